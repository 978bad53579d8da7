var Nv=Object.create;var Mg=Object.defineProperty;var Dv=Object.getOwnPropertyDescriptor;var Uv=Object.getOwnPropertyNames;var Fv=Object.getPrototypeOf,kv=Object.prototype.hasOwnProperty;var wg=(i,e)=>()=>{try{return e||i((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var Bv=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Uv(e))!kv.call(i,s)&&s!==t&&Mg(i,s,{get:()=>e[s],enumerable:!(n=Dv(e,s))||n.enumerable});return i};var Eg=(i,e,t)=>(t=i!=null?Nv(Fv(i)):{},Bv(e||!i||!i.__esModule?Mg(t,"default",{value:i,enumerable:!0}):t,i));var Lg=wg((Nd,Dd)=>{((i,e)=>{typeof define=="function"&&define.amd?define([],e):typeof Dd=="object"&&typeof Nd<"u"?Dd.exports=e():i.Papa=e()})(Nd,function i(){var e=typeof self<"u"?self:typeof window<"u"?window:e!==void 0?e:{},t=!e.document&&!!e.postMessage,n=e.IS_PAPA_WORKER||!1,s={},r=0,o={};function a(x){return x.charCodeAt(0)===65279?x.slice(1):x}function l(x){this._handle=null,this._finished=!1,this._completed=!1,this._halted=!1,this._input=null,this._baseIndex=0,this._partialLine="",this._rowCount=0,this._start=0,this._nextChunk=null,this.isFirstChunk=!0,this._completeResults={data:[],errors:[],meta:{}},function(p){var S=M(p);S.chunkSize=parseInt(S.chunkSize),p.step||p.chunk||(S.chunkSize=null),this._handle=new f(S),(this._handle.streamer=this)._config=S}.call(this,x),this.parseChunk=function(p,S){var A=parseInt(this._config.skipFirstNLines)||0;if(this.isFirstChunk&&0<A){let C=this._config.newline;C||(E=this._config.quoteChar||'"',C=this._handle.guessLineEndings(p,E)),p=[...p.split(C).slice(A)].join(C)}this.isFirstChunk&&w(this._config.beforeFirstChunk)&&(E=this._config.beforeFirstChunk(p))!==void 0&&(p=E),this.isFirstChunk=!1,this._halted=!1;var A=this._partialLine+p,E=(this._partialLine="",this._handle.parse(A,this._baseIndex,!this._finished));if(!this._handle.paused()&&!this._handle.aborted()){if(p=E.meta.cursor,A=(this._finished||(this._partialLine=A.substring(p-this._baseIndex),this._baseIndex=p),E&&E.data&&(this._rowCount+=E.data.length),this._finished||this._config.preview&&this._rowCount>=this._config.preview),n)e.postMessage({results:E,workerId:o.WORKER_ID,finished:A});else if(w(this._config.chunk)&&!S){if(this._config.chunk(E,this._handle),this._handle.paused()||this._handle.aborted())return void(this._halted=!0);this._completeResults=E=void 0}return this._config.step||this._config.chunk||(this._completeResults.data=this._completeResults.data.concat(E.data),this._completeResults.errors=this._completeResults.errors.concat(E.errors),this._completeResults.meta=E.meta),this._completed||!A||!w(this._config.complete)||E&&E.meta.aborted||(this._config.complete(this._completeResults,this._input),this._completed=!0),A||E&&E.meta.paused||this._nextChunk(),E}this._halted=!0},this._sendError=function(p){w(this._config.error)?this._config.error(p):n&&this._config.error&&e.postMessage({workerId:o.WORKER_ID,error:p,finished:!1})}}function c(x){var p;(x=x||{}).chunkSize||(x.chunkSize=o.RemoteChunkSize),l.call(this,x),this._nextChunk=t?function(){this._readChunk(),this._chunkLoaded()}:function(){this._readChunk()},this.stream=function(S){this._input=S,this._nextChunk()},this._readChunk=function(){if(this._finished)this._chunkLoaded();else{if(p=new XMLHttpRequest,this._config.withCredentials&&(p.withCredentials=this._config.withCredentials),t||(p.onload=b(this._chunkLoaded,this),p.onerror=b(this._chunkError,this)),p.ontimeout=b(this._chunkTimeout,this),p.open(this._config.downloadRequestBody?"POST":"GET",this._input,!t),this._config.downloadTimeout&&!t&&(p.timeout=this._config.downloadTimeout),this._config.downloadRequestHeaders){var S,A=this._config.downloadRequestHeaders;for(S in A)p.setRequestHeader(S,A[S])}var E;this._config.chunkSize&&(E=this._start+this._config.chunkSize-1,p.setRequestHeader("Range","bytes="+this._start+"-"+E));try{p.send(this._config.downloadRequestBody)}catch(C){this._chunkError(C.message)}t&&p.status===0&&this._chunkError()}},this._chunkLoaded=function(){p.readyState===4&&(p.status<200||400<=p.status?this._chunkError():(this._start+=this._config.chunkSize||p.responseText.length,this._finished=!this._config.chunkSize||this._start>=(S=>(S=S.getResponseHeader("Content-Range"))!==null?parseInt(S.substring(S.lastIndexOf("/")+1)):-1)(p),this.parseChunk(p.responseText)))},this._chunkError=function(S){S=p.statusText||S,this._sendError(new Error(S))},this._chunkTimeout=function(){this._chunkError("Request timed out after "+this._config.downloadTimeout+"ms")}}function u(x){(x=x||{}).chunkSize||(x.chunkSize=o.LocalChunkSize),l.call(this,x);var p,S,A=typeof FileReader<"u";this.stream=function(E){this._input=E,S=E.slice||E.webkitSlice||E.mozSlice,A?((p=new FileReader).onload=b(this._chunkLoaded,this),p.onerror=b(this._chunkError,this)):p=new FileReaderSync,this._nextChunk()},this._nextChunk=function(){this._finished||this._config.preview&&!(this._rowCount<this._config.preview)||this._readChunk()},this._readChunk=function(){var E=this._input,C=(this._config.chunkSize&&(C=Math.min(this._start+this._config.chunkSize,this._input.size),E=S.call(E,this._start,C)),p.readAsText(E,this._config.encoding));A||this._chunkLoaded({target:{result:C}})},this._chunkLoaded=function(E){this._start+=this._config.chunkSize,this._finished=!this._config.chunkSize||this._start>=this._input.size,this.parseChunk(E.target.result)},this._chunkError=function(){this._sendError(p.error)}}function h(x){var p;l.call(this,x=x||{}),this.stream=function(S){return p=S,this._nextChunk()},this._nextChunk=function(){var S,A;if(!this._finished)return S=this._config.chunkSize,p=S?(A=p.substring(0,S),p.substring(S)):(A=p,""),this._finished=!p,this.parseChunk(A)}}function d(x){l.call(this,x=x||{});var p=[],S=!0,A=!1;this.pause=function(){l.prototype.pause.apply(this,arguments),this._input.pause()},this.resume=function(){l.prototype.resume.apply(this,arguments),this._input.resume()},this.stream=function(E){this._input=E,this._input.on("data",this._streamData),this._input.on("end",this._streamEnd),this._input.on("error",this._streamError)},this._checkIsFinished=function(){A&&p.length===1&&(this._finished=!0)},this._nextChunk=function(){this._checkIsFinished(),p.length?this.parseChunk(p.shift()):S=!0},this._streamData=b(function(E){try{p.push(typeof E=="string"?E:E.toString(this._config.encoding)),S&&(S=!1,this._checkIsFinished(),this.parseChunk(p.shift()))}catch(C){this._streamError(C)}},this),this._streamError=b(function(E){this._streamCleanUp(),this._sendError(E)},this),this._streamEnd=b(function(){this._streamCleanUp(),A=!0,this._streamData("")},this),this._streamCleanUp=b(function(){this._input.removeListener("data",this._streamData),this._input.removeListener("end",this._streamEnd),this._input.removeListener("error",this._streamError)},this)}function f(x){var p,S,A,E,C=Math.pow(2,53),I=-C,D=/^\s*-?(\d+\.?|\.\d+|\d+\.\d+)([eE][-+]?\d+)?\s*$/,L=/^((\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\d\.\d+([+-][0-2]\d:[0-5]\d|Z))|(\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\d([+-][0-2]\d:[0-5]\d|Z))|(\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d([+-][0-2]\d:[0-5]\d|Z)))$/,U=this,V=0,B=0,ne=!1,z=!1,q=[],W={data:[],errors:[],meta:{}};function ge(se){return x.skipEmptyLines==="greedy"?se.join("").trim()==="":se.length===1&&se[0].length===0}function Ee(){if(W&&A&&(ae("Delimiter","UndetectableDelimiter","Unable to auto-detect delimiting character; defaulted to '"+o.DefaultDelimiter+"'"),A=!1),x.skipEmptyLines&&(W.data=W.data.filter(function(We){return!ge(We)})),$()){let We=function(Te){q.push(Te)};var he=We;if(W)if(Array.isArray(W.data[0])){for(var se=0;$()&&se<W.data.length;se++)W.data[se].forEach(We);W.data.splice(0,1)}else W.data.forEach(We)}function ce(We,Te){for(var ke=x.header?{}:[],Ie=0;Ie<We.length;Ie++){var Se=Ie,dt=We[Ie],dt=((ze,st)=>(Ze=>(x.dynamicTypingFunction&&x.dynamicTyping[Ze]===void 0&&(x.dynamicTyping[Ze]=x.dynamicTypingFunction(Ze)),(x.dynamicTyping[Ze]||x.dynamicTyping)===!0))(ze)?st==="true"||st==="TRUE"||st!=="false"&&st!=="FALSE"&&((Ze=>{if(D.test(Ze)&&(Ze=parseFloat(Ze),I<Ze&&Ze<C))return 1})(st)?parseFloat(st):L.test(st)?new Date(st):st===""?null:st):st)(Se=x.header?Ie>=q.length?"__parsed_extra":q[Ie]:Se,dt=x.transform?x.transform(dt,Se):dt);Se==="__parsed_extra"?(ke[Se]=ke[Se]||[],ke[Se].push(dt)):ke[Se]=dt}return x.header&&(Ie>q.length?ae("FieldMismatch","TooManyFields","Too many fields: expected "+q.length+" fields but parsed "+Ie,B+Te):Ie<q.length&&ae("FieldMismatch","TooFewFields","Too few fields: expected "+q.length+" fields but parsed "+Ie,B+Te)),ke}var re;W&&(x.header||x.dynamicTyping||x.transform)&&(re=1,!W.data.length||Array.isArray(W.data[0])?(W.data=W.data.map(ce),re=W.data.length):W.data=ce(W.data,0),x.header&&W.meta&&(W.meta.fields=q),B+=re)}function $(){return x.header&&q.length===0}function ae(se,ce,re,he){se={type:se,code:ce,message:re},he!==void 0&&(se.row=he),W.errors.push(se)}w(x.step)&&(E=x.step,x.step=function(se){W=se,$()?Ee():(Ee(),W.data.length!==0&&(V+=se.data.length,x.preview&&V>x.preview?S.abort():(W.data=W.data[0],E(W,U))))}),this.parse=function(se,ce,re){var he=x.quoteChar||'"',he=(x.newline||(x.newline=this.guessLineEndings(se,he)),A=!1,x.delimiter?w(x.delimiter)&&(x.delimiter=x.delimiter(se),W.meta.delimiter=x.delimiter):((he=((We,Te,ke,Ie,Se)=>{var dt,ze,st,Ze;Se=Se||[",","	","|",";",o.RECORD_SEP,o.UNIT_SEP];for(var vn=0;vn<Se.length;vn++){for(var Pt,pn=Se[vn],wt=0,qt=0,k=0,Nt=(st=void 0,new y({comments:Ie,delimiter:pn,newline:Te,preview:10}).parse(We)),ft=0;ft<Nt.data.length;ft++)ke&&ge(Nt.data[ft])?k++:(Pt=Nt.data[ft].length,qt+=Pt,st===void 0?st=Pt:0<Pt&&(wt+=Math.abs(Pt-st),st=Pt));0<Nt.data.length&&(qt/=Nt.data.length-k),1.99<qt&&(ze===void 0||wt<ze||wt===ze&&Ze<qt)&&(ze=wt,dt=pn,Ze=qt)}return{successful:!!(x.delimiter=dt),bestDelimiter:dt}})(se,x.newline,x.skipEmptyLines,x.comments,x.delimitersToGuess)).successful?x.delimiter=he.bestDelimiter:(A=!0,x.delimiter=o.DefaultDelimiter),W.meta.delimiter=x.delimiter),M(x));return he.header=$(),x.preview&&x.header&&he.preview++,p=se,S=new y(he),W=S.parse(p,ce,re),Ee(),ne?{meta:{paused:!0}}:W||{meta:{paused:!1}}},this.paused=function(){return ne},this.pause=function(){ne=!0,S.abort(),p=w(x.chunk)?"":p.substring(S.getCharIndex())},this.resume=function(){U.streamer._halted?(ne=!1,U.streamer.parseChunk(p,!0)):setTimeout(U.resume,3)},this.aborted=function(){return z},this.abort=function(){z=!0,S.abort(),W.meta.aborted=!0,w(x.complete)&&x.complete(W),p=""},this.guessLineEndings=function(We,he){We=We.substring(0,1048576);var he=new RegExp(g(he)+"([^]*?)"+g(he),"gm"),re=(We=We.replace(he,"")).split("\r"),he=We.split(`
`),We=1<he.length&&he[0].length<re[0].length;if(re.length===1||We)return`
`;for(var Te=0,ke=0;ke<re.length;ke++)re[ke][0]===`
`&&Te++;return Te>=re.length/2?`\r
`:"\r"}}function g(x){return x.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")}function y(x){var p=(x=x||{}).delimiter,S=x.newline,A=x.comments,E=x.step,C=x.preview,I=x.fastMode,D=null,L=!1,U=x.quoteChar==null?'"':x.quoteChar,V=U;if(x.escapeChar!==void 0&&(V=x.escapeChar),(typeof p!="string"||-1<o.BAD_DELIMITERS.indexOf(p))&&(p=","),A===p)throw new Error("Comment character same as delimiter");A===!0?A="#":(typeof A!="string"||-1<o.BAD_DELIMITERS.indexOf(A))&&(A=!1),S!==`
`&&S!=="\r"&&S!==`\r
`&&(S=`
`);var B=0,ne=!1;this.parse=function(z,q,W){if(typeof z!="string")throw new Error("Input must be a string");var ge=z.length,Ee=p.length,$=S.length,ae=A.length,se=w(E),ce=[],re=[],he=[],We=B=0;if(!z)return wt();if(I||I!==!1&&z.indexOf(U)===-1){for(var Te=z.split(S),ke=0;ke<Te.length;ke++){if(he=Te[ke],B+=he.length,ke!==Te.length-1)B+=S.length;else if(W)return wt();if(!A||he.substring(0,ae)!==A){if(se){if(ce=[],Ze(he.split(p)),qt(),ne)return wt()}else Ze(he.split(p));if(C&&C<=ke)return ce=ce.slice(0,C),wt(!0)}}return wt()}for(var Ie=z.indexOf(p,B),Se=z.indexOf(S,B),dt=new RegExp(g(V)+g(U),"g"),ze=z.indexOf(U,B);;)if(z[B]===U)for(ze=B,B++;;){if((ze=z.indexOf(U,ze+1))===-1)return W||re.push({type:"Quotes",code:"MissingQuotes",message:"Quoted field unterminated",row:ce.length,index:B}),Pt();if(ze===ge-1)return Pt(z.substring(B,ze).replace(dt,U));if(U===V&&z[ze+1]===V)ze++;else if(U===V||ze===0||z[ze-1]!==V){Ie!==-1&&Ie<ze+1&&(Ie=z.indexOf(p,ze+1));var st=vn((Se=Se!==-1&&Se<ze+1?z.indexOf(S,ze+1):Se)===-1?Ie:Math.min(Ie,Se));if(z.substr(ze+1+st,Ee)===p){he.push(z.substring(B,ze).replace(dt,U)),z[B=ze+1+st+Ee]!==U&&(ze=z.indexOf(U,B)),Ie!==-1&&Ie<B&&(Ie=z.indexOf(p,B)),Se!==-1&&Se<B&&(Se=z.indexOf(S,B));break}if(st=vn(Se),z.substring(ze+1+st,ze+1+st+$)===S){if(he.push(z.substring(B,ze).replace(dt,U)),pn(ze+1+st+$),Ie!==-1&&Ie<B&&(Ie=z.indexOf(p,B)),ze=z.indexOf(U,B),se&&(qt(),ne))return wt();if(C&&ce.length>=C)return wt(!0);break}re.push({type:"Quotes",code:"InvalidQuotes",message:"Trailing quote on quoted field is malformed",row:ce.length,index:B}),ze++}}else if(A&&he.length===0&&z.substring(B,B+ae)===A){if(Se===-1)return wt();B=Se+$,Se=z.indexOf(S,B),Ie!==-1&&Ie<B&&(Ie=z.indexOf(p,B))}else if(Ie!==-1&&(Ie<Se||Se===-1))he.push(z.substring(B,Ie)),B=Ie+Ee,Ie=z.indexOf(p,B);else{if(Se===-1)break;if(he.push(z.substring(B,Se)),pn(Se+$),se&&(qt(),ne))return wt();if(C&&ce.length>=C)return wt(!0)}return Pt();function Ze(k){ce.push(k),We=B}function vn(k){var Nt=0;return Nt=k!==-1&&(k=z.substring(ze+1,k))&&k.trim()===""?k.length:Nt}function Pt(k){return W||(k===void 0&&(k=z.substring(B)),he.push(k),B=ge,Ze(he),se&&qt()),wt()}function pn(k){B=k,Ze(he),he=[],Se=z.indexOf(S,B)}function wt(k){if(x.header&&!q&&ce.length&&!L){var Nt=ce[0],ft=Object.create(null),Lt=new Set(Nt);let xe=!1;for(let Vt=0;Vt<Nt.length;Vt++){let Le=a(Nt[Vt]);if(ft[Le=w(x.transformHeader)?x.transformHeader(Le,Vt):Le]){let Ve,O=ft[Le];for(;Ve=Le+"_"+O,O++,Lt.has(Ve););Lt.add(Ve),Nt[Vt]=Ve,ft[Le]++,xe=!0,(D=D===null?{}:D)[Ve]=Le}else ft[Le]=1,Nt[Vt]=Le;Lt.add(Le)}xe&&console.warn("Duplicate headers found and renamed."),L=!0}return{data:ce,errors:re,meta:{delimiter:p,linebreak:S,aborted:ne,truncated:!!k,cursor:We+(q||0),renamedHeaders:D}}}function qt(){E(wt()),ce=[],re=[]}},this.abort=function(){ne=!0},this.getCharIndex=function(){return B}}function m(x){var p=x.data,S=s[p.workerId],A=!1;if(p.error)S.userError(p.error,p.file);else if(p.results&&p.results.data){var E={abort:function(){A=!0,_(p.workerId,{data:[],errors:[],meta:{aborted:!0}})},pause:v,resume:v};if(w(S.userStep)){for(var C=0;C<p.results.data.length&&(S.userStep({data:p.results.data[C],errors:p.results.errors,meta:p.results.meta},E),!A);C++);delete p.results}else w(S.userChunk)&&(S.userChunk(p.results,E,p.file),delete p.results)}p.finished&&!A&&_(p.workerId,p.results)}function _(x,p){var S=s[x];w(S.userComplete)&&S.userComplete(p),S.terminate(),delete s[x]}function v(){throw new Error("Not implemented.")}function M(x){if(typeof x!="object"||x===null)return x;var p,S=Array.isArray(x)?[]:{};for(p in x)S[p]=M(x[p]);return S}function b(x,p){return function(){x.apply(p,arguments)}}function w(x){return typeof x=="function"}return o.parse=function(x,p){var S=(p=p||{}).dynamicTyping||!1;if(w(S)&&(p.dynamicTypingFunction=S,S={}),p.dynamicTyping=S,p.transform=!!w(p.transform)&&p.transform,p.downloadTimeout!==void 0){var S=parseInt(p.downloadTimeout);if(isNaN(S))throw new Error("Config downloadTimeout value ("+p.downloadTimeout+") not parsable by parseInt(val).");p.downloadTimeout=S}if(!p.worker||!o.WORKERS_SUPPORTED)return S=null,o.NODE_STREAM_INPUT,typeof x=="string"?(x=a(x),S=new(p.download?c:h)(p)):x.readable===!0&&w(x.read)&&w(x.on)?S=new d(p):(e.File&&x instanceof File||x instanceof Object)&&(S=new u(p)),S.stream(x);(S=(()=>{var A;return!!o.WORKERS_SUPPORTED&&(A=(()=>{var E=e.URL||e.webkitURL||null,C=i.toString();return o.BLOB_URL||(o.BLOB_URL=E.createObjectURL(new Blob(["var global = (function() { if (typeof self !== 'undefined') { return self; } if (typeof window !== 'undefined') { return window; } if (typeof global !== 'undefined') { return global; } return {}; })(); global.IS_PAPA_WORKER=true; ","(",C,")();"],{type:"text/javascript"})))})(),(A=new e.Worker(A)).onmessage=m,A.id=r++,s[A.id]=A)})()).userStep=p.step,S.userChunk=p.chunk,S.userComplete=p.complete,S.userError=p.error,p.step=w(p.step),p.chunk=w(p.chunk),p.complete=w(p.complete),p.error=w(p.error),delete p.worker,S.postMessage({input:x,config:p,workerId:S.id})},o.unparse=function(x,p){var S=!1,A=!0,E=",",C=`\r
`,I='"',D=I+I,L=!1,U=null,V=!1,B=((()=>{if(typeof p=="object"){if(typeof p.delimiter!="string"||o.BAD_DELIMITERS.filter(function(q){return p.delimiter.indexOf(q)!==-1}).length||(E=p.delimiter),typeof p.quotes!="boolean"&&typeof p.quotes!="function"&&!Array.isArray(p.quotes)||(S=p.quotes),typeof p.skipEmptyLines!="boolean"&&typeof p.skipEmptyLines!="string"||(L=p.skipEmptyLines),typeof p.newline=="string"&&(C=p.newline),typeof p.quoteChar=="string"&&(I=p.quoteChar,D=I+I),typeof p.header=="boolean"&&(A=p.header),Array.isArray(p.columns)){if(p.columns.length===0)throw new Error("Option columns is empty");U=p.columns}p.escapeChar!==void 0&&(D=p.escapeChar+I),p.escapeFormulae instanceof RegExp?V=p.escapeFormulae:typeof p.escapeFormulae=="boolean"&&p.escapeFormulae&&(V=/^[=+\-@\t\r].*$/)}})(),new RegExp(g(I),"g"));if(typeof x=="string"&&(x=JSON.parse(x)),Array.isArray(x)){if(!x.length)return ne(U,x,L);if(Array.isArray(x[0]))return ne(null,x,L);if(typeof x[0]=="object")return ne(U||Object.keys(x[0]),x,L)}else if(typeof x=="object")return typeof x.data=="string"&&(x.data=JSON.parse(x.data)),Array.isArray(x.data)&&(x.fields||(x.fields=x.meta&&x.meta.fields||U),x.fields||(x.fields=Array.isArray(x.data[0])?x.fields:typeof x.data[0]=="object"?Object.keys(x.data[0]):[]),Array.isArray(x.data[0])||typeof x.data[0]=="object"||(x.data=[x.data])),ne(x.fields||[],x.data||[],L);throw new Error("Unable to serialize unrecognized input");function ne(q,W,ge){var Ee="",$=(typeof q=="string"&&(q=JSON.parse(q)),typeof W=="string"&&(W=JSON.parse(W)),Array.isArray(q)&&0<q.length),ae=!Array.isArray(W[0]);if($&&A){for(var se=0;se<q.length;se++)0<se&&(Ee+=E),Ee+=z(q[se],se);0<W.length&&(Ee+=C)}for(var ce=0;ce<W.length;ce++){var re=($?q:W[ce]).length,he=!1,We=$?Object.keys(W[ce]).length===0:W[ce].length===0;if(ge&&!$&&(he=ge==="greedy"?W[ce].join("").trim()==="":W[ce].length===1&&(W[ce][0]==null||W[ce][0].length===0)),ge==="greedy"&&$){for(var Te=[],ke=0;ke<re;ke++){var Ie=ae?q[ke]:ke;Te.push(W[ce][Ie])}he=Te.join("").trim()===""}if(!he){for(var Se=0;Se<re;Se++){0<Se&&!We&&(Ee+=E);var dt=$&&ae?q[Se]:Se;Ee+=z(W[ce][dt],Se)}ce<W.length-1&&(!ge||0<re&&!We)&&(Ee+=C)}}return Ee}function z(q,W){var ge,Ee,$;return q==null?"":q.constructor===Date?isNaN(q.getTime())?"":q.toISOString():($=!1,ge=q.toString(),V&&typeof q!="number"&&typeof q!="bigint"&&typeof q!="boolean"&&V.test(ge)&&(q=ge="'"+ge,$=!0),Ee=ge.replace(B,D),($=$||S===!0||typeof S=="function"&&S(q,W)||Array.isArray(S)&&S[W]||((ae,se)=>{for(var ce=0;ce<se.length;ce++)if(-1<ae.indexOf(se[ce]))return!0;return!1})(Ee,o.BAD_DELIMITERS)||-1<Ee.indexOf(E)||-1<ge.indexOf(I)||Ee.charAt(0)===" "||Ee.charAt(Ee.length-1)===" ")?I+Ee+I:Ee)}},o.RECORD_SEP="",o.UNIT_SEP="",o.BYTE_ORDER_MARK="\uFEFF",o.BAD_DELIMITERS=["\r",`
`,'"',o.BYTE_ORDER_MARK],o.WORKERS_SUPPORTED=!t&&!!e.Worker,o.NODE_STREAM_INPUT=1,o.LocalChunkSize=10485760,o.RemoteChunkSize=5242880,o.DefaultDelimiter=",",o.Parser=y,o.ParserHandle=f,o.NetworkStreamer=c,o.FileStreamer=u,o.StringStreamer=h,o.ReadableStreamStreamer=d,n&&(e.onmessage=function(x){x=x.data,o.WORKER_ID===void 0&&x&&(o.WORKER_ID=x.workerId),typeof x.input=="string"?e.postMessage({workerId:o.WORKER_ID,results:o.parse(x.input,x.config),finished:!0}):(e.File&&x.input instanceof File||x.input instanceof Object)&&(x=o.parse(x.input,x.config))&&e.postMessage({workerId:o.WORKER_ID,results:x,finished:!0})}),(c.prototype=Object.create(l.prototype)).constructor=c,(u.prototype=Object.create(l.prototype)).constructor=u,(h.prototype=Object.create(h.prototype)).constructor=h,(d.prototype=Object.create(l.prototype)).constructor=d,o})});var Fg=wg((Ug,bc)=>{(function(i,e){"use strict";typeof define=="function"&&define.amd?define(e):typeof bc=="object"&&bc.exports?bc.exports=e():i.log=e()})(Ug,function(){"use strict";var i=function(){},e="undefined",t=typeof window!==e&&typeof window.navigator!==e&&/Trident\/|MSIE /.test(window.navigator.userAgent),n=["trace","debug","info","warn","error"],s={},r=null;function o(g,y){var m=g[y];if(typeof m.bind=="function")return m.bind(g);try{return Function.prototype.bind.call(m,g)}catch{return function(){return Function.prototype.apply.apply(m,[g,arguments])}}}function a(){console.log&&(console.log.apply?console.log.apply(console,arguments):Function.prototype.apply.apply(console.log,[console,arguments])),console.trace&&console.trace()}function l(g){return g==="debug"&&(g="log"),typeof console===e?!1:g==="trace"&&t?a:console[g]!==void 0?o(console,g):console.log!==void 0?o(console,"log"):i}function c(){for(var g=this.getLevel(),y=0;y<n.length;y++){var m=n[y];this[m]=y<g?i:this.methodFactory(m,g,this.name)}if(this.log=this.debug,typeof console===e&&g<this.levels.SILENT)return"No console available for logging"}function u(g){return function(){typeof console!==e&&(c.call(this),this[g].apply(this,arguments))}}function h(g,y,m){return l(g)||u.apply(this,arguments)}function d(g,y){var m=this,_,v,M,b="loglevel";typeof g=="string"?b+=":"+g:typeof g=="symbol"&&(b=void 0);function w(E){var C=(n[E]||"silent").toUpperCase();if(!(typeof window===e||!b)){try{window.localStorage[b]=C;return}catch{}try{window.document.cookie=encodeURIComponent(b)+"="+C+";"}catch{}}}function x(){var E;if(!(typeof window===e||!b)){try{E=window.localStorage[b]}catch{}if(typeof E===e)try{var C=window.document.cookie,I=encodeURIComponent(b),D=C.indexOf(I+"=");D!==-1&&(E=/^([^;]+)/.exec(C.slice(D+I.length+1))[1])}catch{}return m.levels[E]===void 0&&(E=void 0),E}}function p(){if(!(typeof window===e||!b)){try{window.localStorage.removeItem(b)}catch{}try{window.document.cookie=encodeURIComponent(b)+"=; expires=Thu, 01 Jan 1970 00:00:00 UTC"}catch{}}}function S(E){var C=E;if(typeof C=="string"&&m.levels[C.toUpperCase()]!==void 0&&(C=m.levels[C.toUpperCase()]),typeof C=="number"&&C>=0&&C<=m.levels.SILENT)return C;throw new TypeError("log.setLevel() called with invalid level: "+E)}m.name=g,m.levels={TRACE:0,DEBUG:1,INFO:2,WARN:3,ERROR:4,SILENT:5},m.methodFactory=y||h,m.getLevel=function(){return M??v??_},m.setLevel=function(E,C){return M=S(E),C!==!1&&w(M),c.call(m)},m.setDefaultLevel=function(E){v=S(E),x()||m.setLevel(E,!1)},m.resetLevel=function(){M=null,p(),c.call(m)},m.enableAll=function(E){m.setLevel(m.levels.TRACE,E)},m.disableAll=function(E){m.setLevel(m.levels.SILENT,E)},m.rebuild=function(){if(r!==m&&(_=S(r.getLevel())),c.call(m),r===m)for(var E in s)s[E].rebuild()},_=S(r?r.getLevel():"WARN");var A=x();A!=null&&(M=S(A)),c.call(m)}r=new d,r.getLogger=function(y){if(typeof y!="symbol"&&typeof y!="string"||y==="")throw new TypeError("You must supply a name when creating a logger.");var m=s[y];return m||(m=s[y]=new d(y,r.methodFactory)),m};var f=typeof window!==e?window.log:void 0;return r.noConflict=function(){return typeof window!==e&&window.log===r&&(window.log=f),r},r.getLoggers=function(){return s},r.default=r,r})});var ls=class extends Error{title;detail;errors;omitted;status;constructor({title:e,detail:t,errors:n,errors_omitted:s,status:r}){super(t||e),this.title=e??"Something went wrong",this.detail=t??"",this.errors=n??[],this.omitted=s??!1,this.status=r??0}},hc="",Ad=i=>{hc=i},dc=()=>hc!=="",Tg=new URL(".",document.baseURI).pathname.replace(/studio\/$/,""),Ag=i=>i.startsWith(Tg)?i:Tg+i.replace(/^\//,""),pr=i=>new URL(Ag(i),location.href).href;async function mr(i,e={}){let t={...hc&&{Authorization:`Bearer ${hc}`},...e.headers},n;try{n=await fetch(Ag(i),{...e,headers:t})}catch(o){throw e.signal?.aborted?o:new ls({title:"The server cannot be reached",detail:"Is it still running? Nothing was lost; try again."})}if(n.ok)return n;let s=await n.text(),r;try{r=JSON.parse(s)}catch{r={title:`The server answered ${n.status}`,detail:s.slice(0,300)}}throw new ls({...r,status:n.status})}var Ii=async i=>(await mr(i)).json(),_a=async i=>(await mr(i)).arrayBuffer(),fc=async i=>(await mr(i)).blob();async function pc(i,e){return(await mr(i,{method:"POST",headers:{"Content-Type":"application/json",Prefer:"wait=1"},body:JSON.stringify(e)})).json()}var Rd=async i=>(await mr(i.links.cancel,{method:"POST"})).json(),Rg=async i=>{await mr(i.links.self,{method:"DELETE"})},Kr=i=>["succeeded","failed","cancelled"].includes(i.status??"");async function mc(i,e){let t=null;for(let n=0;;n+=1){try{let r={Accept:"text/event-stream",...t&&{"Last-Event-ID":t}};for await(let o of zv(await mr(i.links.events,{headers:r}))){n=0,t=o.id??t;let a=JSON.parse(o.data);if(a.progress&&e(a.progress),Kr(a)&&a.links)return a}}catch(r){if(!(r instanceof ls)||r.status>=400&&r.status<500||n>=5)throw r}let s=await Ii(i.links.self);if(Kr(s))return s;await new Promise(r=>{setTimeout(r,300*(n+1))})}}async function*zv(i){if(!i.body||i.status===204)return;let e=i.body.pipeThrough(new TextDecoderStream).getReader(),t="";for(;;){let{value:n,done:s}=await e.read();if(s)return;t+=n.replaceAll(`\r
`,`
`);let r=t.split(`

`);t=r.pop()??"";for(let o of r){let a={};for(let l of o.split(`
`)){let[,c,u=""]=/^([^:]*):? ?(.*)$/s.exec(l)??[];c==="data"?a.data=a.data===void 0?u:`${a.data}
${u}`:(c==="id"||c==="event")&&(a[c]=u)}a.data!==void 0&&(yield a)}}}function J(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element #${i}`);return e}function ie(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r!=null&&(s.startsWith("on")&&typeof r=="function"?n.addEventListener(s.slice(2),r):s in n?n[s]=r:n.setAttribute(s,String(r)));return n.append(...t.filter(s=>s!=null&&s!==!1)),n}var Vv="http://www.w3.org/2000/svg";function In(i,e={},...t){let n=document.createElementNS(Vv,i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}function gc(i,e){let t=URL.createObjectURL(i),n=ie("a",{href:t,download:e});document.body.append(n),n.click(),n.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var _t=class extends Error{constructor(e,t){super(t===void 0?e:`Line ${t}: ${e}`)}},Li=i=>`“${i.trim().slice(0,24)}${i.trim().length>24?"…":""}”`;function _c(i,e){let t=Number(i.trim());if(i.trim()===""||!Number.isFinite(t))throw new _t(`${Li(i)} is not a number.`,e);return t}function Zn(i,e=!1){let[t]=i,n=i.at(-1),s=i.length>2&&t.every((r,o)=>r===n[o]);return{points:s?i.slice(0,-1):i,closed:e||s}}function gr(i,e=1e-7){let n=Math.max(...i.flat(1).flat().map(Math.abs),1e-300)*e,s=c=>c.map(u=>Math.round(u/n)).join(","),r=new Map;i.forEach(([c,u],h)=>{for(let d of[c,u]){let f=r.get(s(d))??[];f.push(h),r.set(s(d),f)}});let o=new Set,a=c=>{let u=[];for(let h=c;;){let d=r.get(s(h))??[],f=d.length<=2?d.find(m=>!o.has(m)):void 0;if(f===void 0)return u;o.add(f);let[g,y]=i[f];h=s(g)===s(h)?y:g,u.push(h)}},l=[];return i.forEach(([c,u],h)=>{if(o.has(h))return;o.add(h);let d=a(u),g=[...a(c).reverse(),c,u,...d],y=g.length>3&&s(g[0])===s(g.at(-1));l.push({points:y?g.slice(0,-1):g,closed:y})}),l}var Ut={minimal_surface:{path:"/v1/minimal-surfaces",label:"Film",line:"boundary",lines:["boundaries"],least:3,purpose:"A membrane of least area on its boundary"},ruled_surface:{path:"/v1/ruled-surfaces",label:"Strip",line:"rail",lines:["directrices"],least:2,purpose:"A ruled strip between two rails"},uniform_mesh:{path:"/v1/uniform-meshes",label:"Lattice",line:"hole",lines:["domain","holes"],least:3,purpose:"A gridshell or floor of equal members"}},Cg={mm:.001,cm:.01,m:1,in:.0254,ft:.3048},Oi=i=>String(i.units)in Cg?String(i.units):"m",xa=i=>Cg[Oi(i)]??1;var Pd=i=>typeof i=="number"&&Number.isFinite(i),Pg=i=>Array.isArray(i)&&i.length===3&&i.every(Pd);function Gt(i){return!Array.isArray(i)||!i.some(Pd)?null:[0,1,2].map(e=>Pd(i[e])&&Math.abs(i[e])<1e150?i[e]:0)}function yc(i,e){let t=[],n=(o,a,l,c,u=!1)=>{Array.isArray(l)&&t.push({name:o,path:a,points:l,closed:c,planar:u})},s=(o,a,l,c,u=!1)=>{Array.isArray(l)&&l.forEach((h,d)=>n(`${o} ${d+1}`,[...a,d],h,c,u))};if(i==="ruled_surface"&&s("rail",["directrices"],e.directrices,e.closed===!0),i==="minimal_surface"){s("boundary",["boundaries"],e.boundaries,!0);let o=xc(e.constraints);s("rope",["constraints","polylines"],o?.polylines,!1),Array.isArray(o?.points)&&o.points.length>0&&n("fixed points",["constraints","points"],o.points,!1)}let r=xc(e.domain);if(r){n("polygon",["domain","polygon"],r.polygon,!0,!0),s("hole",["domain","holes"],r.holes,!0,!0),s("boundary",["domain","boundaries"],r.boundaries,!0);for(let o of["bezier","nurbs"])s("control row",["domain",o,"control_points"],xc(r[o])?.control_points,!1)}return t}var xc=i=>i!==null&&typeof i=="object"&&!Array.isArray(i)?i:null,_r=i=>i.path[0]==="constraints"&&i.path[1]==="points";function Ig(i,e){return e.reduce((t,n)=>t?.[n],i)}function Id(i,e){let t=e.split("/").slice(1).map(l=>l.replaceAll("~1","/").replaceAll("~0","~")),n=i.findIndex(l=>l.path.every((c,u)=>String(c)===t[u]));if(n<0){let l=/^(normals|tangents)$/.test(t[0]??"")?i.findIndex(u=>u.path[0]==="directrices"&&String(u.path[1])===t[1]):-1;return l>=0&&/^\d+$/.test(t[2]??"")?{text:`${t[0]} of ${i[l].name}, point ${Number(t[2])+1}`,line:l,point:Number(t[2]),field:t[0]}:{text:t.map(u=>/^\d+$/.test(u)?String(Number(u)+1):u.replaceAll("_"," ")).join(" › ")||"the request",...t[0]!==void 0&&{field:t[0]}}}let s=i[n],[r,o]=t.slice(s.path.length).map(Number);if(r===void 0||!Number.isInteger(r))return{text:s.name,line:n};let a=o===void 0?"":`, ${"xyz"[o]??"coordinate"}`;return{text:`${s.name}, point ${r+1}${a}`,line:n,point:Math.min(r,s.points.length-1),...o!==void 0&&{axis:o}}}function Ld(i){return i==="ruled_surface"?{directrices:[]}:i==="uniform_mesh"?{domain:{},edge_length:1}:{boundaries:[]}}function xr(i,e){let t=yc(i,e);return i==="ruled_surface"?t.length>=2:t.length>=1||i==="uniform_mesh"&&Object.keys(xc(e.domain)??{}).length>0}function ya(i){return typeof i.kind=="string"?i.kind in Ut?i.kind:null:"boundaries"in i?"minimal_surface":"directrices"in i?"ruled_surface":"domain"in i?"uniform_mesh":null}var Od=i=>JSON.stringify(i,null,1).replace(/\[\s+([^[\]{}]*?)\s+\]/g,(e,t)=>`[${t.replace(/\s+/g," ")}]`);var Og=Eg(Lg(),1);function Ng(i){let e=!/[,;\t|]/.test(i),{data:t}=Og.default.parse(e?i.replace(/[ ]+/g," ").replace(/^ | $/gm,""):i,{delimiter:e?" ":""}),n=[0,1,2],s=-1,r=[[]],o,a=!1;for(let[l,c]of t.entries()){let u=c.map(h=>h.trim());if(u.every(h=>h==="")){r.at(-1).length>0&&r.push([]);continue}if(!u[0].startsWith("#")){if(!a&&u.every(h=>!Number.isFinite(Number(h))||h==="")){let h=u.map(m=>m.toLowerCase()),d=(...m)=>h.findIndex(_=>m.includes(_)),[f,g,y]=[d("x","easting","e"),d("y","northing","n"),d("z","height","elevation","h")];if(f<0||g<0)throw new _t(`${Li(c.join(","))} names no columns x and y, and is no point.`,l+1);n=[f,g,y],s=d("line","polyline","boundary","curve","id"),a=!0;continue}if(a=!0,u.length<2)throw new _t(`${Li(c.join(","))} is no point: x, y and z are expected.`,l+1);s>=0&&o!==void 0&&u[s]!==o&&r.at(-1).length>0&&r.push([]),o=s>=0?u[s]:void 0,r.at(-1).push(n.map(h=>h<0||(u[h]??"")===""&&h===n[2]?0:_c(u[h]??"",l+1)))}}return r.filter(l=>l.length>0).map(l=>Zn(l))}var va=class{constructor(e){this._pointer=0,this._eof=!1,this._data=e}next(){if(!this.hasNext())throw this._eof?new Error("Cannot call 'next' after EOF group has been read"):new Error("Unexpected end of input: EOF group not read before end of file. Ended on code "+this._data[this._pointer]);let e={code:parseInt(this._data[this._pointer])};return this._pointer++,e.value=Dg(e.code,this._data[this._pointer].trim()),this._pointer++,e.code===0&&e.value==="EOF"&&(this._eof=!0),this.lastReadGroup=e,e}peek(){if(!this.hasNext())throw this._eof?new Error("Cannot call 'next' after EOF group has been read"):new Error("Unexpected end of input: EOF group not read before end of file. Ended on code "+this._data[this._pointer]);let e={code:parseInt(this._data[this._pointer])};return e.value=Dg(e.code,this._data[this._pointer+1].trim()),e}rewind(e=1){this._pointer=this._pointer-e*2}hasNext(){return!(this._eof||this._pointer>this._data.length-2)}isEOF(){return this._eof}};function Dg(i,e){return i<=9?e:i>=10&&i<=59?parseFloat(e):i>=60&&i<=99?parseInt(e):i>=100&&i<=109?e:i>=110&&i<=149?parseFloat(e):i>=160&&i<=179?parseInt(e):i>=210&&i<=239?parseFloat(e):i>=270&&i<=289?parseInt(e):i>=290&&i<=299?Hv(e):i>=300&&i<=369?e:i>=370&&i<=389?parseInt(e):i>=390&&i<=399?e:i>=400&&i<=409?parseInt(e):i>=410&&i<=419?e:i>=420&&i<=429?parseInt(e):i>=430&&i<=439?e:i>=440&&i<=459?parseInt(e):i>=460&&i<=469?parseFloat(e):i>=470&&i<=481||i===999||i>=1e3&&i<=1009?e:i>=1010&&i<=1059?parseFloat(e):i>=1060&&i<=1071?parseInt(e):(console.log("WARNING: Group code does not have a defined type: %j",{code:i,value:e}),e)}function Hv(i){if(i==="0")return!1;if(i==="1")return!0;throw TypeError("String '"+i+"' cannot be cast to Boolean type")}var vc=[0,16711680,16776960,65280,65535,255,16711935,16777215,8421504,12632256,16711680,16744319,13369344,13395558,10027008,10046540,8323072,8339263,4980736,4990502,16727808,16752511,13382400,13401958,10036736,10051404,8331008,8343359,4985600,4992806,16744192,16760703,13395456,13408614,10046464,10056268,8339200,8347455,4990464,4995366,16760576,16768895,13408512,13415014,10056192,10061132,8347392,8351551,4995328,4997670,16776960,16777087,13421568,13421670,10000384,10000460,8355584,8355647,5000192,5000230,12582656,14679935,10079232,11717734,7510016,8755276,6258432,7307071,3755008,4344870,8388352,12582783,6736896,10079334,5019648,7510092,4161280,6258495,2509824,3755046,4194048,10485631,3394560,8375398,2529280,6264908,2064128,5209919,1264640,3099686,65280,8388479,52224,6736998,38912,5019724,32512,4161343,19456,2509862,65343,8388511,52275,6737023,38950,5019743,32543,4161359,19475,2509871,65407,8388543,52326,6737049,38988,5019762,32575,4161375,19494,2509881,65471,8388575,52377,6737074,39026,5019781,32607,4161391,19513,2509890,65535,8388607,52428,6737100,39064,5019800,32639,4161407,19532,2509900,49151,8380415,39372,6730444,29336,5014936,24447,4157311,14668,2507340,32767,8372223,26316,6724044,19608,5010072,16255,4153215,9804,2505036,16383,8364031,13260,6717388,9880,5005208,8063,4149119,4940,2502476,255,8355839,204,6710988,152,5000344,127,4145023,76,2500172,4129023,10452991,3342540,8349388,2490520,6245528,2031743,5193599,1245260,3089996,8323327,12550143,6684876,10053324,4980888,7490712,4128895,6242175,2490444,3745356,12517631,14647295,10027212,11691724,7471256,8735896,6226047,7290751,3735628,4335180,16711935,16744447,13369548,13395660,9961624,9981080,8323199,8339327,4980812,4990540,16711871,16744415,13369497,13395634,9961586,9981061,8323167,8339311,4980793,4990530,16711807,16744383,13369446,13395609,9961548,9981042,8323135,8339295,4980774,4990521,16711743,16744351,13369395,13395583,9961510,9981023,8323103,8339279,4980755,4990511,3355443,5987163,8684676,11382189,14079702,16777215];function Gv(i){return vc[i]}function He(i){let e={};i.rewind();let t=i.next(),n=t.code;if(e.x=t.value,n+=10,t=i.next(),t.code!=n)throw new Error("Expected code for point value to be "+n+" but got "+t.code+".");return e.y=t.value,n+=10,t=i.next(),t.code!=n?(i.rewind(),e):(e.z=t.value,e)}function xt(i,e,t){switch(e.code){case 0:i.type=e.value;break;case 5:i.handle=e.value;break;case 6:i.lineType=e.value;break;case 8:i.layer=e.value;break;case 48:i.lineTypeScale=e.value;break;case 60:i.visible=e.value===0;break;case 62:i.colorIndex=e.value,i.color=Gv(Math.abs(e.value));break;case 67:i.inPaperSpace=e.value!==0;break;case 100:break;case 101:for(;e.code!=0;)e=t.next();t.rewind();break;case 330:i.ownerHandle=e.value;break;case 347:i.materialObjectHandle=e.value;break;case 370:i.lineweight=e.value;break;case 420:i.color=e.value;break;case 1e3:i.extendedData=i.extendedData||{},i.extendedData.customStrings=i.extendedData.customStrings||[],i.extendedData.customStrings.push(e.value);break;case 1001:i.extendedData=i.extendedData||{},i.extendedData.applicationName=e.value;break;default:return!1}return!0}var ba=class{constructor(){this.ForEntityName="3DFACE"}parseEntity(e,t){let n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 70:n.shape=(t.value&1)===1,n.hasContinuousLinetypePattern=(t.value&128)===128;break;case 10:n.vertices=Wv(e,t),t=e.lastReadGroup;break;default:xt(n,t,e);break}t=e.next()}return n}};function Wv(i,e){var t=[],n=!1,s=!1,r=4;for(let a=0;a<=r;a++){for(var o={};!i.isEOF()&&!(e.code===0||s);){switch(e.code){case 10:case 11:case 12:case 13:if(n){s=!0;continue}o.x=e.value,n=!0;break;case 20:case 21:case 22:case 23:o.y=e.value;break;case 30:case 31:case 32:case 33:o.z=e.value;break;default:return t}e=i.next()}t.push(o),n=!1,s=!1}return i.rewind(),t}var Sa=class{constructor(){this.ForEntityName="ARC"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=He(e);break;case 40:n.radius=t.value;break;case 50:n.startAngle=Math.PI/180*t.value;break;case 51:n.endAngle=Math.PI/180*t.value,n.angleLength=n.endAngle-n.startAngle;break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var Ma=class{constructor(){this.ForEntityName="ATTDEF"}parseEntity(e,t){var n={type:t.value,scale:1,textStyle:"STANDARD"};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 1:n.text=t.value;break;case 2:n.tag=t.value;break;case 3:n.prompt=t.value;break;case 7:n.textStyle=t.value;break;case 10:n.startPoint=He(e);break;case 11:n.endPoint=He(e);break;case 39:n.thickness=t.value;break;case 40:n.textHeight=t.value;break;case 41:n.scale=t.value;break;case 50:n.rotation=t.value;break;case 51:n.obliqueAngle=t.value;break;case 70:n.invisible=!!(t.value&1),n.constant=!!(t.value&2),n.verificationRequired=!!(t.value&4),n.preset=!!(t.value&8);break;case 71:n.backwards=!!(t.value&2),n.mirrored=!!(t.value&4);break;case 72:n.horizontalJustification=t.value;break;case 73:n.fieldLength=t.value;break;case 74:n.verticalJustification=t.value;break;case 100:break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var wa=class{constructor(){this.ForEntityName="CIRCLE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=He(e);break;case 40:n.radius=t.value;break;case 50:n.startAngle=Math.PI/180*t.value;break;case 51:let s=Math.PI/180*t.value;s<n.startAngle?n.angleLength=s+2*Math.PI-n.startAngle:n.angleLength=s-n.startAngle,n.endAngle=s;break;default:xt(n,t,e);break}t=e.next()}return n}};var Ea=class{constructor(){this.ForEntityName="DIMENSION"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 2:n.block=t.value;break;case 10:n.anchorPoint=He(e);break;case 11:n.middleOfText=He(e);break;case 12:n.insertionPoint=He(e);break;case 13:n.linearOrAngularPoint1=He(e);break;case 14:n.linearOrAngularPoint2=He(e);break;case 15:n.diameterOrRadiusPoint=He(e);break;case 16:n.arcPoint=He(e);break;case 70:n.dimensionType=t.value;break;case 71:n.attachmentPoint=t.value;break;case 42:n.actualMeasurement=t.value;break;case 1:n.text=t.value;break;case 50:n.angle=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var Ta=class{constructor(){this.ForEntityName="ELLIPSE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=He(e);break;case 11:n.majorAxisEndPoint=He(e);break;case 40:n.axisRatio=t.value;break;case 41:n.startAngle=t.value;break;case 42:n.endAngle=t.value;break;case 2:n.name=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var Aa=class{constructor(){this.ForEntityName="INSERT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 2:n.name=t.value;break;case 41:n.xScale=t.value;break;case 42:n.yScale=t.value;break;case 43:n.zScale=t.value;break;case 10:n.position=He(e);break;case 50:n.rotation=t.value;break;case 70:n.columnCount=t.value;break;case 71:n.rowCount=t.value;break;case 44:n.columnSpacing=t.value;break;case 45:n.rowSpacing=t.value;break;case 210:n.extrusionDirection=He(e);break;default:xt(n,t,e);break}t=e.next()}return n}};var Ra=class{constructor(){this.ForEntityName="LINE"}parseEntity(e,t){let n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.vertices.unshift(He(e));break;case 11:n.vertices.push(He(e));break;case 210:n.extrusionDirection=He(e);break;case 100:break;default:xt(n,t,e);break}t=e.next()}return n}};var Ca=class{constructor(){this.ForEntityName="LWPOLYLINE"}parseEntity(e,t){let n={type:t.value,vertices:[]},s=0;for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 38:n.elevation=t.value;break;case 39:n.depth=t.value;break;case 70:n.shape=(t.value&1)===1,n.hasContinuousLinetypePattern=(t.value&128)===128;break;case 90:s=t.value;break;case 10:n.vertices=Xv(s,e);break;case 43:t.value!==0&&(n.width=t.value);break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};function Xv(i,e){if(!i||i<=0)throw Error("n must be greater than 0 verticies");let t=[],n=!1,s=!1,r=e.lastReadGroup;for(let o=0;o<i;o++){let a={};for(;!e.isEOF()&&!(r.code===0||s);){switch(r.code){case 10:if(n){s=!0;continue}a.x=r.value,n=!0;break;case 20:a.y=r.value;break;case 30:a.z=r.value;break;case 40:a.startWidth=r.value;break;case 41:a.endWidth=r.value;break;case 42:r.value!=0&&(a.bulge=r.value);break;default:return e.rewind(),n&&t.push(a),e.rewind(),t}r=e.next()}t.push(a),n=!1,s=!1}return e.rewind(),t}var Pa=class{constructor(){this.ForEntityName="MTEXT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 3:n.text?n.text+=t.value:n.text=t.value;break;case 1:n.text?n.text+=t.value:n.text=t.value;break;case 10:n.position=He(e);break;case 11:n.directionVector=He(e);break;case 40:n.height=t.value;break;case 41:n.width=t.value;break;case 50:n.rotation=t.value;break;case 71:n.attachmentPoint=t.value;break;case 72:n.drawingDirection=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var Ia=class{constructor(){this.ForEntityName="POINT"}parseEntity(e,t){let s={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:s.position=He(e);break;case 39:s.thickness=t.value;break;case 210:s.extrusionDirection=He(e);break;case 100:break;default:xt(s,t,e);break}t=e.next()}return s}};var La=class{constructor(){this.ForEntityName="VERTEX"}parseEntity(e,t){var n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.x=t.value;break;case 20:n.y=t.value;break;case 30:n.z=t.value;break;case 40:break;case 41:break;case 42:t.value!=0&&(n.bulge=t.value);break;case 70:n.curveFittingVertex=(t.value&1)!==0,n.curveFitTangent=(t.value&2)!==0,n.splineVertex=(t.value&8)!==0,n.splineControlPoint=(t.value&16)!==0,n.threeDPolylineVertex=(t.value&32)!==0,n.threeDPolylineMesh=(t.value&64)!==0,n.polyfaceMeshVertex=(t.value&128)!==0;break;case 50:break;case 71:n.faceA=t.value;break;case 72:n.faceB=t.value;break;case 73:n.faceC=t.value;break;case 74:n.faceD=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var Oa=class{constructor(){this.ForEntityName="POLYLINE"}parseEntity(e,t){var n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:break;case 20:break;case 30:break;case 39:n.thickness=t.value;break;case 40:break;case 41:break;case 70:n.shape=(t.value&1)!==0,n.includesCurveFitVertices=(t.value&2)!==0,n.includesSplineFitVertices=(t.value&4)!==0,n.is3dPolyline=(t.value&8)!==0,n.is3dPolygonMesh=(t.value&16)!==0,n.is3dPolygonMeshClosed=(t.value&32)!==0,n.isPolyfaceMesh=(t.value&64)!==0,n.hasContinuousLinetypePattern=(t.value&128)!==0;break;case 71:break;case 72:break;case 73:break;case 74:break;case 75:break;case 210:n.extrusionDirection=He(e);break;default:xt(n,t,e);break}t=e.next()}return n.vertices=qv(e,t),n}};function qv(i,e){let t=new La,n=[];for(;!i.isEOF();)if(e.code===0){if(e.value==="VERTEX")n.push(t.parseEntity(i,e)),e=i.lastReadGroup;else if(e.value==="SEQEND"){Yv(i,e);break}}return n}function Yv(i,e){let t={type:e.value};for(e=i.next();!i.isEOF()&&e.code!=0;)xt(t,e,i),e=i.next();return t}var Na=class{constructor(){this.ForEntityName="SOLID"}parseEntity(e,t){let n={type:t.value,points:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.points[0]=He(e);break;case 11:n.points[1]=He(e);break;case 12:n.points[2]=He(e);break;case 13:n.points[3]=He(e);break;case 210:n.extrusionDirection=He(e);break;default:xt(n,t,e);break}t=e.next()}return n}};var Da=class{constructor(){this.ForEntityName="SPLINE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.controlPoints||(n.controlPoints=[]),n.controlPoints.push(He(e));break;case 11:n.fitPoints||(n.fitPoints=[]),n.fitPoints.push(He(e));break;case 12:n.startTangent=He(e);break;case 13:n.endTangent=He(e);break;case 40:n.knotValues||(n.knotValues=[]),n.knotValues.push(t.value);break;case 70:(t.value&1)!=0&&(n.closed=!0),(t.value&2)!=0&&(n.periodic=!0),(t.value&4)!=0&&(n.rational=!0),(t.value&8)!=0&&(n.planar=!0),(t.value&16)!=0&&(n.planar=!0,n.linear=!0);break;case 71:n.degreeOfSplineCurve=t.value;break;case 72:n.numberOfKnots=t.value;break;case 73:n.numberOfControlPoints=t.value;break;case 74:n.numberOfFitPoints=t.value;break;case 210:n.normalVector=He(e);break;default:xt(n,t,e);break}t=e.next()}return n}};var Ua=class{constructor(){this.ForEntityName="TEXT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.startPoint=He(e);break;case 11:n.endPoint=He(e);break;case 40:n.textHeight=t.value;break;case 41:n.xScale=t.value;break;case 50:n.rotation=t.value;break;case 1:n.text=t.value;break;case 72:n.halign=t.value;break;case 73:n.valign=t.value;break;default:xt(n,t,e);break}t=e.next()}return n}};var ut=Eg(Fg());ut.default.setLevel("error");function $v(i){i.registerEntityHandler(ba),i.registerEntityHandler(Sa),i.registerEntityHandler(Ma),i.registerEntityHandler(wa),i.registerEntityHandler(Ea),i.registerEntityHandler(Ta),i.registerEntityHandler(Aa),i.registerEntityHandler(Ra),i.registerEntityHandler(Ca),i.registerEntityHandler(Pa),i.registerEntityHandler(Ia),i.registerEntityHandler(Oa),i.registerEntityHandler(Na),i.registerEntityHandler(Da),i.registerEntityHandler(Ua)}var Zr=class{constructor(){this._entityHandlers={},$v(this)}parse(e){return typeof e=="string"?this._parse(e):(console.error("Cannot read dxf source of type `"+typeof e),null)}registerEntityHandler(e){let t=new e;this._entityHandlers[t.ForEntityName]=t}parseSync(e){return this.parse(e)}parseStream(e){let t="",n=this;return new Promise((s,r)=>{e.on("data",o=>{t+=o}),e.on("end",()=>{try{s(n._parse(t))}catch(o){r(o)}}),e.on("error",o=>{r(o)})})}_parse(e){let t={},n=0,s=e.split(/\r\n|\r|\n/g),r=new va(s);if(!r.hasNext())throw Error("Empty file");let o=this,a;function l(){for(a=r.next();!r.isEOF();)if(a.code===0&&a.value==="SECTION"){if(a=r.next(),a.code!==2){console.error("Unexpected code %s after 0:SECTION",kg(a)),a=r.next();continue}a.value==="HEADER"?(ut.default.debug("> HEADER"),t.header=c(),ut.default.debug("<")):a.value==="BLOCKS"?(ut.default.debug("> BLOCKS"),t.blocks=u(),ut.default.debug("<")):a.value==="ENTITIES"?(ut.default.debug("> ENTITIES"),t.entities=M(!1),ut.default.debug("<")):a.value==="TABLES"?(ut.default.debug("> TABLES"),t.tables=d(),ut.default.debug("<")):a.value==="EOF"?ut.default.debug("EOF"):ut.default.warn("Skipping section '%s'",a.value)}else a=r.next()}function c(){let x=null,p=null,S={};for(a=r.next();;){if(Ni(a,0,"ENDSEC")){x&&(S[x]=p);break}else a.code===9?(x&&(S[x]=p),x=a.value):a.code===10?p={x:a.value}:a.code===20?p.y=a.value:a.code===30?p.z=a.value:p=a.value;a=r.next()}return a=r.next(),S}function u(){let x={};for(a=r.next();a.value!=="EOF"&&!Ni(a,0,"ENDSEC");)if(Ni(a,0,"BLOCK")){ut.default.debug("block {");let p=h();ut.default.debug("}"),w(p),p.name?x[p.name]=p:ut.default.error('block with handle "'+p.handle+'" is missing a name.')}else yr(a),a=r.next();return x}function h(){let x={};for(a=r.next();a.value!=="EOF";){switch(a.code){case 1:x.xrefPath=a.value,a=r.next();break;case 2:x.name=a.value,a=r.next();break;case 3:x.name2=a.value,a=r.next();break;case 5:x.handle=a.value,a=r.next();break;case 8:x.layer=a.value,a=r.next();break;case 10:x.position=b(a),a=r.next();break;case 67:x.paperSpace=!!(a.value&&a.value==1),a=r.next();break;case 70:a.value!=0&&(x.type=a.value),a=r.next();break;case 100:a=r.next();break;case 330:x.ownerHandle=a.value,a=r.next();break;case 0:if(a.value=="ENDBLK")break;x.entities=M(!0);break;default:yr(a),a=r.next()}if(Ni(a,0,"ENDBLK")){a=r.next();break}}return x}function d(){let x={};for(a=r.next();a.value!=="EOF"&&!Ni(a,0,"ENDSEC");)Ni(a,0,"TABLE")?(a=r.next(),v[a.value]?(ut.default.debug(a.value+" Table {"),x[v[a.value].tableName]=g(a),ut.default.debug("}")):ut.default.debug("Unhandled Table "+a.value)):a=r.next();return a=r.next(),x}let f="ENDTAB";function g(x){let p=v[x.value],S={},A=0;for(a=r.next();!Ni(a,0,f);)switch(a.code){case 5:S.handle=a.value,a=r.next();break;case 330:S.ownerHandle=a.value,a=r.next();break;case 100:a.value==="AcDbSymbolTable"||yr(a),a=r.next();break;case 70:A=a.value,a=r.next();break;case 0:a.value===p.dxfSymbolName?S[p.tableRecordsProperty]=p.parseTableRecords():(yr(a),a=r.next());break;default:yr(a),a=r.next()}let E=S[p.tableRecordsProperty];if(E){let C=(()=>{if(E.constructor===Array)return E.length;if(typeof E=="object")return Object.keys(E).length})();A!==C&&ut.default.warn("Parsed "+C+" "+p.dxfSymbolName+"'s but expected "+A)}return a=r.next(),S}function y(){let x=[],p={};for(ut.default.debug("ViewPort {"),a=r.next();!Ni(a,0,f);)switch(a.code){case 2:p.name=a.value,a=r.next();break;case 10:p.lowerLeftCorner=b(a),a=r.next();break;case 11:p.upperRightCorner=b(a),a=r.next();break;case 12:p.center=b(a),a=r.next();break;case 13:p.snapBasePoint=b(a),a=r.next();break;case 14:p.snapSpacing=b(a),a=r.next();break;case 15:p.gridSpacing=b(a),a=r.next();break;case 16:p.viewDirectionFromTarget=b(a),a=r.next();break;case 17:p.viewTarget=b(a),a=r.next();break;case 42:p.lensLength=a.value,a=r.next();break;case 43:p.frontClippingPlane=a.value,a=r.next();break;case 44:p.backClippingPlane=a.value,a=r.next();break;case 45:p.viewHeight=a.value,a=r.next();break;case 50:p.snapRotationAngle=a.value,a=r.next();break;case 51:p.viewTwistAngle=a.value,a=r.next();break;case 79:p.orthographicType=a.value,a=r.next();break;case 110:p.ucsOrigin=b(a),a=r.next();break;case 111:p.ucsXAxis=b(a),a=r.next();break;case 112:p.ucsYAxis=b(a),a=r.next();break;case 110:p.ucsOrigin=b(a),a=r.next();break;case 281:p.renderMode=a.value,a=r.next();break;case 281:p.defaultLightingType=a.value,a=r.next();break;case 292:p.defaultLightingOn=a.value,a=r.next();break;case 330:p.ownerHandle=a.value,a=r.next();break;case 63:case 421:case 431:p.ambientColor=a.value,a=r.next();break;case 0:a.value==="VPORT"&&(ut.default.debug("}"),x.push(p),ut.default.debug("ViewPort {"),p={},a=r.next());break;default:yr(a),a=r.next();break}return ut.default.debug("}"),x.push(p),x}function m(){let x={},p={},S=0,A;for(ut.default.debug("LType {"),a=r.next();!Ni(a,0,"ENDTAB");)switch(a.code){case 2:p.name=a.value,A=a.value,a=r.next();break;case 3:p.description=a.value,a=r.next();break;case 73:S=a.value,S>0&&(p.pattern=[]),a=r.next();break;case 40:p.patternLength=a.value,a=r.next();break;case 49:p.pattern.push(a.value),a=r.next();break;case 0:ut.default.debug("}"),S>0&&S!==p.pattern.length&&ut.default.warn("lengths do not match on LTYPE pattern"),x[A]=p,p={},ut.default.debug("LType {"),a=r.next();break;default:a=r.next()}return ut.default.debug("}"),x[A]=p,x}function _(){let x={},p={},S;for(ut.default.debug("Layer {"),a=r.next();!Ni(a,0,"ENDTAB");)switch(a.code){case 2:p.name=a.value,S=a.value,a=r.next();break;case 62:p.visible=a.value>=0,p.colorIndex=Math.abs(a.value),p.color=Kv(p.colorIndex),a=r.next();break;case 70:p.frozen=(a.value&1)!=0||(a.value&2)!=0,a=r.next();break;case 0:a.value==="LAYER"&&(ut.default.debug("}"),x[S]=p,ut.default.debug("Layer {"),p={},S=void 0,a=r.next());break;default:yr(a),a=r.next();break}return ut.default.debug("}"),x[S]=p,x}let v={VPORT:{tableRecordsProperty:"viewPorts",tableName:"viewPort",dxfSymbolName:"VPORT",parseTableRecords:y},LTYPE:{tableRecordsProperty:"lineTypes",tableName:"lineType",dxfSymbolName:"LTYPE",parseTableRecords:m},LAYER:{tableRecordsProperty:"layers",tableName:"layer",dxfSymbolName:"LAYER",parseTableRecords:_}};function M(x){let p=[],S=x?"ENDBLK":"ENDSEC";for(x||(a=r.next());;)if(a.code===0){if(a.value===S)break;let A=o._entityHandlers[a.value];if(A!=null){ut.default.debug(a.value+" {");let E=A.parseEntity(r,a);a=r.lastReadGroup,ut.default.debug("}"),w(E),p.push(E)}else{ut.default.warn("Unhandled entity "+a.value),a=r.next();continue}}else a=r.next();return S=="ENDSEC"&&(a=r.next()),p}function b(x){let p={},S=x.code;if(p.x=x.value,S+=10,x=r.next(),x.code!=S)throw new Error("Expected code for point value to be "+S+" but got "+x.code+".");return p.y=x.value,S+=10,x=r.next(),x.code!=S?(r.rewind(),p):(p.z=x.value,p)}function w(x){if(!x)throw new TypeError("entity cannot be undefined or null");x.handle||(x.handle=n++)}return l(),t}};function Ni(i,e,t){return i.code===e&&i.value===t}function yr(i){ut.default.debug("unhandled group "+kg(i))}function kg(i){return i.code+":"+i.value}function Kv(i){return vc[i]}var Bg=Zr;var Zv=48;function zg(i){jv(i);let e;try{e=new Bg().parseSync(i)?.entities??[]}catch(r){throw new _t(`This is not DXF that can be read: ${r instanceof Error?r.message:String(r)}.`)}let t=[],n=[];for(let r of e){let o=(r.vertices??[]).map(({x:a,y:l,z:c})=>[a,l,c??r.elevation??0]);if(r.type==="LINE"&&o.length>=2)t.push([o[0],o[1]]);else if((r.type==="LWPOLYLINE"||r.type==="POLYLINE")&&o.length>=2)n.push(Zn(o,r.shape===!0));else if((r.type==="CIRCLE"||r.type==="ARC")&&r.center&&r.radius)n.push(Jv(r));else if(r.type==="SPLINE"){let a=r.fitPoints?.length?r.fitPoints:r.controlPoints??[];a.length>=2&&n.push(Zn(a.map(({x:l,y:c,z:u})=>[l,c,u??0]),r.closed===!0))}}let s=[...n,...t.length>0?gr(t):[]];if(s.length===0)throw new _t("This DXF file has no lines, polylines, arcs or splines.");return s}function Jv({type:i,center:e,radius:t=0,startAngle:n=0,endAngle:s=0}){let r=i==="CIRCLE",o=r?2*Math.PI:(s-n+4*Math.PI)%(2*Math.PI)||2*Math.PI,a=Math.max(2,Math.ceil(Zv*o/(2*Math.PI)));return{points:Array.from({length:r?a:a+1},(c,u)=>{let h=(r?0:n)+o*u/a;return[e.x+t*Math.cos(h),e.y+t*Math.sin(h),e.z??0]}),closed:r}}function jv(i){let e=i.replace(/\s+$/,"").split(/\r?\n/);for(let t=0;t+1<e.length;t+=2){let n=e[t].trim();if(!/^-?\d+$/.test(n))throw new _t(`${Li(e[t])} is not a DXF group code.`,t+1);let s=Number(n);if(s>=10&&s<60&&!Number.isFinite(Number(e[t+1])))throw new _t(`${Li(e[t+1])} is not a number.`,t+2)}}var Qv=["FeatureCollection","Feature","GeometryCollection","LineString","MultiLineString","Polygon","MultiPolygon","Point","MultiPoint"],Vg=i=>Qv.includes(String(i?.type));function Hg(i,e){let t=[],n=[],s=a=>{let l=Array.isArray(a)?a:null;if(!l||l.length<2||!l.slice(0,3).every(c=>typeof c=="number"&&Number.isFinite(c))){let c=JSON.stringify(a)??"nothing";throw new _t(`${c.slice(0,40)} is not a position.`,Ud(e,a))}return[l[0],l[1],l[2]??0]},r=a=>{if(!Array.isArray(a))throw new _t(`${(JSON.stringify(a)??"nothing").slice(0,40)} is not a list of positions.`,Ud(e,a));return a},o=a=>{if(!a)return;let{type:l,coordinates:c}=a;if(l==="FeatureCollection")r(a.features).forEach(u=>o(u));else if(l==="Feature")o(a.geometry);else if(l==="GeometryCollection")r(a.geometries).forEach(u=>o(u));else if(l==="LineString")t.push(Zn(r(c).map(s)));else if(l==="MultiLineString")r(c).forEach(u=>t.push(Zn(r(u).map(s))));else if(l==="Polygon")r(c).forEach(u=>t.push(Zn(r(u).map(s),!0)));else if(l==="MultiPolygon")r(c).forEach(u=>r(u).forEach(h=>t.push(Zn(r(h).map(s),!0))));else if(l==="Point")n.push(s(c));else if(l==="MultiPoint")n.push(...r(c).map(s));else throw new _t(`GeoJSON has no type ${JSON.stringify(l)}.`,Ud(e,l))};if(o(i),t.length===0&&n.length>1&&t.push(Zn(n)),t.length===0)throw new _t("This GeoJSON has no lines or polygons.");return t}function Ud(i,e){let t=JSON.stringify(e);if(!t)return;let n=[...t].map(r=>r.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")).join("\\s*").slice(0,4e3),s=i.search(new RegExp(n));return s<0?void 0:i.slice(0,s).split(`
`).length}var D0=0,Tf=1,U0=2;var vl=1,F0=2,Co=3,oi=0,Mn=1,rn=2,qi=0,Po=1,Af=2,Rf=3,Cf=4,k0=5;var Or=100,B0=101,z0=102,V0=103,H0=104,G0=200,W0=201,X0=202,q0=203,Pf=204,If=205,Y0=206,$0=207,K0=208,Z0=209,J0=210,j0=211,Q0=212,e_=213,t_=214,jc=0,Qc=1,eu=2,mo=3,tu=4,nu=5,iu=6,su=7,bu=0,n_=1,i_=2,Yi=0,Lf=1,Of=2,Nf=3,Df=4,Uf=5,Ff=6,bl=7,df="attached",s_="detached",kf=300,Nr=301,Io=302,Su=303,Mu=304,Xs=1e3,di=1001,go=1002,en=1003,wu=1004;var Dr=1005;var cn=1006,Lo=1007;var mi=1008;var ti=1009,Bf=1010,zf=1011,Oo=1012,Eu=1013,gi=1014,Gn=1015,Ei=1016,Tu=1017,Au=1018,Ur=1020,Vf=35902,Hf=35899,Gf=1021,Wf=1022,jn=1023,_s=1026,Rs=1027,Ru=1028,Sl=1029,Js=1030,Cu=1031;var Pu=1033,Ml=33776,wl=33777,El=33778,Tl=33779,Iu=35840,Lu=35841,Ou=35842,Nu=35843,Du=36196,Uu=37492,Fu=37496,ku=37488,Bu=37489,Al=37490,zu=37491,Vu=37808,Hu=37809,Gu=37810,Wu=37811,Xu=37812,qu=37813,Yu=37814,$u=37815,Ku=37816,Zu=37817,Ju=37818,ju=37819,Qu=37820,eh=37821,th=36492,nh=36494,ih=36495,sh=36283,rh=36284,Rl=36285,oh=36286;var Tr=2300,Ar=2301,Zc=2302,ff=2303,pf=2400,mf=2401,gf=2402,r_=2500;var Xf=0,Cl=1,No=2,o_=3200;var Pl=0,a_=1,Cs="",on="srgb",Wn="srgb-linear",$a="linear",Et="srgb";var Jc=7680;var l_=519,c_=512,u_=513,h_=514,qf=515,d_=516,f_=517,Yf=518,$f=519,Kf=35044;var Zf="300 es",fi=2e3,_o=2001;function eb(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function tb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function xo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function p_(){let i=xo("canvas");return i.style.display="block",i}var Gg={},yo=null;function Ka(...i){let e="THREE."+i.shift();yo?yo("log",e,...i):console.log(e,...i)}function m_(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function De(...i){i=m_(i);let e="THREE."+i.shift();if(yo)yo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Ge(...i){i=m_(i);let e="THREE."+i.shift();if(yo)yo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Er(...i){let e=i.join(" ");e in Gg||(Gg[e]=!0,De(...i))}function g_(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var __={[jc]:jc,[eu]:iu,[tu]:tu,[mo]:nu,[Qc]:Qc,[iu]:eu,[su]:su,[nu]:mo},ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},On=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Wg=1234567,qa=Math.PI/180,Rr=180/Math.PI;function $i(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(On[i&255]+On[i>>8&255]+On[i>>16&255]+On[i>>24&255]+"-"+On[e&255]+On[e>>8&255]+"-"+On[e>>16&15|64]+On[e>>24&255]+"-"+On[t&63|128]+On[t>>8&255]+"-"+On[t>>16&255]+On[t>>24&255]+On[n&255]+On[n>>8&255]+On[n>>16&255]+On[n>>24&255]).toLowerCase()}function Ye(i,e,t){return Math.max(e,Math.min(t,i))}function Jf(i,e){return(i%e+e)%e}function nb(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function ib(i,e,t){return i!==e?(t-i)/(e-i):0}function Ya(i,e,t){return(1-t)*i+t*e}function sb(i,e,t,n){return Ya(i,e,1-Math.exp(-t*n))}function rb(i,e=1){return e-Math.abs(Jf(i,e*2)-e)}function ob(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function ab(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function lb(i,e){return i+Math.floor(Math.random()*(e-i+1))}function cb(i,e){return i+Math.random()*(e-i)}function ub(i){return i*(.5-Math.random())}function hb(i){i!==void 0&&(Wg=i);let e=Wg+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function db(i){return i*qa}function fb(i){return i*Rr}function pb(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function mb(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function jf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function gb(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*d,a*c);break;case"YZY":i.set(l*d,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*d,a*u,a*c);break;case"XZX":i.set(a*u,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*u,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*u,a*c);break;default:De("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ah(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Qf(i,e){if(e.constructor===Float32Array)return i;let t=ah(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function ep(i,e){if(e.constructor===Float32Array)return i;let t=ah(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Do={DEG2RAD:qa,RAD2DEG:Rr,generateUUID:$i,clamp:Ye,euclideanModulo:Jf,mapLinear:nb,inverseLerp:ib,lerp:Ya,damp:sb,pingpong:rb,smoothstep:ob,smootherstep:ab,randInt:lb,randFloat:cb,randFloatSpread:ub,seededRandom:hb,degToRad:db,radToDeg:fb,isPowerOfTwo:pb,ceilPowerOfTwo:mb,floorPowerOfTwo:jf,setQuaternionFromProperEuler:gb,normalize:ep,denormalize:Qf},Ue=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ye(this.x,e.x,t.x),this.y=Ye(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ye(this.x,e,t),this.y=Ye(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ye(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ye(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Xn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==g){let m=l*d+c*f+u*g+h*y;m<0&&(d=-d,f=-f,g=-g,y=-y,m=-m);let _=1-a;if(m<.9995){let v=Math.acos(m),M=Math.sin(v);_=Math.sin(_*v)/M,a=Math.sin(a*v)/M,l=l*_+d*a,c=c*_+f*a,u=u*_+g*a,h=h*_+y*a}else{l=l*_+d*a,c=c*_+f*a,u=u*_+g*a,h=h*_+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*f-c*d,e[t+1]=l*g+u*d+c*h-a*f,e[t+2]=c*g+u*f+a*d-l*h,e[t+3]=u*g-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:De("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ye(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Xg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Xg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ye(this.x,e.x,t.x),this.y=Ye(this.y,e.y,t.y),this.z=Ye(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ye(this.x,e,t),this.y=Ye(this.y,e,t),this.z=Ye(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ye(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Fd.copy(this).projectOnVector(e),this.sub(Fd)}reflect(e){return this.sub(Fd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ye(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Fd=new P,Xg=new Xn,qe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],f=n[5],g=n[8],y=s[0],m=s[3],_=s[6],v=s[1],M=s[4],b=s[7],w=s[2],x=s[5],p=s[8];return r[0]=o*y+a*v+l*w,r[3]=o*m+a*M+l*x,r[6]=o*_+a*b+l*p,r[1]=c*y+u*v+h*w,r[4]=c*m+u*M+h*x,r[7]=c*_+u*b+h*p,r[2]=d*y+f*v+g*w,r[5]=d*m+f*M+g*x,r[8]=d*_+f*b+g*p,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=t*h+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=h*y,e[1]=(s*c-u*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Er("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(kd.makeScale(e,t)),this}rotate(e){return Er("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(kd.makeRotation(-e)),this}translate(e,t){return Er("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(kd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},kd=new qe,qg=new qe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Yg=new qe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function _b(){let i={enabled:!0,workingColorSpace:Wn,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Et&&(s.r=ms(s.r),s.g=ms(s.g),s.b=ms(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Et&&(s.r=po(s.r),s.g=po(s.g),s.b=po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Cs?$a:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Wn]:{primaries:e,whitePoint:n,transfer:$a,toXYZ:qg,fromXYZ:Yg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:on},outputColorSpaceConfig:{drawingBufferColorSpace:on}},[on]:{primaries:e,whitePoint:n,transfer:Et,toXYZ:qg,fromXYZ:Yg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:on}}}),i}var nt=_b();function ms(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function po(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Jr,ru=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Jr===void 0&&(Jr=xo("canvas")),Jr.width=e.width,Jr.height=e.height;let s=Jr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Jr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=xo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ms(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ms(t[n]/255)*255):t[n]=ms(t[n]);return{data:t,width:e.width,height:e.height}}else return De("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},xb=0,vo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:xb++}),this.uuid=$i(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Bd(s[o].image)):r.push(Bd(s[o]))}else r=Bd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Bd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ru.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(De("Texture: Unable to serialize Texture."),{})}var yb=0,zd=new P,yn=class i extends ki{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=di,s=di,r=cn,o=mi,a=jn,l=ti,c=i.DEFAULT_ANISOTROPY,u=Cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:yb++}),this.uuid=$i(),this.name="",this.source=new vo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ue(0,0),this.repeat=new Ue(1,1),this.center=new Ue(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new qe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(zd).x}get height(){return this.source.getSize(zd).y}get depth(){return this.source.getSize(zd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){De(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){De(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==kf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Xs:e.x=e.x-Math.floor(e.x);break;case di:e.x=e.x<0?0:1;break;case go:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Xs:e.y=e.y-Math.floor(e.y);break;case di:e.y=e.y<0?0:1;break;case go:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};yn.DEFAULT_IMAGE=null;yn.DEFAULT_MAPPING=kf;yn.DEFAULT_ANISOTROPY=1;var ot=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],y=l[2],m=l[6],_=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(f+1)/2,w=(_+1)/2,x=(u+d)/4,p=(h+y)/4,S=(g+m)/4;return M>b&&M>w?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=x/n,r=p/n):b>w?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=x/s,r=S/s):w<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(w),n=p/r,s=S/r),this.set(n,s,r,t),this}let v=Math.sqrt((m-g)*(m-g)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(h-y)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ye(this.x,e.x,t.x),this.y=Ye(this.y,e.y,t.y),this.z=Ye(this.z,e.z,t.z),this.w=Ye(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ye(this.x,e,t),this.y=Ye(this.y,e,t),this.z=Ye(this.z,e,t),this.w=Ye(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ye(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ou=class extends ki{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:cn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new ot(0,0,e,t),this.scissorTest=!1,this.viewport=new ot(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new yn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:cn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new vo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Fn=class extends ou{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Za=class extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=en,this.minFilter=en,this.wrapR=di,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var au=class extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=en,this.minFilter=en,this.wrapR=di,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Re=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,d,f,g,y,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,f,g,y,m)}set(e,t,n,s,r,o,a,l,c,u,h,d,f,g,y,m){let _=this.elements;return _[0]=e,_[4]=t,_[8]=n,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=h,_[14]=d,_[3]=f,_[7]=g,_[11]=y,_[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/jr.setFromMatrixColumn(e,0).length(),r=1/jr.setFromMatrixColumn(e,1).length(),o=1/jr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,g=a*u,y=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,g=c*u,y=c*h;t[0]=d+y*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,g=c*u,y=c*h;t[0]=d-y*a,t[4]=-o*h,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,g=a*u,y=a*h;t[0]=l*u,t[4]=g*c-f,t[8]=d*c+y,t[1]=l*h,t[5]=y*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=y-d*h,t[8]=g*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+g,t[10]=d-y*h}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,y=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+y,t[5]=o*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=a*u,t[10]=y*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(vb,e,bb)}lookAt(e,t,n){let s=this.elements;return si.subVectors(e,t),si.lengthSq()===0&&(si.z=1),si.normalize(),Bs.crossVectors(n,si),Bs.lengthSq()===0&&(Math.abs(n.z)===1?si.x+=1e-4:si.z+=1e-4,si.normalize(),Bs.crossVectors(n,si)),Bs.normalize(),Sc.crossVectors(si,Bs),s[0]=Bs.x,s[4]=Sc.x,s[8]=si.x,s[1]=Bs.y,s[5]=Sc.y,s[9]=si.y,s[2]=Bs.z,s[6]=Sc.z,s[10]=si.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],f=n[13],g=n[2],y=n[6],m=n[10],_=n[14],v=n[3],M=n[7],b=n[11],w=n[15],x=s[0],p=s[4],S=s[8],A=s[12],E=s[1],C=s[5],I=s[9],D=s[13],L=s[2],U=s[6],V=s[10],B=s[14],ne=s[3],z=s[7],q=s[11],W=s[15];return r[0]=o*x+a*E+l*L+c*ne,r[4]=o*p+a*C+l*U+c*z,r[8]=o*S+a*I+l*V+c*q,r[12]=o*A+a*D+l*B+c*W,r[1]=u*x+h*E+d*L+f*ne,r[5]=u*p+h*C+d*U+f*z,r[9]=u*S+h*I+d*V+f*q,r[13]=u*A+h*D+d*B+f*W,r[2]=g*x+y*E+m*L+_*ne,r[6]=g*p+y*C+m*U+_*z,r[10]=g*S+y*I+m*V+_*q,r[14]=g*A+y*D+m*B+_*W,r[3]=v*x+M*E+b*L+w*ne,r[7]=v*p+M*C+b*U+w*z,r[11]=v*S+M*I+b*V+w*q,r[15]=v*A+M*D+b*B+w*W,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],y=e[7],m=e[11],_=e[15],v=l*f-c*d,M=a*f-c*h,b=a*d-l*h,w=o*f-c*u,x=o*d-l*u,p=o*h-a*u;return t*(y*v-m*M+_*b)-n*(g*v-m*w+_*x)+s*(g*M-y*w+_*p)-r*(g*b-y*x+m*p)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],y=e[13],m=e[14],_=e[15],v=t*a-n*o,M=t*l-s*o,b=t*c-r*o,w=n*l-s*a,x=n*c-r*a,p=s*c-r*l,S=u*y-h*g,A=u*m-d*g,E=u*_-f*g,C=h*m-d*y,I=h*_-f*y,D=d*_-f*m,L=v*D-M*I+b*C+w*E-x*A+p*S;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let U=1/L;return e[0]=(a*D-l*I+c*C)*U,e[1]=(s*I-n*D-r*C)*U,e[2]=(y*p-m*x+_*w)*U,e[3]=(d*x-h*p-f*w)*U,e[4]=(l*E-o*D-c*A)*U,e[5]=(t*D-s*E+r*A)*U,e[6]=(m*b-g*p-_*M)*U,e[7]=(u*p-d*b+f*M)*U,e[8]=(o*I-a*E+c*S)*U,e[9]=(n*E-t*I-r*S)*U,e[10]=(g*x-y*b+_*v)*U,e[11]=(h*b-u*x-f*v)*U,e[12]=(a*A-o*C-l*S)*U,e[13]=(t*C-n*A+s*S)*U,e[14]=(y*M-g*w-m*v)*U,e[15]=(u*w-h*M+d*v)*U,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,y=o*u,m=o*h,_=a*h,v=l*c,M=l*u,b=l*h,w=n.x,x=n.y,p=n.z;return s[0]=(1-(y+_))*w,s[1]=(f+b)*w,s[2]=(g-M)*w,s[3]=0,s[4]=(f-b)*x,s[5]=(1-(d+_))*x,s[6]=(m+v)*x,s[7]=0,s[8]=(g+M)*p,s[9]=(m-v)*p,s[10]=(1-(d+y))*p,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=jr.set(s[0],s[1],s[2]).length(),a=jr.set(s[4],s[5],s[6]).length(),l=jr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bi.copy(this);let c=1/o,u=1/a,h=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=u,bi.elements[5]*=u,bi.elements[6]*=u,bi.elements[8]*=h,bi.elements[9]*=h,bi.elements[10]*=h,t.setFromRotationMatrix(bi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=fi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===fi)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===_o)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=fi,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===fi)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===_o)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},jr=new P,bi=new Re,vb=new P(0,0,0),bb=new P(1,1,1),Bs=new P,Sc=new P,si=new P,$g=new Re,Kg=new Xn,Bi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ye(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ye(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ye(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ye(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ye(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ye(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:De("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return $g.makeRotationFromQuaternion(e),this.setFromRotationMatrix($g,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Kg.setFromEuler(this),this.setFromQuaternion(Kg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Bi.DEFAULT_ORDER="XYZ";var bo=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Sb=0,Zg=new P,Qr=new Xn,cs=new Re,Mc=new P,Fa=new P,Mb=new P,wb=new Xn,Jg=new P(1,0,0),jg=new P(0,1,0),Qg=new P(0,0,1),e0={type:"added"},Eb={type:"removed"},eo={type:"childadded",child:null},Vd={type:"childremoved",child:null},$t=class i extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Sb++}),this.uuid=$i(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new P,t=new Bi,n=new Xn,s=new P(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Re},normalMatrix:{value:new qe}}),this.matrix=new Re,this.matrixWorld=new Re,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new bo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Qr.setFromAxisAngle(e,t),this.quaternion.multiply(Qr),this}rotateOnWorldAxis(e,t){return Qr.setFromAxisAngle(e,t),this.quaternion.premultiply(Qr),this}rotateX(e){return this.rotateOnAxis(Jg,e)}rotateY(e){return this.rotateOnAxis(jg,e)}rotateZ(e){return this.rotateOnAxis(Qg,e)}translateOnAxis(e,t){return Zg.copy(e).applyQuaternion(this.quaternion),this.position.add(Zg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Jg,e)}translateY(e){return this.translateOnAxis(jg,e)}translateZ(e){return this.translateOnAxis(Qg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(cs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Mc.copy(e):Mc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Fa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cs.lookAt(Fa,Mc,this.up):cs.lookAt(Mc,Fa,this.up),this.quaternion.setFromRotationMatrix(cs),s&&(cs.extractRotation(s.matrixWorld),Qr.setFromRotationMatrix(cs),this.quaternion.premultiply(Qr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Ge("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(e0),eo.child=e,this.dispatchEvent(eo),eo.child=null):Ge("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Eb),Vd.child=e,this.dispatchEvent(Vd),Vd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),cs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),cs.multiply(e.parent.matrixWorld)),e.applyMatrix4(cs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(e0),eo.child=e,this.dispatchEvent(eo),eo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fa,e,Mb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fa,wb,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$t.DEFAULT_UP=new P(0,1,0);$t.DEFAULT_MATRIX_AUTO_UPDATE=!0;$t.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var xn=class extends $t{constructor(){super(),this.isGroup=!0,this.type="Group"}},Tb={type:"move"},So=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new xn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new xn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new xn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let m=t.getJointPose(y,n),_=this._getHandJoint(c,y);m!==null&&(_.matrix.fromArray(m.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=m.radius),_.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Tb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new xn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},x_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},zs={h:0,s:0,l:0},wc={h:0,s:0,l:0};function Hd(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ne=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=on){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,nt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=nt.workingColorSpace){return this.r=e,this.g=t,this.b=n,nt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=nt.workingColorSpace){if(e=Jf(e,1),t=Ye(t,0,1),n=Ye(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Hd(o,r,e+1/3),this.g=Hd(o,r,e),this.b=Hd(o,r,e-1/3)}return nt.colorSpaceToWorking(this,s),this}setStyle(e,t=on){function n(r){r!==void 0&&parseFloat(r)<1&&De("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:De("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);De("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=on){let n=x_[e.toLowerCase()];return n!==void 0?this.setHex(n,t):De("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ms(e.r),this.g=ms(e.g),this.b=ms(e.b),this}copyLinearToSRGB(e){return this.r=po(e.r),this.g=po(e.g),this.b=po(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=on){return nt.workingToColorSpace(Nn.copy(this),e),Math.round(Ye(Nn.r*255,0,255))*65536+Math.round(Ye(Nn.g*255,0,255))*256+Math.round(Ye(Nn.b*255,0,255))}getHexString(e=on){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=nt.workingColorSpace){nt.workingToColorSpace(Nn.copy(this),t);let n=Nn.r,s=Nn.g,r=Nn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=nt.workingColorSpace){return nt.workingToColorSpace(Nn.copy(this),t),e.r=Nn.r,e.g=Nn.g,e.b=Nn.b,e}getStyle(e=on){nt.workingToColorSpace(Nn.copy(this),e);let t=Nn.r,n=Nn.g,s=Nn.b;return e!==on?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(zs),this.setHSL(zs.h+e,zs.s+t,zs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(zs),e.getHSL(wc);let n=Ya(zs.h,wc.h,t),s=Ya(zs.s,wc.s,t),r=Ya(zs.l,wc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Nn=new Ne;Ne.NAMES=x_;var Ja=class extends $t{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Bi,this.environmentIntensity=1,this.environmentRotation=new Bi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Si=new P,us=new P,Gd=new P,hs=new P,to=new P,no=new P,t0=new P,Wd=new P,Xd=new P,qd=new P,Yd=new ot,$d=new ot,Kd=new ot,Un=class i{constructor(e=new P,t=new P,n=new P){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Si.subVectors(e,t),s.cross(Si);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Si.subVectors(s,t),us.subVectors(n,t),Gd.subVectors(e,t);let o=Si.dot(Si),a=Si.dot(us),l=Si.dot(Gd),c=us.dot(us),u=us.dot(Gd),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,hs)===null?!1:hs.x>=0&&hs.y>=0&&hs.x+hs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,hs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,hs.x),l.addScaledVector(o,hs.y),l.addScaledVector(a,hs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Yd.setScalar(0),$d.setScalar(0),Kd.setScalar(0),Yd.fromBufferAttribute(e,t),$d.fromBufferAttribute(e,n),Kd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Yd,r.x),o.addScaledVector($d,r.y),o.addScaledVector(Kd,r.z),o}static isFrontFacing(e,t,n,s){return Si.subVectors(n,t),us.subVectors(e,t),Si.cross(us).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Si.subVectors(this.c,this.b),us.subVectors(this.a,this.b),Si.cross(us).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;to.subVectors(s,n),no.subVectors(r,n),Wd.subVectors(e,n);let l=to.dot(Wd),c=no.dot(Wd);if(l<=0&&c<=0)return t.copy(n);Xd.subVectors(e,s);let u=to.dot(Xd),h=no.dot(Xd);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(to,o);qd.subVectors(e,r);let f=to.dot(qd),g=no.dot(qd);if(g>=0&&f<=g)return t.copy(r);let y=f*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(no,a);let m=u*g-f*h;if(m<=0&&h-u>=0&&f-g>=0)return t0.subVectors(r,s),a=(h-u)/(h-u+(f-g)),t.copy(s).addScaledVector(t0,a);let _=1/(m+y+d);return o=y*_,a=d*_,t.copy(n).addScaledVector(to,o).addScaledVector(no,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},je=class{constructor(e=new P(1/0,1/0,1/0),t=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Mi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Mi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Mi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Mi):Mi.fromBufferAttribute(r,o),Mi.applyMatrix4(e.matrixWorld),this.expandByPoint(Mi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ec.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ec.copy(n.boundingBox)),Ec.applyMatrix4(e.matrixWorld),this.union(Ec)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Mi),Mi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ka),Tc.subVectors(this.max,ka),io.subVectors(e.a,ka),so.subVectors(e.b,ka),ro.subVectors(e.c,ka),Vs.subVectors(so,io),Hs.subVectors(ro,so),vr.subVectors(io,ro);let t=[0,-Vs.z,Vs.y,0,-Hs.z,Hs.y,0,-vr.z,vr.y,Vs.z,0,-Vs.x,Hs.z,0,-Hs.x,vr.z,0,-vr.x,-Vs.y,Vs.x,0,-Hs.y,Hs.x,0,-vr.y,vr.x,0];return!Zd(t,io,so,ro,Tc)||(t=[1,0,0,0,1,0,0,0,1],!Zd(t,io,so,ro,Tc))?!1:(Ac.crossVectors(Vs,Hs),t=[Ac.x,Ac.y,Ac.z],Zd(t,io,so,ro,Tc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Mi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Mi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(ds[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),ds[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),ds[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),ds[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),ds[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),ds[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),ds[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),ds[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(ds),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},ds=[new P,new P,new P,new P,new P,new P,new P,new P],Mi=new P,Ec=new je,io=new P,so=new P,ro=new P,Vs=new P,Hs=new P,vr=new P,ka=new P,Tc=new P,Ac=new P,br=new P;function Zd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){br.fromArray(i,r);let a=s.x*Math.abs(br.x)+s.y*Math.abs(br.y)+s.z*Math.abs(br.z),l=e.dot(br),c=t.dot(br),u=n.dot(br);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var sn=new P,Rc=new Ue,Ab=0,pt=class extends ki{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ab++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Kf,this.updateRanges=[],this.gpuType=Gn,this.version=0,this._normalizationScale=e!==void 0?ah(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Rc.fromBufferAttribute(this,t),Rc.applyMatrix3(e),this.setXY(t,Rc.x,Rc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)sn.fromBufferAttribute(this,t),sn.applyMatrix3(e),this.setXYZ(t,sn.x,sn.y,sn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)sn.fromBufferAttribute(this,t),sn.applyMatrix4(e),this.setXYZ(t,sn.x,sn.y,sn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)sn.fromBufferAttribute(this,t),sn.applyNormalMatrix(e),this.setXYZ(t,sn.x,sn.y,sn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)sn.fromBufferAttribute(this,t),sn.transformDirection(e),this.setXYZ(t,sn.x,sn.y,sn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Qf(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ep(e,this.array)}};var ja=class extends pt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Qa=class extends pt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var ln=class extends pt{constructor(e,t,n){super(new Float32Array(e),t,n)}},Rb=new je,Ba=new P,Jd=new P,kt=class{constructor(e=new P,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Rb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ba.subVectors(e,this.center);let t=Ba.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Ba,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Jd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ba.copy(e.center).add(Jd)),this.expandByPoint(Ba.copy(e.center).sub(Jd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Cb=0,hi=new Re,jd=new $t,oo=new P,ri=new je,za=new je,_n=new P,Xt=class i extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Cb++}),this.uuid=$i(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(eb(e)?Qa:ja)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new qe().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return hi.makeRotationFromQuaternion(e),this.applyMatrix4(hi),this}rotateX(e){return hi.makeRotationX(e),this.applyMatrix4(hi),this}rotateY(e){return hi.makeRotationY(e),this.applyMatrix4(hi),this}rotateZ(e){return hi.makeRotationZ(e),this.applyMatrix4(hi),this}translate(e,t,n){return hi.makeTranslation(e,t,n),this.applyMatrix4(hi),this}scale(e,t,n){return hi.makeScale(e,t,n),this.applyMatrix4(hi),this}lookAt(e){return jd.lookAt(e),jd.updateMatrix(),this.applyMatrix4(jd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(oo).negate(),this.translate(oo.x,oo.y,oo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ln(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&De("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new je);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ge("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ri.setFromBufferAttribute(r),this.morphTargetsRelative?(_n.addVectors(this.boundingBox.min,ri.min),this.boundingBox.expandByPoint(_n),_n.addVectors(this.boundingBox.max,ri.max),this.boundingBox.expandByPoint(_n)):(this.boundingBox.expandByPoint(ri.min),this.boundingBox.expandByPoint(ri.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ge('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new kt);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Ge("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(e){let n=this.boundingSphere.center;if(ri.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];za.setFromBufferAttribute(a),this.morphTargetsRelative?(_n.addVectors(ri.min,za.min),ri.expandByPoint(_n),_n.addVectors(ri.max,za.max),ri.expandByPoint(_n)):(ri.expandByPoint(za.min),ri.expandByPoint(za.max))}ri.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)_n.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(_n));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)_n.fromBufferAttribute(a,c),l&&(oo.fromBufferAttribute(e,c),_n.add(oo)),s=Math.max(s,n.distanceToSquared(_n))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ge('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Ge("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new pt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let A=0;A<n.count;A++)a[A]=new P,l[A]=new P;let u=new P,h=new P,d=new P,f=new Ue,g=new Ue,y=new Ue,m=new P,_=new P;function v(A,E,C){c[A]=c[E]=c[C]=1,u.fromBufferAttribute(n,A),h.fromBufferAttribute(n,E),d.fromBufferAttribute(n,C),f.fromBufferAttribute(r,A),g.fromBufferAttribute(r,E),y.fromBufferAttribute(r,C),h.sub(u),d.sub(u),g.sub(f),y.sub(f);let I=1/(g.x*y.y-y.x*g.y);isFinite(I)&&(m.copy(h).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(I),_.copy(d).multiplyScalar(g.x).addScaledVector(h,-y.x).multiplyScalar(I),a[A].add(m),a[E].add(m),a[C].add(m),l[A].add(_),l[E].add(_),l[C].add(_))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let A=0,E=M.length;A<E;++A){let C=M[A],I=C.start,D=C.count;for(let L=I,U=I+D;L<U;L+=3)v(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let b=new P,w=new P,x=new P,p=new P;function S(A){x.fromBufferAttribute(s,A),p.copy(x);let E=a[A];b.copy(E),b.sub(x.multiplyScalar(x.dot(E))).normalize(),w.crossVectors(p,E);let I=w.dot(l[A])<0?-1:1;o.setXYZW(A,b.x,b.y,b.z,I)}for(let A=0,E=n.count;A<E;++A)c[A]&&S(A);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new pt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new P,r=new P,o=new P,a=new P,l=new P,c=new P,u=new P,h=new P;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),y=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)_n.fromBufferAttribute(e,t),_n.normalize(),e.setXYZ(t,_n.x,_n.y,_n.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,g=0;for(let y=0,m=l.length;y<m;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let _=0;_<u;_++)d[g++]=c[f++]}return new pt(d,u,h)}if(this.index===null)return De("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Cr=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Kf,this.updateRanges=[],this.version=0,this.uuid=$i()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=n0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=n0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function n0(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=$i()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Vn=new P,Qn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?ah(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyMatrix4(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.applyNormalMatrix(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Vn.fromBufferAttribute(this,t),Vn.transformDirection(e),this.setXYZ(t,Vn.x,Vn.y,Vn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Ka("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new pt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ka("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Qf(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):ep(e,this.data.array)}},Qd=new P,Pb=new P,Ib=new qe,Hn=class{constructor(e=new P(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Qd.subVectors(n,t).cross(Pb.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Qd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Ib.getNormalMatrix(e),s=this.coplanarPoint(Qd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Lb=0,qn=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Lb++}),this.uuid=$i(),this.name="",this.type="Material",this.blending=Po,this.side=oi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Pf,this.blendDst=If,this.blendEquation=Or,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ne(0,0,0),this.blendAlpha=0,this.depthFunc=mo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=l_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Jc,this.stencilZFail=Jc,this.stencilZPass=Jc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){De(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){De(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ne().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Hn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Ue().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ue().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var fs=new P,ef=new P,Cc=new P,Pc=new P,zi=class{constructor(e=new P,t=new P(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,fs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=fs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(fs.copy(this.origin).addScaledVector(this.direction,t),fs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){ef.copy(e).add(t).multiplyScalar(.5),Cc.copy(t).sub(e).normalize(),Pc.copy(this.origin).sub(ef);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Cc),a=Pc.dot(this.direction),l=-Pc.dot(Cc),c=Pc.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(ef).addScaledVector(Cc,d),f}intersectSphere(e,t){if(e.radius<0)return null;fs.subVectors(e.center,this.origin);let n=fs.dot(this.direction),s=fs.dot(fs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,fs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,y=t.y-o.y,m=t.z-o.z,_=n.x-o.x,v=n.y-o.y,M=n.z-o.z,b=Math.abs(l),w=Math.abs(c),x=Math.abs(u),p,S,A,E,C,I,D,L,U,V,B,ne;if(b>=w&&b>=x?(A=l,I=h,U=g,ne=_,l>=0?(p=c,S=u,E=d,C=f,D=y,L=m,V=v,B=M):(p=u,S=c,E=f,C=d,D=m,L=y,V=M,B=v)):w>=x?(A=c,I=d,U=y,ne=v,c>=0?(p=u,S=l,E=f,C=h,D=m,L=g,V=M,B=_):(p=l,S=u,E=h,C=f,D=g,L=m,V=_,B=M)):(A=u,I=f,U=m,ne=M,u>=0?(p=l,S=c,E=h,C=d,D=g,L=y,V=_,B=v):(p=c,S=l,E=d,C=h,D=y,L=g,V=v,B=_)),A===0)return null;let z=p/A,q=S/A,W=1/A,ge=E-z*I,Ee=C-q*I,$=D-z*U,ae=L-q*U,se=V-z*ne,ce=B-q*ne,re=se*ae-ce*$,he=ge*ce-Ee*se,We=$*Ee-ae*ge;if(s){if(re<0||he<0||We<0)return null}else if((re<0||he<0||We<0)&&(re>0||he>0||We>0))return null;let Te=re+he+We;if(Te===0)return null;let ke=W*(re*I+he*U+We*ne);return(Te>0?ke<0:ke>0)?null:this.at(ke/Te,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},pi=class extends qn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ne(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bi,this.combine=bu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},i0=new Re,Sr=new zi,Ic=new kt,s0=new P,Lc=new P,Oc=new P,Nc=new P,tf=new P,Dc=new P,r0=new P,Uc=new P,Tt=class extends $t{constructor(e=new Xt,t=new pi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Dc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(tf.fromBufferAttribute(h,e),o?Dc.addScaledVector(tf,u):Dc.addScaledVector(tf.sub(t),u))}t.add(Dc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Ic.copy(n.boundingSphere),Ic.applyMatrix4(r),Sr.copy(e.ray).recast(e.near),!(Ic.containsPoint(Sr.origin)===!1&&(Sr.intersectSphere(Ic,s0)===null||Sr.origin.distanceToSquared(s0)>(e.far-e.near)**2))&&(i0.copy(r).invert(),Sr.copy(e.ray).applyMatrix4(i0),!(n.boundingBox!==null&&Sr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Sr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let m=d[g],_=o[m.materialIndex],v=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,w=M;b<w;b+=3){let x=a.getX(b),p=a.getX(b+1),S=a.getX(b+2);s=Fc(this,_,e,n,c,u,h,x,p,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let m=g,_=y;m<_;m+=3){let v=a.getX(m),M=a.getX(m+1),b=a.getX(m+2);s=Fc(this,o,e,n,c,u,h,v,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let m=d[g],_=o[m.materialIndex],v=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,w=M;b<w;b+=3){let x=b,p=b+1,S=b+2;s=Fc(this,_,e,n,c,u,h,x,p,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let m=g,_=y;m<_;m+=3){let v=m,M=m+1,b=m+2;s=Fc(this,o,e,n,c,u,h,v,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Ob(i,e,t,n,s,r,o,a){let l;if(e.side===Mn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===oi,a),l===null)return null;Uc.copy(a),Uc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Uc);return c<t.near||c>t.far?null:{distance:c,point:Uc.clone(),object:i}}function Fc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Lc),i.getVertexPosition(l,Oc),i.getVertexPosition(c,Nc);let u=Ob(i,e,t,n,Lc,Oc,Nc,r0);if(u){let h=new P;Un.getBarycoord(r0,Lc,Oc,Nc,h),s&&(u.uv=Un.getInterpolatedAttribute(s,a,l,c,h,new Ue)),r&&(u.uv1=Un.getInterpolatedAttribute(r,a,l,c,h,new Ue)),o&&(u.normal=Un.getInterpolatedAttribute(o,a,l,c,h,new P),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new P,materialIndex:0};Un.getNormal(Lc,Oc,Nc,d.normal),u.face=d,u.barycoord=h}return u}var Va=new ot,o0=new ot,a0=new ot,Nb=new ot,l0=new Re,kc=new P,nf=new kt,c0=new Re,sf=new zi,el=class extends Tt{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=df,this.bindMatrix=new Re,this.bindMatrixInverse=new Re,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new je),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,kc),this.boundingBox.expandByPoint(kc)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new kt),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,kc),this.boundingSphere.expandByPoint(kc)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,s=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),nf.copy(this.boundingSphere),nf.applyMatrix4(s),e.ray.intersectsSphere(nf)!==!1&&(c0.copy(s).invert(),sf.copy(e.ray).applyMatrix4(c0),!(this.boundingBox!==null&&sf.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,sf)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new ot,t=this.geometry.attributes.skinWeight;for(let n=0,s=t.count;n<s;n++){e.fromBufferAttribute(t,n);let r=1/e.manhattanLength();r!==1/0?e.multiplyScalar(r):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===df?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===s_?this.bindMatrixInverse.copy(this.bindMatrix).invert():De("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,s=this.geometry;o0.fromBufferAttribute(s.attributes.skinIndex,e),a0.fromBufferAttribute(s.attributes.skinWeight,e),t.isVector4?(Va.copy(t),t.set(0,0,0,0)):(Va.set(t.x,t.y,t.z,1),t.set(0,0,0)),Va.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=a0.getComponent(r);if(o!==0){let a=o0.getComponent(r);l0.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(Nb.copy(Va).applyMatrix4(l0),o)}}return t.isVector4&&(t.w=Va.w),t.applyMatrix4(this.bindMatrixInverse)}},Mo=class extends $t{constructor(){super(),this.isBone=!0,this.type="Bone"}},gs=class extends yn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=en,u=en,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},u0=new Re,Db=new Re,tl=class i{constructor(e=[],t=[]){this.uuid=$i(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){De("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,s=this.bones.length;n<s;n++)this.boneInverses.push(new Re)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new Re;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,s=this.boneTexture;for(let r=0,o=e.length;r<o;r++){let a=e[r]?e[r].matrixWorld:Db;u0.multiplyMatrices(a,t[r]),u0.toArray(n,r*16)}s!==null&&(s.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new gs(t,e,e,jn,Gn);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let s=this.bones[t];if(s.name===e)return s}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,s=e.bones.length;n<s;n++){let r=e.bones[n],o=t[r];o===void 0&&(De("Skeleton: No bone found with UUID:",r),o=new Mo),this.bones.push(o),this.boneInverses.push(new Re().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let s=0,r=t.length;s<r;s++){let o=t[s];e.bones.push(o.uuid);let a=n[s];e.boneInverses.push(a.toArray())}return e}},xs=class extends pt{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},ao=new Re,h0=new Re,Bc=[],d0=new je,Ub=new Re,Ha=new Tt,Ga=new kt,nl=class extends Tt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new xs(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Ub)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new je),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,ao),d0.copy(e.boundingBox).applyMatrix4(ao),this.boundingBox.union(d0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new kt),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,ao),Ga.copy(e.boundingSphere).applyMatrix4(ao),this.boundingSphere.union(Ga)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(Ha.geometry=this.geometry,Ha.material=this.material,Ha.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ga.copy(this.boundingSphere),Ga.applyMatrix4(n),e.ray.intersectsSphere(Ga)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ao),h0.multiplyMatrices(n,ao),Ha.matrixWorld=h0,Ha.raycast(e,Bc);for(let o=0,a=Bc.length;o<a;o++){let l=Bc[o];l.instanceId=r,l.object=this,t.push(l)}Bc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new xs(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new gs(new Float32Array(s*this.count),s,this.count,Ru,Gn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Mr=new kt,Fb=new Ue(.5,.5),zc=new P,ys=class{constructor(e=new Hn,t=new Hn,n=new Hn,s=new Hn,r=new Hn,o=new Hn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=fi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],y=r[9],m=r[10],_=r[11],v=r[12],M=r[13],b=r[14],w=r[15];if(s[0].setComponents(c-o,f-u,_-g,w-v).normalize(),s[1].setComponents(c+o,f+u,_+g,w+v).normalize(),s[2].setComponents(c+a,f+h,_+y,w+M).normalize(),s[3].setComponents(c-a,f-h,_-y,w-M).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,_-m,w-b).normalize();else if(s[4].setComponents(c-l,f-d,_-m,w-b).normalize(),t===fi)s[5].setComponents(c+l,f+d,_+m,w+b).normalize();else if(t===_o)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Mr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Mr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Mr)}intersectsSprite(e){Mr.center.set(0,0,0);let t=Fb.distanceTo(e.center);return Mr.radius=.7071067811865476+t,Mr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Mr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(zc.x=s.normal.x>0?e.max.x:e.min.x,zc.y=s.normal.y>0?e.max.y:e.min.y,zc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(zc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},f0=new Re,il=class i{constructor(){this.coordinateSystem=fi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];f0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new ys),n[s].setFromProjectionMatrix(f0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new ys),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};function rf(i,e){return i-e}function kb(i,e){return i.z-e.z}function Bb(i,e){return e.z-i.z}var _f=class{constructor(){this.index=0,this.pool=[],this.list=[]}push(e,t,n,s){let r=this.pool,o=this.list;this.index>=r.length&&r.push({start:-1,count:-1,z:-1,index:-1});let a=r[this.index];o.push(a),this.index++,a.start=e,a.count=t,a.z=n,a.index=s}reset(){this.list.length=0,this.index=0}},Jn=new Re,zb=new Ne(1,1,1),Vb=new ys,Hb=new il,Vc=new je,wr=new kt,of=new P,p0=new P,m0=new P,Gb=new P,af=new _f,Dn=new Tt,Hc=[];function Wb(i,e,t=0){let n=e.itemSize;if(i.isInterleavedBufferAttribute||i.array.constructor!==e.array.constructor){let s=i.count;for(let r=0;r<s;r++)for(let o=0;o<n;o++)e.setComponent(r+t,o,i.getComponent(r,o))}else e.array.set(i.array,t*n);e.needsUpdate=!0}function Di(i,e){if(i.constructor!==e.constructor){let t=Math.min(i.length,e.length);for(let n=0;n<t;n++)e[n]=i[n]}else{let t=Math.min(i.length,e.length);e.set(new i.constructor(i.buffer,0,t))}}var sl=class extends Tt{constructor(e,t,n=t*2,s){super(new Xt,s),this.isBatchedMesh=!0,this.perObjectFrustumCulled=!0,this.sortObjects=!0,this.boundingBox=null,this.boundingSphere=null,this.customSort=null,this._instanceInfo=[],this._geometryInfo=[],this._availableInstanceIds=[],this._availableGeometryIds=[],this._nextIndexStart=0,this._nextVertexStart=0,this._geometryCount=0,this._visibilityChanged=!0,this._geometryInitialized=!1,this._maxInstanceCount=e,this._maxVertexCount=t,this._maxIndexCount=n,this._multiDrawCounts=new Int32Array(e),this._multiDrawStarts=new Int32Array(e),this._multiDrawCount=0,this._multiDrawBytesPerElement=1,this._mergedDrawCounts=new Int32Array(e),this._mergedDrawStarts=new Int32Array(e),this._mergedDrawInstanceCounts=new Int32Array(e),this._mergedDrawCount=0,this._matricesTexture=null,this._indirectTexture=null,this._colorsTexture=null,this._previousMatricesTexture=null,this._initMatricesTexture(),this._initIndirectTexture()}get maxInstanceCount(){return this._maxInstanceCount}get instanceCount(){return this._instanceInfo.length-this._availableInstanceIds.length}get unusedVertexCount(){return this._maxVertexCount-this._nextVertexStart}get unusedIndexCount(){return this._maxIndexCount-this._nextIndexStart}_initMatricesTexture(){let e=Math.sqrt(this._maxInstanceCount*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4),n=new gs(t,e,e,jn,Gn);this._matricesTexture=n}_initIndirectTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Uint32Array(e*e),n=new gs(t,e,e,Sl,gi);this._indirectTexture=n}_initColorsTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Float32Array(e*e*4).fill(1),n=new gs(t,e,e,jn,Gn);n.colorSpace=nt.workingColorSpace,this._colorsTexture=n}_initializeGeometry(e){let t=this.geometry,n=this._maxVertexCount,s=this._maxIndexCount;if(this._geometryInitialized===!1){for(let r in e.attributes){let o=e.getAttribute(r),{array:a,itemSize:l,normalized:c}=o,u=new a.constructor(n*l),h=new pt(u,l,c);t.setAttribute(r,h)}if(e.getIndex()!==null){let r=n>65535?new Uint32Array(s):new Uint16Array(s);t.setIndex(new pt(r,1))}this._geometryInitialized=!0}}_validateGeometry(e){let t=this.geometry;if(!!e.getIndex()!=!!t.getIndex())throw new Error('THREE.BatchedMesh: All geometries must consistently have "index".');for(let n in t.attributes){if(!e.hasAttribute(n))throw new Error(`THREE.BatchedMesh: Added geometry missing "${n}". All geometries must have consistent attributes.`);let s=e.getAttribute(n),r=t.getAttribute(n);if(s.itemSize!==r.itemSize||s.normalized!==r.normalized)throw new Error(`THREE.BatchedMesh: Added geometry attribute "${n}" has an inconsistent itemSize or normalized value.`)}}validateInstanceId(e){let t=this._instanceInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid instanceId ${e}. Instance is either out of range or has been deleted.`)}validateGeometryId(e){let t=this._geometryInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid geometryId ${e}. Geometry is either out of range or has been deleted.`)}setCustomSort(e){return this.customSort=e,this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new je);let e=this.boundingBox,t=this._instanceInfo;e.makeEmpty();for(let n=0,s=t.length;n<s;n++){if(t[n].active===!1)continue;let r=t[n].geometryIndex;this.getMatrixAt(n,Jn),this.getBoundingBoxAt(r,Vc).applyMatrix4(Jn),e.union(Vc)}}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new kt);let e=this.boundingSphere,t=this._instanceInfo;e.makeEmpty();for(let n=0,s=t.length;n<s;n++){if(t[n].active===!1)continue;let r=t[n].geometryIndex;this.getMatrixAt(n,Jn),this.getBoundingSphereAt(r,wr).applyMatrix4(Jn),e.union(wr)}}addInstance(e){if(this._instanceInfo.length>=this.maxInstanceCount&&this._availableInstanceIds.length===0)throw new Error("THREE.BatchedMesh: Maximum item count reached.");let n={visible:!0,active:!0,geometryIndex:e},s=null;this._availableInstanceIds.length>0?(this._availableInstanceIds.sort(rf),s=this._availableInstanceIds.shift(),this._instanceInfo[s]=n):(s=this._instanceInfo.length,this._instanceInfo.push(n));let r=this._matricesTexture;Jn.identity().toArray(r.image.data,s*16),r.needsUpdate=!0;let o=this._colorsTexture;return o&&(zb.toArray(o.image.data,s*4),o.needsUpdate=!0),this._visibilityChanged=!0,s}addGeometry(e,t=-1,n=-1){this._initializeGeometry(e),this._validateGeometry(e);let s={vertexStart:-1,vertexCount:-1,reservedVertexCount:-1,indexStart:-1,indexCount:-1,reservedIndexCount:-1,start:-1,count:-1,boundingBox:null,boundingSphere:null,active:!0},r=this._geometryInfo;s.vertexStart=this._nextVertexStart,s.reservedVertexCount=t===-1?e.getAttribute("position").count:t;let o=e.getIndex();if(o!==null&&(s.indexStart=this._nextIndexStart,s.reservedIndexCount=n===-1?o.count:n),s.indexStart!==-1&&s.indexStart+s.reservedIndexCount>this._maxIndexCount||s.vertexStart+s.reservedVertexCount>this._maxVertexCount)throw new Error("THREE.BatchedMesh: Reserved space request exceeds the maximum buffer size.");let l;return this._availableGeometryIds.length>0?(this._availableGeometryIds.sort(rf),l=this._availableGeometryIds.shift(),r[l]=s):(l=this._geometryCount,this._geometryCount++,r.push(s)),this.setGeometryAt(l,e),this._nextIndexStart=s.indexStart+s.reservedIndexCount,this._nextVertexStart=s.vertexStart+s.reservedVertexCount,l}setGeometryAt(e,t){if(e>=this._geometryCount)throw new Error("THREE.BatchedMesh: Maximum geometry count reached.");this._validateGeometry(t);let n=this.geometry,s=n.getIndex()!==null,r=n.getIndex(),o=t.getIndex(),a=this._geometryInfo[e];if(s&&o.count>a.reservedIndexCount||t.attributes.position.count>a.reservedVertexCount)throw new Error("THREE.BatchedMesh: Reserved space not large enough for provided geometry.");let l=a.vertexStart,c=a.reservedVertexCount;a.vertexCount=t.getAttribute("position").count;for(let u in n.attributes){let h=t.getAttribute(u),d=n.getAttribute(u);Wb(h,d,l);let f=h.itemSize;for(let g=h.count,y=c;g<y;g++){let m=l+g;for(let _=0;_<f;_++)d.setComponent(m,_,0)}d.needsUpdate=!0,d.addUpdateRange(l*f,c*f)}if(s){let u=a.indexStart,h=a.reservedIndexCount;a.indexCount=t.getIndex().count;for(let d=0;d<o.count;d++)r.setX(u+d,l+o.getX(d));for(let d=o.count,f=h;d<f;d++)r.setX(u+d,l);r.needsUpdate=!0,r.addUpdateRange(u,a.reservedIndexCount)}return a.start=s?a.indexStart:a.vertexStart,a.count=s?a.indexCount:a.vertexCount,a.boundingBox=null,t.boundingBox!==null&&(a.boundingBox=t.boundingBox.clone()),a.boundingSphere=null,t.boundingSphere!==null&&(a.boundingSphere=t.boundingSphere.clone()),this._visibilityChanged=!0,e}deleteGeometry(e){let t=this._geometryInfo;if(e>=t.length||t[e].active===!1)return this;let n=this._instanceInfo;for(let s=0,r=n.length;s<r;s++)n[s].active&&n[s].geometryIndex===e&&this.deleteInstance(s);return t[e].active=!1,this._availableGeometryIds.push(e),this._visibilityChanged=!0,this}deleteInstance(e){return this.validateInstanceId(e),this._instanceInfo[e].active=!1,this._availableInstanceIds.push(e),this._visibilityChanged=!0,this}optimize(){let e=0,t=0,n=this._geometryInfo,s=n.map((o,a)=>a).sort((o,a)=>n[o].vertexStart-n[a].vertexStart),r=this.geometry;for(let o=0,a=n.length;o<a;o++){let l=s[o],c=n[l];if(c.active!==!1){if(r.index!==null){if(c.indexStart!==t){let{indexStart:u,vertexStart:h,reservedIndexCount:d}=c,f=r.index,g=f.array,y=e-h;for(let m=u;m<u+d;m++)g[m]=g[m]+y;f.array.copyWithin(t,u,u+d),f.addUpdateRange(t,d),f.needsUpdate=!0,c.indexStart=t}t+=c.reservedIndexCount}if(c.vertexStart!==e){let{vertexStart:u,reservedVertexCount:h}=c,d=r.attributes;for(let f in d){let g=d[f],{array:y,itemSize:m}=g;y.copyWithin(e*m,u*m,(u+h)*m),g.addUpdateRange(e*m,h*m),g.needsUpdate=!0}c.vertexStart=e}e+=c.reservedVertexCount,c.start=r.index?c.indexStart:c.vertexStart}}return this._nextIndexStart=t,this._nextVertexStart=e,this._visibilityChanged=!0,this}getBoundingBoxAt(e,t){if(e>=this._geometryCount)return null;let n=this.geometry,s=this._geometryInfo[e];if(s.boundingBox===null){let r=new je,o=n.index,a=n.attributes.position;for(let l=s.start,c=s.start+s.count;l<c;l++){let u=l;o&&(u=o.getX(u)),r.expandByPoint(of.fromBufferAttribute(a,u))}s.boundingBox=r}return t.copy(s.boundingBox),t}getBoundingSphereAt(e,t){if(e>=this._geometryCount)return null;let n=this.geometry,s=this._geometryInfo[e];if(s.boundingSphere===null){let r=new kt;this.getBoundingBoxAt(e,Vc),Vc.getCenter(r.center);let o=n.index,a=n.attributes.position,l=0;for(let c=s.start,u=s.start+s.count;c<u;c++){let h=c;o&&(h=o.getX(h)),of.fromBufferAttribute(a,h),l=Math.max(l,r.center.distanceToSquared(of))}r.radius=Math.sqrt(l),s.boundingSphere=r}return t.copy(s.boundingSphere),t}setMatrixAt(e,t){this.validateInstanceId(e);let n=this._matricesTexture,s=this._matricesTexture.image.data;return t.toArray(s,e*16),n.needsUpdate=!0,this}getMatrixAt(e,t){return this.validateInstanceId(e),t.fromArray(this._matricesTexture.image.data,e*16)}setColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null&&this._initColorsTexture(),t.toArray(this._colorsTexture.image.data,e*4),this._colorsTexture.needsUpdate=!0,this}getColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null?t.isVector4?t.set(1,1,1,1):t.setRGB(1,1,1):t.fromArray(this._colorsTexture.image.data,e*4)}setVisibleAt(e,t){return this.validateInstanceId(e),this._instanceInfo[e].visible===t?this:(this._instanceInfo[e].visible=t,this._visibilityChanged=!0,this)}getVisibleAt(e){return this.validateInstanceId(e),this._instanceInfo[e].visible}setGeometryIdAt(e,t){return this.validateInstanceId(e),this.validateGeometryId(t),this._instanceInfo[e].geometryIndex=t,this._visibilityChanged=!0,this}getGeometryIdAt(e){return this.validateInstanceId(e),this._instanceInfo[e].geometryIndex}getGeometryRangeAt(e,t={}){this.validateGeometryId(e);let n=this._geometryInfo[e];return t.vertexStart=n.vertexStart,t.vertexCount=n.vertexCount,t.reservedVertexCount=n.reservedVertexCount,t.indexStart=n.indexStart,t.indexCount=n.indexCount,t.reservedIndexCount=n.reservedIndexCount,t.start=n.start,t.count=n.count,t}setInstanceCount(e){let t=this._availableInstanceIds,n=this._instanceInfo;for(t.sort(rf);t[t.length-1]===n.length-1;)n.pop(),t.pop();if(e<n.length)throw new Error(`THREE.BatchedMesh: Instance ids outside the range ${e} are being used. Cannot shrink instance count.`);let s=new Int32Array(e),r=new Int32Array(e);Di(this._multiDrawCounts,s),Di(this._multiDrawStarts,r),this._multiDrawCounts=s,this._multiDrawStarts=r;let o=new Int32Array(e),a=new Int32Array(e),l=new Int32Array(e);Di(this._mergedDrawCounts,o),Di(this._mergedDrawStarts,a),Di(this._mergedDrawInstanceCounts,l),this._mergedDrawCounts=o,this._mergedDrawStarts=a,this._mergedDrawInstanceCounts=l,this._maxInstanceCount=e;let c=this._indirectTexture,u=this._matricesTexture,h=this._colorsTexture;c.dispose(),this._initIndirectTexture(),Di(c.image.data,this._indirectTexture.image.data),u.dispose(),this._initMatricesTexture(),Di(u.image.data,this._matricesTexture.image.data),h&&(h.dispose(),this._initColorsTexture(),Di(h.image.data,this._colorsTexture.image.data)),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}setGeometrySize(e,t){let n=[...this._geometryInfo].filter(a=>a.active);if(Math.max(...n.map(a=>a.vertexStart+a.reservedVertexCount))>e)throw new Error(`THREE.BatchedMesh: Geometry vertex values are being used outside the range ${e}. Cannot shrink further.`);if(this.geometry.index&&Math.max(...n.map(l=>l.indexStart+l.reservedIndexCount))>t)throw new Error(`THREE.BatchedMesh: Geometry index values are being used outside the range ${t}. Cannot shrink further.`);let r=this.geometry;r.dispose(),this._maxVertexCount=e,this._maxIndexCount=t,this._geometryInitialized&&(this._geometryInitialized=!1,this.geometry=new Xt,this._initializeGeometry(r));let o=this.geometry;r.index&&Di(r.index.array,o.index.array);for(let a in r.attributes)Di(r.attributes[a].array,o.attributes[a].array);this._visibilityChanged=!0}raycast(e,t){let n=this._instanceInfo,s=this._geometryInfo,r=this.matrixWorld,o=this.geometry;Dn.material=this.material,Dn.geometry.index=o.index,Dn.geometry.attributes=o.attributes,Dn.geometry.boundingBox===null&&(Dn.geometry.boundingBox=new je),Dn.geometry.boundingSphere===null&&(Dn.geometry.boundingSphere=new kt);for(let a=0,l=n.length;a<l;a++){if(!n[a].visible||!n[a].active)continue;let c=n[a].geometryIndex,u=s[c];Dn.geometry.setDrawRange(u.start,u.count),this.getMatrixAt(a,Dn.matrixWorld).premultiply(r),this.getBoundingBoxAt(c,Dn.geometry.boundingBox),this.getBoundingSphereAt(c,Dn.geometry.boundingSphere),Dn.raycast(e,Hc);for(let h=0,d=Hc.length;h<d;h++){let f=Hc[h];f.object=this,f.batchId=a,t.push(f)}Hc.length=0}Dn.material=null,Dn.geometry.index=null,Dn.geometry.attributes={},Dn.geometry.setDrawRange(0,1/0)}copy(e){return super.copy(e),this.geometry=e.geometry.clone(),this.perObjectFrustumCulled=e.perObjectFrustumCulled,this.sortObjects=e.sortObjects,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this._geometryInfo=e._geometryInfo.map(t=>({...t,boundingBox:t.boundingBox!==null?t.boundingBox.clone():null,boundingSphere:t.boundingSphere!==null?t.boundingSphere.clone():null})),this._instanceInfo=e._instanceInfo.map(t=>({...t})),this._availableInstanceIds=e._availableInstanceIds.slice(),this._availableGeometryIds=e._availableGeometryIds.slice(),this._nextIndexStart=e._nextIndexStart,this._nextVertexStart=e._nextVertexStart,this._geometryCount=e._geometryCount,this._maxInstanceCount=e._maxInstanceCount,this._maxVertexCount=e._maxVertexCount,this._maxIndexCount=e._maxIndexCount,this._geometryInitialized=e._geometryInitialized,this._multiDrawCounts=e._multiDrawCounts.slice(),this._multiDrawStarts=e._multiDrawStarts.slice(),this._multiDrawBytesPerElement=e._multiDrawBytesPerElement,this._mergedDrawCounts=e._mergedDrawCounts.slice(),this._mergedDrawStarts=e._mergedDrawStarts.slice(),this._mergedDrawInstanceCounts=e._mergedDrawInstanceCounts.slice(),this._indirectTexture=e._indirectTexture.clone(),this._indirectTexture.image.data=this._indirectTexture.image.data.slice(),this._matricesTexture=e._matricesTexture.clone(),this._matricesTexture.image.data=this._matricesTexture.image.data.slice(),e._colorsTexture!==null?(this._colorsTexture=e._colorsTexture.clone(),this._colorsTexture.image.data=this._colorsTexture.image.data.slice()):this._colorsTexture=null,this}dispose(){super.dispose(),this.geometry.dispose(),this._matricesTexture.dispose(),this._matricesTexture=null,this._indirectTexture.dispose(),this._indirectTexture=null,this._colorsTexture!==null&&(this._colorsTexture.dispose(),this._colorsTexture=null),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}_updateDrawParameters(e,t,n,s="multiDraw"){if(!this._visibilityChanged&&!this.perObjectFrustumCulled&&!this.sortObjects)return;let r=t.getIndex(),o=r===null?1:r.array.BYTES_PER_ELEMENT,a=1;n.wireframe&&(a=2,o=t.attributes.position.count>65535?4:2);let l=this._instanceInfo,c=this._multiDrawStarts,u=this._multiDrawCounts,h=this._mergedDrawStarts,d=this._mergedDrawCounts,f=this._mergedDrawInstanceCounts,g=this._geometryInfo,y=this.perObjectFrustumCulled,m=this._indirectTexture,_=m.image.data,v=e.isArrayCamera?Hb:Vb;y&&(e.isArrayCamera?v.setFromArrayCamera(e):(Jn.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).multiply(this.matrixWorld),v.setFromProjectionMatrix(Jn,e.coordinateSystem,e.reversedDepth)));let M=0,b=0;if(this.sortObjects){Jn.copy(this.matrixWorld).invert(),p0.setFromMatrixPosition(e.matrixWorld).applyMatrix4(Jn),m0.set(0,0,-1).transformDirection(e.matrixWorld).transformDirection(Jn);for(let p=0,S=l.length;p<S;p++)if(l[p].visible&&l[p].active){let A=l[p].geometryIndex;this.getMatrixAt(p,Jn),this.getBoundingSphereAt(A,wr).applyMatrix4(Jn);let E=!1;if(y&&(E=!v.intersectsSphere(wr)),!E){let C=g[A],I=Gb.subVectors(wr.center,p0).dot(m0);af.push(C.start,C.count,I,p)}}let w=af.list,x=this.customSort;x===null?w.sort(n.transparent?Bb:kb):x.call(this,w,e);for(let p=0,S=w.length;p<S;p++){let A=w[p],E=A.start*o*a,C=A.count*a;s==="merged"?b>0&&h[b-1]===E&&d[b-1]===C?f[b-1]++:(h[b]=E,d[b]=C,f[b]=1,b++):(c[M]=E,u[M]=C),_[M]=A.index,M++}af.reset()}else for(let w=0,x=l.length;w<x;w++)if(l[w].visible&&l[w].active){let p=l[w].geometryIndex,S=!1;if(y&&(this.getMatrixAt(w,Jn),this.getBoundingSphereAt(p,wr).applyMatrix4(Jn),S=!v.intersectsSphere(wr)),!S){let A=g[p],E=A.start*o*a,C=A.count*a;s==="merged"?b>0&&h[b-1]===E&&d[b-1]===C?f[b-1]++:(h[b]=E,d[b]=C,f[b]=1,b++):(c[M]=E,u[M]=C),_[M]=w,M++}}m.needsUpdate=!0,this._multiDrawCount=M,this._mergedDrawCount=b,this._multiDrawBytesPerElement=o,this._visibilityChanged=!1}onBeforeRender(e,t,n,s,r){e.isWebGPURenderer===!0?(this._visibilityChanged||this.perObjectFrustumCulled||this.sortObjects)&&(this._indirectTexture.needsUpdate=!0):this._updateDrawParameters(n,s,r)}onBeforeShadow(e,t,n,s,r,o){e.isWebGPURenderer!==!0&&this._updateDrawParameters(s,r,o)}},qs=class extends qn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ne(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},lu=new P,cu=new P,g0=new Re,Wa=new zi,Gc=new kt,lf=new P,_0=new P,Vi=class extends $t{constructor(e=new Xt,t=new qs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)lu.fromBufferAttribute(t,s-1),cu.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=lu.distanceTo(cu);e.setAttribute("lineDistance",new ln(n,1))}else De("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Gc.copy(n.boundingSphere),Gc.applyMatrix4(s),Gc.radius+=r,e.ray.intersectsSphere(Gc)===!1)return;g0.copy(s).invert(),Wa.copy(e.ray).applyMatrix4(g0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let _=u.getX(y),v=u.getX(y+1),M=Wc(this,e,Wa,l,_,v,y);M&&t.push(M)}if(this.isLineLoop){let y=u.getX(g-1),m=u.getX(f),_=Wc(this,e,Wa,l,y,m,g-1);_&&t.push(_)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=f,m=g-1;y<m;y+=c){let _=Wc(this,e,Wa,l,y,y+1,y);_&&t.push(_)}if(this.isLineLoop){let y=Wc(this,e,Wa,l,g-1,f,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Wc(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(lu.fromBufferAttribute(a,s),cu.fromBufferAttribute(a,r),t.distanceSqToSegment(lu,cu,lf,_0)>n)return;lf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(lf);if(!(c<e.near||c>e.far))return{distance:c,point:_0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var x0=new P,y0=new P,Hi=class extends Vi{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)x0.fromBufferAttribute(t,s),y0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+x0.distanceTo(y0);e.setAttribute("lineDistance",new ln(n,1))}else De("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},Ys=class extends Vi{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},wo=class extends qn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ne(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},v0=new Re,xf=new zi,Xc=new kt,qc=new P,wi=class extends $t{constructor(e=new Xt,t=new wo){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Xc.copy(n.boundingSphere),Xc.applyMatrix4(s),Xc.radius+=r,e.ray.intersectsSphere(Xc)===!1)return;v0.copy(s).invert(),xf.copy(e.ray).applyMatrix4(v0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=d,y=f;g<y;g++){let m=c.getX(g);qc.fromBufferAttribute(h,m),b0(qc,m,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let g=d,y=f;g<y;g++)qc.fromBufferAttribute(h,g),b0(qc,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function b0(i,e,t,n,s,r,o){let a=xf.distanceSqToPoint(i);if(a<t){let l=new P;xf.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var rl=class extends yn{constructor(e=[],t=Nr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var vs=class extends yn{constructor(e,t,n=gi,s,r,o,a=en,l=en,c,u=_s,h=1){if(u!==_s&&u!==Rs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new vo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ol=class extends vs{constructor(e,t=gi,n=Nr,s,r,o=en,a=en,l,c=_s){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},al=class extends yn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Eo=class i extends Xt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ln(c,3)),this.setAttribute("normal",new ln(u,3)),this.setAttribute("uv",new ln(h,2));function g(y,m,_,v,M,b,w,x,p,S,A){let E=b/p,C=w/S,I=b/2,D=w/2,L=x/2,U=p+1,V=S+1,B=0,ne=0,z=new P;for(let q=0;q<V;q++){let W=q*C-D;for(let ge=0;ge<U;ge++){let Ee=ge*E-I;z[y]=Ee*v,z[m]=W*M,z[_]=L,c.push(z.x,z.y,z.z),z[y]=0,z[m]=0,z[_]=x>0?1:-1,u.push(z.x,z.y,z.z),h.push(ge/p),h.push(1-q/S),B+=1}}for(let q=0;q<S;q++)for(let W=0;W<p;W++){let ge=d+W+U*q,Ee=d+W+U*(q+1),$=d+(W+1)+U*(q+1),ae=d+(W+1)+U*q;l.push(ge,Ee,ae),l.push(Ee,$,ae),ne+=6}a.addGroup(f,ne,A),f+=ne,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Gi=class i extends Xt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],g=[],y=[],m=[];for(let _=0;_<u;_++){let v=_*d-o;for(let M=0;M<c;M++){let b=M*h-r;g.push(b,-v,0),y.push(0,0,1),m.push(M/a),m.push(1-_/l)}}for(let _=0;_<l;_++)for(let v=0;v<a;v++){let M=v+c*_,b=v+c*(_+1),w=v+1+c*(_+1),x=v+1+c*_;f.push(M,b,x),f.push(b,w,x)}this.setIndex(f),this.setAttribute("position",new ln(g,3)),this.setAttribute("normal",new ln(y,3)),this.setAttribute("uv",new ln(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var ll=class extends Xt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new P,r=new P;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],d=h.start,f=h.count;for(let g=d,y=d+f;g<y;g+=3)for(let m=0;m<3;m++){let _=a.getX(g+m),v=a.getX(g+(m+1)%3);s.fromBufferAttribute(o,_),r.fromBufferAttribute(o,v),S0(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),S0(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new ln(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function S0(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}function Fr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(M0(s))s.isRenderTargetTexture?(De("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(M0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function kn(i){let e={};for(let t=0;t<i.length;t++){let n=Fr(i[t]);for(let s in n)e[s]=n[s]}return e}function M0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Xb(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function tp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:nt.workingColorSpace}var Il={clone:Fr,merge:kn},qb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Yb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,un=class extends qn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=qb,this.fragmentShader=Yb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Fr(e.uniforms),this.uniformsGroups=Xb(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ne().setHex(s.value);break;case"v2":this.uniforms[n].value=new Ue().fromArray(s.value);break;case"v3":this.uniforms[n].value=new P().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ot().fromArray(s.value);break;case"m3":this.uniforms[n].value=new qe().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Re().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},uu=class extends un{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},bs=class extends qn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ne(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ne(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Pl,this.normalScale=new Ue(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Yn=class extends bs{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new Ue(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return Ye(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new Ne(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new Ne(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new Ne(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Er('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Er('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var cl=class extends qn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ne(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ne(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Pl,this.normalScale=new Ue(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Bi,this.combine=bu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},hu=class extends qn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=o_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},du=class extends qn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ws(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Xa(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function $b(i){function e(s,r){return i[s]-i[r]}let t=i.length,n=new Array(t);for(let s=0;s!==t;++s)n[s]=s;return n.sort(e),n}function w0(i,e,t){let n=i.length,s=new i.constructor(n);for(let r=0,o=0;o!==n;++r){let a=t[r]*e;for(let l=0;l!==e;++l)s[o++]=i[a+l]}return s}function Kb(i,e,t,n){let s=1,r=i[0];for(;r!==void 0&&r[n]===void 0;)r=i[s++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(e.push(r.time),t.push(...o)),r=i[s++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(e.push(r.time),o.toArray(t,t.length)),r=i[s++];while(r!==void 0);else do o=r[n],o!==void 0&&(e.push(r.time),t.push(o)),r=i[s++];while(r!==void 0)}var Wi=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},fu=class extends Wi{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:pf,endingEnd:pf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case mf:r=e,a=2*t-n;break;case gf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case mf:o=e,l=2*n-t;break;case gf:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),y=g*g,m=y*g,_=-d*m+2*d*y-d*g,v=(1+d)*m+(-1.5-2*d)*y+(-.5+d)*g+1,M=(-1-f)*m+(1.5+f)*y+.5*g,b=f*m-f*y;for(let w=0;w!==a;++w)r[w]=_*o[u+w]+v*o[c+w]+M*o[l+w]+b*o[h+w];return r}},pu=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},mu=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},gu=class extends Wi{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(n-t)/(s-t),y=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*y+o[l+m]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let y=o[c+g],m=o[l+g],_=f*d+g*2,v=h[_],M=h[_+1],b=e*d+g*2,w=u[b],x=u[b+1],p=Jb(n,t,v,w,s);r[g]=y_(p,y,M,x,m)}return r}};function y_(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Zb(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Jb(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=y_(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Zb(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ei=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ws(t,this.TimeBufferType),this.values=Ws(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ws(e.times,Array),values:Ws(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Xa(e.settings)&&(n.settings={inTangents:Ws(e.settings.inTangents,Array),outTangents:Ws(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new mu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new pu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new fu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new gu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Tr:t=this.InterpolantFactoryMethodDiscrete;break;case Ar:t=this.InterpolantFactoryMethodLinear;break;case Zc:t=this.InterpolantFactoryMethodSmooth;break;case ff:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return De("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Tr;case this.InterpolantFactoryMethodLinear:return Ar;case this.InterpolantFactoryMethodSmooth:return Zc;case this.InterpolantFactoryMethodBezier:return ff}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Xa(this.settings)&&(E0(this.settings.inTangents,e),E0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Xa(this.settings)&&(T0(this.settings.inTangents,e),T0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Ge("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ge("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Ge("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Ge("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&tb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ge("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Zc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,d=h-n,f=h+n;for(let g=0;g!==n;++g){let y=t[h+g];if(y!==t[d+g]||y!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Xa(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function E0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function T0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ei.prototype.ValueTypeName="";ei.prototype.TimeBufferType=Float32Array;ei.prototype.ValueBufferType=Float32Array;ei.prototype.DefaultInterpolation=Ar;var Ss=class extends ei{constructor(e,t,n){super(e,t,n)}};Ss.prototype.ValueTypeName="bool";Ss.prototype.ValueBufferType=Array;Ss.prototype.DefaultInterpolation=Tr;Ss.prototype.InterpolantFactoryMethodLinear=void 0;Ss.prototype.InterpolantFactoryMethodSmooth=void 0;var ul=class extends ei{constructor(e,t,n,s){super(e,t,n,s)}};ul.prototype.ValueTypeName="color";var Ms=class extends ei{constructor(e,t,n,s){super(e,t,n,s)}};Ms.prototype.ValueTypeName="number";var _u=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Xn.slerpFlat(r,0,o,c-a,o,c,l);return r}},ws=class extends ei{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new _u(this.times,this.values,this.getValueSize(),e)}};ws.prototype.ValueTypeName="quaternion";ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Es=class extends ei{constructor(e,t,n){super(e,t,n)}};Es.prototype.ValueTypeName="string";Es.prototype.ValueBufferType=Array;Es.prototype.DefaultInterpolation=Tr;Es.prototype.InterpolantFactoryMethodLinear=void 0;Es.prototype.InterpolantFactoryMethodSmooth=void 0;var $s=class extends ei{constructor(e,t,n,s){super(e,t,n,s)}};$s.prototype.ValueTypeName="vector";var hl=class{constructor(e="",t=-1,n=[],s=r_){this.name=e,this.tracks=n,this.duration=t,this.blendMode=s,this.uuid=$i(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,s=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push(Qb(n[o]).scale(s));let r=new this(e.name,e.duration,t,e.blendMode);return r.uuid=e.uuid,r.userData=JSON.parse(e.userData||"{}"),r}static toJSON(e){let t=[],n=e.tracks,s={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let r=0,o=n.length;r!==o;++r)t.push(ei.toJSON(n[r]));return s}static CreateFromMorphTargetSequence(e,t,n,s){let r=t.length,o=[];for(let a=0;a<r;a++){let l=[],c=[];l.push((a+r-1)%r,a,(a+1)%r),c.push(0,1,0);let u=$b(l);l=w0(l,1,u),c=w0(c,1,u),!s&&l[0]===0&&(l.push(r),c.push(c[0])),o.push(new Ms(".morphTargetInfluences["+t[a].name+"]",l,c).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let s=e;n=s.geometry&&s.geometry.animations||s.animations}for(let s=0;s<n.length;s++)if(n[s].name===t)return n[s];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let s={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,l=e.length;a<l;a++){let c=e[a],u=c.name.match(r);if(u&&u.length>1){let h=u[1],d=s[h];d||(s[h]=d=[]),d.push(c)}}let o=[];for(let a in s)o.push(this.CreateFromMorphTargetSequence(a,s[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,s=e.length;n!==s;++n){let r=this.tracks[n];t=Math.max(t,r.times[r.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function jb(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Ms;case"vector":case"vector2":case"vector3":case"vector4":return $s;case"color":return ul;case"quaternion":return ws;case"bool":case"boolean":return Ss;case"string":return Es}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function Qb(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=jb(i.type);if(i.times===void 0){let n=[],s=[];Kb(i.keys,n,s,"value"),i.times=n,i.values=s}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),Xa(i.settings)&&(t.settings={inTangents:Ws(i.settings.inTangents,Float32Array),outTangents:Ws(i.settings.outTangents,Float32Array)}),t}var Fi={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(A0(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!A0(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function A0(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var xu=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],g=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},v_=new xu,Xi=class{constructor(e){this.manager=e!==void 0?e:v_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Xi.DEFAULT_MATERIAL_NAME="__DEFAULT";var ps={},yf=class extends Error{constructor(e,t){super(e),this.response=t}},To=class extends Xi{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Fi.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(ps[e]!==void 0){ps[e].push({onLoad:t,onProgress:n,onError:s});return}ps[e]=[],ps[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&De("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=ps[e],h=c.body.getReader(),d=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),f=d?parseInt(d):0,g=f!==0,y=0,m=new ReadableStream({start(_){v();function v(){h.read().then(({done:M,value:b})=>{if(M)_.close();else{y+=b.byteLength;let w=new ProgressEvent("progress",{lengthComputable:g,loaded:y,total:f});for(let x=0,p=u.length;x<p;x++){let S=u[x];S.onProgress&&S.onProgress(w)}_.enqueue(b),v()}},M=>{_.error(M)})}}});return new Response(m)}else throw new yf(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),d=h&&h[1]?h[1].toLowerCase():void 0,f=new TextDecoder(d);return c.arrayBuffer().then(g=>f.decode(g))}}}).then(c=>{Fi.add(`file:${e}`,c);let u=ps[e];delete ps[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onLoad&&f.onLoad(c)}}).catch(c=>{let u=ps[e];if(u===void 0)throw this.manager.itemError(e),c;delete ps[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onError&&f.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var lo=new WeakMap,yu=class extends Xi{constructor(e){super(e)}load(e,t,n,s){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=Fi.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(e),setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);else{let h=lo.get(o);h===void 0&&(h=[],lo.set(o,h)),h.push({onLoad:t,onError:s})}return o}let a=xo("img");function l(){u(),t&&t(this);let h=lo.get(this)||[];for(let d=0;d<h.length;d++){let f=h[d];f.onLoad&&f.onLoad(this)}lo.delete(this),r.manager.itemEnd(e)}function c(h){u(),s&&s(h),Fi.remove(`image:${e}`);let d=lo.get(this)||[];for(let f=0;f<d.length;f++){let g=d[f];g.onError&&g.onError(h)}lo.delete(this),r.manager.itemError(e),r.manager.itemEnd(e)}function u(){a.removeEventListener("load",l,!1),a.removeEventListener("error",c,!1)}return a.addEventListener("load",l,!1),a.addEventListener("error",c,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),Fi.add(`image:${e}`,a),r.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var dl=class extends Xi{constructor(e){super(e)}load(e,t,n,s){let r=new yn,o=new yu(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){r.image=a,r.needsUpdate=!0,t!==void 0&&t(r)},n,s),r}},Pr=class extends $t{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ne(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var cf=new Re,R0=new P,C0=new P,Ao=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ue(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new Re,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ys,this._frameExtents=new Ue(1,1),this._viewportCount=1,this._viewports=[new ot(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;R0.setFromMatrixPosition(e.matrixWorld),t.position.copy(R0),C0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(C0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){cf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(cf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===_o||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(cf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Yc=new P,$c=new Xn,Ui=new P,fl=class extends $t{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Re,this.projectionMatrix=new Re,this.projectionMatrixInverse=new Re,this.coordinateSystem=fi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Yc,$c,Ui),Ui.x===1&&Ui.y===1&&Ui.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Yc,$c,Ui.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Yc,$c,Ui),Ui.x===1&&Ui.y===1&&Ui.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Yc,$c,Ui.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Gs=new P,P0=new Ue,I0=new Ue,an=class extends fl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Rr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(qa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Rr*2*Math.atan(Math.tan(qa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Gs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z),Gs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Gs.x,Gs.y).multiplyScalar(-e/Gs.z)}getViewSize(e,t){return this.getViewBounds(e,P0,I0),t.subVectors(I0,P0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(qa*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},vf=class extends Ao{constructor(){super(new an(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Rr*2*e.angle*this.focus,s=this.mapSize.width/this.mapSize.height*this.aspect,r=e.distance||t.far;(n!==t.fov||s!==t.aspect||r!==t.far)&&(t.fov=n,t.aspect=s,t.far=r,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},pl=class extends Pr{constructor(e,t,n=0,s=Math.PI/3,r=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy($t.DEFAULT_UP),this.updateMatrix(),this.target=new $t,this.distance=n,this.angle=s,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new vf}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},bf=class extends Ao{constructor(){super(new an(90,1,.5,500)),this.isPointLightShadow=!0}},ml=class extends Pr{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new bf}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Ts=class extends fl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Sf=class extends Ao{constructor(){super(new Ts(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ir=class extends Pr{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy($t.DEFAULT_UP),this.updateMatrix(),this.target=new $t,this.shadow=new Sf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Lr=class{constructor(){this.isSphericalHarmonics3=!0,this.coefficients=[];for(let e=0;e<9;e++)this.coefficients.push(new P)}set(e){for(let t=0;t<9;t++)this.coefficients[t].copy(e[t]);return this}zero(){for(let e=0;e<9;e++)this.coefficients[e].set(0,0,0);return this}getAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.282095),t.addScaledVector(o[1],.488603*s),t.addScaledVector(o[2],.488603*r),t.addScaledVector(o[3],.488603*n),t.addScaledVector(o[4],1.092548*(n*s)),t.addScaledVector(o[5],1.092548*(s*r)),t.addScaledVector(o[6],.315392*(3*r*r-1)),t.addScaledVector(o[7],1.092548*(n*r)),t.addScaledVector(o[8],.546274*(n*n-s*s)),t}getIrradianceAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.886227),t.addScaledVector(o[1],2*.511664*s),t.addScaledVector(o[2],2*.511664*r),t.addScaledVector(o[3],2*.511664*n),t.addScaledVector(o[4],2*.429043*n*s),t.addScaledVector(o[5],2*.429043*s*r),t.addScaledVector(o[6],.743125*r*r-.247708),t.addScaledVector(o[7],2*.429043*n*r),t.addScaledVector(o[8],.429043*(n*n-s*s)),t}add(e){for(let t=0;t<9;t++)this.coefficients[t].add(e.coefficients[t]);return this}addScaledSH(e,t){for(let n=0;n<9;n++)this.coefficients[n].addScaledVector(e.coefficients[n],t);return this}scale(e){for(let t=0;t<9;t++)this.coefficients[t].multiplyScalar(e);return this}lerp(e,t){for(let n=0;n<9;n++)this.coefficients[n].lerp(e.coefficients[n],t);return this}equals(e){for(let t=0;t<9;t++)if(!this.coefficients[t].equals(e.coefficients[t]))return!1;return!0}copy(e){return this.set(e.coefficients)}clone(){return new this.constructor().copy(this)}fromArray(e,t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].fromArray(e,t+s*3);return this}toArray(e=[],t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].toArray(e,t+s*3);return e}static getBasisAt(e,t){let n=e.x,s=e.y,r=e.z;t[0]=.282095,t[1]=.488603*s,t[2]=.488603*r,t[3]=.488603*n,t[4]=1.092548*n*s,t[5]=1.092548*s*r,t[6]=.315392*(3*r*r-1),t[7]=1.092548*n*r,t[8]=.546274*(n*n-s*s)}},gl=class extends Pr{constructor(e=new Lr,t=1){super(void 0,t),this.isLightProbe=!0,this.type="LightProbe",this.sh=e}copy(e){return super.copy(e),this.sh.copy(e.sh),this}toJSON(e){let t=super.toJSON(e);return t.object.sh=this.sh.toArray(),t}};var As=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}},_l=class extends Xt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var uf=new WeakMap,xl=class extends Xi{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&De("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&De("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=Fi.get(`image-bitmap:${e}`);if(o!==void 0){if(r.manager.itemStart(e),o.then){o.then(c=>{uf.has(o)===!0?(s&&s(uf.get(o)),r.manager.itemError(e),r.manager.itemEnd(e)):(t&&t(c),r.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let l=fetch(e,a).then(function(c){return c.blob()}).then(function(c){return createImageBitmap(c,Object.assign({},r.options,{colorSpaceConversion:"none"}))}).then(function(c){return Fi.add(`image-bitmap:${e}`,c),t&&t(c),r.manager.itemEnd(e),c}).catch(function(c){s&&s(c),uf.set(l,c),Fi.remove(`image-bitmap:${e}`),r.manager.itemError(e),r.manager.itemEnd(e)});Fi.add(`image-bitmap:${e}`,l),r.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var co=-90,uo=1,Ro=class extends $t{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new an(co,uo,e,t);s.layers=this.layers,this.add(s);let r=new an(co,uo,e,t);r.layers=this.layers,this.add(r);let o=new an(co,uo,e,t);o.layers=this.layers,this.add(o);let a=new an(co,uo,e,t);a.layers=this.layers,this.add(a);let l=new an(co,uo,e,t);l.layers=this.layers,this.add(l);let c=new an(co,uo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===fi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===_o)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},vu=class extends an{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var np="\\[\\]\\.:\\/",eS=new RegExp("["+np+"]","g"),ip="[^"+np+"]",tS="[^"+np.replace("\\.","")+"]",nS=/((?:WC+[\/:])*)/.source.replace("WC",ip),iS=/(WCOD+)?/.source.replace("WCOD",tS),sS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",ip),rS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",ip),oS=new RegExp("^"+nS+iS+sS+rS+"$"),aS=["material","materials","bones","map"],Mf=class{constructor(e,t,n){let s=n||Ft.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Ft=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(eS,"")}static parseTrackName(e){let t=oS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);aS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){De("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Ge("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Ge("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Ge("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Ge("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Ge("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Ge("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Ge("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Ge("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Ge("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Ge("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ft.Composite=Mf;Ft.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ft.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ft.prototype.GetterByBindingType=[Ft.prototype._getValue_direct,Ft.prototype._getValue_array,Ft.prototype._getValue_arrayElement,Ft.prototype._getValue_toArray];Ft.prototype.SetterByBindingTypeAndVersioning=[[Ft.prototype._setValue_direct,Ft.prototype._setValue_direct_setNeedsUpdate,Ft.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ft.prototype._setValue_array,Ft.prototype._setValue_array_setNeedsUpdate,Ft.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ft.prototype._setValue_arrayElement,Ft.prototype._setValue_arrayElement_setNeedsUpdate,Ft.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ft.prototype._setValue_fromArray,Ft.prototype._setValue_fromArray_setNeedsUpdate,Ft.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var EC=new Float32Array(1);var Ks=class extends Cr{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var L0=new Re,Zs=class{constructor(e,t,n=0,s=1/0){this.ray=new zi(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new bo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Ge("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return L0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(L0),this}intersectObject(e,t=!0,n=[]){return wf(e,this,n,t),n.sort(O0),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)wf(e[s],this,n,t);return n.sort(O0),n}};function O0(i,e){return i.distance-e.distance}function wf(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)wf(r[o],e,t,!0)}}var yl=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Ye(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(Ye(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ef=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var N0=new P,Kc=new P,ho=new P,fo=new P,hf=new P,lS=new P,cS=new P,Sn=class{constructor(e=new P,t=new P){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){N0.subVectors(e,this.start),Kc.subVectors(this.end,this.start);let n=Kc.dot(Kc);if(n===0)return 0;let r=Kc.dot(N0)/n;return t&&(r=Ye(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=lS,n=cS){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;ho.subVectors(c,a),fo.subVectors(u,l),hf.subVectors(a,l);let h=ho.dot(ho),d=fo.dot(fo),f=fo.dot(hf);if(h<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(h<=s)r=0,o=f/d,o=Ye(o,0,1);else{let g=ho.dot(hf);if(d<=s)o=0,r=Ye(-g/h,0,1);else{let y=ho.dot(fo),m=h*d-y*y;m!==0?r=Ye((y*f-g*d)/m,0,1):r=0,o=(y*r+f)/d,o<0?(o=0,r=Ye(-g/h,0,1)):o>1&&(o=1,r=Ye((y-g)/h,0,1))}}return t.copy(a).addScaledVector(ho,r),n.copy(l).addScaledVector(fo,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function sp(i,e,t,n){let s=uS(n);switch(t){case Gf:return i*e;case Ru:return i*e/s.components*s.byteLength;case Sl:return i*e/s.components*s.byteLength;case Js:return i*e*2/s.components*s.byteLength;case Cu:return i*e*2/s.components*s.byteLength;case Wf:return i*e*3/s.components*s.byteLength;case jn:return i*e*4/s.components*s.byteLength;case Pu:return i*e*4/s.components*s.byteLength;case Ml:case wl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case El:case Tl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Lu:case Nu:return Math.max(i,16)*Math.max(e,8)/4;case Iu:case Ou:return Math.max(i,8)*Math.max(e,8)/2;case Du:case Uu:case ku:case Bu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Fu:case Al:case zu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Vu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Hu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Gu:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Wu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Xu:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case qu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Yu:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case $u:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Ku:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Zu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Ju:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ju:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Qu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case eh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case th:case nh:case ih:return Math.ceil(i/4)*Math.ceil(e/4)*16;case sh:case rh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Rl:case oh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function uS(i){switch(i){case ti:case Bf:return{byteLength:1,components:1};case Oo:case zf:case Ei:return{byteLength:2,components:1};case Tu:case Au:return{byteLength:2,components:4};case gi:case Eu:case Gn:return{byteLength:4,components:1};case Vf:case Hf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?De("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function H_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function hS(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],y=h[f];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let y=h[f];i.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var dS=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,fS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,pS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,mS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,gS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,_S=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,xS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,yS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,vS=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,bS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,SS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,MS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,wS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,ES=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,TS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,AS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,RS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,CS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,PS=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,IS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,LS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,OS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,NS=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,DS=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,US=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,FS=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,kS=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,BS=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,zS=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,VS="gl_FragColor = linearToOutputTexel( gl_FragColor );",HS=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,GS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,WS=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,XS=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,qS=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,YS=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,$S=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,KS=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ZS=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,JS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,jS=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,QS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,eM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,tM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,nM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,iM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,sM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,rM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,oM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,aM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,lM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,cM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,uM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,hM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,dM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,fM=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,pM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,mM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,_M=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,xM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,yM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,vM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,bM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,SM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,MM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,wM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,EM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,TM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,AM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,RM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,CM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,PM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,IM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,LM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,NM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,DM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,UM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,FM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,kM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,BM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,zM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,VM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,HM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,GM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,WM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,XM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,qM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,YM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,$M=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,KM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,ZM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,JM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,jM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,QM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ew=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,tw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,nw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,iw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,sw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,rw=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,ow=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,aw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,lw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,cw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,uw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,hw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,dw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,pw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,gw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_w=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,xw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,yw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,vw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,bw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Sw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Mw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ww=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ew=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Tw=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Aw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Rw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Cw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,Pw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Iw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,Lw=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,Ow=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Nw=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Dw=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Uw=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Fw=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,kw=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Bw=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,zw=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Vw=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Hw=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Gw=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Ww=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,it={alphahash_fragment:dS,alphahash_pars_fragment:fS,alphamap_fragment:pS,alphamap_pars_fragment:mS,alphatest_fragment:gS,alphatest_pars_fragment:_S,aomap_fragment:xS,aomap_pars_fragment:yS,batching_pars_vertex:vS,batching_vertex:bS,begin_vertex:SS,beginnormal_vertex:MS,bsdfs:wS,iridescence_fragment:ES,bumpmap_pars_fragment:TS,clipping_planes_fragment:AS,clipping_planes_pars_fragment:RS,clipping_planes_pars_vertex:CS,clipping_planes_vertex:PS,color_fragment:IS,color_pars_fragment:LS,color_pars_vertex:OS,color_vertex:NS,common:DS,defaultnormal_vertex:US,displacementmap_pars_vertex:FS,displacementmap_vertex:kS,emissivemap_fragment:BS,emissivemap_pars_fragment:zS,colorspace_fragment:VS,colorspace_pars_fragment:HS,envmap_fragment:GS,envmap_common_pars_fragment:WS,envmap_pars_fragment:XS,envmap_pars_vertex:qS,envmap_physical_pars_fragment:iM,envmap_vertex:YS,fog_vertex:$S,fog_pars_vertex:KS,fog_fragment:ZS,fog_pars_fragment:JS,gradientmap_pars_fragment:jS,lightmap_pars_fragment:QS,lights_lambert_fragment:eM,lights_lambert_pars_fragment:tM,lights_pars_begin:nM,lights_toon_fragment:sM,lights_toon_pars_fragment:rM,lights_phong_fragment:oM,lights_phong_pars_fragment:aM,lights_physical_fragment:lM,lights_physical_pars_fragment:cM,lights_fragment_begin:uM,lights_fragment_maps:hM,lights_fragment_end:dM,lightprobes_pars_fragment:fM,logdepthbuf_fragment:pM,logdepthbuf_pars_fragment:mM,logdepthbuf_pars_vertex:gM,logdepthbuf_vertex:_M,map_fragment:xM,map_pars_fragment:yM,map_particle_fragment:vM,map_particle_pars_fragment:bM,metalnessmap_fragment:SM,metalnessmap_pars_fragment:MM,morphinstance_vertex:wM,morphcolor_vertex:EM,morphnormal_vertex:TM,morphtarget_pars_vertex:AM,morphtarget_vertex:RM,normal_fragment_begin:CM,normal_fragment_maps:PM,normal_pars_fragment:IM,normal_pars_vertex:LM,normal_vertex:OM,normalmap_pars_fragment:NM,clearcoat_normal_fragment_begin:DM,clearcoat_normal_fragment_maps:UM,clearcoat_pars_fragment:FM,iridescence_pars_fragment:kM,opaque_fragment:BM,packing:zM,premultiplied_alpha_fragment:VM,project_vertex:HM,dithering_fragment:GM,dithering_pars_fragment:WM,roughnessmap_fragment:XM,roughnessmap_pars_fragment:qM,shadowmap_pars_fragment:YM,shadowmap_pars_vertex:$M,shadowmap_vertex:KM,shadowmask_pars_fragment:ZM,skinbase_vertex:JM,skinning_pars_vertex:jM,skinning_vertex:QM,skinnormal_vertex:ew,specularmap_fragment:tw,specularmap_pars_fragment:nw,tonemapping_fragment:iw,tonemapping_pars_fragment:sw,transmission_fragment:rw,transmission_pars_fragment:ow,uv_pars_fragment:aw,uv_pars_vertex:lw,uv_vertex:cw,worldpos_vertex:uw,background_vert:hw,background_frag:dw,backgroundCube_vert:fw,backgroundCube_frag:pw,cube_vert:mw,cube_frag:gw,depth_vert:_w,depth_frag:xw,distance_vert:yw,distance_frag:vw,equirect_vert:bw,equirect_frag:Sw,linedashed_vert:Mw,linedashed_frag:ww,meshbasic_vert:Ew,meshbasic_frag:Tw,meshlambert_vert:Aw,meshlambert_frag:Rw,meshmatcap_vert:Cw,meshmatcap_frag:Pw,meshnormal_vert:Iw,meshnormal_frag:Lw,meshphong_vert:Ow,meshphong_frag:Nw,meshphysical_vert:Dw,meshphysical_frag:Uw,meshtoon_vert:Fw,meshtoon_frag:kw,points_vert:Bw,points_frag:zw,shadow_vert:Vw,shadow_frag:Hw,sprite_vert:Gw,sprite_frag:Ww},be={common:{diffuse:{value:new Ne(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new qe},alphaMap:{value:null},alphaMapTransform:{value:new qe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new qe}},envmap:{envMap:{value:null},envMapRotation:{value:new qe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new qe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new qe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new qe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new qe},normalScale:{value:new Ue(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new qe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new qe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new qe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new qe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ne(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ne(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new qe},alphaTest:{value:0},uvTransform:{value:new qe}},sprite:{diffuse:{value:new Ne(16777215)},opacity:{value:1},center:{value:new Ue(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new qe},alphaMap:{value:null},alphaMapTransform:{value:new qe},alphaTest:{value:0}}},$n={basic:{uniforms:kn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.fog]),vertexShader:it.meshbasic_vert,fragmentShader:it.meshbasic_frag},lambert:{uniforms:kn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new Ne(0)},envMapIntensity:{value:1}}]),vertexShader:it.meshlambert_vert,fragmentShader:it.meshlambert_frag},phong:{uniforms:kn([be.common,be.specularmap,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.fog,be.lights,{emissive:{value:new Ne(0)},specular:{value:new Ne(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:it.meshphong_vert,fragmentShader:it.meshphong_frag},standard:{uniforms:kn([be.common,be.envmap,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.roughnessmap,be.metalnessmap,be.fog,be.lights,{emissive:{value:new Ne(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag},toon:{uniforms:kn([be.common,be.aomap,be.lightmap,be.emissivemap,be.bumpmap,be.normalmap,be.displacementmap,be.gradientmap,be.fog,be.lights,{emissive:{value:new Ne(0)}}]),vertexShader:it.meshtoon_vert,fragmentShader:it.meshtoon_frag},matcap:{uniforms:kn([be.common,be.bumpmap,be.normalmap,be.displacementmap,be.fog,{matcap:{value:null}}]),vertexShader:it.meshmatcap_vert,fragmentShader:it.meshmatcap_frag},points:{uniforms:kn([be.points,be.fog]),vertexShader:it.points_vert,fragmentShader:it.points_frag},dashed:{uniforms:kn([be.common,be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:it.linedashed_vert,fragmentShader:it.linedashed_frag},depth:{uniforms:kn([be.common,be.displacementmap]),vertexShader:it.depth_vert,fragmentShader:it.depth_frag},normal:{uniforms:kn([be.common,be.bumpmap,be.normalmap,be.displacementmap,{opacity:{value:1}}]),vertexShader:it.meshnormal_vert,fragmentShader:it.meshnormal_frag},sprite:{uniforms:kn([be.sprite,be.fog]),vertexShader:it.sprite_vert,fragmentShader:it.sprite_frag},background:{uniforms:{uvTransform:{value:new qe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:it.background_vert,fragmentShader:it.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new qe}},vertexShader:it.backgroundCube_vert,fragmentShader:it.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:it.cube_vert,fragmentShader:it.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:it.equirect_vert,fragmentShader:it.equirect_frag},distance:{uniforms:kn([be.common,be.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:it.distance_vert,fragmentShader:it.distance_frag},shadow:{uniforms:kn([be.lights,be.fog,{color:{value:new Ne(0)},opacity:{value:1}}]),vertexShader:it.shadow_vert,fragmentShader:it.shadow_frag}};$n.physical={uniforms:kn([$n.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new qe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new qe},clearcoatNormalScale:{value:new Ue(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new qe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new qe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new qe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new qe},sheen:{value:0},sheenColor:{value:new Ne(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new qe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new qe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new qe},transmissionSamplerSize:{value:new Ue},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new qe},attenuationDistance:{value:0},attenuationColor:{value:new Ne(0)},specularColor:{value:new Ne(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new qe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new qe},anisotropyVector:{value:new Ue},anisotropyMap:{value:null},anisotropyMapTransform:{value:new qe}}]),vertexShader:it.meshphysical_vert,fragmentShader:it.meshphysical_frag};var lh={r:0,b:0,g:0},Xw=new Re,G_=new qe;G_.set(-1,0,0,0,1,0,0,0,1);function qw(i,e,t,n,s,r){let o=new Ne(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let b=v.backgroundBlurriness>0;M=e.get(M,b)}return M}function g(v){let M=!1,b=f(v);b===null?m(o,a):b&&b.isColor&&(m(b,1),M=!0);let w=i.xr.getEnvironmentBlendMode();w==="additive"?t.buffers.color.setClear(0,0,0,1,r):w==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,M){let b=f(M);b&&b.isCubeTexture?(c===void 0&&(c=new Tt(new Eo(1,1,1),new un({name:"BackgroundCubeMaterial",uniforms:Fr($n.backgroundCube.uniforms),vertexShader:$n.backgroundCube.vertexShader,fragmentShader:$n.backgroundCube.fragmentShader,side:Mn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(w,x,p){this.matrixWorld.copyPosition(p.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Xw.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(G_),c.material.toneMapped=nt.getTransfer(b.colorSpace)!==Et,(u!==b||h!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Tt(new Gi(2,2),new un({name:"BackgroundMaterial",uniforms:Fr($n.background.uniforms),vertexShader:$n.background.vertexShader,fragmentShader:$n.background.fragmentShader,side:oi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=nt.getTransfer(b.colorSpace)!==Et,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,M){v.getRGB(lh,tp(i)),t.buffers.color.setClear(lh.r,lh.g,lh.b,M,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:y,dispose:_}}function Yw(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(C,I,D,L,U){let V=!1,B=h(C,L,D,I);r!==B&&(r=B,c(r.object)),V=f(C,L,D,U),V&&g(C,L,D,U),U!==null&&e.update(U,i.ELEMENT_ARRAY_BUFFER),(V||o)&&(o=!1,b(C,I,D,L),U!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(U).buffer))}function l(){return i.createVertexArray()}function c(C){return i.bindVertexArray(C)}function u(C){return i.deleteVertexArray(C)}function h(C,I,D,L){let U=L.wireframe===!0,V=n[I.id];V===void 0&&(V={},n[I.id]=V);let B=C.isInstancedMesh===!0?C.id:0,ne=V[B];ne===void 0&&(ne={},V[B]=ne);let z=ne[D.id];z===void 0&&(z={},ne[D.id]=z);let q=z[U];return q===void 0&&(q=d(l()),z[U]=q),q}function d(C){let I=[],D=[],L=[];for(let U=0;U<t;U++)I[U]=0,D[U]=0,L[U]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:I,enabledAttributes:D,attributeDivisors:L,object:C,attributes:{},index:null}}function f(C,I,D,L){let U=r.attributes,V=I.attributes,B=0,ne=D.getAttributes();for(let z in ne)if(ne[z].location>=0){let W=U[z],ge=V[z];if(ge===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(ge=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(ge=C.instanceColor)),W===void 0||W.attribute!==ge||ge&&W.data!==ge.data)return!0;B++}return r.attributesNum!==B||r.index!==L}function g(C,I,D,L){let U={},V=I.attributes,B=0,ne=D.getAttributes();for(let z in ne)if(ne[z].location>=0){let W=V[z];W===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(W=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(W=C.instanceColor));let ge={};ge.attribute=W,W&&W.data&&(ge.data=W.data),U[z]=ge,B++}r.attributes=U,r.attributesNum=B,r.index=L}function y(){let C=r.newAttributes;for(let I=0,D=C.length;I<D;I++)C[I]=0}function m(C){_(C,0)}function _(C,I){let D=r.newAttributes,L=r.enabledAttributes,U=r.attributeDivisors;D[C]=1,L[C]===0&&(i.enableVertexAttribArray(C),L[C]=1),U[C]!==I&&(i.vertexAttribDivisor(C,I),U[C]=I)}function v(){let C=r.newAttributes,I=r.enabledAttributes;for(let D=0,L=I.length;D<L;D++)I[D]!==C[D]&&(i.disableVertexAttribArray(D),I[D]=0)}function M(C,I,D,L,U,V,B){B===!0?i.vertexAttribIPointer(C,I,D,U,V):i.vertexAttribPointer(C,I,D,L,U,V)}function b(C,I,D,L){y();let U=L.attributes,V=D.getAttributes(),B=I.defaultAttributeValues;for(let ne in V){let z=V[ne];if(z.location>=0){let q=U[ne];if(q===void 0&&(ne==="instanceMatrix"&&C.instanceMatrix&&(q=C.instanceMatrix),ne==="instanceColor"&&C.instanceColor&&(q=C.instanceColor)),q!==void 0){let W=q.normalized,ge=q.itemSize,Ee=e.get(q);if(Ee===void 0)continue;let $=Ee.buffer,ae=Ee.type,se=Ee.bytesPerElement,ce=ae===i.INT||ae===i.UNSIGNED_INT||q.gpuType===Eu;if(q.isInterleavedBufferAttribute){let re=q.data,he=re.isInterleavedBuffer===!0?re.stride:re.itemSize,We=q.offset;if(re.isInstancedInterleavedBuffer||re.isInstancedBufferAttribute){for(let Te=0;Te<z.locationSize;Te++)_(z.location+Te,re.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let Te=0;Te<z.locationSize;Te++)m(z.location+Te);i.bindBuffer(i.ARRAY_BUFFER,$);for(let Te=0;Te<z.locationSize;Te++)M(z.location+Te,ge/z.locationSize,ae,W,he*se,(We+ge/z.locationSize*Te)*se,ce)}else{if(q.isInstancedBufferAttribute){for(let re=0;re<z.locationSize;re++)_(z.location+re,q.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=q.meshPerAttribute*q.count)}else for(let re=0;re<z.locationSize;re++)m(z.location+re);i.bindBuffer(i.ARRAY_BUFFER,$);for(let re=0;re<z.locationSize;re++)M(z.location+re,ge/z.locationSize,ae,W,ge*se,ge/z.locationSize*re*se,ce)}}else if(B!==void 0){let W=B[ne];if(W!==void 0)switch(W.length){case 2:i.vertexAttrib2fv(z.location,W);break;case 3:i.vertexAttrib3fv(z.location,W);break;case 4:i.vertexAttrib4fv(z.location,W);break;default:i.vertexAttrib1fv(z.location,W)}}}}v()}function w(){A();for(let C in n){let I=n[C];for(let D in I){let L=I[D];for(let U in L){let V=L[U];for(let B in V)u(V[B].object),delete V[B];delete L[U]}}delete n[C]}}function x(C){if(n[C.id]===void 0)return;let I=n[C.id];for(let D in I){let L=I[D];for(let U in L){let V=L[U];for(let B in V)u(V[B].object),delete V[B];delete L[U]}}delete n[C.id]}function p(C){for(let I in n){let D=n[I];for(let L in D){let U=D[L];if(U[C.id]===void 0)continue;let V=U[C.id];for(let B in V)u(V[B].object),delete V[B];delete U[C.id]}}}function S(C){for(let I in n){let D=n[I],L=C.isInstancedMesh===!0?C.id:0,U=D[L];if(U!==void 0){for(let V in U){let B=U[V];for(let ne in B)u(B[ne].object),delete B[ne];delete U[V]}delete D[L],Object.keys(D).length===0&&delete n[I]}}}function A(){E(),o=!0,r!==s&&(r=s,c(r.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:A,resetDefaultState:E,dispose:w,releaseStatesOfGeometry:x,releaseStatesOfObject:S,releaseStatesOfProgram:p,initAttributes:y,enableAttribute:m,disableUnusedAttributes:v}}function $w(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Kw(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let p=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(p.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(p){return!(p!==jn&&n.convert(p)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(p){let S=p===Ei&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(p!==ti&&p!==Gn&&!S&&n.convert(p)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(p){if(p==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";p="mediump"}return p==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(De("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&De("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&De("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),w=i.getParameter(i.MAX_SAMPLES),x=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:m,maxAttributes:_,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:b,maxSamples:w,samples:x}}function Zw(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Hn,a=new qe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,y=h.clipIntersection,m=h.clipShadows,_=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let v=r?0:n,M=v*4,b=_.clippingState||null;l.value=b,b=u(g,d,M,f);for(let w=0;w!==M;++w)b[w]=t[w];_.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,g){let y=h!==null?h.length:0,m=null;if(y!==0){if(m=l.value,g!==!0||m===null){let _=f+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<_)&&(m=new Float32Array(_));for(let M=0,b=f;M!==y;++M,b+=4)o.copy(h[M]).applyMatrix4(v,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,m}}var Nl=class extends Fn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new rl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Eo(5,5,5),r=new un({name:"CubemapFromEquirect",uniforms:Fr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Mn,blending:qi});r.uniforms.tEquirect.value=t;let o=new Tt(s,r),a=t.minFilter;return t.minFilter===mi&&(t.minFilter=cn),new Ro(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},b_=256,Jw=3,jw=20,W_=256,X_=16,Qw=3,eE=new P,tE=new Ne,uh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ro(1,10,null),this._boxMesh=new Tt(new Eo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=eE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(tE));let m=new Ro(n,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=w_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=M_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(b_,jf(e))}_fromTexture(e,t){e.mapping===Nr||e.mapping===Io?this._setSize(e.image.length===0?b_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=S_(e,!1,!1),n=Math.log2(e)-Jw;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=S_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Nr||e.mapping===Io?(this._cubemapMaterial===null&&(this._cubemapMaterial=w_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=M_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=nE(),this._integrationMaterial=iE());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/X_);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Qw)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(W_*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=sE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function S_(i,e,t){return new Nl(i,{minFilter:mi,generateMipmaps:e,type:Ei,colorSpace:Wn,depthBuffer:t})}function Dl(i,e,t){return new un({name:i,uniforms:e,vertexShader:it.cube_vert,fragmentShader:t,side:Mn,blending:qi,depthTest:!1,depthWrite:!1})}function nE(){return Dl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${W_}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function iE(){return Dl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:X_}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function sE(){return Dl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${jw}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function M_(){return Dl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function w_(){return Dl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function rE(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Su||f===Mu)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Nl(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Su||f===Mu,y=f===Nr||f===Io;if(g||y){let m=t.get(d),_=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==_)return n===null&&(n=new uh(i)),m=g?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return g&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new uh(i)),m=g?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===Su?d.mapping=Nr:f===Mu&&(d.mapping=Io),d}function l(d){let f=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function oE(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Er("WebGLRenderer: "+n+" extension not supported."),s}}}function aE(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(g){let y=g.attributes;for(let m in y)e.update(y[m],i.ARRAY_BUFFER)}function h(g){let y=g.index,m=g.attributes.position,_=0;if(m===void 0)return;let v=y!==null?y.array.length:m.array.length/3-1,M=m.count>=65535?Qa:ja,b=new M(Math.ceil(v/3)*6,1),w=b.array;if(y!==null){let p=y.array;_=y.version;for(let S=0,A=0;S<v;S+=3){let E=p[S+0],C=p[S+1],I=p[S+2];w[A++]=E,w[A++]=C,w[A++]=C,w[A++]=I,w[A++]=I,w[A++]=E}}else{_=m.version;for(let p=0,S=0;p<v;p+=3){let A=p+0,E=p+1,C=p+2;w[S++]=A,w[S++]=E,w[S++]=E,w[S++]=C,w[S++]=C,w[S++]=A}}b.version=_;let x=r.get(g);x&&e.remove(x),r.set(g,b)}function d(g){let y=r.get(g);if(y){let m=g.index;m!==null&&y.version<m.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function lE(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){i.drawElements(n,d,r,h*o),t.update(d,n,1)}function c(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),t.update(d,n,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let y=0;for(let m=0;m<f;m++)y+=d[m];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function cE(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Ge("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function uE(i,e,t){let n=new WeakMap,s=new ot;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let A=function(){p.dispose(),n.delete(a),a.removeEventListener("dispose",A)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],M=0;f===!0&&(M=1),g===!0&&(M=2),y===!0&&(M=3);let b=a.attributes.position.count*M,w=1;b>e.maxTextureSize&&(w=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let x=new Float32Array(b*w*4*h),p=new Za(x,b,w,h);p.type=Gn,p.needsUpdate=!0;let S=M*4;for(let E=0;E<h;E++){let C=m[E],I=_[E],D=v[E],L=b*w*4*E;for(let U=0;U<C.count;U++){let V=U*S;f===!0&&(s.fromBufferAttribute(C,U),x[L+V+0]=s.x,x[L+V+1]=s.y,x[L+V+2]=s.z,x[L+V+3]=0),g===!0&&(s.fromBufferAttribute(I,U),x[L+V+4]=s.x,x[L+V+5]=s.y,x[L+V+6]=s.z,x[L+V+7]=0),y===!0&&(s.fromBufferAttribute(D,U),x[L+V+8]=s.x,x[L+V+9]=s.y,x[L+V+10]=s.z,x[L+V+11]=D.itemSize===4?s.w:1)}}d={count:h,texture:p,size:new Ue(b,w)},n.set(a,d),a.addEventListener("dispose",A)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function hE(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var dE={[Lf]:"LINEAR_TONE_MAPPING",[Of]:"REINHARD_TONE_MAPPING",[Nf]:"CINEON_TONE_MAPPING",[Df]:"ACES_FILMIC_TONE_MAPPING",[Ff]:"AGX_TONE_MAPPING",[bl]:"NEUTRAL_TONE_MAPPING",[Uf]:"CUSTOM_TONE_MAPPING"};function fE(i,e,t,n,s,r){let o=new Fn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Xt;u.setAttribute("position",new ln([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ln([0,2,0,0,2,0],2));let h=new uu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Tt(u,h),f=new Ts(-1,1,1,-1,0,1),g=null,y=null,m=!1,_,v=null,M=[],b=!1;this.setSize=function(w,x){o.setSize(w,x),a!==null&&a.setSize(w,x),l!==null&&l.setSize(w,x);for(let p=0;p<M.length;p++){let S=M[p];S.setSize&&S.setSize(w,x)}},this.setEffects=function(w){M=w,b=M.length>0&&M[0].isRenderPass===!0;let x=o.width,p=o.height;M.length>0&&a===null&&(a=new Fn(x,p,{type:Ei,depthBuffer:!1,stencilBuffer:!1}),l=new Fn(x,p,{type:Ei,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&M.some(A=>A.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new vs(x,p),r===!0&&(c.format=Rs,c.type=Ur)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let A=0;A<M.length;A++){let E=M[A];E.setSize&&E.setSize(x,p),S&&E.needsDepthTexture===!0&&E.setDepthTexture&&E.setDepthTexture(c)}},this.begin=function(w,x){if(m||w.toneMapping===Yi&&M.length===0)return!1;if(v=x,x!==null){let p=x.width,S=x.height;(o.width!==p||o.height!==S)&&this.setSize(p,S)}return b===!1&&w.setRenderTarget(o),_=w.toneMapping,w.toneMapping=Yi,!0},this.hasRenderPass=function(){return b},this.end=function(w,x){w.toneMapping=_,m=!0;let p=o,S=a;for(let A=0;A<M.length;A++){let E=M[A];E.enabled!==!1&&(E.render(w,S,p,x),E.needsSwap!==!1&&(p=S,S=S===a?l:a))}if(g!==w.outputColorSpace||y!==w.toneMapping){g=w.outputColorSpace,y=w.toneMapping,h.defines={},nt.getTransfer(g)===Et&&(h.defines.SRGB_TRANSFER="");let A=dE[y];A&&(h.defines[A]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=p.texture,w.setRenderTarget(v),w.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var q_=new yn,Y_=new vs(1,1),$_=new ol(1),K_=new Za,Z_=new au,J_=new rl,E_=[],T_=[],A_=new Float32Array(16),R_=new Float32Array(9),C_=new Float32Array(4);function ko(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=E_[s];if(r===void 0&&(r=new Float32Array(s),E_[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function hn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function dn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function dh(i,e){let t=T_[e];t===void 0&&(t=new Int32Array(e),T_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function pE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function mE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(hn(t,e))return;i.uniform2fv(this.addr,e),dn(t,e)}}function gE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(hn(t,e))return;i.uniform3fv(this.addr,e),dn(t,e)}}function _E(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(hn(t,e))return;i.uniform4fv(this.addr,e),dn(t,e)}}function xE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(hn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),dn(t,e)}else{if(hn(t,n))return;C_.set(n),i.uniformMatrix2fv(this.addr,!1,C_),dn(t,n)}}function yE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(hn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),dn(t,e)}else{if(hn(t,n))return;R_.set(n),i.uniformMatrix3fv(this.addr,!1,R_),dn(t,n)}}function vE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(hn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),dn(t,e)}else{if(hn(t,n))return;A_.set(n),i.uniformMatrix4fv(this.addr,!1,A_),dn(t,n)}}function bE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function SE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(hn(t,e))return;i.uniform2iv(this.addr,e),dn(t,e)}}function ME(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(hn(t,e))return;i.uniform3iv(this.addr,e),dn(t,e)}}function wE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(hn(t,e))return;i.uniform4iv(this.addr,e),dn(t,e)}}function EE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function TE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(hn(t,e))return;i.uniform2uiv(this.addr,e),dn(t,e)}}function AE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(hn(t,e))return;i.uniform3uiv(this.addr,e),dn(t,e)}}function RE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(hn(t,e))return;i.uniform4uiv(this.addr,e),dn(t,e)}}function fh(i){return i.version===0&&(i.compareFunction=$f,i.needsUpdate=!0),i}function CE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=fh(Y_):r=q_,t.setTexture2D(e||r,s)}function PE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Z_,s)}function IE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=fh($_):r=J_,t.setTextureCube(e||r,s)}function LE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||K_,s)}function OE(i){switch(i){case 5126:return pE;case 35664:return mE;case 35665:return gE;case 35666:return _E;case 35674:return xE;case 35675:return yE;case 35676:return vE;case 5124:case 35670:return bE;case 35667:case 35671:return SE;case 35668:case 35672:return ME;case 35669:case 35673:return wE;case 5125:return EE;case 36294:return TE;case 36295:return AE;case 36296:return RE;case 35678:case 36198:case 36298:case 36306:case 35682:return CE;case 35679:case 36299:case 36307:return PE;case 35680:case 36300:case 36308:case 36293:return IE;case 36289:case 36303:case 36311:case 36292:return LE}}function NE(i,e){i.uniform1fv(this.addr,e)}function DE(i,e){let t=ko(e,this.size,2);i.uniform2fv(this.addr,t)}function UE(i,e){let t=ko(e,this.size,3);i.uniform3fv(this.addr,t)}function FE(i,e){let t=ko(e,this.size,4);i.uniform4fv(this.addr,t)}function kE(i,e){let t=ko(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function BE(i,e){let t=ko(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function zE(i,e){let t=ko(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function VE(i,e){i.uniform1iv(this.addr,e)}function HE(i,e){i.uniform2iv(this.addr,e)}function GE(i,e){i.uniform3iv(this.addr,e)}function WE(i,e){i.uniform4iv(this.addr,e)}function XE(i,e){i.uniform1uiv(this.addr,e)}function qE(i,e){i.uniform2uiv(this.addr,e)}function YE(i,e){i.uniform3uiv(this.addr,e)}function $E(i,e){i.uniform4uiv(this.addr,e)}function KE(i,e,t){let n=this.cache,s=e.length,r=dh(t,s);hn(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=fh(Y_):o=q_;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function ZE(i,e,t){let n=this.cache,s=e.length,r=dh(t,s);hn(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Z_,r[o])}function JE(i,e,t){let n=this.cache,s=e.length,r=dh(t,s);hn(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=fh($_):o=J_;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function jE(i,e,t){let n=this.cache,s=e.length,r=dh(t,s);hn(n,r)||(i.uniform1iv(this.addr,r),dn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||K_,r[o])}function QE(i){switch(i){case 5126:return NE;case 35664:return DE;case 35665:return UE;case 35666:return FE;case 35674:return kE;case 35675:return BE;case 35676:return zE;case 5124:case 35670:return VE;case 35667:case 35671:return HE;case 35668:case 35672:return GE;case 35669:case 35673:return WE;case 5125:return XE;case 36294:return qE;case 36295:return YE;case 36296:return $E;case 35678:case 36198:case 36298:case 36306:case 35682:return KE;case 35679:case 36299:case 36307:return ZE;case 35680:case 36300:case 36308:case 36293:return JE;case 36289:case 36303:case 36311:case 36292:return jE}}var ap=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=OE(t.type)}},lp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=QE(t.type)}},cp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},rp=/(\w+)(\])?(\[|\.)?/g;function P_(i,e){i.seq.push(e),i.map[e.id]=e}function eT(i,e,t){let n=i.name,s=n.length;for(rp.lastIndex=0;;){let r=rp.exec(n),o=rp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){P_(t,c===void 0?new ap(a,i,e):new lp(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new cp(a),P_(t,h)),t=h}}}var Uo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);eT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function I_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var tT=37297,nT=0;function iT(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var L_=new qe;function sT(i){nt._getMatrix(L_,nt.workingColorSpace,i);let e=`mat3( ${L_.elements.map(t=>t.toFixed(4))} )`;switch(nt.getTransfer(i)){case $a:return[e,"LinearTransferOETF"];case Et:return[e,"sRGBTransferOETF"];default:return De("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function O_(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+iT(i.getShaderSource(e),a)}else return r}function rT(i,e){let t=sT(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var oT={[Lf]:"Linear",[Of]:"Reinhard",[Nf]:"Cineon",[Df]:"ACESFilmic",[Ff]:"AgX",[bl]:"Neutral",[Uf]:"Custom"};function aT(i,e){let t=oT[e];return t===void 0?(De("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ch=new P;function lT(){nt.getLuminanceCoefficients(ch);let i=ch.x.toFixed(4),e=ch.y.toFixed(4),t=ch.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function cT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ol).join(`
`)}function uT(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function hT(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ol(i){return i!==""}function N_(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function D_(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var dT=/^[ \t]*#include +<([\w\d./]+)>/gm;function up(i){return i.replace(dT,fT)}function fT(i,e){let t=it[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return up(t)}var pT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function U_(i){return i.replace(pT,mT)}function mT(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function F_(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var gT={[vl]:"SHADOWMAP_TYPE_PCF",[Co]:"SHADOWMAP_TYPE_VSM"};function _T(i){return gT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var xT={[Io]:"ENVMAP_MODE_REFRACTION"};function yT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":xT[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var vT={[bu]:"ENVMAP_BLENDING_MULTIPLY",[n_]:"ENVMAP_BLENDING_MIX",[i_]:"ENVMAP_BLENDING_ADD"};function bT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":vT[i.combine]||"ENVMAP_BLENDING_NONE"}function ST(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=_T(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=yT(t),h=bT(t),d=cT(t),f=uT(r),g=s.createProgram(),y,m,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ol).join(`
`),y.length>0&&(y+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ol).join(`
`),m.length>0&&(m+=`
`)):(y=[F_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ol).join(`
`),m=[F_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Yi?"#define TONE_MAPPING":"",t.toneMapping!==Yi?it.tonemapping_pars_fragment:"",t.toneMapping!==Yi?aT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",it.colorspace_pars_fragment,rT("linearToOutputTexel",t.outputColorSpace),lT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ol).join(`
`)),o=up(o),o=N_(o,t),o=D_(o,t),a=up(a),a=N_(a,t),a=D_(a,t),o=U_(o),a=U_(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,m=["#define varying in",t.glslVersion===Zf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Zf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=_+y+o,M=_+m+a,b=I_(s,s.VERTEX_SHADER,v),w=I_(s,s.FRAGMENT_SHADER,M);s.attachShader(g,b),s.attachShader(g,w),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function x(E){if(i.debug.checkShaderErrors){let C=s.getProgramInfoLog(g)||"",I=s.getShaderInfoLog(b)||"",D=s.getShaderInfoLog(w)||"",L=C.trim(),U=I.trim(),V=D.trim(),B=!0,ne=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,w);else{let z=O_(s,b,"vertex"),q=O_(s,w,"fragment");Ge("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+E.name+`
Material Type: `+E.type+`

Program Info Log: `+L+`
`+z+`
`+q)}else L!==""?De("WebGLProgram: Program Info Log:",L):(U===""||V==="")&&(ne=!1);ne&&(E.diagnostics={runnable:B,programLog:L,vertexShader:{log:U,prefix:y},fragmentShader:{log:V,prefix:m}})}s.deleteShader(b),s.deleteShader(w),p=new Uo(s,g),S=hT(s,g)}let p;this.getUniforms=function(){return p===void 0&&x(this),p};let S;this.getAttributes=function(){return S===void 0&&x(this),S};let A=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return A===!1&&(A=s.getProgramParameter(g,tT)),A},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=nT++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=w,this}var MT=0,hp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new dp(e),t.set(e,n)),n}},dp=class{constructor(e){this.id=MT++,this.code=e,this.usedTimes=0}};function wT(i){return i===Js||i===Al||i===Rl}function ET(i,e,t,n,s,r){let o=new bo,a=new hp,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(p){return l.add(p),p===0?"uv":`uv${p}`}function g(p,S,A,E,C,I){let D=E.fog,L=C.geometry,U=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?E.environment:null,V=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap,B=e.get(p.envMap||U,V),ne=d[p.type],z=n.precision;p.precision!==null&&(z=n.getMaxPrecision(p.precision),z!==p.precision&&De("WebGLProgram.getParameters:",p.precision,"not supported, using",z,"instead."));let q=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,W=q!==void 0?q.length:0,ge=0;L.morphAttributes.position!==void 0&&(ge=1),L.morphAttributes.normal!==void 0&&(ge=2),L.morphAttributes.color!==void 0&&(ge=3);let Ee,$,ae,se;if(ne){let Me=$n[ne];Ee=Me.vertexShader,$=Me.fragmentShader}else{Ee=p.vertexShader,$=p.fragmentShader;let Me=a.getVertexShaderStage(p),It=a.getFragmentShaderStage(p);a.update(p,Me,It),ae=Me.id,se=It.id}let ce=i.getRenderTarget(),re=i.state.buffers.depth.getReversed(),he=C.isInstancedMesh===!0,We=C.isBatchedMesh===!0,Te=!!p.map,ke=!!p.matcap,Ie=!!B,Se=Ie&&B.isPMREMTexture===!0,dt=!!p.aoMap,ze=!!p.lightMap,st=!!p.bumpMap&&p.wireframe===!1,Ze=!!p.normalMap,vn=!!p.displacementMap,Pt=!!p.emissiveMap,pn=!!p.metalnessMap,wt=!!p.roughnessMap,qt=p.anisotropy>0,k=p.clearcoat>0,Nt=p.diffuseRoughness>0,ft=p.dispersion>0,Lt=p.retroreflectivity>0,xe=p.iridescence>0,Vt=p.sheen>0,Le=p.transmission>0,Ve=qt&&!!p.anisotropyMap,O=k&&!!p.clearcoatMap,T=k&&!!p.clearcoatNormalMap,G=k&&!!p.clearcoatRoughnessMap,oe=Nt&&!!p.diffuseRoughnessMap,te=xe&&!!p.iridescenceMap,de=xe&&!!p.iridescenceThicknessMap,ye=Vt&&!!p.sheenColorMap,j=Vt&&!!p.sheenRoughnessMap,Q=!!p.specularMap,pe=!!p.specularColorMap,N=!!p.specularIntensityMap,ee=Le&&!!p.transmissionMap,Z=Le&&!!p.thicknessMap,me=!!p.gradientMap,ue=!!p.alphaMap,fe=p.alphaTest>0,Fe=!!p.alphaHash,tt=!!p.extensions,le=Yi;p.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(le=i.toneMapping);let Be=Se?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,Je={shaderID:ne,shaderType:p.type,shaderName:p.name,vertexShader:Ee,fragmentShader:$,defines:p.defines,customVertexShaderID:ae,customFragmentShaderID:se,isRawShaderMaterial:p.isRawShaderMaterial===!0,glslVersion:p.glslVersion,precision:z,batching:We,batchingColor:We&&C._colorsTexture!==null,instancing:he,instancingColor:he&&C.instanceColor!==null,instancingMorph:he&&C.morphTexture!==null,outputColorSpace:ce===null?i.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:nt.workingColorSpace,alphaToCoverage:!!p.alphaToCoverage,map:Te,matcap:ke,envMap:Ie,envMapMode:Ie&&B.mapping,envMapPMREM:Se,envMapMaxLod:Se?Be.length-1:null,envMapSize:Se?Be[0].width:null,aoMap:dt,lightMap:ze,bumpMap:st,normalMap:Ze,displacementMap:vn,emissiveMap:Pt,normalMapObjectSpace:Ze&&p.normalMapType===a_,normalMapTangentSpace:Ze&&p.normalMapType===Pl,packedNormalMap:Ze&&p.normalMapType===Pl&&wT(p.normalMap.format),metalnessMap:pn,roughnessMap:wt,anisotropy:qt,anisotropyMap:Ve,clearcoat:k,clearcoatMap:O,clearcoatNormalMap:T,clearcoatRoughnessMap:G,diffuseRoughness:Nt,diffuseRoughnessMap:oe,dispersion:ft,retroreflection:Lt,iridescence:xe,iridescenceMap:te,iridescenceThicknessMap:de,sheen:Vt,sheenColorMap:ye,sheenRoughnessMap:j,specularMap:Q,specularColorMap:pe,specularIntensityMap:N,transmission:Le,transmissionMap:ee,thicknessMap:Z,gradientMap:me,opaque:p.transparent===!1&&p.blending===Po&&p.alphaToCoverage===!1,alphaMap:ue,alphaTest:fe,alphaHash:Fe,combine:p.combine,mapUv:Te&&f(p.map.channel),aoMapUv:dt&&f(p.aoMap.channel),lightMapUv:ze&&f(p.lightMap.channel),bumpMapUv:st&&f(p.bumpMap.channel),normalMapUv:Ze&&f(p.normalMap.channel),displacementMapUv:vn&&f(p.displacementMap.channel),emissiveMapUv:Pt&&f(p.emissiveMap.channel),metalnessMapUv:pn&&f(p.metalnessMap.channel),roughnessMapUv:wt&&f(p.roughnessMap.channel),anisotropyMapUv:Ve&&f(p.anisotropyMap.channel),clearcoatMapUv:O&&f(p.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(p.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:G&&f(p.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:oe&&f(p.diffuseRoughnessMap.channel),iridescenceMapUv:te&&f(p.iridescenceMap.channel),iridescenceThicknessMapUv:de&&f(p.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&f(p.sheenColorMap.channel),sheenRoughnessMapUv:j&&f(p.sheenRoughnessMap.channel),specularMapUv:Q&&f(p.specularMap.channel),specularColorMapUv:pe&&f(p.specularColorMap.channel),specularIntensityMapUv:N&&f(p.specularIntensityMap.channel),transmissionMapUv:ee&&f(p.transmissionMap.channel),thicknessMapUv:Z&&f(p.thicknessMap.channel),alphaMapUv:ue&&f(p.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Ze||qt),vertexNormals:!!L.attributes.normal,vertexColors:p.vertexColors,vertexAlphas:p.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!L.attributes.uv&&(Te||ue),fog:!!D,useFog:p.fog===!0,fogExp2:!!D&&D.isFogExp2,flatShading:p.wireframe===!1&&(p.flatShading===!0||L.attributes.normal===void 0&&Ze===!1&&(p.isMeshLambertMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isMeshPhysicalMaterial)),sizeAttenuation:p.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:re,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:W,morphTextureStride:ge,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:I.filter(Me=>Me.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:p.dithering,shadowMapEnabled:i.shadowMap.enabled&&A.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:Te&&p.map.isVideoTexture===!0&&nt.getTransfer(p.map.colorSpace)===Et,decodeVideoTextureEmissive:Pt&&p.emissiveMap.isVideoTexture===!0&&nt.getTransfer(p.emissiveMap.colorSpace)===Et,premultipliedAlpha:p.premultipliedAlpha,doubleSided:p.side===rn,flipSided:p.side===Mn,useDepthPacking:p.depthPacking>=0,depthPacking:p.depthPacking||0,index0AttributeName:p.index0AttributeName,extensionClipCullDistance:tt&&p.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&p.extensions.multiDraw===!0||We)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:p.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function y(p){let S=[];if(p.shaderID?S.push(p.shaderID):(S.push(p.customVertexShaderID),S.push(p.customFragmentShaderID)),p.defines!==void 0)for(let A in p.defines)S.push(A),S.push(p.defines[A]);return p.isRawShaderMaterial===!1&&(m(S,p),_(S,p),S.push(i.outputColorSpace)),S.push(p.customProgramCacheKey),S.join()}function m(p,S){p.push(S.precision),p.push(S.outputColorSpace),p.push(S.envMapMode),p.push(S.envMapPMREM),p.push(S.envMapMaxLod),p.push(S.envMapSize),p.push(S.mapUv),p.push(S.alphaMapUv),p.push(S.lightMapUv),p.push(S.aoMapUv),p.push(S.bumpMapUv),p.push(S.normalMapUv),p.push(S.displacementMapUv),p.push(S.emissiveMapUv),p.push(S.metalnessMapUv),p.push(S.roughnessMapUv),p.push(S.anisotropyMapUv),p.push(S.clearcoatMapUv),p.push(S.clearcoatNormalMapUv),p.push(S.clearcoatRoughnessMapUv),p.push(S.diffuseRoughnessMapUv),p.push(S.iridescenceMapUv),p.push(S.iridescenceThicknessMapUv),p.push(S.sheenColorMapUv),p.push(S.sheenRoughnessMapUv),p.push(S.specularMapUv),p.push(S.specularColorMapUv),p.push(S.specularIntensityMapUv),p.push(S.transmissionMapUv),p.push(S.thicknessMapUv),p.push(S.combine),p.push(S.fogExp2),p.push(S.sizeAttenuation),p.push(S.morphTargetsCount),p.push(S.numSunLights),p.push(S.numDirLights),p.push(S.numPointLights),p.push(S.numSpotLights),p.push(S.numSpotLightMaps),p.push(S.numHemiLights),p.push(S.numRectAreaLights),p.push(S.numSunLightShadows),p.push(S.numDirLightShadows),p.push(S.numPointLightShadows),p.push(S.numSpotLightShadows),p.push(S.numSpotLightShadowsWithMaps),p.push(S.numLightProbes),p.push(S.numLightProbeGrids),p.push(S.shadowMapType),p.push(S.toneMapping),p.push(S.numClippingPlanes),p.push(S.numClipIntersection),p.push(S.depthPacking)}function _(p,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),p.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),p.push(o.mask)}function v(p){let S=d[p.type],A;if(S){let E=$n[S];A=Il.clone(E.uniforms)}else A=p.uniforms;return A}function M(p,S){let A=u.get(S);return A!==void 0?++A.usedTimes:(A=new ST(i,S,p,s),c.push(A),u.set(S,A)),A}function b(p){if(--p.usedTimes===0){let S=c.indexOf(p);c[S]=c[c.length-1],c.pop(),u.delete(p.cacheKey),p.destroy()}}function w(p){a.remove(p)}function x(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:v,acquireProgram:M,releaseProgram:b,releaseShaderCache:w,programs:c,dispose:x}}function TT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function AT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function k_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function B_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,y,m,_){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:m,group:_},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=m,v.group=_),e++,v}function l(d,f,g,y,m,_,v){v.reversedDepth===!0&&(m=-m);let M=a(d,f,g,y,m,_);g.transmission>0?n.push(M):g.transparent===!0?s.push(M):t.push(M)}function c(d,f,g,y,m,_){let v=a(d,f,g,y,m,_);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||AT),n.length>1&&n.sort(f||k_),s.length>1&&s.sort(f||k_)}function h(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function RT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new B_,i.set(n,[o])):s>=r.length?(o=new B_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function CT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new P,color:new Ne};break;case"SpotLight":t={position:new P,direction:new P,color:new Ne,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new P,color:new Ne,distance:0,decay:0};break;case"HemisphereLight":t={direction:new P,skyColor:new Ne,groundColor:new Ne};break;case"RectAreaLight":t={color:new Ne,position:new P,halfWidth:new P,halfHeight:new P};break}return i[e.id]=t,t}}}function PT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ue};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ue};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ue,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var IT=0;function LT(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function OT(i){let e=new CT,t=PT(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new P);let s=new P,r=new Re,o=new Re;function a(c){let u=0,h=0,d=0;for(let I=0;I<9;I++)n.probe[I].set(0,0,0);let f=0,g=0,y=0,m=0,_=0,v=0,M=0,b=0,w=0,x=0,p=0,S=0,A=0,E=0;c.sort(LT);for(let I=0,D=c.length;I<D;I++){let L=c[I],U=L.color,V=L.intensity,B=L.distance,ne=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Js?ne=L.shadow.map.texture:ne=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=U.r*V,h+=U.g*V,d+=U.b*V;else if(L.isLightProbe){for(let z=0;z<9;z++)n.probe[z].addScaledVector(L.sh.coefficients[z],V);E++}else if(L.isSunLight){let z=e.get(L);if(z.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let q=L.shadow,W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize.copy(q.mapSize).multiply(q.getFrameExtents()),n.sunShadow[g]=W,n.sunShadowMap[g]=ne;let ge=q.getViewportCount();for(let Ee=0;Ee<ge;Ee++)n.sunShadowMatrix[y+Ee]=q.getMatrix(Ee),n.sunShadowCascade[y+Ee]=q._cascadeData[Ee];y+=ge,g++}n.sun[f]=z,f++}else if(L.isDirectionalLight){let z=e.get(L);if(z.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let q=L.shadow,W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,n.directionalShadow[m]=W,n.directionalShadowMap[m]=ne,n.directionalShadowMatrix[m]=L.shadow.matrix,w++}n.directional[m]=z,m++}else if(L.isSpotLight){let z=e.get(L);z.position.setFromMatrixPosition(L.matrixWorld),z.color.copy(U).multiplyScalar(V),z.distance=B,z.coneCos=Math.cos(L.angle),z.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),z.decay=L.decay,n.spot[v]=z;let q=L.shadow;if(L.map&&(n.spotLightMap[S]=L.map,S++,q.updateMatrices(L),L.castShadow&&A++),n.spotLightMatrix[v]=q.matrix,L.castShadow){let W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,n.spotShadow[v]=W,n.spotShadowMap[v]=ne,p++}v++}else if(L.isRectAreaLight){let z=e.get(L);z.color.copy(U).multiplyScalar(V),z.halfWidth.set(L.width*.5,0,0),z.halfHeight.set(0,L.height*.5,0),n.rectArea[M]=z,M++}else if(L.isPointLight){let z=e.get(L);if(z.color.copy(L.color).multiplyScalar(L.intensity),z.distance=L.distance,z.decay=L.decay,L.castShadow){let q=L.shadow,W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,W.shadowCameraNear=q.camera.near,W.shadowCameraFar=q.camera.far,n.pointShadow[_]=W,n.pointShadowMap[_]=ne,n.pointShadowMatrix[_]=L.shadow.matrix,x++}n.point[_]=z,_++}else if(L.isHemisphereLight){let z=e.get(L);z.skyColor.copy(L.color).multiplyScalar(V),z.groundColor.copy(L.groundColor).multiplyScalar(V),n.hemi[b]=z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=be.LTC_FLOAT_1,n.rectAreaLTC2=be.LTC_FLOAT_2):(n.rectAreaLTC1=be.LTC_HALF_1,n.rectAreaLTC2=be.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let C=n.hash;(C.sunLength!==f||C.directionalLength!==m||C.pointLength!==_||C.spotLength!==v||C.rectAreaLength!==M||C.hemiLength!==b||C.numSunShadows!==g||C.numDirectionalShadows!==w||C.numPointShadows!==x||C.numSpotShadows!==p||C.numSpotMaps!==S||C.numLightProbes!==E)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=M,n.point.length=_,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=w,n.directionalShadowMap.length=w,n.directionalShadowMatrix.length=w,n.pointShadow.length=x,n.pointShadowMap.length=x,n.pointShadowMatrix.length=x,n.spotShadow.length=p,n.spotShadowMap.length=p,n.spotLightMatrix.length=p+S-A,n.spotLightMap.length=S,n.numSpotLightShadowsWithMaps=A,n.numLightProbes=E,C.sunLength=f,C.directionalLength=m,C.pointLength=_,C.spotLength=v,C.rectAreaLength=M,C.hemiLength=b,C.numSunShadows=g,C.numDirectionalShadows=w,C.numPointShadows=x,C.numSpotShadows=p,C.numSpotMaps=S,C.numLightProbes=E,n.version=IT++)}function l(c,u){let h=0,d=0,f=0,g=0,y=0,m=0,_=u.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let b=c[v];if(b.isSunLight){let w=n.sun[h];w.direction.setFromMatrixPosition(b.matrixWorld),w.direction.transformDirection(_),h++}else if(b.isDirectionalLight){let w=n.directional[d];w.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(_),d++}else if(b.isSpotLight){let w=n.spot[g];w.position.setFromMatrixPosition(b.matrixWorld),w.position.applyMatrix4(_),w.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(_),g++}else if(b.isRectAreaLight){let w=n.rectArea[y];w.position.setFromMatrixPosition(b.matrixWorld),w.position.applyMatrix4(_),o.identity(),r.copy(b.matrixWorld),r.premultiply(_),o.extractRotation(r),w.halfWidth.set(b.width*.5,0,0),w.halfHeight.set(0,b.height*.5,0),w.halfWidth.applyMatrix4(o),w.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let w=n.point[f];w.position.setFromMatrixPosition(b.matrixWorld),w.position.applyMatrix4(_),f++}else if(b.isHemisphereLight){let w=n.hemi[m];w.direction.setFromMatrixPosition(b.matrixWorld),w.direction.transformDirection(_),m++}}}return{setup:a,setupView:l,state:n}}function z_(i){let e=new OT(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function NT(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new z_(i),e.set(s,[a])):r>=o.length?(a=new z_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var DT=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,UT=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,FT=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],kT=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],V_=new Re,Ll=new P,op=new P;function BT(i,e,t){let n=new ys,s=new Ue,r=new Ue,o=new ot,a=new hu,l=new du,c={},u=t.maxTextureSize,h={[oi]:Mn,[Mn]:oi,[rn]:rn},d=new un({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ue},radius:{value:4}},vertexShader:DT,fragmentShader:UT}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Xt;g.setAttribute("position",new pt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Tt(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=vl;let _=this.type;this.render=function(x,p,S){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||x.length===0)return;this.type===F0&&(De("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=vl);let A=i.getRenderTarget(),E=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),I=i.state;I.setBlending(qi),I.buffers.depth.getReversed()===!0?I.buffers.color.setClear(0,0,0,0):I.buffers.color.setClear(1,1,1,1),I.buffers.depth.setTest(!0),I.setScissorTest(!1);let D=_!==this.type;D&&p.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(U=>U.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,U=x.length;L<U;L++){let V=x[L],B=V.shadow;if(B===void 0){De("WebGLShadowMap:",V,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let ne=B.getFrameExtents();s.multiply(ne),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ne.x),s.x=r.x*ne.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ne.y),s.y=r.y*ne.y,B.mapSize.y=r.y));let z=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=z,B.map===null||D===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===Co){if(V.isPointLight){De("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new Fn(s.x,s.y,{format:Js,type:Ei,minFilter:cn,magFilter:cn,generateMipmaps:!1}),B.map.texture.name=V.name+".shadowMap",B.map.depthTexture=new vs(s.x,s.y,Gn),B.map.depthTexture.name=V.name+".shadowMapDepth",B.map.depthTexture.format=_s,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=en,B.map.depthTexture.magFilter=en}else V.isPointLight?(B.map=new Nl(s.x),B.map.depthTexture=new ol(s.x,gi)):(B.map=new Fn(s.x,s.y),B.map.depthTexture=new vs(s.x,s.y,gi)),B.map.depthTexture.name=V.name+".shadowMap",B.map.depthTexture.format=_s,this.type===vl?(B.map.depthTexture.compareFunction=z?Yf:qf,B.map.depthTexture.minFilter=cn,B.map.depthTexture.magFilter=cn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=en,B.map.depthTexture.magFilter=en);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let q=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();V.isPointLight!==!0&&B.updateMatrices(V,S);let W=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:S.layers;for(let ge=0;ge<q;ge++){let Ee=B.getCamera(ge);if(V.isPointLight){let $=B.camera,ae=B.matrix,se=V.distance||$.far;se!==$.far&&($.far=se,$.updateProjectionMatrix()),Ll.setFromMatrixPosition(V.matrixWorld),$.position.copy(Ll),op.copy($.position),op.add(FT[ge]),$.up.copy(kT[ge]),$.lookAt(op),$.updateMatrixWorld(),ae.makeTranslation(-Ll.x,-Ll.y,-Ll.z),V_.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),B._frustum.setFromProjectionMatrix(V_,$.coordinateSystem,$.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,ge),i.clear();else{ge===0&&(i.setRenderTarget(B.map),i.clear());let $=B.getViewport(ge);o.set(r.x*$.x,r.y*$.y,r.x*$.z,r.y*$.w),I.viewport(o)}n=B.getFrustum(ge),b(p,S,Ee,V,W,this.type)}B.isPointLightShadow!==!0&&this.type===Co&&v(B,S),B.needsUpdate=!1}_=this.type,m.needsUpdate=!1,i.setRenderTarget(A,E,C)};function v(x,p){let S=e.update(y);d.defines.VSM_SAMPLES!==x.blurSamples&&(d.defines.VSM_SAMPLES=x.blurSamples,f.defines.VSM_SAMPLES=x.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),x.mapPass===null?x.mapPass=new Fn(s.x,s.y,{format:Js,type:Ei}):(x.mapPass.width!==x.map.width||x.mapPass.height!==x.map.height)&&x.mapPass.setSize(x.map.width,x.map.height),d.uniforms.shadow_pass.value=x.map.depthTexture,d.uniforms.resolution.value.set(x.map.width,x.map.height),d.uniforms.radius.value=x.radius,i.setRenderTarget(x.mapPass),i.clear(),i.renderBufferDirect(p,null,S,d,y,null),f.uniforms.shadow_pass.value=x.mapPass.texture,f.uniforms.resolution.value.set(x.map.width,x.map.height),f.uniforms.radius.value=x.radius,i.setRenderTarget(x.map),i.clear(),i.renderBufferDirect(p,null,S,f,y,null)}function M(x,p,S,A){let E=null,C=S.isPointLight===!0?x.customDistanceMaterial:x.customDepthMaterial;if(C!==void 0)E=C;else if(E=S.isPointLight===!0?l:a,i.localClippingEnabled&&p.clipShadows===!0&&Array.isArray(p.clippingPlanes)&&p.clippingPlanes.length!==0||p.displacementMap&&p.displacementScale!==0||p.alphaMap&&p.alphaTest>0||p.map&&p.alphaTest>0||p.alphaToCoverage===!0){let I=E.uuid,D=p.uuid,L=c[I];L===void 0&&(L={},c[I]=L);let U=L[D];U===void 0&&(U=E.clone(),L[D]=U,p.addEventListener("dispose",w)),E=U}if(E.visible=p.visible,E.wireframe=p.wireframe,A===Co?E.side=p.shadowSide!==null?p.shadowSide:p.side:E.side=p.shadowSide!==null?p.shadowSide:h[p.side],E.alphaMap=p.alphaMap,E.alphaTest=p.alphaToCoverage===!0?.5:p.alphaTest,E.map=p.map,E.clipShadows=p.clipShadows,E.clippingPlanes=p.clippingPlanes,E.clipIntersection=p.clipIntersection,E.displacementMap=p.displacementMap,E.displacementScale=p.displacementScale,E.displacementBias=p.displacementBias,E.wireframeLinewidth=p.wireframeLinewidth,E.linewidth=p.linewidth,S.isPointLight===!0&&E.isMeshDistanceMaterial===!0){let I=i.properties.get(E);I.light=S}return E}function b(x,p,S,A,E,C){if(x.visible===!1)return;if(x.layers.test(E)&&(x.isMesh||x.isLine||x.isPoints)&&(x.castShadow||x.receiveShadow&&C===Co)&&(!x.frustumCulled||x.intersectsFrustum(n))){x.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,x.matrixWorld);let L=e.update(x),U=x.material;if(Array.isArray(U)){let V=L.groups;for(let B=0,ne=V.length;B<ne;B++){let z=V[B],q=U[z.materialIndex];if(q&&q.visible){let W=M(x,q,A,C);x.onBeforeShadow(i,x,p,S,L,W,z),i.renderBufferDirect(S,null,L,W,x,z),x.onAfterShadow(i,x,p,S,L,W,z)}}}else if(U.visible){let V=M(x,U,A,C);x.onBeforeShadow(i,x,p,S,L,V,null),i.renderBufferDirect(S,null,L,V,x,null),x.onAfterShadow(i,x,p,S,L,V,null)}}let D=x.children;for(let L=0,U=D.length;L<U;L++)b(D[L],p,S,A,E,C)}function w(x){x.target.removeEventListener("dispose",w);for(let S in c){let A=c[S],E=x.target.uuid;E in A&&(A[E].dispose(),delete A[E])}}}function zT(i,e){function t(){let N=!1,ee=new ot,Z=null,me=new ot(0,0,0,0);return{setMask:function(ue){Z!==ue&&!N&&(i.colorMask(ue,ue,ue,ue),Z=ue)},setLocked:function(ue){N=ue},setClear:function(ue,fe,Fe,tt,le){le===!0&&(ue*=tt,fe*=tt,Fe*=tt),ee.set(ue,fe,Fe,tt),me.equals(ee)===!1&&(i.clearColor(ue,fe,Fe,tt),me.copy(ee))},reset:function(){N=!1,Z=null,me.set(-1,0,0,0)}}}function n(){let N=!1,ee=!1,Z=null,me=null,ue=null;return{setReversed:function(fe){if(ee!==fe){let Fe=e.get("EXT_clip_control");fe?Fe.clipControlEXT(Fe.LOWER_LEFT_EXT,Fe.ZERO_TO_ONE_EXT):Fe.clipControlEXT(Fe.LOWER_LEFT_EXT,Fe.NEGATIVE_ONE_TO_ONE_EXT),ee=fe;let tt=ue;ue=null,this.setClear(tt)}},getReversed:function(){return ee},setTest:function(fe){fe?re(i.DEPTH_TEST):he(i.DEPTH_TEST)},setMask:function(fe){Z!==fe&&!N&&(i.depthMask(fe),Z=fe)},setFunc:function(fe){if(ee&&(fe=__[fe]),me!==fe){switch(fe){case jc:i.depthFunc(i.NEVER);break;case Qc:i.depthFunc(i.ALWAYS);break;case eu:i.depthFunc(i.LESS);break;case mo:i.depthFunc(i.LEQUAL);break;case tu:i.depthFunc(i.EQUAL);break;case nu:i.depthFunc(i.GEQUAL);break;case iu:i.depthFunc(i.GREATER);break;case su:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}me=fe}},setLocked:function(fe){N=fe},setClear:function(fe){ue!==fe&&(ue=fe,ee&&(fe=1-fe),i.clearDepth(fe))},reset:function(){N=!1,Z=null,me=null,ue=null,ee=!1}}}function s(){let N=!1,ee=null,Z=null,me=null,ue=null,fe=null,Fe=null,tt=null,le=null;return{setTest:function(Be){N||(Be?re(i.STENCIL_TEST):he(i.STENCIL_TEST))},setMask:function(Be){ee!==Be&&!N&&(i.stencilMask(Be),ee=Be)},setFunc:function(Be,Je,Me){(Z!==Be||me!==Je||ue!==Me)&&(i.stencilFunc(Be,Je,Me),Z=Be,me=Je,ue=Me)},setOp:function(Be,Je,Me){(fe!==Be||Fe!==Je||tt!==Me)&&(i.stencilOp(Be,Je,Me),fe=Be,Fe=Je,tt=Me)},setLocked:function(Be){N=Be},setClear:function(Be){le!==Be&&(i.clearStencil(Be),le=Be)},reset:function(){N=!1,ee=null,Z=null,me=null,ue=null,fe=null,Fe=null,tt=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],y=null,m=!1,_=null,v=null,M=null,b=null,w=null,x=null,p=null,S=new Ne(0,0,0),A=0,E=!1,C=null,I=null,D=null,L=null,U=null,V=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,ne=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec(z)[1]),B=ne>=1):z.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),B=ne>=2);let q=null,W={},ge=i.getParameter(i.SCISSOR_BOX),Ee=i.getParameter(i.VIEWPORT),$=new ot().fromArray(ge),ae=new ot().fromArray(Ee);function se(N,ee,Z,me){let ue=new Uint8Array(4),fe=i.createTexture();i.bindTexture(N,fe),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Fe=0;Fe<Z;Fe++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(ee,0,i.RGBA,1,1,me,0,i.RGBA,i.UNSIGNED_BYTE,ue):i.texImage2D(ee+Fe,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ue);return fe}let ce={};ce[i.TEXTURE_2D]=se(i.TEXTURE_2D,i.TEXTURE_2D,1),ce[i.TEXTURE_CUBE_MAP]=se(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ce[i.TEXTURE_2D_ARRAY]=se(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ce[i.TEXTURE_3D]=se(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),re(i.DEPTH_TEST),o.setFunc(mo),st(!1),Ze(Tf),re(i.CULL_FACE),dt(qi);function re(N){u[N]!==!0&&(i.enable(N),u[N]=!0)}function he(N){u[N]!==!1&&(i.disable(N),u[N]=!1)}function We(N,ee){return d[N]!==ee?(i.bindFramebuffer(N,ee),d[N]=ee,N===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=ee),N===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=ee),!0):!1}function Te(N,ee){let Z=g,me=!1;if(N){Z=f.get(ee),Z===void 0&&(Z=[],f.set(ee,Z));let ue=N.textures;if(Z.length!==ue.length||Z[0]!==i.COLOR_ATTACHMENT0){for(let fe=0,Fe=ue.length;fe<Fe;fe++)Z[fe]=i.COLOR_ATTACHMENT0+fe;Z.length=ue.length,me=!0}}else Z[0]!==i.BACK&&(Z[0]=i.BACK,me=!0);me&&i.drawBuffers(Z)}function ke(N){return y!==N?(i.useProgram(N),y=N,!0):!1}let Ie={[Or]:i.FUNC_ADD,[B0]:i.FUNC_SUBTRACT,[z0]:i.FUNC_REVERSE_SUBTRACT};Ie[V0]=i.MIN,Ie[H0]=i.MAX;let Se={[G0]:i.ZERO,[W0]:i.ONE,[X0]:i.SRC_COLOR,[Pf]:i.SRC_ALPHA,[J0]:i.SRC_ALPHA_SATURATE,[K0]:i.DST_COLOR,[Y0]:i.DST_ALPHA,[q0]:i.ONE_MINUS_SRC_COLOR,[If]:i.ONE_MINUS_SRC_ALPHA,[Z0]:i.ONE_MINUS_DST_COLOR,[$0]:i.ONE_MINUS_DST_ALPHA,[j0]:i.CONSTANT_COLOR,[Q0]:i.ONE_MINUS_CONSTANT_COLOR,[e_]:i.CONSTANT_ALPHA,[t_]:i.ONE_MINUS_CONSTANT_ALPHA};function dt(N,ee,Z,me,ue,fe,Fe,tt,le,Be){if(N===qi){m===!0&&(he(i.BLEND),m=!1);return}if(m===!1&&(re(i.BLEND),m=!0),N!==k0){if(N!==_||Be!==E){if((v!==Or||w!==Or)&&(i.blendEquation(i.FUNC_ADD),v=Or,w=Or),Be)switch(N){case Po:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Af:i.blendFunc(i.ONE,i.ONE);break;case Rf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Cf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ge("WebGLState: Invalid blending: ",N);break}else switch(N){case Po:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Af:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Rf:Ge("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cf:Ge("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ge("WebGLState: Invalid blending: ",N);break}M=null,b=null,x=null,p=null,S.set(0,0,0),A=0,_=N,E=Be}return}ue=ue||ee,fe=fe||Z,Fe=Fe||me,(ee!==v||ue!==w)&&(i.blendEquationSeparate(Ie[ee],Ie[ue]),v=ee,w=ue),(Z!==M||me!==b||fe!==x||Fe!==p)&&(i.blendFuncSeparate(Se[Z],Se[me],Se[fe],Se[Fe]),M=Z,b=me,x=fe,p=Fe),(tt.equals(S)===!1||le!==A)&&(i.blendColor(tt.r,tt.g,tt.b,le),S.copy(tt),A=le),_=N,E=!1}function ze(N,ee){N.side===rn?he(i.CULL_FACE):re(i.CULL_FACE);let Z=N.side===Mn;ee&&(Z=!Z),st(Z),N.blending===Po&&N.transparent===!1?dt(qi):dt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let me=N.stencilWrite;a.setTest(me),me&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Pt(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?re(i.SAMPLE_ALPHA_TO_COVERAGE):he(i.SAMPLE_ALPHA_TO_COVERAGE)}function st(N){C!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),C=N)}function Ze(N){N!==D0?(re(i.CULL_FACE),N!==I&&(N===Tf?i.cullFace(i.BACK):N===U0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):he(i.CULL_FACE),I=N}function vn(N){N!==D&&(B&&i.lineWidth(N),D=N)}function Pt(N,ee,Z){N?(re(i.POLYGON_OFFSET_FILL),(L!==ee||U!==Z)&&(L=ee,U=Z,o.getReversed()&&(ee=-ee,Z=-Z),i.polygonOffset(ee,Z))):he(i.POLYGON_OFFSET_FILL)}function pn(N){N?re(i.SCISSOR_TEST):he(i.SCISSOR_TEST)}function wt(N){N===void 0&&(N=i.TEXTURE0+V-1),q!==N&&(i.activeTexture(N),q=N)}function qt(N,ee,Z){Z===void 0&&(q===null?Z=i.TEXTURE0+V-1:Z=q);let me=W[Z];me===void 0&&(me={type:void 0,texture:void 0},W[Z]=me),(me.type!==N||me.texture!==ee)&&(q!==Z&&(i.activeTexture(Z),q=Z),i.bindTexture(N,ee||ce[N]),me.type=N,me.texture=ee)}function k(){let N=W[q];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Nt(){try{i.compressedTexImage2D(...arguments)}catch(N){Ge("WebGLState:",N)}}function ft(){try{i.compressedTexImage3D(...arguments)}catch(N){Ge("WebGLState:",N)}}function Lt(){try{i.texSubImage2D(...arguments)}catch(N){Ge("WebGLState:",N)}}function xe(){try{i.texSubImage3D(...arguments)}catch(N){Ge("WebGLState:",N)}}function Vt(){try{i.compressedTexSubImage2D(...arguments)}catch(N){Ge("WebGLState:",N)}}function Le(){try{i.compressedTexSubImage3D(...arguments)}catch(N){Ge("WebGLState:",N)}}function Ve(){try{i.texStorage2D(...arguments)}catch(N){Ge("WebGLState:",N)}}function O(){try{i.texStorage3D(...arguments)}catch(N){Ge("WebGLState:",N)}}function T(){try{i.texImage2D(...arguments)}catch(N){Ge("WebGLState:",N)}}function G(){try{i.texImage3D(...arguments)}catch(N){Ge("WebGLState:",N)}}function oe(N){return h[N]!==void 0?h[N]:i.getParameter(N)}function te(N,ee){h[N]!==ee&&(i.pixelStorei(N,ee),h[N]=ee)}function de(N){$.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),$.copy(N))}function ye(N){ae.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),ae.copy(N))}function j(N,ee){let Z=c.get(ee);Z===void 0&&(Z=new WeakMap,c.set(ee,Z));let me=Z.get(N);me===void 0&&(me=i.getUniformBlockIndex(ee,N.name),i.uniformBlockBinding(ee,me,me),Z.set(N,me))}function Q(N,ee,Z){let ue=c.get(ee).get(N);l[ue]!==Z&&(i.bindBufferBase(i.UNIFORM_BUFFER,ue,Z),l[ue]=Z)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},q=null,W={},d={},l={},f=new WeakMap,g=[],y=null,m=!1,_=null,v=null,M=null,b=null,w=null,x=null,p=null,S=new Ne(0,0,0),A=0,E=!1,C=null,I=null,D=null,L=null,U=null,$.set(0,0,i.canvas.width,i.canvas.height),ae.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:re,disable:he,bindFramebuffer:We,drawBuffers:Te,useProgram:ke,setBlending:dt,setMaterial:ze,setFlipSided:st,setCullFace:Ze,setLineWidth:vn,setPolygonOffset:Pt,setScissorTest:pn,activeTexture:wt,bindTexture:qt,unbindTexture:k,compressedTexImage2D:Nt,compressedTexImage3D:ft,texImage2D:T,texImage3D:G,pixelStorei:te,getParameter:oe,updateUBOMapping:j,uniformBlockBinding:Q,texStorage2D:Ve,texStorage3D:O,texSubImage2D:Lt,texSubImage3D:xe,compressedTexSubImage2D:Vt,compressedTexSubImage3D:Le,scissor:de,viewport:ye,reset:pe}}function VT(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ue,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,y=new FinalizationRegistry(O=>g.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(O,T){return m?new OffscreenCanvas(O,T):xo("canvas")}function v(O,T,G){let oe=1,te=Ve(O);if((te.width>G||te.height>G)&&(oe=G/Math.max(te.width,te.height)),oe<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let de=Math.floor(oe*te.width),ye=Math.floor(oe*te.height);d===void 0&&(d=_(de,ye));let j=T?_(de,ye):d;return j.width=de,j.height=ye,j.getContext("2d").drawImage(O,0,0,de,ye),De("WebGLRenderer: Texture has been resized from ("+te.width+"x"+te.height+") to ("+de+"x"+ye+")."),j}else return"data"in O&&De("WebGLRenderer: Image in DataTexture is too big ("+te.width+"x"+te.height+")."),O;return O}function M(O){return O.generateMipmaps}function b(O){i.generateMipmap(O)}function w(O){return O.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?i.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function x(O,T,G,oe,te,de=!1){if(O!==null){if(i[O]!==void 0)return i[O];De("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let ye;oe&&(ye=e.get("EXT_texture_norm16"),ye||De("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=T;if(T===i.RED&&(G===i.FLOAT&&(j=i.R32F),G===i.HALF_FLOAT&&(j=i.R16F),G===i.UNSIGNED_BYTE&&(j=i.R8),G===i.UNSIGNED_SHORT&&ye&&(j=ye.R16_EXT),G===i.SHORT&&ye&&(j=ye.R16_SNORM_EXT)),T===i.RED_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.R8UI),G===i.UNSIGNED_SHORT&&(j=i.R16UI),G===i.UNSIGNED_INT&&(j=i.R32UI),G===i.BYTE&&(j=i.R8I),G===i.SHORT&&(j=i.R16I),G===i.INT&&(j=i.R32I)),T===i.RG&&(G===i.FLOAT&&(j=i.RG32F),G===i.HALF_FLOAT&&(j=i.RG16F),G===i.UNSIGNED_BYTE&&(j=i.RG8),G===i.UNSIGNED_SHORT&&ye&&(j=ye.RG16_EXT),G===i.SHORT&&ye&&(j=ye.RG16_SNORM_EXT)),T===i.RG_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RG8UI),G===i.UNSIGNED_SHORT&&(j=i.RG16UI),G===i.UNSIGNED_INT&&(j=i.RG32UI),G===i.BYTE&&(j=i.RG8I),G===i.SHORT&&(j=i.RG16I),G===i.INT&&(j=i.RG32I)),T===i.RGB_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RGB8UI),G===i.UNSIGNED_SHORT&&(j=i.RGB16UI),G===i.UNSIGNED_INT&&(j=i.RGB32UI),G===i.BYTE&&(j=i.RGB8I),G===i.SHORT&&(j=i.RGB16I),G===i.INT&&(j=i.RGB32I)),T===i.RGBA_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RGBA8UI),G===i.UNSIGNED_SHORT&&(j=i.RGBA16UI),G===i.UNSIGNED_INT&&(j=i.RGBA32UI),G===i.BYTE&&(j=i.RGBA8I),G===i.SHORT&&(j=i.RGBA16I),G===i.INT&&(j=i.RGBA32I)),T===i.RGB&&(G===i.UNSIGNED_SHORT&&ye&&(j=ye.RGB16_EXT),G===i.SHORT&&ye&&(j=ye.RGB16_SNORM_EXT),G===i.UNSIGNED_INT_5_9_9_9_REV&&(j=i.RGB9_E5),G===i.UNSIGNED_INT_10F_11F_11F_REV&&(j=i.R11F_G11F_B10F)),T===i.RGBA){let Q=de?$a:nt.getTransfer(te);G===i.FLOAT&&(j=i.RGBA32F),G===i.HALF_FLOAT&&(j=i.RGBA16F),G===i.UNSIGNED_BYTE&&(j=Q===Et?i.SRGB8_ALPHA8:i.RGBA8),G===i.UNSIGNED_SHORT&&ye&&(j=ye.RGBA16_EXT),G===i.SHORT&&ye&&(j=ye.RGBA16_SNORM_EXT),G===i.UNSIGNED_SHORT_4_4_4_4&&(j=i.RGBA4),G===i.UNSIGNED_SHORT_5_5_5_1&&(j=i.RGB5_A1)}return(j===i.R16F||j===i.R32F||j===i.RG16F||j===i.RG32F||j===i.RGBA16F||j===i.RGBA32F)&&e.get("EXT_color_buffer_float"),j}function p(O,T){let G;return O?T===null||T===gi||T===Ur?G=i.DEPTH24_STENCIL8:T===Gn?G=i.DEPTH32F_STENCIL8:T===Oo&&(G=i.DEPTH24_STENCIL8,De("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===gi||T===Ur?G=i.DEPTH_COMPONENT24:T===Gn?G=i.DEPTH_COMPONENT32F:T===Oo&&(G=i.DEPTH_COMPONENT16),G}function S(O,T){return M(O)===!0||O.isFramebufferTexture&&O.minFilter!==en&&O.minFilter!==cn?Math.log2(Math.max(T.width,T.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?T.mipmaps.length:1}function A(O){let T=new WeakRef(O);n.get(O).__ref=T,g.add(T),y.register(O,T,T)}function E(O){let T=n.get(O).__ref;T!==void 0&&(g.delete(T),y.unregister(T))}function C(O){D(O.target)}function I(O){L(O.target)}function D(O){O.removeEventListener("dispose",C),E(O),V(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function L(O){O.removeEventListener("dispose",I),E(O),ne(O)}function U(){for(let O of g){let T=O.deref();T!==void 0&&(T.isRenderTarget===!0?L(T):D(T))}g.clear(),h.clear()}function V(O){let T=n.get(O);if(T.__webglInit===void 0)return;let G=O.source,oe=f.get(G);if(oe){let te=oe[T.__cacheKey];te.usedTimes--,te.usedTimes===0&&B(O),Object.keys(oe).length===0&&f.delete(G)}n.remove(O)}function B(O){let T=n.get(O);i.deleteTexture(T.__webglTexture);let G=O.source,oe=f.get(G);delete oe[T.__cacheKey],o.memory.textures--}function ne(O){let T=n.get(O);T.__depthDisposeCallback&&T.__depthDisposeCallback();let G=O.depthTexture;if(G&&G.renderTarget===O&&D(G),O.isWebGLCubeRenderTarget)for(let te=0;te<6;te++){if(Array.isArray(T.__webglFramebuffer[te]))for(let de=0;de<T.__webglFramebuffer[te].length;de++)i.deleteFramebuffer(T.__webglFramebuffer[te][de]);else i.deleteFramebuffer(T.__webglFramebuffer[te]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[te])}else{if(Array.isArray(T.__webglFramebuffer))for(let te=0;te<T.__webglFramebuffer.length;te++)i.deleteFramebuffer(T.__webglFramebuffer[te]);else i.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let te=0;te<T.__webglColorRenderbuffer.length;te++)T.__webglColorRenderbuffer[te]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[te]);T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let oe=O.textures;for(let te=0,de=oe.length;te<de;te++){let ye=n.get(oe[te]);ye.__webglTexture&&(i.deleteTexture(ye.__webglTexture),o.memory.textures--),n.remove(oe[te])}n.remove(O)}let z=0;function q(){z=0}function W(){return z}function ge(O){z=O}function Ee(){let O=z;return O>=s.maxTextures&&De("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),z+=1,O}function $(O){let T=[];return T.push(O.wrapS),T.push(O.wrapT),T.push(O.wrapR||0),T.push(O.magFilter),T.push(O.minFilter),T.push(O.anisotropy),T.push(O.internalFormat),T.push(O.format),T.push(O.type),T.push(O.generateMipmaps),T.push(O.mipmapsAutoUpdate),T.push(O.premultiplyAlpha),T.push(O.flipY),T.push(O.unpackAlignment),T.push(O.colorSpace),T.join()}function ae(O,T){let G=n.get(O);if(O.isVideoTexture&&Vt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&G.__version!==O.version){let oe=O.image;if(oe===null)De("WebGLRenderer: Texture marked for update but no image data found.");else if(oe.complete===!1)De("WebGLRenderer: Texture marked for update but image is incomplete");else{ze(G,O,T);return}}else O.isExternalTexture&&(G.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,G.__webglTexture,i.TEXTURE0+T)}function se(O,T){let G=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&G.__version!==O.version){ze(G,O,T);return}else O.isExternalTexture&&(G.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,G.__webglTexture,i.TEXTURE0+T)}function ce(O,T){let G=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&G.__version!==O.version){ze(G,O,T);return}t.bindTexture(i.TEXTURE_3D,G.__webglTexture,i.TEXTURE0+T)}function re(O,T){let G=n.get(O);if(O.version>0&&G.__version!==O.version){st(G,O,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,G.__webglTexture,i.TEXTURE0+T)}let he={[Xs]:i.REPEAT,[di]:i.CLAMP_TO_EDGE,[go]:i.MIRRORED_REPEAT},We={[en]:i.NEAREST,[wu]:i.NEAREST_MIPMAP_NEAREST,[Dr]:i.NEAREST_MIPMAP_LINEAR,[cn]:i.LINEAR,[Lo]:i.LINEAR_MIPMAP_NEAREST,[mi]:i.LINEAR_MIPMAP_LINEAR},Te={[c_]:i.NEVER,[$f]:i.ALWAYS,[u_]:i.LESS,[qf]:i.LEQUAL,[h_]:i.EQUAL,[Yf]:i.GEQUAL,[d_]:i.GREATER,[f_]:i.NOTEQUAL};function ke(O,T){if(T.type===Gn&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===cn||T.magFilter===Lo||T.magFilter===Dr||T.magFilter===mi||T.minFilter===cn||T.minFilter===Lo||T.minFilter===Dr||T.minFilter===mi)&&De("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(O,i.TEXTURE_WRAP_S,he[T.wrapS]),i.texParameteri(O,i.TEXTURE_WRAP_T,he[T.wrapT]),(O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY)&&i.texParameteri(O,i.TEXTURE_WRAP_R,he[T.wrapR]),i.texParameteri(O,i.TEXTURE_MAG_FILTER,We[T.magFilter]),i.texParameteri(O,i.TEXTURE_MIN_FILTER,We[T.minFilter]),T.compareFunction&&(i.texParameteri(O,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(O,i.TEXTURE_COMPARE_FUNC,Te[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===en||T.minFilter!==Dr&&T.minFilter!==mi||T.type===Gn&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let G=e.get("EXT_texture_filter_anisotropic");i.texParameterf(O,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function Ie(O,T){let G=!1;O.__webglInit===void 0&&(O.__webglInit=!0,T.addEventListener("dispose",C),A(T));let oe=T.source,te=f.get(oe);te===void 0&&(te={},f.set(oe,te));let de=$(T);if(de!==O.__cacheKey){te[de]===void 0&&(te[de]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,G=!0),te[de].usedTimes++;let ye=te[O.__cacheKey];ye!==void 0&&(te[O.__cacheKey].usedTimes--,ye.usedTimes===0&&B(T)),O.__cacheKey=de,O.__webglTexture=te[de].texture}return G}function Se(O,T,G){return Math.floor(Math.floor(O/G)/T)}function dt(O,T,G,oe){let de=O.updateRanges;if(de.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,G,oe,T.data);else{de.sort((N,ee)=>N.start-ee.start);let ye=0;for(let N=1;N<de.length;N++){let ee=de[ye],Z=de[N],me=ee.start+ee.count,ue=Se(Z.start,T.width,4),fe=Se(ee.start,T.width,4);Z.start<=me+1&&ue===fe&&Se(Z.start+Z.count-1,T.width,4)===ue?ee.count=Math.max(ee.count,Z.start+Z.count-ee.start):(++ye,de[ye]=Z)}de.length=ye+1;let j=t.getParameter(i.UNPACK_ROW_LENGTH),Q=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let N=0,ee=de.length;N<ee;N++){let Z=de[N],me=Math.floor(Z.start/4),ue=Math.ceil(Z.count/4),fe=me%T.width,Fe=Math.floor(me/T.width),tt=ue,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,fe),t.pixelStorei(i.UNPACK_SKIP_ROWS,Fe),t.texSubImage2D(i.TEXTURE_2D,0,fe,Fe,tt,le,G,oe,T.data)}O.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,j),t.pixelStorei(i.UNPACK_SKIP_PIXELS,Q),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function ze(O,T,G){let oe=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(oe=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&(oe=i.TEXTURE_3D);let te=Ie(O,T),de=T.source;t.bindTexture(oe,O.__webglTexture,i.TEXTURE0+G);let ye=n.get(de);if(de.version!==ye.__version||te===!0){if(t.activeTexture(i.TEXTURE0+G),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let le=nt.getPrimaries(nt.workingColorSpace),Be=T.colorSpace===Cs?null:nt.getPrimaries(T.colorSpace),Je=T.colorSpace===Cs||le===Be?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let Q=v(T.image,!1,s.maxTextureSize);Q=Le(T,Q);let pe=r.convert(T.format,T.colorSpace),N=r.convert(T.type),ee=x(T.internalFormat,pe,N,T.normalized,T.colorSpace,T.isVideoTexture);ke(oe,T);let Z,me=T.mipmaps,ue=T.isVideoTexture!==!0,fe=ye.__version===void 0||te===!0,Fe=de.dataReady,tt=S(T,Q);if(T.isDepthTexture)ee=p(T.format===Rs,T.type),fe&&(ue?t.texStorage2D(i.TEXTURE_2D,1,ee,Q.width,Q.height):t.texImage2D(i.TEXTURE_2D,0,ee,Q.width,Q.height,0,pe,N,null));else if(T.isDataTexture)if(me.length>0){ue&&fe&&t.texStorage2D(i.TEXTURE_2D,tt,ee,me[0].width,me[0].height);for(let le=0,Be=me.length;le<Be;le++)Z=me[le],ue?Fe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,Z.width,Z.height,pe,N,Z.data):t.texImage2D(i.TEXTURE_2D,le,ee,Z.width,Z.height,0,pe,N,Z.data);T.generateMipmaps=!1}else ue?(fe&&t.texStorage2D(i.TEXTURE_2D,tt,ee,Q.width,Q.height),Fe&&dt(T,Q,pe,N)):t.texImage2D(i.TEXTURE_2D,0,ee,Q.width,Q.height,0,pe,N,Q.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){ue&&fe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,ee,me[0].width,me[0].height,Q.depth);for(let le=0,Be=me.length;le<Be;le++)if(Z=me[le],T.format!==jn)if(pe!==null)if(ue){if(Fe)if(T.layerUpdates.size>0){let Je=sp(Z.width,Z.height,T.format,T.type);for(let Me of T.layerUpdates){let It=Z.data.subarray(Me*Je/Z.data.BYTES_PER_ELEMENT,(Me+1)*Je/Z.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Me,Z.width,Z.height,1,pe,It)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,Z.width,Z.height,Q.depth,pe,Z.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,ee,Z.width,Z.height,Q.depth,0,Z.data,0,0);else De("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ue?Fe&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,Z.width,Z.height,Q.depth,pe,N,Z.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,ee,Z.width,Z.height,Q.depth,0,pe,N,Z.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{ue&&fe&&t.texStorage2D(i.TEXTURE_2D,tt,ee,me[0].width,me[0].height);for(let le=0,Be=me.length;le<Be;le++)Z=me[le],T.format!==jn?pe!==null?ue?Fe&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,Z.width,Z.height,pe,Z.data):t.compressedTexImage2D(i.TEXTURE_2D,le,ee,Z.width,Z.height,0,Z.data):De("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ue?Fe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,Z.width,Z.height,pe,N,Z.data):t.texImage2D(i.TEXTURE_2D,le,ee,Z.width,Z.height,0,pe,N,Z.data)}else if(T.isDataArrayTexture)if(ue){if(fe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,tt,ee,Q.width,Q.height,Q.depth),Fe)if(T.layerUpdates.size>0){let le=sp(Q.width,Q.height,T.format,T.type);for(let Be of T.layerUpdates){let Je=Q.data.subarray(Be*le/Q.data.BYTES_PER_ELEMENT,(Be+1)*le/Q.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Be,Q.width,Q.height,1,pe,N,Je)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Q.width,Q.height,Q.depth,pe,N,Q.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ee,Q.width,Q.height,Q.depth,0,pe,N,Q.data);else if(T.isData3DTexture)ue?(fe&&t.texStorage3D(i.TEXTURE_3D,tt,ee,Q.width,Q.height,Q.depth),Fe&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Q.width,Q.height,Q.depth,pe,N,Q.data)):t.texImage3D(i.TEXTURE_3D,0,ee,Q.width,Q.height,Q.depth,0,pe,N,Q.data);else if(T.isFramebufferTexture){if(fe)if(ue)t.texStorage2D(i.TEXTURE_2D,tt,ee,Q.width,Q.height);else{let le=Q.width,Be=Q.height;for(let Je=0;Je<tt;Je++)t.texImage2D(i.TEXTURE_2D,Je,ee,le,Be,0,pe,N,null),le>>=1,Be>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),Q.parentNode!==le){le.appendChild(Q),h.add(T),le.onpaint=Be=>{let Je=Be.changedElements;for(let Me of h)Je.includes(Me.image)&&(Me.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Q);else{let Je=i.RGBA,Me=i.RGBA,It=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Je,Me,It,Q)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(me.length>0){if(ue&&fe){let le=Ve(me[0]);t.texStorage2D(i.TEXTURE_2D,tt,ee,le.width,le.height)}for(let le=0,Be=me.length;le<Be;le++)Z=me[le],ue?Fe&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,pe,N,Z):t.texImage2D(i.TEXTURE_2D,le,ee,pe,N,Z);T.generateMipmaps=!1}else if(ue){if(fe){let le=Ve(Q);t.texStorage2D(i.TEXTURE_2D,tt,ee,le.width,le.height)}Fe&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,N,Q)}else t.texImage2D(i.TEXTURE_2D,0,ee,pe,N,Q);M(T)&&T.mipmapsAutoUpdate===!0&&b(oe),ye.__version=de.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function st(O,T,G){if(T.image.length!==6)return;let oe=Ie(O,T),te=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+G);let de=n.get(te);if(te.version!==de.__version||oe===!0){t.activeTexture(i.TEXTURE0+G);let ye=nt.getPrimaries(nt.workingColorSpace),j=T.colorSpace===Cs?null:nt.getPrimaries(T.colorSpace),Q=T.colorSpace===Cs||ye===j?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Q);let pe=T.isCompressedTexture||T.image[0].isCompressedTexture,N=T.image[0]&&T.image[0].isDataTexture,ee=[];for(let Me=0;Me<6;Me++)!pe&&!N?ee[Me]=v(T.image[Me],!0,s.maxCubemapSize):ee[Me]=N?T.image[Me].image:T.image[Me],ee[Me]=Le(T,ee[Me]);let Z=ee[0],me=r.convert(T.format,T.colorSpace),ue=r.convert(T.type),fe=x(T.internalFormat,me,ue,T.normalized,T.colorSpace),Fe=T.isVideoTexture!==!0,tt=de.__version===void 0||oe===!0,le=te.dataReady,Be=S(T,Z);ke(i.TEXTURE_CUBE_MAP,T);let Je;if(T.isDepthTexture){if(fe=p(T.format===Rs,T.type),tt)if(Fe)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,fe,Z.width,Z.height);else for(let Me=0;Me<6;Me++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,fe,Z.width,Z.height,0,me,ue,null)}else if(pe){Fe&&tt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,fe,Z.width,Z.height);for(let Me=0;Me<6;Me++){Je=ee[Me].mipmaps;for(let It=0;It<Je.length;It++){let mn=Je[It];T.format!==jn?me!==null?Fe?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It,0,0,mn.width,mn.height,me,mn.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It,fe,mn.width,mn.height,0,mn.data):De("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Fe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It,0,0,mn.width,mn.height,me,ue,mn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It,fe,mn.width,mn.height,0,me,ue,mn.data)}}}else{if(Je=T.mipmaps,Fe&&tt){Je.length>0&&Be++;let Me=Ve(ee[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Be,fe,Me.width,Me.height)}for(let Me=0;Me<6;Me++)if(N){Fe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,0,0,ee[Me].width,ee[Me].height,me,ue,ee[Me].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,fe,ee[Me].width,ee[Me].height,0,me,ue,ee[Me].data);for(let It=0;It<Je.length;It++){let Fs=Je[It].image[Me].image;Fe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It+1,0,0,Fs.width,Fs.height,me,ue,Fs.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It+1,fe,Fs.width,Fs.height,0,me,ue,Fs.data)}}else{Fe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,0,0,me,ue,ee[Me]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,fe,me,ue,ee[Me]);for(let It=0;It<Je.length;It++){let mn=Je[It];Fe?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It+1,0,0,me,ue,mn.image[Me]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,It+1,fe,me,ue,mn.image[Me])}}}M(T)&&T.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),de.__version=te.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function Ze(O,T,G,oe,te,de){let ye=r.convert(G.format,G.colorSpace),j=r.convert(G.type),Q=x(G.internalFormat,ye,j,G.normalized,G.colorSpace),pe=n.get(T),N=n.get(G);if(N.__renderTarget=T,!pe.__hasExternalTextures){let ee=Math.max(1,T.width>>de),Z=Math.max(1,T.height>>de);te===i.TEXTURE_3D||te===i.TEXTURE_2D_ARRAY?t.texImage3D(te,de,Q,ee,Z,T.depth,0,ye,j,null):t.texImage2D(te,de,Q,ee,Z,0,ye,j,null)}t.bindFramebuffer(i.FRAMEBUFFER,O),xe(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,oe,te,N.__webglTexture,0,Lt(T)):(te===i.TEXTURE_2D||te>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&te<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,oe,te,N.__webglTexture,de),t.bindFramebuffer(i.FRAMEBUFFER,null)}function vn(O,T,G){if(i.bindRenderbuffer(i.RENDERBUFFER,O),T.depthBuffer){let oe=T.depthTexture,te=oe&&oe.isDepthTexture?oe.type:null,de=p(T.stencilBuffer,te),ye=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;xe(T)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Lt(T),de,T.width,T.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,Lt(T),de,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,de,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ye,i.RENDERBUFFER,O)}else{let oe=T.textures;for(let te=0;te<oe.length;te++){let de=oe[te],ye=r.convert(de.format,de.colorSpace),j=r.convert(de.type),Q=x(de.internalFormat,ye,j,de.normalized,de.colorSpace);xe(T)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Lt(T),Q,T.width,T.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,Lt(T),Q,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,Q,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Pt(O,T,G){let oe=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,O),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let te=n.get(T.depthTexture);te.__renderTarget=T;let de=oe?T.depthTexture.image[0]:T.depthTexture.image;(!te.__webglTexture||de.width!==T.width||de.height!==T.height)&&(de.width=T.width,de.height=T.height,T.depthTexture.needsUpdate=!0),oe?re(T.depthTexture,0):ae(T.depthTexture,0);let ye=te.__webglTexture,j=Lt(T),Q=oe?i.TEXTURE_CUBE_MAP_POSITIVE_X+G:i.TEXTURE_2D,pe=T.depthTexture.format===Rs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(T.depthTexture.format===_s)xe(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,Q,ye,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,pe,Q,ye,0);else if(T.depthTexture.format===Rs)xe(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,Q,ye,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,pe,Q,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pn(O){let T=n.get(O),G=O.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==O.depthTexture){let oe=O.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),oe){let te=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,oe.removeEventListener("dispose",te)};oe.addEventListener("dispose",te),T.__depthDisposeCallback=te}T.__boundDepthTexture=oe}if(O.depthTexture&&!T.__autoAllocateDepthBuffer)if(G)for(let oe=0;oe<6;oe++)Pt(T.__webglFramebuffer[oe],O,oe);else O.texture.mipmaps.length>0?Pt(T.__webglFramebuffer[0],O,0):Pt(T.__webglFramebuffer,O,0);else if(G){T.__webglDepthbuffer=[];for(let oe=0;oe<6;oe++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[oe]),T.__webglDepthbuffer[oe]===void 0)T.__webglDepthbuffer[oe]=i.createRenderbuffer(),vn(T.__webglDepthbuffer[oe],O,!1);else{let te=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=T.__webglDepthbuffer[oe];i.bindRenderbuffer(i.RENDERBUFFER,de),i.framebufferRenderbuffer(i.FRAMEBUFFER,te,i.RENDERBUFFER,de)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),vn(T.__webglDepthbuffer,O,!1);else{let te=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,de),i.framebufferRenderbuffer(i.FRAMEBUFFER,te,i.RENDERBUFFER,de)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function wt(O,T,G){let oe=n.get(O);T!==void 0&&Ze(oe.__webglFramebuffer,O,O.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),G!==void 0&&pn(O)}function qt(O){let T=O.texture,G=n.get(O),oe=n.get(T);O.addEventListener("dispose",I),A(O);let te=O.textures,de=O.isWebGLCubeRenderTarget===!0,ye=te.length>1;if(ye||(oe.__webglTexture===void 0&&(oe.__webglTexture=i.createTexture()),oe.__version=T.version,o.memory.textures++),de){G.__webglFramebuffer=[];for(let j=0;j<6;j++)if(T.mipmaps.length>0){G.__webglFramebuffer[j]=[];for(let Q=0;Q<T.mipmaps.length;Q++)G.__webglFramebuffer[j][Q]=i.createFramebuffer()}else G.__webglFramebuffer[j]=i.createFramebuffer()}else{if(T.mipmaps.length>0){G.__webglFramebuffer=[];for(let j=0;j<T.mipmaps.length;j++)G.__webglFramebuffer[j]=i.createFramebuffer()}else G.__webglFramebuffer=i.createFramebuffer();if(ye)for(let j=0,Q=te.length;j<Q;j++){let pe=n.get(te[j]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(O.samples>0&&xe(O)===!1){G.__webglMultisampledFramebuffer=i.createFramebuffer(),G.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let j=0;j<te.length;j++){let Q=te[j];G.__webglColorRenderbuffer[j]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,G.__webglColorRenderbuffer[j]);let pe=r.convert(Q.format,Q.colorSpace),N=r.convert(Q.type),ee=x(Q.internalFormat,pe,N,Q.normalized,Q.colorSpace,O.isXRRenderTarget===!0),Z=Lt(O);i.renderbufferStorageMultisample(i.RENDERBUFFER,Z,ee,O.width,O.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+j,i.RENDERBUFFER,G.__webglColorRenderbuffer[j])}i.bindRenderbuffer(i.RENDERBUFFER,null),O.depthBuffer&&(G.__webglDepthRenderbuffer=i.createRenderbuffer(),vn(G.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(de){t.bindTexture(i.TEXTURE_CUBE_MAP,oe.__webglTexture),ke(i.TEXTURE_CUBE_MAP,T);for(let j=0;j<6;j++)if(T.mipmaps.length>0)for(let Q=0;Q<T.mipmaps.length;Q++)Ze(G.__webglFramebuffer[j][Q],O,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,Q);else Ze(G.__webglFramebuffer[j],O,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);M(T)?b(i.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let j=0,Q=te.length;j<Q;j++){let pe=te[j],N=n.get(pe),ee=i.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ee=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,N.__webglTexture),ke(ee,pe),Ze(G.__webglFramebuffer,O,pe,i.COLOR_ATTACHMENT0+j,ee,0),M(pe)&&b(ee)}t.unbindTexture()}else{let j=i.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(j=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,oe.__webglTexture),ke(j,T),T.mipmaps.length>0)for(let Q=0;Q<T.mipmaps.length;Q++)Ze(G.__webglFramebuffer[Q],O,T,i.COLOR_ATTACHMENT0,j,Q);else Ze(G.__webglFramebuffer,O,T,i.COLOR_ATTACHMENT0,j,0);M(T)?b(j):T.mipmaps.length>0&&i.texParameteri(j,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&pn(O)}function k(O){let T=O.textures;for(let G=0,oe=T.length;G<oe;G++){let te=T[G];if(M(te)&&te.mipmapsAutoUpdate===!0){let de=w(O),ye=n.get(te).__webglTexture;t.bindTexture(de,ye),b(de),t.unbindTexture()}}}let Nt=[];function ft(O){if(O.samples>0){if(xe(O)===!1){let T=O.textures,G=O.width,oe=O.height,te=i.COLOR_BUFFER_BIT,de=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ye=n.get(O),j=T.length>1;if(j)for(let pe=0;pe<T.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<T.length;pe++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(te|=i.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(te|=i.STENCIL_BUFFER_BIT)),j){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let N=n.get(T[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,N,0)}i.blitFramebuffer(0,0,G,oe,0,0,G,oe,te,i.NEAREST),l===!0&&(Nt.length=0,Nt.push(i.COLOR_ATTACHMENT0+pe),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Nt.push(de),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Nt))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),j)for(let pe=0;pe<T.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let N=n.get(T[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ye.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,N,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let T=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function Lt(O){return Math.min(s.maxSamples,O.samples)}function xe(O){let T=n.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Vt(O){let T=o.render.frame;u.get(O)!==T&&(u.set(O,T),O.update())}function Le(O,T){let G=O.colorSpace,oe=O.format,te=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||G!==Wn&&G!==Cs&&(nt.getTransfer(G)===Et?(oe!==jn||te!==ti)&&De("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ge("WebGLTextures: Unsupported texture color space:",G)),T}function Ve(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=Ee,this.resetTextureUnits=q,this.getTextureUnits=W,this.setTextureUnits=ge,this.setTexture2D=ae,this.setTexture2DArray=se,this.setTexture3D=ce,this.setTextureCube=re,this.rebindTextures=wt,this.setupRenderTarget=qt,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=ft,this.setupDepthRenderbuffer=pn,this.setupFrameBufferTexture=Ze,this.useMultisampledRTT=xe,this.dispose=U}function HT(i,e){function t(n,s=Cs){let r,o=nt.getTransfer(s);if(n===ti)return i.UNSIGNED_BYTE;if(n===Tu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Au)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Vf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Hf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Bf)return i.BYTE;if(n===zf)return i.SHORT;if(n===Oo)return i.UNSIGNED_SHORT;if(n===Eu)return i.INT;if(n===gi)return i.UNSIGNED_INT;if(n===Gn)return i.FLOAT;if(n===Ei)return i.HALF_FLOAT;if(n===Gf)return i.ALPHA;if(n===Wf)return i.RGB;if(n===jn)return i.RGBA;if(n===_s)return i.DEPTH_COMPONENT;if(n===Rs)return i.DEPTH_STENCIL;if(n===Ru)return i.RED;if(n===Sl)return i.RED_INTEGER;if(n===Js)return i.RG;if(n===Cu)return i.RG_INTEGER;if(n===Pu)return i.RGBA_INTEGER;if(n===Ml||n===wl||n===El||n===Tl)if(o===Et)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ml)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===wl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===El)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Tl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ml)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===wl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===El)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Tl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Iu||n===Lu||n===Ou||n===Nu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Iu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Lu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ou)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Nu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Du||n===Uu||n===Fu||n===ku||n===Bu||n===Al||n===zu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Du||n===Uu)return o===Et?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Fu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ku)return r.COMPRESSED_R11_EAC;if(n===Bu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Al)return r.COMPRESSED_RG11_EAC;if(n===zu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Vu||n===Hu||n===Gu||n===Wu||n===Xu||n===qu||n===Yu||n===$u||n===Ku||n===Zu||n===Ju||n===ju||n===Qu||n===eh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Vu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Hu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Gu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Wu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Xu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===qu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Yu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===$u)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Ku)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Zu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ju)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ju)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Qu)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===eh)return o===Et?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===th||n===nh||n===ih)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===th)return o===Et?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===nh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ih)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===sh||n===rh||n===Rl||n===oh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===sh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===rh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Rl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===oh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ur?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var GT=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,WT=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,fp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new al(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new un({vertexShader:GT,fragmentShader:WT,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Tt(new Gi(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},pp=class extends ki{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null,y=typeof XRWebGLBinding<"u",m=new fp,_={},v=t.getContextAttributes(),M=null,b=null,w=[],x=[],p=new Ue,S=null,A=null,E=new an;E.viewport=new ot;let C=new an;C.viewport=new ot;let I=[E,C],D=new vu,L=null,U=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let ae=w[$];return ae===void 0&&(ae=new So,w[$]=ae),ae.getTargetRaySpace()},this.getControllerGrip=function($){let ae=w[$];return ae===void 0&&(ae=new So,w[$]=ae),ae.getGripSpace()},this.getHand=function($){let ae=w[$];return ae===void 0&&(ae=new So,w[$]=ae),ae.getHandSpace()};function V($){let ae=x.indexOf($.inputSource);if(ae===-1)return;let se=w[ae];se!==void 0&&(se.update($.inputSource,$.frame,c||o),se.dispatchEvent({type:$.type,data:$.inputSource}))}function B(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",ne);for(let $=0;$<w.length;$++){let ae=x[$];ae!==null&&(x[$]=null,w[$].disconnect(ae))}L=null,U=null,m.reset();for(let $ in _)delete _[$];if(e.setRenderTarget(M),f=null,d=null,h=null,s=null,b=null,Ee.stop(),n.isPresenting=!1,e.setPixelRatio(S),e.setSize(p.width,p.height,!1),A!==null){let $=A.camera;$.fov=A.fov,$.zoom=A.zoom,$.updateProjectionMatrix(),A=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,n.isPresenting===!0&&De("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,n.isPresenting===!0&&De("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",B),s.addEventListener("inputsourceschange",ne),v.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(p),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let se=null,ce=null,re=null;v.depth&&(re=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,se=v.stencil?Rs:_s,ce=v.stencil?Ur:gi);let he={colorFormat:t.RGBA8,depthFormat:re,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(he),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Fn(d.textureWidth,d.textureHeight,{format:jn,type:ti,depthTexture:new vs(d.textureWidth,d.textureHeight,ce,void 0,void 0,void 0,void 0,void 0,void 0,se),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let se={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,se),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Fn(f.framebufferWidth,f.framebufferHeight,{format:jn,type:ti,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Ee.setContext(s),Ee.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ne($){for(let ae=0;ae<$.removed.length;ae++){let se=$.removed[ae],ce=x.indexOf(se);ce>=0&&(x[ce]=null,w[ce].disconnect(se))}for(let ae=0;ae<$.added.length;ae++){let se=$.added[ae],ce=x.indexOf(se);if(ce===-1){for(let he=0;he<w.length;he++)if(he>=x.length){x.push(se),ce=he;break}else if(x[he]===null){x[he]=se,ce=he;break}if(ce===-1)break}let re=w[ce];re&&re.connect(se)}}function z($,ae){ae===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(ae.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let ae=$.near,se=$.far;m.texture!==null&&(m.depthNear>0&&(ae=m.depthNear),m.depthFar>0&&(se=m.depthFar)),D.near=C.near=E.near=ae,D.far=C.far=E.far=se,(L!==D.near||U!==D.far)&&(s.updateRenderState({depthNear:D.near,depthFar:D.far}),L=D.near,U=D.far),D.layers.mask=$.layers.mask|6,E.layers.mask=D.layers.mask&-5,C.layers.mask=D.layers.mask&-3;let ce=$.parent,re=D.cameras;z(D,ce);for(let he=0;he<re.length;he++)z(re[he],ce);D.projectionMatrix.copy(E.projectionMatrix),D.projectionMatrixInverse.copy(E.projectionMatrixInverse),A===null&&$.isPerspectiveCamera&&(A={camera:$,fov:$.fov,zoom:$.zoom}),q($,D,ce)};function q($,ae,se){se===null?$.matrix.copy(ae.matrixWorld):($.matrix.copy(se.matrixWorld),$.matrix.invert(),$.matrix.multiply(ae.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(ae.projectionMatrix),$.projectionMatrixInverse.copy(ae.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=Rr*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return D},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function($){l=$,d!==null&&(d.fixedFoveation=$),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=$)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(D)},this.getCameraTexture=function($){return _[$]};let W=null;function ge($,ae){if(u=ae.getViewerPose(c||o),g=ae,u!==null){let se=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let ce=!1;se.length!==D.cameras.length&&(D.cameras.length=0,ce=!0);for(let Te=0;Te<se.length;Te++){let ke=se[Te],Ie=null;if(f!==null)Ie=f.getViewport(ke);else{let dt=h.getViewSubImage(d,ke);Ie=dt.viewport,Te===0&&(e.setRenderTargetTextures(b,dt.colorTexture,dt.depthStencilTexture),e.setRenderTarget(b))}let Se=I[Te];Se===void 0&&(Se=new an,Se.layers.enable(Te),Se.viewport=new ot,I[Te]=Se),Se.matrix.fromArray(ke.transform.matrix),Se.matrix.decompose(Se.position,Se.quaternion,Se.scale),Se.projectionMatrix.fromArray(ke.projectionMatrix),Se.projectionMatrixInverse.copy(Se.projectionMatrix).invert(),Se.viewport.set(Ie.x,Ie.y,Ie.width,Ie.height),Te===0&&(D.matrix.copy(Se.matrix),D.matrix.decompose(D.position,D.quaternion,D.scale)),ce===!0&&D.cameras.push(Se)}let re=s.enabledFeatures;if(re&&re.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=n.getBinding();let Te=h.getDepthInformation(se[0]);Te&&Te.isValid&&Te.texture&&m.init(Te,s.renderState)}if(re&&re.includes("camera-access")&&y){e.state.unbindTexture(),h=n.getBinding();for(let Te=0;Te<se.length;Te++){let ke=se[Te].camera;if(ke){let Ie=_[ke];Ie||(Ie=new al,_[ke]=Ie);let Se=h.getCameraImage(ke);Ie.sourceTexture=Se}}}}for(let se=0;se<w.length;se++){let ce=x[se],re=w[se];ce!==null&&re!==void 0&&re.update(ce,ae,c||o)}W&&W($,ae),ae.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ae}),g=null}let Ee=new H_;Ee.setAnimationLoop(ge),this.setAnimationLoop=function($){W=$},this.dispose=function(){}}},XT=new Re,j_=new qe;j_.set(-1,0,0,0,1,0,0,0,1);function qT(i,e){function t(m,_){m.matrixAutoUpdate===!0&&m.updateMatrix(),_.value.copy(m.matrix)}function n(m,_){_.color.getRGB(m.fogColor.value,tp(i)),_.isFog?(m.fogNear.value=_.near,m.fogFar.value=_.far):_.isFogExp2&&(m.fogDensity.value=_.density)}function s(m,_,v,M,b){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(m,_):_.isMeshLambertMaterial?(r(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(m,_),h(m,_)):_.isMeshPhongMaterial?(r(m,_),u(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(m,_),d(m,_),_.isMeshPhysicalMaterial&&f(m,_,b)):_.isMeshMatcapMaterial?(r(m,_),g(m,_)):_.isMeshDepthMaterial?r(m,_):_.isMeshDistanceMaterial?(r(m,_),y(m,_)):_.isMeshNormalMaterial?r(m,_):_.isLineBasicMaterial?(o(m,_),_.isLineDashedMaterial&&a(m,_)):_.isPointsMaterial?l(m,_,v,M):_.isSpriteMaterial?c(m,_):_.isShadowMaterial?(m.color.value.copy(_.color),m.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(m,_){m.opacity.value=_.opacity,_.color&&m.diffuse.value.copy(_.color),_.emissive&&m.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(m.map.value=_.map,t(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.bumpMap&&(m.bumpMap.value=_.bumpMap,t(_.bumpMap,m.bumpMapTransform),m.bumpScale.value=_.bumpScale,_.side===Mn&&(m.bumpScale.value*=-1)),_.normalMap&&(m.normalMap.value=_.normalMap,t(_.normalMap,m.normalMapTransform),m.normalScale.value.copy(_.normalScale),_.side===Mn&&m.normalScale.value.negate()),_.displacementMap&&(m.displacementMap.value=_.displacementMap,t(_.displacementMap,m.displacementMapTransform),m.displacementScale.value=_.displacementScale,m.displacementBias.value=_.displacementBias),_.emissiveMap&&(m.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,m.emissiveMapTransform)),_.specularMap&&(m.specularMap.value=_.specularMap,t(_.specularMap,m.specularMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest);let v=e.get(_),M=v.envMap,b=v.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(XT.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(j_),m.reflectivity.value=_.reflectivity,m.ior.value=_.ior,m.refractionRatio.value=_.refractionRatio),_.lightMap&&(m.lightMap.value=_.lightMap,m.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,m.lightMapTransform)),_.aoMap&&(m.aoMap.value=_.aoMap,m.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,m.aoMapTransform))}function o(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,_.map&&(m.map.value=_.map,t(_.map,m.mapTransform))}function a(m,_){m.dashSize.value=_.dashSize,m.totalSize.value=_.dashSize+_.gapSize,m.scale.value=_.scale}function l(m,_,v,M){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.size.value=_.size*v,m.scale.value=M*.5,_.map&&(m.map.value=_.map,t(_.map,m.uvTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function c(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.rotation.value=_.rotation,_.map&&(m.map.value=_.map,t(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function u(m,_){m.specular.value.copy(_.specular),m.shininess.value=Math.max(_.shininess,1e-4)}function h(m,_){_.gradientMap&&(m.gradientMap.value=_.gradientMap)}function d(m,_){m.metalness.value=_.metalness,_.metalnessMap&&(m.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,m.metalnessMapTransform)),m.roughness.value=_.roughness,_.roughnessMap&&(m.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,m.roughnessMapTransform)),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)}function f(m,_,v){m.ior.value=_.ior,_.diffuseRoughness>0&&(m.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),_.sheen>0&&(m.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),m.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(m.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,m.sheenColorMapTransform)),_.sheenRoughnessMap&&(m.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,m.sheenRoughnessMapTransform))),_.clearcoat>0&&(m.clearcoat.value=_.clearcoat,m.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(m.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,m.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(m.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===Mn&&m.clearcoatNormalScale.value.negate())),_.dispersion>0&&(m.dispersion.value=_.dispersion),_.retroreflectivity>0&&(m.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(m.iridescence.value=_.iridescence,m.iridescenceIOR.value=_.iridescenceIOR,m.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(m.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,m.iridescenceMapTransform)),_.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),_.transmission>0&&(m.transmission.value=_.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),_.transmissionMap&&(m.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,m.transmissionMapTransform)),m.thickness.value=_.thickness,_.thicknessMap&&(m.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=_.attenuationDistance,m.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(m.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(m.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=_.specularIntensity,m.specularColor.value.copy(_.specularColor),_.specularColorMap&&(m.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,m.specularColorMapTransform)),_.specularIntensityMap&&(m.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,_){_.matcap&&(m.matcap.value=_.matcap)}function y(m,_){let v=e.get(_).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function YT(i,e,t,n){let s={},r={};function o(v,M){let b=M.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,M){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let w=M.program;n.updateUBOMapping(v,w);let x=e.render.frame;r[v.id]!==x&&(c(v),r[v.id]=x)}function l(v){let M=i.createBuffer(),b=v.__size,w=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,w),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],b=v.uniforms,w=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let x=0,p=b.length;x<p;x++){let S=b[x];if(Array.isArray(S))for(let A=0,E=S.length;A<E;A++)u(S[A],x,A,w);else u(S,x,0,w)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,M,b,w){if(d(v,M,b,w)===!0){let x=v.__offset,p=v.value;if(Array.isArray(p)){let S=0;for(let A=0;A<p.length;A++){let E=p[A],C=y(E,!0);h(E,v.__data,S),S+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else h(p,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,x,v.__data)}}function h(v,M,b){typeof v=="number"||typeof v=="boolean"?M[b]=v:v.isMatrix3?(M[b]=v.elements[0],M[b+1]=v.elements[1],M[b+2]=v.elements[2],M[b+3]=0,M[b+4]=v.elements[3],M[b+5]=v.elements[4],M[b+6]=v.elements[5],M[b+7]=0,M[b+8]=v.elements[6],M[b+9]=v.elements[7],M[b+10]=v.elements[8],M[b+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-b),b):v.toArray(M,b)}function d(v,M,b,w){let x=v.value,p=M+"_"+b;if(Array.isArray(x)){w[p]===void 0&&(w[p]=[]);let S=w[p],A=!1;for(let E=0;E<x.length;E++)f(x[E],S,E)===!0&&(A=!0);return A}return f(x,w,p)}function f(v,M,b){if(M[b]===void 0)return typeof v=="number"||typeof v=="boolean"?M[b]=v:ArrayBuffer.isView(v)?M[b]=v.slice():M[b]=v.clone(),!0;{let w=M[b];if(typeof v=="number"||typeof v=="boolean"){if(w!==v)return M[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(w.equals(v)===!1)return w.copy(v),!0}}return!1}function g(v){let M=v.uniforms,b=0,w=16;for(let p=0,S=M.length;p<S;p++){let A=Array.isArray(M[p])?M[p]:[M[p]];for(let E=0,C=A.length;E<C;E++){let I=A[E],D=Array.isArray(I.value)?I.value:[I.value],L=Array.isArray(M[p])||Array.isArray(I.value),U=b;for(let B=0,ne=D.length;B<ne;B++){let z=D[B],q=y(z,L),W=b%w,ge=W%q.boundary,Ee=W+ge;b+=ge,Ee!==0&&w-Ee<q.storage&&(b+=w-Ee),B===0&&(U=b),b+=q.storage}let V=I.type==="int"?Int32Array:I.type==="uint"?Uint32Array:Float32Array;I.__data=new V((b-U)/Float32Array.BYTES_PER_ELEMENT),I.__offset=U}}let x=b%w;return x>0&&(b+=w-x),v.__size=b,v.__cache={},this}function y(v,M){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?De("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):De("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let M=v.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function _(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:_}}var $T=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ki=null;function KT(){return Ki===null&&(Ki=new gs($T,16,16,Js,Ei),Ki.name="DFG_LUT",Ki.minFilter=cn,Ki.magFilter=cn,Ki.wrapS=di,Ki.wrapT=di,Ki.generateMipmaps=!1,Ki.needsUpdate=!0),Ki}var hh=class{constructor(e={}){let{canvas:t=p_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ti}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=f,m=new Set([Pu,Cu,Sl]),_=new Set([ti,gi,Oo,Ur,Tu,Au]),v=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},w=null,x=null,p=[],S=[],A=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Yi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let E=this,C=!1,I=null,D=null,L=null,U=null;this._outputColorSpace=on;let V=0,B=0,ne=null,z=-1,q=null,W=new ot,ge=new ot,Ee=null,$=new Ne(0),ae=0,se=t.width,ce=t.height,re=1,he=null,We=null,Te=new ot(0,0,se,ce),ke=new ot(0,0,se,ce),Ie=!1,Se=new ys,dt=new il,ze=!1,st=!1,Ze=new Re,vn=new P,Pt=new ot,pn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},wt=!1;function qt(){return ne===null?re:1}let k=n;function Nt(R,F){return t.getContext(R,F)}let ft,Lt,xe,Vt,Le,Ve,O,T,G,oe,te,de,ye,j,Q,pe,N,ee,Z,me,ue,fe,Fe;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Me,!1),k===null){let F="webgl2";if(k=Nt(F,R),k===null)throw Nt(F)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(R){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Me,!1),Ge("WebGLRenderer: "+R.message),R}function tt(){ft=new oE(k),ft.init(),ue=new HT(k,ft),Lt=new Kw(k,ft,e,ue),xe=new zT(k,ft),Lt.reversedDepthBuffer&&d&&xe.buffers.depth.setReversed(!0),D=k.createFramebuffer(),L=k.createFramebuffer(),U=k.createFramebuffer(),Vt=new cE(k),Le=new TT,Ve=new VT(k,ft,xe,Le,Lt,ue,Vt),O=new rE(E),T=new hS(k),fe=new Yw(k,T),G=new aE(k,T,Vt,fe),oe=new hE(k,G,T,fe,Vt),ee=new uE(k,Lt,Ve),Q=new Zw(Le),te=new ET(E,O,ft,Lt,fe,Q),de=new qT(E,Le),ye=new RT,j=new NT(ft),N=new qw(E,O,xe,oe,g,l),pe=new BT(E,oe,Lt),Fe=new YT(k,Vt,Lt,xe),Z=new $w(k,ft,Vt),me=new lE(k,ft,Vt),Vt.programs=te.programs,E.capabilities=Lt,E.extensions=ft,E.properties=Le,E.renderLists=ye,E.shadowMap=pe,E.state=xe,E.info=Vt}y!==ti&&(A=new fE(y,t.width,t.height,a,s,r));let le=new pp(E,k);this.xr=le,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=ft.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=ft.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return re},this.setPixelRatio=function(R){R!==void 0&&(re=R,this.setSize(se,ce,!1))},this.getSize=function(R){return R.set(se,ce)},this.setSize=function(R,F,K=!0){if(le.isPresenting){De("WebGLRenderer: Can't change size while VR device is presenting.");return}se=R,ce=F,t.width=Math.floor(R*re),t.height=Math.floor(F*re),K===!0&&(t.style.width=R+"px",t.style.height=F+"px"),A!==null&&A.setSize(t.width,t.height),this.setViewport(0,0,R,F)},this.getDrawingBufferSize=function(R){return R.set(se*re,ce*re).floor()},this.setDrawingBufferSize=function(R,F,K){se=R,ce=F,re=K,t.width=Math.floor(R*K),t.height=Math.floor(F*K),this.setViewport(0,0,R,F)},this.setEffects=function(R){if(y===ti){Ge("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let F=0;F<R.length;F++)if(R[F].isOutputPass===!0){De("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}A.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(W)},this.getViewport=function(R){return R.copy(Te)},this.setViewport=function(R,F,K,H){R.isVector4?Te.set(R.x,R.y,R.z,R.w):Te.set(R,F,K,H),xe.viewport(W.copy(Te).multiplyScalar(qt()).round())},this.getScissor=function(R){return R.copy(ke)},this.setScissor=function(R,F,K,H){R.isVector4?ke.set(R.x,R.y,R.z,R.w):ke.set(R,F,K,H),xe.scissor(ge.copy(ke).multiplyScalar(qt()).round())},this.getScissorTest=function(){return Ie},this.setScissorTest=function(R){xe.setScissorTest(Ie=R)},this.setOpaqueSort=function(R){he=R},this.setTransparentSort=function(R){We=R},this.getClearColor=function(R){return R.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(R=!0,F=!0,K=!0){let H=0;if(R){let X=!1;if(ne!==null){let ve=ne.texture.format;X=m.has(ve)}if(X){let ve=ne.texture.type,Ae=_.has(ve),_e=N.getClearColor(),we=N.getClearAlpha(),Oe=_e.r,$e=_e.g,lt=_e.b;Ae?(v[0]=Oe,v[1]=$e,v[2]=lt,v[3]=we,k.clearBufferuiv(k.COLOR,0,v)):(M[0]=Oe,M[1]=$e,M[2]=lt,M[3]=we,k.clearBufferiv(k.COLOR,0,M))}else H|=k.COLOR_BUFFER_BIT}F&&(H|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(H|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H!==0&&k.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),I=R},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Me,!1),N.dispose(),ye.dispose(),j.dispose(),Ve.dispose(),Le.dispose(),O.dispose(),oe.dispose(),G.dispose(),fe.dispose(),Fe.dispose(),te.dispose(),le.dispose(),le.removeEventListener("sessionstart",fg),le.removeEventListener("sessionend",pg),hr.stop()};function Be(R){R.preventDefault(),Ka("WebGLRenderer: Context Lost."),C=!0}function Je(){Ka("WebGLRenderer: Context Restored."),C=!1;let R=Vt.autoReset,F=pe.enabled,K=pe.autoUpdate,H=pe.needsUpdate,X=pe.type;tt(),Vt.autoReset=R,pe.enabled=F,pe.autoUpdate=K,pe.needsUpdate=H,pe.type=X}function Me(R){Ge("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function It(R){let F=R.target;F.removeEventListener("dispose",It),mn(F)}function mn(R){Fs(R),Le.remove(R)}function Fs(R){let F=Le.get(R).programs;F!==void 0&&(F.forEach(function(K){te.releaseProgram(K)}),R.isShaderMaterial&&te.releaseShaderCache(R))}this.renderBufferDirect=function(R,F,K,H,X,ve){F===null&&(F=pn);let Ae=X.isMesh&&X.matrixWorld.determinantAffine()<0,_e=Iv(R,F,K,H,X);xe.setMaterial(H,Ae);let we=K.index,Oe=1;if(H.wireframe===!0){if(we=G.getWireframeAttribute(K),we===void 0)return;Oe=2}let $e=K.drawRange,lt=K.attributes.position,Ce=$e.start*Oe,ct=($e.start+$e.count)*Oe;ve!==null&&(Ce=Math.max(Ce,ve.start*Oe),ct=Math.min(ct,(ve.start+ve.count)*Oe)),we!==null?(Ce=Math.max(Ce,0),ct=Math.min(ct,we.count)):lt!=null&&(Ce=Math.max(Ce,0),ct=Math.min(ct,lt.count));let nn=ct-Ce;if(nn<0||nn===1/0)return;fe.setup(X,H,_e,K,we);let Ht,Dt=Z;if(we!==null&&(Ht=T.get(we),Dt=me,Dt.setIndex(Ht)),X.isMesh)H.wireframe===!0?(xe.setLineWidth(H.wireframeLinewidth*qt()),Dt.setMode(k.LINES)):Dt.setMode(k.TRIANGLES);else if(X.isLine){let Cn=H.linewidth;Cn===void 0&&(Cn=1),xe.setLineWidth(Cn*qt()),X.isLineSegments?Dt.setMode(k.LINES):X.isLineLoop?Dt.setMode(k.LINE_LOOP):Dt.setMode(k.LINE_STRIP)}else X.isPoints?Dt.setMode(k.POINTS):X.isSprite&&Dt.setMode(k.TRIANGLES);if(X.isBatchedMesh)if(ft.get("WEBGL_multi_draw"))Dt.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{let Cn=X._multiDrawStarts,Pe=X._multiDrawCounts,zn=X._multiDrawCount,vt=we?T.get(we).bytesPerElement:1,dr=Le.get(H).currentProgram.getUniforms();for(let Pn=0;Pn<zn;Pn++)dr.setValue(k,"_gl_DrawID",Pn),Dt.render(Cn[Pn]/vt,Pe[Pn])}else if(X.isInstancedMesh)Dt.renderInstances(Ce,nn,X.count);else if(K.isInstancedBufferGeometry){let Cn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Pe=Math.min(K.instanceCount,Cn);Dt.renderInstances(Ce,nn,Pe)}else Dt.render(Ce,nn)};function dg(R,F,K,H){I!==null&&R.isNodeMaterial&&I.setObject(H,R),ze===!0&&Q.setState(R,K,!1),R.transparent===!0&&R.side===rn&&R.forceSinglePass===!1?(R.side=Mn,R.needsUpdate=!0,ga(R,F,H),R.side=oi,R.needsUpdate=!0,ga(R,F,H),R.side=rn):ga(R,F,H)}this.compile=function(R,F,K=null){K===null&&(K=R),I!==null&&I.renderStart(R,F,K),x=j.get(K),x.init(F),S.push(x),K.traverseVisible(function(X){X.isLight&&X.layers.test(F.layers)&&(x.pushLight(X),X.castShadow&&x.pushShadow(X))}),R!==K&&R.traverseVisible(function(X){X.isLight&&X.layers.test(F.layers)&&(x.pushLight(X),X.castShadow&&x.pushShadow(X))}),x.setupLights(),I!==null&&I.updateLights(x.state.lightsArray),st=this.localClippingEnabled,ze=Q.init(this.clippingPlanes,st),ze===!0&&Q.setGlobalState(this.clippingPlanes,F),I!==null&&pe.render(x.state.shadowsArray,K,F);let H=new Set;return R.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;let ve=X.material;if(ve)if(Array.isArray(ve))for(let Ae=0;Ae<ve.length;Ae++){let _e=ve[Ae];dg(_e,K,F,X),H.add(_e)}else dg(ve,K,F,X),H.add(ve)}),x=S.pop(),I!==null&&I.renderEnd(),H},this.compileAsync=function(R,F,K=null){let H=this.compile(R,F,K);return new Promise(X=>{function ve(){if(H.forEach(function(Ae){let we=Le.get(Ae).currentProgram;(we===void 0||we.isReady())&&H.delete(Ae)}),H.size===0){X(R);return}setTimeout(ve,10)}ft.get("KHR_parallel_shader_compile")!==null?ve():setTimeout(ve,10)})};let Ed=null;function Cv(R){Ed&&Ed(R)}function fg(){hr.stop()}function pg(){hr.start()}let hr=new H_;hr.setAnimationLoop(Cv),typeof self<"u"&&hr.setContext(self),this.setAnimationLoop=function(R){Ed=R,le.setAnimationLoop(R),R===null?hr.stop():hr.start()},le.addEventListener("sessionstart",fg),le.addEventListener("sessionend",pg),this.render=function(R,F){if(F!==void 0&&F.isCamera!==!0){Ge("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;I!==null&&I.renderStart(R,F);let K=le.enabled===!0&&le.isPresenting===!0,H=A!==null&&(ne===null||K)&&A.begin(E,ne);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),F.parent===null&&F.matrixWorldAutoUpdate===!0&&F.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(A===null||A.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(F),F=le.getCamera()),R.isScene===!0&&R.onBeforeRender(E,R,F,ne),x=j.get(R,S.length),x.init(F),x.state.textureUnits=Ve.getTextureUnits(),S.push(x),Ze.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),F.isArrayCamera?dt.setFromArrayCamera(F):Se.setFromProjectionMatrix(Ze,fi,F.reversedDepth),st=this.localClippingEnabled,ze=Q.init(this.clippingPlanes,st),w=ye.get(R,p.length),w.init(),p.push(w),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Ae=E.xr.getDepthSensingMesh();Ae!==null&&Td(Ae,F,-1/0,E.sortObjects)}Td(R,F,0,E.sortObjects),w.finish(),I!==null&&I.updateLights(x.state.lightsArray),E.sortObjects===!0&&w.sort(he,We),wt=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,wt&&N.addToRenderList(w,R),this.info.autoReset===!0&&this.info.reset(),ze===!0&&Q.beginShadows();let X=x.state.shadowsArray;if(pe.render(X,R,F),ze===!0&&Q.endShadows(),(H&&A.hasRenderPass())===!1){let Ae=w.opaque,_e=w.transmissive;if(x.setupLights(),F.isArrayCamera){let we=F.cameras;if(_e.length>0)for(let Oe=0,$e=we.length;Oe<$e;Oe++){let lt=we[Oe];gg(Ae,_e,R,lt)}wt&&N.render(R);for(let Oe=0,$e=we.length;Oe<$e;Oe++){let lt=we[Oe];mg(w,R,lt,lt.viewport)}}else _e.length>0&&gg(Ae,_e,R,F),wt&&N.render(R),mg(w,R,F)}ne!==null&&B===0&&(Ve.updateMultisampleRenderTarget(ne),Ve.updateRenderTargetMipmap(ne)),H&&A.end(E),R.isScene===!0&&R.onAfterRender(E,R,F),fe.resetDefaultState(),z=-1,q=null,S.pop(),S.length>0?(x=S[S.length-1],Ve.setTextureUnits(x.state.textureUnits),ze===!0&&Q.setGlobalState(E.clippingPlanes,x.state.camera)):x=null,p.pop(),p.length>0?w=p[p.length-1]:w=null,I!==null&&I.renderEnd()};function Td(R,F,K,H){if(R.visible===!1)return;if(R.layers.test(F.layers)){if(R.isGroup)K=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(F);else if(R.isLight)x.pushLight(R),R.castShadow&&x.pushShadow(R);else if(R.isSprite){let Ae=F.isArrayCamera?dt:Se;if(!R.frustumCulled||R.intersectsFrustum(Ae)){H&&Pt.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ze);let _e=oe.update(R),we=R.material;we.visible&&w.push(R,_e,we,K,Pt.z,null,F)}}else if(R.isMesh||R.isLine||R.isPoints){let Ae=F.isArrayCamera?dt:Se;if(!R.frustumCulled||R.intersectsFrustum(Ae)){let _e=oe.update(R),we=R.material;if(H&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Pt.copy(R.boundingSphere.center)):(_e.boundingSphere===null&&_e.computeBoundingSphere(),Pt.copy(_e.boundingSphere.center)),Pt.applyMatrix4(R.matrixWorld).applyMatrix4(Ze)),Array.isArray(we)){let Oe=_e.groups;for(let $e=0,lt=Oe.length;$e<lt;$e++){let Ce=Oe[$e],ct=we[Ce.materialIndex];ct&&ct.visible&&w.push(R,_e,ct,K,Pt.z,Ce,F)}}else we.visible&&w.push(R,_e,we,K,Pt.z,null,F)}}}let ve=R.children;for(let Ae=0,_e=ve.length;Ae<_e;Ae++)Td(ve[Ae],F,K,H)}function mg(R,F,K,H){let{opaque:X,transmissive:ve,transparent:Ae}=R;x.setupLightsView(K),ze===!0&&Q.setGlobalState(E.clippingPlanes,K),H&&xe.viewport(W.copy(H)),X.length>0&&cc(X,F,K),ve.length>0&&cc(ve,F,K),Ae.length>0&&cc(Ae,F,K),xe.buffers.depth.setTest(!0),xe.buffers.depth.setMask(!0),xe.buffers.color.setMask(!0),xe.setPolygonOffset(!1)}function gg(R,F,K,H){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(x.state.transmissionRenderTarget[H.id]===void 0){let Ce=ft.has("EXT_color_buffer_half_float")||ft.has("EXT_color_buffer_float");x.state.transmissionRenderTarget[H.id]=new Fn(1,1,{generateMipmaps:!0,type:Ce?Ei:ti,minFilter:mi,samples:Math.max(4,Lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:nt.workingColorSpace})}let ve=x.state.transmissionRenderTarget[H.id],Ae=H.viewport||W;ve.setSize(Ae.z*E.transmissionResolutionScale,Ae.w*E.transmissionResolutionScale);let _e=E.getRenderTarget(),we=E.getActiveCubeFace(),Oe=E.getActiveMipmapLevel();E.setRenderTarget(ve),E.getClearColor($),ae=E.getClearAlpha(),ae<1&&E.setClearColor(16777215,.5),E.clear(),wt&&N.render(K);let $e=E.toneMapping;E.toneMapping=Yi;let lt=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),x.setupLightsView(H),ze===!0&&Q.setGlobalState(E.clippingPlanes,H),cc(R,K,H),Ve.updateMultisampleRenderTarget(ve),Ve.updateRenderTargetMipmap(ve),ft.has("WEBGL_multisampled_render_to_texture")===!1){let Ce=!1;for(let ct=0,nn=F.length;ct<nn;ct++){let Ht=F[ct],{object:Dt,geometry:Cn,material:Pe,group:zn}=Ht;if(Pe.side===rn&&Dt.layers.test(H.layers)){let vt=Pe.side;Pe.side=Mn,Pe.needsUpdate=!0,_g(Dt,K,H,Cn,Pe,zn),Pe.side=vt,Pe.needsUpdate=!0,Ce=!0}}Ce===!0&&(Ve.updateMultisampleRenderTarget(ve),Ve.updateRenderTargetMipmap(ve))}E.setRenderTarget(_e,we,Oe),E.setClearColor($,ae),lt!==void 0&&(H.viewport=lt),E.toneMapping=$e}function cc(R,F,K){let H=F.isScene===!0?F.overrideMaterial:null;for(let X=0,ve=R.length;X<ve;X++){let Ae=R[X],{object:_e,geometry:we,group:Oe}=Ae,$e=Ae.material;$e.allowOverride===!0&&H!==null&&($e=H),_e.layers.test(K.layers)&&_g(_e,F,K,we,$e,Oe)}}function _g(R,F,K,H,X,ve){I!==null&&X.isNodeMaterial&&I.setObject(R,X),R.onBeforeRender(E,F,K,H,X,ve),R.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),X.onBeforeRender(E,F,K,H,R,ve),X.transparent===!0&&X.side===rn&&X.forceSinglePass===!1?(X.side=Mn,X.needsUpdate=!0,E.renderBufferDirect(K,F,H,X,R,ve),X.side=oi,X.needsUpdate=!0,E.renderBufferDirect(K,F,H,X,R,ve),X.side=rn):E.renderBufferDirect(K,F,H,X,R,ve),R.onAfterRender(E,F,K,H,X,ve)}function xg(R){let F=0;for(let K of R)K.texture!==null&&F++;return F}function ga(R,F,K){F.isScene!==!0&&(F=pn);let H=Le.get(R),X=x.state.lights,ve=x.state.shadowsArray,Ae=X.state.version,_e=te.getParameters(R,X.state,ve,F,K,x.state.lightProbeGridArray),we=te.getProgramCacheKey(_e),Oe=H.programs;H.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?F.environment:null,H.fog=F.fog;let $e=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;H.envMap=O.get(R.envMap||H.environment,$e),H.envMapRotation=H.environment!==null&&R.envMap===null?F.environmentRotation:R.envMapRotation,Oe===void 0&&(R.addEventListener("dispose",It),Oe=new Map,H.programs=Oe,H.programVariants=new Map);let lt=Oe.get(we);if(lt!==void 0){if(H.currentProgram===lt&&H.lightsStateVersion===Ae)return vg(R,_e),lt}else _e.uniforms=te.getUniforms(R),I!==null&&R.isNodeMaterial&&I.build(R,K,_e),R.onBeforeCompile(_e,E),lt=te.acquireProgram(_e,we),Oe.set(we,lt),H.uniforms=_e.uniforms;let Ce=H.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Ce.clippingPlanes=Q.uniform),vg(R,_e),H.needsLights=Ov(R),H.lightsStateVersion=Ae,H.needsLights&&(Ce.ambientLightColor.value=X.state.ambient,Ce.lightProbe.value=X.state.probe,Ce.sunLights.value=X.state.sun,Ce.sunLightShadows.value=X.state.sunShadow,Ce.directionalLights.value=X.state.directional,Ce.directionalLightShadows.value=X.state.directionalShadow,Ce.spotLights.value=X.state.spot,Ce.spotLightShadows.value=X.state.spotShadow,Ce.rectAreaLights.value=X.state.rectArea,Ce.ltc_1.value=X.state.rectAreaLTC1,Ce.ltc_2.value=X.state.rectAreaLTC2,Ce.pointLights.value=X.state.point,Ce.pointLightShadows.value=X.state.pointShadow,Ce.hemisphereLights.value=X.state.hemi,Ce.sunShadowMatrix.value=X.state.sunShadowMatrix,Ce.sunShadowCascade.value=X.state.sunShadowCascade,Ce.directionalShadowMatrix.value=X.state.directionalShadowMatrix,Ce.spotLightMatrix.value=X.state.spotLightMatrix,Ce.spotLightMap.value=X.state.spotLightMap,Ce.pointShadowMatrix.value=X.state.pointShadowMatrix),H.numLightProbeGrids=xg(x.state.lightProbeGridArray),H.currentProgram=lt,H.uniformsList=null,lt}function Pv(R,F,K,H,X){let ve=Le.get(R),Ae=ve.currentProgram.id+","+H+","+X,_e=ve.programVariants.get(Ae);return _e===void 0?(_e=ga(R,F,K),ve.programVariants.set(Ae,_e)):(ve.currentProgram=_e,ve.uniformsList=null,ve.outputColorSpace=H,ve.toneMapping=X),_e}function yg(R){if(R.uniformsList===null){let F=R.currentProgram.getUniforms();R.uniformsList=Uo.seqWithValue(F.seq,R.uniforms)}return R.uniformsList}function vg(R,F){let K=Le.get(R);K.outputColorSpace=F.outputColorSpace,K.batching=F.batching,K.batchingColor=F.batchingColor,K.instancing=F.instancing,K.instancingColor=F.instancingColor,K.instancingMorph=F.instancingMorph,K.skinning=F.skinning,K.morphTargets=F.morphTargets,K.morphNormals=F.morphNormals,K.morphColors=F.morphColors,K.morphTargetsCount=F.morphTargetsCount,K.numClippingPlanes=F.numClippingPlanes,K.numIntersection=F.numClipIntersection,K.vertexAlphas=F.vertexAlphas,K.vertexTangents=F.vertexTangents,K.toneMapping=F.toneMapping}function Iv(R,F,K,H,X){F.isScene!==!0&&(F=pn),Ve.resetTextureUnits();let ve=F.fog,Ae=H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial?F.environment:null,_e=ne===null?E.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:nt.workingColorSpace,we=H.isMeshStandardMaterial||H.isMeshLambertMaterial&&!H.envMap||H.isMeshPhongMaterial&&!H.envMap,Oe=O.get(H.envMap||Ae,we),$e=H.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,lt=!!K.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Ce=!!K.morphAttributes.position,ct=!!K.morphAttributes.normal,nn=!!K.morphAttributes.color,Ht=Yi;H.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(Ht=E.toneMapping);let Dt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,Cn=Dt!==void 0?Dt.length:0,Pe=Le.get(H),zn=x.state.lights;if(ze===!0&&(st===!0||R!==q)){let Yt=R===q&&H.id===z;Q.setState(H,R,Yt)}let vt=!1,dr=!1;H.version===Pe.__version?Pe.needsLights&&Pe.lightsStateVersion!==zn.state.version||X.isBatchedMesh&&Pe.batching===!1||!X.isBatchedMesh&&Pe.batching===!0||X.isBatchedMesh&&Pe.batchingColor===!0&&X._colorsTexture===null||X.isBatchedMesh&&Pe.batchingColor===!1&&X._colorsTexture!==null||X.isInstancedMesh&&Pe.instancing===!1||!X.isInstancedMesh&&Pe.instancing===!0||X.isSkinnedMesh&&Pe.skinning===!1||!X.isSkinnedMesh&&Pe.skinning===!0||X.isInstancedMesh&&Pe.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&Pe.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&Pe.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&Pe.instancingMorph===!1&&X.morphTexture!==null||Pe.envMap!==Oe||H.fog===!0&&Pe.fog!==ve||Pe.numClippingPlanes!==void 0&&(Pe.numClippingPlanes!==Q.numPlanes||Pe.numIntersection!==Q.numIntersection)||Pe.vertexAlphas!==$e||Pe.vertexTangents!==lt||Pe.morphTargets!==Ce||Pe.morphNormals!==ct||Pe.morphColors!==nn||Pe.morphTargetsCount!==Cn||Pe.numLightProbeGrids!==xg(x.state.lightProbeGridArray)?vt=!0:(Pe.outputColorSpace!==_e||Pe.toneMapping!==Ht)&&(dr=!0):(vt=!0,Pe.__version=H.version);let Pn=Pe.currentProgram;(vt===!0||dr===!0)&&(Pn=dr===!0?Pv(H,F,X,_e,Ht):ga(H,F,X),I&&H.isNodeMaterial&&I.onUpdateProgram(H,Pn,Pe));let uc=!1,ks=!1,fr=!1,gt=Pn.getUniforms(),bn=Pe.uniforms;if(xe.useProgram(Pn.program)&&(uc=!0,ks=!0,fr=!0),H.id!==z&&(z=H.id,ks=!0),uc||q!==R){xe.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),gt.setValue(k,"projectionMatrix",R.projectionMatrix),gt.setValue(k,"viewMatrix",R.matrixWorldInverse);let gn=gt.map.cameraPosition;gn!==void 0&&gn.setValue(k,vn.setFromMatrixPosition(R.matrixWorld)),Lt.logarithmicDepthBuffer&&gt.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&gt.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),q!==R&&(q=R,ks=!0,fr=!0)}if(Pe.needsLights&&(zn.state.sunShadowMap.length>0&&gt.setValue(k,"sunShadowMap",zn.state.sunShadowMap,Ve),zn.state.directionalShadowMap.length>0&&gt.setValue(k,"directionalShadowMap",zn.state.directionalShadowMap,Ve),zn.state.spotShadowMap.length>0&&gt.setValue(k,"spotShadowMap",zn.state.spotShadowMap,Ve),zn.state.pointShadowMap.length>0&&gt.setValue(k,"pointShadowMap",zn.state.pointShadowMap,Ve)),X.isSkinnedMesh){gt.setOptional(k,X,"bindMatrix"),gt.setOptional(k,X,"bindMatrixInverse");let Yt=X.skeleton;Yt&&(Yt.boneTexture===null&&Yt.computeBoneTexture(),gt.setValue(k,"boneTexture",Yt.boneTexture,Ve))}X.isBatchedMesh&&(gt.setOptional(k,X,"batchingTexture"),gt.setValue(k,"batchingTexture",X._matricesTexture,Ve),gt.setOptional(k,X,"batchingIdTexture"),gt.setValue(k,"batchingIdTexture",X._indirectTexture,Ve),gt.setOptional(k,X,"batchingColorTexture"),X._colorsTexture!==null&&gt.setValue(k,"batchingColorTexture",X._colorsTexture,Ve));let vi=K.morphAttributes;if((vi.position!==void 0||vi.normal!==void 0||vi.color!==void 0)&&ee.update(X,K,Pn),(ks||Pe.receiveShadow!==X.receiveShadow)&&(Pe.receiveShadow=X.receiveShadow,gt.setValue(k,"receiveShadow",X.receiveShadow)),(H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial)&&H.envMap===null&&F.environment!==null&&(bn.envMapIntensity.value=F.environmentIntensity),bn.dfgLUT!==void 0&&(bn.dfgLUT.value=KT()),ks){if(gt.setValue(k,"toneMappingExposure",E.toneMappingExposure),Pe.needsLights&&Lv(bn,fr),ve&&H.fog===!0&&de.refreshFogUniforms(bn,ve),de.refreshMaterialUniforms(bn,H,re,ce,x.state.transmissionRenderTarget[R.id]),Pe.needsLights&&Pe.numLightProbeGrids>0){let Yt=b,gn=0;for(let as of x.state.lightProbeGridArray)as.texture!==null&&(Yt.textures[gn]=as.texture,Yt.min[gn]=as.boundingBox.min,Yt.max[gn]=as.boundingBox.max,Yt.resolution[gn]=as.resolution,gn++);for(let as in Yt)Yt[as].length=gn;bn.probesSH.value=Yt.textures,bn.probesMin.value=Yt.min,bn.probesMax.value=Yt.max,bn.probesResolution.value=Yt.resolution}Uo.upload(k,yg(Pe),bn,Ve)}if(H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(Uo.upload(k,yg(Pe),bn,Ve),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&gt.setValue(k,"center",X.center),gt.setValue(k,"modelViewMatrix",X.modelViewMatrix),gt.setValue(k,"normalMatrix",X.normalMatrix),gt.setValue(k,"modelMatrix",X.matrixWorld),H.uniformsGroups!==void 0){let Yt=H.uniformsGroups;for(let gn=0,as=Yt.length;gn<as;gn++){let Sg=Yt[gn];Fe.update(Sg,Pn),Fe.bind(Sg,Pn)}}return Pn}function Lv(R,F){R.ambientLightColor.needsUpdate=F,R.lightProbe.needsUpdate=F,R.sunLights.needsUpdate=F,R.sunLightShadows.needsUpdate=F,R.directionalLights.needsUpdate=F,R.directionalLightShadows.needsUpdate=F,R.pointLights.needsUpdate=F,R.pointLightShadows.needsUpdate=F,R.spotLights.needsUpdate=F,R.spotLightShadows.needsUpdate=F,R.rectAreaLights.needsUpdate=F,R.hemisphereLights.needsUpdate=F}function Ov(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return V},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(R,F,K){let H=Le.get(R);H.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),Le.get(R.texture).__webglTexture=F,Le.get(R.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:K,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,F){let K=Le.get(R);K.__webglFramebuffer=F,K.__useDefaultFramebuffer=F===void 0},this.setRenderTarget=function(R,F=0,K=0){ne=R,V=F,B=K;let H=null,X=!1,ve=!1;if(R){let _e=Le.get(R);if(_e.__useDefaultFramebuffer!==void 0){xe.bindFramebuffer(k.FRAMEBUFFER,_e.__webglFramebuffer),W.copy(R.viewport),ge.copy(R.scissor),Ee=R.scissorTest,xe.viewport(W),xe.scissor(ge),xe.setScissorTest(Ee),z=-1;return}else if(_e.__webglFramebuffer===void 0)Ve.setupRenderTarget(R);else if(_e.__hasExternalTextures)Ve.rebindTextures(R,Le.get(R.texture).__webglTexture,Le.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let $e=R.depthTexture;if(_e.__boundDepthTexture!==$e){if($e!==null&&Le.has($e)&&(R.width!==$e.image.width||R.height!==$e.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ve.setupDepthRenderbuffer(R)}}let we=R.texture;(we.isData3DTexture||we.isDataArrayTexture||we.isCompressedArrayTexture)&&(ve=!0);let Oe=Le.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Oe[F])?H=Oe[F][K]:H=Oe[F],X=!0):R.samples>0&&Ve.useMultisampledRTT(R)===!1?H=Le.get(R).__webglMultisampledFramebuffer:Array.isArray(Oe)?H=Oe[K]:H=Oe,W.copy(R.viewport),ge.copy(R.scissor),Ee=R.scissorTest}else W.copy(Te).multiplyScalar(re).floor(),ge.copy(ke).multiplyScalar(re).floor(),Ee=Ie;if(K!==0&&(H=D),xe.bindFramebuffer(k.FRAMEBUFFER,H)&&xe.drawBuffers(R,H),xe.viewport(W),xe.scissor(ge),xe.setScissorTest(Ee),X){let _e=Le.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+F,_e.__webglTexture,K)}else if(ve){let _e=F;for(let we=0;we<R.textures.length;we++){let Oe=Le.get(R.textures[we]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+we,Oe.__webglTexture,K,_e)}}else if(R!==null&&K!==0){let _e=Le.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,_e.__webglTexture,K)}z=-1};function bg(R){let F=Le.get(R);return(F.__readFormat!==R.format||F.__readType!==R.type)&&(F.__readFormat=R.format,F.__readType=R.type,F.__formatReadable=Lt.textureFormatReadable(R.format),F.__typeReadable=Lt.textureTypeReadable(R.type)),F}this.readRenderTargetPixels=function(R,F,K,H,X,ve,Ae,_e=0){if(!(R&&R.isWebGLRenderTarget)){Ge("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let we=Le.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ae!==void 0&&(we=we[Ae],Array.isArray(we)&&(we=we[0])),we){xe.bindFramebuffer(k.FRAMEBUFFER,we);try{let Oe=R.textures[_e],$e=Oe.format,lt=Oe.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+_e);let Ce=bg(Oe);if(Ce.__formatReadable===!1){Ge("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ce.__typeReadable===!1){Ge("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}F>=0&&F<=R.width-H&&K>=0&&K<=R.height-X&&k.readPixels(F,K,H,X,ue.convert($e),ue.convert(lt),ve)}finally{let Oe=ne!==null?Le.get(ne).__webglFramebuffer:null;xe.bindFramebuffer(k.FRAMEBUFFER,Oe)}}},this.readRenderTargetPixelsAsync=async function(R,F,K,H,X,ve,Ae,_e=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let we=Le.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Ae!==void 0&&(we=we[Ae],Array.isArray(we)&&(we=we[0])),we)if(F>=0&&F<=R.width-H&&K>=0&&K<=R.height-X){xe.bindFramebuffer(k.FRAMEBUFFER,we);let Oe=R.textures[_e],$e=Oe.format,lt=Oe.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+_e);let Ce=bg(Oe);if(Ce.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ce.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ct=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,ct),k.bufferData(k.PIXEL_PACK_BUFFER,ve.byteLength,k.STREAM_READ),k.readPixels(F,K,H,X,ue.convert($e),ue.convert(lt),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let nn=ne!==null?Le.get(ne).__webglFramebuffer:null;xe.bindFramebuffer(k.FRAMEBUFFER,nn);let Ht=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await g_(k,Ht,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,ct),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,ve),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(ct),k.deleteSync(Ht),ve}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,F=null,K=0){let H=Math.pow(2,-K),X=Math.floor(R.image.width*H),ve=Math.floor(R.image.height*H),Ae=F!==null?F.x:0,_e=F!==null?F.y:0;Ve.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,K,0,0,Ae,_e,X,ve),xe.unbindTexture()},this.copyTextureToTexture=function(R,F,K=null,H=null,X=0,ve=0){let Ae,_e,we,Oe,$e,lt,Ce,ct,nn,Ht=R.isCompressedTexture?R.mipmaps[ve]:R.image;if(K!==null)Ae=K.max.x-K.min.x,_e=K.max.y-K.min.y,we=K.isBox3?K.max.z-K.min.z:1,Oe=K.min.x,$e=K.min.y,lt=K.isBox3?K.min.z:0;else{let gt=Math.pow(2,-X);Ae=Math.floor(Ht.width*gt),_e=Math.floor(Ht.height*gt),R.isDataArrayTexture?we=Ht.depth:R.isData3DTexture?we=Math.floor(Ht.depth*gt):we=1,Oe=0,$e=0,lt=0}H!==null?(Ce=H.x,ct=H.y,nn=H.z):(Ce=0,ct=0,nn=0);let Dt=ue.convert(F.format),Cn=ue.convert(F.type),Pe;F.isData3DTexture?(Ve.setTexture3D(F,0),Pe=k.TEXTURE_3D):F.isDataArrayTexture||F.isCompressedArrayTexture?(Ve.setTexture2DArray(F,0),Pe=k.TEXTURE_2D_ARRAY):(Ve.setTexture2D(F,0),Pe=k.TEXTURE_2D),xe.activeTexture(k.TEXTURE0),xe.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,F.flipY),xe.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,F.premultiplyAlpha),xe.pixelStorei(k.UNPACK_ALIGNMENT,F.unpackAlignment);let zn=xe.getParameter(k.UNPACK_ROW_LENGTH),vt=xe.getParameter(k.UNPACK_IMAGE_HEIGHT),dr=xe.getParameter(k.UNPACK_SKIP_PIXELS),Pn=xe.getParameter(k.UNPACK_SKIP_ROWS),uc=xe.getParameter(k.UNPACK_SKIP_IMAGES);xe.pixelStorei(k.UNPACK_ROW_LENGTH,Ht.width),xe.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ht.height),xe.pixelStorei(k.UNPACK_SKIP_PIXELS,Oe),xe.pixelStorei(k.UNPACK_SKIP_ROWS,$e),xe.pixelStorei(k.UNPACK_SKIP_IMAGES,lt);let ks=R.isDataArrayTexture||R.isData3DTexture,fr=F.isDataArrayTexture||F.isData3DTexture;if(R.isDepthTexture){let gt=Le.get(R),bn=Le.get(F),vi=Le.get(gt.__renderTarget),Yt=Le.get(bn.__renderTarget);xe.bindFramebuffer(k.READ_FRAMEBUFFER,vi.__webglFramebuffer),xe.bindFramebuffer(k.DRAW_FRAMEBUFFER,Yt.__webglFramebuffer);for(let gn=0;gn<we;gn++)ks&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Le.get(R).__webglTexture,X,lt+gn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Le.get(F).__webglTexture,ve,nn+gn)),k.blitFramebuffer(Oe,$e,Oe+Ae,$e+_e,Ce,ct,Ce+Ae,ct+_e,k.DEPTH_BUFFER_BIT,k.NEAREST);xe.bindFramebuffer(k.READ_FRAMEBUFFER,null),xe.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(X!==0||R.isRenderTargetTexture||Le.has(R)){let gt=Le.get(R),bn=Le.get(F);xe.bindFramebuffer(k.READ_FRAMEBUFFER,L),xe.bindFramebuffer(k.DRAW_FRAMEBUFFER,U);for(let vi=0;vi<we;vi++)ks?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,gt.__webglTexture,X,lt+vi):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,gt.__webglTexture,X),fr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,bn.__webglTexture,ve,nn+vi):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,bn.__webglTexture,ve),X!==0?k.blitFramebuffer(Oe,$e,Oe+Ae,$e+_e,Ce,ct,Ce+Ae,ct+_e,k.COLOR_BUFFER_BIT,k.NEAREST):fr?k.copyTexSubImage3D(Pe,ve,Ce,ct,nn+vi,Oe,$e,Ae,_e):k.copyTexSubImage2D(Pe,ve,Ce,ct,Oe,$e,Ae,_e);xe.bindFramebuffer(k.READ_FRAMEBUFFER,null),xe.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else fr?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Pe,ve,Ce,ct,nn,Ae,_e,we,Dt,Cn,Ht.data):F.isCompressedArrayTexture?k.compressedTexSubImage3D(Pe,ve,Ce,ct,nn,Ae,_e,we,Dt,Ht.data):k.texSubImage3D(Pe,ve,Ce,ct,nn,Ae,_e,we,Dt,Cn,Ht):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,ve,Ce,ct,Ae,_e,Dt,Cn,Ht.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,ve,Ce,ct,Ht.width,Ht.height,Dt,Ht.data):k.texSubImage2D(k.TEXTURE_2D,ve,Ce,ct,Ae,_e,Dt,Cn,Ht);xe.pixelStorei(k.UNPACK_ROW_LENGTH,zn),xe.pixelStorei(k.UNPACK_IMAGE_HEIGHT,vt),xe.pixelStorei(k.UNPACK_SKIP_PIXELS,dr),xe.pixelStorei(k.UNPACK_SKIP_ROWS,Pn),xe.pixelStorei(k.UNPACK_SKIP_IMAGES,uc),ve===0&&F.generateMipmaps===!0&&F.mipmapsAutoUpdate===!0&&k.generateMipmap(Pe),xe.unbindTexture()},this.initRenderTarget=function(R){Le.get(R).__webglFramebuffer===void 0&&Ve.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Ve.setTextureCube(R,0):R.isData3DTexture?Ve.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Ve.setTexture2DArray(R,0):Ve.setTexture2D(R,0),xe.unbindTexture()},this.resetState=function(){V=0,B=0,ne=null,xe.reset(),fe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return fi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=nt._getDrawingBufferColorSpace(e),t.unpackColorSpace=nt._getUnpackColorSpace()}};function mp(i,e){if(e===Xf)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===No||e===Cl){let t=i.getIndex();if(t===null){let r=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)r.push(a);i.setIndex(r),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,s=[];if(e===No)for(let r=1;r<=n;r++)s.push(t.getX(0)),s.push(t.getX(r)),s.push(t.getX(r+1));else for(let r=0;r<n;r++)r%2===0?(s.push(t.getX(r)),s.push(t.getX(r+1)),s.push(t.getX(r+2))):(s.push(t.getX(r+2)),s.push(t.getX(r+1)),s.push(t.getX(r)));return s.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(s),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function Q_(i){let e=new Map,t=new Map,n=i.clone();return ex(i,n,function(s,r){e.set(r,s),t.set(s,r)}),n.traverse(function(s){if(!s.isSkinnedMesh)return;let r=s,o=e.get(s),a=o.skeleton.bones;r.skeleton=o.skeleton.clone(),r.bindMatrix.copy(o.bindMatrix),r.skeleton.bones=a.map(function(l){return t.get(l)}),r.bind(r.skeleton,r.bindMatrix)}),n}function ex(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)ex(i.children[n],e.children[n],t)}var zo=class extends Xi{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new Sp(t)}),this.register(function(t){return new Mp(t)}),this.register(function(t){return new wp(t)}),this.register(function(t){return new Op(t)}),this.register(function(t){return new Np(t)}),this.register(function(t){return new Dp(t)}),this.register(function(t){return new Tp(t)}),this.register(function(t){return new Ap(t)}),this.register(function(t){return new Rp(t)}),this.register(function(t){return new Cp(t)}),this.register(function(t){return new bp(t)}),this.register(function(t){return new Pp(t)}),this.register(function(t){return new Ep(t)}),this.register(function(t){return new Lp(t)}),this.register(function(t){return new Ip(t)}),this.register(function(t){return new yp(t)}),this.register(function(t){return new ph(t,rt.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new ph(t,rt.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new Up(t)})}load(e,t,n,s){let r=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let c=As.extractUrlBase(e);o=As.resolveURL(c,this.path)}else o=As.extractUrlBase(e);this.manager.itemStart(e);let a=function(c){s?s(c):console.error(c),r.manager.itemError(e),r.manager.itemEnd(e)},l=new To(this.manager);l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.path),l.setResponseType("arraybuffer"),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials),l.load(e,function(c){try{r.parse(c,o,function(u){t(u),r.manager.itemEnd(e)},a)}catch(u){a(u)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,s){let r,o={},a={},l=new TextDecoder;if(typeof e=="string")r=JSON.parse(e);else if(e instanceof ArrayBuffer)if(l.decode(new Uint8Array(e,0,4))===rx){try{o[rt.KHR_BINARY_GLTF]=new Fp(e)}catch(h){s&&s(h);return}r=JSON.parse(o[rt.KHR_BINARY_GLTF].content)}else r=JSON.parse(l.decode(e));else r=e;if(r.asset===void 0||r.asset.version[0]<2){s&&s(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let c=new Wp(r,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});c.fileLoader.setRequestHeader(this.requestHeader);for(let u=0;u<this.pluginCallbacks.length;u++){let h=this.pluginCallbacks[u](c);h.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[h.name]=h,o[h.name]=!0}if(r.extensionsUsed)for(let u=0;u<r.extensionsUsed.length;++u){let h=r.extensionsUsed[u],d=r.extensionsRequired||[];switch(h){case rt.KHR_MATERIALS_UNLIT:o[h]=new vp;break;case rt.KHR_DRACO_MESH_COMPRESSION:o[h]=new kp(r,this.dracoLoader);break;case rt.KHR_TEXTURE_TRANSFORM:o[h]=new Bp;break;case rt.KHR_MESH_QUANTIZATION:o[h]=new zp;break;default:d.indexOf(h)>=0&&a[h]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+h+'".')}}c.setExtensions(o),c.setPlugins(a),c.parse(n,s)}parseAsync(e,t){let n=this;return new Promise(function(s,r){n.parse(e,t,s,r)})}};function ZT(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function Kt(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var rt={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},yp=class{constructor(e){this.parser=e,this.name=rt.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,s=t.length;n<s;n++){let r=t[n];r.extensions&&r.extensions[this.name]&&r.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,r.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,s=t.cache.get(n);if(s)return s;let r=t.json,l=((r.extensions&&r.extensions[this.name]||{}).lights||[])[e],c,u=new Ne(16777215);l.color!==void 0&&u.setRGB(l.color[0],l.color[1],l.color[2],Wn);let h=l.range!==void 0?l.range:0;switch(l.type){case"directional":c=new Ir(u),c.target.position.set(0,0,-1),c.add(c.target);break;case"point":c=new ml(u),c.distance=h;break;case"spot":c=new pl(u),c.distance=h,l.spot=l.spot||{},l.spot.innerConeAngle=l.spot.innerConeAngle!==void 0?l.spot.innerConeAngle:0,l.spot.outerConeAngle=l.spot.outerConeAngle!==void 0?l.spot.outerConeAngle:Math.PI/4,c.angle=l.spot.outerConeAngle,c.penumbra=1-l.spot.innerConeAngle/l.spot.outerConeAngle,c.target.position.set(0,0,-1),c.add(c.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+l.type)}return c.position.set(0,0,0),Zi(c,l),l.intensity!==void 0&&(c.intensity=l.intensity),c.name=t.createUniqueName(l.name||"light_"+e),s=Promise.resolve(c),t.cache.add(n,s),s}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,r=n.json.nodes[e],a=(r.extensions&&r.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(l){return n._getNodeRef(t.cache,a,l)})}},vp=class{constructor(){this.name=rt.KHR_MATERIALS_UNLIT}getMaterialType(){return pi}extendParams(e,t,n){let s=[];e.color=new Ne(1,1,1),e.opacity=1;let r=t.pbrMetallicRoughness;if(r){if(Array.isArray(r.baseColorFactor)){let o=r.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],Wn),e.opacity=o[3]}r.baseColorTexture!==void 0&&s.push(n.assignTexture(e,"map",r.baseColorTexture,on))}return Promise.all(s)}},bp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},Sp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(s.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let r=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new Ue(r,r)}return Promise.all(s)}},Mp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(s)}},wp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_DISPERSION}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},Ep=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(s)}},Tp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_SHEEN}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(t.sheenColor=new Ne(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let r=n.sheenColorFactor;t.sheenColor.setRGB(r[0],r[1],r[2],Wn)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,on)),n.sheenRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(s)}},Ap=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&s.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(s)}},Rp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_VOLUME}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let r=n.attenuationColor||[1,1,1];return t.attenuationColor=new Ne().setRGB(r[0],r[1],r[2],Wn),Promise.all(s)}},Cp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_IOR}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},Pp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_SPECULAR}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let r=n.specularColorFactor||[1,1,1];return t.specularColor=new Ne().setRGB(r[0],r[1],r[2],Wn),n.specularColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,on)),Promise.all(s)}},Ip=class{constructor(e){this.parser=e,this.name=rt.EXT_MATERIALS_BUMP}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&s.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(s)}},Lp=class{constructor(e){this.parser=e,this.name=rt.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return Kt(this.parser,e,this.name)!==null?Yn:null}extendMaterialParams(e,t){let n=Kt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&s.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(s)}},Op=class{constructor(e){this.parser=e,this.name=rt.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,s=n.textures[e];if(!s.extensions||!s.extensions[this.name])return null;let r=s.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,r.source,o)}},Np=class{constructor(e){this.parser=e,this.name=rt.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},Dp=class{constructor(e){this.parser=e,this.name=rt.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},ph=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let s=n.extensions[this.name],r=this.parser.getDependency("buffer",s.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return r.then(function(a){let l=s.byteOffset||0,c=s.byteLength||0,u=s.count,h=s.byteStride,d=new Uint8Array(a,l,c);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(u,h,d,s.mode,s.filter).then(function(f){return f.buffer}):o.ready.then(function(){let f=new ArrayBuffer(u*h);return o.decodeGltfBuffer(new Uint8Array(f),u,h,d,s.mode,s.filter),f})})}else return null}},Up=class{constructor(e){this.name=rt.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let s=t.meshes[n.mesh];for(let c of s.primitives)if(c.mode!==_i.TRIANGLES&&c.mode!==_i.TRIANGLE_STRIP&&c.mode!==_i.TRIANGLE_FAN&&c.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],l={};for(let c in o)a.push(this.parser.getDependency("accessor",o[c]).then(u=>(l[c]=u,l[c])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(c=>{let u=c.pop(),h=u.isGroup?u.children:[u],d=c[0].count,f=[];for(let g of h){let y=new Re,m=new P,_=new Xn,v=new P(1,1,1),M=new nl(g.geometry,g.material,d);for(let w=0;w<d;w++)l.TRANSLATION&&m.fromBufferAttribute(l.TRANSLATION,w),l.ROTATION&&_.fromBufferAttribute(l.ROTATION,w),l.SCALE&&v.fromBufferAttribute(l.SCALE,w),M.setMatrixAt(w,y.compose(m,_,v));let b=null;for(let w in l)if(w==="_COLOR_0"){let x=l[w];M.instanceColor=new xs(x.array,x.itemSize,x.normalized)}else if(w!=="TRANSLATION"&&w!=="ROTATION"&&w!=="SCALE"){if(b===null){let p=M.geometry;b=new Xt,b.name=p.name;for(let S in p.attributes)b.setAttribute(S,p.attributes[S]);for(let S in p.morphAttributes)b.morphAttributes[S]=p.morphAttributes[S];p.index!==null&&b.setIndex(p.index),b.morphTargetsRelative=p.morphTargetsRelative;for(let S of p.groups)b.addGroup(S.start,S.count,S.materialIndex);p.boundingBox!==null&&(b.boundingBox=p.boundingBox.clone()),p.boundingSphere!==null&&(b.boundingSphere=p.boundingSphere.clone()),b.drawRange.start=p.drawRange.start,b.drawRange.count=p.drawRange.count,b.userData=Object.assign({},p.userData),M.geometry=b}let x=l[w];b.setAttribute(w,new xs(x.array,x.itemSize,x.normalized))}$t.prototype.copy.call(M,g),this.parser.assignFinalMaterial(M),f.push(M)}return u.isGroup?(u.clear(),u.add(...f),u):f[0]}))}},rx="glTF",Ul=12,tx={JSON:1313821514,BIN:5130562},Fp=class{constructor(e){this.name=rt.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,Ul),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==rx)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let s=this.header.length-Ul,r=new DataView(e,Ul),o=0;for(;o<s;){let a=r.getUint32(o,!0);o+=4;let l=r.getUint32(o,!0);if(o+=4,l===tx.JSON){let c=new Uint8Array(e,Ul+o,a);this.content=n.decode(c)}else if(l===tx.BIN){let c=Ul+o;this.body=e.slice(c,c+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},kp=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=rt.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,s=this.dracoLoader,r=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},l={},c={};for(let u in o){let h=Hp[u]||u.toLowerCase();a[h]=o[u]}for(let u in e.attributes){let h=Hp[u]||u.toLowerCase();if(o[u]!==void 0){let d=n.accessors[e.attributes[u]],f=Bo[d.componentType];c[h]=f.name,l[h]=d.normalized===!0}}return t.getDependency("bufferView",r).then(function(u){return new Promise(function(h,d){s.decodeDracoFile(u,function(f){for(let g in f.attributes){let y=f.attributes[g],m=l[g];m!==void 0&&(y.normalized=m)}h(f)},a,c,Wn,d)})})}},Bp=class{constructor(){this.name=rt.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),s=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*s,e.offset.x,-e.repeat.x*s,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},zp=class{constructor(){this.name=rt.KHR_MESH_QUANTIZATION}},mh=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s*3+s;for(let o=0;o!==s;o++)t[o]=n[r+o];return t}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=a*2,c=a*3,u=s-t,h=(n-t)/u,d=h*h,f=d*h,g=e*c,y=g-c,m=-2*f+3*d,_=f-d,v=1-m,M=_-d+h;for(let b=0;b!==a;b++){let w=o[y+b+a],x=o[y+b+l]*u,p=o[g+b+a],S=o[g+b]*u;r[b]=v*w+M*x+m*p+_*S}return r}},JT=new Xn,Vp=class extends mh{interpolate_(e,t,n,s){let r=super.interpolate_(e,t,n,s);return JT.fromArray(r).normalize().toArray(r),r}},_i={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},Bo={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},nx={9728:en,9729:cn,9984:wu,9985:Lo,9986:Dr,9987:mi},ix={33071:di,33648:go,10497:Xs},gp={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},Hp={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},js={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},jT={CUBICSPLINE:void 0,LINEAR:Ar,STEP:Tr},_p={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function QT(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new bs({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:oi})),i.DefaultMaterial}function kr(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function Zi(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function e1(i,e,t){let n=!1,s=!1,r=!1;for(let c=0,u=e.length;c<u;c++){let h=e[c];if(h.POSITION!==void 0&&(n=!0),h.NORMAL!==void 0&&(s=!0),h.COLOR_0!==void 0&&(r=!0),n&&s&&r)break}if(!n&&!s&&!r)return Promise.resolve(i);let o=[],a=[],l=[];for(let c=0,u=e.length;c<u;c++){let h=e[c];if(n){let d=h.POSITION!==void 0?t.getDependency("accessor",h.POSITION):i.attributes.position;o.push(d)}if(s){let d=h.NORMAL!==void 0?t.getDependency("accessor",h.NORMAL):i.attributes.normal;a.push(d)}if(r){let d=h.COLOR_0!==void 0?t.getDependency("accessor",h.COLOR_0):i.attributes.color;l.push(d)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l)]).then(function(c){let u=c[0],h=c[1],d=c[2];return n&&(i.morphAttributes.position=u),s&&(i.morphAttributes.normal=h),r&&(i.morphAttributes.color=d),i.morphTargetsRelative=!0,i})}function t1(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,s=t.length;n<s;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function n1(i){let e,t=i.extensions&&i.extensions[rt.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+xp(t.attributes):e=i.indices+":"+xp(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,s=i.targets.length;n<s;n++)e+=":"+xp(i.targets[n]);return e}function xp(i){let e="",t=Object.keys(i).sort();for(let n=0,s=t.length;n<s;n++)e+=t[n]+":"+i[t[n]]+";";return e}function Gp(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function i1(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var s1=new Re,Wp=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new ZT,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,s=-1,r=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let l=a.match(/Version\/(\d+)/);s=n&&l?parseInt(l[1],10):-1,r=a.indexOf("Firefox")>-1,o=r?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&s<17||r&&o<98?(this.textureLoader=new dl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new xl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new To(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,s=this.json,r=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][s.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:s.asset,parser:n,userData:{}};return kr(r,a,s),Zi(a,s),Promise.all(n._invokeAll(function(l){return l.afterRoot&&l.afterRoot(a)})).then(function(){for(let l of a.scenes)l.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let s=0,r=t.length;s<r;s++){let o=t[s].joints;for(let a=0,l=o.length;a<l;a++)e[o[a]].isBone=!0}for(let s=0,r=e.length;s<r;s++){let o=e[s];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let s=n.clone(),r=(o,a)=>{let l=this.associations.get(o);l!=null&&this.associations.set(a,l);for(let[c,u]of o.children.entries())r(u,a.children[c])};return r(n,s),s.name+="_instance_"+e.uses[t]++,s}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let s=e(t[n]);if(s)return s}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let s=0;s<t.length;s++){let r=e(t[s]);r&&n.push(r)}return n}getDependency(e,t){let n=e+":"+t,s=this.cache.get(n);if(!s){switch(e){case"scene":s=this.loadScene(t);break;case"node":s=this._invokeOne(function(r){return r.loadNode&&r.loadNode(t)});break;case"mesh":s=this._invokeOne(function(r){return r.loadMesh&&r.loadMesh(t)});break;case"accessor":s=this.loadAccessor(t);break;case"bufferView":s=this._invokeOne(function(r){return r.loadBufferView&&r.loadBufferView(t)});break;case"buffer":s=this.loadBuffer(t);break;case"material":s=this._invokeOne(function(r){return r.loadMaterial&&r.loadMaterial(t)});break;case"texture":s=this._invokeOne(function(r){return r.loadTexture&&r.loadTexture(t)});break;case"skin":s=this.loadSkin(t);break;case"animation":s=this._invokeOne(function(r){return r.loadAnimation&&r.loadAnimation(t)});break;case"camera":s=this.loadCamera(t);break;default:if(s=this._invokeOne(function(r){return r!=this&&r.getDependency&&r.getDependency(e,t)}),!s)throw new Error("Unknown type: "+e);break}this.cache.add(n,s)}return s}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,s=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(s.map(function(r,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[rt.KHR_BINARY_GLTF].body);let s=this.options;return new Promise(function(r,o){n.load(As.resolveURL(t.uri,s.path),r,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let s=t.byteLength||0,r=t.byteOffset||0;return n.slice(r,r+s)})}loadAccessor(e){let t=this,n=this.json,s=this.json.accessors[e];if(s.bufferView===void 0&&s.sparse===void 0){let o=gp[s.type],a=Bo[s.componentType],l=s.normalized===!0,c=new a(s.count*o);return Promise.resolve(new pt(c,o,l))}let r=[];return s.bufferView!==void 0?r.push(this.getDependency("bufferView",s.bufferView)):r.push(null),s.sparse!==void 0&&(r.push(this.getDependency("bufferView",s.sparse.indices.bufferView)),r.push(this.getDependency("bufferView",s.sparse.values.bufferView))),Promise.all(r).then(function(o){let a=o[0],l=gp[s.type],c=Bo[s.componentType],u=c.BYTES_PER_ELEMENT,h=u*l,d=s.byteOffset||0,f=s.bufferView!==void 0?n.bufferViews[s.bufferView].byteStride:void 0,g=s.normalized===!0,y,m;if(f&&f!==h){let _=Math.floor(d/f),v="InterleavedBuffer:"+s.bufferView+":"+s.componentType+":"+_+":"+s.count,M=t.cache.get(v);M||(y=new c(a,_*f,s.count*f/u),M=new Cr(y,f/u),t.cache.add(v,M)),m=new Qn(M,l,d%f/u,g)}else a===null?y=new c(s.count*l):y=new c(a,d,s.count*l),m=new pt(y,l,g);if(s.sparse!==void 0){let _=gp.SCALAR,v=Bo[s.sparse.indices.componentType],M=s.sparse.indices.byteOffset||0,b=s.sparse.values.byteOffset||0,w=new v(o[1],M,s.sparse.count*_),x=new c(o[2],b,s.sparse.count*l);a!==null&&(m=new pt(m.array.slice(),m.itemSize,m.normalized)),m.normalized=!1;for(let p=0,S=w.length;p<S;p++){let A=w[p];if(m.setX(A,x[p*l]),l>=2&&m.setY(A,x[p*l+1]),l>=3&&m.setZ(A,x[p*l+2]),l>=4&&m.setW(A,x[p*l+3]),l>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}m.normalized=g}return m})}loadTexture(e){let t=this.json,n=this.options,r=t.textures[e].source,o=t.images[r],a=this.textureLoader;if(o.uri){let l=n.manager.getHandler(o.uri);l!==null&&(a=l)}return this.loadTextureImage(e,r,a)}loadTextureImage(e,t,n){let s=this,r=this.json,o=r.textures[e],a=r.images[t],l=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[l])return this.textureCache[l];let c=this.loadImageSource(t,n).then(function(u){u.flipY=!1,u.name=o.name||a.name||"",u.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(u.name=a.uri);let d=(r.samplers||{})[o.sampler]||{};return u.magFilter=nx[d.magFilter]||cn,u.minFilter=nx[d.minFilter]||mi,u.wrapS=ix[d.wrapS]||Xs,u.wrapT=ix[d.wrapT]||Xs,u.generateMipmaps=!u.isCompressedTexture&&u.minFilter!==en&&u.minFilter!==cn,s.associations.set(u,{textures:e}),u}).catch(function(){return null});return this.textureCache[l]=c,c}loadImageSource(e,t){let n=this,s=this.json,r=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(d=>d.clone());let o=s.images[e],a=self.URL||self.webkitURL,l=o.uri||"",c=!1,u;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)u=n.getDependency("bufferView",o.bufferView).then(function(d){return new Promise(function(f,g){t.parse(d,f,g)})});else{if(o.bufferView!==void 0)l=n.getDependency("bufferView",o.bufferView).then(function(d){c=!0;let f=new Blob([d],{type:o.mimeType});return l=a.createObjectURL(f),l});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");u=Promise.resolve(l).then(function(d){return new Promise(function(f,g){let y=f;t.isImageBitmapLoader===!0&&(y=function(m){let _=new yn(m);_.needsUpdate=!0,f(_)}),t.load(As.resolveURL(d,r.path),y,void 0,g)})})}let h=u.then(function(d){return c===!0&&a.revokeObjectURL(l),Zi(d,o),d.userData.mimeType=o.mimeType||i1(o.uri),d}).catch(function(d){throw console.error("THREE.GLTFLoader: Couldn't load texture",l),d});return this.sourceCache[e]=h,h}assignTexture(e,t,n,s){let r=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),r.extensions[rt.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[rt.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let l=r.associations.get(o);o=r.extensions[rt.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),r.associations.set(o,l)}}return s!==void 0&&(o.colorSpace=s),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,s=t.attributes.tangent===void 0,r=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new wo,qn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,l.sizeAttenuation=!1,this.cache.add(a,l)),n=l}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new qs,qn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,this.cache.add(a,l)),n=l}if(s||r||o){let a="ClonedMaterial:"+n.uuid+":";s&&(a+="derivative-tangents:"),r&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let l=this.cache.get(a);l||(l=n.clone(),r&&(l.vertexColors=!0),o&&(l.flatShading=!0),s&&(l.normalScale&&(l.normalScale.y*=-1),l.clearcoatNormalScale&&(l.clearcoatNormalScale.y*=-1)),this.cache.add(a,l),this.associations.set(l,this.associations.get(n))),n=l}e.material=n}getMaterialType(){return bs}loadMaterial(e){let t=this,n=this.json,s=this.extensions,r=n.materials[e],o,a={},l=r.extensions||{},c=[];if(l[rt.KHR_MATERIALS_UNLIT]){let h=s[rt.KHR_MATERIALS_UNLIT];o=h.getMaterialType(),c.push(h.extendParams(a,r,t))}else{let h=r.pbrMetallicRoughness||{};if(a.color=new Ne(1,1,1),a.opacity=1,Array.isArray(h.baseColorFactor)){let d=h.baseColorFactor;a.color.setRGB(d[0],d[1],d[2],Wn),a.opacity=d[3]}h.baseColorTexture!==void 0&&c.push(t.assignTexture(a,"map",h.baseColorTexture,on)),a.metalness=h.metallicFactor!==void 0?h.metallicFactor:1,a.roughness=h.roughnessFactor!==void 0?h.roughnessFactor:1,h.metallicRoughnessTexture!==void 0&&(c.push(t.assignTexture(a,"metalnessMap",h.metallicRoughnessTexture)),c.push(t.assignTexture(a,"roughnessMap",h.metallicRoughnessTexture))),o=this._invokeOne(function(d){return d.getMaterialType&&d.getMaterialType(e)}),c.push(Promise.all(this._invokeAll(function(d){return d.extendMaterialParams&&d.extendMaterialParams(e,a)})))}r.doubleSided===!0&&(a.side=rn);let u=r.alphaMode||_p.OPAQUE;if(u===_p.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,u===_p.MASK&&(a.alphaTest=r.alphaCutoff!==void 0?r.alphaCutoff:.5)),r.normalTexture!==void 0&&o!==pi&&(c.push(t.assignTexture(a,"normalMap",r.normalTexture)),a.normalScale=new Ue(1,1),r.normalTexture.scale!==void 0)){let h=r.normalTexture.scale;a.normalScale.set(h,h)}if(r.occlusionTexture!==void 0&&o!==pi&&(c.push(t.assignTexture(a,"aoMap",r.occlusionTexture)),r.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=r.occlusionTexture.strength)),r.emissiveFactor!==void 0&&o!==pi){let h=r.emissiveFactor;a.emissive=new Ne().setRGB(h[0],h[1],h[2],Wn)}return r.emissiveTexture!==void 0&&o!==pi&&c.push(t.assignTexture(a,"emissiveMap",r.emissiveTexture,on)),Promise.all(c).then(function(){let h=new o(a);return r.name&&(h.name=r.name),Zi(h,r),t.associations.set(h,{materials:e}),r.extensions&&kr(s,h,r),h})}createUniqueName(e){let t=Ft.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,s=this.primitiveCache;function r(a){return n[rt.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(l){return sx(l,a,t)})}let o=[];for(let a=0,l=e.length;a<l;a++){let c=e[a],u=n1(c),h=s[u];if(h)o.push(h.promise);else{let d;c.extensions&&c.extensions[rt.KHR_DRACO_MESH_COMPRESSION]?d=r(c):d=sx(new Xt,c,t),c.mode===_i.TRIANGLE_STRIP?d=d.then(f=>mp(f,Cl)):c.mode===_i.TRIANGLE_FAN&&(d=d.then(f=>mp(f,No))),s[u]={primitive:c,promise:d},o.push(d)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,s=this.extensions,r=n.meshes[e],o=r.primitives,a=[];for(let l=0,c=o.length;l<c;l++){let u=o[l].material===void 0?QT(this.cache):this.getDependency("material",o[l].material);a.push(u)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(l){let c=l.slice(0,l.length-1),u=l[l.length-1],h=[];for(let f=0,g=u.length;f<g;f++){let y=u[f],m=o[f],_,v=c[f];if(m.mode===_i.TRIANGLES||m.mode===_i.TRIANGLE_STRIP||m.mode===_i.TRIANGLE_FAN||m.mode===void 0){let M=r.isSkinnedMesh===!0,b=y.hasAttribute("skinIndex")&&y.hasAttribute("skinWeight");M&&b===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),_=M&&b?new el(y,v):new Tt(y,v),_.isSkinnedMesh===!0&&_.normalizeSkinWeights()}else if(m.mode===_i.LINES)_=new Hi(y,v);else if(m.mode===_i.LINE_STRIP)_=new Vi(y,v);else if(m.mode===_i.LINE_LOOP)_=new Ys(y,v);else if(m.mode===_i.POINTS)_=new wi(y,v);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+m.mode);Object.keys(_.geometry.morphAttributes).length>0&&t1(_,r),_.name=t.createUniqueName(r.name||"mesh_"+e),Zi(_,r),m.extensions&&kr(s,_,m),t.assignFinalMaterial(_),h.push(_)}for(let f=0,g=h.length;f<g;f++)t.associations.set(h[f],{meshes:e,primitives:f});if(h.length===1)return r.extensions&&kr(s,h[0],r),h[0];let d=new xn;r.extensions&&kr(s,d,r),t.associations.set(d,{meshes:e});for(let f=0,g=h.length;f<g;f++)d.add(h[f]);return d})}loadCamera(e){let t,n=this.json.cameras[e],s=n[n.type];if(!s){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new an(Do.radToDeg(s.yfov),s.aspectRatio||1,s.znear||1,s.zfar||2e6):n.type==="orthographic"&&(t=new Ts(-s.xmag,s.xmag,s.ymag,-s.ymag,s.znear,s.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),Zi(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let s=0,r=t.joints.length;s<r;s++)n.push(this._loadNodeShallow(t.joints[s]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(s){let r=s.pop(),o=s,a=[],l=[];for(let c=0,u=o.length;c<u;c++){let h=o[c];if(h){a.push(h);let d=new Re;r!==null&&d.fromArray(r.array,c*16),l.push(d)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[c])}return new tl(a,l)})}loadAnimation(e){let t=this.json,n=this,s=t.animations[e],r=s.name?s.name:"animation_"+e,o=[],a=[],l=[],c=[],u=[];for(let h=0,d=s.channels.length;h<d;h++){let f=s.channels[h],g=s.samplers[f.sampler],y=f.target,m=y.node,_=s.parameters!==void 0?s.parameters[g.input]:g.input,v=s.parameters!==void 0?s.parameters[g.output]:g.output;y.node!==void 0&&(o.push(this.getDependency("node",m)),a.push(this.getDependency("accessor",_)),l.push(this.getDependency("accessor",v)),c.push(g),u.push(y))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l),Promise.all(c),Promise.all(u)]).then(function(h){let d=h[0],f=h[1],g=h[2],y=h[3],m=h[4],_=[];for(let M=0,b=d.length;M<b;M++){let w=d[M],x=f[M],p=g[M],S=y[M],A=m[M];if(w===void 0)continue;w.updateMatrix&&w.updateMatrix();let E=n._createAnimationTracks(w,x,p,S,A);if(E)for(let C=0;C<E.length;C++)_.push(E[C])}let v=new hl(r,void 0,_);return Zi(v,s),v})}createNodeMesh(e){let t=this.json,n=this,s=t.nodes[e];return s.mesh===void 0?null:n.getDependency("mesh",s.mesh).then(function(r){let o=n._getNodeRef(n.meshCache,s.mesh,r);return s.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let l=0,c=s.weights.length;l<c;l++)a.morphTargetInfluences[l]=s.weights[l]}),o})}loadNode(e){let t=this.json,n=this,s=t.nodes[e],r=n._loadNodeShallow(e),o=[],a=s.children||[];for(let c=0,u=a.length;c<u;c++)o.push(n.getDependency("node",a[c]));let l=s.skin===void 0?Promise.resolve(null):n.getDependency("skin",s.skin);return Promise.all([r,Promise.all(o),l]).then(function(c){let u=c[0],h=c[1],d=c[2];d!==null&&u.traverse(function(f){f.isSkinnedMesh&&f.bind(d,s1)});for(let f=0,g=h.length;f<g;f++)u.add(h[f]);if(u.userData.pivot!==void 0&&h.length>0){let f=u.userData.pivot,g=h[0];u.pivot=new P().fromArray(f),u.position.x-=f[0],u.position.y-=f[1],u.position.z-=f[2],g.position.set(0,0,0),delete u.userData.pivot}return u})}_loadNodeShallow(e){let t=this.json,n=this.extensions,s=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let r=t.nodes[e],o=r.name?s.createUniqueName(r.name):"",a=[],l=s._invokeOne(function(c){return c.createNodeMesh&&c.createNodeMesh(e)});return l&&a.push(l),r.camera!==void 0&&a.push(s.getDependency("camera",r.camera).then(function(c){return s._getNodeRef(s.cameraCache,r.camera,c)})),s._invokeAll(function(c){return c.createNodeAttachment&&c.createNodeAttachment(e)}).forEach(function(c){a.push(c)}),this.nodeCache[e]=Promise.all(a).then(function(c){let u;if(r.isBone===!0?u=new Mo:c.length>1?u=new xn:c.length===1?u=c[0]:u=new $t,u!==c[0])for(let h=0,d=c.length;h<d;h++)u.add(c[h]);if(r.name&&(u.userData.name=r.name,u.name=o),Zi(u,r),r.extensions&&kr(n,u,r),r.matrix!==void 0){let h=new Re;h.fromArray(r.matrix),u.applyMatrix4(h)}else r.translation!==void 0&&u.position.fromArray(r.translation),r.rotation!==void 0&&u.quaternion.fromArray(r.rotation),r.scale!==void 0&&u.scale.fromArray(r.scale);if(!s.associations.has(u))s.associations.set(u,{});else if(r.mesh!==void 0&&s.meshCache.refs[r.mesh]>1){let h=s.associations.get(u);s.associations.set(u,{...h})}return s.associations.get(u).nodes=e,u}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],s=this,r=new xn;n.name&&(r.name=s.createUniqueName(n.name)),Zi(r,n),n.extensions&&kr(t,r,n);let o=n.nodes||[],a=[];for(let l=0,c=o.length;l<c;l++)a.push(s.getDependency("node",o[l]));return Promise.all(a).then(function(l){for(let u=0,h=l.length;u<h;u++){let d=l[u];d.parent!==null?r.add(Q_(d)):r.add(d)}let c=u=>{let h=new Map;for(let[d,f]of s.associations)(d instanceof qn||d instanceof yn)&&h.set(d,f);return u.traverse(d=>{let f=s.associations.get(d);f!=null&&h.set(d,f)}),h};return s.associations=c(r),r})}_createAnimationTracks(e,t,n,s,r){let o=[],a=e.name?e.name:e.uuid,l=[];function c(f){f.morphTargetInfluences&&l.push(f.name?f.name:f.uuid)}js[r.path]===js.weights?(c(e),e.isGroup&&e.children.forEach(c)):l.push(a);let u;switch(js[r.path]){case js.weights:u=Ms;break;case js.rotation:u=ws;break;case js.translation:case js.scale:u=$s;break;default:n.itemSize===1?u=Ms:u=$s;break}let h=s.interpolation!==void 0?jT[s.interpolation]:Ar,d=this._getArrayFromAccessor(n);for(let f=0,g=l.length;f<g;f++){let y=new u(l[f]+"."+js[r.path],t.array,d,h);s.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(y),o.push(y)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=Gp(t.constructor),s=new Float32Array(t.length);for(let r=0,o=t.length;r<o;r++)s[r]=t[r]*n;t=s}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let s=this instanceof ws?Vp:mh;return new s(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function r1(i,e,t){let n=e.attributes,s=new je;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],l=a.min,c=a.max;if(l!==void 0&&c!==void 0){if(s.set(new P(l[0],l[1],l[2]),new P(c[0],c[1],c[2])),a.normalized){let u=Gp(Bo[a.componentType]);s.min.multiplyScalar(u),s.max.multiplyScalar(u)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let r=e.targets;if(r!==void 0){let a=new P,l=new P;for(let c=0,u=r.length;c<u;c++){let h=r[c];if(h.POSITION!==void 0){let d=t.json.accessors[h.POSITION],f=d.min,g=d.max;if(f!==void 0&&g!==void 0){if(l.setX(Math.max(Math.abs(f[0]),Math.abs(g[0]))),l.setY(Math.max(Math.abs(f[1]),Math.abs(g[1]))),l.setZ(Math.max(Math.abs(f[2]),Math.abs(g[2]))),d.normalized){let y=Gp(Bo[d.componentType]);l.multiplyScalar(y)}a.max(l)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}s.expandByVector(a)}i.boundingBox=s;let o=new kt;s.getCenter(o.center),o.radius=s.min.distanceTo(s.max)/2,i.boundingSphere=o}function sx(i,e,t){let n=e.attributes,s=[];function r(o,a){return t.getDependency("accessor",o).then(function(l){i.setAttribute(a,l)})}for(let o in n){let a=Hp[o]||o.toLowerCase();a in i.attributes||s.push(r(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});s.push(o)}return nt.workingColorSpace!==Wn&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${nt.workingColorSpace}" not supported.`),Zi(i,e),r1(i,e,t),Promise.all(s).then(function(){return e.targets!==void 0?e1(i,e.targets,t):i})}var o1=new zo;async function Fl(i){let e=await o1.parseAsync(i,""),t=e.parser.json,n=await e.parser.getDependency("node",0),{geometry:s}=n,r=new Map;for(let[u,h]of Object.entries(s.attributes))u.startsWith("_")&&h instanceof pt&&h.itemSize===1&&(r.set(u.slice(1),h.array),s.deleteAttribute(u));s.deleteAttribute("color");let o=[];for(let u=1;u<t.nodes.length;u+=1){let h=await e.parser.getDependency("node",u),d=[];h.traverse(m=>{m.isLine&&d.push(m)});let f=a1(d.map(Xp)),g=[],[y]=d;if(y&&d.length===1&&!y.geometry.index)for(let[m,_]of Object.entries(y.geometry.attributes)){if(!m.startsWith("_"))continue;let v=Object.entries(t.nodes[u].extras??{}).find(([M])=>M.toLowerCase()===m)?.[1]?.unit??"";g.push({name:m.slice(1),unit:v,values:_.array})}o.push({name:t.nodes[u].name??"lines",segments:f,values:g})}let[a=0,l=0,c=0]=t.nodes[0]?.translation??[];return{geometry:s,attributes:r,lines:o,translation:[a,l,c],extras:t.asset.extras??{}}}function Xp(i){let e=i.geometry.attributes.position,t=i.geometry.index?.array??Uint32Array.from({length:e.count},(a,l)=>l),n=i.isLineSegments,s=i.isLineLoop,r=n?t.length>>1:Math.max(t.length-(s?0:1),0),o=new Float32Array(6*r);for(let a=0;a<r;a+=1)for(let l=0;l<2;l+=1){let c=3*t[((n?2:1)*a+l)%t.length];o.set(e.array.subarray(c,c+3),6*a+3*l)}return o}function a1(i){let e=new Float32Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function gh(i){let e=i.index.array,t=i.attributes.position.count,n=new Map,s=[],r=[];for(let o=0;o<e.length;o+=3)for(let a=0;a<3;a+=1){let l=e[o+a],c=e[o+(a+1)%3],u=Math.min(l,c)*t+Math.max(l,c),h=n.get(u);h===void 0?(n.set(u,s.length/2),s.push(l,c),r.push(o/3,-1)):r[2*h+1]===-1&&(r[2*h+1]=o/3)}return{ends:Uint32Array.from(s),faces:Int32Array.from(r)}}function l1(i){let e=JSON.parse(i),t=[],n=[],s=0;for(let{uri:c=""}of e.buffers??[]){let[,u]=/^data:[^,]*;base64,(.*)$/s.exec(c)??[];if(u===void 0)throw new Error("its data lies in another file; save it as GLB or with embedded buffers.");let h=Uint8Array.from(atob(u),d=>d.charCodeAt(0));t.push(s),n.push(h),s+=h.length+3&-4}for(let c of e.bufferViews??[])c.byteOffset=(c.byteOffset??0)+(t[c.buffer]??0),c.buffer=0;e.buffers=[{byteLength:s}];let r=new TextEncoder().encode(JSON.stringify(e)),o=r.length+3&-4,a=new Uint8Array(20+o+8+s).fill(32,20,20+o),l=new DataView(a.buffer);return[1179937895,2,a.length,o,1313821514].forEach((c,u)=>l.setUint32(4*u,c,!0)),a.set(r,20),l.setUint32(20+o,s,!0),l.setUint32(24+o,5130562,!0),n.forEach((c,u)=>a.set(c,28+o+t[u])),a.buffer}async function qp(i){let e=[];try{let t=await new zo().parseAsync(typeof i=="string"?l1(i):i,"");t.scene.updateMatrixWorld(!0),t.scene.traverse(n=>{let s=n;if(!s.isLine)return;let r=Xp(s),o=l=>new P().fromArray(r,l).applyMatrix4(s.matrixWorld).toArray(),a=[];for(let l=0;l<r.length;l+=6)a.push([o(l),o(l+3)]);a.length>0&&e.push(...gr(a,1e-6))})}catch(t){throw new _t(`This is not glTF that can be read: ${t instanceof Error?t.message:String(t)}`)}if(e.length===0)throw new _t("This glTF file has no lines.");return e}function ox(i){let e=[],t=[],n=new Map;if(i.split(/\r?\n/).forEach((r,o)=>{let[a,...l]=r.replace(/#.*/,"").trim().split(/\s+/);if(!a)return;let c=u=>{let h=parseInt(u,10),d=h<0?e.length+h:h-1;if(!e[d])throw new _t(`there is no vertex ${Li(u)}.`,o+1);return d};if(a==="v"){if(l.length<3)throw new _t("a vertex needs x, y and z.",o+1);e.push(l.slice(0,3).map(u=>_c(u,o+1)))}else if(a==="l")t.push(Zn(l.map(u=>e[c(u)])));else if(a==="f"){let u=l.map(c);u.forEach((h,d)=>{let f=u[(d+1)%u.length],g=`${Math.min(h,f)} ${Math.max(h,f)}`;n.set(g,n.has(g)?null:[h,f])})}else if(!/^(vn|vt|vp|p|o|g|s|mtllib|usemtl|mg|cstype|deg|curv|curv2|surf|parm|end)$/.test(a))throw new _t(`${Li(r)} is not OBJ.`,o+1)}),t.length>0)return t.length>1&&t.every(({points:r})=>r.length===2)?gr(t.map(({points:r})=>r)):t;let s=[...n.values()].filter(r=>r!==null);if(s.length>0)return gr(s.map(([r,o])=>[e[r],e[o]]));if(e.length>0)return[Zn(e)];throw new _t("This OBJ file has no lines, no faces and no vertices.")}var ax=".csv,.txt,.obj,.dxf,.geojson,.json,.gltf,.glb";async function _h(i){let e=new Uint8Array(await i.slice(0,4).arrayBuffer());return String.fromCharCode(...e)==="glTF"?{lines:await qp(await i.arrayBuffer()),format:"glTF",metres:!0}:xh(await i.text(),/\.(\w+)$/.exec(i.name)?.[1]?.toLowerCase()??"")}async function xh(i,e=""){if(i.trim()==="")throw new _t("There is nothing in it.");let t=i.trimStart();if(["json","geojson","gltf"].includes(e)||e===""&&/^[{[]/.test(t))return c1(i);if(e==="obj"||e===""&&/^\s*(v|l|o|g)\s/m.test(i))return{lines:ox(i),format:"OBJ",metres:!1};if(e==="dxf"||e===""&&/^\s*(0|999)\s*\r?\n/.test(i))return{lines:zg(i),format:"DXF",metres:!1};let n=Ng(i);if(n.length===0)throw new _t("There are no points in it.");return{lines:n,format:"CSV",metres:!1}}async function c1(i){let e=Yp(i);if(Vg(e))return{lines:Hg(e,i),format:"GeoJSON",metres:!1};if(e!==null&&typeof e=="object"&&"asset"in e)return{lines:await qp(i),format:"glTF",metres:!0};if(e===null||typeof e!="object"||Array.isArray(e))throw new _t("This JSON is neither a request nor GeoJSON nor glTF.");let t=e;if(!ya(t))throw new _t("This JSON is neither a request (with boundaries, directrices or a domain) nor GeoJSON nor glTF.");return{request:t}}function Yp(i){try{return JSON.parse(i)}catch(e){let t=e instanceof Error?e.message:String(e),[,n]=/position (\d+)/.exec(t)??[],s=n===void 0?i.split(`
`).length:i.slice(0,Number(n)).split(`
`).length;throw new _t(`this is not JSON: ${t.replace(/ (in JSON )?at position.*$/,"")}.`,s)}}var cx=1e-9,u1=800,Ji=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],h1=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]],kl=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Vo=i=>Math.hypot(...i);function $p(i){return i.flatMap((e,t)=>_r(e)?lx(e,t):[...lx(e,t),...d1(e,t)])}function lx(i,e){return i.points.flatMap((t,n)=>Pg(t)?[]:[{line:e,points:[n],text:`${i.name}, point ${n+1} is not three numbers`}])}function d1(i,e){let t=i.points.map(Gt);if(t.some(c=>c===null)||t.length<2)return[];let n=t,s=Math.max(...n.map(c=>Vo(Ji(c,n[0]))),0),r=[],o=i.closed&&n.length>2?n.length:n.length-1;for(let c=0;c<o;c+=1){let u=(c+1)%n.length;Vo(Ji(n[c],n[u]))<=cx*s&&r.push({line:e,points:[c,u],text:`${i.name}, points ${c+1} and ${u+1} are the same`})}if(i.closed&&s>0&&f1(n,s))return[...r,{line:e,points:n.map((c,u)=>u),text:`${i.name}: all points lie on one line`}];let a=new Set(r.map(({points:[,c]})=>c)),l=n.map((c,u)=>u).filter(c=>!a.has(c));return i.closed&&l.length<=u1&&r.push(...p1(i,e,l.map(c=>n[c]),l,s)),r}function f1(i,e){let t=i[0],n=i.reduce((r,o)=>Vo(Ji(o,t))>Vo(Ji(r,t))?o:r),s=Ji(n,t);return i.every(r=>Vo(h1(s,Ji(r,t)))<=1e-9*e*e)}function p1(i,e,t,n,s){let r=[],o=t.length;for(let a=0;a<o&&r.length<4;a+=1)for(let l=a+2;l<o&&r.length<4;l+=1){if(a===0&&l===o-1)continue;let[c,u,h,d]=[t[a],t[(a+1)%o],t[l],t[(l+1)%o]];if(m1(c,u,h,d)>cx*s)continue;let f=[a,(a+1)%o,l,(l+1)%o].map(v=>n[v]),[g,y,m,_]=f.map(v=>v+1);r.push({line:e,points:f,text:`${i.name}: the edge from point ${g} to ${y} meets the edge from ${m} to ${_}`})}return r}function m1(i,e,t,n){let s=Ji(e,i),r=Ji(n,t),o=Ji(i,t),a=kl(s,s),l=kl(s,r),c=kl(r,r),u=kl(s,o),h=kl(r,o),d=a*c-l*l,f=m=>Math.min(1,Math.max(0,m)),g=d>1e-14*a*c?f((l*h-c*u)/d):0,y=c>0?f((l*g+h)/c):0;return g=a>0?f((l*y-u)/a):0,y=c>0?f((l*g+h)/c):0,Vo(Ji([i[0]+g*s[0],i[1]+g*s[1],i[2]+g*s[2]],[t[0]+y*r[0],t[1]+y*r[1],t[2]+y*r[2]]))}var Qs=class{origin;metres;up;constructor(e,t){this.origin=e,this.metres=xa(t),this.up=t.up==="y"?1:2}toScene(e){let[t,n,s]=[0,1,2].map(r=>((e[r]??0)-this.origin[r])*this.metres);return this.up===2?[t,s,-n]:[t,n,s]}fromScene([e,t,n]){return(this.up===2?[e,-n,t]:[e,t,n]).map((r,o)=>r/this.metres+this.origin[o])}length(e){return e/this.metres}},g1=50;function ux(i,e){let t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let a of i)for(let l of a.points){let c=Gt(l);if(c)for(let u=0;u<3;u+=1)t[u]=Math.min(t[u],c[u]),n[u]=Math.max(n[u],c[u])}if(!Number.isFinite(t[0]))return[0,0,0];let s=Math.max(...t.map((a,l)=>n[l]-a))||1,r=10**Math.ceil(Math.log10(s)),o=e.up==="y"?1:2;return t.map((a,l)=>{let c=l===o?a:(a+n[l])/2;return Math.abs(c)>g1*s?Math.round(c/r)*r:0})}var yh=class{document;past=[];future=[];opened=null;constructor(e){this.document=e}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}begin(){this.opened??=JSON.stringify(this.document)}commit(){let e=this.opened;if(this.opened=null,e===null||e===JSON.stringify(this.document))return!1;this.past.push(e),this.future=[];let t=this.past.reduce((n,s)=>n+s.length,0);for(;this.past.length>500||t>4e7&&this.past.length>1;)t-=this.past.shift().length;return!0}edit(e){let t=this.opened!==null;return this.begin(),e(this.document),t||this.commit()}undo(){return this.step(this.past,this.future)}redo(){return this.step(this.future,this.past)}step(e,t){this.opened!==null&&this.commit();let n=e.pop();return n===void 0?!1:(t.push(JSON.stringify(this.document)),this.document=JSON.parse(n),!0)}};function jt(i){let[,e=i,t]=/^(.*?)(_deg|_ms|_s)?$/.exec(i)??[],n=e.replaceAll("_"," ");if(n.length<=2)return n;let s={_deg:" (°)",_ms:" (ms)",_s:" (s)"}[t??""]??"";return n.charAt(0).toUpperCase()+n.slice(1)+s}var _1={"-":"⁻",...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((i,e)=>[String(e),i]))};function At(i,e=5){if(Number.isInteger(i)&&Math.abs(i)<1e15)return i.toLocaleString("en").replace("-","−");let t=Math.abs(i);if(t!==0&&(t<1e-4||t>=1e9)){let[n="",s=""]=i.toExponential(Math.min(e,3)-1).split("e");return`${(n.includes(".")?n.replace(/\.?0+$/,""):n).replace("-","−")}×10${[...s.replace("+","")].map(o=>_1[o]).join("")}`}return String(Number(i.toPrecision(e))).replace("-","−")}var Ps=(i,e,t=`${e}s`)=>`${At(i)} ${i===1?e:t}`;function Kp(i){return i<10?`${At(Number(i.toPrecision(2)))} s`:i<90?`${Math.round(i)} s`:`${Math.floor(i/60)} min ${Math.round(i%60)} s`}var x1=/\b(boundary|boundaries|directrix|directrices|strips?|holes?|loops?|polygons?|polylines?|rows?|points?)((?: \d+(?![.\d%°])(?:,| and| or)?)+)/g;function Bl(i){return i.replace(x1,(e,t,n)=>t+n.replace(/\d+/g,s=>String(Number(s)+1))).replace(/(-?\d+(?:\.\d+)?e[+-]?\d+)\b/g,e=>At(Number(e))).replace(/(?<![\d.,])1 (places|points|triangles|edges|vertices|strips|boundaries|directrices|loops|members|nodes|rows)\b/g,(e,t)=>`1 ${y1(t)}`)}var y1=i=>({vertices:"vertex",boundaries:"boundary",directrices:"directrix"})[i]??i.slice(0,-1),v1=[[/^it is not of type "number"$/,"must be a number"],[/^it is not of types? .*"(number|integer)".*$/,"must be a number"],[/^it is not of type "array"$/,"must be a list such as [x, y, z]"]];function hx(i){let e=v1.find(([t])=>t.test(i));return e?e[1]:Bl(i)}var zl=300,Vl=118,Ho=46,vh=8,b1=8,dx=22;function Zp(i,e,t){let n=[],s=i.filter(o=>o.value!==null&&Number.isFinite(o.value)).map((o,a)=>({x:a,y:o.value})),r=i.filter(o=>o.residual!==null&&o.residual>0).map((o,a)=>({x:a,y:o.residual}));return s.length>=3&&n.push(fx(e,s,!1,null)),r.length>=3&&n.push(fx("Residual",r,!0,t)),n}function fx(i,e,t,n){let s=d=>t?Math.log10(d):d,r=e.map(({y:d})=>s(d));n!==null&&n>0&&r.push(s(n));let o=Math.min(...r),a=Math.max(...r);t&&([o,a]=[Math.floor(o),Math.ceil(a)]),a-o<1e-12*Math.max(Math.abs(a),1e-300)&&([o,a]=[o-Math.abs(o||1)*.01,a+Math.abs(a||1)*.01]);let l=e.at(-1).x||1,c=d=>Ho+(zl-Ho-vh)*d/l,u=d=>Vl-dx-(Vl-b1-dx)*(d-o)/(a-o),h=In("svg",{viewBox:`0 0 ${zl} ${Vl}`,class:"chart",role:"img","aria-label":`${i} over ${e.length} steps, from ${At(e[0].y,4)} to ${At(e.at(-1).y,4)}`});for(let d of S1(o,a,t))h.append(In("line",{class:"rule",x1:Ho,x2:zl-vh,y1:u(d).toFixed(1),y2:u(d).toFixed(1)}),In("text",{x:Ho-6,y:(u(d)+3.5).toFixed(1),"text-anchor":"end"},At(t?10**d:d,4)));return h.append(In("text",{x:Ho,y:Vl-6},"0"),In("text",{x:zl-vh,y:Vl-6,"text-anchor":"end"},`${At(e.length-1)} steps`)),n!==null&&n>0&&h.append(In("path",{class:"floor",d:`M${Ho},${u(s(n)).toFixed(1)}H${zl-vh}`})),h.append(In("path",{class:"curve",d:e.map((d,f)=>`${f?"L":"M"}${c(d.x).toFixed(1)},${u(s(d.y)).toFixed(1)}`).join("")})),ie("figure",{className:"chart-box"},ie("figcaption",{},i),h)}function S1(i,e,t){if(t){let l=Math.max(1,Math.ceil((e-i)/3));return Array.from({length:Math.floor((e-i)/l)+1},(c,u)=>i+u*l)}let n=(e-i)/3,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(l=>l*s).find(l=>l>=n)??n,o=Math.ceil(i/r)*r,a=[];for(let l=o;l<=e+1e-9*r;l+=r)a.push(Math.abs(l)<1e-9*r?0:l);return a.length>1?a:[i,e]}var px=i=>jt(i);be.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ue},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};$n.line={uniforms:Il.merge([be.common,be.fog,be.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var Go=class extends un{constructor(e){super({type:"LineMaterial",uniforms:Il.clone($n.line.uniforms),vertexShader:$n.line.vertexShader,fragmentShader:$n.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var mx=new je,bh=new P,Wo=class extends _l{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new ln(e,3)),this.setAttribute("uv",new ln(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new Ks(t,6,1);return this.setAttribute("instanceStart",new Qn(n,3,0)),this.setAttribute("instanceEnd",new Qn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new Ks(t,6,1);return this.setAttribute("instanceColorStart",new Qn(n,3,0)),this.setAttribute("instanceColorEnd",new Qn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new ll(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new je);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),mx.setFromBufferAttribute(t),this.boundingBox.union(mx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new kt),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)bh.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(bh)),bh.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(bh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Jp=new ot,gx=new P,_x=new P,wn=new ot,En=new ot,ji=new ot,jp=new P,Qp=new Re,Tn=new Sn,xx=new P,Sh=new je,Mh=new kt,Qi=new ot,es,Br;function yx(i,e,t){return Qi.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),Qi.multiplyScalar(1/Qi.w),Qi.x=Br/t.width,Qi.y=Br/t.height,Qi.applyMatrix4(i.projectionMatrixInverse),Qi.multiplyScalar(1/Qi.w),Math.abs(Math.max(Qi.x,Qi.y))}function M1(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Tn.start.fromBufferAttribute(s,a),Tn.end.fromBufferAttribute(r,a),Tn.applyMatrix4(t);let c=new P,u=new P;es.distanceSqToSegment(Tn.start,Tn.end,u,c),u.distanceTo(c)<Br*.5&&e.push({point:u,pointOnLine:c,distance:es.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function w1(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;es.at(1,ji),ji.w=1,ji.applyMatrix4(e.matrixWorldInverse),ji.applyMatrix4(n),ji.multiplyScalar(1/ji.w),ji.x*=r.x/2,ji.y*=r.y/2,ji.z=0,jp.copy(ji),Qp.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=u;d<f;d++){if(wn.fromBufferAttribute(l,d),En.fromBufferAttribute(c,d),wn.w=1,En.w=1,wn.applyMatrix4(Qp),En.applyMatrix4(Qp),wn.z>h&&En.z>h)continue;if(wn.z>h){let M=wn.z-En.z,b=(wn.z-h)/M;wn.lerp(En,b)}else if(En.z>h){let M=En.z-wn.z,b=(En.z-h)/M;En.lerp(wn,b)}wn.applyMatrix4(n),En.applyMatrix4(n),wn.multiplyScalar(1/wn.w),En.multiplyScalar(1/En.w),wn.x*=r.x/2,wn.y*=r.y/2,En.x*=r.x/2,En.y*=r.y/2,Tn.start.copy(wn),Tn.start.z=0,Tn.end.copy(En),Tn.end.z=0;let y=Tn.closestPointToPointParameter(jp,!0);Tn.at(y,xx);let m=Do.lerp(wn.z,En.z,y),_=m>=-1&&m<=1,v=jp.distanceTo(xx)<Br*.5;if(_&&v){Tn.start.fromBufferAttribute(l,d),Tn.end.fromBufferAttribute(c,d),Tn.start.applyMatrix4(o),Tn.end.applyMatrix4(o);let M=new P,b=new P;es.distanceSqToSegment(Tn.start,Tn.end,b,M),t.push({point:b,pointOnLine:M,distance:es.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var wh=class extends Tt{constructor(e=new Wo,t=new Go({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)gx.fromBufferAttribute(t,o),_x.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+gx.distanceTo(_x);let r=new Ks(s,2,1);return e.setAttribute("instanceDistanceStart",new Qn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Qn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;es=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Br=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Mh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Br*.5;else{let h=Math.max(s.near,Mh.distanceToPoint(es.origin));c=yx(s,h,l.resolution)}if(Mh.radius+=c,es.intersectsSphere(Mh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Sh.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Br*.5;else{let h=Math.max(s.near,Sh.distanceToPoint(es.origin));u=yx(s,h,l.resolution)}Sh.expandByScalar(u),es.intersectsBox(Sh)!==!1&&(n?M1(this,t):w1(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Jp),this.material.uniforms.resolution.value.set(Jp.z,Jp.w))}};var Xo=Math.pow(2,-24),Hl=Symbol("SKIP_GENERATION"),Eh={strategy:0,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[Hl]:!1};function Bt(i,e,t){return t.min.x=e[i],t.min.y=e[i+1],t.min.z=e[i+2],t.max.x=e[i+3],t.max.y=e[i+4],t.max.z=e[i+5],t}function Gl(i){let e=-1,t=-1/0;for(let n=0;n<3;n++){let s=i[n+3]-i[n];s>t&&(t=s,e=n)}return e}function em(i,e,t){for(let n=0;n<3;n++){let s=e[i+2*n],r=e[i+2*n+1],o=s-r,a=s+r;o<t[n]&&(t[n]=o),a>t[n+3]&&(t[n+3]=a)}}function Th(i){let e=i[3]-i[0],t=i[4]-i[1],n=i[5]-i[2];return 2*(e*t+t*n+n*e)}function mt(i,e){return e[i+15]===65535}function Rt(i,e){return e[i+6]}function Ot(i,e){return e[i+14]}function bt(i){return i+8}function St(i,e){let t=e[i+6];return i+t*8}function qo(i,e){return e[i+7]}function Ah(i,e,t,n,s){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0,h=1/0,d=1/0,f=1/0,g=-1/0,y=-1/0,m=-1/0,_=i.offset||0;for(let v=(e-_)*6,M=(e+t-_)*6;v<M;v+=6){let b=i[v+0],w=i[v+1],x=b-w,p=b+w;x<r&&(r=x),p>l&&(l=p),b<h&&(h=b),b>g&&(g=b);let S=i[v+2],A=i[v+3],E=S-A,C=S+A;E<o&&(o=E),C>c&&(c=C),S<d&&(d=S),S>y&&(y=S);let I=i[v+4],D=i[v+5],L=I-D,U=I+D;L<a&&(a=L),U>u&&(u=U),I<f&&(f=I),I>m&&(m=I)}n[0]=r,n[1]=o,n[2]=a,n[3]=l,n[4]=c,n[5]=u,s[0]=h,s[1]=d,s[2]=f,s[3]=g,s[4]=y,s[5]=m}var ns=8,nm=8,tm=new Int32Array(ns),ts=new Float32Array(ns*6),Yo=new Float32Array(ns*6),Ti=new Float32Array(6),Rh=new Float32Array(6),er=new Int32Array(nm),bx=new Float32Array(nm*6);function A1(i,e,t,n){for(let s=0;s<3;s++){let r=e[i+2*s],o=e[i+2*s+1],a=r-o,l=r+o;a<t[n+s]&&(t[n+s]=a),l>t[n+s+3]&&(t[n+s+3]=l)}}function Sx(i,e){let t=i[e+3]-i[e],n=i[e+4]-i[e+1],s=i[e+5]-i[e+2];return 2*(t*n+n*s+s*t)}function Mx(i,e,t,n,s,r){let o=-1,a=0;if(r===0)o=Gl(e),o!==-1&&(a=(e[o]+e[o+3])/2);else if(r===1)o=Gl(i),o!==-1&&(a=R1(t,n,s,o));else if(r===2){let l=Th(i),c=1.25*s,u=t.offset||0,h=(n-u)*6,d=(n+s-u)*6;for(let f=0;f<3;f++){let g=e[f],_=(e[f+3]-g)/ns;if(s<nm){for(let v=0;v<s;v++){let M=h+v*6,b=t[M+2*f],w=v;for(;w>0&&t[er[w-1]+2*f]>b;)er[w]=er[w-1],w--;er[w]=M}for(let v=0;v<3;v++)Ti[v]=1/0,Ti[v+3]=-1/0,Rh[v]=1/0,Rh[v+3]=-1/0;for(let v=s-1;v>=0;v--)em(er[v],t,Rh),bx.set(Rh,v*6);for(let v=0;v<s-1;v++){em(er[v],t,Ti);let M=t[er[v+1]+2*f];if(t[er[v]+2*f]===M)continue;let b=v+1,w=s-b,x=Th(Ti)/l,p=Sx(bx,b*6)/l,S=1+1.25*(x*b+p*w);S<c&&(o=f,c=S,a=M)}}else{for(let b=0;b<ns;b++){tm[b]=0;for(let w=0;w<3;w++)ts[b*6+w]=1/0,ts[b*6+w+3]=-1/0}for(let b=h;b<d;b+=6){let p=~~((t[b+2*f]-g)/_);p>=ns&&(p=ns-1),tm[p]++,A1(b,t,ts,p*6)}let v=(ns-1)*6;for(let b=0;b<6;b++)Yo[v+b]=ts[v+b];for(let b=ns-2;b>=0;b--){let w=b*6,x=w+6;for(let p=0;p<3;p++)Yo[w+p]=Math.min(ts[w+p],Yo[x+p]),Yo[w+p+3]=Math.max(ts[w+p+3],Yo[x+p+3])}let M=0;for(let b=0;b<ns-1;b++){let w=b*6,x=tm[b];if(x!==0)for(let C=0;C<3;C++)M===0?(Ti[C]=ts[w+C],Ti[C+3]=ts[w+C+3]):(Ti[C]=Math.min(Ti[C],ts[w+C]),Ti[C+3]=Math.max(Ti[C+3],ts[w+C+3]));M+=x;let p=0,S=0;M!==0&&(p=Th(Ti)/l);let A=s-M;A!==0&&(S=Sx(Yo,w+6)/l);let E=1+1.25*(p*M+S*A);E<c&&(o=f,c=E,a=g+_+b*_)}}}}else console.warn(`BVH: Invalid build strategy value ${r} used.`);return{axis:o,pos:a}}function R1(i,e,t,n){let s=0,r=i.offset;for(let o=e,a=e+t;o<a;o++)s+=i[(o-r)*6+n*2];return s/t}function wx(i,e,t,n,s,r){let o=n,a=n+s-1,l=r.pos,c=r.axis*2,u=t.offset||0;for(;;){for(;o<=a&&t[(o-u)*6+c]<l;)o++;for(;o<=a&&t[(a-u)*6+c]>=l;)a--;if(o<a){for(let h=0;h<e;h++){let d=i[o*e+h];i[o*e+h]=i[a*e+h],i[a*e+h]=d}for(let h=0;h<6;h++){let d=o-u,f=a-u,g=t[d*6+h];t[d*6+h]=t[f*6+h],t[f*6+h]=g}o++,a--}else return o}}var C1=Math.pow(2,32),$o=new Float32Array(6),Ch=new Float32Array(6);function P1(i,e,t,n,s,r){let{maxDepth:o,verbose:a,targetLeafSize:l,_strictLeafSize:c=1/0,strategy:u,onProgress:h,useSharedArrayBuffer:d=!1}=s,f=i.primitiveBuffer,g=i.primitiveBufferStride,y=d?SharedArrayBuffer:ArrayBuffer,m=new y(32*Math.max(1,2*Math.ceil(n)-1)),_=new Float32Array(m),v=new Uint32Array(m),M=new Uint16Array(m),b=0,w=!1;return Ah(e,t,n,$o,Ch),S(t,n,0),m.slice(0,b*32);function x(A){h&&h((A-r.offset)/r.count)}function p(A,E,C){let I=A*2;v[A+6]=E,M[I+14]=C,M[I+15]=65535,x(E+C)}function S(A,E,C){let I=b++,D=I*8;_.set($o,D),!w&&C>=o&&(w=!0,a&&console.warn(`BVH: Max depth of ${o} reached when generating BVH. Consider increasing maxDepth.`));let L=E>c;if(E<=l&&!L||C>=o){p(D,A,E);return}let U=Mx($o,Ch,e,A,E,u),V=U.axis===-1?-1:wx(f,g,e,A,E,U);if(U.axis===-1||V===A||V===A+E){if(!L){p(D,A,E);return}U.axis=Math.max(0,Gl($o)),V=A+Math.max(1,Math.floor(E/2))}v[D+7]=U.axis;let B=V-A;Ah(e,A,B,$o,Ch),S(A,B,C+1);let ne=b-I;if(ne>C1)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");v[D+6]=ne;let z=E-B;Ah(e,V,z,$o,Ch),S(V,z,C+1)}}function Ex(i,e){let t=i.getRootRanges(e.range),n=t[0],s=t[t.length-1],r={offset:n.offset,count:s.offset+s.count-n.offset},o=new Float32Array(6*r.count);o.offset=r.offset,i.computePrimitiveBounds(r.offset,r.count,o),i._roots=t.map(a=>P1(i,o,a.offset,a.count,e,r))}var tr=class{constructor(e){this._getNewPrimitive=e,this._primitives=[]}getPrimitive(){let e=this._primitives;return e.length===0?this._getNewPrimitive():e.pop()}releasePrimitive(e){this._primitives.push(e)}};var im=class{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;let e=[],t=null;this.setBuffer=n=>{t&&e.push(t),t=n,this.float32Array=new Float32Array(n),this.uint16Array=new Uint16Array(n),this.uint32Array=new Uint32Array(n)},this.clearBuffer=()=>{t=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,e.length!==0&&this.setBuffer(e.pop())}}},at=new im;var nr,Zo,Ko=[],Ph=new tr(()=>new je);function Tx(i,e,t,n,s,r){nr=Ph.getPrimitive(),Zo=Ph.getPrimitive(),Ko.push(nr,Zo),at.setBuffer(i._roots[e]);let o=sm(0,i.geometry,t,n,s,r);at.clearBuffer(),Ph.releasePrimitive(nr),Ph.releasePrimitive(Zo),Ko.pop(),Ko.pop();let a=Ko.length;return a>0&&(Zo=Ko[a-1],nr=Ko[a-2]),o}function sm(i,e,t,n,s=null,r=0,o=0){let{float32Array:a,uint16Array:l,uint32Array:c}=at,u=i*2;if(mt(u,l)){let d=Rt(i,c),f=Ot(u,l);return Bt(i,a,nr),n(d,f,!1,o,r+i/8,nr)}else{let E=function(I){let{uint16Array:D,uint32Array:L}=at,U=I*2;for(;!mt(U,D);)I=bt(I),U=I*2;return Rt(I,L)},C=function(I){let{uint16Array:D,uint32Array:L}=at,U=I*2;for(;!mt(U,D);)I=St(I,L),U=I*2;return Rt(I,L)+Ot(U,D)},d=bt(i),f=St(i,c),g=d,y=f,m,_,v,M;if(s&&(v=nr,M=Zo,Bt(g,a,v),Bt(y,a,M),m=s(v),_=s(M),_<m)){g=f,y=d;let I=m;m=_,_=I,v=M}v||(v=nr,Bt(g,a,v));let b=mt(g*2,l),w=t(v,b,m,o+1,r+g/8),x;if(w===2){let I=E(g),L=C(g)-I;x=n(I,L,!0,o+1,r+g/8,v)}else x=w&&sm(g,e,t,n,s,r,o+1);if(x)return!0;M=Zo,Bt(y,a,M);let p=mt(y*2,l),S=t(M,p,_,o+1,r+y/8),A;if(S===2){let I=E(y),L=C(y)-I;A=n(I,L,!0,o+1,r+y/8,M)}else A=S&&sm(y,e,t,n,s,r,o+1);return!!A}}var Wl=new at.constructor,Ih=new at.constructor,ir=new tr(()=>new je),Jo=new je,jo=new je,om=new je,am=new je,lm=!1;function Ax(i,e,t,n){if(lm)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");lm=!0;let s=i._roots,r=e._roots,o,a=0,l=0,c=new Re().copy(t).invert();for(let u=0,h=s.length;u<h;u++){Wl.setBuffer(s[u]),l=0;let d=ir.getPrimitive();Bt(0,Wl.float32Array,d),d.applyMatrix4(c);for(let f=0,g=r.length;f<g&&(Ih.setBuffer(r[f]),o=Ai(0,0,t,c,n,a,l,0,0,d),Ih.clearBuffer(),l+=r[f].byteLength/32,!o);f++);if(ir.releasePrimitive(d),Wl.clearBuffer(),a+=s[u].byteLength/32,o)break}return lm=!1,o}function Ai(i,e,t,n,s,r=0,o=0,a=0,l=0,c=null,u=!1){let h,d;u?(h=Ih,d=Wl):(h=Wl,d=Ih);let f=h.float32Array,g=h.uint32Array,y=h.uint16Array,m=d.float32Array,_=d.uint32Array,v=d.uint16Array,M=i*2,b=e*2,w=mt(M,y),x=mt(b,v),p=!1;if(x&&w)u?p=s(Rt(e,_),Ot(e*2,v),Rt(i,g),Ot(i*2,y),l,o+e/8,a,r+i/8):p=s(Rt(i,g),Ot(i*2,y),Rt(e,_),Ot(e*2,v),a,r+i/8,l,o+e/8);else if(x){let S=ir.getPrimitive();Bt(e,m,S),S.applyMatrix4(t);let A=bt(i),E=St(i,g);Bt(A,f,Jo),Bt(E,f,jo);let C=S.intersectsBox(Jo),I=S.intersectsBox(jo);p=C&&Ai(e,A,n,t,s,o,r,l,a+1,S,!u)||I&&Ai(e,E,n,t,s,o,r,l,a+1,S,!u),ir.releasePrimitive(S)}else{let S=bt(e),A=St(e,_);Bt(S,m,om),Bt(A,m,am);let E=c.intersectsBox(om),C=c.intersectsBox(am);if(E&&C)p=Ai(i,S,t,n,s,r,o,a,l+1,c,u)||Ai(i,A,t,n,s,r,o,a,l+1,c,u);else if(E)if(w)p=Ai(i,S,t,n,s,r,o,a,l+1,c,u);else{let I=ir.getPrimitive();I.copy(om).applyMatrix4(t);let D=bt(i),L=St(i,g);Bt(D,f,Jo),Bt(L,f,jo);let U=I.intersectsBox(Jo),V=I.intersectsBox(jo);p=U&&Ai(S,D,n,t,s,o,r,l,a+1,I,!u)||V&&Ai(S,L,n,t,s,o,r,l,a+1,I,!u),ir.releasePrimitive(I)}else if(C)if(w)p=Ai(i,A,t,n,s,r,o,a,l+1,c,u);else{let I=ir.getPrimitive();I.copy(am).applyMatrix4(t);let D=bt(i),L=St(i,g);Bt(D,f,Jo),Bt(L,f,jo);let U=I.intersectsBox(Jo),V=I.intersectsBox(jo);p=U&&Ai(A,D,n,t,s,o,r,l,a+1,I,!u)||V&&Ai(A,L,n,t,s,o,r,l,a+1,I,!u),ir.releasePrimitive(I)}}return p}var Lh=new class{constructor(){let i=null,e=null,t=null,n=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(r,o)=>{if(n)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=o,this.buffer=i=r._roots[o],this.uint16Array=t=new Uint16Array(i),this.uint32Array=e=new Uint32Array(i)},this.reset=()=>{this.root=null,this.buffer=i=null,this.uint16Array=t=null,this.uint32Array=e=null},this.getRangeStart=r=>{let o=r*2;for(;!mt(o,t);)r=bt(r),o=r*2;return Rt(r,e)},this.getRangeEnd=r=>{let o=r*2;for(;!mt(o,t);)r=St(r,e),o=r*2;return Rt(r,e)+Ot(o,t)};let s=(r,o,a)=>{let l=o*2,c=mt(l,t);if(!r(a,c,o)&&!c){let h=bt(o),d=St(o,e);s(r,h,a+1),s(r,d,a+1)}};this.traverseBuffer=r=>{if(n)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");n=!0;try{s(r,0,0)}finally{n=!1}},this.traverse=r=>{this.traverseBuffer((o,a,l)=>{if(a){let c=l*2,u=e[l+6],h=t[c+14];return r(o,a,new Float32Array(i,l*4,6),u,h)}else{let c=qo(l,e);return r(o,a,new Float32Array(i,l*4,6),c)}})}}};var Rx=new je,Qo=new Float32Array(6),Oh=class{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(e){e={...Eh,...e},"maxLeafSize"in e&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),e={...e,targetLeafSize:e.maxLeafSize}),Ex(this,e)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(e,t,n,s){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0;for(let h=e,d=e+t;h<d;h++){this.writePrimitiveBounds(h,Qo,0);let[f,g,y,m,_,v]=Qo;f<r&&(r=f),m>l&&(l=m),g<o&&(o=g),_>c&&(c=_),y<a&&(a=y),v>u&&(u=v)}return n[s+0]=r,n[s+1]=o,n[s+2]=a,n[s+3]=l,n[s+4]=c,n[s+5]=u,n}computePrimitiveBounds(e,t,n){let s=n.offset||0;for(let r=e,o=e+t;r<o;r++){this.writePrimitiveBounds(r,Qo,0);let[a,l,c,u,h,d]=Qo,f=(a+u)/2,g=(l+h)/2,y=(c+d)/2,m=(u-a)/2,_=(h-l)/2,v=(d-c)/2,M=(r-s)*6;n[M+0]=f,n[M+1]=m+(Math.abs(f)+m)*Xo,n[M+2]=g,n[M+3]=_+(Math.abs(g)+_)*Xo,n[M+4]=y,n[M+5]=v+(Math.abs(y)+v)*Xo}return n}shiftPrimitiveOffsets(e){let t=this._indirectBuffer;if(t)for(let n=0,s=t.length;n<s;n++)t[n]+=e;else{let n=this._roots;for(let s=0;s<n.length;s++){let r=n[s],o=new Uint32Array(r),a=new Uint16Array(r),l=r.byteLength/32;for(let c=0;c<l;c++){let u=8*c,h=2*u;mt(h,a)&&(o[u+6]+=e)}}}}traverse(e,t=0){Lh.setBVH(this,t),Lh.traverse(e),Lh.reset()}refit(){let e=this._roots;for(let t=0,n=e.length;t<n;t++){let s=e[t],r=new Uint32Array(s),o=new Uint16Array(s),a=new Float32Array(s),l=s.byteLength/32;for(let c=l-1;c>=0;c--){let u=c*8,h=u*2;if(mt(h,o)){let f=Rt(u,r),g=Ot(h,o);this.writePrimitiveRangeBounds(f,g,Qo,0),a.set(Qo,u)}else{let f=bt(u),g=St(u,r);for(let y=0;y<3;y++){let m=a[f+y],_=a[f+y+3],v=a[g+y],M=a[g+y+3];a[u+y]=m<v?m:v,a[u+y+3]=_>M?_:M}}}}}getBoundingBox(e){return e.makeEmpty(),this._roots.forEach(n=>{Bt(0,new Float32Array(n),Rx),e.union(Rx)}),e}shapecast(e){let{boundsTraverseOrder:t,intersectsBounds:n,intersectsRange:s,intersectsPrimitive:r,scratchPrimitive:o,iterate:a}=e;if(s&&r){let h=s;s=(d,f,g,y,m)=>h(d,f,g,y,m)?!0:a(d,f,this,r,g,y,o)}else s||(r?s=(h,d,f,g)=>a(h,d,this,r,f,g,o):s=(h,d,f)=>f);let l=!1,c=0,u=this._roots;for(let h=0,d=u.length;h<d;h++){let f=u[h];if(l=Tx(this,h,n,s,t,c),l)break;c+=f.byteLength/32}return l}bvhcast(e,t,n){let{intersectsRanges:s}=n;return Ax(this,e,t,s)}};function Cx(){return typeof SharedArrayBuffer<"u"}function cm(i){return i.index?i.index.count:i.attributes.position.count}function sr(i){return cm(i)/3}function L1(i,e=ArrayBuffer){return i>65535?new Uint32Array(new e(4*i)):new Uint16Array(new e(2*i))}function Px(i,e){if(!i.index){let t=i.attributes.position.count,n=e.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,s=L1(t,n);i.setIndex(new pt(s,1));for(let r=0;r<t;r++)s[r]=r}}function O1(i,e,t){let n=cm(i)/t,s=e||i.drawRange,r=s.start/t,o=(s.start+s.count)/t,a=Math.max(0,r),l=Math.min(n,o)-a;return{offset:Math.floor(a),count:Math.floor(l)}}function N1(i,e){return i.groups.map(t=>({offset:t.start/e,count:t.count/e}))}function um(i,e,t){let n=O1(i,e,t),s=N1(i,t);if(!s.length)return[n];let r=[],o=n.offset,a=n.offset+n.count,l=cm(i)/t,c=[];for(let d of s){let{offset:f,count:g}=d,y=f,m=isFinite(g)?g:l-f,_=f+m;y<a&&_>o&&(c.push({pos:Math.max(o,y),isStart:!0}),c.push({pos:Math.min(a,_),isStart:!1}))}c.sort((d,f)=>d.pos!==f.pos?d.pos-f.pos:d.type==="end"?-1:1);let u=0,h=null;for(let d of c){let f=d.pos;u!==0&&f!==h&&r.push({offset:h,count:f-h}),u+=d.isStart?1:-1,h=f}return r}function D1(i,e){let t=i[i.length-1],n=t.offset+t.count>2**16,s=i.reduce((c,u)=>c+u.count,0),r=n?4:2,o=e?new SharedArrayBuffer(s*r):new ArrayBuffer(s*r),a=n?new Uint32Array(o):new Uint16Array(o),l=0;for(let c=0;c<i.length;c++){let{offset:u,count:h}=i[c];for(let d=0;d<h;d++)a[l+d]=u+d;l+=h}return a}var Nh=class extends Oh{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(e){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(e){}constructor(e,t={}){if(e.isBufferGeometry){if(e.index&&e.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(t.useSharedArrayBuffer&&!Cx())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=e,this.resolvePrimitiveIndex=t.indirect?n=>this._indirectBuffer[n]:n=>n,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,t={...Eh,...t},t[Hl]||this.init(t)}init(e){let{geometry:t,primitiveStride:n}=this;if(e.indirect){let s=um(t,e.range,n),r=D1(s,e.useSharedArrayBuffer);this._indirectBuffer=r}else Px(t,e);super.init(e),!t.boundingBox&&e.setBoundingBox&&(t.boundingBox=this.getBoundingBox(new je))}getRootRanges(e){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:um(this.geometry,e,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}};var li=class{constructor(){this.min=1/0,this.max=-1/0}setFromPointsField(e,t){let n=1/0,s=-1/0;for(let r=0,o=e.length;r<o;r++){let l=e[r][t];n=l<n?l:n,s=l>s?l:s}this.min=n,this.max=s}setFromPoints(e,t){let n=1/0,s=-1/0;for(let r=0,o=t.length;r<o;r++){let a=t[r],l=e.dot(a);n=l<n?l:n,s=l>s?l:s}this.min=n,this.max=s}isSeparated(e){return this.min>e.max||e.min>this.max}};li.prototype.setFromBox=(function(){let i=new P;return function(t,n){let s=n.min,r=n.max,o=1/0,a=-1/0;for(let l=0;l<=1;l++)for(let c=0;c<=1;c++)for(let u=0;u<=1;u++){i.x=s.x*l+r.x*(1-l),i.y=s.y*c+r.y*(1-c),i.z=s.z*u+r.z*(1-u);let h=t.dot(i);o=Math.min(h,o),a=Math.max(h,a)}this.min=o,this.max=a}})();var U1=(function(){let i=new P,e=new P,t=new P;return function(s,r,o){let a=s.start,l=i,c=r.start,u=e;t.subVectors(a,c),i.subVectors(s.end,s.start),e.subVectors(r.end,r.start);let h=t.dot(u),d=u.dot(l),f=u.dot(u),g=t.dot(l),m=l.dot(l)*f-d*d,_,v;m!==0?_=(h*d-g*f)/m:_=0,v=(h+_*d)/f,o.x=_,o.y=v}})(),Xl=(function(){let i=new Ue,e=new P,t=new P;return function(s,r,o,a){U1(s,r,i);let l=i.x,c=i.y;if(l>=0&&l<=1&&c>=0&&c<=1){s.at(l,o),r.at(c,a);return}else if(l>=0&&l<=1){c<0?r.at(0,a):r.at(1,a),s.closestPointToPoint(a,!0,o);return}else if(c>=0&&c<=1){l<0?s.at(0,o):s.at(1,o),r.closestPointToPoint(o,!0,a);return}else{let u;l<0?u=s.start:u=s.end;let h;c<0?h=r.start:h=r.end;let d=e,f=t;if(s.closestPointToPoint(h,!0,e),r.closestPointToPoint(u,!0,t),d.distanceToSquared(h)<=f.distanceToSquared(u)){o.copy(d),a.copy(h);return}else{o.copy(u),a.copy(f);return}}}})(),Ix=(function(){let i=new P,e=new P,t=new Hn,n=new Sn;return function(r,o){let{radius:a,center:l}=r,{a:c,b:u,c:h}=o;if(n.start=c,n.end=u,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a||(n.start=c,n.end=h,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a)||(n.start=u,n.end=h,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a))return!0;let y=o.getPlane(t);if(Math.abs(y.distanceToPoint(l))<=a){let _=y.projectPoint(l,e);if(o.containsPoint(_))return!0}return!1}})();var F1=["x","y","z"],Is=1e-15,Lx=Is*Is;function xi(i){return Math.abs(i)<Is}var An=class extends Un{constructor(...e){super(...e),this.isExtendedTriangle=!0,this.satAxes=new Array(4).fill().map(()=>new P),this.satBounds=new Array(4).fill().map(()=>new li),this.points=[this.a,this.b,this.c],this.plane=new Hn,this.isDegenerateIntoSegment=!1,this.isDegenerateIntoPoint=!1,this.degenerateSegment=new Sn,this.needsUpdate=!0}intersectsSphere(e){return Ix(e,this)}update(){let e=this.a,t=this.b,n=this.c,s=this.points,r=this.satAxes,o=this.satBounds,a=r[0],l=o[0];this.getNormal(a),l.setFromPoints(a,s);let c=r[1],u=o[1];c.subVectors(e,t),u.setFromPoints(c,s);let h=r[2],d=o[2];h.subVectors(t,n),d.setFromPoints(h,s);let f=r[3],g=o[3];f.subVectors(n,e),g.setFromPoints(f,s);let y=c.length(),m=h.length(),_=f.length();this.isDegenerateIntoPoint=!1,this.isDegenerateIntoSegment=!1,y<Is?m<Is||_<Is?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(e),this.degenerateSegment.end.copy(n)):m<Is?_<Is?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(t),this.degenerateSegment.end.copy(e)):_<Is&&(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(n),this.degenerateSegment.end.copy(t)),this.plane.setFromNormalAndCoplanarPoint(a,e),this.needsUpdate=!1}};An.prototype.closestPointToSegment=(function(){let i=new P,e=new P,t=new Sn;return function(s,r=null,o=null){this.needsUpdate&&this.update();let{start:a,end:l}=s,c=this.points,u,h=1/0,d=this.plane.distanceToPoint(a),f=this.plane.distanceToPoint(l);if(d*f<0&&this.plane.intersectLine(s,i)!==null&&this.containsPoint(i))return r&&r.copy(i),o&&o.copy(i),0;for(let g=0;g<3;g++){let y=(g+1)%3;t.start.copy(c[g]),t.end.copy(c[y]),Xl(t,s,i,e),u=i.distanceToSquared(e),u<h&&(h=u,r&&r.copy(i),o&&o.copy(e))}return this.closestPointToPoint(a,i),u=a.distanceToSquared(i),u<h&&(h=u,r&&r.copy(i),o&&o.copy(a)),this.closestPointToPoint(l,i),u=l.distanceToSquared(i),u<h&&(h=u,r&&r.copy(i),o&&o.copy(l)),Math.sqrt(h)}})();An.prototype.intersectsTriangle=(function(){let i=new An,e=new li,t=new li,n=new P,s=new P,r=new P,o=new P,a=new Sn,l=new Sn,c=new P,u=new Ue,h=new Ue;function d(M,b,w,x){let p=n;!M.isDegenerateIntoPoint&&!M.isDegenerateIntoSegment?p.copy(M.plane.normal):p.copy(b.plane.normal);let S=M.satBounds,A=M.satAxes;for(let I=1;I<4;I++){let D=S[I],L=A[I];if(e.setFromPoints(L,b.points),D.isSeparated(e)||(o.copy(p).cross(L),e.setFromPoints(o,M.points),t.setFromPoints(o,b.points),e.isSeparated(t)))return!1}let E=b.satBounds,C=b.satAxes;for(let I=1;I<4;I++){let D=E[I],L=C[I];if(e.setFromPoints(L,M.points),D.isSeparated(e)||(o.crossVectors(p,L),e.setFromPoints(o,M.points),t.setFromPoints(o,b.points),e.isSeparated(t)))return!1}return w&&(x||console.warn("ExtendedTriangle.intersectsTriangle: Triangles are coplanar which does not support an output edge. Setting edge to 0, 0, 0."),w.start.set(0,0,0),w.end.set(0,0,0)),!0}function f(M,b,w,x,p,S,A,E,C,I,D){let L=A/(A-E);I.x=x+(p-x)*L,D.start.subVectors(b,M).multiplyScalar(L).add(M),L=A/(A-C),I.y=x+(S-x)*L,D.end.subVectors(w,M).multiplyScalar(L).add(M)}function g(M,b,w,x,p,S,A,E,C,I,D){if(p>0)f(M.c,M.a,M.b,x,b,w,C,A,E,I,D);else if(S>0)f(M.b,M.a,M.c,w,b,x,E,A,C,I,D);else if(E*C>0||A!=0)f(M.a,M.b,M.c,b,w,x,A,E,C,I,D);else if(E!=0)f(M.b,M.a,M.c,w,b,x,E,A,C,I,D);else if(C!=0)f(M.c,M.a,M.b,x,b,w,C,A,E,I,D);else return!0;return!1}function y(M,b,w,x){let p=b.degenerateSegment,S=M.plane.distanceToPoint(p.start),A=M.plane.distanceToPoint(p.end);return xi(S)?xi(A)?d(M,b,w,x):(w&&(w.start.copy(p.start),w.end.copy(p.start)),M.containsPoint(p.start)):xi(A)?(w&&(w.start.copy(p.end),w.end.copy(p.end)),M.containsPoint(p.end)):M.plane.intersectLine(p,n)!=null?(w&&(w.start.copy(n),w.end.copy(n)),M.containsPoint(n)):!1}function m(M,b,w){let x=b.a;return xi(M.plane.distanceToPoint(x))&&M.containsPoint(x)?(w&&(w.start.copy(x),w.end.copy(x)),!0):!1}function _(M,b,w){let x=M.degenerateSegment,p=b.a;return x.closestPointToPoint(p,!0,n),p.distanceToSquared(n)<Lx?(w&&(w.start.copy(p),w.end.copy(p)),!0):!1}function v(M,b,w,x){if(M.isDegenerateIntoSegment)if(b.isDegenerateIntoSegment){let p=M.degenerateSegment,S=b.degenerateSegment,A=s,E=r;p.delta(A),S.delta(E);let C=n.subVectors(S.start,p.start),I=A.x*E.y-A.y*E.x;if(xi(I))return!1;let D=(C.x*E.y-C.y*E.x)/I,L=-(A.x*C.y-A.y*C.x)/I;if(D<0||D>1||L<0||L>1)return!1;let U=p.start.z+A.z*D,V=S.start.z+E.z*L;return xi(U-V)?(w&&(w.start.copy(p.start).addScaledVector(A,D),w.end.copy(p.start).addScaledVector(A,D)),!0):!1}else return b.isDegenerateIntoPoint?_(M,b,w):y(b,M,w,x);else{if(M.isDegenerateIntoPoint)return b.isDegenerateIntoPoint?b.a.distanceToSquared(M.a)<Lx?(w&&(w.start.copy(M.a),w.end.copy(M.a)),!0):!1:b.isDegenerateIntoSegment?_(b,M,w):m(b,M,w);if(b.isDegenerateIntoPoint)return m(M,b,w);if(b.isDegenerateIntoSegment)return y(M,b,w,x)}}return function(b,w=null,x=!1){this.needsUpdate&&this.update(),b.isExtendedTriangle?b.needsUpdate&&b.update():(i.copy(b),i.update(),b=i);let p=v(this,b,w,x);if(p!==void 0)return p;let S=this.plane,A=b.plane,E=A.distanceToPoint(this.a),C=A.distanceToPoint(this.b),I=A.distanceToPoint(this.c);xi(E)&&(E=0),xi(C)&&(C=0),xi(I)&&(I=0);let D=E*C,L=E*I;if(D>0&&L>0)return!1;let U=S.distanceToPoint(b.a),V=S.distanceToPoint(b.b),B=S.distanceToPoint(b.c);xi(U)&&(U=0),xi(V)&&(V=0),xi(B)&&(B=0);let ne=U*V,z=U*B;if(ne>0&&z>0)return!1;s.copy(S.normal),r.copy(A.normal);let q=s.cross(r),W=0,ge=Math.abs(q.x),Ee=Math.abs(q.y);Ee>ge&&(ge=Ee,W=1),Math.abs(q.z)>ge&&(W=2);let ae=F1[W],se=this.a[ae],ce=this.b[ae],re=this.c[ae],he=b.a[ae],We=b.b[ae],Te=b.c[ae];if(g(this,se,ce,re,D,L,E,C,I,u,a))return d(this,b,w,x);if(g(b,he,We,Te,ne,z,U,V,B,h,l))return d(this,b,w,x);if(u.y<u.x){let ke=u.y;u.y=u.x,u.x=ke,c.copy(a.start),a.start.copy(a.end),a.end.copy(c)}if(h.y<h.x){let ke=h.y;h.y=h.x,h.x=ke,c.copy(l.start),l.start.copy(l.end),l.end.copy(c)}return u.y<h.x||h.y<u.x?!1:(w&&(h.x>u.x?w.start.copy(l.start):w.start.copy(a.start),h.y<u.y?w.end.copy(l.end):w.end.copy(a.end)),!0)}})();An.prototype.distanceToPoint=(function(){let i=new P;return function(t){return this.closestPointToPoint(t,i),t.distanceTo(i)}})();An.prototype.distanceToTriangle=(function(){let i=new P,e=new P,t=["a","b","c"],n=new Sn,s=new Sn;return function(o,a=null,l=null){let c=a||l?n:null;if(this.intersectsTriangle(o,c,!0))return(a||l)&&(a&&c.getCenter(a),l&&c.getCenter(l)),0;let u=1/0;for(let h=0;h<3;h++){let d,f=t[h],g=o[f];this.closestPointToPoint(g,i),d=g.distanceToSquared(i),d<u&&(u=d,a&&a.copy(i),l&&l.copy(g));let y=this[f];o.closestPointToPoint(y,i),d=y.distanceToSquared(i),d<u&&(u=d,a&&a.copy(y),l&&l.copy(i))}for(let h=0;h<3;h++){let d=t[h],f=t[(h+1)%3];n.set(this[d],this[f]);for(let g=0;g<3;g++){let y=t[g],m=t[(g+1)%3];s.set(o[y],o[m]),Xl(n,s,i,e);let _=i.distanceToSquared(e);_<u&&(u=_,a&&a.copy(i),l&&l.copy(e))}}return Math.sqrt(u)}})();var Qt=class{constructor(e,t,n){this.isOrientedBox=!0,this.min=new P,this.max=new P,this.matrix=new Re,this.invMatrix=new Re,this.points=new Array(8).fill().map(()=>new P),this.satAxes=new Array(3).fill().map(()=>new P),this.satBounds=new Array(3).fill().map(()=>new li),this.alignedSatBounds=new Array(3).fill().map(()=>new li),this.needsUpdate=!1,e&&this.min.copy(e),t&&this.max.copy(t),n&&this.matrix.copy(n)}set(e,t,n){this.min.copy(e),this.max.copy(t),this.matrix.copy(n),this.needsUpdate=!0}copy(e){this.min.copy(e.min),this.max.copy(e.max),this.matrix.copy(e.matrix),this.needsUpdate=!0}};Qt.prototype.update=(function(){return function(){let e=this.matrix,t=this.min,n=this.max,s=this.points;for(let c=0;c<=1;c++)for(let u=0;u<=1;u++)for(let h=0;h<=1;h++){let d=1*c|2*u|4*h,f=s[d];f.x=c?n.x:t.x,f.y=u?n.y:t.y,f.z=h?n.z:t.z,f.applyMatrix4(e)}let r=this.satBounds,o=this.satAxes,a=s[0];for(let c=0;c<3;c++){let u=o[c],h=r[c],d=1<<c,f=s[d];u.subVectors(a,f),h.setFromPoints(u,s)}let l=this.alignedSatBounds;l[0].setFromPointsField(s,"x"),l[1].setFromPointsField(s,"y"),l[2].setFromPointsField(s,"z"),this.invMatrix.copy(this.matrix).invert(),this.needsUpdate=!1}})();Qt.prototype.intersectsBox=(function(){let i=new li;return function(t){this.needsUpdate&&this.update();let n=t.min,s=t.max,r=this.satBounds,o=this.satAxes,a=this.alignedSatBounds;if(i.min=n.x,i.max=s.x,a[0].isSeparated(i)||(i.min=n.y,i.max=s.y,a[1].isSeparated(i))||(i.min=n.z,i.max=s.z,a[2].isSeparated(i)))return!1;for(let l=0;l<3;l++){let c=o[l],u=r[l];if(i.setFromBox(c,t),u.isSeparated(i))return!1}return!0}})();Qt.prototype.intersectsTriangle=(function(){let i=new An,e=new Array(3),t=new li,n=new li,s=new P;return function(o){this.needsUpdate&&this.update(),o.isExtendedTriangle?o.needsUpdate&&o.update():(i.copy(o),i.update(),o=i);let a=this.satBounds,l=this.satAxes;e[0]=o.a,e[1]=o.b,e[2]=o.c;for(let d=0;d<3;d++){let f=a[d],g=l[d];if(t.setFromPoints(g,e),f.isSeparated(t))return!1}let c=o.satBounds,u=o.satAxes,h=this.points;for(let d=0;d<3;d++){let f=c[d],g=u[d];if(t.setFromPoints(g,h),f.isSeparated(t))return!1}for(let d=0;d<3;d++){let f=l[d];for(let g=0;g<4;g++){let y=u[g];if(s.crossVectors(f,y),t.setFromPoints(s,e),n.setFromPoints(s,h),t.isSeparated(n))return!1}}return!0}})();Qt.prototype.closestPointToPoint=(function(){return function(e,t){return this.needsUpdate&&this.update(),t.copy(e).applyMatrix4(this.invMatrix).clamp(this.min,this.max).applyMatrix4(this.matrix),t}})();Qt.prototype.distanceToPoint=(function(){let i=new P;return function(t){return this.closestPointToPoint(t,i),t.distanceTo(i)}})();Qt.prototype.distanceToBox=(function(){let i=["x","y","z"],e=new Array(12).fill().map(()=>new Sn),t=new Array(12).fill().map(()=>new Sn),n=new P,s=new P;return function(o,a=0,l=null,c=null){if(this.needsUpdate&&this.update(),this.intersectsBox(o))return(l||c)&&(o.getCenter(s),this.closestPointToPoint(s,n),o.closestPointToPoint(n,s),l&&l.copy(n),c&&c.copy(s)),0;let u=a*a,h=o.min,d=o.max,f=this.points,g=1/0;for(let m=0;m<8;m++){let _=f[m];s.copy(_).clamp(h,d);let v=_.distanceToSquared(s);if(v<g&&(g=v,l&&l.copy(_),c&&c.copy(s),v<u))return Math.sqrt(v)}let y=0;for(let m=0;m<3;m++)for(let _=0;_<=1;_++)for(let v=0;v<=1;v++){let M=(m+1)%3,b=(m+2)%3,w=_<<M|v<<b,x=1<<m|_<<M|v<<b,p=f[w],S=f[x];e[y].set(p,S);let E=i[m],C=i[M],I=i[b],D=t[y],L=D.start,U=D.end;L[E]=h[E],L[C]=_?h[C]:d[C],L[I]=v?h[I]:d[I],U[E]=d[E],U[C]=_?h[C]:d[C],U[I]=v?h[I]:d[I],y++}for(let m=0;m<=1;m++)for(let _=0;_<=1;_++)for(let v=0;v<=1;v++){s.x=m?d.x:h.x,s.y=_?d.y:h.y,s.z=v?d.z:h.z,this.closestPointToPoint(s,n);let M=s.distanceToSquared(n);if(M<g&&(g=M,l&&l.copy(n),c&&c.copy(s),M<u))return Math.sqrt(M)}for(let m=0;m<12;m++){let _=e[m];for(let v=0;v<12;v++){let M=t[v];Xl(_,M,n,s);let b=n.distanceToSquared(s);if(b<g&&(g=b,l&&l.copy(n),c&&c.copy(s),b<u))return Math.sqrt(b)}}return Math.sqrt(g)}})();var hm=class extends tr{constructor(){super(()=>new An)}},Kn=new hm;var ql=new P,dm=new P;function Ox(i,e,t={},n=0,s=1/0){let r=n*n,o=s*s,a=1/0,l=null;if(i.shapecast({boundsTraverseOrder:u=>(ql.copy(e).clamp(u.min,u.max),ql.distanceToSquared(e)),intersectsBounds:(u,h,d)=>d<a&&d<o,intersectsTriangle:(u,h)=>{u.closestPointToPoint(e,ql);let d=e.distanceToSquared(ql);return d<a&&(dm.copy(ql),a=d,l=h),d<r}}),a===1/0)return null;let c=Math.sqrt(a);return t.point?t.point.copy(dm):t.point=dm.clone(),t.distance=c,t.faceIndex=l,t}var Dh=parseInt("187")>=169,k1=parseInt("187")<=161,zr=new P,Vr=new P,Hr=new P,Uh=new Ue,Fh=new Ue,kh=new Ue,Nx=new P,Dx=new P,Ux=new P,Yl=new P;function B1(i,e,t,n,s,r,o,a){let l;if(r===Mn?l=i.intersectTriangle(n,t,e,!0,s):l=i.intersectTriangle(e,t,n,r!==rn,s),l===null)return null;let c=i.origin.distanceTo(s);return c<o||c>a?null:{distance:c,point:s.clone()}}function Fx(i,e,t,n,s,r,o,a,l,c,u){zr.fromBufferAttribute(e,r),Vr.fromBufferAttribute(e,o),Hr.fromBufferAttribute(e,a);let h=B1(i,zr,Vr,Hr,Yl,l,c,u);if(h){if(n){Uh.fromBufferAttribute(n,r),Fh.fromBufferAttribute(n,o),kh.fromBufferAttribute(n,a),h.uv=new Ue;let f=Un.getInterpolation(Yl,zr,Vr,Hr,Uh,Fh,kh,h.uv);Dh||(h.uv=f)}if(s){Uh.fromBufferAttribute(s,r),Fh.fromBufferAttribute(s,o),kh.fromBufferAttribute(s,a),h.uv1=new Ue;let f=Un.getInterpolation(Yl,zr,Vr,Hr,Uh,Fh,kh,h.uv1);Dh||(h.uv1=f),k1&&(h.uv2=h.uv1)}if(t){Nx.fromBufferAttribute(t,r),Dx.fromBufferAttribute(t,o),Ux.fromBufferAttribute(t,a),h.normal=new P;let f=Un.getInterpolation(Yl,zr,Vr,Hr,Nx,Dx,Ux,h.normal);h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1),Dh||(h.normal=f)}let d={a:r,b:o,c:a,normal:new P,materialIndex:0};if(Un.getNormal(zr,Vr,Hr,d.normal),h.face=d,h.faceIndex=r,Dh){let f=new P;Un.getBarycoord(Yl,zr,Vr,Hr,f),h.barycoord=f}}return h}function kx(i){return i&&i.isMaterial?i.side:i}function ea(i,e,t,n,s,r,o){let a=n*3,l=a+0,c=a+1,u=a+2,{index:h,groups:d}=i;i.index&&(l=h.getX(l),c=h.getX(c),u=h.getX(u));let{position:f,normal:g,uv:y,uv1:m}=i.attributes;if(Array.isArray(e)){let _=n*3;for(let v=0,M=d.length;v<M;v++){let{start:b,count:w,materialIndex:x}=d[v];if(_>=b&&_<b+w){let p=kx(e[x]),S=Fx(t,f,g,y,m,l,c,u,p,r,o);if(S)if(S.faceIndex=n,S.face.materialIndex=x,s)s.push(S);else return S}}}else{let _=kx(e),v=Fx(t,f,g,y,m,l,c,u,_,r,o);if(v)if(v.faceIndex=n,v.face.materialIndex=0,s)s.push(v);else return v}return null}function zt(i,e,t,n){let s=i.a,r=i.b,o=i.c,a=e,l=e+1,c=e+2;t&&(a=t.getX(a),l=t.getX(l),c=t.getX(c)),s.x=n.getX(a),s.y=n.getY(a),s.z=n.getZ(a),r.x=n.getX(l),r.y=n.getY(l),r.z=n.getZ(l),o.x=n.getX(c),o.y=n.getY(c),o.z=n.getZ(c)}function Bx(i,e,t,n,s,r,o,a){let{geometry:l,_indirectBuffer:c}=i;for(let u=n,h=n+s;u<h;u++)ea(l,e,t,u,r,o,a)}function zx(i,e,t,n,s,r,o){let{geometry:a,_indirectBuffer:l}=i,c=1/0,u=null;for(let h=n,d=n+s;h<d;h++){let f;f=ea(a,e,t,h,null,r,o),f&&f.distance<c&&(u=f,c=f.distance)}return u}function Vx(i,e,t,n,s,r,o){let{geometry:a}=t,{index:l}=a,c=a.attributes.position;for(let u=i,h=e+i;u<h;u++){let d;if(d=u,zt(o,d*3,l,c),o.needsUpdate=!0,n(o,d,s,r))return!0}return!1}function Hx(i,e=null){e&&Array.isArray(e)&&(e=new Set(e));let t=i.geometry,n=t.index?t.index.array:null,s=t.attributes.position,r,o,a,l,c=0,u=i._roots;for(let d=0,f=u.length;d<f;d++)r=u[d],o=new Uint32Array(r),a=new Uint16Array(r),l=new Float32Array(r),h(0,c),c+=r.byteLength;function h(d,f,g=!1){let y=d*2;if(mt(y,a)){let m=Rt(d,o),_=Ot(y,a),v=1/0,M=1/0,b=1/0,w=-1/0,x=-1/0,p=-1/0;for(let S=3*m,A=3*(m+_);S<A;S++){let E=n[S],C=s.getX(E),I=s.getY(E),D=s.getZ(E);C<v&&(v=C),C>w&&(w=C),I<M&&(M=I),I>x&&(x=I),D<b&&(b=D),D>p&&(p=D)}return l[d+0]!==v||l[d+1]!==M||l[d+2]!==b||l[d+3]!==w||l[d+4]!==x||l[d+5]!==p?(l[d+0]=v,l[d+1]=M,l[d+2]=b,l[d+3]=w,l[d+4]=x,l[d+5]=p,!0):!1}else{let m=bt(d),_=St(d,o),v=g,M=!1,b=!1;if(e){if(!v){let E=m/8+f/32,C=_/8+f/32;M=e.has(E),b=e.has(C),v=!M&&!b}}else M=!0,b=!0;let w=v||M,x=v||b,p=!1;w&&(p=h(m,f,v));let S=!1;x&&(S=h(_,f,v));let A=p||S;if(A)for(let E=0;E<3;E++){let C=m+E,I=_+E,D=l[C],L=l[C+3],U=l[I],V=l[I+3];l[d+E]=D<U?D:U,l[d+E+3]=L>V?L:V}return A}}}function Bn(i,e,t,n,s){let r,o,a,l,c,u,h=1/t.direction.x,d=1/t.direction.y,f=1/t.direction.z,g=t.origin.x,y=t.origin.y,m=t.origin.z,_=e[i],v=e[i+3],M=e[i+1],b=e[i+3+1],w=e[i+2],x=e[i+3+2];return h>=0?(r=(_-g)*h,o=(v-g)*h):(r=(v-g)*h,o=(_-g)*h),d>=0?(a=(M-y)*d,l=(b-y)*d):(a=(b-y)*d,l=(M-y)*d),r>l||a>o||((a>r||isNaN(r))&&(r=a),(l<o||isNaN(o))&&(o=l),f>=0?(c=(w-m)*f,u=(x-m)*f):(c=(x-m)*f,u=(w-m)*f),r>u||c>o)?!1:((c>r||r!==r)&&(r=c),(u<o||o!==o)&&(o=u),r<=s&&o>=n)}function Gx(i,e,t,n,s,r,o,a){let{geometry:l,_indirectBuffer:c}=i;for(let u=n,h=n+s;u<h;u++){let d=c?c[u]:u;ea(l,e,t,d,r,o,a)}}function Wx(i,e,t,n,s,r,o){let{geometry:a,_indirectBuffer:l}=i,c=1/0,u=null;for(let h=n,d=n+s;h<d;h++){let f;f=ea(a,e,t,l?l[h]:h,null,r,o),f&&f.distance<c&&(u=f,c=f.distance)}return u}function Xx(i,e,t,n,s,r,o){let{geometry:a}=t,{index:l}=a,c=a.attributes.position;for(let u=i,h=e+i;u<h;u++){let d;if(d=t.resolveTriangleIndex(u),zt(o,d*3,l,c),o.needsUpdate=!0,n(o,d,s,r))return!0}return!1}function qx(i,e,t,n,s,r,o){at.setBuffer(i._roots[e]),Bn(0,at.float32Array,n,r,o)&&fm(0,i,t,n,s,r,o),at.clearBuffer()}function fm(i,e,t,n,s,r,o){let{float32Array:a,uint16Array:l,uint32Array:c}=at,u=i*2;if(mt(u,l)){let d=Rt(i,c),f=Ot(u,l);Bx(e,t,n,d,f,s,r,o)}else{let d=bt(i);Bn(d,a,n,r,o)&&fm(d,e,t,n,s,r,o);let f=St(i,c);Bn(f,a,n,r,o)&&fm(f,e,t,n,s,r,o)}}var z1=["x","y","z"];function Yx(i,e,t,n,s,r){at.setBuffer(i._roots[e]);let o=null;return Bn(0,at.float32Array,n,s,r)&&(o=pm(0,i,t,n,s,r)),at.clearBuffer(),o}function pm(i,e,t,n,s,r){let{float32Array:o,uint16Array:a,uint32Array:l}=at,c=i*2;if(mt(c,a)){let h=Rt(i,l),d=Ot(c,a);return zx(e,t,n,h,d,s,r)}else{let h=qo(i,l),d=z1[h],g=n.direction[d]>=0,y,m;g?(y=bt(i),m=St(i,l)):(y=St(i,l),m=bt(i));let v=Bn(y,o,n,s,r)?pm(y,e,t,n,s,r):null;if(v){let w=v.point[d];if(g?w<=o[m+h]:w>=o[m+h+3])return v}let b=Bn(m,o,n,s,r)?pm(m,e,t,n,s,r):null;return v&&b?v.distance<=b.distance?v:b:v||b||null}}var Bh=new je,ta=new An,na=new An,$l=new Re,$x=new Qt,zh=new Qt;function Kx(i,e,t,n){at.setBuffer(i._roots[e]);let s=mm(0,i,t,n);return at.clearBuffer(),s}function mm(i,e,t,n,s=null){let{float32Array:r,uint16Array:o,uint32Array:a}=at,l=i*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),$x.set(t.boundingBox.min,t.boundingBox.max,n),s=$x),mt(l,o)){let u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,g=t.attributes.position,y=Rt(i,a),m=Ot(l,o);if($l.copy(n).invert(),t.boundsTree)return Bt(i,r,zh),zh.matrix.copy($l),zh.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>zh.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(n),v.b.applyMatrix4(n),v.c.applyMatrix4(n),v.needsUpdate=!0;for(let M=y*3,b=(m+y)*3;M<b;M+=3)if(zt(na,M,h,d),na.needsUpdate=!0,v.intersectsTriangle(na))return!0;return!1}});{let _=sr(t);for(let v=y*3,M=(m+y)*3;v<M;v+=3){zt(ta,v,h,d),ta.a.applyMatrix4($l),ta.b.applyMatrix4($l),ta.c.applyMatrix4($l),ta.needsUpdate=!0;for(let b=0,w=_*3;b<w;b+=3)if(zt(na,b,f,g),na.needsUpdate=!0,ta.intersectsTriangle(na))return!0}}}else{let u=bt(i),h=St(i,a);return Bt(u,r,Bh),!!(s.intersectsBox(Bh)&&mm(u,e,t,n,s)||(Bt(h,r,Bh),s.intersectsBox(Bh)&&mm(h,e,t,n,s)))}}var Vh=new Re,gm=new Qt,Kl=new Qt,V1=new P,H1=new P,G1=new P,W1=new P;function Zx(i,e,t,n={},s={},r=0,o=1/0){e.boundingBox||e.computeBoundingBox(),gm.set(e.boundingBox.min,e.boundingBox.max,t),gm.needsUpdate=!0;let a=i.geometry,l=a.attributes.position,c=a.index,u=e.attributes.position,h=e.index,d=Kn.getPrimitive(),f=Kn.getPrimitive(),g=V1,y=H1,m=null,_=null;s&&(m=G1,_=W1);let v=1/0,M=null,b=null;return Vh.copy(t).invert(),Kl.matrix.copy(Vh),i.shapecast({boundsTraverseOrder:w=>gm.distanceToBox(w),intersectsBounds:(w,x,p)=>p<v&&p<o?(x&&(Kl.min.copy(w.min),Kl.max.copy(w.max),Kl.needsUpdate=!0),!0):!1,intersectsRange:(w,x)=>{if(e.boundsTree)return e.boundsTree.shapecast({boundsTraverseOrder:S=>Kl.distanceToBox(S),intersectsBounds:(S,A,E)=>E<v&&E<o,intersectsRange:(S,A)=>{for(let E=S,C=S+A;E<C;E++){zt(f,3*E,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let I=w,D=w+x;I<D;I++){zt(d,3*I,c,l),d.needsUpdate=!0;let L=d.distanceToTriangle(f,g,m);if(L<v&&(y.copy(g),_&&_.copy(m),v=L,M=I,b=E),L<r)return!0}}}});{let p=sr(e);for(let S=0,A=p;S<A;S++){zt(f,3*S,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let E=w,C=w+x;E<C;E++){zt(d,3*E,c,l),d.needsUpdate=!0;let I=d.distanceToTriangle(f,g,m);if(I<v&&(y.copy(g),_&&_.copy(m),v=I,M=E,b=S),I<r)return!0}}}}}),Kn.releasePrimitive(d),Kn.releasePrimitive(f),v===1/0?null:(n.point?n.point.copy(y):n.point=y.clone(),n.distance=v,n.faceIndex=M,s&&(s.point?s.point.copy(_):s.point=_.clone(),s.point.applyMatrix4(Vh),y.applyMatrix4(Vh),s.distance=y.sub(s.point).length(),s.faceIndex=b),n)}function Jx(i,e=null){e&&Array.isArray(e)&&(e=new Set(e));let t=i.geometry,n=t.index?t.index.array:null,s=t.attributes.position,r,o,a,l,c=0,u=i._roots;for(let d=0,f=u.length;d<f;d++)r=u[d],o=new Uint32Array(r),a=new Uint16Array(r),l=new Float32Array(r),h(0,c),c+=r.byteLength;function h(d,f,g=!1){let y=d*2;if(mt(y,a)){let m=Rt(d,o),_=Ot(y,a),v=1/0,M=1/0,b=1/0,w=-1/0,x=-1/0,p=-1/0;for(let S=m,A=m+_;S<A;S++){let E=3*i.resolveTriangleIndex(S);for(let C=0;C<3;C++){let I=E+C;I=n?n[I]:I;let D=s.getX(I),L=s.getY(I),U=s.getZ(I);D<v&&(v=D),D>w&&(w=D),L<M&&(M=L),L>x&&(x=L),U<b&&(b=U),U>p&&(p=U)}}return l[d+0]!==v||l[d+1]!==M||l[d+2]!==b||l[d+3]!==w||l[d+4]!==x||l[d+5]!==p?(l[d+0]=v,l[d+1]=M,l[d+2]=b,l[d+3]=w,l[d+4]=x,l[d+5]=p,!0):!1}else{let m=bt(d),_=St(d,o),v=g,M=!1,b=!1;if(e){if(!v){let E=m/8+f/32,C=_/8+f/32;M=e.has(E),b=e.has(C),v=!M&&!b}}else M=!0,b=!0;let w=v||M,x=v||b,p=!1;w&&(p=h(m,f,v));let S=!1;x&&(S=h(_,f,v));let A=p||S;if(A)for(let E=0;E<3;E++){let C=m+E,I=_+E,D=l[C],L=l[C+3],U=l[I],V=l[I+3];l[d+E]=D<U?D:U,l[d+E+3]=L>V?L:V}return A}}}function jx(i,e,t,n,s,r,o){at.setBuffer(i._roots[e]),Bn(0,at.float32Array,n,r,o)&&_m(0,i,t,n,s,r,o),at.clearBuffer()}function _m(i,e,t,n,s,r,o){let{float32Array:a,uint16Array:l,uint32Array:c}=at,u=i*2;if(mt(u,l)){let d=Rt(i,c),f=Ot(u,l);Gx(e,t,n,d,f,s,r,o)}else{let d=bt(i);Bn(d,a,n,r,o)&&_m(d,e,t,n,s,r,o);let f=St(i,c);Bn(f,a,n,r,o)&&_m(f,e,t,n,s,r,o)}}var X1=["x","y","z"];function Qx(i,e,t,n,s,r){at.setBuffer(i._roots[e]);let o=null;return Bn(0,at.float32Array,n,s,r)&&(o=xm(0,i,t,n,s,r)),at.clearBuffer(),o}function xm(i,e,t,n,s,r){let{float32Array:o,uint16Array:a,uint32Array:l}=at,c=i*2;if(mt(c,a)){let h=Rt(i,l),d=Ot(c,a);return Wx(e,t,n,h,d,s,r)}else{let h=qo(i,l),d=X1[h],g=n.direction[d]>=0,y,m;g?(y=bt(i),m=St(i,l)):(y=St(i,l),m=bt(i));let v=Bn(y,o,n,s,r)?xm(y,e,t,n,s,r):null;if(v){let w=v.point[d];if(g?w<=o[m+h]:w>=o[m+h+3])return v}let b=Bn(m,o,n,s,r)?xm(m,e,t,n,s,r):null;return v&&b?v.distance<=b.distance?v:b:v||b||null}}var Hh=new je,ia=new An,sa=new An,Zl=new Re,ey=new Qt,Gh=new Qt;function ty(i,e,t,n){at.setBuffer(i._roots[e]);let s=ym(0,i,t,n);return at.clearBuffer(),s}function ym(i,e,t,n,s=null){let{float32Array:r,uint16Array:o,uint32Array:a}=at,l=i*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),ey.set(t.boundingBox.min,t.boundingBox.max,n),s=ey),mt(l,o)){let u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,g=t.attributes.position,y=Rt(i,a),m=Ot(l,o);if(Zl.copy(n).invert(),t.boundsTree)return Bt(i,r,Gh),Gh.matrix.copy(Zl),Gh.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>Gh.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(n),v.b.applyMatrix4(n),v.c.applyMatrix4(n),v.needsUpdate=!0;for(let M=y,b=m+y;M<b;M++)if(zt(sa,3*e.resolveTriangleIndex(M),h,d),sa.needsUpdate=!0,v.intersectsTriangle(sa))return!0;return!1}});{let _=sr(t);for(let v=y,M=m+y;v<M;v++){let b=e.resolveTriangleIndex(v);zt(ia,3*b,h,d),ia.a.applyMatrix4(Zl),ia.b.applyMatrix4(Zl),ia.c.applyMatrix4(Zl),ia.needsUpdate=!0;for(let w=0,x=_*3;w<x;w+=3)if(zt(sa,w,f,g),sa.needsUpdate=!0,ia.intersectsTriangle(sa))return!0}}}else{let u=bt(i),h=St(i,a);return Bt(u,r,Hh),!!(s.intersectsBox(Hh)&&ym(u,e,t,n,s)||(Bt(h,r,Hh),s.intersectsBox(Hh)&&ym(h,e,t,n,s)))}}var Wh=new Re,vm=new Qt,Jl=new Qt,q1=new P,Y1=new P,$1=new P,K1=new P;function ny(i,e,t,n={},s={},r=0,o=1/0){e.boundingBox||e.computeBoundingBox(),vm.set(e.boundingBox.min,e.boundingBox.max,t),vm.needsUpdate=!0;let a=i.geometry,l=a.attributes.position,c=a.index,u=e.attributes.position,h=e.index,d=Kn.getPrimitive(),f=Kn.getPrimitive(),g=q1,y=Y1,m=null,_=null;s&&(m=$1,_=K1);let v=1/0,M=null,b=null;return Wh.copy(t).invert(),Jl.matrix.copy(Wh),i.shapecast({boundsTraverseOrder:w=>vm.distanceToBox(w),intersectsBounds:(w,x,p)=>p<v&&p<o?(x&&(Jl.min.copy(w.min),Jl.max.copy(w.max),Jl.needsUpdate=!0),!0):!1,intersectsRange:(w,x)=>{if(e.boundsTree){let p=e.boundsTree;return p.shapecast({boundsTraverseOrder:S=>Jl.distanceToBox(S),intersectsBounds:(S,A,E)=>E<v&&E<o,intersectsRange:(S,A)=>{for(let E=S,C=S+A;E<C;E++){let I=p.resolveTriangleIndex(E);zt(f,3*I,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let D=w,L=w+x;D<L;D++){let U=i.resolveTriangleIndex(D);zt(d,3*U,c,l),d.needsUpdate=!0;let V=d.distanceToTriangle(f,g,m);if(V<v&&(y.copy(g),_&&_.copy(m),v=V,M=D,b=E),V<r)return!0}}}})}else{let p=sr(e);for(let S=0,A=p;S<A;S++){zt(f,3*S,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let E=w,C=w+x;E<C;E++){let I=i.resolveTriangleIndex(E);zt(d,3*I,c,l),d.needsUpdate=!0;let D=d.distanceToTriangle(f,g,m);if(D<v&&(y.copy(g),_&&_.copy(m),v=D,M=E,b=S),D<r)return!0}}}}}),Kn.releasePrimitive(d),Kn.releasePrimitive(f),v===1/0?null:(n.point?n.point.copy(y):n.point=y.clone(),n.distance=v,n.faceIndex=M,s&&(s.point?s.point.copy(_):s.point=_.clone(),s.point.applyMatrix4(Wh),y.applyMatrix4(Wh),s.distance=y.sub(s.point).length(),s.faceIndex=b),n)}function bm(i,e,t){return i===null?null:(i.point.applyMatrix4(e.matrixWorld),i.distance=i.point.distanceTo(t.ray.origin),i.object=e,i)}var Xh=new Qt,qh=new zi,iy=new P,sy=new Re,ry=new P,Sm=["getX","getY","getZ"],Yh=class i extends Nh{static serialize(e,t={}){t={cloneBuffers:!0,...t};let n=e.geometry,s=e._roots,r=e._indirectBuffer,o=n.getIndex(),a={version:1,roots:null,index:null,indirectBuffer:null};return t.cloneBuffers?(a.roots=s.map(l=>l.slice()),a.index=o?o.array.slice():null,a.indirectBuffer=r?r.slice():null):(a.roots=s,a.index=o?o.array:null,a.indirectBuffer=r),a}static deserialize(e,t,n={}){n={setIndex:!0,indirect:!!e.indirectBuffer,...n};let{index:s,roots:r,indirectBuffer:o}=e;e.version||(console.warn("MeshBVH.deserialize: Serialization format has been changed and will be fixed up. It is recommended to regenerate any stored serialized data."),l(r));let a=new i(t,{...n,[Hl]:!0});if(a._roots=r,a._indirectBuffer=o||null,n.setIndex){let c=t.getIndex();if(c===null){let u=new pt(e.index,1,!1);t.setIndex(u)}else c.array!==s&&(c.array.set(s),c.needsUpdate=!0)}return a;function l(c){for(let u=0;u<c.length;u++){let h=c[u],d=new Uint32Array(h),f=new Uint16Array(h);for(let g=0,y=h.byteLength/32;g<y;g++){let m=8*g,_=2*m;mt(_,f)||(d[m+6]=d[m+6]/8-g)}}}}get primitiveStride(){return 3}get resolveTriangleIndex(){return this.resolvePrimitiveIndex}constructor(e,t={}){t.maxLeafTris&&(console.warn('MeshBVH: "maxLeafTris" option has been deprecated. Use "targetLeafSize", instead.'),t={...t,targetLeafSize:t.maxLeafTris}),super(e,t)}shiftTriangleOffsets(e){return super.shiftPrimitiveOffsets(e)}writePrimitiveBounds(e,t,n){let s=this.geometry,r=this._indirectBuffer,o=s.attributes.position,a=s.index?s.index.array:null,c=(r?r[e]:e)*3,u=c+0,h=c+1,d=c+2;a&&(u=a[u],h=a[h],d=a[d]);for(let f=0;f<3;f++){let g=o[Sm[f]](u),y=o[Sm[f]](h),m=o[Sm[f]](d),_=g;y<_&&(_=y),m<_&&(_=m);let v=g;y>v&&(v=y),m>v&&(v=m),t[n+f]=_,t[n+f+3]=v}return t}computePrimitiveBounds(e,t,n){let s=this.geometry,r=this._indirectBuffer,o=s.attributes.position,a=s.index?s.index.array:null,l=o.normalized;if(e<0||t+e-n.offset>n.length/6)throw new Error("MeshBVH: compute triangle bounds range is invalid.");let c=o.array,u=o.offset||0,h=3;o.isInterleavedBufferAttribute&&(h=o.data.stride);let d=["getX","getY","getZ"],f=n.offset;for(let g=e,y=e+t;g<y;g++){let _=(r?r[g]:g)*3,v=(g-f)*6,M=_+0,b=_+1,w=_+2;a&&(M=a[M],b=a[b],w=a[w]),l||(M=M*h+u,b=b*h+u,w=w*h+u);for(let x=0;x<3;x++){let p,S,A;l?(p=o[d[x]](M),S=o[d[x]](b),A=o[d[x]](w)):(p=c[M+x],S=c[b+x],A=c[w+x]);let E=p;S<E&&(E=S),A<E&&(E=A);let C=p;S>C&&(C=S),A>C&&(C=A);let I=(C-E)/2,D=x*2;n[v+D+0]=E+I,n[v+D+1]=I+(Math.abs(E)+I)*Xo}}return n}raycastObject3D(e,t,n=[]){let{material:s}=e;if(s===void 0)return;sy.copy(e.matrixWorld).invert(),qh.copy(t.ray).applyMatrix4(sy),ry.setFromMatrixScale(e.matrixWorld),iy.copy(qh.direction).multiply(ry);let r=iy.length(),o=t.near/r,a=t.far/r;if(t.firstHitOnly===!0){let l=this.raycastFirst(qh,s,o,a);l=bm(l,e,t),l&&n.push(l)}else{let l=this.raycast(qh,s,o,a);for(let c=0,u=l.length;c<u;c++){let h=bm(l[c],e,t);h&&n.push(h)}}return n}refit(e=null){return(this.indirect?Jx:Hx)(this,e)}raycast(e,t=oi,n=0,s=1/0){let r=this._roots,o=[],a=this.indirect?jx:qx;for(let l=0,c=r.length;l<c;l++)a(this,l,t,e,o,n,s);return o}raycastFirst(e,t=oi,n=0,s=1/0){let r=this._roots,o=null,a=this.indirect?Qx:Yx;for(let l=0,c=r.length;l<c;l++){let u=a(this,l,t,e,n,s);u!=null&&(o==null||u.distance<o.distance)&&(o=u)}return o}intersectsGeometry(e,t){let n=!1,s=this._roots,r=this.indirect?ty:Kx;for(let o=0,a=s.length;o<a&&(n=r(this,o,e,t),!n);o++);return n}shapecast(e){let t=Kn.getPrimitive(),n=super.shapecast({...e,intersectsPrimitive:e.intersectsTriangle,scratchPrimitive:t,iterate:this.indirect?Xx:Vx});return Kn.releasePrimitive(t),n}bvhcast(e,t,n){let{intersectsRanges:s,intersectsTriangles:r}=n,o=Kn.getPrimitive(),a=this.geometry.index,l=this.geometry.attributes.position,c=this.indirect?g=>{let y=this.resolveTriangleIndex(g);zt(o,y*3,a,l)}:g=>{zt(o,g*3,a,l)},u=Kn.getPrimitive(),h=e.geometry.index,d=e.geometry.attributes.position,f=e.indirect?g=>{let y=e.resolveTriangleIndex(g);zt(u,y*3,h,d)}:g=>{zt(u,g*3,h,d)};if(r){if(!(e instanceof i))throw new Error('MeshBVH: "intersectsTriangles" callback can only be used with another MeshBVH.');let g=(y,m,_,v,M,b,w,x)=>{for(let p=_,S=_+v;p<S;p++){f(p),u.a.applyMatrix4(t),u.b.applyMatrix4(t),u.c.applyMatrix4(t),u.needsUpdate=!0;for(let A=y,E=y+m;A<E;A++)if(c(A),o.needsUpdate=!0,r(o,u,A,p,M,b,w,x))return!0}return!1};if(s){let y=s;s=function(m,_,v,M,b,w,x,p){return y(m,_,v,M,b,w,x,p)?!0:g(m,_,v,M,b,w,x,p)}}else s=g}return super.bvhcast(e,t,{intersectsRanges:s})}intersectsBox(e,t){return Xh.set(e.min,e.max,t),Xh.needsUpdate=!0,this.shapecast({intersectsBounds:n=>Xh.intersectsBox(n),intersectsTriangle:n=>Xh.intersectsTriangle(n)})}intersectsSphere(e){return this.shapecast({intersectsBounds:t=>e.intersectsBox(t),intersectsTriangle:t=>t.intersectsSphere(e)})}closestPointToGeometry(e,t,n={},s={},r=0,o=1/0){return(this.indirect?ny:Zx)(this,e,t,n,s,r,o)}closestPointToPoint(e,t={},n=0,s=1/0){return Ox(this,e,t,n,s)}};var cN=parseInt("187")>=166,ra={Mesh:Tt.prototype.raycast,Line:Vi.prototype.raycast,LineSegments:Hi.prototype.raycast,LineLoop:Ys.prototype.raycast,Points:wi.prototype.raycast,BatchedMesh:sl.prototype.raycast},Rn=new Tt,$h=[];function oy(i,e){if(this.isBatchedMesh)Z1.call(this,i,e);else{let{geometry:t}=this;if(t.boundsTree)t.boundsTree.raycastObject3D(this,i,e);else{let n;if(this instanceof Tt)n=ra.Mesh;else if(this instanceof Hi)n=ra.LineSegments;else if(this instanceof Ys)n=ra.LineLoop;else if(this instanceof Vi)n=ra.Line;else if(this instanceof wi)n=ra.Points;else throw new Error("BVH: Fallback raycast function not found.");n.call(this,i,e)}}}function Z1(i,e){if(this.boundsTrees){let t=this.boundsTrees,n=this._drawInfo||this._instanceInfo,s=this._drawRanges||this._geometryInfo,r=this.matrixWorld;Rn.material=this.material,Rn.geometry=this.geometry;let o=Rn.geometry.boundsTree,a=Rn.geometry.drawRange;Rn.geometry.boundingSphere===null&&(Rn.geometry.boundingSphere=new kt);for(let l=0,c=n.length;l<c;l++){if(!this.getVisibleAt(l))continue;let u=n[l].geometryIndex;if(Rn.geometry.boundsTree=t[u],this.getMatrixAt(l,Rn.matrixWorld).premultiply(r),!Rn.geometry.boundsTree){this.getBoundingBoxAt(u,Rn.geometry.boundingBox),this.getBoundingSphereAt(u,Rn.geometry.boundingSphere);let h=s[u];Rn.geometry.setDrawRange(h.start,h.count)}Rn.raycast(i,$h);for(let h=0,d=$h.length;h<d;h++){let f=$h[h];f.object=this,f.batchId=l,e.push(f)}$h.length=0}Rn.geometry.boundsTree=o,Rn.geometry.drawRange=a,Rn.material=null,Rn.geometry=null}else ra.BatchedMesh.call(this,i,e)}var J1=["#440154","#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6dcd59","#b4de2c","#fde725"],j1=["#0d3b76","#2a6da3","#78a9c8","#c5d9e2","#ece8e2","#eacdbc","#d69a7a","#b3563a","#7a2013"],Q1=i=>i<=.04045?i/12.92:((i+.055)/1.055)**2.4,eA=i=>i<=.0031308?12.92*i:1.055*Math.max(i,0)**.4166666666666667-.055;function tA([i,e,t]){let n=Math.cbrt(.4122214708*i+.5363325363*e+.0514459929*t),s=Math.cbrt(.2119034982*i+.6806995451*e+.1073969566*t),r=Math.cbrt(.0883024619*i+.2817188376*e+.6299787005*t);return[.2104542553*n+.793617785*s-.0040720468*r,1.9779984951*n-2.428592205*s+.4505937099*r,.0259040371*n+.7827717662*s-.808675766*r]}function nA([i,e,t]){let n=(i+.3963377774*e+.2158037573*t)**3,s=(i-.1055613458*e-.0638541728*t)**3,r=(i-.0894841775*e-1.291485548*t)**3;return[4.0767416621*n-3.3077115913*s+.2309699292*r,-1.2684380046*n+2.6097574011*s-.3413193965*r,-.0041960863*n-.7034186147*s+1.707614701*r]}var Mm=256;function ay(i){let e=i.map(t=>tA([1,3,5].map(n=>Q1(parseInt(t.slice(n,n+2),16)/255))));return Array.from({length:Mm},(t,n)=>{let s=n/(Mm-1)*(i.length-1),r=Math.min(Math.floor(s),i.length-2),o=e[r].map((a,l)=>a+(s-r)*(e[r+1][l]-a));return nA(o).map(a=>Math.min(1,Math.max(0,a)))})}var iA={sequential:ay(J1),diverging:ay(j1)},Kh=(i,e)=>iA[i][Math.round(Math.min(1,Math.max(0,e))*(Mm-1))],ly=(i,e)=>`rgb(${Kh(i,e).map(t=>Math.round(255*eA(t))).join(" ")})`;var sA=1e-4,rA=1e-6;function cy(i,e){let t=[{id:"plain",label:"Plain"}];for(let s of i.attributes.keys())t.push({id:s,label:jt(s)});t.push({id:"edge_length",label:"Edge length"}),e!=="minimal_surface"&&t.push({id:"bending",label:"Bending (fold angle)"});let n=new Set(i.lines.flatMap(s=>s.values.map(({name:r})=>r)));n.delete("length");for(let s of n)t.push({id:`line:${s}`,label:jt(s)});return t}function uy(i,e,t,n){if(e==="plain")return null;if(e==="mean_curvature")return oA(i,t,n);if(e==="edge_length"||e==="bending")return lA(i,e,t,n);if(e.startsWith("line:"))return hA(i,e.slice(5));let s=i.attributes.get(e);return s?Zh({id:e,label:jt(e),unit:"",at:"vertex",values:s},0):null}function Zh(i,e){let t=1/0,n=-1/0;for(let o of i.values)Number.isFinite(o)&&(t=Math.min(t,o),n=Math.max(n,o));t>n&&([t,n]=[0,0]);let s=Math.max(Math.abs(t),Math.abs(n)),r=s<=e;return t<0&&n>0?{...i,scale:"diverging",low:-s,high:s,nought:r,noise:e}:{...i,scale:"sequential",low:t,high:n,nought:r,noise:e}}function oA(i,e,t){let n=i.attributes.get("mean_curvature"),s=new Float32Array(n.length),r=aA(i),o=!1;for(let h=0;h<n.length;h+=1)s[h]=n[h]*t*(n[h]<0?1:r[h]),o||=s[h]<0;i.geometry.computeBoundingSphere();let a=i.geometry.boundingSphere.radius/t,l=a>0?sA/a:0,c=Zh({id:"mean_curvature",label:"Mean curvature",unit:`1/${e}`,at:"vertex",values:s},l),u=Math.max(Math.abs(c.low),Math.abs(c.high));return{...c,scale:"diverging",low:-u,high:u}}function aA(i){let{position:e,normal:t}=i.geometry.attributes,n=i.geometry.index.array,s=new Float64Array(e.count),r=a=>new P().fromBufferAttribute(e,a),o=new P;for(let a=0;a<n.length;a+=3){let l=[n[a],n[a+1],n[a+2]],c=l.map(r);for(let u=0;u<3;u+=1){let[h,d]=[(u+1)%3,(u+2)%3],f=c[h].clone().sub(c[u]),g=c[d].clone().sub(c[u]),y=f.dot(g)/Math.max(f.clone().cross(g).length(),1e-30),m=c[d].clone().sub(c[h]);s[l[h]]+=y*m.dot(o.fromBufferAttribute(t,l[h])),s[l[d]]-=y*m.dot(o.fromBufferAttribute(t,l[d]))}}return Float32Array.from(s,a=>a<0?-1:1)}function lA(i,e,t,n){let s=gh(i.geometry),r=i.geometry.attributes.position.array,o=[];for(let d=0;d<s.ends.length/2;d+=1)(e==="edge_length"||s.faces[2*d+1]!==-1)&&o.push(d);let a=new Float32Array(6*o.length),l=new Float32Array(o.length),c=e==="bending"?cA(i):null;o.forEach((d,f)=>{let g=3*s.ends[2*d],y=3*s.ends[2*d+1];for(let m=0;m<3;m+=1)a[6*f+m]=r[g+m],a[6*f+3+m]=r[y+m];c?l[f]=uA(c,s,d):l[f]=Math.hypot(r[g]-r[y],r[g+1]-r[y+1],r[g+2]-r[y+2])/n});let u=e==="bending",h=Zh({id:e,label:u?"Bending (fold angle)":"Edge length",unit:u?"°":t,at:"segment",values:l,segments:a},u?.01:0);return u?{...h,low:0}:h}function cA(i){let{position:e}=i.geometry.attributes,t=i.geometry.index.array,n=s=>new P().fromBufferAttribute(e,t[s]);return Array.from({length:t.length/3},(s,r)=>{let o=n(3*r);return n(3*r+1).sub(o).cross(n(3*r+2).sub(o)).normalize()})}var uA=(i,{faces:e},t)=>i[e[2*t]].angleTo(i[e[2*t+1]])*180/Math.PI;function hA(i,e){let t=i.lines.flatMap(a=>a.values.filter(l=>l.name===e).map(l=>({line:a,each:l})));if(t.length===0)return null;let n=t.reduce((a,{each:l})=>a+l.values.length/2,0),s=new Float32Array(n),r=new Float32Array(6*n),o=0;for(let{line:a,each:l}of t){r.set(a.segments,6*o);for(let c=0;c<l.values.length;c+=2)s[o+c/2]=l.values[c];o+=l.values.length/2}return Zh({id:`line:${e}`,label:jt(e),unit:t[0].each.unit,at:"segment",values:s,segments:r},0)}function Jh(i,e){if(i.nought)return i.scale==="diverging"?.5:0;let t=i.high-i.low;return t>rA*Math.max(Math.abs(i.low),Math.abs(i.high))?(e-i.low)/t:.5}var hy=(i,e)=>`${i.label} ${Math.abs(e)<=i.noise?"≈ 0":`${At(e,4)}`}${i.unit==="°"?"°":i.unit&&` ${i.unit}`}`;function dy(i,e){let t=new Array(e).fill(0);for(let n of i.values)Number.isFinite(n)&&(t[Math.min(e-1,Math.max(0,Math.floor(Jh(i,n)*e)))]+=1);return t}var dA=2e4;function jh(i,e,t,n,s=1){if(i.length/6>dA){let a=new Xt().setAttribute("position",new pt(i,3));n&&a.setAttribute("color",new pt(n,3));let l=new qs({color:n?"#ffffff":t,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new Hi(a,l)}let r=new Wo().setPositions(i);n&&r.setColors(n);let o=new Go({color:n?16777215:new Ne(t).getHex(),linewidth:e,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new wh(r,o)}var oa=class{constructor(e){this.look=e}look;group=new xn;mesh=null;result=null;kind="";quantity=null;lines=[];layers={surface:!0,edges:!1,lines:!0};drawn=!0;stale=!1;get shown(){return this.mesh!==null}get current(){return this.result}show(e,t,n){this.clear(),this.result=e,this.kind=t,this.quantity=null,this.stale=!1,e&&(this.putInto(n),this.make())}putInto(e){if(!this.result)return;let t=e.up===2?[e.origin[0],e.origin[2],-e.origin[1]]:e.origin,[n,s,r]=this.result.translation.map((o,a)=>o-t[a]*e.metres);this.group.position.set(n,s,r)}colourBy(e){this.quantity=e,this.make()}setLayers(e){Object.assign(this.layers,e),this.make()}setStale(e){if(e!==this.stale&&(this.stale=e,!!this.mesh)){this.mesh.material.transparent=e,this.mesh.material.opacity=e?.32:1,this.mesh.material.depthWrite=!e,this.mesh.material.needsUpdate=!0;for(let t of this.lines)t.material.transparent=!0,t.material.opacity=e?.2:t.userData.opacity??1}}restyle(){this.make()}clear(){this.mesh?.geometry.dispose(),this.mesh?.material.dispose(),this.mesh=null,this.lines.forEach(e=>{e.geometry.dispose(),e.material.dispose()}),this.lines=[],this.group.clear()}make(){let{result:e,quantity:t,stale:n}=this;if(this.clear(),!e)return;let s=this.kind!=="minimal_surface",r=new Xt;r.setIndex(e.geometry.index),r.setAttribute("position",e.geometry.attributes.position),r.setAttribute("normal",e.geometry.attributes.normal);let o=t?.at==="vertex";t&&o&&r.setAttribute("color",new pt(fA(t),3));let a={side:rn,flatShading:s,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},l=o?new cl({...a,vertexColors:!0}):new bs({...a,color:this.look.membrane,roughness:.62,metalness:0});this.mesh=new Tt(r,l),this.mesh.raycast=oy,this.mesh.userData.castsShadow=!0,this.mesh.visible=this.layers.surface,this.group.add(this.mesh);let c=(h,d,f,g=1,y)=>{if(h.length===0)return;let m=jh(h,d,f,y,g);m.userData.opacity=g,m.userData.isLine=!0,this.lines.push(m),this.group.add(m)},u=t?.at==="segment"?t:null;if(u&&c(u.segments,3,this.look.ink,1,pA(u)),this.layers.edges&&u?.id!=="edge_length"&&c(mA(e),1,this.look.ink,.3),this.layers.lines)for(let{name:h,segments:d}of e.lines)u&&(h.startsWith("members")||h==="bridges")||(h==="boundaries"||h==="directrices"?this.drawn||c(d,2,this.look.ink,.85):h.startsWith("members")?c(d,h.includes("rim")?1.4:2,this.look.ink,h.includes("rim")?.5:.8):h==="bridges"?c(d,1,this.look.ink,.35):c(d,2.4,this.look.accent));n&&(this.stale=!1,this.setStale(!0))}tree(){let e=this.mesh?.geometry;return e?(e.boundsTree??=new Yh(e,{indirect:!0}),e):null}pick(e,t,n){if(!this.mesh||!this.layers.surface||!this.tree())return null;let s=new Zs;s.setFromCamera(new Ue(t/e.width*2-1,1-n/e.height*2),e.camera),s.firstHitOnly=!0,this.group.updateMatrixWorld();let[r]=s.intersectObject(this.mesh,!1);return r?{point:r.point,distance:r.distance,face:r.faceIndex??0}:null}valueAt(e,t){let{quantity:n,mesh:s}=this;if(!n||!s)return null;let r=s.worldToLocal(e.clone());if(n.at==="segment")return gA(n,r);let o=s.geometry.index.array,{position:a}=s.geometry.attributes,l=[0,1,2].map(y=>o[3*t+y]),[c,u,h]=l.map(y=>new P().fromBufferAttribute(a,y)),d=(y,m,_)=>m.clone().sub(y).cross(_.clone().sub(y)).length(),f=[d(r,u,h),d(c,r,h),d(c,u,r)],g=f.reduce((y,m)=>y+m,0);return g>0?l.reduce((y,m,_)=>y+f[_]/g*n.values[m],0):n.values[l[0]]}outline(){let e=this.result?.geometry.attributes.position;if(!e)return[];let t=Math.max(1,Math.floor(e.count/3e3)),{x:n,y:s,z:r}=this.group.position,o=[];for(let l=0;l<e.count;l+=t)o.push([e.getX(l)+n,e.getY(l)+s,e.getZ(l)+r]);let a=this.result.geometry.boundingBox??(this.result.geometry.computeBoundingBox(),this.result.geometry.boundingBox);for(let l=0;l<e.count;l+=1){let c=[e.getX(l),e.getY(l),e.getZ(l)];if(c.some((u,h)=>u===a.min.getComponent(h)||u===a.max.getComponent(h))&&o.push([c[0]+n,c[1]+s,c[2]+r]),o.length>4e3)break}return o}};function fA(i){let e=new Float32Array(3*i.values.length);return i.values.forEach((t,n)=>e.set(Kh(i.scale,Jh(i,t)),3*n)),e}function pA(i){let e=new Float32Array(6*i.values.length);return i.values.forEach((t,n)=>{let s=Kh(i.scale,Jh(i,t));e.set(s,6*n),e.set(s,6*n+3)}),e}var fy=new WeakMap;function mA(i){let e=fy.get(i);if(e)return e;let t=i.geometry.attributes.position.array,{ends:n}=gh(i.geometry),s=new Float32Array(3*n.length);return n.forEach((r,o)=>s.set(t.subarray(3*r,3*r+3),3*o)),fy.set(i,s),s}function gA({segments:i,values:e},t){let n=1/0,s=null,r=new P,o=new P,a=new P;for(let l=0;l<e.length;l+=1){r.fromArray(i,6*l),o.fromArray(i,6*l+3).sub(r),a.copy(t).sub(r);let c=Math.min(1,Math.max(0,a.dot(o)/o.lengthSq())),u=a.addScaledVector(o,-c).lengthSq();u<n&&([n,s]=[u,e[l]])}return s}var py=[{name:"area",label:"Area",unit:"u²",better:"less"},{name:"total_normal_twist",label:"Twist",unit:"",better:"less"},{name:"convex_bridge_ratio",label:"Convex",unit:"%",better:"more"},{name:"bending_energy",label:"Bending",unit:"",better:"less"},{name:"mean_curvature_variation",label:"Curvature change",unit:"",better:"less"},{name:"largest_fold_deg",label:"Largest fold",unit:"°",better:"less"}],Qh=class{constructor(e,t,n,s){this.stage=e;this.look=t;this.use=n;this.fail=s}stage;look;use;fail;tiles=[];turn=0;async open(e,t,n){this.close();let s=this.turn,r=Array.isArray(e.normals),o=n.filter(a=>r||a!=="minimal_normal_variation");this.tiles=o.map(a=>{let l=ie("button",{type:"button",onclick:()=>this.use(a)},"Use this");l.setAttribute("aria-label",`Use this: ${jt(a)}`);let c=ie("div",{},ie("p",{className:"wait"},"Solving…")),u=ie("div",{className:"picture"}),h=ie("article",{className:"tile"},u,ie("div",{className:"facts"},ie("header",{},ie("h2",{},jt(a)),l),c));return h.dataset.objective=a,{name:a,box:h,facts:c,picture:u,surface:new oa(this.look),statistics:null}}),J("tiles").replaceChildren(...this.tiles.map(({box:a})=>a)),J("tiles").hidden=!1,J("tiles").onscroll=()=>this.stage.invalidate(),this.stage.tiles=this.tiles.map(({picture:a,surface:l})=>({element:a,group:l.group})),this.stage.invalidate(),await Promise.all(this.tiles.map(a=>this.solve(a,e,t,s).catch(l=>{s===this.turn&&(a.facts.replaceChildren(ie("p",{className:"wait"},"This objective found no strip.")),this.fail(l))})))}async solve(e,t,n,s){let{secondary_objective:r,...o}=t,a={...o,objective:e.name,all_objectives:!1,...e.name==="maximal_convexity"&&r?{secondary_objective:r}:{}},l=await pc(Ut.ruled_surface.path,a);if(Kr(l)||(l=await mc(l,()=>{})),l.status!=="succeeded")throw new ls(l.error??{});let c=await Fl(await _a(`${l.links.mesh}?format=glb`));s===this.turn&&(e.surface.show(c,"ruled_surface",n),e.statistics=l.statistics,this.report(t),this.stage.invalidate())}report(e){let t=this.tiles.filter(s=>s.statistics!==null),n=new Map(py.map(({name:s,better:r})=>{let o=t.map(a=>a.statistics[s]).filter(a=>typeof a=="number");return[s,r==="less"?Math.min(...o):Math.max(...o)]}));for(let s of t)s.box.classList.toggle("best",s.name===(e.objective??"minimal_area")),s.facts.replaceChildren(ie("dl",{},...py.flatMap(({name:r,label:o,unit:a})=>{let l=s.statistics[r];if(typeof l!="number")return[];let c=Math.abs(l-n.get(r))<=1e-9*Math.abs(n.get(r)),u=a==="%"?`${At(100*l,3)} %`:`${At(l,4)}${a==="u²"?` ${Oi(e)}²`:a}`;return[ie("dt",{},o),ie("dd",{className:c?"best":""},u)]})))}restyle(){this.tiles.forEach(({surface:e})=>e.restyle())}close(){this.turn+=1,this.tiles.forEach(({surface:e,picture:t})=>{e.show(null,"",null),t.remove()}),this.tiles=[],this.stage.tiles=null,J("tiles").hidden=!0,J("tiles").replaceChildren(),this.stage.invalidate()}};var ed=class{url="";x=0;y=0;scale=1;box=J("flat");image=J("flat-image");constructor(){this.box.addEventListener("wheel",e=>{e.preventDefault();let{left:t,top:n}=this.box.getBoundingClientRect();this.zoom(e.clientX-t,e.clientY-n,Math.exp(-e.deltaY*.0015))},{passive:!1}),this.box.addEventListener("pointerdown",e=>{let t={x:e.clientX-this.x,y:e.clientY-this.y};this.box.setPointerCapture(e.pointerId);let n=r=>{[this.x,this.y]=[r.clientX-t.x,r.clientY-t.y],this.place()},s=()=>{this.box.removeEventListener("pointermove",n),this.box.removeEventListener("pointerup",s)};this.box.addEventListener("pointermove",n),this.box.addEventListener("pointerup",s)}),this.box.addEventListener("keydown",e=>{let{clientWidth:t,clientHeight:n}=this.box;e.key==="+"||e.key==="="?this.zoom(t/2,n/2,1.2):e.key==="-"?this.zoom(t/2,n/2,1/1.2):e.key==="0"&&this.fit()}),new ResizeObserver(()=>{this.box.hidden||this.fit()}).observe(this.box)}async show(e){let t=await fc(`${e.links.pattern}?format=svg`);URL.revokeObjectURL(this.url),this.url=URL.createObjectURL(t),this.box.hidden=!1,this.image.src=this.url,await this.image.decode(),this.fit()}hide(){this.box.hidden=!0}fit(){let{clientWidth:e,clientHeight:t}=this.box,{naturalWidth:n,naturalHeight:s}=this.image;n!==0&&(this.scale=.9*Math.min((e-24)/n,(t-150)/s),this.x=(e-n*this.scale)/2,this.y=(t-s*this.scale)/2+24,this.place())}zoom(e,t,n){this.scale*=n,this.x=e+(this.x-e)*n,this.y=t+(this.y-t)*n,this.place()}place(){let{style:e}=this.image;e.width=`${this.image.naturalWidth*this.scale}px`,e.left=`${this.x}px`,e.top=`${this.y}px`}};function Tm(i,e){let t=i.paths?.[e]?.post?.requestBody?.content?.["application/json"]?.schema;return t?is(i,t):null}var td=i=>i.type==="null";function is(i,e){let t=e,n={};for(let s=0;s<8;s+=1){t.description!==void 0&&(n.description??=t.description),t.default!==void 0&&(n.default??=t.default);let r=t.anyOf??t.oneOf??[];r.some(td)&&(n.nullable=!0);let o=r.filter(c=>!td(c)),a=r.some(td)&&o.length===1?o[0]:void 0,l=t.$ref?{$ref:t.$ref}:t.allOf?.[0]??a;if(!l)break;t=l.$ref?_A(i,l.$ref):l}return{...t,...n}}var _A=(i,e)=>e.slice(2).split("/").reduce((t,n)=>t?.[n],i)??{};function jl(i,e){let t=(e.oneOf??e.anyOf??[e]).filter(o=>!td(o)).map(o=>is(i,o)),n=t.flatMap(o=>o.oneOf??o.anyOf??[o]).filter(o=>o.enum??o.const!==void 0),s=n.flatMap(o=>o.enum??[o.const]);if(s.length>0&&s.every(o=>typeof o=="string")){let o=Object.fromEntries(n.flatMap(a=>(a.enum??[a.const]).map(l=>[String(l),a.description===e.description?void 0:a.description])));return{type:"choice",names:s,help:o,other:t.find(a=>a.properties)??null}}let r=[e.type].flat();if(r.includes("boolean"))return{type:"flag"};if(r.includes("integer")||r.includes("number"))return{type:"number",whole:r.includes("integer")};if(r.includes("string"))return{type:"text"};if(r.includes("object")&&e.maxProperties===1)return{type:"one_of"};if(r.includes("object")&&e.properties&&Object.values(e.properties).every(o=>jl(i,is(i,o))))return{type:"group"};if(r.includes("array")&&e.items&&e.minItems===e.maxItems&&(e.maxItems??9)<=3){let o=is(i,e.items);if([o.type].flat().some(a=>a==="integer"||a==="number"))return{type:"numbers",count:e.maxItems,item:o}}return null}var wm=["objective","secondary_objective","resolution","edge_length","closed","optimise","max_distinct_lengths","topology","units","up"],xA={closed:"Closed rails",units:"Unit",up:"Up axis",all_objectives:"Compare all objectives",optimise:"Optimise"},my=i=>wm.indexOf(i)+1||wm.length+1,Ri=i=>xA[i]??jt(i);function gy(i,e,t,n){let s=i.querySelector("details")?.open??!1;i.replaceChildren();let r=ie("div",{className:"fields"}),o=Object.keys(e.properties??{}).filter(a=>a!=="kind");o.sort((a,l)=>my(a)-my(l));for(let a of o){let l=is(n.openapi,e.properties[a]),c=jl(n.openapi,l);if(!c||c.type==="choice"&&c.names.length<2&&!c.other)continue;let u=Am(n,a,l,c,t[a],h=>n.set(a,h),[a]);(wm.includes(a)?i:r).append(u)}r.childElementCount>0&&i.append(ie("details",{className:"more",open:s},ie("summary",{},"More options"),r))}function Am(i,e,t,n,s,r,o){let a=s??t.default,l=t.description??"",c=`option-${o.join("-")}`;if(n.type==="flag"){let u=ie("input",{type:"checkbox",name:o.join("."),id:c,checked:a===!0});return u.addEventListener("change",()=>r(u.checked)),ie("label",{className:"check field",title:l},u,Ri(e))}if(n.type==="choice")return yA(i,e,t,n,s,r,o);if(n.type==="number"){let u=Em(o.join("."),c,t,n.whole,a);return u.addEventListener("change",()=>{u.checkValidity()?r(u.value===""?void 0:u.valueAsNumber):u.reportValidity()}),ie("label",{className:"field",title:l,htmlFor:c},ie("span",{},Ri(e)),u)}if(n.type==="text"){let u=ie("input",{type:"text",name:o.join("."),id:c,value:a??"",placeholder:"none",autocomplete:"off"});return u.addEventListener("change",()=>r(u.value===""?void 0:u.value)),ie("label",{className:"field",title:l,htmlFor:c},ie("span",{},Ri(e)),u)}if(n.type==="numbers"){let u=Array.isArray(a)?a:[],h=Array.from({length:n.count},(d,f)=>Em(`${o.join(".")}.${f}`,`${c}-${f}`,n.item,!0,u[f]));return h.forEach((d,f)=>{d.setAttribute("aria-label",`${Ri(e)}, ${f+1}`),d.addEventListener("change",()=>r(h.map(g=>g.valueAsNumber||n.item.minimum||0)))}),ie("div",{className:"field",title:l},ie("span",{},Ri(e)),ie("span",{className:"pair even"},...h))}return n.type==="group"?bA(i,e,t,s,r,o):SA(i,e,t,a,r,o)}function yA(i,e,t,n,s,r,o){let a=`option-${o.join("-")}`,l=s??t.default,c=v=>{l=v??t.default,r(v)},u="(object)",h=n.names.map(v=>ie("option",{value:v,title:n.help[v]??""},jt(v)));(t.nullable||t.default===void 0)&&h.unshift(ie("option",{value:""},t.nullable?"None":"Default"));let d=()=>l!==null&&typeof l=="object",f=n.other&&vA(i.openapi,n.other)?n.other:null;f?h.push(ie("option",{value:u},"Weighted sum")):d()&&h.push(ie("option",{value:u},"As in the request"));let g=ie("select",{name:o.join("."),id:a},...h);g.value=d()?u:String(l??"");let y=ie("p",{className:"help"}),m=ie("div",{className:"fields nested"}),_=()=>{if(y.textContent=i.describe(e,g.value)??n.help[g.value]??"",y.hidden=y.textContent==="",m.replaceChildren(),m.hidden=g.value!==u||!f,m.hidden||!f)return;let v=()=>d()?l:{};for(let[M,b]of Object.entries(f.properties??{})){let w=is(i.openapi,b),x=jl(i.openapi,w);x&&m.append(Am(i,M,w,x,v()[M],p=>c(xy({...v(),[M]:p})),[...o,M]))}};return g.addEventListener("change",()=>{g.value===u?f&&c(_y(i.openapi,f)):c(g.value===""?void 0:g.value),_()}),_(),ie("div",{className:"field choice"},ie("label",{htmlFor:a,title:t.description??""},Ri(e)),g,y,m)}var vA=(i,e)=>Object.values(e.properties??{}).length>0&&(e.required??[]).every(t=>jl(i,is(i,e.properties[t])));function _y(i,e){return Object.fromEntries((e.required??[]).map(t=>{let n=is(i,e.properties[t]),[s]=Object.keys(n.properties??{});return[t,s?{[s]:1}:n.default??(n.enum??n.oneOf?.map(r=>r.const))?.[0]??1]}))}var xy=i=>Object.fromEntries(Object.entries(i).filter(([,e])=>e!==void 0));function bA(i,e,t,n,s,r){let o=n??null,a=ie("div",{className:"fields nested"}),l=t.nullable===!0,c=()=>{a.replaceChildren(...Object.entries(t.properties??{}).map(([d,f])=>{let g=is(i.openapi,f);return Am(i,d,g,jl(i.openapi,g),o?.[d],y=>{o=xy({...o,[d]:y}),s(o)},[...r,d])}))};if(!l)return c(),ie("fieldset",{className:"field group",title:t.description??""},ie("legend",{},Ri(e)),a);let u=ie("input",{type:"checkbox",name:r.join("."),id:`option-${r.join("-")}`,checked:o!==null}),h=()=>{a.hidden=o===null,a.replaceChildren(),o&&c()};return u.addEventListener("change",()=>{o=u.checked?_y(i.openapi,t):null,s(o??void 0),h()}),h(),ie("div",{className:"field group"},ie("label",{className:"check",title:t.description??""},u,Ri(e)),a)}function Em(i,e,t,n,s){let r=t.minimum??(t.exclusiveMinimum!==void 0?t.exclusiveMinimum:void 0);return ie("input",{type:"number",name:i,id:e,step:n?"1":"any",value:s??"",placeholder:"auto",inputMode:"decimal",...r!==void 0&&{min:String(r)},...t.maximum!==void 0&&{max:String(t.maximum)}})}function SA(i,e,t,n,s,r){let o=n??{},a=Object.keys(t.properties??{}),l=a.find(f=>o[f]!==void 0&&o[f]!==null)??a[0],c=ie("select",{"aria-label":Ri(e),name:r.join(".")},...a.map(f=>ie("option",{value:f},jt(f))));c.value=l;let u=f=>is(i.openapi,t.properties[f]),h=f=>[u(f).type].flat().includes("integer"),d=Em(`${r.join(".")}.value`,`option-${r.join("-")}`,u(l),h(l),o[l]);return d.setAttribute("aria-label",`${Ri(e)}, value`),c.addEventListener("change",()=>{d.value="",d.step=h(c.value)?"1":"any",d.focus()}),d.addEventListener("change",()=>{d.checkValidity()?s(d.value===""?void 0:{[c.value]:d.valueAsNumber}):d.reportValidity()}),ie("div",{className:"field",title:t.description??""},ie("span",{},Ri(e)),ie("span",{className:"pair"},c,d))}var nd={columns:6,names:["two-rails","helicoid","catenoid","tent","four-corners","ridge-rope","own-mesh","helicoid-relaxation","two-rings","rings-12-free","rings-12-best","rings-14-free","rings-14-best","rings-14-pinkall-polthier","cut-cylinder","three-rings","tetrahedron-loops","nested-loops","three-half-circles","three-half-circles-uneven","helicoid-liu-wang","scherk-relaxation","wavy-strip","contour-stack","wang-tang-i","wang-tang-ii","wang-tang-iii","wang-tang-iv","wang-tang-v","wang-tang-vi","latticed-roof","latticed-roof-steep","latticed-film","latticed-roof-few-lengths","floor-fewest-nodes","floor-equal-members","courtyard","vault"]};var wA=[{title:"Tents",about:"Membranes on a boundary of their own",names:["tent","ridge-rope","four-corners","own-mesh"]},{title:"Canopies and soap films",about:"Several rings, every way to span them",names:[/rings/,/loops/,/half-circles/]},{title:"Strips",about:"Ruled surfaces that fold flat",names:["two-rails","wavy-strip","contour-stack",/^wang-tang/]},{title:"Gridshells and floors",about:"Lattices of equal members",names:[/^latticed/,"vault","courtyard",/^floor/]},{title:"From the papers",about:"Helicoid, catenoid, Scherk and the methods that found them",names:[/./]}],EA={minimal_surface:4,ruled_surface:2,uniform_mesh:3},TA=i=>i.replace(/ \((.*)\)$/,"").replace(/, every way to span them compared$/,", compared");function yy(i,e){let t=new Set(i),n=wA.map((s,r)=>{let o=[...t].filter(a=>s.names.some(l=>typeof l=="string"?l===a.name:l.test(a.name))&&(r<4||t.has(a)));return o.forEach(a=>t.delete(a)),{...s,found:o}});for(let s of t)n[EA[s.kind]??4].found.push(s);return n.filter(({found:s})=>s.length>0).map(({title:s,about:r,found:o})=>ie("section",{},ie("h3",{},s,ie("small",{},r)),ie("div",{className:"cards"},...o.map(a=>{let l=ie("button",{type:"button",className:"card",title:a.title},AA(a.name),ie("span",{},TA(a.title)));return l.dataset.example=a.name,l.addEventListener("click",()=>e(a)),l}))))}function AA(i){let e=nd.names.indexOf(i),t=ie("span",{className:"thumbnail"});if(t.setAttribute("aria-hidden","true"),e>=0){let{columns:n}=nd,s=Math.ceil(nd.names.length/n),[r,o]=[e%n,Math.floor(e/n)];t.style.backgroundSize=`${n*100}% ${s*100}%`,t.style.backgroundPosition=`${n>1?100*r/(n-1):0}% ${s>1?100*o/(s-1):0}%`}else t.classList.add("missing");return t}var Rm=220,Cm=34,Pm=44;function Im(i){if(J("scale").hidden=i===null,!i)return;let e=i.scale==="diverging"&&i.id==="mean_curvature"?"|H|":"All values";J("scale-note").textContent=i.nought?`≈ 0: ${e} below ${At(i.noise,2)}${i.unit&&` ${i.unit}`}`:`${i.label}${i.unit&&` [${i.unit}]`}`;let t=!i.nought&&i.high-i.low<=1e-6*Math.max(Math.abs(i.low),Math.abs(i.high)),n=J("scale-bar"),s=40,r=Array.from({length:s+1},(c,u)=>ly(i.scale,i.nought||t?i.scale==="diverging"||t?.5:0:u/s));n.style.background=`linear-gradient(to right, ${r.join(", ")})`,J("scale-low").textContent=i.nought||t?"":At(i.low,3),J("scale-middle").textContent=i.nought?"≈ 0":t?At(i.high,5):i.scale==="diverging"?"0":"",J("scale-high").textContent=i.nought||t?"":At(i.high,3);let o=dy(i,Pm),a=Math.max(...o,1),l=J("scale-histogram");l.hidden=i.nought||t,l.replaceChildren(In("svg",{viewBox:`0 0 ${Rm} ${Cm}`,preserveAspectRatio:"none",role:"img","aria-label":`Histogram of ${i.values.length} values`},...o.map((c,u)=>{let h=Cm*Math.sqrt(c)/Math.sqrt(a);return In("rect",{x:u*Rm/Pm,y:Cm-h,width:Rm/Pm-.8,height:h})})))}var Nm=i=>i!==null&&typeof i=="object"&&!Array.isArray(i);function aa(i){return i==null?"—":typeof i=="number"?At(i):typeof i=="boolean"?i?"yes":"no":String(i).replaceAll("_"," ")}var RA={minimal_surface:[["area","Area","u²"],["triangles","Triangles",""],["residual","Residual",""],["stability.stable","Stable",""]],ruled_surface:[["area","Area","u²"],["convex_bridge_ratio","Convex bridges","%"],["bending_energy","Bending energy",""],["largest_fold_deg","Largest fold","°"]],uniform_mesh:[["nodes","Nodes",""],["edges","Members",""],["equal_edges","Equal members",""],["distinct_lengths","Distinct lengths",""]]},Lm=(i,e)=>e.split(".").reduce((t,n)=>t?.[n],i);function My(i,e){let t=i.statistics;return(RA[i.kind]??[]).filter(([n])=>Lm(t,n)!==void 0&&Lm(t,n)!==null).map(([n,s,r])=>{let o=Lm(t,n),a=r==="%"&&typeof o=="number"?At(100*o,3):aa(o),l=r===""?"":r==="%"||r==="°"?r:` ${r.replace("u",e)}`;return ie("div",{className:"figure"},ie("span",{className:"value"},a,ie("small",{},l)),ie("span",{className:"name"},s))})}var vy=["objective","objective_value","secondary_value","converged","stop_reason","residual","area","certificate","initial_area","nodes","vertices","triangles","edges","bridges","stability","iterations","self_intersections","mean_curvature","edge_lengths","angles_deg"],by=([i])=>vy.indexOf(i)+1||vy.length+1,CA=6,Om=500;function wy(i){let e=[],t=[],n=(s,r)=>{if(Array.isArray(r)){if(r.length===0)return;r.every(Nm)?t.push(PA(s,r)):r.length>CA?t.push(Ey(s,String(r.length),ie("p",{className:"numbers"},r.map(aa).join(" · ")))):e.push(Sy(s,r.map(aa).join(", ")))}else Nm(r)?Object.entries(r).forEach(([o,a])=>n(`${s} ${o}`,a)):r!==void 0&&e.push(Sy(s,aa(r)))};return Object.entries(i).filter(([s])=>s!=="comparison"&&s!=="history").sort((s,r)=>by(s)-by(r)).forEach(([s,r])=>n(s,r)),[ie("table",{className:"plain"},ie("tbody",{},...e)),...t]}var Sy=(i,e)=>ie("tr",{},ie("th",{scope:"row"},jt(i.replace(/_deg (.*)$/," $1_deg"))),ie("td",{},e)),Ey=(i,e,t)=>ie("details",{},ie("summary",{},`${jt(i)} (${e})`),ie("div",{className:"wide",tabIndex:0,role:"region","aria-label":jt(i)},t));function PA(i,e){let t=e.map(a=>Ty(a)),n=[...new Set(t.flatMap(a=>Object.keys(a)))],s=ie("tr",{},...n.map(a=>ie("th",{scope:"col"},jt(a)))),r=t.slice(0,Om).map(a=>ie("tr",{},...n.map(l=>ie("td",{},l in a?aa(a[l]):"")))),o=e.length>Om?`first ${Om} of ${e.length}`:String(e.length);return Ey(i,o,ie("table",{},ie("thead",{},s),ie("tbody",{},...r)))}function Ty(i,e=""){return Object.entries(i).reduce((t,[n,s])=>Nm(s)?{...t,...Ty(s,`${e}${n} `)}:{...t,[e+n]:Array.isArray(s)?s.map(aa).join(", "):s},{})}var Ay=i=>(i??[]).map(({code:e,detail:t})=>ie("p",{className:"warning"},ie("strong",{},jt(e)),` ${Bl(t)}`)),Ry=i=>(i??[]).map(e=>({iteration:e.iteration,phase:e.phase,value:e.area??null,residual:e.residual??null}));async function Cy(i,e){return new Uint8Array(await new Response(new Blob([i]).stream().pipeThrough(e)).arrayBuffer())}async function Py(i){let e=await Cy(new TextEncoder().encode(JSON.stringify(i)),new CompressionStream("deflate-raw")),t="";for(let n=0;n<e.length;n+=32768)t+=String.fromCharCode(...e.subarray(n,n+32768));return btoa(t).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"")}async function Iy(i){let e=Uint8Array.from(atob(i.replaceAll("-","+").replaceAll("_","/")),t=>t.charCodeAt(0));return JSON.parse(new TextDecoder().decode(await Cy(e,new DecompressionStream("deflate-raw"))))}var Ly=()=>new URL(".",document.baseURI).href.replace(/studio\/$/,""),Oy=async i=>`${Ly()}#s=${await Py(i)}`;async function Ny(i){return`<iframe src="${Ly()}studio/embed.html#s=${await Py(i)}" width="800" height="500" title="Plateau" loading="lazy"></iframe>`}var IA=i=>i.replaceAll("'",String.raw`'\''`);function Dy(i,e){let t=dc()?' -H "Authorization: Bearer $PLATEAU_KEY"':"",n=new URL(pr("/")).origin;return`# Posts the request, waits for its job, and saves the mesh as surface.glb.
job=$(curl -sS --fail-with-body -D - -o /dev/null${t} -H 'Content-Type: application/json' -X POST '${pr(Ut[i].path)}' --data-binary @- <<'JSON' | tr -d '\\r' | sed -n 's/^[Ll]ocation: //p'
${JSON.stringify(e)}
JSON
)
curl -sS --fail --retry 120 --retry-delay 1 --retry-all-errors${t} -o surface.glb "${IA(n)}$job/mesh?format=glb"
`}function Uy(i,e){let t=dc()?`,
    "Authorization": "Bearer " + os.environ["PLATEAU_KEY"]`:"";return`import json
import os
import time
import urllib.request

SERVER = "${new URL(pr("/")).origin}"
HEADERS = {
    "Content-Type": "application/json",
    "Prefer": "wait=30"${t},
}
REQUEST = json.loads(r"""${JSON.stringify(e)}""")


def call(url, body=None):
    data = None if body is None else json.dumps(body).encode()
    with urllib.request.urlopen(urllib.request.Request(url, data, HEADERS)) as answer:
        return answer.read()


job = json.loads(call("${pr(Ut[i].path)}", REQUEST))
while job["status"] in ("queued", "running"):
    time.sleep(0.2)
    job = json.loads(call(SERVER + job["links"]["self"]))
if job["status"] != "succeeded":
    raise SystemExit(job["error"])
print(json.dumps({k: v for k, v in job["statistics"].items() if isinstance(v, (int, float))}, indent=1))
with open("surface.glb", "wb") as file:
    file.write(call(SERVER + job["links"]["mesh"] + "?format=glb"))
`.replace(/^import os\n/m,t?`import os
`:"")}function Fy(i,e){let t=dc()?", Authorization: `Bearer ${process.env.PLATEAU_KEY}`":"";return`import { writeFile } from "node:fs/promises";

interface Job {
  status: "queued" | "running" | "succeeded" | "failed" | "cancelled";
  links: { self: string; mesh: string };
  error: unknown;
}

const server = "${new URL(pr("/")).origin}";
const headers = { "Content-Type": "application/json", Prefer: "wait=30"${t} };
const request = ${JSON.stringify(e)};

async function call(url: string, init: RequestInit = {}): Promise<Response> {
  const answer = await fetch(url, { ...init, headers });
  if (!answer.ok) throw new Error(await answer.text());
  return answer;
}

let job = (await (await call("${pr(Ut[i].path)}", { method: "POST", body: JSON.stringify(request) })).json()) as Job;
while (job.status === "queued" || job.status === "running") {
  job = (await (await call(server + job.links.self)).json()) as Job;
}
if (job.status !== "succeeded") throw new Error(JSON.stringify(job.error));
const mesh = await call(server + job.links.mesh + "?format=glb");
await writeFile("surface.glb", new Uint8Array(await mesh.arrayBuffer()));
`}var ky=["#c2413b","#3d8b4f","#3a6fb5"],OA=27,id=class{constructor(e,t,n){this.box=e;this.stage=t;this.build(n)}box;stage;arms=[];build(e){this.arms=[],this.box.replaceChildren();for(let t of[0,1,2])for(let n of[-1,1]){let s=[0,0,0];s[t]=n;let r=e.up===2?[s[0],s[2],-s[1]]:s,o="XYZ"[t],a=n>0?In("line",{stroke:ky[t]}):null,l=In("circle",{r:n>0?8.5:5.5,fill:ky[t],"fill-opacity":n>0?1:.35}),c=In("g",{tabindex:0,role:"button","aria-label":`Look from ${n>0?"":"minus "}${o}`},l,...n>0?[In("text",{},o)]:[]),u=()=>this.stage.look([r[0],r[1],r[2]+(Math.abs(r[1])>.5?.001:0)]);c.addEventListener("click",u),c.addEventListener("keydown",h=>{["Enter"," "].includes(h.key)&&(h.preventDefault(),u())}),this.arms.push({direction:r,line:a,tip:c})}this.place()}place(){let e=this.arms.map(t=>({arm:t,at:new P(...t.direction).applyQuaternion(this.stage.camera.quaternion.clone().invert()).multiplyScalar(OA)}));e.sort((t,n)=>t.at.z-n.at.z);for(let{arm:t,at:n}of e){let[s,r]=[n.x.toFixed(1),(-n.y).toFixed(1)];t.line?.setAttribute("x2",s),t.line?.setAttribute("y2",r),t.tip.setAttribute("transform",`translate(${s} ${r})`)}if(!this.box.contains(document.activeElement)){let t=e.flatMap(({arm:n})=>[n.line,n.tip]).filter(n=>n!==null);t.some((n,s)=>this.box.children[s]!==n)&&this.box.append(...t)}}};var Ls=(i,e)=>i?.line===e?.line&&i?.point===e?.point,NA=`
attribute float state;
uniform float scale, size, near;
varying float kind;
void main() {
  kind = state;
  vec4 at = modelViewMatrix * vec4(position, 1.0);
  float pixel = near * -at.z;
  // A point on the surface is not to be cut in half by it: it is moved towards the eye by its own size.
  at.xyz -= normalize(at.xyz) * min(pixel * 10.0, 0.05 * -at.z);
  gl_Position = projectionMatrix * at;
  float grow = state > 0.5 ? 1.35 : 1.0;
  gl_PointSize = size * scale * grow + 2.0 * scale;
}`,DA=`
varying float kind; uniform vec3 paper, accent, ink, fault; uniform float scale, size;
void main() {
  float grow = kind > 0.5 ? 1.35 : 1.0;
  float whole = size * scale * grow + 2.0 * scale;
  float r = length(gl_PointCoord - 0.5) * whole;
  float rim = whole / 2.0 - scale;
  float alpha = 1.0 - smoothstep(rim - 0.5, rim + 0.5, r);
  if (alpha < 0.02) discard;
  vec3 fill = kind < 0.5 ? paper : kind < 1.5 ? accent : kind < 2.5 ? accent : kind < 3.5 ? fault : kind < 4.5 ? accent : paper;
  vec3 edge = kind < 1.5 ? accent : kind < 2.5 ? paper : kind < 3.5 ? paper : accent;
  float border = smoothstep(rim - 1.9 * scale, rim - 1.1 * scale, r);
  gl_FragColor = vec4(mix(fill, edge, border), alpha * (kind > 4.5 ? 0.75 : 1.0));
  #include <colorspace_fragment>
}`,sd=class{constructor(e){this.look=e;let t=n=>({value:new Ne(n)});this.material=new un({vertexShader:NA,fragmentShader:DA,transparent:!0,uniforms:{scale:{value:1},size:{value:11},near:{value:.001},paper:t(e.paper),accent:t(e.accent),ink:t(e.ink),fault:t(e.fault)}}),this.group.add(this.extra)}look;group=new xn;places=[];refs=[];points=null;lines=null;extra=new xn;material;restyle(e){this.look=e;for(let t of["paper","accent","ink","fault"])this.material.uniforms[t].value.set(e[t])}setPixel(e,t){this.material.uniforms.near.value=e,this.material.uniforms.scale.value=t}show(e,t,n){let s=[],r=[],o=[];e.forEach((a,l)=>{let u=a.points.map(Gt).map(f=>f?n.toScene(f):null);if(u.forEach((f,g)=>{let y=f??UA(u[(g+u.length-1)%u.length]??null,u[(g+1)%u.length]??null);y&&(s.push(y),r.push({line:l,point:g}))}),_r(a))return;let h=u.filter(f=>f!==null),d=a.closed&&h.length>2?h.length:h.length-1;for(let f=0;f<d;f+=1)o.push(...h[f],...h[(f+1)%h.length])}),t?.forEach((a,l)=>{s.push(n.toScene(a)),r.push({line:-1,point:l}),l>0&&o.push(...n.toScene(t[l-1]),...n.toScene(a))}),this.places=s,this.refs=r,this.setLines(new Float32Array(o)),this.setPoints()}setLines(e){this.lines&&(this.lines.geometry.dispose(),this.lines.material.dispose(),this.group.remove(this.lines)),this.lines=e.length>0?jh(e,2.4,this.look.accent):null,this.lines&&(this.lines.renderOrder=1,this.group.add(this.lines))}setPoints(){let e=this.places.length;if(!this.points||this.points.geometry.attributes.position.count!==e){this.points&&(this.points.geometry.dispose(),this.group.remove(this.points));let n=new Xt;n.setAttribute("position",new pt(new Float32Array(3*e),3)),n.setAttribute("state",new pt(new Float32Array(e),1)),this.points=new wi(n,this.material),this.points.frustumCulled=!1,this.points.renderOrder=2,this.group.add(this.points)}let{position:t}=this.points.geometry.attributes;this.places.forEach((n,s)=>t.setXYZ(s,...n)),t.needsUpdate=!0,this.material.uniforms.size.value=e>300?5:e>120?7:11}mark(e){let t=this.points?.geometry.attributes.state;t&&(this.refs.forEach((n,s)=>t.setX(s,e(n))),t.needsUpdate=!0)}hint(e){this.extra.children.forEach(n=>{n.geometry.dispose()}),this.extra.clear();let t=(n,s,r)=>{if(!n||n.length<2)return;let o=jh(new Float32Array(n.flat()),1.6,s,void 0,r);o.renderOrder=1,this.extra.add(o)};if(t(e.segments,this.look.accent,.95),t(e.faint,this.look.soft,.8),e.ghost){let n=new Xt;n.setAttribute("position",new pt(new Float32Array(e.ghost),3)),n.setAttribute("state",new pt(new Float32Array([5]),1));let s=new wi(n,this.material);s.renderOrder=3,this.extra.add(s)}}};function UA(i,e){return!i||!e?i??e:[0,1,2].map(t=>(i[t]+e[t])/2)}var Zt={LEFT:1,RIGHT:2,MIDDLE:4},Y=Object.freeze({NONE:0,ROTATE:1,TRUCK:2,SCREEN_PAN:4,OFFSET:8,DOLLY:16,ZOOM:32,TOUCH_ROTATE:64,TOUCH_TRUCK:128,TOUCH_SCREEN_PAN:256,TOUCH_OFFSET:512,TOUCH_DOLLY:1024,TOUCH_ZOOM:2048,TOUCH_DOLLY_TRUCK:4096,TOUCH_DOLLY_SCREEN_PAN:8192,TOUCH_DOLLY_OFFSET:16384,TOUCH_DOLLY_ROTATE:32768,TOUCH_ZOOM_TRUCK:65536,TOUCH_ZOOM_OFFSET:131072,TOUCH_ZOOM_SCREEN_PAN:262144,TOUCH_ZOOM_ROTATE:524288}),la={NONE:0,IN:1,OUT:-1};function Gr(i){return i.isPerspectiveCamera}function or(i){return i.isOrthographicCamera}var rr=Math.PI*2,By=Math.PI/2,Yy=1e-5,Ql=Math.PI/180;function Ci(i,e,t){return Math.max(e,Math.min(t,i))}function Wt(i,e=Yy){return Math.abs(i)<e}function Ct(i,e,t=Yy){return Wt(i-e,t)}function zy(i,e){return Math.round(i/e)*e}function ec(i){return isFinite(i)?i:i<0?-Number.MAX_VALUE:Number.MAX_VALUE}function tc(i){return Math.abs(i)<Number.MAX_VALUE?i:i*(1/0)}function rd(i,e,t,n,s=1/0,r){n=Math.max(1e-4,n);let o=2/n,a=o*r,l=1/(1+a+.48*a*a+.235*a*a*a),c=i-e,u=e,h=s*n;c=Ci(c,-h,h),e=i-c;let d=(t.value+o*c)*r;t.value=(t.value-o*d)*l;let f=e+(c+d)*l;return u-i>0==f>u&&(f=u,t.value=(f-u)/r),f}function Vy(i,e,t,n,s=1/0,r,o){n=Math.max(1e-4,n);let a=2/n,l=a*r,c=1/(1+l+.48*l*l+.235*l*l*l),u=e.x,h=e.y,d=e.z,f=i.x-u,g=i.y-h,y=i.z-d,m=u,_=h,v=d,M=s*n,b=M*M,w=f*f+g*g+y*y;if(w>b){let U=Math.sqrt(w);f=f/U*M,g=g/U*M,y=y/U*M}u=i.x-f,h=i.y-g,d=i.z-y;let x=(t.x+a*f)*r,p=(t.y+a*g)*r,S=(t.z+a*y)*r;t.x=(t.x-a*x)*c,t.y=(t.y-a*p)*c,t.z=(t.z-a*S)*c,o.x=u+(f+x)*c,o.y=h+(g+p)*c,o.z=d+(y+S)*c;let A=m-i.x,E=_-i.y,C=v-i.z,I=o.x-m,D=o.y-_,L=o.z-v;return A*I+E*D+C*L>0&&(o.x=m,o.y=_,o.z=v,t.x=(o.x-m)/r,t.y=(o.y-_)/r,t.z=(o.z-v)/r),o}function Dm(i,e){e.set(0,0),i.forEach(t=>{e.x+=t.clientX,e.y+=t.clientY}),e.x/=i.length,e.y/=i.length}function Um(i,e){return or(i)?(console.warn(`${e} is not supported in OrthographicCamera`),!0):!1}var Hm=class{constructor(){this._listeners={}}addEventListener(e,t){let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let s=this._listeners[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}removeAllEventListeners(e){if(!e){this._listeners={};return}Array.isArray(this._listeners[e])&&(this._listeners[e].length=0)}dispatchEvent(e){let n=this._listeners[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e)}}},Fm,FA="3.1.0",od=1/8,kA=/Mac/.test((Fm=globalThis?.navigator)===null||Fm===void 0?void 0:Fm.platform),Xe,Hy,ad,km,ni,Qe,yt,ca,nc,ss,rs,Wr,Gy,Wy,ci,ua,ha,Xy,Bm,qy,zm,Vm,ld,da=class i extends Hm{static install(e){Xe=e.THREE,Hy=Object.freeze(new Xe.Vector3(0,0,0)),ad=Object.freeze(new Xe.Vector3(0,1,0)),km=Object.freeze(new Xe.Vector3(0,0,1)),ni=new Xe.Vector2,Qe=new Xe.Vector3,yt=new Xe.Vector3,ca=new Xe.Vector3,nc=new Xe.Vector3,ss=new Xe.Vector3,rs=new Xe.Vector3,Wr=new Xe.Vector3,Gy=new Xe.Vector3,Wy=new Xe.Vector3,ci=new Xe.Spherical,ua=new Xe.Spherical,ha=new Xe.Box3,Xy=new Xe.Box3,Bm=new Xe.Sphere,qy=new Xe.Quaternion,zm=new Xe.Quaternion,Vm=new Xe.Matrix4,ld=new Xe.Raycaster}static get ACTION(){return Y}set verticalDragToForward(e){console.warn("camera-controls: `verticalDragToForward` was removed. Use `mouseButtons.left = CameraControls.ACTION.SCREEN_PAN` instead.")}constructor(e,t){super(),this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.minDistance=Number.EPSILON,this.maxDistance=1/0,this.infinityDolly=!1,this.minZoom=.01,this.maxZoom=1/0,this.smoothTime=.25,this.draggingSmoothTime=.125,this.maxSpeed=1/0,this.azimuthRotateSpeed=1,this.polarRotateSpeed=1,this.dollySpeed=1,this.dollyDragInverted=!1,this.truckSpeed=2,this.dollyToCursor=!1,this.dragToOffset=!1,this.boundaryFriction=0,this.restThreshold=.01,this.colliderMeshes=[],this.cancel=()=>{},this._enabled=!0,this._state=Y.NONE,this._viewport=null,this._changedDolly=0,this._changedZoom=0,this._hasRested=!0,this._boundaryEnclosesCamera=!1,this._needsUpdate=!0,this._updatedLastTime=!1,this._elementRect=new DOMRect,this._isDragging=!1,this._dragNeedsUpdate=!0,this._activePointers=[],this._lockedPointer=null,this._interactiveArea=new DOMRect(0,0,1,1),this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._isUserControllingOffset=!1,this._isUserControllingZoom=!1,this._lastDollyDirection=la.NONE,this._thetaVelocity={value:0},this._phiVelocity={value:0},this._radiusVelocity={value:0},this._targetVelocity=new Xe.Vector3,this._focalOffsetVelocity=new Xe.Vector3,this._zoomVelocity={value:0},this._truckInternal=(_,v,M,b)=>{let w,x;if(Gr(this._camera)){let p=Qe.copy(this._camera.position).sub(this._target),S=this._camera.getEffectiveFOV()*Ql,A=p.length()*Math.tan(S*.5);w=this.truckSpeed*_*A/this._elementRect.height,x=this.truckSpeed*v*A/this._elementRect.height}else if(or(this._camera)){let p=this._camera;w=this.truckSpeed*_*(p.right-p.left)/p.zoom/this._elementRect.width,x=this.truckSpeed*v*(p.top-p.bottom)/p.zoom/this._elementRect.height}else return;b?(M?this.setFocalOffset(this._focalOffsetEnd.x+w,this._focalOffsetEnd.y,this._focalOffsetEnd.z,!0):this.truck(w,0,!0),this.forward(-x,!0)):M?this.setFocalOffset(this._focalOffsetEnd.x+w,this._focalOffsetEnd.y+x,this._focalOffsetEnd.z,!0):this.truck(w,x,!0)},this._rotateInternal=(_,v)=>{let M=rr*this.azimuthRotateSpeed*_/this._elementRect.height,b=rr*this.polarRotateSpeed*v/this._elementRect.height;this.rotate(M,b,!0)},this._dollyInternal=(_,v,M)=>{let b=Math.pow(.95,-_*this.dollySpeed),w=this._sphericalEnd.radius,x=this._sphericalEnd.radius*b,p=Ci(x,this.minDistance,this.maxDistance),S=p-x;this.infinityDolly&&this.dollyToCursor?this._dollyToNoClamp(x,!0):this.infinityDolly&&!this.dollyToCursor?(this.dollyInFixed(S,!0),this._dollyToNoClamp(p,!0)):this._dollyToNoClamp(p,!0),this.dollyToCursor&&(this._changedDolly+=(this.infinityDolly?x:p)-w,this._dollyControlCoord.set(v,M)),this._lastDollyDirection=Math.sign(-_)},this._zoomInternal=(_,v,M)=>{let b=Math.pow(.95,_*this.dollySpeed),w=this._zoom,x=this._zoom*b;this.zoomTo(x,!0),this.dollyToCursor&&(this._changedZoom+=x-w,this._dollyControlCoord.set(v,M))},typeof Xe>"u"&&console.error("camera-controls: `THREE` is undefined. You must first run `CameraControls.install( { THREE: THREE } )`. Check the docs for further information."),this._camera=e,this._yAxisUpSpace=new Xe.Quaternion().setFromUnitVectors(this._camera.up,ad),this._yAxisUpSpaceInverse=this._yAxisUpSpace.clone().invert(),this._state=Y.NONE,this._target=new Xe.Vector3,this._targetEnd=this._target.clone(),this._focalOffset=new Xe.Vector3,this._focalOffsetEnd=this._focalOffset.clone(),this._spherical=new Xe.Spherical().setFromVector3(Qe.copy(this._camera.position).applyQuaternion(this._yAxisUpSpace)),this._sphericalEnd=this._spherical.clone(),this._lastDistance=this._spherical.radius,this._zoom=this._camera.zoom,this._zoomEnd=this._zoom,this._lastZoom=this._zoom,this._nearPlaneCorners=[new Xe.Vector3,new Xe.Vector3,new Xe.Vector3,new Xe.Vector3],this._updateNearPlaneCorners(),this._boundary=new Xe.Box3(new Xe.Vector3(-1/0,-1/0,-1/0),new Xe.Vector3(1/0,1/0,1/0)),this._cameraUp0=this._camera.up.clone(),this._target0=this._target.clone(),this._position0=this._camera.position.clone(),this._zoom0=this._zoom,this._focalOffset0=this._focalOffset.clone(),this._dollyControlCoord=new Xe.Vector2,this.mouseButtons={left:Y.ROTATE,middle:Y.DOLLY,right:Y.TRUCK,wheel:Gr(this._camera)?Y.DOLLY:or(this._camera)?Y.ZOOM:Y.NONE},this.touches={one:Y.TOUCH_ROTATE,two:Gr(this._camera)?Y.TOUCH_DOLLY_TRUCK:or(this._camera)?Y.TOUCH_ZOOM_TRUCK:Y.NONE,three:Y.TOUCH_TRUCK};let n=new Xe.Vector2,s=new Xe.Vector2,r=new Xe.Vector2,o=_=>{if(!this._enabled||!this._domElement)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let b=this._domElement.getBoundingClientRect(),w=_.clientX/b.width,x=_.clientY/b.height;if(w<this._interactiveArea.left||w>this._interactiveArea.right||x<this._interactiveArea.top||x>this._interactiveArea.bottom)return}let v=_.pointerType!=="mouse"?null:(_.buttons&Zt.LEFT)===Zt.LEFT?Zt.LEFT:(_.buttons&Zt.MIDDLE)===Zt.MIDDLE?Zt.MIDDLE:(_.buttons&Zt.RIGHT)===Zt.RIGHT?Zt.RIGHT:null;if(v!==null){let b=this._findPointerByMouseButton(v);b&&this._disposePointer(b)}if((_.buttons&Zt.LEFT)===Zt.LEFT&&this._lockedPointer)return;let M={pointerId:_.pointerId,clientX:_.clientX,clientY:_.clientY,deltaX:0,deltaY:0,mouseButton:v};this._activePointers.push(M),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),this._isDragging=!0,d(_)},a=_=>{_.cancelable&&_.preventDefault();let v=_.pointerId,M=this._lockedPointer||this._findPointerById(v);if(M){if(M.clientX=_.clientX,M.clientY=_.clientY,M.deltaX=_.movementX,M.deltaY=_.movementY,this._state=0,_.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else(!this._isDragging&&this._lockedPointer||this._isDragging&&(_.buttons&Zt.LEFT)===Zt.LEFT)&&(this._state=this._state|this.mouseButtons.left),this._isDragging&&(_.buttons&Zt.MIDDLE)===Zt.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),this._isDragging&&(_.buttons&Zt.RIGHT)===Zt.RIGHT&&(this._state=this._state|this.mouseButtons.right);f()}},l=_=>{let v=this._findPointerById(_.pointerId);if(!(v&&v===this._lockedPointer)){if(v&&this._disposePointer(v),_.pointerType==="touch")switch(this._activePointers.length){case 0:this._state=Y.NONE;break;case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else this._state=Y.NONE;g()}},c=-1,u=_=>{if(!this._domElement||!this._enabled||this.mouseButtons.wheel===Y.NONE)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let x=this._domElement.getBoundingClientRect(),p=_.clientX/x.width,S=_.clientY/x.height;if(p<this._interactiveArea.left||p>this._interactiveArea.right||S<this._interactiveArea.top||S>this._interactiveArea.bottom)return}if(_.preventDefault(),this.dollyToCursor||this.mouseButtons.wheel===Y.ROTATE||this.mouseButtons.wheel===Y.TRUCK){let x=performance.now();c-x<1e3&&this._getClientRect(this._elementRect),c=x}let v=kA?-1:-3,M=_.deltaMode===1||_.ctrlKey?_.deltaY/v:_.deltaY/(v*10),b=this.dollyToCursor?(_.clientX-this._elementRect.x)/this._elementRect.width*2-1:0,w=this.dollyToCursor?(_.clientY-this._elementRect.y)/this._elementRect.height*-2+1:0;switch(this.mouseButtons.wheel){case Y.ROTATE:{this._rotateInternal(_.deltaX,_.deltaY),this._isUserControllingRotate=!0;break}case Y.TRUCK:{this._truckInternal(_.deltaX,_.deltaY,!1,!1),this._isUserControllingTruck=!0;break}case Y.SCREEN_PAN:{this._truckInternal(_.deltaX,_.deltaY,!1,!0),this._isUserControllingTruck=!0;break}case Y.OFFSET:{this._truckInternal(_.deltaX,_.deltaY,!0,!1),this._isUserControllingOffset=!0;break}case Y.DOLLY:{this._dollyInternal(-M,b,w),this._isUserControllingDolly=!0;break}case Y.ZOOM:{this._zoomInternal(-M,b,w),this._isUserControllingZoom=!0;break}}this.dispatchEvent({type:"control"})},h=_=>{if(!(!this._domElement||!this._enabled)){if(this.mouseButtons.right===i.ACTION.NONE){let v=_ instanceof PointerEvent?_.pointerId:0,M=this._findPointerById(v);M&&this._disposePointer(M),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l);return}_.preventDefault()}},d=_=>{if(!this._enabled)return;if(Dm(this._activePointers,ni),this._getClientRect(this._elementRect),n.copy(ni),s.copy(ni),this._activePointers.length>=2){let M=ni.x-this._activePointers[1].clientX,b=ni.y-this._activePointers[1].clientY,w=Math.sqrt(M*M+b*b);r.set(0,w);let x=(this._activePointers[0].clientX+this._activePointers[1].clientX)*.5,p=(this._activePointers[0].clientY+this._activePointers[1].clientY)*.5;s.set(x,p)}if(this._state=0,!_)this._lockedPointer&&(this._state=this._state|this.mouseButtons.left);else if("pointerType"in _&&_.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else!this._lockedPointer&&(_.buttons&Zt.LEFT)===Zt.LEFT&&(this._state=this._state|this.mouseButtons.left),(_.buttons&Zt.MIDDLE)===Zt.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),(_.buttons&Zt.RIGHT)===Zt.RIGHT&&(this._state=this._state|this.mouseButtons.right);((this._state&Y.ROTATE)===Y.ROTATE||(this._state&Y.TOUCH_ROTATE)===Y.TOUCH_ROTATE||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE)&&(this._sphericalEnd.theta=this._spherical.theta,this._sphericalEnd.phi=this._spherical.phi,this._thetaVelocity.value=0,this._phiVelocity.value=0),((this._state&Y.TRUCK)===Y.TRUCK||(this._state&Y.SCREEN_PAN)===Y.SCREEN_PAN||(this._state&Y.TOUCH_TRUCK)===Y.TOUCH_TRUCK||(this._state&Y.TOUCH_SCREEN_PAN)===Y.TOUCH_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN)&&(this._targetEnd.copy(this._target),this._targetVelocity.set(0,0,0)),((this._state&Y.DOLLY)===Y.DOLLY||(this._state&Y.TOUCH_DOLLY)===Y.TOUCH_DOLLY||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE)&&(this._sphericalEnd.radius=this._spherical.radius,this._radiusVelocity.value=0),((this._state&Y.ZOOM)===Y.ZOOM||(this._state&Y.TOUCH_ZOOM)===Y.TOUCH_ZOOM||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_ZOOM_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE)&&(this._zoomEnd=this._zoom,this._zoomVelocity.value=0),((this._state&Y.OFFSET)===Y.OFFSET||(this._state&Y.TOUCH_OFFSET)===Y.TOUCH_OFFSET||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET)&&(this._focalOffsetEnd.copy(this._focalOffset),this._focalOffsetVelocity.set(0,0,0)),this.dispatchEvent({type:"controlstart"})},f=()=>{if(!this._enabled||!this._dragNeedsUpdate)return;this._dragNeedsUpdate=!1,Dm(this._activePointers,ni);let v=this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement?this._lockedPointer||this._activePointers[0]:null,M=v?-v.deltaX:s.x-ni.x,b=v?-v.deltaY:s.y-ni.y;if(s.copy(ni),((this._state&Y.ROTATE)===Y.ROTATE||(this._state&Y.TOUCH_ROTATE)===Y.TOUCH_ROTATE||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE)&&(this._rotateInternal(M,b),this._isUserControllingRotate=!0),(this._state&Y.DOLLY)===Y.DOLLY||(this._state&Y.ZOOM)===Y.ZOOM){let w=this.dollyToCursor?(n.x-this._elementRect.x)/this._elementRect.width*2-1:0,x=this.dollyToCursor?(n.y-this._elementRect.y)/this._elementRect.height*-2+1:0,p=this.dollyDragInverted?-1:1;(this._state&Y.DOLLY)===Y.DOLLY?(this._dollyInternal(p*b*od,w,x),this._isUserControllingDolly=!0):(this._zoomInternal(p*b*od,w,x),this._isUserControllingZoom=!0)}if((this._state&Y.TOUCH_DOLLY)===Y.TOUCH_DOLLY||(this._state&Y.TOUCH_ZOOM)===Y.TOUCH_ZOOM||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_ZOOM_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE){let w=ni.x-this._activePointers[1].clientX,x=ni.y-this._activePointers[1].clientY,p=Math.sqrt(w*w+x*x),S=r.y-p;r.set(0,p);let A=this.dollyToCursor?(s.x-this._elementRect.x)/this._elementRect.width*2-1:0,E=this.dollyToCursor?(s.y-this._elementRect.y)/this._elementRect.height*-2+1:0;(this._state&Y.TOUCH_DOLLY)===Y.TOUCH_DOLLY||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET?(this._dollyInternal(S*od,A,E),this._isUserControllingDolly=!0):(this._zoomInternal(S*od,A,E),this._isUserControllingZoom=!0)}((this._state&Y.TRUCK)===Y.TRUCK||(this._state&Y.TOUCH_TRUCK)===Y.TOUCH_TRUCK||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK)&&(this._truckInternal(M,b,!1,!1),this._isUserControllingTruck=!0),((this._state&Y.SCREEN_PAN)===Y.SCREEN_PAN||(this._state&Y.TOUCH_SCREEN_PAN)===Y.TOUCH_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_ZOOM_SCREEN_PAN)&&(this._truckInternal(M,b,!1,!0),this._isUserControllingTruck=!0),((this._state&Y.OFFSET)===Y.OFFSET||(this._state&Y.TOUCH_OFFSET)===Y.TOUCH_OFFSET||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET)&&(this._truckInternal(M,b,!0,!1),this._isUserControllingOffset=!0),this.dispatchEvent({type:"control"})},g=()=>{Dm(this._activePointers,ni),s.copy(ni),this._dragNeedsUpdate=!1,(this._activePointers.length===0||this._activePointers.length===1&&this._activePointers[0]===this._lockedPointer)&&(this._isDragging=!1),this._activePointers.length===0&&this._domElement&&(this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this.dispatchEvent({type:"controlend"}))};this.lockPointer=()=>{!this._enabled||!this._domElement||(this.cancel(),this._lockedPointer={pointerId:-1,clientX:0,clientY:0,deltaX:0,deltaY:0,mouseButton:null},this._activePointers.push(this._lockedPointer),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.requestPointerLock(),this._domElement.ownerDocument.addEventListener("pointerlockchange",y),this._domElement.ownerDocument.addEventListener("pointerlockerror",m),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),d())},this.unlockPointer=()=>{var _,v,M;this._lockedPointer!==null&&(this._disposePointer(this._lockedPointer),this._lockedPointer=null),(_=this._domElement)===null||_===void 0||_.ownerDocument.exitPointerLock(),(v=this._domElement)===null||v===void 0||v.ownerDocument.removeEventListener("pointerlockchange",y),(M=this._domElement)===null||M===void 0||M.ownerDocument.removeEventListener("pointerlockerror",m),this.cancel()};let y=()=>{this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement||this.unlockPointer()},m=()=>{this.unlockPointer()};this._addAllEventListeners=_=>{this._domElement=_,this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none",this._domElement.addEventListener("pointerdown",o),this._domElement.addEventListener("pointercancel",l),this._domElement.addEventListener("wheel",u,{passive:!1}),this._domElement.addEventListener("contextmenu",h)},this._removeAllEventListeners=()=>{this._domElement&&(this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect="",this._domElement.removeEventListener("pointerdown",o),this._domElement.removeEventListener("pointercancel",l),this._domElement.removeEventListener("wheel",u,{passive:!1}),this._domElement.removeEventListener("contextmenu",h),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.removeEventListener("pointerlockchange",y),this._domElement.ownerDocument.removeEventListener("pointerlockerror",m))},this.cancel=()=>{this._state!==Y.NONE&&(this._state=Y.NONE,this._activePointers.length=0,g())},t&&this.connect(t),this.update(0)}get camera(){return this._camera}set camera(e){this._camera=e,this.updateCameraUp(),this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0}get enabled(){return this._enabled}set enabled(e){this._enabled=e,this._domElement&&(e?(this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none"):(this.cancel(),this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect=""))}get active(){return!this._hasRested}get currentAction(){return this._state}get distance(){return this._spherical.radius}set distance(e){this._spherical.radius===e&&this._sphericalEnd.radius===e||(this._spherical.radius=e,this._sphericalEnd.radius=e,this._needsUpdate=!0)}get azimuthAngle(){return this._spherical.theta}set azimuthAngle(e){this._spherical.theta===e&&this._sphericalEnd.theta===e||(this._spherical.theta=e,this._sphericalEnd.theta=e,this._needsUpdate=!0)}get polarAngle(){return this._spherical.phi}set polarAngle(e){this._spherical.phi===e&&this._sphericalEnd.phi===e||(this._spherical.phi=e,this._sphericalEnd.phi=e,this._needsUpdate=!0)}get boundaryEnclosesCamera(){return this._boundaryEnclosesCamera}set boundaryEnclosesCamera(e){this._boundaryEnclosesCamera=e,this._needsUpdate=!0}set interactiveArea(e){this._interactiveArea.width=Ci(e.width,0,1),this._interactiveArea.height=Ci(e.height,0,1),this._interactiveArea.x=Ci(e.x,0,1-this._interactiveArea.width),this._interactiveArea.y=Ci(e.y,0,1-this._interactiveArea.height)}addEventListener(e,t){super.addEventListener(e,t)}removeEventListener(e,t){super.removeEventListener(e,t)}rotate(e,t,n=!1){return this.rotateTo(this._sphericalEnd.theta+e,this._sphericalEnd.phi+t,n)}rotateAzimuthTo(e,t=!1){return this.rotateTo(e,this._sphericalEnd.phi,t)}rotatePolarTo(e,t=!1){return this.rotateTo(this._sphericalEnd.theta,e,t)}rotateTo(e,t,n=!1){this._isUserControllingRotate=!1;let s=Ci(e,this.minAzimuthAngle,this.maxAzimuthAngle),r=Ci(t,this.minPolarAngle,this.maxPolarAngle);this._sphericalEnd.theta=s,this._sphericalEnd.phi=r,this._sphericalEnd.makeSafe(),this._needsUpdate=!0,n||(this._spherical.theta=this._sphericalEnd.theta,this._spherical.phi=this._sphericalEnd.phi);let o=!n||Ct(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Ct(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold);return this._createOnRestPromise(o)}dolly(e,t=!1){return this.dollyTo(this._sphericalEnd.radius-e,t)}dollyTo(e,t=!1){return this._isUserControllingDolly=!1,this._lastDollyDirection=la.NONE,this._changedDolly=0,this._dollyToNoClamp(Ci(e,this.minDistance,this.maxDistance),t)}_dollyToNoClamp(e,t=!1){let n=this._sphericalEnd.radius;if(this.colliderMeshes.length>=1){let o=this._collisionTest(),a=Ct(o,this._spherical.radius);if(!(n>e)&&a)return Promise.resolve();this._sphericalEnd.radius=Math.min(e,o)}else this._sphericalEnd.radius=e;this._needsUpdate=!0,t||(this._spherical.radius=this._sphericalEnd.radius);let r=!t||Ct(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(r)}dollyInFixed(e,t=!1){this._targetEnd.add(this._getCameraDirection(nc).multiplyScalar(e)),t||this._target.copy(this._targetEnd);let n=!t||Ct(this._target.x,this._targetEnd.x,this.restThreshold)&&Ct(this._target.y,this._targetEnd.y,this.restThreshold)&&Ct(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(n)}zoom(e,t=!1){return this.zoomTo(this._zoomEnd+e,t)}zoomTo(e,t=!1){this._isUserControllingZoom=!1,this._zoomEnd=Ci(e,this.minZoom,this.maxZoom),this._needsUpdate=!0,t||(this._zoom=this._zoomEnd);let n=!t||Ct(this._zoom,this._zoomEnd,this.restThreshold);return this._changedZoom=0,this._createOnRestPromise(n)}pan(e,t,n=!1){return console.warn("`pan` has been renamed to `truck`"),this.truck(e,t,n)}truck(e,t,n=!1){this._camera.updateMatrix(),ss.setFromMatrixColumn(this._camera.matrix,0),rs.setFromMatrixColumn(this._camera.matrix,1),ss.multiplyScalar(e),rs.multiplyScalar(-t);let s=Qe.copy(ss).add(rs),r=yt.copy(this._targetEnd).add(s);return this.moveTo(r.x,r.y,r.z,n)}forward(e,t=!1){Qe.setFromMatrixColumn(this._camera.matrix,0),Qe.crossVectors(this._camera.up,Qe),Qe.multiplyScalar(e);let n=yt.copy(this._targetEnd).add(Qe);return this.moveTo(n.x,n.y,n.z,t)}elevate(e,t=!1){return Qe.copy(this._camera.up).multiplyScalar(e),this.moveTo(this._targetEnd.x+Qe.x,this._targetEnd.y+Qe.y,this._targetEnd.z+Qe.z,t)}moveTo(e,t,n,s=!1){this._isUserControllingTruck=!1;let r=Qe.set(e,t,n).sub(this._targetEnd);this._encloseToBoundary(this._targetEnd,r,this.boundaryFriction),this._needsUpdate=!0,s||this._target.copy(this._targetEnd);let o=!s||Ct(this._target.x,this._targetEnd.x,this.restThreshold)&&Ct(this._target.y,this._targetEnd.y,this.restThreshold)&&Ct(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(o)}lookInDirectionOf(e,t,n,s=!1){let a=Qe.set(e,t,n).sub(this._targetEnd).normalize().multiplyScalar(-this._sphericalEnd.radius).add(this._targetEnd);return this.setPosition(a.x,a.y,a.z,s)}fitToBox(e,t,{cover:n=!1,paddingLeft:s=0,paddingRight:r=0,paddingBottom:o=0,paddingTop:a=0}={}){let l=[],c=e.isBox3?ha.copy(e):ha.setFromObject(e);c.isEmpty()&&(console.warn("camera-controls: fitTo() cannot be used with an empty box. Aborting"),Promise.resolve());let u=zy(this._sphericalEnd.theta,By),h=zy(this._sphericalEnd.phi,By);l.push(this.rotateTo(u,h,t));let d=Qe.setFromSpherical(this._sphericalEnd).normalize(),f=qy.setFromUnitVectors(d,km),g=Ct(Math.abs(d.y),1);g&&f.multiply(zm.setFromAxisAngle(ad,u)),f.multiply(this._yAxisUpSpaceInverse);let y=Xy.makeEmpty();yt.copy(c.min).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.min).setX(c.max.x).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.min).setY(c.max.y).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.max).setZ(c.min.z).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.min).setZ(c.max.z).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.max).setY(c.min.y).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.max).setX(c.min.x).applyQuaternion(f),y.expandByPoint(yt),yt.copy(c.max).applyQuaternion(f),y.expandByPoint(yt),y.min.x-=s,y.min.y-=o,y.max.x+=r,y.max.y+=a,f.setFromUnitVectors(km,d),g&&f.premultiply(zm.invert()),f.premultiply(this._yAxisUpSpace);let m=y.getSize(Qe),_=y.getCenter(yt).applyQuaternion(f);if(Gr(this._camera)){let v=this.getDistanceToFitBox(m.x,m.y,m.z,n);l.push(this.moveTo(_.x,_.y,_.z,t)),l.push(this.dollyTo(v,t)),l.push(this.setFocalOffset(0,0,0,t))}else if(or(this._camera)){let v=this._camera,M=v.right-v.left,b=v.top-v.bottom,w=n?Math.max(M/m.x,b/m.y):Math.min(M/m.x,b/m.y);l.push(this.moveTo(_.x,_.y,_.z,t)),l.push(this.zoomTo(w,t)),l.push(this.setFocalOffset(0,0,0,t))}return Promise.all(l)}fitToSphere(e,t){let n=[],r="isObject3D"in e?i.createBoundingSphere(e,Bm):Bm.copy(e);if(n.push(this.moveTo(r.center.x,r.center.y,r.center.z,t)),Gr(this._camera)){let o=this.getDistanceToFitSphere(r.radius);n.push(this.dollyTo(o,t))}else if(or(this._camera)){let o=this._camera.right-this._camera.left,a=this._camera.top-this._camera.bottom,l=2*r.radius,c=Math.min(o/l,a/l);n.push(this.zoomTo(c,t))}return n.push(this.setFocalOffset(0,0,0,t)),Promise.all(n)}setLookAt(e,t,n,s,r,o,a=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=la.NONE,this._changedDolly=0;let l=yt.set(s,r,o),c=Qe.set(e,t,n);this._targetEnd.copy(l),this._sphericalEnd.setFromVector3(c.sub(l).applyQuaternion(this._yAxisUpSpace)),this._needsUpdate=!0,a||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let u=!a||Ct(this._target.x,this._targetEnd.x,this.restThreshold)&&Ct(this._target.y,this._targetEnd.y,this.restThreshold)&&Ct(this._target.z,this._targetEnd.z,this.restThreshold)&&Ct(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Ct(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&Ct(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(u)}lerp(e,t,n,s=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=la.NONE,this._changedDolly=0;let r=Qe.set(...e.target);if("spherical"in e)ci.set(...e.spherical);else{let h=yt.set(...e.position);ci.setFromVector3(h.sub(r).applyQuaternion(this._yAxisUpSpace))}let o=ca.set(...t.target);if("spherical"in t)ua.set(...t.spherical);else{let h=yt.set(...t.position);ua.setFromVector3(h.sub(o).applyQuaternion(this._yAxisUpSpace))}this._targetEnd.copy(r.lerp(o,n));let a=ua.theta-ci.theta,l=ua.phi-ci.phi,c=ua.radius-ci.radius;this._sphericalEnd.set(ci.radius+c*n,ci.phi+l*n,ci.theta+a*n),this._needsUpdate=!0,s||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let u=!s||Ct(this._target.x,this._targetEnd.x,this.restThreshold)&&Ct(this._target.y,this._targetEnd.y,this.restThreshold)&&Ct(this._target.z,this._targetEnd.z,this.restThreshold)&&Ct(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Ct(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&Ct(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(u)}lerpLookAt(e,t,n,s,r,o,a,l,c,u,h,d,f,g=!1){return this.lerp({position:[e,t,n],target:[s,r,o]},{position:[a,l,c],target:[u,h,d]},f,g)}setPosition(e,t,n,s=!1){return this.setLookAt(e,t,n,this._targetEnd.x,this._targetEnd.y,this._targetEnd.z,s)}setTarget(e,t,n,s=!1){let r=this.getPosition(Qe),o=this.setLookAt(r.x,r.y,r.z,e,t,n,s);return this._sphericalEnd.phi=Ci(this._sphericalEnd.phi,this.minPolarAngle,this.maxPolarAngle),o}setFocalOffset(e,t,n,s=!1){this._isUserControllingOffset=!1,this._focalOffsetEnd.set(e,t,n),this._needsUpdate=!0,s||this._focalOffset.copy(this._focalOffsetEnd);let r=!s||Ct(this._focalOffset.x,this._focalOffsetEnd.x,this.restThreshold)&&Ct(this._focalOffset.y,this._focalOffsetEnd.y,this.restThreshold)&&Ct(this._focalOffset.z,this._focalOffsetEnd.z,this.restThreshold);return this._createOnRestPromise(r)}setOrbitPoint(e,t,n){this._camera.updateMatrixWorld(),ss.setFromMatrixColumn(this._camera.matrixWorldInverse,0),rs.setFromMatrixColumn(this._camera.matrixWorldInverse,1),Wr.setFromMatrixColumn(this._camera.matrixWorldInverse,2);let s=Qe.set(e,t,n),r=s.distanceTo(this._camera.position),o=s.sub(this._camera.position);ss.multiplyScalar(o.x),rs.multiplyScalar(o.y),Wr.multiplyScalar(o.z),Qe.copy(ss).add(rs).add(Wr),Qe.z=Qe.z+r,this.dollyTo(r,!1),this.setFocalOffset(-Qe.x,Qe.y,-Qe.z,!1),this.moveTo(e,t,n,!1)}setBoundary(e){if(!e){this._boundary.min.set(-1/0,-1/0,-1/0),this._boundary.max.set(1/0,1/0,1/0),this._needsUpdate=!0;return}this._boundary.copy(e),this._boundary.clampPoint(this._targetEnd,this._targetEnd),this._needsUpdate=!0}setViewport(e,t,n,s){if(e===null){this._viewport=null;return}this._viewport=this._viewport||new Xe.Vector4,typeof e=="number"?this._viewport.set(e,t,n,s):this._viewport.copy(e)}getDistanceToFitBox(e,t,n,s=!1){if(Um(this._camera,"getDistanceToFitBox"))return this._spherical.radius;let r=e/t,o=this._camera.getEffectiveFOV()*Ql,a=this._camera.aspect;return((s?r>a:r<a)?t:e/a)*.5/Math.tan(o*.5)+n*.5}getDistanceToFitSphere(e){if(Um(this._camera,"getDistanceToFitSphere"))return this._spherical.radius;let t=this._camera.getEffectiveFOV()*Ql,n=Math.atan(Math.tan(t*.5)*this._camera.aspect)*2,s=1<this._camera.aspect?t:n;return e/Math.sin(s*.5)}getTarget(e,t=!0){return(e&&e.isVector3?e:new Xe.Vector3).copy(t?this._targetEnd:this._target)}getPosition(e,t=!0){return(e&&e.isVector3?e:new Xe.Vector3).setFromSpherical(t?this._sphericalEnd:this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(t?this._targetEnd:this._target)}getSpherical(e,t=!0){return(e||new Xe.Spherical).copy(t?this._sphericalEnd:this._spherical)}getFocalOffset(e,t=!0){return(e&&e.isVector3?e:new Xe.Vector3).copy(t?this._focalOffsetEnd:this._focalOffset)}normalizeRotations(){return this._sphericalEnd.theta=(this._sphericalEnd.theta%rr+rr)%rr,this._sphericalEnd.theta>Math.PI&&(this._sphericalEnd.theta-=rr),this._spherical.theta+=rr*Math.round((this._sphericalEnd.theta-this._spherical.theta)/rr),this}stop(){this._focalOffset.copy(this._focalOffsetEnd),this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd),this._zoom=this._zoomEnd}reset(e=!1){if(!Ct(this._camera.up.x,this._cameraUp0.x)||!Ct(this._camera.up.y,this._cameraUp0.y)||!Ct(this._camera.up.z,this._cameraUp0.z)){this._camera.up.copy(this._cameraUp0);let n=this.getPosition(Qe);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}let t=[this.setLookAt(this._position0.x,this._position0.y,this._position0.z,this._target0.x,this._target0.y,this._target0.z,e),this.setFocalOffset(this._focalOffset0.x,this._focalOffset0.y,this._focalOffset0.z,e),this.zoomTo(this._zoom0,e)];return Promise.all(t)}saveState(){this._cameraUp0.copy(this._camera.up),this.getTarget(this._target0),this.getPosition(this._position0),this._zoom0=this._zoom,this._focalOffset0.copy(this._focalOffset)}updateCameraUp(){this._yAxisUpSpace.setFromUnitVectors(this._camera.up,ad),this._yAxisUpSpaceInverse.copy(this._yAxisUpSpace).invert()}applyCameraUp(){let e=Qe.subVectors(this._target,this._camera.position).normalize(),t=yt.crossVectors(e,this._camera.up);this._camera.up.crossVectors(t,e).normalize(),this._camera.updateMatrixWorld();let n=this.getPosition(Qe);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}update(e){let t=this._sphericalEnd.theta-this._spherical.theta,n=this._sphericalEnd.phi-this._spherical.phi,s=this._sphericalEnd.radius-this._spherical.radius,r=Gy.subVectors(this._targetEnd,this._target),o=Wy.subVectors(this._focalOffsetEnd,this._focalOffset),a=this._zoomEnd-this._zoom;if(Wt(t))this._thetaVelocity.value=0,this._spherical.theta=this._sphericalEnd.theta;else{let h=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.theta=rd(this._spherical.theta,this._sphericalEnd.theta,this._thetaVelocity,h,1/0,e),this._needsUpdate=!0}if(Wt(n))this._phiVelocity.value=0,this._spherical.phi=this._sphericalEnd.phi;else{let h=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.phi=rd(this._spherical.phi,this._sphericalEnd.phi,this._phiVelocity,h,1/0,e),this._needsUpdate=!0}if(Wt(s))this._radiusVelocity.value=0,this._spherical.radius=this._sphericalEnd.radius;else{let h=this._isUserControllingDolly?this.draggingSmoothTime:this.smoothTime;this._spherical.radius=rd(this._spherical.radius,this._sphericalEnd.radius,this._radiusVelocity,h,this.maxSpeed,e),this._needsUpdate=!0}if(Wt(r.x)&&Wt(r.y)&&Wt(r.z))this._targetVelocity.set(0,0,0),this._target.copy(this._targetEnd);else{let h=this._isUserControllingTruck?this.draggingSmoothTime:this.smoothTime;Vy(this._target,this._targetEnd,this._targetVelocity,h,this.maxSpeed,e,this._target),this._needsUpdate=!0}if(Wt(o.x)&&Wt(o.y)&&Wt(o.z))this._focalOffsetVelocity.set(0,0,0),this._focalOffset.copy(this._focalOffsetEnd);else{let h=this._isUserControllingOffset?this.draggingSmoothTime:this.smoothTime;Vy(this._focalOffset,this._focalOffsetEnd,this._focalOffsetVelocity,h,this.maxSpeed,e,this._focalOffset),this._needsUpdate=!0}if(Wt(a))this._zoomVelocity.value=0,this._zoom=this._zoomEnd;else{let h=this._isUserControllingZoom?this.draggingSmoothTime:this.smoothTime;this._zoom=rd(this._zoom,this._zoomEnd,this._zoomVelocity,h,1/0,e)}if(this.dollyToCursor){if(Gr(this._camera)&&this._changedDolly!==0){let h=this._spherical.radius-this._lastDistance,d=this._camera,f=this._getCameraDirection(nc),g=Qe.copy(f).cross(d.up).normalize();g.lengthSq()===0&&(g.x=1);let y=yt.crossVectors(g,f),m=this._sphericalEnd.radius*Math.tan(d.getEffectiveFOV()*Ql*.5),v=(this._sphericalEnd.radius-h-this._sphericalEnd.radius)/this._sphericalEnd.radius,M=ca.copy(this._targetEnd).add(g.multiplyScalar(this._dollyControlCoord.x*m*d.aspect)).add(y.multiplyScalar(this._dollyControlCoord.y*m)),b=Qe.copy(this._targetEnd).lerp(M,v),w=this._lastDollyDirection===la.IN&&this._spherical.radius<=this.minDistance,x=this._lastDollyDirection===la.OUT&&this.maxDistance<=this._spherical.radius;if(this.infinityDolly&&(w||x)){this._sphericalEnd.radius-=h,this._spherical.radius-=h;let S=yt.copy(f).multiplyScalar(-h);b.add(S)}this._boundary.clampPoint(b,b);let p=yt.subVectors(b,this._targetEnd);this._targetEnd.copy(b),this._target.add(p),this._changedDolly-=h,Wt(this._changedDolly)&&(this._changedDolly=0)}else if(or(this._camera)&&this._changedZoom!==0){let h=this._zoom-this._lastZoom,d=this._camera,f=Qe.set(this._dollyControlCoord.x,this._dollyControlCoord.y,(d.near+d.far)/(d.near-d.far)).unproject(d),g=yt.set(0,0,-1).applyQuaternion(d.quaternion),y=ca.copy(f).add(g.multiplyScalar(-f.dot(d.up))),_=-(this._zoom-h-this._zoom)/this._zoom,v=this._getCameraDirection(nc),M=this._targetEnd.dot(v),b=Qe.copy(this._targetEnd).lerp(y,_),w=b.dot(v),x=v.multiplyScalar(w-M);b.sub(x),this._boundary.clampPoint(b,b);let p=yt.subVectors(b,this._targetEnd);this._targetEnd.copy(b),this._target.add(p),this._changedZoom-=h,Wt(this._changedZoom)&&(this._changedZoom=0)}}this._camera.zoom!==this._zoom&&(this._camera.zoom=this._zoom,this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0),this._dragNeedsUpdate=!0;let l=this._collisionTest();this._spherical.radius=Math.min(this._spherical.radius,l),this._spherical.makeSafe(),this._camera.position.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(this._target),this._camera.lookAt(this._target),(!Wt(this._focalOffset.x)||!Wt(this._focalOffset.y)||!Wt(this._focalOffset.z))&&(ss.setFromMatrixColumn(this._camera.matrix,0),rs.setFromMatrixColumn(this._camera.matrix,1),Wr.setFromMatrixColumn(this._camera.matrix,2),ss.multiplyScalar(this._focalOffset.x),rs.multiplyScalar(-this._focalOffset.y),Wr.multiplyScalar(this._focalOffset.z),Qe.copy(ss).add(rs).add(Wr),this._camera.position.add(Qe),this._camera.updateMatrixWorld()),this._boundaryEnclosesCamera&&this._encloseToBoundary(this._camera.position.copy(this._target),Qe.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse),1);let u=this._needsUpdate;return u&&!this._updatedLastTime?(this._hasRested=!1,this.dispatchEvent({type:"wake"}),this.dispatchEvent({type:"update"})):u?(this.dispatchEvent({type:"update"}),Wt(t,this.restThreshold)&&Wt(n,this.restThreshold)&&Wt(s,this.restThreshold)&&Wt(r.x,this.restThreshold)&&Wt(r.y,this.restThreshold)&&Wt(r.z,this.restThreshold)&&Wt(o.x,this.restThreshold)&&Wt(o.y,this.restThreshold)&&Wt(o.z,this.restThreshold)&&Wt(a,this.restThreshold)&&!this._hasRested&&(this._hasRested=!0,this.dispatchEvent({type:"rest"}))):!u&&this._updatedLastTime&&this.dispatchEvent({type:"sleep"}),this._lastDistance=this._spherical.radius,this._lastZoom=this._zoom,this._updatedLastTime=u,this._needsUpdate=!1,u}toJSON(){return JSON.stringify({enabled:this._enabled,minDistance:this.minDistance,maxDistance:ec(this.maxDistance),minZoom:this.minZoom,maxZoom:ec(this.maxZoom),minPolarAngle:this.minPolarAngle,maxPolarAngle:ec(this.maxPolarAngle),minAzimuthAngle:ec(this.minAzimuthAngle),maxAzimuthAngle:ec(this.maxAzimuthAngle),smoothTime:this.smoothTime,draggingSmoothTime:this.draggingSmoothTime,dollySpeed:this.dollySpeed,truckSpeed:this.truckSpeed,dollyToCursor:this.dollyToCursor,target:this._targetEnd.toArray(),position:Qe.setFromSpherical(this._sphericalEnd).add(this._targetEnd).toArray(),zoom:this._zoomEnd,focalOffset:this._focalOffsetEnd.toArray(),target0:this._target0.toArray(),position0:this._position0.toArray(),zoom0:this._zoom0,focalOffset0:this._focalOffset0.toArray()})}fromJSON(e,t=!1){let n=JSON.parse(e);this.enabled=n.enabled,this.minDistance=n.minDistance,this.maxDistance=tc(n.maxDistance),this.minZoom=n.minZoom,this.maxZoom=tc(n.maxZoom),this.minPolarAngle=n.minPolarAngle,this.maxPolarAngle=tc(n.maxPolarAngle),this.minAzimuthAngle=tc(n.minAzimuthAngle),this.maxAzimuthAngle=tc(n.maxAzimuthAngle),this.smoothTime=n.smoothTime,this.draggingSmoothTime=n.draggingSmoothTime,this.dollySpeed=n.dollySpeed,this.truckSpeed=n.truckSpeed,this.dollyToCursor=n.dollyToCursor,this._target0.fromArray(n.target0),this._position0.fromArray(n.position0),this._zoom0=n.zoom0,this._focalOffset0.fromArray(n.focalOffset0),this.moveTo(n.target[0],n.target[1],n.target[2],t),ci.setFromVector3(Qe.fromArray(n.position).sub(this._targetEnd).applyQuaternion(this._yAxisUpSpace)),this.rotateTo(ci.theta,ci.phi,t),this.dollyTo(ci.radius,t),this.zoomTo(n.zoom,t),this.setFocalOffset(n.focalOffset[0],n.focalOffset[1],n.focalOffset[2],t),this._needsUpdate=!0}connect(e){if(this._domElement){console.warn("camera-controls is already connected.");return}e.setAttribute("data-camera-controls-version",FA),this._addAllEventListeners(e),this._getClientRect(this._elementRect)}disconnect(){this.cancel(),this._removeAllEventListeners(),this._domElement&&(this._domElement.removeAttribute("data-camera-controls-version"),this._domElement=void 0)}dispose(){this.removeAllEventListeners(),this.disconnect()}_getTargetDirection(e){return e.setFromSpherical(this._spherical).divideScalar(this._spherical.radius).applyQuaternion(this._yAxisUpSpaceInverse)}_getCameraDirection(e){return this._getTargetDirection(e).negate()}_findPointerById(e){return this._activePointers.find(t=>t.pointerId===e)}_findPointerByMouseButton(e){return this._activePointers.find(t=>t.mouseButton===e)}_disposePointer(e){this._activePointers.splice(this._activePointers.indexOf(e),1)}_encloseToBoundary(e,t,n){let s=t.lengthSq();if(s===0)return e;let r=yt.copy(t).add(e),a=this._boundary.clampPoint(r,ca).sub(r),l=a.lengthSq();if(l===0)return e.add(t);if(l===s)return e;if(n===0)return e.add(t).add(a);{let c=1+n*l/t.dot(a);return e.add(yt.copy(t).multiplyScalar(c)).add(a.multiplyScalar(1-n))}}_updateNearPlaneCorners(){if(Gr(this._camera)){let e=this._camera,t=e.near,n=e.getEffectiveFOV()*Ql,s=Math.tan(n*.5)*t,r=s*e.aspect;this._nearPlaneCorners[0].set(-r,-s,0),this._nearPlaneCorners[1].set(r,-s,0),this._nearPlaneCorners[2].set(r,s,0),this._nearPlaneCorners[3].set(-r,s,0)}else if(or(this._camera)){let e=this._camera,t=1/e.zoom,n=e.left*t,s=e.right*t,r=e.top*t,o=e.bottom*t;this._nearPlaneCorners[0].set(n,r,0),this._nearPlaneCorners[1].set(s,r,0),this._nearPlaneCorners[2].set(s,o,0),this._nearPlaneCorners[3].set(n,o,0)}}_collisionTest(){let e=1/0;if(!(this.colliderMeshes.length>=1)||Um(this._camera,"_collisionTest"))return e;let n=this._getTargetDirection(nc);Vm.lookAt(Hy,n,this._camera.up);for(let s=0;s<4;s++){let r=yt.copy(this._nearPlaneCorners[s]);r.applyMatrix4(Vm);let o=ca.addVectors(this._target,r);ld.set(o,n),ld.far=this._spherical.radius+1;let a=ld.intersectObjects(this.colliderMeshes);a.length!==0&&a[0].distance<e&&(e=a[0].distance)}return e}_getClientRect(e){if(!this._domElement)return;let t=this._domElement.getBoundingClientRect();return e.x=t.left,e.y=t.top,this._viewport?(e.x+=this._viewport.x,e.y+=t.height-this._viewport.w-this._viewport.y,e.width=this._viewport.z,e.height=this._viewport.w):(e.width=t.width,e.height=t.height),e}_createOnRestPromise(e){return e?Promise.resolve():(this._hasRested=!1,this.dispatchEvent({type:"transitionstart"}),new Promise(t=>{let n=()=>{this.removeEventListener("rest",n),t()};this.addEventListener("rest",n)}))}_addAllEventListeners(e){}_removeAllEventListeners(){}get dampingFactor(){return console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead."),0}set dampingFactor(e){console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead.")}get draggingDampingFactor(){return console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead."),0}set draggingDampingFactor(e){console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead.")}static createBoundingSphere(e,t=new Xe.Sphere){let n=t,s=n.center;ha.makeEmpty(),e.traverseVisible(o=>{o.isMesh&&ha.expandByObject(o)}),ha.getCenter(s);let r=0;return e.traverseVisible(o=>{if(!o.isMesh)return;let a=o;if(!a.geometry)return;let l=a.geometry.clone();l.applyMatrix4(a.matrixWorld);let u=l.attributes.position;for(let h=0,d=u.count;h<d;h++)Qe.fromBufferAttribute(u,h),r=Math.max(r,s.distanceToSquared(Qe))}),n.radius=Math.sqrt(r),n}};var Gm=2e3,BA=[{toward:new P(-.75,.55,.38).normalize(),strength:1.2,width:.7},{toward:new P(.8,.42,-.35).normalize(),strength:.5,width:.8},{toward:new P(.1,1,-.15).normalize(),strength:.4,width:.8}];function zA(i){let e=i.y,t=e>0?.24+.14*e**.6:.24-.14*(-e)**.5,n=0;for(let{toward:s,strength:r,width:o}of BA){let a=i.dot(s);a>o&&(n+=r*((a-o)/(1-o))**.5)}return[t*(1-.05*e)+n,t+n*.99,t*(1+.09*e)+n*.96]}function $y(){let i=new Lr,e=[],t=4*Math.PI/Gm;for(let n=0;n<Gm;n+=1){let s=1-(2*n+1)/Gm,r=Math.sqrt(1-s*s),o=n*Math.PI*(3-Math.sqrt(5)),a=new P(r*Math.cos(o),s,r*Math.sin(o)),l=new P(...zA(a));Lr.getBasisAt(a,e);for(let c=0;c<9;c+=1)i.coefficients[c].addScaledVector(l,e[c]*t)}return new gl(i)}var VA=`
varying vec2 at; uniform vec2 middle; uniform float size;
void main() {
  at = middle + position.xy * size * vec2(1.0, -1.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,HA=`
varying vec2 at; uniform vec2 middle; uniform float step1, reach, strength; uniform vec3 ink;
float lines(float spacing) {
  vec2 cell = at / spacing;
  vec2 width = fwidth(cell);
  vec2 near = abs(fract(cell - 0.5) - 0.5) / width;
  // A grid finer than a few pixels is grey noise: it fades out before.
  float fine = 1.0 - smoothstep(0.12, 0.4, max(width.x, width.y));
  return (1.0 - min(min(near.x, near.y), 1.0)) * fine;
}
void main() {
  float fade = 1.0 - smoothstep(0.25, 1.0, length(at - middle) / reach);
  float alpha = max(lines(step1) * 0.45, lines(step1 * 10.0)) * fade * fade * strength;
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(ink, alpha);
  #include <colorspace_fragment>
}`,cd=class{mesh;step=1;constructor(){let e={middle:{value:[0,0]},size:{value:1},step1:{value:1},reach:{value:1},strength:{value:.5},ink:{value:new Ne("#5b6b73")}},t=new un({uniforms:e,vertexShader:VA,fragmentShader:HA,transparent:!0,depthWrite:!1,side:rn});this.mesh=new Tt(new Gi(1,1),t),this.mesh.rotation.x=-Math.PI/2,this.mesh.renderOrder=-2,this.mesh.frustumCulled=!1}place(e,t,n){let{uniforms:s}=this.mesh.material,r=t*4.5;this.step=10**Math.floor(Math.log10(t/2.5));let o=this.step*10,[a,l]=[Math.round(e.x/o)*o,Math.round(e.z/o)*o];this.mesh.position.set(a,n-.004*t,l),this.mesh.scale.setScalar(2*r),Object.assign(s.middle,{value:[0,0]}),s.size.value=2*r,s.step1.value=this.step,s.reach.value=r}style(e,t){this.mesh.material.uniforms.ink.value.set(e),this.mesh.material.uniforms.strength.value=t}};var fa=256,GA=1.5,WA=`
varying float height; uniform float ground, reach;
void main() { vec4 at = modelMatrix * vec4(position, 1.0); height = (at.y - ground) / reach; gl_Position = projectionMatrix * viewMatrix * at; }`,XA=`
varying float height;
void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, 0.75 * pow(1.0 - clamp(height, 0.0, 1.0), 1.4)); }`,qA="varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }",YA=`
varying vec2 at; uniform sampler2D picture; uniform vec2 step;
void main() {
  float sum = 0.0, weight = 0.0;
  for (float i = -8.0; i <= 8.0; i += 1.0) {
    float w = exp(-0.5 * i * i / 16.0);
    sum += w * texture2D(picture, at + i * step).a; weight += w;
  }
  gl_FragColor = vec4(0.0, 0.0, 0.0, sum / weight);
}`,ud=class{plane;targets=[new Fn(fa,fa),new Fn(fa,fa)];camera=new Ts(-1,1,1,-1,0,1);dark=new un({vertexShader:WA,fragmentShader:XA,side:rn,blending:qi,uniforms:{ground:{value:0},reach:{value:1}}});blur=new un({vertexShader:qA,fragmentShader:YA,depthTest:!1,depthWrite:!1,blending:qi,uniforms:{picture:{value:null},step:{value:[0,0]}}});page=new Tt(new Gi(1,1),this.blur);constructor(){let e=new pi({map:this.targets[0].texture,transparent:!0,depthWrite:!1,opacity:.5,toneMapped:!1});this.plane=new Tt(new Gi(1,1),e),this.plane.rotation.x=-Math.PI/2,this.plane.renderOrder=-1,this.page.frustumCulled=!1}update(e,t,n,s,r){let o=[],a=!1;if(n.traverse(w=>{w.userData.castsShadow?a||=w.visible:("isMesh"in w||"isLine"in w||"isPoints"in w)&&o.push(w)}),this.plane.visible=a,!a)return;let[l,c]=[s.max.x-s.min.x,s.max.z-s.min.z],u=Math.max(l,c)*GA||1,h=Math.max(s.max.y-s.min.y,.35*u),[d,f]=[(s.min.x+s.max.x)/2,(s.min.z+s.max.z)/2],g=s.min.y;this.plane.position.set(d,g-.002*u,f),this.plane.scale.setScalar(u);let{camera:y,dark:m,targets:_}=this;Object.assign(y,{left:-u/2,right:u/2,top:u/2,bottom:-u/2,near:0,far:2*h+.1*u}),y.position.set(d,g+2*h,f),y.up.set(0,0,-1),y.lookAt(d,g,f),y.updateProjectionMatrix(),m.uniforms.ground.value=g,m.uniforms.reach.value=h;let v=[...r,this.plane,...o].map(w=>[w,w.visible]);v.forEach(([w])=>{w.visible=!1});let M=e.getRenderTarget(),b=t.background;t.background=null,t.overrideMaterial=m,e.setRenderTarget(_[0]),e.setScissorTest(!1),e.clear(),e.render(t,y),t.overrideMaterial=null,t.background=b,v.forEach(([w,x])=>{w.visible=x}),this.smear(e,_[0],_[1],[1.1/fa,0]),this.smear(e,_[1],_[0],[0,1.1/fa]),e.setRenderTarget(M)}smear(e,t,n,s){this.blur.uniforms.picture.value=t.texture,this.blur.uniforms.step.value=s,e.setRenderTarget(n),e.clear(),e.render(this.page,this.camera)}style(e){this.plane.material.opacity=e}};da.install({THREE:{Box3:je,Matrix4:Re,Quaternion:Xn,Raycaster:Zs,Sphere:kt,Spherical:yl,Vector2:Ue,Vector3:P,Vector4:ot}});var Xm=30,$A=2,hd=class{constructor(e,t){this.canvas=e;this.insets=t;this.renderer=ZA(e),this.shadow=new ud,this.scene.add(this.model,this.grid.mesh,this.shadow.plane);let n=new Ir(16775406,1.8);n.position.set(-3.4,2.2,.6),this.scene.add(n,$y()),this.controls=new da(this.camera,e),Object.assign(this.controls,{smoothTime:.12,draggingSmoothTime:.05,minPolarAngle:.001,maxPolarAngle:Math.PI-.001,dollyToCursor:!0});let{ACTION:s}=da;Object.assign(this.controls.mouseButtons,{left:s.ROTATE,right:s.TRUCK,middle:s.TRUCK,wheel:s.NONE});for(let r of["controlstart","control","transitionstart"])this.controls.addEventListener(r,()=>this.wake());this.controls.addEventListener("rest",()=>this.onRest()),e.addEventListener("wheel",r=>this.onWheel(r),{passive:!1}),e.addEventListener("webglcontextlost",r=>r.preventDefault()),e.addEventListener("webglcontextrestored",()=>this.invalidate()),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}canvas;insets;renderer;scene=new Ja;camera=new an(Xm,1,.1,1e3);controls;model=new xn;grid=new cd;shadow;beforeDraw=()=>{};onDraw=()=>{};onRest=()=>{};content=()=>[];tiles=null;width=1;height=1;frames=0;dirty=!0;running=!1;last=0;sphere=new kt(new P,5);wasInside=!0;invalidate(){this.dirty=!0,this.wake()}wake(){this.running||(this.running=!0,this.last=performance.now(),requestAnimationFrame(e=>this.tick(e)))}tick(e){let t=Math.min(Math.max(e-this.last,1)/1e3,.1);this.last=e;let n=this.controls.update(t);(n||this.dirty)&&this.draw(),n||this.dirty||this.controls.active?requestAnimationFrame(s=>this.tick(s)):this.running=!1}draw(){this.dirty=!1,this.frames+=1;let{renderer:e,camera:t}=this,n=t.position.distanceTo(this.sphere.center);t.near=Math.max(n-4*this.sphere.radius,n*.004),t.far=n+40*this.sphere.radius,t.updateProjectionMatrix(),t.updateMatrixWorld(),this.beforeDraw(),e&&(this.tiles?this.drawTiles(e,this.tiles):(e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.render(this.scene,t))),this.onDraw()}drawTiles(e,t){let n=this.canvas.getBoundingClientRect();e.setScissorTest(!1),e.clear(),e.setScissorTest(!0);let s=[this.model,this.grid.mesh,this.shadow.plane].map(r=>[r,r.visible]);s.forEach(([r])=>{r.visible=!1});for(let{element:r,group:o}of t){let a=r.getBoundingClientRect(),l=Math.max(a.top,n.top),c=Math.min(a.bottom,n.bottom);c<=l||a.width<1||(e.setViewport(a.left-n.left,n.bottom-a.bottom,a.width,a.height),e.setScissor(a.left-n.left,n.bottom-c,a.width,c-l),this.camera.aspect=a.width/a.height,this.camera.fov=Wm(this.camera.aspect),this.camera.updateProjectionMatrix(),this.scene.add(o),e.render(this.scene,this.camera),this.scene.remove(o))}s.forEach(([r,o])=>{r.visible=o}),e.setScissorTest(!1),this.shape()}async picture(e,t){let{renderer:n}=this;if(!n)throw new Error("there is no picture without WebGL 2");let s=n.getPixelRatio();n.setPixelRatio(e),n.setSize(this.width,this.height,!1),this.scene.background=t===null?null:new Ne(t),this.draw();let r=await new Promise(o=>{this.canvas.toBlob(o,"image/png")});if(this.scene.background=null,n.setPixelRatio(s),n.setSize(this.width,this.height,!1),this.draw(),!r)throw new Error("the browser makes no picture of this size");return r}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.width=e,this.height=t,this.renderer&&(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,$A)),this.renderer.setSize(e,t,!1)),this.shape(),this.wasInside&&!this.allInside()&&this.fit(!1),this.draw())}shape(){this.camera.aspect=this.width/this.height,this.camera.fov=Wm(this.camera.aspect),this.camera.updateProjectionMatrix()}measure(){let e=this.content(),t=new je;e.forEach(n=>t.expandByPoint(new P(...n))),t.isEmpty()&&t.set(new P(-5,0,-5),new P(5,0,5)),t.getBoundingSphere(this.sphere),this.sphere.radius===0&&(this.sphere.radius=1),this.grid.place(this.sphere.center,this.sphere.radius,t.min.y),this.renderer&&this.shadow.update(this.renderer,this.scene,this.model,t,[this.grid.mesh]),this.invalidate()}get radius(){return this.sphere.radius}get centre(){return this.sphere.center}fit(e,t){let n=this.content(),s=t?new P(...t):this.camera.position.clone().sub(this.controls.getTarget(new P));s.lengthSq()===0&&s.set(.6,.55,.8),s.normalize();let r=new P(0,1,0).cross(s);r.lengthSq()<1e-9&&r.set(1,0,0),r.normalize();let o=s.clone().cross(r),a=n.length>0?n.map(A=>new P(...A).sub(this.sphere.center)):KA(this.sphere.radius),{top:l,right:c,bottom:u,left:h}=this.insets(),f=2*Math.tan(Wm(this.width/this.height)*Math.PI/360)/this.height,g=Math.max(this.width-h-c,this.width/4)*f/2,y=Math.max(this.height-l-u,this.height/4)*f/2,m=a.map(A=>A.dot(r)),_=a.map(A=>A.dot(o)),v=a.map(A=>A.dot(s)),M=this.sphere.radius,b=0,w=0;for(let A=0;A<6;A+=1){M=0;for(let L=0;L<a.length;L+=1){let U=Math.max(Math.abs(m[L]-b)/g,Math.abs(_[L]-w)/y);M=Math.max(M,v[L]+U,v[L]+.02*this.sphere.radius)}let[E,C,I,D]=[1/0,-1/0,1/0,-1/0];for(let L=0;L<a.length;L+=1){let U=M-v[L];E=Math.min(E,(m[L]-b)/U),C=Math.max(C,(m[L]-b)/U),I=Math.min(I,(_[L]-w)/U),D=Math.max(D,(_[L]-w)/U)}b+=(E+C)/2*M,w+=(I+D)/2*M}M*=1.02;let x=(c-h)/2*f*M,p=(l-u)/2*f*M,S=this.sphere.center.clone().addScaledVector(r,b+x).addScaledVector(o,w+p);this.place({eye:S.clone().addScaledVector(s,M).toArray(),target:S.toArray()},e)}pose(){return{eye:this.controls.getPosition(new P).toArray(),target:this.controls.getTarget(new P).toArray()}}place({eye:e,target:t},n){let s=!n||matchMedia("(prefers-reduced-motion: reduce)").matches;this.controls.setLookAt(...e,...t,!s),s&&this.controls.update(0),this.invalidate()}look(e){this.fit(!0,e)}orbit(e,t){this.controls.rotate(e,t,!0),this.wake()}pan(e,t){let n=this.pixelAt(this.controls.getTarget(new P));this.controls.truck(-e*n,-t*n,!0),this.wake()}onWheel(e){e.preventDefault();let t=e.deltaMode===1?16:1,{x:n,y:s}=this.local(e);this.zoom(n,s,Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0016))))}zoom(e,t,n){let s=this.controls.getTarget(new P),r=this.controls.getPosition(new P),o=r.distanceTo(s)*n;if(o<this.sphere.radius*.001||o>this.sphere.radius*60)return;let a=this.ray(e,t),l=this.under(e,t),c;if(l)c=l;else{let u=s.clone().sub(r).normalize(),h=a.direction.dot(u);c=a.origin.clone().addScaledVector(a.direction,s.clone().sub(a.origin).dot(u)/h)}r.sub(c).multiplyScalar(n).add(c),s.sub(c).multiplyScalar(n).add(c),this.place({eye:r.toArray(),target:s.toArray()},!1),this.onRest()}under=()=>null;local(e){let t=this.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}project(e){let t=new P(...e).project(this.camera);return{x:(t.x+1)/2*this.width,y:(1-t.y)/2*this.height,visible:t.z<1}}ray(e,t){let n=new Zs;return n.setFromCamera(new Ue(e/this.width*2-1,1-t/this.height*2),this.camera),n.ray}pixelAt(e){let t=this.camera.getWorldDirection(new P),n=e.clone().sub(this.camera.position).dot(t);return 2*Math.max(n,1e-9)*Math.tan(this.camera.fov*Math.PI/360)/this.height}onPlane(e,t,n,s){let{origin:r,direction:o}=this.ray(e,t),a=o.dot(s);if(Math.abs(a)<1e-6)return null;let l=n.clone().sub(r).dot(s)/a;return l<=0||l>60*this.sphere.radius+r.distanceTo(n)?null:r.clone().addScaledVector(o,l)}allInside(){return this.content().every(e=>{let{x:t,y:n,visible:s}=this.project(e);return s&&t>=0&&n>=0&&t<=this.width&&n<=this.height})}rememberWhetherAllIsSeen(){this.camera.updateMatrixWorld(),this.wasInside=this.allInside()}},Wm=i=>i>=1?Xm:Math.atan(Math.tan(Xm*Math.PI/360)/i)*360/Math.PI,KA=i=>[-1,1].flatMap(e=>[-1,1].map(t=>new P(e*i*.7,0,t*i*.7)));function ZA(i){let e=i.getContext("webgl2",{antialias:!0,alpha:!0,powerPreference:"high-performance"});if(!e)return null;let t=new hh({canvas:i,context:e,antialias:!0,alpha:!0});return t.setClearColor(0,0),t.toneMapping=bl,t.toneMappingExposure=1,t.debug.checkShaderErrors=!1,t}var ar={point:11,touch:24,edge:8,snap:12,align:7},Ky=4,JA=46,dd=class{constructor(e){this.host=e;let{canvas:t}=e.stage;this.marquee=document.createElement("div"),this.marquee.className="marquee",this.marquee.hidden=!0,t.parentElement.append(this.marquee),t.addEventListener("pointerdown",n=>this.press(n),{capture:!0}),t.addEventListener("pointermove",n=>this.glide(n)),t.addEventListener("pointerleave",()=>{this.busy||(this.hover=null,this.ghost=null,this.next=null,this.drawing&&e.label(null),this.refresh())}),t.addEventListener("contextmenu",n=>n.preventDefault()),t.addEventListener("keydown",n=>this.key(n)),e.stage.beforeDraw=()=>this.hints()}host;selection=[];mode="ground";snapping=!0;level=0;next=null;hover=null;ghost=null;busy=!1;marquee;get drawing(){return this.host.history.document.draft!==null}get only(){return this.selection.length===1?this.selection[0]:null}select(e){this.selection=e,this.refresh(),this.host.selectionChanged();let{only:t}=this,n=t&&this.host.lines[t.line];n&&this.host.announce(`${n.name}, point ${t.point+1} of ${n.points.length}: ${(Gt(n.points[t.point])??[]).map(s=>At(s,6)).join(", ")}`)}prune(){let{lines:e}=this.host;this.selection=this.selection.filter(({line:t,point:n})=>n<(e[t]?.points.length??0)),this.hover=null,this.ghost=null}refresh(){let{sketch:e,stage:t,faulty:n}=this.host;e.mark(s=>s.line<0?4:this.selection.some(r=>Ls(r,s))?2:n.has(`${s.line}/${s.point}`)?3:Ls(this.hover,s)?1:0),t.invalidate()}step(e){let{lines:t}=this.host,n=t.flatMap((r,o)=>r.points.map((a,l)=>({line:o,point:l})));if(n.length===0)return;let s=n.findIndex(r=>Ls(r,this.selection.at(-1)??null));this.select([n[s<0?e>0?0:n.length-1:(s+e+n.length)%n.length]])}nearestPoint(e,t,n){let{stage:s,sketch:r,surface:o}=this.host,a=null;if(r.places.forEach((f,g)=>{if(r.refs[g].line<0)return;let y=s.project(f),m=Math.hypot(y.x-e,y.y-t);y.visible&&m<=n&&(!a||m<a.distance)&&(a={ref:r.refs[g],distance:m,place:f})}),!a)return null;let{ref:l,place:c}=a;if(this.selection.some(f=>Ls(f,l)))return l;let u=new P(...c),h=o.pick(s,s.project(c).x,s.project(c).y);return h&&h.distance<s.camera.position.distanceTo(u)-14*s.pixelAt(u)?null:l}nearestEdge(e,t){let{stage:n,lines:s,frame:r}=this.host,o=null;return s.forEach((a,l)=>{if(_r(a)||a.name.startsWith("control"))return;let c=a.points.map(Gt),u=a.closed&&c.length>2?c.length:c.length-1;for(let h=0;h<u;h+=1){let d=c[h],f=c[(h+1)%c.length];if(!d||!f)continue;let g=n.project(r.toScene(d)),y=n.project(r.toScene(f)),m=(y.x-g.x)**2+(y.y-g.y)**2;if(!g.visible||!y.visible||m<900)continue;let _=((e-g.x)*(y.x-g.x)+(t-g.y)*(y.y-g.y))/m,v=Math.hypot(g.x+_*(y.x-g.x)-e,g.y+_*(y.y-g.y)-t);if(_<.08||_>.92||v>ar.edge||o&&v>=o.distance)continue;let M=this.alongEdge(d,f,e,t);o={line:l,after:h,distance:v,point:d.map((b,w)=>b+M*(f[w]-b))}}}),o}alongEdge(e,t,n,s){let{stage:r,frame:o}=this.host,a=new P(...o.toScene(e)),l=new P(...o.toScene(t)).sub(a),{origin:c,direction:u}=r.ray(n,s),h=a.clone().sub(c),d=l.dot(l),f=l.dot(u),g=l.dot(h),y=u.dot(h),m=d-f*f;return m>1e-12*d?Math.min(.98,Math.max(.02,(f*y-g)/m)):.5}arrow(){let{only:e}=this,{stage:t,frame:n,lines:s}=this.host,r=e&&Gt(s[e.line]?.points[e.point]);if(!r||this.drawing)return null;let o=new P(...n.toScene(r)),a=JA*t.pixelAt(o);return{from:o,to:o.clone().addScaledVector(this.liftAxis(),a)}}liftAxis(){let{camera:e}=this.host.stage,t=e.getWorldDirection(new P);return Math.abs(t.y)>.94?new P(0,1,0).applyQuaternion(e.quaternion):new P(0,1,0)}onArrow(e,t){let n=this.arrow();if(!n)return!1;let s=this.host.stage.project(n.from.toArray()),r=this.host.stage.project(n.to.toArray()),o=Math.hypot(r.x-s.x,r.y-s.y);if(o<12)return!1;let a=((e-s.x)*(r.x-s.x)+(t-s.y)*(r.y-s.y))/(o*o),l=Math.abs((e-s.x)*(r.y-s.y)-(t-s.y)*(r.x-s.x))/o;return a>.4&&a<1.2&&l<8}glide(e){if(this.busy||e.buttons!==0||this.host.fixed)return;let{stage:t,host:n}={stage:this.host.stage,host:this.host},{x:s,y:r}=t.local(e);if(this.drawing){this.next=this.snap(s,r,e.altKey),this.showNext(s,r),t.canvas.style.cursor="crosshair",t.invalidate();return}let o=this.onArrow(s,r),a=o?null:this.nearestPoint(s,r,ar.point),l=o||a?null:this.nearestEdge(s,r),c=!Ls(a,this.hover)||JSON.stringify(l)!==JSON.stringify(this.ghost);this.hover=a,this.ghost=l,t.canvas.style.cursor=o?"ns-resize":a?"grab":l?"copy":"",c&&(this.refresh(),n.selectionChanged())}press(e){let{stage:t,host:n}={stage:this.host.stage,host:this.host};if(t.canvas.focus({preventScroll:!0}),e.button!==0||this.busy||this.host.fixed)return;let s=t.local(e),r=e.pointerType==="touch";if(this.drawing){this.onRelease(e,(l,c,u,h)=>{u<=Ky&&this.place(this.snap(l,c,h.altKey))});return}if(this.onArrow(s.x,s.y)){this.drag(e,this.only,"height");return}let o=this.nearestPoint(s.x,s.y,r?ar.touch:ar.point);if(o){this.drag(e,o,this.mode);return}let a=r?null:this.nearestEdge(s.x,s.y);if(a&&!e.shiftKey){n.history.begin(),this.insertAt(a.line,a.after,this.tidy(a.point)),n.changed(!0),this.drag(e,{line:a.line,point:a.after+1},this.mode);return}if(e.shiftKey){this.selectBox(e);return}this.onRelease(e,(l,c,u)=>{if(u>Ky)return;let h=n.surface.pick(t,l,c);h?n.read(h.point,h.face,l,c):(n.label(null),this.selection.length>0&&this.select([]))})}onRelease(e,t){let{stage:n}=this.host,s=n.local(e),r=0,o=l=>{let{x:c,y:u}=n.local(l);r=Math.max(r,Math.hypot(c-s.x,u-s.y))},a=l=>{if(l.pointerId!==e.pointerId)return;document.removeEventListener("pointermove",o),document.removeEventListener("pointerup",a),document.removeEventListener("pointercancel",a);let{x:c,y:u}=n.local(l);l.type==="pointerup"&&t(c,u,r,l)};document.addEventListener("pointermove",o),document.addEventListener("pointerup",a),document.addEventListener("pointercancel",a)}seize(e,t,n){let{stage:s}=this.host;this.busy=!0,s.controls.enabled=!1,e.preventDefault();try{s.canvas.setPointerCapture(e.pointerId)}catch{}let r=a=>{a.pointerId===e.pointerId&&t(a)},o=a=>{a.pointerId===e.pointerId&&(document.removeEventListener("pointermove",r),document.removeEventListener("pointerup",o),document.removeEventListener("pointercancel",o),this.busy=!1,s.controls.enabled=!0,n(a))};document.addEventListener("pointermove",r),document.addEventListener("pointerup",o),document.addEventListener("pointercancel",o)}drag(e,t,n){let{host:s}=this,{stage:r,history:o,frame:a}=s,l=s.lines[t.line].points[t.point],c=Gt(l);if(!c)return;let u=this.selection.some(_=>Ls(_,t));u||this.select(e.shiftKey?[...this.selection,t]:[t]);let h=this.selection.map(_=>({ref:_,from:Gt(s.lines[_.line].points[_.point])??c})),d=new P(...a.toScene(c)),f=r.project(d.toArray()),g=r.local(e),y={x:g.x-f.x,y:g.y-f.y},m=!1;o.begin(),this.seize(e,_=>{let{x:v,y:M}=r.local(_);if(!m&&Math.hypot(v-g.x,M-g.y)<2)return;m=!0;let b=n==="height"!==(_.shiftKey&&!e.shiftKey),w=b?this.raised(d,M-g.y):this.grounded(d,v-y.x,M-y.y);if(!w)return;let x=this.rounded(w,c);!b&&this.snapping&&!_.altKey&&(x=this.onto(v,M,h.map(A=>A.ref))??x);for(let{ref:A,from:E}of h)this.write(A,E.map((C,I)=>Xr(C+x[I]-c[I])));let p=r.project(a.toScene(x)),S=Oi(o.document.request);s.label(b?`${"xyz"[a.up]} ${At(x[a.up],6)} ${S}`:x.map((A,E)=>`${"xyz"[E]} ${At(A,6)}`).join("  "),p.x,p.y),this.lifting=b,s.changed(!0)},_=>{this.lifting=!1,s.label(null),!m&&_.type==="pointerup"&&(e.shiftKey&&u?this.select(this.selection.filter(v=>!Ls(v,t))):e.shiftKey||this.select([t])),o.commit()&&s.changed(!1)})}lifting=!1;selectBox(e){let{stage:t,sketch:n}=this.host,s=t.local(e),r=this.selection,{style:o}=this.marquee;this.seize(e,a=>{let{x:l,y:c}=t.local(a),[u,h,d,f]=[Math.min(l,s.x),Math.min(c,s.y),Math.max(l,s.x),Math.max(c,s.y)];this.marquee.hidden=!1,Object.assign(o,{left:`${u}px`,top:`${h}px`,width:`${d-u}px`,height:`${f-h}px`});let g=n.refs.filter((y,m)=>{let _=t.project(n.places[m]);return y.line>=0&&_.visible&&_.x>=u&&_.x<=d&&_.y>=h&&_.y<=f});this.selection=[...r,...g.filter(y=>!r.some(m=>Ls(m,y)))],this.refresh()},()=>{this.marquee.hidden=!0,this.select(this.selection)})}grounded(e,t,n){let{stage:s}=this.host,r=s.camera.getWorldDirection(new P);return s.onPlane(t,n,e,Math.abs(r.y)>.08?new P(0,1,0):r)}raised(e,t){let{stage:n}=this.host,s=new P(0,1,0).applyQuaternion(n.camera.quaternion).y;return e.clone().add(new P(0,-t*n.pixelAt(e)/Math.max(s,.35),0))}rounded(e,t){let{stage:n,frame:s}=this.host,r=10**Math.floor(Math.log10(s.length(n.pixelAt(e))*1.5)),o=s.fromScene(e.toArray()),a=1e-9*s.length(n.radius)+1e-12*Math.max(...t.map(Math.abs));return o.map((l,c)=>Math.abs(l-t[c])<=a?t[c]:Xr(Math.round(l/r)*r))}tidy(e){let{frame:t}=this.host;return this.rounded(new P(...t.toScene(e)),[NaN,NaN,NaN])}onto(e,t,n){let{stage:s,sketch:r,lines:o}=this.host,a=r.refs.findIndex((c,u)=>{if(c.line<0||n.some(d=>d.line===c.line))return!1;let h=s.project(r.places[u]);return h.visible&&Math.hypot(h.x-e,h.y-t)<ar.snap}),l=r.refs[a];return l?Gt(o[l.line].points[l.point]):null}write({line:e,point:t},n){let{points:s}=this.host.lines[e],r=s[t];Array.isArray(r)?r.splice(0,Math.max(3,r.length),...n):s[t]=n}moveBy(e){let{history:t}=this.host;t.edit(()=>{for(let s of this.selection){let r=Gt(this.host.lines[s.line].points[s.point]);r&&this.write(s,r.map((o,a)=>Xr(o+e[a])))}})&&this.host.changed(!1)}setAxis(e,t){this.host.history.edit(()=>{for(let s of this.selection){let r=Gt(this.host.lines[s.line].points[s.point])??[0,0,0];r[e]=t,this.write(s,r)}})&&this.host.changed(!1)}edgeBefore(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t||_r(t)||t.points.length<2)return null;let n=e.point>0?e.point-1:t.closed?t.points.length-1:-1,s=Gt(t.points[e.point]),r=Gt(t.points[n]);return s&&r?{length:Math.hypot(...s.map((o,a)=>o-r[a])),previous:r,point:s}:null}setEdgeBefore(e){let t=this.edgeBefore(),{only:n}=this;if(!t||!n||!(e>0)||t.length===0)return;let s=t.previous.map((r,o)=>Xr(r+(t.point[o]-r)*e/t.length));this.host.history.edit(()=>this.write(n,s))&&this.host.changed(!1)}companions(e){let{request:t}=this.host.history.document,{points:n,path:s}=this.host.lines[e];return s[0]!=="directrices"?[]:["normals","tangents"].flatMap(r=>{let o=t[r]?.[s[1]];return Array.isArray(o)&&o.length===n.length?[o]:[]})}insertAt(e,t,n){this.companions(e).forEach(s=>s.splice(t+1,0,structuredClone(s[t]))),this.host.lines[e].points.splice(t+1,0,n),this.selection=[{line:e,point:t+1}]}insert(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t)return;let n=Gt(t.points[e.point]),s=Gt(t.points[e.point+1])??(t.closed?Gt(t.points[0]):null);if(!n)return;let r=Gt(t.points[e.point-1])??n.map((a,l)=>a-(l===0?1:0)),o=n.map((a,l)=>Xr(s?(a+s[l])/2:2*a-r[l]));this.host.history.edit(()=>this.insertAt(e.line,e.point,o))&&this.host.changed(!1),this.select(this.selection)}remove(){let{host:e}=this;if(this.selection.length===0)return;let[t]=this.selection;e.history.edit(()=>{let s=[...this.selection].sort((r,o)=>o.line-r.line||o.point-r.point);for(let{line:r,point:o}of s)this.companions(r).forEach(a=>a.splice(o,1)),e.lines[r].points.splice(o,1);for(let r=e.lines.length-1;r>=0;r-=1)e.lines[r].points.length===0&&this.dropLine(r)}),this.selection=[],e.changed(!1);let n=e.lines[t.line]?.points.length??0;this.select(n>0&&n>1?[{line:t.line,point:Math.min(t.point,n-1)}]:[])}removeLine(){let{host:e}=this,t=[...new Set(this.selection.map(n=>n.line))].sort((n,s)=>s-n);t.length!==0&&(e.history.edit(()=>t.forEach(n=>this.dropLine(n))),this.selection=[],e.changed(!1),this.select([]))}dropLine(e){let{request:t}=this.host.history.document,{path:n}=this.host.lines[e],s=Ig(t,n.slice(0,-1)),r=n.at(-1);if(Array.isArray(s)?s.splice(Number(r),1):delete s[r],n[0]==="directrices")for(let o of["normals","tangents"])Array.isArray(t[o])&&t[o].splice(Number(r),1)}startDrawing(){let{history:e,stage:t,lines:n,frame:s}=this.host;if(this.drawing)return;e.edit(a=>{a.draft=[]}),this.select([]);let r=n.flatMap(a=>a.points.map(l=>Gt(l)?.[s.up]??1/0));this.level=r.length>0?Math.min(...r):s.origin[s.up],this.next=null;let o=t.camera.getWorldDirection(new P);Math.abs(o.y)<.3&&t.look([.25,1.2,.6]),this.host.changed(!1),t.canvas.focus({preventScroll:!0})}stopDrawing(){this.drawing&&(this.host.history.edit(e=>{e.draft=null}),this.next=null,this.host.label(null),this.host.stage.canvas.style.cursor="",this.host.changed(!1))}get least(){return Ut[this.host.history.document.kind].least}place(e){if(e){if(e.close){this.finishDrawing();return}this.host.history.edit(t=>{t.draft.push(e.point)}),this.host.changed(!1)}}finishDrawing(){let{host:e}=this,{history:t}=e,n=t.document.draft;return!n||n.length<this.least?!1:(t.edit(s=>{let{kind:r,request:o}=s,{lines:a}=Ut[r];if(s.draft=null,r==="uniform_mesh"){let l=o.domain??={};!l.polygon&&!l.boundaries&&!l.bezier&&!l.nurbs?l.polygon=n:(l.polygon?l.holes??=[]:l.boundaries??=[]).push(n)}else(o[a[0]]??=[]).push(n)}),this.next=null,e.label(null),e.stage.canvas.style.cursor="",e.changed(!1),!0)}enter(e){let t=this.host.history.document.draft;if(!t)return null;let n=t.at(-1)??null,s=e.replace(/^@/,"").trim().split(/[\s,;]+/).map(Number);if(s.length>3||s.some(u=>!Number.isFinite(u))||e.trim()==="")return"Type a length, or x, y, z.";let{up:r}=this.host.frame,[o,a]=r===2?[0,1]:[0,2];if(s.length===1){if(!n)return"The first point needs x, y, z.";let u=this.next?.point??null,h=u?u.map((f,g)=>f-n[g]):[1,0,0],d=Math.hypot(...h);return d===0?"Point into a direction first.":(this.place({point:n.map((f,g)=>Xr(f+h[g]/d*s[0])),how:"",close:!1}),null)}let l=[0,0,0],c=e.trim().startsWith("@")?n??[0,0,0]:[0,0,0];return l[o]=c[o]+s[0],l[a]=c[a]+s[1],l[r]=s.length===3?c[r]+s[2]:e.trim().startsWith("@")?c[r]:this.level,r===1&&s.length===3&&l.splice(0,3,...c.map((u,h)=>u+s[h])),this.place({point:l,how:"",close:!1}),null}snap(e,t,n){let{stage:s,sketch:r,lines:o,frame:a,history:l}=this.host,c=l.document.draft??[],u=c.length>=this.least&&Ut[l.document.kind].line!=="rail"?c[0]:null;if(u){let M=s.project(a.toScene(u));if(Math.hypot(M.x-e,M.y-t)<ar.snap)return{point:u,how:"closes the loop",close:!0}}if(!n&&this.snapping){let M=r.refs.findIndex((x,p)=>{let S=s.project(r.places[p]);return x.line>=0&&S.visible&&Math.hypot(S.x-e,S.y-t)<ar.snap}),b=r.refs[M],w=b&&Gt(o[b.line].points[b.point]);if(w)return{point:w,how:"on a point",close:!1}}let h=[...a.origin];h[a.up]=this.level;let d=s.onPlane(e,t,new P(...a.toScene(h)),new P(0,1,0));if(!d)return null;let f=a.fromScene(d.toArray());f[a.up]=this.level;let g=a.length(s.pixelAt(d)),y=a.up===2?[0,1]:[0,2],m=10**Math.floor(Math.log10(g*1.5)),_=[1,2,5,10,20,50].map(M=>M*m).find(M=>M>=9*g)??m,v="";for(let M of y){let b=f[M],w=n||!this.snapping?void 0:[c.at(-1),c[0]].find(x=>x&&Math.abs(x[M]-b)<ar.align*g);if(w)f[M]=w[M],v="in line";else{let x=n||!this.snapping?m:_;f[M]=Xr(Math.round(b/x)*x)}}return{point:f,how:v,close:!1}}showNext(e,t){let{host:n}=this,{next:s}=this,{draft:r,request:o}=n.history.document;if(!s||!r){n.label(null);return}let a=r.at(-1),l=s.point.map(u=>At(u,6)).join(", "),c=a?Math.hypot(...s.point.map((u,h)=>u-a[h])):0;n.label([a?`${At(c,4)} ${Oi(o)}`:l,s.how].filter(Boolean).join(" · "),e,t)}hints(){let{sketch:e,stage:t,frame:n,history:s,lines:r}=this.host,o=Math.tan(t.camera.fov*Math.PI/360);e.setPixel(2*o/t.height,t.renderer?.getPixelRatio()??1);let a=[],l=[],c=null,{draft:u}=s.document;if(u&&this.next){let d=n.toScene(this.next.point);c=d,u.length>0&&a.push(n.toScene(u.at(-1)),d),u.length>1&&Ut[s.document.kind].line!=="rail"&&l.push(d,n.toScene(u[0]))}else this.ghost&&!this.busy&&(c=n.toScene(this.ghost.point));let h=this.arrow();if(h){let d=h.to.toArray(),f=new P(1,0,0).applyQuaternion(t.camera.quaternion),g=h.from.distanceTo(h.to),y=h.to.clone().addScaledVector(h.to.clone().sub(h.from),-.24);a.push(h.from.toArray(),d);for(let M of[-1,1])a.push(y.clone().addScaledVector(f,M*.14*g).toArray(),d);let{only:m}=this,_=Gt(r[m.line].points[m.point]),v=[...n.toScene(_)];v[1]=t.grid.mesh.position.y,(this.lifting||Math.abs(v[1]-h.from.y)>g*.3)&&l.push(h.from.toArray(),v)}e.hint({segments:a,faint:l,ghost:c})}key(e){let{stage:t,frame:n,lines:s}=this.host;if(e.ctrlKey||e.metaKey){if(e.key!=="a")return;this.select(s.flatMap((h,d)=>h.points.map((f,g)=>({line:d,point:g})))),e.preventDefault();return}let r=this.selection.length>0&&!this.drawing,o=n.up===2?[0,1]:[0,2],a=n.up===2?1:-1,l={ArrowLeft:[o[0],-1],ArrowRight:[o[0],1],ArrowUp:[o[1],a],ArrowDown:[o[1],-a],PageUp:[n.up,1],PageDown:[n.up,-1]},c={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},u=l[e.key];if(r&&u){let h=10**Math.round(Math.log10(n.length(t.pixelAt(t.centre))*10))*(e.shiftKey?10:1),d=[0,0,0];d[u[0]]=u[1]*h,this.moveBy(d)}else if(c[e.key]){let[h,d]=c[e.key];e.shiftKey?t.pan(-24*h,-24*d):t.orbit(.12*h,.12*d)}else if(r&&(e.key==="Delete"||e.key==="Backspace"))this.remove();else if(r&&(e.key==="Insert"||e.key==="Enter"))this.insert();else if(e.key==="]")this.step(1);else if(e.key==="[")this.step(-1);else if(e.key==="+"||e.key==="=")t.zoom(t.width/2,t.height/2,.85);else if(e.key==="-"&&!this.drawing)t.zoom(t.width/2,t.height/2,1/.85);else if(e.key==="Escape"&&r)this.select([]);else return;e.preventDefault()}},Xr=i=>Number(i.toPrecision(14));var jA=2e3,QA=1.2,Zy=450,eg=[.62,.5,.85],md="plateau.work",Zm="plateau.recent",Ds=document.documentElement.hasAttribute("data-embed"),tg={light:{sketch:{paper:"#ffffff",accent:"#0a6c7e",ink:"#1c2427",fault:"#c62f26",soft:"#6d7b81"},look:{membrane:"#f2eee6",ink:"#20292d",accent:"#b4561f"},grid:["#5b6b73",.42],shadow:.5},dark:{sketch:{paper:"#12181b",accent:"#56c4d4",ink:"#ffffff",fault:"#ff7a70",soft:"#8fa0a8"},look:{membrane:"#cbc7be",ink:"#0d1214",accent:"#ffb273"},grid:["#90a4ad",.3],shadow:.85}},gd={},ng=[],pd=[],ii=new yh({kind:"minimal_surface",request:Ld("minimal_surface"),draft:null,title:null}),et=()=>ii.document,Jt=null,cr=!1,Ns="plain",qr=null,Pi=null,lr=null,_d=0,ig=0,Os="model",Jy=0,Jm=null,Yr=new Set,xd=!1,sg={...tg.light.look},Ke=new hd(J("view"),()=>({top:64,right:34,left:34,bottom:Math.max(Ds?40:70,J("look").offsetHeight+34)})),ui=new sd(tg.light.sketch),fn=new oa(sg);Ke.model.add(fn.group,ui.group);var Mt={history:ii,stage:Ke,sketch:ui,surface:fn,lines:[],frame:new Qs([0,0,0],et().request),faulty:new Set,changed:i=>Us({dragging:i}),selectionChanged:()=>og(),label:bd,read:nR,announce:i=>{J("announcement").textContent=i},fixed:Ds},ht=new dd(Mt),av=new id(J("gizmo"),Ke,Mt.frame),jm=new ed,Qm=new Qh(Ke,sg,lR,i=>os(i));Ke.under=(i,e)=>fn.pick(Ke,i,e)?.point??null;Ke.content=()=>[...ui.places,...fn.outline()];Ke.onDraw=()=>{av.place(),dv()};Ke.onRest=()=>{Ke.rememberWhetherAllIsSeen(),ac()};J("no-webgl").hidden=Ke.renderer!==null;function rc({refit:i=!0,direction:e=void 0}={}){let{kind:t,request:n}=et(),s=document.querySelector(`#kinds input[value="${t}"]`);s&&(s.checked=!0),J("purpose").textContent=Ut[t].purpose,Mt.lines=yc(t,n),Mt.frame=new Qs(ux(Mt.lines,n),n),av.build(Mt.frame),fn.putInto(Mt.frame),ht.prune(),lv(),ma(),Ke.measure(),i&&Ke.fit(!1,e??eg),rg()}function lv(){let{kind:i,request:e}=et(),t=Tm(gd,Ut[i].path);t&&gy(J("options"),t,e,{openapi:gd,set:(n,s)=>{ii.edit(({request:o})=>{s===void 0?delete o[n]:o[n]=s})&&((n==="units"||n==="up")&&(ur(),rc()),Us({option:!0}))},describe:(n,s)=>{if(n!=="objective")return;let r=ng.find(o=>o.kind===i&&o.name===s);return r?`${yd(r.minimises)} [${r.unit.replaceAll("u",Oi(e))}]. ${r.source}.`:void 0}})}var yd=i=>i.charAt(0).toUpperCase()+i.slice(1);function ma(i=!1){let{draft:e}=et();ui.group.visible=!cr&&!Ds,fn.drawn=ui.group.visible,ui.show(cr?[]:Mt.lines,e,Mt.frame),i||(Mt.faulty=new Set([...Yr,...$p(Mt.lines).flatMap(({line:t,points:n})=>n.map(s=>`${t}/${s}`))]),Ke.rememberWhetherAllIsSeen()),ht.refresh()}function Us({dragging:i=!1,option:e=!1}={}){J("intro").hidden=!0,cr=!1,Yr=new Set,Mt.lines=yc(et().kind,et().request),ht.prune(),ma(i),i||(e||lv(),Ke.measure(),ac()),rg(i),J("live").checked&&xr(et().kind,et().request)&&et().draft===null&&(!i||ig<QA)&&pa()}function rg(i=!1){J("undo").disabled=!ii.canUndo,J("redo").disabled=!ii.canRedo,J("draw").setAttribute("aria-pressed",String(ht.drawing)),J("title").textContent=et().title??"",!i&&J("request-box").open&&cv(),og(),lg()}function cv(){J("request").value=Od(et().request),J("request-fault").hidden=!0}function vd(i){if(!i())return;let{kind:e}=et();Jt&&Jt.job.kind!==e&&ur(),rc({refit:!1}),Ke.rememberWhetherAllIsSeen(),Us()}function og(){let i=ht.drawing,{selection:e}=ht,t=!J("intro").hidden&&!i&&e.length===0;J("intro").hidden=!t,J("drawing").hidden=!i,J("point").hidden=i||e.length===0,J("hint").hidden=t||i||e.length>0,i?eR():e.length>0?hv():J("hint").textContent=uv()}function uv(){return cr?"The server keeps no drawing of this job: only its mesh is shown. Undo, or any edit, brings your drawing back.":Mt.lines.length===0?"Nothing is drawn yet. Press Draw, open a file, or drop one here.":xr(et().kind,et().request)?"Drag a point to move it, press on an edge to add one. Drag the ground to orbit, right-drag to pan, wheel to zoom.":`A strip needs two ${Ut[et().kind].line}s: press Draw for the next one.`}function eR(){let{kind:i,draft:e}=et(),{line:t,least:n}=Ut[i],s=i==="uniform_mesh"&&Mt.lines.length===0,r=e.length,o=s?"polygon":t;J("drawing-hint").textContent=r===0?`Click on the ground to begin the ${o}.`:r<n?`${Ps(r,"point")} of the ${o}: click to add more.`:i==="ruled_surface"?`${Ps(r,"point")}: click to add more, Enter ends the rail.`:`${Ps(r,"point")}: click the first point, or press Enter, to close the ${o}.`,J("finish").disabled=r<n,J("level-name").textContent=`at ${"xyz"[Mt.frame.up]}`,document.activeElement!==J("level")&&(J("level").value=String(ht.level))}function hv(){let{selection:i}=ht,{only:e}=ht,t=e&&Mt.lines[e.line];J("point-name").textContent=t?`${yd(t.name)}, ${e.point+1} of ${t.points.length}`:Ps(i.length,"point");for(let s of document.querySelectorAll("#point [data-axis]")){let r=new Set(i.map(a=>{let l=Mt.lines[a.line]?.points[a.point];return Array.isArray(l)?l[Number(s.dataset.axis)]:void 0})),[o]=r;document.activeElement===s&&s.dataset.dirty||(s.value=r.size===1&&o!==void 0&&o!==null?String(o):"",s.placeholder=r.size===1?"none":"various")}let n=ht.edgeBefore();J("edge-field").hidden=!n,n&&document.activeElement!==J("edge")&&(J("edge").value=String(Number(n.length.toPrecision(7)))),J("insert-point").disabled=!e}function tR(i){let e=i.replace(/,/g,".").replace(/−/g,"-").match(/[+-]?\s*\d*\.?\d+(?:e[+-]?\d+)?/gi);return!e||e.join("").replace(/\s/g,"")!==i.replace(/,/g,".").replace(/−/g,"-").replace(/\s/g,"")?NaN:Number(e.reduce((t,n)=>t+Number(n.replace(/\s/g,"")),0).toPrecision(15))}var ic=null;function bd(i,e=0,t=0,n=null){ic=i===null?null:{text:i,x:e,y:t,anchor:n},dv()}function dv(){let i=J("label");if(i.hidden=ic===null,!ic)return;let{text:e,anchor:t}=ic,{x:n,y:s}=t?Ke.project(t):ic;i.textContent=e;let r=Math.min(Math.max(n+14,6),Ke.width-i.offsetWidth-6),o=Math.min(Math.max(s-30,6),Ke.height-30);i.style.transform=`translate(${Math.round(r)}px, ${Math.round(o)}px)`}function nR(i,e,t,n){let s=fn.valueAt(i,e),r=Mt.frame.fromScene(i.toArray()).map(o=>At(o,5)).join(", ");bd(qr&&s!==null?hy(qr,s):r,t,n,i.toArray())}var qm=0,fd=0;async function ag(i){qm+=1,document.body.setAttribute("aria-busy","true");try{return await i()}finally{qm-=1,document.body.setAttribute("aria-busy",String(qm>0))}}var Sd=(i,e,t=os)=>ag(async()=>{fd+=1;let n=fd;try{let s=await i();n===fd&&e(s)}catch(s){n===fd&&t(s)}}),yi=i=>{J("status").textContent=i},pa=()=>pv(({kind:i,request:e})=>pc(Ut[i].path,JSON.parse(e))),fv=i=>pv(()=>Promise.resolve(i));async function pv(i){if(lr=i,Pi){(Pi.generation!==_d||performance.now()-Pi.since>jA)&&gv();return}await ag(async()=>{for(jy(!0);lr;){let e=lr;lr=null;let{kind:t,request:n,title:s}=et();Pi={job:null,since:performance.now(),cancelled:!1,dragging:iR(),request:JSON.stringify(n),kind:t,title:s,generation:_d};try{await sR(Pi,e)}catch(r){lr||(os(r),yi("Not solved."))}finally{Pi=null}}jy(!1),lg()})}var iR=()=>document.querySelector("canvas:active")!==null;async function sR(i,e){if(i.dragging||yi("Solving…"),i.job=await e(i),yv(),i.cancelled&&(i.job=await Rd(i.job)),!Kr(i.job)){Jm=i.job.id,ac();let n=[],s=Date.now(),r=window.setInterval(()=>Ym(null,n,s),500);Ym(null,n,s,i.job.status==="queued"?"Waiting in the queue":"Running");try{i.job=await mc(i.job,o=>{let a=n.at(-1);(!a||a.iteration!==o.iteration||a.phase!==o.phase)&&n.push({iteration:o.iteration,phase:o.phase,value:o.objective_value??null,residual:o.residual??null}),Ym(o,n,s)})}finally{clearInterval(r),J("running-charts").replaceChildren()}}Jm=null;let{job:t}=i;if(t.status==="failed"){if(lr)return;os(t.error??{}),yi("Not solved.")}else if(t.status==="cancelled")lr||yi("Cancelled.");else{let n=await Fl(await _a(`${t.links.mesh}?format=glb`));if(i.generation!==_d||cr)return;let s=Jt?.dragging&&Jt.job.id!==t.id?Jt.job:null;ig=(performance.now()-i.since)/1e3,_v(t,n,i.request,i.dragging),s&&Rg(s).catch(()=>{}),i.dragging||hR(t,i)}ac()}function jy(i){J("cancel").hidden=!i;let e=J("progress");clearTimeout(Qy),i?Qy=window.setTimeout(()=>{e.hidden=!1},300):e.hidden=!0,i&&e.removeAttribute("value")}var Qy=0;function Ym(i,e,t,n){let s=Kp((Date.now()-t)/1e3),r=e.at(-1);i&&(J("progress").value=i.fraction,J("running-charts").replaceChildren(...Zp(e,et().kind==="minimal_surface"?"Area":"Objective",mv(et().request))));let o=J("progress").position,a=[o>0&&`${Math.round(o*100)} %`,n??(r?px(r.phase):"Running"),r&&r.iteration>0&&`iteration ${At(r.iteration)}`,s];yi(a.filter(Boolean).join(" · "))}var mv=i=>typeof i.tolerance=="number"?i.tolerance:et().kind==="minimal_surface"?1e-6:null;async function gv(){if(Pi&&(Pi.cancelled=!0,!!Pi.job))try{await Rd(Pi.job)}catch(i){os(i)}}function ur(){Jt=null,qr=null,fn.show(null,"",Mt.frame),J("result").hidden=!0,J("nothing").hidden=!1,J("look").hidden=!0,J("modes").hidden=!0,Im(null),wd("model")}function _v(i,e,t,n=!1){let s=Jt===null||Jt.job.kind!==i.kind,r=JSON.parse(t);Jt={job:i,mesh:e,solved:t,request:r,dragging:n},bd(null),fn.show(e,i.kind,Mt.frame),xv(e,i.kind,r),Ke.measure(),Ke.rememberWhetherAllIsSeen(),s&&!xd&&Ke.fit(!1),xd=!1,oR(),J("nothing").hidden=!0,J("result").hidden=!1,J("look").hidden=!1,J("job-id").textContent=i.id;let o=Oi(r),a=i.statistics;J("figures").replaceChildren(...My(i,o)),J("warnings").replaceChildren(...Ay(i.warnings)),J("statistics").replaceChildren(...wy(a)),J("charts").replaceChildren(...Zp(Ry(a.history),"Area",mv(r))),ev(J("downloads"),["glb","gltf","obj","ply","stl"],i,i.links.mesh);let l=!!(i.links.pattern&&a.flat_pattern);J("pattern-box").hidden=!l,l&&ev(J("pattern-downloads"),["svg","dxf"],i,i.links.pattern),J("modes").hidden=i.kind!=="ruled_surface",document.querySelector('[data-mode="flat"]').hidden=!l,Os==="flat"&&(l?jm.show(i).catch(os):wd("model")),rR(i,e),lg()}function rR(i,e){let t=(Date.parse(i.finished_at??"")-Date.parse(i.started_at??""))/1e3,n=t>0?`Solved in ${Kp(t)}`:"Solved",{converged:s}=i.statistics;yi(`${n}: ${Ps(e.geometry.index.count/3,"triangle")}.${s===!1?" Not converged.":""}`)}function ev(i,e,t,n){i.replaceChildren(...e.map(s=>ie("button",{type:"button",onclick:async()=>{try{gc(await fc(`${n}?format=${s}`),`${t.kind.replaceAll("_","-")}-${t.id}.${s}`)}catch(r){os(r)}}},s.toUpperCase())))}var Md=()=>Jt!==null&&!cr&&(Jt.solved!==JSON.stringify(et().request)||Jt.job.kind!==et().kind);function lg(){let i=Md();for(let t of document.querySelectorAll("#downloads button, #pattern-downloads button"))t.disabled=i;clearTimeout(Jy);let e=()=>{J("result").classList.toggle("stale",i),J("stale").hidden=!i,fn.setStale(i),Ke.invalidate()};i&&Pi&&ig*1e3<Zy?Jy=window.setTimeout(e,Zy):e()}function xv(i,e,t){let n=cy(i,e),s=J("quantity");n.some(({id:r})=>r===Ns)||(Ns="plain"),s.replaceChildren(...n.map(({id:r,label:o})=>ie("option",{value:r},o))),s.value=Ns,qr=uy(i,Ns,Oi(t),xa(t)),fn.colourBy(qr),Im(qr)}function oR(){let i={surface:"Surface",edges:"Mesh",lines:"Lines"};J("layers").replaceChildren(...Object.keys(i).map(e=>{let t=ie("button",{type:"button","aria-pressed":String(fn.layers[e])},i[e]);return t.addEventListener("click",()=>{fn.setLayers({[e]:!fn.layers[e]}),t.setAttribute("aria-pressed",String(fn.layers[e])),Ke.measure()}),t}),aR())}function aR(){let i=ie("button",{type:"button","aria-pressed":String(ui.group.visible)},"Drawing");return i.addEventListener("click",()=>{ui.group.visible=!ui.group.visible,fn.drawn=ui.group.visible,fn.restyle(),i.setAttribute("aria-pressed",String(ui.group.visible)),Ke.invalidate()}),i}function wd(i){if(!(i===Os&&i!=="compare")){Os=i;for(let e of document.querySelectorAll("[data-mode]"))e.setAttribute("aria-pressed",String(e.dataset.mode===Os));if(J("corner").hidden=Os!=="model",Os!=="compare"&&Qm.close(),Os!=="flat"&&jm.hide(),Os==="compare"){let e=ng.filter(t=>t.kind==="ruled_surface").map(t=>t.name);Qm.open(et().request,Mt.frame,e)}Os==="flat"&&Jt&&jm.show(Jt.job).catch(os),Ke.invalidate()}}function lR(i){wd("model"),ii.edit(({request:t})=>{t.objective=i,i!=="maximal_convexity"&&delete t.secondary_objective})&&Us(),J("live").checked||pa()}function yv(){J("problem").hidden=!0,Yr.size!==0&&(Yr=new Set,ma())}function os(i){let{title:e,detail:t,message:n,errors:s,omitted:r}=i,o=s??[];Yr=new Set;let a=o.map(u=>{let h=Id(Mt.lines,u.pointer);h.line!==void 0&&h.point!==void 0&&h.point>=0&&Yr.add(`${h.line}/${h.point}`);let d=h.line===void 0?J("options").querySelector(`[name="${CSS.escape(h.field??"")}"], [name^="${CSS.escape(h.field??"")}."]`):null;return tv(yd(h.text),hx(u.detail),h,d)});if(!o.some(u=>Id(Mt.lines,u.pointer).point!==void 0))for(let{line:u,points:h,text:d}of $p(Mt.lines))h.forEach(f=>Yr.add(`${u}/${f}`)),a.push(tv("",d,{line:u,point:h[0]},null));r&&a.push(ie("li",{},"and more"));let l=t??n??"",c=o.length>0&&(/^see errors/.test(l)||o.some(u=>l.includes(u.detail)));J("problem").replaceChildren(ie("strong",{},e??"Something went wrong"),c||l===e?"":Bl(yd(l)),a.length>0&&ie("ul",{},...a)||""),J("problem").hidden=!1,ma()}function tv(i,e,t,n){let s=[i&&ie("b",{},i),i?` ${e}`:e];if(t.line===void 0&&!n)return ie("li",{},...s);let r=ie("button",{type:"button"},...s);return r.addEventListener("click",()=>{n?(n.closest("details")?.setAttribute("open",""),n.focus()):ht.select([{line:t.line,point:Math.max(t.point??0,0)}])}),n&&n.setAttribute("aria-invalid","true"),ie("li",{},r)}var nv=0;function oc(i){J("toast").textContent=i,J("toast").hidden=!1,clearTimeout(nv),nv=window.setTimeout(()=>{J("toast").hidden=!0},7e3)}function $r(i,e,t,{direction:n=void 0}={}){cr=!1,xd=!1,_d+=1;let s=Jt?.job.kind===i;ii.edit(r=>Object.assign(r,{kind:i,request:e,title:t,draft:null})),ht.selection=[],(!s||!xr(i,e))&&ur(),yv(),rc(n?{direction:n}:{})}var cg=i=>Sd(()=>Ii(`/v1/examples/${encodeURIComponent(i)}`),e=>{let{kind:t,...n}=e.request;ur(),$r(e.kind,n,e.title),Us(),J("live").checked||yi("Ready.")});function ug(i){ur(),$r(i,Ld(i),null),yi(""),ht.startDrawing()}function cR(i,e,t,n){let{kind:s,request:r}=et(),{line:o,least:a}=Ut[s],l=t?1/xa(r):1,c=i.map(({points:d})=>d.map(([f,g,y])=>{let m=t&&r.up!=="y"?[f,-y,g]:[f,g,y];return t?m.map(_=>Number((_*l).toPrecision(9))):m})),u=c.findIndex(d=>d.length<(s==="ruled_surface"?1:a));if(u>=0)throw new _t(`Line ${u+1} of the file has ${Ps(c[u].length,"point")}; a ${o} needs ${a}.`);let h={...structuredClone(r)};for(let d of["normals","tangents","constraints"])delete h[d];if(typeof h.initial_mesh=="object"&&delete h.initial_mesh,s==="ruled_surface")Object.assign(h,{directrices:c,closed:i.length>1&&i.every(({closed:d})=>d)});else if(s==="minimal_surface")h.boundaries=c;else{let d=[...c].sort((f,g)=>iv(g)-iv(f));h.domain={polygon:d[0],...d.length>1&&{holes:d.slice(1)}}}$r(s,h,n||`${e} drawing`),Us(),oc(`${e}: ${Ps(c.length,"line")}, ${Ps(c.reduce((d,f)=>d+f.length,0),"point")}. Undo brings back what was there.`)}var iv=i=>{let e=[0,1,2].map(t=>Math.max(...i.map(n=>n[t]))-Math.min(...i.map(n=>n[t])));return Math.hypot(...e)},sc=(i,e)=>Sd(i,t=>{"lines"in t?cR(t.lines,t.format,t.metres,e):vv(t.request,e)},t=>os({title:e?`${e} cannot be opened`:"This cannot be opened",detail:t instanceof Error?t.message:String(t)}));function vv(i,e){let{kind:t,...n}=i,s=ya(i)??et().kind;if(t!==void 0&&!(String(t)in Ut))throw new _t(`This server has no kind ${JSON.stringify(t)}.`);$r(s,n,e),Us()}function uR(){let i=e=>{J("request-fault").textContent=e,J("request-fault").hidden=!1};J("request-fault").hidden=!0;try{let e=Yp(J("request").value);if(e===null||typeof e!="object"||Array.isArray(e)){i("A request is an object, { … }.");return}vv(e.kind!==void 0||ya(e)?e:{...e,kind:et().kind},et().title)}catch(e){i(e instanceof Error?e.message:String(e))}}var sv=0;function ac(){Ds||!lc||(clearTimeout(sv),sv=window.setTimeout(bv,250))}function bv(){if(Ds||!lc)return;let{kind:i,request:e,draft:t,title:n}=et(),s=JSON.stringify({kind:i,request:e,draft:t,title:n,camera:hg(),colour:Ns,job:Jm??(Md()?null:Jt?.job.id??null)});try{sessionStorage.setItem(md,s),localStorage.setItem(md,s)}catch{rv||oc("This drawing is too large to be kept by the browser: save it as a file."),rv=!0}}var rv=!1,lc=!1;function hg(){let{eye:i,target:e}=Ke.pose(),t=new Qs([0,0,0],et().request).toScene(Mt.frame.origin);return{eye:i.map((n,s)=>n+t[s]),target:e.map((n,s)=>n+t[s])}}function Sv({eye:i,target:e}){xd=!0;let t=new Qs([0,0,0],et().request).toScene(Mt.frame.origin);Ke.place({eye:i.map((n,s)=>n-t[s]),target:e.map((n,s)=>n-t[s])},!1),Ke.rememberWhetherAllIsSeen()}function Mv(){try{return JSON.parse(localStorage.getItem(Zm)??"[]")}catch{return[]}}function hR(i,{request:e,title:t}){if(Ds||e.length>2e5)return;let n=[{id:i.id,title:t,kind:i.kind,request:e},...Mv().filter(s=>s.id!==i.id)].slice(0,20);try{localStorage.setItem(Zm,JSON.stringify(n))}catch{localStorage.removeItem(Zm)}}async function dR(){let i=J("recent-list");i.replaceChildren(ie("p",{className:"quiet"},"Asking the server…")),J("recent").showModal();try{let{jobs:e}=await Ii("/v1/jobs?limit=30"),t=new Map(Mv().map(s=>[s.id,s])),n=e.map(s=>{let r=t.get(s.id),o=ie("button",{type:"button",disabled:!["succeeded","running","queued"].includes(s.status)},"Open");return o.setAttribute("aria-label",`Open ${r?.title??s.kind} of ${s.created_at}`),o.addEventListener("click",()=>{J("recent").close(),fR(s,r)}),ie("tr",{},ie("th",{scope:"row"},r?.title??Ut[s.kind].label),ie("td",{},s.status),ie("td",{},new Date(s.created_at).toLocaleString()),ie("td",{},o))});i.replaceChildren(n.length>0?ie("table",{className:"plain"},ie("tbody",{},...n)):ie("p",{className:"quiet"},"No jobs yet."))}catch(e){i.replaceChildren(ie("p",{className:"fault"},e instanceof Error?e.message:String(e)))}}var fR=(i,e)=>Sd(async()=>{let t=await Ii(i.links.self),n=e||t.status!=="succeeded"?null:await Fl(await _a(`${t.links.mesh}?format=glb`));return{job:t,mesh:n}},({job:t,mesh:n})=>{e?(ur(),$r(e.kind,JSON.parse(e.request),e.title),fv(t)):n?pR(t,n):yi("This job has no result yet, and this browser does not know its drawing.")});function pR(i,e){cr=!0,ur();let{unit:t,up:n}=e.extras,s={units:t,up:n},[r,o,a]=e.extras.origin??[0,0,0];Mt.frame=new Qs([r,o,a],s),ma(),_v(i,e,JSON.stringify(s)),Ke.fit(!1,eg),rg()}var mR=["Link","Embed","curl","Python","TypeScript"],$m=0;async function wv(i){$m+=1;let e=$m,{kind:t,request:n,title:s}=et(),r={kind:t,request:n,title:s,camera:hg(),colour:Ns},o=i==="Link"?await Oy(r):i==="Embed"?await Ny(r):i==="curl"?Dy(t,n):i==="Python"?Uy(t,n):Fy(t,n);e===$m&&(J("share-forms").replaceChildren(...mR.map(a=>ie("button",{type:"button","aria-pressed":String(a===i),onclick:()=>{wv(a)}},a))),J("share-text").value=o,J("copied").textContent="")}function gR(){let i=Object.keys(Ut).filter(t=>Tm(gd,Ut[t].path)),e=J("kinds").querySelector("legend");J("kinds").replaceChildren(e,...i.map(t=>{let n=ie("input",{type:"radio",name:"kind",value:t});return n.addEventListener("change",()=>_R(t)),ie("label",{},n,Ut[t].label)})),J("blank-starts").replaceChildren(...i.map(t=>ie("button",{type:"button",onclick:()=>{J("gallery").close(),ug(t)}},`Draw a ${Ut[t].label.toLowerCase()}`)))}var ov=new Map;function _R(i){let e=et();if(e.kind===i)return;ov.set(e.kind,{request:structuredClone(e.request),title:e.title});let t=ov.get(i),n=pd.find(s=>s.kind===i);t?($r(i,t.request,t.title),Us()):n?cg(xR[i]??n.name):ug(i)}var xR={ruled_surface:"wavy-strip",uniform_mesh:"vault"};function Ev(i){document.documentElement.dataset.theme=i,J("theme").setAttribute("aria-pressed",String(i==="dark"));let e=tg[i];Object.assign(sg,e.look),ui.restyle(e.sketch),Ke.grid.style(...e.grid),Ke.shadow.style(e.shadow),fn.restyle(),Qm.restyle(),ma(),Ke.invalidate()}function yR(){let i=(s,r,o)=>J(s).addEventListener(r,a=>{o(a)});i("solve","click",()=>xr(et().kind,et().request)?pa():yi(uv())),i("cancel","click",()=>(lr=null,gv())),i("live","change",()=>J("live").checked&&Md()&&pa()),i("draw","click",()=>ht.drawing?ht.stopDrawing():ht.startDrawing()),i("undo","click",()=>vd(()=>ii.undo())),i("redo","click",()=>vd(()=>ii.redo())),i("finish","click",()=>ht.finishDrawing()),i("give-up","click",()=>ht.stopDrawing()),i("snap","change",()=>{ht.snapping=J("snap").checked}),i("level","change",()=>{ht.level=J("level").valueAsNumber||0}),i("previous-point","click",()=>ht.step(-1)),i("next-point","click",()=>ht.step(1)),i("insert-point","click",()=>ht.insert()),i("delete-point","click",()=>ht.remove()),i("remove-line","click",()=>ht.removeLine());for(let s of["point","options","key-form","drawing"])i(s,"submit",r=>r.preventDefault());for(let s of document.querySelectorAll("#point input"))s.addEventListener("input",()=>{s.dataset.dirty="1"}),s.addEventListener("blur",()=>{delete s.dataset.dirty}),s.addEventListener("change",()=>{delete s.dataset.dirty;let r=tR(s.value);Number.isFinite(r)?s.id==="edge"?ht.setEdgeBefore(r):ht.setAxis(Number(s.dataset.axis),r):(s.value.trim()!==""&&oc(`${JSON.stringify(s.value)} is not a number.`),hv())});J("entry").addEventListener("keydown",s=>{if(s.key!=="Enter")return;s.preventDefault(),s.stopPropagation();let r=J("entry");if(r.value.trim()===""){ht.finishDrawing();return}let o=ht.enter(r.value);o?oc(o):r.value=""});for(let s of document.querySelectorAll("[data-view]"))s.addEventListener("click",()=>{let o={top:[0,1,.001],front:[0,.02,1],side:[1,.02,0]}[s.dataset.view];o?Ke.look(o):Ke.fit(!0)});for(let s of document.querySelectorAll("[data-mode]"))s.addEventListener("click",()=>wd(s.dataset.mode));for(let s of document.querySelectorAll("[data-panel]"))s.addEventListener("click",()=>Tv(s.dataset.panel));i("quantity","change",()=>{Ns=J("quantity").value,bd(null),Jt&&xv(Jt.mesh,Jt.job.kind,Jt.request),Ke.invalidate(),ac()}),i("request-box","toggle",()=>{J("request-box").open&&cv()}),i("apply-request","click",uR),i("save-request","click",()=>gc(new Blob([Od({kind:et().kind,...et().request})],{type:"application/json"}),`${et().kind.replaceAll("_","-")}.json`));let e=J("file");e.accept=ax,i("open-file","click",()=>e.click()),i("file","change",async()=>{let[s]=e.files??[];s&&await sc(()=>_h(s),s.name),e.value=""}),vR();let t=J("gallery"),n=()=>t.showModal();i("open-gallery","click",n),i("intro-gallery","click",n),i("intro-draw","click",()=>ug("minimal_surface")),i("open-recent","click",dR),i("open-share","click",async()=>{await wv("Link"),J("share").showModal()}),i("open-settings","click",()=>J("settings").showModal()),i("copy","click",async()=>{try{await navigator.clipboard.writeText(J("share-text").value),J("copied").textContent="Copied."}catch{J("share-text").select(),J("copied").textContent="Press Ctrl C: the browser does not let this page copy."}}),i("picture","click",async()=>{gc(await Ke.picture(2,document.documentElement.dataset.theme==="dark"?"#1a2023":"#f3f4f3"),"plateau.png")});for(let s of document.querySelectorAll("dialog"))s.querySelector("[data-close]").addEventListener("click",()=>s.close()),s.addEventListener("click",r=>{r.target===s&&s.close()});i("theme","click",()=>{let s=document.documentElement.dataset.theme==="dark"?"light":"dark";Ev(s),localStorage.setItem("theme",s)}),i("api-key","change",()=>{let{value:s}=J("api-key");Ad(s),s?sessionStorage.setItem("api-key",s):sessionStorage.removeItem("api-key"),J("settings").close(),lc||Rv()}),document.addEventListener("keydown",bR),window.addEventListener("pagehide",bv),window.addEventListener("hashchange",()=>{location.hash.startsWith("#s=")&&lc&&Sd(Av,s=>{s&&MR(s)})})}function Tv(i){document.querySelector("main").dataset.panel=i;for(let e of document.querySelectorAll("[data-panel]:is(button)"))e.setAttribute("aria-pressed",String(e.dataset.panel===i))}function vR(){document.addEventListener("dragover",i=>{i.preventDefault(),document.body.classList.add("dropping")}),document.addEventListener("dragleave",i=>{i.relatedTarget||document.body.classList.remove("dropping")}),document.addEventListener("drop",i=>{i.preventDefault(),document.body.classList.remove("dropping");let[e]=i.dataTransfer?.files??[],t=i.dataTransfer?.getData("text/plain")??"";e?sc(()=>_h(e),e.name):t&&sc(()=>xh(t),"")}),document.addEventListener("paste",i=>{if(i.target.matches("input, textarea"))return;let[e]=i.clipboardData?.files??[],t=i.clipboardData?.getData("text/plain")??"";if(e)sc(()=>_h(e),e.name);else if(t.trim()!=="")sc(()=>xh(t),"");else return;i.preventDefault()})}function bR(i){let e=i.target,t=e.matches('input:not([type="radio"], [type="checkbox"]), textarea, select')||document.querySelector("dialog[open]")!==null,n=i.ctrlKey||i.metaKey,s=i.key.toLowerCase();if(n&&!t&&s==="z")vd(()=>i.shiftKey?ii.redo():ii.undo());else if(n&&!t&&s==="y")vd(()=>ii.redo());else if(ht.drawing&&i.key==="Enter"&&!e.matches("button, summary, a"))ht.finishDrawing();else if(ht.drawing&&i.key==="Escape")ht.stopDrawing();else if(ht.drawing&&!t&&!n&&/^[\d.,@-]$/.test(i.key)){let r=J("entry");r.focus(),r.value+=i.key}else return;i.preventDefault()}async function Av(){let[,i]=/^#s=(.+)$/.exec(location.hash)??[];if(!i)return null;try{let e=await Iy(i);if(Ds||window.history.replaceState(null,"",location.pathname+location.search),e.kind in Ut&&e.request!==null&&typeof e.request=="object")return e}catch{}return oc("This link is damaged: it does not hold a request."),null}async function SR(){let i=await Av();if(i)return i;if(new URLSearchParams(location.search).has("example")||Ds)return null;try{let e=JSON.parse(sessionStorage.getItem(md)??localStorage.getItem(md)??"null");return e&&e.kind in Ut?e:null}catch{return null}}function MR({kind:i,request:e,title:t,camera:n,colour:s}){ur(),Ns=s??"plain",$r(i,e,t??null),n&&Sv(n),Us(),xr(i,e)||yi("")}var wR={kind:"minimal_surface",title:"A saddle canopy",request:{boundaries:[Array.from({length:24},(i,e)=>{let t=e*Math.PI/12;return[7*Math.cos(t),5.5*Math.sin(t),2.6+2*Math.cos(2*t)].map(n=>Number(n.toFixed(3)))})],objective:"minimal_area",resolution:{triangles:2e3}}},Rv=()=>ag(async()=>{J("problem").hidden=!0;try{let[i,{objectives:e},{examples:t},n]=await Promise.all([Ii("/openapi.json"),Ii("/v1/objectives"),Ii("/v1/examples"),SR()]);if([gd,ng,pd]=[i,e,t],gR(),J("gallery-list").replaceChildren(...yy(pd,({name:s})=>{J("gallery").close(),cg(s)})),lc=!0,n){Object.assign(ii.document,{kind:n.kind,request:n.request,draft:n.draft??null,title:n.title??null}),Ns=n.colour??"plain",rc(),n.camera&&Sv(n.camera);let s=n.job?await Ii(`/v1/jobs/${n.job}`).catch(()=>null):null;s&&s.status!=="cancelled"&&s.status!=="failed"?await fv(s):xr(n.kind,n.request)&&et().draft===null&&await pa()}else{let s=new URLSearchParams(location.search).get("example"),r=pd.find(c=>c.name===s),o=r?await Ii(`/v1/examples/${encodeURIComponent(r.name)}`):wR,{kind:a,...l}=o.request;Object.assign(ii.document,{kind:o.kind,request:l,title:o.title}),rc({direction:eg}),J("intro").hidden=r!==void 0,og(),await pa()}}catch(i){os(i),yi("Not ready."),i instanceof ls&&i.status===401&&J("settings").showModal()}});yR();Ds&&new URLSearchParams(location.search).get("ground")==="none"&&(Ke.grid.mesh.visible=!1);Ev(localStorage.getItem("theme")??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light"));Tv("setup");J("look").hidden=!0;var Km=sessionStorage.getItem("api-key");Km&&(J("api-key").value=Km,Ad(Km));Rv();Object.assign(window,{studio:{request:()=>structuredClone(et().request),kind:()=>et().kind,draft:()=>structuredClone(et().draft),pose:()=>hg(),frames:()=>Ke.frames,project:i=>Ke.project(Mt.frame.toScene(i)),lines:()=>Mt.lines,faulty:()=>[...Mt.faulty],selection:()=>ht.selection,points:()=>ui.places.map(i=>Ke.project(i)),shown:()=>Jt?{job:Jt.job.id,solved:Jt.solved,stale:Md()}:null,draw:()=>Ke.draw(),fit:()=>Ke.fit(!1),openExample:cg,covers:(i,e)=>fn.pick(Ke,i,e)!==null,corners:()=>Mt.lines.flatMap(i=>i.points.map(Gt)),quantity:()=>qr,humanise:jt}});
