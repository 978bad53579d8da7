var fS=Object.create;var w0=Object.defineProperty;var pS=Object.getOwnPropertyDescriptor;var mS=Object.getOwnPropertyNames;var gS=Object.getPrototypeOf,_S=Object.prototype.hasOwnProperty;var M0=(i,e)=>()=>{try{return e||i((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var yS=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of mS(e))!_S.call(i,s)&&s!==t&&w0(i,s,{get:()=>e[s],enumerable:!(n=pS(e,s))||n.enumerable});return i};var E0=(i,e,t)=>(t=i!=null?fS(gS(i)):{},yS(e||!i||!i.__esModule?w0(t,"default",{value:i,enumerable:!0}):t,i));var Eb=M0((Zg,Qg)=>{"use strict";((i,e)=>{typeof define=="function"&&define.amd?define([],e):typeof Qg=="object"&&typeof Zg<"u"?Qg.exports=e():i.Papa=e()})(Zg,function i(){var e=typeof self<"u"?self:typeof window<"u"?window:e!==void 0?e:{},t=!e.document&&!!e.postMessage,n=e.IS_PAPA_WORKER||!1,s={},r=0,o={};function a(y){return y.charCodeAt(0)===65279?y.slice(1):y}function l(y){this._handle=null,this._finished=!1,this._completed=!1,this._halted=!1,this._input=null,this._baseIndex=0,this._partialLine="",this._rowCount=0,this._start=0,this._nextChunk=null,this.isFirstChunk=!0,this._completeResults={data:[],errors:[],meta:{}},function(p){var w=M(p);w.chunkSize=parseInt(w.chunkSize),p.step||p.chunk||(w.chunkSize=null),this._handle=new f(w),(this._handle.streamer=this)._config=w}.call(this,y),this.parseChunk=function(p,w){var T=parseInt(this._config.skipFirstNLines)||0;if(this.isFirstChunk&&0<T){let C=this._config.newline;C||(E=this._config.quoteChar||'"',C=this._handle.guessLineEndings(p,E)),p=[...p.split(C).slice(T)].join(C)}this.isFirstChunk&&S(this._config.beforeFirstChunk)&&(E=this._config.beforeFirstChunk(p))!==void 0&&(p=E),this.isFirstChunk=!1,this._halted=!1;var T=this._partialLine+p,E=(this._partialLine="",this._handle.parse(T,this._baseIndex,!this._finished));if(!this._handle.paused()&&!this._handle.aborted()){if(p=E.meta.cursor,T=(this._finished||(this._partialLine=T.substring(p-this._baseIndex),this._baseIndex=p),E&&E.data&&(this._rowCount+=E.data.length),this._finished||this._config.preview&&this._rowCount>=this._config.preview),n)e.postMessage({results:E,workerId:o.WORKER_ID,finished:T});else if(S(this._config.chunk)&&!w){if(this._config.chunk(E,this._handle),this._handle.paused()||this._handle.aborted())return void(this._halted=!0);this._completeResults=E=void 0}return this._config.step||this._config.chunk||(this._completeResults.data=this._completeResults.data.concat(E.data),this._completeResults.errors=this._completeResults.errors.concat(E.errors),this._completeResults.meta=E.meta),this._completed||!T||!S(this._config.complete)||E&&E.meta.aborted||(this._config.complete(this._completeResults,this._input),this._completed=!0),T||E&&E.meta.paused||this._nextChunk(),E}this._halted=!0},this._sendError=function(p){S(this._config.error)?this._config.error(p):n&&this._config.error&&e.postMessage({workerId:o.WORKER_ID,error:p,finished:!1})}}function c(y){var p;(y=y||{}).chunkSize||(y.chunkSize=o.RemoteChunkSize),l.call(this,y),this._nextChunk=t?function(){this._readChunk(),this._chunkLoaded()}:function(){this._readChunk()},this.stream=function(w){this._input=w,this._nextChunk()},this._readChunk=function(){if(this._finished)this._chunkLoaded();else{if(p=new XMLHttpRequest,this._config.withCredentials&&(p.withCredentials=this._config.withCredentials),t||(p.onload=b(this._chunkLoaded,this),p.onerror=b(this._chunkError,this)),p.ontimeout=b(this._chunkTimeout,this),p.open(this._config.downloadRequestBody?"POST":"GET",this._input,!t),this._config.downloadTimeout&&!t&&(p.timeout=this._config.downloadTimeout),this._config.downloadRequestHeaders){var w,T=this._config.downloadRequestHeaders;for(w in T)p.setRequestHeader(w,T[w])}var E;this._config.chunkSize&&(E=this._start+this._config.chunkSize-1,p.setRequestHeader("Range","bytes="+this._start+"-"+E));try{p.send(this._config.downloadRequestBody)}catch(C){this._chunkError(C.message)}t&&p.status===0&&this._chunkError()}},this._chunkLoaded=function(){p.readyState===4&&(p.status<200||400<=p.status?this._chunkError():(this._start+=this._config.chunkSize||p.responseText.length,this._finished=!this._config.chunkSize||this._start>=(w=>(w=w.getResponseHeader("Content-Range"))!==null?parseInt(w.substring(w.lastIndexOf("/")+1)):-1)(p),this.parseChunk(p.responseText)))},this._chunkError=function(w){w=p.statusText||w,this._sendError(new Error(w))},this._chunkTimeout=function(){this._chunkError("Request timed out after "+this._config.downloadTimeout+"ms")}}function u(y){(y=y||{}).chunkSize||(y.chunkSize=o.LocalChunkSize),l.call(this,y);var p,w,T=typeof FileReader<"u";this.stream=function(E){this._input=E,w=E.slice||E.webkitSlice||E.mozSlice,T?((p=new FileReader).onload=b(this._chunkLoaded,this),p.onerror=b(this._chunkError,this)):p=new FileReaderSync,this._nextChunk()},this._nextChunk=function(){this._finished||this._config.preview&&!(this._rowCount<this._config.preview)||this._readChunk()},this._readChunk=function(){var E=this._input,C=(this._config.chunkSize&&(C=Math.min(this._start+this._config.chunkSize,this._input.size),E=w.call(E,this._start,C)),p.readAsText(E,this._config.encoding));T||this._chunkLoaded({target:{result:C}})},this._chunkLoaded=function(E){this._start+=this._config.chunkSize,this._finished=!this._config.chunkSize||this._start>=this._input.size,this.parseChunk(E.target.result)},this._chunkError=function(){this._sendError(p.error)}}function h(y){var p;l.call(this,y=y||{}),this.stream=function(w){return p=w,this._nextChunk()},this._nextChunk=function(){var w,T;if(!this._finished)return w=this._config.chunkSize,p=w?(T=p.substring(0,w),p.substring(w)):(T=p,""),this._finished=!p,this.parseChunk(T)}}function d(y){l.call(this,y=y||{});var p=[],w=!0,T=!1;this.pause=function(){l.prototype.pause.apply(this,arguments),this._input.pause()},this.resume=function(){l.prototype.resume.apply(this,arguments),this._input.resume()},this.stream=function(E){this._input=E,this._input.on("data",this._streamData),this._input.on("end",this._streamEnd),this._input.on("error",this._streamError)},this._checkIsFinished=function(){T&&p.length===1&&(this._finished=!0)},this._nextChunk=function(){this._checkIsFinished(),p.length?this.parseChunk(p.shift()):w=!0},this._streamData=b(function(E){try{p.push(typeof E=="string"?E:E.toString(this._config.encoding)),w&&(w=!1,this._checkIsFinished(),this.parseChunk(p.shift()))}catch(C){this._streamError(C)}},this),this._streamError=b(function(E){this._streamCleanUp(),this._sendError(E)},this),this._streamEnd=b(function(){this._streamCleanUp(),T=!0,this._streamData("")},this),this._streamCleanUp=b(function(){this._input.removeListener("data",this._streamData),this._input.removeListener("end",this._streamEnd),this._input.removeListener("error",this._streamError)},this)}function f(y){var p,w,T,E,C=Math.pow(2,53),O=-C,U=/^\s*-?(\d+\.?|\.\d+|\d+\.\d+)([eE][-+]?\d+)?\s*$/,I=/^((\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\d\.\d+([+-][0-2]\d:[0-5]\d|Z))|(\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-5]\d([+-][0-2]\d:[0-5]\d|Z))|(\d{4}-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d([+-][0-2]\d:[0-5]\d|Z)))$/,D=this,V=0,F=0,ie=!1,z=!1,q=[],W={data:[],errors:[],meta:{}};function _e(se){return y.skipEmptyLines==="greedy"?se.join("").trim()==="":se.length===1&&se[0].length===0}function Te(){if(W&&T&&(ae("Delimiter","UndetectableDelimiter","Unable to auto-detect delimiting character; defaulted to '"+o.DefaultDelimiter+"'"),T=!1),y.skipEmptyLines&&(W.data=W.data.filter(function($e){return!_e($e)})),K()){let $e=function(Ae){q.push(Ae)};var de=$e;if(W)if(Array.isArray(W.data[0])){for(var se=0;K()&&se<W.data.length;se++)W.data[se].forEach($e);W.data.splice(0,1)}else W.data.forEach($e)}function ue($e,Ae){for(var Ve=y.header?{}:[],Le=0;Le<$e.length;Le++){var we=Le,gt=$e[Le],gt=((We,at)=>(Qe=>(y.dynamicTypingFunction&&y.dynamicTyping[Qe]===void 0&&(y.dynamicTyping[Qe]=y.dynamicTypingFunction(Qe)),(y.dynamicTyping[Qe]||y.dynamicTyping)===!0))(We)?at==="true"||at==="TRUE"||at!=="false"&&at!=="FALSE"&&((Qe=>{if(U.test(Qe)&&(Qe=parseFloat(Qe),O<Qe&&Qe<C))return 1})(at)?parseFloat(at):I.test(at)?new Date(at):at===""?null:at):at)(we=y.header?Le>=q.length?"__parsed_extra":q[Le]:we,gt=y.transform?y.transform(gt,we):gt);we==="__parsed_extra"?(Ve[we]=Ve[we]||[],Ve[we].push(gt)):Ve[we]=gt}return y.header&&(Le>q.length?ae("FieldMismatch","TooManyFields","Too many fields: expected "+q.length+" fields but parsed "+Le,F+Ae):Le<q.length&&ae("FieldMismatch","TooFewFields","Too few fields: expected "+q.length+" fields but parsed "+Le,F+Ae)),Ve}var re;W&&(y.header||y.dynamicTyping||y.transform)&&(re=1,!W.data.length||Array.isArray(W.data[0])?(W.data=W.data.map(ue),re=W.data.length):W.data=ue(W.data,0),y.header&&W.meta&&(W.meta.fields=q),F+=re)}function K(){return y.header&&q.length===0}function ae(se,ue,re,de){se={type:se,code:ue,message:re},de!==void 0&&(se.row=de),W.errors.push(se)}S(y.step)&&(E=y.step,y.step=function(se){W=se,K()?Te():(Te(),W.data.length!==0&&(V+=se.data.length,y.preview&&V>y.preview?w.abort():(W.data=W.data[0],E(W,D))))}),this.parse=function(se,ue,re){var de=y.quoteChar||'"',de=(y.newline||(y.newline=this.guessLineEndings(se,de)),T=!1,y.delimiter?S(y.delimiter)&&(y.delimiter=y.delimiter(se),W.meta.delimiter=y.delimiter):((de=(($e,Ae,Ve,Le,we)=>{var gt,We,at,Qe;we=we||[",","	","|",";",o.RECORD_SEP,o.UNIT_SEP];for(var Mn=0;Mn<we.length;Mn++){for(var Ot,yn=we[Mn],At=0,Jt=0,B=0,kt=(at=void 0,new x({comments:Le,delimiter:yn,newline:Ae,preview:10}).parse($e)),_t=0;_t<kt.data.length;_t++)Ve&&_e(kt.data[_t])?B++:(Ot=kt.data[_t].length,Jt+=Ot,at===void 0?at=Ot:0<Ot&&(At+=Math.abs(Ot-at),at=Ot));0<kt.data.length&&(Jt/=kt.data.length-B),1.99<Jt&&(We===void 0||At<We||At===We&&Qe<Jt)&&(We=At,gt=yn,Qe=Jt)}return{successful:!!(y.delimiter=gt),bestDelimiter:gt}})(se,y.newline,y.skipEmptyLines,y.comments,y.delimitersToGuess)).successful?y.delimiter=de.bestDelimiter:(T=!0,y.delimiter=o.DefaultDelimiter),W.meta.delimiter=y.delimiter),M(y));return de.header=K(),y.preview&&y.header&&de.preview++,p=se,w=new x(de),W=w.parse(p,ue,re),Te(),ie?{meta:{paused:!0}}:W||{meta:{paused:!1}}},this.paused=function(){return ie},this.pause=function(){ie=!0,w.abort(),p=S(y.chunk)?"":p.substring(w.getCharIndex())},this.resume=function(){D.streamer._halted?(ie=!1,D.streamer.parseChunk(p,!0)):setTimeout(D.resume,3)},this.aborted=function(){return z},this.abort=function(){z=!0,w.abort(),W.meta.aborted=!0,S(y.complete)&&y.complete(W),p=""},this.guessLineEndings=function($e,de){$e=$e.substring(0,1048576);var de=new RegExp(g(de)+"([^]*?)"+g(de),"gm"),re=($e=$e.replace(de,"")).split("\r"),de=$e.split(`
`),$e=1<de.length&&de[0].length<re[0].length;if(re.length===1||$e)return`
`;for(var Ae=0,Ve=0;Ve<re.length;Ve++)re[Ve][0]===`
`&&Ae++;return Ae>=re.length/2?`\r
`:"\r"}}function g(y){return y.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")}function x(y){var p=(y=y||{}).delimiter,w=y.newline,T=y.comments,E=y.step,C=y.preview,O=y.fastMode,U=null,I=!1,D=y.quoteChar==null?'"':y.quoteChar,V=D;if(y.escapeChar!==void 0&&(V=y.escapeChar),(typeof p!="string"||-1<o.BAD_DELIMITERS.indexOf(p))&&(p=","),T===p)throw new Error("Comment character same as delimiter");T===!0?T="#":(typeof T!="string"||-1<o.BAD_DELIMITERS.indexOf(T))&&(T=!1),w!==`
`&&w!=="\r"&&w!==`\r
`&&(w=`
`);var F=0,ie=!1;this.parse=function(z,q,W){if(typeof z!="string")throw new Error("Input must be a string");var _e=z.length,Te=p.length,K=w.length,ae=T.length,se=S(E),ue=[],re=[],de=[],$e=F=0;if(!z)return At();if(O||O!==!1&&z.indexOf(D)===-1){for(var Ae=z.split(w),Ve=0;Ve<Ae.length;Ve++){if(de=Ae[Ve],F+=de.length,Ve!==Ae.length-1)F+=w.length;else if(W)return At();if(!T||de.substring(0,ae)!==T){if(se){if(ue=[],Qe(de.split(p)),Jt(),ie)return At()}else Qe(de.split(p));if(C&&C<=Ve)return ue=ue.slice(0,C),At(!0)}}return At()}for(var Le=z.indexOf(p,F),we=z.indexOf(w,F),gt=new RegExp(g(V)+g(D),"g"),We=z.indexOf(D,F);;)if(z[F]===D)for(We=F,F++;;){if((We=z.indexOf(D,We+1))===-1)return W||re.push({type:"Quotes",code:"MissingQuotes",message:"Quoted field unterminated",row:ue.length,index:F}),Ot();if(We===_e-1)return Ot(z.substring(F,We).replace(gt,D));if(D===V&&z[We+1]===V)We++;else if(D===V||We===0||z[We-1]!==V){Le!==-1&&Le<We+1&&(Le=z.indexOf(p,We+1));var at=Mn((we=we!==-1&&we<We+1?z.indexOf(w,We+1):we)===-1?Le:Math.min(Le,we));if(z.substr(We+1+at,Te)===p){de.push(z.substring(F,We).replace(gt,D)),z[F=We+1+at+Te]!==D&&(We=z.indexOf(D,F)),Le!==-1&&Le<F&&(Le=z.indexOf(p,F)),we!==-1&&we<F&&(we=z.indexOf(w,F));break}if(at=Mn(we),z.substring(We+1+at,We+1+at+K)===w){if(de.push(z.substring(F,We).replace(gt,D)),yn(We+1+at+K),Le!==-1&&Le<F&&(Le=z.indexOf(p,F)),We=z.indexOf(D,F),se&&(Jt(),ie))return At();if(C&&ue.length>=C)return At(!0);break}re.push({type:"Quotes",code:"InvalidQuotes",message:"Trailing quote on quoted field is malformed",row:ue.length,index:F}),We++}}else if(T&&de.length===0&&z.substring(F,F+ae)===T){if(we===-1)return At();F=we+K,we=z.indexOf(w,F),Le!==-1&&Le<F&&(Le=z.indexOf(p,F))}else if(Le!==-1&&(Le<we||we===-1))de.push(z.substring(F,Le)),F=Le+Te,Le=z.indexOf(p,F);else{if(we===-1)break;if(de.push(z.substring(F,we)),yn(we+K),se&&(Jt(),ie))return At();if(C&&ue.length>=C)return At(!0)}return Ot();function Qe(B){ue.push(B),$e=F}function Mn(B){var kt=0;return kt=B!==-1&&(B=z.substring(We+1,B))&&B.trim()===""?B.length:kt}function Ot(B){return W||(B===void 0&&(B=z.substring(F)),de.push(B),F=_e,Qe(de),se&&Jt()),At()}function yn(B){F=B,Qe(de),de=[],we=z.indexOf(w,F)}function At(B){if(y.header&&!q&&ue.length&&!I){var kt=ue[0],_t=Object.create(null),Ut=new Set(kt);let xe=!1;for(let Wt=0;Wt<kt.length;Wt++){let Oe=a(kt[Wt]);if(_t[Oe=S(y.transformHeader)?y.transformHeader(Oe,Wt):Oe]){let Xe,L=_t[Oe];for(;Xe=Oe+"_"+L,L++,Ut.has(Xe););Ut.add(Xe),kt[Wt]=Xe,_t[Oe]++,xe=!0,(U=U===null?{}:U)[Xe]=Oe}else _t[Oe]=1,kt[Wt]=Oe;Ut.add(Oe)}xe&&console.warn("Duplicate headers found and renamed."),I=!0}return{data:ue,errors:re,meta:{delimiter:p,linebreak:w,aborted:ie,truncated:!!B,cursor:$e+(q||0),renamedHeaders:U}}}function Jt(){E(At()),ue=[],re=[]}},this.abort=function(){ie=!0},this.getCharIndex=function(){return F}}function m(y){var p=y.data,w=s[p.workerId],T=!1;if(p.error)w.userError(p.error,p.file);else if(p.results&&p.results.data){var E={abort:function(){T=!0,_(p.workerId,{data:[],errors:[],meta:{aborted:!0}})},pause:v,resume:v};if(S(w.userStep)){for(var C=0;C<p.results.data.length&&(w.userStep({data:p.results.data[C],errors:p.results.errors,meta:p.results.meta},E),!T);C++);delete p.results}else S(w.userChunk)&&(w.userChunk(p.results,E,p.file),delete p.results)}p.finished&&!T&&_(p.workerId,p.results)}function _(y,p){var w=s[y];S(w.userComplete)&&w.userComplete(p),w.terminate(),delete s[y]}function v(){throw new Error("Not implemented.")}function M(y){if(typeof y!="object"||y===null)return y;var p,w=Array.isArray(y)?[]:{};for(p in y)w[p]=M(y[p]);return w}function b(y,p){return function(){y.apply(p,arguments)}}function S(y){return typeof y=="function"}return o.parse=function(y,p){var w=(p=p||{}).dynamicTyping||!1;if(S(w)&&(p.dynamicTypingFunction=w,w={}),p.dynamicTyping=w,p.transform=!!S(p.transform)&&p.transform,p.downloadTimeout!==void 0){var w=parseInt(p.downloadTimeout);if(isNaN(w))throw new Error("Config downloadTimeout value ("+p.downloadTimeout+") not parsable by parseInt(val).");p.downloadTimeout=w}if(!p.worker||!o.WORKERS_SUPPORTED)return w=null,o.NODE_STREAM_INPUT,typeof y=="string"?(y=a(y),w=new(p.download?c:h)(p)):y.readable===!0&&S(y.read)&&S(y.on)?w=new d(p):(e.File&&y instanceof File||y instanceof Object)&&(w=new u(p)),w.stream(y);(w=(()=>{var T;return!!o.WORKERS_SUPPORTED&&(T=(()=>{var E=e.URL||e.webkitURL||null,C=i.toString();return o.BLOB_URL||(o.BLOB_URL=E.createObjectURL(new Blob(["var global = (function() { if (typeof self !== 'undefined') { return self; } if (typeof window !== 'undefined') { return window; } if (typeof global !== 'undefined') { return global; } return {}; })(); global.IS_PAPA_WORKER=true; ","(",C,")();"],{type:"text/javascript"})))})(),(T=new e.Worker(T)).onmessage=m,T.id=r++,s[T.id]=T)})()).userStep=p.step,w.userChunk=p.chunk,w.userComplete=p.complete,w.userError=p.error,p.step=S(p.step),p.chunk=S(p.chunk),p.complete=S(p.complete),p.error=S(p.error),delete p.worker,w.postMessage({input:y,config:p,workerId:w.id})},o.unparse=function(y,p){var w=!1,T=!0,E=",",C=`\r
`,O='"',U=O+O,I=!1,D=null,V=!1,F=((()=>{if(typeof p=="object"){if(typeof p.delimiter!="string"||o.BAD_DELIMITERS.filter(function(q){return p.delimiter.indexOf(q)!==-1}).length||(E=p.delimiter),typeof p.quotes!="boolean"&&typeof p.quotes!="function"&&!Array.isArray(p.quotes)||(w=p.quotes),typeof p.skipEmptyLines!="boolean"&&typeof p.skipEmptyLines!="string"||(I=p.skipEmptyLines),typeof p.newline=="string"&&(C=p.newline),typeof p.quoteChar=="string"&&(O=p.quoteChar,U=O+O),typeof p.header=="boolean"&&(T=p.header),Array.isArray(p.columns)){if(p.columns.length===0)throw new Error("Option columns is empty");D=p.columns}p.escapeChar!==void 0&&(U=p.escapeChar+O),p.escapeFormulae instanceof RegExp?V=p.escapeFormulae:typeof p.escapeFormulae=="boolean"&&p.escapeFormulae&&(V=/^[=+\-@\t\r].*$/)}})(),new RegExp(g(O),"g"));if(typeof y=="string"&&(y=JSON.parse(y)),Array.isArray(y)){if(!y.length)return ie(D,y,I);if(Array.isArray(y[0]))return ie(null,y,I);if(typeof y[0]=="object")return ie(D||Object.keys(y[0]),y,I)}else if(typeof y=="object")return typeof y.data=="string"&&(y.data=JSON.parse(y.data)),Array.isArray(y.data)&&(y.fields||(y.fields=y.meta&&y.meta.fields||D),y.fields||(y.fields=Array.isArray(y.data[0])?y.fields:typeof y.data[0]=="object"?Object.keys(y.data[0]):[]),Array.isArray(y.data[0])||typeof y.data[0]=="object"||(y.data=[y.data])),ie(y.fields||[],y.data||[],I);throw new Error("Unable to serialize unrecognized input");function ie(q,W,_e){var Te="",K=(typeof q=="string"&&(q=JSON.parse(q)),typeof W=="string"&&(W=JSON.parse(W)),Array.isArray(q)&&0<q.length),ae=!Array.isArray(W[0]);if(K&&T){for(var se=0;se<q.length;se++)0<se&&(Te+=E),Te+=z(q[se],se);0<W.length&&(Te+=C)}for(var ue=0;ue<W.length;ue++){var re=(K?q:W[ue]).length,de=!1,$e=K?Object.keys(W[ue]).length===0:W[ue].length===0;if(_e&&!K&&(de=_e==="greedy"?W[ue].join("").trim()==="":W[ue].length===1&&(W[ue][0]==null||W[ue][0].length===0)),_e==="greedy"&&K){for(var Ae=[],Ve=0;Ve<re;Ve++){var Le=ae?q[Ve]:Ve;Ae.push(W[ue][Le])}de=Ae.join("").trim()===""}if(!de){for(var we=0;we<re;we++){0<we&&!$e&&(Te+=E);var gt=K&&ae?q[we]:we;Te+=z(W[ue][gt],we)}ue<W.length-1&&(!_e||0<re&&!$e)&&(Te+=C)}}return Te}function z(q,W){var _e,Te,K;return q==null?"":q.constructor===Date?isNaN(q.getTime())?"":q.toISOString():(K=!1,_e=q.toString(),V&&typeof q!="number"&&typeof q!="bigint"&&typeof q!="boolean"&&V.test(_e)&&(q=_e="'"+_e,K=!0),Te=_e.replace(F,U),(K=K||w===!0||typeof w=="function"&&w(q,W)||Array.isArray(w)&&w[W]||((ae,se)=>{for(var ue=0;ue<se.length;ue++)if(-1<ae.indexOf(se[ue]))return!0;return!1})(Te,o.BAD_DELIMITERS)||-1<Te.indexOf(E)||-1<_e.indexOf(O)||Te.charAt(0)===" "||Te.charAt(Te.length-1)===" ")?O+Te+O:Te)}},o.RECORD_SEP="",o.UNIT_SEP="",o.BYTE_ORDER_MARK="\uFEFF",o.BAD_DELIMITERS=["\r",`
`,'"',o.BYTE_ORDER_MARK],o.WORKERS_SUPPORTED=!t&&!!e.Worker,o.NODE_STREAM_INPUT=1,o.LocalChunkSize=10485760,o.RemoteChunkSize=5242880,o.DefaultDelimiter=",",o.Parser=x,o.ParserHandle=f,o.NetworkStreamer=c,o.FileStreamer=u,o.StringStreamer=h,o.ReadableStreamStreamer=d,n&&(e.onmessage=function(y){y=y.data,o.WORKER_ID===void 0&&y&&(o.WORKER_ID=y.workerId),typeof y.input=="string"?e.postMessage({workerId:o.WORKER_ID,results:o.parse(y.input,y.config),finished:!0}):(e.File&&y.input instanceof File||y.input instanceof Object)&&(y=o.parse(y.input,y.config))&&e.postMessage({workerId:o.WORKER_ID,results:y,finished:!0})}),(c.prototype=Object.create(l.prototype)).constructor=c,(u.prototype=Object.create(l.prototype)).constructor=u,(h.prototype=Object.create(h.prototype)).constructor=h,(d.prototype=Object.create(l.prototype)).constructor=d,o})});var Pb=M0((Cb,xf)=>{"use strict";(function(i,e){"use strict";typeof define=="function"&&define.amd?define(e):typeof xf=="object"&&xf.exports?xf.exports=e():i.log=e()})(Cb,function(){"use strict";var i=function(){},e="undefined",t=typeof window!==e&&typeof window.navigator!==e&&/Trident\/|MSIE /.test(window.navigator.userAgent),n=["trace","debug","info","warn","error"],s={},r=null;function o(g,x){var m=g[x];if(typeof m.bind=="function")return m.bind(g);try{return Function.prototype.bind.call(m,g)}catch{return function(){return Function.prototype.apply.apply(m,[g,arguments])}}}function a(){console.log&&(console.log.apply?console.log.apply(console,arguments):Function.prototype.apply.apply(console.log,[console,arguments])),console.trace&&console.trace()}function l(g){return g==="debug"&&(g="log"),typeof console===e?!1:g==="trace"&&t?a:console[g]!==void 0?o(console,g):console.log!==void 0?o(console,"log"):i}function c(){for(var g=this.getLevel(),x=0;x<n.length;x++){var m=n[x];this[m]=x<g?i:this.methodFactory(m,g,this.name)}if(this.log=this.debug,typeof console===e&&g<this.levels.SILENT)return"No console available for logging"}function u(g){return function(){typeof console!==e&&(c.call(this),this[g].apply(this,arguments))}}function h(g,x,m){return l(g)||u.apply(this,arguments)}function d(g,x){var m=this,_,v,M,b="loglevel";typeof g=="string"?b+=":"+g:typeof g=="symbol"&&(b=void 0);function S(E){var C=(n[E]||"silent").toUpperCase();if(!(typeof window===e||!b)){try{window.localStorage[b]=C;return}catch{}try{window.document.cookie=encodeURIComponent(b)+"="+C+";"}catch{}}}function y(){var E;if(!(typeof window===e||!b)){try{E=window.localStorage[b]}catch{}if(typeof E===e)try{var C=window.document.cookie,O=encodeURIComponent(b),U=C.indexOf(O+"=");U!==-1&&(E=/^([^;]+)/.exec(C.slice(U+O.length+1))[1])}catch{}return m.levels[E]===void 0&&(E=void 0),E}}function p(){if(!(typeof window===e||!b)){try{window.localStorage.removeItem(b)}catch{}try{window.document.cookie=encodeURIComponent(b)+"=; expires=Thu, 01 Jan 1970 00:00:00 UTC"}catch{}}}function w(E){var C=E;if(typeof C=="string"&&m.levels[C.toUpperCase()]!==void 0&&(C=m.levels[C.toUpperCase()]),typeof C=="number"&&C>=0&&C<=m.levels.SILENT)return C;throw new TypeError("log.setLevel() called with invalid level: "+E)}m.name=g,m.levels={TRACE:0,DEBUG:1,INFO:2,WARN:3,ERROR:4,SILENT:5},m.methodFactory=x||h,m.getLevel=function(){return M??v??_},m.setLevel=function(E,C){return M=w(E),C!==!1&&S(M),c.call(m)},m.setDefaultLevel=function(E){v=w(E),y()||m.setLevel(E,!1)},m.resetLevel=function(){M=null,p(),c.call(m)},m.enableAll=function(E){m.setLevel(m.levels.TRACE,E)},m.disableAll=function(E){m.setLevel(m.levels.SILENT,E)},m.rebuild=function(){if(r!==m&&(_=w(r.getLevel())),c.call(m),r===m)for(var E in s)s[E].rebuild()},_=w(r?r.getLevel():"WARN");var T=y();T!=null&&(M=w(T)),c.call(m)}r=new d,r.getLogger=function(x){if(typeof x!="symbol"&&typeof x!="string"||x==="")throw new TypeError("You must supply a name when creating a logger.");var m=s[x];return m||(m=s[x]=new d(x,r.methodFactory)),m};var f=typeof window!==e?window.log:void 0;return r.noConflict=function(){return typeof window!==e&&window.log===r&&(window.log=f),r},r.getLoggers=function(){return s},r.default=r,r})});var po=class extends Error{constructor(e,t){super(e,t),this.name=new.target.name}},$i=class extends po{constructor(t,n=null,s=null){let{title:r,detail:o,type:a="about:blank",errors:l=[],errors_omitted:c=!1}=t,u=l.map(h=>`
  ${h.pointer||"(the whole request)"}: ${h.detail}`);super(`${r}${o&&`: ${o}`}${u.join("")}${c?`
  … and more`:""}`);this.status=n;this.requestId=s;this.title=r,this.detail=o,this.type=a,this.errors=l,this.errorsOmitted=c}status;requestId;title;detail;type;errors;errorsOmitted},Yi=class extends $i{},Ir=class extends $i{},As=class extends $i{},Wa=class extends $i{},Jc=class extends $i{},Rs=class extends $i{constructor(t){super(t.error??{title:"The job failed",detail:""});this.job=t}job},Xa=class extends po{constructor(t){super(`job ${t.id} was cancelled`);this.job=t}job},Li=class extends po{job;constructor(e,{job:t,...n}={}){super(e,n),this.job=t}},xS={400:Yi,413:Yi,415:Yi,422:Yi,401:Ir,403:Ir,404:As,410:As,429:Wa,503:Wa};async function jc(i){let e=await i.text(),t={title:`HTTP ${i.status}`,detail:e.slice(0,200)};try{let s=JSON.parse(e);typeof s.title=="string"&&typeof s.detail=="string"&&(t=s)}catch{}let n=xS[i.status]??(i.status>=500?Jc:$i);return new n(t,i.status,i.headers.get("x-request-id"))}function Zc(i){if(i instanceof Float64Array||i instanceof Float32Array){if(i.length%3!==0)throw qa("",`expected x y z of each point, got ${i.length} numbers`);return Array.from({length:i.length/3},(e,t)=>Array.from(i.subarray(3*t,3*t+3)))}if(!Array.isArray(i))throw qa("","expected points as [[x, y, z], …]");return i.map(e=>"x"in e?[e.x,e.y,e.z]:[...e])}function Qc(i,e){if(!Array.isArray(e))throw qa(`/${i}`,"expected a list of curves");return e.map((t,n)=>{try{return Zc(t)}catch(s){throw s instanceof Yi?qa(`/${i}/${n}`,s.detail):s}})}function T0(i){return A0(i,""),JSON.stringify(i)}function A0(i,e){if(typeof i=="number"&&!Number.isFinite(i))throw qa(e,`${i} is not a finite number`);if(!(typeof i!="object"||i===null))for(let[t,n]of Object.entries(i))(typeof n=="number"?!Number.isFinite(n):typeof n=="object")&&A0(n,`${e}/${t.replaceAll("~","~0").replaceAll("/","~1")}`)}function qa(i,e){return new Yi({title:"The request cannot be worked on",detail:e,errors:[{pointer:i,detail:e}]})}var Ya=class extends Error{constructor(e,t){super(e),this.name="ParseError",this.type=t.type,this.field=t.field,this.value=t.value,this.line=t.line}},R0=10,vS=13,Lr=32;function Ef(i){}function I0(i){if(typeof i=="function")throw new TypeError("`config` must be an object, got a function instead. Did you mean `createParser({onEvent: fn})`?");let{onEvent:e=Ef,onError:t=Ef,onRetry:n=Ef,onComment:s,maxBufferSize:r}=i,o=[],a=0,l=!0,c,u="",h=0,d,f=!1;function g(S){if(f)throw new Error("Cannot feed parser: it was terminated after exceeding the configured max buffer size. Call `reset()` to resume parsing.");if(l&&(l=!1,S.charCodeAt(0)===239&&S.charCodeAt(1)===187&&S.charCodeAt(2)===191&&(S=S.slice(3))),o.length===0){let w=m(S);w!==""&&(o.push(w),a=w.length),x();return}if(S.indexOf(`
`)===-1&&S.indexOf("\r")===-1){o.push(S),a+=S.length,x();return}o.push(S);let y=o.join("");o.length=0,a=0;let p=m(y);p!==""&&(o.push(p),a=p.length),x()}function x(){r!==void 0&&(a+u.length<=r||(f=!0,o.length=0,a=0,c=void 0,u="",h=0,d=void 0,t(new Ya(`Buffered data exceeded max buffer size of ${r} characters`,{type:"max-buffer-size-exceeded"}))))}function m(S){let y=0;if(S.indexOf("\r")===-1){let p=S.indexOf(`
`,y);for(;p!==-1;){if(y===p){h>0&&e({id:c,event:d,data:u}),c=void 0,u="",h=0,d=void 0,y=p+1,p=S.indexOf(`
`,y);continue}let w=S.charCodeAt(y);if(C0(S,y,w)){let T=S.charCodeAt(y+5)===Lr?y+6:y+5,E=S.slice(T,p);if(h===0&&S.charCodeAt(p+1)===R0){e({id:c,event:d,data:E}),c=void 0,u="",d=void 0,y=p+2,p=S.indexOf(`
`,y);continue}u=h===0?E:`${u}
${E}`,h++}else P0(S,y,w)?d=S.slice(S.charCodeAt(y+6)===Lr?y+7:y+6,p)||void 0:_(S,y,p);y=p+1,p=S.indexOf(`
`,y)}return S.slice(y)}for(;y<S.length;){let p=S.indexOf("\r",y),w=S.indexOf(`
`,y),T=-1;if(p!==-1&&w!==-1?T=p<w?p:w:p!==-1?p===S.length-1?T=-1:T=p:w!==-1&&(T=w),T===-1)break;_(S,y,T),y=T+1,S.charCodeAt(y-1)===vS&&S.charCodeAt(y)===R0&&y++}return S.slice(y)}function _(S,y,p){if(y===p){M();return}let w=S.charCodeAt(y);if(C0(S,y,w)){let I=S.charCodeAt(y+5)===Lr?y+6:y+5,D=S.slice(I,p);u=h===0?D:`${u}
${D}`,h++;return}if(P0(S,y,w)){d=S.slice(S.charCodeAt(y+6)===Lr?y+7:y+6,p)||void 0;return}if(w===105&&S.charCodeAt(y+1)===100&&S.charCodeAt(y+2)===58){let I=S.slice(S.charCodeAt(y+3)===Lr?y+4:y+3,p);I.includes("\0")||(c=I);return}if(w===58){if(s){let I=S.slice(y,p);s(I.slice(S.charCodeAt(y+1)===Lr?2:1))}return}let T=S.slice(y,p),E=T.indexOf(":");if(E===-1){v(T,"",T);return}let C=T.slice(0,E),O=T.charCodeAt(E+1)===Lr?2:1,U=T.slice(E+O);v(C,U,T)}function v(S,y,p){switch(S){case"event":d=y||void 0;break;case"data":u=h===0?y:`${u}
${y}`,h++;break;case"id":y.includes("\0")||(c=y);break;case"retry":/^\d+$/.test(y)?n(parseInt(y,10)):t(new Ya(`Invalid \`retry\` value: "${y}"`,{type:"invalid-retry",value:y,line:p}));break;default:t(new Ya(`Unknown field "${S.length>20?`${S.slice(0,20)}…`:S}"`,{type:"unknown-field",field:S,value:y,line:p}));break}}function M(){h>0&&e({id:c,event:d,data:u}),c=void 0,u="",h=0,d=void 0}function b(S={}){if(S.consume&&o.length>0){let y=o.join("");_(y,0,y.length)}l=!0,c=void 0,u="",h=0,d=void 0,o.length=0,a=0,f=!1}return{feed:g,reset:b}}function C0(i,e,t){return t===100&&i.charCodeAt(e+1)===97&&i.charCodeAt(e+2)===116&&i.charCodeAt(e+3)===97&&i.charCodeAt(e+4)===58}function P0(i,e,t){return t===101&&i.charCodeAt(e+1)===118&&i.charCodeAt(e+2)===101&&i.charCodeAt(e+3)===110&&i.charCodeAt(e+4)===116&&i.charCodeAt(e+5)===58}function Ka(i,e){return e?new Promise((t,n)=>{let s=()=>n(e.reason);e.aborted&&s(),e.addEventListener("abort",s,{once:!0}),i.then(t,n).finally(()=>e.removeEventListener("abort",s))}):i}function mo(i,e){let t,n=new Promise(s=>t=setTimeout(s,i));return Ka(n,e).finally(()=>clearTimeout(t))}var $a=class{#e=new AbortController;#i;#t;constructor(e,t){this.#i=e,e?.addEventListener("abort",this.#n),e?.aborted&&this.#n(),this.expect(t)}get signal(){return this.#e.signal}expect(e){clearTimeout(this.#t),this.#t=setTimeout(this.#n,e)}close(){clearTimeout(this.#t),this.#i?.removeEventListener("abort",this.#n),this.#n()}#n=()=>this.#e.abort()};var bS=5e3,SS=45e3,wS=15e3,MS=1e3,L0=6e4,ES=15e3,TS=8,O0=2,AS=2e3,RS=[408,425,429,502,503,504],ui=i=>i==="succeeded"||i==="failed"||i==="cancelled",go=class extends Error{constructor(t,n=0){super("interrupted",{cause:t});this.pauseMs=n}pauseMs},eu=class{#e;#i;#t;#n="";#s=MS;#r=O0;#o=!0;constructor(e,t,n){this.#e=e,this.#i=t,this.#t=n}async end(){let{signal:e,onProgress:t}=this.#t;for(e?.throwIfAborted(),ui(this.#e.status)&&t?.(this.#e.progress);!ui(this.#e.status)&&!(this.#r>0&&(this.#r-=1,await this.#u(),ui(this.#e.status)));)await this.#h(),(ui(this.#e.status)||this.#r===0)&&(this.#l(!0),t?.(this.#e.progress)),ui(this.#e.status)||await mo(this.#r>0?this.#s:AS,e);return this.#e}async#u(){let{onProgress:e,signal:t}=this.#t,n=new $a(t,bS),s=[],r=I0({onEvent:o=>s.push(o),onRetry:o=>this.#s=Math.min(o,L0)});try{let o={Accept:"text/event-stream"};this.#n&&(o["Last-Event-ID"]=this.#n);let a=`${this.#c}/events`,l=await this.#a(n,d=>this.#i(a,o,d));l.status===204&&(this.#r=0);let c=l.headers.get("content-type")?.startsWith("text/event-stream");if(l.status!==200||!c||!l.body)return;let u=l.body.getReader(),h=new TextDecoder;for(;;){let{done:d,value:f}=await this.#a(n,()=>u.read());if(d)break;n.expect(SS),this.#l(!0),r.feed(h.decode(f,{stream:!0}));for(let g of s.splice(0)){this.#r=O0,this.#n=g.id??this.#n;let x=JSON.parse(g.data);if(g.event==="status"&&(this.#e=x),e?.(x.progress),ui(this.#e.status))return}}this.#l(!1)}catch(o){if(!(o instanceof go))throw o;this.#l(!1)}finally{n.close()}}async#h(){for(let e=0;;e+=1)try{this.#e=await this.#d();return}catch(t){if(!(t instanceof go))throw t;if(this.#l(!1),e+1>=TS)throw this.#f(t.cause);let n=Math.min(this.#s*2**e,ES);await mo(Math.max(this.#s,n,t.pauseMs),this.#t.signal)}}async#d(){let e=new $a(this.#t.signal,wS);try{let t=await this.#a(e,n=>this.#i(this.#c,{},n));if(!t.ok){let n=await this.#a(e,()=>jc(t));if(!RS.includes(t.status))throw n;let s=1e3*Number(t.headers.get("retry-after")??0);throw new go(n,Math.min(s||0,L0))}return await this.#a(e,()=>t.json())}finally{e.close()}}async#a(e,t){try{return await Ka(t(e.signal),e.signal)}catch(n){throw this.#t.signal?.throwIfAborted(),new go(n)}}get#c(){return`v1/jobs/${this.#e.id}`}#f(e){let{id:t}=this.#e,n=`the connection was lost; job ${t} goes on at the server, and \`client.job('${t}')\` comes back to it`;return new Li(n,{cause:e,job:this.#e})}#l(e){e!==this.#o&&(this.#o=e,this.#t.onConnection?.(e))}};var tu=class{constructor(e,t){this.job=e;this.statistics=e.statistics;let n=CS(t);this.vertices=n.vertices,this.triangles=n.triangles,this.edges=n.edges,this.forces=n.forces,this.meanCurvature=n.meanCurvature,this.unit=n.unit,this.up=n.up}job;vertices;triangles;edges;forces;meanCurvature;unit;up;statistics;get id(){return this.job.id}get warnings(){return this.job.warnings}get origin(){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];this.vertices.forEach((s,r)=>{let o=r%3;e[o]=Math.min(e[o],s),t[o]=Math.max(t[o],s)});let n=s=>.5*e[s]+.5*t[s];return[n(0),n(1),n(2)]}};function CS(i){let e=new Uint8Array(i),t=new TextDecoder().decode(e.subarray(0,4096)),n=t.indexOf(`end_header
`);if(n<0)throw new Error("the PLY file has no header");let s=t.slice(0,n).split(`
`).map(S=>S.split(" ")),r=S=>{let y=0,p="",w=new Map;for(let[T,E="",C=""]of s)T==="element"&&(p=E),!(T!=="property"||E==="list"||p!==S)&&(w.set(C,y),y+={double:8,float:4,int:4,uchar:1}[E]??0);return{offsets:w,stride:y}},{offsets:o,stride:a}=r("vertex"),l=S=>Number(s.find(y=>y[0]==="element"&&y[1]===S)?.[2]),[,,c="",u=""]=s.find(S=>S[0]==="comment"&&S[1]==="unit")??[],h=new DataView(i),d=new TextEncoder().encode(t.slice(0,n)).length+11,f=new Float64Array(3*l("vertex")),g=o.get("mean_curvature"),x=g===void 0?null:new Float64Array(l("vertex"));for(let S=0;3*S<f.length;S++,d+=a){for(let y=0;y<3;y++)f[3*S+y]=h.getFloat64(d+8*y,!0);x&&(x[S]=h.getFloat64(d+g,!0))}let m=new Uint32Array(3*l("face"));for(let S=0;3*S<m.length;S++,d+=13)for(let y=0;y<3;y++)m[3*S+y]=h.getUint32(d+1+4*y,!0);let _=r("edge"),v=new Uint32Array(2*(l("edge")||0)),M=_.offsets.get("force"),b=new Float64Array(M===void 0?0:v.length/2);for(let S=0;2*S<v.length;S++,d+=_.stride){for(let y=0;y<2;y++)v[2*S+y]=h.getUint32(d+4*y,!0);M!==void 0&&(b[S]=h.getFloat64(d+M,!0))}return{vertices:f,triangles:m,edges:v,forces:b,meanCurvature:x,unit:c.replace(",",""),up:u}}function N0(i){let e=new Map,t="";for(let n of i.split(`
`)){if(n.startsWith("o ")&&(t=n.slice(2)),!n.startsWith("l "))continue;let s=e.get(t)??[];s.push(Uint32Array.from(n.slice(2).split(" "),r=>Number(r)-1)),e.set(t,s)}return e}var PS={ruled_surface:"v1/ruled-surfaces",minimal_surface:"v1/minimal-surfaces",uniform_mesh:"v1/uniform-meshes",tensile_structure:"v1/tensile-structures",cable_net:"v1/cable-nets"},IS=1,LS=4,nu=class extends tu{#e;constructor(e,t,n){super(t,n),this.#e=e}download(e="glb"){return this.#e.download(this.id,e)}async lines(){return N0(new TextDecoder().decode(await this.download("obj")))}},Ja=class{constructor(e,t){this.info=t;this.#e=e}info;#e;get id(){return this.info.id}get status(){return this.info.status}async refresh(){return this.info=await this.#e.getJson(`v1/jobs/${this.id}`)}async wait(e={}){return this.info=await this.#e.waitFor(this.info,e),this.#e.resultOf(this.info)}async cancel(){return this.info=await this.#e.cancel(this.id)}async delete(){await this.#e.delete(this.id)}},ja=class{url;#e;#i;#t;constructor(e={}){let{url:t,apiKey:n,patienceMs:s,fetch:r}=typeof e=="string"?{url:e}:e,o=globalThis.process?.env??{};this.url=(t||o.PLATEAU_URL||"http://127.0.0.1:8080").replace(/\/+$/,"");let a=n??o.PLATEAU_API_KEY;this.#i=a?{Authorization:`Bearer ${a}`}:{},this.#e=s??6e4,this.#t=r??((l,c)=>globalThis.fetch(l,c))}async ruledSurface(e,t={},n){return this.solve({kind:"ruled_surface",directrices:Qc("directrices",e),...t},n)}async minimalSurface(e,t={},n){return this.solve({kind:"minimal_surface",boundaries:Qc("boundaries",e),...t},n)}async uniformMesh(e,t,n={},s){let o=Array.isArray(e)||ArrayBuffer.isView(e)?{polygon:Zc(e)}:e;return this.solve({kind:"uniform_mesh",domain:o,edge_length:t,...n},s)}async tensileStructure(e,t,n={},s){let r=Qc("boundaries",e),o=Array.isArray(t)?{layers:t}:{film:t};return this.solve({kind:"tensile_structure",boundaries:r,...o,...n},s)}async cableNet(e,t,n,s={},r){let o={vertices:Zc(e),edges:t.map(([a,l])=>[a,l]),supports:[...n]};return this.solve({kind:"cable_net",...o,...s},r)}async solve(e,t={}){let{signal:n,onProgress:s}=t,{info:r}=await this.submit(e,{waitS:s?0:IS,signal:n}),o;try{o=await this.waitFor(r,t)}catch(a){throw a instanceof Li||await this.cancel(r.id).catch(()=>{}),a}return this.resultOf(o,n)}async submit(e,t={}){let{idempotencyKey:n=D0(),waitS:s=0,signal:r}=t;r?.throwIfAborted();let o=this.#s(e,n,s);try{return new Ja(this,await Ka(o,r))}catch(a){throw r?.aborted&&this.#r(o,n),a}}live(){return new iu(this)}async job(e){return new Ja(this,await this.getJson(`v1/jobs/${e}`))}async*jobs(e={}){let t;do{let n=new URLSearchParams({...e,...t?{cursor:t}:{}}),s=await this.getJson(`v1/jobs?${n}`);yield*s.jobs,t=s.next_cursor}while(t)}async cancel(e){return(await this.send(`v1/jobs/${e}/cancel`,{method:"POST"})).json()}async delete(e){await this.send(`v1/jobs/${e}`,{method:"DELETE"})}async download(e,t="glb",n){let s=t==="svg"||t==="dxf"?"pattern":"mesh";return(await this.send(`v1/jobs/${e}/${s}?format=${t}`,{signal:n})).arrayBuffer()}objectives(){return this.getJson("v1/objectives")}limits(){return this.getJson("v1/limits")}async example(e){let t=await this.getJson(`v1/examples/${e}`);return{kind:t.kind,...t.request}}waitFor(e,t={}){return new eu(e,(n,s,r)=>this.#n(n,{headers:s,signal:r}),t).end()}async resultOf(e,t){if(e.status==="failed")throw new Rs(e);if(e.status==="cancelled")throw new Xa(e);return new nu(this,e,await this.download(e.id,"ply",t))}async getJson(e){return(await this.send(e)).json()}async send(e,t={}){let n=Date.now()+this.#e;for(let s=1;;){let r;try{r=await this.#n(e,t)}catch(c){if(t.signal?.throwIfAborted(),s++>=LS)throw new Li(`${this.url} cannot be reached`,{cause:c});await mo(100*3**(s-1),t.signal);continue}if(r.ok)return r;let o=1e3*Number(r.headers.get("retry-after")??Number.NaN),a=Math.max(200,o);if(!(r.status===429||r.status===503)||Number.isNaN(a)||Date.now()+a>=n)throw await jc(r);await r.body?.cancel(),await mo(a,t.signal)}}#n(e,t){let n={method:t.method??"GET",headers:{...this.#i,...t.headers}};return t.body!==void 0&&(n.body=t.body),t.signal&&(n.signal=t.signal),this.#t(`${this.url}/${e}`,n)}async#s(e,t,n){let s={"Content-Type":"application/json","Idempotency-Key":t};return n>0&&(s.Prefer=`wait=${n}`),await(await this.send(PS[e.kind],{method:"POST",headers:s,body:T0(e)})).json()}async#r(e,t){try{for await(let s of this.jobs({idempotency_key:t}))await this.cancel(s.id);let n=await e;ui(n.status)||await this.cancel(n.id)}catch{}}},iu=class{#e;#i=D0();#t=new AbortController;#n=Promise.resolve();#s;constructor(e){this.#e=e}async solve(e,t={}){this.#t.abort();let n=this.#t=new AbortController,s=this.#n.then(()=>this.#r(e,n.signal));this.#n=s.catch(()=>{});try{let r=await s;return!r||(r=await this.#e.waitFor(r,{...t,signal:n.signal}),n.signal.aborted)?null:await this.#e.resultOf(r,n.signal)}catch(r){if(n.signal.aborted)return null;throw r instanceof Li||await this.#o(),r}}stop(){this.#t.abort(),this.#n.then(()=>this.#o())}async#r(e,t){if(t.aborted)return null;let n=await this.#e.submit({...e,supersede:this.#i});return this.#s=n.info}async#o(){let e=this.#s;this.#s=void 0,e&&!ui(e.status)&&await this.#e.cancel(e.id).catch(()=>{})}};function D0(){return Array.from(crypto.getRandomValues(new Uint8Array(16)),i=>i.toString(16).padStart(2,"0")).join("")}var Za=new URL(".",document.baseURI).href.replace(/studio\/$/,""),Or=i=>Za+i.replace(/^\//,""),OS=1e4,U0=i=>new ja({url:Za,apiKey:i,patienceMs:OS}),su="",Yt=U0(su),ru=()=>su!=="";function Tf(i){su=i,Yt=U0(su)}function Y(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element #${i}`);return e}function te(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r!=null&&(s.startsWith("on")&&typeof r=="function"?n.addEventListener(s.slice(2),r):s in n?n[s]=r:n.setAttribute(s,String(r)));return n.append(...t.filter(s=>s!=null&&s!==!1)),n}var NS="http://www.w3.org/2000/svg";function Un(i,e={},...t){let n=document.createElementNS(NS,i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}function _o(i,e){let t=URL.createObjectURL(i),n=te("a",{href:t,download:e});document.body.append(n),n.click(),n.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var Rt={minimal_surface:{path:"/v1/minimal-surfaces",label:"Film",line:"boundary",lines:["boundaries"],least:3,purpose:"A membrane of least area on its boundary"},ruled_surface:{path:"/v1/ruled-surfaces",label:"Strip",line:"rail",lines:["directrices"],least:2,purpose:"A ruled strip between two rails"},uniform_mesh:{path:"/v1/uniform-meshes",label:"Lattice",line:"hole",lines:["domain","holes"],least:3,purpose:"A gridshell or floor of equal members"},tensile_structure:{path:"/v1/tensile-structures",label:"Tensile",line:"boundary",lines:["boundaries"],least:3,purpose:"A film with cables, pressure and weight in equilibrium"},cable_net:{path:"/v1/cable-nets",label:"Net",line:"net",lines:[],least:2,purpose:"A net of cables with target forces and lengths"}},F0={mm:.001,cm:.01,m:1,in:.0254,ft:.3048},hi=i=>{let e=String(Qa(i.units)?.length??i.units);return e in F0?e:"m"},yo=i=>F0[hi(i)]??1;var Af=i=>typeof i=="number"&&Number.isFinite(i),k0=i=>Array.isArray(i)&&i.length===3&&i.every(Af);function Dt(i){return!Array.isArray(i)||!i.some(Af)?null:[0,1,2].map(e=>Af(i[e])&&Math.abs(i[e])<1e150?i[e]:0)}function ou(i,e){let t=[],n=(o,a,l,c,u=!1)=>{Array.isArray(l)&&t.push({name:o,path:a,points:l,closed:c,planar:u})},s=(o,a,l,c,u=!1)=>{Array.isArray(l)&&l.forEach((h,d)=>n(`${o} ${d+1}`,[...a,d],h,c,u))};if(i==="ruled_surface"&&s("rail",["directrices"],e.directrices,e.closed===!0),i==="tensile_structure"&&s("boundary",["boundaries"],e.boundaries,!0),i==="cable_net"&&Array.isArray(e.vertices)){let o=new Set((Array.isArray(e.supports)?e.supports:[]).filter(Number.isInteger));t.push({name:"vertices",path:["vertices"],points:e.vertices,closed:!1,planar:!1,only:o})}if(i==="minimal_surface"){s("boundary",["boundaries"],e.boundaries,!0);let o=Qa(e.constraints);s("rope",["constraints","polylines"],o?.polylines,!1),Array.isArray(o?.points)&&o.points.length>0&&n("fixed points",["constraints","points"],o.points,!1)}let r=Qa(e.domain);if(r){n("polygon",["domain","polygon"],r.polygon,!0,!0),s("hole",["domain","holes"],r.holes,!0,!0),s("boundary",["domain","boundaries"],r.boundaries,!0);for(let o of["bezier","nurbs"])s("control row",["domain",o,"control_points"],Qa(r[o])?.control_points,!1)}return t}var Qa=i=>i!==null&&typeof i=="object"&&!Array.isArray(i)?i:null,Nr=i=>i.only!==void 0||i.path[0]==="constraints"&&i.path[1]==="points",el=(i,e)=>i.only?.has(e)??!0;function au(i,e){return e.reduce((t,n)=>t?.[n],i)}function Rf(i,e){let t=e.split("/").slice(1).map(l=>l.replaceAll("~1","/").replaceAll("~0","~")),n=i.findIndex(l=>l.path.every((c,u)=>String(c)===t[u]));if(n<0){let l=/^(normals|tangents)$/.test(t[0]??"")?i.findIndex(u=>u.path[0]==="directrices"&&String(u.path[1])===t[1]):-1;return l>=0&&/^\d+$/.test(t[2]??"")?{text:`${t[0]} of ${i[l].name}, point ${Number(t[2])+1}`,line:l,point:Number(t[2]),field:t[0]}:{text:t.map(u=>/^\d+$/.test(u)?String(Number(u)+1):u.replaceAll("_"," ")).join(" › ")||"the request",...t[0]!==void 0&&{field:t[0]}}}let s=i[n],[r,o]=t.slice(s.path.length).map(Number);if(r===void 0||!Number.isInteger(r))return{text:s.name,line:n};let a=o===void 0?"":`, ${"xyz"[o]??"coordinate"}`;return{text:`${s.name}, point ${r+1}${a}`,line:n,point:Math.min(r,s.points.length-1),...o!==void 0&&{axis:o}}}function lu(i){return i==="ruled_surface"?{directrices:[]}:i==="uniform_mesh"?{domain:{},edge_length:1}:i==="tensile_structure"?{boundaries:[],film:{tension:1}}:i==="cable_net"?{vertices:[],edges:[],supports:[],cables:[{force_density:1}]}:{boundaries:[]}}function Oi(i,e){let t=ou(i,e);return i==="ruled_surface"?t.length>=2:i==="cable_net"?Array.isArray(e.edges)&&e.edges.length>0:t.length>=1||i==="uniform_mesh"&&Object.keys(Qa(e.domain)??{}).length>0}function tl(i){return typeof i.kind=="string"?i.kind in Rt?i.kind:null:"boundaries"in i?"minimal_surface":"directrices"in i?"ruled_surface":"edges"in i?"cable_net":"domain"in i?"uniform_mesh":null}var cu=i=>JSON.stringify(i,null,1).replace(/\[\s+([^[\]{}]*?)\s+\]/g,(e,t)=>`[${t.replace(/\s+/g," ")}]`);function Zt(i){let[,e=i,t]=/^(.*?)(_deg|_ms|_s)?$/.exec(i)??[],n=e.replaceAll("_"," ");if(n.length<=2)return n;let s={_deg:" (°)",_ms:" (ms)",_s:" (s)"}[t??""]??"";return n.charAt(0).toUpperCase()+n.slice(1)+s}var Dr=i=>i.charAt(0).toUpperCase()+i.slice(1);function Cf(i){let e=i.replace(/,/g,".").replace(/−/g,"-"),t=e.match(/[+-]?\s*\d*\.?\d+(?:e[+-]?\d+)?/gi);return!t||t.join("").replace(/\s/g,"")!==e.replace(/\s/g,"")?NaN:Number(t.reduce((n,s)=>n+Number(s.replace(/\s/g,"")),0).toPrecision(15))}var DS={"-":"⁻",...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((i,e)=>[String(e),i]))};function vt(i,e=5){if(Number.isInteger(i)&&Math.abs(i)<1e15)return i.toLocaleString("en").replace("-","−");let t=Math.abs(i);if(t!==0&&(t<1e-4||t>=1e9)){let[n="",s=""]=i.toExponential(Math.min(e,3)-1).split("e");return`${(n.includes(".")?n.replace(/\.?0+$/,""):n).replace("-","−")}×10${[...s.replace("+","")].map(o=>DS[o]).join("")}`}return String(Number(i.toPrecision(e))).replace("-","−")}var bi=(i,e,t=`${e}s`)=>`${vt(i)} ${i===1?e:t}`;function nl(i){return i<10?`${vt(Number(i.toPrecision(2)))} s`:i<90?`${Math.round(i)} s`:`${Math.floor(i/60)} min ${Math.round(i%60)} s`}var US=/\b(boundary|boundaries|directrix|directrices|strips?|holes?|loops?|polygons?|polylines?|rows?|points?)((?: \d+(?![.\d%°])(?:,| and| or)?)+)/g;function il(i){return i.replace(US,(e,t,n)=>t+n.replace(/\d+/g,s=>String(Number(s)+1))).replace(/(-?\d+(?:\.\d+)?e[+-]?\d+)\b/g,e=>vt(Number(e))).replace(/(?<![\d.,])1 (places|points|triangles|edges|vertices|strips|boundaries|directrices|loops|members|nodes|rows)\b/g,(e,t)=>`1 ${FS(t)}`)}var FS=i=>({vertices:"vertex",boundaries:"boundary",directrices:"directrix"})[i]??i.slice(0,-1);function hu(i,e){let t=i.paths?.[e]?.post?.requestBody?.content?.["application/json"]?.schema;return t?Ki(i,t):null}var uu=i=>i.type==="null";function Ki(i,e){let t=e,n={};for(let s=0;s<8;s+=1){t.description!==void 0&&(n.description??=t.description),t["x-default"]!==void 0&&(n["x-default"]??=t["x-default"]);let r=t.anyOf??t.oneOf??[];r.some(uu)&&(n.nullable=!0);let o=r.filter(c=>!uu(c)),a=r.some(uu)&&o.length===1?o[0]:void 0,l=t.$ref?{$ref:t.$ref}:t.allOf?.[0]??a;if(!l)break;t=l.$ref?kS(i,l.$ref):l}return{...t,...n}}var kS=(i,e)=>e.slice(2).split("/").reduce((t,n)=>t?.[n],i)??{};function sl(i,e){let t=(e.oneOf??e.anyOf??[e]).filter(a=>!uu(a)).map(a=>Ki(i,a)),n=t.flatMap(a=>a.oneOf??a.anyOf??[a]).filter(a=>a.enum),s=n.flatMap(a=>a.enum??[]);if(s.length>0&&s.every(a=>typeof a=="string")){let a=Object.fromEntries(n.flatMap(l=>(l.enum??[]).map((c,u)=>[String(c),l["x-enum-descriptions"]?.[u]||void 0])));return{type:"choice",names:s,help:a,other:t.find(l=>l.properties)??null}}let r=t.find(a=>a.properties);if(r&&t.some(a=>a.type==="boolean"))return{type:"switch",options:r};let o=[e.type].flat();if(o.includes("boolean"))return{type:"flag"};if(o.includes("integer")||o.includes("number"))return{type:"number",whole:o.includes("integer")};if(o.includes("string"))return{type:"text"};if(o.includes("object")&&e.maxProperties===1)return{type:"one_of"};if(o.includes("object")&&e.properties&&Object.values(e.properties).every(a=>sl(i,Ki(i,a))))return{type:"group"};if(o.includes("array")&&e.items&&e.minItems===e.maxItems&&(e.maxItems??9)<=3){let a=Ki(i,e.items);if([a.type].flat().some(l=>l==="integer"||l==="number"))return{type:"numbers",count:e.maxItems,item:a}}return null}var Pf=["objective","secondary_objective","resolution","edge_length","closed","optimise","max_distinct_lengths","topology","units","up"],BS={closed:"Closed rails",units:"Unit",up:"Up axis",all_objectives:"Compare all objectives",optimise:"Optimise",certify:"Prove a lower bound of the area"},zS=["kind","supersede","cancel_on_disconnect"],B0=i=>Pf.indexOf(i)+1||Pf.length+1,Ni=i=>BS[i]??Zt(i);function V0(i,e,t,n){let s=i.querySelector("details")?.open??!1;i.replaceChildren();let r=te("div",{className:"fields"}),o=Object.keys(e.properties??{}).filter(a=>!zS.includes(a));o.sort((a,l)=>B0(a)-B0(l));for(let a of o){let l=Ki(n.openapi,e.properties[a]),c=sl(n.openapi,l);if(!c||c.type==="choice"&&c.names.length<2&&!c.other)continue;let u=Lf(n,a,l,c,t[a],h=>n.set(a,h),[a]);(Pf.includes(a)?i:r).append(u)}r.childElementCount>0&&i.append(te("details",{className:"more",open:s},te("summary",{},"More options"),r))}function Lf(i,e,t,n,s,r,o){let a=s??t["x-default"],l=t.description??"",c=`option-${o.join("-")}`;if(n.type==="flag"){let u=te("input",{type:"checkbox",name:o.join("."),id:c,checked:a===!0});return u.addEventListener("change",()=>r(u.checked)),te("label",{className:"check field",title:l},u,Ni(e))}if(n.type==="switch"){let u={...n.options,description:t.description,nullable:!0};return z0(i,e,u,a===!0?{}:a||null,r,o)}if(n.type==="choice")return VS(i,e,t,n,s,r,o);if(n.type==="number"){let u=If(o.join("."),c,t,n.whole,a);return u.addEventListener("change",()=>{u.checkValidity()?r(u.value===""?void 0:u.valueAsNumber):u.reportValidity()}),te("label",{className:"field",title:l,htmlFor:c},te("span",{},Ni(e)),u)}if(n.type==="text"){let u=te("input",{type:"text",name:o.join("."),id:c,value:a??"",placeholder:"none",autocomplete:"off"});return u.addEventListener("change",()=>r(u.value===""?void 0:u.value)),te("label",{className:"field",title:l,htmlFor:c},te("span",{},Ni(e)),u)}if(n.type==="numbers"){let u=Array.isArray(a)?a:[],h=Array.from({length:n.count},(d,f)=>If(`${o.join(".")}.${f}`,`${c}-${f}`,n.item,!0,u[f]));return h.forEach((d,f)=>{d.setAttribute("aria-label",`${Ni(e)}, ${f+1}`),d.addEventListener("change",()=>r(h.map(g=>g.valueAsNumber||n.item.minimum||0)))}),te("div",{className:"field",title:l},te("span",{},Ni(e)),te("span",{className:"pair even"},...h))}return n.type==="group"?z0(i,e,t,s,r,o):GS(i,e,t,a,r,o)}function VS(i,e,t,n,s,r,o){let a=`option-${o.join("-")}`,l=s??t["x-default"],c=v=>{l=v??t["x-default"],r(v)},u="(object)",h=n.names.map(v=>te("option",{value:v,title:n.help[v]??""},Zt(v)));(t.nullable||t["x-default"]===void 0)&&h.unshift(te("option",{value:""},t.nullable?"None":"Default"));let d=()=>l!==null&&typeof l=="object",f=n.other&&HS(i.openapi,n.other)?n.other:null;f?h.push(te("option",{value:u},"Weighted sum")):d()&&h.push(te("option",{value:u},"As in the request"));let g=te("select",{name:o.join("."),id:a},...h);g.value=d()?u:String(l??"");let x=te("p",{className:"help"}),m=te("div",{className:"fields nested"}),_=()=>{if(x.textContent=i.describe(e,g.value)??n.help[g.value]??"",x.hidden=x.textContent==="",m.replaceChildren(),m.hidden=g.value!==u||!f,m.hidden||!f)return;let v=()=>d()?l:{};for(let[M,b]of Object.entries(f.properties??{})){let S=Ki(i.openapi,b),y=sl(i.openapi,S);y&&m.append(Lf(i,M,S,y,v()[M],p=>c(G0({...v(),[M]:p})),[...o,M]))}};return g.addEventListener("change",()=>{g.value===u?f&&c(H0(i.openapi,f)):c(g.value===""?void 0:g.value),_()}),_(),te("div",{className:"field choice"},te("label",{htmlFor:a,title:t.description??""},Ni(e)),g,x,m)}var HS=(i,e)=>Object.values(e.properties??{}).length>0&&(e.required??[]).every(t=>sl(i,Ki(i,e.properties[t])));function H0(i,e){return Object.fromEntries((e.required??[]).map(t=>{let n=Ki(i,e.properties[t]),[s]=Object.keys(n.properties??{});return[t,s?{[s]:1}:n["x-default"]??n.enum?.[0]??1]}))}var G0=i=>Object.fromEntries(Object.entries(i).filter(([,e])=>e!==void 0));function z0(i,e,t,n,s,r){let o=n??null,a=te("div",{className:"fields nested"}),l=t.nullable===!0,c=()=>{a.replaceChildren(...Object.entries(t.properties??{}).map(([d,f])=>{let g=Ki(i.openapi,f);return Lf(i,d,g,sl(i.openapi,g),o?.[d],x=>{o=G0({...o,[d]:x}),s(o)},[...r,d])}))};if(!l)return c(),te("fieldset",{className:"field group",title:t.description??""},te("legend",{},Ni(e)),a);let u=te("input",{type:"checkbox",name:r.join("."),id:`option-${r.join("-")}`,checked:o!==null}),h=()=>{a.hidden=o===null,a.replaceChildren(),o&&c()};return u.addEventListener("change",()=>{o=u.checked?H0(i.openapi,t):null,s(o??void 0),h()}),h(),te("div",{className:"field group"},te("label",{className:"check",title:t.description??""},u,Ni(e)),a)}function If(i,e,t,n,s){let r=t.minimum??(t.exclusiveMinimum!==void 0?t.exclusiveMinimum:void 0);return te("input",{type:"number",name:i,id:e,step:n?"1":"any",value:s??"",placeholder:"auto",inputMode:"decimal",...r!==void 0&&{min:String(r)},...t.maximum!==void 0&&{max:String(t.maximum)}})}function GS(i,e,t,n,s,r){let o=n??{},a=Object.keys(t.properties??{}),l=a.find(f=>o[f]!==void 0&&o[f]!==null)??a[0],c=te("select",{"aria-label":Ni(e),name:r.join(".")},...a.map(f=>te("option",{value:f},Zt(f))));c.value=l;let u=f=>Ki(i.openapi,t.properties[f]),h=f=>[u(f).type].flat().includes("integer"),d=If(`${r.join(".")}.value`,`option-${r.join("-")}`,u(l),h(l),o[l]);return d.setAttribute("aria-label",`${Ni(e)}, value`),c.addEventListener("change",()=>{d.value="",d.step=h(c.value)?"1":"any",d.focus()}),d.addEventListener("change",()=>{d.checkValidity()?s(d.value===""?void 0:{[c.value]:d.valueAsNumber}):d.reportValidity()}),te("div",{className:"field",title:t.description??""},te("span",{},Ni(e)),te("span",{className:"pair"},c,d))}var du={columns:6,names:["two-rails","helicoid","catenoid","tent","four-corners","ridge-rope","own-mesh","helicoid-relaxation","two-rings","rings-12-free","rings-12-best","rings-11-proven","rings-14-free","rings-14-best","rings-14-pinkall-polthier","cut-cylinder","three-rings","tetrahedron-loops","nested-loops","three-half-circles","three-half-circles-uneven","helicoid-liu-wang","scherk-relaxation","wavy-strip","contour-stack","wang-tang-i","wang-tang-ii","wang-tang-iii","wang-tang-iv","wang-tang-v","wang-tang-vi","latticed-roof","latticed-roof-steep","latticed-film","latticed-roof-few-lengths","floor-fewest-nodes","floor-equal-members","courtyard","plane-sail","four-point-sail","inflated-disc","conic-tent","flying-mast","ridge-and-valley","air-hall","cushion","film-on-a-plane","four-cables","cable-net-by-targets","vault"]};var Of=[{title:"Tents",about:"Membranes on a boundary of their own",names:["tent","ridge-rope","four-corners","own-mesh"]},{title:"Canopies and soap films",about:"Several rings, every way to span them",names:[/rings/,/loops/,/half-circles/]},{title:"Strips",about:"Ruled surfaces that fold flat",names:["two-rails","wavy-strip","contour-stack",/^wang-tang/]},{title:"Gridshells and floors",about:"Lattices of equal members",names:[/^latticed/,"vault","courtyard",/^floor/]},{title:"Tensile structures",about:"Films with cables, pressure and weight",names:[/sail/,/cable/,/film-on/,/mast/,/conic/,/cushion/,"ridge-and-valley","air-hall","inflated-disc"]},{title:"From the papers",about:"Helicoid, catenoid, Scherk and the methods that found them",names:[/./]}],XS={minimal_surface:5,ruled_surface:2,uniform_mesh:3,tensile_structure:4,cable_net:4},qS=i=>i.replace(/ \((.*)\)$/,"").replace(/, every way to span them compared$/,", compared");function W0(i,e){let t=new Set(i),n=Of.map((s,r)=>{let o=[...t].filter(a=>s.names.some(l=>typeof l=="string"?l===a.name:l.test(a.name))&&(r<Of.length-1||t.has(a)));return o.forEach(a=>t.delete(a)),{...s,found:o}});for(let s of t)n[XS[s.kind]??Of.length-1].found.push(s);return n.filter(({found:s})=>s.length>0).map(({title:s,about:r,found:o})=>te("section",{},te("h3",{},s,te("small",{},r)),te("div",{className:"cards"},...o.map(a=>{let l=te("button",{type:"button",className:"card",title:a.title},YS(a.name),te("span",{},qS(a.title)));return l.dataset.example=a.name,l.addEventListener("click",()=>e(a)),l}))))}function YS(i){let e=du.names.indexOf(i),t=te("span",{className:"thumbnail"});if(t.setAttribute("aria-hidden","true"),e>=0){let{columns:n}=du,s=Math.ceil(du.names.length/n),[r,o]=[e%n,Math.floor(e/n)];t.style.backgroundSize=`${n*100}% ${s*100}%`,t.style.backgroundPosition=`${n>1?100*r/(n-1):0}% ${s>1?100*o/(s-1):0}%`}else t.classList.add("missing");return t}var Nf=0,X0=0,Df=0;function Si(){return X0+=1,X0}async function xo(i){Nf+=1,document.body.setAttribute("aria-busy","true");try{return await i()}finally{Nf-=1,document.body.setAttribute("aria-busy",String(Nf>0))}}var Ur=(i,e,t)=>xo(async()=>{let n=Si();Df=n;try{let s=await i();n===Df&&e(s)}catch(s){n===Df&&t(s,n)}});var Di=class{origin;metres;up;constructor(e,t){this.origin=e,this.metres=yo(t),this.up=t.up==="y"?1:2}toScene(e){let[t,n,s]=[0,1,2].map(r=>((e[r]??0)-this.origin[r])*this.metres);return this.up===2?[t,s,-n]:[t,n,s]}fromScene([e,t,n]){return(this.up===2?[e,-n,t]:[e,t,n]).map((r,o)=>r/this.metres+this.origin[o])}length(e){return e/this.metres}},$S=50;function q0(i,e){let t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let a of i)for(let l of a.points){let c=Dt(l);if(c)for(let u=0;u<3;u+=1)t[u]=Math.min(t[u],c[u]),n[u]=Math.max(n[u],c[u])}if(!Number.isFinite(t[0]))return[0,0,0];let s=Math.max(...t.map((a,l)=>n[l]-a))||1,r=10**Math.ceil(Math.log10(s)),o=e.up==="y"?1:2;return t.map((a,l)=>{let c=l===o?a:(a+n[l])/2;return Math.abs(c)>$S*s?Math.round(c/r)*r:0})}var B_=0,Mp=1,z_=2;var Hl=1,V_=2,jo=3,pi=0,An=1,un=2,as=0,Zo=1,Ep=2,Tp=3,Ap=4,H_=5;var Jr=100,G_=101,W_=102,X_=103,q_=104,Y_=200,$_=201,K_=202,J_=203,Rp=204,Cp=205,j_=206,Z_=207,Q_=208,ey=209,ty=210,ny=211,iy=212,sy=213,ry=214,Gu=0,Wu=1,Xu=2,Fo=3,qu=4,Yu=5,$u=6,Ku=7,dh=0,oy=1,ay=2,ls=0,Pp=1,Ip=2,Lp=3,Op=4,Np=5,Dp=6,Gl=7,up="attached",ly="detached",Up=300,jr=301,Qo=302,fh=303,ph=304,lr=1e3,Mi=1001,ko=1002,on=1003,mh=1004;var Zr=1005;var pn=1006,ea=1007;var Ai=1008;var oi=1009,Fp=1010,kp=1011,ta=1012,gh=1013,Ri=1014,$n=1015,zi=1016,_h=1017,yh=1018,Qr=1020,Bp=35902,zp=35899,Vp=1021,Hp=1022,ii=1023,Fs=1026,$s=1027,xh=1028,Wl=1029,pr=1030,vh=1031;var bh=1033,Xl=33776,ql=33777,Yl=33778,$l=33779,Sh=35840,wh=35841,Mh=35842,Eh=35843,Th=36196,Ah=37492,Rh=37496,Ch=37488,Ph=37489,Kl=37490,Ih=37491,Lh=37808,Oh=37809,Nh=37810,Dh=37811,Uh=37812,Fh=37813,kh=37814,Bh=37815,zh=37816,Vh=37817,Hh=37818,Gh=37819,Wh=37820,Xh=37821,qh=36492,Yh=36494,$h=36495,Kh=36283,Jh=36284,Jl=36285,jh=36286;var Gr=2300,Wr=2301,Vu=2302,hp=2303,dp=2400,fp=2401,pp=2402,cy=2500;var Gp=0,jl=1,na=2,uy=3200;var Zl=0,hy=1,Ks="",hn="srgb",Kn="srgb-linear",gl="linear",Ct="srgb";var Hu=7680;var dy=519,fy=512,py=513,my=514,Wp=515,gy=516,_y=517,Xp=518,qp=519,Yp=35044;var $p="300 es",Ei=2e3,Bo=2001;function KS(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function JS(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function zo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function yy(){let i=zo("canvas");return i.style.display="block",i}var Y0={},Vo=null;function _l(...i){let e="THREE."+i.shift();Vo?Vo("log",e,...i):console.log(e,...i)}function xy(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Fe(...i){i=xy(i);let e="THREE."+i.shift();if(Vo)Vo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function qe(...i){i=xy(i);let e="THREE."+i.shift();if(Vo)Vo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Hr(...i){let e=i.join(" ");e in Y0||(Y0[e]=!0,Fe(...i))}function vy(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var by={[Gu]:Gu,[Xu]:$u,[qu]:qu,[Fo]:Yu,[Wu]:Wu,[$u]:Xu,[Ku]:Ku,[Yu]:Fo},Qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],$0=1234567,pl=Math.PI/180,Xr=180/Math.PI;function cs(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]+"-"+Fn[e&255]+Fn[e>>8&255]+"-"+Fn[e>>16&15|64]+Fn[e>>24&255]+"-"+Fn[t&63|128]+Fn[t>>8&255]+"-"+Fn[t>>16&255]+Fn[t>>24&255]+Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]).toLowerCase()}function je(i,e,t){return Math.max(e,Math.min(t,i))}function Kp(i,e){return(i%e+e)%e}function jS(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function ZS(i,e,t){return i!==e?(t-i)/(e-i):0}function ml(i,e,t){return(1-t)*i+t*e}function QS(i,e,t,n){return ml(i,e,1-Math.exp(-t*n))}function ew(i,e=1){return e-Math.abs(Kp(i,e*2)-e)}function tw(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function nw(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function iw(i,e){return i+Math.floor(Math.random()*(e-i+1))}function sw(i,e){return i+Math.random()*(e-i)}function rw(i){return i*(.5-Math.random())}function ow(i){i!==void 0&&($0=i);let e=$0+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function aw(i){return i*pl}function lw(i){return i*Xr}function cw(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function uw(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function Jp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function hw(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),u=o((e+n)/2),h=r((e-n)/2),d=o((e-n)/2),f=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*u,l*h,l*d,a*c);break;case"YZY":i.set(l*d,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*d,a*u,a*c);break;case"XZX":i.set(a*u,l*g,l*f,a*c);break;case"YXY":i.set(l*f,a*u,l*g,a*c);break;case"ZYZ":i.set(l*g,l*f,a*u,a*c);break;default:Fe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Zh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jp(i,e){if(e.constructor===Float32Array)return i;let t=Zh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Zp(i,e){if(e.constructor===Float32Array)return i;let t=Zh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ia={DEG2RAD:pl,RAD2DEG:Xr,generateUUID:cs,clamp:je,euclideanModulo:Kp,mapLinear:jS,inverseLerp:ZS,lerp:ml,damp:QS,pingpong:ew,smoothstep:tw,smootherstep:nw,randInt:iw,randFloat:sw,randFloatSpread:rw,seededRandom:ow,degToRad:aw,radToDeg:lw,isPowerOfTwo:cw,ceilPowerOfTwo:uw,floorPowerOfTwo:Jp,setQuaternionFromProperEuler:hw,normalize:Zp,denormalize:jp},ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=je(this.x,e.x,t.x),this.y=je(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=je(this.x,e,t),this.y=je(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(je(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Jn=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==g){let m=l*d+c*f+u*g+h*x;m<0&&(d=-d,f=-f,g=-g,x=-x,m=-m);let _=1-a;if(m<.9995){let v=Math.acos(m),M=Math.sin(v);_=Math.sin(_*v)/M,a=Math.sin(a*v)/M,l=l*_+d*a,c=c*_+f*a,u=u*_+g*a,h=h*_+x*a}else{l=l*_+d*a,c=c*_+f*a,u=u*_+g*a,h=h*_+x*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*f-c*d,e[t+1]=l*g+u*d+c*h-a*f,e[t+2]=c*g+u*f+a*d-l*h,e[t+3]=u*g-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:Fe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(je(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(K0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(K0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=je(this.x,e.x,t.x),this.y=je(this.y,e.y,t.y),this.z=je(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=je(this.x,e,t),this.y=je(this.y,e,t),this.z=je(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Uf.copy(this).projectOnVector(e),this.sub(Uf)}reflect(e){return this.sub(Uf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(je(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Uf=new P,K0=new Jn,Je=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],f=n[5],g=n[8],x=s[0],m=s[3],_=s[6],v=s[1],M=s[4],b=s[7],S=s[2],y=s[5],p=s[8];return r[0]=o*x+a*v+l*S,r[3]=o*m+a*M+l*y,r[6]=o*_+a*b+l*p,r[1]=c*x+u*v+h*S,r[4]=c*m+u*M+h*y,r[7]=c*_+u*b+h*p,r[2]=d*x+f*v+g*S,r[5]=d*m+f*M+g*y,r[8]=d*_+f*b+g*p,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=t*h+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/g;return e[0]=h*x,e[1]=(s*c-u*n)*x,e[2]=(a*n-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(n*l-c*t)*x,e[8]=(o*t-n*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Hr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ff.makeScale(e,t)),this}rotate(e){return Hr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ff.makeRotation(-e)),this}translate(e,t){return Hr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ff.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Ff=new Je,J0=new Je().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),j0=new Je().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function dw(){let i={enabled:!0,workingColorSpace:Kn,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ct&&(s.r=Ds(s.r),s.g=Ds(s.g),s.b=Ds(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ct&&(s.r=Uo(s.r),s.g=Uo(s.g),s.b=Uo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ks?gl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Kn]:{primaries:e,whitePoint:n,transfer:gl,toXYZ:J0,fromXYZ:j0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:hn},outputColorSpaceConfig:{drawingBufferColorSpace:hn}},[hn]:{primaries:e,whitePoint:n,transfer:Ct,toXYZ:J0,fromXYZ:j0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:hn}}}),i}var st=dw();function Ds(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Uo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var vo,Ju=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{vo===void 0&&(vo=zo("canvas")),vo.width=e.width,vo.height=e.height;let s=vo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=vo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=zo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ds(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Ds(t[n]/255)*255):t[n]=Ds(t[n]);return{data:t,width:e.width,height:e.height}}else return Fe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},fw=0,Ho=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:fw++}),this.uuid=cs(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(kf(s[o].image)):r.push(kf(s[o]))}else r=kf(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function kf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Ju.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Fe("Texture: Unable to serialize Texture."),{})}var pw=0,Bf=new P,wn=class i extends Qi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=Mi,s=Mi,r=pn,o=Ai,a=ii,l=oi,c=i.DEFAULT_ANISOTROPY,u=Ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:pw++}),this.uuid=cs(),this.name="",this.source=new Ho(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ke(0,0),this.repeat=new ke(1,1),this.center=new ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Je,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Bf).x}get height(){return this.source.getSize(Bf).y}get depth(){return this.source.getSize(Bf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Fe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Fe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Up)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case lr:e.x=e.x-Math.floor(e.x);break;case Mi:e.x=e.x<0?0:1;break;case ko:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case lr:e.y=e.y-Math.floor(e.y);break;case Mi:e.y=e.y<0?0:1;break;case ko:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};wn.DEFAULT_IMAGE=null;wn.DEFAULT_MAPPING=Up;wn.DEFAULT_ANISOTROPY=1;var ct=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],x=l[2],m=l[6],_=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let M=(c+1)/2,b=(f+1)/2,S=(_+1)/2,y=(u+d)/4,p=(h+x)/4,w=(g+m)/4;return M>b&&M>S?M<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(M),s=y/n,r=p/n):b>S?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=y/s,r=w/s):S<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(S),n=p/r,s=w/r),this.set(n,s,r,t),this}let v=Math.sqrt((m-g)*(m-g)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(h-x)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=je(this.x,e.x,t.x),this.y=je(this.y,e.y,t.y),this.z=je(this.z,e.z,t.z),this.w=je(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=je(this.x,e,t),this.y=je(this.y,e,t),this.z=je(this.z,e,t),this.w=je(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(je(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ju=class extends Qi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new ct(0,0,e,t),this.scissorTest=!1,this.viewport=new ct(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new wn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:pn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ho(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Vn=class extends ju{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},yl=class extends wn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=on,this.minFilter=on,this.wrapR=Mi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Zu=class extends wn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=on,this.minFilter=on,this.wrapR=Mi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ce=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,d,f,g,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,f,g,x,m)}set(e,t,n,s,r,o,a,l,c,u,h,d,f,g,x,m){let _=this.elements;return _[0]=e,_[4]=t,_[8]=n,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=h,_[14]=d,_[3]=f,_[7]=g,_[11]=x,_[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/bo.setFromMatrixColumn(e,0).length(),r=1/bo.setFromMatrixColumn(e,1).length(),o=1/bo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,g=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+g*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,g=c*u,x=c*h;t[0]=d+x*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,g=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,g=a*u,x=a*h;t[0]=l*u,t[4]=g*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=g*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+g,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(mw,e,gw)}lookAt(e,t,n){let s=this.elements;return di.subVectors(e,t),di.lengthSq()===0&&(di.z=1),di.normalize(),nr.crossVectors(n,di),nr.lengthSq()===0&&(Math.abs(n.z)===1?di.x+=1e-4:di.z+=1e-4,di.normalize(),nr.crossVectors(n,di)),nr.normalize(),fu.crossVectors(di,nr),s[0]=nr.x,s[4]=fu.x,s[8]=di.x,s[1]=nr.y,s[5]=fu.y,s[9]=di.y,s[2]=nr.z,s[6]=fu.z,s[10]=di.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],f=n[13],g=n[2],x=n[6],m=n[10],_=n[14],v=n[3],M=n[7],b=n[11],S=n[15],y=s[0],p=s[4],w=s[8],T=s[12],E=s[1],C=s[5],O=s[9],U=s[13],I=s[2],D=s[6],V=s[10],F=s[14],ie=s[3],z=s[7],q=s[11],W=s[15];return r[0]=o*y+a*E+l*I+c*ie,r[4]=o*p+a*C+l*D+c*z,r[8]=o*w+a*O+l*V+c*q,r[12]=o*T+a*U+l*F+c*W,r[1]=u*y+h*E+d*I+f*ie,r[5]=u*p+h*C+d*D+f*z,r[9]=u*w+h*O+d*V+f*q,r[13]=u*T+h*U+d*F+f*W,r[2]=g*y+x*E+m*I+_*ie,r[6]=g*p+x*C+m*D+_*z,r[10]=g*w+x*O+m*V+_*q,r[14]=g*T+x*U+m*F+_*W,r[3]=v*y+M*E+b*I+S*ie,r[7]=v*p+M*C+b*D+S*z,r[11]=v*w+M*O+b*V+S*q,r[15]=v*T+M*U+b*F+S*W,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],x=e[7],m=e[11],_=e[15],v=l*f-c*d,M=a*f-c*h,b=a*d-l*h,S=o*f-c*u,y=o*d-l*u,p=o*h-a*u;return t*(x*v-m*M+_*b)-n*(g*v-m*S+_*y)+s*(g*M-x*S+_*p)-r*(g*b-x*y+m*p)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],x=e[13],m=e[14],_=e[15],v=t*a-n*o,M=t*l-s*o,b=t*c-r*o,S=n*l-s*a,y=n*c-r*a,p=s*c-r*l,w=u*x-h*g,T=u*m-d*g,E=u*_-f*g,C=h*m-d*x,O=h*_-f*x,U=d*_-f*m,I=v*U-M*O+b*C+S*E-y*T+p*w;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let D=1/I;return e[0]=(a*U-l*O+c*C)*D,e[1]=(s*O-n*U-r*C)*D,e[2]=(x*p-m*y+_*S)*D,e[3]=(d*y-h*p-f*S)*D,e[4]=(l*E-o*U-c*T)*D,e[5]=(t*U-s*E+r*T)*D,e[6]=(m*b-g*p-_*M)*D,e[7]=(u*p-d*b+f*M)*D,e[8]=(o*O-a*E+c*w)*D,e[9]=(n*E-t*O-r*w)*D,e[10]=(g*y-x*b+_*v)*D,e[11]=(h*b-u*y-f*v)*D,e[12]=(a*T-o*C-l*w)*D,e[13]=(t*C-n*T+s*w)*D,e[14]=(x*M-g*S-m*v)*D,e[15]=(u*S-h*M+d*v)*D,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,x=o*u,m=o*h,_=a*h,v=l*c,M=l*u,b=l*h,S=n.x,y=n.y,p=n.z;return s[0]=(1-(x+_))*S,s[1]=(f+b)*S,s[2]=(g-M)*S,s[3]=0,s[4]=(f-b)*y,s[5]=(1-(d+_))*y,s[6]=(m+v)*y,s[7]=0,s[8]=(g+M)*p,s[9]=(m-v)*p,s[10]=(1-(d+x))*p,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=bo.set(s[0],s[1],s[2]).length(),a=bo.set(s[4],s[5],s[6]).length(),l=bo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ui.copy(this);let c=1/o,u=1/a,h=1/l;return Ui.elements[0]*=c,Ui.elements[1]*=c,Ui.elements[2]*=c,Ui.elements[4]*=u,Ui.elements[5]*=u,Ui.elements[6]*=u,Ui.elements[8]*=h,Ui.elements[9]*=h,Ui.elements[10]*=h,t.setFromRotationMatrix(Ui),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Ei,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,x;if(l)g=r/(o-r),x=o*r/(o-r);else if(a===Ei)g=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Bo)g=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ei,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,x;if(l)g=1/(o-r),x=o/(o-r);else if(a===Ei)g=-2/(o-r),x=-(o+r)/(o-r);else if(a===Bo)g=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},bo=new P,Ui=new Ce,mw=new P(0,0,0),gw=new P(1,1,1),nr=new P,fu=new P,di=new P,Z0=new Ce,Q0=new Jn,es=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(je(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-je(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(je(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-je(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(je(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-je(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Fe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Z0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Z0,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Q0.setFromEuler(this),this.setFromQuaternion(Q0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};es.DEFAULT_ORDER="XYZ";var Go=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},_w=0,e_=new P,So=new Jn,Cs=new Ce,pu=new P,rl=new P,yw=new P,xw=new Jn,t_=new P(1,0,0),n_=new P(0,1,0),i_=new P(0,0,1),s_={type:"added"},vw={type:"removed"},wo={type:"childadded",child:null},zf={type:"childremoved",child:null},Qt=class i extends Qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:_w++}),this.uuid=cs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new P,t=new es,n=new Jn,s=new P(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ce},normalMatrix:{value:new Je}}),this.matrix=new Ce,this.matrixWorld=new Ce,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Go,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return So.setFromAxisAngle(e,t),this.quaternion.multiply(So),this}rotateOnWorldAxis(e,t){return So.setFromAxisAngle(e,t),this.quaternion.premultiply(So),this}rotateX(e){return this.rotateOnAxis(t_,e)}rotateY(e){return this.rotateOnAxis(n_,e)}rotateZ(e){return this.rotateOnAxis(i_,e)}translateOnAxis(e,t){return e_.copy(e).applyQuaternion(this.quaternion),this.position.add(e_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(t_,e)}translateY(e){return this.translateOnAxis(n_,e)}translateZ(e){return this.translateOnAxis(i_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Cs.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?pu.copy(e):pu.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),rl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Cs.lookAt(rl,pu,this.up):Cs.lookAt(pu,rl,this.up),this.quaternion.setFromRotationMatrix(Cs),s&&(Cs.extractRotation(s.matrixWorld),So.setFromRotationMatrix(Cs),this.quaternion.premultiply(So.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(s_),wo.child=e,this.dispatchEvent(wo),wo.child=null):qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(vw),zf.child=e,this.dispatchEvent(zf),zf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Cs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Cs.multiply(e.parent.matrixWorld)),e.applyMatrix4(Cs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(s_),wo.child=e,this.dispatchEvent(wo),wo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(rl,e,yw),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(rl,xw,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Qt.DEFAULT_UP=new P(0,1,0);Qt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Qt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Sn=class extends Qt{constructor(){super(),this.isGroup=!0,this.type="Group"}},bw={type:"move"},Wo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Sn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Sn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Sn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,n),_=this._getHandJoint(c,x);m!==null&&(_.matrix.fromArray(m.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=m.radius),_.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(bw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Sn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Sy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ir={h:0,s:0,l:0},mu={h:0,s:0,l:0};function Vf(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ue=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=hn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,st.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=st.workingColorSpace){return this.r=e,this.g=t,this.b=n,st.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=st.workingColorSpace){if(e=Kp(e,1),t=je(t,0,1),n=je(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Vf(o,r,e+1/3),this.g=Vf(o,r,e),this.b=Vf(o,r,e-1/3)}return st.colorSpaceToWorking(this,s),this}setStyle(e,t=hn){function n(r){r!==void 0&&parseFloat(r)<1&&Fe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Fe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Fe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=hn){let n=Sy[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Fe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ds(e.r),this.g=Ds(e.g),this.b=Ds(e.b),this}copyLinearToSRGB(e){return this.r=Uo(e.r),this.g=Uo(e.g),this.b=Uo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=hn){return st.workingToColorSpace(kn.copy(this),e),Math.round(je(kn.r*255,0,255))*65536+Math.round(je(kn.g*255,0,255))*256+Math.round(je(kn.b*255,0,255))}getHexString(e=hn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=st.workingColorSpace){st.workingToColorSpace(kn.copy(this),t);let n=kn.r,s=kn.g,r=kn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=st.workingColorSpace){return st.workingToColorSpace(kn.copy(this),t),e.r=kn.r,e.g=kn.g,e.b=kn.b,e}getStyle(e=hn){st.workingToColorSpace(kn.copy(this),e);let t=kn.r,n=kn.g,s=kn.b;return e!==hn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ir),this.setHSL(ir.h+e,ir.s+t,ir.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ir),e.getHSL(mu);let n=ml(ir.h,mu.h,t),s=ml(ir.s,mu.s,t),r=ml(ir.l,mu.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},kn=new Ue;Ue.NAMES=Sy;var xl=class extends Qt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new es,this.environmentIntensity=1,this.environmentRotation=new es,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Fi=new P,Ps=new P,Hf=new P,Is=new P,Mo=new P,Eo=new P,r_=new P,Gf=new P,Wf=new P,Xf=new P,qf=new ct,Yf=new ct,$f=new ct,zn=class i{constructor(e=new P,t=new P,n=new P){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Fi.subVectors(e,t),s.cross(Fi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Fi.subVectors(s,t),Ps.subVectors(n,t),Hf.subVectors(e,t);let o=Fi.dot(Fi),a=Fi.dot(Ps),l=Fi.dot(Hf),c=Ps.dot(Ps),u=Ps.dot(Hf),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,Is)===null?!1:Is.x>=0&&Is.y>=0&&Is.x+Is.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,Is)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Is.x),l.addScaledVector(o,Is.y),l.addScaledVector(a,Is.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return qf.setScalar(0),Yf.setScalar(0),$f.setScalar(0),qf.fromBufferAttribute(e,t),Yf.fromBufferAttribute(e,n),$f.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(qf,r.x),o.addScaledVector(Yf,r.y),o.addScaledVector($f,r.z),o}static isFrontFacing(e,t,n,s){return Fi.subVectors(n,t),Ps.subVectors(e,t),Fi.cross(Ps).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Fi.subVectors(this.c,this.b),Ps.subVectors(this.a,this.b),Fi.cross(Ps).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Mo.subVectors(s,n),Eo.subVectors(r,n),Gf.subVectors(e,n);let l=Mo.dot(Gf),c=Eo.dot(Gf);if(l<=0&&c<=0)return t.copy(n);Wf.subVectors(e,s);let u=Mo.dot(Wf),h=Eo.dot(Wf);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(Mo,o);Xf.subVectors(e,r);let f=Mo.dot(Xf),g=Eo.dot(Xf);if(g>=0&&f<=g)return t.copy(r);let x=f*c-l*g;if(x<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Eo,a);let m=u*g-f*h;if(m<=0&&h-u>=0&&f-g>=0)return r_.subVectors(r,s),a=(h-u)/(h-u+(f-g)),t.copy(s).addScaledVector(r_,a);let _=1/(m+x+d);return o=x*_,a=d*_,t.copy(n).addScaledVector(Mo,o).addScaledVector(Eo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},tt=class{constructor(e=new P(1/0,1/0,1/0),t=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ki):ki.fromBufferAttribute(r,o),ki.applyMatrix4(e.matrixWorld),this.expandByPoint(ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),gu.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),gu.copy(n.boundingBox)),gu.applyMatrix4(e.matrixWorld),this.union(gu)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ki),ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(ol),_u.subVectors(this.max,ol),To.subVectors(e.a,ol),Ao.subVectors(e.b,ol),Ro.subVectors(e.c,ol),sr.subVectors(Ao,To),rr.subVectors(Ro,Ao),Fr.subVectors(To,Ro);let t=[0,-sr.z,sr.y,0,-rr.z,rr.y,0,-Fr.z,Fr.y,sr.z,0,-sr.x,rr.z,0,-rr.x,Fr.z,0,-Fr.x,-sr.y,sr.x,0,-rr.y,rr.x,0,-Fr.y,Fr.x,0];return!Kf(t,To,Ao,Ro,_u)||(t=[1,0,0,0,1,0,0,0,1],!Kf(t,To,Ao,Ro,_u))?!1:(yu.crossVectors(sr,rr),t=[yu.x,yu.y,yu.z],Kf(t,To,Ao,Ro,_u))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ls),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ls=[new P,new P,new P,new P,new P,new P,new P,new P],ki=new P,gu=new tt,To=new P,Ao=new P,Ro=new P,sr=new P,rr=new P,Fr=new P,ol=new P,_u=new P,yu=new P,kr=new P;function Kf(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){kr.fromArray(i,r);let a=s.x*Math.abs(kr.x)+s.y*Math.abs(kr.y)+s.z*Math.abs(kr.z),l=e.dot(kr),c=t.dot(kr),u=n.dot(kr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var cn=new P,xu=new ke,Sw=0,mt=class extends Qi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Sw++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Yp,this.updateRanges=[],this.gpuType=$n,this.version=0,this._normalizationScale=e!==void 0?Zh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)xu.fromBufferAttribute(this,t),xu.applyMatrix3(e),this.setXY(t,xu.x,xu.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)cn.fromBufferAttribute(this,t),cn.applyMatrix3(e),this.setXYZ(t,cn.x,cn.y,cn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)cn.fromBufferAttribute(this,t),cn.applyMatrix4(e),this.setXYZ(t,cn.x,cn.y,cn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)cn.fromBufferAttribute(this,t),cn.applyNormalMatrix(e),this.setXYZ(t,cn.x,cn.y,cn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)cn.fromBufferAttribute(this,t),cn.transformDirection(e),this.setXYZ(t,cn.x,cn.y,cn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):jp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zp(e,this.array)}};var vl=class extends mt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var bl=class extends mt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var fn=class extends mt{constructor(e,t,n){super(new Float32Array(e),t,n)}},ww=new tt,al=new P,Jf=new P,Vt=class{constructor(e=new P,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):ww.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;al.subVectors(e,this.center);let t=al.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(al,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Jf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(al.copy(e.center).add(Jf)),this.expandByPoint(al.copy(e.center).sub(Jf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Mw=0,wi=new Ce,jf=new Qt,Co=new P,fi=new tt,ll=new tt,bn=new P,Kt=class i extends Qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Mw++}),this.uuid=cs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(KS(e)?bl:vl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Je().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return wi.makeRotationFromQuaternion(e),this.applyMatrix4(wi),this}rotateX(e){return wi.makeRotationX(e),this.applyMatrix4(wi),this}rotateY(e){return wi.makeRotationY(e),this.applyMatrix4(wi),this}rotateZ(e){return wi.makeRotationZ(e),this.applyMatrix4(wi),this}translate(e,t,n){return wi.makeTranslation(e,t,n),this.applyMatrix4(wi),this}scale(e,t,n){return wi.makeScale(e,t,n),this.applyMatrix4(wi),this}lookAt(e){return jf.lookAt(e),jf.updateMatrix(),this.applyMatrix4(jf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Co).negate(),this.translate(Co.x,Co.y,Co.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new fn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Fe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tt);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];fi.setFromBufferAttribute(r),this.morphTargetsRelative?(bn.addVectors(this.boundingBox.min,fi.min),this.boundingBox.expandByPoint(bn),bn.addVectors(this.boundingBox.max,fi.max),this.boundingBox.expandByPoint(bn)):(this.boundingBox.expandByPoint(fi.min),this.boundingBox.expandByPoint(fi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vt);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(e){let n=this.boundingSphere.center;if(fi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ll.setFromBufferAttribute(a),this.morphTargetsRelative?(bn.addVectors(fi.min,ll.min),fi.expandByPoint(bn),bn.addVectors(fi.max,ll.max),fi.expandByPoint(bn)):(fi.expandByPoint(ll.min),fi.expandByPoint(ll.max))}fi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)bn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)bn.fromBufferAttribute(a,c),l&&(Co.fromBufferAttribute(e,c),bn.add(Co)),s=Math.max(s,n.distanceToSquared(bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new mt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let T=0;T<n.count;T++)a[T]=new P,l[T]=new P;let u=new P,h=new P,d=new P,f=new ke,g=new ke,x=new ke,m=new P,_=new P;function v(T,E,C){c[T]=c[E]=c[C]=1,u.fromBufferAttribute(n,T),h.fromBufferAttribute(n,E),d.fromBufferAttribute(n,C),f.fromBufferAttribute(r,T),g.fromBufferAttribute(r,E),x.fromBufferAttribute(r,C),h.sub(u),d.sub(u),g.sub(f),x.sub(f);let O=1/(g.x*x.y-x.x*g.y);isFinite(O)&&(m.copy(h).multiplyScalar(x.y).addScaledVector(d,-g.y).multiplyScalar(O),_.copy(d).multiplyScalar(g.x).addScaledVector(h,-x.x).multiplyScalar(O),a[T].add(m),a[E].add(m),a[C].add(m),l[T].add(_),l[E].add(_),l[C].add(_))}let M=this.groups;M.length===0&&(M=[{start:0,count:e.count}]);for(let T=0,E=M.length;T<E;++T){let C=M[T],O=C.start,U=C.count;for(let I=O,D=O+U;I<D;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let b=new P,S=new P,y=new P,p=new P;function w(T){y.fromBufferAttribute(s,T),p.copy(y);let E=a[T];b.copy(E),b.sub(y.multiplyScalar(y.dot(E))).normalize(),S.crossVectors(p,E);let O=S.dot(l[T])<0?-1:1;o.setXYZW(T,b.x,b.y,b.z,O)}for(let T=0,E=n.count;T<E;++T)c[T]&&w(T);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new mt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new P,r=new P,o=new P,a=new P,l=new P,c=new P,u=new P,h=new P;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)bn.fromBufferAttribute(e,t),bn.normalize(),e.setXYZ(t,bn.x,bn.y,bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,g=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let _=0;_<u;_++)d[g++]=c[f++]}return new mt(d,u,h)}if(this.index===null)return Fe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},qr=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Yp,this.updateRanges=[],this.version=0,this.uuid=cs()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=o_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=o_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function o_(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=cs()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var qn=new P,si=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Zh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)qn.fromBufferAttribute(this,t),qn.applyMatrix4(e),this.setXYZ(t,qn.x,qn.y,qn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)qn.fromBufferAttribute(this,t),qn.applyNormalMatrix(e),this.setXYZ(t,qn.x,qn.y,qn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)qn.fromBufferAttribute(this,t),qn.transformDirection(e),this.setXYZ(t,qn.x,qn.y,qn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){_l("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new mt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){_l("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):jp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zp(e,this.data.array)}},Zf=new P,Ew=new P,Tw=new Je,Yn=class{constructor(e=new P(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Zf.subVectors(n,t).cross(Ew.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Zf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||Tw.getNormalMatrix(e),s=this.coplanarPoint(Zf).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Aw=0,jn=class extends Qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Aw++}),this.uuid=cs(),this.name="",this.type="Material",this.blending=Zo,this.side=pi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Rp,this.blendDst=Cp,this.blendEquation=Jr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ue(0,0,0),this.blendAlpha=0,this.depthFunc=Fo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=dy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Hu,this.stencilZFail=Hu,this.stencilZPass=Hu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Fe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Fe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ue().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Yn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ke().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Os=new P,Qf=new P,vu=new P,bu=new P,ts=class{constructor(e=new P,t=new P(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Os)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Os.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Os.copy(this.origin).addScaledVector(this.direction,t),Os.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Qf.copy(e).add(t).multiplyScalar(.5),vu.copy(t).sub(e).normalize(),bu.copy(this.origin).sub(Qf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(vu),a=bu.dot(this.direction),l=-bu.dot(vu),c=bu.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Qf).addScaledVector(vu,d),f}intersectSphere(e,t){if(e.radius<0)return null;Os.subVectors(e.center,this.origin);let n=Os.dot(this.direction),s=Os.dot(Os)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Os)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,x=t.y-o.y,m=t.z-o.z,_=n.x-o.x,v=n.y-o.y,M=n.z-o.z,b=Math.abs(l),S=Math.abs(c),y=Math.abs(u),p,w,T,E,C,O,U,I,D,V,F,ie;if(b>=S&&b>=y?(T=l,O=h,D=g,ie=_,l>=0?(p=c,w=u,E=d,C=f,U=x,I=m,V=v,F=M):(p=u,w=c,E=f,C=d,U=m,I=x,V=M,F=v)):S>=y?(T=c,O=d,D=x,ie=v,c>=0?(p=u,w=l,E=f,C=h,U=m,I=g,V=M,F=_):(p=l,w=u,E=h,C=f,U=g,I=m,V=_,F=M)):(T=u,O=f,D=m,ie=M,u>=0?(p=l,w=c,E=h,C=d,U=g,I=x,V=_,F=v):(p=c,w=l,E=d,C=h,U=x,I=g,V=v,F=_)),T===0)return null;let z=p/T,q=w/T,W=1/T,_e=E-z*O,Te=C-q*O,K=U-z*D,ae=I-q*D,se=V-z*ie,ue=F-q*ie,re=se*ae-ue*K,de=_e*ue-Te*se,$e=K*Te-ae*_e;if(s){if(re<0||de<0||$e<0)return null}else if((re<0||de<0||$e<0)&&(re>0||de>0||$e>0))return null;let Ae=re+de+$e;if(Ae===0)return null;let Ve=W*(re*O+de*D+$e*ie);return(Ae>0?Ve<0:Ve>0)?null:this.at(Ve/Ae,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ti=class extends jn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new es,this.combine=dh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},a_=new Ce,Br=new ts,Su=new Vt,l_=new P,wu=new P,Mu=new P,Eu=new P,ep=new P,Tu=new P,c_=new P,Au=new P,Pt=class extends Qt{constructor(e=new Kt,t=new Ti){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Tu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(ep.fromBufferAttribute(h,e),o?Tu.addScaledVector(ep,u):Tu.addScaledVector(ep.sub(t),u))}t.add(Tu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Su.copy(n.boundingSphere),Su.applyMatrix4(r),Br.copy(e.ray).recast(e.near),!(Su.containsPoint(Br.origin)===!1&&(Br.intersectSphere(Su,l_)===null||Br.origin.distanceToSquared(l_)>(e.far-e.near)**2))&&(a_.copy(r).invert(),Br.copy(e.ray).applyMatrix4(a_),!(n.boundingBox!==null&&Br.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Br)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let m=d[g],_=o[m.materialIndex],v=Math.max(m.start,f.start),M=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,S=M;b<S;b+=3){let y=a.getX(b),p=a.getX(b+1),w=a.getX(b+2);s=Ru(this,_,e,n,c,u,h,y,p,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=g,_=x;m<_;m+=3){let v=a.getX(m),M=a.getX(m+1),b=a.getX(m+2);s=Ru(this,o,e,n,c,u,h,v,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,x=d.length;g<x;g++){let m=d[g],_=o[m.materialIndex],v=Math.max(m.start,f.start),M=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,S=M;b<S;b+=3){let y=b,p=b+1,w=b+2;s=Ru(this,_,e,n,c,u,h,y,p,w),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=g,_=x;m<_;m+=3){let v=m,M=m+1,b=m+2;s=Ru(this,o,e,n,c,u,h,v,M,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Rw(i,e,t,n,s,r,o,a){let l;if(e.side===An?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===pi,a),l===null)return null;Au.copy(a),Au.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Au);return c<t.near||c>t.far?null:{distance:c,point:Au.clone(),object:i}}function Ru(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,wu),i.getVertexPosition(l,Mu),i.getVertexPosition(c,Eu);let u=Rw(i,e,t,n,wu,Mu,Eu,c_);if(u){let h=new P;zn.getBarycoord(c_,wu,Mu,Eu,h),s&&(u.uv=zn.getInterpolatedAttribute(s,a,l,c,h,new ke)),r&&(u.uv1=zn.getInterpolatedAttribute(r,a,l,c,h,new ke)),o&&(u.normal=zn.getInterpolatedAttribute(o,a,l,c,h,new P),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new P,materialIndex:0};zn.getNormal(wu,Mu,Eu,d.normal),u.face=d,u.barycoord=h}return u}var cl=new ct,u_=new ct,h_=new ct,Cw=new ct,d_=new Ce,Cu=new P,tp=new Vt,f_=new Ce,np=new ts,Sl=class extends Pt{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=up,this.bindMatrix=new Ce,this.bindMatrixInverse=new Ce,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new tt),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Cu),this.boundingBox.expandByPoint(Cu)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new Vt),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Cu),this.boundingSphere.expandByPoint(Cu)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,s=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),tp.copy(this.boundingSphere),tp.applyMatrix4(s),e.ray.intersectsSphere(tp)!==!1&&(f_.copy(s).invert(),np.copy(e.ray).applyMatrix4(f_),!(this.boundingBox!==null&&np.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,np)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new ct,t=this.geometry.attributes.skinWeight;for(let n=0,s=t.count;n<s;n++){e.fromBufferAttribute(t,n);let r=1/e.manhattanLength();r!==1/0?e.multiplyScalar(r):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===up?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===ly?this.bindMatrixInverse.copy(this.bindMatrix).invert():Fe("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,s=this.geometry;u_.fromBufferAttribute(s.attributes.skinIndex,e),h_.fromBufferAttribute(s.attributes.skinWeight,e),t.isVector4?(cl.copy(t),t.set(0,0,0,0)):(cl.set(t.x,t.y,t.z,1),t.set(0,0,0)),cl.applyMatrix4(this.bindMatrix);for(let r=0;r<4;r++){let o=h_.getComponent(r);if(o!==0){let a=u_.getComponent(r);d_.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(Cw.copy(cl).applyMatrix4(d_),o)}}return t.isVector4&&(t.w=cl.w),t.applyMatrix4(this.bindMatrixInverse)}},Xo=class extends Qt{constructor(){super(),this.isBone=!0,this.type="Bone"}},Us=class extends wn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=on,u=on,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},p_=new Ce,Pw=new Ce,wl=class i{constructor(e=[],t=[]){this.uuid=cs(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){Fe("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,s=this.bones.length;n<s;n++)this.boneInverses.push(new Ce)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new Ce;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,s=this.boneTexture;for(let r=0,o=e.length;r<o;r++){let a=e[r]?e[r].matrixWorld:Pw;p_.multiplyMatrices(a,t[r]),p_.toArray(n,r*16)}s!==null&&(s.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new Us(t,e,e,ii,$n);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let s=this.bones[t];if(s.name===e)return s}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,s=e.bones.length;n<s;n++){let r=e.bones[n],o=t[r];o===void 0&&(Fe("Skeleton: No bone found with UUID:",r),o=new Xo),this.bones.push(o),this.boneInverses.push(new Ce().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let s=0,r=t.length;s<r;s++){let o=t[s];e.bones.push(o.uuid);let a=n[s];e.boneInverses.push(a.toArray())}return e}},ks=class extends mt{constructor(e,t,n,s=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Po=new Ce,m_=new Ce,Pu=[],g_=new tt,Iw=new Ce,ul=new Pt,hl=new Vt,Ml=class extends Pt{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new ks(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,Iw)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new tt),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Po),g_.copy(e.boundingBox).applyMatrix4(Po),this.boundingBox.union(g_)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Vt),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Po),hl.copy(e.boundingSphere).applyMatrix4(Po),this.boundingSphere.union(hl)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=e*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(e,t){let n=this.matrixWorld,s=this.count;if(ul.geometry=this.geometry,ul.material=this.material,ul.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),hl.copy(this.boundingSphere),hl.applyMatrix4(n),e.ray.intersectsSphere(hl)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Po),m_.multiplyMatrices(n,Po),ul.matrixWorld=m_,ul.raycast(e,Pu);for(let o=0,a=Pu.length;o<a;o++){let l=Pu[o];l.instanceId=r,l.object=this,t.push(l)}Pu.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new ks(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Us(new Float32Array(s*this.count),s,this.count,xh,$n));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},zr=new Vt,Lw=new ke(.5,.5),Iu=new P,Bs=class{constructor(e=new Yn,t=new Yn,n=new Yn,s=new Yn,r=new Yn,o=new Yn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ei,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],x=r[9],m=r[10],_=r[11],v=r[12],M=r[13],b=r[14],S=r[15];if(s[0].setComponents(c-o,f-u,_-g,S-v).normalize(),s[1].setComponents(c+o,f+u,_+g,S+v).normalize(),s[2].setComponents(c+a,f+h,_+x,S+M).normalize(),s[3].setComponents(c-a,f-h,_-x,S-M).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,_-m,S-b).normalize();else if(s[4].setComponents(c-l,f-d,_-m,S-b).normalize(),t===Ei)s[5].setComponents(c+l,f+d,_+m,S+b).normalize();else if(t===Bo)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),zr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),zr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(zr)}intersectsSprite(e){zr.center.set(0,0,0);let t=Lw.distanceTo(e.center);return zr.radius=.7071067811865476+t,zr.applyMatrix4(e.matrixWorld),this.intersectsSphere(zr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Iu.x=s.normal.x>0?e.max.x:e.min.x,Iu.y=s.normal.y>0?e.max.y:e.min.y,Iu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Iu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},__=new Ce,El=class i{constructor(){this.coordinateSystem=Ei,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];__.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Bs),n[s].setFromProjectionMatrix(__,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Bs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};function ip(i,e){return i-e}function Ow(i,e){return i.z-e.z}function Nw(i,e){return e.z-i.z}var mp=class{constructor(){this.index=0,this.pool=[],this.list=[]}push(e,t,n,s){let r=this.pool,o=this.list;this.index>=r.length&&r.push({start:-1,count:-1,z:-1,index:-1});let a=r[this.index];o.push(a),this.index++,a.start=e,a.count=t,a.z=n,a.index=s}reset(){this.list.length=0,this.index=0}},ni=new Ce,Dw=new Ue(1,1,1),Uw=new Bs,Fw=new El,Lu=new tt,Vr=new Vt,sp=new P,y_=new P,x_=new P,kw=new P,rp=new mp,Bn=new Pt,Ou=[];function Bw(i,e,t=0){let n=e.itemSize;if(i.isInterleavedBufferAttribute||i.array.constructor!==e.array.constructor){let s=i.count;for(let r=0;r<s;r++)for(let o=0;o<n;o++)e.setComponent(r+t,o,i.getComponent(r,o))}else e.array.set(i.array,t*n);e.needsUpdate=!0}function Ji(i,e){if(i.constructor!==e.constructor){let t=Math.min(i.length,e.length);for(let n=0;n<t;n++)e[n]=i[n]}else{let t=Math.min(i.length,e.length);e.set(new i.constructor(i.buffer,0,t))}}var Tl=class extends Pt{constructor(e,t,n=t*2,s){super(new Kt,s),this.isBatchedMesh=!0,this.perObjectFrustumCulled=!0,this.sortObjects=!0,this.boundingBox=null,this.boundingSphere=null,this.customSort=null,this._instanceInfo=[],this._geometryInfo=[],this._availableInstanceIds=[],this._availableGeometryIds=[],this._nextIndexStart=0,this._nextVertexStart=0,this._geometryCount=0,this._visibilityChanged=!0,this._geometryInitialized=!1,this._maxInstanceCount=e,this._maxVertexCount=t,this._maxIndexCount=n,this._multiDrawCounts=new Int32Array(e),this._multiDrawStarts=new Int32Array(e),this._multiDrawCount=0,this._multiDrawBytesPerElement=1,this._mergedDrawCounts=new Int32Array(e),this._mergedDrawStarts=new Int32Array(e),this._mergedDrawInstanceCounts=new Int32Array(e),this._mergedDrawCount=0,this._matricesTexture=null,this._indirectTexture=null,this._colorsTexture=null,this._previousMatricesTexture=null,this._initMatricesTexture(),this._initIndirectTexture()}get maxInstanceCount(){return this._maxInstanceCount}get instanceCount(){return this._instanceInfo.length-this._availableInstanceIds.length}get unusedVertexCount(){return this._maxVertexCount-this._nextVertexStart}get unusedIndexCount(){return this._maxIndexCount-this._nextIndexStart}_initMatricesTexture(){let e=Math.sqrt(this._maxInstanceCount*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4),n=new Us(t,e,e,ii,$n);this._matricesTexture=n}_initIndirectTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Uint32Array(e*e),n=new Us(t,e,e,Wl,Ri);this._indirectTexture=n}_initColorsTexture(){let e=Math.sqrt(this._maxInstanceCount);e=Math.ceil(e);let t=new Float32Array(e*e*4).fill(1),n=new Us(t,e,e,ii,$n);n.colorSpace=st.workingColorSpace,this._colorsTexture=n}_initializeGeometry(e){let t=this.geometry,n=this._maxVertexCount,s=this._maxIndexCount;if(this._geometryInitialized===!1){for(let r in e.attributes){let o=e.getAttribute(r),{array:a,itemSize:l,normalized:c}=o,u=new a.constructor(n*l),h=new mt(u,l,c);t.setAttribute(r,h)}if(e.getIndex()!==null){let r=n>65535?new Uint32Array(s):new Uint16Array(s);t.setIndex(new mt(r,1))}this._geometryInitialized=!0}}_validateGeometry(e){let t=this.geometry;if(!!e.getIndex()!=!!t.getIndex())throw new Error('THREE.BatchedMesh: All geometries must consistently have "index".');for(let n in t.attributes){if(!e.hasAttribute(n))throw new Error(`THREE.BatchedMesh: Added geometry missing "${n}". All geometries must have consistent attributes.`);let s=e.getAttribute(n),r=t.getAttribute(n);if(s.itemSize!==r.itemSize||s.normalized!==r.normalized)throw new Error(`THREE.BatchedMesh: Added geometry attribute "${n}" has an inconsistent itemSize or normalized value.`)}}validateInstanceId(e){let t=this._instanceInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid instanceId ${e}. Instance is either out of range or has been deleted.`)}validateGeometryId(e){let t=this._geometryInfo;if(e<0||e>=t.length||t[e].active===!1)throw new Error(`THREE.BatchedMesh: Invalid geometryId ${e}. Geometry is either out of range or has been deleted.`)}setCustomSort(e){return this.customSort=e,this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tt);let e=this.boundingBox,t=this._instanceInfo;e.makeEmpty();for(let n=0,s=t.length;n<s;n++){if(t[n].active===!1)continue;let r=t[n].geometryIndex;this.getMatrixAt(n,ni),this.getBoundingBoxAt(r,Lu).applyMatrix4(ni),e.union(Lu)}}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vt);let e=this.boundingSphere,t=this._instanceInfo;e.makeEmpty();for(let n=0,s=t.length;n<s;n++){if(t[n].active===!1)continue;let r=t[n].geometryIndex;this.getMatrixAt(n,ni),this.getBoundingSphereAt(r,Vr).applyMatrix4(ni),e.union(Vr)}}addInstance(e){if(this._instanceInfo.length>=this.maxInstanceCount&&this._availableInstanceIds.length===0)throw new Error("THREE.BatchedMesh: Maximum item count reached.");let n={visible:!0,active:!0,geometryIndex:e},s=null;this._availableInstanceIds.length>0?(this._availableInstanceIds.sort(ip),s=this._availableInstanceIds.shift(),this._instanceInfo[s]=n):(s=this._instanceInfo.length,this._instanceInfo.push(n));let r=this._matricesTexture;ni.identity().toArray(r.image.data,s*16),r.needsUpdate=!0;let o=this._colorsTexture;return o&&(Dw.toArray(o.image.data,s*4),o.needsUpdate=!0),this._visibilityChanged=!0,s}addGeometry(e,t=-1,n=-1){this._initializeGeometry(e),this._validateGeometry(e);let s={vertexStart:-1,vertexCount:-1,reservedVertexCount:-1,indexStart:-1,indexCount:-1,reservedIndexCount:-1,start:-1,count:-1,boundingBox:null,boundingSphere:null,active:!0},r=this._geometryInfo;s.vertexStart=this._nextVertexStart,s.reservedVertexCount=t===-1?e.getAttribute("position").count:t;let o=e.getIndex();if(o!==null&&(s.indexStart=this._nextIndexStart,s.reservedIndexCount=n===-1?o.count:n),s.indexStart!==-1&&s.indexStart+s.reservedIndexCount>this._maxIndexCount||s.vertexStart+s.reservedVertexCount>this._maxVertexCount)throw new Error("THREE.BatchedMesh: Reserved space request exceeds the maximum buffer size.");let l;return this._availableGeometryIds.length>0?(this._availableGeometryIds.sort(ip),l=this._availableGeometryIds.shift(),r[l]=s):(l=this._geometryCount,this._geometryCount++,r.push(s)),this.setGeometryAt(l,e),this._nextIndexStart=s.indexStart+s.reservedIndexCount,this._nextVertexStart=s.vertexStart+s.reservedVertexCount,l}setGeometryAt(e,t){if(e>=this._geometryCount)throw new Error("THREE.BatchedMesh: Maximum geometry count reached.");this._validateGeometry(t);let n=this.geometry,s=n.getIndex()!==null,r=n.getIndex(),o=t.getIndex(),a=this._geometryInfo[e];if(s&&o.count>a.reservedIndexCount||t.attributes.position.count>a.reservedVertexCount)throw new Error("THREE.BatchedMesh: Reserved space not large enough for provided geometry.");let l=a.vertexStart,c=a.reservedVertexCount;a.vertexCount=t.getAttribute("position").count;for(let u in n.attributes){let h=t.getAttribute(u),d=n.getAttribute(u);Bw(h,d,l);let f=h.itemSize;for(let g=h.count,x=c;g<x;g++){let m=l+g;for(let _=0;_<f;_++)d.setComponent(m,_,0)}d.needsUpdate=!0,d.addUpdateRange(l*f,c*f)}if(s){let u=a.indexStart,h=a.reservedIndexCount;a.indexCount=t.getIndex().count;for(let d=0;d<o.count;d++)r.setX(u+d,l+o.getX(d));for(let d=o.count,f=h;d<f;d++)r.setX(u+d,l);r.needsUpdate=!0,r.addUpdateRange(u,a.reservedIndexCount)}return a.start=s?a.indexStart:a.vertexStart,a.count=s?a.indexCount:a.vertexCount,a.boundingBox=null,t.boundingBox!==null&&(a.boundingBox=t.boundingBox.clone()),a.boundingSphere=null,t.boundingSphere!==null&&(a.boundingSphere=t.boundingSphere.clone()),this._visibilityChanged=!0,e}deleteGeometry(e){let t=this._geometryInfo;if(e>=t.length||t[e].active===!1)return this;let n=this._instanceInfo;for(let s=0,r=n.length;s<r;s++)n[s].active&&n[s].geometryIndex===e&&this.deleteInstance(s);return t[e].active=!1,this._availableGeometryIds.push(e),this._visibilityChanged=!0,this}deleteInstance(e){return this.validateInstanceId(e),this._instanceInfo[e].active=!1,this._availableInstanceIds.push(e),this._visibilityChanged=!0,this}optimize(){let e=0,t=0,n=this._geometryInfo,s=n.map((o,a)=>a).sort((o,a)=>n[o].vertexStart-n[a].vertexStart),r=this.geometry;for(let o=0,a=n.length;o<a;o++){let l=s[o],c=n[l];if(c.active!==!1){if(r.index!==null){if(c.indexStart!==t){let{indexStart:u,vertexStart:h,reservedIndexCount:d}=c,f=r.index,g=f.array,x=e-h;for(let m=u;m<u+d;m++)g[m]=g[m]+x;f.array.copyWithin(t,u,u+d),f.addUpdateRange(t,d),f.needsUpdate=!0,c.indexStart=t}t+=c.reservedIndexCount}if(c.vertexStart!==e){let{vertexStart:u,reservedVertexCount:h}=c,d=r.attributes;for(let f in d){let g=d[f],{array:x,itemSize:m}=g;x.copyWithin(e*m,u*m,(u+h)*m),g.addUpdateRange(e*m,h*m),g.needsUpdate=!0}c.vertexStart=e}e+=c.reservedVertexCount,c.start=r.index?c.indexStart:c.vertexStart}}return this._nextIndexStart=t,this._nextVertexStart=e,this._visibilityChanged=!0,this}getBoundingBoxAt(e,t){if(e>=this._geometryCount)return null;let n=this.geometry,s=this._geometryInfo[e];if(s.boundingBox===null){let r=new tt,o=n.index,a=n.attributes.position;for(let l=s.start,c=s.start+s.count;l<c;l++){let u=l;o&&(u=o.getX(u)),r.expandByPoint(sp.fromBufferAttribute(a,u))}s.boundingBox=r}return t.copy(s.boundingBox),t}getBoundingSphereAt(e,t){if(e>=this._geometryCount)return null;let n=this.geometry,s=this._geometryInfo[e];if(s.boundingSphere===null){let r=new Vt;this.getBoundingBoxAt(e,Lu),Lu.getCenter(r.center);let o=n.index,a=n.attributes.position,l=0;for(let c=s.start,u=s.start+s.count;c<u;c++){let h=c;o&&(h=o.getX(h)),sp.fromBufferAttribute(a,h),l=Math.max(l,r.center.distanceToSquared(sp))}r.radius=Math.sqrt(l),s.boundingSphere=r}return t.copy(s.boundingSphere),t}setMatrixAt(e,t){this.validateInstanceId(e);let n=this._matricesTexture,s=this._matricesTexture.image.data;return t.toArray(s,e*16),n.needsUpdate=!0,this}getMatrixAt(e,t){return this.validateInstanceId(e),t.fromArray(this._matricesTexture.image.data,e*16)}setColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null&&this._initColorsTexture(),t.toArray(this._colorsTexture.image.data,e*4),this._colorsTexture.needsUpdate=!0,this}getColorAt(e,t){return this.validateInstanceId(e),this._colorsTexture===null?t.isVector4?t.set(1,1,1,1):t.setRGB(1,1,1):t.fromArray(this._colorsTexture.image.data,e*4)}setVisibleAt(e,t){return this.validateInstanceId(e),this._instanceInfo[e].visible===t?this:(this._instanceInfo[e].visible=t,this._visibilityChanged=!0,this)}getVisibleAt(e){return this.validateInstanceId(e),this._instanceInfo[e].visible}setGeometryIdAt(e,t){return this.validateInstanceId(e),this.validateGeometryId(t),this._instanceInfo[e].geometryIndex=t,this._visibilityChanged=!0,this}getGeometryIdAt(e){return this.validateInstanceId(e),this._instanceInfo[e].geometryIndex}getGeometryRangeAt(e,t={}){this.validateGeometryId(e);let n=this._geometryInfo[e];return t.vertexStart=n.vertexStart,t.vertexCount=n.vertexCount,t.reservedVertexCount=n.reservedVertexCount,t.indexStart=n.indexStart,t.indexCount=n.indexCount,t.reservedIndexCount=n.reservedIndexCount,t.start=n.start,t.count=n.count,t}setInstanceCount(e){let t=this._availableInstanceIds,n=this._instanceInfo;for(t.sort(ip);t[t.length-1]===n.length-1;)n.pop(),t.pop();if(e<n.length)throw new Error(`THREE.BatchedMesh: Instance ids outside the range ${e} are being used. Cannot shrink instance count.`);let s=new Int32Array(e),r=new Int32Array(e);Ji(this._multiDrawCounts,s),Ji(this._multiDrawStarts,r),this._multiDrawCounts=s,this._multiDrawStarts=r;let o=new Int32Array(e),a=new Int32Array(e),l=new Int32Array(e);Ji(this._mergedDrawCounts,o),Ji(this._mergedDrawStarts,a),Ji(this._mergedDrawInstanceCounts,l),this._mergedDrawCounts=o,this._mergedDrawStarts=a,this._mergedDrawInstanceCounts=l,this._maxInstanceCount=e;let c=this._indirectTexture,u=this._matricesTexture,h=this._colorsTexture;c.dispose(),this._initIndirectTexture(),Ji(c.image.data,this._indirectTexture.image.data),u.dispose(),this._initMatricesTexture(),Ji(u.image.data,this._matricesTexture.image.data),h&&(h.dispose(),this._initColorsTexture(),Ji(h.image.data,this._colorsTexture.image.data)),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}setGeometrySize(e,t){let n=[...this._geometryInfo].filter(a=>a.active);if(Math.max(...n.map(a=>a.vertexStart+a.reservedVertexCount))>e)throw new Error(`THREE.BatchedMesh: Geometry vertex values are being used outside the range ${e}. Cannot shrink further.`);if(this.geometry.index&&Math.max(...n.map(l=>l.indexStart+l.reservedIndexCount))>t)throw new Error(`THREE.BatchedMesh: Geometry index values are being used outside the range ${t}. Cannot shrink further.`);let r=this.geometry;r.dispose(),this._maxVertexCount=e,this._maxIndexCount=t,this._geometryInitialized&&(this._geometryInitialized=!1,this.geometry=new Kt,this._initializeGeometry(r));let o=this.geometry;r.index&&Ji(r.index.array,o.index.array);for(let a in r.attributes)Ji(r.attributes[a].array,o.attributes[a].array);this._visibilityChanged=!0}raycast(e,t){let n=this._instanceInfo,s=this._geometryInfo,r=this.matrixWorld,o=this.geometry;Bn.material=this.material,Bn.geometry.index=o.index,Bn.geometry.attributes=o.attributes,Bn.geometry.boundingBox===null&&(Bn.geometry.boundingBox=new tt),Bn.geometry.boundingSphere===null&&(Bn.geometry.boundingSphere=new Vt);for(let a=0,l=n.length;a<l;a++){if(!n[a].visible||!n[a].active)continue;let c=n[a].geometryIndex,u=s[c];Bn.geometry.setDrawRange(u.start,u.count),this.getMatrixAt(a,Bn.matrixWorld).premultiply(r),this.getBoundingBoxAt(c,Bn.geometry.boundingBox),this.getBoundingSphereAt(c,Bn.geometry.boundingSphere),Bn.raycast(e,Ou);for(let h=0,d=Ou.length;h<d;h++){let f=Ou[h];f.object=this,f.batchId=a,t.push(f)}Ou.length=0}Bn.material=null,Bn.geometry.index=null,Bn.geometry.attributes={},Bn.geometry.setDrawRange(0,1/0)}copy(e){return super.copy(e),this.geometry=e.geometry.clone(),this.perObjectFrustumCulled=e.perObjectFrustumCulled,this.sortObjects=e.sortObjects,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this._geometryInfo=e._geometryInfo.map(t=>({...t,boundingBox:t.boundingBox!==null?t.boundingBox.clone():null,boundingSphere:t.boundingSphere!==null?t.boundingSphere.clone():null})),this._instanceInfo=e._instanceInfo.map(t=>({...t})),this._availableInstanceIds=e._availableInstanceIds.slice(),this._availableGeometryIds=e._availableGeometryIds.slice(),this._nextIndexStart=e._nextIndexStart,this._nextVertexStart=e._nextVertexStart,this._geometryCount=e._geometryCount,this._maxInstanceCount=e._maxInstanceCount,this._maxVertexCount=e._maxVertexCount,this._maxIndexCount=e._maxIndexCount,this._geometryInitialized=e._geometryInitialized,this._multiDrawCounts=e._multiDrawCounts.slice(),this._multiDrawStarts=e._multiDrawStarts.slice(),this._multiDrawBytesPerElement=e._multiDrawBytesPerElement,this._mergedDrawCounts=e._mergedDrawCounts.slice(),this._mergedDrawStarts=e._mergedDrawStarts.slice(),this._mergedDrawInstanceCounts=e._mergedDrawInstanceCounts.slice(),this._indirectTexture=e._indirectTexture.clone(),this._indirectTexture.image.data=this._indirectTexture.image.data.slice(),this._matricesTexture=e._matricesTexture.clone(),this._matricesTexture.image.data=this._matricesTexture.image.data.slice(),e._colorsTexture!==null?(this._colorsTexture=e._colorsTexture.clone(),this._colorsTexture.image.data=this._colorsTexture.image.data.slice()):this._colorsTexture=null,this}dispose(){super.dispose(),this.geometry.dispose(),this._matricesTexture.dispose(),this._matricesTexture=null,this._indirectTexture.dispose(),this._indirectTexture=null,this._colorsTexture!==null&&(this._colorsTexture.dispose(),this._colorsTexture=null),this._previousMatricesTexture!==null&&(this._previousMatricesTexture.dispose(),this._previousMatricesTexture=null)}_updateDrawParameters(e,t,n,s="multiDraw"){if(!this._visibilityChanged&&!this.perObjectFrustumCulled&&!this.sortObjects)return;let r=t.getIndex(),o=r===null?1:r.array.BYTES_PER_ELEMENT,a=1;n.wireframe&&(a=2,o=t.attributes.position.count>65535?4:2);let l=this._instanceInfo,c=this._multiDrawStarts,u=this._multiDrawCounts,h=this._mergedDrawStarts,d=this._mergedDrawCounts,f=this._mergedDrawInstanceCounts,g=this._geometryInfo,x=this.perObjectFrustumCulled,m=this._indirectTexture,_=m.image.data,v=e.isArrayCamera?Fw:Uw;x&&(e.isArrayCamera?v.setFromArrayCamera(e):(ni.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse).multiply(this.matrixWorld),v.setFromProjectionMatrix(ni,e.coordinateSystem,e.reversedDepth)));let M=0,b=0;if(this.sortObjects){ni.copy(this.matrixWorld).invert(),y_.setFromMatrixPosition(e.matrixWorld).applyMatrix4(ni),x_.set(0,0,-1).transformDirection(e.matrixWorld).transformDirection(ni);for(let p=0,w=l.length;p<w;p++)if(l[p].visible&&l[p].active){let T=l[p].geometryIndex;this.getMatrixAt(p,ni),this.getBoundingSphereAt(T,Vr).applyMatrix4(ni);let E=!1;if(x&&(E=!v.intersectsSphere(Vr)),!E){let C=g[T],O=kw.subVectors(Vr.center,y_).dot(x_);rp.push(C.start,C.count,O,p)}}let S=rp.list,y=this.customSort;y===null?S.sort(n.transparent?Nw:Ow):y.call(this,S,e);for(let p=0,w=S.length;p<w;p++){let T=S[p],E=T.start*o*a,C=T.count*a;s==="merged"?b>0&&h[b-1]===E&&d[b-1]===C?f[b-1]++:(h[b]=E,d[b]=C,f[b]=1,b++):(c[M]=E,u[M]=C),_[M]=T.index,M++}rp.reset()}else for(let S=0,y=l.length;S<y;S++)if(l[S].visible&&l[S].active){let p=l[S].geometryIndex,w=!1;if(x&&(this.getMatrixAt(S,ni),this.getBoundingSphereAt(p,Vr).applyMatrix4(ni),w=!v.intersectsSphere(Vr)),!w){let T=g[p],E=T.start*o*a,C=T.count*a;s==="merged"?b>0&&h[b-1]===E&&d[b-1]===C?f[b-1]++:(h[b]=E,d[b]=C,f[b]=1,b++):(c[M]=E,u[M]=C),_[M]=S,M++}}m.needsUpdate=!0,this._multiDrawCount=M,this._mergedDrawCount=b,this._multiDrawBytesPerElement=o,this._visibilityChanged=!1}onBeforeRender(e,t,n,s,r){e.isWebGPURenderer===!0?(this._visibilityChanged||this.perObjectFrustumCulled||this.sortObjects)&&(this._indirectTexture.needsUpdate=!0):this._updateDrawParameters(n,s,r)}onBeforeShadow(e,t,n,s,r,o){e.isWebGPURenderer!==!0&&this._updateDrawParameters(s,r,o)}},cr=class extends jn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ue(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Qu=new P,eh=new P,v_=new Ce,dl=new ts,Nu=new Vt,op=new P,b_=new P,ns=class extends Qt{constructor(e=new Kt,t=new cr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Qu.fromBufferAttribute(t,s-1),eh.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Qu.distanceTo(eh);e.setAttribute("lineDistance",new fn(n,1))}else Fe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Nu.copy(n.boundingSphere),Nu.applyMatrix4(s),Nu.radius+=r,e.ray.intersectsSphere(Nu)===!1)return;v_.copy(s).invert(),dl.copy(e.ray).applyMatrix4(v_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,d=n.attributes.position;if(u!==null){let f=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let x=f,m=g-1;x<m;x+=c){let _=u.getX(x),v=u.getX(x+1),M=Du(this,e,dl,l,_,v,x);M&&t.push(M)}if(this.isLineLoop){let x=u.getX(g-1),m=u.getX(f),_=Du(this,e,dl,l,x,m,g-1);_&&t.push(_)}}else{let f=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let x=f,m=g-1;x<m;x+=c){let _=Du(this,e,dl,l,x,x+1,x);_&&t.push(_)}if(this.isLineLoop){let x=Du(this,e,dl,l,g-1,f,g-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Du(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Qu.fromBufferAttribute(a,s),eh.fromBufferAttribute(a,r),t.distanceSqToSegment(Qu,eh,op,b_)>n)return;op.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(op);if(!(c<e.near||c>e.far))return{distance:c,point:b_.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var S_=new P,w_=new P,is=class extends ns{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)S_.fromBufferAttribute(t,s),w_.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+S_.distanceTo(w_);e.setAttribute("lineDistance",new fn(n,1))}else Fe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},ur=class extends ns{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},qo=class extends jn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Ue(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},M_=new Ce,gp=new ts,Uu=new Vt,Fu=new P,Bi=class extends Qt{constructor(e=new Kt,t=new qo){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Uu.copy(n.boundingSphere),Uu.applyMatrix4(s),Uu.radius+=r,e.ray.intersectsSphere(Uu)===!1)return;M_.copy(s).invert(),gp.copy(e.ray).applyMatrix4(M_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let g=d,x=f;g<x;g++){let m=c.getX(g);Fu.fromBufferAttribute(h,m),E_(Fu,m,l,s,e,t,this)}}else{let d=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let g=d,x=f;g<x;g++)Fu.fromBufferAttribute(h,g),E_(Fu,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function E_(i,e,t,n,s,r,o){let a=gp.distanceSqToPoint(i);if(a<t){let l=new P;gp.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Al=class extends wn{constructor(e=[],t=jr,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var zs=class extends wn{constructor(e,t,n=Ri,s,r,o,a=on,l=on,c,u=Fs,h=1){if(u!==Fs&&u!==$s)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ho(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Rl=class extends zs{constructor(e,t=Ri,n=jr,s,r,o=on,a=on,l,c=Fs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Cl=class extends wn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Yo=class i extends Kt{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new fn(c,3)),this.setAttribute("normal",new fn(u,3)),this.setAttribute("uv",new fn(h,2));function g(x,m,_,v,M,b,S,y,p,w,T){let E=b/p,C=S/w,O=b/2,U=S/2,I=y/2,D=p+1,V=w+1,F=0,ie=0,z=new P;for(let q=0;q<V;q++){let W=q*C-U;for(let _e=0;_e<D;_e++){let Te=_e*E-O;z[x]=Te*v,z[m]=W*M,z[_]=I,c.push(z.x,z.y,z.z),z[x]=0,z[m]=0,z[_]=y>0?1:-1,u.push(z.x,z.y,z.z),h.push(_e/p),h.push(1-q/w),F+=1}}for(let q=0;q<w;q++)for(let W=0;W<p;W++){let _e=d+W+D*q,Te=d+W+D*(q+1),K=d+(W+1)+D*(q+1),ae=d+(W+1)+D*q;l.push(_e,Te,ae),l.push(Te,K,ae),ie+=6}a.addGroup(f,ie,T),f+=ie,d+=F}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ss=class i extends Kt{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],g=[],x=[],m=[];for(let _=0;_<u;_++){let v=_*d-o;for(let M=0;M<c;M++){let b=M*h-r;g.push(b,-v,0),x.push(0,0,1),m.push(M/a),m.push(1-_/l)}}for(let _=0;_<l;_++)for(let v=0;v<a;v++){let M=v+c*_,b=v+c*(_+1),S=v+1+c*(_+1),y=v+1+c*_;f.push(M,b,y),f.push(b,S,y)}this.setIndex(f),this.setAttribute("position",new fn(g,3)),this.setAttribute("normal",new fn(x,3)),this.setAttribute("uv",new fn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Pl=class extends Kt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new P,r=new P;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let h=l[c],d=h.start,f=h.count;for(let g=d,x=d+f;g<x;g+=3)for(let m=0;m<3;m++){let _=a.getX(g+m),v=a.getX(g+(m+1)%3);s.fromBufferAttribute(o,_),r.fromBufferAttribute(o,v),T_(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,h=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,h),T_(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new fn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function T_(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}function eo(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(A_(s))s.isRenderTargetTexture?(Fe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(A_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Hn(i){let e={};for(let t=0;t<i.length;t++){let n=eo(i[t]);for(let s in n)e[s]=n[s]}return e}function A_(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function zw(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Qp(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:st.workingColorSpace}var Ql={clone:eo,merge:Hn},Vw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Hw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,mn=class extends jn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Vw,this.fragmentShader=Hw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=eo(e.uniforms),this.uniformsGroups=zw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ue().setHex(s.value);break;case"v2":this.uniforms[n].value=new ke().fromArray(s.value);break;case"v3":this.uniforms[n].value=new P().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ct().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Je().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ce().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},th=class extends mn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Vs=class extends jn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ue(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zl,this.normalScale=new ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new es,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Zn=class extends Vs{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new ke(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return je(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new Ue(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new Ue(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new Ue(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Hr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Hr('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}};var Il=class extends jn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ue(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ue(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zl,this.normalScale=new ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new es,this.combine=dh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},nh=class extends jn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=uy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ih=class extends jn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ar(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function fl(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function Gw(i){function e(s,r){return i[s]-i[r]}let t=i.length,n=new Array(t);for(let s=0;s!==t;++s)n[s]=s;return n.sort(e),n}function R_(i,e,t){let n=i.length,s=new i.constructor(n);for(let r=0,o=0;o!==n;++r){let a=t[r]*e;for(let l=0;l!==e;++l)s[o++]=i[a+l]}return s}function Ww(i,e,t,n){let s=1,r=i[0];for(;r!==void 0&&r[n]===void 0;)r=i[s++];if(r===void 0)return;let o=r[n];if(o!==void 0)if(Array.isArray(o))do o=r[n],o!==void 0&&(e.push(r.time),t.push(...o)),r=i[s++];while(r!==void 0);else if(o.toArray!==void 0)do o=r[n],o!==void 0&&(e.push(r.time),o.toArray(t,t.length)),r=i[s++];while(r!==void 0);else do o=r[n],o!==void 0&&(e.push(r.time),t.push(o)),r=i[s++];while(r!==void 0)}var rs=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},sh=class extends rs{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:dp,endingEnd:dp}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case fp:r=e,a=2*t-n;break;case pp:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case fp:o=e,l=2*n-t;break;case pp:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),x=g*g,m=x*g,_=-d*m+2*d*x-d*g,v=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*g+1,M=(-1-f)*m+(1.5+f)*x+.5*g,b=f*m-f*x;for(let S=0;S!==a;++S)r[S]=_*o[u+S]+v*o[c+S]+M*o[l+S]+b*o[h+S];return r}},rh=class extends rs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},oh=class extends rs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ah=class extends rs{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(n-t)/(s-t),x=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let x=o[c+g],m=o[l+g],_=f*d+g*2,v=h[_],M=h[_+1],b=e*d+g*2,S=u[b],y=u[b+1],p=qw(n,t,v,S,s);r[g]=wy(p,x,M,y,m)}return r}};function wy(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Xw(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function qw(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=wy(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Xw(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ri=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ar(t,this.TimeBufferType),this.values=ar(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:ar(e.times,Array),values:ar(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),fl(e.settings)&&(n.settings={inTangents:ar(e.settings.inTangents,Array),outTangents:ar(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new oh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new rh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new sh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ah(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Gr:t=this.InterpolantFactoryMethodDiscrete;break;case Wr:t=this.InterpolantFactoryMethodLinear;break;case Vu:t=this.InterpolantFactoryMethodSmooth;break;case hp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Fe("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Gr;case this.InterpolantFactoryMethodLinear:return Wr;case this.InterpolantFactoryMethodSmooth:return Vu;case this.InterpolantFactoryMethodBezier:return hp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;fl(this.settings)&&(C_(this.settings.inTangents,e),C_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;fl(this.settings)&&(P_(this.settings.inTangents,e),P_(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&JS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Vu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,d=h-n,f=h+n;for(let g=0;g!==n;++g){let x=t[h+g];if(x!==t[d+g]||x!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,fl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function C_(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function P_(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ri.prototype.ValueTypeName="";ri.prototype.TimeBufferType=Float32Array;ri.prototype.ValueBufferType=Float32Array;ri.prototype.DefaultInterpolation=Wr;var Hs=class extends ri{constructor(e,t,n){super(e,t,n)}};Hs.prototype.ValueTypeName="bool";Hs.prototype.ValueBufferType=Array;Hs.prototype.DefaultInterpolation=Gr;Hs.prototype.InterpolantFactoryMethodLinear=void 0;Hs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ll=class extends ri{constructor(e,t,n,s){super(e,t,n,s)}};Ll.prototype.ValueTypeName="color";var Gs=class extends ri{constructor(e,t,n,s){super(e,t,n,s)}};Gs.prototype.ValueTypeName="number";var lh=class extends rs{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Jn.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ws=class extends ri{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new lh(this.times,this.values,this.getValueSize(),e)}};Ws.prototype.ValueTypeName="quaternion";Ws.prototype.InterpolantFactoryMethodSmooth=void 0;var Xs=class extends ri{constructor(e,t,n){super(e,t,n)}};Xs.prototype.ValueTypeName="string";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=Gr;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var hr=class extends ri{constructor(e,t,n,s){super(e,t,n,s)}};hr.prototype.ValueTypeName="vector";var Ol=class{constructor(e="",t=-1,n=[],s=cy){this.name=e,this.tracks=n,this.duration=t,this.blendMode=s,this.uuid=cs(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,s=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push($w(n[o]).scale(s));let r=new this(e.name,e.duration,t,e.blendMode);return r.uuid=e.uuid,r.userData=JSON.parse(e.userData||"{}"),r}static toJSON(e){let t=[],n=e.tracks,s={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let r=0,o=n.length;r!==o;++r)t.push(ri.toJSON(n[r]));return s}static CreateFromMorphTargetSequence(e,t,n,s){let r=t.length,o=[];for(let a=0;a<r;a++){let l=[],c=[];l.push((a+r-1)%r,a,(a+1)%r),c.push(0,1,0);let u=Gw(l);l=R_(l,1,u),c=R_(c,1,u),!s&&l[0]===0&&(l.push(r),c.push(c[0])),o.push(new Gs(".morphTargetInfluences["+t[a].name+"]",l,c).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let s=e;n=s.geometry&&s.geometry.animations||s.animations}for(let s=0;s<n.length;s++)if(n[s].name===t)return n[s];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let s={},r=/^([\w-]*?)([\d]+)$/;for(let a=0,l=e.length;a<l;a++){let c=e[a],u=c.name.match(r);if(u&&u.length>1){let h=u[1],d=s[h];d||(s[h]=d=[]),d.push(c)}}let o=[];for(let a in s)o.push(this.CreateFromMorphTargetSequence(a,s[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,s=e.length;n!==s;++n){let r=this.tracks[n];t=Math.max(t,r.times[r.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function Yw(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return Gs;case"vector":case"vector2":case"vector3":case"vector4":return hr;case"color":return Ll;case"quaternion":return Ws;case"bool":case"boolean":return Hs;case"string":return Xs}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function $w(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=Yw(i.type);if(i.times===void 0){let n=[],s=[];Ww(i.keys,n,s,"value"),i.times=n,i.values=s}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),fl(i.settings)&&(t.settings={inTangents:ar(i.settings.inTangents,Float32Array),outTangents:ar(i.settings.outTangents,Float32Array)}),t}var Zi={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(I_(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!I_(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function I_(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var ch=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],g=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},My=new ch,os=class{constructor(e){this.manager=e!==void 0?e:My,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};os.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ns={},_p=class extends Error{constructor(e,t){super(e),this.response=t}},$o=class extends os{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=Zi.get(`file:${e}`);if(r!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(r),this.manager.itemEnd(e)},0);return}if(Ns[e]!==void 0){Ns[e].push({onLoad:t,onProgress:n,onError:s});return}Ns[e]=[],Ns[e].push({onLoad:t,onProgress:n,onError:s});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&Fe("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Ns[e],h=c.body.getReader(),d=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),f=d?parseInt(d):0,g=f!==0,x=0,m=new ReadableStream({start(_){v();function v(){h.read().then(({done:M,value:b})=>{if(M)_.close();else{x+=b.byteLength;let S=new ProgressEvent("progress",{lengthComputable:g,loaded:x,total:f});for(let y=0,p=u.length;y<p;y++){let w=u[y];w.onProgress&&w.onProgress(S)}_.enqueue(b),v()}},M=>{_.error(M)})}}});return new Response(m)}else throw new _p(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),d=h&&h[1]?h[1].toLowerCase():void 0,f=new TextDecoder(d);return c.arrayBuffer().then(g=>f.decode(g))}}}).then(c=>{Zi.add(`file:${e}`,c);let u=Ns[e];delete Ns[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onLoad&&f.onLoad(c)}}).catch(c=>{let u=Ns[e];if(u===void 0)throw this.manager.itemError(e),c;delete Ns[e];for(let h=0,d=u.length;h<d;h++){let f=u[h];f.onError&&f.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Io=new WeakMap,uh=class extends os{constructor(e){super(e)}load(e,t,n,s){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=Zi.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)r.manager.itemStart(e),setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);else{let h=Io.get(o);h===void 0&&(h=[],Io.set(o,h)),h.push({onLoad:t,onError:s})}return o}let a=zo("img");function l(){u(),t&&t(this);let h=Io.get(this)||[];for(let d=0;d<h.length;d++){let f=h[d];f.onLoad&&f.onLoad(this)}Io.delete(this),r.manager.itemEnd(e)}function c(h){u(),s&&s(h),Zi.remove(`image:${e}`);let d=Io.get(this)||[];for(let f=0;f<d.length;f++){let g=d[f];g.onError&&g.onError(h)}Io.delete(this),r.manager.itemError(e),r.manager.itemEnd(e)}function u(){a.removeEventListener("load",l,!1),a.removeEventListener("error",c,!1)}return a.addEventListener("load",l,!1),a.addEventListener("error",c,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),Zi.add(`image:${e}`,a),r.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var Nl=class extends os{constructor(e){super(e)}load(e,t,n,s){let r=new wn,o=new uh(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){r.image=a,r.needsUpdate=!0,t!==void 0&&t(r)},n,s),r}},Yr=class extends Qt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ue(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var ap=new Ce,L_=new P,O_=new P,Ko=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ke(512,512),this.mapType=oi,this.map=null,this.mapPass=null,this.matrix=new Ce,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Bs,this._frameExtents=new ke(1,1),this._viewportCount=1,this._viewports=[new ct(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;L_.setFromMatrixPosition(e.matrixWorld),t.position.copy(L_),O_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(O_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){ap.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(ap,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Bo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(ap)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ku=new P,Bu=new Jn,ji=new P,Dl=class extends Qt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ce,this.projectionMatrix=new Ce,this.projectionMatrixInverse=new Ce,this.coordinateSystem=Ei,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ku,Bu,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ku,Bu,ji.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ku,Bu,ji),ji.x===1&&ji.y===1&&ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ku,Bu,ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},or=new P,N_=new ke,D_=new ke,dn=class extends Dl{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Xr*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(pl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Xr*2*Math.atan(Math.tan(pl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){or.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(or.x,or.y).multiplyScalar(-e/or.z),or.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(or.x,or.y).multiplyScalar(-e/or.z)}getViewSize(e,t){return this.getViewBounds(e,N_,D_),t.subVectors(D_,N_)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(pl*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},yp=class extends Ko{constructor(){super(new dn(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=Xr*2*e.angle*this.focus,s=this.mapSize.width/this.mapSize.height*this.aspect,r=e.distance||t.far;(n!==t.fov||s!==t.aspect||r!==t.far)&&(t.fov=n,t.aspect=s,t.far=r,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},Ul=class extends Yr{constructor(e,t,n=0,s=Math.PI/3,r=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.distance=n,this.angle=s,this.penumbra=r,this.decay=o,this.map=null,this.shadow=new yp}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},xp=class extends Ko{constructor(){super(new dn(90,1,.5,500)),this.isPointLightShadow=!0}},Fl=class extends Yr{constructor(e,t,n=0,s=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=s,this.shadow=new xp}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},qs=class extends Dl{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},vp=class extends Ko{constructor(){super(new qs(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},$r=class extends Yr{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Qt.DEFAULT_UP),this.updateMatrix(),this.target=new Qt,this.shadow=new vp}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Kr=class{constructor(){this.isSphericalHarmonics3=!0,this.coefficients=[];for(let e=0;e<9;e++)this.coefficients.push(new P)}set(e){for(let t=0;t<9;t++)this.coefficients[t].copy(e[t]);return this}zero(){for(let e=0;e<9;e++)this.coefficients[e].set(0,0,0);return this}getAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.282095),t.addScaledVector(o[1],.488603*s),t.addScaledVector(o[2],.488603*r),t.addScaledVector(o[3],.488603*n),t.addScaledVector(o[4],1.092548*(n*s)),t.addScaledVector(o[5],1.092548*(s*r)),t.addScaledVector(o[6],.315392*(3*r*r-1)),t.addScaledVector(o[7],1.092548*(n*r)),t.addScaledVector(o[8],.546274*(n*n-s*s)),t}getIrradianceAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.886227),t.addScaledVector(o[1],2*.511664*s),t.addScaledVector(o[2],2*.511664*r),t.addScaledVector(o[3],2*.511664*n),t.addScaledVector(o[4],2*.429043*n*s),t.addScaledVector(o[5],2*.429043*s*r),t.addScaledVector(o[6],.743125*r*r-.247708),t.addScaledVector(o[7],2*.429043*n*r),t.addScaledVector(o[8],.429043*(n*n-s*s)),t}add(e){for(let t=0;t<9;t++)this.coefficients[t].add(e.coefficients[t]);return this}addScaledSH(e,t){for(let n=0;n<9;n++)this.coefficients[n].addScaledVector(e.coefficients[n],t);return this}scale(e){for(let t=0;t<9;t++)this.coefficients[t].multiplyScalar(e);return this}lerp(e,t){for(let n=0;n<9;n++)this.coefficients[n].lerp(e.coefficients[n],t);return this}equals(e){for(let t=0;t<9;t++)if(!this.coefficients[t].equals(e.coefficients[t]))return!1;return!0}copy(e){return this.set(e.coefficients)}clone(){return new this.constructor().copy(this)}fromArray(e,t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].fromArray(e,t+s*3);return this}toArray(e=[],t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].toArray(e,t+s*3);return e}static getBasisAt(e,t){let n=e.x,s=e.y,r=e.z;t[0]=.282095,t[1]=.488603*s,t[2]=.488603*r,t[3]=.488603*n,t[4]=1.092548*n*s,t[5]=1.092548*s*r,t[6]=.315392*(3*r*r-1),t[7]=1.092548*n*r,t[8]=.546274*(n*n-s*s)}},kl=class extends Yr{constructor(e=new Kr,t=1){super(void 0,t),this.isLightProbe=!0,this.type="LightProbe",this.sh=e}copy(e){return super.copy(e),this.sh.copy(e.sh),this}toJSON(e){let t=super.toJSON(e);return t.object.sh=this.sh.toArray(),t}};var Ys=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}},Bl=class extends Kt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var lp=new WeakMap,zl=class extends os{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&Fe("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&Fe("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,s){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let r=this,o=Zi.get(`image-bitmap:${e}`);if(o!==void 0){if(r.manager.itemStart(e),o.then){o.then(c=>{lp.has(o)===!0?(s&&s(lp.get(o)),r.manager.itemError(e),r.manager.itemEnd(e)):(t&&t(c),r.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),r.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let l=fetch(e,a).then(function(c){return c.blob()}).then(function(c){return createImageBitmap(c,Object.assign({},r.options,{colorSpaceConversion:"none"}))}).then(function(c){return Zi.add(`image-bitmap:${e}`,c),t&&t(c),r.manager.itemEnd(e),c}).catch(function(c){s&&s(c),lp.set(l,c),Zi.remove(`image-bitmap:${e}`),r.manager.itemError(e),r.manager.itemEnd(e)});Zi.add(`image-bitmap:${e}`,l),r.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Lo=-90,Oo=1,Jo=class extends Qt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new dn(Lo,Oo,e,t);s.layers=this.layers,this.add(s);let r=new dn(Lo,Oo,e,t);r.layers=this.layers,this.add(r);let o=new dn(Lo,Oo,e,t);o.layers=this.layers,this.add(o);let a=new dn(Lo,Oo,e,t);a.layers=this.layers,this.add(a);let l=new dn(Lo,Oo,e,t);l.layers=this.layers,this.add(l);let c=new dn(Lo,Oo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ei)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Bo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=x,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},hh=class extends dn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var em="\\[\\]\\.:\\/",Kw=new RegExp("["+em+"]","g"),tm="[^"+em+"]",Jw="[^"+em.replace("\\.","")+"]",jw=/((?:WC+[\/:])*)/.source.replace("WC",tm),Zw=/(WCOD+)?/.source.replace("WCOD",Jw),Qw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tm),eM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tm),tM=new RegExp("^"+jw+Zw+Qw+eM+"$"),nM=["material","materials","bones","map"],bp=class{constructor(e,t,n){let s=n||zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Kw,"")}static parseTrackName(e){let t=tM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);nM.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Fe("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};zt.Composite=bp;zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};zt.prototype.GetterByBindingType=[zt.prototype._getValue_direct,zt.prototype._getValue_array,zt.prototype._getValue_arrayElement,zt.prototype._getValue_toArray];zt.prototype.SetterByBindingTypeAndVersioning=[[zt.prototype._setValue_direct,zt.prototype._setValue_direct_setNeedsUpdate,zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_array,zt.prototype._setValue_array_setNeedsUpdate,zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_arrayElement,zt.prototype._setValue_arrayElement_setNeedsUpdate,zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[zt.prototype._setValue_fromArray,zt.prototype._setValue_fromArray_setNeedsUpdate,zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var v3=new Float32Array(1);var dr=class extends qr{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var U_=new Ce,fr=class{constructor(e,t,n=0,s=1/0){this.ray=new ts(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new Go,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):qe("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return U_.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(U_),this}intersectObject(e,t=!0,n=[]){return Sp(e,this,n,t),n.sort(F_),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Sp(e[s],this,n,t);return n.sort(F_),n}};function F_(i,e){return i.distance-e.distance}function Sp(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Sp(r[o],e,t,!0)}}var Vl=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=je(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(je(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var wp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var k_=new P,zu=new P,No=new P,Do=new P,cp=new P,iM=new P,sM=new P,Tn=class{constructor(e=new P,t=new P){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){k_.subVectors(e,this.start),zu.subVectors(this.end,this.start);let n=zu.dot(zu);if(n===0)return 0;let r=zu.dot(k_)/n;return t&&(r=je(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=iM,n=sM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;No.subVectors(c,a),Do.subVectors(u,l),cp.subVectors(a,l);let h=No.dot(No),d=Do.dot(Do),f=Do.dot(cp);if(h<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(h<=s)r=0,o=f/d,o=je(o,0,1);else{let g=No.dot(cp);if(d<=s)o=0,r=je(-g/h,0,1);else{let x=No.dot(Do),m=h*d-x*x;m!==0?r=je((x*f-g*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=je(-g/h,0,1)):o>1&&(o=1,r=je((x-g)/h,0,1))}}return t.copy(a).addScaledVector(No,r),n.copy(l).addScaledVector(Do,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function nm(i,e,t,n){let s=rM(n);switch(t){case Vp:return i*e;case xh:return i*e/s.components*s.byteLength;case Wl:return i*e/s.components*s.byteLength;case pr:return i*e*2/s.components*s.byteLength;case vh:return i*e*2/s.components*s.byteLength;case Hp:return i*e*3/s.components*s.byteLength;case ii:return i*e*4/s.components*s.byteLength;case bh:return i*e*4/s.components*s.byteLength;case Xl:case ql:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Yl:case $l:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case wh:case Eh:return Math.max(i,16)*Math.max(e,8)/4;case Sh:case Mh:return Math.max(i,8)*Math.max(e,8)/2;case Th:case Ah:case Ch:case Ph:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Rh:case Kl:case Ih:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Lh:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Oh:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Nh:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Dh:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Uh:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Fh:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case kh:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Bh:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case zh:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Vh:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Hh:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Gh:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Wh:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Xh:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case qh:case Yh:case $h:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Kh:case Jh:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Jl:case jh:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function rM(i){switch(i){case oi:case Fp:return{byteLength:1,components:1};case ta:case kp:case zi:return{byteLength:2,components:1};case _h:case yh:return{byteLength:2,components:4};case Ri:case gh:case $n:return{byteLength:4,components:1};case Bp:case zp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Fe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function qy(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function oM(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],x=h[f];x.start<=g.start+g.count+1?g.count=Math.max(g.count,x.start+x.count-g.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let x=h[f];i.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var aM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,lM=`#ifdef USE_ALPHAHASH
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
#endif`,cM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,uM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,hM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,dM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,fM=`#ifdef USE_AOMAP
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
#endif`,pM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,mM=`#ifdef USE_BATCHING
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
#endif`,gM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,_M=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,yM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,xM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,vM=`#ifdef USE_IRIDESCENCE
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
#endif`,bM=`#ifdef USE_BUMPMAP
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
#endif`,SM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,wM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,MM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,EM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,TM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,AM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,RM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,CM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,PM=`#define PI 3.141592653589793
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
} // validated`,IM=`vec3 transformedNormal = objectNormal;
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
#endif`,LM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,OM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,NM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,DM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,UM="gl_FragColor = linearToOutputTexel( gl_FragColor );",FM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,kM=`#ifdef USE_ENVMAP
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
#endif`,BM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,zM=`#ifdef USE_ENVMAP
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
#endif`,VM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,HM=`#ifdef USE_ENVMAP
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
#endif`,GM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,WM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,XM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,qM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,YM=`#ifdef USE_GRADIENTMAP
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
}`,$M=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,KM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,JM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,jM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,ZM=`#ifdef USE_ENVMAP
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
#endif`,QM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,eE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,tE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,nE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,iE=`PhysicalMaterial material;
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
#endif`,sE=`uniform sampler2D dfgLUT;
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
}`,rE=`
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
#endif`,oE=`#if defined( RE_IndirectDiffuse )
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
#endif`,aE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,lE=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,cE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,uE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,hE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,dE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,fE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,pE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,mE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,gE=`#if defined( USE_POINTS_UV )
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
#endif`,_E=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,yE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,xE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,vE=`#if defined( USE_MORPHCOLORS )
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
#endif`,bE=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,SE=`#ifdef USE_MORPHTARGETS
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
#endif`,wE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ME=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,EE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,TE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,AE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,RE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,CE=`#ifdef USE_NORMALMAP
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
#endif`,PE=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,IE=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,LE=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,OE=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,NE=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,DE=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,UE=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,FE=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,kE=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,BE=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,zE=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,VE=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,HE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,GE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,WE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,XE=`float getShadowMask() {
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
}`,qE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,YE=`#ifdef USE_SKINNING
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
#endif`,$E=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,KE=`#ifdef USE_SKINNING
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
#endif`,JE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,jE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ZE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,QE=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,eT=`#ifdef USE_TRANSMISSION
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
#endif`,tT=`#ifdef USE_TRANSMISSION
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
#endif`,nT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,iT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,oT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,aT=`uniform sampler2D t2D;
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
}`,lT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,cT=`uniform float backgroundBlurriness;
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
}`,uT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,hT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,dT=`#include <common>
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
}`,fT=`#if DEPTH_PACKING == 3200
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
}`,pT=`#define DISTANCE
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
}`,mT=`#define DISTANCE
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
}`,gT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,_T=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yT=`uniform float scale;
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
}`,xT=`uniform vec3 diffuse;
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
}`,vT=`#include <common>
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
}`,bT=`uniform vec3 diffuse;
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
}`,ST=`#define LAMBERT
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
}`,wT=`#define LAMBERT
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
}`,MT=`#define MATCAP
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
}`,ET=`#define MATCAP
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
}`,TT=`#define NORMAL
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
}`,AT=`#define NORMAL
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
}`,RT=`#define PHONG
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
}`,CT=`#define PHONG
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
}`,PT=`#define STANDARD
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
}`,IT=`#define STANDARD
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
}`,LT=`#define TOON
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
}`,OT=`#define TOON
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
}`,NT=`uniform float size;
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
}`,DT=`uniform vec3 diffuse;
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
}`,UT=`#include <common>
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
}`,FT=`uniform vec3 color;
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
}`,kT=`uniform float rotation;
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
}`,BT=`uniform vec3 diffuse;
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
}`,rt={alphahash_fragment:aM,alphahash_pars_fragment:lM,alphamap_fragment:cM,alphamap_pars_fragment:uM,alphatest_fragment:hM,alphatest_pars_fragment:dM,aomap_fragment:fM,aomap_pars_fragment:pM,batching_pars_vertex:mM,batching_vertex:gM,begin_vertex:_M,beginnormal_vertex:yM,bsdfs:xM,iridescence_fragment:vM,bumpmap_pars_fragment:bM,clipping_planes_fragment:SM,clipping_planes_pars_fragment:wM,clipping_planes_pars_vertex:MM,clipping_planes_vertex:EM,color_fragment:TM,color_pars_fragment:AM,color_pars_vertex:RM,color_vertex:CM,common:PM,defaultnormal_vertex:IM,displacementmap_pars_vertex:LM,displacementmap_vertex:OM,emissivemap_fragment:NM,emissivemap_pars_fragment:DM,colorspace_fragment:UM,colorspace_pars_fragment:FM,envmap_fragment:kM,envmap_common_pars_fragment:BM,envmap_pars_fragment:zM,envmap_pars_vertex:VM,envmap_physical_pars_fragment:ZM,envmap_vertex:HM,fog_vertex:GM,fog_pars_vertex:WM,fog_fragment:XM,fog_pars_fragment:qM,gradientmap_pars_fragment:YM,lightmap_pars_fragment:$M,lights_lambert_fragment:KM,lights_lambert_pars_fragment:JM,lights_pars_begin:jM,lights_toon_fragment:QM,lights_toon_pars_fragment:eE,lights_phong_fragment:tE,lights_phong_pars_fragment:nE,lights_physical_fragment:iE,lights_physical_pars_fragment:sE,lights_fragment_begin:rE,lights_fragment_maps:oE,lights_fragment_end:aE,lightprobes_pars_fragment:lE,logdepthbuf_fragment:cE,logdepthbuf_pars_fragment:uE,logdepthbuf_pars_vertex:hE,logdepthbuf_vertex:dE,map_fragment:fE,map_pars_fragment:pE,map_particle_fragment:mE,map_particle_pars_fragment:gE,metalnessmap_fragment:_E,metalnessmap_pars_fragment:yE,morphinstance_vertex:xE,morphcolor_vertex:vE,morphnormal_vertex:bE,morphtarget_pars_vertex:SE,morphtarget_vertex:wE,normal_fragment_begin:ME,normal_fragment_maps:EE,normal_pars_fragment:TE,normal_pars_vertex:AE,normal_vertex:RE,normalmap_pars_fragment:CE,clearcoat_normal_fragment_begin:PE,clearcoat_normal_fragment_maps:IE,clearcoat_pars_fragment:LE,iridescence_pars_fragment:OE,opaque_fragment:NE,packing:DE,premultiplied_alpha_fragment:UE,project_vertex:FE,dithering_fragment:kE,dithering_pars_fragment:BE,roughnessmap_fragment:zE,roughnessmap_pars_fragment:VE,shadowmap_pars_fragment:HE,shadowmap_pars_vertex:GE,shadowmap_vertex:WE,shadowmask_pars_fragment:XE,skinbase_vertex:qE,skinning_pars_vertex:YE,skinning_vertex:$E,skinnormal_vertex:KE,specularmap_fragment:JE,specularmap_pars_fragment:jE,tonemapping_fragment:ZE,tonemapping_pars_fragment:QE,transmission_fragment:eT,transmission_pars_fragment:tT,uv_pars_fragment:nT,uv_pars_vertex:iT,uv_vertex:sT,worldpos_vertex:rT,background_vert:oT,background_frag:aT,backgroundCube_vert:lT,backgroundCube_frag:cT,cube_vert:uT,cube_frag:hT,depth_vert:dT,depth_frag:fT,distance_vert:pT,distance_frag:mT,equirect_vert:gT,equirect_frag:_T,linedashed_vert:yT,linedashed_frag:xT,meshbasic_vert:vT,meshbasic_frag:bT,meshlambert_vert:ST,meshlambert_frag:wT,meshmatcap_vert:MT,meshmatcap_frag:ET,meshnormal_vert:TT,meshnormal_frag:AT,meshphong_vert:RT,meshphong_frag:CT,meshphysical_vert:PT,meshphysical_frag:IT,meshtoon_vert:LT,meshtoon_frag:OT,points_vert:NT,points_frag:DT,shadow_vert:UT,shadow_frag:FT,sprite_vert:kT,sprite_frag:BT},Se={common:{diffuse:{value:new Ue(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Je},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Je}},envmap:{envMap:{value:null},envMapRotation:{value:new Je},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Je}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Je}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Je},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Je},normalScale:{value:new ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Je},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Je}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Je}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Je}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ue(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ue(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0},uvTransform:{value:new Je}},sprite:{diffuse:{value:new Ue(16777215)},opacity:{value:1},center:{value:new ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Je},alphaMap:{value:null},alphaMapTransform:{value:new Je},alphaTest:{value:0}}},Qn={basic:{uniforms:Hn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.fog]),vertexShader:rt.meshbasic_vert,fragmentShader:rt.meshbasic_frag},lambert:{uniforms:Hn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new Ue(0)},envMapIntensity:{value:1}}]),vertexShader:rt.meshlambert_vert,fragmentShader:rt.meshlambert_frag},phong:{uniforms:Hn([Se.common,Se.specularmap,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,Se.lights,{emissive:{value:new Ue(0)},specular:{value:new Ue(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:rt.meshphong_vert,fragmentShader:rt.meshphong_frag},standard:{uniforms:Hn([Se.common,Se.envmap,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.roughnessmap,Se.metalnessmap,Se.fog,Se.lights,{emissive:{value:new Ue(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:rt.meshphysical_vert,fragmentShader:rt.meshphysical_frag},toon:{uniforms:Hn([Se.common,Se.aomap,Se.lightmap,Se.emissivemap,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.gradientmap,Se.fog,Se.lights,{emissive:{value:new Ue(0)}}]),vertexShader:rt.meshtoon_vert,fragmentShader:rt.meshtoon_frag},matcap:{uniforms:Hn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,Se.fog,{matcap:{value:null}}]),vertexShader:rt.meshmatcap_vert,fragmentShader:rt.meshmatcap_frag},points:{uniforms:Hn([Se.points,Se.fog]),vertexShader:rt.points_vert,fragmentShader:rt.points_frag},dashed:{uniforms:Hn([Se.common,Se.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:rt.linedashed_vert,fragmentShader:rt.linedashed_frag},depth:{uniforms:Hn([Se.common,Se.displacementmap]),vertexShader:rt.depth_vert,fragmentShader:rt.depth_frag},normal:{uniforms:Hn([Se.common,Se.bumpmap,Se.normalmap,Se.displacementmap,{opacity:{value:1}}]),vertexShader:rt.meshnormal_vert,fragmentShader:rt.meshnormal_frag},sprite:{uniforms:Hn([Se.sprite,Se.fog]),vertexShader:rt.sprite_vert,fragmentShader:rt.sprite_frag},background:{uniforms:{uvTransform:{value:new Je},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:rt.background_vert,fragmentShader:rt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Je}},vertexShader:rt.backgroundCube_vert,fragmentShader:rt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:rt.cube_vert,fragmentShader:rt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:rt.equirect_vert,fragmentShader:rt.equirect_frag},distance:{uniforms:Hn([Se.common,Se.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:rt.distance_vert,fragmentShader:rt.distance_frag},shadow:{uniforms:Hn([Se.lights,Se.fog,{color:{value:new Ue(0)},opacity:{value:1}}]),vertexShader:rt.shadow_vert,fragmentShader:rt.shadow_frag}};Qn.physical={uniforms:Hn([Qn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Je},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Je},clearcoatNormalScale:{value:new ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Je},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Je},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Je},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Je},sheen:{value:0},sheenColor:{value:new Ue(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Je},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Je},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Je},transmissionSamplerSize:{value:new ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Je},attenuationDistance:{value:0},attenuationColor:{value:new Ue(0)},specularColor:{value:new Ue(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Je},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Je},anisotropyVector:{value:new ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Je}}]),vertexShader:rt.meshphysical_vert,fragmentShader:rt.meshphysical_frag};var Qh={r:0,b:0,g:0},zT=new Ce,Yy=new Je;Yy.set(-1,0,0,0,1,0,0,0,1);function VT(i,e,t,n,s,r){let o=new Ue(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let M=v.isScene===!0?v.background:null;if(M&&M.isTexture){let b=v.backgroundBlurriness>0;M=e.get(M,b)}return M}function g(v){let M=!1,b=f(v);b===null?m(o,a):b&&b.isColor&&(m(b,1),M=!0);let S=i.xr.getEnvironmentBlendMode();S==="additive"?t.buffers.color.setClear(0,0,0,1,r):S==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||M)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(v,M){let b=f(M);b&&b.isCubeTexture?(c===void 0&&(c=new Pt(new Yo(1,1,1),new mn({name:"BackgroundCubeMaterial",uniforms:eo(Qn.backgroundCube.uniforms),vertexShader:Qn.backgroundCube.vertexShader,fragmentShader:Qn.backgroundCube.fragmentShader,side:An,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(S,y,p){this.matrixWorld.copyPosition(p.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(zT.makeRotationFromEuler(M.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yy),c.material.toneMapped=st.getTransfer(b.colorSpace)!==Ct,(u!==b||h!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Pt(new ss(2,2),new mn({name:"BackgroundMaterial",uniforms:eo(Qn.background.uniforms),vertexShader:Qn.background.vertexShader,fragmentShader:Qn.background.fragmentShader,side:pi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,l.material.toneMapped=st.getTransfer(b.colorSpace)!==Ct,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,M){v.getRGB(Qh,Qp(i)),t.buffers.color.setClear(Qh.r,Qh.g,Qh.b,M,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,M=1){o.set(v),a=M,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:x,dispose:_}}function HT(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(C,O,U,I,D){let V=!1,F=h(C,I,U,O);r!==F&&(r=F,c(r.object)),V=f(C,I,U,D),V&&g(C,I,U,D),D!==null&&e.update(D,i.ELEMENT_ARRAY_BUFFER),(V||o)&&(o=!1,b(C,O,U,I),D!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(D).buffer))}function l(){return i.createVertexArray()}function c(C){return i.bindVertexArray(C)}function u(C){return i.deleteVertexArray(C)}function h(C,O,U,I){let D=I.wireframe===!0,V=n[O.id];V===void 0&&(V={},n[O.id]=V);let F=C.isInstancedMesh===!0?C.id:0,ie=V[F];ie===void 0&&(ie={},V[F]=ie);let z=ie[U.id];z===void 0&&(z={},ie[U.id]=z);let q=z[D];return q===void 0&&(q=d(l()),z[D]=q),q}function d(C){let O=[],U=[],I=[];for(let D=0;D<t;D++)O[D]=0,U[D]=0,I[D]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:U,attributeDivisors:I,object:C,attributes:{},index:null}}function f(C,O,U,I){let D=r.attributes,V=O.attributes,F=0,ie=U.getAttributes();for(let z in ie)if(ie[z].location>=0){let W=D[z],_e=V[z];if(_e===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(_e=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(_e=C.instanceColor)),W===void 0||W.attribute!==_e||_e&&W.data!==_e.data)return!0;F++}return r.attributesNum!==F||r.index!==I}function g(C,O,U,I){let D={},V=O.attributes,F=0,ie=U.getAttributes();for(let z in ie)if(ie[z].location>=0){let W=V[z];W===void 0&&(z==="instanceMatrix"&&C.instanceMatrix&&(W=C.instanceMatrix),z==="instanceColor"&&C.instanceColor&&(W=C.instanceColor));let _e={};_e.attribute=W,W&&W.data&&(_e.data=W.data),D[z]=_e,F++}r.attributes=D,r.attributesNum=F,r.index=I}function x(){let C=r.newAttributes;for(let O=0,U=C.length;O<U;O++)C[O]=0}function m(C){_(C,0)}function _(C,O){let U=r.newAttributes,I=r.enabledAttributes,D=r.attributeDivisors;U[C]=1,I[C]===0&&(i.enableVertexAttribArray(C),I[C]=1),D[C]!==O&&(i.vertexAttribDivisor(C,O),D[C]=O)}function v(){let C=r.newAttributes,O=r.enabledAttributes;for(let U=0,I=O.length;U<I;U++)O[U]!==C[U]&&(i.disableVertexAttribArray(U),O[U]=0)}function M(C,O,U,I,D,V,F){F===!0?i.vertexAttribIPointer(C,O,U,D,V):i.vertexAttribPointer(C,O,U,I,D,V)}function b(C,O,U,I){x();let D=I.attributes,V=U.getAttributes(),F=O.defaultAttributeValues;for(let ie in V){let z=V[ie];if(z.location>=0){let q=D[ie];if(q===void 0&&(ie==="instanceMatrix"&&C.instanceMatrix&&(q=C.instanceMatrix),ie==="instanceColor"&&C.instanceColor&&(q=C.instanceColor)),q!==void 0){let W=q.normalized,_e=q.itemSize,Te=e.get(q);if(Te===void 0)continue;let K=Te.buffer,ae=Te.type,se=Te.bytesPerElement,ue=ae===i.INT||ae===i.UNSIGNED_INT||q.gpuType===gh;if(q.isInterleavedBufferAttribute){let re=q.data,de=re.isInterleavedBuffer===!0?re.stride:re.itemSize,$e=q.offset;if(re.isInstancedInterleavedBuffer||re.isInstancedBufferAttribute){for(let Ae=0;Ae<z.locationSize;Ae++)_(z.location+Ae,re.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let Ae=0;Ae<z.locationSize;Ae++)m(z.location+Ae);i.bindBuffer(i.ARRAY_BUFFER,K);for(let Ae=0;Ae<z.locationSize;Ae++)M(z.location+Ae,_e/z.locationSize,ae,W,de*se,($e+_e/z.locationSize*Ae)*se,ue)}else{if(q.isInstancedBufferAttribute){for(let re=0;re<z.locationSize;re++)_(z.location+re,q.meshPerAttribute);C.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=q.meshPerAttribute*q.count)}else for(let re=0;re<z.locationSize;re++)m(z.location+re);i.bindBuffer(i.ARRAY_BUFFER,K);for(let re=0;re<z.locationSize;re++)M(z.location+re,_e/z.locationSize,ae,W,_e*se,_e/z.locationSize*re*se,ue)}}else if(F!==void 0){let W=F[ie];if(W!==void 0)switch(W.length){case 2:i.vertexAttrib2fv(z.location,W);break;case 3:i.vertexAttrib3fv(z.location,W);break;case 4:i.vertexAttrib4fv(z.location,W);break;default:i.vertexAttrib1fv(z.location,W)}}}}v()}function S(){T();for(let C in n){let O=n[C];for(let U in O){let I=O[U];for(let D in I){let V=I[D];for(let F in V)u(V[F].object),delete V[F];delete I[D]}}delete n[C]}}function y(C){if(n[C.id]===void 0)return;let O=n[C.id];for(let U in O){let I=O[U];for(let D in I){let V=I[D];for(let F in V)u(V[F].object),delete V[F];delete I[D]}}delete n[C.id]}function p(C){for(let O in n){let U=n[O];for(let I in U){let D=U[I];if(D[C.id]===void 0)continue;let V=D[C.id];for(let F in V)u(V[F].object),delete V[F];delete D[C.id]}}}function w(C){for(let O in n){let U=n[O],I=C.isInstancedMesh===!0?C.id:0,D=U[I];if(D!==void 0){for(let V in D){let F=D[V];for(let ie in F)u(F[ie].object),delete F[ie];delete D[V]}delete U[I],Object.keys(U).length===0&&delete n[O]}}}function T(){E(),o=!0,r!==s&&(r=s,c(r.object))}function E(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:T,resetDefaultState:E,dispose:S,releaseStatesOfGeometry:y,releaseStatesOfObject:w,releaseStatesOfProgram:p,initAttributes:x,enableAttribute:m,disableUnusedAttributes:v}}function GT(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function WT(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let p=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(p.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(p){return!(p!==ii&&n.convert(p)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(p){let w=p===zi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(p!==oi&&p!==$n&&!w&&n.convert(p)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(p){if(p==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";p="mediump"}return p==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Fe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Fe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Fe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),M=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),S=i.getParameter(i.MAX_SAMPLES),y=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:x,maxCubemapSize:m,maxAttributes:_,maxVertexUniforms:v,maxVaryings:M,maxFragmentUniforms:b,maxSamples:S,samples:y}}function XT(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Yn,a=new Je,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,_=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let v=r?0:n,M=v*4,b=_.clippingState||null;l.value=b,b=u(g,d,M,f);for(let S=0;S!==M;++S)b[S]=t[S];_.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,g){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=l.value,g!==!0||m===null){let _=f+x*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<_)&&(m=new Float32Array(_));for(let M=0,b=f;M!==x;++M,b+=4)o.copy(h[M]).applyMatrix4(v,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var nc=class extends Vn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Al(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Yo(5,5,5),r=new mn({name:"CubemapFromEquirect",uniforms:eo(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:An,blending:as});r.uniforms.tEquirect.value=t;let o=new Pt(s,r),a=t.minFilter;return t.minFilter===Ai&&(t.minFilter=pn),new Jo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Ey=256,qT=3,YT=20,$y=256,Ky=16,$T=3,KT=new P,JT=new Ue,td=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Jo(1,10,null),this._boxMesh=new Pt(new Yo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=KT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(JT));let m=new Jo(n,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ry(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ay(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ey,Jp(e))}_fromTexture(e,t){e.mapping===jr||e.mapping===Qo?this._setSize(e.image.length===0?Ey:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Ty(e,!1,!1),n=Math.log2(e)-qT;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Ty(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===jr||e.mapping===Qo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ry()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ay()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=jT(),this._integrationMaterial=ZT());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Ky);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-$T)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/($y*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=QT());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Ty(i,e,t){return new nc(i,{minFilter:Ai,generateMipmaps:e,type:zi,colorSpace:Kn,depthBuffer:t})}function ic(i,e,t){return new mn({name:i,uniforms:e,vertexShader:rt.cube_vert,fragmentShader:t,side:An,blending:as,depthTest:!1,depthWrite:!1})}function jT(){return ic("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${$y}u

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
	`)}function ZT(){return ic("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ky}},`

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
	`)}function QT(){return ic("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${YT}
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
	`)}function Ay(){return ic("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ry(){return ic("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function e1(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===fh||f===ph)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let x=new nc(g.height);return x.fromEquirectangularTexture(i,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===fh||f===ph,x=f===jr||f===Qo;if(g||x){let m=t.get(d),_=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==_)return n===null&&(n=new td(i)),m=g?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return g&&v&&v.height>0||x&&v&&l(v)?(n===null&&(n=new td(i)),m=g?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===fh?d.mapping=jr:f===ph&&(d.mapping=Qo),d}function l(d){let f=0,g=6;for(let x=0;x<g;x++)d[x]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function t1(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Hr("WebGLRenderer: "+n+" extension not supported."),s}}}function n1(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let x=r.get(g);x&&(e.remove(x),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(g){let x=g.attributes;for(let m in x)e.update(x[m],i.ARRAY_BUFFER)}function h(g){let x=g.index,m=g.attributes.position,_=0;if(m===void 0)return;let v=x!==null?x.array.length:m.array.length/3-1,M=m.count>=65535?bl:vl,b=new M(Math.ceil(v/3)*6,1),S=b.array;if(x!==null){let p=x.array;_=x.version;for(let w=0,T=0;w<v;w+=3){let E=p[w+0],C=p[w+1],O=p[w+2];S[T++]=E,S[T++]=C,S[T++]=C,S[T++]=O,S[T++]=O,S[T++]=E}}else{_=m.version;for(let p=0,w=0;p<v;p+=3){let T=p+0,E=p+1,C=p+2;S[w++]=T,S[w++]=E,S[w++]=E,S[w++]=C,S[w++]=C,S[w++]=T}}b.version=_;let y=r.get(g);y&&e.remove(y),r.set(g,b)}function d(g){let x=r.get(g);if(x){let m=g.index;m!==null&&x.version<m.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let x=s[g].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function i1(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){i.drawElements(n,d,r,h*o),t.update(d,n,1)}function c(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),t.update(d,n,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];t.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function s1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function r1(i,e,t){let n=new WeakMap,s=new ct;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let E=function(){w.dispose(),n.delete(a),a.removeEventListener("dispose",E)};var f=E;d!==void 0&&d.texture.dispose();let g=a.morphAttributes.position!==void 0,x=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],v=a.morphAttributes.normal||[],M=a.morphAttributes.color||[],b=0;g===!0&&(b=1),x===!0&&(b=2),m===!0&&(b=3);let S=a.attributes.position.count*b,y=1;S>e.maxTextureSize&&(y=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let p=new Float32Array(S*y*4*h),w=new yl(p,S,y,h);w.type=$n,w.needsUpdate=!0;let T=b*4;for(let C=0;C<h;C++){let O=_[C],U=v[C],I=M[C],D=S*y*4*C;for(let V=0;V<O.count;V++){let F=V*T;g===!0&&(s.fromBufferAttribute(O,V),p[D+F+0]=s.x,p[D+F+1]=s.y,p[D+F+2]=s.z,p[D+F+3]=0),x===!0&&(s.fromBufferAttribute(U,V),p[D+F+4]=s.x,p[D+F+5]=s.y,p[D+F+6]=s.z,p[D+F+7]=0),m===!0&&(s.fromBufferAttribute(I,V),p[D+F+8]=s.x,p[D+F+9]=s.y,p[D+F+10]=s.z,p[D+F+11]=I.itemSize===4?s.w:1)}}d={count:h,texture:w,size:new ke(S,y)},n.set(a,d),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let g=0;for(let m=0;m<c.length;m++)g+=c[m];let x=a.morphTargetsRelative?1:1-g;l.getUniforms().setValue(i,"morphTargetBaseInfluence",x),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function o1(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var a1={[Pp]:"LINEAR_TONE_MAPPING",[Ip]:"REINHARD_TONE_MAPPING",[Lp]:"CINEON_TONE_MAPPING",[Op]:"ACES_FILMIC_TONE_MAPPING",[Dp]:"AGX_TONE_MAPPING",[Gl]:"NEUTRAL_TONE_MAPPING",[Np]:"CUSTOM_TONE_MAPPING"};function l1(i,e,t,n,s,r){let o=new Vn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Kt;u.setAttribute("position",new fn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new fn([0,2,0,0,2,0],2));let h=new th({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Pt(u,h),f=new qs(-1,1,1,-1,0,1),g=null,x=null,m=!1,_,v=null,M=[],b=!1;this.setSize=function(S,y){o.setSize(S,y),a!==null&&a.setSize(S,y),l!==null&&l.setSize(S,y);for(let p=0;p<M.length;p++){let w=M[p];w.setSize&&w.setSize(S,y)}},this.setEffects=function(S){M=S,b=M.length>0&&M[0].isRenderPass===!0;let y=o.width,p=o.height;M.length>0&&a===null&&(a=new Vn(y,p,{type:zi,depthBuffer:!1,stencilBuffer:!1}),l=new Vn(y,p,{type:zi,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&M.some(T=>T.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new zs(y,p),r===!0&&(c.format=$s,c.type=Qr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let T=0;T<M.length;T++){let E=M[T];E.setSize&&E.setSize(y,p),w&&E.needsDepthTexture===!0&&E.setDepthTexture&&E.setDepthTexture(c)}},this.begin=function(S,y){if(m||S.toneMapping===ls&&M.length===0)return!1;if(v=y,y!==null){let p=y.width,w=y.height;(o.width!==p||o.height!==w)&&this.setSize(p,w)}return b===!1&&S.setRenderTarget(o),_=S.toneMapping,S.toneMapping=ls,!0},this.hasRenderPass=function(){return b},this.end=function(S,y){S.toneMapping=_,m=!0;let p=o,w=a;for(let T=0;T<M.length;T++){let E=M[T];E.enabled!==!1&&(E.render(S,w,p,y),E.needsSwap!==!1&&(p=w,w=w===a?l:a))}if(g!==S.outputColorSpace||x!==S.toneMapping){g=S.outputColorSpace,x=S.toneMapping,h.defines={},st.getTransfer(g)===Ct&&(h.defines.SRGB_TRANSFER="");let T=a1[x];T&&(h.defines[T]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=p.texture,S.setRenderTarget(v),S.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Jy=new wn,jy=new zs(1,1),Zy=new Rl(1),Qy=new yl,ex=new Zu,tx=new Al,Cy=[],Py=[],Iy=new Float32Array(16),Ly=new Float32Array(9),Oy=new Float32Array(4);function oa(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Cy[s];if(r===void 0&&(r=new Float32Array(s),Cy[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function gn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function _n(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function id(i,e){let t=Py[e];t===void 0&&(t=new Int32Array(e),Py[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function c1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function u1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(gn(t,e))return;i.uniform2fv(this.addr,e),_n(t,e)}}function h1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(gn(t,e))return;i.uniform3fv(this.addr,e),_n(t,e)}}function d1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(gn(t,e))return;i.uniform4fv(this.addr,e),_n(t,e)}}function f1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(gn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),_n(t,e)}else{if(gn(t,n))return;Oy.set(n),i.uniformMatrix2fv(this.addr,!1,Oy),_n(t,n)}}function p1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(gn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),_n(t,e)}else{if(gn(t,n))return;Ly.set(n),i.uniformMatrix3fv(this.addr,!1,Ly),_n(t,n)}}function m1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(gn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),_n(t,e)}else{if(gn(t,n))return;Iy.set(n),i.uniformMatrix4fv(this.addr,!1,Iy),_n(t,n)}}function g1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function _1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(gn(t,e))return;i.uniform2iv(this.addr,e),_n(t,e)}}function y1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(gn(t,e))return;i.uniform3iv(this.addr,e),_n(t,e)}}function x1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(gn(t,e))return;i.uniform4iv(this.addr,e),_n(t,e)}}function v1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function b1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(gn(t,e))return;i.uniform2uiv(this.addr,e),_n(t,e)}}function S1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(gn(t,e))return;i.uniform3uiv(this.addr,e),_n(t,e)}}function w1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(gn(t,e))return;i.uniform4uiv(this.addr,e),_n(t,e)}}function sd(i){return i.version===0&&(i.compareFunction=qp,i.needsUpdate=!0),i}function M1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=sd(jy):r=Jy,t.setTexture2D(e||r,s)}function E1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||ex,s)}function T1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=sd(Zy):r=tx,t.setTextureCube(e||r,s)}function A1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Qy,s)}function R1(i){switch(i){case 5126:return c1;case 35664:return u1;case 35665:return h1;case 35666:return d1;case 35674:return f1;case 35675:return p1;case 35676:return m1;case 5124:case 35670:return g1;case 35667:case 35671:return _1;case 35668:case 35672:return y1;case 35669:case 35673:return x1;case 5125:return v1;case 36294:return b1;case 36295:return S1;case 36296:return w1;case 35678:case 36198:case 36298:case 36306:case 35682:return M1;case 35679:case 36299:case 36307:return E1;case 35680:case 36300:case 36308:case 36293:return T1;case 36289:case 36303:case 36311:case 36292:return A1}}function C1(i,e){i.uniform1fv(this.addr,e)}function P1(i,e){let t=oa(e,this.size,2);i.uniform2fv(this.addr,t)}function I1(i,e){let t=oa(e,this.size,3);i.uniform3fv(this.addr,t)}function L1(i,e){let t=oa(e,this.size,4);i.uniform4fv(this.addr,t)}function O1(i,e){let t=oa(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function N1(i,e){let t=oa(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function D1(i,e){let t=oa(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function U1(i,e){i.uniform1iv(this.addr,e)}function F1(i,e){i.uniform2iv(this.addr,e)}function k1(i,e){i.uniform3iv(this.addr,e)}function B1(i,e){i.uniform4iv(this.addr,e)}function z1(i,e){i.uniform1uiv(this.addr,e)}function V1(i,e){i.uniform2uiv(this.addr,e)}function H1(i,e){i.uniform3uiv(this.addr,e)}function G1(i,e){i.uniform4uiv(this.addr,e)}function W1(i,e,t){let n=this.cache,s=e.length,r=id(t,s);gn(n,r)||(i.uniform1iv(this.addr,r),_n(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=sd(jy):o=Jy;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function X1(i,e,t){let n=this.cache,s=e.length,r=id(t,s);gn(n,r)||(i.uniform1iv(this.addr,r),_n(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ex,r[o])}function q1(i,e,t){let n=this.cache,s=e.length,r=id(t,s);gn(n,r)||(i.uniform1iv(this.addr,r),_n(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=sd(Zy):o=tx;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Y1(i,e,t){let n=this.cache,s=e.length,r=id(t,s);gn(n,r)||(i.uniform1iv(this.addr,r),_n(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Qy,r[o])}function $1(i){switch(i){case 5126:return C1;case 35664:return P1;case 35665:return I1;case 35666:return L1;case 35674:return O1;case 35675:return N1;case 35676:return D1;case 5124:case 35670:return U1;case 35667:case 35671:return F1;case 35668:case 35672:return k1;case 35669:case 35673:return B1;case 5125:return z1;case 36294:return V1;case 36295:return H1;case 36296:return G1;case 35678:case 36198:case 36298:case 36306:case 35682:return W1;case 35679:case 36299:case 36307:return X1;case 35680:case 36300:case 36308:case 36293:return q1;case 36289:case 36303:case 36311:case 36292:return Y1}}var rm=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=R1(t.type)}},om=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=$1(t.type)}},am=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},im=/(\w+)(\])?(\[|\.)?/g;function Ny(i,e){i.seq.push(e),i.map[e.id]=e}function K1(i,e,t){let n=i.name,s=n.length;for(im.lastIndex=0;;){let r=im.exec(n),o=im.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ny(t,c===void 0?new rm(a,i,e):new om(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new am(a),Ny(t,h)),t=h}}}var sa=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);K1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Dy(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var J1=37297,j1=0;function Z1(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Uy=new Je;function Q1(i){st._getMatrix(Uy,st.workingColorSpace,i);let e=`mat3( ${Uy.elements.map(t=>t.toFixed(4))} )`;switch(st.getTransfer(i)){case gl:return[e,"LinearTransferOETF"];case Ct:return[e,"sRGBTransferOETF"];default:return Fe("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Fy(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Z1(i.getShaderSource(e),a)}else return r}function eA(i,e){let t=Q1(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var tA={[Pp]:"Linear",[Ip]:"Reinhard",[Lp]:"Cineon",[Op]:"ACESFilmic",[Dp]:"AgX",[Gl]:"Neutral",[Np]:"Custom"};function nA(i,e){let t=tA[e];return t===void 0?(Fe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ed=new P;function iA(){st.getLuminanceCoefficients(ed);let i=ed.x.toFixed(4),e=ed.y.toFixed(4),t=ed.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function sA(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(tc).join(`
`)}function rA(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function oA(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function tc(i){return i!==""}function ky(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function By(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var aA=/^[ \t]*#include +<([\w\d./]+)>/gm;function lm(i){return i.replace(aA,lA)}function lA(i,e){let t=rt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return lm(t)}var cA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function zy(i){return i.replace(cA,uA)}function uA(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Vy(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var hA={[Hl]:"SHADOWMAP_TYPE_PCF",[jo]:"SHADOWMAP_TYPE_VSM"};function dA(i){return hA[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var fA={[Qo]:"ENVMAP_MODE_REFRACTION"};function pA(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":fA[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var mA={[dh]:"ENVMAP_BLENDING_MULTIPLY",[oy]:"ENVMAP_BLENDING_MIX",[ay]:"ENVMAP_BLENDING_ADD"};function gA(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":mA[i.combine]||"ENVMAP_BLENDING_NONE"}function _A(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=dA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=pA(t),h=gA(t),d=sA(t),f=rA(r),g=s.createProgram(),x,m,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(tc).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(tc).join(`
`),m.length>0&&(m+=`
`)):(x=[Vy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(tc).join(`
`),m=[Vy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ls?"#define TONE_MAPPING":"",t.toneMapping!==ls?rt.tonemapping_pars_fragment:"",t.toneMapping!==ls?nA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",rt.colorspace_pars_fragment,eA("linearToOutputTexel",t.outputColorSpace),iA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(tc).join(`
`)),o=lm(o),o=ky(o,t),o=By(o,t),a=lm(a),a=ky(a,t),a=By(a,t),o=zy(o),a=zy(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===$p?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===$p?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=_+x+o,M=_+m+a,b=Dy(s,s.VERTEX_SHADER,v),S=Dy(s,s.FRAGMENT_SHADER,M);s.attachShader(g,b),s.attachShader(g,S),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function y(E){if(i.debug.checkShaderErrors){let C=s.getProgramInfoLog(g)||"",O=s.getShaderInfoLog(b)||"",U=s.getShaderInfoLog(S)||"",I=C.trim(),D=O.trim(),V=U.trim(),F=!0,ie=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(F=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,S);else{let z=Fy(s,b,"vertex"),q=Fy(s,S,"fragment");qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+E.name+`
Material Type: `+E.type+`

Program Info Log: `+I+`
`+z+`
`+q)}else I!==""?Fe("WebGLProgram: Program Info Log:",I):(D===""||V==="")&&(ie=!1);ie&&(E.diagnostics={runnable:F,programLog:I,vertexShader:{log:D,prefix:x},fragmentShader:{log:V,prefix:m}})}s.deleteShader(b),s.deleteShader(S),p=new sa(s,g),w=oA(s,g)}let p;this.getUniforms=function(){return p===void 0&&y(this),p};let w;this.getAttributes=function(){return w===void 0&&y(this),w};let T=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=s.getProgramParameter(g,J1)),T},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=j1++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=S,this}var yA=0,cm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new um(e),t.set(e,n)),n}},um=class{constructor(e){this.id=yA++,this.code=e,this.usedTimes=0}};function xA(i){return i===pr||i===Kl||i===Jl}function vA(i,e,t,n,s,r){let o=new Go,a=new cm,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(p){return l.add(p),p===0?"uv":`uv${p}`}function g(p,w,T,E,C,O){let U=E.fog,I=C.geometry,D=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?E.environment:null,V=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap,F=e.get(p.envMap||D,V),ie=d[p.type],z=n.precision;p.precision!==null&&(z=n.getMaxPrecision(p.precision),z!==p.precision&&Fe("WebGLProgram.getParameters:",p.precision,"not supported, using",z,"instead."));let q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,W=q!==void 0?q.length:0,_e=0;I.morphAttributes.position!==void 0&&(_e=1),I.morphAttributes.normal!==void 0&&(_e=2),I.morphAttributes.color!==void 0&&(_e=3);let Te,K,ae,se;if(ie){let Me=Qn[ie];Te=Me.vertexShader,K=Me.fragmentShader}else{Te=p.vertexShader,K=p.fragmentShader;let Me=a.getVertexShaderStage(p),Nt=a.getFragmentShaderStage(p);a.update(p,Me,Nt),ae=Me.id,se=Nt.id}let ue=i.getRenderTarget(),re=i.state.buffers.depth.getReversed(),de=C.isInstancedMesh===!0,$e=C.isBatchedMesh===!0,Ae=!!p.map,Ve=!!p.matcap,Le=!!F,we=Le&&F.isPMREMTexture===!0,gt=!!p.aoMap,We=!!p.lightMap,at=!!p.bumpMap&&p.wireframe===!1,Qe=!!p.normalMap,Mn=!!p.displacementMap,Ot=!!p.emissiveMap,yn=!!p.metalnessMap,At=!!p.roughnessMap,Jt=p.anisotropy>0,B=p.clearcoat>0,kt=p.diffuseRoughness>0,_t=p.dispersion>0,Ut=p.retroreflectivity>0,xe=p.iridescence>0,Wt=p.sheen>0,Oe=p.transmission>0,Xe=Jt&&!!p.anisotropyMap,L=B&&!!p.clearcoatMap,A=B&&!!p.clearcoatNormalMap,G=B&&!!p.clearcoatRoughnessMap,oe=kt&&!!p.diffuseRoughnessMap,ne=xe&&!!p.iridescenceMap,fe=xe&&!!p.iridescenceThicknessMap,ve=Wt&&!!p.sheenColorMap,Z=Wt&&!!p.sheenRoughnessMap,Q=!!p.specularMap,me=!!p.specularColorMap,N=!!p.specularIntensityMap,ee=Oe&&!!p.transmissionMap,j=Oe&&!!p.thicknessMap,ge=!!p.gradientMap,he=!!p.alphaMap,pe=p.alphaTest>0,ze=!!p.alphaHash,it=!!p.extensions,le=ls;p.toneMapped&&(ue===null||ue.isXRRenderTarget===!0)&&(le=i.toneMapping);let Ge=we?F.isCompressedCubeTexture?F.image[0].mipmaps:F.mipmaps:null,et={shaderID:ie,shaderType:p.type,shaderName:p.name,vertexShader:Te,fragmentShader:K,defines:p.defines,customVertexShaderID:ae,customFragmentShaderID:se,isRawShaderMaterial:p.isRawShaderMaterial===!0,glslVersion:p.glslVersion,precision:z,batching:$e,batchingColor:$e&&C._colorsTexture!==null,instancing:de,instancingColor:de&&C.instanceColor!==null,instancingMorph:de&&C.morphTexture!==null,outputColorSpace:ue===null?i.outputColorSpace:ue.isXRRenderTarget===!0?ue.texture.colorSpace:st.workingColorSpace,alphaToCoverage:!!p.alphaToCoverage,map:Ae,matcap:Ve,envMap:Le,envMapMode:Le&&F.mapping,envMapPMREM:we,envMapMaxLod:we?Ge.length-1:null,envMapSize:we?Ge[0].width:null,aoMap:gt,lightMap:We,bumpMap:at,normalMap:Qe,displacementMap:Mn,emissiveMap:Ot,normalMapObjectSpace:Qe&&p.normalMapType===hy,normalMapTangentSpace:Qe&&p.normalMapType===Zl,packedNormalMap:Qe&&p.normalMapType===Zl&&xA(p.normalMap.format),metalnessMap:yn,roughnessMap:At,anisotropy:Jt,anisotropyMap:Xe,clearcoat:B,clearcoatMap:L,clearcoatNormalMap:A,clearcoatRoughnessMap:G,diffuseRoughness:kt,diffuseRoughnessMap:oe,dispersion:_t,retroreflection:Ut,iridescence:xe,iridescenceMap:ne,iridescenceThicknessMap:fe,sheen:Wt,sheenColorMap:ve,sheenRoughnessMap:Z,specularMap:Q,specularColorMap:me,specularIntensityMap:N,transmission:Oe,transmissionMap:ee,thicknessMap:j,gradientMap:ge,opaque:p.transparent===!1&&p.blending===Zo&&p.alphaToCoverage===!1,alphaMap:he,alphaTest:pe,alphaHash:ze,combine:p.combine,mapUv:Ae&&f(p.map.channel),aoMapUv:gt&&f(p.aoMap.channel),lightMapUv:We&&f(p.lightMap.channel),bumpMapUv:at&&f(p.bumpMap.channel),normalMapUv:Qe&&f(p.normalMap.channel),displacementMapUv:Mn&&f(p.displacementMap.channel),emissiveMapUv:Ot&&f(p.emissiveMap.channel),metalnessMapUv:yn&&f(p.metalnessMap.channel),roughnessMapUv:At&&f(p.roughnessMap.channel),anisotropyMapUv:Xe&&f(p.anisotropyMap.channel),clearcoatMapUv:L&&f(p.clearcoatMap.channel),clearcoatNormalMapUv:A&&f(p.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:G&&f(p.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:oe&&f(p.diffuseRoughnessMap.channel),iridescenceMapUv:ne&&f(p.iridescenceMap.channel),iridescenceThicknessMapUv:fe&&f(p.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(p.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(p.sheenRoughnessMap.channel),specularMapUv:Q&&f(p.specularMap.channel),specularColorMapUv:me&&f(p.specularColorMap.channel),specularIntensityMapUv:N&&f(p.specularIntensityMap.channel),transmissionMapUv:ee&&f(p.transmissionMap.channel),thicknessMapUv:j&&f(p.thicknessMap.channel),alphaMapUv:he&&f(p.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Qe||Jt),vertexNormals:!!I.attributes.normal,vertexColors:p.vertexColors,vertexAlphas:p.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!I.attributes.uv&&(Ae||he),fog:!!U,useFog:p.fog===!0,fogExp2:!!U&&U.isFogExp2,flatShading:p.wireframe===!1&&(p.flatShading===!0||I.attributes.normal===void 0&&Qe===!1&&(p.isMeshLambertMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isMeshPhysicalMaterial)),sizeAttenuation:p.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:re,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:W,morphTextureStride:_e,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:O.filter(Me=>Me.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:p.dithering,shadowMapEnabled:i.shadowMap.enabled&&T.length>0,shadowMapType:i.shadowMap.type,toneMapping:le,decodeVideoTexture:Ae&&p.map.isVideoTexture===!0&&st.getTransfer(p.map.colorSpace)===Ct,decodeVideoTextureEmissive:Ot&&p.emissiveMap.isVideoTexture===!0&&st.getTransfer(p.emissiveMap.colorSpace)===Ct,premultipliedAlpha:p.premultipliedAlpha,doubleSided:p.side===un,flipSided:p.side===An,useDepthPacking:p.depthPacking>=0,depthPacking:p.depthPacking||0,index0AttributeName:p.index0AttributeName,extensionClipCullDistance:it&&p.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(it&&p.extensions.multiDraw===!0||$e)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:p.customProgramCacheKey()};return et.vertexUv1s=l.has(1),et.vertexUv2s=l.has(2),et.vertexUv3s=l.has(3),l.clear(),et}function x(p){let w=[];if(p.shaderID?w.push(p.shaderID):(w.push(p.customVertexShaderID),w.push(p.customFragmentShaderID)),p.defines!==void 0)for(let T in p.defines)w.push(T),w.push(p.defines[T]);return p.isRawShaderMaterial===!1&&(m(w,p),_(w,p),w.push(i.outputColorSpace)),w.push(p.customProgramCacheKey),w.join()}function m(p,w){p.push(w.precision),p.push(w.outputColorSpace),p.push(w.envMapMode),p.push(w.envMapPMREM),p.push(w.envMapMaxLod),p.push(w.envMapSize),p.push(w.mapUv),p.push(w.alphaMapUv),p.push(w.lightMapUv),p.push(w.aoMapUv),p.push(w.bumpMapUv),p.push(w.normalMapUv),p.push(w.displacementMapUv),p.push(w.emissiveMapUv),p.push(w.metalnessMapUv),p.push(w.roughnessMapUv),p.push(w.anisotropyMapUv),p.push(w.clearcoatMapUv),p.push(w.clearcoatNormalMapUv),p.push(w.clearcoatRoughnessMapUv),p.push(w.diffuseRoughnessMapUv),p.push(w.iridescenceMapUv),p.push(w.iridescenceThicknessMapUv),p.push(w.sheenColorMapUv),p.push(w.sheenRoughnessMapUv),p.push(w.specularMapUv),p.push(w.specularColorMapUv),p.push(w.specularIntensityMapUv),p.push(w.transmissionMapUv),p.push(w.thicknessMapUv),p.push(w.combine),p.push(w.fogExp2),p.push(w.sizeAttenuation),p.push(w.morphTargetsCount),p.push(w.numSunLights),p.push(w.numDirLights),p.push(w.numPointLights),p.push(w.numSpotLights),p.push(w.numSpotLightMaps),p.push(w.numHemiLights),p.push(w.numRectAreaLights),p.push(w.numSunLightShadows),p.push(w.numDirLightShadows),p.push(w.numPointLightShadows),p.push(w.numSpotLightShadows),p.push(w.numSpotLightShadowsWithMaps),p.push(w.numLightProbes),p.push(w.numLightProbeGrids),p.push(w.shadowMapType),p.push(w.toneMapping),p.push(w.numClippingPlanes),p.push(w.numClipIntersection),p.push(w.depthPacking)}function _(p,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),p.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),p.push(o.mask)}function v(p){let w=d[p.type],T;if(w){let E=Qn[w];T=Ql.clone(E.uniforms)}else T=p.uniforms;return T}function M(p,w){let T=u.get(w);return T!==void 0?++T.usedTimes:(T=new _A(i,w,p,s),c.push(T),u.set(w,T)),T}function b(p){if(--p.usedTimes===0){let w=c.indexOf(p);c[w]=c[c.length-1],c.pop(),u.delete(p.cacheKey),p.destroy()}}function S(p){a.remove(p)}function y(){a.dispose()}return{getParameters:g,getProgramCacheKey:x,getUniforms:v,acquireProgram:M,releaseProgram:b,releaseShaderCache:S,programs:c,dispose:y}}function bA(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function SA(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Hy(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Gy(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,x,m,_){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:_},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=x,v.renderOrder=d.renderOrder,v.z=m,v.group=_),e++,v}function l(d,f,g,x,m,_,v){v.reversedDepth===!0&&(m=-m);let M=a(d,f,g,x,m,_);g.transmission>0?n.push(M):g.transparent===!0?s.push(M):t.push(M)}function c(d,f,g,x,m,_){let v=a(d,f,g,x,m,_);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||SA),n.length>1&&n.sort(f||Hy),s.length>1&&s.sort(f||Hy)}function h(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function wA(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Gy,i.set(n,[o])):s>=r.length?(o=new Gy,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function MA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new P,color:new Ue};break;case"SpotLight":t={position:new P,direction:new P,color:new Ue,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new P,color:new Ue,distance:0,decay:0};break;case"HemisphereLight":t={direction:new P,skyColor:new Ue,groundColor:new Ue};break;case"RectAreaLight":t={color:new Ue,position:new P,halfWidth:new P,halfHeight:new P};break}return i[e.id]=t,t}}}function EA(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var TA=0;function AA(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function RA(i){let e=new MA,t=EA(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new P);let s=new P,r=new Ce,o=new Ce;function a(c){let u=0,h=0,d=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let f=0,g=0,x=0,m=0,_=0,v=0,M=0,b=0,S=0,y=0,p=0,w=0,T=0,E=0;c.sort(AA);for(let O=0,U=c.length;O<U;O++){let I=c[O],D=I.color,V=I.intensity,F=I.distance,ie=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===pr?ie=I.shadow.map.texture:ie=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=D.r*V,h+=D.g*V,d+=D.b*V;else if(I.isLightProbe){for(let z=0;z<9;z++)n.probe[z].addScaledVector(I.sh.coefficients[z],V);E++}else if(I.isSunLight){let z=e.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let q=I.shadow,W=t.get(I);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize.copy(q.mapSize).multiply(q.getFrameExtents()),n.sunShadow[g]=W,n.sunShadowMap[g]=ie;let _e=q.getViewportCount();for(let Te=0;Te<_e;Te++)n.sunShadowMatrix[x+Te]=q.getMatrix(Te),n.sunShadowCascade[x+Te]=q._cascadeData[Te];x+=_e,g++}n.sun[f]=z,f++}else if(I.isDirectionalLight){let z=e.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let q=I.shadow,W=t.get(I);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,n.directionalShadow[m]=W,n.directionalShadowMap[m]=ie,n.directionalShadowMatrix[m]=I.shadow.matrix,S++}n.directional[m]=z,m++}else if(I.isSpotLight){let z=e.get(I);z.position.setFromMatrixPosition(I.matrixWorld),z.color.copy(D).multiplyScalar(V),z.distance=F,z.coneCos=Math.cos(I.angle),z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),z.decay=I.decay,n.spot[v]=z;let q=I.shadow;if(I.map&&(n.spotLightMap[w]=I.map,w++,q.updateMatrices(I),I.castShadow&&T++),n.spotLightMatrix[v]=q.matrix,I.castShadow){let W=t.get(I);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,n.spotShadow[v]=W,n.spotShadowMap[v]=ie,p++}v++}else if(I.isRectAreaLight){let z=e.get(I);z.color.copy(D).multiplyScalar(V),z.halfWidth.set(I.width*.5,0,0),z.halfHeight.set(0,I.height*.5,0),n.rectArea[M]=z,M++}else if(I.isPointLight){let z=e.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),z.distance=I.distance,z.decay=I.decay,I.castShadow){let q=I.shadow,W=t.get(I);W.shadowIntensity=q.intensity,W.shadowBias=q.bias,W.shadowNormalBias=q.normalBias,W.shadowRadius=q.radius,W.shadowMapSize=q.mapSize,W.shadowCameraNear=q.camera.near,W.shadowCameraFar=q.camera.far,n.pointShadow[_]=W,n.pointShadowMap[_]=ie,n.pointShadowMatrix[_]=I.shadow.matrix,y++}n.point[_]=z,_++}else if(I.isHemisphereLight){let z=e.get(I);z.skyColor.copy(I.color).multiplyScalar(V),z.groundColor.copy(I.groundColor).multiplyScalar(V),n.hemi[b]=z,b++}}M>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Se.LTC_FLOAT_1,n.rectAreaLTC2=Se.LTC_FLOAT_2):(n.rectAreaLTC1=Se.LTC_HALF_1,n.rectAreaLTC2=Se.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let C=n.hash;(C.sunLength!==f||C.directionalLength!==m||C.pointLength!==_||C.spotLength!==v||C.rectAreaLength!==M||C.hemiLength!==b||C.numSunShadows!==g||C.numDirectionalShadows!==S||C.numPointShadows!==y||C.numSpotShadows!==p||C.numSpotMaps!==w||C.numLightProbes!==E)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=M,n.point.length=_,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=S,n.directionalShadowMap.length=S,n.directionalShadowMatrix.length=S,n.pointShadow.length=y,n.pointShadowMap.length=y,n.pointShadowMatrix.length=y,n.spotShadow.length=p,n.spotShadowMap.length=p,n.spotLightMatrix.length=p+w-T,n.spotLightMap.length=w,n.numSpotLightShadowsWithMaps=T,n.numLightProbes=E,C.sunLength=f,C.directionalLength=m,C.pointLength=_,C.spotLength=v,C.rectAreaLength=M,C.hemiLength=b,C.numSunShadows=g,C.numDirectionalShadows=S,C.numPointShadows=y,C.numSpotShadows=p,C.numSpotMaps=w,C.numLightProbes=E,n.version=TA++)}function l(c,u){let h=0,d=0,f=0,g=0,x=0,m=0,_=u.matrixWorldInverse;for(let v=0,M=c.length;v<M;v++){let b=c[v];if(b.isSunLight){let S=n.sun[h];S.direction.setFromMatrixPosition(b.matrixWorld),S.direction.transformDirection(_),h++}else if(b.isDirectionalLight){let S=n.directional[d];S.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(_),d++}else if(b.isSpotLight){let S=n.spot[g];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(_),S.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(_),g++}else if(b.isRectAreaLight){let S=n.rectArea[x];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(_),o.identity(),r.copy(b.matrixWorld),r.premultiply(_),o.extractRotation(r),S.halfWidth.set(b.width*.5,0,0),S.halfHeight.set(0,b.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let S=n.point[f];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(_),f++}else if(b.isHemisphereLight){let S=n.hemi[m];S.direction.setFromMatrixPosition(b.matrixWorld),S.direction.transformDirection(_),m++}}}return{setup:a,setupView:l,state:n}}function Wy(i){let e=new RA(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function CA(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Wy(i),e.set(s,[a])):r>=o.length?(a=new Wy(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var PA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,IA=`uniform sampler2D shadow_pass;
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
}`,LA=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],OA=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],Xy=new Ce,ec=new P,sm=new P;function NA(i,e,t){let n=new Bs,s=new ke,r=new ke,o=new ct,a=new nh,l=new ih,c={},u=t.maxTextureSize,h={[pi]:An,[An]:pi,[un]:un},d=new mn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ke},radius:{value:4}},vertexShader:PA,fragmentShader:IA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Kt;g.setAttribute("position",new mt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Pt(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Hl;let _=this.type;this.render=function(y,p,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||y.length===0)return;this.type===V_&&(Fe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Hl);let T=i.getRenderTarget(),E=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),O=i.state;O.setBlending(as),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let U=_!==this.type;U&&p.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(D=>D.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,D=y.length;I<D;I++){let V=y[I],F=V.shadow;if(F===void 0){Fe("WebGLShadowMap:",V,"has no shadow.");continue}if(F.autoUpdate===!1&&F.needsUpdate===!1)continue;s.copy(F.mapSize);let ie=F.getFrameExtents();s.multiply(ie),r.copy(F.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ie.x),s.x=r.x*ie.x,F.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ie.y),s.y=r.y*ie.y,F.mapSize.y=r.y));let z=i.state.buffers.depth.getReversed();if(F.camera._reversedDepth=z,F.map===null||U===!0){if(F.map!==null&&(F.map.depthTexture!==null&&(F.map.depthTexture.dispose(),F.map.depthTexture=null),F.map.dispose()),this.type===jo){if(V.isPointLight){Fe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}F.map=new Vn(s.x,s.y,{format:pr,type:zi,minFilter:pn,magFilter:pn,generateMipmaps:!1}),F.map.texture.name=V.name+".shadowMap",F.map.depthTexture=new zs(s.x,s.y,$n),F.map.depthTexture.name=V.name+".shadowMapDepth",F.map.depthTexture.format=Fs,F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=on,F.map.depthTexture.magFilter=on}else V.isPointLight?(F.map=new nc(s.x),F.map.depthTexture=new Rl(s.x,Ri)):(F.map=new Vn(s.x,s.y),F.map.depthTexture=new zs(s.x,s.y,Ri)),F.map.depthTexture.name=V.name+".shadowMap",F.map.depthTexture.format=Fs,this.type===Hl?(F.map.depthTexture.compareFunction=z?Xp:Wp,F.map.depthTexture.minFilter=pn,F.map.depthTexture.magFilter=pn):(F.map.depthTexture.compareFunction=null,F.map.depthTexture.minFilter=on,F.map.depthTexture.magFilter=on);F.camera.updateProjectionMatrix()}F.map.isWebGLCubeRenderTarget!==!0&&(F.map.width!==s.x||F.map.height!==s.y)&&F.map.setSize(s.x,s.y);let q=F.map.isWebGLCubeRenderTarget?6:F.getViewportCount();V.isPointLight!==!0&&F.updateMatrices(V,w);let W=(F.camera.layers.mask&4294967294)!==0?F.camera.layers:w.layers;for(let _e=0;_e<q;_e++){let Te=F.getCamera(_e);if(V.isPointLight){let K=F.camera,ae=F.matrix,se=V.distance||K.far;se!==K.far&&(K.far=se,K.updateProjectionMatrix()),ec.setFromMatrixPosition(V.matrixWorld),K.position.copy(ec),sm.copy(K.position),sm.add(LA[_e]),K.up.copy(OA[_e]),K.lookAt(sm),K.updateMatrixWorld(),ae.makeTranslation(-ec.x,-ec.y,-ec.z),Xy.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),F._frustum.setFromProjectionMatrix(Xy,K.coordinateSystem,K.reversedDepth)}if(F.map.isWebGLCubeRenderTarget)i.setRenderTarget(F.map,_e),i.clear();else{_e===0&&(i.setRenderTarget(F.map),i.clear());let K=F.getViewport(_e);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),O.viewport(o)}n=F.getFrustum(_e),b(p,w,Te,V,W,this.type)}F.isPointLightShadow!==!0&&this.type===jo&&v(F,w),F.needsUpdate=!1}_=this.type,m.needsUpdate=!1,i.setRenderTarget(T,E,C)};function v(y,p){let w=e.update(x);d.defines.VSM_SAMPLES!==y.blurSamples&&(d.defines.VSM_SAMPLES=y.blurSamples,f.defines.VSM_SAMPLES=y.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),y.mapPass===null?y.mapPass=new Vn(s.x,s.y,{format:pr,type:zi}):(y.mapPass.width!==y.map.width||y.mapPass.height!==y.map.height)&&y.mapPass.setSize(y.map.width,y.map.height),d.uniforms.shadow_pass.value=y.map.depthTexture,d.uniforms.resolution.value.set(y.map.width,y.map.height),d.uniforms.radius.value=y.radius,i.setRenderTarget(y.mapPass),i.clear(),i.renderBufferDirect(p,null,w,d,x,null),f.uniforms.shadow_pass.value=y.mapPass.texture,f.uniforms.resolution.value.set(y.map.width,y.map.height),f.uniforms.radius.value=y.radius,i.setRenderTarget(y.map),i.clear(),i.renderBufferDirect(p,null,w,f,x,null)}function M(y,p,w,T){let E=null,C=w.isPointLight===!0?y.customDistanceMaterial:y.customDepthMaterial;if(C!==void 0)E=C;else if(E=w.isPointLight===!0?l:a,i.localClippingEnabled&&p.clipShadows===!0&&Array.isArray(p.clippingPlanes)&&p.clippingPlanes.length!==0||p.displacementMap&&p.displacementScale!==0||p.alphaMap&&p.alphaTest>0||p.map&&p.alphaTest>0||p.alphaToCoverage===!0){let O=E.uuid,U=p.uuid,I=c[O];I===void 0&&(I={},c[O]=I);let D=I[U];D===void 0&&(D=E.clone(),I[U]=D,p.addEventListener("dispose",S)),E=D}if(E.visible=p.visible,E.wireframe=p.wireframe,T===jo?E.side=p.shadowSide!==null?p.shadowSide:p.side:E.side=p.shadowSide!==null?p.shadowSide:h[p.side],E.alphaMap=p.alphaMap,E.alphaTest=p.alphaToCoverage===!0?.5:p.alphaTest,E.map=p.map,E.clipShadows=p.clipShadows,E.clippingPlanes=p.clippingPlanes,E.clipIntersection=p.clipIntersection,E.displacementMap=p.displacementMap,E.displacementScale=p.displacementScale,E.displacementBias=p.displacementBias,E.wireframeLinewidth=p.wireframeLinewidth,E.linewidth=p.linewidth,w.isPointLight===!0&&E.isMeshDistanceMaterial===!0){let O=i.properties.get(E);O.light=w}return E}function b(y,p,w,T,E,C){if(y.visible===!1)return;if(y.layers.test(E)&&(y.isMesh||y.isLine||y.isPoints)&&(y.castShadow||y.receiveShadow&&C===jo)&&(!y.frustumCulled||y.intersectsFrustum(n))){y.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,y.matrixWorld);let I=e.update(y),D=y.material;if(Array.isArray(D)){let V=I.groups;for(let F=0,ie=V.length;F<ie;F++){let z=V[F],q=D[z.materialIndex];if(q&&q.visible){let W=M(y,q,T,C);y.onBeforeShadow(i,y,p,w,I,W,z),i.renderBufferDirect(w,null,I,W,y,z),y.onAfterShadow(i,y,p,w,I,W,z)}}}else if(D.visible){let V=M(y,D,T,C);y.onBeforeShadow(i,y,p,w,I,V,null),i.renderBufferDirect(w,null,I,V,y,null),y.onAfterShadow(i,y,p,w,I,V,null)}}let U=y.children;for(let I=0,D=U.length;I<D;I++)b(U[I],p,w,T,E,C)}function S(y){y.target.removeEventListener("dispose",S);for(let w in c){let T=c[w],E=y.target.uuid;E in T&&(T[E].dispose(),delete T[E])}}}function DA(i,e){function t(){let N=!1,ee=new ct,j=null,ge=new ct(0,0,0,0);return{setMask:function(he){j!==he&&!N&&(i.colorMask(he,he,he,he),j=he)},setLocked:function(he){N=he},setClear:function(he,pe,ze,it,le){le===!0&&(he*=it,pe*=it,ze*=it),ee.set(he,pe,ze,it),ge.equals(ee)===!1&&(i.clearColor(he,pe,ze,it),ge.copy(ee))},reset:function(){N=!1,j=null,ge.set(-1,0,0,0)}}}function n(){let N=!1,ee=!1,j=null,ge=null,he=null;return{setReversed:function(pe){if(ee!==pe){let ze=e.get("EXT_clip_control");pe?ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.ZERO_TO_ONE_EXT):ze.clipControlEXT(ze.LOWER_LEFT_EXT,ze.NEGATIVE_ONE_TO_ONE_EXT),ee=pe;let it=he;he=null,this.setClear(it)}},getReversed:function(){return ee},setTest:function(pe){pe?re(i.DEPTH_TEST):de(i.DEPTH_TEST)},setMask:function(pe){j!==pe&&!N&&(i.depthMask(pe),j=pe)},setFunc:function(pe){if(ee&&(pe=by[pe]),ge!==pe){switch(pe){case Gu:i.depthFunc(i.NEVER);break;case Wu:i.depthFunc(i.ALWAYS);break;case Xu:i.depthFunc(i.LESS);break;case Fo:i.depthFunc(i.LEQUAL);break;case qu:i.depthFunc(i.EQUAL);break;case Yu:i.depthFunc(i.GEQUAL);break;case $u:i.depthFunc(i.GREATER);break;case Ku:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ge=pe}},setLocked:function(pe){N=pe},setClear:function(pe){he!==pe&&(he=pe,ee&&(pe=1-pe),i.clearDepth(pe))},reset:function(){N=!1,j=null,ge=null,he=null,ee=!1}}}function s(){let N=!1,ee=null,j=null,ge=null,he=null,pe=null,ze=null,it=null,le=null;return{setTest:function(Ge){N||(Ge?re(i.STENCIL_TEST):de(i.STENCIL_TEST))},setMask:function(Ge){ee!==Ge&&!N&&(i.stencilMask(Ge),ee=Ge)},setFunc:function(Ge,et,Me){(j!==Ge||ge!==et||he!==Me)&&(i.stencilFunc(Ge,et,Me),j=Ge,ge=et,he=Me)},setOp:function(Ge,et,Me){(pe!==Ge||ze!==et||it!==Me)&&(i.stencilOp(Ge,et,Me),pe=Ge,ze=et,it=Me)},setLocked:function(Ge){N=Ge},setClear:function(Ge){le!==Ge&&(i.clearStencil(Ge),le=Ge)},reset:function(){N=!1,ee=null,j=null,ge=null,he=null,pe=null,ze=null,it=null,le=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],x=null,m=!1,_=null,v=null,M=null,b=null,S=null,y=null,p=null,w=new Ue(0,0,0),T=0,E=!1,C=null,O=null,U=null,I=null,D=null,V=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),F=!1,ie=0,z=i.getParameter(i.VERSION);z.indexOf("WebGL")!==-1?(ie=parseFloat(/^WebGL (\d)/.exec(z)[1]),F=ie>=1):z.indexOf("OpenGL ES")!==-1&&(ie=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),F=ie>=2);let q=null,W={},_e=i.getParameter(i.SCISSOR_BOX),Te=i.getParameter(i.VIEWPORT),K=new ct().fromArray(_e),ae=new ct().fromArray(Te);function se(N,ee,j,ge){let he=new Uint8Array(4),pe=i.createTexture();i.bindTexture(N,pe),i.texParameteri(N,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(N,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let ze=0;ze<j;ze++)N===i.TEXTURE_3D||N===i.TEXTURE_2D_ARRAY?i.texImage3D(ee,0,i.RGBA,1,1,ge,0,i.RGBA,i.UNSIGNED_BYTE,he):i.texImage2D(ee+ze,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,he);return pe}let ue={};ue[i.TEXTURE_2D]=se(i.TEXTURE_2D,i.TEXTURE_2D,1),ue[i.TEXTURE_CUBE_MAP]=se(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),ue[i.TEXTURE_2D_ARRAY]=se(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),ue[i.TEXTURE_3D]=se(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),re(i.DEPTH_TEST),o.setFunc(Fo),at(!1),Qe(Mp),re(i.CULL_FACE),gt(as);function re(N){u[N]!==!0&&(i.enable(N),u[N]=!0)}function de(N){u[N]!==!1&&(i.disable(N),u[N]=!1)}function $e(N,ee){return d[N]!==ee?(i.bindFramebuffer(N,ee),d[N]=ee,N===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=ee),N===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=ee),!0):!1}function Ae(N,ee){let j=g,ge=!1;if(N){j=f.get(ee),j===void 0&&(j=[],f.set(ee,j));let he=N.textures;if(j.length!==he.length||j[0]!==i.COLOR_ATTACHMENT0){for(let pe=0,ze=he.length;pe<ze;pe++)j[pe]=i.COLOR_ATTACHMENT0+pe;j.length=he.length,ge=!0}}else j[0]!==i.BACK&&(j[0]=i.BACK,ge=!0);ge&&i.drawBuffers(j)}function Ve(N){return x!==N?(i.useProgram(N),x=N,!0):!1}let Le={[Jr]:i.FUNC_ADD,[G_]:i.FUNC_SUBTRACT,[W_]:i.FUNC_REVERSE_SUBTRACT};Le[X_]=i.MIN,Le[q_]=i.MAX;let we={[Y_]:i.ZERO,[$_]:i.ONE,[K_]:i.SRC_COLOR,[Rp]:i.SRC_ALPHA,[ty]:i.SRC_ALPHA_SATURATE,[Q_]:i.DST_COLOR,[j_]:i.DST_ALPHA,[J_]:i.ONE_MINUS_SRC_COLOR,[Cp]:i.ONE_MINUS_SRC_ALPHA,[ey]:i.ONE_MINUS_DST_COLOR,[Z_]:i.ONE_MINUS_DST_ALPHA,[ny]:i.CONSTANT_COLOR,[iy]:i.ONE_MINUS_CONSTANT_COLOR,[sy]:i.CONSTANT_ALPHA,[ry]:i.ONE_MINUS_CONSTANT_ALPHA};function gt(N,ee,j,ge,he,pe,ze,it,le,Ge){if(N===as){m===!0&&(de(i.BLEND),m=!1);return}if(m===!1&&(re(i.BLEND),m=!0),N!==H_){if(N!==_||Ge!==E){if((v!==Jr||S!==Jr)&&(i.blendEquation(i.FUNC_ADD),v=Jr,S=Jr),Ge)switch(N){case Zo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ep:i.blendFunc(i.ONE,i.ONE);break;case Tp:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Ap:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:qe("WebGLState: Invalid blending: ",N);break}else switch(N){case Zo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Ep:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Tp:qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ap:qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:qe("WebGLState: Invalid blending: ",N);break}M=null,b=null,y=null,p=null,w.set(0,0,0),T=0,_=N,E=Ge}return}he=he||ee,pe=pe||j,ze=ze||ge,(ee!==v||he!==S)&&(i.blendEquationSeparate(Le[ee],Le[he]),v=ee,S=he),(j!==M||ge!==b||pe!==y||ze!==p)&&(i.blendFuncSeparate(we[j],we[ge],we[pe],we[ze]),M=j,b=ge,y=pe,p=ze),(it.equals(w)===!1||le!==T)&&(i.blendColor(it.r,it.g,it.b,le),w.copy(it),T=le),_=N,E=!1}function We(N,ee){N.side===un?de(i.CULL_FACE):re(i.CULL_FACE);let j=N.side===An;ee&&(j=!j),at(j),N.blending===Zo&&N.transparent===!1?gt(as):gt(N.blending,N.blendEquation,N.blendSrc,N.blendDst,N.blendEquationAlpha,N.blendSrcAlpha,N.blendDstAlpha,N.blendColor,N.blendAlpha,N.premultipliedAlpha),o.setFunc(N.depthFunc),o.setTest(N.depthTest),o.setMask(N.depthWrite),r.setMask(N.colorWrite);let ge=N.stencilWrite;a.setTest(ge),ge&&(a.setMask(N.stencilWriteMask),a.setFunc(N.stencilFunc,N.stencilRef,N.stencilFuncMask),a.setOp(N.stencilFail,N.stencilZFail,N.stencilZPass)),Ot(N.polygonOffset,N.polygonOffsetFactor,N.polygonOffsetUnits),N.alphaToCoverage===!0?re(i.SAMPLE_ALPHA_TO_COVERAGE):de(i.SAMPLE_ALPHA_TO_COVERAGE)}function at(N){C!==N&&(N?i.frontFace(i.CW):i.frontFace(i.CCW),C=N)}function Qe(N){N!==B_?(re(i.CULL_FACE),N!==O&&(N===Mp?i.cullFace(i.BACK):N===z_?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):de(i.CULL_FACE),O=N}function Mn(N){N!==U&&(F&&i.lineWidth(N),U=N)}function Ot(N,ee,j){N?(re(i.POLYGON_OFFSET_FILL),(I!==ee||D!==j)&&(I=ee,D=j,o.getReversed()&&(ee=-ee,j=-j),i.polygonOffset(ee,j))):de(i.POLYGON_OFFSET_FILL)}function yn(N){N?re(i.SCISSOR_TEST):de(i.SCISSOR_TEST)}function At(N){N===void 0&&(N=i.TEXTURE0+V-1),q!==N&&(i.activeTexture(N),q=N)}function Jt(N,ee,j){j===void 0&&(q===null?j=i.TEXTURE0+V-1:j=q);let ge=W[j];ge===void 0&&(ge={type:void 0,texture:void 0},W[j]=ge),(ge.type!==N||ge.texture!==ee)&&(q!==j&&(i.activeTexture(j),q=j),i.bindTexture(N,ee||ue[N]),ge.type=N,ge.texture=ee)}function B(){let N=W[q];N!==void 0&&N.type!==void 0&&(i.bindTexture(N.type,null),N.type=void 0,N.texture=void 0)}function kt(){try{i.compressedTexImage2D(...arguments)}catch(N){qe("WebGLState:",N)}}function _t(){try{i.compressedTexImage3D(...arguments)}catch(N){qe("WebGLState:",N)}}function Ut(){try{i.texSubImage2D(...arguments)}catch(N){qe("WebGLState:",N)}}function xe(){try{i.texSubImage3D(...arguments)}catch(N){qe("WebGLState:",N)}}function Wt(){try{i.compressedTexSubImage2D(...arguments)}catch(N){qe("WebGLState:",N)}}function Oe(){try{i.compressedTexSubImage3D(...arguments)}catch(N){qe("WebGLState:",N)}}function Xe(){try{i.texStorage2D(...arguments)}catch(N){qe("WebGLState:",N)}}function L(){try{i.texStorage3D(...arguments)}catch(N){qe("WebGLState:",N)}}function A(){try{i.texImage2D(...arguments)}catch(N){qe("WebGLState:",N)}}function G(){try{i.texImage3D(...arguments)}catch(N){qe("WebGLState:",N)}}function oe(N){return h[N]!==void 0?h[N]:i.getParameter(N)}function ne(N,ee){h[N]!==ee&&(i.pixelStorei(N,ee),h[N]=ee)}function fe(N){K.equals(N)===!1&&(i.scissor(N.x,N.y,N.z,N.w),K.copy(N))}function ve(N){ae.equals(N)===!1&&(i.viewport(N.x,N.y,N.z,N.w),ae.copy(N))}function Z(N,ee){let j=c.get(ee);j===void 0&&(j=new WeakMap,c.set(ee,j));let ge=j.get(N);ge===void 0&&(ge=i.getUniformBlockIndex(ee,N.name),i.uniformBlockBinding(ee,ge,ge),j.set(N,ge))}function Q(N,ee,j){let he=c.get(ee).get(N);l[he]!==j&&(i.bindBufferBase(i.UNIFORM_BUFFER,he,j),l[he]=j)}function me(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},q=null,W={},d={},l={},f=new WeakMap,g=[],x=null,m=!1,_=null,v=null,M=null,b=null,S=null,y=null,p=null,w=new Ue(0,0,0),T=0,E=!1,C=null,O=null,U=null,I=null,D=null,K.set(0,0,i.canvas.width,i.canvas.height),ae.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:re,disable:de,bindFramebuffer:$e,drawBuffers:Ae,useProgram:Ve,setBlending:gt,setMaterial:We,setFlipSided:at,setCullFace:Qe,setLineWidth:Mn,setPolygonOffset:Ot,setScissorTest:yn,activeTexture:At,bindTexture:Jt,unbindTexture:B,compressedTexImage2D:kt,compressedTexImage3D:_t,texImage2D:A,texImage3D:G,pixelStorei:ne,getParameter:oe,updateUBOMapping:Z,uniformBlockBinding:Q,texStorage2D:Xe,texStorage3D:L,texSubImage2D:Ut,texSubImage3D:xe,compressedTexSubImage2D:Wt,compressedTexSubImage3D:Oe,scissor:fe,viewport:ve,reset:me}}function UA(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ke,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,x=new FinalizationRegistry(L=>g.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(L,A){return m?new OffscreenCanvas(L,A):zo("canvas")}function v(L,A,G){let oe=1,ne=Xe(L);if((ne.width>G||ne.height>G)&&(oe=G/Math.max(ne.width,ne.height)),oe<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let fe=Math.floor(oe*ne.width),ve=Math.floor(oe*ne.height);d===void 0&&(d=_(fe,ve));let Z=A?_(fe,ve):d;return Z.width=fe,Z.height=ve,Z.getContext("2d").drawImage(L,0,0,fe,ve),Fe("WebGLRenderer: Texture has been resized from ("+ne.width+"x"+ne.height+") to ("+fe+"x"+ve+")."),Z}else return"data"in L&&Fe("WebGLRenderer: Image in DataTexture is too big ("+ne.width+"x"+ne.height+")."),L;return L}function M(L){return L.generateMipmaps}function b(L){i.generateMipmap(L)}function S(L){return L.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?i.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function y(L,A,G,oe,ne,fe=!1){if(L!==null){if(i[L]!==void 0)return i[L];Fe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let ve;oe&&(ve=e.get("EXT_texture_norm16"),ve||Fe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=A;if(A===i.RED&&(G===i.FLOAT&&(Z=i.R32F),G===i.HALF_FLOAT&&(Z=i.R16F),G===i.UNSIGNED_BYTE&&(Z=i.R8),G===i.UNSIGNED_SHORT&&ve&&(Z=ve.R16_EXT),G===i.SHORT&&ve&&(Z=ve.R16_SNORM_EXT)),A===i.RED_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.R8UI),G===i.UNSIGNED_SHORT&&(Z=i.R16UI),G===i.UNSIGNED_INT&&(Z=i.R32UI),G===i.BYTE&&(Z=i.R8I),G===i.SHORT&&(Z=i.R16I),G===i.INT&&(Z=i.R32I)),A===i.RG&&(G===i.FLOAT&&(Z=i.RG32F),G===i.HALF_FLOAT&&(Z=i.RG16F),G===i.UNSIGNED_BYTE&&(Z=i.RG8),G===i.UNSIGNED_SHORT&&ve&&(Z=ve.RG16_EXT),G===i.SHORT&&ve&&(Z=ve.RG16_SNORM_EXT)),A===i.RG_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.RG8UI),G===i.UNSIGNED_SHORT&&(Z=i.RG16UI),G===i.UNSIGNED_INT&&(Z=i.RG32UI),G===i.BYTE&&(Z=i.RG8I),G===i.SHORT&&(Z=i.RG16I),G===i.INT&&(Z=i.RG32I)),A===i.RGB_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),G===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),G===i.UNSIGNED_INT&&(Z=i.RGB32UI),G===i.BYTE&&(Z=i.RGB8I),G===i.SHORT&&(Z=i.RGB16I),G===i.INT&&(Z=i.RGB32I)),A===i.RGBA_INTEGER&&(G===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),G===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),G===i.UNSIGNED_INT&&(Z=i.RGBA32UI),G===i.BYTE&&(Z=i.RGBA8I),G===i.SHORT&&(Z=i.RGBA16I),G===i.INT&&(Z=i.RGBA32I)),A===i.RGB&&(G===i.UNSIGNED_SHORT&&ve&&(Z=ve.RGB16_EXT),G===i.SHORT&&ve&&(Z=ve.RGB16_SNORM_EXT),G===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),G===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),A===i.RGBA){let Q=fe?gl:st.getTransfer(ne);G===i.FLOAT&&(Z=i.RGBA32F),G===i.HALF_FLOAT&&(Z=i.RGBA16F),G===i.UNSIGNED_BYTE&&(Z=Q===Ct?i.SRGB8_ALPHA8:i.RGBA8),G===i.UNSIGNED_SHORT&&ve&&(Z=ve.RGBA16_EXT),G===i.SHORT&&ve&&(Z=ve.RGBA16_SNORM_EXT),G===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),G===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&e.get("EXT_color_buffer_float"),Z}function p(L,A){let G;return L?A===null||A===Ri||A===Qr?G=i.DEPTH24_STENCIL8:A===$n?G=i.DEPTH32F_STENCIL8:A===ta&&(G=i.DEPTH24_STENCIL8,Fe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):A===null||A===Ri||A===Qr?G=i.DEPTH_COMPONENT24:A===$n?G=i.DEPTH_COMPONENT32F:A===ta&&(G=i.DEPTH_COMPONENT16),G}function w(L,A){return M(L)===!0||L.isFramebufferTexture&&L.minFilter!==on&&L.minFilter!==pn?Math.log2(Math.max(A.width,A.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?A.mipmaps.length:1}function T(L){let A=new WeakRef(L);n.get(L).__ref=A,g.add(A),x.register(L,A,A)}function E(L){let A=n.get(L).__ref;A!==void 0&&(g.delete(A),x.unregister(A))}function C(L){U(L.target)}function O(L){I(L.target)}function U(L){L.removeEventListener("dispose",C),E(L),V(L),L.isVideoTexture&&u.delete(L),L.isHTMLTexture&&h.delete(L)}function I(L){L.removeEventListener("dispose",O),E(L),ie(L)}function D(){for(let L of g){let A=L.deref();A!==void 0&&(A.isRenderTarget===!0?I(A):U(A))}g.clear(),h.clear()}function V(L){let A=n.get(L);if(A.__webglInit===void 0)return;let G=L.source,oe=f.get(G);if(oe){let ne=oe[A.__cacheKey];ne.usedTimes--,ne.usedTimes===0&&F(L),Object.keys(oe).length===0&&f.delete(G)}n.remove(L)}function F(L){let A=n.get(L);i.deleteTexture(A.__webglTexture);let G=L.source,oe=f.get(G);delete oe[A.__cacheKey],o.memory.textures--}function ie(L){let A=n.get(L);A.__depthDisposeCallback&&A.__depthDisposeCallback();let G=L.depthTexture;if(G&&G.renderTarget===L&&U(G),L.isWebGLCubeRenderTarget)for(let ne=0;ne<6;ne++){if(Array.isArray(A.__webglFramebuffer[ne]))for(let fe=0;fe<A.__webglFramebuffer[ne].length;fe++)i.deleteFramebuffer(A.__webglFramebuffer[ne][fe]);else i.deleteFramebuffer(A.__webglFramebuffer[ne]);A.__webglDepthbuffer&&i.deleteRenderbuffer(A.__webglDepthbuffer[ne])}else{if(Array.isArray(A.__webglFramebuffer))for(let ne=0;ne<A.__webglFramebuffer.length;ne++)i.deleteFramebuffer(A.__webglFramebuffer[ne]);else i.deleteFramebuffer(A.__webglFramebuffer);if(A.__webglDepthbuffer&&i.deleteRenderbuffer(A.__webglDepthbuffer),A.__webglMultisampledFramebuffer&&i.deleteFramebuffer(A.__webglMultisampledFramebuffer),A.__webglColorRenderbuffer)for(let ne=0;ne<A.__webglColorRenderbuffer.length;ne++)A.__webglColorRenderbuffer[ne]&&i.deleteRenderbuffer(A.__webglColorRenderbuffer[ne]);A.__webglDepthRenderbuffer&&i.deleteRenderbuffer(A.__webglDepthRenderbuffer)}let oe=L.textures;for(let ne=0,fe=oe.length;ne<fe;ne++){let ve=n.get(oe[ne]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(oe[ne])}n.remove(L)}let z=0;function q(){z=0}function W(){return z}function _e(L){z=L}function Te(){let L=z;return L>=s.maxTextures&&Fe("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),z+=1,L}function K(L){let A=[];return A.push(L.wrapS),A.push(L.wrapT),A.push(L.wrapR||0),A.push(L.magFilter),A.push(L.minFilter),A.push(L.anisotropy),A.push(L.internalFormat),A.push(L.format),A.push(L.type),A.push(L.generateMipmaps),A.push(L.mipmapsAutoUpdate),A.push(L.premultiplyAlpha),A.push(L.flipY),A.push(L.unpackAlignment),A.push(L.colorSpace),A.join()}function ae(L,A){let G=n.get(L);if(L.isVideoTexture&&Wt(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&G.__version!==L.version){let oe=L.image;if(oe===null)Fe("WebGLRenderer: Texture marked for update but no image data found.");else if(oe.complete===!1)Fe("WebGLRenderer: Texture marked for update but image is incomplete");else{We(G,L,A);return}}else L.isExternalTexture&&(G.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,G.__webglTexture,i.TEXTURE0+A)}function se(L,A){let G=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&G.__version!==L.version){We(G,L,A);return}else L.isExternalTexture&&(G.__webglTexture=L.sourceTexture?L.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,G.__webglTexture,i.TEXTURE0+A)}function ue(L,A){let G=n.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&G.__version!==L.version){We(G,L,A);return}t.bindTexture(i.TEXTURE_3D,G.__webglTexture,i.TEXTURE0+A)}function re(L,A){let G=n.get(L);if(L.version>0&&G.__version!==L.version){at(G,L,A);return}t.bindTexture(i.TEXTURE_CUBE_MAP,G.__webglTexture,i.TEXTURE0+A)}let de={[lr]:i.REPEAT,[Mi]:i.CLAMP_TO_EDGE,[ko]:i.MIRRORED_REPEAT},$e={[on]:i.NEAREST,[mh]:i.NEAREST_MIPMAP_NEAREST,[Zr]:i.NEAREST_MIPMAP_LINEAR,[pn]:i.LINEAR,[ea]:i.LINEAR_MIPMAP_NEAREST,[Ai]:i.LINEAR_MIPMAP_LINEAR},Ae={[fy]:i.NEVER,[qp]:i.ALWAYS,[py]:i.LESS,[Wp]:i.LEQUAL,[my]:i.EQUAL,[Xp]:i.GEQUAL,[gy]:i.GREATER,[_y]:i.NOTEQUAL};function Ve(L,A){if(A.type===$n&&e.has("OES_texture_float_linear")===!1&&(A.magFilter===pn||A.magFilter===ea||A.magFilter===Zr||A.magFilter===Ai||A.minFilter===pn||A.minFilter===ea||A.minFilter===Zr||A.minFilter===Ai)&&Fe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(L,i.TEXTURE_WRAP_S,de[A.wrapS]),i.texParameteri(L,i.TEXTURE_WRAP_T,de[A.wrapT]),(L===i.TEXTURE_3D||L===i.TEXTURE_2D_ARRAY)&&i.texParameteri(L,i.TEXTURE_WRAP_R,de[A.wrapR]),i.texParameteri(L,i.TEXTURE_MAG_FILTER,$e[A.magFilter]),i.texParameteri(L,i.TEXTURE_MIN_FILTER,$e[A.minFilter]),A.compareFunction&&(i.texParameteri(L,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(L,i.TEXTURE_COMPARE_FUNC,Ae[A.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(A.magFilter===on||A.minFilter!==Zr&&A.minFilter!==Ai||A.type===$n&&e.has("OES_texture_float_linear")===!1)return;if(A.anisotropy>1||n.get(A).__currentAnisotropy){let G=e.get("EXT_texture_filter_anisotropic");i.texParameterf(L,G.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(A.anisotropy,s.getMaxAnisotropy())),n.get(A).__currentAnisotropy=A.anisotropy}}}function Le(L,A){let G=!1;L.__webglInit===void 0&&(L.__webglInit=!0,A.addEventListener("dispose",C),T(A));let oe=A.source,ne=f.get(oe);ne===void 0&&(ne={},f.set(oe,ne));let fe=K(A);if(fe!==L.__cacheKey){ne[fe]===void 0&&(ne[fe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,G=!0),ne[fe].usedTimes++;let ve=ne[L.__cacheKey];ve!==void 0&&(ne[L.__cacheKey].usedTimes--,ve.usedTimes===0&&F(A)),L.__cacheKey=fe,L.__webglTexture=ne[fe].texture}return G}function we(L,A,G){return Math.floor(Math.floor(L/G)/A)}function gt(L,A,G,oe){let fe=L.updateRanges;if(fe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,A.width,A.height,G,oe,A.data);else{fe.sort((N,ee)=>N.start-ee.start);let ve=0;for(let N=1;N<fe.length;N++){let ee=fe[ve],j=fe[N],ge=ee.start+ee.count,he=we(j.start,A.width,4),pe=we(ee.start,A.width,4);j.start<=ge+1&&he===pe&&we(j.start+j.count-1,A.width,4)===he?ee.count=Math.max(ee.count,j.start+j.count-ee.start):(++ve,fe[ve]=j)}fe.length=ve+1;let Z=t.getParameter(i.UNPACK_ROW_LENGTH),Q=t.getParameter(i.UNPACK_SKIP_PIXELS),me=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,A.width);for(let N=0,ee=fe.length;N<ee;N++){let j=fe[N],ge=Math.floor(j.start/4),he=Math.ceil(j.count/4),pe=ge%A.width,ze=Math.floor(ge/A.width),it=he,le=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,pe),t.pixelStorei(i.UNPACK_SKIP_ROWS,ze),t.texSubImage2D(i.TEXTURE_2D,0,pe,ze,it,le,G,oe,A.data)}L.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,Z),t.pixelStorei(i.UNPACK_SKIP_PIXELS,Q),t.pixelStorei(i.UNPACK_SKIP_ROWS,me)}}function We(L,A,G){let oe=i.TEXTURE_2D;(A.isDataArrayTexture||A.isCompressedArrayTexture)&&(oe=i.TEXTURE_2D_ARRAY),A.isData3DTexture&&(oe=i.TEXTURE_3D);let ne=Le(L,A),fe=A.source;t.bindTexture(oe,L.__webglTexture,i.TEXTURE0+G);let ve=n.get(fe);if(fe.version!==ve.__version||ne===!0){if(t.activeTexture(i.TEXTURE0+G),(typeof ImageBitmap<"u"&&A.image instanceof ImageBitmap)===!1){let le=st.getPrimaries(st.workingColorSpace),Ge=A.colorSpace===Ks?null:st.getPrimaries(A.colorSpace),et=A.colorSpace===Ks||le===Ge?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,A.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,et)}t.pixelStorei(i.UNPACK_ALIGNMENT,A.unpackAlignment);let Q=v(A.image,!1,s.maxTextureSize);Q=Oe(A,Q);let me=r.convert(A.format,A.colorSpace),N=r.convert(A.type),ee=y(A.internalFormat,me,N,A.normalized,A.colorSpace,A.isVideoTexture);Ve(oe,A);let j,ge=A.mipmaps,he=A.isVideoTexture!==!0,pe=ve.__version===void 0||ne===!0,ze=fe.dataReady,it=w(A,Q);if(A.isDepthTexture)ee=p(A.format===$s,A.type),pe&&(he?t.texStorage2D(i.TEXTURE_2D,1,ee,Q.width,Q.height):t.texImage2D(i.TEXTURE_2D,0,ee,Q.width,Q.height,0,me,N,null));else if(A.isDataTexture)if(ge.length>0){he&&pe&&t.texStorage2D(i.TEXTURE_2D,it,ee,ge[0].width,ge[0].height);for(let le=0,Ge=ge.length;le<Ge;le++)j=ge[le],he?ze&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,j.width,j.height,me,N,j.data):t.texImage2D(i.TEXTURE_2D,le,ee,j.width,j.height,0,me,N,j.data);A.generateMipmaps=!1}else he?(pe&&t.texStorage2D(i.TEXTURE_2D,it,ee,Q.width,Q.height),ze&&gt(A,Q,me,N)):t.texImage2D(i.TEXTURE_2D,0,ee,Q.width,Q.height,0,me,N,Q.data);else if(A.isCompressedTexture)if(A.isCompressedArrayTexture){he&&pe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,it,ee,ge[0].width,ge[0].height,Q.depth);for(let le=0,Ge=ge.length;le<Ge;le++)if(j=ge[le],A.format!==ii)if(me!==null)if(he){if(ze)if(A.layerUpdates.size>0){let et=nm(j.width,j.height,A.format,A.type);for(let Me of A.layerUpdates){let Nt=j.data.subarray(Me*et/j.data.BYTES_PER_ELEMENT,(Me+1)*et/j.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,Me,j.width,j.height,1,me,Nt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,j.width,j.height,Q.depth,me,j.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,le,ee,j.width,j.height,Q.depth,0,j.data,0,0);else Fe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else he?ze&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,le,0,0,0,j.width,j.height,Q.depth,me,N,j.data):t.texImage3D(i.TEXTURE_2D_ARRAY,le,ee,j.width,j.height,Q.depth,0,me,N,j.data);A.layerUpdates.size>0&&A.clearLayerUpdates()}else{he&&pe&&t.texStorage2D(i.TEXTURE_2D,it,ee,ge[0].width,ge[0].height);for(let le=0,Ge=ge.length;le<Ge;le++)j=ge[le],A.format!==ii?me!==null?he?ze&&t.compressedTexSubImage2D(i.TEXTURE_2D,le,0,0,j.width,j.height,me,j.data):t.compressedTexImage2D(i.TEXTURE_2D,le,ee,j.width,j.height,0,j.data):Fe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):he?ze&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,j.width,j.height,me,N,j.data):t.texImage2D(i.TEXTURE_2D,le,ee,j.width,j.height,0,me,N,j.data)}else if(A.isDataArrayTexture)if(he){if(pe&&t.texStorage3D(i.TEXTURE_2D_ARRAY,it,ee,Q.width,Q.height,Q.depth),ze)if(A.layerUpdates.size>0){let le=nm(Q.width,Q.height,A.format,A.type);for(let Ge of A.layerUpdates){let et=Q.data.subarray(Ge*le/Q.data.BYTES_PER_ELEMENT,(Ge+1)*le/Q.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ge,Q.width,Q.height,1,me,N,et)}A.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Q.width,Q.height,Q.depth,me,N,Q.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ee,Q.width,Q.height,Q.depth,0,me,N,Q.data);else if(A.isData3DTexture)he?(pe&&t.texStorage3D(i.TEXTURE_3D,it,ee,Q.width,Q.height,Q.depth),ze&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Q.width,Q.height,Q.depth,me,N,Q.data)):t.texImage3D(i.TEXTURE_3D,0,ee,Q.width,Q.height,Q.depth,0,me,N,Q.data);else if(A.isFramebufferTexture){if(pe)if(he)t.texStorage2D(i.TEXTURE_2D,it,ee,Q.width,Q.height);else{let le=Q.width,Ge=Q.height;for(let et=0;et<it;et++)t.texImage2D(i.TEXTURE_2D,et,ee,le,Ge,0,me,N,null),le>>=1,Ge>>=1}}else if(A.isHTMLTexture){if("texElementImage2D"in i){let le=i.canvas;if(le.hasAttribute("layoutsubtree")||le.setAttribute("layoutsubtree","true"),Q.parentNode!==le){le.appendChild(Q),h.add(A),le.onpaint=Ge=>{let et=Ge.changedElements;for(let Me of h)et.includes(Me.image)&&(Me.needsUpdate=!0)},le.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Q);else{let et=i.RGBA,Me=i.RGBA,Nt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,et,Me,Nt,Q)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ge.length>0){if(he&&pe){let le=Xe(ge[0]);t.texStorage2D(i.TEXTURE_2D,it,ee,le.width,le.height)}for(let le=0,Ge=ge.length;le<Ge;le++)j=ge[le],he?ze&&t.texSubImage2D(i.TEXTURE_2D,le,0,0,me,N,j):t.texImage2D(i.TEXTURE_2D,le,ee,me,N,j);A.generateMipmaps=!1}else if(he){if(pe){let le=Xe(Q);t.texStorage2D(i.TEXTURE_2D,it,ee,le.width,le.height)}ze&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,me,N,Q)}else t.texImage2D(i.TEXTURE_2D,0,ee,me,N,Q);M(A)&&A.mipmapsAutoUpdate===!0&&b(oe),ve.__version=fe.version,A.onUpdate&&A.onUpdate(A)}L.__version=A.version}function at(L,A,G){if(A.image.length!==6)return;let oe=Le(L,A),ne=A.source;t.bindTexture(i.TEXTURE_CUBE_MAP,L.__webglTexture,i.TEXTURE0+G);let fe=n.get(ne);if(ne.version!==fe.__version||oe===!0){t.activeTexture(i.TEXTURE0+G);let ve=st.getPrimaries(st.workingColorSpace),Z=A.colorSpace===Ks?null:st.getPrimaries(A.colorSpace),Q=A.colorSpace===Ks||ve===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,A.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,A.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Q);let me=A.isCompressedTexture||A.image[0].isCompressedTexture,N=A.image[0]&&A.image[0].isDataTexture,ee=[];for(let Me=0;Me<6;Me++)!me&&!N?ee[Me]=v(A.image[Me],!0,s.maxCubemapSize):ee[Me]=N?A.image[Me].image:A.image[Me],ee[Me]=Oe(A,ee[Me]);let j=ee[0],ge=r.convert(A.format,A.colorSpace),he=r.convert(A.type),pe=y(A.internalFormat,ge,he,A.normalized,A.colorSpace),ze=A.isVideoTexture!==!0,it=fe.__version===void 0||oe===!0,le=ne.dataReady,Ge=w(A,j);Ve(i.TEXTURE_CUBE_MAP,A);let et;if(A.isDepthTexture){if(pe=p(A.format===$s,A.type),it)if(ze)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,pe,j.width,j.height);else for(let Me=0;Me<6;Me++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,pe,j.width,j.height,0,ge,he,null)}else if(me){ze&&it&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,pe,j.width,j.height);for(let Me=0;Me<6;Me++){et=ee[Me].mipmaps;for(let Nt=0;Nt<et.length;Nt++){let xn=et[Nt];A.format!==ii?ge!==null?ze?le&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt,0,0,xn.width,xn.height,ge,xn.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt,pe,xn.width,xn.height,0,xn.data):Fe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):ze?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt,0,0,xn.width,xn.height,ge,he,xn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt,pe,xn.width,xn.height,0,ge,he,xn.data)}}}else{if(et=A.mipmaps,ze&&it){et.length>0&&Ge++;let Me=Xe(ee[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ge,pe,Me.width,Me.height)}for(let Me=0;Me<6;Me++)if(N){ze?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,0,0,ee[Me].width,ee[Me].height,ge,he,ee[Me].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,pe,ee[Me].width,ee[Me].height,0,ge,he,ee[Me].data);for(let Nt=0;Nt<et.length;Nt++){let er=et[Nt].image[Me].image;ze?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt+1,0,0,er.width,er.height,ge,he,er.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt+1,pe,er.width,er.height,0,ge,he,er.data)}}else{ze?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,0,0,ge,he,ee[Me]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,0,pe,ge,he,ee[Me]);for(let Nt=0;Nt<et.length;Nt++){let xn=et[Nt];ze?le&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt+1,0,0,ge,he,xn.image[Me]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Me,Nt+1,pe,ge,he,xn.image[Me])}}}M(A)&&A.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),fe.__version=ne.version,A.onUpdate&&A.onUpdate(A)}L.__version=A.version}function Qe(L,A,G,oe,ne,fe){let ve=r.convert(G.format,G.colorSpace),Z=r.convert(G.type),Q=y(G.internalFormat,ve,Z,G.normalized,G.colorSpace),me=n.get(A),N=n.get(G);if(N.__renderTarget=A,!me.__hasExternalTextures){let ee=Math.max(1,A.width>>fe),j=Math.max(1,A.height>>fe);ne===i.TEXTURE_3D||ne===i.TEXTURE_2D_ARRAY?t.texImage3D(ne,fe,Q,ee,j,A.depth,0,ve,Z,null):t.texImage2D(ne,fe,Q,ee,j,0,ve,Z,null)}t.bindFramebuffer(i.FRAMEBUFFER,L),xe(A)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,oe,ne,N.__webglTexture,0,Ut(A)):(ne===i.TEXTURE_2D||ne>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ne<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,oe,ne,N.__webglTexture,fe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Mn(L,A,G){if(i.bindRenderbuffer(i.RENDERBUFFER,L),A.depthBuffer){let oe=A.depthTexture,ne=oe&&oe.isDepthTexture?oe.type:null,fe=p(A.stencilBuffer,ne),ve=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;xe(A)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(A),fe,A.width,A.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(A),fe,A.width,A.height):i.renderbufferStorage(i.RENDERBUFFER,fe,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,L)}else{let oe=A.textures;for(let ne=0;ne<oe.length;ne++){let fe=oe[ne],ve=r.convert(fe.format,fe.colorSpace),Z=r.convert(fe.type),Q=y(fe.internalFormat,ve,Z,fe.normalized,fe.colorSpace);xe(A)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Ut(A),Q,A.width,A.height):G?i.renderbufferStorageMultisample(i.RENDERBUFFER,Ut(A),Q,A.width,A.height):i.renderbufferStorage(i.RENDERBUFFER,Q,A.width,A.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ot(L,A,G){let oe=A.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,L),!(A.depthTexture&&A.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ne=n.get(A.depthTexture);ne.__renderTarget=A;let fe=oe?A.depthTexture.image[0]:A.depthTexture.image;(!ne.__webglTexture||fe.width!==A.width||fe.height!==A.height)&&(fe.width=A.width,fe.height=A.height,A.depthTexture.needsUpdate=!0),oe?re(A.depthTexture,0):ae(A.depthTexture,0);let ve=ne.__webglTexture,Z=Ut(A),Q=oe?i.TEXTURE_CUBE_MAP_POSITIVE_X+G:i.TEXTURE_2D,me=A.depthTexture.format===$s?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(A.depthTexture.format===Fs)xe(A)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,Q,ve,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,me,Q,ve,0);else if(A.depthTexture.format===$s)xe(A)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,me,Q,ve,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,me,Q,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(L){let A=n.get(L),G=L.isWebGLCubeRenderTarget===!0;if(A.__boundDepthTexture!==L.depthTexture){let oe=L.depthTexture;if(A.__depthDisposeCallback&&A.__depthDisposeCallback(),oe){let ne=()=>{delete A.__boundDepthTexture,delete A.__depthDisposeCallback,oe.removeEventListener("dispose",ne)};oe.addEventListener("dispose",ne),A.__depthDisposeCallback=ne}A.__boundDepthTexture=oe}if(L.depthTexture&&!A.__autoAllocateDepthBuffer)if(G)for(let oe=0;oe<6;oe++)Ot(A.__webglFramebuffer[oe],L,oe);else L.texture.mipmaps.length>0?Ot(A.__webglFramebuffer[0],L,0):Ot(A.__webglFramebuffer,L,0);else if(G){A.__webglDepthbuffer=[];for(let oe=0;oe<6;oe++)if(t.bindFramebuffer(i.FRAMEBUFFER,A.__webglFramebuffer[oe]),A.__webglDepthbuffer[oe]===void 0)A.__webglDepthbuffer[oe]=i.createRenderbuffer(),Mn(A.__webglDepthbuffer[oe],L,!1);else{let ne=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,fe=A.__webglDepthbuffer[oe];i.bindRenderbuffer(i.RENDERBUFFER,fe),i.framebufferRenderbuffer(i.FRAMEBUFFER,ne,i.RENDERBUFFER,fe)}}else if(L.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,A.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,A.__webglFramebuffer),A.__webglDepthbuffer===void 0)A.__webglDepthbuffer=i.createRenderbuffer(),Mn(A.__webglDepthbuffer,L,!1);else{let ne=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,fe=A.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,fe),i.framebufferRenderbuffer(i.FRAMEBUFFER,ne,i.RENDERBUFFER,fe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function At(L,A,G){let oe=n.get(L);A!==void 0&&Qe(oe.__webglFramebuffer,L,L.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),G!==void 0&&yn(L)}function Jt(L){let A=L.texture,G=n.get(L),oe=n.get(A);L.addEventListener("dispose",O),T(L);let ne=L.textures,fe=L.isWebGLCubeRenderTarget===!0,ve=ne.length>1;if(ve||(oe.__webglTexture===void 0&&(oe.__webglTexture=i.createTexture()),oe.__version=A.version,o.memory.textures++),fe){G.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(A.mipmaps.length>0){G.__webglFramebuffer[Z]=[];for(let Q=0;Q<A.mipmaps.length;Q++)G.__webglFramebuffer[Z][Q]=i.createFramebuffer()}else G.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(A.mipmaps.length>0){G.__webglFramebuffer=[];for(let Z=0;Z<A.mipmaps.length;Z++)G.__webglFramebuffer[Z]=i.createFramebuffer()}else G.__webglFramebuffer=i.createFramebuffer();if(ve)for(let Z=0,Q=ne.length;Z<Q;Z++){let me=n.get(ne[Z]);me.__webglTexture===void 0&&(me.__webglTexture=i.createTexture(),o.memory.textures++)}if(L.samples>0&&xe(L)===!1){G.__webglMultisampledFramebuffer=i.createFramebuffer(),G.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,G.__webglMultisampledFramebuffer);for(let Z=0;Z<ne.length;Z++){let Q=ne[Z];G.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,G.__webglColorRenderbuffer[Z]);let me=r.convert(Q.format,Q.colorSpace),N=r.convert(Q.type),ee=y(Q.internalFormat,me,N,Q.normalized,Q.colorSpace,L.isXRRenderTarget===!0),j=Ut(L);i.renderbufferStorageMultisample(i.RENDERBUFFER,j,ee,L.width,L.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,G.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),L.depthBuffer&&(G.__webglDepthRenderbuffer=i.createRenderbuffer(),Mn(G.__webglDepthRenderbuffer,L,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(fe){t.bindTexture(i.TEXTURE_CUBE_MAP,oe.__webglTexture),Ve(i.TEXTURE_CUBE_MAP,A);for(let Z=0;Z<6;Z++)if(A.mipmaps.length>0)for(let Q=0;Q<A.mipmaps.length;Q++)Qe(G.__webglFramebuffer[Z][Q],L,A,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,Q);else Qe(G.__webglFramebuffer[Z],L,A,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);M(A)?b(i.TEXTURE_CUBE_MAP):A.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let Z=0,Q=ne.length;Z<Q;Z++){let me=ne[Z],N=n.get(me),ee=i.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(ee=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,N.__webglTexture),Ve(ee,me),Qe(G.__webglFramebuffer,L,me,i.COLOR_ATTACHMENT0+Z,ee,0),M(me)&&b(ee)}t.unbindTexture()}else{let Z=i.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(Z=L.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,oe.__webglTexture),Ve(Z,A),A.mipmaps.length>0)for(let Q=0;Q<A.mipmaps.length;Q++)Qe(G.__webglFramebuffer[Q],L,A,i.COLOR_ATTACHMENT0,Z,Q);else Qe(G.__webglFramebuffer,L,A,i.COLOR_ATTACHMENT0,Z,0);M(A)?b(Z):A.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),t.unbindTexture()}L.depthBuffer&&yn(L)}function B(L){let A=L.textures;for(let G=0,oe=A.length;G<oe;G++){let ne=A[G];if(M(ne)&&ne.mipmapsAutoUpdate===!0){let fe=S(L),ve=n.get(ne).__webglTexture;t.bindTexture(fe,ve),b(fe),t.unbindTexture()}}}let kt=[];function _t(L){if(L.samples>0){if(xe(L)===!1){let A=L.textures,G=L.width,oe=L.height,ne=i.COLOR_BUFFER_BIT,fe=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(L),Z=A.length>1;if(Z)for(let me=0;me<A.length;me++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<A.length;me++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ne|=i.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ne|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let N=n.get(A[me]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,N,0)}i.blitFramebuffer(0,0,G,oe,0,0,G,oe,ne,i.NEAREST),l===!0&&(kt.length=0,kt.push(i.COLOR_ATTACHMENT0+me),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&kt.push(fe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,kt))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let me=0;me<A.length;me++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let N=n.get(A[me]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+me,i.TEXTURE_2D,N,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let A=L.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[A])}}}function Ut(L){return Math.min(s.maxSamples,L.samples)}function xe(L){let A=n.get(L);return L.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&A.__useRenderToTexture!==!1}function Wt(L){let A=o.render.frame;u.get(L)!==A&&(u.set(L,A),L.update())}function Oe(L,A){let G=L.colorSpace,oe=L.format,ne=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||G!==Kn&&G!==Ks&&(st.getTransfer(G)===Ct?(oe!==ii||ne!==oi)&&Fe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):qe("WebGLTextures: Unsupported texture color space:",G)),A}function Xe(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=Te,this.resetTextureUnits=q,this.getTextureUnits=W,this.setTextureUnits=_e,this.setTexture2D=ae,this.setTexture2DArray=se,this.setTexture3D=ue,this.setTextureCube=re,this.rebindTextures=At,this.setupRenderTarget=Jt,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=_t,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Qe,this.useMultisampledRTT=xe,this.dispose=D}function FA(i,e){function t(n,s=Ks){let r,o=st.getTransfer(s);if(n===oi)return i.UNSIGNED_BYTE;if(n===_h)return i.UNSIGNED_SHORT_4_4_4_4;if(n===yh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Bp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===zp)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Fp)return i.BYTE;if(n===kp)return i.SHORT;if(n===ta)return i.UNSIGNED_SHORT;if(n===gh)return i.INT;if(n===Ri)return i.UNSIGNED_INT;if(n===$n)return i.FLOAT;if(n===zi)return i.HALF_FLOAT;if(n===Vp)return i.ALPHA;if(n===Hp)return i.RGB;if(n===ii)return i.RGBA;if(n===Fs)return i.DEPTH_COMPONENT;if(n===$s)return i.DEPTH_STENCIL;if(n===xh)return i.RED;if(n===Wl)return i.RED_INTEGER;if(n===pr)return i.RG;if(n===vh)return i.RG_INTEGER;if(n===bh)return i.RGBA_INTEGER;if(n===Xl||n===ql||n===Yl||n===$l)if(o===Ct)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Xl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ql)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===$l)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Xl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ql)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Yl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===$l)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Sh||n===wh||n===Mh||n===Eh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Sh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===wh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Mh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Eh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Th||n===Ah||n===Rh||n===Ch||n===Ph||n===Kl||n===Ih)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Th||n===Ah)return o===Ct?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Rh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Ch)return r.COMPRESSED_R11_EAC;if(n===Ph)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Kl)return r.COMPRESSED_RG11_EAC;if(n===Ih)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Lh||n===Oh||n===Nh||n===Dh||n===Uh||n===Fh||n===kh||n===Bh||n===zh||n===Vh||n===Hh||n===Gh||n===Wh||n===Xh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Lh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Oh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Nh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Dh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Uh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Fh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===kh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Bh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===zh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Vh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Hh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Gh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Wh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Xh)return o===Ct?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===qh||n===Yh||n===$h)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===qh)return o===Ct?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Yh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===$h)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Kh||n===Jh||n===Jl||n===jh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Kh)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Jh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Jl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===jh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Qr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var kA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,BA=`
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

}`,hm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Cl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new mn({vertexShader:kA,fragmentShader:BA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Pt(new ss(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},dm=class extends Qi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null,x=typeof XRWebGLBinding<"u",m=new hm,_={},v=t.getContextAttributes(),M=null,b=null,S=[],y=[],p=new ke,w=null,T=null,E=new dn;E.viewport=new ct;let C=new dn;C.viewport=new ct;let O=[E,C],U=new hh,I=null,D=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let ae=S[K];return ae===void 0&&(ae=new Wo,S[K]=ae),ae.getTargetRaySpace()},this.getControllerGrip=function(K){let ae=S[K];return ae===void 0&&(ae=new Wo,S[K]=ae),ae.getGripSpace()},this.getHand=function(K){let ae=S[K];return ae===void 0&&(ae=new Wo,S[K]=ae),ae.getHandSpace()};function V(K){let ae=y.indexOf(K.inputSource);if(ae===-1)return;let se=S[ae];se!==void 0&&(se.update(K.inputSource,K.frame,c||o),se.dispatchEvent({type:K.type,data:K.inputSource}))}function F(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",F),s.removeEventListener("inputsourceschange",ie);for(let K=0;K<S.length;K++){let ae=y[K];ae!==null&&(y[K]=null,S[K].disconnect(ae))}I=null,D=null,m.reset();for(let K in _)delete _[K];if(e.setRenderTarget(M),f=null,d=null,h=null,s=null,b=null,Te.stop(),n.isPresenting=!1,e.setPixelRatio(w),e.setSize(p.width,p.height,!1),T!==null){let K=T.camera;K.fov=T.fov,K.zoom=T.zoom,K.updateProjectionMatrix(),T=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&Fe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&Fe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(K){c=K},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(M=e.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",F),s.addEventListener("inputsourceschange",ie),v.xrCompatible!==!0&&await t.makeXRCompatible(),w=e.getPixelRatio(),e.getSize(p),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let se=null,ue=null,re=null;v.depth&&(re=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,se=v.stencil?$s:Fs,ue=v.stencil?Qr:Ri);let de={colorFormat:t.RGBA8,depthFormat:re,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(de),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new Vn(d.textureWidth,d.textureHeight,{format:ii,type:oi,depthTexture:new zs(d.textureWidth,d.textureHeight,ue,void 0,void 0,void 0,void 0,void 0,void 0,se),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let se={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,se),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new Vn(f.framebufferWidth,f.framebufferHeight,{format:ii,type:oi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Te.setContext(s),Te.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ie(K){for(let ae=0;ae<K.removed.length;ae++){let se=K.removed[ae],ue=y.indexOf(se);ue>=0&&(y[ue]=null,S[ue].disconnect(se))}for(let ae=0;ae<K.added.length;ae++){let se=K.added[ae],ue=y.indexOf(se);if(ue===-1){for(let de=0;de<S.length;de++)if(de>=y.length){y.push(se),ue=de;break}else if(y[de]===null){y[de]=se,ue=de;break}if(ue===-1)break}let re=S[ue];re&&re.connect(se)}}function z(K,ae){ae===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(ae.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let ae=K.near,se=K.far;m.texture!==null&&(m.depthNear>0&&(ae=m.depthNear),m.depthFar>0&&(se=m.depthFar)),U.near=C.near=E.near=ae,U.far=C.far=E.far=se,(I!==U.near||D!==U.far)&&(s.updateRenderState({depthNear:U.near,depthFar:U.far}),I=U.near,D=U.far),U.layers.mask=K.layers.mask|6,E.layers.mask=U.layers.mask&-5,C.layers.mask=U.layers.mask&-3;let ue=K.parent,re=U.cameras;z(U,ue);for(let de=0;de<re.length;de++)z(re[de],ue);U.projectionMatrix.copy(E.projectionMatrix),U.projectionMatrixInverse.copy(E.projectionMatrixInverse),T===null&&K.isPerspectiveCamera&&(T={camera:K,fov:K.fov,zoom:K.zoom}),q(K,U,ue)};function q(K,ae,se){se===null?K.matrix.copy(ae.matrixWorld):(K.matrix.copy(se.matrixWorld),K.matrix.invert(),K.matrix.multiply(ae.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(ae.projectionMatrix),K.projectionMatrixInverse.copy(ae.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=Xr*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(K){l=K,d!==null&&(d.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(U)},this.getCameraTexture=function(K){return _[K]};let W=null;function _e(K,ae){if(u=ae.getViewerPose(c||o),g=ae,u!==null){let se=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let ue=!1;se.length!==U.cameras.length&&(U.cameras.length=0,ue=!0);for(let Ae=0;Ae<se.length;Ae++){let Ve=se[Ae],Le=null;if(f!==null)Le=f.getViewport(Ve);else{let gt=h.getViewSubImage(d,Ve);Le=gt.viewport,Ae===0&&(e.setRenderTargetTextures(b,gt.colorTexture,gt.depthStencilTexture),e.setRenderTarget(b))}let we=O[Ae];we===void 0&&(we=new dn,we.layers.enable(Ae),we.viewport=new ct,O[Ae]=we),we.matrix.fromArray(Ve.transform.matrix),we.matrix.decompose(we.position,we.quaternion,we.scale),we.projectionMatrix.fromArray(Ve.projectionMatrix),we.projectionMatrixInverse.copy(we.projectionMatrix).invert(),we.viewport.set(Le.x,Le.y,Le.width,Le.height),Ae===0&&(U.matrix.copy(we.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),ue===!0&&U.cameras.push(we)}let re=s.enabledFeatures;if(re&&re.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=n.getBinding();let Ae=h.getDepthInformation(se[0]);Ae&&Ae.isValid&&Ae.texture&&m.init(Ae,s.renderState)}if(re&&re.includes("camera-access")&&x){e.state.unbindTexture(),h=n.getBinding();for(let Ae=0;Ae<se.length;Ae++){let Ve=se[Ae].camera;if(Ve){let Le=_[Ve];Le||(Le=new Cl,_[Ve]=Le);let we=h.getCameraImage(Ve);Le.sourceTexture=we}}}}for(let se=0;se<S.length;se++){let ue=y[se],re=S[se];ue!==null&&re!==void 0&&re.update(ue,ae,c||o)}W&&W(K,ae),ae.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ae}),g=null}let Te=new qy;Te.setAnimationLoop(_e),this.setAnimationLoop=function(K){W=K},this.dispose=function(){}}},zA=new Ce,nx=new Je;nx.set(-1,0,0,0,1,0,0,0,1);function VA(i,e){function t(m,_){m.matrixAutoUpdate===!0&&m.updateMatrix(),_.value.copy(m.matrix)}function n(m,_){_.color.getRGB(m.fogColor.value,Qp(i)),_.isFog?(m.fogNear.value=_.near,m.fogFar.value=_.far):_.isFogExp2&&(m.fogDensity.value=_.density)}function s(m,_,v,M,b){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(m,_):_.isMeshLambertMaterial?(r(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(m,_),h(m,_)):_.isMeshPhongMaterial?(r(m,_),u(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(m,_),d(m,_),_.isMeshPhysicalMaterial&&f(m,_,b)):_.isMeshMatcapMaterial?(r(m,_),g(m,_)):_.isMeshDepthMaterial?r(m,_):_.isMeshDistanceMaterial?(r(m,_),x(m,_)):_.isMeshNormalMaterial?r(m,_):_.isLineBasicMaterial?(o(m,_),_.isLineDashedMaterial&&a(m,_)):_.isPointsMaterial?l(m,_,v,M):_.isSpriteMaterial?c(m,_):_.isShadowMaterial?(m.color.value.copy(_.color),m.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(m,_){m.opacity.value=_.opacity,_.color&&m.diffuse.value.copy(_.color),_.emissive&&m.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(m.map.value=_.map,t(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.bumpMap&&(m.bumpMap.value=_.bumpMap,t(_.bumpMap,m.bumpMapTransform),m.bumpScale.value=_.bumpScale,_.side===An&&(m.bumpScale.value*=-1)),_.normalMap&&(m.normalMap.value=_.normalMap,t(_.normalMap,m.normalMapTransform),m.normalScale.value.copy(_.normalScale),_.side===An&&m.normalScale.value.negate()),_.displacementMap&&(m.displacementMap.value=_.displacementMap,t(_.displacementMap,m.displacementMapTransform),m.displacementScale.value=_.displacementScale,m.displacementBias.value=_.displacementBias),_.emissiveMap&&(m.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,m.emissiveMapTransform)),_.specularMap&&(m.specularMap.value=_.specularMap,t(_.specularMap,m.specularMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest);let v=e.get(_),M=v.envMap,b=v.envMapRotation;M&&(m.envMap.value=M,m.envMapRotation.value.setFromMatrix4(zA.makeRotationFromEuler(b)).transpose(),M.isCubeTexture&&M.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(nx),m.reflectivity.value=_.reflectivity,m.ior.value=_.ior,m.refractionRatio.value=_.refractionRatio),_.lightMap&&(m.lightMap.value=_.lightMap,m.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,m.lightMapTransform)),_.aoMap&&(m.aoMap.value=_.aoMap,m.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,m.aoMapTransform))}function o(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,_.map&&(m.map.value=_.map,t(_.map,m.mapTransform))}function a(m,_){m.dashSize.value=_.dashSize,m.totalSize.value=_.dashSize+_.gapSize,m.scale.value=_.scale}function l(m,_,v,M){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.size.value=_.size*v,m.scale.value=M*.5,_.map&&(m.map.value=_.map,t(_.map,m.uvTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function c(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.rotation.value=_.rotation,_.map&&(m.map.value=_.map,t(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function u(m,_){m.specular.value.copy(_.specular),m.shininess.value=Math.max(_.shininess,1e-4)}function h(m,_){_.gradientMap&&(m.gradientMap.value=_.gradientMap)}function d(m,_){m.metalness.value=_.metalness,_.metalnessMap&&(m.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,m.metalnessMapTransform)),m.roughness.value=_.roughness,_.roughnessMap&&(m.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,m.roughnessMapTransform)),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)}function f(m,_,v){m.ior.value=_.ior,_.diffuseRoughness>0&&(m.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),_.sheen>0&&(m.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),m.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(m.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,m.sheenColorMapTransform)),_.sheenRoughnessMap&&(m.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,m.sheenRoughnessMapTransform))),_.clearcoat>0&&(m.clearcoat.value=_.clearcoat,m.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(m.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,m.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(m.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===An&&m.clearcoatNormalScale.value.negate())),_.dispersion>0&&(m.dispersion.value=_.dispersion),_.retroreflectivity>0&&(m.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(m.iridescence.value=_.iridescence,m.iridescenceIOR.value=_.iridescenceIOR,m.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(m.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,m.iridescenceMapTransform)),_.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),_.transmission>0&&(m.transmission.value=_.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),_.transmissionMap&&(m.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,m.transmissionMapTransform)),m.thickness.value=_.thickness,_.thicknessMap&&(m.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=_.attenuationDistance,m.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(m.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(m.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=_.specularIntensity,m.specularColor.value.copy(_.specularColor),_.specularColorMap&&(m.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,m.specularColorMapTransform)),_.specularIntensityMap&&(m.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,_){_.matcap&&(m.matcap.value=_.matcap)}function x(m,_){let v=e.get(_).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function HA(i,e,t,n){let s={},r={};function o(v,M){let b=M.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,M){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let S=M.program;n.updateUBOMapping(v,S);let y=e.render.frame;r[v.id]!==y&&(c(v),r[v.id]=y)}function l(v){let M=i.createBuffer(),b=v.__size,S=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,b,S),i.bindBuffer(i.UNIFORM_BUFFER,null),M}function c(v){let M=s[v.id],b=v.uniforms,S=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,M);for(let y=0,p=b.length;y<p;y++){let w=b[y];if(Array.isArray(w))for(let T=0,E=w.length;T<E;T++)u(w[T],y,T,S);else u(w,y,0,S)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,M,b,S){if(d(v,M,b,S)===!0){let y=v.__offset,p=v.value;if(Array.isArray(p)){let w=0;for(let T=0;T<p.length;T++){let E=p[T],C=x(E,!0);h(E,v.__data,w),w+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else h(p,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,y,v.__data)}}function h(v,M,b){typeof v=="number"||typeof v=="boolean"?M[b]=v:v.isMatrix3?(M[b]=v.elements[0],M[b+1]=v.elements[1],M[b+2]=v.elements[2],M[b+3]=0,M[b+4]=v.elements[3],M[b+5]=v.elements[4],M[b+6]=v.elements[5],M[b+7]=0,M[b+8]=v.elements[6],M[b+9]=v.elements[7],M[b+10]=v.elements[8],M[b+11]=0):ArrayBuffer.isView(v)?M.set(v.subarray(0,M.length-b),b):v.toArray(M,b)}function d(v,M,b,S){let y=v.value,p=M+"_"+b;if(Array.isArray(y)){S[p]===void 0&&(S[p]=[]);let w=S[p],T=!1;for(let E=0;E<y.length;E++)f(y[E],w,E)===!0&&(T=!0);return T}return f(y,S,p)}function f(v,M,b){if(M[b]===void 0)return typeof v=="number"||typeof v=="boolean"?M[b]=v:ArrayBuffer.isView(v)?M[b]=v.slice():M[b]=v.clone(),!0;{let S=M[b];if(typeof v=="number"||typeof v=="boolean"){if(S!==v)return M[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(S.equals(v)===!1)return S.copy(v),!0}}return!1}function g(v){let M=v.uniforms,b=0,S=16;for(let p=0,w=M.length;p<w;p++){let T=Array.isArray(M[p])?M[p]:[M[p]];for(let E=0,C=T.length;E<C;E++){let O=T[E],U=Array.isArray(O.value)?O.value:[O.value],I=Array.isArray(M[p])||Array.isArray(O.value),D=b;for(let F=0,ie=U.length;F<ie;F++){let z=U[F],q=x(z,I),W=b%S,_e=W%q.boundary,Te=W+_e;b+=_e,Te!==0&&S-Te<q.storage&&(b+=S-Te),F===0&&(D=b),b+=q.storage}let V=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new V((b-D)/Float32Array.BYTES_PER_ELEMENT),O.__offset=D}}let y=b%S;return y>0&&(b+=S-y),v.__size=b,v.__cache={},this}function x(v,M){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Fe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Fe("WebGLRenderer: Unsupported uniform value type.",v),M===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let M=v.target;M.removeEventListener("dispose",m),i.deleteBuffer(s[M.id]),delete s[M.id],delete r[M.id]}function _(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:_}}var GA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),us=null;function WA(){return us===null&&(us=new Us(GA,16,16,pr,zi),us.name="DFG_LUT",us.minFilter=pn,us.magFilter=pn,us.wrapS=Mi,us.wrapT=Mi,us.generateMipmaps=!1,us.needsUpdate=!0),us}var nd=class{constructor(e={}){let{canvas:t=yy(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=oi}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let x=f,m=new Set([bh,vh,Wl]),_=new Set([oi,Ri,ta,Qr,_h,yh]),v=new Uint32Array(4),M=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},S=null,y=null,p=[],w=[],T=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ls,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let E=this,C=!1,O=null,U=null,I=null,D=null;this._outputColorSpace=hn;let V=0,F=0,ie=null,z=-1,q=null,W=new ct,_e=new ct,Te=null,K=new Ue(0),ae=0,se=t.width,ue=t.height,re=1,de=null,$e=null,Ae=new ct(0,0,se,ue),Ve=new ct(0,0,se,ue),Le=!1,we=new Bs,gt=new El,We=!1,at=!1,Qe=new Ce,Mn=new P,Ot=new ct,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},At=!1;function Jt(){return ie===null?re:1}let B=n;function kt(R,k){return t.getContext(R,k)}let _t,Ut,xe,Wt,Oe,Xe,L,A,G,oe,ne,fe,ve,Z,Q,me,N,ee,j,ge,he,pe,ze;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ge,!1),t.addEventListener("webglcontextrestored",et,!1),t.addEventListener("webglcontextcreationerror",Me,!1),B===null){let k="webgl2";if(B=kt(k,R),B===null)throw kt(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}it()}catch(R){throw t.removeEventListener("webglcontextlost",Ge,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Me,!1),qe("WebGLRenderer: "+R.message),R}function it(){_t=new t1(B),_t.init(),he=new FA(B,_t),Ut=new WT(B,_t,e,he),xe=new DA(B,_t),Ut.reversedDepthBuffer&&d&&xe.buffers.depth.setReversed(!0),U=B.createFramebuffer(),I=B.createFramebuffer(),D=B.createFramebuffer(),Wt=new s1(B),Oe=new bA,Xe=new UA(B,_t,xe,Oe,Ut,he,Wt),L=new e1(E),A=new oM(B),pe=new HT(B,A),G=new n1(B,A,Wt,pe),oe=new o1(B,G,A,pe,Wt),ee=new r1(B,Ut,Xe),Q=new XT(Oe),ne=new vA(E,L,_t,Ut,pe,Q),fe=new VA(E,Oe),ve=new wA,Z=new CA(_t),N=new VT(E,L,xe,oe,g,l),me=new NA(E,oe,Ut),ze=new HA(B,Wt,Ut,xe),j=new GT(B,_t,Wt),ge=new i1(B,_t,Wt),Wt.programs=ne.programs,E.capabilities=Ut,E.extensions=_t,E.properties=Oe,E.renderLists=ve,E.shadowMap=me,E.state=xe,E.info=Wt}x!==oi&&(T=new l1(x,t.width,t.height,a,s,r));let le=new dm(E,B);this.xr=le,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let R=_t.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=_t.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return re},this.setPixelRatio=function(R){R!==void 0&&(re=R,this.setSize(se,ue,!1))},this.getSize=function(R){return R.set(se,ue)},this.setSize=function(R,k,J=!0){if(le.isPresenting){Fe("WebGLRenderer: Can't change size while VR device is presenting.");return}se=R,ue=k,t.width=Math.floor(R*re),t.height=Math.floor(k*re),J===!0&&(t.style.width=R+"px",t.style.height=k+"px"),T!==null&&T.setSize(t.width,t.height),this.setViewport(0,0,R,k)},this.getDrawingBufferSize=function(R){return R.set(se*re,ue*re).floor()},this.setDrawingBufferSize=function(R,k,J){se=R,ue=k,re=J,t.width=Math.floor(R*J),t.height=Math.floor(k*J),this.setViewport(0,0,R,k)},this.setEffects=function(R){if(x===oi){qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let k=0;k<R.length;k++)if(R[k].isOutputPass===!0){Fe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}T.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(W)},this.getViewport=function(R){return R.copy(Ae)},this.setViewport=function(R,k,J,H){R.isVector4?Ae.set(R.x,R.y,R.z,R.w):Ae.set(R,k,J,H),xe.viewport(W.copy(Ae).multiplyScalar(Jt()).round())},this.getScissor=function(R){return R.copy(Ve)},this.setScissor=function(R,k,J,H){R.isVector4?Ve.set(R.x,R.y,R.z,R.w):Ve.set(R,k,J,H),xe.scissor(_e.copy(Ve).multiplyScalar(Jt()).round())},this.getScissorTest=function(){return Le},this.setScissorTest=function(R){xe.setScissorTest(Le=R)},this.setOpaqueSort=function(R){de=R},this.setTransparentSort=function(R){$e=R},this.getClearColor=function(R){return R.copy(N.getClearColor())},this.setClearColor=function(){N.setClearColor(...arguments)},this.getClearAlpha=function(){return N.getClearAlpha()},this.setClearAlpha=function(){N.setClearAlpha(...arguments)},this.clear=function(R=!0,k=!0,J=!0){let H=0;if(R){let X=!1;if(ie!==null){let be=ie.texture.format;X=m.has(be)}if(X){let be=ie.texture.type,Re=_.has(be),ye=N.getClearColor(),Ee=N.getClearAlpha(),De=ye.r,Ze=ye.g,dt=ye.b;Re?(v[0]=De,v[1]=Ze,v[2]=dt,v[3]=Ee,B.clearBufferuiv(B.COLOR,0,v)):(M[0]=De,M[1]=Ze,M[2]=dt,M[3]=Ee,B.clearBufferiv(B.COLOR,0,M))}else H|=B.COLOR_BUFFER_BIT}k&&(H|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),J&&(H|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),H!==0&&B.clear(H)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),O=R},this.dispose=function(){t.removeEventListener("webglcontextlost",Ge,!1),t.removeEventListener("webglcontextrestored",et,!1),t.removeEventListener("webglcontextcreationerror",Me,!1),N.dispose(),ve.dispose(),Z.dispose(),Xe.dispose(),Oe.dispose(),L.dispose(),oe.dispose(),G.dispose(),pe.dispose(),ze.dispose(),ne.dispose(),le.dispose(),le.removeEventListener("sessionstart",f0),le.removeEventListener("sessionend",p0),Rr.stop()};function Ge(R){R.preventDefault(),_l("WebGLRenderer: Context Lost."),C=!0}function et(){_l("WebGLRenderer: Context Restored."),C=!1;let R=Wt.autoReset,k=me.enabled,J=me.autoUpdate,H=me.needsUpdate,X=me.type;it(),Wt.autoReset=R,me.enabled=k,me.autoUpdate=J,me.needsUpdate=H,me.type=X}function Me(R){qe("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function Nt(R){let k=R.target;k.removeEventListener("dispose",Nt),xn(k)}function xn(R){er(R),Oe.remove(R)}function er(R){let k=Oe.get(R).programs;k!==void 0&&(k.forEach(function(J){ne.releaseProgram(J)}),R.isShaderMaterial&&ne.releaseShaderCache(R))}this.renderBufferDirect=function(R,k,J,H,X,be){k===null&&(k=yn);let Re=X.isMesh&&X.matrixWorld.determinantAffine()<0,ye=uS(R,k,J,H,X);xe.setMaterial(H,Re);let Ee=J.index,De=1;if(H.wireframe===!0){if(Ee=G.getWireframeAttribute(J),Ee===void 0)return;De=2}let Ze=J.drawRange,dt=J.attributes.position,Pe=Ze.start*De,ft=(Ze.start+Ze.count)*De;be!==null&&(Pe=Math.max(Pe,be.start*De),ft=Math.min(ft,(be.start+be.count)*De)),Ee!==null?(Pe=Math.max(Pe,0),ft=Math.min(ft,Ee.count)):dt!=null&&(Pe=Math.max(Pe,0),ft=Math.min(ft,dt.count));let ln=ft-Pe;if(ln<0||ln===1/0)return;pe.setup(X,H,ye,J,Ee);let Xt,Bt=j;if(Ee!==null&&(Xt=A.get(Ee),Bt=ge,Bt.setIndex(Xt)),X.isMesh)H.wireframe===!0?(xe.setLineWidth(H.wireframeLinewidth*Jt()),Bt.setMode(B.LINES)):Bt.setMode(B.TRIANGLES);else if(X.isLine){let Nn=H.linewidth;Nn===void 0&&(Nn=1),xe.setLineWidth(Nn*Jt()),X.isLineSegments?Bt.setMode(B.LINES):X.isLineLoop?Bt.setMode(B.LINE_LOOP):Bt.setMode(B.LINE_STRIP)}else X.isPoints?Bt.setMode(B.POINTS):X.isSprite&&Bt.setMode(B.TRIANGLES);if(X.isBatchedMesh)if(_t.get("WEBGL_multi_draw"))Bt.renderMultiDraw(X._multiDrawStarts,X._multiDrawCounts,X._multiDrawCount);else{let Nn=X._multiDrawStarts,Ie=X._multiDrawCounts,Xn=X._multiDrawCount,Mt=Ee?A.get(Ee).bytesPerElement:1,Cr=Oe.get(H).currentProgram.getUniforms();for(let Dn=0;Dn<Xn;Dn++)Cr.setValue(B,"_gl_DrawID",Dn),Bt.render(Nn[Dn]/Mt,Ie[Dn])}else if(X.isInstancedMesh)Bt.renderInstances(Pe,ln,X.count);else if(J.isInstancedBufferGeometry){let Nn=J._maxInstanceCount!==void 0?J._maxInstanceCount:1/0,Ie=Math.min(J.instanceCount,Nn);Bt.renderInstances(Pe,ln,Ie)}else Bt.render(Pe,ln)};function d0(R,k,J,H){O!==null&&R.isNodeMaterial&&O.setObject(H,R),We===!0&&Q.setState(R,J,!1),R.transparent===!0&&R.side===un&&R.forceSinglePass===!1?(R.side=An,R.needsUpdate=!0,Ga(R,k,H),R.side=pi,R.needsUpdate=!0,Ga(R,k,H),R.side=un):Ga(R,k,H)}this.compile=function(R,k,J=null){J===null&&(J=R),O!==null&&O.renderStart(R,k,J),y=Z.get(J),y.init(k),w.push(y),J.traverseVisible(function(X){X.isLight&&X.layers.test(k.layers)&&(y.pushLight(X),X.castShadow&&y.pushShadow(X))}),R!==J&&R.traverseVisible(function(X){X.isLight&&X.layers.test(k.layers)&&(y.pushLight(X),X.castShadow&&y.pushShadow(X))}),y.setupLights(),O!==null&&O.updateLights(y.state.lightsArray),at=this.localClippingEnabled,We=Q.init(this.clippingPlanes,at),We===!0&&Q.setGlobalState(this.clippingPlanes,k),O!==null&&me.render(y.state.shadowsArray,J,k);let H=new Set;return R.traverse(function(X){if(!(X.isMesh||X.isPoints||X.isLine||X.isSprite))return;let be=X.material;if(be)if(Array.isArray(be))for(let Re=0;Re<be.length;Re++){let ye=be[Re];d0(ye,J,k,X),H.add(ye)}else d0(be,J,k,X),H.add(be)}),y=w.pop(),O!==null&&O.renderEnd(),H},this.compileAsync=function(R,k,J=null){let H=this.compile(R,k,J);return new Promise(X=>{function be(){if(H.forEach(function(Re){let Ee=Oe.get(Re).currentProgram;(Ee===void 0||Ee.isReady())&&H.delete(Re)}),H.size===0){X(R);return}setTimeout(be,10)}_t.get("KHR_parallel_shader_compile")!==null?be():setTimeout(be,10)})};let wf=null;function lS(R){wf&&wf(R)}function f0(){Rr.stop()}function p0(){Rr.start()}let Rr=new qy;Rr.setAnimationLoop(lS),typeof self<"u"&&Rr.setContext(self),this.setAnimationLoop=function(R){wf=R,le.setAnimationLoop(R),R===null?Rr.stop():Rr.start()},le.addEventListener("sessionstart",f0),le.addEventListener("sessionend",p0),this.render=function(R,k){if(k!==void 0&&k.isCamera!==!0){qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;O!==null&&O.renderStart(R,k);let J=le.enabled===!0&&le.isPresenting===!0,H=T!==null&&(ie===null||J)&&T.begin(E,ie);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),le.enabled===!0&&le.isPresenting===!0&&(T===null||T.isCompositing()===!1)&&(le.cameraAutoUpdate===!0&&le.updateCamera(k),k=le.getCamera()),R.isScene===!0&&R.onBeforeRender(E,R,k,ie),y=Z.get(R,w.length),y.init(k),y.state.textureUnits=Xe.getTextureUnits(),w.push(y),Qe.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?gt.setFromArrayCamera(k):we.setFromProjectionMatrix(Qe,Ei,k.reversedDepth),at=this.localClippingEnabled,We=Q.init(this.clippingPlanes,at),S=ve.get(R,p.length),S.init(),p.push(S),this.info.render.frame++,le.enabled===!0&&le.isPresenting===!0){let Re=E.xr.getDepthSensingMesh();Re!==null&&Mf(Re,k,-1/0,E.sortObjects)}Mf(R,k,0,E.sortObjects),S.finish(),O!==null&&O.updateLights(y.state.lightsArray),E.sortObjects===!0&&S.sort(de,$e),At=le.enabled===!1||le.isPresenting===!1||le.hasDepthSensing()===!1,At&&N.addToRenderList(S,R),this.info.autoReset===!0&&this.info.reset(),We===!0&&Q.beginShadows();let X=y.state.shadowsArray;if(me.render(X,R,k),We===!0&&Q.endShadows(),(H&&T.hasRenderPass())===!1){let Re=S.opaque,ye=S.transmissive;if(y.setupLights(),k.isArrayCamera){let Ee=k.cameras;if(ye.length>0)for(let De=0,Ze=Ee.length;De<Ze;De++){let dt=Ee[De];g0(Re,ye,R,dt)}At&&N.render(R);for(let De=0,Ze=Ee.length;De<Ze;De++){let dt=Ee[De];m0(S,R,dt,dt.viewport)}}else ye.length>0&&g0(Re,ye,R,k),At&&N.render(R),m0(S,R,k)}ie!==null&&F===0&&(Xe.updateMultisampleRenderTarget(ie),Xe.updateRenderTargetMipmap(ie)),H&&T.end(E),R.isScene===!0&&R.onAfterRender(E,R,k),pe.resetDefaultState(),z=-1,q=null,w.pop(),w.length>0?(y=w[w.length-1],Xe.setTextureUnits(y.state.textureUnits),We===!0&&Q.setGlobalState(E.clippingPlanes,y.state.camera)):y=null,p.pop(),p.length>0?S=p[p.length-1]:S=null,O!==null&&O.renderEnd()};function Mf(R,k,J,H){if(R.visible===!1)return;if(R.layers.test(k.layers)){if(R.isGroup)J=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(k);else if(R.isLight)y.pushLight(R),R.castShadow&&y.pushShadow(R);else if(R.isSprite){let Re=k.isArrayCamera?gt:we;if(!R.frustumCulled||R.intersectsFrustum(Re)){H&&Ot.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Qe);let ye=oe.update(R),Ee=R.material;Ee.visible&&S.push(R,ye,Ee,J,Ot.z,null,k)}}else if(R.isMesh||R.isLine||R.isPoints){let Re=k.isArrayCamera?gt:we;if(!R.frustumCulled||R.intersectsFrustum(Re)){let ye=oe.update(R),Ee=R.material;if(H&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),Ot.copy(R.boundingSphere.center)):(ye.boundingSphere===null&&ye.computeBoundingSphere(),Ot.copy(ye.boundingSphere.center)),Ot.applyMatrix4(R.matrixWorld).applyMatrix4(Qe)),Array.isArray(Ee)){let De=ye.groups;for(let Ze=0,dt=De.length;Ze<dt;Ze++){let Pe=De[Ze],ft=Ee[Pe.materialIndex];ft&&ft.visible&&S.push(R,ye,ft,J,Ot.z,Pe,k)}}else Ee.visible&&S.push(R,ye,Ee,J,Ot.z,null,k)}}}let be=R.children;for(let Re=0,ye=be.length;Re<ye;Re++)Mf(be[Re],k,J,H)}function m0(R,k,J,H){let{opaque:X,transmissive:be,transparent:Re}=R;y.setupLightsView(J),We===!0&&Q.setGlobalState(E.clippingPlanes,J),H&&xe.viewport(W.copy(H)),X.length>0&&$c(X,k,J),be.length>0&&$c(be,k,J),Re.length>0&&$c(Re,k,J),xe.buffers.depth.setTest(!0),xe.buffers.depth.setMask(!0),xe.buffers.color.setMask(!0),xe.setPolygonOffset(!1)}function g0(R,k,J,H){if((J.isScene===!0?J.overrideMaterial:null)!==null)return;if(y.state.transmissionRenderTarget[H.id]===void 0){let Pe=_t.has("EXT_color_buffer_half_float")||_t.has("EXT_color_buffer_float");y.state.transmissionRenderTarget[H.id]=new Vn(1,1,{generateMipmaps:!0,type:Pe?zi:oi,minFilter:Ai,samples:Math.max(4,Ut.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:st.workingColorSpace})}let be=y.state.transmissionRenderTarget[H.id],Re=H.viewport||W;be.setSize(Re.z*E.transmissionResolutionScale,Re.w*E.transmissionResolutionScale);let ye=E.getRenderTarget(),Ee=E.getActiveCubeFace(),De=E.getActiveMipmapLevel();E.setRenderTarget(be),E.getClearColor(K),ae=E.getClearAlpha(),ae<1&&E.setClearColor(16777215,.5),E.clear(),At&&N.render(J);let Ze=E.toneMapping;E.toneMapping=ls;let dt=H.viewport;if(H.viewport!==void 0&&(H.viewport=void 0),y.setupLightsView(H),We===!0&&Q.setGlobalState(E.clippingPlanes,H),$c(R,J,H),Xe.updateMultisampleRenderTarget(be),Xe.updateRenderTargetMipmap(be),_t.has("WEBGL_multisampled_render_to_texture")===!1){let Pe=!1;for(let ft=0,ln=k.length;ft<ln;ft++){let Xt=k[ft],{object:Bt,geometry:Nn,material:Ie,group:Xn}=Xt;if(Ie.side===un&&Bt.layers.test(H.layers)){let Mt=Ie.side;Ie.side=An,Ie.needsUpdate=!0,_0(Bt,J,H,Nn,Ie,Xn),Ie.side=Mt,Ie.needsUpdate=!0,Pe=!0}}Pe===!0&&(Xe.updateMultisampleRenderTarget(be),Xe.updateRenderTargetMipmap(be))}E.setRenderTarget(ye,Ee,De),E.setClearColor(K,ae),dt!==void 0&&(H.viewport=dt),E.toneMapping=Ze}function $c(R,k,J){let H=k.isScene===!0?k.overrideMaterial:null;for(let X=0,be=R.length;X<be;X++){let Re=R[X],{object:ye,geometry:Ee,group:De}=Re,Ze=Re.material;Ze.allowOverride===!0&&H!==null&&(Ze=H),ye.layers.test(J.layers)&&_0(ye,k,J,Ee,Ze,De)}}function _0(R,k,J,H,X,be){O!==null&&X.isNodeMaterial&&O.setObject(R,X),R.onBeforeRender(E,k,J,H,X,be),R.modelViewMatrix.multiplyMatrices(J.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),X.onBeforeRender(E,k,J,H,R,be),X.transparent===!0&&X.side===un&&X.forceSinglePass===!1?(X.side=An,X.needsUpdate=!0,E.renderBufferDirect(J,k,H,X,R,be),X.side=pi,X.needsUpdate=!0,E.renderBufferDirect(J,k,H,X,R,be),X.side=un):E.renderBufferDirect(J,k,H,X,R,be),R.onAfterRender(E,k,J,H,X,be)}function y0(R){let k=0;for(let J of R)J.texture!==null&&k++;return k}function Ga(R,k,J){k.isScene!==!0&&(k=yn);let H=Oe.get(R),X=y.state.lights,be=y.state.shadowsArray,Re=X.state.version,ye=ne.getParameters(R,X.state,be,k,J,y.state.lightProbeGridArray),Ee=ne.getProgramCacheKey(ye),De=H.programs;H.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?k.environment:null,H.fog=k.fog;let Ze=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;H.envMap=L.get(R.envMap||H.environment,Ze),H.envMapRotation=H.environment!==null&&R.envMap===null?k.environmentRotation:R.envMapRotation,De===void 0&&(R.addEventListener("dispose",Nt),De=new Map,H.programs=De,H.programVariants=new Map);let dt=De.get(Ee);if(dt!==void 0){if(H.currentProgram===dt&&H.lightsStateVersion===Re)return v0(R,ye),dt}else ye.uniforms=ne.getUniforms(R),O!==null&&R.isNodeMaterial&&O.build(R,J,ye),R.onBeforeCompile(ye,E),dt=ne.acquireProgram(ye,Ee),De.set(Ee,dt),H.uniforms=ye.uniforms;let Pe=H.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(Pe.clippingPlanes=Q.uniform),v0(R,ye),H.needsLights=dS(R),H.lightsStateVersion=Re,H.needsLights&&(Pe.ambientLightColor.value=X.state.ambient,Pe.lightProbe.value=X.state.probe,Pe.sunLights.value=X.state.sun,Pe.sunLightShadows.value=X.state.sunShadow,Pe.directionalLights.value=X.state.directional,Pe.directionalLightShadows.value=X.state.directionalShadow,Pe.spotLights.value=X.state.spot,Pe.spotLightShadows.value=X.state.spotShadow,Pe.rectAreaLights.value=X.state.rectArea,Pe.ltc_1.value=X.state.rectAreaLTC1,Pe.ltc_2.value=X.state.rectAreaLTC2,Pe.pointLights.value=X.state.point,Pe.pointLightShadows.value=X.state.pointShadow,Pe.hemisphereLights.value=X.state.hemi,Pe.sunShadowMatrix.value=X.state.sunShadowMatrix,Pe.sunShadowCascade.value=X.state.sunShadowCascade,Pe.directionalShadowMatrix.value=X.state.directionalShadowMatrix,Pe.spotLightMatrix.value=X.state.spotLightMatrix,Pe.spotLightMap.value=X.state.spotLightMap,Pe.pointShadowMatrix.value=X.state.pointShadowMatrix),H.numLightProbeGrids=y0(y.state.lightProbeGridArray),H.currentProgram=dt,H.uniformsList=null,dt}function cS(R,k,J,H,X){let be=Oe.get(R),Re=be.currentProgram.id+","+H+","+X,ye=be.programVariants.get(Re);return ye===void 0?(ye=Ga(R,k,J),be.programVariants.set(Re,ye)):(be.currentProgram=ye,be.uniformsList=null,be.outputColorSpace=H,be.toneMapping=X),ye}function x0(R){if(R.uniformsList===null){let k=R.currentProgram.getUniforms();R.uniformsList=sa.seqWithValue(k.seq,R.uniforms)}return R.uniformsList}function v0(R,k){let J=Oe.get(R);J.outputColorSpace=k.outputColorSpace,J.batching=k.batching,J.batchingColor=k.batchingColor,J.instancing=k.instancing,J.instancingColor=k.instancingColor,J.instancingMorph=k.instancingMorph,J.skinning=k.skinning,J.morphTargets=k.morphTargets,J.morphNormals=k.morphNormals,J.morphColors=k.morphColors,J.morphTargetsCount=k.morphTargetsCount,J.numClippingPlanes=k.numClippingPlanes,J.numIntersection=k.numClipIntersection,J.vertexAlphas=k.vertexAlphas,J.vertexTangents=k.vertexTangents,J.toneMapping=k.toneMapping}function uS(R,k,J,H,X){k.isScene!==!0&&(k=yn),Xe.resetTextureUnits();let be=k.fog,Re=H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial?k.environment:null,ye=ie===null?E.outputColorSpace:ie.isXRRenderTarget===!0?ie.texture.colorSpace:st.workingColorSpace,Ee=H.isMeshStandardMaterial||H.isMeshLambertMaterial&&!H.envMap||H.isMeshPhongMaterial&&!H.envMap,De=L.get(H.envMap||Re,Ee),Ze=H.vertexColors===!0&&!!J.attributes.color&&J.attributes.color.itemSize===4,dt=!!J.attributes.tangent&&(!!H.normalMap||H.anisotropy>0),Pe=!!J.morphAttributes.position,ft=!!J.morphAttributes.normal,ln=!!J.morphAttributes.color,Xt=ls;H.toneMapped&&(ie===null||ie.isXRRenderTarget===!0)&&(Xt=E.toneMapping);let Bt=J.morphAttributes.position||J.morphAttributes.normal||J.morphAttributes.color,Nn=Bt!==void 0?Bt.length:0,Ie=Oe.get(H),Xn=y.state.lights;if(We===!0&&(at===!0||R!==q)){let jt=R===q&&H.id===z;Q.setState(H,R,jt)}let Mt=!1,Cr=!1;H.version===Ie.__version?Ie.needsLights&&Ie.lightsStateVersion!==Xn.state.version||X.isBatchedMesh&&Ie.batching===!1||!X.isBatchedMesh&&Ie.batching===!0||X.isBatchedMesh&&Ie.batchingColor===!0&&X._colorsTexture===null||X.isBatchedMesh&&Ie.batchingColor===!1&&X._colorsTexture!==null||X.isInstancedMesh&&Ie.instancing===!1||!X.isInstancedMesh&&Ie.instancing===!0||X.isSkinnedMesh&&Ie.skinning===!1||!X.isSkinnedMesh&&Ie.skinning===!0||X.isInstancedMesh&&Ie.instancingColor===!0&&X.instanceColor===null||X.isInstancedMesh&&Ie.instancingColor===!1&&X.instanceColor!==null||X.isInstancedMesh&&Ie.instancingMorph===!0&&X.morphTexture===null||X.isInstancedMesh&&Ie.instancingMorph===!1&&X.morphTexture!==null||Ie.envMap!==De||H.fog===!0&&Ie.fog!==be||Ie.numClippingPlanes!==void 0&&(Ie.numClippingPlanes!==Q.numPlanes||Ie.numIntersection!==Q.numIntersection)||Ie.vertexAlphas!==Ze||Ie.vertexTangents!==dt||Ie.morphTargets!==Pe||Ie.morphNormals!==ft||Ie.morphColors!==ln||Ie.morphTargetsCount!==Nn||Ie.numLightProbeGrids!==y0(y.state.lightProbeGridArray)?Mt=!0:(Ie.outputColorSpace!==ye||Ie.toneMapping!==Xt)&&(Cr=!0):(Mt=!0,Ie.__version=H.version);let Dn=Ie.currentProgram;(Mt===!0||Cr===!0)&&(Dn=Cr===!0?cS(H,k,X,ye,Xt):Ga(H,k,X),O&&H.isNodeMaterial&&O.onUpdateProgram(H,Dn,Ie));let Kc=!1,tr=!1,Pr=!1,xt=Dn.getUniforms(),En=Ie.uniforms;if(xe.useProgram(Dn.program)&&(Kc=!0,tr=!0,Pr=!0),H.id!==z&&(z=H.id,tr=!0),Kc||q!==R){xe.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),xt.setValue(B,"projectionMatrix",R.projectionMatrix),xt.setValue(B,"viewMatrix",R.matrixWorldInverse);let vn=xt.map.cameraPosition;vn!==void 0&&vn.setValue(B,Mn.setFromMatrixPosition(R.matrixWorld)),Ut.logarithmicDepthBuffer&&xt.setValue(B,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(H.isMeshPhongMaterial||H.isMeshToonMaterial||H.isMeshLambertMaterial||H.isMeshBasicMaterial||H.isMeshStandardMaterial||H.isShaderMaterial)&&xt.setValue(B,"isOrthographic",R.isOrthographicCamera===!0),q!==R&&(q=R,tr=!0,Pr=!0)}if(Ie.needsLights&&(Xn.state.sunShadowMap.length>0&&xt.setValue(B,"sunShadowMap",Xn.state.sunShadowMap,Xe),Xn.state.directionalShadowMap.length>0&&xt.setValue(B,"directionalShadowMap",Xn.state.directionalShadowMap,Xe),Xn.state.spotShadowMap.length>0&&xt.setValue(B,"spotShadowMap",Xn.state.spotShadowMap,Xe),Xn.state.pointShadowMap.length>0&&xt.setValue(B,"pointShadowMap",Xn.state.pointShadowMap,Xe)),X.isSkinnedMesh){xt.setOptional(B,X,"bindMatrix"),xt.setOptional(B,X,"bindMatrixInverse");let jt=X.skeleton;jt&&(jt.boneTexture===null&&jt.computeBoneTexture(),xt.setValue(B,"boneTexture",jt.boneTexture,Xe))}X.isBatchedMesh&&(xt.setOptional(B,X,"batchingTexture"),xt.setValue(B,"batchingTexture",X._matricesTexture,Xe),xt.setOptional(B,X,"batchingIdTexture"),xt.setValue(B,"batchingIdTexture",X._indirectTexture,Xe),xt.setOptional(B,X,"batchingColorTexture"),X._colorsTexture!==null&&xt.setValue(B,"batchingColorTexture",X._colorsTexture,Xe));let Ii=J.morphAttributes;if((Ii.position!==void 0||Ii.normal!==void 0||Ii.color!==void 0)&&ee.update(X,J,Dn),(tr||Ie.receiveShadow!==X.receiveShadow)&&(Ie.receiveShadow=X.receiveShadow,xt.setValue(B,"receiveShadow",X.receiveShadow)),(H.isMeshStandardMaterial||H.isMeshLambertMaterial||H.isMeshPhongMaterial)&&H.envMap===null&&k.environment!==null&&(En.envMapIntensity.value=k.environmentIntensity),En.dfgLUT!==void 0&&(En.dfgLUT.value=WA()),tr){if(xt.setValue(B,"toneMappingExposure",E.toneMappingExposure),Ie.needsLights&&hS(En,Pr),be&&H.fog===!0&&fe.refreshFogUniforms(En,be),fe.refreshMaterialUniforms(En,H,re,ue,y.state.transmissionRenderTarget[R.id]),Ie.needsLights&&Ie.numLightProbeGrids>0){let jt=b,vn=0;for(let Ts of y.state.lightProbeGridArray)Ts.texture!==null&&(jt.textures[vn]=Ts.texture,jt.min[vn]=Ts.boundingBox.min,jt.max[vn]=Ts.boundingBox.max,jt.resolution[vn]=Ts.resolution,vn++);for(let Ts in jt)jt[Ts].length=vn;En.probesSH.value=jt.textures,En.probesMin.value=jt.min,En.probesMax.value=jt.max,En.probesResolution.value=jt.resolution}sa.upload(B,x0(Ie),En,Xe)}if(H.isShaderMaterial&&H.uniformsNeedUpdate===!0&&(sa.upload(B,x0(Ie),En,Xe),H.uniformsNeedUpdate=!1),H.isSpriteMaterial&&xt.setValue(B,"center",X.center),xt.setValue(B,"modelViewMatrix",X.modelViewMatrix),xt.setValue(B,"normalMatrix",X.normalMatrix),xt.setValue(B,"modelMatrix",X.matrixWorld),H.uniformsGroups!==void 0){let jt=H.uniformsGroups;for(let vn=0,Ts=jt.length;vn<Ts;vn++){let S0=jt[vn];ze.update(S0,Dn),ze.bind(S0,Dn)}}return Dn}function hS(R,k){R.ambientLightColor.needsUpdate=k,R.lightProbe.needsUpdate=k,R.sunLights.needsUpdate=k,R.sunLightShadows.needsUpdate=k,R.directionalLights.needsUpdate=k,R.directionalLightShadows.needsUpdate=k,R.pointLights.needsUpdate=k,R.pointLightShadows.needsUpdate=k,R.spotLights.needsUpdate=k,R.spotLightShadows.needsUpdate=k,R.rectAreaLights.needsUpdate=k,R.hemisphereLights.needsUpdate=k}function dS(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return V},this.getActiveMipmapLevel=function(){return F},this.getRenderTarget=function(){return ie},this.setRenderTargetTextures=function(R,k,J){let H=Oe.get(R);H.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,H.__autoAllocateDepthBuffer===!1&&(H.__useRenderToTexture=!1),Oe.get(R.texture).__webglTexture=k,Oe.get(R.depthTexture).__webglTexture=H.__autoAllocateDepthBuffer?void 0:J,H.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,k){let J=Oe.get(R);J.__webglFramebuffer=k,J.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(R,k=0,J=0){ie=R,V=k,F=J;let H=null,X=!1,be=!1;if(R){let ye=Oe.get(R);if(ye.__useDefaultFramebuffer!==void 0){xe.bindFramebuffer(B.FRAMEBUFFER,ye.__webglFramebuffer),W.copy(R.viewport),_e.copy(R.scissor),Te=R.scissorTest,xe.viewport(W),xe.scissor(_e),xe.setScissorTest(Te),z=-1;return}else if(ye.__webglFramebuffer===void 0)Xe.setupRenderTarget(R);else if(ye.__hasExternalTextures)Xe.rebindTextures(R,Oe.get(R.texture).__webglTexture,Oe.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let Ze=R.depthTexture;if(ye.__boundDepthTexture!==Ze){if(Ze!==null&&Oe.has(Ze)&&(R.width!==Ze.image.width||R.height!==Ze.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(R)}}let Ee=R.texture;(Ee.isData3DTexture||Ee.isDataArrayTexture||Ee.isCompressedArrayTexture)&&(be=!0);let De=Oe.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(De[k])?H=De[k][J]:H=De[k],X=!0):R.samples>0&&Xe.useMultisampledRTT(R)===!1?H=Oe.get(R).__webglMultisampledFramebuffer:Array.isArray(De)?H=De[J]:H=De,W.copy(R.viewport),_e.copy(R.scissor),Te=R.scissorTest}else W.copy(Ae).multiplyScalar(re).floor(),_e.copy(Ve).multiplyScalar(re).floor(),Te=Le;if(J!==0&&(H=U),xe.bindFramebuffer(B.FRAMEBUFFER,H)&&xe.drawBuffers(R,H),xe.viewport(W),xe.scissor(_e),xe.setScissorTest(Te),X){let ye=Oe.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+k,ye.__webglTexture,J)}else if(be){let ye=k;for(let Ee=0;Ee<R.textures.length;Ee++){let De=Oe.get(R.textures[Ee]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ee,De.__webglTexture,J,ye)}}else if(R!==null&&J!==0){let ye=Oe.get(R.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ye.__webglTexture,J)}z=-1};function b0(R){let k=Oe.get(R);return(k.__readFormat!==R.format||k.__readType!==R.type)&&(k.__readFormat=R.format,k.__readType=R.type,k.__formatReadable=Ut.textureFormatReadable(R.format),k.__typeReadable=Ut.textureTypeReadable(R.type)),k}this.readRenderTargetPixels=function(R,k,J,H,X,be,Re,ye=0){if(!(R&&R.isWebGLRenderTarget)){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ee=Oe.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Re!==void 0&&(Ee=Ee[Re],Array.isArray(Ee)&&(Ee=Ee[0])),Ee){xe.bindFramebuffer(B.FRAMEBUFFER,Ee);try{let De=R.textures[ye],Ze=De.format,dt=De.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+ye);let Pe=b0(De);if(Pe.__formatReadable===!1){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Pe.__typeReadable===!1){qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=R.width-H&&J>=0&&J<=R.height-X&&B.readPixels(k,J,H,X,he.convert(Ze),he.convert(dt),be)}finally{let De=ie!==null?Oe.get(ie).__webglFramebuffer:null;xe.bindFramebuffer(B.FRAMEBUFFER,De)}}},this.readRenderTargetPixelsAsync=async function(R,k,J,H,X,be,Re,ye=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ee=Oe.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Re!==void 0&&(Ee=Ee[Re],Array.isArray(Ee)&&(Ee=Ee[0])),Ee)if(k>=0&&k<=R.width-H&&J>=0&&J<=R.height-X){xe.bindFramebuffer(B.FRAMEBUFFER,Ee);let De=R.textures[ye],Ze=De.format,dt=De.type;R.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+ye);let Pe=b0(De);if(Pe.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Pe.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ft=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,ft),B.bufferData(B.PIXEL_PACK_BUFFER,be.byteLength,B.STREAM_READ),B.readPixels(k,J,H,X,he.convert(Ze),he.convert(dt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let ln=ie!==null?Oe.get(ie).__webglFramebuffer:null;xe.bindFramebuffer(B.FRAMEBUFFER,ln);let Xt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await vy(B,Xt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,ft),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,be),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(ft),B.deleteSync(Xt),be}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,k=null,J=0){let H=Math.pow(2,-J),X=Math.floor(R.image.width*H),be=Math.floor(R.image.height*H),Re=k!==null?k.x:0,ye=k!==null?k.y:0;Xe.setTexture2D(R,0),B.copyTexSubImage2D(B.TEXTURE_2D,J,0,0,Re,ye,X,be),xe.unbindTexture()},this.copyTextureToTexture=function(R,k,J=null,H=null,X=0,be=0){let Re,ye,Ee,De,Ze,dt,Pe,ft,ln,Xt=R.isCompressedTexture?R.mipmaps[be]:R.image;if(J!==null)Re=J.max.x-J.min.x,ye=J.max.y-J.min.y,Ee=J.isBox3?J.max.z-J.min.z:1,De=J.min.x,Ze=J.min.y,dt=J.isBox3?J.min.z:0;else{let xt=Math.pow(2,-X);Re=Math.floor(Xt.width*xt),ye=Math.floor(Xt.height*xt),R.isDataArrayTexture?Ee=Xt.depth:R.isData3DTexture?Ee=Math.floor(Xt.depth*xt):Ee=1,De=0,Ze=0,dt=0}H!==null?(Pe=H.x,ft=H.y,ln=H.z):(Pe=0,ft=0,ln=0);let Bt=he.convert(k.format),Nn=he.convert(k.type),Ie;k.isData3DTexture?(Xe.setTexture3D(k,0),Ie=B.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(Xe.setTexture2DArray(k,0),Ie=B.TEXTURE_2D_ARRAY):(Xe.setTexture2D(k,0),Ie=B.TEXTURE_2D),xe.activeTexture(B.TEXTURE0),xe.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,k.flipY),xe.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),xe.pixelStorei(B.UNPACK_ALIGNMENT,k.unpackAlignment);let Xn=xe.getParameter(B.UNPACK_ROW_LENGTH),Mt=xe.getParameter(B.UNPACK_IMAGE_HEIGHT),Cr=xe.getParameter(B.UNPACK_SKIP_PIXELS),Dn=xe.getParameter(B.UNPACK_SKIP_ROWS),Kc=xe.getParameter(B.UNPACK_SKIP_IMAGES);xe.pixelStorei(B.UNPACK_ROW_LENGTH,Xt.width),xe.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Xt.height),xe.pixelStorei(B.UNPACK_SKIP_PIXELS,De),xe.pixelStorei(B.UNPACK_SKIP_ROWS,Ze),xe.pixelStorei(B.UNPACK_SKIP_IMAGES,dt);let tr=R.isDataArrayTexture||R.isData3DTexture,Pr=k.isDataArrayTexture||k.isData3DTexture;if(R.isDepthTexture){let xt=Oe.get(R),En=Oe.get(k),Ii=Oe.get(xt.__renderTarget),jt=Oe.get(En.__renderTarget);xe.bindFramebuffer(B.READ_FRAMEBUFFER,Ii.__webglFramebuffer),xe.bindFramebuffer(B.DRAW_FRAMEBUFFER,jt.__webglFramebuffer);for(let vn=0;vn<Ee;vn++)tr&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Oe.get(R).__webglTexture,X,dt+vn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Oe.get(k).__webglTexture,be,ln+vn)),B.blitFramebuffer(De,Ze,De+Re,Ze+ye,Pe,ft,Pe+Re,ft+ye,B.DEPTH_BUFFER_BIT,B.NEAREST);xe.bindFramebuffer(B.READ_FRAMEBUFFER,null),xe.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(X!==0||R.isRenderTargetTexture||Oe.has(R)){let xt=Oe.get(R),En=Oe.get(k);xe.bindFramebuffer(B.READ_FRAMEBUFFER,I),xe.bindFramebuffer(B.DRAW_FRAMEBUFFER,D);for(let Ii=0;Ii<Ee;Ii++)tr?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,xt.__webglTexture,X,dt+Ii):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,xt.__webglTexture,X),Pr?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,En.__webglTexture,be,ln+Ii):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,En.__webglTexture,be),X!==0?B.blitFramebuffer(De,Ze,De+Re,Ze+ye,Pe,ft,Pe+Re,ft+ye,B.COLOR_BUFFER_BIT,B.NEAREST):Pr?B.copyTexSubImage3D(Ie,be,Pe,ft,ln+Ii,De,Ze,Re,ye):B.copyTexSubImage2D(Ie,be,Pe,ft,De,Ze,Re,ye);xe.bindFramebuffer(B.READ_FRAMEBUFFER,null),xe.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Pr?R.isDataTexture||R.isData3DTexture?B.texSubImage3D(Ie,be,Pe,ft,ln,Re,ye,Ee,Bt,Nn,Xt.data):k.isCompressedArrayTexture?B.compressedTexSubImage3D(Ie,be,Pe,ft,ln,Re,ye,Ee,Bt,Xt.data):B.texSubImage3D(Ie,be,Pe,ft,ln,Re,ye,Ee,Bt,Nn,Xt):R.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,be,Pe,ft,Re,ye,Bt,Nn,Xt.data):R.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,be,Pe,ft,Xt.width,Xt.height,Bt,Xt.data):B.texSubImage2D(B.TEXTURE_2D,be,Pe,ft,Re,ye,Bt,Nn,Xt);xe.pixelStorei(B.UNPACK_ROW_LENGTH,Xn),xe.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Mt),xe.pixelStorei(B.UNPACK_SKIP_PIXELS,Cr),xe.pixelStorei(B.UNPACK_SKIP_ROWS,Dn),xe.pixelStorei(B.UNPACK_SKIP_IMAGES,Kc),be===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&B.generateMipmap(Ie),xe.unbindTexture()},this.initRenderTarget=function(R){Oe.get(R).__webglFramebuffer===void 0&&Xe.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?Xe.setTextureCube(R,0):R.isData3DTexture?Xe.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?Xe.setTexture2DArray(R,0):Xe.setTexture2D(R,0),xe.unbindTexture()},this.resetState=function(){V=0,F=0,ie=null,xe.reset(),pe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ei}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=st._getDrawingBufferColorSpace(e),t.unpackColorSpace=st._getUnpackColorSpace()}};var ix=["#c2413b","#3d8b4f","#3a6fb5"],XA=27,rd=class{constructor(e,t,n){this.box=e;this.stage=t;this.build(n)}box;stage;arms=[];build(e){this.arms=[],this.box.replaceChildren();for(let t of[0,1,2])for(let n of[-1,1]){let s=[0,0,0];s[t]=n;let r=e.up===2?[s[0],s[2],-s[1]]:s,o="XYZ"[t],a=n>0?Un("line",{stroke:ix[t]}):null,l=Un("circle",{r:n>0?8.5:5.5,fill:ix[t],"fill-opacity":n>0?1:.35}),c=Un("g",{tabindex:0,role:"button","aria-label":`Look from ${n>0?"":"minus "}${o}`},l,...n>0?[Un("text",{},o)]:[]),u=()=>this.stage.look([r[0],r[1],r[2]+(Math.abs(r[1])>.5?.001:0)]);c.addEventListener("click",u),c.addEventListener("keydown",h=>{["Enter"," "].includes(h.key)&&(h.preventDefault(),u())}),this.arms.push({direction:r,line:a,tip:c})}this.place()}place(){let e=this.arms.map(t=>({arm:t,at:new P(...t.direction).applyQuaternion(this.stage.camera.quaternion.clone().invert()).multiplyScalar(XA)}));e.sort((t,n)=>t.at.z-n.at.z);for(let{arm:t,at:n}of e){let[s,r]=[n.x.toFixed(1),(-n.y).toFixed(1)];t.line?.setAttribute("x2",s),t.line?.setAttribute("y2",r),t.tip.setAttribute("transform",`translate(${s} ${r})`)}if(!this.box.contains(document.activeElement)){let t=e.flatMap(({arm:n})=>[n.line,n.tip]).filter(n=>n!==null);t.some((n,s)=>this.box.children[s]!==n)&&this.box.append(...t)}}};var to=i=>Array.isArray(i)?i:[],hs=i=>to(i.cables),sx=(i,e)=>to(to(i.boundaries)[e]);function mr(i,{boundary:e=0,from:t,to:n}){let s=sx(i,e).length;if(!(t<s&&n<s&&t>=0&&n>=0))return[];let r=[t];for(;r.at(-1)!==n&&r.length<=s;)r.push((r.at(-1)+1)%s);return r}var fm=(i,e,t)=>hs(i).findIndex(({along:n})=>n&&(n.boundary??0)===e&&mr(i,n).slice(0,-1).includes(t)),qA=(i,e)=>{let t=mr(i,e).map(s=>Dt(sx(i,e.boundary??0)[s])),n=0;for(let s=1;s<t.length;s+=1)n+=Math.hypot(...[0,1,2].map(r=>(t[s]?.[r]??0)-(t[s-1]?.[r]??0)));return n},sc=i=>Number(i.toPrecision(2));function od(i,e,t){let n=qA(i,e)||1,r=((Array.isArray(i.layers)?i.layers:[i.film]).reduce((o,a)=>o+(Number(a?.tension)||0),0)||1)*n;return sc(t==="force_density"?r/n:t==="length"?1.05*n:t==="unstressed_length"?1.045*n:t==="sag"?.13*n:r)}function rx(i,e,t,n){let s=hs(i),r={boundary:e,from:t,to:n},o=mr(i,r).slice(0,-1),a=s.at(-1),l=s.filter(d=>!d.along||(d.along.boundary??0)!==e||!mr(i,d.along).slice(0,-1).some(f=>o.includes(f))),c=a?.along?a.mode??"force":"force",u=["force","end_tension","horizontal_component"],h=a?.along&&u.includes(c)?a.value:od(i,r,c);return l.push({along:r,mode:c,value:h,...c==="unstressed_length"&&{axial_stiffness:a?.axial_stiffness??100*h}}),i.cables=l,l.length-1}function ox(i,e){hs(i).splice(e,1)}function pm(i){let e=to(i.supports);return{stretches:[...hs(i),...e].flatMap(({along:t})=>t?[t]:[]),points:[...to(i.free_points),...e.flatMap(({point:t})=>t?[t]:[])]}}function ax(i,e,t){let{stretches:n,points:s}=pm(i);for(let r of n.filter(o=>(o.boundary??0)===e))r.from>t&&(r.from+=1),r.to>t&&(r.to+=1);for(let r of s)(r.boundary??0)===e&&r.point>t&&(r.point+=1)}function lx(i,e,t,n){let{stretches:s,points:r}=pm(i),o=new Set;for(let a of s.filter(l=>(l.boundary??0)===e)){a.from===t&&a.to===(t+1)%(n+1)&&o.add(a);let l=a.to>=t?a.to-1:a.to;a.from=(a.from>t?a.from-1:a.from)%Math.max(n,1),a.to=(l+n)%Math.max(n,1),a.from===a.to&&o.add(a)}for(let a of r.filter(l=>(l.boundary??0)===e))a.point===t?o.add(a):a.point>t&&(a.point-=1);ux(i,o)}function cx(i,e){let{stretches:t,points:n}=pm(i),s=new Set([...t,...n].filter(r=>(r.boundary??0)===e));for(let r of[...t,...n])(r.boundary??0)>e&&(r.boundary=(r.boundary??0)-1);for(let r of to(i.supports))r.boundary===e?s.add(r):(r.boundary??-1)>e&&(r.boundary-=1);ux(i,s)}function ux(i,e){let t=n=>!e.has(n)&&!e.has(n.along)&&!e.has(n.point);for(let n of["cables","supports","free_points"])Array.isArray(i[n])&&(i[n]=to(i[n]).filter(t))}var dx=1e-9,YA=800,ds=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],$A=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]],rc=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],aa=i=>Math.hypot(...i);function ad(i){return i.flatMap((e,t)=>Nr(e)?hx(e,t):[...hx(e,t),...KA(e,t)])}function hx(i,e){return i.points.flatMap((t,n)=>k0(t)?[]:[{line:e,points:[n],text:`${i.name}, point ${n+1} is not three numbers`}])}function KA(i,e){let t=i.points.map(Dt);if(t.some(c=>c===null)||t.length<2)return[];let n=t,s=Math.max(...n.map(c=>aa(ds(c,n[0]))),0),r=[],o=i.closed&&n.length>2?n.length:n.length-1;for(let c=0;c<o;c+=1){let u=(c+1)%n.length;aa(ds(n[c],n[u]))<=dx*s&&r.push({line:e,points:[c,u],text:`${i.name}, points ${c+1} and ${u+1} are the same`})}if(i.closed&&s>0&&JA(n,s))return[...r,{line:e,points:n.map((c,u)=>u),text:`${i.name}: all points lie on one line`}];let a=new Set(r.map(({points:[,c]})=>c)),l=n.map((c,u)=>u).filter(c=>!a.has(c));return i.closed&&l.length<=YA&&r.push(...jA(i,e,l.map(c=>n[c]),l,s)),r}function JA(i,e){let t=i[0],n=i.reduce((r,o)=>aa(ds(o,t))>aa(ds(r,t))?o:r),s=ds(n,t);return i.every(r=>aa($A(s,ds(r,t)))<=1e-9*e*e)}function jA(i,e,t,n,s){let r=[],o=t.length;for(let a=0;a<o&&r.length<4;a+=1)for(let l=a+2;l<o&&r.length<4;l+=1){if(a===0&&l===o-1)continue;let[c,u,h,d]=[t[a],t[(a+1)%o],t[l],t[(l+1)%o]];if(ZA(c,u,h,d)>dx*s)continue;let f=[a,(a+1)%o,l,(l+1)%o].map(v=>n[v]),[g,x,m,_]=f.map(v=>v+1);r.push({line:e,points:f,text:`${i.name}: the edge from point ${g} to ${x} meets the edge from ${m} to ${_}`})}return r}function ZA(i,e,t,n){let s=ds(e,i),r=ds(n,t),o=ds(i,t),a=rc(s,s),l=rc(s,r),c=rc(r,r),u=rc(s,o),h=rc(r,o),d=a*c-l*l,f=m=>Math.min(1,Math.max(0,m)),g=d>1e-14*a*c?f((l*h-c*u)/d):0,x=c>0?f((l*g+h)/c):0;return g=a>0?f((l*x-u)/a):0,x=c>0?f((l*g+h)/c):0,aa(ds([i[0]+g*s[0],i[1]+g*s[1],i[2]+g*s[2]],[t[0]+x*r[0],t[1]+x*r[1],t[2]+x*r[2]]))}var QA={force:i=>i,end_tension:i=>i,horizontal_component:i=>i,force_density:(i,e)=>`${i}/${e}`,length:(i,e)=>e,unstressed_length:(i,e)=>e,sag:(i,e)=>e},fx=i=>i.units?.force??"kN";function px(i,e,t,n){if(!e)return;let s=e.mode??"force";Y("cable-name").textContent=e.name??`Cable ${t+1}`;let r=Y("cable-mode");r.replaceChildren(...n.map(({name:o,help:a})=>te("option",{value:o,title:a??""},Zt(o)))),r.value=s,Y("cable-unit").textContent=QA[s]?.(fx(i),hi(i))??"",Y("stiffness-unit").textContent=fx(i);for(let[o,a]of[["cable-value",e.value],["cable-stiffness",e.axial_stiffness??""]]){let l=Y(o);(document.activeElement!==l||!l.dataset.dirty)&&(l.value=String(a))}}function mx(i,e,t,n){let s=a=>Number(a.toPrecision(6)),r=n?{force:n.force,end_tension:n.force,horizontal_component:n.force,force_density:n.force/n.length,length:n.length,unstressed_length:n.unstressed_length,sag:n.sag}:{};e.mode=t;let o=r[t];e.value=o?s(o):od(i,e.along,t),t==="unstressed_length"&&!e.axial_stiffness&&(e.axial_stiffness=s(100*(n?.force??od(i,e.along,"force"))),n&&(e.value=s(n.length/(1+n.force/e.axial_stiffness))))}var ld=class{document;past=[];future=[];opened=null;constructor(e){this.document=e}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}begin(){this.opened??=JSON.stringify(this.document)}commit(){let e=this.opened;if(this.opened=null,e===null||e===JSON.stringify(this.document))return!1;this.past.push(e),this.future=[];let t=this.past.reduce((n,s)=>n+s.length,0);for(;this.past.length>500||t>4e7&&this.past.length>1;)t-=this.past.shift().length;return!0}edit(e){let t=this.opened!==null;return this.begin(),e(this.document),t||this.commit()}undo(){return this.step(this.past,this.future)}redo(){return this.step(this.future,this.past)}step(e,t){this.opened!==null&&this.commit();let n=e.pop();return n===void 0?!1:(t.push(JSON.stringify(this.document)),this.document=JSON.parse(n),!0)}};Se.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new ke},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Qn.line={uniforms:Ql.merge([Se.common,Se.fog,Se.line]),vertexShader:`
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
		`};var la=class extends mn{constructor(e){super({type:"LineMaterial",uniforms:Ql.clone(Qn.line.uniforms),vertexShader:Qn.line.vertexShader,fragmentShader:Qn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var gx=new tt,cd=new P,ca=class extends Bl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new fn(e,3)),this.setAttribute("uv",new fn(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new dr(t,6,1);return this.setAttribute("instanceStart",new si(n,3,0)),this.setAttribute("instanceEnd",new si(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new dr(t,6,1);return this.setAttribute("instanceColorStart",new si(n,3,0)),this.setAttribute("instanceColorEnd",new si(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Pl(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tt);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),gx.setFromBufferAttribute(t),this.boundingBox.union(gx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vt),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)cd.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(cd)),cd.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(cd));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var mm=new ct,_x=new P,yx=new P,Rn=new ct,Cn=new ct,fs=new ct,gm=new P,_m=new Ce,Pn=new Tn,xx=new P,ud=new tt,hd=new Vt,ps=new ct,ms,no;function vx(i,e,t){return ps.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),ps.multiplyScalar(1/ps.w),ps.x=no/t.width,ps.y=no/t.height,ps.applyMatrix4(i.projectionMatrixInverse),ps.multiplyScalar(1/ps.w),Math.abs(Math.max(ps.x,ps.y))}function eR(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Pn.start.fromBufferAttribute(s,a),Pn.end.fromBufferAttribute(r,a),Pn.applyMatrix4(t);let c=new P,u=new P;ms.distanceSqToSegment(Pn.start,Pn.end,u,c),u.distanceTo(c)<no*.5&&e.push({point:u,pointOnLine:c,distance:ms.origin.distanceTo(u),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function tR(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),h=-e.near;ms.at(1,fs),fs.w=1,fs.applyMatrix4(e.matrixWorldInverse),fs.applyMatrix4(n),fs.multiplyScalar(1/fs.w),fs.x*=r.x/2,fs.y*=r.y/2,fs.z=0,gm.copy(fs),_m.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,f=u;d<f;d++){if(Rn.fromBufferAttribute(l,d),Cn.fromBufferAttribute(c,d),Rn.w=1,Cn.w=1,Rn.applyMatrix4(_m),Cn.applyMatrix4(_m),Rn.z>h&&Cn.z>h)continue;if(Rn.z>h){let M=Rn.z-Cn.z,b=(Rn.z-h)/M;Rn.lerp(Cn,b)}else if(Cn.z>h){let M=Cn.z-Rn.z,b=(Cn.z-h)/M;Cn.lerp(Rn,b)}Rn.applyMatrix4(n),Cn.applyMatrix4(n),Rn.multiplyScalar(1/Rn.w),Cn.multiplyScalar(1/Cn.w),Rn.x*=r.x/2,Rn.y*=r.y/2,Cn.x*=r.x/2,Cn.y*=r.y/2,Pn.start.copy(Rn),Pn.start.z=0,Pn.end.copy(Cn),Pn.end.z=0;let x=Pn.closestPointToPointParameter(gm,!0);Pn.at(x,xx);let m=ia.lerp(Rn.z,Cn.z,x),_=m>=-1&&m<=1,v=gm.distanceTo(xx)<no*.5;if(_&&v){Pn.start.fromBufferAttribute(l,d),Pn.end.fromBufferAttribute(c,d),Pn.start.applyMatrix4(o),Pn.end.applyMatrix4(o);let M=new P,b=new P;ms.distanceSqToSegment(Pn.start,Pn.end,b,M),t.push({point:b,pointOnLine:M,distance:ms.origin.distanceTo(b),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var dd=class extends Pt{constructor(e=new ca,t=new la({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)_x.fromBufferAttribute(t,o),yx.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+_x.distanceTo(yx);let r=new dr(s,2,1);return e.setAttribute("instanceDistanceStart",new si(r,1,0)),e.setAttribute("instanceDistanceEnd",new si(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ms=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;no=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),hd.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=no*.5;else{let h=Math.max(s.near,hd.distanceToPoint(ms.origin));c=vx(s,h,l.resolution)}if(hd.radius+=c,ms.intersectsSphere(hd)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),ud.copy(a.boundingBox).applyMatrix4(o);let u;if(n)u=no*.5;else{let h=Math.max(s.near,ud.distanceToPoint(ms.origin));u=vx(s,h,l.resolution)}ud.expandByScalar(u),ms.intersectsBox(ud)!==!1&&(n?eR(this,t):tR(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(mm),this.material.uniforms.resolution.value.set(mm.z,mm.w))}};var ua=Math.pow(2,-24),oc=Symbol("SKIP_GENERATION"),fd={strategy:0,maxDepth:40,targetLeafSize:10,useSharedArrayBuffer:!1,setBoundingBox:!0,onProgress:null,indirect:!1,verbose:!0,range:null,[oc]:!1};function Ht(i,e,t){return t.min.x=e[i],t.min.y=e[i+1],t.min.z=e[i+2],t.max.x=e[i+3],t.max.y=e[i+4],t.max.z=e[i+5],t}function ac(i){let e=-1,t=-1/0;for(let n=0;n<3;n++){let s=i[n+3]-i[n];s>t&&(t=s,e=n)}return e}function ym(i,e,t){for(let n=0;n<3;n++){let s=e[i+2*n],r=e[i+2*n+1],o=s-r,a=s+r;o<t[n]&&(t[n]=o),a>t[n+3]&&(t[n+3]=a)}}function pd(i){let e=i[3]-i[0],t=i[4]-i[1],n=i[5]-i[2];return 2*(e*t+t*n+n*e)}function yt(i,e){return e[i+15]===65535}function It(i,e){return e[i+6]}function Ft(i,e){return e[i+14]}function Et(i){return i+8}function Tt(i,e){let t=e[i+6];return i+t*8}function ha(i,e){return e[i+7]}function md(i,e,t,n,s){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0,h=1/0,d=1/0,f=1/0,g=-1/0,x=-1/0,m=-1/0,_=i.offset||0;for(let v=(e-_)*6,M=(e+t-_)*6;v<M;v+=6){let b=i[v+0],S=i[v+1],y=b-S,p=b+S;y<r&&(r=y),p>l&&(l=p),b<h&&(h=b),b>g&&(g=b);let w=i[v+2],T=i[v+3],E=w-T,C=w+T;E<o&&(o=E),C>c&&(c=C),w<d&&(d=w),w>x&&(x=w);let O=i[v+4],U=i[v+5],I=O-U,D=O+U;I<a&&(a=I),D>u&&(u=D),O<f&&(f=O),O>m&&(m=O)}n[0]=r,n[1]=o,n[2]=a,n[3]=l,n[4]=c,n[5]=u,s[0]=h,s[1]=d,s[2]=f,s[3]=g,s[4]=x,s[5]=m}var _s=8,vm=8,xm=new Int32Array(_s),gs=new Float32Array(_s*6),da=new Float32Array(_s*6),Vi=new Float32Array(6),gd=new Float32Array(6),gr=new Int32Array(vm),Sx=new Float32Array(vm*6);function sR(i,e,t,n){for(let s=0;s<3;s++){let r=e[i+2*s],o=e[i+2*s+1],a=r-o,l=r+o;a<t[n+s]&&(t[n+s]=a),l>t[n+s+3]&&(t[n+s+3]=l)}}function wx(i,e){let t=i[e+3]-i[e],n=i[e+4]-i[e+1],s=i[e+5]-i[e+2];return 2*(t*n+n*s+s*t)}function Mx(i,e,t,n,s,r){let o=-1,a=0;if(r===0)o=ac(e),o!==-1&&(a=(e[o]+e[o+3])/2);else if(r===1)o=ac(i),o!==-1&&(a=rR(t,n,s,o));else if(r===2){let l=pd(i),c=1.25*s,u=t.offset||0,h=(n-u)*6,d=(n+s-u)*6;for(let f=0;f<3;f++){let g=e[f],_=(e[f+3]-g)/_s;if(s<vm){for(let v=0;v<s;v++){let M=h+v*6,b=t[M+2*f],S=v;for(;S>0&&t[gr[S-1]+2*f]>b;)gr[S]=gr[S-1],S--;gr[S]=M}for(let v=0;v<3;v++)Vi[v]=1/0,Vi[v+3]=-1/0,gd[v]=1/0,gd[v+3]=-1/0;for(let v=s-1;v>=0;v--)ym(gr[v],t,gd),Sx.set(gd,v*6);for(let v=0;v<s-1;v++){ym(gr[v],t,Vi);let M=t[gr[v+1]+2*f];if(t[gr[v]+2*f]===M)continue;let b=v+1,S=s-b,y=pd(Vi)/l,p=wx(Sx,b*6)/l,w=1+1.25*(y*b+p*S);w<c&&(o=f,c=w,a=M)}}else{for(let b=0;b<_s;b++){xm[b]=0;for(let S=0;S<3;S++)gs[b*6+S]=1/0,gs[b*6+S+3]=-1/0}for(let b=h;b<d;b+=6){let p=~~((t[b+2*f]-g)/_);p>=_s&&(p=_s-1),xm[p]++,sR(b,t,gs,p*6)}let v=(_s-1)*6;for(let b=0;b<6;b++)da[v+b]=gs[v+b];for(let b=_s-2;b>=0;b--){let S=b*6,y=S+6;for(let p=0;p<3;p++)da[S+p]=Math.min(gs[S+p],da[y+p]),da[S+p+3]=Math.max(gs[S+p+3],da[y+p+3])}let M=0;for(let b=0;b<_s-1;b++){let S=b*6,y=xm[b];if(y!==0)for(let C=0;C<3;C++)M===0?(Vi[C]=gs[S+C],Vi[C+3]=gs[S+C+3]):(Vi[C]=Math.min(Vi[C],gs[S+C]),Vi[C+3]=Math.max(Vi[C+3],gs[S+C+3]));M+=y;let p=0,w=0;M!==0&&(p=pd(Vi)/l);let T=s-M;T!==0&&(w=wx(da,S+6)/l);let E=1+1.25*(p*M+w*T);E<c&&(o=f,c=E,a=g+_+b*_)}}}}else console.warn(`BVH: Invalid build strategy value ${r} used.`);return{axis:o,pos:a}}function rR(i,e,t,n){let s=0,r=i.offset;for(let o=e,a=e+t;o<a;o++)s+=i[(o-r)*6+n*2];return s/t}function Ex(i,e,t,n,s,r){let o=n,a=n+s-1,l=r.pos,c=r.axis*2,u=t.offset||0;for(;;){for(;o<=a&&t[(o-u)*6+c]<l;)o++;for(;o<=a&&t[(a-u)*6+c]>=l;)a--;if(o<a){for(let h=0;h<e;h++){let d=i[o*e+h];i[o*e+h]=i[a*e+h],i[a*e+h]=d}for(let h=0;h<6;h++){let d=o-u,f=a-u,g=t[d*6+h];t[d*6+h]=t[f*6+h],t[f*6+h]=g}o++,a--}else return o}}var oR=Math.pow(2,32),fa=new Float32Array(6),_d=new Float32Array(6);function aR(i,e,t,n,s,r){let{maxDepth:o,verbose:a,targetLeafSize:l,_strictLeafSize:c=1/0,strategy:u,onProgress:h,useSharedArrayBuffer:d=!1}=s,f=i.primitiveBuffer,g=i.primitiveBufferStride,x=d?SharedArrayBuffer:ArrayBuffer,m=new x(32*Math.max(1,2*Math.ceil(n)-1)),_=new Float32Array(m),v=new Uint32Array(m),M=new Uint16Array(m),b=0,S=!1;return md(e,t,n,fa,_d),w(t,n,0),m.slice(0,b*32);function y(T){h&&h((T-r.offset)/r.count)}function p(T,E,C){let O=T*2;v[T+6]=E,M[O+14]=C,M[O+15]=65535,y(E+C)}function w(T,E,C){let O=b++,U=O*8;_.set(fa,U),!S&&C>=o&&(S=!0,a&&console.warn(`BVH: Max depth of ${o} reached when generating BVH. Consider increasing maxDepth.`));let I=E>c;if(E<=l&&!I||C>=o){p(U,T,E);return}let D=Mx(fa,_d,e,T,E,u),V=D.axis===-1?-1:Ex(f,g,e,T,E,D);if(D.axis===-1||V===T||V===T+E){if(!I){p(U,T,E);return}D.axis=Math.max(0,ac(fa)),V=T+Math.max(1,Math.floor(E/2))}v[U+7]=D.axis;let F=V-T;md(e,T,F,fa,_d),w(T,F,C+1);let ie=b-O;if(ie>oR)throw new Error("MeshBVH: Cannot store relative child node offset greater than 32 bits.");v[U+6]=ie;let z=E-F;md(e,V,z,fa,_d),w(V,z,C+1)}}function Tx(i,e){let t=i.getRootRanges(e.range),n=t[0],s=t[t.length-1],r={offset:n.offset,count:s.offset+s.count-n.offset},o=new Float32Array(6*r.count);o.offset=r.offset,i.computePrimitiveBounds(r.offset,r.count,o),i._roots=t.map(a=>aR(i,o,a.offset,a.count,e,r))}var _r=class{constructor(e){this._getNewPrimitive=e,this._primitives=[]}getPrimitive(){let e=this._primitives;return e.length===0?this._getNewPrimitive():e.pop()}releasePrimitive(e){this._primitives.push(e)}};var bm=class{constructor(){this.float32Array=null,this.uint16Array=null,this.uint32Array=null;let e=[],t=null;this.setBuffer=n=>{t&&e.push(t),t=n,this.float32Array=new Float32Array(n),this.uint16Array=new Uint16Array(n),this.uint32Array=new Uint32Array(n)},this.clearBuffer=()=>{t=null,this.float32Array=null,this.uint16Array=null,this.uint32Array=null,e.length!==0&&this.setBuffer(e.pop())}}},ut=new bm;var yr,ma,pa=[],yd=new _r(()=>new tt);function Ax(i,e,t,n,s,r){yr=yd.getPrimitive(),ma=yd.getPrimitive(),pa.push(yr,ma),ut.setBuffer(i._roots[e]);let o=Sm(0,i.geometry,t,n,s,r);ut.clearBuffer(),yd.releasePrimitive(yr),yd.releasePrimitive(ma),pa.pop(),pa.pop();let a=pa.length;return a>0&&(ma=pa[a-1],yr=pa[a-2]),o}function Sm(i,e,t,n,s=null,r=0,o=0){let{float32Array:a,uint16Array:l,uint32Array:c}=ut,u=i*2;if(yt(u,l)){let g=It(i,c),x=Ft(u,l);return Ht(i,a,yr),n(g,x,!1,o,r+i/8,yr)}else{let O=function(I){let{uint16Array:D,uint32Array:V}=ut,F=I*2;for(;!yt(F,D);)I=Et(I),F=I*2;return It(I,V)},U=function(I){let{uint16Array:D,uint32Array:V}=ut,F=I*2;for(;!yt(F,D);)I=Tt(I,V),F=I*2;return It(I,V)+Ft(F,D)};var d=O,f=U;let g=Et(i),x=Tt(i,c),m=g,_=x,v,M,b,S;if(s&&(b=yr,S=ma,Ht(m,a,b),Ht(_,a,S),v=s(b),M=s(S),M<v)){m=x,_=g;let I=v;v=M,M=I,b=S}b||(b=yr,Ht(m,a,b));let y=yt(m*2,l),p=t(b,y,v,o+1,r+m/8),w;if(p===2){let I=O(m),V=U(m)-I;w=n(I,V,!0,o+1,r+m/8,b)}else w=p&&Sm(m,e,t,n,s,r,o+1);if(w)return!0;S=ma,Ht(_,a,S);let T=yt(_*2,l),E=t(S,T,M,o+1,r+_/8),C;if(E===2){let I=O(_),V=U(_)-I;C=n(I,V,!0,o+1,r+_/8,S)}else C=E&&Sm(_,e,t,n,s,r,o+1);return!!C}}var lc=new ut.constructor,xd=new ut.constructor,xr=new _r(()=>new tt),ga=new tt,_a=new tt,Mm=new tt,Em=new tt,Tm=!1;function Rx(i,e,t,n){if(Tm)throw new Error("MeshBVH: Recursive calls to bvhcast not supported.");Tm=!0;let s=i._roots,r=e._roots,o,a=0,l=0,c=new Ce().copy(t).invert();for(let u=0,h=s.length;u<h;u++){lc.setBuffer(s[u]),l=0;let d=xr.getPrimitive();Ht(0,lc.float32Array,d),d.applyMatrix4(c);for(let f=0,g=r.length;f<g&&(xd.setBuffer(r[f]),o=Hi(0,0,t,c,n,a,l,0,0,d),xd.clearBuffer(),l+=r[f].byteLength/32,!o);f++);if(xr.releasePrimitive(d),lc.clearBuffer(),a+=s[u].byteLength/32,o)break}return Tm=!1,o}function Hi(i,e,t,n,s,r=0,o=0,a=0,l=0,c=null,u=!1){let h,d;u?(h=xd,d=lc):(h=lc,d=xd);let f=h.float32Array,g=h.uint32Array,x=h.uint16Array,m=d.float32Array,_=d.uint32Array,v=d.uint16Array,M=i*2,b=e*2,S=yt(M,x),y=yt(b,v),p=!1;if(y&&S)u?p=s(It(e,_),Ft(e*2,v),It(i,g),Ft(i*2,x),l,o+e/8,a,r+i/8):p=s(It(i,g),Ft(i*2,x),It(e,_),Ft(e*2,v),a,r+i/8,l,o+e/8);else if(y){let w=xr.getPrimitive();Ht(e,m,w),w.applyMatrix4(t);let T=Et(i),E=Tt(i,g);Ht(T,f,ga),Ht(E,f,_a);let C=w.intersectsBox(ga),O=w.intersectsBox(_a);p=C&&Hi(e,T,n,t,s,o,r,l,a+1,w,!u)||O&&Hi(e,E,n,t,s,o,r,l,a+1,w,!u),xr.releasePrimitive(w)}else{let w=Et(e),T=Tt(e,_);Ht(w,m,Mm),Ht(T,m,Em);let E=c.intersectsBox(Mm),C=c.intersectsBox(Em);if(E&&C)p=Hi(i,w,t,n,s,r,o,a,l+1,c,u)||Hi(i,T,t,n,s,r,o,a,l+1,c,u);else if(E)if(S)p=Hi(i,w,t,n,s,r,o,a,l+1,c,u);else{let O=xr.getPrimitive();O.copy(Mm).applyMatrix4(t);let U=Et(i),I=Tt(i,g);Ht(U,f,ga),Ht(I,f,_a);let D=O.intersectsBox(ga),V=O.intersectsBox(_a);p=D&&Hi(w,U,n,t,s,o,r,l,a+1,O,!u)||V&&Hi(w,I,n,t,s,o,r,l,a+1,O,!u),xr.releasePrimitive(O)}else if(C)if(S)p=Hi(i,T,t,n,s,r,o,a,l+1,c,u);else{let O=xr.getPrimitive();O.copy(Em).applyMatrix4(t);let U=Et(i),I=Tt(i,g);Ht(U,f,ga),Ht(I,f,_a);let D=O.intersectsBox(ga),V=O.intersectsBox(_a);p=D&&Hi(T,U,n,t,s,o,r,l,a+1,O,!u)||V&&Hi(T,I,n,t,s,o,r,l,a+1,O,!u),xr.releasePrimitive(O)}}return p}var vd=new class{constructor(){let i=null,e=null,t=null,n=!1;this.root=null,this.buffer=null,this.uint32Array=null,this.uint16Array=null,this.setBVH=(r,o)=>{if(n)throw new Error("BVHTraversalHelper: cannot call setBVH during an active traversal.");this.root=o,this.buffer=i=r._roots[o],this.uint16Array=t=new Uint16Array(i),this.uint32Array=e=new Uint32Array(i)},this.reset=()=>{this.root=null,this.buffer=i=null,this.uint16Array=t=null,this.uint32Array=e=null},this.getRangeStart=r=>{let o=r*2;for(;!yt(o,t);)r=Et(r),o=r*2;return It(r,e)},this.getRangeEnd=r=>{let o=r*2;for(;!yt(o,t);)r=Tt(r,e),o=r*2;return It(r,e)+Ft(o,t)};let s=(r,o,a)=>{let l=o*2,c=yt(l,t);if(!r(a,c,o)&&!c){let h=Et(o),d=Tt(o,e);s(r,h,a+1),s(r,d,a+1)}};this.traverseBuffer=r=>{if(n)throw new Error("BVHTraversalHelper: cannot start a traversal during an active traversal.");n=!0;try{s(r,0,0)}finally{n=!1}},this.traverse=r=>{this.traverseBuffer((o,a,l)=>{if(a){let c=l*2,u=e[l+6],h=t[c+14];return r(o,a,new Float32Array(i,l*4,6),u,h)}else{let c=ha(l,e);return r(o,a,new Float32Array(i,l*4,6),c)}})}}};var Cx=new tt,ya=new Float32Array(6),bd=class{constructor(){this._roots=null,this.primitiveBuffer=null,this.primitiveBufferStride=null}init(e){e={...fd,...e},"maxLeafSize"in e&&(console.warn('BVH: "maxLeafSize" option has been deprecated. Use "targetLeafSize", instead.'),e={...e,targetLeafSize:e.maxLeafSize}),Tx(this,e)}getRootRanges(){throw new Error("BVH: getRootRanges() not implemented")}writePrimitiveBounds(){throw new Error("BVH: writePrimitiveBounds() not implemented")}writePrimitiveRangeBounds(e,t,n,s){let r=1/0,o=1/0,a=1/0,l=-1/0,c=-1/0,u=-1/0;for(let h=e,d=e+t;h<d;h++){this.writePrimitiveBounds(h,ya,0);let[f,g,x,m,_,v]=ya;f<r&&(r=f),m>l&&(l=m),g<o&&(o=g),_>c&&(c=_),x<a&&(a=x),v>u&&(u=v)}return n[s+0]=r,n[s+1]=o,n[s+2]=a,n[s+3]=l,n[s+4]=c,n[s+5]=u,n}computePrimitiveBounds(e,t,n){let s=n.offset||0;for(let r=e,o=e+t;r<o;r++){this.writePrimitiveBounds(r,ya,0);let[a,l,c,u,h,d]=ya,f=(a+u)/2,g=(l+h)/2,x=(c+d)/2,m=(u-a)/2,_=(h-l)/2,v=(d-c)/2,M=(r-s)*6;n[M+0]=f,n[M+1]=m+(Math.abs(f)+m)*ua,n[M+2]=g,n[M+3]=_+(Math.abs(g)+_)*ua,n[M+4]=x,n[M+5]=v+(Math.abs(x)+v)*ua}return n}shiftPrimitiveOffsets(e){let t=this._indirectBuffer;if(t)for(let n=0,s=t.length;n<s;n++)t[n]+=e;else{let n=this._roots;for(let s=0;s<n.length;s++){let r=n[s],o=new Uint32Array(r),a=new Uint16Array(r),l=r.byteLength/32;for(let c=0;c<l;c++){let u=8*c,h=2*u;yt(h,a)&&(o[u+6]+=e)}}}}traverse(e,t=0){vd.setBVH(this,t),vd.traverse(e),vd.reset()}refit(){let e=this._roots;for(let t=0,n=e.length;t<n;t++){let s=e[t],r=new Uint32Array(s),o=new Uint16Array(s),a=new Float32Array(s),l=s.byteLength/32;for(let c=l-1;c>=0;c--){let u=c*8,h=u*2;if(yt(h,o)){let f=It(u,r),g=Ft(h,o);this.writePrimitiveRangeBounds(f,g,ya,0),a.set(ya,u)}else{let f=Et(u),g=Tt(u,r);for(let x=0;x<3;x++){let m=a[f+x],_=a[f+x+3],v=a[g+x],M=a[g+x+3];a[u+x]=m<v?m:v,a[u+x+3]=_>M?_:M}}}}}getBoundingBox(e){return e.makeEmpty(),this._roots.forEach(n=>{Ht(0,new Float32Array(n),Cx),e.union(Cx)}),e}shapecast(e){let{boundsTraverseOrder:t,intersectsBounds:n,intersectsRange:s,intersectsPrimitive:r,scratchPrimitive:o,iterate:a}=e;if(s&&r){let h=s;s=(d,f,g,x,m)=>h(d,f,g,x,m)?!0:a(d,f,this,r,g,x,o)}else s||(r?s=(h,d,f,g)=>a(h,d,this,r,f,g,o):s=(h,d,f)=>f);let l=!1,c=0,u=this._roots;for(let h=0,d=u.length;h<d;h++){let f=u[h];if(l=Ax(this,h,n,s,t,c),l)break;c+=f.byteLength/32}return l}bvhcast(e,t,n){let{intersectsRanges:s}=n;return Rx(this,e,t,s)}};function Px(){return typeof SharedArrayBuffer<"u"}function Am(i){return i.index?i.index.count:i.attributes.position.count}function vr(i){return Am(i)/3}function cR(i,e=ArrayBuffer){return i>65535?new Uint32Array(new e(4*i)):new Uint16Array(new e(2*i))}function Ix(i,e){if(!i.index){let t=i.attributes.position.count,n=e.useSharedArrayBuffer?SharedArrayBuffer:ArrayBuffer,s=cR(t,n);i.setIndex(new mt(s,1));for(let r=0;r<t;r++)s[r]=r}}function uR(i,e,t){let n=Am(i)/t,s=e||i.drawRange,r=s.start/t,o=(s.start+s.count)/t,a=Math.max(0,r),l=Math.min(n,o)-a;return{offset:Math.floor(a),count:Math.floor(l)}}function hR(i,e){return i.groups.map(t=>({offset:t.start/e,count:t.count/e}))}function Rm(i,e,t){let n=uR(i,e,t),s=hR(i,t);if(!s.length)return[n];let r=[],o=n.offset,a=n.offset+n.count,l=Am(i)/t,c=[];for(let d of s){let{offset:f,count:g}=d,x=f,m=isFinite(g)?g:l-f,_=f+m;x<a&&_>o&&(c.push({pos:Math.max(o,x),isStart:!0}),c.push({pos:Math.min(a,_),isStart:!1}))}c.sort((d,f)=>d.pos!==f.pos?d.pos-f.pos:d.type==="end"?-1:1);let u=0,h=null;for(let d of c){let f=d.pos;u!==0&&f!==h&&r.push({offset:h,count:f-h}),u+=d.isStart?1:-1,h=f}return r}function dR(i,e){let t=i[i.length-1],n=t.offset+t.count>2**16,s=i.reduce((c,u)=>c+u.count,0),r=n?4:2,o=e?new SharedArrayBuffer(s*r):new ArrayBuffer(s*r),a=n?new Uint32Array(o):new Uint16Array(o),l=0;for(let c=0;c<i.length;c++){let{offset:u,count:h}=i[c];for(let d=0;d<h;d++)a[l+d]=u+d;l+=h}return a}var Sd=class extends bd{get indirect(){return!!this._indirectBuffer}get primitiveStride(){return null}get primitiveBufferStride(){return this.indirect?1:this.primitiveStride}set primitiveBufferStride(e){}get primitiveBuffer(){return this.indirect?this._indirectBuffer:this.geometry.index.array}set primitiveBuffer(e){}constructor(e,t={}){if(e.isBufferGeometry){if(e.index&&e.index.isInterleavedBufferAttribute)throw new Error("BVH: InterleavedBufferAttribute is not supported for the index attribute.")}else throw new Error("BVH: Only BufferGeometries are supported.");if(t.useSharedArrayBuffer&&!Px())throw new Error("BVH: SharedArrayBuffer is not available.");super(),this.geometry=e,this.resolvePrimitiveIndex=t.indirect?n=>this._indirectBuffer[n]:n=>n,this.primitiveBuffer=null,this.primitiveBufferStride=null,this._indirectBuffer=null,t={...fd,...t},t[oc]||this.init(t)}init(e){let{geometry:t,primitiveStride:n}=this;if(e.indirect){let s=Rm(t,e.range,n),r=dR(s,e.useSharedArrayBuffer);this._indirectBuffer=r}else Ix(t,e);super.init(e),!t.boundingBox&&e.setBoundingBox&&(t.boundingBox=this.getBoundingBox(new tt))}getRootRanges(e){return this.indirect?[{offset:0,count:this._indirectBuffer.length}]:Rm(this.geometry,e,this.primitiveStride)}raycastObject3D(){throw new Error("BVH: raycastObject3D() not implemented")}};var gi=class{constructor(){this.min=1/0,this.max=-1/0}setFromPointsField(e,t){let n=1/0,s=-1/0;for(let r=0,o=e.length;r<o;r++){let l=e[r][t];n=l<n?l:n,s=l>s?l:s}this.min=n,this.max=s}setFromPoints(e,t){let n=1/0,s=-1/0;for(let r=0,o=t.length;r<o;r++){let a=t[r],l=e.dot(a);n=l<n?l:n,s=l>s?l:s}this.min=n,this.max=s}isSeparated(e){return this.min>e.max||e.min>this.max}};gi.prototype.setFromBox=(function(){let i=new P;return function(t,n){let s=n.min,r=n.max,o=1/0,a=-1/0;for(let l=0;l<=1;l++)for(let c=0;c<=1;c++)for(let u=0;u<=1;u++){i.x=s.x*l+r.x*(1-l),i.y=s.y*c+r.y*(1-c),i.z=s.z*u+r.z*(1-u);let h=t.dot(i);o=Math.min(h,o),a=Math.max(h,a)}this.min=o,this.max=a}})();var fR=(function(){let i=new P,e=new P,t=new P;return function(s,r,o){let a=s.start,l=i,c=r.start,u=e;t.subVectors(a,c),i.subVectors(s.end,s.start),e.subVectors(r.end,r.start);let h=t.dot(u),d=u.dot(l),f=u.dot(u),g=t.dot(l),m=l.dot(l)*f-d*d,_,v;m!==0?_=(h*d-g*f)/m:_=0,v=(h+_*d)/f,o.x=_,o.y=v}})(),cc=(function(){let i=new ke,e=new P,t=new P;return function(s,r,o,a){fR(s,r,i);let l=i.x,c=i.y;if(l>=0&&l<=1&&c>=0&&c<=1){s.at(l,o),r.at(c,a);return}else if(l>=0&&l<=1){c<0?r.at(0,a):r.at(1,a),s.closestPointToPoint(a,!0,o);return}else if(c>=0&&c<=1){l<0?s.at(0,o):s.at(1,o),r.closestPointToPoint(o,!0,a);return}else{let u;l<0?u=s.start:u=s.end;let h;c<0?h=r.start:h=r.end;let d=e,f=t;if(s.closestPointToPoint(h,!0,e),r.closestPointToPoint(u,!0,t),d.distanceToSquared(h)<=f.distanceToSquared(u)){o.copy(d),a.copy(h);return}else{o.copy(u),a.copy(f);return}}}})(),Lx=(function(){let i=new P,e=new P,t=new Yn,n=new Tn;return function(r,o){let{radius:a,center:l}=r,{a:c,b:u,c:h}=o;if(n.start=c,n.end=u,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a||(n.start=c,n.end=h,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a)||(n.start=u,n.end=h,n.closestPointToPoint(l,!0,i).distanceTo(l)<=a))return!0;let x=o.getPlane(t);if(Math.abs(x.distanceToPoint(l))<=a){let _=x.projectPoint(l,e);if(o.containsPoint(_))return!0}return!1}})();var pR=["x","y","z"],Js=1e-15,Ox=Js*Js;function Ci(i){return Math.abs(i)<Js}var In=class extends zn{constructor(...e){super(...e),this.isExtendedTriangle=!0,this.satAxes=new Array(4).fill().map(()=>new P),this.satBounds=new Array(4).fill().map(()=>new gi),this.points=[this.a,this.b,this.c],this.plane=new Yn,this.isDegenerateIntoSegment=!1,this.isDegenerateIntoPoint=!1,this.degenerateSegment=new Tn,this.needsUpdate=!0}intersectsSphere(e){return Lx(e,this)}update(){let e=this.a,t=this.b,n=this.c,s=this.points,r=this.satAxes,o=this.satBounds,a=r[0],l=o[0];this.getNormal(a),l.setFromPoints(a,s);let c=r[1],u=o[1];c.subVectors(e,t),u.setFromPoints(c,s);let h=r[2],d=o[2];h.subVectors(t,n),d.setFromPoints(h,s);let f=r[3],g=o[3];f.subVectors(n,e),g.setFromPoints(f,s);let x=c.length(),m=h.length(),_=f.length();this.isDegenerateIntoPoint=!1,this.isDegenerateIntoSegment=!1,x<Js?m<Js||_<Js?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(e),this.degenerateSegment.end.copy(n)):m<Js?_<Js?this.isDegenerateIntoPoint=!0:(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(t),this.degenerateSegment.end.copy(e)):_<Js&&(this.isDegenerateIntoSegment=!0,this.degenerateSegment.start.copy(n),this.degenerateSegment.end.copy(t)),this.plane.setFromNormalAndCoplanarPoint(a,e),this.needsUpdate=!1}};In.prototype.closestPointToSegment=(function(){let i=new P,e=new P,t=new Tn;return function(s,r=null,o=null){this.needsUpdate&&this.update();let{start:a,end:l}=s,c=this.points,u,h=1/0,d=this.plane.distanceToPoint(a),f=this.plane.distanceToPoint(l);if(d*f<0&&this.plane.intersectLine(s,i)!==null&&this.containsPoint(i))return r&&r.copy(i),o&&o.copy(i),0;for(let g=0;g<3;g++){let x=(g+1)%3;t.start.copy(c[g]),t.end.copy(c[x]),cc(t,s,i,e),u=i.distanceToSquared(e),u<h&&(h=u,r&&r.copy(i),o&&o.copy(e))}return this.closestPointToPoint(a,i),u=a.distanceToSquared(i),u<h&&(h=u,r&&r.copy(i),o&&o.copy(a)),this.closestPointToPoint(l,i),u=l.distanceToSquared(i),u<h&&(h=u,r&&r.copy(i),o&&o.copy(l)),Math.sqrt(h)}})();In.prototype.intersectsTriangle=(function(){let i=new In,e=new gi,t=new gi,n=new P,s=new P,r=new P,o=new P,a=new Tn,l=new Tn,c=new P,u=new ke,h=new ke;function d(M,b,S,y){let p=n;!M.isDegenerateIntoPoint&&!M.isDegenerateIntoSegment?p.copy(M.plane.normal):p.copy(b.plane.normal);let w=M.satBounds,T=M.satAxes;for(let O=1;O<4;O++){let U=w[O],I=T[O];if(e.setFromPoints(I,b.points),U.isSeparated(e)||(o.copy(p).cross(I),e.setFromPoints(o,M.points),t.setFromPoints(o,b.points),e.isSeparated(t)))return!1}let E=b.satBounds,C=b.satAxes;for(let O=1;O<4;O++){let U=E[O],I=C[O];if(e.setFromPoints(I,M.points),U.isSeparated(e)||(o.crossVectors(p,I),e.setFromPoints(o,M.points),t.setFromPoints(o,b.points),e.isSeparated(t)))return!1}return S&&(y||console.warn("ExtendedTriangle.intersectsTriangle: Triangles are coplanar which does not support an output edge. Setting edge to 0, 0, 0."),S.start.set(0,0,0),S.end.set(0,0,0)),!0}function f(M,b,S,y,p,w,T,E,C,O,U){let I=T/(T-E);O.x=y+(p-y)*I,U.start.subVectors(b,M).multiplyScalar(I).add(M),I=T/(T-C),O.y=y+(w-y)*I,U.end.subVectors(S,M).multiplyScalar(I).add(M)}function g(M,b,S,y,p,w,T,E,C,O,U){if(p>0)f(M.c,M.a,M.b,y,b,S,C,T,E,O,U);else if(w>0)f(M.b,M.a,M.c,S,b,y,E,T,C,O,U);else if(E*C>0||T!=0)f(M.a,M.b,M.c,b,S,y,T,E,C,O,U);else if(E!=0)f(M.b,M.a,M.c,S,b,y,E,T,C,O,U);else if(C!=0)f(M.c,M.a,M.b,y,b,S,C,T,E,O,U);else return!0;return!1}function x(M,b,S,y){let p=b.degenerateSegment,w=M.plane.distanceToPoint(p.start),T=M.plane.distanceToPoint(p.end);return Ci(w)?Ci(T)?d(M,b,S,y):(S&&(S.start.copy(p.start),S.end.copy(p.start)),M.containsPoint(p.start)):Ci(T)?(S&&(S.start.copy(p.end),S.end.copy(p.end)),M.containsPoint(p.end)):M.plane.intersectLine(p,n)!=null?(S&&(S.start.copy(n),S.end.copy(n)),M.containsPoint(n)):!1}function m(M,b,S){let y=b.a;return Ci(M.plane.distanceToPoint(y))&&M.containsPoint(y)?(S&&(S.start.copy(y),S.end.copy(y)),!0):!1}function _(M,b,S){let y=M.degenerateSegment,p=b.a;return y.closestPointToPoint(p,!0,n),p.distanceToSquared(n)<Ox?(S&&(S.start.copy(p),S.end.copy(p)),!0):!1}function v(M,b,S,y){if(M.isDegenerateIntoSegment)if(b.isDegenerateIntoSegment){let p=M.degenerateSegment,w=b.degenerateSegment,T=s,E=r;p.delta(T),w.delta(E);let C=n.subVectors(w.start,p.start),O=T.x*E.y-T.y*E.x;if(Ci(O))return!1;let U=(C.x*E.y-C.y*E.x)/O,I=-(T.x*C.y-T.y*C.x)/O;if(U<0||U>1||I<0||I>1)return!1;let D=p.start.z+T.z*U,V=w.start.z+E.z*I;return Ci(D-V)?(S&&(S.start.copy(p.start).addScaledVector(T,U),S.end.copy(p.start).addScaledVector(T,U)),!0):!1}else return b.isDegenerateIntoPoint?_(M,b,S):x(b,M,S,y);else{if(M.isDegenerateIntoPoint)return b.isDegenerateIntoPoint?b.a.distanceToSquared(M.a)<Ox?(S&&(S.start.copy(M.a),S.end.copy(M.a)),!0):!1:b.isDegenerateIntoSegment?_(b,M,S):m(b,M,S);if(b.isDegenerateIntoPoint)return m(M,b,S);if(b.isDegenerateIntoSegment)return x(M,b,S,y)}}return function(b,S=null,y=!1){this.needsUpdate&&this.update(),b.isExtendedTriangle?b.needsUpdate&&b.update():(i.copy(b),i.update(),b=i);let p=v(this,b,S,y);if(p!==void 0)return p;let w=this.plane,T=b.plane,E=T.distanceToPoint(this.a),C=T.distanceToPoint(this.b),O=T.distanceToPoint(this.c);Ci(E)&&(E=0),Ci(C)&&(C=0),Ci(O)&&(O=0);let U=E*C,I=E*O;if(U>0&&I>0)return!1;let D=w.distanceToPoint(b.a),V=w.distanceToPoint(b.b),F=w.distanceToPoint(b.c);Ci(D)&&(D=0),Ci(V)&&(V=0),Ci(F)&&(F=0);let ie=D*V,z=D*F;if(ie>0&&z>0)return!1;s.copy(w.normal),r.copy(T.normal);let q=s.cross(r),W=0,_e=Math.abs(q.x),Te=Math.abs(q.y);Te>_e&&(_e=Te,W=1),Math.abs(q.z)>_e&&(W=2);let ae=pR[W],se=this.a[ae],ue=this.b[ae],re=this.c[ae],de=b.a[ae],$e=b.b[ae],Ae=b.c[ae];if(g(this,se,ue,re,U,I,E,C,O,u,a))return d(this,b,S,y);if(g(b,de,$e,Ae,ie,z,D,V,F,h,l))return d(this,b,S,y);if(u.y<u.x){let Ve=u.y;u.y=u.x,u.x=Ve,c.copy(a.start),a.start.copy(a.end),a.end.copy(c)}if(h.y<h.x){let Ve=h.y;h.y=h.x,h.x=Ve,c.copy(l.start),l.start.copy(l.end),l.end.copy(c)}return u.y<h.x||h.y<u.x?!1:(S&&(h.x>u.x?S.start.copy(l.start):S.start.copy(a.start),h.y<u.y?S.end.copy(l.end):S.end.copy(a.end)),!0)}})();In.prototype.distanceToPoint=(function(){let i=new P;return function(t){return this.closestPointToPoint(t,i),t.distanceTo(i)}})();In.prototype.distanceToTriangle=(function(){let i=new P,e=new P,t=["a","b","c"],n=new Tn,s=new Tn;return function(o,a=null,l=null){let c=a||l?n:null;if(this.intersectsTriangle(o,c,!0))return(a||l)&&(a&&c.getCenter(a),l&&c.getCenter(l)),0;let u=1/0;for(let h=0;h<3;h++){let d,f=t[h],g=o[f];this.closestPointToPoint(g,i),d=g.distanceToSquared(i),d<u&&(u=d,a&&a.copy(i),l&&l.copy(g));let x=this[f];o.closestPointToPoint(x,i),d=x.distanceToSquared(i),d<u&&(u=d,a&&a.copy(x),l&&l.copy(i))}for(let h=0;h<3;h++){let d=t[h],f=t[(h+1)%3];n.set(this[d],this[f]);for(let g=0;g<3;g++){let x=t[g],m=t[(g+1)%3];s.set(o[x],o[m]),cc(n,s,i,e);let _=i.distanceToSquared(e);_<u&&(u=_,a&&a.copy(i),l&&l.copy(e))}}return Math.sqrt(u)}})();var rn=class{constructor(e,t,n){this.isOrientedBox=!0,this.min=new P,this.max=new P,this.matrix=new Ce,this.invMatrix=new Ce,this.points=new Array(8).fill().map(()=>new P),this.satAxes=new Array(3).fill().map(()=>new P),this.satBounds=new Array(3).fill().map(()=>new gi),this.alignedSatBounds=new Array(3).fill().map(()=>new gi),this.needsUpdate=!1,e&&this.min.copy(e),t&&this.max.copy(t),n&&this.matrix.copy(n)}set(e,t,n){this.min.copy(e),this.max.copy(t),this.matrix.copy(n),this.needsUpdate=!0}copy(e){this.min.copy(e.min),this.max.copy(e.max),this.matrix.copy(e.matrix),this.needsUpdate=!0}};rn.prototype.update=(function(){return function(){let e=this.matrix,t=this.min,n=this.max,s=this.points;for(let c=0;c<=1;c++)for(let u=0;u<=1;u++)for(let h=0;h<=1;h++){let d=1*c|2*u|4*h,f=s[d];f.x=c?n.x:t.x,f.y=u?n.y:t.y,f.z=h?n.z:t.z,f.applyMatrix4(e)}let r=this.satBounds,o=this.satAxes,a=s[0];for(let c=0;c<3;c++){let u=o[c],h=r[c],d=1<<c,f=s[d];u.subVectors(a,f),h.setFromPoints(u,s)}let l=this.alignedSatBounds;l[0].setFromPointsField(s,"x"),l[1].setFromPointsField(s,"y"),l[2].setFromPointsField(s,"z"),this.invMatrix.copy(this.matrix).invert(),this.needsUpdate=!1}})();rn.prototype.intersectsBox=(function(){let i=new gi;return function(t){this.needsUpdate&&this.update();let n=t.min,s=t.max,r=this.satBounds,o=this.satAxes,a=this.alignedSatBounds;if(i.min=n.x,i.max=s.x,a[0].isSeparated(i)||(i.min=n.y,i.max=s.y,a[1].isSeparated(i))||(i.min=n.z,i.max=s.z,a[2].isSeparated(i)))return!1;for(let l=0;l<3;l++){let c=o[l],u=r[l];if(i.setFromBox(c,t),u.isSeparated(i))return!1}return!0}})();rn.prototype.intersectsTriangle=(function(){let i=new In,e=new Array(3),t=new gi,n=new gi,s=new P;return function(o){this.needsUpdate&&this.update(),o.isExtendedTriangle?o.needsUpdate&&o.update():(i.copy(o),i.update(),o=i);let a=this.satBounds,l=this.satAxes;e[0]=o.a,e[1]=o.b,e[2]=o.c;for(let d=0;d<3;d++){let f=a[d],g=l[d];if(t.setFromPoints(g,e),f.isSeparated(t))return!1}let c=o.satBounds,u=o.satAxes,h=this.points;for(let d=0;d<3;d++){let f=c[d],g=u[d];if(t.setFromPoints(g,h),f.isSeparated(t))return!1}for(let d=0;d<3;d++){let f=l[d];for(let g=0;g<4;g++){let x=u[g];if(s.crossVectors(f,x),t.setFromPoints(s,e),n.setFromPoints(s,h),t.isSeparated(n))return!1}}return!0}})();rn.prototype.closestPointToPoint=(function(){return function(e,t){return this.needsUpdate&&this.update(),t.copy(e).applyMatrix4(this.invMatrix).clamp(this.min,this.max).applyMatrix4(this.matrix),t}})();rn.prototype.distanceToPoint=(function(){let i=new P;return function(t){return this.closestPointToPoint(t,i),t.distanceTo(i)}})();rn.prototype.distanceToBox=(function(){let i=["x","y","z"],e=new Array(12).fill().map(()=>new Tn),t=new Array(12).fill().map(()=>new Tn),n=new P,s=new P;return function(o,a=0,l=null,c=null){if(this.needsUpdate&&this.update(),this.intersectsBox(o))return(l||c)&&(o.getCenter(s),this.closestPointToPoint(s,n),o.closestPointToPoint(n,s),l&&l.copy(n),c&&c.copy(s)),0;let u=a*a,h=o.min,d=o.max,f=this.points,g=1/0;for(let m=0;m<8;m++){let _=f[m];s.copy(_).clamp(h,d);let v=_.distanceToSquared(s);if(v<g&&(g=v,l&&l.copy(_),c&&c.copy(s),v<u))return Math.sqrt(v)}let x=0;for(let m=0;m<3;m++)for(let _=0;_<=1;_++)for(let v=0;v<=1;v++){let M=(m+1)%3,b=(m+2)%3,S=_<<M|v<<b,y=1<<m|_<<M|v<<b,p=f[S],w=f[y];e[x].set(p,w);let E=i[m],C=i[M],O=i[b],U=t[x],I=U.start,D=U.end;I[E]=h[E],I[C]=_?h[C]:d[C],I[O]=v?h[O]:d[O],D[E]=d[E],D[C]=_?h[C]:d[C],D[O]=v?h[O]:d[O],x++}for(let m=0;m<=1;m++)for(let _=0;_<=1;_++)for(let v=0;v<=1;v++){s.x=m?d.x:h.x,s.y=_?d.y:h.y,s.z=v?d.z:h.z,this.closestPointToPoint(s,n);let M=s.distanceToSquared(n);if(M<g&&(g=M,l&&l.copy(n),c&&c.copy(s),M<u))return Math.sqrt(M)}for(let m=0;m<12;m++){let _=e[m];for(let v=0;v<12;v++){let M=t[v];cc(_,M,n,s);let b=n.distanceToSquared(s);if(b<g&&(g=b,l&&l.copy(n),c&&c.copy(s),b<u))return Math.sqrt(b)}}return Math.sqrt(g)}})();var Cm=class extends _r{constructor(){super(()=>new In)}},ei=new Cm;var uc=new P,Pm=new P;function Nx(i,e,t={},n=0,s=1/0){let r=n*n,o=s*s,a=1/0,l=null;if(i.shapecast({boundsTraverseOrder:u=>(uc.copy(e).clamp(u.min,u.max),uc.distanceToSquared(e)),intersectsBounds:(u,h,d)=>d<a&&d<o,intersectsTriangle:(u,h)=>{u.closestPointToPoint(e,uc);let d=e.distanceToSquared(uc);return d<a&&(Pm.copy(uc),a=d,l=h),d<r}}),a===1/0)return null;let c=Math.sqrt(a);return t.point?t.point.copy(Pm):t.point=Pm.clone(),t.distance=c,t.faceIndex=l,t}var wd=parseInt("187")>=169,mR=parseInt("187")<=161,io=new P,so=new P,ro=new P,Md=new ke,Ed=new ke,Td=new ke,Dx=new P,Ux=new P,Fx=new P,hc=new P;function gR(i,e,t,n,s,r,o,a){let l;if(r===An?l=i.intersectTriangle(n,t,e,!0,s):l=i.intersectTriangle(e,t,n,r!==un,s),l===null)return null;let c=i.origin.distanceTo(s);return c<o||c>a?null:{distance:c,point:s.clone()}}function kx(i,e,t,n,s,r,o,a,l,c,u){io.fromBufferAttribute(e,r),so.fromBufferAttribute(e,o),ro.fromBufferAttribute(e,a);let h=gR(i,io,so,ro,hc,l,c,u);if(h){if(n){Md.fromBufferAttribute(n,r),Ed.fromBufferAttribute(n,o),Td.fromBufferAttribute(n,a),h.uv=new ke;let f=zn.getInterpolation(hc,io,so,ro,Md,Ed,Td,h.uv);wd||(h.uv=f)}if(s){Md.fromBufferAttribute(s,r),Ed.fromBufferAttribute(s,o),Td.fromBufferAttribute(s,a),h.uv1=new ke;let f=zn.getInterpolation(hc,io,so,ro,Md,Ed,Td,h.uv1);wd||(h.uv1=f),mR&&(h.uv2=h.uv1)}if(t){Dx.fromBufferAttribute(t,r),Ux.fromBufferAttribute(t,o),Fx.fromBufferAttribute(t,a),h.normal=new P;let f=zn.getInterpolation(hc,io,so,ro,Dx,Ux,Fx,h.normal);h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1),wd||(h.normal=f)}let d={a:r,b:o,c:a,normal:new P,materialIndex:0};if(zn.getNormal(io,so,ro,d.normal),h.face=d,h.faceIndex=r,wd){let f=new P;zn.getBarycoord(hc,io,so,ro,f),h.barycoord=f}}return h}function Bx(i){return i&&i.isMaterial?i.side:i}function xa(i,e,t,n,s,r,o){let a=n*3,l=a+0,c=a+1,u=a+2,{index:h,groups:d}=i;i.index&&(l=h.getX(l),c=h.getX(c),u=h.getX(u));let{position:f,normal:g,uv:x,uv1:m}=i.attributes;if(Array.isArray(e)){let _=n*3;for(let v=0,M=d.length;v<M;v++){let{start:b,count:S,materialIndex:y}=d[v];if(_>=b&&_<b+S){let p=Bx(e[y]),w=kx(t,f,g,x,m,l,c,u,p,r,o);if(w)if(w.faceIndex=n,w.face.materialIndex=y,s)s.push(w);else return w}}}else{let _=Bx(e),v=kx(t,f,g,x,m,l,c,u,_,r,o);if(v)if(v.faceIndex=n,v.face.materialIndex=0,s)s.push(v);else return v}return null}function Gt(i,e,t,n){let s=i.a,r=i.b,o=i.c,a=e,l=e+1,c=e+2;t&&(a=t.getX(a),l=t.getX(l),c=t.getX(c)),s.x=n.getX(a),s.y=n.getY(a),s.z=n.getZ(a),r.x=n.getX(l),r.y=n.getY(l),r.z=n.getZ(l),o.x=n.getX(c),o.y=n.getY(c),o.z=n.getZ(c)}function zx(i,e,t,n,s,r,o,a){let{geometry:l,_indirectBuffer:c}=i;for(let u=n,h=n+s;u<h;u++)xa(l,e,t,u,r,o,a)}function Vx(i,e,t,n,s,r,o){let{geometry:a,_indirectBuffer:l}=i,c=1/0,u=null;for(let h=n,d=n+s;h<d;h++){let f;f=xa(a,e,t,h,null,r,o),f&&f.distance<c&&(u=f,c=f.distance)}return u}function Hx(i,e,t,n,s,r,o){let{geometry:a}=t,{index:l}=a,c=a.attributes.position;for(let u=i,h=e+i;u<h;u++){let d;if(d=u,Gt(o,d*3,l,c),o.needsUpdate=!0,n(o,d,s,r))return!0}return!1}function Gx(i,e=null){e&&Array.isArray(e)&&(e=new Set(e));let t=i.geometry,n=t.index?t.index.array:null,s=t.attributes.position,r,o,a,l,c=0,u=i._roots;for(let d=0,f=u.length;d<f;d++)r=u[d],o=new Uint32Array(r),a=new Uint16Array(r),l=new Float32Array(r),h(0,c),c+=r.byteLength;function h(d,f,g=!1){let x=d*2;if(yt(x,a)){let m=It(d,o),_=Ft(x,a),v=1/0,M=1/0,b=1/0,S=-1/0,y=-1/0,p=-1/0;for(let w=3*m,T=3*(m+_);w<T;w++){let E=n[w],C=s.getX(E),O=s.getY(E),U=s.getZ(E);C<v&&(v=C),C>S&&(S=C),O<M&&(M=O),O>y&&(y=O),U<b&&(b=U),U>p&&(p=U)}return l[d+0]!==v||l[d+1]!==M||l[d+2]!==b||l[d+3]!==S||l[d+4]!==y||l[d+5]!==p?(l[d+0]=v,l[d+1]=M,l[d+2]=b,l[d+3]=S,l[d+4]=y,l[d+5]=p,!0):!1}else{let m=Et(d),_=Tt(d,o),v=g,M=!1,b=!1;if(e){if(!v){let E=m/8+f/32,C=_/8+f/32;M=e.has(E),b=e.has(C),v=!M&&!b}}else M=!0,b=!0;let S=v||M,y=v||b,p=!1;S&&(p=h(m,f,v));let w=!1;y&&(w=h(_,f,v));let T=p||w;if(T)for(let E=0;E<3;E++){let C=m+E,O=_+E,U=l[C],I=l[C+3],D=l[O],V=l[O+3];l[d+E]=U<D?U:D,l[d+E+3]=I>V?I:V}return T}}}function Gn(i,e,t,n,s){let r,o,a,l,c,u,h=1/t.direction.x,d=1/t.direction.y,f=1/t.direction.z,g=t.origin.x,x=t.origin.y,m=t.origin.z,_=e[i],v=e[i+3],M=e[i+1],b=e[i+3+1],S=e[i+2],y=e[i+3+2];return h>=0?(r=(_-g)*h,o=(v-g)*h):(r=(v-g)*h,o=(_-g)*h),d>=0?(a=(M-x)*d,l=(b-x)*d):(a=(b-x)*d,l=(M-x)*d),r>l||a>o||((a>r||isNaN(r))&&(r=a),(l<o||isNaN(o))&&(o=l),f>=0?(c=(S-m)*f,u=(y-m)*f):(c=(y-m)*f,u=(S-m)*f),r>u||c>o)?!1:((c>r||r!==r)&&(r=c),(u<o||o!==o)&&(o=u),r<=s&&o>=n)}function Wx(i,e,t,n,s,r,o,a){let{geometry:l,_indirectBuffer:c}=i;for(let u=n,h=n+s;u<h;u++){let d=c?c[u]:u;xa(l,e,t,d,r,o,a)}}function Xx(i,e,t,n,s,r,o){let{geometry:a,_indirectBuffer:l}=i,c=1/0,u=null;for(let h=n,d=n+s;h<d;h++){let f;f=xa(a,e,t,l?l[h]:h,null,r,o),f&&f.distance<c&&(u=f,c=f.distance)}return u}function qx(i,e,t,n,s,r,o){let{geometry:a}=t,{index:l}=a,c=a.attributes.position;for(let u=i,h=e+i;u<h;u++){let d;if(d=t.resolveTriangleIndex(u),Gt(o,d*3,l,c),o.needsUpdate=!0,n(o,d,s,r))return!0}return!1}function Yx(i,e,t,n,s,r,o){ut.setBuffer(i._roots[e]),Gn(0,ut.float32Array,n,r,o)&&Im(0,i,t,n,s,r,o),ut.clearBuffer()}function Im(i,e,t,n,s,r,o){let{float32Array:a,uint16Array:l,uint32Array:c}=ut,u=i*2;if(yt(u,l)){let d=It(i,c),f=Ft(u,l);zx(e,t,n,d,f,s,r,o)}else{let d=Et(i);Gn(d,a,n,r,o)&&Im(d,e,t,n,s,r,o);let f=Tt(i,c);Gn(f,a,n,r,o)&&Im(f,e,t,n,s,r,o)}}var _R=["x","y","z"];function $x(i,e,t,n,s,r){ut.setBuffer(i._roots[e]);let o=null;return Gn(0,ut.float32Array,n,s,r)&&(o=Lm(0,i,t,n,s,r)),ut.clearBuffer(),o}function Lm(i,e,t,n,s,r){let{float32Array:o,uint16Array:a,uint32Array:l}=ut,c=i*2;if(yt(c,a)){let h=It(i,l),d=Ft(c,a);return Vx(e,t,n,h,d,s,r)}else{let h=ha(i,l),d=_R[h],g=n.direction[d]>=0,x,m;g?(x=Et(i),m=Tt(i,l)):(x=Tt(i,l),m=Et(i));let v=Gn(x,o,n,s,r)?Lm(x,e,t,n,s,r):null;if(v){let S=v.point[d];if(g?S<=o[m+h]:S>=o[m+h+3])return v}let b=Gn(m,o,n,s,r)?Lm(m,e,t,n,s,r):null;return v&&b?v.distance<=b.distance?v:b:v||b||null}}var Ad=new tt,va=new In,ba=new In,dc=new Ce,Kx=new rn,Rd=new rn;function Jx(i,e,t,n){ut.setBuffer(i._roots[e]);let s=Om(0,i,t,n);return ut.clearBuffer(),s}function Om(i,e,t,n,s=null){let{float32Array:r,uint16Array:o,uint32Array:a}=ut,l=i*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),Kx.set(t.boundingBox.min,t.boundingBox.max,n),s=Kx),yt(l,o)){let u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,g=t.attributes.position,x=It(i,a),m=Ft(l,o);if(dc.copy(n).invert(),t.boundsTree)return Ht(i,r,Rd),Rd.matrix.copy(dc),Rd.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>Rd.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(n),v.b.applyMatrix4(n),v.c.applyMatrix4(n),v.needsUpdate=!0;for(let M=x*3,b=(m+x)*3;M<b;M+=3)if(Gt(ba,M,h,d),ba.needsUpdate=!0,v.intersectsTriangle(ba))return!0;return!1}});{let _=vr(t);for(let v=x*3,M=(m+x)*3;v<M;v+=3){Gt(va,v,h,d),va.a.applyMatrix4(dc),va.b.applyMatrix4(dc),va.c.applyMatrix4(dc),va.needsUpdate=!0;for(let b=0,S=_*3;b<S;b+=3)if(Gt(ba,b,f,g),ba.needsUpdate=!0,va.intersectsTriangle(ba))return!0}}}else{let u=Et(i),h=Tt(i,a);return Ht(u,r,Ad),!!(s.intersectsBox(Ad)&&Om(u,e,t,n,s)||(Ht(h,r,Ad),s.intersectsBox(Ad)&&Om(h,e,t,n,s)))}}var Cd=new Ce,Nm=new rn,fc=new rn,yR=new P,xR=new P,vR=new P,bR=new P;function jx(i,e,t,n={},s={},r=0,o=1/0){e.boundingBox||e.computeBoundingBox(),Nm.set(e.boundingBox.min,e.boundingBox.max,t),Nm.needsUpdate=!0;let a=i.geometry,l=a.attributes.position,c=a.index,u=e.attributes.position,h=e.index,d=ei.getPrimitive(),f=ei.getPrimitive(),g=yR,x=xR,m=null,_=null;s&&(m=vR,_=bR);let v=1/0,M=null,b=null;return Cd.copy(t).invert(),fc.matrix.copy(Cd),i.shapecast({boundsTraverseOrder:S=>Nm.distanceToBox(S),intersectsBounds:(S,y,p)=>p<v&&p<o?(y&&(fc.min.copy(S.min),fc.max.copy(S.max),fc.needsUpdate=!0),!0):!1,intersectsRange:(S,y)=>{if(e.boundsTree)return e.boundsTree.shapecast({boundsTraverseOrder:w=>fc.distanceToBox(w),intersectsBounds:(w,T,E)=>E<v&&E<o,intersectsRange:(w,T)=>{for(let E=w,C=w+T;E<C;E++){Gt(f,3*E,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let O=S,U=S+y;O<U;O++){Gt(d,3*O,c,l),d.needsUpdate=!0;let I=d.distanceToTriangle(f,g,m);if(I<v&&(x.copy(g),_&&_.copy(m),v=I,M=O,b=E),I<r)return!0}}}});{let p=vr(e);for(let w=0,T=p;w<T;w++){Gt(f,3*w,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let E=S,C=S+y;E<C;E++){Gt(d,3*E,c,l),d.needsUpdate=!0;let O=d.distanceToTriangle(f,g,m);if(O<v&&(x.copy(g),_&&_.copy(m),v=O,M=E,b=w),O<r)return!0}}}}}),ei.releasePrimitive(d),ei.releasePrimitive(f),v===1/0?null:(n.point?n.point.copy(x):n.point=x.clone(),n.distance=v,n.faceIndex=M,s&&(s.point?s.point.copy(_):s.point=_.clone(),s.point.applyMatrix4(Cd),x.applyMatrix4(Cd),s.distance=x.sub(s.point).length(),s.faceIndex=b),n)}function Zx(i,e=null){e&&Array.isArray(e)&&(e=new Set(e));let t=i.geometry,n=t.index?t.index.array:null,s=t.attributes.position,r,o,a,l,c=0,u=i._roots;for(let d=0,f=u.length;d<f;d++)r=u[d],o=new Uint32Array(r),a=new Uint16Array(r),l=new Float32Array(r),h(0,c),c+=r.byteLength;function h(d,f,g=!1){let x=d*2;if(yt(x,a)){let m=It(d,o),_=Ft(x,a),v=1/0,M=1/0,b=1/0,S=-1/0,y=-1/0,p=-1/0;for(let w=m,T=m+_;w<T;w++){let E=3*i.resolveTriangleIndex(w);for(let C=0;C<3;C++){let O=E+C;O=n?n[O]:O;let U=s.getX(O),I=s.getY(O),D=s.getZ(O);U<v&&(v=U),U>S&&(S=U),I<M&&(M=I),I>y&&(y=I),D<b&&(b=D),D>p&&(p=D)}}return l[d+0]!==v||l[d+1]!==M||l[d+2]!==b||l[d+3]!==S||l[d+4]!==y||l[d+5]!==p?(l[d+0]=v,l[d+1]=M,l[d+2]=b,l[d+3]=S,l[d+4]=y,l[d+5]=p,!0):!1}else{let m=Et(d),_=Tt(d,o),v=g,M=!1,b=!1;if(e){if(!v){let E=m/8+f/32,C=_/8+f/32;M=e.has(E),b=e.has(C),v=!M&&!b}}else M=!0,b=!0;let S=v||M,y=v||b,p=!1;S&&(p=h(m,f,v));let w=!1;y&&(w=h(_,f,v));let T=p||w;if(T)for(let E=0;E<3;E++){let C=m+E,O=_+E,U=l[C],I=l[C+3],D=l[O],V=l[O+3];l[d+E]=U<D?U:D,l[d+E+3]=I>V?I:V}return T}}}function Qx(i,e,t,n,s,r,o){ut.setBuffer(i._roots[e]),Gn(0,ut.float32Array,n,r,o)&&Dm(0,i,t,n,s,r,o),ut.clearBuffer()}function Dm(i,e,t,n,s,r,o){let{float32Array:a,uint16Array:l,uint32Array:c}=ut,u=i*2;if(yt(u,l)){let d=It(i,c),f=Ft(u,l);Wx(e,t,n,d,f,s,r,o)}else{let d=Et(i);Gn(d,a,n,r,o)&&Dm(d,e,t,n,s,r,o);let f=Tt(i,c);Gn(f,a,n,r,o)&&Dm(f,e,t,n,s,r,o)}}var SR=["x","y","z"];function ev(i,e,t,n,s,r){ut.setBuffer(i._roots[e]);let o=null;return Gn(0,ut.float32Array,n,s,r)&&(o=Um(0,i,t,n,s,r)),ut.clearBuffer(),o}function Um(i,e,t,n,s,r){let{float32Array:o,uint16Array:a,uint32Array:l}=ut,c=i*2;if(yt(c,a)){let h=It(i,l),d=Ft(c,a);return Xx(e,t,n,h,d,s,r)}else{let h=ha(i,l),d=SR[h],g=n.direction[d]>=0,x,m;g?(x=Et(i),m=Tt(i,l)):(x=Tt(i,l),m=Et(i));let v=Gn(x,o,n,s,r)?Um(x,e,t,n,s,r):null;if(v){let S=v.point[d];if(g?S<=o[m+h]:S>=o[m+h+3])return v}let b=Gn(m,o,n,s,r)?Um(m,e,t,n,s,r):null;return v&&b?v.distance<=b.distance?v:b:v||b||null}}var Pd=new tt,Sa=new In,wa=new In,pc=new Ce,tv=new rn,Id=new rn;function nv(i,e,t,n){ut.setBuffer(i._roots[e]);let s=Fm(0,i,t,n);return ut.clearBuffer(),s}function Fm(i,e,t,n,s=null){let{float32Array:r,uint16Array:o,uint32Array:a}=ut,l=i*2;if(s===null&&(t.boundingBox||t.computeBoundingBox(),tv.set(t.boundingBox.min,t.boundingBox.max,n),s=tv),yt(l,o)){let u=e.geometry,h=u.index,d=u.attributes.position,f=t.index,g=t.attributes.position,x=It(i,a),m=Ft(l,o);if(pc.copy(n).invert(),t.boundsTree)return Ht(i,r,Id),Id.matrix.copy(pc),Id.needsUpdate=!0,t.boundsTree.shapecast({intersectsBounds:v=>Id.intersectsBox(v),intersectsTriangle:v=>{v.a.applyMatrix4(n),v.b.applyMatrix4(n),v.c.applyMatrix4(n),v.needsUpdate=!0;for(let M=x,b=m+x;M<b;M++)if(Gt(wa,3*e.resolveTriangleIndex(M),h,d),wa.needsUpdate=!0,v.intersectsTriangle(wa))return!0;return!1}});{let _=vr(t);for(let v=x,M=m+x;v<M;v++){let b=e.resolveTriangleIndex(v);Gt(Sa,3*b,h,d),Sa.a.applyMatrix4(pc),Sa.b.applyMatrix4(pc),Sa.c.applyMatrix4(pc),Sa.needsUpdate=!0;for(let S=0,y=_*3;S<y;S+=3)if(Gt(wa,S,f,g),wa.needsUpdate=!0,Sa.intersectsTriangle(wa))return!0}}}else{let u=Et(i),h=Tt(i,a);return Ht(u,r,Pd),!!(s.intersectsBox(Pd)&&Fm(u,e,t,n,s)||(Ht(h,r,Pd),s.intersectsBox(Pd)&&Fm(h,e,t,n,s)))}}var Ld=new Ce,km=new rn,mc=new rn,wR=new P,MR=new P,ER=new P,TR=new P;function iv(i,e,t,n={},s={},r=0,o=1/0){e.boundingBox||e.computeBoundingBox(),km.set(e.boundingBox.min,e.boundingBox.max,t),km.needsUpdate=!0;let a=i.geometry,l=a.attributes.position,c=a.index,u=e.attributes.position,h=e.index,d=ei.getPrimitive(),f=ei.getPrimitive(),g=wR,x=MR,m=null,_=null;s&&(m=ER,_=TR);let v=1/0,M=null,b=null;return Ld.copy(t).invert(),mc.matrix.copy(Ld),i.shapecast({boundsTraverseOrder:S=>km.distanceToBox(S),intersectsBounds:(S,y,p)=>p<v&&p<o?(y&&(mc.min.copy(S.min),mc.max.copy(S.max),mc.needsUpdate=!0),!0):!1,intersectsRange:(S,y)=>{if(e.boundsTree){let p=e.boundsTree;return p.shapecast({boundsTraverseOrder:w=>mc.distanceToBox(w),intersectsBounds:(w,T,E)=>E<v&&E<o,intersectsRange:(w,T)=>{for(let E=w,C=w+T;E<C;E++){let O=p.resolveTriangleIndex(E);Gt(f,3*O,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let U=S,I=S+y;U<I;U++){let D=i.resolveTriangleIndex(U);Gt(d,3*D,c,l),d.needsUpdate=!0;let V=d.distanceToTriangle(f,g,m);if(V<v&&(x.copy(g),_&&_.copy(m),v=V,M=U,b=E),V<r)return!0}}}})}else{let p=vr(e);for(let w=0,T=p;w<T;w++){Gt(f,3*w,h,u),f.a.applyMatrix4(t),f.b.applyMatrix4(t),f.c.applyMatrix4(t),f.needsUpdate=!0;for(let E=S,C=S+y;E<C;E++){let O=i.resolveTriangleIndex(E);Gt(d,3*O,c,l),d.needsUpdate=!0;let U=d.distanceToTriangle(f,g,m);if(U<v&&(x.copy(g),_&&_.copy(m),v=U,M=E,b=w),U<r)return!0}}}}}),ei.releasePrimitive(d),ei.releasePrimitive(f),v===1/0?null:(n.point?n.point.copy(x):n.point=x.clone(),n.distance=v,n.faceIndex=M,s&&(s.point?s.point.copy(_):s.point=_.clone(),s.point.applyMatrix4(Ld),x.applyMatrix4(Ld),s.distance=x.sub(s.point).length(),s.faceIndex=b),n)}function Bm(i,e,t){return i===null?null:(i.point.applyMatrix4(e.matrixWorld),i.distance=i.point.distanceTo(t.ray.origin),i.object=e,i)}var Od=new rn,Nd=new ts,sv=new P,rv=new Ce,ov=new P,zm=["getX","getY","getZ"],Dd=class i extends Sd{static serialize(e,t={}){t={cloneBuffers:!0,...t};let n=e.geometry,s=e._roots,r=e._indirectBuffer,o=n.getIndex(),a={version:1,roots:null,index:null,indirectBuffer:null};return t.cloneBuffers?(a.roots=s.map(l=>l.slice()),a.index=o?o.array.slice():null,a.indirectBuffer=r?r.slice():null):(a.roots=s,a.index=o?o.array:null,a.indirectBuffer=r),a}static deserialize(e,t,n={}){n={setIndex:!0,indirect:!!e.indirectBuffer,...n};let{index:s,roots:r,indirectBuffer:o}=e;e.version||(console.warn("MeshBVH.deserialize: Serialization format has been changed and will be fixed up. It is recommended to regenerate any stored serialized data."),l(r));let a=new i(t,{...n,[oc]:!0});if(a._roots=r,a._indirectBuffer=o||null,n.setIndex){let c=t.getIndex();if(c===null){let u=new mt(e.index,1,!1);t.setIndex(u)}else c.array!==s&&(c.array.set(s),c.needsUpdate=!0)}return a;function l(c){for(let u=0;u<c.length;u++){let h=c[u],d=new Uint32Array(h),f=new Uint16Array(h);for(let g=0,x=h.byteLength/32;g<x;g++){let m=8*g,_=2*m;yt(_,f)||(d[m+6]=d[m+6]/8-g)}}}}get primitiveStride(){return 3}get resolveTriangleIndex(){return this.resolvePrimitiveIndex}constructor(e,t={}){t.maxLeafTris&&(console.warn('MeshBVH: "maxLeafTris" option has been deprecated. Use "targetLeafSize", instead.'),t={...t,targetLeafSize:t.maxLeafTris}),super(e,t)}shiftTriangleOffsets(e){return super.shiftPrimitiveOffsets(e)}writePrimitiveBounds(e,t,n){let s=this.geometry,r=this._indirectBuffer,o=s.attributes.position,a=s.index?s.index.array:null,c=(r?r[e]:e)*3,u=c+0,h=c+1,d=c+2;a&&(u=a[u],h=a[h],d=a[d]);for(let f=0;f<3;f++){let g=o[zm[f]](u),x=o[zm[f]](h),m=o[zm[f]](d),_=g;x<_&&(_=x),m<_&&(_=m);let v=g;x>v&&(v=x),m>v&&(v=m),t[n+f]=_,t[n+f+3]=v}return t}computePrimitiveBounds(e,t,n){let s=this.geometry,r=this._indirectBuffer,o=s.attributes.position,a=s.index?s.index.array:null,l=o.normalized;if(e<0||t+e-n.offset>n.length/6)throw new Error("MeshBVH: compute triangle bounds range is invalid.");let c=o.array,u=o.offset||0,h=3;o.isInterleavedBufferAttribute&&(h=o.data.stride);let d=["getX","getY","getZ"],f=n.offset;for(let g=e,x=e+t;g<x;g++){let _=(r?r[g]:g)*3,v=(g-f)*6,M=_+0,b=_+1,S=_+2;a&&(M=a[M],b=a[b],S=a[S]),l||(M=M*h+u,b=b*h+u,S=S*h+u);for(let y=0;y<3;y++){let p,w,T;l?(p=o[d[y]](M),w=o[d[y]](b),T=o[d[y]](S)):(p=c[M+y],w=c[b+y],T=c[S+y]);let E=p;w<E&&(E=w),T<E&&(E=T);let C=p;w>C&&(C=w),T>C&&(C=T);let O=(C-E)/2,U=y*2;n[v+U+0]=E+O,n[v+U+1]=O+(Math.abs(E)+O)*ua}}return n}raycastObject3D(e,t,n=[]){let{material:s}=e;if(s===void 0)return;rv.copy(e.matrixWorld).invert(),Nd.copy(t.ray).applyMatrix4(rv),ov.setFromMatrixScale(e.matrixWorld),sv.copy(Nd.direction).multiply(ov);let r=sv.length(),o=t.near/r,a=t.far/r;if(t.firstHitOnly===!0){let l=this.raycastFirst(Nd,s,o,a);l=Bm(l,e,t),l&&n.push(l)}else{let l=this.raycast(Nd,s,o,a);for(let c=0,u=l.length;c<u;c++){let h=Bm(l[c],e,t);h&&n.push(h)}}return n}refit(e=null){return(this.indirect?Zx:Gx)(this,e)}raycast(e,t=pi,n=0,s=1/0){let r=this._roots,o=[],a=this.indirect?Qx:Yx;for(let l=0,c=r.length;l<c;l++)a(this,l,t,e,o,n,s);return o}raycastFirst(e,t=pi,n=0,s=1/0){let r=this._roots,o=null,a=this.indirect?ev:$x;for(let l=0,c=r.length;l<c;l++){let u=a(this,l,t,e,n,s);u!=null&&(o==null||u.distance<o.distance)&&(o=u)}return o}intersectsGeometry(e,t){let n=!1,s=this._roots,r=this.indirect?nv:Jx;for(let o=0,a=s.length;o<a&&(n=r(this,o,e,t),!n);o++);return n}shapecast(e){let t=ei.getPrimitive(),n=super.shapecast({...e,intersectsPrimitive:e.intersectsTriangle,scratchPrimitive:t,iterate:this.indirect?qx:Hx});return ei.releasePrimitive(t),n}bvhcast(e,t,n){let{intersectsRanges:s,intersectsTriangles:r}=n,o=ei.getPrimitive(),a=this.geometry.index,l=this.geometry.attributes.position,c=this.indirect?g=>{let x=this.resolveTriangleIndex(g);Gt(o,x*3,a,l)}:g=>{Gt(o,g*3,a,l)},u=ei.getPrimitive(),h=e.geometry.index,d=e.geometry.attributes.position,f=e.indirect?g=>{let x=e.resolveTriangleIndex(g);Gt(u,x*3,h,d)}:g=>{Gt(u,g*3,h,d)};if(r){if(!(e instanceof i))throw new Error('MeshBVH: "intersectsTriangles" callback can only be used with another MeshBVH.');let g=(x,m,_,v,M,b,S,y)=>{for(let p=_,w=_+v;p<w;p++){f(p),u.a.applyMatrix4(t),u.b.applyMatrix4(t),u.c.applyMatrix4(t),u.needsUpdate=!0;for(let T=x,E=x+m;T<E;T++)if(c(T),o.needsUpdate=!0,r(o,u,T,p,M,b,S,y))return!0}return!1};if(s){let x=s;s=function(m,_,v,M,b,S,y,p){return x(m,_,v,M,b,S,y,p)?!0:g(m,_,v,M,b,S,y,p)}}else s=g}return super.bvhcast(e,t,{intersectsRanges:s})}intersectsBox(e,t){return Od.set(e.min,e.max,t),Od.needsUpdate=!0,this.shapecast({intersectsBounds:n=>Od.intersectsBox(n),intersectsTriangle:n=>Od.intersectsTriangle(n)})}intersectsSphere(e){return this.shapecast({intersectsBounds:t=>e.intersectsBox(t),intersectsTriangle:t=>t.intersectsSphere(e)})}closestPointToGeometry(e,t,n={},s={},r=0,o=1/0){return(this.indirect?iv:jx)(this,e,t,n,s,r,o)}closestPointToPoint(e,t={},n=0,s=1/0){return Nx(this,e,t,n,s)}};var UD=parseInt("187")>=166,Ma={Mesh:Pt.prototype.raycast,Line:ns.prototype.raycast,LineSegments:is.prototype.raycast,LineLoop:ur.prototype.raycast,Points:Bi.prototype.raycast,BatchedMesh:Tl.prototype.raycast},Ln=new Pt,Ud=[];function av(i,e){if(this.isBatchedMesh)AR.call(this,i,e);else{let{geometry:t}=this;if(t.boundsTree)t.boundsTree.raycastObject3D(this,i,e);else{let n;if(this instanceof Pt)n=Ma.Mesh;else if(this instanceof is)n=Ma.LineSegments;else if(this instanceof ur)n=Ma.LineLoop;else if(this instanceof ns)n=Ma.Line;else if(this instanceof Bi)n=Ma.Points;else throw new Error("BVH: Fallback raycast function not found.");n.call(this,i,e)}}}function AR(i,e){if(this.boundsTrees){let t=this.boundsTrees,n=this._drawInfo||this._instanceInfo,s=this._drawRanges||this._geometryInfo,r=this.matrixWorld;Ln.material=this.material,Ln.geometry=this.geometry;let o=Ln.geometry.boundsTree,a=Ln.geometry.drawRange;Ln.geometry.boundingSphere===null&&(Ln.geometry.boundingSphere=new Vt);for(let l=0,c=n.length;l<c;l++){if(!this.getVisibleAt(l))continue;let u=n[l].geometryIndex;if(Ln.geometry.boundsTree=t[u],this.getMatrixAt(l,Ln.matrixWorld).premultiply(r),!Ln.geometry.boundsTree){this.getBoundingBoxAt(u,Ln.geometry.boundingBox),this.getBoundingSphereAt(u,Ln.geometry.boundingSphere);let h=s[u];Ln.geometry.setDrawRange(h.start,h.count)}Ln.raycast(i,Ud);for(let h=0,d=Ud.length;h<d;h++){let f=Ud[h];f.object=this,f.batchId=l,e.push(f)}Ud.length=0}Ln.geometry.boundsTree=o,Ln.geometry.drawRange=a,Ln.material=null,Ln.geometry=null}else Ma.BatchedMesh.call(this,i,e)}var RR=["#440154","#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6dcd59","#b4de2c","#fde725"],CR=["#0d3b76","#2a6da3","#78a9c8","#c5d9e2","#ece8e2","#eacdbc","#d69a7a","#b3563a","#7a2013"],PR=i=>i<=.04045?i/12.92:((i+.055)/1.055)**2.4,IR=i=>i<=.0031308?12.92*i:1.055*Math.max(i,0)**.4166666666666667-.055;function LR([i,e,t]){let n=Math.cbrt(.4122214708*i+.5363325363*e+.0514459929*t),s=Math.cbrt(.2119034982*i+.6806995451*e+.1073969566*t),r=Math.cbrt(.0883024619*i+.2817188376*e+.6299787005*t);return[.2104542553*n+.793617785*s-.0040720468*r,1.9779984951*n-2.428592205*s+.4505937099*r,.0259040371*n+.7827717662*s-.808675766*r]}function OR([i,e,t]){let n=(i+.3963377774*e+.2158037573*t)**3,s=(i-.1055613458*e-.0638541728*t)**3,r=(i-.0894841775*e-1.291485548*t)**3;return[4.0767416621*n-3.3077115913*s+.2309699292*r,-1.2684380046*n+2.6097574011*s-.3413193965*r,-.0041960863*n-.7034186147*s+1.707614701*r]}var Vm=256;function lv(i){let e=i.map(t=>LR([1,3,5].map(n=>PR(parseInt(t.slice(n,n+2),16)/255))));return Array.from({length:Vm},(t,n)=>{let s=n/(Vm-1)*(i.length-1),r=Math.min(Math.floor(s),i.length-2),o=e[r].map((a,l)=>a+(s-r)*(e[r+1][l]-a));return OR(o).map(a=>Math.min(1,Math.max(0,a)))})}var NR={sequential:lv(RR),diverging:lv(CR)},Fd=(i,e)=>NR[i][Math.round(Math.min(1,Math.max(0,e))*(Vm-1))],cv=(i,e)=>`rgb(${Fd(i,e).map(t=>Math.round(255*IR(t))).join(" ")})`;function Hm(i,e){if(e===Gp)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===na||e===jl){let t=i.getIndex();if(t===null){let r=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)r.push(a);i.setIndex(r),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,s=[];if(e===na)for(let r=1;r<=n;r++)s.push(t.getX(0)),s.push(t.getX(r)),s.push(t.getX(r+1));else for(let r=0;r<n;r++)r%2===0?(s.push(t.getX(r)),s.push(t.getX(r+1)),s.push(t.getX(r+2))):(s.push(t.getX(r+2)),s.push(t.getX(r+1)),s.push(t.getX(r)));return s.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(s),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function uv(i){let e=new Map,t=new Map,n=i.clone();return hv(i,n,function(s,r){e.set(r,s),t.set(s,r)}),n.traverse(function(s){if(!s.isSkinnedMesh)return;let r=s,o=e.get(s),a=o.skeleton.bones;r.skeleton=o.skeleton.clone(),r.bindMatrix.copy(o.bindMatrix),r.skeleton.bones=a.map(function(l){return t.get(l)}),r.bind(r.skeleton,r.bindMatrix)}),n}function hv(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)hv(i.children[n],e.children[n],t)}var Ta=class extends os{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new Km(t)}),this.register(function(t){return new Jm(t)}),this.register(function(t){return new jm(t)}),this.register(function(t){return new og(t)}),this.register(function(t){return new ag(t)}),this.register(function(t){return new lg(t)}),this.register(function(t){return new Qm(t)}),this.register(function(t){return new eg(t)}),this.register(function(t){return new tg(t)}),this.register(function(t){return new ng(t)}),this.register(function(t){return new $m(t)}),this.register(function(t){return new ig(t)}),this.register(function(t){return new Zm(t)}),this.register(function(t){return new rg(t)}),this.register(function(t){return new sg(t)}),this.register(function(t){return new qm(t)}),this.register(function(t){return new kd(t,lt.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new kd(t,lt.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new cg(t)})}load(e,t,n,s){let r=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let c=Ys.extractUrlBase(e);o=Ys.resolveURL(c,this.path)}else o=Ys.extractUrlBase(e);this.manager.itemStart(e);let a=function(c){s?s(c):console.error(c),r.manager.itemError(e),r.manager.itemEnd(e)},l=new $o(this.manager);l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.path),l.setResponseType("arraybuffer"),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials),l.load(e,function(c){try{r.parse(c,o,function(u){t(u),r.manager.itemEnd(e)},a)}catch(u){a(u)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,s){let r,o={},a={},l=new TextDecoder;if(typeof e=="string")r=JSON.parse(e);else if(e instanceof ArrayBuffer)if(l.decode(new Uint8Array(e,0,4))===gv){try{o[lt.KHR_BINARY_GLTF]=new ug(e)}catch(h){s&&s(h);return}r=JSON.parse(o[lt.KHR_BINARY_GLTF].content)}else r=JSON.parse(l.decode(e));else r=e;if(r.asset===void 0||r.asset.version[0]<2){s&&s(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let c=new _g(r,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});c.fileLoader.setRequestHeader(this.requestHeader);for(let u=0;u<this.pluginCallbacks.length;u++){let h=this.pluginCallbacks[u](c);h.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[h.name]=h,o[h.name]=!0}if(r.extensionsUsed)for(let u=0;u<r.extensionsUsed.length;++u){let h=r.extensionsUsed[u],d=r.extensionsRequired||[];switch(h){case lt.KHR_MATERIALS_UNLIT:o[h]=new Ym;break;case lt.KHR_DRACO_MESH_COMPRESSION:o[h]=new hg(r,this.dracoLoader);break;case lt.KHR_TEXTURE_TRANSFORM:o[h]=new dg;break;case lt.KHR_MESH_QUANTIZATION:o[h]=new fg;break;default:d.indexOf(h)>=0&&a[h]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+h+'".')}}c.setExtensions(o),c.setPlugins(a),c.parse(n,s)}parseAsync(e,t){let n=this;return new Promise(function(s,r){n.parse(e,t,s,r)})}};function DR(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function en(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var lt={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},qm=class{constructor(e){this.parser=e,this.name=lt.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,s=t.length;n<s;n++){let r=t[n];r.extensions&&r.extensions[this.name]&&r.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,r.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,s=t.cache.get(n);if(s)return s;let r=t.json,l=((r.extensions&&r.extensions[this.name]||{}).lights||[])[e],c,u=new Ue(16777215);l.color!==void 0&&u.setRGB(l.color[0],l.color[1],l.color[2],Kn);let h=l.range!==void 0?l.range:0;switch(l.type){case"directional":c=new $r(u),c.target.position.set(0,0,-1),c.add(c.target);break;case"point":c=new Fl(u),c.distance=h;break;case"spot":c=new Ul(u),c.distance=h,l.spot=l.spot||{},l.spot.innerConeAngle=l.spot.innerConeAngle!==void 0?l.spot.innerConeAngle:0,l.spot.outerConeAngle=l.spot.outerConeAngle!==void 0?l.spot.outerConeAngle:Math.PI/4,c.angle=l.spot.outerConeAngle,c.penumbra=1-l.spot.innerConeAngle/l.spot.outerConeAngle,c.target.position.set(0,0,-1),c.add(c.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+l.type)}return c.position.set(0,0,0),ys(c,l),l.intensity!==void 0&&(c.intensity=l.intensity),c.name=t.createUniqueName(l.name||"light_"+e),s=Promise.resolve(c),t.cache.add(n,s),s}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,r=n.json.nodes[e],a=(r.extensions&&r.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(l){return n._getNodeRef(t.cache,a,l)})}},Ym=class{constructor(){this.name=lt.KHR_MATERIALS_UNLIT}getMaterialType(){return Ti}extendParams(e,t,n){let s=[];e.color=new Ue(1,1,1),e.opacity=1;let r=t.pbrMetallicRoughness;if(r){if(Array.isArray(r.baseColorFactor)){let o=r.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],Kn),e.opacity=o[3]}r.baseColorTexture!==void 0&&s.push(n.assignTexture(e,"map",r.baseColorTexture,hn))}return Promise.all(s)}},$m=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},Km=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(s.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let r=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new ke(r,r)}return Promise.all(s)}},Jm=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(s)}},jm=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_DISPERSION}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},Zm=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(s)}},Qm=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_SHEEN}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];if(t.sheenColor=new Ue(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let r=n.sheenColorFactor;t.sheenColor.setRGB(r[0],r[1],r[2],Kn)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,hn)),n.sheenRoughnessTexture!==void 0&&s.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(s)}},eg=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&s.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(s)}},tg=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_VOLUME}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&s.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let r=n.attenuationColor||[1,1,1];return t.attenuationColor=new Ue().setRGB(r[0],r[1],r[2],Kn),Promise.all(s)}},ng=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_IOR}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},ig=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_SPECULAR}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let r=n.specularColorFactor||[1,1,1];return t.specularColor=new Ue().setRGB(r[0],r[1],r[2],Kn),n.specularColorTexture!==void 0&&s.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,hn)),Promise.all(s)}},sg=class{constructor(e){this.parser=e,this.name=lt.EXT_MATERIALS_BUMP}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&s.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(s)}},rg=class{constructor(e){this.parser=e,this.name=lt.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return en(this.parser,e,this.name)!==null?Zn:null}extendMaterialParams(e,t){let n=en(this.parser,e,this.name);if(n===null)return Promise.resolve();let s=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&s.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(s)}},og=class{constructor(e){this.parser=e,this.name=lt.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,s=n.textures[e];if(!s.extensions||!s.extensions[this.name])return null;let r=s.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,r.source,o)}},ag=class{constructor(e){this.parser=e,this.name=lt.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},lg=class{constructor(e){this.parser=e,this.name=lt.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,s=n.json,r=s.textures[e];if(!r.extensions||!r.extensions[t])return null;let o=r.extensions[t],a=s.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},kd=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let s=n.extensions[this.name],r=this.parser.getDependency("buffer",s.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return r.then(function(a){let l=s.byteOffset||0,c=s.byteLength||0,u=s.count,h=s.byteStride,d=new Uint8Array(a,l,c);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(u,h,d,s.mode,s.filter).then(function(f){return f.buffer}):o.ready.then(function(){let f=new ArrayBuffer(u*h);return o.decodeGltfBuffer(new Uint8Array(f),u,h,d,s.mode,s.filter),f})})}else return null}},cg=class{constructor(e){this.name=lt.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let s=t.meshes[n.mesh];for(let c of s.primitives)if(c.mode!==Pi.TRIANGLES&&c.mode!==Pi.TRIANGLE_STRIP&&c.mode!==Pi.TRIANGLE_FAN&&c.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],l={};for(let c in o)a.push(this.parser.getDependency("accessor",o[c]).then(u=>(l[c]=u,l[c])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(c=>{let u=c.pop(),h=u.isGroup?u.children:[u],d=c[0].count,f=[];for(let g of h){let x=new Ce,m=new P,_=new Jn,v=new P(1,1,1),M=new Ml(g.geometry,g.material,d);for(let S=0;S<d;S++)l.TRANSLATION&&m.fromBufferAttribute(l.TRANSLATION,S),l.ROTATION&&_.fromBufferAttribute(l.ROTATION,S),l.SCALE&&v.fromBufferAttribute(l.SCALE,S),M.setMatrixAt(S,x.compose(m,_,v));let b=null;for(let S in l)if(S==="_COLOR_0"){let y=l[S];M.instanceColor=new ks(y.array,y.itemSize,y.normalized)}else if(S!=="TRANSLATION"&&S!=="ROTATION"&&S!=="SCALE"){if(b===null){let p=M.geometry;b=new Kt,b.name=p.name;for(let w in p.attributes)b.setAttribute(w,p.attributes[w]);for(let w in p.morphAttributes)b.morphAttributes[w]=p.morphAttributes[w];p.index!==null&&b.setIndex(p.index),b.morphTargetsRelative=p.morphTargetsRelative;for(let w of p.groups)b.addGroup(w.start,w.count,w.materialIndex);p.boundingBox!==null&&(b.boundingBox=p.boundingBox.clone()),p.boundingSphere!==null&&(b.boundingSphere=p.boundingSphere.clone()),b.drawRange.start=p.drawRange.start,b.drawRange.count=p.drawRange.count,b.userData=Object.assign({},p.userData),M.geometry=b}let y=l[S];b.setAttribute(S,new ks(y.array,y.itemSize,y.normalized))}Qt.prototype.copy.call(M,g),this.parser.assignFinalMaterial(M),f.push(M)}return u.isGroup?(u.clear(),u.add(...f),u):f[0]}))}},gv="glTF",gc=12,dv={JSON:1313821514,BIN:5130562},ug=class{constructor(e){this.name=lt.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,gc),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==gv)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let s=this.header.length-gc,r=new DataView(e,gc),o=0;for(;o<s;){let a=r.getUint32(o,!0);o+=4;let l=r.getUint32(o,!0);if(o+=4,l===dv.JSON){let c=new Uint8Array(e,gc+o,a);this.content=n.decode(c)}else if(l===dv.BIN){let c=gc+o;this.body=e.slice(c,c+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},hg=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=lt.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,s=this.dracoLoader,r=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},l={},c={};for(let u in o){let h=mg[u]||u.toLowerCase();a[h]=o[u]}for(let u in e.attributes){let h=mg[u]||u.toLowerCase();if(o[u]!==void 0){let d=n.accessors[e.attributes[u]],f=Ea[d.componentType];c[h]=f.name,l[h]=d.normalized===!0}}return t.getDependency("bufferView",r).then(function(u){return new Promise(function(h,d){s.decodeDracoFile(u,function(f){for(let g in f.attributes){let x=f.attributes[g],m=l[g];m!==void 0&&(x.normalized=m)}h(f)},a,c,Kn,d)})})}},dg=class{constructor(){this.name=lt.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),s=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*s,e.offset.x,-e.repeat.x*s,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},fg=class{constructor(){this.name=lt.KHR_MESH_QUANTIZATION}},Bd=class extends rs{constructor(e,t,n,s){super(e,t,n,s)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s*3+s;for(let o=0;o!==s;o++)t[o]=n[r+o];return t}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=a*2,c=a*3,u=s-t,h=(n-t)/u,d=h*h,f=d*h,g=e*c,x=g-c,m=-2*f+3*d,_=f-d,v=1-m,M=_-d+h;for(let b=0;b!==a;b++){let S=o[x+b+a],y=o[x+b+l]*u,p=o[g+b+a],w=o[g+b]*u;r[b]=v*S+M*y+m*p+_*w}return r}},UR=new Jn,pg=class extends Bd{interpolate_(e,t,n,s){let r=super.interpolate_(e,t,n,s);return UR.fromArray(r).normalize().toArray(r),r}},Pi={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},Ea={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},fv={9728:on,9729:pn,9984:mh,9985:ea,9986:Zr,9987:Ai},pv={33071:Mi,33648:ko,10497:lr},Gm={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},mg={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},br={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},FR={CUBICSPLINE:void 0,LINEAR:Wr,STEP:Gr},Wm={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function kR(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new Vs({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:pi})),i.DefaultMaterial}function oo(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function ys(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function BR(i,e,t){let n=!1,s=!1,r=!1;for(let c=0,u=e.length;c<u;c++){let h=e[c];if(h.POSITION!==void 0&&(n=!0),h.NORMAL!==void 0&&(s=!0),h.COLOR_0!==void 0&&(r=!0),n&&s&&r)break}if(!n&&!s&&!r)return Promise.resolve(i);let o=[],a=[],l=[];for(let c=0,u=e.length;c<u;c++){let h=e[c];if(n){let d=h.POSITION!==void 0?t.getDependency("accessor",h.POSITION):i.attributes.position;o.push(d)}if(s){let d=h.NORMAL!==void 0?t.getDependency("accessor",h.NORMAL):i.attributes.normal;a.push(d)}if(r){let d=h.COLOR_0!==void 0?t.getDependency("accessor",h.COLOR_0):i.attributes.color;l.push(d)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l)]).then(function(c){let u=c[0],h=c[1],d=c[2];return n&&(i.morphAttributes.position=u),s&&(i.morphAttributes.normal=h),r&&(i.morphAttributes.color=d),i.morphTargetsRelative=!0,i})}function zR(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,s=t.length;n<s;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function VR(i){let e,t=i.extensions&&i.extensions[lt.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+Xm(t.attributes):e=i.indices+":"+Xm(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,s=i.targets.length;n<s;n++)e+=":"+Xm(i.targets[n]);return e}function Xm(i){let e="",t=Object.keys(i).sort();for(let n=0,s=t.length;n<s;n++)e+=t[n]+":"+i[t[n]]+";";return e}function gg(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function HR(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var GR=new Ce,_g=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new DR,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,s=-1,r=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let l=a.match(/Version\/(\d+)/);s=n&&l?parseInt(l[1],10):-1,r=a.indexOf("Firefox")>-1,o=r?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&s<17||r&&o<98?(this.textureLoader=new Nl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new zl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new $o(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,s=this.json,r=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][s.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:s.asset,parser:n,userData:{}};return oo(r,a,s),ys(a,s),Promise.all(n._invokeAll(function(l){return l.afterRoot&&l.afterRoot(a)})).then(function(){for(let l of a.scenes)l.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let s=0,r=t.length;s<r;s++){let o=t[s].joints;for(let a=0,l=o.length;a<l;a++)e[o[a]].isBone=!0}for(let s=0,r=e.length;s<r;s++){let o=e[s];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let s=n.clone(),r=(o,a)=>{let l=this.associations.get(o);l!=null&&this.associations.set(a,l);for(let[c,u]of o.children.entries())r(u,a.children[c])};return r(n,s),s.name+="_instance_"+e.uses[t]++,s}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let s=e(t[n]);if(s)return s}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let s=0;s<t.length;s++){let r=e(t[s]);r&&n.push(r)}return n}getDependency(e,t){let n=e+":"+t,s=this.cache.get(n);if(!s){switch(e){case"scene":s=this.loadScene(t);break;case"node":s=this._invokeOne(function(r){return r.loadNode&&r.loadNode(t)});break;case"mesh":s=this._invokeOne(function(r){return r.loadMesh&&r.loadMesh(t)});break;case"accessor":s=this.loadAccessor(t);break;case"bufferView":s=this._invokeOne(function(r){return r.loadBufferView&&r.loadBufferView(t)});break;case"buffer":s=this.loadBuffer(t);break;case"material":s=this._invokeOne(function(r){return r.loadMaterial&&r.loadMaterial(t)});break;case"texture":s=this._invokeOne(function(r){return r.loadTexture&&r.loadTexture(t)});break;case"skin":s=this.loadSkin(t);break;case"animation":s=this._invokeOne(function(r){return r.loadAnimation&&r.loadAnimation(t)});break;case"camera":s=this.loadCamera(t);break;default:if(s=this._invokeOne(function(r){return r!=this&&r.getDependency&&r.getDependency(e,t)}),!s)throw new Error("Unknown type: "+e);break}this.cache.add(n,s)}return s}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,s=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(s.map(function(r,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[lt.KHR_BINARY_GLTF].body);let s=this.options;return new Promise(function(r,o){n.load(Ys.resolveURL(t.uri,s.path),r,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let s=t.byteLength||0,r=t.byteOffset||0;return n.slice(r,r+s)})}loadAccessor(e){let t=this,n=this.json,s=this.json.accessors[e];if(s.bufferView===void 0&&s.sparse===void 0){let o=Gm[s.type],a=Ea[s.componentType],l=s.normalized===!0,c=new a(s.count*o);return Promise.resolve(new mt(c,o,l))}let r=[];return s.bufferView!==void 0?r.push(this.getDependency("bufferView",s.bufferView)):r.push(null),s.sparse!==void 0&&(r.push(this.getDependency("bufferView",s.sparse.indices.bufferView)),r.push(this.getDependency("bufferView",s.sparse.values.bufferView))),Promise.all(r).then(function(o){let a=o[0],l=Gm[s.type],c=Ea[s.componentType],u=c.BYTES_PER_ELEMENT,h=u*l,d=s.byteOffset||0,f=s.bufferView!==void 0?n.bufferViews[s.bufferView].byteStride:void 0,g=s.normalized===!0,x,m;if(f&&f!==h){let _=Math.floor(d/f),v="InterleavedBuffer:"+s.bufferView+":"+s.componentType+":"+_+":"+s.count,M=t.cache.get(v);M||(x=new c(a,_*f,s.count*f/u),M=new qr(x,f/u),t.cache.add(v,M)),m=new si(M,l,d%f/u,g)}else a===null?x=new c(s.count*l):x=new c(a,d,s.count*l),m=new mt(x,l,g);if(s.sparse!==void 0){let _=Gm.SCALAR,v=Ea[s.sparse.indices.componentType],M=s.sparse.indices.byteOffset||0,b=s.sparse.values.byteOffset||0,S=new v(o[1],M,s.sparse.count*_),y=new c(o[2],b,s.sparse.count*l);a!==null&&(m=new mt(m.array.slice(),m.itemSize,m.normalized)),m.normalized=!1;for(let p=0,w=S.length;p<w;p++){let T=S[p];if(m.setX(T,y[p*l]),l>=2&&m.setY(T,y[p*l+1]),l>=3&&m.setZ(T,y[p*l+2]),l>=4&&m.setW(T,y[p*l+3]),l>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}m.normalized=g}return m})}loadTexture(e){let t=this.json,n=this.options,r=t.textures[e].source,o=t.images[r],a=this.textureLoader;if(o.uri){let l=n.manager.getHandler(o.uri);l!==null&&(a=l)}return this.loadTextureImage(e,r,a)}loadTextureImage(e,t,n){let s=this,r=this.json,o=r.textures[e],a=r.images[t],l=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[l])return this.textureCache[l];let c=this.loadImageSource(t,n).then(function(u){u.flipY=!1,u.name=o.name||a.name||"",u.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(u.name=a.uri);let d=(r.samplers||{})[o.sampler]||{};return u.magFilter=fv[d.magFilter]||pn,u.minFilter=fv[d.minFilter]||Ai,u.wrapS=pv[d.wrapS]||lr,u.wrapT=pv[d.wrapT]||lr,u.generateMipmaps=!u.isCompressedTexture&&u.minFilter!==on&&u.minFilter!==pn,s.associations.set(u,{textures:e}),u}).catch(function(){return null});return this.textureCache[l]=c,c}loadImageSource(e,t){let n=this,s=this.json,r=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(d=>d.clone());let o=s.images[e],a=self.URL||self.webkitURL,l=o.uri||"",c=!1,u;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)u=n.getDependency("bufferView",o.bufferView).then(function(d){return new Promise(function(f,g){t.parse(d,f,g)})});else{if(o.bufferView!==void 0)l=n.getDependency("bufferView",o.bufferView).then(function(d){c=!0;let f=new Blob([d],{type:o.mimeType});return l=a.createObjectURL(f),l});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");u=Promise.resolve(l).then(function(d){return new Promise(function(f,g){let x=f;t.isImageBitmapLoader===!0&&(x=function(m){let _=new wn(m);_.needsUpdate=!0,f(_)}),t.load(Ys.resolveURL(d,r.path),x,void 0,g)})})}let h=u.then(function(d){return c===!0&&a.revokeObjectURL(l),ys(d,o),d.userData.mimeType=o.mimeType||HR(o.uri),d}).catch(function(d){throw console.error("THREE.GLTFLoader: Couldn't load texture",l),d});return this.sourceCache[e]=h,h}assignTexture(e,t,n,s){let r=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),r.extensions[lt.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[lt.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let l=r.associations.get(o);o=r.extensions[lt.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),r.associations.set(o,l)}}return s!==void 0&&(o.colorSpace=s),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,s=t.attributes.tangent===void 0,r=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new qo,jn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,l.sizeAttenuation=!1,this.cache.add(a,l)),n=l}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new cr,jn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,this.cache.add(a,l)),n=l}if(s||r||o){let a="ClonedMaterial:"+n.uuid+":";s&&(a+="derivative-tangents:"),r&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let l=this.cache.get(a);l||(l=n.clone(),r&&(l.vertexColors=!0),o&&(l.flatShading=!0),s&&(l.normalScale&&(l.normalScale.y*=-1),l.clearcoatNormalScale&&(l.clearcoatNormalScale.y*=-1)),this.cache.add(a,l),this.associations.set(l,this.associations.get(n))),n=l}e.material=n}getMaterialType(){return Vs}loadMaterial(e){let t=this,n=this.json,s=this.extensions,r=n.materials[e],o,a={},l=r.extensions||{},c=[];if(l[lt.KHR_MATERIALS_UNLIT]){let h=s[lt.KHR_MATERIALS_UNLIT];o=h.getMaterialType(),c.push(h.extendParams(a,r,t))}else{let h=r.pbrMetallicRoughness||{};if(a.color=new Ue(1,1,1),a.opacity=1,Array.isArray(h.baseColorFactor)){let d=h.baseColorFactor;a.color.setRGB(d[0],d[1],d[2],Kn),a.opacity=d[3]}h.baseColorTexture!==void 0&&c.push(t.assignTexture(a,"map",h.baseColorTexture,hn)),a.metalness=h.metallicFactor!==void 0?h.metallicFactor:1,a.roughness=h.roughnessFactor!==void 0?h.roughnessFactor:1,h.metallicRoughnessTexture!==void 0&&(c.push(t.assignTexture(a,"metalnessMap",h.metallicRoughnessTexture)),c.push(t.assignTexture(a,"roughnessMap",h.metallicRoughnessTexture))),o=this._invokeOne(function(d){return d.getMaterialType&&d.getMaterialType(e)}),c.push(Promise.all(this._invokeAll(function(d){return d.extendMaterialParams&&d.extendMaterialParams(e,a)})))}r.doubleSided===!0&&(a.side=un);let u=r.alphaMode||Wm.OPAQUE;if(u===Wm.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,u===Wm.MASK&&(a.alphaTest=r.alphaCutoff!==void 0?r.alphaCutoff:.5)),r.normalTexture!==void 0&&o!==Ti&&(c.push(t.assignTexture(a,"normalMap",r.normalTexture)),a.normalScale=new ke(1,1),r.normalTexture.scale!==void 0)){let h=r.normalTexture.scale;a.normalScale.set(h,h)}if(r.occlusionTexture!==void 0&&o!==Ti&&(c.push(t.assignTexture(a,"aoMap",r.occlusionTexture)),r.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=r.occlusionTexture.strength)),r.emissiveFactor!==void 0&&o!==Ti){let h=r.emissiveFactor;a.emissive=new Ue().setRGB(h[0],h[1],h[2],Kn)}return r.emissiveTexture!==void 0&&o!==Ti&&c.push(t.assignTexture(a,"emissiveMap",r.emissiveTexture,hn)),Promise.all(c).then(function(){let h=new o(a);return r.name&&(h.name=r.name),ys(h,r),t.associations.set(h,{materials:e}),r.extensions&&oo(s,h,r),h})}createUniqueName(e){let t=zt.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,s=this.primitiveCache;function r(a){return n[lt.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(l){return mv(l,a,t)})}let o=[];for(let a=0,l=e.length;a<l;a++){let c=e[a],u=VR(c),h=s[u];if(h)o.push(h.promise);else{let d;c.extensions&&c.extensions[lt.KHR_DRACO_MESH_COMPRESSION]?d=r(c):d=mv(new Kt,c,t),c.mode===Pi.TRIANGLE_STRIP?d=d.then(f=>Hm(f,jl)):c.mode===Pi.TRIANGLE_FAN&&(d=d.then(f=>Hm(f,na))),s[u]={primitive:c,promise:d},o.push(d)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,s=this.extensions,r=n.meshes[e],o=r.primitives,a=[];for(let l=0,c=o.length;l<c;l++){let u=o[l].material===void 0?kR(this.cache):this.getDependency("material",o[l].material);a.push(u)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(l){let c=l.slice(0,l.length-1),u=l[l.length-1],h=[];for(let f=0,g=u.length;f<g;f++){let x=u[f],m=o[f],_,v=c[f];if(m.mode===Pi.TRIANGLES||m.mode===Pi.TRIANGLE_STRIP||m.mode===Pi.TRIANGLE_FAN||m.mode===void 0){let M=r.isSkinnedMesh===!0,b=x.hasAttribute("skinIndex")&&x.hasAttribute("skinWeight");M&&b===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),_=M&&b?new Sl(x,v):new Pt(x,v),_.isSkinnedMesh===!0&&_.normalizeSkinWeights()}else if(m.mode===Pi.LINES)_=new is(x,v);else if(m.mode===Pi.LINE_STRIP)_=new ns(x,v);else if(m.mode===Pi.LINE_LOOP)_=new ur(x,v);else if(m.mode===Pi.POINTS)_=new Bi(x,v);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+m.mode);Object.keys(_.geometry.morphAttributes).length>0&&zR(_,r),_.name=t.createUniqueName(r.name||"mesh_"+e),ys(_,r),m.extensions&&oo(s,_,m),t.assignFinalMaterial(_),h.push(_)}for(let f=0,g=h.length;f<g;f++)t.associations.set(h[f],{meshes:e,primitives:f});if(h.length===1)return r.extensions&&oo(s,h[0],r),h[0];let d=new Sn;r.extensions&&oo(s,d,r),t.associations.set(d,{meshes:e});for(let f=0,g=h.length;f<g;f++)d.add(h[f]);return d})}loadCamera(e){let t,n=this.json.cameras[e],s=n[n.type];if(!s){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new dn(ia.radToDeg(s.yfov),s.aspectRatio||1,s.znear||1,s.zfar||2e6):n.type==="orthographic"&&(t=new qs(-s.xmag,s.xmag,s.ymag,-s.ymag,s.znear,s.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),ys(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let s=0,r=t.joints.length;s<r;s++)n.push(this._loadNodeShallow(t.joints[s]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(s){let r=s.pop(),o=s,a=[],l=[];for(let c=0,u=o.length;c<u;c++){let h=o[c];if(h){a.push(h);let d=new Ce;r!==null&&d.fromArray(r.array,c*16),l.push(d)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[c])}return new wl(a,l)})}loadAnimation(e){let t=this.json,n=this,s=t.animations[e],r=s.name?s.name:"animation_"+e,o=[],a=[],l=[],c=[],u=[];for(let h=0,d=s.channels.length;h<d;h++){let f=s.channels[h],g=s.samplers[f.sampler],x=f.target,m=x.node,_=s.parameters!==void 0?s.parameters[g.input]:g.input,v=s.parameters!==void 0?s.parameters[g.output]:g.output;x.node!==void 0&&(o.push(this.getDependency("node",m)),a.push(this.getDependency("accessor",_)),l.push(this.getDependency("accessor",v)),c.push(g),u.push(x))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l),Promise.all(c),Promise.all(u)]).then(function(h){let d=h[0],f=h[1],g=h[2],x=h[3],m=h[4],_=[];for(let M=0,b=d.length;M<b;M++){let S=d[M],y=f[M],p=g[M],w=x[M],T=m[M];if(S===void 0)continue;S.updateMatrix&&S.updateMatrix();let E=n._createAnimationTracks(S,y,p,w,T);if(E)for(let C=0;C<E.length;C++)_.push(E[C])}let v=new Ol(r,void 0,_);return ys(v,s),v})}createNodeMesh(e){let t=this.json,n=this,s=t.nodes[e];return s.mesh===void 0?null:n.getDependency("mesh",s.mesh).then(function(r){let o=n._getNodeRef(n.meshCache,s.mesh,r);return s.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let l=0,c=s.weights.length;l<c;l++)a.morphTargetInfluences[l]=s.weights[l]}),o})}loadNode(e){let t=this.json,n=this,s=t.nodes[e],r=n._loadNodeShallow(e),o=[],a=s.children||[];for(let c=0,u=a.length;c<u;c++)o.push(n.getDependency("node",a[c]));let l=s.skin===void 0?Promise.resolve(null):n.getDependency("skin",s.skin);return Promise.all([r,Promise.all(o),l]).then(function(c){let u=c[0],h=c[1],d=c[2];d!==null&&u.traverse(function(f){f.isSkinnedMesh&&f.bind(d,GR)});for(let f=0,g=h.length;f<g;f++)u.add(h[f]);if(u.userData.pivot!==void 0&&h.length>0){let f=u.userData.pivot,g=h[0];u.pivot=new P().fromArray(f),u.position.x-=f[0],u.position.y-=f[1],u.position.z-=f[2],g.position.set(0,0,0),delete u.userData.pivot}return u})}_loadNodeShallow(e){let t=this.json,n=this.extensions,s=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let r=t.nodes[e],o=r.name?s.createUniqueName(r.name):"",a=[],l=s._invokeOne(function(c){return c.createNodeMesh&&c.createNodeMesh(e)});return l&&a.push(l),r.camera!==void 0&&a.push(s.getDependency("camera",r.camera).then(function(c){return s._getNodeRef(s.cameraCache,r.camera,c)})),s._invokeAll(function(c){return c.createNodeAttachment&&c.createNodeAttachment(e)}).forEach(function(c){a.push(c)}),this.nodeCache[e]=Promise.all(a).then(function(c){let u;if(r.isBone===!0?u=new Xo:c.length>1?u=new Sn:c.length===1?u=c[0]:u=new Qt,u!==c[0])for(let h=0,d=c.length;h<d;h++)u.add(c[h]);if(r.name&&(u.userData.name=r.name,u.name=o),ys(u,r),r.extensions&&oo(n,u,r),r.matrix!==void 0){let h=new Ce;h.fromArray(r.matrix),u.applyMatrix4(h)}else r.translation!==void 0&&u.position.fromArray(r.translation),r.rotation!==void 0&&u.quaternion.fromArray(r.rotation),r.scale!==void 0&&u.scale.fromArray(r.scale);if(!s.associations.has(u))s.associations.set(u,{});else if(r.mesh!==void 0&&s.meshCache.refs[r.mesh]>1){let h=s.associations.get(u);s.associations.set(u,{...h})}return s.associations.get(u).nodes=e,u}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],s=this,r=new Sn;n.name&&(r.name=s.createUniqueName(n.name)),ys(r,n),n.extensions&&oo(t,r,n);let o=n.nodes||[],a=[];for(let l=0,c=o.length;l<c;l++)a.push(s.getDependency("node",o[l]));return Promise.all(a).then(function(l){for(let u=0,h=l.length;u<h;u++){let d=l[u];d.parent!==null?r.add(uv(d)):r.add(d)}let c=u=>{let h=new Map;for(let[d,f]of s.associations)(d instanceof jn||d instanceof wn)&&h.set(d,f);return u.traverse(d=>{let f=s.associations.get(d);f!=null&&h.set(d,f)}),h};return s.associations=c(r),r})}_createAnimationTracks(e,t,n,s,r){let o=[],a=e.name?e.name:e.uuid,l=[];function c(f){f.morphTargetInfluences&&l.push(f.name?f.name:f.uuid)}br[r.path]===br.weights?(c(e),e.isGroup&&e.children.forEach(c)):l.push(a);let u;switch(br[r.path]){case br.weights:u=Gs;break;case br.rotation:u=Ws;break;case br.translation:case br.scale:u=hr;break;default:n.itemSize===1?u=Gs:u=hr;break}let h=s.interpolation!==void 0?FR[s.interpolation]:Wr,d=this._getArrayFromAccessor(n);for(let f=0,g=l.length;f<g;f++){let x=new u(l[f]+"."+br[r.path],t.array,d,h);s.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(x),o.push(x)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=gg(t.constructor),s=new Float32Array(t.length);for(let r=0,o=t.length;r<o;r++)s[r]=t[r]*n;t=s}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let s=this instanceof Ws?pg:Bd;return new s(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function WR(i,e,t){let n=e.attributes,s=new tt;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],l=a.min,c=a.max;if(l!==void 0&&c!==void 0){if(s.set(new P(l[0],l[1],l[2]),new P(c[0],c[1],c[2])),a.normalized){let u=gg(Ea[a.componentType]);s.min.multiplyScalar(u),s.max.multiplyScalar(u)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let r=e.targets;if(r!==void 0){let a=new P,l=new P;for(let c=0,u=r.length;c<u;c++){let h=r[c];if(h.POSITION!==void 0){let d=t.json.accessors[h.POSITION],f=d.min,g=d.max;if(f!==void 0&&g!==void 0){if(l.setX(Math.max(Math.abs(f[0]),Math.abs(g[0]))),l.setY(Math.max(Math.abs(f[1]),Math.abs(g[1]))),l.setZ(Math.max(Math.abs(f[2]),Math.abs(g[2]))),d.normalized){let x=gg(Ea[d.componentType]);l.multiplyScalar(x)}a.max(l)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}s.expandByVector(a)}i.boundingBox=s;let o=new Vt;s.getCenter(o.center),o.radius=s.min.distanceTo(s.max)/2,i.boundingSphere=o}function mv(i,e,t){let n=e.attributes,s=[];function r(o,a){return t.getDependency("accessor",o).then(function(l){i.setAttribute(a,l)})}for(let o in n){let a=mg[o]||o.toLowerCase();a in i.attributes||s.push(r(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});s.push(o)}return st.workingColorSpace!==Kn&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${st.workingColorSpace}" not supported.`),ys(i,e),WR(i,e,t),Promise.all(s).then(function(){return e.targets!==void 0?BR(i,e.targets,t):i})}var XR=new Ta;async function Aa(i){let e=await XR.parseAsync(i,""),t=e.parser.json,n=await e.parser.getDependency("node",0),{geometry:s}=n,r=new Map;for(let[u,h]of Object.entries(s.attributes))u.startsWith("_")&&h instanceof mt&&h.itemSize===1&&(r.set(u.slice(1),h.array),s.deleteAttribute(u));s.deleteAttribute("color"),s.index||(s.setIndex([]),s.setAttribute("normal",new mt(new Float32Array(3*s.attributes.position.count),3)));let o=[];for(let u=1;u<t.nodes.length;u+=1){let h=await e.parser.getDependency("node",u),d=[];h.traverse(m=>{m.isLine&&d.push(m)});let f=qR(d.map(yg)),g=[],[x]=d;if(x&&d.length===1&&!x.geometry.index)for(let[m,_]of Object.entries(x.geometry.attributes)){if(!m.startsWith("_"))continue;let v=Object.entries(t.nodes[u].extras??{}).find(([M])=>M.toLowerCase()===m)?.[1]?.unit??"";g.push({name:m.slice(1),unit:v,values:_.array})}o.push({name:t.nodes[u].name??"lines",segments:f,values:g})}let[a=0,l=0,c=0]=t.nodes[0]?.translation??[];return{geometry:s,attributes:r,lines:o,translation:[a,l,c],extras:t.asset.extras??{}}}var js=({geometry:i})=>i.index.count>0;function yg(i){let e=i.geometry.attributes.position,t=i.geometry.index?.array??Uint32Array.from({length:e.count},(a,l)=>l),n=i.isLineSegments,s=i.isLineLoop,r=n?t.length>>1:Math.max(t.length-(s?0:1),0),o=new Float32Array(6*r);for(let a=0;a<r;a+=1)for(let l=0;l<2;l+=1){let c=3*t[((n?2:1)*a+l)%t.length];o.set(e.array.subarray(c,c+3),6*a+3*l)}return o}function qR(i){let e=new Float32Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function zd(i){let e=i.index.array,t=i.attributes.position.count,n=new Map,s=[],r=[];for(let o=0;o<e.length;o+=3)for(let a=0;a<3;a+=1){let l=e[o+a],c=e[o+(a+1)%3],u=Math.min(l,c)*t+Math.max(l,c),h=n.get(u);h===void 0?(n.set(u,s.length/2),s.push(l,c),r.push(o/3,-1)):r[2*h+1]===-1&&(r[2*h+1]=o/3)}return{ends:Uint32Array.from(s),faces:Int32Array.from(r)}}var YR=1e-4,$R=1e-6,KR=.001;function _v(i,e){let t=[{id:"plain",label:"Plain"}];for(let s of i.attributes.keys())t.push({id:s,label:Zt(s)});js(i)&&t.push({id:"edge_length",label:"Edge length"}),js(i)&&e!=="minimal_surface"&&t.push({id:"bending",label:"Bending (fold angle)"});let n=new Set(yv(i).flatMap(s=>s.values.map(({name:r})=>r)));n.delete("length");for(let s of n)t.push({id:`line:${s}`,label:Zt(s)});return t}var yv=i=>i.lines.filter(({name:e})=>e!=="reactions"),xv=i=>i.lines.some(({name:e,values:t})=>e.startsWith("cables")&&t.some(n=>n.name==="force"))?"line:force":"plain";function vv(i,e,t,n){if(e==="plain")return null;if(e==="mean_curvature")return JR(i,t,n);if(e==="edge_length"||e==="bending")return ZR(i,e,t,n);if(e.startsWith("line:"))return tC(i,e.slice(5));let s=i.attributes.get(e);return s?Vd({id:e,label:Zt(e),unit:"",at:"vertex",values:s},0):null}function Vd(i,e){let t=1/0,n=-1/0;for(let o of i.values)Number.isFinite(o)&&(t=Math.min(t,o),n=Math.max(n,o));t>n&&([t,n]=[0,0]);let s=Math.max(Math.abs(t),Math.abs(n)),r=s<=e;return t<0&&n>0?{...i,scale:"diverging",low:-s,high:s,nought:r,noise:e}:{...i,scale:"sequential",low:t,high:n,nought:r,noise:e}}function JR(i,e,t){let n=i.attributes.get("mean_curvature"),s=new Float32Array(n.length),r=jR(i),o=!1;for(let h=0;h<n.length;h+=1)s[h]=n[h]*t*(n[h]<0?1:r[h]),o||=s[h]<0;i.geometry.computeBoundingSphere();let a=i.geometry.boundingSphere.radius/t,l=a>0?YR/a:0,c=Vd({id:"mean_curvature",label:"Mean curvature",unit:`1/${e}`,at:"vertex",values:s},l),u=Math.max(Math.abs(c.low),Math.abs(c.high));return{...c,scale:"diverging",low:-u,high:u}}function jR(i){let{position:e,normal:t}=i.geometry.attributes,n=i.geometry.index.array,s=new Float64Array(e.count),r=a=>new P().fromBufferAttribute(e,a),o=new P;for(let a=0;a<n.length;a+=3){let l=[n[a],n[a+1],n[a+2]],c=l.map(r);for(let u=0;u<3;u+=1){let[h,d]=[(u+1)%3,(u+2)%3],f=c[h].clone().sub(c[u]),g=c[d].clone().sub(c[u]),x=f.dot(g)/Math.max(f.clone().cross(g).length(),1e-30),m=c[d].clone().sub(c[h]);s[l[h]]+=x*m.dot(o.fromBufferAttribute(t,l[h])),s[l[d]]-=x*m.dot(o.fromBufferAttribute(t,l[d]))}}return Float32Array.from(s,a=>a<0?-1:1)}function ZR(i,e,t,n){let s=zd(i.geometry),r=i.geometry.attributes.position.array,o=[];for(let d=0;d<s.ends.length/2;d+=1)(e==="edge_length"||s.faces[2*d+1]!==-1)&&o.push(d);let a=new Float32Array(6*o.length),l=new Float32Array(o.length),c=e==="bending"?QR(i):null;o.forEach((d,f)=>{let g=3*s.ends[2*d],x=3*s.ends[2*d+1];for(let m=0;m<3;m+=1)a[6*f+m]=r[g+m],a[6*f+3+m]=r[x+m];c?l[f]=eC(c,s,d):l[f]=Math.hypot(r[g]-r[x],r[g+1]-r[x+1],r[g+2]-r[x+2])/n});let u=e==="bending",h=Vd({id:e,label:u?"Bending (fold angle)":"Edge length",unit:u?"°":t,at:"segment",values:l,segments:a},u?.01:0);return u?{...h,low:0}:h}function QR(i){let{position:e}=i.geometry.attributes,t=i.geometry.index.array,n=s=>new P().fromBufferAttribute(e,t[s]);return Array.from({length:t.length/3},(s,r)=>{let o=n(3*r);return n(3*r+1).sub(o).cross(n(3*r+2).sub(o)).normalize()})}var eC=(i,{faces:e},t)=>i[e[2*t]].angleTo(i[e[2*t+1]])*180/Math.PI;function tC(i,e){let t=yv(i).flatMap(c=>c.values.filter(u=>u.name===e).map(u=>({line:c,each:u})));if(t.length===0)return null;let n=t.reduce((c,{each:u})=>c+u.values.length/2,0),s=new Float32Array(n),r=new Float32Array(6*n),o=0;for(let{line:c,each:u}of t){r.set(c.segments,6*o);for(let h=0;h<u.values.length;h+=2)s[o+h/2]=u.values[h];o+=u.values.length/2}let a=Vd({id:`line:${e}`,label:Zt(e),unit:t[0].each.unit,at:"segment",values:s,segments:r},0);if(a.high-a.low>KR*Math.max(Math.abs(a.low),Math.abs(a.high)))return a;let l=Number(((a.low+a.high)/2).toPrecision(4));return{...a,low:l,high:l}}function Hd(i,e){if(i.nought)return i.scale==="diverging"?.5:0;let t=i.high-i.low;return t>$R*Math.max(Math.abs(i.low),Math.abs(i.high))?(e-i.low)/t:.5}var Gd=(i,e)=>`${i.label} ${Math.abs(e)<=i.noise?"≈ 0":`${vt(e,4)}`}${i.unit==="°"?"°":i.unit&&` ${i.unit}`}`;function bv(i,e){let t=new Array(e).fill(0);for(let n of i.values)Number.isFinite(n)&&(t[Math.min(e-1,Math.max(0,Math.floor(Hd(i,n)*e)))]+=1);return t}var nC=8,xg={length:.16,width:.06},iC=2e4;function _c(i,e,t,n,s=1){if(i.length/6>iC){let a=new Kt().setAttribute("position",new mt(i,3));n&&a.setAttribute("color",new mt(n,3));let l=new cr({color:n?"#ffffff":t,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new is(a,l)}let r=new ca().setPositions(i);n&&r.setColors(n);let o=new la({color:n?16777215:new Ue(t).getHex(),linewidth:e,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new dd(r,o)}var sC=2e3;function Ra({geometry:i,material:e}){i.dispose(),setTimeout(()=>e.dispose(),sC)}var Ca=class{constructor(e){this.look=e}look;group=new Sn;mesh=null;result=null;kind="";quantity=null;lines=[];layers={surface:!0,edges:!1,lines:!0,reactions:!1};drawn=!0;ghost=!1;get shown(){return this.mesh!==null}get current(){return this.result}show(e,t,n,s=null){this.result=e,this.kind=t,this.quantity=s,this.ghost=!1,e&&this.putInto(n),this.make()}putInto(e){if(!this.result)return;let t=e.up===2?[e.origin[0],e.origin[2],-e.origin[1]]:e.origin,[n,s,r]=this.result.translation.map((o,a)=>o-t[a]*e.metres);this.group.position.set(n,s,r)}colourBy(e){this.quantity=e,this.make()}setLayers(e){Object.assign(this.layers,e),this.make()}setGhost(e){if(e!==this.ghost&&(this.ghost=e,!!this.mesh)){this.mesh.material.transparent=e,this.mesh.material.opacity=e?.32:1,this.mesh.material.depthWrite=!e,this.mesh.material.needsUpdate=!0;for(let t of this.lines)t.material.transparent=!0,t.material.opacity=e?.2:t.userData.opacity??1}}restyle(){this.make()}clear(){this.mesh&&Ra(this.mesh),this.mesh=null,this.lines.forEach(Ra),this.lines=[],this.group.clear()}make(){let{result:e,quantity:t,ghost:n}=this;if(this.clear(),!e)return;let s=this.kind!=="minimal_surface",r=new Kt;r.setIndex(e.geometry.index),r.setAttribute("position",e.geometry.attributes.position),r.setAttribute("normal",e.geometry.attributes.normal);let o=t?.at==="vertex";t&&o&&r.setAttribute("color",new mt(oC(t),3));let a={side:un,flatShading:s,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},l=o?new Il({...a,vertexColors:!0}):new Vs({...a,color:this.look.membrane,roughness:.62,metalness:0});this.mesh=new Pt(r,l),this.mesh.raycast=av,this.mesh.userData.castsShadow=!0,this.mesh.visible=this.layers.surface,this.group.add(this.mesh);let c=(h,d,f,g=1,x)=>{if(h.length===0)return;let m=_c(h,d,f,x,g);m.userData.opacity=g,m.userData.isLine=!0,m.renderOrder=.01*this.lines.length,this.lines.push(m),this.group.add(m)},u=t?.at==="segment"?t:null;if(u?.id.startsWith("line:")){c(u.segments,5,this.look.rim);let h=this.lines.at(-1);h&&Object.assign(h.material,{depthWrite:!1})}if(u&&c(u.segments,3,this.look.ink,1,aC(u)),this.layers.edges&&u?.id!=="edge_length"&&c(lC(e),1,this.look.ink,.3),this.layers.lines)for(let{name:h,segments:d,values:f}of e.lines)h==="reactions"||u&&(h.startsWith("members")||h==="bridges")||f.some(g=>u?.id===`line:${g.name}`)||(h==="boundaries"||h==="directrices"?this.drawn||c(d,2,this.look.ink,.85):h.startsWith("members")?c(d,h.includes("rim")?1.4:2,this.look.ink,h.includes("rim")?.5:.8):h==="bridges"?c(d,1,this.look.ink,.35):c(d,2.4,this.look.accent));this.layers.reactions&&c(rC(e),2.2,this.look.reaction),n&&(this.ghost=!1,this.setGhost(!0))}tree(){let e=this.mesh?.geometry;return e?(e.boundsTree??=new Dd(e,{indirect:!0}),e):null}pick(e,t,n){if(!this.mesh||!this.layers.surface||!this.result||!js(this.result)||!this.tree())return null;let s=new fr;s.setFromCamera(new ke(t/e.width*2-1,1-n/e.height*2),e.camera),s.firstHitOnly=!0,this.group.updateMatrixWorld();let[r]=s.intersectObject(this.mesh,!1);return r?{point:r.point,distance:r.distance,face:r.faceIndex??0}:null}pickLine(e,t,n){let{quantity:s,result:r}=this,o=[],a=(u,h)=>{for(let d=0;d<u.length/6;d+=1){let[f,g]=[0,3].map(b=>this.group.localToWorld(new P().fromArray(u,6*d+b))),x=e.project(f.toArray()),m=e.project(g.toArray());if(!x.visible||!m.visible)continue;let _=(m.x-x.x)**2+(m.y-x.y)**2,v=_>0?Math.min(1,Math.max(0,((t-x.x)*(m.x-x.x)+(n-x.y)*(m.y-x.y))/_)):0,M=Math.hypot(x.x+v*(m.x-x.x)-t,x.y+v*(m.y-x.y)-n);M<=nC&&o.push({distance:M,point:f.lerp(g,v),value:h(d)})}};this.group.updateMatrixWorld(),s?.at==="segment"&&a(s.segments,u=>Gd(s,s.values[u]));let l=this.layers.reactions?r?.lines.find(({name:u})=>u==="reactions"):void 0,c=l?.values.find(({name:u})=>u==="force");return l&&c&&a(l.segments,u=>`Reaction ${vt(c.values[2*u],4)} ${c.unit}`),o.sort((u,h)=>u.distance-h.distance)[0]??null}valueAt(e,t){let{quantity:n,mesh:s}=this;if(!n||!s)return null;let r=s.worldToLocal(e.clone());if(n.at==="segment")return cC(n,r);let o=s.geometry.index.array,{position:a}=s.geometry.attributes,l=[0,1,2].map(x=>o[3*t+x]),[c,u,h]=l.map(x=>new P().fromBufferAttribute(a,x)),d=(x,m,_)=>m.clone().sub(x).cross(_.clone().sub(x)).length(),f=[d(r,u,h),d(c,r,h),d(c,u,r)],g=f.reduce((x,m)=>x+m,0);return g>0?l.reduce((x,m,_)=>x+f[_]/g*n.values[m],0):n.values[l[0]]}outline(){let e=this.result?.geometry.attributes.position;if(!e)return[];let t=Math.max(1,Math.floor(e.count/3e3)),{x:n,y:s,z:r}=this.group.position,o=[];for(let l=0;l<e.count;l+=t)o.push([e.getX(l)+n,e.getY(l)+s,e.getZ(l)+r]);let a=this.result.geometry.boundingBox??(this.result.geometry.computeBoundingBox(),this.result.geometry.boundingBox);for(let l=0;l<e.count;l+=1){let c=[e.getX(l),e.getY(l),e.getZ(l)];if(c.some((u,h)=>u===a.min.getComponent(h)||u===a.max.getComponent(h))&&o.push([c[0]+n,c[1]+s,c[2]+r]),o.length>4e3)break}return o}};function rC(i){let{segments:e}=i.lines.find(({name:o})=>o==="reactions")??{segments:new Float32Array},t=new P,n=new P,s=0;for(let o=0;o<e.length;o+=6)s=Math.max(s,t.fromArray(e,o).distanceTo(n.fromArray(e,o+3)));let r=[];for(let o=0;o<e.length;o+=6){t.fromArray(e,o),n.fromArray(e,o+3);let a=n.clone().sub(t),l=a.length();if(!(l>1e-6*s))continue;a.divideScalar(l);let c=new P(Math.abs(a.x)<.8?1:0,Math.abs(a.x)<.8?0:1,0).cross(a).normalize(),u=Math.min(s*xg.length,l),h=n.clone().addScaledVector(a,-u);r.push(...t.toArray(),...n.toArray());for(let d of[c,c.clone().cross(a)])for(let f of[-1,1])r.push(...h.clone().addScaledVector(d,f*u*xg.width/xg.length).toArray(),...n.toArray())}return new Float32Array(r)}function oC(i){let e=new Float32Array(3*i.values.length);return i.values.forEach((t,n)=>e.set(Fd(i.scale,Hd(i,t)),3*n)),e}function aC(i){let e=new Float32Array(6*i.values.length);return i.values.forEach((t,n)=>{let s=Fd(i.scale,Hd(i,t));e.set(s,6*n),e.set(s,6*n+3)}),e}var Sv=new WeakMap;function lC(i){let e=Sv.get(i);if(e)return e;let t=i.geometry.attributes.position.array,{ends:n}=zd(i.geometry),s=new Float32Array(3*n.length);return n.forEach((r,o)=>s.set(t.subarray(3*r,3*r+3),3*o)),Sv.set(i,s),s}function cC({segments:i,values:e},t){let n=1/0,s=null,r=new P,o=new P,a=new P;for(let l=0;l<e.length;l+=1){r.fromArray(i,6*l),o.fromArray(i,6*l+3).sub(r),a.copy(t).sub(r);let c=Math.min(1,Math.max(0,a.dot(o)/o.lengthSq())),u=a.addScaledVector(o,-c).lengthSq();u<n&&([n,s]=[u,e[l]])}return s}var Gi=(i,e)=>i?.line===e?.line&&i?.point===e?.point,uC=`
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
}`,hC=`
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
}`,Wd=class{constructor(e){this.look=e;let t=n=>({value:new Ue(n)});this.material=new mn({vertexShader:uC,fragmentShader:hC,transparent:!0,uniforms:{scale:{value:1},size:{value:11},near:{value:.001},paper:t(e.paper),accent:t(e.accent),ink:t(e.ink),fault:t(e.fault)}}),this.group.add(this.extra)}look;group=new Sn;places=[];refs=[];points=null;lines=null;cables=[];extra=new Sn;material;restyle(e){this.look=e;for(let t of["paper","accent","ink","fault"])this.material.uniforms[t].value.set(e[t])}setPixel(e,t){this.material.uniforms.near.value=e,this.material.uniforms.scale.value=t}show(e,t,n,s={courses:[],chosen:-1}){let r=[],o=[],a=[];e.forEach((l,c)=>{let h=l.points.map(Dt).map(g=>g?n.toScene(g):null);if(h.forEach((g,x)=>{if(!el(l,x))return;let m=g??dC(h[(x+h.length-1)%h.length]??null,h[(x+1)%h.length]??null);m&&(r.push(m),o.push({line:c,point:x}))}),Nr(l))return;let d=h.filter(g=>g!==null),f=l.closed&&d.length>2?d.length:d.length-1;for(let g=0;g<f;g+=1)a.push(...d[g],...d[(g+1)%d.length])}),t?.forEach((l,c)=>{r.push(n.toScene(l)),o.push({line:-1,point:c}),c>0&&a.push(...n.toScene(t[c-1]),...n.toScene(l))}),this.places=r,this.refs=o,this.setLines(new Float32Array(a)),this.setCables(s.courses.map(l=>l.map(c=>n.toScene(c))),s.chosen),this.setPoints()}setLines(e){this.lines&&(Ra(this.lines),this.group.remove(this.lines)),this.lines=e.length>0?_c(e,2.4,this.look.accent):null,this.lines&&(this.lines.renderOrder=1,this.group.add(this.lines))}setCables(e,t){for(let r of this.cables)Ra(r),this.group.remove(r);let n=r=>r.slice(1).flatMap((o,a)=>[...r[a],...o]),s=(r,o,a)=>r.length>0?[_c(new Float32Array(r),o,a)]:[];this.cables=[...s(e.flatMap((r,o)=>o===t?[]:n(r)),5,this.look.cable),...s(n(e[t]??[]),8,this.look.cable)];for(let r of this.cables)r.renderOrder=.9,r.material.depthWrite=!1,this.group.add(r)}setPoints(){let e=this.places.length;if(!this.points||this.points.geometry.attributes.position.count!==e){this.points&&(this.points.geometry.dispose(),this.group.remove(this.points));let n=new Kt;n.setAttribute("position",new mt(new Float32Array(3*e),3)),n.setAttribute("state",new mt(new Float32Array(e),1)),this.points=new Bi(n,this.material),this.points.frustumCulled=!1,this.points.renderOrder=2,this.group.add(this.points)}let{position:t}=this.points.geometry.attributes;this.places.forEach((n,s)=>t.setXYZ(s,...n)),t.needsUpdate=!0,this.material.uniforms.size.value=e>300?5:e>120?7:11}mark(e){let t=this.points?.geometry.attributes.state;t&&(this.refs.forEach((n,s)=>t.setX(s,e(n))),t.needsUpdate=!0)}hint(e){for(let n of this.extra.children)n.material===this.material?n.geometry.dispose():Ra(n);this.extra.clear();let t=(n,s,r)=>{if(!n||n.length<2)return;let o=_c(new Float32Array(n.flat()),1.6,s,void 0,r);o.renderOrder=1,this.extra.add(o)};if(t(e.segments,this.look.accent,.95),t(e.faint,this.look.soft,.8),e.ghost){let n=new Kt;n.setAttribute("position",new mt(new Float32Array(e.ghost),3)),n.setAttribute("state",new mt(new Float32Array([5]),1));let s=new Bi(n,this.material);s.renderOrder=3,this.extra.add(s)}}};function dC(i,e){return!i||!e?i??e:[0,1,2].map(t=>(i[t]+e[t])/2)}var tn={LEFT:1,RIGHT:2,MIDDLE:4},$=Object.freeze({NONE:0,ROTATE:1,TRUCK:2,SCREEN_PAN:4,OFFSET:8,DOLLY:16,ZOOM:32,TOUCH_ROTATE:64,TOUCH_TRUCK:128,TOUCH_SCREEN_PAN:256,TOUCH_OFFSET:512,TOUCH_DOLLY:1024,TOUCH_ZOOM:2048,TOUCH_DOLLY_TRUCK:4096,TOUCH_DOLLY_SCREEN_PAN:8192,TOUCH_DOLLY_OFFSET:16384,TOUCH_DOLLY_ROTATE:32768,TOUCH_ZOOM_TRUCK:65536,TOUCH_ZOOM_OFFSET:131072,TOUCH_ZOOM_SCREEN_PAN:262144,TOUCH_ZOOM_ROTATE:524288}),Pa={NONE:0,IN:1,OUT:-1};function ao(i){return i.isPerspectiveCamera}function wr(i){return i.isOrthographicCamera}var Sr=Math.PI*2,wv=Math.PI/2,Iv=1e-5,yc=Math.PI/180;function Wi(i,e,t){return Math.max(e,Math.min(t,i))}function qt(i,e=Iv){return Math.abs(i)<e}function Lt(i,e,t=Iv){return qt(i-e,t)}function Mv(i,e){return Math.round(i/e)*e}function xc(i){return isFinite(i)?i:i<0?-Number.MAX_VALUE:Number.MAX_VALUE}function vc(i){return Math.abs(i)<Number.MAX_VALUE?i:i*(1/0)}function Xd(i,e,t,n,s=1/0,r){n=Math.max(1e-4,n);let o=2/n,a=o*r,l=1/(1+a+.48*a*a+.235*a*a*a),c=i-e,u=e,h=s*n;c=Wi(c,-h,h),e=i-c;let d=(t.value+o*c)*r;t.value=(t.value-o*d)*l;let f=e+(c+d)*l;return u-i>0==f>u&&(f=u,t.value=(f-u)/r),f}function Ev(i,e,t,n,s=1/0,r,o){n=Math.max(1e-4,n);let a=2/n,l=a*r,c=1/(1+l+.48*l*l+.235*l*l*l),u=e.x,h=e.y,d=e.z,f=i.x-u,g=i.y-h,x=i.z-d,m=u,_=h,v=d,M=s*n,b=M*M,S=f*f+g*g+x*x;if(S>b){let D=Math.sqrt(S);f=f/D*M,g=g/D*M,x=x/D*M}u=i.x-f,h=i.y-g,d=i.z-x;let y=(t.x+a*f)*r,p=(t.y+a*g)*r,w=(t.z+a*x)*r;t.x=(t.x-a*y)*c,t.y=(t.y-a*p)*c,t.z=(t.z-a*w)*c,o.x=u+(f+y)*c,o.y=h+(g+p)*c,o.z=d+(x+w)*c;let T=m-i.x,E=_-i.y,C=v-i.z,O=o.x-m,U=o.y-_,I=o.z-v;return T*O+E*U+C*I>0&&(o.x=m,o.y=_,o.z=v,t.x=(o.x-m)/r,t.y=(o.y-_)/r,t.z=(o.z-v)/r),o}function vg(i,e){e.set(0,0),i.forEach(t=>{e.x+=t.clientX,e.y+=t.clientY}),e.x/=i.length,e.y/=i.length}function bg(i,e){return wr(i)?(console.warn(`${e} is not supported in OrthographicCamera`),!0):!1}var Ag=class{constructor(){this._listeners={}}addEventListener(e,t){let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let s=this._listeners[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}removeAllEventListeners(e){if(!e){this._listeners={};return}Array.isArray(this._listeners[e])&&(this._listeners[e].length=0)}dispatchEvent(e){let n=this._listeners[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e)}}},Sg,fC="3.1.0",qd=1/8,pC=/Mac/.test((Sg=globalThis?.navigator)===null||Sg===void 0?void 0:Sg.platform),Ke,Tv,Yd,wg,ai,nt,wt,Ia,bc,xs,vs,lo,Av,Rv,_i,La,Oa,Cv,Mg,Pv,Eg,Tg,$d,Na=class i extends Ag{static install(e){Ke=e.THREE,Tv=Object.freeze(new Ke.Vector3(0,0,0)),Yd=Object.freeze(new Ke.Vector3(0,1,0)),wg=Object.freeze(new Ke.Vector3(0,0,1)),ai=new Ke.Vector2,nt=new Ke.Vector3,wt=new Ke.Vector3,Ia=new Ke.Vector3,bc=new Ke.Vector3,xs=new Ke.Vector3,vs=new Ke.Vector3,lo=new Ke.Vector3,Av=new Ke.Vector3,Rv=new Ke.Vector3,_i=new Ke.Spherical,La=new Ke.Spherical,Oa=new Ke.Box3,Cv=new Ke.Box3,Mg=new Ke.Sphere,Pv=new Ke.Quaternion,Eg=new Ke.Quaternion,Tg=new Ke.Matrix4,$d=new Ke.Raycaster}static get ACTION(){return $}set verticalDragToForward(e){console.warn("camera-controls: `verticalDragToForward` was removed. Use `mouseButtons.left = CameraControls.ACTION.SCREEN_PAN` instead.")}constructor(e,t){super(),this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.minDistance=Number.EPSILON,this.maxDistance=1/0,this.infinityDolly=!1,this.minZoom=.01,this.maxZoom=1/0,this.smoothTime=.25,this.draggingSmoothTime=.125,this.maxSpeed=1/0,this.azimuthRotateSpeed=1,this.polarRotateSpeed=1,this.dollySpeed=1,this.dollyDragInverted=!1,this.truckSpeed=2,this.dollyToCursor=!1,this.dragToOffset=!1,this.boundaryFriction=0,this.restThreshold=.01,this.colliderMeshes=[],this.cancel=()=>{},this._enabled=!0,this._state=$.NONE,this._viewport=null,this._changedDolly=0,this._changedZoom=0,this._hasRested=!0,this._boundaryEnclosesCamera=!1,this._needsUpdate=!0,this._updatedLastTime=!1,this._elementRect=new DOMRect,this._isDragging=!1,this._dragNeedsUpdate=!0,this._activePointers=[],this._lockedPointer=null,this._interactiveArea=new DOMRect(0,0,1,1),this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._isUserControllingOffset=!1,this._isUserControllingZoom=!1,this._lastDollyDirection=Pa.NONE,this._thetaVelocity={value:0},this._phiVelocity={value:0},this._radiusVelocity={value:0},this._targetVelocity=new Ke.Vector3,this._focalOffsetVelocity=new Ke.Vector3,this._zoomVelocity={value:0},this._truckInternal=(_,v,M,b)=>{let S,y;if(ao(this._camera)){let p=nt.copy(this._camera.position).sub(this._target),w=this._camera.getEffectiveFOV()*yc,T=p.length()*Math.tan(w*.5);S=this.truckSpeed*_*T/this._elementRect.height,y=this.truckSpeed*v*T/this._elementRect.height}else if(wr(this._camera)){let p=this._camera;S=this.truckSpeed*_*(p.right-p.left)/p.zoom/this._elementRect.width,y=this.truckSpeed*v*(p.top-p.bottom)/p.zoom/this._elementRect.height}else return;b?(M?this.setFocalOffset(this._focalOffsetEnd.x+S,this._focalOffsetEnd.y,this._focalOffsetEnd.z,!0):this.truck(S,0,!0),this.forward(-y,!0)):M?this.setFocalOffset(this._focalOffsetEnd.x+S,this._focalOffsetEnd.y+y,this._focalOffsetEnd.z,!0):this.truck(S,y,!0)},this._rotateInternal=(_,v)=>{let M=Sr*this.azimuthRotateSpeed*_/this._elementRect.height,b=Sr*this.polarRotateSpeed*v/this._elementRect.height;this.rotate(M,b,!0)},this._dollyInternal=(_,v,M)=>{let b=Math.pow(.95,-_*this.dollySpeed),S=this._sphericalEnd.radius,y=this._sphericalEnd.radius*b,p=Wi(y,this.minDistance,this.maxDistance),w=p-y;this.infinityDolly&&this.dollyToCursor?this._dollyToNoClamp(y,!0):this.infinityDolly&&!this.dollyToCursor?(this.dollyInFixed(w,!0),this._dollyToNoClamp(p,!0)):this._dollyToNoClamp(p,!0),this.dollyToCursor&&(this._changedDolly+=(this.infinityDolly?y:p)-S,this._dollyControlCoord.set(v,M)),this._lastDollyDirection=Math.sign(-_)},this._zoomInternal=(_,v,M)=>{let b=Math.pow(.95,_*this.dollySpeed),S=this._zoom,y=this._zoom*b;this.zoomTo(y,!0),this.dollyToCursor&&(this._changedZoom+=y-S,this._dollyControlCoord.set(v,M))},typeof Ke>"u"&&console.error("camera-controls: `THREE` is undefined. You must first run `CameraControls.install( { THREE: THREE } )`. Check the docs for further information."),this._camera=e,this._yAxisUpSpace=new Ke.Quaternion().setFromUnitVectors(this._camera.up,Yd),this._yAxisUpSpaceInverse=this._yAxisUpSpace.clone().invert(),this._state=$.NONE,this._target=new Ke.Vector3,this._targetEnd=this._target.clone(),this._focalOffset=new Ke.Vector3,this._focalOffsetEnd=this._focalOffset.clone(),this._spherical=new Ke.Spherical().setFromVector3(nt.copy(this._camera.position).applyQuaternion(this._yAxisUpSpace)),this._sphericalEnd=this._spherical.clone(),this._lastDistance=this._spherical.radius,this._zoom=this._camera.zoom,this._zoomEnd=this._zoom,this._lastZoom=this._zoom,this._nearPlaneCorners=[new Ke.Vector3,new Ke.Vector3,new Ke.Vector3,new Ke.Vector3],this._updateNearPlaneCorners(),this._boundary=new Ke.Box3(new Ke.Vector3(-1/0,-1/0,-1/0),new Ke.Vector3(1/0,1/0,1/0)),this._cameraUp0=this._camera.up.clone(),this._target0=this._target.clone(),this._position0=this._camera.position.clone(),this._zoom0=this._zoom,this._focalOffset0=this._focalOffset.clone(),this._dollyControlCoord=new Ke.Vector2,this.mouseButtons={left:$.ROTATE,middle:$.DOLLY,right:$.TRUCK,wheel:ao(this._camera)?$.DOLLY:wr(this._camera)?$.ZOOM:$.NONE},this.touches={one:$.TOUCH_ROTATE,two:ao(this._camera)?$.TOUCH_DOLLY_TRUCK:wr(this._camera)?$.TOUCH_ZOOM_TRUCK:$.NONE,three:$.TOUCH_TRUCK};let n=new Ke.Vector2,s=new Ke.Vector2,r=new Ke.Vector2,o=_=>{if(!this._enabled||!this._domElement)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let b=this._domElement.getBoundingClientRect(),S=_.clientX/b.width,y=_.clientY/b.height;if(S<this._interactiveArea.left||S>this._interactiveArea.right||y<this._interactiveArea.top||y>this._interactiveArea.bottom)return}let v=_.pointerType!=="mouse"?null:(_.buttons&tn.LEFT)===tn.LEFT?tn.LEFT:(_.buttons&tn.MIDDLE)===tn.MIDDLE?tn.MIDDLE:(_.buttons&tn.RIGHT)===tn.RIGHT?tn.RIGHT:null;if(v!==null){let b=this._findPointerByMouseButton(v);b&&this._disposePointer(b)}if((_.buttons&tn.LEFT)===tn.LEFT&&this._lockedPointer)return;let M={pointerId:_.pointerId,clientX:_.clientX,clientY:_.clientY,deltaX:0,deltaY:0,mouseButton:v};this._activePointers.push(M),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),this._isDragging=!0,d(_)},a=_=>{_.cancelable&&_.preventDefault();let v=_.pointerId,M=this._lockedPointer||this._findPointerById(v);if(M){if(M.clientX=_.clientX,M.clientY=_.clientY,M.deltaX=_.movementX,M.deltaY=_.movementY,this._state=0,_.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else(!this._isDragging&&this._lockedPointer||this._isDragging&&(_.buttons&tn.LEFT)===tn.LEFT)&&(this._state=this._state|this.mouseButtons.left),this._isDragging&&(_.buttons&tn.MIDDLE)===tn.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),this._isDragging&&(_.buttons&tn.RIGHT)===tn.RIGHT&&(this._state=this._state|this.mouseButtons.right);f()}},l=_=>{let v=this._findPointerById(_.pointerId);if(!(v&&v===this._lockedPointer)){if(v&&this._disposePointer(v),_.pointerType==="touch")switch(this._activePointers.length){case 0:this._state=$.NONE;break;case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else this._state=$.NONE;g()}},c=-1,u=_=>{if(!this._domElement||!this._enabled||this.mouseButtons.wheel===$.NONE)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let y=this._domElement.getBoundingClientRect(),p=_.clientX/y.width,w=_.clientY/y.height;if(p<this._interactiveArea.left||p>this._interactiveArea.right||w<this._interactiveArea.top||w>this._interactiveArea.bottom)return}if(_.preventDefault(),this.dollyToCursor||this.mouseButtons.wheel===$.ROTATE||this.mouseButtons.wheel===$.TRUCK){let y=performance.now();c-y<1e3&&this._getClientRect(this._elementRect),c=y}let v=pC?-1:-3,M=_.deltaMode===1||_.ctrlKey?_.deltaY/v:_.deltaY/(v*10),b=this.dollyToCursor?(_.clientX-this._elementRect.x)/this._elementRect.width*2-1:0,S=this.dollyToCursor?(_.clientY-this._elementRect.y)/this._elementRect.height*-2+1:0;switch(this.mouseButtons.wheel){case $.ROTATE:{this._rotateInternal(_.deltaX,_.deltaY),this._isUserControllingRotate=!0;break}case $.TRUCK:{this._truckInternal(_.deltaX,_.deltaY,!1,!1),this._isUserControllingTruck=!0;break}case $.SCREEN_PAN:{this._truckInternal(_.deltaX,_.deltaY,!1,!0),this._isUserControllingTruck=!0;break}case $.OFFSET:{this._truckInternal(_.deltaX,_.deltaY,!0,!1),this._isUserControllingOffset=!0;break}case $.DOLLY:{this._dollyInternal(-M,b,S),this._isUserControllingDolly=!0;break}case $.ZOOM:{this._zoomInternal(-M,b,S),this._isUserControllingZoom=!0;break}}this.dispatchEvent({type:"control"})},h=_=>{if(!(!this._domElement||!this._enabled)){if(this.mouseButtons.right===i.ACTION.NONE){let v=_ instanceof PointerEvent?_.pointerId:0,M=this._findPointerById(v);M&&this._disposePointer(M),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l);return}_.preventDefault()}},d=_=>{if(!this._enabled)return;if(vg(this._activePointers,ai),this._getClientRect(this._elementRect),n.copy(ai),s.copy(ai),this._activePointers.length>=2){let M=ai.x-this._activePointers[1].clientX,b=ai.y-this._activePointers[1].clientY,S=Math.sqrt(M*M+b*b);r.set(0,S);let y=(this._activePointers[0].clientX+this._activePointers[1].clientX)*.5,p=(this._activePointers[0].clientY+this._activePointers[1].clientY)*.5;s.set(y,p)}if(this._state=0,!_)this._lockedPointer&&(this._state=this._state|this.mouseButtons.left);else if("pointerType"in _&&_.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else!this._lockedPointer&&(_.buttons&tn.LEFT)===tn.LEFT&&(this._state=this._state|this.mouseButtons.left),(_.buttons&tn.MIDDLE)===tn.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),(_.buttons&tn.RIGHT)===tn.RIGHT&&(this._state=this._state|this.mouseButtons.right);((this._state&$.ROTATE)===$.ROTATE||(this._state&$.TOUCH_ROTATE)===$.TOUCH_ROTATE||(this._state&$.TOUCH_DOLLY_ROTATE)===$.TOUCH_DOLLY_ROTATE||(this._state&$.TOUCH_ZOOM_ROTATE)===$.TOUCH_ZOOM_ROTATE)&&(this._sphericalEnd.theta=this._spherical.theta,this._sphericalEnd.phi=this._spherical.phi,this._thetaVelocity.value=0,this._phiVelocity.value=0),((this._state&$.TRUCK)===$.TRUCK||(this._state&$.SCREEN_PAN)===$.SCREEN_PAN||(this._state&$.TOUCH_TRUCK)===$.TOUCH_TRUCK||(this._state&$.TOUCH_SCREEN_PAN)===$.TOUCH_SCREEN_PAN||(this._state&$.TOUCH_DOLLY_TRUCK)===$.TOUCH_DOLLY_TRUCK||(this._state&$.TOUCH_DOLLY_SCREEN_PAN)===$.TOUCH_DOLLY_SCREEN_PAN||(this._state&$.TOUCH_ZOOM_TRUCK)===$.TOUCH_ZOOM_TRUCK||(this._state&$.TOUCH_ZOOM_SCREEN_PAN)===$.TOUCH_DOLLY_SCREEN_PAN)&&(this._targetEnd.copy(this._target),this._targetVelocity.set(0,0,0)),((this._state&$.DOLLY)===$.DOLLY||(this._state&$.TOUCH_DOLLY)===$.TOUCH_DOLLY||(this._state&$.TOUCH_DOLLY_TRUCK)===$.TOUCH_DOLLY_TRUCK||(this._state&$.TOUCH_DOLLY_SCREEN_PAN)===$.TOUCH_DOLLY_SCREEN_PAN||(this._state&$.TOUCH_DOLLY_OFFSET)===$.TOUCH_DOLLY_OFFSET||(this._state&$.TOUCH_DOLLY_ROTATE)===$.TOUCH_DOLLY_ROTATE)&&(this._sphericalEnd.radius=this._spherical.radius,this._radiusVelocity.value=0),((this._state&$.ZOOM)===$.ZOOM||(this._state&$.TOUCH_ZOOM)===$.TOUCH_ZOOM||(this._state&$.TOUCH_ZOOM_TRUCK)===$.TOUCH_ZOOM_TRUCK||(this._state&$.TOUCH_ZOOM_SCREEN_PAN)===$.TOUCH_ZOOM_SCREEN_PAN||(this._state&$.TOUCH_ZOOM_OFFSET)===$.TOUCH_ZOOM_OFFSET||(this._state&$.TOUCH_ZOOM_ROTATE)===$.TOUCH_ZOOM_ROTATE)&&(this._zoomEnd=this._zoom,this._zoomVelocity.value=0),((this._state&$.OFFSET)===$.OFFSET||(this._state&$.TOUCH_OFFSET)===$.TOUCH_OFFSET||(this._state&$.TOUCH_DOLLY_OFFSET)===$.TOUCH_DOLLY_OFFSET||(this._state&$.TOUCH_ZOOM_OFFSET)===$.TOUCH_ZOOM_OFFSET)&&(this._focalOffsetEnd.copy(this._focalOffset),this._focalOffsetVelocity.set(0,0,0)),this.dispatchEvent({type:"controlstart"})},f=()=>{if(!this._enabled||!this._dragNeedsUpdate)return;this._dragNeedsUpdate=!1,vg(this._activePointers,ai);let v=this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement?this._lockedPointer||this._activePointers[0]:null,M=v?-v.deltaX:s.x-ai.x,b=v?-v.deltaY:s.y-ai.y;if(s.copy(ai),((this._state&$.ROTATE)===$.ROTATE||(this._state&$.TOUCH_ROTATE)===$.TOUCH_ROTATE||(this._state&$.TOUCH_DOLLY_ROTATE)===$.TOUCH_DOLLY_ROTATE||(this._state&$.TOUCH_ZOOM_ROTATE)===$.TOUCH_ZOOM_ROTATE)&&(this._rotateInternal(M,b),this._isUserControllingRotate=!0),(this._state&$.DOLLY)===$.DOLLY||(this._state&$.ZOOM)===$.ZOOM){let S=this.dollyToCursor?(n.x-this._elementRect.x)/this._elementRect.width*2-1:0,y=this.dollyToCursor?(n.y-this._elementRect.y)/this._elementRect.height*-2+1:0,p=this.dollyDragInverted?-1:1;(this._state&$.DOLLY)===$.DOLLY?(this._dollyInternal(p*b*qd,S,y),this._isUserControllingDolly=!0):(this._zoomInternal(p*b*qd,S,y),this._isUserControllingZoom=!0)}if((this._state&$.TOUCH_DOLLY)===$.TOUCH_DOLLY||(this._state&$.TOUCH_ZOOM)===$.TOUCH_ZOOM||(this._state&$.TOUCH_DOLLY_TRUCK)===$.TOUCH_DOLLY_TRUCK||(this._state&$.TOUCH_ZOOM_TRUCK)===$.TOUCH_ZOOM_TRUCK||(this._state&$.TOUCH_DOLLY_SCREEN_PAN)===$.TOUCH_DOLLY_SCREEN_PAN||(this._state&$.TOUCH_ZOOM_SCREEN_PAN)===$.TOUCH_ZOOM_SCREEN_PAN||(this._state&$.TOUCH_DOLLY_OFFSET)===$.TOUCH_DOLLY_OFFSET||(this._state&$.TOUCH_ZOOM_OFFSET)===$.TOUCH_ZOOM_OFFSET||(this._state&$.TOUCH_DOLLY_ROTATE)===$.TOUCH_DOLLY_ROTATE||(this._state&$.TOUCH_ZOOM_ROTATE)===$.TOUCH_ZOOM_ROTATE){let S=ai.x-this._activePointers[1].clientX,y=ai.y-this._activePointers[1].clientY,p=Math.sqrt(S*S+y*y),w=r.y-p;r.set(0,p);let T=this.dollyToCursor?(s.x-this._elementRect.x)/this._elementRect.width*2-1:0,E=this.dollyToCursor?(s.y-this._elementRect.y)/this._elementRect.height*-2+1:0;(this._state&$.TOUCH_DOLLY)===$.TOUCH_DOLLY||(this._state&$.TOUCH_DOLLY_ROTATE)===$.TOUCH_DOLLY_ROTATE||(this._state&$.TOUCH_DOLLY_TRUCK)===$.TOUCH_DOLLY_TRUCK||(this._state&$.TOUCH_DOLLY_SCREEN_PAN)===$.TOUCH_DOLLY_SCREEN_PAN||(this._state&$.TOUCH_DOLLY_OFFSET)===$.TOUCH_DOLLY_OFFSET?(this._dollyInternal(w*qd,T,E),this._isUserControllingDolly=!0):(this._zoomInternal(w*qd,T,E),this._isUserControllingZoom=!0)}((this._state&$.TRUCK)===$.TRUCK||(this._state&$.TOUCH_TRUCK)===$.TOUCH_TRUCK||(this._state&$.TOUCH_DOLLY_TRUCK)===$.TOUCH_DOLLY_TRUCK||(this._state&$.TOUCH_ZOOM_TRUCK)===$.TOUCH_ZOOM_TRUCK)&&(this._truckInternal(M,b,!1,!1),this._isUserControllingTruck=!0),((this._state&$.SCREEN_PAN)===$.SCREEN_PAN||(this._state&$.TOUCH_SCREEN_PAN)===$.TOUCH_SCREEN_PAN||(this._state&$.TOUCH_DOLLY_SCREEN_PAN)===$.TOUCH_DOLLY_SCREEN_PAN||(this._state&$.TOUCH_ZOOM_SCREEN_PAN)===$.TOUCH_ZOOM_SCREEN_PAN)&&(this._truckInternal(M,b,!1,!0),this._isUserControllingTruck=!0),((this._state&$.OFFSET)===$.OFFSET||(this._state&$.TOUCH_OFFSET)===$.TOUCH_OFFSET||(this._state&$.TOUCH_DOLLY_OFFSET)===$.TOUCH_DOLLY_OFFSET||(this._state&$.TOUCH_ZOOM_OFFSET)===$.TOUCH_ZOOM_OFFSET)&&(this._truckInternal(M,b,!0,!1),this._isUserControllingOffset=!0),this.dispatchEvent({type:"control"})},g=()=>{vg(this._activePointers,ai),s.copy(ai),this._dragNeedsUpdate=!1,(this._activePointers.length===0||this._activePointers.length===1&&this._activePointers[0]===this._lockedPointer)&&(this._isDragging=!1),this._activePointers.length===0&&this._domElement&&(this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this.dispatchEvent({type:"controlend"}))};this.lockPointer=()=>{!this._enabled||!this._domElement||(this.cancel(),this._lockedPointer={pointerId:-1,clientX:0,clientY:0,deltaX:0,deltaY:0,mouseButton:null},this._activePointers.push(this._lockedPointer),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.requestPointerLock(),this._domElement.ownerDocument.addEventListener("pointerlockchange",x),this._domElement.ownerDocument.addEventListener("pointerlockerror",m),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),d())},this.unlockPointer=()=>{var _,v,M;this._lockedPointer!==null&&(this._disposePointer(this._lockedPointer),this._lockedPointer=null),(_=this._domElement)===null||_===void 0||_.ownerDocument.exitPointerLock(),(v=this._domElement)===null||v===void 0||v.ownerDocument.removeEventListener("pointerlockchange",x),(M=this._domElement)===null||M===void 0||M.ownerDocument.removeEventListener("pointerlockerror",m),this.cancel()};let x=()=>{this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement||this.unlockPointer()},m=()=>{this.unlockPointer()};this._addAllEventListeners=_=>{this._domElement=_,this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none",this._domElement.addEventListener("pointerdown",o),this._domElement.addEventListener("pointercancel",l),this._domElement.addEventListener("wheel",u,{passive:!1}),this._domElement.addEventListener("contextmenu",h)},this._removeAllEventListeners=()=>{this._domElement&&(this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect="",this._domElement.removeEventListener("pointerdown",o),this._domElement.removeEventListener("pointercancel",l),this._domElement.removeEventListener("wheel",u,{passive:!1}),this._domElement.removeEventListener("contextmenu",h),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.removeEventListener("pointerlockchange",x),this._domElement.ownerDocument.removeEventListener("pointerlockerror",m))},this.cancel=()=>{this._state!==$.NONE&&(this._state=$.NONE,this._activePointers.length=0,g())},t&&this.connect(t),this.update(0)}get camera(){return this._camera}set camera(e){this._camera=e,this.updateCameraUp(),this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0}get enabled(){return this._enabled}set enabled(e){this._enabled=e,this._domElement&&(e?(this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none"):(this.cancel(),this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect=""))}get active(){return!this._hasRested}get currentAction(){return this._state}get distance(){return this._spherical.radius}set distance(e){this._spherical.radius===e&&this._sphericalEnd.radius===e||(this._spherical.radius=e,this._sphericalEnd.radius=e,this._needsUpdate=!0)}get azimuthAngle(){return this._spherical.theta}set azimuthAngle(e){this._spherical.theta===e&&this._sphericalEnd.theta===e||(this._spherical.theta=e,this._sphericalEnd.theta=e,this._needsUpdate=!0)}get polarAngle(){return this._spherical.phi}set polarAngle(e){this._spherical.phi===e&&this._sphericalEnd.phi===e||(this._spherical.phi=e,this._sphericalEnd.phi=e,this._needsUpdate=!0)}get boundaryEnclosesCamera(){return this._boundaryEnclosesCamera}set boundaryEnclosesCamera(e){this._boundaryEnclosesCamera=e,this._needsUpdate=!0}set interactiveArea(e){this._interactiveArea.width=Wi(e.width,0,1),this._interactiveArea.height=Wi(e.height,0,1),this._interactiveArea.x=Wi(e.x,0,1-this._interactiveArea.width),this._interactiveArea.y=Wi(e.y,0,1-this._interactiveArea.height)}addEventListener(e,t){super.addEventListener(e,t)}removeEventListener(e,t){super.removeEventListener(e,t)}rotate(e,t,n=!1){return this.rotateTo(this._sphericalEnd.theta+e,this._sphericalEnd.phi+t,n)}rotateAzimuthTo(e,t=!1){return this.rotateTo(e,this._sphericalEnd.phi,t)}rotatePolarTo(e,t=!1){return this.rotateTo(this._sphericalEnd.theta,e,t)}rotateTo(e,t,n=!1){this._isUserControllingRotate=!1;let s=Wi(e,this.minAzimuthAngle,this.maxAzimuthAngle),r=Wi(t,this.minPolarAngle,this.maxPolarAngle);this._sphericalEnd.theta=s,this._sphericalEnd.phi=r,this._sphericalEnd.makeSafe(),this._needsUpdate=!0,n||(this._spherical.theta=this._sphericalEnd.theta,this._spherical.phi=this._sphericalEnd.phi);let o=!n||Lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold);return this._createOnRestPromise(o)}dolly(e,t=!1){return this.dollyTo(this._sphericalEnd.radius-e,t)}dollyTo(e,t=!1){return this._isUserControllingDolly=!1,this._lastDollyDirection=Pa.NONE,this._changedDolly=0,this._dollyToNoClamp(Wi(e,this.minDistance,this.maxDistance),t)}_dollyToNoClamp(e,t=!1){let n=this._sphericalEnd.radius;if(this.colliderMeshes.length>=1){let o=this._collisionTest(),a=Lt(o,this._spherical.radius);if(!(n>e)&&a)return Promise.resolve();this._sphericalEnd.radius=Math.min(e,o)}else this._sphericalEnd.radius=e;this._needsUpdate=!0,t||(this._spherical.radius=this._sphericalEnd.radius);let r=!t||Lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(r)}dollyInFixed(e,t=!1){this._targetEnd.add(this._getCameraDirection(bc).multiplyScalar(e)),t||this._target.copy(this._targetEnd);let n=!t||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(n)}zoom(e,t=!1){return this.zoomTo(this._zoomEnd+e,t)}zoomTo(e,t=!1){this._isUserControllingZoom=!1,this._zoomEnd=Wi(e,this.minZoom,this.maxZoom),this._needsUpdate=!0,t||(this._zoom=this._zoomEnd);let n=!t||Lt(this._zoom,this._zoomEnd,this.restThreshold);return this._changedZoom=0,this._createOnRestPromise(n)}pan(e,t,n=!1){return console.warn("`pan` has been renamed to `truck`"),this.truck(e,t,n)}truck(e,t,n=!1){this._camera.updateMatrix(),xs.setFromMatrixColumn(this._camera.matrix,0),vs.setFromMatrixColumn(this._camera.matrix,1),xs.multiplyScalar(e),vs.multiplyScalar(-t);let s=nt.copy(xs).add(vs),r=wt.copy(this._targetEnd).add(s);return this.moveTo(r.x,r.y,r.z,n)}forward(e,t=!1){nt.setFromMatrixColumn(this._camera.matrix,0),nt.crossVectors(this._camera.up,nt),nt.multiplyScalar(e);let n=wt.copy(this._targetEnd).add(nt);return this.moveTo(n.x,n.y,n.z,t)}elevate(e,t=!1){return nt.copy(this._camera.up).multiplyScalar(e),this.moveTo(this._targetEnd.x+nt.x,this._targetEnd.y+nt.y,this._targetEnd.z+nt.z,t)}moveTo(e,t,n,s=!1){this._isUserControllingTruck=!1;let r=nt.set(e,t,n).sub(this._targetEnd);this._encloseToBoundary(this._targetEnd,r,this.boundaryFriction),this._needsUpdate=!0,s||this._target.copy(this._targetEnd);let o=!s||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(o)}lookInDirectionOf(e,t,n,s=!1){let a=nt.set(e,t,n).sub(this._targetEnd).normalize().multiplyScalar(-this._sphericalEnd.radius).add(this._targetEnd);return this.setPosition(a.x,a.y,a.z,s)}fitToBox(e,t,{cover:n=!1,paddingLeft:s=0,paddingRight:r=0,paddingBottom:o=0,paddingTop:a=0}={}){let l=[],c=e.isBox3?Oa.copy(e):Oa.setFromObject(e);c.isEmpty()&&(console.warn("camera-controls: fitTo() cannot be used with an empty box. Aborting"),Promise.resolve());let u=Mv(this._sphericalEnd.theta,wv),h=Mv(this._sphericalEnd.phi,wv);l.push(this.rotateTo(u,h,t));let d=nt.setFromSpherical(this._sphericalEnd).normalize(),f=Pv.setFromUnitVectors(d,wg),g=Lt(Math.abs(d.y),1);g&&f.multiply(Eg.setFromAxisAngle(Yd,u)),f.multiply(this._yAxisUpSpaceInverse);let x=Cv.makeEmpty();wt.copy(c.min).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.min).setX(c.max.x).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.min).setY(c.max.y).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.max).setZ(c.min.z).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.min).setZ(c.max.z).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.max).setY(c.min.y).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.max).setX(c.min.x).applyQuaternion(f),x.expandByPoint(wt),wt.copy(c.max).applyQuaternion(f),x.expandByPoint(wt),x.min.x-=s,x.min.y-=o,x.max.x+=r,x.max.y+=a,f.setFromUnitVectors(wg,d),g&&f.premultiply(Eg.invert()),f.premultiply(this._yAxisUpSpace);let m=x.getSize(nt),_=x.getCenter(wt).applyQuaternion(f);if(ao(this._camera)){let v=this.getDistanceToFitBox(m.x,m.y,m.z,n);l.push(this.moveTo(_.x,_.y,_.z,t)),l.push(this.dollyTo(v,t)),l.push(this.setFocalOffset(0,0,0,t))}else if(wr(this._camera)){let v=this._camera,M=v.right-v.left,b=v.top-v.bottom,S=n?Math.max(M/m.x,b/m.y):Math.min(M/m.x,b/m.y);l.push(this.moveTo(_.x,_.y,_.z,t)),l.push(this.zoomTo(S,t)),l.push(this.setFocalOffset(0,0,0,t))}return Promise.all(l)}fitToSphere(e,t){let n=[],r="isObject3D"in e?i.createBoundingSphere(e,Mg):Mg.copy(e);if(n.push(this.moveTo(r.center.x,r.center.y,r.center.z,t)),ao(this._camera)){let o=this.getDistanceToFitSphere(r.radius);n.push(this.dollyTo(o,t))}else if(wr(this._camera)){let o=this._camera.right-this._camera.left,a=this._camera.top-this._camera.bottom,l=2*r.radius,c=Math.min(o/l,a/l);n.push(this.zoomTo(c,t))}return n.push(this.setFocalOffset(0,0,0,t)),Promise.all(n)}setLookAt(e,t,n,s,r,o,a=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=Pa.NONE,this._changedDolly=0;let l=wt.set(s,r,o),c=nt.set(e,t,n);this._targetEnd.copy(l),this._sphericalEnd.setFromVector3(c.sub(l).applyQuaternion(this._yAxisUpSpace)),this._needsUpdate=!0,a||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let u=!a||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold)&&Lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&Lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(u)}lerp(e,t,n,s=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=Pa.NONE,this._changedDolly=0;let r=nt.set(...e.target);if("spherical"in e)_i.set(...e.spherical);else{let h=wt.set(...e.position);_i.setFromVector3(h.sub(r).applyQuaternion(this._yAxisUpSpace))}let o=Ia.set(...t.target);if("spherical"in t)La.set(...t.spherical);else{let h=wt.set(...t.position);La.setFromVector3(h.sub(o).applyQuaternion(this._yAxisUpSpace))}this._targetEnd.copy(r.lerp(o,n));let a=La.theta-_i.theta,l=La.phi-_i.phi,c=La.radius-_i.radius;this._sphericalEnd.set(_i.radius+c*n,_i.phi+l*n,_i.theta+a*n),this._needsUpdate=!0,s||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let u=!s||Lt(this._target.x,this._targetEnd.x,this.restThreshold)&&Lt(this._target.y,this._targetEnd.y,this.restThreshold)&&Lt(this._target.z,this._targetEnd.z,this.restThreshold)&&Lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&Lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&Lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(u)}lerpLookAt(e,t,n,s,r,o,a,l,c,u,h,d,f,g=!1){return this.lerp({position:[e,t,n],target:[s,r,o]},{position:[a,l,c],target:[u,h,d]},f,g)}setPosition(e,t,n,s=!1){return this.setLookAt(e,t,n,this._targetEnd.x,this._targetEnd.y,this._targetEnd.z,s)}setTarget(e,t,n,s=!1){let r=this.getPosition(nt),o=this.setLookAt(r.x,r.y,r.z,e,t,n,s);return this._sphericalEnd.phi=Wi(this._sphericalEnd.phi,this.minPolarAngle,this.maxPolarAngle),o}setFocalOffset(e,t,n,s=!1){this._isUserControllingOffset=!1,this._focalOffsetEnd.set(e,t,n),this._needsUpdate=!0,s||this._focalOffset.copy(this._focalOffsetEnd);let r=!s||Lt(this._focalOffset.x,this._focalOffsetEnd.x,this.restThreshold)&&Lt(this._focalOffset.y,this._focalOffsetEnd.y,this.restThreshold)&&Lt(this._focalOffset.z,this._focalOffsetEnd.z,this.restThreshold);return this._createOnRestPromise(r)}setOrbitPoint(e,t,n){this._camera.updateMatrixWorld(),xs.setFromMatrixColumn(this._camera.matrixWorldInverse,0),vs.setFromMatrixColumn(this._camera.matrixWorldInverse,1),lo.setFromMatrixColumn(this._camera.matrixWorldInverse,2);let s=nt.set(e,t,n),r=s.distanceTo(this._camera.position),o=s.sub(this._camera.position);xs.multiplyScalar(o.x),vs.multiplyScalar(o.y),lo.multiplyScalar(o.z),nt.copy(xs).add(vs).add(lo),nt.z=nt.z+r,this.dollyTo(r,!1),this.setFocalOffset(-nt.x,nt.y,-nt.z,!1),this.moveTo(e,t,n,!1)}setBoundary(e){if(!e){this._boundary.min.set(-1/0,-1/0,-1/0),this._boundary.max.set(1/0,1/0,1/0),this._needsUpdate=!0;return}this._boundary.copy(e),this._boundary.clampPoint(this._targetEnd,this._targetEnd),this._needsUpdate=!0}setViewport(e,t,n,s){if(e===null){this._viewport=null;return}this._viewport=this._viewport||new Ke.Vector4,typeof e=="number"?this._viewport.set(e,t,n,s):this._viewport.copy(e)}getDistanceToFitBox(e,t,n,s=!1){if(bg(this._camera,"getDistanceToFitBox"))return this._spherical.radius;let r=e/t,o=this._camera.getEffectiveFOV()*yc,a=this._camera.aspect;return((s?r>a:r<a)?t:e/a)*.5/Math.tan(o*.5)+n*.5}getDistanceToFitSphere(e){if(bg(this._camera,"getDistanceToFitSphere"))return this._spherical.radius;let t=this._camera.getEffectiveFOV()*yc,n=Math.atan(Math.tan(t*.5)*this._camera.aspect)*2,s=1<this._camera.aspect?t:n;return e/Math.sin(s*.5)}getTarget(e,t=!0){return(e&&e.isVector3?e:new Ke.Vector3).copy(t?this._targetEnd:this._target)}getPosition(e,t=!0){return(e&&e.isVector3?e:new Ke.Vector3).setFromSpherical(t?this._sphericalEnd:this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(t?this._targetEnd:this._target)}getSpherical(e,t=!0){return(e||new Ke.Spherical).copy(t?this._sphericalEnd:this._spherical)}getFocalOffset(e,t=!0){return(e&&e.isVector3?e:new Ke.Vector3).copy(t?this._focalOffsetEnd:this._focalOffset)}normalizeRotations(){return this._sphericalEnd.theta=(this._sphericalEnd.theta%Sr+Sr)%Sr,this._sphericalEnd.theta>Math.PI&&(this._sphericalEnd.theta-=Sr),this._spherical.theta+=Sr*Math.round((this._sphericalEnd.theta-this._spherical.theta)/Sr),this}stop(){this._focalOffset.copy(this._focalOffsetEnd),this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd),this._zoom=this._zoomEnd}reset(e=!1){if(!Lt(this._camera.up.x,this._cameraUp0.x)||!Lt(this._camera.up.y,this._cameraUp0.y)||!Lt(this._camera.up.z,this._cameraUp0.z)){this._camera.up.copy(this._cameraUp0);let n=this.getPosition(nt);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}let t=[this.setLookAt(this._position0.x,this._position0.y,this._position0.z,this._target0.x,this._target0.y,this._target0.z,e),this.setFocalOffset(this._focalOffset0.x,this._focalOffset0.y,this._focalOffset0.z,e),this.zoomTo(this._zoom0,e)];return Promise.all(t)}saveState(){this._cameraUp0.copy(this._camera.up),this.getTarget(this._target0),this.getPosition(this._position0),this._zoom0=this._zoom,this._focalOffset0.copy(this._focalOffset)}updateCameraUp(){this._yAxisUpSpace.setFromUnitVectors(this._camera.up,Yd),this._yAxisUpSpaceInverse.copy(this._yAxisUpSpace).invert()}applyCameraUp(){let e=nt.subVectors(this._target,this._camera.position).normalize(),t=wt.crossVectors(e,this._camera.up);this._camera.up.crossVectors(t,e).normalize(),this._camera.updateMatrixWorld();let n=this.getPosition(nt);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}update(e){let t=this._sphericalEnd.theta-this._spherical.theta,n=this._sphericalEnd.phi-this._spherical.phi,s=this._sphericalEnd.radius-this._spherical.radius,r=Av.subVectors(this._targetEnd,this._target),o=Rv.subVectors(this._focalOffsetEnd,this._focalOffset),a=this._zoomEnd-this._zoom;if(qt(t))this._thetaVelocity.value=0,this._spherical.theta=this._sphericalEnd.theta;else{let h=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.theta=Xd(this._spherical.theta,this._sphericalEnd.theta,this._thetaVelocity,h,1/0,e),this._needsUpdate=!0}if(qt(n))this._phiVelocity.value=0,this._spherical.phi=this._sphericalEnd.phi;else{let h=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.phi=Xd(this._spherical.phi,this._sphericalEnd.phi,this._phiVelocity,h,1/0,e),this._needsUpdate=!0}if(qt(s))this._radiusVelocity.value=0,this._spherical.radius=this._sphericalEnd.radius;else{let h=this._isUserControllingDolly?this.draggingSmoothTime:this.smoothTime;this._spherical.radius=Xd(this._spherical.radius,this._sphericalEnd.radius,this._radiusVelocity,h,this.maxSpeed,e),this._needsUpdate=!0}if(qt(r.x)&&qt(r.y)&&qt(r.z))this._targetVelocity.set(0,0,0),this._target.copy(this._targetEnd);else{let h=this._isUserControllingTruck?this.draggingSmoothTime:this.smoothTime;Ev(this._target,this._targetEnd,this._targetVelocity,h,this.maxSpeed,e,this._target),this._needsUpdate=!0}if(qt(o.x)&&qt(o.y)&&qt(o.z))this._focalOffsetVelocity.set(0,0,0),this._focalOffset.copy(this._focalOffsetEnd);else{let h=this._isUserControllingOffset?this.draggingSmoothTime:this.smoothTime;Ev(this._focalOffset,this._focalOffsetEnd,this._focalOffsetVelocity,h,this.maxSpeed,e,this._focalOffset),this._needsUpdate=!0}if(qt(a))this._zoomVelocity.value=0,this._zoom=this._zoomEnd;else{let h=this._isUserControllingZoom?this.draggingSmoothTime:this.smoothTime;this._zoom=Xd(this._zoom,this._zoomEnd,this._zoomVelocity,h,1/0,e)}if(this.dollyToCursor){if(ao(this._camera)&&this._changedDolly!==0){let h=this._spherical.radius-this._lastDistance,d=this._camera,f=this._getCameraDirection(bc),g=nt.copy(f).cross(d.up).normalize();g.lengthSq()===0&&(g.x=1);let x=wt.crossVectors(g,f),m=this._sphericalEnd.radius*Math.tan(d.getEffectiveFOV()*yc*.5),v=(this._sphericalEnd.radius-h-this._sphericalEnd.radius)/this._sphericalEnd.radius,M=Ia.copy(this._targetEnd).add(g.multiplyScalar(this._dollyControlCoord.x*m*d.aspect)).add(x.multiplyScalar(this._dollyControlCoord.y*m)),b=nt.copy(this._targetEnd).lerp(M,v),S=this._lastDollyDirection===Pa.IN&&this._spherical.radius<=this.minDistance,y=this._lastDollyDirection===Pa.OUT&&this.maxDistance<=this._spherical.radius;if(this.infinityDolly&&(S||y)){this._sphericalEnd.radius-=h,this._spherical.radius-=h;let w=wt.copy(f).multiplyScalar(-h);b.add(w)}this._boundary.clampPoint(b,b);let p=wt.subVectors(b,this._targetEnd);this._targetEnd.copy(b),this._target.add(p),this._changedDolly-=h,qt(this._changedDolly)&&(this._changedDolly=0)}else if(wr(this._camera)&&this._changedZoom!==0){let h=this._zoom-this._lastZoom,d=this._camera,f=nt.set(this._dollyControlCoord.x,this._dollyControlCoord.y,(d.near+d.far)/(d.near-d.far)).unproject(d),g=wt.set(0,0,-1).applyQuaternion(d.quaternion),x=Ia.copy(f).add(g.multiplyScalar(-f.dot(d.up))),_=-(this._zoom-h-this._zoom)/this._zoom,v=this._getCameraDirection(bc),M=this._targetEnd.dot(v),b=nt.copy(this._targetEnd).lerp(x,_),S=b.dot(v),y=v.multiplyScalar(S-M);b.sub(y),this._boundary.clampPoint(b,b);let p=wt.subVectors(b,this._targetEnd);this._targetEnd.copy(b),this._target.add(p),this._changedZoom-=h,qt(this._changedZoom)&&(this._changedZoom=0)}}this._camera.zoom!==this._zoom&&(this._camera.zoom=this._zoom,this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0),this._dragNeedsUpdate=!0;let l=this._collisionTest();this._spherical.radius=Math.min(this._spherical.radius,l),this._spherical.makeSafe(),this._camera.position.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(this._target),this._camera.lookAt(this._target),(!qt(this._focalOffset.x)||!qt(this._focalOffset.y)||!qt(this._focalOffset.z))&&(xs.setFromMatrixColumn(this._camera.matrix,0),vs.setFromMatrixColumn(this._camera.matrix,1),lo.setFromMatrixColumn(this._camera.matrix,2),xs.multiplyScalar(this._focalOffset.x),vs.multiplyScalar(-this._focalOffset.y),lo.multiplyScalar(this._focalOffset.z),nt.copy(xs).add(vs).add(lo),this._camera.position.add(nt),this._camera.updateMatrixWorld()),this._boundaryEnclosesCamera&&this._encloseToBoundary(this._camera.position.copy(this._target),nt.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse),1);let u=this._needsUpdate;return u&&!this._updatedLastTime?(this._hasRested=!1,this.dispatchEvent({type:"wake"}),this.dispatchEvent({type:"update"})):u?(this.dispatchEvent({type:"update"}),qt(t,this.restThreshold)&&qt(n,this.restThreshold)&&qt(s,this.restThreshold)&&qt(r.x,this.restThreshold)&&qt(r.y,this.restThreshold)&&qt(r.z,this.restThreshold)&&qt(o.x,this.restThreshold)&&qt(o.y,this.restThreshold)&&qt(o.z,this.restThreshold)&&qt(a,this.restThreshold)&&!this._hasRested&&(this._hasRested=!0,this.dispatchEvent({type:"rest"}))):!u&&this._updatedLastTime&&this.dispatchEvent({type:"sleep"}),this._lastDistance=this._spherical.radius,this._lastZoom=this._zoom,this._updatedLastTime=u,this._needsUpdate=!1,u}toJSON(){return JSON.stringify({enabled:this._enabled,minDistance:this.minDistance,maxDistance:xc(this.maxDistance),minZoom:this.minZoom,maxZoom:xc(this.maxZoom),minPolarAngle:this.minPolarAngle,maxPolarAngle:xc(this.maxPolarAngle),minAzimuthAngle:xc(this.minAzimuthAngle),maxAzimuthAngle:xc(this.maxAzimuthAngle),smoothTime:this.smoothTime,draggingSmoothTime:this.draggingSmoothTime,dollySpeed:this.dollySpeed,truckSpeed:this.truckSpeed,dollyToCursor:this.dollyToCursor,target:this._targetEnd.toArray(),position:nt.setFromSpherical(this._sphericalEnd).add(this._targetEnd).toArray(),zoom:this._zoomEnd,focalOffset:this._focalOffsetEnd.toArray(),target0:this._target0.toArray(),position0:this._position0.toArray(),zoom0:this._zoom0,focalOffset0:this._focalOffset0.toArray()})}fromJSON(e,t=!1){let n=JSON.parse(e);this.enabled=n.enabled,this.minDistance=n.minDistance,this.maxDistance=vc(n.maxDistance),this.minZoom=n.minZoom,this.maxZoom=vc(n.maxZoom),this.minPolarAngle=n.minPolarAngle,this.maxPolarAngle=vc(n.maxPolarAngle),this.minAzimuthAngle=vc(n.minAzimuthAngle),this.maxAzimuthAngle=vc(n.maxAzimuthAngle),this.smoothTime=n.smoothTime,this.draggingSmoothTime=n.draggingSmoothTime,this.dollySpeed=n.dollySpeed,this.truckSpeed=n.truckSpeed,this.dollyToCursor=n.dollyToCursor,this._target0.fromArray(n.target0),this._position0.fromArray(n.position0),this._zoom0=n.zoom0,this._focalOffset0.fromArray(n.focalOffset0),this.moveTo(n.target[0],n.target[1],n.target[2],t),_i.setFromVector3(nt.fromArray(n.position).sub(this._targetEnd).applyQuaternion(this._yAxisUpSpace)),this.rotateTo(_i.theta,_i.phi,t),this.dollyTo(_i.radius,t),this.zoomTo(n.zoom,t),this.setFocalOffset(n.focalOffset[0],n.focalOffset[1],n.focalOffset[2],t),this._needsUpdate=!0}connect(e){if(this._domElement){console.warn("camera-controls is already connected.");return}e.setAttribute("data-camera-controls-version",fC),this._addAllEventListeners(e),this._getClientRect(this._elementRect)}disconnect(){this.cancel(),this._removeAllEventListeners(),this._domElement&&(this._domElement.removeAttribute("data-camera-controls-version"),this._domElement=void 0)}dispose(){this.removeAllEventListeners(),this.disconnect()}_getTargetDirection(e){return e.setFromSpherical(this._spherical).divideScalar(this._spherical.radius).applyQuaternion(this._yAxisUpSpaceInverse)}_getCameraDirection(e){return this._getTargetDirection(e).negate()}_findPointerById(e){return this._activePointers.find(t=>t.pointerId===e)}_findPointerByMouseButton(e){return this._activePointers.find(t=>t.mouseButton===e)}_disposePointer(e){this._activePointers.splice(this._activePointers.indexOf(e),1)}_encloseToBoundary(e,t,n){let s=t.lengthSq();if(s===0)return e;let r=wt.copy(t).add(e),a=this._boundary.clampPoint(r,Ia).sub(r),l=a.lengthSq();if(l===0)return e.add(t);if(l===s)return e;if(n===0)return e.add(t).add(a);{let c=1+n*l/t.dot(a);return e.add(wt.copy(t).multiplyScalar(c)).add(a.multiplyScalar(1-n))}}_updateNearPlaneCorners(){if(ao(this._camera)){let e=this._camera,t=e.near,n=e.getEffectiveFOV()*yc,s=Math.tan(n*.5)*t,r=s*e.aspect;this._nearPlaneCorners[0].set(-r,-s,0),this._nearPlaneCorners[1].set(r,-s,0),this._nearPlaneCorners[2].set(r,s,0),this._nearPlaneCorners[3].set(-r,s,0)}else if(wr(this._camera)){let e=this._camera,t=1/e.zoom,n=e.left*t,s=e.right*t,r=e.top*t,o=e.bottom*t;this._nearPlaneCorners[0].set(n,r,0),this._nearPlaneCorners[1].set(s,r,0),this._nearPlaneCorners[2].set(s,o,0),this._nearPlaneCorners[3].set(n,o,0)}}_collisionTest(){let e=1/0;if(!(this.colliderMeshes.length>=1)||bg(this._camera,"_collisionTest"))return e;let n=this._getTargetDirection(bc);Tg.lookAt(Tv,n,this._camera.up);for(let s=0;s<4;s++){let r=wt.copy(this._nearPlaneCorners[s]);r.applyMatrix4(Tg);let o=Ia.addVectors(this._target,r);$d.set(o,n),$d.far=this._spherical.radius+1;let a=$d.intersectObjects(this.colliderMeshes);a.length!==0&&a[0].distance<e&&(e=a[0].distance)}return e}_getClientRect(e){if(!this._domElement)return;let t=this._domElement.getBoundingClientRect();return e.x=t.left,e.y=t.top,this._viewport?(e.x+=this._viewport.x,e.y+=t.height-this._viewport.w-this._viewport.y,e.width=this._viewport.z,e.height=this._viewport.w):(e.width=t.width,e.height=t.height),e}_createOnRestPromise(e){return e?Promise.resolve():(this._hasRested=!1,this.dispatchEvent({type:"transitionstart"}),new Promise(t=>{let n=()=>{this.removeEventListener("rest",n),t()};this.addEventListener("rest",n)}))}_addAllEventListeners(e){}_removeAllEventListeners(){}get dampingFactor(){return console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead."),0}set dampingFactor(e){console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead.")}get draggingDampingFactor(){return console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead."),0}set draggingDampingFactor(e){console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead.")}static createBoundingSphere(e,t=new Ke.Sphere){let n=t,s=n.center;Oa.makeEmpty(),e.traverseVisible(o=>{o.isMesh&&Oa.expandByObject(o)}),Oa.getCenter(s);let r=0;return e.traverseVisible(o=>{if(!o.isMesh)return;let a=o;if(!a.geometry)return;let l=a.geometry.clone();l.applyMatrix4(a.matrixWorld);let u=l.attributes.position;for(let h=0,d=u.count;h<d;h++)nt.fromBufferAttribute(u,h),r=Math.max(r,s.distanceToSquared(nt))}),n.radius=Math.sqrt(r),n}};var Rg=2e3,mC=[{toward:new P(-.75,.55,.38).normalize(),strength:1.2,width:.7},{toward:new P(.8,.42,-.35).normalize(),strength:.5,width:.8},{toward:new P(.1,1,-.15).normalize(),strength:.4,width:.8}];function gC(i){let e=i.y,t=e>0?.24+.14*e**.6:.24-.14*(-e)**.5,n=0;for(let{toward:s,strength:r,width:o}of mC){let a=i.dot(s);a>o&&(n+=r*((a-o)/(1-o))**.5)}return[t*(1-.05*e)+n,t+n*.99,t*(1+.09*e)+n*.96]}function Lv(){let i=new Kr,e=[],t=4*Math.PI/Rg;for(let n=0;n<Rg;n+=1){let s=1-(2*n+1)/Rg,r=Math.sqrt(1-s*s),o=n*Math.PI*(3-Math.sqrt(5)),a=new P(r*Math.cos(o),s,r*Math.sin(o)),l=new P(...gC(a));Kr.getBasisAt(a,e);for(let c=0;c<9;c+=1)i.coefficients[c].addScaledVector(l,e[c]*t)}return new kl(i)}var _C=`
varying vec2 at; uniform vec2 middle; uniform float size;
void main() {
  at = middle + position.xy * size * vec2(1.0, -1.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,yC=`
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
}`,Cg={polygonOffset:!0,polygonOffsetFactor:3,polygonOffsetUnits:4},Kd=class{mesh;step=1;constructor(){let e={middle:{value:[0,0]},size:{value:1},step1:{value:1},reach:{value:1},strength:{value:.5},ink:{value:new Ue("#5b6b73")}},t=new mn({uniforms:e,vertexShader:_C,fragmentShader:yC,transparent:!0,depthWrite:!1,side:un,...Cg});this.mesh=new Pt(new ss(1,1),t),this.mesh.rotation.x=-Math.PI/2,this.mesh.renderOrder=-2,this.mesh.frustumCulled=!1}place(e,t,n){let{uniforms:s}=this.mesh.material,r=t*4.5;this.step=10**Math.floor(Math.log10(t/2.5));let o=this.step*10,[a,l]=[Math.round(e.x/o)*o,Math.round(e.z/o)*o];this.mesh.position.set(a,n-.004*t,l),this.mesh.scale.setScalar(2*r),Object.assign(s.middle,{value:[0,0]}),s.size.value=2*r,s.step1.value=this.step,s.reach.value=r}style(e,t){this.mesh.material.uniforms.ink.value.set(e),this.mesh.material.uniforms.strength.value=t}};var Da=256,xC=1.5,vC=`
varying float height; uniform float ground, reach;
void main() { vec4 at = modelMatrix * vec4(position, 1.0); height = (at.y - ground) / reach; gl_Position = projectionMatrix * viewMatrix * at; }`,bC=`
varying float height;
void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, 0.75 * pow(1.0 - clamp(height, 0.0, 1.0), 1.4)); }`,SC="varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }",wC=`
varying vec2 at; uniform sampler2D picture; uniform vec2 step;
void main() {
  float sum = 0.0, weight = 0.0;
  for (float i = -8.0; i <= 8.0; i += 1.0) {
    float w = exp(-0.5 * i * i / 16.0);
    sum += w * texture2D(picture, at + i * step).a; weight += w;
  }
  gl_FragColor = vec4(0.0, 0.0, 0.0, sum / weight);
}`,Jd=class{plane;targets=[new Vn(Da,Da),new Vn(Da,Da)];camera=new qs(-1,1,1,-1,0,1);dark=new mn({vertexShader:vC,fragmentShader:bC,side:un,blending:as,uniforms:{ground:{value:0},reach:{value:1}}});blur=new mn({vertexShader:SC,fragmentShader:wC,depthTest:!1,depthWrite:!1,blending:as,uniforms:{picture:{value:null},step:{value:[0,0]}}});page=new Pt(new ss(1,1),this.blur);constructor(){let e=new Ti({map:this.targets[0].texture,transparent:!0,depthWrite:!1,opacity:.5,toneMapped:!1,...Cg});this.plane=new Pt(new ss(1,1),e),this.plane.rotation.x=-Math.PI/2,this.plane.renderOrder=-1,this.page.frustumCulled=!1}update(e,t,n,s,r){let o=[],a=!1;if(n.traverse(S=>{S.userData.castsShadow?a||=S.visible:("isMesh"in S||"isLine"in S||"isPoints"in S)&&o.push(S)}),this.plane.visible=a,!a)return;let[l,c]=[s.max.x-s.min.x,s.max.z-s.min.z],u=Math.max(l,c)*xC||1,h=Math.max(s.max.y-s.min.y,.35*u),[d,f]=[(s.min.x+s.max.x)/2,(s.min.z+s.max.z)/2],g=s.min.y;this.plane.position.set(d,g-.002*u,f),this.plane.scale.setScalar(u);let{camera:x,dark:m,targets:_}=this;Object.assign(x,{left:-u/2,right:u/2,top:u/2,bottom:-u/2,near:0,far:2*h+.1*u}),x.position.set(d,g+2*h,f),x.up.set(0,0,-1),x.lookAt(d,g,f),x.updateProjectionMatrix(),m.uniforms.ground.value=g,m.uniforms.reach.value=h;let v=[...r,this.plane,...o].map(S=>[S,S.visible]);v.forEach(([S])=>{S.visible=!1});let M=e.getRenderTarget(),b=t.background;t.background=null,t.overrideMaterial=m,e.setRenderTarget(_[0]),e.setScissorTest(!1),e.clear(),e.render(t,x),t.overrideMaterial=null,t.background=b,v.forEach(([S,y])=>{S.visible=y}),this.smear(e,_[0],_[1],[1.1/Da,0]),this.smear(e,_[1],_[0],[0,1.1/Da]),e.setRenderTarget(M)}smear(e,t,n,s){this.blur.uniforms.picture.value=t.texture,this.blur.uniforms.step.value=s,e.setRenderTarget(n),e.clear(),e.render(this.page,this.camera)}style(e){this.plane.material.opacity=e}};Na.install({THREE:{Box3:tt,Matrix4:Ce,Quaternion:Jn,Raycaster:fr,Sphere:Vt,Spherical:Vl,Vector2:ke,Vector3:P,Vector4:ct}});var Ig=30,MC=2,jd=class{constructor(e,t){this.canvas=e;this.insets=t;this.renderer=TC(e),this.shadow=new Jd,this.scene.add(this.model,this.grid.mesh,this.shadow.plane);let n=new $r(16775406,1.8);n.position.set(-3.4,2.2,.6),this.scene.add(n,Lv()),this.controls=new Na(this.camera,e),Object.assign(this.controls,{smoothTime:.12,draggingSmoothTime:.05,minPolarAngle:.001,maxPolarAngle:Math.PI-.001,dollyToCursor:!0});let{ACTION:s}=Na;Object.assign(this.controls.mouseButtons,{left:s.ROTATE,right:s.TRUCK,middle:s.TRUCK,wheel:s.NONE});for(let r of["controlstart","control","transitionstart"])this.controls.addEventListener(r,()=>this.wake());this.controls.addEventListener("rest",()=>this.onRest()),e.addEventListener("wheel",r=>this.onWheel(r),{passive:!1}),e.addEventListener("webglcontextlost",r=>r.preventDefault()),e.addEventListener("webglcontextrestored",()=>this.invalidate()),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}canvas;insets;renderer;scene=new xl;camera=new dn(Ig,1,.1,1e3);controls;model=new Sn;grid=new Kd;shadow;beforeDraw=()=>{};onDraw=()=>{};onRest=()=>{};content=()=>[];tiles=null;width=1;height=1;frames=0;dirty=!0;running=!1;last=0;sphere=new Vt(new P,5);wasInside=!0;invalidate(){this.dirty=!0,this.wake()}wake(){this.running||(this.running=!0,this.last=performance.now(),requestAnimationFrame(e=>this.tick(e)))}tick(e){let t=Math.min(Math.max(e-this.last,1)/1e3,.1);this.last=e;let n=this.controls.update(t);(n||this.dirty)&&this.draw(),n||this.dirty?requestAnimationFrame(s=>this.tick(s)):this.running=!1}draw(){this.dirty=!1,this.frames+=1;let{renderer:e,camera:t}=this,n=t.position.distanceTo(this.sphere.center);t.near=Math.max(n-4*this.sphere.radius,n*.004),t.far=n+40*this.sphere.radius,t.updateProjectionMatrix(),t.updateMatrixWorld(),this.beforeDraw(),e&&(this.tiles?this.drawTiles(e,this.tiles):(e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.render(this.scene,t))),this.onDraw()}drawTiles(e,t){let n=this.canvas.getBoundingClientRect();e.setScissorTest(!1),e.clear(),e.setScissorTest(!0);let s=[this.model,this.grid.mesh,this.shadow.plane].map(r=>[r,r.visible]);s.forEach(([r])=>{r.visible=!1});for(let{element:r,group:o}of t){let a=r.getBoundingClientRect(),l=Math.max(a.top,n.top),c=Math.min(a.bottom,n.bottom);c<=l||a.width<1||(e.setViewport(a.left-n.left,n.bottom-a.bottom,a.width,a.height),e.setScissor(a.left-n.left,n.bottom-c,a.width,c-l),this.camera.aspect=a.width/a.height,this.camera.fov=Pg(this.camera.aspect),this.camera.updateProjectionMatrix(),this.scene.add(o),e.render(this.scene,this.camera),this.scene.remove(o))}s.forEach(([r,o])=>{r.visible=o}),e.setScissorTest(!1),this.shape()}async picture(e,t){let{renderer:n}=this;if(!n)throw new Error("there is no picture without WebGL 2");let s=n.getPixelRatio();n.setPixelRatio(e),n.setSize(this.width,this.height,!1),this.scene.background=t===null?null:new Ue(t),this.draw();let r=await new Promise(o=>{this.canvas.toBlob(o,"image/png")});if(this.scene.background=null,n.setPixelRatio(s),n.setSize(this.width,this.height,!1),this.draw(),!r)throw new Error("the browser makes no picture of this size");return r}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.width=e,this.height=t,this.renderer&&(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,MC)),this.renderer.setSize(e,t,!1)),this.shape(),this.wasInside&&!this.allInside()&&this.fit(!1),this.draw())}shape(){this.camera.aspect=this.width/this.height,this.camera.fov=Pg(this.camera.aspect),this.camera.updateProjectionMatrix()}measure(){let e=this.content(),t=new tt;e.forEach(n=>t.expandByPoint(new P(...n))),t.isEmpty()&&t.set(new P(-5,0,-5),new P(5,0,5)),t.getBoundingSphere(this.sphere),this.sphere.radius===0&&(this.sphere.radius=1),this.grid.place(this.sphere.center,this.sphere.radius,t.min.y),this.renderer&&this.shadow.update(this.renderer,this.scene,this.model,t,[this.grid.mesh]),this.invalidate()}get isAtRest(){return!this.running}get radius(){return this.sphere.radius}get centre(){return this.sphere.center}fit(e,t){let n=this.content(),s=t?new P(...t):this.camera.position.clone().sub(this.controls.getTarget(new P));s.lengthSq()===0&&s.set(.6,.55,.8),s.normalize();let r=new P(0,1,0).cross(s);r.lengthSq()<1e-9&&r.set(1,0,0),r.normalize();let o=s.clone().cross(r),a=n.length>0?n.map(T=>new P(...T).sub(this.sphere.center)):EC(this.sphere.radius),{top:l,right:c,bottom:u,left:h}=this.insets(),f=2*Math.tan(Pg(this.width/this.height)*Math.PI/360)/this.height,g=Math.max(this.width-h-c,this.width/4)*f/2,x=Math.max(this.height-l-u,this.height/4)*f/2,m=a.map(T=>T.dot(r)),_=a.map(T=>T.dot(o)),v=a.map(T=>T.dot(s)),M=this.sphere.radius,b=0,S=0;for(let T=0;T<6;T+=1){M=0;for(let I=0;I<a.length;I+=1){let D=Math.max(Math.abs(m[I]-b)/g,Math.abs(_[I]-S)/x);M=Math.max(M,v[I]+D,v[I]+.02*this.sphere.radius)}let[E,C,O,U]=[1/0,-1/0,1/0,-1/0];for(let I=0;I<a.length;I+=1){let D=M-v[I];E=Math.min(E,(m[I]-b)/D),C=Math.max(C,(m[I]-b)/D),O=Math.min(O,(_[I]-S)/D),U=Math.max(U,(_[I]-S)/D)}b+=(E+C)/2*M,S+=(O+U)/2*M}M*=1.02;let y=(c-h)/2*f*M,p=(l-u)/2*f*M,w=this.sphere.center.clone().addScaledVector(r,b+y).addScaledVector(o,S+p);this.place({eye:w.clone().addScaledVector(s,M).toArray(),target:w.toArray()},e)}pose(){return{eye:this.controls.getPosition(new P).toArray(),target:this.controls.getTarget(new P).toArray()}}place({eye:e,target:t},n){let s=!n||matchMedia("(prefers-reduced-motion: reduce)").matches;this.controls.setLookAt(...e,...t,!s),s&&this.controls.update(0),this.invalidate()}look(e){this.fit(!0,e)}orbit(e,t){this.controls.rotate(e,t,!0),this.wake()}pan(e,t){let n=this.pixelAt(this.controls.getTarget(new P));this.controls.truck(-e*n,-t*n,!0),this.wake()}onWheel(e){e.preventDefault();let t=e.deltaMode===1?16:1,{x:n,y:s}=this.local(e);this.zoom(n,s,Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0016))))}zoom(e,t,n){let s=this.controls.getTarget(new P),r=this.controls.getPosition(new P),o=r.distanceTo(s)*n;if(o<this.sphere.radius*.001||o>this.sphere.radius*60)return;let a=this.ray(e,t),l=this.under(e,t),c;if(l)c=l;else{let u=s.clone().sub(r).normalize(),h=a.direction.dot(u);c=a.origin.clone().addScaledVector(a.direction,s.clone().sub(a.origin).dot(u)/h)}r.sub(c).multiplyScalar(n).add(c),s.sub(c).multiplyScalar(n).add(c),this.place({eye:r.toArray(),target:s.toArray()},!1),this.onRest()}under=()=>null;local(e){let t=this.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}project(e){let t=new P(...e).project(this.camera);return{x:(t.x+1)/2*this.width,y:(1-t.y)/2*this.height,visible:t.z<1}}ray(e,t){let n=new fr;return n.setFromCamera(new ke(e/this.width*2-1,1-t/this.height*2),this.camera),n.ray}pixelAt(e){let t=this.camera.getWorldDirection(new P),n=e.clone().sub(this.camera.position).dot(t);return 2*Math.max(n,1e-9)*Math.tan(this.camera.fov*Math.PI/360)/this.height}onPlane(e,t,n,s){let{origin:r,direction:o}=this.ray(e,t),a=o.dot(s);if(Math.abs(a)<1e-6)return null;let l=n.clone().sub(r).dot(s)/a;return l<=0||l>60*this.sphere.radius+r.distanceTo(n)?null:r.clone().addScaledVector(o,l)}allInside(){return this.content().every(e=>{let{x:t,y:n,visible:s}=this.project(e);return s&&t>=0&&n>=0&&t<=this.width&&n<=this.height})}rememberWhetherAllIsSeen(){this.camera.updateMatrixWorld(),this.wasInside=this.allInside()}},Pg=i=>i>=1?Ig:Math.atan(Math.tan(Ig*Math.PI/360)/i)*360/Math.PI,EC=i=>[-1,1].flatMap(e=>[-1,1].map(t=>new P(e*i*.7,0,t*i*.7)));function TC(i){let e=i.getContext("webgl2",{antialias:!0,alpha:!0,powerPreference:"high-performance"});if(!e)return null;let t=new nd({canvas:i,context:e,antialias:!0,alpha:!0});return t.setClearColor(0,0),t.toneMapping=Gl,t.toneMappingExposure=1,t.debug.checkShaderErrors=!1,t}var Xi={point:11,touch:24,edge:8,snap:12,align:7},Lg=4,AC=46,Zd=class{constructor(e){this.host=e;let{canvas:t}=e.stage;this.marquee=document.createElement("div"),this.marquee.className="marquee",this.marquee.hidden=!0,t.parentElement.append(this.marquee),t.addEventListener("pointerdown",n=>this.press(n),{capture:!0}),t.addEventListener("pointermove",n=>this.glide(n)),t.addEventListener("pointerleave",()=>{this.busy||(this.hover=null,this.ghost=null,this.next=null,(this.drawing||this.cabling)&&e.label(null),this.refresh())}),t.addEventListener("contextmenu",n=>n.preventDefault()),t.addEventListener("keydown",n=>this.key(n)),e.stage.beforeDraw=()=>this.hints()}host;selection=[];mode="ground";snapping=!0;level=0;next=null;hover=null;ghost=null;busy=!1;cabling=!1;cable=-1;cableFrom=null;marquee;get mayCable(){return this.host.history.document.kind==="tensile_structure"&&!this.host.fixed}get drawing(){return this.host.history.document.draft!==null}get only(){return this.selection.length===1?this.selection[0]:null}select(e){this.selection=e,e.length>0&&(this.cable=-1),this.refresh(),this.host.selectionChanged();let{only:t}=this,n=t&&this.host.lines[t.line];n&&this.host.announce(`${n.name}, point ${t.point+1} of ${n.points.length}: ${(Dt(n.points[t.point])??[]).map(s=>vt(s,6)).join(", ")}`)}prune(){let{lines:e}=this.host;this.mayCable||this.stopCabling(),this.cable>=this.cables&&(this.cable=-1),this.cableFrom=null,this.selection=this.selection.filter(({line:t,point:n})=>n<(e[t]?.points.length??0)),this.hover=null,this.ghost=null}refresh(){let{sketch:e,stage:t,faulty:n}=this.host;e.mark(s=>s.line<0?4:Gi(this.cableFrom,s)||this.selection.some(r=>Gi(r,s))?2:n.has(`${s.line}/${s.point}`)?3:Gi(this.hover,s)?1:0),t.invalidate()}step(e){let{lines:t}=this.host,n=t.flatMap((r,o)=>r.points.map((a,l)=>({line:o,point:l})).filter(({point:a})=>el(r,a)));if(n.length===0)return;let s=n.findIndex(r=>Gi(r,this.selection.at(-1)??null));this.select([n[s<0?e>0?0:n.length-1:(s+e+n.length)%n.length]])}nearestPoint(e,t,n){let{stage:s,sketch:r,surface:o}=this.host,a=null;if(r.places.forEach((f,g)=>{if(r.refs[g].line<0)return;let x=s.project(f),m=Math.hypot(x.x-e,x.y-t);x.visible&&m<=n&&(!a||m<a.distance)&&(a={ref:r.refs[g],distance:m,place:f})}),!a)return null;let{ref:l,place:c}=a;if(this.selection.some(f=>Gi(f,l)))return l;let u=new P(...c),h=o.pick(s,s.project(c).x,s.project(c).y);return h&&h.distance<s.camera.position.distanceTo(u)-14*s.pixelAt(u)?null:l}nearestEdge(e,t,n=!1){let{stage:s,lines:r,frame:o}=this.host,a=null;return r.forEach((l,c)=>{if(Nr(l)||l.name.startsWith("control"))return;let u=l.points.map(Dt),h=l.closed&&u.length>2?u.length:u.length-1;for(let d=0;d<h;d+=1){let f=u[d],g=u[(d+1)%u.length];if(!f||!g)continue;let x=s.project(o.toScene(f)),m=s.project(o.toScene(g)),_=(m.x-x.x)**2+(m.y-x.y)**2;if(!x.visible||!m.visible||_<(n?1:900))continue;let v=((e-x.x)*(m.x-x.x)+(t-x.y)*(m.y-x.y))/_,M=n?Math.min(.9,Math.max(.1,v)):v,b=Math.hypot(x.x+M*(m.x-x.x)-e,x.y+M*(m.y-x.y)-t);if(M<.08||M>.92||b>Xi.edge||a&&b>=a.distance)continue;let S=this.alongEdge(f,g,e,t);a={line:c,after:d,distance:b,point:f.map((y,p)=>y+S*(g[p]-y))}}}),a}alongEdge(e,t,n,s){let{stage:r,frame:o}=this.host,a=new P(...o.toScene(e)),l=new P(...o.toScene(t)).sub(a),{origin:c,direction:u}=r.ray(n,s),h=a.clone().sub(c),d=l.dot(l),f=l.dot(u),g=l.dot(h),x=u.dot(h),m=d-f*f;return m>1e-12*d?Math.min(.98,Math.max(.02,(f*x-g)/m)):.5}arrow(){let{only:e}=this,{stage:t,frame:n,lines:s}=this.host,r=e&&Dt(s[e.line]?.points[e.point]);if(!r||this.drawing||this.cabling)return null;let o=new P(...n.toScene(r)),a=AC*t.pixelAt(o);return{from:o,to:o.clone().addScaledVector(this.liftAxis(),a)}}liftAxis(){let{camera:e}=this.host.stage,t=e.getWorldDirection(new P);return Math.abs(t.y)>.94?new P(0,1,0).applyQuaternion(e.quaternion):new P(0,1,0)}onArrow(e,t){let n=this.arrow();if(!n)return!1;let s=this.host.stage.project(n.from.toArray()),r=this.host.stage.project(n.to.toArray()),o=Math.hypot(r.x-s.x,r.y-s.y);if(o<12)return!1;let a=((e-s.x)*(r.x-s.x)+(t-s.y)*(r.y-s.y))/(o*o),l=Math.abs((e-s.x)*(r.y-s.y)-(t-s.y)*(r.x-s.x))/o;return a>.4&&a<1.2&&l<8}glide(e){if(this.busy||e.buttons!==0||this.host.fixed)return;let{stage:t,host:n}={stage:this.host.stage,host:this.host},{x:s,y:r}=t.local(e);if(this.drawing){this.next=this.snap(s,r,e.altKey),this.showNext(s,r),t.canvas.style.cursor="crosshair",t.invalidate();return}if(this.cabling){this.hover=this.nearestPoint(s,r,Xi.point),this.ghost=this.hover?null:this.nearestEdge(s,r,!0),t.canvas.style.cursor=this.hover||this.ghost?"pointer":"",this.refresh();return}let o=this.onArrow(s,r),a=o?null:this.nearestPoint(s,r,Xi.point),l=o||a?null:this.nearestEdge(s,r),c=!Gi(a,this.hover)||JSON.stringify(l)!==JSON.stringify(this.ghost);this.hover=a,this.ghost=l,t.canvas.style.cursor=o?"ns-resize":a?"grab":l?"copy":"",c&&(this.refresh(),n.selectionChanged())}press(e){let{stage:t,host:n}={stage:this.host.stage,host:this.host};if(t.canvas.focus({preventScroll:!0}),e.button!==0||this.busy||this.host.fixed)return;let s=t.local(e),r=e.pointerType==="touch";if(this.drawing){this.onRelease(e,(l,c,u,h)=>{u<=Lg&&this.place(this.snap(l,c,h.altKey))});return}if(this.cabling){this.onRelease(e,(l,c,u)=>{u<=Lg&&this.clickCable(l,c,r)});return}if(this.onArrow(s.x,s.y)){this.drag(e,this.only,"height");return}let o=this.nearestPoint(s.x,s.y,r?Xi.touch:Xi.point);if(o){this.drag(e,o,this.mode);return}let a=r?null:this.nearestEdge(s.x,s.y);if(a&&!e.shiftKey){n.history.begin(),this.insertAt(a.line,a.after,this.tidy(a.point)),n.changed(!0),this.drag(e,{line:a.line,point:a.after+1},this.mode);return}if(e.shiftKey){this.selectBox(e);return}this.onRelease(e,(l,c,u)=>{if(u>Lg)return;let h=n.surface.pickLine(t,l,c),d=n.surface.pick(t,l,c),f=t.camera.position,g=h&&d&&d.distance<.98*f.distanceTo(h.point);h&&!g?n.readLine(h.point,h.value,l,c):d?n.read(d.point,d.face,l,c):(n.label(null),this.selection.length>0&&this.select([]))})}onRelease(e,t){let{stage:n}=this.host,s=n.local(e),r=0,o=l=>{let{x:c,y:u}=n.local(l);r=Math.max(r,Math.hypot(c-s.x,u-s.y))},a=l=>{if(l.pointerId!==e.pointerId)return;document.removeEventListener("pointermove",o),document.removeEventListener("pointerup",a),document.removeEventListener("pointercancel",a);let{x:c,y:u}=n.local(l);l.type==="pointerup"&&t(c,u,r,l)};document.addEventListener("pointermove",o),document.addEventListener("pointerup",a),document.addEventListener("pointercancel",a)}seize(e,t,n){let{stage:s}=this.host;this.busy=!0,s.controls.enabled=!1,e.preventDefault();try{s.canvas.setPointerCapture(e.pointerId)}catch{}let r=a=>{a.pointerId===e.pointerId&&t(a)},o=a=>{a.pointerId===e.pointerId&&(document.removeEventListener("pointermove",r),document.removeEventListener("pointerup",o),document.removeEventListener("pointercancel",o),this.busy=!1,s.controls.enabled=!0,n(a))};document.addEventListener("pointermove",r),document.addEventListener("pointerup",o),document.addEventListener("pointercancel",o)}drag(e,t,n){let{host:s}=this,{stage:r,history:o,frame:a}=s,l=s.lines[t.line].points[t.point],c=Dt(l);if(!c)return;let u=this.selection.some(_=>Gi(_,t));u||this.select(e.shiftKey?[...this.selection,t]:[t]);let h=this.selection.map(_=>({ref:_,from:Dt(s.lines[_.line].points[_.point])??c})),d=new P(...a.toScene(c)),f=r.project(d.toArray()),g=r.local(e),x={x:g.x-f.x,y:g.y-f.y},m=!1;o.begin(),this.seize(e,_=>{let{x:v,y:M}=r.local(_);if(!m&&Math.hypot(v-g.x,M-g.y)<2)return;m=!0;let b=n==="height"!==(_.shiftKey&&!e.shiftKey),S=b?this.raised(d,M-g.y):this.grounded(d,v-x.x,M-x.y);if(!S)return;let y=this.rounded(S,c);!b&&this.snapping&&!_.altKey&&(y=this.onto(v,M,h.map(T=>T.ref))??y);for(let{ref:T,from:E}of h)this.write(T,E.map((C,O)=>co(C+y[O]-c[O])));let p=r.project(a.toScene(y)),w=hi(o.document.request);s.label(b?`${"xyz"[a.up]} ${vt(y[a.up],6)} ${w}`:y.map((T,E)=>`${"xyz"[E]} ${vt(T,6)}`).join("  "),p.x,p.y),this.lifting=b,s.changed(!0)},_=>{this.lifting=!1,s.label(null),!m&&_.type==="pointerup"&&(e.shiftKey&&u?this.select(this.selection.filter(v=>!Gi(v,t))):e.shiftKey||this.select([t])),o.commit()&&s.changed(!1)})}lifting=!1;selectBox(e){let{stage:t,sketch:n}=this.host,s=t.local(e),r=this.selection,{style:o}=this.marquee;this.seize(e,a=>{let{x:l,y:c}=t.local(a),[u,h,d,f]=[Math.min(l,s.x),Math.min(c,s.y),Math.max(l,s.x),Math.max(c,s.y)];this.marquee.hidden=!1,Object.assign(o,{left:`${u}px`,top:`${h}px`,width:`${d-u}px`,height:`${f-h}px`});let g=n.refs.filter((x,m)=>{let _=t.project(n.places[m]);return x.line>=0&&_.visible&&_.x>=u&&_.x<=d&&_.y>=h&&_.y<=f});this.selection=[...r,...g.filter(x=>!r.some(m=>Gi(m,x)))],this.refresh()},()=>{this.marquee.hidden=!0,this.select(this.selection)})}grounded(e,t,n){let{stage:s}=this.host,r=s.camera.getWorldDirection(new P);return s.onPlane(t,n,e,Math.abs(r.y)>.08?new P(0,1,0):r)}raised(e,t){let{stage:n}=this.host,s=new P(0,1,0).applyQuaternion(n.camera.quaternion).y;return e.clone().add(new P(0,-t*n.pixelAt(e)/Math.max(s,.35),0))}rounded(e,t){let{stage:n,frame:s}=this.host,r=10**Math.floor(Math.log10(s.length(n.pixelAt(e))*1.5)),o=s.fromScene(e.toArray()),a=1e-9*s.length(n.radius)+1e-12*Math.max(...t.map(Math.abs));return o.map((l,c)=>Math.abs(l-t[c])<=a?t[c]:co(Math.round(l/r)*r))}tidy(e){let{frame:t}=this.host;return this.rounded(new P(...t.toScene(e)),[NaN,NaN,NaN])}onto(e,t,n){let{stage:s,sketch:r,lines:o}=this.host,a=r.refs.findIndex((c,u)=>{if(c.line<0||n.some(d=>d.line===c.line))return!1;let h=s.project(r.places[u]);return h.visible&&Math.hypot(h.x-e,h.y-t)<Xi.snap}),l=r.refs[a];return l?Dt(o[l.line].points[l.point]):null}get cables(){return this.host.history.document.request.cables?.length??0}startCabling(){this.mayCable&&(this.stopDrawing(),this.cabling=!0,this.select([]),this.host.selectionChanged())}stopCabling(){this.cabling&&(this.cabling=!1,this.cableFrom=null,this.ghost=null,this.host.label(null),this.host.stage.canvas.style.cursor="",this.host.selectionChanged())}chooseCable(e){this.selection=[],this.cable=e,this.refresh(),this.host.selectionChanged(),e>=0&&this.host.announce(`Cable ${e+1} of ${this.cables}`)}clickCable(e,t,n){let s=this.nearestPoint(e,t,n?Xi.touch:Xi.point),r=s?null:this.nearestEdge(e,t,!0),o=this.cableFrom;if(s&&o&&o.line===s.line&&o.point!==s.point)this.makeCable(s.line,...this.ordered(o,s.point));else if(s)this.cableFrom=Gi(o,s)?null:s,this.refresh(),this.host.selectionChanged();else if(r){let a=fm(this.host.history.document.request,r.line,r.after);a>=0?this.chooseCable(a):this.makeCable(r.line,r.after,(r.after+1)%this.host.lines[r.line].points.length)}else this.cableFrom=null,this.chooseCable(-1)}ordered({line:e,point:t},n){let s=this.host.lines[e].points.length;return(n-t+s)%s<=s/2?[t,n]:[n,t]}makeCable(e,t,n){let s=-1;this.cableFrom=null,this.host.history.edit(({request:o})=>{s=rx(o,e,t,n)})&&this.host.changed(!1),this.chooseCable(s)}cableFromPoint(){let{only:e}=this;if(!e||!this.mayCable)return;let t=fm(this.host.history.document.request,e.line,e.point);t>=0?this.chooseCable(t):this.makeCable(e.line,e.point,(e.point+1)%this.host.lines[e.line].points.length)}dropCable(){let{cable:e}=this;if(e<0)return;let t=this.host.history.edit(({request:n})=>ox(n,e));this.cable=-1,t&&this.host.changed(!1),this.host.selectionChanged()}cableHint(){let{lines:e,frame:t,history:n}=this.host,{cableFrom:s,hover:r,ghost:o}=this,a=e[r?.line??o?.line??-1];if(!a)return[];let l=d=>t.toScene(Dt(a.points[d])??[0,0,0]),c=d=>d.slice(1).flatMap((f,g)=>[l(d[g]),l(f)]);if(o)return c([o.after,(o.after+1)%a.points.length]);if(!s||s.line!==r.line||s.point===r.point)return[];let[u,h]=this.ordered(s,r.point);return c(mr(n.document.request,{boundary:s.line,from:u,to:h}))}write({line:e,point:t},n){let{points:s}=this.host.lines[e],r=s[t];Array.isArray(r)?r.splice(0,Math.max(3,r.length),...n):s[t]=n}moveBy(e){let{history:t}=this.host;t.edit(()=>{for(let s of this.selection){let r=Dt(this.host.lines[s.line].points[s.point]);r&&this.write(s,r.map((o,a)=>co(o+e[a])))}})&&this.host.changed(!1)}setAxis(e,t){this.host.history.edit(()=>{for(let s of this.selection){let r=Dt(this.host.lines[s.line].points[s.point])??[0,0,0];r[e]=t,this.write(s,r)}})&&this.host.changed(!1)}edgeBefore(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t||Nr(t)||t.points.length<2)return null;let n=e.point>0?e.point-1:t.closed?t.points.length-1:-1,s=Dt(t.points[e.point]),r=Dt(t.points[n]);return s&&r?{length:Math.hypot(...s.map((o,a)=>o-r[a])),previous:r,point:s}:null}setEdgeBefore(e){let t=this.edgeBefore(),{only:n}=this;if(!t||!n||!(e>0)||t.length===0)return;let s=t.previous.map((r,o)=>co(r+(t.point[o]-r)*e/t.length));this.host.history.edit(()=>this.write(n,s))&&this.host.changed(!1)}companions(e){let{request:t}=this.host.history.document,{points:n,path:s}=this.host.lines[e];return s[0]!=="directrices"?[]:["normals","tangents"].flatMap(r=>{let o=t[r]?.[s[1]];return Array.isArray(o)&&o.length===n.length?[o]:[]})}insertAt(e,t,n){this.companions(e).forEach(s=>s.splice(t+1,0,structuredClone(s[t]))),this.mayCable&&ax(this.host.history.document.request,e,t),this.host.lines[e].points.splice(t+1,0,n),this.selection=[{line:e,point:t+1}]}insert(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t||t.only)return;let n=Dt(t.points[e.point]),s=Dt(t.points[e.point+1])??(t.closed?Dt(t.points[0]):null);if(!n)return;let r=Dt(t.points[e.point-1])??n.map((a,l)=>a-(l===0?1:0)),o=n.map((a,l)=>co(s?(a+s[l])/2:2*a-r[l]));this.host.history.edit(()=>this.insertAt(e.line,e.point,o))&&this.host.changed(!1),this.select(this.selection)}remove(){let{host:e}=this;if(this.selection.length===0||this.selection.some(s=>e.lines[s.line]?.only))return;let[t]=this.selection;e.history.edit(()=>{let s=[...this.selection].sort((r,o)=>o.line-r.line||o.point-r.point);for(let{line:r,point:o}of s)this.companions(r).forEach(a=>a.splice(o,1)),e.lines[r].points.splice(o,1),this.mayCable&&lx(e.history.document.request,r,o,e.lines[r].points.length);for(let r=e.lines.length-1;r>=0;r-=1)e.lines[r].points.length===0&&this.dropLine(r)}),this.selection=[],e.changed(!1);let n=e.lines[t.line]?.points.length??0;this.select(n>0&&n>1?[{line:t.line,point:Math.min(t.point,n-1)}]:[])}removeLine(){let{host:e}=this,t=[...new Set(this.selection.map(n=>n.line))].sort((n,s)=>s-n);t.length===0||t.some(n=>e.lines[n]?.only)||(e.history.edit(()=>t.forEach(n=>this.dropLine(n))),this.selection=[],e.changed(!1),this.select([]))}dropLine(e){let{request:t}=this.host.history.document,{path:n}=this.host.lines[e],s=au(t,n.slice(0,-1)),r=n.at(-1);if(Array.isArray(s)?s.splice(Number(r),1):delete s[r],this.mayCable&&cx(t,e),n[0]==="directrices")for(let o of["normals","tangents"])Array.isArray(t[o])&&t[o].splice(Number(r),1)}startDrawing(){let{history:e,stage:t,lines:n,frame:s}=this.host;if(this.drawing||Rt[e.document.kind].lines.length===0)return;this.stopCabling(),e.edit(a=>{a.draft=[]}),this.select([]);let r=n.flatMap(a=>a.points.map(l=>Dt(l)?.[s.up]??1/0));this.level=r.length>0?Math.min(...r):s.origin[s.up],this.next=null;let o=t.camera.getWorldDirection(new P);Math.abs(o.y)<.3&&t.look([.25,1.2,.6]),this.host.changed(!1),t.canvas.focus({preventScroll:!0})}stopDrawing(){this.drawing&&(this.host.history.edit(e=>{e.draft=null}),this.next=null,this.host.label(null),this.host.stage.canvas.style.cursor="",this.host.changed(!1))}get least(){return Rt[this.host.history.document.kind].least}place(e){if(e){if(e.close){this.finishDrawing();return}this.host.history.edit(t=>{t.draft.push(e.point)}),this.host.changed(!1)}}finishDrawing(){let{host:e}=this,{history:t}=e,n=t.document.draft;return!n||n.length<this.least?!1:(t.edit(s=>{let{kind:r,request:o}=s,{lines:a}=Rt[r];if(s.draft=null,r==="uniform_mesh"){let l=o.domain??={};!l.polygon&&!l.boundaries&&!l.bezier&&!l.nurbs?l.polygon=n:(l.polygon?l.holes??=[]:l.boundaries??=[]).push(n)}else(o[a[0]]??=[]).push(n)}),this.next=null,e.label(null),e.stage.canvas.style.cursor="",e.changed(!1),!0)}enter(e){let t=this.host.history.document.draft;if(!t)return null;let n=t.at(-1)??null,s=e.replace(/^@/,"").trim().split(/[\s,;]+/).map(Number);if(s.length>3||s.some(u=>!Number.isFinite(u))||e.trim()==="")return"Type a length, or x, y, z.";let{up:r}=this.host.frame,[o,a]=r===2?[0,1]:[0,2];if(s.length===1){if(!n)return"The first point needs x, y, z.";let u=this.next?.point??null,h=u?u.map((f,g)=>f-n[g]):[1,0,0],d=Math.hypot(...h);return d===0?"Point into a direction first.":(this.place({point:n.map((f,g)=>co(f+h[g]/d*s[0])),how:"",close:!1}),null)}let l=[0,0,0],c=e.trim().startsWith("@")?n??[0,0,0]:[0,0,0];return l[o]=c[o]+s[0],l[a]=c[a]+s[1],l[r]=s.length===3?c[r]+s[2]:e.trim().startsWith("@")?c[r]:this.level,r===1&&s.length===3&&l.splice(0,3,...c.map((u,h)=>u+s[h])),this.place({point:l,how:"",close:!1}),null}snap(e,t,n){let{stage:s,sketch:r,lines:o,frame:a,history:l}=this.host,c=l.document.draft??[],u=c.length>=this.least&&Rt[l.document.kind].line!=="rail"?c[0]:null;if(u){let M=s.project(a.toScene(u));if(Math.hypot(M.x-e,M.y-t)<Xi.snap)return{point:u,how:"closes the loop",close:!0}}if(!n&&this.snapping){let M=r.refs.findIndex((y,p)=>{let w=s.project(r.places[p]);return y.line>=0&&w.visible&&Math.hypot(w.x-e,w.y-t)<Xi.snap}),b=r.refs[M],S=b&&Dt(o[b.line].points[b.point]);if(S)return{point:S,how:"on a point",close:!1}}let h=[...a.origin];h[a.up]=this.level;let d=s.onPlane(e,t,new P(...a.toScene(h)),new P(0,1,0));if(!d)return null;let f=a.fromScene(d.toArray());f[a.up]=this.level;let g=a.length(s.pixelAt(d)),x=a.up===2?[0,1]:[0,2],m=10**Math.floor(Math.log10(g*1.5)),_=[1,2,5,10,20,50].map(M=>M*m).find(M=>M>=9*g)??m,v="";for(let M of x){let b=f[M],S=n||!this.snapping?void 0:[c.at(-1),c[0]].find(y=>y&&Math.abs(y[M]-b)<Xi.align*g);if(S)f[M]=S[M],v="in line";else{let y=n||!this.snapping?m:_;f[M]=co(Math.round(b/y)*y)}}return{point:f,how:v,close:!1}}showNext(e,t){let{host:n}=this,{next:s}=this,{draft:r,request:o}=n.history.document;if(!s||!r){n.label(null);return}let a=r.at(-1),l=s.point.map(u=>vt(u,6)).join(", "),c=a?Math.hypot(...s.point.map((u,h)=>u-a[h])):0;n.label([a?`${vt(c,4)} ${hi(o)}`:l,s.how].filter(Boolean).join(" · "),e,t)}hints(){let{sketch:e,stage:t,frame:n,history:s,lines:r}=this.host,o=Math.tan(t.camera.fov*Math.PI/360);e.setPixel(2*o/t.height,t.renderer?.getPixelRatio()??1);let a=[],l=[],c=null,{draft:u}=s.document;if(u&&this.next){let d=n.toScene(this.next.point);c=d,u.length>0&&a.push(n.toScene(u.at(-1)),d),u.length>1&&Rt[s.document.kind].line!=="rail"&&l.push(d,n.toScene(u[0]))}else this.cabling?a.push(...this.cableHint()):this.ghost&&!this.busy&&(c=n.toScene(this.ghost.point));let h=this.arrow();if(h){let d=h.to.toArray(),f=new P(1,0,0).applyQuaternion(t.camera.quaternion),g=h.from.distanceTo(h.to),x=h.to.clone().addScaledVector(h.to.clone().sub(h.from),-.24);a.push(h.from.toArray(),d);for(let M of[-1,1])a.push(x.clone().addScaledVector(f,M*.14*g).toArray(),d);let{only:m}=this,_=Dt(r[m.line].points[m.point]),v=[...n.toScene(_)];v[1]=t.grid.mesh.position.y,(this.lifting||Math.abs(v[1]-h.from.y)>g*.3)&&l.push(h.from.toArray(),v)}e.hint({segments:a,faint:l,ghost:c})}key(e){let{stage:t,frame:n,lines:s}=this.host;if(e.ctrlKey||e.metaKey){if(e.key!=="a")return;this.select(s.flatMap((h,d)=>h.points.map((f,g)=>({line:d,point:g})).filter(({point:f})=>el(h,f)))),e.preventDefault();return}let r=this.selection.length>0&&!this.drawing,o=n.up===2?[0,1]:[0,2],a=n.up===2?1:-1,l={ArrowLeft:[o[0],-1],ArrowRight:[o[0],1],ArrowUp:[o[1],a],ArrowDown:[o[1],-a],PageUp:[n.up,1],PageDown:[n.up,-1]},c={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},u=l[e.key];if(r&&u){let h=10**Math.round(Math.log10(n.length(t.pixelAt(t.centre))*10))*(e.shiftKey?10:1),d=[0,0,0];d[u[0]]=u[1]*h,this.moveBy(d)}else if(c[e.key]){let[h,d]=c[e.key];e.shiftKey?t.pan(-24*h,-24*d):t.orbit(.12*h,.12*d)}else if(this.cable>=0&&(e.key==="Delete"||e.key==="Backspace"))this.dropCable();else if(r&&(e.key==="Delete"||e.key==="Backspace"))this.remove();else if(r&&(e.key==="Insert"||e.key==="Enter"))this.insert();else if(e.key==="]")this.step(1);else if(e.key==="[")this.step(-1);else if(e.key==="+"||e.key==="=")t.zoom(t.width/2,t.height/2,.85);else if(e.key==="-"&&!this.drawing)t.zoom(t.width/2,t.height/2,1/.85);else if(e.key==="Escape"&&r)this.select([]);else return;e.preventDefault()}},co=i=>Number(i.toPrecision(14));var RC={idle:[],submitting:["running","shown","failed","cancelled"],running:["shown","failed","cancelled"],shown:[],failed:[],cancelled:[]},Qd=class{life={phase:"idle"};waiting=null;get underWay(){return this.life.phase==="submitting"||this.life.phase==="running"?this.life.asked:null}get job(){return"job"in this.life?this.life.job:null}get hasWaiting(){return this.waiting!==null}isCurrent(e){return this.underWay===e}ask(e){return this.underWay?(this.waiting=e,!1):(this.life={phase:"submitting",asked:e},!0)}enter(e){return this.underWay!==e.asked||!RC[this.life.phase].includes(e.phase)?!1:(this.life=e,!0)}next(){let{waiting:e}=this;return e&&(this.life={phase:"submitting",asked:e}),this.waiting=null,e}wasCancelled(e,t){this.underWay||(this.life={phase:"cancelled",asked:{kind:e,request:t}})}dropWaiting(){this.waiting=null}};var ef=[.62,.5,.85],yi=document.documentElement.hasAttribute("data-embed"),tf={light:{sketch:{paper:"#ffffff",accent:"#0a6c7e",ink:"#1c2427",fault:"#c62f26",soft:"#6d7b81",cable:"#b4561f"},look:{membrane:"#f2eee6",ink:"#20292d",accent:"#b4561f",reaction:"#c2185b",rim:"#ffffff"},grid:["#5b6b73",.42],shadow:.5},dark:{sketch:{paper:"#12181b",accent:"#56c4d4",ink:"#ffffff",fault:"#ff7a70",soft:"#8fa0a8",cable:"#ffb273"},look:{membrane:"#cbc7be",ink:"#0d1214",accent:"#ffb273",reaction:"#ff8fb8",rim:"#6c7c84"},grid:["#90a4ad",.3],shadow:.85}},xi={openapi:{},objectives:[],examples:[]},ce={mode:"model",shown:null,viewing:!1,requests:new Qd,lastDuration:0,colour:"plain",quantity:null,serverFaulty:new Set,cameraGiven:!1,ready:!1},ti=new ld({kind:"minimal_surface",request:lu("minimal_surface"),draft:null,title:null}),Ne=()=>ti.document;function Mr(){let{shown:i,viewing:e}=ce;return i!==null&&!e&&(i.solved!==JSON.stringify(Ne().request)||i.job.kind!==Ne().kind)}var Sc={...tf.light.look},He=new jd(Y("view"),()=>({top:64,right:34,left:34,bottom:Math.max(yi?40:70,Y("look").offsetHeight+34)})),On=new Wd(tf.light.sketch),$t=new Ca(Sc);He.model.add($t.group,On.group);var ot={history:ti,stage:He,sketch:On,surface:$t,lines:[],frame:new Di([0,0,0],Ne().request),faulty:new Set,fixed:yi,changed(){},selectionChanged(){},label(){},read(){},readLine(){},announce(){}},Be=new Zd(ot);function bs(i=!1){On.group.visible=!ce.viewing&&!yi,$t.drawn=On.group.visible,Nv(),i||(ot.faulty=new Set([...ce.serverFaulty,...ad(ot.lines).flatMap(({line:e,points:t})=>t.map(n=>`${e}/${n}`))]),He.rememberWhetherAllIsSeen()),Be.refresh()}var Ov=-1;function Nv(){Ov=Be.cable;let{request:i,kind:e}=Ne(),t=({along:s})=>s?mr(i,s).map(r=>Dt(au(i,["boundaries",s.boundary??0,r]))??[0,0,0]):[],n=e==="tensile_structure"&&!ce.viewing?hs(i).map(t):[];On.show(ce.viewing?[]:ot.lines,Ne().draft,ot.frame,{courses:n,chosen:Be.cable})}function CC(){let i=xi.openapi.components?.schemas,{enum:e=["force"],"x-enum-descriptions":t}=i?.CableMode??{};return e.map((n,s)=>({name:n,help:t?.[s]}))}function Dv(){if(!ce.shown||ce.shown.job.kind!=="tensile_structure")return;let i=e=>JSON.stringify(hs(e)[Be.cable]?.along);if(i(ce.shown.request)===i(Ne().request))return ce.shown.job.statistics?.cables?.[Be.cable]}function Ss(){let{drawing:i,selection:e}=Be,t=!Y("intro").hidden&&!i&&e.length===0;Y("intro").hidden=!t,Y("drawing").hidden=!i;let n=!i&&e.length===0?hs(Ne().request)[Be.cable]:void 0;Ov!==Be.cable&&(Nv(),Be.refresh()),Y("cabling").hidden=!Be.mayCable,Y("cabling").setAttribute("aria-pressed",String(Be.cabling)),Y("cable").hidden=!n,Y("point").hidden=i||e.length===0,Y("hint").hidden=t||i||e.length>0||n!==void 0,n&&px(Ne().request,n,Be.cable,CC()),i?PC():e.length>0?Ng():Y("hint").textContent=Og()}function Og(){return ce.viewing?"The server keeps no drawing of this job: only its mesh is shown. Undo, or any edit, brings your drawing back.":ce.mode==="compare"?"Each objective solved on the same rails; the best value of each row is bold. Drag beside the figures to turn all of them.":Be.cabling?"Click an edge of the boundary to hang it on a cable, or a point and then another for a cable along several edges.":ce.mode==="flat"?"The strip unrolled into the plane, to scale. Drag to move it, wheel to zoom.":ot.lines.length===0?"Nothing is drawn yet. Press Draw, open a file, or drop one here.":Ne().kind==="cable_net"?"Drag a support to move it. The net is given by its request: its vertices, edges and targets.":Oi(Ne().kind,Ne().request)?"Drag a point to move it, press on an edge to add one. Drag the ground to orbit, right-drag to pan, wheel to zoom.":`A strip needs two ${Rt[Ne().kind].line}s: press Draw for the next one.`}function PC(){let{kind:i,draft:e}=Ne(),{line:t,least:n}=Rt[i],s=i==="uniform_mesh"&&ot.lines.length===0,r=e.length,o=s?"polygon":t;Y("drawing-hint").textContent=r===0?`Click on the ground to begin the ${o}.`:r<n?`${bi(r,"point")} of the ${o}: click to add more.`:i==="ruled_surface"?`${bi(r,"point")}: click to add more, Enter ends the rail.`:`${bi(r,"point")}: click the first point, or press Enter, to close the ${o}.`,Y("finish").disabled=r<n,Y("level-name").textContent=`at ${"xyz"[ot.frame.up]}`,document.activeElement!==Y("level")&&(Y("level").value=String(Be.level))}function Ng(){let{selection:i,only:e}=Be,t=e&&ot.lines[e.line];Y("point-name").textContent=t?`${Dr(t.name)}, ${e.point+1} of ${t.points.length}`:bi(i.length,"point");for(let r of document.querySelectorAll("#point [data-axis]")){let o=new Set(i.map(l=>{let c=ot.lines[l.line]?.points[l.point];return Array.isArray(c)?c[Number(r.dataset.axis)]:void 0})),[a]=o;document.activeElement===r&&r.dataset.dirty||(r.value=o.size===1&&a!==void 0&&a!==null?String(a):"",r.placeholder=o.size===1?"none":"various")}let n=Be.edgeBefore();Y("edge-field").hidden=!n,n&&document.activeElement!==Y("edge")&&(Y("edge").value=String(Number(n.length.toPrecision(7))));let s=i.some(r=>ot.lines[r.line]?.only);Y("insert-point").disabled=!e||s;for(let r of["delete-point","remove-line"])Y(r).disabled=s;Y("cable-from-point").hidden=!e||!Be.mayCable}var IC=7e3,nn=i=>{Y("status").textContent=i},Fv=i=>{Y("announcement").textContent=i},Uv=0;function Zs(i){Y("toast").textContent=i,Y("toast").hidden=!1,clearTimeout(Uv),Uv=window.setTimeout(()=>{Y("toast").hidden=!0},IC)}var wc=null;function Er(i,e=0,t=0,n=null){wc=i===null?null:{text:i,x:e,y:t,anchor:n},Dg()}function Dg(){let i=Y("label");if(i.hidden=wc===null,!wc)return;let{text:e,anchor:t}=wc,{x:n,y:s}=t?He.project(t):wc;i.textContent=e;let r=Math.min(Math.max(n+14,6),He.width-i.offsetWidth-6),o=Math.min(Math.max(s-30,6),He.height-30);i.style.transform=`translate(${Math.round(r)}px, ${Math.round(o)}px)`}var kv=(i,e,t,n)=>{let s=$t.valueAt(i,e),r=ot.frame.fromScene(i.toArray()).map(o=>vt(o,5)).join(", ");Er(ce.quantity&&s!==null?Gd(ce.quantity,s):r,t,n,i.toArray())},Bv=(i,e,t,n)=>Er(e,t,n,i.toArray());var nf="plateau.work",Ug="plateau.recent",LC=250,OC=2e5,NC=20,Fg=i=>{let{kind:e,request:t}=i??{};return e!==void 0&&e in Rt&&t!==null&&typeof t=="object"},zv=0,Vv=!1;function qi(){clearTimeout(zv),zv=window.setTimeout(Mc,LC)}function Mc(){if(yi||!ce.ready)return;let{kind:i,request:e,draft:t,title:n}=Ne(),{requests:{life:s,job:r},shown:o}=ce,a=s.phase!=="idle"&&s.asked.kind===i&&s.asked.request===JSON.stringify(e),l=a?s.phase:"idle",c=(a?r:Mr()?null:o?.job)?.id??null,u={kind:i,request:e,draft:t,title:n,camera:kg(),colour:ce.colour,phase:l,job:c},h=JSON.stringify(u);try{sessionStorage.setItem(nf,h),localStorage.setItem(nf,h)}catch{Vv||Zs("This drawing is too large to be kept by the browser: save it as a file."),Vv=!0}}function Hv(){try{let i=JSON.parse(sessionStorage.getItem(nf)??localStorage.getItem(nf)??"null");return Fg(i)?i:null}catch{return null}}function kg(){let{eye:i,target:e}=He.pose(),t=new Di([0,0,0],Ne().request).toScene(ot.frame.origin);return{eye:i.map((n,s)=>n+t[s]),target:e.map((n,s)=>n+t[s])}}function sf({eye:i,target:e}){ce.cameraGiven=!0;let t=new Di([0,0,0],Ne().request).toScene(ot.frame.origin);He.place({eye:i.map((n,s)=>n-t[s]),target:e.map((n,s)=>n-t[s])},!1),He.rememberWhetherAllIsSeen()}function Bg(){try{return JSON.parse(localStorage.getItem(Ug)??"[]")}catch{return[]}}function Gv(i,{request:e,title:t}){if(yi||e.length>OC)return;let n=[{id:i.id,title:t,kind:i.kind,request:e},...Bg().filter(s=>s.id!==i.id)].slice(0,NC);try{localStorage.setItem(Ug,JSON.stringify(n))}catch{localStorage.removeItem(Ug)}}var Wv=[{name:"area",label:"Area",unit:"u²",better:"less"},{name:"total_normal_twist",label:"Twist",unit:"",better:"less"},{name:"convex_bridge_ratio",label:"Convex",unit:"%",better:"more"},{name:"bending_energy",label:"Bending",unit:"",better:"less"},{name:"mean_curvature_variation",label:"Curvature var.",unit:"",better:"less"},{name:"largest_fold_deg",label:"Fold",unit:"°",better:"less"}],DC=4,rf=class{constructor(e,t){this.stage=e;this.look=t}stage;look;tiles=[];stop=new AbortController;use=()=>{};async open(e,t,n,s){this.close();let{signal:r}=this.stop=new AbortController,o=Array.isArray(e.normals),a=n.filter(c=>o||c!=="minimal_normal_variation");this.tiles=a.map(c=>{let u=te("button",{type:"button",onclick:()=>this.use(c)},"Use this");u.setAttribute("aria-label",`Use this: ${Zt(c)}`);let h=te("div",{},te("p",{className:"wait"},"Solving…")),d=te("div",{className:"picture"}),f=te("article",{className:"tile"},d,te("div",{className:"facts"},te("header",{},te("h2",{},Zt(c)),u),h));return f.dataset.objective=c,{name:c,box:f,facts:h,picture:d,surface:new Ca(this.look),statistics:null}}),Y("tiles").replaceChildren(...this.tiles.map(({box:c})=>c)),Y("tiles").hidden=!1,Y("tiles").onscroll=()=>this.stage.invalidate(),this.stage.tiles=this.tiles.map(({picture:c,surface:u})=>({element:c,group:u.group})),this.stage.invalidate();let l=[...this.tiles];await Promise.all(Array.from({length:DC},async()=>{for(let c=l.shift();c&&!r.aborted;c=l.shift())await this.fill(c,e,t,r,s)}))}async fill(e,t,n,s,r){try{await this.solve(e,t,n,s)}catch(o){if(s.aborted)return;e.facts.replaceChildren(te("p",{className:"wait"},"This objective found no strip.")),r(o)}}async solve(e,t,n,s){let{secondary_objective:r,...o}=t,a={...o,objective:e.name,all_objectives:!1,...e.name==="maximal_convexity"&&r?{secondary_objective:r}:{}},{info:l}=await Yt.submit({...a,kind:"ruled_surface"},{waitS:1}),c=await Yt.waitFor(l,{signal:s});if(c.status!=="succeeded")throw new Rs(c);let u=await Aa(await Yt.download(c.id,"glb",s));s.aborted||(e.surface.show(u,"ruled_surface",n),e.statistics=c.statistics,this.report(t),this.stage.invalidate())}report(e){let t=this.tiles.filter(s=>s.statistics!==null),n=new Map(Wv.map(({name:s,better:r})=>{let o=t.map(a=>a.statistics[s]).filter(a=>typeof a=="number");return[s,r==="less"?Math.min(...o):Math.max(...o)]}));for(let s of t)s.box.classList.toggle("best",s.name===(e.objective??"minimal_area")),s.facts.replaceChildren(te("dl",{},...Wv.flatMap(({name:r,label:o,unit:a})=>{let l=s.statistics[r];if(typeof l!="number")return[];let c=Math.abs(l-n.get(r))<=1e-9*Math.abs(n.get(r)),u=a==="%"?`${vt(100*l,3)} %`:`${vt(l,4)}${a==="u²"?` ${hi(e)}²`:a}`;return[te("dt",{title:Zt(r)},o),te("dd",{className:c?"best":""},u)]})))}restyle(){this.tiles.forEach(({surface:e})=>e.restyle())}close(){this.stop.abort(),this.tiles.forEach(({surface:e,picture:t})=>{e.show(null,"",null),t.remove()}),this.tiles=[],this.stage.tiles=null,Y("tiles").hidden=!0,Y("tiles").replaceChildren(),this.stage.invalidate()}};var of=class{url="";asked=0;x=0;y=0;scale=1;box=Y("flat");image=Y("flat-image");constructor(){this.box.addEventListener("wheel",e=>{e.preventDefault();let{left:t,top:n}=this.box.getBoundingClientRect();this.zoom(e.clientX-t,e.clientY-n,Math.exp(-e.deltaY*.0015))},{passive:!1}),this.box.addEventListener("pointerdown",e=>{let t={x:e.clientX-this.x,y:e.clientY-this.y};this.box.setPointerCapture(e.pointerId);let n=r=>{[this.x,this.y]=[r.clientX-t.x,r.clientY-t.y],this.place()},s=()=>{this.box.removeEventListener("pointermove",n),this.box.removeEventListener("pointerup",s)};this.box.addEventListener("pointermove",n),this.box.addEventListener("pointerup",s)}),this.box.addEventListener("keydown",e=>{let{clientWidth:t,clientHeight:n}=this.box;e.key==="+"||e.key==="="?this.zoom(t/2,n/2,1.2):e.key==="-"?this.zoom(t/2,n/2,1/1.2):e.key==="0"&&this.fit()}),new ResizeObserver(()=>{this.box.hidden||this.fit()}).observe(this.box)}async show(e){this.asked+=1;let t=this.asked,n=await Yt.download(e.id,"svg");t===this.asked&&(URL.revokeObjectURL(this.url),this.url=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"})),this.box.hidden=!1,this.image.src=this.url,await this.image.decode(),this.fit())}hide(){this.asked+=1,this.box.hidden=!0}fit(){let{clientWidth:e,clientHeight:t}=this.box,{naturalWidth:n,naturalHeight:s}=this.image;n!==0&&(this.scale=.9*Math.min((e-24)/n,(t-150)/s),this.x=(e-n*this.scale)/2,this.y=(t-s*this.scale)/2+24,this.place())}zoom(e,t,n){this.scale*=n,this.x=e+(this.x-e)*n,this.y=t+(this.y-t)*n,this.place()}place(){let{style:e}=this.image;e.width=`${this.image.naturalWidth*this.scale}px`,e.left=`${this.x}px`,e.top=`${this.y}px`}};var Xv=0;function Yv(i){return i<Xv?!1:(Xv=i,!0)}function Ua(i=Si()){Yv(i)&&(Y("problem").hidden=!0,ce.serverFaulty.size!==0&&(ce.serverFaulty=new Set,bs()))}function li(i,e=Si()){if(!Yv(e))return;let{title:t,detail:n,message:s,errors:r,errorsOmitted:o}=i instanceof Li?UC(i):i,a=r??[],l=new Set,c=a.map(d=>{let f=Rf(ot.lines,d.pointer);f.line!==void 0&&f.point!==void 0&&f.point>=0&&l.add(`${f.line}/${f.point}`);let g=f.line===void 0?Y("options").querySelector(`[name="${CSS.escape(f.field??"")}"], [name^="${CSS.escape(f.field??"")}."]`):null;return qv(Dr(f.text),il(d.detail),f,g)});if(!a.some(d=>Rf(ot.lines,d.pointer).point!==void 0))for(let{line:d,points:f,text:g}of ad(ot.lines))f.forEach(x=>l.add(`${d}/${x}`)),c.push(qv("",g,{line:d,point:f[0]},null));o&&c.push(te("li",{},"and more"));let u=n??s??"",h=a.length>0&&(/^see errors/.test(u)||a.some(d=>u.includes(d.detail)));Y("problem").replaceChildren(te("strong",{},t??"Something went wrong"),h||u===t?"":il(Dr(u)),c.length>0&&te("ul",{},...c)||""),Y("problem").hidden=!1,ce.serverFaulty=l,bs()}var UC=({job:i})=>i?{title:"The connection was lost",detail:"The job goes on at the server. Reload the page to come back to it."}:{title:"The server cannot be reached",detail:"Is it still running? Nothing was lost; try again."};function qv(i,e,t,n){let s=[i&&te("b",{},i),i?` ${e}`:e];if(t.line===void 0&&!n)return te("li",{},...s);let r=te("button",{type:"button"},...s);return r.addEventListener("click",()=>{n?(n.closest("details")?.setAttribute("open",""),n.focus()):Be.select([{line:t.line,point:Math.max(t.point??0,0)}])}),n&&n.setAttribute("aria-invalid","true"),te("li",{},r)}var af=new of,Fa=new rf(He,Sc);function zg(){let i=Si();return e=>li(e,i)}function uo(i){if(!(i===ce.mode&&i!=="compare")){ce.mode=i,Y("stage").dataset.shows=i;for(let e of document.querySelectorAll("[data-mode]"))e.setAttribute("aria-pressed",String(e.dataset.mode===i));if(Y("corner").hidden=i!=="model",i!=="compare"&&Fa.close(),i!=="flat"&&af.hide(),i==="compare"){let e=xi.objectives.filter(t=>t.kind==="ruled_surface").map(t=>t.name);Fa.open(Ne().request,ot.frame,e,zg())}i==="flat"&&ce.shown&&af.show(ce.shown.job).catch(zg()),Ss(),He.invalidate()}}function $v(){ce.mode==="flat"?af.fit():He.fit(!0)}function Kv(i,e){Y("modes").hidden=!i,document.querySelector('[data-mode="flat"]').hidden=!e,!(ce.mode!=="flat"||!ce.shown)&&(e?af.show(ce.shown.job).catch(zg()):uo("model"))}var Ec=300,Tc=118,ka=56,lf=8,FC=8,Jv=22;function cf(i,e,t){let n=[],s=i.filter(o=>o.value!==null&&Number.isFinite(o.value)).map((o,a)=>({x:a,y:o.value})),r=i.filter(o=>o.residual!==null&&o.residual>0).map((o,a)=>({x:a,y:o.residual}));return s.length>=3&&n.push(jv(e,s,!1,null)),r.length>=3&&n.push(jv("Residual",r,!0,t)),n}function jv(i,e,t,n){let s=g=>t?Math.log10(g):g,r=e.map(({y:g})=>s(g));n!==null&&n>0&&r.push(s(n));let o=Math.min(...r),a=Math.max(...r);t&&([o,a]=[Math.floor(o),Math.ceil(a)]),a-o<1e-12*Math.max(Math.abs(a),1e-300)&&([o,a]=[o-Math.abs(o||1)*.01,a+Math.abs(a||1)*.01]);let l=e.at(-1).x||1,c=g=>ka+(Ec-ka-lf)*g/l,u=g=>Tc-Jv-(Tc-FC-Jv)*(g-o)/(a-o),h=Un("svg",{viewBox:`0 0 ${Ec} ${Tc}`,class:"chart",role:"img","aria-label":`${i} over ${e.length} steps, from ${vt(e[0].y,4)} to ${vt(e.at(-1).y,4)}`}),d=kC(o,a,t),f=t?4:Math.min(9,Math.max(4,1+Math.ceil(Math.log10(Math.max(Math.abs(o),Math.abs(a))/Math.abs(d[1]-d[0])))));for(let g of d)h.append(Un("line",{class:"rule",x1:ka,x2:Ec-lf,y1:u(g).toFixed(1),y2:u(g).toFixed(1)}),Un("text",{x:ka-6,y:(u(g)+3.5).toFixed(1),"text-anchor":"end"},vt(t?10**g:g,f)));return h.append(Un("text",{x:ka,y:Tc-6},"0"),Un("text",{x:Ec-lf,y:Tc-6,"text-anchor":"end"},`${vt(e.length-1)} steps`)),n!==null&&n>0&&h.append(Un("path",{class:"floor",d:`M${ka},${u(s(n)).toFixed(1)}H${Ec-lf}`})),h.append(Un("path",{class:"curve",d:e.map((g,x)=>`${x?"L":"M"}${c(g.x).toFixed(1)},${u(s(g.y)).toFixed(1)}`).join("")})),te("figure",{className:"chart-box"},te("figcaption",{},i),h)}function kC(i,e,t){if(t){let l=Math.max(1,Math.ceil((e-i)/3));return Array.from({length:Math.floor((e-i)/l)+1},(c,u)=>i+u*l)}let n=(e-i)/3,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].map(l=>l*s).find(l=>l>=n)??n,o=Math.ceil(i/r)*r,a=[];for(let l=o;l<=e+1e-9*r;l+=r)a.push(Math.abs(l)<1e-9*r?0:l);return a.length>1?a:[i,e]}var Zv=i=>Zt(i);var Vg=220,Hg=34,Gg=44;function Wg(i){if(Y("scale").hidden=i===null,!i)return;let e=i.scale==="diverging"&&i.id==="mean_curvature"?"|H|":"All values";Y("scale-note").textContent=i.nought?`≈ 0: ${e} below ${vt(i.noise,2)}${i.unit&&` ${i.unit}`}`:`${i.label}${i.unit&&` [${i.unit}]`}`;let t=!i.nought&&i.high-i.low<=1e-6*Math.max(Math.abs(i.low),Math.abs(i.high)),n=Y("scale-bar"),s=40,r=Array.from({length:s+1},(c,u)=>cv(i.scale,i.nought||t?i.scale==="diverging"||t?.5:0:u/s));n.style.background=`linear-gradient(to right, ${r.join(", ")})`,Y("scale-low").textContent=i.nought||t?"":vt(i.low,3),Y("scale-middle").textContent=i.nought?"≈ 0":t?vt(i.high,5):i.scale==="diverging"?"0":"",Y("scale-high").textContent=i.nought||t?"":vt(i.high,3);let o=bv(i,Gg),a=Math.max(...o,1),l=Y("scale-histogram");l.hidden=i.nought||t,l.replaceChildren(Un("svg",{viewBox:`0 0 ${Vg} ${Hg}`,preserveAspectRatio:"none",role:"img","aria-label":`Histogram of ${i.values.length} values`},...o.map((c,u)=>{let h=Hg*Math.sqrt(c)/Math.sqrt(a);return Un("rect",{x:u*Vg/Gg,y:Hg-h,width:Vg/Gg-.8,height:h})})))}var qg=i=>i!==null&&typeof i=="object"&&!Array.isArray(i);function Ba(i){return i==null?"—":typeof i=="number"?vt(i):typeof i=="boolean"?i?"yes":"no":String(i).replaceAll("_"," ")}var BC={minimal_surface:[["area","Area","u²"],["triangles","Triangles",""],["residual","Residual",""],["stability.stable","Stable",""],["certificate.gap","Proven: above the least area by at most","%"]],ruled_surface:[["area","Area","u²"],["convex_bridge_ratio","Convex bridges","%"],["bending_energy","Bending energy",""],["largest_fold_deg","Largest fold","°"]],uniform_mesh:[["nodes","Nodes",""],["edges","Members",""],["equal_edges","Equal members",""],["distinct_lengths","Distinct lengths",""]],cable_net:[["edges","Edges",""],["load_path","Load path",""],["balance.imbalance","Force imbalance",""],["objective_value","Loss",""]],tensile_structure:[["area","Area","u²"],["pressure","Pressure",""],["balance.imbalance","Force imbalance",""],["stress.deviation","Stress deviation",""]]},Yg=(i,e)=>e.split(".").reduce((t,n)=>t?.[n],i),zC=(i,e)=>Yg(i,e)!==void 0&&Yg(i,e)!==null;function nb(i,e){let t=i.statistics;return(BC[i.kind]??[]).filter(([n])=>zC(t,n)).map(([n,s,r])=>{let o=Yg(t,n),a=r==="%"&&typeof o=="number"?vt(100*o,3):Ba(o),l=r===""?"":r==="%"||r==="°"?r:` ${r.replace("u",e)}`;return te("div",{className:"figure"},te("span",{className:"value"},a,te("small",{},l)),te("span",{className:"name"},s))})}var Qv=["objective","objective_value","secondary_value","converged","stop_reason","residual","area","certificate","initial_area","nodes","vertices","triangles","edges","bridges","stability","iterations","self_intersections","mean_curvature","edge_lengths","angles_deg"],eb=([i])=>Qv.indexOf(i)+1||Qv.length+1,VC=6,Xg=500;function ib(i){let e=[],t=[],n=(s,r)=>{if(Array.isArray(r)){if(r.length===0)return;r.every(qg)?t.push(GC(s,r)):r.length>VC?t.push(sb(s,String(r.length),te("p",{className:"numbers"},r.map(Ba).join(" · ")))):e.push(tb(s,r.map(Ba).join(", ")))}else qg(r)?Object.entries(r).forEach(([o,a])=>n(`${s} ${o}`,a)):r!==void 0&&e.push(tb(s,Ba(r)))};return Object.entries(i).filter(([s])=>s!=="comparison"&&s!=="history").sort((s,r)=>eb(s)-eb(r)).forEach(([s,r])=>n(s,r)),[te("table",{className:"plain"},te("tbody",{},...e)),...t]}var HC=60;function tb(i,e){let t=Zt(i.replace(/_deg (.*)$/," $1_deg"));return e.length>HC?te("tr",{},te("td",{className:"long",colSpan:2},te("span",{},t),e)):te("tr",{},te("th",{scope:"row"},t),te("td",{},e))}var sb=(i,e,t)=>te("details",{},te("summary",{},`${Zt(i)} (${e})`),te("div",{className:"wide",tabIndex:0,role:"region","aria-label":Zt(i)},t));function GC(i,e){let t=e.map(a=>rb(a)),n=[...new Set(t.flatMap(a=>Object.keys(a)))],s=te("tr",{},...n.map(a=>te("th",{scope:"col"},Zt(a)))),r=t.slice(0,Xg).map(a=>te("tr",{},...n.map(l=>te("td",{},l in a?Ba(a[l]):"")))),o=e.length>Xg?`first ${Xg} of ${e.length}`:String(e.length);return sb(i,o,te("table",{},te("thead",{},s),te("tbody",{},...r)))}function rb(i,e=""){return Object.entries(i).reduce((t,[n,s])=>qg(s)?{...t,...rb(s,`${e}${n} `)}:{...t,[e+n]:Array.isArray(s)?s.map(Ba).join(", "):s},{})}var ob=i=>(i??[]).map(({code:e,detail:t})=>te("p",{className:"warning"},te("strong",{},Zt(e)),` ${il(t)}`)),ab=i=>(i??[]).map(e=>({iteration:e.iteration,phase:e.phase,value:e.area??null,residual:e.residual??null}));var lb=450,cb=0;function ws(){ce.shown=null,ce.quantity=null,$t.show(null,"",ot.frame),Y("result").hidden=!0,Y("nothing").hidden=!1,Y("look").hidden=!0,Y("modes").hidden=!0,Wg(null),uo("model")}function uf(i,e,t,n=!1){let s=ce.shown===null||ce.shown.job.kind!==i.kind,r=JSON.parse(t);ce.shown={job:i,mesh:e,solved:t,request:r,dragging:n},Er(null),s&&ce.colour==="plain"&&(ce.colour=xv(e)),db(),$t.show(e,i.kind,ot.frame,ce.quantity),Y("look").hidden=!1,XC(),He.measure(),He.rememberWhetherAllIsSeen(),s&&!ce.cameraGiven&&He.fit(!1),ce.cameraGiven=!1,Y("nothing").hidden=!0,Y("result").hidden=!1,Y("job-id").textContent=i.id;let o=i.statistics;Y("figures").replaceChildren(...nb(i,hi(r))),Y("warnings").replaceChildren(...ob(i.warnings)),Y("statistics").replaceChildren(...ib(o)),Y("charts").replaceChildren(...cf(ab(o.history),"Area",$g(r))),ub(Y("downloads"),["glb","gltf","obj","ply",...js(e)?["stl"]:[]],i);let a=!!(i.links.pattern&&o.flat_pattern);Y("pattern-box").hidden=!a,a&&ub(Y("pattern-downloads"),["svg","dxf"],i),Kv(i.kind==="ruled_surface",a),WC(i,e),Ac()}var $g=i=>typeof i.tolerance=="number"?i.tolerance:Ne().kind==="minimal_surface"?1e-6:null;function WC(i,e){let t=(Date.parse(i.finished_at??"")-Date.parse(i.started_at??""))/1e3,n=t>0?`Solved in ${nl(t)}`:"Solved",{converged:s}=i.statistics,r=e.lines.filter(({name:a})=>a.startsWith("cables")).reduce((a,l)=>a+l.segments.length/6,0),o=js(e)?bi(e.geometry.index.count/3,"triangle"):bi(r,"edge");nn(`${n}: ${o}.${s===!1?" Not converged.":""}`)}function ub(i,e,t){i.replaceChildren(...e.map(n=>te("button",{type:"button",onclick:async()=>{let s=Si();try{_o(new Blob([await Yt.download(t.id,n)]),`${t.kind.replaceAll("_","-")}-${t.id}.${n}`)}catch(r){li(r,s)}}},n.toUpperCase())))}function Ac(){let i=Mr();for(let t of document.querySelectorAll("#downloads button, #pattern-downloads button"))t.disabled=i;clearTimeout(cb);let e=()=>{Y("result").classList.toggle("stale",i),Y("stale").hidden=!i,$t.setGhost(i||Ne().draft!==null),He.invalidate()};i&&ce.requests.underWay&&ce.lastDuration*1e3<lb?cb=window.setTimeout(e,lb):e()}function hb(){ce.shown&&(db(),$t.colourBy(ce.quantity))}function db(){let{shown:i}=ce;if(!i)return;let{mesh:e,job:t,request:n}=i,s=_v(e,t.kind),r=Y("quantity");s.some(({id:o})=>o===ce.colour)||(ce.colour="plain"),r.replaceChildren(...s.map(({id:o,label:a})=>te("option",{value:o},a))),r.value=ce.colour,ce.quantity=vv(e,ce.colour,hi(n),yo(n)),Wg(ce.quantity)}function XC(){let i={surface:"Surface",edges:"Mesh",lines:"Lines",reactions:"Reactions"},e=ce.shown?.mesh,t=n=>n==="reactions"?e?.lines.some(s=>s.name==="reactions"&&s.segments.length>0)??!1:n==="lines"||!e||js(e);Y("layers").replaceChildren(...Object.keys(i).filter(t).map(n=>{let s=te("button",{type:"button","aria-pressed":String($t.layers[n])},i[n]);return s.addEventListener("click",()=>{$t.setLayers({[n]:!$t.layers[n]}),s.setAttribute("aria-pressed",String($t.layers[n])),He.measure()}),s}),qC())}function qC(){let i=te("button",{type:"button","aria-pressed":String(On.group.visible)},"Drawing");return i.addEventListener("click",()=>{On.group.visible=!On.group.visible,$t.drawn=On.group.visible,$t.restyle(),i.setAttribute("aria-pressed",String(On.group.visible)),He.invalidate()}),i}var YC=2e3,$C=300,KC=1,{requests:sn}=ce,fb=0,hf=0,df={submit:async({kind:i,request:e})=>(await Yt.submit({...JSON.parse(e),kind:i},{waitS:KC})).info,follow:(i,e)=>ZC(i,e),mesh:async(i,{stop:e})=>Aa(await Yt.download(i.id,"glb",e.signal)),cancel:i=>Yt.cancel(i.id)},Qs=(i=!1)=>Kg(df,i),mb=i=>Kg({...df,submit:()=>Promise.resolve(i)}),gb=i=>Kg({...df,submit:e=>Yt.getJson(`v1/jobs/${i}`).catch(t=>{if(t instanceof As)return df.submit(e);throw t})});async function Kg(i,e=!1){let{kind:t,request:n,title:s}=Ne(),r={turn:Si(),kind:t,request:JSON.stringify(n),title:s,dragging:e,since:performance.now(),stop:new AbortController,source:i},o=sn.underWay;sn.ask(r)?await _b(r):o&&(clearTimeout(hf),hf=window.setTimeout(()=>{vb(o)},o.since+YC-performance.now()))}var _b=i=>xo(async()=>{clearTimeout(hf),i.since=performance.now(),Sb(!0),i.dragging||nn("Solving…");try{await JC(i)}catch(e){sn.enter({phase:"failed",asked:i,job:sn.job,error:e})&&(sn.hasWaiting||(li(e,i.turn),nn("Not solved.")),Rc())}});function Rc(){let i=sn.next();if(i){_b(i);return}clearTimeout(hf),Sb(!1),Ac(),qi()}var pb=(i,{signal:e})=>new Promise((t,n)=>{e.addEventListener("abort",()=>n(e.reason),{once:!0}),i.then(t,n)});async function JC(i){let{source:e,stop:t}=i,n=e.submit(i);n.then(o=>{t.signal.aborted&&yb(i,o).catch(()=>{})},()=>{});let s=await pb(n,t);if(!sn.isCurrent(i))return;if(Ua(i.turn),ui(s.status)||(sn.enter({phase:"running",asked:i,job:s}),qi(),s=await e.follow(s,i)),s.status==="failed")throw sn.life.phase==="submitting"&&sn.enter({phase:"running",asked:i,job:s}),new Rs(s);if(s.status==="cancelled"){sn.enter({phase:"cancelled",asked:i})&&(sn.hasWaiting||nn("Cancelled."),Rc());return}let r=await pb(e.mesh(s,i),t);sn.enter({phase:"shown",asked:i,job:s})&&(jC(i,s,r),Rc())}function jC(i,e,t){let n=ce.shown;ce.lastDuration=(performance.now()-i.since)/1e3,uf(e,t,i.request,i.dragging),n?.dragging&&n.job.id!==e.id&&Yt.delete(n.job.id).catch(()=>{}),i.dragging||Gv(e,i)}var yb=(i,e)=>e&&!ui(e.status)?i.source.cancel(e):Promise.resolve();function xb(i){let{job:e}=sn;return sn.enter({phase:"cancelled",asked:i})?(i.stop.abort(),yb(i,e)):null}function vb(i){let e=xb(i);e&&(e.catch(()=>{}),Rc())}function Cc(){sn.dropWaiting();let{underWay:i}=sn;i&&(vb(i),nn(""))}function bb(){sn.dropWaiting();let{underWay:i}=sn;if(!i)return;let e=xb(i);Rc(),Mc();let{life:t}=sn;nn("Cancelling…"),xo(async()=>{try{await e,sn.life===t&&nn("Cancelled.")}catch(n){li(n,i.turn),sn.life===t&&nn("Not cancelled.")}})}async function ZC(i,e){let{signal:t}=e.stop,n=[],s=Date.now(),r=!0,o=(l,c)=>{sn.isCurrent(e)&&(r?QC(l,n,s,c):nn(`Connection interrupted, the job goes on, reconnecting · ${nl((Date.now()-s)/1e3)}`))},a=window.setInterval(()=>o(null),500);o(null,i.status==="queued"?"Waiting in the queue":"Running");try{return await Yt.waitFor(i,{signal:t,onConnection:l=>{r=l,o(null)},onProgress:l=>{let c=n.at(-1);(!c||c.iteration!==l.iteration||c.phase!==l.phase)&&n.push({iteration:l.iteration,phase:l.phase,value:l.objective_value??null,residual:l.residual??null}),o(l)}})}finally{clearInterval(a)}}function Sb(i){Y("cancel").hidden=!i,Y("running-charts").replaceChildren();let e=Y("progress");clearTimeout(fb),i?(e.removeAttribute("value"),fb=window.setTimeout(()=>{e.hidden=!1},$C)):e.hidden=!0}function QC(i,e,t,n){let s=nl((Date.now()-t)/1e3),r=e.at(-1),o=Y("progress");i&&(o.value=i.fraction,Y("running-charts").replaceChildren(...cf(e,Ne().kind==="minimal_surface"?"Area":"Objective",$g(Ne().request))));let a=[o.position>0&&`${Math.round(o.position*100)} %`,n??(r?Zv(r.phase):"Running"),r&&r.iteration>0&&`iteration ${vt(r.iteration)}`,s];nn(a.filter(Boolean).join(" · "))}var eP=1.2,Jg=new rd(Y("gizmo"),He,ot.frame),za=()=>Y("live").checked;function Tr({refit:i=!0,direction:e=ef}={}){let{kind:t,request:n}=Ne();ot.lines=ou(t,n),ot.frame=new Di(q0(ot.lines,n),n),Jg.build(ot.frame),$t.putInto(ot.frame),Be.prune(),ff(),bs(),He.measure(),i&&He.fit(!1,e),pf()}function ff(){let{kind:i,request:e}=Ne(),t=document.querySelector(`#kinds input[value="${i}"]`);t&&(t.checked=!0),Y("purpose").textContent=Rt[i].purpose;let n=hu(xi.openapi,Rt[i].path);n&&V0(Y("options"),n,e,{openapi:xi.openapi,set:(s,r)=>{ti.edit(({request:a})=>{r===void 0?delete a[s]:a[s]=r})&&((s==="units"||s==="up")&&(ws(),Tr()),vi({option:!0}))},describe:(s,r)=>{if(s!=="objective")return;let o=xi.objectives.find(a=>a.kind===i&&a.name===r);return o?`${Dr(o.minimises)} [${o.unit.replaceAll("u",hi(e))}]. ${o.source}.`:void 0}})}function vi({dragging:i=!1,option:e=!1}={}){Y("intro").hidden=!0,ce.viewing=!1,ce.serverFaulty=new Set,ot.lines=ou(Ne().kind,Ne().request),Be.prune(),bs(i),i||(e||ff(),He.measure(),qi()),pf(i),za()&&Oi(Ne().kind,Ne().request)&&Ne().draft===null&&(!i||ce.lastDuration<eP)&&Qs(i)}function pf(i=!1){Y("undo").disabled=!ti.canUndo,Y("redo").disabled=!ti.canRedo,Y("draw").setAttribute("aria-pressed",String(Be.drawing)),Y("draw").disabled=Rt[Ne().kind].lines.length===0,Y("title").textContent=Ne().title??"",!i&&Y("request-box").open&&mf(),Ss(),Ac()}function mf(){let i=Y("request"),e=cu(Ne().request);i.defaultValue!==e&&(i.defaultValue=e)}var wb=i=>{i()&&(ce.requests.underWay&&ce.requests.underWay.kind!==Ne().kind&&Cc(),ce.shown&&ce.shown.job.kind!==Ne().kind&&ws(),Tr({refit:!1}),He.rememberWhetherAllIsSeen(),vi())},jg=()=>wb(()=>ti.undo()),gf=()=>wb(()=>ti.redo());function Ar(i,e,t){Cc(),ce.viewing=!1,ce.cameraGiven=!1;let n=ce.shown?.job.kind===i;ti.edit(s=>Object.assign(s,{kind:i,request:e,title:t,draft:null})),Be.selection=[],(!n||!Oi(i,e))&&ws(),Ua(),Tr()}function Va(i){ws(),Ar(i,lu(i),null),nn(""),Be.startDrawing()}function Mb(i){uo("model"),ti.edit(({request:t})=>{t.objective=i,i!=="maximal_convexity"&&delete t.secondary_objective})&&vi(),za()||Qs()}var bt=class extends Error{constructor(e,t){super(t===void 0?e:`Line ${t}: ${e}`)}},Ms=i=>`“${i.trim().slice(0,24)}${i.trim().length>24?"…":""}”`;function _f(i,e){let t=Number(i.trim());if(i.trim()===""||!Number.isFinite(t))throw new bt(`${Ms(i)} is not a number.`,e);return t}function ci(i,e=!1){let[t]=i,n=i.at(-1),s=i.length>2&&t.every((r,o)=>r===n[o]);return{points:s?i.slice(0,-1):i,closed:e||s}}function ho(i,e=1e-7){let n=Math.max(...i.flat(1).flat().map(Math.abs),1e-300)*e,s=c=>c.map(u=>Math.round(u/n)).join(","),r=new Map;i.forEach(([c,u],h)=>{for(let d of[c,u]){let f=r.get(s(d))??[];f.push(h),r.set(s(d),f)}});let o=new Set,a=c=>{let u=[];for(let h=c;;){let d=r.get(s(h))??[],f=d.length<=2?d.find(m=>!o.has(m)):void 0;if(f===void 0)return u;o.add(f);let[g,x]=i[f];h=s(g)===s(h)?x:g,u.push(h)}},l=[];return i.forEach(([c,u],h)=>{if(o.has(h))return;o.add(h);let d=a(u),g=[...a(c).reverse(),c,u,...d],x=g.length>3&&s(g[0])===s(g.at(-1));l.push({points:x?g.slice(0,-1):g,closed:x})}),l}var Tb=E0(Eb(),1);function Ab(i){let e=!/[,;\t|]/.test(i),{data:t}=Tb.default.parse(e?i.replace(/[ ]+/g," ").replace(/^ | $/gm,""):i,{delimiter:e?" ":""}),n=[0,1,2],s=-1,r=[[]],o,a=!1;for(let[l,c]of t.entries()){let u=c.map(h=>h.trim());if(u.every(h=>h==="")){r.at(-1).length>0&&r.push([]);continue}if(!u[0].startsWith("#")){if(!a&&u.every(h=>!Number.isFinite(Number(h))||h==="")){let h=u.map(m=>m.toLowerCase()),d=(...m)=>h.findIndex(_=>m.includes(_)),[f,g,x]=[d("x","easting","e"),d("y","northing","n"),d("z","height","elevation","h")];if(f<0||g<0)throw new bt(`${Ms(c.join(","))} names no columns x and y, and is no point.`,l+1);n=[f,g,x],s=d("line","polyline","boundary","curve","id"),a=!0;continue}if(a=!0,u.length<2)throw new bt(`${Ms(c.join(","))} is no point: x, y and z are expected.`,l+1);s>=0&&o!==void 0&&u[s]!==o&&r.at(-1).length>0&&r.push([]),o=s>=0?u[s]:void 0,r.at(-1).push(n.map(h=>h<0||(u[h]??"")===""&&h===n[2]?0:_f(u[h]??"",l+1)))}}return r.filter(l=>l.length>0).map(l=>ci(l))}var Pc=class{constructor(e){this._pointer=0,this._eof=!1,this._data=e}next(){if(!this.hasNext())throw this._eof?new Error("Cannot call 'next' after EOF group has been read"):new Error("Unexpected end of input: EOF group not read before end of file. Ended on code "+this._data[this._pointer]);let e={code:parseInt(this._data[this._pointer])};return this._pointer++,e.value=Rb(e.code,this._data[this._pointer].trim()),this._pointer++,e.code===0&&e.value==="EOF"&&(this._eof=!0),this.lastReadGroup=e,e}peek(){if(!this.hasNext())throw this._eof?new Error("Cannot call 'next' after EOF group has been read"):new Error("Unexpected end of input: EOF group not read before end of file. Ended on code "+this._data[this._pointer]);let e={code:parseInt(this._data[this._pointer])};return e.value=Rb(e.code,this._data[this._pointer+1].trim()),e}rewind(e=1){this._pointer=this._pointer-e*2}hasNext(){return!(this._eof||this._pointer>this._data.length-2)}isEOF(){return this._eof}};function Rb(i,e){return i<=9?e:i>=10&&i<=59?parseFloat(e):i>=60&&i<=99?parseInt(e):i>=100&&i<=109?e:i>=110&&i<=149?parseFloat(e):i>=160&&i<=179?parseInt(e):i>=210&&i<=239?parseFloat(e):i>=270&&i<=289?parseInt(e):i>=290&&i<=299?tP(e):i>=300&&i<=369?e:i>=370&&i<=389?parseInt(e):i>=390&&i<=399?e:i>=400&&i<=409?parseInt(e):i>=410&&i<=419?e:i>=420&&i<=429?parseInt(e):i>=430&&i<=439?e:i>=440&&i<=459?parseInt(e):i>=460&&i<=469?parseFloat(e):i>=470&&i<=481||i===999||i>=1e3&&i<=1009?e:i>=1010&&i<=1059?parseFloat(e):i>=1060&&i<=1071?parseInt(e):(console.log("WARNING: Group code does not have a defined type: %j",{code:i,value:e}),e)}function tP(i){if(i==="0")return!1;if(i==="1")return!0;throw TypeError("String '"+i+"' cannot be cast to Boolean type")}var yf=[0,16711680,16776960,65280,65535,255,16711935,16777215,8421504,12632256,16711680,16744319,13369344,13395558,10027008,10046540,8323072,8339263,4980736,4990502,16727808,16752511,13382400,13401958,10036736,10051404,8331008,8343359,4985600,4992806,16744192,16760703,13395456,13408614,10046464,10056268,8339200,8347455,4990464,4995366,16760576,16768895,13408512,13415014,10056192,10061132,8347392,8351551,4995328,4997670,16776960,16777087,13421568,13421670,10000384,10000460,8355584,8355647,5000192,5000230,12582656,14679935,10079232,11717734,7510016,8755276,6258432,7307071,3755008,4344870,8388352,12582783,6736896,10079334,5019648,7510092,4161280,6258495,2509824,3755046,4194048,10485631,3394560,8375398,2529280,6264908,2064128,5209919,1264640,3099686,65280,8388479,52224,6736998,38912,5019724,32512,4161343,19456,2509862,65343,8388511,52275,6737023,38950,5019743,32543,4161359,19475,2509871,65407,8388543,52326,6737049,38988,5019762,32575,4161375,19494,2509881,65471,8388575,52377,6737074,39026,5019781,32607,4161391,19513,2509890,65535,8388607,52428,6737100,39064,5019800,32639,4161407,19532,2509900,49151,8380415,39372,6730444,29336,5014936,24447,4157311,14668,2507340,32767,8372223,26316,6724044,19608,5010072,16255,4153215,9804,2505036,16383,8364031,13260,6717388,9880,5005208,8063,4149119,4940,2502476,255,8355839,204,6710988,152,5000344,127,4145023,76,2500172,4129023,10452991,3342540,8349388,2490520,6245528,2031743,5193599,1245260,3089996,8323327,12550143,6684876,10053324,4980888,7490712,4128895,6242175,2490444,3745356,12517631,14647295,10027212,11691724,7471256,8735896,6226047,7290751,3735628,4335180,16711935,16744447,13369548,13395660,9961624,9981080,8323199,8339327,4980812,4990540,16711871,16744415,13369497,13395634,9961586,9981061,8323167,8339311,4980793,4990530,16711807,16744383,13369446,13395609,9961548,9981042,8323135,8339295,4980774,4990521,16711743,16744351,13369395,13395583,9961510,9981023,8323103,8339279,4980755,4990511,3355443,5987163,8684676,11382189,14079702,16777215];function nP(i){return yf[i]}function Ye(i){let e={};i.rewind();let t=i.next(),n=t.code;if(e.x=t.value,n+=10,t=i.next(),t.code!=n)throw new Error("Expected code for point value to be "+n+" but got "+t.code+".");return e.y=t.value,n+=10,t=i.next(),t.code!=n?(i.rewind(),e):(e.z=t.value,e)}function St(i,e,t){switch(e.code){case 0:i.type=e.value;break;case 5:i.handle=e.value;break;case 6:i.lineType=e.value;break;case 8:i.layer=e.value;break;case 48:i.lineTypeScale=e.value;break;case 60:i.visible=e.value===0;break;case 62:i.colorIndex=e.value,i.color=nP(Math.abs(e.value));break;case 67:i.inPaperSpace=e.value!==0;break;case 100:break;case 101:for(;e.code!=0;)e=t.next();t.rewind();break;case 330:i.ownerHandle=e.value;break;case 347:i.materialObjectHandle=e.value;break;case 370:i.lineweight=e.value;break;case 420:i.color=e.value;break;case 1e3:i.extendedData=i.extendedData||{},i.extendedData.customStrings=i.extendedData.customStrings||[],i.extendedData.customStrings.push(e.value);break;case 1001:i.extendedData=i.extendedData||{},i.extendedData.applicationName=e.value;break;default:return!1}return!0}var Ic=class{constructor(){this.ForEntityName="3DFACE"}parseEntity(e,t){let n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 70:n.shape=(t.value&1)===1,n.hasContinuousLinetypePattern=(t.value&128)===128;break;case 10:n.vertices=iP(e,t),t=e.lastReadGroup;break;default:St(n,t,e);break}t=e.next()}return n}};function iP(i,e){var t=[],n=!1,s=!1,r=4;for(let a=0;a<=r;a++){for(var o={};!i.isEOF()&&!(e.code===0||s);){switch(e.code){case 10:case 11:case 12:case 13:if(n){s=!0;continue}o.x=e.value,n=!0;break;case 20:case 21:case 22:case 23:o.y=e.value;break;case 30:case 31:case 32:case 33:o.z=e.value;break;default:return t}e=i.next()}t.push(o),n=!1,s=!1}return i.rewind(),t}var Lc=class{constructor(){this.ForEntityName="ARC"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=Ye(e);break;case 40:n.radius=t.value;break;case 50:n.startAngle=Math.PI/180*t.value;break;case 51:n.endAngle=Math.PI/180*t.value,n.angleLength=n.endAngle-n.startAngle;break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var Oc=class{constructor(){this.ForEntityName="ATTDEF"}parseEntity(e,t){var n={type:t.value,scale:1,textStyle:"STANDARD"};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 1:n.text=t.value;break;case 2:n.tag=t.value;break;case 3:n.prompt=t.value;break;case 7:n.textStyle=t.value;break;case 10:n.startPoint=Ye(e);break;case 11:n.endPoint=Ye(e);break;case 39:n.thickness=t.value;break;case 40:n.textHeight=t.value;break;case 41:n.scale=t.value;break;case 50:n.rotation=t.value;break;case 51:n.obliqueAngle=t.value;break;case 70:n.invisible=!!(t.value&1),n.constant=!!(t.value&2),n.verificationRequired=!!(t.value&4),n.preset=!!(t.value&8);break;case 71:n.backwards=!!(t.value&2),n.mirrored=!!(t.value&4);break;case 72:n.horizontalJustification=t.value;break;case 73:n.fieldLength=t.value;break;case 74:n.verticalJustification=t.value;break;case 100:break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var Nc=class{constructor(){this.ForEntityName="CIRCLE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=Ye(e);break;case 40:n.radius=t.value;break;case 50:n.startAngle=Math.PI/180*t.value;break;case 51:let s=Math.PI/180*t.value;s<n.startAngle?n.angleLength=s+2*Math.PI-n.startAngle:n.angleLength=s-n.startAngle,n.endAngle=s;break;default:St(n,t,e);break}t=e.next()}return n}};var Dc=class{constructor(){this.ForEntityName="DIMENSION"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 2:n.block=t.value;break;case 10:n.anchorPoint=Ye(e);break;case 11:n.middleOfText=Ye(e);break;case 12:n.insertionPoint=Ye(e);break;case 13:n.linearOrAngularPoint1=Ye(e);break;case 14:n.linearOrAngularPoint2=Ye(e);break;case 15:n.diameterOrRadiusPoint=Ye(e);break;case 16:n.arcPoint=Ye(e);break;case 70:n.dimensionType=t.value;break;case 71:n.attachmentPoint=t.value;break;case 42:n.actualMeasurement=t.value;break;case 1:n.text=t.value;break;case 50:n.angle=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var Uc=class{constructor(){this.ForEntityName="ELLIPSE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.center=Ye(e);break;case 11:n.majorAxisEndPoint=Ye(e);break;case 40:n.axisRatio=t.value;break;case 41:n.startAngle=t.value;break;case 42:n.endAngle=t.value;break;case 2:n.name=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var Fc=class{constructor(){this.ForEntityName="INSERT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 2:n.name=t.value;break;case 41:n.xScale=t.value;break;case 42:n.yScale=t.value;break;case 43:n.zScale=t.value;break;case 10:n.position=Ye(e);break;case 50:n.rotation=t.value;break;case 70:n.columnCount=t.value;break;case 71:n.rowCount=t.value;break;case 44:n.columnSpacing=t.value;break;case 45:n.rowSpacing=t.value;break;case 210:n.extrusionDirection=Ye(e);break;default:St(n,t,e);break}t=e.next()}return n}};var kc=class{constructor(){this.ForEntityName="LINE"}parseEntity(e,t){let n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.vertices.unshift(Ye(e));break;case 11:n.vertices.push(Ye(e));break;case 210:n.extrusionDirection=Ye(e);break;case 100:break;default:St(n,t,e);break}t=e.next()}return n}};var Bc=class{constructor(){this.ForEntityName="LWPOLYLINE"}parseEntity(e,t){let n={type:t.value,vertices:[]},s=0;for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 38:n.elevation=t.value;break;case 39:n.depth=t.value;break;case 70:n.shape=(t.value&1)===1,n.hasContinuousLinetypePattern=(t.value&128)===128;break;case 90:s=t.value;break;case 10:n.vertices=sP(s,e);break;case 43:t.value!==0&&(n.width=t.value);break;case 210:n.extrusionDirectionX=t.value;break;case 220:n.extrusionDirectionY=t.value;break;case 230:n.extrusionDirectionZ=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};function sP(i,e){if(!i||i<=0)throw Error("n must be greater than 0 verticies");let t=[],n=!1,s=!1,r=e.lastReadGroup;for(let o=0;o<i;o++){let a={};for(;!e.isEOF()&&!(r.code===0||s);){switch(r.code){case 10:if(n){s=!0;continue}a.x=r.value,n=!0;break;case 20:a.y=r.value;break;case 30:a.z=r.value;break;case 40:a.startWidth=r.value;break;case 41:a.endWidth=r.value;break;case 42:r.value!=0&&(a.bulge=r.value);break;default:return e.rewind(),n&&t.push(a),e.rewind(),t}r=e.next()}t.push(a),n=!1,s=!1}return e.rewind(),t}var zc=class{constructor(){this.ForEntityName="MTEXT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 3:n.text?n.text+=t.value:n.text=t.value;break;case 1:n.text?n.text+=t.value:n.text=t.value;break;case 10:n.position=Ye(e);break;case 11:n.directionVector=Ye(e);break;case 40:n.height=t.value;break;case 41:n.width=t.value;break;case 50:n.rotation=t.value;break;case 71:n.attachmentPoint=t.value;break;case 72:n.drawingDirection=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var Vc=class{constructor(){this.ForEntityName="POINT"}parseEntity(e,t){let s={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:s.position=Ye(e);break;case 39:s.thickness=t.value;break;case 210:s.extrusionDirection=Ye(e);break;case 100:break;default:St(s,t,e);break}t=e.next()}return s}};var Hc=class{constructor(){this.ForEntityName="VERTEX"}parseEntity(e,t){var n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.x=t.value;break;case 20:n.y=t.value;break;case 30:n.z=t.value;break;case 40:break;case 41:break;case 42:t.value!=0&&(n.bulge=t.value);break;case 70:n.curveFittingVertex=(t.value&1)!==0,n.curveFitTangent=(t.value&2)!==0,n.splineVertex=(t.value&8)!==0,n.splineControlPoint=(t.value&16)!==0,n.threeDPolylineVertex=(t.value&32)!==0,n.threeDPolylineMesh=(t.value&64)!==0,n.polyfaceMeshVertex=(t.value&128)!==0;break;case 50:break;case 71:n.faceA=t.value;break;case 72:n.faceB=t.value;break;case 73:n.faceC=t.value;break;case 74:n.faceD=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var Gc=class{constructor(){this.ForEntityName="POLYLINE"}parseEntity(e,t){var n={type:t.value,vertices:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:break;case 20:break;case 30:break;case 39:n.thickness=t.value;break;case 40:break;case 41:break;case 70:n.shape=(t.value&1)!==0,n.includesCurveFitVertices=(t.value&2)!==0,n.includesSplineFitVertices=(t.value&4)!==0,n.is3dPolyline=(t.value&8)!==0,n.is3dPolygonMesh=(t.value&16)!==0,n.is3dPolygonMeshClosed=(t.value&32)!==0,n.isPolyfaceMesh=(t.value&64)!==0,n.hasContinuousLinetypePattern=(t.value&128)!==0;break;case 71:break;case 72:break;case 73:break;case 74:break;case 75:break;case 210:n.extrusionDirection=Ye(e);break;default:St(n,t,e);break}t=e.next()}return n.vertices=rP(e,t),n}};function rP(i,e){let t=new Hc,n=[];for(;!i.isEOF();)if(e.code===0){if(e.value==="VERTEX")n.push(t.parseEntity(i,e)),e=i.lastReadGroup;else if(e.value==="SEQEND"){oP(i,e);break}}return n}function oP(i,e){let t={type:e.value};for(e=i.next();!i.isEOF()&&e.code!=0;)St(t,e,i),e=i.next();return t}var Wc=class{constructor(){this.ForEntityName="SOLID"}parseEntity(e,t){let n={type:t.value,points:[]};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.points[0]=Ye(e);break;case 11:n.points[1]=Ye(e);break;case 12:n.points[2]=Ye(e);break;case 13:n.points[3]=Ye(e);break;case 210:n.extrusionDirection=Ye(e);break;default:St(n,t,e);break}t=e.next()}return n}};var Xc=class{constructor(){this.ForEntityName="SPLINE"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.controlPoints||(n.controlPoints=[]),n.controlPoints.push(Ye(e));break;case 11:n.fitPoints||(n.fitPoints=[]),n.fitPoints.push(Ye(e));break;case 12:n.startTangent=Ye(e);break;case 13:n.endTangent=Ye(e);break;case 40:n.knotValues||(n.knotValues=[]),n.knotValues.push(t.value);break;case 70:(t.value&1)!=0&&(n.closed=!0),(t.value&2)!=0&&(n.periodic=!0),(t.value&4)!=0&&(n.rational=!0),(t.value&8)!=0&&(n.planar=!0),(t.value&16)!=0&&(n.planar=!0,n.linear=!0);break;case 71:n.degreeOfSplineCurve=t.value;break;case 72:n.numberOfKnots=t.value;break;case 73:n.numberOfControlPoints=t.value;break;case 74:n.numberOfFitPoints=t.value;break;case 210:n.normalVector=Ye(e);break;default:St(n,t,e);break}t=e.next()}return n}};var qc=class{constructor(){this.ForEntityName="TEXT"}parseEntity(e,t){let n={type:t.value};for(t=e.next();!e.isEOF()&&t.code!==0;){switch(t.code){case 10:n.startPoint=Ye(e);break;case 11:n.endPoint=Ye(e);break;case 40:n.textHeight=t.value;break;case 41:n.xScale=t.value;break;case 50:n.rotation=t.value;break;case 1:n.text=t.value;break;case 72:n.halign=t.value;break;case 73:n.valign=t.value;break;default:St(n,t,e);break}t=e.next()}return n}};var pt=E0(Pb());pt.default.setLevel("error");function aP(i){i.registerEntityHandler(Ic),i.registerEntityHandler(Lc),i.registerEntityHandler(Oc),i.registerEntityHandler(Nc),i.registerEntityHandler(Dc),i.registerEntityHandler(Uc),i.registerEntityHandler(Fc),i.registerEntityHandler(kc),i.registerEntityHandler(Bc),i.registerEntityHandler(zc),i.registerEntityHandler(Vc),i.registerEntityHandler(Gc),i.registerEntityHandler(Wc),i.registerEntityHandler(Xc),i.registerEntityHandler(qc)}var Ha=class{constructor(){this._entityHandlers={},aP(this)}parse(e){return typeof e=="string"?this._parse(e):(console.error("Cannot read dxf source of type `"+typeof e),null)}registerEntityHandler(e){let t=new e;this._entityHandlers[t.ForEntityName]=t}parseSync(e){return this.parse(e)}parseStream(e){let t="",n=this;return new Promise((s,r)=>{e.on("data",o=>{t+=o}),e.on("end",()=>{try{s(n._parse(t))}catch(o){r(o)}}),e.on("error",o=>{r(o)})})}_parse(e){let t={},n=0,s=e.split(/\r\n|\r|\n/g),r=new Pc(s);if(!r.hasNext())throw Error("Empty file");let o=this,a;function l(){for(a=r.next();!r.isEOF();)if(a.code===0&&a.value==="SECTION"){if(a=r.next(),a.code!==2){console.error("Unexpected code %s after 0:SECTION",Ib(a)),a=r.next();continue}a.value==="HEADER"?(pt.default.debug("> HEADER"),t.header=c(),pt.default.debug("<")):a.value==="BLOCKS"?(pt.default.debug("> BLOCKS"),t.blocks=u(),pt.default.debug("<")):a.value==="ENTITIES"?(pt.default.debug("> ENTITIES"),t.entities=M(!1),pt.default.debug("<")):a.value==="TABLES"?(pt.default.debug("> TABLES"),t.tables=d(),pt.default.debug("<")):a.value==="EOF"?pt.default.debug("EOF"):pt.default.warn("Skipping section '%s'",a.value)}else a=r.next()}function c(){let y=null,p=null,w={};for(a=r.next();;){if(Es(a,0,"ENDSEC")){y&&(w[y]=p);break}else a.code===9?(y&&(w[y]=p),y=a.value):a.code===10?p={x:a.value}:a.code===20?p.y=a.value:a.code===30?p.z=a.value:p=a.value;a=r.next()}return a=r.next(),w}function u(){let y={};for(a=r.next();a.value!=="EOF"&&!Es(a,0,"ENDSEC");)if(Es(a,0,"BLOCK")){pt.default.debug("block {");let p=h();pt.default.debug("}"),S(p),p.name?y[p.name]=p:pt.default.error('block with handle "'+p.handle+'" is missing a name.')}else fo(a),a=r.next();return y}function h(){let y={};for(a=r.next();a.value!=="EOF";){switch(a.code){case 1:y.xrefPath=a.value,a=r.next();break;case 2:y.name=a.value,a=r.next();break;case 3:y.name2=a.value,a=r.next();break;case 5:y.handle=a.value,a=r.next();break;case 8:y.layer=a.value,a=r.next();break;case 10:y.position=b(a),a=r.next();break;case 67:y.paperSpace=!!(a.value&&a.value==1),a=r.next();break;case 70:a.value!=0&&(y.type=a.value),a=r.next();break;case 100:a=r.next();break;case 330:y.ownerHandle=a.value,a=r.next();break;case 0:if(a.value=="ENDBLK")break;y.entities=M(!0);break;default:fo(a),a=r.next()}if(Es(a,0,"ENDBLK")){a=r.next();break}}return y}function d(){let y={};for(a=r.next();a.value!=="EOF"&&!Es(a,0,"ENDSEC");)Es(a,0,"TABLE")?(a=r.next(),v[a.value]?(pt.default.debug(a.value+" Table {"),y[v[a.value].tableName]=g(a),pt.default.debug("}")):pt.default.debug("Unhandled Table "+a.value)):a=r.next();return a=r.next(),y}let f="ENDTAB";function g(y){let p=v[y.value],w={},T=0;for(a=r.next();!Es(a,0,f);)switch(a.code){case 5:w.handle=a.value,a=r.next();break;case 330:w.ownerHandle=a.value,a=r.next();break;case 100:a.value==="AcDbSymbolTable"||fo(a),a=r.next();break;case 70:T=a.value,a=r.next();break;case 0:a.value===p.dxfSymbolName?w[p.tableRecordsProperty]=p.parseTableRecords():(fo(a),a=r.next());break;default:fo(a),a=r.next()}let E=w[p.tableRecordsProperty];if(E){let C=(()=>{if(E.constructor===Array)return E.length;if(typeof E=="object")return Object.keys(E).length})();T!==C&&pt.default.warn("Parsed "+C+" "+p.dxfSymbolName+"'s but expected "+T)}return a=r.next(),w}function x(){let y=[],p={};for(pt.default.debug("ViewPort {"),a=r.next();!Es(a,0,f);)switch(a.code){case 2:p.name=a.value,a=r.next();break;case 10:p.lowerLeftCorner=b(a),a=r.next();break;case 11:p.upperRightCorner=b(a),a=r.next();break;case 12:p.center=b(a),a=r.next();break;case 13:p.snapBasePoint=b(a),a=r.next();break;case 14:p.snapSpacing=b(a),a=r.next();break;case 15:p.gridSpacing=b(a),a=r.next();break;case 16:p.viewDirectionFromTarget=b(a),a=r.next();break;case 17:p.viewTarget=b(a),a=r.next();break;case 42:p.lensLength=a.value,a=r.next();break;case 43:p.frontClippingPlane=a.value,a=r.next();break;case 44:p.backClippingPlane=a.value,a=r.next();break;case 45:p.viewHeight=a.value,a=r.next();break;case 50:p.snapRotationAngle=a.value,a=r.next();break;case 51:p.viewTwistAngle=a.value,a=r.next();break;case 79:p.orthographicType=a.value,a=r.next();break;case 110:p.ucsOrigin=b(a),a=r.next();break;case 111:p.ucsXAxis=b(a),a=r.next();break;case 112:p.ucsYAxis=b(a),a=r.next();break;case 110:p.ucsOrigin=b(a),a=r.next();break;case 281:p.renderMode=a.value,a=r.next();break;case 281:p.defaultLightingType=a.value,a=r.next();break;case 292:p.defaultLightingOn=a.value,a=r.next();break;case 330:p.ownerHandle=a.value,a=r.next();break;case 63:case 421:case 431:p.ambientColor=a.value,a=r.next();break;case 0:a.value==="VPORT"&&(pt.default.debug("}"),y.push(p),pt.default.debug("ViewPort {"),p={},a=r.next());break;default:fo(a),a=r.next();break}return pt.default.debug("}"),y.push(p),y}function m(){let y={},p={},w=0,T;for(pt.default.debug("LType {"),a=r.next();!Es(a,0,"ENDTAB");)switch(a.code){case 2:p.name=a.value,T=a.value,a=r.next();break;case 3:p.description=a.value,a=r.next();break;case 73:w=a.value,w>0&&(p.pattern=[]),a=r.next();break;case 40:p.patternLength=a.value,a=r.next();break;case 49:p.pattern.push(a.value),a=r.next();break;case 0:pt.default.debug("}"),w>0&&w!==p.pattern.length&&pt.default.warn("lengths do not match on LTYPE pattern"),y[T]=p,p={},pt.default.debug("LType {"),a=r.next();break;default:a=r.next()}return pt.default.debug("}"),y[T]=p,y}function _(){let y={},p={},w;for(pt.default.debug("Layer {"),a=r.next();!Es(a,0,"ENDTAB");)switch(a.code){case 2:p.name=a.value,w=a.value,a=r.next();break;case 62:p.visible=a.value>=0,p.colorIndex=Math.abs(a.value),p.color=lP(p.colorIndex),a=r.next();break;case 70:p.frozen=(a.value&1)!=0||(a.value&2)!=0,a=r.next();break;case 0:a.value==="LAYER"&&(pt.default.debug("}"),y[w]=p,pt.default.debug("Layer {"),p={},w=void 0,a=r.next());break;default:fo(a),a=r.next();break}return pt.default.debug("}"),y[w]=p,y}let v={VPORT:{tableRecordsProperty:"viewPorts",tableName:"viewPort",dxfSymbolName:"VPORT",parseTableRecords:x},LTYPE:{tableRecordsProperty:"lineTypes",tableName:"lineType",dxfSymbolName:"LTYPE",parseTableRecords:m},LAYER:{tableRecordsProperty:"layers",tableName:"layer",dxfSymbolName:"LAYER",parseTableRecords:_}};function M(y){let p=[],w=y?"ENDBLK":"ENDSEC";for(y||(a=r.next());;)if(a.code===0){if(a.value===w)break;let T=o._entityHandlers[a.value];if(T!=null){pt.default.debug(a.value+" {");let E=T.parseEntity(r,a);a=r.lastReadGroup,pt.default.debug("}"),S(E),p.push(E)}else{pt.default.warn("Unhandled entity "+a.value),a=r.next();continue}}else a=r.next();return w=="ENDSEC"&&(a=r.next()),p}function b(y){let p={},w=y.code;if(p.x=y.value,w+=10,y=r.next(),y.code!=w)throw new Error("Expected code for point value to be "+w+" but got "+y.code+".");return p.y=y.value,w+=10,y=r.next(),y.code!=w?(r.rewind(),p):(p.z=y.value,p)}function S(y){if(!y)throw new TypeError("entity cannot be undefined or null");y.handle||(y.handle=n++)}return l(),t}};function Es(i,e,t){return i.code===e&&i.value===t}function fo(i){pt.default.debug("unhandled group "+Ib(i))}function Ib(i){return i.code+":"+i.value}function lP(i){return yf[i]}var Lb=Ha;var cP=48;function Ob(i){hP(i);let e;try{e=new Lb().parseSync(i)?.entities??[]}catch(r){throw new bt(`This is not DXF that can be read: ${r instanceof Error?r.message:String(r)}.`)}let t=[],n=[];for(let r of e){let o=(r.vertices??[]).map(({x:a,y:l,z:c})=>[a,l,c??r.elevation??0]);if(r.type==="LINE"&&o.length>=2)t.push([o[0],o[1]]);else if((r.type==="LWPOLYLINE"||r.type==="POLYLINE")&&o.length>=2)n.push(ci(o,r.shape===!0));else if((r.type==="CIRCLE"||r.type==="ARC")&&r.center&&r.radius)n.push(uP(r));else if(r.type==="SPLINE"){let a=r.fitPoints?.length?r.fitPoints:r.controlPoints??[];a.length>=2&&n.push(ci(a.map(({x:l,y:c,z:u})=>[l,c,u??0]),r.closed===!0))}}let s=[...n,...t.length>0?ho(t):[]];if(s.length===0)throw new bt("This DXF file has no lines, polylines, arcs or splines.");return s}function uP({type:i,center:e,radius:t=0,startAngle:n=0,endAngle:s=0}){let r=i==="CIRCLE",o=r?2*Math.PI:(s-n+4*Math.PI)%(2*Math.PI)||2*Math.PI,a=Math.max(2,Math.ceil(cP*o/(2*Math.PI)));return{points:Array.from({length:r?a:a+1},(c,u)=>{let h=(r?0:n)+o*u/a;return[e.x+t*Math.cos(h),e.y+t*Math.sin(h),e.z??0]}),closed:r}}function hP(i){let e=i.replace(/\s+$/,"").split(/\r?\n/);for(let t=0;t+1<e.length;t+=2){let n=e[t].trim();if(!/^-?\d+$/.test(n))throw new bt(`${Ms(e[t])} is not a DXF group code.`,t+1);let s=Number(n);if(s>=10&&s<60&&!Number.isFinite(Number(e[t+1])))throw new bt(`${Ms(e[t+1])} is not a number.`,t+2)}}var dP=["FeatureCollection","Feature","GeometryCollection","LineString","MultiLineString","Polygon","MultiPolygon","Point","MultiPoint"],Nb=i=>dP.includes(String(i?.type));function Db(i,e){let t=[],n=[],s=a=>{let l=Array.isArray(a)?a:null;if(!l||l.length<2||!l.slice(0,3).every(c=>typeof c=="number"&&Number.isFinite(c))){let c=JSON.stringify(a)??"nothing";throw new bt(`${c.slice(0,40)} is not a position.`,e0(e,a))}return[l[0],l[1],l[2]??0]},r=a=>{if(!Array.isArray(a))throw new bt(`${(JSON.stringify(a)??"nothing").slice(0,40)} is not a list of positions.`,e0(e,a));return a},o=a=>{if(!a)return;let{type:l,coordinates:c}=a;if(l==="FeatureCollection")r(a.features).forEach(u=>o(u));else if(l==="Feature")o(a.geometry);else if(l==="GeometryCollection")r(a.geometries).forEach(u=>o(u));else if(l==="LineString")t.push(ci(r(c).map(s)));else if(l==="MultiLineString")r(c).forEach(u=>t.push(ci(r(u).map(s))));else if(l==="Polygon")r(c).forEach(u=>t.push(ci(r(u).map(s),!0)));else if(l==="MultiPolygon")r(c).forEach(u=>r(u).forEach(h=>t.push(ci(r(h).map(s),!0))));else if(l==="Point")n.push(s(c));else if(l==="MultiPoint")n.push(...r(c).map(s));else throw new bt(`GeoJSON has no type ${JSON.stringify(l)}.`,e0(e,l))};if(o(i),t.length===0&&n.length>1&&t.push(ci(n)),t.length===0)throw new bt("This GeoJSON has no lines or polygons.");return t}function e0(i,e){let t=JSON.stringify(e);if(!t)return;let n=[...t].map(r=>r.replace(/[.*+?^${}()|[\]\\]/g,"\\$&")).join("\\s*").slice(0,4e3),s=i.search(new RegExp(n));return s<0?void 0:i.slice(0,s).split(`
`).length}function fP(i){let e=JSON.parse(i),t=[],n=[],s=0;for(let{uri:c=""}of e.buffers??[]){let[,u]=/^data:[^,]*;base64,(.*)$/s.exec(c)??[];if(u===void 0)throw new Error("its data lies in another file; save it as GLB or with embedded buffers.");let h=Uint8Array.from(atob(u),d=>d.charCodeAt(0));t.push(s),n.push(h),s+=h.length+3&-4}for(let c of e.bufferViews??[])c.byteOffset=(c.byteOffset??0)+(t[c.buffer]??0),c.buffer=0;e.buffers=[{byteLength:s}];let r=new TextEncoder().encode(JSON.stringify(e)),o=r.length+3&-4,a=new Uint8Array(20+o+8+s).fill(32,20,20+o),l=new DataView(a.buffer);return[1179937895,2,a.length,o,1313821514].forEach((c,u)=>l.setUint32(4*u,c,!0)),a.set(r,20),l.setUint32(20+o,s,!0),l.setUint32(24+o,5130562,!0),n.forEach((c,u)=>a.set(c,28+o+t[u])),a.buffer}async function t0(i){let e=[];try{let t=await new Ta().parseAsync(typeof i=="string"?fP(i):i,"");t.scene.updateMatrixWorld(!0),t.scene.traverse(n=>{let s=n;if(!s.isLine)return;let r=yg(s),o=l=>new P().fromArray(r,l).applyMatrix4(s.matrixWorld).toArray(),a=[];for(let l=0;l<r.length;l+=6)a.push([o(l),o(l+3)]);a.length>0&&e.push(...ho(a,1e-6))})}catch(t){throw new bt(`This is not glTF that can be read: ${t instanceof Error?t.message:String(t)}`)}if(e.length===0)throw new bt("This glTF file has no lines.");return e}function Ub(i){let e=[],t=[],n=new Map;if(i.split(/\r?\n/).forEach((r,o)=>{let[a,...l]=r.replace(/#.*/,"").trim().split(/\s+/);if(!a)return;let c=u=>{let h=parseInt(u,10),d=h<0?e.length+h:h-1;if(!e[d])throw new bt(`there is no vertex ${Ms(u)}.`,o+1);return d};if(a==="v"){if(l.length<3)throw new bt("a vertex needs x, y and z.",o+1);e.push(l.slice(0,3).map(u=>_f(u,o+1)))}else if(a==="l")t.push(ci(l.map(u=>e[c(u)])));else if(a==="f"){let u=l.map(c);u.forEach((h,d)=>{let f=u[(d+1)%u.length],g=`${Math.min(h,f)} ${Math.max(h,f)}`;n.set(g,n.has(g)?null:[h,f])})}else if(!/^(vn|vt|vp|p|o|g|s|mtllib|usemtl|mg|cstype|deg|curv|curv2|surf|parm|end)$/.test(a))throw new bt(`${Ms(r)} is not OBJ.`,o+1)}),t.length>0)return t.length>1&&t.every(({points:r})=>r.length===2)?ho(t.map(({points:r})=>r)):t;let s=[...n.values()].filter(r=>r!==null);if(s.length>0)return ho(s.map(([r,o])=>[e[r],e[o]]));if(e.length>0)return[ci(e)];throw new bt("This OBJ file has no lines, no faces and no vertices.")}var Fb=".csv,.txt,.obj,.dxf,.geojson,.json,.gltf,.glb";async function n0(i){let e=new Uint8Array(await i.slice(0,4).arrayBuffer());return String.fromCharCode(...e)==="glTF"?{lines:await t0(await i.arrayBuffer()),format:"glTF",metres:!0}:i0(await i.text(),/\.(\w+)$/.exec(i.name)?.[1]?.toLowerCase()??"")}async function i0(i,e=""){if(i.trim()==="")throw new bt("There is nothing in it.");let t=i.trimStart();if(["json","geojson","gltf"].includes(e)||e===""&&/^[{[]/.test(t))return pP(i);if(e==="obj"||e===""&&/^\s*(v|l|o|g)\s/m.test(i))return{lines:Ub(i),format:"OBJ",metres:!1};if(e==="dxf"||e===""&&/^\s*(0|999)\s*\r?\n/.test(i))return{lines:Ob(i),format:"DXF",metres:!1};let n=Ab(i);if(n.length===0)throw new bt("There are no points in it.");return{lines:n,format:"CSV",metres:!1}}async function pP(i){let e=s0(i);if(Nb(e))return{lines:Db(e,i),format:"GeoJSON",metres:!1};if(e!==null&&typeof e=="object"&&"asset"in e)return{lines:await t0(i),format:"glTF",metres:!0};if(e===null||typeof e!="object"||Array.isArray(e))throw new bt("This JSON is neither a request nor GeoJSON nor glTF.");let t=e;if(!tl(t))throw new bt("This JSON is neither a request (with boundaries, directrices or a domain) nor GeoJSON nor glTF.");return{request:t}}function s0(i){try{return JSON.parse(i)}catch(e){let t=e instanceof Error?e.message:String(e),[,n]=/position (\d+)/.exec(t)??[],s=n===void 0?i.split(`
`).length:i.slice(0,Number(n)).split(`
`).length;throw new bt(`this is not JSON: ${t.replace(/ (in JSON )?at position.*$/,"")}.`,s)}}async function kb(i,e){return new Uint8Array(await new Response(new Blob([i]).stream().pipeThrough(e)).arrayBuffer())}async function Bb(i){let e=await kb(new TextEncoder().encode(JSON.stringify(i)),new CompressionStream("deflate-raw")),t="";for(let n=0;n<e.length;n+=32768)t+=String.fromCharCode(...e.subarray(n,n+32768));return btoa(t).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"")}async function zb(i){let e=Uint8Array.from(atob(i.replaceAll("-","+").replaceAll("_","/")),t=>t.charCodeAt(0));return JSON.parse(new TextDecoder().decode(await kb(e,new DecompressionStream("deflate-raw"))))}var Vb=async i=>`${Za}#s=${await Bb(i)}`;async function Hb(i){return`<iframe src="${Za}studio/embed.html#s=${await Bb(i)}" width="800" height="500" title="Plateau" loading="lazy"></iframe>`}var mP=i=>i.replaceAll("'",String.raw`'\''`);function Gb(i,e){let t=ru()?' -H "Authorization: Bearer $PLATEAU_KEY"':"",n=new URL(Or("/")).origin;return`# Posts the request, waits for its job, and saves the mesh as surface.glb.
job=$(curl -sS --fail-with-body -D - -o /dev/null${t} -H 'Content-Type: application/json' -X POST '${Or(Rt[i].path)}' --data-binary @- <<'JSON' | tr -d '\\r' | sed -n 's/^[Ll]ocation: //p'
${JSON.stringify(e)}
JSON
)
curl -sS --fail --retry 120 --retry-delay 1 --retry-all-errors${t} -o surface.glb "${mP(n)}$job/mesh?format=glb"
`}function Wb(i,e){let t=ru()?`,
    "Authorization": "Bearer " + os.environ["PLATEAU_KEY"]`:"";return`import json
import os
import time
import urllib.request

SERVER = "${new URL(Or("/")).origin}"
HEADERS = {
    "Content-Type": "application/json",
    "Prefer": "wait=30"${t},
}
REQUEST = json.loads(r"""${JSON.stringify(e)}""")


def call(url, body=None):
    data = None if body is None else json.dumps(body).encode()
    with urllib.request.urlopen(urllib.request.Request(url, data, HEADERS)) as answer:
        return answer.read()


job = json.loads(call("${Or(Rt[i].path)}", REQUEST))
while job["status"] in ("queued", "running"):
    time.sleep(0.2)
    job = json.loads(call(SERVER + job["links"]["self"]))
if job["status"] != "succeeded":
    raise SystemExit(job["error"])
print(json.dumps({k: v for k, v in job["statistics"].items() if isinstance(v, (int, float))}, indent=1))
with open("surface.glb", "wb") as file:
    file.write(call(SERVER + job["links"]["mesh"] + "?format=glb"))
`.replace(/^import os\n/m,t?`import os
`:"")}function Xb(i,e){let t=ru()?", Authorization: `Bearer ${process.env.PLATEAU_KEY}`":"";return`import { writeFile } from "node:fs/promises";

interface Job {
  status: "queued" | "running" | "succeeded" | "failed" | "cancelled";
  links: { self: string; mesh: string };
  error: unknown;
}

const server = "${new URL(Or("/")).origin}";
const headers = { "Content-Type": "application/json", Prefer: "wait=30"${t} };
const request = ${JSON.stringify(e)};

async function call(url: string, init: RequestInit = {}): Promise<Response> {
  const answer = await fetch(url, { ...init, headers });
  if (!answer.ok) throw new Error(await answer.text());
  return answer;
}

let job = (await (await call("${Or(Rt[i].path)}", { method: "POST", body: JSON.stringify(request) })).json()) as Job;
while (job.status === "queued" || job.status === "running") {
  job = (await (await call(server + job.links.self)).json()) as Job;
}
if (job.status !== "succeeded") throw new Error(JSON.stringify(job.error));
const mesh = await call(server + job.links.mesh + "?format=glb");
await writeFile("surface.glb", new Uint8Array(await mesh.arrayBuffer()));
`}var r0=i=>Yt.getJson(`v1/examples/${encodeURIComponent(i)}`),Yc=i=>Ur(()=>r0(i),e=>{let{kind:t,...n}=e.request;ws(),Ar(e.kind,n,e.title),vi(),za()||nn("Ready.")},li),qb=new Map,_P={ruled_surface:"wavy-strip",uniform_mesh:"vault"};function $b(i){let e=Ne();if(e.kind===i)return;qb.set(e.kind,{request:structuredClone(e.request),title:e.title});let t=qb.get(i),n=xi.examples.find(s=>s.kind===i);t?(Ar(i,t.request,t.title),vi()):n?Yc(_P[i]??n.name):Va(i)}var vf=(i,e)=>Ur(i,t=>{"lines"in t?yP(t.lines,t.format,t.metres,e):Kb(t.request,e)},(t,n)=>li({title:e?`${e} cannot be opened`:"This cannot be opened",detail:t instanceof Error?t.message:String(t)},n));function yP(i,e,t,n){let{kind:s,request:r}=Ne(),{line:o,least:a}=Rt[s],l=t?1/yo(r):1,c=i.map(({points:d})=>d.map(([f,g,x])=>{let m=t&&r.up!=="y"?[f,-x,g]:[f,g,x];return t?m.map(_=>Number((_*l).toPrecision(9))):m})),u=c.findIndex(d=>d.length<(s==="ruled_surface"?1:a));if(u>=0)throw new bt(`Line ${u+1} of the file has ${bi(c[u].length,"point")}; a ${o} needs ${a}.`);let h={...structuredClone(r)};for(let d of["normals","tangents","constraints","cables","free_points","supports"])delete h[d];if(typeof h.initial_mesh=="object"&&delete h.initial_mesh,s==="ruled_surface")Object.assign(h,{directrices:c,closed:i.length>1&&i.every(({closed:d})=>d)});else if(s==="minimal_surface"||s==="tensile_structure")h.boundaries=c;else if(s==="cable_net")Object.assign(h,xP(i.map(({closed:d},f)=>d?[...c[f],c[f][0]]:c[f])),{cables:[{force_density:1}],loads:[]});else{let d=[...c].sort((f,g)=>Yb(g)-Yb(f));h.domain={polygon:d[0],...d.length>1&&{holes:d.slice(1)}}}Ar(s,h,n||`${e} drawing`),vi(),Zs(`${e}: ${bi(c.length,"line")}, ${bi(c.reduce((d,f)=>d+f.length,0),"point")}. Undo brings back what was there.`)}function xP(i){let e=new Map,t=[],n=[],s=a=>{let l=a.join(" "),c=e.get(l)??t.length;return c===t.length&&(e.set(l,c),t.push(a),n.push(0)),n[c]+=1,c},r=i.flatMap(a=>a.slice(1).map((l,c)=>[s(a[c]),s(l)])),o=Math.min(...n);return{vertices:t,edges:r,supports:t.map((a,l)=>l).filter(a=>n[a]===o)}}var Yb=i=>{let e=[0,1,2].map(t=>Math.max(...i.map(n=>n[t]))-Math.min(...i.map(n=>n[t])));return Math.hypot(...e)};function Kb(i,e){let{kind:t,...n}=i,s=tl(i)??Ne().kind;if(t!==void 0&&!(String(t)in Rt))throw new bt(`This server has no kind ${JSON.stringify(t)}.`);Ar(s,n,e),vi()}function Jb(){let i=e=>{Y("request-fault").textContent=e,Y("request-fault").hidden=!1};try{let e=s0(Y("request").value);if(e===null||typeof e!="object"||Array.isArray(e)){i("A request is an object, { … }.");return}Kb(e.kind!==void 0||tl(e)?e:{...e,kind:Ne().kind},Ne().title),Y("request-form").reset()}catch(e){i(e instanceof Error?e.message:String(e))}}async function o0(){let[,i]=/^#s=(.+)$/.exec(location.hash)??[];if(!i)return null;try{let e=await zb(i);if(yi||window.history.replaceState(null,"",location.pathname+location.search),Fg(e))return e}catch{}return Zs("This link is damaged: it does not hold a request."),null}var jb=()=>Ur(o0,i=>{if(!i)return;let{kind:e,request:t,title:n,camera:s,colour:r}=i;ws(),ce.colour=r??"plain",Ar(e,t,n??null),s&&sf(s),vi(),Oi(e,t)||nn("")},li);async function Zb(){let i=Y("recent-list");i.replaceChildren(te("p",{className:"quiet"},"Asking the server…")),Y("recent").showModal();try{let{jobs:e}=await Yt.getJson("v1/jobs?limit=30"),t=new Map(Bg().map(s=>[s.id,s])),n=e.map(s=>{let r=t.get(s.id),o=te("button",{type:"button",disabled:!["succeeded","running","queued"].includes(s.status)},"Open");return o.setAttribute("aria-label",`Open ${r?.title??s.kind} of ${s.created_at}`),o.addEventListener("click",()=>{Y("recent").close(),vP(s,r)}),te("tr",{},te("th",{scope:"row"},r?.title??Rt[s.kind].label),te("td",{},s.status),te("td",{},new Date(s.created_at).toLocaleString()),te("td",{},o))});i.replaceChildren(n.length>0?te("table",{className:"plain"},te("tbody",{},...n)):te("p",{className:"quiet"},"No jobs yet."))}catch(e){i.replaceChildren(te("p",{className:"fault"},e instanceof Error?e.message:String(e)))}}var vP=(i,e)=>Ur(async()=>{let t=await Yt.getJson(`v1/jobs/${i.id}`),n=e||t.status!=="succeeded"?null:await Aa(await Yt.download(t.id,"glb"));return{job:t,mesh:n}},({job:t,mesh:n})=>{e?(ws(),Ar(e.kind,JSON.parse(e.request),e.title),mb(t)):n?bP(t,n):nn("This job has no result yet, and this browser does not know its drawing.")},li);function bP(i,e){Cc(),ce.viewing=!0,ws();let{unit:t,up:n}=e.extras,s={units:t,up:n},[r,o,a]=e.extras.origin??[0,0,0];ot.frame=new Di([r,o,a],s),bs(),uf(i,e,JSON.stringify(s)),He.fit(!1,ef),pf()}var SP={kind:"minimal_surface",title:"A saddle canopy",request:{boundaries:[Array.from({length:24},(i,e)=>{let t=e*Math.PI/12;return[7*Math.cos(t),5.5*Math.sin(t),2.6+2*Math.cos(2*t)].map(n=>Number(n.toFixed(3)))})],objective:"minimal_area",resolution:{triangles:2e3}}},a0=()=>new URLSearchParams(location.search).get("example"),bf=()=>xo(async()=>{let i=Si();Ua(i);try{await Promise.all([wP(),EP()])}catch(e){li(e,i),nn("Not ready."),e instanceof Ir&&Y("settings").showModal()}});function wP(){let i=JSON.stringify(Ne());return Ur(MP,({found:e,example:t})=>{if(JSON.stringify(Ne())!==i)return;if(e){TP(e);return}let{kind:n,title:s,request:{kind:r,...o}}=t??SP;Object.assign(ti.document,{kind:n,request:o,title:s}),Tr(),Y("intro").hidden=t!==null,Ss(),Qs()},e=>{throw e})}async function MP(){let i=await o0()??(a0()!==null||yi?null:Hv()),e=i||a0()===null?null:await r0(a0()).catch(t=>{if(t instanceof As)return null;throw t});return{found:i,example:e}}async function EP(){let[i,{objectives:e},{examples:t}]=await Promise.all([Yt.getJson("openapi.json"),Yt.objectives(),Yt.getJson("v1/examples")]);Object.assign(xi,{openapi:i,objectives:e,examples:t}),AP(),ff(),Y("gallery-list").replaceChildren(...W0(t,({name:n})=>{Y("gallery").close(),Yc(n)})),ce.ready=!0,qi()}function TP({kind:i,request:e,draft:t,title:n,camera:s,colour:r,phase:o,job:a}){Object.assign(ti.document,{kind:i,request:e,draft:t??null,title:n??null}),ce.colour=r??"plain",Tr(),s&&sf(s),o==="cancelled"?(ce.requests.wasCancelled(i,JSON.stringify(e)),nn("Cancelled.")):a?gb(a):Oi(i,e)&&Ne().draft===null&&Qs()}function AP(){let i=Object.keys(Rt).filter(t=>hu(xi.openapi,Rt[t].path)),e=Y("kinds").querySelector("legend");Y("kinds").replaceChildren(e,...i.map(t=>{let n=te("input",{type:"radio",name:"kind",value:t});return n.addEventListener("change",()=>$b(t)),te("label",{},n,Rt[t].label)})),Y("blank-starts").replaceChildren(...i.filter(t=>Rt[t].lines.length>0).map(t=>te("button",{type:"button",onclick:()=>{Y("gallery").close(),Va(t)}},`Draw a ${Rt[t].label.toLowerCase()}`)))}var Qb="theme";function eS(){return localStorage.getItem(Qb)??(matchMedia("(prefers-color-scheme: dark)").matches?"dark":"light")}function l0(i){document.documentElement.dataset.theme=i,Y("theme").setAttribute("aria-pressed",String(i==="dark"));let e=tf[i];Object.assign(Sc,e.look),On.restyle(e.sketch),He.grid.style(...e.grid),He.shadow.style(e.shadow),$t.restyle(),Fa.restyle(),bs(),He.invalidate()}function tS(){let i=document.documentElement.dataset.theme==="dark"?"light":"dark";l0(i),localStorage.setItem(Qb,i)}var RP=["Link","Embed","curl","Python","TypeScript"],c0=0;async function nS(){await iS("Link"),Y("share").showModal()}async function iS(i){c0+=1;let e=c0,{kind:t,request:n,title:s}=Ne(),r={kind:t,request:n,title:s,camera:kg(),colour:ce.colour},o=i==="Link"?await Vb(r):i==="Embed"?await Hb(r):i==="curl"?Gb(t,n):i==="Python"?Wb(t,n):Xb(t,n);e===c0&&(Y("share-forms").replaceChildren(...RP.map(a=>te("button",{type:"button","aria-pressed":String(a===i),onclick:()=>{iS(a)}},a))),Y("share-text").value=o,Y("copied").textContent="")}async function sS(){try{await navigator.clipboard.writeText(Y("share-text").value),Y("copied").textContent="Copied."}catch{Y("share-text").select(),Y("copied").textContent="Press Ctrl C: the browser does not let this page copy."}}async function rS(){_o(await He.picture(2,document.documentElement.dataset.theme==="dark"?"#1a2023":"#f3f4f3"),"plateau.png")}var u0="api-key",ht=(i,e,t)=>Y(i).addEventListener(e,n=>{t(n)}),Sf=i=>document.querySelectorAll(i);function aS(){CP(),PP(),LP(),OP(),NP(),document.addEventListener("keydown",DP),window.addEventListener("pagehide",Mc),window.addEventListener("hashchange",()=>{location.hash.startsWith("#s=")&&ce.ready&&jb()})}function h0(i){document.querySelector("main").dataset.panel=i;for(let e of Sf("[data-panel]:is(button)"))e.setAttribute("aria-pressed",String(e.dataset.panel===i))}function CP(){ht("solve","click",()=>(ce.viewing&&(ce.viewing=!1,Tr({refit:!1})),Oi(Ne().kind,Ne().request)?Qs():nn(Og()))),ht("cancel","click",bb),ht("live","change",()=>za()&&Mr()&&Qs()),Y("request-box").querySelector("summary").addEventListener("click",mf),ht("request-box","toggle",mf),ht("request-form","input",()=>{Y("discard-request").hidden=!1}),ht("request-form","reset",()=>{for(let i of["discard-request","request-fault"])Y(i).hidden=!0}),ht("apply-request","click",Jb),ht("save-request","click",()=>_o(new Blob([cu({kind:Ne().kind,...Ne().request})],{type:"application/json"}),`${Ne().kind.replaceAll("_","-")}.json`));for(let i of Sf("[data-panel]:is(button)"))i.addEventListener("click",()=>h0(i.dataset.panel));for(let i of["point","options","key-form","drawing","cable"])ht(i,"submit",e=>e.preventDefault())}function PP(){ht("cabling","click",()=>Be.cabling?Be.stopCabling():Be.startCabling()),ht("draw","click",()=>Be.drawing?Be.stopDrawing():Be.startDrawing()),ht("undo","click",jg),ht("redo","click",gf),ht("finish","click",()=>Be.finishDrawing()),ht("give-up","click",()=>Be.stopDrawing()),ht("snap","change",()=>{Be.snapping=Y("snap").checked}),ht("level","change",()=>{Be.level=Y("level").valueAsNumber||0}),ht("previous-point","click",()=>Be.step(-1)),ht("next-point","click",()=>Be.step(1)),ht("insert-point","click",()=>Be.insert()),ht("delete-point","click",()=>Be.remove()),ht("remove-line","click",()=>Be.removeLine()),ht("cable-from-point","click",()=>Be.cableFromPoint()),ht("drop-cable","click",()=>Be.dropCable()),IP(),ht("intro-draw","click",()=>Va("minimal_surface"));for(let e of document.querySelectorAll("#point input"))e.addEventListener("input",()=>{e.dataset.dirty="1"}),e.addEventListener("blur",()=>{delete e.dataset.dirty}),e.addEventListener("change",()=>{delete e.dataset.dirty;let t=Cf(e.value);Number.isFinite(t)?e.id==="edge"?Be.setEdgeBefore(t):Be.setAxis(Number(e.dataset.axis),t):(e.value.trim()!==""&&Zs(`${JSON.stringify(e.value)} is not a number.`),Ng())});let i=Y("entry");i.addEventListener("keydown",e=>{if(e.key!=="Enter")return;if(e.preventDefault(),e.stopPropagation(),i.value.trim()===""){Be.finishDrawing();return}let t=Be.enter(i.value);t?Zs(t):i.value=""})}function IP(){let i=e=>{ti.edit(({request:n})=>{let s=hs(n)[Be.cable];s&&e(s,n)})&&vi()};ht("cable-mode","change",()=>{let{value:e}=Y("cable-mode"),t=Dv();i((n,s)=>mx(s,n,e,t))});for(let[e,t]of[["cable-value",(n,s)=>{n.value=s}],["cable-stiffness",(n,s)=>{n.axial_stiffness=s}]]){let n=Y(e);n.addEventListener("input",()=>{n.dataset.dirty="1"}),n.addEventListener("blur",()=>{delete n.dataset.dirty}),n.addEventListener("change",()=>{delete n.dataset.dirty;let s=Cf(n.value);s>0?i(r=>t(r,s)):e==="cable-stiffness"&&n.value.trim()===""?i(r=>{delete r.axial_stiffness}):Zs(`${JSON.stringify(n.value)} is not a number above 0.`),Ss()})}}function LP(){let i={top:[0,1,.001],front:[0,.02,1],side:[1,.02,0]};for(let e of Sf("[data-view]"))e.addEventListener("click",()=>{let t=i[e.dataset.view];t?He.look(t):$v()});for(let e of Sf("[data-mode]"))e.addEventListener("click",()=>uo(e.dataset.mode));ht("quantity","change",()=>{ce.colour=Y("quantity").value,Er(null),hb(),He.invalidate(),qi()}),ht("theme","click",tS)}function OP(){let i=Y("file");i.accept=Fb,ht("open-file","click",()=>i.click()),ht("file","change",async()=>{let[e]=i.files??[];e&&await vf(()=>n0(e),e.name),i.value=""}),document.addEventListener("dragover",e=>{e.preventDefault(),document.body.classList.add("dropping")}),document.addEventListener("dragleave",e=>{e.relatedTarget||document.body.classList.remove("dropping")}),document.addEventListener("drop",e=>{e.preventDefault(),document.body.classList.remove("dropping"),oS(e.dataTransfer)}),document.addEventListener("paste",e=>{!e.target.matches("input, textarea")&&oS(e.clipboardData)&&e.preventDefault()})}function oS(i){let[e]=i?.files??[],t=i?.getData("text/plain")??"";if(e)vf(()=>n0(e),e.name);else if(t.trim()!=="")vf(()=>i0(t),"");else return!1;return!0}function NP(){let i=()=>Y("gallery").showModal();ht("open-gallery","click",i),ht("intro-gallery","click",i),ht("open-recent","click",Zb),ht("open-share","click",nS),ht("open-settings","click",()=>Y("settings").showModal()),ht("copy","click",sS),ht("picture","click",rS);for(let n of document.querySelectorAll("dialog"))n.querySelector("[data-close]").addEventListener("click",()=>n.close()),n.addEventListener("click",s=>{s.target===n&&n.close()});let e=Y("api-key"),t=sessionStorage.getItem(u0);t&&(e.value=t,Tf(t)),e.addEventListener("change",()=>{Tf(e.value),e.value?sessionStorage.setItem(u0,e.value):sessionStorage.removeItem(u0),Y("settings").close(),ce.ready||bf()})}function DP(i){let e=i.target,t=e.matches('input:not([type="radio"], [type="checkbox"]), textarea, select')||document.querySelector("dialog[open]")!==null,n=i.ctrlKey||i.metaKey,s=i.key.toLowerCase();if(n&&!t&&s==="z")(i.shiftKey?gf:jg)();else if(n&&!t&&s==="y")gf();else if(Be.drawing&&i.key==="Enter"&&!e.matches("button, summary, a"))Be.finishDrawing();else if(Be.drawing&&i.key==="Escape")Be.stopDrawing();else if(Be.cabling&&i.key==="Escape")Be.stopCabling();else if(Be.drawing&&!t&&!n&&/^[\d.,@-]$/.test(i.key)){let r=Y("entry");r.focus(),r.value+=i.key}else return;i.preventDefault()}Object.assign(ot,{changed:i=>vi({dragging:i}),selectionChanged:Ss,label:Er,read:kv,readLine:Bv,announce:Fv});Fa.use=Mb;He.under=(i,e)=>$t.pick(He,i,e)?.point??null;He.content=()=>[...On.places,...$t.outline()];He.onDraw=()=>{Jg.place(),Dg()};He.onRest=()=>{He.rememberWhetherAllIsSeen(),qi()};Y("no-webgl").hidden=He.renderer!==null;yi&&new URLSearchParams(location.search).get("ground")==="none"&&(He.grid.mesh.visible=!1);aS();l0(eS());h0("setup");Y("look").hidden=!0;bf();Object.assign(window,{studio:{request:()=>structuredClone(Ne().request),kind:()=>Ne().kind,draft:()=>structuredClone(Ne().draft),shown:()=>ce.shown?{job:ce.shown.job.id,solved:ce.shown.solved,stale:Mr()}:null,faulty:()=>[...ot.faulty],selection:()=>Be.selection,points:()=>On.places.map(i=>He.project(i)),project:i=>He.project(ot.frame.toScene(i)),covers:(i,e)=>$t.pick(He,i,e)!==null,fit:()=>He.fit(!1),draw:()=>He.draw(),isAtRest:()=>He.isAtRest,openExample:Yc}});
