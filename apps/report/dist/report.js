/*!
The page of clothfit report holds these libraries.

three 0.180.0 (MIT)

The MIT License

Copyright © 2010-2025 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

---

uplot 1.6.32 (MIT)

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

---

fflate 0.8.2 (MIT)

MIT License

Copyright (c) 2023 Arjun Barrett

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all
copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
SOFTWARE.
*/
(()=>{var ii=Uint8Array,Mr=Uint16Array,o_=Int32Array,ad=new ii([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),ld=new ii([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),a_=new ii([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),cd=function(n,t){for(var e=new Mr(31),i=0;i<31;++i)e[i]=t+=1<<n[i-1];for(var s=new o_(e[30]),i=1;i<30;++i)for(var r=e[i];r<e[i+1];++r)s[r]=r-e[i]<<5|i;return{b:e,r:s}},hd=cd(ad,2),ud=hd.b,l_=hd.r;ud[28]=258,l_[258]=28;var fd=cd(ld,0),c_=fd.b,eT=fd.r,Ah=new Mr(32768);for(ye=0;ye<32768;++ye)qi=(ye&43690)>>1|(ye&21845)<<1,qi=(qi&52428)>>2|(qi&13107)<<2,qi=(qi&61680)>>4|(qi&3855)<<4,Ah[ye]=((qi&65280)>>8|(qi&255)<<8)>>1;var qi,ye,Ao=(function(n,t,e){for(var i=n.length,s=0,r=new Mr(t);s<i;++s)n[s]&&++r[n[s]-1];var o=new Mr(t);for(s=1;s<t;++s)o[s]=o[s-1]+r[s-1]<<1;var a;if(e){a=new Mr(1<<t);var l=15-t;for(s=0;s<i;++s)if(n[s])for(var c=s<<4|n[s],u=t-n[s],h=o[n[s]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[Ah[h]>>l]=c}else for(a=new Mr(i),s=0;s<i;++s)n[s]&&(a[s]=Ah[o[n[s]-1]++]>>15-n[s]);return a}),Co=new ii(288);for(ye=0;ye<144;++ye)Co[ye]=8;var ye;for(ye=144;ye<256;++ye)Co[ye]=9;var ye;for(ye=256;ye<280;++ye)Co[ye]=7;var ye;for(ye=280;ye<288;++ye)Co[ye]=8;var ye,dd=new ii(32);for(ye=0;ye<32;++ye)dd[ye]=5;var ye;var h_=Ao(Co,9,1);var u_=Ao(dd,5,1),Th=function(n){for(var t=n[0],e=1;e<n.length;++e)n[e]>t&&(t=n[e]);return t},di=function(n,t,e){var i=t/8|0;return(n[i]|n[i+1]<<8)>>(t&7)&e},Eh=function(n,t){var e=t/8|0;return(n[e]|n[e+1]<<8|n[e+2]<<16)>>(t&7)},f_=function(n){return(n+7)/8|0},d_=function(n,t,e){return(t==null||t<0)&&(t=0),(e==null||e>n.length)&&(e=n.length),new ii(n.subarray(t,e))};var p_=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],pi=function(n,t,e){var i=new Error(t||p_[n]);if(i.code=n,Error.captureStackTrace&&Error.captureStackTrace(i,pi),!e)throw i;return i},m_=function(n,t,e,i){var s=n.length,r=i?i.length:0;if(!s||t.f&&!t.l)return e||new ii(0);var o=!e,a=o||t.i!=2,l=t.i;o&&(e=new ii(s*3));var c=function(Kt){var be=e.length;if(Kt>be){var L=new ii(Math.max(be*2,Kt));L.set(e),e=L}},u=t.f||0,h=t.p||0,f=t.b||0,p=t.l,_=t.d,v=t.m,m=t.n,d=s*8;do{if(!p){u=di(n,h,1);var T=di(n,h+1,3);if(h+=3,T)if(T==1)p=h_,_=u_,v=9,m=5;else if(T==2){var R=di(n,h,31)+257,N=di(n,h+10,15)+4,B=R+di(n,h+5,31)+1;h+=14;for(var w=new ii(B),b=new ii(19),C=0;C<N;++C)b[a_[C]]=di(n,h+C*3,7);h+=N*3;for(var G=Th(b),H=(1<<G)-1,q=Ao(b,G,1),C=0;C<B;){var X=q[di(n,h,H)];h+=X&15;var E=X>>4;if(E<16)w[C++]=E;else{var Z=0,J=0;for(E==16?(J=3+di(n,h,3),h+=2,Z=w[C-1]):E==17?(J=3+di(n,h,7),h+=3):E==18&&(J=11+di(n,h,127),h+=7);J--;)w[C++]=Z}}var Q=w.subarray(0,R),ot=w.subarray(R);v=Th(Q),m=Th(ot),p=Ao(Q,v,1),_=Ao(ot,m,1)}else pi(1);else{var E=f_(h)+4,M=n[E-4]|n[E-3]<<8,D=E+M;if(D>s){l&&pi(0);break}a&&c(f+M),e.set(n.subarray(E,D),f),t.b=f+=M,t.p=h=D*8,t.f=u;continue}if(h>d){l&&pi(0);break}}a&&c(f+131072);for(var at=(1<<v)-1,vt=(1<<m)-1,yt=h;;yt=h){var Z=p[Eh(n,h)&at],mt=Z>>4;if(h+=Z&15,h>d){l&&pi(0);break}if(Z||pi(2),mt<256)e[f++]=mt;else if(mt==256){yt=h,p=null;break}else{var Qt=mt-254;if(mt>264){var C=mt-257,Yt=ad[C];Qt=di(n,h,(1<<Yt)-1)+ud[C],h+=Yt}var tt=_[Eh(n,h)&vt],et=tt>>4;tt||pi(3),h+=tt&15;var ot=c_[et];if(et>3){var Yt=ld[et];ot+=Eh(n,h)&(1<<Yt)-1,h+=Yt}if(h>d){l&&pi(0);break}a&&c(f+131072);var St=f+Qt;if(f<ot){var Ft=r-ot,xt=Math.min(ot,St);for(Ft+f<0&&pi(3);f<xt;++f)e[f]=i[Ft+f]}for(;f<St;++f)e[f]=e[f-ot]}}t.l=p,t.p=yt,t.b=f,t.f=u,p&&(u=1,t.m=v,t.d=_,t.n=m)}while(!u);return f!=e.length&&o?d_(e,0,f):e.subarray(0,f)};var g_=new ii(0);var __=function(n,t){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&pi(6,"invalid zlib data"),(n[1]>>5&1)==+!t&&pi(6,"invalid zlib data: "+(n[1]&32?"need":"unexpected")+" dictionary"),(n[1]>>3&4)+2};function pd(n,t){return m_(n.subarray(__(n,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var v_=typeof TextDecoder<"u"&&new TextDecoder,x_=0;try{v_.decode(g_,{stream:!0}),x_=1}catch{}var y_=65535,M_=65534;function md(){return JSON.parse(document.getElementById("report-data").textContent)}function S_(n){let t=document.getElementById(`blob-${n.blob}`).textContent;if(Uint8Array.fromBase64)return Uint8Array.fromBase64(t);let e=atob(t),i=new Uint8Array(e.length);for(let s=0;s<i.length;++s)i[s]=e.charCodeAt(s);return i}async function b_(n){if(typeof DecompressionStream>"u")return pd(n);let t=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Uint8Array(await new Response(t).arrayBuffer())}function w_(n,t,e,i){let s=i===2?new Uint16Array(t):new Int32Array(t);for(let r=0;r<t;++r){let o=r<e?0:s[r-e],a=0;for(let l=0;l<i;++l)a|=n[l*t+r]<<8*l;o+=a,s[r]=o}return s}async function T_(n){let t=S_(n);if(n.type==="bytes")return t;let e=n.shape.reduce((l,c)=>l*c,1),i=n.shape.slice(1).reduce((l,c)=>l*c,1),s=w_(await b_(t),e,i,n.type==="u16"?2:4);if(n.type==="i32")return s;let r=n.shape[n.shape.length-1],o=n.lower.map((l,c)=>(n.upper[c]-l)/M_),a=new Float32Array(e);for(let l=0;l<e;++l){let c=l%r;a[l]=s[l]===y_?NaN:n.lower[c]+s[l]*o[c]}return a}var Ch=new Map;function Ee(n){return Ch.has(n.blob)||Ch.set(n.blob,T_(n)),Ch.get(n.blob)}function V(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t??{}))r==null||r===!1||(s.startsWith("on")?i.addEventListener(s.slice(2),r):i.setAttribute(s,r===!0?"":r));return i.append(...e.flat().filter(s=>s!=null)),i}function gd(n,t,e,i){let s=t.map(r=>V("button",{type:"button","aria-pressed":String(r.value===e),onclick:()=>{t.forEach((o,a)=>s[a].setAttribute("aria-pressed",String(o===r))),i(r.value)}},r.title));return V("div",{class:"segmented",role:"group","aria-label":n},s)}function Ro(n,t,e,i){let s=V("input",{type:"checkbox",checked:t,onchange:()=>e(s.checked)}),r=i?V("span",{class:"swatch",style:`--swatch: ${i}`}):null;return V("label",{class:"check"},s,r,V("span",{},n))}function Sr(n,t,e,i){let s=V("select",{"aria-label":n,onchange:()=>i(s.value)},t.map(r=>V("option",{value:r.value,selected:r.value===e},r.title)));return s}var Rh=new Set,_d=new Set;function br(n,t){let e=()=>{i.disconnect(),Rh.delete(e)&&t()},i=new IntersectionObserver(s=>{s.some(r=>r.isIntersecting)&&e()},{rootMargin:"300px"});Rh.add(e),i.observe(n)}function wr(n,t){let e=!1;new IntersectionObserver(i=>{e=i[i.length-1].isIntersecting,t(e)}).observe(n),_d.add(()=>{e||(t(!0),t(!1))})}function Ph(){let[n]=Rh;return n?.(),!!n}function Na(){for(;Ph(););for(let n of _d)n()}function vd(n,t,e){let i=new Int32Array(e+1);for(let s=0;s<n.length;s+=t)++i[n[s]+1];for(let s=0;s<e;++s)i[s+1]+=i[s];return i}async function xd(n){let{points:t,markers:e,tracks:i}=n.observations,s=n.clock.frames,r={nodes:await Ee(t.nodes),weights:await Ee(t.weights),markers:null,tracks:null};if(e){let o=await Ee(e.items);r.markers={items:o,first:vd(o,2,s),positions:await Ee(e.positions)}}if(i){let o=await Ee(i.items);r.tracks={items:o,first:vd(o,3,s),pixels:await Ee(i.pixels)}}return r}function Po(n,t,e,i,s,r){for(let o=0;o<3;++o){let a=0;for(let l=0;l<3;++l){let c=n.nodes[3*t+l];a+=n.weights[3*t+l]*e[i+3*c+o]}s[r+o]=a}}function Tr(n){let{rotation:t,translation:e}=n;return[0,1,2].map(i=>-(t[i]*e[0]+t[3+i]*e[1]+t[6+i]*e[2]))}function Ih(n,t){let{rotation:e}=n;return[0,1,2].map(i=>e[i]*t[0]+e[3+i]*t[1]+e[6+i]*t[2])}function Fa(n,t,e,i,s,r){let{rotation:o,translation:a,focal:l,centre:c,distortion:[u,h,f,p,_]}=n;for(let v=0;v<i;++v){let m=t[e+3*v],d=t[e+3*v+1],T=t[e+3*v+2],E=o[6]*m+o[7]*d+o[8]*T+a[2],M=(o[0]*m+o[1]*d+o[2]*T+a[0])/E,D=(o[3]*m+o[4]*d+o[5]*T+a[1])/E,R=M*M+D*D,N=1+R*(u+R*(h+R*_));s[2*v]=l[0]*(M*N+2*f*M*D+p*(R+2*M*M))+c[0],s[2*v+1]=l[1]*(D*N+f*(R+2*D*D)+2*p*M*D)+c[1],r[v]=E>1e-6?1:0}}function yd(n,t,e){let{focal:i,centre:s,distortion:[r,o,a,l,c]}=n,u=(t-s[0])/i[0],h=(e-s[1])/i[1],f=u,p=h;for(let v=0;v<12;++v){let m=f*f+p*p,d=1+m*(r+m*(o+m*c));[f,p]=[(u-2*a*f*p-l*(m+2*f*f))/d,(h-a*(m+2*p*p)-2*l*f*p)/d]}let _=Math.hypot(f,p,1);return Ih(n,[f/_,p/_,1/_])}async function Md(n){if(!n.outlines)return null;let t=await Ee(n.outlines.corners),e=await Ee(n.outlines.polygons),i=new Map,s=0;for(let r=0;r<e.length;r+=2){let[o,a]=[e[r],e[r+1]];i.has(o)||i.set(o,new Path2D);let l=i.get(o);l.moveTo(t[s],t[s+1]);for(let c=1;c<a;++c)l.lineTo(t[s+2*c],t[s+2*c+1]);l.closePath(),s+=2*a}return i}function Sd(n){let t=new Map;for(let e=0;e<n.length;e+=3)for(let i=0;i<3;++i){let[s,r]=[n[e+i],n[e+(i+1)%3]].sort((a,l)=>a-l),o=s*1048576+r;t.has(o)?t.get(o)[3]=e/3:t.set(o,[s,r,e/3,-1])}return new Int32Array([...t.values()].flat())}var Oa=class{constructor(t,e,i){this.camera=t,this.mesh=e,this.cloth=i,this.pixels=new Float32Array(2*i.particles),this.inFront=new Uint8Array(i.particles),this.sides=new Int8Array(e.triangles.length/3)}at(t){let{positions:e,particles:i,frames:s}=this.cloth;return t>=s?null:(Fa(this.camera,e,3*i*t,i,this.pixels,this.inFront),{inside:this.inside(),contours:this.contours(),box:this.box()})}inside(){let t=new Path2D,{pixels:e,inFront:i,sides:s,mesh:{triangles:r}}=this;for(let o=0;o<r.length;o+=3){let[a,l,c]=[r[o],r[o+1],r[o+2]];if(s[o/3]=0,!i[a]||!i[l]||!i[c])continue;let u=(e[2*l]-e[2*a])*(e[2*c+1]-e[2*a+1])-(e[2*c]-e[2*a])*(e[2*l+1]-e[2*a+1]);s[o/3]=u>0?1:-1;let[h,f]=u>0?[l,c]:[c,l];t.moveTo(e[2*a],e[2*a+1]),t.lineTo(e[2*h],e[2*h+1]),t.lineTo(e[2*f],e[2*f+1])}return t}contours(){let t=new Path2D,{pixels:e,sides:i,mesh:{edges:s}}=this;for(let r=0;r<s.length;r+=4){let o=i[s[r+2]],a=s[r+3]<0?0:i[s[r+3]];o!==a&&(t.moveTo(e[2*s[r]],e[2*s[r]+1]),t.lineTo(e[2*s[r+1]],e[2*s[r+1]+1]))}return t}box(){let t=[1/0,1/0,-1/0,-1/0];for(let e=0;e<this.inFront.length;++e)if(this.inFront[e])for(let i=0;i<2;++i)t[i]=Math.min(t[i],this.pixels[2*e+i]),t[2+i]=Math.max(t[2+i],this.pixels[2*e+i]);return t}},Dh={willReadFrequently:!0},ps=null;function E_(n,t){return ps??=document.createElement("canvas"),(ps.width<n||ps.height<t)&&(ps.width=Math.max(n,ps.width),ps.height=Math.max(t,ps.height)),ps.getContext("2d",Dh)}function bd(n,{inside:t,contours:e,box:i},s,r,o){let{width:a,height:l}=n.canvas,c=(m,d)=>Math.round(Math.max(0,Math.min(d,m))),u=2*o+2,[h,f]=[c(i[0]*r-u,a),c(i[1]*r-u,l)],p=c(i[2]*r+u,a)-h,_=c(i[3]*r+u,l)-f;if(!(p>0&&_>0))return;let v=E_(a,l);v.setTransform(1,0,0,1,0,0),v.clearRect(h,f,p,_),v.setTransform(r,0,0,r,.5*r,.5*r),v.lineWidth=2*o/r,v.lineCap="round",v.strokeStyle=s,v.fillStyle=s,v.stroke(e),v.globalCompositeOperation="destination-out",v.fill(t),v.globalCompositeOperation="source-over",n.setTransform(1,0,0,1,0,0),n.drawImage(v.canvas,h,f,p,_,h,f,p,_)}var A_=90,Ba=class{constructor(t){this.block=t.pictures,this.kept=new Map,this.waiting=new Set}get isEmpty(){return!this.block}indexAt(t){let{frames:e}=this.block,i=0;for(;i+1<e.length&&e[i+1]<=t;)++i;return i}frameOf(t){return this.block.frames[t]}get(t,e){return this.kept.has(t)?this.kept.get(t):(this.waiting.has(t)||this.load(t).then(e),null)}prefetch(t){let{frames:e}=this.block;for(let i=1;i<=3;++i){let s=(t+i)%e.length;!this.kept.has(s)&&!this.waiting.has(s)&&this.load(s)}}async load(t){this.waiting.add(t);let e=await Ee(this.block),{ends:i}=this.block,s=e.subarray(t>0?i[t-1]:0,i[t]),r=await createImageBitmap(new Blob([s],{type:"image/jpeg"}));if(this.waiting.delete(t),this.kept.set(t,r),this.kept.size>A_){let[o]=this.kept.keys();this.kept.get(o).close(),this.kept.delete(o)}}};var ms={measured:"#ffffff",before:"#ff9a3c",after:"#3fc1ff",miss:"#ff4fa3"},ka=class{constructor(t,e,i,s){let r={triangles:i,edges:Sd(i)};Object.assign(this,{report:t,observations:e,mesh:r,cloths:s}),this.layers=new Set(["measured","after"]),this.views=new Set}setLayer(t,e){e?this.layers.add(t):this.layers.delete(t);for(let i of this.views)i.draw()}},Io=class{constructor(t,e,i,{maxWidth:s=720}={}){this.context=t,this.player=i,this.maxWidth=s,this.canvas=V("canvas",{role:"img"}),this.note=V("span",{class:"picture-note"}),this.element=V("div",{class:"camera-view"},this.canvas,this.note),this.isSeen=!1,this.setCamera(e),wr(this.element,r=>{this.isSeen=r,r&&this.draw()}),t.views.add(this),i.onFrame(()=>{this.frame()!==this.drawn&&this.draw()})}setCamera(t){this.index=t,this.camera=this.context.report.cameras[t],this.store=new Ba(this.camera),this.paths=Object.fromEntries(Object.entries(this.context.cloths).map(([s,r])=>[s,new Oa(this.camera,this.context.mesh,r)])),this.outlines=null,this.last=null;let[e,i]=this.camera.size;this.canvas.style.aspectRatio=`${e} / ${i}`,this.canvas.setAttribute("aria-label",`camera ${this.camera.name} with outlines`),Md(this.camera).then(s=>{this.outlines=s,this.draw()}),this.draw()}frame(){return this.store.isEmpty?this.player.frame:this.store.frameOf(this.store.indexAt(this.player.frame))}draw(){if(!this.isSeen)return;this.fit();let t=this.canvas.getContext("2d",{...Dh,alpha:!1}),e=this.canvas.width/this.camera.size[0];t.setTransform(1,0,0,1,0,0);let i=this.drawPicture(t);this.drawn=i;let{layers:s}=this.context,r=Math.max(1.25,this.canvas.width/420);s.has("measured")&&this.outlines?.has(i)&&(t.setTransform(e,0,0,e,.5*e,.5*e),t.lineWidth=r/e,t.strokeStyle=ms.measured,t.stroke(this.outlines.get(i)));for(let[o,a]of Object.entries(this.paths)){let l=s.has(o)?a.at(i):null;l&&bd(t,l,ms[o]??"#fff",e,r)}s.has("points")&&this.drawPoints(t,i,e,r)}fit(){let t=Math.min(2,window.devicePixelRatio||1),e=this.canvas.clientWidth||320,i=Math.round(Math.min(this.maxWidth,e*t)),s=Math.round(i*this.camera.size[1]/this.camera.size[0]);(this.canvas.width!==i||this.canvas.height!==s)&&(this.canvas.width=i,this.canvas.height=s)}drawPicture(t){let{width:e,height:i}=this.canvas;if(t.fillStyle="#20252b",t.fillRect(0,0,e,i),this.store.isEmpty)return this.note.textContent="no pictures: outlines only",this.player.frame;let s=this.store.indexAt(this.player.frame),r=this.store.get(s,()=>this.draw());r&&(this.last={image:r,frame:this.store.frameOf(s)}),this.last?.image.width&&t.drawImage(this.last.image,0,0,e,i),this.player.isPlaying&&this.store.prefetch(s);let o=this.last?.frame??this.store.frameOf(s);return this.note.textContent=o===this.player.frame?"":`frame ${o}`,o}drawPoints(t,e,i,s){let{observations:r,cloths:o}=this.context,a=Object.values(o).at(-1);if(!r.tracks||e>=a.frames)return;let{first:l,items:c,pixels:u}=r.tracks,h=new Float32Array(3),f=new Float32Array(2),p=new Uint8Array(1),_=2.6*s/i;t.setTransform(i,0,0,i,.5*i,.5*i),t.lineWidth=s/i,t.strokeStyle=ms.miss,t.fillStyle=ms.measured,t.beginPath();for(let v=l[e];v<l[e+1];++v)c[3*v+1]===this.index&&(Po(r,c[3*v+2],a.positions,3*a.particles*e,h,0),Fa(this.camera,h,0,1,f,p),t.fillRect(u[2*v]-_/2,u[2*v+1]-_/2,_,_),p[0]&&(t.moveTo(u[2*v],u[2*v+1]),t.lineTo(f[0],f[1])));t.stroke()}};function C_(n){let t=(r,o,a)=>Ro(o,n.layers.has(r),l=>n.setLayer(r,l),a),{cameras:e,motions:i,observations:s}=n.report;return[e.some(r=>r.outlines)?t("measured","Measured",ms.measured):null,...i.map(({name:r,title:o})=>t(r,o,ms[r]??"#fff")),s.tracks?t("points","Tracks",ms.miss):null]}function R_(n){return Math.max(0,n.findIndex(t=>t.pictures))}var za=class{constructor(t,e,i){this.onCamera=i;let{cameras:s}=t.report;this.index=R_(s),this.view=new Io(t,this.index,e),this.choice=Sr("Camera",s.map((r,o)=>({value:String(o),title:r.name+(r.held_out?" (held out)":"")})),String(this.index),r=>this.setCamera(Number(r))),this.element=V("figure",{class:"panel picture-panel"},V("div",{class:"view",id:"view-picture"},this.view.element),V("figcaption",{class:"controls"},V("label",{class:"field-choice"},V("span",{},"Camera"),this.choice),V("span",{class:"checks"},C_(t))))}setCamera(t){this.index=t,this.choice.value=String(t),this.view.setCamera(t),this.onCamera(t)}};function wd(n,t,e){let i=n.report.cameras.map((s,r)=>{let o=new Io(n,r,t,{maxWidth:480});return V("button",{type:"button",class:"camera-tile",title:`Show ${s.name} beside the 3D view`,onclick:()=>{e.setCamera(r),e.element.scrollIntoView({behavior:"smooth",block:"center"})}},o.element,V("span",{class:"camera-name"},s.name,s.held_out?V("em",{}," held out"):null))});return V("div",{class:"camera-grid"},i)}var Ad=new Set,Cd="clothfit-report-theme";function Td(){try{return localStorage.getItem(Cd)}catch{return null}}function P_(n){try{localStorage.setItem(Cd,n)}catch{}}function Ed(){return document.documentElement.dataset.theme==="dark"}function Va(n){Ad.add(n)}function qe(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function Do(n){document.documentElement.dataset.theme=n;for(let t of Ad)t()}function Rd(n){let t=document.documentElement.dataset.theme;return Do(n),()=>Do(t)}function Pd(){let n=matchMedia("(prefers-color-scheme: dark)");return Do(Td()??(n.matches?"dark":"light")),n.addEventListener("change",()=>{Td()||Do(n.matches?"dark":"light")}),V("button",{type:"button",class:"theme","aria-label":"Light or dark",title:"Light or dark",onclick:()=>{P_(Ed()?"light":"dark"),Do(Ed()?"light":"dark")}},"\u25D0")}var Lh=window.requestIdleCallback??(n=>setTimeout(n,200));function I_(n){let t=()=>{Ph()?Lh(t,{timeout:1500}):Na()};Lh(t,{timeout:3e3}),n.onState(()=>{n.isPlaying||Lh(()=>{n.isPlaying||Na()},{timeout:1500})})}function D_(n){n.draw();let{canvas:t}=n,e=V("canvas",{class:"on-paper",width:t.width,height:t.height});return e.getContext("2d").drawImage(t,0,0),t.after(e),e}function Id(n,t){I_(n);let e=[];window.addEventListener("beforeprint",()=>{n.pause(),e.push(Rd("light")),Na();for(let s of document.querySelectorAll("details.folded:not([open])"))s.open=!0,e.push(()=>{s.open=!1});if(!t)return;let i=D_(t);e.push(()=>i.remove())}),window.addEventListener("afterprint",()=>{for(let i of e)i();e=[]})}var Ha=class{constructor({frames:t,rate:e}){this.frames=t,this.rate=e,this.speed=1,this.frame=0,this.isPlaying=!1,this.frameListeners=new Set,this.stateListeners=new Set,this.tick=this.tick.bind(this)}onFrame(t){return this.frameListeners.add(t),t(this.frame),()=>this.frameListeners.delete(t)}onFrameSlowly(t){let e=-1/0;this.onFrame(i=>{let s=performance.now();this.isPlaying&&s-e<120||(e=s,t(i))}),this.onState(()=>t(this.frame))}onState(t){this.stateListeners.add(t),t(this)}seek(t){let e=Math.max(0,Math.min(this.frames-1,Math.round(t)));if(this.exact=e,e!==this.frame){this.frame=e;for(let i of this.frameListeners)i(e)}}play(){this.isPlaying||(this.isPlaying=!0,this.last=performance.now(),this.exact=this.frame,requestAnimationFrame(this.tick),this.tellState())}pause(){this.isPlaying=!1,this.tellState()}toggle(){this.isPlaying?this.pause():this.play()}setSpeed(t){this.speed=t,this.tellState()}tellState(){for(let t of this.stateListeners)t(this)}tick(t){if(!this.isPlaying)return;let e=Math.min(.1,Math.max(0,(t-this.last)/1e3));this.last=t,this.exact+=e*this.rate*this.speed,this.exact>=this.frames&&(this.exact=0);let i=Math.min(this.frames-1,Math.floor(this.exact));if(i!==this.frame){this.frame=i;for(let s of this.frameListeners)s(i)}requestAnimationFrame(this.tick)}};function ge(n,t=4){if(n==null||!Number.isFinite(n))return"\u2013";if(n===0)return"0";let e=Math.abs(n);if(e>=1e5||e<.001){let[i,s]=n.toExponential(t-1).split("e");return`${Number(i)}\xD710${L_(Number(s))}`}return String(Number(n.toPrecision(t)))}function L_(n){let t="\u2070\xB9\xB2\xB3\u2074\u2075\u2076\u2077\u2078\u2079",e=[...String(Math.abs(n))].map(i=>t[Number(i)]).join("");return(n<0?"\u207B":"")+e}function Dd(n){return`${n.toFixed(2)} s`}function Uh(n){return n==="m"?{factor:1e3,unit:"mm"}:n==="1"?{factor:100,unit:"%"}:{factor:1,unit:n}}function bn(n){return(n??"").replaceAll("^2","\xB2").replaceAll("^3","\xB3")}function Ld(n,t,e=3){let i=Uh(t);return`${ge(n*i.factor,e)} ${bn(i.unit)}`}function U_(n){let t=n.items.flatMap(e=>[e.value,...e.interval??[]].filter(Number.isFinite));return[Math.min(0,...t),Math.max(0,...t)||1]}function N_(n,t,[e,i]){let s=u=>`${100*(u-e)/(i-e)}%`,r=(u,h)=>`${100*Math.abs(h-u)/(i-e)}%`,o=s(Math.min(0,n.value)),[a,l]=n.interval??[],c=Number.isFinite(a)&&Number.isFinite(l)?V("span",{class:"whisker",style:`left: ${s(a)}; width: ${r(a,l)}`}):null;return V("div",{class:`bar-row ${n.muted?"muted":""} ${n.marked?"marked":""}`,role:"listitem"},V("span",{class:"bar-name"},n.name),V("span",{class:"bar-track"},V("span",{class:"bar",style:`left: ${o}; width: ${r(0,n.value)}`}),c),V("span",{class:"bar-value"},`${ge(n.value,3)} ${bn(t.unit)}`,n.note?V("small",{},n.note):null))}function Ud(n){let t=U_(n);return V("figure",{class:"chart"},V("figcaption",{},n.title),V("div",{class:"bars",role:"list"},n.items.map(e=>N_(e,n,t))))}var Nd=[[.2777273272,.0054073445,.3340998053],[.1050930431,1.4046135299,1.3845901626],[-.3308618287,.2148475595,.095095163],[-4.634230499,-5.7991009734,-19.3324409563],[6.2282699363,14.1799333668,56.6905526007],[4.7763849977,-13.7451453777,-65.3530326334],[-5.4354558559,4.6458526122,26.3124352496]];function F_(n){return[0,1,2].map(t=>{let e=0;for(let i=Nd.length-1;i>=0;--i)e=e*n+Nd[i][t];return Math.max(0,Math.min(1,e))})}var Ga=[[.03,.19,.42],[.13,.4,.68],[.57,.77,.87],[.96,.96,.95],[.96,.73,.44],[.72,.36,.05],[.42,.19,.01]];function O_(n){let t=n*(Ga.length-1),e=Math.min(Ga.length-2,Math.floor(t)),i=t-e;return[0,1,2].map(s=>Ga[e][s]*(1-i)+Ga[e+1][s]*i)}var Nh=[.55,.55,.55];function Lo(n,t,e){if(!Number.isFinite(n))return Nh;let i=Math.max(0,Math.min(1,(n-t[0])/(t[1]-t[0]||1)));return e?O_(i):F_(i)}function B_(n){return`rgb(${n.map(t=>Math.round(255*t)).join(" ")})`}function Wa(n){return`linear-gradient(to right, ${Array.from({length:13},(e,i)=>B_(Lo(i/12,[0,1],n))).join(", ")})`}function Fd(n,t){return n.frames?n.values[Math.min(t,n.values.length-1)]:n.values}function k_(n){let[t,e]=[1/0,-1/0];for(let r of n.flatMap(o=>o.values.flat(2)))r!==null&&(t=Math.min(t,r),e=Math.max(e,r));let i=n[0].diverging,s=Math.max(Math.abs(t),Math.abs(e))||1;return i?[-s,s]:[Math.min(0,t),e>t?e:t+1]}function z_(n,t,e,i){n.width=t[0].length,n.height=t.length;let s=n.getContext("2d"),r=s.createImageData(n.width,n.height);t.forEach((o,a)=>o.forEach((l,c)=>{let u=l===null?Nh:Lo(l,e,i),h=4*(c+(t.length-1-a)*n.width);r.data.set([255*u[0],255*u[1],255*u[2],255],h)})),s.putImageData(r,0,0)}function Od(n){return[ge(n.range[0],3),`${n.title}${n.unit?`, ${n.unit}`:""}`,ge(n.range[1],3)]}function Bd(n,{player:t,section:e}){let i=V("canvas",{role:"img","aria-label":`${n.value.title}: ${n.title}`}),s=V("span",{class:"readout"},"\xA0"),r=e.blocks.filter(h=>h===n||n.group&&h.kind==="heatmap"&&h.group===n.group),o=k_(r),a=bn(n.value.unit);i.addEventListener("pointermove",h=>{let f=Fd(n,t.frame),p=i.getBoundingClientRect(),_=Math.floor((h.clientX-p.left)/p.width*f[0].length),v=Math.floor((1-(h.clientY-p.top)/p.height)*f.length),m=f[v]?.[_];s.textContent=m===void 0?"\xA0":`${ge(m,3)} ${m===null?"":a}`}),i.addEventListener("pointerleave",()=>{s.textContent="\xA0"});let l=h=>z_(i,Fd(n,h),o,n.diverging),c=h=>h.range[1]-h.range[0]||1;i.style.aspectRatio=n.stretch?"1":`${Math.max(.4,Math.min(2.5,c(n.u)/c(n.v)))}`;let u=V("figure",{class:"chart heatmap"},V("figcaption",{},n.title,s),V("div",{class:"heat-body"},V("div",{class:"heat-v"},Od(n.v).reverse().map(h=>V("span",{},h))),i,V("div",{class:"heat-u"},Od(n.u).map(h=>V("span",{},h)))),V("div",{class:"legend-row"},V("span",{},`${n.value.title}, ${a}`),V("span",{},ge(o[0],2)),V("span",{class:"ramp",style:`background: ${Wa(n.diverging)}`}),V("span",{},ge(o[1],3))));if(n.frames){let h=!1;wr(u,f=>{h=f,f&&l(t.frame)}),t.onFrame(f=>{h&&l(f)})}else br(u,()=>l(0));return u}function Fh(n,t){let e=n.scale==="log",i=h=>e?Math.log(h):h,s=h=>e?Math.exp(h):h,r=h=>Number.isFinite(h)&&(!e||h>0),o=t.filter(r).map(i),[a,l]=[Math.min(...o),Math.max(...o)],c=.04*(l-a)||1;return{share:h=>Number.isFinite(h)?100*((r(h)?i(h):a-c)-a+c)/(l-a+2*c):null,ends:[s(a),s(l)]}}function Oh(n,t){return t===null?null:Math.min(n.bounds[1],Math.max(n.bounds[0],t))}function Xa(n,[t,e],i,s){let[r,o]=[n.share(Math.max(t??-1/0,s.bounds[0])),n.share(Math.min(e??1/0,s.bounds[1]))];if(r===null||o===null)return null;let a=Math.max(0,r),l=Math.min(100,o)-a;return V("span",{class:i,style:`left: ${a}%; width: ${l}%`})}function Er(n,t,e,i){let s=n.share(t);return s===null||t===null?null:V("span",{class:e,style:`left: ${s}%`,title:`${i}: ${ge(t)}`})}function Bh(n,t){return V("span",{class:"axis-ends"},V("span",{},ge(n.ends[0],2)),V("span",{},t.scale==="log"?"log":""),V("span",{},ge(n.ends[1],2)))}function V_(n){let t=Fh(n,[...[...n.prior??[],...n.interval??[]].map(s=>Oh(n,s)),n.value,n.start,n.truth]),[e,i]=n.interval??[null,null];return V("div",{class:`interval-row ${n.muted?"muted":""}`,role:"listitem"},V("span",{class:"interval-name"},V("code",{},n.name),n.doc?V("small",{},n.doc):null),V("span",{class:"interval-axis"},V("span",{class:"axis-line"},n.prior?Xa(t,n.prior,"prior",n):null,n.interval?Xa(t,n.interval,"posterior",n):null,Er(t,n.start,"start","start"),Er(t,n.truth,"truth","truth"),Er(t,n.value,"value","value")),Bh(t,n)),V("span",{class:"interval-value"},V("strong",{},ge(n.value)),` ${n.unit==="1"?"":bn(n.unit)}`,n.interval?V("small",{},`${ge(e)} \u2026 ${ge(i)}`):null,n.note?V("small",{class:"note"},n.note):null))}function kd(n){let t=n.items.some(s=>Number.isFinite(s.truth)),e=n.items.some(s=>s.prior),i=[...e?[["prior","before the fit"]]:[],["posterior",e?"after it":"interval"],["start",n.start??"start"],["value","value"],...t?[["truth","truth"]]:[]];return V("figure",{class:"intervals"},V("figcaption",{class:"key"},i.map(([s,r])=>V("span",{},V("span",{class:`key-mark ${s}`}),r))),V("div",{role:"list"},n.items.map(V_)))}var kh=["before","after"];function H_(n,t,e,i){return V("span",{class:`axis-line of-${kh[i]} ${t.muted?"muted":""}`},t.interval?Xa(n,t.interval,"posterior",e):null,Er(n,e.truth,"truth","truth"),Er(n,t.value,"value","value"))}function G_(n,t,e,i){let[s,r]=n.interval??[];return V("span",{class:`pair-side ${n.muted?"muted":""}`},V("span",{class:`pair-name is-${kh[i]}`},e),V("span",{},V("strong",{},ge(n.value)),` ${t.unit==="1"?"":bn(t.unit)}`,n.interval?V("small",{},`${ge(s)} \u2026 ${ge(r)}`):null,n.note?V("small",{class:"note"},n.note):null))}function W_(n,t){let e=Fh(n,[...n.sides.flatMap(i=>[i.value,...(i.interval??[]).map(s=>Oh(n,s))]),n.truth]);return V("div",{class:`interval-row ${n.marked?"marked":""}`,role:"listitem"},V("span",{class:"interval-name"},V("code",{},n.name),n.doc?V("small",{},n.doc):null,n.difference?V("small",{class:"pair-difference"},n.difference):null),V("span",{class:"interval-axis"},n.sides.map((i,s)=>H_(e,i,n,s)),Bh(e,n)),V("span",{class:"interval-value"},n.sides.map((i,s)=>G_(i,n,t[s],s))))}function zd(n){let t=n.items.some(i=>Number.isFinite(i.truth)),e=n.names.map((i,s)=>V("span",{class:`of-${kh[s]}`},V("span",{class:"key-mark posterior"}),i));return t&&e.push(V("span",{},V("span",{class:"key-mark truth"}),"truth")),V("figure",{class:"intervals pairs"},V("figcaption",{class:"key"},e),V("div",{role:"list"},n.items.map(i=>W_(i,n.names))))}var X_="uplot",q_="u-hz",Y_="u-vt",Z_="u-title",$_="u-wrap",J_="u-under",K_="u-over",j_="u-axis",Hs="u-off",Q_="u-select",tv="u-cursor-x",ev="u-cursor-y",nv="u-cursor-pt",iv="u-legend",sv="u-live",rv="u-inline",ov="u-series",av="u-marker",Vd="u-label",lv="u-value",No="width",Fo="height";var Hd="bottom",Ar="left",zh="right",iu="#000",Gd=iu+"0",Vh="mousemove",Wd="mousedown",Hh="mouseup",Xd="mouseenter",qd="mouseleave",Yd="dblclick",cv="resize",hv="scroll",Zd="change",Ja="dppxchange",su="--",Ur=typeof window<"u",Yh=Ur?document:null,Rr=Ur?window:null,uv=Ur?navigator:null,Me,qa;function Zh(){let n=devicePixelRatio;Me!=n&&(Me=n,qa&&Jh(Zd,qa,Zh),qa=matchMedia(`(min-resolution: ${Me-.001}dppx) and (max-resolution: ${Me+.001}dppx)`),Gs(Zd,qa,Zh),Rr.dispatchEvent(new CustomEvent(Ja)))}function Zn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function $h(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function He(n,t,e){n.style[t]=e+"px"}function mi(n,t,e,i){let s=Yh.createElement(n);return t!=null&&Zn(s,t),e?.insertBefore(s,i),s}function si(n,t){return mi("div",n,t)}var $d=new WeakMap;function Ni(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=$d.get(n);r!=o&&(n.style.transform=r,$d.set(n,r),t<0||e<0||t>i||e>s?Zn(n,Hs):$h(n,Hs))}var Jd=new WeakMap;function Kd(n,t,e){let i=t+e,s=Jd.get(n);i!=s&&(Jd.set(n,i),n.style.background=t,n.style.borderColor=e)}var jd=new WeakMap;function Qd(n,t,e,i){let s=t+""+e,r=jd.get(n);s!=r&&(jd.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var ru={passive:!0},fv={...ru,capture:!0};function Gs(n,t,e,i){t.addEventListener(n,e,i?fv:ru)}function Jh(n,t,e,i){t.removeEventListener(n,e,ru)}Ur&&Zh();function gi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:$n((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Ap(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Cp=n=>n!=null,Rp=n=>n!=null&&n>0,Qa=Ap(Cp),dv=Ap(Rp);function pv(n,t,e,i=0,s=!1){let r=s?dv:Qa,o=s?Rp:Cp;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Le,l??-Le]}function tl(n,t,e,i){let s=np(n),r=np(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Yi:Pp,a=s==1?$n:ri,l=r==1?ri:$n,c=a(o(sn(n))),u=l(o(sn(t))),h=Pr(e,c),f=Pr(e,u);return e==10&&(c<0&&(h=Ue(h,-c)),u<0&&(f=Ue(f,-u))),i||e==2?(n=h*s,t=f*r):(n=Up(n,h),t=el(t,f)),[n,t]}function ou(n,t,e,i){let s=tl(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var au=.1,tp={mode:3,pad:au},Bo={pad:0,soft:null,mode:0},mv={min:Bo,max:Bo};function Ka(n,t,e,i){return nl(e)?ep(n,t,e):(Bo.pad=e,Bo.soft=i?0:null,Bo.mode=i?3:0,ep(n,t,mv))}function _e(n,t){return n??t}function gv(n,t,e){for(t=_e(t,0),e=_e(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function ep(n,t,e){let i=e.min,s=e.max,r=_e(i.pad,0),o=_e(s.pad,0),a=_e(i.hard,-Le),l=_e(s.hard,Le),c=_e(i.soft,Le),u=_e(s.soft,-Le),h=_e(i.mode,0),f=_e(s.mode,0),p=t-n,_=Yi(p),v=Un(sn(n),sn(t)),m=Yi(v),d=sn(m-_);(p<1e-24||d>10)&&(p=0,(n==0||t==0)&&(p=1e-24,h==2&&c!=Le&&(r=0),f==2&&u!=-Le&&(o=0)));let T=p||v||1e3,E=Yi(T),M=Pr(10,$n(E)),D=T*(p==0?n==0?.1:1:r),R=Ue(Up(n-D,M/10),24),N=n>=c&&(h==1||h==3&&R<=c||h==2&&R>=c)?c:Le,B=Un(a,R<N&&n>=N?N:_i(N,R)),w=T*(p==0?t==0?.1:1:o),b=Ue(el(t+w,M/10),24),C=t<=u&&(f==1||f==3&&b>=u||f==2&&b<=u)?u:-Le,G=_i(l,b>C&&t<=C?C:Un(C,b));return B==G&&B==0&&(G=100),[B,G]}var _v=new Intl.NumberFormat(Ur?uv.language:"en-US"),lu=n=>_v.format(n),Jn=Math,$a=Jn.PI,sn=Jn.abs,$n=Jn.floor,nn=Jn.round,ri=Jn.ceil,_i=Jn.min,Un=Jn.max,Pr=Jn.pow,np=Jn.sign,Yi=Jn.log10,Pp=Jn.log2,vv=(n,t=1)=>Jn.sinh(n)*t,Gh=(n,t=1)=>Jn.asinh(n/t),Le=1/0;function ip(n){return(Yi((n^n>>31)-(n>>31))|0)+1}function Kh(n,t,e){return _i(Un(n,t),e)}function Ip(n){return typeof n=="function"}function he(n){return Ip(n)?n:()=>n}var xv=()=>{},Dp=n=>n,Lp=(n,t)=>t,yv=n=>null,sp=n=>!0,rp=(n,t)=>n==t,Mv=/\.\d*?(?=9{6,}|0{6,})/gm,Ws=n=>{if(Fp(n)||_s.has(n))return n;let t=`${n}`,e=t.match(Mv);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Ws(s)}e${r}`}return Ue(n,i)};function zs(n,t){return Ws(Ue(Ws(n/t))*t)}function el(n,t){return Ws(ri(Ws(n/t))*t)}function Up(n,t){return Ws($n(Ws(n/t))*t)}function Ue(n,t=0){if(Fp(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return nn(i)/e}var _s=new Map;function Np(n){return((""+n).split(".")[1]||"").length}function zo(n,t,e,i){let s=[],r=i.map(Np);for(let o=t;o<e;o++){let a=sn(o),l=Ue(Pr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Ue(u,h);s.push(f),_s.set(f,h)}}return s}var ko={},cu=[],Ir=[null,null],gs=Array.isArray,Fp=Number.isInteger,Sv=n=>n===void 0;function op(n){return typeof n=="string"}function nl(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function bv(n){return n!=null&&typeof n=="object"}var wv=Object.getPrototypeOf(Uint8Array),Op="__proto__";function Dr(n,t=nl){let e;if(gs(n)){let i=n.find(s=>s!=null);if(gs(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Dr(n[s],t)}else e=n.slice()}else if(n instanceof wv)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Op&&(e[i]=Dr(n[i],t))}else e=n;return e}function je(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Op&&(nl(n[s])?je(n[s],Dr(i[s])):n[s]=Dr(i[s]))}return n}var Tv=0,Ev=1,Av=2;function Cv(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function Rv(n,t){if(Dv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Lv(o[0])||(o=Iv(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:Ev,p=[];for(let _=0;_<u.length;_++){let v=u[_],m=r.get(l[_]);v===null?f!=Tv&&(h[m]=v,f==Av&&p.push(m)):h[m]=v}Cv(h,p,s),i.push(h)}}return i}var Pv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Iv(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Dv(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Lv(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Un(1,$n((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Bp=["January","February","March","April","May","June","July","August","September","October","November","December"],kp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zp(n){return n.slice(0,3)}var Uv=kp.map(zp),Nv=Bp.map(zp),Fv={MMMM:Bp,MMM:Nv,WWWW:kp,WWW:Uv};function Uo(n){return(n<10?"0":"")+n}function Ov(n){return(n<10?"00":n<100?"0":"")+n}var Bv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Uo(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Uo(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Uo(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Uo(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Uo(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Ov(n.getMilliseconds())};function hu(n,t){t=t||Fv;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Bv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var kv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function zv(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==kv?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var Vp=n=>n%1==0,ja=[1,2,2.5,5],Vv=zo(10,-32,0,ja),Hp=zo(10,0,32,ja),Hv=Hp.filter(Vp),Vs=Vv.concat(Hp),uu=`
`,Gp="{YYYY}",ap=uu+Gp,Wp="{M}/{D}",Oo=uu+Wp,Ya=Oo+"/{YY}",Xp="{aa}",Gv="{h}:{mm}",Cr=Gv+Xp,lp=uu+Cr,cp=":{ss}",Se=null;function qp(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?zo(10,0,3,ja).filter(Vp):zo(10,-3,0,ja)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Gp,Se,Se,Se,Se,Se,Se,1],[s*28,"{MMM}",ap,Se,Se,Se,Se,Se,1],[s,Wp,ap,Se,Se,Se,Se,Se,1],[i,"{h}"+Xp,Ya,Se,Oo,Se,Se,Se,1],[e,Cr,Ya,Se,Oo,Se,Se,Se,1],[t,cp,Ya+" "+Cr,Se,Oo+" "+Cr,Se,lp,Se,1],[n,cp+".{fff}",Ya+" "+Cr,Se,Oo+" "+Cr,Se,lp,Se,1]];function u(h){return(f,p,_,v,m,d)=>{let T=[],E=m>=o,M=m>=r&&m<o,D=h(_),R=Ue(D*n,3),N=Wh(D.getFullYear(),E?0:D.getMonth(),M||E?1:D.getDate()),B=Ue(N*n,3);if(M||E){let w=M?m/r:0,b=E?m/o:0,C=R==B?R:Ue(Wh(N.getFullYear()+b,N.getMonth()+w,1)*n,3),G=new Date(nn(C/n)),H=G.getFullYear(),q=G.getMonth();for(let X=0;C<=v;X++){let Z=Wh(H+b*X,q+w*X,1),J=Z-h(Ue(Z*n,3));C=Ue((+Z+J)*n,3),C<=v&&T.push(C)}}else{let w=m>=s?s:m,b=$n(_)-$n(R),C=B+b+el(R-B,w);T.push(C);let G=h(C),H=G.getHours()+G.getMinutes()/e+G.getSeconds()/i,q=m/i,X=f.axes[p]._space,Z=d/X;for(;C=Ue(C+m,n==1?0:3),!(C>v);)if(q>1){let J=$n(Ue(H+q,6))%24,at=h(C).getHours()-J;at>1&&(at=-1),C-=at*i,H=(H+q)%24;let vt=T[T.length-1];Ue((C-vt)/m,3)*Z>=.7&&T.push(C)}else T.push(C)}return T}}return[l,c,u]}var[Wv,Xv,qv]=qp(1),[Yv,Zv,$v]=qp(.001);zo(2,-53,53,[1]);function hp(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function up(n,t){return(e,i,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,c,u,h,f,p;return i.map(_=>{let v=n(_),m=v.getFullYear(),d=v.getMonth(),T=v.getDate(),E=v.getHours(),M=v.getMinutes(),D=v.getSeconds(),R=m!=l&&a[2]||d!=c&&a[3]||T!=u&&a[4]||E!=h&&a[5]||M!=f&&a[6]||D!=p&&a[7]||a[1];return l=m,c=d,u=T,h=E,f=M,p=D,R(v)})}}function Jv(n,t){let e=hu(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Wh(n,t,e){return new Date(n,t,e)}function fp(n,t){return t(n)}var Kv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function dp(n,t){return(e,i,s,r)=>r==null?su:t(n(i))}function jv(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function Qv(n,t){return n.series[t].fill(n,t)}var tx={show:!0,live:!0,isolate:!1,mount:xv,markers:{show:!0,width:2,stroke:jv,fill:Qv,dash:"solid"},idx:null,idxs:null,values:[]};function ex(n,t){let e=n.cursor.points,i=si(),s=e.size(n,t);He(i,No,s),He(i,Fo,s);let r=s/-2;He(i,"marginLeft",r),He(i,"marginTop",r);let o=e.width(n,t,s);return o&&He(i,"borderWidth",o),i}function nx(n,t){let e=n.series[t].points;return e._fill||e._stroke}function ix(n,t){let e=n.series[t].points;return e._stroke||e._fill}function sx(n,t){return n.series[t].points.size}var Xh=[0,0];function rx(n,t,e){return Xh[0]=t,Xh[1]=e,Xh}function Za(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function qh(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var ox={show:!0,x:!0,y:!0,lock:!1,move:rx,points:{one:!1,show:ex,size:sx,width:0,stroke:ix,fill:nx},bind:{mousedown:Za,mouseup:Za,click:Za,dblclick:Za,mousemove:qh,mouseleave:qh,mouseenter:qh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Yp={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},fu=je({},Yp,{filter:Lp}),Zp=je({},fu,{size:10}),$p=je({},Yp,{show:!1}),du='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Jp="bold "+du,Kp=1.5,pp={show:!0,scale:"x",stroke:iu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jp,side:2,grid:fu,ticks:Zp,border:$p,font:du,lineGap:Kp,rotate:0},ax="Value",lx="Time",mp={show:!0,scale:"x",auto:!1,sorted:1,min:Le,max:-Le,idxs:[]};function cx(n,t,e,i,s){return t.map(r=>r==null?"":lu(r))}function hx(n,t,e,i,s,r,o){let a=[],l=_s.get(s)||0;e=o?e:Ue(el(e,s),l);for(let c=e;c<=i;c=Ue(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function jh(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Yi:Pp,u=$n(c(e));s=Pr(l,u),l==10&&(s=Vs[gi(s,Vs)]);let h=e,f=s*l;l==10&&(f=Vs[gi(f,Vs)]);do a.push(h),h=h+s,l==10&&!_s.has(h)&&(h=Ue(h,_s.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Vs[gi(f,Vs)]));while(h<=i);return a}function ux(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?jh(n,t,Un(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?jh(n,t,Un(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}var jp=/./,fx=/[12357]/,dx=/[125]/,gp=/1/,Qh=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function px(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?jp:l(7,o)-u>=c?fx:l(5,o)-u>=c?dx:gp;if(h==gp){let f=sn(l(1,o)-u);if(f<c)return Qh(t.slice().reverse(),a.distr,h,ri(c/f)).reverse()}return Qh(t,a.distr,h,1)}function mx(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=sn(l(1,o)-l(2,o));return c<a?Qh(t.slice().reverse(),3,jp,ri(a/c)).reverse():t}function gx(n,t,e,i){return i==null?su:t==null?"":lu(t)}var _p={show:!0,scale:"y",stroke:iu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Jp,side:3,grid:fu,ticks:Zp,border:$p,font:du,lineGap:Kp,rotate:0};function _x(n,t){let e=3+(n||1)*2;return Ue(e*t,3)}function vx(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=sn(o-r),l=n.series[t],c=a/(l.points.space*Me);return i[1]-i[0]<=c}var vp={scale:null,auto:!0,sorted:0,min:Le,max:-Le},Qp=(n,t,e,i,s)=>s,xp={show:!0,auto:!0,sorted:0,gaps:Qp,alpha:1,facets:[je({},vp,{scale:"x"}),je({},vp,{scale:"y"})]},yp={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qp,alpha:1,points:{show:vx,filter:null},values:null,min:Le,max:-Le,idxs:[],path:null,clip:null};function xx(n,t,e,i,s){return e/10}var tm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},yx=je({},tm,{time:!1,ori:1}),Mp={};function em(n,t){let e=Mp[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Mp[n]=e)),e}var Lr=1,tu=2;function Xs(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,_=a.width,v=a.height,m=n.valToPosH,d=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,d,f,p,_,v,sl,Nr,ol,im,rm):e(s,l,c,u,h,d,m,p,f,v,_,rl,Fr,gu,sm,om)}function pu(n,t){let e=0,i=0,s=_e(n.bands,cu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function Mx(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Zi(n,t,e,i,s,r){return Xs(n,t,(o,a,l,c,u,h,f,p,_,v,m)=>{let d=o.pxRound,T=c.dir*(c.ori==0?1:-1),E=c.ori==0?Nr:Fr,M,D;T==1?(M=e,D=i):(M=i,D=e);let R=d(h(a[M],c,v,p)),N=d(f(l[M],u,m,_)),B=d(h(a[D],c,v,p)),w=d(f(r==1?u.max:u.min,u,m,_)),b=new Path2D(s);return E(b,B,w),E(b,R,w),E(b,R,N),b})}function il(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?ol:gu,l=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Sx(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function mu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let p=r(n[h]),_=f==h?p:r(n[f]),v=h-s;p=o<=0&&v>=0&&v<l?r(n[v]):p;let d=f+s;_=o>=0&&d>=0&&d<l?r(n[d]):_,_>=p&&a.push([p,_])}return a}function Sp(n){return n==0?Dp:n==1?nn:t=>zs(t,n)}function nm(n){let t=n==0?sl:rl,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=_i(c,a/2,l/2),u=_i(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var sl=(n,t,e)=>{n.moveTo(t,e)},rl=(n,t,e)=>{n.moveTo(e,t)},Nr=(n,t,e)=>{n.lineTo(t,e)},Fr=(n,t,e)=>{n.lineTo(e,t)},ol=nm(0),gu=nm(1),im=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},sm=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},rm=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},om=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function am(n){return(t,e,i,s,r)=>Xs(t,e,(o,a,l,c,u,h,f,p,_,v,m)=>{let{pxRound:d,points:T}=o,E,M;c.ori==0?(E=sl,M=im):(E=rl,M=sm);let D=Ue(T.width*Me,3),R=(T.size-T.width)/2*Me,N=Ue(R*2,3),B=new Path2D,w=new Path2D,{left:b,top:C,width:G,height:H}=t.bbox;ol(w,b-N,C-N,G+N*2,H+N*2);let q=X=>{if(l[X]!=null){let Z=d(h(a[X],c,v,p)),J=d(f(l[X],u,m,_));E(B,Z+R,J),M(B,Z,J,R,0,$a*2)}};if(r)r.forEach(q);else for(let X=i;X<=s;X++)q(X);return{stroke:D>0?B:null,fill:B,clip:w,flags:Lr|tu}})}function lm(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var bx=lm(Nr),wx=lm(Fr);function cm(n){let t=_e(n?.alignGaps,0);return(e,i,s,r)=>Xs(e,i,(o,a,l,c,u,h,f,p,_,v,m)=>{[s,r]=Qa(l,s,r);let d=o.pxRound,T=H=>d(h(H,c,v,p)),E=H=>d(f(H,u,m,_)),M,D;c.ori==0?(M=Nr,D=bx):(M=Fr,D=wx);let R=c.dir*(c.ori==0?1:-1),N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lr},B=N.stroke,w=!1;if(r-s>=v*4){let H=mt=>e.posToVal(mt,c.key,!0),q=null,X=null,Z,J,Q,ot=T(a[R==1?s:r]),at=T(a[s]),vt=T(a[r]),yt=H(R==1?at+1:vt-1);for(let mt=R==1?s:r;mt>=s&&mt<=r;mt+=R){let Qt=a[mt],tt=(R==1?Qt<yt:Qt>yt)?ot:T(Qt),et=l[mt];tt==ot?et!=null?(J=et,q==null?(M(B,tt,E(J)),Z=q=X=J):J<q?q=J:J>X&&(X=J)):et===null&&(w=!0):(q!=null&&D(B,ot,E(q),E(X),E(Z),E(J)),et!=null?(J=et,M(B,tt,E(J)),q=X=Z=J):(q=X=null,et===null&&(w=!0)),ot=tt,yt=H(ot+R))}q!=null&&q!=X&&Q!=ot&&D(B,ot,E(q),E(X),E(Z),E(J))}else for(let H=R==1?s:r;H>=s&&H<=r;H+=R){let q=l[H];q===null?w=!0:q!=null&&M(B,T(a[H]),E(q))}let[C,G]=pu(e,i);if(o.fill!=null||C!=0){let H=N.fill=new Path2D(B),q=o.fillTo(e,i,o.min,o.max,C),X=E(q),Z=T(a[s]),J=T(a[r]);R==-1&&([J,Z]=[Z,J]),M(H,J,X),M(H,Z,X)}if(!o.spanGaps){let H=[];w&&H.push(...mu(a,l,s,r,R,T,t)),N.gaps=H=o.gaps(e,i,s,r,H),N.clip=il(H,c.ori,p,_,v,m)}return G!=0&&(N.band=G==2?[Zi(e,i,s,r,B,-1),Zi(e,i,s,r,B,1)]:Zi(e,i,s,r,B,G)),N})}function Tx(n){let t=_e(n.align,1),e=_e(n.ascDesc,!1),i=_e(n.alignGaps,0),s=_e(n.extend,!1);return(r,o,a,l)=>Xs(r,o,(c,u,h,f,p,_,v,m,d,T,E)=>{[a,l]=Qa(h,a,l);let M=c.pxRound,{left:D,width:R}=r.bbox,N=at=>M(_(at,f,T,m)),B=at=>M(v(at,p,E,d)),w=f.ori==0?Nr:Fr,b={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lr},C=b.stroke,G=f.dir*(f.ori==0?1:-1),H=B(h[G==1?a:l]),q=N(u[G==1?a:l]),X=q,Z=q;s&&t==-1&&(Z=D,w(C,Z,H)),w(C,q,H);for(let at=G==1?a:l;at>=a&&at<=l;at+=G){let vt=h[at];if(vt==null)continue;let yt=N(u[at]),mt=B(vt);t==1?w(C,yt,H):w(C,X,mt),w(C,yt,mt),H=mt,X=yt}let J=X;s&&t==1&&(J=D+R,w(C,J,H));let[Q,ot]=pu(r,o);if(c.fill!=null||Q!=0){let at=b.fill=new Path2D(C),vt=c.fillTo(r,o,c.min,c.max,Q),yt=B(vt);w(at,J,yt),w(at,Z,yt)}if(!c.spanGaps){let at=[];at.push(...mu(u,h,a,l,G,N,i));let vt=c.width*Me/2,yt=e||t==1?vt:-vt,mt=e||t==-1?-vt:vt;at.forEach(Qt=>{Qt[0]+=yt,Qt[1]+=mt}),b.gaps=at=c.gaps(r,o,a,l,at),b.clip=il(at,f.ori,m,d,T,E)}return ot!=0&&(b.band=ot==2?[Zi(r,o,a,l,C,-1),Zi(r,o,a,l,C,1)]:Zi(r,o,a,l,C,ot)),b})}function bp(n,t,e,i,s,r,o=Le){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=sn(n[l]-n[a]);u<c&&(c=u,o=sn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function Ex(n){n=n||ko;let t=_e(n.size,[.6,Le,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=he(s),o=1-t[0],a=_e(t[1],Le),l=_e(t[2],1),c=_e(n.disp,ko),u=_e(n.each,p=>{}),{fill:h,stroke:f}=c;return(p,_,v,m)=>Xs(p,_,(d,T,E,M,D,R,N,B,w,b,C)=>{let G=d.pxRound,H=e,q=i*Me,X=a*Me,Z=l*Me,J,Q;M.ori==0?[J,Q]=r(p,_):[Q,J]=r(p,_);let ot=M.dir*(M.ori==0?1:-1),at=M.ori==0?ol:gu,vt=M.ori==0?u:(U,K,it,nt,Nt,ut,It)=>{u(U,K,it,Nt,nt,It,ut)},yt=_e(p.bands,cu).find(U=>U.series[0]==_),mt=yt!=null?yt.dir:0,Qt=d.fillTo(p,_,d.min,d.max,mt),Yt=G(N(Qt,D,C,w)),tt,et,St,Ft=b,xt=G(d.width*Me),Kt=!1,be=null,L=null,ue=null,$t=null;h!=null&&(xt==0||f!=null)&&(Kt=!0,be=h.values(p,_,v,m),L=new Map,new Set(be).forEach(U=>{U!=null&&L.set(U,new Path2D)}),xt>0&&(ue=f.values(p,_,v,m),$t=new Map,new Set(ue).forEach(U=>{U!=null&&$t.set(U,new Path2D)})));let{x0:Gt,size:Ut}=c;if(Gt!=null&&Ut!=null){H=1,T=Gt.values(p,_,v,m),Gt.unit==2&&(T=T.map(it=>p.posToVal(B+it*b,M.key,!0)));let U=Ut.values(p,_,v,m);Ut.unit==2?et=U[0]*b:et=R(U[0],M,b,B)-R(0,M,b,B),Ft=bp(T,E,R,M,b,B,Ft),St=Ft-et+q}else Ft=bp(T,E,R,M,b,B,Ft),St=Ft*o+q,et=Ft-St;St<1&&(St=0),xt>=et/2&&(xt=0),St<5&&(G=Dp);let we=St>0,Rt=Ft-St-(we?xt:0);et=G(Kh(Rt,Z,X)),tt=(H==0?et/2:H==ot?0:et)-H*ot*((H==0?q/2:0)+(we?xt/2:0));let Ht={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Be=Kt?null:new Path2D,ve=null;if(yt!=null)ve=p.data[yt.series[1]];else{let{y0:U,y1:K}=c;U!=null&&K!=null&&(E=K.values(p,_,v,m),ve=U.values(p,_,v,m))}let P=J*et,x=Q*et;for(let U=ot==1?v:m;U>=v&&U<=m;U+=ot){let K=E[U];if(K==null)continue;if(ve!=null){let _t=ve[U]??0;if(K-_t==0)continue;Yt=N(_t,D,C,w)}let it=M.distr!=2||c!=null?T[U]:U,nt=R(it,M,b,B),Nt=N(_e(K,Qt),D,C,w),ut=G(nt-tt),It=G(Un(Nt,Yt)),At=G(_i(Nt,Yt)),lt=It-At;if(K!=null){let _t=K<0?x:P,kt=K<0?P:x;Kt?(xt>0&&ue[U]!=null&&at($t.get(ue[U]),ut,At+$n(xt/2),et,Un(0,lt-xt),_t,kt),be[U]!=null&&at(L.get(be[U]),ut,At+$n(xt/2),et,Un(0,lt-xt),_t,kt)):at(Be,ut,At+$n(xt/2),et,Un(0,lt-xt),_t,kt),vt(p,_,U,ut-xt/2,At,et+xt,lt)}}return xt>0?Ht.stroke=Kt?$t:Be:Kt||(Ht._fill=d.width==0?d._fill:d._stroke??d._fill,Ht.width=0),Ht.fill=Kt?L:Be,Ht})}function Ax(n,t){let e=_e(t?.alignGaps,0);return(i,s,r,o)=>Xs(i,s,(a,l,c,u,h,f,p,_,v,m,d)=>{[r,o]=Qa(c,r,o);let T=a.pxRound,E=J=>T(f(J,u,m,_)),M=J=>T(p(J,h,d,v)),D,R,N;u.ori==0?(D=sl,N=Nr,R=rm):(D=rl,N=Fr,R=om);let B=u.dir*(u.ori==0?1:-1),w=E(l[B==1?r:o]),b=w,C=[],G=[];for(let J=B==1?r:o;J>=r&&J<=o;J+=B)if(c[J]!=null){let ot=l[J],at=E(ot);C.push(b=at),G.push(M(c[J]))}let H={stroke:n(C,G,D,N,R,T),fill:null,clip:null,band:null,gaps:null,flags:Lr},q=H.stroke,[X,Z]=pu(i,s);if(a.fill!=null||X!=0){let J=H.fill=new Path2D(q),Q=a.fillTo(i,s,a.min,a.max,X),ot=M(Q);N(J,b,ot),N(J,w,ot)}if(!a.spanGaps){let J=[];J.push(...mu(l,c,r,o,B,E,e)),H.gaps=J=a.gaps(i,s,r,o,J),H.clip=il(J,u.ori,_,v,m,d)}return Z!=0&&(H.band=Z==2?[Zi(i,s,r,o,q,-1),Zi(i,s,r,o,q,1)]:Zi(i,s,r,o,q,Z)),H})}function Cx(n){return Ax(Rx,n)}function Rx(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,n[f+1],t[f+1])}return a}var eu=new Set;function wp(){for(let n of eu)n.syncRect(!0)}Ur&&(Gs(cv,Rr,wp),Gs(hv,Rr,wp,!0),Gs(Ja,Rr,()=>{pn.pxRatio=Me}));var Px=cm(),Ix=am();function Tp(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>nu(r,o,t,e))}function Dx(n,t){return n.map((e,i)=>i==0?{}:je({},t,e))}function nu(n,t,e,i){return je({},t==0?e:i,n)}function hm(n,t,e){return t==null?Ir:[t,e]}var Lx=hm;function Ux(n,t,e){return t==null?Ir:Ka(t,e,au,!0)}function um(n,t,e,i){return t==null?Ir:tl(t,e,n.scales[i].log,!1)}var Nx=um;function fm(n,t,e,i){return t==null?Ir:ou(t,e,n.scales[i].log,!1)}var Fx=fm;function Ox(n,t,e,i,s){let r=Un(ip(n),ip(t)),o=t-n,a=gi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?_s.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ep(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=nn((e=+s)*Me))+"px"),[n,t,e]}function Bx(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ue(t[2]*Me,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function pn(n,t,e){let i={mode:_e(n.mode,1)},s=i.mode;function r(g,y,A,I){let O=y.valToPct(g);return I+A*(y.dir==-1?1-O:O)}function o(g,y,A,I){let O=y.valToPct(g);return I+A*(y.dir==-1?O:1-O)}function a(g,y,A,I){return y.ori==0?r(g,y,A,I):o(g,y,A,I)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=si(X_);if(n.id!=null&&(c.id=n.id),Zn(c,n.class),n.title){let g=si(Z_,c);g.textContent=n.title}let u=mi("canvas"),h=i.ctx=u.getContext("2d"),f=si($_,c);Gs("click",f,g=>{g.target===_&&(ke!=gr||Xe!=_r)&&vn.click(i,g)},!0);let p=i.under=si(J_,f);f.appendChild(u);let _=i.over=si(K_,f);n=Dr(n);let v=+_e(n.pxAlign,1),m=Sp(v);(n.plugins||[]).forEach(g=>{g.opts&&(n=g.opts(i,n)||n)});let d=n.ms||.001,T=i.series=s==1?Tp(n.series||[],mp,yp,!1):Dx(n.series||[null],xp),E=i.axes=Tp(n.axes||[],pp,_p,!0),M=i.scales={},D=i.bands=n.bands||[];D.forEach(g=>{g.fill=he(g.fill||null),g.dir=_e(g.dir,-1)});let R=s==2?T[1].facets[0].scale:T[0].scale,N={axes:X0,series:Fs},B=(n.drawOrder||["axes","series"]).map(g=>N[g]);function w(g){let y=g.distr==3?A=>Yi(A>0?A:g.clamp(i,A,g.min,g.max,g.key)):g.distr==4?A=>Gh(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let I=y(A),{_min:O,_max:Y}=g,st=Y-O;return(I-O)/st}}function b(g){let y=M[g];if(y==null){let A=(n.scales||ko)[g]||ko;if(A.from!=null){b(A.from);let I=je({},M[A.from],A,{key:g});I.valToPct=w(I),M[g]=I}else{y=M[g]=je({},g==R?tm:yx,A),y.key=g;let I=y.time,O=y.range,Y=gs(O);if((g!=R||s==2&&!I)&&(Y&&(O[0]==null||O[1]==null)&&(O={min:O[0]==null?tp:{mode:1,hard:O[0],soft:O[0]},max:O[1]==null?tp:{mode:1,hard:O[1],soft:O[1]}},Y=!1),!Y&&nl(O))){let st=O;O=(ct,gt,Et)=>gt==null?Ir:Ka(gt,Et,st)}y.range=he(O||(I?Lx:g==R?y.distr==3?Nx:y.distr==4?Fx:hm:y.distr==3?um:y.distr==4?fm:Ux)),y.auto=he(Y?!1:y.auto),y.clamp=he(y.clamp||xx),y._min=y._max=null,y.valToPct=w(y)}}}b("x"),b("y"),s==1&&T.forEach(g=>{b(g.scale)}),E.forEach(g=>{b(g.scale)});for(let g in n.scales)b(g);let C=M[R],G=C.distr,H,q;C.ori==0?(Zn(c,q_),H=r,q=o):(Zn(c,Y_),H=o,q=r);let X={};for(let g in M){let y=M[g];(y.min!=null||y.max!=null)&&(X[g]={min:y.min,max:y.max},y.min=y.max=null)}let Z=n.tzDate||(g=>new Date(nn(g/d))),J=n.fmtDate||hu,Q=d==1?qv(Z):$v(Z),ot=up(Z,hp(d==1?Xv:Zv,J)),at=dp(Z,fp(Kv,J)),vt=[],yt=i.legend=je({},tx,n.legend),mt=i.cursor=je({},ox,{drag:{y:s==2}},n.cursor),Qt=yt.show,Yt=mt.show,tt=yt.markers;yt.idxs=vt,tt.width=he(tt.width),tt.dash=he(tt.dash),tt.stroke=he(tt.stroke),tt.fill=he(tt.fill);let et,St,Ft,xt=[],Kt=[],be,L=!1,ue={};if(yt.live){let g=T[1]?T[1].values:null;L=g!=null,be=L?g(i,1,0):{_:0};for(let y in be)ue[y]=su}if(Qt)if(et=mi("table",iv,c),Ft=mi("tbody",null,et),yt.mount(i,et),L){St=mi("thead",null,et,Ft);let g=mi("tr",null,St);mi("th",null,g);for(var $t in be)mi("th",Vd,g).textContent=$t}else Zn(et,rv),yt.live&&Zn(et,sv);let Gt={show:!0},Ut={show:!1};function we(g,y){if(y==0&&(L||!yt.live||s==2))return Ir;let A=[],I=mi("tr",ov,Ft,Ft.childNodes[y]);Zn(I,g.class),g.show||Zn(I,Hs);let O=mi("th",null,I);if(tt.show){let ct=si(av,O);if(y>0){let gt=tt.width(i,y);gt&&(ct.style.border=gt+"px "+tt.dash(i,y)+" "+tt.stroke(i,y)),ct.style.background=tt.fill(i,y)}}let Y=si(Vd,O);g.label instanceof HTMLElement?Y.appendChild(g.label):Y.textContent=g.label,y>0&&(tt.show||(Y.style.color=g.width>0?tt.stroke(i,y):tt.fill(i,y)),Ht("click",O,ct=>{if(mt._lock)return;_n(ct);let gt=T.indexOf(g);if((ct.ctrlKey||ct.metaKey)!=yt.isolate){let Et=T.some((Ct,Lt)=>Lt>0&&Lt!=gt&&Ct.show);T.forEach((Ct,Lt)=>{Lt>0&&Ii(Lt,Et?Lt==gt?Gt:Ut:Gt,!0,Ke.setSeries)})}else Ii(gt,{show:!g.show},!0,Ke.setSeries)},!1),On&&Ht(Xd,O,ct=>{mt._lock||(_n(ct),Ii(T.indexOf(g),xr,!0,Ke.setSeries))},!1));for(var st in be){let ct=mi("td",lv,I);ct.textContent="--",A.push(ct)}return[I,A]}let Rt=new Map;function Ht(g,y,A,I=!0){let O=Rt.get(y)||{},Y=mt.bind[g](i,y,A,I);Y&&(Gs(g,y,O[g]=Y),Rt.set(y,O))}function Be(g,y,A){let I=Rt.get(y)||{};for(let O in I)(g==null||O==g)&&(Jh(O,y,I[O]),delete I[O]);g==null&&Rt.delete(y)}let ve=0,P=0,x=0,U=0,K=0,it=0,nt=K,Nt=it,ut=x,It=U,At=0,lt=0,_t=0,kt=0;i.bbox={};let Bt=!1,Mt=!1,jt=!1,F=!1,ft=!1,pt=!1;function Pt(g,y,A){(A||g!=i.width||y!=i.height)&&ht(g,y),fr(!1),jt=!0,Mt=!0,dr()}function ht(g,y){i.width=ve=x=g,i.height=P=U=y,K=it=0,Re(),de();let A=i.bbox;At=A.left=zs(K*Me,.5),lt=A.top=zs(it*Me,.5),_t=A.width=zs(x*Me,.5),kt=A.height=zs(U*Me,.5)}let rt=3;function Ot(){let g=!1,y=0;for(;!g;){y++;let A=G0(y),I=W0(y);g=y==rt||A&&I,g||(ht(i.width,i.height),Mt=!0)}}function te({width:g,height:y}){Pt(g,y)}i.setSize=te;function Re(){let g=!1,y=!1,A=!1,I=!1;E.forEach((O,Y)=>{if(O.show&&O._show){let{side:st,_size:ct}=O,gt=st%2,Et=O.label!=null?O.labelSize:0,Ct=ct+Et;Ct>0&&(gt?(x-=Ct,st==3?(K+=Ct,I=!0):A=!0):(U-=Ct,st==0?(it+=Ct,g=!0):y=!0))}}),Wi[0]=g,Wi[1]=A,Wi[2]=y,Wi[3]=I,x-=Pi[1]+Pi[3],K+=Pi[3],U-=Pi[2]+Pi[0],it+=Pi[0]}function de(){let g=K+x,y=it+U,A=K,I=it;function O(Y,st){switch(Y){case 1:return g+=st,g-st;case 2:return y+=st,y-st;case 3:return A-=st,A+st;case 0:return I-=st,I+st}}E.forEach((Y,st)=>{if(Y.show&&Y._show){let ct=Y.side;Y._pos=O(ct,Y._size),Y.label!=null&&(Y._lpos=O(ct,Y.labelSize))}})}if(mt.dataIdx==null){let g=mt.hover,y=g.skip=new Set(g.skip??[]);y.add(void 0);let A=g.prox=he(g.prox),I=g.bias??=0;mt.dataIdx=(O,Y,st,ct)=>{if(Y==0)return st;let gt=st,Et=A(O,Y,st,ct)??Le,Ct=Et>=0&&Et<Le,Lt=C.ori==0?x:U,ee=mt.left,xe=t[0],me=t[Y];if(y.has(me[st])){gt=null;let le=null,Jt=null,Vt;if(I==0||I==-1)for(Vt=st;le==null&&Vt-- >0;)y.has(me[Vt])||(le=Vt);if(I==0||I==1)for(Vt=st;Jt==null&&Vt++<me.length;)y.has(me[Vt])||(Jt=Vt);if(le!=null||Jt!=null)if(Ct){let Ve=le==null?-1/0:H(xe[le],C,Lt,0),$e=Jt==null?1/0:H(xe[Jt],C,Lt,0),dn=ee-Ve,Pe=$e-ee;dn<=Pe?dn<=Et&&(gt=le):Pe<=Et&&(gt=Jt)}else gt=Jt==null?le:le==null?Jt:st-le<=Jt-st?le:Jt}else Ct&&sn(ee-H(xe[st],C,Lt,0))>Et&&(gt=null);return gt}}let _n=g=>{mt.event=g};mt.idxs=vt,mt._lock=!1;let De=mt.points;De.show=he(De.show),De.size=he(De.size),De.stroke=he(De.stroke),De.width=he(De.width),De.fill=he(De.fill);let Wn=i.focus=je({},n.focus||{alpha:.3},mt.focus),On=Wn.prox>=0,Ri=On&&De.one,Cn=[],Gi=[],hi=[];function Mo(g,y){let A=De.show(i,y);if(A instanceof HTMLElement)return Zn(A,nv),Zn(A,g.class),Ni(A,-10,-10,x,U),_.insertBefore(A,Cn[y]),A}function Us(g,y){if(s==1||y>0){let A=s==1&&M[g.scale].time,I=g.value;g.value=A?op(I)?dp(Z,fp(I,J)):I||at:I||gx,g.label=g.label||(A?lx:ax)}if(Ri||y>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Px||yv,g.fillTo=he(g.fillTo||Mx),g.pxAlign=+_e(g.pxAlign,v),g.pxRound=Sp(g.pxAlign),g.stroke=he(g.stroke||null),g.fill=he(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=_x(Un(1,g.width),1),I=g.points=je({},{size:A,width:Un(1,A*.2),stroke:g.stroke,space:A*2,paths:Ix,_stroke:null,_fill:null},g.points);I.show=he(I.show),I.filter=he(I.filter),I.fill=he(I.fill),I.stroke=he(I.stroke),I.paths=he(I.paths),I.pxAlign=g.pxAlign}if(Qt){let A=we(g,y);xt.splice(y,0,A[0]),Kt.splice(y,0,A[1]),yt.values.push(null)}if(Yt){vt.splice(y,0,null);let A=null;Ri?y==0&&(A=Mo(g,y)):y>0&&(A=Mo(g,y)),Cn.splice(y,0,A),Gi.splice(y,0,0),hi.splice(y,0,0)}fn("addSeries",y)}function Ra(g,y){y=y??T.length,g=s==1?nu(g,y,mp,yp):nu(g,y,{},xp),T.splice(y,0,g),Us(T[y],y)}i.addSeries=Ra;function Pa(g){if(T.splice(g,1),Qt){yt.values.splice(g,1),Kt.splice(g,1);let y=xt.splice(g,1)[0];Be(null,y.firstChild),y.remove()}Yt&&(vt.splice(g,1),Cn.splice(g,1)[0].remove(),Gi.splice(g,1),hi.splice(g,1)),fn("delSeries",g)}i.delSeries=Pa;let Wi=[!1,!1,!1,!1];function dh(g,y){if(g._show=g.show,g.show){let A=g.side%2,I=M[g.scale];I==null&&(g.scale=A?T[1].scale:R,I=M[g.scale]);let O=I.time;g.size=he(g.size),g.space=he(g.space),g.rotate=he(g.rotate),gs(g.incrs)&&g.incrs.forEach(st=>{!_s.has(st)&&_s.set(st,Np(st))}),g.incrs=he(g.incrs||(I.distr==2?Hv:O?d==1?Wv:Yv:Vs)),g.splits=he(g.splits||(O&&I.distr==1?Q:I.distr==3?jh:I.distr==4?ux:hx)),g.stroke=he(g.stroke),g.grid.stroke=he(g.grid.stroke),g.ticks.stroke=he(g.ticks.stroke),g.border.stroke=he(g.border.stroke);let Y=g.values;g.values=gs(Y)&&!gs(Y[0])?he(Y):O?gs(Y)?up(Z,hp(Y,J)):op(Y)?Jv(Z,Y):Y||ot:Y||cx,g.filter=he(g.filter||(I.distr>=3&&I.log==10?px:I.distr==3&&I.log==2?mx:Lp)),g.font=Ep(g.font),g.labelFont=Ep(g.labelFont),g._size=g.size(i,null,y,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(Wi[y]=!0,g._el=si(j_,f))}}function Ns(g,y,A,I){let[O,Y,st,ct]=A,gt=y%2,Et=0;return gt==0&&(ct||Y)&&(Et=y==0&&!O||y==2&&!st?nn(pp.size/3):0),gt==1&&(O||st)&&(Et=y==1&&!Y||y==3&&!ct?nn(_p.size/2):0),Et}let Ia=i.padding=(n.padding||[Ns,Ns,Ns,Ns]).map(g=>he(_e(g,Ns))),Pi=i._padding=Ia.map((g,y)=>g(i,y,Wi,0)),en,S=null,k=null,j=s==1?T[0].idxs:null,$=null,W=!1;function dt(g,y){if(t=g??[],i.data=i._data=t,s==2){en=0;for(let A=1;A<T.length;A++)en+=t[A][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),$=t[0],en=$.length;let A=t;if(G==2){A=t.slice();let I=A[0]=Array(en);for(let O=0;O<en;O++)I[O]=O}i._data=t=A}if(fr(!0),fn("setData"),G==2&&(jt=!0),y!==!1){let A=C;A.auto(i,W)?bt():us(R,A.min,A.max),F=F||mt.left>=0,pt=!0,dr()}}i.setData=dt;function bt(){W=!0;let g,y;s==1&&(en>0?(S=j[0]=0,k=j[1]=en-1,g=t[0][S],y=t[0][k],G==2?(g=S,y=k):g==y&&(G==3?[g,y]=tl(g,g,C.log,!1):G==4?[g,y]=ou(g,g,C.log,!1):C.time?y=g+nn(86400/d):[g,y]=Ka(g,y,au,!0))):(S=j[0]=g=null,k=j[1]=y=null)),us(R,g,y)}let Dt,Tt,Xt,Zt,zt,re,pe,Ne,Te,ne;function Wt(g,y,A,I,O,Y){g??=Gd,A??=cu,I??="butt",O??=Gd,Y??="round",g!=Dt&&(h.strokeStyle=Dt=g),O!=Tt&&(h.fillStyle=Tt=O),y!=Xt&&(h.lineWidth=Xt=y),Y!=zt&&(h.lineJoin=zt=Y),I!=re&&(h.lineCap=re=I),A!=Zt&&h.setLineDash(Zt=A)}function Fe(g,y,A,I){y!=Tt&&(h.fillStyle=Tt=y),g!=pe&&(h.font=pe=g),A!=Ne&&(h.textAlign=Ne=A),I!=Te&&(h.textBaseline=Te=I)}function ce(g,y,A,I,O=0){if(I.length>0&&g.auto(i,W)&&(y==null||y.min==null)){let Y=_e(S,0),st=_e(k,I.length-1),ct=A.min==null?pv(I,Y,st,O,g.distr==3):[A.min,A.max];g.min=_i(g.min,A.min=ct[0]),g.max=Un(g.max,A.max=ct[1])}}let Sn={min:null,max:null};function ls(){for(let I in M){let O=M[I];X[I]==null&&(O.min==null||X[R]!=null&&O.auto(i,W))&&(X[I]=Sn)}for(let I in M){let O=M[I];X[I]==null&&O.from!=null&&X[O.from]!=null&&(X[I]=Sn)}X[R]!=null&&fr(!0);let g={};for(let I in X){let O=X[I];if(O!=null){let Y=g[I]=Dr(M[I],bv);if(O.min!=null)je(Y,O);else if(I!=R||s==2)if(en==0&&Y.from==null){let st=Y.range(i,null,null,I);Y.min=st[0],Y.max=st[1]}else Y.min=Le,Y.max=-Le}}if(en>0){T.forEach((I,O)=>{if(s==1){let Y=I.scale,st=X[Y];if(st==null)return;let ct=g[Y];if(O==0){let gt=ct.range(i,ct.min,ct.max,Y);ct.min=gt[0],ct.max=gt[1],S=gi(ct.min,t[0]),k=gi(ct.max,t[0]),k-S>1&&(t[0][S]<ct.min&&S++,t[0][k]>ct.max&&k--),I.min=$[S],I.max=$[k]}else I.show&&I.auto&&ce(ct,st,I,t[O],I.sorted);I.idxs[0]=S,I.idxs[1]=k}else if(O>0&&I.show&&I.auto){let[Y,st]=I.facets,ct=Y.scale,gt=st.scale,[Et,Ct]=t[O],Lt=g[ct],ee=g[gt];Lt!=null&&ce(Lt,X[ct],Y,Et,Y.sorted),ee!=null&&ce(ee,X[gt],st,Ct,st.sorted),I.min=st.min,I.max=st.max}});for(let I in g){let O=g[I],Y=X[I];if(O.from==null&&(Y==null||Y.min==null)){let st=O.range(i,O.min==Le?null:O.min,O.max==-Le?null:O.max,I);O.min=st[0],O.max=st[1]}}}for(let I in g){let O=g[I];if(O.from!=null){let Y=g[O.from];if(Y.min==null)O.min=O.max=null;else{let st=O.range(i,Y.min,Y.max,I);O.min=st[0],O.max=st[1]}}}let y={},A=!1;for(let I in g){let O=g[I],Y=M[I];if(Y.min!=O.min||Y.max!=O.max){Y.min=O.min,Y.max=O.max;let st=Y.distr;Y._min=st==3?Yi(Y.min):st==4?Gh(Y.min,Y.asinh):st==100?Y.fwd(Y.min):Y.min,Y._max=st==3?Yi(Y.max):st==4?Gh(Y.max,Y.asinh):st==100?Y.fwd(Y.max):Y.max,y[I]=A=!0}}if(A){T.forEach((I,O)=>{s==2?O>0&&y.y&&(I._paths=null):y[I.scale]&&(I._paths=null)});for(let I in y)jt=!0,fn("setScale",I);Yt&&mt.left>=0&&(F=pt=!0)}for(let I in X)X[I]=null}function Rn(g){let y=Kh(S-1,0,en-1),A=Kh(k+1,0,en-1);for(;g[y]==null&&y>0;)y--;for(;g[A]==null&&A<en-1;)A++;return[y,A]}function Fs(){if(en>0){let g=T.some(y=>y._focus)&&ne!=Wn.alpha;g&&(h.globalAlpha=ne=Wn.alpha),T.forEach((y,A)=>{if(A>0&&y.show&&(Oe(A,!1),Oe(A,!0),y._paths==null)){let I=ne;ne!=y.alpha&&(h.globalAlpha=ne=y.alpha);let O=s==2?[0,t[A][0].length-1]:Rn(t[A]);y._paths=y.paths(i,A,O[0],O[1]),ne!=I&&(h.globalAlpha=ne=I)}}),T.forEach((y,A)=>{if(A>0&&y.show){let I=ne;ne!=y.alpha&&(h.globalAlpha=ne=y.alpha),y._paths!=null&&Pn(A,!1);{let O=y._paths!=null?y._paths.gaps:null,Y=y.points.show(i,A,S,k,O),st=y.points.filter(i,A,Y,O);(Y||st)&&(y.points._paths=y.points.paths(i,A,S,k,st),Pn(A,!0))}ne!=I&&(h.globalAlpha=ne=I),fn("drawSeries",A)}}),g&&(h.globalAlpha=ne=1)}}function Oe(g,y){let A=y?T[g].points:T[g];A._stroke=A.stroke(i,g),A._fill=A.fill(i,g)}function Pn(g,y){let A=y?T[g].points:T[g],{stroke:I,fill:O,clip:Y,flags:st,_stroke:ct=A._stroke,_fill:gt=A._fill,_width:Et=A.width}=A._paths;Et=Ue(Et*Me,3);let Ct=null,Lt=Et%2/2;y&&gt==null&&(gt=Et>0?"#fff":ct);let ee=A.pxAlign==1&&Lt>0;if(ee&&h.translate(Lt,Lt),!y){let xe=At-Et/2,me=lt-Et/2,le=_t+Et,Jt=kt+Et;Ct=new Path2D,Ct.rect(xe,me,le,Jt)}y?cn(ct,Et,A.dash,A.cap,gt,I,O,st,Y):Bn(g,ct,Et,A.dash,A.cap,gt,I,O,st,Ct,Y),ee&&h.translate(-Lt,-Lt)}function Bn(g,y,A,I,O,Y,st,ct,gt,Et,Ct){let Lt=!1;gt!=0&&D.forEach((ee,xe)=>{if(ee.series[0]==g){let me=T[ee.series[1]],le=t[ee.series[1]],Jt=(me._paths||ko).band;gs(Jt)&&(Jt=ee.dir==1?Jt[0]:Jt[1]);let Vt,Ve=null;me.show&&Jt&&gv(le,S,k)?(Ve=ee.fill(i,xe)||Y,Vt=me._paths.clip):Jt=null,cn(y,A,I,O,Ve,st,ct,gt,Et,Ct,Vt,Jt),Lt=!0}}),Lt||cn(y,A,I,O,Y,st,ct,gt,Et,Ct)}let ln=Lr|tu;function cn(g,y,A,I,O,Y,st,ct,gt,Et,Ct,Lt){Wt(g,y,A,I,O),(gt||Et||Lt)&&(h.save(),gt&&h.clip(gt),Et&&h.clip(Et)),Lt?(ct&ln)==ln?(h.clip(Lt),Ct&&h.clip(Ct),ti(O,st),cs(g,Y,y)):ct&tu?(ti(O,st),h.clip(Lt),cs(g,Y,y)):ct&Lr&&(h.save(),h.clip(Lt),Ct&&h.clip(Ct),ti(O,st),h.restore(),cs(g,Y,y)):(ti(O,st),cs(g,Y,y)),(gt||Et||Lt)&&h.restore()}function cs(g,y,A){A>0&&(y instanceof Map?y.forEach((I,O)=>{h.strokeStyle=Dt=O,h.stroke(I)}):y!=null&&g&&h.stroke(y))}function ti(g,y){y instanceof Map?y.forEach((A,I)=>{h.fillStyle=Tt=I,h.fill(A)}):y!=null&&g&&h.fill(y)}function H0(g,y,A,I){let O=E[g],Y;if(I<=0)Y=[0,0];else{let st=O._space=O.space(i,g,y,A,I),ct=O._incrs=O.incrs(i,g,y,A,I,st);Y=Ox(y,A,ct,I,st)}return O._found=Y}function ph(g,y,A,I,O,Y,st,ct,gt,Et){let Ct=st%2/2;v==1&&h.translate(Ct,Ct),Wt(ct,st,gt,Et,ct),h.beginPath();let Lt,ee,xe,me,le=O+(I==0||I==3?-Y:Y);A==0?(ee=O,me=le):(Lt=O,xe=le);for(let Jt=0;Jt<g.length;Jt++)y[Jt]!=null&&(A==0?Lt=xe=g[Jt]:ee=me=g[Jt],h.moveTo(Lt,ee),h.lineTo(xe,me));h.stroke(),v==1&&h.translate(-Ct,-Ct)}function G0(g){let y=!0;return E.forEach((A,I)=>{if(!A.show)return;let O=M[A.scale];if(O.min==null){A._show&&(y=!1,A._show=!1,fr(!1));return}else A._show||(y=!1,A._show=!0,fr(!1));let Y=A.side,st=Y%2,{min:ct,max:gt}=O,[Et,Ct]=H0(I,ct,gt,st==0?x:U);if(Ct==0)return;let Lt=O.distr==2,ee=A._splits=A.splits(i,I,ct,gt,Et,Ct,Lt),xe=O.distr==2?ee.map(Vt=>$[Vt]):ee,me=O.distr==2?$[ee[1]]-$[ee[0]]:Et,le=A._values=A.values(i,A.filter(i,xe,I,Ct,me),I,Ct,me);A._rotate=Y==2?A.rotate(i,le,I,Ct):0;let Jt=A._size;A._size=ri(A.size(i,le,I,g)),Jt!=null&&A._size!=Jt&&(y=!1)}),y}function W0(g){let y=!0;return Ia.forEach((A,I)=>{let O=A(i,I,Wi,g);O!=Pi[I]&&(y=!1),Pi[I]=O}),y}function X0(){for(let g=0;g<E.length;g++){let y=E[g];if(!y.show||!y._show)continue;let A=y.side,I=A%2,O,Y,st=y.stroke(i,g),ct=A==0||A==3?-1:1,[gt,Et]=y._found;if(y.label!=null){let Dn=y.labelGap*ct,Yn=nn((y._lpos+Dn)*Me);Fe(y.labelFont[0],st,"center",A==2?"top":Hd),h.save(),I==1?(O=Y=0,h.translate(Yn,nn(lt+kt/2)),h.rotate((A==3?-$a:$a)/2)):(O=nn(At+_t/2),Y=Yn);let ks=Ip(y.label)?y.label(i,g,gt,Et):y.label;h.fillText(ks,O,Y),h.restore()}if(Et==0)continue;let Ct=M[y.scale],Lt=I==0?_t:kt,ee=I==0?At:lt,xe=y._splits,me=Ct.distr==2?xe.map(Dn=>$[Dn]):xe,le=Ct.distr==2?$[xe[1]]-$[xe[0]]:gt,Jt=y.ticks,Vt=y.border,Ve=Jt.show?Jt.size:0,$e=nn(Ve*Me),dn=nn((y.alignTo==2?y._size-Ve-y.gap:y.gap)*Me),Pe=y._rotate*-$a/180,Je=m(y._pos*Me),Xn=($e+dn)*ct,In=Je+Xn;Y=I==0?In:0,O=I==1?In:0;let ei=y.font[0],ui=y.align==1?Ar:y.align==2?zh:Pe>0?Ar:Pe<0?zh:I==0?"center":A==3?zh:Ar,Li=Pe||I==1?"middle":A==2?"top":Hd;Fe(ei,st,ui,Li);let qn=y.font[1]*y.lineGap,ni=xe.map(Dn=>m(a(Dn,Ct,Lt,ee))),fi=y._values;for(let Dn=0;Dn<fi.length;Dn++){let Yn=fi[Dn];if(Yn!=null){I==0?O=ni[Dn]:Y=ni[Dn],Yn=""+Yn;let ks=Yn.indexOf(`
`)==-1?[Yn]:Yn.split(/\n/gm);for(let Ln=0;Ln<ks.length;Ln++){let od=ks[Ln];Pe?(h.save(),h.translate(O,Y+Ln*qn),h.rotate(Pe),h.fillText(od,0,0),h.restore()):h.fillText(od,O,Y+Ln*qn)}}}Jt.show&&ph(ni,Jt.filter(i,me,g,Et,le),I,A,Je,$e,Ue(Jt.width*Me,3),Jt.stroke(i,g),Jt.dash,Jt.cap);let Ui=y.grid;Ui.show&&ph(ni,Ui.filter(i,me,g,Et,le),I,I==0?2:1,I==0?lt:At,I==0?kt:_t,Ue(Ui.width*Me,3),Ui.stroke(i,g),Ui.dash,Ui.cap),Vt.show&&ph([Je],[1],I==0?1:0,I==0?1:2,I==1?lt:At,I==1?kt:_t,Ue(Vt.width*Me,3),Vt.stroke(i,g),Vt.dash,Vt.cap)}fn("drawAxes")}function fr(g){T.forEach((y,A)=>{A>0&&(y._paths=null,g&&(s==1?(y.min=null,y.max=null):y.facets.forEach(I=>{I.min=null,I.max=null})))})}let Da=!1,mh=!1,So=[];function q0(){mh=!1;for(let g=0;g<So.length;g++)fn(...So[g]);So.length=0}function dr(){Da||(Pv(Hf),Da=!0)}function Y0(g,y=!1){Da=!0,mh=y,g(i),Hf(),y&&So.length>0&&queueMicrotask(q0)}i.batch=Y0;function Hf(){if(Bt&&(ls(),Bt=!1),jt&&(Ot(),jt=!1),Mt){if(He(p,Ar,K),He(p,"top",it),He(p,No,x),He(p,Fo,U),He(_,Ar,K),He(_,"top",it),He(_,No,x),He(_,Fo,U),He(f,No,ve),He(f,Fo,P),u.width=nn(ve*Me),u.height=nn(P*Me),E.forEach(({_el:g,_show:y,_size:A,_pos:I,side:O})=>{if(g!=null)if(y){let Y=O===3||O===0?A:0,st=O%2==1;He(g,st?"left":"top",I-Y),He(g,st?"width":"height",A),He(g,st?"top":"left",st?it:K),He(g,st?"height":"width",st?U:x),$h(g,Hs)}else Zn(g,Hs)}),Dt=Tt=Xt=zt=re=pe=Ne=Te=Zt=null,ne=1,To(!0),K!=nt||it!=Nt||x!=ut||U!=It){fr(!1);let g=x/ut,y=U/It;if(Yt&&!F&&mt.left>=0){mt.left*=g,mt.top*=y,pr&&Ni(pr,nn(mt.left),0,x,U),mr&&Ni(mr,0,nn(mt.top),x,U);for(let A=0;A<Cn.length;A++){let I=Cn[A];I!=null&&(Gi[A]*=g,hi[A]*=y,Ni(I,ri(Gi[A]),ri(hi[A]),x,U))}}if(ze.show&&!ft&&ze.left>=0&&ze.width>0){ze.left*=g,ze.width*=g,ze.top*=y,ze.height*=y;for(let A in Mh)He(vr,A,ze[A])}nt=K,Nt=it,ut=x,It=U}fn("setSize"),Mt=!1}ve>0&&P>0&&(h.clearRect(0,0,u.width,u.height),fn("drawClear"),B.forEach(g=>g()),fn("draw")),ze.show&&ft&&(La(ze),ft=!1),Yt&&F&&(Bs(null,!0,!1),F=!1),yt.show&&yt.live&&pt&&(xh(),pt=!1),l||(l=!0,i.status=1,fn("ready")),W=!1,Da=!1}i.redraw=(g,y)=>{jt=y||!1,g!==!1?us(R,C.min,C.max):dr()};function gh(g,y){let A=M[g];if(A.from==null){if(en==0){let I=A.range(i,y.min,y.max,g);y.min=I[0],y.max=I[1]}if(y.min>y.max){let I=y.min;y.min=y.max,y.max=I}if(en>1&&y.min!=null&&y.max!=null&&y.max-y.min<1e-16)return;g==R&&A.distr==2&&en>0&&(y.min=gi(y.min,t[0]),y.max=gi(y.max,t[0]),y.min==y.max&&y.max++),X[g]=y,Bt=!0,dr()}}i.setScale=gh;let _h,vh,pr,mr,Gf,Wf,gr,_r,Xf,qf,ke,Xe,hs=!1,vn=mt.drag,hn=vn.x,un=vn.y;Yt&&(mt.x&&(_h=si(tv,_)),mt.y&&(vh=si(ev,_)),C.ori==0?(pr=_h,mr=vh):(pr=vh,mr=_h),ke=mt.left,Xe=mt.top);let ze=i.select=je({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),vr=ze.show?si(Q_,ze.over?_:p):null;function La(g,y){if(ze.show){for(let A in g)ze[A]=g[A],A in Mh&&He(vr,A,g[A]);y!==!1&&fn("setSelect")}}i.setSelect=La;function Z0(g){if(T[g].show)Qt&&$h(xt[g],Hs);else if(Qt&&Zn(xt[g],Hs),Yt){let A=Ri?Cn[0]:Cn[g];A!=null&&Ni(A,-10,-10,x,U)}}function us(g,y,A){gh(g,{min:y,max:A})}function Ii(g,y,A,I){y.focus!=null&&Q0(g),y.show!=null&&T.forEach((O,Y)=>{Y>0&&(g==Y||g==null)&&(O.show=y.show,Z0(Y),s==2?(us(O.facets[0].scale,null,null),us(O.facets[1].scale,null,null)):us(O.scale,null,null),dr())}),A!==!1&&fn("setSeries",g,y),I&&Eo("setSeries",i,g,y)}i.setSeries=Ii;function $0(g,y){je(D[g],y)}function J0(g,y){g.fill=he(g.fill||null),g.dir=_e(g.dir,-1),y=y??D.length,D.splice(y,0,g)}function K0(g){g==null?D.length=0:D.splice(g,1)}i.addBand=J0,i.setBand=$0,i.delBand=K0;function j0(g,y){T[g].alpha=y,Yt&&Cn[g]!=null&&(Cn[g].style.opacity=y),Qt&&xt[g]&&(xt[g].style.opacity=y)}let Xi,fs,Os,xr={focus:!0};function Q0(g){if(g!=Os){let y=g==null,A=Wn.alpha!=1;T.forEach((I,O)=>{if(s==1||O>0){let Y=y||O==0||O==g;I._focus=y?null:Y,A&&j0(O,Y?1:Wn.alpha)}}),Os=g,A&&dr()}}Qt&&On&&Ht(qd,et,g=>{mt._lock||(_n(g),Os!=null&&Ii(null,xr,!0,Ke.setSeries))});function Di(g,y,A){let I=M[y];A&&(g=g/Me-(I.ori==1?it:K));let O=x;I.ori==1&&(O=U,g=O-g),I.dir==-1&&(g=O-g);let Y=I._min,st=I._max,ct=g/O,gt=Y+(st-Y)*ct,Et=I.distr;return Et==3?Pr(10,gt):Et==4?vv(gt,I.asinh):Et==100?I.bwd(gt):gt}function t_(g,y){let A=Di(g,R,y);return gi(A,t[0],S,k)}i.valToIdx=g=>gi(g,t[0]),i.posToIdx=t_,i.posToVal=Di,i.valToPos=(g,y,A)=>M[y].ori==0?r(g,M[y],A?_t:x,A?At:0):o(g,M[y],A?kt:U,A?lt:0),i.setCursor=(g,y,A)=>{ke=g.left,Xe=g.top,Bs(null,y,A)};function Yf(g,y){He(vr,Ar,ze.left=g),He(vr,No,ze.width=y)}function Zf(g,y){He(vr,"top",ze.top=g),He(vr,Fo,ze.height=y)}let bo=C.ori==0?Yf:Zf,wo=C.ori==1?Yf:Zf;function e_(){if(Qt&&yt.live)for(let g=s==2?1:0;g<T.length;g++){if(g==0&&L)continue;let y=yt.values[g],A=0;for(let I in y)Kt[g][A++].firstChild.nodeValue=y[I]}}function xh(g,y){if(g!=null&&(g.idxs?g.idxs.forEach((A,I)=>{vt[I]=A}):Sv(g.idx)||vt.fill(g.idx),yt.idx=vt[0]),Qt&&yt.live){for(let A=0;A<T.length;A++)(A>0||s==1&&!L)&&n_(A,vt[A]);e_()}pt=!1,y!==!1&&fn("setLegend")}i.setLegend=xh;function n_(g,y){let A=T[g],I=g==0&&G==2?$:t[g],O;L?O=A.values(i,g,y)??ue:(O=A.value(i,y==null?null:I[y],g,y),O=O==null?ue:{_:O}),yt.values[g]=O}function Bs(g,y,A){Xf=ke,qf=Xe,[ke,Xe]=mt.move(i,ke,Xe),mt.left=ke,mt.top=Xe,Yt&&(pr&&Ni(pr,nn(ke),0,x,U),mr&&Ni(mr,0,nn(Xe),x,U));let I,O=S>k;Xi=Le,fs=null;let Y=C.ori==0?x:U,st=C.ori==1?x:U;if(ke<0||en==0||O){I=mt.idx=null;for(let ct=0;ct<T.length;ct++){let gt=Cn[ct];gt!=null&&Ni(gt,-10,-10,x,U)}On&&Ii(null,xr,!0,g==null&&Ke.setSeries),yt.live&&(vt.fill(I),pt=!0)}else{let ct,gt,Et;s==1&&(ct=C.ori==0?ke:Xe,gt=Di(ct,R),I=mt.idx=gi(gt,t[0],S,k),Et=H(t[0][I],C,Y,0));let Ct=-10,Lt=-10,ee=0,xe=0,me=!0,le="",Jt="";for(let Vt=s==2?1:0;Vt<T.length;Vt++){let Ve=T[Vt],$e=vt[Vt],dn=$e==null?null:s==1?t[Vt][$e]:t[Vt][1][$e],Pe=mt.dataIdx(i,Vt,I,gt),Je=Pe==null?null:s==1?t[Vt][Pe]:t[Vt][1][Pe];if(pt=pt||Je!=dn||Pe!=$e,vt[Vt]=Pe,Vt>0&&Ve.show){let Xn=Pe==null?-10:Pe==I?Et:H(s==1?t[0][Pe]:t[Vt][0][Pe],C,Y,0),In=Je==null?-10:q(Je,s==1?M[Ve.scale]:M[Ve.facets[1].scale],st,0);if(On&&Je!=null){let ei=C.ori==1?ke:Xe,ui=sn(Wn.dist(i,Vt,Pe,In,ei));if(ui<Xi){let Li=Wn.bias;if(Li!=0){let qn=Di(ei,Ve.scale),ni=Je>=0?1:-1,fi=qn>=0?1:-1;fi==ni&&(fi==1?Li==1?Je>=qn:Je<=qn:Li==1?Je<=qn:Je>=qn)&&(Xi=ui,fs=Vt)}else Xi=ui,fs=Vt}}if(pt||Ri){let ei,ui;C.ori==0?(ei=Xn,ui=In):(ei=In,ui=Xn);let Li,qn,ni,fi,Ui,Dn,Yn=!0,ks=De.bbox;if(ks!=null){Yn=!1;let Ln=ks(i,Vt);ni=Ln.left,fi=Ln.top,Li=Ln.width,qn=Ln.height}else ni=ei,fi=ui,Li=qn=De.size(i,Vt);if(Dn=De.fill(i,Vt),Ui=De.stroke(i,Vt),Ri)Vt==fs&&Xi<=Wn.prox&&(Ct=ni,Lt=fi,ee=Li,xe=qn,me=Yn,le=Dn,Jt=Ui);else{let Ln=Cn[Vt];Ln!=null&&(Gi[Vt]=ni,hi[Vt]=fi,Qd(Ln,Li,qn,Yn),Kd(Ln,Dn,Ui),Ni(Ln,ri(ni),ri(fi),x,U))}}}}if(Ri){let Vt=Wn.prox,Ve=Os==null?Xi<=Vt:Xi>Vt||fs!=Os;if(pt||Ve){let $e=Cn[0];$e!=null&&(Gi[0]=Ct,hi[0]=Lt,Qd($e,ee,xe,me),Kd($e,le,Jt),Ni($e,ri(Ct),ri(Lt),x,U))}}}if(ze.show&&hs)if(g!=null){let[ct,gt]=Ke.scales,[Et,Ct]=Ke.match,[Lt,ee]=g.cursor.sync.scales,xe=g.cursor.drag;if(hn=xe._x,un=xe._y,hn||un){let{left:me,top:le,width:Jt,height:Vt}=g.select,Ve=g.scales[Lt].ori,$e=g.posToVal,dn,Pe,Je,Xn,In,ei=ct!=null&&Et(ct,Lt),ui=gt!=null&&Ct(gt,ee);ei&&hn?(Ve==0?(dn=me,Pe=Jt):(dn=le,Pe=Vt),Je=M[ct],Xn=H($e(dn,Lt),Je,Y,0),In=H($e(dn+Pe,Lt),Je,Y,0),bo(_i(Xn,In),sn(In-Xn))):bo(0,Y),ui&&un?(Ve==1?(dn=me,Pe=Jt):(dn=le,Pe=Vt),Je=M[gt],Xn=q($e(dn,ee),Je,st,0),In=q($e(dn+Pe,ee),Je,st,0),wo(_i(Xn,In),sn(In-Xn))):wo(0,st)}else Sh()}else{let ct=sn(Xf-Gf),gt=sn(qf-Wf);if(C.ori==1){let ee=ct;ct=gt,gt=ee}hn=vn.x&&ct>=vn.dist,un=vn.y&&gt>=vn.dist;let Et=vn.uni;Et!=null?hn&&un&&(hn=ct>=Et,un=gt>=Et,!hn&&!un&&(gt>ct?un=!0:hn=!0)):vn.x&&vn.y&&(hn||un)&&(hn=un=!0);let Ct,Lt;hn&&(C.ori==0?(Ct=gr,Lt=ke):(Ct=_r,Lt=Xe),bo(_i(Ct,Lt),sn(Lt-Ct)),un||wo(0,st)),un&&(C.ori==1?(Ct=gr,Lt=ke):(Ct=_r,Lt=Xe),wo(_i(Ct,Lt),sn(Lt-Ct)),hn||bo(0,Y)),!hn&&!un&&(bo(0,0),wo(0,0))}if(vn._x=hn,vn._y=un,g==null){if(A){if(rd!=null){let[ct,gt]=Ke.scales;Ke.values[0]=ct!=null?Di(C.ori==0?ke:Xe,ct):null,Ke.values[1]=gt!=null?Di(C.ori==1?ke:Xe,gt):null}Eo(Vh,i,ke,Xe,x,U,I)}if(On){let ct=A&&Ke.setSeries,gt=Wn.prox;Os==null?Xi<=gt&&Ii(fs,xr,!0,ct):Xi>gt?Ii(null,xr,!0,ct):fs!=Os&&Ii(fs,xr,!0,ct)}}pt&&(yt.idx=I,xh()),y!==!1&&fn("setCursor")}let ds=null;Object.defineProperty(i,"rect",{get(){return ds==null&&To(!1),ds}});function To(g=!1){g?ds=null:(ds=_.getBoundingClientRect(),fn("syncRect",ds))}function $f(g,y,A,I,O,Y,st){mt._lock||hs&&g!=null&&g.movementX==0&&g.movementY==0||(yh(g,y,A,I,O,Y,st,!1,g!=null),g!=null?Bs(null,!0,!0):Bs(y,!0,!1))}function yh(g,y,A,I,O,Y,st,ct,gt){if(ds==null&&To(!1),_n(g),g!=null)A=g.clientX-ds.left,I=g.clientY-ds.top;else{if(A<0||I<0){ke=-10,Xe=-10;return}let[Et,Ct]=Ke.scales,Lt=y.cursor.sync,[ee,xe]=Lt.values,[me,le]=Lt.scales,[Jt,Vt]=Ke.match,Ve=y.axes[0].side%2==1,$e=C.ori==0?x:U,dn=C.ori==1?x:U,Pe=Ve?Y:O,Je=Ve?O:Y,Xn=Ve?I:A,In=Ve?A:I;if(me!=null?A=Jt(Et,me)?a(ee,M[Et],$e,0):-10:A=$e*(Xn/Pe),le!=null?I=Vt(Ct,le)?a(xe,M[Ct],dn,0):-10:I=dn*(In/Je),C.ori==1){let ei=A;A=I,I=ei}}gt&&(y==null||y.cursor.event.type==Vh)&&((A<=1||A>=x-1)&&(A=zs(A,x)),(I<=1||I>=U-1)&&(I=zs(I,U))),ct?(Gf=A,Wf=I,[gr,_r]=mt.move(i,A,I)):(ke=A,Xe=I)}let Mh={width:0,height:0,left:0,top:0};function Sh(){La(Mh,!1)}let Jf,Kf,jf,Qf;function td(g,y,A,I,O,Y,st){hs=!0,hn=un=vn._x=vn._y=!1,yh(g,y,A,I,O,Y,st,!0,!1),g!=null&&(Ht(Hh,Yh,ed,!1),Eo(Wd,i,gr,_r,x,U,null));let{left:ct,top:gt,width:Et,height:Ct}=ze;Jf=ct,Kf=gt,jf=Et,Qf=Ct}function ed(g,y,A,I,O,Y,st){hs=vn._x=vn._y=!1,yh(g,y,A,I,O,Y,st,!1,!0);let{left:ct,top:gt,width:Et,height:Ct}=ze,Lt=Et>0||Ct>0,ee=Jf!=ct||Kf!=gt||jf!=Et||Qf!=Ct;if(Lt&&ee&&La(ze),vn.setScale&&Lt&&ee){let xe=ct,me=Et,le=gt,Jt=Ct;if(C.ori==1&&(xe=gt,me=Ct,le=ct,Jt=Et),hn&&us(R,Di(xe,R),Di(xe+me,R)),un)for(let Vt in M){let Ve=M[Vt];Vt!=R&&Ve.from==null&&Ve.min!=Le&&us(Vt,Di(le+Jt,Vt),Di(le,Vt))}Sh()}else mt.lock&&(mt._lock=!mt._lock,Bs(y,!0,g!=null));g!=null&&(Be(Hh,Yh),Eo(Hh,i,ke,Xe,x,U,null))}function i_(g,y,A,I,O,Y,st){if(mt._lock)return;_n(g);let ct=hs;if(hs){let gt=!0,Et=!0,Ct=10,Lt,ee;C.ori==0?(Lt=hn,ee=un):(Lt=un,ee=hn),Lt&&ee&&(gt=ke<=Ct||ke>=x-Ct,Et=Xe<=Ct||Xe>=U-Ct),Lt&&gt&&(ke=ke<gr?0:x),ee&&Et&&(Xe=Xe<_r?0:U),Bs(null,!0,!0),hs=!1}ke=-10,Xe=-10,vt.fill(null),Bs(null,!0,!0),ct&&(hs=ct)}function nd(g,y,A,I,O,Y,st){mt._lock||(_n(g),bt(),Sh(),g!=null&&Eo(Yd,i,ke,Xe,x,U,null))}function id(){E.forEach(Bx),Pt(i.width,i.height,!0)}Gs(Ja,Rr,id);let yr={};yr.mousedown=td,yr.mousemove=$f,yr.mouseup=ed,yr.dblclick=nd,yr.setSeries=(g,y,A,I)=>{let O=Ke.match[2];A=O(i,y,A),A!=-1&&Ii(A,I,!0,!1)},Yt&&(Ht(Wd,_,td),Ht(Vh,_,$f),Ht(Xd,_,g=>{_n(g),To(!1)}),Ht(qd,_,i_),Ht(Yd,_,nd),eu.add(i),i.syncRect=To);let Ua=i.hooks=n.hooks||{};function fn(g,y,A){mh?So.push([g,y,A]):g in Ua&&Ua[g].forEach(I=>{I.call(null,i,y,A)})}(n.plugins||[]).forEach(g=>{for(let y in g.hooks)Ua[y]=(Ua[y]||[]).concat(g.hooks[y])});let sd=(g,y,A)=>A,Ke=je({key:null,setSeries:!1,filters:{pub:sp,sub:sp},scales:[R,T[1]?T[1].scale:null],match:[rp,rp,sd],values:[null,null]},mt.sync);Ke.match.length==2&&Ke.match.push(sd),mt.sync=Ke;let rd=Ke.key,bh=em(rd);function Eo(g,y,A,I,O,Y,st){Ke.filters.pub(g,y,A,I,O,Y,st)&&bh.pub(g,y,A,I,O,Y,st)}bh.sub(i);function s_(g,y,A,I,O,Y,st){Ke.filters.sub(g,y,A,I,O,Y,st)&&yr[g](null,y,A,I,O,Y,st)}i.pub=s_;function r_(){bh.unsub(i),eu.delete(i),Rt.clear(),Jh(Ja,Rr,id),c.remove(),et?.remove(),fn("destroy")}i.destroy=r_;function wh(){fn("init",n,t),dt(t||n.data,!1),X[R]?gh(R,X[R]):bt(),ft=ze.show&&(ze.width>0||ze.height>0),F=pt=!0,Pt(n.width,n.height)}return T.forEach(Us),E.forEach(dh),e?e instanceof HTMLElement?(e.appendChild(c),wh()):e(i,wh):wh(),i}pn.assign=je;pn.fmtNum=lu;pn.rangeNum=Ka;pn.rangeLog=tl;pn.rangeAsinh=ou;pn.orient=Xs;pn.pxRatio=Me;pn.join=Rv;pn.fmtDate=hu,pn.tzDate=zv;pn.sync=em;{pn.addGap=Sx,pn.clipGaps=il;let n=pn.paths={points:am};n.linear=cm,n.stepped=Tx,n.bars=Ex,n.spline=Cx}var kx=210,zx=320;function dm(n,t){let e={before:"--before",after:"--after"}[n.role];return qe(e??`--series-${(n.colour??t)%6+1}`)}function Vx(n){return t=>{let{ctx:e,bbox:i}=t;e.save(),e.beginPath();for(let[r,o]of n.held_out){let a=t.valToPos((r-.5)/n.rate,"x",!0),l=t.valToPos((o+.5)/n.rate,"x",!0);e.rect(a,i.top,l-a,i.height)}e.clip(),e.strokeStyle=qe("--hatch"),e.lineWidth=devicePixelRatio,e.beginPath();let s=7*devicePixelRatio;for(let r=i.left-i.height;r<i.left+i.width;r+=s)e.moveTo(r,i.top+i.height),e.lineTo(r+i.height,i.top);e.stroke(),e.restore()}}function Hx(n,t,e,i){let s=Math.log10(i/e),r=s>3?[1]:s>1.2?[1,2,5]:[1,1.5,2,3,5,7],o=[];for(let a=Math.floor(Math.log10(e));a<=Math.log10(i);++a)for(let l of r)o.push(+`${l}e${a}`);return o.filter(a=>a>=e*(1-1e-9)&&a<=i*(1+1e-9))}function pm(n,t,e,i){return{label:t?`${n}, ${bn(t)}`:n,labelSize:22,labelFont:"12px system-ui, sans-serif",font:"11px system-ui, sans-serif",stroke:()=>qe("--ink-soft"),grid:{stroke:()=>qe("--grid-soft"),width:1},ticks:{stroke:()=>qe("--grid-soft"),width:1},size:e?i?66:52:34,values:(s,r)=>r.map(o=>o===null?"":ge(o,4)),...i?{splits:Hx,filter:(s,r)=>r}:{}}}function Gx(n){if(n.from_zero)return(t,e,i)=>[0,(i||1)*1.08];if(n.log)return(t,e,i)=>[(e||1)/1.12,(i||1)*1.12]}var _u=n=>n.tall?zx:kx;function Wx(n,t,e){let i=!!n.frames,s=i?{title:"time",unit:"s"}:n.x;return{width:e,height:_u(n),cursor:{points:{size:7},drag:{x:!1,y:!1}},legend:{live:!0},scales:{x:{time:!1,distr:n.x?.log?3:1},y:{distr:n.y.log?3:1,range:Gx(n.y)}},axes:[pm(s.title,s.unit,!1,s.log),pm(bn(n.y.unit)||n.y.title,"",!0,n.y.log)],series:[{label:s.title,value:(r,o)=>o===null?"\u2013":`${ge(o,4)} ${bn(s.unit)}`},...n.series.map((r,o)=>({label:r.name,stroke:()=>dm(r,o),width:2,spanGaps:!!(r.steps||r.joined),paths:r.steps?pn.paths.stepped({align:1}):void 0,dash:r.role==="before"?[6,4]:void 0,points:{show:!!r.points,size:6,fill:()=>dm(r,o)},value:(a,l)=>l===null?"\u2013":`${ge(l,3)} ${bn(n.y.unit)}`}))],hooks:i?{drawClear:[Vx(t)]}:{}}}function Xx(n,t,e){let i=V("div",{class:"now-line"});n.over.append(i);let s=l=>{i.style.transform=`translateX(${n.valToPos(l/e.rate,"x")}px)`},r=l=>{n.cursor.left<0&&n.setLegend({idx:l},!1)},o=l=>{s(l),r(l)},a=!1;return wr(n.root,l=>{a=l,l&&o(t.frame)}),t.onFrame(l=>{a&&s(l)}),t.onFrameSlowly(l=>{a&&r(l)}),n.over.addEventListener("pointerdown",l=>{let{left:c}=n.over.getBoundingClientRect(),u=h=>t.seek(n.posToVal(h.clientX-c,"x")*e.rate);t.pause(),u(l),n.over.setPointerCapture(l.pointerId),n.over.onpointermove=u,n.over.onpointerup=()=>{n.over.onpointermove=null}}),n.hooks.setCursor=[()=>{n.cursor.left<0&&o(t.frame)}],{show:o}}function mm(n,{player:t,clock:e}){let i=V("div",{class:"plot",style:`min-height: ${_u(n)+30}px`}),s=V("figure",{class:"chart"},V("figcaption",{},n.title),i),o=[n.frames?Array.from({length:e.frames},(a,l)=>l/e.rate):n.x.values,...n.series.map(a=>a.values)];return br(s,()=>{let a=new pn(Wx(n,e,Math.max(240,i.clientWidth)),o,i),l=n.frames?Xx(a,t,e):null;new ResizeObserver(()=>{Math.abs(i.clientWidth-a.width)<2||i.clientWidth===0||(a.setSize({width:i.clientWidth,height:_u(n)}),l?.show(t.frame))}).observe(i),Va(()=>a.redraw(!1)),requestAnimationFrame(()=>l?.show(t.frame))}),s}function gm(n){let t=V("img",{alt:n.title}),e=V("figure",{class:"chart picture"},V("figcaption",{},n.title),t);return br(e,async()=>{let i=new Blob([await Ee(n.image)],{type:n.type});t.src=URL.createObjectURL(i)}),e}function vu(n,t){return n.folded?V("details",{class:"folded"},V("summary",{},n.title),t):n.title?V("div",{},V("p",{class:"block-title"},n.title),t):t}function _m(n){return V("div",{class:"prose"},n.paragraphs.map(t=>V("p",{},t)))}function vm(n){return vu(n,V("pre",{tabindex:0},V("code",{},n.text)))}function xm(n){return V("h3",{class:"block-heading"},n.text)}function qx({text:n,href:t}){return t.startsWith("./")?V("a",{href:t},n):n}function Yx(n,t){if(n?.href)return V("td",{},qx(n));let e=typeof n=="number"?ge(n):n??"\u2013",i=t.code?V("code",{},e):String(e);return V("td",{class:t.number?"number":t.wide?"wide-cell":null},i)}function ym(n){return n.unit?`${n.title}, ${n.unit}`:n.title}function Mm(n){if(typeof n=="number")return n;if(n?.href)return n.text;let t=Number.parseFloat(n);return Number.isFinite(t)?t:String(n)}function Zx(n,t){let[e,i]=[Mm(n),Mm(t)];return typeof e==typeof i?e<i?-1:+(e>i):typeof e=="number"?-1:1}var Sm=n=>n===null||n===""||n==="-";function $x(n,t,e){let i=n.filter(s=>!Sm(s[t]));return i.sort((s,r)=>e*Zx(s[t],r[t])),[...i,...n.filter(s=>Sm(s[t]))]}function Jx(n,t,e){let i=n.columns[t],s=n.sortable?V("button",{type:"button",class:"sort",onclick:()=>e(t)},ym(i)):ym(i);return V("th",{class:i.number?"number":null,scope:"col"},s)}function bm(n){let t=V("tbody"),e=o=>t.replaceChildren(...o.map(a=>V("tr",{},a.map((l,c)=>Yx(l,n.columns[c]))))),i={index:-1,sign:1},s=n.columns.map((o,a)=>Jx(n,a,l=>{i={index:l,sign:i.index===l?-i.sign:1},s.forEach((c,u)=>c.setAttribute("aria-sort",u!==l?"none":i.sign>0?"ascending":"descending")),e($x(n.rows,i.index,i.sign))}));e(n.rows);let r=n.columns.some(o=>o.title);return vu(n,V("div",{class:"table-scroll",tabindex:0},V("table",{},r?V("thead",{},V("tr",{},s)):null,t)))}var Kx={text:_m,heading:xm,picture:gm,table:bm,code:vm,lines:mm,bars:Ud,intervals:kd,interval_pairs:zd,heatmap:Bd,cameras:(n,{pictures:t,player:e,picturePanel:i})=>wd(t,e,i)},jx=new Set(["lines","heatmap"]),Qx=n=>n.kind==="heatmap";function ty(n,t){let e=Kx[n.kind],i=e?e(n,t):V("p",{},`This page does not know blocks of the kind "${n.kind}".`);return i.classList.add(n.narrow??jx.has(n.kind)?"narrow":"wide"),i}function wm(n,t){return V("section",{class:"card",id:n.id,"aria-labelledby":`${n.id}-title`},V("h2",{id:`${n.id}-title`},n.title),n.lead?V("p",{class:"lead"},n.lead):null,V("div",{class:n.blocks.filter(Qx).length>2?"blocks maps":"blocks"},n.blocks.map(e=>ty(e,{...t,section:n}))))}function Tm(n){return V("nav",{"aria-label":"Sections"},n.map(t=>V("a",{href:`#${t.id}`},t.short??t.title)))}var ey=[.1,.25,.5,1,2];function ny(n){let t=Math.max(1,n.frames-1);return n.held_out.map(([e,i])=>V("span",{class:"held-out",title:"held out",style:`left: ${100*e/t}%; width: ${100*(i-e)/t}%`}))}function iy(n){let t={ArrowLeft:-1,ArrowRight:1,",":-1,".":1,PageUp:-10,PageDown:10};document.addEventListener("keydown",e=>{if(e.ctrlKey||e.metaKey||e.altKey)return;let i=e.target.tagName;if(i==="INPUT"||i==="SELECT"||i==="TEXTAREA")return;let s=i==="BUTTON"||i==="SUMMARY"||i==="A";if(e.key===" "&&!s)n.toggle();else if((e.key==="ArrowLeft"||e.key==="ArrowRight")&&e.shiftKey)n.seek(n.frame+10*t[e.key]);else if(e.key in t&&!e.key.startsWith("Page"))n.pause(),n.seek(n.frame+t[e.key]);else return;e.preventDefault()})}function Em(n,t){let e=V("button",{type:"button",class:"play",onclick:()=>n.toggle()}),i=V("input",{type:"range",min:0,max:t.frames-1,step:1,value:0,"aria-label":"Frame",id:"frame-slider",oninput:()=>{let o=Number(i.value);n.pause(),n.seek(o)}}),s=V("output",{class:"now",for:"frame-slider"}),r=Sr("Speed",ey.map(o=>({value:String(o),title:`${o}\xD7`})),"1",o=>n.setSpeed(Number(o)));return n.onState(()=>{e.textContent=n.isPlaying?"\u275A\u275A":"\u25BA",e.setAttribute("aria-label",n.isPlaying?"Pause":"Play")}),n.onFrameSlowly(o=>{i.value=o;let a=t.held_out.some(([c,u])=>o>=c&&o<=u),l=a?"held out":o<=t.last_fitted?"fitted":"not fitted";i.setAttribute("aria-valuetext",`frame ${o}, ${l}`),s.replaceChildren(V("span",{class:"frame"},`${o} / ${t.frames-1}`),V("span",{class:"time"},Dd(o/t.rate)),V("span",{class:`state ${a?"is-held-out":""}`},l))}),iy(n),V("div",{class:"transport",role:"group","aria-label":"Time"},e,V("div",{class:"track"},V("div",{class:"marks"},ny(t)),i),s,r)}var Ps={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Is={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ig=0,ju=1,sg=2;var Qu=1,rg=2,zi=3,bi=0,Mn=1,Fn=2,rs=0,Ks=1,tf=2,ef=3,nf=4,og=5,Ts=100,ag=101,lg=102,cg=103,hg=104,ug=200,fg=201,dg=202,pg=203,Ll=204,Ul=205,mg=206,gg=207,_g=208,vg=209,xg=210,yg=211,Mg=212,Sg=213,bg=214,oc=0,ac=1,lc=2,js=3,cc=4,hc=5,uc=6,fc=7,dc=0,wg=1,Tg=2,os=0,Eg=1,Ag=2,Cg=3,Rg=4,Pg=5,Ig=6,Dg=7;var sf=300,nr=301,ir=302,pc=303,mc=304,Sa=306,Nl=1e3,ws=1001,Fl=1002,li=1003,Lg=1004;var ba=1005;var wi=1006,gc=1007;var Ds=1008;var Ci=1009,rf=1010,of=1011,uo=1012,_c=1013,Ls=1014,Vi=1015,fo=1016,vc=1017,xc=1018,po=1020,af=35902,lf=35899,cf=1021,hf=1022,ci=1023,to=1026,mo=1027,uf=1028,yc=1029,ff=1030,Mc=1031;var Sc=1033,wa=33776,Ta=33777,Ea=33778,Aa=33779,bc=35840,wc=35841,Tc=35842,Ec=35843,Ac=36196,Cc=37492,Rc=37496,Pc=37808,Ic=37809,Dc=37810,Lc=37811,Uc=37812,Nc=37813,Fc=37814,Oc=37815,Bc=37816,kc=37817,zc=37818,Vc=37819,Hc=37820,Gc=37821,Wc=36492,Xc=36494,qc=36495,Yc=36283,Zc=36284,$c=36285,Jc=36286;var Ko=2300,Ol=2301,Dl=2302,Gu=2400,Wu=2401,Xu=2402;var Ug=3200,Ng=3201;var df=0,Fg=1,as="",xn="srgb",Qs="srgb-linear",jo="linear",Ce="srgb";var Js=7680;var qu=519,Og=512,Bg=513,kg=514,pf=515,zg=516,Vg=517,Hg=518,Gg=519,Bl=35044,go=35048;var mf="300 es",Si=2e3,Qo=2001;var Fi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},wn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Am=1234567,$o=Math.PI/180,eo=180/Math.PI;function es(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(wn[n&255]+wn[n>>8&255]+wn[n>>16&255]+wn[n>>24&255]+"-"+wn[t&255]+wn[t>>8&255]+"-"+wn[t>>16&15|64]+wn[t>>24&255]+"-"+wn[e&63|128]+wn[e>>8&255]+"-"+wn[e>>16&255]+wn[e>>24&255]+wn[i&255]+wn[i>>8&255]+wn[i>>16&255]+wn[i>>24&255]).toLowerCase()}function ae(n,t,e){return Math.max(t,Math.min(e,n))}function gf(n,t){return(n%t+t)%t}function sy(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function ry(n,t,e){return n!==t?(e-n)/(t-n):0}function Jo(n,t,e){return(1-e)*n+e*t}function oy(n,t,e,i){return Jo(n,t,1-Math.exp(-e*i))}function ay(n,t=1){return t-Math.abs(gf(n,t*2)-t)}function ly(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function cy(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function hy(n,t){return n+Math.floor(Math.random()*(t-n+1))}function uy(n,t){return n+Math.random()*(t-n)}function fy(n){return n*(.5-Math.random())}function dy(n){n!==void 0&&(Am=n);let t=Am+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function py(n){return n*$o}function my(n){return n*eo}function gy(n){return(n&n-1)===0&&n!==0}function _y(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function vy(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function xy(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),f=o((t-i)/2),p=r((i-t)/2),_=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*_,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*_,a*c);break;case"ZYZ":n.set(l*_,l*p,a*u,a*c);break;default:console.warn("THREE.MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Mi(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Ae(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}var _f={DEG2RAD:$o,RAD2DEG:eo,generateUUID:es,clamp:ae,euclideanModulo:gf,mapLinear:sy,inverseLerp:ry,lerp:Jo,damp:oy,pingpong:ay,smoothstep:ly,smootherstep:cy,randInt:hy,randFloat:uy,randFloatSpread:fy,seededRandom:dy,degToRad:py,radToDeg:my,isPowerOfTwo:gy,ceilPowerOfTwo:_y,floorPowerOfTwo:vy,setQuaternionFromProperEuler:xy,normalize:Ae,denormalize:Mi},qt=class n{constructor(t=0,e=0){n.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Vn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],p=r[o+1],_=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=p,t[e+2]=_,t[e+3]=v;return}if(h!==v||l!==f||c!==p||u!==_){let m=1-a,d=l*f+c*p+u*_+h*v,T=d>=0?1:-1,E=1-d*d;if(E>Number.EPSILON){let D=Math.sqrt(E),R=Math.atan2(D,d*T);m=Math.sin(m*R)/D,a=Math.sin(a*R)/D}let M=a*T;if(l=l*m+f*M,c=c*m+p*M,u=u*m+_*M,h=h*m+v*M,m===1-a){let D=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=D,c*=D,u*=D,h*=D}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],p=r[o+2],_=r[o+3];return t[e]=a*_+u*h+l*p-c*f,t[e+1]=l*_+u*f+c*h-a*p,t[e+2]=c*_+u*p+a*f-l*h,t[e+3]=u*_-a*h-l*f-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),p=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h-f*p*_;break;case"YXZ":this._x=f*u*h+c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h+f*p*_;break;case"ZXY":this._x=f*u*h-c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h-f*p*_;break;case"ZYX":this._x=f*u*h-c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h+f*p*_;break;case"YZX":this._x=f*u*h+c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h-f*p*_;break;case"XZY":this._x=f*u*h-c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h+f*p*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>h){let p=2*Math.sqrt(1+i-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){let p=2*Math.sqrt(1+a-i-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+h-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ae(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);let i=this._x,s=this._y,r=this._z,o=this._w,a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;let l=1-a*a;if(l<=Number.EPSILON){let p=1-e;return this._w=p*o+e*this._w,this._x=p*i+e*this._x,this._y=p*s+e*this._y,this._z=p*r+e*this._z,this.normalize(),this}let c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class n{constructor(t=0,e=0,i=0){n.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Cm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Cm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this.z=ae(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this.z=ae(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return xu.copy(this).projectOnVector(t),this.sub(xu)}reflect(t){return this.sub(xu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ae(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},xu=new z,Cm=new Vn,ie=class n{constructor(t,e,i,s,r,o,a,l,c){n.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],p=i[5],_=i[8],v=s[0],m=s[3],d=s[6],T=s[1],E=s[4],M=s[7],D=s[2],R=s[5],N=s[8];return r[0]=o*v+a*T+l*D,r[3]=o*m+a*E+l*R,r[6]=o*d+a*M+l*N,r[1]=c*v+u*T+h*D,r[4]=c*m+u*E+h*R,r[7]=c*d+u*M+h*N,r[2]=f*v+p*T+_*D,r[5]=f*m+p*E+_*R,r[8]=f*d+p*M+_*N,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,_=e*h+i*f+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/_;return t[0]=h*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=p*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(yu.makeScale(t,e)),this}rotate(t){return this.premultiply(yu.makeRotation(-t)),this}translate(t,e){return this.premultiply(yu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},yu=new ie;function vf(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function ta(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Wg(){let n=ta("canvas");return n.style.display="block",n}var Rm={};function no(n){n in Rm||(Rm[n]=!0,console.warn(n))}function Xg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Pm=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Im=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function yy(){let n={enabled:!0,workingColorSpace:Qs,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ce&&(s.r=ns(s.r),s.g=ns(s.g),s.b=ns(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ce&&(s.r=Qr(s.r),s.g=Qr(s.g),s.b=Qr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===as?jo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return no("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),n.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return no("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),n.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Qs]:{primaries:t,whitePoint:i,transfer:jo,toXYZ:Pm,fromXYZ:Im,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:xn},outputColorSpaceConfig:{drawingBufferColorSpace:xn}},[xn]:{primaries:t,whitePoint:i,transfer:Ce,toXYZ:Pm,fromXYZ:Im,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:xn}}}),n}var fe=yy();function ns(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Qr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Or,kl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Or===void 0&&(Or=ta("canvas")),Or.width=t.width,Or.height=t.height;let s=Or.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Or}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ta("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ns(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ns(e[i]/255)*255):e[i]=ns(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},My=0,io=class{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:My++}),this.uuid=es(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Mu(s[o].image)):r.push(Mu(s[o]))}else r=Mu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Mu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?kl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}var Sy=0,Su=new z,Hn=class n extends Fi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=ws,s=ws,r=wi,o=Ds,a=ci,l=Ci,c=n.DEFAULT_ANISOTROPY,u=as){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Sy++}),this.uuid=es(),this.name="",this.source=new io(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new qt(0,0),this.repeat=new qt(1,1),this.center=new qt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(Su).x}get height(){return this.source.getSize(Su).y}get depth(){return this.source.getSize(Su).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==sf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Nl:t.x=t.x-Math.floor(t.x);break;case ws:t.x=t.x<0?0:1;break;case Fl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Nl:t.y=t.y-Math.floor(t.y);break;case ws:t.y=t.y<0?0:1;break;case Fl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Hn.DEFAULT_IMAGE=null;Hn.DEFAULT_MAPPING=sf;Hn.DEFAULT_ANISOTROPY=1;var Ze=class n{constructor(t=0,e=0,i=0,s=1){n.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],_=l[9],v=l[2],m=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(_+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let E=(c+1)/2,M=(p+1)/2,D=(d+1)/2,R=(u+f)/4,N=(h+v)/4,B=(_+m)/4;return E>M&&E>D?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=R/i,r=N/i):M>D?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=R/s,r=B/s):D<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(D),i=N/r,s=B/r),this.set(i,s,r,e),this}let T=Math.sqrt((m-_)*(m-_)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(T)<.001&&(T=1),this.x=(m-_)/T,this.y=(h-v)/T,this.z=(f-u)/T,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ae(this.x,t.x,e.x),this.y=ae(this.y,t.y,e.y),this.z=ae(this.z,t.z,e.z),this.w=ae(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ae(this.x,t,e),this.y=ae(this.y,t,e),this.z=ae(this.z,t,e),this.w=ae(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ae(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},zl=class extends Fi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:wi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Ze(0,0,t,e),this.scissorTest=!1,this.viewport=new Ze(0,0,t,e);let s={width:t,height:e,depth:i.depth},r=new Hn(s);this.textures=[];let o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview}_setTextureOptions(t={}){let e={minFilter:wi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new io(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}},Oi=class extends zl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ea=class extends Hn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=li,this.minFilter=li,this.wrapR=ws,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Vl=class extends Hn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=li,this.minFilter=li,this.wrapR=ws,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Bi=class{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(vi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(vi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=vi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,vi):vi.fromBufferAttribute(r,o),vi.applyMatrix4(t.matrixWorld),this.expandByPoint(vi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),al.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),al.copy(i.boundingBox)),al.applyMatrix4(t.matrixWorld),this.union(al)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,vi),vi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Vo),ll.subVectors(this.max,Vo),Br.subVectors(t.a,Vo),kr.subVectors(t.b,Vo),zr.subVectors(t.c,Vo),vs.subVectors(kr,Br),xs.subVectors(zr,kr),qs.subVectors(Br,zr);let e=[0,-vs.z,vs.y,0,-xs.z,xs.y,0,-qs.z,qs.y,vs.z,0,-vs.x,xs.z,0,-xs.x,qs.z,0,-qs.x,-vs.y,vs.x,0,-xs.y,xs.x,0,-qs.y,qs.x,0];return!bu(e,Br,kr,zr,ll)||(e=[1,0,0,0,1,0,0,0,1],!bu(e,Br,kr,zr,ll))?!1:(cl.crossVectors(vs,xs),e=[cl.x,cl.y,cl.z],bu(e,Br,kr,zr,ll))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,vi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(vi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:($i[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),$i[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),$i[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),$i[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),$i[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),$i[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),$i[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),$i[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints($i),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},$i=[new z,new z,new z,new z,new z,new z,new z,new z],vi=new z,al=new Bi,Br=new z,kr=new z,zr=new z,vs=new z,xs=new z,qs=new z,Vo=new z,ll=new z,cl=new z,Ys=new z;function bu(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ys.fromArray(n,r);let a=s.x*Math.abs(Ys.x)+s.y*Math.abs(Ys.y)+s.z*Math.abs(Ys.z),l=t.dot(Ys),c=e.dot(Ys),u=i.dot(Ys);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var by=new Bi,Ho=new z,wu=new z,Es=class{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):by.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Ho.subVectors(t,this.center);let e=Ho.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Ho,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(wu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Ho.copy(t.center).add(wu)),this.expandByPoint(Ho.copy(t.center).sub(wu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ji=new z,Tu=new z,hl=new z,ys=new z,Eu=new z,ul=new z,Au=new z,is=class{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ji)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ji.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ji.copy(this.origin).addScaledVector(this.direction,e),Ji.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Tu.copy(t).add(e).multiplyScalar(.5),hl.copy(e).sub(t).normalize(),ys.copy(this.origin).sub(Tu);let r=t.distanceTo(e)*.5,o=-this.direction.dot(hl),a=ys.dot(this.direction),l=-ys.dot(hl),c=ys.lengthSq(),u=Math.abs(1-o*o),h,f,p,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){let v=1/u;h*=v,f*=v,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Tu).addScaledVector(hl,f),p}intersectSphere(t,e){Ji.subVectors(t.center,this.origin);let i=Ji.dot(this.direction),s=Ji.dot(Ji)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Ji)!==null}intersectTriangle(t,e,i,s,r){Eu.subVectors(e,t),ul.subVectors(i,t),Au.crossVectors(Eu,ul);let o=this.direction.dot(Au),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ys.subVectors(this.origin,t);let l=a*this.direction.dot(ul.crossVectors(ys,ul));if(l<0)return null;let c=a*this.direction.dot(Eu.cross(ys));if(c<0||l+c>o)return null;let u=-a*ys.dot(Au);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},We=class n{constructor(t,e,i,s,r,o,a,l,c,u,h,f,p,_,v,m){n.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,f,p,_,v,m)}set(t,e,i,s,r,o,a,l,c,u,h,f,p,_,v,m){let d=this.elements;return d[0]=t,d[4]=e,d[8]=i,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=p,d[7]=_,d[11]=v,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){let e=this.elements,i=t.elements,s=1/Vr.setFromMatrixColumn(t,0).length(),r=1/Vr.setFromMatrixColumn(t,1).length(),o=1/Vr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let f=o*u,p=o*h,_=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=p+_*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=_+p*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*u,p=l*h,_=c*u,v=c*h;e[0]=f+v*a,e[4]=_*a-p,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=p*a-_,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*u,p=l*h,_=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=_+p*a,e[1]=p+_*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*u,p=o*h,_=a*u,v=a*h;e[0]=l*u,e[4]=_*c-p,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=p*c-_,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,p=o*c,_=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=_*h+p,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=p*h+_,e[10]=f-v*h}else if(t.order==="XZY"){let f=o*l,p=o*c,_=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=p*h-_,e[2]=_*h-p,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(wy,t,Ty)}lookAt(t,e,i){let s=this.elements;return Kn.subVectors(t,e),Kn.lengthSq()===0&&(Kn.z=1),Kn.normalize(),Ms.crossVectors(i,Kn),Ms.lengthSq()===0&&(Math.abs(i.z)===1?Kn.x+=1e-4:Kn.z+=1e-4,Kn.normalize(),Ms.crossVectors(i,Kn)),Ms.normalize(),fl.crossVectors(Kn,Ms),s[0]=Ms.x,s[4]=fl.x,s[8]=Kn.x,s[1]=Ms.y,s[5]=fl.y,s[9]=Kn.y,s[2]=Ms.z,s[6]=fl.z,s[10]=Kn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],p=i[13],_=i[2],v=i[6],m=i[10],d=i[14],T=i[3],E=i[7],M=i[11],D=i[15],R=s[0],N=s[4],B=s[8],w=s[12],b=s[1],C=s[5],G=s[9],H=s[13],q=s[2],X=s[6],Z=s[10],J=s[14],Q=s[3],ot=s[7],at=s[11],vt=s[15];return r[0]=o*R+a*b+l*q+c*Q,r[4]=o*N+a*C+l*X+c*ot,r[8]=o*B+a*G+l*Z+c*at,r[12]=o*w+a*H+l*J+c*vt,r[1]=u*R+h*b+f*q+p*Q,r[5]=u*N+h*C+f*X+p*ot,r[9]=u*B+h*G+f*Z+p*at,r[13]=u*w+h*H+f*J+p*vt,r[2]=_*R+v*b+m*q+d*Q,r[6]=_*N+v*C+m*X+d*ot,r[10]=_*B+v*G+m*Z+d*at,r[14]=_*w+v*H+m*J+d*vt,r[3]=T*R+E*b+M*q+D*Q,r[7]=T*N+E*C+M*X+D*ot,r[11]=T*B+E*G+M*Z+D*at,r[15]=T*w+E*H+M*J+D*vt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],p=t[14],_=t[3],v=t[7],m=t[11],d=t[15];return _*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*p-i*l*p)+v*(+e*l*p-e*c*f+r*o*f-s*o*p+s*c*u-r*l*u)+m*(+e*c*h-e*a*p-r*o*h+i*o*p+r*a*u-i*c*u)+d*(-s*a*u-e*l*h+e*a*f+s*o*h-i*o*f+i*l*u)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],p=t[11],_=t[12],v=t[13],m=t[14],d=t[15],T=h*m*c-v*f*c+v*l*p-a*m*p-h*l*d+a*f*d,E=_*f*c-u*m*c-_*l*p+o*m*p+u*l*d-o*f*d,M=u*v*c-_*h*c+_*a*p-o*v*p-u*a*d+o*h*d,D=_*h*l-u*v*l-_*a*f+o*v*f+u*a*m-o*h*m,R=e*T+i*E+s*M+r*D;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let N=1/R;return t[0]=T*N,t[1]=(v*f*r-h*m*r-v*s*p+i*m*p+h*s*d-i*f*d)*N,t[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*d+i*l*d)*N,t[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*p-i*l*p)*N,t[4]=E*N,t[5]=(u*m*r-_*f*r+_*s*p-e*m*p-u*s*d+e*f*d)*N,t[6]=(_*l*r-o*m*r-_*s*c+e*m*c+o*s*d-e*l*d)*N,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*p+e*l*p)*N,t[8]=M*N,t[9]=(_*h*r-u*v*r-_*i*p+e*v*p+u*i*d-e*h*d)*N,t[10]=(o*v*r-_*a*r+_*i*c-e*v*c-o*i*d+e*a*d)*N,t[11]=(u*a*r-o*h*r-u*i*c+e*h*c+o*i*p-e*a*p)*N,t[12]=D*N,t[13]=(u*v*s-_*h*s+_*i*f-e*v*f-u*i*m+e*h*m)*N,t[14]=(_*a*s-o*v*s-_*i*l+e*v*l+o*i*m-e*a*m)*N,t[15]=(o*h*s-u*a*s+u*i*l-e*h*l-o*i*f+e*a*f)*N,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,_=r*h,v=o*u,m=o*h,d=a*h,T=l*c,E=l*u,M=l*h,D=i.x,R=i.y,N=i.z;return s[0]=(1-(v+d))*D,s[1]=(p+M)*D,s[2]=(_-E)*D,s[3]=0,s[4]=(p-M)*R,s[5]=(1-(f+d))*R,s[6]=(m+T)*R,s[7]=0,s[8]=(_+E)*N,s[9]=(m-T)*N,s[10]=(1-(f+v))*N,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements,r=Vr.set(s[0],s[1],s[2]).length(),o=Vr.set(s[4],s[5],s[6]).length(),a=Vr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],xi.copy(this);let c=1/r,u=1/o,h=1/a;return xi.elements[0]*=c,xi.elements[1]*=c,xi.elements[2]*=c,xi.elements[4]*=u,xi.elements[5]*=u,xi.elements[6]*=u,xi.elements[8]*=h,xi.elements[9]*=h,xi.elements[10]*=h,e.setFromRotationMatrix(xi),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=Si,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),f=(e+t)/(e-t),p=(i+s)/(i-s),_,v;if(l)_=r/(o-r),v=o*r/(o-r);else if(a===Si)_=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Qo)_=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Si,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),f=-(e+t)/(e-t),p=-(i+s)/(i-s),_,v;if(l)_=1/(o-r),v=o/(o-r);else if(a===Si)_=-2/(o-r),v=-(o+r)/(o-r);else if(a===Qo)_=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=_,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Vr=new z,xi=new We,wy=new z(0,0,0),Ty=new z(1,1,1),Ms=new z,fl=new z,Kn=new z,Dm=new We,Lm=new Vn,Ti=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(ae(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ae(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(ae(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ae(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ae(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-ae(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Dm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Dm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Lm.setFromEuler(this),this.setFromQuaternion(Lm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ti.DEFAULT_ORDER="XYZ";var so=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Ey=0,Um=new z,Hr=new Vn,Ki=new We,dl=new z,Go=new z,Ay=new z,Cy=new Vn,Nm=new z(1,0,0),Fm=new z(0,1,0),Om=new z(0,0,1),Bm={type:"added"},Ry={type:"removed"},Gr={type:"childadded",child:null},Cu={type:"childremoved",child:null},gn=class n extends Fi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ey++}),this.uuid=es(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new z,e=new Ti,i=new Vn,s=new z(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new We},normalMatrix:{value:new ie}}),this.matrix=new We,this.matrixWorld=new We,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new so,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Hr.setFromAxisAngle(t,e),this.quaternion.multiply(Hr),this}rotateOnWorldAxis(t,e){return Hr.setFromAxisAngle(t,e),this.quaternion.premultiply(Hr),this}rotateX(t){return this.rotateOnAxis(Nm,t)}rotateY(t){return this.rotateOnAxis(Fm,t)}rotateZ(t){return this.rotateOnAxis(Om,t)}translateOnAxis(t,e){return Um.copy(t).applyQuaternion(this.quaternion),this.position.add(Um.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Nm,t)}translateY(t){return this.translateOnAxis(Fm,t)}translateZ(t){return this.translateOnAxis(Om,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ki.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?dl.copy(t):dl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Go.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ki.lookAt(Go,dl,this.up):Ki.lookAt(dl,Go,this.up),this.quaternion.setFromRotationMatrix(Ki),s&&(Ki.extractRotation(s.matrixWorld),Hr.setFromRotationMatrix(Ki),this.quaternion.premultiply(Hr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Bm),Gr.child=t,this.dispatchEvent(Gr),Gr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Ry),Cu.child=t,this.dispatchEvent(Cu),Cu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ki.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ki.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ki),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Bm),Gr.child=t,this.dispatchEvent(Gr),Gr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Go,t,Ay),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Go,Cy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),p=o(t.animations),_=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}};gn.DEFAULT_UP=new z(0,1,0);gn.DEFAULT_MATRIX_AUTO_UPDATE=!0;gn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var yi=new z,ji=new z,Ru=new z,Qi=new z,Wr=new z,Xr=new z,km=new z,Pu=new z,Iu=new z,Du=new z,Lu=new Ze,Uu=new Ze,Nu=new Ze,ts=class n{constructor(t=new z,e=new z,i=new z){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),yi.subVectors(t,e),s.cross(yi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){yi.subVectors(s,e),ji.subVectors(i,e),Ru.subVectors(t,e);let o=yi.dot(yi),a=yi.dot(ji),l=yi.dot(Ru),c=ji.dot(ji),u=ji.dot(Ru),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,p=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-p-_,_,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Qi)===null?!1:Qi.x>=0&&Qi.y>=0&&Qi.x+Qi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Qi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Qi.x),l.addScaledVector(o,Qi.y),l.addScaledVector(a,Qi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Lu.setScalar(0),Uu.setScalar(0),Nu.setScalar(0),Lu.fromBufferAttribute(t,e),Uu.fromBufferAttribute(t,i),Nu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Lu,r.x),o.addScaledVector(Uu,r.y),o.addScaledVector(Nu,r.z),o}static isFrontFacing(t,e,i,s){return yi.subVectors(i,e),ji.subVectors(t,e),yi.cross(ji).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return yi.subVectors(this.c,this.b),ji.subVectors(this.a,this.b),yi.cross(ji).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Wr.subVectors(s,i),Xr.subVectors(r,i),Pu.subVectors(t,i);let l=Wr.dot(Pu),c=Xr.dot(Pu);if(l<=0&&c<=0)return e.copy(i);Iu.subVectors(t,s);let u=Wr.dot(Iu),h=Xr.dot(Iu);if(u>=0&&h<=u)return e.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(i).addScaledVector(Wr,o);Du.subVectors(t,r);let p=Wr.dot(Du),_=Xr.dot(Du);if(_>=0&&p<=_)return e.copy(r);let v=p*c-l*_;if(v<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(i).addScaledVector(Xr,a);let m=u*_-p*h;if(m<=0&&h-u>=0&&p-_>=0)return km.subVectors(r,s),a=(h-u)/(h-u+(p-_)),e.copy(s).addScaledVector(km,a);let d=1/(m+v+f);return o=v*d,a=f*d,e.copy(i).addScaledVector(Wr,o).addScaledVector(Xr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},qg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ss={h:0,s:0,l:0},pl={h:0,s:0,l:0};function Fu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var se=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=xn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,fe.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=fe.workingColorSpace){return this.r=t,this.g=e,this.b=i,fe.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=fe.workingColorSpace){if(t=gf(t,1),e=ae(e,0,1),i=ae(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Fu(o,r,t+1/3),this.g=Fu(o,r,t),this.b=Fu(o,r,t-1/3)}return fe.colorSpaceToWorking(this,s),this}setStyle(t,e=xn){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=xn){let i=qg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ns(t.r),this.g=ns(t.g),this.b=ns(t.b),this}copyLinearToSRGB(t){return this.r=Qr(t.r),this.g=Qr(t.g),this.b=Qr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=xn){return fe.workingToColorSpace(Tn.copy(this),t),Math.round(ae(Tn.r*255,0,255))*65536+Math.round(ae(Tn.g*255,0,255))*256+Math.round(ae(Tn.b*255,0,255))}getHexString(t=xn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=fe.workingColorSpace){fe.workingToColorSpace(Tn.copy(this),e);let i=Tn.r,s=Tn.g,r=Tn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=fe.workingColorSpace){return fe.workingToColorSpace(Tn.copy(this),e),t.r=Tn.r,t.g=Tn.g,t.b=Tn.b,t}getStyle(t=xn){fe.workingToColorSpace(Tn.copy(this),t);let e=Tn.r,i=Tn.g,s=Tn.b;return t!==xn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ss),this.setHSL(Ss.h+t,Ss.s+e,Ss.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ss),t.getHSL(pl);let i=Jo(Ss.h,pl.h,e),s=Jo(Ss.s,pl.s,e),r=Jo(Ss.l,pl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Tn=new se;se.NAMES=qg;var Py=0,Ei=class extends Fi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Py++}),this.uuid=es(),this.name="",this.type="Material",this.blending=Ks,this.side=bi,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ll,this.blendDst=Ul,this.blendEquation=Ts,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new se(0,0,0),this.blendAlpha=0,this.depthFunc=js,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=qu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Js,this.stencilZFail=Js,this.stencilZPass=Js,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Ks&&(i.blending=this.blending),this.side!==bi&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==Ll&&(i.blendSrc=this.blendSrc),this.blendDst!==Ul&&(i.blendDst=this.blendDst),this.blendEquation!==Ts&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==js&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==qu&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Js&&(i.stencilFail=this.stencilFail),this.stencilZFail!==Js&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==Js&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}},na=class extends Ei{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new se(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ti,this.combine=dc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}};var Qe=new z,ml=new qt,Iy=0,Ye=class{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Iy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Bl,this.updateRanges=[],this.gpuType=Vi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)ml.fromBufferAttribute(this,e),ml.applyMatrix3(t),this.setXY(e,ml.x,ml.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Qe.fromBufferAttribute(this,e),Qe.applyMatrix3(t),this.setXYZ(e,Qe.x,Qe.y,Qe.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Qe.fromBufferAttribute(this,e),Qe.applyMatrix4(t),this.setXYZ(e,Qe.x,Qe.y,Qe.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Qe.fromBufferAttribute(this,e),Qe.applyNormalMatrix(t),this.setXYZ(e,Qe.x,Qe.y,Qe.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Qe.fromBufferAttribute(this,e),Qe.transformDirection(t),this.setXYZ(e,Qe.x,Qe.y,Qe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=Mi(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Ae(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Mi(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ae(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Mi(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ae(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Mi(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ae(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Mi(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ae(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Ae(e,this.array),i=Ae(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Ae(e,this.array),i=Ae(i,this.array),s=Ae(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Ae(e,this.array),i=Ae(i,this.array),s=Ae(s,this.array),r=Ae(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Bl&&(t.usage=this.usage),t}};var ia=class extends Ye{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var sa=class extends Ye{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var zn=class extends Ye{constructor(t,e,i){super(new Float32Array(t),e,i)}},Dy=0,oi=new We,Ou=new gn,qr=new z,jn=new Bi,Wo=new Bi,mn=new z,tn=class n extends Fi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Dy++}),this.uuid=es(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(vf(t)?sa:ia)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ie().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return oi.makeRotationFromQuaternion(t),this.applyMatrix4(oi),this}rotateX(t){return oi.makeRotationX(t),this.applyMatrix4(oi),this}rotateY(t){return oi.makeRotationY(t),this.applyMatrix4(oi),this}rotateZ(t){return oi.makeRotationZ(t),this.applyMatrix4(oi),this}translate(t,e,i){return oi.makeTranslation(t,e,i),this.applyMatrix4(oi),this}scale(t,e,i){return oi.makeScale(t,e,i),this.applyMatrix4(oi),this}lookAt(t){return Ou.lookAt(t),Ou.updateMatrix(),this.applyMatrix4(Ou.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(qr).negate(),this.translate(qr.x,qr.y,qr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new zn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Bi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];jn.setFromBufferAttribute(r),this.morphTargetsRelative?(mn.addVectors(this.boundingBox.min,jn.min),this.boundingBox.expandByPoint(mn),mn.addVectors(this.boundingBox.max,jn.max),this.boundingBox.expandByPoint(mn)):(this.boundingBox.expandByPoint(jn.min),this.boundingBox.expandByPoint(jn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Es);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){let i=this.boundingSphere.center;if(jn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Wo.setFromBufferAttribute(a),this.morphTargetsRelative?(mn.addVectors(jn.min,Wo.min),jn.expandByPoint(mn),mn.addVectors(jn.max,Wo.max),jn.expandByPoint(mn)):(jn.expandByPoint(Wo.min),jn.expandByPoint(Wo.max))}jn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)mn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(mn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)mn.fromBufferAttribute(a,c),l&&(qr.fromBufferAttribute(t,c),mn.add(qr)),s=Math.max(s,i.distanceToSquared(mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Ye(new Float32Array(4*i.count),4));let o=this.getAttribute("tangent"),a=[],l=[];for(let B=0;B<i.count;B++)a[B]=new z,l[B]=new z;let c=new z,u=new z,h=new z,f=new qt,p=new qt,_=new qt,v=new z,m=new z;function d(B,w,b){c.fromBufferAttribute(i,B),u.fromBufferAttribute(i,w),h.fromBufferAttribute(i,b),f.fromBufferAttribute(r,B),p.fromBufferAttribute(r,w),_.fromBufferAttribute(r,b),u.sub(c),h.sub(c),p.sub(f),_.sub(f);let C=1/(p.x*_.y-_.x*p.y);isFinite(C)&&(v.copy(u).multiplyScalar(_.y).addScaledVector(h,-p.y).multiplyScalar(C),m.copy(h).multiplyScalar(p.x).addScaledVector(u,-_.x).multiplyScalar(C),a[B].add(v),a[w].add(v),a[b].add(v),l[B].add(m),l[w].add(m),l[b].add(m))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let B=0,w=T.length;B<w;++B){let b=T[B],C=b.start,G=b.count;for(let H=C,q=C+G;H<q;H+=3)d(t.getX(H+0),t.getX(H+1),t.getX(H+2))}let E=new z,M=new z,D=new z,R=new z;function N(B){D.fromBufferAttribute(s,B),R.copy(D);let w=a[B];E.copy(w),E.sub(D.multiplyScalar(D.dot(w))).normalize(),M.crossVectors(R,w);let C=M.dot(l[B])<0?-1:1;o.setXYZW(B,E.x,E.y,E.z,C)}for(let B=0,w=T.length;B<w;++B){let b=T[B],C=b.start,G=b.count;for(let H=C,q=C+G;H<q;H+=3)N(t.getX(H+0)),N(t.getX(H+1)),N(t.getX(H+2))}}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Ye(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,p=t.count;f<p;f+=3){let _=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=e.count;f<p;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)mn.fromBufferAttribute(t,e),mn.normalize(),t.setXYZ(e,mn.x,mn.y,mn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),p=0,_=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?p=l[v]*a.data.stride+a.offset:p=l[v]*u;for(let d=0;d<u;d++)f[_++]=c[p++]}return new Ye(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],p=t(f,i);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let p=c[h];u.push(p.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}},zm=new We,Zs=new is,gl=new Es,Vm=new z,_l=new z,vl=new z,xl=new z,Bu=new z,yl=new z,Hm=new z,Ml=new z,yn=class extends gn{constructor(t=new tn,e=new na){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){yl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Bu.fromBufferAttribute(h,t),o?yl.addScaledVector(Bu,u):yl.addScaledVector(Bu.sub(e),u))}e.add(yl)}return e}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),gl.copy(i.boundingSphere),gl.applyMatrix4(r),Zs.copy(t.ray).recast(t.near),!(gl.containsPoint(Zs.origin)===!1&&(Zs.intersectSphere(gl,Vm)===null||Zs.origin.distanceToSquared(Vm)>(t.far-t.near)**2))&&(zm.copy(r).invert(),Zs.copy(t.ray).applyMatrix4(zm),!(i.boundingBox!==null&&Zs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Zs)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){let m=f[_],d=o[m.materialIndex],T=Math.max(m.start,p.start),E=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let M=T,D=E;M<D;M+=3){let R=a.getX(M),N=a.getX(M+1),B=a.getX(M+2);s=Sl(this,d,t,i,c,u,h,R,N,B),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let _=Math.max(0,p.start),v=Math.min(a.count,p.start+p.count);for(let m=_,d=v;m<d;m+=3){let T=a.getX(m),E=a.getX(m+1),M=a.getX(m+2);s=Sl(this,o,t,i,c,u,h,T,E,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,v=f.length;_<v;_++){let m=f[_],d=o[m.materialIndex],T=Math.max(m.start,p.start),E=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let M=T,D=E;M<D;M+=3){let R=M,N=M+1,B=M+2;s=Sl(this,d,t,i,c,u,h,R,N,B),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let _=Math.max(0,p.start),v=Math.min(l.count,p.start+p.count);for(let m=_,d=v;m<d;m+=3){let T=m,E=m+1,M=m+2;s=Sl(this,o,t,i,c,u,h,T,E,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Ly(n,t,e,i,s,r,o,a){let l;if(t.side===Mn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===bi,a),l===null)return null;Ml.copy(a),Ml.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ml);return c<e.near||c>e.far?null:{distance:c,point:Ml.clone(),object:n}}function Sl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,_l),n.getVertexPosition(l,vl),n.getVertexPosition(c,xl);let u=Ly(n,t,e,i,_l,vl,xl,Hm);if(u){let h=new z;ts.getBarycoord(Hm,_l,vl,xl,h),s&&(u.uv=ts.getInterpolatedAttribute(s,a,l,c,h,new qt)),r&&(u.uv1=ts.getInterpolatedAttribute(r,a,l,c,h,new qt)),o&&(u.normal=ts.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new z,materialIndex:0};ts.getNormal(_l,vl,xl,f.normal),u.face=f,u.barycoord=h}return u}var ro=class n extends tn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,p=0;_("z","y","x",-1,-1,i,e,t,o,r,0),_("z","y","x",1,-1,i,e,-t,o,r,1),_("x","z","y",1,1,t,i,e,s,o,2),_("x","z","y",1,-1,t,i,-e,s,o,3),_("x","y","z",1,-1,t,e,i,s,r,4),_("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new zn(c,3)),this.setAttribute("normal",new zn(u,3)),this.setAttribute("uv",new zn(h,2));function _(v,m,d,T,E,M,D,R,N,B,w){let b=M/N,C=D/B,G=M/2,H=D/2,q=R/2,X=N+1,Z=B+1,J=0,Q=0,ot=new z;for(let at=0;at<Z;at++){let vt=at*C-H;for(let yt=0;yt<X;yt++){let mt=yt*b-G;ot[v]=mt*T,ot[m]=vt*E,ot[d]=q,c.push(ot.x,ot.y,ot.z),ot[v]=0,ot[m]=0,ot[d]=R>0?1:-1,u.push(ot.x,ot.y,ot.z),h.push(yt/N),h.push(1-at/B),J+=1}}for(let at=0;at<B;at++)for(let vt=0;vt<N;vt++){let yt=f+vt+X*at,mt=f+vt+X*(at+1),Qt=f+(vt+1)+X*(at+1),Yt=f+(vt+1)+X*at;l.push(yt,mt,Yt),l.push(mt,Qt,Yt),Q+=6}a.addGroup(p,Q,w),p+=Q,f+=J}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};function sr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function An(n){let t={};for(let e=0;e<n.length;e++){let i=sr(n[e]);for(let s in i)t[s]=i[s]}return t}function Uy(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function xf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:fe.workingColorSpace}var Yg={clone:sr,merge:An},Ny=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Fy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ai=class extends Ei{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ny,this.fragmentShader=Fy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=sr(t.uniforms),this.uniformsGroups=Uy(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}},ra=class extends gn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new We,this.projectionMatrix=new We,this.projectionMatrixInverse=new We,this.coordinateSystem=Si,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}},bs=new z,Gm=new qt,Wm=new qt,En=class extends ra{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=eo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan($o*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return eo*2*Math.atan(Math.tan($o*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){bs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(bs.x,bs.y).multiplyScalar(-t/bs.z),bs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(bs.x,bs.y).multiplyScalar(-t/bs.z)}getViewSize(t,e){return this.getViewBounds(t,Gm,Wm),e.subVectors(Wm,Gm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan($o*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}},Yr=-90,Zr=1,Hl=class extends gn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new En(Yr,Zr,t,e);s.layers=this.layers,this.add(s);let r=new En(Yr,Zr,t,e);r.layers=this.layers,this.add(r);let o=new En(Yr,Zr,t,e);o.layers=this.layers,this.add(o);let a=new En(Yr,Zr,t,e);a.layers=this.layers,this.add(a);let l=new En(Yr,Zr,t,e);l.layers=this.layers,this.add(l);let c=new En(Yr,Zr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Si)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Qo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;let v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=v,t.setRenderTarget(i,5,s),t.render(e,u),t.setRenderTarget(h,f,p),t.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},oa=class extends Hn{constructor(t=[],e=nr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}},Gl=class extends Oi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new oa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ro(5,5,5),r=new Ai({name:"CubemapFromEquirect",uniforms:sr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Mn,blending:rs});r.uniforms.tEquirect.value=e;let o=new yn(s,r),a=e.minFilter;return e.minFilter===Ds&&(e.minFilter=wi),new Hl(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},kn=class extends gn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Oy={type:"move"},oo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let v of t.hand.values()){let m=e.getJointPose(v,i),d=this._getHandJoint(c,v);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,_=.005;c.inputState.pinching&&f>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Oy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new kn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}};var aa=class extends gn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ti,this.environmentIntensity=1,this.environmentRotation=new Ti,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}},Wl=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=Bl,this.updateRanges=[],this.version=0,this.uuid=es()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=es()),t.arrayBuffers[this.array.buffer._uuid]===void 0&&(t.arrayBuffers[this.array.buffer._uuid]=this.array.slice(0).buffer);let e=new this.array.constructor(t.arrayBuffers[this.array.buffer._uuid]),i=new this.constructor(e,this.stride);return i.setUsage(this.usage),i}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){return t.arrayBuffers===void 0&&(t.arrayBuffers={}),this.array.buffer._uuid===void 0&&(this.array.buffer._uuid=es()),t.arrayBuffers[this.array.buffer._uuid]===void 0&&(t.arrayBuffers[this.array.buffer._uuid]=Array.from(new Uint32Array(this.array.buffer))),{uuid:this.uuid,buffer:this.array.buffer._uuid,type:this.array.constructor.name,stride:this.stride}}},Nn=new z,la=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)Nn.fromBufferAttribute(this,e),Nn.applyMatrix4(t),this.setXYZ(e,Nn.x,Nn.y,Nn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Nn.fromBufferAttribute(this,e),Nn.applyNormalMatrix(t),this.setXYZ(e,Nn.x,Nn.y,Nn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Nn.fromBufferAttribute(this,e),Nn.transformDirection(t),this.setXYZ(e,Nn.x,Nn.y,Nn.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=Mi(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Ae(i,this.array)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=Ae(e,this.array)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=Ae(e,this.array)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=Ae(e,this.array)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=Ae(e,this.array)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=Mi(e,this.array)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=Mi(e,this.array)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=Mi(e,this.array)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=Mi(e,this.array)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ae(e,this.array),i=Ae(i,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ae(e,this.array),i=Ae(i,this.array),s=Ae(s,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=Ae(e,this.array),i=Ae(i,this.array),s=Ae(s,this.array),r=Ae(r,this.array)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){console.log("THREE.InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ye(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){console.log("THREE.InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}},ao=class extends Ei{constructor(t){super(),this.isSpriteMaterial=!0,this.type="SpriteMaterial",this.color=new se(16777215),this.map=null,this.alphaMap=null,this.rotation=0,this.sizeAttenuation=!0,this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.rotation=t.rotation,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},$r,Xo=new z,Jr=new z,Kr=new z,jr=new qt,qo=new qt,Zg=new We,bl=new z,Yo=new z,wl=new z,Xm=new qt,ku=new qt,qm=new qt,ca=class extends gn{constructor(t=new ao){if(super(),this.isSprite=!0,this.type="Sprite",$r===void 0){$r=new tn;let e=new Float32Array([-.5,-.5,0,0,0,.5,-.5,0,1,0,.5,.5,0,1,1,-.5,.5,0,0,1]),i=new Wl(e,5);$r.setIndex([0,1,2,0,2,3]),$r.setAttribute("position",new la(i,3,0,!1)),$r.setAttribute("uv",new la(i,2,3,!1))}this.geometry=$r,this.material=t,this.center=new qt(.5,.5),this.count=1}raycast(t,e){t.camera===null&&console.error('THREE.Sprite: "Raycaster.camera" needs to be set in order to raycast against sprites.'),Jr.setFromMatrixScale(this.matrixWorld),Zg.copy(t.camera.matrixWorld),this.modelViewMatrix.multiplyMatrices(t.camera.matrixWorldInverse,this.matrixWorld),Kr.setFromMatrixPosition(this.modelViewMatrix),t.camera.isPerspectiveCamera&&this.material.sizeAttenuation===!1&&Jr.multiplyScalar(-Kr.z);let i=this.material.rotation,s,r;i!==0&&(r=Math.cos(i),s=Math.sin(i));let o=this.center;Tl(bl.set(-.5,-.5,0),Kr,o,Jr,s,r),Tl(Yo.set(.5,-.5,0),Kr,o,Jr,s,r),Tl(wl.set(.5,.5,0),Kr,o,Jr,s,r),Xm.set(0,0),ku.set(1,0),qm.set(1,1);let a=t.ray.intersectTriangle(bl,Yo,wl,!1,Xo);if(a===null&&(Tl(Yo.set(-.5,.5,0),Kr,o,Jr,s,r),ku.set(0,1),a=t.ray.intersectTriangle(bl,wl,Yo,!1,Xo),a===null))return;let l=t.ray.origin.distanceTo(Xo);l<t.near||l>t.far||e.push({distance:l,point:Xo.clone(),uv:ts.getInterpolation(Xo,bl,Yo,wl,Xm,ku,qm,new qt),face:null,object:this})}copy(t,e){return super.copy(t,e),t.center!==void 0&&this.center.copy(t.center),this.material=t.material,this}};function Tl(n,t,e,i,s,r){jr.subVectors(n,e).addScalar(.5).multiply(i),s!==void 0?(qo.x=r*jr.x-s*jr.y,qo.y=s*jr.x+r*jr.y):qo.copy(jr),n.copy(t),n.x+=qo.x,n.y+=qo.y,n.applyMatrix4(Zg)}var zu=new z,By=new z,ky=new ie,ai=class{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=zu.subVectors(i,e).cross(By.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){let i=t.delta(zu),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||ky.getNormalMatrix(t),s=this.coplanarPoint(zu).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}},$s=new Es,zy=new qt(.5,.5),El=new z,lo=class{constructor(t=new ai,e=new ai,i=new ai,s=new ai,r=new ai,o=new ai){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Si,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],_=r[8],v=r[9],m=r[10],d=r[11],T=r[12],E=r[13],M=r[14],D=r[15];if(s[0].setComponents(c-o,p-u,d-_,D-T).normalize(),s[1].setComponents(c+o,p+u,d+_,D+T).normalize(),s[2].setComponents(c+a,p+h,d+v,D+E).normalize(),s[3].setComponents(c-a,p-h,d-v,D-E).normalize(),i)s[4].setComponents(l,f,m,M).normalize(),s[5].setComponents(c-l,p-f,d-m,D-M).normalize();else if(s[4].setComponents(c-l,p-f,d-m,D-M).normalize(),e===Si)s[5].setComponents(c+l,p+f,d+m,D+M).normalize();else if(e===Qo)s[5].setComponents(l,f,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),$s.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),$s.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere($s)}intersectsSprite(t){$s.center.set(0,0,0);let e=zy.distanceTo(t.center);return $s.radius=.7071067811865476+e,$s.applyMatrix4(t.matrixWorld),this.intersectsSphere($s)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(El.x=s.normal.x>0?t.max.x:t.min.x,El.y=s.normal.y>0?t.max.y:t.min.y,El.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(El)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}};var ss=class extends Ei{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new se(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Xl=new z,ql=new z,Ym=new We,Zo=new is,Al=new Es,Vu=new z,Zm=new z,Yl=class extends gn{constructor(t=new tn,e=new ss){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Xl.fromBufferAttribute(e,s-1),ql.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Xl.distanceTo(ql);t.setAttribute("lineDistance",new zn(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Al.copy(i.boundingSphere),Al.applyMatrix4(s),Al.radius+=r,t.ray.intersectsSphere(Al)===!1)return;Ym.copy(s).invert(),Zo.copy(t.ray).applyMatrix4(Ym);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let v=p,m=_-1;v<m;v+=c){let d=u.getX(v),T=u.getX(v+1),E=Cl(this,t,Zo,l,d,T,v);E&&e.push(E)}if(this.isLineLoop){let v=u.getX(_-1),m=u.getX(p),d=Cl(this,t,Zo,l,v,m,_-1);d&&e.push(d)}}else{let p=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let v=p,m=_-1;v<m;v+=c){let d=Cl(this,t,Zo,l,v,v+1,v);d&&e.push(d)}if(this.isLineLoop){let v=Cl(this,t,Zo,l,_-1,p,_-1);v&&e.push(v)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Cl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Xl.fromBufferAttribute(a,s),ql.fromBufferAttribute(a,r),e.distanceSqToSegment(Xl,ql,Vu,Zm)>i)return;Vu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Vu);if(!(c<t.near||c>t.far))return{distance:c,point:Zm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var $m=new z,Jm=new z,As=class extends Yl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)$m.fromBufferAttribute(e,s),Jm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+$m.distanceTo(Jm);t.setAttribute("lineDistance",new zn(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var co=class extends Ei{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new se(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},Km=new We,Yu=new is,Rl=new Es,Pl=new z,ha=class extends gn{constructor(t=new tn,e=new co){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Rl.copy(i.boundingSphere),Rl.applyMatrix4(s),Rl.radius+=r,t.ray.intersectsSphere(Rl)===!1)return;Km.copy(s).invert(),Yu.copy(t.ray).applyMatrix4(Km);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){let f=Math.max(0,o.start),p=Math.min(c.count,o.start+o.count);for(let _=f,v=p;_<v;_++){let m=c.getX(_);Pl.fromBufferAttribute(h,m),jm(Pl,m,l,s,t,e,this)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=f,v=p;_<v;_++)Pl.fromBufferAttribute(h,_),jm(Pl,_,l,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function jm(n,t,e,i,s,r,o){let a=Yu.distanceSqToPoint(n);if(a<e){let l=new z;Yu.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var tr=class extends Hn{constructor(t,e,i,s,r,o,a,l,c){super(t,e,i,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}},ua=class extends Hn{constructor(t,e,i=Ls,s,r,o,a=li,l=li,c,u=to,h=1){if(u!==to&&u!==mo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new io(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}},fa=class extends Hn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}};var da=class n extends tn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,p=[],_=[],v=[],m=[];for(let d=0;d<u;d++){let T=d*f-o;for(let E=0;E<c;E++){let M=E*h-r;_.push(M,-T,0),v.push(0,0,1),m.push(E/a),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let T=0;T<a;T++){let E=T+c*d,M=T+c*(d+1),D=T+1+c*(d+1),R=T+1+c*d;p.push(E,M,R),p.push(M,D,R)}this.setIndex(p),this.setAttribute("position",new zn(_,3)),this.setAttribute("normal",new zn(v,3)),this.setAttribute("uv",new zn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var ki=class extends Ei{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new se(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new se(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=df,this.normalScale=new qt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ti,this.combine=dc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Zl=class extends Ei{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ug,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},$l=class extends Ei{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Il(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Vy(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}var er=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("call to abstract method")}intervalChanged_(){}},Jl=class extends er{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gu,endingEnd:Gu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Wu:r=t,a=2*e-i;break;case Xu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Wu:o=t,l=2*i-e;break;case Xu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,p=this._weightNext,_=(i-e)/(s-e),v=_*_,m=v*_,d=-f*m+2*f*v-f*_,T=(1+f)*m+(-1.5-2*f)*v+(-.5+f)*_+1,E=(-1-p)*m+(1.5+p)*v+.5*_,M=p*m-p*v;for(let D=0;D!==a;++D)r[D]=d*o[u+D]+T*o[c+D]+E*o[l+D]+M*o[h+D];return r}},Kl=class extends er{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},jl=class extends er{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Qn=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Il(e,this.TimeBufferType),this.values=Il(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Il(t.times,Array),values:Il(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s)}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new jl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Kl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Jl(this.times,this.values,this.getValueSize(),t)}setInterpolation(t){let e;switch(t){case Ko:e=this.InterpolantFactoryMethodDiscrete;break;case Ol:e=this.InterpolantFactoryMethodLinear;break;case Dl:e=this.InterpolantFactoryMethodSmooth;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return console.warn("THREE.KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ko;case this.InterpolantFactoryMethodLinear:return Ol;case this.InterpolantFactoryMethodSmooth:return Dl}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(console.error("THREE.KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(console.error("THREE.KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){console.error("THREE.KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){console.error("THREE.KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Vy(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){console.error("THREE.KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Dl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,f=h-i,p=h+i;for(let _=0;_!==i;++_){let v=e[h+_];if(v!==e[f+_]||v!==e[p+_]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,f=o*i;for(let p=0;p!==i;++p)e[f+p]=e[h+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,s}};Qn.prototype.ValueTypeName="";Qn.prototype.TimeBufferType=Float32Array;Qn.prototype.ValueBufferType=Float32Array;Qn.prototype.DefaultInterpolation=Ol;var Cs=class extends Qn{constructor(t,e,i){super(t,e,i)}};Cs.prototype.ValueTypeName="bool";Cs.prototype.ValueBufferType=Array;Cs.prototype.DefaultInterpolation=Ko;Cs.prototype.InterpolantFactoryMethodLinear=void 0;Cs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ql=class extends Qn{constructor(t,e,i,s){super(t,e,i,s)}};Ql.prototype.ValueTypeName="color";var tc=class extends Qn{constructor(t,e,i,s){super(t,e,i,s)}};tc.prototype.ValueTypeName="number";var ec=class extends er{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)Vn.slerpFlat(r,0,o,c-a,o,c,l);return r}},pa=class extends Qn{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ec(this.times,this.values,this.getValueSize(),t)}};pa.prototype.ValueTypeName="quaternion";pa.prototype.InterpolantFactoryMethodSmooth=void 0;var Rs=class extends Qn{constructor(t,e,i){super(t,e,i)}};Rs.prototype.ValueTypeName="string";Rs.prototype.ValueBufferType=Array;Rs.prototype.DefaultInterpolation=Ko;Rs.prototype.InterpolantFactoryMethodLinear=void 0;Rs.prototype.InterpolantFactoryMethodSmooth=void 0;var nc=class extends Qn{constructor(t,e,i,s){super(t,e,i,s)}};nc.prototype.ValueTypeName="vector";var ic=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this.abortController=new AbortController,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let p=c[h],_=c[h+1];if(p.global&&(p.lastIndex=0),p.test(u))return _}return null},this.abort=function(){return this.abortController.abort(),this.abortController=new AbortController,this}}},$g=new ic,sc=class{constructor(t){this.manager=t!==void 0?t:$g,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={}}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}abort(){return this}};sc.DEFAULT_MATERIAL_NAME="__DEFAULT";var ma=class extends gn{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new se(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}};var Hu=new We,Qm=new z,tg=new z,Zu=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new qt(512,512),this.mapType=Ci,this.map=null,this.mapPass=null,this.matrix=new We,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new lo,this._frameExtents=new qt(1,1),this._viewportCount=1,this._viewports=[new Ze(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera,i=this.matrix;Qm.setFromMatrixPosition(t.matrixWorld),e.position.copy(Qm),tg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(tg),e.updateMatrixWorld(),Hu.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Hu,e.coordinateSystem,e.reversedDepth),e.reversedDepth?i.set(.5,0,0,.5,0,.5,0,.5,0,0,1,0,0,0,0,1):i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply(Hu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}};var ga=class extends ra{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},$u=class extends Zu{constructor(){super(new ga(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},_a=class extends ma{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(gn.DEFAULT_UP),this.updateMatrix(),this.target=new gn,this.shadow=new $u}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}},va=class extends ma{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var rc=class extends En{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}};var yf="\\[\\]\\.:\\/",Hy=new RegExp("["+yf+"]","g"),Mf="[^"+yf+"]",Gy="[^"+yf.replace("\\.","")+"]",Wy=/((?:WC+[\/:])*)/.source.replace("WC",Mf),Xy=/(WCOD+)?/.source.replace("WCOD",Gy),qy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Mf),Yy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Mf),Zy=new RegExp("^"+Wy+Xy+qy+Yy+"$"),$y=["material","materials","bones","map"],Ju=class{constructor(t,e,i){let s=i||Ge.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ge=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Hy,"")}static parseTrackName(t){let e=Zy.exec(t);if(e===null)throw new Error("PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);$y.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){console.warn("THREE.PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){console.error("THREE.PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){console.error("THREE.PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){console.error("THREE.PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){console.error("THREE.PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){console.error("THREE.PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){console.error("THREE.PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;console.error("THREE.PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){console.error("THREE.PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ge.Composite=Ju;Ge.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ge.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ge.prototype.GetterByBindingType=[Ge.prototype._getValue_direct,Ge.prototype._getValue_array,Ge.prototype._getValue_arrayElement,Ge.prototype._getValue_toArray];Ge.prototype.SetterByBindingTypeAndVersioning=[[Ge.prototype._setValue_direct,Ge.prototype._setValue_direct_setNeedsUpdate,Ge.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_array,Ge.prototype._setValue_array_setNeedsUpdate,Ge.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_arrayElement,Ge.prototype._setValue_arrayElement_setNeedsUpdate,Ge.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_fromArray,Ge.prototype._setValue_fromArray_setNeedsUpdate,Ge.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var yE=new Float32Array(1);var eg=new We,xa=class{constructor(t,e,i=0,s=1/0){this.ray=new is(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new so,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,(e.near+e.far)/(e.near-e.far)).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):console.error("THREE.Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return eg.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(eg),this}intersectObject(t,e=!0,i=[]){return Ku(t,this,i,e),i.sort(ng),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Ku(t[s],this,i,e);return i.sort(ng),i}};function ng(n,t){return n.distance-t.distance}function Ku(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Ku(r[o],t,e,!0)}}var ho=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ae(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ae(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ya=class extends As{constructor(t=10,e=10,i=4473924,s=8947848){i=new se(i),s=new se(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let f=0,p=0,_=-a;f<=e;f++,_+=o){l.push(-a,0,_,a,0,_),l.push(_,0,-a,_,0,a);let v=f===r?i:s;v.toArray(c,p),p+=3,v.toArray(c,p),p+=3,v.toArray(c,p),p+=3,v.toArray(c,p),p+=3}let u=new tn;u.setAttribute("position",new zn(l,3)),u.setAttribute("color",new zn(c,3));let h=new ss({vertexColors:!0,toneMapped:!1});super(u,h),this.type="GridHelper"}dispose(){this.geometry.dispose(),this.material.dispose()}};var Ma=class extends Fi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Sf(n,t,e,i){let s=Jy(i);switch(e){case cf:return n*t;case uf:return n*t/s.components*s.byteLength;case yc:return n*t/s.components*s.byteLength;case ff:return n*t*2/s.components*s.byteLength;case Mc:return n*t*2/s.components*s.byteLength;case hf:return n*t*3/s.components*s.byteLength;case ci:return n*t*4/s.components*s.byteLength;case Sc:return n*t*4/s.components*s.byteLength;case wa:case Ta:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ea:case Aa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case wc:case Ec:return Math.max(n,16)*Math.max(t,8)/4;case bc:case Tc:return Math.max(n,8)*Math.max(t,8)/2;case Ac:case Cc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Rc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Pc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ic:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Dc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Lc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Uc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Nc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Fc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Oc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case kc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case zc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Vc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Hc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Gc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Wc:case Xc:case qc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Yc:case Zc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case $c:case Jc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Jy(n){switch(n){case Ci:case rf:return{byteLength:1,components:1};case uo:case of:case fo:return{byteLength:2,components:1};case vc:case xc:return{byteLength:2,components:4};case Ls:case _c:case Vi:return{byteLength:4,components:1};case af:case lf:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"180"}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="180");function x0(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function jy(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((p,_)=>p.start-_.start);let f=0;for(let p=1;p<h.length;p++){let _=h[f],v=h[p];v.start<=_.start+_.count+1?_.count=Math.max(_.count,v.start+v.count-_.start):(++f,h[f]=v)}h.length=f+1;for(let p=0,_=h.length;p<_;p++){let v=h[p];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Qy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,tM=`#ifdef USE_ALPHAHASH
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
#endif`,eM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,nM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,iM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,sM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,rM=`#ifdef USE_AOMAP
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
#endif`,oM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,aM=`#ifdef USE_BATCHING
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
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,lM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,cM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,hM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,uM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,fM=`#ifdef USE_IRIDESCENCE
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
#endif`,dM=`#ifdef USE_BUMPMAP
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
#endif`,pM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,mM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,gM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,_M=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,vM=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,xM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,yM=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,MM=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,SM=`#define PI 3.141592653589793
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
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
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
} // validated`,bM=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,wM=`vec3 transformedNormal = objectNormal;
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
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,TM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,EM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,AM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,CM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,RM="gl_FragColor = linearToOutputTexel( gl_FragColor );",PM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,IM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,DM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,LM=`#ifdef USE_ENVMAP
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
#endif`,UM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,NM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,FM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,OM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,BM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,kM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,zM=`#ifdef USE_GRADIENTMAP
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
}`,VM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,HM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,GM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,WM=`uniform bool receiveShadow;
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
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
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
#endif`,XM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,qM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,YM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ZM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,$M=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,JM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
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
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
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
#endif`,KM=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
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
		vec3 iridescenceF0;
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
		float v = 0.5 / ( gv + gl );
		return saturate(v);
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
		float roughness = material.clearcoatRoughness;
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
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
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
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
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
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
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
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
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
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,jM=`
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
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
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
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,QM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,tS=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,eS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,nS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,iS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,sS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,rS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,oS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,aS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,lS=`#if defined( USE_POINTS_UV )
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
#endif`,cS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,hS=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,uS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,fS=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,dS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,pS=`#ifdef USE_MORPHTARGETS
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
#endif`,mS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,gS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,_S=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,vS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,xS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,yS=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,MS=`#ifdef USE_NORMALMAP
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
#endif`,SS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,bS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,wS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,TS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ES=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,AS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,CS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,RS=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,PS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,IS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,DS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,LS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,US=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
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
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
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
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
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
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,NS=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
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
#endif`,FS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
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
#endif`,OS=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
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
	#if NUM_POINT_LIGHT_SHADOWS > 0
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
}`,BS=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,kS=`#ifdef USE_SKINNING
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
#endif`,zS=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,VS=`#ifdef USE_SKINNING
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
#endif`,HS=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,GS=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,WS=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,XS=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,qS=`#ifdef USE_TRANSMISSION
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
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,YS=`#ifdef USE_TRANSMISSION
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
#endif`,ZS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$S=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,JS=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,KS=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,jS=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,QS=`uniform sampler2D t2D;
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
}`,tb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,eb=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,nb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ib=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sb=`#include <common>
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
}`,rb=`#if DEPTH_PACKING == 3200
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
}`,ob=`#define DISTANCE
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
}`,ab=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,lb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,cb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hb=`uniform float scale;
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
}`,ub=`uniform vec3 diffuse;
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
}`,fb=`#include <common>
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
}`,db=`uniform vec3 diffuse;
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
}`,pb=`#define LAMBERT
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
}`,mb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
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
}`,gb=`#define MATCAP
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
}`,_b=`#define MATCAP
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
}`,vb=`#define NORMAL
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
}`,xb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
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
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,yb=`#define PHONG
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
}`,Mb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
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
}`,Sb=`#define STANDARD
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
}`,bb=`#define STANDARD
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
#ifdef USE_DISPERSION
	uniform float dispersion;
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
#include <packing>
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
#include <cube_uv_reflection_fragment>
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
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
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
}`,wb=`#define TOON
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
}`,Tb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
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
}`,Eb=`uniform float size;
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
}`,Ab=`uniform vec3 diffuse;
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
}`,Cb=`#include <common>
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
}`,Rb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
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
}`,Pb=`uniform float rotation;
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
}`,Ib=`uniform vec3 diffuse;
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
}`,oe={alphahash_fragment:Qy,alphahash_pars_fragment:tM,alphamap_fragment:eM,alphamap_pars_fragment:nM,alphatest_fragment:iM,alphatest_pars_fragment:sM,aomap_fragment:rM,aomap_pars_fragment:oM,batching_pars_vertex:aM,batching_vertex:lM,begin_vertex:cM,beginnormal_vertex:hM,bsdfs:uM,iridescence_fragment:fM,bumpmap_pars_fragment:dM,clipping_planes_fragment:pM,clipping_planes_pars_fragment:mM,clipping_planes_pars_vertex:gM,clipping_planes_vertex:_M,color_fragment:vM,color_pars_fragment:xM,color_pars_vertex:yM,color_vertex:MM,common:SM,cube_uv_reflection_fragment:bM,defaultnormal_vertex:wM,displacementmap_pars_vertex:TM,displacementmap_vertex:EM,emissivemap_fragment:AM,emissivemap_pars_fragment:CM,colorspace_fragment:RM,colorspace_pars_fragment:PM,envmap_fragment:IM,envmap_common_pars_fragment:DM,envmap_pars_fragment:LM,envmap_pars_vertex:UM,envmap_physical_pars_fragment:XM,envmap_vertex:NM,fog_vertex:FM,fog_pars_vertex:OM,fog_fragment:BM,fog_pars_fragment:kM,gradientmap_pars_fragment:zM,lightmap_pars_fragment:VM,lights_lambert_fragment:HM,lights_lambert_pars_fragment:GM,lights_pars_begin:WM,lights_toon_fragment:qM,lights_toon_pars_fragment:YM,lights_phong_fragment:ZM,lights_phong_pars_fragment:$M,lights_physical_fragment:JM,lights_physical_pars_fragment:KM,lights_fragment_begin:jM,lights_fragment_maps:QM,lights_fragment_end:tS,logdepthbuf_fragment:eS,logdepthbuf_pars_fragment:nS,logdepthbuf_pars_vertex:iS,logdepthbuf_vertex:sS,map_fragment:rS,map_pars_fragment:oS,map_particle_fragment:aS,map_particle_pars_fragment:lS,metalnessmap_fragment:cS,metalnessmap_pars_fragment:hS,morphinstance_vertex:uS,morphcolor_vertex:fS,morphnormal_vertex:dS,morphtarget_pars_vertex:pS,morphtarget_vertex:mS,normal_fragment_begin:gS,normal_fragment_maps:_S,normal_pars_fragment:vS,normal_pars_vertex:xS,normal_vertex:yS,normalmap_pars_fragment:MS,clearcoat_normal_fragment_begin:SS,clearcoat_normal_fragment_maps:bS,clearcoat_pars_fragment:wS,iridescence_pars_fragment:TS,opaque_fragment:ES,packing:AS,premultiplied_alpha_fragment:CS,project_vertex:RS,dithering_fragment:PS,dithering_pars_fragment:IS,roughnessmap_fragment:DS,roughnessmap_pars_fragment:LS,shadowmap_pars_fragment:US,shadowmap_pars_vertex:NS,shadowmap_vertex:FS,shadowmask_pars_fragment:OS,skinbase_vertex:BS,skinning_pars_vertex:kS,skinning_vertex:zS,skinnormal_vertex:VS,specularmap_fragment:HS,specularmap_pars_fragment:GS,tonemapping_fragment:WS,tonemapping_pars_fragment:XS,transmission_fragment:qS,transmission_pars_fragment:YS,uv_pars_fragment:ZS,uv_pars_vertex:$S,uv_vertex:JS,worldpos_vertex:KS,background_vert:jS,background_frag:QS,backgroundCube_vert:tb,backgroundCube_frag:eb,cube_vert:nb,cube_frag:ib,depth_vert:sb,depth_frag:rb,distanceRGBA_vert:ob,distanceRGBA_frag:ab,equirect_vert:lb,equirect_frag:cb,linedashed_vert:hb,linedashed_frag:ub,meshbasic_vert:fb,meshbasic_frag:db,meshlambert_vert:pb,meshlambert_frag:mb,meshmatcap_vert:gb,meshmatcap_frag:_b,meshnormal_vert:vb,meshnormal_frag:xb,meshphong_vert:yb,meshphong_frag:Mb,meshphysical_vert:Sb,meshphysical_frag:bb,meshtoon_vert:wb,meshtoon_frag:Tb,points_vert:Eb,points_frag:Ab,shadow_vert:Cb,shadow_frag:Rb,sprite_vert:Pb,sprite_frag:Ib},wt={common:{diffuse:{value:new se(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new qt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new se(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new se(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new se(16777215)},opacity:{value:1},center:{value:new qt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},Hi={basic:{uniforms:An([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.fog]),vertexShader:oe.meshbasic_vert,fragmentShader:oe.meshbasic_frag},lambert:{uniforms:An([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,wt.lights,{emissive:{value:new se(0)}}]),vertexShader:oe.meshlambert_vert,fragmentShader:oe.meshlambert_frag},phong:{uniforms:An([wt.common,wt.specularmap,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,wt.lights,{emissive:{value:new se(0)},specular:{value:new se(1118481)},shininess:{value:30}}]),vertexShader:oe.meshphong_vert,fragmentShader:oe.meshphong_frag},standard:{uniforms:An([wt.common,wt.envmap,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.roughnessmap,wt.metalnessmap,wt.fog,wt.lights,{emissive:{value:new se(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:oe.meshphysical_vert,fragmentShader:oe.meshphysical_frag},toon:{uniforms:An([wt.common,wt.aomap,wt.lightmap,wt.emissivemap,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.gradientmap,wt.fog,wt.lights,{emissive:{value:new se(0)}}]),vertexShader:oe.meshtoon_vert,fragmentShader:oe.meshtoon_frag},matcap:{uniforms:An([wt.common,wt.bumpmap,wt.normalmap,wt.displacementmap,wt.fog,{matcap:{value:null}}]),vertexShader:oe.meshmatcap_vert,fragmentShader:oe.meshmatcap_frag},points:{uniforms:An([wt.points,wt.fog]),vertexShader:oe.points_vert,fragmentShader:oe.points_frag},dashed:{uniforms:An([wt.common,wt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:oe.linedashed_vert,fragmentShader:oe.linedashed_frag},depth:{uniforms:An([wt.common,wt.displacementmap]),vertexShader:oe.depth_vert,fragmentShader:oe.depth_frag},normal:{uniforms:An([wt.common,wt.bumpmap,wt.normalmap,wt.displacementmap,{opacity:{value:1}}]),vertexShader:oe.meshnormal_vert,fragmentShader:oe.meshnormal_frag},sprite:{uniforms:An([wt.sprite,wt.fog]),vertexShader:oe.sprite_vert,fragmentShader:oe.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:oe.background_vert,fragmentShader:oe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:oe.backgroundCube_vert,fragmentShader:oe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:oe.cube_vert,fragmentShader:oe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:oe.equirect_vert,fragmentShader:oe.equirect_frag},distanceRGBA:{uniforms:An([wt.common,wt.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:oe.distanceRGBA_vert,fragmentShader:oe.distanceRGBA_frag},shadow:{uniforms:An([wt.lights,wt.fog,{color:{value:new se(0)},opacity:{value:1}}]),vertexShader:oe.shadow_vert,fragmentShader:oe.shadow_frag}};Hi.physical={uniforms:An([Hi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new qt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new se(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new qt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new se(0)},specularColor:{value:new se(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new qt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:oe.meshphysical_vert,fragmentShader:oe.meshphysical_frag};var Kc={r:0,b:0,g:0},rr=new Ti,Db=new We;function Lb(n,t,e,i,s,r,o){let a=new se(0),l=r===!0?0:1,c,u,h=null,f=0,p=null;function _(E){let M=E.isScene===!0?E.background:null;return M&&M.isTexture&&(M=(E.backgroundBlurriness>0?e:t).get(M)),M}function v(E){let M=!1,D=_(E);D===null?d(a,l):D&&D.isColor&&(d(D,1),M=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?i.buffers.color.setClear(0,0,0,1,o):R==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||M)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(E,M){let D=_(M);D&&(D.isCubeTexture||D.mapping===Sa)?(u===void 0&&(u=new yn(new ro(1,1,1),new Ai({name:"BackgroundCubeMaterial",uniforms:sr(Hi.backgroundCube.uniforms),vertexShader:Hi.backgroundCube.vertexShader,fragmentShader:Hi.backgroundCube.fragmentShader,side:Mn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(R,N,B){this.matrixWorld.copyPosition(B.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),rr.copy(M.backgroundRotation),rr.x*=-1,rr.y*=-1,rr.z*=-1,D.isCubeTexture&&D.isRenderTargetTexture===!1&&(rr.y*=-1,rr.z*=-1),u.material.uniforms.envMap.value=D,u.material.uniforms.flipEnvMap.value=D.isCubeTexture&&D.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(Db.makeRotationFromEuler(rr)),u.material.toneMapped=fe.getTransfer(D.colorSpace)!==Ce,(h!==D||f!==D.version||p!==n.toneMapping)&&(u.material.needsUpdate=!0,h=D,f=D.version,p=n.toneMapping),u.layers.enableAll(),E.unshift(u,u.geometry,u.material,0,0,null)):D&&D.isTexture&&(c===void 0&&(c=new yn(new da(2,2),new Ai({name:"BackgroundMaterial",uniforms:sr(Hi.background.uniforms),vertexShader:Hi.background.vertexShader,fragmentShader:Hi.background.fragmentShader,side:bi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=D,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=fe.getTransfer(D.colorSpace)!==Ce,D.matrixAutoUpdate===!0&&D.updateMatrix(),c.material.uniforms.uvTransform.value.copy(D.matrix),(h!==D||f!==D.version||p!==n.toneMapping)&&(c.material.needsUpdate=!0,h=D,f=D.version,p=n.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function d(E,M){E.getRGB(Kc,xf(n)),i.buffers.color.setClear(Kc.r,Kc.g,Kc.b,M,o)}function T(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(E,M=1){a.set(E),l=M,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,d(a,l)},render:v,addToRenderList:m,dispose:T}}function Ub(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(b,C,G,H,q){let X=!1,Z=h(H,G,C);r!==Z&&(r=Z,c(r.object)),X=p(b,H,G,q),X&&_(b,H,G,q),q!==null&&t.update(q,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,M(b,C,G,H),q!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(q).buffer))}function l(){return n.createVertexArray()}function c(b){return n.bindVertexArray(b)}function u(b){return n.deleteVertexArray(b)}function h(b,C,G){let H=G.wireframe===!0,q=i[b.id];q===void 0&&(q={},i[b.id]=q);let X=q[C.id];X===void 0&&(X={},q[C.id]=X);let Z=X[H];return Z===void 0&&(Z=f(l()),X[H]=Z),Z}function f(b){let C=[],G=[],H=[];for(let q=0;q<e;q++)C[q]=0,G[q]=0,H[q]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:G,attributeDivisors:H,object:b,attributes:{},index:null}}function p(b,C,G,H){let q=r.attributes,X=C.attributes,Z=0,J=G.getAttributes();for(let Q in J)if(J[Q].location>=0){let at=q[Q],vt=X[Q];if(vt===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(vt=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(vt=b.instanceColor)),at===void 0||at.attribute!==vt||vt&&at.data!==vt.data)return!0;Z++}return r.attributesNum!==Z||r.index!==H}function _(b,C,G,H){let q={},X=C.attributes,Z=0,J=G.getAttributes();for(let Q in J)if(J[Q].location>=0){let at=X[Q];at===void 0&&(Q==="instanceMatrix"&&b.instanceMatrix&&(at=b.instanceMatrix),Q==="instanceColor"&&b.instanceColor&&(at=b.instanceColor));let vt={};vt.attribute=at,at&&at.data&&(vt.data=at.data),q[Q]=vt,Z++}r.attributes=q,r.attributesNum=Z,r.index=H}function v(){let b=r.newAttributes;for(let C=0,G=b.length;C<G;C++)b[C]=0}function m(b){d(b,0)}function d(b,C){let G=r.newAttributes,H=r.enabledAttributes,q=r.attributeDivisors;G[b]=1,H[b]===0&&(n.enableVertexAttribArray(b),H[b]=1),q[b]!==C&&(n.vertexAttribDivisor(b,C),q[b]=C)}function T(){let b=r.newAttributes,C=r.enabledAttributes;for(let G=0,H=C.length;G<H;G++)C[G]!==b[G]&&(n.disableVertexAttribArray(G),C[G]=0)}function E(b,C,G,H,q,X,Z){Z===!0?n.vertexAttribIPointer(b,C,G,q,X):n.vertexAttribPointer(b,C,G,H,q,X)}function M(b,C,G,H){v();let q=H.attributes,X=G.getAttributes(),Z=C.defaultAttributeValues;for(let J in X){let Q=X[J];if(Q.location>=0){let ot=q[J];if(ot===void 0&&(J==="instanceMatrix"&&b.instanceMatrix&&(ot=b.instanceMatrix),J==="instanceColor"&&b.instanceColor&&(ot=b.instanceColor)),ot!==void 0){let at=ot.normalized,vt=ot.itemSize,yt=t.get(ot);if(yt===void 0)continue;let mt=yt.buffer,Qt=yt.type,Yt=yt.bytesPerElement,tt=Qt===n.INT||Qt===n.UNSIGNED_INT||ot.gpuType===_c;if(ot.isInterleavedBufferAttribute){let et=ot.data,St=et.stride,Ft=ot.offset;if(et.isInstancedInterleavedBuffer){for(let xt=0;xt<Q.locationSize;xt++)d(Q.location+xt,et.meshPerAttribute);b.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=et.meshPerAttribute*et.count)}else for(let xt=0;xt<Q.locationSize;xt++)m(Q.location+xt);n.bindBuffer(n.ARRAY_BUFFER,mt);for(let xt=0;xt<Q.locationSize;xt++)E(Q.location+xt,vt/Q.locationSize,Qt,at,St*Yt,(Ft+vt/Q.locationSize*xt)*Yt,tt)}else{if(ot.isInstancedBufferAttribute){for(let et=0;et<Q.locationSize;et++)d(Q.location+et,ot.meshPerAttribute);b.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let et=0;et<Q.locationSize;et++)m(Q.location+et);n.bindBuffer(n.ARRAY_BUFFER,mt);for(let et=0;et<Q.locationSize;et++)E(Q.location+et,vt/Q.locationSize,Qt,at,vt*Yt,vt/Q.locationSize*et*Yt,tt)}}else if(Z!==void 0){let at=Z[J];if(at!==void 0)switch(at.length){case 2:n.vertexAttrib2fv(Q.location,at);break;case 3:n.vertexAttrib3fv(Q.location,at);break;case 4:n.vertexAttrib4fv(Q.location,at);break;default:n.vertexAttrib1fv(Q.location,at)}}}}T()}function D(){B();for(let b in i){let C=i[b];for(let G in C){let H=C[G];for(let q in H)u(H[q].object),delete H[q];delete C[G]}delete i[b]}}function R(b){if(i[b.id]===void 0)return;let C=i[b.id];for(let G in C){let H=C[G];for(let q in H)u(H[q].object),delete H[q];delete C[G]}delete i[b.id]}function N(b){for(let C in i){let G=i[C];if(G[b.id]===void 0)continue;let H=G[b.id];for(let q in H)u(H[q].object),delete H[q];delete G[b.id]}}function B(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:w,dispose:D,releaseStatesOfGeometry:R,releaseStatesOfProgram:N,initAttributes:v,enableAttribute:m,disableUnusedAttributes:T}}function Nb(n,t,e){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),e.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),e.update(u,i,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let p=0;for(let _=0;_<h;_++)p+=u[_];e.update(p,i,1)}function l(c,u,h,f){if(h===0)return;let p=t.get("WEBGL_multi_draw");if(p===null)for(let _=0;_<c.length;_++)o(c[_],u[_],f[_]);else{p.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let _=0;for(let v=0;v<h;v++)_+=u[v]*f[v];e.update(_,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function Fb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let N=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(N.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(N){return!(N!==ci&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(N){let B=N===fo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(N!==Ci&&i.convert(N)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&N!==Vi&&!B)}function l(N){if(N==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";N="mediump"}return N==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),T=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),D=_>0,R=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:_,maxTextureSize:v,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:T,maxVaryings:E,maxFragmentUniforms:M,vertexTextures:D,maxSamples:R}}function Ob(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ai,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let p=h.length!==0||f||i!==0||s;return s=f,i=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,p){let _=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,d=n.get(h);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{let T=r?0:i,E=T*4,M=d.clippingState||null;l.value=M,M=u(_,f,E,p);for(let D=0;D!==E;++D)M[D]=e[D];d.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=T}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,p,_){let v=h!==null?h.length:0,m=null;if(v!==0){if(m=l.value,_!==!0||m===null){let d=p+v*4,T=f.matrixWorldInverse;a.getNormalMatrix(T),(m===null||m.length<d)&&(m=new Float32Array(d));for(let E=0,M=p;E!==v;++E,M+=4)o.copy(h[E]).applyMatrix4(T,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function Bb(n){let t=new WeakMap;function e(o,a){return a===pc?o.mapping=nr:a===mc&&(o.mapping=ir),o}function i(o){if(o&&o.isTexture){let a=o.mapping;if(a===pc||a===mc)if(t.has(o)){let l=t.get(o).texture;return e(l,o.mapping)}else{let l=o.image;if(l&&l.height>0){let c=new Gl(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){let a=o.target;a.removeEventListener("dispose",s);let l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}var vo=4,Jg=[.125,.215,.35,.446,.526,.582],lr=20,bf=new ga,Kg=new se,wf=null,Tf=0,Ef=0,Af=!1,ar=(1+Math.sqrt(5))/2,_o=1/ar,jg=[new z(-ar,_o,0),new z(ar,_o,0),new z(-_o,0,ar),new z(_o,0,ar),new z(0,ar,-_o),new z(0,ar,_o),new z(-1,1,-1),new z(1,1,-1),new z(-1,1,1),new z(1,1,1)],kb=new z,th=class{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=kb}=r;wf=this._renderer.getRenderTarget(),Tf=this._renderer.getActiveCubeFace(),Ef=this._renderer.getActiveMipmapLevel(),Af=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);let l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,i,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=e0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=t0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(wf,Tf,Ef),this._renderer.xr.enabled=Af,t.scissorTest=!1,jc(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===nr||t.mapping===ir?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),wf=this._renderer.getRenderTarget(),Tf=this._renderer.getActiveCubeFace(),Ef=this._renderer.getActiveMipmapLevel(),Af=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;let i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){let t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:wi,minFilter:wi,generateMipmaps:!1,type:fo,format:ci,colorSpace:Qs,depthBuffer:!1},s=Qg(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Qg(t,e,i);let{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=zb(r)),this._blurMaterial=Vb(r,t,e)}return s}_compileMaterial(t){let e=new yn(this._lodPlanes[0],t);this._renderer.compile(e,bf)}_sceneToCubeUV(t,e,i,s,r){let l=new En(90,1,e,i),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,p=h.toneMapping;h.getClearColor(Kg),h.toneMapping=os,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));let v=new na({name:"PMREM.Background",side:Mn,depthWrite:!1,depthTest:!1}),m=new yn(new ro,v),d=!1,T=t.background;T?T.isColor&&(v.color.copy(T),t.background=null,d=!0):(v.color.copy(Kg),d=!0);for(let E=0;E<6;E++){let M=E%3;M===0?(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[E],r.y,r.z)):M===1?(l.up.set(0,0,c[E]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[E],r.z)):(l.up.set(0,c[E],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[E]));let D=this._cubeSize;jc(s,M*D,E>2?D:0,D,D),h.setRenderTarget(s),d&&h.render(m,l),h.render(t,l)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=p,h.autoClear=f,t.background=T}_textureToCubeUV(t,e){let i=this._renderer,s=t.mapping===nr||t.mapping===ir;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=e0()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=t0());let r=s?this._cubemapMaterial:this._equirectMaterial,o=new yn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;let l=this._cubeSize;jc(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,bf)}_applyPMREM(t){let e=this._renderer,i=e.autoClear;e.autoClear=!1;let s=this._lodPlanes.length;for(let r=1;r<s;r++){let o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=jg[(s-r-1)%jg.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){let o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){let l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");let u=3,h=new yn(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[i]-1,_=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*lr-1),v=r/_,m=isFinite(r)?1+Math.floor(u*v):lr;m>lr&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${lr}`);let d=[],T=0;for(let N=0;N<lr;++N){let B=N/v,w=Math.exp(-B*B/2);d.push(w),N===0?T+=w:N<m&&(T+=2*w)}for(let N=0;N<d.length;N++)d[N]=d[N]/T;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);let{_lodMax:E}=this;f.dTheta.value=_,f.mipInt.value=E-i;let M=this._sizeLods[s],D=3*M*(s>E-vo?s-E+vo:0),R=4*(this._cubeSize-M);jc(e,D,R,3*M,2*M),l.setRenderTarget(e),l.render(h,bf)}};function zb(n){let t=[],e=[],i=[],s=n,r=n-vo+1+Jg.length;for(let o=0;o<r;o++){let a=Math.pow(2,s);e.push(a);let l=1/a;o>n-vo?l=Jg[o-n+vo-1]:o===0&&(l=0),i.push(l);let c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],p=6,_=6,v=3,m=2,d=1,T=new Float32Array(v*_*p),E=new Float32Array(m*_*p),M=new Float32Array(d*_*p);for(let R=0;R<p;R++){let N=R%3*2/3-1,B=R>2?0:-1,w=[N,B,0,N+2/3,B,0,N+2/3,B+1,0,N,B,0,N+2/3,B+1,0,N,B+1,0];T.set(w,v*_*R),E.set(f,m*_*R);let b=[R,R,R,R,R,R];M.set(b,d*_*R)}let D=new tn;D.setAttribute("position",new Ye(T,v)),D.setAttribute("uv",new Ye(E,m)),D.setAttribute("faceIndex",new Ye(M,d)),t.push(D),s>vo&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function Qg(n,t,e){let i=new Oi(n,t,e);return i.texture.mapping=Sa,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function jc(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function Vb(n,t,e){let i=new Float32Array(lr),s=new z(0,1,0);return new Ai({name:"SphericalGaussianBlur",defines:{n:lr,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Of(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:rs,depthTest:!1,depthWrite:!1})}function t0(){return new Ai({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Of(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:rs,depthTest:!1,depthWrite:!1})}function e0(){return new Ai({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Of(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:rs,depthTest:!1,depthWrite:!1})}function Of(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function Hb(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){let l=a.mapping,c=l===pc||l===mc,u=l===nr||l===ir;if(c||u){let h=t.get(a),f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new th(n)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{let p=a.image;return c&&p&&p.height>0||u&&p&&s(p)?(e===null&&(e=new th(n)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0,c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){let l=a.target;l.removeEventListener("dispose",r);let c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function Gb(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&no("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function Wb(n,t,e,i){let s={},r=new WeakMap;function o(h){let f=h.target;f.index!==null&&t.remove(f.index);for(let _ in f.attributes)t.remove(f.attributes[_]);f.removeEventListener("dispose",o),delete s[f.id];let p=r.get(f);p&&(t.remove(p),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){let f=h.attributes;for(let p in f)t.update(f[p],n.ARRAY_BUFFER)}function c(h){let f=[],p=h.index,_=h.attributes.position,v=0;if(p!==null){let T=p.array;v=p.version;for(let E=0,M=T.length;E<M;E+=3){let D=T[E+0],R=T[E+1],N=T[E+2];f.push(D,R,R,N,N,D)}}else if(_!==void 0){let T=_.array;v=_.version;for(let E=0,M=T.length/3-1;E<M;E+=3){let D=E+0,R=E+1,N=E+2;f.push(D,R,R,N,N,D)}}else return;let m=new(vf(f)?sa:ia)(f,1);m.version=v;let d=r.get(h);d&&t.remove(d),r.set(h,m)}function u(h){let f=r.get(h);if(f){let p=h.index;p!==null&&f.version<p.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function Xb(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){n.drawElements(i,p,r,f*o),e.update(p,i,1)}function c(f,p,_){_!==0&&(n.drawElementsInstanced(i,p,r,f*o,_),e.update(p,i,_))}function u(f,p,_){if(_===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,p,0,r,f,0,_);let m=0;for(let d=0;d<_;d++)m+=p[d];e.update(m,i,1)}function h(f,p,_,v){if(_===0)return;let m=t.get("WEBGL_multi_draw");if(m===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],v[d]);else{m.multiDrawElementsInstancedWEBGL(i,p,0,r,f,0,v,0,_);let d=0;for(let T=0;T<_;T++)d+=p[T]*v[T];e.update(d,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function qb(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Yb(n,t,e){let i=new WeakMap,s=new Ze;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let w=function(){N.dispose(),i.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],T=a.morphAttributes.color||[],E=0;p===!0&&(E=1),_===!0&&(E=2),v===!0&&(E=3);let M=a.attributes.position.count*E,D=1;M>t.maxTextureSize&&(D=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let R=new Float32Array(M*D*4*h),N=new ea(R,M,D,h);N.type=Vi,N.needsUpdate=!0;let B=E*4;for(let b=0;b<h;b++){let C=m[b],G=d[b],H=T[b],q=M*D*4*b;for(let X=0;X<C.count;X++){let Z=X*B;p===!0&&(s.fromBufferAttribute(C,X),R[q+Z+0]=s.x,R[q+Z+1]=s.y,R[q+Z+2]=s.z,R[q+Z+3]=0),_===!0&&(s.fromBufferAttribute(G,X),R[q+Z+4]=s.x,R[q+Z+5]=s.y,R[q+Z+6]=s.z,R[q+Z+7]=0),v===!0&&(s.fromBufferAttribute(H,X),R[q+Z+8]=s.x,R[q+Z+9]=s.y,R[q+Z+10]=s.z,R[q+Z+11]=H.itemSize===4?s.w:1)}}f={count:h,texture:N,size:new qt(M,D)},i.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let v=0;v<c.length;v++)p+=c[v];let _=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Zb(n,t,e,i){let s=new WeakMap;function r(l){let c=i.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){let f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){let c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}var y0=new Hn,n0=new ua(1,1),M0=new ea,S0=new Vl,b0=new oa,i0=[],s0=[],r0=new Float32Array(16),o0=new Float32Array(9),a0=new Float32Array(4);function yo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=i0[s];if(r===void 0&&(r=new Float32Array(s),i0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function rn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function on(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function nh(n,t){let e=s0[t];e===void 0&&(e=new Int32Array(t),s0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function $b(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Jb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2fv(this.addr,t),on(e,t)}}function Kb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(rn(e,t))return;n.uniform3fv(this.addr,t),on(e,t)}}function jb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4fv(this.addr,t),on(e,t)}}function Qb(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;a0.set(i),n.uniformMatrix2fv(this.addr,!1,a0),on(e,i)}}function tw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;o0.set(i),n.uniformMatrix3fv(this.addr,!1,o0),on(e,i)}}function ew(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(rn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),on(e,t)}else{if(rn(e,i))return;r0.set(i),n.uniformMatrix4fv(this.addr,!1,r0),on(e,i)}}function nw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function iw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2iv(this.addr,t),on(e,t)}}function sw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(rn(e,t))return;n.uniform3iv(this.addr,t),on(e,t)}}function rw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4iv(this.addr,t),on(e,t)}}function ow(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function aw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(rn(e,t))return;n.uniform2uiv(this.addr,t),on(e,t)}}function lw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(rn(e,t))return;n.uniform3uiv(this.addr,t),on(e,t)}}function cw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(rn(e,t))return;n.uniform4uiv(this.addr,t),on(e,t)}}function hw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(n0.compareFunction=pf,r=n0):r=y0,e.setTexture2D(t||r,s)}function uw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||S0,s)}function fw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||b0,s)}function dw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||M0,s)}function pw(n){switch(n){case 5126:return $b;case 35664:return Jb;case 35665:return Kb;case 35666:return jb;case 35674:return Qb;case 35675:return tw;case 35676:return ew;case 5124:case 35670:return nw;case 35667:case 35671:return iw;case 35668:case 35672:return sw;case 35669:case 35673:return rw;case 5125:return ow;case 36294:return aw;case 36295:return lw;case 36296:return cw;case 35678:case 36198:case 36298:case 36306:case 35682:return hw;case 35679:case 36299:case 36307:return uw;case 35680:case 36300:case 36308:case 36293:return fw;case 36289:case 36303:case 36311:case 36292:return dw}}function mw(n,t){n.uniform1fv(this.addr,t)}function gw(n,t){let e=yo(t,this.size,2);n.uniform2fv(this.addr,e)}function _w(n,t){let e=yo(t,this.size,3);n.uniform3fv(this.addr,e)}function vw(n,t){let e=yo(t,this.size,4);n.uniform4fv(this.addr,e)}function xw(n,t){let e=yo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function yw(n,t){let e=yo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Mw(n,t){let e=yo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Sw(n,t){n.uniform1iv(this.addr,t)}function bw(n,t){n.uniform2iv(this.addr,t)}function ww(n,t){n.uniform3iv(this.addr,t)}function Tw(n,t){n.uniform4iv(this.addr,t)}function Ew(n,t){n.uniform1uiv(this.addr,t)}function Aw(n,t){n.uniform2uiv(this.addr,t)}function Cw(n,t){n.uniform3uiv(this.addr,t)}function Rw(n,t){n.uniform4uiv(this.addr,t)}function Pw(n,t,e){let i=this.cache,s=t.length,r=nh(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||y0,r[o])}function Iw(n,t,e){let i=this.cache,s=t.length,r=nh(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||S0,r[o])}function Dw(n,t,e){let i=this.cache,s=t.length,r=nh(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||b0,r[o])}function Lw(n,t,e){let i=this.cache,s=t.length,r=nh(e,s);rn(i,r)||(n.uniform1iv(this.addr,r),on(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||M0,r[o])}function Uw(n){switch(n){case 5126:return mw;case 35664:return gw;case 35665:return _w;case 35666:return vw;case 35674:return xw;case 35675:return yw;case 35676:return Mw;case 5124:case 35670:return Sw;case 35667:case 35671:return bw;case 35668:case 35672:return ww;case 35669:case 35673:return Tw;case 5125:return Ew;case 36294:return Aw;case 36295:return Cw;case 36296:return Rw;case 35678:case 36198:case 36298:case 36306:case 35682:return Pw;case 35679:case 36299:case 36307:return Iw;case 35680:case 36300:case 36308:case 36293:return Dw;case 36289:case 36303:case 36311:case 36292:return Lw}}var Rf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=pw(e.type)}},Pf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Uw(e.type)}},If=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Cf=/(\w+)(\])?(\[|\.)?/g;function l0(n,t){n.seq.push(t),n.map[t.id]=t}function Nw(n,t,e){let i=n.name,s=i.length;for(Cf.lastIndex=0;;){let r=Cf.exec(i),o=Cf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){l0(e,c===void 0?new Rf(a,n,t):new Pf(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new If(a),l0(e,h)),e=h}}}var xo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){let r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);Nw(r,o,this)}}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function c0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var Fw=37297,Ow=0;function Bw(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var h0=new ie;function kw(n){fe._getMatrix(h0,fe.workingColorSpace,n);let t=`mat3( ${h0.elements.map(e=>e.toFixed(4))} )`;switch(fe.getTransfer(n)){case jo:return[t,"LinearTransferOETF"];case Ce:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function u0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Bw(n.getShaderSource(t),a)}else return r}function zw(n,t){let e=kw(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function Vw(n,t){let e;switch(t){case Eg:e="Linear";break;case Ag:e="Reinhard";break;case Cg:e="Cineon";break;case Rg:e="ACESFilmic";break;case Ig:e="AgX";break;case Dg:e="Neutral";break;case Pg:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Qc=new z;function Hw(){fe.getLuminanceCoefficients(Qc);let n=Qc.x.toFixed(4),t=Qc.y.toFixed(4),e=Qc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Gw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ca).join(`
`)}function Ww(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Xw(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ca(n){return n!==""}function f0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function d0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var qw=/^[ \t]*#include +<([\w\d./]+)>/gm;function Df(n){return n.replace(qw,Zw)}var Yw=new Map;function Zw(n,t){let e=oe[t];if(e===void 0){let i=Yw.get(t);if(i!==void 0)e=oe[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return Df(e)}var $w=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function p0(n){return n.replace($w,Jw)}function Jw(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function m0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function Kw(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===Qu?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===rg?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===zi&&(t="SHADOWMAP_TYPE_VSM"),t}function jw(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case nr:case ir:t="ENVMAP_TYPE_CUBE";break;case Sa:t="ENVMAP_TYPE_CUBE_UV";break}return t}function Qw(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case ir:t="ENVMAP_MODE_REFRACTION";break}return t}function t1(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case dc:t="ENVMAP_BLENDING_MULTIPLY";break;case wg:t="ENVMAP_BLENDING_MIX";break;case Tg:t="ENVMAP_BLENDING_ADD";break}return t}function e1(n){let t=n.envMapCubeUVHeight;if(t===null)return null;let e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function n1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Kw(e),c=jw(e),u=Qw(e),h=t1(e),f=e1(e),p=Gw(e),_=Ww(r),v=s.createProgram(),m,d,T=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(Ca).join(`
`),m.length>0&&(m+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(Ca).join(`
`),d.length>0&&(d+=`
`)):(m=[m0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ca).join(`
`),d=[m0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==os?"#define TONE_MAPPING":"",e.toneMapping!==os?oe.tonemapping_pars_fragment:"",e.toneMapping!==os?Vw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",oe.colorspace_pars_fragment,zw("linearToOutputTexel",e.outputColorSpace),Hw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ca).join(`
`)),o=Df(o),o=f0(o,e),o=d0(o,e),a=Df(a),a=f0(a,e),a=d0(a,e),o=p0(o),a=p0(a),e.isRawShaderMaterial!==!0&&(T=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,d=["#define varying in",e.glslVersion===mf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===mf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);let E=T+m+o,M=T+d+a,D=c0(s,s.VERTEX_SHADER,E),R=c0(s,s.FRAGMENT_SHADER,M);s.attachShader(v,D),s.attachShader(v,R),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function N(C){if(n.debug.checkShaderErrors){let G=s.getProgramInfoLog(v)||"",H=s.getShaderInfoLog(D)||"",q=s.getShaderInfoLog(R)||"",X=G.trim(),Z=H.trim(),J=q.trim(),Q=!0,ot=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(Q=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,D,R);else{let at=u0(s,D,"vertex"),vt=u0(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+X+`
`+at+`
`+vt)}else X!==""?console.warn("THREE.WebGLProgram: Program Info Log:",X):(Z===""||J==="")&&(ot=!1);ot&&(C.diagnostics={runnable:Q,programLog:X,vertexShader:{log:Z,prefix:m},fragmentShader:{log:J,prefix:d}})}s.deleteShader(D),s.deleteShader(R),B=new xo(s,v),w=Xw(s,v)}let B;this.getUniforms=function(){return B===void 0&&N(this),B};let w;this.getAttributes=function(){return w===void 0&&N(this),w};let b=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return b===!1&&(b=s.getProgramParameter(v,Fw)),b},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Ow++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=D,this.fragmentShader=R,this}var i1=0,Lf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){let e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Uf(t),e.set(t,i)),i}},Uf=class{constructor(t){this.id=i1++,this.code=t,this.usedTimes=0}};function s1(n,t,e,i,s,r,o){let a=new so,l=new Lf,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures,p=s.precision,_={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function m(w,b,C,G,H){let q=G.fog,X=H.geometry,Z=w.isMeshStandardMaterial?G.environment:null,J=(w.isMeshStandardMaterial?e:t).get(w.envMap||Z),Q=J&&J.mapping===Sa?J.image.height:null,ot=_[w.type];w.precision!==null&&(p=s.getMaxPrecision(w.precision),p!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",p,"instead."));let at=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,vt=at!==void 0?at.length:0,yt=0;X.morphAttributes.position!==void 0&&(yt=1),X.morphAttributes.normal!==void 0&&(yt=2),X.morphAttributes.color!==void 0&&(yt=3);let mt,Qt,Yt,tt;if(ot){let de=Hi[ot];mt=de.vertexShader,Qt=de.fragmentShader}else mt=w.vertexShader,Qt=w.fragmentShader,l.update(w),Yt=l.getVertexShaderID(w),tt=l.getFragmentShaderID(w);let et=n.getRenderTarget(),St=n.state.buffers.depth.getReversed(),Ft=H.isInstancedMesh===!0,xt=H.isBatchedMesh===!0,Kt=!!w.map,be=!!w.matcap,L=!!J,ue=!!w.aoMap,$t=!!w.lightMap,Gt=!!w.bumpMap,Ut=!!w.normalMap,we=!!w.displacementMap,Rt=!!w.emissiveMap,Ht=!!w.metalnessMap,Be=!!w.roughnessMap,ve=w.anisotropy>0,P=w.clearcoat>0,x=w.dispersion>0,U=w.iridescence>0,K=w.sheen>0,it=w.transmission>0,nt=ve&&!!w.anisotropyMap,Nt=P&&!!w.clearcoatMap,ut=P&&!!w.clearcoatNormalMap,It=P&&!!w.clearcoatRoughnessMap,At=U&&!!w.iridescenceMap,lt=U&&!!w.iridescenceThicknessMap,_t=K&&!!w.sheenColorMap,kt=K&&!!w.sheenRoughnessMap,Bt=!!w.specularMap,Mt=!!w.specularColorMap,jt=!!w.specularIntensityMap,F=it&&!!w.transmissionMap,ft=it&&!!w.thicknessMap,pt=!!w.gradientMap,Pt=!!w.alphaMap,ht=w.alphaTest>0,rt=!!w.alphaHash,Ot=!!w.extensions,te=os;w.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(te=n.toneMapping);let Re={shaderID:ot,shaderType:w.type,shaderName:w.name,vertexShader:mt,fragmentShader:Qt,defines:w.defines,customVertexShaderID:Yt,customFragmentShaderID:tt,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:p,batching:xt,batchingColor:xt&&H._colorsTexture!==null,instancing:Ft,instancingColor:Ft&&H.instanceColor!==null,instancingMorph:Ft&&H.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:et===null?n.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Qs,alphaToCoverage:!!w.alphaToCoverage,map:Kt,matcap:be,envMap:L,envMapMode:L&&J.mapping,envMapCubeUVHeight:Q,aoMap:ue,lightMap:$t,bumpMap:Gt,normalMap:Ut,displacementMap:f&&we,emissiveMap:Rt,normalMapObjectSpace:Ut&&w.normalMapType===Fg,normalMapTangentSpace:Ut&&w.normalMapType===df,metalnessMap:Ht,roughnessMap:Be,anisotropy:ve,anisotropyMap:nt,clearcoat:P,clearcoatMap:Nt,clearcoatNormalMap:ut,clearcoatRoughnessMap:It,dispersion:x,iridescence:U,iridescenceMap:At,iridescenceThicknessMap:lt,sheen:K,sheenColorMap:_t,sheenRoughnessMap:kt,specularMap:Bt,specularColorMap:Mt,specularIntensityMap:jt,transmission:it,transmissionMap:F,thicknessMap:ft,gradientMap:pt,opaque:w.transparent===!1&&w.blending===Ks&&w.alphaToCoverage===!1,alphaMap:Pt,alphaTest:ht,alphaHash:rt,combine:w.combine,mapUv:Kt&&v(w.map.channel),aoMapUv:ue&&v(w.aoMap.channel),lightMapUv:$t&&v(w.lightMap.channel),bumpMapUv:Gt&&v(w.bumpMap.channel),normalMapUv:Ut&&v(w.normalMap.channel),displacementMapUv:we&&v(w.displacementMap.channel),emissiveMapUv:Rt&&v(w.emissiveMap.channel),metalnessMapUv:Ht&&v(w.metalnessMap.channel),roughnessMapUv:Be&&v(w.roughnessMap.channel),anisotropyMapUv:nt&&v(w.anisotropyMap.channel),clearcoatMapUv:Nt&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:ut&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:It&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:At&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:lt&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:_t&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:kt&&v(w.sheenRoughnessMap.channel),specularMapUv:Bt&&v(w.specularMap.channel),specularColorMapUv:Mt&&v(w.specularColorMap.channel),specularIntensityMapUv:jt&&v(w.specularIntensityMap.channel),transmissionMapUv:F&&v(w.transmissionMap.channel),thicknessMapUv:ft&&v(w.thicknessMap.channel),alphaMapUv:Pt&&v(w.alphaMap.channel),vertexTangents:!!X.attributes.tangent&&(Ut||ve),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,pointsUvs:H.isPoints===!0&&!!X.attributes.uv&&(Kt||Pt),fog:!!q,useFog:w.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:w.flatShading===!0&&w.wireframe===!1,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:St,skinning:H.isSkinnedMesh===!0,morphTargets:X.morphAttributes.position!==void 0,morphNormals:X.morphAttributes.normal!==void 0,morphColors:X.morphAttributes.color!==void 0,morphTargetsCount:vt,morphTextureStride:yt,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:te,decodeVideoTexture:Kt&&w.map.isVideoTexture===!0&&fe.getTransfer(w.map.colorSpace)===Ce,decodeVideoTextureEmissive:Rt&&w.emissiveMap.isVideoTexture===!0&&fe.getTransfer(w.emissiveMap.colorSpace)===Ce,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Fn,flipSided:w.side===Mn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Ot&&w.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&w.extensions.multiDraw===!0||xt)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return Re.vertexUv1s=c.has(1),Re.vertexUv2s=c.has(2),Re.vertexUv3s=c.has(3),c.clear(),Re}function d(w){let b=[];if(w.shaderID?b.push(w.shaderID):(b.push(w.customVertexShaderID),b.push(w.customFragmentShaderID)),w.defines!==void 0)for(let C in w.defines)b.push(C),b.push(w.defines[C]);return w.isRawShaderMaterial===!1&&(T(b,w),E(b,w),b.push(n.outputColorSpace)),b.push(w.customProgramCacheKey),b.join()}function T(w,b){w.push(b.precision),w.push(b.outputColorSpace),w.push(b.envMapMode),w.push(b.envMapCubeUVHeight),w.push(b.mapUv),w.push(b.alphaMapUv),w.push(b.lightMapUv),w.push(b.aoMapUv),w.push(b.bumpMapUv),w.push(b.normalMapUv),w.push(b.displacementMapUv),w.push(b.emissiveMapUv),w.push(b.metalnessMapUv),w.push(b.roughnessMapUv),w.push(b.anisotropyMapUv),w.push(b.clearcoatMapUv),w.push(b.clearcoatNormalMapUv),w.push(b.clearcoatRoughnessMapUv),w.push(b.iridescenceMapUv),w.push(b.iridescenceThicknessMapUv),w.push(b.sheenColorMapUv),w.push(b.sheenRoughnessMapUv),w.push(b.specularMapUv),w.push(b.specularColorMapUv),w.push(b.specularIntensityMapUv),w.push(b.transmissionMapUv),w.push(b.thicknessMapUv),w.push(b.combine),w.push(b.fogExp2),w.push(b.sizeAttenuation),w.push(b.morphTargetsCount),w.push(b.morphAttributeCount),w.push(b.numDirLights),w.push(b.numPointLights),w.push(b.numSpotLights),w.push(b.numSpotLightMaps),w.push(b.numHemiLights),w.push(b.numRectAreaLights),w.push(b.numDirLightShadows),w.push(b.numPointLightShadows),w.push(b.numSpotLightShadows),w.push(b.numSpotLightShadowsWithMaps),w.push(b.numLightProbes),w.push(b.shadowMapType),w.push(b.toneMapping),w.push(b.numClippingPlanes),w.push(b.numClipIntersection),w.push(b.depthPacking)}function E(w,b){a.disableAll(),b.supportsVertexTextures&&a.enable(0),b.instancing&&a.enable(1),b.instancingColor&&a.enable(2),b.instancingMorph&&a.enable(3),b.matcap&&a.enable(4),b.envMap&&a.enable(5),b.normalMapObjectSpace&&a.enable(6),b.normalMapTangentSpace&&a.enable(7),b.clearcoat&&a.enable(8),b.iridescence&&a.enable(9),b.alphaTest&&a.enable(10),b.vertexColors&&a.enable(11),b.vertexAlphas&&a.enable(12),b.vertexUv1s&&a.enable(13),b.vertexUv2s&&a.enable(14),b.vertexUv3s&&a.enable(15),b.vertexTangents&&a.enable(16),b.anisotropy&&a.enable(17),b.alphaHash&&a.enable(18),b.batching&&a.enable(19),b.dispersion&&a.enable(20),b.batchingColor&&a.enable(21),b.gradientMap&&a.enable(22),w.push(a.mask),a.disableAll(),b.fog&&a.enable(0),b.useFog&&a.enable(1),b.flatShading&&a.enable(2),b.logarithmicDepthBuffer&&a.enable(3),b.reversedDepthBuffer&&a.enable(4),b.skinning&&a.enable(5),b.morphTargets&&a.enable(6),b.morphNormals&&a.enable(7),b.morphColors&&a.enable(8),b.premultipliedAlpha&&a.enable(9),b.shadowMapEnabled&&a.enable(10),b.doubleSided&&a.enable(11),b.flipSided&&a.enable(12),b.useDepthPacking&&a.enable(13),b.dithering&&a.enable(14),b.transmission&&a.enable(15),b.sheen&&a.enable(16),b.opaque&&a.enable(17),b.pointsUvs&&a.enable(18),b.decodeVideoTexture&&a.enable(19),b.decodeVideoTextureEmissive&&a.enable(20),b.alphaToCoverage&&a.enable(21),w.push(a.mask)}function M(w){let b=_[w.type],C;if(b){let G=Hi[b];C=Yg.clone(G.uniforms)}else C=w.uniforms;return C}function D(w,b){let C;for(let G=0,H=u.length;G<H;G++){let q=u[G];if(q.cacheKey===b){C=q,++C.usedTimes;break}}return C===void 0&&(C=new n1(n,b,w,r),u.push(C)),C}function R(w){if(--w.usedTimes===0){let b=u.indexOf(w);u[b]=u[u.length-1],u.pop(),w.destroy()}}function N(w){l.remove(w)}function B(){l.dispose()}return{getParameters:m,getProgramCacheKey:d,getUniforms:M,acquireProgram:D,releaseProgram:R,releaseShaderCache:N,programs:u,dispose:B}}function r1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function o1(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function g0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function _0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h,f,p,_,v,m){let d=n[t];return d===void 0?(d={id:h.id,object:h,geometry:f,material:p,groupOrder:_,renderOrder:h.renderOrder,z:v,group:m},n[t]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=p,d.groupOrder=_,d.renderOrder=h.renderOrder,d.z=v,d.group=m),t++,d}function a(h,f,p,_,v,m){let d=o(h,f,p,_,v,m);p.transmission>0?i.push(d):p.transparent===!0?s.push(d):e.push(d)}function l(h,f,p,_,v,m){let d=o(h,f,p,_,v,m);p.transmission>0?i.unshift(d):p.transparent===!0?s.unshift(d):e.unshift(d)}function c(h,f){e.length>1&&e.sort(h||o1),i.length>1&&i.sort(f||g0),s.length>1&&s.sort(f||g0)}function u(){for(let h=t,f=n.length;h<f;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function a1(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new _0,n.set(i,[o])):s>=r.length?(o=new _0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function l1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new z,color:new se};break;case"SpotLight":e={position:new z,direction:new z,color:new se,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new se,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new se,groundColor:new se};break;case"RectAreaLight":e={color:new se,position:new z,halfWidth:new z,halfHeight:new z};break}return n[t.id]=e,e}}}function c1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new qt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var h1=0;function u1(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function f1(n){let t=new l1,e=c1(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);let s=new z,r=new We,o=new We;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)i.probe[w].set(0,0,0);let p=0,_=0,v=0,m=0,d=0,T=0,E=0,M=0,D=0,R=0,N=0;c.sort(u1);for(let w=0,b=c.length;w<b;w++){let C=c[w],G=C.color,H=C.intensity,q=C.distance,X=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=G.r*H,h+=G.g*H,f+=G.b*H;else if(C.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(C.sh.coefficients[Z],H);N++}else if(C.isDirectionalLight){let Z=t.get(C);if(Z.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){let J=C.shadow,Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,i.directionalShadow[p]=Q,i.directionalShadowMap[p]=X,i.directionalShadowMatrix[p]=C.shadow.matrix,T++}i.directional[p]=Z,p++}else if(C.isSpotLight){let Z=t.get(C);Z.position.setFromMatrixPosition(C.matrixWorld),Z.color.copy(G).multiplyScalar(H),Z.distance=q,Z.coneCos=Math.cos(C.angle),Z.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),Z.decay=C.decay,i.spot[v]=Z;let J=C.shadow;if(C.map&&(i.spotLightMap[D]=C.map,D++,J.updateMatrices(C),C.castShadow&&R++),i.spotLightMatrix[v]=J.matrix,C.castShadow){let Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,i.spotShadow[v]=Q,i.spotShadowMap[v]=X,M++}v++}else if(C.isRectAreaLight){let Z=t.get(C);Z.color.copy(G).multiplyScalar(H),Z.halfWidth.set(C.width*.5,0,0),Z.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=Z,m++}else if(C.isPointLight){let Z=t.get(C);if(Z.color.copy(C.color).multiplyScalar(C.intensity),Z.distance=C.distance,Z.decay=C.decay,C.castShadow){let J=C.shadow,Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,Q.shadowCameraNear=J.camera.near,Q.shadowCameraFar=J.camera.far,i.pointShadow[_]=Q,i.pointShadowMap[_]=X,i.pointShadowMatrix[_]=C.shadow.matrix,E++}i.point[_]=Z,_++}else if(C.isHemisphereLight){let Z=t.get(C);Z.skyColor.copy(C.color).multiplyScalar(H),Z.groundColor.copy(C.groundColor).multiplyScalar(H),i.hemi[d]=Z,d++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=wt.LTC_FLOAT_1,i.rectAreaLTC2=wt.LTC_FLOAT_2):(i.rectAreaLTC1=wt.LTC_HALF_1,i.rectAreaLTC2=wt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let B=i.hash;(B.directionalLength!==p||B.pointLength!==_||B.spotLength!==v||B.rectAreaLength!==m||B.hemiLength!==d||B.numDirectionalShadows!==T||B.numPointShadows!==E||B.numSpotShadows!==M||B.numSpotMaps!==D||B.numLightProbes!==N)&&(i.directional.length=p,i.spot.length=v,i.rectArea.length=m,i.point.length=_,i.hemi.length=d,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.pointShadow.length=E,i.pointShadowMap.length=E,i.spotShadow.length=M,i.spotShadowMap.length=M,i.directionalShadowMatrix.length=T,i.pointShadowMatrix.length=E,i.spotLightMatrix.length=M+D-R,i.spotLightMap.length=D,i.numSpotLightShadowsWithMaps=R,i.numLightProbes=N,B.directionalLength=p,B.pointLength=_,B.spotLength=v,B.rectAreaLength=m,B.hemiLength=d,B.numDirectionalShadows=T,B.numPointShadows=E,B.numSpotShadows=M,B.numSpotMaps=D,B.numLightProbes=N,i.version=h1++)}function l(c,u){let h=0,f=0,p=0,_=0,v=0,m=u.matrixWorldInverse;for(let d=0,T=c.length;d<T;d++){let E=c[d];if(E.isDirectionalLight){let M=i.directional[h];M.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),h++}else if(E.isSpotLight){let M=i.spot[p];M.position.setFromMatrixPosition(E.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),p++}else if(E.isRectAreaLight){let M=i.rectArea[_];M.position.setFromMatrixPosition(E.matrixWorld),M.position.applyMatrix4(m),o.identity(),r.copy(E.matrixWorld),r.premultiply(m),o.extractRotation(r),M.halfWidth.set(E.width*.5,0,0),M.halfHeight.set(0,E.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),_++}else if(E.isPointLight){let M=i.point[f];M.position.setFromMatrixPosition(E.matrixWorld),M.position.applyMatrix4(m),f++}else if(E.isHemisphereLight){let M=i.hemi[v];M.direction.setFromMatrixPosition(E.matrixWorld),M.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function v0(n){let t=new f1(n),e=[],i=[];function s(u){c.camera=u,e.length=0,i.length=0}function r(u){e.push(u)}function o(u){i.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}let c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function d1(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new v0(n),t.set(s,[a])):r>=o.length?(a=new v0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var p1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,m1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function g1(n,t,e){let i=new lo,s=new qt,r=new qt,o=new Ze,a=new Zl({depthPacking:Ng}),l=new $l,c={},u=e.maxTextureSize,h={[bi]:Mn,[Mn]:bi,[Fn]:Fn},f=new Ai({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new qt},radius:{value:4}},vertexShader:p1,fragmentShader:m1}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let _=new tn;_.setAttribute("position",new Ye(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new yn(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Qu;let d=this.type;this.render=function(R,N,B){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;let w=n.getRenderTarget(),b=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),G=n.state;G.setBlending(rs),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=d!==zi&&this.type===zi,q=d===zi&&this.type!==zi;for(let X=0,Z=R.length;X<Z;X++){let J=R[X],Q=J.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",J,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);let ot=Q.getFrameExtents();if(s.multiply(ot),r.copy(Q.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ot.x),s.x=r.x*ot.x,Q.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ot.y),s.y=r.y*ot.y,Q.mapSize.y=r.y)),Q.map===null||H===!0||q===!0){let vt=this.type!==zi?{minFilter:li,magFilter:li}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Oi(s.x,s.y,vt),Q.map.texture.name=J.name+".shadowMap",Q.camera.updateProjectionMatrix()}n.setRenderTarget(Q.map),n.clear();let at=Q.getViewportCount();for(let vt=0;vt<at;vt++){let yt=Q.getViewport(vt);o.set(r.x*yt.x,r.y*yt.y,r.x*yt.z,r.y*yt.w),G.viewport(o),Q.updateMatrices(J,vt),i=Q.getFrustum(),M(N,B,Q.camera,J,this.type)}Q.isPointLightShadow!==!0&&this.type===zi&&T(Q,B),Q.needsUpdate=!1}d=this.type,m.needsUpdate=!1,n.setRenderTarget(w,b,C)};function T(R,N){let B=t.update(v);f.defines.VSM_SAMPLES!==R.blurSamples&&(f.defines.VSM_SAMPLES=R.blurSamples,p.defines.VSM_SAMPLES=R.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new Oi(s.x,s.y)),f.uniforms.shadow_pass.value=R.map.texture,f.uniforms.resolution.value=R.mapSize,f.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(N,null,B,f,v,null),p.uniforms.shadow_pass.value=R.mapPass.texture,p.uniforms.resolution.value=R.mapSize,p.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(N,null,B,p,v,null)}function E(R,N,B,w){let b=null,C=B.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)b=C;else if(b=B.isPointLight===!0?l:a,n.localClippingEnabled&&N.clipShadows===!0&&Array.isArray(N.clippingPlanes)&&N.clippingPlanes.length!==0||N.displacementMap&&N.displacementScale!==0||N.alphaMap&&N.alphaTest>0||N.map&&N.alphaTest>0||N.alphaToCoverage===!0){let G=b.uuid,H=N.uuid,q=c[G];q===void 0&&(q={},c[G]=q);let X=q[H];X===void 0&&(X=b.clone(),q[H]=X,N.addEventListener("dispose",D)),b=X}if(b.visible=N.visible,b.wireframe=N.wireframe,w===zi?b.side=N.shadowSide!==null?N.shadowSide:N.side:b.side=N.shadowSide!==null?N.shadowSide:h[N.side],b.alphaMap=N.alphaMap,b.alphaTest=N.alphaToCoverage===!0?.5:N.alphaTest,b.map=N.map,b.clipShadows=N.clipShadows,b.clippingPlanes=N.clippingPlanes,b.clipIntersection=N.clipIntersection,b.displacementMap=N.displacementMap,b.displacementScale=N.displacementScale,b.displacementBias=N.displacementBias,b.wireframeLinewidth=N.wireframeLinewidth,b.linewidth=N.linewidth,B.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let G=n.properties.get(b);G.light=B}return b}function M(R,N,B,w,b){if(R.visible===!1)return;if(R.layers.test(N.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&b===zi)&&(!R.frustumCulled||i.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(B.matrixWorldInverse,R.matrixWorld);let H=t.update(R),q=R.material;if(Array.isArray(q)){let X=H.groups;for(let Z=0,J=X.length;Z<J;Z++){let Q=X[Z],ot=q[Q.materialIndex];if(ot&&ot.visible){let at=E(R,ot,w,b);R.onBeforeShadow(n,R,N,B,H,at,Q),n.renderBufferDirect(B,null,H,at,R,Q),R.onAfterShadow(n,R,N,B,H,at,Q)}}}else if(q.visible){let X=E(R,q,w,b);R.onBeforeShadow(n,R,N,B,H,X,null),n.renderBufferDirect(B,null,H,X,R,null),R.onAfterShadow(n,R,N,B,H,X,null)}}let G=R.children;for(let H=0,q=G.length;H<q;H++)M(G[H],N,B,w,b)}function D(R){R.target.removeEventListener("dispose",D);for(let B in c){let w=c[B],b=R.target.uuid;b in w&&(w[b].dispose(),delete w[b])}}}var _1={[oc]:ac,[lc]:uc,[cc]:fc,[js]:hc,[ac]:oc,[uc]:lc,[fc]:cc,[hc]:js};function v1(n,t){function e(){let F=!1,ft=new Ze,pt=null,Pt=new Ze(0,0,0,0);return{setMask:function(ht){pt!==ht&&!F&&(n.colorMask(ht,ht,ht,ht),pt=ht)},setLocked:function(ht){F=ht},setClear:function(ht,rt,Ot,te,Re){Re===!0&&(ht*=te,rt*=te,Ot*=te),ft.set(ht,rt,Ot,te),Pt.equals(ft)===!1&&(n.clearColor(ht,rt,Ot,te),Pt.copy(ft))},reset:function(){F=!1,pt=null,Pt.set(-1,0,0,0)}}}function i(){let F=!1,ft=!1,pt=null,Pt=null,ht=null;return{setReversed:function(rt){if(ft!==rt){let Ot=t.get("EXT_clip_control");rt?Ot.clipControlEXT(Ot.LOWER_LEFT_EXT,Ot.ZERO_TO_ONE_EXT):Ot.clipControlEXT(Ot.LOWER_LEFT_EXT,Ot.NEGATIVE_ONE_TO_ONE_EXT),ft=rt;let te=ht;ht=null,this.setClear(te)}},getReversed:function(){return ft},setTest:function(rt){rt?et(n.DEPTH_TEST):St(n.DEPTH_TEST)},setMask:function(rt){pt!==rt&&!F&&(n.depthMask(rt),pt=rt)},setFunc:function(rt){if(ft&&(rt=_1[rt]),Pt!==rt){switch(rt){case oc:n.depthFunc(n.NEVER);break;case ac:n.depthFunc(n.ALWAYS);break;case lc:n.depthFunc(n.LESS);break;case js:n.depthFunc(n.LEQUAL);break;case cc:n.depthFunc(n.EQUAL);break;case hc:n.depthFunc(n.GEQUAL);break;case uc:n.depthFunc(n.GREATER);break;case fc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Pt=rt}},setLocked:function(rt){F=rt},setClear:function(rt){ht!==rt&&(ft&&(rt=1-rt),n.clearDepth(rt),ht=rt)},reset:function(){F=!1,pt=null,Pt=null,ht=null,ft=!1}}}function s(){let F=!1,ft=null,pt=null,Pt=null,ht=null,rt=null,Ot=null,te=null,Re=null;return{setTest:function(de){F||(de?et(n.STENCIL_TEST):St(n.STENCIL_TEST))},setMask:function(de){ft!==de&&!F&&(n.stencilMask(de),ft=de)},setFunc:function(de,_n,De){(pt!==de||Pt!==_n||ht!==De)&&(n.stencilFunc(de,_n,De),pt=de,Pt=_n,ht=De)},setOp:function(de,_n,De){(rt!==de||Ot!==_n||te!==De)&&(n.stencilOp(de,_n,De),rt=de,Ot=_n,te=De)},setLocked:function(de){F=de},setClear:function(de){Re!==de&&(n.clearStencil(de),Re=de)},reset:function(){F=!1,ft=null,pt=null,Pt=null,ht=null,rt=null,Ot=null,te=null,Re=null}}}let r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap,u={},h={},f=new WeakMap,p=[],_=null,v=!1,m=null,d=null,T=null,E=null,M=null,D=null,R=null,N=new se(0,0,0),B=0,w=!1,b=null,C=null,G=null,H=null,q=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),Z=!1,J=0,Q=n.getParameter(n.VERSION);Q.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(Q)[1]),Z=J>=1):Q.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),Z=J>=2);let ot=null,at={},vt=n.getParameter(n.SCISSOR_BOX),yt=n.getParameter(n.VIEWPORT),mt=new Ze().fromArray(vt),Qt=new Ze().fromArray(yt);function Yt(F,ft,pt,Pt){let ht=new Uint8Array(4),rt=n.createTexture();n.bindTexture(F,rt),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ot=0;Ot<pt;Ot++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(ft,0,n.RGBA,1,1,Pt,0,n.RGBA,n.UNSIGNED_BYTE,ht):n.texImage2D(ft+Ot,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ht);return rt}let tt={};tt[n.TEXTURE_2D]=Yt(n.TEXTURE_2D,n.TEXTURE_2D,1),tt[n.TEXTURE_CUBE_MAP]=Yt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),tt[n.TEXTURE_2D_ARRAY]=Yt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),tt[n.TEXTURE_3D]=Yt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),et(n.DEPTH_TEST),o.setFunc(js),Gt(!1),Ut(ju),et(n.CULL_FACE),ue(rs);function et(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function St(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function Ft(F,ft){return h[F]!==ft?(n.bindFramebuffer(F,ft),h[F]=ft,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=ft),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=ft),!0):!1}function xt(F,ft){let pt=p,Pt=!1;if(F){pt=f.get(ft),pt===void 0&&(pt=[],f.set(ft,pt));let ht=F.textures;if(pt.length!==ht.length||pt[0]!==n.COLOR_ATTACHMENT0){for(let rt=0,Ot=ht.length;rt<Ot;rt++)pt[rt]=n.COLOR_ATTACHMENT0+rt;pt.length=ht.length,Pt=!0}}else pt[0]!==n.BACK&&(pt[0]=n.BACK,Pt=!0);Pt&&n.drawBuffers(pt)}function Kt(F){return _!==F?(n.useProgram(F),_=F,!0):!1}let be={[Ts]:n.FUNC_ADD,[ag]:n.FUNC_SUBTRACT,[lg]:n.FUNC_REVERSE_SUBTRACT};be[cg]=n.MIN,be[hg]=n.MAX;let L={[ug]:n.ZERO,[fg]:n.ONE,[dg]:n.SRC_COLOR,[Ll]:n.SRC_ALPHA,[xg]:n.SRC_ALPHA_SATURATE,[_g]:n.DST_COLOR,[mg]:n.DST_ALPHA,[pg]:n.ONE_MINUS_SRC_COLOR,[Ul]:n.ONE_MINUS_SRC_ALPHA,[vg]:n.ONE_MINUS_DST_COLOR,[gg]:n.ONE_MINUS_DST_ALPHA,[yg]:n.CONSTANT_COLOR,[Mg]:n.ONE_MINUS_CONSTANT_COLOR,[Sg]:n.CONSTANT_ALPHA,[bg]:n.ONE_MINUS_CONSTANT_ALPHA};function ue(F,ft,pt,Pt,ht,rt,Ot,te,Re,de){if(F===rs){v===!0&&(St(n.BLEND),v=!1);return}if(v===!1&&(et(n.BLEND),v=!0),F!==og){if(F!==m||de!==w){if((d!==Ts||M!==Ts)&&(n.blendEquation(n.FUNC_ADD),d=Ts,M=Ts),de)switch(F){case Ks:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case tf:n.blendFunc(n.ONE,n.ONE);break;case ef:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case nf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}else switch(F){case Ks:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case tf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case ef:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case nf:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}T=null,E=null,D=null,R=null,N.set(0,0,0),B=0,m=F,w=de}return}ht=ht||ft,rt=rt||pt,Ot=Ot||Pt,(ft!==d||ht!==M)&&(n.blendEquationSeparate(be[ft],be[ht]),d=ft,M=ht),(pt!==T||Pt!==E||rt!==D||Ot!==R)&&(n.blendFuncSeparate(L[pt],L[Pt],L[rt],L[Ot]),T=pt,E=Pt,D=rt,R=Ot),(te.equals(N)===!1||Re!==B)&&(n.blendColor(te.r,te.g,te.b,Re),N.copy(te),B=Re),m=F,w=!1}function $t(F,ft){F.side===Fn?St(n.CULL_FACE):et(n.CULL_FACE);let pt=F.side===Mn;ft&&(pt=!pt),Gt(pt),F.blending===Ks&&F.transparent===!1?ue(rs):ue(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Pt=F.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Rt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?et(n.SAMPLE_ALPHA_TO_COVERAGE):St(n.SAMPLE_ALPHA_TO_COVERAGE)}function Gt(F){b!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),b=F)}function Ut(F){F!==ig?(et(n.CULL_FACE),F!==C&&(F===ju?n.cullFace(n.BACK):F===sg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):St(n.CULL_FACE),C=F}function we(F){F!==G&&(Z&&n.lineWidth(F),G=F)}function Rt(F,ft,pt){F?(et(n.POLYGON_OFFSET_FILL),(H!==ft||q!==pt)&&(n.polygonOffset(ft,pt),H=ft,q=pt)):St(n.POLYGON_OFFSET_FILL)}function Ht(F){F?et(n.SCISSOR_TEST):St(n.SCISSOR_TEST)}function Be(F){F===void 0&&(F=n.TEXTURE0+X-1),ot!==F&&(n.activeTexture(F),ot=F)}function ve(F,ft,pt){pt===void 0&&(ot===null?pt=n.TEXTURE0+X-1:pt=ot);let Pt=at[pt];Pt===void 0&&(Pt={type:void 0,texture:void 0},at[pt]=Pt),(Pt.type!==F||Pt.texture!==ft)&&(ot!==pt&&(n.activeTexture(pt),ot=pt),n.bindTexture(F,ft||tt[F]),Pt.type=F,Pt.texture=ft)}function P(){let F=at[ot];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function x(){try{n.compressedTexImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function U(){try{n.compressedTexImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function K(){try{n.texSubImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function it(){try{n.texSubImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function nt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Nt(){try{n.compressedTexSubImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function ut(){try{n.texStorage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function It(){try{n.texStorage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function At(){try{n.texImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function lt(){try{n.texImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function _t(F){mt.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),mt.copy(F))}function kt(F){Qt.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),Qt.copy(F))}function Bt(F,ft){let pt=c.get(ft);pt===void 0&&(pt=new WeakMap,c.set(ft,pt));let Pt=pt.get(F);Pt===void 0&&(Pt=n.getUniformBlockIndex(ft,F.name),pt.set(F,Pt))}function Mt(F,ft){let Pt=c.get(ft).get(F);l.get(ft)!==Pt&&(n.uniformBlockBinding(ft,Pt,F.__bindingPointIndex),l.set(ft,Pt))}function jt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},ot=null,at={},h={},f=new WeakMap,p=[],_=null,v=!1,m=null,d=null,T=null,E=null,M=null,D=null,R=null,N=new se(0,0,0),B=0,w=!1,b=null,C=null,G=null,H=null,q=null,mt.set(0,0,n.canvas.width,n.canvas.height),Qt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:et,disable:St,bindFramebuffer:Ft,drawBuffers:xt,useProgram:Kt,setBlending:ue,setMaterial:$t,setFlipSided:Gt,setCullFace:Ut,setLineWidth:we,setPolygonOffset:Rt,setScissorTest:Ht,activeTexture:Be,bindTexture:ve,unbindTexture:P,compressedTexImage2D:x,compressedTexImage3D:U,texImage2D:At,texImage3D:lt,updateUBOMapping:Bt,uniformBlockBinding:Mt,texStorage2D:ut,texStorage3D:It,texSubImage2D:K,texSubImage3D:it,compressedTexSubImage2D:nt,compressedTexSubImage3D:Nt,scissor:_t,viewport:kt,reset:jt}}function x1(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new qt,u=new WeakMap,h,f=new WeakMap,p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(P,x){return p?new OffscreenCanvas(P,x):ta("canvas")}function v(P,x,U){let K=1,it=ve(P);if((it.width>U||it.height>U)&&(K=U/Math.max(it.width,it.height)),K<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let nt=Math.floor(K*it.width),Nt=Math.floor(K*it.height);h===void 0&&(h=_(nt,Nt));let ut=x?_(nt,Nt):h;return ut.width=nt,ut.height=Nt,ut.getContext("2d").drawImage(P,0,0,nt,Nt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+it.width+"x"+it.height+") to ("+nt+"x"+Nt+")."),ut}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+it.width+"x"+it.height+")."),P;return P}function m(P){return P.generateMipmaps}function d(P){n.generateMipmap(P)}function T(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(P,x,U,K,it=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let nt=x;if(x===n.RED&&(U===n.FLOAT&&(nt=n.R32F),U===n.HALF_FLOAT&&(nt=n.R16F),U===n.UNSIGNED_BYTE&&(nt=n.R8)),x===n.RED_INTEGER&&(U===n.UNSIGNED_BYTE&&(nt=n.R8UI),U===n.UNSIGNED_SHORT&&(nt=n.R16UI),U===n.UNSIGNED_INT&&(nt=n.R32UI),U===n.BYTE&&(nt=n.R8I),U===n.SHORT&&(nt=n.R16I),U===n.INT&&(nt=n.R32I)),x===n.RG&&(U===n.FLOAT&&(nt=n.RG32F),U===n.HALF_FLOAT&&(nt=n.RG16F),U===n.UNSIGNED_BYTE&&(nt=n.RG8)),x===n.RG_INTEGER&&(U===n.UNSIGNED_BYTE&&(nt=n.RG8UI),U===n.UNSIGNED_SHORT&&(nt=n.RG16UI),U===n.UNSIGNED_INT&&(nt=n.RG32UI),U===n.BYTE&&(nt=n.RG8I),U===n.SHORT&&(nt=n.RG16I),U===n.INT&&(nt=n.RG32I)),x===n.RGB_INTEGER&&(U===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),U===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),U===n.UNSIGNED_INT&&(nt=n.RGB32UI),U===n.BYTE&&(nt=n.RGB8I),U===n.SHORT&&(nt=n.RGB16I),U===n.INT&&(nt=n.RGB32I)),x===n.RGBA_INTEGER&&(U===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),U===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),U===n.UNSIGNED_INT&&(nt=n.RGBA32UI),U===n.BYTE&&(nt=n.RGBA8I),U===n.SHORT&&(nt=n.RGBA16I),U===n.INT&&(nt=n.RGBA32I)),x===n.RGB&&(U===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),U===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),x===n.RGBA){let Nt=it?jo:fe.getTransfer(K);U===n.FLOAT&&(nt=n.RGBA32F),U===n.HALF_FLOAT&&(nt=n.RGBA16F),U===n.UNSIGNED_BYTE&&(nt=Nt===Ce?n.SRGB8_ALPHA8:n.RGBA8),U===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),U===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function M(P,x){let U;return P?x===null||x===Ls||x===po?U=n.DEPTH24_STENCIL8:x===Vi?U=n.DEPTH32F_STENCIL8:x===uo&&(U=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ls||x===po?U=n.DEPTH_COMPONENT24:x===Vi?U=n.DEPTH_COMPONENT32F:x===uo&&(U=n.DEPTH_COMPONENT16),U}function D(P,x){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==li&&P.minFilter!==wi?Math.log2(Math.max(x.width,x.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?x.mipmaps.length:1}function R(P){let x=P.target;x.removeEventListener("dispose",R),B(x),x.isVideoTexture&&u.delete(x)}function N(P){let x=P.target;x.removeEventListener("dispose",N),b(x)}function B(P){let x=i.get(P);if(x.__webglInit===void 0)return;let U=P.source,K=f.get(U);if(K){let it=K[x.__cacheKey];it.usedTimes--,it.usedTimes===0&&w(P),Object.keys(K).length===0&&f.delete(U)}i.remove(P)}function w(P){let x=i.get(P);n.deleteTexture(x.__webglTexture);let U=P.source,K=f.get(U);delete K[x.__cacheKey],o.memory.textures--}function b(P){let x=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(x.__webglFramebuffer[K]))for(let it=0;it<x.__webglFramebuffer[K].length;it++)n.deleteFramebuffer(x.__webglFramebuffer[K][it]);else n.deleteFramebuffer(x.__webglFramebuffer[K]);x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer[K])}else{if(Array.isArray(x.__webglFramebuffer))for(let K=0;K<x.__webglFramebuffer.length;K++)n.deleteFramebuffer(x.__webglFramebuffer[K]);else n.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&n.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&n.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let K=0;K<x.__webglColorRenderbuffer.length;K++)x.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(x.__webglColorRenderbuffer[K]);x.__webglDepthRenderbuffer&&n.deleteRenderbuffer(x.__webglDepthRenderbuffer)}let U=P.textures;for(let K=0,it=U.length;K<it;K++){let nt=i.get(U[K]);nt.__webglTexture&&(n.deleteTexture(nt.__webglTexture),o.memory.textures--),i.remove(U[K])}i.remove(P)}let C=0;function G(){C=0}function H(){let P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function q(P){let x=[];return x.push(P.wrapS),x.push(P.wrapT),x.push(P.wrapR||0),x.push(P.magFilter),x.push(P.minFilter),x.push(P.anisotropy),x.push(P.internalFormat),x.push(P.format),x.push(P.type),x.push(P.generateMipmaps),x.push(P.premultiplyAlpha),x.push(P.flipY),x.push(P.unpackAlignment),x.push(P.colorSpace),x.join()}function X(P,x){let U=i.get(P);if(P.isVideoTexture&&Ht(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&U.__version!==P.version){let K=P.image;if(K===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{tt(U,P,x);return}}else P.isExternalTexture&&(U.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,U.__webglTexture,n.TEXTURE0+x)}function Z(P,x){let U=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&U.__version!==P.version){tt(U,P,x);return}e.bindTexture(n.TEXTURE_2D_ARRAY,U.__webglTexture,n.TEXTURE0+x)}function J(P,x){let U=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&U.__version!==P.version){tt(U,P,x);return}e.bindTexture(n.TEXTURE_3D,U.__webglTexture,n.TEXTURE0+x)}function Q(P,x){let U=i.get(P);if(P.version>0&&U.__version!==P.version){et(U,P,x);return}e.bindTexture(n.TEXTURE_CUBE_MAP,U.__webglTexture,n.TEXTURE0+x)}let ot={[Nl]:n.REPEAT,[ws]:n.CLAMP_TO_EDGE,[Fl]:n.MIRRORED_REPEAT},at={[li]:n.NEAREST,[Lg]:n.NEAREST_MIPMAP_NEAREST,[ba]:n.NEAREST_MIPMAP_LINEAR,[wi]:n.LINEAR,[gc]:n.LINEAR_MIPMAP_NEAREST,[Ds]:n.LINEAR_MIPMAP_LINEAR},vt={[Og]:n.NEVER,[Gg]:n.ALWAYS,[Bg]:n.LESS,[pf]:n.LEQUAL,[kg]:n.EQUAL,[Hg]:n.GEQUAL,[zg]:n.GREATER,[Vg]:n.NOTEQUAL};function yt(P,x){if(x.type===Vi&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===wi||x.magFilter===gc||x.magFilter===ba||x.magFilter===Ds||x.minFilter===wi||x.minFilter===gc||x.minFilter===ba||x.minFilter===Ds)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ot[x.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ot[x.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ot[x.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,at[x.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,at[x.minFilter]),x.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,vt[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===li||x.minFilter!==ba&&x.minFilter!==Ds||x.type===Vi&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||i.get(x).__currentAnisotropy){let U=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,U.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),i.get(x).__currentAnisotropy=x.anisotropy}}}function mt(P,x){let U=!1;P.__webglInit===void 0&&(P.__webglInit=!0,x.addEventListener("dispose",R));let K=x.source,it=f.get(K);it===void 0&&(it={},f.set(K,it));let nt=q(x);if(nt!==P.__cacheKey){it[nt]===void 0&&(it[nt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,U=!0),it[nt].usedTimes++;let Nt=it[P.__cacheKey];Nt!==void 0&&(it[P.__cacheKey].usedTimes--,Nt.usedTimes===0&&w(x)),P.__cacheKey=nt,P.__webglTexture=it[nt].texture}return U}function Qt(P,x,U){return Math.floor(Math.floor(P/U)/x)}function Yt(P,x,U,K){let nt=P.updateRanges;if(nt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,x.width,x.height,U,K,x.data);else{nt.sort((lt,_t)=>lt.start-_t.start);let Nt=0;for(let lt=1;lt<nt.length;lt++){let _t=nt[Nt],kt=nt[lt],Bt=_t.start+_t.count,Mt=Qt(kt.start,x.width,4),jt=Qt(_t.start,x.width,4);kt.start<=Bt+1&&Mt===jt&&Qt(kt.start+kt.count-1,x.width,4)===Mt?_t.count=Math.max(_t.count,kt.start+kt.count-_t.start):(++Nt,nt[Nt]=kt)}nt.length=Nt+1;let ut=n.getParameter(n.UNPACK_ROW_LENGTH),It=n.getParameter(n.UNPACK_SKIP_PIXELS),At=n.getParameter(n.UNPACK_SKIP_ROWS);n.pixelStorei(n.UNPACK_ROW_LENGTH,x.width);for(let lt=0,_t=nt.length;lt<_t;lt++){let kt=nt[lt],Bt=Math.floor(kt.start/4),Mt=Math.ceil(kt.count/4),jt=Bt%x.width,F=Math.floor(Bt/x.width),ft=Mt,pt=1;n.pixelStorei(n.UNPACK_SKIP_PIXELS,jt),n.pixelStorei(n.UNPACK_SKIP_ROWS,F),e.texSubImage2D(n.TEXTURE_2D,0,jt,F,ft,pt,U,K,x.data)}P.clearUpdateRanges(),n.pixelStorei(n.UNPACK_ROW_LENGTH,ut),n.pixelStorei(n.UNPACK_SKIP_PIXELS,It),n.pixelStorei(n.UNPACK_SKIP_ROWS,At)}}function tt(P,x,U){let K=n.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(K=n.TEXTURE_2D_ARRAY),x.isData3DTexture&&(K=n.TEXTURE_3D);let it=mt(P,x),nt=x.source;e.bindTexture(K,P.__webglTexture,n.TEXTURE0+U);let Nt=i.get(nt);if(nt.version!==Nt.__version||it===!0){e.activeTexture(n.TEXTURE0+U);let ut=fe.getPrimaries(fe.workingColorSpace),It=x.colorSpace===as?null:fe.getPrimaries(x.colorSpace),At=x.colorSpace===as||ut===It?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,At);let lt=v(x.image,!1,s.maxTextureSize);lt=Be(x,lt);let _t=r.convert(x.format,x.colorSpace),kt=r.convert(x.type),Bt=E(x.internalFormat,_t,kt,x.colorSpace,x.isVideoTexture);yt(K,x);let Mt,jt=x.mipmaps,F=x.isVideoTexture!==!0,ft=Nt.__version===void 0||it===!0,pt=nt.dataReady,Pt=D(x,lt);if(x.isDepthTexture)Bt=M(x.format===mo,x.type),ft&&(F?e.texStorage2D(n.TEXTURE_2D,1,Bt,lt.width,lt.height):e.texImage2D(n.TEXTURE_2D,0,Bt,lt.width,lt.height,0,_t,kt,null));else if(x.isDataTexture)if(jt.length>0){F&&ft&&e.texStorage2D(n.TEXTURE_2D,Pt,Bt,jt[0].width,jt[0].height);for(let ht=0,rt=jt.length;ht<rt;ht++)Mt=jt[ht],F?pt&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,Mt.width,Mt.height,_t,kt,Mt.data):e.texImage2D(n.TEXTURE_2D,ht,Bt,Mt.width,Mt.height,0,_t,kt,Mt.data);x.generateMipmaps=!1}else F?(ft&&e.texStorage2D(n.TEXTURE_2D,Pt,Bt,lt.width,lt.height),pt&&Yt(x,lt,_t,kt)):e.texImage2D(n.TEXTURE_2D,0,Bt,lt.width,lt.height,0,_t,kt,lt.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){F&&ft&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Pt,Bt,jt[0].width,jt[0].height,lt.depth);for(let ht=0,rt=jt.length;ht<rt;ht++)if(Mt=jt[ht],x.format!==ci)if(_t!==null)if(F){if(pt)if(x.layerUpdates.size>0){let Ot=Sf(Mt.width,Mt.height,x.format,x.type);for(let te of x.layerUpdates){let Re=Mt.data.subarray(te*Ot/Mt.data.BYTES_PER_ELEMENT,(te+1)*Ot/Mt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,te,Mt.width,Mt.height,1,_t,Re)}x.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,Mt.width,Mt.height,lt.depth,_t,Mt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ht,Bt,Mt.width,Mt.height,lt.depth,0,Mt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else F?pt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,Mt.width,Mt.height,lt.depth,_t,kt,Mt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ht,Bt,Mt.width,Mt.height,lt.depth,0,_t,kt,Mt.data)}else{F&&ft&&e.texStorage2D(n.TEXTURE_2D,Pt,Bt,jt[0].width,jt[0].height);for(let ht=0,rt=jt.length;ht<rt;ht++)Mt=jt[ht],x.format!==ci?_t!==null?F?pt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ht,0,0,Mt.width,Mt.height,_t,Mt.data):e.compressedTexImage2D(n.TEXTURE_2D,ht,Bt,Mt.width,Mt.height,0,Mt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):F?pt&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,Mt.width,Mt.height,_t,kt,Mt.data):e.texImage2D(n.TEXTURE_2D,ht,Bt,Mt.width,Mt.height,0,_t,kt,Mt.data)}else if(x.isDataArrayTexture)if(F){if(ft&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Pt,Bt,lt.width,lt.height,lt.depth),pt)if(x.layerUpdates.size>0){let ht=Sf(lt.width,lt.height,x.format,x.type);for(let rt of x.layerUpdates){let Ot=lt.data.subarray(rt*ht/lt.data.BYTES_PER_ELEMENT,(rt+1)*ht/lt.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,rt,lt.width,lt.height,1,_t,kt,Ot)}x.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,lt.width,lt.height,lt.depth,_t,kt,lt.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Bt,lt.width,lt.height,lt.depth,0,_t,kt,lt.data);else if(x.isData3DTexture)F?(ft&&e.texStorage3D(n.TEXTURE_3D,Pt,Bt,lt.width,lt.height,lt.depth),pt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,lt.width,lt.height,lt.depth,_t,kt,lt.data)):e.texImage3D(n.TEXTURE_3D,0,Bt,lt.width,lt.height,lt.depth,0,_t,kt,lt.data);else if(x.isFramebufferTexture){if(ft)if(F)e.texStorage2D(n.TEXTURE_2D,Pt,Bt,lt.width,lt.height);else{let ht=lt.width,rt=lt.height;for(let Ot=0;Ot<Pt;Ot++)e.texImage2D(n.TEXTURE_2D,Ot,Bt,ht,rt,0,_t,kt,null),ht>>=1,rt>>=1}}else if(jt.length>0){if(F&&ft){let ht=ve(jt[0]);e.texStorage2D(n.TEXTURE_2D,Pt,Bt,ht.width,ht.height)}for(let ht=0,rt=jt.length;ht<rt;ht++)Mt=jt[ht],F?pt&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,_t,kt,Mt):e.texImage2D(n.TEXTURE_2D,ht,Bt,_t,kt,Mt);x.generateMipmaps=!1}else if(F){if(ft){let ht=ve(lt);e.texStorage2D(n.TEXTURE_2D,Pt,Bt,ht.width,ht.height)}pt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,_t,kt,lt)}else e.texImage2D(n.TEXTURE_2D,0,Bt,_t,kt,lt);m(x)&&d(K),Nt.__version=nt.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function et(P,x,U){if(x.image.length!==6)return;let K=mt(P,x),it=x.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+U);let nt=i.get(it);if(it.version!==nt.__version||K===!0){e.activeTexture(n.TEXTURE0+U);let Nt=fe.getPrimaries(fe.workingColorSpace),ut=x.colorSpace===as?null:fe.getPrimaries(x.colorSpace),It=x.colorSpace===as||Nt===ut?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,x.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,x.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,It);let At=x.isCompressedTexture||x.image[0].isCompressedTexture,lt=x.image[0]&&x.image[0].isDataTexture,_t=[];for(let rt=0;rt<6;rt++)!At&&!lt?_t[rt]=v(x.image[rt],!0,s.maxCubemapSize):_t[rt]=lt?x.image[rt].image:x.image[rt],_t[rt]=Be(x,_t[rt]);let kt=_t[0],Bt=r.convert(x.format,x.colorSpace),Mt=r.convert(x.type),jt=E(x.internalFormat,Bt,Mt,x.colorSpace),F=x.isVideoTexture!==!0,ft=nt.__version===void 0||K===!0,pt=it.dataReady,Pt=D(x,kt);yt(n.TEXTURE_CUBE_MAP,x);let ht;if(At){F&&ft&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Pt,jt,kt.width,kt.height);for(let rt=0;rt<6;rt++){ht=_t[rt].mipmaps;for(let Ot=0;Ot<ht.length;Ot++){let te=ht[Ot];x.format!==ci?Bt!==null?F?pt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot,0,0,te.width,te.height,Bt,te.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot,jt,te.width,te.height,0,te.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):F?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot,0,0,te.width,te.height,Bt,Mt,te.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot,jt,te.width,te.height,0,Bt,Mt,te.data)}}}else{if(ht=x.mipmaps,F&&ft){ht.length>0&&Pt++;let rt=ve(_t[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Pt,jt,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(lt){F?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,_t[rt].width,_t[rt].height,Bt,Mt,_t[rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,jt,_t[rt].width,_t[rt].height,0,Bt,Mt,_t[rt].data);for(let Ot=0;Ot<ht.length;Ot++){let Re=ht[Ot].image[rt].image;F?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot+1,0,0,Re.width,Re.height,Bt,Mt,Re.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot+1,jt,Re.width,Re.height,0,Bt,Mt,Re.data)}}else{F?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Bt,Mt,_t[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,jt,Bt,Mt,_t[rt]);for(let Ot=0;Ot<ht.length;Ot++){let te=ht[Ot];F?pt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot+1,0,0,Bt,Mt,te.image[rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Ot+1,jt,Bt,Mt,te.image[rt])}}}m(x)&&d(n.TEXTURE_CUBE_MAP),nt.__version=it.version,x.onUpdate&&x.onUpdate(x)}P.__version=x.version}function St(P,x,U,K,it,nt){let Nt=r.convert(U.format,U.colorSpace),ut=r.convert(U.type),It=E(U.internalFormat,Nt,ut,U.colorSpace),At=i.get(x),lt=i.get(U);if(lt.__renderTarget=x,!At.__hasExternalTextures){let _t=Math.max(1,x.width>>nt),kt=Math.max(1,x.height>>nt);it===n.TEXTURE_3D||it===n.TEXTURE_2D_ARRAY?e.texImage3D(it,nt,It,_t,kt,x.depth,0,Nt,ut,null):e.texImage2D(it,nt,It,_t,kt,0,Nt,ut,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),Rt(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,K,it,lt.__webglTexture,0,we(x)):(it===n.TEXTURE_2D||it>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&it<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,K,it,lt.__webglTexture,nt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ft(P,x,U){if(n.bindRenderbuffer(n.RENDERBUFFER,P),x.depthBuffer){let K=x.depthTexture,it=K&&K.isDepthTexture?K.type:null,nt=M(x.stencilBuffer,it),Nt=x.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ut=we(x);Rt(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ut,nt,x.width,x.height):U?n.renderbufferStorageMultisample(n.RENDERBUFFER,ut,nt,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,nt,x.width,x.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Nt,n.RENDERBUFFER,P)}else{let K=x.textures;for(let it=0;it<K.length;it++){let nt=K[it],Nt=r.convert(nt.format,nt.colorSpace),ut=r.convert(nt.type),It=E(nt.internalFormat,Nt,ut,nt.colorSpace),At=we(x);U&&Rt(x)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,At,It,x.width,x.height):Rt(x)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,At,It,x.width,x.height):n.renderbufferStorage(n.RENDERBUFFER,It,x.width,x.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function xt(P,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");let K=i.get(x.depthTexture);K.__renderTarget=x,(!K.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),X(x.depthTexture,0);let it=K.__webglTexture,nt=we(x);if(x.depthTexture.format===to)Rt(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,it,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,it,0);else if(x.depthTexture.format===mo)Rt(x)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,it,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,it,0);else throw new Error("Unknown depthTexture format")}function Kt(P){let x=i.get(P),U=P.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==P.depthTexture){let K=P.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),K){let it=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,K.removeEventListener("dispose",it)};K.addEventListener("dispose",it),x.__depthDisposeCallback=it}x.__boundDepthTexture=K}if(P.depthTexture&&!x.__autoAllocateDepthBuffer){if(U)throw new Error("target.depthTexture not supported in Cube render targets");let K=P.texture.mipmaps;K&&K.length>0?xt(x.__webglFramebuffer[0],P):xt(x.__webglFramebuffer,P)}else if(U){x.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(e.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[K]),x.__webglDepthbuffer[K]===void 0)x.__webglDepthbuffer[K]=n.createRenderbuffer(),Ft(x.__webglDepthbuffer[K],P,!1);else{let it=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,nt=x.__webglDepthbuffer[K];n.bindRenderbuffer(n.RENDERBUFFER,nt),n.framebufferRenderbuffer(n.FRAMEBUFFER,it,n.RENDERBUFFER,nt)}}else{let K=P.texture.mipmaps;if(K&&K.length>0?e.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=n.createRenderbuffer(),Ft(x.__webglDepthbuffer,P,!1);else{let it=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,nt=x.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,nt),n.framebufferRenderbuffer(n.FRAMEBUFFER,it,n.RENDERBUFFER,nt)}}e.bindFramebuffer(n.FRAMEBUFFER,null)}function be(P,x,U){let K=i.get(P);x!==void 0&&St(K.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),U!==void 0&&Kt(P)}function L(P){let x=P.texture,U=i.get(P),K=i.get(x);P.addEventListener("dispose",N);let it=P.textures,nt=P.isWebGLCubeRenderTarget===!0,Nt=it.length>1;if(Nt||(K.__webglTexture===void 0&&(K.__webglTexture=n.createTexture()),K.__version=x.version,o.memory.textures++),nt){U.__webglFramebuffer=[];for(let ut=0;ut<6;ut++)if(x.mipmaps&&x.mipmaps.length>0){U.__webglFramebuffer[ut]=[];for(let It=0;It<x.mipmaps.length;It++)U.__webglFramebuffer[ut][It]=n.createFramebuffer()}else U.__webglFramebuffer[ut]=n.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){U.__webglFramebuffer=[];for(let ut=0;ut<x.mipmaps.length;ut++)U.__webglFramebuffer[ut]=n.createFramebuffer()}else U.__webglFramebuffer=n.createFramebuffer();if(Nt)for(let ut=0,It=it.length;ut<It;ut++){let At=i.get(it[ut]);At.__webglTexture===void 0&&(At.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Rt(P)===!1){U.__webglMultisampledFramebuffer=n.createFramebuffer(),U.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,U.__webglMultisampledFramebuffer);for(let ut=0;ut<it.length;ut++){let It=it[ut];U.__webglColorRenderbuffer[ut]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,U.__webglColorRenderbuffer[ut]);let At=r.convert(It.format,It.colorSpace),lt=r.convert(It.type),_t=E(It.internalFormat,At,lt,It.colorSpace,P.isXRRenderTarget===!0),kt=we(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,kt,_t,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,U.__webglColorRenderbuffer[ut])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(U.__webglDepthRenderbuffer=n.createRenderbuffer(),Ft(U.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(nt){e.bindTexture(n.TEXTURE_CUBE_MAP,K.__webglTexture),yt(n.TEXTURE_CUBE_MAP,x);for(let ut=0;ut<6;ut++)if(x.mipmaps&&x.mipmaps.length>0)for(let It=0;It<x.mipmaps.length;It++)St(U.__webglFramebuffer[ut][It],P,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ut,It);else St(U.__webglFramebuffer[ut],P,x,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ut,0);m(x)&&d(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Nt){for(let ut=0,It=it.length;ut<It;ut++){let At=it[ut],lt=i.get(At),_t=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(_t,lt.__webglTexture),yt(_t,At),St(U.__webglFramebuffer,P,At,n.COLOR_ATTACHMENT0+ut,_t,0),m(At)&&d(_t)}e.unbindTexture()}else{let ut=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(ut=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(ut,K.__webglTexture),yt(ut,x),x.mipmaps&&x.mipmaps.length>0)for(let It=0;It<x.mipmaps.length;It++)St(U.__webglFramebuffer[It],P,x,n.COLOR_ATTACHMENT0,ut,It);else St(U.__webglFramebuffer,P,x,n.COLOR_ATTACHMENT0,ut,0);m(x)&&d(ut),e.unbindTexture()}P.depthBuffer&&Kt(P)}function ue(P){let x=P.textures;for(let U=0,K=x.length;U<K;U++){let it=x[U];if(m(it)){let nt=T(P),Nt=i.get(it).__webglTexture;e.bindTexture(nt,Nt),d(nt),e.unbindTexture()}}}let $t=[],Gt=[];function Ut(P){if(P.samples>0){if(Rt(P)===!1){let x=P.textures,U=P.width,K=P.height,it=n.COLOR_BUFFER_BIT,nt=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Nt=i.get(P),ut=x.length>1;if(ut)for(let At=0;At<x.length;At++)e.bindFramebuffer(n.FRAMEBUFFER,Nt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+At,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,Nt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+At,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,Nt.__webglMultisampledFramebuffer);let It=P.texture.mipmaps;It&&It.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let At=0;At<x.length;At++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(it|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(it|=n.STENCIL_BUFFER_BIT)),ut){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Nt.__webglColorRenderbuffer[At]);let lt=i.get(x[At]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,lt,0)}n.blitFramebuffer(0,0,U,K,0,0,U,K,it,n.NEAREST),l===!0&&($t.length=0,Gt.length=0,$t.push(n.COLOR_ATTACHMENT0+At),P.depthBuffer&&P.resolveDepthBuffer===!1&&($t.push(nt),Gt.push(nt),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,Gt)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,$t))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ut)for(let At=0;At<x.length;At++){e.bindFramebuffer(n.FRAMEBUFFER,Nt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+At,n.RENDERBUFFER,Nt.__webglColorRenderbuffer[At]);let lt=i.get(x[At]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,Nt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+At,n.TEXTURE_2D,lt,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,Nt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){let x=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[x])}}}function we(P){return Math.min(s.maxSamples,P.samples)}function Rt(P){let x=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Ht(P){let x=o.render.frame;u.get(P)!==x&&(u.set(P,x),P.update())}function Be(P,x){let U=P.colorSpace,K=P.format,it=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||U!==Qs&&U!==as&&(fe.getTransfer(U)===Ce?(K!==ci||it!==Ci)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",U)),x}function ve(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=H,this.resetTextureUnits=G,this.setTexture2D=X,this.setTexture2DArray=Z,this.setTexture3D=J,this.setTextureCube=Q,this.rebindTextures=be,this.setupRenderTarget=L,this.updateRenderTargetMipmap=ue,this.updateMultisampleRenderTarget=Ut,this.setupDepthRenderbuffer=Kt,this.setupFrameBufferTexture=St,this.useMultisampledRTT=Rt}function y1(n,t){function e(i,s=as){let r,o=fe.getTransfer(s);if(i===Ci)return n.UNSIGNED_BYTE;if(i===vc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===xc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===af)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===lf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===rf)return n.BYTE;if(i===of)return n.SHORT;if(i===uo)return n.UNSIGNED_SHORT;if(i===_c)return n.INT;if(i===Ls)return n.UNSIGNED_INT;if(i===Vi)return n.FLOAT;if(i===fo)return n.HALF_FLOAT;if(i===cf)return n.ALPHA;if(i===hf)return n.RGB;if(i===ci)return n.RGBA;if(i===to)return n.DEPTH_COMPONENT;if(i===mo)return n.DEPTH_STENCIL;if(i===uf)return n.RED;if(i===yc)return n.RED_INTEGER;if(i===ff)return n.RG;if(i===Mc)return n.RG_INTEGER;if(i===Sc)return n.RGBA_INTEGER;if(i===wa||i===Ta||i===Ea||i===Aa)if(o===Ce)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===wa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Ea)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Aa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===wa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ta)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Ea)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Aa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===bc||i===wc||i===Tc||i===Ec)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===bc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Tc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ec)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ac||i===Cc||i===Rc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ac||i===Cc)return o===Ce?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Rc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Pc||i===Ic||i===Dc||i===Lc||i===Uc||i===Nc||i===Fc||i===Oc||i===Bc||i===kc||i===zc||i===Vc||i===Hc||i===Gc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Pc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ic)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Dc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Lc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Uc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Nc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Oc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Bc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===kc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===zc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Vc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Hc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Gc)return o===Ce?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Wc||i===Xc||i===qc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Wc)return o===Ce?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Xc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===qc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Yc||i===Zc||i===$c||i===Jc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Yc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Zc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===$c)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Jc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===po?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var M1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,S1=`
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

}`,Nf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new fa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ai({vertexShader:M1,fragmentShader:S1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new yn(new da(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ff=class extends Fi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,_=null,v=typeof XRWebGLBinding<"u",m=new Nf,d={},T=e.getContextAttributes(),E=null,M=null,D=[],R=[],N=new qt,B=null,w=new En;w.viewport=new Ze;let b=new En;b.viewport=new Ze;let C=[w,b],G=new rc,H=null,q=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let et=D[tt];return et===void 0&&(et=new oo,D[tt]=et),et.getTargetRaySpace()},this.getControllerGrip=function(tt){let et=D[tt];return et===void 0&&(et=new oo,D[tt]=et),et.getGripSpace()},this.getHand=function(tt){let et=D[tt];return et===void 0&&(et=new oo,D[tt]=et),et.getHandSpace()};function X(tt){let et=R.indexOf(tt.inputSource);if(et===-1)return;let St=D[et];St!==void 0&&(St.update(tt.inputSource,tt.frame,c||o),St.dispatchEvent({type:tt.type,data:tt.inputSource}))}function Z(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",Z),s.removeEventListener("inputsourceschange",J);for(let tt=0;tt<D.length;tt++){let et=R[tt];et!==null&&(R[tt]=null,D[tt].disconnect(et))}H=null,q=null,m.reset();for(let tt in d)delete d[tt];t.setRenderTarget(E),p=null,f=null,h=null,s=null,M=null,Yt.stop(),i.isPresenting=!1,t.setPixelRatio(B),t.setSize(N.width,N.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(E=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",Z),s.addEventListener("inputsourceschange",J),T.xrCompatible!==!0&&await e.makeXRCompatible(),B=t.getPixelRatio(),t.getSize(N),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let St=null,Ft=null,xt=null;T.depth&&(xt=T.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,St=T.stencil?mo:to,Ft=T.stencil?po:Ls);let Kt={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Kt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),M=new Oi(f.textureWidth,f.textureHeight,{format:ci,type:Ci,depthTexture:new ua(f.textureWidth,f.textureHeight,Ft,void 0,void 0,void 0,void 0,void 0,void 0,St),stencilBuffer:T.stencil,colorSpace:t.outputColorSpace,samples:T.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{let St={antialias:T.antialias,alpha:!0,depth:T.depth,stencil:T.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,St),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new Oi(p.framebufferWidth,p.framebufferHeight,{format:ci,type:Ci,colorSpace:t.outputColorSpace,stencilBuffer:T.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Yt.setContext(s),Yt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function J(tt){for(let et=0;et<tt.removed.length;et++){let St=tt.removed[et],Ft=R.indexOf(St);Ft>=0&&(R[Ft]=null,D[Ft].disconnect(St))}for(let et=0;et<tt.added.length;et++){let St=tt.added[et],Ft=R.indexOf(St);if(Ft===-1){for(let Kt=0;Kt<D.length;Kt++)if(Kt>=R.length){R.push(St),Ft=Kt;break}else if(R[Kt]===null){R[Kt]=St,Ft=Kt;break}if(Ft===-1)break}let xt=D[Ft];xt&&xt.connect(St)}}let Q=new z,ot=new z;function at(tt,et,St){Q.setFromMatrixPosition(et.matrixWorld),ot.setFromMatrixPosition(St.matrixWorld);let Ft=Q.distanceTo(ot),xt=et.projectionMatrix.elements,Kt=St.projectionMatrix.elements,be=xt[14]/(xt[10]-1),L=xt[14]/(xt[10]+1),ue=(xt[9]+1)/xt[5],$t=(xt[9]-1)/xt[5],Gt=(xt[8]-1)/xt[0],Ut=(Kt[8]+1)/Kt[0],we=be*Gt,Rt=be*Ut,Ht=Ft/(-Gt+Ut),Be=Ht*-Gt;if(et.matrixWorld.decompose(tt.position,tt.quaternion,tt.scale),tt.translateX(Be),tt.translateZ(Ht),tt.matrixWorld.compose(tt.position,tt.quaternion,tt.scale),tt.matrixWorldInverse.copy(tt.matrixWorld).invert(),xt[10]===-1)tt.projectionMatrix.copy(et.projectionMatrix),tt.projectionMatrixInverse.copy(et.projectionMatrixInverse);else{let ve=be+Ht,P=L+Ht,x=we-Be,U=Rt+(Ft-Be),K=ue*L/P*ve,it=$t*L/P*ve;tt.projectionMatrix.makePerspective(x,U,K,it,ve,P),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert()}}function vt(tt,et){et===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(et.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let et=tt.near,St=tt.far;m.texture!==null&&(m.depthNear>0&&(et=m.depthNear),m.depthFar>0&&(St=m.depthFar)),G.near=b.near=w.near=et,G.far=b.far=w.far=St,(H!==G.near||q!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),H=G.near,q=G.far),G.layers.mask=tt.layers.mask|6,w.layers.mask=G.layers.mask&3,b.layers.mask=G.layers.mask&5;let Ft=tt.parent,xt=G.cameras;vt(G,Ft);for(let Kt=0;Kt<xt.length;Kt++)vt(xt[Kt],Ft);xt.length===2?at(G,w,b):G.projectionMatrix.copy(w.projectionMatrix),yt(tt,G,Ft)};function yt(tt,et,St){St===null?tt.matrix.copy(et.matrixWorld):(tt.matrix.copy(St.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(et.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(et.projectionMatrix),tt.projectionMatrixInverse.copy(et.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=eo*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(tt){l=tt,f!==null&&(f.fixedFoveation=tt),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(tt){return d[tt]};let mt=null;function Qt(tt,et){if(u=et.getViewerPose(c||o),_=et,u!==null){let St=u.views;p!==null&&(t.setRenderTargetFramebuffer(M,p.framebuffer),t.setRenderTarget(M));let Ft=!1;St.length!==G.cameras.length&&(G.cameras.length=0,Ft=!0);for(let L=0;L<St.length;L++){let ue=St[L],$t=null;if(p!==null)$t=p.getViewport(ue);else{let Ut=h.getViewSubImage(f,ue);$t=Ut.viewport,L===0&&(t.setRenderTargetTextures(M,Ut.colorTexture,Ut.depthStencilTexture),t.setRenderTarget(M))}let Gt=C[L];Gt===void 0&&(Gt=new En,Gt.layers.enable(L),Gt.viewport=new Ze,C[L]=Gt),Gt.matrix.fromArray(ue.transform.matrix),Gt.matrix.decompose(Gt.position,Gt.quaternion,Gt.scale),Gt.projectionMatrix.fromArray(ue.projectionMatrix),Gt.projectionMatrixInverse.copy(Gt.projectionMatrix).invert(),Gt.viewport.set($t.x,$t.y,$t.width,$t.height),L===0&&(G.matrix.copy(Gt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ft===!0&&G.cameras.push(Gt)}let xt=s.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=i.getBinding();let L=h.getDepthInformation(St[0]);L&&L.isValid&&L.texture&&m.init(L,s.renderState)}if(xt&&xt.includes("camera-access")&&v){t.state.unbindTexture(),h=i.getBinding();for(let L=0;L<St.length;L++){let ue=St[L].camera;if(ue){let $t=d[ue];$t||($t=new fa,d[ue]=$t);let Gt=h.getCameraImage(ue);$t.sourceTexture=Gt}}}}for(let St=0;St<D.length;St++){let Ft=R[St],xt=D[St];Ft!==null&&xt!==void 0&&xt.update(Ft,et,c||o)}mt&&mt(tt,et),et.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:et}),_=null}let Yt=new x0;Yt.setAnimationLoop(Qt),this.setAnimationLoop=function(tt){mt=tt},this.dispose=function(){}}},or=new Ti,b1=new We;function w1(n,t){function e(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function i(m,d){d.color.getRGB(m.fogColor.value,xf(n)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,T,E,M){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(m,d):d.isMeshToonMaterial?(r(m,d),h(m,d)):d.isMeshPhongMaterial?(r(m,d),u(m,d)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,M)):d.isMeshMatcapMaterial?(r(m,d),_(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),v(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?l(m,d,T,E):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,e(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===Mn&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,e(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===Mn&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,e(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,e(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);let T=t.get(d),E=T.envMap,M=T.envMapRotation;E&&(m.envMap.value=E,or.copy(M),or.x*=-1,or.y*=-1,or.z*=-1,E.isCubeTexture&&E.isRenderTargetTexture===!1&&(or.y*=-1,or.z*=-1),m.envMapRotation.value.setFromMatrix4(b1.makeRotationFromEuler(or)),m.flipEnvMap.value=E.isCubeTexture&&E.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,T,E){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*T,m.scale.value=E*.5,d.map&&(m.map.value=d.map,e(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function u(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function h(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,T){m.ior.value=d.ior,d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Mn&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=T.texture,m.transmissionSamplerSize.value.set(T.width,T.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,d){d.matcap&&(m.matcap.value=d.matcap)}function v(m,d){let T=t.get(d).light;m.referencePosition.value.setFromMatrixPosition(T.matrixWorld),m.nearDistance.value=T.shadow.camera.near,m.farDistance.value=T.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function T1(n,t,e,i){let s={},r={},o=[],a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(T,E){let M=E.program;i.uniformBlockBinding(T,M)}function c(T,E){let M=s[T.id];M===void 0&&(_(T),M=u(T),s[T.id]=M,T.addEventListener("dispose",m));let D=E.program;i.updateUBOMapping(T,D);let R=t.render.frame;r[T.id]!==R&&(f(T),r[T.id]=R)}function u(T){let E=h();T.__bindingPointIndex=E;let M=n.createBuffer(),D=T.__size,R=T.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,D,R),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,E,M),M}function h(){for(let T=0;T<a;T++)if(o.indexOf(T)===-1)return o.push(T),T;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(T){let E=s[T.id],M=T.uniforms,D=T.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let R=0,N=M.length;R<N;R++){let B=Array.isArray(M[R])?M[R]:[M[R]];for(let w=0,b=B.length;w<b;w++){let C=B[w];if(p(C,R,w,D)===!0){let G=C.__offset,H=Array.isArray(C.value)?C.value:[C.value],q=0;for(let X=0;X<H.length;X++){let Z=H[X],J=v(Z);typeof Z=="number"||typeof Z=="boolean"?(C.__data[0]=Z,n.bufferSubData(n.UNIFORM_BUFFER,G+q,C.__data)):Z.isMatrix3?(C.__data[0]=Z.elements[0],C.__data[1]=Z.elements[1],C.__data[2]=Z.elements[2],C.__data[3]=0,C.__data[4]=Z.elements[3],C.__data[5]=Z.elements[4],C.__data[6]=Z.elements[5],C.__data[7]=0,C.__data[8]=Z.elements[6],C.__data[9]=Z.elements[7],C.__data[10]=Z.elements[8],C.__data[11]=0):(Z.toArray(C.__data,q),q+=J.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,G,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function p(T,E,M,D){let R=T.value,N=E+"_"+M;if(D[N]===void 0)return typeof R=="number"||typeof R=="boolean"?D[N]=R:D[N]=R.clone(),!0;{let B=D[N];if(typeof R=="number"||typeof R=="boolean"){if(B!==R)return D[N]=R,!0}else if(B.equals(R)===!1)return B.copy(R),!0}return!1}function _(T){let E=T.uniforms,M=0,D=16;for(let N=0,B=E.length;N<B;N++){let w=Array.isArray(E[N])?E[N]:[E[N]];for(let b=0,C=w.length;b<C;b++){let G=w[b],H=Array.isArray(G.value)?G.value:[G.value];for(let q=0,X=H.length;q<X;q++){let Z=H[q],J=v(Z),Q=M%D,ot=Q%J.boundary,at=Q+ot;M+=ot,at!==0&&D-at<J.storage&&(M+=D-at),G.__data=new Float32Array(J.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=M,M+=J.storage}}}let R=M%D;return R>0&&(M+=D-R),T.__size=M,T.__cache={},this}function v(T){let E={boundary:0,storage:0};return typeof T=="number"||typeof T=="boolean"?(E.boundary=4,E.storage=4):T.isVector2?(E.boundary=8,E.storage=8):T.isVector3||T.isColor?(E.boundary=16,E.storage=12):T.isVector4?(E.boundary=16,E.storage=16):T.isMatrix3?(E.boundary=48,E.storage=48):T.isMatrix4?(E.boundary=64,E.storage=64):T.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",T),E}function m(T){let E=T.target;E.removeEventListener("dispose",m);let M=o.indexOf(E.__bindingPointIndex);o.splice(M,1),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function d(){for(let T in s)n.deleteBuffer(s[T]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}var eh=class{constructor(t={}){let{canvas:e=Wg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=new Uint32Array(4),v=new Int32Array(4),m=null,d=null,T=[],E=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let M=this,D=!1;this._outputColorSpace=xn;let R=0,N=0,B=null,w=-1,b=null,C=new Ze,G=new Ze,H=null,q=new se(0),X=0,Z=e.width,J=e.height,Q=1,ot=null,at=null,vt=new Ze(0,0,Z,J),yt=new Ze(0,0,Z,J),mt=!1,Qt=new lo,Yt=!1,tt=!1,et=new We,St=new z,Ft=new Ze,xt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Kt=!1;function be(){return B===null?Q:1}let L=i;function ue(S,k){return e.getContext(S,k)}try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"180"}`),e.addEventListener("webglcontextlost",pt,!1),e.addEventListener("webglcontextrestored",Pt,!1),e.addEventListener("webglcontextcreationerror",ht,!1),L===null){let k="webgl2";if(L=ue(k,S),L===null)throw ue(k)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(S){throw console.error("THREE.WebGLRenderer: "+S.message),S}let $t,Gt,Ut,we,Rt,Ht,Be,ve,P,x,U,K,it,nt,Nt,ut,It,At,lt,_t,kt,Bt,Mt,jt;function F(){$t=new Gb(L),$t.init(),Bt=new y1(L,$t),Gt=new Fb(L,$t,t,Bt),Ut=new v1(L,$t),Gt.reversedDepthBuffer&&f&&Ut.buffers.depth.setReversed(!0),we=new qb(L),Rt=new r1,Ht=new x1(L,$t,Ut,Rt,Gt,Bt,we),Be=new Bb(M),ve=new Hb(M),P=new jy(L),Mt=new Ub(L,P),x=new Wb(L,P,we,Mt),U=new Zb(L,x,P,we),lt=new Yb(L,Gt,Ht),ut=new Ob(Rt),K=new s1(M,Be,ve,$t,Gt,Mt,ut),it=new w1(M,Rt),nt=new a1,Nt=new d1($t),At=new Lb(M,Be,ve,Ut,U,p,l),It=new g1(M,U,Gt),jt=new T1(L,we,Gt,Ut),_t=new Nb(L,$t,we),kt=new Xb(L,$t,we),we.programs=K.programs,M.capabilities=Gt,M.extensions=$t,M.properties=Rt,M.renderLists=nt,M.shadowMap=It,M.state=Ut,M.info=we}F();let ft=new Ff(M,L);this.xr=ft,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){let S=$t.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=$t.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(S){S!==void 0&&(Q=S,this.setSize(Z,J,!1))},this.getSize=function(S){return S.set(Z,J)},this.setSize=function(S,k,j=!0){if(ft.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Z=S,J=k,e.width=Math.floor(S*Q),e.height=Math.floor(k*Q),j===!0&&(e.style.width=S+"px",e.style.height=k+"px"),this.setViewport(0,0,S,k)},this.getDrawingBufferSize=function(S){return S.set(Z*Q,J*Q).floor()},this.setDrawingBufferSize=function(S,k,j){Z=S,J=k,Q=j,e.width=Math.floor(S*j),e.height=Math.floor(k*j),this.setViewport(0,0,S,k)},this.getCurrentViewport=function(S){return S.copy(C)},this.getViewport=function(S){return S.copy(vt)},this.setViewport=function(S,k,j,$){S.isVector4?vt.set(S.x,S.y,S.z,S.w):vt.set(S,k,j,$),Ut.viewport(C.copy(vt).multiplyScalar(Q).round())},this.getScissor=function(S){return S.copy(yt)},this.setScissor=function(S,k,j,$){S.isVector4?yt.set(S.x,S.y,S.z,S.w):yt.set(S,k,j,$),Ut.scissor(G.copy(yt).multiplyScalar(Q).round())},this.getScissorTest=function(){return mt},this.setScissorTest=function(S){Ut.setScissorTest(mt=S)},this.setOpaqueSort=function(S){ot=S},this.setTransparentSort=function(S){at=S},this.getClearColor=function(S){return S.copy(At.getClearColor())},this.setClearColor=function(){At.setClearColor(...arguments)},this.getClearAlpha=function(){return At.getClearAlpha()},this.setClearAlpha=function(){At.setClearAlpha(...arguments)},this.clear=function(S=!0,k=!0,j=!0){let $=0;if(S){let W=!1;if(B!==null){let dt=B.texture.format;W=dt===Sc||dt===Mc||dt===yc}if(W){let dt=B.texture.type,bt=dt===Ci||dt===Ls||dt===uo||dt===po||dt===vc||dt===xc,Dt=At.getClearColor(),Tt=At.getClearAlpha(),Xt=Dt.r,Zt=Dt.g,zt=Dt.b;bt?(_[0]=Xt,_[1]=Zt,_[2]=zt,_[3]=Tt,L.clearBufferuiv(L.COLOR,0,_)):(v[0]=Xt,v[1]=Zt,v[2]=zt,v[3]=Tt,L.clearBufferiv(L.COLOR,0,v))}else $|=L.COLOR_BUFFER_BIT}k&&($|=L.DEPTH_BUFFER_BIT),j&&($|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),L.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",pt,!1),e.removeEventListener("webglcontextrestored",Pt,!1),e.removeEventListener("webglcontextcreationerror",ht,!1),At.dispose(),nt.dispose(),Nt.dispose(),Rt.dispose(),Be.dispose(),ve.dispose(),U.dispose(),Mt.dispose(),jt.dispose(),K.dispose(),ft.dispose(),ft.removeEventListener("sessionstart",De),ft.removeEventListener("sessionend",Wn),On.stop()};function pt(S){S.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),D=!0}function Pt(){console.log("THREE.WebGLRenderer: Context Restored."),D=!1;let S=we.autoReset,k=It.enabled,j=It.autoUpdate,$=It.needsUpdate,W=It.type;F(),we.autoReset=S,It.enabled=k,It.autoUpdate=j,It.needsUpdate=$,It.type=W}function ht(S){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function rt(S){let k=S.target;k.removeEventListener("dispose",rt),Ot(k)}function Ot(S){te(S),Rt.remove(S)}function te(S){let k=Rt.get(S).programs;k!==void 0&&(k.forEach(function(j){K.releaseProgram(j)}),S.isShaderMaterial&&K.releaseShaderCache(S))}this.renderBufferDirect=function(S,k,j,$,W,dt){k===null&&(k=xt);let bt=W.isMesh&&W.matrixWorld.determinant()<0,Dt=Wi(S,k,j,$,W);Ut.setMaterial($,bt);let Tt=j.index,Xt=1;if($.wireframe===!0){if(Tt=x.getWireframeAttribute(j),Tt===void 0)return;Xt=2}let Zt=j.drawRange,zt=j.attributes.position,re=Zt.start*Xt,pe=(Zt.start+Zt.count)*Xt;dt!==null&&(re=Math.max(re,dt.start*Xt),pe=Math.min(pe,(dt.start+dt.count)*Xt)),Tt!==null?(re=Math.max(re,0),pe=Math.min(pe,Tt.count)):zt!=null&&(re=Math.max(re,0),pe=Math.min(pe,zt.count));let Ne=pe-re;if(Ne<0||Ne===1/0)return;Mt.setup(W,$,Dt,j,Tt);let Te,ne=_t;if(Tt!==null&&(Te=P.get(Tt),ne=kt,ne.setIndex(Te)),W.isMesh)$.wireframe===!0?(Ut.setLineWidth($.wireframeLinewidth*be()),ne.setMode(L.LINES)):ne.setMode(L.TRIANGLES);else if(W.isLine){let Wt=$.linewidth;Wt===void 0&&(Wt=1),Ut.setLineWidth(Wt*be()),W.isLineSegments?ne.setMode(L.LINES):W.isLineLoop?ne.setMode(L.LINE_LOOP):ne.setMode(L.LINE_STRIP)}else W.isPoints?ne.setMode(L.POINTS):W.isSprite&&ne.setMode(L.TRIANGLES);if(W.isBatchedMesh)if(W._multiDrawInstances!==null)no("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ne.renderMultiDrawInstances(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount,W._multiDrawInstances);else if($t.get("WEBGL_multi_draw"))ne.renderMultiDraw(W._multiDrawStarts,W._multiDrawCounts,W._multiDrawCount);else{let Wt=W._multiDrawStarts,Fe=W._multiDrawCounts,ce=W._multiDrawCount,Sn=Tt?P.get(Tt).bytesPerElement:1,ls=Rt.get($).currentProgram.getUniforms();for(let Rn=0;Rn<ce;Rn++)ls.setValue(L,"_gl_DrawID",Rn),ne.render(Wt[Rn]/Sn,Fe[Rn])}else if(W.isInstancedMesh)ne.renderInstances(re,Ne,W.count);else if(j.isInstancedBufferGeometry){let Wt=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,Wt);ne.renderInstances(re,Ne,Fe)}else ne.render(re,Ne)};function Re(S,k,j){S.transparent===!0&&S.side===Fn&&S.forceSinglePass===!1?(S.side=Mn,S.needsUpdate=!0,Us(S,k,j),S.side=bi,S.needsUpdate=!0,Us(S,k,j),S.side=Fn):Us(S,k,j)}this.compile=function(S,k,j=null){j===null&&(j=S),d=Nt.get(j),d.init(k),E.push(d),j.traverseVisible(function(W){W.isLight&&W.layers.test(k.layers)&&(d.pushLight(W),W.castShadow&&d.pushShadow(W))}),S!==j&&S.traverseVisible(function(W){W.isLight&&W.layers.test(k.layers)&&(d.pushLight(W),W.castShadow&&d.pushShadow(W))}),d.setupLights();let $=new Set;return S.traverse(function(W){if(!(W.isMesh||W.isPoints||W.isLine||W.isSprite))return;let dt=W.material;if(dt)if(Array.isArray(dt))for(let bt=0;bt<dt.length;bt++){let Dt=dt[bt];Re(Dt,j,W),$.add(Dt)}else Re(dt,j,W),$.add(dt)}),d=E.pop(),$},this.compileAsync=function(S,k,j=null){let $=this.compile(S,k,j);return new Promise(W=>{function dt(){if($.forEach(function(bt){Rt.get(bt).currentProgram.isReady()&&$.delete(bt)}),$.size===0){W(S);return}setTimeout(dt,10)}$t.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let de=null;function _n(S){de&&de(S)}function De(){On.stop()}function Wn(){On.start()}let On=new x0;On.setAnimationLoop(_n),typeof self<"u"&&On.setContext(self),this.setAnimationLoop=function(S){de=S,ft.setAnimationLoop(S),S===null?On.stop():On.start()},ft.addEventListener("sessionstart",De),ft.addEventListener("sessionend",Wn),this.render=function(S,k){if(k!==void 0&&k.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ft.enabled===!0&&ft.isPresenting===!0&&(ft.cameraAutoUpdate===!0&&ft.updateCamera(k),k=ft.getCamera()),S.isScene===!0&&S.onBeforeRender(M,S,k,B),d=Nt.get(S,E.length),d.init(k),E.push(d),et.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),Qt.setFromProjectionMatrix(et,Si,k.reversedDepth),tt=this.localClippingEnabled,Yt=ut.init(this.clippingPlanes,tt),m=nt.get(S,T.length),m.init(),T.push(m),ft.enabled===!0&&ft.isPresenting===!0){let dt=M.xr.getDepthSensingMesh();dt!==null&&Ri(dt,k,-1/0,M.sortObjects)}Ri(S,k,0,M.sortObjects),m.finish(),M.sortObjects===!0&&m.sort(ot,at),Kt=ft.enabled===!1||ft.isPresenting===!1||ft.hasDepthSensing()===!1,Kt&&At.addToRenderList(m,S),this.info.render.frame++,Yt===!0&&ut.beginShadows();let j=d.state.shadowsArray;It.render(j,S,k),Yt===!0&&ut.endShadows(),this.info.autoReset===!0&&this.info.reset();let $=m.opaque,W=m.transmissive;if(d.setupLights(),k.isArrayCamera){let dt=k.cameras;if(W.length>0)for(let bt=0,Dt=dt.length;bt<Dt;bt++){let Tt=dt[bt];Gi($,W,S,Tt)}Kt&&At.render(S);for(let bt=0,Dt=dt.length;bt<Dt;bt++){let Tt=dt[bt];Cn(m,S,Tt,Tt.viewport)}}else W.length>0&&Gi($,W,S,k),Kt&&At.render(S),Cn(m,S,k);B!==null&&N===0&&(Ht.updateMultisampleRenderTarget(B),Ht.updateRenderTargetMipmap(B)),S.isScene===!0&&S.onAfterRender(M,S,k),Mt.resetDefaultState(),w=-1,b=null,E.pop(),E.length>0?(d=E[E.length-1],Yt===!0&&ut.setGlobalState(M.clippingPlanes,d.state.camera)):d=null,T.pop(),T.length>0?m=T[T.length-1]:m=null};function Ri(S,k,j,$){if(S.visible===!1)return;if(S.layers.test(k.layers)){if(S.isGroup)j=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(k);else if(S.isLight)d.pushLight(S),S.castShadow&&d.pushShadow(S);else if(S.isSprite){if(!S.frustumCulled||Qt.intersectsSprite(S)){$&&Ft.setFromMatrixPosition(S.matrixWorld).applyMatrix4(et);let bt=U.update(S),Dt=S.material;Dt.visible&&m.push(S,bt,Dt,j,Ft.z,null)}}else if((S.isMesh||S.isLine||S.isPoints)&&(!S.frustumCulled||Qt.intersectsObject(S))){let bt=U.update(S),Dt=S.material;if($&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Ft.copy(S.boundingSphere.center)):(bt.boundingSphere===null&&bt.computeBoundingSphere(),Ft.copy(bt.boundingSphere.center)),Ft.applyMatrix4(S.matrixWorld).applyMatrix4(et)),Array.isArray(Dt)){let Tt=bt.groups;for(let Xt=0,Zt=Tt.length;Xt<Zt;Xt++){let zt=Tt[Xt],re=Dt[zt.materialIndex];re&&re.visible&&m.push(S,bt,re,j,Ft.z,zt)}}else Dt.visible&&m.push(S,bt,Dt,j,Ft.z,null)}}let dt=S.children;for(let bt=0,Dt=dt.length;bt<Dt;bt++)Ri(dt[bt],k,j,$)}function Cn(S,k,j,$){let W=S.opaque,dt=S.transmissive,bt=S.transparent;d.setupLightsView(j),Yt===!0&&ut.setGlobalState(M.clippingPlanes,j),$&&Ut.viewport(C.copy($)),W.length>0&&hi(W,k,j),dt.length>0&&hi(dt,k,j),bt.length>0&&hi(bt,k,j),Ut.buffers.depth.setTest(!0),Ut.buffers.depth.setMask(!0),Ut.buffers.color.setMask(!0),Ut.setPolygonOffset(!1)}function Gi(S,k,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[$.id]===void 0&&(d.state.transmissionRenderTarget[$.id]=new Oi(1,1,{generateMipmaps:!0,type:$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float")?fo:Ci,minFilter:Ds,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:fe.workingColorSpace}));let dt=d.state.transmissionRenderTarget[$.id],bt=$.viewport||C;dt.setSize(bt.z*M.transmissionResolutionScale,bt.w*M.transmissionResolutionScale);let Dt=M.getRenderTarget(),Tt=M.getActiveCubeFace(),Xt=M.getActiveMipmapLevel();M.setRenderTarget(dt),M.getClearColor(q),X=M.getClearAlpha(),X<1&&M.setClearColor(16777215,.5),M.clear(),Kt&&At.render(j);let Zt=M.toneMapping;M.toneMapping=os;let zt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),d.setupLightsView($),Yt===!0&&ut.setGlobalState(M.clippingPlanes,$),hi(S,j,$),Ht.updateMultisampleRenderTarget(dt),Ht.updateRenderTargetMipmap(dt),$t.has("WEBGL_multisampled_render_to_texture")===!1){let re=!1;for(let pe=0,Ne=k.length;pe<Ne;pe++){let Te=k[pe],ne=Te.object,Wt=Te.geometry,Fe=Te.material,ce=Te.group;if(Fe.side===Fn&&ne.layers.test($.layers)){let Sn=Fe.side;Fe.side=Mn,Fe.needsUpdate=!0,Mo(ne,j,$,Wt,Fe,ce),Fe.side=Sn,Fe.needsUpdate=!0,re=!0}}re===!0&&(Ht.updateMultisampleRenderTarget(dt),Ht.updateRenderTargetMipmap(dt))}M.setRenderTarget(Dt,Tt,Xt),M.setClearColor(q,X),zt!==void 0&&($.viewport=zt),M.toneMapping=Zt}function hi(S,k,j){let $=k.isScene===!0?k.overrideMaterial:null;for(let W=0,dt=S.length;W<dt;W++){let bt=S[W],Dt=bt.object,Tt=bt.geometry,Xt=bt.group,Zt=bt.material;Zt.allowOverride===!0&&$!==null&&(Zt=$),Dt.layers.test(j.layers)&&Mo(Dt,k,j,Tt,Zt,Xt)}}function Mo(S,k,j,$,W,dt){S.onBeforeRender(M,k,j,$,W,dt),S.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),W.onBeforeRender(M,k,j,$,S,dt),W.transparent===!0&&W.side===Fn&&W.forceSinglePass===!1?(W.side=Mn,W.needsUpdate=!0,M.renderBufferDirect(j,k,$,W,S,dt),W.side=bi,W.needsUpdate=!0,M.renderBufferDirect(j,k,$,W,S,dt),W.side=Fn):M.renderBufferDirect(j,k,$,W,S,dt),S.onAfterRender(M,k,j,$,W,dt)}function Us(S,k,j){k.isScene!==!0&&(k=xt);let $=Rt.get(S),W=d.state.lights,dt=d.state.shadowsArray,bt=W.state.version,Dt=K.getParameters(S,W.state,dt,k,j),Tt=K.getProgramCacheKey(Dt),Xt=$.programs;$.environment=S.isMeshStandardMaterial?k.environment:null,$.fog=k.fog,$.envMap=(S.isMeshStandardMaterial?ve:Be).get(S.envMap||$.environment),$.envMapRotation=$.environment!==null&&S.envMap===null?k.environmentRotation:S.envMapRotation,Xt===void 0&&(S.addEventListener("dispose",rt),Xt=new Map,$.programs=Xt);let Zt=Xt.get(Tt);if(Zt!==void 0){if($.currentProgram===Zt&&$.lightsStateVersion===bt)return Pa(S,Dt),Zt}else Dt.uniforms=K.getUniforms(S),S.onBeforeCompile(Dt,M),Zt=K.acquireProgram(Dt,Tt),Xt.set(Tt,Zt),$.uniforms=Dt.uniforms;let zt=$.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(zt.clippingPlanes=ut.uniform),Pa(S,Dt),$.needsLights=Ns(S),$.lightsStateVersion=bt,$.needsLights&&(zt.ambientLightColor.value=W.state.ambient,zt.lightProbe.value=W.state.probe,zt.directionalLights.value=W.state.directional,zt.directionalLightShadows.value=W.state.directionalShadow,zt.spotLights.value=W.state.spot,zt.spotLightShadows.value=W.state.spotShadow,zt.rectAreaLights.value=W.state.rectArea,zt.ltc_1.value=W.state.rectAreaLTC1,zt.ltc_2.value=W.state.rectAreaLTC2,zt.pointLights.value=W.state.point,zt.pointLightShadows.value=W.state.pointShadow,zt.hemisphereLights.value=W.state.hemi,zt.directionalShadowMap.value=W.state.directionalShadowMap,zt.directionalShadowMatrix.value=W.state.directionalShadowMatrix,zt.spotShadowMap.value=W.state.spotShadowMap,zt.spotLightMatrix.value=W.state.spotLightMatrix,zt.spotLightMap.value=W.state.spotLightMap,zt.pointShadowMap.value=W.state.pointShadowMap,zt.pointShadowMatrix.value=W.state.pointShadowMatrix),$.currentProgram=Zt,$.uniformsList=null,Zt}function Ra(S){if(S.uniformsList===null){let k=S.currentProgram.getUniforms();S.uniformsList=xo.seqWithValue(k.seq,S.uniforms)}return S.uniformsList}function Pa(S,k){let j=Rt.get(S);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function Wi(S,k,j,$,W){k.isScene!==!0&&(k=xt),Ht.resetTextureUnits();let dt=k.fog,bt=$.isMeshStandardMaterial?k.environment:null,Dt=B===null?M.outputColorSpace:B.isXRRenderTarget===!0?B.texture.colorSpace:Qs,Tt=($.isMeshStandardMaterial?ve:Be).get($.envMap||bt),Xt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,Zt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),zt=!!j.morphAttributes.position,re=!!j.morphAttributes.normal,pe=!!j.morphAttributes.color,Ne=os;$.toneMapped&&(B===null||B.isXRRenderTarget===!0)&&(Ne=M.toneMapping);let Te=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,ne=Te!==void 0?Te.length:0,Wt=Rt.get($),Fe=d.state.lights;if(Yt===!0&&(tt===!0||S!==b)){let ln=S===b&&$.id===w;ut.setState($,S,ln)}let ce=!1;$.version===Wt.__version?(Wt.needsLights&&Wt.lightsStateVersion!==Fe.state.version||Wt.outputColorSpace!==Dt||W.isBatchedMesh&&Wt.batching===!1||!W.isBatchedMesh&&Wt.batching===!0||W.isBatchedMesh&&Wt.batchingColor===!0&&W.colorTexture===null||W.isBatchedMesh&&Wt.batchingColor===!1&&W.colorTexture!==null||W.isInstancedMesh&&Wt.instancing===!1||!W.isInstancedMesh&&Wt.instancing===!0||W.isSkinnedMesh&&Wt.skinning===!1||!W.isSkinnedMesh&&Wt.skinning===!0||W.isInstancedMesh&&Wt.instancingColor===!0&&W.instanceColor===null||W.isInstancedMesh&&Wt.instancingColor===!1&&W.instanceColor!==null||W.isInstancedMesh&&Wt.instancingMorph===!0&&W.morphTexture===null||W.isInstancedMesh&&Wt.instancingMorph===!1&&W.morphTexture!==null||Wt.envMap!==Tt||$.fog===!0&&Wt.fog!==dt||Wt.numClippingPlanes!==void 0&&(Wt.numClippingPlanes!==ut.numPlanes||Wt.numIntersection!==ut.numIntersection)||Wt.vertexAlphas!==Xt||Wt.vertexTangents!==Zt||Wt.morphTargets!==zt||Wt.morphNormals!==re||Wt.morphColors!==pe||Wt.toneMapping!==Ne||Wt.morphTargetsCount!==ne)&&(ce=!0):(ce=!0,Wt.__version=$.version);let Sn=Wt.currentProgram;ce===!0&&(Sn=Us($,k,W));let ls=!1,Rn=!1,Fs=!1,Oe=Sn.getUniforms(),Pn=Wt.uniforms;if(Ut.useProgram(Sn.program)&&(ls=!0,Rn=!0,Fs=!0),$.id!==w&&(w=$.id,Rn=!0),ls||b!==S){Ut.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),Oe.setValue(L,"projectionMatrix",S.projectionMatrix),Oe.setValue(L,"viewMatrix",S.matrixWorldInverse);let cn=Oe.map.cameraPosition;cn!==void 0&&cn.setValue(L,St.setFromMatrixPosition(S.matrixWorld)),Gt.logarithmicDepthBuffer&&Oe.setValue(L,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Oe.setValue(L,"isOrthographic",S.isOrthographicCamera===!0),b!==S&&(b=S,Rn=!0,Fs=!0)}if(W.isSkinnedMesh){Oe.setOptional(L,W,"bindMatrix"),Oe.setOptional(L,W,"bindMatrixInverse");let ln=W.skeleton;ln&&(ln.boneTexture===null&&ln.computeBoneTexture(),Oe.setValue(L,"boneTexture",ln.boneTexture,Ht))}W.isBatchedMesh&&(Oe.setOptional(L,W,"batchingTexture"),Oe.setValue(L,"batchingTexture",W._matricesTexture,Ht),Oe.setOptional(L,W,"batchingIdTexture"),Oe.setValue(L,"batchingIdTexture",W._indirectTexture,Ht),Oe.setOptional(L,W,"batchingColorTexture"),W._colorsTexture!==null&&Oe.setValue(L,"batchingColorTexture",W._colorsTexture,Ht));let Bn=j.morphAttributes;if((Bn.position!==void 0||Bn.normal!==void 0||Bn.color!==void 0)&&lt.update(W,j,Sn),(Rn||Wt.receiveShadow!==W.receiveShadow)&&(Wt.receiveShadow=W.receiveShadow,Oe.setValue(L,"receiveShadow",W.receiveShadow)),$.isMeshGouraudMaterial&&$.envMap!==null&&(Pn.envMap.value=Tt,Pn.flipEnvMap.value=Tt.isCubeTexture&&Tt.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&k.environment!==null&&(Pn.envMapIntensity.value=k.environmentIntensity),Rn&&(Oe.setValue(L,"toneMappingExposure",M.toneMappingExposure),Wt.needsLights&&dh(Pn,Fs),dt&&$.fog===!0&&it.refreshFogUniforms(Pn,dt),it.refreshMaterialUniforms(Pn,$,Q,J,d.state.transmissionRenderTarget[S.id]),xo.upload(L,Ra(Wt),Pn,Ht)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(xo.upload(L,Ra(Wt),Pn,Ht),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Oe.setValue(L,"center",W.center),Oe.setValue(L,"modelViewMatrix",W.modelViewMatrix),Oe.setValue(L,"normalMatrix",W.normalMatrix),Oe.setValue(L,"modelMatrix",W.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){let ln=$.uniformsGroups;for(let cn=0,cs=ln.length;cn<cs;cn++){let ti=ln[cn];jt.update(ti,Sn),jt.bind(ti,Sn)}}return Sn}function dh(S,k){S.ambientLightColor.needsUpdate=k,S.lightProbe.needsUpdate=k,S.directionalLights.needsUpdate=k,S.directionalLightShadows.needsUpdate=k,S.pointLights.needsUpdate=k,S.pointLightShadows.needsUpdate=k,S.spotLights.needsUpdate=k,S.spotLightShadows.needsUpdate=k,S.rectAreaLights.needsUpdate=k,S.hemisphereLights.needsUpdate=k}function Ns(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return N},this.getRenderTarget=function(){return B},this.setRenderTargetTextures=function(S,k,j){let $=Rt.get(S);$.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Rt.get(S.texture).__webglTexture=k,Rt.get(S.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,k){let j=Rt.get(S);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0};let Ia=L.createFramebuffer();this.setRenderTarget=function(S,k=0,j=0){B=S,R=k,N=j;let $=!0,W=null,dt=!1,bt=!1;if(S){let Tt=Rt.get(S);if(Tt.__useDefaultFramebuffer!==void 0)Ut.bindFramebuffer(L.FRAMEBUFFER,null),$=!1;else if(Tt.__webglFramebuffer===void 0)Ht.setupRenderTarget(S);else if(Tt.__hasExternalTextures)Ht.rebindTextures(S,Rt.get(S.texture).__webglTexture,Rt.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let zt=S.depthTexture;if(Tt.__boundDepthTexture!==zt){if(zt!==null&&Rt.has(zt)&&(S.width!==zt.image.width||S.height!==zt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Ht.setupDepthRenderbuffer(S)}}let Xt=S.texture;(Xt.isData3DTexture||Xt.isDataArrayTexture||Xt.isCompressedArrayTexture)&&(bt=!0);let Zt=Rt.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Zt[k])?W=Zt[k][j]:W=Zt[k],dt=!0):S.samples>0&&Ht.useMultisampledRTT(S)===!1?W=Rt.get(S).__webglMultisampledFramebuffer:Array.isArray(Zt)?W=Zt[j]:W=Zt,C.copy(S.viewport),G.copy(S.scissor),H=S.scissorTest}else C.copy(vt).multiplyScalar(Q).floor(),G.copy(yt).multiplyScalar(Q).floor(),H=mt;if(j!==0&&(W=Ia),Ut.bindFramebuffer(L.FRAMEBUFFER,W)&&$&&Ut.drawBuffers(S,W),Ut.viewport(C),Ut.scissor(G),Ut.setScissorTest(H),dt){let Tt=Rt.get(S.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+k,Tt.__webglTexture,j)}else if(bt){let Tt=k;for(let Xt=0;Xt<S.textures.length;Xt++){let Zt=Rt.get(S.textures[Xt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+Xt,Zt.__webglTexture,j,Tt)}}else if(S!==null&&j!==0){let Tt=Rt.get(S.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Tt.__webglTexture,j)}w=-1},this.readRenderTargetPixels=function(S,k,j,$,W,dt,bt,Dt=0){if(!(S&&S.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Tt=Rt.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&bt!==void 0&&(Tt=Tt[bt]),Tt){Ut.bindFramebuffer(L.FRAMEBUFFER,Tt);try{let Xt=S.textures[Dt],Zt=Xt.format,zt=Xt.type;if(!Gt.textureFormatReadable(Zt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Gt.textureTypeReadable(zt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=S.width-$&&j>=0&&j<=S.height-W&&(S.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+Dt),L.readPixels(k,j,$,W,Bt.convert(Zt),Bt.convert(zt),dt))}finally{let Xt=B!==null?Rt.get(B).__webglFramebuffer:null;Ut.bindFramebuffer(L.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(S,k,j,$,W,dt,bt,Dt=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Tt=Rt.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&bt!==void 0&&(Tt=Tt[bt]),Tt)if(k>=0&&k<=S.width-$&&j>=0&&j<=S.height-W){Ut.bindFramebuffer(L.FRAMEBUFFER,Tt);let Xt=S.textures[Dt],Zt=Xt.format,zt=Xt.type;if(!Gt.textureFormatReadable(Zt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Gt.textureTypeReadable(zt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let re=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,re),L.bufferData(L.PIXEL_PACK_BUFFER,dt.byteLength,L.STREAM_READ),S.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+Dt),L.readPixels(k,j,$,W,Bt.convert(Zt),Bt.convert(zt),0);let pe=B!==null?Rt.get(B).__webglFramebuffer:null;Ut.bindFramebuffer(L.FRAMEBUFFER,pe);let Ne=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await Xg(L,Ne,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,re),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,dt),L.deleteBuffer(re),L.deleteSync(Ne),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,k=null,j=0){let $=Math.pow(2,-j),W=Math.floor(S.image.width*$),dt=Math.floor(S.image.height*$),bt=k!==null?k.x:0,Dt=k!==null?k.y:0;Ht.setTexture2D(S,0),L.copyTexSubImage2D(L.TEXTURE_2D,j,0,0,bt,Dt,W,dt),Ut.unbindTexture()};let Pi=L.createFramebuffer(),en=L.createFramebuffer();this.copyTextureToTexture=function(S,k,j=null,$=null,W=0,dt=null){dt===null&&(W!==0?(no("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),dt=W,W=0):dt=0);let bt,Dt,Tt,Xt,Zt,zt,re,pe,Ne,Te=S.isCompressedTexture?S.mipmaps[dt]:S.image;if(j!==null)bt=j.max.x-j.min.x,Dt=j.max.y-j.min.y,Tt=j.isBox3?j.max.z-j.min.z:1,Xt=j.min.x,Zt=j.min.y,zt=j.isBox3?j.min.z:0;else{let Bn=Math.pow(2,-W);bt=Math.floor(Te.width*Bn),Dt=Math.floor(Te.height*Bn),S.isDataArrayTexture?Tt=Te.depth:S.isData3DTexture?Tt=Math.floor(Te.depth*Bn):Tt=1,Xt=0,Zt=0,zt=0}$!==null?(re=$.x,pe=$.y,Ne=$.z):(re=0,pe=0,Ne=0);let ne=Bt.convert(k.format),Wt=Bt.convert(k.type),Fe;k.isData3DTexture?(Ht.setTexture3D(k,0),Fe=L.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(Ht.setTexture2DArray(k,0),Fe=L.TEXTURE_2D_ARRAY):(Ht.setTexture2D(k,0),Fe=L.TEXTURE_2D),L.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,k.flipY),L.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),L.pixelStorei(L.UNPACK_ALIGNMENT,k.unpackAlignment);let ce=L.getParameter(L.UNPACK_ROW_LENGTH),Sn=L.getParameter(L.UNPACK_IMAGE_HEIGHT),ls=L.getParameter(L.UNPACK_SKIP_PIXELS),Rn=L.getParameter(L.UNPACK_SKIP_ROWS),Fs=L.getParameter(L.UNPACK_SKIP_IMAGES);L.pixelStorei(L.UNPACK_ROW_LENGTH,Te.width),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,Te.height),L.pixelStorei(L.UNPACK_SKIP_PIXELS,Xt),L.pixelStorei(L.UNPACK_SKIP_ROWS,Zt),L.pixelStorei(L.UNPACK_SKIP_IMAGES,zt);let Oe=S.isDataArrayTexture||S.isData3DTexture,Pn=k.isDataArrayTexture||k.isData3DTexture;if(S.isDepthTexture){let Bn=Rt.get(S),ln=Rt.get(k),cn=Rt.get(Bn.__renderTarget),cs=Rt.get(ln.__renderTarget);Ut.bindFramebuffer(L.READ_FRAMEBUFFER,cn.__webglFramebuffer),Ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,cs.__webglFramebuffer);for(let ti=0;ti<Tt;ti++)Oe&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Rt.get(S).__webglTexture,W,zt+ti),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Rt.get(k).__webglTexture,dt,Ne+ti)),L.blitFramebuffer(Xt,Zt,bt,Dt,re,pe,bt,Dt,L.DEPTH_BUFFER_BIT,L.NEAREST);Ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),Ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(W!==0||S.isRenderTargetTexture||Rt.has(S)){let Bn=Rt.get(S),ln=Rt.get(k);Ut.bindFramebuffer(L.READ_FRAMEBUFFER,Pi),Ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,en);for(let cn=0;cn<Tt;cn++)Oe?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Bn.__webglTexture,W,zt+cn):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Bn.__webglTexture,W),Pn?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,ln.__webglTexture,dt,Ne+cn):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,ln.__webglTexture,dt),W!==0?L.blitFramebuffer(Xt,Zt,bt,Dt,re,pe,bt,Dt,L.COLOR_BUFFER_BIT,L.NEAREST):Pn?L.copyTexSubImage3D(Fe,dt,re,pe,Ne+cn,Xt,Zt,bt,Dt):L.copyTexSubImage2D(Fe,dt,re,pe,Xt,Zt,bt,Dt);Ut.bindFramebuffer(L.READ_FRAMEBUFFER,null),Ut.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else Pn?S.isDataTexture||S.isData3DTexture?L.texSubImage3D(Fe,dt,re,pe,Ne,bt,Dt,Tt,ne,Wt,Te.data):k.isCompressedArrayTexture?L.compressedTexSubImage3D(Fe,dt,re,pe,Ne,bt,Dt,Tt,ne,Te.data):L.texSubImage3D(Fe,dt,re,pe,Ne,bt,Dt,Tt,ne,Wt,Te):S.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,dt,re,pe,bt,Dt,ne,Wt,Te.data):S.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,dt,re,pe,Te.width,Te.height,ne,Te.data):L.texSubImage2D(L.TEXTURE_2D,dt,re,pe,bt,Dt,ne,Wt,Te);L.pixelStorei(L.UNPACK_ROW_LENGTH,ce),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,Sn),L.pixelStorei(L.UNPACK_SKIP_PIXELS,ls),L.pixelStorei(L.UNPACK_SKIP_ROWS,Rn),L.pixelStorei(L.UNPACK_SKIP_IMAGES,Fs),dt===0&&k.generateMipmaps&&L.generateMipmap(Fe),Ut.unbindTexture()},this.initRenderTarget=function(S){Rt.get(S).__webglFramebuffer===void 0&&Ht.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Ht.setTextureCube(S,0):S.isData3DTexture?Ht.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Ht.setTexture2DArray(S,0):Ht.setTexture2D(S,0),Ut.unbindTexture()},this.resetState=function(){R=0,N=0,B=null,Ut.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Si}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=fe._getDrawingBufferColorSpace(t),e.unpackColorSpace=fe._getUnpackColorSpace()}};var cr=256;function E1(n,t){let e=[];if(n.grid){let[i,s]=n.grid;for(let r=0;r<s;++r)for(let o=0;o<i;++o){let a=o+r*i;o+1<i&&e.push(a,a+1),r+1<s&&e.push(a,a+i)}return e}for(let i=0;i<t.length;i+=3)for(let s=0;s<3;++s)e.push(t[i+s],t[i+(s+1)%3]);return e}function A1(n){let t=new Float32Array(3*(cr+1)),e=new se;for(let i=0;i<=cr;++i){let s=i===cr?NaN:i/(cr-1);e.setRGB(...Lo(s,[0,1],n.diverging),xn),e.toArray(t,3*i)}return t}var ih=class{constructor(t,e,i,s){this.positions=i,this.frames=s,this.particles=t.particles,this.geometry=new tn,this.place=new Ye(new Float32Array(3*this.particles),3),this.place.setUsage(go),this.colours=new Ye(new Float32Array(3*this.particles).fill(1),3),this.colours.setUsage(go),this.geometry.setAttribute("position",this.place),this.geometry.setAttribute("color",this.colours),this.geometry.setIndex(new Ye(new Uint32Array(e),1));let r={polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1};this.coloured=new ki({side:Fn,vertexColors:!0,...r}),this.front=new ki({side:bi,...r}),this.back=new ki({side:Mn,...r}),this.tinted=new ki({side:Fn,transparent:!0,opacity:.72,...r}),this.surface=new yn(this.geometry,this.coloured),this.reverse=new yn(this.geometry,this.back);let o=new tn;o.setAttribute("position",this.place),o.setIndex(E1(t,e)),this.threads=new As(o,new ss({transparent:!0,opacity:.22})),this.object=new kn,this.object.add(this.surface,this.reverse,this.threads);for(let a of this.object.children)a.frustumCulled=!1;this.setField(null,null),this.applyTheme()}applyTheme(){this.front.color.set(qe("--cloth-front")),this.back.color.set(qe("--cloth-back")),this.threads.material.color.set(qe("--thread")),this.tint&&this.tinted.color.set(qe(this.tint))}setTint(t){this.tint=t,this.chooseMaterial(),this.applyTheme()}chooseMaterial(){this.surface.material=this.tint?this.tinted:this.field?this.coloured:this.front,this.reverse.visible=!this.field&&!this.tint}setField(t,e){this.field=t,this.values=e,this.shades=t?A1(t):null,this.chooseMaterial(),this.frame!==void 0&&this.colour()}setFrame(t){if(this.frame=t,this.object.visible=t<this.frames,!this.object.visible)return!1;let e=3*this.particles*t;return this.place.array.set(this.positions.subarray(e,e+3*this.particles)),this.place.needsUpdate=!0,this.geometry.computeVertexNormals(),this.geometry.boundingSphere=null,this.colour(),!0}colour(){if(!this.field||this.frame>=this.frames)return;let[t,e]=this.field.range,i=(cr-1)/(e-t||1),s=this.particles*this.frame;for(let r=0;r<this.particles;++r){let o=this.values?this.values[s+r]:NaN,a=Number.isFinite(o)?Math.max(0,Math.min(cr-1,Math.round((o-t)*i))):cr;for(let l=0;l<3;++l)this.colours.array[3*r+l]=this.shades[3*a+l]}this.colours.needsUpdate=!0}valueAt(t){return this.values&&this.frame<this.frames?this.values[this.particles*this.frame+t]:NaN}positionAt(t,e){return e.fromArray(this.positions,3*(this.particles*this.frame+t))}};function w0(n,t,e){let i=e.getCenter(new z),s=e.getSize(new z).length(),r=10**Math.round(Math.log10(s/12)),o=2*Math.ceil(.9*s/r),a=new ya(o*r,o);a.material.transparent=!0,a.material.vertexColors=!1;let l=new Vn().setFromUnitVectors(new z(0,1,0),t);a.quaternion.copy(l);let u=(n===null?C1(e,t)-.02*s:n)-.004*s,h=n===null?u-i.dot(t):u-i.z;a.position.copy(i).addScaledVector(n===null?t:new z(0,0,1),h);let f={applyTheme(){a.material.color.set(qe("--grid")),a.material.opacity=n===null?.35:.8}};return f.applyTheme(),{object:a,parts:[f],setFrame(){}}}function C1(n,t){let e=1/0;for(let i=0;i<8;++i){let s=new z(i&1?n.max.x:n.min.x,i&2?n.max.y:n.min.y,i&4?n.max.z:n.min.z);e=Math.min(e,s.dot(t))}return e}var sh=5*Math.PI/180,R1=.97;function rh(n,t,e){let{eye:i,controls:s,home:{up:r}}=n,o=i.position.clone().sub(s.target).applyAxisAngle(r,t),a=new z().crossVectors(o,r).normalize(),l=o.clone().applyAxisAngle(a,e),c=Math.abs(l.clone().normalize().dot(r))>R1;i.position.copy(s.target).add(c?o:l),s.update()}function T0(n,t){let{eye:e,controls:i}=n;e.position.sub(i.target).multiplyScalar(t).add(i.target),i.update()}function E0(n){let t={a:()=>rh(n,-sh,0),d:()=>rh(n,sh,0),w:()=>rh(n,0,sh),s:()=>rh(n,0,-sh),"+":()=>T0(n,.9),"-":()=>T0(n,1.1111111111111112),0:()=>n.lookHome()};document.addEventListener("keydown",e=>{/^(SELECT|TEXTAREA)$/.test(e.target.tagName)||e.ctrlKey||e.metaKey||e.altKey||t[e.key.toLowerCase()]?.()})}var Bf=48,A0=.023;function C0(n){let t=document.createElement("canvas"),e=t.getContext("2d"),i=`600 ${Bf*.6}px system-ui, sans-serif`;e.font=i,t.width=Math.ceil(e.measureText(n).width)+24,t.height=Bf;let s=new tr(t);s.colorSpace=xn;let r=new ca(new ao({map:s,transparent:!0,depthWrite:!1,sizeAttenuation:!1}));r.scale.set(A0*t.width/Bf,A0,1),r.center.set(.5,-.3);let o={object:r,applyTheme(){e.clearRect(0,0,t.width,t.height),e.font=i,e.textAlign="center",e.textBaseline="middle",e.fillStyle=qe("--ink-soft"),e.fillText(n,t.width/2,t.height/2),s.needsUpdate=!0}};return o.applyTheme(),o}function R0(n,t,e){let i=n.getAttribute("position");(!i||i.count<t)&&(i=new Ye(new Float32Array(3*Math.max(16,2*t)),3),i.setUsage(go),n.setAttribute("position",i)),n.setDrawRange(0,e(i.array)),i.needsUpdate=!0}var hr=class{constructor(t,e=1){this.colourName=t,this.object=new As(new tn,new ss({transparent:e<1,opacity:e})),this.object.frustumCulled=!1,this.applyTheme()}applyTheme(){this.object.material.color.set(qe(this.colourName))}set(t,e){R0(this.object.geometry,2*t,e)}};function P1(){let t=document.createElement("canvas");t.width=t.height=64;let e=t.getContext("2d");return e.fillStyle="#fff",e.beginPath(),e.arc(64/2,64/2,64/2-2,0,2*Math.PI),e.fill(),new tr(t)}var ur=class{constructor(t,e){this.colourName=t,this.pixels=e,this.object=new ha(new tn,new co({size:e,sizeAttenuation:!1,map:P1(),alphaTest:.5,transparent:!1})),this.object.frustumCulled=!1,this.applyTheme()}applyTheme(){this.object.material.color.set(qe(this.colourName))}setPixelRatio(t){this.object.material.size=this.pixels*t}set(t,e){R0(this.object.geometry,t,e)}};function P0(n,t){let{first:e,items:i,positions:s}=n.markers,r=s.length/3/(e.length-1)>150,o=new ur("--measured",r?3:6),a=new hr("--miss"),l=new kn;return l.add(a.object,o.object),{object:l,parts:[o,a],setFrame(c){let[u,h]=[e[c],e[c+1]];o.set(h-u,p=>(p.set(s.subarray(3*u,3*h)),h-u));let f=c<t.frames?h:u;a.set(h-u,p=>{for(let _=u;_<f;++_){let v=6*(_-u);p.set(s.subarray(3*_,3*_+3),v),Po(n,i[2*_+1],t.positions,3*t.particles*c,p,v+3)}return 2*(f-u)})}}}function I0(n,t,e){let i=new hr("--ray",.45),{first:s,items:r,pixels:o}=n.tracks;return{object:i.object,parts:[i],camera:0,setFrame(a){let l=t[this.camera],c=Tr(l),[u,h]=[s[a],a<e.frames?s[a+1]:s[a]];i.set(h-u,f=>{let p=0;for(let _=u;_<h;++_){if(r[3*_+1]!==this.camera)continue;let v=3*p;Po(n,r[3*_+2],e.positions,3*e.particles*a,f,v);let m=yd(l,o[2*_],o[2*_+1]),d=[0,1,2].reduce((T,E)=>T+(f[v+E]-c[E])*m[E],0);for(let T=0;T<3;++T)f[v+T]=c[T],f[v+3+T]=c[T]+d*m[T];p+=2}return p})}}}function D0(n,t){let e=new hr("--frustum"),i=new kn;i.add(e.object);let s=[e],r=n.map(o=>{let a=Tr(o),[l,c]=o.size;return[[0,0],[l,0],[l,c],[0,c]].map(([u,h])=>{let f=[(u-o.centre[0])/o.focal[0],(h-o.centre[1])/o.focal[1],1];return Ih(o,f.map(p=>p*t)).map((p,_)=>p+a[_])})});return e.set(8*n.length,o=>{let a=0;return n.forEach((l,c)=>{let u=Tr(l);r[c].forEach((f,p)=>{o.set([...u,...f,...f,...r[c][(p+1)%4]],a),a+=12});let h=C0(l.name);h.object.position.set(...u),i.add(h.object),s.push(h)}),a/3}),{object:i,parts:s,setFrame(){}}}async function L0(n){let t=new ur("--handle",11),e=new hr("--handle",.35),i=new kn;i.add(t.object,e.object);let s=await Promise.all(n.map(r=>Ee(r.positions)));return e.set(s.reduce((r,o)=>r+o.length/3,0),r=>{let o=0;for(let a of s)for(let l=3;l<a.length;l+=3)r.set(a.subarray(l-3,l+3),o),o+=6;return o/3}),{object:i,parts:[t,e],setFrame(r){t.set(n.length,o=>{let a=0;return n.forEach((l,c)=>{!(l.released_after===null||r<=l.released_after+1e-6)||3*r>=s[c].length||o.set(s[c].subarray(3*r,3*r+3),3*a++)}),a})}}}async function U0(n){let t=new kn,e=[];for(let i of n){let s=await Ee(i.positions),r=3*i.positions.shape.at(-2),o=new tn,a=new Ye(s.slice(0,r),3);o.setAttribute("position",a),o.setIndex(new Ye(new Uint32Array(await Ee(i.triangles)),1)),o.computeVertexNormals();let l=new ki({color:qe("--obstacle"),side:Fn,transparent:!0,opacity:.7,depthWrite:!1});t.add(new yn(o,l)),e.push({positions:s,count:r,place:a,geometry:o,material:l})}return{object:t,parts:e.map(({material:i})=>({applyTheme:()=>i.color.set(qe("--obstacle"))})),setFrame(i){for(let{positions:s,count:r,place:o,geometry:a}of e){let l=Math.min(i*r,s.length-r);o.array.set(s.subarray(l,l+r)),o.needsUpdate=!0,a.boundingSphere=null}}}}function N0(n){let{factor:t,unit:e}=Uh(n.unit),[i,s]=n.range;return[V("span",{class:"legend-title"},`${n.title}, ${bn(e)}`),V("span",{class:"ramp",style:`background: ${Wa(n.diverging)}`}),V("span",{class:"legend-ends"},V("span",{},ge(i*t,2)),V("span",{},`${ge(s*t,2)}${n.diverging?"":" and more"}`))]}var I1=5;function D1(n,t,e){let i=n.columns(),s=Math.min(i-1,Math.floor(t/n.container.clientWidth*i)),{left:r,width:o,height:a}=n.rectangle(s);n.eye.aspect=o/a,n.eye.updateProjectionMatrix();let l=new xa;l.setFromCamera(new qt(2*(t-r)/o-1,1-2*e/a),n.eye);let{cloth:c}=n.shown[s],u=c.object.visible?l.intersectObjects([c.surface,c.reverse].filter(_=>_.visible)):[];if(u.length===0)return null;let h=new z,{face:f,point:p}=u[0];return[f.a,f.b,f.c].reduce((_,v)=>c.positionAt(v,h).distanceTo(p)<c.positionAt(_,new z).distanceTo(p)?v:_)}function F0(n,t){let e=null;n.canvas.addEventListener("pointerdown",i=>{e=[i.clientX,i.clientY]}),n.canvas.addEventListener("pointerup",i=>{if(!e||Math.hypot(i.clientX-e[0],i.clientY-e[1])>I1)return;let s=n.canvas.getBoundingClientRect();t(D1(n,i.clientX-s.left,i.clientY-s.top))})}var oh=class{constructor(t,e,i){this.fields=t,this.uv=e,this.onClose=i,this.element=V("div",{class:"probe",role:"status",hidden:!0})}async show(t,e,i){let s=`${t} ${e} ${i.length}`;if(this.asked=s,this.element.hidden=t===null,t===null)return;let r=i.filter(a=>e<a.cloth.frames),o=[L1(t,r)];for(let a of this.fields){let l=await Promise.all(r.map(async({motion:c,cloth:u})=>{let h=a.values[c.name];return h?(await Ee(h))[u.particles*e+t]:NaN}));o.push([a.title,...l.map(c=>Ld(c,a.unit))])}this.asked===s&&this.fill(t,r,o)}fill(t,e,i){let[s,r]=[this.uv[2*t],this.uv[2*t+1]],o=["",...e.map(a=>a.motion.title)];this.element.replaceChildren(V("strong",{},`Particle ${t}`),V("span",{},` (u, v) = (${ge(s,3)}, ${ge(r,3)}) m`),V("button",{type:"button","aria-label":"Close",onclick:this.onClose},"\xD7"),V("table",{},V("tr",{},o.map(a=>V("th",{},a))),i.map(a=>V("tr",{},a.map(l=>V("td",{},l))))))}};function L1(n,t){let e=new z;return["place",...t.map(({cloth:i})=>`${i.positionAt(n,e).toArray().map(r=>r.toFixed(3)).join(", ")} m`)]}var O0={type:"change"},zf={type:"start"},k0={type:"end"},ah=new is,B0=new ai,U1=Math.cos(70*_f.DEG2RAD),an=new z,Gn=2*Math.PI,Ie={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},kf=1e-6,lh=class extends Ma{constructor(t,e=null){super(t,e),this.state=Ie.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ps.ROTATE,MIDDLE:Ps.DOLLY,RIGHT:Ps.PAN},this.touches={ONE:Is.ROTATE,TWO:Is.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Vn,this._lastTargetPosition=new z,this._quat=new Vn().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ho,this._sphericalDelta=new ho,this._scale=1,this._panOffset=new z,this._rotateStart=new qt,this._rotateEnd=new qt,this._rotateDelta=new qt,this._panStart=new qt,this._panEnd=new qt,this._panDelta=new qt,this._dollyStart=new qt,this._dollyEnd=new qt,this._dollyDelta=new qt,this._dollyDirection=new z,this._mouse=new qt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=F1.bind(this),this._onPointerDown=N1.bind(this),this._onPointerUp=O1.bind(this),this._onContextMenu=W1.bind(this),this._onMouseWheel=z1.bind(this),this._onKeyDown=V1.bind(this),this._onTouchStart=H1.bind(this),this._onTouchMove=G1.bind(this),this._onMouseDown=B1.bind(this),this._onMouseMove=k1.bind(this),this._interceptControlDown=X1.bind(this),this._interceptControlUp=q1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(O0),this.update(),this.state=Ie.NONE}update(t=null){let e=this.object.position;an.copy(e).sub(this.target),an.applyQuaternion(this._quat),this._spherical.setFromVector3(an),this.autoRotate&&this.state===Ie.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Gn:i>Math.PI&&(i-=Gn),s<-Math.PI?s+=Gn:s>Math.PI&&(s-=Gn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(an.setFromSpherical(this._spherical),an.applyQuaternion(this._quatInverse),e.copy(this.target).add(an),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=an.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=an.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ah.origin.copy(this.object.position),ah.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ah.direction))<U1?this.object.lookAt(this.target):(B0.setFromNormalAndCoplanarPoint(this.object.up,this.target),ah.intersectPlane(B0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>kf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>kf||this._lastTargetPosition.distanceToSquared(this.target)>kf?(this.dispatchEvent(O0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Gn/60*this.autoRotateSpeed*t:Gn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){an.setFromMatrixColumn(e,0),an.multiplyScalar(-t),this._panOffset.add(an)}_panUp(t,e){this.screenSpacePanning===!0?an.setFromMatrixColumn(e,1):(an.setFromMatrixColumn(e,0),an.crossVectors(this.object.up,an)),an.multiplyScalar(t),this._panOffset.add(an)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;an.copy(s).sub(this.target);let r=an.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Gn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Gn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Gn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new qt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function N1(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n)))}function F1(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function O1(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(k0),this.state=Ie.NONE;break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function B1(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ps.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ie.DOLLY;break;case Ps.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ie.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ie.ROTATE}break;case Ps.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ie.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ie.PAN}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(zf)}function k1(n){switch(this.state){case Ie.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ie.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ie.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function z1(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ie.NONE||(n.preventDefault(),this.dispatchEvent(zf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(k0))}function V1(n){this.enabled!==!1&&this._handleKeyDown(n)}function H1(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Is.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(n),this.state=Ie.TOUCH_ROTATE;break;case Is.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(n),this.state=Ie.TOUCH_PAN;break;default:this.state=Ie.NONE}break;case 2:switch(this.touches.TWO){case Is.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ie.TOUCH_DOLLY_PAN;break;case Is.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ie.TOUCH_DOLLY_ROTATE;break;default:this.state=Ie.NONE}break;default:this.state=Ie.NONE}this.state!==Ie.NONE&&this.dispatchEvent(zf)}function G1(n){switch(this._trackPointer(n),this.state){case Ie.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ie.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ie.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ie.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ie.NONE}}function W1(n){this.enabled!==!1&&n.preventDefault()}function X1(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function q1(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ch=class{constructor(t){this.share=t,this.isMoving=!1}move(t,e){this.isMoving=t,this.wanted=Math.max(1/60,e),this.last=null,this.intervals=[]}drawn(t){if(!this.isMoving||(this.last!==null&&this.intervals.push((t-this.last)/1e3),this.last=t,this.intervals.length<6))return!1;let e=[...this.intervals].sort((i,s)=>i-s)[3];return this.intervals=[],e<1.25*this.wanted||this.share<=.45?!1:(this.share=Math.max(.45,.8*this.share),!0)}get now(){return this.isMoving?this.share:1}};var hh=class{constructor(t,e){this.motion=t,this.cloth=e,this.layers=new Map,this.scene=new aa,this.scene.add(e.object,new va(16777215,1.9))}addLayer(t,e,i){e.object.visible=i,this.layers.set(t,e),this.scene.add(e.object)}setFrame(t){this.cloth.setFrame(t);for(let e of this.layers.values())e.object.visible&&e.setFrame(t)}applyTheme(){this.cloth.applyTheme();for(let t of this.layers.values())for(let e of t.parts)e.applyTheme()}};function z0(n){let t=new Bi,e=new z;for(let i=0;i<n.length;i+=3)t.expandByPoint(e.fromArray(n,i));return t}function Y1(){let n=document.createElement("canvas").getContext("webgl2"),t=n?.getExtension("WEBGL_debug_renderer_info"),e=t?n.getParameter(t.UNMASKED_RENDERER_WEBGL):"";return n?.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)}var uh=class{constructor(t,e,i,s){this.container=t,this.panes=e,this.shown=e.slice(-1),this.isOver=!1,this.mostPixels=Y1()?1:2,this.pace=new ch(this.mostPixels>1?1:.75),this.canvas=document.createElement("canvas"),this.renderer=new eh({canvas:this.canvas,context:this.makeContext()}),this.renderer.setScissorTest(!0),t.prepend(this.canvas),this.eye=new En(32,1,.01,100),this.eye.up.copy(i),this.light=new _a(16777215,1.6),this.controls=new lh(this.eye,this.canvas),this.controls.addEventListener("change",()=>this.invalidate()),this.controls.addEventListener("start",()=>{this.isPlaying||this.move(!0,1/30)}),this.controls.addEventListener("end",()=>{this.isPlaying||this.move(!1,0)}),this.background=qe("--panel"),this.home={up:i,box:s},this.lookHome(),new ResizeObserver(()=>this.resize()).observe(t),Va(()=>this.applyTheme()),this.frames=0}makeContext(){let t=this.canvas.getContext("webgl2",{alpha:!1,stencil:!1,antialias:this.mostPixels>1,powerPreference:"low-power"});if(!t)throw new Error("this browser has none");return t}lookHome(){let{up:t,box:e}=this.home,i=e.getCenter(new z),s=.5*e.getSize(new z).length(),r=Math.abs(t.z)>.9?new z(.55,-1,0):new z(.55,0,1);r.addScaledVector(t,-r.dot(t)).normalize();let o=r.addScaledVector(t,.42).normalize();this.distance=s/Math.sin(.5*this.eye.fov*Math.PI/180),this.controls.target.copy(i),this.eye.position.copy(i).addScaledVector(o,this.distance*this.closeness()),this.eye.near=.01*this.distance,this.eye.far=20*this.distance,this.controls.update(),this.invalidate()}stepBack(t){let{target:e}=this.controls,i=Math.max(...t.map(o=>e.distanceTo(new z(...o)))),s=this.eye.position.clone().sub(e),r=1.15*i/Math.sin(.5*this.eye.fov*Math.PI/180);s.setLength(Math.max(s.length(),r)),this.eye.position.copy(e).add(s),this.controls.update()}closeness(){let t=this.aspect();return .98*Math.max(1,1.15/t)}aspect(){let{clientWidth:t,clientHeight:e}=this.container;return t&&e?t/this.columns()/e:1.3}columns(){return this.isOver?1:this.shown.length}show(t,e=!1){let i=this.closeness();this.shown=this.panes.filter(r=>t.includes(r.motion.name)),this.isOver=e&&this.shown.length>1;for(let r of this.shown)r.setFrame(this.frame??0);let{target:s}=this.controls;this.eye.position.sub(s).multiplyScalar(this.closeness()/i).add(s),this.controls.update(),this.resize()}setFrame(t){this.frame=t;for(let e of this.shown)e.setFrame(t);this.invalidate()}refresh(){this.setFrame(this.frame??0)}applyTheme(){this.background=qe("--panel");for(let t of this.panes)t.applyTheme();this.invalidate()}play(t,e){this.isPlaying=t,this.move(t,1/e)}move(t,e){this.pace.move(t,e),this.resize()}resize(){let{clientWidth:t,clientHeight:e}=this.container;if(!t||!e)return;let i=this.pace.now*Math.min(this.mostPixels,window.devicePixelRatio);this.renderer.setPixelRatio(i),this.renderer.setSize(t,e,!1);for(let s of this.panes)for(let r of s.layers.values())for(let o of r.parts)o.setPixelRatio?.(this.renderer.getPixelRatio());this.invalidate()}invalidate(){this.isWaiting||(this.isWaiting=!0,requestAnimationFrame(()=>{this.isWaiting=!1,this.draw()}))}rectangle(t){let e=this.container.clientWidth/this.columns();return{left:this.isOver?0:t*e,width:e,height:this.container.clientHeight}}draw(){this.renderer.setClearColor(this.background),this.shown.forEach((t,e)=>{let{left:i,width:s,height:r}=this.rectangle(e);this.eye.aspect=s/r,this.eye.updateProjectionMatrix(),this.renderer.setViewport(i,0,s,r),this.renderer.setScissor(i,0,s,r),this.light.position.copy(this.eye.position).sub(this.controls.target).addScaledVector(this.eye.up,.8*this.distance),t.scene.add(this.light),this.renderer.autoClear=!this.isOver||e===0,this.renderer.render(t.scene,this.eye)}),++this.frames,this.pace.drawn(performance.now())&&this.resize()}};var V0={markers:["Markers","--measured",!0],rays:["Rays of the camera beside","--ray",!1],handles:["Handles","--handle",!0],cameras:["Cameras","--frustum",!1],ground:["Ground","--grid",!0],obstacles:["Obstacles","--obstacle",!0]};async function Z1(n,t,e,i,s){let r=await Ee(n.mesh.triangles),o=new ih(n.mesh,r,await Ee(t.positions),t.frames),a=new hh(t,o),l=(u,h)=>a.addLayer(u,h,V0[u][2]);l("ground",w0(n.ground,i,s)),n.obstacles.length&&l("obstacles",await U0(n.obstacles)),e.markers&&l("markers",P0(e,o)),e.tracks&&l("rays",I0(e,n.cameras,o)),n.handles.length&&l("handles",await L0(n.handles)),n.cameras.length&&l("cameras",D0(n.cameras,.16*s.getSize(new z).length()));let c=new ur("--picked",12);return a.addLayer("picked",{object:c.object,parts:[c],particle:null,setFrame(u){let h=this.particle!==null&&u<o.frames;c.set(1,f=>{if(h){let p=3*(o.particles*u+this.particle);f.set(o.positions.subarray(p,p+3))}return h?1:0})}},!0),a}var Vf="*over",fh=class n{static async make(t,e,i){let s=new z(...t.gravity).negate();s.length()>0?s.normalize():s.set(0,0,1);let r=t.motions[t.motions.length-1],o=z0(await Ee(r.positions)),a=[];for(let c of t.motions)a.push(await Z1(t,c,e,s,o));let l=await Ee(t.mesh.uv);return new n(t,i,a,s,o,l)}constructor(t,e,i,s,r,o){this.report=t,this.panes=i,this.particle=null;let a=t.cameras.length>0||matchMedia("(max-width: 480px)").matches;this.first=a?i[i.length-1].motion.name:"",t.shows_both&&i.length>1&&(this.first=Vf),this.legend=V("div",{class:"legend"}),this.titles=V("div",{class:"pane-titles","aria-hidden":"true"}),this.divider=V("div",{class:"pane-divider"}),this.probe=new oh(t.fields,o,()=>this.choose(null)),this.view=V("div",{class:"view",id:"view-3d"},this.divider,this.titles,this.legend,this.probe.element),this.viewer=new uh(this.view,i,s,r),this.viewer.canvas.setAttribute("aria-label","The cloth in 3D: drag to turn, wheel to zoom, right-drag to move, click for the values of a particle; keys W, A, S, D turn, + and - zoom, 0 resets"),this.element=V("figure",{class:"panel view-panel"},this.view,this.controls()),E0(this.viewer),F0(this.viewer,l=>this.choose(l)),this.showMotions(this.first),this.showField(t.fields[0]?.name??""),e.onState(()=>this.viewer.play(e.isPlaying,e.rate*e.speed)),e.onFrame(l=>{this.viewer.setFrame(l),this.updateProbe()})}controls(){let t=this.panes.map(o=>o.motion),e=gd("Which motion",[...t.map(({name:o,title:a})=>({value:o,title:a})),...t.length>1?[{value:"",title:"Side by side"}]:[],...this.report.shows_both?[{value:Vf,title:"Over each other"}]:[]],this.first,o=>this.showMotions(o)),i=Sr("Colour by",[...this.report.fields.map(({name:o,title:a})=>({value:o,title:a})),{value:"",title:"Sides of the cloth"}],this.report.fields[0]?.name??"",o=>this.showField(o)),s=Object.entries(V0).filter(([o])=>this.panes[0].layers.has(o)).map(([o,[a,l,c]])=>Ro(a,c,u=>this.showLayer(o,u),`var(${l})`));s.push(Ro("Threads",!0,o=>{for(let a of this.panes)a.cloth.threads.visible=o;this.viewer.invalidate()},"var(--thread)"));let r=V("button",{type:"button",onclick:()=>this.viewer.lookHome()},"Reset view");return V("figcaption",{class:"controls"},e,V("label",{class:"field-choice"},V("span",{},"Colour"),i),V("details",{class:"menu"},V("summary",{},"Layers"),V("div",{},s,r)))}showMotions(t){let e=t===Vf,i=t&&!e?[t]:this.panes.map(s=>s.motion.name);for(let s of this.panes)s.cloth.setTint(e?`--${s.motion.name}`:null);this.legend.hidden=e,this.viewer.show(i,e),this.titles.replaceChildren(...this.viewer.shown.map(s=>V("span",{class:`is-${s.motion.name}`},s.motion.title))),this.divider.hidden=this.viewer.columns()<2,this.updateProbe()}showLayer(t,e){for(let i of this.panes)i.layers.has(t)&&(i.layers.get(t).object.visible=e);t==="cameras"&&e&&this.viewer.stepBack(this.report.cameras.map(Tr)),this.viewer.refresh()}setCamera(t){for(let e of this.panes)e.layers.has("rays")&&(e.layers.get("rays").camera=t);this.viewer.refresh()}async showField(t){let e=this.report.fields.find(i=>i.name===t)??null;this.field=e;for(let i of this.panes){let s=e?.values[i.motion.name],r=s?await Ee(s):null;if(this.field!==e)return;i.cloth.setField(e,r)}this.legend.replaceChildren(...e?N0(e):[]),this.viewer.invalidate(),this.updateProbe()}choose(t){this.particle=t;for(let e of this.panes)e.layers.get("picked").particle=t;this.viewer.refresh(),this.updateProbe()}updateProbe(){this.probe.show(this.particle,this.viewer.frame,this.viewer.shown)}};async function $1(n){let t={};for(let e of n.motions)t[e.name]={positions:await Ee(e.positions),particles:n.mesh.particles,frames:e.frames};return t}async function J1(n,t,e){try{return await fh.make(n,t,e)}catch(i){return{element:V("figure",{class:"panel"},V("p",{class:"missing"},`The 3D view needs WebGL: ${i.message}`)),setCamera(){}}}}async function K1(n,t,e){let i=await xd(n),s=await $1(n),r=await J1(n,i,t);if(e.append(r.element),e.classList.toggle("alone",n.cameras.length===0),n.cameras.length===0)return{viewPanel:r};let o=new ka(n,i,await Ee(n.mesh.triangles),s),a=new za(o,t,l=>r.setCamera(l));return r.setCamera(a.index),e.append(a.element),{viewPanel:r,pictures:o,picturePanel:a}}function j1(){let n=document.querySelector(".verdict-words");if(n.querySelectorAll("li").length<2)return;let t=V("button",{type:"button",class:"more","aria-expanded":"false",onclick:()=>{let e=n.classList.toggle("open");t.setAttribute("aria-expanded",String(e)),t.textContent=e?"Less":"More"}},"More");n.append(t)}var Q1={frames:1,rate:1,held_out:[],last_fitted:0};async function tT(){let n=md(),t=!!n.motions?.length,e=n.clock??Q1,i=new Ha(e);document.getElementById("bar-tools").append(Tm(n.sections),Pd());let s=document.getElementById("stage");t?document.body.append(Em(i,e)):s.hidden=!0;let r=t?await K1(n,i,s):{};n.notes.length&&s.after(V("aside",{class:"notes"},n.notes.map(l=>V("p",{},l))));let o={report:n,player:i,clock:e,...r},a=document.getElementById("sections");for(let l of n.sections)a.append(wm(l,o));Id(i,r.viewPanel?.viewer),t&&j1(),document.documentElement.dataset.ready="true",window.clothfit={player:i,...r},t&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&i.play()}tT();})();
