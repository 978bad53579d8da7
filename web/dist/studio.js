var eb=Object.create;var Fg=Object.defineProperty;var tb=Object.getOwnPropertyDescriptor;var nb=Object.getOwnPropertyNames;var ib=Object.getPrototypeOf,sb=Object.prototype.hasOwnProperty;var kg=(i,e)=>()=>{try{return e||i((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var rb=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of nb(e))!sb.call(i,s)&&s!==t&&Fg(i,s,{get:()=>e[s],enumerable:!(n=tb(e,s))||n.enumerable});return i};var Bg=(i,e,t)=>(t=i!=null?eb(ib(i)):{},rb(e||!i||!i.__esModule?Fg(t,"default",{value:i,enumerable:!0}):t,i));var hv=kg((dg,fg)=>{((i,e)=>{typeof define=="function"&&define.amd?define([],e):typeof fg=="object"&&typeof dg<"u"?fg.exports=e():i.Papa=e()})(dg,function i(){var e=typeof self<"u"?self:typeof window<"u"?window:e!==void 0?e:{},t=!e.document&&!!e.postMessage,n=e.IS_PAPA_WORKER||!1,s={},r=0,o={};function a(x){return x.charCodeAt(0)===65279?x.slice(1):x}function l(x){this._handle=null,this._finished=!1,this._completed=!1,this._halted=!1,this._input=null,this._baseIndex=0,this._partialLine="",this._rowCount=0,this._start=0,this._nextChunk=null,this.isFirstChunk=!0,this._completeResults={data:[],errors:[],meta:{}},function(p){var S=M(p);S.chunkSize=parseInt(S.chunkSize),p.step||p.chunk||(S.chunkSize=null),this._handle=new f(S),(this._handle.streamer=this)._config=S}.call(this,x),this.parseChunk=function(p,S){var A=parseInt(this._config.skipFirstNLines)||0;if(this.isFirstChunk&&0<A){let C=this._config.newline;C||(E=this._config.quoteChar||'"',C=this._handle.guessLineEndings(p,E)),p=[...p.split(C).slice(A)].join(C)}this.isFirstChunk&&w(this._config.beforeFirstChunk)&&(E=this._config.beforeFirstChunk(p))!==void 0&&(p=E),this.isFirstChunk=!1,this._halted=!1;var A=this._partialLine+p,E=(this._partialLine="",this._handle.parse(A,this._baseIndex,!this._finished));if(!this._handle.paused()&&!this._handle.aborted()){if(p=E.meta.cursor,A=(this._finished||(this._partialLine=A.substring(p-this._baseIndex),this._baseIndex=p),E&&E.data&&(this._rowCount+=E.data.length),this._finished||this._config.preview&&this._rowCount>=this._config.preview),n)e.postMessage({results:E,workerId:o.WORKER_ID,finished:A});else if(w(this._config.chunk)&&!S){if(this._config.chunk(E,this._handle),this._handle.paused()||this._handle.aborted())return void(this._halted=!0);this._completeResults=E=void 0}return this._config.step||this._config.chunk||(this._completeResults.data=this._completeResults.data.concat(E.data),this._completeResults.errors=this._completeResults.errors.concat(E.errors),this._completeResults.meta=E.meta),this._completed||!A||!w(this._config.complete)||E&&E.meta.aborted||(this._config.complete(this._completeResults,this._input),this._completed=!0),A||E&&E.meta.paused||this._nextChunk(),E}this._halted=!0},this._sendError=function(p){w(this._config.error)?this._config.error(p):n&&this._config.error&&e.postMessage({workerId:o.WORKER_ID,error:p,finished:!1})}}function c(x){var p;(x=x||{}).chunkSize||(x.chunkSize=o.RemoteChunkSize),l.call(this,x),this._nextChunk=t?function(){this._readChunk(),this._chunkLoaded()}:function(){this._readChunk()},this.stream=function(S){this._input=S,this._nextChunk()},this._readChunk=function(){if(this._finished)this._chunkLoaded();else{if(p=new XMLHttpRequest,this._config.withCredentials&&(p.withCredentials=this._config.withCredentials),t||(p.onload=b(this._chunkLoaded,this),p.onerror=b(this._chunkError,this)),p.ontimeout=b(this._chunkTimeout,this),p.open(this._config.downloadRequestBody?"POST":"GET",this._input,!t),this._config.downloadTimeout&&!t&&(p.timeout=this._config.downloadTimeout),this._config.downloadRequestHeaders){var S,A=this._config.downloadRequestHeaders;for(S in A)p.setRequestHeader(S,A[S])}var E;this._config.chunkSize&&(E=this._start+this._config.chunkSize-1,p.setRequestHeader("Range","bytes="+this._start+"-"+E));try{p.send(this._config.downloadRequestBody)}catch(C){this._chunkError(C.message)}t&&p.status===0&&this._chunkError()}},this._chunkLoaded=function(){p.readyState===4&&(p.status<200||400<=p.status?this._chunkError():(this._start+=this._config.chunkSize||p.responseText.length,this._finished=!this._config.chunkSize||this._start>=(S=>(S=S.getResponseHeader("Content-Range"))!==null?parseInt(S.substring(S.lastIndexOf("/")+1)):-1)(p),this.parseChunk(p.responseText)))},this._chunkError=function(S){S=p.statusText||S,this._sendError(new Error(S))},this._chunkTimeout=function(){this._chunkError("Request timed out after "+this._config.downloadTimeout+"ms")}}function u(x){(x=x||{}).chunkSize||(x.chunkSize=o.LocalChunkSize),l.call(this,x);var p,S,A=typeof FileReader<"u";this.stream=function(E){this._input=E,S=E.slice||E.webkitSlice||E.mozSlice,A?((p=new FileReader).onload=b(this._chunkLoaded,this),p.onerror=b(this._chunkError,this)):p=new FileReaderSync,this._nextChunk()},this._nextChunk=function(){this._finished||this._config.preview&&!(this._rowCount<this._config.preview)||this._readChunk()},this._readChunk=function(){var E=this._input,C=(this._config.chunkSize&&(C=Math.min(this._start+this._config.chunkSize,this._input.size),E=S.call(E,this._start,C)),p.readAsText(E,this._config.encoding));A||this._chunkLoaded({target:{result:C}})},this._chunkLoaded=function(E){this._start+=this._config.chunkSize,this._finished=!this._config.chunkSize||this._start>=this._input.size,this.parseChunk(E.target.result)},this._chunkError=function(){this._sendError(p.error)}}function h(x){var p;l.call(this,x=x||{}),this.stream=function(S){return p=S,this._nextChunk()},this._nextChunk=function(){var S,A;if(!this._finished)return S=this._config.chunkSize,p=S?(A=p.substring(0,S),p.substring(S)):(A=p,""),this._finished=!p,this.parseChunk(A)}}function d(x){l.call(this,x=x||{});var p=[],S=!0,A=!1;this.pause=function(){l.prototype.pause.apply(this,arguments),this._input.pause()},this.resume=function(){l.prototype.resume.apply(this,arguments),this._input.resume()},this.stream=function(E){this._input=E,this._input.on("data",this._streamData),this._input.on("end",this._streamEnd),this._input.on("error",this._streamError)},this._checkIsFinished=function(){A&&p.length===1&&(this._finished=!0)},this._nextChunk=function(){this._checkIsFinished(),p.length?this.parseChunk(p.shift()):S=!0},this._streamData=b(function(E){try{p.push(typeof E=="string"?E:E.toString(this._config.encoding)),S&&(S=!1,this._checkIsFinished(),this.parseChunk(p.shift()))}catch(C){this._streamError(C)}},this),this._streamError=b(function(E){this._streamCleanUp(),this._sendError(E)},this),this._streamEnd=b(function(){this._streamCleanUp(),A=!0,this._streamData("")},this),this._streamCleanUp=b(function(){this._input.removeListener("data",this._streamData),this._input.removeListener("end",this._streamEnd),this._input.removeListener("error",this._streamError)},this)}function f(x){var p,S,A,E,C=Math.pow(2,53),I=-C,D=/^\s*-?(\d+\.?|\.\d+|\d+\.\d+)([eE][-+]?\d+)?\s*$/,L=/^((\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\d\.\d+([+-][0-2]\d:[0-5]\d|Z))|(\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\d([+-][0-2]\d:[0-5]\d|Z))|(\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d([+-][0-2]\d:[0-5]\d|Z)))$/,U=this,V=0,B=0,ne=!1,z=!1,q=[],W={data:[],errors:[],meta:{}};function _e(se){return x.skipEmptyLines==="greedy"?se.join("").trim()==="":se.length===1&&se[0].length===0}function Te(){if(W&&A&&(ae("Delimiter","UndetectableDelimiter","Unable to auto-detect delimiting character; defaulted to '"+o.DefaultDelimiter+"'"),A=!1),x.skipEmptyLines&&(W.data=W.data.filter(function(Ye){return!_e(Ye)})),$()){let Ye=function(Ae){q.push(Ae)};var de=Ye;if(W)if(Array.isArray(W.data[0])){for(var se=0;$()&&se<W.data.length;se++)W.data[se].forEach(Ye);W.data.splice(0,1)}else W.data.forEach(Ye)}function ce(Ye,Ae){for(var Be=x.header?{}:[],Le=0;Le<Ye.length;Le++){var Me=Le,pt=Ye[Le],pt=((Ge,rt)=>(je=>(x.dynamicTypingFunction&&x.dynamicTyping[je]===void 0&&(x.dynamicTyping[je]=x.dynamicTypingFunction(je)),(x.dynamicTyping[je]||x.dynamicTyping)===!0))(Ge)?rt==="true"||rt==="TRUE"||rt!=="false"&&rt!=="FALSE"&&((je=>{if(D.test(je)&&(je=parseFloat(je),I<je&&je<C))return 1})(rt)?parseFloat(rt):L.test(rt)?new Date(rt):rt===""?null:rt):rt)(Me=x.header?Le>=q.length?"__parsed_extra":q[Le]:Me,pt=x.transform?x.transform(pt,Me):pt);Me==="__parsed_extra"?(Be[Me]=Be[Me]||[],Be[Me].push(pt)):Be[Me]=pt}return x.header&&(Le>q.length?ae("FieldMismatch","TooManyFields","Too many fields: expected "+q.length+" fields but parsed "+Le,B+Ae):Le<q.length&&ae("FieldMismatch","TooFewFields","Too few fields: expected "+q.length+" fields but parsed "+Le,B+Ae)),Be}var re;W&&(x.header||x.dynamicTyping||x.transform)&&(re=1,!W.data.length||Array.isArray(W.data[0])?(W.data=W.data.map(ce),re=W.data.length):W.data=ce(W.data,0),x.header&&W.meta&&(W.meta.fields=q),B+=re)}function $(){return x.header&&q.length===0}function ae(se,ce,re,de){se={type:se,code:ce,message:re},de!==void 0&&(se.row=de),W.errors.push(se)}w(x.step)&&(E=x.step,x.step=function(se){W=se,$()?Te():(Te(),W.data.length!==0&&(V+=se.data.length,x.preview&&V>x.preview?S.abort():(W.data=W.data[0],E(W,U))))}),this.parse=function(se,ce,re){var de=x.quoteChar||'"',de=(x.newline||(x.newline=this.guessLineEndings(se,de)),A=!1,x.delimiter?w(x.delimiter)&&(x.delimiter=x.delimiter(se),W.meta.delimiter=x.delimiter):((de=((Ye,Ae,Be,Le,Me)=>{var pt,Ge,rt,je;Me=Me||[",","	","|",";",o.RECORD_SEP,o.UNIT_SEP];for(var Sn=0;Sn<Me.length;Sn++){for(var Ot,mn=Me[Sn],Rt=0,Kt=0,k=0,Ft=(rt=void 0,new y({comments:Le,delimiter:mn,newline:Ae,preview:10}).parse(Ye)),mt=0;mt<Ft.data.length;mt++)Be&&_e(Ft.data[mt])?k++:(Ot=Ft.data[mt].length,Kt+=Ot,rt===void 0?rt=Ot:0<Ot&&(Rt+=Math.abs(Ot-rt),rt=Ot));0<Ft.data.length&&(Kt/=Ft.data.length-k),1.99<Kt&&(Ge===void 0||Rt<Ge||Rt===Ge&&je<Kt)&&(Ge=Rt,pt=mn,je=Kt)}return{successful:!!(x.delimiter=pt),bestDelimiter:pt}})(se,x.newline,x.skipEmptyLines,x.comments,x.delimitersToGuess)).successful?x.delimiter=de.bestDelimiter:(A=!0,x.delimiter=o.DefaultDelimiter),W.meta.delimiter=x.delimiter),M(x));return de.header=$(),x.preview&&x.header&&de.preview++,p=se,S=new y(de),W=S.parse(p,ce,re),Te(),ne?{meta:{paused:!0}}:W||{meta:{paused:!1}}},this.paused=function(){return ne},this.pause=function(){ne=!0,S.abort(),p=w(x.chunk)?"":p.substring(S.getCharIndex())},this.resume=function(){U.streamer._halted?(ne=!1,U.streamer.parseChunk(p,!0)):setTimeout(U.resume,3)},this.aborted=function(){return z},this.abort=function(){z=!0,S.abort(),W.meta.aborted=!0,w(x.complete)&&x.complete(W),p=""},this.guessLineEndings=function(Ye,de){Ye=Ye.substring(0,1048576);var de=new RegExp(m(de)+"([^]*?)"+m(de),"gm"),re=(Ye=Ye.replace(de,"")).split("\r"),de=Ye.split(`
`),Ye=1<de.length&&de[0].length<re[0].length;if(re.length===1||Ye)return`
`;for(var Ae=0,Be=0;Be<re.length;Be++)re[Be][0]===`
`&&Ae++;return Ae>=re.length/2?`\r
`:"\r"}}function m(x){return x.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")}function y(x){var p=(x=x||{}).delimiter,S=x.newline,A=x.comments,E=x.step,C=x.preview,I=x.fastMode,D=null,L=!1,U=x.quoteChar==null?'"':x.quoteChar,V=U;if(x.escapeChar!==void 0&&(V=x.escapeChar),(typeof p!="string"||-1<o.BAD_DELIMITERS.indexOf(p))&&(p=","),A===p)throw new Error("Comment character same as delimiter");A===!0?A="#":(typeof A!="string"||-1<o.BAD_DELIMITERS.indexOf(A))&&(A=!1),S!==`
`&&S!=="\r"&&S!==`\r
`&&(S=`
`);var B=0,ne=!1;this.parse=function(z,q,W){if(typeof z!="string")throw new Error("Input must be a string");var _e=z.length,Te=p.length,$=S.length,ae=A.length,se=w(E),ce=[],re=[],de=[],Ye=B=0;if(!z)return Rt();if(I||I!==!1&&z.indexOf(U)===-1){for(var Ae=z.split(S),Be=0;Be<Ae.length;Be++){if(de=Ae[Be],B+=de.length,Be!==Ae.length-1)B+=S.length;else if(W)return Rt();if(!A||de.substring(0,ae)!==A){if(se){if(ce=[],je(de.split(p)),Kt(),ne)return Rt()}else je(de.split(p));if(C&&C<=Be)return ce=ce.slice(0,C),Rt(!0)}}return Rt()}for(var Le=z.indexOf(p,B),Me=z.indexOf(S,B),pt=new RegExp(m(V)+m(U),"g"),Ge=z.indexOf(U,B);;)if(z[B]===U)for(Ge=B,B++;;){if((Ge=z.indexOf(U,Ge+1))===-1)return W||re.push({type:"Quotes",code:"MissingQuotes",message:"Quoted field unterminated",row:ce.length,index:B}),Ot();if(Ge===_e-1)return Ot(z.substring(B,Ge).replace(pt,U));if(U===V&&z[Ge+1]===V)Ge++;else if(U===V||Ge===0||z[Ge-1]!==V){Le!==-1&&Le<Ge+1&&(Le=z.indexOf(p,Ge+1));var rt=Sn((Me=Me!==-1&&Me<Ge+1?z.indexOf(S,Ge+1):Me)===-1?Le:Math.min(Le,Me));if(z.substr(Ge+1+rt,Te)===p){de.push(z.substring(B,Ge).replace(pt,U)),z[B=Ge+1+rt+Te]!==U&&(Ge=z.indexOf(U,B)),Le!==-1&&Le<B&&(Le=z.indexOf(p,B)),Me!==-1&&Me<B&&(Me=z.indexOf(S,B));break}if(rt=Sn(Me),z.substring(Ge+1+rt,Ge+1+rt+$)===S){if(de.push(z.substring(B,Ge).replace(pt,U)),mn(Ge+1+rt+$),Le!==-1&&Le<B&&(Le=z.indexOf(p,B)),Ge=z.indexOf(U,B),se&&(Kt(),ne))return Rt();if(C&&ce.length>=C)return Rt(!0);break}re.push({type:"Quotes",code:"InvalidQuotes",message:"Trailing quote on quoted field is malformed",row:ce.length,index:B}),Ge++}}else if(A&&de.length===0&&z.substring(B,B+ae)===A){if(Me===-1)return Rt();B=Me+$,Me=z.indexOf(S,B),Le!==-1&&Le<B&&(Le=z.indexOf(p,B))}else if(Le!==-1&&(Le<Me||Me===-1))de.push(z.substring(B,Le)),B=Le+Te,Le=z.indexOf(p,B);else{if(Me===-1)break;if(de.push(z.substring(B,Me)),mn(Me+$),se&&(Kt(),ne))return Rt();if(C&&ce.length>=C)return Rt(!0)}return Ot();function je(k){ce.push(k),Ye=B}function Sn(k){var Ft=0;return Ft=k!==-1&&(k=z.substring(Ge+1,k))&&k.trim()===""?k.length:Ft}function Ot(k){return W||(k===void 0&&(k=z.substring(B)),de.push(k),B=_e,je(de),se&&Kt()),Rt()}function mn(k){B=k,je(de),de=[],Me=z.indexOf(S,B)}function Rt(k){if(x.header&&!q&&ce.length&&!L){var Ft=ce[0],mt=Object.create(null),Dt=new Set(Ft);let ye=!1;for(let Gt=0;Gt<Ft.length;Gt++){let Oe=a(Ft[Gt]);if(mt[Oe=w(x.transformHeader)?x.transformHeader(Oe,Gt):Oe]){let We,O=mt[Oe];for(;We=Oe+"_"+O,O++,Dt.has(We););Dt.add(We),Ft[Gt]=We,mt[Oe]++,ye=!0,(D=D===null?{}:D)[We]=Oe}else mt[Oe]=1,Ft[Gt]=Oe;Dt.add(Oe)}ye&&console.warn("Duplicate headers found and renamed."),L=!0}return{data:ce,errors:re,meta:{delimiter:p,linebreak:S,aborted:ne,truncated:!!k,cursor:Ye+(q||0),renamedHeaders:D}}}function Kt(){E(Rt()),ce=[],re=[]}},this.abort=function(){ne=!0},this.getCharIndex=function(){return B}}function g(x){var p=x.data,S=s[p.workerId],A=!1;if(p.error)S.userError(p.error,p.file);else if(p.results&&p.results.data){var E={abort:function(){A=!0,_(p.workerId,{data:[],errors:[],meta:{aborted:!0}})},pause:v,resume:v};if(w(S.userStep)){for(var C=0;C<p.results.data.length&&(S.userStep({data:p.results.data[C],errors:p.results.errors,meta:p.results.meta},E),!A);C++);delete p.results}else w(S.userChunk)&&(S.userChunk(p.results,E,p.file),delete p.results)}p.finished&&!A&&_(p.workerId,p.results)}function _(x,p){var S=s[x];w(S.userComplete)&&S.userComplete(p),S.terminate(),delete s[x]}function v(){throw new Error("Not implemented.")}function M(x){if(typeof x!="object"||x===null)return x;var p,S=Array.isArray(x)?[]:{};for(p in x)S[p]=M(x[p]);return S}function b(x,p){return function(){x.apply(p,arguments)}}function w(x){return typeof x=="function"}return o.parse=function(x,p){var S=(p=p||{}).dynamicTyping||!1;if(w(S)&&(p.dynamicTypingFunction=S,S={}),p.dynamicTyping=S,p.transform=!!w(p.transform)&&p.transform,p.downloadTimeout!==void 0){var S=parseInt(p.downloadTimeout);if(isNaN(S))throw new Error("Config downloadTimeout value ("+p.downloadTimeout+") not parsable by parseInt(val).");p.downloadTimeout=S}if(!p.worker||!o.WORKERS_SUPPORTED)return S=null,o.NODE_STREAM_INPUT,typeof x=="string"?(x=a(x),S=new(p.download?c:h)(p)):x.readable===!0&&w(x.read)&&w(x.on)?S=new d(p):(e.File&&x instanceof File||x instanceof Object)&&(S=new u(p)),S.stream(x);(S=(()=>{var A;return!!o.WORKERS_SUPPORTED&&(A=(()=>{var E=e.URL||e.webkitURL||null,C=i.toString();return o.BLOB_URL||(o.BLOB_URL=E.createObjectURL(new Blob(["var global = (function() { if (typeof self !== 'undefined') { return self; } if (typeof window !== 'undefined') { return window; } if (typeof global !== 'undefined') { return global; } return {}; })(); global.IS_PAPA_WORKER=true; ","(",C,")();"],{type:"text/javascript"})))})(),(A=new e.Worker(A)).onmessage=g,A.id=r++,s[A.id]=A)})()).userStep=p.step,S.userChunk=p.chunk,S.userComplete=p.complete,S.userError=p.error,p.step=w(p.step),p.chunk=w(p.chunk),p.complete=w(p.complete),p.error=w(p.error),delete p.worker,S.postMessage({input:x,config:p,workerId:S.id})},o.unparse=function(x,p){var S=!1,A=!0,E=",",C=`\r
`,I='"',D=I+I,L=!1,U=null,V=!1,B=((()=>{if(typeof p=="object"){if(typeof p.delimiter!="string"||o.BAD_DELIMITERS.filter(function(q){return p.delimiter.indexOf(q)!==-1}).length||(E=p.delimiter),typeof p.quotes!="boolean"&&typeof p.quotes!="function"&&!Array.isArray(p.quotes)||(S=p.quotes),typeof p.skipEmptyLines!="boolean"&&typeof p.skipEmptyLines!="string"||(L=p.skipEmptyLines),typeof p.newline=="string"&&(C=p.newline),typeof p.quoteChar=="string"&&(I=p.quoteChar,D=I+I),typeof p.header=="boolean"&&(A=p.header),Array.isArray(p.columns)){if(p.columns.length===0)throw new Error("Option columns is empty");U=p.columns}p.escapeChar!==void 0&&(D=p.escapeChar+I),p.escapeFormulae instanceof RegExp?V=p.escapeFormulae:typeof p.escapeFormulae=="boolean"&&p.escapeFormulae&&(V=/^[=+\-@\t\r].*$/)}})(),new RegExp(m(I),"g"));if(typeof x=="string"&&(x=JSON.parse(x)),Array.isArray(x)){if(!x.length)return ne(U,x,L);if(Array.isArray(x[0]))return ne(null,x,L);if(typeof x[0]=="object")return ne(U||Object.keys(x[0]),x,L)}else if(typeof x=="object")return typeof x.data=="string"&&(x.data=JSON.parse(x.data)),Array.isArray(x.data)&&(x.fields||(x.fields=x.meta&&x.meta.fields||U),x.fields||(x.fields=Array.isArray(x.data[0])?x.fields:typeof x.data[0]=="object"?Object.keys(x.data[0]):[]),Array.isArray(x.data[0])||typeof x.data[0]=="object"||(x.data=[x.data])),ne(x.fields||[],x.data||[],L);throw new Error("Unable to serialize unrecognized input");function ne(q,W,_e){var Te="",$=(typeof q=="string"&&(q=JSON.parse(q)),typeof W=="string"&&(W=JSON.parse(W)),Array.isArray(q)&&0<q.length),ae=!Array.isArray(W[0]);if($&&A){for(var se=0;se<q.length;se++)0<se&&(Te+=E),Te+=z(q[se],se);0<W.length&&(Te+=C)}for(var ce=0;ce<W.length;ce++){var re=($?q:W[ce]).length,de=!1,Ye=$?Object.keys(W[ce]).length===0:W[ce].length===0;if(_e&&!$&&(de=_e==="greedy"?W[ce].join("").trim()==="":W[ce].length===1&&(W[ce][0]==null||W[ce][0].length===0)),_e==="greedy"&&$){for(var Ae=[],Be=0;Be<re;Be++){var Le=ae?q[Be]:Be;Ae.push(W[ce][Le])}de=Ae.join("").trim()===""}if(!de){for(var Me=0;Me<re;Me++){0<Me&&!Ye&&(Te+=E);var pt=$&&ae?q[Me]:Me;Te+=z(W[ce][pt],Me)}ce<W.length-1&&(!_e||0<re&&!Ye)&&(Te+=C)}}return Te}function z(q,W){var _e,Te,$;return q==null?"":q.constructor===Date?isNaN(q.getTime())?"":q.toISOString():($=!1,_e=q.toString(),V&&typeof q!="number"&&typeof q!="bigint"&&typeof q!="boolean"&&V.test(_e)&&(q=_e="'"+_e,$=!0),Te=_e.replace(B,D),($=$||S===!0||typeof S=="function"&&S(q,W)||Array.isArray(S)&&S[W]||((ae,se)=>{for(var ce=0;ce<se.length;ce++)if(-1<ae.indexOf(se[ce]))return!0;return!1})(Te,o.BAD_DELIMITERS)||-1<Te.indexOf(E)||-1<_e.indexOf(I)||Te.charAt(0)===" "||Te.charAt(Te.length-1)===" ")?I+Te+I:Te)}},o.RECORD_SEP="",o.UNIT_SEP="",o.BYTE_ORDER_MARK="\uFEFF",o.BAD_DELIMITERS=["\r",`
`,'"',o.BYTE_ORDER_MARK],o.WORKERS_SUPPORTED=!t&&!!e.Worker,o.NODE_STREAM_INPUT=1,o.LocalChunkSize=10485760,o.RemoteChunkSize=5242880,o.DefaultDelimiter=",",o.Parser=y,o.ParserHandle=f,o.NetworkStreamer=c,o.FileStreamer=u,o.StringStreamer=h,o.ReadableStreamStreamer=d,n&&(e.onmessage=function(x){x=x.data,o.WORKER_ID===void 0&&x&&(o.WORKER_ID=x.workerId),typeof x.input=="string"?e.postMessage({workerId:o.WORKER_ID,results:o.parse(x.input,x.config),finished:!0}):(e.File&&x.input instanceof File||x.input instanceof Object)&&(x=o.parse(x.input,x.config))&&e.postMessage({workerId:o.WORKER_ID,results:x,finished:!0})}),(c.prototype=Object.create(l.prototype)).constructor=c,(u.prototype=Object.create(l.prototype)).constructor=u,(h.prototype=Object.create(h.prototype)).constructor=h,(d.prototype=Object.create(l.prototype)).constructor=d,o})});var gv=kg((mv,Fd)=>{(function(i,e){"use strict";typeof define=="function"&&define.amd?define(e):typeof Fd=="object"&&Fd.exports?Fd.exports=e():i.log=e()})(mv,function(){"use strict";var i=function(){},e="undefined",t=typeof window!==e&&typeof window.navigator!==e&&/Trident\/|MSIE /.test(window.navigator.userAgent),n=["trace","debug","info","warn","error"],s={},r=null;function o(m,y){var g=m[y];if(typeof g.bind=="function")return g.bind(m);try{return Function.prototype.bind.call(g,m)}catch{return function(){return Function.prototype.apply.apply(g,[m,arguments])}}}function a(){console.log&&(console.log.apply?console.log.apply(console,arguments):Function.prototype.apply.apply(console.log,[console,arguments])),console.trace&&console.trace()}function l(m){return m==="debug"&&(m="log"),typeof console===e?!1:m==="trace"&&t?a:console[m]!==void 0?o(console,m):console.log!==void 0?o(console,"log"):i}function c(){for(var m=this.getLevel(),y=0;y<n.length;y++){var g=n[y];this[g]=y<m?i:this.methodFactory(g,m,this.name)}if(this.log=this.debug,typeof console===e&&m<this.levels.SILENT)return"No console available for logging"}function u(m){return function(){typeof console!==e&&(c.call(this),this[m].apply(this,arguments))}}function h(m,y,g){return l(m)||u.apply(this,arguments)}function d(m,y){var g=this,_,v,M,b="loglevel";typeof m=="string"?b+=":"+m:typeof m=="symbol"&&(b=void 0);function w(E){var C=(n[E]||"silent").toUpperCase();if(!(typeof window===e||!b)){try{window.localStorage[b]=C;return}catch{}try{window.document.cookie=encodeURIComponent(b)+"="+C+";"}catch{}}}function x(){var E;if(!(typeof window===e||!b)){try{E=window.localStorage[b]}catch{}if(typeof E===e)try{var C=window.document.cookie,I=encodeURIComponent(b),D=C.indexOf(I+"=");D!==-1&&(E=/^([^;]+)/.exec(C.slice(D+I.length+1))[1])}catch{}return g.levels[E]===void 0&&(E=void 0),E}}function p(){if(!(typeof window===e||!b)){try{window.localStorage.removeItem(b)}catch{}try{window.document.cookie=encodeURIComponent(b)+"=; expires=Thu, 01 Jan 1970 00:00:00 UTC"}catch{}}}function S(E){var C=E;if(typeof C=="string"&&g.levels[C.toUpperCase()]!==void 0&&(C=g.levels[C.toUpperCase()]),typeof C=="number"&&C>=0&&C<=g.levels.SILENT)return C;throw new TypeError("log.setLevel() called with invalid level: "+E)}g.name=m,g.levels={TRACE:0,DEBUG:1,INFO:2,WARN:3,ERROR:4,SILENT:5},g.methodFactory=y||h,g.getLevel=function(){return M??v??_},g.setLevel=function(E,C){return M=S(E),C!==!1&&w(M),c.call(g)},g.setDefaultLevel=function(E){v=S(E),x()||g.setLevel(E,!1)},g.resetLevel=function(){M=null,p(),c.call(g)},g.enableAll=function(E){g.setLevel(g.levels.TRACE,E)},g.disableAll=function(E){g.setLevel(g.levels.SILENT,E)},g.rebuild=function(){if(r!==g&&(_=S(r.getLevel())),c.call(g),r===g)for(var E in s)s[E].rebuild()},_=S(r?r.getLevel():"WARN");var A=x();A!=null&&(M=S(A)),c.call(g)}r=new d,r.getLogger=function(y){if(typeof y!="symbol"&&typeof y!="string"||y==="")throw new TypeError("You must supply a name when creating a logger.");var g=s[y];return g||(g=s[y]=new d(y,r.methodFactory)),g};var f=typeof window!==e?window.log:void 0;return r.noConflict=function(){return typeof window!==e&&window.log===r&&(window.log=f),r},r.getLoggers=function(){return s},r.default=r,r})});var zi=class extends Error{title;detail;errors;omitted;status;constructor({title:e,detail:t,errors:n,errors_omitted:s,status:r}){super(t||e),this.title=e??"Something went wrong",this.detail=t??"",this.errors=n??[],this.omitted=s??!1,this.status=r??0}},Sc="",Gd=i=>{Sc=i},Mc=()=>Sc!=="",zg=new URL(".",document.baseURI).pathname.replace(/studio\/$/,""),Vg=i=>i.startsWith(zg)?i:zg+i.replace(/^\//,""),vr=i=>new URL(Vg(i),location.href).href;async function br(i,e={}){let t={...Sc&&{Authorization:`Bearer ${Sc}`},...e.headers},n;try{n=await fetch(Vg(i),{...e,headers:t})}catch(o){throw e.signal?.aborted?o:new zi({title:"The server cannot be reached",detail:"Is it still running? Nothing was lost; try again."})}if(n.ok)return n;let s=await n.text(),r;try{r=JSON.parse(s)}catch{r={title:`The server answered ${n.status}`,detail:s.slice(0,300)}}throw new zi({...r,status:n.status})}var Vi=async i=>(await br(i)).json(),no=async i=>(await br(i)).arrayBuffer(),wc=async i=>(await br(i)).blob();async function Ec(i,e){return(await br(i,{method:"POST",headers:{"Content-Type":"application/json",Prefer:"wait=1"},body:JSON.stringify(e)})).json()}var Wd=async i=>(await br(i.links.cancel,{method:"POST"})).json(),Hg=async i=>{await br(i.links.self,{method:"DELETE"})},to=i=>["succeeded","failed","cancelled"].includes(i.status??"");async function Tc(i,e){let t=null;for(let n=0;;n+=1){try{let r={Accept:"text/event-stream",...t&&{"Last-Event-ID":t}};for await(let o of ob(await br(i.links.events,{headers:r}))){n=0,t=o.id??t;let a=JSON.parse(o.data);if(a.progress&&e(a.progress),to(a)&&a.links)return a}}catch(r){if(!(r instanceof zi)||r.status>=400&&r.status<500||n>=5)throw r}let s=await Vi(i.links.self);if(to(s))return s;await new Promise(r=>{setTimeout(r,300*(n+1))})}}async function*ob(i){if(!i.body||i.status===204)return;let e=i.body.pipeThrough(new TextDecoderStream).getReader(),t="";for(;;){let{value:n,done:s}=await e.read();if(s)return;t+=n.replaceAll(`\r
`,`
`);let r=t.split(`

`);t=r.pop()??"";for(let o of r){let a={};for(let l of o.split(`
`)){let[,c,u=""]=/^([^:]*):? ?(.*)$/s.exec(l)??[];c==="data"?a.data=a.data===void 0?u:`${a.data}
${u}`:(c==="id"||c==="event")&&(a[c]=u)}a.data!==void 0&&(yield a)}}}function Z(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element #${i}`);return e}function ie(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r!=null&&(s.startsWith("on")&&typeof r=="function"?n.addEventListener(s.slice(2),r):s in n?n[s]=r:n.setAttribute(s,String(r)));return n.append(...t.filter(s=>s!=null&&s!==!1)),n}var ab="http://www.w3.org/2000/svg";function Dn(i,e={},...t){let n=document.createElementNS(ab,i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}function io(i,e){let t=URL.createObjectURL(i),n=ie("a",{href:t,download:e});document.body.append(n),n.click(),n.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var Mt={minimal_surface:{path:"/v1/minimal-surfaces",label:"Film",line:"boundary",lines:["boundaries"],least:3,purpose:"A membrane of least area on its boundary"},ruled_surface:{path:"/v1/ruled-surfaces",label:"Strip",line:"rail",lines:["directrices"],least:2,purpose:"A ruled strip between two rails"},uniform_mesh:{path:"/v1/uniform-meshes",label:"Lattice",line:"hole",lines:["domain","holes"],least:3,purpose:"A gridshell or floor of equal members"},tensile_structure:{path:"/v1/tensile-structures",label:"Tensile",line:"boundary",lines:["boundaries"],least:3,purpose:"A film with cables, pressure and weight in equilibrium"}},Gg={mm:.001,cm:.01,m:1,in:.0254,ft:.3048},wi=i=>{let e=String(Ca(i.units)?.length??i.units);return e in Gg?e:"m"},so=i=>Gg[wi(i)]??1;var Xd=i=>typeof i=="number"&&Number.isFinite(i),Wg=i=>Array.isArray(i)&&i.length===3&&i.every(Xd);function Yt(i){return!Array.isArray(i)||!i.some(Xd)?null:[0,1,2].map(e=>Xd(i[e])&&Math.abs(i[e])<1e150?i[e]:0)}function Ac(i,e){let t=[],n=(o,a,l,c,u=!1)=>{Array.isArray(l)&&t.push({name:o,path:a,points:l,closed:c,planar:u})},s=(o,a,l,c,u=!1)=>{Array.isArray(l)&&l.forEach((h,d)=>n(`${o} ${d+1}`,[...a,d],h,c,u))};if(i==="ruled_surface"&&s("rail",["directrices"],e.directrices,e.closed===!0),i==="tensile_structure"&&s("boundary",["boundaries"],e.boundaries,!0),i==="minimal_surface"){s("boundary",["boundaries"],e.boundaries,!0);let o=Ca(e.constraints);s("rope",["constraints","polylines"],o?.polylines,!1),Array.isArray(o?.points)&&o.points.length>0&&n("fixed points",["constraints","points"],o.points,!1)}let r=Ca(e.domain);if(r){n("polygon",["domain","polygon"],r.polygon,!0,!0),s("hole",["domain","holes"],r.holes,!0,!0),s("boundary",["domain","boundaries"],r.boundaries,!0);for(let o of["bezier","nurbs"])s("control row",["domain",o,"control_points"],Ca(r[o])?.control_points,!1)}return t}var Ca=i=>i!==null&&typeof i=="object"&&!Array.isArray(i)?i:null,Mr=i=>i.path[0]==="constraints"&&i.path[1]==="points";function Xg(i,e){return e.reduce((t,n)=>t?.[n],i)}function qd(i,e){let t=e.split("/").slice(1).map(l=>l.replaceAll("~1","/").replaceAll("~0","~")),n=i.findIndex(l=>l.path.every((c,u)=>String(c)===t[u]));if(n<0){let l=/^(normals|tangents)$/.test(t[0]??"")?i.findIndex(u=>u.path[0]==="directrices"&&String(u.path[1])===t[1]):-1;return l>=0&&/^\d+$/.test(t[2]??"")?{text:`${t[0]} of ${i[l].name}, point ${Number(t[2])+1}`,line:l,point:Number(t[2]),field:t[0]}:{text:t.map(u=>/^\d+$/.test(u)?String(Number(u)+1):u.replaceAll("_"," ")).join(" › ")||"the request",...t[0]!==void 0&&{field:t[0]}}}let s=i[n],[r,o]=t.slice(s.path.length).map(Number);if(r===void 0||!Number.isInteger(r))return{text:s.name,line:n};let a=o===void 0?"":`, ${"xyz"[o]??"coordinate"}`;return{text:`${s.name}, point ${r+1}${a}`,line:n,point:Math.min(r,s.points.length-1),...o!==void 0&&{axis:o}}}function Rc(i){return i==="ruled_surface"?{directrices:[]}:i==="uniform_mesh"?{domain:{},edge_length:1}:i==="tensile_structure"?{boundaries:[],film:{tension:1}}:{boundaries:[]}}function Ei(i,e){let t=Ac(i,e);return i==="ruled_surface"?t.length>=2:t.length>=1||i==="uniform_mesh"&&Object.keys(Ca(e.domain)??{}).length>0}function Pa(i){return typeof i.kind=="string"?i.kind in Mt?i.kind:null:"boundaries"in i?"minimal_surface":"directrices"in i?"ruled_surface":"domain"in i?"uniform_mesh":null}var Cc=i=>JSON.stringify(i,null,1).replace(/\[\s+([^[\]{}]*?)\s+\]/g,(e,t)=>`[${t.replace(/\s+/g," ")}]`);function tn(i){let[,e=i,t]=/^(.*?)(_deg|_ms|_s)?$/.exec(i)??[],n=e.replaceAll("_"," ");if(n.length<=2)return n;let s={_deg:" (°)",_ms:" (ms)",_s:" (s)"}[t??""]??"";return n.charAt(0).toUpperCase()+n.slice(1)+s}var wr=i=>i.charAt(0).toUpperCase()+i.slice(1);function qg(i){let e=i.replace(/,/g,".").replace(/−/g,"-"),t=e.match(/[+-]?\s*\d*\.?\d+(?:e[+-]?\d+)?/gi);return!t||t.join("").replace(/\s/g,"")!==e.replace(/\s/g,"")?NaN:Number(t.reduce((n,s)=>n+Number(s.replace(/\s/g,"")),0).toPrecision(15))}var lb={"-":"⁻",...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((i,e)=>[String(e),i]))};function wt(i,e=5){if(Number.isInteger(i)&&Math.abs(i)<1e15)return i.toLocaleString("en").replace("-","−");let t=Math.abs(i);if(t!==0&&(t<1e-4||t>=1e9)){let[n="",s=""]=i.toExponential(Math.min(e,3)-1).split("e");return`${(n.includes(".")?n.replace(/\.?0+$/,""):n).replace("-","−")}×10${[...s.replace("+","")].map(o=>lb[o]).join("")}`}return String(Number(i.toPrecision(e))).replace("-","−")}var Ti=(i,e,t=`${e}s`)=>`${wt(i)} ${i===1?e:t}`;function Pc(i){return i<10?`${wt(Number(i.toPrecision(2)))} s`:i<90?`${Math.round(i)} s`:`${Math.floor(i/60)} min ${Math.round(i%60)} s`}var cb=/\b(boundary|boundaries|directrix|directrices|strips?|holes?|loops?|polygons?|polylines?|rows?|points?)((?: \d+(?![.\d%°])(?:,| and| or)?)+)/g;function Ia(i){return i.replace(cb,(e,t,n)=>t+n.replace(/\d+/g,s=>String(Number(s)+1))).replace(/(-?\d+(?:\.\d+)?e[+-]?\d+)\b/g,e=>wt(Number(e))).replace(/(?<![\d.,])1 (places|points|triangles|edges|vertices|strips|boundaries|directrices|loops|members|nodes|rows)\b/g,(e,t)=>`1 ${ub(t)}`)}var ub=i=>({vertices:"vertex",boundaries:"boundary",directrices:"directrix"})[i]??i.slice(0,-1),hb=[[/^it is not of type "number"$/,"must be a number"],[/^it is not of types? .*"(number|integer)".*$/,"must be a number"],[/^it is not of type "array"$/,"must be a list such as [x, y, z]"]];function Yg(i){let e=hb.find(([t])=>t.test(i));return e?e[1]:Ia(i)}function Lc(i,e){let t=i.paths?.[e]?.post?.requestBody?.content?.["application/json"]?.schema;return t?Hi(i,t):null}var Ic=i=>i.type==="null";function Hi(i,e){let t=e,n={};for(let s=0;s<8;s+=1){t.description!==void 0&&(n.description??=t.description),t["x-default"]!==void 0&&(n["x-default"]??=t["x-default"]);let r=t.anyOf??t.oneOf??[];r.some(Ic)&&(n.nullable=!0);let o=r.filter(c=>!Ic(c)),a=r.some(Ic)&&o.length===1?o[0]:void 0,l=t.$ref?{$ref:t.$ref}:t.allOf?.[0]??a;if(!l)break;t=l.$ref?db(i,l.$ref):l}return{...t,...n}}var db=(i,e)=>e.slice(2).split("/").reduce((t,n)=>t?.[n],i)??{};function La(i,e){let t=(e.oneOf??e.anyOf??[e]).filter(o=>!Ic(o)).map(o=>Hi(i,o)),n=t.flatMap(o=>o.oneOf??o.anyOf??[o]).filter(o=>o.enum),s=n.flatMap(o=>o.enum??[]);if(s.length>0&&s.every(o=>typeof o=="string")){let o=Object.fromEntries(n.flatMap(a=>(a.enum??[]).map((l,c)=>[String(l),a["x-enum-descriptions"]?.[c]||void 0])));return{type:"choice",names:s,help:o,other:t.find(a=>a.properties)??null}}let r=[e.type].flat();if(r.includes("boolean"))return{type:"flag"};if(r.includes("integer")||r.includes("number"))return{type:"number",whole:r.includes("integer")};if(r.includes("string"))return{type:"text"};if(r.includes("object")&&e.maxProperties===1)return{type:"one_of"};if(r.includes("object")&&e.properties&&Object.values(e.properties).every(o=>La(i,Hi(i,o))))return{type:"group"};if(r.includes("array")&&e.items&&e.minItems===e.maxItems&&(e.maxItems??9)<=3){let o=Hi(i,e.items);if([o.type].flat().some(a=>a==="integer"||a==="number"))return{type:"numbers",count:e.maxItems,item:o}}return null}var Yd=["objective","secondary_objective","resolution","edge_length","closed","optimise","max_distinct_lengths","topology","units","up"],fb={closed:"Closed rails",units:"Unit",up:"Up axis",all_objectives:"Compare all objectives",optimise:"Optimise"},pb=["kind","supersede","cancel_on_disconnect"],$g=i=>Yd.indexOf(i)+1||Yd.length+1,Ai=i=>fb[i]??tn(i);function Kg(i,e,t,n){let s=i.querySelector("details")?.open??!1;i.replaceChildren();let r=ie("div",{className:"fields"}),o=Object.keys(e.properties??{}).filter(a=>!pb.includes(a));o.sort((a,l)=>$g(a)-$g(l));for(let a of o){let l=Hi(n.openapi,e.properties[a]),c=La(n.openapi,l);if(!c||c.type==="choice"&&c.names.length<2&&!c.other)continue;let u=Kd(n,a,l,c,t[a],h=>n.set(a,h),[a]);(Yd.includes(a)?i:r).append(u)}r.childElementCount>0&&i.append(ie("details",{className:"more",open:s},ie("summary",{},"More options"),r))}function Kd(i,e,t,n,s,r,o){let a=s??t["x-default"],l=t.description??"",c=`option-${o.join("-")}`;if(n.type==="flag"){let u=ie("input",{type:"checkbox",name:o.join("."),id:c,checked:a===!0});return u.addEventListener("change",()=>r(u.checked)),ie("label",{className:"check field",title:l},u,Ai(e))}if(n.type==="choice")return mb(i,e,t,n,s,r,o);if(n.type==="number"){let u=$d(o.join("."),c,t,n.whole,a);return u.addEventListener("change",()=>{u.checkValidity()?r(u.value===""?void 0:u.valueAsNumber):u.reportValidity()}),ie("label",{className:"field",title:l,htmlFor:c},ie("span",{},Ai(e)),u)}if(n.type==="text"){let u=ie("input",{type:"text",name:o.join("."),id:c,value:a??"",placeholder:"none",autocomplete:"off"});return u.addEventListener("change",()=>r(u.value===""?void 0:u.value)),ie("label",{className:"field",title:l,htmlFor:c},ie("span",{},Ai(e)),u)}if(n.type==="numbers"){let u=Array.isArray(a)?a:[],h=Array.from({length:n.count},(d,f)=>$d(`${o.join(".")}.${f}`,`${c}-${f}`,n.item,!0,u[f]));return h.forEach((d,f)=>{d.setAttribute("aria-label",`${Ai(e)}, ${f+1}`),d.addEventListener("change",()=>r(h.map(m=>m.valueAsNumber||n.item.minimum||0)))}),ie("div",{className:"field",title:l},ie("span",{},Ai(e)),ie("span",{className:"pair even"},...h))}return n.type==="group"?_b(i,e,t,s,r,o):xb(i,e,t,a,r,o)}function mb(i,e,t,n,s,r,o){let a=`option-${o.join("-")}`,l=s??t["x-default"],c=v=>{l=v??t["x-default"],r(v)},u="(object)",h=n.names.map(v=>ie("option",{value:v,title:n.help[v]??""},tn(v)));(t.nullable||t["x-default"]===void 0)&&h.unshift(ie("option",{value:""},t.nullable?"None":"Default"));let d=()=>l!==null&&typeof l=="object",f=n.other&&gb(i.openapi,n.other)?n.other:null;f?h.push(ie("option",{value:u},"Weighted sum")):d()&&h.push(ie("option",{value:u},"As in the request"));let m=ie("select",{name:o.join("."),id:a},...h);m.value=d()?u:String(l??"");let y=ie("p",{className:"help"}),g=ie("div",{className:"fields nested"}),_=()=>{if(y.textContent=i.describe(e,m.value)??n.help[m.value]??"",y.hidden=y.textContent==="",g.replaceChildren(),g.hidden=m.value!==u||!f,g.hidden||!f)return;let v=()=>d()?l:{};for(let[M,b]of Object.entries(f.properties??{})){let w=Hi(i.openapi,b),x=La(i.openapi,w);x&&g.append(Kd(i,M,w,x,v()[M],p=>c(Jg({...v(),[M]:p})),[...o,M]))}};return m.addEventListener("change",()=>{m.value===u?f&&c(Zg(i.openapi,f)):c(m.value===""?void 0:m.value),_()}),_(),ie("div",{className:"field choice"},ie("label",{htmlFor:a,title:t.description??""},Ai(e)),m,y,g)}var gb=(i,e)=>Object.values(e.properties??{}).length>0&&(e.required??[]).every(t=>La(i,Hi(i,e.properties[t])));function Zg(i,e){return Object.fromEntries((e.required??[]).map(t=>{let n=Hi(i,e.properties[t]),[s]=Object.keys(n.properties??{});return[t,s?{[s]:1}:n["x-default"]??n.enum?.[0]??1]}))}var Jg=i=>Object.fromEntries(Object.entries(i).filter(([,e])=>e!==void 0));function _b(i,e,t,n,s,r){let o=n??null,a=ie("div",{className:"fields nested"}),l=t.nullable===!0,c=()=>{a.replaceChildren(...Object.entries(t.properties??{}).map(([d,f])=>{let m=Hi(i.openapi,f);return Kd(i,d,m,La(i.openapi,m),o?.[d],y=>{o=Jg({...o,[d]:y}),s(o)},[...r,d])}))};if(!l)return c(),ie("fieldset",{className:"field group",title:t.description??""},ie("legend",{},Ai(e)),a);let u=ie("input",{type:"checkbox",name:r.join("."),id:`option-${r.join("-")}`,checked:o!==null}),h=()=>{a.hidden=o===null,a.replaceChildren(),o&&c()};return u.addEventListener("change",()=>{o=u.checked?Zg(i.openapi,t):null,s(o??void 0),h()}),h(),ie("div",{className:"field group"},ie("label",{className:"check",title:t.description??""},u,Ai(e)),a)}function $d(i,e,t,n,s){let r=t.minimum??(t.exclusiveMinimum!==void 0?t.exclusiveMinimum:void 0);return ie("input",{type:"number",name:i,id:e,step:n?"1":"any",value:s??"",placeholder:"auto",inputMode:"decimal",...r!==void 0&&{min:String(r)},...t.maximum!==void 0&&{max:String(t.maximum)}})}function xb(i,e,t,n,s,r){let o=n??{},a=Object.keys(t.properties??{}),l=a.find(f=>o[f]!==void 0&&o[f]!==null)??a[0],c=ie("select",{"aria-label":Ai(e),name:r.join(".")},...a.map(f=>ie("option",{value:f},tn(f))));c.value=l;let u=f=>Hi(i.openapi,t.properties[f]),h=f=>[u(f).type].flat().includes("integer"),d=$d(`${r.join(".")}.value`,`option-${r.join("-")}`,u(l),h(l),o[l]);return d.setAttribute("aria-label",`${Ai(e)}, value`),c.addEventListener("change",()=>{d.value="",d.step=h(c.value)?"1":"any",d.focus()}),d.addEventListener("change",()=>{d.checkValidity()?s(d.value===""?void 0:{[c.value]:d.valueAsNumber}):d.reportValidity()}),ie("div",{className:"field",title:t.description??""},ie("span",{},Ai(e)),ie("span",{className:"pair"},c,d))}var Oc={columns:6,names:["two-rails","helicoid","catenoid","tent","four-corners","ridge-rope","own-mesh","helicoid-relaxation","two-rings","rings-12-free","rings-12-best","rings-14-free","rings-14-best","rings-14-pinkall-polthier","cut-cylinder","three-rings","tetrahedron-loops","nested-loops","three-half-circles","three-half-circles-uneven","helicoid-liu-wang","scherk-relaxation","wavy-strip","contour-stack","wang-tang-i","wang-tang-ii","wang-tang-iii","wang-tang-iv","wang-tang-v","wang-tang-vi","latticed-roof","latticed-roof-steep","latticed-film","latticed-roof-few-lengths","floor-fewest-nodes","floor-equal-members","courtyard","plane-sail","four-point-sail","inflated-disc","vault"]};var Zd=[{title:"Tents",about:"Membranes on a boundary of their own",names:["tent","ridge-rope","four-corners","own-mesh"]},{title:"Canopies and soap films",about:"Several rings, every way to span them",names:[/rings/,/loops/,/half-circles/]},{title:"Strips",about:"Ruled surfaces that fold flat",names:["two-rails","wavy-strip","contour-stack",/^wang-tang/]},{title:"Gridshells and floors",about:"Lattices of equal members",names:[/^latticed/,"vault","courtyard",/^floor/]},{title:"Tensile structures",about:"Films with cables, pressure and weight",names:[/sail/,"inflated-disc"]},{title:"From the papers",about:"Helicoid, catenoid, Scherk and the methods that found them",names:[/./]}],vb={minimal_surface:5,ruled_surface:2,uniform_mesh:3,tensile_structure:4},bb=i=>i.replace(/ \((.*)\)$/,"").replace(/, every way to span them compared$/,", compared");function jg(i,e){let t=new Set(i),n=Zd.map((s,r)=>{let o=[...t].filter(a=>s.names.some(l=>typeof l=="string"?l===a.name:l.test(a.name))&&(r<Zd.length-1||t.has(a)));return o.forEach(a=>t.delete(a)),{...s,found:o}});for(let s of t)n[vb[s.kind]??Zd.length-1].found.push(s);return n.filter(({found:s})=>s.length>0).map(({title:s,about:r,found:o})=>ie("section",{},ie("h3",{},s,ie("small",{},r)),ie("div",{className:"cards"},...o.map(a=>{let l=ie("button",{type:"button",className:"card",title:a.title},Sb(a.name),ie("span",{},bb(a.title)));return l.dataset.example=a.name,l.addEventListener("click",()=>e(a)),l}))))}function Sb(i){let e=Oc.names.indexOf(i),t=ie("span",{className:"thumbnail"});if(t.setAttribute("aria-hidden","true"),e>=0){let{columns:n}=Oc,s=Math.ceil(Oc.names.length/n),[r,o]=[e%n,Math.floor(e/n)];t.style.backgroundSize=`${n*100}% ${s*100}%`,t.style.backgroundPosition=`${n>1?100*r/(n-1):0}% ${s>1?100*o/(s-1):0}%`}else t.classList.add("missing");return t}var Jd=0,Nc=0;async function Oa(i){Jd+=1,document.body.setAttribute("aria-busy","true");try{return await i()}finally{Jd-=1,document.body.setAttribute("aria-busy",String(Jd>0))}}var Na=(i,e,t)=>Oa(async()=>{Nc+=1;let n=Nc;try{let s=await i();n===Nc&&e(s)}catch(s){n===Nc&&t(s)}});var Ri=class{origin;metres;up;constructor(e,t){this.origin=e,this.metres=so(t),this.up=t.up==="y"?1:2}toScene(e){let[t,n,s]=[0,1,2].map(r=>((e[r]??0)-this.origin[r])*this.metres);return this.up===2?[t,s,-n]:[t,n,s]}fromScene([e,t,n]){return(this.up===2?[e,-n,t]:[e,t,n]).map((r,o)=>r/this.metres+this.origin[o])}length(e){return e/this.metres}},Mb=50;function Qg(i,e){let t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let a of i)for(let l of a.points){let c=Yt(l);if(c)for(let u=0;u<3;u+=1)t[u]=Math.min(t[u],c[u]),n[u]=Math.max(n[u],c[u])}if(!Number.isFinite(t[0]))return[0,0,0];let s=Math.max(...t.map((a,l)=>n[l]-a))||1,r=10**Math.ceil(Math.log10(s)),o=e.up==="y"?1:2;return t.map((a,l)=>{let c=l===o?a:(a+n[l])/2;return Math.abs(c)>Mb*s?Math.round(c/r)*r:0})}var q0=0,Vf=1,Y0=2;var xl=1,$0=2,Fo=3,ci=0,En=1,an=2,es=0,ko=1,Hf=2,Gf=3,Wf=4,K0=5;var kr=100,Z0=101,J0=102,j0=103,Q0=104,e_=200,t_=201,n_=202,i_=203,Xf=204,qf=205,s_=206,r_=207,o_=208,a_=209,l_=210,c_=211,u_=212,h_=213,d_=214,hu=0,du=1,fu=2,Mo=3,pu=4,mu=5,gu=6,_u=7,Nu=0,f_=1,p_=2,ts=0,Yf=1,$f=2,Kf=3,Zf=4,Jf=5,jf=6,yl=7,Af="attached",m_="detached",Qf=300,Br=301,Bo=302,Du=303,Uu=304,Zs=1e3,gi=1001,wo=1002,nn=1003,Fu=1004;var zr=1005;var hn=1006,zo=1007;var yi=1008;var si=1009,ep=1010,tp=1011,Vo=1012,ku=1013,vi=1014,Yn=1015,Oi=1016,Bu=1017,zu=1018,Vr=1020,np=35902,ip=35899,sp=1021,rp=1022,ti=1023,Ts=1026,Fs=1027,Vu=1028,vl=1029,nr=1030,Hu=1031;var Gu=1033,bl=33776,Sl=33777,Ml=33778,wl=33779,Wu=35840,Xu=35841,qu=35842,Yu=35843,$u=36196,Ku=37492,Zu=37496,Ju=37488,ju=37489,El=37490,Qu=37491,eh=37808,th=37809,nh=37810,ih=37811,sh=37812,rh=37813,oh=37814,ah=37815,lh=37816,ch=37817,uh=37818,hh=37819,dh=37820,fh=37821,ph=36492,mh=36494,gh=36495,_h=36283,xh=36284,Tl=36285,yh=36286;var Ir=2300,Lr=2301,cu=2302,Rf=2303,Cf=2400,Pf=2401,If=2402,g_=2500;var op=0,Al=1,Ho=2,__=3200;var Rl=0,x_=1,ks="",ln="srgb",$n="srgb-linear",qa="linear",Ct="srgb";var uu=7680;var y_=519,v_=512,b_=513,S_=514,ap=515,M_=516,w_=517,lp=518,cp=519,up=35044;var hp="300 es",_i=2e3,Eo=2001;function wb(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Eb(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function To(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function E_(){let i=To("canvas");return i.style.display="block",i}var e0={},Ao=null;function Ya(...i){let e="THREE."+i.shift();Ao?Ao("log",e,...i):console.log(e,...i)}function T_(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ue(...i){i=T_(i);let e="THREE."+i.shift();if(Ao)Ao("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Xe(...i){i=T_(i);let e="THREE."+i.shift();if(Ao)Ao("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Pr(...i){let e=i.join(" ");e in e0||(e0[e]=!0,Ue(...i))}function A_(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var R_={[hu]:hu,[fu]:gu,[pu]:pu,[Mo]:mu,[du]:du,[gu]:fu,[_u]:_u,[mu]:Mo},qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],t0=1234567,Wa=Math.PI/180,Or=180/Math.PI;function ns(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]+"-"+Un[e&255]+Un[e>>8&255]+"-"+Un[e>>16&15|64]+Un[e>>24&255]+"-"+Un[t&63|128]+Un[t>>8&255]+"-"+Un[t>>16&255]+Un[t>>24&255]+Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]).toLowerCase()}function Ze(i,e,t){return Math.max(e,Math.min(t,i))}function dp(i,e){return(i%e+e)%e}function Tb(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Ab(i,e,t){return i!==e?(t-i)/(e-i):0}function Xa(i,e,t){return(1-t)*i+t*e}function Rb(i,e,t,n){return Xa(i,e,1-Math.exp(-t*n))}function Cb(i,e=1){return e-Math.abs(dp(i,e*2)-e)}function Pb(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function Ib(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function Lb(i,e){return i+Math.floor(Math.random()*(e-i+1))}function Ob(i,e){return i+Math.random()*(e-i)}function Nb(i){return i*(.5-Math.random())}function Db(i){i!==void 0&&(t0=i);let e=t0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Ub(i){return i*Wa}function Fb(i){return i*Or}function kb(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function Bb(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function fp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function zb(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),m=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*d,a*c);break;case"YZY":i.set(l*d,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*d,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*f,a*c);break;case"YXY":i.set(l*f,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*f,a*u,a*c);break;default:Ue("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function vh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function pp(i,e){if(e.constructor===Float32Array)return i;let t=vh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function mp(i,e){if(e.constructor===Float32Array)return i;let t=vh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Go={DEG2RAD:Wa,RAD2DEG:Or,generateUUID:ns,clamp:Ze,euclideanModulo:dp,mapLinear:Tb,inverseLerp:Ab,lerp:Xa,damp:Rb,pingpong:Cb,smoothstep:Pb,smootherstep:Ib,randInt:Lb,randFloat:Ob,randFloatSpread:Nb,seededRandom:Db,degToRad:Ub,radToDeg:Fb,isPowerOfTwo:kb,ceilPowerOfTwo:Bb,floorPowerOfTwo:fp,setQuaternionFromProperEuler:zb,normalize:mp,denormalize:pp},Fe=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ze(this.x,e.x,t.x),this.y=Ze(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ze(this.x,e,t),this.y=Ze(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ze(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ze(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Kn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],m=r[o+2],y=r[o+3];if(h!==y||l!==d||c!==f||u!==m){let g=l*d+c*f+u*m+h*y;g<0&&(d=-d,f=-f,m=-m,y=-y,g=-g);let _=1-a;if(g<.9995){let v=Math.acos(g),M=Math.sin(v);_=Math.sin(_*v)/M,a=Math.sin(a*v)/M,l=l*_+d*a,c=c*_+f*a,u=u*_+m*a,h=h*_+y*a}else{l=l*_+d*a,c=c*_+f*a,u=u*_+m*a,h=h*_+y*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return e[t]=a*m+u*h+l*f-c*d,e[t+1]=l*m+u*d+c*h-a*f,e[t+2]=c*m+u*f+a*d-l*h,e[t+3]=u*m-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:Ue("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ze(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(n0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(n0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ze(this.x,e.x,t.x),this.y=Ze(this.y,e.y,t.y),this.z=Ze(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ze(this.x,e,t),this.y=Ze(this.y,e,t),this.z=Ze(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ze(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return jd.copy(this).projectOnVector(e),this.sub(jd)}reflect(e){return this.sub(jd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ze(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},jd=new P,n0=new Kn,Ke=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],f=n[5],m=n[8],y=s[0],g=s[3],_=s[6],v=s[1],M=s[4],b=s[7],w=s[2],x=s[5],p=s[8];return r[0]=o*y+a*v+l*w,r[3]=o*g+a*M+l*x,r[6]=o*_+a*b+l*p,r[1]=c*y+u*v+h*w,r[4]=c*g+u*M+h*x,r[7]=c*_+u*b+h*p,r[2]=d*y+f*v+m*w,r[5]=d*g+f*M+m*x,r[8]=d*_+f*b+m*p,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,m=t*h+n*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/m;return e[0]=h*y,e[1]=(s*c-u*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=f*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Pr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Qd.makeScale(e,t)),this}rotate(e){return Pr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Qd.makeRotation(-e)),this}translate(e,t){return Pr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Qd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Qd=new Ke,i0=new Ke().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),s0=new Ke().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Vb(){let i={enabled:!0,workingColorSpace:$n,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=ws(s.r),s.g=ws(s.g),s.b=ws(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=So(s.r),s.g=So(s.g),s.b=So(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ks?qa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[$n]:{primaries:e,whitePoint:n,transfer:qa,toXYZ:i0,fromXYZ:s0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ln},outputColorSpaceConfig:{drawingBufferColorSpace:ln}},[ln]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:i0,fromXYZ:s0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ln}}}),i}var it=Vb();function ws(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function So(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var ro,xu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{ro===void 0&&(ro=To("canvas")),ro.width=e.width,ro.height=e.height;let s=ro.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=ro}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=To("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ws(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ws(t[n]/255)*255):t[n]=ws(t[n]);return{data:t,width:e.width,height:e.height}}else return Ue("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Hb=0,Ro=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Hb++}),this.uuid=ns(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ef(s[o].image)):r.push(ef(s[o]))}else r=ef(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function ef(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?xu.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ue("Texture: Unable to serialize Texture."),{})}var Gb=0,tf=new P,vn=class i extends qi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=gi,s=gi,r=hn,o=yi,a=ti,l=si,c=i.DEFAULT_ANISOTROPY,u=ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Gb++}),this.uuid=ns(),this.name="",this.source=new Ro(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Fe(0,0),this.repeat=new Fe(1,1),this.center=new Fe(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ke,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(tf).x}get height(){return this.source.getSize(tf).y}get depth(){return this.source.getSize(tf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ue(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ue(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Zs:e.x=e.x-Math.floor(e.x);break;case gi:e.x=e.x<0?0:1;break;case wo:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Zs:e.y=e.y-Math.floor(e.y);break;case gi:e.y=e.y<0?0:1;break;case wo:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};vn.DEFAULT_IMAGE=null;vn.DEFAULT_MAPPING=Qf;vn.DEFAULT_ANISOTROPY=1;var ct=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],y=l[2],g=l[6],_=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-y)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+y)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(f+1)/2,w=(_+1)/2,x=(u+d)/4,p=(h+y)/4,S=(m+g)/4;return M>b&&M>w?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=x/n,r=p/n):b>w?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=x/s,r=S/s):w<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(w),n=p/r,s=S/r),this.set(n,s,r,t),this}let v=Math.sqrt((g-m)*(g-m)+(h-y)*(h-y)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(g-m)/v,this.y=(h-y)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ze(this.x,e.x,t.x),this.y=Ze(this.y,e.y,t.y),this.z=Ze(this.z,e.z,t.z),this.w=Ze(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ze(this.x,e,t),this.y=Ze(this.y,e,t),this.z=Ze(this.z,e,t),this.w=Ze(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ze(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},yu=class extends qi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:hn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new ct(0,0,e,t),this.scissorTest=!1,this.viewport=new ct(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new vn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:hn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ro(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},zn=class extends yu{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},$a=class extends vn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=nn,this.minFilter=nn,this.wrapR=gi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var vu=class extends vn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=nn,this.minFilter=nn,this.wrapR=gi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ce=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,d,f,m,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,f,m,y,g)}set(e,t,n,s,r,o,a,l,c,u,h,d,f,m,y,g){let _=this.elements;return _[0]=e,_[4]=t,_[8]=n,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=h,_[14]=d,_[3]=f,_[7]=m,_[11]=y,_[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/oo.setFromMatrixColumn(e,0).length(),r=1/oo.setFromMatrixColumn(e,1).length(),o=1/oo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,m=a*u,y=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+m*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,m=c*u,y=c*h;t[0]=d+y*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,m=c*u,y=c*h;t[0]=d-y*a,t[4]=-o*h,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,m=a*u,y=a*h;t[0]=l*u,t[4]=m*c-f,t[8]=d*c+y,t[1]=l*h,t[5]=y*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,y=a*c;t[0]=l*u,t[4]=y-d*h,t[8]=m*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+m,t[10]=d-y*h}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,y=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+y,t[5]=o*u,t[9]=f*h-m,t[2]=m*h-f,t[6]=a*u,t[10]=y*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Wb,e,Xb)}lookAt(e,t,n){let s=this.elements;return ai.subVectors(e,t),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),Ws.crossVectors(n,ai),Ws.lengthSq()===0&&(Math.abs(n.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),Ws.crossVectors(n,ai)),Ws.normalize(),Dc.crossVectors(ai,Ws),s[0]=Ws.x,s[4]=Dc.x,s[8]=ai.x,s[1]=Ws.y,s[5]=Dc.y,s[9]=ai.y,s[2]=Ws.z,s[6]=Dc.z,s[10]=ai.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],f=n[13],m=n[2],y=n[6],g=n[10],_=n[14],v=n[3],M=n[7],b=n[11],w=n[15],x=s[0],p=s[4],S=s[8],A=s[12],E=s[1],C=s[5],I=s[9],D=s[13],L=s[2],U=s[6],V=s[10],B=s[14],ne=s[3],z=s[7],q=s[11],W=s[15];return r[0]=o*x+a*E+l*L+c*ne,r[4]=o*p+a*C+l*U+c*z,r[8]=o*S+a*I+l*V+c*q,r[12]=o*A+a*D+l*B+c*W,r[1]=u*x+h*E+d*L+f*ne,r[5]=u*p+h*C+d*U+f*z,r[9]=u*S+h*I+d*V+f*q,r[13]=u*A+h*D+d*B+f*W,r[2]=m*x+y*E+g*L+_*ne,r[6]=m*p+y*C+g*U+_*z,r[10]=m*S+y*I+g*V+_*q,r[14]=m*A+y*D+g*B+_*W,r[3]=v*x+M*E+b*L+w*ne,r[7]=v*p+M*C+b*U+w*z,r[11]=v*S+M*I+b*V+w*q,r[15]=v*A+M*D+b*B+w*W,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],m=e[3],y=e[7],g=e[11],_=e[15],v=l*f-c*d,M=a*f-c*h,b=a*d-l*h,w=o*f-c*u,x=o*d-l*u,p=o*h-a*u;return t*(y*v-g*M+_*b)-n*(m*v-g*w+_*x)+s*(m*M-y*w+_*p)-r*(m*b-y*x+g*p)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],m=e[12],y=e[13],g=e[14],_=e[15],v=t*a-n*o,M=t*l-s*o,b=t*c-r*o,w=n*l-s*a,x=n*c-r*a,p=s*c-r*l,S=u*y-h*m,A=u*g-d*m,E=u*_-f*m,C=h*g-d*y,I=h*_-f*y,D=d*_-f*g,L=v*D-M*I+b*C+w*E-x*A+p*S;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let U=1/L;return e[0]=(a*D-l*I+c*C)*U,e[1]=(s*I-n*D-r*C)*U,e[2]=(y*p-g*x+_*w)*U,e[3]=(d*x-h*p-f*w)*U,e[4]=(l*E-o*D-c*A)*U,e[5]=(t*D-s*E+r*A)*U,e[6]=(g*b-m*p-_*M)*U,e[7]=(u*p-d*b+f*M)*U,e[8]=(o*I-a*E+c*S)*U,e[9]=(n*E-t*I-r*S)*U,e[10]=(m*x-y*b+_*v)*U,e[11]=(h*b-u*x-f*v)*U,e[12]=(a*A-o*C-l*S)*U,e[13]=(t*C-n*A+s*S)*U,e[14]=(y*M-m*w-g*v)*U,e[15]=(u*w-h*M+d*v)*U,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,m=r*h,y=o*u,g=o*h,_=a*h,v=l*c,M=l*u,b=l*h,w=n.x,x=n.y,p=n.z;return s[0]=(1-(y+_))*w,s[1]=(f+b)*w,s[2]=(m-M)*w,s[3]=0,s[4]=(f-b)*x,s[5]=(1-(d+_))*x,s[6]=(g+v)*x,s[7]=0,s[8]=(m+M)*p,s[9]=(g-v)*p,s[10]=(1-(d+y))*p,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=oo.set(s[0],s[1],s[2]).length(),a=oo.set(s[4],s[5],s[6]).length(),l=oo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,u=1/a,h=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=h,Ci.elements[9]*=h,Ci.elements[10]*=h,t.setFromRotationMatrix(Ci),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=_i,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),m,y;if(l)m=r/(o-r),y=o*r/(o-r);else if(a===_i)m=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Eo)m=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=_i,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),m,y;if(l)m=1/(o-r),y=o/(o-r);else if(a===_i)m=-2/(o-r),y=-(o+r)/(o-r);else if(a===Eo)m=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},oo=new P,Ci=new Ce,Wb=new P(0,0,0),Xb=new P(1,1,1),Ws=new P,Dc=new P,ai=new P,r0=new Ce,o0=new Kn,Yi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ze(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Ze(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ze(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Ze(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Ze(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ze(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ue("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return r0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(r0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return o0.setFromEuler(this),this.setFromQuaternion(o0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Yi.DEFAULT_ORDER="XYZ";var Co=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},qb=0,a0=new P,ao=new Kn,xs=new Ce,Uc=new P,Da=new P,Yb=new P,$b=new Kn,l0=new P(1,0,0),c0=new P(0,1,0),u0=new P(0,0,1),h0={type:"added"},Kb={type:"removed"},lo={type:"childadded",child:null},nf={type:"childremoved",child:null},Jt=class i extends qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:qb++}),this.uuid=ns(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new P,t=new Yi,n=new Kn,s=new P(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ce},normalMatrix:{value:new Ke}}),this.matrix=new Ce,this.matrixWorld=new Ce,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Co,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.multiply(ao),this}rotateOnWorldAxis(e,t){return ao.setFromAxisAngle(e,t),this.quaternion.premultiply(ao),this}rotateX(e){return this.rotateOnAxis(l0,e)}rotateY(e){return this.rotateOnAxis(c0,e)}rotateZ(e){return this.rotateOnAxis(u0,e)}translateOnAxis(e,t){return a0.copy(e).applyQuaternion(this.quaternion),this.position.add(a0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(l0,e)}translateY(e){return this.translateOnAxis(c0,e)}translateZ(e){return this.translateOnAxis(u0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Uc.copy(e):Uc.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Da.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xs.lookAt(Da,Uc,this.up):xs.lookAt(Uc,Da,this.up),this.quaternion.setFromRotationMatrix(xs),s&&(xs.extractRotation(s.matrixWorld),ao.setFromRotationMatrix(xs),this.quaternion.premultiply(ao.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Xe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(h0),lo.child=e,this.dispatchEvent(lo),lo.child=null):Xe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Kb),nf.child=e,this.dispatchEvent(nf),nf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xs.multiply(e.parent.matrixWorld)),e.applyMatrix4(xs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(h0),lo.child=e,this.dispatchEvent(lo),lo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Da,e,Yb),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Da,$b,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),m.length>0&&(n.nodes=m)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Jt.DEFAULT_UP=new P(0,1,0);Jt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Jt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var yn=class extends Jt{constructor(){super(),this.isGroup=!0,this.type="Group"}},Zb={type:"move"},Po=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new yn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new yn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new yn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let g=t.getJointPose(y,n),_=this._getHandJoint(c,y);g!==null&&(_.matrix.fromArray(g.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=g.radius),_.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Zb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new yn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},C_={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xs={h:0,s:0,l:0},Fc={h:0,s:0,l:0};function sf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var De=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ln){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,it.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=it.workingColorSpace){return this.r=e,this.g=t,this.b=n,it.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=it.workingColorSpace){if(e=dp(e,1),t=Ze(t,0,1),n=Ze(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=sf(o,r,e+1/3),this.g=sf(o,r,e),this.b=sf(o,r,e-1/3)}return it.colorSpaceToWorking(this,s),this}setStyle(e,t=ln){function n(r){r!==void 0&&parseFloat(r)<1&&Ue("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ue("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ue("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ln){let n=C_[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ue("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ws(e.r),this.g=ws(e.g),this.b=ws(e.b),this}copyLinearToSRGB(e){return this.r=So(e.r),this.g=So(e.g),this.b=So(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ln){return it.workingToColorSpace(Fn.copy(this),e),Math.round(Ze(Fn.r*255,0,255))*65536+Math.round(Ze(Fn.g*255,0,255))*256+Math.round(Ze(Fn.b*255,0,255))}getHexString(e=ln){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=it.workingColorSpace){it.workingToColorSpace(Fn.copy(this),t);let n=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=it.workingColorSpace){return it.workingToColorSpace(Fn.copy(this),t),e.r=Fn.r,e.g=Fn.g,e.b=Fn.b,e}getStyle(e=ln){it.workingToColorSpace(Fn.copy(this),e);let t=Fn.r,n=Fn.g,s=Fn.b;return e!==ln?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Xs),this.setHSL(Xs.h+e,Xs.s+t,Xs.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Xs),e.getHSL(Fc);let n=Xa(Xs.h,Fc.h,t),s=Xa(Xs.s,Fc.s,t),r=Xa(Xs.l,Fc.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new De;De.NAMES=C_;var Ka=class extends Jt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Yi,this.environmentIntensity=1,this.environmentRotation=new Yi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Pi=new P,ys=new P,rf=new P,vs=new P,co=new P,uo=new P,d0=new P,of=new P,af=new P,lf=new P,cf=new ct,uf=new ct,hf=new ct,Bn=class i{constructor(e=new P,t=new P,n=new P){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Pi.subVectors(e,t),s.cross(Pi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Pi.subVectors(s,t),ys.subVectors(n,t),rf.subVectors(e,t);let o=Pi.dot(Pi),a=Pi.dot(ys),l=Pi.dot(rf),c=ys.dot(ys),u=ys.dot(rf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,vs)===null?!1:vs.x>=0&&vs.y>=0&&vs.x+vs.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,vs.x),l.addScaledVector(o,vs.y),l.addScaledVector(a,vs.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return cf.setScalar(0),uf.setScalar(0),hf.setScalar(0),cf.fromBufferAttribute(e,t),uf.fromBufferAttribute(e,n),hf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(cf,r.x),o.addScaledVector(uf,r.y),o.addScaledVector(hf,r.z),o}static isFrontFacing(e,t,n,s){return Pi.subVectors(n,t),ys.subVectors(e,t),Pi.cross(ys).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Pi.subVectors(this.c,this.b),ys.subVectors(this.a,this.b),Pi.cross(ys).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;co.subVectors(s,n),uo.subVectors(r,n),of.subVectors(e,n);let l=co.dot(of),c=uo.dot(of);if(l<=0&&c<=0)return t.copy(n);af.subVectors(e,s);let u=co.dot(af),h=uo.dot(af);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(co,o);lf.subVectors(e,r);let f=co.dot(lf),m=uo.dot(lf);if(m>=0&&f<=m)return t.copy(r);let y=f*c-l*m;if(y<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(uo,a);let g=u*m-f*h;if(g<=0&&h-u>=0&&f-m>=0)return d0.subVectors(r,s),a=(h-u)/(h-u+(f-m)),t.copy(s).addScaledVector(d0,a);let _=1/(g+y+d);return o=y*_,a=d*_,t.copy(n).addScaledVector(co,o).addScaledVector(uo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},et=class{constructor(e=new P(1/0,1/0,1/0),t=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Ii.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Ii.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Ii.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ii):Ii.fromBufferAttribute(r,o),Ii.applyMatrix4(e.matrixWorld),this.expandByPoint(Ii);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),kc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),kc.copy(n.boundingBox)),kc.applyMatrix4(e.matrixWorld),this.union(kc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ii),Ii.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ua),Bc.subVectors(this.max,Ua),ho.subVectors(e.a,Ua),fo.subVectors(e.b,Ua),po.subVectors(e.c,Ua),qs.subVectors(fo,ho),Ys.subVectors(po,fo),Er.subVectors(ho,po);let t=[0,-qs.z,qs.y,0,-Ys.z,Ys.y,0,-Er.z,Er.y,qs.z,0,-qs.x,Ys.z,0,-Ys.x,Er.z,0,-Er.x,-qs.y,qs.x,0,-Ys.y,Ys.x,0,-Er.y,Er.x,0];return!df(t,ho,fo,po,Bc)||(t=[1,0,0,0,1,0,0,0,1],!df(t,ho,fo,po,Bc))?!1:(zc.crossVectors(qs,Ys),t=[zc.x,zc.y,zc.z],df(t,ho,fo,po,Bc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ii).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ii).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(bs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),bs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),bs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),bs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),bs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),bs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),bs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),bs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(bs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},bs=[new P,new P,new P,new P,new P,new P,new P,new P],Ii=new P,kc=new et,ho=new P,fo=new P,po=new P,qs=new P,Ys=new P,Er=new P,Ua=new P,Bc=new P,zc=new P,Tr=new P;function df(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Tr.fromArray(i,r);let a=s.x*Math.abs(Tr.x)+s.y*Math.abs(Tr.y)+s.z*Math.abs(Tr.z),l=e.dot(Tr),c=t.dot(Tr),u=n.dot(Tr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var on=new P,Vc=new Fe,Jb=0,gt=class extends qi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Jb++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=up,this.updateRanges=[],this.gpuType=Yn,this.version=0,this._normalizationScale=e!==void 0?vh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Vc.fromBufferAttribute(this,t),Vc.applyMatrix3(e),this.setXY(t,Vc.x,Vc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.applyMatrix3(e),this.setXYZ(t,on.x,on.y,on.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.applyMatrix4(e),this.setXYZ(t,on.x,on.y,on.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.applyNormalMatrix(e),this.setXYZ(t,on.x,on.y,on.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)on.fromBufferAttribute(this,t),on.transformDirection(e),this.setXYZ(t,on.x,on.y,on.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):pp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):mp(e,this.array)}};var Za=class extends gt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ja=class extends gt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var un=class extends gt{constructor(e,t,n){super(new Float32Array(e),t,n)}},jb=new et,Fa=new P,ff=new P,zt=class{constructor(e=new P,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):jb.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Fa.subVectors(e,this.center);let t=Fa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Fa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(ff.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Fa.copy(e.center).add(ff)),this.expandByPoint(Fa.copy(e.center).sub(ff))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Qb=0,mi=new Ce,pf=new Jt,mo=new P,li=new et,ka=new et,xn=new P,$t=class i extends qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Qb++}),this.uuid=ns(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(wb(e)?Ja:Za)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Ke().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return mi.makeRotationFromQuaternion(e),this.applyMatrix4(mi),this}rotateX(e){return mi.makeRotationX(e),this.applyMatrix4(mi),this}rotateY(e){return mi.makeRotationY(e),this.applyMatrix4(mi),this}rotateZ(e){return mi.makeRotationZ(e),this.applyMatrix4(mi),this}translate(e,t,n){return mi.makeTranslation(e,t,n),this.applyMatrix4(mi),this}scale(e,t,n){return mi.makeScale(e,t,n),this.applyMatrix4(mi),this}lookAt(e){return pf.lookAt(e),pf.updateMatrix(),this.applyMatrix4(pf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(mo).negate(),this.translate(mo.x,mo.y,mo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new un(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ue("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new et);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Xe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];li.setFromBufferAttribute(r),this.morphTargetsRelative?(xn.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(xn),xn.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(xn)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Xe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zt);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Xe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(e){let n=this.boundingSphere.center;if(li.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ka.setFromBufferAttribute(a),this.morphTargetsRelative?(xn.addVectors(li.min,ka.min),li.expandByPoint(xn),xn.addVectors(li.max,ka.max),li.expandByPoint(xn)):(li.expandByPoint(ka.min),li.expandByPoint(ka.max))}li.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)xn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(xn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)xn.fromBufferAttribute(a,c),l&&(mo.fromBufferAttribute(e,c),xn.add(mo)),s=Math.max(s,n.distanceToSquared(xn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Xe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Xe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new gt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let A=0;A<n.count;A++)a[A]=new P,l[A]=new P;let u=new P,h=new P,d=new P,f=new Fe,m=new Fe,y=new Fe,g=new P,_=new P;function v(A,E,C){c[A]=c[E]=c[C]=1,u.fromBufferAttribute(n,A),h.fromBufferAttribute(n,E),d.fromBufferAttribute(n,C),f.fromBufferAttribute(r,A),m.fromBufferAttribute(r,E),y.fromBufferAttribute(r,C),h.sub(u),d.sub(u),m.sub(f),y.sub(f);let I=1/(m.x*y.y-y.x*m.y);isFinite(I)&&(g.copy(h).multiplyScalar(y.y).addScaledVector(d,-m.y).multiplyScalar(I),_.copy(d).multiplyScalar(m.x).addScaledVector(h,-y.x).multiplyScalar(I),a[A].add(g),a[E].add(g),a[C].add(g),l[A].add(_),l[E].add(_),l[C].add(_))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let A=0,E=M.length;A<E;++A){let C=M[A],I=C.start,D=C.count;for(let L=I,U=I+D;L<U;L+=3)v(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let b=new P,w=new P,x=new P,p=new P;function S(A){x.fromBufferAttribute(s,A),p.copy(x);let E=a[A];b.copy(E),b.sub(x.multiplyScalar(x.dot(E))).normalize(),w.crossVectors(p,E);let I=w.dot(l[A])<0?-1:1;o.setXYZW(A,b.x,b.y,b.z,I)}for(let A=0,E=n.count;A<E;++A)c[A]&&S(A);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new gt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new P,r=new P,o=new P,a=new P,l=new P,c=new P,u=new P,h=new P;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),y=e.getX(d+1),g=e.getX(d+2);s.fromBufferAttribute(t,m),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,g),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)xn.fromBufferAttribute(e,t),xn.normalize(),e.setXYZ(t,xn.x,xn.y,xn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?f=l[y]*a.data.stride+a.offset:f=l[y]*u;for(let _=0;_<u;_++)d[m++]=c[f++]}return new gt(d,u,h)}if(this.index===null)return Ue("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Nr=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=up,this.updateRanges=[],this.version=0,this.uuid=ns()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=f0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=f0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function f0(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=ns()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var Xn=new P,ni=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?vh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)Xn.fromBufferAttribute(this,t),Xn.applyMatrix4(e),this.setXYZ(t,Xn.x,Xn.y,Xn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Xn.fromBufferAttribute(this,t),Xn.applyNormalMatrix(e),this.setXYZ(t,Xn.x,Xn.y,Xn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Xn.fromBufferAttribute(this,t),Xn.transformDirection(e),this.setXYZ(t,Xn.x,Xn.y,Xn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Ya("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new gt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ya("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):pp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):mp(e,this.data.array)}},mf=new P,eS=new P,tS=new Ke,qn=class{constructor(e=new P(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=mf.subVectors(n,t).cross(eS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(mf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||tS.getNormalMatrix(e),s=this.coplanarPoint(mf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},nS=0,Zn=class extends qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:nS++}),this.uuid=ns(),this.name="",this.type="Material",this.blending=ko,this.side=ci,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Xf,this.blendDst=qf,this.blendEquation=kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new De(0,0,0),this.blendAlpha=0,this.depthFunc=Mo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=y_,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uu,this.stencilZFail=uu,this.stencilZPass=uu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ue(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ue(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new De().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new qn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Fe().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Fe().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ss=new P,gf=new P,Hc=new P,Gc=new P,$i=class{constructor(e=new P,t=new P(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ss)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ss.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ss.copy(this.origin).addScaledVector(this.direction,t),Ss.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){gf.copy(e).add(t).multiplyScalar(.5),Hc.copy(t).sub(e).normalize(),Gc.copy(this.origin).sub(gf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Hc),a=Gc.dot(this.direction),l=-Gc.dot(Hc),c=Gc.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=r*u,h>=0)if(d>=-m)if(d<=m){let y=1/u;h*=y,d*=y,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(gf).addScaledVector(Hc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Ss.subVectors(e.center,this.origin);let n=Ss.dot(this.direction),s=Ss.dot(Ss)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Ss)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,y=t.y-o.y,g=t.z-o.z,_=n.x-o.x,v=n.y-o.y,M=n.z-o.z,b=Math.abs(l),w=Math.abs(c),x=Math.abs(u),p,S,A,E,C,I,D,L,U,V,B,ne;if(b>=w&&b>=x?(A=l,I=h,U=m,ne=_,l>=0?(p=c,S=u,E=d,C=f,D=y,L=g,V=v,B=M):(p=u,S=c,E=f,C=d,D=g,L=y,V=M,B=v)):w>=x?(A=c,I=d,U=y,ne=v,c>=0?(p=u,S=l,E=f,C=h,D=g,L=m,V=M,B=_):(p=l,S=u,E=h,C=f,D=m,L=g,V=_,B=M)):(A=u,I=f,U=g,ne=M,u>=0?(p=l,S=c,E=h,C=d,D=m,L=y,V=_,B=v):(p=c,S=l,E=d,C=h,D=y,L=m,V=v,B=_)),A===0)return null;let z=p/A,q=S/A,W=1/A,_e=E-z*I,Te=C-q*I,$=D-z*U,ae=L-q*U,se=V-z*ne,ce=B-q*ne,re=se*ae-ce*$,de=_e*ce-Te*se,Ye=$*Te-ae*_e;if(s){if(re<0||de<0||Ye<0)return null}else if((re<0||de<0||Ye<0)&&(re>0||de>0||Ye>0))return null;let Ae=re+de+Ye;if(Ae===0)return null;let Be=W*(re*I+de*U+Ye*ne);return(Ae>0?Be<0:Be>0)?null:this.at(Be/Ae,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},xi=class extends Zn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new De(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yi,this.combine=Nu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},p0=new Ce,Ar=new $i,Wc=new zt,m0=new P,Xc=new P,qc=new P,Yc=new P,_f=new P,$c=new P,g0=new P,Kc=new P,Pt=class extends Jt{constructor(e=new $t,t=new xi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){$c.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(_f.fromBufferAttribute(h,e),o?$c.addScaledVector(_f,u):$c.addScaledVector(_f.sub(t),u))}t.add($c)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Wc.copy(n.boundingSphere),Wc.applyMatrix4(r),Ar.copy(e.ray).recast(e.near),!(Wc.containsPoint(Ar.origin)===!1&&(Ar.intersectSphere(Wc,m0)===null||Ar.origin.distanceToSquared(m0)>(e.far-e.near)**2))&&(p0.copy(r).invert(),Ar.copy(e.ray).applyMatrix4(p0),!(n.boundingBox!==null&&Ar.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ar)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,y=d.length;m<y;m++){let g=d[m],_=o[g.materialIndex],v=Math.max(g.start,f.start),M=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=v,w=M;b<w;b+=3){let x=a.getX(b),p=a.getX(b+1),S=a.getX(b+2);s=Zc(this,_,e,n,c,u,h,x,p,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),y=Math.min(a.count,f.start+f.count);for(let g=m,_=y;g<_;g+=3){let v=a.getX(g),M=a.getX(g+1),b=a.getX(g+2);s=Zc(this,o,e,n,c,u,h,v,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,y=d.length;m<y;m++){let g=d[m],_=o[g.materialIndex],v=Math.max(g.start,f.start),M=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let b=v,w=M;b<w;b+=3){let x=b,p=b+1,S=b+2;s=Zc(this,_,e,n,c,u,h,x,p,S),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let m=Math.max(0,f.start),y=Math.min(l.count,f.start+f.count);for(let g=m,_=y;g<_;g+=3){let v=g,M=g+1,b=g+2;s=Zc(this,o,e,n,c,u,h,v,M,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function iS(i,e,t,n,s,r,o,a){let l;if(e.side===En?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===ci,a),l===null)return null;Kc.copy(a),Kc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Kc);return c<t.near||c>t.far?null:{distance:c,point:Kc.clone(),object:i}}function Zc(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,Xc),i.getVertexPosition(l,qc),i.getVertexPosition(c,Yc);let u=iS(i,e,t,n,Xc,qc,Yc,g0);if(u){let h=new P;Bn.getBarycoord(g0,Xc,qc,Yc,h),s&&(u.uv=Bn.getInterpolatedAttribute(s,a,l,c,h,new Fe)),r&&(u.uv1=Bn.getInterpolatedAttribute(r,a,l,c,h,new Fe)),o&&(u.normal=Bn.getInterpolatedAttribute(o,a,l,c,h,new P),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new P,materialIndex:0};Bn.getNormal(Xc,qc,Yc,d.normal),u.face=d,u.barycoord=h}return u}var Ba=new ct,_0=new ct,x0=new ct,sS=new ct,y0=new Ce,Jc=new P,xf=new zt,v0=new Ce,yf=new $i,ja=class extends Pt{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Af,this.bindMatrix=new Ce,this.bindMatrixInverse=new Ce,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new et),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Jc),this.boundingBox.expandByPoint(Jc)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new zt),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Jc),this.boundingSphere.expandByPoint(Jc)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,s=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),xf.copy(this.boundingSphere),xf.applyMatrix4(s),e.ray.intersectsSphere(xf)!==!1&&(v0.copy(s).invert(),yf.copy(e.ray).applyMatrix4(v0),!(this.boundingBox!==null&&yf.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,yf)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new ct,t=this.geometry.attributes.skinWeight;for(let n=0,s=t.count;n<s;n++){e.fromBufferAttribute(t,n);let r=1/e.manhattanLength();r!==1/0?e.multiplyScalar(r):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===Af?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===m_?this.bindMatrixInverse.copy(this.bindMatrix).invert():Ue("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,s=this.geometry;_0.fromBufferAttribute(s.attributes.skinIndex,e),x0.fromBufferAttribute(s.attributes.skinWeight,e),t.isVector4?(Ba.copy(t),t.set(0,0,0,0)):(Ba.set(t.x,t.y,t.z,1),t.set(0,0,0)),Ba.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=x0.getComponent(r);if(o!==0){let a=_0.getComponent(r);y0.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(sS.copy(Ba).applyMatrix4(y0),o)}}return t.isVector4&&(t.w=Ba.w),t.applyMatrix4(this.bindMatrixInverse)}},Io=class extends Jt{constructor(){super(),this.isBone=!0,this.type="Bone"}},Es=class extends vn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=nn,u=nn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},b0=new Ce,rS=new Ce,Qa=class i{constructor(e=[],t=[]){this.uuid=ns(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){Ue("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,s=this.bones.length;n<s;n++)this.boneInverses.push(new Ce)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new Ce;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,s=this.boneTexture;for(let r=0,o=e.length;r<o;r++){let a=e[r]?e[r].matrixWorld:rS;b0.multiplyMatrices(a,t[r]),b0.toArray(n,r*16)}s!==null&&(s.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new Es(t,e,e,ti,Yn);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let s=this.bones[t];if(s.name===e)return s}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,s=e.bones.length;n<s;n++){let r=e.bones[n],o=t[r];o===void 0&&(Ue("Skeleton: No bone found with UUID:",r),o=new Io),this.bones.push(o),this.boneInverses.push(new Ce().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let s=0,r=t.length;s<r;s++){let o=t[s];e.bones.push(o.uuid);let a=n[s];e.boneInverses.push(a.toArray())}return e}},As=class extends gt{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},go=new Ce,S0=new Ce,jc=[],M0=new et,oS=new Ce,za=new Pt,Va=new zt,el=class extends Pt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new As(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,oS)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new et),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,go),M0.copy(e.boundingBox).applyMatrix4(go),this.boundingBox.union(M0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new zt),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,go),Va.copy(e.boundingSphere).applyMatrix4(go),this.boundingSphere.union(Va)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(za.geometry=this.geometry,za.material=this.material,za.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Va.copy(this.boundingSphere),Va.applyMatrix4(n),e.ray.intersectsSphere(Va)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,go),S0.multiplyMatrices(n,go),za.matrixWorld=S0,za.raycast(e,jc);for(let o=0,a=jc.length;o<a;o++){let l=jc[o];l.instanceId=r,l.object=this,t.push(l)}jc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new As(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Es(new Float32Array(s*this.count),s,this.count,Vu,Yn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Rr=new zt,aS=new Fe(.5,.5),Qc=new P,Rs=class{constructor(e=new qn,t=new qn,n=new qn,s=new qn,r=new qn,o=new qn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=_i,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],m=r[8],y=r[9],g=r[10],_=r[11],v=r[12],M=r[13],b=r[14],w=r[15];if(s[0].setComponents(c-o,f-u,_-m,w-v).normalize(),s[1].setComponents(c+o,f+u,_+m,w+v).normalize(),s[2].setComponents(c+a,f+h,_+y,w+M).normalize(),s[3].setComponents(c-a,f-h,_-y,w-M).normalize(),n)s[4].setComponents(l,d,g,b).normalize(),s[5].setComponents(c-l,f-d,_-g,w-b).normalize();else if(s[4].setComponents(c-l,f-d,_-g,w-b).normalize(),t===_i)s[5].setComponents(c+l,f+d,_+g,w+b).normalize();else if(t===Eo)s[5].setComponents(l,d,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Rr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Rr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Rr)}intersectsSprite(e){Rr.center.set(0,0,0);let t=aS.distanceTo(e.center);return Rr.radius=.7071067811865476+t,Rr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Rr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Qc.x=s.normal.x>0?e.max.x:e.min.x,Qc.y=s.normal.y>0?e.max.y:e.min.y,Qc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Qc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},w0=new Ce,tl=class i{constructor(){this.coordinateSystem=_i,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];w0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Rs),n[s].setFromProjectionMatrix(w0,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Rs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};function vf(i,e){return i-e}function lS(i,e){return i.z-e.z}function cS(i,e){return e.z-i.z}var Lf=class{constructor(){this.index=0,this.pool=[],this.list=[]}push(e,t,n,s){let r=this.pool,o=this.list;this.index>=r.length&&r.push({start:-1,count:-1,z:-1,index:-1});let a=r[this.index];o.push(a),this.index++,a.start=e,a.count=t,a.z=n,a.index=s}reset(){this.list.length=0,this.index=0}},ei=new Ce,uS=new De(1,1,1),hS=new Rs,dS=new tl,eu=new et,Cr=new zt,bf=new P,E0=new P,T0=new P,fS=new P,Sf=new Lf,kn=new Pt,tu=[];function pS(i,e,t=0){let n=e.itemSize;if(i.isInterleavedBufferAttribute||i.array.constructor!==e.array.constructor){let s=i.count;for(let r=0;r<s;r++)for(let o=0;o<n;o++)e.setComponent(r+t,o,i.getComponent(r,o))}else e.array.set(i.array,t*n);e.needsUpdate=!0}function Gi(i,e){if(i.constructor!==e.constructor){let t=Math.min(i.length,e.length);for(let n=0;n<t;n++)e[n]=i[n]}else{let t=Math.min(i.length,e.length);e.set(new i.constructor(i.buffer,0,t))}}var nl=class extends Pt{constructor(e,t,n=t*2,s){super(new $t,s),this.isBatchedMesh=!0,this.perObjectFrustumCulled=!0,this.sortObjects=!0,this.boundingBox=null,this.boundingSphere=null,this.customSort=null,this._instanceInfo=[],this._geometryInfo=[],this._availableInstanceIds=[],this._availableGeometryIds=[],this._nextIndexStart=0,this._nextVertexStart=0,this._geometryCount=0,this._visibilityChanged=!0,this._geometryInitialized=!1,this._maxInstanceCount=e,this._maxVertexCount=t,this._maxIndexCount=n,this._multiDrawCounts=new Int32Array(e),this._multiDrawStarts=new Int32Array(e),this._multiDrawCount=0,this._multiDrawBytesPerElement=1,this._mergedDrawCounts=new Int32Array(e),this._mergedDrawStarts=new Int32Array(e),this._mergedDrawInstanceCounts=new Int32Array(e),this._mergedDrawCount=0,this._matricesTexture=null,this._indirectTexture=null,this._colorsTexture=null,this._previousMatricesTexture=null,this._initMatricesTexture(),this._initIndirectTexture()}get maxInstanceCount(){return this._maxInstanceCount}get instanceCount(){return this._instanceInfo.length-this._availableInstanceIds.length}get unusedVertexCount(){return this._maxVertexCount-this._nextVertexStart}get unusedIndexCount(){return this._maxIndexCount-this._nextIndexStart}_initMatricesTexture(){let e=Math.sqrt(this._maxInstanceCount*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4),n=new Es(t,e,e,ti,Yn);this._matricesTexture=n}_initIndirectTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Uint32Array(e*e),n=new Es(t,e,e,vl,vi);this._indirectTexture=n}_initColorsTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Float32Array(e*e*4).fill(1),n=new Es(t,e,e,ti,Yn);n.colorSpace=it.workingColorSpace,this._colorsTexture=n}_initializeGeometry(e){let t=this.geometry,n=this._maxVertexCount,s=this._maxIndexCount;if(this._geometryInitialized===!1){for(let r in e.attributes){let o=e.getAttribute(r),{array:a,itemSize:l,normalized:c}=o,u=new a.constructor(n*l),h=new gt(u,l,c);t.setAttribute(r,h)}if(e.getIndex()!==null){let r=n>65535?new Uint32Array(s):new Uint16Array(s);t.setIndex(new gt(r,1))}this._geometryInitialized=!0}}_validateGeometry(e){let t=this.geometry;if(!!e.getIndex()!=!!t.getIndex())throw new Error('THREE.BatchedMesh: All geometries must consistently have "index".');for(let n in t.attributes){if(!e.hasAttribute(n))throw new Error(`THREE.BatchedMesh: Added geometry missing "${n}". All geometries must have consistent attributes.`);let s=e.getAttribute(n),r=t.getAttribute(n);if(s.itemSize!==r.itemSize||s.normalized!==r.normalized)throw new Error(`THREE.BatchedMesh: Added geometry attribute "${n}" has an inconsistent itemSize or normalized value.`)}}validateInstanceId(e){let t=this._instanceInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid instanceId ${e}. Instance is either out of range or has been deleted.`)}validateGeometryId(e){let t=this._geometryInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid geometryId ${e}. Geometry is either out of range or has been deleted.`)}setCustomSort(e){return this.customSort=e,this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new et);let e=this.boundingBox,t=this._instanceInfo;e.makeEmpty();for(let n=0,s=t.length;n<s;n++){if(t[n].active===!1)continue;let r=t[n].geometryIndex;this.getMatrixAt(n,ei),this.getBoundingBoxAt(r,eu).applyMatrix4(ei),e.union(eu)}}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zt);let e=this.boundingSphere,t=this._instanceInfo;e.makeEmpty();for(let n=0,s=t.length;n<s;n++){if(t[n].active===!1)continue;let r=t[n].geometryIndex;this.getMatrixAt(n,ei),this.getBoundingSphereAt(r,Cr).applyMatrix4(ei),e.union(Cr)}}addInstance(e){if(this._instanceInfo.length>=this.maxInstanceCount&&this._availableInstanceIds.length===0)throw new Error("THREE.BatchedMesh: Maximum item count reached.");let n={visible:!0,active:!0,geometryIndex:e},s=null;this._availableInstanceIds.length>0?(this._availableInstanceIds.sort(vf),s=this._availableInstanceIds.shift(),this._instanceInfo[s]=n):(s=this._instanceInfo.length,this._instanceInfo.push(n));let r=this._matricesTexture;ei.identity().toArray(r.image.data,s*16),r.needsUpdate=!0;let o=this._colorsTexture;return o&&(uS.toArray(o.image.data,s*4),o.needsUpdate=!0),this._visibilityChanged=!0,s}addGeometry(e,t=-1,n=-1){this._initializeGeometry(e),this._validateGeometry(e);let s={vertexStart:-1,vertexCount:-1,reservedVertexCount:-1,indexStart:-1,indexCount:-1,reservedIndexCount:-1,start:-1,count:-1,boundingBox:null,boundingSphere:null,active:!0},r=this._geometryInfo;s.vertexStart=this._nextVertexStart,s.reservedVertexCount=t===-1?e.getAttribute("position").count:t;let o=e.getIndex();if(o!==null&&(s.indexStart=this._nextIndexStart,s.reservedIndexCount=n===-1?o.count:n),s.indexStart!==-1&&s.indexStart+s.reservedIndexCount>this._maxIndexCount||s.vertexStart+s.reservedVertexCount>this._maxVertexCount)throw new Error("THREE.BatchedMesh: Reserved space request exceeds the maximum buffer size.");let l;return this._availableGeometryIds.length>0?(this._availableGeometryIds.sort(vf),l=this._availableGeometryIds.shift(),r[l]=s):(l=this._geometryCount,this._geometryCount++,r.push(s)),this.setGeometryAt(l,e),this._nextIndexStart=s.indexStart+s.reservedIndexCount,this._nextVertexStart=s.vertexStart+s.reservedVertexCount,l}setGeometryAt(e,t){if(e>=this._geometryCount)throw new Error("THREE.BatchedMesh: Maximum geometry count reached.");this._validateGeometry(t);let n=this.geometry,s=n.getIndex()!==null,r=n.getIndex(),o=t.getIndex(),a=this._geometryInfo[e];if(s&&o.count>a.reservedIndexCount||t.attributes.position.count>a.reservedVertexCount)throw new Error("THREE.BatchedMesh: Reserved space not large enough for provided geometry.");let l=a.vertexStart,c=a.reservedVertexCount;a.vertexCount=t.getAttribute("position").count;for(let u in n.attributes){let h=t.getAttribute(u),d=n.getAttribute(u);pS(h,d,l);let f=h.itemSize;for(let m=h.count,y=c;m<y;m++){let g=l+m;for(let _=0;_<f;_++)d.setComponent(g,_,0)}d.needsUpdate=!0,d.addUpdateRange(l*f,c*f)}if(s){let u=a.indexStart,h=a.reservedIndexCount;a.indexCount=t.getIndex().count;for(let d=0;d<o.count;d++)r.setX(u+d,l+o.getX(d));for(let d=o.count,f=h;d<f;d++)r.setX(u+d,l);r.needsUpdate=!0,r.addUpdateRange(u,a.reservedIndexCount)}return a.start=s?a.indexStart:a.vertexStart,a.count=s?a.indexCount:a.vertexCount,a.boundingBox=null,t.boundingBox!==null&&(a.boundingBox=t.boundingBox.clone()),a.boundingSphere=null,t.boundingSphere!==null&&(a.boundingSphere=t.boundingSphere.clone()),this._visibilityChanged=!0,e}deleteGeometry(e){let t=this._geometryInfo;if(e>=t.length||t[e].active===!1)return this;let n=this._instanceInfo;for(let s=0,r=n.length;s<r;s++)n[s].active&&n[s].geometryIndex===e&&this.deleteInstance(s);return t[e].active=!1,this._availableGeometryIds.push(e),this._visibilityChanged=!0,this}deleteInstance(e){return this.validateInstanceId(e),this._instanceInfo[e].active=!1,this._availableInstanceIds.push(e),this._visibilityChanged=!0,this}optimize(){let e=0,t=0,n=this._geometryInfo,s=n.map((o,a)=>a).sort((o,a)=>n[o].vertexStart-n[a].vertexStart),r=this.geometry;for(let o=0,a=n.length;o<a;o++){let l=s[o],c=n[l];if(c.active!==!1){if(r.index!==null){if(c.indexStart!==t){let{indexStart:u,vertexStart:h,reservedIndexCount:d}=c,f=r.index,m=f.array,y=e-h;for(let g=u;g<u+d;g++)m[g]=m[g]+y;f.array.copyWithin(t,u,u+d),f.addUpdateRange(t,d),f.needsUpdate=!0,c.indexStart=t}t+=c.reservedIndexCount}if(c.vertexStart!==e){let{vertexStart:u,reservedVertexCount:h}=c,d=r.attributes;for(let f in d){let m=d[f],{array:y,itemSize:g}=m;y.copyWithin(e*g,u*g,(u+h)*g),m.addUpdateRange(e*g,h*g),m.needsUpdate=!0}c.vertexStart=e}e+=c.reservedVertexCount,c.start=r.index?c.indexStart:c.vertexStart}}return this._nextIndexStart=t,this._nextVertexStart=e,this._visibilityChanged=!0,this}getBoundingBoxAt(e,t){if(e>=this._geometryCount)return null;let n=this.geometry,s=this._geometryInfo[e];if(s.boundingBox===null){let r=new et,o=n.index,a=n.attributes.position;for(let l=s.start,c=s.start+s.count;l<c;l++){let u=l;o&&(u=o.getX(u)),r.expandByPoint(bf.fromBufferAttribute(a,u))}s.boundingBox=r}return t.copy(s.boundingBox),t}getBoundingSphereAt(e,t){if(e>=this._geometryCount)return null;let n=this.geometry,s=this._geometryInfo[e];if(s.boundingSphere===null){let r=new zt;this.getBoundingBoxAt(e,eu),eu.getCenter(r.center);let o=n.index,a=n.attributes.position,l=0;for(let c=s.start,u=s.start+s.count;c<u;c++){let h=c;o&&(h=o.getX(h)),bf.fromBufferAttribute(a,h),l=Math.max(l,r.center.distanceToSquared(bf))}r.radius=Math.sqrt(l),s.boundingSphere=r}return t.copy(s.boundingSphere),t}setMatrixAt(e,t){this.validateInstanceId(e);let n=this._matricesTexture,s=this._matricesTexture.image.data;return t.toArray(s,e*16),n.needsUpdate=!0,this}getMatrixAt(e,t){return this.validateInstanceId(e),t.fromArray(this._matricesTexture.image.data,e*16)}setColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null&&this._initColorsTexture(),t.toArray(this._colorsTexture.image.data,e*4),this._colorsTexture.needsUpdate=!0,this}getColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null?t.isVector4?t.set(1,1,1,1):t.setRGB(1,1,1):t.fromArray(this._colorsTexture.image.data,e*4)}setVisibleAt(e,t){return this.validateInstanceId(e),this._instanceInfo[e].visible===t?this:(this._instanceInfo[e].visible=t,this._visibilityChanged=!0,this)}getVisibleAt(e){return this.validateInstanceId(e),this._instanceInfo[e].visible}setGeometryIdAt(e,t){return this.validateInstanceId(e),this.validateGeometryId(t),this._instanceInfo[e].geometryIndex=t,this._visibilityChanged=!0,this}getGeometryIdAt(e){return this.validateInstanceId(e),this._instanceInfo[e].geometryIndex}getGeometryRangeAt(e,t={}){this.validateGeometryId(e);let n=this._geometryInfo[e];return t.vertexStart=n.vertexStart,t.vertexCount=n.vertexCount,t.reservedVertexCount=n.reservedVertexCount,t.indexStart=n.indexStart,t.indexCount=n.indexCount,t.reservedIndexCount=n.reservedIndexCount,t.start=n.start,t.count=n.count,t}setInstanceCount(e){let t=this._availableInstanceIds,n=this._instanceInfo;for(t.sort(vf);t[t.length-1]===n.length-1;)n.pop(),t.pop();if(e<n.length)throw new Error(`THREE.BatchedMesh: Instance ids outside the range ${e} are being used. Cannot shrink instance count.`);let s=new Int32Array(e),r=new Int32Array(e);Gi(this._multiDrawCounts,s),Gi(this._multiDrawStarts,r),this._multiDrawCounts=s,this._multiDrawStarts=r;let o=new Int32Array(e),a=new Int32Array(e),l=new Int32Array(e);Gi(this._mergedDrawCounts,o),Gi(this._mergedDrawStarts,a),Gi(this._mergedDrawInstanceCounts,l),this._mergedDrawCounts=o,this._mergedDrawStarts=a,this._mergedDrawInstanceCounts=l,this._maxInstanceCount=e;let c=this._indirectTexture,u=this._matricesTexture,h=this._colorsTexture;c.dispose(),this._initIndirectTexture(),Gi(c.image.data,this._indirectTexture.image.data),u.dispose(),this._initMatricesTexture(),Gi(u.image.data,this._matricesTexture.image.data),h&&(h.dispose(),this._initColorsTexture(),Gi(h.image.data,this._colorsTexture.image.data)),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}setGeometrySize(e,t){let n=[...this._geometryInfo].filter(a=>a.active);if(Math.max(...n.map(a=>a.vertexStart+a.reservedVertexCount))>e)throw new Error(`THREE.BatchedMesh: Geometry vertex values are being used outside the range ${e}. Cannot shrink further.`);if(this.geometry.index&&Math.max(...n.map(l=>l.indexStart+l.reservedIndexCount))>t)throw new Error(`THREE.BatchedMesh: Geometry index values are being used outside the range ${t}. Cannot shrink further.`);let r=this.geometry;r.dispose(),this._maxVertexCount=e,this._maxIndexCount=t,this._geometryInitialized&&(this._geometryInitialized=!1,this.geometry=new $t,this._initializeGeometry(r));let o=this.geometry;r.index&&Gi(r.index.array,o.index.array);for(let a in r.attributes)Gi(r.attributes[a].array,o.attributes[a].array);this._visibilityChanged=!0}raycast(e,t){let n=this._instanceInfo,s=this._geometryInfo,r=this.matrixWorld,o=this.geometry;kn.material=this.material,kn.geometry.index=o.index,kn.geometry.attributes=o.attributes,kn.geometry.boundingBox===null&&(kn.geometry.boundingBox=new et),kn.geometry.boundingSphere===null&&(kn.geometry.boundingSphere=new zt);for(let a=0,l=n.length;a<l;a++){if(!n[a].visible||!n[a].active)continue;let c=n[a].geometryIndex,u=s[c];kn.geometry.setDrawRange(u.start,u.count),this.getMatrixAt(a,kn.matrixWorld).premultiply(r),this.getBoundingBoxAt(c,kn.geometry.boundingBox),this.getBoundingSphereAt(c,kn.geometry.boundingSphere),kn.raycast(e,tu);for(let h=0,d=tu.length;h<d;h++){let f=tu[h];f.object=this,f.batchId=a,t.push(f)}tu.length=0}kn.material=null,kn.geometry.index=null,kn.geometry.attributes={},kn.geometry.setDrawRange(0,1/0)}copy(e){return super.copy(e),this.geometry=e.geometry.clone(),this.perObjectFrustumCulled=e.perObjectFrustumCulled,this.sortObjects=e.sortObjects,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this._geometryInfo=e._geometryInfo.map(t=>({...t,boundingBox:t.boundingBox!==null?t.boundingBox.clone():null,boundingSphere:t.boundingSphere!==null?t.boundingSphere.clone():null})),this._instanceInfo=e._instanceInfo.map(t=>({...t})),this._availableInstanceIds=e._availableInstanceIds.slice(),this._availableGeometryIds=e._availableGeometryIds.slice(),this._nextIndexStart=e._nextIndexStart,this._nextVertexStart=e._nextVertexStart,this._geometryCount=e._geometryCount,this._maxInstanceCount=e._maxInstanceCount,this._maxVertexCount=e._maxVertexCount,this._maxIndexCount=e._maxIndexCount,this._geometryInitialized=e._geometryInitialized,this._multiDrawCounts=e._multiDrawCounts.slice(),this._multiDrawStarts=e._multiDrawStarts.slice(),this._multiDrawBytesPerElement=e._multiDrawBytesPerElement,this._mergedDrawCounts=e._mergedDrawCounts.slice(),this._mergedDrawStarts=e._mergedDrawStarts.slice(),this._mergedDrawInstanceCounts=e._mergedDrawInstanceCounts.slice(),this._indirectTexture=e._indirectTexture.clone(),this._indirectTexture.image.data=this._indirectTexture.image.data.slice(),this._matricesTexture=e._matricesTexture.clone(),this._matricesTexture.image.data=this._matricesTexture.image.data.slice(),e._colorsTexture!==null?(this._colorsTexture=e._colorsTexture.clone(),this._colorsTexture.image.data=this._colorsTexture.image.data.slice()):this._colorsTexture=null,this}dispose(){super.dispose(),this.geometry.dispose(),this._matricesTexture.dispose(),this._matricesTexture=null,this._indirectTexture.dispose(),this._indirectTexture=null,this._colorsTexture!==null&&(this._colorsTexture.dispose(),this._colorsTexture=null),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}_updateDrawParameters(e,t,n,s="multiDraw"){if(!this._visibilityChanged&&!this.perObjectFrustumCulled&&!this.sortObjects)return;let r=t.getIndex(),o=r===null?1:r.array.BYTES_PER_ELEMENT,a=1;n.wireframe&&(a=2,o=t.attributes.position.count>65535?4:2);let l=this._instanceInfo,c=this._multiDrawStarts,u=this._multiDrawCounts,h=this._mergedDrawStarts,d=this._mergedDrawCounts,f=this._mergedDrawInstanceCounts,m=this._geometryInfo,y=this.perObjectFrustumCulled,g=this._indirectTexture,_=g.image.data,v=e.isArrayCamera?dS:hS;y&&(e.isArrayCamera?v.setFromArrayCamera(e):(ei.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).multiply(this.matrixWorld),v.setFromProjectionMatrix(ei,e.coordinateSystem,e.reversedDepth)));let M=0,b=0;if(this.sortObjects){ei.copy(this.matrixWorld).invert(),E0.setFromMatrixPosition(e.matrixWorld).applyMatrix4(ei),T0.set(0,0,-1).transformDirection(e.matrixWorld).transformDirection(ei);for(let p=0,S=l.length;p<S;p++)if(l[p].visible&&l[p].active){let A=l[p].geometryIndex;this.getMatrixAt(p,ei),this.getBoundingSphereAt(A,Cr).applyMatrix4(ei);let E=!1;if(y&&(E=!v.intersectsSphere(Cr)),!E){let C=m[A],I=fS.subVectors(Cr.center,E0).dot(T0);Sf.push(C.start,C.count,I,p)}}let w=Sf.list,x=this.customSort;x===null?w.sort(n.transparent?cS:lS):x.call(this,w,e);for(let p=0,S=w.length;p<S;p++){let A=w[p],E=A.start*o*a,C=A.count*a;s==="merged"?b>0&&h[b-1]===E&&d[b-1]===C?f[b-1]++:(h[b]=E,d[b]=C,f[b]=1,b++):(c[M]=E,u[M]=C),_[M]=A.index,M++}Sf.reset()}else for(let w=0,x=l.length;w<x;w++)if(l[w].visible&&l[w].active){let p=l[w].geometryIndex,S=!1;if(y&&(this.getMatrixAt(w,ei),this.getBoundingSphereAt(p,Cr).applyMatrix4(ei),S=!v.intersectsSphere(Cr)),!S){let A=m[p],E=A.start*o*a,C=A.count*a;s==="merged"?b>0&&h[b-1]===E&&d[b-1]===C?f[b-1]++:(h[b]=E,d[b]=C,f[b]=1,b++):(c[M]=E,u[M]=C),_[M]=w,M++}}g.needsUpdate=!0,this._multiDrawCount=M,this._mergedDrawCount=b,this._multiDrawBytesPerElement=o,this._visibilityChanged=!1}onBeforeRender(e,t,n,s,r){e.isWebGPURenderer===!0?(this._visibilityChanged||this.perObjectFrustumCulled||this.sortObjects)&&(this._indirectTexture.needsUpdate=!0):this._updateDrawParameters(n,s,r)}onBeforeShadow(e,t,n,s,r,o){e.isWebGPURenderer!==!0&&this._updateDrawParameters(s,r,o)}},Js=class extends Zn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new De(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},bu=new P,Su=new P,A0=new Ce,Ha=new $i,nu=new zt,Mf=new P,R0=new P,Ki=class extends Jt{constructor(e=new $t,t=new Js){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)bu.fromBufferAttribute(t,s-1),Su.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=bu.distanceTo(Su);e.setAttribute("lineDistance",new un(n,1))}else Ue("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),nu.copy(n.boundingSphere),nu.applyMatrix4(s),nu.radius+=r,e.ray.intersectsSphere(nu)===!1)return;A0.copy(s).invert(),Ha.copy(e.ray).applyMatrix4(A0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let y=f,g=m-1;y<g;y+=c){let _=u.getX(y),v=u.getX(y+1),M=iu(this,e,Ha,l,_,v,y);M&&t.push(M)}if(this.isLineLoop){let y=u.getX(m-1),g=u.getX(f),_=iu(this,e,Ha,l,y,g,m-1);_&&t.push(_)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let y=f,g=m-1;y<g;y+=c){let _=iu(this,e,Ha,l,y,y+1,y);_&&t.push(_)}if(this.isLineLoop){let y=iu(this,e,Ha,l,m-1,f,m-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function iu(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(bu.fromBufferAttribute(a,s),Su.fromBufferAttribute(a,r),t.distanceSqToSegment(bu,Su,Mf,R0)>n)return;Mf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Mf);if(!(c<e.near||c>e.far))return{distance:c,point:R0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var C0=new P,P0=new P,Zi=class extends Ki{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)C0.fromBufferAttribute(t,s),P0.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+C0.distanceTo(P0);e.setAttribute("lineDistance",new un(n,1))}else Ue("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},js=class extends Ki{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},Lo=class extends Zn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new De(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},I0=new Ce,Of=new $i,su=new zt,ru=new P,Li=class extends Jt{constructor(e=new $t,t=new Lo){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),su.copy(n.boundingSphere),su.applyMatrix4(s),su.radius+=r,e.ray.intersectsSphere(su)===!1)return;I0.copy(s).invert(),Of.copy(e.ray).applyMatrix4(I0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let m=d,y=f;m<y;m++){let g=c.getX(m);ru.fromBufferAttribute(h,g),L0(ru,g,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let m=d,y=f;m<y;m++)ru.fromBufferAttribute(h,m),L0(ru,m,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function L0(i,e,t,n,s,r,o){let a=Of.distanceSqToPoint(i);if(a<t){let l=new P;Of.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var il=class extends vn{constructor(e=[],t=Br,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Cs=class extends vn{constructor(e,t,n=vi,s,r,o,a=nn,l=nn,c,u=Ts,h=1){if(u!==Ts&&u!==Fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ro(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},sl=class extends Cs{constructor(e,t=vi,n=Br,s,r,o=nn,a=nn,l,c=Ts){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},rl=class extends vn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Oo=class i extends $t{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,n,t,e,o,r,0),m("z","y","x",1,-1,n,t,-e,o,r,1),m("x","z","y",1,1,e,n,t,s,o,2),m("x","z","y",1,-1,e,n,-t,s,o,3),m("x","y","z",1,-1,e,t,n,s,r,4),m("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new un(c,3)),this.setAttribute("normal",new un(u,3)),this.setAttribute("uv",new un(h,2));function m(y,g,_,v,M,b,w,x,p,S,A){let E=b/p,C=w/S,I=b/2,D=w/2,L=x/2,U=p+1,V=S+1,B=0,ne=0,z=new P;for(let q=0;q<V;q++){let W=q*C-D;for(let _e=0;_e<U;_e++){let Te=_e*E-I;z[y]=Te*v,z[g]=W*M,z[_]=L,c.push(z.x,z.y,z.z),z[y]=0,z[g]=0,z[_]=x>0?1:-1,u.push(z.x,z.y,z.z),h.push(_e/p),h.push(1-q/S),B+=1}}for(let q=0;q<S;q++)for(let W=0;W<p;W++){let _e=d+W+U*q,Te=d+W+U*(q+1),$=d+(W+1)+U*(q+1),ae=d+(W+1)+U*q;l.push(_e,Te,ae),l.push(Te,$,ae),ne+=6}a.addGroup(f,ne,A),f+=ne,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ji=class i extends $t{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],m=[],y=[],g=[];for(let _=0;_<u;_++){let v=_*d-o;for(let M=0;M<c;M++){let b=M*h-r;m.push(b,-v,0),y.push(0,0,1),g.push(M/a),g.push(1-_/l)}}for(let _=0;_<l;_++)for(let v=0;v<a;v++){let M=v+c*_,b=v+c*(_+1),w=v+1+c*(_+1),x=v+1+c*_;f.push(M,b,x),f.push(b,w,x)}this.setIndex(f),this.setAttribute("position",new un(m,3)),this.setAttribute("normal",new un(y,3)),this.setAttribute("uv",new un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var ol=class extends $t{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new P,r=new P;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],d=h.start,f=h.count;for(let m=d,y=d+f;m<y;m+=3)for(let g=0;g<3;g++){let _=a.getX(m+g),v=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,_),r.fromBufferAttribute(o,v),O0(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),O0(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new un(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function O0(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}function Hr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(N0(s))s.isRenderTargetTexture?(Ue("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(N0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Vn(i){let e={};for(let t=0;t<i.length;t++){let n=Hr(i[t]);for(let s in n)e[s]=n[s]}return e}function N0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function mS(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function gp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:it.workingColorSpace}var Cl={clone:Hr,merge:Vn},gS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_S=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,dn=class extends Zn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gS,this.fragmentShader=_S,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Hr(e.uniforms),this.uniformsGroups=mS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new De().setHex(s.value);break;case"v2":this.uniforms[n].value=new Fe().fromArray(s.value);break;case"v3":this.uniforms[n].value=new P().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ct().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Ke().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ce().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Mu=class extends dn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Ps=class extends Zn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new De(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new De(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Rl,this.normalScale=new Fe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Jn=class extends Ps{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new Fe(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return Ze(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new De(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new De(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new De(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Pr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Pr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var al=class extends Zn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new De(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new De(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Rl,this.normalScale=new Fe(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yi,this.combine=Nu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},wu=class extends Zn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=__,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Eu=class extends Zn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ks(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ga(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function xS(i){function e(s,r){return i[s]-i[r]}let t=i.length,n=new Array(t);for(let s=0;s!==t;++s)n[s]=s;return n.sort(e),n}function D0(i,e,t){let n=i.length,s=new i.constructor(n);for(let r=0,o=0;o!==n;++r){let a=t[r]*e;for(let l=0;l!==e;++l)s[o++]=i[a+l]}return s}function yS(i,e,t,n){let s=1,r=i[0];for(;r!==void 0&&r[n]===void 0;)r=i[s++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(e.push(r.time),t.push(...o)),r=i[s++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(e.push(r.time),o.toArray(t,t.length)),r=i[s++];while(r!==void 0);else do o=r[n],o!==void 0&&(e.push(r.time),t.push(o)),r=i[s++];while(r!==void 0)}var ji=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Tu=class extends ji{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Cf,endingEnd:Cf}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Pf:r=e,a=2*t-n;break;case If:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Pf:o=e,l=2*n-t;break;case If:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(n-t)/(s-t),y=m*m,g=y*m,_=-d*g+2*d*y-d*m,v=(1+d)*g+(-1.5-2*d)*y+(-.5+d)*m+1,M=(-1-f)*g+(1.5+f)*y+.5*m,b=f*g-f*y;for(let w=0;w!==a;++w)r[w]=_*o[u+w]+v*o[c+w]+M*o[l+w]+b*o[h+w];return r}},Au=class extends ji{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Ru=class extends ji{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Cu=class extends ji{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-t)/(s-t),y=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*y+o[l+g]*m;return r}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let y=o[c+m],g=o[l+m],_=f*d+m*2,v=h[_],M=h[_+1],b=e*d+m*2,w=u[b],x=u[b+1],p=bS(n,t,v,w,s);r[m]=P_(p,y,M,x,g)}return r}};function P_(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function vS(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function bS(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=P_(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=vS(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ii=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ks(t,this.TimeBufferType),this.values=Ks(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ks(e.times,Array),values:Ks(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ga(e.settings)&&(n.settings={inTangents:Ks(e.settings.inTangents,Array),outTangents:Ks(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ru(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Tu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Cu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ir:t=this.InterpolantFactoryMethodDiscrete;break;case Lr:t=this.InterpolantFactoryMethodLinear;break;case cu:t=this.InterpolantFactoryMethodSmooth;break;case Rf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ue("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ir;case this.InterpolantFactoryMethodLinear:return Lr;case this.InterpolantFactoryMethodSmooth:return cu;case this.InterpolantFactoryMethodBezier:return Rf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ga(this.settings)&&(U0(this.settings.inTangents,e),U0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ga(this.settings)&&(F0(this.settings.inTangents,e),F0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Xe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Xe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Xe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Xe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Eb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Xe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===cu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,d=h-n,f=h+n;for(let m=0;m!==n;++m){let y=t[h+m];if(y!==t[d+m]||y!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ga(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function U0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function F0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ii.prototype.ValueTypeName="";ii.prototype.TimeBufferType=Float32Array;ii.prototype.ValueBufferType=Float32Array;ii.prototype.DefaultInterpolation=Lr;var Is=class extends ii{constructor(e,t,n){super(e,t,n)}};Is.prototype.ValueTypeName="bool";Is.prototype.ValueBufferType=Array;Is.prototype.DefaultInterpolation=Ir;Is.prototype.InterpolantFactoryMethodLinear=void 0;Is.prototype.InterpolantFactoryMethodSmooth=void 0;var ll=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};ll.prototype.ValueTypeName="color";var Ls=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};Ls.prototype.ValueTypeName="number";var Pu=class extends ji{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Kn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Os=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Pu(this.times,this.values,this.getValueSize(),e)}};Os.prototype.ValueTypeName="quaternion";Os.prototype.InterpolantFactoryMethodSmooth=void 0;var Ns=class extends ii{constructor(e,t,n){super(e,t,n)}};Ns.prototype.ValueTypeName="string";Ns.prototype.ValueBufferType=Array;Ns.prototype.DefaultInterpolation=Ir;Ns.prototype.InterpolantFactoryMethodLinear=void 0;Ns.prototype.InterpolantFactoryMethodSmooth=void 0;var Qs=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};Qs.prototype.ValueTypeName="vector";var cl=class{constructor(e="",t=-1,n=[],s=g_){this.name=e,this.tracks=n,this.duration=t,this.blendMode=s,this.uuid=ns(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,s=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push(MS(n[o]).scale(s));let r=new this(e.name,e.duration,t,e.blendMode);return r.uuid=e.uuid,r.userData=JSON.parse(e.userData||"{}"),r}static toJSON(e){let t=[],n=e.tracks,s={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let r=0,o=n.length;r!==o;++r)t.push(ii.toJSON(n[r]));return s}static CreateFromMorphTargetSequence(e,t,n,s){let r=t.length,o=[];for(let a=0;a<r;a++){let l=[],c=[];l.push((a+r-1)%r,a,(a+1)%r),c.push(0,1,0);let u=xS(l);l=D0(l,1,u),c=D0(c,1,u),!s&&l[0]===0&&(l.push(r),c.push(c[0])),o.push(new Ls(".morphTargetInfluences["+t[a].name+"]",l,c).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let s=e;n=s.geometry&&s.geometry.animations||s.animations}for(let s=0;s<n.length;s++)if(n[s].name===t)return n[s];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let s={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,l=e.length;a<l;a++){let c=e[a],u=c.name.match(r);if(u&&u.length>1){let h=u[1],d=s[h];d||(s[h]=d=[]),d.push(c)}}let o=[];for(let a in s)o.push(this.CreateFromMorphTargetSequence(a,s[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,s=e.length;n!==s;++n){let r=this.tracks[n];t=Math.max(t,r.times[r.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function SS(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Ls;case"vector":case"vector2":case"vector3":case"vector4":return Qs;case"color":return ll;case"quaternion":return Os;case"bool":case"boolean":return Is;case"string":return Ns}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function MS(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=SS(i.type);if(i.times===void 0){let n=[],s=[];yS(i.keys,n,s,"value"),i.times=n,i.values=s}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),Ga(i.settings)&&(t.settings={inTangents:Ks(i.settings.inTangents,Float32Array),outTangents:Ks(i.settings.outTangents,Float32Array)}),t}var Xi={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(k0(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!k0(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function k0(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var Iu=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},I_=new Iu,Qi=class{constructor(e){this.manager=e!==void 0?e:I_,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Qi.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ms={},Nf=class extends Error{constructor(e,t){super(e),this.response=t}},No=class extends Qi{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Xi.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Ms[e]!==void 0){Ms[e].push({onLoad:t,onProgress:n,onError:s});return}Ms[e]=[],Ms[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&Ue("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Ms[e],h=c.body.getReader(),d=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),f=d?parseInt(d):0,m=f!==0,y=0,g=new ReadableStream({start(_){v();function v(){h.read().then(({done:M,value:b})=>{if(M)_.close();else{y+=b.byteLength;let w=new ProgressEvent("progress",{lengthComputable:m,loaded:y,total:f});for(let x=0,p=u.length;x<p;x++){let S=u[x];S.onProgress&&S.onProgress(w)}_.enqueue(b),v()}},M=>{_.error(M)})}}});return new Response(g)}else throw new Nf(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),d=h&&h[1]?h[1].toLowerCase():void 0,f=new TextDecoder(d);return c.arrayBuffer().then(m=>f.decode(m))}}}).then(c=>{Xi.add(`file:${e}`,c);let u=Ms[e];delete Ms[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onLoad&&f.onLoad(c)}}).catch(c=>{let u=Ms[e];if(u===void 0)throw this.manager.itemError(e),c;delete Ms[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onError&&f.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var _o=new WeakMap,Lu=class extends Qi{constructor(e){super(e)}load(e,t,n,s){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=Xi.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(e),setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);else{let h=_o.get(o);h===void 0&&(h=[],_o.set(o,h)),h.push({onLoad:t,onError:s})}return o}let a=To("img");function l(){u(),t&&t(this);let h=_o.get(this)||[];for(let d=0;d<h.length;d++){let f=h[d];f.onLoad&&f.onLoad(this)}_o.delete(this),r.manager.itemEnd(e)}function c(h){u(),s&&s(h),Xi.remove(`image:${e}`);let d=_o.get(this)||[];for(let f=0;f<d.length;f++){let m=d[f];m.onError&&m.onError(h)}_o.delete(this),r.manager.itemError(e),r.manager.itemEnd(e)}function u(){a.removeEventListener("load",l,!1),a.removeEventListener("error",c,!1)}return a.addEventListener("load",l,!1),a.addEventListener("error",c,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),Xi.add(`image:${e}`,a),r.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var ul=class extends Qi{constructor(e){super(e)}load(e,t,n,s){let r=new vn,o=new Lu(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){r.image=a,r.needsUpdate=!0,t!==void 0&&t(r)},n,s),r}},Dr=class extends Jt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new De(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var wf=new Ce,B0=new P,z0=new P,Do=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Fe(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Ce,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Rs,this._frameExtents=new Fe(1,1),this._viewportCount=1,this._viewports=[new ct(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;B0.setFromMatrixPosition(e.matrixWorld),t.position.copy(B0),z0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(z0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){wf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(wf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Eo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(wf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ou=new P,au=new Kn,Wi=new P,hl=class extends Jt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ce,this.projectionMatrix=new Ce,this.projectionMatrixInverse=new Ce,this.coordinateSystem=_i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ou,au,Wi),Wi.x===1&&Wi.y===1&&Wi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ou,au,Wi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ou,au,Wi),Wi.x===1&&Wi.y===1&&Wi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ou,au,Wi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},$s=new P,V0=new Fe,H0=new Fe,cn=class extends hl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Or*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Wa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Or*2*Math.atan(Math.tan(Wa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){$s.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set($s.x,$s.y).multiplyScalar(-e/$s.z),$s.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set($s.x,$s.y).multiplyScalar(-e/$s.z)}getViewSize(e,t){return this.getViewBounds(e,V0,H0),t.subVectors(H0,V0)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Wa*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Df=class extends Do{constructor(){super(new cn(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Or*2*e.angle*this.focus,s=this.mapSize.width/this.mapSize.height*this.aspect,r=e.distance||t.far;(n!==t.fov||s!==t.aspect||r!==t.far)&&(t.fov=n,t.aspect=s,t.far=r,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},dl=class extends Dr{constructor(e,t,n=0,s=Math.PI/3,r=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.target=new Jt,this.distance=n,this.angle=s,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new Df}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},Uf=class extends Do{constructor(){super(new cn(90,1,.5,500)),this.isPointLightShadow=!0}},fl=class extends Dr{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new Uf}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},Ds=class extends hl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ff=class extends Do{constructor(){super(new Ds(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ur=class extends Dr{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Jt.DEFAULT_UP),this.updateMatrix(),this.target=new Jt,this.shadow=new Ff}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Fr=class{constructor(){this.isSphericalHarmonics3=!0,this.coefficients=[];for(let e=0;e<9;e++)this.coefficients.push(new P)}set(e){for(let t=0;t<9;t++)this.coefficients[t].copy(e[t]);return this}zero(){for(let e=0;e<9;e++)this.coefficients[e].set(0,0,0);return this}getAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.282095),t.addScaledVector(o[1],.488603*s),t.addScaledVector(o[2],.488603*r),t.addScaledVector(o[3],.488603*n),t.addScaledVector(o[4],1.092548*(n*s)),t.addScaledVector(o[5],1.092548*(s*r)),t.addScaledVector(o[6],.315392*(3*r*r-1)),t.addScaledVector(o[7],1.092548*(n*r)),t.addScaledVector(o[8],.546274*(n*n-s*s)),t}getIrradianceAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.886227),t.addScaledVector(o[1],2*.511664*s),t.addScaledVector(o[2],2*.511664*r),t.addScaledVector(o[3],2*.511664*n),t.addScaledVector(o[4],2*.429043*n*s),t.addScaledVector(o[5],2*.429043*s*r),t.addScaledVector(o[6],.743125*r*r-.247708),t.addScaledVector(o[7],2*.429043*n*r),t.addScaledVector(o[8],.429043*(n*n-s*s)),t}add(e){for(let t=0;t<9;t++)this.coefficients[t].add(e.coefficients[t]);return this}addScaledSH(e,t){for(let n=0;n<9;n++)this.coefficients[n].addScaledVector(e.coefficients[n],t);return this}scale(e){for(let t=0;t<9;t++)this.coefficients[t].multiplyScalar(e);return this}lerp(e,t){for(let n=0;n<9;n++)this.coefficients[n].lerp(e.coefficients[n],t);return this}equals(e){for(let t=0;t<9;t++)if(!this.coefficients[t].equals(e.coefficients[t]))return!1;return!0}copy(e){return this.set(e.coefficients)}clone(){return new this.constructor().copy(this)}fromArray(e,t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].fromArray(e,t+s*3);return this}toArray(e=[],t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].toArray(e,t+s*3);return e}static getBasisAt(e,t){let n=e.x,s=e.y,r=e.z;t[0]=.282095,t[1]=.488603*s,t[2]=.488603*r,t[3]=.488603*n,t[4]=1.092548*n*s,t[5]=1.092548*s*r,t[6]=.315392*(3*r*r-1),t[7]=1.092548*n*r,t[8]=.546274*(n*n-s*s)}},pl=class extends Dr{constructor(e=new Fr,t=1){super(void 0,t),this.isLightProbe=!0,this.type="LightProbe",this.sh=e}copy(e){return super.copy(e),this.sh.copy(e.sh),this}toJSON(e){let t=super.toJSON(e);return t.object.sh=this.sh.toArray(),t}};var Us=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}},ml=class extends $t{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ef=new WeakMap,gl=class extends Qi{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&Ue("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&Ue("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=Xi.get(`image-bitmap:${e}`);if(o!==void 0){if(r.manager.itemStart(e),o.then){o.then(c=>{Ef.has(o)===!0?(s&&s(Ef.get(o)),r.manager.itemError(e),r.manager.itemEnd(e)):(t&&t(c),r.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let l=fetch(e,a).then(function(c){return c.blob()}).then(function(c){return createImageBitmap(c,Object.assign({},r.options,{colorSpaceConversion:"none"}))}).then(function(c){return Xi.add(`image-bitmap:${e}`,c),t&&t(c),r.manager.itemEnd(e),c}).catch(function(c){s&&s(c),Ef.set(l,c),Xi.remove(`image-bitmap:${e}`),r.manager.itemError(e),r.manager.itemEnd(e)});Xi.add(`image-bitmap:${e}`,l),r.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var xo=-90,yo=1,Uo=class extends Jt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new cn(xo,yo,e,t);s.layers=this.layers,this.add(s);let r=new cn(xo,yo,e,t);r.layers=this.layers,this.add(r);let o=new cn(xo,yo,e,t);o.layers=this.layers,this.add(o);let a=new cn(xo,yo,e,t);a.layers=this.layers,this.add(a);let l=new cn(xo,yo,e,t);l.layers=this.layers,this.add(l);let c=new cn(xo,yo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===_i)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Eo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Ou=class extends cn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var _p="\\[\\]\\.:\\/",wS=new RegExp("["+_p+"]","g"),xp="[^"+_p+"]",ES="[^"+_p.replace("\\.","")+"]",TS=/((?:WC+[\/:])*)/.source.replace("WC",xp),AS=/(WCOD+)?/.source.replace("WCOD",ES),RS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xp),CS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xp),PS=new RegExp("^"+TS+AS+RS+CS+"$"),IS=["material","materials","bones","map"],kf=class{constructor(e,t,n){let s=n||Bt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Bt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(wS,"")}static parseTrackName(e){let t=PS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);IS.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ue("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Xe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Xe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Xe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Xe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Xe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Xe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Xe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Xe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Xe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Xe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Bt.Composite=kf;Bt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Bt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Bt.prototype.GetterByBindingType=[Bt.prototype._getValue_direct,Bt.prototype._getValue_array,Bt.prototype._getValue_arrayElement,Bt.prototype._getValue_toArray];Bt.prototype.SetterByBindingTypeAndVersioning=[[Bt.prototype._setValue_direct,Bt.prototype._setValue_direct_setNeedsUpdate,Bt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_array,Bt.prototype._setValue_array_setNeedsUpdate,Bt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_arrayElement,Bt.prototype._setValue_arrayElement_setNeedsUpdate,Bt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Bt.prototype._setValue_fromArray,Bt.prototype._setValue_fromArray_setNeedsUpdate,Bt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var uC=new Float32Array(1);var er=class extends Nr{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var G0=new Ce,tr=class{constructor(e,t,n=0,s=1/0){this.ray=new $i(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Co,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):Xe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return G0.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(G0),this}intersectObject(e,t=!0,n=[]){return Bf(e,this,n,t),n.sort(W0),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Bf(e[s],this,n,t);return n.sort(W0),n}};function W0(i,e){return i.distance-e.distance}function Bf(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Bf(r[o],e,t,!0)}}var _l=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=Ze(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(Ze(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var zf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var X0=new P,lu=new P,vo=new P,bo=new P,Tf=new P,LS=new P,OS=new P,wn=class{constructor(e=new P,t=new P){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){X0.subVectors(e,this.start),lu.subVectors(this.end,this.start);let n=lu.dot(lu);if(n===0)return 0;let r=lu.dot(X0)/n;return t&&(r=Ze(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=LS,n=OS){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;vo.subVectors(c,a),bo.subVectors(u,l),Tf.subVectors(a,l);let h=vo.dot(vo),d=bo.dot(bo),f=bo.dot(Tf);if(h<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(h<=s)r=0,o=f/d,o=Ze(o,0,1);else{let m=vo.dot(Tf);if(d<=s)o=0,r=Ze(-m/h,0,1);else{let y=vo.dot(bo),g=h*d-y*y;g!==0?r=Ze((y*f-m*d)/g,0,1):r=0,o=(y*r+f)/d,o<0?(o=0,r=Ze(-m/h,0,1)):o>1&&(o=1,r=Ze((y-m)/h,0,1))}}return t.copy(a).addScaledVector(vo,r),n.copy(l).addScaledVector(bo,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function yp(i,e,t,n){let s=NS(n);switch(t){case sp:return i*e;case Vu:return i*e/s.components*s.byteLength;case vl:return i*e/s.components*s.byteLength;case nr:return i*e*2/s.components*s.byteLength;case Hu:return i*e*2/s.components*s.byteLength;case rp:return i*e*3/s.components*s.byteLength;case ti:return i*e*4/s.components*s.byteLength;case Gu:return i*e*4/s.components*s.byteLength;case bl:case Sl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Ml:case wl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Xu:case Yu:return Math.max(i,16)*Math.max(e,8)/4;case Wu:case qu:return Math.max(i,8)*Math.max(e,8)/2;case $u:case Ku:case Ju:case ju:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Zu:case El:case Qu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case eh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case th:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case nh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ih:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case sh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case rh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case oh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case ah:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case lh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case ch:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case uh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case hh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case dh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case fh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case ph:case mh:case gh:return Math.ceil(i/4)*Math.ceil(e/4)*16;case _h:case xh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Tl:case yh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function NS(i){switch(i){case si:case ep:return{byteLength:1,components:1};case Vo:case tp:case Oi:return{byteLength:2,components:1};case Bu:case zu:return{byteLength:2,components:4};case vi:case ku:case Yn:return{byteLength:4,components:1};case np:case ip:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ue("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Q_(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function DS(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],y=h[f];y.start<=m.start+m.count+1?m.count=Math.max(m.count,y.start+y.count-m.start):(++d,h[d]=y)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let y=h[f];i.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var US=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,FS=`#ifdef USE_ALPHAHASH
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
#endif`,kS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,BS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,zS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,VS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,HS=`#ifdef USE_AOMAP
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
#endif`,GS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,WS=`#ifdef USE_BATCHING
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
#endif`,XS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,qS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,YS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$S=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,KS=`#ifdef USE_IRIDESCENCE
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
#endif`,ZS=`#ifdef USE_BUMPMAP
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
#endif`,JS=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,jS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,QS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,eM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,tM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,nM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,iM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,sM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,rM=`#define PI 3.141592653589793
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
} // validated`,oM=`vec3 transformedNormal = objectNormal;
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
#endif`,aM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,lM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,cM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,uM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,hM="gl_FragColor = linearToOutputTexel( gl_FragColor );",dM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,fM=`#ifdef USE_ENVMAP
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
#endif`,pM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,mM=`#ifdef USE_ENVMAP
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
#endif`,gM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,_M=`#ifdef USE_ENVMAP
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
#endif`,xM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,yM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,vM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,bM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,SM=`#ifdef USE_GRADIENTMAP
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
}`,MM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,wM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,EM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,TM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,AM=`#ifdef USE_ENVMAP
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
#endif`,RM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,CM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,PM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,IM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,LM=`PhysicalMaterial material;
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
#endif`,OM=`uniform sampler2D dfgLUT;
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
}`,NM=`
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
#endif`,DM=`#if defined( RE_IndirectDiffuse )
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
#endif`,UM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,FM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,kM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,BM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,VM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,HM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,GM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,WM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,XM=`#if defined( USE_POINTS_UV )
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
#endif`,qM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,YM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$M=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,KM=`#if defined( USE_MORPHCOLORS )
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
#endif`,ZM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,JM=`#ifdef USE_MORPHTARGETS
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
#endif`,jM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,QM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ew=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,tw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,nw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,sw=`#ifdef USE_NORMALMAP
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
#endif`,rw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,ow=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,aw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,lw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,cw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,uw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,hw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,dw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,fw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,pw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,mw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,gw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,_w=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,xw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,yw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,vw=`float getShadowMask() {
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
}`,bw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Sw=`#ifdef USE_SKINNING
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
#endif`,Mw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ww=`#ifdef USE_SKINNING
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
#endif`,Ew=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Tw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Aw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Rw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Cw=`#ifdef USE_TRANSMISSION
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
#endif`,Pw=`#ifdef USE_TRANSMISSION
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
#endif`,Iw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Lw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ow=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Nw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Dw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Uw=`uniform sampler2D t2D;
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
}`,Fw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,kw=`uniform float backgroundBlurriness;
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
}`,Bw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,zw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vw=`#include <common>
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
}`,Hw=`#if DEPTH_PACKING == 3200
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
}`,Gw=`#define DISTANCE
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
}`,Ww=`#define DISTANCE
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
}`,Xw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,qw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Yw=`uniform float scale;
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
}`,$w=`uniform vec3 diffuse;
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
}`,Kw=`#include <common>
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
}`,Zw=`uniform vec3 diffuse;
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
}`,Jw=`#define LAMBERT
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
}`,jw=`#define LAMBERT
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
}`,Qw=`#define MATCAP
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
}`,eE=`#define MATCAP
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
}`,tE=`#define NORMAL
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
}`,nE=`#define NORMAL
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
}`,iE=`#define PHONG
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
}`,sE=`#define PHONG
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
}`,rE=`#define STANDARD
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
}`,oE=`#define STANDARD
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
}`,aE=`#define TOON
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
}`,lE=`#define TOON
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
}`,cE=`uniform float size;
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
}`,uE=`uniform vec3 diffuse;
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
}`,hE=`#include <common>
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
}`,dE=`uniform vec3 color;
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
}`,fE=`uniform float rotation;
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
}`,pE=`uniform vec3 diffuse;
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
}`,st={alphahash_fragment:US,alphahash_pars_fragment:FS,alphamap_fragment:kS,alphamap_pars_fragment:BS,alphatest_fragment:zS,alphatest_pars_fragment:VS,aomap_fragment:HS,aomap_pars_fragment:GS,batching_pars_vertex:WS,batching_vertex:XS,begin_vertex:qS,beginnormal_vertex:YS,bsdfs:$S,iridescence_fragment:KS,bumpmap_pars_fragment:ZS,clipping_planes_fragment:JS,clipping_planes_pars_fragment:jS,clipping_planes_pars_vertex:QS,clipping_planes_vertex:eM,color_fragment:tM,color_pars_fragment:nM,color_pars_vertex:iM,color_vertex:sM,common:rM,defaultnormal_vertex:oM,displacementmap_pars_vertex:aM,displacementmap_vertex:lM,emissivemap_fragment:cM,emissivemap_pars_fragment:uM,colorspace_fragment:hM,colorspace_pars_fragment:dM,envmap_fragment:fM,envmap_common_pars_fragment:pM,envmap_pars_fragment:mM,envmap_pars_vertex:gM,envmap_physical_pars_fragment:AM,envmap_vertex:_M,fog_vertex:xM,fog_pars_vertex:yM,fog_fragment:vM,fog_pars_fragment:bM,gradientmap_pars_fragment:SM,lightmap_pars_fragment:MM,lights_lambert_fragment:wM,lights_lambert_pars_fragment:EM,lights_pars_begin:TM,lights_toon_fragment:RM,lights_toon_pars_fragment:CM,lights_phong_fragment:PM,lights_phong_pars_fragment:IM,lights_physical_fragment:LM,lights_physical_pars_fragment:OM,lights_fragment_begin:NM,lights_fragment_maps:DM,lights_fragment_end:UM,lightprobes_pars_fragment:FM,logdepthbuf_fragment:kM,logdepthbuf_pars_fragment:BM,logdepthbuf_pars_vertex:zM,logdepthbuf_vertex:VM,map_fragment:HM,map_pars_fragment:GM,map_particle_fragment:WM,map_particle_pars_fragment:XM,metalnessmap_fragment:qM,metalnessmap_pars_fragment:YM,morphinstance_vertex:$M,morphcolor_vertex:KM,morphnormal_vertex:ZM,morphtarget_pars_vertex:JM,morphtarget_vertex:jM,normal_fragment_begin:QM,normal_fragment_maps:ew,normal_pars_fragment:tw,normal_pars_vertex:nw,normal_vertex:iw,normalmap_pars_fragment:sw,clearcoat_normal_fragment_begin:rw,clearcoat_normal_fragment_maps:ow,clearcoat_pars_fragment:aw,iridescence_pars_fragment:lw,opaque_fragment:cw,packing:uw,premultiplied_alpha_fragment:hw,project_vertex:dw,dithering_fragment:fw,dithering_pars_fragment:pw,roughnessmap_fragment:mw,roughnessmap_pars_fragment:gw,shadowmap_pars_fragment:_w,shadowmap_pars_vertex:xw,shadowmap_vertex:yw,shadowmask_pars_fragment:vw,skinbase_vertex:bw,skinning_pars_vertex:Sw,skinning_vertex:Mw,skinnormal_vertex:ww,specularmap_fragment:Ew,specularmap_pars_fragment:Tw,tonemapping_fragment:Aw,tonemapping_pars_fragment:Rw,transmission_fragment:Cw,transmission_pars_fragment:Pw,uv_pars_fragment:Iw,uv_pars_vertex:Lw,uv_vertex:Ow,worldpos_vertex:Nw,background_vert:Dw,background_frag:Uw,backgroundCube_vert:Fw,backgroundCube_frag:kw,cube_vert:Bw,cube_frag:zw,depth_vert:Vw,depth_frag:Hw,distance_vert:Gw,distance_frag:Ww,equirect_vert:Xw,equirect_frag:qw,linedashed_vert:Yw,linedashed_frag:$w,meshbasic_vert:Kw,meshbasic_frag:Zw,meshlambert_vert:Jw,meshlambert_frag:jw,meshmatcap_vert:Qw,meshmatcap_frag:eE,meshnormal_vert:tE,meshnormal_frag:nE,meshphong_vert:iE,meshphong_frag:sE,meshphysical_vert:rE,meshphysical_frag:oE,meshtoon_vert:aE,meshtoon_frag:lE,points_vert:cE,points_frag:uE,shadow_vert:hE,shadow_frag:dE,sprite_vert:fE,sprite_frag:pE},Se={common:{diffuse:{value:new De(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ke}},envmap:{envMap:{value:null},envMapRotation:{value:new Ke},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ke}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ke}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ke},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ke},normalScale:{value:new Fe(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ke},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ke}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ke}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ke}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new De(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new De(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0},uvTransform:{value:new Ke}},sprite:{diffuse:{value:new De(16777215)},opacity:{value:1},center:{value:new Fe(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ke},alphaMap:{value:null},alphaMapTransform:{value:new Ke},alphaTest:{value:0}}},jn={basic:{uniforms:Vn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.fog]),vertexShader:st.meshbasic_vert,fragmentShader:st.meshbasic_frag},lambert:{uniforms:Vn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new De(0)},envMapIntensity:{value:1}}]),vertexShader:st.meshlambert_vert,fragmentShader:st.meshlambert_frag},phong:{uniforms:Vn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new De(0)},specular:{value:new De(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:st.meshphong_vert,fragmentShader:st.meshphong_frag},standard:{uniforms:Vn([Se.common,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.roughnessmap,Se.metalnessmap,Se.fog,Se.lights,{emissive:{value:new De(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag},toon:{uniforms:Vn([Se.common,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.gradientmap,Se.fog,Se.lights,{emissive:{value:new De(0)}}]),vertexShader:st.meshtoon_vert,fragmentShader:st.meshtoon_frag},matcap:{uniforms:Vn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,{matcap:{value:null}}]),vertexShader:st.meshmatcap_vert,fragmentShader:st.meshmatcap_frag},points:{uniforms:Vn([Se.points,Se.fog]),vertexShader:st.points_vert,fragmentShader:st.points_frag},dashed:{uniforms:Vn([Se.common,Se.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:st.linedashed_vert,fragmentShader:st.linedashed_frag},depth:{uniforms:Vn([Se.common,Se.displacementmap]),vertexShader:st.depth_vert,fragmentShader:st.depth_frag},normal:{uniforms:Vn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,{opacity:{value:1}}]),vertexShader:st.meshnormal_vert,fragmentShader:st.meshnormal_frag},sprite:{uniforms:Vn([Se.sprite,Se.fog]),vertexShader:st.sprite_vert,fragmentShader:st.sprite_frag},background:{uniforms:{uvTransform:{value:new Ke},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:st.background_vert,fragmentShader:st.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ke}},vertexShader:st.backgroundCube_vert,fragmentShader:st.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:st.cube_vert,fragmentShader:st.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:st.equirect_vert,fragmentShader:st.equirect_frag},distance:{uniforms:Vn([Se.common,Se.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:st.distance_vert,fragmentShader:st.distance_frag},shadow:{uniforms:Vn([Se.lights,Se.fog,{color:{value:new De(0)},opacity:{value:1}}]),vertexShader:st.shadow_vert,fragmentShader:st.shadow_frag}};jn.physical={uniforms:Vn([jn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ke},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ke},clearcoatNormalScale:{value:new Fe(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ke},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ke},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ke},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ke},sheen:{value:0},sheenColor:{value:new De(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ke},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ke},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ke},transmissionSamplerSize:{value:new Fe},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ke},attenuationDistance:{value:0},attenuationColor:{value:new De(0)},specularColor:{value:new De(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ke},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ke},anisotropyVector:{value:new Fe},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ke}}]),vertexShader:st.meshphysical_vert,fragmentShader:st.meshphysical_frag};var bh={r:0,b:0,g:0},mE=new Ce,ex=new Ke;ex.set(-1,0,0,0,1,0,0,0,1);function gE(i,e,t,n,s,r){let o=new De(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let b=v.backgroundBlurriness>0;M=e.get(M,b)}return M}function m(v){let M=!1,b=f(v);b===null?g(o,a):b&&b.isColor&&(g(b,1),M=!0);let w=i.xr.getEnvironmentBlendMode();w==="additive"?t.buffers.color.setClear(0,0,0,1,r):w==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(v,M){let b=f(M);b&&b.isCubeTexture?(c===void 0&&(c=new Pt(new Oo(1,1,1),new dn({name:"BackgroundCubeMaterial",uniforms:Hr(jn.backgroundCube.uniforms),vertexShader:jn.backgroundCube.vertexShader,fragmentShader:jn.backgroundCube.fragmentShader,side:En,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(w,x,p){this.matrixWorld.copyPosition(p.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(mE.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ex),c.material.toneMapped=it.getTransfer(b.colorSpace)!==Ct,(u!==b||h!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Pt(new Ji(2,2),new dn({name:"BackgroundMaterial",uniforms:Hr(jn.background.uniforms),vertexShader:jn.background.vertexShader,fragmentShader:jn.background.fragmentShader,side:ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=it.getTransfer(b.colorSpace)!==Ct,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,M){v.getRGB(bh,gp(i)),t.buffers.color.setClear(bh.r,bh.g,bh.b,M,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:m,addToRenderList:y,dispose:_}}function _E(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(C,I,D,L,U){let V=!1,B=h(C,L,D,I);r!==B&&(r=B,c(r.object)),V=f(C,L,D,U),V&&m(C,L,D,U),U!==null&&e.update(U,i.ELEMENT_ARRAY_BUFFER),(V||o)&&(o=!1,b(C,I,D,L),U!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(U).buffer))}function l(){return i.createVertexArray()}function c(C){return i.bindVertexArray(C)}function u(C){return i.deleteVertexArray(C)}function h(C,I,D,L){let U=L.wireframe===!0,V=n[I.id];V===void 0&&(V={},n[I.id]=V);let B=C.isInstancedMesh===!0?C.id:0,ne=V[B];ne===void 0&&(ne={},V[B]=ne);let z=ne[D.id];z===void 0&&(z={},ne[D.id]=z);let q=z[U];return q===void 0&&(q=d(l()),z[U]=q),q}function d(C){let I=[],D=[],L=[];for(let U=0;U<t;U++)I[U]=0,D[U]=0,L[U]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:I,enabledAttributes:D,attributeDivisors:L,object:C,attributes:{},index:null}}function f(C,I,D,L){let U=r.attributes,V=I.attributes,B=0,ne=D.getAttributes();for(let z in ne)if(ne[z].location>=0){let W=U[z],_e=V[z];if(_e===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(_e=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(_e=C.instanceColor)),W===void 0||W.attribute!==_e||_e&&W.data!==_e.data)return!0;B++}return r.attributesNum!==B||r.index!==L}function m(C,I,D,L){let U={},V=I.attributes,B=0,ne=D.getAttributes();for(let z in ne)if(ne[z].location>=0){let W=V[z];W===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(W=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(W=C.instanceColor));let _e={};_e.attribute=W,W&&W.data&&(_e.data=W.data),U[z]=_e,B++}r.attributes=U,r.attributesNum=B,r.index=L}function y(){let C=r.newAttributes;for(let I=0,D=C.length;I<D;I++)C[I]=0}function g(C){_(C,0)}function _(C,I){let D=r.newAttributes,L=r.enabledAttributes,U=r.attributeDivisors;D[C]=1,L[C]===0&&(i.enableVertexAttribArray(C),L[C]=1),U[C]!==I&&(i.vertexAttribDivisor(C,I),U[C]=I)}function v(){let C=r.newAttributes,I=r.enabledAttributes;for(let D=0,L=I.length;D<L;D++)I[D]!==C[D]&&(i.disableVertexAttribArray(D),I[D]=0)}function M(C,I,D,L,U,V,B){B===!0?i.vertexAttribIPointer(C,I,D,U,V):i.vertexAttribPointer(C,I,D,L,U,V)}function b(C,I,D,L){y();let U=L.attributes,V=D.getAttributes(),B=I.defaultAttributeValues;for(let ne in V){let z=V[ne];if(z.location>=0){let q=U[ne];if(q===void 0&&(ne==="instanceMatrix"&&C.instanceMatrix&&(q=C.instanceMatrix),ne==="instanceColor"&&C.instanceColor&&(q=C.instanceColor)),q!==void 0){let W=q.normalized,_e=q.itemSize,Te=e.get(q);if(Te===void 0)continue;let $=Te.buffer,ae=Te.type,se=Te.bytesPerElement,ce=ae===i.INT||ae===i.UNSIGNED_INT||q.gpuType===ku;if(q.isInterleavedBufferAttribute){let re=q.data,de=re.isInterleavedBuffer===!0?re.stride:re.itemSize,Ye=q.offset;if(re.isInstancedInterleavedBuffer||re.isInstancedBufferAttribute){for(let Ae=0;Ae<z.locationSize;Ae++)_(z.location+Ae,re.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let Ae=0;Ae<z.locationSize;Ae++)g(z.location+Ae);i.bindBuffer(i.ARRAY_BUFFER,$);for(let Ae=0;Ae<z.locationSize;Ae++)M(z.location+Ae,_e/z.locationSize,ae,W,de*se,(Ye+_e/z.locationSize*Ae)*se,ce)}else{if(q.isInstancedBufferAttribute){for(let re=0;re<z.locationSize;re++)_(z.location+re,q.meshPerAttribute);C.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=q.meshPerAttribute*q.count)}else for(let re=0;re<z.locationSize;re++)g(z.location+re);i.bindBuffer(i.ARRAY_BUFFER,$);for(let re=0;re<z.locationSize;re++)M(z.location+re,_e/z.locationSize,ae,W,_e*se,_e/z.locationSize*re*se,ce)}}else if(B!==void 0){let W=B[ne];if(W!==void 0)switch(W.length){case 2:i.vertexAttrib2fv(z.location,W);break;case 3:i.vertexAttrib3fv(z.location,W);break;case 4:i.vertexAttrib4fv(z.location,W);break;default:i.vertexAttrib1fv(z.location,W)}}}}v()}function w(){A();for(let C in n){let I=n[C];for(let D in I){let L=I[D];for(let U in L){let V=L[U];for(let B in V)u(V[B].object),delete V[B];delete L[U]}}delete n[C]}}function x(C){if(n[C.id]===void 0)return;let I=n[C.id];for(let D in I){let L=I[D];for(let U in L){let V=L[U];for(let B in V)u(V[B].object),delete V[B];delete L[U]}}delete n[C.id]}function p(C){for(let I in n){let D=n[I];for(let L in D){let U=D[L];if(U[C.id]===void 0)continue;let V=U[C.id];for(let B in V)u(V[B].object),delete V[B];delete U[C.id]}}}function S(C){for(let I in n){let D=n[I],L=C.isInstancedMesh===!0?C.id:0,U=D[L];if(U!==void 0){for(let V in U){let B=U[V];for(let ne in B)u(B[ne].object),delete B[ne];delete U[V]}delete D[L],Object.keys(D).length===0&&delete n[I]}}}function A(){E(),o=!0,r!==s&&(r=s,c(r.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:A,resetDefaultState:E,dispose:w,releaseStatesOfGeometry:x,releaseStatesOfObject:S,releaseStatesOfProgram:p,initAttributes:y,enableAttribute:g,disableUnusedAttributes:v}}function xE(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function yE(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let p=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(p.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(p){return!(p!==ti&&n.convert(p)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(p){let S=p===Oi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(p!==si&&p!==Yn&&!S&&n.convert(p)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(p){if(p==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";p="mediump"}return p==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ue("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ue("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ue("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),w=i.getParameter(i.MAX_SAMPLES),x=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:y,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:b,maxSamples:w,samples:x}}function vE(i){let e=this,t=null,n=0,s=!1,r=!1,o=new qn,a=new Ke,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,y=h.clipIntersection,g=h.clipShadows,_=i.get(h);if(!s||m===null||m.length===0||r&&!g)r?u(null):c();else{let v=r?0:n,M=v*4,b=_.clippingState||null;l.value=b,b=u(m,d,M,f);for(let w=0;w!==M;++w)b[w]=t[w];_.clippingState=b,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,m){let y=h!==null?h.length:0,g=null;if(y!==0){if(g=l.value,m!==!0||g===null){let _=f+y*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<_)&&(g=new Float32Array(_));for(let M=0,b=f;M!==y;++M,b+=4)o.copy(h[M]).applyMatrix4(v,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,g}}var Ll=class extends zn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new il(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Oo(5,5,5),r=new dn({name:"CubemapFromEquirect",uniforms:Hr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:En,blending:es});r.uniforms.tEquirect.value=t;let o=new Pt(s,r),a=t.minFilter;return t.minFilter===yi&&(t.minFilter=hn),new Uo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},L_=256,bE=3,SE=20,tx=256,nx=16,ME=3,wE=new P,EE=new De,Mh=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Uo(1,10,null),this._boxMesh=new Pt(new Oo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=wE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(EE));let g=new Uo(n,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=D_(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=N_(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(L_,fp(e))}_fromTexture(e,t){e.mapping===Br||e.mapping===Bo?this._setSize(e.image.length===0?L_:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=O_(e,!1,!1),n=Math.log2(e)-bE;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=O_(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Br||e.mapping===Bo?(this._cubemapMaterial===null&&(this._cubemapMaterial=D_()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=N_()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=TE(),this._integrationMaterial=AE());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/nx);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-ME)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(tx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=RE());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function O_(i,e,t){return new Ll(i,{minFilter:yi,generateMipmaps:e,type:Oi,colorSpace:$n,depthBuffer:t})}function Ol(i,e,t){return new dn({name:i,uniforms:e,vertexShader:st.cube_vert,fragmentShader:t,side:En,blending:es,depthTest:!1,depthWrite:!1})}function TE(){return Ol("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${tx}u

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
	`)}function AE(){return Ol("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:nx}},`

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
	`)}function RE(){return Ol("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${SE}
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
	`)}function N_(){return Ol("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function D_(){return Ol("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function CE(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Du||f===Uu)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let y=new Ll(m.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===Du||f===Uu,y=f===Br||f===Bo;if(m||y){let g=t.get(d),_=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==_)return n===null&&(n=new Mh(i)),g=m?n.fromEquirectangular(d,g):n.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let v=d.image;return m&&v&&v.height>0||y&&v&&l(v)?(n===null&&(n=new Mh(i)),g=m?n.fromEquirectangular(d):n.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===Du?d.mapping=Br:f===Uu&&(d.mapping=Bo),d}function l(d){let f=0,m=6;for(let y=0;y<m;y++)d[y]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function PE(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Pr("WebGLRenderer: "+n+" extension not supported."),s}}}function IE(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let y=r.get(m);y&&(e.remove(y),r.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(m){let y=m.attributes;for(let g in y)e.update(y[g],i.ARRAY_BUFFER)}function h(m){let y=m.index,g=m.attributes.position,_=0;if(g===void 0)return;let v=y!==null?y.array.length:g.array.length/3-1,M=g.count>=65535?Ja:Za,b=new M(Math.ceil(v/3)*6,1),w=b.array;if(y!==null){let p=y.array;_=y.version;for(let S=0,A=0;S<v;S+=3){let E=p[S+0],C=p[S+1],I=p[S+2];w[A++]=E,w[A++]=C,w[A++]=C,w[A++]=I,w[A++]=I,w[A++]=E}}else{_=g.version;for(let p=0,S=0;p<v;p+=3){let A=p+0,E=p+1,C=p+2;w[S++]=A,w[S++]=E,w[S++]=E,w[S++]=C,w[S++]=C,w[S++]=A}}b.version=_;let x=r.get(m);x&&e.remove(x),r.set(m,b)}function d(m){let y=r.get(m);if(y){let g=m.index;g!==null&&y.version<g.version&&h(m)}else h(m);return r.get(m)}function f(){for(let m in s){let y=s[m].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function LE(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){i.drawElements(n,d,r,h*o),t.update(d,n,1)}function c(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),t.update(d,n,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let y=0;for(let g=0;g<f;g++)y+=d[g];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function OE(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Xe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function NE(i,e,t){let n=new WeakMap,s=new ct;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let A=function(){p.dispose(),n.delete(a),a.removeEventListener("dispose",A)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],M=0;f===!0&&(M=1),m===!0&&(M=2),y===!0&&(M=3);let b=a.attributes.position.count*M,w=1;b>e.maxTextureSize&&(w=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let x=new Float32Array(b*w*4*h),p=new $a(x,b,w,h);p.type=Yn,p.needsUpdate=!0;let S=M*4;for(let E=0;E<h;E++){let C=g[E],I=_[E],D=v[E],L=b*w*4*E;for(let U=0;U<C.count;U++){let V=U*S;f===!0&&(s.fromBufferAttribute(C,U),x[L+V+0]=s.x,x[L+V+1]=s.y,x[L+V+2]=s.z,x[L+V+3]=0),m===!0&&(s.fromBufferAttribute(I,U),x[L+V+4]=s.x,x[L+V+5]=s.y,x[L+V+6]=s.z,x[L+V+7]=0),y===!0&&(s.fromBufferAttribute(D,U),x[L+V+8]=s.x,x[L+V+9]=s.y,x[L+V+10]=s.z,x[L+V+11]=D.itemSize===4?s.w:1)}}d={count:h,texture:p,size:new Fe(b,w)},n.set(a,d),a.addEventListener("dispose",A)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let y=0;y<c.length;y++)f+=c[y];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function DE(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var UE={[Yf]:"LINEAR_TONE_MAPPING",[$f]:"REINHARD_TONE_MAPPING",[Kf]:"CINEON_TONE_MAPPING",[Zf]:"ACES_FILMIC_TONE_MAPPING",[jf]:"AGX_TONE_MAPPING",[yl]:"NEUTRAL_TONE_MAPPING",[Jf]:"CUSTOM_TONE_MAPPING"};function FE(i,e,t,n,s,r){let o=new zn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new $t;u.setAttribute("position",new un([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new un([0,2,0,0,2,0],2));let h=new Mu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Pt(u,h),f=new Ds(-1,1,1,-1,0,1),m=null,y=null,g=!1,_,v=null,M=[],b=!1;this.setSize=function(w,x){o.setSize(w,x),a!==null&&a.setSize(w,x),l!==null&&l.setSize(w,x);for(let p=0;p<M.length;p++){let S=M[p];S.setSize&&S.setSize(w,x)}},this.setEffects=function(w){M=w,b=M.length>0&&M[0].isRenderPass===!0;let x=o.width,p=o.height;M.length>0&&a===null&&(a=new zn(x,p,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new zn(x,p,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&M.some(A=>A.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&c===null&&(c=new Cs(x,p),r===!0&&(c.format=Fs,c.type=Vr)),o.dispose(),o.depthTexture=S?c:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let A=0;A<M.length;A++){let E=M[A];E.setSize&&E.setSize(x,p),S&&E.needsDepthTexture===!0&&E.setDepthTexture&&E.setDepthTexture(c)}},this.begin=function(w,x){if(g||w.toneMapping===ts&&M.length===0)return!1;if(v=x,x!==null){let p=x.width,S=x.height;(o.width!==p||o.height!==S)&&this.setSize(p,S)}return b===!1&&w.setRenderTarget(o),_=w.toneMapping,w.toneMapping=ts,!0},this.hasRenderPass=function(){return b},this.end=function(w,x){w.toneMapping=_,g=!0;let p=o,S=a;for(let A=0;A<M.length;A++){let E=M[A];E.enabled!==!1&&(E.render(w,S,p,x),E.needsSwap!==!1&&(p=S,S=S===a?l:a))}if(m!==w.outputColorSpace||y!==w.toneMapping){m=w.outputColorSpace,y=w.toneMapping,h.defines={},it.getTransfer(m)===Ct&&(h.defines.SRGB_TRANSFER="");let A=UE[y];A&&(h.defines[A]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=p.texture,w.setRenderTarget(v),w.render(d,f),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var ix=new vn,sx=new Cs(1,1),rx=new sl(1),ox=new $a,ax=new vu,lx=new il,U_=[],F_=[],k_=new Float32Array(16),B_=new Float32Array(9),z_=new Float32Array(4);function qo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=U_[s];if(r===void 0&&(r=new Float32Array(s),U_[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function fn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function pn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Eh(i,e){let t=F_[e];t===void 0&&(t=new Int32Array(e),F_[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function kE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function BE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(fn(t,e))return;i.uniform2fv(this.addr,e),pn(t,e)}}function zE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(fn(t,e))return;i.uniform3fv(this.addr,e),pn(t,e)}}function VE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(fn(t,e))return;i.uniform4fv(this.addr,e),pn(t,e)}}function HE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(fn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),pn(t,e)}else{if(fn(t,n))return;z_.set(n),i.uniformMatrix2fv(this.addr,!1,z_),pn(t,n)}}function GE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(fn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),pn(t,e)}else{if(fn(t,n))return;B_.set(n),i.uniformMatrix3fv(this.addr,!1,B_),pn(t,n)}}function WE(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(fn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),pn(t,e)}else{if(fn(t,n))return;k_.set(n),i.uniformMatrix4fv(this.addr,!1,k_),pn(t,n)}}function XE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function qE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(fn(t,e))return;i.uniform2iv(this.addr,e),pn(t,e)}}function YE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(fn(t,e))return;i.uniform3iv(this.addr,e),pn(t,e)}}function $E(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(fn(t,e))return;i.uniform4iv(this.addr,e),pn(t,e)}}function KE(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function ZE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(fn(t,e))return;i.uniform2uiv(this.addr,e),pn(t,e)}}function JE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(fn(t,e))return;i.uniform3uiv(this.addr,e),pn(t,e)}}function jE(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(fn(t,e))return;i.uniform4uiv(this.addr,e),pn(t,e)}}function Th(i){return i.version===0&&(i.compareFunction=cp,i.needsUpdate=!0),i}function QE(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Th(sx):r=ix,t.setTexture2D(e||r,s)}function eT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||ax,s)}function tT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Th(rx):r=lx,t.setTextureCube(e||r,s)}function nT(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||ox,s)}function iT(i){switch(i){case 5126:return kE;case 35664:return BE;case 35665:return zE;case 35666:return VE;case 35674:return HE;case 35675:return GE;case 35676:return WE;case 5124:case 35670:return XE;case 35667:case 35671:return qE;case 35668:case 35672:return YE;case 35669:case 35673:return $E;case 5125:return KE;case 36294:return ZE;case 36295:return JE;case 36296:return jE;case 35678:case 36198:case 36298:case 36306:case 35682:return QE;case 35679:case 36299:case 36307:return eT;case 35680:case 36300:case 36308:case 36293:return tT;case 36289:case 36303:case 36311:case 36292:return nT}}function sT(i,e){i.uniform1fv(this.addr,e)}function rT(i,e){let t=qo(e,this.size,2);i.uniform2fv(this.addr,t)}function oT(i,e){let t=qo(e,this.size,3);i.uniform3fv(this.addr,t)}function aT(i,e){let t=qo(e,this.size,4);i.uniform4fv(this.addr,t)}function lT(i,e){let t=qo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function cT(i,e){let t=qo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function uT(i,e){let t=qo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function hT(i,e){i.uniform1iv(this.addr,e)}function dT(i,e){i.uniform2iv(this.addr,e)}function fT(i,e){i.uniform3iv(this.addr,e)}function pT(i,e){i.uniform4iv(this.addr,e)}function mT(i,e){i.uniform1uiv(this.addr,e)}function gT(i,e){i.uniform2uiv(this.addr,e)}function _T(i,e){i.uniform3uiv(this.addr,e)}function xT(i,e){i.uniform4uiv(this.addr,e)}function yT(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);fn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Th(sx):o=ix;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function vT(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);fn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ax,r[o])}function bT(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);fn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Th(rx):o=lx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function ST(i,e,t){let n=this.cache,s=e.length,r=Eh(t,s);fn(n,r)||(i.uniform1iv(this.addr,r),pn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ox,r[o])}function MT(i){switch(i){case 5126:return sT;case 35664:return rT;case 35665:return oT;case 35666:return aT;case 35674:return lT;case 35675:return cT;case 35676:return uT;case 5124:case 35670:return hT;case 35667:case 35671:return dT;case 35668:case 35672:return fT;case 35669:case 35673:return pT;case 5125:return mT;case 36294:return gT;case 36295:return _T;case 36296:return xT;case 35678:case 36198:case 36298:case 36306:case 35682:return yT;case 35679:case 36299:case 36307:return vT;case 35680:case 36300:case 36308:case 36293:return bT;case 36289:case 36303:case 36311:case 36292:return ST}}var Sp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=iT(t.type)}},Mp=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=MT(t.type)}},wp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},vp=/(\w+)(\])?(\[|\.)?/g;function V_(i,e){i.seq.push(e),i.map[e.id]=e}function wT(i,e,t){let n=i.name,s=n.length;for(vp.lastIndex=0;;){let r=vp.exec(n),o=vp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){V_(t,c===void 0?new Sp(a,i,e):new Mp(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new wp(a),V_(t,h)),t=h}}}var Wo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);wT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function H_(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var ET=37297,TT=0;function AT(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var G_=new Ke;function RT(i){it._getMatrix(G_,it.workingColorSpace,i);let e=`mat3( ${G_.elements.map(t=>t.toFixed(4))} )`;switch(it.getTransfer(i)){case qa:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return Ue("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function W_(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+AT(i.getShaderSource(e),a)}else return r}function CT(i,e){let t=RT(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var PT={[Yf]:"Linear",[$f]:"Reinhard",[Kf]:"Cineon",[Zf]:"ACESFilmic",[jf]:"AgX",[yl]:"Neutral",[Jf]:"Custom"};function IT(i,e){let t=PT[e];return t===void 0?(Ue("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Sh=new P;function LT(){it.getLuminanceCoefficients(Sh);let i=Sh.x.toFixed(4),e=Sh.y.toFixed(4),t=Sh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function OT(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Il).join(`
`)}function NT(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function DT(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Il(i){return i!==""}function X_(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function q_(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var UT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ep(i){return i.replace(UT,FT)}function FT(i,e){let t=st[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Ep(t)}var kT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Y_(i){return i.replace(kT,BT)}function BT(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function $_(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var zT={[xl]:"SHADOWMAP_TYPE_PCF",[Fo]:"SHADOWMAP_TYPE_VSM"};function VT(i){return zT[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var HT={[Bo]:"ENVMAP_MODE_REFRACTION"};function GT(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":HT[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var WT={[Nu]:"ENVMAP_BLENDING_MULTIPLY",[f_]:"ENVMAP_BLENDING_MIX",[p_]:"ENVMAP_BLENDING_ADD"};function XT(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":WT[i.combine]||"ENVMAP_BLENDING_NONE"}function qT(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=VT(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=GT(t),h=XT(t),d=OT(t),f=NT(r),m=s.createProgram(),y,g,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Il).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Il).join(`
`),g.length>0&&(g+=`
`)):(y=[$_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Il).join(`
`),g=[$_(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?st.tonemapping_pars_fragment:"",t.toneMapping!==ts?IT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",st.colorspace_pars_fragment,CT("linearToOutputTexel",t.outputColorSpace),LT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Il).join(`
`)),o=Ep(o),o=X_(o,t),o=q_(o,t),a=Ep(a),a=X_(a,t),a=q_(a,t),o=Y_(o),a=Y_(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",t.glslVersion===hp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===hp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=_+y+o,M=_+g+a,b=H_(s,s.VERTEX_SHADER,v),w=H_(s,s.FRAGMENT_SHADER,M);s.attachShader(m,b),s.attachShader(m,w),t.index0AttributeName!==void 0?s.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function x(E){if(i.debug.checkShaderErrors){let C=s.getProgramInfoLog(m)||"",I=s.getShaderInfoLog(b)||"",D=s.getShaderInfoLog(w)||"",L=C.trim(),U=I.trim(),V=D.trim(),B=!0,ne=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(B=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,m,b,w);else{let z=W_(s,b,"vertex"),q=W_(s,w,"fragment");Xe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+E.name+`
Material Type: `+E.type+`

Program Info Log: `+L+`
`+z+`
`+q)}else L!==""?Ue("WebGLProgram: Program Info Log:",L):(U===""||V==="")&&(ne=!1);ne&&(E.diagnostics={runnable:B,programLog:L,vertexShader:{log:U,prefix:y},fragmentShader:{log:V,prefix:g}})}s.deleteShader(b),s.deleteShader(w),p=new Wo(s,m),S=DT(s,m)}let p;this.getUniforms=function(){return p===void 0&&x(this),p};let S;this.getAttributes=function(){return S===void 0&&x(this),S};let A=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return A===!1&&(A=s.getProgramParameter(m,ET)),A},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=TT++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=b,this.fragmentShader=w,this}var YT=0,Tp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Ap(e),t.set(e,n)),n}},Ap=class{constructor(e){this.id=YT++,this.code=e,this.usedTimes=0}};function $T(i){return i===nr||i===El||i===Tl}function KT(i,e,t,n,s,r){let o=new Co,a=new Tp,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(p){return l.add(p),p===0?"uv":`uv${p}`}function m(p,S,A,E,C,I){let D=E.fog,L=C.geometry,U=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?E.environment:null,V=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap,B=e.get(p.envMap||U,V),ne=d[p.type],z=n.precision;p.precision!==null&&(z=n.getMaxPrecision(p.precision),z!==p.precision&&Ue("WebGLProgram.getParameters:",p.precision,"not supported, using",z,"instead."));let q=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,W=q!==void 0?q.length:0,_e=0;L.morphAttributes.position!==void 0&&(_e=1),L.morphAttributes.normal!==void 0&&(_e=2),L.morphAttributes.color!==void 0&&(_e=3);let Te,$,ae,se;if(ne){let we=jn[ne];Te=we.vertexShader,$=we.fragmentShader}else{Te=p.vertexShader,$=p.fragmentShader;let we=a.getVertexShaderStage(p),Nt=a.getFragmentShaderStage(p);a.update(p,we,Nt),ae=we.id,se=Nt.id}let ce=i.getRenderTarget(),re=i.state.buffers.depth.getReversed(),de=C.isInstancedMesh===!0,Ye=C.isBatchedMesh===!0,Ae=!!p.map,Be=!!p.matcap,Le=!!B,Me=Le&&B.isPMREMTexture===!0,pt=!!p.aoMap,Ge=!!p.lightMap,rt=!!p.bumpMap&&p.wireframe===!1,je=!!p.normalMap,Sn=!!p.displacementMap,Ot=!!p.emissiveMap,mn=!!p.metalnessMap,Rt=!!p.roughnessMap,Kt=p.anisotropy>0,k=p.clearcoat>0,Ft=p.diffuseRoughness>0,mt=p.dispersion>0,Dt=p.retroreflectivity>0,ye=p.iridescence>0,Gt=p.sheen>0,Oe=p.transmission>0,We=Kt&&!!p.anisotropyMap,O=k&&!!p.clearcoatMap,T=k&&!!p.clearcoatNormalMap,G=k&&!!p.clearcoatRoughnessMap,oe=Ft&&!!p.diffuseRoughnessMap,te=ye&&!!p.iridescenceMap,fe=ye&&!!p.iridescenceThicknessMap,ve=Gt&&!!p.sheenColorMap,j=Gt&&!!p.sheenRoughnessMap,Q=!!p.specularMap,me=!!p.specularColorMap,N=!!p.specularIntensityMap,ee=Oe&&!!p.transmissionMap,J=Oe&&!!p.thicknessMap,ge=!!p.gradientMap,he=!!p.alphaMap,pe=p.alphaTest>0,ke=!!p.alphaHash,nt=!!p.extensions,le=ts;p.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(le=i.toneMapping);let ze=Me?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,Qe={shaderID:ne,shaderType:p.type,shaderName:p.name,vertexShader:Te,fragmentShader:$,defines:p.defines,customVertexShaderID:ae,customFragmentShaderID:se,isRawShaderMaterial:p.isRawShaderMaterial===!0,glslVersion:p.glslVersion,precision:z,batching:Ye,batchingColor:Ye&&C._colorsTexture!==null,instancing:de,instancingColor:de&&C.instanceColor!==null,instancingMorph:de&&C.morphTexture!==null,outputColorSpace:ce===null?i.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:it.workingColorSpace,alphaToCoverage:!!p.alphaToCoverage,map:Ae,matcap:Be,envMap:Le,envMapMode:Le&&B.mapping,envMapPMREM:Me,envMapMaxLod:Me?ze.length-1:null,envMapSize:Me?ze[0].width:null,aoMap:pt,lightMap:Ge,bumpMap:rt,normalMap:je,displacementMap:Sn,emissiveMap:Ot,normalMapObjectSpace:je&&p.normalMapType===x_,normalMapTangentSpace:je&&p.normalMapType===Rl,packedNormalMap:je&&p.normalMapType===Rl&&$T(p.normalMap.format),metalnessMap:mn,roughnessMap:Rt,anisotropy:Kt,anisotropyMap:We,clearcoat:k,clearcoatMap:O,clearcoatNormalMap:T,clearcoatRoughnessMap:G,diffuseRoughness:Ft,diffuseRoughnessMap:oe,dispersion:mt,retroreflection:Dt,iridescence:ye,iridescenceMap:te,iridescenceThicknessMap:fe,sheen:Gt,sheenColorMap:ve,sheenRoughnessMap:j,specularMap:Q,specularColorMap:me,specularIntensityMap:N,transmission:Oe,transmissionMap:ee,thicknessMap:J,gradientMap:ge,opaque:p.transparent===!1&&p.blending===ko&&p.alphaToCoverage===!1,alphaMap:he,alphaTest:pe,alphaHash:ke,combine:p.combine,mapUv:Ae&&f(p.map.channel),aoMapUv:pt&&f(p.aoMap.channel),lightMapUv:Ge&&f(p.lightMap.channel),bumpMapUv:rt&&f(p.bumpMap.channel),normalMapUv:je&&f(p.normalMap.channel),displacementMapUv:Sn&&f(p.displacementMap.channel),emissiveMapUv:Ot&&f(p.emissiveMap.channel),metalnessMapUv:mn&&f(p.metalnessMap.channel),roughnessMapUv:Rt&&f(p.roughnessMap.channel),anisotropyMapUv:We&&f(p.anisotropyMap.channel),clearcoatMapUv:O&&f(p.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(p.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:G&&f(p.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:oe&&f(p.diffuseRoughnessMap.channel),iridescenceMapUv:te&&f(p.iridescenceMap.channel),iridescenceThicknessMapUv:fe&&f(p.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(p.sheenColorMap.channel),sheenRoughnessMapUv:j&&f(p.sheenRoughnessMap.channel),specularMapUv:Q&&f(p.specularMap.channel),specularColorMapUv:me&&f(p.specularColorMap.channel),specularIntensityMapUv:N&&f(p.specularIntensityMap.channel),transmissionMapUv:ee&&f(p.transmissionMap.channel),thicknessMapUv:J&&f(p.thicknessMap.channel),alphaMapUv:he&&f(p.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(je||Kt),vertexNormals:!!L.attributes.normal,vertexColors:p.vertexColors,vertexAlphas:p.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!L.attributes.uv&&(Ae||he),fog:!!D,useFog:p.fog===!0,fogExp2:!!D&&D.isFogExp2,flatShading:p.wireframe===!1&&(p.flatShading===!0||L.attributes.normal===void 0&&je===!1&&(p.isMeshLambertMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isMeshPhysicalMaterial)),sizeAttenuation:p.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:re,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:W,morphTextureStride:_e,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:I.filter(we=>we.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:p.dithering,shadowMapEnabled:i.shadowMap.enabled&&A.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:Ae&&p.map.isVideoTexture===!0&&it.getTransfer(p.map.colorSpace)===Ct,decodeVideoTextureEmissive:Ot&&p.emissiveMap.isVideoTexture===!0&&it.getTransfer(p.emissiveMap.colorSpace)===Ct,premultipliedAlpha:p.premultipliedAlpha,doubleSided:p.side===an,flipSided:p.side===En,useDepthPacking:p.depthPacking>=0,depthPacking:p.depthPacking||0,index0AttributeName:p.index0AttributeName,extensionClipCullDistance:nt&&p.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(nt&&p.extensions.multiDraw===!0||Ye)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:p.customProgramCacheKey()};return Qe.vertexUv1s=l.has(1),Qe.vertexUv2s=l.has(2),Qe.vertexUv3s=l.has(3),l.clear(),Qe}function y(p){let S=[];if(p.shaderID?S.push(p.shaderID):(S.push(p.customVertexShaderID),S.push(p.customFragmentShaderID)),p.defines!==void 0)for(let A in p.defines)S.push(A),S.push(p.defines[A]);return p.isRawShaderMaterial===!1&&(g(S,p),_(S,p),S.push(i.outputColorSpace)),S.push(p.customProgramCacheKey),S.join()}function g(p,S){p.push(S.precision),p.push(S.outputColorSpace),p.push(S.envMapMode),p.push(S.envMapPMREM),p.push(S.envMapMaxLod),p.push(S.envMapSize),p.push(S.mapUv),p.push(S.alphaMapUv),p.push(S.lightMapUv),p.push(S.aoMapUv),p.push(S.bumpMapUv),p.push(S.normalMapUv),p.push(S.displacementMapUv),p.push(S.emissiveMapUv),p.push(S.metalnessMapUv),p.push(S.roughnessMapUv),p.push(S.anisotropyMapUv),p.push(S.clearcoatMapUv),p.push(S.clearcoatNormalMapUv),p.push(S.clearcoatRoughnessMapUv),p.push(S.diffuseRoughnessMapUv),p.push(S.iridescenceMapUv),p.push(S.iridescenceThicknessMapUv),p.push(S.sheenColorMapUv),p.push(S.sheenRoughnessMapUv),p.push(S.specularMapUv),p.push(S.specularColorMapUv),p.push(S.specularIntensityMapUv),p.push(S.transmissionMapUv),p.push(S.thicknessMapUv),p.push(S.combine),p.push(S.fogExp2),p.push(S.sizeAttenuation),p.push(S.morphTargetsCount),p.push(S.numSunLights),p.push(S.numDirLights),p.push(S.numPointLights),p.push(S.numSpotLights),p.push(S.numSpotLightMaps),p.push(S.numHemiLights),p.push(S.numRectAreaLights),p.push(S.numSunLightShadows),p.push(S.numDirLightShadows),p.push(S.numPointLightShadows),p.push(S.numSpotLightShadows),p.push(S.numSpotLightShadowsWithMaps),p.push(S.numLightProbes),p.push(S.numLightProbeGrids),p.push(S.shadowMapType),p.push(S.toneMapping),p.push(S.numClippingPlanes),p.push(S.numClipIntersection),p.push(S.depthPacking)}function _(p,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),p.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),p.push(o.mask)}function v(p){let S=d[p.type],A;if(S){let E=jn[S];A=Cl.clone(E.uniforms)}else A=p.uniforms;return A}function M(p,S){let A=u.get(S);return A!==void 0?++A.usedTimes:(A=new qT(i,S,p,s),c.push(A),u.set(S,A)),A}function b(p){if(--p.usedTimes===0){let S=c.indexOf(p);c[S]=c[c.length-1],c.pop(),u.delete(p.cacheKey),p.destroy()}}function w(p){a.remove(p)}function x(){a.dispose()}return{getParameters:m,getProgramCacheKey:y,getUniforms:v,acquireProgram:M,releaseProgram:b,releaseShaderCache:w,programs:c,dispose:x}}function ZT(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function JT(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function K_(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Z_(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,y,g,_){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:g,group:_},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=m,v.materialVariant=o(d),v.groupOrder=y,v.renderOrder=d.renderOrder,v.z=g,v.group=_),e++,v}function l(d,f,m,y,g,_,v){v.reversedDepth===!0&&(g=-g);let M=a(d,f,m,y,g,_);m.transmission>0?n.push(M):m.transparent===!0?s.push(M):t.push(M)}function c(d,f,m,y,g,_){let v=a(d,f,m,y,g,_);m.transmission>0?n.unshift(v):m.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||JT),n.length>1&&n.sort(f||K_),s.length>1&&s.sort(f||K_)}function h(){for(let d=e,f=i.length;d<f;d++){let m=i[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function jT(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Z_,i.set(n,[o])):s>=r.length?(o=new Z_,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function QT(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new P,color:new De};break;case"SpotLight":t={position:new P,direction:new P,color:new De,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new P,color:new De,distance:0,decay:0};break;case"HemisphereLight":t={direction:new P,skyColor:new De,groundColor:new De};break;case"RectAreaLight":t={color:new De,position:new P,halfWidth:new P,halfHeight:new P};break}return i[e.id]=t,t}}}function e1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Fe,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var t1=0;function n1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function i1(i){let e=new QT,t=e1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new P);let s=new P,r=new Ce,o=new Ce;function a(c){let u=0,h=0,d=0;for(let I=0;I<9;I++)n.probe[I].set(0,0,0);let f=0,m=0,y=0,g=0,_=0,v=0,M=0,b=0,w=0,x=0,p=0,S=0,A=0,E=0;c.sort(n1);for(let I=0,D=c.length;I<D;I++){let L=c[I],U=L.color,V=L.intensity,B=L.distance,ne=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===nr?ne=L.shadow.map.texture:ne=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=U.r*V,h+=U.g*V,d+=U.b*V;else if(L.isLightProbe){for(let z=0;z<9;z++)n.probe[z].addScaledVector(L.sh.coefficients[z],V);E++}else if(L.isSunLight){let z=e.get(L);if(z.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let q=L.shadow,W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize.copy(q.mapSize).multiply(q.getFrameExtents()),n.sunShadow[m]=W,n.sunShadowMap[m]=ne;let _e=q.getViewportCount();for(let Te=0;Te<_e;Te++)n.sunShadowMatrix[y+Te]=q.getMatrix(Te),n.sunShadowCascade[y+Te]=q._cascadeData[Te];y+=_e,m++}n.sun[f]=z,f++}else if(L.isDirectionalLight){let z=e.get(L);if(z.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let q=L.shadow,W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,n.directionalShadow[g]=W,n.directionalShadowMap[g]=ne,n.directionalShadowMatrix[g]=L.shadow.matrix,w++}n.directional[g]=z,g++}else if(L.isSpotLight){let z=e.get(L);z.position.setFromMatrixPosition(L.matrixWorld),z.color.copy(U).multiplyScalar(V),z.distance=B,z.coneCos=Math.cos(L.angle),z.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),z.decay=L.decay,n.spot[v]=z;let q=L.shadow;if(L.map&&(n.spotLightMap[S]=L.map,S++,q.updateMatrices(L),L.castShadow&&A++),n.spotLightMatrix[v]=q.matrix,L.castShadow){let W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,n.spotShadow[v]=W,n.spotShadowMap[v]=ne,p++}v++}else if(L.isRectAreaLight){let z=e.get(L);z.color.copy(U).multiplyScalar(V),z.halfWidth.set(L.width*.5,0,0),z.halfHeight.set(0,L.height*.5,0),n.rectArea[M]=z,M++}else if(L.isPointLight){let z=e.get(L);if(z.color.copy(L.color).multiplyScalar(L.intensity),z.distance=L.distance,z.decay=L.decay,L.castShadow){let q=L.shadow,W=t.get(L);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,W.shadowCameraNear=q.camera.near,W.shadowCameraFar=q.camera.far,n.pointShadow[_]=W,n.pointShadowMap[_]=ne,n.pointShadowMatrix[_]=L.shadow.matrix,x++}n.point[_]=z,_++}else if(L.isHemisphereLight){let z=e.get(L);z.skyColor.copy(L.color).multiplyScalar(V),z.groundColor.copy(L.groundColor).multiplyScalar(V),n.hemi[b]=z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Se.LTC_FLOAT_1,n.rectAreaLTC2=Se.LTC_FLOAT_2):(n.rectAreaLTC1=Se.LTC_HALF_1,n.rectAreaLTC2=Se.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let C=n.hash;(C.sunLength!==f||C.directionalLength!==g||C.pointLength!==_||C.spotLength!==v||C.rectAreaLength!==M||C.hemiLength!==b||C.numSunShadows!==m||C.numDirectionalShadows!==w||C.numPointShadows!==x||C.numSpotShadows!==p||C.numSpotMaps!==S||C.numLightProbes!==E)&&(n.sun.length=f,n.directional.length=g,n.spot.length=v,n.rectArea.length=M,n.point.length=_,n.hemi.length=b,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=w,n.directionalShadowMap.length=w,n.directionalShadowMatrix.length=w,n.pointShadow.length=x,n.pointShadowMap.length=x,n.pointShadowMatrix.length=x,n.spotShadow.length=p,n.spotShadowMap.length=p,n.spotLightMatrix.length=p+S-A,n.spotLightMap.length=S,n.numSpotLightShadowsWithMaps=A,n.numLightProbes=E,C.sunLength=f,C.directionalLength=g,C.pointLength=_,C.spotLength=v,C.rectAreaLength=M,C.hemiLength=b,C.numSunShadows=m,C.numDirectionalShadows=w,C.numPointShadows=x,C.numSpotShadows=p,C.numSpotMaps=S,C.numLightProbes=E,n.version=t1++)}function l(c,u){let h=0,d=0,f=0,m=0,y=0,g=0,_=u.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let b=c[v];if(b.isSunLight){let w=n.sun[h];w.direction.setFromMatrixPosition(b.matrixWorld),w.direction.transformDirection(_),h++}else if(b.isDirectionalLight){let w=n.directional[d];w.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(_),d++}else if(b.isSpotLight){let w=n.spot[m];w.position.setFromMatrixPosition(b.matrixWorld),w.position.applyMatrix4(_),w.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),w.direction.sub(s),w.direction.transformDirection(_),m++}else if(b.isRectAreaLight){let w=n.rectArea[y];w.position.setFromMatrixPosition(b.matrixWorld),w.position.applyMatrix4(_),o.identity(),r.copy(b.matrixWorld),r.premultiply(_),o.extractRotation(r),w.halfWidth.set(b.width*.5,0,0),w.halfHeight.set(0,b.height*.5,0),w.halfWidth.applyMatrix4(o),w.halfHeight.applyMatrix4(o),y++}else if(b.isPointLight){let w=n.point[f];w.position.setFromMatrixPosition(b.matrixWorld),w.position.applyMatrix4(_),f++}else if(b.isHemisphereLight){let w=n.hemi[g];w.direction.setFromMatrixPosition(b.matrixWorld),w.direction.transformDirection(_),g++}}}return{setup:a,setupView:l,state:n}}function J_(i){let e=new i1(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function s1(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new J_(i),e.set(s,[a])):r>=o.length?(a=new J_(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var r1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,o1=`uniform sampler2D shadow_pass;
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
}`,a1=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],l1=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],j_=new Ce,Pl=new P,bp=new P;function c1(i,e,t){let n=new Rs,s=new Fe,r=new Fe,o=new ct,a=new wu,l=new Eu,c={},u=t.maxTextureSize,h={[ci]:En,[En]:ci,[an]:an},d=new dn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Fe},radius:{value:4}},vertexShader:r1,fragmentShader:o1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new $t;m.setAttribute("position",new gt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Pt(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=xl;let _=this.type;this.render=function(x,p,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||x.length===0)return;this.type===$0&&(Ue("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=xl);let A=i.getRenderTarget(),E=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),I=i.state;I.setBlending(es),I.buffers.depth.getReversed()===!0?I.buffers.color.setClear(0,0,0,0):I.buffers.color.setClear(1,1,1,1),I.buffers.depth.setTest(!0),I.setScissorTest(!1);let D=_!==this.type;D&&p.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(U=>U.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,U=x.length;L<U;L++){let V=x[L],B=V.shadow;if(B===void 0){Ue("WebGLShadowMap:",V,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let ne=B.getFrameExtents();s.multiply(ne),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ne.x),s.x=r.x*ne.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ne.y),s.y=r.y*ne.y,B.mapSize.y=r.y));let z=i.state.buffers.depth.getReversed();if(B.camera._reversedDepth=z,B.map===null||D===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===Fo){if(V.isPointLight){Ue("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new zn(s.x,s.y,{format:nr,type:Oi,minFilter:hn,magFilter:hn,generateMipmaps:!1}),B.map.texture.name=V.name+".shadowMap",B.map.depthTexture=new Cs(s.x,s.y,Yn),B.map.depthTexture.name=V.name+".shadowMapDepth",B.map.depthTexture.format=Ts,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=nn,B.map.depthTexture.magFilter=nn}else V.isPointLight?(B.map=new Ll(s.x),B.map.depthTexture=new sl(s.x,vi)):(B.map=new zn(s.x,s.y),B.map.depthTexture=new Cs(s.x,s.y,vi)),B.map.depthTexture.name=V.name+".shadowMap",B.map.depthTexture.format=Ts,this.type===xl?(B.map.depthTexture.compareFunction=z?lp:ap,B.map.depthTexture.minFilter=hn,B.map.depthTexture.magFilter=hn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=nn,B.map.depthTexture.magFilter=nn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let q=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();V.isPointLight!==!0&&B.updateMatrices(V,S);let W=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:S.layers;for(let _e=0;_e<q;_e++){let Te=B.getCamera(_e);if(V.isPointLight){let $=B.camera,ae=B.matrix,se=V.distance||$.far;se!==$.far&&($.far=se,$.updateProjectionMatrix()),Pl.setFromMatrixPosition(V.matrixWorld),$.position.copy(Pl),bp.copy($.position),bp.add(a1[_e]),$.up.copy(l1[_e]),$.lookAt(bp),$.updateMatrixWorld(),ae.makeTranslation(-Pl.x,-Pl.y,-Pl.z),j_.multiplyMatrices($.projectionMatrix,$.matrixWorldInverse),B._frustum.setFromProjectionMatrix(j_,$.coordinateSystem,$.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)i.setRenderTarget(B.map,_e),i.clear();else{_e===0&&(i.setRenderTarget(B.map),i.clear());let $=B.getViewport(_e);o.set(r.x*$.x,r.y*$.y,r.x*$.z,r.y*$.w),I.viewport(o)}n=B.getFrustum(_e),b(p,S,Te,V,W,this.type)}B.isPointLightShadow!==!0&&this.type===Fo&&v(B,S),B.needsUpdate=!1}_=this.type,g.needsUpdate=!1,i.setRenderTarget(A,E,C)};function v(x,p){let S=e.update(y);d.defines.VSM_SAMPLES!==x.blurSamples&&(d.defines.VSM_SAMPLES=x.blurSamples,f.defines.VSM_SAMPLES=x.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),x.mapPass===null?x.mapPass=new zn(s.x,s.y,{format:nr,type:Oi}):(x.mapPass.width!==x.map.width||x.mapPass.height!==x.map.height)&&x.mapPass.setSize(x.map.width,x.map.height),d.uniforms.shadow_pass.value=x.map.depthTexture,d.uniforms.resolution.value.set(x.map.width,x.map.height),d.uniforms.radius.value=x.radius,i.setRenderTarget(x.mapPass),i.clear(),i.renderBufferDirect(p,null,S,d,y,null),f.uniforms.shadow_pass.value=x.mapPass.texture,f.uniforms.resolution.value.set(x.map.width,x.map.height),f.uniforms.radius.value=x.radius,i.setRenderTarget(x.map),i.clear(),i.renderBufferDirect(p,null,S,f,y,null)}function M(x,p,S,A){let E=null,C=S.isPointLight===!0?x.customDistanceMaterial:x.customDepthMaterial;if(C!==void 0)E=C;else if(E=S.isPointLight===!0?l:a,i.localClippingEnabled&&p.clipShadows===!0&&Array.isArray(p.clippingPlanes)&&p.clippingPlanes.length!==0||p.displacementMap&&p.displacementScale!==0||p.alphaMap&&p.alphaTest>0||p.map&&p.alphaTest>0||p.alphaToCoverage===!0){let I=E.uuid,D=p.uuid,L=c[I];L===void 0&&(L={},c[I]=L);let U=L[D];U===void 0&&(U=E.clone(),L[D]=U,p.addEventListener("dispose",w)),E=U}if(E.visible=p.visible,E.wireframe=p.wireframe,A===Fo?E.side=p.shadowSide!==null?p.shadowSide:p.side:E.side=p.shadowSide!==null?p.shadowSide:h[p.side],E.alphaMap=p.alphaMap,E.alphaTest=p.alphaToCoverage===!0?.5:p.alphaTest,E.map=p.map,E.clipShadows=p.clipShadows,E.clippingPlanes=p.clippingPlanes,E.clipIntersection=p.clipIntersection,E.displacementMap=p.displacementMap,E.displacementScale=p.displacementScale,E.displacementBias=p.displacementBias,E.wireframeLinewidth=p.wireframeLinewidth,E.linewidth=p.linewidth,S.isPointLight===!0&&E.isMeshDistanceMaterial===!0){let I=i.properties.get(E);I.light=S}return E}function b(x,p,S,A,E,C){if(x.visible===!1)return;if(x.layers.test(E)&&(x.isMesh||x.isLine||x.isPoints)&&(x.castShadow||x.receiveShadow&&C===Fo)&&(!x.frustumCulled||x.intersectsFrustum(n))){x.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,x.matrixWorld);let L=e.update(x),U=x.material;if(Array.isArray(U)){let V=L.groups;for(let B=0,ne=V.length;B<ne;B++){let z=V[B],q=U[z.materialIndex];if(q&&q.visible){let W=M(x,q,A,C);x.onBeforeShadow(i,x,p,S,L,W,z),i.renderBufferDirect(S,null,L,W,x,z),x.onAfterShadow(i,x,p,S,L,W,z)}}}else if(U.visible){let V=M(x,U,A,C);x.onBeforeShadow(i,x,p,S,L,V,null),i.renderBufferDirect(S,null,L,V,x,null),x.onAfterShadow(i,x,p,S,L,V,null)}}let D=x.children;for(let L=0,U=D.length;L<U;L++)b(D[L],p,S,A,E,C)}function w(x){x.target.removeEventListener("dispose",w);for(let S in c){let A=c[S],E=x.target.uuid;E in A&&(A[E].dispose(),delete A[E])}}}function u1(i,e){function t(){let N=!1,ee=new ct,J=null,ge=new ct(0,0,0,0);return{setMask:function(he){J!==he&&!N&&(i.colorMask(he,he,he,he),J=he)},setLocked:function(he){N=he},setClear:function(he,pe,ke,nt,le){le===!0&&(he*=nt,pe*=nt,ke*=nt),ee.set(he,pe,ke,nt),ge.equals(ee)===!1&&(i.clearColor(he,pe,ke,nt),ge.copy(ee))},reset:function(){N=!1,J=null,ge.set(-1,0,0,0)}}}function n(){let N=!1,ee=!1,J=null,ge=null,he=null;return{setReversed:function(pe){if(ee!==pe){let ke=e.get("EXT_clip_control");pe?ke.clipControlEXT(ke.LOWER_LEFT_EXT,ke.ZERO_TO_ONE_EXT):ke.clipControlEXT(ke.LOWER_LEFT_EXT,ke.NEGATIVE_ONE_TO_ONE_EXT),ee=pe;let nt=he;he=null,this.setClear(nt)}},getReversed:function(){return ee},setTest:function(pe){pe?re(i.DEPTH_TEST):de(i.DEPTH_TEST)},setMask:function(pe){J!==pe&&!N&&(i.depthMask(pe),J=pe)},setFunc:function(pe){if(ee&&(pe=R_[pe]),ge!==pe){switch(pe){case hu:i.depthFunc(i.NEVER);break;case du:i.depthFunc(i.ALWAYS);break;case fu:i.depthFunc(i.LESS);break;case Mo:i.depthFunc(i.LEQUAL);break;case pu:i.depthFunc(i.EQUAL);break;case mu:i.depthFunc(i.GEQUAL);break;case gu:i.depthFunc(i.GREATER);break;case _u:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ge=pe}},setLocked:function(pe){N=pe},setClear:function(pe){he!==pe&&(he=pe,ee&&(pe=1-pe),i.clearDepth(pe))},reset:function(){N=!1,J=null,ge=null,he=null,ee=!1}}}function s(){let N=!1,ee=null,J=null,ge=null,he=null,pe=null,ke=null,nt=null,le=null;return{setTest:function(ze){N||(ze?re(i.STENCIL_TEST):de(i.STENCIL_TEST))},setMask:function(ze){ee!==ze&&!N&&(i.stencilMask(ze),ee=ze)},setFunc:function(ze,Qe,we){(J!==ze||ge!==Qe||he!==we)&&(i.stencilFunc(ze,Qe,we),J=ze,ge=Qe,he=we)},setOp:function(ze,Qe,we){(pe!==ze||ke!==Qe||nt!==we)&&(i.stencilOp(ze,Qe,we),pe=ze,ke=Qe,nt=we)},setLocked:function(ze){N=ze},setClear:function(ze){le!==ze&&(i.clearStencil(ze),le=ze)},reset:function(){N=!1,ee=null,J=null,ge=null,he=null,pe=null,ke=null,nt=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],y=null,g=!1,_=null,v=null,M=null,b=null,w=null,x=null,p=null,S=new De(0,0,0),A=0,E=!1,C=null,I=null,D=null,L=null,U=null,V=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,ne=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec(z)[1]),B=ne>=1):z.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),B=ne>=2);let q=null,W={},_e=i.getParameter(i.SCISSOR_BOX),Te=i.getParameter(i.VIEWPORT),$=new ct().fromArray(_e),ae=new ct().fromArray(Te);function se(N,ee,J,ge){let he=new Uint8Array(4),pe=i.createTexture();i.bindTexture(N,pe),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let ke=0;ke<J;ke++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(ee,0,i.RGBA,1,1,ge,0,i.RGBA,i.UNSIGNED_BYTE,he):i.texImage2D(ee+ke,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,he);return pe}let ce={};ce[i.TEXTURE_2D]=se(i.TEXTURE_2D,i.TEXTURE_2D,1),ce[i.TEXTURE_CUBE_MAP]=se(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ce[i.TEXTURE_2D_ARRAY]=se(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ce[i.TEXTURE_3D]=se(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),re(i.DEPTH_TEST),o.setFunc(Mo),rt(!1),je(Vf),re(i.CULL_FACE),pt(es);function re(N){u[N]!==!0&&(i.enable(N),u[N]=!0)}function de(N){u[N]!==!1&&(i.disable(N),u[N]=!1)}function Ye(N,ee){return d[N]!==ee?(i.bindFramebuffer(N,ee),d[N]=ee,N===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=ee),N===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=ee),!0):!1}function Ae(N,ee){let J=m,ge=!1;if(N){J=f.get(ee),J===void 0&&(J=[],f.set(ee,J));let he=N.textures;if(J.length!==he.length||J[0]!==i.COLOR_ATTACHMENT0){for(let pe=0,ke=he.length;pe<ke;pe++)J[pe]=i.COLOR_ATTACHMENT0+pe;J.length=he.length,ge=!0}}else J[0]!==i.BACK&&(J[0]=i.BACK,ge=!0);ge&&i.drawBuffers(J)}function Be(N){return y!==N?(i.useProgram(N),y=N,!0):!1}let Le={[kr]:i.FUNC_ADD,[Z0]:i.FUNC_SUBTRACT,[J0]:i.FUNC_REVERSE_SUBTRACT};Le[j0]=i.MIN,Le[Q0]=i.MAX;let Me={[e_]:i.ZERO,[t_]:i.ONE,[n_]:i.SRC_COLOR,[Xf]:i.SRC_ALPHA,[l_]:i.SRC_ALPHA_SATURATE,[o_]:i.DST_COLOR,[s_]:i.DST_ALPHA,[i_]:i.ONE_MINUS_SRC_COLOR,[qf]:i.ONE_MINUS_SRC_ALPHA,[a_]:i.ONE_MINUS_DST_COLOR,[r_]:i.ONE_MINUS_DST_ALPHA,[c_]:i.CONSTANT_COLOR,[u_]:i.ONE_MINUS_CONSTANT_COLOR,[h_]:i.CONSTANT_ALPHA,[d_]:i.ONE_MINUS_CONSTANT_ALPHA};function pt(N,ee,J,ge,he,pe,ke,nt,le,ze){if(N===es){g===!0&&(de(i.BLEND),g=!1);return}if(g===!1&&(re(i.BLEND),g=!0),N!==K0){if(N!==_||ze!==E){if((v!==kr||w!==kr)&&(i.blendEquation(i.FUNC_ADD),v=kr,w=kr),ze)switch(N){case ko:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Hf:i.blendFunc(i.ONE,i.ONE);break;case Gf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Wf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Xe("WebGLState: Invalid blending: ",N);break}else switch(N){case ko:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Hf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Gf:Xe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wf:Xe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Xe("WebGLState: Invalid blending: ",N);break}M=null,b=null,x=null,p=null,S.set(0,0,0),A=0,_=N,E=ze}return}he=he||ee,pe=pe||J,ke=ke||ge,(ee!==v||he!==w)&&(i.blendEquationSeparate(Le[ee],Le[he]),v=ee,w=he),(J!==M||ge!==b||pe!==x||ke!==p)&&(i.blendFuncSeparate(Me[J],Me[ge],Me[pe],Me[ke]),M=J,b=ge,x=pe,p=ke),(nt.equals(S)===!1||le!==A)&&(i.blendColor(nt.r,nt.g,nt.b,le),S.copy(nt),A=le),_=N,E=!1}function Ge(N,ee){N.side===an?de(i.CULL_FACE):re(i.CULL_FACE);let J=N.side===En;ee&&(J=!J),rt(J),N.blending===ko&&N.transparent===!1?pt(es):pt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let ge=N.stencilWrite;a.setTest(ge),ge&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Ot(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?re(i.SAMPLE_ALPHA_TO_COVERAGE):de(i.SAMPLE_ALPHA_TO_COVERAGE)}function rt(N){C!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),C=N)}function je(N){N!==q0?(re(i.CULL_FACE),N!==I&&(N===Vf?i.cullFace(i.BACK):N===Y0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):de(i.CULL_FACE),I=N}function Sn(N){N!==D&&(B&&i.lineWidth(N),D=N)}function Ot(N,ee,J){N?(re(i.POLYGON_OFFSET_FILL),(L!==ee||U!==J)&&(L=ee,U=J,o.getReversed()&&(ee=-ee,J=-J),i.polygonOffset(ee,J))):de(i.POLYGON_OFFSET_FILL)}function mn(N){N?re(i.SCISSOR_TEST):de(i.SCISSOR_TEST)}function Rt(N){N===void 0&&(N=i.TEXTURE0+V-1),q!==N&&(i.activeTexture(N),q=N)}function Kt(N,ee,J){J===void 0&&(q===null?J=i.TEXTURE0+V-1:J=q);let ge=W[J];ge===void 0&&(ge={type:void 0,texture:void 0},W[J]=ge),(ge.type!==N||ge.texture!==ee)&&(q!==J&&(i.activeTexture(J),q=J),i.bindTexture(N,ee||ce[N]),ge.type=N,ge.texture=ee)}function k(){let N=W[q];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function Ft(){try{i.compressedTexImage2D(...arguments)}catch(N){Xe("WebGLState:",N)}}function mt(){try{i.compressedTexImage3D(...arguments)}catch(N){Xe("WebGLState:",N)}}function Dt(){try{i.texSubImage2D(...arguments)}catch(N){Xe("WebGLState:",N)}}function ye(){try{i.texSubImage3D(...arguments)}catch(N){Xe("WebGLState:",N)}}function Gt(){try{i.compressedTexSubImage2D(...arguments)}catch(N){Xe("WebGLState:",N)}}function Oe(){try{i.compressedTexSubImage3D(...arguments)}catch(N){Xe("WebGLState:",N)}}function We(){try{i.texStorage2D(...arguments)}catch(N){Xe("WebGLState:",N)}}function O(){try{i.texStorage3D(...arguments)}catch(N){Xe("WebGLState:",N)}}function T(){try{i.texImage2D(...arguments)}catch(N){Xe("WebGLState:",N)}}function G(){try{i.texImage3D(...arguments)}catch(N){Xe("WebGLState:",N)}}function oe(N){return h[N]!==void 0?h[N]:i.getParameter(N)}function te(N,ee){h[N]!==ee&&(i.pixelStorei(N,ee),h[N]=ee)}function fe(N){$.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),$.copy(N))}function ve(N){ae.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),ae.copy(N))}function j(N,ee){let J=c.get(ee);J===void 0&&(J=new WeakMap,c.set(ee,J));let ge=J.get(N);ge===void 0&&(ge=i.getUniformBlockIndex(ee,N.name),i.uniformBlockBinding(ee,ge,ge),J.set(N,ge))}function Q(N,ee,J){let he=c.get(ee).get(N);l[he]!==J&&(i.bindBufferBase(i.UNIFORM_BUFFER,he,J),l[he]=J)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},q=null,W={},d={},l={},f=new WeakMap,m=[],y=null,g=!1,_=null,v=null,M=null,b=null,w=null,x=null,p=null,S=new De(0,0,0),A=0,E=!1,C=null,I=null,D=null,L=null,U=null,$.set(0,0,i.canvas.width,i.canvas.height),ae.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:re,disable:de,bindFramebuffer:Ye,drawBuffers:Ae,useProgram:Be,setBlending:pt,setMaterial:Ge,setFlipSided:rt,setCullFace:je,setLineWidth:Sn,setPolygonOffset:Ot,setScissorTest:mn,activeTexture:Rt,bindTexture:Kt,unbindTexture:k,compressedTexImage2D:Ft,compressedTexImage3D:mt,texImage2D:T,texImage3D:G,pixelStorei:te,getParameter:oe,updateUBOMapping:j,uniformBlockBinding:Q,texStorage2D:We,texStorage3D:O,texSubImage2D:Dt,texSubImage3D:ye,compressedTexSubImage2D:Gt,compressedTexSubImage3D:Oe,scissor:fe,viewport:ve,reset:me}}function h1(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Fe,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,y=new FinalizationRegistry(O=>m.delete(O)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(O,T){return g?new OffscreenCanvas(O,T):To("canvas")}function v(O,T,G){let oe=1,te=We(O);if((te.width>G||te.height>G)&&(oe=G/Math.max(te.width,te.height)),oe<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let fe=Math.floor(oe*te.width),ve=Math.floor(oe*te.height);d===void 0&&(d=_(fe,ve));let j=T?_(fe,ve):d;return j.width=fe,j.height=ve,j.getContext("2d").drawImage(O,0,0,fe,ve),Ue("WebGLRenderer: Texture has been resized from ("+te.width+"x"+te.height+") to ("+fe+"x"+ve+")."),j}else return"data"in O&&Ue("WebGLRenderer: Image in DataTexture is too big ("+te.width+"x"+te.height+")."),O;return O}function M(O){return O.generateMipmaps}function b(O){i.generateMipmap(O)}function w(O){return O.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?i.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function x(O,T,G,oe,te,fe=!1){if(O!==null){if(i[O]!==void 0)return i[O];Ue("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let ve;oe&&(ve=e.get("EXT_texture_norm16"),ve||Ue("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=T;if(T===i.RED&&(G===i.FLOAT&&(j=i.R32F),G===i.HALF_FLOAT&&(j=i.R16F),G===i.UNSIGNED_BYTE&&(j=i.R8),G===i.UNSIGNED_SHORT&&ve&&(j=ve.R16_EXT),G===i.SHORT&&ve&&(j=ve.R16_SNORM_EXT)),T===i.RED_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.R8UI),G===i.UNSIGNED_SHORT&&(j=i.R16UI),G===i.UNSIGNED_INT&&(j=i.R32UI),G===i.BYTE&&(j=i.R8I),G===i.SHORT&&(j=i.R16I),G===i.INT&&(j=i.R32I)),T===i.RG&&(G===i.FLOAT&&(j=i.RG32F),G===i.HALF_FLOAT&&(j=i.RG16F),G===i.UNSIGNED_BYTE&&(j=i.RG8),G===i.UNSIGNED_SHORT&&ve&&(j=ve.RG16_EXT),G===i.SHORT&&ve&&(j=ve.RG16_SNORM_EXT)),T===i.RG_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RG8UI),G===i.UNSIGNED_SHORT&&(j=i.RG16UI),G===i.UNSIGNED_INT&&(j=i.RG32UI),G===i.BYTE&&(j=i.RG8I),G===i.SHORT&&(j=i.RG16I),G===i.INT&&(j=i.RG32I)),T===i.RGB_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RGB8UI),G===i.UNSIGNED_SHORT&&(j=i.RGB16UI),G===i.UNSIGNED_INT&&(j=i.RGB32UI),G===i.BYTE&&(j=i.RGB8I),G===i.SHORT&&(j=i.RGB16I),G===i.INT&&(j=i.RGB32I)),T===i.RGBA_INTEGER&&(G===i.UNSIGNED_BYTE&&(j=i.RGBA8UI),G===i.UNSIGNED_SHORT&&(j=i.RGBA16UI),G===i.UNSIGNED_INT&&(j=i.RGBA32UI),G===i.BYTE&&(j=i.RGBA8I),G===i.SHORT&&(j=i.RGBA16I),G===i.INT&&(j=i.RGBA32I)),T===i.RGB&&(G===i.UNSIGNED_SHORT&&ve&&(j=ve.RGB16_EXT),G===i.SHORT&&ve&&(j=ve.RGB16_SNORM_EXT),G===i.UNSIGNED_INT_5_9_9_9_REV&&(j=i.RGB9_E5),G===i.UNSIGNED_INT_10F_11F_11F_REV&&(j=i.R11F_G11F_B10F)),T===i.RGBA){let Q=fe?qa:it.getTransfer(te);G===i.FLOAT&&(j=i.RGBA32F),G===i.HALF_FLOAT&&(j=i.RGBA16F),G===i.UNSIGNED_BYTE&&(j=Q===Ct?i.SRGB8_ALPHA8:i.RGBA8),G===i.UNSIGNED_SHORT&&ve&&(j=ve.RGBA16_EXT),G===i.SHORT&&ve&&(j=ve.RGBA16_SNORM_EXT),G===i.UNSIGNED_SHORT_4_4_4_4&&(j=i.RGBA4),G===i.UNSIGNED_SHORT_5_5_5_1&&(j=i.RGB5_A1)}return(j===i.R16F||j===i.R32F||j===i.RG16F||j===i.RG32F||j===i.RGBA16F||j===i.RGBA32F)&&e.get("EXT_color_buffer_float"),j}function p(O,T){let G;return O?T===null||T===vi||T===Vr?G=i.DEPTH24_STENCIL8:T===Yn?G=i.DEPTH32F_STENCIL8:T===Vo&&(G=i.DEPTH24_STENCIL8,Ue("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===vi||T===Vr?G=i.DEPTH_COMPONENT24:T===Yn?G=i.DEPTH_COMPONENT32F:T===Vo&&(G=i.DEPTH_COMPONENT16),G}function S(O,T){return M(O)===!0||O.isFramebufferTexture&&O.minFilter!==nn&&O.minFilter!==hn?Math.log2(Math.max(T.width,T.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?T.mipmaps.length:1}function A(O){let T=new WeakRef(O);n.get(O).__ref=T,m.add(T),y.register(O,T,T)}function E(O){let T=n.get(O).__ref;T!==void 0&&(m.delete(T),y.unregister(T))}function C(O){D(O.target)}function I(O){L(O.target)}function D(O){O.removeEventListener("dispose",C),E(O),V(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function L(O){O.removeEventListener("dispose",I),E(O),ne(O)}function U(){for(let O of m){let T=O.deref();T!==void 0&&(T.isRenderTarget===!0?L(T):D(T))}m.clear(),h.clear()}function V(O){let T=n.get(O);if(T.__webglInit===void 0)return;let G=O.source,oe=f.get(G);if(oe){let te=oe[T.__cacheKey];te.usedTimes--,te.usedTimes===0&&B(O),Object.keys(oe).length===0&&f.delete(G)}n.remove(O)}function B(O){let T=n.get(O);i.deleteTexture(T.__webglTexture);let G=O.source,oe=f.get(G);delete oe[T.__cacheKey],o.memory.textures--}function ne(O){let T=n.get(O);T.__depthDisposeCallback&&T.__depthDisposeCallback();let G=O.depthTexture;if(G&&G.renderTarget===O&&D(G),O.isWebGLCubeRenderTarget)for(let te=0;te<6;te++){if(Array.isArray(T.__webglFramebuffer[te]))for(let fe=0;fe<T.__webglFramebuffer[te].length;fe++)i.deleteFramebuffer(T.__webglFramebuffer[te][fe]);else i.deleteFramebuffer(T.__webglFramebuffer[te]);T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer[te])}else{if(Array.isArray(T.__webglFramebuffer))for(let te=0;te<T.__webglFramebuffer.length;te++)i.deleteFramebuffer(T.__webglFramebuffer[te]);else i.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&i.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&i.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let te=0;te<T.__webglColorRenderbuffer.length;te++)T.__webglColorRenderbuffer[te]&&i.deleteRenderbuffer(T.__webglColorRenderbuffer[te]);T.__webglDepthRenderbuffer&&i.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let oe=O.textures;for(let te=0,fe=oe.length;te<fe;te++){let ve=n.get(oe[te]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(oe[te])}n.remove(O)}let z=0;function q(){z=0}function W(){return z}function _e(O){z=O}function Te(){let O=z;return O>=s.maxTextures&&Ue("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),z+=1,O}function $(O){let T=[];return T.push(O.wrapS),T.push(O.wrapT),T.push(O.wrapR||0),T.push(O.magFilter),T.push(O.minFilter),T.push(O.anisotropy),T.push(O.internalFormat),T.push(O.format),T.push(O.type),T.push(O.generateMipmaps),T.push(O.mipmapsAutoUpdate),T.push(O.premultiplyAlpha),T.push(O.flipY),T.push(O.unpackAlignment),T.push(O.colorSpace),T.join()}function ae(O,T){let G=n.get(O);if(O.isVideoTexture&&Gt(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&G.__version!==O.version){let oe=O.image;if(oe===null)Ue("WebGLRenderer: Texture marked for update but no image data found.");else if(oe.complete===!1)Ue("WebGLRenderer: Texture marked for update but image is incomplete");else{Ge(G,O,T);return}}else O.isExternalTexture&&(G.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,G.__webglTexture,i.TEXTURE0+T)}function se(O,T){let G=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&G.__version!==O.version){Ge(G,O,T);return}else O.isExternalTexture&&(G.__webglTexture=O.sourceTexture?O.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,G.__webglTexture,i.TEXTURE0+T)}function ce(O,T){let G=n.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&G.__version!==O.version){Ge(G,O,T);return}t.bindTexture(i.TEXTURE_3D,G.__webglTexture,i.TEXTURE0+T)}function re(O,T){let G=n.get(O);if(O.version>0&&G.__version!==O.version){rt(G,O,T);return}t.bindTexture(i.TEXTURE_CUBE_MAP,G.__webglTexture,i.TEXTURE0+T)}let de={[Zs]:i.REPEAT,[gi]:i.CLAMP_TO_EDGE,[wo]:i.MIRRORED_REPEAT},Ye={[nn]:i.NEAREST,[Fu]:i.NEAREST_MIPMAP_NEAREST,[zr]:i.NEAREST_MIPMAP_LINEAR,[hn]:i.LINEAR,[zo]:i.LINEAR_MIPMAP_NEAREST,[yi]:i.LINEAR_MIPMAP_LINEAR},Ae={[v_]:i.NEVER,[cp]:i.ALWAYS,[b_]:i.LESS,[ap]:i.LEQUAL,[S_]:i.EQUAL,[lp]:i.GEQUAL,[M_]:i.GREATER,[w_]:i.NOTEQUAL};function Be(O,T){if(T.type===Yn&&e.has("OES_texture_float_linear")===!1&&(T.magFilter===hn||T.magFilter===zo||T.magFilter===zr||T.magFilter===yi||T.minFilter===hn||T.minFilter===zo||T.minFilter===zr||T.minFilter===yi)&&Ue("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(O,i.TEXTURE_WRAP_S,de[T.wrapS]),i.texParameteri(O,i.TEXTURE_WRAP_T,de[T.wrapT]),(O===i.TEXTURE_3D||O===i.TEXTURE_2D_ARRAY)&&i.texParameteri(O,i.TEXTURE_WRAP_R,de[T.wrapR]),i.texParameteri(O,i.TEXTURE_MAG_FILTER,Ye[T.magFilter]),i.texParameteri(O,i.TEXTURE_MIN_FILTER,Ye[T.minFilter]),T.compareFunction&&(i.texParameteri(O,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(O,i.TEXTURE_COMPARE_FUNC,Ae[T.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===nn||T.minFilter!==zr&&T.minFilter!==yi||T.type===Yn&&e.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||n.get(T).__currentAnisotropy){let G=e.get("EXT_texture_filter_anisotropic");i.texParameterf(O,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),n.get(T).__currentAnisotropy=T.anisotropy}}}function Le(O,T){let G=!1;O.__webglInit===void 0&&(O.__webglInit=!0,T.addEventListener("dispose",C),A(T));let oe=T.source,te=f.get(oe);te===void 0&&(te={},f.set(oe,te));let fe=$(T);if(fe!==O.__cacheKey){te[fe]===void 0&&(te[fe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,G=!0),te[fe].usedTimes++;let ve=te[O.__cacheKey];ve!==void 0&&(te[O.__cacheKey].usedTimes--,ve.usedTimes===0&&B(T)),O.__cacheKey=fe,O.__webglTexture=te[fe].texture}return G}function Me(O,T,G){return Math.floor(Math.floor(O/G)/T)}function pt(O,T,G,oe){let fe=O.updateRanges;if(fe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,T.width,T.height,G,oe,T.data);else{fe.sort((N,ee)=>N.start-ee.start);let ve=0;for(let N=1;N<fe.length;N++){let ee=fe[ve],J=fe[N],ge=ee.start+ee.count,he=Me(J.start,T.width,4),pe=Me(ee.start,T.width,4);J.start<=ge+1&&he===pe&&Me(J.start+J.count-1,T.width,4)===he?ee.count=Math.max(ee.count,J.start+J.count-ee.start):(++ve,fe[ve]=J)}fe.length=ve+1;let j=t.getParameter(i.UNPACK_ROW_LENGTH),Q=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,T.width);for(let N=0,ee=fe.length;N<ee;N++){let J=fe[N],ge=Math.floor(J.start/4),he=Math.ceil(J.count/4),pe=ge%T.width,ke=Math.floor(ge/T.width),nt=he,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,pe),t.pixelStorei(i.UNPACK_SKIP_ROWS,ke),t.texSubImage2D(i.TEXTURE_2D,0,pe,ke,nt,le,G,oe,T.data)}O.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,j),t.pixelStorei(i.UNPACK_SKIP_PIXELS,Q),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function Ge(O,T,G){let oe=i.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(oe=i.TEXTURE_2D_ARRAY),T.isData3DTexture&&(oe=i.TEXTURE_3D);let te=Le(O,T),fe=T.source;t.bindTexture(oe,O.__webglTexture,i.TEXTURE0+G);let ve=n.get(fe);if(fe.version!==ve.__version||te===!0){if(t.activeTexture(i.TEXTURE0+G),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let le=it.getPrimaries(it.workingColorSpace),ze=T.colorSpace===ks?null:it.getPrimaries(T.colorSpace),Qe=T.colorSpace===ks||le===ze?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qe)}t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment);let Q=v(T.image,!1,s.maxTextureSize);Q=Oe(T,Q);let me=r.convert(T.format,T.colorSpace),N=r.convert(T.type),ee=x(T.internalFormat,me,N,T.normalized,T.colorSpace,T.isVideoTexture);Be(oe,T);let J,ge=T.mipmaps,he=T.isVideoTexture!==!0,pe=ve.__version===void 0||te===!0,ke=fe.dataReady,nt=S(T,Q);if(T.isDepthTexture)ee=p(T.format===Fs,T.type),pe&&(he?t.texStorage2D(i.TEXTURE_2D,1,ee,Q.width,Q.height):t.texImage2D(i.TEXTURE_2D,0,ee,Q.width,Q.height,0,me,N,null));else if(T.isDataTexture)if(ge.length>0){he&&pe&&t.texStorage2D(i.TEXTURE_2D,nt,ee,ge[0].width,ge[0].height);for(let le=0,ze=ge.length;le<ze;le++)J=ge[le],he?ke&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,J.width,J.height,me,N,J.data):t.texImage2D(i.TEXTURE_2D,le,ee,J.width,J.height,0,me,N,J.data);T.generateMipmaps=!1}else he?(pe&&t.texStorage2D(i.TEXTURE_2D,nt,ee,Q.width,Q.height),ke&&pt(T,Q,me,N)):t.texImage2D(i.TEXTURE_2D,0,ee,Q.width,Q.height,0,me,N,Q.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){he&&pe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,nt,ee,ge[0].width,ge[0].height,Q.depth);for(let le=0,ze=ge.length;le<ze;le++)if(J=ge[le],T.format!==ti)if(me!==null)if(he){if(ke)if(T.layerUpdates.size>0){let Qe=yp(J.width,J.height,T.format,T.type);for(let we of T.layerUpdates){let Nt=J.data.subarray(we*Qe/J.data.BYTES_PER_ELEMENT,(we+1)*Qe/J.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,we,J.width,J.height,1,me,Nt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,J.width,J.height,Q.depth,me,J.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,ee,J.width,J.height,Q.depth,0,J.data,0,0);else Ue("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else he?ke&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,J.width,J.height,Q.depth,me,N,J.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,ee,J.width,J.height,Q.depth,0,me,N,J.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{he&&pe&&t.texStorage2D(i.TEXTURE_2D,nt,ee,ge[0].width,ge[0].height);for(let le=0,ze=ge.length;le<ze;le++)J=ge[le],T.format!==ti?me!==null?he?ke&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,J.width,J.height,me,J.data):t.compressedTexImage2D(i.TEXTURE_2D,le,ee,J.width,J.height,0,J.data):Ue("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):he?ke&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,J.width,J.height,me,N,J.data):t.texImage2D(i.TEXTURE_2D,le,ee,J.width,J.height,0,me,N,J.data)}else if(T.isDataArrayTexture)if(he){if(pe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,nt,ee,Q.width,Q.height,Q.depth),ke)if(T.layerUpdates.size>0){let le=yp(Q.width,Q.height,T.format,T.type);for(let ze of T.layerUpdates){let Qe=Q.data.subarray(ze*le/Q.data.BYTES_PER_ELEMENT,(ze+1)*le/Q.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,ze,Q.width,Q.height,1,me,N,Qe)}T.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Q.width,Q.height,Q.depth,me,N,Q.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ee,Q.width,Q.height,Q.depth,0,me,N,Q.data);else if(T.isData3DTexture)he?(pe&&t.texStorage3D(i.TEXTURE_3D,nt,ee,Q.width,Q.height,Q.depth),ke&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Q.width,Q.height,Q.depth,me,N,Q.data)):t.texImage3D(i.TEXTURE_3D,0,ee,Q.width,Q.height,Q.depth,0,me,N,Q.data);else if(T.isFramebufferTexture){if(pe)if(he)t.texStorage2D(i.TEXTURE_2D,nt,ee,Q.width,Q.height);else{let le=Q.width,ze=Q.height;for(let Qe=0;Qe<nt;Qe++)t.texImage2D(i.TEXTURE_2D,Qe,ee,le,ze,0,me,N,null),le>>=1,ze>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),Q.parentNode!==le){le.appendChild(Q),h.add(T),le.onpaint=ze=>{let Qe=ze.changedElements;for(let we of h)Qe.includes(we.image)&&(we.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Q);else{let Qe=i.RGBA,we=i.RGBA,Nt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Qe,we,Nt,Q)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ge.length>0){if(he&&pe){let le=We(ge[0]);t.texStorage2D(i.TEXTURE_2D,nt,ee,le.width,le.height)}for(let le=0,ze=ge.length;le<ze;le++)J=ge[le],he?ke&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,me,N,J):t.texImage2D(i.TEXTURE_2D,le,ee,me,N,J);T.generateMipmaps=!1}else if(he){if(pe){let le=We(Q);t.texStorage2D(i.TEXTURE_2D,nt,ee,le.width,le.height)}ke&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,N,Q)}else t.texImage2D(i.TEXTURE_2D,0,ee,me,N,Q);M(T)&&T.mipmapsAutoUpdate===!0&&b(oe),ve.__version=fe.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function rt(O,T,G){if(T.image.length!==6)return;let oe=Le(O,T),te=T.source;t.bindTexture(i.TEXTURE_CUBE_MAP,O.__webglTexture,i.TEXTURE0+G);let fe=n.get(te);if(te.version!==fe.__version||oe===!0){t.activeTexture(i.TEXTURE0+G);let ve=it.getPrimaries(it.workingColorSpace),j=T.colorSpace===ks?null:it.getPrimaries(T.colorSpace),Q=T.colorSpace===ks||ve===j?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,T.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,T.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Q);let me=T.isCompressedTexture||T.image[0].isCompressedTexture,N=T.image[0]&&T.image[0].isDataTexture,ee=[];for(let we=0;we<6;we++)!me&&!N?ee[we]=v(T.image[we],!0,s.maxCubemapSize):ee[we]=N?T.image[we].image:T.image[we],ee[we]=Oe(T,ee[we]);let J=ee[0],ge=r.convert(T.format,T.colorSpace),he=r.convert(T.type),pe=x(T.internalFormat,ge,he,T.normalized,T.colorSpace),ke=T.isVideoTexture!==!0,nt=fe.__version===void 0||oe===!0,le=te.dataReady,ze=S(T,J);Be(i.TEXTURE_CUBE_MAP,T);let Qe;if(T.isDepthTexture){if(pe=p(T.format===Fs,T.type),nt)if(ke)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,pe,J.width,J.height);else for(let we=0;we<6;we++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,pe,J.width,J.height,0,ge,he,null)}else if(me){ke&&nt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,pe,J.width,J.height);for(let we=0;we<6;we++){Qe=ee[we].mipmaps;for(let Nt=0;Nt<Qe.length;Nt++){let gn=Qe[Nt];T.format!==ti?ge!==null?ke?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt,0,0,gn.width,gn.height,ge,gn.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt,pe,gn.width,gn.height,0,gn.data):Ue("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):ke?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt,0,0,gn.width,gn.height,ge,he,gn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt,pe,gn.width,gn.height,0,ge,he,gn.data)}}}else{if(Qe=T.mipmaps,ke&&nt){Qe.length>0&&ze++;let we=We(ee[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,ze,pe,we.width,we.height)}for(let we=0;we<6;we++)if(N){ke?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,0,0,ee[we].width,ee[we].height,ge,he,ee[we].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,pe,ee[we].width,ee[we].height,0,ge,he,ee[we].data);for(let Nt=0;Nt<Qe.length;Nt++){let Hs=Qe[Nt].image[we].image;ke?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt+1,0,0,Hs.width,Hs.height,ge,he,Hs.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt+1,pe,Hs.width,Hs.height,0,ge,he,Hs.data)}}else{ke?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,0,0,ge,he,ee[we]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,0,pe,ge,he,ee[we]);for(let Nt=0;Nt<Qe.length;Nt++){let gn=Qe[Nt];ke?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt+1,0,0,ge,he,gn.image[we]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+we,Nt+1,pe,ge,he,gn.image[we])}}}M(T)&&T.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),fe.__version=te.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function je(O,T,G,oe,te,fe){let ve=r.convert(G.format,G.colorSpace),j=r.convert(G.type),Q=x(G.internalFormat,ve,j,G.normalized,G.colorSpace),me=n.get(T),N=n.get(G);if(N.__renderTarget=T,!me.__hasExternalTextures){let ee=Math.max(1,T.width>>fe),J=Math.max(1,T.height>>fe);te===i.TEXTURE_3D||te===i.TEXTURE_2D_ARRAY?t.texImage3D(te,fe,Q,ee,J,T.depth,0,ve,j,null):t.texImage2D(te,fe,Q,ee,J,0,ve,j,null)}t.bindFramebuffer(i.FRAMEBUFFER,O),ye(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,oe,te,N.__webglTexture,0,Dt(T)):(te===i.TEXTURE_2D||te>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&te<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,oe,te,N.__webglTexture,fe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Sn(O,T,G){if(i.bindRenderbuffer(i.RENDERBUFFER,O),T.depthBuffer){let oe=T.depthTexture,te=oe&&oe.isDepthTexture?oe.type:null,fe=p(T.stencilBuffer,te),ve=T.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ye(T)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Dt(T),fe,T.width,T.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,Dt(T),fe,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,fe,T.width,T.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,O)}else{let oe=T.textures;for(let te=0;te<oe.length;te++){let fe=oe[te],ve=r.convert(fe.format,fe.colorSpace),j=r.convert(fe.type),Q=x(fe.internalFormat,ve,j,fe.normalized,fe.colorSpace);ye(T)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Dt(T),Q,T.width,T.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,Dt(T),Q,T.width,T.height):i.renderbufferStorage(i.RENDERBUFFER,Q,T.width,T.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ot(O,T,G){let oe=T.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,O),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let te=n.get(T.depthTexture);te.__renderTarget=T;let fe=oe?T.depthTexture.image[0]:T.depthTexture.image;(!te.__webglTexture||fe.width!==T.width||fe.height!==T.height)&&(fe.width=T.width,fe.height=T.height,T.depthTexture.needsUpdate=!0),oe?re(T.depthTexture,0):ae(T.depthTexture,0);let ve=te.__webglTexture,j=Dt(T),Q=oe?i.TEXTURE_CUBE_MAP_POSITIVE_X+G:i.TEXTURE_2D,me=T.depthTexture.format===Fs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(T.depthTexture.format===Ts)ye(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,Q,ve,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,me,Q,ve,0);else if(T.depthTexture.format===Fs)ye(T)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,Q,ve,0,j):i.framebufferTexture2D(i.FRAMEBUFFER,me,Q,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function mn(O){let T=n.get(O),G=O.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==O.depthTexture){let oe=O.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),oe){let te=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,oe.removeEventListener("dispose",te)};oe.addEventListener("dispose",te),T.__depthDisposeCallback=te}T.__boundDepthTexture=oe}if(O.depthTexture&&!T.__autoAllocateDepthBuffer)if(G)for(let oe=0;oe<6;oe++)Ot(T.__webglFramebuffer[oe],O,oe);else O.texture.mipmaps.length>0?Ot(T.__webglFramebuffer[0],O,0):Ot(T.__webglFramebuffer,O,0);else if(G){T.__webglDepthbuffer=[];for(let oe=0;oe<6;oe++)if(t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[oe]),T.__webglDepthbuffer[oe]===void 0)T.__webglDepthbuffer[oe]=i.createRenderbuffer(),Sn(T.__webglDepthbuffer[oe],O,!1);else{let te=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,fe=T.__webglDepthbuffer[oe];i.bindRenderbuffer(i.RENDERBUFFER,fe),i.framebufferRenderbuffer(i.FRAMEBUFFER,te,i.RENDERBUFFER,fe)}}else if(O.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=i.createRenderbuffer(),Sn(T.__webglDepthbuffer,O,!1);else{let te=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,fe=T.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,fe),i.framebufferRenderbuffer(i.FRAMEBUFFER,te,i.RENDERBUFFER,fe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Rt(O,T,G){let oe=n.get(O);T!==void 0&&je(oe.__webglFramebuffer,O,O.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),G!==void 0&&mn(O)}function Kt(O){let T=O.texture,G=n.get(O),oe=n.get(T);O.addEventListener("dispose",I),A(O);let te=O.textures,fe=O.isWebGLCubeRenderTarget===!0,ve=te.length>1;if(ve||(oe.__webglTexture===void 0&&(oe.__webglTexture=i.createTexture()),oe.__version=T.version,o.memory.textures++),fe){G.__webglFramebuffer=[];for(let j=0;j<6;j++)if(T.mipmaps.length>0){G.__webglFramebuffer[j]=[];for(let Q=0;Q<T.mipmaps.length;Q++)G.__webglFramebuffer[j][Q]=i.createFramebuffer()}else G.__webglFramebuffer[j]=i.createFramebuffer()}else{if(T.mipmaps.length>0){G.__webglFramebuffer=[];for(let j=0;j<T.mipmaps.length;j++)G.__webglFramebuffer[j]=i.createFramebuffer()}else G.__webglFramebuffer=i.createFramebuffer();if(ve)for(let j=0,Q=te.length;j<Q;j++){let me=n.get(te[j]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(O.samples>0&&ye(O)===!1){G.__webglMultisampledFramebuffer=i.createFramebuffer(),G.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let j=0;j<te.length;j++){let Q=te[j];G.__webglColorRenderbuffer[j]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,G.__webglColorRenderbuffer[j]);let me=r.convert(Q.format,Q.colorSpace),N=r.convert(Q.type),ee=x(Q.internalFormat,me,N,Q.normalized,Q.colorSpace,O.isXRRenderTarget===!0),J=Dt(O);i.renderbufferStorageMultisample(i.RENDERBUFFER,J,ee,O.width,O.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+j,i.RENDERBUFFER,G.__webglColorRenderbuffer[j])}i.bindRenderbuffer(i.RENDERBUFFER,null),O.depthBuffer&&(G.__webglDepthRenderbuffer=i.createRenderbuffer(),Sn(G.__webglDepthRenderbuffer,O,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(fe){t.bindTexture(i.TEXTURE_CUBE_MAP,oe.__webglTexture),Be(i.TEXTURE_CUBE_MAP,T);for(let j=0;j<6;j++)if(T.mipmaps.length>0)for(let Q=0;Q<T.mipmaps.length;Q++)je(G.__webglFramebuffer[j][Q],O,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,Q);else je(G.__webglFramebuffer[j],O,T,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);M(T)?b(i.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let j=0,Q=te.length;j<Q;j++){let me=te[j],N=n.get(me),ee=i.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(ee=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,N.__webglTexture),Be(ee,me),je(G.__webglFramebuffer,O,me,i.COLOR_ATTACHMENT0+j,ee,0),M(me)&&b(ee)}t.unbindTexture()}else{let j=i.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(j=O.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(j,oe.__webglTexture),Be(j,T),T.mipmaps.length>0)for(let Q=0;Q<T.mipmaps.length;Q++)je(G.__webglFramebuffer[Q],O,T,i.COLOR_ATTACHMENT0,j,Q);else je(G.__webglFramebuffer,O,T,i.COLOR_ATTACHMENT0,j,0);M(T)?b(j):T.mipmaps.length>0&&i.texParameteri(j,i.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),t.unbindTexture()}O.depthBuffer&&mn(O)}function k(O){let T=O.textures;for(let G=0,oe=T.length;G<oe;G++){let te=T[G];if(M(te)&&te.mipmapsAutoUpdate===!0){let fe=w(O),ve=n.get(te).__webglTexture;t.bindTexture(fe,ve),b(fe),t.unbindTexture()}}}let Ft=[];function mt(O){if(O.samples>0){if(ye(O)===!1){let T=O.textures,G=O.width,oe=O.height,te=i.COLOR_BUFFER_BIT,fe=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(O),j=T.length>1;if(j)for(let me=0;me<T.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<T.length;me++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(te|=i.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(te|=i.STENCIL_BUFFER_BIT)),j){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let N=n.get(T[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,N,0)}i.blitFramebuffer(0,0,G,oe,0,0,G,oe,te,i.NEAREST),l===!0&&(Ft.length=0,Ft.push(i.COLOR_ATTACHMENT0+me),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Ft.push(fe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ft))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),j)for(let me=0;me<T.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let N=n.get(T[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,N,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let T=O.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[T])}}}function Dt(O){return Math.min(s.maxSamples,O.samples)}function ye(O){let T=n.get(O);return O.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Gt(O){let T=o.render.frame;u.get(O)!==T&&(u.set(O,T),O.update())}function Oe(O,T){let G=O.colorSpace,oe=O.format,te=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||G!==$n&&G!==ks&&(it.getTransfer(G)===Ct?(oe!==ti||te!==si)&&Ue("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Xe("WebGLTextures: Unsupported texture color space:",G)),T}function We(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=Te,this.resetTextureUnits=q,this.getTextureUnits=W,this.setTextureUnits=_e,this.setTexture2D=ae,this.setTexture2DArray=se,this.setTexture3D=ce,this.setTextureCube=re,this.rebindTextures=Rt,this.setupRenderTarget=Kt,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=mt,this.setupDepthRenderbuffer=mn,this.setupFrameBufferTexture=je,this.useMultisampledRTT=ye,this.dispose=U}function d1(i,e){function t(n,s=ks){let r,o=it.getTransfer(s);if(n===si)return i.UNSIGNED_BYTE;if(n===Bu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===zu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===np)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===ip)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ep)return i.BYTE;if(n===tp)return i.SHORT;if(n===Vo)return i.UNSIGNED_SHORT;if(n===ku)return i.INT;if(n===vi)return i.UNSIGNED_INT;if(n===Yn)return i.FLOAT;if(n===Oi)return i.HALF_FLOAT;if(n===sp)return i.ALPHA;if(n===rp)return i.RGB;if(n===ti)return i.RGBA;if(n===Ts)return i.DEPTH_COMPONENT;if(n===Fs)return i.DEPTH_STENCIL;if(n===Vu)return i.RED;if(n===vl)return i.RED_INTEGER;if(n===nr)return i.RG;if(n===Hu)return i.RG_INTEGER;if(n===Gu)return i.RGBA_INTEGER;if(n===bl||n===Sl||n===Ml||n===wl)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===bl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Sl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Ml)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===wl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===bl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Sl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Ml)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===wl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Wu||n===Xu||n===qu||n===Yu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Wu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Xu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===qu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Yu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===$u||n===Ku||n===Zu||n===Ju||n===ju||n===El||n===Qu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===$u||n===Ku)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Zu)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Ju)return r.COMPRESSED_R11_EAC;if(n===ju)return r.COMPRESSED_SIGNED_R11_EAC;if(n===El)return r.COMPRESSED_RG11_EAC;if(n===Qu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===eh||n===th||n===nh||n===ih||n===sh||n===rh||n===oh||n===ah||n===lh||n===ch||n===uh||n===hh||n===dh||n===fh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===eh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===th)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===nh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ih)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===sh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===rh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===oh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===ah)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===lh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ch)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===uh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===hh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===dh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===fh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===ph||n===mh||n===gh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===ph)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===mh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===gh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===_h||n===xh||n===Tl||n===yh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===_h)return r.COMPRESSED_RED_RGTC1_EXT;if(n===xh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Tl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===yh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Vr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var f1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,p1=`
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

}`,Rp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new rl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new dn({vertexShader:f1,fragmentShader:p1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Pt(new Ji(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cp=class extends qi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,y=typeof XRWebGLBinding<"u",g=new Rp,_={},v=t.getContextAttributes(),M=null,b=null,w=[],x=[],p=new Fe,S=null,A=null,E=new cn;E.viewport=new ct;let C=new cn;C.viewport=new ct;let I=[E,C],D=new Ou,L=null,U=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function($){let ae=w[$];return ae===void 0&&(ae=new Po,w[$]=ae),ae.getTargetRaySpace()},this.getControllerGrip=function($){let ae=w[$];return ae===void 0&&(ae=new Po,w[$]=ae),ae.getGripSpace()},this.getHand=function($){let ae=w[$];return ae===void 0&&(ae=new Po,w[$]=ae),ae.getHandSpace()};function V($){let ae=x.indexOf($.inputSource);if(ae===-1)return;let se=w[ae];se!==void 0&&(se.update($.inputSource,$.frame,c||o),se.dispatchEvent({type:$.type,data:$.inputSource}))}function B(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",ne);for(let $=0;$<w.length;$++){let ae=x[$];ae!==null&&(x[$]=null,w[$].disconnect(ae))}L=null,U=null,g.reset();for(let $ in _)delete _[$];if(e.setRenderTarget(M),f=null,d=null,h=null,s=null,b=null,Te.stop(),n.isPresenting=!1,e.setPixelRatio(S),e.setSize(p.width,p.height,!1),A!==null){let $=A.camera;$.fov=A.fov,$.zoom=A.zoom,$.updateProjectionMatrix(),A=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function($){r=$,n.isPresenting===!0&&Ue("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function($){a=$,n.isPresenting===!0&&Ue("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function($){c=$},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function($){if(s=$,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",B),s.addEventListener("inputsourceschange",ne),v.xrCompatible!==!0&&await t.makeXRCompatible(),S=e.getPixelRatio(),e.getSize(p),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let se=null,ce=null,re=null;v.depth&&(re=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,se=v.stencil?Fs:Ts,ce=v.stencil?Vr:vi);let de={colorFormat:t.RGBA8,depthFormat:re,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(de),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new zn(d.textureWidth,d.textureHeight,{format:ti,type:si,depthTexture:new Cs(d.textureWidth,d.textureHeight,ce,void 0,void 0,void 0,void 0,void 0,void 0,se),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let se={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,se),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new zn(f.framebufferWidth,f.framebufferHeight,{format:ti,type:si,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Te.setContext(s),Te.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ne($){for(let ae=0;ae<$.removed.length;ae++){let se=$.removed[ae],ce=x.indexOf(se);ce>=0&&(x[ce]=null,w[ce].disconnect(se))}for(let ae=0;ae<$.added.length;ae++){let se=$.added[ae],ce=x.indexOf(se);if(ce===-1){for(let de=0;de<w.length;de++)if(de>=x.length){x.push(se),ce=de;break}else if(x[de]===null){x[de]=se,ce=de;break}if(ce===-1)break}let re=w[ce];re&&re.connect(se)}}function z($,ae){ae===null?$.matrixWorld.copy($.matrix):$.matrixWorld.multiplyMatrices(ae.matrixWorld,$.matrix),$.matrixWorldInverse.copy($.matrixWorld).invert()}this.updateCamera=function($){if(s===null)return;let ae=$.near,se=$.far;g.texture!==null&&(g.depthNear>0&&(ae=g.depthNear),g.depthFar>0&&(se=g.depthFar)),D.near=C.near=E.near=ae,D.far=C.far=E.far=se,(L!==D.near||U!==D.far)&&(s.updateRenderState({depthNear:D.near,depthFar:D.far}),L=D.near,U=D.far),D.layers.mask=$.layers.mask|6,E.layers.mask=D.layers.mask&-5,C.layers.mask=D.layers.mask&-3;let ce=$.parent,re=D.cameras;z(D,ce);for(let de=0;de<re.length;de++)z(re[de],ce);D.projectionMatrix.copy(E.projectionMatrix),D.projectionMatrixInverse.copy(E.projectionMatrixInverse),A===null&&$.isPerspectiveCamera&&(A={camera:$,fov:$.fov,zoom:$.zoom}),q($,D,ce)};function q($,ae,se){se===null?$.matrix.copy(ae.matrixWorld):($.matrix.copy(se.matrixWorld),$.matrix.invert(),$.matrix.multiply(ae.matrixWorld)),$.matrix.decompose($.position,$.quaternion,$.scale),$.updateMatrixWorld(!0),$.projectionMatrix.copy(ae.projectionMatrix),$.projectionMatrixInverse.copy(ae.projectionMatrixInverse),$.isPerspectiveCamera&&($.fov=Or*2*Math.atan(1/$.projectionMatrix.elements[5]),$.zoom=1)}this.getCamera=function(){return D},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function($){l=$,d!==null&&(d.fixedFoveation=$),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=$)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(D)},this.getCameraTexture=function($){return _[$]};let W=null;function _e($,ae){if(u=ae.getViewerPose(c||o),m=ae,u!==null){let se=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let ce=!1;se.length!==D.cameras.length&&(D.cameras.length=0,ce=!0);for(let Ae=0;Ae<se.length;Ae++){let Be=se[Ae],Le=null;if(f!==null)Le=f.getViewport(Be);else{let pt=h.getViewSubImage(d,Be);Le=pt.viewport,Ae===0&&(e.setRenderTargetTextures(b,pt.colorTexture,pt.depthStencilTexture),e.setRenderTarget(b))}let Me=I[Ae];Me===void 0&&(Me=new cn,Me.layers.enable(Ae),Me.viewport=new ct,I[Ae]=Me),Me.matrix.fromArray(Be.transform.matrix),Me.matrix.decompose(Me.position,Me.quaternion,Me.scale),Me.projectionMatrix.fromArray(Be.projectionMatrix),Me.projectionMatrixInverse.copy(Me.projectionMatrix).invert(),Me.viewport.set(Le.x,Le.y,Le.width,Le.height),Ae===0&&(D.matrix.copy(Me.matrix),D.matrix.decompose(D.position,D.quaternion,D.scale)),ce===!0&&D.cameras.push(Me)}let re=s.enabledFeatures;if(re&&re.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=n.getBinding();let Ae=h.getDepthInformation(se[0]);Ae&&Ae.isValid&&Ae.texture&&g.init(Ae,s.renderState)}if(re&&re.includes("camera-access")&&y){e.state.unbindTexture(),h=n.getBinding();for(let Ae=0;Ae<se.length;Ae++){let Be=se[Ae].camera;if(Be){let Le=_[Be];Le||(Le=new rl,_[Be]=Le);let Me=h.getCameraImage(Be);Le.sourceTexture=Me}}}}for(let se=0;se<w.length;se++){let ce=x[se],re=w[se];ce!==null&&re!==void 0&&re.update(ce,ae,c||o)}W&&W($,ae),ae.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ae}),m=null}let Te=new Q_;Te.setAnimationLoop(_e),this.setAnimationLoop=function($){W=$},this.dispose=function(){}}},m1=new Ce,cx=new Ke;cx.set(-1,0,0,0,1,0,0,0,1);function g1(i,e){function t(g,_){g.matrixAutoUpdate===!0&&g.updateMatrix(),_.value.copy(g.matrix)}function n(g,_){_.color.getRGB(g.fogColor.value,gp(i)),_.isFog?(g.fogNear.value=_.near,g.fogFar.value=_.far):_.isFogExp2&&(g.fogDensity.value=_.density)}function s(g,_,v,M,b){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(g,_):_.isMeshLambertMaterial?(r(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(g,_),h(g,_)):_.isMeshPhongMaterial?(r(g,_),u(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(g,_),d(g,_),_.isMeshPhysicalMaterial&&f(g,_,b)):_.isMeshMatcapMaterial?(r(g,_),m(g,_)):_.isMeshDepthMaterial?r(g,_):_.isMeshDistanceMaterial?(r(g,_),y(g,_)):_.isMeshNormalMaterial?r(g,_):_.isLineBasicMaterial?(o(g,_),_.isLineDashedMaterial&&a(g,_)):_.isPointsMaterial?l(g,_,v,M):_.isSpriteMaterial?c(g,_):_.isShadowMaterial?(g.color.value.copy(_.color),g.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(g,_){g.opacity.value=_.opacity,_.color&&g.diffuse.value.copy(_.color),_.emissive&&g.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.bumpMap&&(g.bumpMap.value=_.bumpMap,t(_.bumpMap,g.bumpMapTransform),g.bumpScale.value=_.bumpScale,_.side===En&&(g.bumpScale.value*=-1)),_.normalMap&&(g.normalMap.value=_.normalMap,t(_.normalMap,g.normalMapTransform),g.normalScale.value.copy(_.normalScale),_.side===En&&g.normalScale.value.negate()),_.displacementMap&&(g.displacementMap.value=_.displacementMap,t(_.displacementMap,g.displacementMapTransform),g.displacementScale.value=_.displacementScale,g.displacementBias.value=_.displacementBias),_.emissiveMap&&(g.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,g.emissiveMapTransform)),_.specularMap&&(g.specularMap.value=_.specularMap,t(_.specularMap,g.specularMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest);let v=e.get(_),M=v.envMap,b=v.envMapRotation;M&&(g.envMap.value=M,g.envMapRotation.value.setFromMatrix4(m1.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(cx),g.reflectivity.value=_.reflectivity,g.ior.value=_.ior,g.refractionRatio.value=_.refractionRatio),_.lightMap&&(g.lightMap.value=_.lightMap,g.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,g.lightMapTransform)),_.aoMap&&(g.aoMap.value=_.aoMap,g.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,g.aoMapTransform))}function o(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform))}function a(g,_){g.dashSize.value=_.dashSize,g.totalSize.value=_.dashSize+_.gapSize,g.scale.value=_.scale}function l(g,_,v,M){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.size.value=_.size*v,g.scale.value=M*.5,_.map&&(g.map.value=_.map,t(_.map,g.uvTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function c(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.rotation.value=_.rotation,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function u(g,_){g.specular.value.copy(_.specular),g.shininess.value=Math.max(_.shininess,1e-4)}function h(g,_){_.gradientMap&&(g.gradientMap.value=_.gradientMap)}function d(g,_){g.metalness.value=_.metalness,_.metalnessMap&&(g.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,g.metalnessMapTransform)),g.roughness.value=_.roughness,_.roughnessMap&&(g.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,g.roughnessMapTransform)),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)}function f(g,_,v){g.ior.value=_.ior,_.diffuseRoughness>0&&(g.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),_.sheen>0&&(g.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),g.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(g.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,g.sheenColorMapTransform)),_.sheenRoughnessMap&&(g.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,g.sheenRoughnessMapTransform))),_.clearcoat>0&&(g.clearcoat.value=_.clearcoat,g.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(g.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,g.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(g.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===En&&g.clearcoatNormalScale.value.negate())),_.dispersion>0&&(g.dispersion.value=_.dispersion),_.retroreflectivity>0&&(g.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(g.iridescence.value=_.iridescence,g.iridescenceIOR.value=_.iridescenceIOR,g.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(g.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,g.iridescenceMapTransform)),_.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),_.transmission>0&&(g.transmission.value=_.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),_.transmissionMap&&(g.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,g.transmissionMapTransform)),g.thickness.value=_.thickness,_.thicknessMap&&(g.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=_.attenuationDistance,g.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(g.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(g.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=_.specularIntensity,g.specularColor.value.copy(_.specularColor),_.specularColorMap&&(g.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,g.specularColorMapTransform)),_.specularIntensityMap&&(g.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,_){_.matcap&&(g.matcap.value=_.matcap)}function y(g,_){let v=e.get(_).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function _1(i,e,t,n){let s={},r={};function o(v,M){let b=M.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,M){let b=s[v.id];b===void 0&&(m(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",g));let w=M.program;n.updateUBOMapping(v,w);let x=e.render.frame;r[v.id]!==x&&(c(v),r[v.id]=x)}function l(v){let M=i.createBuffer(),b=v.__size,w=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,w),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],b=v.uniforms,w=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let x=0,p=b.length;x<p;x++){let S=b[x];if(Array.isArray(S))for(let A=0,E=S.length;A<E;A++)u(S[A],x,A,w);else u(S,x,0,w)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,M,b,w){if(d(v,M,b,w)===!0){let x=v.__offset,p=v.value;if(Array.isArray(p)){let S=0;for(let A=0;A<p.length;A++){let E=p[A],C=y(E,!0);h(E,v.__data,S),S+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else h(p,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,x,v.__data)}}function h(v,M,b){typeof v=="number"||typeof v=="boolean"?M[b]=v:v.isMatrix3?(M[b]=v.elements[0],M[b+1]=v.elements[1],M[b+2]=v.elements[2],M[b+3]=0,M[b+4]=v.elements[3],M[b+5]=v.elements[4],M[b+6]=v.elements[5],M[b+7]=0,M[b+8]=v.elements[6],M[b+9]=v.elements[7],M[b+10]=v.elements[8],M[b+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-b),b):v.toArray(M,b)}function d(v,M,b,w){let x=v.value,p=M+"_"+b;if(Array.isArray(x)){w[p]===void 0&&(w[p]=[]);let S=w[p],A=!1;for(let E=0;E<x.length;E++)f(x[E],S,E)===!0&&(A=!0);return A}return f(x,w,p)}function f(v,M,b){if(M[b]===void 0)return typeof v=="number"||typeof v=="boolean"?M[b]=v:ArrayBuffer.isView(v)?M[b]=v.slice():M[b]=v.clone(),!0;{let w=M[b];if(typeof v=="number"||typeof v=="boolean"){if(w!==v)return M[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(w.equals(v)===!1)return w.copy(v),!0}}return!1}function m(v){let M=v.uniforms,b=0,w=16;for(let p=0,S=M.length;p<S;p++){let A=Array.isArray(M[p])?M[p]:[M[p]];for(let E=0,C=A.length;E<C;E++){let I=A[E],D=Array.isArray(I.value)?I.value:[I.value],L=Array.isArray(M[p])||Array.isArray(I.value),U=b;for(let B=0,ne=D.length;B<ne;B++){let z=D[B],q=y(z,L),W=b%w,_e=W%q.boundary,Te=W+_e;b+=_e,Te!==0&&w-Te<q.storage&&(b+=w-Te),B===0&&(U=b),b+=q.storage}let V=I.type==="int"?Int32Array:I.type==="uint"?Uint32Array:Float32Array;I.__data=new V((b-U)/Float32Array.BYTES_PER_ELEMENT),I.__offset=U}}let x=b%w;return x>0&&(b+=w-x),v.__size=b,v.__cache={},this}function y(v,M){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Ue("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Ue("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(v){let M=v.target;M.removeEventListener("dispose",g),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function _(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:_}}var x1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),is=null;function y1(){return is===null&&(is=new Es(x1,16,16,nr,Oi),is.name="DFG_LUT",is.minFilter=hn,is.magFilter=hn,is.wrapS=gi,is.wrapT=gi,is.generateMipmaps=!1,is.needsUpdate=!0),is}var wh=class{constructor(e={}){let{canvas:t=E_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=si}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let y=f,g=new Set([Gu,Hu,vl]),_=new Set([si,vi,Vo,Vr,Bu,zu]),v=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},w=null,x=null,p=[],S=[],A=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let E=this,C=!1,I=null,D=null,L=null,U=null;this._outputColorSpace=ln;let V=0,B=0,ne=null,z=-1,q=null,W=new ct,_e=new ct,Te=null,$=new De(0),ae=0,se=t.width,ce=t.height,re=1,de=null,Ye=null,Ae=new ct(0,0,se,ce),Be=new ct(0,0,se,ce),Le=!1,Me=new Rs,pt=new tl,Ge=!1,rt=!1,je=new Ce,Sn=new P,Ot=new ct,mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Rt=!1;function Kt(){return ne===null?re:1}let k=n;function Ft(R,F){return t.getContext(R,F)}let mt,Dt,ye,Gt,Oe,We,O,T,G,oe,te,fe,ve,j,Q,me,N,ee,J,ge,he,pe,ke;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",Qe,!1),t.addEventListener("webglcontextcreationerror",we,!1),k===null){let F="webgl2";if(k=Ft(F,R),k===null)throw Ft(F)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}nt()}catch(R){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",we,!1),Xe("WebGLRenderer: "+R.message),R}function nt(){mt=new PE(k),mt.init(),he=new d1(k,mt),Dt=new yE(k,mt,e,he),ye=new u1(k,mt),Dt.reversedDepthBuffer&&d&&ye.buffers.depth.setReversed(!0),D=k.createFramebuffer(),L=k.createFramebuffer(),U=k.createFramebuffer(),Gt=new OE(k),Oe=new ZT,We=new h1(k,mt,ye,Oe,Dt,he,Gt),O=new CE(E),T=new DS(k),pe=new _E(k,T),G=new IE(k,T,Gt,pe),oe=new DE(k,G,T,pe,Gt),ee=new NE(k,Dt,We),Q=new vE(Oe),te=new KT(E,O,mt,Dt,pe,Q),fe=new g1(E,Oe),ve=new jT,j=new s1(mt),N=new gE(E,O,ye,oe,m,l),me=new c1(E,oe,Dt),ke=new _1(k,Gt,Dt,ye),J=new xE(k,mt,Gt),ge=new LE(k,mt,Gt),Gt.programs=te.programs,E.capabilities=Dt,E.extensions=mt,E.properties=Oe,E.renderLists=ve,E.shadowMap=me,E.state=ye,E.info=Gt}y!==si&&(A=new FE(y,t.width,t.height,a,s,r));let le=new Cp(E,k);this.xr=le,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let R=mt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=mt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return re},this.setPixelRatio=function(R){R!==void 0&&(re=R,this.setSize(se,ce,!1))},this.getSize=function(R){return R.set(se,ce)},this.setSize=function(R,F,K=!0){if(le.isPresenting){Ue("WebGLRenderer: Can't change size while VR device is presenting.");return}se=R,ce=F,t.width=Math.floor(R*re),t.height=Math.floor(F*re),K===!0&&(t.style.width=R+"px",t.style.height=F+"px"),A!==null&&A.setSize(t.width,t.height),this.setViewport(0,0,R,F)},this.getDrawingBufferSize=function(R){return R.set(se*re,ce*re).floor()},this.setDrawingBufferSize=function(R,F,K){se=R,ce=F,re=K,t.width=Math.floor(R*K),t.height=Math.floor(F*K),this.setViewport(0,0,R,F)},this.setEffects=function(R){if(y===si){Xe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let F=0;F<R.length;F++)if(R[F].isOutputPass===!0){Ue("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}A.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(W)},this.getViewport=function(R){return R.copy(Ae)},this.setViewport=function(R,F,K,H){R.isVector4?Ae.set(R.x,R.y,R.z,R.w):Ae.set(R,F,K,H),ye.viewport(W.copy(Ae).multiplyScalar(Kt()).round())},this.getScissor=function(R){return R.copy(Be)},this.setScissor=function(R,F,K,H){R.isVector4?Be.set(R.x,R.y,R.z,R.w):Be.set(R,F,K,H),ye.scissor(_e.copy(Be).multiplyScalar(Kt()).round())},this.getScissorTest=function(){return Le},this.setScissorTest=function(R){ye.setScissorTest(Le=R)},this.setOpaqueSort=function(R){de=R},this.setTransparentSort=function(R){Ye=R},this.getClearColor=function(R){return R.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(R=!0,F=!0,K=!0){let H=0;if(R){let X=!1;if(ne!==null){let be=ne.texture.format;X=g.has(be)}if(X){let be=ne.texture.type,Re=_.has(be),xe=N.getClearColor(),Ee=N.getClearAlpha(),Ne=xe.r,Je=xe.g,ht=xe.b;Re?(v[0]=Ne,v[1]=Je,v[2]=ht,v[3]=Ee,k.clearBufferuiv(k.COLOR,0,v)):(M[0]=Ne,M[1]=Je,M[2]=ht,M[3]=Ee,k.clearBufferiv(k.COLOR,0,M))}else H|=k.COLOR_BUFFER_BIT}F&&(H|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(H|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H!==0&&k.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),I=R},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",Qe,!1),t.removeEventListener("webglcontextcreationerror",we,!1),N.dispose(),ve.dispose(),j.dispose(),We.dispose(),Oe.dispose(),O.dispose(),oe.dispose(),G.dispose(),pe.dispose(),ke.dispose(),te.dispose(),le.dispose(),le.removeEventListener("sessionstart",Ag),le.removeEventListener("sessionend",Rg),_r.stop()};function ze(R){R.preventDefault(),Ya("WebGLRenderer: Context Lost."),C=!0}function Qe(){Ya("WebGLRenderer: Context Restored."),C=!1;let R=Gt.autoReset,F=me.enabled,K=me.autoUpdate,H=me.needsUpdate,X=me.type;nt(),Gt.autoReset=R,me.enabled=F,me.autoUpdate=K,me.needsUpdate=H,me.type=X}function we(R){Xe("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function Nt(R){let F=R.target;F.removeEventListener("dispose",Nt),gn(F)}function gn(R){Hs(R),Oe.remove(R)}function Hs(R){let F=Oe.get(R).programs;F!==void 0&&(F.forEach(function(K){te.releaseProgram(K)}),R.isShaderMaterial&&te.releaseShaderCache(R))}this.renderBufferDirect=function(R,F,K,H,X,be){F===null&&(F=mn);let Re=X.isMesh&&X.matrixWorld.determinantAffine()<0,xe=Jv(R,F,K,H,X);ye.setMaterial(H,Re);let Ee=K.index,Ne=1;if(H.wireframe===!0){if(Ee=G.getWireframeAttribute(K),Ee===void 0)return;Ne=2}let Je=K.drawRange,ht=K.attributes.position,Pe=Je.start*Ne,dt=(Je.start+Je.count)*Ne;be!==null&&(Pe=Math.max(Pe,be.start*Ne),dt=Math.min(dt,(be.start+be.count)*Ne)),Ee!==null?(Pe=Math.max(Pe,0),dt=Math.min(dt,Ee.count)):ht!=null&&(Pe=Math.max(Pe,0),dt=Math.min(dt,ht.count));let rn=dt-Pe;if(rn<0||rn===1/0)return;pe.setup(X,H,xe,K,Ee);let Wt,kt=J;if(Ee!==null&&(Wt=T.get(Ee),kt=ge,kt.setIndex(Wt)),X.isMesh)H.wireframe===!0?(ye.setLineWidth(H.wireframeLinewidth*Kt()),kt.setMode(k.LINES)):kt.setMode(k.TRIANGLES);else if(X.isLine){let On=H.linewidth;On===void 0&&(On=1),ye.setLineWidth(On*Kt()),X.isLineSegments?kt.setMode(k.LINES):X.isLineLoop?kt.setMode(k.LINE_LOOP):kt.setMode(k.LINE_STRIP)}else X.isPoints?kt.setMode(k.POINTS):X.isSprite&&kt.setMode(k.TRIANGLES);if(X.isBatchedMesh)if(mt.get("WEBGL_multi_draw"))kt.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{let On=X._multiDrawStarts,Ie=X._multiDrawCounts,Wn=X._multiDrawCount,St=Ee?T.get(Ee).bytesPerElement:1,xr=Oe.get(H).currentProgram.getUniforms();for(let Nn=0;Nn<Wn;Nn++)xr.setValue(k,"_gl_DrawID",Nn),kt.render(On[Nn]/St,Ie[Nn])}else if(X.isInstancedMesh)kt.renderInstances(Pe,rn,X.count);else if(K.isInstancedBufferGeometry){let On=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ie=Math.min(K.instanceCount,On);kt.renderInstances(Pe,rn,Ie)}else kt.render(Pe,rn)};function Tg(R,F,K,H){I!==null&&R.isNodeMaterial&&I.setObject(H,R),Ge===!0&&Q.setState(R,K,!1),R.transparent===!0&&R.side===an&&R.forceSinglePass===!1?(R.side=En,R.needsUpdate=!0,Ra(R,F,H),R.side=ci,R.needsUpdate=!0,Ra(R,F,H),R.side=an):Ra(R,F,H)}this.compile=function(R,F,K=null){K===null&&(K=R),I!==null&&I.renderStart(R,F,K),x=j.get(K),x.init(F),S.push(x),K.traverseVisible(function(X){X.isLight&&X.layers.test(F.layers)&&(x.pushLight(X),X.castShadow&&x.pushShadow(X))}),R!==K&&R.traverseVisible(function(X){X.isLight&&X.layers.test(F.layers)&&(x.pushLight(X),X.castShadow&&x.pushShadow(X))}),x.setupLights(),I!==null&&I.updateLights(x.state.lightsArray),rt=this.localClippingEnabled,Ge=Q.init(this.clippingPlanes,rt),Ge===!0&&Q.setGlobalState(this.clippingPlanes,F),I!==null&&me.render(x.state.shadowsArray,K,F);let H=new Set;return R.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;let be=X.material;if(be)if(Array.isArray(be))for(let Re=0;Re<be.length;Re++){let xe=be[Re];Tg(xe,K,F,X),H.add(xe)}else Tg(be,K,F,X),H.add(be)}),x=S.pop(),I!==null&&I.renderEnd(),H},this.compileAsync=function(R,F,K=null){let H=this.compile(R,F,K);return new Promise(X=>{function be(){if(H.forEach(function(Re){let Ee=Oe.get(Re).currentProgram;(Ee===void 0||Ee.isReady())&&H.delete(Re)}),H.size===0){X(R);return}setTimeout(be,10)}mt.get("KHR_parallel_shader_compile")!==null?be():setTimeout(be,10)})};let Vd=null;function Kv(R){Vd&&Vd(R)}function Ag(){_r.stop()}function Rg(){_r.start()}let _r=new Q_;_r.setAnimationLoop(Kv),typeof self<"u"&&_r.setContext(self),this.setAnimationLoop=function(R){Vd=R,le.setAnimationLoop(R),R===null?_r.stop():_r.start()},le.addEventListener("sessionstart",Ag),le.addEventListener("sessionend",Rg),this.render=function(R,F){if(F!==void 0&&F.isCamera!==!0){Xe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;I!==null&&I.renderStart(R,F);let K=le.enabled===!0&&le.isPresenting===!0,H=A!==null&&(ne===null||K)&&A.begin(E,ne);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),F.parent===null&&F.matrixWorldAutoUpdate===!0&&F.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(A===null||A.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(F),F=le.getCamera()),R.isScene===!0&&R.onBeforeRender(E,R,F,ne),x=j.get(R,S.length),x.init(F),x.state.textureUnits=We.getTextureUnits(),S.push(x),je.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),F.isArrayCamera?pt.setFromArrayCamera(F):Me.setFromProjectionMatrix(je,_i,F.reversedDepth),rt=this.localClippingEnabled,Ge=Q.init(this.clippingPlanes,rt),w=ve.get(R,p.length),w.init(),p.push(w),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Re=E.xr.getDepthSensingMesh();Re!==null&&Hd(Re,F,-1/0,E.sortObjects)}Hd(R,F,0,E.sortObjects),w.finish(),I!==null&&I.updateLights(x.state.lightsArray),E.sortObjects===!0&&w.sort(de,Ye),Rt=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,Rt&&N.addToRenderList(w,R),this.info.autoReset===!0&&this.info.reset(),Ge===!0&&Q.beginShadows();let X=x.state.shadowsArray;if(me.render(X,R,F),Ge===!0&&Q.endShadows(),(H&&A.hasRenderPass())===!1){let Re=w.opaque,xe=w.transmissive;if(x.setupLights(),F.isArrayCamera){let Ee=F.cameras;if(xe.length>0)for(let Ne=0,Je=Ee.length;Ne<Je;Ne++){let ht=Ee[Ne];Pg(Re,xe,R,ht)}Rt&&N.render(R);for(let Ne=0,Je=Ee.length;Ne<Je;Ne++){let ht=Ee[Ne];Cg(w,R,ht,ht.viewport)}}else xe.length>0&&Pg(Re,xe,R,F),Rt&&N.render(R),Cg(w,R,F)}ne!==null&&B===0&&(We.updateMultisampleRenderTarget(ne),We.updateRenderTargetMipmap(ne)),H&&A.end(E),R.isScene===!0&&R.onAfterRender(E,R,F),pe.resetDefaultState(),z=-1,q=null,S.pop(),S.length>0?(x=S[S.length-1],We.setTextureUnits(x.state.textureUnits),Ge===!0&&Q.setGlobalState(E.clippingPlanes,x.state.camera)):x=null,p.pop(),p.length>0?w=p[p.length-1]:w=null,I!==null&&I.renderEnd()};function Hd(R,F,K,H){if(R.visible===!1)return;if(R.layers.test(F.layers)){if(R.isGroup)K=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(F);else if(R.isLight)x.pushLight(R),R.castShadow&&x.pushShadow(R);else if(R.isSprite){let Re=F.isArrayCamera?pt:Me;if(!R.frustumCulled||R.intersectsFrustum(Re)){H&&Ot.setFromMatrixPosition(R.matrixWorld).applyMatrix4(je);let xe=oe.update(R),Ee=R.material;Ee.visible&&w.push(R,xe,Ee,K,Ot.z,null,F)}}else if(R.isMesh||R.isLine||R.isPoints){let Re=F.isArrayCamera?pt:Me;if(!R.frustumCulled||R.intersectsFrustum(Re)){let xe=oe.update(R),Ee=R.material;if(H&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Ot.copy(R.boundingSphere.center)):(xe.boundingSphere===null&&xe.computeBoundingSphere(),Ot.copy(xe.boundingSphere.center)),Ot.applyMatrix4(R.matrixWorld).applyMatrix4(je)),Array.isArray(Ee)){let Ne=xe.groups;for(let Je=0,ht=Ne.length;Je<ht;Je++){let Pe=Ne[Je],dt=Ee[Pe.materialIndex];dt&&dt.visible&&w.push(R,xe,dt,K,Ot.z,Pe,F)}}else Ee.visible&&w.push(R,xe,Ee,K,Ot.z,null,F)}}}let be=R.children;for(let Re=0,xe=be.length;Re<xe;Re++)Hd(be[Re],F,K,H)}function Cg(R,F,K,H){let{opaque:X,transmissive:be,transparent:Re}=R;x.setupLightsView(K),Ge===!0&&Q.setGlobalState(E.clippingPlanes,K),H&&ye.viewport(W.copy(H)),X.length>0&&vc(X,F,K),be.length>0&&vc(be,F,K),Re.length>0&&vc(Re,F,K),ye.buffers.depth.setTest(!0),ye.buffers.depth.setMask(!0),ye.buffers.color.setMask(!0),ye.setPolygonOffset(!1)}function Pg(R,F,K,H){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(x.state.transmissionRenderTarget[H.id]===void 0){let Pe=mt.has("EXT_color_buffer_half_float")||mt.has("EXT_color_buffer_float");x.state.transmissionRenderTarget[H.id]=new zn(1,1,{generateMipmaps:!0,type:Pe?Oi:si,minFilter:yi,samples:Math.max(4,Dt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:it.workingColorSpace})}let be=x.state.transmissionRenderTarget[H.id],Re=H.viewport||W;be.setSize(Re.z*E.transmissionResolutionScale,Re.w*E.transmissionResolutionScale);let xe=E.getRenderTarget(),Ee=E.getActiveCubeFace(),Ne=E.getActiveMipmapLevel();E.setRenderTarget(be),E.getClearColor($),ae=E.getClearAlpha(),ae<1&&E.setClearColor(16777215,.5),E.clear(),Rt&&N.render(K);let Je=E.toneMapping;E.toneMapping=ts;let ht=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),x.setupLightsView(H),Ge===!0&&Q.setGlobalState(E.clippingPlanes,H),vc(R,K,H),We.updateMultisampleRenderTarget(be),We.updateRenderTargetMipmap(be),mt.has("WEBGL_multisampled_render_to_texture")===!1){let Pe=!1;for(let dt=0,rn=F.length;dt<rn;dt++){let Wt=F[dt],{object:kt,geometry:On,material:Ie,group:Wn}=Wt;if(Ie.side===an&&kt.layers.test(H.layers)){let St=Ie.side;Ie.side=En,Ie.needsUpdate=!0,Ig(kt,K,H,On,Ie,Wn),Ie.side=St,Ie.needsUpdate=!0,Pe=!0}}Pe===!0&&(We.updateMultisampleRenderTarget(be),We.updateRenderTargetMipmap(be))}E.setRenderTarget(xe,Ee,Ne),E.setClearColor($,ae),ht!==void 0&&(H.viewport=ht),E.toneMapping=Je}function vc(R,F,K){let H=F.isScene===!0?F.overrideMaterial:null;for(let X=0,be=R.length;X<be;X++){let Re=R[X],{object:xe,geometry:Ee,group:Ne}=Re,Je=Re.material;Je.allowOverride===!0&&H!==null&&(Je=H),xe.layers.test(K.layers)&&Ig(xe,F,K,Ee,Je,Ne)}}function Ig(R,F,K,H,X,be){I!==null&&X.isNodeMaterial&&I.setObject(R,X),R.onBeforeRender(E,F,K,H,X,be),R.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),X.onBeforeRender(E,F,K,H,R,be),X.transparent===!0&&X.side===an&&X.forceSinglePass===!1?(X.side=En,X.needsUpdate=!0,E.renderBufferDirect(K,F,H,X,R,be),X.side=ci,X.needsUpdate=!0,E.renderBufferDirect(K,F,H,X,R,be),X.side=an):E.renderBufferDirect(K,F,H,X,R,be),R.onAfterRender(E,F,K,H,X,be)}function Lg(R){let F=0;for(let K of R)K.texture!==null&&F++;return F}function Ra(R,F,K){F.isScene!==!0&&(F=mn);let H=Oe.get(R),X=x.state.lights,be=x.state.shadowsArray,Re=X.state.version,xe=te.getParameters(R,X.state,be,F,K,x.state.lightProbeGridArray),Ee=te.getProgramCacheKey(xe),Ne=H.programs;H.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?F.environment:null,H.fog=F.fog;let Je=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;H.envMap=O.get(R.envMap||H.environment,Je),H.envMapRotation=H.environment!==null&&R.envMap===null?F.environmentRotation:R.envMapRotation,Ne===void 0&&(R.addEventListener("dispose",Nt),Ne=new Map,H.programs=Ne,H.programVariants=new Map);let ht=Ne.get(Ee);if(ht!==void 0){if(H.currentProgram===ht&&H.lightsStateVersion===Re)return Ng(R,xe),ht}else xe.uniforms=te.getUniforms(R),I!==null&&R.isNodeMaterial&&I.build(R,K,xe),R.onBeforeCompile(xe,E),ht=te.acquireProgram(xe,Ee),Ne.set(Ee,ht),H.uniforms=xe.uniforms;let Pe=H.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Pe.clippingPlanes=Q.uniform),Ng(R,xe),H.needsLights=Qv(R),H.lightsStateVersion=Re,H.needsLights&&(Pe.ambientLightColor.value=X.state.ambient,Pe.lightProbe.value=X.state.probe,Pe.sunLights.value=X.state.sun,Pe.sunLightShadows.value=X.state.sunShadow,Pe.directionalLights.value=X.state.directional,Pe.directionalLightShadows.value=X.state.directionalShadow,Pe.spotLights.value=X.state.spot,Pe.spotLightShadows.value=X.state.spotShadow,Pe.rectAreaLights.value=X.state.rectArea,Pe.ltc_1.value=X.state.rectAreaLTC1,Pe.ltc_2.value=X.state.rectAreaLTC2,Pe.pointLights.value=X.state.point,Pe.pointLightShadows.value=X.state.pointShadow,Pe.hemisphereLights.value=X.state.hemi,Pe.sunShadowMatrix.value=X.state.sunShadowMatrix,Pe.sunShadowCascade.value=X.state.sunShadowCascade,Pe.directionalShadowMatrix.value=X.state.directionalShadowMatrix,Pe.spotLightMatrix.value=X.state.spotLightMatrix,Pe.spotLightMap.value=X.state.spotLightMap,Pe.pointShadowMatrix.value=X.state.pointShadowMatrix),H.numLightProbeGrids=Lg(x.state.lightProbeGridArray),H.currentProgram=ht,H.uniformsList=null,ht}function Zv(R,F,K,H,X){let be=Oe.get(R),Re=be.currentProgram.id+","+H+","+X,xe=be.programVariants.get(Re);return xe===void 0?(xe=Ra(R,F,K),be.programVariants.set(Re,xe)):(be.currentProgram=xe,be.uniformsList=null,be.outputColorSpace=H,be.toneMapping=X),xe}function Og(R){if(R.uniformsList===null){let F=R.currentProgram.getUniforms();R.uniformsList=Wo.seqWithValue(F.seq,R.uniforms)}return R.uniformsList}function Ng(R,F){let K=Oe.get(R);K.outputColorSpace=F.outputColorSpace,K.batching=F.batching,K.batchingColor=F.batchingColor,K.instancing=F.instancing,K.instancingColor=F.instancingColor,K.instancingMorph=F.instancingMorph,K.skinning=F.skinning,K.morphTargets=F.morphTargets,K.morphNormals=F.morphNormals,K.morphColors=F.morphColors,K.morphTargetsCount=F.morphTargetsCount,K.numClippingPlanes=F.numClippingPlanes,K.numIntersection=F.numClipIntersection,K.vertexAlphas=F.vertexAlphas,K.vertexTangents=F.vertexTangents,K.toneMapping=F.toneMapping}function Jv(R,F,K,H,X){F.isScene!==!0&&(F=mn),We.resetTextureUnits();let be=F.fog,Re=H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial?F.environment:null,xe=ne===null?E.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:it.workingColorSpace,Ee=H.isMeshStandardMaterial||H.isMeshLambertMaterial&&!H.envMap||H.isMeshPhongMaterial&&!H.envMap,Ne=O.get(H.envMap||Re,Ee),Je=H.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,ht=!!K.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Pe=!!K.morphAttributes.position,dt=!!K.morphAttributes.normal,rn=!!K.morphAttributes.color,Wt=ts;H.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(Wt=E.toneMapping);let kt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,On=kt!==void 0?kt.length:0,Ie=Oe.get(H),Wn=x.state.lights;if(Ge===!0&&(rt===!0||R!==q)){let Zt=R===q&&H.id===z;Q.setState(H,R,Zt)}let St=!1,xr=!1;H.version===Ie.__version?Ie.needsLights&&Ie.lightsStateVersion!==Wn.state.version||X.isBatchedMesh&&Ie.batching===!1||!X.isBatchedMesh&&Ie.batching===!0||X.isBatchedMesh&&Ie.batchingColor===!0&&X._colorsTexture===null||X.isBatchedMesh&&Ie.batchingColor===!1&&X._colorsTexture!==null||X.isInstancedMesh&&Ie.instancing===!1||!X.isInstancedMesh&&Ie.instancing===!0||X.isSkinnedMesh&&Ie.skinning===!1||!X.isSkinnedMesh&&Ie.skinning===!0||X.isInstancedMesh&&Ie.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&Ie.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&Ie.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&Ie.instancingMorph===!1&&X.morphTexture!==null||Ie.envMap!==Ne||H.fog===!0&&Ie.fog!==be||Ie.numClippingPlanes!==void 0&&(Ie.numClippingPlanes!==Q.numPlanes||Ie.numIntersection!==Q.numIntersection)||Ie.vertexAlphas!==Je||Ie.vertexTangents!==ht||Ie.morphTargets!==Pe||Ie.morphNormals!==dt||Ie.morphColors!==rn||Ie.morphTargetsCount!==On||Ie.numLightProbeGrids!==Lg(x.state.lightProbeGridArray)?St=!0:(Ie.outputColorSpace!==xe||Ie.toneMapping!==Wt)&&(xr=!0):(St=!0,Ie.__version=H.version);let Nn=Ie.currentProgram;(St===!0||xr===!0)&&(Nn=xr===!0?Zv(H,F,X,xe,Wt):Ra(H,F,X),I&&H.isNodeMaterial&&I.onUpdateProgram(H,Nn,Ie));let bc=!1,Gs=!1,yr=!1,xt=Nn.getUniforms(),Mn=Ie.uniforms;if(ye.useProgram(Nn.program)&&(bc=!0,Gs=!0,yr=!0),H.id!==z&&(z=H.id,Gs=!0),bc||q!==R){ye.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),xt.setValue(k,"projectionMatrix",R.projectionMatrix),xt.setValue(k,"viewMatrix",R.matrixWorldInverse);let _n=xt.map.cameraPosition;_n!==void 0&&_n.setValue(k,Sn.setFromMatrixPosition(R.matrixWorld)),Dt.logarithmicDepthBuffer&&xt.setValue(k,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&xt.setValue(k,"isOrthographic",R.isOrthographicCamera===!0),q!==R&&(q=R,Gs=!0,yr=!0)}if(Ie.needsLights&&(Wn.state.sunShadowMap.length>0&&xt.setValue(k,"sunShadowMap",Wn.state.sunShadowMap,We),Wn.state.directionalShadowMap.length>0&&xt.setValue(k,"directionalShadowMap",Wn.state.directionalShadowMap,We),Wn.state.spotShadowMap.length>0&&xt.setValue(k,"spotShadowMap",Wn.state.spotShadowMap,We),Wn.state.pointShadowMap.length>0&&xt.setValue(k,"pointShadowMap",Wn.state.pointShadowMap,We)),X.isSkinnedMesh){xt.setOptional(k,X,"bindMatrix"),xt.setOptional(k,X,"bindMatrixInverse");let Zt=X.skeleton;Zt&&(Zt.boneTexture===null&&Zt.computeBoneTexture(),xt.setValue(k,"boneTexture",Zt.boneTexture,We))}X.isBatchedMesh&&(xt.setOptional(k,X,"batchingTexture"),xt.setValue(k,"batchingTexture",X._matricesTexture,We),xt.setOptional(k,X,"batchingIdTexture"),xt.setValue(k,"batchingIdTexture",X._indirectTexture,We),xt.setOptional(k,X,"batchingColorTexture"),X._colorsTexture!==null&&xt.setValue(k,"batchingColorTexture",X._colorsTexture,We));let Mi=K.morphAttributes;if((Mi.position!==void 0||Mi.normal!==void 0||Mi.color!==void 0)&&ee.update(X,K,Nn),(Gs||Ie.receiveShadow!==X.receiveShadow)&&(Ie.receiveShadow=X.receiveShadow,xt.setValue(k,"receiveShadow",X.receiveShadow)),(H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial)&&H.envMap===null&&F.environment!==null&&(Mn.envMapIntensity.value=F.environmentIntensity),Mn.dfgLUT!==void 0&&(Mn.dfgLUT.value=y1()),Gs){if(xt.setValue(k,"toneMappingExposure",E.toneMappingExposure),Ie.needsLights&&jv(Mn,yr),be&&H.fog===!0&&fe.refreshFogUniforms(Mn,be),fe.refreshMaterialUniforms(Mn,H,re,ce,x.state.transmissionRenderTarget[R.id]),Ie.needsLights&&Ie.numLightProbeGrids>0){let Zt=b,_n=0;for(let _s of x.state.lightProbeGridArray)_s.texture!==null&&(Zt.textures[_n]=_s.texture,Zt.min[_n]=_s.boundingBox.min,Zt.max[_n]=_s.boundingBox.max,Zt.resolution[_n]=_s.resolution,_n++);for(let _s in Zt)Zt[_s].length=_n;Mn.probesSH.value=Zt.textures,Mn.probesMin.value=Zt.min,Mn.probesMax.value=Zt.max,Mn.probesResolution.value=Zt.resolution}Wo.upload(k,Og(Ie),Mn,We)}if(H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(Wo.upload(k,Og(Ie),Mn,We),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&xt.setValue(k,"center",X.center),xt.setValue(k,"modelViewMatrix",X.modelViewMatrix),xt.setValue(k,"normalMatrix",X.normalMatrix),xt.setValue(k,"modelMatrix",X.matrixWorld),H.uniformsGroups!==void 0){let Zt=H.uniformsGroups;for(let _n=0,_s=Zt.length;_n<_s;_n++){let Ug=Zt[_n];ke.update(Ug,Nn),ke.bind(Ug,Nn)}}return Nn}function jv(R,F){R.ambientLightColor.needsUpdate=F,R.lightProbe.needsUpdate=F,R.sunLights.needsUpdate=F,R.sunLightShadows.needsUpdate=F,R.directionalLights.needsUpdate=F,R.directionalLightShadows.needsUpdate=F,R.pointLights.needsUpdate=F,R.pointLightShadows.needsUpdate=F,R.spotLights.needsUpdate=F,R.spotLightShadows.needsUpdate=F,R.rectAreaLights.needsUpdate=F,R.hemisphereLights.needsUpdate=F}function Qv(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return V},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(R,F,K){let H=Oe.get(R);H.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),Oe.get(R.texture).__webglTexture=F,Oe.get(R.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:K,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,F){let K=Oe.get(R);K.__webglFramebuffer=F,K.__useDefaultFramebuffer=F===void 0},this.setRenderTarget=function(R,F=0,K=0){ne=R,V=F,B=K;let H=null,X=!1,be=!1;if(R){let xe=Oe.get(R);if(xe.__useDefaultFramebuffer!==void 0){ye.bindFramebuffer(k.FRAMEBUFFER,xe.__webglFramebuffer),W.copy(R.viewport),_e.copy(R.scissor),Te=R.scissorTest,ye.viewport(W),ye.scissor(_e),ye.setScissorTest(Te),z=-1;return}else if(xe.__webglFramebuffer===void 0)We.setupRenderTarget(R);else if(xe.__hasExternalTextures)We.rebindTextures(R,Oe.get(R.texture).__webglTexture,Oe.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Je=R.depthTexture;if(xe.__boundDepthTexture!==Je){if(Je!==null&&Oe.has(Je)&&(R.width!==Je.image.width||R.height!==Je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");We.setupDepthRenderbuffer(R)}}let Ee=R.texture;(Ee.isData3DTexture||Ee.isDataArrayTexture||Ee.isCompressedArrayTexture)&&(be=!0);let Ne=Oe.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Ne[F])?H=Ne[F][K]:H=Ne[F],X=!0):R.samples>0&&We.useMultisampledRTT(R)===!1?H=Oe.get(R).__webglMultisampledFramebuffer:Array.isArray(Ne)?H=Ne[K]:H=Ne,W.copy(R.viewport),_e.copy(R.scissor),Te=R.scissorTest}else W.copy(Ae).multiplyScalar(re).floor(),_e.copy(Be).multiplyScalar(re).floor(),Te=Le;if(K!==0&&(H=D),ye.bindFramebuffer(k.FRAMEBUFFER,H)&&ye.drawBuffers(R,H),ye.viewport(W),ye.scissor(_e),ye.setScissorTest(Te),X){let xe=Oe.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+F,xe.__webglTexture,K)}else if(be){let xe=F;for(let Ee=0;Ee<R.textures.length;Ee++){let Ne=Oe.get(R.textures[Ee]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Ee,Ne.__webglTexture,K,xe)}}else if(R!==null&&K!==0){let xe=Oe.get(R.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,xe.__webglTexture,K)}z=-1};function Dg(R){let F=Oe.get(R);return(F.__readFormat!==R.format||F.__readType!==R.type)&&(F.__readFormat=R.format,F.__readType=R.type,F.__formatReadable=Dt.textureFormatReadable(R.format),F.__typeReadable=Dt.textureTypeReadable(R.type)),F}this.readRenderTargetPixels=function(R,F,K,H,X,be,Re,xe=0){if(!(R&&R.isWebGLRenderTarget)){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ee=Oe.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Re!==void 0&&(Ee=Ee[Re],Array.isArray(Ee)&&(Ee=Ee[0])),Ee){ye.bindFramebuffer(k.FRAMEBUFFER,Ee);try{let Ne=R.textures[xe],Je=Ne.format,ht=Ne.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+xe);let Pe=Dg(Ne);if(Pe.__formatReadable===!1){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Pe.__typeReadable===!1){Xe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}F>=0&&F<=R.width-H&&K>=0&&K<=R.height-X&&k.readPixels(F,K,H,X,he.convert(Je),he.convert(ht),be)}finally{let Ne=ne!==null?Oe.get(ne).__webglFramebuffer:null;ye.bindFramebuffer(k.FRAMEBUFFER,Ne)}}},this.readRenderTargetPixelsAsync=async function(R,F,K,H,X,be,Re,xe=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ee=Oe.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Re!==void 0&&(Ee=Ee[Re],Array.isArray(Ee)&&(Ee=Ee[0])),Ee)if(F>=0&&F<=R.width-H&&K>=0&&K<=R.height-X){ye.bindFramebuffer(k.FRAMEBUFFER,Ee);let Ne=R.textures[xe],Je=Ne.format,ht=Ne.type;R.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+xe);let Pe=Dg(Ne);if(Pe.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Pe.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let dt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,dt),k.bufferData(k.PIXEL_PACK_BUFFER,be.byteLength,k.STREAM_READ),k.readPixels(F,K,H,X,he.convert(Je),he.convert(ht),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let rn=ne!==null?Oe.get(ne).__webglFramebuffer:null;ye.bindFramebuffer(k.FRAMEBUFFER,rn);let Wt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await A_(k,Wt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,dt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,be),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(dt),k.deleteSync(Wt),be}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,F=null,K=0){let H=Math.pow(2,-K),X=Math.floor(R.image.width*H),be=Math.floor(R.image.height*H),Re=F!==null?F.x:0,xe=F!==null?F.y:0;We.setTexture2D(R,0),k.copyTexSubImage2D(k.TEXTURE_2D,K,0,0,Re,xe,X,be),ye.unbindTexture()},this.copyTextureToTexture=function(R,F,K=null,H=null,X=0,be=0){let Re,xe,Ee,Ne,Je,ht,Pe,dt,rn,Wt=R.isCompressedTexture?R.mipmaps[be]:R.image;if(K!==null)Re=K.max.x-K.min.x,xe=K.max.y-K.min.y,Ee=K.isBox3?K.max.z-K.min.z:1,Ne=K.min.x,Je=K.min.y,ht=K.isBox3?K.min.z:0;else{let xt=Math.pow(2,-X);Re=Math.floor(Wt.width*xt),xe=Math.floor(Wt.height*xt),R.isDataArrayTexture?Ee=Wt.depth:R.isData3DTexture?Ee=Math.floor(Wt.depth*xt):Ee=1,Ne=0,Je=0,ht=0}H!==null?(Pe=H.x,dt=H.y,rn=H.z):(Pe=0,dt=0,rn=0);let kt=he.convert(F.format),On=he.convert(F.type),Ie;F.isData3DTexture?(We.setTexture3D(F,0),Ie=k.TEXTURE_3D):F.isDataArrayTexture||F.isCompressedArrayTexture?(We.setTexture2DArray(F,0),Ie=k.TEXTURE_2D_ARRAY):(We.setTexture2D(F,0),Ie=k.TEXTURE_2D),ye.activeTexture(k.TEXTURE0),ye.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,F.flipY),ye.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,F.premultiplyAlpha),ye.pixelStorei(k.UNPACK_ALIGNMENT,F.unpackAlignment);let Wn=ye.getParameter(k.UNPACK_ROW_LENGTH),St=ye.getParameter(k.UNPACK_IMAGE_HEIGHT),xr=ye.getParameter(k.UNPACK_SKIP_PIXELS),Nn=ye.getParameter(k.UNPACK_SKIP_ROWS),bc=ye.getParameter(k.UNPACK_SKIP_IMAGES);ye.pixelStorei(k.UNPACK_ROW_LENGTH,Wt.width),ye.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Wt.height),ye.pixelStorei(k.UNPACK_SKIP_PIXELS,Ne),ye.pixelStorei(k.UNPACK_SKIP_ROWS,Je),ye.pixelStorei(k.UNPACK_SKIP_IMAGES,ht);let Gs=R.isDataArrayTexture||R.isData3DTexture,yr=F.isDataArrayTexture||F.isData3DTexture;if(R.isDepthTexture){let xt=Oe.get(R),Mn=Oe.get(F),Mi=Oe.get(xt.__renderTarget),Zt=Oe.get(Mn.__renderTarget);ye.bindFramebuffer(k.READ_FRAMEBUFFER,Mi.__webglFramebuffer),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,Zt.__webglFramebuffer);for(let _n=0;_n<Ee;_n++)Gs&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Oe.get(R).__webglTexture,X,ht+_n),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Oe.get(F).__webglTexture,be,rn+_n)),k.blitFramebuffer(Ne,Je,Ne+Re,Je+xe,Pe,dt,Pe+Re,dt+xe,k.DEPTH_BUFFER_BIT,k.NEAREST);ye.bindFramebuffer(k.READ_FRAMEBUFFER,null),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(X!==0||R.isRenderTargetTexture||Oe.has(R)){let xt=Oe.get(R),Mn=Oe.get(F);ye.bindFramebuffer(k.READ_FRAMEBUFFER,L),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,U);for(let Mi=0;Mi<Ee;Mi++)Gs?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,xt.__webglTexture,X,ht+Mi):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,xt.__webglTexture,X),yr?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Mn.__webglTexture,be,rn+Mi):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Mn.__webglTexture,be),X!==0?k.blitFramebuffer(Ne,Je,Ne+Re,Je+xe,Pe,dt,Pe+Re,dt+xe,k.COLOR_BUFFER_BIT,k.NEAREST):yr?k.copyTexSubImage3D(Ie,be,Pe,dt,rn+Mi,Ne,Je,Re,xe):k.copyTexSubImage2D(Ie,be,Pe,dt,Ne,Je,Re,xe);ye.bindFramebuffer(k.READ_FRAMEBUFFER,null),ye.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else yr?R.isDataTexture||R.isData3DTexture?k.texSubImage3D(Ie,be,Pe,dt,rn,Re,xe,Ee,kt,On,Wt.data):F.isCompressedArrayTexture?k.compressedTexSubImage3D(Ie,be,Pe,dt,rn,Re,xe,Ee,kt,Wt.data):k.texSubImage3D(Ie,be,Pe,dt,rn,Re,xe,Ee,kt,On,Wt):R.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,be,Pe,dt,Re,xe,kt,On,Wt.data):R.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,be,Pe,dt,Wt.width,Wt.height,kt,Wt.data):k.texSubImage2D(k.TEXTURE_2D,be,Pe,dt,Re,xe,kt,On,Wt);ye.pixelStorei(k.UNPACK_ROW_LENGTH,Wn),ye.pixelStorei(k.UNPACK_IMAGE_HEIGHT,St),ye.pixelStorei(k.UNPACK_SKIP_PIXELS,xr),ye.pixelStorei(k.UNPACK_SKIP_ROWS,Nn),ye.pixelStorei(k.UNPACK_SKIP_IMAGES,bc),be===0&&F.generateMipmaps===!0&&F.mipmapsAutoUpdate===!0&&k.generateMipmap(Ie),ye.unbindTexture()},this.initRenderTarget=function(R){Oe.get(R).__webglFramebuffer===void 0&&We.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?We.setTextureCube(R,0):R.isData3DTexture?We.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?We.setTexture2DArray(R,0):We.setTexture2D(R,0),ye.unbindTexture()},this.resetState=function(){V=0,B=0,ne=null,ye.reset(),pe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return _i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=it._getDrawingBufferColorSpace(e),t.unpackColorSpace=it._getUnpackColorSpace()}};var ux=["#c2413b","#3d8b4f","#3a6fb5"],v1=27,Ah=class{constructor(e,t,n){this.box=e;this.stage=t;this.build(n)}box;stage;arms=[];build(e){this.arms=[],this.box.replaceChildren();for(let t of[0,1,2])for(let n of[-1,1]){let s=[0,0,0];s[t]=n;let r=e.up===2?[s[0],s[2],-s[1]]:s,o="XYZ"[t],a=n>0?Dn("line",{stroke:ux[t]}):null,l=Dn("circle",{r:n>0?8.5:5.5,fill:ux[t],"fill-opacity":n>0?1:.35}),c=Dn("g",{tabindex:0,role:"button","aria-label":`Look from ${n>0?"":"minus "}${o}`},l,...n>0?[Dn("text",{},o)]:[]),u=()=>this.stage.look([r[0],r[1],r[2]+(Math.abs(r[1])>.5?.001:0)]);c.addEventListener("click",u),c.addEventListener("keydown",h=>{["Enter"," "].includes(h.key)&&(h.preventDefault(),u())}),this.arms.push({direction:r,line:a,tip:c})}this.place()}place(){let e=this.arms.map(t=>({arm:t,at:new P(...t.direction).applyQuaternion(this.stage.camera.quaternion.clone().invert()).multiplyScalar(v1)}));e.sort((t,n)=>t.at.z-n.at.z);for(let{arm:t,at:n}of e){let[s,r]=[n.x.toFixed(1),(-n.y).toFixed(1)];t.line?.setAttribute("x2",s),t.line?.setAttribute("y2",r),t.tip.setAttribute("transform",`translate(${s} ${r})`)}if(!this.box.contains(document.activeElement)){let t=e.flatMap(({arm:n})=>[n.line,n.tip]).filter(n=>n!==null);t.some((n,s)=>this.box.children[s]!==n)&&this.box.append(...t)}}};var dx=1e-9,b1=800,ss=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],S1=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]],Nl=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Yo=i=>Math.hypot(...i);function Rh(i){return i.flatMap((e,t)=>Mr(e)?hx(e,t):[...hx(e,t),...M1(e,t)])}function hx(i,e){return i.points.flatMap((t,n)=>Wg(t)?[]:[{line:e,points:[n],text:`${i.name}, point ${n+1} is not three numbers`}])}function M1(i,e){let t=i.points.map(Yt);if(t.some(c=>c===null)||t.length<2)return[];let n=t,s=Math.max(...n.map(c=>Yo(ss(c,n[0]))),0),r=[],o=i.closed&&n.length>2?n.length:n.length-1;for(let c=0;c<o;c+=1){let u=(c+1)%n.length;Yo(ss(n[c],n[u]))<=dx*s&&r.push({line:e,points:[c,u],text:`${i.name}, points ${c+1} and ${u+1} are the same`})}if(i.closed&&s>0&&w1(n,s))return[...r,{line:e,points:n.map((c,u)=>u),text:`${i.name}: all points lie on one line`}];let a=new Set(r.map(({points:[,c]})=>c)),l=n.map((c,u)=>u).filter(c=>!a.has(c));return i.closed&&l.length<=b1&&r.push(...E1(i,e,l.map(c=>n[c]),l,s)),r}function w1(i,e){let t=i[0],n=i.reduce((r,o)=>Yo(ss(o,t))>Yo(ss(r,t))?o:r),s=ss(n,t);return i.every(r=>Yo(S1(s,ss(r,t)))<=1e-9*e*e)}function E1(i,e,t,n,s){let r=[],o=t.length;for(let a=0;a<o&&r.length<4;a+=1)for(let l=a+2;l<o&&r.length<4;l+=1){if(a===0&&l===o-1)continue;let[c,u,h,d]=[t[a],t[(a+1)%o],t[l],t[(l+1)%o]];if(T1(c,u,h,d)>dx*s)continue;let f=[a,(a+1)%o,l,(l+1)%o].map(v=>n[v]),[m,y,g,_]=f.map(v=>v+1);r.push({line:e,points:f,text:`${i.name}: the edge from point ${m} to ${y} meets the edge from ${g} to ${_}`})}return r}function T1(i,e,t,n){let s=ss(e,i),r=ss(n,t),o=ss(i,t),a=Nl(s,s),l=Nl(s,r),c=Nl(r,r),u=Nl(s,o),h=Nl(r,o),d=a*c-l*l,f=g=>Math.min(1,Math.max(0,g)),m=d>1e-14*a*c?f((l*h-c*u)/d):0,y=c>0?f((l*m+h)/c):0;return m=a>0?f((l*y-u)/a):0,y=c>0?f((l*m+h)/c):0,Yo(ss([i[0]+m*s[0],i[1]+m*s[1],i[2]+m*s[2]],[t[0]+y*r[0],t[1]+y*r[1],t[2]+y*r[2]]))}var Ch=class{document;past=[];future=[];opened=null;constructor(e){this.document=e}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}begin(){this.opened??=JSON.stringify(this.document)}commit(){let e=this.opened;if(this.opened=null,e===null||e===JSON.stringify(this.document))return!1;this.past.push(e),this.future=[];let t=this.past.reduce((n,s)=>n+s.length,0);for(;this.past.length>500||t>4e7&&this.past.length>1;)t-=this.past.shift().length;return!0}edit(e){let t=this.opened!==null;return this.begin(),e(this.document),t||this.commit()}undo(){return this.step(this.past,this.future)}redo(){return this.step(this.future,this.past)}step(e,t){this.opened!==null&&this.commit();let n=e.pop();return n===void 0?!1:(t.push(JSON.stringify(this.document)),this.document=JSON.parse(n),!0)}};Se.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Fe},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};jn.line={uniforms:Cl.merge([Se.common,Se.fog,Se.line]),vertexShader:`
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
		`};var $o=class extends dn{constructor(e){super({type:"LineMaterial",uniforms:Cl.clone(jn.line.uniforms),vertexShader:jn.line.vertexShader,fragmentShader:jn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var fx=new et,Ph=new P,Ko=class extends ml{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new un(e,3)),this.setAttribute("uv",new un(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new er(t,6,1);return this.setAttribute("instanceStart",new ni(n,3,0)),this.setAttribute("instanceEnd",new ni(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new er(t,6,1);return this.setAttribute("instanceColorStart",new ni(n,3,0)),this.setAttribute("instanceColorEnd",new ni(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new ol(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new et);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),fx.setFromBufferAttribute(t),this.boundingBox.union(fx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new zt),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Ph.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ph)),Ph.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ph));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Pp=new ct,px=new P,mx=new P,Tn=new ct,An=new ct,rs=new ct,Ip=new P,Lp=new Ce,Rn=new wn,gx=new P,Ih=new et,Lh=new zt,os=new ct,as,Gr;function _x(i,e,t){return os.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),os.multiplyScalar(1/os.w),os.x=Gr/t.width,os.y=Gr/t.height,os.applyMatrix4(i.projectionMatrixInverse),os.multiplyScalar(1/os.w),Math.abs(Math.max(os.x,os.y))}function A1(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Rn.start.fromBufferAttribute(s,a),Rn.end.fromBufferAttribute(r,a),Rn.applyMatrix4(t);let c=new P,u=new P;as.distanceSqToSegment(Rn.start,Rn.end,u,c),u.distanceTo(c)<Gr*.5&&e.push({point:u,pointOnLine:c,distance:as.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function R1(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;as.at(1,rs),rs.w=1,rs.applyMatrix4(e.matrixWorldInverse),rs.applyMatrix4(n),rs.multiplyScalar(1/rs.w),rs.x*=r.x/2,rs.y*=r.y/2,rs.z=0,Ip.copy(rs),Lp.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=u;d<f;d++){if(Tn.fromBufferAttribute(l,d),An.fromBufferAttribute(c,d),Tn.w=1,An.w=1,Tn.applyMatrix4(Lp),An.applyMatrix4(Lp),Tn.z>h&&An.z>h)continue;if(Tn.z>h){let M=Tn.z-An.z,b=(Tn.z-h)/M;Tn.lerp(An,b)}else if(An.z>h){let M=An.z-Tn.z,b=(An.z-h)/M;An.lerp(Tn,b)}Tn.applyMatrix4(n),An.applyMatrix4(n),Tn.multiplyScalar(1/Tn.w),An.multiplyScalar(1/An.w),Tn.x*=r.x/2,Tn.y*=r.y/2,An.x*=r.x/2,An.y*=r.y/2,Rn.start.copy(Tn),Rn.start.z=0,Rn.end.copy(An),Rn.end.z=0;let y=Rn.closestPointToPointParameter(Ip,!0);Rn.at(y,gx);let g=Go.lerp(Tn.z,An.z,y),_=g>=-1&&g<=1,v=Ip.distanceTo(gx)<Gr*.5;if(_&&v){Rn.start.fromBufferAttribute(l,d),Rn.end.fromBufferAttribute(c,d),Rn.start.applyMatrix4(o),Rn.end.applyMatrix4(o);let M=new P,b=new P;as.distanceSqToSegment(Rn.start,Rn.end,b,M),t.push({point:b,pointOnLine:M,distance:as.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var Oh=class extends Pt{constructor(e=new Ko,t=new $o({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)px.fromBufferAttribute(t,o),mx.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+px.distanceTo(mx);let r=new er(s,2,1);return e.setAttribute("instanceDistanceStart",new ni(r,1,0)),e.setAttribute("instanceDistanceEnd",new ni(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;as=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Gr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Lh.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Gr*.5;else{let h=Math.max(s.near,Lh.distanceToPoint(as.origin));c=_x(s,h,l.resolution)}if(Lh.radius+=c,as.intersectsSphere(Lh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Ih.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=Gr*.5;else{let h=Math.max(s.near,Ih.distanceToPoint(as.origin));u=_x(s,h,l.resolution)}Ih.expandByScalar(u),as.intersectsBox(Ih)!==!1&&(n?A1(this,t):R1(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Pp),this.material.uniforms.resolution.value.set(Pp.z,Pp.w))}};var Zo=Math.pow(2,-24),Dl=Symbol("SKIP_GENERATION"),Nh={strategy:0,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[Dl]:!1};function Vt(i,e,t){return t.min.x=e[i],t.min.y=e[i+1],t.min.z=e[i+2],t.max.x=e[i+3],t.max.y=e[i+4],t.max.z=e[i+5],t}function Ul(i){let e=-1,t=-1/0;for(let n=0;n<3;n++){let s=i[n+3]-i[n];s>t&&(t=s,e=n)}return e}function Op(i,e,t){for(let n=0;n<3;n++){let s=e[i+2*n],r=e[i+2*n+1],o=s-r,a=s+r;o<t[n]&&(t[n]=o),a>t[n+3]&&(t[n+3]=a)}}function Dh(i){let e=i[3]-i[0],t=i[4]-i[1],n=i[5]-i[2];return 2*(e*t+t*n+n*e)}function _t(i,e){return e[i+15]===65535}function It(i,e){return e[i+6]}function Ut(i,e){return e[i+14]}function Et(i){return i+8}function Tt(i,e){let t=e[i+6];return i+t*8}function Jo(i,e){return e[i+7]}function Uh(i,e,t,n,s){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0,h=1/0,d=1/0,f=1/0,m=-1/0,y=-1/0,g=-1/0,_=i.offset||0;for(let v=(e-_)*6,M=(e+t-_)*6;v<M;v+=6){let b=i[v+0],w=i[v+1],x=b-w,p=b+w;x<r&&(r=x),p>l&&(l=p),b<h&&(h=b),b>m&&(m=b);let S=i[v+2],A=i[v+3],E=S-A,C=S+A;E<o&&(o=E),C>c&&(c=C),S<d&&(d=S),S>y&&(y=S);let I=i[v+4],D=i[v+5],L=I-D,U=I+D;L<a&&(a=L),U>u&&(u=U),I<f&&(f=I),I>g&&(g=I)}n[0]=r,n[1]=o,n[2]=a,n[3]=l,n[4]=c,n[5]=u,s[0]=h,s[1]=d,s[2]=f,s[3]=m,s[4]=y,s[5]=g}var cs=8,Dp=8,Np=new Int32Array(cs),ls=new Float32Array(cs*6),jo=new Float32Array(cs*6),Ni=new Float32Array(6),Fh=new Float32Array(6),ir=new Int32Array(Dp),yx=new Float32Array(Dp*6);function I1(i,e,t,n){for(let s=0;s<3;s++){let r=e[i+2*s],o=e[i+2*s+1],a=r-o,l=r+o;a<t[n+s]&&(t[n+s]=a),l>t[n+s+3]&&(t[n+s+3]=l)}}function vx(i,e){let t=i[e+3]-i[e],n=i[e+4]-i[e+1],s=i[e+5]-i[e+2];return 2*(t*n+n*s+s*t)}function bx(i,e,t,n,s,r){let o=-1,a=0;if(r===0)o=Ul(e),o!==-1&&(a=(e[o]+e[o+3])/2);else if(r===1)o=Ul(i),o!==-1&&(a=L1(t,n,s,o));else if(r===2){let l=Dh(i),c=1.25*s,u=t.offset||0,h=(n-u)*6,d=(n+s-u)*6;for(let f=0;f<3;f++){let m=e[f],_=(e[f+3]-m)/cs;if(s<Dp){for(let v=0;v<s;v++){let M=h+v*6,b=t[M+2*f],w=v;for(;w>0&&t[ir[w-1]+2*f]>b;)ir[w]=ir[w-1],w--;ir[w]=M}for(let v=0;v<3;v++)Ni[v]=1/0,Ni[v+3]=-1/0,Fh[v]=1/0,Fh[v+3]=-1/0;for(let v=s-1;v>=0;v--)Op(ir[v],t,Fh),yx.set(Fh,v*6);for(let v=0;v<s-1;v++){Op(ir[v],t,Ni);let M=t[ir[v+1]+2*f];if(t[ir[v]+2*f]===M)continue;let b=v+1,w=s-b,x=Dh(Ni)/l,p=vx(yx,b*6)/l,S=1+1.25*(x*b+p*w);S<c&&(o=f,c=S,a=M)}}else{for(let b=0;b<cs;b++){Np[b]=0;for(let w=0;w<3;w++)ls[b*6+w]=1/0,ls[b*6+w+3]=-1/0}for(let b=h;b<d;b+=6){let p=~~((t[b+2*f]-m)/_);p>=cs&&(p=cs-1),Np[p]++,I1(b,t,ls,p*6)}let v=(cs-1)*6;for(let b=0;b<6;b++)jo[v+b]=ls[v+b];for(let b=cs-2;b>=0;b--){let w=b*6,x=w+6;for(let p=0;p<3;p++)jo[w+p]=Math.min(ls[w+p],jo[x+p]),jo[w+p+3]=Math.max(ls[w+p+3],jo[x+p+3])}let M=0;for(let b=0;b<cs-1;b++){let w=b*6,x=Np[b];if(x!==0)for(let C=0;C<3;C++)M===0?(Ni[C]=ls[w+C],Ni[C+3]=ls[w+C+3]):(Ni[C]=Math.min(Ni[C],ls[w+C]),Ni[C+3]=Math.max(Ni[C+3],ls[w+C+3]));M+=x;let p=0,S=0;M!==0&&(p=Dh(Ni)/l);let A=s-M;A!==0&&(S=vx(jo,w+6)/l);let E=1+1.25*(p*M+S*A);E<c&&(o=f,c=E,a=m+_+b*_)}}}}else console.warn(`BVH: Invalid build strategy value ${r} used.`);return{axis:o,pos:a}}function L1(i,e,t,n){let s=0,r=i.offset;for(let o=e,a=e+t;o<a;o++)s+=i[(o-r)*6+n*2];return s/t}function Sx(i,e,t,n,s,r){let o=n,a=n+s-1,l=r.pos,c=r.axis*2,u=t.offset||0;for(;;){for(;o<=a&&t[(o-u)*6+c]<l;)o++;for(;o<=a&&t[(a-u)*6+c]>=l;)a--;if(o<a){for(let h=0;h<e;h++){let d=i[o*e+h];i[o*e+h]=i[a*e+h],i[a*e+h]=d}for(let h=0;h<6;h++){let d=o-u,f=a-u,m=t[d*6+h];t[d*6+h]=t[f*6+h],t[f*6+h]=m}o++,a--}else return o}}var O1=Math.pow(2,32),Qo=new Float32Array(6),kh=new Float32Array(6);function N1(i,e,t,n,s,r){let{maxDepth:o,verbose:a,targetLeafSize:l,_strictLeafSize:c=1/0,strategy:u,onProgress:h,useSharedArrayBuffer:d=!1}=s,f=i.primitiveBuffer,m=i.primitiveBufferStride,y=d?SharedArrayBuffer:ArrayBuffer,g=new y(32*Math.max(1,2*Math.ceil(n)-1)),_=new Float32Array(g),v=new Uint32Array(g),M=new Uint16Array(g),b=0,w=!1;return Uh(e,t,n,Qo,kh),S(t,n,0),g.slice(0,b*32);function x(A){h&&h((A-r.offset)/r.count)}function p(A,E,C){let I=A*2;v[A+6]=E,M[I+14]=C,M[I+15]=65535,x(E+C)}function S(A,E,C){let I=b++,D=I*8;_.set(Qo,D),!w&&C>=o&&(w=!0,a&&console.warn(`BVH: Max depth of ${o} reached when generating BVH. Consider increasing maxDepth.`));let L=E>c;if(E<=l&&!L||C>=o){p(D,A,E);return}let U=bx(Qo,kh,e,A,E,u),V=U.axis===-1?-1:Sx(f,m,e,A,E,U);if(U.axis===-1||V===A||V===A+E){if(!L){p(D,A,E);return}U.axis=Math.max(0,Ul(Qo)),V=A+Math.max(1,Math.floor(E/2))}v[D+7]=U.axis;let B=V-A;Uh(e,A,B,Qo,kh),S(A,B,C+1);let ne=b-I;if(ne>O1)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");v[D+6]=ne;let z=E-B;Uh(e,V,z,Qo,kh),S(V,z,C+1)}}function Mx(i,e){let t=i.getRootRanges(e.range),n=t[0],s=t[t.length-1],r={offset:n.offset,count:s.offset+s.count-n.offset},o=new Float32Array(6*r.count);o.offset=r.offset,i.computePrimitiveBounds(r.offset,r.count,o),i._roots=t.map(a=>N1(i,o,a.offset,a.count,e,r))}var sr=class{constructor(e){this._getNewPrimitive=e,this._primitives=[]}getPrimitive(){let e=this._primitives;return e.length===0?this._getNewPrimitive():e.pop()}releasePrimitive(e){this._primitives.push(e)}};var Up=class{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;let e=[],t=null;this.setBuffer=n=>{t&&e.push(t),t=n,this.float32Array=new Float32Array(n),this.uint16Array=new Uint16Array(n),this.uint32Array=new Uint32Array(n)},this.clearBuffer=()=>{t=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,e.length!==0&&this.setBuffer(e.pop())}}},ut=new Up;var rr,ta,ea=[],Bh=new sr(()=>new et);function wx(i,e,t,n,s,r){rr=Bh.getPrimitive(),ta=Bh.getPrimitive(),ea.push(rr,ta),ut.setBuffer(i._roots[e]);let o=Fp(0,i.geometry,t,n,s,r);ut.clearBuffer(),Bh.releasePrimitive(rr),Bh.releasePrimitive(ta),ea.pop(),ea.pop();let a=ea.length;return a>0&&(ta=ea[a-1],rr=ea[a-2]),o}function Fp(i,e,t,n,s=null,r=0,o=0){let{float32Array:a,uint16Array:l,uint32Array:c}=ut,u=i*2;if(_t(u,l)){let d=It(i,c),f=Ut(u,l);return Vt(i,a,rr),n(d,f,!1,o,r+i/8,rr)}else{let E=function(I){let{uint16Array:D,uint32Array:L}=ut,U=I*2;for(;!_t(U,D);)I=Et(I),U=I*2;return It(I,L)},C=function(I){let{uint16Array:D,uint32Array:L}=ut,U=I*2;for(;!_t(U,D);)I=Tt(I,L),U=I*2;return It(I,L)+Ut(U,D)},d=Et(i),f=Tt(i,c),m=d,y=f,g,_,v,M;if(s&&(v=rr,M=ta,Vt(m,a,v),Vt(y,a,M),g=s(v),_=s(M),_<g)){m=f,y=d;let I=g;g=_,_=I,v=M}v||(v=rr,Vt(m,a,v));let b=_t(m*2,l),w=t(v,b,g,o+1,r+m/8),x;if(w===2){let I=E(m),L=C(m)-I;x=n(I,L,!0,o+1,r+m/8,v)}else x=w&&Fp(m,e,t,n,s,r,o+1);if(x)return!0;M=ta,Vt(y,a,M);let p=_t(y*2,l),S=t(M,p,_,o+1,r+y/8),A;if(S===2){let I=E(y),L=C(y)-I;A=n(I,L,!0,o+1,r+y/8,M)}else A=S&&Fp(y,e,t,n,s,r,o+1);return!!A}}var Fl=new ut.constructor,zh=new ut.constructor,or=new sr(()=>new et),na=new et,ia=new et,Bp=new et,zp=new et,Vp=!1;function Ex(i,e,t,n){if(Vp)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");Vp=!0;let s=i._roots,r=e._roots,o,a=0,l=0,c=new Ce().copy(t).invert();for(let u=0,h=s.length;u<h;u++){Fl.setBuffer(s[u]),l=0;let d=or.getPrimitive();Vt(0,Fl.float32Array,d),d.applyMatrix4(c);for(let f=0,m=r.length;f<m&&(zh.setBuffer(r[f]),o=Di(0,0,t,c,n,a,l,0,0,d),zh.clearBuffer(),l+=r[f].byteLength/32,!o);f++);if(or.releasePrimitive(d),Fl.clearBuffer(),a+=s[u].byteLength/32,o)break}return Vp=!1,o}function Di(i,e,t,n,s,r=0,o=0,a=0,l=0,c=null,u=!1){let h,d;u?(h=zh,d=Fl):(h=Fl,d=zh);let f=h.float32Array,m=h.uint32Array,y=h.uint16Array,g=d.float32Array,_=d.uint32Array,v=d.uint16Array,M=i*2,b=e*2,w=_t(M,y),x=_t(b,v),p=!1;if(x&&w)u?p=s(It(e,_),Ut(e*2,v),It(i,m),Ut(i*2,y),l,o+e/8,a,r+i/8):p=s(It(i,m),Ut(i*2,y),It(e,_),Ut(e*2,v),a,r+i/8,l,o+e/8);else if(x){let S=or.getPrimitive();Vt(e,g,S),S.applyMatrix4(t);let A=Et(i),E=Tt(i,m);Vt(A,f,na),Vt(E,f,ia);let C=S.intersectsBox(na),I=S.intersectsBox(ia);p=C&&Di(e,A,n,t,s,o,r,l,a+1,S,!u)||I&&Di(e,E,n,t,s,o,r,l,a+1,S,!u),or.releasePrimitive(S)}else{let S=Et(e),A=Tt(e,_);Vt(S,g,Bp),Vt(A,g,zp);let E=c.intersectsBox(Bp),C=c.intersectsBox(zp);if(E&&C)p=Di(i,S,t,n,s,r,o,a,l+1,c,u)||Di(i,A,t,n,s,r,o,a,l+1,c,u);else if(E)if(w)p=Di(i,S,t,n,s,r,o,a,l+1,c,u);else{let I=or.getPrimitive();I.copy(Bp).applyMatrix4(t);let D=Et(i),L=Tt(i,m);Vt(D,f,na),Vt(L,f,ia);let U=I.intersectsBox(na),V=I.intersectsBox(ia);p=U&&Di(S,D,n,t,s,o,r,l,a+1,I,!u)||V&&Di(S,L,n,t,s,o,r,l,a+1,I,!u),or.releasePrimitive(I)}else if(C)if(w)p=Di(i,A,t,n,s,r,o,a,l+1,c,u);else{let I=or.getPrimitive();I.copy(zp).applyMatrix4(t);let D=Et(i),L=Tt(i,m);Vt(D,f,na),Vt(L,f,ia);let U=I.intersectsBox(na),V=I.intersectsBox(ia);p=U&&Di(A,D,n,t,s,o,r,l,a+1,I,!u)||V&&Di(A,L,n,t,s,o,r,l,a+1,I,!u),or.releasePrimitive(I)}}return p}var Vh=new class{constructor(){let i=null,e=null,t=null,n=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(r,o)=>{if(n)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=o,this.buffer=i=r._roots[o],this.uint16Array=t=new Uint16Array(i),this.uint32Array=e=new Uint32Array(i)},this.reset=()=>{this.root=null,this.buffer=i=null,this.uint16Array=t=null,this.uint32Array=e=null},this.getRangeStart=r=>{let o=r*2;for(;!_t(o,t);)r=Et(r),o=r*2;return It(r,e)},this.getRangeEnd=r=>{let o=r*2;for(;!_t(o,t);)r=Tt(r,e),o=r*2;return It(r,e)+Ut(o,t)};let s=(r,o,a)=>{let l=o*2,c=_t(l,t);if(!r(a,c,o)&&!c){let h=Et(o),d=Tt(o,e);s(r,h,a+1),s(r,d,a+1)}};this.traverseBuffer=r=>{if(n)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");n=!0;try{s(r,0,0)}finally{n=!1}},this.traverse=r=>{this.traverseBuffer((o,a,l)=>{if(a){let c=l*2,u=e[l+6],h=t[c+14];return r(o,a,new Float32Array(i,l*4,6),u,h)}else{let c=Jo(l,e);return r(o,a,new Float32Array(i,l*4,6),c)}})}}};var Tx=new et,sa=new Float32Array(6),Hh=class{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(e){e={...Nh,...e},"maxLeafSize"in e&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),e={...e,targetLeafSize:e.maxLeafSize}),Mx(this,e)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(e,t,n,s){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0;for(let h=e,d=e+t;h<d;h++){this.writePrimitiveBounds(h,sa,0);let[f,m,y,g,_,v]=sa;f<r&&(r=f),g>l&&(l=g),m<o&&(o=m),_>c&&(c=_),y<a&&(a=y),v>u&&(u=v)}return n[s+0]=r,n[s+1]=o,n[s+2]=a,n[s+3]=l,n[s+4]=c,n[s+5]=u,n}computePrimitiveBounds(e,t,n){let s=n.offset||0;for(let r=e,o=e+t;r<o;r++){this.writePrimitiveBounds(r,sa,0);let[a,l,c,u,h,d]=sa,f=(a+u)/2,m=(l+h)/2,y=(c+d)/2,g=(u-a)/2,_=(h-l)/2,v=(d-c)/2,M=(r-s)*6;n[M+0]=f,n[M+1]=g+(Math.abs(f)+g)*Zo,n[M+2]=m,n[M+3]=_+(Math.abs(m)+_)*Zo,n[M+4]=y,n[M+5]=v+(Math.abs(y)+v)*Zo}return n}shiftPrimitiveOffsets(e){let t=this._indirectBuffer;if(t)for(let n=0,s=t.length;n<s;n++)t[n]+=e;else{let n=this._roots;for(let s=0;s<n.length;s++){let r=n[s],o=new Uint32Array(r),a=new Uint16Array(r),l=r.byteLength/32;for(let c=0;c<l;c++){let u=8*c,h=2*u;_t(h,a)&&(o[u+6]+=e)}}}}traverse(e,t=0){Vh.setBVH(this,t),Vh.traverse(e),Vh.reset()}refit(){let e=this._roots;for(let t=0,n=e.length;t<n;t++){let s=e[t],r=new Uint32Array(s),o=new Uint16Array(s),a=new Float32Array(s),l=s.byteLength/32;for(let c=l-1;c>=0;c--){let u=c*8,h=u*2;if(_t(h,o)){let f=It(u,r),m=Ut(h,o);this.writePrimitiveRangeBounds(f,m,sa,0),a.set(sa,u)}else{let f=Et(u),m=Tt(u,r);for(let y=0;y<3;y++){let g=a[f+y],_=a[f+y+3],v=a[m+y],M=a[m+y+3];a[u+y]=g<v?g:v,a[u+y+3]=_>M?_:M}}}}}getBoundingBox(e){return e.makeEmpty(),this._roots.forEach(n=>{Vt(0,new Float32Array(n),Tx),e.union(Tx)}),e}shapecast(e){let{boundsTraverseOrder:t,intersectsBounds:n,intersectsRange:s,intersectsPrimitive:r,scratchPrimitive:o,iterate:a}=e;if(s&&r){let h=s;s=(d,f,m,y,g)=>h(d,f,m,y,g)?!0:a(d,f,this,r,m,y,o)}else s||(r?s=(h,d,f,m)=>a(h,d,this,r,f,m,o):s=(h,d,f)=>f);let l=!1,c=0,u=this._roots;for(let h=0,d=u.length;h<d;h++){let f=u[h];if(l=wx(this,h,n,s,t,c),l)break;c+=f.byteLength/32}return l}bvhcast(e,t,n){let{intersectsRanges:s}=n;return Ex(this,e,t,s)}};function Ax(){return typeof SharedArrayBuffer<"u"}function Hp(i){return i.index?i.index.count:i.attributes.position.count}function ar(i){return Hp(i)/3}function U1(i,e=ArrayBuffer){return i>65535?new Uint32Array(new e(4*i)):new Uint16Array(new e(2*i))}function Rx(i,e){if(!i.index){let t=i.attributes.position.count,n=e.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,s=U1(t,n);i.setIndex(new gt(s,1));for(let r=0;r<t;r++)s[r]=r}}function F1(i,e,t){let n=Hp(i)/t,s=e||i.drawRange,r=s.start/t,o=(s.start+s.count)/t,a=Math.max(0,r),l=Math.min(n,o)-a;return{offset:Math.floor(a),count:Math.floor(l)}}function k1(i,e){return i.groups.map(t=>({offset:t.start/e,count:t.count/e}))}function Gp(i,e,t){let n=F1(i,e,t),s=k1(i,t);if(!s.length)return[n];let r=[],o=n.offset,a=n.offset+n.count,l=Hp(i)/t,c=[];for(let d of s){let{offset:f,count:m}=d,y=f,g=isFinite(m)?m:l-f,_=f+g;y<a&&_>o&&(c.push({pos:Math.max(o,y),isStart:!0}),c.push({pos:Math.min(a,_),isStart:!1}))}c.sort((d,f)=>d.pos!==f.pos?d.pos-f.pos:d.type==="end"?-1:1);let u=0,h=null;for(let d of c){let f=d.pos;u!==0&&f!==h&&r.push({offset:h,count:f-h}),u+=d.isStart?1:-1,h=f}return r}function B1(i,e){let t=i[i.length-1],n=t.offset+t.count>2**16,s=i.reduce((c,u)=>c+u.count,0),r=n?4:2,o=e?new SharedArrayBuffer(s*r):new ArrayBuffer(s*r),a=n?new Uint32Array(o):new Uint16Array(o),l=0;for(let c=0;c<i.length;c++){let{offset:u,count:h}=i[c];for(let d=0;d<h;d++)a[l+d]=u+d;l+=h}return a}var Gh=class extends Hh{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(e){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(e){}constructor(e,t={}){if(e.isBufferGeometry){if(e.index&&e.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(t.useSharedArrayBuffer&&!Ax())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=e,this.resolvePrimitiveIndex=t.indirect?n=>this._indirectBuffer[n]:n=>n,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,t={...Nh,...t},t[Dl]||this.init(t)}init(e){let{geometry:t,primitiveStride:n}=this;if(e.indirect){let s=Gp(t,e.range,n),r=B1(s,e.useSharedArrayBuffer);this._indirectBuffer=r}else Rx(t,e);super.init(e),!t.boundingBox&&e.setBoundingBox&&(t.boundingBox=this.getBoundingBox(new et))}getRootRanges(e){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:Gp(this.geometry,e,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}};var hi=class{constructor(){this.min=1/0,this.max=-1/0}setFromPointsField(e,t){let n=1/0,s=-1/0;for(let r=0,o=e.length;r<o;r++){let l=e[r][t];n=l<n?l:n,s=l>s?l:s}this.min=n,this.max=s}setFromPoints(e,t){let n=1/0,s=-1/0;for(let r=0,o=t.length;r<o;r++){let a=t[r],l=e.dot(a);n=l<n?l:n,s=l>s?l:s}this.min=n,this.max=s}isSeparated(e){return this.min>e.max||e.min>this.max}};hi.prototype.setFromBox=(function(){let i=new P;return function(t,n){let s=n.min,r=n.max,o=1/0,a=-1/0;for(let l=0;l<=1;l++)for(let c=0;c<=1;c++)for(let u=0;u<=1;u++){i.x=s.x*l+r.x*(1-l),i.y=s.y*c+r.y*(1-c),i.z=s.z*u+r.z*(1-u);let h=t.dot(i);o=Math.min(h,o),a=Math.max(h,a)}this.min=o,this.max=a}})();var z1=(function(){let i=new P,e=new P,t=new P;return function(s,r,o){let a=s.start,l=i,c=r.start,u=e;t.subVectors(a,c),i.subVectors(s.end,s.start),e.subVectors(r.end,r.start);let h=t.dot(u),d=u.dot(l),f=u.dot(u),m=t.dot(l),g=l.dot(l)*f-d*d,_,v;g!==0?_=(h*d-m*f)/g:_=0,v=(h+_*d)/f,o.x=_,o.y=v}})(),kl=(function(){let i=new Fe,e=new P,t=new P;return function(s,r,o,a){z1(s,r,i);let l=i.x,c=i.y;if(l>=0&&l<=1&&c>=0&&c<=1){s.at(l,o),r.at(c,a);return}else if(l>=0&&l<=1){c<0?r.at(0,a):r.at(1,a),s.closestPointToPoint(a,!0,o);return}else if(c>=0&&c<=1){l<0?s.at(0,o):s.at(1,o),r.closestPointToPoint(o,!0,a);return}else{let u;l<0?u=s.start:u=s.end;let h;c<0?h=r.start:h=r.end;let d=e,f=t;if(s.closestPointToPoint(h,!0,e),r.closestPointToPoint(u,!0,t),d.distanceToSquared(h)<=f.distanceToSquared(u)){o.copy(d),a.copy(h);return}else{o.copy(u),a.copy(f);return}}}})(),Cx=(function(){let i=new P,e=new P,t=new qn,n=new wn;return function(r,o){let{radius:a,center:l}=r,{a:c,b:u,c:h}=o;if(n.start=c,n.end=u,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a||(n.start=c,n.end=h,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a)||(n.start=u,n.end=h,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a))return!0;let y=o.getPlane(t);if(Math.abs(y.distanceToPoint(l))<=a){let _=y.projectPoint(l,e);if(o.containsPoint(_))return!0}return!1}})();var V1=["x","y","z"],Bs=1e-15,Px=Bs*Bs;function bi(i){return Math.abs(i)<Bs}var Cn=class extends Bn{constructor(...e){super(...e),this.isExtendedTriangle=!0,this.satAxes=new Array(4).fill().map(()=>new P),this.satBounds=new Array(4).fill().map(()=>new hi),this.points=[this.a,this.b,this.c],this.plane=new qn,this.isDegenerateIntoSegment=!1,this.isDegenerateIntoPoint=!1,this.degenerateSegment=new wn,this.needsUpdate=!0}intersectsSphere(e){return Cx(e,this)}update(){let e=this.a,t=this.b,n=this.c,s=this.points,r=this.satAxes,o=this.satBounds,a=r[0],l=o[0];this.getNormal(a),l.setFromPoints(a,s);let c=r[1],u=o[1];c.subVectors(e,t),u.setFromPoints(c,s);let h=r[2],d=o[2];h.subVectors(t,n),d.setFromPoints(h,s);let f=r[3],m=o[3];f.subVectors(n,e),m.setFromPoints(f,s);let y=c.length(),g=h.length(),_=f.length();this.isDegenerateIntoPoint=!1,this.isDegenerateIntoSegment=!1,y<Bs?g<Bs||_<Bs?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(e),this.degenerateSegment.end.copy(n)):g<Bs?_<Bs?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(t),this.degenerateSegment.end.copy(e)):_<Bs&&(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(n),this.degenerateSegment.end.copy(t)),this.plane.setFromNormalAndCoplanarPoint(a,e),this.needsUpdate=!1}};Cn.prototype.closestPointToSegment=(function(){let i=new P,e=new P,t=new wn;return function(s,r=null,o=null){this.needsUpdate&&this.update();let{start:a,end:l}=s,c=this.points,u,h=1/0,d=this.plane.distanceToPoint(a),f=this.plane.distanceToPoint(l);if(d*f<0&&this.plane.intersectLine(s,i)!==null&&this.containsPoint(i))return r&&r.copy(i),o&&o.copy(i),0;for(let m=0;m<3;m++){let y=(m+1)%3;t.start.copy(c[m]),t.end.copy(c[y]),kl(t,s,i,e),u=i.distanceToSquared(e),u<h&&(h=u,r&&r.copy(i),o&&o.copy(e))}return this.closestPointToPoint(a,i),u=a.distanceToSquared(i),u<h&&(h=u,r&&r.copy(i),o&&o.copy(a)),this.closestPointToPoint(l,i),u=l.distanceToSquared(i),u<h&&(h=u,r&&r.copy(i),o&&o.copy(l)),Math.sqrt(h)}})();Cn.prototype.intersectsTriangle=(function(){let i=new Cn,e=new hi,t=new hi,n=new P,s=new P,r=new P,o=new P,a=new wn,l=new wn,c=new P,u=new Fe,h=new Fe;function d(M,b,w,x){let p=n;!M.isDegenerateIntoPoint&&!M.isDegenerateIntoSegment?p.copy(M.plane.normal):p.copy(b.plane.normal);let S=M.satBounds,A=M.satAxes;for(let I=1;I<4;I++){let D=S[I],L=A[I];if(e.setFromPoints(L,b.points),D.isSeparated(e)||(o.copy(p).cross(L),e.setFromPoints(o,M.points),t.setFromPoints(o,b.points),e.isSeparated(t)))return!1}let E=b.satBounds,C=b.satAxes;for(let I=1;I<4;I++){let D=E[I],L=C[I];if(e.setFromPoints(L,M.points),D.isSeparated(e)||(o.crossVectors(p,L),e.setFromPoints(o,M.points),t.setFromPoints(o,b.points),e.isSeparated(t)))return!1}return w&&(x||console.warn("ExtendedTriangle.intersectsTriangle: Triangles are coplanar which does not support an output edge. Setting edge to 0, 0, 0."),w.start.set(0,0,0),w.end.set(0,0,0)),!0}function f(M,b,w,x,p,S,A,E,C,I,D){let L=A/(A-E);I.x=x+(p-x)*L,D.start.subVectors(b,M).multiplyScalar(L).add(M),L=A/(A-C),I.y=x+(S-x)*L,D.end.subVectors(w,M).multiplyScalar(L).add(M)}function m(M,b,w,x,p,S,A,E,C,I,D){if(p>0)f(M.c,M.a,M.b,x,b,w,C,A,E,I,D);else if(S>0)f(M.b,M.a,M.c,w,b,x,E,A,C,I,D);else if(E*C>0||A!=0)f(M.a,M.b,M.c,b,w,x,A,E,C,I,D);else if(E!=0)f(M.b,M.a,M.c,w,b,x,E,A,C,I,D);else if(C!=0)f(M.c,M.a,M.b,x,b,w,C,A,E,I,D);else return!0;return!1}function y(M,b,w,x){let p=b.degenerateSegment,S=M.plane.distanceToPoint(p.start),A=M.plane.distanceToPoint(p.end);return bi(S)?bi(A)?d(M,b,w,x):(w&&(w.start.copy(p.start),w.end.copy(p.start)),M.containsPoint(p.start)):bi(A)?(w&&(w.start.copy(p.end),w.end.copy(p.end)),M.containsPoint(p.end)):M.plane.intersectLine(p,n)!=null?(w&&(w.start.copy(n),w.end.copy(n)),M.containsPoint(n)):!1}function g(M,b,w){let x=b.a;return bi(M.plane.distanceToPoint(x))&&M.containsPoint(x)?(w&&(w.start.copy(x),w.end.copy(x)),!0):!1}function _(M,b,w){let x=M.degenerateSegment,p=b.a;return x.closestPointToPoint(p,!0,n),p.distanceToSquared(n)<Px?(w&&(w.start.copy(p),w.end.copy(p)),!0):!1}function v(M,b,w,x){if(M.isDegenerateIntoSegment)if(b.isDegenerateIntoSegment){let p=M.degenerateSegment,S=b.degenerateSegment,A=s,E=r;p.delta(A),S.delta(E);let C=n.subVectors(S.start,p.start),I=A.x*E.y-A.y*E.x;if(bi(I))return!1;let D=(C.x*E.y-C.y*E.x)/I,L=-(A.x*C.y-A.y*C.x)/I;if(D<0||D>1||L<0||L>1)return!1;let U=p.start.z+A.z*D,V=S.start.z+E.z*L;return bi(U-V)?(w&&(w.start.copy(p.start).addScaledVector(A,D),w.end.copy(p.start).addScaledVector(A,D)),!0):!1}else return b.isDegenerateIntoPoint?_(M,b,w):y(b,M,w,x);else{if(M.isDegenerateIntoPoint)return b.isDegenerateIntoPoint?b.a.distanceToSquared(M.a)<Px?(w&&(w.start.copy(M.a),w.end.copy(M.a)),!0):!1:b.isDegenerateIntoSegment?_(b,M,w):g(b,M,w);if(b.isDegenerateIntoPoint)return g(M,b,w);if(b.isDegenerateIntoSegment)return y(M,b,w,x)}}return function(b,w=null,x=!1){this.needsUpdate&&this.update(),b.isExtendedTriangle?b.needsUpdate&&b.update():(i.copy(b),i.update(),b=i);let p=v(this,b,w,x);if(p!==void 0)return p;let S=this.plane,A=b.plane,E=A.distanceToPoint(this.a),C=A.distanceToPoint(this.b),I=A.distanceToPoint(this.c);bi(E)&&(E=0),bi(C)&&(C=0),bi(I)&&(I=0);let D=E*C,L=E*I;if(D>0&&L>0)return!1;let U=S.distanceToPoint(b.a),V=S.distanceToPoint(b.b),B=S.distanceToPoint(b.c);bi(U)&&(U=0),bi(V)&&(V=0),bi(B)&&(B=0);let ne=U*V,z=U*B;if(ne>0&&z>0)return!1;s.copy(S.normal),r.copy(A.normal);let q=s.cross(r),W=0,_e=Math.abs(q.x),Te=Math.abs(q.y);Te>_e&&(_e=Te,W=1),Math.abs(q.z)>_e&&(W=2);let ae=V1[W],se=this.a[ae],ce=this.b[ae],re=this.c[ae],de=b.a[ae],Ye=b.b[ae],Ae=b.c[ae];if(m(this,se,ce,re,D,L,E,C,I,u,a))return d(this,b,w,x);if(m(b,de,Ye,Ae,ne,z,U,V,B,h,l))return d(this,b,w,x);if(u.y<u.x){let Be=u.y;u.y=u.x,u.x=Be,c.copy(a.start),a.start.copy(a.end),a.end.copy(c)}if(h.y<h.x){let Be=h.y;h.y=h.x,h.x=Be,c.copy(l.start),l.start.copy(l.end),l.end.copy(c)}return u.y<h.x||h.y<u.x?!1:(w&&(h.x>u.x?w.start.copy(l.start):w.start.copy(a.start),h.y<u.y?w.end.copy(l.end):w.end.copy(a.end)),!0)}})();Cn.prototype.distanceToPoint=(function(){let i=new P;return function(t){return this.closestPointToPoint(t,i),t.distanceTo(i)}})();Cn.prototype.distanceToTriangle=(function(){let i=new P,e=new P,t=["a","b","c"],n=new wn,s=new wn;return function(o,a=null,l=null){let c=a||l?n:null;if(this.intersectsTriangle(o,c,!0))return(a||l)&&(a&&c.getCenter(a),l&&c.getCenter(l)),0;let u=1/0;for(let h=0;h<3;h++){let d,f=t[h],m=o[f];this.closestPointToPoint(m,i),d=m.distanceToSquared(i),d<u&&(u=d,a&&a.copy(i),l&&l.copy(m));let y=this[f];o.closestPointToPoint(y,i),d=y.distanceToSquared(i),d<u&&(u=d,a&&a.copy(y),l&&l.copy(i))}for(let h=0;h<3;h++){let d=t[h],f=t[(h+1)%3];n.set(this[d],this[f]);for(let m=0;m<3;m++){let y=t[m],g=t[(m+1)%3];s.set(o[y],o[g]),kl(n,s,i,e);let _=i.distanceToSquared(e);_<u&&(u=_,a&&a.copy(i),l&&l.copy(e))}}return Math.sqrt(u)}})();var en=class{constructor(e,t,n){this.isOrientedBox=!0,this.min=new P,this.max=new P,this.matrix=new Ce,this.invMatrix=new Ce,this.points=new Array(8).fill().map(()=>new P),this.satAxes=new Array(3).fill().map(()=>new P),this.satBounds=new Array(3).fill().map(()=>new hi),this.alignedSatBounds=new Array(3).fill().map(()=>new hi),this.needsUpdate=!1,e&&this.min.copy(e),t&&this.max.copy(t),n&&this.matrix.copy(n)}set(e,t,n){this.min.copy(e),this.max.copy(t),this.matrix.copy(n),this.needsUpdate=!0}copy(e){this.min.copy(e.min),this.max.copy(e.max),this.matrix.copy(e.matrix),this.needsUpdate=!0}};en.prototype.update=(function(){return function(){let e=this.matrix,t=this.min,n=this.max,s=this.points;for(let c=0;c<=1;c++)for(let u=0;u<=1;u++)for(let h=0;h<=1;h++){let d=1*c|2*u|4*h,f=s[d];f.x=c?n.x:t.x,f.y=u?n.y:t.y,f.z=h?n.z:t.z,f.applyMatrix4(e)}let r=this.satBounds,o=this.satAxes,a=s[0];for(let c=0;c<3;c++){let u=o[c],h=r[c],d=1<<c,f=s[d];u.subVectors(a,f),h.setFromPoints(u,s)}let l=this.alignedSatBounds;l[0].setFromPointsField(s,"x"),l[1].setFromPointsField(s,"y"),l[2].setFromPointsField(s,"z"),this.invMatrix.copy(this.matrix).invert(),this.needsUpdate=!1}})();en.prototype.intersectsBox=(function(){let i=new hi;return function(t){this.needsUpdate&&this.update();let n=t.min,s=t.max,r=this.satBounds,o=this.satAxes,a=this.alignedSatBounds;if(i.min=n.x,i.max=s.x,a[0].isSeparated(i)||(i.min=n.y,i.max=s.y,a[1].isSeparated(i))||(i.min=n.z,i.max=s.z,a[2].isSeparated(i)))return!1;for(let l=0;l<3;l++){let c=o[l],u=r[l];if(i.setFromBox(c,t),u.isSeparated(i))return!1}return!0}})();en.prototype.intersectsTriangle=(function(){let i=new Cn,e=new Array(3),t=new hi,n=new hi,s=new P;return function(o){this.needsUpdate&&this.update(),o.isExtendedTriangle?o.needsUpdate&&o.update():(i.copy(o),i.update(),o=i);let a=this.satBounds,l=this.satAxes;e[0]=o.a,e[1]=o.b,e[2]=o.c;for(let d=0;d<3;d++){let f=a[d],m=l[d];if(t.setFromPoints(m,e),f.isSeparated(t))return!1}let c=o.satBounds,u=o.satAxes,h=this.points;for(let d=0;d<3;d++){let f=c[d],m=u[d];if(t.setFromPoints(m,h),f.isSeparated(t))return!1}for(let d=0;d<3;d++){let f=l[d];for(let m=0;m<4;m++){let y=u[m];if(s.crossVectors(f,y),t.setFromPoints(s,e),n.setFromPoints(s,h),t.isSeparated(n))return!1}}return!0}})();en.prototype.closestPointToPoint=(function(){return function(e,t){return this.needsUpdate&&this.update(),t.copy(e).applyMatrix4(this.invMatrix).clamp(this.min,this.max).applyMatrix4(this.matrix),t}})();en.prototype.distanceToPoint=(function(){let i=new P;return function(t){return this.closestPointToPoint(t,i),t.distanceTo(i)}})();en.prototype.distanceToBox=(function(){let i=["x","y","z"],e=new Array(12).fill().map(()=>new wn),t=new Array(12).fill().map(()=>new wn),n=new P,s=new P;return function(o,a=0,l=null,c=null){if(this.needsUpdate&&this.update(),this.intersectsBox(o))return(l||c)&&(o.getCenter(s),this.closestPointToPoint(s,n),o.closestPointToPoint(n,s),l&&l.copy(n),c&&c.copy(s)),0;let u=a*a,h=o.min,d=o.max,f=this.points,m=1/0;for(let g=0;g<8;g++){let _=f[g];s.copy(_).clamp(h,d);let v=_.distanceToSquared(s);if(v<m&&(m=v,l&&l.copy(_),c&&c.copy(s),v<u))return Math.sqrt(v)}let y=0;for(let g=0;g<3;g++)for(let _=0;_<=1;_++)for(let v=0;v<=1;v++){let M=(g+1)%3,b=(g+2)%3,w=_<<M|v<<b,x=1<<g|_<<M|v<<b,p=f[w],S=f[x];e[y].set(p,S);let E=i[g],C=i[M],I=i[b],D=t[y],L=D.start,U=D.end;L[E]=h[E],L[C]=_?h[C]:d[C],L[I]=v?h[I]:d[I],U[E]=d[E],U[C]=_?h[C]:d[C],U[I]=v?h[I]:d[I],y++}for(let g=0;g<=1;g++)for(let _=0;_<=1;_++)for(let v=0;v<=1;v++){s.x=g?d.x:h.x,s.y=_?d.y:h.y,s.z=v?d.z:h.z,this.closestPointToPoint(s,n);let M=s.distanceToSquared(n);if(M<m&&(m=M,l&&l.copy(n),c&&c.copy(s),M<u))return Math.sqrt(M)}for(let g=0;g<12;g++){let _=e[g];for(let v=0;v<12;v++){let M=t[v];kl(_,M,n,s);let b=n.distanceToSquared(s);if(b<m&&(m=b,l&&l.copy(n),c&&c.copy(s),b<u))return Math.sqrt(b)}}return Math.sqrt(m)}})();var Wp=class extends sr{constructor(){super(()=>new Cn)}},Qn=new Wp;var Bl=new P,Xp=new P;function Ix(i,e,t={},n=0,s=1/0){let r=n*n,o=s*s,a=1/0,l=null;if(i.shapecast({boundsTraverseOrder:u=>(Bl.copy(e).clamp(u.min,u.max),Bl.distanceToSquared(e)),intersectsBounds:(u,h,d)=>d<a&&d<o,intersectsTriangle:(u,h)=>{u.closestPointToPoint(e,Bl);let d=e.distanceToSquared(Bl);return d<a&&(Xp.copy(Bl),a=d,l=h),d<r}}),a===1/0)return null;let c=Math.sqrt(a);return t.point?t.point.copy(Xp):t.point=Xp.clone(),t.distance=c,t.faceIndex=l,t}var Wh=parseInt("187")>=169,H1=parseInt("187")<=161,Wr=new P,Xr=new P,qr=new P,Xh=new Fe,qh=new Fe,Yh=new Fe,Lx=new P,Ox=new P,Nx=new P,zl=new P;function G1(i,e,t,n,s,r,o,a){let l;if(r===En?l=i.intersectTriangle(n,t,e,!0,s):l=i.intersectTriangle(e,t,n,r!==an,s),l===null)return null;let c=i.origin.distanceTo(s);return c<o||c>a?null:{distance:c,point:s.clone()}}function Dx(i,e,t,n,s,r,o,a,l,c,u){Wr.fromBufferAttribute(e,r),Xr.fromBufferAttribute(e,o),qr.fromBufferAttribute(e,a);let h=G1(i,Wr,Xr,qr,zl,l,c,u);if(h){if(n){Xh.fromBufferAttribute(n,r),qh.fromBufferAttribute(n,o),Yh.fromBufferAttribute(n,a),h.uv=new Fe;let f=Bn.getInterpolation(zl,Wr,Xr,qr,Xh,qh,Yh,h.uv);Wh||(h.uv=f)}if(s){Xh.fromBufferAttribute(s,r),qh.fromBufferAttribute(s,o),Yh.fromBufferAttribute(s,a),h.uv1=new Fe;let f=Bn.getInterpolation(zl,Wr,Xr,qr,Xh,qh,Yh,h.uv1);Wh||(h.uv1=f),H1&&(h.uv2=h.uv1)}if(t){Lx.fromBufferAttribute(t,r),Ox.fromBufferAttribute(t,o),Nx.fromBufferAttribute(t,a),h.normal=new P;let f=Bn.getInterpolation(zl,Wr,Xr,qr,Lx,Ox,Nx,h.normal);h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1),Wh||(h.normal=f)}let d={a:r,b:o,c:a,normal:new P,materialIndex:0};if(Bn.getNormal(Wr,Xr,qr,d.normal),h.face=d,h.faceIndex=r,Wh){let f=new P;Bn.getBarycoord(zl,Wr,Xr,qr,f),h.barycoord=f}}return h}function Ux(i){return i&&i.isMaterial?i.side:i}function ra(i,e,t,n,s,r,o){let a=n*3,l=a+0,c=a+1,u=a+2,{index:h,groups:d}=i;i.index&&(l=h.getX(l),c=h.getX(c),u=h.getX(u));let{position:f,normal:m,uv:y,uv1:g}=i.attributes;if(Array.isArray(e)){let _=n*3;for(let v=0,M=d.length;v<M;v++){let{start:b,count:w,materialIndex:x}=d[v];if(_>=b&&_<b+w){let p=Ux(e[x]),S=Dx(t,f,m,y,g,l,c,u,p,r,o);if(S)if(S.faceIndex=n,S.face.materialIndex=x,s)s.push(S);else return S}}}else{let _=Ux(e),v=Dx(t,f,m,y,g,l,c,u,_,r,o);if(v)if(v.faceIndex=n,v.face.materialIndex=0,s)s.push(v);else return v}return null}function Ht(i,e,t,n){let s=i.a,r=i.b,o=i.c,a=e,l=e+1,c=e+2;t&&(a=t.getX(a),l=t.getX(l),c=t.getX(c)),s.x=n.getX(a),s.y=n.getY(a),s.z=n.getZ(a),r.x=n.getX(l),r.y=n.getY(l),r.z=n.getZ(l),o.x=n.getX(c),o.y=n.getY(c),o.z=n.getZ(c)}function Fx(i,e,t,n,s,r,o,a){let{geometry:l,_indirectBuffer:c}=i;for(let u=n,h=n+s;u<h;u++)ra(l,e,t,u,r,o,a)}function kx(i,e,t,n,s,r,o){let{geometry:a,_indirectBuffer:l}=i,c=1/0,u=null;for(let h=n,d=n+s;h<d;h++){let f;f=ra(a,e,t,h,null,r,o),f&&f.distance<c&&(u=f,c=f.distance)}return u}function Bx(i,e,t,n,s,r,o){let{geometry:a}=t,{index:l}=a,c=a.attributes.position;for(let u=i,h=e+i;u<h;u++){let d;if(d=u,Ht(o,d*3,l,c),o.needsUpdate=!0,n(o,d,s,r))return!0}return!1}function zx(i,e=null){e&&Array.isArray(e)&&(e=new Set(e));let t=i.geometry,n=t.index?t.index.array:null,s=t.attributes.position,r,o,a,l,c=0,u=i._roots;for(let d=0,f=u.length;d<f;d++)r=u[d],o=new Uint32Array(r),a=new Uint16Array(r),l=new Float32Array(r),h(0,c),c+=r.byteLength;function h(d,f,m=!1){let y=d*2;if(_t(y,a)){let g=It(d,o),_=Ut(y,a),v=1/0,M=1/0,b=1/0,w=-1/0,x=-1/0,p=-1/0;for(let S=3*g,A=3*(g+_);S<A;S++){let E=n[S],C=s.getX(E),I=s.getY(E),D=s.getZ(E);C<v&&(v=C),C>w&&(w=C),I<M&&(M=I),I>x&&(x=I),D<b&&(b=D),D>p&&(p=D)}return l[d+0]!==v||l[d+1]!==M||l[d+2]!==b||l[d+3]!==w||l[d+4]!==x||l[d+5]!==p?(l[d+0]=v,l[d+1]=M,l[d+2]=b,l[d+3]=w,l[d+4]=x,l[d+5]=p,!0):!1}else{let g=Et(d),_=Tt(d,o),v=m,M=!1,b=!1;if(e){if(!v){let E=g/8+f/32,C=_/8+f/32;M=e.has(E),b=e.has(C),v=!M&&!b}}else M=!0,b=!0;let w=v||M,x=v||b,p=!1;w&&(p=h(g,f,v));let S=!1;x&&(S=h(_,f,v));let A=p||S;if(A)for(let E=0;E<3;E++){let C=g+E,I=_+E,D=l[C],L=l[C+3],U=l[I],V=l[I+3];l[d+E]=D<U?D:U,l[d+E+3]=L>V?L:V}return A}}}function Hn(i,e,t,n,s){let r,o,a,l,c,u,h=1/t.direction.x,d=1/t.direction.y,f=1/t.direction.z,m=t.origin.x,y=t.origin.y,g=t.origin.z,_=e[i],v=e[i+3],M=e[i+1],b=e[i+3+1],w=e[i+2],x=e[i+3+2];return h>=0?(r=(_-m)*h,o=(v-m)*h):(r=(v-m)*h,o=(_-m)*h),d>=0?(a=(M-y)*d,l=(b-y)*d):(a=(b-y)*d,l=(M-y)*d),r>l||a>o||((a>r||isNaN(r))&&(r=a),(l<o||isNaN(o))&&(o=l),f>=0?(c=(w-g)*f,u=(x-g)*f):(c=(x-g)*f,u=(w-g)*f),r>u||c>o)?!1:((c>r||r!==r)&&(r=c),(u<o||o!==o)&&(o=u),r<=s&&o>=n)}function Vx(i,e,t,n,s,r,o,a){let{geometry:l,_indirectBuffer:c}=i;for(let u=n,h=n+s;u<h;u++){let d=c?c[u]:u;ra(l,e,t,d,r,o,a)}}function Hx(i,e,t,n,s,r,o){let{geometry:a,_indirectBuffer:l}=i,c=1/0,u=null;for(let h=n,d=n+s;h<d;h++){let f;f=ra(a,e,t,l?l[h]:h,null,r,o),f&&f.distance<c&&(u=f,c=f.distance)}return u}function Gx(i,e,t,n,s,r,o){let{geometry:a}=t,{index:l}=a,c=a.attributes.position;for(let u=i,h=e+i;u<h;u++){let d;if(d=t.resolveTriangleIndex(u),Ht(o,d*3,l,c),o.needsUpdate=!0,n(o,d,s,r))return!0}return!1}function Wx(i,e,t,n,s,r,o){ut.setBuffer(i._roots[e]),Hn(0,ut.float32Array,n,r,o)&&qp(0,i,t,n,s,r,o),ut.clearBuffer()}function qp(i,e,t,n,s,r,o){let{float32Array:a,uint16Array:l,uint32Array:c}=ut,u=i*2;if(_t(u,l)){let d=It(i,c),f=Ut(u,l);Fx(e,t,n,d,f,s,r,o)}else{let d=Et(i);Hn(d,a,n,r,o)&&qp(d,e,t,n,s,r,o);let f=Tt(i,c);Hn(f,a,n,r,o)&&qp(f,e,t,n,s,r,o)}}var W1=["x","y","z"];function Xx(i,e,t,n,s,r){ut.setBuffer(i._roots[e]);let o=null;return Hn(0,ut.float32Array,n,s,r)&&(o=Yp(0,i,t,n,s,r)),ut.clearBuffer(),o}function Yp(i,e,t,n,s,r){let{float32Array:o,uint16Array:a,uint32Array:l}=ut,c=i*2;if(_t(c,a)){let h=It(i,l),d=Ut(c,a);return kx(e,t,n,h,d,s,r)}else{let h=Jo(i,l),d=W1[h],m=n.direction[d]>=0,y,g;m?(y=Et(i),g=Tt(i,l)):(y=Tt(i,l),g=Et(i));let v=Hn(y,o,n,s,r)?Yp(y,e,t,n,s,r):null;if(v){let w=v.point[d];if(m?w<=o[g+h]:w>=o[g+h+3])return v}let b=Hn(g,o,n,s,r)?Yp(g,e,t,n,s,r):null;return v&&b?v.distance<=b.distance?v:b:v||b||null}}var $h=new et,oa=new Cn,aa=new Cn,Vl=new Ce,qx=new en,Kh=new en;function Yx(i,e,t,n){ut.setBuffer(i._roots[e]);let s=$p(0,i,t,n);return ut.clearBuffer(),s}function $p(i,e,t,n,s=null){let{float32Array:r,uint16Array:o,uint32Array:a}=ut,l=i*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),qx.set(t.boundingBox.min,t.boundingBox.max,n),s=qx),_t(l,o)){let u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,m=t.attributes.position,y=It(i,a),g=Ut(l,o);if(Vl.copy(n).invert(),t.boundsTree)return Vt(i,r,Kh),Kh.matrix.copy(Vl),Kh.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>Kh.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(n),v.b.applyMatrix4(n),v.c.applyMatrix4(n),v.needsUpdate=!0;for(let M=y*3,b=(g+y)*3;M<b;M+=3)if(Ht(aa,M,h,d),aa.needsUpdate=!0,v.intersectsTriangle(aa))return!0;return!1}});{let _=ar(t);for(let v=y*3,M=(g+y)*3;v<M;v+=3){Ht(oa,v,h,d),oa.a.applyMatrix4(Vl),oa.b.applyMatrix4(Vl),oa.c.applyMatrix4(Vl),oa.needsUpdate=!0;for(let b=0,w=_*3;b<w;b+=3)if(Ht(aa,b,f,m),aa.needsUpdate=!0,oa.intersectsTriangle(aa))return!0}}}else{let u=Et(i),h=Tt(i,a);return Vt(u,r,$h),!!(s.intersectsBox($h)&&$p(u,e,t,n,s)||(Vt(h,r,$h),s.intersectsBox($h)&&$p(h,e,t,n,s)))}}var Zh=new Ce,Kp=new en,Hl=new en,X1=new P,q1=new P,Y1=new P,$1=new P;function $x(i,e,t,n={},s={},r=0,o=1/0){e.boundingBox||e.computeBoundingBox(),Kp.set(e.boundingBox.min,e.boundingBox.max,t),Kp.needsUpdate=!0;let a=i.geometry,l=a.attributes.position,c=a.index,u=e.attributes.position,h=e.index,d=Qn.getPrimitive(),f=Qn.getPrimitive(),m=X1,y=q1,g=null,_=null;s&&(g=Y1,_=$1);let v=1/0,M=null,b=null;return Zh.copy(t).invert(),Hl.matrix.copy(Zh),i.shapecast({boundsTraverseOrder:w=>Kp.distanceToBox(w),intersectsBounds:(w,x,p)=>p<v&&p<o?(x&&(Hl.min.copy(w.min),Hl.max.copy(w.max),Hl.needsUpdate=!0),!0):!1,intersectsRange:(w,x)=>{if(e.boundsTree)return e.boundsTree.shapecast({boundsTraverseOrder:S=>Hl.distanceToBox(S),intersectsBounds:(S,A,E)=>E<v&&E<o,intersectsRange:(S,A)=>{for(let E=S,C=S+A;E<C;E++){Ht(f,3*E,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let I=w,D=w+x;I<D;I++){Ht(d,3*I,c,l),d.needsUpdate=!0;let L=d.distanceToTriangle(f,m,g);if(L<v&&(y.copy(m),_&&_.copy(g),v=L,M=I,b=E),L<r)return!0}}}});{let p=ar(e);for(let S=0,A=p;S<A;S++){Ht(f,3*S,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let E=w,C=w+x;E<C;E++){Ht(d,3*E,c,l),d.needsUpdate=!0;let I=d.distanceToTriangle(f,m,g);if(I<v&&(y.copy(m),_&&_.copy(g),v=I,M=E,b=S),I<r)return!0}}}}}),Qn.releasePrimitive(d),Qn.releasePrimitive(f),v===1/0?null:(n.point?n.point.copy(y):n.point=y.clone(),n.distance=v,n.faceIndex=M,s&&(s.point?s.point.copy(_):s.point=_.clone(),s.point.applyMatrix4(Zh),y.applyMatrix4(Zh),s.distance=y.sub(s.point).length(),s.faceIndex=b),n)}function Kx(i,e=null){e&&Array.isArray(e)&&(e=new Set(e));let t=i.geometry,n=t.index?t.index.array:null,s=t.attributes.position,r,o,a,l,c=0,u=i._roots;for(let d=0,f=u.length;d<f;d++)r=u[d],o=new Uint32Array(r),a=new Uint16Array(r),l=new Float32Array(r),h(0,c),c+=r.byteLength;function h(d,f,m=!1){let y=d*2;if(_t(y,a)){let g=It(d,o),_=Ut(y,a),v=1/0,M=1/0,b=1/0,w=-1/0,x=-1/0,p=-1/0;for(let S=g,A=g+_;S<A;S++){let E=3*i.resolveTriangleIndex(S);for(let C=0;C<3;C++){let I=E+C;I=n?n[I]:I;let D=s.getX(I),L=s.getY(I),U=s.getZ(I);D<v&&(v=D),D>w&&(w=D),L<M&&(M=L),L>x&&(x=L),U<b&&(b=U),U>p&&(p=U)}}return l[d+0]!==v||l[d+1]!==M||l[d+2]!==b||l[d+3]!==w||l[d+4]!==x||l[d+5]!==p?(l[d+0]=v,l[d+1]=M,l[d+2]=b,l[d+3]=w,l[d+4]=x,l[d+5]=p,!0):!1}else{let g=Et(d),_=Tt(d,o),v=m,M=!1,b=!1;if(e){if(!v){let E=g/8+f/32,C=_/8+f/32;M=e.has(E),b=e.has(C),v=!M&&!b}}else M=!0,b=!0;let w=v||M,x=v||b,p=!1;w&&(p=h(g,f,v));let S=!1;x&&(S=h(_,f,v));let A=p||S;if(A)for(let E=0;E<3;E++){let C=g+E,I=_+E,D=l[C],L=l[C+3],U=l[I],V=l[I+3];l[d+E]=D<U?D:U,l[d+E+3]=L>V?L:V}return A}}}function Zx(i,e,t,n,s,r,o){ut.setBuffer(i._roots[e]),Hn(0,ut.float32Array,n,r,o)&&Zp(0,i,t,n,s,r,o),ut.clearBuffer()}function Zp(i,e,t,n,s,r,o){let{float32Array:a,uint16Array:l,uint32Array:c}=ut,u=i*2;if(_t(u,l)){let d=It(i,c),f=Ut(u,l);Vx(e,t,n,d,f,s,r,o)}else{let d=Et(i);Hn(d,a,n,r,o)&&Zp(d,e,t,n,s,r,o);let f=Tt(i,c);Hn(f,a,n,r,o)&&Zp(f,e,t,n,s,r,o)}}var K1=["x","y","z"];function Jx(i,e,t,n,s,r){ut.setBuffer(i._roots[e]);let o=null;return Hn(0,ut.float32Array,n,s,r)&&(o=Jp(0,i,t,n,s,r)),ut.clearBuffer(),o}function Jp(i,e,t,n,s,r){let{float32Array:o,uint16Array:a,uint32Array:l}=ut,c=i*2;if(_t(c,a)){let h=It(i,l),d=Ut(c,a);return Hx(e,t,n,h,d,s,r)}else{let h=Jo(i,l),d=K1[h],m=n.direction[d]>=0,y,g;m?(y=Et(i),g=Tt(i,l)):(y=Tt(i,l),g=Et(i));let v=Hn(y,o,n,s,r)?Jp(y,e,t,n,s,r):null;if(v){let w=v.point[d];if(m?w<=o[g+h]:w>=o[g+h+3])return v}let b=Hn(g,o,n,s,r)?Jp(g,e,t,n,s,r):null;return v&&b?v.distance<=b.distance?v:b:v||b||null}}var Jh=new et,la=new Cn,ca=new Cn,Gl=new Ce,jx=new en,jh=new en;function Qx(i,e,t,n){ut.setBuffer(i._roots[e]);let s=jp(0,i,t,n);return ut.clearBuffer(),s}function jp(i,e,t,n,s=null){let{float32Array:r,uint16Array:o,uint32Array:a}=ut,l=i*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),jx.set(t.boundingBox.min,t.boundingBox.max,n),s=jx),_t(l,o)){let u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,m=t.attributes.position,y=It(i,a),g=Ut(l,o);if(Gl.copy(n).invert(),t.boundsTree)return Vt(i,r,jh),jh.matrix.copy(Gl),jh.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>jh.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(n),v.b.applyMatrix4(n),v.c.applyMatrix4(n),v.needsUpdate=!0;for(let M=y,b=g+y;M<b;M++)if(Ht(ca,3*e.resolveTriangleIndex(M),h,d),ca.needsUpdate=!0,v.intersectsTriangle(ca))return!0;return!1}});{let _=ar(t);for(let v=y,M=g+y;v<M;v++){let b=e.resolveTriangleIndex(v);Ht(la,3*b,h,d),la.a.applyMatrix4(Gl),la.b.applyMatrix4(Gl),la.c.applyMatrix4(Gl),la.needsUpdate=!0;for(let w=0,x=_*3;w<x;w+=3)if(Ht(ca,w,f,m),ca.needsUpdate=!0,la.intersectsTriangle(ca))return!0}}}else{let u=Et(i),h=Tt(i,a);return Vt(u,r,Jh),!!(s.intersectsBox(Jh)&&jp(u,e,t,n,s)||(Vt(h,r,Jh),s.intersectsBox(Jh)&&jp(h,e,t,n,s)))}}var Qh=new Ce,Qp=new en,Wl=new en,Z1=new P,J1=new P,j1=new P,Q1=new P;function ey(i,e,t,n={},s={},r=0,o=1/0){e.boundingBox||e.computeBoundingBox(),Qp.set(e.boundingBox.min,e.boundingBox.max,t),Qp.needsUpdate=!0;let a=i.geometry,l=a.attributes.position,c=a.index,u=e.attributes.position,h=e.index,d=Qn.getPrimitive(),f=Qn.getPrimitive(),m=Z1,y=J1,g=null,_=null;s&&(g=j1,_=Q1);let v=1/0,M=null,b=null;return Qh.copy(t).invert(),Wl.matrix.copy(Qh),i.shapecast({boundsTraverseOrder:w=>Qp.distanceToBox(w),intersectsBounds:(w,x,p)=>p<v&&p<o?(x&&(Wl.min.copy(w.min),Wl.max.copy(w.max),Wl.needsUpdate=!0),!0):!1,intersectsRange:(w,x)=>{if(e.boundsTree){let p=e.boundsTree;return p.shapecast({boundsTraverseOrder:S=>Wl.distanceToBox(S),intersectsBounds:(S,A,E)=>E<v&&E<o,intersectsRange:(S,A)=>{for(let E=S,C=S+A;E<C;E++){let I=p.resolveTriangleIndex(E);Ht(f,3*I,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let D=w,L=w+x;D<L;D++){let U=i.resolveTriangleIndex(D);Ht(d,3*U,c,l),d.needsUpdate=!0;let V=d.distanceToTriangle(f,m,g);if(V<v&&(y.copy(m),_&&_.copy(g),v=V,M=D,b=E),V<r)return!0}}}})}else{let p=ar(e);for(let S=0,A=p;S<A;S++){Ht(f,3*S,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let E=w,C=w+x;E<C;E++){let I=i.resolveTriangleIndex(E);Ht(d,3*I,c,l),d.needsUpdate=!0;let D=d.distanceToTriangle(f,m,g);if(D<v&&(y.copy(m),_&&_.copy(g),v=D,M=E,b=S),D<r)return!0}}}}}),Qn.releasePrimitive(d),Qn.releasePrimitive(f),v===1/0?null:(n.point?n.point.copy(y):n.point=y.clone(),n.distance=v,n.faceIndex=M,s&&(s.point?s.point.copy(_):s.point=_.clone(),s.point.applyMatrix4(Qh),y.applyMatrix4(Qh),s.distance=y.sub(s.point).length(),s.faceIndex=b),n)}function em(i,e,t){return i===null?null:(i.point.applyMatrix4(e.matrixWorld),i.distance=i.point.distanceTo(t.ray.origin),i.object=e,i)}var ed=new en,td=new $i,ty=new P,ny=new Ce,iy=new P,tm=["getX","getY","getZ"],nd=class i extends Gh{static serialize(e,t={}){t={cloneBuffers:!0,...t};let n=e.geometry,s=e._roots,r=e._indirectBuffer,o=n.getIndex(),a={version:1,roots:null,index:null,indirectBuffer:null};return t.cloneBuffers?(a.roots=s.map(l=>l.slice()),a.index=o?o.array.slice():null,a.indirectBuffer=r?r.slice():null):(a.roots=s,a.index=o?o.array:null,a.indirectBuffer=r),a}static deserialize(e,t,n={}){n={setIndex:!0,indirect:!!e.indirectBuffer,...n};let{index:s,roots:r,indirectBuffer:o}=e;e.version||(console.warn("MeshBVH.deserialize: Serialization format has been changed and will be fixed up. It is recommended to regenerate any stored serialized data."),l(r));let a=new i(t,{...n,[Dl]:!0});if(a._roots=r,a._indirectBuffer=o||null,n.setIndex){let c=t.getIndex();if(c===null){let u=new gt(e.index,1,!1);t.setIndex(u)}else c.array!==s&&(c.array.set(s),c.needsUpdate=!0)}return a;function l(c){for(let u=0;u<c.length;u++){let h=c[u],d=new Uint32Array(h),f=new Uint16Array(h);for(let m=0,y=h.byteLength/32;m<y;m++){let g=8*m,_=2*g;_t(_,f)||(d[g+6]=d[g+6]/8-m)}}}}get primitiveStride(){return 3}get resolveTriangleIndex(){return this.resolvePrimitiveIndex}constructor(e,t={}){t.maxLeafTris&&(console.warn('MeshBVH: "maxLeafTris" option has been deprecated. Use "targetLeafSize", instead.'),t={...t,targetLeafSize:t.maxLeafTris}),super(e,t)}shiftTriangleOffsets(e){return super.shiftPrimitiveOffsets(e)}writePrimitiveBounds(e,t,n){let s=this.geometry,r=this._indirectBuffer,o=s.attributes.position,a=s.index?s.index.array:null,c=(r?r[e]:e)*3,u=c+0,h=c+1,d=c+2;a&&(u=a[u],h=a[h],d=a[d]);for(let f=0;f<3;f++){let m=o[tm[f]](u),y=o[tm[f]](h),g=o[tm[f]](d),_=m;y<_&&(_=y),g<_&&(_=g);let v=m;y>v&&(v=y),g>v&&(v=g),t[n+f]=_,t[n+f+3]=v}return t}computePrimitiveBounds(e,t,n){let s=this.geometry,r=this._indirectBuffer,o=s.attributes.position,a=s.index?s.index.array:null,l=o.normalized;if(e<0||t+e-n.offset>n.length/6)throw new Error("MeshBVH: compute triangle bounds range is invalid.");let c=o.array,u=o.offset||0,h=3;o.isInterleavedBufferAttribute&&(h=o.data.stride);let d=["getX","getY","getZ"],f=n.offset;for(let m=e,y=e+t;m<y;m++){let _=(r?r[m]:m)*3,v=(m-f)*6,M=_+0,b=_+1,w=_+2;a&&(M=a[M],b=a[b],w=a[w]),l||(M=M*h+u,b=b*h+u,w=w*h+u);for(let x=0;x<3;x++){let p,S,A;l?(p=o[d[x]](M),S=o[d[x]](b),A=o[d[x]](w)):(p=c[M+x],S=c[b+x],A=c[w+x]);let E=p;S<E&&(E=S),A<E&&(E=A);let C=p;S>C&&(C=S),A>C&&(C=A);let I=(C-E)/2,D=x*2;n[v+D+0]=E+I,n[v+D+1]=I+(Math.abs(E)+I)*Zo}}return n}raycastObject3D(e,t,n=[]){let{material:s}=e;if(s===void 0)return;ny.copy(e.matrixWorld).invert(),td.copy(t.ray).applyMatrix4(ny),iy.setFromMatrixScale(e.matrixWorld),ty.copy(td.direction).multiply(iy);let r=ty.length(),o=t.near/r,a=t.far/r;if(t.firstHitOnly===!0){let l=this.raycastFirst(td,s,o,a);l=em(l,e,t),l&&n.push(l)}else{let l=this.raycast(td,s,o,a);for(let c=0,u=l.length;c<u;c++){let h=em(l[c],e,t);h&&n.push(h)}}return n}refit(e=null){return(this.indirect?Kx:zx)(this,e)}raycast(e,t=ci,n=0,s=1/0){let r=this._roots,o=[],a=this.indirect?Zx:Wx;for(let l=0,c=r.length;l<c;l++)a(this,l,t,e,o,n,s);return o}raycastFirst(e,t=ci,n=0,s=1/0){let r=this._roots,o=null,a=this.indirect?Jx:Xx;for(let l=0,c=r.length;l<c;l++){let u=a(this,l,t,e,n,s);u!=null&&(o==null||u.distance<o.distance)&&(o=u)}return o}intersectsGeometry(e,t){let n=!1,s=this._roots,r=this.indirect?Qx:Yx;for(let o=0,a=s.length;o<a&&(n=r(this,o,e,t),!n);o++);return n}shapecast(e){let t=Qn.getPrimitive(),n=super.shapecast({...e,intersectsPrimitive:e.intersectsTriangle,scratchPrimitive:t,iterate:this.indirect?Gx:Bx});return Qn.releasePrimitive(t),n}bvhcast(e,t,n){let{intersectsRanges:s,intersectsTriangles:r}=n,o=Qn.getPrimitive(),a=this.geometry.index,l=this.geometry.attributes.position,c=this.indirect?m=>{let y=this.resolveTriangleIndex(m);Ht(o,y*3,a,l)}:m=>{Ht(o,m*3,a,l)},u=Qn.getPrimitive(),h=e.geometry.index,d=e.geometry.attributes.position,f=e.indirect?m=>{let y=e.resolveTriangleIndex(m);Ht(u,y*3,h,d)}:m=>{Ht(u,m*3,h,d)};if(r){if(!(e instanceof i))throw new Error('MeshBVH: "intersectsTriangles" callback can only be used with another MeshBVH.');let m=(y,g,_,v,M,b,w,x)=>{for(let p=_,S=_+v;p<S;p++){f(p),u.a.applyMatrix4(t),u.b.applyMatrix4(t),u.c.applyMatrix4(t),u.needsUpdate=!0;for(let A=y,E=y+g;A<E;A++)if(c(A),o.needsUpdate=!0,r(o,u,A,p,M,b,w,x))return!0}return!1};if(s){let y=s;s=function(g,_,v,M,b,w,x,p){return y(g,_,v,M,b,w,x,p)?!0:m(g,_,v,M,b,w,x,p)}}else s=m}return super.bvhcast(e,t,{intersectsRanges:s})}intersectsBox(e,t){return ed.set(e.min,e.max,t),ed.needsUpdate=!0,this.shapecast({intersectsBounds:n=>ed.intersectsBox(n),intersectsTriangle:n=>ed.intersectsTriangle(n)})}intersectsSphere(e){return this.shapecast({intersectsBounds:t=>e.intersectsBox(t),intersectsTriangle:t=>t.intersectsSphere(e)})}closestPointToGeometry(e,t,n={},s={},r=0,o=1/0){return(this.indirect?ey:$x)(this,e,t,n,s,r,o)}closestPointToPoint(e,t={},n=0,s=1/0){return Ix(this,e,t,n,s)}};var yO=parseInt("187")>=166,ua={Mesh:Pt.prototype.raycast,Line:Ki.prototype.raycast,LineSegments:Zi.prototype.raycast,LineLoop:js.prototype.raycast,Points:Li.prototype.raycast,BatchedMesh:nl.prototype.raycast},Pn=new Pt,id=[];function sy(i,e){if(this.isBatchedMesh)eA.call(this,i,e);else{let{geometry:t}=this;if(t.boundsTree)t.boundsTree.raycastObject3D(this,i,e);else{let n;if(this instanceof Pt)n=ua.Mesh;else if(this instanceof Zi)n=ua.LineSegments;else if(this instanceof js)n=ua.LineLoop;else if(this instanceof Ki)n=ua.Line;else if(this instanceof Li)n=ua.Points;else throw new Error("BVH: Fallback raycast function not found.");n.call(this,i,e)}}}function eA(i,e){if(this.boundsTrees){let t=this.boundsTrees,n=this._drawInfo||this._instanceInfo,s=this._drawRanges||this._geometryInfo,r=this.matrixWorld;Pn.material=this.material,Pn.geometry=this.geometry;let o=Pn.geometry.boundsTree,a=Pn.geometry.drawRange;Pn.geometry.boundingSphere===null&&(Pn.geometry.boundingSphere=new zt);for(let l=0,c=n.length;l<c;l++){if(!this.getVisibleAt(l))continue;let u=n[l].geometryIndex;if(Pn.geometry.boundsTree=t[u],this.getMatrixAt(l,Pn.matrixWorld).premultiply(r),!Pn.geometry.boundsTree){this.getBoundingBoxAt(u,Pn.geometry.boundingBox),this.getBoundingSphereAt(u,Pn.geometry.boundingSphere);let h=s[u];Pn.geometry.setDrawRange(h.start,h.count)}Pn.raycast(i,id);for(let h=0,d=id.length;h<d;h++){let f=id[h];f.object=this,f.batchId=l,e.push(f)}id.length=0}Pn.geometry.boundsTree=o,Pn.geometry.drawRange=a,Pn.material=null,Pn.geometry=null}else ua.BatchedMesh.call(this,i,e)}var tA=["#440154","#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6dcd59","#b4de2c","#fde725"],nA=["#0d3b76","#2a6da3","#78a9c8","#c5d9e2","#ece8e2","#eacdbc","#d69a7a","#b3563a","#7a2013"],iA=i=>i<=.04045?i/12.92:((i+.055)/1.055)**2.4,sA=i=>i<=.0031308?12.92*i:1.055*Math.max(i,0)**.4166666666666667-.055;function rA([i,e,t]){let n=Math.cbrt(.4122214708*i+.5363325363*e+.0514459929*t),s=Math.cbrt(.2119034982*i+.6806995451*e+.1073969566*t),r=Math.cbrt(.0883024619*i+.2817188376*e+.6299787005*t);return[.2104542553*n+.793617785*s-.0040720468*r,1.9779984951*n-2.428592205*s+.4505937099*r,.0259040371*n+.7827717662*s-.808675766*r]}function oA([i,e,t]){let n=(i+.3963377774*e+.2158037573*t)**3,s=(i-.1055613458*e-.0638541728*t)**3,r=(i-.0894841775*e-1.291485548*t)**3;return[4.0767416621*n-3.3077115913*s+.2309699292*r,-1.2684380046*n+2.6097574011*s-.3413193965*r,-.0041960863*n-.7034186147*s+1.707614701*r]}var nm=256;function ry(i){let e=i.map(t=>rA([1,3,5].map(n=>iA(parseInt(t.slice(n,n+2),16)/255))));return Array.from({length:nm},(t,n)=>{let s=n/(nm-1)*(i.length-1),r=Math.min(Math.floor(s),i.length-2),o=e[r].map((a,l)=>a+(s-r)*(e[r+1][l]-a));return oA(o).map(a=>Math.min(1,Math.max(0,a)))})}var aA={sequential:ry(tA),diverging:ry(nA)},sd=(i,e)=>aA[i][Math.round(Math.min(1,Math.max(0,e))*(nm-1))],oy=(i,e)=>`rgb(${sd(i,e).map(t=>Math.round(255*sA(t))).join(" ")})`;function im(i,e){if(e===op)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===Ho||e===Al){let t=i.getIndex();if(t===null){let r=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)r.push(a);i.setIndex(r),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,s=[];if(e===Ho)for(let r=1;r<=n;r++)s.push(t.getX(0)),s.push(t.getX(r)),s.push(t.getX(r+1));else for(let r=0;r<n;r++)r%2===0?(s.push(t.getX(r)),s.push(t.getX(r+1)),s.push(t.getX(r+2))):(s.push(t.getX(r+2)),s.push(t.getX(r+1)),s.push(t.getX(r)));return s.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(s),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function ay(i){let e=new Map,t=new Map,n=i.clone();return ly(i,n,function(s,r){e.set(r,s),t.set(s,r)}),n.traverse(function(s){if(!s.isSkinnedMesh)return;let r=s,o=e.get(s),a=o.skeleton.bones;r.skeleton=o.skeleton.clone(),r.bindMatrix.copy(o.bindMatrix),r.skeleton.bones=a.map(function(l){return t.get(l)}),r.bind(r.skeleton,r.bindMatrix)}),n}function ly(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)ly(i.children[n],e.children[n],t)}var da=class extends Qi{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new um(t)}),this.register(function(t){return new hm(t)}),this.register(function(t){return new dm(t)}),this.register(function(t){return new bm(t)}),this.register(function(t){return new Sm(t)}),this.register(function(t){return new Mm(t)}),this.register(function(t){return new pm(t)}),this.register(function(t){return new mm(t)}),this.register(function(t){return new gm(t)}),this.register(function(t){return new _m(t)}),this.register(function(t){return new cm(t)}),this.register(function(t){return new xm(t)}),this.register(function(t){return new fm(t)}),this.register(function(t){return new vm(t)}),this.register(function(t){return new ym(t)}),this.register(function(t){return new am(t)}),this.register(function(t){return new rd(t,ot.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new rd(t,ot.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new wm(t)})}load(e,t,n,s){let r=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let c=Us.extractUrlBase(e);o=Us.resolveURL(c,this.path)}else o=Us.extractUrlBase(e);this.manager.itemStart(e);let a=function(c){s?s(c):console.error(c),r.manager.itemError(e),r.manager.itemEnd(e)},l=new No(this.manager);l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.path),l.setResponseType("arraybuffer"),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials),l.load(e,function(c){try{r.parse(c,o,function(u){t(u),r.manager.itemEnd(e)},a)}catch(u){a(u)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,s){let r,o={},a={},l=new TextDecoder;if(typeof e=="string")r=JSON.parse(e);else if(e instanceof ArrayBuffer)if(l.decode(new Uint8Array(e,0,4))===fy){try{o[ot.KHR_BINARY_GLTF]=new Em(e)}catch(h){s&&s(h);return}r=JSON.parse(o[ot.KHR_BINARY_GLTF].content)}else r=JSON.parse(l.decode(e));else r=e;if(r.asset===void 0||r.asset.version[0]<2){s&&s(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let c=new Lm(r,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});c.fileLoader.setRequestHeader(this.requestHeader);for(let u=0;u<this.pluginCallbacks.length;u++){let h=this.pluginCallbacks[u](c);h.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[h.name]=h,o[h.name]=!0}if(r.extensionsUsed)for(let u=0;u<r.extensionsUsed.length;++u){let h=r.extensionsUsed[u],d=r.extensionsRequired||[];switch(h){case ot.KHR_MATERIALS_UNLIT:o[h]=new lm;break;case ot.KHR_DRACO_MESH_COMPRESSION:o[h]=new Tm(r,this.dracoLoader);break;case ot.KHR_TEXTURE_TRANSFORM:o[h]=new Am;break;case ot.KHR_MESH_QUANTIZATION:o[h]=new Rm;break;default:d.indexOf(h)>=0&&a[h]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+h+'".')}}c.setExtensions(o),c.setPlugins(a),c.parse(n,s)}parseAsync(e,t){let n=this;return new Promise(function(s,r){n.parse(e,t,s,r)})}};function lA(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function jt(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var ot={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},am=class{constructor(e){this.parser=e,this.name=ot.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,s=t.length;n<s;n++){let r=t[n];r.extensions&&r.extensions[this.name]&&r.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,r.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,s=t.cache.get(n);if(s)return s;let r=t.json,l=((r.extensions&&r.extensions[this.name]||{}).lights||[])[e],c,u=new De(16777215);l.color!==void 0&&u.setRGB(l.color[0],l.color[1],l.color[2],$n);let h=l.range!==void 0?l.range:0;switch(l.type){case"directional":c=new Ur(u),c.target.position.set(0,0,-1),c.add(c.target);break;case"point":c=new fl(u),c.distance=h;break;case"spot":c=new dl(u),c.distance=h,l.spot=l.spot||{},l.spot.innerConeAngle=l.spot.innerConeAngle!==void 0?l.spot.innerConeAngle:0,l.spot.outerConeAngle=l.spot.outerConeAngle!==void 0?l.spot.outerConeAngle:Math.PI/4,c.angle=l.spot.outerConeAngle,c.penumbra=1-l.spot.innerConeAngle/l.spot.outerConeAngle,c.target.position.set(0,0,-1),c.add(c.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+l.type)}return c.position.set(0,0,0),us(c,l),l.intensity!==void 0&&(c.intensity=l.intensity),c.name=t.createUniqueName(l.name||"light_"+e),s=Promise.resolve(c),t.cache.add(n,s),s}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,r=n.json.nodes[e],a=(r.extensions&&r.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(l){return n._getNodeRef(t.cache,a,l)})}},lm=class{constructor(){this.name=ot.KHR_MATERIALS_UNLIT}getMaterialType(){return xi}extendParams(e,t,n){let s=[];e.color=new De(1,1,1),e.opacity=1;let r=t.pbrMetallicRoughness;if(r){if(Array.isArray(r.baseColorFactor)){let o=r.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],$n),e.opacity=o[3]}r.baseColorTexture!==void 0&&s.push(n.assignTexture(e,"map",r.baseColorTexture,ln))}return Promise.all(s)}},cm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},um=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(s.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let r=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new Fe(r,r)}return Promise.all(s)}},hm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(s)}},dm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_DISPERSION}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},fm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(s)}},pm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_SHEEN}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(t.sheenColor=new De(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let r=n.sheenColorFactor;t.sheenColor.setRGB(r[0],r[1],r[2],$n)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,ln)),n.sheenRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(s)}},mm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&s.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(s)}},gm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_VOLUME}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let r=n.attenuationColor||[1,1,1];return t.attenuationColor=new De().setRGB(r[0],r[1],r[2],$n),Promise.all(s)}},_m=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_IOR}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},xm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_SPECULAR}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let r=n.specularColorFactor||[1,1,1];return t.specularColor=new De().setRGB(r[0],r[1],r[2],$n),n.specularColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,ln)),Promise.all(s)}},ym=class{constructor(e){this.parser=e,this.name=ot.EXT_MATERIALS_BUMP}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&s.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(s)}},vm=class{constructor(e){this.parser=e,this.name=ot.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return jt(this.parser,e,this.name)!==null?Jn:null}extendMaterialParams(e,t){let n=jt(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&s.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(s)}},bm=class{constructor(e){this.parser=e,this.name=ot.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,s=n.textures[e];if(!s.extensions||!s.extensions[this.name])return null;let r=s.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,r.source,o)}},Sm=class{constructor(e){this.parser=e,this.name=ot.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},Mm=class{constructor(e){this.parser=e,this.name=ot.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},rd=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let s=n.extensions[this.name],r=this.parser.getDependency("buffer",s.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return r.then(function(a){let l=s.byteOffset||0,c=s.byteLength||0,u=s.count,h=s.byteStride,d=new Uint8Array(a,l,c);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(u,h,d,s.mode,s.filter).then(function(f){return f.buffer}):o.ready.then(function(){let f=new ArrayBuffer(u*h);return o.decodeGltfBuffer(new Uint8Array(f),u,h,d,s.mode,s.filter),f})})}else return null}},wm=class{constructor(e){this.name=ot.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let s=t.meshes[n.mesh];for(let c of s.primitives)if(c.mode!==Si.TRIANGLES&&c.mode!==Si.TRIANGLE_STRIP&&c.mode!==Si.TRIANGLE_FAN&&c.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],l={};for(let c in o)a.push(this.parser.getDependency("accessor",o[c]).then(u=>(l[c]=u,l[c])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(c=>{let u=c.pop(),h=u.isGroup?u.children:[u],d=c[0].count,f=[];for(let m of h){let y=new Ce,g=new P,_=new Kn,v=new P(1,1,1),M=new el(m.geometry,m.material,d);for(let w=0;w<d;w++)l.TRANSLATION&&g.fromBufferAttribute(l.TRANSLATION,w),l.ROTATION&&_.fromBufferAttribute(l.ROTATION,w),l.SCALE&&v.fromBufferAttribute(l.SCALE,w),M.setMatrixAt(w,y.compose(g,_,v));let b=null;for(let w in l)if(w==="_COLOR_0"){let x=l[w];M.instanceColor=new As(x.array,x.itemSize,x.normalized)}else if(w!=="TRANSLATION"&&w!=="ROTATION"&&w!=="SCALE"){if(b===null){let p=M.geometry;b=new $t,b.name=p.name;for(let S in p.attributes)b.setAttribute(S,p.attributes[S]);for(let S in p.morphAttributes)b.morphAttributes[S]=p.morphAttributes[S];p.index!==null&&b.setIndex(p.index),b.morphTargetsRelative=p.morphTargetsRelative;for(let S of p.groups)b.addGroup(S.start,S.count,S.materialIndex);p.boundingBox!==null&&(b.boundingBox=p.boundingBox.clone()),p.boundingSphere!==null&&(b.boundingSphere=p.boundingSphere.clone()),b.drawRange.start=p.drawRange.start,b.drawRange.count=p.drawRange.count,b.userData=Object.assign({},p.userData),M.geometry=b}let x=l[w];b.setAttribute(w,new As(x.array,x.itemSize,x.normalized))}Jt.prototype.copy.call(M,m),this.parser.assignFinalMaterial(M),f.push(M)}return u.isGroup?(u.clear(),u.add(...f),u):f[0]}))}},fy="glTF",Xl=12,cy={JSON:1313821514,BIN:5130562},Em=class{constructor(e){this.name=ot.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,Xl),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==fy)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let s=this.header.length-Xl,r=new DataView(e,Xl),o=0;for(;o<s;){let a=r.getUint32(o,!0);o+=4;let l=r.getUint32(o,!0);if(o+=4,l===cy.JSON){let c=new Uint8Array(e,Xl+o,a);this.content=n.decode(c)}else if(l===cy.BIN){let c=Xl+o;this.body=e.slice(c,c+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},Tm=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=ot.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,s=this.dracoLoader,r=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},l={},c={};for(let u in o){let h=Pm[u]||u.toLowerCase();a[h]=o[u]}for(let u in e.attributes){let h=Pm[u]||u.toLowerCase();if(o[u]!==void 0){let d=n.accessors[e.attributes[u]],f=ha[d.componentType];c[h]=f.name,l[h]=d.normalized===!0}}return t.getDependency("bufferView",r).then(function(u){return new Promise(function(h,d){s.decodeDracoFile(u,function(f){for(let m in f.attributes){let y=f.attributes[m],g=l[m];g!==void 0&&(y.normalized=g)}h(f)},a,c,$n,d)})})}},Am=class{constructor(){this.name=ot.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),s=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*s,e.offset.x,-e.repeat.x*s,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},Rm=class{constructor(){this.name=ot.KHR_MESH_QUANTIZATION}},od=class extends ji{constructor(e,t,n,s){super(e,t,n,s)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s*3+s;for(let o=0;o!==s;o++)t[o]=n[r+o];return t}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=a*2,c=a*3,u=s-t,h=(n-t)/u,d=h*h,f=d*h,m=e*c,y=m-c,g=-2*f+3*d,_=f-d,v=1-g,M=_-d+h;for(let b=0;b!==a;b++){let w=o[y+b+a],x=o[y+b+l]*u,p=o[m+b+a],S=o[m+b]*u;r[b]=v*w+M*x+g*p+_*S}return r}},cA=new Kn,Cm=class extends od{interpolate_(e,t,n,s){let r=super.interpolate_(e,t,n,s);return cA.fromArray(r).normalize().toArray(r),r}},Si={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},ha={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},uy={9728:nn,9729:hn,9984:Fu,9985:zo,9986:zr,9987:yi},hy={33071:gi,33648:wo,10497:Zs},sm={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},Pm={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},lr={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},uA={CUBICSPLINE:void 0,LINEAR:Lr,STEP:Ir},rm={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function hA(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new Ps({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:ci})),i.DefaultMaterial}function Yr(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function us(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function dA(i,e,t){let n=!1,s=!1,r=!1;for(let c=0,u=e.length;c<u;c++){let h=e[c];if(h.POSITION!==void 0&&(n=!0),h.NORMAL!==void 0&&(s=!0),h.COLOR_0!==void 0&&(r=!0),n&&s&&r)break}if(!n&&!s&&!r)return Promise.resolve(i);let o=[],a=[],l=[];for(let c=0,u=e.length;c<u;c++){let h=e[c];if(n){let d=h.POSITION!==void 0?t.getDependency("accessor",h.POSITION):i.attributes.position;o.push(d)}if(s){let d=h.NORMAL!==void 0?t.getDependency("accessor",h.NORMAL):i.attributes.normal;a.push(d)}if(r){let d=h.COLOR_0!==void 0?t.getDependency("accessor",h.COLOR_0):i.attributes.color;l.push(d)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l)]).then(function(c){let u=c[0],h=c[1],d=c[2];return n&&(i.morphAttributes.position=u),s&&(i.morphAttributes.normal=h),r&&(i.morphAttributes.color=d),i.morphTargetsRelative=!0,i})}function fA(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,s=t.length;n<s;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function pA(i){let e,t=i.extensions&&i.extensions[ot.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+om(t.attributes):e=i.indices+":"+om(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,s=i.targets.length;n<s;n++)e+=":"+om(i.targets[n]);return e}function om(i){let e="",t=Object.keys(i).sort();for(let n=0,s=t.length;n<s;n++)e+=t[n]+":"+i[t[n]]+";";return e}function Im(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function mA(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var gA=new Ce,Lm=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new lA,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,s=-1,r=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let l=a.match(/Version\/(\d+)/);s=n&&l?parseInt(l[1],10):-1,r=a.indexOf("Firefox")>-1,o=r?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&s<17||r&&o<98?(this.textureLoader=new ul(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new gl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new No(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,s=this.json,r=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][s.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:s.asset,parser:n,userData:{}};return Yr(r,a,s),us(a,s),Promise.all(n._invokeAll(function(l){return l.afterRoot&&l.afterRoot(a)})).then(function(){for(let l of a.scenes)l.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let s=0,r=t.length;s<r;s++){let o=t[s].joints;for(let a=0,l=o.length;a<l;a++)e[o[a]].isBone=!0}for(let s=0,r=e.length;s<r;s++){let o=e[s];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let s=n.clone(),r=(o,a)=>{let l=this.associations.get(o);l!=null&&this.associations.set(a,l);for(let[c,u]of o.children.entries())r(u,a.children[c])};return r(n,s),s.name+="_instance_"+e.uses[t]++,s}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let s=e(t[n]);if(s)return s}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let s=0;s<t.length;s++){let r=e(t[s]);r&&n.push(r)}return n}getDependency(e,t){let n=e+":"+t,s=this.cache.get(n);if(!s){switch(e){case"scene":s=this.loadScene(t);break;case"node":s=this._invokeOne(function(r){return r.loadNode&&r.loadNode(t)});break;case"mesh":s=this._invokeOne(function(r){return r.loadMesh&&r.loadMesh(t)});break;case"accessor":s=this.loadAccessor(t);break;case"bufferView":s=this._invokeOne(function(r){return r.loadBufferView&&r.loadBufferView(t)});break;case"buffer":s=this.loadBuffer(t);break;case"material":s=this._invokeOne(function(r){return r.loadMaterial&&r.loadMaterial(t)});break;case"texture":s=this._invokeOne(function(r){return r.loadTexture&&r.loadTexture(t)});break;case"skin":s=this.loadSkin(t);break;case"animation":s=this._invokeOne(function(r){return r.loadAnimation&&r.loadAnimation(t)});break;case"camera":s=this.loadCamera(t);break;default:if(s=this._invokeOne(function(r){return r!=this&&r.getDependency&&r.getDependency(e,t)}),!s)throw new Error("Unknown type: "+e);break}this.cache.add(n,s)}return s}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,s=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(s.map(function(r,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[ot.KHR_BINARY_GLTF].body);let s=this.options;return new Promise(function(r,o){n.load(Us.resolveURL(t.uri,s.path),r,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let s=t.byteLength||0,r=t.byteOffset||0;return n.slice(r,r+s)})}loadAccessor(e){let t=this,n=this.json,s=this.json.accessors[e];if(s.bufferView===void 0&&s.sparse===void 0){let o=sm[s.type],a=ha[s.componentType],l=s.normalized===!0,c=new a(s.count*o);return Promise.resolve(new gt(c,o,l))}let r=[];return s.bufferView!==void 0?r.push(this.getDependency("bufferView",s.bufferView)):r.push(null),s.sparse!==void 0&&(r.push(this.getDependency("bufferView",s.sparse.indices.bufferView)),r.push(this.getDependency("bufferView",s.sparse.values.bufferView))),Promise.all(r).then(function(o){let a=o[0],l=sm[s.type],c=ha[s.componentType],u=c.BYTES_PER_ELEMENT,h=u*l,d=s.byteOffset||0,f=s.bufferView!==void 0?n.bufferViews[s.bufferView].byteStride:void 0,m=s.normalized===!0,y,g;if(f&&f!==h){let _=Math.floor(d/f),v="InterleavedBuffer:"+s.bufferView+":"+s.componentType+":"+_+":"+s.count,M=t.cache.get(v);M||(y=new c(a,_*f,s.count*f/u),M=new Nr(y,f/u),t.cache.add(v,M)),g=new ni(M,l,d%f/u,m)}else a===null?y=new c(s.count*l):y=new c(a,d,s.count*l),g=new gt(y,l,m);if(s.sparse!==void 0){let _=sm.SCALAR,v=ha[s.sparse.indices.componentType],M=s.sparse.indices.byteOffset||0,b=s.sparse.values.byteOffset||0,w=new v(o[1],M,s.sparse.count*_),x=new c(o[2],b,s.sparse.count*l);a!==null&&(g=new gt(g.array.slice(),g.itemSize,g.normalized)),g.normalized=!1;for(let p=0,S=w.length;p<S;p++){let A=w[p];if(g.setX(A,x[p*l]),l>=2&&g.setY(A,x[p*l+1]),l>=3&&g.setZ(A,x[p*l+2]),l>=4&&g.setW(A,x[p*l+3]),l>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}g.normalized=m}return g})}loadTexture(e){let t=this.json,n=this.options,r=t.textures[e].source,o=t.images[r],a=this.textureLoader;if(o.uri){let l=n.manager.getHandler(o.uri);l!==null&&(a=l)}return this.loadTextureImage(e,r,a)}loadTextureImage(e,t,n){let s=this,r=this.json,o=r.textures[e],a=r.images[t],l=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[l])return this.textureCache[l];let c=this.loadImageSource(t,n).then(function(u){u.flipY=!1,u.name=o.name||a.name||"",u.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(u.name=a.uri);let d=(r.samplers||{})[o.sampler]||{};return u.magFilter=uy[d.magFilter]||hn,u.minFilter=uy[d.minFilter]||yi,u.wrapS=hy[d.wrapS]||Zs,u.wrapT=hy[d.wrapT]||Zs,u.generateMipmaps=!u.isCompressedTexture&&u.minFilter!==nn&&u.minFilter!==hn,s.associations.set(u,{textures:e}),u}).catch(function(){return null});return this.textureCache[l]=c,c}loadImageSource(e,t){let n=this,s=this.json,r=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(d=>d.clone());let o=s.images[e],a=self.URL||self.webkitURL,l=o.uri||"",c=!1,u;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)u=n.getDependency("bufferView",o.bufferView).then(function(d){return new Promise(function(f,m){t.parse(d,f,m)})});else{if(o.bufferView!==void 0)l=n.getDependency("bufferView",o.bufferView).then(function(d){c=!0;let f=new Blob([d],{type:o.mimeType});return l=a.createObjectURL(f),l});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");u=Promise.resolve(l).then(function(d){return new Promise(function(f,m){let y=f;t.isImageBitmapLoader===!0&&(y=function(g){let _=new vn(g);_.needsUpdate=!0,f(_)}),t.load(Us.resolveURL(d,r.path),y,void 0,m)})})}let h=u.then(function(d){return c===!0&&a.revokeObjectURL(l),us(d,o),d.userData.mimeType=o.mimeType||mA(o.uri),d}).catch(function(d){throw console.error("THREE.GLTFLoader: Couldn't load texture",l),d});return this.sourceCache[e]=h,h}assignTexture(e,t,n,s){let r=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),r.extensions[ot.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[ot.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let l=r.associations.get(o);o=r.extensions[ot.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),r.associations.set(o,l)}}return s!==void 0&&(o.colorSpace=s),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,s=t.attributes.tangent===void 0,r=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new Lo,Zn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,l.sizeAttenuation=!1,this.cache.add(a,l)),n=l}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new Js,Zn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,this.cache.add(a,l)),n=l}if(s||r||o){let a="ClonedMaterial:"+n.uuid+":";s&&(a+="derivative-tangents:"),r&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let l=this.cache.get(a);l||(l=n.clone(),r&&(l.vertexColors=!0),o&&(l.flatShading=!0),s&&(l.normalScale&&(l.normalScale.y*=-1),l.clearcoatNormalScale&&(l.clearcoatNormalScale.y*=-1)),this.cache.add(a,l),this.associations.set(l,this.associations.get(n))),n=l}e.material=n}getMaterialType(){return Ps}loadMaterial(e){let t=this,n=this.json,s=this.extensions,r=n.materials[e],o,a={},l=r.extensions||{},c=[];if(l[ot.KHR_MATERIALS_UNLIT]){let h=s[ot.KHR_MATERIALS_UNLIT];o=h.getMaterialType(),c.push(h.extendParams(a,r,t))}else{let h=r.pbrMetallicRoughness||{};if(a.color=new De(1,1,1),a.opacity=1,Array.isArray(h.baseColorFactor)){let d=h.baseColorFactor;a.color.setRGB(d[0],d[1],d[2],$n),a.opacity=d[3]}h.baseColorTexture!==void 0&&c.push(t.assignTexture(a,"map",h.baseColorTexture,ln)),a.metalness=h.metallicFactor!==void 0?h.metallicFactor:1,a.roughness=h.roughnessFactor!==void 0?h.roughnessFactor:1,h.metallicRoughnessTexture!==void 0&&(c.push(t.assignTexture(a,"metalnessMap",h.metallicRoughnessTexture)),c.push(t.assignTexture(a,"roughnessMap",h.metallicRoughnessTexture))),o=this._invokeOne(function(d){return d.getMaterialType&&d.getMaterialType(e)}),c.push(Promise.all(this._invokeAll(function(d){return d.extendMaterialParams&&d.extendMaterialParams(e,a)})))}r.doubleSided===!0&&(a.side=an);let u=r.alphaMode||rm.OPAQUE;if(u===rm.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,u===rm.MASK&&(a.alphaTest=r.alphaCutoff!==void 0?r.alphaCutoff:.5)),r.normalTexture!==void 0&&o!==xi&&(c.push(t.assignTexture(a,"normalMap",r.normalTexture)),a.normalScale=new Fe(1,1),r.normalTexture.scale!==void 0)){let h=r.normalTexture.scale;a.normalScale.set(h,h)}if(r.occlusionTexture!==void 0&&o!==xi&&(c.push(t.assignTexture(a,"aoMap",r.occlusionTexture)),r.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=r.occlusionTexture.strength)),r.emissiveFactor!==void 0&&o!==xi){let h=r.emissiveFactor;a.emissive=new De().setRGB(h[0],h[1],h[2],$n)}return r.emissiveTexture!==void 0&&o!==xi&&c.push(t.assignTexture(a,"emissiveMap",r.emissiveTexture,ln)),Promise.all(c).then(function(){let h=new o(a);return r.name&&(h.name=r.name),us(h,r),t.associations.set(h,{materials:e}),r.extensions&&Yr(s,h,r),h})}createUniqueName(e){let t=Bt.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,s=this.primitiveCache;function r(a){return n[ot.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(l){return dy(l,a,t)})}let o=[];for(let a=0,l=e.length;a<l;a++){let c=e[a],u=pA(c),h=s[u];if(h)o.push(h.promise);else{let d;c.extensions&&c.extensions[ot.KHR_DRACO_MESH_COMPRESSION]?d=r(c):d=dy(new $t,c,t),c.mode===Si.TRIANGLE_STRIP?d=d.then(f=>im(f,Al)):c.mode===Si.TRIANGLE_FAN&&(d=d.then(f=>im(f,Ho))),s[u]={primitive:c,promise:d},o.push(d)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,s=this.extensions,r=n.meshes[e],o=r.primitives,a=[];for(let l=0,c=o.length;l<c;l++){let u=o[l].material===void 0?hA(this.cache):this.getDependency("material",o[l].material);a.push(u)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(l){let c=l.slice(0,l.length-1),u=l[l.length-1],h=[];for(let f=0,m=u.length;f<m;f++){let y=u[f],g=o[f],_,v=c[f];if(g.mode===Si.TRIANGLES||g.mode===Si.TRIANGLE_STRIP||g.mode===Si.TRIANGLE_FAN||g.mode===void 0){let M=r.isSkinnedMesh===!0,b=y.hasAttribute("skinIndex")&&y.hasAttribute("skinWeight");M&&b===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),_=M&&b?new ja(y,v):new Pt(y,v),_.isSkinnedMesh===!0&&_.normalizeSkinWeights()}else if(g.mode===Si.LINES)_=new Zi(y,v);else if(g.mode===Si.LINE_STRIP)_=new Ki(y,v);else if(g.mode===Si.LINE_LOOP)_=new js(y,v);else if(g.mode===Si.POINTS)_=new Li(y,v);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+g.mode);Object.keys(_.geometry.morphAttributes).length>0&&fA(_,r),_.name=t.createUniqueName(r.name||"mesh_"+e),us(_,r),g.extensions&&Yr(s,_,g),t.assignFinalMaterial(_),h.push(_)}for(let f=0,m=h.length;f<m;f++)t.associations.set(h[f],{meshes:e,primitives:f});if(h.length===1)return r.extensions&&Yr(s,h[0],r),h[0];let d=new yn;r.extensions&&Yr(s,d,r),t.associations.set(d,{meshes:e});for(let f=0,m=h.length;f<m;f++)d.add(h[f]);return d})}loadCamera(e){let t,n=this.json.cameras[e],s=n[n.type];if(!s){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new cn(Go.radToDeg(s.yfov),s.aspectRatio||1,s.znear||1,s.zfar||2e6):n.type==="orthographic"&&(t=new Ds(-s.xmag,s.xmag,s.ymag,-s.ymag,s.znear,s.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),us(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let s=0,r=t.joints.length;s<r;s++)n.push(this._loadNodeShallow(t.joints[s]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(s){let r=s.pop(),o=s,a=[],l=[];for(let c=0,u=o.length;c<u;c++){let h=o[c];if(h){a.push(h);let d=new Ce;r!==null&&d.fromArray(r.array,c*16),l.push(d)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[c])}return new Qa(a,l)})}loadAnimation(e){let t=this.json,n=this,s=t.animations[e],r=s.name?s.name:"animation_"+e,o=[],a=[],l=[],c=[],u=[];for(let h=0,d=s.channels.length;h<d;h++){let f=s.channels[h],m=s.samplers[f.sampler],y=f.target,g=y.node,_=s.parameters!==void 0?s.parameters[m.input]:m.input,v=s.parameters!==void 0?s.parameters[m.output]:m.output;y.node!==void 0&&(o.push(this.getDependency("node",g)),a.push(this.getDependency("accessor",_)),l.push(this.getDependency("accessor",v)),c.push(m),u.push(y))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l),Promise.all(c),Promise.all(u)]).then(function(h){let d=h[0],f=h[1],m=h[2],y=h[3],g=h[4],_=[];for(let M=0,b=d.length;M<b;M++){let w=d[M],x=f[M],p=m[M],S=y[M],A=g[M];if(w===void 0)continue;w.updateMatrix&&w.updateMatrix();let E=n._createAnimationTracks(w,x,p,S,A);if(E)for(let C=0;C<E.length;C++)_.push(E[C])}let v=new cl(r,void 0,_);return us(v,s),v})}createNodeMesh(e){let t=this.json,n=this,s=t.nodes[e];return s.mesh===void 0?null:n.getDependency("mesh",s.mesh).then(function(r){let o=n._getNodeRef(n.meshCache,s.mesh,r);return s.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let l=0,c=s.weights.length;l<c;l++)a.morphTargetInfluences[l]=s.weights[l]}),o})}loadNode(e){let t=this.json,n=this,s=t.nodes[e],r=n._loadNodeShallow(e),o=[],a=s.children||[];for(let c=0,u=a.length;c<u;c++)o.push(n.getDependency("node",a[c]));let l=s.skin===void 0?Promise.resolve(null):n.getDependency("skin",s.skin);return Promise.all([r,Promise.all(o),l]).then(function(c){let u=c[0],h=c[1],d=c[2];d!==null&&u.traverse(function(f){f.isSkinnedMesh&&f.bind(d,gA)});for(let f=0,m=h.length;f<m;f++)u.add(h[f]);if(u.userData.pivot!==void 0&&h.length>0){let f=u.userData.pivot,m=h[0];u.pivot=new P().fromArray(f),u.position.x-=f[0],u.position.y-=f[1],u.position.z-=f[2],m.position.set(0,0,0),delete u.userData.pivot}return u})}_loadNodeShallow(e){let t=this.json,n=this.extensions,s=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let r=t.nodes[e],o=r.name?s.createUniqueName(r.name):"",a=[],l=s._invokeOne(function(c){return c.createNodeMesh&&c.createNodeMesh(e)});return l&&a.push(l),r.camera!==void 0&&a.push(s.getDependency("camera",r.camera).then(function(c){return s._getNodeRef(s.cameraCache,r.camera,c)})),s._invokeAll(function(c){return c.createNodeAttachment&&c.createNodeAttachment(e)}).forEach(function(c){a.push(c)}),this.nodeCache[e]=Promise.all(a).then(function(c){let u;if(r.isBone===!0?u=new Io:c.length>1?u=new yn:c.length===1?u=c[0]:u=new Jt,u!==c[0])for(let h=0,d=c.length;h<d;h++)u.add(c[h]);if(r.name&&(u.userData.name=r.name,u.name=o),us(u,r),r.extensions&&Yr(n,u,r),r.matrix!==void 0){let h=new Ce;h.fromArray(r.matrix),u.applyMatrix4(h)}else r.translation!==void 0&&u.position.fromArray(r.translation),r.rotation!==void 0&&u.quaternion.fromArray(r.rotation),r.scale!==void 0&&u.scale.fromArray(r.scale);if(!s.associations.has(u))s.associations.set(u,{});else if(r.mesh!==void 0&&s.meshCache.refs[r.mesh]>1){let h=s.associations.get(u);s.associations.set(u,{...h})}return s.associations.get(u).nodes=e,u}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],s=this,r=new yn;n.name&&(r.name=s.createUniqueName(n.name)),us(r,n),n.extensions&&Yr(t,r,n);let o=n.nodes||[],a=[];for(let l=0,c=o.length;l<c;l++)a.push(s.getDependency("node",o[l]));return Promise.all(a).then(function(l){for(let u=0,h=l.length;u<h;u++){let d=l[u];d.parent!==null?r.add(ay(d)):r.add(d)}let c=u=>{let h=new Map;for(let[d,f]of s.associations)(d instanceof Zn||d instanceof vn)&&h.set(d,f);return u.traverse(d=>{let f=s.associations.get(d);f!=null&&h.set(d,f)}),h};return s.associations=c(r),r})}_createAnimationTracks(e,t,n,s,r){let o=[],a=e.name?e.name:e.uuid,l=[];function c(f){f.morphTargetInfluences&&l.push(f.name?f.name:f.uuid)}lr[r.path]===lr.weights?(c(e),e.isGroup&&e.children.forEach(c)):l.push(a);let u;switch(lr[r.path]){case lr.weights:u=Ls;break;case lr.rotation:u=Os;break;case lr.translation:case lr.scale:u=Qs;break;default:n.itemSize===1?u=Ls:u=Qs;break}let h=s.interpolation!==void 0?uA[s.interpolation]:Lr,d=this._getArrayFromAccessor(n);for(let f=0,m=l.length;f<m;f++){let y=new u(l[f]+"."+lr[r.path],t.array,d,h);s.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(y),o.push(y)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=Im(t.constructor),s=new Float32Array(t.length);for(let r=0,o=t.length;r<o;r++)s[r]=t[r]*n;t=s}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let s=this instanceof Os?Cm:od;return new s(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function _A(i,e,t){let n=e.attributes,s=new et;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],l=a.min,c=a.max;if(l!==void 0&&c!==void 0){if(s.set(new P(l[0],l[1],l[2]),new P(c[0],c[1],c[2])),a.normalized){let u=Im(ha[a.componentType]);s.min.multiplyScalar(u),s.max.multiplyScalar(u)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let r=e.targets;if(r!==void 0){let a=new P,l=new P;for(let c=0,u=r.length;c<u;c++){let h=r[c];if(h.POSITION!==void 0){let d=t.json.accessors[h.POSITION],f=d.min,m=d.max;if(f!==void 0&&m!==void 0){if(l.setX(Math.max(Math.abs(f[0]),Math.abs(m[0]))),l.setY(Math.max(Math.abs(f[1]),Math.abs(m[1]))),l.setZ(Math.max(Math.abs(f[2]),Math.abs(m[2]))),d.normalized){let y=Im(ha[d.componentType]);l.multiplyScalar(y)}a.max(l)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}s.expandByVector(a)}i.boundingBox=s;let o=new zt;s.getCenter(o.center),o.radius=s.min.distanceTo(s.max)/2,i.boundingSphere=o}function dy(i,e,t){let n=e.attributes,s=[];function r(o,a){return t.getDependency("accessor",o).then(function(l){i.setAttribute(a,l)})}for(let o in n){let a=Pm[o]||o.toLowerCase();a in i.attributes||s.push(r(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});s.push(o)}return it.workingColorSpace!==$n&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${it.workingColorSpace}" not supported.`),us(i,e),_A(i,e,t),Promise.all(s).then(function(){return e.targets!==void 0?dA(i,e.targets,t):i})}var xA=new da;async function fa(i){let e=await xA.parseAsync(i,""),t=e.parser.json,n=await e.parser.getDependency("node",0),{geometry:s}=n,r=new Map;for(let[u,h]of Object.entries(s.attributes))u.startsWith("_")&&h instanceof gt&&h.itemSize===1&&(r.set(u.slice(1),h.array),s.deleteAttribute(u));s.deleteAttribute("color");let o=[];for(let u=1;u<t.nodes.length;u+=1){let h=await e.parser.getDependency("node",u),d=[];h.traverse(g=>{g.isLine&&d.push(g)});let f=yA(d.map(Om)),m=[],[y]=d;if(y&&d.length===1&&!y.geometry.index)for(let[g,_]of Object.entries(y.geometry.attributes)){if(!g.startsWith("_"))continue;let v=Object.entries(t.nodes[u].extras??{}).find(([M])=>M.toLowerCase()===g)?.[1]?.unit??"";m.push({name:g.slice(1),unit:v,values:_.array})}o.push({name:t.nodes[u].name??"lines",segments:f,values:m})}let[a=0,l=0,c=0]=t.nodes[0]?.translation??[];return{geometry:s,attributes:r,lines:o,translation:[a,l,c],extras:t.asset.extras??{}}}function Om(i){let e=i.geometry.attributes.position,t=i.geometry.index?.array??Uint32Array.from({length:e.count},(a,l)=>l),n=i.isLineSegments,s=i.isLineLoop,r=n?t.length>>1:Math.max(t.length-(s?0:1),0),o=new Float32Array(6*r);for(let a=0;a<r;a+=1)for(let l=0;l<2;l+=1){let c=3*t[((n?2:1)*a+l)%t.length];o.set(e.array.subarray(c,c+3),6*a+3*l)}return o}function yA(i){let e=new Float32Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function ad(i){let e=i.index.array,t=i.attributes.position.count,n=new Map,s=[],r=[];for(let o=0;o<e.length;o+=3)for(let a=0;a<3;a+=1){let l=e[o+a],c=e[o+(a+1)%3],u=Math.min(l,c)*t+Math.max(l,c),h=n.get(u);h===void 0?(n.set(u,s.length/2),s.push(l,c),r.push(o/3,-1)):r[2*h+1]===-1&&(r[2*h+1]=o/3)}return{ends:Uint32Array.from(s),faces:Int32Array.from(r)}}var vA=1e-4,bA=1e-6;function py(i,e){let t=[{id:"plain",label:"Plain"}];for(let s of i.attributes.keys())t.push({id:s,label:tn(s)});t.push({id:"edge_length",label:"Edge length"}),e!=="minimal_surface"&&t.push({id:"bending",label:"Bending (fold angle)"});let n=new Set(i.lines.flatMap(s=>s.values.map(({name:r})=>r)));n.delete("length");for(let s of n)t.push({id:`line:${s}`,label:tn(s)});return t}function my(i,e,t,n){if(e==="plain")return null;if(e==="mean_curvature")return SA(i,t,n);if(e==="edge_length"||e==="bending")return wA(i,e,t,n);if(e.startsWith("line:"))return AA(i,e.slice(5));let s=i.attributes.get(e);return s?ld({id:e,label:tn(e),unit:"",at:"vertex",values:s},0):null}function ld(i,e){let t=1/0,n=-1/0;for(let o of i.values)Number.isFinite(o)&&(t=Math.min(t,o),n=Math.max(n,o));t>n&&([t,n]=[0,0]);let s=Math.max(Math.abs(t),Math.abs(n)),r=s<=e;return t<0&&n>0?{...i,scale:"diverging",low:-s,high:s,nought:r,noise:e}:{...i,scale:"sequential",low:t,high:n,nought:r,noise:e}}function SA(i,e,t){let n=i.attributes.get("mean_curvature"),s=new Float32Array(n.length),r=MA(i),o=!1;for(let h=0;h<n.length;h+=1)s[h]=n[h]*t*(n[h]<0?1:r[h]),o||=s[h]<0;i.geometry.computeBoundingSphere();let a=i.geometry.boundingSphere.radius/t,l=a>0?vA/a:0,c=ld({id:"mean_curvature",label:"Mean curvature",unit:`1/${e}`,at:"vertex",values:s},l),u=Math.max(Math.abs(c.low),Math.abs(c.high));return{...c,scale:"diverging",low:-u,high:u}}function MA(i){let{position:e,normal:t}=i.geometry.attributes,n=i.geometry.index.array,s=new Float64Array(e.count),r=a=>new P().fromBufferAttribute(e,a),o=new P;for(let a=0;a<n.length;a+=3){let l=[n[a],n[a+1],n[a+2]],c=l.map(r);for(let u=0;u<3;u+=1){let[h,d]=[(u+1)%3,(u+2)%3],f=c[h].clone().sub(c[u]),m=c[d].clone().sub(c[u]),y=f.dot(m)/Math.max(f.clone().cross(m).length(),1e-30),g=c[d].clone().sub(c[h]);s[l[h]]+=y*g.dot(o.fromBufferAttribute(t,l[h])),s[l[d]]-=y*g.dot(o.fromBufferAttribute(t,l[d]))}}return Float32Array.from(s,a=>a<0?-1:1)}function wA(i,e,t,n){let s=ad(i.geometry),r=i.geometry.attributes.position.array,o=[];for(let d=0;d<s.ends.length/2;d+=1)(e==="edge_length"||s.faces[2*d+1]!==-1)&&o.push(d);let a=new Float32Array(6*o.length),l=new Float32Array(o.length),c=e==="bending"?EA(i):null;o.forEach((d,f)=>{let m=3*s.ends[2*d],y=3*s.ends[2*d+1];for(let g=0;g<3;g+=1)a[6*f+g]=r[m+g],a[6*f+3+g]=r[y+g];c?l[f]=TA(c,s,d):l[f]=Math.hypot(r[m]-r[y],r[m+1]-r[y+1],r[m+2]-r[y+2])/n});let u=e==="bending",h=ld({id:e,label:u?"Bending (fold angle)":"Edge length",unit:u?"°":t,at:"segment",values:l,segments:a},u?.01:0);return u?{...h,low:0}:h}function EA(i){let{position:e}=i.geometry.attributes,t=i.geometry.index.array,n=s=>new P().fromBufferAttribute(e,t[s]);return Array.from({length:t.length/3},(s,r)=>{let o=n(3*r);return n(3*r+1).sub(o).cross(n(3*r+2).sub(o)).normalize()})}var TA=(i,{faces:e},t)=>i[e[2*t]].angleTo(i[e[2*t+1]])*180/Math.PI;function AA(i,e){let t=i.lines.flatMap(a=>a.values.filter(l=>l.name===e).map(l=>({line:a,each:l})));if(t.length===0)return null;let n=t.reduce((a,{each:l})=>a+l.values.length/2,0),s=new Float32Array(n),r=new Float32Array(6*n),o=0;for(let{line:a,each:l}of t){r.set(a.segments,6*o);for(let c=0;c<l.values.length;c+=2)s[o+c/2]=l.values[c];o+=l.values.length/2}return ld({id:`line:${e}`,label:tn(e),unit:t[0].each.unit,at:"segment",values:s,segments:r},0)}function cd(i,e){if(i.nought)return i.scale==="diverging"?.5:0;let t=i.high-i.low;return t>bA*Math.max(Math.abs(i.low),Math.abs(i.high))?(e-i.low)/t:.5}var gy=(i,e)=>`${i.label} ${Math.abs(e)<=i.noise?"≈ 0":`${wt(e,4)}`}${i.unit==="°"?"°":i.unit&&` ${i.unit}`}`;function _y(i,e){let t=new Array(e).fill(0);for(let n of i.values)Number.isFinite(n)&&(t[Math.min(e-1,Math.max(0,Math.floor(cd(i,n)*e)))]+=1);return t}var RA=2e4;function ud(i,e,t,n,s=1){if(i.length/6>RA){let a=new $t().setAttribute("position",new gt(i,3));n&&a.setAttribute("color",new gt(n,3));let l=new Js({color:n?"#ffffff":t,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new Zi(a,l)}let r=new Ko().setPositions(i);n&&r.setColors(n);let o=new $o({color:n?16777215:new De(t).getHex(),linewidth:e,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new Oh(r,o)}var CA=2e3;function ql({geometry:i,material:e}){i.dispose(),setTimeout(()=>e.dispose(),CA)}var pa=class{constructor(e){this.look=e}look;group=new yn;mesh=null;result=null;kind="";quantity=null;lines=[];layers={surface:!0,edges:!1,lines:!0};drawn=!0;ghost=!1;get shown(){return this.mesh!==null}get current(){return this.result}show(e,t,n,s=null){this.result=e,this.kind=t,this.quantity=s,this.ghost=!1,e&&this.putInto(n),this.make()}putInto(e){if(!this.result)return;let t=e.up===2?[e.origin[0],e.origin[2],-e.origin[1]]:e.origin,[n,s,r]=this.result.translation.map((o,a)=>o-t[a]*e.metres);this.group.position.set(n,s,r)}colourBy(e){this.quantity=e,this.make()}setLayers(e){Object.assign(this.layers,e),this.make()}setGhost(e){if(e!==this.ghost&&(this.ghost=e,!!this.mesh)){this.mesh.material.transparent=e,this.mesh.material.opacity=e?.32:1,this.mesh.material.depthWrite=!e,this.mesh.material.needsUpdate=!0;for(let t of this.lines)t.material.transparent=!0,t.material.opacity=e?.2:t.userData.opacity??1}}restyle(){this.make()}clear(){this.mesh&&ql(this.mesh),this.mesh=null,this.lines.forEach(ql),this.lines=[],this.group.clear()}make(){let{result:e,quantity:t,ghost:n}=this;if(this.clear(),!e)return;let s=this.kind!=="minimal_surface",r=new $t;r.setIndex(e.geometry.index),r.setAttribute("position",e.geometry.attributes.position),r.setAttribute("normal",e.geometry.attributes.normal);let o=t?.at==="vertex";t&&o&&r.setAttribute("color",new gt(PA(t),3));let a={side:an,flatShading:s,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},l=o?new al({...a,vertexColors:!0}):new Ps({...a,color:this.look.membrane,roughness:.62,metalness:0});this.mesh=new Pt(r,l),this.mesh.raycast=sy,this.mesh.userData.castsShadow=!0,this.mesh.visible=this.layers.surface,this.group.add(this.mesh);let c=(h,d,f,m=1,y)=>{if(h.length===0)return;let g=ud(h,d,f,y,m);g.userData.opacity=m,g.userData.isLine=!0,this.lines.push(g),this.group.add(g)},u=t?.at==="segment"?t:null;if(u&&c(u.segments,3,this.look.ink,1,IA(u)),this.layers.edges&&u?.id!=="edge_length"&&c(LA(e),1,this.look.ink,.3),this.layers.lines)for(let{name:h,segments:d}of e.lines)u&&(h.startsWith("members")||h==="bridges")||(h==="boundaries"||h==="directrices"?this.drawn||c(d,2,this.look.ink,.85):h.startsWith("members")?c(d,h.includes("rim")?1.4:2,this.look.ink,h.includes("rim")?.5:.8):h==="bridges"?c(d,1,this.look.ink,.35):c(d,2.4,this.look.accent));n&&(this.ghost=!1,this.setGhost(!0))}tree(){let e=this.mesh?.geometry;return e?(e.boundsTree??=new nd(e,{indirect:!0}),e):null}pick(e,t,n){if(!this.mesh||!this.layers.surface||!this.tree())return null;let s=new tr;s.setFromCamera(new Fe(t/e.width*2-1,1-n/e.height*2),e.camera),s.firstHitOnly=!0,this.group.updateMatrixWorld();let[r]=s.intersectObject(this.mesh,!1);return r?{point:r.point,distance:r.distance,face:r.faceIndex??0}:null}valueAt(e,t){let{quantity:n,mesh:s}=this;if(!n||!s)return null;let r=s.worldToLocal(e.clone());if(n.at==="segment")return OA(n,r);let o=s.geometry.index.array,{position:a}=s.geometry.attributes,l=[0,1,2].map(y=>o[3*t+y]),[c,u,h]=l.map(y=>new P().fromBufferAttribute(a,y)),d=(y,g,_)=>g.clone().sub(y).cross(_.clone().sub(y)).length(),f=[d(r,u,h),d(c,r,h),d(c,u,r)],m=f.reduce((y,g)=>y+g,0);return m>0?l.reduce((y,g,_)=>y+f[_]/m*n.values[g],0):n.values[l[0]]}outline(){let e=this.result?.geometry.attributes.position;if(!e)return[];let t=Math.max(1,Math.floor(e.count/3e3)),{x:n,y:s,z:r}=this.group.position,o=[];for(let l=0;l<e.count;l+=t)o.push([e.getX(l)+n,e.getY(l)+s,e.getZ(l)+r]);let a=this.result.geometry.boundingBox??(this.result.geometry.computeBoundingBox(),this.result.geometry.boundingBox);for(let l=0;l<e.count;l+=1){let c=[e.getX(l),e.getY(l),e.getZ(l)];if(c.some((u,h)=>u===a.min.getComponent(h)||u===a.max.getComponent(h))&&o.push([c[0]+n,c[1]+s,c[2]+r]),o.length>4e3)break}return o}};function PA(i){let e=new Float32Array(3*i.values.length);return i.values.forEach((t,n)=>e.set(sd(i.scale,cd(i,t)),3*n)),e}function IA(i){let e=new Float32Array(6*i.values.length);return i.values.forEach((t,n)=>{let s=sd(i.scale,cd(i,t));e.set(s,6*n),e.set(s,6*n+3)}),e}var xy=new WeakMap;function LA(i){let e=xy.get(i);if(e)return e;let t=i.geometry.attributes.position.array,{ends:n}=ad(i.geometry),s=new Float32Array(3*n.length);return n.forEach((r,o)=>s.set(t.subarray(3*r,3*r+3),3*o)),xy.set(i,s),s}function OA({segments:i,values:e},t){let n=1/0,s=null,r=new P,o=new P,a=new P;for(let l=0;l<e.length;l+=1){r.fromArray(i,6*l),o.fromArray(i,6*l+3).sub(r),a.copy(t).sub(r);let c=Math.min(1,Math.max(0,a.dot(o)/o.lengthSq())),u=a.addScaledVector(o,-c).lengthSq();u<n&&([n,s]=[u,e[l]])}return s}var zs=(i,e)=>i?.line===e?.line&&i?.point===e?.point,NA=`
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
}`,hd=class{constructor(e){this.look=e;let t=n=>({value:new De(n)});this.material=new dn({vertexShader:NA,fragmentShader:DA,transparent:!0,uniforms:{scale:{value:1},size:{value:11},near:{value:.001},paper:t(e.paper),accent:t(e.accent),ink:t(e.ink),fault:t(e.fault)}}),this.group.add(this.extra)}look;group=new yn;places=[];refs=[];points=null;lines=null;extra=new yn;material;restyle(e){this.look=e;for(let t of["paper","accent","ink","fault"])this.material.uniforms[t].value.set(e[t])}setPixel(e,t){this.material.uniforms.near.value=e,this.material.uniforms.scale.value=t}show(e,t,n){let s=[],r=[],o=[];e.forEach((a,l)=>{let u=a.points.map(Yt).map(f=>f?n.toScene(f):null);if(u.forEach((f,m)=>{let y=f??UA(u[(m+u.length-1)%u.length]??null,u[(m+1)%u.length]??null);y&&(s.push(y),r.push({line:l,point:m}))}),Mr(a))return;let h=u.filter(f=>f!==null),d=a.closed&&h.length>2?h.length:h.length-1;for(let f=0;f<d;f+=1)o.push(...h[f],...h[(f+1)%h.length])}),t?.forEach((a,l)=>{s.push(n.toScene(a)),r.push({line:-1,point:l}),l>0&&o.push(...n.toScene(t[l-1]),...n.toScene(a))}),this.places=s,this.refs=r,this.setLines(new Float32Array(o)),this.setPoints()}setLines(e){this.lines&&(ql(this.lines),this.group.remove(this.lines)),this.lines=e.length>0?ud(e,2.4,this.look.accent):null,this.lines&&(this.lines.renderOrder=1,this.group.add(this.lines))}setPoints(){let e=this.places.length;if(!this.points||this.points.geometry.attributes.position.count!==e){this.points&&(this.points.geometry.dispose(),this.group.remove(this.points));let n=new $t;n.setAttribute("position",new gt(new Float32Array(3*e),3)),n.setAttribute("state",new gt(new Float32Array(e),1)),this.points=new Li(n,this.material),this.points.frustumCulled=!1,this.points.renderOrder=2,this.group.add(this.points)}let{position:t}=this.points.geometry.attributes;this.places.forEach((n,s)=>t.setXYZ(s,...n)),t.needsUpdate=!0,this.material.uniforms.size.value=e>300?5:e>120?7:11}mark(e){let t=this.points?.geometry.attributes.state;t&&(this.refs.forEach((n,s)=>t.setX(s,e(n))),t.needsUpdate=!0)}hint(e){for(let n of this.extra.children)n.material===this.material?n.geometry.dispose():ql(n);this.extra.clear();let t=(n,s,r)=>{if(!n||n.length<2)return;let o=ud(new Float32Array(n.flat()),1.6,s,void 0,r);o.renderOrder=1,this.extra.add(o)};if(t(e.segments,this.look.accent,.95),t(e.faint,this.look.soft,.8),e.ghost){let n=new $t;n.setAttribute("position",new gt(new Float32Array(e.ghost),3)),n.setAttribute("state",new gt(new Float32Array([5]),1));let s=new Li(n,this.material);s.renderOrder=3,this.extra.add(s)}}};function UA(i,e){return!i||!e?i??e:[0,1,2].map(t=>(i[t]+e[t])/2)}var Qt={LEFT:1,RIGHT:2,MIDDLE:4},Y=Object.freeze({NONE:0,ROTATE:1,TRUCK:2,SCREEN_PAN:4,OFFSET:8,DOLLY:16,ZOOM:32,TOUCH_ROTATE:64,TOUCH_TRUCK:128,TOUCH_SCREEN_PAN:256,TOUCH_OFFSET:512,TOUCH_DOLLY:1024,TOUCH_ZOOM:2048,TOUCH_DOLLY_TRUCK:4096,TOUCH_DOLLY_SCREEN_PAN:8192,TOUCH_DOLLY_OFFSET:16384,TOUCH_DOLLY_ROTATE:32768,TOUCH_ZOOM_TRUCK:65536,TOUCH_ZOOM_OFFSET:131072,TOUCH_ZOOM_SCREEN_PAN:262144,TOUCH_ZOOM_ROTATE:524288}),ma={NONE:0,IN:1,OUT:-1};function $r(i){return i.isPerspectiveCamera}function ur(i){return i.isOrthographicCamera}var cr=Math.PI*2,yy=Math.PI/2,Ay=1e-5,Yl=Math.PI/180;function Ui(i,e,t){return Math.max(e,Math.min(t,i))}function Xt(i,e=Ay){return Math.abs(i)<e}function Lt(i,e,t=Ay){return Xt(i-e,t)}function vy(i,e){return Math.round(i/e)*e}function $l(i){return isFinite(i)?i:i<0?-Number.MAX_VALUE:Number.MAX_VALUE}function Kl(i){return Math.abs(i)<Number.MAX_VALUE?i:i*(1/0)}function dd(i,e,t,n,s=1/0,r){n=Math.max(1e-4,n);let o=2/n,a=o*r,l=1/(1+a+.48*a*a+.235*a*a*a),c=i-e,u=e,h=s*n;c=Ui(c,-h,h),e=i-c;let d=(t.value+o*c)*r;t.value=(t.value-o*d)*l;let f=e+(c+d)*l;return u-i>0==f>u&&(f=u,t.value=(f-u)/r),f}function by(i,e,t,n,s=1/0,r,o){n=Math.max(1e-4,n);let a=2/n,l=a*r,c=1/(1+l+.48*l*l+.235*l*l*l),u=e.x,h=e.y,d=e.z,f=i.x-u,m=i.y-h,y=i.z-d,g=u,_=h,v=d,M=s*n,b=M*M,w=f*f+m*m+y*y;if(w>b){let U=Math.sqrt(w);f=f/U*M,m=m/U*M,y=y/U*M}u=i.x-f,h=i.y-m,d=i.z-y;let x=(t.x+a*f)*r,p=(t.y+a*m)*r,S=(t.z+a*y)*r;t.x=(t.x-a*x)*c,t.y=(t.y-a*p)*c,t.z=(t.z-a*S)*c,o.x=u+(f+x)*c,o.y=h+(m+p)*c,o.z=d+(y+S)*c;let A=g-i.x,E=_-i.y,C=v-i.z,I=o.x-g,D=o.y-_,L=o.z-v;return A*I+E*D+C*L>0&&(o.x=g,o.y=_,o.z=v,t.x=(o.x-g)/r,t.y=(o.y-_)/r,t.z=(o.z-v)/r),o}function Nm(i,e){e.set(0,0),i.forEach(t=>{e.x+=t.clientX,e.y+=t.clientY}),e.x/=i.length,e.y/=i.length}function Dm(i,e){return ur(i)?(console.warn(`${e} is not supported in OrthographicCamera`),!0):!1}var Vm=class{constructor(){this._listeners={}}addEventListener(e,t){let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let s=this._listeners[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}removeAllEventListeners(e){if(!e){this._listeners={};return}Array.isArray(this._listeners[e])&&(this._listeners[e].length=0)}dispatchEvent(e){let n=this._listeners[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e)}}},Um,FA="3.1.0",fd=1/8,kA=/Mac/.test((Um=globalThis?.navigator)===null||Um===void 0?void 0:Um.platform),$e,Sy,pd,Fm,ri,tt,bt,ga,Zl,hs,ds,Kr,My,wy,di,_a,xa,Ey,km,Ty,Bm,zm,md,ya=class i extends Vm{static install(e){$e=e.THREE,Sy=Object.freeze(new $e.Vector3(0,0,0)),pd=Object.freeze(new $e.Vector3(0,1,0)),Fm=Object.freeze(new $e.Vector3(0,0,1)),ri=new $e.Vector2,tt=new $e.Vector3,bt=new $e.Vector3,ga=new $e.Vector3,Zl=new $e.Vector3,hs=new $e.Vector3,ds=new $e.Vector3,Kr=new $e.Vector3,My=new $e.Vector3,wy=new $e.Vector3,di=new $e.Spherical,_a=new $e.Spherical,xa=new $e.Box3,Ey=new $e.Box3,km=new $e.Sphere,Ty=new $e.Quaternion,Bm=new $e.Quaternion,zm=new $e.Matrix4,md=new $e.Raycaster}static get ACTION(){return Y}set verticalDragToForward(e){console.warn("camera-controls: `verticalDragToForward` was removed. Use `mouseButtons.left = CameraControls.ACTION.SCREEN_PAN` instead.")}constructor(e,t){super(),this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.minDistance=Number.EPSILON,this.maxDistance=1/0,this.infinityDolly=!1,this.minZoom=.01,this.maxZoom=1/0,this.smoothTime=.25,this.draggingSmoothTime=.125,this.maxSpeed=1/0,this.azimuthRotateSpeed=1,this.polarRotateSpeed=1,this.dollySpeed=1,this.dollyDragInverted=!1,this.truckSpeed=2,this.dollyToCursor=!1,this.dragToOffset=!1,this.boundaryFriction=0,this.restThreshold=.01,this.colliderMeshes=[],this.cancel=()=>{},this._enabled=!0,this._state=Y.NONE,this._viewport=null,this._changedDolly=0,this._changedZoom=0,this._hasRested=!0,this._boundaryEnclosesCamera=!1,this._needsUpdate=!0,this._updatedLastTime=!1,this._elementRect=new DOMRect,this._isDragging=!1,this._dragNeedsUpdate=!0,this._activePointers=[],this._lockedPointer=null,this._interactiveArea=new DOMRect(0,0,1,1),this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._isUserControllingOffset=!1,this._isUserControllingZoom=!1,this._lastDollyDirection=ma.NONE,this._thetaVelocity={value:0},this._phiVelocity={value:0},this._radiusVelocity={value:0},this._targetVelocity=new $e.Vector3,this._focalOffsetVelocity=new $e.Vector3,this._zoomVelocity={value:0},this._truckInternal=(_,v,M,b)=>{let w,x;if($r(this._camera)){let p=tt.copy(this._camera.position).sub(this._target),S=this._camera.getEffectiveFOV()*Yl,A=p.length()*Math.tan(S*.5);w=this.truckSpeed*_*A/this._elementRect.height,x=this.truckSpeed*v*A/this._elementRect.height}else if(ur(this._camera)){let p=this._camera;w=this.truckSpeed*_*(p.right-p.left)/p.zoom/this._elementRect.width,x=this.truckSpeed*v*(p.top-p.bottom)/p.zoom/this._elementRect.height}else return;b?(M?this.setFocalOffset(this._focalOffsetEnd.x+w,this._focalOffsetEnd.y,this._focalOffsetEnd.z,!0):this.truck(w,0,!0),this.forward(-x,!0)):M?this.setFocalOffset(this._focalOffsetEnd.x+w,this._focalOffsetEnd.y+x,this._focalOffsetEnd.z,!0):this.truck(w,x,!0)},this._rotateInternal=(_,v)=>{let M=cr*this.azimuthRotateSpeed*_/this._elementRect.height,b=cr*this.polarRotateSpeed*v/this._elementRect.height;this.rotate(M,b,!0)},this._dollyInternal=(_,v,M)=>{let b=Math.pow(.95,-_*this.dollySpeed),w=this._sphericalEnd.radius,x=this._sphericalEnd.radius*b,p=Ui(x,this.minDistance,this.maxDistance),S=p-x;this.infinityDolly&&this.dollyToCursor?this._dollyToNoClamp(x,!0):this.infinityDolly&&!this.dollyToCursor?(this.dollyInFixed(S,!0),this._dollyToNoClamp(p,!0)):this._dollyToNoClamp(p,!0),this.dollyToCursor&&(this._changedDolly+=(this.infinityDolly?x:p)-w,this._dollyControlCoord.set(v,M)),this._lastDollyDirection=Math.sign(-_)},this._zoomInternal=(_,v,M)=>{let b=Math.pow(.95,_*this.dollySpeed),w=this._zoom,x=this._zoom*b;this.zoomTo(x,!0),this.dollyToCursor&&(this._changedZoom+=x-w,this._dollyControlCoord.set(v,M))},typeof $e>"u"&&console.error("camera-controls: `THREE` is undefined. You must first run `CameraControls.install( { THREE: THREE } )`. Check the docs for further information."),this._camera=e,this._yAxisUpSpace=new $e.Quaternion().setFromUnitVectors(this._camera.up,pd),this._yAxisUpSpaceInverse=this._yAxisUpSpace.clone().invert(),this._state=Y.NONE,this._target=new $e.Vector3,this._targetEnd=this._target.clone(),this._focalOffset=new $e.Vector3,this._focalOffsetEnd=this._focalOffset.clone(),this._spherical=new $e.Spherical().setFromVector3(tt.copy(this._camera.position).applyQuaternion(this._yAxisUpSpace)),this._sphericalEnd=this._spherical.clone(),this._lastDistance=this._spherical.radius,this._zoom=this._camera.zoom,this._zoomEnd=this._zoom,this._lastZoom=this._zoom,this._nearPlaneCorners=[new $e.Vector3,new $e.Vector3,new $e.Vector3,new $e.Vector3],this._updateNearPlaneCorners(),this._boundary=new $e.Box3(new $e.Vector3(-1/0,-1/0,-1/0),new $e.Vector3(1/0,1/0,1/0)),this._cameraUp0=this._camera.up.clone(),this._target0=this._target.clone(),this._position0=this._camera.position.clone(),this._zoom0=this._zoom,this._focalOffset0=this._focalOffset.clone(),this._dollyControlCoord=new $e.Vector2,this.mouseButtons={left:Y.ROTATE,middle:Y.DOLLY,right:Y.TRUCK,wheel:$r(this._camera)?Y.DOLLY:ur(this._camera)?Y.ZOOM:Y.NONE},this.touches={one:Y.TOUCH_ROTATE,two:$r(this._camera)?Y.TOUCH_DOLLY_TRUCK:ur(this._camera)?Y.TOUCH_ZOOM_TRUCK:Y.NONE,three:Y.TOUCH_TRUCK};let n=new $e.Vector2,s=new $e.Vector2,r=new $e.Vector2,o=_=>{if(!this._enabled||!this._domElement)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let b=this._domElement.getBoundingClientRect(),w=_.clientX/b.width,x=_.clientY/b.height;if(w<this._interactiveArea.left||w>this._interactiveArea.right||x<this._interactiveArea.top||x>this._interactiveArea.bottom)return}let v=_.pointerType!=="mouse"?null:(_.buttons&Qt.LEFT)===Qt.LEFT?Qt.LEFT:(_.buttons&Qt.MIDDLE)===Qt.MIDDLE?Qt.MIDDLE:(_.buttons&Qt.RIGHT)===Qt.RIGHT?Qt.RIGHT:null;if(v!==null){let b=this._findPointerByMouseButton(v);b&&this._disposePointer(b)}if((_.buttons&Qt.LEFT)===Qt.LEFT&&this._lockedPointer)return;let M={pointerId:_.pointerId,clientX:_.clientX,clientY:_.clientY,deltaX:0,deltaY:0,mouseButton:v};this._activePointers.push(M),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),this._isDragging=!0,d(_)},a=_=>{_.cancelable&&_.preventDefault();let v=_.pointerId,M=this._lockedPointer||this._findPointerById(v);if(M){if(M.clientX=_.clientX,M.clientY=_.clientY,M.deltaX=_.movementX,M.deltaY=_.movementY,this._state=0,_.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else(!this._isDragging&&this._lockedPointer||this._isDragging&&(_.buttons&Qt.LEFT)===Qt.LEFT)&&(this._state=this._state|this.mouseButtons.left),this._isDragging&&(_.buttons&Qt.MIDDLE)===Qt.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),this._isDragging&&(_.buttons&Qt.RIGHT)===Qt.RIGHT&&(this._state=this._state|this.mouseButtons.right);f()}},l=_=>{let v=this._findPointerById(_.pointerId);if(!(v&&v===this._lockedPointer)){if(v&&this._disposePointer(v),_.pointerType==="touch")switch(this._activePointers.length){case 0:this._state=Y.NONE;break;case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else this._state=Y.NONE;m()}},c=-1,u=_=>{if(!this._domElement||!this._enabled||this.mouseButtons.wheel===Y.NONE)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let x=this._domElement.getBoundingClientRect(),p=_.clientX/x.width,S=_.clientY/x.height;if(p<this._interactiveArea.left||p>this._interactiveArea.right||S<this._interactiveArea.top||S>this._interactiveArea.bottom)return}if(_.preventDefault(),this.dollyToCursor||this.mouseButtons.wheel===Y.ROTATE||this.mouseButtons.wheel===Y.TRUCK){let x=performance.now();c-x<1e3&&this._getClientRect(this._elementRect),c=x}let v=kA?-1:-3,M=_.deltaMode===1||_.ctrlKey?_.deltaY/v:_.deltaY/(v*10),b=this.dollyToCursor?(_.clientX-this._elementRect.x)/this._elementRect.width*2-1:0,w=this.dollyToCursor?(_.clientY-this._elementRect.y)/this._elementRect.height*-2+1:0;switch(this.mouseButtons.wheel){case Y.ROTATE:{this._rotateInternal(_.deltaX,_.deltaY),this._isUserControllingRotate=!0;break}case Y.TRUCK:{this._truckInternal(_.deltaX,_.deltaY,!1,!1),this._isUserControllingTruck=!0;break}case Y.SCREEN_PAN:{this._truckInternal(_.deltaX,_.deltaY,!1,!0),this._isUserControllingTruck=!0;break}case Y.OFFSET:{this._truckInternal(_.deltaX,_.deltaY,!0,!1),this._isUserControllingOffset=!0;break}case Y.DOLLY:{this._dollyInternal(-M,b,w),this._isUserControllingDolly=!0;break}case Y.ZOOM:{this._zoomInternal(-M,b,w),this._isUserControllingZoom=!0;break}}this.dispatchEvent({type:"control"})},h=_=>{if(!(!this._domElement||!this._enabled)){if(this.mouseButtons.right===i.ACTION.NONE){let v=_ instanceof PointerEvent?_.pointerId:0,M=this._findPointerById(v);M&&this._disposePointer(M),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l);return}_.preventDefault()}},d=_=>{if(!this._enabled)return;if(Nm(this._activePointers,ri),this._getClientRect(this._elementRect),n.copy(ri),s.copy(ri),this._activePointers.length>=2){let M=ri.x-this._activePointers[1].clientX,b=ri.y-this._activePointers[1].clientY,w=Math.sqrt(M*M+b*b);r.set(0,w);let x=(this._activePointers[0].clientX+this._activePointers[1].clientX)*.5,p=(this._activePointers[0].clientY+this._activePointers[1].clientY)*.5;s.set(x,p)}if(this._state=0,!_)this._lockedPointer&&(this._state=this._state|this.mouseButtons.left);else if("pointerType"in _&&_.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else!this._lockedPointer&&(_.buttons&Qt.LEFT)===Qt.LEFT&&(this._state=this._state|this.mouseButtons.left),(_.buttons&Qt.MIDDLE)===Qt.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),(_.buttons&Qt.RIGHT)===Qt.RIGHT&&(this._state=this._state|this.mouseButtons.right);((this._state&Y.ROTATE)===Y.ROTATE||(this._state&Y.TOUCH_ROTATE)===Y.TOUCH_ROTATE||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE)&&(this._sphericalEnd.theta=this._spherical.theta,this._sphericalEnd.phi=this._spherical.phi,this._thetaVelocity.value=0,this._phiVelocity.value=0),((this._state&Y.TRUCK)===Y.TRUCK||(this._state&Y.SCREEN_PAN)===Y.SCREEN_PAN||(this._state&Y.TOUCH_TRUCK)===Y.TOUCH_TRUCK||(this._state&Y.TOUCH_SCREEN_PAN)===Y.TOUCH_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN)&&(this._targetEnd.copy(this._target),this._targetVelocity.set(0,0,0)),((this._state&Y.DOLLY)===Y.DOLLY||(this._state&Y.TOUCH_DOLLY)===Y.TOUCH_DOLLY||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE)&&(this._sphericalEnd.radius=this._spherical.radius,this._radiusVelocity.value=0),((this._state&Y.ZOOM)===Y.ZOOM||(this._state&Y.TOUCH_ZOOM)===Y.TOUCH_ZOOM||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_ZOOM_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE)&&(this._zoomEnd=this._zoom,this._zoomVelocity.value=0),((this._state&Y.OFFSET)===Y.OFFSET||(this._state&Y.TOUCH_OFFSET)===Y.TOUCH_OFFSET||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET)&&(this._focalOffsetEnd.copy(this._focalOffset),this._focalOffsetVelocity.set(0,0,0)),this.dispatchEvent({type:"controlstart"})},f=()=>{if(!this._enabled||!this._dragNeedsUpdate)return;this._dragNeedsUpdate=!1,Nm(this._activePointers,ri);let v=this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement?this._lockedPointer||this._activePointers[0]:null,M=v?-v.deltaX:s.x-ri.x,b=v?-v.deltaY:s.y-ri.y;if(s.copy(ri),((this._state&Y.ROTATE)===Y.ROTATE||(this._state&Y.TOUCH_ROTATE)===Y.TOUCH_ROTATE||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE)&&(this._rotateInternal(M,b),this._isUserControllingRotate=!0),(this._state&Y.DOLLY)===Y.DOLLY||(this._state&Y.ZOOM)===Y.ZOOM){let w=this.dollyToCursor?(n.x-this._elementRect.x)/this._elementRect.width*2-1:0,x=this.dollyToCursor?(n.y-this._elementRect.y)/this._elementRect.height*-2+1:0,p=this.dollyDragInverted?-1:1;(this._state&Y.DOLLY)===Y.DOLLY?(this._dollyInternal(p*b*fd,w,x),this._isUserControllingDolly=!0):(this._zoomInternal(p*b*fd,w,x),this._isUserControllingZoom=!0)}if((this._state&Y.TOUCH_DOLLY)===Y.TOUCH_DOLLY||(this._state&Y.TOUCH_ZOOM)===Y.TOUCH_ZOOM||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_ZOOM_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_ZOOM_ROTATE)===Y.TOUCH_ZOOM_ROTATE){let w=ri.x-this._activePointers[1].clientX,x=ri.y-this._activePointers[1].clientY,p=Math.sqrt(w*w+x*x),S=r.y-p;r.set(0,p);let A=this.dollyToCursor?(s.x-this._elementRect.x)/this._elementRect.width*2-1:0,E=this.dollyToCursor?(s.y-this._elementRect.y)/this._elementRect.height*-2+1:0;(this._state&Y.TOUCH_DOLLY)===Y.TOUCH_DOLLY||(this._state&Y.TOUCH_DOLLY_ROTATE)===Y.TOUCH_DOLLY_ROTATE||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET?(this._dollyInternal(S*fd,A,E),this._isUserControllingDolly=!0):(this._zoomInternal(S*fd,A,E),this._isUserControllingZoom=!0)}((this._state&Y.TRUCK)===Y.TRUCK||(this._state&Y.TOUCH_TRUCK)===Y.TOUCH_TRUCK||(this._state&Y.TOUCH_DOLLY_TRUCK)===Y.TOUCH_DOLLY_TRUCK||(this._state&Y.TOUCH_ZOOM_TRUCK)===Y.TOUCH_ZOOM_TRUCK)&&(this._truckInternal(M,b,!1,!1),this._isUserControllingTruck=!0),((this._state&Y.SCREEN_PAN)===Y.SCREEN_PAN||(this._state&Y.TOUCH_SCREEN_PAN)===Y.TOUCH_SCREEN_PAN||(this._state&Y.TOUCH_DOLLY_SCREEN_PAN)===Y.TOUCH_DOLLY_SCREEN_PAN||(this._state&Y.TOUCH_ZOOM_SCREEN_PAN)===Y.TOUCH_ZOOM_SCREEN_PAN)&&(this._truckInternal(M,b,!1,!0),this._isUserControllingTruck=!0),((this._state&Y.OFFSET)===Y.OFFSET||(this._state&Y.TOUCH_OFFSET)===Y.TOUCH_OFFSET||(this._state&Y.TOUCH_DOLLY_OFFSET)===Y.TOUCH_DOLLY_OFFSET||(this._state&Y.TOUCH_ZOOM_OFFSET)===Y.TOUCH_ZOOM_OFFSET)&&(this._truckInternal(M,b,!0,!1),this._isUserControllingOffset=!0),this.dispatchEvent({type:"control"})},m=()=>{Nm(this._activePointers,ri),s.copy(ri),this._dragNeedsUpdate=!1,(this._activePointers.length===0||this._activePointers.length===1&&this._activePointers[0]===this._lockedPointer)&&(this._isDragging=!1),this._activePointers.length===0&&this._domElement&&(this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this.dispatchEvent({type:"controlend"}))};this.lockPointer=()=>{!this._enabled||!this._domElement||(this.cancel(),this._lockedPointer={pointerId:-1,clientX:0,clientY:0,deltaX:0,deltaY:0,mouseButton:null},this._activePointers.push(this._lockedPointer),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.requestPointerLock(),this._domElement.ownerDocument.addEventListener("pointerlockchange",y),this._domElement.ownerDocument.addEventListener("pointerlockerror",g),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),d())},this.unlockPointer=()=>{var _,v,M;this._lockedPointer!==null&&(this._disposePointer(this._lockedPointer),this._lockedPointer=null),(_=this._domElement)===null||_===void 0||_.ownerDocument.exitPointerLock(),(v=this._domElement)===null||v===void 0||v.ownerDocument.removeEventListener("pointerlockchange",y),(M=this._domElement)===null||M===void 0||M.ownerDocument.removeEventListener("pointerlockerror",g),this.cancel()};let y=()=>{this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement||this.unlockPointer()},g=()=>{this.unlockPointer()};this._addAllEventListeners=_=>{this._domElement=_,this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none",this._domElement.addEventListener("pointerdown",o),this._domElement.addEventListener("pointercancel",l),this._domElement.addEventListener("wheel",u,{passive:!1}),this._domElement.addEventListener("contextmenu",h)},this._removeAllEventListeners=()=>{this._domElement&&(this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect="",this._domElement.removeEventListener("pointerdown",o),this._domElement.removeEventListener("pointercancel",l),this._domElement.removeEventListener("wheel",u,{passive:!1}),this._domElement.removeEventListener("contextmenu",h),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.removeEventListener("pointerlockchange",y),this._domElement.ownerDocument.removeEventListener("pointerlockerror",g))},this.cancel=()=>{this._state!==Y.NONE&&(this._state=Y.NONE,this._activePointers.length=0,m())},t&&this.connect(t),this.update(0)}get camera(){return this._camera}set camera(e){this._camera=e,this.updateCameraUp(),this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0}get enabled(){return this._enabled}set enabled(e){this._enabled=e,this._domElement&&(e?(this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none"):(this.cancel(),this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect=""))}get active(){return!this._hasRested}get currentAction(){return this._state}get distance(){return this._spherical.radius}set distance(e){this._spherical.radius===e&&this._sphericalEnd.radius===e||(this._spherical.radius=e,this._sphericalEnd.radius=e,this._needsUpdate=!0)}get azimuthAngle(){return this._spherical.theta}set azimuthAngle(e){this._spherical.theta===e&&this._sphericalEnd.theta===e||(this._spherical.theta=e,this._sphericalEnd.theta=e,this._needsUpdate=!0)}get polarAngle(){return this._spherical.phi}set polarAngle(e){this._spherical.phi===e&&this._sphericalEnd.phi===e||(this._spherical.phi=e,this._sphericalEnd.phi=e,this._needsUpdate=!0)}get boundaryEnclosesCamera(){return this._boundaryEnclosesCamera}set boundaryEnclosesCamera(e){this._boundaryEnclosesCamera=e,this._needsUpdate=!0}set interactiveArea(e){this._interactiveArea.width=Ui(e.width,0,1),this._interactiveArea.height=Ui(e.height,0,1),this._interactiveArea.x=Ui(e.x,0,1-this._interactiveArea.width),this._interactiveArea.y=Ui(e.y,0,1-this._interactiveArea.height)}addEventListener(e,t){super.addEventListener(e,t)}removeEventListener(e,t){super.removeEventListener(e,t)}rotate(e,t,n=!1){return this.rotateTo(this._sphericalEnd.theta+e,this._sphericalEnd.phi+t,n)}rotateAzimuthTo(e,t=!1){return this.rotateTo(e,this._sphericalEnd.phi,t)}rotatePolarTo(e,t=!1){return this.rotateTo(this._sphericalEnd.theta,e,t)}rotateTo(e,t,n=!1){this._isUserControllingRotate=!1;let s=Ui(e,this.minAzimuthAngle,this.maxAzimuthAngle),r=Ui(t,this.minPolarAngle,this.maxPolarAngle);this._sphericalEnd.theta=s,this._sphericalEnd.phi=r,this._sphericalEnd.makeSafe(),this._needsUpdate=!0,n||(this._spherical.theta=this._sphericalEnd.theta,this._spherical.phi=this._sphericalEnd.phi);let o=!n||Lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold);return this._createOnRestPromise(o)}dolly(e,t=!1){return this.dollyTo(this._sphericalEnd.radius-e,t)}dollyTo(e,t=!1){return this._isUserControllingDolly=!1,this._lastDollyDirection=ma.NONE,this._changedDolly=0,this._dollyToNoClamp(Ui(e,this.minDistance,this.maxDistance),t)}_dollyToNoClamp(e,t=!1){let n=this._sphericalEnd.radius;if(this.colliderMeshes.length>=1){let o=this._collisionTest(),a=Lt(o,this._spherical.radius);if(!(n>e)&&a)return Promise.resolve();this._sphericalEnd.radius=Math.min(e,o)}else this._sphericalEnd.radius=e;this._needsUpdate=!0,t||(this._spherical.radius=this._sphericalEnd.radius);let r=!t||Lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(r)}dollyInFixed(e,t=!1){this._targetEnd.add(this._getCameraDirection(Zl).multiplyScalar(e)),t||this._target.copy(this._targetEnd);let n=!t||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(n)}zoom(e,t=!1){return this.zoomTo(this._zoomEnd+e,t)}zoomTo(e,t=!1){this._isUserControllingZoom=!1,this._zoomEnd=Ui(e,this.minZoom,this.maxZoom),this._needsUpdate=!0,t||(this._zoom=this._zoomEnd);let n=!t||Lt(this._zoom,this._zoomEnd,this.restThreshold);return this._changedZoom=0,this._createOnRestPromise(n)}pan(e,t,n=!1){return console.warn("`pan` has been renamed to `truck`"),this.truck(e,t,n)}truck(e,t,n=!1){this._camera.updateMatrix(),hs.setFromMatrixColumn(this._camera.matrix,0),ds.setFromMatrixColumn(this._camera.matrix,1),hs.multiplyScalar(e),ds.multiplyScalar(-t);let s=tt.copy(hs).add(ds),r=bt.copy(this._targetEnd).add(s);return this.moveTo(r.x,r.y,r.z,n)}forward(e,t=!1){tt.setFromMatrixColumn(this._camera.matrix,0),tt.crossVectors(this._camera.up,tt),tt.multiplyScalar(e);let n=bt.copy(this._targetEnd).add(tt);return this.moveTo(n.x,n.y,n.z,t)}elevate(e,t=!1){return tt.copy(this._camera.up).multiplyScalar(e),this.moveTo(this._targetEnd.x+tt.x,this._targetEnd.y+tt.y,this._targetEnd.z+tt.z,t)}moveTo(e,t,n,s=!1){this._isUserControllingTruck=!1;let r=tt.set(e,t,n).sub(this._targetEnd);this._encloseToBoundary(this._targetEnd,r,this.boundaryFriction),this._needsUpdate=!0,s||this._target.copy(this._targetEnd);let o=!s||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(o)}lookInDirectionOf(e,t,n,s=!1){let a=tt.set(e,t,n).sub(this._targetEnd).normalize().multiplyScalar(-this._sphericalEnd.radius).add(this._targetEnd);return this.setPosition(a.x,a.y,a.z,s)}fitToBox(e,t,{cover:n=!1,paddingLeft:s=0,paddingRight:r=0,paddingBottom:o=0,paddingTop:a=0}={}){let l=[],c=e.isBox3?xa.copy(e):xa.setFromObject(e);c.isEmpty()&&(console.warn("camera-controls: fitTo() cannot be used with an empty box. Aborting"),Promise.resolve());let u=vy(this._sphericalEnd.theta,yy),h=vy(this._sphericalEnd.phi,yy);l.push(this.rotateTo(u,h,t));let d=tt.setFromSpherical(this._sphericalEnd).normalize(),f=Ty.setFromUnitVectors(d,Fm),m=Lt(Math.abs(d.y),1);m&&f.multiply(Bm.setFromAxisAngle(pd,u)),f.multiply(this._yAxisUpSpaceInverse);let y=Ey.makeEmpty();bt.copy(c.min).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.min).setX(c.max.x).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.min).setY(c.max.y).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.max).setZ(c.min.z).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.min).setZ(c.max.z).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.max).setY(c.min.y).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.max).setX(c.min.x).applyQuaternion(f),y.expandByPoint(bt),bt.copy(c.max).applyQuaternion(f),y.expandByPoint(bt),y.min.x-=s,y.min.y-=o,y.max.x+=r,y.max.y+=a,f.setFromUnitVectors(Fm,d),m&&f.premultiply(Bm.invert()),f.premultiply(this._yAxisUpSpace);let g=y.getSize(tt),_=y.getCenter(bt).applyQuaternion(f);if($r(this._camera)){let v=this.getDistanceToFitBox(g.x,g.y,g.z,n);l.push(this.moveTo(_.x,_.y,_.z,t)),l.push(this.dollyTo(v,t)),l.push(this.setFocalOffset(0,0,0,t))}else if(ur(this._camera)){let v=this._camera,M=v.right-v.left,b=v.top-v.bottom,w=n?Math.max(M/g.x,b/g.y):Math.min(M/g.x,b/g.y);l.push(this.moveTo(_.x,_.y,_.z,t)),l.push(this.zoomTo(w,t)),l.push(this.setFocalOffset(0,0,0,t))}return Promise.all(l)}fitToSphere(e,t){let n=[],r="isObject3D"in e?i.createBoundingSphere(e,km):km.copy(e);if(n.push(this.moveTo(r.center.x,r.center.y,r.center.z,t)),$r(this._camera)){let o=this.getDistanceToFitSphere(r.radius);n.push(this.dollyTo(o,t))}else if(ur(this._camera)){let o=this._camera.right-this._camera.left,a=this._camera.top-this._camera.bottom,l=2*r.radius,c=Math.min(o/l,a/l);n.push(this.zoomTo(c,t))}return n.push(this.setFocalOffset(0,0,0,t)),Promise.all(n)}setLookAt(e,t,n,s,r,o,a=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=ma.NONE,this._changedDolly=0;let l=bt.set(s,r,o),c=tt.set(e,t,n);this._targetEnd.copy(l),this._sphericalEnd.setFromVector3(c.sub(l).applyQuaternion(this._yAxisUpSpace)),this._needsUpdate=!0,a||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let u=!a||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold)&&Lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&Lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(u)}lerp(e,t,n,s=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=ma.NONE,this._changedDolly=0;let r=tt.set(...e.target);if("spherical"in e)di.set(...e.spherical);else{let h=bt.set(...e.position);di.setFromVector3(h.sub(r).applyQuaternion(this._yAxisUpSpace))}let o=ga.set(...t.target);if("spherical"in t)_a.set(...t.spherical);else{let h=bt.set(...t.position);_a.setFromVector3(h.sub(o).applyQuaternion(this._yAxisUpSpace))}this._targetEnd.copy(r.lerp(o,n));let a=_a.theta-di.theta,l=_a.phi-di.phi,c=_a.radius-di.radius;this._sphericalEnd.set(di.radius+c*n,di.phi+l*n,di.theta+a*n),this._needsUpdate=!0,s||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let u=!s||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold)&&Lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&Lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(u)}lerpLookAt(e,t,n,s,r,o,a,l,c,u,h,d,f,m=!1){return this.lerp({position:[e,t,n],target:[s,r,o]},{position:[a,l,c],target:[u,h,d]},f,m)}setPosition(e,t,n,s=!1){return this.setLookAt(e,t,n,this._targetEnd.x,this._targetEnd.y,this._targetEnd.z,s)}setTarget(e,t,n,s=!1){let r=this.getPosition(tt),o=this.setLookAt(r.x,r.y,r.z,e,t,n,s);return this._sphericalEnd.phi=Ui(this._sphericalEnd.phi,this.minPolarAngle,this.maxPolarAngle),o}setFocalOffset(e,t,n,s=!1){this._isUserControllingOffset=!1,this._focalOffsetEnd.set(e,t,n),this._needsUpdate=!0,s||this._focalOffset.copy(this._focalOffsetEnd);let r=!s||Lt(this._focalOffset.x,this._focalOffsetEnd.x,this.restThreshold)&&Lt(this._focalOffset.y,this._focalOffsetEnd.y,this.restThreshold)&&Lt(this._focalOffset.z,this._focalOffsetEnd.z,this.restThreshold);return this._createOnRestPromise(r)}setOrbitPoint(e,t,n){this._camera.updateMatrixWorld(),hs.setFromMatrixColumn(this._camera.matrixWorldInverse,0),ds.setFromMatrixColumn(this._camera.matrixWorldInverse,1),Kr.setFromMatrixColumn(this._camera.matrixWorldInverse,2);let s=tt.set(e,t,n),r=s.distanceTo(this._camera.position),o=s.sub(this._camera.position);hs.multiplyScalar(o.x),ds.multiplyScalar(o.y),Kr.multiplyScalar(o.z),tt.copy(hs).add(ds).add(Kr),tt.z=tt.z+r,this.dollyTo(r,!1),this.setFocalOffset(-tt.x,tt.y,-tt.z,!1),this.moveTo(e,t,n,!1)}setBoundary(e){if(!e){this._boundary.min.set(-1/0,-1/0,-1/0),this._boundary.max.set(1/0,1/0,1/0),this._needsUpdate=!0;return}this._boundary.copy(e),this._boundary.clampPoint(this._targetEnd,this._targetEnd),this._needsUpdate=!0}setViewport(e,t,n,s){if(e===null){this._viewport=null;return}this._viewport=this._viewport||new $e.Vector4,typeof e=="number"?this._viewport.set(e,t,n,s):this._viewport.copy(e)}getDistanceToFitBox(e,t,n,s=!1){if(Dm(this._camera,"getDistanceToFitBox"))return this._spherical.radius;let r=e/t,o=this._camera.getEffectiveFOV()*Yl,a=this._camera.aspect;return((s?r>a:r<a)?t:e/a)*.5/Math.tan(o*.5)+n*.5}getDistanceToFitSphere(e){if(Dm(this._camera,"getDistanceToFitSphere"))return this._spherical.radius;let t=this._camera.getEffectiveFOV()*Yl,n=Math.atan(Math.tan(t*.5)*this._camera.aspect)*2,s=1<this._camera.aspect?t:n;return e/Math.sin(s*.5)}getTarget(e,t=!0){return(e&&e.isVector3?e:new $e.Vector3).copy(t?this._targetEnd:this._target)}getPosition(e,t=!0){return(e&&e.isVector3?e:new $e.Vector3).setFromSpherical(t?this._sphericalEnd:this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(t?this._targetEnd:this._target)}getSpherical(e,t=!0){return(e||new $e.Spherical).copy(t?this._sphericalEnd:this._spherical)}getFocalOffset(e,t=!0){return(e&&e.isVector3?e:new $e.Vector3).copy(t?this._focalOffsetEnd:this._focalOffset)}normalizeRotations(){return this._sphericalEnd.theta=(this._sphericalEnd.theta%cr+cr)%cr,this._sphericalEnd.theta>Math.PI&&(this._sphericalEnd.theta-=cr),this._spherical.theta+=cr*Math.round((this._sphericalEnd.theta-this._spherical.theta)/cr),this}stop(){this._focalOffset.copy(this._focalOffsetEnd),this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd),this._zoom=this._zoomEnd}reset(e=!1){if(!Lt(this._camera.up.x,this._cameraUp0.x)||!Lt(this._camera.up.y,this._cameraUp0.y)||!Lt(this._camera.up.z,this._cameraUp0.z)){this._camera.up.copy(this._cameraUp0);let n=this.getPosition(tt);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}let t=[this.setLookAt(this._position0.x,this._position0.y,this._position0.z,this._target0.x,this._target0.y,this._target0.z,e),this.setFocalOffset(this._focalOffset0.x,this._focalOffset0.y,this._focalOffset0.z,e),this.zoomTo(this._zoom0,e)];return Promise.all(t)}saveState(){this._cameraUp0.copy(this._camera.up),this.getTarget(this._target0),this.getPosition(this._position0),this._zoom0=this._zoom,this._focalOffset0.copy(this._focalOffset)}updateCameraUp(){this._yAxisUpSpace.setFromUnitVectors(this._camera.up,pd),this._yAxisUpSpaceInverse.copy(this._yAxisUpSpace).invert()}applyCameraUp(){let e=tt.subVectors(this._target,this._camera.position).normalize(),t=bt.crossVectors(e,this._camera.up);this._camera.up.crossVectors(t,e).normalize(),this._camera.updateMatrixWorld();let n=this.getPosition(tt);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}update(e){let t=this._sphericalEnd.theta-this._spherical.theta,n=this._sphericalEnd.phi-this._spherical.phi,s=this._sphericalEnd.radius-this._spherical.radius,r=My.subVectors(this._targetEnd,this._target),o=wy.subVectors(this._focalOffsetEnd,this._focalOffset),a=this._zoomEnd-this._zoom;if(Xt(t))this._thetaVelocity.value=0,this._spherical.theta=this._sphericalEnd.theta;else{let h=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.theta=dd(this._spherical.theta,this._sphericalEnd.theta,this._thetaVelocity,h,1/0,e),this._needsUpdate=!0}if(Xt(n))this._phiVelocity.value=0,this._spherical.phi=this._sphericalEnd.phi;else{let h=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.phi=dd(this._spherical.phi,this._sphericalEnd.phi,this._phiVelocity,h,1/0,e),this._needsUpdate=!0}if(Xt(s))this._radiusVelocity.value=0,this._spherical.radius=this._sphericalEnd.radius;else{let h=this._isUserControllingDolly?this.draggingSmoothTime:this.smoothTime;this._spherical.radius=dd(this._spherical.radius,this._sphericalEnd.radius,this._radiusVelocity,h,this.maxSpeed,e),this._needsUpdate=!0}if(Xt(r.x)&&Xt(r.y)&&Xt(r.z))this._targetVelocity.set(0,0,0),this._target.copy(this._targetEnd);else{let h=this._isUserControllingTruck?this.draggingSmoothTime:this.smoothTime;by(this._target,this._targetEnd,this._targetVelocity,h,this.maxSpeed,e,this._target),this._needsUpdate=!0}if(Xt(o.x)&&Xt(o.y)&&Xt(o.z))this._focalOffsetVelocity.set(0,0,0),this._focalOffset.copy(this._focalOffsetEnd);else{let h=this._isUserControllingOffset?this.draggingSmoothTime:this.smoothTime;by(this._focalOffset,this._focalOffsetEnd,this._focalOffsetVelocity,h,this.maxSpeed,e,this._focalOffset),this._needsUpdate=!0}if(Xt(a))this._zoomVelocity.value=0,this._zoom=this._zoomEnd;else{let h=this._isUserControllingZoom?this.draggingSmoothTime:this.smoothTime;this._zoom=dd(this._zoom,this._zoomEnd,this._zoomVelocity,h,1/0,e)}if(this.dollyToCursor){if($r(this._camera)&&this._changedDolly!==0){let h=this._spherical.radius-this._lastDistance,d=this._camera,f=this._getCameraDirection(Zl),m=tt.copy(f).cross(d.up).normalize();m.lengthSq()===0&&(m.x=1);let y=bt.crossVectors(m,f),g=this._sphericalEnd.radius*Math.tan(d.getEffectiveFOV()*Yl*.5),v=(this._sphericalEnd.radius-h-this._sphericalEnd.radius)/this._sphericalEnd.radius,M=ga.copy(this._targetEnd).add(m.multiplyScalar(this._dollyControlCoord.x*g*d.aspect)).add(y.multiplyScalar(this._dollyControlCoord.y*g)),b=tt.copy(this._targetEnd).lerp(M,v),w=this._lastDollyDirection===ma.IN&&this._spherical.radius<=this.minDistance,x=this._lastDollyDirection===ma.OUT&&this.maxDistance<=this._spherical.radius;if(this.infinityDolly&&(w||x)){this._sphericalEnd.radius-=h,this._spherical.radius-=h;let S=bt.copy(f).multiplyScalar(-h);b.add(S)}this._boundary.clampPoint(b,b);let p=bt.subVectors(b,this._targetEnd);this._targetEnd.copy(b),this._target.add(p),this._changedDolly-=h,Xt(this._changedDolly)&&(this._changedDolly=0)}else if(ur(this._camera)&&this._changedZoom!==0){let h=this._zoom-this._lastZoom,d=this._camera,f=tt.set(this._dollyControlCoord.x,this._dollyControlCoord.y,(d.near+d.far)/(d.near-d.far)).unproject(d),m=bt.set(0,0,-1).applyQuaternion(d.quaternion),y=ga.copy(f).add(m.multiplyScalar(-f.dot(d.up))),_=-(this._zoom-h-this._zoom)/this._zoom,v=this._getCameraDirection(Zl),M=this._targetEnd.dot(v),b=tt.copy(this._targetEnd).lerp(y,_),w=b.dot(v),x=v.multiplyScalar(w-M);b.sub(x),this._boundary.clampPoint(b,b);let p=bt.subVectors(b,this._targetEnd);this._targetEnd.copy(b),this._target.add(p),this._changedZoom-=h,Xt(this._changedZoom)&&(this._changedZoom=0)}}this._camera.zoom!==this._zoom&&(this._camera.zoom=this._zoom,this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0),this._dragNeedsUpdate=!0;let l=this._collisionTest();this._spherical.radius=Math.min(this._spherical.radius,l),this._spherical.makeSafe(),this._camera.position.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(this._target),this._camera.lookAt(this._target),(!Xt(this._focalOffset.x)||!Xt(this._focalOffset.y)||!Xt(this._focalOffset.z))&&(hs.setFromMatrixColumn(this._camera.matrix,0),ds.setFromMatrixColumn(this._camera.matrix,1),Kr.setFromMatrixColumn(this._camera.matrix,2),hs.multiplyScalar(this._focalOffset.x),ds.multiplyScalar(-this._focalOffset.y),Kr.multiplyScalar(this._focalOffset.z),tt.copy(hs).add(ds).add(Kr),this._camera.position.add(tt),this._camera.updateMatrixWorld()),this._boundaryEnclosesCamera&&this._encloseToBoundary(this._camera.position.copy(this._target),tt.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse),1);let u=this._needsUpdate;return u&&!this._updatedLastTime?(this._hasRested=!1,this.dispatchEvent({type:"wake"}),this.dispatchEvent({type:"update"})):u?(this.dispatchEvent({type:"update"}),Xt(t,this.restThreshold)&&Xt(n,this.restThreshold)&&Xt(s,this.restThreshold)&&Xt(r.x,this.restThreshold)&&Xt(r.y,this.restThreshold)&&Xt(r.z,this.restThreshold)&&Xt(o.x,this.restThreshold)&&Xt(o.y,this.restThreshold)&&Xt(o.z,this.restThreshold)&&Xt(a,this.restThreshold)&&!this._hasRested&&(this._hasRested=!0,this.dispatchEvent({type:"rest"}))):!u&&this._updatedLastTime&&this.dispatchEvent({type:"sleep"}),this._lastDistance=this._spherical.radius,this._lastZoom=this._zoom,this._updatedLastTime=u,this._needsUpdate=!1,u}toJSON(){return JSON.stringify({enabled:this._enabled,minDistance:this.minDistance,maxDistance:$l(this.maxDistance),minZoom:this.minZoom,maxZoom:$l(this.maxZoom),minPolarAngle:this.minPolarAngle,maxPolarAngle:$l(this.maxPolarAngle),minAzimuthAngle:$l(this.minAzimuthAngle),maxAzimuthAngle:$l(this.maxAzimuthAngle),smoothTime:this.smoothTime,draggingSmoothTime:this.draggingSmoothTime,dollySpeed:this.dollySpeed,truckSpeed:this.truckSpeed,dollyToCursor:this.dollyToCursor,target:this._targetEnd.toArray(),position:tt.setFromSpherical(this._sphericalEnd).add(this._targetEnd).toArray(),zoom:this._zoomEnd,focalOffset:this._focalOffsetEnd.toArray(),target0:this._target0.toArray(),position0:this._position0.toArray(),zoom0:this._zoom0,focalOffset0:this._focalOffset0.toArray()})}fromJSON(e,t=!1){let n=JSON.parse(e);this.enabled=n.enabled,this.minDistance=n.minDistance,this.maxDistance=Kl(n.maxDistance),this.minZoom=n.minZoom,this.maxZoom=Kl(n.maxZoom),this.minPolarAngle=n.minPolarAngle,this.maxPolarAngle=Kl(n.maxPolarAngle),this.minAzimuthAngle=Kl(n.minAzimuthAngle),this.maxAzimuthAngle=Kl(n.maxAzimuthAngle),this.smoothTime=n.smoothTime,this.draggingSmoothTime=n.draggingSmoothTime,this.dollySpeed=n.dollySpeed,this.truckSpeed=n.truckSpeed,this.dollyToCursor=n.dollyToCursor,this._target0.fromArray(n.target0),this._position0.fromArray(n.position0),this._zoom0=n.zoom0,this._focalOffset0.fromArray(n.focalOffset0),this.moveTo(n.target[0],n.target[1],n.target[2],t),di.setFromVector3(tt.fromArray(n.position).sub(this._targetEnd).applyQuaternion(this._yAxisUpSpace)),this.rotateTo(di.theta,di.phi,t),this.dollyTo(di.radius,t),this.zoomTo(n.zoom,t),this.setFocalOffset(n.focalOffset[0],n.focalOffset[1],n.focalOffset[2],t),this._needsUpdate=!0}connect(e){if(this._domElement){console.warn("camera-controls is already connected.");return}e.setAttribute("data-camera-controls-version",FA),this._addAllEventListeners(e),this._getClientRect(this._elementRect)}disconnect(){this.cancel(),this._removeAllEventListeners(),this._domElement&&(this._domElement.removeAttribute("data-camera-controls-version"),this._domElement=void 0)}dispose(){this.removeAllEventListeners(),this.disconnect()}_getTargetDirection(e){return e.setFromSpherical(this._spherical).divideScalar(this._spherical.radius).applyQuaternion(this._yAxisUpSpaceInverse)}_getCameraDirection(e){return this._getTargetDirection(e).negate()}_findPointerById(e){return this._activePointers.find(t=>t.pointerId===e)}_findPointerByMouseButton(e){return this._activePointers.find(t=>t.mouseButton===e)}_disposePointer(e){this._activePointers.splice(this._activePointers.indexOf(e),1)}_encloseToBoundary(e,t,n){let s=t.lengthSq();if(s===0)return e;let r=bt.copy(t).add(e),a=this._boundary.clampPoint(r,ga).sub(r),l=a.lengthSq();if(l===0)return e.add(t);if(l===s)return e;if(n===0)return e.add(t).add(a);{let c=1+n*l/t.dot(a);return e.add(bt.copy(t).multiplyScalar(c)).add(a.multiplyScalar(1-n))}}_updateNearPlaneCorners(){if($r(this._camera)){let e=this._camera,t=e.near,n=e.getEffectiveFOV()*Yl,s=Math.tan(n*.5)*t,r=s*e.aspect;this._nearPlaneCorners[0].set(-r,-s,0),this._nearPlaneCorners[1].set(r,-s,0),this._nearPlaneCorners[2].set(r,s,0),this._nearPlaneCorners[3].set(-r,s,0)}else if(ur(this._camera)){let e=this._camera,t=1/e.zoom,n=e.left*t,s=e.right*t,r=e.top*t,o=e.bottom*t;this._nearPlaneCorners[0].set(n,r,0),this._nearPlaneCorners[1].set(s,r,0),this._nearPlaneCorners[2].set(s,o,0),this._nearPlaneCorners[3].set(n,o,0)}}_collisionTest(){let e=1/0;if(!(this.colliderMeshes.length>=1)||Dm(this._camera,"_collisionTest"))return e;let n=this._getTargetDirection(Zl);zm.lookAt(Sy,n,this._camera.up);for(let s=0;s<4;s++){let r=bt.copy(this._nearPlaneCorners[s]);r.applyMatrix4(zm);let o=ga.addVectors(this._target,r);md.set(o,n),md.far=this._spherical.radius+1;let a=md.intersectObjects(this.colliderMeshes);a.length!==0&&a[0].distance<e&&(e=a[0].distance)}return e}_getClientRect(e){if(!this._domElement)return;let t=this._domElement.getBoundingClientRect();return e.x=t.left,e.y=t.top,this._viewport?(e.x+=this._viewport.x,e.y+=t.height-this._viewport.w-this._viewport.y,e.width=this._viewport.z,e.height=this._viewport.w):(e.width=t.width,e.height=t.height),e}_createOnRestPromise(e){return e?Promise.resolve():(this._hasRested=!1,this.dispatchEvent({type:"transitionstart"}),new Promise(t=>{let n=()=>{this.removeEventListener("rest",n),t()};this.addEventListener("rest",n)}))}_addAllEventListeners(e){}_removeAllEventListeners(){}get dampingFactor(){return console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead."),0}set dampingFactor(e){console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead.")}get draggingDampingFactor(){return console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead."),0}set draggingDampingFactor(e){console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead.")}static createBoundingSphere(e,t=new $e.Sphere){let n=t,s=n.center;xa.makeEmpty(),e.traverseVisible(o=>{o.isMesh&&xa.expandByObject(o)}),xa.getCenter(s);let r=0;return e.traverseVisible(o=>{if(!o.isMesh)return;let a=o;if(!a.geometry)return;let l=a.geometry.clone();l.applyMatrix4(a.matrixWorld);let u=l.attributes.position;for(let h=0,d=u.count;h<d;h++)tt.fromBufferAttribute(u,h),r=Math.max(r,s.distanceToSquared(tt))}),n.radius=Math.sqrt(r),n}};var Hm=2e3,BA=[{toward:new P(-.75,.55,.38).normalize(),strength:1.2,width:.7},{toward:new P(.8,.42,-.35).normalize(),strength:.5,width:.8},{toward:new P(.1,1,-.15).normalize(),strength:.4,width:.8}];function zA(i){let e=i.y,t=e>0?.24+.14*e**.6:.24-.14*(-e)**.5,n=0;for(let{toward:s,strength:r,width:o}of BA){let a=i.dot(s);a>o&&(n+=r*((a-o)/(1-o))**.5)}return[t*(1-.05*e)+n,t+n*.99,t*(1+.09*e)+n*.96]}function Ry(){let i=new Fr,e=[],t=4*Math.PI/Hm;for(let n=0;n<Hm;n+=1){let s=1-(2*n+1)/Hm,r=Math.sqrt(1-s*s),o=n*Math.PI*(3-Math.sqrt(5)),a=new P(r*Math.cos(o),s,r*Math.sin(o)),l=new P(...zA(a));Fr.getBasisAt(a,e);for(let c=0;c<9;c+=1)i.coefficients[c].addScaledVector(l,e[c]*t)}return new pl(i)}var VA=`
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
}`,Gm={polygonOffset:!0,polygonOffsetFactor:3,polygonOffsetUnits:4},gd=class{mesh;step=1;constructor(){let e={middle:{value:[0,0]},size:{value:1},step1:{value:1},reach:{value:1},strength:{value:.5},ink:{value:new De("#5b6b73")}},t=new dn({uniforms:e,vertexShader:VA,fragmentShader:HA,transparent:!0,depthWrite:!1,side:an,...Gm});this.mesh=new Pt(new Ji(1,1),t),this.mesh.rotation.x=-Math.PI/2,this.mesh.renderOrder=-2,this.mesh.frustumCulled=!1}place(e,t,n){let{uniforms:s}=this.mesh.material,r=t*4.5;this.step=10**Math.floor(Math.log10(t/2.5));let o=this.step*10,[a,l]=[Math.round(e.x/o)*o,Math.round(e.z/o)*o];this.mesh.position.set(a,n-.004*t,l),this.mesh.scale.setScalar(2*r),Object.assign(s.middle,{value:[0,0]}),s.size.value=2*r,s.step1.value=this.step,s.reach.value=r}style(e,t){this.mesh.material.uniforms.ink.value.set(e),this.mesh.material.uniforms.strength.value=t}};var va=256,GA=1.5,WA=`
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
}`,_d=class{plane;targets=[new zn(va,va),new zn(va,va)];camera=new Ds(-1,1,1,-1,0,1);dark=new dn({vertexShader:WA,fragmentShader:XA,side:an,blending:es,uniforms:{ground:{value:0},reach:{value:1}}});blur=new dn({vertexShader:qA,fragmentShader:YA,depthTest:!1,depthWrite:!1,blending:es,uniforms:{picture:{value:null},step:{value:[0,0]}}});page=new Pt(new Ji(1,1),this.blur);constructor(){let e=new xi({map:this.targets[0].texture,transparent:!0,depthWrite:!1,opacity:.5,toneMapped:!1,...Gm});this.plane=new Pt(new Ji(1,1),e),this.plane.rotation.x=-Math.PI/2,this.plane.renderOrder=-1,this.page.frustumCulled=!1}update(e,t,n,s,r){let o=[],a=!1;if(n.traverse(w=>{w.userData.castsShadow?a||=w.visible:("isMesh"in w||"isLine"in w||"isPoints"in w)&&o.push(w)}),this.plane.visible=a,!a)return;let[l,c]=[s.max.x-s.min.x,s.max.z-s.min.z],u=Math.max(l,c)*GA||1,h=Math.max(s.max.y-s.min.y,.35*u),[d,f]=[(s.min.x+s.max.x)/2,(s.min.z+s.max.z)/2],m=s.min.y;this.plane.position.set(d,m-.002*u,f),this.plane.scale.setScalar(u);let{camera:y,dark:g,targets:_}=this;Object.assign(y,{left:-u/2,right:u/2,top:u/2,bottom:-u/2,near:0,far:2*h+.1*u}),y.position.set(d,m+2*h,f),y.up.set(0,0,-1),y.lookAt(d,m,f),y.updateProjectionMatrix(),g.uniforms.ground.value=m,g.uniforms.reach.value=h;let v=[...r,this.plane,...o].map(w=>[w,w.visible]);v.forEach(([w])=>{w.visible=!1});let M=e.getRenderTarget(),b=t.background;t.background=null,t.overrideMaterial=g,e.setRenderTarget(_[0]),e.setScissorTest(!1),e.clear(),e.render(t,y),t.overrideMaterial=null,t.background=b,v.forEach(([w,x])=>{w.visible=x}),this.smear(e,_[0],_[1],[1.1/va,0]),this.smear(e,_[1],_[0],[0,1.1/va]),e.setRenderTarget(M)}smear(e,t,n,s){this.blur.uniforms.picture.value=t.texture,this.blur.uniforms.step.value=s,e.setRenderTarget(n),e.clear(),e.render(this.page,this.camera)}style(e){this.plane.material.opacity=e}};ya.install({THREE:{Box3:et,Matrix4:Ce,Quaternion:Kn,Raycaster:tr,Sphere:zt,Spherical:_l,Vector2:Fe,Vector3:P,Vector4:ct}});var Xm=30,$A=2,xd=class{constructor(e,t){this.canvas=e;this.insets=t;this.renderer=ZA(e),this.shadow=new _d,this.scene.add(this.model,this.grid.mesh,this.shadow.plane);let n=new Ur(16775406,1.8);n.position.set(-3.4,2.2,.6),this.scene.add(n,Ry()),this.controls=new ya(this.camera,e),Object.assign(this.controls,{smoothTime:.12,draggingSmoothTime:.05,minPolarAngle:.001,maxPolarAngle:Math.PI-.001,dollyToCursor:!0});let{ACTION:s}=ya;Object.assign(this.controls.mouseButtons,{left:s.ROTATE,right:s.TRUCK,middle:s.TRUCK,wheel:s.NONE});for(let r of["controlstart","control","transitionstart"])this.controls.addEventListener(r,()=>this.wake());this.controls.addEventListener("rest",()=>this.onRest()),e.addEventListener("wheel",r=>this.onWheel(r),{passive:!1}),e.addEventListener("webglcontextlost",r=>r.preventDefault()),e.addEventListener("webglcontextrestored",()=>this.invalidate()),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}canvas;insets;renderer;scene=new Ka;camera=new cn(Xm,1,.1,1e3);controls;model=new yn;grid=new gd;shadow;beforeDraw=()=>{};onDraw=()=>{};onRest=()=>{};content=()=>[];tiles=null;width=1;height=1;frames=0;dirty=!0;running=!1;last=0;sphere=new zt(new P,5);wasInside=!0;invalidate(){this.dirty=!0,this.wake()}wake(){this.running||(this.running=!0,this.last=performance.now(),requestAnimationFrame(e=>this.tick(e)))}tick(e){let t=Math.min(Math.max(e-this.last,1)/1e3,.1);this.last=e;let n=this.controls.update(t);(n||this.dirty)&&this.draw(),n||this.dirty||this.controls.active?requestAnimationFrame(s=>this.tick(s)):this.running=!1}draw(){this.dirty=!1,this.frames+=1;let{renderer:e,camera:t}=this,n=t.position.distanceTo(this.sphere.center);t.near=Math.max(n-4*this.sphere.radius,n*.004),t.far=n+40*this.sphere.radius,t.updateProjectionMatrix(),t.updateMatrixWorld(),this.beforeDraw(),e&&(this.tiles?this.drawTiles(e,this.tiles):(e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.render(this.scene,t))),this.onDraw()}drawTiles(e,t){let n=this.canvas.getBoundingClientRect();e.setScissorTest(!1),e.clear(),e.setScissorTest(!0);let s=[this.model,this.grid.mesh,this.shadow.plane].map(r=>[r,r.visible]);s.forEach(([r])=>{r.visible=!1});for(let{element:r,group:o}of t){let a=r.getBoundingClientRect(),l=Math.max(a.top,n.top),c=Math.min(a.bottom,n.bottom);c<=l||a.width<1||(e.setViewport(a.left-n.left,n.bottom-a.bottom,a.width,a.height),e.setScissor(a.left-n.left,n.bottom-c,a.width,c-l),this.camera.aspect=a.width/a.height,this.camera.fov=Wm(this.camera.aspect),this.camera.updateProjectionMatrix(),this.scene.add(o),e.render(this.scene,this.camera),this.scene.remove(o))}s.forEach(([r,o])=>{r.visible=o}),e.setScissorTest(!1),this.shape()}async picture(e,t){let{renderer:n}=this;if(!n)throw new Error("there is no picture without WebGL 2");let s=n.getPixelRatio();n.setPixelRatio(e),n.setSize(this.width,this.height,!1),this.scene.background=t===null?null:new De(t),this.draw();let r=await new Promise(o=>{this.canvas.toBlob(o,"image/png")});if(this.scene.background=null,n.setPixelRatio(s),n.setSize(this.width,this.height,!1),this.draw(),!r)throw new Error("the browser makes no picture of this size");return r}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.width=e,this.height=t,this.renderer&&(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,$A)),this.renderer.setSize(e,t,!1)),this.shape(),this.wasInside&&!this.allInside()&&this.fit(!1),this.draw())}shape(){this.camera.aspect=this.width/this.height,this.camera.fov=Wm(this.camera.aspect),this.camera.updateProjectionMatrix()}measure(){let e=this.content(),t=new et;e.forEach(n=>t.expandByPoint(new P(...n))),t.isEmpty()&&t.set(new P(-5,0,-5),new P(5,0,5)),t.getBoundingSphere(this.sphere),this.sphere.radius===0&&(this.sphere.radius=1),this.grid.place(this.sphere.center,this.sphere.radius,t.min.y),this.renderer&&this.shadow.update(this.renderer,this.scene,this.model,t,[this.grid.mesh]),this.invalidate()}get radius(){return this.sphere.radius}get centre(){return this.sphere.center}fit(e,t){let n=this.content(),s=t?new P(...t):this.camera.position.clone().sub(this.controls.getTarget(new P));s.lengthSq()===0&&s.set(.6,.55,.8),s.normalize();let r=new P(0,1,0).cross(s);r.lengthSq()<1e-9&&r.set(1,0,0),r.normalize();let o=s.clone().cross(r),a=n.length>0?n.map(A=>new P(...A).sub(this.sphere.center)):KA(this.sphere.radius),{top:l,right:c,bottom:u,left:h}=this.insets(),f=2*Math.tan(Wm(this.width/this.height)*Math.PI/360)/this.height,m=Math.max(this.width-h-c,this.width/4)*f/2,y=Math.max(this.height-l-u,this.height/4)*f/2,g=a.map(A=>A.dot(r)),_=a.map(A=>A.dot(o)),v=a.map(A=>A.dot(s)),M=this.sphere.radius,b=0,w=0;for(let A=0;A<6;A+=1){M=0;for(let L=0;L<a.length;L+=1){let U=Math.max(Math.abs(g[L]-b)/m,Math.abs(_[L]-w)/y);M=Math.max(M,v[L]+U,v[L]+.02*this.sphere.radius)}let[E,C,I,D]=[1/0,-1/0,1/0,-1/0];for(let L=0;L<a.length;L+=1){let U=M-v[L];E=Math.min(E,(g[L]-b)/U),C=Math.max(C,(g[L]-b)/U),I=Math.min(I,(_[L]-w)/U),D=Math.max(D,(_[L]-w)/U)}b+=(E+C)/2*M,w+=(I+D)/2*M}M*=1.02;let x=(c-h)/2*f*M,p=(l-u)/2*f*M,S=this.sphere.center.clone().addScaledVector(r,b+x).addScaledVector(o,w+p);this.place({eye:S.clone().addScaledVector(s,M).toArray(),target:S.toArray()},e)}pose(){return{eye:this.controls.getPosition(new P).toArray(),target:this.controls.getTarget(new P).toArray()}}place({eye:e,target:t},n){let s=!n||matchMedia("(prefers-reduced-motion: reduce)").matches;this.controls.setLookAt(...e,...t,!s),s&&this.controls.update(0),this.invalidate()}look(e){this.fit(!0,e)}orbit(e,t){this.controls.rotate(e,t,!0),this.wake()}pan(e,t){let n=this.pixelAt(this.controls.getTarget(new P));this.controls.truck(-e*n,-t*n,!0),this.wake()}onWheel(e){e.preventDefault();let t=e.deltaMode===1?16:1,{x:n,y:s}=this.local(e);this.zoom(n,s,Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0016))))}zoom(e,t,n){let s=this.controls.getTarget(new P),r=this.controls.getPosition(new P),o=r.distanceTo(s)*n;if(o<this.sphere.radius*.001||o>this.sphere.radius*60)return;let a=this.ray(e,t),l=this.under(e,t),c;if(l)c=l;else{let u=s.clone().sub(r).normalize(),h=a.direction.dot(u);c=a.origin.clone().addScaledVector(a.direction,s.clone().sub(a.origin).dot(u)/h)}r.sub(c).multiplyScalar(n).add(c),s.sub(c).multiplyScalar(n).add(c),this.place({eye:r.toArray(),target:s.toArray()},!1),this.onRest()}under=()=>null;local(e){let t=this.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}project(e){let t=new P(...e).project(this.camera);return{x:(t.x+1)/2*this.width,y:(1-t.y)/2*this.height,visible:t.z<1}}ray(e,t){let n=new tr;return n.setFromCamera(new Fe(e/this.width*2-1,1-t/this.height*2),this.camera),n.ray}pixelAt(e){let t=this.camera.getWorldDirection(new P),n=e.clone().sub(this.camera.position).dot(t);return 2*Math.max(n,1e-9)*Math.tan(this.camera.fov*Math.PI/360)/this.height}onPlane(e,t,n,s){let{origin:r,direction:o}=this.ray(e,t),a=o.dot(s);if(Math.abs(a)<1e-6)return null;let l=n.clone().sub(r).dot(s)/a;return l<=0||l>60*this.sphere.radius+r.distanceTo(n)?null:r.clone().addScaledVector(o,l)}allInside(){return this.content().every(e=>{let{x:t,y:n,visible:s}=this.project(e);return s&&t>=0&&n>=0&&t<=this.width&&n<=this.height})}rememberWhetherAllIsSeen(){this.camera.updateMatrixWorld(),this.wasInside=this.allInside()}},Wm=i=>i>=1?Xm:Math.atan(Math.tan(Xm*Math.PI/360)/i)*360/Math.PI,KA=i=>[-1,1].flatMap(e=>[-1,1].map(t=>new P(e*i*.7,0,t*i*.7)));function ZA(i){let e=i.getContext("webgl2",{antialias:!0,alpha:!0,powerPreference:"high-performance"});if(!e)return null;let t=new wh({canvas:i,context:e,antialias:!0,alpha:!0});return t.setClearColor(0,0),t.toneMapping=yl,t.toneMappingExposure=1,t.debug.checkShaderErrors=!1,t}var hr={point:11,touch:24,edge:8,snap:12,align:7},Cy=4,JA=46,yd=class{constructor(e){this.host=e;let{canvas:t}=e.stage;this.marquee=document.createElement("div"),this.marquee.className="marquee",this.marquee.hidden=!0,t.parentElement.append(this.marquee),t.addEventListener("pointerdown",n=>this.press(n),{capture:!0}),t.addEventListener("pointermove",n=>this.glide(n)),t.addEventListener("pointerleave",()=>{this.busy||(this.hover=null,this.ghost=null,this.next=null,this.drawing&&e.label(null),this.refresh())}),t.addEventListener("contextmenu",n=>n.preventDefault()),t.addEventListener("keydown",n=>this.key(n)),e.stage.beforeDraw=()=>this.hints()}host;selection=[];mode="ground";snapping=!0;level=0;next=null;hover=null;ghost=null;busy=!1;marquee;get drawing(){return this.host.history.document.draft!==null}get only(){return this.selection.length===1?this.selection[0]:null}select(e){this.selection=e,this.refresh(),this.host.selectionChanged();let{only:t}=this,n=t&&this.host.lines[t.line];n&&this.host.announce(`${n.name}, point ${t.point+1} of ${n.points.length}: ${(Yt(n.points[t.point])??[]).map(s=>wt(s,6)).join(", ")}`)}prune(){let{lines:e}=this.host;this.selection=this.selection.filter(({line:t,point:n})=>n<(e[t]?.points.length??0)),this.hover=null,this.ghost=null}refresh(){let{sketch:e,stage:t,faulty:n}=this.host;e.mark(s=>s.line<0?4:this.selection.some(r=>zs(r,s))?2:n.has(`${s.line}/${s.point}`)?3:zs(this.hover,s)?1:0),t.invalidate()}step(e){let{lines:t}=this.host,n=t.flatMap((r,o)=>r.points.map((a,l)=>({line:o,point:l})));if(n.length===0)return;let s=n.findIndex(r=>zs(r,this.selection.at(-1)??null));this.select([n[s<0?e>0?0:n.length-1:(s+e+n.length)%n.length]])}nearestPoint(e,t,n){let{stage:s,sketch:r,surface:o}=this.host,a=null;if(r.places.forEach((f,m)=>{if(r.refs[m].line<0)return;let y=s.project(f),g=Math.hypot(y.x-e,y.y-t);y.visible&&g<=n&&(!a||g<a.distance)&&(a={ref:r.refs[m],distance:g,place:f})}),!a)return null;let{ref:l,place:c}=a;if(this.selection.some(f=>zs(f,l)))return l;let u=new P(...c),h=o.pick(s,s.project(c).x,s.project(c).y);return h&&h.distance<s.camera.position.distanceTo(u)-14*s.pixelAt(u)?null:l}nearestEdge(e,t){let{stage:n,lines:s,frame:r}=this.host,o=null;return s.forEach((a,l)=>{if(Mr(a)||a.name.startsWith("control"))return;let c=a.points.map(Yt),u=a.closed&&c.length>2?c.length:c.length-1;for(let h=0;h<u;h+=1){let d=c[h],f=c[(h+1)%c.length];if(!d||!f)continue;let m=n.project(r.toScene(d)),y=n.project(r.toScene(f)),g=(y.x-m.x)**2+(y.y-m.y)**2;if(!m.visible||!y.visible||g<900)continue;let _=((e-m.x)*(y.x-m.x)+(t-m.y)*(y.y-m.y))/g,v=Math.hypot(m.x+_*(y.x-m.x)-e,m.y+_*(y.y-m.y)-t);if(_<.08||_>.92||v>hr.edge||o&&v>=o.distance)continue;let M=this.alongEdge(d,f,e,t);o={line:l,after:h,distance:v,point:d.map((b,w)=>b+M*(f[w]-b))}}}),o}alongEdge(e,t,n,s){let{stage:r,frame:o}=this.host,a=new P(...o.toScene(e)),l=new P(...o.toScene(t)).sub(a),{origin:c,direction:u}=r.ray(n,s),h=a.clone().sub(c),d=l.dot(l),f=l.dot(u),m=l.dot(h),y=u.dot(h),g=d-f*f;return g>1e-12*d?Math.min(.98,Math.max(.02,(f*y-m)/g)):.5}arrow(){let{only:e}=this,{stage:t,frame:n,lines:s}=this.host,r=e&&Yt(s[e.line]?.points[e.point]);if(!r||this.drawing)return null;let o=new P(...n.toScene(r)),a=JA*t.pixelAt(o);return{from:o,to:o.clone().addScaledVector(this.liftAxis(),a)}}liftAxis(){let{camera:e}=this.host.stage,t=e.getWorldDirection(new P);return Math.abs(t.y)>.94?new P(0,1,0).applyQuaternion(e.quaternion):new P(0,1,0)}onArrow(e,t){let n=this.arrow();if(!n)return!1;let s=this.host.stage.project(n.from.toArray()),r=this.host.stage.project(n.to.toArray()),o=Math.hypot(r.x-s.x,r.y-s.y);if(o<12)return!1;let a=((e-s.x)*(r.x-s.x)+(t-s.y)*(r.y-s.y))/(o*o),l=Math.abs((e-s.x)*(r.y-s.y)-(t-s.y)*(r.x-s.x))/o;return a>.4&&a<1.2&&l<8}glide(e){if(this.busy||e.buttons!==0||this.host.fixed)return;let{stage:t,host:n}={stage:this.host.stage,host:this.host},{x:s,y:r}=t.local(e);if(this.drawing){this.next=this.snap(s,r,e.altKey),this.showNext(s,r),t.canvas.style.cursor="crosshair",t.invalidate();return}let o=this.onArrow(s,r),a=o?null:this.nearestPoint(s,r,hr.point),l=o||a?null:this.nearestEdge(s,r),c=!zs(a,this.hover)||JSON.stringify(l)!==JSON.stringify(this.ghost);this.hover=a,this.ghost=l,t.canvas.style.cursor=o?"ns-resize":a?"grab":l?"copy":"",c&&(this.refresh(),n.selectionChanged())}press(e){let{stage:t,host:n}={stage:this.host.stage,host:this.host};if(t.canvas.focus({preventScroll:!0}),e.button!==0||this.busy||this.host.fixed)return;let s=t.local(e),r=e.pointerType==="touch";if(this.drawing){this.onRelease(e,(l,c,u,h)=>{u<=Cy&&this.place(this.snap(l,c,h.altKey))});return}if(this.onArrow(s.x,s.y)){this.drag(e,this.only,"height");return}let o=this.nearestPoint(s.x,s.y,r?hr.touch:hr.point);if(o){this.drag(e,o,this.mode);return}let a=r?null:this.nearestEdge(s.x,s.y);if(a&&!e.shiftKey){n.history.begin(),this.insertAt(a.line,a.after,this.tidy(a.point)),n.changed(!0),this.drag(e,{line:a.line,point:a.after+1},this.mode);return}if(e.shiftKey){this.selectBox(e);return}this.onRelease(e,(l,c,u)=>{if(u>Cy)return;let h=n.surface.pick(t,l,c);h?n.read(h.point,h.face,l,c):(n.label(null),this.selection.length>0&&this.select([]))})}onRelease(e,t){let{stage:n}=this.host,s=n.local(e),r=0,o=l=>{let{x:c,y:u}=n.local(l);r=Math.max(r,Math.hypot(c-s.x,u-s.y))},a=l=>{if(l.pointerId!==e.pointerId)return;document.removeEventListener("pointermove",o),document.removeEventListener("pointerup",a),document.removeEventListener("pointercancel",a);let{x:c,y:u}=n.local(l);l.type==="pointerup"&&t(c,u,r,l)};document.addEventListener("pointermove",o),document.addEventListener("pointerup",a),document.addEventListener("pointercancel",a)}seize(e,t,n){let{stage:s}=this.host;this.busy=!0,s.controls.enabled=!1,e.preventDefault();try{s.canvas.setPointerCapture(e.pointerId)}catch{}let r=a=>{a.pointerId===e.pointerId&&t(a)},o=a=>{a.pointerId===e.pointerId&&(document.removeEventListener("pointermove",r),document.removeEventListener("pointerup",o),document.removeEventListener("pointercancel",o),this.busy=!1,s.controls.enabled=!0,n(a))};document.addEventListener("pointermove",r),document.addEventListener("pointerup",o),document.addEventListener("pointercancel",o)}drag(e,t,n){let{host:s}=this,{stage:r,history:o,frame:a}=s,l=s.lines[t.line].points[t.point],c=Yt(l);if(!c)return;let u=this.selection.some(_=>zs(_,t));u||this.select(e.shiftKey?[...this.selection,t]:[t]);let h=this.selection.map(_=>({ref:_,from:Yt(s.lines[_.line].points[_.point])??c})),d=new P(...a.toScene(c)),f=r.project(d.toArray()),m=r.local(e),y={x:m.x-f.x,y:m.y-f.y},g=!1;o.begin(),this.seize(e,_=>{let{x:v,y:M}=r.local(_);if(!g&&Math.hypot(v-m.x,M-m.y)<2)return;g=!0;let b=n==="height"!==(_.shiftKey&&!e.shiftKey),w=b?this.raised(d,M-m.y):this.grounded(d,v-y.x,M-y.y);if(!w)return;let x=this.rounded(w,c);!b&&this.snapping&&!_.altKey&&(x=this.onto(v,M,h.map(A=>A.ref))??x);for(let{ref:A,from:E}of h)this.write(A,E.map((C,I)=>Zr(C+x[I]-c[I])));let p=r.project(a.toScene(x)),S=wi(o.document.request);s.label(b?`${"xyz"[a.up]} ${wt(x[a.up],6)} ${S}`:x.map((A,E)=>`${"xyz"[E]} ${wt(A,6)}`).join("  "),p.x,p.y),this.lifting=b,s.changed(!0)},_=>{this.lifting=!1,s.label(null),!g&&_.type==="pointerup"&&(e.shiftKey&&u?this.select(this.selection.filter(v=>!zs(v,t))):e.shiftKey||this.select([t])),o.commit()&&s.changed(!1)})}lifting=!1;selectBox(e){let{stage:t,sketch:n}=this.host,s=t.local(e),r=this.selection,{style:o}=this.marquee;this.seize(e,a=>{let{x:l,y:c}=t.local(a),[u,h,d,f]=[Math.min(l,s.x),Math.min(c,s.y),Math.max(l,s.x),Math.max(c,s.y)];this.marquee.hidden=!1,Object.assign(o,{left:`${u}px`,top:`${h}px`,width:`${d-u}px`,height:`${f-h}px`});let m=n.refs.filter((y,g)=>{let _=t.project(n.places[g]);return y.line>=0&&_.visible&&_.x>=u&&_.x<=d&&_.y>=h&&_.y<=f});this.selection=[...r,...m.filter(y=>!r.some(g=>zs(g,y)))],this.refresh()},()=>{this.marquee.hidden=!0,this.select(this.selection)})}grounded(e,t,n){let{stage:s}=this.host,r=s.camera.getWorldDirection(new P);return s.onPlane(t,n,e,Math.abs(r.y)>.08?new P(0,1,0):r)}raised(e,t){let{stage:n}=this.host,s=new P(0,1,0).applyQuaternion(n.camera.quaternion).y;return e.clone().add(new P(0,-t*n.pixelAt(e)/Math.max(s,.35),0))}rounded(e,t){let{stage:n,frame:s}=this.host,r=10**Math.floor(Math.log10(s.length(n.pixelAt(e))*1.5)),o=s.fromScene(e.toArray()),a=1e-9*s.length(n.radius)+1e-12*Math.max(...t.map(Math.abs));return o.map((l,c)=>Math.abs(l-t[c])<=a?t[c]:Zr(Math.round(l/r)*r))}tidy(e){let{frame:t}=this.host;return this.rounded(new P(...t.toScene(e)),[NaN,NaN,NaN])}onto(e,t,n){let{stage:s,sketch:r,lines:o}=this.host,a=r.refs.findIndex((c,u)=>{if(c.line<0||n.some(d=>d.line===c.line))return!1;let h=s.project(r.places[u]);return h.visible&&Math.hypot(h.x-e,h.y-t)<hr.snap}),l=r.refs[a];return l?Yt(o[l.line].points[l.point]):null}write({line:e,point:t},n){let{points:s}=this.host.lines[e],r=s[t];Array.isArray(r)?r.splice(0,Math.max(3,r.length),...n):s[t]=n}moveBy(e){let{history:t}=this.host;t.edit(()=>{for(let s of this.selection){let r=Yt(this.host.lines[s.line].points[s.point]);r&&this.write(s,r.map((o,a)=>Zr(o+e[a])))}})&&this.host.changed(!1)}setAxis(e,t){this.host.history.edit(()=>{for(let s of this.selection){let r=Yt(this.host.lines[s.line].points[s.point])??[0,0,0];r[e]=t,this.write(s,r)}})&&this.host.changed(!1)}edgeBefore(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t||Mr(t)||t.points.length<2)return null;let n=e.point>0?e.point-1:t.closed?t.points.length-1:-1,s=Yt(t.points[e.point]),r=Yt(t.points[n]);return s&&r?{length:Math.hypot(...s.map((o,a)=>o-r[a])),previous:r,point:s}:null}setEdgeBefore(e){let t=this.edgeBefore(),{only:n}=this;if(!t||!n||!(e>0)||t.length===0)return;let s=t.previous.map((r,o)=>Zr(r+(t.point[o]-r)*e/t.length));this.host.history.edit(()=>this.write(n,s))&&this.host.changed(!1)}companions(e){let{request:t}=this.host.history.document,{points:n,path:s}=this.host.lines[e];return s[0]!=="directrices"?[]:["normals","tangents"].flatMap(r=>{let o=t[r]?.[s[1]];return Array.isArray(o)&&o.length===n.length?[o]:[]})}insertAt(e,t,n){this.companions(e).forEach(s=>s.splice(t+1,0,structuredClone(s[t]))),this.host.lines[e].points.splice(t+1,0,n),this.selection=[{line:e,point:t+1}]}insert(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t)return;let n=Yt(t.points[e.point]),s=Yt(t.points[e.point+1])??(t.closed?Yt(t.points[0]):null);if(!n)return;let r=Yt(t.points[e.point-1])??n.map((a,l)=>a-(l===0?1:0)),o=n.map((a,l)=>Zr(s?(a+s[l])/2:2*a-r[l]));this.host.history.edit(()=>this.insertAt(e.line,e.point,o))&&this.host.changed(!1),this.select(this.selection)}remove(){let{host:e}=this;if(this.selection.length===0)return;let[t]=this.selection;e.history.edit(()=>{let s=[...this.selection].sort((r,o)=>o.line-r.line||o.point-r.point);for(let{line:r,point:o}of s)this.companions(r).forEach(a=>a.splice(o,1)),e.lines[r].points.splice(o,1);for(let r=e.lines.length-1;r>=0;r-=1)e.lines[r].points.length===0&&this.dropLine(r)}),this.selection=[],e.changed(!1);let n=e.lines[t.line]?.points.length??0;this.select(n>0&&n>1?[{line:t.line,point:Math.min(t.point,n-1)}]:[])}removeLine(){let{host:e}=this,t=[...new Set(this.selection.map(n=>n.line))].sort((n,s)=>s-n);t.length!==0&&(e.history.edit(()=>t.forEach(n=>this.dropLine(n))),this.selection=[],e.changed(!1),this.select([]))}dropLine(e){let{request:t}=this.host.history.document,{path:n}=this.host.lines[e],s=Xg(t,n.slice(0,-1)),r=n.at(-1);if(Array.isArray(s)?s.splice(Number(r),1):delete s[r],n[0]==="directrices")for(let o of["normals","tangents"])Array.isArray(t[o])&&t[o].splice(Number(r),1)}startDrawing(){let{history:e,stage:t,lines:n,frame:s}=this.host;if(this.drawing)return;e.edit(a=>{a.draft=[]}),this.select([]);let r=n.flatMap(a=>a.points.map(l=>Yt(l)?.[s.up]??1/0));this.level=r.length>0?Math.min(...r):s.origin[s.up],this.next=null;let o=t.camera.getWorldDirection(new P);Math.abs(o.y)<.3&&t.look([.25,1.2,.6]),this.host.changed(!1),t.canvas.focus({preventScroll:!0})}stopDrawing(){this.drawing&&(this.host.history.edit(e=>{e.draft=null}),this.next=null,this.host.label(null),this.host.stage.canvas.style.cursor="",this.host.changed(!1))}get least(){return Mt[this.host.history.document.kind].least}place(e){if(e){if(e.close){this.finishDrawing();return}this.host.history.edit(t=>{t.draft.push(e.point)}),this.host.changed(!1)}}finishDrawing(){let{host:e}=this,{history:t}=e,n=t.document.draft;return!n||n.length<this.least?!1:(t.edit(s=>{let{kind:r,request:o}=s,{lines:a}=Mt[r];if(s.draft=null,r==="uniform_mesh"){let l=o.domain??={};!l.polygon&&!l.boundaries&&!l.bezier&&!l.nurbs?l.polygon=n:(l.polygon?l.holes??=[]:l.boundaries??=[]).push(n)}else(o[a[0]]??=[]).push(n)}),this.next=null,e.label(null),e.stage.canvas.style.cursor="",e.changed(!1),!0)}enter(e){let t=this.host.history.document.draft;if(!t)return null;let n=t.at(-1)??null,s=e.replace(/^@/,"").trim().split(/[\s,;]+/).map(Number);if(s.length>3||s.some(u=>!Number.isFinite(u))||e.trim()==="")return"Type a length, or x, y, z.";let{up:r}=this.host.frame,[o,a]=r===2?[0,1]:[0,2];if(s.length===1){if(!n)return"The first point needs x, y, z.";let u=this.next?.point??null,h=u?u.map((f,m)=>f-n[m]):[1,0,0],d=Math.hypot(...h);return d===0?"Point into a direction first.":(this.place({point:n.map((f,m)=>Zr(f+h[m]/d*s[0])),how:"",close:!1}),null)}let l=[0,0,0],c=e.trim().startsWith("@")?n??[0,0,0]:[0,0,0];return l[o]=c[o]+s[0],l[a]=c[a]+s[1],l[r]=s.length===3?c[r]+s[2]:e.trim().startsWith("@")?c[r]:this.level,r===1&&s.length===3&&l.splice(0,3,...c.map((u,h)=>u+s[h])),this.place({point:l,how:"",close:!1}),null}snap(e,t,n){let{stage:s,sketch:r,lines:o,frame:a,history:l}=this.host,c=l.document.draft??[],u=c.length>=this.least&&Mt[l.document.kind].line!=="rail"?c[0]:null;if(u){let M=s.project(a.toScene(u));if(Math.hypot(M.x-e,M.y-t)<hr.snap)return{point:u,how:"closes the loop",close:!0}}if(!n&&this.snapping){let M=r.refs.findIndex((x,p)=>{let S=s.project(r.places[p]);return x.line>=0&&S.visible&&Math.hypot(S.x-e,S.y-t)<hr.snap}),b=r.refs[M],w=b&&Yt(o[b.line].points[b.point]);if(w)return{point:w,how:"on a point",close:!1}}let h=[...a.origin];h[a.up]=this.level;let d=s.onPlane(e,t,new P(...a.toScene(h)),new P(0,1,0));if(!d)return null;let f=a.fromScene(d.toArray());f[a.up]=this.level;let m=a.length(s.pixelAt(d)),y=a.up===2?[0,1]:[0,2],g=10**Math.floor(Math.log10(m*1.5)),_=[1,2,5,10,20,50].map(M=>M*g).find(M=>M>=9*m)??g,v="";for(let M of y){let b=f[M],w=n||!this.snapping?void 0:[c.at(-1),c[0]].find(x=>x&&Math.abs(x[M]-b)<hr.align*m);if(w)f[M]=w[M],v="in line";else{let x=n||!this.snapping?g:_;f[M]=Zr(Math.round(b/x)*x)}}return{point:f,how:v,close:!1}}showNext(e,t){let{host:n}=this,{next:s}=this,{draft:r,request:o}=n.history.document;if(!s||!r){n.label(null);return}let a=r.at(-1),l=s.point.map(u=>wt(u,6)).join(", "),c=a?Math.hypot(...s.point.map((u,h)=>u-a[h])):0;n.label([a?`${wt(c,4)} ${wi(o)}`:l,s.how].filter(Boolean).join(" · "),e,t)}hints(){let{sketch:e,stage:t,frame:n,history:s,lines:r}=this.host,o=Math.tan(t.camera.fov*Math.PI/360);e.setPixel(2*o/t.height,t.renderer?.getPixelRatio()??1);let a=[],l=[],c=null,{draft:u}=s.document;if(u&&this.next){let d=n.toScene(this.next.point);c=d,u.length>0&&a.push(n.toScene(u.at(-1)),d),u.length>1&&Mt[s.document.kind].line!=="rail"&&l.push(d,n.toScene(u[0]))}else this.ghost&&!this.busy&&(c=n.toScene(this.ghost.point));let h=this.arrow();if(h){let d=h.to.toArray(),f=new P(1,0,0).applyQuaternion(t.camera.quaternion),m=h.from.distanceTo(h.to),y=h.to.clone().addScaledVector(h.to.clone().sub(h.from),-.24);a.push(h.from.toArray(),d);for(let M of[-1,1])a.push(y.clone().addScaledVector(f,M*.14*m).toArray(),d);let{only:g}=this,_=Yt(r[g.line].points[g.point]),v=[...n.toScene(_)];v[1]=t.grid.mesh.position.y,(this.lifting||Math.abs(v[1]-h.from.y)>m*.3)&&l.push(h.from.toArray(),v)}e.hint({segments:a,faint:l,ghost:c})}key(e){let{stage:t,frame:n,lines:s}=this.host;if(e.ctrlKey||e.metaKey){if(e.key!=="a")return;this.select(s.flatMap((h,d)=>h.points.map((f,m)=>({line:d,point:m})))),e.preventDefault();return}let r=this.selection.length>0&&!this.drawing,o=n.up===2?[0,1]:[0,2],a=n.up===2?1:-1,l={ArrowLeft:[o[0],-1],ArrowRight:[o[0],1],ArrowUp:[o[1],a],ArrowDown:[o[1],-a],PageUp:[n.up,1],PageDown:[n.up,-1]},c={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},u=l[e.key];if(r&&u){let h=10**Math.round(Math.log10(n.length(t.pixelAt(t.centre))*10))*(e.shiftKey?10:1),d=[0,0,0];d[u[0]]=u[1]*h,this.moveBy(d)}else if(c[e.key]){let[h,d]=c[e.key];e.shiftKey?t.pan(-24*h,-24*d):t.orbit(.12*h,.12*d)}else if(r&&(e.key==="Delete"||e.key==="Backspace"))this.remove();else if(r&&(e.key==="Insert"||e.key==="Enter"))this.insert();else if(e.key==="]")this.step(1);else if(e.key==="[")this.step(-1);else if(e.key==="+"||e.key==="=")t.zoom(t.width/2,t.height/2,.85);else if(e.key==="-"&&!this.drawing)t.zoom(t.width/2,t.height/2,1/.85);else if(e.key==="Escape"&&r)this.select([]);else return;e.preventDefault()}},Zr=i=>Number(i.toPrecision(14));var vd=[.62,.5,.85],fi=document.documentElement.hasAttribute("data-embed"),bd={light:{sketch:{paper:"#ffffff",accent:"#0a6c7e",ink:"#1c2427",fault:"#c62f26",soft:"#6d7b81"},look:{membrane:"#f2eee6",ink:"#20292d",accent:"#b4561f"},grid:["#5b6b73",.42],shadow:.5},dark:{sketch:{paper:"#12181b",accent:"#56c4d4",ink:"#ffffff",fault:"#ff7a70",soft:"#8fa0a8"},look:{membrane:"#cbc7be",ink:"#0d1214",accent:"#ffb273"},grid:["#90a4ad",.3],shadow:.85}},Fi={openapi:{},objectives:[],examples:[]},ue={mode:"model",shown:null,viewing:!1,run:null,pendingJob:null,lastDuration:0,colour:"plain",quantity:null,serverFaulty:new Set,generation:0,cameraGiven:!1,ready:!1},pi=new Ch({kind:"minimal_surface",request:Rc("minimal_surface"),draft:null,title:null}),He=()=>pi.document;function dr(){let{shown:i,viewing:e}=ue;return i!==null&&!e&&(i.solved!==JSON.stringify(He().request)||i.job.kind!==He().kind)}var Jl={...bd.light.look},Ve=new xd(Z("view"),()=>({top:64,right:34,left:34,bottom:Math.max(fi?40:70,Z("look").offsetHeight+34)})),In=new hd(bd.light.sketch),qt=new pa(Jl);Ve.model.add(qt.group,In.group);var at={history:pi,stage:Ve,sketch:In,surface:qt,lines:[],frame:new Ri([0,0,0],He().request),faulty:new Set,fixed:fi,changed(){},selectionChanged(){},label(){},read(){},announce(){}},lt=new yd(at);function fs(i=!1){In.group.visible=!ue.viewing&&!fi,qt.drawn=In.group.visible,In.show(ue.viewing?[]:at.lines,He().draft,at.frame),i||(at.faulty=new Set([...ue.serverFaulty,...Rh(at.lines).flatMap(({line:e,points:t})=>t.map(n=>`${e}/${n}`))]),Ve.rememberWhetherAllIsSeen()),lt.refresh()}function fr(){let{drawing:i,selection:e}=lt,t=!Z("intro").hidden&&!i&&e.length===0;Z("intro").hidden=!t,Z("drawing").hidden=!i,Z("point").hidden=i||e.length===0,Z("hint").hidden=t||i||e.length>0,i?jA():e.length>0?Ym():Z("hint").textContent=qm()}function qm(){return ue.viewing?"The server keeps no drawing of this job: only its mesh is shown. Undo, or any edit, brings your drawing back.":ue.mode==="compare"?"Each objective solved on the same rails; the best value of each row is bold. Drag beside the figures to turn all of them.":ue.mode==="flat"?"The strip unrolled into the plane, to scale. Drag to move it, wheel to zoom.":at.lines.length===0?"Nothing is drawn yet. Press Draw, open a file, or drop one here.":Ei(He().kind,He().request)?"Drag a point to move it, press on an edge to add one. Drag the ground to orbit, right-drag to pan, wheel to zoom.":`A strip needs two ${Mt[He().kind].line}s: press Draw for the next one.`}function jA(){let{kind:i,draft:e}=He(),{line:t,least:n}=Mt[i],s=i==="uniform_mesh"&&at.lines.length===0,r=e.length,o=s?"polygon":t;Z("drawing-hint").textContent=r===0?`Click on the ground to begin the ${o}.`:r<n?`${Ti(r,"point")} of the ${o}: click to add more.`:i==="ruled_surface"?`${Ti(r,"point")}: click to add more, Enter ends the rail.`:`${Ti(r,"point")}: click the first point, or press Enter, to close the ${o}.`,Z("finish").disabled=r<n,Z("level-name").textContent=`at ${"xyz"[at.frame.up]}`,document.activeElement!==Z("level")&&(Z("level").value=String(lt.level))}function Ym(){let{selection:i,only:e}=lt,t=e&&at.lines[e.line];Z("point-name").textContent=t?`${wr(t.name)}, ${e.point+1} of ${t.points.length}`:Ti(i.length,"point");for(let s of document.querySelectorAll("#point [data-axis]")){let r=new Set(i.map(a=>{let l=at.lines[a.line]?.points[a.point];return Array.isArray(l)?l[Number(s.dataset.axis)]:void 0})),[o]=r;document.activeElement===s&&s.dataset.dirty||(s.value=r.size===1&&o!==void 0&&o!==null?String(o):"",s.placeholder=r.size===1?"none":"various")}let n=lt.edgeBefore();Z("edge-field").hidden=!n,n&&document.activeElement!==Z("edge")&&(Z("edge").value=String(Number(n.length.toPrecision(7)))),Z("insert-point").disabled=!e}var QA=7e3,bn=i=>{Z("status").textContent=i},Iy=i=>{Z("announcement").textContent=i},Py=0;function pr(i){Z("toast").textContent=i,Z("toast").hidden=!1,clearTimeout(Py),Py=window.setTimeout(()=>{Z("toast").hidden=!0},QA)}var jl=null;function Jr(i,e=0,t=0,n=null){jl=i===null?null:{text:i,x:e,y:t,anchor:n},$m()}function $m(){let i=Z("label");if(i.hidden=jl===null,!jl)return;let{text:e,anchor:t}=jl,{x:n,y:s}=t?Ve.project(t):jl;i.textContent=e;let r=Math.min(Math.max(n+14,6),Ve.width-i.offsetWidth-6),o=Math.min(Math.max(s-30,6),Ve.height-30);i.style.transform=`translate(${Math.round(r)}px, ${Math.round(o)}px)`}var Ly=(i,e,t,n)=>{let s=qt.valueAt(i,e),r=at.frame.fromScene(i.toArray()).map(o=>wt(o,5)).join(", ");Jr(ue.quantity&&s!==null?gy(ue.quantity,s):r,t,n,i.toArray())};var Sd="plateau.work",Km="plateau.recent",eR=250,tR=2e5,nR=20,Zm=i=>{let{kind:e,request:t}=i??{};return e!==void 0&&e in Mt&&t!==null&&typeof t=="object"},Oy=0,Ny=!1;function ki(){clearTimeout(Oy),Oy=window.setTimeout(Jm,eR)}function Jm(){if(fi||!ue.ready)return;let{kind:i,request:e,draft:t,title:n}=He(),s=ue.pendingJob??(dr()?null:ue.shown?.job.id??null),r={kind:i,request:e,draft:t,title:n,camera:jm(),colour:ue.colour,job:s},o=JSON.stringify(r);try{sessionStorage.setItem(Sd,o),localStorage.setItem(Sd,o)}catch{Ny||pr("This drawing is too large to be kept by the browser: save it as a file."),Ny=!0}}function Dy(){try{let i=JSON.parse(sessionStorage.getItem(Sd)??localStorage.getItem(Sd)??"null");return Zm(i)?i:null}catch{return null}}function jm(){let{eye:i,target:e}=Ve.pose(),t=new Ri([0,0,0],He().request).toScene(at.frame.origin);return{eye:i.map((n,s)=>n+t[s]),target:e.map((n,s)=>n+t[s])}}function Md({eye:i,target:e}){ue.cameraGiven=!0;let t=new Ri([0,0,0],He().request).toScene(at.frame.origin);Ve.place({eye:i.map((n,s)=>n-t[s]),target:e.map((n,s)=>n-t[s])},!1),Ve.rememberWhetherAllIsSeen()}function Qm(){try{return JSON.parse(localStorage.getItem(Km)??"[]")}catch{return[]}}function Uy(i,{request:e,title:t}){if(fi||e.length>tR)return;let n=[{id:i.id,title:t,kind:i.kind,request:e},...Qm().filter(s=>s.id!==i.id)].slice(0,nR);try{localStorage.setItem(Km,JSON.stringify(n))}catch{localStorage.removeItem(Km)}}var Fy=[{name:"area",label:"Area",unit:"u²",better:"less"},{name:"total_normal_twist",label:"Twist",unit:"",better:"less"},{name:"convex_bridge_ratio",label:"Convex",unit:"%",better:"more"},{name:"bending_energy",label:"Bending",unit:"",better:"less"},{name:"mean_curvature_variation",label:"Curvature var.",unit:"",better:"less"},{name:"largest_fold_deg",label:"Fold",unit:"°",better:"less"}],wd=class{constructor(e,t,n){this.stage=e;this.look=t;this.fail=n}stage;look;fail;tiles=[];turn=0;use=()=>{};async open(e,t,n){this.close();let s=this.turn,r=Array.isArray(e.normals),o=n.filter(a=>r||a!=="minimal_normal_variation");this.tiles=o.map(a=>{let l=ie("button",{type:"button",onclick:()=>this.use(a)},"Use this");l.setAttribute("aria-label",`Use this: ${tn(a)}`);let c=ie("div",{},ie("p",{className:"wait"},"Solving…")),u=ie("div",{className:"picture"}),h=ie("article",{className:"tile"},u,ie("div",{className:"facts"},ie("header",{},ie("h2",{},tn(a)),l),c));return h.dataset.objective=a,{name:a,box:h,facts:c,picture:u,surface:new pa(this.look),statistics:null}}),Z("tiles").replaceChildren(...this.tiles.map(({box:a})=>a)),Z("tiles").hidden=!1,Z("tiles").onscroll=()=>this.stage.invalidate(),this.stage.tiles=this.tiles.map(({picture:a,surface:l})=>({element:a,group:l.group})),this.stage.invalidate(),await Promise.all(this.tiles.map(a=>this.solve(a,e,t,s).catch(l=>{s===this.turn&&(a.facts.replaceChildren(ie("p",{className:"wait"},"This objective found no strip.")),this.fail(l))})))}async solve(e,t,n,s){let{secondary_objective:r,...o}=t,a={...o,objective:e.name,all_objectives:!1,...e.name==="maximal_convexity"&&r?{secondary_objective:r}:{}},l=await Ec(Mt.ruled_surface.path,a);if(to(l)||(l=await Tc(l,()=>{})),l.status!=="succeeded")throw new zi(l.error??{});let c=await fa(await no(`${l.links.mesh}?format=glb`));s===this.turn&&(e.surface.show(c,"ruled_surface",n),e.statistics=l.statistics,this.report(t),this.stage.invalidate())}report(e){let t=this.tiles.filter(s=>s.statistics!==null),n=new Map(Fy.map(({name:s,better:r})=>{let o=t.map(a=>a.statistics[s]).filter(a=>typeof a=="number");return[s,r==="less"?Math.min(...o):Math.max(...o)]}));for(let s of t)s.box.classList.toggle("best",s.name===(e.objective??"minimal_area")),s.facts.replaceChildren(ie("dl",{},...Fy.flatMap(({name:r,label:o,unit:a})=>{let l=s.statistics[r];if(typeof l!="number")return[];let c=Math.abs(l-n.get(r))<=1e-9*Math.abs(n.get(r)),u=a==="%"?`${wt(100*l,3)} %`:`${wt(l,4)}${a==="u²"?` ${wi(e)}²`:a}`;return[ie("dt",{title:tn(r)},o),ie("dd",{className:c?"best":""},u)]})))}restyle(){this.tiles.forEach(({surface:e})=>e.restyle())}close(){this.turn+=1,this.tiles.forEach(({surface:e,picture:t})=>{e.show(null,"",null),t.remove()}),this.tiles=[],this.stage.tiles=null,Z("tiles").hidden=!0,Z("tiles").replaceChildren(),this.stage.invalidate()}};var Ed=class{url="";x=0;y=0;scale=1;box=Z("flat");image=Z("flat-image");constructor(){this.box.addEventListener("wheel",e=>{e.preventDefault();let{left:t,top:n}=this.box.getBoundingClientRect();this.zoom(e.clientX-t,e.clientY-n,Math.exp(-e.deltaY*.0015))},{passive:!1}),this.box.addEventListener("pointerdown",e=>{let t={x:e.clientX-this.x,y:e.clientY-this.y};this.box.setPointerCapture(e.pointerId);let n=r=>{[this.x,this.y]=[r.clientX-t.x,r.clientY-t.y],this.place()},s=()=>{this.box.removeEventListener("pointermove",n),this.box.removeEventListener("pointerup",s)};this.box.addEventListener("pointermove",n),this.box.addEventListener("pointerup",s)}),this.box.addEventListener("keydown",e=>{let{clientWidth:t,clientHeight:n}=this.box;e.key==="+"||e.key==="="?this.zoom(t/2,n/2,1.2):e.key==="-"?this.zoom(t/2,n/2,1/1.2):e.key==="0"&&this.fit()}),new ResizeObserver(()=>{this.box.hidden||this.fit()}).observe(this.box)}async show(e){let t=await wc(`${e.links.pattern}?format=svg`);URL.revokeObjectURL(this.url),this.url=URL.createObjectURL(t),this.box.hidden=!1,this.image.src=this.url,await this.image.decode(),this.fit()}hide(){this.box.hidden=!0}fit(){let{clientWidth:e,clientHeight:t}=this.box,{naturalWidth:n,naturalHeight:s}=this.image;n!==0&&(this.scale=.9*Math.min((e-24)/n,(t-150)/s),this.x=(e-n*this.scale)/2,this.y=(t-s*this.scale)/2+24,this.place())}zoom(e,t,n){this.scale*=n,this.x=e+(this.x-e)*n,this.y=t+(this.y-t)*n,this.place()}place(){let{style:e}=this.image;e.width=`${this.image.naturalWidth*this.scale}px`,e.left=`${this.x}px`,e.top=`${this.y}px`}};function Td(){Z("problem").hidden=!0,ue.serverFaulty.size!==0&&(ue.serverFaulty=new Set,fs())}function Ln(i){let{title:e,detail:t,message:n,errors:s,omitted:r}=i,o=s??[],a=new Set,l=o.map(h=>{let d=qd(at.lines,h.pointer);d.line!==void 0&&d.point!==void 0&&d.point>=0&&a.add(`${d.line}/${d.point}`);let f=d.line===void 0?Z("options").querySelector(`[name="${CSS.escape(d.field??"")}"], [name^="${CSS.escape(d.field??"")}."]`):null;return ky(wr(d.text),Yg(h.detail),d,f)});if(!o.some(h=>qd(at.lines,h.pointer).point!==void 0))for(let{line:h,points:d,text:f}of Rh(at.lines))d.forEach(m=>a.add(`${h}/${m}`)),l.push(ky("",f,{line:h,point:d[0]},null));r&&l.push(ie("li",{},"and more"));let c=t??n??"",u=o.length>0&&(/^see errors/.test(c)||o.some(h=>c.includes(h.detail)));Z("problem").replaceChildren(ie("strong",{},e??"Something went wrong"),u||c===e?"":Ia(wr(c)),l.length>0&&ie("ul",{},...l)||""),Z("problem").hidden=!1,ue.serverFaulty=a,fs()}function ky(i,e,t,n){let s=[i&&ie("b",{},i),i?` ${e}`:e];if(t.line===void 0&&!n)return ie("li",{},...s);let r=ie("button",{type:"button"},...s);return r.addEventListener("click",()=>{n?(n.closest("details")?.setAttribute("open",""),n.focus()):lt.select([{line:t.line,point:Math.max(t.point??0,0)}])}),n&&n.setAttribute("aria-invalid","true"),ie("li",{},r)}var Ad=new Ed,ba=new wd(Ve,Jl,Ln);function jr(i){if(!(i===ue.mode&&i!=="compare")){ue.mode=i,Z("stage").dataset.shows=i;for(let e of document.querySelectorAll("[data-mode]"))e.setAttribute("aria-pressed",String(e.dataset.mode===i));if(Z("corner").hidden=i!=="model",i!=="compare"&&ba.close(),i!=="flat"&&Ad.hide(),i==="compare"){let e=Fi.objectives.filter(t=>t.kind==="ruled_surface").map(t=>t.name);ba.open(He().request,at.frame,e)}i==="flat"&&ue.shown&&Ad.show(ue.shown.job).catch(Ln),fr(),Ve.invalidate()}}function By(){ue.mode==="flat"?Ad.fit():Ve.fit(!0)}function zy(i,e){Z("modes").hidden=!i,document.querySelector('[data-mode="flat"]').hidden=!e,!(ue.mode!=="flat"||!ue.shown)&&(e?Ad.show(ue.shown.job).catch(Ln):jr("model"))}var Ql=300,ec=118,Sa=56,Rd=8,iR=8,Vy=22;function Cd(i,e,t){let n=[],s=i.filter(o=>o.value!==null&&Number.isFinite(o.value)).map((o,a)=>({x:a,y:o.value})),r=i.filter(o=>o.residual!==null&&o.residual>0).map((o,a)=>({x:a,y:o.residual}));return s.length>=3&&n.push(Hy(e,s,!1,null)),r.length>=3&&n.push(Hy("Residual",r,!0,t)),n}function Hy(i,e,t,n){let s=m=>t?Math.log10(m):m,r=e.map(({y:m})=>s(m));n!==null&&n>0&&r.push(s(n));let o=Math.min(...r),a=Math.max(...r);t&&([o,a]=[Math.floor(o),Math.ceil(a)]),a-o<1e-12*Math.max(Math.abs(a),1e-300)&&([o,a]=[o-Math.abs(o||1)*.01,a+Math.abs(a||1)*.01]);let l=e.at(-1).x||1,c=m=>Sa+(Ql-Sa-Rd)*m/l,u=m=>ec-Vy-(ec-iR-Vy)*(m-o)/(a-o),h=Dn("svg",{viewBox:`0 0 ${Ql} ${ec}`,class:"chart",role:"img","aria-label":`${i} over ${e.length} steps, from ${wt(e[0].y,4)} to ${wt(e.at(-1).y,4)}`}),d=sR(o,a,t),f=t?4:Math.min(9,Math.max(4,1+Math.ceil(Math.log10(Math.max(Math.abs(o),Math.abs(a))/Math.abs(d[1]-d[0])))));for(let m of d)h.append(Dn("line",{class:"rule",x1:Sa,x2:Ql-Rd,y1:u(m).toFixed(1),y2:u(m).toFixed(1)}),Dn("text",{x:Sa-6,y:(u(m)+3.5).toFixed(1),"text-anchor":"end"},wt(t?10**m:m,f)));return h.append(Dn("text",{x:Sa,y:ec-6},"0"),Dn("text",{x:Ql-Rd,y:ec-6,"text-anchor":"end"},`${wt(e.length-1)} steps`)),n!==null&&n>0&&h.append(Dn("path",{class:"floor",d:`M${Sa},${u(s(n)).toFixed(1)}H${Ql-Rd}`})),h.append(Dn("path",{class:"curve",d:e.map((m,y)=>`${y?"L":"M"}${c(m.x).toFixed(1)},${u(s(m.y)).toFixed(1)}`).join("")})),ie("figure",{className:"chart-box"},ie("figcaption",{},i),h)}function sR(i,e,t){if(t){let l=Math.max(1,Math.ceil((e-i)/3));return Array.from({length:Math.floor((e-i)/l)+1},(c,u)=>i+u*l)}let n=(e-i)/3,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(l=>l*s).find(l=>l>=n)??n,o=Math.ceil(i/r)*r,a=[];for(let l=o;l<=e+1e-9*r;l+=r)a.push(Math.abs(l)<1e-9*r?0:l);return a.length>1?a:[i,e]}var Gy=i=>tn(i);var eg=220,tg=34,ng=44;function ig(i){if(Z("scale").hidden=i===null,!i)return;let e=i.scale==="diverging"&&i.id==="mean_curvature"?"|H|":"All values";Z("scale-note").textContent=i.nought?`≈ 0: ${e} below ${wt(i.noise,2)}${i.unit&&` ${i.unit}`}`:`${i.label}${i.unit&&` [${i.unit}]`}`;let t=!i.nought&&i.high-i.low<=1e-6*Math.max(Math.abs(i.low),Math.abs(i.high)),n=Z("scale-bar"),s=40,r=Array.from({length:s+1},(c,u)=>oy(i.scale,i.nought||t?i.scale==="diverging"||t?.5:0:u/s));n.style.background=`linear-gradient(to right, ${r.join(", ")})`,Z("scale-low").textContent=i.nought||t?"":wt(i.low,3),Z("scale-middle").textContent=i.nought?"≈ 0":t?wt(i.high,5):i.scale==="diverging"?"0":"",Z("scale-high").textContent=i.nought||t?"":wt(i.high,3);let o=_y(i,ng),a=Math.max(...o,1),l=Z("scale-histogram");l.hidden=i.nought||t,l.replaceChildren(Dn("svg",{viewBox:`0 0 ${eg} ${tg}`,preserveAspectRatio:"none",role:"img","aria-label":`Histogram of ${i.values.length} values`},...o.map((c,u)=>{let h=tg*Math.sqrt(c)/Math.sqrt(a);return Dn("rect",{x:u*eg/ng,y:tg-h,width:eg/ng-.8,height:h})})))}var og=i=>i!==null&&typeof i=="object"&&!Array.isArray(i);function Ma(i){return i==null?"—":typeof i=="number"?wt(i):typeof i=="boolean"?i?"yes":"no":String(i).replaceAll("_"," ")}var rR={minimal_surface:[["area","Area","u²"],["triangles","Triangles",""],["residual","Residual",""],["stability.stable","Stable",""]],ruled_surface:[["area","Area","u²"],["convex_bridge_ratio","Convex bridges","%"],["bending_energy","Bending energy",""],["largest_fold_deg","Largest fold","°"]],uniform_mesh:[["nodes","Nodes",""],["edges","Members",""],["equal_edges","Equal members",""],["distinct_lengths","Distinct lengths",""]],tensile_structure:[["area","Area","u²"],["pressure","Pressure",""],["balance.imbalance","Force imbalance",""],["stress.deviation","Stress deviation",""]]},sg=(i,e)=>e.split(".").reduce((t,n)=>t?.[n],i);function Yy(i,e){let t=i.statistics;return(rR[i.kind]??[]).filter(([n])=>sg(t,n)!==void 0&&sg(t,n)!==null).map(([n,s,r])=>{let o=sg(t,n),a=r==="%"&&typeof o=="number"?wt(100*o,3):Ma(o),l=r===""?"":r==="%"||r==="°"?r:` ${r.replace("u",e)}`;return ie("div",{className:"figure"},ie("span",{className:"value"},a,ie("small",{},l)),ie("span",{className:"name"},s))})}var Wy=["objective","objective_value","secondary_value","converged","stop_reason","residual","area","certificate","initial_area","nodes","vertices","triangles","edges","bridges","stability","iterations","self_intersections","mean_curvature","edge_lengths","angles_deg"],Xy=([i])=>Wy.indexOf(i)+1||Wy.length+1,oR=6,rg=500;function $y(i){let e=[],t=[],n=(s,r)=>{if(Array.isArray(r)){if(r.length===0)return;r.every(og)?t.push(aR(s,r)):r.length>oR?t.push(Ky(s,String(r.length),ie("p",{className:"numbers"},r.map(Ma).join(" · ")))):e.push(qy(s,r.map(Ma).join(", ")))}else og(r)?Object.entries(r).forEach(([o,a])=>n(`${s} ${o}`,a)):r!==void 0&&e.push(qy(s,Ma(r)))};return Object.entries(i).filter(([s])=>s!=="comparison"&&s!=="history").sort((s,r)=>Xy(s)-Xy(r)).forEach(([s,r])=>n(s,r)),[ie("table",{className:"plain"},ie("tbody",{},...e)),...t]}var qy=(i,e)=>ie("tr",{},ie("th",{scope:"row"},tn(i.replace(/_deg (.*)$/," $1_deg"))),ie("td",{},e)),Ky=(i,e,t)=>ie("details",{},ie("summary",{},`${tn(i)} (${e})`),ie("div",{className:"wide",tabIndex:0,role:"region","aria-label":tn(i)},t));function aR(i,e){let t=e.map(a=>Zy(a)),n=[...new Set(t.flatMap(a=>Object.keys(a)))],s=ie("tr",{},...n.map(a=>ie("th",{scope:"col"},tn(a)))),r=t.slice(0,rg).map(a=>ie("tr",{},...n.map(l=>ie("td",{},l in a?Ma(a[l]):"")))),o=e.length>rg?`first ${rg} of ${e.length}`:String(e.length);return Ky(i,o,ie("table",{},ie("thead",{},s),ie("tbody",{},...r)))}function Zy(i,e=""){return Object.entries(i).reduce((t,[n,s])=>og(s)?{...t,...Zy(s,`${e}${n} `)}:{...t,[e+n]:Array.isArray(s)?s.map(Ma).join(", "):s},{})}var Jy=i=>(i??[]).map(({code:e,detail:t})=>ie("p",{className:"warning"},ie("strong",{},tn(e)),` ${Ia(t)}`)),jy=i=>(i??[]).map(e=>({iteration:e.iteration,phase:e.phase,value:e.area??null,residual:e.residual??null}));var Qy=450,ev=0;function ps(){ue.shown=null,ue.quantity=null,qt.show(null,"",at.frame),Z("result").hidden=!0,Z("nothing").hidden=!1,Z("look").hidden=!0,Z("modes").hidden=!0,ig(null),jr("model")}function Pd(i,e,t,n=!1){let s=ue.shown===null||ue.shown.job.kind!==i.kind,r=JSON.parse(t);ue.shown={job:i,mesh:e,solved:t,request:r,dragging:n},Jr(null),iv(),qt.show(e,i.kind,at.frame,ue.quantity),Ve.measure(),Ve.rememberWhetherAllIsSeen(),s&&!ue.cameraGiven&&Ve.fit(!1),ue.cameraGiven=!1,cR(),Z("nothing").hidden=!0,Z("result").hidden=!1,Z("look").hidden=!1,Z("job-id").textContent=i.id;let o=i.statistics;Z("figures").replaceChildren(...Yy(i,wi(r))),Z("warnings").replaceChildren(...Jy(i.warnings)),Z("statistics").replaceChildren(...$y(o)),Z("charts").replaceChildren(...Cd(jy(o.history),"Area",ag(r))),tv(Z("downloads"),["glb","gltf","obj","ply","stl"],i,i.links.mesh);let a=!!(i.links.pattern&&o.flat_pattern);Z("pattern-box").hidden=!a,a&&tv(Z("pattern-downloads"),["svg","dxf"],i,i.links.pattern),zy(i.kind==="ruled_surface",a),lR(i,e),tc()}var ag=i=>typeof i.tolerance=="number"?i.tolerance:He().kind==="minimal_surface"?1e-6:null;function lR(i,e){let t=(Date.parse(i.finished_at??"")-Date.parse(i.started_at??""))/1e3,n=t>0?`Solved in ${Pc(t)}`:"Solved",{converged:s}=i.statistics;bn(`${n}: ${Ti(e.geometry.index.count/3,"triangle")}.${s===!1?" Not converged.":""}`)}function tv(i,e,t,n){i.replaceChildren(...e.map(s=>ie("button",{type:"button",onclick:async()=>{try{io(await wc(`${n}?format=${s}`),`${t.kind.replaceAll("_","-")}-${t.id}.${s}`)}catch(r){Ln(r)}}},s.toUpperCase())))}function tc(){let i=dr();for(let t of document.querySelectorAll("#downloads button, #pattern-downloads button"))t.disabled=i;clearTimeout(ev);let e=()=>{Z("result").classList.toggle("stale",i),Z("stale").hidden=!i,qt.setGhost(i||He().draft!==null),Ve.invalidate()};i&&ue.run&&ue.lastDuration*1e3<Qy?ev=window.setTimeout(e,Qy):e()}function nv(){ue.shown&&(iv(),qt.colourBy(ue.quantity))}function iv(){let{shown:i}=ue;if(!i)return;let{mesh:e,job:t,request:n}=i,s=py(e,t.kind),r=Z("quantity");s.some(({id:o})=>o===ue.colour)||(ue.colour="plain"),r.replaceChildren(...s.map(({id:o,label:a})=>ie("option",{value:o},a))),r.value=ue.colour,ue.quantity=my(e,ue.colour,wi(n),so(n)),ig(ue.quantity)}function cR(){let i={surface:"Surface",edges:"Mesh",lines:"Lines"};Z("layers").replaceChildren(...Object.keys(i).map(e=>{let t=ie("button",{type:"button","aria-pressed":String(qt.layers[e])},i[e]);return t.addEventListener("click",()=>{qt.setLayers({[e]:!qt.layers[e]}),t.setAttribute("aria-pressed",String(qt.layers[e])),Ve.measure()}),t}),uR())}function uR(){let i=ie("button",{type:"button","aria-pressed":String(In.group.visible)},"Drawing");return i.addEventListener("click",()=>{In.group.visible=!In.group.visible,qt.drawn=In.group.visible,qt.restyle(),i.setAttribute("aria-pressed",String(In.group.visible)),Ve.invalidate()}),i}var hR=2e3,dR=300,mr=null,sv=0,Vs=()=>ov(({kind:i,request:e})=>Ec(Mt[i].path,JSON.parse(e))),Id=i=>ov(()=>Promise.resolve(i));async function ov(i){mr=i;let{run:e}=ue;if(e){(e.generation!==ue.generation||performance.now()-e.since>hR)&&lv();return}await Oa(async()=>{for(rv(!0);mr;){let t=mr;mr=null;let{kind:n,request:s,title:r}=He(),o={job:null,since:performance.now(),cancelled:!1,dragging:document.querySelector("canvas:active")!==null,request:JSON.stringify(s),kind:n,title:r,generation:ue.generation};ue.run=o;try{await fR(o,t)}catch(a){mr||(Ln(a),bn("Not solved."))}finally{ue.run=null}}rv(!1),tc()})}async function fR(i,e){i.dragging||bn("Solving…"),ue.pendingJob=null,i.job=await e(i),Td(),i.cancelled&&(i.job=await Wd(i.job)),to(i.job)||(i.job=await pR(i.job)),ue.pendingJob=null;let{job:t}=i;if(t.status==="failed"){if(mr)return;Ln(t.error??{}),bn("Not solved.")}else if(t.status==="cancelled")mr||bn("Cancelled.");else{let n=await fa(await no(`${t.links.mesh}?format=glb`));if(i.generation!==ue.generation||ue.viewing)return;let s=ue.shown;ue.lastDuration=(performance.now()-i.since)/1e3,Pd(t,n,i.request,i.dragging),s?.dragging&&s.job.id!==t.id&&Hg(s.job).catch(()=>{}),i.dragging||Uy(t,i)}ki()}async function pR(i){ue.pendingJob=i.id,ki();let e=[],t=Date.now(),n=window.setInterval(()=>lg(null,e,t),500);lg(null,e,t,i.status==="queued"?"Waiting in the queue":"Running");try{return await Tc(i,s=>{let r=e.at(-1);(!r||r.iteration!==s.iteration||r.phase!==s.phase)&&e.push({iteration:s.iteration,phase:s.phase,value:s.objective_value??null,residual:s.residual??null}),lg(s,e,t)})}finally{clearInterval(n),Z("running-charts").replaceChildren()}}function rv(i){Z("cancel").hidden=!i;let e=Z("progress");clearTimeout(sv),i?(e.removeAttribute("value"),sv=window.setTimeout(()=>{e.hidden=!1},dR)):e.hidden=!0}function lg(i,e,t,n){let s=Pc((Date.now()-t)/1e3),r=e.at(-1),o=Z("progress");i&&(o.value=i.fraction,Z("running-charts").replaceChildren(...Cd(e,He().kind==="minimal_surface"?"Area":"Objective",ag(He().request))));let a=[o.position>0&&`${Math.round(o.position*100)} %`,n??(r?Gy(r.phase):"Running"),r&&r.iteration>0&&`iteration ${wt(r.iteration)}`,s];bn(a.filter(Boolean).join(" · "))}function av(){mr=null,lv()}async function lv(){let{run:i}=ue;if(i&&(i.cancelled=!0,!!i.job))try{await Wd(i.job)}catch(e){Ln(e)}}var mR=1.2,cg=new Ah(Z("gizmo"),Ve,at.frame),wa=()=>Z("live").checked;function Ea({refit:i=!0,direction:e=vd}={}){let{kind:t,request:n}=He();at.lines=Ac(t,n),at.frame=new Ri(Qg(at.lines,n),n),cg.build(at.frame),qt.putInto(at.frame),lt.prune(),Ld(),fs(),Ve.measure(),i&&Ve.fit(!1,e),Od()}function Ld(){let{kind:i,request:e}=He(),t=document.querySelector(`#kinds input[value="${i}"]`);t&&(t.checked=!0),Z("purpose").textContent=Mt[i].purpose;let n=Lc(Fi.openapi,Mt[i].path);n&&Kg(Z("options"),n,e,{openapi:Fi.openapi,set:(s,r)=>{pi.edit(({request:a})=>{r===void 0?delete a[s]:a[s]=r})&&((s==="units"||s==="up")&&(ps(),Ea()),Bi({option:!0}))},describe:(s,r)=>{if(s!=="objective")return;let o=Fi.objectives.find(a=>a.kind===i&&a.name===r);return o?`${wr(o.minimises)} [${o.unit.replaceAll("u",wi(e))}]. ${o.source}.`:void 0}})}function Bi({dragging:i=!1,option:e=!1}={}){Z("intro").hidden=!0,ue.viewing=!1,ue.serverFaulty=new Set,at.lines=Ac(He().kind,He().request),lt.prune(),fs(i),i||(e||Ld(),Ve.measure(),ki()),Od(i),wa()&&Ei(He().kind,He().request)&&He().draft===null&&(!i||ue.lastDuration<mR)&&Vs()}function Od(i=!1){Z("undo").disabled=!pi.canUndo,Z("redo").disabled=!pi.canRedo,Z("draw").setAttribute("aria-pressed",String(lt.drawing)),Z("title").textContent=He().title??"",!i&&Z("request-box").open&&ug(),fr(),tc()}function ug(){Z("request").value=Cc(He().request),Z("request-fault").hidden=!0}var cv=i=>{i()&&(ue.shown&&ue.shown.job.kind!==He().kind&&ps(),Ea({refit:!1}),Ve.rememberWhetherAllIsSeen(),Bi())},hg=()=>cv(()=>pi.undo()),Nd=()=>cv(()=>pi.redo());function gr(i,e,t){ue.viewing=!1,ue.cameraGiven=!1,ue.generation+=1;let n=ue.shown?.job.kind===i;pi.edit(s=>Object.assign(s,{kind:i,request:e,title:t,draft:null})),lt.selection=[],(!n||!Ei(i,e))&&ps(),Td(),Ea()}function Ta(i){ps(),gr(i,Rc(i),null),bn(""),lt.startDrawing()}function uv(i){jr("model"),pi.edit(({request:t})=>{t.objective=i,i!=="maximal_convexity"&&delete t.secondary_objective})&&Bi(),wa()||Vs()}var yt=class extends Error{constructor(e,t){super(t===void 0?e:`Line ${t}: ${e}`)}},ms=i=>`“${i.trim().slice(0,24)}${i.trim().length>24?"…":""}”`;function Dd(i,e){let t=Number(i.trim());if(i.trim()===""||!Number.isFinite(t))throw new yt(`${ms(i)} is not a number.`,e);return t}function oi(i,e=!1){let[t]=i,n=i.at(-1),s=i.length>2&&t.every((r,o)=>r===n[o]);return{points:s?i.slice(0,-1):i,closed:e||s}}function Qr(i,e=1e-7){let n=Math.max(...i.flat(1).flat().map(Math.abs),1e-300)*e,s=c=>c.map(u=>Math.round(u/n)).join(","),r=new Map;i.forEach(([c,u],h)=>{for(let d of[c,u]){let f=r.get(s(d))??[];f.push(h),r.set(s(d),f)}});let o=new Set,a=c=>{let u=[];for(let h=c;;){let d=r.get(s(h))??[],f=d.length<=2?d.find(g=>!o.has(g)):void 0;if(f===void 0)return u;o.add(f);let[m,y]=i[f];h=s(m)===s(h)?y:m,u.push(h)}},l=[];return i.forEach(([c,u],h)=>{if(o.has(h))return;o.add(h);let d=a(u),m=[...a(c).reverse(),c,u,...d],y=m.length>3&&s(m[0])===s(m.at(-1));l.push({points:y?m.slice(0,-1):m,closed:y})}),l}var dv=Bg(hv(),1);function fv(i){let e=!/[,;\t|]/.test(i),{data:t}=dv.default.parse(e?i.replace(/[ ]+/g," ").replace(/^ | $/gm,""):i,{delimiter:e?" ":""}),n=[0,1,2],s=-1,r=[[]],o,a=!1;for(let[l,c]of t.entries()){let u=c.map(h=>h.trim());if(u.every(h=>h==="")){r.at(-1).length>0&&r.push([]);continue}if(!u[0].startsWith("#")){if(!a&&u.every(h=>!Number.isFinite(Number(h))||h==="")){let h=u.map(g=>g.toLowerCase()),d=(...g)=>h.findIndex(_=>g.includes(_)),[f,m,y]=[d("x","easting","e"),d("y","northing","n"),d("z","height","elevation","h")];if(f<0||m<0)throw new yt(`${ms(c.join(","))} names no columns x and y, and is no point.`,l+1);n=[f,m,y],s=d("line","polyline","boundary","curve","id"),a=!0;continue}if(a=!0,u.length<2)throw new yt(`${ms(c.join(","))} is no point: x, y and z are expected.`,l+1);s>=0&&o!==void 0&&u[s]!==o&&r.at(-1).length>0&&r.push([]),o=s>=0?u[s]:void 0,r.at(-1).push(n.map(h=>h<0||(u[h]??"")===""&&h===n[2]?0:Dd(u[h]??"",l+1)))}}return r.filter(l=>l.length>0).map(l=>oi(l))}var nc=class{constructor(e){this._pointer=0,this._eof=!1,this._data=e}next(){if(!this.hasNext())throw this._eof?new Error("Cannot call 'next' after EOF group has been read"):new Error("Unexpected end of input: EOF group not read before end of file. Ended on code "+this._data[this._pointer]);let e={code:parseInt(this._data[this._pointer])};return this._pointer++,e.value=pv(e.code,this._data[this._pointer].trim()),this._pointer++,e.code===0&&e.value==="EOF"&&(this._eof=!0),this.lastReadGroup=e,e}peek(){if(!this.hasNext())throw this._eof?new Error("Cannot call 'next' after EOF group has been read"):new Error("Unexpected end of input: EOF group not read before end of file. Ended on code "+this._data[this._pointer]);let e={code:parseInt(this._data[this._pointer])};return e.value=pv(e.code,this._data[this._pointer+1].trim()),e}rewind(e=1){this._pointer=this._pointer-e*2}hasNext(){return!(this._eof||this._pointer>this._data.length-2)}isEOF(){return this._eof}};function pv(i,e){return i<=9?e:i>=10&&i<=59?parseFloat(e):i>=60&&i<=99?parseInt(e):i>=100&&i<=109?e:i>=110&&i<=149?parseFloat(e):i>=160&&i<=179?parseInt(e):i>=210&&i<=239?parseFloat(e):i>=270&&i<=289?parseInt(e):i>=290&&i<=299?gR(e):i>=300&&i<=369?e:i>=370&&i<=389?parseInt(e):i>=390&&i<=399?e:i>=400&&i<=409?parseInt(e):i>=410&&i<=419?e:i>=420&&i<=429?parseInt(e):i>=430&&i<=439?e:i>=440&&i<=459?parseInt(e):i>=460&&i<=469?parseFloat(e):i>=470&&i<=481||i===999||i>=1e3&&i<=1009?e:i>=1010&&i<=1059?parseFloat(e):i>=1060&&i<=1071?parseInt(e):(console.log("WARNING: Group code does not have a defined type: %j",{code:i,value:e}),e)}function gR(i){if(i==="0")return!1;if(i==="1")return!0;throw TypeError("String '"+i+"' cannot be cast to Boolean type")}var Ud=[0,16711680,16776960,65280,65535,255,16711935,16777215,8421504,12632256,16711680,16744319,13369344,13395558,10027008,10046540,8323072,8339263,4980736,4990502,16727808,16752511,13382400,13401958,10036736,10051404,8331008,8343359,4985600,4992806,16744192,16760703,13395456,13408614,10046464,10056268,8339200,8347455,4990464,4995366,16760576,16768895,13408512,13415014,10056192,10061132,8347392,8351551,4995328,4997670,16776960,16777087,13421568,13421670,10000384,10000460,8355584,8355647,5000192,5000230,12582656,14679935,10079232,11717734,7510016,8755276,6258432,7307071,3755008,4344870,8388352,12582783,6736896,10079334,5019648,7510092,4161280,6258495,2509824,3755046,4194048,10485631,3394560,8375398,2529280,6264908,2064128,5209919,1264640,3099686,65280,8388479,52224,6736998,38912,5019724,32512,4161343,19456,2509862,65343,8388511,52275,6737023,38950,5019743,32543,4161359,19475,2509871,65407,8388543,52326,6737049,38988,5019762,32575,4161375,19494,2509881,65471,8388575,52377,6737074,39026,5019781,32607,4161391,19513,2509890,65535,8388607,52428,6737100,39064,5019800,32639,4161407,19532,2509900,49151,8380415,39372,6730444,29336,5014936,24447,4157311,14668,2507340,32767,8372223,26316,6724044,19608,5010072,16255,4153215,9804,2505036,16383,8364031,13260,6717388,9880,5005208,8063,4149119,4940,2502476,255,8355839,204,6710988,152,5000344,127,4145023,76,2500172,4129023,10452991,3342540,8349388,2490520,6245528,2031743,5193599,1245260,3089996,8323327,12550143,6684876,10053324,4980888,7490712,4128895,6242175,2490444,3745356,12517631,14647295,10027212,11691724,7471256,8735896,6226047,7290751,3735628,4335180,16711935,16744447,13369548,13395660,9961624,9981080,8323199,8339327,4980812,4990540,16711871,16744415,13369497,13395634,9961586,9981061,8323167,8339311,4980793,4990530,16711807,16744383,13369446,13395609,9961548,9981042,8323135,8339295,4980774,4990521,16711743,16744351,13369395,13395583,9961510,9981023,8323103,8339279,4980755,4990511,3355443,5987163,8684676,11382189,14079702,16777215];function _R(i){return Ud[i]}function qe(i){let e={};i.rewind();let t=i.next(),n=t.code;if(e.x=t.value,n+=10,t=i.next(),t.code!=n)throw new Error("Expected code for point value to be "+n+" but got "+t.code+".");return e.y=t.value,n+=10,t=i.next(),t.code!=n?(i.rewind(),e):(e.z=t.value,e)}function vt(i,e,t){switch(e.code){case 0:i.type=e.value;break;case 5:i.handle=e.value;break;case 6:i.lineType=e.value;break;case 8:i.layer=e.value;break;case 48:i.lineTypeScale=e.value;break;case 60:i.visible=e.value===0;break;case 62:i.colorIndex=e.value,i.color=_R(Math.abs(e.value));break;case 67:i.inPaperSpace=e.value!==0;break;case 100:break;case 101:for(;e.code!=0;)e=t.next();t.rewind();break;case 330:i.ownerHandle=e.value;break;case 347:i.materialObjectHandle=e.value;break;case 370:i.lineweight=e.value;break;case 420:i.color=e.value;break;case 1e3:i.extendedData=i.extendedData||{},i.extendedData.customStrings=i.extendedData.customStrings||[],i.extendedData.customStrings.push(e.value);break;case 1001:i.extendedData=i.extendedData||{},i.extendedData.applicationName=e.value;break;default:return!1}return!0}var ic=class{constructor(){this.ForEntityName="3DFACE"}parseEntity(e,t){let n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 70:n.shape=(t.value&1)===1,n.hasContinuousLinetypePattern=(t.value&128)===128;break;case 10:n.vertices=xR(e,t),t=e.lastReadGroup;break;default:vt(n,t,e);break}t=e.next()}return n}};function xR(i,e){var t=[],n=!1,s=!1,r=4;for(let a=0;a<=r;a++){for(var o={};!i.isEOF()&&!(e.code===0||s);){switch(e.code){case 10:case 11:case 12:case 13:if(n){s=!0;continue}o.x=e.value,n=!0;break;case 20:case 21:case 22:case 23:o.y=e.value;break;case 30:case 31:case 32:case 33:o.z=e.value;break;default:return t}e=i.next()}t.push(o),n=!1,s=!1}return i.rewind(),t}var sc=class{constructor(){this.ForEntityName="ARC"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=qe(e);break;case 40:n.radius=t.value;break;case 50:n.startAngle=Math.PI/180*t.value;break;case 51:n.endAngle=Math.PI/180*t.value,n.angleLength=n.endAngle-n.startAngle;break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var rc=class{constructor(){this.ForEntityName="ATTDEF"}parseEntity(e,t){var n={type:t.value,scale:1,textStyle:"STANDARD"};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 1:n.text=t.value;break;case 2:n.tag=t.value;break;case 3:n.prompt=t.value;break;case 7:n.textStyle=t.value;break;case 10:n.startPoint=qe(e);break;case 11:n.endPoint=qe(e);break;case 39:n.thickness=t.value;break;case 40:n.textHeight=t.value;break;case 41:n.scale=t.value;break;case 50:n.rotation=t.value;break;case 51:n.obliqueAngle=t.value;break;case 70:n.invisible=!!(t.value&1),n.constant=!!(t.value&2),n.verificationRequired=!!(t.value&4),n.preset=!!(t.value&8);break;case 71:n.backwards=!!(t.value&2),n.mirrored=!!(t.value&4);break;case 72:n.horizontalJustification=t.value;break;case 73:n.fieldLength=t.value;break;case 74:n.verticalJustification=t.value;break;case 100:break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var oc=class{constructor(){this.ForEntityName="CIRCLE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=qe(e);break;case 40:n.radius=t.value;break;case 50:n.startAngle=Math.PI/180*t.value;break;case 51:let s=Math.PI/180*t.value;s<n.startAngle?n.angleLength=s+2*Math.PI-n.startAngle:n.angleLength=s-n.startAngle,n.endAngle=s;break;default:vt(n,t,e);break}t=e.next()}return n}};var ac=class{constructor(){this.ForEntityName="DIMENSION"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 2:n.block=t.value;break;case 10:n.anchorPoint=qe(e);break;case 11:n.middleOfText=qe(e);break;case 12:n.insertionPoint=qe(e);break;case 13:n.linearOrAngularPoint1=qe(e);break;case 14:n.linearOrAngularPoint2=qe(e);break;case 15:n.diameterOrRadiusPoint=qe(e);break;case 16:n.arcPoint=qe(e);break;case 70:n.dimensionType=t.value;break;case 71:n.attachmentPoint=t.value;break;case 42:n.actualMeasurement=t.value;break;case 1:n.text=t.value;break;case 50:n.angle=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var lc=class{constructor(){this.ForEntityName="ELLIPSE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=qe(e);break;case 11:n.majorAxisEndPoint=qe(e);break;case 40:n.axisRatio=t.value;break;case 41:n.startAngle=t.value;break;case 42:n.endAngle=t.value;break;case 2:n.name=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var cc=class{constructor(){this.ForEntityName="INSERT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 2:n.name=t.value;break;case 41:n.xScale=t.value;break;case 42:n.yScale=t.value;break;case 43:n.zScale=t.value;break;case 10:n.position=qe(e);break;case 50:n.rotation=t.value;break;case 70:n.columnCount=t.value;break;case 71:n.rowCount=t.value;break;case 44:n.columnSpacing=t.value;break;case 45:n.rowSpacing=t.value;break;case 210:n.extrusionDirection=qe(e);break;default:vt(n,t,e);break}t=e.next()}return n}};var uc=class{constructor(){this.ForEntityName="LINE"}parseEntity(e,t){let n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.vertices.unshift(qe(e));break;case 11:n.vertices.push(qe(e));break;case 210:n.extrusionDirection=qe(e);break;case 100:break;default:vt(n,t,e);break}t=e.next()}return n}};var hc=class{constructor(){this.ForEntityName="LWPOLYLINE"}parseEntity(e,t){let n={type:t.value,vertices:[]},s=0;for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 38:n.elevation=t.value;break;case 39:n.depth=t.value;break;case 70:n.shape=(t.value&1)===1,n.hasContinuousLinetypePattern=(t.value&128)===128;break;case 90:s=t.value;break;case 10:n.vertices=yR(s,e);break;case 43:t.value!==0&&(n.width=t.value);break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};function yR(i,e){if(!i||i<=0)throw Error("n must be greater than 0 verticies");let t=[],n=!1,s=!1,r=e.lastReadGroup;for(let o=0;o<i;o++){let a={};for(;!e.isEOF()&&!(r.code===0||s);){switch(r.code){case 10:if(n){s=!0;continue}a.x=r.value,n=!0;break;case 20:a.y=r.value;break;case 30:a.z=r.value;break;case 40:a.startWidth=r.value;break;case 41:a.endWidth=r.value;break;case 42:r.value!=0&&(a.bulge=r.value);break;default:return e.rewind(),n&&t.push(a),e.rewind(),t}r=e.next()}t.push(a),n=!1,s=!1}return e.rewind(),t}var dc=class{constructor(){this.ForEntityName="MTEXT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 3:n.text?n.text+=t.value:n.text=t.value;break;case 1:n.text?n.text+=t.value:n.text=t.value;break;case 10:n.position=qe(e);break;case 11:n.directionVector=qe(e);break;case 40:n.height=t.value;break;case 41:n.width=t.value;break;case 50:n.rotation=t.value;break;case 71:n.attachmentPoint=t.value;break;case 72:n.drawingDirection=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var fc=class{constructor(){this.ForEntityName="POINT"}parseEntity(e,t){let s={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:s.position=qe(e);break;case 39:s.thickness=t.value;break;case 210:s.extrusionDirection=qe(e);break;case 100:break;default:vt(s,t,e);break}t=e.next()}return s}};var pc=class{constructor(){this.ForEntityName="VERTEX"}parseEntity(e,t){var n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.x=t.value;break;case 20:n.y=t.value;break;case 30:n.z=t.value;break;case 40:break;case 41:break;case 42:t.value!=0&&(n.bulge=t.value);break;case 70:n.curveFittingVertex=(t.value&1)!==0,n.curveFitTangent=(t.value&2)!==0,n.splineVertex=(t.value&8)!==0,n.splineControlPoint=(t.value&16)!==0,n.threeDPolylineVertex=(t.value&32)!==0,n.threeDPolylineMesh=(t.value&64)!==0,n.polyfaceMeshVertex=(t.value&128)!==0;break;case 50:break;case 71:n.faceA=t.value;break;case 72:n.faceB=t.value;break;case 73:n.faceC=t.value;break;case 74:n.faceD=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var mc=class{constructor(){this.ForEntityName="POLYLINE"}parseEntity(e,t){var n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:break;case 20:break;case 30:break;case 39:n.thickness=t.value;break;case 40:break;case 41:break;case 70:n.shape=(t.value&1)!==0,n.includesCurveFitVertices=(t.value&2)!==0,n.includesSplineFitVertices=(t.value&4)!==0,n.is3dPolyline=(t.value&8)!==0,n.is3dPolygonMesh=(t.value&16)!==0,n.is3dPolygonMeshClosed=(t.value&32)!==0,n.isPolyfaceMesh=(t.value&64)!==0,n.hasContinuousLinetypePattern=(t.value&128)!==0;break;case 71:break;case 72:break;case 73:break;case 74:break;case 75:break;case 210:n.extrusionDirection=qe(e);break;default:vt(n,t,e);break}t=e.next()}return n.vertices=vR(e,t),n}};function vR(i,e){let t=new pc,n=[];for(;!i.isEOF();)if(e.code===0){if(e.value==="VERTEX")n.push(t.parseEntity(i,e)),e=i.lastReadGroup;else if(e.value==="SEQEND"){bR(i,e);break}}return n}function bR(i,e){let t={type:e.value};for(e=i.next();!i.isEOF()&&e.code!=0;)vt(t,e,i),e=i.next();return t}var gc=class{constructor(){this.ForEntityName="SOLID"}parseEntity(e,t){let n={type:t.value,points:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.points[0]=qe(e);break;case 11:n.points[1]=qe(e);break;case 12:n.points[2]=qe(e);break;case 13:n.points[3]=qe(e);break;case 210:n.extrusionDirection=qe(e);break;default:vt(n,t,e);break}t=e.next()}return n}};var _c=class{constructor(){this.ForEntityName="SPLINE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.controlPoints||(n.controlPoints=[]),n.controlPoints.push(qe(e));break;case 11:n.fitPoints||(n.fitPoints=[]),n.fitPoints.push(qe(e));break;case 12:n.startTangent=qe(e);break;case 13:n.endTangent=qe(e);break;case 40:n.knotValues||(n.knotValues=[]),n.knotValues.push(t.value);break;case 70:(t.value&1)!=0&&(n.closed=!0),(t.value&2)!=0&&(n.periodic=!0),(t.value&4)!=0&&(n.rational=!0),(t.value&8)!=0&&(n.planar=!0),(t.value&16)!=0&&(n.planar=!0,n.linear=!0);break;case 71:n.degreeOfSplineCurve=t.value;break;case 72:n.numberOfKnots=t.value;break;case 73:n.numberOfControlPoints=t.value;break;case 74:n.numberOfFitPoints=t.value;break;case 210:n.normalVector=qe(e);break;default:vt(n,t,e);break}t=e.next()}return n}};var xc=class{constructor(){this.ForEntityName="TEXT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.startPoint=qe(e);break;case 11:n.endPoint=qe(e);break;case 40:n.textHeight=t.value;break;case 41:n.xScale=t.value;break;case 50:n.rotation=t.value;break;case 1:n.text=t.value;break;case 72:n.halign=t.value;break;case 73:n.valign=t.value;break;default:vt(n,t,e);break}t=e.next()}return n}};var ft=Bg(gv());ft.default.setLevel("error");function SR(i){i.registerEntityHandler(ic),i.registerEntityHandler(sc),i.registerEntityHandler(rc),i.registerEntityHandler(oc),i.registerEntityHandler(ac),i.registerEntityHandler(lc),i.registerEntityHandler(cc),i.registerEntityHandler(uc),i.registerEntityHandler(hc),i.registerEntityHandler(dc),i.registerEntityHandler(fc),i.registerEntityHandler(mc),i.registerEntityHandler(gc),i.registerEntityHandler(_c),i.registerEntityHandler(xc)}var Aa=class{constructor(){this._entityHandlers={},SR(this)}parse(e){return typeof e=="string"?this._parse(e):(console.error("Cannot read dxf source of type `"+typeof e),null)}registerEntityHandler(e){let t=new e;this._entityHandlers[t.ForEntityName]=t}parseSync(e){return this.parse(e)}parseStream(e){let t="",n=this;return new Promise((s,r)=>{e.on("data",o=>{t+=o}),e.on("end",()=>{try{s(n._parse(t))}catch(o){r(o)}}),e.on("error",o=>{r(o)})})}_parse(e){let t={},n=0,s=e.split(/\r\n|\r|\n/g),r=new nc(s);if(!r.hasNext())throw Error("Empty file");let o=this,a;function l(){for(a=r.next();!r.isEOF();)if(a.code===0&&a.value==="SECTION"){if(a=r.next(),a.code!==2){console.error("Unexpected code %s after 0:SECTION",_v(a)),a=r.next();continue}a.value==="HEADER"?(ft.default.debug("> HEADER"),t.header=c(),ft.default.debug("<")):a.value==="BLOCKS"?(ft.default.debug("> BLOCKS"),t.blocks=u(),ft.default.debug("<")):a.value==="ENTITIES"?(ft.default.debug("> ENTITIES"),t.entities=M(!1),ft.default.debug("<")):a.value==="TABLES"?(ft.default.debug("> TABLES"),t.tables=d(),ft.default.debug("<")):a.value==="EOF"?ft.default.debug("EOF"):ft.default.warn("Skipping section '%s'",a.value)}else a=r.next()}function c(){let x=null,p=null,S={};for(a=r.next();;){if(gs(a,0,"ENDSEC")){x&&(S[x]=p);break}else a.code===9?(x&&(S[x]=p),x=a.value):a.code===10?p={x:a.value}:a.code===20?p.y=a.value:a.code===30?p.z=a.value:p=a.value;a=r.next()}return a=r.next(),S}function u(){let x={};for(a=r.next();a.value!=="EOF"&&!gs(a,0,"ENDSEC");)if(gs(a,0,"BLOCK")){ft.default.debug("block {");let p=h();ft.default.debug("}"),w(p),p.name?x[p.name]=p:ft.default.error('block with handle "'+p.handle+'" is missing a name.')}else eo(a),a=r.next();return x}function h(){let x={};for(a=r.next();a.value!=="EOF";){switch(a.code){case 1:x.xrefPath=a.value,a=r.next();break;case 2:x.name=a.value,a=r.next();break;case 3:x.name2=a.value,a=r.next();break;case 5:x.handle=a.value,a=r.next();break;case 8:x.layer=a.value,a=r.next();break;case 10:x.position=b(a),a=r.next();break;case 67:x.paperSpace=!!(a.value&&a.value==1),a=r.next();break;case 70:a.value!=0&&(x.type=a.value),a=r.next();break;case 100:a=r.next();break;case 330:x.ownerHandle=a.value,a=r.next();break;case 0:if(a.value=="ENDBLK")break;x.entities=M(!0);break;default:eo(a),a=r.next()}if(gs(a,0,"ENDBLK")){a=r.next();break}}return x}function d(){let x={};for(a=r.next();a.value!=="EOF"&&!gs(a,0,"ENDSEC");)gs(a,0,"TABLE")?(a=r.next(),v[a.value]?(ft.default.debug(a.value+" Table {"),x[v[a.value].tableName]=m(a),ft.default.debug("}")):ft.default.debug("Unhandled Table "+a.value)):a=r.next();return a=r.next(),x}let f="ENDTAB";function m(x){let p=v[x.value],S={},A=0;for(a=r.next();!gs(a,0,f);)switch(a.code){case 5:S.handle=a.value,a=r.next();break;case 330:S.ownerHandle=a.value,a=r.next();break;case 100:a.value==="AcDbSymbolTable"||eo(a),a=r.next();break;case 70:A=a.value,a=r.next();break;case 0:a.value===p.dxfSymbolName?S[p.tableRecordsProperty]=p.parseTableRecords():(eo(a),a=r.next());break;default:eo(a),a=r.next()}let E=S[p.tableRecordsProperty];if(E){let C=(()=>{if(E.constructor===Array)return E.length;if(typeof E=="object")return Object.keys(E).length})();A!==C&&ft.default.warn("Parsed "+C+" "+p.dxfSymbolName+"'s but expected "+A)}return a=r.next(),S}function y(){let x=[],p={};for(ft.default.debug("ViewPort {"),a=r.next();!gs(a,0,f);)switch(a.code){case 2:p.name=a.value,a=r.next();break;case 10:p.lowerLeftCorner=b(a),a=r.next();break;case 11:p.upperRightCorner=b(a),a=r.next();break;case 12:p.center=b(a),a=r.next();break;case 13:p.snapBasePoint=b(a),a=r.next();break;case 14:p.snapSpacing=b(a),a=r.next();break;case 15:p.gridSpacing=b(a),a=r.next();break;case 16:p.viewDirectionFromTarget=b(a),a=r.next();break;case 17:p.viewTarget=b(a),a=r.next();break;case 42:p.lensLength=a.value,a=r.next();break;case 43:p.frontClippingPlane=a.value,a=r.next();break;case 44:p.backClippingPlane=a.value,a=r.next();break;case 45:p.viewHeight=a.value,a=r.next();break;case 50:p.snapRotationAngle=a.value,a=r.next();break;case 51:p.viewTwistAngle=a.value,a=r.next();break;case 79:p.orthographicType=a.value,a=r.next();break;case 110:p.ucsOrigin=b(a),a=r.next();break;case 111:p.ucsXAxis=b(a),a=r.next();break;case 112:p.ucsYAxis=b(a),a=r.next();break;case 110:p.ucsOrigin=b(a),a=r.next();break;case 281:p.renderMode=a.value,a=r.next();break;case 281:p.defaultLightingType=a.value,a=r.next();break;case 292:p.defaultLightingOn=a.value,a=r.next();break;case 330:p.ownerHandle=a.value,a=r.next();break;case 63:case 421:case 431:p.ambientColor=a.value,a=r.next();break;case 0:a.value==="VPORT"&&(ft.default.debug("}"),x.push(p),ft.default.debug("ViewPort {"),p={},a=r.next());break;default:eo(a),a=r.next();break}return ft.default.debug("}"),x.push(p),x}function g(){let x={},p={},S=0,A;for(ft.default.debug("LType {"),a=r.next();!gs(a,0,"ENDTAB");)switch(a.code){case 2:p.name=a.value,A=a.value,a=r.next();break;case 3:p.description=a.value,a=r.next();break;case 73:S=a.value,S>0&&(p.pattern=[]),a=r.next();break;case 40:p.patternLength=a.value,a=r.next();break;case 49:p.pattern.push(a.value),a=r.next();break;case 0:ft.default.debug("}"),S>0&&S!==p.pattern.length&&ft.default.warn("lengths do not match on LTYPE pattern"),x[A]=p,p={},ft.default.debug("LType {"),a=r.next();break;default:a=r.next()}return ft.default.debug("}"),x[A]=p,x}function _(){let x={},p={},S;for(ft.default.debug("Layer {"),a=r.next();!gs(a,0,"ENDTAB");)switch(a.code){case 2:p.name=a.value,S=a.value,a=r.next();break;case 62:p.visible=a.value>=0,p.colorIndex=Math.abs(a.value),p.color=MR(p.colorIndex),a=r.next();break;case 70:p.frozen=(a.value&1)!=0||(a.value&2)!=0,a=r.next();break;case 0:a.value==="LAYER"&&(ft.default.debug("}"),x[S]=p,ft.default.debug("Layer {"),p={},S=void 0,a=r.next());break;default:eo(a),a=r.next();break}return ft.default.debug("}"),x[S]=p,x}let v={VPORT:{tableRecordsProperty:"viewPorts",tableName:"viewPort",dxfSymbolName:"VPORT",parseTableRecords:y},LTYPE:{tableRecordsProperty:"lineTypes",tableName:"lineType",dxfSymbolName:"LTYPE",parseTableRecords:g},LAYER:{tableRecordsProperty:"layers",tableName:"layer",dxfSymbolName:"LAYER",parseTableRecords:_}};function M(x){let p=[],S=x?"ENDBLK":"ENDSEC";for(x||(a=r.next());;)if(a.code===0){if(a.value===S)break;let A=o._entityHandlers[a.value];if(A!=null){ft.default.debug(a.value+" {");let E=A.parseEntity(r,a);a=r.lastReadGroup,ft.default.debug("}"),w(E),p.push(E)}else{ft.default.warn("Unhandled entity "+a.value),a=r.next();continue}}else a=r.next();return S=="ENDSEC"&&(a=r.next()),p}function b(x){let p={},S=x.code;if(p.x=x.value,S+=10,x=r.next(),x.code!=S)throw new Error("Expected code for point value to be "+S+" but got "+x.code+".");return p.y=x.value,S+=10,x=r.next(),x.code!=S?(r.rewind(),p):(p.z=x.value,p)}function w(x){if(!x)throw new TypeError("entity cannot be undefined or null");x.handle||(x.handle=n++)}return l(),t}};function gs(i,e,t){return i.code===e&&i.value===t}function eo(i){ft.default.debug("unhandled group "+_v(i))}function _v(i){return i.code+":"+i.value}function MR(i){return Ud[i]}var xv=Aa;var wR=48;function yv(i){TR(i);let e;try{e=new xv().parseSync(i)?.entities??[]}catch(r){throw new yt(`This is not DXF that can be read: ${r instanceof Error?r.message:String(r)}.`)}let t=[],n=[];for(let r of e){let o=(r.vertices??[]).map(({x:a,y:l,z:c})=>[a,l,c??r.elevation??0]);if(r.type==="LINE"&&o.length>=2)t.push([o[0],o[1]]);else if((r.type==="LWPOLYLINE"||r.type==="POLYLINE")&&o.length>=2)n.push(oi(o,r.shape===!0));else if((r.type==="CIRCLE"||r.type==="ARC")&&r.center&&r.radius)n.push(ER(r));else if(r.type==="SPLINE"){let a=r.fitPoints?.length?r.fitPoints:r.controlPoints??[];a.length>=2&&n.push(oi(a.map(({x:l,y:c,z:u})=>[l,c,u??0]),r.closed===!0))}}let s=[...n,...t.length>0?Qr(t):[]];if(s.length===0)throw new yt("This DXF file has no lines, polylines, arcs or splines.");return s}function ER({type:i,center:e,radius:t=0,startAngle:n=0,endAngle:s=0}){let r=i==="CIRCLE",o=r?2*Math.PI:(s-n+4*Math.PI)%(2*Math.PI)||2*Math.PI,a=Math.max(2,Math.ceil(wR*o/(2*Math.PI)));return{points:Array.from({length:r?a:a+1},(c,u)=>{let h=(r?0:n)+o*u/a;return[e.x+t*Math.cos(h),e.y+t*Math.sin(h),e.z??0]}),closed:r}}function TR(i){let e=i.replace(/\s+$/,"").split(/\r?\n/);for(let t=0;t+1<e.length;t+=2){let n=e[t].trim();if(!/^-?\d+$/.test(n))throw new yt(`${ms(e[t])} is not a DXF group code.`,t+1);let s=Number(n);if(s>=10&&s<60&&!Number.isFinite(Number(e[t+1])))throw new yt(`${ms(e[t+1])} is not a number.`,t+2)}}var AR=["FeatureCollection","Feature","GeometryCollection","LineString","MultiLineString","Polygon","MultiPolygon","Point","MultiPoint"],vv=i=>AR.includes(String(i?.type));function bv(i,e){let t=[],n=[],s=a=>{let l=Array.isArray(a)?a:null;if(!l||l.length<2||!l.slice(0,3).every(c=>typeof c=="number"&&Number.isFinite(c))){let c=JSON.stringify(a)??"nothing";throw new yt(`${c.slice(0,40)} is not a position.`,pg(e,a))}return[l[0],l[1],l[2]??0]},r=a=>{if(!Array.isArray(a))throw new yt(`${(JSON.stringify(a)??"nothing").slice(0,40)} is not a list of positions.`,pg(e,a));return a},o=a=>{if(!a)return;let{type:l,coordinates:c}=a;if(l==="FeatureCollection")r(a.features).forEach(u=>o(u));else if(l==="Feature")o(a.geometry);else if(l==="GeometryCollection")r(a.geometries).forEach(u=>o(u));else if(l==="LineString")t.push(oi(r(c).map(s)));else if(l==="MultiLineString")r(c).forEach(u=>t.push(oi(r(u).map(s))));else if(l==="Polygon")r(c).forEach(u=>t.push(oi(r(u).map(s),!0)));else if(l==="MultiPolygon")r(c).forEach(u=>r(u).forEach(h=>t.push(oi(r(h).map(s),!0))));else if(l==="Point")n.push(s(c));else if(l==="MultiPoint")n.push(...r(c).map(s));else throw new yt(`GeoJSON has no type ${JSON.stringify(l)}.`,pg(e,l))};if(o(i),t.length===0&&n.length>1&&t.push(oi(n)),t.length===0)throw new yt("This GeoJSON has no lines or polygons.");return t}function pg(i,e){let t=JSON.stringify(e);if(!t)return;let n=[...t].map(r=>r.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")).join("\\s*").slice(0,4e3),s=i.search(new RegExp(n));return s<0?void 0:i.slice(0,s).split(`
`).length}function RR(i){let e=JSON.parse(i),t=[],n=[],s=0;for(let{uri:c=""}of e.buffers??[]){let[,u]=/^data:[^,]*;base64,(.*)$/s.exec(c)??[];if(u===void 0)throw new Error("its data lies in another file; save it as GLB or with embedded buffers.");let h=Uint8Array.from(atob(u),d=>d.charCodeAt(0));t.push(s),n.push(h),s+=h.length+3&-4}for(let c of e.bufferViews??[])c.byteOffset=(c.byteOffset??0)+(t[c.buffer]??0),c.buffer=0;e.buffers=[{byteLength:s}];let r=new TextEncoder().encode(JSON.stringify(e)),o=r.length+3&-4,a=new Uint8Array(20+o+8+s).fill(32,20,20+o),l=new DataView(a.buffer);return[1179937895,2,a.length,o,1313821514].forEach((c,u)=>l.setUint32(4*u,c,!0)),a.set(r,20),l.setUint32(20+o,s,!0),l.setUint32(24+o,5130562,!0),n.forEach((c,u)=>a.set(c,28+o+t[u])),a.buffer}async function mg(i){let e=[];try{let t=await new da().parseAsync(typeof i=="string"?RR(i):i,"");t.scene.updateMatrixWorld(!0),t.scene.traverse(n=>{let s=n;if(!s.isLine)return;let r=Om(s),o=l=>new P().fromArray(r,l).applyMatrix4(s.matrixWorld).toArray(),a=[];for(let l=0;l<r.length;l+=6)a.push([o(l),o(l+3)]);a.length>0&&e.push(...Qr(a,1e-6))})}catch(t){throw new yt(`This is not glTF that can be read: ${t instanceof Error?t.message:String(t)}`)}if(e.length===0)throw new yt("This glTF file has no lines.");return e}function Sv(i){let e=[],t=[],n=new Map;if(i.split(/\r?\n/).forEach((r,o)=>{let[a,...l]=r.replace(/#.*/,"").trim().split(/\s+/);if(!a)return;let c=u=>{let h=parseInt(u,10),d=h<0?e.length+h:h-1;if(!e[d])throw new yt(`there is no vertex ${ms(u)}.`,o+1);return d};if(a==="v"){if(l.length<3)throw new yt("a vertex needs x, y and z.",o+1);e.push(l.slice(0,3).map(u=>Dd(u,o+1)))}else if(a==="l")t.push(oi(l.map(u=>e[c(u)])));else if(a==="f"){let u=l.map(c);u.forEach((h,d)=>{let f=u[(d+1)%u.length],m=`${Math.min(h,f)} ${Math.max(h,f)}`;n.set(m,n.has(m)?null:[h,f])})}else if(!/^(vn|vt|vp|p|o|g|s|mtllib|usemtl|mg|cstype|deg|curv|curv2|surf|parm|end)$/.test(a))throw new yt(`${ms(r)} is not OBJ.`,o+1)}),t.length>0)return t.length>1&&t.every(({points:r})=>r.length===2)?Qr(t.map(({points:r})=>r)):t;let s=[...n.values()].filter(r=>r!==null);if(s.length>0)return Qr(s.map(([r,o])=>[e[r],e[o]]));if(e.length>0)return[oi(e)];throw new yt("This OBJ file has no lines, no faces and no vertices.")}var Mv=".csv,.txt,.obj,.dxf,.geojson,.json,.gltf,.glb";async function gg(i){let e=new Uint8Array(await i.slice(0,4).arrayBuffer());return String.fromCharCode(...e)==="glTF"?{lines:await mg(await i.arrayBuffer()),format:"glTF",metres:!0}:_g(await i.text(),/\.(\w+)$/.exec(i.name)?.[1]?.toLowerCase()??"")}async function _g(i,e=""){if(i.trim()==="")throw new yt("There is nothing in it.");let t=i.trimStart();if(["json","geojson","gltf"].includes(e)||e===""&&/^[{[]/.test(t))return CR(i);if(e==="obj"||e===""&&/^\s*(v|l|o|g)\s/m.test(i))return{lines:Sv(i),format:"OBJ",metres:!1};if(e==="dxf"||e===""&&/^\s*(0|999)\s*\r?\n/.test(i))return{lines:yv(i),format:"DXF",metres:!1};let n=fv(i);if(n.length===0)throw new yt("There are no points in it.");return{lines:n,format:"CSV",metres:!1}}async function CR(i){let e=xg(i);if(vv(e))return{lines:bv(e,i),format:"GeoJSON",metres:!1};if(e!==null&&typeof e=="object"&&"asset"in e)return{lines:await mg(i),format:"glTF",metres:!0};if(e===null||typeof e!="object"||Array.isArray(e))throw new yt("This JSON is neither a request nor GeoJSON nor glTF.");let t=e;if(!Pa(t))throw new yt("This JSON is neither a request (with boundaries, directrices or a domain) nor GeoJSON nor glTF.");return{request:t}}function xg(i){try{return JSON.parse(i)}catch(e){let t=e instanceof Error?e.message:String(e),[,n]=/position (\d+)/.exec(t)??[],s=n===void 0?i.split(`
`).length:i.slice(0,Number(n)).split(`
`).length;throw new yt(`this is not JSON: ${t.replace(/ (in JSON )?at position.*$/,"")}.`,s)}}async function wv(i,e){return new Uint8Array(await new Response(new Blob([i]).stream().pipeThrough(e)).arrayBuffer())}async function Ev(i){let e=await wv(new TextEncoder().encode(JSON.stringify(i)),new CompressionStream("deflate-raw")),t="";for(let n=0;n<e.length;n+=32768)t+=String.fromCharCode(...e.subarray(n,n+32768));return btoa(t).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"")}async function Tv(i){let e=Uint8Array.from(atob(i.replaceAll("-","+").replaceAll("_","/")),t=>t.charCodeAt(0));return JSON.parse(new TextDecoder().decode(await wv(e,new DecompressionStream("deflate-raw"))))}var Av=()=>new URL(".",document.baseURI).href.replace(/studio\/$/,""),Rv=async i=>`${Av()}#s=${await Ev(i)}`;async function Cv(i){return`<iframe src="${Av()}studio/embed.html#s=${await Ev(i)}" width="800" height="500" title="Plateau" loading="lazy"></iframe>`}var PR=i=>i.replaceAll("'",String.raw`'\''`);function Pv(i,e){let t=Mc()?' -H "Authorization: Bearer $PLATEAU_KEY"':"",n=new URL(vr("/")).origin;return`# Posts the request, waits for its job, and saves the mesh as surface.glb.
job=$(curl -sS --fail-with-body -D - -o /dev/null${t} -H 'Content-Type: application/json' -X POST '${vr(Mt[i].path)}' --data-binary @- <<'JSON' | tr -d '\\r' | sed -n 's/^[Ll]ocation: //p'
${JSON.stringify(e)}
JSON
)
curl -sS --fail --retry 120 --retry-delay 1 --retry-all-errors${t} -o surface.glb "${PR(n)}$job/mesh?format=glb"
`}function Iv(i,e){let t=Mc()?`,
    "Authorization": "Bearer " + os.environ["PLATEAU_KEY"]`:"";return`import json
import os
import time
import urllib.request

SERVER = "${new URL(vr("/")).origin}"
HEADERS = {
    "Content-Type": "application/json",
    "Prefer": "wait=30"${t},
}
REQUEST = json.loads(r"""${JSON.stringify(e)}""")


def call(url, body=None):
    data = None if body is None else json.dumps(body).encode()
    with urllib.request.urlopen(urllib.request.Request(url, data, HEADERS)) as answer:
        return answer.read()


job = json.loads(call("${vr(Mt[i].path)}", REQUEST))
while job["status"] in ("queued", "running"):
    time.sleep(0.2)
    job = json.loads(call(SERVER + job["links"]["self"]))
if job["status"] != "succeeded":
    raise SystemExit(job["error"])
print(json.dumps({k: v for k, v in job["statistics"].items() if isinstance(v, (int, float))}, indent=1))
with open("surface.glb", "wb") as file:
    file.write(call(SERVER + job["links"]["mesh"] + "?format=glb"))
`.replace(/^import os\n/m,t?`import os
`:"")}function Lv(i,e){let t=Mc()?", Authorization: `Bearer ${process.env.PLATEAU_KEY}`":"";return`import { writeFile } from "node:fs/promises";

interface Job {
  status: "queued" | "running" | "succeeded" | "failed" | "cancelled";
  links: { self: string; mesh: string };
  error: unknown;
}

const server = "${new URL(vr("/")).origin}";
const headers = { "Content-Type": "application/json", Prefer: "wait=30"${t} };
const request = ${JSON.stringify(e)};

async function call(url: string, init: RequestInit = {}): Promise<Response> {
  const answer = await fetch(url, { ...init, headers });
  if (!answer.ok) throw new Error(await answer.text());
  return answer;
}

let job = (await (await call("${vr(Mt[i].path)}", { method: "POST", body: JSON.stringify(request) })).json()) as Job;
while (job.status === "queued" || job.status === "running") {
  job = (await (await call(server + job.links.self)).json()) as Job;
}
if (job.status !== "succeeded") throw new Error(JSON.stringify(job.error));
const mesh = await call(server + job.links.mesh + "?format=glb");
await writeFile("surface.glb", new Uint8Array(await mesh.arrayBuffer()));
`}var yg=i=>Vi(`/v1/examples/${encodeURIComponent(i)}`),yc=i=>Na(()=>yg(i),e=>{let{kind:t,...n}=e.request;ps(),gr(e.kind,n,e.title),Bi(),wa()||bn("Ready.")},Ln),Ov=new Map,LR={ruled_surface:"wavy-strip",uniform_mesh:"vault"};function Dv(i){let e=He();if(e.kind===i)return;Ov.set(e.kind,{request:structuredClone(e.request),title:e.title});let t=Ov.get(i),n=Fi.examples.find(s=>s.kind===i);t?(gr(i,t.request,t.title),Bi()):n?yc(LR[i]??n.name):Ta(i)}var kd=(i,e)=>Na(i,t=>{"lines"in t?OR(t.lines,t.format,t.metres,e):Uv(t.request,e)},t=>Ln({title:e?`${e} cannot be opened`:"This cannot be opened",detail:t instanceof Error?t.message:String(t)}));function OR(i,e,t,n){let{kind:s,request:r}=He(),{line:o,least:a}=Mt[s],l=t?1/so(r):1,c=i.map(({points:d})=>d.map(([f,m,y])=>{let g=t&&r.up!=="y"?[f,-y,m]:[f,m,y];return t?g.map(_=>Number((_*l).toPrecision(9))):g})),u=c.findIndex(d=>d.length<(s==="ruled_surface"?1:a));if(u>=0)throw new yt(`Line ${u+1} of the file has ${Ti(c[u].length,"point")}; a ${o} needs ${a}.`);let h={...structuredClone(r)};for(let d of["normals","tangents","constraints"])delete h[d];if(typeof h.initial_mesh=="object"&&delete h.initial_mesh,s==="ruled_surface")Object.assign(h,{directrices:c,closed:i.length>1&&i.every(({closed:d})=>d)});else if(s==="minimal_surface")h.boundaries=c;else{let d=[...c].sort((f,m)=>Nv(m)-Nv(f));h.domain={polygon:d[0],...d.length>1&&{holes:d.slice(1)}}}gr(s,h,n||`${e} drawing`),Bi(),pr(`${e}: ${Ti(c.length,"line")}, ${Ti(c.reduce((d,f)=>d+f.length,0),"point")}. Undo brings back what was there.`)}var Nv=i=>{let e=[0,1,2].map(t=>Math.max(...i.map(n=>n[t]))-Math.min(...i.map(n=>n[t])));return Math.hypot(...e)};function Uv(i,e){let{kind:t,...n}=i,s=Pa(i)??He().kind;if(t!==void 0&&!(String(t)in Mt))throw new yt(`This server has no kind ${JSON.stringify(t)}.`);gr(s,n,e),Bi()}function Fv(){let i=e=>{Z("request-fault").textContent=e,Z("request-fault").hidden=!1};Z("request-fault").hidden=!0;try{let e=xg(Z("request").value);if(e===null||typeof e!="object"||Array.isArray(e)){i("A request is an object, { … }.");return}Uv(e.kind!==void 0||Pa(e)?e:{...e,kind:He().kind},He().title)}catch(e){i(e instanceof Error?e.message:String(e))}}async function vg(){let[,i]=/^#s=(.+)$/.exec(location.hash)??[];if(!i)return null;try{let e=await Tv(i);if(fi||window.history.replaceState(null,"",location.pathname+location.search),Zm(e))return e}catch{}return pr("This link is damaged: it does not hold a request."),null}var kv=()=>Na(vg,i=>{if(!i)return;let{kind:e,request:t,title:n,camera:s,colour:r}=i;ps(),ue.colour=r??"plain",gr(e,t,n??null),s&&Md(s),Bi(),Ei(e,t)||bn("")},Ln);async function Bv(){let i=Z("recent-list");i.replaceChildren(ie("p",{className:"quiet"},"Asking the server…")),Z("recent").showModal();try{let{jobs:e}=await Vi("/v1/jobs?limit=30"),t=new Map(Qm().map(s=>[s.id,s])),n=e.map(s=>{let r=t.get(s.id),o=ie("button",{type:"button",disabled:!["succeeded","running","queued"].includes(s.status)},"Open");return o.setAttribute("aria-label",`Open ${r?.title??s.kind} of ${s.created_at}`),o.addEventListener("click",()=>{Z("recent").close(),NR(s,r)}),ie("tr",{},ie("th",{scope:"row"},r?.title??Mt[s.kind].label),ie("td",{},s.status),ie("td",{},new Date(s.created_at).toLocaleString()),ie("td",{},o))});i.replaceChildren(n.length>0?ie("table",{className:"plain"},ie("tbody",{},...n)):ie("p",{className:"quiet"},"No jobs yet."))}catch(e){i.replaceChildren(ie("p",{className:"fault"},e instanceof Error?e.message:String(e)))}}var NR=(i,e)=>Na(async()=>{let t=await Vi(i.links.self),n=e||t.status!=="succeeded"?null:await fa(await no(`${t.links.mesh}?format=glb`));return{job:t,mesh:n}},({job:t,mesh:n})=>{e?(ps(),gr(e.kind,JSON.parse(e.request),e.title),Id(t)):n?DR(t,n):bn("This job has no result yet, and this browser does not know its drawing.")},Ln);function DR(i,e){ue.viewing=!0,ps();let{unit:t,up:n}=e.extras,s={units:t,up:n},[r,o,a]=e.extras.origin??[0,0,0];at.frame=new Ri([r,o,a],s),fs(),Pd(i,e,JSON.stringify(s)),Ve.fit(!1,vd),Od()}var UR={kind:"minimal_surface",title:"A saddle canopy",request:{boundaries:[Array.from({length:24},(i,e)=>{let t=e*Math.PI/12;return[7*Math.cos(t),5.5*Math.sin(t),2.6+2*Math.cos(2*t)].map(n=>Number(n.toFixed(3)))})],objective:"minimal_area",resolution:{triangles:2e3}}},bg=()=>new URLSearchParams(location.search).get("example"),Bd=()=>Oa(async()=>{Z("problem").hidden=!0;try{await Promise.all([FR(),kR()])}catch(i){Ln(i),bn("Not ready."),i instanceof zi&&i.status===401&&Z("settings").showModal()}});async function FR(){let i=await vg()??(bg()!==null||fi?null:Dy());if(i){await BR(i);return}let e=bg()===null?null:await yg(bg()).catch(o=>{if(o instanceof zi&&o.status===404)return null;throw o}),{kind:t,title:n,request:{kind:s,...r}}=e??UR;Object.assign(pi.document,{kind:t,request:r,title:n}),Ea(),Z("intro").hidden=e!==null,fr(),await Vs()}async function kR(){let[i,{objectives:e},{examples:t}]=await Promise.all([Vi("/openapi.json"),Vi("/v1/objectives"),Vi("/v1/examples")]);Object.assign(Fi,{openapi:i,objectives:e,examples:t}),zR(),Ld(),Z("gallery-list").replaceChildren(...jg(t,({name:n})=>{Z("gallery").close(),yc(n)})),ue.ready=!0,ki()}async function BR({kind:i,request:e,draft:t,title:n,camera:s,colour:r,job:o}){Object.assign(pi.document,{kind:i,request:e,draft:t??null,title:n??null}),ue.colour=r??"plain",Ea(),s&&Md(s);let a=o?await Vi(`/v1/jobs/${o}`).catch(()=>null):null;a&&a.status!=="cancelled"&&a.status!=="failed"?await Id(a):Ei(i,e)&&He().draft===null&&await Vs()}function zR(){let i=Object.keys(Mt).filter(t=>Lc(Fi.openapi,Mt[t].path)),e=Z("kinds").querySelector("legend");Z("kinds").replaceChildren(e,...i.map(t=>{let n=ie("input",{type:"radio",name:"kind",value:t});return n.addEventListener("change",()=>Dv(t)),ie("label",{},n,Mt[t].label)})),Z("blank-starts").replaceChildren(...i.map(t=>ie("button",{type:"button",onclick:()=>{Z("gallery").close(),Ta(t)}},`Draw a ${Mt[t].label.toLowerCase()}`)))}var zv="theme";function Vv(){return localStorage.getItem(zv)??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function Sg(i){document.documentElement.dataset.theme=i,Z("theme").setAttribute("aria-pressed",String(i==="dark"));let e=bd[i];Object.assign(Jl,e.look),In.restyle(e.sketch),Ve.grid.style(...e.grid),Ve.shadow.style(e.shadow),qt.restyle(),ba.restyle(),fs(),Ve.invalidate()}function Hv(){let i=document.documentElement.dataset.theme==="dark"?"light":"dark";Sg(i),localStorage.setItem(zv,i)}var VR=["Link","Embed","curl","Python","TypeScript"],Mg=0;async function Gv(){await Wv("Link"),Z("share").showModal()}async function Wv(i){Mg+=1;let e=Mg,{kind:t,request:n,title:s}=He(),r={kind:t,request:n,title:s,camera:jm(),colour:ue.colour},o=i==="Link"?await Rv(r):i==="Embed"?await Cv(r):i==="curl"?Pv(t,n):i==="Python"?Iv(t,n):Lv(t,n);e===Mg&&(Z("share-forms").replaceChildren(...VR.map(a=>ie("button",{type:"button","aria-pressed":String(a===i),onclick:()=>{Wv(a)}},a))),Z("share-text").value=o,Z("copied").textContent="")}async function Xv(){try{await navigator.clipboard.writeText(Z("share-text").value),Z("copied").textContent="Copied."}catch{Z("share-text").select(),Z("copied").textContent="Press Ctrl C: the browser does not let this page copy."}}async function qv(){io(await Ve.picture(2,document.documentElement.dataset.theme==="dark"?"#1a2023":"#f3f4f3"),"plateau.png")}var wg="api-key",At=(i,e,t)=>Z(i).addEventListener(e,n=>{t(n)}),zd=i=>document.querySelectorAll(i);function $v(){HR(),GR(),WR(),XR(),qR(),document.addEventListener("keydown",YR),window.addEventListener("pagehide",Jm),window.addEventListener("hashchange",()=>{location.hash.startsWith("#s=")&&ue.ready&&kv()})}function Eg(i){document.querySelector("main").dataset.panel=i;for(let e of zd("[data-panel]:is(button)"))e.setAttribute("aria-pressed",String(e.dataset.panel===i))}function HR(){At("solve","click",()=>Ei(He().kind,He().request)?Vs():bn(qm())),At("cancel","click",av),At("live","change",()=>wa()&&dr()&&Vs()),At("request-box","toggle",()=>{Z("request-box").open&&ug()}),At("apply-request","click",Fv),At("save-request","click",()=>io(new Blob([Cc({kind:He().kind,...He().request})],{type:"application/json"}),`${He().kind.replaceAll("_","-")}.json`));for(let i of zd("[data-panel]:is(button)"))i.addEventListener("click",()=>Eg(i.dataset.panel));for(let i of["point","options","key-form","drawing"])At(i,"submit",e=>e.preventDefault())}function GR(){At("draw","click",()=>lt.drawing?lt.stopDrawing():lt.startDrawing()),At("undo","click",hg),At("redo","click",Nd),At("finish","click",()=>lt.finishDrawing()),At("give-up","click",()=>lt.stopDrawing()),At("snap","change",()=>{lt.snapping=Z("snap").checked}),At("level","change",()=>{lt.level=Z("level").valueAsNumber||0}),At("previous-point","click",()=>lt.step(-1)),At("next-point","click",()=>lt.step(1)),At("insert-point","click",()=>lt.insert()),At("delete-point","click",()=>lt.remove()),At("remove-line","click",()=>lt.removeLine()),At("intro-draw","click",()=>Ta("minimal_surface"));for(let e of document.querySelectorAll("#point input"))e.addEventListener("input",()=>{e.dataset.dirty="1"}),e.addEventListener("blur",()=>{delete e.dataset.dirty}),e.addEventListener("change",()=>{delete e.dataset.dirty;let t=qg(e.value);Number.isFinite(t)?e.id==="edge"?lt.setEdgeBefore(t):lt.setAxis(Number(e.dataset.axis),t):(e.value.trim()!==""&&pr(`${JSON.stringify(e.value)} is not a number.`),Ym())});let i=Z("entry");i.addEventListener("keydown",e=>{if(e.key!=="Enter")return;if(e.preventDefault(),e.stopPropagation(),i.value.trim()===""){lt.finishDrawing();return}let t=lt.enter(i.value);t?pr(t):i.value=""})}function WR(){let i={top:[0,1,.001],front:[0,.02,1],side:[1,.02,0]};for(let e of zd("[data-view]"))e.addEventListener("click",()=>{let t=i[e.dataset.view];t?Ve.look(t):By()});for(let e of zd("[data-mode]"))e.addEventListener("click",()=>jr(e.dataset.mode));At("quantity","change",()=>{ue.colour=Z("quantity").value,Jr(null),nv(),Ve.invalidate(),ki()}),At("theme","click",Hv)}function XR(){let i=Z("file");i.accept=Mv,At("open-file","click",()=>i.click()),At("file","change",async()=>{let[e]=i.files??[];e&&await kd(()=>gg(e),e.name),i.value=""}),document.addEventListener("dragover",e=>{e.preventDefault(),document.body.classList.add("dropping")}),document.addEventListener("dragleave",e=>{e.relatedTarget||document.body.classList.remove("dropping")}),document.addEventListener("drop",e=>{e.preventDefault(),document.body.classList.remove("dropping"),Yv(e.dataTransfer)}),document.addEventListener("paste",e=>{!e.target.matches("input, textarea")&&Yv(e.clipboardData)&&e.preventDefault()})}function Yv(i){let[e]=i?.files??[],t=i?.getData("text/plain")??"";if(e)kd(()=>gg(e),e.name);else if(t.trim()!=="")kd(()=>_g(t),"");else return!1;return!0}function qR(){let i=()=>Z("gallery").showModal();At("open-gallery","click",i),At("intro-gallery","click",i),At("open-recent","click",Bv),At("open-share","click",Gv),At("open-settings","click",()=>Z("settings").showModal()),At("copy","click",Xv),At("picture","click",qv);for(let n of document.querySelectorAll("dialog"))n.querySelector("[data-close]").addEventListener("click",()=>n.close()),n.addEventListener("click",s=>{s.target===n&&n.close()});let e=Z("api-key"),t=sessionStorage.getItem(wg);t&&(e.value=t,Gd(t)),e.addEventListener("change",()=>{Gd(e.value),e.value?sessionStorage.setItem(wg,e.value):sessionStorage.removeItem(wg),Z("settings").close(),ue.ready||Bd()})}function YR(i){let e=i.target,t=e.matches('input:not([type="radio"], [type="checkbox"]), textarea, select')||document.querySelector("dialog[open]")!==null,n=i.ctrlKey||i.metaKey,s=i.key.toLowerCase();if(n&&!t&&s==="z")(i.shiftKey?Nd:hg)();else if(n&&!t&&s==="y")Nd();else if(lt.drawing&&i.key==="Enter"&&!e.matches("button, summary, a"))lt.finishDrawing();else if(lt.drawing&&i.key==="Escape")lt.stopDrawing();else if(lt.drawing&&!t&&!n&&/^[\d.,@-]$/.test(i.key)){let r=Z("entry");r.focus(),r.value+=i.key}else return;i.preventDefault()}Object.assign(at,{changed:i=>Bi({dragging:i}),selectionChanged:fr,label:Jr,read:Ly,announce:Iy});ba.use=uv;Ve.under=(i,e)=>qt.pick(Ve,i,e)?.point??null;Ve.content=()=>[...In.places,...qt.outline()];Ve.onDraw=()=>{cg.place(),$m()};Ve.onRest=()=>{Ve.rememberWhetherAllIsSeen(),ki()};Z("no-webgl").hidden=Ve.renderer!==null;fi&&new URLSearchParams(location.search).get("ground")==="none"&&(Ve.grid.mesh.visible=!1);$v();Sg(Vv());Eg("setup");Z("look").hidden=!0;Bd();Object.assign(window,{studio:{request:()=>structuredClone(He().request),kind:()=>He().kind,draft:()=>structuredClone(He().draft),shown:()=>ue.shown?{job:ue.shown.job.id,solved:ue.shown.solved,stale:dr()}:null,faulty:()=>[...at.faulty],selection:()=>lt.selection,points:()=>In.places.map(i=>Ve.project(i)),project:i=>Ve.project(at.frame.toScene(i)),covers:(i,e)=>qt.pick(Ve,i,e)!==null,fit:()=>Ve.fit(!1),draw:()=>Ve.draw(),openExample:yc}});
