var F_=Object.create;var fh=Object.defineProperty;var B_=Object.getOwnPropertyDescriptor;var k_=Object.getOwnPropertyNames;var z_=Object.getPrototypeOf,V_=Object.prototype.hasOwnProperty;var CE=(i,e)=>()=>{try{return e||i((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}},RE=(i,e)=>{for(var t in e)fh(i,t,{get:e[t],enumerable:!0})},H_=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of k_(e))!V_.call(i,s)&&s!==t&&fh(i,s,{get:()=>e[s],enumerable:!(n=B_(e,s))||n.enumerable});return i};var PE=(i,e,t)=>(t=i!=null?F_(z_(i)):{},H_(e||!i||!i.__esModule?fh(t,"default",{value:i,enumerable:!0}):t,i));function ee(i){let e=document.getElementById(i);if(!e)throw new Error(`the page has no element #${i}`);return e}function ft(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r!=null&&(s.startsWith("on")&&typeof r=="function"?n.addEventListener(s.slice(2),r):s in n?n[s]=r:n.setAttribute(s,String(r)));return n.append(...t.filter(s=>s!=null&&s!==!1)),n}var G_="http://www.w3.org/2000/svg";function Ui(i,e={},...t){let n=document.createElementNS(G_,i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.append(...t),n}function af(i,e){let t=URL.createObjectURL(i),n=ft("a",{href:t,download:e});document.body.append(n),n.click(),n.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}var kt={minimal_surface:{path:"/v1/minimal-surfaces",label:"Film",noun:"film",line:"boundary",lines:["boundaries"],least:3,purpose:"A membrane of least area on its boundary"},ruled_surface:{path:"/v1/ruled-surfaces",label:"Strip",noun:"strip",line:"rail",lines:["directrices"],least:2,purpose:"A ruled strip between two rails"},uniform_mesh:{path:"/v1/uniform-meshes",label:"Lattice",noun:"lattice",line:"hole",lines:["domain","holes"],least:3,purpose:"A gridshell or floor of equal members"},tensile_structure:{path:"/v1/tensile-structures",label:"Tensile",noun:"tensile structure",line:"boundary",lines:["boundaries"],least:3,purpose:"A film with cables, pressure and weight in equilibrium"},cable_net:{path:"/v1/cable-nets",label:"Net",noun:"cable net",line:"net",lines:[],least:2,purpose:"A net of cables with target forces and lengths"}},lf={mm:.001,cm:.01,m:1,in:.0254,ft:.3048},en=i=>{let e=String(Os(i.units)?.length??i.units);return e in lf?e:"m"},Or=i=>lf[en(i)]??1,OE=i=>i.up==="y"?1:2,ph=i=>typeof i=="number"&&Number.isFinite(i),cf=i=>Array.isArray(i)&&i.length===3&&i.every(ph);function je(i){return!Array.isArray(i)||!i.some(ph)?null:[0,1,2].map(e=>ph(i[e])&&Math.abs(i[e])<1e150?i[e]:0)}function ia(i,e){let t=[],n=(o,a,l,c,h=!1)=>{Array.isArray(l)&&t.push({name:o,path:a,points:l,closed:c,planar:h})},s=(o,a,l,c,h=!1)=>{Array.isArray(l)&&l.forEach((u,d)=>n(`${o} ${d+1}`,[...a,d],u,c,h))};if(i==="ruled_surface"&&s("rail",["directrices"],e.directrices,e.closed===!0),i==="tensile_structure"){s("boundary",["boundaries"],e.boundaries,!0);let o=l=>Array.isArray(l)?l.map(c=>Os(c)??{}):[],a=new Set([e.boundaries,[e.joints],[o(e.rings).map(({hub:l})=>l)]].flat(2).filter(Array.isArray).map(String));for(let l of["masts","cables"])o(e[l]).forEach(({name:c,points:h},u)=>{let d=new Set([0,1].filter(m=>Array.isArray(h)&&!a.has(String(h[m]))));Array.isArray(h)&&d.size>0&&t.push({name:typeof c=="string"?c:`${hf(l)} ${u+1}`,path:[l,u,"points"],points:h,closed:!1,planar:!1,only:d})})}if(i==="cable_net"&&Array.isArray(e.vertices)){let o=new Set((Array.isArray(e.supports)?e.supports:[]).filter(Number.isInteger));t.push({name:"vertices",path:["vertices"],points:e.vertices,closed:!1,planar:!1,only:o})}if(i==="minimal_surface"){s("boundary",["boundaries"],e.boundaries,!0);let o=Os(e.constraints);s("rope",["constraints","polylines"],o?.polylines,!1),Array.isArray(o?.points)&&o.points.length>0&&n("fixed points",["constraints","points"],o.points,!1)}let r=Os(e.domain);if(r){n("polygon",["domain","polygon"],r.polygon,!0,!0),s("hole",["domain","holes"],r.holes,!0,!0),s("boundary",["domain","boundaries"],r.boundaries,!0);for(let o of["bezier","nurbs"])s("control row",["domain",o,"control_points"],Os(r[o])?.control_points,!1)}return t}var Os=i=>i!==null&&typeof i=="object"&&!Array.isArray(i)?i:null,as=i=>i.only!==void 0||i.path[0]==="constraints"&&i.path[1]==="points",Dr=(i,e)=>i.only?.has(e)??!0;function ls(i,e){return e.reduce((t,n)=>t?.[n],i)}var W_={vertices:"vertex",boundaries:"boundary",directrices:"rail"},hf=i=>W_[i]??i.replace(/s$/,"").replaceAll("_"," "),X_=i=>i.flatMap((e,t)=>{let n=/^\d+$/.test(i[t+1]??"");if(!/^\d+$/.test(e))return n?[]:[e.replaceAll("_"," ")];let s=i[t-1]??"";return[`${/^\d*$/.test(s)?"":`${hf(s)} `}${Number(e)+1}`]});function mh(i,e){let t=e.split("/").slice(1).map(l=>l.replaceAll("~1","/").replaceAll("~0","~")),n=i.findIndex(l=>l.path.every((c,h)=>String(c)===t[h]));if(n<0){let l=/^(normals|tangents)$/.test(t[0]??"")?i.findIndex(c=>c.path[0]==="directrices"&&String(c.path[1])===t[1]):-1;return l>=0&&/^\d+$/.test(t[2]??"")?{text:`${t[0]} of ${i[l].name}, point ${Number(t[2])+1}`,line:l,point:Number(t[2]),field:t[0]}:{text:X_(t).join(", ")||"the request",...t[0]!==void 0&&{field:t[0]}}}let s=i[n],[r,o]=t.slice(s.path.length).map(Number);if(r===void 0||!Number.isInteger(r))return{text:s.name,line:n};let a=o===void 0?"":`, ${"xyz"[o]??"coordinate"}`;return{text:`${s.name}, point ${r+1}${a}`,line:n,point:Math.min(r,s.points.length-1),...o!==void 0&&{axis:o}}}function sa(i){return i==="ruled_surface"?{directrices:[]}:i==="uniform_mesh"?{domain:{},edge_length:1}:i==="tensile_structure"?{boundaries:[],film:{tension:1}}:i==="cable_net"?{vertices:[],edges:[],supports:[],cables:[{force_density:1}]}:{boundaries:[]}}function ra(i,e){let t=ia(i,e);return i==="ruled_surface"?t.length>=2:i==="cable_net"?Array.isArray(e.edges)&&e.edges.length>0:t.length>=1||i==="uniform_mesh"&&Object.keys(Os(e.domain)??{}).length>0}function DE(i){return typeof i.kind=="string"?i.kind in kt?i.kind:null:"boundaries"in i?"minimal_surface":"directrices"in i?"ruled_surface":"edges"in i?"cable_net":"domain"in i?"uniform_mesh":null}var uf=i=>JSON.stringify(i,null,1).replace(/\[\s+([^[\]{}]*?)\s+\]/g,(e,t)=>`[${t.replace(/\s+/g," ")}]`);var On=class{origin;metres;up;constructor(e,t){this.origin=e,this.metres=Or(t),this.up=t.up==="y"?1:2}toScene(e){let[t,n,s]=[0,1,2].map(r=>((e[r]??0)-this.origin[r])*this.metres);return this.up===2?[t,s,-n]:[t,n,s]}fromScene([e,t,n]){return(this.up===2?[e,-n,t]:[e,t,n]).map((r,o)=>r/this.metres+this.origin[o])}length(e){return e/this.metres}},q_=50;function df(i,e){let t=[1/0,1/0,1/0],n=[-1/0,-1/0,-1/0];for(let a of i)for(let l of a.points){let c=je(l);if(c)for(let h=0;h<3;h+=1)t[h]=Math.min(t[h],c[h]),n[h]=Math.max(n[h],c[h])}if(!Number.isFinite(t[0]))return[0,0,0];let s=Math.max(...t.map((a,l)=>n[l]-a))||1,r=10**Math.ceil(Math.log10(s)),o=e.up==="y"?1:2;return t.map((a,l)=>{let c=l===o?a:(a+n[l])/2;return Math.abs(c)>q_*s?Math.round(c/r)*r:0})}var oa=class{document;past=[];future=[];opened=null;constructor(e){this.document=e}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}begin(){this.opened??=JSON.stringify(this.document)}commit(){let e=this.opened;if(this.opened=null,e===null||e===JSON.stringify(this.document))return!1;this.past.push(e),this.future=[];let t=this.past.reduce((n,s)=>n+s.length,0);for(;this.past.length>500||t>4e7&&this.past.length>1;)t-=this.past.shift().length;return!0}abandon(){this.opened!==null&&(this.document=JSON.parse(this.opened)),this.opened=null}edit(e){let t=this.opened!==null;return this.begin(),e(this.document),t||this.commit()}amend(e){e(this.document)}undo(){return this.step(this.past,this.future)}redo(){return this.step(this.future,this.past)}step(e,t){this.opened!==null&&this.commit();let n=e.pop();return n===void 0?!1:(t.push(JSON.stringify(this.document)),this.document=JSON.parse(n),!0)}};var Yf=0,$h=1,Jf=2;var po=1,Zf=2,lr=3,Ji=0,dn=1,qt=2,oi=0,cr=1,Yh=2,Jh=3,Zh=4,Kf=5;var gs=100,jf=101,Qf=102,ep=103,tp=104,np=200,ip=201,sp=202,rp=203,Kh=204,jh=205,op=206,ap=207,lp=208,cp=209,hp=210,up=211,dp=212,fp=213,pp=214,Da=0,Na=1,Ua=2,Zs=3,Fa=4,Ba=5,ka=6,za=7,ml=0,mp=1,gp=2,ai=0,Qh=1,eu=2,tu=3,nu=4,iu=5,su=6,mo=7;var ru=300,_s=301,hr=302,gl=303,_l=304,Va=1e3,ni=1001,Ha=1002,Ht=1003,_p=1004;var go=1005;var hn=1006,yl=1007;var Ai=1008;var xn=1009,ou=1010,au=1011,ur=1012,xl=1013,qn=1014,$n=1015,Yn=1016,vl=1017,bl=1018,ys=1020,lu=35902,cu=35899,hu=1021,uu=1022,Jn=1023,Ei=1026,Ci=1027,du=1028,Sl=1029,Zi=1030,Ml=1031;var wl=1033,_o=33776,yo=33777,xo=33778,vo=33779,El=35840,Tl=35841,Al=35842,Cl=35843,Rl=36196,Pl=37492,Il=37496,Ll=37488,Ol=37489,bo=37490,Dl=37491,Nl=37808,Ul=37809,Fl=37810,Bl=37811,kl=37812,zl=37813,Vl=37814,Hl=37815,Gl=37816,Wl=37817,Xl=37818,ql=37819,$l=37820,Yl=37821,Jl=36492,Zl=36494,Kl=36495,jl=36283,Ql=36284,So=36285,ec=36286;var Gr=2300,Ga=2301,La=2302,Bh=2303,kh=2400,zh=2401,Vh=2402;var yp=3200;var Mo=0,xp=1,Ri="",En="srgb",Wr="srgb-linear",Xr="linear",at="srgb";var Oa=7680;var vp=519,bp=512,Sp=513,Mp=514,fu=515,wp=516,Ep=517,pu=518,mu=519,gu=35044;var _u="300 es",Nn=2e3,Ks=2001;function $_(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Y_(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function qr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Tp(){let i=qr("canvas");return i.style.display="block",i}var ff={},js=null;function $r(...i){let e="THREE."+i.shift();js?js("log",e,...i):console.log(e,...i)}function Ap(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Re(...i){i=Ap(i);let e="THREE."+i.shift();if(js)js("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function De(...i){i=Ap(i);let e="THREE."+i.shift();if(js)js("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function zr(...i){let e=i.join(" ");e in ff||(ff[e]=!0,Re(...i))}function Cp(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Rp={[Da]:Da,[Ua]:ka,[Fa]:Fa,[Zs]:Ba,[Na]:Na,[ka]:Ua,[za]:za,[Ba]:Zs},ii=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},tn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],pf=1234567,Vr=Math.PI/180,Qs=180/Math.PI;function Ki(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(tn[i&255]+tn[i>>8&255]+tn[i>>16&255]+tn[i>>24&255]+"-"+tn[e&255]+tn[e>>8&255]+"-"+tn[e>>16&15|64]+tn[e>>24&255]+"-"+tn[t&63|128]+tn[t>>8&255]+"-"+tn[t>>16&255]+tn[t>>24&255]+tn[n&255]+tn[n>>8&255]+tn[n>>16&255]+tn[n>>24&255]).toLowerCase()}function ze(i,e,t){return Math.max(e,Math.min(t,i))}function yu(i,e){return(i%e+e)%e}function J_(i,e,t,n,s){return n+(i-e)*(s-n)/(t-e)}function Z_(i,e,t){return i!==e?(t-i)/(e-i):0}function Hr(i,e,t){return(1-t)*i+t*e}function K_(i,e,t,n){return Hr(i,e,1-Math.exp(-t*n))}function j_(i,e=1){return e-Math.abs(yu(i,e*2)-e)}function Q_(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function e0(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function t0(i,e){return i+Math.floor(Math.random()*(e-i+1))}function n0(i,e){return i+Math.random()*(e-i)}function i0(i){return i*(.5-Math.random())}function s0(i){i!==void 0&&(pf=i);let e=pf+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function r0(i){return i*Vr}function o0(i){return i*Qs}function a0(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function l0(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function xu(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function c0(i,e,t,n,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+n)/2),h=o((e+n)/2),u=r((e-n)/2),d=o((e-n)/2),m=r((n-e)/2),g=o((n-e)/2);switch(s){case"XYX":i.set(a*h,l*u,l*d,a*c);break;case"YZY":i.set(l*d,a*h,l*u,a*c);break;case"ZXZ":i.set(l*u,l*d,a*h,a*c);break;case"XZX":i.set(a*h,l*g,l*m,a*c);break;case"YXY":i.set(l*m,a*h,l*g,a*c);break;case"ZYZ":i.set(l*g,l*m,a*h,a*c);break;default:Re("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function tc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function vu(i,e){if(e.constructor===Float32Array)return i;let t=tc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function bu(i,e){if(e.constructor===Float32Array)return i;let t=tc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Su={DEG2RAD:Vr,RAD2DEG:Qs,generateUUID:Ki,clamp:ze,euclideanModulo:yu,mapLinear:J_,inverseLerp:Z_,lerp:Hr,damp:K_,pingpong:j_,smoothstep:Q_,smootherstep:e0,randInt:t0,randFloat:n0,randFloatSpread:i0,seededRandom:s0,degToRad:r0,radToDeg:o0,isPowerOfTwo:a0,ceilPowerOfTwo:l0,floorPowerOfTwo:xu,setQuaternionFromProperEuler:c0,normalize:bu,denormalize:vu},He=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ze(this.x,e.x,t.x),this.y=ze(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ze(this.x,e,t),this.y=ze(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ze(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ze(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Un=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],m=r[o+1],g=r[o+2],y=r[o+3];if(u!==y||l!==d||c!==m||h!==g){let p=l*d+c*m+h*g+u*y;p<0&&(d=-d,m=-m,g=-g,y=-y,p=-p);let f=1-a;if(p<.9995){let x=Math.acos(p),w=Math.sin(x);f=Math.sin(f*x)/w,a=Math.sin(a*x)/w,l=l*f+d*a,c=c*f+m*a,h=h*f+g*a,u=u*f+y*a}else{l=l*f+d*a,c=c*f+m*a,h=h*f+g*a,u=u*f+y*a;let x=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=x,c*=x,h*=x,u*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=u}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],u=r[o],d=r[o+1],m=r[o+2],g=r[o+3];return e[t]=a*g+h*u+l*m-c*d,e[t+1]=l*g+h*d+c*u-a*m,e[t+2]=c*g+h*m+a*d-l*u,e[t+3]=h*g-a*u-l*d-c*m,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),u=a(r/2),d=l(n/2),m=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u-d*m*g;break;case"YXZ":this._x=d*h*u+c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u+d*m*g;break;case"ZXY":this._x=d*h*u-c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u-d*m*g;break;case"ZYX":this._x=d*h*u-c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u+d*m*g;break;case"YZX":this._x=d*h*u+c*m*g,this._y=c*m*u+d*h*g,this._z=c*h*g-d*m*u,this._w=c*h*u-d*m*g;break;case"XZY":this._x=d*h*u-c*m*g,this._y=c*m*u-d*h*g,this._z=c*h*g+d*m*u,this._w=c*h*u+d*m*g;break;default:Re("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],u=t[10],d=n+a+u;if(d>0){let m=.5/Math.sqrt(d+1);this._w=.25/m,this._x=(h-l)*m,this._y=(r-c)*m,this._z=(o-s)*m}else if(n>a&&n>u){let m=2*Math.sqrt(1+n-a-u);this._w=(h-l)/m,this._x=.25*m,this._y=(s+o)/m,this._z=(r+c)/m}else if(a>u){let m=2*Math.sqrt(1+a-n-u);this._w=(r-c)/m,this._x=(s+o)/m,this._y=.25*m,this._z=(l+h)/m}else{let m=2*Math.sqrt(1+u-n-a);this._w=(o-s)/m,this._x=(r+c)/m,this._y=(l+h)/m,this._z=.25*m}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ze(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},C=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(mf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(mf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),h=2*(a*t-r*s),u=2*(r*n-o*t);return this.x=t+l*c+o*u-a*h,this.y=n+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ze(this.x,e.x,t.x),this.y=ze(this.y,e.y,t.y),this.z=ze(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ze(this.x,e,t),this.y=ze(this.y,e,t),this.z=ze(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ze(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return gh.copy(this).projectOnVector(e),this.sub(gh)}reflect(e){return this.sub(gh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(ze(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},gh=new C,mf=new Un,Ue=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=s,h[2]=a,h[3]=t,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],u=n[7],d=n[2],m=n[5],g=n[8],y=s[0],p=s[3],f=s[6],x=s[1],w=s[4],M=s[7],v=s[2],b=s[5],_=s[8];return r[0]=o*y+a*x+l*v,r[3]=o*p+a*w+l*b,r[6]=o*f+a*M+l*_,r[1]=c*y+h*x+u*v,r[4]=c*p+h*w+u*b,r[7]=c*f+h*M+u*_,r[2]=d*y+m*x+g*v,r[5]=d*p+m*w+g*b,r[8]=d*f+m*M+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=h*o-a*c,d=a*l-h*r,m=c*r-o*l,g=t*u+n*d+s*m;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/g;return e[0]=u*y,e[1]=(s*c-h*n)*y,e[2]=(a*n-s*o)*y,e[3]=d*y,e[4]=(h*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=m*y,e[7]=(n*l-c*t)*y,e[8]=(o*t-n*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return zr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(_h.makeScale(e,t)),this}rotate(e){return zr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(_h.makeRotation(-e)),this}translate(e,t){return zr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(_h.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},_h=new Ue,gf=new Ue().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),_f=new Ue().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function h0(){let i={enabled:!0,workingColorSpace:Wr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===at&&(s.r=wi(s.r),s.g=wi(s.g),s.b=wi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===at&&(s.r=Js(s.r),s.g=Js(s.g),s.b=Js(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ri?Xr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Wr]:{primaries:e,whitePoint:n,transfer:Xr,toXYZ:gf,fromXYZ:_f,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:En},outputColorSpaceConfig:{drawingBufferColorSpace:En}},[En]:{primaries:e,whitePoint:n,transfer:at,toXYZ:gf,fromXYZ:_f,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:En}}}),i}var Qe=h0();function wi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Js(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Ds,Wa=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Ds===void 0&&(Ds=qr("canvas")),Ds.width=e.width,Ds.height=e.height;let s=Ds.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Ds}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=qr("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=wi(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(wi(t[n]/255)*255):t[n]=wi(t[n]);return{data:t,width:e.width,height:e.height}}else return Re("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},u0=0,er=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:u0++}),this.uuid=Ki(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(yh(s[o].image)):r.push(yh(s[o]))}else r=yh(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function yh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Wa.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Re("Texture: Unable to serialize Texture."),{})}var d0=0,xh=new C,yn=class i extends ii{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ni,s=ni,r=hn,o=Ai,a=Jn,l=xn,c=i.DEFAULT_ANISOTROPY,h=Ri){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:d0++}),this.uuid=Ki(),this.name="",this.source=new er(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new He(0,0),this.repeat=new He(1,1),this.center=new He(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ue,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(xh).x}get height(){return this.source.getSize(xh).y}get depth(){return this.source.getSize(xh).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Re(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Re(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ru)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Va:e.x=e.x-Math.floor(e.x);break;case ni:e.x=e.x<0?0:1;break;case Ha:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Va:e.y=e.y-Math.floor(e.y);break;case ni:e.y=e.y<0?0:1;break;case Ha:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};yn.DEFAULT_IMAGE=null;yn.DEFAULT_MAPPING=ru;yn.DEFAULT_ANISOTROPY=1;var it=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],h=l[4],u=l[8],d=l[1],m=l[5],g=l[9],y=l[2],p=l[6],f=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-y)<.01&&Math.abs(g-p)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+y)<.1&&Math.abs(g+p)<.1&&Math.abs(c+m+f-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,M=(m+1)/2,v=(f+1)/2,b=(h+d)/4,_=(u+y)/4,T=(g+p)/4;return w>M&&w>v?w<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(w),s=b/n,r=_/n):M>v?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=b/s,r=T/s):v<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(v),n=_/r,s=T/r),this.set(n,s,r,t),this}let x=Math.sqrt((p-g)*(p-g)+(u-y)*(u-y)+(d-h)*(d-h));return Math.abs(x)<.001&&(x=1),this.x=(p-g)/x,this.y=(u-y)/x,this.z=(d-h)/x,this.w=Math.acos((c+m+f-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ze(this.x,e.x,t.x),this.y=ze(this.y,e.y,t.y),this.z=ze(this.z,e.z,t.z),this.w=ze(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ze(this.x,e,t),this.y=ze(this.y,e,t),this.z=ze(this.z,e,t),this.w=ze(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(ze(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Xa=class extends ii{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:hn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new it(0,0,e,t),this.scissorTest=!1,this.viewport=new it(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new yn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:hn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new er(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},sn=class extends Xa{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Yr=class extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Ht,this.minFilter=Ht,this.wrapR=ni,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var qa=class extends yn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Ht,this.minFilter=Ht,this.wrapR=ni,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ot=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,h,u,d,m,g,y,p){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,h,u,d,m,g,y,p)}set(e,t,n,s,r,o,a,l,c,h,u,d,m,g,y,p){let f=this.elements;return f[0]=e,f[4]=t,f[8]=n,f[12]=s,f[1]=r,f[5]=o,f[9]=a,f[13]=l,f[2]=c,f[6]=h,f[10]=u,f[14]=d,f[3]=m,f[7]=g,f[11]=y,f[15]=p,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Ns.setFromMatrixColumn(e,0).length(),r=1/Ns.setFromMatrixColumn(e,1).length(),o=1/Ns.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(e.order==="XYZ"){let d=o*h,m=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=-l*u,t[8]=c,t[1]=m+g*c,t[5]=d-y*c,t[9]=-a*l,t[2]=y-d*c,t[6]=g+m*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*h,m=l*u,g=c*h,y=c*u;t[0]=d+y*a,t[4]=g*a-m,t[8]=o*c,t[1]=o*u,t[5]=o*h,t[9]=-a,t[2]=m*a-g,t[6]=y+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*h,m=l*u,g=c*h,y=c*u;t[0]=d-y*a,t[4]=-o*u,t[8]=g+m*a,t[1]=m+g*a,t[5]=o*h,t[9]=y-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*h,m=o*u,g=a*h,y=a*u;t[0]=l*h,t[4]=g*c-m,t[8]=d*c+y,t[1]=l*u,t[5]=y*c+d,t[9]=m*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,m=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=y-d*u,t[8]=g*u+m,t[1]=u,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=m*u+g,t[10]=d-y*u}else if(e.order==="XZY"){let d=o*l,m=o*c,g=a*l,y=a*c;t[0]=l*h,t[4]=-u,t[8]=c*h,t[1]=d*u+y,t[5]=o*h,t[9]=m*u-g,t[2]=g*u-m,t[6]=a*h,t[10]=y*u+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(f0,e,p0)}lookAt(e,t,n){let s=this.elements;return Mn.subVectors(e,t),Mn.lengthSq()===0&&(Mn.z=1),Mn.normalize(),Fi.crossVectors(n,Mn),Fi.lengthSq()===0&&(Math.abs(n.z)===1?Mn.x+=1e-4:Mn.z+=1e-4,Mn.normalize(),Fi.crossVectors(n,Mn)),Fi.normalize(),aa.crossVectors(Mn,Fi),s[0]=Fi.x,s[4]=aa.x,s[8]=Mn.x,s[1]=Fi.y,s[5]=aa.y,s[9]=Mn.y,s[2]=Fi.z,s[6]=aa.z,s[10]=Mn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],u=n[5],d=n[9],m=n[13],g=n[2],y=n[6],p=n[10],f=n[14],x=n[3],w=n[7],M=n[11],v=n[15],b=s[0],_=s[4],T=s[8],O=s[12],P=s[1],D=s[5],k=s[9],W=s[13],I=s[2],V=s[6],j=s[10],z=s[14],ie=s[3],q=s[7],Q=s[11],te=s[15];return r[0]=o*b+a*P+l*I+c*ie,r[4]=o*_+a*D+l*V+c*q,r[8]=o*T+a*k+l*j+c*Q,r[12]=o*O+a*W+l*z+c*te,r[1]=h*b+u*P+d*I+m*ie,r[5]=h*_+u*D+d*V+m*q,r[9]=h*T+u*k+d*j+m*Q,r[13]=h*O+u*W+d*z+m*te,r[2]=g*b+y*P+p*I+f*ie,r[6]=g*_+y*D+p*V+f*q,r[10]=g*T+y*k+p*j+f*Q,r[14]=g*O+y*W+p*z+f*te,r[3]=x*b+w*P+M*I+v*ie,r[7]=x*_+w*D+M*V+v*q,r[11]=x*T+w*k+M*j+v*Q,r[15]=x*O+w*W+M*z+v*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],u=e[6],d=e[10],m=e[14],g=e[3],y=e[7],p=e[11],f=e[15],x=l*m-c*d,w=a*m-c*u,M=a*d-l*u,v=o*m-c*h,b=o*d-l*h,_=o*u-a*h;return t*(y*x-p*w+f*M)-n*(g*x-p*v+f*b)+s*(g*w-y*v+f*_)-r*(g*M-y*b+p*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],u=e[9],d=e[10],m=e[11],g=e[12],y=e[13],p=e[14],f=e[15],x=t*a-n*o,w=t*l-s*o,M=t*c-r*o,v=n*l-s*a,b=n*c-r*a,_=s*c-r*l,T=h*y-u*g,O=h*p-d*g,P=h*f-m*g,D=u*p-d*y,k=u*f-m*y,W=d*f-m*p,I=x*W-w*k+M*D+v*P-b*O+_*T;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return e[0]=(a*W-l*k+c*D)*V,e[1]=(s*k-n*W-r*D)*V,e[2]=(y*_-p*b+f*v)*V,e[3]=(d*b-u*_-m*v)*V,e[4]=(l*P-o*W-c*O)*V,e[5]=(t*W-s*P+r*O)*V,e[6]=(p*M-g*_-f*w)*V,e[7]=(h*_-d*M+m*w)*V,e[8]=(o*k-a*P+c*T)*V,e[9]=(n*P-t*k-r*T)*V,e[10]=(g*b-y*M+f*x)*V,e[11]=(u*M-h*b-m*x)*V,e[12]=(a*O-o*D-l*T)*V,e[13]=(t*D-n*O+s*T)*V,e[14]=(y*w-g*v-p*x)*V,e[15]=(h*v-u*w+d*x)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,h=o+o,u=a+a,d=r*c,m=r*h,g=r*u,y=o*h,p=o*u,f=a*u,x=l*c,w=l*h,M=l*u,v=n.x,b=n.y,_=n.z;return s[0]=(1-(y+f))*v,s[1]=(m+M)*v,s[2]=(g-w)*v,s[3]=0,s[4]=(m-M)*b,s[5]=(1-(d+f))*b,s[6]=(p+x)*b,s[7]=0,s[8]=(g+w)*_,s[9]=(p-x)*_,s[10]=(1-(d+y))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Ns.set(s[0],s[1],s[2]).length(),a=Ns.set(s[4],s[5],s[6]).length(),l=Ns.set(s[8],s[9],s[10]).length();r<0&&(o=-o),zn.copy(this);let c=1/o,h=1/a,u=1/l;return zn.elements[0]*=c,zn.elements[1]*=c,zn.elements[2]*=c,zn.elements[4]*=h,zn.elements[5]*=h,zn.elements[6]*=h,zn.elements[8]*=u,zn.elements[9]*=u,zn.elements[10]*=u,t.setFromRotationMatrix(zn),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=Nn,l=!1){let c=this.elements,h=2*r/(t-e),u=2*r/(n-s),d=(t+e)/(t-e),m=(n+s)/(n-s),g,y;if(l)g=r/(o-r),y=o*r/(o-r);else if(a===Nn)g=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Ks)g=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=m,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Nn,l=!1){let c=this.elements,h=2/(t-e),u=2/(n-s),d=-(t+e)/(t-e),m=-(n+s)/(n-s),g,y;if(l)g=1/(o-r),y=o/(o-r);else if(a===Nn)g=-2/(o-r),y=-(o+r)/(o-r);else if(a===Ks)g=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=m,c[2]=0,c[6]=0,c[10]=g,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Ns=new C,zn=new ot,f0=new C(0,0,0),p0=new C(1,1,1),Fi=new C,aa=new C,Mn=new C,yf=new ot,xf=new Un,si=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],m=s[10];switch(t){case"XYZ":this._y=Math.asin(ze(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,m),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ze(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,m),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ze(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,m),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ze(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,m),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ze(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,m));break;case"XZY":this._z=Math.asin(-ze(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,m),this._y=0);break;default:Re("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return yf.makeRotationFromQuaternion(e),this.setFromRotationMatrix(yf,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return xf.setFromEuler(this),this.setFromQuaternion(xf,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};si.DEFAULT_ORDER="XYZ";var tr=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},m0=0,vf=new C,Us=new Un,xi=new ot,la=new C,Nr=new C,g0=new C,_0=new Un,bf=new C(1,0,0),Sf=new C(0,1,0),Mf=new C(0,0,1),wf={type:"added"},y0={type:"removed"},Fs={type:"childadded",child:null},vh={type:"childremoved",child:null},Xt=class i extends ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:m0++}),this.uuid=Ki(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new C,t=new si,n=new Un,s=new C(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ot},normalMatrix:{value:new Ue}}),this.matrix=new ot,this.matrixWorld=new ot,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new tr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Us.setFromAxisAngle(e,t),this.quaternion.multiply(Us),this}rotateOnWorldAxis(e,t){return Us.setFromAxisAngle(e,t),this.quaternion.premultiply(Us),this}rotateX(e){return this.rotateOnAxis(bf,e)}rotateY(e){return this.rotateOnAxis(Sf,e)}rotateZ(e){return this.rotateOnAxis(Mf,e)}translateOnAxis(e,t){return vf.copy(e).applyQuaternion(this.quaternion),this.position.add(vf.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(bf,e)}translateY(e){return this.translateOnAxis(Sf,e)}translateZ(e){return this.translateOnAxis(Mf,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(xi.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?la.copy(e):la.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Nr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xi.lookAt(Nr,la,this.up):xi.lookAt(la,Nr,this.up),this.quaternion.setFromRotationMatrix(xi),s&&(xi.extractRotation(s.matrixWorld),Us.setFromRotationMatrix(xi),this.quaternion.premultiply(Us.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(De("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(wf),Fs.child=e,this.dispatchEvent(Fs),Fs.child=null):De("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(y0),vh.child=e,this.dispatchEvent(vh),vh.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),xi.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),xi.multiply(e.parent.matrixWorld)),e.applyMatrix4(xi),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(wf),Fs.child=e,this.dispatchEvent(Fs),Fs.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Nr,e,g0),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Nr,_0,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(e.shapes,u)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),u=o(e.shapes),d=o(e.skeletons),m=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),m.length>0&&(n.animations=m),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Xt.DEFAULT_UP=new C(0,1,0);Xt.DEFAULT_MATRIX_AUTO_UPDATE=!0;Xt.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var _n=class extends Xt{constructor(){super(),this.isGroup=!0,this.type="Group"}},x0={type:"move"},nr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new _n,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new _n,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new C,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new C),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new _n,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new C,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new C,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let p=t.getJointPose(y,n),f=this._getHandJoint(c,y);p!==null&&(f.matrix.fromArray(p.transform.matrix),f.matrix.decompose(f.position,f.quaternion,f.scale),f.matrixWorldNeedsUpdate=!0,f.jointRadius=p.radius),f.visible=p!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),m=.02,g=.005;c.inputState.pinching&&d>m+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=m-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(x0)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new _n;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Pp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bi={h:0,s:0,l:0},ca={h:0,s:0,l:0};function bh(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Oe=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=En){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Qe.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Qe.workingColorSpace){return this.r=e,this.g=t,this.b=n,Qe.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Qe.workingColorSpace){if(e=yu(e,1),t=ze(t,0,1),n=ze(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=bh(o,r,e+1/3),this.g=bh(o,r,e),this.b=bh(o,r,e-1/3)}return Qe.colorSpaceToWorking(this,s),this}setStyle(e,t=En){function n(r){r!==void 0&&parseFloat(r)<1&&Re("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Re("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Re("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=En){let n=Pp[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Re("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=wi(e.r),this.g=wi(e.g),this.b=wi(e.b),this}copyLinearToSRGB(e){return this.r=Js(e.r),this.g=Js(e.g),this.b=Js(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=En){return Qe.workingToColorSpace(nn.copy(this),e),Math.round(ze(nn.r*255,0,255))*65536+Math.round(ze(nn.g*255,0,255))*256+Math.round(ze(nn.b*255,0,255))}getHexString(e=En){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Qe.workingColorSpace){Qe.workingToColorSpace(nn.copy(this),t);let n=nn.r,s=nn.g,r=nn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case n:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-n)/u+2;break;case r:l=(n-s)/u+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Qe.workingColorSpace){return Qe.workingToColorSpace(nn.copy(this),t),e.r=nn.r,e.g=nn.g,e.b=nn.b,e}getStyle(e=En){Qe.workingToColorSpace(nn.copy(this),e);let t=nn.r,n=nn.g,s=nn.b;return e!==En?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Bi),this.setHSL(Bi.h+e,Bi.s+t,Bi.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Bi),e.getHSL(ca);let n=Hr(Bi.h,ca.h,t),s=Hr(Bi.s,ca.s,t),r=Hr(Bi.l,ca.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},nn=new Oe;Oe.NAMES=Pp;var Jr=class extends Xt{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new si,this.environmentIntensity=1,this.environmentRotation=new si,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Vn=new C,vi=new C,Sh=new C,bi=new C,Bs=new C,ks=new C,Ef=new C,Mh=new C,wh=new C,Eh=new C,Th=new it,Ah=new it,Ch=new it,Hi=class i{constructor(e=new C,t=new C,n=new C){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Vn.subVectors(e,t),s.cross(Vn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Vn.subVectors(s,t),vi.subVectors(n,t),Sh.subVectors(e,t);let o=Vn.dot(Vn),a=Vn.dot(vi),l=Vn.dot(Sh),c=vi.dot(vi),h=vi.dot(Sh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,m=(c*l-a*h)*d,g=(o*h-a*l)*d;return r.set(1-m-g,g,m)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,bi)===null?!1:bi.x>=0&&bi.y>=0&&bi.x+bi.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,bi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,bi.x),l.addScaledVector(o,bi.y),l.addScaledVector(a,bi.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Th.setScalar(0),Ah.setScalar(0),Ch.setScalar(0),Th.fromBufferAttribute(e,t),Ah.fromBufferAttribute(e,n),Ch.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Th,r.x),o.addScaledVector(Ah,r.y),o.addScaledVector(Ch,r.z),o}static isFrontFacing(e,t,n,s){return Vn.subVectors(n,t),vi.subVectors(e,t),Vn.cross(vi).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Vn.subVectors(this.c,this.b),vi.subVectors(this.a,this.b),Vn.cross(vi).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Bs.subVectors(s,n),ks.subVectors(r,n),Mh.subVectors(e,n);let l=Bs.dot(Mh),c=ks.dot(Mh);if(l<=0&&c<=0)return t.copy(n);wh.subVectors(e,s);let h=Bs.dot(wh),u=ks.dot(wh);if(h>=0&&u<=h)return t.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(n).addScaledVector(Bs,o);Eh.subVectors(e,r);let m=Bs.dot(Eh),g=ks.dot(Eh);if(g>=0&&m<=g)return t.copy(r);let y=m*c-l*g;if(y<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(ks,a);let p=h*g-m*u;if(p<=0&&u-h>=0&&m-g>=0)return Ef.subVectors(r,s),a=(u-h)/(u-h+(m-g)),t.copy(s).addScaledVector(Ef,a);let f=1/(p+y+d);return o=y*f,a=d*f,t.copy(n).addScaledVector(Bs,o).addScaledVector(ks,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},rn=class{constructor(e=new C(1/0,1/0,1/0),t=new C(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Hn.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Hn.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Hn.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Hn):Hn.fromBufferAttribute(r,o),Hn.applyMatrix4(e.matrixWorld),this.expandByPoint(Hn);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),ha.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),ha.copy(n.boundingBox)),ha.applyMatrix4(e.matrixWorld),this.union(ha)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Hn),Hn.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ur),ua.subVectors(this.max,Ur),zs.subVectors(e.a,Ur),Vs.subVectors(e.b,Ur),Hs.subVectors(e.c,Ur),ki.subVectors(Vs,zs),zi.subVectors(Hs,Vs),cs.subVectors(zs,Hs);let t=[0,-ki.z,ki.y,0,-zi.z,zi.y,0,-cs.z,cs.y,ki.z,0,-ki.x,zi.z,0,-zi.x,cs.z,0,-cs.x,-ki.y,ki.x,0,-zi.y,zi.x,0,-cs.y,cs.x,0];return!Rh(t,zs,Vs,Hs,ua)||(t=[1,0,0,0,1,0,0,0,1],!Rh(t,zs,Vs,Hs,ua))?!1:(da.crossVectors(ki,zi),t=[da.x,da.y,da.z],Rh(t,zs,Vs,Hs,ua))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Hn).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Hn).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Si[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Si[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Si[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Si[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Si[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Si[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Si[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Si[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Si),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Si=[new C,new C,new C,new C,new C,new C,new C,new C],Hn=new C,ha=new rn,zs=new C,Vs=new C,Hs=new C,ki=new C,zi=new C,cs=new C,Ur=new C,ua=new C,da=new C,hs=new C;function Rh(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){hs.fromArray(i,r);let a=s.x*Math.abs(hs.x)+s.y*Math.abs(hs.y)+s.z*Math.abs(hs.z),l=e.dot(hs),c=t.dot(hs),h=n.dot(hs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Rt=new C,fa=new He,v0=0,mt=class extends ii{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:v0++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=gu,this.updateRanges=[],this.gpuType=$n,this.version=0,this._normalizationScale=e!==void 0?tc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)fa.fromBufferAttribute(this,t),fa.applyMatrix3(e),this.setXY(t,fa.x,fa.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Rt.fromBufferAttribute(this,t),Rt.applyMatrix3(e),this.setXYZ(t,Rt.x,Rt.y,Rt.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Rt.fromBufferAttribute(this,t),Rt.applyMatrix4(e),this.setXYZ(t,Rt.x,Rt.y,Rt.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Rt.fromBufferAttribute(this,t),Rt.applyNormalMatrix(e),this.setXYZ(t,Rt.x,Rt.y,Rt.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Rt.fromBufferAttribute(this,t),Rt.transformDirection(e),this.setXYZ(t,Rt.x,Rt.y,Rt.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):vu(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):bu(e,this.array)}};var Zr=class extends mt{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Kr=class extends mt{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Vt=class extends mt{constructor(e,t,n){super(new Float32Array(e),t,n)}},b0=new rn,Fr=new C,Ph=new C,un=class{constructor(e=new C,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):b0.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Fr.subVectors(e,this.center);let t=Fr.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Fr,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ph.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Fr.copy(e.center).add(Ph)),this.expandByPoint(Fr.copy(e.center).sub(Ph))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},S0=0,Dn=new ot,Ih=new Xt,Gs=new C,wn=new rn,Br=new rn,zt=new C,Et=class i extends ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:S0++}),this.uuid=Ki(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new($_(e)?Kr:Zr)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Ue().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Dn.makeRotationFromQuaternion(e),this.applyMatrix4(Dn),this}rotateX(e){return Dn.makeRotationX(e),this.applyMatrix4(Dn),this}rotateY(e){return Dn.makeRotationY(e),this.applyMatrix4(Dn),this}rotateZ(e){return Dn.makeRotationZ(e),this.applyMatrix4(Dn),this}translate(e,t,n){return Dn.makeTranslation(e,t,n),this.applyMatrix4(Dn),this}scale(e,t,n){return Dn.makeScale(e,t,n),this.applyMatrix4(Dn),this}lookAt(e){return Ih.lookAt(e),Ih.updateMatrix(),this.applyMatrix4(Ih.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Gs).negate(),this.translate(Gs.x,Gs.y,Gs.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Vt(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Re("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new rn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new C(-1/0,-1/0,-1/0),new C(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];wn.setFromBufferAttribute(r),this.morphTargetsRelative?(zt.addVectors(this.boundingBox.min,wn.min),this.boundingBox.expandByPoint(zt),zt.addVectors(this.boundingBox.max,wn.max),this.boundingBox.expandByPoint(zt)):(this.boundingBox.expandByPoint(wn.min),this.boundingBox.expandByPoint(wn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&De('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new un);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){De("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new C,1/0);return}if(e){let n=this.boundingSphere.center;if(wn.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Br.setFromBufferAttribute(a),this.morphTargetsRelative?(zt.addVectors(wn.min,Br.min),wn.expandByPoint(zt),zt.addVectors(wn.max,Br.max),wn.expandByPoint(zt)):(wn.expandByPoint(Br.min),wn.expandByPoint(Br.max))}wn.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)zt.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(zt));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)zt.fromBufferAttribute(a,c),l&&(Gs.fromBufferAttribute(e,c),zt.add(Gs)),s=Math.max(s,n.distanceToSquared(zt))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&De('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){De("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new mt(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let O=0;O<n.count;O++)a[O]=new C,l[O]=new C;let h=new C,u=new C,d=new C,m=new He,g=new He,y=new He,p=new C,f=new C;function x(O,P,D){c[O]=c[P]=c[D]=1,h.fromBufferAttribute(n,O),u.fromBufferAttribute(n,P),d.fromBufferAttribute(n,D),m.fromBufferAttribute(r,O),g.fromBufferAttribute(r,P),y.fromBufferAttribute(r,D),u.sub(h),d.sub(h),g.sub(m),y.sub(m);let k=1/(g.x*y.y-y.x*g.y);isFinite(k)&&(p.copy(u).multiplyScalar(y.y).addScaledVector(d,-g.y).multiplyScalar(k),f.copy(d).multiplyScalar(g.x).addScaledVector(u,-y.x).multiplyScalar(k),a[O].add(p),a[P].add(p),a[D].add(p),l[O].add(f),l[P].add(f),l[D].add(f))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let O=0,P=w.length;O<P;++O){let D=w[O],k=D.start,W=D.count;for(let I=k,V=k+W;I<V;I+=3)x(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let M=new C,v=new C,b=new C,_=new C;function T(O){b.fromBufferAttribute(s,O),_.copy(b);let P=a[O];M.copy(P),M.sub(b.multiplyScalar(b.dot(P))).normalize(),v.crossVectors(_,P);let k=v.dot(l[O])<0?-1:1;o.setXYZW(O,M.x,M.y,M.z,k)}for(let O=0,P=n.count;O<P;++O)c[O]&&T(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new mt(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,m=n.count;d<m;d++)n.setXYZ(d,0,0,0);let s=new C,r=new C,o=new C,a=new C,l=new C,c=new C,h=new C,u=new C;if(e)for(let d=0,m=e.count;d<m;d+=3){let g=e.getX(d+0),y=e.getX(d+1),p=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,p),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,y),c.fromBufferAttribute(n,p),a.add(h),l.add(h),c.add(h),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(y,l.x,l.y,l.z),n.setXYZ(p,c.x,c.y,c.z)}else for(let d=0,m=t.count;d<m;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)zt.fromBufferAttribute(e,t),zt.normalize(),e.setXYZ(t,zt.x,zt.y,zt.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),m=0,g=0;for(let y=0,p=l.length;y<p;y++){a.isInterleavedBufferAttribute?m=l[y]*a.data.stride+a.offset:m=l[y]*h;for(let f=0;f<h;f++)d[g++]=c[m++]}return new mt(d,h,u)}if(this.index===null)return Re("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],m=e(d,n);l.push(m)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let m=c[u];h.push(m.toJSON(e.data))}h.length>0&&(s[l]=h,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(t))}let r=e.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,m=u.length;d<m;d++)h.push(u[d].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},$a=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=gu,this.updateRanges=[],this.version=0,this.uuid=Ki()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Tf(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Tf(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Tf(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Ki()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var ln=new C,Wn=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?tc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix4(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyNormalMatrix(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.transformDirection(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){$r("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new mt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){$r("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):vu(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):bu(e,this.data.array)}},Lh=new C,M0=new C,w0=new Ue,Gn=class{constructor(e=new C(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Lh.subVectors(n,t).cross(M0.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Lh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||w0.getNormalMatrix(e),s=this.coplanarPoint(Lh).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},E0=0,Xn=class extends ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:E0++}),this.uuid=Ki(),this.name="",this.type="Material",this.blending=cr,this.side=Ji,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Kh,this.blendDst=jh,this.blendEquation=gs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Oe(0,0,0),this.blendAlpha=0,this.depthFunc=Zs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=vp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Oa,this.stencilZFail=Oa,this.stencilZPass=Oa,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Re(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Re(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Oe().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Gn().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new He().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new He().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Mi=new C,Oh=new C,pa=new C,ma=new C,fs=class{constructor(e=new C,t=new C(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Mi)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Mi.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Mi.copy(this.origin).addScaledVector(this.direction,t),Mi.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Oh.copy(e).add(t).multiplyScalar(.5),pa.copy(t).sub(e).normalize(),ma.copy(this.origin).sub(Oh);let r=e.distanceTo(t)*.5,o=-this.direction.dot(pa),a=ma.dot(this.direction),l=-ma.dot(pa),c=ma.lengthSq(),h=Math.abs(1-o*o),u,d,m,g;if(h>0)if(u=o*l-a,d=o*a-l,g=r*h,u>=0)if(d>=-g)if(d<=g){let y=1/h;u*=y,d*=y,m=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;else d<=-g?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),m=-u*u+d*(d+2*l)+c):d<=g?(u=0,d=Math.min(Math.max(-r,-l),r),m=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),m=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),m=-u*u+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Oh).addScaledVector(pa,d),m}intersectSphere(e,t){if(e.radius<0)return null;Mi.subVectors(e.center,this.origin);let n=Mi.dot(this.direction),s=Mi.dot(Mi)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),h>=0?(r=(e.min.y-d.y)*h,o=(e.max.y-d.y)*h):(r=(e.max.y-d.y)*h,o=(e.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(e.min.z-d.z)*u,l=(e.max.z-d.z)*u):(a=(e.max.z-d.z)*u,l=(e.min.z-d.z)*u),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Mi)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=e.x-o.x,d=e.y-o.y,m=e.z-o.z,g=t.x-o.x,y=t.y-o.y,p=t.z-o.z,f=n.x-o.x,x=n.y-o.y,w=n.z-o.z,M=Math.abs(l),v=Math.abs(c),b=Math.abs(h),_,T,O,P,D,k,W,I,V,j,z,ie;if(M>=v&&M>=b?(O=l,k=u,V=g,ie=f,l>=0?(_=c,T=h,P=d,D=m,W=y,I=p,j=x,z=w):(_=h,T=c,P=m,D=d,W=p,I=y,j=w,z=x)):v>=b?(O=c,k=d,V=y,ie=x,c>=0?(_=h,T=l,P=m,D=u,W=p,I=g,j=w,z=f):(_=l,T=h,P=u,D=m,W=g,I=p,j=f,z=w)):(O=h,k=m,V=p,ie=w,h>=0?(_=l,T=c,P=u,D=d,W=g,I=y,j=f,z=x):(_=c,T=l,P=d,D=u,W=y,I=g,j=x,z=f)),O===0)return null;let q=_/O,Q=T/O,te=1/O,Ee=P-q*k,Be=D-Q*k,J=W-q*V,_e=I-Q*V,be=j-q*ie,Pe=z-Q*ie,ye=be*_e-Pe*J,Ve=Ee*Pe-Be*be,At=J*Be-_e*Ee;if(s){if(ye<0||Ve<0||At<0)return null}else if((ye<0||Ve<0||At<0)&&(ye>0||Ve>0||At>0))return null;let Le=ye+Ve+At;if(Le===0)return null;let ct=te*(ye*k+Ve*V+At*ie);return(Le>0?ct<0:ct>0)?null:this.at(ct/Le,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ir=class extends Xn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new si,this.combine=ml,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Af=new ot,us=new fs,ga=new un,Cf=new C,_a=new C,ya=new C,xa=new C,Dh=new C,va=new C,Rf=new C,ba=new C,Lt=class extends Xt{constructor(e=new Et,t=new ir){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){va.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Dh.fromBufferAttribute(u,e),o?va.addScaledVector(Dh,h):va.addScaledVector(Dh.sub(t),h))}t.add(va)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),ga.copy(n.boundingSphere),ga.applyMatrix4(r),us.copy(e.ray).recast(e.near),!(ga.containsPoint(us.origin)===!1&&(us.intersectSphere(ga,Cf)===null||us.origin.distanceToSquared(Cf)>(e.far-e.near)**2))&&(Af.copy(r).invert(),us.copy(e.ray).applyMatrix4(Af),!(n.boundingBox!==null&&us.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,us)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,m=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],f=o[p.materialIndex],x=Math.max(p.start,m.start),w=Math.min(a.count,Math.min(p.start+p.count,m.start+m.count));for(let M=x,v=w;M<v;M+=3){let b=a.getX(M),_=a.getX(M+1),T=a.getX(M+2);s=Sa(this,f,e,n,c,h,u,b,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),y=Math.min(a.count,m.start+m.count);for(let p=g,f=y;p<f;p+=3){let x=a.getX(p),w=a.getX(p+1),M=a.getX(p+2);s=Sa(this,o,e,n,c,h,u,x,w,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,y=d.length;g<y;g++){let p=d[g],f=o[p.materialIndex],x=Math.max(p.start,m.start),w=Math.min(l.count,Math.min(p.start+p.count,m.start+m.count));for(let M=x,v=w;M<v;M+=3){let b=M,_=M+1,T=M+2;s=Sa(this,f,e,n,c,h,u,b,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=p.materialIndex,t.push(s))}}else{let g=Math.max(0,m.start),y=Math.min(l.count,m.start+m.count);for(let p=g,f=y;p<f;p+=3){let x=p,w=p+1,M=p+2;s=Sa(this,o,e,n,c,h,u,x,w,M),s&&(s.faceIndex=Math.floor(p/3),t.push(s))}}}};function T0(i,e,t,n,s,r,o,a){let l;if(e.side===dn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===Ji,a),l===null)return null;ba.copy(a),ba.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(ba);return c<t.near||c>t.far?null:{distance:c,point:ba.clone(),object:i}}function Sa(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,_a),i.getVertexPosition(l,ya),i.getVertexPosition(c,xa);let h=T0(i,e,t,n,_a,ya,xa,Rf);if(h){let u=new C;Hi.getBarycoord(Rf,_a,ya,xa,u),s&&(h.uv=Hi.getInterpolatedAttribute(s,a,l,c,u,new He)),r&&(h.uv1=Hi.getInterpolatedAttribute(r,a,l,c,u,new He)),o&&(h.normal=Hi.getInterpolatedAttribute(o,a,l,c,u,new C),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new C,materialIndex:0};Hi.getNormal(_a,ya,xa,d.normal),h.face=d,h.barycoord=u}return h}var Ya=class extends yn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=Ht,h=Ht,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ds=new un,A0=new He(.5,.5),Ma=new C,Gi=class{constructor(e=new Gn,t=new Gn,n=new Gn,s=new Gn,r=new Gn,o=new Gn){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Nn,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],m=r[7],g=r[8],y=r[9],p=r[10],f=r[11],x=r[12],w=r[13],M=r[14],v=r[15];if(s[0].setComponents(c-o,m-h,f-g,v-x).normalize(),s[1].setComponents(c+o,m+h,f+g,v+x).normalize(),s[2].setComponents(c+a,m+u,f+y,v+w).normalize(),s[3].setComponents(c-a,m-u,f-y,v-w).normalize(),n)s[4].setComponents(l,d,p,M).normalize(),s[5].setComponents(c-l,m-d,f-p,v-M).normalize();else if(s[4].setComponents(c-l,m-d,f-p,v-M).normalize(),t===Nn)s[5].setComponents(c+l,m+d,f+p,v+M).normalize();else if(t===Ks)s[5].setComponents(l,d,p,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ds.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ds.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ds)}intersectsSprite(e){ds.center.set(0,0,0);let t=A0.distanceTo(e.center);return ds.radius=.7071067811865476+t,ds.applyMatrix4(e.matrixWorld),this.intersectsSphere(ds)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ma.x=s.normal.x>0?e.max.x:e.min.x,Ma.y=s.normal.y>0?e.max.y:e.min.y,Ma.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ma)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Pf=new ot,Ja=class i{constructor(){this.coordinateSystem=Nn,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Pf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Gi),n[s].setFromProjectionMatrix(Pf,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Gi),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var sr=class extends Xn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Oe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Za=new C,Ka=new C,If=new ot,kr=new fs,wa=new un,Nh=new C,Lf=new C,ja=class extends Xt{constructor(e=new Et,t=new sr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let s=1,r=t.count;s<r;s++)Za.fromBufferAttribute(t,s-1),Ka.fromBufferAttribute(t,s),n[s]=n[s-1],n[s]+=Za.distanceTo(Ka);e.setAttribute("lineDistance",new Vt(n,1))}else Re("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),wa.copy(n.boundingSphere),wa.applyMatrix4(s),wa.radius+=r,e.ray.intersectsSphere(wa)===!1)return;If.copy(s).invert(),kr.copy(e.ray).applyMatrix4(If);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let m=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let y=m,p=g-1;y<p;y+=c){let f=h.getX(y),x=h.getX(y+1),w=Ea(this,e,kr,l,f,x,y);w&&t.push(w)}if(this.isLineLoop){let y=h.getX(g-1),p=h.getX(m),f=Ea(this,e,kr,l,y,p,g-1);f&&t.push(f)}}else{let m=Math.max(0,o.start),g=Math.min(d.count,o.start+o.count);for(let y=m,p=g-1;y<p;y+=c){let f=Ea(this,e,kr,l,y,y+1,y);f&&t.push(f)}if(this.isLineLoop){let y=Ea(this,e,kr,l,g-1,m,g-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Ea(i,e,t,n,s,r,o){let a=i.geometry.attributes.position;if(Za.fromBufferAttribute(a,s),Ka.fromBufferAttribute(a,r),t.distanceSqToSegment(Za,Ka,Nh,Lf)>n)return;Nh.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Nh);if(!(c<e.near||c>e.far))return{distance:c,point:Lf.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Of=new C,Df=new C,jr=class extends ja{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let s=0,r=t.count;s<r;s+=2)Of.fromBufferAttribute(t,s),Df.fromBufferAttribute(t,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Of.distanceTo(Df);e.setAttribute("lineDistance",new Vt(n,1))}else Re("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Qa=class extends Xn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Oe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Nf=new ot,Hh=new fs,Ta=new un,Aa=new C,rr=class extends Xt{constructor(e=new Et,t=new Qa){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ta.copy(n.boundingSphere),Ta.applyMatrix4(s),Ta.radius+=r,e.ray.intersectsSphere(Ta)===!1)return;Nf.copy(s).invert(),Hh.copy(e.ray).applyMatrix4(Nf);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,u=n.attributes.position;if(c!==null){let d=Math.max(0,o.start),m=Math.min(c.count,o.start+o.count);for(let g=d,y=m;g<y;g++){let p=c.getX(g);Aa.fromBufferAttribute(u,p),Uf(Aa,p,l,s,e,t,this)}}else{let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let g=d,y=m;g<y;g++)Aa.fromBufferAttribute(u,g),Uf(Aa,g,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Uf(i,e,t,n,s,r,o){let a=Hh.distanceSqToPoint(i);if(a<t){let l=new C;Hh.closestPointToPoint(i,l),l.applyMatrix4(n);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Qr=class extends yn{constructor(e=[],t=_s,n,s,r,o,a,l,c,h){super(e,t,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ti=class extends yn{constructor(e,t,n=qn,s,r,o,a=Ht,l=Ht,c,h=Ei,u=1){if(h!==Ei&&h!==Ci)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:u};super(d,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new er(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},eo=class extends Ti{constructor(e,t=qn,n=_s,s,r,o=Ht,a=Ht,l,c=Ei){let h={width:e,height:e,depth:1},u=[h,h,h,h,h,h];super(e,e,t,n,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},to=class extends yn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},or=class i extends Et{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,m=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Vt(c,3)),this.setAttribute("normal",new Vt(h,3)),this.setAttribute("uv",new Vt(u,2));function g(y,p,f,x,w,M,v,b,_,T,O){let P=M/_,D=v/T,k=M/2,W=v/2,I=b/2,V=_+1,j=T+1,z=0,ie=0,q=new C;for(let Q=0;Q<j;Q++){let te=Q*D-W;for(let Ee=0;Ee<V;Ee++){let Be=Ee*P-k;q[y]=Be*x,q[p]=te*w,q[f]=I,c.push(q.x,q.y,q.z),q[y]=0,q[p]=0,q[f]=b>0?1:-1,h.push(q.x,q.y,q.z),u.push(Ee/_),u.push(1-Q/T),z+=1}}for(let Q=0;Q<T;Q++)for(let te=0;te<_;te++){let Ee=d+te+V*Q,Be=d+te+V*(Q+1),J=d+(te+1)+V*(Q+1),_e=d+(te+1)+V*Q;l.push(Ee,Be,_e),l.push(Be,J,_e),ie+=6}a.addGroup(m,ie,O),m+=ie,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var ri=class i extends Et{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,u=e/a,d=t/l,m=[],g=[],y=[],p=[];for(let f=0;f<h;f++){let x=f*d-o;for(let w=0;w<c;w++){let M=w*u-r;g.push(M,-x,0),y.push(0,0,1),p.push(w/a),p.push(1-f/l)}}for(let f=0;f<l;f++)for(let x=0;x<a;x++){let w=x+c*f,M=x+c*(f+1),v=x+1+c*(f+1),b=x+1+c*f;m.push(w,M,b),m.push(M,v,b)}this.setIndex(m),this.setAttribute("position",new Vt(g,3)),this.setAttribute("normal",new Vt(y,3)),this.setAttribute("uv",new Vt(p,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var no=class extends Et{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],n=new Set,s=new C,r=new C;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,m=u.count;for(let g=d,y=d+m;g<y;g+=3)for(let p=0;p<3;p++){let f=a.getX(g+p),x=a.getX(g+(p+1)%3);s.fromBufferAttribute(o,f),r.fromBufferAttribute(o,x),Ff(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),Ff(s,r,n)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Vt(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function Ff(i,e,t){let n=`${i.x},${i.y},${i.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${i.x},${i.y},${i.z}`;return t.has(n)===!0||t.has(s)===!0?!1:(t.add(n),t.add(s),!0)}function xs(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Bf(s))s.isRenderTargetTexture?(Re("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Bf(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function on(i){let e={};for(let t=0;t<i.length;t++){let n=xs(i[t]);for(let s in n)e[s]=n[s]}return e}function Bf(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function C0(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Mu(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Qe.workingColorSpace}var wo={clone:xs,merge:on},R0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,P0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ot=class extends Xn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=R0,this.fragmentShader=P0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=xs(e.uniforms),this.uniformsGroups=C0(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Oe().setHex(s.value);break;case"v2":this.uniforms[n].value=new He().fromArray(s.value);break;case"v3":this.uniforms[n].value=new C().fromArray(s.value);break;case"v4":this.uniforms[n].value=new it().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Ue().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ot().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},el=class extends Ot{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},io=class extends Xn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Oe(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Mo,this.normalScale=new He(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new si,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var so=class extends Xn{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Mo,this.normalScale=new He(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new si,this.combine=ml,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},tl=class extends Xn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=yp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},nl=class extends Xn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ws(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ca(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Wi=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},il=class extends Wi{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:kh,endingEnd:kh}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case zh:r=e,a=2*t-n;break;case Vh:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case zh:o=e,l=2*n-t;break;case Vh:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,m=this._weightNext,g=(n-t)/(s-t),y=g*g,p=y*g,f=-d*p+2*d*y-d*g,x=(1+d)*p+(-1.5-2*d)*y+(-.5+d)*g+1,w=(-1-m)*p+(1.5+m)*y+.5*g,M=m*p-m*y;for(let v=0;v!==a;++v)r[v]=f*o[h+v]+x*o[c+v]+w*o[l+v]+M*o[u+v];return r}},sl=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(n-t)/(s-t),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},rl=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ol=class extends Wi{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(n-t)/(s-t),y=1-g;for(let p=0;p!==a;++p)r[p]=o[c+p]*y+o[l+p]*g;return r}let d=a*2,m=e-1;for(let g=0;g!==a;++g){let y=o[c+g],p=o[l+g],f=m*d+g*2,x=u[f],w=u[f+1],M=e*d+g*2,v=h[M],b=h[M+1],_=L0(n,t,x,v,s);r[g]=Ip(_,y,w,b,p)}return r}};function Ip(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function I0(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function L0(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=Ip(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=I0(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Tn=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ws(t,this.TimeBufferType),this.values=Ws(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ws(e.times,Array),values:Ws(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ca(e.settings)&&(n.settings={inTangents:Ws(e.settings.inTangents,Array),outTangents:Ws(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new rl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new sl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new il(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ol(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Gr:t=this.InterpolantFactoryMethodDiscrete;break;case Ga:t=this.InterpolantFactoryMethodLinear;break;case La:t=this.InterpolantFactoryMethodSmooth;break;case Bh:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Re("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Gr;case this.InterpolantFactoryMethodLinear:return Ga;case this.InterpolantFactoryMethodSmooth:return La;case this.InterpolantFactoryMethodBezier:return Bh}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ca(this.settings)&&(kf(this.settings.inTangents,e),kf(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ca(this.settings)&&(zf(this.settings.inTangents,e),zf(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(De("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(De("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){De("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){De("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&Y_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){De("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===La,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(s)l=!0;else{let u=a*n,d=u-n,m=u+n;for(let g=0;g!==n;++g){let y=t[u+g];if(y!==t[d+g]||y!==t[m+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let u=a*n,d=o*n;for(let m=0;m!==n;++m)t[d+m]=t[u+m]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ca(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function kf(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function zf(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Tn.prototype.ValueTypeName="";Tn.prototype.TimeBufferType=Float32Array;Tn.prototype.ValueBufferType=Float32Array;Tn.prototype.DefaultInterpolation=Ga;var Xi=class extends Tn{constructor(e,t,n){super(e,t,n)}};Xi.prototype.ValueTypeName="bool";Xi.prototype.ValueBufferType=Array;Xi.prototype.DefaultInterpolation=Gr;Xi.prototype.InterpolantFactoryMethodLinear=void 0;Xi.prototype.InterpolantFactoryMethodSmooth=void 0;var al=class extends Tn{constructor(e,t,n,s){super(e,t,n,s)}};al.prototype.ValueTypeName="color";var ll=class extends Tn{constructor(e,t,n,s){super(e,t,n,s)}};ll.prototype.ValueTypeName="number";var cl=class extends Wi{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let h=c+a;c!==h;c+=4)Un.slerpFlat(r,0,o,c-a,o,c,l);return r}},ro=class extends Tn{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new cl(this.times,this.values,this.getValueSize(),e)}};ro.prototype.ValueTypeName="quaternion";ro.prototype.InterpolantFactoryMethodSmooth=void 0;var qi=class extends Tn{constructor(e,t,n){super(e,t,n)}};qi.prototype.ValueTypeName="string";qi.prototype.ValueBufferType=Array;qi.prototype.DefaultInterpolation=Gr;qi.prototype.InterpolantFactoryMethodLinear=void 0;qi.prototype.InterpolantFactoryMethodSmooth=void 0;var hl=class extends Tn{constructor(e,t,n,s){super(e,t,n,s)}};hl.prototype.ValueTypeName="vector";var ul=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let m=c[u],g=c[u+1];if(m.global&&(m.lastIndex=0),m.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Lp=new ul,dl=class{constructor(e){this.manager=e!==void 0?e:Lp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};dl.DEFAULT_MATERIAL_NAME="__DEFAULT";var oo=class extends Xt{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Oe(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Uh=new ot,Vf=new C,Hf=new C,fl=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new He(512,512),this.mapType=xn,this.map=null,this.mapPass=null,this.matrix=new ot,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gi,this._frameExtents=new He(1,1),this._viewportCount=1,this._viewports=[new it(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Vf.setFromMatrixPosition(e.matrixWorld),t.position.copy(Vf),Hf.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Hf),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Uh.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Uh,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Ks||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Uh)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Ra=new C,Pa=new Un,ti=new C,ao=class extends Xt{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ot,this.projectionMatrix=new ot,this.projectionMatrixInverse=new ot,this.coordinateSystem=Nn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Ra,Pa,ti),ti.x===1&&ti.y===1&&ti.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ra,Pa,ti.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Ra,Pa,ti),ti.x===1&&ti.y===1&&ti.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ra,Pa,ti.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Vi=new C,Gf=new He,Wf=new He,cn=class extends ao{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Qs*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Vr*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Qs*2*Math.atan(Math.tan(Vr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Vi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Vi.x,Vi.y).multiplyScalar(-e/Vi.z),Vi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Vi.x,Vi.y).multiplyScalar(-e/Vi.z)}getViewSize(e,t){return this.getViewBounds(e,Gf,Wf),t.subVectors(Wf,Gf)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Vr*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ps=class extends ao{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Gh=class extends fl{constructor(){super(new ps(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},lo=class extends oo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Xt.DEFAULT_UP),this.updateMatrix(),this.target=new Xt,this.shadow=new Gh}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var ms=class{constructor(){this.isSphericalHarmonics3=!0,this.coefficients=[];for(let e=0;e<9;e++)this.coefficients.push(new C)}set(e){for(let t=0;t<9;t++)this.coefficients[t].copy(e[t]);return this}zero(){for(let e=0;e<9;e++)this.coefficients[e].set(0,0,0);return this}getAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.282095),t.addScaledVector(o[1],.488603*s),t.addScaledVector(o[2],.488603*r),t.addScaledVector(o[3],.488603*n),t.addScaledVector(o[4],1.092548*(n*s)),t.addScaledVector(o[5],1.092548*(s*r)),t.addScaledVector(o[6],.315392*(3*r*r-1)),t.addScaledVector(o[7],1.092548*(n*r)),t.addScaledVector(o[8],.546274*(n*n-s*s)),t}getIrradianceAt(e,t){let n=e.x,s=e.y,r=e.z,o=this.coefficients;return t.copy(o[0]).multiplyScalar(.886227),t.addScaledVector(o[1],2*.511664*s),t.addScaledVector(o[2],2*.511664*r),t.addScaledVector(o[3],2*.511664*n),t.addScaledVector(o[4],2*.429043*n*s),t.addScaledVector(o[5],2*.429043*s*r),t.addScaledVector(o[6],.743125*r*r-.247708),t.addScaledVector(o[7],2*.429043*n*r),t.addScaledVector(o[8],.429043*(n*n-s*s)),t}add(e){for(let t=0;t<9;t++)this.coefficients[t].add(e.coefficients[t]);return this}addScaledSH(e,t){for(let n=0;n<9;n++)this.coefficients[n].addScaledVector(e.coefficients[n],t);return this}scale(e){for(let t=0;t<9;t++)this.coefficients[t].multiplyScalar(e);return this}lerp(e,t){for(let n=0;n<9;n++)this.coefficients[n].lerp(e.coefficients[n],t);return this}equals(e){for(let t=0;t<9;t++)if(!this.coefficients[t].equals(e.coefficients[t]))return!1;return!0}copy(e){return this.set(e.coefficients)}clone(){return new this.constructor().copy(this)}fromArray(e,t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].fromArray(e,t+s*3);return this}toArray(e=[],t=0){let n=this.coefficients;for(let s=0;s<9;s++)n[s].toArray(e,t+s*3);return e}static getBasisAt(e,t){let n=e.x,s=e.y,r=e.z;t[0]=.282095,t[1]=.488603*s,t[2]=.488603*r,t[3]=.488603*n,t[4]=1.092548*n*s,t[5]=1.092548*s*r,t[6]=.315392*(3*r*r-1),t[7]=1.092548*n*r,t[8]=.546274*(n*n-s*s)}},co=class extends oo{constructor(e=new ms,t=1){super(void 0,t),this.isLightProbe=!0,this.type="LightProbe",this.sh=e}copy(e){return super.copy(e),this.sh.copy(e.sh),this}toJSON(e){let t=super.toJSON(e);return t.object.sh=this.sh.toArray(),t}};var ho=class extends Et{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Xs=-90,qs=1,ar=class extends Xt{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new cn(Xs,qs,e,t);s.layers=this.layers,this.add(s);let r=new cn(Xs,qs,e,t);r.layers=this.layers,this.add(r);let o=new cn(Xs,qs,e,t);o.layers=this.layers,this.add(o);let a=new cn(Xs,qs,e,t);a.layers=this.layers,this.add(a);let l=new cn(Xs,qs,e,t);l.layers=this.layers,this.add(l);let c=new cn(Xs,qs,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Nn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ks)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=e.getRenderTarget(),d=e.getActiveCubeFace(),m=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let y=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let p=!1;e.isWebGLRenderer===!0?p=e.state.buffers.depth.getReversed():p=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=y,e.setRenderTarget(n,5,s),p&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(u,d,m),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},pl=class extends cn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var wu="\\[\\]\\.:\\/",O0=new RegExp("["+wu+"]","g"),Eu="[^"+wu+"]",D0="[^"+wu.replace("\\.","")+"]",N0=/((?:WC+[\/:])*)/.source.replace("WC",Eu),U0=/(WCOD+)?/.source.replace("WCOD",D0),F0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Eu),B0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Eu),k0=new RegExp("^"+N0+U0+F0+B0+"$"),z0=["material","materials","bones","map"],Wh=class{constructor(e,t,n){let s=n||_t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},_t=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(O0,"")}static parseTrackName(e){let t=k0.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);z0.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Re("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){De("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){De("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){De("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){De("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){De("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){De("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;De("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){De("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};_t.Composite=Wh;_t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};_t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};_t.prototype.GetterByBindingType=[_t.prototype._getValue_direct,_t.prototype._getValue_array,_t.prototype._getValue_arrayElement,_t.prototype._getValue_toArray];_t.prototype.SetterByBindingTypeAndVersioning=[[_t.prototype._setValue_direct,_t.prototype._setValue_direct_setNeedsUpdate,_t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[_t.prototype._setValue_array,_t.prototype._setValue_array_setNeedsUpdate,_t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[_t.prototype._setValue_arrayElement,_t.prototype._setValue_arrayElement_setNeedsUpdate,_t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[_t.prototype._setValue_fromArray,_t.prototype._setValue_fromArray_setNeedsUpdate,_t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var kE=new Float32Array(1);var $i=class extends $a{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Xf=new ot,Yi=class{constructor(e,t,n=0,s=1/0){this.ray=new fs(e,t),this.near=n,this.far=s,this.camera=null,this.layers=new tr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):De("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return Xf.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Xf),this}intersectObject(e,t=!0,n=[]){return Xh(e,this,n,t),n.sort(qf),n}intersectObjects(e,t=!0,n=[]){for(let s=0,r=e.length;s<r;s++)Xh(e[s],this,n,t);return n.sort(qf),n}};function qf(i,e){return i.distance-e.distance}function Xh(i,e,t,n){let s=!0;if(i.layers.test(e.layers)&&i.raycast(e,t)===!1&&(s=!1),s===!0&&n===!0){let r=i.children;for(let o=0,a=r.length;o<a;o++)Xh(r[o],e,t,!0)}}var uo=class{constructor(e=1,t=0,n=0){this.radius=e,this.phi=t,this.theta=n}set(e,t,n){return this.radius=e,this.phi=t,this.theta=n,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ze(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,n){return this.radius=Math.sqrt(e*e+t*t+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,n),this.phi=Math.acos(ze(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var qh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};var $f=new C,Ia=new C,$s=new C,Ys=new C,Fh=new C,V0=new C,H0=new C,fo=class{constructor(e=new C,t=new C){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){$f.subVectors(e,this.start),Ia.subVectors(this.end,this.start);let n=Ia.dot(Ia);if(n===0)return 0;let r=Ia.dot($f)/n;return t&&(r=ze(r,0,1)),r}closestPointToPoint(e,t,n){let s=this.closestPointToPointParameter(e,t);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=V0,n=H0){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,h=e.end;$s.subVectors(c,a),Ys.subVectors(h,l),Fh.subVectors(a,l);let u=$s.dot($s),d=Ys.dot(Ys),m=Ys.dot(Fh);if(u<=s&&d<=s)return t.copy(a),n.copy(l),t.distanceToSquared(n);if(u<=s)r=0,o=m/d,o=ze(o,0,1);else{let g=$s.dot(Fh);if(d<=s)o=0,r=ze(-g/u,0,1);else{let y=$s.dot(Ys),p=u*d-y*y;p!==0?r=ze((y*m-g*d)/p,0,1):r=0,o=(y*r+m)/d,o<0?(o=0,r=ze(-g/u,0,1)):o>1&&(o=1,r=ze((y-g)/u,0,1))}}return t.copy(a).addScaledVector($s,r),n.copy(l).addScaledVector(Ys,o),t.distanceToSquared(n)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function Tu(i,e,t,n){let s=G0(n);switch(t){case hu:return i*e;case du:return i*e/s.components*s.byteLength;case Sl:return i*e/s.components*s.byteLength;case Zi:return i*e*2/s.components*s.byteLength;case Ml:return i*e*2/s.components*s.byteLength;case uu:return i*e*3/s.components*s.byteLength;case Jn:return i*e*4/s.components*s.byteLength;case wl:return i*e*4/s.components*s.byteLength;case _o:case yo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case xo:case vo:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Tl:case Cl:return Math.max(i,16)*Math.max(e,8)/4;case El:case Al:return Math.max(i,8)*Math.max(e,8)/2;case Rl:case Pl:case Ll:case Ol:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Il:case bo:case Dl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Nl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ul:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Fl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Bl:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case kl:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case zl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Vl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Hl:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Gl:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Wl:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Xl:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case ql:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case $l:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Yl:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Jl:case Zl:case Kl:return Math.ceil(i/4)*Math.ceil(e/4)*16;case jl:case Ql:return Math.ceil(i/4)*Math.ceil(e/4)*8;case So:case ec:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function G0(i){switch(i){case xn:case ou:return{byteLength:1,components:1};case ur:case au:case Yn:return{byteLength:2,components:1};case vl:case bl:return{byteLength:2,components:4};case qn:case xl:case $n:return{byteLength:4,components:1};case lu:case cu:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Re("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function em(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function X0(i){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,h),a.onUploadCallback();let m;if(c instanceof Float32Array)m=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)m=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?m=i.HALF_FLOAT:m=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)m=i.SHORT;else if(c instanceof Uint32Array)m=i.UNSIGNED_INT;else if(c instanceof Int32Array)m=i.INT;else if(c instanceof Int8Array)m=i.BYTE;else if(c instanceof Uint8Array)m=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)m=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:m,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,l,c){let h=l.array,u=l.updateRanges;if(i.bindBuffer(c,a),u.length===0)i.bufferSubData(c,0,h);else{u.sort((m,g)=>m.start-g.start);let d=0;for(let m=1;m<u.length;m++){let g=u[d],y=u[m];y.start<=g.start+g.count+1?g.count=Math.max(g.count,y.start+y.count-g.start):(++d,u[d]=y)}u.length=d+1;for(let m=0,g=u.length;m<g;m++){let y=u[m];i.bufferSubData(c,y.start*h.BYTES_PER_ELEMENT,h,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var q0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,$0=`#ifdef USE_ALPHAHASH
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
#endif`,Y0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,J0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Z0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,K0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,j0=`#ifdef USE_AOMAP
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
#endif`,Q0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ey=`#ifdef USE_BATCHING
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
#endif`,ty=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,ny=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,iy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,sy=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ry=`#ifdef USE_IRIDESCENCE
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
#endif`,oy=`#ifdef USE_BUMPMAP
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
#endif`,ay=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ly=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,cy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,hy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,uy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,dy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,fy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,py=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,my=`#define PI 3.141592653589793
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
} // validated`,gy=`vec3 transformedNormal = objectNormal;
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
#endif`,_y=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xy=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,vy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,by="gl_FragColor = linearToOutputTexel( gl_FragColor );",Sy=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,My=`#ifdef USE_ENVMAP
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
#endif`,wy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ey=`#ifdef USE_ENVMAP
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
#endif`,Ty=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ay=`#ifdef USE_ENVMAP
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
#endif`,Cy=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ry=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Py=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Iy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ly=`#ifdef USE_GRADIENTMAP
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
}`,Oy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Dy=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ny=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Uy=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Fy=`#ifdef USE_ENVMAP
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
#endif`,By=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ky=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Vy=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Hy=`PhysicalMaterial material;
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
#endif`,Gy=`uniform sampler2D dfgLUT;
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
}`,Wy=`
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
#endif`,Xy=`#if defined( RE_IndirectDiffuse )
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
#endif`,qy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,$y=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Yy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Jy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zy=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ky=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,jy=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Qy=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,ex=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,tx=`#if defined( USE_POINTS_UV )
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
#endif`,nx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ix=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,sx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,rx=`#if defined( USE_MORPHCOLORS )
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
#endif`,ox=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ax=`#ifdef USE_MORPHTARGETS
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
#endif`,lx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,hx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,ux=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,px=`#ifdef USE_NORMALMAP
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
#endif`,mx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,gx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_x=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,vx=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,bx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Sx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Mx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,wx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Ex=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Tx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Ax=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Cx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Rx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Px=`float getShadowMask() {
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
}`,Ix=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Lx=`#ifdef USE_SKINNING
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
#endif`,Ox=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Dx=`#ifdef USE_SKINNING
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
#endif`,Nx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ux=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Fx=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Bx=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,kx=`#ifdef USE_TRANSMISSION
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
#endif`,zx=`#ifdef USE_TRANSMISSION
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
#endif`,Vx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Hx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Gx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Wx=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Xx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,qx=`uniform sampler2D t2D;
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
}`,$x=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Yx=`uniform float backgroundBlurriness;
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
}`,Jx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Kx=`#include <common>
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
}`,jx=`#if DEPTH_PACKING == 3200
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
}`,Qx=`#define DISTANCE
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
}`,ev=`#define DISTANCE
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
}`,tv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,nv=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,iv=`uniform float scale;
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
}`,sv=`uniform vec3 diffuse;
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
}`,rv=`#include <common>
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
}`,ov=`uniform vec3 diffuse;
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
}`,av=`#define LAMBERT
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
}`,lv=`#define LAMBERT
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
}`,cv=`#define MATCAP
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
}`,hv=`#define MATCAP
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
}`,uv=`#define NORMAL
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
}`,dv=`#define NORMAL
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
}`,fv=`#define PHONG
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
}`,pv=`#define PHONG
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
}`,mv=`#define STANDARD
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
}`,gv=`#define STANDARD
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
}`,_v=`#define TOON
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
}`,yv=`#define TOON
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
}`,xv=`uniform float size;
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
}`,vv=`uniform vec3 diffuse;
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
}`,bv=`#include <common>
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
}`,Sv=`uniform vec3 color;
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
}`,Mv=`uniform float rotation;
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
}`,wv=`uniform vec3 diffuse;
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
}`,qe={alphahash_fragment:q0,alphahash_pars_fragment:$0,alphamap_fragment:Y0,alphamap_pars_fragment:J0,alphatest_fragment:Z0,alphatest_pars_fragment:K0,aomap_fragment:j0,aomap_pars_fragment:Q0,batching_pars_vertex:ey,batching_vertex:ty,begin_vertex:ny,beginnormal_vertex:iy,bsdfs:sy,iridescence_fragment:ry,bumpmap_pars_fragment:oy,clipping_planes_fragment:ay,clipping_planes_pars_fragment:ly,clipping_planes_pars_vertex:cy,clipping_planes_vertex:hy,color_fragment:uy,color_pars_fragment:dy,color_pars_vertex:fy,color_vertex:py,common:my,defaultnormal_vertex:gy,displacementmap_pars_vertex:_y,displacementmap_vertex:yy,emissivemap_fragment:xy,emissivemap_pars_fragment:vy,colorspace_fragment:by,colorspace_pars_fragment:Sy,envmap_fragment:My,envmap_common_pars_fragment:wy,envmap_pars_fragment:Ey,envmap_pars_vertex:Ty,envmap_physical_pars_fragment:Fy,envmap_vertex:Ay,fog_vertex:Cy,fog_pars_vertex:Ry,fog_fragment:Py,fog_pars_fragment:Iy,gradientmap_pars_fragment:Ly,lightmap_pars_fragment:Oy,lights_lambert_fragment:Dy,lights_lambert_pars_fragment:Ny,lights_pars_begin:Uy,lights_toon_fragment:By,lights_toon_pars_fragment:ky,lights_phong_fragment:zy,lights_phong_pars_fragment:Vy,lights_physical_fragment:Hy,lights_physical_pars_fragment:Gy,lights_fragment_begin:Wy,lights_fragment_maps:Xy,lights_fragment_end:qy,lightprobes_pars_fragment:$y,logdepthbuf_fragment:Yy,logdepthbuf_pars_fragment:Jy,logdepthbuf_pars_vertex:Zy,logdepthbuf_vertex:Ky,map_fragment:jy,map_pars_fragment:Qy,map_particle_fragment:ex,map_particle_pars_fragment:tx,metalnessmap_fragment:nx,metalnessmap_pars_fragment:ix,morphinstance_vertex:sx,morphcolor_vertex:rx,morphnormal_vertex:ox,morphtarget_pars_vertex:ax,morphtarget_vertex:lx,normal_fragment_begin:cx,normal_fragment_maps:hx,normal_pars_fragment:ux,normal_pars_vertex:dx,normal_vertex:fx,normalmap_pars_fragment:px,clearcoat_normal_fragment_begin:mx,clearcoat_normal_fragment_maps:gx,clearcoat_pars_fragment:_x,iridescence_pars_fragment:yx,opaque_fragment:xx,packing:vx,premultiplied_alpha_fragment:bx,project_vertex:Sx,dithering_fragment:Mx,dithering_pars_fragment:wx,roughnessmap_fragment:Ex,roughnessmap_pars_fragment:Tx,shadowmap_pars_fragment:Ax,shadowmap_pars_vertex:Cx,shadowmap_vertex:Rx,shadowmask_pars_fragment:Px,skinbase_vertex:Ix,skinning_pars_vertex:Lx,skinning_vertex:Ox,skinnormal_vertex:Dx,specularmap_fragment:Nx,specularmap_pars_fragment:Ux,tonemapping_fragment:Fx,tonemapping_pars_fragment:Bx,transmission_fragment:kx,transmission_pars_fragment:zx,uv_pars_fragment:Vx,uv_pars_vertex:Hx,uv_vertex:Gx,worldpos_vertex:Wx,background_vert:Xx,background_frag:qx,backgroundCube_vert:$x,backgroundCube_frag:Yx,cube_vert:Jx,cube_frag:Zx,depth_vert:Kx,depth_frag:jx,distance_vert:Qx,distance_frag:ev,equirect_vert:tv,equirect_frag:nv,linedashed_vert:iv,linedashed_frag:sv,meshbasic_vert:rv,meshbasic_frag:ov,meshlambert_vert:av,meshlambert_frag:lv,meshmatcap_vert:cv,meshmatcap_frag:hv,meshnormal_vert:uv,meshnormal_frag:dv,meshphong_vert:fv,meshphong_frag:pv,meshphysical_vert:mv,meshphysical_frag:gv,meshtoon_vert:_v,meshtoon_frag:yv,points_vert:xv,points_frag:vv,shadow_vert:bv,shadow_frag:Sv,sprite_vert:Mv,sprite_frag:wv},pe={common:{diffuse:{value:new Oe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ue},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ue}},envmap:{envMap:{value:null},envMapRotation:{value:new Ue},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ue}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ue}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ue},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ue},normalScale:{value:new He(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ue},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ue}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ue}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ue}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Oe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Oe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0},uvTransform:{value:new Ue}},sprite:{diffuse:{value:new Oe(16777215)},opacity:{value:1},center:{value:new He(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ue},alphaMap:{value:null},alphaMapTransform:{value:new Ue},alphaTest:{value:0}}},fn={basic:{uniforms:on([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.fog]),vertexShader:qe.meshbasic_vert,fragmentShader:qe.meshbasic_frag},lambert:{uniforms:on([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Oe(0)},envMapIntensity:{value:1}}]),vertexShader:qe.meshlambert_vert,fragmentShader:qe.meshlambert_frag},phong:{uniforms:on([pe.common,pe.specularmap,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,pe.lights,{emissive:{value:new Oe(0)},specular:{value:new Oe(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:qe.meshphong_vert,fragmentShader:qe.meshphong_frag},standard:{uniforms:on([pe.common,pe.envmap,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.roughnessmap,pe.metalnessmap,pe.fog,pe.lights,{emissive:{value:new Oe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:qe.meshphysical_vert,fragmentShader:qe.meshphysical_frag},toon:{uniforms:on([pe.common,pe.aomap,pe.lightmap,pe.emissivemap,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.gradientmap,pe.fog,pe.lights,{emissive:{value:new Oe(0)}}]),vertexShader:qe.meshtoon_vert,fragmentShader:qe.meshtoon_frag},matcap:{uniforms:on([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,pe.fog,{matcap:{value:null}}]),vertexShader:qe.meshmatcap_vert,fragmentShader:qe.meshmatcap_frag},points:{uniforms:on([pe.points,pe.fog]),vertexShader:qe.points_vert,fragmentShader:qe.points_frag},dashed:{uniforms:on([pe.common,pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:qe.linedashed_vert,fragmentShader:qe.linedashed_frag},depth:{uniforms:on([pe.common,pe.displacementmap]),vertexShader:qe.depth_vert,fragmentShader:qe.depth_frag},normal:{uniforms:on([pe.common,pe.bumpmap,pe.normalmap,pe.displacementmap,{opacity:{value:1}}]),vertexShader:qe.meshnormal_vert,fragmentShader:qe.meshnormal_frag},sprite:{uniforms:on([pe.sprite,pe.fog]),vertexShader:qe.sprite_vert,fragmentShader:qe.sprite_frag},background:{uniforms:{uvTransform:{value:new Ue},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:qe.background_vert,fragmentShader:qe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ue}},vertexShader:qe.backgroundCube_vert,fragmentShader:qe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:qe.cube_vert,fragmentShader:qe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:qe.equirect_vert,fragmentShader:qe.equirect_frag},distance:{uniforms:on([pe.common,pe.displacementmap,{referencePosition:{value:new C},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:qe.distance_vert,fragmentShader:qe.distance_frag},shadow:{uniforms:on([pe.lights,pe.fog,{color:{value:new Oe(0)},opacity:{value:1}}]),vertexShader:qe.shadow_vert,fragmentShader:qe.shadow_frag}};fn.physical={uniforms:on([fn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ue},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ue},clearcoatNormalScale:{value:new He(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ue},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ue},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ue},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ue},sheen:{value:0},sheenColor:{value:new Oe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ue},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ue},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ue},transmissionSamplerSize:{value:new He},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ue},attenuationDistance:{value:0},attenuationColor:{value:new Oe(0)},specularColor:{value:new Oe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ue},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ue},anisotropyVector:{value:new He},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ue}}]),vertexShader:qe.meshphysical_vert,fragmentShader:qe.meshphysical_frag};var nc={r:0,b:0,g:0},Ev=new ot,tm=new Ue;tm.set(-1,0,0,0,1,0,0,0,1);function Tv(i,e,t,n,s,r){let o=new Oe(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function m(x){let w=x.isScene===!0?x.background:null;if(w&&w.isTexture){let M=x.backgroundBlurriness>0;w=e.get(w,M)}return w}function g(x){let w=!1,M=m(x);M===null?p(o,a):M&&M.isColor&&(p(M,1),w=!0);let v=i.xr.getEnvironmentBlendMode();v==="additive"?t.buffers.color.setClear(0,0,0,1,r):v==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function y(x,w){let M=m(w);M&&M.isCubeTexture?(c===void 0&&(c=new Lt(new or(1,1,1),new Ot({name:"BackgroundCubeMaterial",uniforms:xs(fn.backgroundCube.uniforms),vertexShader:fn.backgroundCube.vertexShader,fragmentShader:fn.backgroundCube.fragmentShader,side:dn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(v,b,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Ev.makeRotationFromEuler(w.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(tm),c.material.toneMapped=Qe.getTransfer(M.colorSpace)!==at,(h!==M||u!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Lt(new ri(2,2),new Ot({name:"BackgroundMaterial",uniforms:xs(fn.background.uniforms),vertexShader:fn.background.vertexShader,fragmentShader:fn.background.fragmentShader,side:Ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Qe.getTransfer(M.colorSpace)!==at,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=i.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function p(x,w){x.getRGB(nc,Mu(i)),t.buffers.color.setClear(nc.r,nc.g,nc.b,w,r)}function f(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,w=1){o.set(x),a=w,p(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,p(o,a)},render:g,addToRenderList:y,dispose:f}}function Av(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(D,k,W,I,V){let j=!1,z=u(D,I,W,k);r!==z&&(r=z,c(r.object)),j=m(D,I,W,V),j&&g(D,I,W,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,M(D,k,W,I),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function u(D,k,W,I){let V=I.wireframe===!0,j=n[k.id];j===void 0&&(j={},n[k.id]=j);let z=D.isInstancedMesh===!0?D.id:0,ie=j[z];ie===void 0&&(ie={},j[z]=ie);let q=ie[W.id];q===void 0&&(q={},ie[W.id]=q);let Q=q[V];return Q===void 0&&(Q=d(l()),q[V]=Q),Q}function d(D){let k=[],W=[],I=[];for(let V=0;V<t;V++)k[V]=0,W[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:W,attributeDivisors:I,object:D,attributes:{},index:null}}function m(D,k,W,I){let V=r.attributes,j=k.attributes,z=0,ie=W.getAttributes();for(let q in ie)if(ie[q].location>=0){let te=V[q],Ee=j[q];if(Ee===void 0&&(q==="instanceMatrix"&&D.instanceMatrix&&(Ee=D.instanceMatrix),q==="instanceColor"&&D.instanceColor&&(Ee=D.instanceColor)),te===void 0||te.attribute!==Ee||Ee&&te.data!==Ee.data)return!0;z++}return r.attributesNum!==z||r.index!==I}function g(D,k,W,I){let V={},j=k.attributes,z=0,ie=W.getAttributes();for(let q in ie)if(ie[q].location>=0){let te=j[q];te===void 0&&(q==="instanceMatrix"&&D.instanceMatrix&&(te=D.instanceMatrix),q==="instanceColor"&&D.instanceColor&&(te=D.instanceColor));let Ee={};Ee.attribute=te,te&&te.data&&(Ee.data=te.data),V[q]=Ee,z++}r.attributes=V,r.attributesNum=z,r.index=I}function y(){let D=r.newAttributes;for(let k=0,W=D.length;k<W;k++)D[k]=0}function p(D){f(D,0)}function f(D,k){let W=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;W[D]=1,I[D]===0&&(i.enableVertexAttribArray(D),I[D]=1),V[D]!==k&&(i.vertexAttribDivisor(D,k),V[D]=k)}function x(){let D=r.newAttributes,k=r.enabledAttributes;for(let W=0,I=k.length;W<I;W++)k[W]!==D[W]&&(i.disableVertexAttribArray(W),k[W]=0)}function w(D,k,W,I,V,j,z){z===!0?i.vertexAttribIPointer(D,k,W,V,j):i.vertexAttribPointer(D,k,W,I,V,j)}function M(D,k,W,I){y();let V=I.attributes,j=W.getAttributes(),z=k.defaultAttributeValues;for(let ie in j){let q=j[ie];if(q.location>=0){let Q=V[ie];if(Q===void 0&&(ie==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ie==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let te=Q.normalized,Ee=Q.itemSize,Be=e.get(Q);if(Be===void 0)continue;let J=Be.buffer,_e=Be.type,be=Be.bytesPerElement,Pe=_e===i.INT||_e===i.UNSIGNED_INT||Q.gpuType===xl;if(Q.isInterleavedBufferAttribute){let ye=Q.data,Ve=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,At=Q.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let Le=0;Le<q.locationSize;Le++)f(q.location+Le,ye.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let Le=0;Le<q.locationSize;Le++)p(q.location+Le);i.bindBuffer(i.ARRAY_BUFFER,J);for(let Le=0;Le<q.locationSize;Le++)w(q.location+Le,Ee/q.locationSize,_e,te,Ve*be,(At+Ee/q.locationSize*Le)*be,Pe)}else{if(Q.isInstancedBufferAttribute){for(let ye=0;ye<q.locationSize;ye++)f(q.location+ye,Q.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ye=0;ye<q.locationSize;ye++)p(q.location+ye);i.bindBuffer(i.ARRAY_BUFFER,J);for(let ye=0;ye<q.locationSize;ye++)w(q.location+ye,Ee/q.locationSize,_e,te,Ee*be,Ee/q.locationSize*ye*be,Pe)}}else if(z!==void 0){let te=z[ie];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(q.location,te);break;case 3:i.vertexAttrib3fv(q.location,te);break;case 4:i.vertexAttrib4fv(q.location,te);break;default:i.vertexAttrib1fv(q.location,te)}}}}x()}function v(){O();for(let D in n){let k=n[D];for(let W in k){let I=k[W];for(let V in I){let j=I[V];for(let z in j)h(j[z].object),delete j[z];delete I[V]}}delete n[D]}}function b(D){if(n[D.id]===void 0)return;let k=n[D.id];for(let W in k){let I=k[W];for(let V in I){let j=I[V];for(let z in j)h(j[z].object),delete j[z];delete I[V]}}delete n[D.id]}function _(D){for(let k in n){let W=n[k];for(let I in W){let V=W[I];if(V[D.id]===void 0)continue;let j=V[D.id];for(let z in j)h(j[z].object),delete j[z];delete V[D.id]}}}function T(D){for(let k in n){let W=n[k],I=D.isInstancedMesh===!0?D.id:0,V=W[I];if(V!==void 0){for(let j in V){let z=V[j];for(let ie in z)h(z[ie].object),delete z[ie];delete V[j]}delete W[I],Object.keys(W).length===0&&delete n[k]}}}function O(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:P,dispose:v,releaseStatesOfGeometry:b,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:y,enableAttribute:p,disableUnusedAttributes:x}}function Cv(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),t.update(c,n,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let d=0;for(let m=0;m<h;m++)d+=c[m];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Rv(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Jn&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===Yn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==xn&&_!==$n&&!T&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(Re("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&u===!1;t.reversedDepthBuffer===!0&&u===!1&&Re("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&u===!0&&Re("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let m=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=i.getParameter(i.MAX_TEXTURE_SIZE),p=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),f=i.getParameter(i.MAX_VERTEX_ATTRIBS),x=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),w=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),v=i.getParameter(i.MAX_SAMPLES),b=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:m,maxVertexTextures:g,maxTextureSize:y,maxCubemapSize:p,maxAttributes:f,maxVertexUniforms:x,maxVaryings:w,maxFragmentUniforms:M,maxSamples:v,samples:b}}function Pv(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Gn,a=new Ue,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let m=u.length!==0||d||n!==0||s;return s=d,n=u.length,m},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){t=h(u,d,0)},this.setState=function(u,d,m){let g=u.clippingPlanes,y=u.clipIntersection,p=u.clipShadows,f=i.get(u);if(!s||g===null||g.length===0||r&&!p)r?h(null):c();else{let x=r?0:n,w=x*4,M=f.clippingState||null;l.value=M,M=h(g,d,w,m);for(let v=0;v!==w;++v)M[v]=t[v];f.clippingState=M,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function h(u,d,m,g){let y=u!==null?u.length:0,p=null;if(y!==0){if(p=l.value,g!==!0||p===null){let f=m+y*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(p===null||p.length<f)&&(p=new Float32Array(f));for(let w=0,M=m;w!==y;++w,M+=4)o.copy(u[w]).applyMatrix4(x,a),o.normal.toArray(p,M),p[M+3]=o.constant}l.value=p,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,p}}var Ao=class extends sn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Qr(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new or(5,5,5),r=new Ot({name:"CubemapFromEquirect",uniforms:xs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:dn,blending:oi});r.uniforms.tEquirect.value=t;let o=new Lt(s,r),a=t.minFilter;return t.minFilter===Ai&&(t.minFilter=hn),new ar(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Op=256,Iv=3,Lv=20,nm=256,im=16,Ov=3,Dv=new C,Nv=new Oe,sc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ar(1,10,null),this._boxMesh=new Lt(new or(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=Dv}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,m=l.autoClearDepth,g=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(Nv));let p=new ar(n,s,h);return p.position.copy(a),p.update(l,e),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=m,l.autoClearStencil=g,e.background=y,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Up(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Np(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Op,xu(e))}_fromTexture(e,t){e.mapping===_s||e.mapping===hr?this._setSize(e.image.length===0?Op:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Dp(e,!1,!1),n=Math.log2(e)-Iv;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Dp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===_s||e.mapping===hr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Up()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Np()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Uv(),this._integrationMaterial=Fv());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/im);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Ov)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(nm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=Bv());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Dp(i,e,t){return new Ao(i,{minFilter:Ai,generateMipmaps:e,type:Yn,colorSpace:Wr,depthBuffer:t})}function Co(i,e,t){return new Ot({name:i,uniforms:e,vertexShader:qe.cube_vert,fragmentShader:t,side:dn,blending:oi,depthTest:!1,depthWrite:!1})}function Uv(){return Co("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${nm}u

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
	`)}function Fv(){return Co("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:im}},`

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
	`)}function Bv(){return Co("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Lv}
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
	`)}function Np(){return Co("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Up(){return Co("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function kv(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,m=!1){return d==null?null:m?o(d):r(d)}function r(d){if(d&&d.isTexture){let m=d.mapping;if(m===gl||m===_l)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let y=new Ao(g.height);return y.fromEquirectangularTexture(i,d),e.set(d,y),d.addEventListener("dispose",c),a(y.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let m=d.mapping,g=m===gl||m===_l,y=m===_s||m===hr;if(g||y){let p=t.get(d),f=p!==void 0?p.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==f)return n===null&&(n=new sc(i)),p=g?n.fromEquirectangular(d,p):n.fromCubemap(d,p),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),p.texture;if(p!==void 0)return p.texture;{let x=d.image;return g&&x&&x.height>0||y&&x&&l(x)?(n===null&&(n=new sc(i)),p=g?n.fromEquirectangular(d):n.fromCubemap(d),p.texture.pmremVersion=d.pmremVersion,t.set(d,p),d.addEventListener("dispose",h),p.texture):null}}}return d}function a(d,m){return m===gl?d.mapping=_s:m===_l&&(d.mapping=hr),d}function l(d){let m=0,g=6;for(let y=0;y<g;y++)d[y]!==void 0&&m++;return m===g}function c(d){let m=d.target;m.removeEventListener("dispose",c);let g=e.get(m);g!==void 0&&(e.delete(m),g.dispose())}function h(d){let m=d.target;m.removeEventListener("dispose",h);let g=t.get(m);g!==void 0&&(t.delete(m),g.dispose())}function u(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function zv(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&zr("WebGLRenderer: "+n+" extension not supported."),s}}}function Vv(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let p in g.attributes)e.remove(g.attributes[p]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let y=r.get(g);y&&(e.remove(y),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function h(g){let y=g.attributes;for(let p in y)e.update(y[p],i.ARRAY_BUFFER)}function u(g){let y=g.index,p=g.attributes.position,f=0;if(p===void 0)return;let x=y!==null?y.array.length:p.array.length/3-1,w=p.count>=65535?Kr:Zr,M=new w(Math.ceil(x/3)*6,1),v=M.array;if(y!==null){let _=y.array;f=y.version;for(let T=0,O=0;T<x;T+=3){let P=_[T+0],D=_[T+1],k=_[T+2];v[O++]=P,v[O++]=D,v[O++]=D,v[O++]=k,v[O++]=k,v[O++]=P}}else{f=p.version;for(let _=0,T=0;_<x;_+=3){let O=_+0,P=_+1,D=_+2;v[T++]=O,v[T++]=P,v[T++]=P,v[T++]=D,v[T++]=D,v[T++]=O}}M.version=f;let b=r.get(g);b&&e.remove(b),r.set(g,M)}function d(g){let y=r.get(g);if(y){let p=g.index;p!==null&&y.version<p.version&&u(g)}else u(g);return r.get(g)}function m(){for(let g in s){let y=s[g].deref();y!==void 0&&l(y)}}return{get:c,update:h,getWireframeAttribute:d,dispose:m}}function Hv(i,e,t){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){i.drawElements(n,d,r,u*o),t.update(d,n,1)}function c(u,d,m){m!==0&&(i.drawElementsInstanced(n,d,r,u*o,m),t.update(d,n,m))}function h(u,d,m){if(m===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,m);let y=0;for(let p=0;p<m;p++)y+=d[p];t.update(y,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Gv(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:De("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function Wv(i,e,t){let n=new WeakMap,s=new it;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let P=function(){T.dispose(),n.delete(a),a.removeEventListener("dispose",P)};var m=P;d!==void 0&&d.texture.dispose();let g=a.morphAttributes.position!==void 0,y=a.morphAttributes.normal!==void 0,p=a.morphAttributes.color!==void 0,f=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],w=a.morphAttributes.color||[],M=0;g===!0&&(M=1),y===!0&&(M=2),p===!0&&(M=3);let v=a.attributes.position.count*M,b=1;v>e.maxTextureSize&&(b=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let _=new Float32Array(v*b*4*u),T=new Yr(_,v,b,u);T.type=$n,T.needsUpdate=!0;let O=M*4;for(let D=0;D<u;D++){let k=f[D],W=x[D],I=w[D],V=v*b*4*D;for(let j=0;j<k.count;j++){let z=j*O;g===!0&&(s.fromBufferAttribute(k,j),_[V+z+0]=s.x,_[V+z+1]=s.y,_[V+z+2]=s.z,_[V+z+3]=0),y===!0&&(s.fromBufferAttribute(W,j),_[V+z+4]=s.x,_[V+z+5]=s.y,_[V+z+6]=s.z,_[V+z+7]=0),p===!0&&(s.fromBufferAttribute(I,j),_[V+z+8]=s.x,_[V+z+9]=s.y,_[V+z+10]=s.z,_[V+z+11]=I.itemSize===4?s.w:1)}}d={count:u,texture:T,size:new He(v,b)},n.set(a,d),a.addEventListener("dispose",P)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let g=0;for(let p=0;p<c.length;p++)g+=c[p];let y=a.morphTargetsRelative?1:1-g;l.getUniforms().setValue(i,"morphTargetBaseInfluence",y),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function Xv(i,e,t,n,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=e.get(c,u);if(r.get(d)!==h&&(e.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let m=c.skeleton;r.get(m)!==h&&(m.update(),r.set(m,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var qv={[Qh]:"LINEAR_TONE_MAPPING",[eu]:"REINHARD_TONE_MAPPING",[tu]:"CINEON_TONE_MAPPING",[nu]:"ACES_FILMIC_TONE_MAPPING",[su]:"AGX_TONE_MAPPING",[mo]:"NEUTRAL_TONE_MAPPING",[iu]:"CUSTOM_TONE_MAPPING"};function $v(i,e,t,n,s,r){let o=new sn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Et;h.setAttribute("position",new Vt([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Vt([0,2,0,0,2,0],2));let u=new el({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Lt(h,u),m=new ps(-1,1,1,-1,0,1),g=null,y=null,p=!1,f,x=null,w=[],M=!1;this.setSize=function(v,b){o.setSize(v,b),a!==null&&a.setSize(v,b),l!==null&&l.setSize(v,b);for(let _=0;_<w.length;_++){let T=w[_];T.setSize&&T.setSize(v,b)}},this.setEffects=function(v){w=v,M=w.length>0&&w[0].isRenderPass===!0;let b=o.width,_=o.height;w.length>0&&a===null&&(a=new sn(b,_,{type:Yn,depthBuffer:!1,stencilBuffer:!1}),l=new sn(b,_,{type:Yn,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&w.some(O=>O.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ti(b,_),r===!0&&(c.format=Ci,c.type=ys)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let O=0;O<w.length;O++){let P=w[O];P.setSize&&P.setSize(b,_),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(v,b){if(p||v.toneMapping===ai&&w.length===0)return!1;if(x=b,b!==null){let _=b.width,T=b.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return M===!1&&v.setRenderTarget(o),f=v.toneMapping,v.toneMapping=ai,!0},this.hasRenderPass=function(){return M},this.end=function(v,b){v.toneMapping=f,p=!0;let _=o,T=a;for(let O=0;O<w.length;O++){let P=w[O];P.enabled!==!1&&(P.render(v,T,_,b),P.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(g!==v.outputColorSpace||y!==v.toneMapping){g=v.outputColorSpace,y=v.toneMapping,u.defines={},Qe.getTransfer(g)===at&&(u.defines.SRGB_TRANSFER="");let O=qv[y];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,v.setRenderTarget(x),v.render(d,m),x=null,p=!1},this.isCompositing=function(){return p},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var sm=new yn,rm=new Ti(1,1),om=new eo(1),am=new Yr,lm=new qa,cm=new Qr,Fp=[],Bp=[],kp=new Float32Array(16),zp=new Float32Array(9),Vp=new Float32Array(4);function fr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Fp[s];if(r===void 0&&(r=new Float32Array(s),Fp[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Dt(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Nt(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function oc(i,e){let t=Bp[e];t===void 0&&(t=new Int32Array(e),Bp[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function Yv(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function Jv(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dt(t,e))return;i.uniform2fv(this.addr,e),Nt(t,e)}}function Zv(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Dt(t,e))return;i.uniform3fv(this.addr,e),Nt(t,e)}}function Kv(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dt(t,e))return;i.uniform4fv(this.addr,e),Nt(t,e)}}function jv(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Dt(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Nt(t,e)}else{if(Dt(t,n))return;Vp.set(n),i.uniformMatrix2fv(this.addr,!1,Vp),Nt(t,n)}}function Qv(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Dt(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Nt(t,e)}else{if(Dt(t,n))return;zp.set(n),i.uniformMatrix3fv(this.addr,!1,zp),Nt(t,n)}}function eb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Dt(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Nt(t,e)}else{if(Dt(t,n))return;kp.set(n),i.uniformMatrix4fv(this.addr,!1,kp),Nt(t,n)}}function tb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function nb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dt(t,e))return;i.uniform2iv(this.addr,e),Nt(t,e)}}function ib(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Dt(t,e))return;i.uniform3iv(this.addr,e),Nt(t,e)}}function sb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dt(t,e))return;i.uniform4iv(this.addr,e),Nt(t,e)}}function rb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function ob(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Dt(t,e))return;i.uniform2uiv(this.addr,e),Nt(t,e)}}function ab(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Dt(t,e))return;i.uniform3uiv(this.addr,e),Nt(t,e)}}function lb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Dt(t,e))return;i.uniform4uiv(this.addr,e),Nt(t,e)}}function ac(i){return i.version===0&&(i.compareFunction=mu,i.needsUpdate=!0),i}function cb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ac(rm):r=sm,t.setTexture2D(e||r,s)}function hb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||lm,s)}function ub(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ac(om):r=cm,t.setTextureCube(e||r,s)}function db(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||am,s)}function fb(i){switch(i){case 5126:return Yv;case 35664:return Jv;case 35665:return Zv;case 35666:return Kv;case 35674:return jv;case 35675:return Qv;case 35676:return eb;case 5124:case 35670:return tb;case 35667:case 35671:return nb;case 35668:case 35672:return ib;case 35669:case 35673:return sb;case 5125:return rb;case 36294:return ob;case 36295:return ab;case 36296:return lb;case 35678:case 36198:case 36298:case 36306:case 35682:return cb;case 35679:case 36299:case 36307:return hb;case 35680:case 36300:case 36308:case 36293:return ub;case 36289:case 36303:case 36311:case 36292:return db}}function pb(i,e){i.uniform1fv(this.addr,e)}function mb(i,e){let t=fr(e,this.size,2);i.uniform2fv(this.addr,t)}function gb(i,e){let t=fr(e,this.size,3);i.uniform3fv(this.addr,t)}function _b(i,e){let t=fr(e,this.size,4);i.uniform4fv(this.addr,t)}function yb(i,e){let t=fr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function xb(i,e){let t=fr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function vb(i,e){let t=fr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function bb(i,e){i.uniform1iv(this.addr,e)}function Sb(i,e){i.uniform2iv(this.addr,e)}function Mb(i,e){i.uniform3iv(this.addr,e)}function wb(i,e){i.uniform4iv(this.addr,e)}function Eb(i,e){i.uniform1uiv(this.addr,e)}function Tb(i,e){i.uniform2uiv(this.addr,e)}function Ab(i,e){i.uniform3uiv(this.addr,e)}function Cb(i,e){i.uniform4uiv(this.addr,e)}function Rb(i,e,t){let n=this.cache,s=e.length,r=oc(t,s);Dt(n,r)||(i.uniform1iv(this.addr,r),Nt(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=ac(rm):o=sm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Pb(i,e,t){let n=this.cache,s=e.length,r=oc(t,s);Dt(n,r)||(i.uniform1iv(this.addr,r),Nt(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||lm,r[o])}function Ib(i,e,t){let n=this.cache,s=e.length,r=oc(t,s);Dt(n,r)||(i.uniform1iv(this.addr,r),Nt(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=ac(om):o=cm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Lb(i,e,t){let n=this.cache,s=e.length,r=oc(t,s);Dt(n,r)||(i.uniform1iv(this.addr,r),Nt(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||am,r[o])}function Ob(i){switch(i){case 5126:return pb;case 35664:return mb;case 35665:return gb;case 35666:return _b;case 35674:return yb;case 35675:return xb;case 35676:return vb;case 5124:case 35670:return bb;case 35667:case 35671:return Sb;case 35668:case 35672:return Mb;case 35669:case 35673:return wb;case 5125:return Eb;case 36294:return Tb;case 36295:return Ab;case 36296:return Cb;case 35678:case 36198:case 36298:case 36306:case 35682:return Rb;case 35679:case 36299:case 36307:return Pb;case 35680:case 36300:case 36308:case 36293:return Ib;case 36289:case 36303:case 36311:case 36292:return Lb}}var Ru=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=fb(t.type)}},Pu=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ob(t.type)}},Iu=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Au=/(\w+)(\])?(\[|\.)?/g;function Hp(i,e){i.seq.push(e),i.map[e.id]=e}function Db(i,e,t){let n=i.name,s=n.length;for(Au.lastIndex=0;;){let r=Au.exec(n),o=Au.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Hp(t,c===void 0?new Ru(a,i,e):new Pu(a,i,e));break}else{let u=t.map[a];u===void 0&&(u=new Iu(a),Hp(t,u)),t=u}}}var dr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);Db(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Gp(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Nb=37297,Ub=0;function Fb(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var Wp=new Ue;function Bb(i){Qe._getMatrix(Wp,Qe.workingColorSpace,i);let e=`mat3( ${Wp.elements.map(t=>t.toFixed(4))} )`;switch(Qe.getTransfer(i)){case Xr:return[e,"LinearTransferOETF"];case at:return[e,"sRGBTransferOETF"];default:return Re("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Xp(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Fb(i.getShaderSource(e),a)}else return r}function kb(i,e){let t=Bb(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var zb={[Qh]:"Linear",[eu]:"Reinhard",[tu]:"Cineon",[nu]:"ACESFilmic",[su]:"AgX",[mo]:"Neutral",[iu]:"Custom"};function Vb(i,e){let t=zb[e];return t===void 0?(Re("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ic=new C;function Hb(){Qe.getLuminanceCoefficients(ic);let i=ic.x.toFixed(4),e=ic.y.toFixed(4),t=ic.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Gb(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(To).join(`
`)}function Wb(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Xb(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function To(i){return i!==""}function qp(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function $p(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var qb=/^[ \t]*#include +<([\w\d./]+)>/gm;function Lu(i){return i.replace(qb,$b)}function $b(i,e){let t=qe[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Lu(t)}var Yb=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Yp(i){return i.replace(Yb,Jb)}function Jb(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Jp(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var Zb={[po]:"SHADOWMAP_TYPE_PCF",[lr]:"SHADOWMAP_TYPE_VSM"};function Kb(i){return Zb[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var jb={[hr]:"ENVMAP_MODE_REFRACTION"};function Qb(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":jb[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var eS={[ml]:"ENVMAP_BLENDING_MULTIPLY",[mp]:"ENVMAP_BLENDING_MIX",[gp]:"ENVMAP_BLENDING_ADD"};function tS(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":eS[i.combine]||"ENVMAP_BLENDING_NONE"}function nS(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=Kb(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Qb(t),u=tS(t),d=Gb(t),m=Wb(r),g=s.createProgram(),y,p,f=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(To).join(`
`),y.length>0&&(y+=`
`),p=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m].filter(To).join(`
`),p.length>0&&(p+=`
`)):(y=[Jp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(To).join(`
`),p=[Jp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,m,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+u:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ai?"#define TONE_MAPPING":"",t.toneMapping!==ai?qe.tonemapping_pars_fragment:"",t.toneMapping!==ai?Vb("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",qe.colorspace_pars_fragment,kb("linearToOutputTexel",t.outputColorSpace),Hb(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(To).join(`
`)),o=Lu(o),o=qp(o,t),o=$p(o,t),a=Lu(a),a=qp(a,t),a=$p(a,t),o=Yp(o),a=Yp(a),t.isRawShaderMaterial!==!0&&(f=`#version 300 es
`,y=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,p=["#define varying in",t.glslVersion===_u?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===_u?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);let x=f+y+o,w=f+p+a,M=Gp(s,s.VERTEX_SHADER,x),v=Gp(s,s.FRAGMENT_SHADER,w);s.attachShader(g,M),s.attachShader(g,v),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function b(P){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(M)||"",W=s.getShaderInfoLog(v)||"",I=D.trim(),V=k.trim(),j=W.trim(),z=!0,ie=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,M,v);else{let q=Xp(s,M,"vertex"),Q=Xp(s,v,"fragment");De("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+I+`
`+q+`
`+Q)}else I!==""?Re("WebGLProgram: Program Info Log:",I):(V===""||j==="")&&(ie=!1);ie&&(P.diagnostics={runnable:z,programLog:I,vertexShader:{log:V,prefix:y},fragmentShader:{log:j,prefix:p}})}s.deleteShader(M),s.deleteShader(v),_=new dr(s,g),T=Xb(s,g)}let _;this.getUniforms=function(){return _===void 0&&b(this),_};let T;this.getAttributes=function(){return T===void 0&&b(this),T};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(g,Nb)),O},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Ub++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=v,this}var iS=0,Ou=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Du(e),t.set(e,n)),n}},Du=class{constructor(e){this.id=iS++,this.code=e,this.usedTimes=0}};function sS(i){return i===Zi||i===bo||i===So}function rS(i,e,t,n,s,r){let o=new tr,a=new Ou,l=new Set,c=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function m(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,T,O,P,D,k){let W=P.fog,I=D.geometry,V=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?P.environment:null,j=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,z=e.get(_.envMap||V,j),ie=d[_.type],q=n.precision;_.precision!==null&&(q=n.getMaxPrecision(_.precision),q!==_.precision&&Re("WebGLProgram.getParameters:",_.precision,"not supported, using",q,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,te=Q!==void 0?Q.length:0,Ee=0;I.morphAttributes.position!==void 0&&(Ee=1),I.morphAttributes.normal!==void 0&&(Ee=2),I.morphAttributes.color!==void 0&&(Ee=3);let Be,J,_e,be;if(ie){let ge=fn[ie];Be=ge.vertexShader,J=ge.fragmentShader}else{Be=_.vertexShader,J=_.fragmentShader;let ge=a.getVertexShaderStage(_),ht=a.getFragmentShaderStage(_);a.update(_,ge,ht),_e=ge.id,be=ht.id}let Pe=i.getRenderTarget(),ye=i.state.buffers.depth.getReversed(),Ve=D.isInstancedMesh===!0,At=D.isBatchedMesh===!0,Le=!!_.map,ct=!!_.matcap,ut=!!z,Je=ut&&z.isPMREMTexture===!0,Gt=!!_.aoMap,Pt=!!_.lightMap,gn=!!_.bumpMap&&_.wireframe===!1,bt=!!_.normalMap,ei=!!_.displacementMap,Ut=!!_.emissiveMap,Rn=!!_.metalnessMap,Pn=!!_.roughnessMap,In=_.anisotropy>0,N=_.clearcoat>0,Ln=_.diffuseRoughness>0,yt=_.dispersion>0,xt=_.retroreflectivity>0,me=_.iridescence>0,It=_.sheen>0,Ie=_.transmission>0,Fe=In&&!!_.anisotropyMap,A=N&&!!_.clearcoatMap,S=N&&!!_.clearcoatNormalMap,F=N&&!!_.clearcoatRoughnessMap,ne=Ln&&!!_.diffuseRoughnessMap,K=me&&!!_.iridescenceMap,ae=me&&!!_.iridescenceThicknessMap,de=It&&!!_.sheenColorMap,$=It&&!!_.sheenRoughnessMap,Y=!!_.specularMap,ce=!!_.specularColorMap,R=!!_.specularIntensityMap,Z=Ie&&!!_.transmissionMap,X=Ie&&!!_.thicknessMap,he=!!_.gradientMap,re=!!_.alphaMap,le=_.alphaTest>0,Ae=!!_.alphaHash,Xe=!!_.extensions,se=ai;_.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(se=i.toneMapping);let Ce=Je?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Ge={shaderID:ie,shaderType:_.type,shaderName:_.name,vertexShader:Be,fragmentShader:J,defines:_.defines,customVertexShaderID:_e,customFragmentShaderID:be,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:q,batching:At,batchingColor:At&&D._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&D.instanceColor!==null,instancingMorph:Ve&&D.morphTexture!==null,outputColorSpace:Pe===null?i.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:Qe.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Le,matcap:ct,envMap:ut,envMapMode:ut&&z.mapping,envMapPMREM:Je,envMapMaxLod:Je?Ce.length-1:null,envMapSize:Je?Ce[0].width:null,aoMap:Gt,lightMap:Pt,bumpMap:gn,normalMap:bt,displacementMap:ei,emissiveMap:Ut,normalMapObjectSpace:bt&&_.normalMapType===xp,normalMapTangentSpace:bt&&_.normalMapType===Mo,packedNormalMap:bt&&_.normalMapType===Mo&&sS(_.normalMap.format),metalnessMap:Rn,roughnessMap:Pn,anisotropy:In,anisotropyMap:Fe,clearcoat:N,clearcoatMap:A,clearcoatNormalMap:S,clearcoatRoughnessMap:F,diffuseRoughness:Ln,diffuseRoughnessMap:ne,dispersion:yt,retroreflection:xt,iridescence:me,iridescenceMap:K,iridescenceThicknessMap:ae,sheen:It,sheenColorMap:de,sheenRoughnessMap:$,specularMap:Y,specularColorMap:ce,specularIntensityMap:R,transmission:Ie,transmissionMap:Z,thicknessMap:X,gradientMap:he,opaque:_.transparent===!1&&_.blending===cr&&_.alphaToCoverage===!1,alphaMap:re,alphaTest:le,alphaHash:Ae,combine:_.combine,mapUv:Le&&m(_.map.channel),aoMapUv:Gt&&m(_.aoMap.channel),lightMapUv:Pt&&m(_.lightMap.channel),bumpMapUv:gn&&m(_.bumpMap.channel),normalMapUv:bt&&m(_.normalMap.channel),displacementMapUv:ei&&m(_.displacementMap.channel),emissiveMapUv:Ut&&m(_.emissiveMap.channel),metalnessMapUv:Rn&&m(_.metalnessMap.channel),roughnessMapUv:Pn&&m(_.roughnessMap.channel),anisotropyMapUv:Fe&&m(_.anisotropyMap.channel),clearcoatMapUv:A&&m(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&m(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:F&&m(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ne&&m(_.diffuseRoughnessMap.channel),iridescenceMapUv:K&&m(_.iridescenceMap.channel),iridescenceThicknessMapUv:ae&&m(_.iridescenceThicknessMap.channel),sheenColorMapUv:de&&m(_.sheenColorMap.channel),sheenRoughnessMapUv:$&&m(_.sheenRoughnessMap.channel),specularMapUv:Y&&m(_.specularMap.channel),specularColorMapUv:ce&&m(_.specularColorMap.channel),specularIntensityMapUv:R&&m(_.specularIntensityMap.channel),transmissionMapUv:Z&&m(_.transmissionMap.channel),thicknessMapUv:X&&m(_.thicknessMap.channel),alphaMapUv:re&&m(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(bt||In),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(Le||re),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&bt===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:ye,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:Ee,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:k.filter(ge=>ge.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&O.length>0,shadowMapType:i.shadowMap.type,toneMapping:se,decodeVideoTexture:Le&&_.map.isVideoTexture===!0&&Qe.getTransfer(_.map.colorSpace)===at,decodeVideoTextureEmissive:Ut&&_.emissiveMap.isVideoTexture===!0&&Qe.getTransfer(_.emissiveMap.colorSpace)===at,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===qt,flipSided:_.side===dn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Xe&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Xe&&_.extensions.multiDraw===!0||At)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ge.vertexUv1s=l.has(1),Ge.vertexUv2s=l.has(2),Ge.vertexUv3s=l.has(3),l.clear(),Ge}function y(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)T.push(O),T.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(p(T,_),f(T,_),T.push(i.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function p(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function f(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function x(_){let T=d[_.type],O;if(T){let P=fn[T];O=wo.clone(P.uniforms)}else O=_.uniforms;return O}function w(_,T){let O=h.get(T);return O!==void 0?++O.usedTimes:(O=new nS(i,T,_,s),c.push(O),h.set(T,O)),O}function M(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function v(_){a.remove(_)}function b(){a.dispose()}return{getParameters:g,getProgramCacheKey:y,getUniforms:x,acquireProgram:w,releaseProgram:M,releaseShaderCache:v,programs:c,dispose:b}}function oS(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function aS(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Zp(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Kp(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let m=0;return d.isInstancedMesh&&(m+=2),d.isSkinnedMesh&&(m+=1),m}function a(d,m,g,y,p,f){let x=i[e];return x===void 0?(x={id:d.id,object:d,geometry:m,material:g,materialVariant:o(d),groupOrder:y,renderOrder:d.renderOrder,z:p,group:f},i[e]=x):(x.id=d.id,x.object=d,x.geometry=m,x.material=g,x.materialVariant=o(d),x.groupOrder=y,x.renderOrder=d.renderOrder,x.z=p,x.group=f),e++,x}function l(d,m,g,y,p,f,x){x.reversedDepth===!0&&(p=-p);let w=a(d,m,g,y,p,f);g.transmission>0?n.push(w):g.transparent===!0?s.push(w):t.push(w)}function c(d,m,g,y,p,f){let x=a(d,m,g,y,p,f);g.transmission>0?n.unshift(x):g.transparent===!0?s.unshift(x):t.unshift(x)}function h(d,m){t.length>1&&t.sort(d||aS),n.length>1&&n.sort(m||Zp),s.length>1&&s.sort(m||Zp)}function u(){for(let d=e,m=i.length;d<m;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function lS(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new Kp,i.set(n,[o])):s>=r.length?(o=new Kp,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function cS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new C,color:new Oe};break;case"SpotLight":t={position:new C,direction:new C,color:new Oe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new C,color:new Oe,distance:0,decay:0};break;case"HemisphereLight":t={direction:new C,skyColor:new Oe,groundColor:new Oe};break;case"RectAreaLight":t={color:new Oe,position:new C,halfWidth:new C,halfHeight:new C};break}return i[e.id]=t,t}}}function hS(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new He};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new He};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new He,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var uS=0;function dS(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function fS(i){let e=new cS,t=hS(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new C);let s=new C,r=new ot,o=new ot;function a(c){let h=0,u=0,d=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let m=0,g=0,y=0,p=0,f=0,x=0,w=0,M=0,v=0,b=0,_=0,T=0,O=0,P=0;c.sort(dS);for(let k=0,W=c.length;k<W;k++){let I=c[k],V=I.color,j=I.intensity,z=I.distance,ie=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Zi?ie=I.shadow.map.texture:ie=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=V.r*j,u+=V.g*j,d+=V.b*j;else if(I.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(I.sh.coefficients[q],j);P++}else if(I.isSunLight){let q=e.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=te,n.sunShadowMap[g]=ie;let Ee=Q.getViewportCount();for(let Be=0;Be<Ee;Be++)n.sunShadowMatrix[y+Be]=Q.getMatrix(Be),n.sunShadowCascade[y+Be]=Q._cascadeData[Be];y+=Ee,g++}n.sun[m]=q,m++}else if(I.isDirectionalLight){let q=e.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,n.directionalShadow[p]=te,n.directionalShadowMap[p]=ie,n.directionalShadowMatrix[p]=I.shadow.matrix,v++}n.directional[p]=q,p++}else if(I.isSpotLight){let q=e.get(I);q.position.setFromMatrixPosition(I.matrixWorld),q.color.copy(V).multiplyScalar(j),q.distance=z,q.coneCos=Math.cos(I.angle),q.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),q.decay=I.decay,n.spot[x]=q;let Q=I.shadow;if(I.map&&(n.spotLightMap[T]=I.map,T++,Q.updateMatrices(I),I.castShadow&&O++),n.spotLightMatrix[x]=Q.matrix,I.castShadow){let te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,n.spotShadow[x]=te,n.spotShadowMap[x]=ie,_++}x++}else if(I.isRectAreaLight){let q=e.get(I);q.color.copy(V).multiplyScalar(j),q.halfWidth.set(I.width*.5,0,0),q.halfHeight.set(0,I.height*.5,0),n.rectArea[w]=q,w++}else if(I.isPointLight){let q=e.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),q.distance=I.distance,q.decay=I.decay,I.castShadow){let Q=I.shadow,te=t.get(I);te.shadowIntensity=Q.intensity,te.shadowBias=Q.bias,te.shadowNormalBias=Q.normalBias,te.shadowRadius=Q.radius,te.shadowMapSize=Q.mapSize,te.shadowCameraNear=Q.camera.near,te.shadowCameraFar=Q.camera.far,n.pointShadow[f]=te,n.pointShadowMap[f]=ie,n.pointShadowMatrix[f]=I.shadow.matrix,b++}n.point[f]=q,f++}else if(I.isHemisphereLight){let q=e.get(I);q.skyColor.copy(I.color).multiplyScalar(j),q.groundColor.copy(I.groundColor).multiplyScalar(j),n.hemi[M]=q,M++}}w>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=pe.LTC_FLOAT_1,n.rectAreaLTC2=pe.LTC_FLOAT_2):(n.rectAreaLTC1=pe.LTC_HALF_1,n.rectAreaLTC2=pe.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let D=n.hash;(D.sunLength!==m||D.directionalLength!==p||D.pointLength!==f||D.spotLength!==x||D.rectAreaLength!==w||D.hemiLength!==M||D.numSunShadows!==g||D.numDirectionalShadows!==v||D.numPointShadows!==b||D.numSpotShadows!==_||D.numSpotMaps!==T||D.numLightProbes!==P)&&(n.sun.length=m,n.directional.length=p,n.spot.length=x,n.rectArea.length=w,n.point.length=f,n.hemi.length=M,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=y,n.sunShadowCascade.length=y,n.directionalShadow.length=v,n.directionalShadowMap.length=v,n.directionalShadowMatrix.length=v,n.pointShadow.length=b,n.pointShadowMap.length=b,n.pointShadowMatrix.length=b,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+T-O,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=O,n.numLightProbes=P,D.sunLength=m,D.directionalLength=p,D.pointLength=f,D.spotLength=x,D.rectAreaLength=w,D.hemiLength=M,D.numSunShadows=g,D.numDirectionalShadows=v,D.numPointShadows=b,D.numSpotShadows=_,D.numSpotMaps=T,D.numLightProbes=P,n.version=uS++)}function l(c,h){let u=0,d=0,m=0,g=0,y=0,p=0,f=h.matrixWorldInverse;for(let x=0,w=c.length;x<w;x++){let M=c[x];if(M.isSunLight){let v=n.sun[u];v.direction.setFromMatrixPosition(M.matrixWorld),v.direction.transformDirection(f),u++}else if(M.isDirectionalLight){let v=n.directional[d];v.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(f),d++}else if(M.isSpotLight){let v=n.spot[g];v.position.setFromMatrixPosition(M.matrixWorld),v.position.applyMatrix4(f),v.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),v.direction.sub(s),v.direction.transformDirection(f),g++}else if(M.isRectAreaLight){let v=n.rectArea[y];v.position.setFromMatrixPosition(M.matrixWorld),v.position.applyMatrix4(f),o.identity(),r.copy(M.matrixWorld),r.premultiply(f),o.extractRotation(r),v.halfWidth.set(M.width*.5,0,0),v.halfHeight.set(0,M.height*.5,0),v.halfWidth.applyMatrix4(o),v.halfHeight.applyMatrix4(o),y++}else if(M.isPointLight){let v=n.point[m];v.position.setFromMatrixPosition(M.matrixWorld),v.position.applyMatrix4(f),m++}else if(M.isHemisphereLight){let v=n.hemi[p];v.direction.setFromMatrixPosition(M.matrixWorld),v.direction.transformDirection(f),p++}}}return{setup:a,setupView:l,state:n}}function jp(i){let e=new fS(i),t=[],n=[],s=[];function r(u){h.camera=u,t.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):t.push(u)}function a(u){n.push(u)}function l(){e.setup(t),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){e.setupView(t,u)}let h={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function pS(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new jp(i),e.set(s,[a])):r>=o.length?(a=new jp(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var mS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,gS=`uniform sampler2D shadow_pass;
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
}`,_S=[new C(1,0,0),new C(-1,0,0),new C(0,1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1)],yS=[new C(0,-1,0),new C(0,-1,0),new C(0,0,1),new C(0,0,-1),new C(0,-1,0),new C(0,-1,0)],Qp=new ot,Eo=new C,Cu=new C;function xS(i,e,t){let n=new Gi,s=new He,r=new He,o=new it,a=new tl,l=new nl,c={},h=t.maxTextureSize,u={[Ji]:dn,[dn]:Ji,[qt]:qt},d=new Ot({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new He},radius:{value:4}},vertexShader:mS,fragmentShader:gS}),m=d.clone();m.defines.HORIZONTAL_PASS=1;let g=new Et;g.setAttribute("position",new mt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Lt(g,d),p=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=po;let f=this.type;this.render=function(b,_,T){if(p.enabled===!1||p.autoUpdate===!1&&p.needsUpdate===!1||b.length===0)return;this.type===Zf&&(Re("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=po);let O=i.getRenderTarget(),P=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),k=i.state;k.setBlending(oi),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let W=f!==this.type;W&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=b.length;I<V;I++){let j=b[I],z=j.shadow;if(z===void 0){Re("WebGLShadowMap:",j,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let ie=z.getFrameExtents();s.multiply(ie),r.copy(z.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ie.x),s.x=r.x*ie.x,z.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ie.y),s.y=r.y*ie.y,z.mapSize.y=r.y));let q=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=q,z.map===null||W===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===lr){if(j.isPointLight){Re("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new sn(s.x,s.y,{format:Zi,type:Yn,minFilter:hn,magFilter:hn,generateMipmaps:!1}),z.map.texture.name=j.name+".shadowMap",z.map.depthTexture=new Ti(s.x,s.y,$n),z.map.depthTexture.name=j.name+".shadowMapDepth",z.map.depthTexture.format=Ei,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Ht,z.map.depthTexture.magFilter=Ht}else j.isPointLight?(z.map=new Ao(s.x),z.map.depthTexture=new eo(s.x,qn)):(z.map=new sn(s.x,s.y),z.map.depthTexture=new Ti(s.x,s.y,qn)),z.map.depthTexture.name=j.name+".shadowMap",z.map.depthTexture.format=Ei,this.type===po?(z.map.depthTexture.compareFunction=q?pu:fu,z.map.depthTexture.minFilter=hn,z.map.depthTexture.magFilter=hn):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Ht,z.map.depthTexture.magFilter=Ht);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();j.isPointLight!==!0&&z.updateMatrices(j,T);let te=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:T.layers;for(let Ee=0;Ee<Q;Ee++){let Be=z.getCamera(Ee);if(j.isPointLight){let J=z.camera,_e=z.matrix,be=j.distance||J.far;be!==J.far&&(J.far=be,J.updateProjectionMatrix()),Eo.setFromMatrixPosition(j.matrixWorld),J.position.copy(Eo),Cu.copy(J.position),Cu.add(_S[Ee]),J.up.copy(yS[Ee]),J.lookAt(Cu),J.updateMatrixWorld(),_e.makeTranslation(-Eo.x,-Eo.y,-Eo.z),Qp.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),z._frustum.setFromProjectionMatrix(Qp,J.coordinateSystem,J.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,Ee),i.clear();else{Ee===0&&(i.setRenderTarget(z.map),i.clear());let J=z.getViewport(Ee);o.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),k.viewport(o)}n=z.getFrustum(Ee),M(_,T,Be,j,te,this.type)}z.isPointLightShadow!==!0&&this.type===lr&&x(z,T),z.needsUpdate=!1}f=this.type,p.needsUpdate=!1,i.setRenderTarget(O,P,D)};function x(b,_){let T=e.update(y);d.defines.VSM_SAMPLES!==b.blurSamples&&(d.defines.VSM_SAMPLES=b.blurSamples,m.defines.VSM_SAMPLES=b.blurSamples,d.needsUpdate=!0,m.needsUpdate=!0),b.mapPass===null?b.mapPass=new sn(s.x,s.y,{format:Zi,type:Yn}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),d.uniforms.shadow_pass.value=b.map.depthTexture,d.uniforms.resolution.value.set(b.map.width,b.map.height),d.uniforms.radius.value=b.radius,i.setRenderTarget(b.mapPass),i.clear(),i.renderBufferDirect(_,null,T,d,y,null),m.uniforms.shadow_pass.value=b.mapPass.texture,m.uniforms.resolution.value.set(b.map.width,b.map.height),m.uniforms.radius.value=b.radius,i.setRenderTarget(b.map),i.clear(),i.renderBufferDirect(_,null,T,m,y,null)}function w(b,_,T,O){let P=null,D=T.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(D!==void 0)P=D;else if(P=T.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=P.uuid,W=_.uuid,I=c[k];I===void 0&&(I={},c[k]=I);let V=I[W];V===void 0&&(V=P.clone(),I[W]=V,_.addEventListener("dispose",v)),P=V}if(P.visible=_.visible,P.wireframe=_.wireframe,O===lr?P.side=_.shadowSide!==null?_.shadowSide:_.side:P.side=_.shadowSide!==null?_.shadowSide:u[_.side],P.alphaMap=_.alphaMap,P.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,P.map=_.map,P.clipShadows=_.clipShadows,P.clippingPlanes=_.clippingPlanes,P.clipIntersection=_.clipIntersection,P.displacementMap=_.displacementMap,P.displacementScale=_.displacementScale,P.displacementBias=_.displacementBias,P.wireframeLinewidth=_.wireframeLinewidth,P.linewidth=_.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let k=i.properties.get(P);k.light=T}return P}function M(b,_,T,O,P,D){if(b.visible===!1)return;if(b.layers.test(P)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&D===lr)&&(!b.frustumCulled||b.intersectsFrustum(n))){b.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,b.matrixWorld);let I=e.update(b),V=b.material;if(Array.isArray(V)){let j=I.groups;for(let z=0,ie=j.length;z<ie;z++){let q=j[z],Q=V[q.materialIndex];if(Q&&Q.visible){let te=w(b,Q,O,D);b.onBeforeShadow(i,b,_,T,I,te,q),i.renderBufferDirect(T,null,I,te,b,q),b.onAfterShadow(i,b,_,T,I,te,q)}}}else if(V.visible){let j=w(b,V,O,D);b.onBeforeShadow(i,b,_,T,I,j,null),i.renderBufferDirect(T,null,I,j,b,null),b.onAfterShadow(i,b,_,T,I,j,null)}}let W=b.children;for(let I=0,V=W.length;I<V;I++)M(W[I],_,T,O,P,D)}function v(b){b.target.removeEventListener("dispose",v);for(let T in c){let O=c[T],P=b.target.uuid;P in O&&(O[P].dispose(),delete O[P])}}}function vS(i,e){function t(){let R=!1,Z=new it,X=null,he=new it(0,0,0,0);return{setMask:function(re){X!==re&&!R&&(i.colorMask(re,re,re,re),X=re)},setLocked:function(re){R=re},setClear:function(re,le,Ae,Xe,se){se===!0&&(re*=Xe,le*=Xe,Ae*=Xe),Z.set(re,le,Ae,Xe),he.equals(Z)===!1&&(i.clearColor(re,le,Ae,Xe),he.copy(Z))},reset:function(){R=!1,X=null,he.set(-1,0,0,0)}}}function n(){let R=!1,Z=!1,X=null,he=null,re=null;return{setReversed:function(le){if(Z!==le){let Ae=e.get("EXT_clip_control");le?Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.ZERO_TO_ONE_EXT):Ae.clipControlEXT(Ae.LOWER_LEFT_EXT,Ae.NEGATIVE_ONE_TO_ONE_EXT),Z=le;let Xe=re;re=null,this.setClear(Xe)}},getReversed:function(){return Z},setTest:function(le){le?ye(i.DEPTH_TEST):Ve(i.DEPTH_TEST)},setMask:function(le){X!==le&&!R&&(i.depthMask(le),X=le)},setFunc:function(le){if(Z&&(le=Rp[le]),he!==le){switch(le){case Da:i.depthFunc(i.NEVER);break;case Na:i.depthFunc(i.ALWAYS);break;case Ua:i.depthFunc(i.LESS);break;case Zs:i.depthFunc(i.LEQUAL);break;case Fa:i.depthFunc(i.EQUAL);break;case Ba:i.depthFunc(i.GEQUAL);break;case ka:i.depthFunc(i.GREATER);break;case za:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}he=le}},setLocked:function(le){R=le},setClear:function(le){re!==le&&(re=le,Z&&(le=1-le),i.clearDepth(le))},reset:function(){R=!1,X=null,he=null,re=null,Z=!1}}}function s(){let R=!1,Z=null,X=null,he=null,re=null,le=null,Ae=null,Xe=null,se=null;return{setTest:function(Ce){R||(Ce?ye(i.STENCIL_TEST):Ve(i.STENCIL_TEST))},setMask:function(Ce){Z!==Ce&&!R&&(i.stencilMask(Ce),Z=Ce)},setFunc:function(Ce,Ge,ge){(X!==Ce||he!==Ge||re!==ge)&&(i.stencilFunc(Ce,Ge,ge),X=Ce,he=Ge,re=ge)},setOp:function(Ce,Ge,ge){(le!==Ce||Ae!==Ge||Xe!==ge)&&(i.stencilOp(Ce,Ge,ge),le=Ce,Ae=Ge,Xe=ge)},setLocked:function(Ce){R=Ce},setClear:function(Ce){se!==Ce&&(i.clearStencil(Ce),se=Ce)},reset:function(){R=!1,Z=null,X=null,he=null,re=null,le=null,Ae=null,Xe=null,se=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,h={},u={},d={},m=new WeakMap,g=[],y=null,p=!1,f=null,x=null,w=null,M=null,v=null,b=null,_=null,T=new Oe(0,0,0),O=0,P=!1,D=null,k=null,W=null,I=null,V=null,j=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ie=0,q=i.getParameter(i.VERSION);q.indexOf("WebGL")!==-1?(ie=parseFloat(/^WebGL (\d)/.exec(q)[1]),z=ie>=1):q.indexOf("OpenGL ES")!==-1&&(ie=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),z=ie>=2);let Q=null,te={},Ee=i.getParameter(i.SCISSOR_BOX),Be=i.getParameter(i.VIEWPORT),J=new it().fromArray(Ee),_e=new it().fromArray(Be);function be(R,Z,X,he){let re=new Uint8Array(4),le=i.createTexture();i.bindTexture(R,le),i.texParameteri(R,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(R,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ae=0;Ae<X;Ae++)R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY?i.texImage3D(Z,0,i.RGBA,1,1,he,0,i.RGBA,i.UNSIGNED_BYTE,re):i.texImage2D(Z+Ae,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,re);return le}let Pe={};Pe[i.TEXTURE_2D]=be(i.TEXTURE_2D,i.TEXTURE_2D,1),Pe[i.TEXTURE_CUBE_MAP]=be(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[i.TEXTURE_2D_ARRAY]=be(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pe[i.TEXTURE_3D]=be(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(i.DEPTH_TEST),o.setFunc(Zs),gn(!1),bt($h),ye(i.CULL_FACE),Gt(oi);function ye(R){h[R]!==!0&&(i.enable(R),h[R]=!0)}function Ve(R){h[R]!==!1&&(i.disable(R),h[R]=!1)}function At(R,Z){return d[R]!==Z?(i.bindFramebuffer(R,Z),d[R]=Z,R===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=Z),R===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=Z),!0):!1}function Le(R,Z){let X=g,he=!1;if(R){X=m.get(Z),X===void 0&&(X=[],m.set(Z,X));let re=R.textures;if(X.length!==re.length||X[0]!==i.COLOR_ATTACHMENT0){for(let le=0,Ae=re.length;le<Ae;le++)X[le]=i.COLOR_ATTACHMENT0+le;X.length=re.length,he=!0}}else X[0]!==i.BACK&&(X[0]=i.BACK,he=!0);he&&i.drawBuffers(X)}function ct(R){return y!==R?(i.useProgram(R),y=R,!0):!1}let ut={[gs]:i.FUNC_ADD,[jf]:i.FUNC_SUBTRACT,[Qf]:i.FUNC_REVERSE_SUBTRACT};ut[ep]=i.MIN,ut[tp]=i.MAX;let Je={[np]:i.ZERO,[ip]:i.ONE,[sp]:i.SRC_COLOR,[Kh]:i.SRC_ALPHA,[hp]:i.SRC_ALPHA_SATURATE,[lp]:i.DST_COLOR,[op]:i.DST_ALPHA,[rp]:i.ONE_MINUS_SRC_COLOR,[jh]:i.ONE_MINUS_SRC_ALPHA,[cp]:i.ONE_MINUS_DST_COLOR,[ap]:i.ONE_MINUS_DST_ALPHA,[up]:i.CONSTANT_COLOR,[dp]:i.ONE_MINUS_CONSTANT_COLOR,[fp]:i.CONSTANT_ALPHA,[pp]:i.ONE_MINUS_CONSTANT_ALPHA};function Gt(R,Z,X,he,re,le,Ae,Xe,se,Ce){if(R===oi){p===!0&&(Ve(i.BLEND),p=!1);return}if(p===!1&&(ye(i.BLEND),p=!0),R!==Kf){if(R!==f||Ce!==P){if((x!==gs||v!==gs)&&(i.blendEquation(i.FUNC_ADD),x=gs,v=gs),Ce)switch(R){case cr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Yh:i.blendFunc(i.ONE,i.ONE);break;case Jh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Zh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:De("WebGLState: Invalid blending: ",R);break}else switch(R){case cr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Yh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Jh:De("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Zh:De("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:De("WebGLState: Invalid blending: ",R);break}w=null,M=null,b=null,_=null,T.set(0,0,0),O=0,f=R,P=Ce}return}re=re||Z,le=le||X,Ae=Ae||he,(Z!==x||re!==v)&&(i.blendEquationSeparate(ut[Z],ut[re]),x=Z,v=re),(X!==w||he!==M||le!==b||Ae!==_)&&(i.blendFuncSeparate(Je[X],Je[he],Je[le],Je[Ae]),w=X,M=he,b=le,_=Ae),(Xe.equals(T)===!1||se!==O)&&(i.blendColor(Xe.r,Xe.g,Xe.b,se),T.copy(Xe),O=se),f=R,P=!1}function Pt(R,Z){R.side===qt?Ve(i.CULL_FACE):ye(i.CULL_FACE);let X=R.side===dn;Z&&(X=!X),gn(X),R.blending===cr&&R.transparent===!1?Gt(oi):Gt(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),o.setFunc(R.depthFunc),o.setTest(R.depthTest),o.setMask(R.depthWrite),r.setMask(R.colorWrite);let he=R.stencilWrite;a.setTest(he),he&&(a.setMask(R.stencilWriteMask),a.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),a.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),Ut(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?ye(i.SAMPLE_ALPHA_TO_COVERAGE):Ve(i.SAMPLE_ALPHA_TO_COVERAGE)}function gn(R){D!==R&&(R?i.frontFace(i.CW):i.frontFace(i.CCW),D=R)}function bt(R){R!==Yf?(ye(i.CULL_FACE),R!==k&&(R===$h?i.cullFace(i.BACK):R===Jf?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ve(i.CULL_FACE),k=R}function ei(R){R!==W&&(z&&i.lineWidth(R),W=R)}function Ut(R,Z,X){R?(ye(i.POLYGON_OFFSET_FILL),(I!==Z||V!==X)&&(I=Z,V=X,o.getReversed()&&(Z=-Z,X=-X),i.polygonOffset(Z,X))):Ve(i.POLYGON_OFFSET_FILL)}function Rn(R){R?ye(i.SCISSOR_TEST):Ve(i.SCISSOR_TEST)}function Pn(R){R===void 0&&(R=i.TEXTURE0+j-1),Q!==R&&(i.activeTexture(R),Q=R)}function In(R,Z,X){X===void 0&&(Q===null?X=i.TEXTURE0+j-1:X=Q);let he=te[X];he===void 0&&(he={type:void 0,texture:void 0},te[X]=he),(he.type!==R||he.texture!==Z)&&(Q!==X&&(i.activeTexture(X),Q=X),i.bindTexture(R,Z||Pe[R]),he.type=R,he.texture=Z)}function N(){let R=te[Q];R!==void 0&&R.type!==void 0&&(i.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function Ln(){try{i.compressedTexImage2D(...arguments)}catch(R){De("WebGLState:",R)}}function yt(){try{i.compressedTexImage3D(...arguments)}catch(R){De("WebGLState:",R)}}function xt(){try{i.texSubImage2D(...arguments)}catch(R){De("WebGLState:",R)}}function me(){try{i.texSubImage3D(...arguments)}catch(R){De("WebGLState:",R)}}function It(){try{i.compressedTexSubImage2D(...arguments)}catch(R){De("WebGLState:",R)}}function Ie(){try{i.compressedTexSubImage3D(...arguments)}catch(R){De("WebGLState:",R)}}function Fe(){try{i.texStorage2D(...arguments)}catch(R){De("WebGLState:",R)}}function A(){try{i.texStorage3D(...arguments)}catch(R){De("WebGLState:",R)}}function S(){try{i.texImage2D(...arguments)}catch(R){De("WebGLState:",R)}}function F(){try{i.texImage3D(...arguments)}catch(R){De("WebGLState:",R)}}function ne(R){return u[R]!==void 0?u[R]:i.getParameter(R)}function K(R,Z){u[R]!==Z&&(i.pixelStorei(R,Z),u[R]=Z)}function ae(R){J.equals(R)===!1&&(i.scissor(R.x,R.y,R.z,R.w),J.copy(R))}function de(R){_e.equals(R)===!1&&(i.viewport(R.x,R.y,R.z,R.w),_e.copy(R))}function $(R,Z){let X=c.get(Z);X===void 0&&(X=new WeakMap,c.set(Z,X));let he=X.get(R);he===void 0&&(he=i.getUniformBlockIndex(Z,R.name),i.uniformBlockBinding(Z,he,he),X.set(R,he))}function Y(R,Z,X){let re=c.get(Z).get(R);l[re]!==X&&(i.bindBufferBase(i.UNIFORM_BUFFER,re,X),l[re]=X)}function ce(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,te={},d={},l={},m=new WeakMap,g=[],y=null,p=!1,f=null,x=null,w=null,M=null,v=null,b=null,_=null,T=new Oe(0,0,0),O=0,P=!1,D=null,k=null,W=null,I=null,V=null,J.set(0,0,i.canvas.width,i.canvas.height),_e.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ye,disable:Ve,bindFramebuffer:At,drawBuffers:Le,useProgram:ct,setBlending:Gt,setMaterial:Pt,setFlipSided:gn,setCullFace:bt,setLineWidth:ei,setPolygonOffset:Ut,setScissorTest:Rn,activeTexture:Pn,bindTexture:In,unbindTexture:N,compressedTexImage2D:Ln,compressedTexImage3D:yt,texImage2D:S,texImage3D:F,pixelStorei:K,getParameter:ne,updateUBOMapping:$,uniformBlockBinding:Y,texStorage2D:Fe,texStorage3D:A,texSubImage2D:xt,texSubImage3D:me,compressedTexSubImage2D:It,compressedTexSubImage3D:Ie,scissor:ae,viewport:de,reset:ce}}function bS(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new He,h=new WeakMap,u=new Set,d,m=new WeakMap,g=new Set,y=new FinalizationRegistry(A=>g.delete(A)),p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function f(A,S){return p?new OffscreenCanvas(A,S):qr("canvas")}function x(A,S,F){let ne=1,K=Fe(A);if((K.width>F||K.height>F)&&(ne=F/Math.max(K.width,K.height)),ne<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let ae=Math.floor(ne*K.width),de=Math.floor(ne*K.height);d===void 0&&(d=f(ae,de));let $=S?f(ae,de):d;return $.width=ae,$.height=de,$.getContext("2d").drawImage(A,0,0,ae,de),Re("WebGLRenderer: Texture has been resized from ("+K.width+"x"+K.height+") to ("+ae+"x"+de+")."),$}else return"data"in A&&Re("WebGLRenderer: Image in DataTexture is too big ("+K.width+"x"+K.height+")."),A;return A}function w(A){return A.generateMipmaps}function M(A){i.generateMipmap(A)}function v(A){return A.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?i.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function b(A,S,F,ne,K,ae=!1){if(A!==null){if(i[A]!==void 0)return i[A];Re("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let de;ne&&(de=e.get("EXT_texture_norm16"),de||Re("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let $=S;if(S===i.RED&&(F===i.FLOAT&&($=i.R32F),F===i.HALF_FLOAT&&($=i.R16F),F===i.UNSIGNED_BYTE&&($=i.R8),F===i.UNSIGNED_SHORT&&de&&($=de.R16_EXT),F===i.SHORT&&de&&($=de.R16_SNORM_EXT)),S===i.RED_INTEGER&&(F===i.UNSIGNED_BYTE&&($=i.R8UI),F===i.UNSIGNED_SHORT&&($=i.R16UI),F===i.UNSIGNED_INT&&($=i.R32UI),F===i.BYTE&&($=i.R8I),F===i.SHORT&&($=i.R16I),F===i.INT&&($=i.R32I)),S===i.RG&&(F===i.FLOAT&&($=i.RG32F),F===i.HALF_FLOAT&&($=i.RG16F),F===i.UNSIGNED_BYTE&&($=i.RG8),F===i.UNSIGNED_SHORT&&de&&($=de.RG16_EXT),F===i.SHORT&&de&&($=de.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(F===i.UNSIGNED_BYTE&&($=i.RG8UI),F===i.UNSIGNED_SHORT&&($=i.RG16UI),F===i.UNSIGNED_INT&&($=i.RG32UI),F===i.BYTE&&($=i.RG8I),F===i.SHORT&&($=i.RG16I),F===i.INT&&($=i.RG32I)),S===i.RGB_INTEGER&&(F===i.UNSIGNED_BYTE&&($=i.RGB8UI),F===i.UNSIGNED_SHORT&&($=i.RGB16UI),F===i.UNSIGNED_INT&&($=i.RGB32UI),F===i.BYTE&&($=i.RGB8I),F===i.SHORT&&($=i.RGB16I),F===i.INT&&($=i.RGB32I)),S===i.RGBA_INTEGER&&(F===i.UNSIGNED_BYTE&&($=i.RGBA8UI),F===i.UNSIGNED_SHORT&&($=i.RGBA16UI),F===i.UNSIGNED_INT&&($=i.RGBA32UI),F===i.BYTE&&($=i.RGBA8I),F===i.SHORT&&($=i.RGBA16I),F===i.INT&&($=i.RGBA32I)),S===i.RGB&&(F===i.UNSIGNED_SHORT&&de&&($=de.RGB16_EXT),F===i.SHORT&&de&&($=de.RGB16_SNORM_EXT),F===i.UNSIGNED_INT_5_9_9_9_REV&&($=i.RGB9_E5),F===i.UNSIGNED_INT_10F_11F_11F_REV&&($=i.R11F_G11F_B10F)),S===i.RGBA){let Y=ae?Xr:Qe.getTransfer(K);F===i.FLOAT&&($=i.RGBA32F),F===i.HALF_FLOAT&&($=i.RGBA16F),F===i.UNSIGNED_BYTE&&($=Y===at?i.SRGB8_ALPHA8:i.RGBA8),F===i.UNSIGNED_SHORT&&de&&($=de.RGBA16_EXT),F===i.SHORT&&de&&($=de.RGBA16_SNORM_EXT),F===i.UNSIGNED_SHORT_4_4_4_4&&($=i.RGBA4),F===i.UNSIGNED_SHORT_5_5_5_1&&($=i.RGB5_A1)}return($===i.R16F||$===i.R32F||$===i.RG16F||$===i.RG32F||$===i.RGBA16F||$===i.RGBA32F)&&e.get("EXT_color_buffer_float"),$}function _(A,S){let F;return A?S===null||S===qn||S===ys?F=i.DEPTH24_STENCIL8:S===$n?F=i.DEPTH32F_STENCIL8:S===ur&&(F=i.DEPTH24_STENCIL8,Re("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===qn||S===ys?F=i.DEPTH_COMPONENT24:S===$n?F=i.DEPTH_COMPONENT32F:S===ur&&(F=i.DEPTH_COMPONENT16),F}function T(A,S){return w(A)===!0||A.isFramebufferTexture&&A.minFilter!==Ht&&A.minFilter!==hn?Math.log2(Math.max(S.width,S.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?S.mipmaps.length:1}function O(A){let S=new WeakRef(A);n.get(A).__ref=S,g.add(S),y.register(A,S,S)}function P(A){let S=n.get(A).__ref;S!==void 0&&(g.delete(S),y.unregister(S))}function D(A){W(A.target)}function k(A){I(A.target)}function W(A){A.removeEventListener("dispose",D),P(A),j(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function I(A){A.removeEventListener("dispose",k),P(A),ie(A)}function V(){for(let A of g){let S=A.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):W(S))}g.clear(),u.clear()}function j(A){let S=n.get(A);if(S.__webglInit===void 0)return;let F=A.source,ne=m.get(F);if(ne){let K=ne[S.__cacheKey];K.usedTimes--,K.usedTimes===0&&z(A),Object.keys(ne).length===0&&m.delete(F)}n.remove(A)}function z(A){let S=n.get(A);i.deleteTexture(S.__webglTexture);let F=A.source,ne=m.get(F);delete ne[S.__cacheKey],o.memory.textures--}function ie(A){let S=n.get(A);S.__depthDisposeCallback&&S.__depthDisposeCallback();let F=A.depthTexture;if(F&&F.renderTarget===A&&W(F),A.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(S.__webglFramebuffer[K]))for(let ae=0;ae<S.__webglFramebuffer[K].length;ae++)i.deleteFramebuffer(S.__webglFramebuffer[K][ae]);else i.deleteFramebuffer(S.__webglFramebuffer[K]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[K])}else{if(Array.isArray(S.__webglFramebuffer))for(let K=0;K<S.__webglFramebuffer.length;K++)i.deleteFramebuffer(S.__webglFramebuffer[K]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let K=0;K<S.__webglColorRenderbuffer.length;K++)S.__webglColorRenderbuffer[K]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[K]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ne=A.textures;for(let K=0,ae=ne.length;K<ae;K++){let de=n.get(ne[K]);de.__webglTexture&&(i.deleteTexture(de.__webglTexture),o.memory.textures--),n.remove(ne[K])}n.remove(A)}let q=0;function Q(){q=0}function te(){return q}function Ee(A){q=A}function Be(){let A=q;return A>=s.maxTextures&&Re("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,A}function J(A){let S=[];return S.push(A.wrapS),S.push(A.wrapT),S.push(A.wrapR||0),S.push(A.magFilter),S.push(A.minFilter),S.push(A.anisotropy),S.push(A.internalFormat),S.push(A.format),S.push(A.type),S.push(A.generateMipmaps),S.push(A.mipmapsAutoUpdate),S.push(A.premultiplyAlpha),S.push(A.flipY),S.push(A.unpackAlignment),S.push(A.colorSpace),S.join()}function _e(A,S){let F=n.get(A);if(A.isVideoTexture&&It(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&F.__version!==A.version){let ne=A.image;if(ne===null)Re("WebGLRenderer: Texture marked for update but no image data found.");else if(ne.complete===!1)Re("WebGLRenderer: Texture marked for update but image is incomplete");else{Pt(F,A,S);return}}else A.isExternalTexture&&(F.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,F.__webglTexture,i.TEXTURE0+S)}function be(A,S){let F=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&F.__version!==A.version){Pt(F,A,S);return}else A.isExternalTexture&&(F.__webglTexture=A.sourceTexture?A.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,F.__webglTexture,i.TEXTURE0+S)}function Pe(A,S){let F=n.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&F.__version!==A.version){Pt(F,A,S);return}t.bindTexture(i.TEXTURE_3D,F.__webglTexture,i.TEXTURE0+S)}function ye(A,S){let F=n.get(A);if(A.version>0&&F.__version!==A.version){gn(F,A,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,F.__webglTexture,i.TEXTURE0+S)}let Ve={[Va]:i.REPEAT,[ni]:i.CLAMP_TO_EDGE,[Ha]:i.MIRRORED_REPEAT},At={[Ht]:i.NEAREST,[_p]:i.NEAREST_MIPMAP_NEAREST,[go]:i.NEAREST_MIPMAP_LINEAR,[hn]:i.LINEAR,[yl]:i.LINEAR_MIPMAP_NEAREST,[Ai]:i.LINEAR_MIPMAP_LINEAR},Le={[bp]:i.NEVER,[mu]:i.ALWAYS,[Sp]:i.LESS,[fu]:i.LEQUAL,[Mp]:i.EQUAL,[pu]:i.GEQUAL,[wp]:i.GREATER,[Ep]:i.NOTEQUAL};function ct(A,S){if(S.type===$n&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===hn||S.magFilter===yl||S.magFilter===go||S.magFilter===Ai||S.minFilter===hn||S.minFilter===yl||S.minFilter===go||S.minFilter===Ai)&&Re("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(A,i.TEXTURE_WRAP_S,Ve[S.wrapS]),i.texParameteri(A,i.TEXTURE_WRAP_T,Ve[S.wrapT]),(A===i.TEXTURE_3D||A===i.TEXTURE_2D_ARRAY)&&i.texParameteri(A,i.TEXTURE_WRAP_R,Ve[S.wrapR]),i.texParameteri(A,i.TEXTURE_MAG_FILTER,At[S.magFilter]),i.texParameteri(A,i.TEXTURE_MIN_FILTER,At[S.minFilter]),S.compareFunction&&(i.texParameteri(A,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(A,i.TEXTURE_COMPARE_FUNC,Le[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Ht||S.minFilter!==go&&S.minFilter!==Ai||S.type===$n&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let F=e.get("EXT_texture_filter_anisotropic");i.texParameterf(A,F.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ut(A,S){let F=!1;A.__webglInit===void 0&&(A.__webglInit=!0,S.addEventListener("dispose",D),O(S));let ne=S.source,K=m.get(ne);K===void 0&&(K={},m.set(ne,K));let ae=J(S);if(ae!==A.__cacheKey){K[ae]===void 0&&(K[ae]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,F=!0),K[ae].usedTimes++;let de=K[A.__cacheKey];de!==void 0&&(K[A.__cacheKey].usedTimes--,de.usedTimes===0&&z(S)),A.__cacheKey=ae,A.__webglTexture=K[ae].texture}return F}function Je(A,S,F){return Math.floor(Math.floor(A/F)/S)}function Gt(A,S,F,ne){let ae=A.updateRanges;if(ae.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,F,ne,S.data);else{ae.sort((R,Z)=>R.start-Z.start);let de=0;for(let R=1;R<ae.length;R++){let Z=ae[de],X=ae[R],he=Z.start+Z.count,re=Je(X.start,S.width,4),le=Je(Z.start,S.width,4);X.start<=he+1&&re===le&&Je(X.start+X.count-1,S.width,4)===re?Z.count=Math.max(Z.count,X.start+X.count-Z.start):(++de,ae[de]=X)}ae.length=de+1;let $=t.getParameter(i.UNPACK_ROW_LENGTH),Y=t.getParameter(i.UNPACK_SKIP_PIXELS),ce=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let R=0,Z=ae.length;R<Z;R++){let X=ae[R],he=Math.floor(X.start/4),re=Math.ceil(X.count/4),le=he%S.width,Ae=Math.floor(he/S.width),Xe=re,se=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,le),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ae),t.texSubImage2D(i.TEXTURE_2D,0,le,Ae,Xe,se,F,ne,S.data)}A.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,$),t.pixelStorei(i.UNPACK_SKIP_PIXELS,Y),t.pixelStorei(i.UNPACK_SKIP_ROWS,ce)}}function Pt(A,S,F){let ne=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ne=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ne=i.TEXTURE_3D);let K=ut(A,S),ae=S.source;t.bindTexture(ne,A.__webglTexture,i.TEXTURE0+F);let de=n.get(ae);if(ae.version!==de.__version||K===!0){if(t.activeTexture(i.TEXTURE0+F),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let se=Qe.getPrimaries(Qe.workingColorSpace),Ce=S.colorSpace===Ri?null:Qe.getPrimaries(S.colorSpace),Ge=S.colorSpace===Ri||se===Ce?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ge)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let Y=x(S.image,!1,s.maxTextureSize);Y=Ie(S,Y);let ce=r.convert(S.format,S.colorSpace),R=r.convert(S.type),Z=b(S.internalFormat,ce,R,S.normalized,S.colorSpace,S.isVideoTexture);ct(ne,S);let X,he=S.mipmaps,re=S.isVideoTexture!==!0,le=de.__version===void 0||K===!0,Ae=ae.dataReady,Xe=T(S,Y);if(S.isDepthTexture)Z=_(S.format===Ci,S.type),le&&(re?t.texStorage2D(i.TEXTURE_2D,1,Z,Y.width,Y.height):t.texImage2D(i.TEXTURE_2D,0,Z,Y.width,Y.height,0,ce,R,null));else if(S.isDataTexture)if(he.length>0){re&&le&&t.texStorage2D(i.TEXTURE_2D,Xe,Z,he[0].width,he[0].height);for(let se=0,Ce=he.length;se<Ce;se++)X=he[se],re?Ae&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,X.width,X.height,ce,R,X.data):t.texImage2D(i.TEXTURE_2D,se,Z,X.width,X.height,0,ce,R,X.data);S.generateMipmaps=!1}else re?(le&&t.texStorage2D(i.TEXTURE_2D,Xe,Z,Y.width,Y.height),Ae&&Gt(S,Y,ce,R)):t.texImage2D(i.TEXTURE_2D,0,Z,Y.width,Y.height,0,ce,R,Y.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){re&&le&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Xe,Z,he[0].width,he[0].height,Y.depth);for(let se=0,Ce=he.length;se<Ce;se++)if(X=he[se],S.format!==Jn)if(ce!==null)if(re){if(Ae)if(S.layerUpdates.size>0){let Ge=Tu(X.width,X.height,S.format,S.type);for(let ge of S.layerUpdates){let ht=X.data.subarray(ge*Ge/X.data.BYTES_PER_ELEMENT,(ge+1)*Ge/X.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,ge,X.width,X.height,1,ce,ht)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,X.width,X.height,Y.depth,ce,X.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,se,Z,X.width,X.height,Y.depth,0,X.data,0,0);else Re("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else re?Ae&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,se,0,0,0,X.width,X.height,Y.depth,ce,R,X.data):t.texImage3D(i.TEXTURE_2D_ARRAY,se,Z,X.width,X.height,Y.depth,0,ce,R,X.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{re&&le&&t.texStorage2D(i.TEXTURE_2D,Xe,Z,he[0].width,he[0].height);for(let se=0,Ce=he.length;se<Ce;se++)X=he[se],S.format!==Jn?ce!==null?re?Ae&&t.compressedTexSubImage2D(i.TEXTURE_2D,se,0,0,X.width,X.height,ce,X.data):t.compressedTexImage2D(i.TEXTURE_2D,se,Z,X.width,X.height,0,X.data):Re("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):re?Ae&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,X.width,X.height,ce,R,X.data):t.texImage2D(i.TEXTURE_2D,se,Z,X.width,X.height,0,ce,R,X.data)}else if(S.isDataArrayTexture)if(re){if(le&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Xe,Z,Y.width,Y.height,Y.depth),Ae)if(S.layerUpdates.size>0){let se=Tu(Y.width,Y.height,S.format,S.type);for(let Ce of S.layerUpdates){let Ge=Y.data.subarray(Ce*se/Y.data.BYTES_PER_ELEMENT,(Ce+1)*se/Y.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Ce,Y.width,Y.height,1,ce,R,Ge)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,ce,R,Y.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,Z,Y.width,Y.height,Y.depth,0,ce,R,Y.data);else if(S.isData3DTexture)re?(le&&t.texStorage3D(i.TEXTURE_3D,Xe,Z,Y.width,Y.height,Y.depth),Ae&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,ce,R,Y.data)):t.texImage3D(i.TEXTURE_3D,0,Z,Y.width,Y.height,Y.depth,0,ce,R,Y.data);else if(S.isFramebufferTexture){if(le)if(re)t.texStorage2D(i.TEXTURE_2D,Xe,Z,Y.width,Y.height);else{let se=Y.width,Ce=Y.height;for(let Ge=0;Ge<Xe;Ge++)t.texImage2D(i.TEXTURE_2D,Ge,Z,se,Ce,0,ce,R,null),se>>=1,Ce>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let se=i.canvas;if(se.hasAttribute("layoutsubtree")||se.setAttribute("layoutsubtree","true"),Y.parentNode!==se){se.appendChild(Y),u.add(S),se.onpaint=Ce=>{let Ge=Ce.changedElements;for(let ge of u)Ge.includes(ge.image)&&(ge.needsUpdate=!0)},se.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,Y);else{let Ge=i.RGBA,ge=i.RGBA,ht=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ge,ge,ht,Y)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(he.length>0){if(re&&le){let se=Fe(he[0]);t.texStorage2D(i.TEXTURE_2D,Xe,Z,se.width,se.height)}for(let se=0,Ce=he.length;se<Ce;se++)X=he[se],re?Ae&&t.texSubImage2D(i.TEXTURE_2D,se,0,0,ce,R,X):t.texImage2D(i.TEXTURE_2D,se,Z,ce,R,X);S.generateMipmaps=!1}else if(re){if(le){let se=Fe(Y);t.texStorage2D(i.TEXTURE_2D,Xe,Z,se.width,se.height)}Ae&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ce,R,Y)}else t.texImage2D(i.TEXTURE_2D,0,Z,ce,R,Y);w(S)&&S.mipmapsAutoUpdate===!0&&M(ne),de.__version=ae.version,S.onUpdate&&S.onUpdate(S)}A.__version=S.version}function gn(A,S,F){if(S.image.length!==6)return;let ne=ut(A,S),K=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,A.__webglTexture,i.TEXTURE0+F);let ae=n.get(K);if(K.version!==ae.__version||ne===!0){t.activeTexture(i.TEXTURE0+F);let de=Qe.getPrimaries(Qe.workingColorSpace),$=S.colorSpace===Ri?null:Qe.getPrimaries(S.colorSpace),Y=S.colorSpace===Ri||de===$?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);let ce=S.isCompressedTexture||S.image[0].isCompressedTexture,R=S.image[0]&&S.image[0].isDataTexture,Z=[];for(let ge=0;ge<6;ge++)!ce&&!R?Z[ge]=x(S.image[ge],!0,s.maxCubemapSize):Z[ge]=R?S.image[ge].image:S.image[ge],Z[ge]=Ie(S,Z[ge]);let X=Z[0],he=r.convert(S.format,S.colorSpace),re=r.convert(S.type),le=b(S.internalFormat,he,re,S.normalized,S.colorSpace),Ae=S.isVideoTexture!==!0,Xe=ae.__version===void 0||ne===!0,se=K.dataReady,Ce=T(S,X);ct(i.TEXTURE_CUBE_MAP,S);let Ge;if(S.isDepthTexture){if(le=_(S.format===Ci,S.type),Xe)if(Ae)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,le,X.width,X.height);else for(let ge=0;ge<6;ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,X.width,X.height,0,he,re,null)}else if(ce){Ae&&Xe&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Ce,le,X.width,X.height);for(let ge=0;ge<6;ge++){Ge=Z[ge].mipmaps;for(let ht=0;ht<Ge.length;ht++){let Ft=Ge[ht];S.format!==Jn?he!==null?Ae?se&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht,0,0,Ft.width,Ft.height,he,Ft.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht,le,Ft.width,Ft.height,0,Ft.data):Re("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht,0,0,Ft.width,Ft.height,he,re,Ft.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht,le,Ft.width,Ft.height,0,he,re,Ft.data)}}}else{if(Ge=S.mipmaps,Ae&&Xe){Ge.length>0&&Ce++;let ge=Fe(Z[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Ce,le,ge.width,ge.height)}for(let ge=0;ge<6;ge++)if(R){Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,Z[ge].width,Z[ge].height,he,re,Z[ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,Z[ge].width,Z[ge].height,0,he,re,Z[ge].data);for(let ht=0;ht<Ge.length;ht++){let Di=Ge[ht].image[ge].image;Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht+1,0,0,Di.width,Di.height,he,re,Di.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht+1,le,Di.width,Di.height,0,he,re,Di.data)}}else{Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,0,0,he,re,Z[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,0,le,he,re,Z[ge]);for(let ht=0;ht<Ge.length;ht++){let Ft=Ge[ht];Ae?se&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht+1,0,0,he,re,Ft.image[ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ge,ht+1,le,he,re,Ft.image[ge])}}}w(S)&&S.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),ae.__version=K.version,S.onUpdate&&S.onUpdate(S)}A.__version=S.version}function bt(A,S,F,ne,K,ae){let de=r.convert(F.format,F.colorSpace),$=r.convert(F.type),Y=b(F.internalFormat,de,$,F.normalized,F.colorSpace),ce=n.get(S),R=n.get(F);if(R.__renderTarget=S,!ce.__hasExternalTextures){let Z=Math.max(1,S.width>>ae),X=Math.max(1,S.height>>ae);K===i.TEXTURE_3D||K===i.TEXTURE_2D_ARRAY?t.texImage3D(K,ae,Y,Z,X,S.depth,0,de,$,null):t.texImage2D(K,ae,Y,Z,X,0,de,$,null)}t.bindFramebuffer(i.FRAMEBUFFER,A),me(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ne,K,R.__webglTexture,0,xt(S)):(K===i.TEXTURE_2D||K>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&K<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ne,K,R.__webglTexture,ae),t.bindFramebuffer(i.FRAMEBUFFER,null)}function ei(A,S,F){if(i.bindRenderbuffer(i.RENDERBUFFER,A),S.depthBuffer){let ne=S.depthTexture,K=ne&&ne.isDepthTexture?ne.type:null,ae=_(S.stencilBuffer,K),de=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;me(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xt(S),ae,S.width,S.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,xt(S),ae,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,ae,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,de,i.RENDERBUFFER,A)}else{let ne=S.textures;for(let K=0;K<ne.length;K++){let ae=ne[K],de=r.convert(ae.format,ae.colorSpace),$=r.convert(ae.type),Y=b(ae.internalFormat,de,$,ae.normalized,ae.colorSpace);me(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,xt(S),Y,S.width,S.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,xt(S),Y,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,Y,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ut(A,S,F){let ne=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,A),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let K=n.get(S.depthTexture);K.__renderTarget=S;let ae=ne?S.depthTexture.image[0]:S.depthTexture.image;(!K.__webglTexture||ae.width!==S.width||ae.height!==S.height)&&(ae.width=S.width,ae.height=S.height,S.depthTexture.needsUpdate=!0),ne?ye(S.depthTexture,0):_e(S.depthTexture,0);let de=K.__webglTexture,$=xt(S),Y=ne?i.TEXTURE_CUBE_MAP_POSITIVE_X+F:i.TEXTURE_2D,ce=S.depthTexture.format===Ci?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===Ei)me(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,Y,de,0,$):i.framebufferTexture2D(i.FRAMEBUFFER,ce,Y,de,0);else if(S.depthTexture.format===Ci)me(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,Y,de,0,$):i.framebufferTexture2D(i.FRAMEBUFFER,ce,Y,de,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Rn(A){let S=n.get(A),F=A.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==A.depthTexture){let ne=A.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ne){let K=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ne.removeEventListener("dispose",K)};ne.addEventListener("dispose",K),S.__depthDisposeCallback=K}S.__boundDepthTexture=ne}if(A.depthTexture&&!S.__autoAllocateDepthBuffer)if(F)for(let ne=0;ne<6;ne++)Ut(S.__webglFramebuffer[ne],A,ne);else A.texture.mipmaps.length>0?Ut(S.__webglFramebuffer[0],A,0):Ut(S.__webglFramebuffer,A,0);else if(F){S.__webglDepthbuffer=[];for(let ne=0;ne<6;ne++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[ne]),S.__webglDepthbuffer[ne]===void 0)S.__webglDepthbuffer[ne]=i.createRenderbuffer(),ei(S.__webglDepthbuffer[ne],A,!1);else{let K=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=S.__webglDepthbuffer[ne];i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,K,i.RENDERBUFFER,ae)}}else if(A.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),ei(S.__webglDepthbuffer,A,!1);else{let K=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ae=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ae),i.framebufferRenderbuffer(i.FRAMEBUFFER,K,i.RENDERBUFFER,ae)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Pn(A,S,F){let ne=n.get(A);S!==void 0&&bt(ne.__webglFramebuffer,A,A.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),F!==void 0&&Rn(A)}function In(A){let S=A.texture,F=n.get(A),ne=n.get(S);A.addEventListener("dispose",k),O(A);let K=A.textures,ae=A.isWebGLCubeRenderTarget===!0,de=K.length>1;if(de||(ne.__webglTexture===void 0&&(ne.__webglTexture=i.createTexture()),ne.__version=S.version,o.memory.textures++),ae){F.__webglFramebuffer=[];for(let $=0;$<6;$++)if(S.mipmaps.length>0){F.__webglFramebuffer[$]=[];for(let Y=0;Y<S.mipmaps.length;Y++)F.__webglFramebuffer[$][Y]=i.createFramebuffer()}else F.__webglFramebuffer[$]=i.createFramebuffer()}else{if(S.mipmaps.length>0){F.__webglFramebuffer=[];for(let $=0;$<S.mipmaps.length;$++)F.__webglFramebuffer[$]=i.createFramebuffer()}else F.__webglFramebuffer=i.createFramebuffer();if(de)for(let $=0,Y=K.length;$<Y;$++){let ce=n.get(K[$]);ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture(),o.memory.textures++)}if(A.samples>0&&me(A)===!1){F.__webglMultisampledFramebuffer=i.createFramebuffer(),F.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,F.__webglMultisampledFramebuffer);for(let $=0;$<K.length;$++){let Y=K[$];F.__webglColorRenderbuffer[$]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,F.__webglColorRenderbuffer[$]);let ce=r.convert(Y.format,Y.colorSpace),R=r.convert(Y.type),Z=b(Y.internalFormat,ce,R,Y.normalized,Y.colorSpace,A.isXRRenderTarget===!0),X=xt(A);i.renderbufferStorageMultisample(i.RENDERBUFFER,X,Z,A.width,A.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+$,i.RENDERBUFFER,F.__webglColorRenderbuffer[$])}i.bindRenderbuffer(i.RENDERBUFFER,null),A.depthBuffer&&(F.__webglDepthRenderbuffer=i.createRenderbuffer(),ei(F.__webglDepthRenderbuffer,A,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ae){t.bindTexture(i.TEXTURE_CUBE_MAP,ne.__webglTexture),ct(i.TEXTURE_CUBE_MAP,S);for(let $=0;$<6;$++)if(S.mipmaps.length>0)for(let Y=0;Y<S.mipmaps.length;Y++)bt(F.__webglFramebuffer[$][Y],A,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+$,Y);else bt(F.__webglFramebuffer[$],A,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+$,0);w(S)?M(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(de){for(let $=0,Y=K.length;$<Y;$++){let ce=K[$],R=n.get(ce),Z=i.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Z=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(Z,R.__webglTexture),ct(Z,ce),bt(F.__webglFramebuffer,A,ce,i.COLOR_ATTACHMENT0+$,Z,0),w(ce)&&M(Z)}t.unbindTexture()}else{let $=i.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&($=A.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture($,ne.__webglTexture),ct($,S),S.mipmaps.length>0)for(let Y=0;Y<S.mipmaps.length;Y++)bt(F.__webglFramebuffer[Y],A,S,i.COLOR_ATTACHMENT0,$,Y);else bt(F.__webglFramebuffer,A,S,i.COLOR_ATTACHMENT0,$,0);w(S)?M($):S.mipmaps.length>0&&i.texParameteri($,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}A.depthBuffer&&Rn(A)}function N(A){let S=A.textures;for(let F=0,ne=S.length;F<ne;F++){let K=S[F];if(w(K)&&K.mipmapsAutoUpdate===!0){let ae=v(A),de=n.get(K).__webglTexture;t.bindTexture(ae,de),M(ae),t.unbindTexture()}}}let Ln=[];function yt(A){if(A.samples>0){if(me(A)===!1){let S=A.textures,F=A.width,ne=A.height,K=i.COLOR_BUFFER_BIT,ae=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,de=n.get(A),$=S.length>1;if($)for(let ce=0;ce<S.length;ce++)t.bindFramebuffer(i.FRAMEBUFFER,de.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,de.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,de.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglFramebuffer);for(let ce=0;ce<S.length;ce++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(K|=i.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(K|=i.STENCIL_BUFFER_BIT)),$){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,de.__webglColorRenderbuffer[ce]);let R=n.get(S[ce]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,R,0)}i.blitFramebuffer(0,0,F,ne,0,0,F,ne,K,i.NEAREST),l===!0&&(Ln.length=0,Ln.push(i.COLOR_ATTACHMENT0+ce),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&Ln.push(ae),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ln))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),$)for(let ce=0;ce<S.length;ce++){t.bindFramebuffer(i.FRAMEBUFFER,de.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.RENDERBUFFER,de.__webglColorRenderbuffer[ce]);let R=n.get(S[ce]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,de.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ce,i.TEXTURE_2D,R,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,de.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let S=A.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function xt(A){return Math.min(s.maxSamples,A.samples)}function me(A){let S=n.get(A);return A.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function It(A){let S=o.render.frame;h.get(A)!==S&&(h.set(A,S),A.update())}function Ie(A,S){let F=A.colorSpace,ne=A.format,K=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||F!==Wr&&F!==Ri&&(Qe.getTransfer(F)===at?(ne!==Jn||K!==xn)&&Re("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):De("WebGLTextures: Unsupported texture color space:",F)),S}function Fe(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=Be,this.resetTextureUnits=Q,this.getTextureUnits=te,this.setTextureUnits=Ee,this.setTexture2D=_e,this.setTexture2DArray=be,this.setTexture3D=Pe,this.setTextureCube=ye,this.rebindTextures=Pn,this.setupRenderTarget=In,this.updateRenderTargetMipmap=N,this.updateMultisampleRenderTarget=yt,this.setupDepthRenderbuffer=Rn,this.setupFrameBufferTexture=bt,this.useMultisampledRTT=me,this.dispose=V}function SS(i,e){function t(n,s=Ri){let r,o=Qe.getTransfer(s);if(n===xn)return i.UNSIGNED_BYTE;if(n===vl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===bl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===lu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===cu)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ou)return i.BYTE;if(n===au)return i.SHORT;if(n===ur)return i.UNSIGNED_SHORT;if(n===xl)return i.INT;if(n===qn)return i.UNSIGNED_INT;if(n===$n)return i.FLOAT;if(n===Yn)return i.HALF_FLOAT;if(n===hu)return i.ALPHA;if(n===uu)return i.RGB;if(n===Jn)return i.RGBA;if(n===Ei)return i.DEPTH_COMPONENT;if(n===Ci)return i.DEPTH_STENCIL;if(n===du)return i.RED;if(n===Sl)return i.RED_INTEGER;if(n===Zi)return i.RG;if(n===Ml)return i.RG_INTEGER;if(n===wl)return i.RGBA_INTEGER;if(n===_o||n===yo||n===xo||n===vo)if(o===at)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===_o)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===yo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===xo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===vo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===_o)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===yo)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===xo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===vo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===El||n===Tl||n===Al||n===Cl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===El)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Tl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Al)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Cl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Rl||n===Pl||n===Il||n===Ll||n===Ol||n===bo||n===Dl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Rl||n===Pl)return o===at?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Il)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Ll)return r.COMPRESSED_R11_EAC;if(n===Ol)return r.COMPRESSED_SIGNED_R11_EAC;if(n===bo)return r.COMPRESSED_RG11_EAC;if(n===Dl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Nl||n===Ul||n===Fl||n===Bl||n===kl||n===zl||n===Vl||n===Hl||n===Gl||n===Wl||n===Xl||n===ql||n===$l||n===Yl)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Nl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ul)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Fl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Bl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===kl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===zl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Vl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Hl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Gl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Wl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Xl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ql)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===$l)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Yl)return o===at?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Jl||n===Zl||n===Kl)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Jl)return o===at?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Zl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Kl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===jl||n===Ql||n===So||n===ec)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===jl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ql)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===So)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ec)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===ys?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var MS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,wS=`
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

}`,Nu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new to(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Ot({vertexShader:MS,fragmentShader:wS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Lt(new ri(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Uu=class extends ii{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,m=null,g=null,y=typeof XRWebGLBinding<"u",p=new Nu,f={},x=t.getContextAttributes(),w=null,M=null,v=[],b=[],_=new He,T=null,O=null,P=new cn;P.viewport=new it;let D=new cn;D.viewport=new it;let k=[P,D],W=new pl,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let _e=v[J];return _e===void 0&&(_e=new nr,v[J]=_e),_e.getTargetRaySpace()},this.getControllerGrip=function(J){let _e=v[J];return _e===void 0&&(_e=new nr,v[J]=_e),_e.getGripSpace()},this.getHand=function(J){let _e=v[J];return _e===void 0&&(_e=new nr,v[J]=_e),_e.getHandSpace()};function j(J){let _e=b.indexOf(J.inputSource);if(_e===-1)return;let be=v[_e];be!==void 0&&(be.update(J.inputSource,J.frame,c||o),be.dispatchEvent({type:J.type,data:J.inputSource}))}function z(){s.removeEventListener("select",j),s.removeEventListener("selectstart",j),s.removeEventListener("selectend",j),s.removeEventListener("squeeze",j),s.removeEventListener("squeezestart",j),s.removeEventListener("squeezeend",j),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",ie);for(let J=0;J<v.length;J++){let _e=b[J];_e!==null&&(b[J]=null,v[J].disconnect(_e))}I=null,V=null,p.reset();for(let J in f)delete f[J];if(e.setRenderTarget(w),m=null,d=null,u=null,s=null,M=null,Be.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(_.width,_.height,!1),O!==null){let J=O.camera;J.fov=O.fov,J.zoom=O.zoom,J.updateProjectionMatrix(),O=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,n.isPresenting===!0&&Re("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,n.isPresenting===!0&&Re("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(J){c=J},this.getBaseLayer=function(){return d!==null?d:m},this.getBinding=function(){return u===null&&y&&(u=new XRWebGLBinding(s,t)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",j),s.addEventListener("selectstart",j),s.addEventListener("selectend",j),s.addEventListener("squeeze",j),s.addEventListener("squeezestart",j),s.addEventListener("squeezeend",j),s.addEventListener("end",z),s.addEventListener("inputsourceschange",ie),x.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(_),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Pe=null,ye=null;x.depth&&(ye=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=x.stencil?Ci:Ei,Pe=x.stencil?ys:qn);let Ve={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ve),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),M=new sn(d.textureWidth,d.textureHeight,{format:Jn,type:xn,depthTexture:new Ti(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let be={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};m=new XRWebGLLayer(s,t,be),s.updateRenderState({baseLayer:m}),e.setPixelRatio(1),e.setSize(m.framebufferWidth,m.framebufferHeight,!1),M=new sn(m.framebufferWidth,m.framebufferHeight,{format:Jn,type:xn,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:m.ignoreDepthValues===!1,resolveStencilBuffer:m.ignoreDepthValues===!1,storeMultisampledDepthBuffer:m.ignoreDepthValues===!1,storeMultisampledStencilBuffer:m.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Be.setContext(s),Be.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return p.getDepthTexture()};function ie(J){for(let _e=0;_e<J.removed.length;_e++){let be=J.removed[_e],Pe=b.indexOf(be);Pe>=0&&(b[Pe]=null,v[Pe].disconnect(be))}for(let _e=0;_e<J.added.length;_e++){let be=J.added[_e],Pe=b.indexOf(be);if(Pe===-1){for(let Ve=0;Ve<v.length;Ve++)if(Ve>=b.length){b.push(be),Pe=Ve;break}else if(b[Ve]===null){b[Ve]=be,Pe=Ve;break}if(Pe===-1)break}let ye=v[Pe];ye&&ye.connect(be)}}function q(J,_e){_e===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(_e.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let _e=J.near,be=J.far;p.texture!==null&&(p.depthNear>0&&(_e=p.depthNear),p.depthFar>0&&(be=p.depthFar)),W.near=D.near=P.near=_e,W.far=D.far=P.far=be,(I!==W.near||V!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),I=W.near,V=W.far),W.layers.mask=J.layers.mask|6,P.layers.mask=W.layers.mask&-5,D.layers.mask=W.layers.mask&-3;let Pe=J.parent,ye=W.cameras;q(W,Pe);for(let Ve=0;Ve<ye.length;Ve++)q(ye[Ve],Pe);W.projectionMatrix.copy(P.projectionMatrix),W.projectionMatrixInverse.copy(P.projectionMatrixInverse),O===null&&J.isPerspectiveCamera&&(O={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,W,Pe)};function Q(J,_e,be){be===null?J.matrix.copy(_e.matrixWorld):(J.matrix.copy(be.matrixWorld),J.matrix.invert(),J.matrix.multiply(_e.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(_e.projectionMatrix),J.projectionMatrixInverse.copy(_e.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Qs*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&m===null))return l},this.setFoveation=function(J){l=J,d!==null&&(d.fixedFoveation=J),m!==null&&m.fixedFoveation!==void 0&&(m.fixedFoveation=J)},this.hasDepthSensing=function(){return p.texture!==null},this.getDepthSensingMesh=function(){return p.getMesh(W)},this.getCameraTexture=function(J){return f[J]};let te=null;function Ee(J,_e){if(h=_e.getViewerPose(c||o),g=_e,h!==null){let be=h.views;m!==null&&(e.setRenderTargetFramebuffer(M,m.framebuffer),e.setRenderTarget(M));let Pe=!1;be.length!==W.cameras.length&&(W.cameras.length=0,Pe=!0);for(let Le=0;Le<be.length;Le++){let ct=be[Le],ut=null;if(m!==null)ut=m.getViewport(ct);else{let Gt=u.getViewSubImage(d,ct);ut=Gt.viewport,Le===0&&(e.setRenderTargetTextures(M,Gt.colorTexture,Gt.depthStencilTexture),e.setRenderTarget(M))}let Je=k[Le];Je===void 0&&(Je=new cn,Je.layers.enable(Le),Je.viewport=new it,k[Le]=Je),Je.matrix.fromArray(ct.transform.matrix),Je.matrix.decompose(Je.position,Je.quaternion,Je.scale),Je.projectionMatrix.fromArray(ct.projectionMatrix),Je.projectionMatrixInverse.copy(Je.projectionMatrix).invert(),Je.viewport.set(ut.x,ut.y,ut.width,ut.height),Le===0&&(W.matrix.copy(Je.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Pe===!0&&W.cameras.push(Je)}let ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){u=n.getBinding();let Le=u.getDepthInformation(be[0]);Le&&Le.isValid&&Le.texture&&p.init(Le,s.renderState)}if(ye&&ye.includes("camera-access")&&y){e.state.unbindTexture(),u=n.getBinding();for(let Le=0;Le<be.length;Le++){let ct=be[Le].camera;if(ct){let ut=f[ct];ut||(ut=new to,f[ct]=ut);let Je=u.getCameraImage(ct);ut.sourceTexture=Je}}}}for(let be=0;be<v.length;be++){let Pe=b[be],ye=v[be];Pe!==null&&ye!==void 0&&ye.update(Pe,_e,c||o)}te&&te(J,_e),_e.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:_e}),g=null}let Be=new em;Be.setAnimationLoop(Ee),this.setAnimationLoop=function(J){te=J},this.dispose=function(){}}},ES=new ot,hm=new Ue;hm.set(-1,0,0,0,1,0,0,0,1);function TS(i,e){function t(p,f){p.matrixAutoUpdate===!0&&p.updateMatrix(),f.value.copy(p.matrix)}function n(p,f){f.color.getRGB(p.fogColor.value,Mu(i)),f.isFog?(p.fogNear.value=f.near,p.fogFar.value=f.far):f.isFogExp2&&(p.fogDensity.value=f.density)}function s(p,f,x,w,M){f.isNodeMaterial?f.uniformsNeedUpdate=!1:f.isMeshBasicMaterial?r(p,f):f.isMeshLambertMaterial?(r(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshToonMaterial?(r(p,f),u(p,f)):f.isMeshPhongMaterial?(r(p,f),h(p,f),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)):f.isMeshStandardMaterial?(r(p,f),d(p,f),f.isMeshPhysicalMaterial&&m(p,f,M)):f.isMeshMatcapMaterial?(r(p,f),g(p,f)):f.isMeshDepthMaterial?r(p,f):f.isMeshDistanceMaterial?(r(p,f),y(p,f)):f.isMeshNormalMaterial?r(p,f):f.isLineBasicMaterial?(o(p,f),f.isLineDashedMaterial&&a(p,f)):f.isPointsMaterial?l(p,f,x,w):f.isSpriteMaterial?c(p,f):f.isShadowMaterial?(p.color.value.copy(f.color),p.opacity.value=f.opacity):f.isShaderMaterial&&(f.uniformsNeedUpdate=!1)}function r(p,f){p.opacity.value=f.opacity,f.color&&p.diffuse.value.copy(f.color),f.emissive&&p.emissive.value.copy(f.emissive).multiplyScalar(f.emissiveIntensity),f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.bumpMap&&(p.bumpMap.value=f.bumpMap,t(f.bumpMap,p.bumpMapTransform),p.bumpScale.value=f.bumpScale,f.side===dn&&(p.bumpScale.value*=-1)),f.normalMap&&(p.normalMap.value=f.normalMap,t(f.normalMap,p.normalMapTransform),p.normalScale.value.copy(f.normalScale),f.side===dn&&p.normalScale.value.negate()),f.displacementMap&&(p.displacementMap.value=f.displacementMap,t(f.displacementMap,p.displacementMapTransform),p.displacementScale.value=f.displacementScale,p.displacementBias.value=f.displacementBias),f.emissiveMap&&(p.emissiveMap.value=f.emissiveMap,t(f.emissiveMap,p.emissiveMapTransform)),f.specularMap&&(p.specularMap.value=f.specularMap,t(f.specularMap,p.specularMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest);let x=e.get(f),w=x.envMap,M=x.envMapRotation;w&&(p.envMap.value=w,p.envMapRotation.value.setFromMatrix4(ES.makeRotationFromEuler(M)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&p.envMapRotation.value.premultiply(hm),p.reflectivity.value=f.reflectivity,p.ior.value=f.ior,p.refractionRatio.value=f.refractionRatio),f.lightMap&&(p.lightMap.value=f.lightMap,p.lightMapIntensity.value=f.lightMapIntensity,t(f.lightMap,p.lightMapTransform)),f.aoMap&&(p.aoMap.value=f.aoMap,p.aoMapIntensity.value=f.aoMapIntensity,t(f.aoMap,p.aoMapTransform))}function o(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform))}function a(p,f){p.dashSize.value=f.dashSize,p.totalSize.value=f.dashSize+f.gapSize,p.scale.value=f.scale}function l(p,f,x,w){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.size.value=f.size*x,p.scale.value=w*.5,f.map&&(p.map.value=f.map,t(f.map,p.uvTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function c(p,f){p.diffuse.value.copy(f.color),p.opacity.value=f.opacity,p.rotation.value=f.rotation,f.map&&(p.map.value=f.map,t(f.map,p.mapTransform)),f.alphaMap&&(p.alphaMap.value=f.alphaMap,t(f.alphaMap,p.alphaMapTransform)),f.alphaTest>0&&(p.alphaTest.value=f.alphaTest)}function h(p,f){p.specular.value.copy(f.specular),p.shininess.value=Math.max(f.shininess,1e-4)}function u(p,f){f.gradientMap&&(p.gradientMap.value=f.gradientMap)}function d(p,f){p.metalness.value=f.metalness,f.metalnessMap&&(p.metalnessMap.value=f.metalnessMap,t(f.metalnessMap,p.metalnessMapTransform)),p.roughness.value=f.roughness,f.roughnessMap&&(p.roughnessMap.value=f.roughnessMap,t(f.roughnessMap,p.roughnessMapTransform)),f.envMap&&(p.envMapIntensity.value=f.envMapIntensity)}function m(p,f,x){p.ior.value=f.ior,f.diffuseRoughness>0&&(p.diffuseRoughness.value=f.diffuseRoughness,f.diffuseRoughnessMap&&(p.diffuseRoughnessMap.value=f.diffuseRoughnessMap,t(f.diffuseRoughnessMap,p.diffuseRoughnessMapTransform))),f.sheen>0&&(p.sheenColor.value.copy(f.sheenColor).multiplyScalar(f.sheen),p.sheenRoughness.value=f.sheenRoughness,f.sheenColorMap&&(p.sheenColorMap.value=f.sheenColorMap,t(f.sheenColorMap,p.sheenColorMapTransform)),f.sheenRoughnessMap&&(p.sheenRoughnessMap.value=f.sheenRoughnessMap,t(f.sheenRoughnessMap,p.sheenRoughnessMapTransform))),f.clearcoat>0&&(p.clearcoat.value=f.clearcoat,p.clearcoatRoughness.value=f.clearcoatRoughness,f.clearcoatMap&&(p.clearcoatMap.value=f.clearcoatMap,t(f.clearcoatMap,p.clearcoatMapTransform)),f.clearcoatRoughnessMap&&(p.clearcoatRoughnessMap.value=f.clearcoatRoughnessMap,t(f.clearcoatRoughnessMap,p.clearcoatRoughnessMapTransform)),f.clearcoatNormalMap&&(p.clearcoatNormalMap.value=f.clearcoatNormalMap,t(f.clearcoatNormalMap,p.clearcoatNormalMapTransform),p.clearcoatNormalScale.value.copy(f.clearcoatNormalScale),f.side===dn&&p.clearcoatNormalScale.value.negate())),f.dispersion>0&&(p.dispersion.value=f.dispersion),f.retroreflectivity>0&&(p.retroreflectivity.value=f.retroreflectivity),f.iridescence>0&&(p.iridescence.value=f.iridescence,p.iridescenceIOR.value=f.iridescenceIOR,p.iridescenceThicknessMinimum.value=f.iridescenceThicknessMinimum,p.iridescenceThicknessMaximum.value=f.iridescenceThicknessMaximum,f.iridescenceMap&&(p.iridescenceMap.value=f.iridescenceMap,t(f.iridescenceMap,p.iridescenceMapTransform)),f.iridescenceThicknessMap&&(p.iridescenceThicknessMap.value=f.iridescenceThicknessMap,t(f.iridescenceThicknessMap,p.iridescenceThicknessMapTransform))),f.transmission>0&&(p.transmission.value=f.transmission,p.transmissionSamplerMap.value=x.texture,p.transmissionSamplerSize.value.set(x.width,x.height),f.transmissionMap&&(p.transmissionMap.value=f.transmissionMap,t(f.transmissionMap,p.transmissionMapTransform)),p.thickness.value=f.thickness,f.thicknessMap&&(p.thicknessMap.value=f.thicknessMap,t(f.thicknessMap,p.thicknessMapTransform)),p.attenuationDistance.value=f.attenuationDistance,p.attenuationColor.value.copy(f.attenuationColor)),f.anisotropy>0&&(p.anisotropyVector.value.set(f.anisotropy*Math.cos(f.anisotropyRotation),f.anisotropy*Math.sin(f.anisotropyRotation)),f.anisotropyMap&&(p.anisotropyMap.value=f.anisotropyMap,t(f.anisotropyMap,p.anisotropyMapTransform))),p.specularIntensity.value=f.specularIntensity,p.specularColor.value.copy(f.specularColor),f.specularColorMap&&(p.specularColorMap.value=f.specularColorMap,t(f.specularColorMap,p.specularColorMapTransform)),f.specularIntensityMap&&(p.specularIntensityMap.value=f.specularIntensityMap,t(f.specularIntensityMap,p.specularIntensityMapTransform))}function g(p,f){f.matcap&&(p.matcap.value=f.matcap)}function y(p,f){let x=e.get(f).light;p.referencePosition.value.setFromMatrixPosition(x.matrixWorld),p.nearDistance.value=x.shadow.camera.near,p.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function AS(i,e,t,n){let s={},r={};function o(x,w){let M=w.program;n.uniformBlockBinding(x,M,s[x.id])}function a(x,w){let M=s[x.id];M===void 0&&(g(x),M=l(x),s[x.id]=M,x.addEventListener("dispose",p));let v=w.program;n.updateUBOMapping(x,v);let b=e.render.frame;r[x.id]!==b&&(c(x),r[x.id]=b)}function l(x){let w=i.createBuffer(),M=x.__size,v=x.usage;return i.bindBuffer(i.UNIFORM_BUFFER,w),i.bufferData(i.UNIFORM_BUFFER,M,v),i.bindBuffer(i.UNIFORM_BUFFER,null),w}function c(x){let w=s[x.id],M=x.uniforms,v=x.__cache;i.bindBuffer(i.UNIFORM_BUFFER,w);for(let b=0,_=M.length;b<_;b++){let T=M[b];if(Array.isArray(T))for(let O=0,P=T.length;O<P;O++)h(T[O],b,O,v);else h(T,b,0,v)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(x,w,M,v){if(d(x,w,M,v)===!0){let b=x.__offset,_=x.value;if(Array.isArray(_)){let T=0;for(let O=0;O<_.length;O++){let P=_[O],D=y(P,!0);u(P,x.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,x.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,b,x.__data)}}function u(x,w,M){typeof x=="number"||typeof x=="boolean"?w[M]=x:x.isMatrix3?(w[M]=x.elements[0],w[M+1]=x.elements[1],w[M+2]=x.elements[2],w[M+3]=0,w[M+4]=x.elements[3],w[M+5]=x.elements[4],w[M+6]=x.elements[5],w[M+7]=0,w[M+8]=x.elements[6],w[M+9]=x.elements[7],w[M+10]=x.elements[8],w[M+11]=0):ArrayBuffer.isView(x)?w.set(x.subarray(0,w.length-M),M):x.toArray(w,M)}function d(x,w,M,v){let b=x.value,_=w+"_"+M;if(Array.isArray(b)){v[_]===void 0&&(v[_]=[]);let T=v[_],O=!1;for(let P=0;P<b.length;P++)m(b[P],T,P)===!0&&(O=!0);return O}return m(b,v,_)}function m(x,w,M){if(w[M]===void 0)return typeof x=="number"||typeof x=="boolean"?w[M]=x:ArrayBuffer.isView(x)?w[M]=x.slice():w[M]=x.clone(),!0;{let v=w[M];if(typeof x=="number"||typeof x=="boolean"){if(v!==x)return w[M]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(v.equals(x)===!1)return v.copy(x),!0}}return!1}function g(x){let w=x.uniforms,M=0,v=16;for(let _=0,T=w.length;_<T;_++){let O=Array.isArray(w[_])?w[_]:[w[_]];for(let P=0,D=O.length;P<D;P++){let k=O[P],W=Array.isArray(k.value)?k.value:[k.value],I=Array.isArray(w[_])||Array.isArray(k.value),V=M;for(let z=0,ie=W.length;z<ie;z++){let q=W[z],Q=y(q,I),te=M%v,Ee=te%Q.boundary,Be=te+Ee;M+=Ee,Be!==0&&v-Be<Q.storage&&(M+=v-Be),z===0&&(V=M),M+=Q.storage}let j=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new j((M-V)/Float32Array.BYTES_PER_ELEMENT),k.__offset=V}}let b=M%v;return b>0&&(M+=v-b),x.__size=M,x.__cache={},this}function y(x,w){let M={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(M.boundary=4,M.storage=4):x.isVector2?(M.boundary=8,M.storage=8):x.isVector3||x.isColor?(M.boundary=16,M.storage=12):x.isVector4?(M.boundary=16,M.storage=16):x.isMatrix3?(M.boundary=16,M.storage=48):x.isMatrix4?(M.boundary=16,M.storage=64):x.isTexture?Re("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(M.boundary=16,M.storage=x.byteLength):Re("WebGLRenderer: Unsupported uniform value type.",x),w===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function p(x){let w=x.target;w.removeEventListener("dispose",p),i.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function f(){for(let x in s)i.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:f}}var CS=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),li=null;function RS(){return li===null&&(li=new Ya(CS,16,16,Zi,Yn),li.name="DFG_LUT",li.minFilter=hn,li.magFilter=hn,li.wrapS=ni,li.wrapT=ni,li.generateMipmaps=!1,li.needsUpdate=!0),li}var rc=class{constructor(e={}){let{canvas:t=Tp(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:m=xn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let y=m,p=new Set([wl,Ml,Sl]),f=new Set([xn,qn,ur,ys,vl,bl]),x=new Uint32Array(4),w=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},v=null,b=null,_=[],T=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ai,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,k=null,W=null,I=null,V=null;this._outputColorSpace=En;let j=0,z=0,ie=null,q=-1,Q=null,te=new it,Ee=new it,Be=null,J=new Oe(0),_e=0,be=t.width,Pe=t.height,ye=1,Ve=null,At=null,Le=new it(0,0,be,Pe),ct=new it(0,0,be,Pe),ut=!1,Je=new Gi,Gt=new Ja,Pt=!1,gn=!1,bt=new ot,ei=new C,Ut=new it,Rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Pn=!1;function In(){return ie===null?ye:1}let N=n;function Ln(E,L){return t.getContext(E,L)}let yt,xt,me,It,Ie,Fe,A,S,F,ne,K,ae,de,$,Y,ce,R,Z,X,he,re,le,Ae;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ce,!1),t.addEventListener("webglcontextrestored",Ge,!1),t.addEventListener("webglcontextcreationerror",ge,!1),N===null){let L="webgl2";if(N=Ln(L,E),N===null)throw Ln(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Xe()}catch(E){throw t.removeEventListener("webglcontextlost",Ce,!1),t.removeEventListener("webglcontextrestored",Ge,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),De("WebGLRenderer: "+E.message),E}function Xe(){yt=new zv(N),yt.init(),re=new SS(N,yt),xt=new Rv(N,yt,e,re),me=new vS(N,yt),xt.reversedDepthBuffer&&d&&me.buffers.depth.setReversed(!0),W=N.createFramebuffer(),I=N.createFramebuffer(),V=N.createFramebuffer(),It=new Gv(N),Ie=new oS,Fe=new bS(N,yt,me,Ie,xt,re,It),A=new kv(P),S=new X0(N),le=new Av(N,S),F=new Vv(N,S,It,le),ne=new Xv(N,F,S,le,It),Z=new Wv(N,xt,Fe),Y=new Pv(Ie),K=new rS(P,A,yt,xt,le,Y),ae=new TS(P,Ie),de=new lS,$=new pS(yt),R=new Tv(P,A,me,ne,g,l),ce=new xS(P,ne,xt),Ae=new AS(N,It,xt,me),X=new Cv(N,yt,It),he=new Hv(N,yt,It),It.programs=K.programs,P.capabilities=xt,P.extensions=yt,P.properties=Ie,P.renderLists=de,P.shadowMap=ce,P.state=me,P.info=It}y!==xn&&(O=new $v(y,t.width,t.height,a,s,r));let se=new Uu(P,N);this.xr=se,this.getContext=function(){return N},this.getContextAttributes=function(){return N.getContextAttributes()},this.forceContextLoss=function(){let E=yt.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=yt.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(E){E!==void 0&&(ye=E,this.setSize(be,Pe,!1))},this.getSize=function(E){return E.set(be,Pe)},this.setSize=function(E,L,G=!0){if(se.isPresenting){Re("WebGLRenderer: Can't change size while VR device is presenting.");return}be=E,Pe=L,t.width=Math.floor(E*ye),t.height=Math.floor(L*ye),G===!0&&(t.style.width=E+"px",t.style.height=L+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,E,L)},this.getDrawingBufferSize=function(E){return E.set(be*ye,Pe*ye).floor()},this.setDrawingBufferSize=function(E,L,G){be=E,Pe=L,ye=G,t.width=Math.floor(E*G),t.height=Math.floor(L*G),this.setViewport(0,0,E,L)},this.setEffects=function(E){if(y===xn){De("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let L=0;L<E.length;L++)if(E[L].isOutputPass===!0){Re("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(te)},this.getViewport=function(E){return E.copy(Le)},this.setViewport=function(E,L,G,U){E.isVector4?Le.set(E.x,E.y,E.z,E.w):Le.set(E,L,G,U),me.viewport(te.copy(Le).multiplyScalar(In()).round())},this.getScissor=function(E){return E.copy(ct)},this.setScissor=function(E,L,G,U){E.isVector4?ct.set(E.x,E.y,E.z,E.w):ct.set(E,L,G,U),me.scissor(Ee.copy(ct).multiplyScalar(In()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(E){me.setScissorTest(ut=E)},this.setOpaqueSort=function(E){Ve=E},this.setTransparentSort=function(E){At=E},this.getClearColor=function(E){return E.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(E=!0,L=!0,G=!0){let U=0;if(E){let B=!1;if(ie!==null){let fe=ie.texture.format;B=p.has(fe)}if(B){let fe=ie.texture.type,ve=f.has(fe),ue=R.getClearColor(),xe=R.getClearAlpha(),Te=ue.r,ke=ue.g,Ze=ue.b;ve?(x[0]=Te,x[1]=ke,x[2]=Ze,x[3]=xe,N.clearBufferuiv(N.COLOR,0,x)):(w[0]=Te,w[1]=ke,w[2]=Ze,w[3]=xe,N.clearBufferiv(N.COLOR,0,w))}else U|=N.COLOR_BUFFER_BIT}L&&(U|=N.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),G&&(U|=N.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&N.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),k=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Ce,!1),t.removeEventListener("webglcontextrestored",Ge,!1),t.removeEventListener("webglcontextcreationerror",ge,!1),R.dispose(),de.dispose(),$.dispose(),Fe.dispose(),Ie.dispose(),A.dispose(),ne.dispose(),F.dispose(),le.dispose(),Ae.dispose(),K.dispose(),se.dispose(),se.removeEventListener("sessionstart",Zd),se.removeEventListener("sessionend",Kd),ss.stop()};function Ce(E){E.preventDefault(),$r("WebGLRenderer: Context Lost."),D=!0}function Ge(){$r("WebGLRenderer: Context Restored."),D=!1;let E=It.autoReset,L=ce.enabled,G=ce.autoUpdate,U=ce.needsUpdate,B=ce.type;Xe(),It.autoReset=E,ce.enabled=L,ce.autoUpdate=G,ce.needsUpdate=U,ce.type=B}function ge(E){De("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function ht(E){let L=E.target;L.removeEventListener("dispose",ht),Ft(L)}function Ft(E){Di(E),Ie.remove(E)}function Di(E){let L=Ie.get(E).programs;L!==void 0&&(L.forEach(function(G){K.releaseProgram(G)}),E.isShaderMaterial&&K.releaseShaderCache(E))}this.renderBufferDirect=function(E,L,G,U,B,fe){L===null&&(L=Rn);let ve=B.isMesh&&B.matrixWorld.determinantAffine()<0,ue=D_(E,L,G,U,B);me.setMaterial(U,ve);let xe=G.index,Te=1;if(U.wireframe===!0){if(xe=F.getWireframeAttribute(G),xe===void 0)return;Te=2}let ke=G.drawRange,Ze=G.attributes.position,Se=ke.start*Te,Ke=(ke.start+ke.count)*Te;fe!==null&&(Se=Math.max(Se,fe.start*Te),Ke=Math.min(Ke,(fe.start+fe.count)*Te)),xe!==null?(Se=Math.max(Se,0),Ke=Math.min(Ke,xe.count)):Ze!=null&&(Se=Math.max(Se,0),Ke=Math.min(Ke,Ze.count));let Ct=Ke-Se;if(Ct<0||Ct===1/0)return;le.setup(B,U,ue,G,xe);let pt,dt=X;if(xe!==null&&(pt=S.get(xe),dt=he,dt.setIndex(pt)),B.isMesh)U.wireframe===!0?(me.setLineWidth(U.wireframeLinewidth*In()),dt.setMode(N.LINES)):dt.setMode(N.TRIANGLES);else if(B.isLine){let jt=U.linewidth;jt===void 0&&(jt=1),me.setLineWidth(jt*In()),B.isLineSegments?dt.setMode(N.LINES):B.isLineLoop?dt.setMode(N.LINE_LOOP):dt.setMode(N.LINE_STRIP)}else B.isPoints?dt.setMode(N.POINTS):B.isSprite&&dt.setMode(N.TRIANGLES);if(B.isBatchedMesh)if(yt.get("WEBGL_multi_draw"))dt.renderMultiDraw(B._multiDrawStarts,B._multiDrawCounts,B._multiDrawCount);else{let jt=B._multiDrawStarts,Me=B._multiDrawCounts,an=B._multiDrawCount,rt=xe?S.get(xe).bytesPerElement:1,rs=Ie.get(U).currentProgram.getUniforms();for(let Qt=0;Qt<an;Qt++)rs.setValue(N,"_gl_DrawID",Qt),dt.render(jt[Qt]/rt,Me[Qt])}else if(B.isInstancedMesh)dt.renderInstances(Se,Ct,B.count);else if(G.isInstancedBufferGeometry){let jt=G._maxInstanceCount!==void 0?G._maxInstanceCount:1/0,Me=Math.min(G.instanceCount,jt);dt.renderInstances(Se,Ct,Me)}else dt.render(Se,Ct)};function Jd(E,L,G,U){k!==null&&E.isNodeMaterial&&k.setObject(U,E),Pt===!0&&Y.setState(E,G,!1),E.transparent===!0&&E.side===qt&&E.forceSinglePass===!1?(E.side=dn,E.needsUpdate=!0,Lr(E,L,U),E.side=Ji,E.needsUpdate=!0,Lr(E,L,U),E.side=qt):Lr(E,L,U)}this.compile=function(E,L,G=null){G===null&&(G=E),k!==null&&k.renderStart(E,L,G),b=$.get(G),b.init(L),T.push(b),G.traverseVisible(function(B){B.isLight&&B.layers.test(L.layers)&&(b.pushLight(B),B.castShadow&&b.pushShadow(B))}),E!==G&&E.traverseVisible(function(B){B.isLight&&B.layers.test(L.layers)&&(b.pushLight(B),B.castShadow&&b.pushShadow(B))}),b.setupLights(),k!==null&&k.updateLights(b.state.lightsArray),gn=this.localClippingEnabled,Pt=Y.init(this.clippingPlanes,gn),Pt===!0&&Y.setGlobalState(this.clippingPlanes,L),k!==null&&ce.render(b.state.shadowsArray,G,L);let U=new Set;return E.traverse(function(B){if(!(B.isMesh||B.isPoints||B.isLine||B.isSprite))return;let fe=B.material;if(fe)if(Array.isArray(fe))for(let ve=0;ve<fe.length;ve++){let ue=fe[ve];Jd(ue,G,L,B),U.add(ue)}else Jd(fe,G,L,B),U.add(fe)}),b=T.pop(),k!==null&&k.renderEnd(),U},this.compileAsync=function(E,L,G=null){let U=this.compile(E,L,G);return new Promise(B=>{function fe(){if(U.forEach(function(ve){let xe=Ie.get(ve).currentProgram;(xe===void 0||xe.isReady())&&U.delete(ve)}),U.size===0){B(E);return}setTimeout(fe,10)}yt.get("KHR_parallel_shader_compile")!==null?fe():setTimeout(fe,10)})};let uh=null;function L_(E){uh&&uh(E)}function Zd(){ss.stop()}function Kd(){ss.start()}let ss=new em;ss.setAnimationLoop(L_),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(E){uh=E,se.setAnimationLoop(E),E===null?ss.stop():ss.start()},se.addEventListener("sessionstart",Zd),se.addEventListener("sessionend",Kd),this.render=function(E,L){if(L!==void 0&&L.isCamera!==!0){De("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;k!==null&&k.renderStart(E,L);let G=se.enabled===!0&&se.isPresenting===!0,U=O!==null&&(ie===null||G)&&O.begin(P,ie);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),se.enabled===!0&&se.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(se.cameraAutoUpdate===!0&&se.updateCamera(L),L=se.getCamera()),E.isScene===!0&&E.onBeforeRender(P,E,L,ie),b=$.get(E,T.length),b.init(L),b.state.textureUnits=Fe.getTextureUnits(),T.push(b),bt.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?Gt.setFromArrayCamera(L):Je.setFromProjectionMatrix(bt,Nn,L.reversedDepth),gn=this.localClippingEnabled,Pt=Y.init(this.clippingPlanes,gn),v=de.get(E,_.length),v.init(),_.push(v),this.info.render.frame++,se.enabled===!0&&se.isPresenting===!0){let ve=P.xr.getDepthSensingMesh();ve!==null&&dh(ve,L,-1/0,P.sortObjects)}dh(E,L,0,P.sortObjects),v.finish(),k!==null&&k.updateLights(b.state.lightsArray),P.sortObjects===!0&&v.sort(Ve,At),Pn=se.enabled===!1||se.isPresenting===!1||se.hasDepthSensing()===!1,Pn&&R.addToRenderList(v,E),this.info.autoReset===!0&&this.info.reset(),Pt===!0&&Y.beginShadows();let B=b.state.shadowsArray;if(ce.render(B,E,L),Pt===!0&&Y.endShadows(),(U&&O.hasRenderPass())===!1){let ve=v.opaque,ue=v.transmissive;if(b.setupLights(),L.isArrayCamera){let xe=L.cameras;if(ue.length>0)for(let Te=0,ke=xe.length;Te<ke;Te++){let Ze=xe[Te];Qd(ve,ue,E,Ze)}Pn&&R.render(E);for(let Te=0,ke=xe.length;Te<ke;Te++){let Ze=xe[Te];jd(v,E,Ze,Ze.viewport)}}else ue.length>0&&Qd(ve,ue,E,L),Pn&&R.render(E),jd(v,E,L)}ie!==null&&z===0&&(Fe.updateMultisampleRenderTarget(ie),Fe.updateRenderTargetMipmap(ie)),U&&O.end(P),E.isScene===!0&&E.onAfterRender(P,E,L),le.resetDefaultState(),q=-1,Q=null,T.pop(),T.length>0?(b=T[T.length-1],Fe.setTextureUnits(b.state.textureUnits),Pt===!0&&Y.setGlobalState(P.clippingPlanes,b.state.camera)):b=null,_.pop(),_.length>0?v=_[_.length-1]:v=null,k!==null&&k.renderEnd()};function dh(E,L,G,U){if(E.visible===!1)return;if(E.layers.test(L.layers)){if(E.isGroup)G=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(L);else if(E.isLight)b.pushLight(E),E.castShadow&&b.pushShadow(E);else if(E.isSprite){let ve=L.isArrayCamera?Gt:Je;if(!E.frustumCulled||E.intersectsFrustum(ve)){U&&Ut.setFromMatrixPosition(E.matrixWorld).applyMatrix4(bt);let ue=ne.update(E),xe=E.material;xe.visible&&v.push(E,ue,xe,G,Ut.z,null,L)}}else if(E.isMesh||E.isLine||E.isPoints){let ve=L.isArrayCamera?Gt:Je;if(!E.frustumCulled||E.intersectsFrustum(ve)){let ue=ne.update(E),xe=E.material;if(U&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ut.copy(E.boundingSphere.center)):(ue.boundingSphere===null&&ue.computeBoundingSphere(),Ut.copy(ue.boundingSphere.center)),Ut.applyMatrix4(E.matrixWorld).applyMatrix4(bt)),Array.isArray(xe)){let Te=ue.groups;for(let ke=0,Ze=Te.length;ke<Ze;ke++){let Se=Te[ke],Ke=xe[Se.materialIndex];Ke&&Ke.visible&&v.push(E,ue,Ke,G,Ut.z,Se,L)}}else xe.visible&&v.push(E,ue,xe,G,Ut.z,null,L)}}}let fe=E.children;for(let ve=0,ue=fe.length;ve<ue;ve++)dh(fe[ve],L,G,U)}function jd(E,L,G,U){let{opaque:B,transmissive:fe,transparent:ve}=E;b.setupLightsView(G),Pt===!0&&Y.setGlobalState(P.clippingPlanes,G),U&&me.viewport(te.copy(U)),B.length>0&&ta(B,L,G),fe.length>0&&ta(fe,L,G),ve.length>0&&ta(ve,L,G),me.buffers.depth.setTest(!0),me.buffers.depth.setMask(!0),me.buffers.color.setMask(!0),me.setPolygonOffset(!1)}function Qd(E,L,G,U){if((G.isScene===!0?G.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[U.id]===void 0){let Se=yt.has("EXT_color_buffer_half_float")||yt.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[U.id]=new sn(1,1,{generateMipmaps:!0,type:Se?Yn:xn,minFilter:Ai,samples:Math.max(4,xt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Qe.workingColorSpace})}let fe=b.state.transmissionRenderTarget[U.id],ve=U.viewport||te;fe.setSize(ve.z*P.transmissionResolutionScale,ve.w*P.transmissionResolutionScale);let ue=P.getRenderTarget(),xe=P.getActiveCubeFace(),Te=P.getActiveMipmapLevel();P.setRenderTarget(fe),P.getClearColor(J),_e=P.getClearAlpha(),_e<1&&P.setClearColor(16777215,.5),P.clear(),Pn&&R.render(G);let ke=P.toneMapping;P.toneMapping=ai;let Ze=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),b.setupLightsView(U),Pt===!0&&Y.setGlobalState(P.clippingPlanes,U),ta(E,G,U),Fe.updateMultisampleRenderTarget(fe),Fe.updateRenderTargetMipmap(fe),yt.has("WEBGL_multisampled_render_to_texture")===!1){let Se=!1;for(let Ke=0,Ct=L.length;Ke<Ct;Ke++){let pt=L[Ke],{object:dt,geometry:jt,material:Me,group:an}=pt;if(Me.side===qt&&dt.layers.test(U.layers)){let rt=Me.side;Me.side=dn,Me.needsUpdate=!0,ef(dt,G,U,jt,Me,an),Me.side=rt,Me.needsUpdate=!0,Se=!0}}Se===!0&&(Fe.updateMultisampleRenderTarget(fe),Fe.updateRenderTargetMipmap(fe))}P.setRenderTarget(ue,xe,Te),P.setClearColor(J,_e),Ze!==void 0&&(U.viewport=Ze),P.toneMapping=ke}function ta(E,L,G){let U=L.isScene===!0?L.overrideMaterial:null;for(let B=0,fe=E.length;B<fe;B++){let ve=E[B],{object:ue,geometry:xe,group:Te}=ve,ke=ve.material;ke.allowOverride===!0&&U!==null&&(ke=U),ue.layers.test(G.layers)&&ef(ue,L,G,xe,ke,Te)}}function ef(E,L,G,U,B,fe){k!==null&&B.isNodeMaterial&&k.setObject(E,B),E.onBeforeRender(P,L,G,U,B,fe),E.modelViewMatrix.multiplyMatrices(G.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),B.onBeforeRender(P,L,G,U,E,fe),B.transparent===!0&&B.side===qt&&B.forceSinglePass===!1?(B.side=dn,B.needsUpdate=!0,P.renderBufferDirect(G,L,U,B,E,fe),B.side=Ji,B.needsUpdate=!0,P.renderBufferDirect(G,L,U,B,E,fe),B.side=qt):P.renderBufferDirect(G,L,U,B,E,fe),E.onAfterRender(P,L,G,U,B,fe)}function tf(E){let L=0;for(let G of E)G.texture!==null&&L++;return L}function Lr(E,L,G){L.isScene!==!0&&(L=Rn);let U=Ie.get(E),B=b.state.lights,fe=b.state.shadowsArray,ve=B.state.version,ue=K.getParameters(E,B.state,fe,L,G,b.state.lightProbeGridArray),xe=K.getProgramCacheKey(ue),Te=U.programs;U.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?L.environment:null,U.fog=L.fog;let ke=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;U.envMap=A.get(E.envMap||U.environment,ke),U.envMapRotation=U.environment!==null&&E.envMap===null?L.environmentRotation:E.envMapRotation,Te===void 0&&(E.addEventListener("dispose",ht),Te=new Map,U.programs=Te,U.programVariants=new Map);let Ze=Te.get(xe);if(Ze!==void 0){if(U.currentProgram===Ze&&U.lightsStateVersion===ve)return sf(E,ue),Ze}else ue.uniforms=K.getUniforms(E),k!==null&&E.isNodeMaterial&&k.build(E,G,ue),E.onBeforeCompile(ue,P),Ze=K.acquireProgram(ue,xe),Te.set(xe,Ze),U.uniforms=ue.uniforms;let Se=U.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Se.clippingPlanes=Y.uniform),sf(E,ue),U.needsLights=U_(E),U.lightsStateVersion=ve,U.needsLights&&(Se.ambientLightColor.value=B.state.ambient,Se.lightProbe.value=B.state.probe,Se.sunLights.value=B.state.sun,Se.sunLightShadows.value=B.state.sunShadow,Se.directionalLights.value=B.state.directional,Se.directionalLightShadows.value=B.state.directionalShadow,Se.spotLights.value=B.state.spot,Se.spotLightShadows.value=B.state.spotShadow,Se.rectAreaLights.value=B.state.rectArea,Se.ltc_1.value=B.state.rectAreaLTC1,Se.ltc_2.value=B.state.rectAreaLTC2,Se.pointLights.value=B.state.point,Se.pointLightShadows.value=B.state.pointShadow,Se.hemisphereLights.value=B.state.hemi,Se.sunShadowMatrix.value=B.state.sunShadowMatrix,Se.sunShadowCascade.value=B.state.sunShadowCascade,Se.directionalShadowMatrix.value=B.state.directionalShadowMatrix,Se.spotLightMatrix.value=B.state.spotLightMatrix,Se.spotLightMap.value=B.state.spotLightMap,Se.pointShadowMatrix.value=B.state.pointShadowMatrix),U.numLightProbeGrids=tf(b.state.lightProbeGridArray),U.currentProgram=Ze,U.uniformsList=null,Ze}function O_(E,L,G,U,B){let fe=Ie.get(E),ve=fe.currentProgram.id+","+U+","+B,ue=fe.programVariants.get(ve);return ue===void 0?(ue=Lr(E,L,G),fe.programVariants.set(ve,ue)):(fe.currentProgram=ue,fe.uniformsList=null,fe.outputColorSpace=U,fe.toneMapping=B),ue}function nf(E){if(E.uniformsList===null){let L=E.currentProgram.getUniforms();E.uniformsList=dr.seqWithValue(L.seq,E.uniforms)}return E.uniformsList}function sf(E,L){let G=Ie.get(E);G.outputColorSpace=L.outputColorSpace,G.batching=L.batching,G.batchingColor=L.batchingColor,G.instancing=L.instancing,G.instancingColor=L.instancingColor,G.instancingMorph=L.instancingMorph,G.skinning=L.skinning,G.morphTargets=L.morphTargets,G.morphNormals=L.morphNormals,G.morphColors=L.morphColors,G.morphTargetsCount=L.morphTargetsCount,G.numClippingPlanes=L.numClippingPlanes,G.numIntersection=L.numClipIntersection,G.vertexAlphas=L.vertexAlphas,G.vertexTangents=L.vertexTangents,G.toneMapping=L.toneMapping}function D_(E,L,G,U,B){L.isScene!==!0&&(L=Rn),Fe.resetTextureUnits();let fe=L.fog,ve=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?L.environment:null,ue=ie===null?P.outputColorSpace:ie.isXRRenderTarget===!0?ie.texture.colorSpace:Qe.workingColorSpace,xe=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,Te=A.get(U.envMap||ve,xe),ke=U.vertexColors===!0&&!!G.attributes.color&&G.attributes.color.itemSize===4,Ze=!!G.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),Se=!!G.morphAttributes.position,Ke=!!G.morphAttributes.normal,Ct=!!G.morphAttributes.color,pt=ai;U.toneMapped&&(ie===null||ie.isXRRenderTarget===!0)&&(pt=P.toneMapping);let dt=G.morphAttributes.position||G.morphAttributes.normal||G.morphAttributes.color,jt=dt!==void 0?dt.length:0,Me=Ie.get(U),an=b.state.lights;if(Pt===!0&&(gn===!0||E!==Q)){let St=E===Q&&U.id===q;Y.setState(U,E,St)}let rt=!1,rs=!1;U.version===Me.__version?Me.needsLights&&Me.lightsStateVersion!==an.state.version||B.isBatchedMesh&&Me.batching===!1||!B.isBatchedMesh&&Me.batching===!0||B.isBatchedMesh&&Me.batchingColor===!0&&B._colorsTexture===null||B.isBatchedMesh&&Me.batchingColor===!1&&B._colorsTexture!==null||B.isInstancedMesh&&Me.instancing===!1||!B.isInstancedMesh&&Me.instancing===!0||B.isSkinnedMesh&&Me.skinning===!1||!B.isSkinnedMesh&&Me.skinning===!0||B.isInstancedMesh&&Me.instancingColor===!0&&B.instanceColor===null||B.isInstancedMesh&&Me.instancingColor===!1&&B.instanceColor!==null||B.isInstancedMesh&&Me.instancingMorph===!0&&B.morphTexture===null||B.isInstancedMesh&&Me.instancingMorph===!1&&B.morphTexture!==null||Me.envMap!==Te||U.fog===!0&&Me.fog!==fe||Me.numClippingPlanes!==void 0&&(Me.numClippingPlanes!==Y.numPlanes||Me.numIntersection!==Y.numIntersection)||Me.vertexAlphas!==ke||Me.vertexTangents!==Ze||Me.morphTargets!==Se||Me.morphNormals!==Ke||Me.morphColors!==Ct||Me.morphTargetsCount!==jt||Me.numLightProbeGrids!==tf(b.state.lightProbeGridArray)?rt=!0:(Me.outputColorSpace!==ue||Me.toneMapping!==pt)&&(rs=!0):(rt=!0,Me.__version=U.version);let Qt=Me.currentProgram;(rt===!0||rs===!0)&&(Qt=rs===!0?O_(U,L,B,ue,pt):Lr(U,L,B),k&&U.isNodeMaterial&&k.onUpdateProgram(U,Qt,Me));let na=!1,Ni=!1,os=!1,nt=Qt.getUniforms(),Wt=Me.uniforms;if(me.useProgram(Qt.program)&&(na=!0,Ni=!0,os=!0),U.id!==q&&(q=U.id,Ni=!0),na||Q!==E){me.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),nt.setValue(N,"projectionMatrix",E.projectionMatrix),nt.setValue(N,"viewMatrix",E.matrixWorldInverse);let Bt=nt.map.cameraPosition;Bt!==void 0&&Bt.setValue(N,ei.setFromMatrixPosition(E.matrixWorld)),xt.logarithmicDepthBuffer&&nt.setValue(N,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&nt.setValue(N,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Ni=!0,os=!0)}if(Me.needsLights&&(an.state.sunShadowMap.length>0&&nt.setValue(N,"sunShadowMap",an.state.sunShadowMap,Fe),an.state.directionalShadowMap.length>0&&nt.setValue(N,"directionalShadowMap",an.state.directionalShadowMap,Fe),an.state.spotShadowMap.length>0&&nt.setValue(N,"spotShadowMap",an.state.spotShadowMap,Fe),an.state.pointShadowMap.length>0&&nt.setValue(N,"pointShadowMap",an.state.pointShadowMap,Fe)),B.isSkinnedMesh){nt.setOptional(N,B,"bindMatrix"),nt.setOptional(N,B,"bindMatrixInverse");let St=B.skeleton;St&&(St.boneTexture===null&&St.computeBoneTexture(),nt.setValue(N,"boneTexture",St.boneTexture,Fe))}B.isBatchedMesh&&(nt.setOptional(N,B,"batchingTexture"),nt.setValue(N,"batchingTexture",B._matricesTexture,Fe),nt.setOptional(N,B,"batchingIdTexture"),nt.setValue(N,"batchingIdTexture",B._indirectTexture,Fe),nt.setOptional(N,B,"batchingColorTexture"),B._colorsTexture!==null&&nt.setValue(N,"batchingColorTexture",B._colorsTexture,Fe));let kn=G.morphAttributes;if((kn.position!==void 0||kn.normal!==void 0||kn.color!==void 0)&&Z.update(B,G,Qt),(Ni||Me.receiveShadow!==B.receiveShadow)&&(Me.receiveShadow=B.receiveShadow,nt.setValue(N,"receiveShadow",B.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&L.environment!==null&&(Wt.envMapIntensity.value=L.environmentIntensity),Wt.dfgLUT!==void 0&&(Wt.dfgLUT.value=RS()),Ni){if(nt.setValue(N,"toneMappingExposure",P.toneMappingExposure),Me.needsLights&&N_(Wt,os),fe&&U.fog===!0&&ae.refreshFogUniforms(Wt,fe),ae.refreshMaterialUniforms(Wt,U,ye,Pe,b.state.transmissionRenderTarget[E.id]),Me.needsLights&&Me.numLightProbeGrids>0){let St=M,Bt=0;for(let yi of b.state.lightProbeGridArray)yi.texture!==null&&(St.textures[Bt]=yi.texture,St.min[Bt]=yi.boundingBox.min,St.max[Bt]=yi.boundingBox.max,St.resolution[Bt]=yi.resolution,Bt++);for(let yi in St)St[yi].length=Bt;Wt.probesSH.value=St.textures,Wt.probesMin.value=St.min,Wt.probesMax.value=St.max,Wt.probesResolution.value=St.resolution}dr.upload(N,nf(Me),Wt,Fe)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(dr.upload(N,nf(Me),Wt,Fe),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&nt.setValue(N,"center",B.center),nt.setValue(N,"modelViewMatrix",B.modelViewMatrix),nt.setValue(N,"normalMatrix",B.normalMatrix),nt.setValue(N,"modelMatrix",B.matrixWorld),U.uniformsGroups!==void 0){let St=U.uniformsGroups;for(let Bt=0,yi=St.length;Bt<yi;Bt++){let of=St[Bt];Ae.update(of,Qt),Ae.bind(of,Qt)}}return Qt}function N_(E,L){E.ambientLightColor.needsUpdate=L,E.lightProbe.needsUpdate=L,E.sunLights.needsUpdate=L,E.sunLightShadows.needsUpdate=L,E.directionalLights.needsUpdate=L,E.directionalLightShadows.needsUpdate=L,E.pointLights.needsUpdate=L,E.pointLightShadows.needsUpdate=L,E.spotLights.needsUpdate=L,E.spotLightShadows.needsUpdate=L,E.rectAreaLights.needsUpdate=L,E.hemisphereLights.needsUpdate=L}function U_(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return j},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ie},this.setRenderTargetTextures=function(E,L,G){let U=Ie.get(E);U.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Ie.get(E.texture).__webglTexture=L,Ie.get(E.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:G,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,L){let G=Ie.get(E);G.__webglFramebuffer=L,G.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(E,L=0,G=0){ie=E,j=L,z=G;let U=null,B=!1,fe=!1;if(E){let ue=Ie.get(E);if(ue.__useDefaultFramebuffer!==void 0){me.bindFramebuffer(N.FRAMEBUFFER,ue.__webglFramebuffer),te.copy(E.viewport),Ee.copy(E.scissor),Be=E.scissorTest,me.viewport(te),me.scissor(Ee),me.setScissorTest(Be),q=-1;return}else if(ue.__webglFramebuffer===void 0)Fe.setupRenderTarget(E);else if(ue.__hasExternalTextures)Fe.rebindTextures(E,Ie.get(E.texture).__webglTexture,Ie.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let ke=E.depthTexture;if(ue.__boundDepthTexture!==ke){if(ke!==null&&Ie.has(ke)&&(E.width!==ke.image.width||E.height!==ke.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Fe.setupDepthRenderbuffer(E)}}let xe=E.texture;(xe.isData3DTexture||xe.isDataArrayTexture||xe.isCompressedArrayTexture)&&(fe=!0);let Te=Ie.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Te[L])?U=Te[L][G]:U=Te[L],B=!0):E.samples>0&&Fe.useMultisampledRTT(E)===!1?U=Ie.get(E).__webglMultisampledFramebuffer:Array.isArray(Te)?U=Te[G]:U=Te,te.copy(E.viewport),Ee.copy(E.scissor),Be=E.scissorTest}else te.copy(Le).multiplyScalar(ye).floor(),Ee.copy(ct).multiplyScalar(ye).floor(),Be=ut;if(G!==0&&(U=W),me.bindFramebuffer(N.FRAMEBUFFER,U)&&me.drawBuffers(E,U),me.viewport(te),me.scissor(Ee),me.setScissorTest(Be),B){let ue=Ie.get(E.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_CUBE_MAP_POSITIVE_X+L,ue.__webglTexture,G)}else if(fe){let ue=L;for(let xe=0;xe<E.textures.length;xe++){let Te=Ie.get(E.textures[xe]);N.framebufferTextureLayer(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0+xe,Te.__webglTexture,G,ue)}}else if(E!==null&&G!==0){let ue=Ie.get(E.texture);N.framebufferTexture2D(N.FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,ue.__webglTexture,G)}q=-1};function rf(E){let L=Ie.get(E);return(L.__readFormat!==E.format||L.__readType!==E.type)&&(L.__readFormat=E.format,L.__readType=E.type,L.__formatReadable=xt.textureFormatReadable(E.format),L.__typeReadable=xt.textureTypeReadable(E.type)),L}this.readRenderTargetPixels=function(E,L,G,U,B,fe,ve,ue=0){if(!(E&&E.isWebGLRenderTarget)){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xe=Ie.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&ve!==void 0&&(xe=xe[ve],Array.isArray(xe)&&(xe=xe[0])),xe){me.bindFramebuffer(N.FRAMEBUFFER,xe);try{let Te=E.textures[ue],ke=Te.format,Ze=Te.type;E.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+ue);let Se=rf(Te);if(Se.__formatReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Se.__typeReadable===!1){De("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=E.width-U&&G>=0&&G<=E.height-B&&N.readPixels(L,G,U,B,re.convert(ke),re.convert(Ze),fe)}finally{let Te=ie!==null?Ie.get(ie).__webglFramebuffer:null;me.bindFramebuffer(N.FRAMEBUFFER,Te)}}},this.readRenderTargetPixelsAsync=async function(E,L,G,U,B,fe,ve,ue=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xe=Ie.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&ve!==void 0&&(xe=xe[ve],Array.isArray(xe)&&(xe=xe[0])),xe)if(L>=0&&L<=E.width-U&&G>=0&&G<=E.height-B){me.bindFramebuffer(N.FRAMEBUFFER,xe);let Te=E.textures[ue],ke=Te.format,Ze=Te.type;E.textures.length>1&&N.readBuffer(N.COLOR_ATTACHMENT0+ue);let Se=rf(Te);if(Se.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Se.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Ke=N.createBuffer();N.bindBuffer(N.PIXEL_PACK_BUFFER,Ke),N.bufferData(N.PIXEL_PACK_BUFFER,fe.byteLength,N.STREAM_READ),N.readPixels(L,G,U,B,re.convert(ke),re.convert(Ze),0),N.bindBuffer(N.PIXEL_PACK_BUFFER,null);let Ct=ie!==null?Ie.get(ie).__webglFramebuffer:null;me.bindFramebuffer(N.FRAMEBUFFER,Ct);let pt=N.fenceSync(N.SYNC_GPU_COMMANDS_COMPLETE,0);return N.flush(),await Cp(N,pt,4),N.bindBuffer(N.PIXEL_PACK_BUFFER,Ke),N.getBufferSubData(N.PIXEL_PACK_BUFFER,0,fe),N.bindBuffer(N.PIXEL_PACK_BUFFER,null),N.deleteBuffer(Ke),N.deleteSync(pt),fe}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,L=null,G=0){let U=Math.pow(2,-G),B=Math.floor(E.image.width*U),fe=Math.floor(E.image.height*U),ve=L!==null?L.x:0,ue=L!==null?L.y:0;Fe.setTexture2D(E,0),N.copyTexSubImage2D(N.TEXTURE_2D,G,0,0,ve,ue,B,fe),me.unbindTexture()},this.copyTextureToTexture=function(E,L,G=null,U=null,B=0,fe=0){let ve,ue,xe,Te,ke,Ze,Se,Ke,Ct,pt=E.isCompressedTexture?E.mipmaps[fe]:E.image;if(G!==null)ve=G.max.x-G.min.x,ue=G.max.y-G.min.y,xe=G.isBox3?G.max.z-G.min.z:1,Te=G.min.x,ke=G.min.y,Ze=G.isBox3?G.min.z:0;else{let nt=Math.pow(2,-B);ve=Math.floor(pt.width*nt),ue=Math.floor(pt.height*nt),E.isDataArrayTexture?xe=pt.depth:E.isData3DTexture?xe=Math.floor(pt.depth*nt):xe=1,Te=0,ke=0,Ze=0}U!==null?(Se=U.x,Ke=U.y,Ct=U.z):(Se=0,Ke=0,Ct=0);let dt=re.convert(L.format),jt=re.convert(L.type),Me;L.isData3DTexture?(Fe.setTexture3D(L,0),Me=N.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(Fe.setTexture2DArray(L,0),Me=N.TEXTURE_2D_ARRAY):(Fe.setTexture2D(L,0),Me=N.TEXTURE_2D),me.activeTexture(N.TEXTURE0),me.pixelStorei(N.UNPACK_FLIP_Y_WEBGL,L.flipY),me.pixelStorei(N.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),me.pixelStorei(N.UNPACK_ALIGNMENT,L.unpackAlignment);let an=me.getParameter(N.UNPACK_ROW_LENGTH),rt=me.getParameter(N.UNPACK_IMAGE_HEIGHT),rs=me.getParameter(N.UNPACK_SKIP_PIXELS),Qt=me.getParameter(N.UNPACK_SKIP_ROWS),na=me.getParameter(N.UNPACK_SKIP_IMAGES);me.pixelStorei(N.UNPACK_ROW_LENGTH,pt.width),me.pixelStorei(N.UNPACK_IMAGE_HEIGHT,pt.height),me.pixelStorei(N.UNPACK_SKIP_PIXELS,Te),me.pixelStorei(N.UNPACK_SKIP_ROWS,ke),me.pixelStorei(N.UNPACK_SKIP_IMAGES,Ze);let Ni=E.isDataArrayTexture||E.isData3DTexture,os=L.isDataArrayTexture||L.isData3DTexture;if(E.isDepthTexture){let nt=Ie.get(E),Wt=Ie.get(L),kn=Ie.get(nt.__renderTarget),St=Ie.get(Wt.__renderTarget);me.bindFramebuffer(N.READ_FRAMEBUFFER,kn.__webglFramebuffer),me.bindFramebuffer(N.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Bt=0;Bt<xe;Bt++)Ni&&(N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ie.get(E).__webglTexture,B,Ze+Bt),N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Ie.get(L).__webglTexture,fe,Ct+Bt)),N.blitFramebuffer(Te,ke,Te+ve,ke+ue,Se,Ke,Se+ve,Ke+ue,N.DEPTH_BUFFER_BIT,N.NEAREST);me.bindFramebuffer(N.READ_FRAMEBUFFER,null),me.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else if(B!==0||E.isRenderTargetTexture||Ie.has(E)){let nt=Ie.get(E),Wt=Ie.get(L);me.bindFramebuffer(N.READ_FRAMEBUFFER,I),me.bindFramebuffer(N.DRAW_FRAMEBUFFER,V);for(let kn=0;kn<xe;kn++)Ni?N.framebufferTextureLayer(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,nt.__webglTexture,B,Ze+kn):N.framebufferTexture2D(N.READ_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,nt.__webglTexture,B),os?N.framebufferTextureLayer(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,Wt.__webglTexture,fe,Ct+kn):N.framebufferTexture2D(N.DRAW_FRAMEBUFFER,N.COLOR_ATTACHMENT0,N.TEXTURE_2D,Wt.__webglTexture,fe),B!==0?N.blitFramebuffer(Te,ke,Te+ve,ke+ue,Se,Ke,Se+ve,Ke+ue,N.COLOR_BUFFER_BIT,N.NEAREST):os?N.copyTexSubImage3D(Me,fe,Se,Ke,Ct+kn,Te,ke,ve,ue):N.copyTexSubImage2D(Me,fe,Se,Ke,Te,ke,ve,ue);me.bindFramebuffer(N.READ_FRAMEBUFFER,null),me.bindFramebuffer(N.DRAW_FRAMEBUFFER,null)}else os?E.isDataTexture||E.isData3DTexture?N.texSubImage3D(Me,fe,Se,Ke,Ct,ve,ue,xe,dt,jt,pt.data):L.isCompressedArrayTexture?N.compressedTexSubImage3D(Me,fe,Se,Ke,Ct,ve,ue,xe,dt,pt.data):N.texSubImage3D(Me,fe,Se,Ke,Ct,ve,ue,xe,dt,jt,pt):E.isDataTexture?N.texSubImage2D(N.TEXTURE_2D,fe,Se,Ke,ve,ue,dt,jt,pt.data):E.isCompressedTexture?N.compressedTexSubImage2D(N.TEXTURE_2D,fe,Se,Ke,pt.width,pt.height,dt,pt.data):N.texSubImage2D(N.TEXTURE_2D,fe,Se,Ke,ve,ue,dt,jt,pt);me.pixelStorei(N.UNPACK_ROW_LENGTH,an),me.pixelStorei(N.UNPACK_IMAGE_HEIGHT,rt),me.pixelStorei(N.UNPACK_SKIP_PIXELS,rs),me.pixelStorei(N.UNPACK_SKIP_ROWS,Qt),me.pixelStorei(N.UNPACK_SKIP_IMAGES,na),fe===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&N.generateMipmap(Me),me.unbindTexture()},this.initRenderTarget=function(E){Ie.get(E).__webglFramebuffer===void 0&&Fe.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Fe.setTextureCube(E,0):E.isData3DTexture?Fe.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Fe.setTexture2DArray(E,0):Fe.setTexture2D(E,0),me.unbindTexture()},this.resetState=function(){j=0,z=0,ie=null,me.reset(),le.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Nn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Qe._getDrawingBufferColorSpace(e),t.unpackColorSpace=Qe._getUnpackColorSpace()}};pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new He},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};fn.line={uniforms:wo.merge([pe.common,pe.fog,pe.line]),vertexShader:`
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
		`};var vs=class extends Ot{constructor(e){super({type:"LineMaterial",uniforms:wo.clone(fn.line.uniforms),vertexShader:fn.line.vertexShader,fragmentShader:fn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var um=new rn,lc=new C,bs=class extends ho{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new Vt(e,3)),this.setAttribute("uv",new Vt(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,n=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),n.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new $i(t,6,1);return this.setAttribute("instanceStart",new Wn(n,3,0)),this.setAttribute("instanceEnd",new Wn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let n=new $i(t,6,1);return this.setAttribute("instanceColorStart",new Wn(n,3,0)),this.setAttribute("instanceColorEnd",new Wn(n,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new no(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new rn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),um.setFromBufferAttribute(t),this.boundingBox.union(um))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new un),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)lc.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(lc)),lc.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(lc));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Fu=new it,dm=new C,fm=new C,$t=new it,Yt=new it,ci=new it,Bu=new C,ku=new ot,Jt=new fo,pm=new C,cc=new rn,hc=new un,hi=new it,ui,Ss;function mm(i,e,t){return hi.set(0,0,-e,1).applyMatrix4(i.projectionMatrix),hi.multiplyScalar(1/hi.w),hi.x=Ss/t.width,hi.y=Ss/t.height,hi.applyMatrix4(i.projectionMatrixInverse),hi.multiplyScalar(1/hi.w),Math.abs(Math.max(hi.x,hi.y))}function PS(i,e){let t=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Jt.start.fromBufferAttribute(s,a),Jt.end.fromBufferAttribute(r,a),Jt.applyMatrix4(t);let c=new C,h=new C;ui.distanceSqToSegment(Jt.start,Jt.end,h,c),h.distanceTo(c)<Ss*.5&&e.push({point:h,pointOnLine:c,distance:ui.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function IS(i,e,t){let n=e.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-e.near;ui.at(1,ci),ci.w=1,ci.applyMatrix4(e.matrixWorldInverse),ci.applyMatrix4(n),ci.multiplyScalar(1/ci.w),ci.x*=r.x/2,ci.y*=r.y/2,ci.z=0,Bu.copy(ci),ku.multiplyMatrices(e.matrixWorldInverse,o);for(let d=0,m=h;d<m;d++){if($t.fromBufferAttribute(l,d),Yt.fromBufferAttribute(c,d),$t.w=1,Yt.w=1,$t.applyMatrix4(ku),Yt.applyMatrix4(ku),$t.z>u&&Yt.z>u)continue;if($t.z>u){let w=$t.z-Yt.z,M=($t.z-u)/w;$t.lerp(Yt,M)}else if(Yt.z>u){let w=Yt.z-$t.z,M=(Yt.z-u)/w;Yt.lerp($t,M)}$t.applyMatrix4(n),Yt.applyMatrix4(n),$t.multiplyScalar(1/$t.w),Yt.multiplyScalar(1/Yt.w),$t.x*=r.x/2,$t.y*=r.y/2,Yt.x*=r.x/2,Yt.y*=r.y/2,Jt.start.copy($t),Jt.start.z=0,Jt.end.copy(Yt),Jt.end.z=0;let y=Jt.closestPointToPointParameter(Bu,!0);Jt.at(y,pm);let p=Su.lerp($t.z,Yt.z,y),f=p>=-1&&p<=1,x=Bu.distanceTo(pm)<Ss*.5;if(f&&x){Jt.start.fromBufferAttribute(l,d),Jt.end.fromBufferAttribute(c,d),Jt.start.applyMatrix4(o),Jt.end.applyMatrix4(o);let w=new C,M=new C;ui.distanceSqToSegment(Jt.start,Jt.end,M,w),t.push({point:M,pointOnLine:w,distance:ui.origin.distanceTo(M),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var Ro=class extends Lt{constructor(e=new bs,t=new vs({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,n=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)dm.fromBufferAttribute(t,o),fm.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+dm.distanceTo(fm);let r=new $i(s,2,1);return e.setAttribute("instanceDistanceStart",new Wn(r,1,0)),e.setAttribute("instanceDistanceEnd",new Wn(r,1,1)),this}raycast(e,t){let n=this.material.worldUnits,s=e.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;ui=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Ss=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),hc.copy(a.boundingSphere).applyMatrix4(o);let c;if(n)c=Ss*.5;else{let u=Math.max(s.near,hc.distanceToPoint(ui.origin));c=mm(s,u,l.resolution)}if(hc.radius+=c,ui.intersectsSphere(hc)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),cc.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=Ss*.5;else{let u=Math.max(s.near,cc.distanceToPoint(ui.origin));h=mm(s,u,l.resolution)}cc.expandByScalar(h),ui.intersectsBox(cc)!==!1&&(n?PS(this,t):IS(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Fu),this.material.uniforms.resolution.value.set(Fu.z,Fu.w))}};var gm=["#440154","#482878","#3e4a89","#31688e","#26828e","#1f9e89","#35b779","#6dcd59","#b4de2c","#fde725"],LS=["#0d3b76","#2a6da3","#78a9c8","#c5d9e2","#ece8e2","#eacdbc","#d69a7a","#b3563a","#7a2013"],OS=i=>i<=.04045?i/12.92:((i+.055)/1.055)**2.4,DS=i=>i<=.0031308?12.92*i:1.055*Math.max(i,0)**.4166666666666667-.055;function NS([i,e,t]){let n=Math.cbrt(.4122214708*i+.5363325363*e+.0514459929*t),s=Math.cbrt(.2119034982*i+.6806995451*e+.1073969566*t),r=Math.cbrt(.0883024619*i+.2817188376*e+.6299787005*t);return[.2104542553*n+.793617785*s-.0040720468*r,1.9779984951*n-2.428592205*s+.4505937099*r,.0259040371*n+.7827717662*s-.808675766*r]}function US([i,e,t]){let n=(i+.3963377774*e+.2158037573*t)**3,s=(i-.1055613458*e-.0638541728*t)**3,r=(i-.0894841775*e-1.291485548*t)**3;return[4.0767416621*n-3.3077115913*s+.2309699292*r,-1.2684380046*n+2.6097574011*s-.3413193965*r,-.0041960863*n-.7034186147*s+1.707614701*r]}var Vu=256;function zu(i){let e=i.map(t=>NS([1,3,5].map(n=>OS(parseInt(t.slice(n,n+2),16)/255))));return Array.from({length:Vu},(t,n)=>{let s=n/(Vu-1)*(i.length-1),r=Math.min(Math.floor(s),i.length-2),o=e[r].map((a,l)=>a+(s-r)*(e[r+1][l]-a));return US(o).map(a=>Math.min(1,Math.max(0,a)))})}var FS=gm.slice(0,8).reverse(),BS={sequential:zu(gm),lines:zu(FS),diverging:zu(LS)},uc=(i,e)=>BS[i][Math.round(Math.min(1,Math.max(0,e))*(Vu-1))],_m=(i,e)=>`rgb(${uc(i,e).map(t=>Math.round(255*DS(t))).join(" ")})`;var kS={5121:Uint8Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},zS={SCALAR:1,VEC2:2,VEC3:3,VEC4:4},VS=1179937895,HS=1313821514,ym=1,xm=2,yC=3;function vm(i){let e=new DataView(i);if(i.byteLength<20||e.getUint32(0,!0)!==VS||e.getUint32(16,!0)!==HS)throw new Error("it does not begin as a GLB file does.");let t=e.getUint32(12,!0),n=JSON.parse(new TextDecoder().decode(new Uint8Array(i,20,t)));return bm(n,[{bytes:i,start:20+t+8}])}function xC(i){let e=JSON.parse(i);return bm(e,(e.buffers??[]).map(({uri:t=""})=>{let[,n]=/^data:[^,]*;base64,(.*)$/s.exec(t)??[];if(n===void 0)throw new Error("its data lies in another file; save it as GLB or with embedded buffers.");return{bytes:Uint8Array.from(atob(n),s=>s.charCodeAt(0)).buffer,start:0}}))}function bm(i,e){return{document:i,read:n=>{let{bufferView:s,byteOffset:r=0,componentType:o,count:a,type:l,sparse:c}=i.accessors[n],h=zS[l],u=kS[o];if(h===void 0||!u||s===void 0||c)throw new Error("its data is stored in a way that is not known here.");let{buffer:d,byteOffset:m=0,byteStride:g}=i.bufferViews[s],{bytes:y,start:p}=e[d],f=p+m+r,x=g??h*u.BYTES_PER_ELEMENT;if(x===h*u.BYTES_PER_ELEMENT)return{array:new u(y,f,h*a),size:h};let w=new u(h*a);for(let M=0;M<a;M+=1)w.set(new u(y,f+M*x,h),M*h);return{array:w,size:h}}}}async function Hu(i){let{document:{nodes:e=[],meshes:t=[],asset:n},read:s}=vm(i),r=p=>s(p).array,[o,...a]=e.filter(({mesh:p})=>p!==void 0),l=({mesh:p})=>t[p].primitives,[c]=l(o),h=new Et,u=new Map;for(let[p,f]of Object.entries(c.attributes)){let{array:x,size:w}=s(f);p==="POSITION"||p==="NORMAL"?h.setAttribute(p.toLowerCase(),new mt(x,w)):p.startsWith("_")&&w===1&&u.set(p.slice(1).toLowerCase(),x)}h.setIndex(c.indices===void 0?[]:new mt(s(c.indices).array,1)),h.attributes.normal||h.setAttribute("normal",new mt(new Float32Array(3*h.attributes.position.count),3));let d=a.map(p=>{let f=l(p),x=WS(f.map(({attributes:{POSITION:v},indices:b,mode:_})=>GS(r(v),b===void 0?null:s(b).array,_))),w=[],[M]=f;if(M&&f.length===1&&M.indices===void 0)for(let[v,b]of Object.entries(M.attributes))v.startsWith("_")&&w.push({name:v.slice(1).toLowerCase(),unit:p.extras?.[v]?.unit??"",values:r(b)});return{name:p.name??"lines",segments:x,values:w}}),[m=0,g=0,y=0]=o.translation??[];return{geometry:h,attributes:u,lines:d,translation:[m,g,y],extras:n.extras??{}}}function Sm(i,e,t){let{metres:n,up:s}=new On([0,0,0],t),[r,o,a]=i,l=new Float32Array(i.length);for(let u=0;u<i.length;u+=3){let d=(i[u]-r)*n,m=(i[u+1]-o)*n,g=(i[u+2]-a)*n;l[u]=d,l[u+1]=s===2?g:m,l[u+2]=s===2?-m:g}let c=new On([0,0,0],t).toScene([r,o,a]),h=new Et().setIndex(new mt(e,1)).setAttribute("position",new mt(l,3));return h.computeVertexNormals(),{geometry:h,attributes:new Map,lines:[],translation:c,extras:{}}}var Pi=({geometry:i})=>i.index.count>0;function GS(i,e,t){let n=e??Uint32Array.from({length:i.length/3},(a,l)=>l),s=t===ym,r=s?n.length>>1:Math.max(n.length-(t===xm?0:1),0),o=new Float32Array(6*r);for(let a=0;a<r;a+=1)for(let l=0;l<2;l+=1){let c=3*n[((s?2:1)*a+l)%n.length];o.set(i.subarray(c,c+3),6*a+3*l)}return o}function WS(i){let e=new Float32Array(i.reduce((n,s)=>n+s.length,0)),t=0;for(let n of i)e.set(n,t),t+=n.length;return e}function dc(i){let e=i.index.array,t=i.attributes.position.count,n=new Map,s=[],r=[];for(let o=0;o<e.length;o+=3)for(let a=0;a<3;a+=1){let l=e[o+a],c=e[o+(a+1)%3],h=Math.min(l,c)*t+Math.max(l,c),u=n.get(h);u===void 0?(n.set(h,s.length/2),s.push(l,c),r.push(o/3,-1)):r[2*u+1]===-1&&(r[2*u+1]=o/3)}return{ends:Uint32Array.from(s),faces:Int32Array.from(r)}}function An(i){let[,e=i,t]=/^(.*?)(_deg|_ms|_s)?$/.exec(i)??[],n=e.replaceAll("_"," ");if(n.length<=2)return n;let s={_deg:" (°)",_ms:" (ms)",_s:" (s)"}[t??""]??"";return n.charAt(0).toUpperCase()+n.slice(1)+s}var Po=i=>(i??"").replace(/\.\w{2,8}$/,"").trim().toLowerCase().replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-|-$/g,"")||null,ji=i=>i.charAt(0).toUpperCase()+i.slice(1);function EC(i){let e=i.replace(/,/g,".").replace(/−/g,"-"),t=e.match(/[+-]?\s*\d*\.?\d+(?:e[+-]?\d+)?/gi);return!t||t.join("").replace(/\s/g,"")!==e.replace(/\s/g,"")?NaN:Number(t.reduce((n,s)=>n+Number(s.replace(/\s/g,"")),0).toPrecision(15))}var XS={"-":"⁻",...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((i,e)=>[String(e),i]))};function et(i,e=5){if(Number.isInteger(i)&&Math.abs(i)<1e15)return i.toLocaleString("en").replace("-","−");let t=Math.abs(i);if(t!==0&&(t<1e-4||t>=1e9)){let[n="",s=""]=i.toExponential(Math.min(e,3)-1).split("e");return`${(n.includes(".")?n.replace(/\.?0+$/,""):n).replace("-","−")}×10${[...s.replace("+","")].map(o=>XS[o]).join("")}`}return String(Number(i.toPrecision(e))).replace("-","−")}var Qi=(i,e,t=`${e}s`)=>`${et(i)} ${i===1?e:t}`;function Io(i){return i<10?`${et(Number(i.toPrecision(2)))} s`:i<90?`${Math.round(i)} s`:`${Math.floor(i/60)} min ${Math.round(i%60)} s`}var qS=1e-4,$S=1e-6,YS=.001;function Mm(i,e){let t=[{id:"plain",label:"Plain"}];for(let s of i.attributes.keys())t.push({id:s,label:An(s)});Pi(i)&&t.push({id:"edge_length",label:"Edge length"}),Pi(i)&&e!=="minimal_surface"&&t.push({id:"bending",label:"Bending (fold angle)"});let n=new Set(wm(i).flatMap(s=>s.values.map(({name:r})=>r)));n.delete("length");for(let s of n)t.push({id:`line:${s}`,label:An(s)});return t}var wm=i=>i.lines.filter(({name:e})=>e!=="reactions"),Em=i=>i.lines.some(({name:e,values:t})=>e.startsWith("cables")&&t.some(n=>n.name==="force"))?"line:force":"plain";function Tm(i,e,t,n){if(e==="plain")return null;if(e==="mean_curvature")return JS(i,t,n);if(e==="edge_length"||e==="bending")return KS(i,e,t,n);if(e.startsWith("line:"))return eM(i,e.slice(5));let s=i.attributes.get(e);return s?fc({id:e,label:An(e),unit:"",at:"vertex",values:s},0):null}function fc(i,e){let t=1/0,n=-1/0;for(let o of i.values)Number.isFinite(o)&&(t=Math.min(t,o),n=Math.max(n,o));t>n&&([t,n]=[0,0]);let s=Math.max(Math.abs(t),Math.abs(n)),r=s<=e;return t<0&&n>0?{...i,scale:"diverging",low:-s,high:s,nought:r,noise:e}:{...i,scale:"sequential",low:t,high:n,nought:r,noise:e}}function JS(i,e,t){let n=i.attributes.get("mean_curvature"),s=new Float32Array(n.length),r=ZS(i),o=!1;for(let u=0;u<n.length;u+=1)s[u]=n[u]*t*(n[u]<0?1:r[u]),o||=s[u]<0;i.geometry.computeBoundingSphere();let a=i.geometry.boundingSphere.radius/t,l=a>0?qS/a:0,c=fc({id:"mean_curvature",label:"Mean curvature",unit:`1/${e}`,at:"vertex",values:s},l),h=Math.max(Math.abs(c.low),Math.abs(c.high));return{...c,scale:"diverging",low:-h,high:h}}function ZS(i){let{position:e,normal:t}=i.geometry.attributes,n=i.geometry.index.array,s=new Float64Array(e.count),r=a=>new C().fromBufferAttribute(e,a),o=new C;for(let a=0;a<n.length;a+=3){let l=[n[a],n[a+1],n[a+2]],c=l.map(r);for(let h=0;h<3;h+=1){let[u,d]=[(h+1)%3,(h+2)%3],m=c[u].clone().sub(c[h]),g=c[d].clone().sub(c[h]),y=m.dot(g)/Math.max(m.clone().cross(g).length(),1e-30),p=c[d].clone().sub(c[u]);s[l[u]]+=y*p.dot(o.fromBufferAttribute(t,l[u])),s[l[d]]-=y*p.dot(o.fromBufferAttribute(t,l[d]))}}return Float32Array.from(s,a=>a<0?-1:1)}function KS(i,e,t,n){let s=dc(i.geometry),r=i.geometry.attributes.position.array,o=[];for(let d=0;d<s.ends.length/2;d+=1)(e==="edge_length"||s.faces[2*d+1]!==-1)&&o.push(d);let a=new Float32Array(6*o.length),l=new Float32Array(o.length),c=e==="bending"?jS(i):null;o.forEach((d,m)=>{let g=3*s.ends[2*d],y=3*s.ends[2*d+1];for(let p=0;p<3;p+=1)a[6*m+p]=r[g+p],a[6*m+3+p]=r[y+p];c?l[m]=QS(c,s,d):l[m]=Math.hypot(r[g]-r[y],r[g+1]-r[y+1],r[g+2]-r[y+2])/n});let h=e==="bending",u=fc({id:e,label:h?"Bending (fold angle)":"Edge length",unit:h?"°":t,at:"segment",values:l,segments:a},h?.01:0);return h?{...u,low:0}:u}function jS(i){let{position:e}=i.geometry.attributes,t=i.geometry.index.array,n=s=>new C().fromBufferAttribute(e,t[s]);return Array.from({length:t.length/3},(s,r)=>{let o=n(3*r);return n(3*r+1).sub(o).cross(n(3*r+2).sub(o)).normalize()})}var QS=(i,{faces:e},t)=>i[e[2*t]].angleTo(i[e[2*t+1]])*180/Math.PI;function eM(i,e){let t=wm(i).flatMap(c=>c.values.filter(h=>h.name===e).map(h=>({line:c,each:h})));if(t.length===0)return null;let n=t.reduce((c,{each:h})=>c+h.values.length/2,0),s=new Float32Array(n),r=new Float32Array(6*n),o=0;for(let{line:c,each:h}of t){r.set(c.segments,6*o);for(let u=0;u<h.values.length;u+=2)s[o+u/2]=h.values[u];o+=h.values.length/2}let a=fc({id:`line:${e}`,label:An(e),unit:t[0].each.unit,at:"segment",values:s,segments:r},0);if(a.high-a.low>YS*Math.max(Math.abs(a.low),Math.abs(a.high)))return a;let l=Number(((a.low+a.high)/2).toPrecision(4));return{...a,low:l,high:l}}function pc(i,e){if(i.nought)return i.scale==="diverging"?.5:0;let t=i.high-i.low;return t>$S*Math.max(Math.abs(i.low),Math.abs(i.high))?(e-i.low)/t:.5}var mc=(i,e)=>`${i.label} ${Math.abs(e)<=i.noise?"≈ 0":`${et(e,4)}`}${i.unit==="°"?"°":i.unit&&` ${i.unit}`}`;function Am(i,e){let t=new Array(e).fill(0);for(let n of i.values)Number.isFinite(n)&&(t[Math.min(e-1,Math.max(0,Math.floor(pc(i,n)*e)))]+=1);return t}var tM=8,Gu={length:.16,width:.06},nM=16,iM=2e4,Wu=null,kC=i=>{Wu=i},sM=i=>{i.fragmentShader=i.fragmentShader.replace("#include <normal_fragment_begin>",`
    vec3 normal = normalize(vNormal);
    float facing = dot(normal, isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(vViewPosition));
    float rim = -2.0 * fwidth(facing);
    if (!gl_FrontFacing && facing < 0.0) {
      if (facing > rim) discard;
      normal = -normal;
    }
    vec3 nonPerturbedNormal = normal;`)},Rm={polygonOffset:!0,polygonOffsetFactor:0,polygonOffsetUnits:-400};function Pm(i,e,t,n){let s=new bs().setPositions(i),r=new vs({color:new Oe(t).getHex(),linewidth:e,dashed:!0,dashSize:n,gapSize:n,toneMapped:!1,...Rm}),o=new Ro(s,r);return o.computeLineDistances(),o}function Lo(i,e,t,n,s=1){if(i.length/6>iM){let a=new Et().setAttribute("position",new mt(i,3));n&&a.setAttribute("color",new mt(n,3));let l=new sr({color:n?"#ffffff":t,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1});return new jr(a,l)}let r=new bs().setPositions(i);n&&r.setColors(n);let o=new vs({color:n?16777215:new Oe(t).getHex(),linewidth:e,vertexColors:!!n,transparent:s<1,opacity:s,toneMapped:!1,...Rm});return new Ro(r,o)}var rM=2e3;function pr({geometry:i,material:e}){i.dispose(),setTimeout(()=>e.dispose(),rM)}var gc=class{constructor(e){this.look=e}look;group=new _n;mesh=null;result=null;kind="";quantity=null;lines=[];layers={surface:!0,edges:!1,lines:!0,reactions:!1};drawn=!0;ghost=!1;get shown(){return this.mesh!==null}get current(){return this.result}show(e,t,n,s=null){this.result=e,this.kind=t,this.quantity=s,this.ghost=!1,e&&this.putInto(n),this.make()}putInto(e){if(!this.result)return;let t=e.up===2?[e.origin[0],e.origin[2],-e.origin[1]]:e.origin,[n,s,r]=this.result.translation.map((o,a)=>o-t[a]*e.metres);this.group.position.set(n,s,r)}colourBy(e){this.quantity=e,this.make()}setLayers(e){Object.assign(this.layers,e),this.make()}setGhost(e){if(e!==this.ghost&&(this.ghost=e,!!this.mesh)){this.mesh.material.transparent=e,this.mesh.material.opacity=e?.32:1,this.mesh.material.depthWrite=!e,this.mesh.material.needsUpdate=!0;for(let t of this.lines)t.material.transparent=!0,t.material.opacity=e?.2:t.userData.opacity??1}}restyle(){this.make()}clear(){this.mesh&&pr(this.mesh),this.mesh=null,this.lines.forEach(pr),this.lines=[],this.group.clear()}make(){let{result:e,quantity:t,ghost:n}=this;if(this.clear(),!e)return;let s=this.kind==="ruled_surface"||this.kind==="uniform_mesh",r=new Et;r.setIndex(e.geometry.index),r.setAttribute("position",e.geometry.attributes.position),r.setAttribute("normal",e.geometry.attributes.normal);let o=t?.at==="vertex";t&&o&&r.setAttribute("color",new mt(aM(t),3));let a={side:qt,flatShading:s,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1},l=o?new so({...a,vertexColors:!0}):new io({...a,color:this.look.membrane,roughness:.62,metalness:0});s||(l.onBeforeCompile=sM),this.mesh=new Lt(r,l),this.mesh.userData.castsShadow=!0,this.mesh.visible=this.layers.surface,this.group.add(this.mesh);let c=(u,d,m,g=1,y)=>{if(u.length===0)return;let p=Lo(u,d,m,y,g);p.userData.opacity=g,p.userData.isLine=!0,p.renderOrder=.01*this.lines.length,this.lines.push(p),this.group.add(p)},h=t?.at==="segment"?t:null;if(h?.id.startsWith("line:")){c(h.segments,5,this.look.rim);let u=this.lines.at(-1);u&&Object.assign(u.material,{depthWrite:!1})}if(h&&c(h.segments,3,this.look.ink,1,lM(h)),this.layers.edges&&h?.id!=="edge_length"&&c(cM(e),1,this.look.ink,.3),this.layers.lines)for(let{name:u,segments:d,values:m}of e.lines)u==="reactions"||h&&(u.startsWith("members")||u==="bridges")||m.some(g=>h?.id===`line:${g.name}`)||(["boundaries","directrices","held edges"].includes(u)?this.drawn||c(d,2,this.look.ink,.85):u.startsWith("members")?c(d,u.includes("rim")?1.4:2,this.look.ink,u.includes("rim")?.5:.8):u==="bridges"?c(d,1,this.look.ink,.35):c(d,2.4,this.look.accent));this.layers.reactions&&c(oM(e),2.2,this.look.reaction),n&&(this.ghost=!1,this.setGhost(!0))}reactions(){let e=this.layers.reactions?this.result?.lines.find(({name:a})=>a==="reactions"):void 0,t=e?.values.find(({name:a})=>a==="force");if(!e||!t)return[];let{x:n,y:s,z:r}=this.group.position;return Array.from({length:e.segments.length/6},(a,l)=>({i:l,size:t.values[2*l]})).sort((a,l)=>l.size-a.size).slice(0,nM).map(({i:a,size:l})=>({tip:[e.segments[6*a+3]+n,e.segments[6*a+4]+s,e.segments[6*a+5]+r],text:`${et(l,3)} ${t.unit}`}))}pick(e,t,n){if(!this.mesh||!this.layers.surface||!this.result||!Pi(this.result))return null;let s=new Yi;s.setFromCamera(new He(t/e.width*2-1,1-n/e.height*2),e.camera),this.group.updateMatrixWorld();let{geometry:r,matrixWorld:o}=this.mesh;if(!Wu){let[c]=s.intersectObject(this.mesh,!1);return c?{point:c.point,distance:c.distance,face:c.faceIndex??0}:null}r.boundsTree??=new Wu.MeshBVH(r,{indirect:!0});let a=r.boundsTree.raycastFirst(s.ray.clone().applyMatrix4(o.clone().invert()),qt),l=a?.point.applyMatrix4(o);return l?{point:l,distance:l.distanceTo(s.ray.origin),face:a.faceIndex??0}:null}pickLine(e,t,n){let{quantity:s,result:r}=this,o=[],a=(h,u)=>{for(let d=0;d<h.length/6;d+=1){let[m,g]=[0,3].map(M=>this.group.localToWorld(new C().fromArray(h,6*d+M))),y=e.project(m.toArray()),p=e.project(g.toArray());if(!y.visible||!p.visible)continue;let f=(p.x-y.x)**2+(p.y-y.y)**2,x=f>0?Math.min(1,Math.max(0,((t-y.x)*(p.x-y.x)+(n-y.y)*(p.y-y.y))/f)):0,w=Math.hypot(y.x+x*(p.x-y.x)-t,y.y+x*(p.y-y.y)-n);w<=tM&&o.push({distance:w,point:m.lerp(g,x),value:u(d)})}};this.group.updateMatrixWorld(),s?.at==="segment"&&a(s.segments,h=>mc(s,s.values[h]));let l=this.layers.reactions?r?.lines.find(({name:h})=>h==="reactions"):void 0,c=l?.values.find(({name:h})=>h==="force");return l&&c&&a(l.segments,h=>`Reaction ${et(c.values[2*h],4)} ${c.unit}`),o.sort((h,u)=>h.distance-u.distance)[0]??null}valueAt(e,t){let{quantity:n,mesh:s}=this;if(!n||!s)return null;let r=s.worldToLocal(e.clone());if(n.at==="segment")return hM(n,r);let o=s.geometry.index.array,{position:a}=s.geometry.attributes,l=[0,1,2].map(y=>o[3*t+y]),[c,h,u]=l.map(y=>new C().fromBufferAttribute(a,y)),d=(y,p,f)=>p.clone().sub(y).cross(f.clone().sub(y)).length(),m=[d(r,h,u),d(c,r,u),d(c,h,r)],g=m.reduce((y,p)=>y+p,0);return g>0?l.reduce((y,p,f)=>y+m[f]/g*n.values[p],0):n.values[l[0]]}outline(){let e=this.result?.geometry.attributes.position;if(!e)return[];let t=Math.max(1,Math.floor(e.count/3e3)),{x:n,y:s,z:r}=this.group.position,o=[];for(let l=0;l<e.count;l+=t)o.push([e.getX(l)+n,e.getY(l)+s,e.getZ(l)+r]);let a=this.result.geometry.boundingBox??(this.result.geometry.computeBoundingBox(),this.result.geometry.boundingBox);for(let l=0;l<e.count;l+=1){let c=[e.getX(l),e.getY(l),e.getZ(l)];if(c.some((h,u)=>h===a.min.getComponent(u)||h===a.max.getComponent(u))&&o.push([c[0]+n,c[1]+s,c[2]+r]),o.length>4e3)break}return o}};function oM(i){let{segments:e}=i.lines.find(({name:o})=>o==="reactions")??{segments:new Float32Array},t=new C,n=new C,s=0;for(let o=0;o<e.length;o+=6)s=Math.max(s,t.fromArray(e,o).distanceTo(n.fromArray(e,o+3)));let r=[];for(let o=0;o<e.length;o+=6){t.fromArray(e,o),n.fromArray(e,o+3);let a=n.clone().sub(t),l=a.length();if(!(l>1e-6*s))continue;a.divideScalar(l);let c=new C(Math.abs(a.x)<.8?1:0,Math.abs(a.x)<.8?0:1,0).cross(a).normalize(),h=Math.min(s*Gu.length,l),u=n.clone().addScaledVector(a,-h);r.push(...t.toArray(),...n.toArray());for(let d of[c,c.clone().cross(a)])for(let m of[-1,1])r.push(...u.clone().addScaledVector(d,m*h*Gu.width/Gu.length).toArray(),...n.toArray())}return new Float32Array(r)}function aM(i){let e=new Float32Array(3*i.values.length);return i.values.forEach((t,n)=>e.set(uc(i.scale,pc(i,t)),3*n)),e}function lM(i){let e=new Float32Array(6*i.values.length);return i.values.forEach((t,n)=>{let s=uc(i.scale,pc(i,t));e.set(s,6*n),e.set(s,6*n+3)}),e}var Cm=new WeakMap;function cM(i){let e=Cm.get(i);if(e)return e;let t=i.geometry.attributes.position.array,{ends:n}=dc(i.geometry),s=new Float32Array(3*n.length);return n.forEach((r,o)=>s.set(t.subarray(3*r,3*r+3),3*o)),Cm.set(i,s),s}function hM({segments:i,values:e},t){let n=1/0,s=null,r=new C,o=new C,a=new C;for(let l=0;l<e.length;l+=1){r.fromArray(i,6*l),o.fromArray(i,6*l+3).sub(r),a.copy(t).sub(r);let c=Math.min(1,Math.max(0,a.dot(o)/o.lengthSq())),h=a.addScaledVector(o,-c).lengthSq();h<n&&([n,s]=[h,e[l]])}return s}var Zn=(i,e)=>i?.line===e?.line&&i?.point===e?.point,uM=`
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
}`,dM=`
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
}`,_c=class{constructor(e){this.look=e;let t=n=>({value:new Oe(n)});this.material=new Ot({vertexShader:uM,fragmentShader:dM,transparent:!0,uniforms:{scale:{value:1},size:{value:11},near:{value:.001},paper:t(e.paper),accent:t(e.accent),ink:t(e.ink),fault:t(e.fault)}}),this.group.add(this.extra)}look;group=new _n;places=[];refs=[];points=null;lines=null;cables=[];extra=new _n;material;restyle(e){this.look=e;for(let t of["paper","accent","ink","fault"])this.material.uniforms[t].value.set(e[t])}setPixel(e,t){this.material.uniforms.near.value=e,this.material.uniforms.scale.value=t}show(e,t,n,s={courses:[],segments:new Set,chosen:-1}){let r=[],o=[],a=[];e.forEach((l,c)=>{let u=l.points.map(je).map(g=>g?n.toScene(g):null);if(u.forEach((g,y)=>{if(!Dr(l,y))return;let p=g??fM(u[(y+u.length-1)%u.length]??null,u[(y+1)%u.length]??null);p&&(r.push(p),o.push({line:c,point:y}))}),as(l))return;let d=u.flatMap((g,y)=>g?[{at:g,p:y}]:[]),m=l.closed&&d.length>2?d.length:d.length-1;for(let g=0;g<m;g+=1)s.segments.has(`${c}/${d[g].p}`)||a.push(...d[g].at,...d[(g+1)%d.length].at)}),t?.forEach((l,c)=>{r.push(n.toScene(l)),o.push({line:-1,point:c}),c>0&&a.push(...n.toScene(t[c-1]),...n.toScene(l))}),this.places=r,this.refs=o,this.setLines(new Float32Array(a)),this.setCables(s.courses.map(l=>l.map(c=>n.toScene(c))),s.chosen),this.setPoints()}setLines(e){this.lines&&(pr(this.lines),this.group.remove(this.lines)),this.lines=e.length>0?Lo(e,2.4,this.look.accent):null,this.lines&&(this.lines.renderOrder=1,this.group.add(this.lines))}setCables(e,t){for(let a of this.cables)pr(a),this.group.remove(a);let n=a=>a.slice(1).flatMap((l,c)=>[...a[c],...l]),s=(a,l,c)=>a.length>0?[Lo(new Float32Array(a),l,c)]:[],r=e.flatMap((a,l)=>l===t?[]:n(a)),o=Math.max(1e-9,...e.filter(a=>a.length>1).map(a=>Math.hypot(...a[0].map((l,c)=>l-a.at(-1)[c]))));this.cables=[...r.length>0?[Pm(new Float32Array(r),1.6,this.look.cable,o/40)]:[],...s(n(e[t]??[]),6,this.look.cable)];for(let a of this.cables)a.renderOrder=.9,a.material.depthWrite=!1,this.group.add(a)}setPoints(){let e=this.places.length;if(!this.points||this.points.geometry.attributes.position.count!==e){this.points&&(this.points.geometry.dispose(),this.group.remove(this.points));let n=new Et;n.setAttribute("position",new mt(new Float32Array(3*e),3)),n.setAttribute("state",new mt(new Float32Array(e),1)),this.points=new rr(n,this.material),this.points.frustumCulled=!1,this.points.renderOrder=2,this.group.add(this.points)}let{position:t}=this.points.geometry.attributes;this.places.forEach((n,s)=>t.setXYZ(s,...n)),t.needsUpdate=!0,this.material.uniforms.size.value=e>300?5:e>120?7:11}mark(e){let t=this.points?.geometry.attributes.state;t&&(this.refs.forEach((n,s)=>t.setX(s,e(n))),t.needsUpdate=!0)}hint(e){for(let n of this.extra.children)n.material===this.material?n.geometry.dispose():pr(n);this.extra.clear();let t=(n,s,r,o=1.6)=>{if(!n||n.length<2)return;let a=Lo(new Float32Array(n.flat()),o,s,void 0,r);a.renderOrder=1+.01*this.extra.children.length,o>2&&Object.assign(a.material,{depthTest:!1,depthWrite:!1,transparent:!0}),this.extra.add(a)};if(t(e.segments,this.look.accent,.95),t(e.faint,this.look.soft,.8),t(e.lift,this.look.paper,1,8),t(e.lift,this.look.cable,1,4.5),e.ghost){let n=new Et;n.setAttribute("position",new mt(new Float32Array(e.ghost),3)),n.setAttribute("state",new mt(new Float32Array([5]),1));let s=new rr(n,this.material);s.renderOrder=3,this.extra.add(s)}}};function fM(i,e){return!i||!e?i??e:[0,1,2].map(t=>(i[t]+e[t])/2)}var Mt={LEFT:1,RIGHT:2,MIDDLE:4},H=Object.freeze({NONE:0,ROTATE:1,TRUCK:2,SCREEN_PAN:4,OFFSET:8,DOLLY:16,ZOOM:32,TOUCH_ROTATE:64,TOUCH_TRUCK:128,TOUCH_SCREEN_PAN:256,TOUCH_OFFSET:512,TOUCH_DOLLY:1024,TOUCH_ZOOM:2048,TOUCH_DOLLY_TRUCK:4096,TOUCH_DOLLY_SCREEN_PAN:8192,TOUCH_DOLLY_OFFSET:16384,TOUCH_DOLLY_ROTATE:32768,TOUCH_ZOOM_TRUCK:65536,TOUCH_ZOOM_OFFSET:131072,TOUCH_ZOOM_SCREEN_PAN:262144,TOUCH_ZOOM_ROTATE:524288}),mr={NONE:0,IN:1,OUT:-1};function Ms(i){return i.isPerspectiveCamera}function ts(i){return i.isOrthographicCamera}var es=Math.PI*2,Im=Math.PI/2,km=1e-5,Oo=Math.PI/180;function Kn(i,e,t){return Math.max(e,Math.min(t,i))}function gt(i,e=km){return Math.abs(i)<e}function lt(i,e,t=km){return gt(i-e,t)}function Lm(i,e){return Math.round(i/e)*e}function Do(i){return isFinite(i)?i:i<0?-Number.MAX_VALUE:Number.MAX_VALUE}function No(i){return Math.abs(i)<Number.MAX_VALUE?i:i*(1/0)}function yc(i,e,t,n,s=1/0,r){n=Math.max(1e-4,n);let o=2/n,a=o*r,l=1/(1+a+.48*a*a+.235*a*a*a),c=i-e,h=e,u=s*n;c=Kn(c,-u,u),e=i-c;let d=(t.value+o*c)*r;t.value=(t.value-o*d)*l;let m=e+(c+d)*l;return h-i>0==m>h&&(m=h,t.value=(m-h)/r),m}function Om(i,e,t,n,s=1/0,r,o){n=Math.max(1e-4,n);let a=2/n,l=a*r,c=1/(1+l+.48*l*l+.235*l*l*l),h=e.x,u=e.y,d=e.z,m=i.x-h,g=i.y-u,y=i.z-d,p=h,f=u,x=d,w=s*n,M=w*w,v=m*m+g*g+y*y;if(v>M){let V=Math.sqrt(v);m=m/V*w,g=g/V*w,y=y/V*w}h=i.x-m,u=i.y-g,d=i.z-y;let b=(t.x+a*m)*r,_=(t.y+a*g)*r,T=(t.z+a*y)*r;t.x=(t.x-a*b)*c,t.y=(t.y-a*_)*c,t.z=(t.z-a*T)*c,o.x=h+(m+b)*c,o.y=u+(g+_)*c,o.z=d+(y+T)*c;let O=p-i.x,P=f-i.y,D=x-i.z,k=o.x-p,W=o.y-f,I=o.z-x;return O*k+P*W+D*I>0&&(o.x=p,o.y=f,o.z=x,t.x=(o.x-p)/r,t.y=(o.y-f)/r,t.z=(o.z-x)/r),o}function Xu(i,e){e.set(0,0),i.forEach(t=>{e.x+=t.clientX,e.y+=t.clientY}),e.x/=i.length,e.y/=i.length}function qu(i,e){return ts(i)?(console.warn(`${e} is not supported in OrthographicCamera`),!0):!1}var ju=class{constructor(){this._listeners={}}addEventListener(e,t){let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let s=this._listeners[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}removeAllEventListeners(e){if(!e){this._listeners={};return}Array.isArray(this._listeners[e])&&(this._listeners[e].length=0)}dispatchEvent(e){let n=this._listeners[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e)}}},$u,pM="3.1.0",xc=1/8,mM=/Mac/.test(($u=globalThis?.navigator)===null||$u===void 0?void 0:$u.platform),Ne,Dm,vc,Yu,vn,We,st,gr,Uo,di,fi,ws,Nm,Um,Cn,_r,yr,Fm,Ju,Bm,Zu,Ku,bc,xr=class i extends ju{static install(e){Ne=e.THREE,Dm=Object.freeze(new Ne.Vector3(0,0,0)),vc=Object.freeze(new Ne.Vector3(0,1,0)),Yu=Object.freeze(new Ne.Vector3(0,0,1)),vn=new Ne.Vector2,We=new Ne.Vector3,st=new Ne.Vector3,gr=new Ne.Vector3,Uo=new Ne.Vector3,di=new Ne.Vector3,fi=new Ne.Vector3,ws=new Ne.Vector3,Nm=new Ne.Vector3,Um=new Ne.Vector3,Cn=new Ne.Spherical,_r=new Ne.Spherical,yr=new Ne.Box3,Fm=new Ne.Box3,Ju=new Ne.Sphere,Bm=new Ne.Quaternion,Zu=new Ne.Quaternion,Ku=new Ne.Matrix4,bc=new Ne.Raycaster}static get ACTION(){return H}set verticalDragToForward(e){console.warn("camera-controls: `verticalDragToForward` was removed. Use `mouseButtons.left = CameraControls.ACTION.SCREEN_PAN` instead.")}constructor(e,t){super(),this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.minDistance=Number.EPSILON,this.maxDistance=1/0,this.infinityDolly=!1,this.minZoom=.01,this.maxZoom=1/0,this.smoothTime=.25,this.draggingSmoothTime=.125,this.maxSpeed=1/0,this.azimuthRotateSpeed=1,this.polarRotateSpeed=1,this.dollySpeed=1,this.dollyDragInverted=!1,this.truckSpeed=2,this.dollyToCursor=!1,this.dragToOffset=!1,this.boundaryFriction=0,this.restThreshold=.01,this.colliderMeshes=[],this.cancel=()=>{},this._enabled=!0,this._state=H.NONE,this._viewport=null,this._changedDolly=0,this._changedZoom=0,this._hasRested=!0,this._boundaryEnclosesCamera=!1,this._needsUpdate=!0,this._updatedLastTime=!1,this._elementRect=new DOMRect,this._isDragging=!1,this._dragNeedsUpdate=!0,this._activePointers=[],this._lockedPointer=null,this._interactiveArea=new DOMRect(0,0,1,1),this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._isUserControllingOffset=!1,this._isUserControllingZoom=!1,this._lastDollyDirection=mr.NONE,this._thetaVelocity={value:0},this._phiVelocity={value:0},this._radiusVelocity={value:0},this._targetVelocity=new Ne.Vector3,this._focalOffsetVelocity=new Ne.Vector3,this._zoomVelocity={value:0},this._truckInternal=(f,x,w,M)=>{let v,b;if(Ms(this._camera)){let _=We.copy(this._camera.position).sub(this._target),T=this._camera.getEffectiveFOV()*Oo,O=_.length()*Math.tan(T*.5);v=this.truckSpeed*f*O/this._elementRect.height,b=this.truckSpeed*x*O/this._elementRect.height}else if(ts(this._camera)){let _=this._camera;v=this.truckSpeed*f*(_.right-_.left)/_.zoom/this._elementRect.width,b=this.truckSpeed*x*(_.top-_.bottom)/_.zoom/this._elementRect.height}else return;M?(w?this.setFocalOffset(this._focalOffsetEnd.x+v,this._focalOffsetEnd.y,this._focalOffsetEnd.z,!0):this.truck(v,0,!0),this.forward(-b,!0)):w?this.setFocalOffset(this._focalOffsetEnd.x+v,this._focalOffsetEnd.y+b,this._focalOffsetEnd.z,!0):this.truck(v,b,!0)},this._rotateInternal=(f,x)=>{let w=es*this.azimuthRotateSpeed*f/this._elementRect.height,M=es*this.polarRotateSpeed*x/this._elementRect.height;this.rotate(w,M,!0)},this._dollyInternal=(f,x,w)=>{let M=Math.pow(.95,-f*this.dollySpeed),v=this._sphericalEnd.radius,b=this._sphericalEnd.radius*M,_=Kn(b,this.minDistance,this.maxDistance),T=_-b;this.infinityDolly&&this.dollyToCursor?this._dollyToNoClamp(b,!0):this.infinityDolly&&!this.dollyToCursor?(this.dollyInFixed(T,!0),this._dollyToNoClamp(_,!0)):this._dollyToNoClamp(_,!0),this.dollyToCursor&&(this._changedDolly+=(this.infinityDolly?b:_)-v,this._dollyControlCoord.set(x,w)),this._lastDollyDirection=Math.sign(-f)},this._zoomInternal=(f,x,w)=>{let M=Math.pow(.95,f*this.dollySpeed),v=this._zoom,b=this._zoom*M;this.zoomTo(b,!0),this.dollyToCursor&&(this._changedZoom+=b-v,this._dollyControlCoord.set(x,w))},typeof Ne>"u"&&console.error("camera-controls: `THREE` is undefined. You must first run `CameraControls.install( { THREE: THREE } )`. Check the docs for further information."),this._camera=e,this._yAxisUpSpace=new Ne.Quaternion().setFromUnitVectors(this._camera.up,vc),this._yAxisUpSpaceInverse=this._yAxisUpSpace.clone().invert(),this._state=H.NONE,this._target=new Ne.Vector3,this._targetEnd=this._target.clone(),this._focalOffset=new Ne.Vector3,this._focalOffsetEnd=this._focalOffset.clone(),this._spherical=new Ne.Spherical().setFromVector3(We.copy(this._camera.position).applyQuaternion(this._yAxisUpSpace)),this._sphericalEnd=this._spherical.clone(),this._lastDistance=this._spherical.radius,this._zoom=this._camera.zoom,this._zoomEnd=this._zoom,this._lastZoom=this._zoom,this._nearPlaneCorners=[new Ne.Vector3,new Ne.Vector3,new Ne.Vector3,new Ne.Vector3],this._updateNearPlaneCorners(),this._boundary=new Ne.Box3(new Ne.Vector3(-1/0,-1/0,-1/0),new Ne.Vector3(1/0,1/0,1/0)),this._cameraUp0=this._camera.up.clone(),this._target0=this._target.clone(),this._position0=this._camera.position.clone(),this._zoom0=this._zoom,this._focalOffset0=this._focalOffset.clone(),this._dollyControlCoord=new Ne.Vector2,this.mouseButtons={left:H.ROTATE,middle:H.DOLLY,right:H.TRUCK,wheel:Ms(this._camera)?H.DOLLY:ts(this._camera)?H.ZOOM:H.NONE},this.touches={one:H.TOUCH_ROTATE,two:Ms(this._camera)?H.TOUCH_DOLLY_TRUCK:ts(this._camera)?H.TOUCH_ZOOM_TRUCK:H.NONE,three:H.TOUCH_TRUCK};let n=new Ne.Vector2,s=new Ne.Vector2,r=new Ne.Vector2,o=f=>{if(!this._enabled||!this._domElement)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let M=this._domElement.getBoundingClientRect(),v=f.clientX/M.width,b=f.clientY/M.height;if(v<this._interactiveArea.left||v>this._interactiveArea.right||b<this._interactiveArea.top||b>this._interactiveArea.bottom)return}let x=f.pointerType!=="mouse"?null:(f.buttons&Mt.LEFT)===Mt.LEFT?Mt.LEFT:(f.buttons&Mt.MIDDLE)===Mt.MIDDLE?Mt.MIDDLE:(f.buttons&Mt.RIGHT)===Mt.RIGHT?Mt.RIGHT:null;if(x!==null){let M=this._findPointerByMouseButton(x);M&&this._disposePointer(M)}if((f.buttons&Mt.LEFT)===Mt.LEFT&&this._lockedPointer)return;let w={pointerId:f.pointerId,clientX:f.clientX,clientY:f.clientY,deltaX:0,deltaY:0,mouseButton:x};this._activePointers.push(w),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),this._isDragging=!0,d(f)},a=f=>{f.cancelable&&f.preventDefault();let x=f.pointerId,w=this._lockedPointer||this._findPointerById(x);if(w){if(w.clientX=f.clientX,w.clientY=f.clientY,w.deltaX=f.movementX,w.deltaY=f.movementY,this._state=0,f.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else(!this._isDragging&&this._lockedPointer||this._isDragging&&(f.buttons&Mt.LEFT)===Mt.LEFT)&&(this._state=this._state|this.mouseButtons.left),this._isDragging&&(f.buttons&Mt.MIDDLE)===Mt.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),this._isDragging&&(f.buttons&Mt.RIGHT)===Mt.RIGHT&&(this._state=this._state|this.mouseButtons.right);m()}},l=f=>{let x=this._findPointerById(f.pointerId);if(!(x&&x===this._lockedPointer)){if(x&&this._disposePointer(x),f.pointerType==="touch")switch(this._activePointers.length){case 0:this._state=H.NONE;break;case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else this._state=H.NONE;g()}},c=-1,h=f=>{if(!this._domElement||!this._enabled||this.mouseButtons.wheel===H.NONE)return;if(this._interactiveArea.left!==0||this._interactiveArea.top!==0||this._interactiveArea.width!==1||this._interactiveArea.height!==1){let b=this._domElement.getBoundingClientRect(),_=f.clientX/b.width,T=f.clientY/b.height;if(_<this._interactiveArea.left||_>this._interactiveArea.right||T<this._interactiveArea.top||T>this._interactiveArea.bottom)return}if(f.preventDefault(),this.dollyToCursor||this.mouseButtons.wheel===H.ROTATE||this.mouseButtons.wheel===H.TRUCK){let b=performance.now();c-b<1e3&&this._getClientRect(this._elementRect),c=b}let x=mM?-1:-3,w=f.deltaMode===1||f.ctrlKey?f.deltaY/x:f.deltaY/(x*10),M=this.dollyToCursor?(f.clientX-this._elementRect.x)/this._elementRect.width*2-1:0,v=this.dollyToCursor?(f.clientY-this._elementRect.y)/this._elementRect.height*-2+1:0;switch(this.mouseButtons.wheel){case H.ROTATE:{this._rotateInternal(f.deltaX,f.deltaY),this._isUserControllingRotate=!0;break}case H.TRUCK:{this._truckInternal(f.deltaX,f.deltaY,!1,!1),this._isUserControllingTruck=!0;break}case H.SCREEN_PAN:{this._truckInternal(f.deltaX,f.deltaY,!1,!0),this._isUserControllingTruck=!0;break}case H.OFFSET:{this._truckInternal(f.deltaX,f.deltaY,!0,!1),this._isUserControllingOffset=!0;break}case H.DOLLY:{this._dollyInternal(-w,M,v),this._isUserControllingDolly=!0;break}case H.ZOOM:{this._zoomInternal(-w,M,v),this._isUserControllingZoom=!0;break}}this.dispatchEvent({type:"control"})},u=f=>{if(!(!this._domElement||!this._enabled)){if(this.mouseButtons.right===i.ACTION.NONE){let x=f instanceof PointerEvent?f.pointerId:0,w=this._findPointerById(x);w&&this._disposePointer(w),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l);return}f.preventDefault()}},d=f=>{if(!this._enabled)return;if(Xu(this._activePointers,vn),this._getClientRect(this._elementRect),n.copy(vn),s.copy(vn),this._activePointers.length>=2){let w=vn.x-this._activePointers[1].clientX,M=vn.y-this._activePointers[1].clientY,v=Math.sqrt(w*w+M*M);r.set(0,v);let b=(this._activePointers[0].clientX+this._activePointers[1].clientX)*.5,_=(this._activePointers[0].clientY+this._activePointers[1].clientY)*.5;s.set(b,_)}if(this._state=0,!f)this._lockedPointer&&(this._state=this._state|this.mouseButtons.left);else if("pointerType"in f&&f.pointerType==="touch")switch(this._activePointers.length){case 1:this._state=this.touches.one;break;case 2:this._state=this.touches.two;break;case 3:this._state=this.touches.three;break}else!this._lockedPointer&&(f.buttons&Mt.LEFT)===Mt.LEFT&&(this._state=this._state|this.mouseButtons.left),(f.buttons&Mt.MIDDLE)===Mt.MIDDLE&&(this._state=this._state|this.mouseButtons.middle),(f.buttons&Mt.RIGHT)===Mt.RIGHT&&(this._state=this._state|this.mouseButtons.right);((this._state&H.ROTATE)===H.ROTATE||(this._state&H.TOUCH_ROTATE)===H.TOUCH_ROTATE||(this._state&H.TOUCH_DOLLY_ROTATE)===H.TOUCH_DOLLY_ROTATE||(this._state&H.TOUCH_ZOOM_ROTATE)===H.TOUCH_ZOOM_ROTATE)&&(this._sphericalEnd.theta=this._spherical.theta,this._sphericalEnd.phi=this._spherical.phi,this._thetaVelocity.value=0,this._phiVelocity.value=0),((this._state&H.TRUCK)===H.TRUCK||(this._state&H.SCREEN_PAN)===H.SCREEN_PAN||(this._state&H.TOUCH_TRUCK)===H.TOUCH_TRUCK||(this._state&H.TOUCH_SCREEN_PAN)===H.TOUCH_SCREEN_PAN||(this._state&H.TOUCH_DOLLY_TRUCK)===H.TOUCH_DOLLY_TRUCK||(this._state&H.TOUCH_DOLLY_SCREEN_PAN)===H.TOUCH_DOLLY_SCREEN_PAN||(this._state&H.TOUCH_ZOOM_TRUCK)===H.TOUCH_ZOOM_TRUCK||(this._state&H.TOUCH_ZOOM_SCREEN_PAN)===H.TOUCH_DOLLY_SCREEN_PAN)&&(this._targetEnd.copy(this._target),this._targetVelocity.set(0,0,0)),((this._state&H.DOLLY)===H.DOLLY||(this._state&H.TOUCH_DOLLY)===H.TOUCH_DOLLY||(this._state&H.TOUCH_DOLLY_TRUCK)===H.TOUCH_DOLLY_TRUCK||(this._state&H.TOUCH_DOLLY_SCREEN_PAN)===H.TOUCH_DOLLY_SCREEN_PAN||(this._state&H.TOUCH_DOLLY_OFFSET)===H.TOUCH_DOLLY_OFFSET||(this._state&H.TOUCH_DOLLY_ROTATE)===H.TOUCH_DOLLY_ROTATE)&&(this._sphericalEnd.radius=this._spherical.radius,this._radiusVelocity.value=0),((this._state&H.ZOOM)===H.ZOOM||(this._state&H.TOUCH_ZOOM)===H.TOUCH_ZOOM||(this._state&H.TOUCH_ZOOM_TRUCK)===H.TOUCH_ZOOM_TRUCK||(this._state&H.TOUCH_ZOOM_SCREEN_PAN)===H.TOUCH_ZOOM_SCREEN_PAN||(this._state&H.TOUCH_ZOOM_OFFSET)===H.TOUCH_ZOOM_OFFSET||(this._state&H.TOUCH_ZOOM_ROTATE)===H.TOUCH_ZOOM_ROTATE)&&(this._zoomEnd=this._zoom,this._zoomVelocity.value=0),((this._state&H.OFFSET)===H.OFFSET||(this._state&H.TOUCH_OFFSET)===H.TOUCH_OFFSET||(this._state&H.TOUCH_DOLLY_OFFSET)===H.TOUCH_DOLLY_OFFSET||(this._state&H.TOUCH_ZOOM_OFFSET)===H.TOUCH_ZOOM_OFFSET)&&(this._focalOffsetEnd.copy(this._focalOffset),this._focalOffsetVelocity.set(0,0,0)),this.dispatchEvent({type:"controlstart"})},m=()=>{if(!this._enabled||!this._dragNeedsUpdate)return;this._dragNeedsUpdate=!1,Xu(this._activePointers,vn);let x=this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement?this._lockedPointer||this._activePointers[0]:null,w=x?-x.deltaX:s.x-vn.x,M=x?-x.deltaY:s.y-vn.y;if(s.copy(vn),((this._state&H.ROTATE)===H.ROTATE||(this._state&H.TOUCH_ROTATE)===H.TOUCH_ROTATE||(this._state&H.TOUCH_DOLLY_ROTATE)===H.TOUCH_DOLLY_ROTATE||(this._state&H.TOUCH_ZOOM_ROTATE)===H.TOUCH_ZOOM_ROTATE)&&(this._rotateInternal(w,M),this._isUserControllingRotate=!0),(this._state&H.DOLLY)===H.DOLLY||(this._state&H.ZOOM)===H.ZOOM){let v=this.dollyToCursor?(n.x-this._elementRect.x)/this._elementRect.width*2-1:0,b=this.dollyToCursor?(n.y-this._elementRect.y)/this._elementRect.height*-2+1:0,_=this.dollyDragInverted?-1:1;(this._state&H.DOLLY)===H.DOLLY?(this._dollyInternal(_*M*xc,v,b),this._isUserControllingDolly=!0):(this._zoomInternal(_*M*xc,v,b),this._isUserControllingZoom=!0)}if((this._state&H.TOUCH_DOLLY)===H.TOUCH_DOLLY||(this._state&H.TOUCH_ZOOM)===H.TOUCH_ZOOM||(this._state&H.TOUCH_DOLLY_TRUCK)===H.TOUCH_DOLLY_TRUCK||(this._state&H.TOUCH_ZOOM_TRUCK)===H.TOUCH_ZOOM_TRUCK||(this._state&H.TOUCH_DOLLY_SCREEN_PAN)===H.TOUCH_DOLLY_SCREEN_PAN||(this._state&H.TOUCH_ZOOM_SCREEN_PAN)===H.TOUCH_ZOOM_SCREEN_PAN||(this._state&H.TOUCH_DOLLY_OFFSET)===H.TOUCH_DOLLY_OFFSET||(this._state&H.TOUCH_ZOOM_OFFSET)===H.TOUCH_ZOOM_OFFSET||(this._state&H.TOUCH_DOLLY_ROTATE)===H.TOUCH_DOLLY_ROTATE||(this._state&H.TOUCH_ZOOM_ROTATE)===H.TOUCH_ZOOM_ROTATE){let v=vn.x-this._activePointers[1].clientX,b=vn.y-this._activePointers[1].clientY,_=Math.sqrt(v*v+b*b),T=r.y-_;r.set(0,_);let O=this.dollyToCursor?(s.x-this._elementRect.x)/this._elementRect.width*2-1:0,P=this.dollyToCursor?(s.y-this._elementRect.y)/this._elementRect.height*-2+1:0;(this._state&H.TOUCH_DOLLY)===H.TOUCH_DOLLY||(this._state&H.TOUCH_DOLLY_ROTATE)===H.TOUCH_DOLLY_ROTATE||(this._state&H.TOUCH_DOLLY_TRUCK)===H.TOUCH_DOLLY_TRUCK||(this._state&H.TOUCH_DOLLY_SCREEN_PAN)===H.TOUCH_DOLLY_SCREEN_PAN||(this._state&H.TOUCH_DOLLY_OFFSET)===H.TOUCH_DOLLY_OFFSET?(this._dollyInternal(T*xc,O,P),this._isUserControllingDolly=!0):(this._zoomInternal(T*xc,O,P),this._isUserControllingZoom=!0)}((this._state&H.TRUCK)===H.TRUCK||(this._state&H.TOUCH_TRUCK)===H.TOUCH_TRUCK||(this._state&H.TOUCH_DOLLY_TRUCK)===H.TOUCH_DOLLY_TRUCK||(this._state&H.TOUCH_ZOOM_TRUCK)===H.TOUCH_ZOOM_TRUCK)&&(this._truckInternal(w,M,!1,!1),this._isUserControllingTruck=!0),((this._state&H.SCREEN_PAN)===H.SCREEN_PAN||(this._state&H.TOUCH_SCREEN_PAN)===H.TOUCH_SCREEN_PAN||(this._state&H.TOUCH_DOLLY_SCREEN_PAN)===H.TOUCH_DOLLY_SCREEN_PAN||(this._state&H.TOUCH_ZOOM_SCREEN_PAN)===H.TOUCH_ZOOM_SCREEN_PAN)&&(this._truckInternal(w,M,!1,!0),this._isUserControllingTruck=!0),((this._state&H.OFFSET)===H.OFFSET||(this._state&H.TOUCH_OFFSET)===H.TOUCH_OFFSET||(this._state&H.TOUCH_DOLLY_OFFSET)===H.TOUCH_DOLLY_OFFSET||(this._state&H.TOUCH_ZOOM_OFFSET)===H.TOUCH_ZOOM_OFFSET)&&(this._truckInternal(w,M,!0,!1),this._isUserControllingOffset=!0),this.dispatchEvent({type:"control"})},g=()=>{Xu(this._activePointers,vn),s.copy(vn),this._dragNeedsUpdate=!1,(this._activePointers.length===0||this._activePointers.length===1&&this._activePointers[0]===this._lockedPointer)&&(this._isDragging=!1),this._activePointers.length===0&&this._domElement&&(this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this.dispatchEvent({type:"controlend"}))};this.lockPointer=()=>{!this._enabled||!this._domElement||(this.cancel(),this._lockedPointer={pointerId:-1,clientX:0,clientY:0,deltaX:0,deltaY:0,mouseButton:null},this._activePointers.push(this._lockedPointer),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.requestPointerLock(),this._domElement.ownerDocument.addEventListener("pointerlockchange",y),this._domElement.ownerDocument.addEventListener("pointerlockerror",p),this._domElement.ownerDocument.addEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.addEventListener("pointerup",l),d())},this.unlockPointer=()=>{var f,x,w;this._lockedPointer!==null&&(this._disposePointer(this._lockedPointer),this._lockedPointer=null),(f=this._domElement)===null||f===void 0||f.ownerDocument.exitPointerLock(),(x=this._domElement)===null||x===void 0||x.ownerDocument.removeEventListener("pointerlockchange",y),(w=this._domElement)===null||w===void 0||w.ownerDocument.removeEventListener("pointerlockerror",p),this.cancel()};let y=()=>{this._domElement&&this._domElement.ownerDocument.pointerLockElement===this._domElement||this.unlockPointer()},p=()=>{this.unlockPointer()};this._addAllEventListeners=f=>{this._domElement=f,this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none",this._domElement.addEventListener("pointerdown",o),this._domElement.addEventListener("pointercancel",l),this._domElement.addEventListener("wheel",h,{passive:!1}),this._domElement.addEventListener("contextmenu",u)},this._removeAllEventListeners=()=>{this._domElement&&(this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect="",this._domElement.removeEventListener("pointerdown",o),this._domElement.removeEventListener("pointercancel",l),this._domElement.removeEventListener("wheel",h,{passive:!1}),this._domElement.removeEventListener("contextmenu",u),this._domElement.ownerDocument.removeEventListener("pointermove",a,{passive:!1}),this._domElement.ownerDocument.removeEventListener("pointerup",l),this._domElement.ownerDocument.removeEventListener("pointerlockchange",y),this._domElement.ownerDocument.removeEventListener("pointerlockerror",p))},this.cancel=()=>{this._state!==H.NONE&&(this._state=H.NONE,this._activePointers.length=0,g())},t&&this.connect(t),this.update(0)}get camera(){return this._camera}set camera(e){this._camera=e,this.updateCameraUp(),this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0}get enabled(){return this._enabled}set enabled(e){this._enabled=e,this._domElement&&(e?(this._domElement.style.touchAction="none",this._domElement.style.userSelect="none",this._domElement.style.webkitUserSelect="none"):(this.cancel(),this._domElement.style.touchAction="",this._domElement.style.userSelect="",this._domElement.style.webkitUserSelect=""))}get active(){return!this._hasRested}get currentAction(){return this._state}get distance(){return this._spherical.radius}set distance(e){this._spherical.radius===e&&this._sphericalEnd.radius===e||(this._spherical.radius=e,this._sphericalEnd.radius=e,this._needsUpdate=!0)}get azimuthAngle(){return this._spherical.theta}set azimuthAngle(e){this._spherical.theta===e&&this._sphericalEnd.theta===e||(this._spherical.theta=e,this._sphericalEnd.theta=e,this._needsUpdate=!0)}get polarAngle(){return this._spherical.phi}set polarAngle(e){this._spherical.phi===e&&this._sphericalEnd.phi===e||(this._spherical.phi=e,this._sphericalEnd.phi=e,this._needsUpdate=!0)}get boundaryEnclosesCamera(){return this._boundaryEnclosesCamera}set boundaryEnclosesCamera(e){this._boundaryEnclosesCamera=e,this._needsUpdate=!0}set interactiveArea(e){this._interactiveArea.width=Kn(e.width,0,1),this._interactiveArea.height=Kn(e.height,0,1),this._interactiveArea.x=Kn(e.x,0,1-this._interactiveArea.width),this._interactiveArea.y=Kn(e.y,0,1-this._interactiveArea.height)}addEventListener(e,t){super.addEventListener(e,t)}removeEventListener(e,t){super.removeEventListener(e,t)}rotate(e,t,n=!1){return this.rotateTo(this._sphericalEnd.theta+e,this._sphericalEnd.phi+t,n)}rotateAzimuthTo(e,t=!1){return this.rotateTo(e,this._sphericalEnd.phi,t)}rotatePolarTo(e,t=!1){return this.rotateTo(this._sphericalEnd.theta,e,t)}rotateTo(e,t,n=!1){this._isUserControllingRotate=!1;let s=Kn(e,this.minAzimuthAngle,this.maxAzimuthAngle),r=Kn(t,this.minPolarAngle,this.maxPolarAngle);this._sphericalEnd.theta=s,this._sphericalEnd.phi=r,this._sphericalEnd.makeSafe(),this._needsUpdate=!0,n||(this._spherical.theta=this._sphericalEnd.theta,this._spherical.phi=this._sphericalEnd.phi);let o=!n||lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold);return this._createOnRestPromise(o)}dolly(e,t=!1){return this.dollyTo(this._sphericalEnd.radius-e,t)}dollyTo(e,t=!1){return this._isUserControllingDolly=!1,this._lastDollyDirection=mr.NONE,this._changedDolly=0,this._dollyToNoClamp(Kn(e,this.minDistance,this.maxDistance),t)}_dollyToNoClamp(e,t=!1){let n=this._sphericalEnd.radius;if(this.colliderMeshes.length>=1){let o=this._collisionTest(),a=lt(o,this._spherical.radius);if(!(n>e)&&a)return Promise.resolve();this._sphericalEnd.radius=Math.min(e,o)}else this._sphericalEnd.radius=e;this._needsUpdate=!0,t||(this._spherical.radius=this._sphericalEnd.radius);let r=!t||lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(r)}dollyInFixed(e,t=!1){this._targetEnd.add(this._getCameraDirection(Uo).multiplyScalar(e)),t||this._target.copy(this._targetEnd);let n=!t||lt(this._target.x,this._targetEnd.x,this.restThreshold)&&lt(this._target.y,this._targetEnd.y,this.restThreshold)&&lt(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(n)}zoom(e,t=!1){return this.zoomTo(this._zoomEnd+e,t)}zoomTo(e,t=!1){this._isUserControllingZoom=!1,this._zoomEnd=Kn(e,this.minZoom,this.maxZoom),this._needsUpdate=!0,t||(this._zoom=this._zoomEnd);let n=!t||lt(this._zoom,this._zoomEnd,this.restThreshold);return this._changedZoom=0,this._createOnRestPromise(n)}pan(e,t,n=!1){return console.warn("`pan` has been renamed to `truck`"),this.truck(e,t,n)}truck(e,t,n=!1){this._camera.updateMatrix(),di.setFromMatrixColumn(this._camera.matrix,0),fi.setFromMatrixColumn(this._camera.matrix,1),di.multiplyScalar(e),fi.multiplyScalar(-t);let s=We.copy(di).add(fi),r=st.copy(this._targetEnd).add(s);return this.moveTo(r.x,r.y,r.z,n)}forward(e,t=!1){We.setFromMatrixColumn(this._camera.matrix,0),We.crossVectors(this._camera.up,We),We.multiplyScalar(e);let n=st.copy(this._targetEnd).add(We);return this.moveTo(n.x,n.y,n.z,t)}elevate(e,t=!1){return We.copy(this._camera.up).multiplyScalar(e),this.moveTo(this._targetEnd.x+We.x,this._targetEnd.y+We.y,this._targetEnd.z+We.z,t)}moveTo(e,t,n,s=!1){this._isUserControllingTruck=!1;let r=We.set(e,t,n).sub(this._targetEnd);this._encloseToBoundary(this._targetEnd,r,this.boundaryFriction),this._needsUpdate=!0,s||this._target.copy(this._targetEnd);let o=!s||lt(this._target.x,this._targetEnd.x,this.restThreshold)&&lt(this._target.y,this._targetEnd.y,this.restThreshold)&&lt(this._target.z,this._targetEnd.z,this.restThreshold);return this._createOnRestPromise(o)}lookInDirectionOf(e,t,n,s=!1){let a=We.set(e,t,n).sub(this._targetEnd).normalize().multiplyScalar(-this._sphericalEnd.radius).add(this._targetEnd);return this.setPosition(a.x,a.y,a.z,s)}fitToBox(e,t,{cover:n=!1,paddingLeft:s=0,paddingRight:r=0,paddingBottom:o=0,paddingTop:a=0}={}){let l=[],c=e.isBox3?yr.copy(e):yr.setFromObject(e);c.isEmpty()&&(console.warn("camera-controls: fitTo() cannot be used with an empty box. Aborting"),Promise.resolve());let h=Lm(this._sphericalEnd.theta,Im),u=Lm(this._sphericalEnd.phi,Im);l.push(this.rotateTo(h,u,t));let d=We.setFromSpherical(this._sphericalEnd).normalize(),m=Bm.setFromUnitVectors(d,Yu),g=lt(Math.abs(d.y),1);g&&m.multiply(Zu.setFromAxisAngle(vc,h)),m.multiply(this._yAxisUpSpaceInverse);let y=Fm.makeEmpty();st.copy(c.min).applyQuaternion(m),y.expandByPoint(st),st.copy(c.min).setX(c.max.x).applyQuaternion(m),y.expandByPoint(st),st.copy(c.min).setY(c.max.y).applyQuaternion(m),y.expandByPoint(st),st.copy(c.max).setZ(c.min.z).applyQuaternion(m),y.expandByPoint(st),st.copy(c.min).setZ(c.max.z).applyQuaternion(m),y.expandByPoint(st),st.copy(c.max).setY(c.min.y).applyQuaternion(m),y.expandByPoint(st),st.copy(c.max).setX(c.min.x).applyQuaternion(m),y.expandByPoint(st),st.copy(c.max).applyQuaternion(m),y.expandByPoint(st),y.min.x-=s,y.min.y-=o,y.max.x+=r,y.max.y+=a,m.setFromUnitVectors(Yu,d),g&&m.premultiply(Zu.invert()),m.premultiply(this._yAxisUpSpace);let p=y.getSize(We),f=y.getCenter(st).applyQuaternion(m);if(Ms(this._camera)){let x=this.getDistanceToFitBox(p.x,p.y,p.z,n);l.push(this.moveTo(f.x,f.y,f.z,t)),l.push(this.dollyTo(x,t)),l.push(this.setFocalOffset(0,0,0,t))}else if(ts(this._camera)){let x=this._camera,w=x.right-x.left,M=x.top-x.bottom,v=n?Math.max(w/p.x,M/p.y):Math.min(w/p.x,M/p.y);l.push(this.moveTo(f.x,f.y,f.z,t)),l.push(this.zoomTo(v,t)),l.push(this.setFocalOffset(0,0,0,t))}return Promise.all(l)}fitToSphere(e,t){let n=[],r="isObject3D"in e?i.createBoundingSphere(e,Ju):Ju.copy(e);if(n.push(this.moveTo(r.center.x,r.center.y,r.center.z,t)),Ms(this._camera)){let o=this.getDistanceToFitSphere(r.radius);n.push(this.dollyTo(o,t))}else if(ts(this._camera)){let o=this._camera.right-this._camera.left,a=this._camera.top-this._camera.bottom,l=2*r.radius,c=Math.min(o/l,a/l);n.push(this.zoomTo(c,t))}return n.push(this.setFocalOffset(0,0,0,t)),Promise.all(n)}setLookAt(e,t,n,s,r,o,a=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=mr.NONE,this._changedDolly=0;let l=st.set(s,r,o),c=We.set(e,t,n);this._targetEnd.copy(l),this._sphericalEnd.setFromVector3(c.sub(l).applyQuaternion(this._yAxisUpSpace)),this._needsUpdate=!0,a||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let h=!a||lt(this._target.x,this._targetEnd.x,this.restThreshold)&&lt(this._target.y,this._targetEnd.y,this.restThreshold)&&lt(this._target.z,this._targetEnd.z,this.restThreshold)&&lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(h)}lerp(e,t,n,s=!1){this._isUserControllingRotate=!1,this._isUserControllingDolly=!1,this._isUserControllingTruck=!1,this._lastDollyDirection=mr.NONE,this._changedDolly=0;let r=We.set(...e.target);if("spherical"in e)Cn.set(...e.spherical);else{let u=st.set(...e.position);Cn.setFromVector3(u.sub(r).applyQuaternion(this._yAxisUpSpace))}let o=gr.set(...t.target);if("spherical"in t)_r.set(...t.spherical);else{let u=st.set(...t.position);_r.setFromVector3(u.sub(o).applyQuaternion(this._yAxisUpSpace))}this._targetEnd.copy(r.lerp(o,n));let a=_r.theta-Cn.theta,l=_r.phi-Cn.phi,c=_r.radius-Cn.radius;this._sphericalEnd.set(Cn.radius+c*n,Cn.phi+l*n,Cn.theta+a*n),this._needsUpdate=!0,s||(this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd));let h=!s||lt(this._target.x,this._targetEnd.x,this.restThreshold)&&lt(this._target.y,this._targetEnd.y,this.restThreshold)&&lt(this._target.z,this._targetEnd.z,this.restThreshold)&&lt(this._spherical.theta,this._sphericalEnd.theta,this.restThreshold)&&lt(this._spherical.phi,this._sphericalEnd.phi,this.restThreshold)&&lt(this._spherical.radius,this._sphericalEnd.radius,this.restThreshold);return this._createOnRestPromise(h)}lerpLookAt(e,t,n,s,r,o,a,l,c,h,u,d,m,g=!1){return this.lerp({position:[e,t,n],target:[s,r,o]},{position:[a,l,c],target:[h,u,d]},m,g)}setPosition(e,t,n,s=!1){return this.setLookAt(e,t,n,this._targetEnd.x,this._targetEnd.y,this._targetEnd.z,s)}setTarget(e,t,n,s=!1){let r=this.getPosition(We),o=this.setLookAt(r.x,r.y,r.z,e,t,n,s);return this._sphericalEnd.phi=Kn(this._sphericalEnd.phi,this.minPolarAngle,this.maxPolarAngle),o}setFocalOffset(e,t,n,s=!1){this._isUserControllingOffset=!1,this._focalOffsetEnd.set(e,t,n),this._needsUpdate=!0,s||this._focalOffset.copy(this._focalOffsetEnd);let r=!s||lt(this._focalOffset.x,this._focalOffsetEnd.x,this.restThreshold)&&lt(this._focalOffset.y,this._focalOffsetEnd.y,this.restThreshold)&&lt(this._focalOffset.z,this._focalOffsetEnd.z,this.restThreshold);return this._createOnRestPromise(r)}setOrbitPoint(e,t,n){this._camera.updateMatrixWorld(),di.setFromMatrixColumn(this._camera.matrixWorldInverse,0),fi.setFromMatrixColumn(this._camera.matrixWorldInverse,1),ws.setFromMatrixColumn(this._camera.matrixWorldInverse,2);let s=We.set(e,t,n),r=s.distanceTo(this._camera.position),o=s.sub(this._camera.position);di.multiplyScalar(o.x),fi.multiplyScalar(o.y),ws.multiplyScalar(o.z),We.copy(di).add(fi).add(ws),We.z=We.z+r,this.dollyTo(r,!1),this.setFocalOffset(-We.x,We.y,-We.z,!1),this.moveTo(e,t,n,!1)}setBoundary(e){if(!e){this._boundary.min.set(-1/0,-1/0,-1/0),this._boundary.max.set(1/0,1/0,1/0),this._needsUpdate=!0;return}this._boundary.copy(e),this._boundary.clampPoint(this._targetEnd,this._targetEnd),this._needsUpdate=!0}setViewport(e,t,n,s){if(e===null){this._viewport=null;return}this._viewport=this._viewport||new Ne.Vector4,typeof e=="number"?this._viewport.set(e,t,n,s):this._viewport.copy(e)}getDistanceToFitBox(e,t,n,s=!1){if(qu(this._camera,"getDistanceToFitBox"))return this._spherical.radius;let r=e/t,o=this._camera.getEffectiveFOV()*Oo,a=this._camera.aspect;return((s?r>a:r<a)?t:e/a)*.5/Math.tan(o*.5)+n*.5}getDistanceToFitSphere(e){if(qu(this._camera,"getDistanceToFitSphere"))return this._spherical.radius;let t=this._camera.getEffectiveFOV()*Oo,n=Math.atan(Math.tan(t*.5)*this._camera.aspect)*2,s=1<this._camera.aspect?t:n;return e/Math.sin(s*.5)}getTarget(e,t=!0){return(e&&e.isVector3?e:new Ne.Vector3).copy(t?this._targetEnd:this._target)}getPosition(e,t=!0){return(e&&e.isVector3?e:new Ne.Vector3).setFromSpherical(t?this._sphericalEnd:this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(t?this._targetEnd:this._target)}getSpherical(e,t=!0){return(e||new Ne.Spherical).copy(t?this._sphericalEnd:this._spherical)}getFocalOffset(e,t=!0){return(e&&e.isVector3?e:new Ne.Vector3).copy(t?this._focalOffsetEnd:this._focalOffset)}normalizeRotations(){return this._sphericalEnd.theta=(this._sphericalEnd.theta%es+es)%es,this._sphericalEnd.theta>Math.PI&&(this._sphericalEnd.theta-=es),this._spherical.theta+=es*Math.round((this._sphericalEnd.theta-this._spherical.theta)/es),this}stop(){this._focalOffset.copy(this._focalOffsetEnd),this._target.copy(this._targetEnd),this._spherical.copy(this._sphericalEnd),this._zoom=this._zoomEnd}reset(e=!1){if(!lt(this._camera.up.x,this._cameraUp0.x)||!lt(this._camera.up.y,this._cameraUp0.y)||!lt(this._camera.up.z,this._cameraUp0.z)){this._camera.up.copy(this._cameraUp0);let n=this.getPosition(We);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}let t=[this.setLookAt(this._position0.x,this._position0.y,this._position0.z,this._target0.x,this._target0.y,this._target0.z,e),this.setFocalOffset(this._focalOffset0.x,this._focalOffset0.y,this._focalOffset0.z,e),this.zoomTo(this._zoom0,e)];return Promise.all(t)}saveState(){this._cameraUp0.copy(this._camera.up),this.getTarget(this._target0),this.getPosition(this._position0),this._zoom0=this._zoom,this._focalOffset0.copy(this._focalOffset)}updateCameraUp(){this._yAxisUpSpace.setFromUnitVectors(this._camera.up,vc),this._yAxisUpSpaceInverse.copy(this._yAxisUpSpace).invert()}applyCameraUp(){let e=We.subVectors(this._target,this._camera.position).normalize(),t=st.crossVectors(e,this._camera.up);this._camera.up.crossVectors(t,e).normalize(),this._camera.updateMatrixWorld();let n=this.getPosition(We);this.updateCameraUp(),this.setPosition(n.x,n.y,n.z)}update(e){let t=this._sphericalEnd.theta-this._spherical.theta,n=this._sphericalEnd.phi-this._spherical.phi,s=this._sphericalEnd.radius-this._spherical.radius,r=Nm.subVectors(this._targetEnd,this._target),o=Um.subVectors(this._focalOffsetEnd,this._focalOffset),a=this._zoomEnd-this._zoom;if(gt(t))this._thetaVelocity.value=0,this._spherical.theta=this._sphericalEnd.theta;else{let u=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.theta=yc(this._spherical.theta,this._sphericalEnd.theta,this._thetaVelocity,u,1/0,e),this._needsUpdate=!0}if(gt(n))this._phiVelocity.value=0,this._spherical.phi=this._sphericalEnd.phi;else{let u=this._isUserControllingRotate?this.draggingSmoothTime:this.smoothTime;this._spherical.phi=yc(this._spherical.phi,this._sphericalEnd.phi,this._phiVelocity,u,1/0,e),this._needsUpdate=!0}if(gt(s))this._radiusVelocity.value=0,this._spherical.radius=this._sphericalEnd.radius;else{let u=this._isUserControllingDolly?this.draggingSmoothTime:this.smoothTime;this._spherical.radius=yc(this._spherical.radius,this._sphericalEnd.radius,this._radiusVelocity,u,this.maxSpeed,e),this._needsUpdate=!0}if(gt(r.x)&&gt(r.y)&&gt(r.z))this._targetVelocity.set(0,0,0),this._target.copy(this._targetEnd);else{let u=this._isUserControllingTruck?this.draggingSmoothTime:this.smoothTime;Om(this._target,this._targetEnd,this._targetVelocity,u,this.maxSpeed,e,this._target),this._needsUpdate=!0}if(gt(o.x)&&gt(o.y)&&gt(o.z))this._focalOffsetVelocity.set(0,0,0),this._focalOffset.copy(this._focalOffsetEnd);else{let u=this._isUserControllingOffset?this.draggingSmoothTime:this.smoothTime;Om(this._focalOffset,this._focalOffsetEnd,this._focalOffsetVelocity,u,this.maxSpeed,e,this._focalOffset),this._needsUpdate=!0}if(gt(a))this._zoomVelocity.value=0,this._zoom=this._zoomEnd;else{let u=this._isUserControllingZoom?this.draggingSmoothTime:this.smoothTime;this._zoom=yc(this._zoom,this._zoomEnd,this._zoomVelocity,u,1/0,e)}if(this.dollyToCursor){if(Ms(this._camera)&&this._changedDolly!==0){let u=this._spherical.radius-this._lastDistance,d=this._camera,m=this._getCameraDirection(Uo),g=We.copy(m).cross(d.up).normalize();g.lengthSq()===0&&(g.x=1);let y=st.crossVectors(g,m),p=this._sphericalEnd.radius*Math.tan(d.getEffectiveFOV()*Oo*.5),x=(this._sphericalEnd.radius-u-this._sphericalEnd.radius)/this._sphericalEnd.radius,w=gr.copy(this._targetEnd).add(g.multiplyScalar(this._dollyControlCoord.x*p*d.aspect)).add(y.multiplyScalar(this._dollyControlCoord.y*p)),M=We.copy(this._targetEnd).lerp(w,x),v=this._lastDollyDirection===mr.IN&&this._spherical.radius<=this.minDistance,b=this._lastDollyDirection===mr.OUT&&this.maxDistance<=this._spherical.radius;if(this.infinityDolly&&(v||b)){this._sphericalEnd.radius-=u,this._spherical.radius-=u;let T=st.copy(m).multiplyScalar(-u);M.add(T)}this._boundary.clampPoint(M,M);let _=st.subVectors(M,this._targetEnd);this._targetEnd.copy(M),this._target.add(_),this._changedDolly-=u,gt(this._changedDolly)&&(this._changedDolly=0)}else if(ts(this._camera)&&this._changedZoom!==0){let u=this._zoom-this._lastZoom,d=this._camera,m=We.set(this._dollyControlCoord.x,this._dollyControlCoord.y,(d.near+d.far)/(d.near-d.far)).unproject(d),g=st.set(0,0,-1).applyQuaternion(d.quaternion),y=gr.copy(m).add(g.multiplyScalar(-m.dot(d.up))),f=-(this._zoom-u-this._zoom)/this._zoom,x=this._getCameraDirection(Uo),w=this._targetEnd.dot(x),M=We.copy(this._targetEnd).lerp(y,f),v=M.dot(x),b=x.multiplyScalar(v-w);M.sub(b),this._boundary.clampPoint(M,M);let _=st.subVectors(M,this._targetEnd);this._targetEnd.copy(M),this._target.add(_),this._changedZoom-=u,gt(this._changedZoom)&&(this._changedZoom=0)}}this._camera.zoom!==this._zoom&&(this._camera.zoom=this._zoom,this._camera.updateProjectionMatrix(),this._updateNearPlaneCorners(),this._needsUpdate=!0),this._dragNeedsUpdate=!0;let l=this._collisionTest();this._spherical.radius=Math.min(this._spherical.radius,l),this._spherical.makeSafe(),this._camera.position.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse).add(this._target),this._camera.lookAt(this._target),(!gt(this._focalOffset.x)||!gt(this._focalOffset.y)||!gt(this._focalOffset.z))&&(di.setFromMatrixColumn(this._camera.matrix,0),fi.setFromMatrixColumn(this._camera.matrix,1),ws.setFromMatrixColumn(this._camera.matrix,2),di.multiplyScalar(this._focalOffset.x),fi.multiplyScalar(-this._focalOffset.y),ws.multiplyScalar(this._focalOffset.z),We.copy(di).add(fi).add(ws),this._camera.position.add(We),this._camera.updateMatrixWorld()),this._boundaryEnclosesCamera&&this._encloseToBoundary(this._camera.position.copy(this._target),We.setFromSpherical(this._spherical).applyQuaternion(this._yAxisUpSpaceInverse),1);let h=this._needsUpdate;return h&&!this._updatedLastTime?(this._hasRested=!1,this.dispatchEvent({type:"wake"}),this.dispatchEvent({type:"update"})):h?(this.dispatchEvent({type:"update"}),gt(t,this.restThreshold)&&gt(n,this.restThreshold)&&gt(s,this.restThreshold)&&gt(r.x,this.restThreshold)&&gt(r.y,this.restThreshold)&&gt(r.z,this.restThreshold)&&gt(o.x,this.restThreshold)&&gt(o.y,this.restThreshold)&&gt(o.z,this.restThreshold)&&gt(a,this.restThreshold)&&!this._hasRested&&(this._hasRested=!0,this.dispatchEvent({type:"rest"}))):!h&&this._updatedLastTime&&this.dispatchEvent({type:"sleep"}),this._lastDistance=this._spherical.radius,this._lastZoom=this._zoom,this._updatedLastTime=h,this._needsUpdate=!1,h}toJSON(){return JSON.stringify({enabled:this._enabled,minDistance:this.minDistance,maxDistance:Do(this.maxDistance),minZoom:this.minZoom,maxZoom:Do(this.maxZoom),minPolarAngle:this.minPolarAngle,maxPolarAngle:Do(this.maxPolarAngle),minAzimuthAngle:Do(this.minAzimuthAngle),maxAzimuthAngle:Do(this.maxAzimuthAngle),smoothTime:this.smoothTime,draggingSmoothTime:this.draggingSmoothTime,dollySpeed:this.dollySpeed,truckSpeed:this.truckSpeed,dollyToCursor:this.dollyToCursor,target:this._targetEnd.toArray(),position:We.setFromSpherical(this._sphericalEnd).add(this._targetEnd).toArray(),zoom:this._zoomEnd,focalOffset:this._focalOffsetEnd.toArray(),target0:this._target0.toArray(),position0:this._position0.toArray(),zoom0:this._zoom0,focalOffset0:this._focalOffset0.toArray()})}fromJSON(e,t=!1){let n=JSON.parse(e);this.enabled=n.enabled,this.minDistance=n.minDistance,this.maxDistance=No(n.maxDistance),this.minZoom=n.minZoom,this.maxZoom=No(n.maxZoom),this.minPolarAngle=n.minPolarAngle,this.maxPolarAngle=No(n.maxPolarAngle),this.minAzimuthAngle=No(n.minAzimuthAngle),this.maxAzimuthAngle=No(n.maxAzimuthAngle),this.smoothTime=n.smoothTime,this.draggingSmoothTime=n.draggingSmoothTime,this.dollySpeed=n.dollySpeed,this.truckSpeed=n.truckSpeed,this.dollyToCursor=n.dollyToCursor,this._target0.fromArray(n.target0),this._position0.fromArray(n.position0),this._zoom0=n.zoom0,this._focalOffset0.fromArray(n.focalOffset0),this.moveTo(n.target[0],n.target[1],n.target[2],t),Cn.setFromVector3(We.fromArray(n.position).sub(this._targetEnd).applyQuaternion(this._yAxisUpSpace)),this.rotateTo(Cn.theta,Cn.phi,t),this.dollyTo(Cn.radius,t),this.zoomTo(n.zoom,t),this.setFocalOffset(n.focalOffset[0],n.focalOffset[1],n.focalOffset[2],t),this._needsUpdate=!0}connect(e){if(this._domElement){console.warn("camera-controls is already connected.");return}e.setAttribute("data-camera-controls-version",pM),this._addAllEventListeners(e),this._getClientRect(this._elementRect)}disconnect(){this.cancel(),this._removeAllEventListeners(),this._domElement&&(this._domElement.removeAttribute("data-camera-controls-version"),this._domElement=void 0)}dispose(){this.removeAllEventListeners(),this.disconnect()}_getTargetDirection(e){return e.setFromSpherical(this._spherical).divideScalar(this._spherical.radius).applyQuaternion(this._yAxisUpSpaceInverse)}_getCameraDirection(e){return this._getTargetDirection(e).negate()}_findPointerById(e){return this._activePointers.find(t=>t.pointerId===e)}_findPointerByMouseButton(e){return this._activePointers.find(t=>t.mouseButton===e)}_disposePointer(e){this._activePointers.splice(this._activePointers.indexOf(e),1)}_encloseToBoundary(e,t,n){let s=t.lengthSq();if(s===0)return e;let r=st.copy(t).add(e),a=this._boundary.clampPoint(r,gr).sub(r),l=a.lengthSq();if(l===0)return e.add(t);if(l===s)return e;if(n===0)return e.add(t).add(a);{let c=1+n*l/t.dot(a);return e.add(st.copy(t).multiplyScalar(c)).add(a.multiplyScalar(1-n))}}_updateNearPlaneCorners(){if(Ms(this._camera)){let e=this._camera,t=e.near,n=e.getEffectiveFOV()*Oo,s=Math.tan(n*.5)*t,r=s*e.aspect;this._nearPlaneCorners[0].set(-r,-s,0),this._nearPlaneCorners[1].set(r,-s,0),this._nearPlaneCorners[2].set(r,s,0),this._nearPlaneCorners[3].set(-r,s,0)}else if(ts(this._camera)){let e=this._camera,t=1/e.zoom,n=e.left*t,s=e.right*t,r=e.top*t,o=e.bottom*t;this._nearPlaneCorners[0].set(n,r,0),this._nearPlaneCorners[1].set(s,r,0),this._nearPlaneCorners[2].set(s,o,0),this._nearPlaneCorners[3].set(n,o,0)}}_collisionTest(){let e=1/0;if(!(this.colliderMeshes.length>=1)||qu(this._camera,"_collisionTest"))return e;let n=this._getTargetDirection(Uo);Ku.lookAt(Dm,n,this._camera.up);for(let s=0;s<4;s++){let r=st.copy(this._nearPlaneCorners[s]);r.applyMatrix4(Ku);let o=gr.addVectors(this._target,r);bc.set(o,n),bc.far=this._spherical.radius+1;let a=bc.intersectObjects(this.colliderMeshes);a.length!==0&&a[0].distance<e&&(e=a[0].distance)}return e}_getClientRect(e){if(!this._domElement)return;let t=this._domElement.getBoundingClientRect();return e.x=t.left,e.y=t.top,this._viewport?(e.x+=this._viewport.x,e.y+=t.height-this._viewport.w-this._viewport.y,e.width=this._viewport.z,e.height=this._viewport.w):(e.width=t.width,e.height=t.height),e}_createOnRestPromise(e){return e?Promise.resolve():(this._hasRested=!1,this.dispatchEvent({type:"transitionstart"}),new Promise(t=>{let n=()=>{this.removeEventListener("rest",n),t()};this.addEventListener("rest",n)}))}_addAllEventListeners(e){}_removeAllEventListeners(){}get dampingFactor(){return console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead."),0}set dampingFactor(e){console.warn(".dampingFactor has been deprecated. use smoothTime (in seconds) instead.")}get draggingDampingFactor(){return console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead."),0}set draggingDampingFactor(e){console.warn(".draggingDampingFactor has been deprecated. use draggingSmoothTime (in seconds) instead.")}static createBoundingSphere(e,t=new Ne.Sphere){let n=t,s=n.center;yr.makeEmpty(),e.traverseVisible(o=>{o.isMesh&&yr.expandByObject(o)}),yr.getCenter(s);let r=0;return e.traverseVisible(o=>{if(!o.isMesh)return;let a=o;if(!a.geometry)return;let l=a.geometry.clone();l.applyMatrix4(a.matrixWorld);let h=l.attributes.position;for(let u=0,d=h.count;u<d;u++)We.fromBufferAttribute(h,u),r=Math.max(r,s.distanceToSquared(We))}),n.radius=Math.sqrt(r),n}};var Qu=2e3,gM=[{toward:new C(-.75,.55,.38).normalize(),strength:1.2,width:.7},{toward:new C(.8,.42,-.35).normalize(),strength:.5,width:.8},{toward:new C(.1,1,-.15).normalize(),strength:.4,width:.8}];function _M(i){let e=i.y,t=e>0?.24+.14*e**.6:.24-.14*(-e)**.5,n=0;for(let{toward:s,strength:r,width:o}of gM){let a=i.dot(s);a>o&&(n+=r*((a-o)/(1-o))**.5)}return[t*(1-.05*e)+n,t+n*.99,t*(1+.09*e)+n*.96]}function zm(){let i=new ms,e=[],t=4*Math.PI/Qu;for(let n=0;n<Qu;n+=1){let s=1-(2*n+1)/Qu,r=Math.sqrt(1-s*s),o=n*Math.PI*(3-Math.sqrt(5)),a=new C(r*Math.cos(o),s,r*Math.sin(o)),l=new C(..._M(a));ms.getBasisAt(a,e);for(let c=0;c<9;c+=1)i.coefficients[c].addScaledVector(l,e[c]*t)}return new co(i)}var yM=`
varying vec2 at; uniform vec2 middle; uniform float size;
void main() {
  at = middle + position.xy * size * vec2(1.0, -1.0);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`,xM=`
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
}`,ed={polygonOffset:!0,polygonOffsetFactor:3,polygonOffsetUnits:4},Sc=class{mesh;step=1;constructor(){let e={middle:{value:[0,0]},size:{value:1},step1:{value:1},reach:{value:1},strength:{value:.5},ink:{value:new Oe("#5b6b73")}},t=new Ot({uniforms:e,vertexShader:yM,fragmentShader:xM,transparent:!0,depthWrite:!1,side:qt,...ed});this.mesh=new Lt(new ri(1,1),t),this.mesh.rotation.x=-Math.PI/2,this.mesh.renderOrder=-2,this.mesh.frustumCulled=!1}place(e,t,n){let{uniforms:s}=this.mesh.material,r=t*4.5;this.step=10**Math.floor(Math.log10(t/2.5));let o=this.step*10,[a,l]=[Math.round(e.x/o)*o,Math.round(e.z/o)*o];this.mesh.position.set(a,n-.004*t,l),this.mesh.scale.setScalar(2*r),Object.assign(s.middle,{value:[0,0]}),s.size.value=2*r,s.step1.value=this.step,s.reach.value=r}style(e,t){this.mesh.material.uniforms.ink.value.set(e),this.mesh.material.uniforms.strength.value=t}};var vr=256,vM=1.5,bM=`
varying float height; uniform float ground, reach;
void main() { vec4 at = modelMatrix * vec4(position, 1.0); height = (at.y - ground) / reach; gl_Position = projectionMatrix * viewMatrix * at; }`,SM=`
varying float height;
void main() { gl_FragColor = vec4(0.0, 0.0, 0.0, 0.75 * pow(1.0 - clamp(height, 0.0, 1.0), 1.4)); }`,MM="varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy * 2.0, 0.0, 1.0); }",wM=`
varying vec2 at; uniform sampler2D picture; uniform vec2 step;
void main() {
  float sum = 0.0, weight = 0.0;
  for (float i = -8.0; i <= 8.0; i += 1.0) {
    float w = exp(-0.5 * i * i / 16.0);
    sum += w * texture2D(picture, at + i * step).a; weight += w;
  }
  gl_FragColor = vec4(0.0, 0.0, 0.0, sum / weight);
}`,Mc=class{plane;targets=[new sn(vr,vr),new sn(vr,vr)];camera=new ps(-1,1,1,-1,0,1);dark=new Ot({vertexShader:bM,fragmentShader:SM,side:qt,blending:oi,uniforms:{ground:{value:0},reach:{value:1}}});blur=new Ot({vertexShader:MM,fragmentShader:wM,depthTest:!1,depthWrite:!1,blending:oi,uniforms:{picture:{value:null},step:{value:[0,0]}}});opacity=.5;faded=!1;page=new Lt(new ri(1,1),this.blur);constructor(){let e=new ir({map:this.targets[0].texture,transparent:!0,depthWrite:!1,opacity:.5,toneMapped:!1,...ed});this.plane=new Lt(new ri(1,1),e),this.plane.rotation.x=-Math.PI/2,this.plane.renderOrder=-1,this.page.frustumCulled=!1}update(e,t,n,s,r){let o=[],a=!1;if(n.traverse(v=>{v.userData.castsShadow?a||=v.visible:("isMesh"in v||"isLine"in v||"isPoints"in v)&&o.push(v)}),this.plane.visible=a,!a)return;let[l,c]=[s.max.x-s.min.x,s.max.z-s.min.z],h=Math.max(l,c)*vM||1,u=Math.max(s.max.y-s.min.y,.35*h),[d,m]=[(s.min.x+s.max.x)/2,(s.min.z+s.max.z)/2],g=s.min.y;this.plane.position.set(d,g-.002*h,m),this.plane.scale.setScalar(h);let{camera:y,dark:p,targets:f}=this;Object.assign(y,{left:-h/2,right:h/2,top:h/2,bottom:-h/2,near:0,far:2*u+.1*h}),y.position.set(d,g+2*u,m),y.up.set(0,0,-1),y.lookAt(d,g,m),y.updateProjectionMatrix(),p.uniforms.ground.value=g,p.uniforms.reach.value=u;let x=[...r,this.plane,...o].map(v=>[v,v.visible]);x.forEach(([v])=>{v.visible=!1});let w=e.getRenderTarget(),M=t.background;t.background=null,t.overrideMaterial=p,e.setRenderTarget(f[0]),e.setScissorTest(!1),e.clear(),e.render(t,y),t.overrideMaterial=null,t.background=M,x.forEach(([v,b])=>{v.visible=b}),this.smear(e,f[0],f[1],[1.1/vr,0]),this.smear(e,f[1],f[0],[0,1.1/vr]),e.setRenderTarget(w)}smear(e,t,n,s){this.blur.uniforms.picture.value=t.texture,this.blur.uniforms.step.value=s,e.setRenderTarget(n),e.clear(),e.render(this.page,this.camera)}style(e){this.opacity=e,this.fade(this.faded)}fade(e){this.faded=e,this.plane.material.opacity=e?.25*this.opacity:this.opacity}};xr.install({THREE:{Box3:rn,Matrix4:ot,Quaternion:Un,Raycaster:Yi,Sphere:un,Spherical:uo,Vector2:He,Vector3:C,Vector4:it}});var wc=30,Vm=.04,EM=2,TM=2.5,Ec=class{constructor(e,t){this.canvas=e;this.insets=t;this.renderer=CM(e),this.shadow=new Mc,this.scene.add(this.model,this.grid.mesh,this.shadow.plane);let n=new lo(16775406,1.8);n.position.set(-3.4,2.2,.6),this.scene.add(n,zm()),this.controls=new xr(this.camera,e),Object.assign(this.controls,{smoothTime:.12,draggingSmoothTime:.05,minPolarAngle:.001,maxPolarAngle:Math.PI-.001,dollyToCursor:!0,dollySpeed:TM});let{ACTION:s}=xr;Object.assign(this.controls.mouseButtons,{left:s.ROTATE,right:s.TRUCK,middle:s.TRUCK,wheel:s.NONE});for(let r of["controlstart","control","transitionstart"])this.controls.addEventListener(r,()=>this.wake());this.controls.addEventListener("controlstart",()=>{this.fitted=!1,[s.ROTATE,s.TOUCH_ROTATE].some(r=>r===this.controls.currentAction)&&this.leaveParallel()}),this.controls.addEventListener("rest",()=>this.onRest()),e.addEventListener("wheel",r=>this.onWheel(r),{passive:!1}),e.addEventListener("webglcontextlost",r=>r.preventDefault()),e.addEventListener("webglcontextrestored",()=>this.invalidate()),new ResizeObserver(()=>this.resize()).observe(e),this.resize()}canvas;insets;renderer;scene=new Jr;camera=new cn(wc,1,.1,1e3);controls;model=new _n;grid=new Sc;shadow;beforeDraw=()=>{};onDraw=()=>{};onRest=()=>{};content=()=>[];tiles=null;width=1;height=1;field=wc;frames=0;dirty=!0;running=!1;last=0;sphere=new un(new C,5);wasInside=!0;fitted=!1;invalidate(){this.dirty=!0,this.wake()}wake(){this.running||(this.running=!0,this.last=performance.now(),requestAnimationFrame(e=>this.tick(e)))}tick(e){let t=Math.min(Math.max(e-this.last,1)/1e3,.1);this.last=e;let n=this.controls.update(t);(n||this.dirty)&&this.draw(),n||this.dirty?requestAnimationFrame(s=>this.tick(s)):this.running=!1}draw(){this.dirty=!1,this.frames+=1;let{renderer:e,camera:t}=this,n=t.position.distanceTo(this.sphere.center);t.near=Math.max(n-4*this.sphere.radius,n*.004),t.far=n+40*this.sphere.radius,t.updateProjectionMatrix(),t.updateMatrixWorld(),this.beforeDraw(),e&&(this.tiles?this.drawTiles(e,this.tiles):(e.setScissorTest(!1),e.setViewport(0,0,this.width,this.height),e.render(this.scene,t))),this.onDraw()}drawTiles(e,t){let n=this.canvas.getBoundingClientRect();e.setScissorTest(!1),e.clear(),e.setScissorTest(!0);let s=[this.model,this.grid.mesh,this.shadow.plane].map(r=>[r,r.visible]);s.forEach(([r])=>{r.visible=!1});for(let{element:r,group:o}of t){let a=r.getBoundingClientRect(),l=Math.max(a.top,n.top),c=Math.min(a.bottom,n.bottom);c<=l||a.width<1||(e.setViewport(a.left-n.left,n.bottom-a.bottom,a.width,a.height),e.setScissor(a.left-n.left,n.bottom-c,a.width,c-l),this.camera.aspect=a.width/a.height,this.camera.fov=td(this.camera.aspect,this.field),this.camera.updateProjectionMatrix(),this.scene.add(o),e.render(this.scene,this.camera),this.scene.remove(o))}s.forEach(([r,o])=>{r.visible=o}),e.setScissorTest(!1),this.shape()}async picture(e,t){let{renderer:n}=this;if(!n)throw new Error("there is no picture without WebGL 2");let s=n.getPixelRatio();n.setPixelRatio(e),n.setSize(this.width,this.height,!1),this.scene.background=t===null?null:new Oe(t),this.draw();let r=await new Promise(o=>{this.canvas.toBlob(o,"image/png")});if(this.scene.background=null,n.setPixelRatio(s),n.setSize(this.width,this.height,!1),this.draw(),!r)throw new Error("the browser makes no picture of this size");return r}resize(){let{clientWidth:e,clientHeight:t}=this.canvas;e===0||t===0||(this.width=e,this.height=t,this.renderer&&(this.renderer.setPixelRatio(Math.min(window.devicePixelRatio||1,EM)),this.renderer.setSize(e,t,!1)),this.shape(),this.keepInside(!1),this.draw())}keepInside(e){(this.fitted||this.wasInside&&!this.allInside())&&this.fit(e)}shape(){this.camera.aspect=this.width/this.height,this.camera.fov=td(this.camera.aspect,this.field),this.camera.updateProjectionMatrix()}measure(){let e=this.content(),t=new rn;e.forEach(n=>t.expandByPoint(new C(...n))),t.isEmpty()&&t.set(new C(-5,0,-5),new C(5,0,5)),t.getBoundingSphere(this.sphere),this.sphere.radius===0&&(this.sphere.radius=1),this.grid.place(this.sphere.center,this.sphere.radius,t.min.y),this.renderer&&this.shadow.update(this.renderer,this.scene,this.model,t,[this.grid.mesh]),this.invalidate()}get isAtRest(){return!this.running}get radius(){return this.sphere.radius}get centre(){return this.sphere.center}fit(e,t){let n=this.content(),s=t?new C(...t):this.camera.position.clone().sub(this.controls.getTarget(new C));s.lengthSq()===0&&s.set(.6,.55,.8),s.normalize();let r=new C(0,1,0).cross(s);r.lengthSq()<1e-9&&r.set(1,0,0),r.normalize();let o=s.clone().cross(r),a=n.length>0?n.map(O=>new C(...O).sub(this.sphere.center)):AM(this.sphere.radius),{top:l,right:c,bottom:h,left:u}=this.insets(),m=2*Math.tan(td(this.width/this.height,this.field)*Math.PI/360)/this.height,g=Math.max(this.width-u-c,this.width/4)*m/2,y=Math.max(this.height-l-h,this.height/4)*m/2,p=a.map(O=>O.dot(r)),f=a.map(O=>O.dot(o)),x=a.map(O=>O.dot(s)),w=this.sphere.radius,M=0,v=0;for(let O=0;O<6;O+=1){w=0;for(let I=0;I<a.length;I+=1){let V=Math.max(Math.abs(p[I]-M)/g,Math.abs(f[I]-v)/y);w=Math.max(w,x[I]+V,x[I]+.02*this.sphere.radius)}let[P,D,k,W]=[1/0,-1/0,1/0,-1/0];for(let I=0;I<a.length;I+=1){let V=w-x[I];P=Math.min(P,(p[I]-M)/V),D=Math.max(D,(p[I]-M)/V),k=Math.min(k,(f[I]-v)/V),W=Math.max(W,(f[I]-v)/V)}M+=(P+D)/2*w,v+=(k+W)/2*w}w*=1.02;let b=(c-u)/2*m*w,_=(l-h)/2*m*w,T=this.sphere.center.clone().addScaledVector(r,M+b).addScaledVector(o,v+_);this.place({eye:T.clone().addScaledVector(s,w).toArray(),target:T.toArray()},e),this.fitted=this.wasInside=!0}pose(){let e=this.controls.getTarget(new C),t=this.controls.getPosition(new C).sub(e);return this.isParallel&&t.setLength(t.length()*Hm(this.field)+this.sphere.radius),t.add(e),{eye:t.toArray(),target:e.toArray()}}get isParallel(){return this.field===Vm}leaveParallel(){if(!this.isParallel)return;let e=this.pose();this.field=wc,this.shape(),this.place(e,!1)}place({eye:e,target:t},n){this.fitted=!1;let s=!n||matchMedia("(prefers-reduced-motion: reduce)").matches;this.controls.setLookAt(...e,...t,!s),s&&this.controls.update(0),this.invalidate()}look(e){this.leaveParallel(),this.fit(!0,e)}view(e){this.leaveParallel(),this.fit(!1,e)}lookAlong(e){this.field=Vm,this.shape(),this.fit(!1,e)}orbit(e,t){this.fitted=!1,this.leaveParallel(),this.controls.rotate(e,t,!0),this.wake()}pan(e,t){this.fitted=!1;let n=this.pixelAt(this.controls.getTarget(new C));this.controls.truck(-e*n,-t*n,!0),this.wake()}onWheel(e){e.preventDefault();let t=e.deltaMode===1?16:1,{x:n,y:s}=this.local(e);this.zoom(n,s,Math.exp(Math.max(-1,Math.min(1,e.deltaY*t*.0016))))}zoom(e,t,n){let s=this.controls.getTarget(new C),r=this.controls.getPosition(new C),o=r.distanceTo(s)*n*Hm(this.field);if(o<this.sphere.radius*.001||o>this.sphere.radius*60)return;let a=this.ray(e,t),l=this.under(e,t),c;if(l)c=l;else{let h=s.clone().sub(r).normalize(),u=a.direction.dot(h);c=a.origin.clone().addScaledVector(a.direction,s.clone().sub(a.origin).dot(h)/u)}r.sub(c).multiplyScalar(n).add(c),s.sub(c).multiplyScalar(n).add(c),this.place({eye:r.toArray(),target:s.toArray()},!1),this.onRest()}under=()=>null;local(e){let t=this.canvas.getBoundingClientRect();return{x:e.clientX-t.left,y:e.clientY-t.top}}project(e){let t=new C(...e).project(this.camera);return{x:(t.x+1)/2*this.width,y:(1-t.y)/2*this.height,visible:t.z<1}}ray(e,t){let n=new Yi;return n.setFromCamera(new He(e/this.width*2-1,1-t/this.height*2),this.camera),n.ray}pixelAt(e){let t=this.camera.getWorldDirection(new C),n=e.clone().sub(this.camera.position).dot(t);return 2*Math.max(n,1e-9)*Math.tan(this.camera.fov*Math.PI/360)/this.height}onPlane(e,t,n,s){let{origin:r,direction:o}=this.ray(e,t),a=o.dot(s);if(Math.abs(a)<1e-6)return null;let l=n.clone().sub(r).dot(s)/a;return l<=0||l>60*this.sphere.radius+r.distanceTo(n)?null:r.clone().addScaledVector(o,l)}allInside(){return this.content().every(e=>{let{x:t,y:n,visible:s}=this.project(e);return s&&t>=0&&n>=0&&t<=this.width&&n<=this.height})}rememberWhetherAllIsSeen(){this.camera.updateMatrixWorld(),this.wasInside=this.allInside()}},td=(i,e)=>i>=1?e:Math.atan(Math.tan(e*Math.PI/360)/i)*360/Math.PI,Hm=i=>Math.tan(i*Math.PI/360)/Math.tan(wc*Math.PI/360),AM=i=>[-1,1].flatMap(e=>[-1,1].map(t=>new C(e*i*.7,0,t*i*.7)));function CM(i){let e=i.getContext("webgl2",{antialias:!0,alpha:!0,powerPreference:"high-performance"});if(!e)return null;let t=new rc({canvas:i,context:e,antialias:!0,alpha:!0});return t.setClearColor(0,0),t.toneMapping=mo,t.toneMappingExposure=1,t.debug.checkShaderErrors=!1,t}var Ii=i=>Array.isArray(i)?i:[],pn=i=>Ii(i.cables),Bo=(i,e)=>Ii(Ii(i.boundaries)[e]);function pi(i,{boundary:e=0,from:t,to:n}){let s=Bo(i,e).length;if(!(t<s&&n<s&&t>=0&&n>=0))return[];let r=[t];for(;r.at(-1)!==n&&r.length<=s;)r.push((r.at(-1)+1)%s);return r}var Ac=(i,e,t)=>pn(i).findIndex(({along:n})=>n&&(n.boundary??0)===e&&pi(i,n).slice(0,-1).includes(t)),br=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],id=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Tc=i=>Math.hypot(...i);function RM(i,e){let t=Bo(i,e.boundary??0);return pi(i,e).map(n=>je(t[n])??[0,0,0])}function PM(i,e){let t=RM(i,e);return t.slice(1).reduce((n,s,r)=>n+Tc(br(s,t[r])),0)}function IM(i,e){let t=e.boundary??0,n=Bo(i,t).map(o=>je(o)??[0,0,0]),s=n.length,r=(o,a,l)=>{let[c,h]=[br(n[a],n[o]),br(n[l],n[o])],u=Tc(c)*Tc(h);return u>0?Math.acos(Math.min(1,Math.max(-1,id(c,h)/u))):Math.PI};return!n[e.from]||!n[e.to]?Math.PI:Math.min(r(e.from,e.to,(e.from+s-1)%s),r(e.to,e.from,(e.to+1)%s))}function LM(i,e){let t=Bo(i,e.boundary??0).map(a=>je(a)??[0,0,0]),[n,s]=[t[e.from],t[e.to]];if(!n||!s)return 1/0;let r=pi(i,e),o=[.25,.5,.75].map(a=>[n[0]+a*(s[0]-n[0]),n[1]+a*(s[1]-n[1]),n[2]+a*(s[2]-n[2])]);return Math.min(...t.flatMap((a,l)=>{let c=(l+1)%t.length;return r.includes(l)||r.includes(c)?[]:o.map(h=>OM(h,a,t[c]))}))}function OM(i,e,t){let[n,s]=[br(t,e),br(i,e)],r=Math.min(1,Math.max(0,id(n,s)/(id(n,n)||1)));return Tc(br(s,[r*n[0],r*n[1],r*n[2]]))}var Gm=.1,DM=.4,NM=.4;function UM(i,e,t){let n=Math.min(Gm,Math.max(NM*LM(i,e)/t,Gm/100)),s=Math.min(DM*IM(i,e),Math.PI/2);return Math.max(1/(8*n)+n/2,1/(2*Math.sin(Math.max(s,.001))))}var nd=i=>Number(i.toPrecision(2)),Wm=i=>Number(i.toPrecision(4));function Xm(i){return(Array.isArray(i.layers)?i.layers:[i.film]).reduce((t,n)=>t+(Number(n?.tension)||Math.max(Number(n?.warp)||0,Number(n?.weft)||0)),0)||1}function Fo(i,e,t){let n=PM(i,e)||1,s=UM(i,e,n),r=2*s*Math.asin(1/(2*s));return t==="force_density"?nd(Xm(i)*s/r):t==="length"?Wm(r*n):t==="unstressed_length"?Wm(r*n/1.01):nd(t==="sag"?(s-Math.sqrt(s*s-.25))*n:Xm(i)*s*n)}function sd(i,e,t,n){let s=pn(i),r={boundary:e,from:t,to:n},o=pi(i,r).slice(0,-1),a=s.at(-1),l=s.filter(u=>!u.along||(u.along.boundary??0)!==e||!pi(i,u.along).slice(0,-1).some(d=>o.includes(d))),c=a?.along?a.mode??"force":"force",h=Fo(i,r,c);return l.push({along:r,mode:c,value:h,...c==="unstressed_length"&&{axial_stiffness:100*Fo(i,r,"force")}}),i.cables=l,l.length-1}var rd=i=>Ii(i.boundaries).flatMap((e,t)=>Ii(e).flatMap((n,s)=>Ac(i,t,s)<0?[[t,s]]:[]));function qm(i){for(let[e,t]of rd(i))sd(i,e,t,(t+1)%Bo(i,e).length)}function $m(i,e){pn(i).splice(e,1)}function od(i){let e=Ii(i.supports);return{stretches:[...pn(i),...e].flatMap(({along:t})=>t?[t]:[]),points:[...Ii(i.free_points),...e.flatMap(({point:t})=>t?[t]:[])]}}function Ym(i,e,t){let{stretches:n,points:s}=od(i);for(let r of n.filter(o=>(o.boundary??0)===e))r.from>t&&(r.from+=1),r.to>t&&(r.to+=1);for(let r of s)(r.boundary??0)===e&&r.point>t&&(r.point+=1)}function Jm(i,e,t,n){let{stretches:s,points:r}=od(i),o=new Set;for(let a of s.filter(l=>(l.boundary??0)===e)){a.from===t&&a.to===(t+1)%(n+1)&&o.add(a);let l=a.to>=t?a.to-1:a.to;a.from=(a.from>t?a.from-1:a.from)%Math.max(n,1),a.to=(l+n)%Math.max(n,1),a.from===a.to&&o.add(a)}for(let a of r.filter(l=>(l.boundary??0)===e))a.point===t?o.add(a):a.point>t&&(a.point-=1);Km(i,o)}function Zm(i,e){let{stretches:t,points:n}=od(i),s=new Set([...t,...n].filter(r=>(r.boundary??0)===e));for(let r of[...t,...n])(r.boundary??0)>e&&(r.boundary=(r.boundary??0)-1);for(let r of Ii(i.supports))r.boundary===e?s.add(r):(r.boundary??-1)>e&&(r.boundary-=1);Km(i,s)}function Km(i,e){let t=n=>!e.has(n)&&!e.has(n.along)&&!e.has(n.point);for(let n of["cables","supports","free_points"])Array.isArray(i[n])&&(i[n]=Ii(i[n]).filter(t))}var Cc={arc:3,rectangle:2,circle:2},jm=["rectangle","circle"],Qm=32,FM=6,BM=(i,e,t)=>i.map((n,s)=>n+t*(e[s]-n)),ad=i=>i.map(e=>Number(e.toPrecision(10)));function ld(i,e,t,n){let[s,r]=t===2?[0,1]:[0,2],[o,a,l]=e;if(i==="curve"&&e.length>2)return zM(e,n).map(ad);if(i==="rectangle"&&o&&a){let[c,h]=[[...o],[...a]];return c[s]=a[s],h[s]=o[s],h[t]=o[t],[o,c,[...a],h]}return i==="circle"&&o&&a?eg(o,s,r,Math.atan2(a[r]-o[r],a[s]-o[s]),2*Math.PI,Math.hypot(a[s]-o[s],a[r]-o[r]),Qm).slice(0,-1).map(ad):i==="arc"&&o&&a&&l?kM(o,a,l,s,r).map(ad):e}var eg=(i,e,t,n,s,r,o)=>Array.from({length:o+1},(a,l)=>{let c=[...i];return c[e]=i[e]+r*Math.cos(n+s*l/o),c[t]=i[t]+r*Math.sin(n+s*l/o),c});function kM(i,e,t,n,s){let[r,o,a,l]=[e[n]-i[n],e[s]-i[s],t[n]-i[n],t[s]-i[s]],c=2*(r*l-o*a);if(Math.abs(c)<1e-9*(r*r+o*o+a*a+l*l))return[i,e,t];let[h,u]=[r*r+o*o,a*a+l*l],[d,m]=[(l*h-o*u)/c,(r*u-a*h)/c],g=[...i];g[n]=i[n]+d,g[s]=i[s]+m;let y=b=>Math.atan2(b[s]-g[s],b[n]-g[n]),p=2*Math.PI,f=y(i),x=((y(t)-f)%p+p)%p,w=c>0?x:x-p,M=Math.max(4,Math.ceil(Qm*Math.abs(w)/p)),v=3-n-s;return eg(g,n,s,f,w,Math.hypot(d,m),M).map((b,_)=>(b[v]=i[v]+(t[v]-i[v])*_/M,_===0?i:_===M?t:b))}function zM(i,e,t=FM){let n=i.length,s=o=>e?i[(o+n)%n]:i[o]??BM(i[o<0?1:n-2],i[o<0?0:n-1],2);return[...Array.from({length:e?n:n-1},(o,a)=>{let[l,c,h,u]=[s(a-1),s(a),s(a+1),s(a+2)],d=(p,f)=>Math.sqrt(Math.hypot(...p.map((x,w)=>f[w]-x))),m=d(c,h)||1,[g,y]=[d(l,c)||m,d(h,u)||m];return Array.from({length:t},(p,f)=>c.map((x,w)=>{let[M,v,b,_]=[f/t,l[w],h[w],u[w]],T=b-x,[O,P]=[T+m*((x-v)/g-(b-v)/(g+m)),T+m*((_-b)/y-(_-x)/(m+y))];return x+M*(O+M*(3*T-2*O-P+M*(O+P-2*T)))}))}).flat(),...e?[]:[i.at(-1)]]}var bn={point:11,touch:24,edge:8,handle:10,snap:12,align:7},Rc=4,VM="Pull this corner up",HM=12,GM=52,Pc=class{constructor(e){this.host=e;let{canvas:t}=e.stage;this.marquee=document.createElement("div"),this.marquee.className="marquee",this.marquee.hidden=!0,t.parentElement.append(this.marquee),t.addEventListener("pointerdown",n=>this.press(n),{capture:!0});for(let n of["pointermove","pointerup","pointercancel"])document.addEventListener(n,s=>{this.fingers.has(s.pointerId)&&(n==="pointermove"?this.fingers.set(s.pointerId,s):this.fingers.delete(s.pointerId))},{capture:!0});t.addEventListener("pointermove",n=>this.glide(n)),t.addEventListener("pointerleave",()=>{this.busy||(this.hover=null,this.ghost=null,this.next=null,(this.drawing||this.cabling)&&e.label(null),this.refresh())}),t.addEventListener("contextmenu",n=>n.preventDefault()),t.addEventListener("keydown",n=>this.key(n)),e.stage.beforeDraw=()=>this.hints()}host;selection=[];mode="ground";snapping=!0;shape="points";level=0;next=null;hover=null;ghost=null;prompting=!1;busy=!1;cabling=!1;rig="edge";cable=-1;measured=null;cableFrom=null;marquee;fingers=new Map;letGo=null;handingOver=!1;get mayCable(){return this.host.history.document.kind==="tensile_structure"&&!this.host.fixed}get measuring(){return this.measured!==null}get drawing(){return this.host.history.document.draft!==null}get only(){return this.selection.length===1?this.selection[0]:null}select(e){this.selection=e,this.prompting&&(this.prompting=!1,this.host.label(null)),e.length>0&&(this.cable=-1),this.refresh(),this.host.selectionChanged();let{only:t}=this,n=t&&this.host.lines[t.line];n&&this.host.announce(`${n.name}, point ${t.point+1} of ${n.points.length}: ${(je(n.points[t.point])??[]).map(s=>et(s,6)).join(", ")}`)}prune(){let{lines:e}=this.host;this.mayCable||this.stopCabling(),this.cable>=this.cables&&(this.cable=-1),this.cableFrom=null,this.selection=this.selection.filter(({line:t,point:n})=>n<(e[t]?.points.length??0)),this.hover=null,this.ghost=null}refresh(){let{sketch:e,stage:t,faulty:n}=this.host;e.mark(s=>s.line<0?4:Zn(this.cableFrom,s)||this.selection.some(r=>Zn(r,s))?2:n.has(`${s.line}/${s.point}`)?3:Zn(this.hover,s)?1:0),t.invalidate()}step(e){let{lines:t}=this.host,n=t.flatMap((r,o)=>r.points.map((a,l)=>({line:o,point:l})).filter(({point:a})=>Dr(r,a)));if(n.length===0)return;let s=n.findIndex(r=>Zn(r,this.selection.at(-1)??null));this.select([n[s<0?e>0?0:n.length-1:(s+e+n.length)%n.length]])}nearestPoint(e,t,n){let{stage:s,sketch:r,surface:o}=this.host,a=null;if(r.places.forEach((m,g)=>{if(r.refs[g].line<0)return;let y=s.project(m),p=Math.hypot(y.x-e,y.y-t);y.visible&&p<=n&&(!a||p<a.distance)&&(a={ref:r.refs[g],distance:p,place:m})}),!a)return null;let{ref:l,place:c}=a;if(this.selection.some(m=>Zn(m,l)))return l;let h=new C(...c),u=o.pick(s,s.project(c).x,s.project(c).y);return u&&u.distance<s.camera.position.distanceTo(h)-14*s.pixelAt(h)?null:l}nearestEdge(e,t,n=!1){let{stage:s,lines:r,frame:o}=this.host,a=null;return r.forEach((l,c)=>{if(as(l)||l.name.startsWith("control"))return;let h=l.points.map(je),u=l.closed&&h.length>2?h.length:h.length-1;for(let d=0;d<u;d+=1){let m=h[d],g=h[(d+1)%h.length];if(!m||!g)continue;let y=s.project(o.toScene(m)),p=s.project(o.toScene(g)),f=(p.x-y.x)**2+(p.y-y.y)**2;if(!y.visible||!p.visible||f<(n?1:900))continue;let x=((e-y.x)*(p.x-y.x)+(t-y.y)*(p.y-y.y))/f,w=n?Math.min(.9,Math.max(.1,x)):x,M=m.map((T,O)=>ns((T+g[O])/2)),v=s.project(o.toScene(M)),b=Math.hypot(v.x-e,v.y-t)<=bn.handle,_=b?0:Math.hypot(y.x+w*(p.x-y.x)-e,y.y+w*(p.y-y.y)-t);w<.08||w>.92||_>bn.edge||a&&_>=a.distance||(a={line:c,after:d,point:M,held:b,distance:_})}}),a}arrow(){let{only:e}=this,{stage:t,frame:n,lines:s}=this.host,r=e&&je(s[e.line]?.points[e.point]);if(!r||this.drawing||this.cabling||this.measured)return null;let o=new C(...n.toScene(r)),a=GM*t.pixelAt(o);return{from:o,to:o.clone().addScaledVector(this.liftAxis(),a)}}liftAxis(){let{camera:e}=this.host.stage,t=e.getWorldDirection(new C);return Math.abs(t.y)>.94?new C(0,1,0).applyQuaternion(e.quaternion):new C(0,1,0)}onArrow(e,t){let n=this.arrow();if(!n)return!1;let s=this.host.stage.project(n.from.toArray()),r=this.host.stage.project(n.to.toArray()),o=Math.hypot(r.x-s.x,r.y-s.y);if(o<12)return!1;let a=((e-s.x)*(r.x-s.x)+(t-s.y)*(r.y-s.y))/(o*o),l=Math.abs((e-s.x)*(r.y-s.y)-(t-s.y)*(r.x-s.x))/o;return a>.35&&a<1.25&&l<11}glide(e){if(this.busy||e.buttons!==0||this.host.fixed)return;let{stage:t,host:n}={stage:this.host.stage,host:this.host},{x:s,y:r}=t.local(e);if(this.drawing){this.next=this.snap(s,r,e.altKey),this.showNext(s,r),t.canvas.style.cursor="crosshair",t.invalidate();return}if(this.measured){this.hover=this.nearestPoint(s,r,bn.point),this.ghost=null,t.canvas.style.cursor="crosshair",this.refresh();return}if(this.cabling){this.hover=this.nearestPoint(s,r,bn.point),this.ghost=this.hover?null:this.nearestEdge(s,r,!0),t.canvas.style.cursor=this.hover||this.ghost?"pointer":"",this.refresh();return}let o=this.onArrow(s,r),a=o?null:this.nearestPoint(s,r,bn.point),l=o||a?null:this.nearestEdge(s,r),c=!Zn(a,this.hover)||JSON.stringify(l)!==JSON.stringify(this.ghost);this.hover=a,this.ghost=l,t.canvas.style.cursor=o?"ns-resize":a?"grab":l?.held?"copy":"",c&&(this.refresh(),n.selectionChanged())}press(e){let{stage:t,host:n}={stage:this.host.stage,host:this.host};if(this.handingOver)return;t.canvas.focus({preventScroll:!0});let s=e.pointerType==="touch";if(s&&this.fingers.set(e.pointerId,e),this.fingers.size>1){this.letGo?.();return}if(e.button!==0||this.busy||this.host.fixed)return;let r=t.local(e);if(this.drawing){this.onRelease(e,(l,c,h,u)=>{h<=Rc&&this.place(this.snap(l,c,u.altKey))});return}if(this.measured){this.onRelease(e,(l,c,h)=>{h<=Rc&&this.measureAt(l,c)});return}if(this.cabling){this.onRelease(e,(l,c,h)=>{h<=Rc&&this.clickCable(l,c,s)});return}if(this.onArrow(r.x,r.y)){this.drag(e,this.only,"height");return}let o=this.nearestPoint(r.x,r.y,s?bn.touch:bn.point);if(o){this.drag(e,o,this.mode);return}let a=s?null:this.nearestEdge(r.x,r.y);if(a?.held&&!e.shiftKey){n.history.begin(),this.insertAt(a.line,a.after,a.point),n.changed(!0),this.drag(e,{line:a.line,point:a.after+1},this.mode);return}if(e.shiftKey){this.selectBox(e);return}this.onRelease(e,(l,c,h)=>{if(h>Rc)return;let u=n.surface.pickLine(t,l,c),d=n.surface.pick(t,l,c),m=t.camera.position,g=u&&d&&d.distance<.98*m.distanceTo(u.point);u&&!g?n.readLine(u.point,u.value,l,c):d?n.read(d.point,d.face,l,c):(n.label(null),this.selection.length>0&&this.select([]))})}onRelease(e,t){let{stage:n}=this.host,s=n.local(e),r=0,o=c=>{let{x:h,y:u}=n.local(c);r=Math.max(r,Math.hypot(h-s.x,u-s.y))},a=()=>{document.removeEventListener("pointermove",o),document.removeEventListener("pointerup",l),document.removeEventListener("pointercancel",l),this.letGo=null},l=c=>{if(c.pointerId!==e.pointerId)return;a();let{x:h,y:u}=n.local(c);c.type==="pointerup"&&t(h,u,r,c)};document.addEventListener("pointermove",o),document.addEventListener("pointerup",l),document.addEventListener("pointercancel",l),this.letGo=a}seize(e,t,n,s=()=>{}){let{stage:r}=this.host;this.busy=!0,r.controls.enabled=!1,e.preventDefault();try{r.canvas.setPointerCapture(e.pointerId)}catch{}let o=c=>{c.pointerId===e.pointerId&&t(c)},a=()=>{document.removeEventListener("pointermove",o),document.removeEventListener("pointerup",l),document.removeEventListener("pointercancel",l),this.busy=!1,this.letGo=null,r.controls.enabled=!0},l=c=>{c.pointerId===e.pointerId&&(a(),n(c))};document.addEventListener("pointermove",o),document.addEventListener("pointerup",l),document.addEventListener("pointercancel",l),this.letGo=()=>{a(),s(),this.handOver(this.fingers.get(e.pointerId)??e)}}handOver({pointerId:e,pointerType:t,clientX:n,clientY:s}){this.handingOver=!0;let r={pointerId:e,pointerType:t,clientX:n,clientY:s,button:0,buttons:1,isPrimary:!0,bubbles:!0,cancelable:!0};this.host.stage.canvas.dispatchEvent(new PointerEvent("pointerdown",r)),this.handingOver=!1}drag(e,t,n){let{host:s}=this,{stage:r,history:o,frame:a}=s,l=s.lines[t.line].points[t.point],c=je(l);if(!c)return;let h=this.selection.some(x=>Zn(x,t)),u=this.selection;h||this.select([t]),this.prompting=!1;let d=this.selection.map(x=>({ref:x,from:je(s.lines[x.line].points[x.point])??c})),m=new C(...a.toScene(c)),g=r.project(m.toArray()),y=r.local(e),p={x:y.x-g.x,y:y.y-g.y},f=!1;o.begin(),this.seize(e,x=>{let{x:w,y:M}=r.local(x);if(!f&&Math.hypot(w-y.x,M-y.y)<2)return;f=!0;let v=n==="height"!==x.shiftKey,b=v?this.raised(m,M-y.y):this.grounded(m,w-p.x,M-p.y);if(!b)return;let _=this.rounded(b,c);!v&&this.snapping&&!x.altKey&&(_=this.onto(w,M,d.map(P=>P.ref))??_);for(let{ref:P,from:D}of d)this.write(P,D.map((k,W)=>ns(k+_[W]-c[W])));let T=r.project(a.toScene(_)),O=en(o.document.request);s.label(v?`${"xyz"[a.up]} ${et(_[a.up],6)} ${O}`:_.map((P,D)=>`${"xyz"[D]} ${et(P,6)}`).join("  "),T.x,T.y),this.lifting=v,s.changed(!0)},x=>{this.lifting=!1,s.label(null),!f&&x.type==="pointerup"&&(e.shiftKey?this.select(h?u.filter(w=>!Zn(w,t)):[...u,t]):this.select([t])),o.commit()&&(s.changed(!1),this.tellMoved())},()=>{this.lifting=!1,s.label(null),o.abandon(),f&&s.changed(!1)})}lifting=!1;selectBox(e){let{stage:t,sketch:n}=this.host,s=t.local(e),r=this.selection,{style:o}=this.marquee;this.seize(e,a=>{let{x:l,y:c}=t.local(a),[h,u,d,m]=[Math.min(l,s.x),Math.min(c,s.y),Math.max(l,s.x),Math.max(c,s.y)];this.marquee.hidden=!1,Object.assign(o,{left:`${h}px`,top:`${u}px`,width:`${d-h}px`,height:`${m-u}px`});let g=n.refs.filter((y,p)=>{let f=t.project(n.places[p]);return y.line>=0&&f.visible&&f.x>=h&&f.x<=d&&f.y>=u&&f.y<=m});this.selection=[...r,...g.filter(y=>!r.some(p=>Zn(p,y)))],this.refresh()},()=>{this.marquee.hidden=!0,this.select(this.selection)})}grounded(e,t,n){let{stage:s}=this.host,r=s.camera.getWorldDirection(new C);return s.onPlane(t,n,e,Math.abs(r.y)>.08?new C(0,1,0):r)}raised(e,t){let{stage:n}=this.host,s=new C(0,1,0).applyQuaternion(n.camera.quaternion).y;return e.clone().add(new C(0,-t*n.pixelAt(e)/Math.max(s,.35),0))}rounded(e,t){let{stage:n,frame:s}=this.host,r=10**Math.floor(Math.log10(s.length(n.pixelAt(e))*1.5)),o=s.fromScene(e.toArray()),a=1e-9*s.length(n.radius)+1e-12*Math.max(...t.map(Math.abs));return o.map((l,c)=>Math.abs(l-t[c])<=a?t[c]:ns(Math.round(l/r)*r))}onto(e,t,n){let{stage:s,sketch:r,lines:o}=this.host,a=r.refs.findIndex((c,h)=>{if(c.line<0||n.some(d=>d.line===c.line))return!1;let u=s.project(r.places[h]);return u.visible&&Math.hypot(u.x-e,u.y-t)<bn.snap}),l=r.refs[a];return l?je(o[l.line].points[l.point]):null}startMeasuring(){this.stopDrawing(),this.stopCabling(),this.measured=[],this.select([]),this.host.stage.canvas.focus({preventScroll:!0})}stopMeasuring(){this.measured&&(this.measured=null,this.host.label(null),this.host.stage.canvas.style.cursor="",this.refresh(),this.host.selectionChanged())}measureAt(e,t){let{stage:n,frame:s,lines:r,surface:o}=this.host,a=this.nearestPoint(e,t,bn.point),l=new C(0,n.grid.mesh.position.y,0),c=o.pick(n,e,t)?.point??n.onPlane(e,t,l,new C(0,1,0)),h=(a&&je(r[a.line].points[a.point]))??(c&&s.fromScene(c.toArray()));if(!h)return;this.measured=this.measured.length===1?[this.measured[0],h]:[h];let[u,d]=this.measured;if(u&&d){let m=d.map((p,f)=>p-u[f]),g=`${et(Math.hypot(...m),4)} ${en(this.host.history.document.request)}`,y=s.toScene(u.map((p,f)=>(p+d[f])/2));this.host.label(`${g} (${m.map((p,f)=>`${"xyz"[f]} ${et(Number(p.toPrecision(4)),4)}`).join(", ")})`,0,0,y),this.host.announce(g)}else this.host.label(null);this.refresh()}get cables(){return this.host.history.document.request.cables?.length??0}get hasBegun(){return this.cableFrom!==null}startCabling(e="edge"){this.mayCable&&(this.stopDrawing(),this.stopMeasuring(),this.cabling=!0,this.rig=e,this.cableFrom=null,this.cable=-1,this.select([]),this.host.selectionChanged())}stopCabling(){this.cabling&&(this.cabling=!1,this.cableFrom=null,this.ghost=null,this.host.label(null),this.host.stage.canvas.style.cursor="",this.host.selectionChanged())}chooseCable(e){this.selection=[],this.cable=e,this.refresh(),this.host.selectionChanged(),e>=0&&this.host.announce(`Cable ${e+1} of ${this.cables}`)}clickCable(e,t,n){let{stage:s,frame:r}=this.host,o=this.nearestPoint(e,t,n?bn.touch:bn.point),a=o||this.rig!=="edge"?null:this.nearestEdge(e,t,!0),l=o?null:s.onPlane(e,t,new C(0,s.grid.mesh.position.y,0),new C(0,1,0));this.takeForCable(o,a,l&&r.fromScene(l.toArray()))}takeForCable(e,t,n){let s=e&&!this.host.lines[e.line].only?e:null,r=this.cableFrom;if(this.rig!=="edge")this.cableFrom=r||this.rig==="mast"||this.rig==="hold"?null:s,this.cableFrom===null&&this.host.rig(r??s,s,n),this.refresh(),this.host.selectionChanged();else if(s&&r&&r.line===s.line&&r.point!==s.point)this.makeCable(s.line,...this.ordered(r,s.point));else if(s)this.cableFrom=Zn(r,s)?null:s,this.refresh(),this.host.selectionChanged();else if(t){let o=Ac(this.host.history.document.request,t.line,t.after);o>=0?this.chooseCable(o):this.makeCable(t.line,t.after,(t.after+1)%this.host.lines[t.line].points.length)}else this.cableFrom=null,this.chooseCable(-1)}ordered({line:e,point:t},n){let s=this.host.lines[e].points.length;return(n-t+s)%s<=s/2?[t,n]:[n,t]}makeCable(e,t,n){let s=-1;this.cableFrom=null,this.host.history.edit(({request:o})=>{s=sd(o,e,t,n)})&&this.host.changed(!1),this.chooseCable(s)}cableFromPoint(){let{only:e}=this;if(!e||!this.mayCable)return;let t=Ac(this.host.history.document.request,e.line,e.point);t>=0?this.chooseCable(t):this.makeCable(e.line,e.point,(e.point+1)%this.host.lines[e.line].points.length)}dropCable(){let{cable:e}=this;if(e<0)return;let t=this.host.history.edit(({request:n})=>$m(n,e));this.cable=-1,t&&this.host.changed(!1),this.host.selectionChanged()}cableHint(){let{lines:e,frame:t,history:n}=this.host,{cableFrom:s,hover:r,ghost:o}=this,a=e[r?.line??o?.line??-1];if(!a)return[];let l=d=>t.toScene(je(a.points[d])??[0,0,0]),c=d=>d.slice(1).flatMap((m,g)=>[l(d[g]),l(m)]);if(o)return c([o.after,(o.after+1)%a.points.length]);if(!s||s.line!==r.line||s.point===r.point)return[];let[h,u]=this.ordered(s,r.point);return c(pi(n.document.request,{boundary:s.line,from:h,to:u}))}write({line:e,point:t},n){let{points:s}=this.host.lines[e],r=s[t],o=this.mayCable&&je(r);Array.isArray(r)?r.splice(0,Math.max(3,r.length),...n):s[t]=n,o&&this.host.moved(o,n)}moveBy(e){let{history:t}=this.host;t.edit(()=>{for(let s of this.selection){let r=je(this.host.lines[s.line].points[s.point]);r&&this.write(s,r.map((o,a)=>ns(o+e[a])))}})&&(this.host.changed(!1),this.tellMoved())}tellMoved(){let{only:e,host:t}=this,n=e&&t.lines[e.line],s=n&&je(n.points[e.point]);n&&s?t.announce(`${n.name}, point ${e.point+1}: moved to ${s.map(r=>et(r,6)).join(", ")} ${en(t.history.document.request)}`):this.selection.length>0&&t.announce(`${this.selection.length} points moved`)}setAxis(e,t){this.host.history.edit(()=>{for(let s of this.selection){let r=je(this.host.lines[s.line].points[s.point])??[0,0,0];r[e]=t,this.write(s,r)}})&&(this.host.changed(!1),this.tellMoved())}edgeBefore(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t||as(t)||t.points.length<2)return null;let n=e.point>0?e.point-1:t.closed?t.points.length-1:-1,s=je(t.points[e.point]),r=je(t.points[n]);return s&&r?{length:Math.hypot(...s.map((o,a)=>o-r[a])),previous:r,point:s}:null}setEdgeBefore(e){let t=this.edgeBefore(),{only:n}=this;if(!t||!n||!(e>0)||t.length===0)return;let s=t.previous.map((r,o)=>ns(r+(t.point[o]-r)*e/t.length));this.host.history.edit(()=>this.write(n,s))&&(this.host.changed(!1),this.tellMoved())}companions(e){let{request:t}=this.host.history.document,{points:n,path:s}=this.host.lines[e];return s[0]!=="directrices"?[]:["normals","tangents"].flatMap(r=>{let o=t[r]?.[s[1]];return Array.isArray(o)&&o.length===n.length?[o]:[]})}insertAt(e,t,n){this.companions(e).forEach(s=>s.splice(t+1,0,structuredClone(s[t]))),this.mayCable&&Ym(this.host.history.document.request,e,t),this.host.lines[e].points.splice(t+1,0,n),this.selection=[{line:e,point:t+1}]}insert(){let{only:e}=this,t=e&&this.host.lines[e.line];if(!t||t.only)return;let n=je(t.points[e.point]),s=je(t.points[e.point+1])??(t.closed?je(t.points[0]):null);if(!n)return;let r=je(t.points[e.point-1])??n.map((a,l)=>a-(l===0?1:0)),o=n.map((a,l)=>ns(s?(a+s[l])/2:2*a-r[l]));this.host.history.edit(()=>this.insertAt(e.line,e.point,o))&&this.host.changed(!1),this.select(this.selection)}remove(){let{host:e}=this,{only:t}=this,n=(t&&e.lines[t.line]?.path)??[],s=ls(e.history.document.request,n.slice(0,1));if(n.length===3&&Array.isArray(s)&&this.mayCable){e.history.edit(()=>s.splice(Number(n[1]),1)),this.selection=[],e.changed(!1),this.select([]);return}if(this.selection.length===0||this.selection.some(a=>e.lines[a.line]?.only))return;let[r]=this.selection;e.history.edit(()=>{let a=[...this.selection].sort((l,c)=>c.line-l.line||c.point-l.point);for(let{line:l,point:c}of a)this.letGoOf(l,[c]),this.companions(l).forEach(h=>h.splice(c,1)),e.lines[l].points.splice(c,1),this.mayCable&&Jm(e.history.document.request,l,c,e.lines[l].points.length);for(let l=e.lines.length-1;l>=0;l-=1)e.lines[l].points.length===0&&this.dropLine(l)}),this.selection=[],e.changed(!1);let o=e.lines[r.line]?.points.length??0;this.select(o>0&&o>1?[{line:r.line,point:Math.min(r.point,o-1)}]:[])}removeLine(){let{host:e}=this,t=[...new Set(this.selection.map(n=>n.line))].sort((n,s)=>s-n);t.length===0||t.some(n=>e.lines[n]?.only)||(e.history.edit(()=>t.forEach(n=>this.dropLine(n))),this.selection=[],e.changed(!1),this.select([]))}letGoOf(e,t){let n=this.mayCable?t.map(s=>je(this.host.lines[e].points[s])):[];for(let s of n)s&&this.host.moved(s,null)}dropLine(e){let{request:t}=this.host.history.document,{path:n,points:s}=this.host.lines[e];this.letGoOf(e,s.map((a,l)=>l));let r=ls(t,n.slice(0,-1)),o=n.at(-1);if(Array.isArray(r)?r.splice(Number(o),1):delete r[o],this.mayCable&&Zm(t,e),n[0]==="directrices")for(let a of["normals","tangents"])Array.isArray(t[a])&&t[a].splice(Number(o),1)}startDrawing(){let{history:e,stage:t,lines:n,frame:s}=this.host;if(this.drawing||kt[e.document.kind].lines.length===0)return;this.stopCabling(),this.stopMeasuring(),this.shapes.includes(this.shape)||(this.shape="points"),e.edit(a=>{a.draft=[]}),this.select([]);let r=n.flatMap(a=>a.points.map(l=>je(l)?.[s.up]??1/0));this.level=r.length>0?Math.min(...r):s.origin[s.up],this.next=null;let o=t.camera.getWorldDirection(new C);Math.abs(o.y)<.3&&t.look([.25,1.2,.6]),this.host.changed(!1),t.canvas.focus({preventScroll:!0})}stopDrawing(){this.drawing&&(this.host.history.edit(e=>{e.draft=null}),this.endLine())}get least(){return Cc[this.shape]??kt[this.host.history.document.kind].least}get shapes(){return["points","curve","arc","rectangle","circle"].filter(e=>kt[this.host.history.document.kind].line!=="rail"||!jm.includes(e))}place(e){if(!e)return;if(e.close){this.finishDrawing();return}let{history:t}=this.host,n=t.document.draft.length+1===Cc[this.shape];n&&t.begin(),t.edit(s=>{s.draft.push(e.point)}),n?(this.finishDrawing(),t.commit()):this.host.changed(!1)}finishDrawing(){let{host:e}=this,{history:t}=e,{draft:n,kind:s}=t.document;if(!n||n.length<this.least)return!1;let r=ld(this.shape,n,e.frame.up,kt[s].line!=="rail");return t.edit(o=>{let{kind:a,request:l}=o,{lines:c}=kt[a];if(o.draft=null,a==="uniform_mesh"){let h=l.domain??={};!h.polygon&&!h.boundaries&&!h.bezier&&!h.nurbs?h.polygon=r:(h.polygon?h.holes??=[]:h.boundaries??=[]).push(r)}else(l[c[0]]??=[]).push(r)}),this.endLine(),this.askForLift(),!0}endLine(){let{host:e}=this;this.next=null,e.label(null),e.stage.canvas.style.cursor="",e.stage.canvas.focus({preventScroll:!0}),e.changed(!1)}askForLift(){let{host:e}=this,{kind:t}=e.history.document,[n,...s]=e.lines,r=n?.points.map(je)??[],o=e.frame.up;if(!n||s.length>0||r.length>HM||t!=="minimal_surface"&&t!=="tensile_structure"||r.some(c=>c?.[o]!==r[0]?.[o]))return;let a=e.stage.camera.position,l=r.map(c=>a.distanceTo(new C(...e.frame.toScene(c??[0,0,0]))));this.select([{line:0,point:l.indexOf(Math.min(...l))}]),this.prompting=!0,e.stage.invalidate()}enter(e){let t=this.host.history.document.draft;if(!t)return null;let n=t.at(-1)??null,s=e.replace(/^@/,"").trim().split(/[\s,;]+/).map(Number);if(s.length>3||s.some(h=>!Number.isFinite(h))||e.trim()==="")return"Type a length, or x, y, z.";let{up:r}=this.host.frame,[o,a]=r===2?[0,1]:[0,2];if(s.length===1){if(!n)return"The first point needs x, y, z.";let h=this.next?.point??null,u=h?h.map((m,g)=>m-n[g]):[1,0,0],d=Math.hypot(...u);return d===0?"Point into a direction first.":(this.place({point:n.map((m,g)=>ns(m+u[g]/d*s[0])),how:"",close:!1}),null)}let l=[0,0,0],c=e.trim().startsWith("@")?n??[0,0,0]:[0,0,0];return l[o]=c[o]+s[0],l[a]=c[a]+s[1],l[r]=s.length===3?c[r]+s[2]:e.trim().startsWith("@")?c[r]:this.level,r===1&&s.length===3&&l.splice(0,3,...c.map((h,u)=>h+s[u])),this.place({point:l,how:"",close:!1}),null}snap(e,t,n){let{stage:s,sketch:r,lines:o,frame:a,history:l}=this.host,c=l.document.draft??[],h=c.length>=this.least&&!Cc[this.shape]&&kt[l.document.kind].line!=="rail"?c[0]:null;if(h){let w=s.project(a.toScene(h));if(Math.hypot(w.x-e,w.y-t)<bn.snap)return{point:h,how:"closes the loop",close:!0}}if(!n&&this.snapping){let w=r.refs.findIndex((b,_)=>{let T=s.project(r.places[_]);return b.line>=0&&T.visible&&Math.hypot(T.x-e,T.y-t)<bn.snap}),M=r.refs[w],v=M&&je(o[M.line].points[M.point]);if(v)return{point:v,how:"on a point",close:!1}}let u=[...a.origin];u[a.up]=this.level;let d=s.onPlane(e,t,new C(...a.toScene(u)),new C(0,1,0));if(!d)return null;let m=a.fromScene(d.toArray());m[a.up]=this.level;let g=a.length(s.pixelAt(d)),y=a.up===2?[0,1]:[0,2],p=10**Math.floor(Math.log10(g*1.5)),f=[1,2,5,10,20,50].map(w=>w*p).find(w=>w>=9*g)??p,x="";for(let w of y){let M=m[w],v=n||!this.snapping?void 0:[c.at(-1),c[0]].find(b=>b&&Math.abs(b[w]-M)<bn.align*g);if(v)m[w]=v[w],x="in line";else{let b=n||!this.snapping?p:f;m[w]=ns(Math.round(M/b)*b)}}return{point:m,how:x,close:!1}}showNext(e,t){let{host:n}=this,{next:s}=this,{draft:r,request:o}=n.history.document;if(!s||!r){n.label(null);return}let a=r.at(-1),l=s.point.map(h=>et(h,6)).join(", "),c=a?Math.hypot(...s.point.map((h,u)=>h-a[u])):0;n.label([a?`${et(c,4)} ${en(o)}`:l,s.how].filter(Boolean).join(" · "),e,t)}hints(){let{sketch:e,stage:t,frame:n,history:s,lines:r}=this.host,o=Math.tan(t.camera.fov*Math.PI/360);e.setPixel(2*o/t.height,t.renderer?.getPixelRatio()??1);let a=[],l=[],c=[],h=null,{draft:u}=s.document;if(u&&this.next){let m=n.toScene(this.next.point);h=m;let g=kt[s.document.kind].line!=="rail";if(u.length>0&&this.shape==="points"&&a.push(n.toScene(u.at(-1)),m),u.length>1&&g&&this.shape==="points"&&l.push(m,n.toScene(u[0])),u.length>0&&this.shape!=="points"){let y=ld(this.shape,[...u,this.next.point],n.up,g).map(f=>n.toScene(f)),p=g?[...y,y[0]]:y;a.push(...p.slice(1).flatMap((f,x)=>[p[x],f]))}}else if(this.measured){let m=this.measured.map(g=>n.toScene(g));m.length===1?h=m[0]:c.push(...m)}else this.cabling?a.push(...this.cableHint()):this.ghost&&!this.busy&&(h=n.toScene(this.ghost.point));let d=this.arrow();if(this.prompting&&!d&&(this.prompting=!1,this.host.label(null)),d){let m=d.to.toArray(),g=new C(1,0,0).applyQuaternion(t.camera.quaternion),y=d.from.distanceTo(d.to),p=d.to.clone().addScaledVector(d.to.clone().sub(d.from),-.24);this.prompting&&this.host.label(VM,0,0,m),c.push(d.from.toArray(),m);for(let M of[-1,1])c.push(p.clone().addScaledVector(g,M*.14*y).toArray(),m);let{only:f}=this,x=je(r[f.line].points[f.point]),w=[...n.toScene(x)];w[1]=t.grid.mesh.position.y,(this.lifting||Math.abs(w[1]-d.from.y)>y*.3)&&l.push(d.from.toArray(),w)}e.hint({segments:a,faint:l,lift:c,ghost:h})}key(e){let{stage:t,frame:n,lines:s}=this.host;if(e.ctrlKey||e.metaKey){if(e.key!=="a")return;this.select(s.flatMap((u,d)=>u.points.map((m,g)=>({line:d,point:g})).filter(({point:m})=>Dr(u,m)))),e.preventDefault();return}let r=this.selection.length>0&&!this.drawing,o=n.up===2?[0,1]:[0,2],a=n.up===2?1:-1,l={ArrowLeft:[o[0],-1],ArrowRight:[o[0],1],ArrowUp:[o[1],a],ArrowDown:[o[1],-a],PageUp:[n.up,1],PageDown:[n.up,-1]},c={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,-1],ArrowDown:[0,1]},h=l[e.key];if(r&&h){let u=10**Math.round(Math.log10(n.length(t.pixelAt(t.centre))*10))*(e.shiftKey?10:1),d=[0,0,0];d[h[0]]=h[1]*u,this.moveBy(d)}else if(c[e.key]){let[u,d]=c[e.key];e.shiftKey?t.pan(-24*u,-24*d):t.orbit(.12*u,.12*d)}else if(this.cabling&&e.key==="Enter"&&this.only)this.takeForCable(this.only,null,null);else if(this.cable>=0&&(e.key==="Delete"||e.key==="Backspace"))this.dropCable();else if(r&&(e.key==="Delete"||e.key==="Backspace"))this.remove();else if(r&&(e.key==="Insert"||e.key==="Enter"))this.insert();else if(e.key==="]")this.step(1);else if(e.key==="[")this.step(-1);else if(e.key==="+"||e.key==="=")t.zoom(t.width/2,t.height/2,.85);else if(e.key==="-"&&!this.drawing)t.zoom(t.width/2,t.height/2,1/.85);else if(e.key==="Escape"&&this.measured)this.stopMeasuring();else if(e.key==="Escape"&&r)this.select([]);else return;e.preventDefault()}},ns=i=>Number(i.toPrecision(14));var WM={idle:[],submitting:["running","shown","failed","cancelled"],running:["shown","failed","cancelled"],shown:[],failed:[],cancelled:[]},Ic=class{life={phase:"idle"};waiting=null;get underWay(){return this.life.phase==="submitting"||this.life.phase==="running"?this.life.asked:null}get job(){return"job"in this.life?this.life.job:null}get hasWaiting(){return this.waiting!==null}isCurrent(e){return this.underWay===e}ask(e){return this.underWay?(this.waiting=e,!1):(this.life={phase:"submitting",asked:e},!0)}enter(e){return this.underWay!==e.asked||!WM[this.life.phase].includes(e.phase)?!1:(this.life=e,!0)}next(){let{waiting:e}=this;return e&&(this.life={phase:"submitting",asked:e}),this.waiting=null,e}wasCancelled(e,t){this.underWay||(this.life={phase:"cancelled",asked:{kind:e,request:t}})}dropWaiting(){this.waiting=null}};var tg=[.62,.5,.85],Es=document.documentElement.hasAttribute("data-embed"),ng={light:{sketch:{paper:"#ffffff",accent:"#0a6c7e",ink:"#1c2427",fault:"#c62f26",soft:"#6d7b81",cable:"#b4561f"},look:{membrane:"#f2eee6",ink:"#20292d",accent:"#b4561f",reaction:"#c2185b",rim:"#ffffff"},grid:["#5b6b73",.42],shadow:.5},dark:{sketch:{paper:"#12181b",accent:"#56c4d4",ink:"#ffffff",fault:"#ff7a70",soft:"#8fa0a8",cable:"#ffb273"},look:{membrane:"#cbc7be",ink:"#0d1214",accent:"#ffb273",reaction:"#ff8fb8",rim:"#6c7c84"},grid:["#90a4ad",.3],shadow:.85}},vt={parts:null},Ts={openapi:{},objectives:[],examples:[]},oe={mode:"model",shown:null,viewing:!1,requests:new Ic,lastDuration:0,colour:"plain",quantity:null,serverFaulty:new Set,cameraGiven:!1,card:null,ready:!1},Sn=new oa({kind:"minimal_surface",request:sa("minimal_surface"),draft:null,title:null}),we=()=>Sn.document;function Lc(){let{shown:i,viewing:e}=oe;return i!==null&&!e&&(i.solved!==JSON.stringify(we().request)||i.job.kind!==we().kind)}var cd={...ng.light.look},Ye=new Ec(ee("view"),()=>({top:64,right:34,left:34,bottom:Math.max(Es?40:70,ee("look").offsetHeight+34)})),Fn=new _c(ng.light.sketch),Tt=new gc(cd);Ye.model.add(Tt.group,Fn.group);var $e={history:Sn,stage:Ye,sketch:Fn,surface:Tt,lines:[],frame:new On([0,0,0],we().request),faulty:new Set,fixed:Es,changed(){},selectionChanged(){},moved(){},rig(){},label(){},read(){},readLine(){},announce(){}},tt=new Pc($e);var sg=1e-9,XM=800,mi=(i,e)=>[i[0]-e[0],i[1]-e[1],i[2]-e[2]],qM=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]],ko=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2],Sr=i=>Math.hypot(...i);function Oc(i){return i.flatMap((e,t)=>as(e)?ig(e,t):[...ig(e,t),...$M(e,t)])}function ig(i,e){return i.points.flatMap((t,n)=>cf(t)?[]:[{line:e,points:[n],text:`${i.name}, point ${n+1} is not three numbers`}])}function $M(i,e){let t=i.points.map(je);if(t.some(c=>c===null)||t.length<2)return[];let n=t,s=Math.max(...n.map(c=>Sr(mi(c,n[0]))),0),r=[],o=i.closed&&n.length>2?n.length:n.length-1;for(let c=0;c<o;c+=1){let h=(c+1)%n.length;Sr(mi(n[c],n[h]))<=sg*s&&r.push({line:e,points:[c,h],text:`${i.name}, points ${c+1} and ${h+1} are the same`})}if(i.closed&&s>0&&YM(n,s))return[...r,{line:e,points:n.map((c,h)=>h),text:`${i.name}: all points lie on one line`}];let a=new Set(r.map(({points:[,c]})=>c)),l=n.map((c,h)=>h).filter(c=>!a.has(c));return i.closed&&l.length<=XM&&r.push(...JM(i,e,l.map(c=>n[c]),l,s)),r}function YM(i,e){let t=i[0],n=i.reduce((r,o)=>Sr(mi(o,t))>Sr(mi(r,t))?o:r),s=mi(n,t);return i.every(r=>Sr(qM(s,mi(r,t)))<=1e-9*e*e)}function JM(i,e,t,n,s){let r=[],o=t.length;for(let a=0;a<o&&r.length<4;a+=1)for(let l=a+2;l<o&&r.length<4;l+=1){if(a===0&&l===o-1)continue;let[c,h,u,d]=[t[a],t[(a+1)%o],t[l],t[(l+1)%o]];if(ZM(c,h,u,d)>sg*s)continue;let m=[a,(a+1)%o,l,(l+1)%o].map(x=>n[x]),[g,y,p,f]=m.map(x=>x+1);r.push({line:e,points:m,text:`${i.name}: the edge from point ${g} to ${y} meets the edge from ${p} to ${f}`})}return r}function ZM(i,e,t,n){let s=mi(e,i),r=mi(n,t),o=mi(i,t),a=ko(s,s),l=ko(s,r),c=ko(r,r),h=ko(s,o),u=ko(r,o),d=a*c-l*l,m=p=>Math.min(1,Math.max(0,p)),g=d>1e-14*a*c?m((l*u-c*h)/d):0,y=c>0?m((l*g+u)/c):0;return g=a>0?m((l*y-h)/a):0,y=c>0?m((l*g+u)/c):0,Sr(mi([i[0]+g*s[0],i[1]+g*s[1],i[2]+g*s[2]],[t[0]+y*r[0],t[1]+y*r[1],t[2]+y*r[2]]))}var KM={force:i=>i,end_tension:i=>i,horizontal_component:i=>i,force_density:(i,e)=>`${i}/${e}`,length:(i,e)=>e,unstressed_length:(i,e)=>e,sag:(i,e)=>e},Dc=i=>i.units?.force??"kN",jM=(i,e)=>KM[e]?.(Dc(i),en(i))??"";function rg(i,e,t,n){if(!e)return;let s=e.mode??"force";ee("cable-name").textContent=e.name??`Cable ${t+1}`;let r=ee("cable-mode");r.replaceChildren(...n.map(({name:o,help:a})=>ft("option",{value:o,title:a??""},An(o)))),r.value=s,ee("cable-unit").textContent=jM(i,s),ee("stiffness-unit").textContent=Dc(i);for(let[o,a]of[["cable-value",e.value],["cable-stiffness",e.axial_stiffness??""]]){let l=ee(o);(document.activeElement!==l||!l.dataset.dirty)&&(l.value=String(a))}}function LR(i,e,t,n){let s=a=>Number(a.toPrecision(6)),r=n?{force:n.force,end_tension:n.force,horizontal_component:n.force,force_density:n.force/n.length,length:n.length,unstressed_length:n.unstressed_length,sag:n.sag}:{};e.mode=t;let o=r[t];o?e.value=s(o):e.along&&(e.value=Fo(i,e.along,t)),t==="unstressed_length"&&!e.axial_stiffness&&(e.axial_stiffness=s(100*(n?.force??(e.along?Fo(i,e.along,"force"):1))),n&&(e.value=s(n.length/(1+n.force/e.axial_stiffness))))}function Mr(i=!1){Fn.group.visible=!oe.viewing&&!Es,Tt.drawn=Fn.group.visible,cg(),i||($e.faulty=new Set([...oe.serverFaulty,...Oc($e.lines).flatMap(({line:e,points:t})=>t.map(n=>`${e}/${n}`))]),Ye.rememberWhetherAllIsSeen()),tt.refresh()}var ag={show:()=>{},hint:()=>""},lg=-1;function cg(){lg=tt.cable;let{request:i,kind:e}=we(),t=({along:o,across:a,points:l})=>(o?pi(i,o).map(c=>ls(i,["boundaries",o.boundary??0,c])):[a??l??[]].flat()).map(c=>je(c)??[0,0,0]),n=e==="tensile_structure"&&!oe.viewing&&Array.isArray(i.masts)?i.masts:[],s=e==="tensile_structure"&&!oe.viewing?pn(i):[],r=new Set(s.flatMap(({along:o})=>o?pi(i,o).slice(0,-1).map(a=>`${o.boundary??0}/${a}`):[]));Fn.show(oe.viewing?[]:$e.lines,we().draft,$e.frame,{courses:[...s,...n].map(t),segments:r,chosen:tt.cable})}function hd(){let i=Ts.openapi.components?.schemas,{enum:e=["force"],"x-enum-descriptions":t}=i?.CableMode??{};return e.map((n,s)=>({name:n,help:t?.[s]}))}function hg(i=tt.cable){if(!oe.shown||oe.shown.job.kind!=="tensile_structure")return;let e=t=>JSON.stringify(pn(t)[i]?.along);if(e(oe.shown.request)===e(we().request))return oe.shown.job.statistics?.cables?.[i]}function Uc(){let{drawing:i,selection:e}=tt,t=!ee("intro").hidden&&!i&&!tt.measuring&&e.length===0;ee("intro").hidden=!t,ee("drawing").hidden=!i;let n=!i&&e.length===0?pn(we().request)[tt.cable]:void 0;lg!==tt.cable&&(cg(),tt.refresh()),ee("measure").setAttribute("aria-pressed",String(tt.measuring)),ee("cabling").hidden=!tt.mayCable,ee("cabling").setAttribute("aria-pressed",String(tt.cabling)),ag.show(),ee("cable").hidden=!n;let s=e.length>0&&!tt.cabling;ee("point").hidden=i||!s,ee("hint").hidden=t||i||s||n!==void 0,n&&rg(we().request,n,tt.cable,hd()),i?tw():s?nw():ee("hint").textContent=QM()}var Nc=matchMedia("(pointer: coarse)").matches;function QM(){return oe.viewing?"The server keeps no drawing of this job: only its mesh is shown. Undo, or any edit, brings your drawing back.":oe.mode==="compare"?"Each objective solved on the same rails; the best value of each row is bold. Drag beside the figures to turn all of them.":tt.measuring?"Click a point, a place of the surface or of the ground, and then another: the distance stands between them. Escape ends.":tt.cabling?ag.hint():oe.mode==="flat"?`The strip unrolled into the plane, to scale. Drag to move it, ${Nc?"pinch":"wheel"} to zoom.`:$e.lines.length===0?"Nothing is drawn yet. Press Draw, open a file, or drop one here.":we().kind==="cable_net"?"Drag a support to move it. The net is given by its request: its vertices, edges and targets.":ra(we().kind,we().request)?Nc?"Drag a point to move it. One finger beside the points turns the view, two move and zoom it.":"Drag a point to move it, or press the middle of an edge to add one. Drag the ground to orbit, right-drag to pan, wheel to zoom.":`A strip needs two ${kt[we().kind].line}s: press Draw for the next one.`}var ew={arc:["where the arc begins","a point on the arc","where the arc ends"],rectangle:["a corner of the rectangle","the opposite corner"],circle:["the centre of the circle","a point on the circle"]};function tw(){let{kind:i,draft:e}=we(),{line:t}=kt[i],{least:n,shape:s,shapes:r}=tt,o=i==="uniform_mesh"&&$e.lines.length===0,a=e.length,l=o?"polygon":t,c=Nc?"tap":"click",h=Nc?"Finish":"Enter",u=ee("shape");for(let m of u.options)m.hidden=m.disabled=!r.includes(m.value);u.value=s;let d=ew[s];ee("drawing-hint").textContent=d?`${ji(c)} ${d[Math.min(a,d.length-1)]}.`:a===0?`${ji(c)} on the ground to begin the ${l}.`:a<n?`${Qi(a,"point")} of the ${l}: ${c} to add more.`:i==="ruled_surface"?`${Qi(a,"point")}: ${c} to add more, ${h} ends the rail.`:`${Qi(a,"point")}: ${c} the first point, or press ${h}, to close the ${l}.`,ee("finish").disabled=a<n,ee("level-name").textContent=`at ${"xyz"[$e.frame.up]}`,document.activeElement!==ee("level")&&(ee("level").value=String(tt.level))}var og=i=>{i.style.width=`calc(${Math.max(1.2*i.value.length,7)}ch + 26px)`};function nw(){let{selection:i,only:e}=tt,t=e&&$e.lines[e.line];ee("point-name").textContent=t?`${ji(t.name)}, ${e.point+1} of ${t.points.length}`:Qi(i.length,"point");for(let o of document.querySelectorAll("#point [data-axis]")){let a=new Set(i.map(c=>{let h=$e.lines[c.line]?.points[c.point];return Array.isArray(h)?h[Number(o.dataset.axis)]:void 0})),[l]=a;document.activeElement===o&&o.dataset.dirty||(o.value=a.size===1&&l!==void 0&&l!==null?String(l):"",og(o),o.placeholder=a.size===1?"none":"various")}let n=tt.edgeBefore();ee("edge-field").hidden=!n;let s=ee("edge");n&&!(document.activeElement===s&&s.dataset.dirty)&&(s.value=String(Number(n.length.toPrecision(7))),og(s));let r=i.some(o=>$e.lines[o.line]?.only);ee("insert-point").disabled=!e||r,ee("remove-line").disabled=r,ee("delete-point").disabled=r&&!(e&&tt.mayCable),ee("cable-from-point").hidden=!e||!tt.mayCable||r}var As=class extends Error{constructor({ending:e,type:t,title:n,detail:s,errors:r}){let[o]=r??[];super([n,s,o&&`${o.pointer} ${o.detail}`].filter(Boolean).join(": ")),this.name="PlateauError",Object.assign(this,{ending:e,type:t,title:n,detail:s,errors:r??[]})}},ud=i=>i.reason??new DOMException("the request was cancelled","AbortError");function ug({shapes:i=new URL("shapes.wasm",import.meta.url),structures:e=new URL("structures.wasm",import.meta.url),worker:t=()=>new Worker(new URL("worker.mjs",import.meta.url),{type:"module"})}={}){let n=null,s=0,r=[],o=null,a=null;function l(){n=t(),n.onmessage=({data:p})=>{if(p.number!==o?.number)return;if(p.progress)return o.onProgress?.(p.progress);let{resolve:f,reject:x}=o;o=null,p.fault===void 0?f(p.done):x(new Error(p.fault)),u()},n.onerror=p=>{let f=o;c(),f?.reject(new Error(p.message||"the worker cannot be loaded")),u()},r.unshift(h("start",{modules:{shapes:String(i),structures:String(e)}}))}function c(){n?.terminate(),n=null,o=null,r=r.filter(({what:p})=>p!=="start")}function h(p,f,{onProgress:x}={}){s+=1;let w={what:p,number:s,members:f,onProgress:x};return w.promise=new Promise((M,v)=>Object.assign(w,{resolve:M,reject:v})),w.promise.catch(()=>{}),w}function u(){o||r.length===0||(n||l(),o=r.shift(),n.postMessage({what:o.what,number:o.number,...o.members}))}function d(p){return r.push(p),u(),p.promise}async function m(p,f){return(await d(h("file",{format:p,of:f}))).file}async function g(p,f,{onProgress:x,signal:w}){if(w?.aborted)throw ud(w);let M=globalThis.crossOriginIsolated?new Int32Array(new SharedArrayBuffer(4)):null,v=h(p,{request:f,flag:M,progress:!!x},{onProgress:x}),b=()=>{if(v===o&&M){Atomics.store(M,0,1);return}v===o&&c(),r=r.filter(_=>_!==v),v.reject(ud(w)),u()};w?.addEventListener("abort",b);try{let{answer:_,vertices:T,triangles:O}=await d(v);if(_.ending==="cancelled")throw w?ud(w):new As(_);if(_.ending!=="solved"&&_.ending!=="moved")throw new As(_);return O&&(a=O),{number:v.number,answer:_,mesh:{vertices:T,triangles:a}}}finally{w?.removeEventListener("abort",b)}}let y=({number:p,answer:{statistics:f,warnings:x},mesh:w})=>({statistics:f,warnings:x,mesh:w,file:M=>m(M,p),glb:()=>m("glb",p)});return{async load(p){await d(h("load",{kind:p}))},async solve(p,{onProgress:f,signal:x}={}){return y(await g("solve",p,{onProgress:f,signal:x}))},async drag(p,{signal:f}={}){let x=await g("drag",p,{signal:f}),{answer:w,mesh:M}=x;return w.ending==="moved"?{moved:w.moved,mesh:M}:{moved:null,...y(x)}},close(){let p=[o,...r].filter(Boolean);c(),r=[],p.forEach(({reject:f})=>f(new Error("the solvers were closed")))}}}var Cs=class extends Error{jobId;constructor(e,t){super(e,t),this.name=new.target.name}},_i=class extends Cs{constructor(t,n=null,s=null){let{title:r,detail:o,type:a="about:blank",errors:l=[],errors_omitted:c=!1}=t,h=l.map(({pointer:d,parameter:m,detail:g})=>({pointer:d??m??"",detail:g})),u=h.map(d=>`
  ${d.pointer||"(the whole request)"}: ${d.detail}`);super(`${r}${o&&`: ${o}`}${u.join("")}${c?`
  … and more`:""}`);this.status=n;this.requestId=s;this.title=r,this.detail=o,this.type=a,this.errors=h,this.errorsOmitted=c}status;requestId;title;detail;type;errors;errorsOmitted},gi=class extends _i{},Rs=class extends _i{},Li=class extends _i{},zo=class extends _i{},Fc=class extends _i{},is=class extends _i{constructor(t){super(t.error??{title:"The job failed",detail:""});this.job=t;this.jobId=t.id}job},wr=class extends Cs{constructor(t){super(`job ${t.id} was cancelled`);this.job=t;this.jobId=t.id}job},Zt=class extends Cs{job;idempotencyKey;constructor(e,{job:t,...n}={}){super(e,n),this.job=t,this.jobId=t?.id}};async function dd(i,e){try{return await e}catch(t){throw t instanceof Cs&&(t.jobId??=i),t}}var Bc=[408,425,429,502,503,504];function kc(i){let e=i.headers.get("retry-after")??"";return/^\d+$/.test(e)?Math.max(200,1e3*Number(e)):0}var iw={400:gi,413:gi,415:gi,422:gi,401:Rs,403:Rs,404:Li,410:Li,429:zo,503:zo};function zc(i,e){let t={title:`HTTP ${i.status}`,detail:e.slice(0,200)};try{let s=JSON.parse(e);typeof s.title=="string"&&typeof s.detail=="string"&&(t=s)}catch{}let n=iw[i.status]??(i.status>=500?Fc:_i);return new n(t,i.status,i.headers.get("x-request-id"))}function sw(i){if(i instanceof Float64Array||i instanceof Float32Array){if(i.length%3!==0)throw jn("",`expected x y z of each point, got ${i.length} numbers`);return Array.from({length:i.length/3},(t,n)=>Array.from(i.subarray(3*n,3*n+3)))}if(!Array.isArray(i))throw jn("","expected points as [[x, y, z], …]");let e=t=>Array.isArray(t)&&t.length>0&&t.every(fd);if(i.length>0&&i.every(e))throw jn("",`${fg}: ${rw}`);if(!i.every(fd))throw jn("","expected points as [[x, y, z], …]");return i.map(t=>"x"in t?[t.x,t.y,t.z]:[...t])}function Vc(i,e){try{return sw(e)}catch(t){throw t instanceof gi?jn(i,t.detail):t}}function Hc(i,e){if(!Array.isArray(e)||e.length>0&&e.every(fd))throw jn(`/${i}`,`${ow}: ${dg}`);if(e.length>0&&e.every(t=>pg(t)>2))throw jn(`/${i}`,`${fg}: ${dg}`);return e.map((t,n)=>Vc(`/${i}/${n}`,t))}var rw="it must be a list of points [x, y, z], such as [[0, 0, 0], [4, 0, 1], [4, 3, 0]]",dg="it must be a list of polylines, which are lists of points [x, y, z], such as [[[0, 0, 0], [4, 0, 1], [4, 3, 0]]]",fg="has a level of brackets too many",ow="lacks a level of brackets";function pg(i){return Array.isArray(i)?1+pg(i[0]):0}function fd(i){return Array.isArray(i)?i.length>0&&i.every(e=>typeof e=="number"):typeof i=="object"&&i!==null&&"x"in i}function pd({kind:i,units:e},t=""){if(!(i!=="tensile_structure"&&i!=="cable_net"||typeof e!="string"))throw jn(`${t}/units`,`must be an object, such as {"force":"kN","length":"${e}"}`)}function mg(i){return gg(i,""),JSON.stringify(i)}function gg(i,e){if(typeof i=="number"&&!Number.isFinite(i))throw jn(e,`${i} is not a finite number`);if(!(typeof i!="object"||i===null))for(let[t,n]of Object.entries(i))(typeof n=="number"?!Number.isFinite(n):typeof n=="object")&&gg(n,`${e}/${t.replaceAll("~","~0").replaceAll("/","~1")}`)}function jn(i,e){return new gi({title:"The request is invalid",detail:e,errors:[{pointer:i,detail:e}]})}var Vo=class extends Error{constructor(e,t){super(e),this.name="ParseError",this.type=t.type,this.field=t.field,this.value=t.value,this.line=t.line}},_g=10,aw=13,Ps=32;function md(i){}function vg(i){if(typeof i=="function")throw new TypeError("`config` must be an object, got a function instead. Did you mean `createParser({onEvent: fn})`?");let{onEvent:e=md,onError:t=md,onRetry:n=md,onComment:s,maxBufferSize:r}=i,o=[],a=0,l=!0,c,h="",u=0,d,m=!1;function g(v){if(m)throw new Error("Cannot feed parser: it was terminated after exceeding the configured max buffer size. Call `reset()` to resume parsing.");if(l&&(l=!1,v.charCodeAt(0)===239&&v.charCodeAt(1)===187&&v.charCodeAt(2)===191&&(v=v.slice(3))),o.length===0){let T=p(v);T!==""&&(o.push(T),a=T.length),y();return}if(v.indexOf(`
`)===-1&&v.indexOf("\r")===-1){o.push(v),a+=v.length,y();return}o.push(v);let b=o.join("");o.length=0,a=0;let _=p(b);_!==""&&(o.push(_),a=_.length),y()}function y(){r!==void 0&&(a+h.length<=r||(m=!0,o.length=0,a=0,c=void 0,h="",u=0,d=void 0,t(new Vo(`Buffered data exceeded max buffer size of ${r} characters`,{type:"max-buffer-size-exceeded"}))))}function p(v){let b=0;if(v.indexOf("\r")===-1){let _=v.indexOf(`
`,b);for(;_!==-1;){if(b===_){u>0&&e({id:c,event:d,data:h}),c=void 0,h="",u=0,d=void 0,b=_+1,_=v.indexOf(`
`,b);continue}let T=v.charCodeAt(b);if(yg(v,b,T)){let O=v.charCodeAt(b+5)===Ps?b+6:b+5,P=v.slice(O,_);if(u===0&&v.charCodeAt(_+1)===_g){e({id:c,event:d,data:P}),c=void 0,h="",d=void 0,b=_+2,_=v.indexOf(`
`,b);continue}h=u===0?P:`${h}
${P}`,u++}else xg(v,b,T)?d=v.slice(v.charCodeAt(b+6)===Ps?b+7:b+6,_)||void 0:f(v,b,_);b=_+1,_=v.indexOf(`
`,b)}return v.slice(b)}for(;b<v.length;){let _=v.indexOf("\r",b),T=v.indexOf(`
`,b),O=-1;if(_!==-1&&T!==-1?O=_<T?_:T:_!==-1?_===v.length-1?O=-1:O=_:T!==-1&&(O=T),O===-1)break;f(v,b,O),b=O+1,v.charCodeAt(b-1)===aw&&v.charCodeAt(b)===_g&&b++}return v.slice(b)}function f(v,b,_){if(b===_){w();return}let T=v.charCodeAt(b);if(yg(v,b,T)){let I=v.charCodeAt(b+5)===Ps?b+6:b+5,V=v.slice(I,_);h=u===0?V:`${h}
${V}`,u++;return}if(xg(v,b,T)){d=v.slice(v.charCodeAt(b+6)===Ps?b+7:b+6,_)||void 0;return}if(T===105&&v.charCodeAt(b+1)===100&&v.charCodeAt(b+2)===58){let I=v.slice(v.charCodeAt(b+3)===Ps?b+4:b+3,_);I.includes("\0")||(c=I);return}if(T===58){if(s){let I=v.slice(b,_);s(I.slice(v.charCodeAt(b+1)===Ps?2:1))}return}let O=v.slice(b,_),P=O.indexOf(":");if(P===-1){x(O,"",O);return}let D=O.slice(0,P),k=O.charCodeAt(P+1)===Ps?2:1,W=O.slice(P+k);x(D,W,O)}function x(v,b,_){switch(v){case"event":d=b||void 0;break;case"data":h=u===0?b:`${h}
${b}`,u++;break;case"id":b.includes("\0")||(c=b);break;case"retry":/^\d+$/.test(b)?n(parseInt(b,10)):t(new Vo(`Invalid \`retry\` value: "${b}"`,{type:"invalid-retry",value:b,line:_}));break;default:t(new Vo(`Unknown field "${v.length>20?`${v.slice(0,20)}…`:v}"`,{type:"unknown-field",field:v,value:b,line:_}));break}}function w(){u>0&&e({id:c,event:d,data:h}),c=void 0,h="",u=0,d=void 0}function M(v={}){if(v.consume&&o.length>0){let b=o.join("");f(b,0,b.length)}l=!0,c=void 0,h="",u=0,d=void 0,o.length=0,a=0,m=!1}return{feed:g,reset:M}}function yg(i,e,t){return t===100&&i.charCodeAt(e+1)===97&&i.charCodeAt(e+2)===116&&i.charCodeAt(e+3)===97&&i.charCodeAt(e+4)===58}function xg(i,e,t){return t===101&&i.charCodeAt(e+1)===118&&i.charCodeAt(e+2)===101&&i.charCodeAt(e+3)===110&&i.charCodeAt(e+4)===116&&i.charCodeAt(e+5)===58}function Go(i,e){return e?new Promise((t,n)=>{let s=()=>n(e.reason);e.aborted&&s(),e.addEventListener("abort",s,{once:!0}),i.then(t,n).finally(()=>e.removeEventListener("abort",s))}):i}function _d(i,e){let t,n=new Promise(s=>t=setTimeout(s,i));return Go(n,e).finally(()=>clearTimeout(t))}var lw=6e4,cw=4e3,hw=100,uw=3e3,Gc=class{#e;reached=!1;constructor(e){this.#e=e}get ms(){return this.#e??(this.reached?lw:cw)}attempts(){return new gd(this)}},gd=class{#e;#n;#t=hw;constructor(e){this.#e=e}async again(e,t){let n=Date.now();return this.#n??=n+this.#e.ms,n+e>=this.#n?!1:(await _d(e||Math.min(this.#t,this.#n-n),t),this.#t=Math.min(2*this.#t,uw),!0)}},Ho=class{#e=new AbortController;#n;#t;constructor(e,t){this.#n=e,e?.addEventListener("abort",this.#i),e?.aborted&&this.#i(),this.expect(t)}get signal(){return this.#e.signal}expect(e){clearTimeout(this.#t),this.#t=setTimeout(this.#i,e)}close(){clearTimeout(this.#t),this.#n?.removeEventListener("abort",this.#i),this.#i()}#i=()=>this.#e.abort()};var dw=5e3,fw=45e3,pw=15e3,mw=1e3,gw=6e4,bg=2,_w=2e3,mn=i=>i==="succeeded"||i==="failed"||i==="cancelled",Er=class extends Error{constructor(t,n=0){super("interrupted",{cause:t});this.pauseMs=n}pauseMs},Wc=class{#e;#n;#t;#i;#r="";#o=mw;#s=bg;#c=!0;constructor(e,t,n,s){this.#e=e,this.#n=t,this.#t=n,this.#i=s}async end(){let{signal:e,onProgress:t}=this.#t;for(e?.throwIfAborted(),mn(this.#e.status)&&t?.(this.#e.progress);!mn(this.#e.status)&&!(this.#s>0&&(this.#s-=1,await this.#h(),mn(this.#e.status)));)await this.#u(),(mn(this.#e.status)||this.#s===0)&&(this.#l(!0),t?.(this.#e.progress)),mn(this.#e.status)||await _d(this.#s>0?this.#o:_w,e);return this.#e}async#h(){let{onProgress:e,signal:t}=this.#t,n=new Ho(t,dw),s=[],r=vg({onEvent:o=>s.push(o),onRetry:o=>this.#o=Math.min(o,gw)});try{let o={Accept:"text/event-stream"};this.#r&&(o["Last-Event-ID"]=this.#r);let a=`${this.#d}/events`,l=await this.#a(n,d=>this.#n(a,o,d));l.status===204&&(this.#s=0);let c=l.headers.get("content-type")?.startsWith("text/event-stream");if(l.status!==200||!c||!l.body)return;let h=l.body.getReader(),u=new TextDecoder;for(;;){let{done:d,value:m}=await this.#a(n,()=>h.read());if(d)break;n.expect(fw),this.#l(!0),r.feed(u.decode(m,{stream:!0}));for(let g of s.splice(0)){this.#s=bg,this.#r=g.id??this.#r;let y=JSON.parse(g.data);if(g.event==="status"&&(this.#e=y),e?.(y.progress),mn(this.#e.status))return}}this.#l(!1)}catch(o){if(!(o instanceof Er))throw o;this.#l(!1)}finally{n.close()}}async#u(){let e=this.#i.attempts();for(;;)try{this.#e=await this.#f();return}catch(t){if(!(t instanceof Er))throw t;if(this.#l(!1),!await e.again(t.pauseMs,this.#t.signal))throw this.#p(t.cause)}}async#f(){let e=new Ho(this.#t.signal,pw);try{let t=await this.#a(e,n=>this.#n(this.#d,{},n));if(!t.ok){let n=zc(t,await this.#a(e,()=>t.text()));throw Bc.includes(t.status)?new Er(n,kc(t)):n}return await this.#a(e,()=>t.json())}finally{e.close()}}async#a(e,t){try{return await Go(t(e.signal),e.signal)}catch(n){throw this.#t.signal?.throwIfAborted(),new Er(n)}}get#d(){return`v1/jobs/${this.#e.id}`}#p(e){let{id:t}=this.#e,n=`the connection was lost; job ${t} goes on at the server, and \`client.resume('${t}')\` comes back to it`;return new Zt(n,{cause:e,job:this.#e})}#l(e){e!==this.#c&&(this.#c=e,this.#t.onConnection?.(e))}};var Xc=class{constructor(e,t){this.job=e;this.statistics=e.statistics;let n=yw(t);this.vertices=n.vertices,this.triangles=n.triangles,this.edges=n.edges,this.forces=n.forces,this.meanCurvature=n.meanCurvature,this.unit=n.unit,this.up=n.up}job;vertices;triangles;edges;forces;meanCurvature;unit;up;statistics;request;get id(){return this.job.id}get warnings(){return this.job.warnings}get origin(){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];this.vertices.forEach((s,r)=>{let o=r%3;e[o]=Math.min(e[o],s),t[o]=Math.max(t[o],s)});let n=s=>.5*e[s]+.5*t[s];return[n(0),n(1),n(2)]}};function yw(i){let e=new Uint8Array(i),t=new TextDecoder().decode(e.subarray(0,4096)),n=t.indexOf(`end_header
`);if(n<0)throw new Error("the PLY file has no header");let s=t.slice(0,n).split(`
`).map(v=>v.split(" ")),r=v=>{let b=0,_="",T=new Map;for(let[O,P="",D=""]of s)O==="element"&&(_=P),!(O!=="property"||P==="list"||_!==v)&&(T.set(D,b),b+={double:8,float:4,int:4,uchar:1}[P]??0);return{offsets:T,stride:b}},{offsets:o,stride:a}=r("vertex"),l=v=>Number(s.find(b=>b[0]==="element"&&b[1]===v)?.[2]),[,,c="",h=""]=s.find(v=>v[0]==="comment"&&v[1]==="unit")??[],u=new DataView(i),d=new TextEncoder().encode(t.slice(0,n)).length+11,m=new Float64Array(3*l("vertex")),g=o.get("mean_curvature"),y=g===void 0?null:new Float64Array(l("vertex"));for(let v=0;3*v<m.length;v++,d+=a){for(let b=0;b<3;b++)m[3*v+b]=u.getFloat64(d+8*b,!0);y&&(y[v]=u.getFloat64(d+g,!0))}let p=new Uint32Array(3*l("face"));for(let v=0;3*v<p.length;v++,d+=13)for(let b=0;b<3;b++)p[3*v+b]=u.getUint32(d+1+4*b,!0);let f=r("edge"),x=new Uint32Array(2*(l("edge")||0)),w=f.offsets.get("force"),M=new Float64Array(w===void 0?0:x.length/2);for(let v=0;2*v<x.length;v++,d+=f.stride){for(let b=0;b<2;b++)x[2*v+b]=u.getUint32(d+4*b,!0);w!==void 0&&(M[v]=u.getFloat64(d+w,!0))}return{vertices:m,triangles:p,edges:x,forces:M,meanCurvature:y,unit:c.replace(",",""),up:h}}function Sg(i){return new Map(i.lines.map(({name:e,paths:t,arrows:n,values:s})=>[e,{paths:t.map(r=>Uint32Array.from(r)),arrows:Float64Array.from(n.flat(2)),values:s?{[s.name]:Float64Array.from(s.values)}:{},unit:s?.unit??null}]))}var Mg="0.1.0",yd={ruled_surface:"v1/ruled-surfaces",minimal_surface:"v1/minimal-surfaces",uniform_mesh:"v1/uniform-meshes",tensile_structure:"v1/tensile-structures",cable_net:"v1/cable-nets"},xw=/^v1\/jobs\/([^/?]+)/,vw=1,bw=20,Sw=["ECONNREFUSED","ENOTFOUND","EAI_AGAIN","EHOSTUNREACH","ENETUNREACH","ETIMEDOUT","UND_ERR_CONNECT_TIMEOUT"],qc=class extends Xc{#e;constructor(e,t,n){super(t,n),this.#e=e}download(e="glb"){return this.#e.download(this.id,e)}async lines(){return Sg(Tr(await this.download("json")))}pattern(e={}){return this.#e.drawing(this.id,"pattern",e)}schedule(e={}){return this.#e.drawing(this.id,"schedule",e)}certificate(){return this.#e.getJson(`v1/jobs/${this.id}/certificate`)}},Wo=class{constructor(e,t,n){this.info=t;this.request=n;this.#e=e}info;request;#e;get id(){return this.info.id}get status(){return this.info.status}async refresh(){return this.info=await this.#e.getJson(`v1/jobs/${this.id}`)}fetchRequest(){return this.#e.getJson(`v1/jobs/${this.id}/request`)}async wait(e={}){return this.info=await this.#e.waitFor(this.info,e),this.#e.resultOf(this.info,void 0,this.request)}async cancel(){return this.info=await this.#e.cancel(this.id)}async delete(){await this.#e.delete(this.id)}},Xo=class{constructor(e,t,n){this.info=t;this.#e=e,this.#n=n}info;#e;#n;get id(){return this.info.id}get status(){return this.info.status}async refresh(){return this.info=await this.#e.getJson(`v1/batches/${this.id}`)}async wait(e={}){let{signal:t}=e;for(;!mn(this.info.status);){let s={headers:{Prefer:`wait=${bw}`},signal:t};this.info=Tr(await this.#e.send(`v1/batches/${this.id}`,s))}let n=[];for(let{id:s,index:r}of this.info.jobs){let o=await this.#e.getJson(`v1/jobs/${s}`);n.push(await this.#e.resultOf(o,t,this.#n?.[r]).catch(a=>{if(a instanceof is||a instanceof wr)return a;throw a}))}return n}download(e="zip",t){let n=t?`&mesh_format=${t}`:"";return this.#e.send(`v1/batches/${this.id}/meshes?format=${e}${n}`)}async cancel(){return this.info=Tr(await this.#e.send(`v1/batches/${this.id}/cancel`,{method:"POST"}))}async delete(){await this.#e.send(`v1/batches/${this.id}`,{method:"DELETE"})}},qo=class{url;#e;#n;#t;constructor(e={}){let{url:t,apiKey:n,patienceMs:s,fetch:r}=typeof e=="string"?{url:e}:e,{env:o={},versions:a}=globalThis.process??{};this.url=(t||o.PLATEAU_URL||"http://127.0.0.1:8080").replace(/\/+$/,"");let l=n??o.PLATEAU_API_KEY;this.#n=l?{Authorization:`Bearer ${l}`}:{},a?.node&&(this.#n["User-Agent"]=`plateau-client/${Mg} (Node.js)`),this.#e=new Gc(s),this.#t=r??((c,h)=>globalThis.fetch(c,h))}async ruledSurface(e,t={},n){return this.solve({kind:"ruled_surface",directrices:Hc("directrices",e),...t},n)}async minimalSurface(e,t={},n){return this.solve({kind:"minimal_surface",boundaries:Hc("boundaries",e),...t},n)}async uniformMesh(e,t,n={},s){let o=Array.isArray(e)||ArrayBuffer.isView(e)?{polygon:Vc("/domain/polygon",e)}:e;return this.solve({kind:"uniform_mesh",domain:o,edge_length:t,...n},s)}async tensileStructure(e,t,n={},s){let r=Hc("boundaries",e),o=Array.isArray(t)?{layers:t}:{film:t};return this.solve({kind:"tensile_structure",boundaries:r,...o,...n},s)}async cableNet(e,t,n,s={},r){let o={vertices:Vc("/vertices",e),edges:t,supports:n};return this.solve({kind:"cable_net",...o,...s},r)}async solve(e,t={}){let{signal:n,onProgress:s}=t,{info:r}=await this.submit(e,{waitS:s?0:vw,signal:n}),o;try{o=await this.waitFor(r,t)}catch(a){throw a instanceof Zt||await this.cancel(r.id).catch(()=>{}),a}return this.resultOf(o,n,e)}async submit(e,t={}){let{idempotencyKey:n=vd(),waitS:s=0,signal:r}=t;r?.throwIfAborted();let o=this.#c(e,n,s);try{return new Wo(this,await Go(o,r),e)}catch(a){throw r?.aborted&&this.#u(o,n),a}}async submitBatch(e,t={}){let n=t.idempotencyKey??vd();return e.forEach((s,r)=>pd(s,`/requests/${r}`)),new Xo(this,await this.#h("v1/batches",{requests:e},n,0),e)}async batch(e){return new Xo(this,await this.getJson(`v1/batches/${e}`))}live(){return new $c(this)}async job(e){return new Wo(this,await this.getJson(`v1/jobs/${e}`))}async resume(e,t={}){return(await this.job(e)).wait(t)}async*jobs(e={}){let t;do{let n=new URLSearchParams({...e,...t?{cursor:t}:{}}),s=await this.getJson(`v1/jobs?${n}`);yield*s.jobs,t=s.next_cursor}while(t)}async cancel(e){return Tr(await this.send(`v1/jobs/${e}/cancel`,{method:"POST"}))}async delete(e){await this.send(`v1/jobs/${e}`,{method:"DELETE"})}async download(e,t="glb",n){let s=t==="svg"||t==="dxf"?"pattern":"mesh";return this.send(`v1/jobs/${e}/${s}?format=${t}`,{signal:n})}drawing(e,t,n={}){let s=new URLSearchParams(Object.entries(n).map(([r,o])=>[r,String(o)]));return this.send(`v1/jobs/${e}/${t}?${s}`)}objectives(){return this.getJson("v1/objectives")}limits(){return this.getJson("v1/limits")}async example(e){let t=await this.getJson(`v1/examples/${e}`);return{kind:t.kind,...t.request}}waitFor(e,t={}){let n=(s,r,o)=>this.#s(s,{headers:r,signal:o});return dd(e.id,new Wc(e,n,t,this.#e).end())}async resultOf(e,t,n){if(e.status==="failed")throw new is(e);if(e.status==="cancelled")throw new wr(e);let s=new qc(this,e,await this.download(e.id,"ply",t));return s.request=n,s}async getJson(e){return Tr(await this.send(e))}send(e,t={}){return dd(xw.exec(e)?.[1],this.#i(e,t))}async#i(e,t){let n=this.#e.attempts();for(;;){let s,r;try{s=await this.#s(e,t),r=await s.arrayBuffer()}catch(l){if(t.signal?.throwIfAborted(),!this.#e.reached&&await this.#r())throw this.#o(l);if(await n.again(0,t.signal))continue;let c=this.#e.reached?"":"; start the service there, or name its address by `url` or PLATEAU_URL";throw new Zt(`${this.url} cannot be reached${c}`,{cause:l})}if(s.ok)return r;let o=zc(s,new TextDecoder().decode(r));if(!Bc.includes(s.status)||!await n.again(kc(s),t.signal))throw o}}async#r(){return xd()?this.#t(`${this.url}/health/live`,{mode:"no-cors"}).then(()=>!0,()=>!1):!1}#o(e){let t=`${this.url} answers, but the browser keeps its answers from pages of ${xd()} (CORS): the server's setting http.cors_origins must name "${xd()}"`;return new Zt(t,{cause:e})}async#s(e,t){let n={method:t.method??"GET",headers:{...this.#n,...t.headers}};t.body!==void 0&&(n.body=t.body),t.signal&&(n.signal=t.signal);try{let s=await this.#t(`${this.url}/${e}`,n);return this.#e.reached=!0,s}catch(s){let r=s.cause?.code;throw typeof r=="string"&&!Sw.includes(r)&&(this.#e.reached=!0),s}}async#c(e,t,n){if(!(e.kind in yd))throw jn("/kind",`must be one of ${Object.keys(yd).join(", ")}`);return pd(e),this.#h(yd[e.kind],e,t,n)}async#h(e,t,n,s){let r={"Content-Type":"application/json","Idempotency-Key":n};s>0&&(r.Prefer=`wait=${s}`);try{return Tr(await this.send(e,{method:"POST",headers:r,body:mg(t)}))}catch(o){throw o instanceof Zt&&(o.idempotencyKey=n),o}}async#u(e,t){try{for await(let s of this.jobs({idempotency_key:t}))await this.cancel(s.id);let n=await e;mn(n.status)||await this.cancel(n.id)}catch{}}},$c=class{#e;#n=vd();#t=new AbortController;#i=Promise.resolve();#r;constructor(e){this.#e=e}async solve(e,t={}){this.#t.abort();let n=this.#t=new AbortController,s=this.#i.then(()=>this.#o(e,n.signal));this.#i=s.catch(()=>{});try{let r=await s;return!r||(r=await this.#e.waitFor(r,{...t,signal:n.signal}),n.signal.aborted)?null:await this.#e.resultOf(r,n.signal,e)}catch(r){if(n.signal.aborted)return null;throw r instanceof Zt||await this.#s(),r}}stop(){this.#t.abort(),this.#i.then(()=>this.#s())}async#o(e,t){if(t.aborted)return null;let n=await this.#e.submit({...e,supersede:this.#n});return this.#r=n.info}async#s(){let e=this.#r;this.#r=void 0,e&&!mn(e.status)&&await this.#e.cancel(e.id).catch(()=>{})}};function xd(){return globalThis.location?.origin}function Tr(i){return JSON.parse(new TextDecoder().decode(i))}function vd(){return Array.from(crypto.getRandomValues(new Uint8Array(16)),i=>i.toString(16).padStart(2,"0")).join("")}var wg=new URL(".",document.baseURI).href.replace(/studio\/$/,""),$o=i=>wg+i.replace(/^\//,""),Yo=document.documentElement.hasAttribute("data-static"),Mw=1e4,Eg=i=>new qo({url:wg,apiKey:i,patienceMs:Mw}),Yc="",Bn=Eg(Yc),Tg=()=>Yc!=="";function hP(i){Yc=i,Bn=Eg(Yc)}async function uP(i){if(!Yo)return Bn.getJson(i);let e=await fetch($o(`studio/data/${i.replace(/^v1\//,"").replace(/\.json$/,"")}.json`));if(e.status===404)throw new Li({title:"There is no such document",detail:i});if(!e.ok)throw new Error(`${i} was answered with ${e.status}`);return e.json()}var ww=["cache","callback_url","label","metadata","supersede","cancel_on_disconnect"],Md=2e4,Cg="page-",Ew=()=>ug({shapes:$o("studio/shapes.wasm"),structures:$o("studio/structures.wasm"),worker:()=>new Worker($o("studio/worker.js"),{type:"module"})}),Tw={},Kc=i=>Tw[i]??=Ew(),Jc={minimal_surface:"shapes",ruled_surface:"shapes",uniform_mesh:"shapes",tensile_structure:"structures",cable_net:"structures"},bd=new Set,Sd=new Set,jc=new WeakMap,Ag=0,Oi=i=>i.id.startsWith(Cg);function Rg(i,e){let{triangles:t}=e.resolution??{};return!Sd.has(Jc[i])&&!e.certify&&!(typeof t=="number"&&t>Md)}var wd=i=>bd.has(Jc[i]);async function Pg(i){wd(i)||await Kc("document").load(i).then(()=>Zc(i,!0),()=>Zc(i,!1))}function Zc(i,e){(e?bd:Sd).add(Jc[i]),(e?Sd:bd).delete(Jc[i])}var Ed=i=>!(i instanceof As)&&i?.name!=="AbortError",Ig=i=>i instanceof As&&i.ending==="refused",Lg=(i,e)=>{let t={...e,kind:i};for(let n of ww)delete t[n];return t};async function Og(i,e,t,n="document"){let s=Lg(i,e),r=Date.now(),o=await Ng(i,Kc(n).solve(s,t));return Ug(i,r,s,o)}async function Dg(i,e,t){let n=Lg(i,e),s=Date.now(),r=await Ng(i,Kc("document").drag(n,t));if(r.moved===null)return Ug(i,s,n,r);let{moved:o,mesh:{vertices:a,triangles:l}}=r,c=Fg(i,s,{...o,vertices:a.length/3,triangles:l.length/3},[]);return jc.set(c,{body:n,solution:null,mesh:()=>Promise.resolve(Sm(a,l,e))}),c}async function Ng(i,e){try{let t=await e;return Zc(i,!0),t}catch(t){throw Ed(t)&&Zc(i,!1),t}}function Ug(i,e,t,n){let s=Fg(i,e,n.statistics,n.warnings),r=n.glb();return r.catch(()=>{}),jc.set(s,{body:t,solution:n,mesh:async()=>Hu((await r).buffer)}),s}function Fg(i,e,t,n){Ag+=1;let[s,r]=[e,Date.now()].map(a=>new Date(a).toISOString()),o=i==="ruled_surface"?{pattern:"#"}:{};return{id:`${Cg}${Ag}`,kind:i,status:"succeeded",statistics:t,warnings:n,links:o,created_at:s,started_at:s,finished_at:r}}async function Bg(i,e){return jc.get(i)?.mesh()??Hu(await Bn.download(i.id,"glb",e))}async function kg(i,e){let t=jc.get(i);return t?await t.solution?.file(e).catch(()=>null)??await(await Kc("other").solve(t.body)).file(e):Bn.download(i.id,e)}var Aw=7e3,Kt=i=>{ee("status").textContent=i},SP=i=>{ee("announcement").textContent=i};function Vg(i){document.querySelector("main").dataset.panel=i;for(let e of document.querySelectorAll("[data-panel]:is(button)"))e.setAttribute("aria-pressed",String(e.dataset.panel===i))}var zg=0;function Hg(i){ee("toast").textContent=i,ee("toast").hidden=!1,clearTimeout(zg),zg=window.setTimeout(()=>{ee("toast").hidden=!0},Aw)}var Ar=null;function Ad(i,e=0,t=0,n=null,s=!1){Ar=i===null?null:{text:i,x:e,y:t,anchor:n,reading:s},Cw()}function Gg(){Ar?.reading&&Ad(null)}function Cw(){let i=ee("label");if(i.hidden=Ar===null,!Ar)return;let{text:e,anchor:t}=Ar,{x:n,y:s}=t?Ye.project(t):Ar;i.textContent=e;let r=Math.min(Math.max(n+14,6),Ye.width-i.offsetWidth-6),o=Math.min(Math.max(s-30,6),Ye.height-30);i.style.transform=`translate(${Math.round(r)}px, ${Math.round(o)}px)`}var Td=130,Is=ft("p",{id:"scale-line","aria-hidden":"true"});function MP(){Is.isConnected||ee("stage").append(Is);let i=$e.frame.length(Ye.pixelAt(Ye.centre)),e=10**Math.floor(Math.log10(Td*i)),t=[5,2,1].map(r=>r*e).find(r=>r<=Td*i)??e;Is.hidden=oe.mode!=="model"||!Number.isFinite(t);let n=`${et(t)} ${en(we().request)}`;Is.textContent!==n&&(Is.textContent=n),Is.style.width=`${(t/i).toFixed(1)}px`;let s=ee("look");Is.style.bottom=`${s.offsetWidth+Td+40>Ye.width?s.offsetHeight+20:14}px`}var Rw={of:()=>[]},Qc=[],Wg=[];function eh(){Qc.forEach(({box:e})=>e.remove());let i=[...Tt.reactions(),...Rw.of()];Wg=i.map(({tip:e})=>e),Qc=i.filter(({text:e})=>e!=="").map(({tip:e,text:t})=>({anchor:e,box:ft("p",{className:"tag"},t)})),ee("stage").append(...Qc.map(({box:e})=>e)),Pw()}var wP=()=>Wg;function Pw(){let i=[];for(let{anchor:e,box:t}of Qc){let{x:n,y:s,visible:r}=Ye.project(e);if(t.hidden=oe.mode!=="model"||!r||i.some(a=>Math.abs(a.x-n)<62&&Math.abs(a.y-s)<20),t.hidden)continue;i.push({x:n,y:s});let o=Math.max(4,Math.min(n+6,Ye.width-t.offsetWidth-4));t.style.transform=`translate(${Math.round(o)}px, ${Math.round(s-10)}px)`}}var EP=(i,e,t,n)=>{let s=Tt.valueAt(i,e),r=$e.frame.fromScene(i.toArray()).map(o=>et(o,5)).join(", ");Ad(oe.quantity&&s!==null?mc(oe.quantity,s):r,t,n,i.toArray(),!0)},TP=(i,e,t,n)=>Ad(e,t,n,i.toArray(),!0);var th="plateau.work",Cd="plateau.recent",Iw=250,Lw=2e5,Ow=20,Dw=i=>{let{kind:e,request:t}=i??{};return e!==void 0&&e in kt&&t!==null&&typeof t=="object"},Xg=0,qg=!1;function Cr(){clearTimeout(Xg),Xg=window.setTimeout(Rd,Iw)}function Rd(){if(Es||!oe.ready)return;let{kind:i,request:e,draft:t,title:n}=we(),{requests:{life:s,job:r},shown:o}=oe,a=s.phase!=="idle"&&s.asked.kind===i&&s.asked.request===JSON.stringify(e),l=a?s.phase:"idle",c=a&&r&&!Oi(r)?r:Lc()?null:o?.job,h=c&&!Oi(c)?c.id:null,u={kind:i,request:e,draft:t,title:n,camera:Nw(),colour:oe.colour,phase:l,job:h},d=JSON.stringify(u);try{sessionStorage.setItem(th,d),localStorage.setItem(th,d)}catch{qg||Hg("This drawing is too large to be kept by the browser: save it as a file."),qg=!0}vt.parts?.pictureRecent()}function OP(){try{let i=JSON.parse(sessionStorage.getItem(th)??localStorage.getItem(th)??"null");return Dw(i)?i:null}catch{return null}}function Nw(){let{eye:i,target:e}=Ye.pose(),t=new On([0,0,0],we().request).toScene($e.frame.origin);return{eye:i.map((n,s)=>n+t[s]),target:e.map((n,s)=>n+t[s])}}function DP({eye:i,target:e}){oe.cameraGiven=!0;let t=new On([0,0,0],we().request).toScene($e.frame.origin);Ye.place({eye:i.map((n,s)=>n-t[s]),target:e.map((n,s)=>n-t[s])},!1),Ye.rememberWhetherAllIsSeen()}function Uw(){try{return JSON.parse(localStorage.getItem(Cd)??"[]")}catch{return[]}}function Pd(i,{request:e,title:t}){if(Es||e.length>Lw)return;let n=Uw(),s=n.find(({id:r})=>r===i.id)?.picture;Fw([{id:i.id,title:t,kind:i.kind,request:e,...s&&{picture:s}},...n.filter(({id:r})=>r!==i.id)])}function Fw(i){try{localStorage.setItem(Cd,JSON.stringify(i.slice(0,Ow)))}catch{localStorage.removeItem(Cd)}}var $g=["force","end_tension","horizontal_component","force_density"],Bw={"/problems/no-equilibrium":i=>pn(i).some(({mode:e="force"})=>$g.includes(e))?{label:"Double the forces of the cables",apply:e=>{for(let t of pn(e))$g.includes(t.mode??"force")&&(t.value*=2)}}:typeof i.pressure!="number"||i.pressure===0?null:{label:"Halve the pressure",apply:e=>{e.pressure=e.pressure/2}},"/problems/no-connected-film":({topology:i})=>i==="free"||i==="best"?null:{label:"Let the film come apart",apply:e=>{e.topology="free"}}},Yg=(i,e)=>Bw[i]?.(e)??null;var Jg={"degenerate-boundary":"The boundary spans no area that a mesh could begin with. Move its points apart.","equilibrium-not-found":"No shape in equilibrium was found, which does not prove that there is none. Try another resolution, or begin nearer to the shape.",internal:"The service failed. This is a defect of the service and not of the drawing.","invalid-mesh":"The solver ended with a mesh that is no surface. Try another resolution or another solver.","no-connected-film":"No film connects the boundaries. Move them closer together, or choose a topology that lets the film come apart.","no-equilibrium":"The film closes or leaves its supports before it is in balance. Give the cables larger forces, lower the pressure, or move the supports closer together.","no-initial-mesh":"No mesh was found that the solver could begin with. Move the points apart, or choose another initial mesh.","no-room-for-interior-vertices":"The boundary is too small for the vertices that were asked for. Ask for fewer.","not-flattenable":"The surface cannot be laid flat.","self-intersecting-boundary":"The boundary crosses or touches itself, so no mesh without folds spans it. Move the points apart.","slack-cable":"A cable would carry no force. Make it shorter, or give it a larger force.","targets-not-reached":"No net meets the targets. Leave out some of them, or make them less strict.","too-large":"The mesh is too large for this service. Ask for fewer triangles or for longer edges."},kw=/\b(point|boundary|boundaries|cable|layer|edge|vertex|vertices|support|ring|rail|directrix|directrices|triangle|mast|strip|hole|joint|segment|polyline)(s?) (\d+(?:(?:, | and | to | or )\d+)*)(?![\d.]*\d|\.\d)/gi,zw=/(?<![\w/])((?:\/[a-z_]+(?:\/\d+)*)+)/g,Id=i=>i.replace(kw,(e,t,n,s)=>`${t}${n} ${s.replace(/\d+/g,r=>String(Number(r)+1))}`).replace(zw,e=>e.slice(1).split("/").map(t=>/^\d+$/.test(t)?String(Number(t)+1):t.replaceAll("_"," ")).join(" "));var Ld=0,Zg=0,nh=0;function Qn(){return Zg+=1,Zg}async function ih(i){Ld+=1,document.body.setAttribute("aria-busy","true");try{return await i()}finally{Ld-=1,document.body.setAttribute("aria-busy",String(Ld>0))}}function Kg(){nh=Qn()}var kP=(i,e,t)=>ih(async()=>{let n=Qn();nh=n;try{let s=await i();n===nh&&e(s)}catch(s){n===nh&&t(s,n)}});var Vw={by:i=>{}},Od=0;function Qg(i){return i<Od?!1:(Od=i,!0)}function Jo(i=Qn()){Qg(i)&&(ee("problem").hidden=!0,oe.serverFaulty.size!==0&&(oe.serverFaulty=new Set,Mr()))}var Hw="This server does not take this key. Copy it again, or ask whoever runs the server for another one.";function Gw(){ee("key-fault").textContent=Tg()?Hw:"This server asks for a key. Type the one that you were given.",ee("key-fault").hidden=!1;let i=ee("settings");i.open||i.showModal(),ee("api-key").focus()}function Ls(i,e=Qn()){if(!Qg(e))return;if(i instanceof Rs){Gw();return}let{type:t,title:n,detail:s,message:r,errors:o,errorsOmitted:a}=i instanceof Zt?Xw(i):i,l=o??[],c=new Set,h=Oc($e.lines),u=l.flatMap(f=>{let x=mh($e.lines,f.pointer);if(x.line!==void 0&&h.some(({line:v,points:b})=>v===x.line&&(x.point===void 0||b.includes(x.point))))return[];x.line!==void 0&&x.point!==void 0&&x.point>=0&&c.add(`${x.line}/${x.point}`);let M=x.line===void 0?ee("options").querySelector(`[name="${CSS.escape(x.field??"")}"], [name^="${CSS.escape(x.field??"")}."]`):null;return[jg(ji(x.text),Id(f.detail),x,M)]});if(l.length===0||u.length<l.length||!l.some(f=>mh($e.lines,f.pointer).point!==void 0))for(let{line:f,points:x,text:w}of h)x.forEach(M=>c.add(`${f}/${M}`)),u.push(jg("",ji(w),{line:f,point:x[0]},null));a&&u.push(ft("li",{},"and more"));let d=Jg[(t??"").replace("/problems/","")],m=s??r??"",g=l.length>0&&(/^see errors/.test(m)||l.some(f=>m.includes(f.detail))),y=d!==void 0&&m!==""&&!g;if(ee("problem").replaceChildren(ft("strong",{},n??"Something went wrong"),d??(g||m===n?"":ji(Id(m))),u.length>0&&ft("ul",{},...u)||"",Ww(t)??"",y?ft("details",{},ft("summary",{},"In the words of the service, which counts from 0"),m):""),ee("problem").hidden=!1,Vg("setup"),ee("problem").scrollIntoView({block:"nearest"}),oe.serverFaulty=c,Mr(),!(i instanceof Zt)||i.job)return;let{life:p}=oe.requests;vt.parts?.whenBack(()=>{Od===e&&(Jo(),oe.requests.life===p&&Kt("The server is back."))})}function Ww(i){let e=i===void 0?null:Yg(i,we().request);return e&&ft("button",{type:"button",className:"remedy",onclick:()=>Vw.by(e)},e.label)}var Xw=({job:i})=>i?{title:"The connection was lost",detail:"The job goes on at the server. Reload the page to come back to it."}:{title:"The server cannot be reached",detail:"Is it still running? Nothing was lost; try again."};function jg(i,e,t,n){let s=[i&&ft("b",{},i),i?` ${e}`:e];if(t.line===void 0&&!n)return ft("li",{},...s);let r=ft("button",{type:"button"},...s);return r.addEventListener("click",()=>{n?(n.closest("details")?.setAttribute("open",""),n.focus()):tt.select([{line:t.line,point:Math.max(t.point??0,0)}])}),n&&n.setAttribute("aria-invalid","true"),ft("li",{},r)}var Rr=null,Zo=null,qw={use:i=>{}},oI=()=>Zo?.restyle();function $w(){return vt.parts?(Rr??=new vt.parts.Flat,Zo??=new vt.parts.Compare(Ye,cd,i=>qw.use(i)),{flat:Rr,compare:Zo}):null}function e_(){let i=Qn();return e=>Ls(e,i)}function Ko(i){if(!(i===oe.mode&&i!=="compare"||i!=="model"&&!$w())){oe.mode=i,ee("stage").dataset.shows=i;for(let e of document.querySelectorAll("[data-mode]"))e.setAttribute("aria-pressed",String(e.dataset.mode===i));if(ee("corner").hidden=i!=="model",i!=="compare"&&Zo?.close(),i!=="flat"&&Rr?.hide(),i==="compare"){let e=Ts.objectives.filter(t=>t.kind==="ruled_surface").map(t=>t.name);Zo.open(we().request,$e.frame,e,e_())}i==="flat"&&sh(),Uc(),Ye.invalidate()}}function aI(){oe.mode==="flat"?Rr.fit():Ye.fit(!0)}function t_(i,e){ee("modes").hidden=!i,document.querySelector('[data-mode="flat"]').hidden=!e,oe.mode==="flat"&&(e?sh():Ko("model"))}function sh(){let{shown:i,mode:e}=oe;i&&e==="flat"&&Rr.show({job:i.job,request:i.request,name:Po(we().title)??"strip"},e_())}function lI(){return oe.mode!=="flat"?!1:(Rr.print(),!0)}var r_=(i,e)=>t=>i(t)?null:e,n_=r_(({normals:i})=>Array.isArray(i),"Needs normals along the rails."),i_=i=>e=>{if(typeof e[i]=="number"&&e[i]!==0)return`Not together with a ${i}.`;if(pn(e).some(({along:t})=>t))return"Not with cables along a boundary.";for(let t of["supports","rings","layers"])if(Array.isArray(e[t])&&e[t].length>0)return`Not with ${t}.`;return null},Yw=({film:i})=>i!==null&&typeof i=="object"&&["warp","weft"].some(e=>typeof i[e]=="number"),Dd=r_(({layers:i})=>!Array.isArray(i)||i.length===0,"Each of the layers has its own."),Jw=[{kind:"ruled_surface",field:"objective=minimal_normal_variation",reason:n_},{kind:"ruled_surface",field:"objective.weights.minimal_normal_variation",reason:n_},{kind:"tensile_structure",field:"pressure",reason:i_("volume")},{kind:"tensile_structure",field:"volume",reason:i_("pressure")},{kind:"tensile_structure",field:"film.tension",reason:i=>Yw(i)?"Not together with warp and weft.":Dd(i)},{kind:"tensile_structure",field:"film.weight",reason:i=>Dd(i)},{kind:"tensile_structure",field:"film",reason:i=>Dd(i)}],o_=[];function dI(i){o_=i}var Zw={solver:"auto",topology:"fixed",initial_mesh:"auto",closed:"false",optimise:"nodes",optimise_nodes:"true"};function s_(i,e){let t=i[e]??Zw[e];return t===null||typeof t!="object"?String(t):e==="domain"?Object.keys(t).find(n=>n!=="holes")??"":e==="objective"?"weighted":"given"}var Kw={minimal_surface:"minimal_area",ruled_surface:"minimal_area",uniform_mesh:"most_equal_edges"};function a_(i,e,t){let n=o_.filter(c=>c.kind===i),s=n.filter(({options:c})=>c.some(({name:h})=>h===t));if(s.length===0)return null;let r=e.objective===void 0?Kw[i]:s_(e,"objective"),o=r==="weighted"?s.length===n.length&&s[0]:s.find(({name:c})=>c===r);if(!o&&n.length>1)return`Only with the objective ${s.map(({name:c})=>An(c).toLowerCase()).join(" or ")}.`;let a=(o||s[0]).options.find(({name:c})=>c===t).needs;if(a.length===0||a.some(c=>Object.entries(c).every(([h,u])=>u.includes(s_(e,h)))))return null;let l=c=>Object.entries(c).map(([h,u])=>`${An(h).toLowerCase()} ${u.map(d=>An(d).toLowerCase()).join(" or ")}`).join(" and ");return`Only with ${a.map(l).join(", or with ")}.`}var l_=(i,e,t)=>Jw.find(n=>n.kind===i&&n.field===t)?.reason(e)??a_(i,e,t);function Nd(i,e){let t=!1;for(let n=!0;n;){let s=Object.keys(e).filter(r=>e[r]!==void 0&&e[r]!==null&&a_(i,e,r)!==null);for(let r of s)delete e[r];n=s.length>0,t||=n}return t}var c_=["#c2413b","#3d8b4f","#3a6fb5"],jw=27,rh=class{constructor(e,t,n){this.box=e;this.stage=t;this.build(n)}box;stage;arms=[];build(e){this.arms=[],this.box.replaceChildren();for(let t of[0,1,2])for(let n of[-1,1]){let s=[0,0,0];s[t]=n;let r=e.up===2?[s[0],s[2],-s[1]]:s,o="XYZ"[t],a=n>0?Ui("line",{stroke:c_[t]}):null,l=Ui("circle",{r:n>0?8.5:5.5,fill:c_[t],"fill-opacity":n>0?1:.35}),c=Ui("g",{tabindex:0,role:"button","aria-label":`Look from ${n>0?"":"minus "}${o}`},l,...n>0?[Ui("text",{},o)]:[]),h=()=>this.stage.lookAlong([r[0],r[1],r[2]+(Math.abs(r[1])>.5?.001:0)]);c.addEventListener("click",h),c.addEventListener("keydown",u=>{["Enter"," "].includes(u.key)&&(u.preventDefault(),h())}),this.arms.push({direction:r,line:a,tip:c})}this.place()}place(){let e=this.arms.map(t=>({arm:t,at:new C(...t.direction).applyQuaternion(this.stage.camera.quaternion.clone().invert()).multiplyScalar(jw)}));e.sort((t,n)=>t.at.z-n.at.z);for(let{arm:t,at:n}of e){let[s,r]=[n.x.toFixed(1),(-n.y).toFixed(1)];t.line?.setAttribute("x2",s),t.line?.setAttribute("y2",r),t.tip.setAttribute("transform",`translate(${s} ${r})`)}if(!this.box.contains(document.activeElement)){let t=e.flatMap(({arm:n})=>[n.line,n.tip]).filter(n=>n!==null);t.some((n,s)=>this.box.children[s]!==n)&&this.box.append(...t)}}};var Ud=220,Fd=34,Bd=44;function oh(i){if(ee("scale").hidden=i===null,!i)return;let e=i.scale==="diverging"&&i.id==="mean_curvature"?"|H|":"All values";ee("scale-note").textContent=i.nought?`≈ 0: ${e} below ${et(i.noise,2)}${i.unit&&` ${i.unit}`}`:`${i.label}${i.unit&&` [${i.unit}]`}`;let t=!i.nought&&i.high-i.low<=1e-6*Math.max(Math.abs(i.low),Math.abs(i.high)),n=ee("scale-bar"),s=40,r=Array.from({length:s+1},(c,h)=>_m(i.scale,i.nought||t?i.scale==="diverging"||t?.5:0:h/s));n.style.background=`linear-gradient(to right, ${r.join(", ")})`,ee("scale-low").textContent=i.nought||t?"":et(i.low,3),ee("scale-middle").textContent=i.nought?"≈ 0":t?et(i.high,5):i.scale==="diverging"?"0":"",ee("scale-high").textContent=i.nought||t?"":et(i.high,3);let o=Am(i,Bd),a=Math.max(...o,1),l=ee("scale-histogram");l.hidden=i.nought||t,l.replaceChildren(Ui("svg",{viewBox:`0 0 ${Ud} ${Fd}`,preserveAspectRatio:"none",role:"img","aria-label":`Histogram of ${i.values.length} values`},...o.map((c,h)=>{let u=Fd*Math.sqrt(c)/Math.sqrt(a);return Ui("rect",{x:h*Ud/Bd,y:Fd-u,width:Ud/Bd-.8,height:u})})))}function Qw(i){return i==null?"—":typeof i=="number"?et(i):typeof i=="boolean"?i?"yes":"no":String(i).replaceAll("_"," ")}var eE={minimal_surface:[["area","Area","u²"],["certificate.gap","Proven: above the least area by at most","%"]],ruled_surface:[["area","Area","u²"],["convex_bridge_ratio","Convex bridges","%"],["largest_fold_deg","Largest fold","°"]],uniform_mesh:[["edges","Members",""],["nodes","Nodes",""],["equal_edges","Equal members",""],["distinct_lengths","Distinct lengths",""]]},jo=i=>Array.isArray(i)?i:[],h_=i=>Math.max(0,...i.map(({force:e})=>Math.hypot(...e))),tE=i=>{let[e,t]=[et(Math.min(...i),3),et(Math.max(...i),3)];return e===t?e:`${e}–${t}`},nE=(i,e)=>i===String(e)?`cable ${e+1}`:i;function iE(i,e){let t=String(i.force_unit??""),n=[],s=(c,h,u)=>{typeof h=="number"&&n.push({name:c,value:et(h,4),unit:u})},r=jo(i.cables);if(r.length>0){let c=r.map(({force_max:u})=>Math.abs(u)),h=c.indexOf(Math.max(...c));s(r.length>1?`Largest cable force: ${nE(r[h].name,h)}`:"Cable force",r[h].force_max,t)}let o=jo(i.reactions);o.length>0&&s("Largest reaction",h_(o),t),r.length>0&&n.push({name:r.length>1?"Cable lengths":"Cable length",value:tE(r.map(({length:c})=>c)),unit:e});let a=jo(i.masts);a.length>0&&s("Largest mast force",Math.max(...a.map(({force:c})=>Math.abs(c))),t),jo(i.chambers).length>0&&(s("Pressure",i.pressure,`${t}/${e}²`),s("Volume",i.volume,`${e}³`));let l=jo(i.edge_reactions);return o.length===0&&l.length>0&&s("Largest reaction of a boundary",h_(l),t),i.area&&s("Area",i.area,`${e}²`),i.load_path!==void 0&&s("Load path",i.load_path,`${t} ${e}`),n}var kd=(i,e)=>e.split(".").reduce((t,n)=>t?.[n],i),sE=(i,e)=>kd(i,e)!==void 0&&kd(i,e)!==null;function rE([i,e,t],n){let s=[i,t].sort((o,a)=>a-o).map(o=>et(Number(o.toPrecision(3)),3)),r=!(e>1e-6*Math.max(i,t));return[{name:"Span",value:s.join(" × "),unit:n},{name:"Rise",value:r?"0":et(Number(e.toPrecision(3)),3),unit:n}]}function u_(i,e,t){let n=i.statistics,s=eE[i.kind]?.filter(([o])=>sE(n,o)).map(([o,a,l])=>{let c=kd(n,o);return{name:a,value:l==="%"&&typeof c=="number"?et(100*c,3):typeof c=="number"?et(c,4):Qw(c),unit:l.replace("u",e)}})??iE(n,e),r=o=>o===""||o==="%"||o==="°"?o:` ${o}`;return[...rE(t,e),...s].map(({name:o,value:a,unit:l})=>ft("div",{className:"figure"},ft("span",{className:"value"},a,ft("small",{},r(l))),ft("span",{className:"name"},o)))}var d_=450,f_=0;function ah(){oe.shown=null,oe.quantity=null,Tt.show(null,"",$e.frame),eh(),ee("result").hidden=!0,ee("nothing").hidden=!1,ee("look").hidden=!0,ee("modes").hidden=!0,oh(null),Ko("model")}function m_(i,e,t,n=!1){let s=oe.shown===null||oe.shown.job.kind!==i.kind,r=JSON.parse(t);oe.shown={job:i,mesh:e,solved:t,request:r,dragging:n},Gg(),s&&oe.colour==="plain"&&(oe.colour=Em(e)),g_(),Tt.show(e,i.kind,$e.frame,oe.quantity),ee("look").hidden=!1,cE(),eh(),Ye.measure(),Ye.rememberWhetherAllIsSeen(),s&&!oe.cameraGiven&&Ye.fit(!1),oe.cameraGiven=!1,ee("nothing").hidden=!0,ee("result").hidden=!1,zd(i);let o=i.statistics;ee("figures").replaceChildren(...u_(i,en(r),aE(e,Or(r)))),oE(),p_(ee("downloads"),["glb","gltf","obj","ply",...Pi(e)?["stl"]:[]],i);let a=!!(i.links.pattern&&o.flat_pattern);ee("pattern-box").hidden=!a,a&&p_(ee("pattern-downloads"),["svg","dxf"],i),t_(i.kind==="ruled_surface",a),lE(i,e),Qo()}function oE(){let{shown:i}=oe;if(!vt.parts||!i)return;let{job:e,mesh:t,request:n}=i,s=en(n),{x:r,y:o,z:a}=Tt.group.position,l=d=>$e.frame.fromScene([d[0]+r,d[1]+o,d[2]+a]),{result:c,numerics:h}=vt.parts.statistics(e,s),u=vt.parts.samplesOf(e.statistics.history);ee("charts").replaceChildren(...vt.parts.charts(u,"Area",Vd(n))),ee("details").replaceChildren(...vt.parts.details(e,{mesh:t,request:n,toRequest:l},s,Po(we().title)??e.kind.replaceAll("_","-"))),ee("warnings").replaceChildren(...vt.parts.warnings(e.warnings,s)),ee("statistics").replaceChildren(...c),ee("numbers").replaceChildren(...h)}function aE({geometry:i},e){i.computeBoundingBox();let{min:t,max:n}=i.boundingBox;return[n.x-t.x,n.y-t.y,n.z-t.z].map(s=>s/e)}function zd(i){ee("job-id").parentElement.hidden=Oi(i),ee("job-id").textContent=i.id}var Vd=i=>typeof i.tolerance=="number"?i.tolerance:we().kind==="minimal_surface"?1e-6:null;function lE(i,e){let t=(Date.parse(i.finished_at??"")-Date.parse(i.started_at??""))/1e3,n=t>0?`Solved in ${Io(t)}`:"Solved",{converged:s}=i.statistics,r=e.lines.filter(({name:a})=>a.startsWith("cables")).reduce((a,l)=>a+l.segments.length/6,0),o=Pi(e)?Qi(e.geometry.index.count/3,"triangle"):Qi(r,"edge");Kt(`${n}: ${o}.${s===!1?" Not converged.":""}`)}function p_(i,e,t){i.replaceChildren(...e.map(n=>ft("button",{type:"button",onclick:async()=>{let s=Qn();try{af(new Blob([await kg(t,n)]),`${Po(we().title)??`${t.kind.replaceAll("_","-")}${Oi(t)?"":`-${t.id}`}`}.${n}`)}catch(r){Ls(r,s)}}},n.toUpperCase())))}function Qo(){let i=Lc();for(let t of document.querySelectorAll("#downloads button, #pattern-downloads button"))t.disabled=i;clearTimeout(f_);let e=()=>{ee("result").classList.toggle("stale",i),ee("stale").hidden=!i,Tt.setGhost(i||we().draft!==null),Ye.shadow.fade(i),Ye.invalidate()};i&&oe.requests.underWay&&oe.lastDuration*1e3<d_?f_=window.setTimeout(e,d_):e()}function BI(){oe.shown&&(g_(),Tt.colourBy(oe.quantity),Ye.keepInside(!1))}function g_(){let{shown:i}=oe;if(!i)return;let{mesh:e,job:t,request:n}=i,s=Mm(e,t.kind),r=ee("quantity"),o=s.some(({id:a})=>a===oe.colour);if(!o&&i.dragging){oe.quantity=null,oh(null);return}o||(oe.colour="plain"),r.replaceChildren(...s.map(({id:a,label:l})=>ft("option",{value:a},l))),r.value=oe.colour,oe.quantity=Tm(e,oe.colour,en(n),Or(n)),oe.quantity?.id.startsWith("line:")&&oe.quantity.scale==="sequential"&&document.documentElement.dataset.theme!=="dark"&&(oe.quantity.scale="lines"),oh(oe.quantity)}function cE(){let i={surface:"Surface",edges:"Mesh",lines:"Lines",reactions:"Reactions"},e=oe.shown?.mesh,t=n=>n==="reactions"?e?.lines.some(s=>s.name==="reactions"&&s.segments.length>0)??!1:n==="lines"||!e||Pi(e);ee("layers").replaceChildren(...Object.keys(i).filter(t).map(n=>{let s=ft("button",{type:"button","aria-pressed":String(Tt.layers[n])},i[n]);return s.addEventListener("click",()=>{Tt.setLayers({[n]:!Tt.layers[n]}),s.setAttribute("aria-pressed",String(Tt.layers[n])),eh(),Ye.measure(),Ye.keepInside(!0)}),s}),uE(),...hE)}var hE=[];function uE(){let i=ft("button",{type:"button","aria-pressed":String(Fn.group.visible)},"Drawing");return i.addEventListener("click",()=>{Fn.group.visible=!Fn.group.visible,Tt.drawn=Fn.group.visible,Tt.restyle(),i.setAttribute("aria-pressed",String(Fn.group.visible)),Ye.invalidate()}),i}var dE=2e3,fE=300,pE=1,mE=800,gE=5e3,{requests:wt}=oe,__=0,Hd=0,lh=0,x_=async(i,e)=>(await Bn.submit({...JSON.parse(e),kind:i},{waitS:pE})).info,Pr={submit:async i=>{let{kind:e,request:t}=i;if(Yo)return Gd(i);try{let n=await x_(e,t);return ch("kept"),n}catch(n){if(!(n instanceof Zt)||!wd(e))throw n;return ch("lost"),Gd(i)}},follow:(i,e)=>vE(i,e),mesh:(i,{stop:e})=>Bg(i,e.signal),cancel:i=>Bn.cancel(i.id)},_E={...Pr,submit:async i=>{try{return await Gd(i)}catch(e){if(Yo||!(Ed(e)||Ig(e)&&!i.dragging))throw e;return Pr.submit(i)}}};async function Gd(i){let{kind:e,dragging:t,stop:{signal:n}}=i,s=JSON.parse(i.request);if(t)return Dg(e,s,{signal:n});let r=A_(i);try{return await Og(e,s,{signal:n,onProgress:r.add})}finally{r.end()}}function hh({dragging:i=!1,live:e=!1}={}){return Wd(e&&v_()?_E:Pr,i)}function v_(){let{kind:i,request:e}=we(),{shown:t}=oe;return Rg(i,e)&&!(t?.job.kind===i&&t.mesh.geometry.index.count>3*Md)}var b_=()=>we().kind==="minimal_surface"&&v_(),jI=i=>Wd({...Pr,submit:()=>Promise.resolve(i)}),QI=i=>Wd({...Pr,submit:e=>Bn.getJson(`v1/jobs/${i}`).catch(t=>{if(t instanceof Li)return Pr.submit(e);throw t})});async function Wd(i,e=!1){let{kind:t,request:n,title:s}=we(),r={turn:Qn(),kind:t,request:JSON.stringify(n),title:s,dragging:e,since:performance.now(),stop:new AbortController,source:i},o=wt.underWay;wt.ask(r)?await S_(r):o&&(clearTimeout(lh),lh=window.setTimeout(()=>{T_(o)},o.since+dE-performance.now()))}var S_=i=>ih(async()=>{clearTimeout(lh),i.since=performance.now(),C_(!0,i.dragging),i.dragging||Kt("Solving…");try{await yE(i)}catch(e){wt.enter({phase:"failed",asked:i,job:wt.job,error:e})&&(wt.hasWaiting||(Ls(e,i.turn),Kt("Not solved.")),ea())}});function ea(){let i=wt.next();if(i){S_(i);return}clearTimeout(lh),C_(!1),Qo(),Cr()}var y_=(i,{signal:e})=>new Promise((t,n)=>{e.addEventListener("abort",()=>n(e.reason),{once:!0}),i.then(t,n)});async function yE(i){let{source:e,stop:t}=i,n=e.submit(i);n.then(o=>{t.signal.aborted&&w_(i,o).catch(()=>{})},()=>{});let s=await y_(n,t);if(!wt.isCurrent(i))return;if(Jo(i.turn),mn(s.status)||(wt.enter({phase:"running",asked:i,job:s}),Cr(),s=await e.follow(s,i)),s.status==="failed")throw wt.life.phase==="submitting"&&wt.enter({phase:"running",asked:i,job:s}),new is(s);if(s.status==="cancelled"){wt.enter({phase:"cancelled",asked:i})&&(wt.hasWaiting||Kt("Cancelled."),ea());return}let r=await y_(e.mesh(s,i),t);wt.enter({phase:"shown",asked:i,job:s})&&(xE(i,s,r),ea())}function xE(i,e,t){let n=oe.shown;clearTimeout(Hd),oe.lastDuration=(performance.now()-i.since)/1e3,m_(e,t,i.request,i.dragging),n?.dragging&&n.job.id!==e.id&&!Oi(n.job)&&Bn.delete(n.job.id).catch(()=>{}),Oi(e)?!i.dragging&&!Yo&&(Hd=window.setTimeout(()=>{M_(i)},mE)):(i.dragging||Pd(e,i),Pg(e.kind))}async function M_(i){let{shown:e}=oe,t=()=>oe.shown===e&&e!==null&&e.solved===i.request;if(t())try{let n=await x_(i.kind,i.request),s=mn(n.status)?n:await Bn.waitFor(n);if(ch("kept"),s.status!=="succeeded"||(Pd(s,i),!t()))return;e.job=s,zd(s),sh(),Cr()}catch(n){ch("lost"),n instanceof Zt&&t()&&(Hd=window.setTimeout(()=>{M_(i)},gE))}}function ch(i){ee("unkept").hidden=i==="kept"}var w_=(i,e)=>e&&!mn(e.status)?i.source.cancel(e):Promise.resolve();function E_(i){let{job:e}=wt;return wt.enter({phase:"cancelled",asked:i})?(i.stop.abort(),w_(i,e)):null}function T_(i){let e=E_(i);e&&(e.catch(()=>{}),ea())}function Xd(){wt.dropWaiting();let{underWay:i}=wt;i&&(T_(i),Kt(""))}function e3(){wt.dropWaiting();let{underWay:i}=wt;if(!i)return;let e=E_(i);ea(),Rd();let{life:t}=wt;Kt("Cancelling…"),ih(async()=>{try{await e,wt.life===t&&Kt("Cancelled.")}catch(n){Ls(n,i.turn),wt.life===t&&Kt("Not cancelled.")}})}function A_(i,e="Solving"){let t=[],n=Date.now(),s=!0,r=(a,l)=>{wt.isCurrent(i)&&(s?bE(a,t,n,l):Kt(`Connection interrupted, the job goes on, reconnecting · ${Io((Date.now()-n)/1e3)}`))},o=window.setInterval(()=>r(null),500);return r(null,e),{connect:a=>{s=a,r(null)},add:a=>{let l=t.at(-1);(!l||l.iteration!==a.iteration||l.phase!==a.phase)&&t.push({iteration:a.iteration,phase:a.phase,value:a.objective_value??null,residual:a.residual??null}),r(a)},end:()=>clearInterval(o)}}async function vE(i,e){let t=A_(e,i.status==="queued"?"Waiting in the queue":"Running");try{return await Bn.waitFor(i,{signal:e.stop.signal,onConnection:t.connect,onProgress:t.add})}finally{t.end()}}function C_(i,e=!1){(!i||!e)&&(ee("cancel").hidden=!i),ee("running-charts").replaceChildren();let t=ee("progress");clearTimeout(__),i?(t.removeAttribute("value"),__=window.setTimeout(()=>{t.hidden=ee("cancel").hidden=!1},fE)):t.hidden=!0}function bE(i,e,t,n){let s=Io((Date.now()-t)/1e3),r=e.at(-1),o=ee("progress");i&&(o.value=i.fraction,ee("running-charts").replaceChildren(...vt.parts?.charts(e,we().kind==="minimal_surface"?"Area":"Objective",Vd(we().request))??[]));let a=[o.position>0&&`${Math.round(o.position*100)} %`,n??(r?An(r.phase):"Running"),r&&r.iteration>0&&`iteration ${et(r.iteration)}`,s];Kt(a.filter(Boolean).join(" · "))}var SE=1.2,ME=new rh(ee("gizmo"),Ye,$e.frame),qd=()=>ee("live").checked;function $d({refit:i=!0,direction:e=tg}={}){let{kind:t,request:n}=we();$e.lines=ia(t,n),$e.frame=new On(df($e.lines,n),n),ME.build($e.frame),Tt.putInto($e.frame),tt.prune(),Yd(),Mr(),Ye.measure(),i&&Ye.view(e),P_()}function Yd(){let{kind:i,request:e}=we(),t=document.querySelector(`#kinds input[value="${i}"]`);t&&(t.checked=!0),ee("purpose").textContent=kt[i].purpose;let n=vt.parts?.schemaOf(Ts.openapi,kt[i].path);if(!vt.parts||!n)return;let{build:s,disable:r,OBJECTIVES:o}=vt.parts,a=ee("options"),l={openapi:Ts.openapi,whyNot:c=>l_(i,we().request,c),given:c=>ls(we().request,c.split(".")),unit:c=>{let[h,u]=[Dc(we().request),en(we().request)];return i==="tensile_structure"?{"film.tension":`${h}/${u}`,pressure:`${h}/${u}²`,"film.weight":`${h}/${u}²`}[c]:void 0},set:(c,h)=>{let u=!1,d=structuredClone(we().request);if(Sn.edit(({request:g})=>{h===void 0?delete g[c]:g[c]=h,u=Nd(i,g)}))if((c==="units"||c==="up")&&(ah(),$d()),Ir({option:!0}),c==="units"&&vt.parts.unitChanged(d),u){let{name:g}=document.activeElement;Yd(),g&&a.querySelector(`[name="${CSS.escape(g)}"]`)?.focus()}else r(a,l)},describe:(c,h)=>c==="objective"?o[i]?.[h]:void 0};s(a,n,e,l,i==="tensile_structure"?wE(a,l):null)}function wE(i,e){return vt.parts.cableTable(we().request,pn(we().request),{modes:hd(),found:hg,foundMast:t=>oe.shown?.job.statistics?.masts?.[t],edit:t=>{Sn.edit(({request:n})=>t(n))&&(Ir({option:!0}),vt.parts.disable(i,e))},choose:t=>tt.chooseCable(t),chooseMast:t=>{let n=$e.lines.findIndex(({path:[s,r]})=>s==="masts"&&r===t);tt.stopCabling(),n>=0&&tt.select([{line:n,point:[...$e.lines[n].only][0]}])},hangAll:EE(we().request)?null:()=>{Sn.edit(({request:t})=>qm(t))&&Ir({edited:!0})}})}var EE=i=>rd(i).length===0||!!i.pressure||!!i.volume;function Ir({dragging:i=!1,option:e=!1,edited:t=!1}={}){ee("intro").hidden=!0,oe.card&&oe.card.of!==JSON.stringify(we().request)&&oe.card.close(),oe.viewing=!1,oe.serverFaulty=new Set,$e.lines=ia(we().kind,we().request),tt.prune(),Mr(i),i||(e||Yd(),Ye.measure(),Cr()),P_(i),qd()&&ra(we().kind,we().request)&&we().draft===null&&(!i||oe.lastDuration<SE||b_())&&hh({dragging:i,live:t||e})}function P_(i=!1){ee("undo").disabled=!Sn.canUndo,ee("redo").disabled=!Sn.canRedo,ee("draw").setAttribute("aria-pressed",String(tt.drawing)),ee("draw").disabled=kt[we().kind].lines.length===0,ee("title").textContent=we().title??"",!i&&ee("request-box").open&&TE(),Uc(),Qo()}function TE(){let i=ee("request"),e=uf(we().request);i.defaultValue!==e&&(i.defaultValue=e)}var I_=i=>{let{serial:e}=we();if(!i())return;let t=e!==we().serial;oe.requests.underWay&&(t||oe.requests.underWay.kind!==we().kind)&&Xd(),oe.shown&&(t||oe.shown.job.kind!==we().kind)&&ah(),$d({refit:t}),Ye.rememberWhetherAllIsSeen(),Ir({edited:!0})},y3=()=>I_(()=>Sn.undo()),x3=()=>I_(()=>Sn.redo()),R_=0;function AE(i,e,t,{amend:n=!1}={}){Xd(),Kg(),oe.viewing=!1,oe.cameraGiven=!1,R_+=1;let s=r=>{Object.assign(r,{kind:i,request:e,title:t,draft:null,serial:R_})};n?Sn.amend(s):Sn.edit(s),tt.selection=[],Kt(""),ah(),Jo(),$d()}function v3(i){AE(i,sa(i),null),Kt(""),tt.startDrawing()}function b3(i){Ko("model"),Sn.edit(({request:t})=>{t.objective=i,Nd(we().kind,t)})&&Ir(),qd()||hh()}function S3({apply:i}){Sn.edit(({request:e})=>i(e))&&Ir(),qd()||hh()}export{CE as a,RE as b,PE as c,_i as d,Rs as e,Li as f,is as g,Zt as h,wg as i,$o as j,Yo as k,Bn as l,Tg as m,hP as n,uP as o,ee as p,ft as q,Ui as r,af as s,kt as t,en as u,Or as v,OE as w,je as x,ia as y,ra as z,DE as A,uf as B,pn as C,Ac as D,sd as E,An as F,Po as G,ji as H,EC as I,et as J,Qi as K,dI as L,l_ as M,Nd as N,Ji as O,dn as P,qt as Q,He as R,Un as S,C as T,it as U,ot as V,Hi as W,rn as X,mt as Y,Gn as Z,fs as _,fo as $,On as aa,df as ba,ym as ca,xm as da,yC as ea,vm as fa,xC as ga,Hu as ha,GS as ia,kC as ja,Lo as ka,pr as la,gc as ma,Qn as na,ih as oa,Kg as pa,kP as qa,Dc as ra,jM as sa,LR as ta,zM as ua,tg as va,Es as wa,ng as xa,vt as ya,Ts as za,oe as Aa,Sn as Ba,we as Ca,Lc as Da,cd as Ea,Ye as Fa,Fn as Ga,Tt as Ha,$e as Ia,tt as Ja,Mr as Ka,ag as La,hg as Ma,Uc as Na,QM as Oa,og as Pa,nw as Qa,Oi as Ra,wd as Sa,Ed as Ta,Og as Ua,Bg as Va,kg as Wa,Kt as Xa,SP as Ya,Vg as Za,Hg as _a,Ad as $a,Cw as ab,MP as bb,Rw as cb,eh as db,wP as eb,Pw as fb,EP as gb,TP as hb,Dw as ib,Cr as jb,Rd as kb,OP as lb,Nw as mb,DP as nb,Uw as ob,Fw as pb,Vw as qb,Jo as rb,Hw as sb,Ls as tb,qw as ub,oI as vb,Ko as wb,aI as xb,lI as yb,Qw as zb,jo as Ab,nE as Bb,ah as Cb,m_ as Db,oE as Eb,BI as Fb,hE as Gb,hh as Hb,jI as Ib,QI as Jb,Xd as Kb,e3 as Lb,ME as Mb,qd as Nb,$d as Ob,Yd as Pb,Ir as Qb,P_ as Rb,TE as Sb,y3 as Tb,x3 as Ub,AE as Vb,v3 as Wb,b3 as Xb,S3 as Yb};
