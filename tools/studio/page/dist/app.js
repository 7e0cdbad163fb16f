function g(n,t={},...e){let[i,...s]=n.split("."),r=document.createElement(i);s.length&&(r.className=s.join(" "));for(let[o,a]of Object.entries(t))Ax(r,o,a);return Gu(r,e),r}var Mx="http://www.w3.org/2000/svg";function Ie(n,t={},...e){let[i,...s]=n.split("."),r=document.createElementNS(Mx,i);s.length&&r.setAttribute("class",s.join(" "));for(let[o,a]of Object.entries(t))o.startsWith("on")?r.addEventListener(o.slice(2).toLowerCase(),a):a!=null&&r.setAttribute(o,a);return Gu(r,e),r}function Ax(n,t,e){if(e!=null)if(t.startsWith("on"))n.addEventListener(t.slice(2).toLowerCase(),e);else if(t==="data")Object.assign(n.dataset,e);else if(t==="style")Object.assign(n.style,e);else if(t==="aria")for(let[i,s]of Object.entries(e))n.setAttribute(`aria-${i}`,s);else t in n&&t!=="list"?n[t]=e:n.setAttribute(t,e)}function Gu(n,t){for(let e of t.flat(1/0))e!=null&&e!==!1&&n.append(e)}function Gt(n,...t){return n.replaceChildren(),Gu(n,t),n}function Kt(n,t){n.textContent!==t&&(n.textContent=t)}var Tx={play:"M5 3.2v9.6l8-4.8z",pause:"M4.5 3h2.6v10H4.5zM8.9 3h2.6v10H8.9z",stop:"M4 4h8v8H4z",step:"M3.5 3.2v9.6l6.5-4.8zM10.8 3.2h2v9.6h-2z",undo:"M6.5 3 2.5 6.5l4 3.5V7.8h2.7a2.2 2.2 0 0 1 0 4.4H6v1.6h3.2a3.8 3.8 0 0 0 0-7.6H6.5z",redo:"M9.5 3l4 3.5-4 3.5V7.8H6.8a2.2 2.2 0 0 0 0 4.4H10v1.6H6.8a3.8 3.8 0 0 1 0-7.6h2.7z",lock:"M5 7V5.5a3 3 0 0 1 6 0V7h.8v6H4.2V7zm1.5 0h3V5.5a1.5 1.5 0 0 0-3 0z",unlock:"M5 7V4.5a3 3 0 0 1 5.8-1l-1.4.5A1.5 1.5 0 0 0 6.5 4.5V7h5.3v6H4.2V7z",reset:"M8 3.2a4.8 4.8 0 1 1-4.7 5.7h1.6A3.3 3.3 0 1 0 8 4.7v2L4.5 4 8 1.3z",sun:"M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6zM7.3 1h1.4v2.2H7.3zm0 11.8h1.4V15H7.3zM1 7.3h2.2v1.4H1zm11.8 0H15v1.4h-2.2zM3.6 2.6l1.5 1.5-1 1-1.5-1.5zm8.3 8.3 1.5 1.5-1 1-1.5-1.5zm1.5-7.3-1.5 1.5-1-1 1.5-1.5zM5.1 11.9l-1.5 1.5-1-1 1.5-1.5z",help:"M7.2 11.3h1.5v1.5H7.2zM8 3a2.8 2.8 0 0 0-2.9 2.8h1.5A1.4 1.4 0 1 1 8.7 7c-.9.6-1.5 1.2-1.5 2.3v.8h1.5v-.7c0-.5.3-.8 1-1.3A2.8 2.8 0 0 0 8 3z",record:"M8 3.5a4.5 4.5 0 1 0 0 9 4.5 4.5 0 0 0 0-9z",close:"m4.2 3.2 3.8 3.8 3.8-3.8 1 1L9 8l3.8 3.8-1 1L8 9l-3.8 3.8-1-1L7 8 3.2 4.2z"};function Fi(n){return Ie("svg.icon",{viewBox:"0 0 16 16","aria-hidden":"true",focusable:"false"},Ie("path",{d:Tx[n]}))}function an(n,t,e,i={}){return g("button.icon-button",{type:"button",title:t,aria:{label:t},onClick:e,...i},Fi(n))}var us=class extends Error{constructor(t,{where:e="",message:i="",line:s=0}={}){super(i||`the server answered ${t}`),this.status=t,this.where=e,this.line=s}};async function Ex(n){let t=await n.text(),e={};try{e=t?JSON.parse(t):{}}catch{e={error:{message:t.slice(0,300)}}}if(!n.ok)throw new us(n.status,e.error);return e}async function Hu(n,t,e,i){let s;try{s=await fetch(t,{method:n,signal:i,headers:e===void 0?{}:{"Content-Type":"application/json"},body:e===void 0?void 0:JSON.stringify(e)})}catch(r){throw r.name==="AbortError"?r:new us(0,{message:"legwright studio does not answer; is it still running?"})}return Ex(s)}var _i=(n,t)=>Hu("GET",n,void 0,t),ii=(n,t={},e)=>Hu("POST",n,t,e),zr=n=>Hu("DELETE",n),ol=(n,t={})=>ii("/api/command",{do:n,...t}),Vu=new Map;function Dp(n){return Vu.has(n)||Vu.set(n,_i(`/api/mesh/${encodeURIComponent(n)}`)),Vu.get(n)}var al=class{constructor(t,e){this.failed=t,this.changed=e,this.drafts=new Map,this.number=0,this.flight=Promise.resolve(),this.moving=null,this.worker=new Worker("edit_worker.js"),this.worker.onmessage=({data:i})=>this.take(i),this.worker.onerror=()=>this.end()}end(){this.ended=!0,this.drafts.clear(),this.changed(),this.landed?.(),this.landed=null,this.failed(new us(0,{message:"Edits cannot be sent: load this page anew."}))}value(t,e){return this.drafts.get(t)?.value??e}set(t,e="once"){if(this.ended)return this.end();let i=Object.keys(t).sort().join();(e==="begin"||e==="once")&&(this.moving=null);for(let[o,a]of Object.entries(t))this.drafts.set(o,{value:a,revision:1/0});let s=e==="begin"||e==="drag",r=this.moving!==i;this.moving=s?i:null,this.idle&&(this.flight=new Promise(o=>this.landed=o)),this.worker.postMessage({number:++this.number,values:t,held:s,fresh:r}),this.changed()}take({number:t,values:e,revision:i,refusal:s}){for(let[r,o]of Object.entries(e)){let a=this.drafts.get(r);a?.value===o&&(s?this.drafts.delete(r):a.revision=i)}s?this.failed(new us(s.status,s)):this.settle(this.seen??0),s&&this.changed(),!(t<this.number)&&(this.landed(),this.landed=null)}sent(){return this.flight}get idle(){return!this.landed}settle(t){this.seen=t;for(let[e,i]of this.drafts)i.revision<=t&&this.drafts.delete(e)}};var Np=5e3;function Fp(n,t,e){let i=null,s=250,r="",o=0,a=!1,l=()=>{i=new EventSource(e===void 0?"/api/events":`/api/events?heard=${e}`),i.onopen=()=>{s=250,e=void 0,r="",t(!0,r)};for(let h of Rx)i.addEventListener(h,c=>n(h,JSON.parse(c.data)));i.onmessage=h=>{let c=JSON.parse(h.data);n(c.kind,c)},i.onerror=async()=>{i.close(),t(!1,r),r=await Cx(),!a&&(t(!1,r),o=setTimeout(l,s),s=Math.min(Np,2*s))}};return l(),()=>{a=!0,clearTimeout(o),i.close()}}async function Cx(){try{await _i("/api/room",AbortSignal.timeout(Np))}catch(n){if(n.status)return n.message}return""}var Rx=["opened","state","assembly","design","motion","point","alternatives","physics","judge","job","notice"];var Ko=class{constructor(t){this.failed=t,this.flights=new Map,this.waiting=new Map}send(t,e){this.waiting.set(t,e),this.flights.has(t)||this.flights.set(t,this.fly(t))}async fly(t){for(let e;e=this.waiting.get(t);){this.waiting.delete(t);try{await e()}catch(i){this.failed(i)}}this.flights.delete(t)}sent(){return Promise.all(this.flights.values())}};var Up="legwright-set-by-hand",Px=()=>{try{return sessionStorage.getItem(Up)}catch{return null}},Ix=n=>{try{sessionStorage.setItem(Up,n)}catch{}},ll=class{constructor(t){this.studio=t,this.begin(),t.store.on("state",e=>this.follow(e)),t.store.on("opened",e=>e&&this.recall(`${e.path} ${e.kept}`)),t.store.on("forgotten",()=>{this.session=void 0,this.begin()})}begin(){this.names=new Set,this.before=null,this.known=null,this.searching=!1}recall(t){if(t===this.session)return;this.session=t;let{session:e,names:i,before:s,known:r}=JSON.parse(Px()??"{}");e===t&&(this.names=new Set(i),this.before=s&&new Map(s),this.known=r&&new Map(r))}keepInTab(){if(!this.session)return;let{session:t,names:e,before:i,known:s}=this,r=o=>o&&[...o];Ix(JSON.stringify({session:t,names:[...e],before:r(i),known:r(s)}))}note(t){this.before&&this.startAnew(),!this.names.has(t)&&(this.names.add(t),this.keepInTab())}searchBegins(){this.before||(this.before=new Map(this.free().map(t=>[t,this.value(t)])),this.keepInTab())}async aroundSearch(t){let e=this.before;this.searchBegins();let i=this.before;try{return await t()}catch(s){throw this.before===i&&(this.before=e),this.keepInTab(),s}}startAnew(){this.names.clear(),this.before=this.known=null,this.follow(this.studio.store.get("state")),this.keepInTab()}follow(t){if(!t)return;let e=t.phase==="searching";e&&!this.searching&&this.searchBegins(),this.searching=e;let{parameters:i}=this.studio.store.get("document")??{};this.known||i?.length!==t.s.length||(this.known=new Map(i.map(({name:s},r)=>[s,t.s[r]])),this.keepInTab())}value(t){return this.studio.readParameter(t).value}free(){return[...this.names].filter(t=>{let{value:e,locked:i}=this.studio.readParameter(t);return!i&&Math.abs(e-(this.known?.get(t)??e))>1e-9})}changed(){return this.studio.store.get("document")?[...this.before??[]].filter(([t,e])=>Math.abs(this.value(t)-e)>1e-9).map(([t])=>t):[]}async keep(){let{studio:t}=this,[e,i]=[this.changed(),this.before],s=e.length?e:this.free();if(this.searching&&await t.stopSearch(),e.length){let r=Object.fromEntries(e.map(o=>[o,i.get(o)]));await t.command("edit",{values:r,goes_on:!1})}await t.command("freeze",{names:s,frozen:!0}),this.startAnew()}};var hl=class{constructor(t={}){this.values={...t},this.followers=new Map}get(t){return this.values[t]}set(t,e){if(this.values[t]!==e){this.values[t]=e;for(let i of this.followers.get(t)??[])i(e)}}touch(t){for(let e of this.followers.get(t)??[])e(this.values[t])}on(t,e){for(let s of[t].flat())this.followers.has(s)||this.followers.set(s,new Set),this.followers.get(s).add(e);let i=[t].flat().map(s=>this.values[s]);i.some(s=>s!=null)&&e(i[0])}};function Jo(n,...t){let e=g("dialog",{aria:{label:n},onClick:i=>i.target===e&&e.close()},g("h2",{},n),t);return e.addEventListener("close",()=>e.remove()),document.body.append(e),e.showModal(),e}function Gr(n,t="",{label:e="Name",action:i="Keep",hint:s=""}={}){return new Promise(r=>{let o=g("input.wide",{type:"text",value:t,required:!0,aria:{label:e}}),a=g("form",{method:"dialog",onSubmit:()=>r(o.value.trim()||null)},g("label.field",{},e,o),s?g("p.hint",{},s):"",g("div.actions",{},g("button",{type:"button",onClick:()=>l.close()},"Cancel"),g("button.primary",{type:"submit"},i))),l=Jo(n,a);l.addEventListener("close",()=>r(null)),o.select()})}function Op(n,t){let e=g("div.menu",{role:"menu",hidden:!0}),i=g("button",{type:"button",aria:{haspopup:"menu",expanded:"false"},onClick:()=>s(e.hidden)},n),s=o=>{e.hidden=!o,i.setAttribute("aria-expanded",String(o)),o&&e.firstChild.focus()};for(let{label:o,act:a,hint:l}of t)e.append(g("button",{type:"button",role:"menuitem",onClick:()=>{s(!1),i.focus(),a()}},o,l?g("kbd",{},l):""));let r=g("div.menu-holder",{},i,e);return r.addEventListener("keydown",o=>{if(e.hidden)return;let a=[...e.children],l=a.indexOf(document.activeElement),h={ArrowDown:1,ArrowUp:-1}[o.key];if(o.key==="Escape")s(!1),i.focus();else if(h)a[(l+h+a.length)%a.length].focus();else return;o.preventDefault(),o.stopPropagation()}),document.addEventListener("pointerdown",o=>{!e.hidden&&!r.contains(o.target)&&s(!1)}),r}var cl=class{constructor(){this.element=g("div.notices",{role:"status",aria:{live:"polite"}})}clear(t){for(let e of this.element.querySelectorAll(`.notice.${t}`))e.remove()}show(t,e){let i=()=>o.remove(),s=[...this.element.children].find(a=>a.dataset.words===e),r=1+Number(s?.dataset.times??0);s?.remove();let o=g(`div.notice.${t}`,{role:t==="error"?"alert":"status",data:{words:e,times:r}},g("span",{},r>1?`${e} (${r} times)`:e),g("button.link",{type:"button",aria:{label:"Dismiss"},onClick:i},"Dismiss"));for(;this.element.children.length>3;)(this.element.querySelector(".notice:not(.done)")??this.element.firstChild).remove();this.element.append(o),t!=="done"&&setTimeout(i,t==="error"?12e3:5e3)}};var ul=class{constructor(){this.names=new Set,this.hovered=null,this.followers=[]}on(t){this.followers.push(t)}tell(){for(let t of this.followers)t(this)}set(t){this.names=new Set(t),this.tell()}hover(t){this.hovered!==t&&(this.hovered=t,this.tell())}get first(){return this.names.values().next().value??null}};var dl=class{constructor(){this.store=new hl({connected:!1}),this.selection=new ul,this.notices=new cl,this.motions=new Map;let t=e=>this.fail(e);this.edits=new al(t,()=>this.store.touch("state")),this.sender=new Ko(t),this.beside=new Ko(t),this.turn=Promise.resolve(),this.meshSource=Dp,this.hand=new ll(this),this.store.on("task",()=>this.showMotion())}start(t){this.stopFollowing=Fp((e,i)=>this.take(e,i),(e,i)=>{this.store.set("connected",e),this.store.set("trouble",e?"":i||"Connection lost, trying again …")},t)}take(t,e){({opened:()=>this.opened(e),state:()=>this.takeState(e),motion:()=>{this.motions.set(e.task??0,e),(e.task??0)===(this.store.get("task")??0)&&this.store.set("motion",e)},alternatives:()=>this.store.set(`alternatives ${e.what}`,e),notice:()=>this.notices.show(e.level,e.words)}[t]??(()=>this.store.set(t,e)))()}takeState(t){this.edits.settle(t.revision),this.store.set("state",t),t.document!==void 0&&t.document!==this.known&&(this.known=t.document,this.loadDocument())}async opened(t){let e=`${t.path} ${t.kept}`,i=this.session!==void 0&&this.session!==e;if(this.session=e,i){this.forget(),this.stopFollowing(),this.start(t.heard);return}this.store.set("opened",t);let s=t.path||t.of_modules;!t.proposes&&!t.assembles&&s&&await this.loadDocument()}forget(){this.known=void 0,this.motions.clear(),this.store.values["alternatives fewest"]=this.store.values["alternatives front"]=null;let t=["opened","state","motion","design","document","judge","physics","assembly"];for(let e of t)this.store.values[e]=null;this.store.set("paused",!1),this.store.set("task",0),this.selection.hovered=null,this.selection.set([]),this.store.touch("forgotten"),this.store.touch("searchCleared")}async loadDocument(){if(this.loading)return this.again=!0;this.loading=!0;let{session:t}=this;try{let e=await _i("/api/document");if(t!==this.session)return void(this.again=!0);this.known??=e.document,this.again&&=e.document!==this.known,(this.store.get("task")??0)>=e.tasks.length&&this.store.set("task",0),this.store.set("document",e),this.showMotion()}catch(e){e.message=`What is open cannot be worked on: ${e.message}. Open another (File).`,t===this.session&&this.fail(e)}finally{this.loading=!1,this.again&&(this.again=!1,this.loadDocument())}}isOpen(){return!!this.store.get("document")}name(){let{label:t,name:e}=this.store.get("document")??{};return(t||e||"legwright").replaceAll(/\W+/g,"_")}showMotion(){let t=this.motions.get(this.store.get("task")??0);t&&this.store.set("motion",t)}readParameter(t){let e=this.store.get("state"),i=this.store.get("document"),s=i?.parameters.findIndex(a=>a.name===t)??-1;if(!(s>=0&&s<(e?.s.length??0)))return{value:0,lower:0,upper:0,locked:!0,gradient:null};let o=i.parameters[s];return{value:this.edits.value(t,e.s[s]),lower:e.lower?.[s]??o.robot_lower,upper:e.upper?.[s]??o.robot_upper,locked:!!e.frozen?.[s],gradient:e.gradient?.[s]??null}}edit(t,e,i){this.store.set("held",{name:t,phase:i});let s=this.phaseOnceMoved(t,e,i);s&&(this.store.get("state")?.phase==="searching"&&this.store.set("paused",!0),this.hand.note(t),this.edits.set({[t]:e},s))}phaseOnceMoved(t,e,i){let s={begin:this.readParameter(t).value,once:void 0},r=i in s?s[i]:this.resting,o=e===r;return this.resting=o&&i!=="end"?e:void 0,o?null:i==="drag"&&r!==void 0?"begin":i}lock(t,e){return this.command("freeze",{names:[t],frozen:e})}async putBack(t,e){await this.command("edit",{values:{[t]:e},goes_on:!1}),await this.lock(t,!0)}workOut(t){return this.command("work_out",{what:t})}choose(t,e,i){this.latest(`choose ${t}`,()=>this.commandQuietly("choose",{what:t,design:e,goes_on:i}))}setBounds(t,e,i){Number.isFinite(e)&&Number.isFinite(i)&&this.command("bounds",{name:t,lower:e,upper:i})}async act(t){try{return await t()}catch(e){this.fail(e);return}}fail(t){t.name!=="AbortError"&&(t instanceof us||console.error(t),this.notices.show("error",t.message))}answered(){return Promise.all([this.turn,this.edits.sent(),this.sender.sent()])}inOrder(t){let e=this.answered();return this.turn=e.then(()=>this.act(t)),this.turn}command(t,e){let i=t==="start"||t==="step",s=()=>ol(t,e);return this.inOrder(i?()=>this.hand.aroundSearch(s):s)}commandQuietly(t,e){return ol(t,e)}latest(t,e){this.sender.send(t,e)}latestBeside(t,e){this.beside.send(t,e)}setTask(t,e){this.latest("task",async()=>{try{await ii("/api/task",{task:t,changes:e})}catch(i){throw this.store.touch("taskRefused"),i}})}showTask(t){this.store.set("task",t)}startSearch(){return this.store.get("paused")||this.store.touch("searchCleared"),this.store.set("paused",!1),this.command("start")}halt(){return this.act(()=>ol("pause"))}pauseSearch(){return this.store.set("paused",!0),this.halt()}stopSearch(){return this.store.set("paused",!1),this.halt()}atWork(){let{store:t}=this,e=i=>!!t.get(i)?.running;return{search:t.get("paused")||["searching","working out"].includes(t.get("state")?.phase),judge:e("judge"),job:e("job")}}async stopAll(){let{search:t,judge:e,job:i}=this.atWork();t&&await this.stopSearch(),e&&await this.act(()=>zr("/api/judge")),i&&await this.act(()=>zr("/api/job"))}async open(t){this.store.set("opening",!0),await this.answered(),await this.act(t),this.store.set("opening",!1)}async toFolder(t,e,i,s,r="",o={}){let a=await this.act(()=>_i(`/api/free?path=${encodeURIComponent(i)}`)),l=await Gr(t,a?.path??i,{label:"Folder",action:e,hint:`${r}The folder is below those that the studio was started with.`});if(l)return await this.answered(),this.act(()=>ii(s,{path:l,...o}))}async save(){let t=`runs/${this.name()}`,e=await this.toFolder("Save as a run","Save",t,"/api/save");e&&this.notices.show("done",`Saved: ${e.path}`)}optimize(){return this.toFolder("Search with MuJoCo's verdicts","Search",`runs/${this.name()}_found`,"/api/optimize","Searches from this body within its bounds, with what is locked as it is, plays what it finds in MuJoCo and writes the best as a run: half a minute as a rule, up to some minutes. Then open that run. ")}backToModules(){return this.open(()=>ii("/api/assembly/bench"))}report(){return this.toFolder("Write the report of a run","Report",`runs/${this.name()}_report`,"/api/report","Saves what stands as a run, plays it and writes its report. The run that it was saved as can be named, too. ")}exportRobot(t){let e=!t&&this.store.get("refused");return this.toFolder("Export robot and gait","Export",`exports/${this.name()}`,"/api/export",e?"MuJoCo fails what stands: see Simulate, Verdict. ":"",t?{run:t}:{})}showFault({from:t,to:e}){this.view.setPlaying(!1),this.view.seekPhase(t<=e?(t+e)/2:t)}showMoment({task:t,time:e},i,s=[]){this.showTask(t??0),this.showWorkspace("simulate"),this.physics.playUntil(e,i),this.view.pointAt(s.map(r=>this.partOf(r)))}partOf({kind:t,name:e,words:i}){let{joints:s=[]}=this.store.get("document")??{},{bodies:r=[]}=this.store.get("design")??{},a={joint:()=>s.find(h=>h.name===e)?.body,body:()=>r.findIndex(h=>h.name===e)}[t]?.()??-1,l=this.view.player?.root??1;return{body:a>0?a:l,where:t==="foot"?e:void 0,words:i}}};var fl=class{constructor(t){this.studio=t,this.followers=[],this.selected="trunk",this.carried=null,this.step=0,this.aimed=null,t.store.on("assembly",e=>e&&this.take(e))}on(t){this.followers.push(t)}tell(t){for(let e of this.followers)e(t)}take(t){this.told=t,this.wanted&&this.find(this.wanted)&&(this.selected=this.wanted),this.wanted=null,this.find(this.selected)||(this.selected="trunk"),this.carried&&!this.spots().length&&(this.carried=null),this.tell("assembly")}find(t){let{trunk:e,parts:i,limbs:s}=this.told;return[e,...i,...s.flatMap(o=>[o,...o.joints,o.foot])].find(o=>o.item===t)}limbOf(t){return this.told.limbs.find(e=>t===e.item||t.startsWith(`${e.item}/`))}select(t){if(this.selected!==t){if(!this.find(t)){this.wanted=t;return}this.selected=t,this.tell("selected")}}carry(t,{dragged:e=!1}={}){this.carried=t,this.dragged=e,this.aimed=null,this.tell("carried")}aim(t){this.aimed!==t&&(this.aimed=t,this.tell("aimed"))}spots(){if(!this.carried||!this.told)return[];let{kind:t}=this.carried;return this.told.spots.filter(e=>t?e.takes.includes(t):e.begins_limb)}put(t){let{carried:e}=this;return this.carry(null),e.kind?this.obey({do:"put",module:e.name,spot:t}):this.obey({do:"copy",item:e.item,spot:t})}replace(t,e){return this.obey({do:"put",module:e,spot:t})}async obey(t){this.begin();let e=await this.studio.inOrder(()=>ii("/api/assembly",t));return e&&this.studio.notices.clear("error"),e?.item&&this.select(e.item),e}set(t,e,i){return this.obey({do:"set",item:t,key:e,value:i})}begin(){this.step+=1}drag(t,e,i){let{step:s}=this;this.studio.latest("assembly",async()=>{let r=this.draggedStep===s;this.draggedStep=s,await ii("/api/assembly",{do:"set",item:t,key:e,value:i,goes_on:r})})}};var ar=n=>n==="m"?4:3;function Ui(n,t){return Number.isFinite(n)?`${n.toFixed(ar(t))} ${t}`.trim():"–"}function We(n,t=4){if(n==null||!Number.isFinite(n))return"–";if(n===0)return"0";let e=Math.floor(Math.log10(Math.abs(n)));return e<-4||e>6?n.toExponential(t-2).replace("e+","e"):n.toFixed(Math.max(0,Math.min(6,t-1-e)))}function Wu(n,t){if(!Number.isFinite(n))return"–";let e=t===void 0?We(n,3):Ui(n,t);return n>0?`+${e}`:e.replace("-","−")}function pl(n){return Number.isFinite(n)?n<60?`${Math.max(1,Math.round(n))} s`:`${Math.floor(n/60)} min ${Math.round(n%60)} s`:""}var Oe=n=>n.replaceAll("_"," ");function Lx(n){let t=new DataView(n.buffer,n.byteOffset,n.byteLength),e=s=>String.fromCharCode(...n.subarray(s,s+4));if(n.length<20||e(0)!=="RIFF"||e(8)!=="WEBP")throw new Error("This is no WebP picture.");let i=[];for(let s=12;s+8<=n.length;){let r=8+t.getUint32(s+4,!0),o=r+r%2;["ALPH","VP8 ","VP8L"].includes(e(s))&&i.push(n.subarray(s,s+o)),s+=o}return i}function ml(n,...t){let e=t.reduce((r,o)=>r+o.length,0),i=new Uint8Array(8+e+e%2);i.set([...n].map(r=>r.charCodeAt(0))),new DataView(i.buffer).setUint32(4,e,!0);let s=8;for(let r of t)i.set(r,s),s+=r.length;return i}var kp=(...n)=>Uint8Array.from(n.flatMap(t=>[t&255,t>>8&255,t>>16&255]));function Bp(n,t,e){let i=({bytes:a,duration:l,at:[h,c,u,d]=[0,0,n,t]})=>ml("ANMF",kp(h/2,c/2,u-1,d-1,Math.min(16777215,Math.max(1,Math.round(l)))),Uint8Array.of(2),...Lx(a)),s=ml("VP8X",Uint8Array.of(18,0,0,0),kp(n-1,t-1)),r=ml("ANIM",new Uint8Array(6)),o=Uint8Array.from([..."WEBP"].map(a=>a.charCodeAt(0)));return ml("RIFF",o,s,r,...e.map(i))}var Dx=50,Nx=960,Fx=1200,Ux=.8,zp=()=>document.createElement("canvas").toDataURL("image/webp").startsWith("data:image/webp"),gl=class{constructor(t,e){let{canvas:i}=t,s=Math.min(1,Nx/i.width);this.copy=document.createElement("canvas"),this.copy.width=Math.round(i.width*s),this.copy.height=Math.round(i.height*s),this.pen=this.copy.getContext("2d"),this.frames=[],this.take=()=>{let r=performance.now();r-(this.frames.at(-1)?.time??-1/0)<Dx-5||(this.frames.push({time:r,bytes:this.grab(i)}),this.frames.length===Fx&&e())},t.after.add(this.take),this.stage=t,t.touch()}async grab(t){this.pen.drawImage(t,0,0,this.copy.width,this.copy.height);let e=await new Promise(i=>this.copy.toBlob(i,"image/webp",Ux));return new Uint8Array(await e.arrayBuffer())}async end(){this.stage.after.delete(this.take);let t=performance.now(),{frames:e,copy:i}=this;if(!e.length)return null;let s=[];for(let[r,{time:o,bytes:a}]of e.entries())s.push({bytes:await a,duration:(e[r+1]?.time??t)-o});return Bp(i.width,i.height,s)}};var Ox=[["corner","Corner"],["side","Side"],["front","Front"],["top","Top"]],kx=[["forces","Forces"],["paths","Paths"],["faults","Faults"],["follow","Follow"]],xl=n=>g("div.segmented",{role:"group",aria:{label:"Camera"}},Ox.map(([t,e])=>g("button",{type:"button",onClick:()=>n.stage.view(t)},e))),Gp=(n,t=kx)=>g("div.segmented",{role:"group",aria:{label:"Shown in the picture"}},t.map(([e,i])=>{let s=g("button",{type:"button",aria:{pressed:String(n.show[e])}},i);return s.addEventListener("click",()=>{n.show[e]=!n.show[e],s.setAttribute("aria-pressed",String(n.show[e])),n.pose()}),s}));function Vp(n,t){let e=URL.createObjectURL(t);g("a",{href:e,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(e),1e4)}var _l=class{constructor(t){this.studio=t,this.element=g("button",{type:"button",aria:{pressed:"false"},title:"Record the picture as an animated WebP, a minute at most",onClick:()=>this.film?this.end():this.begin()},Fi("record"),"Record"),!zp()&&(this.element.disabled=!0,this.element.title="This browser writes no WebP, so it records no films")}begin(){this.film=new gl(this.studio.view.stage,()=>this.end()),this.element.setAttribute("aria-pressed","true")}async end(){let{film:t}=this;this.film=null,this.element.setAttribute("aria-pressed","false");let e=await this.studio.act(()=>t.end());e&&Vp(`${this.studio.name()}.webp`,new Blob([e],{type:"image/webp"}))}},Hp=n=>g("button",{type:"button",title:"Save the picture as PNG",onClick:async()=>{let t=Uint8Array.from(atob(n.view.stage.picture().split(",")[1]),e=>e.charCodeAt(0));Vp(`${n.name()}.png`,new Blob([t],{type:"image/png"}))}},"Picture");var Wp="legwright-theme",Xp=matchMedia("(prefers-color-scheme: dark)"),Bx=()=>{try{return localStorage.getItem(Wp)}catch{return null}},lr=()=>Bx()??(Xp.matches?"dark":"light");function Ds(n){let t=()=>{document.documentElement.dataset.theme=lr(),n(lr())};Xp.addEventListener("change",t),addEventListener("legwright-theme",t),t()}function yl(){try{localStorage.setItem(Wp,lr()==="dark"?"light":"dark")}catch{return}dispatchEvent(new Event("legwright-theme"))}var qs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},wm=0,vd=1,Sm=2;var Da=1,Mm=2,mo=3,Zs=0,Ji=1,Mn=2,mr=0,go=1,bd=2,wd=3,Sd=4,Am=5;var gr=100,Tm=101,Em=102,Cm=103,Rm=104,Pm=200,Im=201,Lm=202,Dm=203,Md=204,Ad=205,Nm=206,Fm=207,Um=208,Om=209,km=210,Bm=211,zm=212,Gm=213,Vm=214,Wl=0,Xl=1,$l=2,io=3,ql=4,Yl=5,Zl=6,Kl=7,wh=0,Hm=1,Wm=2,is=0,Td=1,Ed=2,Cd=3,Rd=4,Pd=5,Id=6,Ld=7;var Dd=300,_r=301,_o=302,Sh=303,Mh=304,Jl=1e3,Qn=1001,jl=1002,Di=1003,Xm=1004;var Na=1005;var Ki=1006,Ah=1007;var ws=1008;var tn=1009,Nd=1010,Fd=1011,xo=1012,Th=1013,Un=1014,On=1015,kn=1016,Eh=1017,Ch=1018,xr=1020,Ud=35902,Od=35899,kd=1021,Bd=1022,Bn=1023,xs=1026,Ss=1027,zd=1028,Rh=1029,Ks=1030,Ph=1031;var Ih=1033,Fa=33776,Ua=33777,Oa=33778,ka=33779,Lh=35840,Dh=35841,Nh=35842,Fh=35843,Uh=36196,Oh=37492,kh=37496,Bh=37488,zh=37489,Ba=37490,Gh=37491,Vh=37808,Hh=37809,Wh=37810,Xh=37811,$h=37812,qh=37813,Yh=37814,Zh=37815,Kh=37816,Jh=37817,jh=37818,Qh=37819,tc=37820,ec=37821,ic=36492,nc=36494,sc=36495,rc=36283,oc=36284,za=36285,ac=36286;var oa=2300,Ql=2301,Vl=2302,dd=2303,fd=2400,pd=2401,md=2402;var $m=3200;var lc=0,qm=1,Ms="",cn="srgb",aa="srgb-linear",la="linear",Le="srgb";var Hl=7680;var Gd=7682;var Vd=514;var Ym=519,Zm=512,Km=513,Jm=514,Hd=515,jm=516,Qm=517,Wd=518,Xd=519,tg=35044,$d=35048;var qd="300 es",wn=2e3,no=2001;function zx(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Gx(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function ha(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function eg(){let n=ha("canvas");return n.style.display="block",n}var $p={},so=null;function Yd(...n){let t="THREE."+n.shift();so?so("log",t,...n):console.log(t,...n)}function ig(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=ig(n);let t="THREE."+n.shift();if(so)so("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function te(...n){n=ig(n);let t="THREE."+n.shift();if(so)so("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function na(...n){let t=n.join(" ");t in $p||($p[t]=!0,qt(...n))}function ng(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var sg={[Wl]:Wl,[$l]:Zl,[ql]:ql,[io]:Yl,[Xl]:Xl,[Zl]:$l,[Kl]:Kl,[Yl]:io},Nn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},zi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],qp=1234567,sa=Math.PI/180,ro=180/Math.PI;function yo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(zi[n&255]+zi[n>>8&255]+zi[n>>16&255]+zi[n>>24&255]+"-"+zi[t&255]+zi[t>>8&255]+"-"+zi[t>>16&15|64]+zi[t>>24&255]+"-"+zi[e&63|128]+zi[e>>8&255]+"-"+zi[e>>16&255]+zi[e>>24&255]+zi[i&255]+zi[i>>8&255]+zi[i>>16&255]+zi[i>>24&255]).toLowerCase()}function me(n,t,e){return Math.max(t,Math.min(e,n))}function Zd(n,t){return(n%t+t)%t}function Vx(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function Hx(n,t,e){return n!==t?(e-n)/(t-n):0}function ra(n,t,e){return(1-e)*n+e*t}function Wx(n,t,e,i){return ra(n,t,1-Math.exp(-e*i))}function Xx(n,t=1){return t-Math.abs(Zd(n,t*2)-t)}function $x(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function qx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Yx(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Zx(n,t){return n+Math.random()*(t-n)}function Kx(n){return n*(.5-Math.random())}function Jx(n){n!==void 0&&(qp=n);let t=qp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function jx(n){return n*sa}function Qx(n){return n*ro}function ty(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function ey(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Kd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function iy(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),h=r((t+i)/2),c=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),_=o((i-t)/2);switch(s){case"XYX":n.set(a*c,l*u,l*d,a*h);break;case"YZY":n.set(l*d,a*c,l*u,a*h);break;case"ZXZ":n.set(l*u,l*d,a*c,a*h);break;case"XZX":n.set(a*c,l*_,l*f,a*h);break;case"YXY":n.set(l*f,a*c,l*_,a*h);break;case"ZYZ":n.set(l*_,l*f,a*c,a*h);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Jd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function rg(n,t){if(t.constructor===Float32Array)return n;let e=Jd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function og(n,t){if(t.constructor===Float32Array)return n;let e=Jd(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var hc={DEG2RAD:sa,RAD2DEG:ro,generateUUID:yo,clamp:me,euclideanModulo:Zd,mapLinear:Vx,inverseLerp:Hx,lerp:ra,damp:Wx,pingpong:Xx,smoothstep:$x,smootherstep:qx,randInt:Yx,randFloat:Zx,randFloatSpread:Kx,seededRandom:Jx,degToRad:jx,radToDeg:Qx,isPowerOfTwo:ty,ceilPowerOfTwo:ey,floorPowerOfTwo:Kd,setQuaternionFromProperEuler:iy,normalize:og,denormalize:rg},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(me(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Me=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],h=i[s+1],c=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],_=r[o+2],w=r[o+3];if(u!==w||l!==d||h!==f||c!==_){let m=l*d+h*f+c*_+u*w;m<0&&(d=-d,f=-f,_=-_,w=-w,m=-m);let p=1-a;if(m<.9995){let v=Math.acos(m),R=Math.sin(v);p=Math.sin(p*v)/R,a=Math.sin(a*v)/R,l=l*p+d*a,h=h*p+f*a,c=c*p+_*a,u=u*p+w*a}else{l=l*p+d*a,h=h*p+f*a,c=c*p+_*a,u=u*p+w*a;let v=1/Math.sqrt(l*l+h*h+c*c+u*u);l*=v,h*=v,c*=v,u*=v}}t[e]=l,t[e+1]=h,t[e+2]=c,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],h=i[s+2],c=i[s+3],u=r[o],d=r[o+1],f=r[o+2],_=r[o+3];return t[e]=a*_+c*u+l*f-h*d,t[e+1]=l*_+c*d+h*u-a*f,t[e+2]=h*_+c*f+a*d-l*u,t[e+3]=c*_-a*u-l*d-h*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,h=a(i/2),c=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=d*c*u+h*f*_,this._y=h*f*u-d*c*_,this._z=h*c*_+d*f*u,this._w=h*c*u-d*f*_;break;case"YXZ":this._x=d*c*u+h*f*_,this._y=h*f*u-d*c*_,this._z=h*c*_-d*f*u,this._w=h*c*u+d*f*_;break;case"ZXY":this._x=d*c*u-h*f*_,this._y=h*f*u+d*c*_,this._z=h*c*_+d*f*u,this._w=h*c*u-d*f*_;break;case"ZYX":this._x=d*c*u-h*f*_,this._y=h*f*u+d*c*_,this._z=h*c*_-d*f*u,this._w=h*c*u+d*f*_;break;case"YZX":this._x=d*c*u+h*f*_,this._y=h*f*u+d*c*_,this._z=h*c*_-d*f*u,this._w=h*c*u-d*f*_;break;case"XZY":this._x=d*c*u-h*f*_,this._y=h*f*u-d*c*_,this._z=h*c*_+d*f*u,this._w=h*c*u+d*f*_;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],h=e[2],c=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(c-l)*f,this._y=(r-h)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(c-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+h)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-h)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+c)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+h)/f,this._y=(l+c)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(me(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,h=e._z,c=e._w;return this._x=i*c+o*a+s*h-r*l,this._y=s*c+o*l+r*a-i*h,this._z=r*c+o*h+i*l-s*a,this._w=o*c-i*a-s*l-r*h,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let h=Math.acos(a),c=Math.sin(h);l=Math.sin(l*h)/c,e=Math.sin(e*h)/c,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Yp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Yp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,h=2*(o*s-a*i),c=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*h+o*u-a*c,this.y=i+l*c+a*h-r*u,this.z=s+l*u+r*c-o*h,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this.z=me(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this.z=me(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Xu.copy(this).projectOnVector(t),this.sub(Xu)}reflect(t){return this.sub(Xu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(me(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Xu=new B,Yp=new Me,ne=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,h){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,h)}set(t,e,i,s,r,o,a,l,h){let c=this.elements;return c[0]=t,c[1]=s,c[2]=a,c[3]=e,c[4]=r,c[5]=l,c[6]=i,c[7]=o,c[8]=h,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],h=i[1],c=i[4],u=i[7],d=i[2],f=i[5],_=i[8],w=s[0],m=s[3],p=s[6],v=s[1],R=s[4],b=s[7],C=s[2],E=s[5],y=s[8];return r[0]=o*w+a*v+l*C,r[3]=o*m+a*R+l*E,r[6]=o*p+a*b+l*y,r[1]=h*w+c*v+u*C,r[4]=h*m+c*R+u*E,r[7]=h*p+c*b+u*y,r[2]=d*w+f*v+_*C,r[5]=d*m+f*R+_*E,r[8]=d*p+f*b+_*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],h=t[7],c=t[8];return e*o*c-e*a*h-i*r*c+i*a*l+s*r*h-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],h=t[7],c=t[8],u=c*o-a*h,d=a*l-c*r,f=h*r-o*l,_=e*u+i*d+s*f;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);let w=1/_;return t[0]=u*w,t[1]=(s*h-c*i)*w,t[2]=(a*i-s*o)*w,t[3]=d*w,t[4]=(c*e-s*l)*w,t[5]=(s*r-a*e)*w,t[6]=f*w,t[7]=(i*l-h*e)*w,t[8]=(o*e-i*r)*w,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),h=Math.sin(r);return this.set(i*l,i*h,-i*(l*o+h*a)+o+t,-s*h,s*l,-s*(-h*o+l*a)+a+e,0,0,1),this}scale(t,e){return na("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply($u.makeScale(t,e)),this}rotate(t){return na("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply($u.makeRotation(-t)),this}translate(t,e){return na("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply($u.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},$u=new ne,Zp=new ne().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Kp=new ne().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ny(){let n={enabled:!0,workingColorSpace:aa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Le&&(s.r=_s(s.r),s.g=_s(s.g),s.b=_s(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Le&&(s.r=eo(s.r),s.g=eo(s.g),s.b=eo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ms?la:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[aa]:{primaries:t,whitePoint:i,transfer:la,toXYZ:Zp,fromXYZ:Kp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:cn},outputColorSpaceConfig:{drawingBufferColorSpace:cn}},[cn]:{primaries:t,whitePoint:i,transfer:Le,toXYZ:Zp,fromXYZ:Kp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:cn}}}),n}var ye=ny();function _s(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function eo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Vr,th=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Vr===void 0&&(Vr=ha("canvas")),Vr.width=t.width,Vr.height=t.height;let s=Vr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Vr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=ha("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=_s(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(_s(e[i]/255)*255):e[i]=_s(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},sy=0,oo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:sy++}),this.uuid=yo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(qu(s[o].image)):r.push(qu(s[o]))}else r=qu(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function qu(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?th.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var ry=0,Yu=new B,Qi=class n extends Nn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Qn,s=Qn,r=Ki,o=ws,a=Bn,l=tn,h=n.DEFAULT_ANISOTROPY,c=Ms){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ry++}),this.uuid=yo(),this.name="",this.source=new oo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=h,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ne,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=c,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Yu).x}get height(){return this.source.getSize(Yu).y}get depth(){return this.source.getSize(Yu).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Dd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Jl:t.x=t.x-Math.floor(t.x);break;case Qn:t.x=t.x<0?0:1;break;case jl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Jl:t.y=t.y-Math.floor(t.y);break;case Qn:t.y=t.y<0?0:1;break;case jl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Qi.DEFAULT_IMAGE=null;Qi.DEFAULT_MAPPING=Dd;Qi.DEFAULT_ANISOTROPY=1;var Qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,h=l[0],c=l[4],u=l[8],d=l[1],f=l[5],_=l[9],w=l[2],m=l[6],p=l[10];if(Math.abs(c-d)<.01&&Math.abs(u-w)<.01&&Math.abs(_-m)<.01){if(Math.abs(c+d)<.1&&Math.abs(u+w)<.1&&Math.abs(_+m)<.1&&Math.abs(h+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let R=(h+1)/2,b=(f+1)/2,C=(p+1)/2,E=(c+d)/4,y=(u+w)/4,T=(_+m)/4;return R>b&&R>C?R<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(R),s=E/i,r=y/i):b>C?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=E/s,r=T/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=y/r,s=T/r),this.set(i,s,r,e),this}let v=Math.sqrt((m-_)*(m-_)+(u-w)*(u-w)+(d-c)*(d-c));return Math.abs(v)<.001&&(v=1),this.x=(m-_)/v,this.y=(u-w)/v,this.z=(d-c)/v,this.w=Math.acos((h+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=me(this.x,t.x,e.x),this.y=me(this.y,t.y,e.y),this.z=me(this.z,t.z,e.z),this.w=me(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=me(this.x,t,e),this.y=me(this.y,t,e),this.z=me(this.z,t,e),this.w=me(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(me(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},eh=class extends Nn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ki,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Qe(0,0,t,e),this.scissorTest=!1,this.viewport=new Qe(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Qi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ki,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new oo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},dn=class extends eh{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},ca=class extends Qi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Di,this.minFilter=Di,this.wrapR=Qn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var ih=class extends Qi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Di,this.minFilter=Di,this.wrapR=Qn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var Ce=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,h,c,u,d,f,_,w,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,h,c,u,d,f,_,w,m)}set(t,e,i,s,r,o,a,l,h,c,u,d,f,_,w,m){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=h,p[6]=c,p[10]=u,p[14]=d,p[3]=f,p[7]=_,p[11]=w,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Hr.setFromMatrixColumn(t,0).length(),r=1/Hr.setFromMatrixColumn(t,1).length(),o=1/Hr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),h=Math.sin(s),c=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*c,f=o*u,_=a*c,w=a*u;e[0]=l*c,e[4]=-l*u,e[8]=h,e[1]=f+_*h,e[5]=d-w*h,e[9]=-a*l,e[2]=w-d*h,e[6]=_+f*h,e[10]=o*l}else if(t.order==="YXZ"){let d=l*c,f=l*u,_=h*c,w=h*u;e[0]=d+w*a,e[4]=_*a-f,e[8]=o*h,e[1]=o*u,e[5]=o*c,e[9]=-a,e[2]=f*a-_,e[6]=w+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*c,f=l*u,_=h*c,w=h*u;e[0]=d-w*a,e[4]=-o*u,e[8]=_+f*a,e[1]=f+_*a,e[5]=o*c,e[9]=w-d*a,e[2]=-o*h,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*c,f=o*u,_=a*c,w=a*u;e[0]=l*c,e[4]=_*h-f,e[8]=d*h+w,e[1]=l*u,e[5]=w*h+d,e[9]=f*h-_,e[2]=-h,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*h,_=a*l,w=a*h;e[0]=l*c,e[4]=w-d*u,e[8]=_*u+f,e[1]=u,e[5]=o*c,e[9]=-a*c,e[2]=-h*c,e[6]=f*u+_,e[10]=d-w*u}else if(t.order==="XZY"){let d=o*l,f=o*h,_=a*l,w=a*h;e[0]=l*c,e[4]=-u,e[8]=h*c,e[1]=d*u+w,e[5]=o*c,e[9]=f*u-_,e[2]=_*u-f,e[6]=a*c,e[10]=w*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(oy,t,ay)}lookAt(t,e,i){let s=this.elements;return ln.subVectors(t,e),ln.lengthSq()===0&&(ln.z=1),ln.normalize(),Ns.crossVectors(i,ln),Ns.lengthSq()===0&&(Math.abs(i.z)===1?ln.x+=1e-4:ln.z+=1e-4,ln.normalize(),Ns.crossVectors(i,ln)),Ns.normalize(),vl.crossVectors(ln,Ns),s[0]=Ns.x,s[4]=vl.x,s[8]=ln.x,s[1]=Ns.y,s[5]=vl.y,s[9]=ln.y,s[2]=Ns.z,s[6]=vl.z,s[10]=ln.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],h=i[12],c=i[1],u=i[5],d=i[9],f=i[13],_=i[2],w=i[6],m=i[10],p=i[14],v=i[3],R=i[7],b=i[11],C=i[15],E=s[0],y=s[4],T=s[8],U=s[12],L=s[1],D=s[5],z=s[9],V=s[13],N=s[2],W=s[6],q=s[10],H=s[14],lt=s[3],Z=s[7],j=s[11],et=s[15];return r[0]=o*E+a*L+l*N+h*lt,r[4]=o*y+a*D+l*W+h*Z,r[8]=o*T+a*z+l*q+h*j,r[12]=o*U+a*V+l*H+h*et,r[1]=c*E+u*L+d*N+f*lt,r[5]=c*y+u*D+d*W+f*Z,r[9]=c*T+u*z+d*q+f*j,r[13]=c*U+u*V+d*H+f*et,r[2]=_*E+w*L+m*N+p*lt,r[6]=_*y+w*D+m*W+p*Z,r[10]=_*T+w*z+m*q+p*j,r[14]=_*U+w*V+m*H+p*et,r[3]=v*E+R*L+b*N+C*lt,r[7]=v*y+R*D+b*W+C*Z,r[11]=v*T+R*z+b*q+C*j,r[15]=v*U+R*V+b*H+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],h=t[13],c=t[2],u=t[6],d=t[10],f=t[14],_=t[3],w=t[7],m=t[11],p=t[15],v=l*f-h*d,R=a*f-h*u,b=a*d-l*u,C=o*f-h*c,E=o*d-l*c,y=o*u-a*c;return e*(w*v-m*R+p*b)-i*(_*v-m*C+p*E)+s*(_*R-w*C+p*y)-r*(_*b-w*E+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],h=t[6],c=t[10];return e*(o*c-a*h)-i*(r*c-a*l)+s*(r*h-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],h=t[7],c=t[8],u=t[9],d=t[10],f=t[11],_=t[12],w=t[13],m=t[14],p=t[15],v=e*a-i*o,R=e*l-s*o,b=e*h-r*o,C=i*l-s*a,E=i*h-r*a,y=s*h-r*l,T=c*w-u*_,U=c*m-d*_,L=c*p-f*_,D=u*m-d*w,z=u*p-f*w,V=d*p-f*m,N=v*V-R*z+b*D+C*L-E*U+y*T;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return t[0]=(a*V-l*z+h*D)*W,t[1]=(s*z-i*V-r*D)*W,t[2]=(w*y-m*E+p*C)*W,t[3]=(d*E-u*y-f*C)*W,t[4]=(l*L-o*V-h*U)*W,t[5]=(e*V-s*L+r*U)*W,t[6]=(m*b-_*y-p*R)*W,t[7]=(c*y-d*b+f*R)*W,t[8]=(o*z-a*L+h*T)*W,t[9]=(i*L-e*z-r*T)*W,t[10]=(_*E-w*b+p*v)*W,t[11]=(u*b-c*E-f*v)*W,t[12]=(a*U-o*D-l*T)*W,t[13]=(e*D-i*U+s*T)*W,t[14]=(w*R-_*C-m*v)*W,t[15]=(c*C-u*R+d*v)*W,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,h=r*o,c=r*a;return this.set(h*o+i,h*a-s*l,h*l+s*a,0,h*a+s*l,c*a+i,c*l-s*o,0,h*l-s*a,c*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,h=r+r,c=o+o,u=a+a,d=r*h,f=r*c,_=r*u,w=o*c,m=o*u,p=a*u,v=l*h,R=l*c,b=l*u,C=i.x,E=i.y,y=i.z;return s[0]=(1-(w+p))*C,s[1]=(f+b)*C,s[2]=(_-R)*C,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(d+p))*E,s[6]=(m+v)*E,s[7]=0,s[8]=(_+R)*y,s[9]=(m-v)*y,s[10]=(1-(d+w))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Hr.set(s[0],s[1],s[2]).length(),a=Hr.set(s[4],s[5],s[6]).length(),l=Hr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),In.copy(this);let h=1/o,c=1/a,u=1/l;return In.elements[0]*=h,In.elements[1]*=h,In.elements[2]*=h,In.elements[4]*=c,In.elements[5]*=c,In.elements[6]*=c,In.elements[8]*=u,In.elements[9]*=u,In.elements[10]*=u,e.setFromRotationMatrix(In),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=wn,l=!1){let h=this.elements,c=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),_,w;if(l)_=r/(o-r),w=o*r/(o-r);else if(a===wn)_=-(o+r)/(o-r),w=-2*o*r/(o-r);else if(a===no)_=-o/(o-r),w=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return h[0]=c,h[4]=0,h[8]=d,h[12]=0,h[1]=0,h[5]=u,h[9]=f,h[13]=0,h[2]=0,h[6]=0,h[10]=_,h[14]=w,h[3]=0,h[7]=0,h[11]=-1,h[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=wn,l=!1){let h=this.elements,c=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),_,w;if(l)_=1/(o-r),w=o/(o-r);else if(a===wn)_=-2/(o-r),w=-(o+r)/(o-r);else if(a===no)_=-1/(o-r),w=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return h[0]=c,h[4]=0,h[8]=0,h[12]=d,h[1]=0,h[5]=u,h[9]=0,h[13]=f,h[2]=0,h[6]=0,h[10]=_,h[14]=w,h[3]=0,h[7]=0,h[11]=0,h[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Hr=new B,In=new Ce,oy=new B(0,0,0),ay=new B(1,1,1),Ns=new B,vl=new B,ln=new B,Jp=new Ce,jp=new Me,ys=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],h=s[5],c=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(me(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-c,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,h),this._z=0);break;case"YXZ":this._x=Math.asin(-me(c,-1,1)),Math.abs(c)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,h)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(me(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,h)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-me(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,h));break;case"YZX":this._z=Math.asin(me(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-c,h),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-me(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,h),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-c,f),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Jp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Jp,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return jp.setFromEuler(this),this.setFromQuaternion(jp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ys.DEFAULT_ORDER="XYZ";var ao=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},ly=0,Qp=new B,Wr=new Me,ds=new Ce,bl=new B,jo=new B,hy=new B,cy=new Me,tm=new B(1,0,0),em=new B(0,1,0),im=new B(0,0,1),nm={type:"added"},uy={type:"removed"},Xr={type:"childadded",child:null},Zu={type:"childremoved",child:null},Oi=class n extends Nn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ly++}),this.uuid=yo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new B,e=new ys,i=new Me,s=new B(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ce},normalMatrix:{value:new ne}}),this.matrix=new Ce,this.matrixWorld=new Ce,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Wr.setFromAxisAngle(t,e),this.quaternion.multiply(Wr),this}rotateOnWorldAxis(t,e){return Wr.setFromAxisAngle(t,e),this.quaternion.premultiply(Wr),this}rotateX(t){return this.rotateOnAxis(tm,t)}rotateY(t){return this.rotateOnAxis(em,t)}rotateZ(t){return this.rotateOnAxis(im,t)}translateOnAxis(t,e){return Qp.copy(t).applyQuaternion(this.quaternion),this.position.add(Qp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(tm,t)}translateY(t){return this.translateOnAxis(em,t)}translateZ(t){return this.translateOnAxis(im,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ds.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?bl.copy(t):bl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),jo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ds.lookAt(jo,bl,this.up):ds.lookAt(bl,jo,this.up),this.quaternion.setFromRotationMatrix(ds),s&&(ds.extractRotation(s.matrixWorld),Wr.setFromRotationMatrix(ds),this.quaternion.premultiply(Wr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(te("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(nm),Xr.child=t,this.dispatchEvent(Xr),Xr.child=null):te("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(uy),Zu.child=t,this.dispatchEvent(Zu),Zu.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(nm),Xr.child=t,this.dispatchEvent(Xr),Xr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jo,t,hy),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jo,cy,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let h=0,c=l.length;h<c;h++){let u=l[h];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,h=this.material.length;l<h;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),h=o(t.textures),c=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),_=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),h.length>0&&(i.textures=h),c.length>0&&(i.images=c),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),_.length>0&&(i.nodes=_)}return i.object=s,i;function o(a){let l=[];for(let h in a){let c=a[h];delete c.metadata,l.push(c)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Oi.DEFAULT_UP=new B(0,1,0);Oi.DEFAULT_MATRIX_AUTO_UPDATE=!0;Oi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ge=class extends Oi{constructor(){super(),this.isGroup=!0,this.type="Group"}},dy={type:"move"},lo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ge,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ge,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ge,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,h=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(h&&t.hand){o=!0;for(let w of t.hand.values()){let m=e.getJointPose(w,i),p=this._getHandJoint(h,w);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let c=h.joints["index-finger-tip"],u=h.joints["thumb-tip"],d=c.position.distanceTo(u.position),f=.02,_=.005;h.inputState.pinching&&d>f+_?(h.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!h.inputState.pinching&&d<=f-_&&(h.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(dy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),h!==null&&(h.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new ge;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},ag={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fs={h:0,s:0,l:0},wl={h:0,s:0,l:0};function Ku(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ie=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=cn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ye.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ye.workingColorSpace){return this.r=t,this.g=e,this.b=i,ye.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ye.workingColorSpace){if(t=Zd(t,1),e=me(e,0,1),i=me(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Ku(o,r,t+1/3),this.g=Ku(o,r,t),this.b=Ku(o,r,t-1/3)}return ye.colorSpaceToWorking(this,s),this}setStyle(t,e=cn){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=cn){let i=ag[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=_s(t.r),this.g=_s(t.g),this.b=_s(t.b),this}copyLinearToSRGB(t){return this.r=eo(t.r),this.g=eo(t.g),this.b=eo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=cn){return ye.workingToColorSpace(Gi.copy(this),t),Math.round(me(Gi.r*255,0,255))*65536+Math.round(me(Gi.g*255,0,255))*256+Math.round(me(Gi.b*255,0,255))}getHexString(t=cn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ye.workingColorSpace){ye.workingToColorSpace(Gi.copy(this),e);let i=Gi.r,s=Gi.g,r=Gi.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,h,c=(a+o)/2;if(a===o)l=0,h=0;else{let u=o-a;switch(h=c<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=h,t.l=c,t}getRGB(t,e=ye.workingColorSpace){return ye.workingToColorSpace(Gi.copy(this),e),t.r=Gi.r,t.g=Gi.g,t.b=Gi.b,t}getStyle(t=cn){ye.workingToColorSpace(Gi.copy(this),t);let e=Gi.r,i=Gi.g,s=Gi.b;return t!==cn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Fs),this.setHSL(Fs.h+t,Fs.s+e,Fs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Fs),t.getHSL(wl);let i=ra(Fs.h,wl.h,e),s=ra(Fs.s,wl.s,e),r=ra(Fs.l,wl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gi=new ie;ie.NAMES=ag;var ua=class n{constructor(t,e=1,i=1e3){this.isFog=!0,this.name="",this.color=new ie(t),this.near=e,this.far=i}clone(){return new n(this.color,this.near,this.far)}toJSON(){return{type:"Fog",name:this.name,color:this.color.getHex(),near:this.near,far:this.far}}},da=class extends Oi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ys,this.environmentIntensity=1,this.environmentRotation=new ys,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ln=new B,fs=new B,Ju=new B,ps=new B,$r=new B,qr=new B,sm=new B,ju=new B,Qu=new B,td=new B,ed=new Qe,id=new Qe,nd=new Qe,Bs=class n{constructor(t=new B,e=new B,i=new B){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ln.subVectors(t,e),s.cross(Ln);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ln.subVectors(s,e),fs.subVectors(i,e),Ju.subVectors(t,e);let o=Ln.dot(Ln),a=Ln.dot(fs),l=Ln.dot(Ju),h=fs.dot(fs),c=fs.dot(Ju),u=o*h-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(h*l-a*c)*d,_=(o*c-a*l)*d;return r.set(1-f-_,_,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ps)===null?!1:ps.x>=0&&ps.y>=0&&ps.x+ps.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ps)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ps.x),l.addScaledVector(o,ps.y),l.addScaledVector(a,ps.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return ed.setScalar(0),id.setScalar(0),nd.setScalar(0),ed.fromBufferAttribute(t,e),id.fromBufferAttribute(t,i),nd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ed,r.x),o.addScaledVector(id,r.y),o.addScaledVector(nd,r.z),o}static isFrontFacing(t,e,i,s){return Ln.subVectors(i,e),fs.subVectors(t,e),Ln.cross(fs).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ln.subVectors(this.c,this.b),fs.subVectors(this.a,this.b),Ln.cross(fs).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;$r.subVectors(s,i),qr.subVectors(r,i),ju.subVectors(t,i);let l=$r.dot(ju),h=qr.dot(ju);if(l<=0&&h<=0)return e.copy(i);Qu.subVectors(t,s);let c=$r.dot(Qu),u=qr.dot(Qu);if(c>=0&&u<=c)return e.copy(s);let d=l*u-c*h;if(d<=0&&l>=0&&c<=0&&l-c>0)return o=l/(l-c),e.copy(i).addScaledVector($r,o);td.subVectors(t,r);let f=$r.dot(td),_=qr.dot(td);if(_>=0&&f<=_)return e.copy(r);let w=f*h-l*_;if(w<=0&&h>=0&&_<=0)return a=h/(h-_),e.copy(i).addScaledVector(qr,a);let m=c*_-f*u;if(m<=0&&u-c>=0&&f-_>=0)return sm.subVectors(r,s),a=(u-c)/(u-c+(f-_)),e.copy(s).addScaledVector(sm,a);let p=1/(m+w+d);return o=w*p,a=d*p,e.copy(i).addScaledVector($r,o).addScaledVector(qr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ts=class{constructor(t=new B(1/0,1/0,1/0),e=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Dn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Dn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Dn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Dn):Dn.fromBufferAttribute(r,o),Dn.applyMatrix4(t.matrixWorld),this.expandByPoint(Dn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Sl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Sl.copy(i.boundingBox)),Sl.applyMatrix4(t.matrixWorld),this.union(Sl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Dn),Dn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Qo),Ml.subVectors(this.max,Qo),Yr.subVectors(t.a,Qo),Zr.subVectors(t.b,Qo),Kr.subVectors(t.c,Qo),Us.subVectors(Zr,Yr),Os.subVectors(Kr,Zr),hr.subVectors(Yr,Kr);let e=[0,-Us.z,Us.y,0,-Os.z,Os.y,0,-hr.z,hr.y,Us.z,0,-Us.x,Os.z,0,-Os.x,hr.z,0,-hr.x,-Us.y,Us.x,0,-Os.y,Os.x,0,-hr.y,hr.x,0];return!sd(e,Yr,Zr,Kr,Ml)||(e=[1,0,0,0,1,0,0,0,1],!sd(e,Yr,Zr,Kr,Ml))?!1:(Al.crossVectors(Us,Os),e=[Al.x,Al.y,Al.z],sd(e,Yr,Zr,Kr,Ml))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Dn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Dn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ms),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ms=[new B,new B,new B,new B,new B,new B,new B,new B],Dn=new B,Sl=new ts,Yr=new B,Zr=new B,Kr=new B,Us=new B,Os=new B,hr=new B,Qo=new B,Ml=new B,Al=new B,cr=new B;function sd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){cr.fromArray(n,r);let a=s.x*Math.abs(cr.x)+s.y*Math.abs(cr.y)+s.z*Math.abs(cr.z),l=t.dot(cr),h=e.dot(cr),c=i.dot(cr);if(Math.max(-Math.max(l,h,c),Math.min(l,h,c))>a)return!1}return!0}var xi=new B,Tl=new Yt,fy=0,li=class extends Nn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:fy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=tg,this.updateRanges=[],this.gpuType=On,this.version=0,this._normalizationScale=t!==void 0?Jd(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Tl.fromBufferAttribute(this,e),Tl.applyMatrix3(t),this.setXY(e,Tl.x,Tl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)xi.fromBufferAttribute(this,e),xi.applyMatrix3(t),this.setXYZ(e,xi.x,xi.y,xi.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)xi.fromBufferAttribute(this,e),xi.applyMatrix4(t),this.setXYZ(e,xi.x,xi.y,xi.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)xi.fromBufferAttribute(this,e),xi.applyNormalMatrix(t),this.setXYZ(e,xi.x,xi.y,xi.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)xi.fromBufferAttribute(this,e),xi.transformDirection(t),this.setXYZ(e,xi.x,xi.y,xi.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):rg(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):og(t,this.array)}};var fa=class extends li{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var pa=class extends li{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var we=class extends li{constructor(t,e,i){super(new Float32Array(t),e,i)}},py=new ts,ta=new B,rd=new B,fr=class{constructor(t=new B,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):py.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ta.subVectors(t,this.center);let e=ta.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ta,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(rd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ta.copy(t.center).add(rd)),this.expandByPoint(ta.copy(t.center).sub(rd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},my=0,bn=new Ce,od=new Oi,Jr=new B,hn=new ts,ea=new ts,Li=new B,ti=class n extends Nn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:my++}),this.uuid=yo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(zx(t)?pa:fa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ne().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return bn.makeRotationFromQuaternion(t),this.applyMatrix4(bn),this}rotateX(t){return bn.makeRotationX(t),this.applyMatrix4(bn),this}rotateY(t){return bn.makeRotationY(t),this.applyMatrix4(bn),this}rotateZ(t){return bn.makeRotationZ(t),this.applyMatrix4(bn),this}translate(t,e,i){return bn.makeTranslation(t,e,i),this.applyMatrix4(bn),this}scale(t,e,i){return bn.makeScale(t,e,i),this.applyMatrix4(bn),this}lookAt(t){return od.lookAt(t),od.updateMatrix(),this.applyMatrix4(od.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jr).negate(),this.translate(Jr.x,Jr.y,Jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new we(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ts);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];hn.setFromBufferAttribute(r),this.morphTargetsRelative?(Li.addVectors(this.boundingBox.min,hn.min),this.boundingBox.expandByPoint(Li),Li.addVectors(this.boundingBox.max,hn.max),this.boundingBox.expandByPoint(Li)):(this.boundingBox.expandByPoint(hn.min),this.boundingBox.expandByPoint(hn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&te('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new fr);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){te("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(t){let i=this.boundingSphere.center;if(hn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ea.setFromBufferAttribute(a),this.morphTargetsRelative?(Li.addVectors(hn.min,ea.min),hn.expandByPoint(Li),Li.addVectors(hn.max,ea.max),hn.expandByPoint(Li)):(hn.expandByPoint(ea.min),hn.expandByPoint(ea.max))}hn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Li.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Li));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let h=0,c=a.count;h<c;h++)Li.fromBufferAttribute(a,h),l&&(Jr.fromBufferAttribute(t,h),Li.add(Jr)),s=Math.max(s,i.distanceToSquared(Li))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&te('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){te("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new li(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],h=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new B,l[U]=new B;let c=new B,u=new B,d=new B,f=new Yt,_=new Yt,w=new Yt,m=new B,p=new B;function v(U,L,D){h[U]=h[L]=h[D]=1,c.fromBufferAttribute(i,U),u.fromBufferAttribute(i,L),d.fromBufferAttribute(i,D),f.fromBufferAttribute(r,U),_.fromBufferAttribute(r,L),w.fromBufferAttribute(r,D),u.sub(c),d.sub(c),_.sub(f),w.sub(f);let z=1/(_.x*w.y-w.x*_.y);isFinite(z)&&(m.copy(u).multiplyScalar(w.y).addScaledVector(d,-_.y).multiplyScalar(z),p.copy(d).multiplyScalar(_.x).addScaledVector(u,-w.x).multiplyScalar(z),a[U].add(m),a[L].add(m),a[D].add(m),l[U].add(p),l[L].add(p),l[D].add(p))}let R=this.groups;R.length===0&&(R=[{start:0,count:t.count}]);for(let U=0,L=R.length;U<L;++U){let D=R[U],z=D.start,V=D.count;for(let N=z,W=z+V;N<W;N+=3)v(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let b=new B,C=new B,E=new B,y=new B;function T(U){E.fromBufferAttribute(s,U),y.copy(E);let L=a[U];b.copy(L),b.sub(E.multiplyScalar(E.dot(L))).normalize(),C.crossVectors(y,L);let z=C.dot(l[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,z)}for(let U=0,L=i.count;U<L;++U)h[U]&&T(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new li(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,h=new B,c=new B,u=new B;if(t)for(let d=0,f=t.count;d<f;d+=3){let _=t.getX(d+0),w=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,w),o.fromBufferAttribute(e,m),c.subVectors(o,r),u.subVectors(s,r),c.cross(u),a.fromBufferAttribute(i,_),l.fromBufferAttribute(i,w),h.fromBufferAttribute(i,m),a.add(c),l.add(c),h.add(c),i.setXYZ(_,a.x,a.y,a.z),i.setXYZ(w,l.x,l.y,l.z),i.setXYZ(m,h.x,h.y,h.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),c.subVectors(o,r),u.subVectors(s,r),c.cross(u),i.setXYZ(d+0,c.x,c.y,c.z),i.setXYZ(d+1,c.x,c.y,c.z),i.setXYZ(d+2,c.x,c.y,c.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Li.fromBufferAttribute(t,e),Li.normalize(),t.setXYZ(e,Li.x,Li.y,Li.z)}toNonIndexed(){function t(a,l){let h=a.array,c=a.itemSize,u=a.normalized,d=new h.constructor(l.length*c),f=0,_=0;for(let w=0,m=l.length;w<m;w++){a.isInterleavedBufferAttribute?f=l[w]*a.data.stride+a.offset:f=l[w]*c;for(let p=0;p<c;p++)d[_++]=h[f++]}return new li(d,c,u)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],h=t(l,i);e.setAttribute(a,h)}let r=this.morphAttributes;for(let a in r){let l=[],h=r[a];for(let c=0,u=h.length;c<u;c++){let d=h[c],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let h=o[a];e.addGroup(h.start,h.count,h.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let h in l)l[h]!==void 0&&(t[h]=l[h]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let h=i[l];t.data.attributes[l]=h.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let h=this.morphAttributes[l],c=[];for(let u=0,d=h.length;u<d;u++){let f=h[u];c.push(f.toJSON(t.data))}c.length>0&&(s[l]=c,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let h in s){let c=s[h];this.setAttribute(h,c.clone(e))}let r=t.morphAttributes;for(let h in r){let c=[],u=r[h];for(let d=0,f=u.length;d<f;d++)c.push(u[d].clone(e));this.morphAttributes[h]=c}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let h=0,c=o.length;h<c;h++){let u=o[h];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var ad=new B,gy=new B,_y=new ne,un=class{constructor(t=new B(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=ad.subVectors(i,e).cross(gy.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(ad),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||_y.getNormalMatrix(t),s=this.coplanarPoint(ad).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},xy=0,vs=class extends Nn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xy++}),this.uuid=yo(),this.name="",this.type="Material",this.blending=go,this.side=Zs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Md,this.blendDst=Ad,this.blendEquation=gr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ie(0,0,0),this.blendAlpha=0,this.depthFunc=io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ym,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Hl,this.stencilZFail=Hl,this.stencilZPass=Hl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ie().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new un().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var gs=new B,ld=new B,El=new B,Cl=new B,zs=class{constructor(t=new B,e=new B(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,gs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=gs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(gs.copy(this.origin).addScaledVector(this.direction,e),gs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){ld.copy(t).add(e).multiplyScalar(.5),El.copy(e).sub(t).normalize(),Cl.copy(this.origin).sub(ld);let r=t.distanceTo(e)*.5,o=-this.direction.dot(El),a=Cl.dot(this.direction),l=-Cl.dot(El),h=Cl.lengthSq(),c=Math.abs(1-o*o),u,d,f,_;if(c>0)if(u=o*l-a,d=o*a-l,_=r*c,u>=0)if(d>=-_)if(d<=_){let w=1/c;u*=w,d*=w,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+h}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+h;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+h;else d<=-_?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+h):d<=_?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+h):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+h);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+h;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ld).addScaledVector(El,d),f}intersectSphere(t,e){if(t.radius<0)return null;gs.subVectors(t.center,this.origin);let i=gs.dot(this.direction),s=gs.dot(gs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,h=1/this.direction.x,c=1/this.direction.y,u=1/this.direction.z,d=this.origin;return h>=0?(i=(t.min.x-d.x)*h,s=(t.max.x-d.x)*h):(i=(t.max.x-d.x)*h,s=(t.min.x-d.x)*h),c>=0?(r=(t.min.y-d.y)*c,o=(t.max.y-d.y)*c):(r=(t.max.y-d.y)*c,o=(t.min.y-d.y)*c),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,gs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,h=a.y,c=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,_=e.x-o.x,w=e.y-o.y,m=e.z-o.z,p=i.x-o.x,v=i.y-o.y,R=i.z-o.z,b=Math.abs(l),C=Math.abs(h),E=Math.abs(c),y,T,U,L,D,z,V,N,W,q,H,lt;if(b>=C&&b>=E?(U=l,z=u,W=_,lt=p,l>=0?(y=h,T=c,L=d,D=f,V=w,N=m,q=v,H=R):(y=c,T=h,L=f,D=d,V=m,N=w,q=R,H=v)):C>=E?(U=h,z=d,W=w,lt=v,h>=0?(y=c,T=l,L=f,D=u,V=m,N=_,q=R,H=p):(y=l,T=c,L=u,D=f,V=_,N=m,q=p,H=R)):(U=c,z=f,W=m,lt=R,c>=0?(y=l,T=h,L=u,D=d,V=_,N=w,q=p,H=v):(y=h,T=l,L=d,D=u,V=w,N=_,q=v,H=p)),U===0)return null;let Z=y/U,j=T/U,et=1/U,dt=L-Z*z,ut=D-j*z,tt=V-Z*W,mt=N-j*W,xt=q-Z*lt,Et=H-j*lt,wt=xt*mt-Et*tt,Wt=dt*Et-ut*xt,oe=tt*ut-mt*dt;if(s){if(wt<0||Wt<0||oe<0)return null}else if((wt<0||Wt<0||oe<0)&&(wt>0||Wt>0||oe>0))return null;let Vt=wt+Wt+oe;if(Vt===0)return null;let de=et*(wt*z+Wt*W+oe*lt);return(Vt>0?de<0:de>0)?null:this.at(de/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ho=class extends vs{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ie(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ys,this.combine=wh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},rm=new Ce,ur=new zs,Rl=new fr,om=new B,Pl=new B,Il=new B,Ll=new B,hd=new B,Dl=new B,am=new B,Nl=new B,Ae=class extends Oi{constructor(t=new ti,e=new ho){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Dl.set(0,0,0);for(let l=0,h=r.length;l<h;l++){let c=a[l],u=r[l];c!==0&&(hd.fromBufferAttribute(u,t),o?Dl.addScaledVector(hd,c):Dl.addScaledVector(hd.sub(e),c))}e.add(Dl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Rl.copy(i.boundingSphere),Rl.applyMatrix4(r),ur.copy(t.ray).recast(t.near),!(Rl.containsPoint(ur.origin)===!1&&(ur.intersectSphere(Rl,om)===null||ur.origin.distanceToSquared(om)>(t.far-t.near)**2))&&(rm.copy(r).invert(),ur.copy(t.ray).applyMatrix4(rm),!(i.boundingBox!==null&&ur.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,ur)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,h=r.attributes.uv,c=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,w=d.length;_<w;_++){let m=d[_],p=o[m.materialIndex],v=Math.max(m.start,f.start),R=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,C=R;b<C;b+=3){let E=a.getX(b),y=a.getX(b+1),T=a.getX(b+2);s=Fl(this,p,t,i,h,c,u,E,y,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let _=Math.max(0,f.start),w=Math.min(a.count,f.start+f.count);for(let m=_,p=w;m<p;m+=3){let v=a.getX(m),R=a.getX(m+1),b=a.getX(m+2);s=Fl(this,o,t,i,h,c,u,v,R,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,w=d.length;_<w;_++){let m=d[_],p=o[m.materialIndex],v=Math.max(m.start,f.start),R=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,C=R;b<C;b+=3){let E=b,y=b+1,T=b+2;s=Fl(this,p,t,i,h,c,u,E,y,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let _=Math.max(0,f.start),w=Math.min(l.count,f.start+f.count);for(let m=_,p=w;m<p;m+=3){let v=m,R=m+1,b=m+2;s=Fl(this,o,t,i,h,c,u,v,R,b),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function yy(n,t,e,i,s,r,o,a){let l;if(t.side===Ji?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Zs,a),l===null)return null;Nl.copy(a),Nl.applyMatrix4(n.matrixWorld);let h=e.ray.origin.distanceTo(Nl);return h<e.near||h>e.far?null:{distance:h,point:Nl.clone(),object:n}}function Fl(n,t,e,i,s,r,o,a,l,h){n.getVertexPosition(a,Pl),n.getVertexPosition(l,Il),n.getVertexPosition(h,Ll);let c=yy(n,t,e,i,Pl,Il,Ll,am);if(c){let u=new B;Bs.getBarycoord(am,Pl,Il,Ll,u),s&&(c.uv=Bs.getInterpolatedAttribute(s,a,l,h,u,new Yt)),r&&(c.uv1=Bs.getInterpolatedAttribute(r,a,l,h,u,new Yt)),o&&(c.normal=Bs.getInterpolatedAttribute(o,a,l,h,u,new B),c.normal.dot(i.direction)>0&&c.normal.multiplyScalar(-1));let d={a,b:l,c:h,normal:new B,materialIndex:0};Bs.getNormal(Pl,Il,Ll,d.normal),c.face=d,c.barycoord=u}return c}var nh=class extends Qi{constructor(t=null,e=1,i=1,s,r,o,a,l,h=Di,c=Di,u,d){super(null,o,a,l,h,c,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var dr=new fr,vy=new Yt(.5,.5),Ul=new B,Gs=class{constructor(t=new un,e=new un,i=new un,s=new un,r=new un,o=new un){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=wn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],h=r[3],c=r[4],u=r[5],d=r[6],f=r[7],_=r[8],w=r[9],m=r[10],p=r[11],v=r[12],R=r[13],b=r[14],C=r[15];if(s[0].setComponents(h-o,f-c,p-_,C-v).normalize(),s[1].setComponents(h+o,f+c,p+_,C+v).normalize(),s[2].setComponents(h+a,f+u,p+w,C+R).normalize(),s[3].setComponents(h-a,f-u,p-w,C-R).normalize(),i)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(h-l,f-d,p-m,C-b).normalize();else if(s[4].setComponents(h-l,f-d,p-m,C-b).normalize(),e===wn)s[5].setComponents(h+l,f+d,p+m,C+b).normalize();else if(e===no)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),dr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),dr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(dr)}intersectsSprite(t){dr.center.set(0,0,0);let e=vy.distanceTo(t.center);return dr.radius=.7071067811865476+e,dr.applyMatrix4(t.matrixWorld),this.intersectsSphere(dr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Ul.x=s.normal.x>0?t.max.x:t.min.x,Ul.y=s.normal.y>0?t.max.y:t.min.y,Ul.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ul)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},lm=new Ce,sh=class n{constructor(){this.coordinateSystem=wn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];lm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Gs),i[s].setFromProjectionMatrix(lm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Gs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var co=class extends vs{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ie(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},rh=new B,oh=new B,hm=new Ce,ia=new zs,Ol=new fr,cd=new B,cm=new B,Vs=class extends Oi{constructor(t=new ti,e=new co){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)rh.fromBufferAttribute(e,s-1),oh.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=rh.distanceTo(oh);t.setAttribute("lineDistance",new we(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ol.copy(i.boundingSphere),Ol.applyMatrix4(s),Ol.radius+=r,t.ray.intersectsSphere(Ol)===!1)return;hm.copy(s).invert(),ia.copy(t.ray).applyMatrix4(hm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,h=this.isLineSegments?2:1,c=i.index,d=i.attributes.position;if(c!==null){let f=Math.max(0,o.start),_=Math.min(c.count,o.start+o.count);for(let w=f,m=_-1;w<m;w+=h){let p=c.getX(w),v=c.getX(w+1),R=kl(this,t,ia,l,p,v,w);R&&e.push(R)}if(this.isLineLoop){let w=c.getX(_-1),m=c.getX(f),p=kl(this,t,ia,l,w,m,_-1);p&&e.push(p)}}else{let f=Math.max(0,o.start),_=Math.min(d.count,o.start+o.count);for(let w=f,m=_-1;w<m;w+=h){let p=kl(this,t,ia,l,w,w+1,w);p&&e.push(p)}if(this.isLineLoop){let w=kl(this,t,ia,l,_-1,f,_-1);w&&e.push(w)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function kl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(rh.fromBufferAttribute(a,s),oh.fromBufferAttribute(a,r),e.distanceSqToSegment(rh,oh,cd,cm)>i)return;cd.applyMatrix4(n.matrixWorld);let h=t.ray.origin.distanceTo(cd);if(!(h<t.near||h>t.far))return{distance:h,point:cm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var um=new B,dm=new B,ma=class extends Vs{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)um.fromBufferAttribute(e,s),dm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+um.distanceTo(dm);t.setAttribute("lineDistance",new we(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ga=class extends Qi{constructor(t=[],e=_r,i,s,r,o,a,l,h,c){super(t,e,i,s,r,o,a,l,h,c),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var bs=class extends Qi{constructor(t,e,i=Un,s,r,o,a=Di,l=Di,h,c=xs,u=1){if(c!==xs&&c!==Ss)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,c,i,h),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new oo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},_a=class extends bs{constructor(t,e=Un,i=_r,s,r,o=Di,a=Di,l,h=xs){let c={width:t,height:t,depth:1},u=[c,c,c,c,c,c];super(t,t,e,i,s,r,o,a,l,h),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},xa=class extends Qi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Sn=class n extends ti{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],h=[],c=[],u=[],d=0,f=0;_("z","y","x",-1,-1,i,e,t,o,r,0),_("z","y","x",1,-1,i,e,-t,o,r,1),_("x","z","y",1,1,t,i,e,s,o,2),_("x","z","y",1,-1,t,i,-e,s,o,3),_("x","y","z",1,-1,t,e,i,s,r,4),_("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new we(h,3)),this.setAttribute("normal",new we(c,3)),this.setAttribute("uv",new we(u,2));function _(w,m,p,v,R,b,C,E,y,T,U){let L=b/y,D=C/T,z=b/2,V=C/2,N=E/2,W=y+1,q=T+1,H=0,lt=0,Z=new B;for(let j=0;j<q;j++){let et=j*D-V;for(let dt=0;dt<W;dt++){let ut=dt*L-z;Z[w]=ut*v,Z[m]=et*R,Z[p]=N,h.push(Z.x,Z.y,Z.z),Z[w]=0,Z[m]=0,Z[p]=E>0?1:-1,c.push(Z.x,Z.y,Z.z),u.push(dt/y),u.push(1-j/T),H+=1}}for(let j=0;j<T;j++)for(let et=0;et<y;et++){let dt=d+et+W*j,ut=d+et+W*(j+1),tt=d+(et+1)+W*(j+1),mt=d+(et+1)+W*j;l.push(dt,ut,mt),l.push(ut,tt,mt),lt+=6}a.addGroup(f,lt,U),f+=lt,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},ya=class n extends ti{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],h=[],c=e/2,u=Math.PI/2*t,d=e,f=2*u+d,_=i*2+r,w=s+1,m=new B,p=new B;for(let v=0;v<=_;v++){let R=0,b=0,C=0,E=0;if(v<=i){let U=v/i,L=U*Math.PI/2;b=-c-t*Math.cos(L),C=t*Math.sin(L),E=-t*Math.cos(L),R=U*u}else if(v<=i+r){let U=(v-i)/r;b=-c+U*e,C=t,E=0,R=u+U*d}else{let U=(v-i-r)/i,L=U*Math.PI/2;b=c+t*Math.sin(L),C=t*Math.cos(L),E=t*Math.sin(L),R=u+d+U*u}let y=Math.max(0,Math.min(1,R/f)),T=0;v===0?T=.5/s:v===_&&(T=-.5/s);for(let U=0;U<=s;U++){let L=U/s,D=L*Math.PI*2,z=Math.sin(D),V=Math.cos(D);p.x=-C*V,p.y=b,p.z=C*z,a.push(p.x,p.y,p.z),m.set(-C*V,E,C*z),m.normalize(),l.push(m.x,m.y,m.z),h.push(L+T,y)}if(v>0){let U=(v-1)*w;for(let L=0;L<s;L++){let D=U+L,z=U+L+1,V=v*w+L,N=v*w+L+1;o.push(D,z,V),o.push(z,N,V)}}}this.setIndex(o),this.setAttribute("position",new we(a,3)),this.setAttribute("normal",new we(l,3)),this.setAttribute("uv",new we(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}},va=class n extends ti{constructor(t=1,e=32,i=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:t,segments:e,thetaStart:i,thetaLength:s},e=Math.max(3,e);let r=[],o=[],a=[],l=[],h=new B,c=new Yt;o.push(0,0,0),a.push(0,0,1),l.push(.5,.5);for(let u=0,d=3;u<=e;u++,d+=3){let f=i+u/e*s;h.x=t*Math.cos(f),h.y=t*Math.sin(f),o.push(h.x,h.y,h.z),a.push(0,0,1),c.x=(o[d]/t+1)/2,c.y=(o[d+1]/t+1)/2,l.push(c.x,c.y)}for(let u=1;u<=e;u++)r.push(u,u+1,0);this.setIndex(r),this.setAttribute("position",new we(o,3)),this.setAttribute("normal",new we(a,3)),this.setAttribute("uv",new we(l,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.segments,t.thetaStart,t.thetaLength)}},Hs=class n extends ti{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let h=this;s=Math.floor(s),r=Math.floor(r);let c=[],u=[],d=[],f=[],_=0,w=[],m=i/2,p=0;v(),o===!1&&(t>0&&R(!0),e>0&&R(!1)),this.setIndex(c),this.setAttribute("position",new we(u,3)),this.setAttribute("normal",new we(d,3)),this.setAttribute("uv",new we(f,2));function v(){let b=new B,C=new B,E=0,y=(e-t)/i;for(let T=0;T<=r;T++){let U=[],L=T/r,D=L*(e-t)+t;for(let z=0;z<=s;z++){let V=z/s,N=V*l+a,W=Math.sin(N),q=Math.cos(N);C.x=D*W,C.y=-L*i+m,C.z=D*q,u.push(C.x,C.y,C.z),b.set(W,y,q).normalize(),d.push(b.x,b.y,b.z),f.push(V,1-L),U.push(_++)}w.push(U)}for(let T=0;T<s;T++)for(let U=0;U<r;U++){let L=w[U][T],D=w[U+1][T],z=w[U+1][T+1],V=w[U][T+1];(t>0||U!==0)&&(c.push(L,D,V),E+=3),(e>0||U!==r-1)&&(c.push(D,z,V),E+=3)}h.addGroup(p,E,0),p+=E}function R(b){let C=_,E=new Yt,y=new B,T=0,U=b===!0?t:e,L=b===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),_++;let D=_;for(let z=0;z<=s;z++){let N=z/s*l+a,W=Math.cos(N),q=Math.sin(N);y.x=U*q,y.y=m*L,y.z=U*W,u.push(y.x,y.y,y.z),d.push(0,L,0),E.x=W*.5+.5,E.y=q*.5*L+.5,f.push(E.x,E.y),_++}for(let z=0;z<s;z++){let V=C+z,N=D+z;b===!0?c.push(N,N+1,V):c.push(N+1,N,V),T+=3}h.addGroup(p,T,b===!0?1:2),p+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},pr=class n extends Hs{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var ba=class n extends ti{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),h=a+1,c=l+1,u=t/a,d=e/l,f=[],_=[],w=[],m=[];for(let p=0;p<c;p++){let v=p*d-o;for(let R=0;R<h;R++){let b=R*u-r;_.push(b,-v,0),w.push(0,0,1),m.push(R/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let R=v+h*p,b=v+h*(p+1),C=v+1+h*(p+1),E=v+1+h*p;f.push(R,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new we(_,3)),this.setAttribute("normal",new we(w,3)),this.setAttribute("uv",new we(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}},wa=class n extends ti{constructor(t=.5,e=1,i=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:i,phiSegments:s,thetaStart:r,thetaLength:o},i=Math.max(3,i),s=Math.max(1,s);let a=[],l=[],h=[],c=[],u=t,d=(e-t)/s,f=new B,_=new Yt;for(let w=0;w<=s;w++){for(let m=0;m<=i;m++){let p=r+m/i*o;f.x=u*Math.cos(p),f.y=u*Math.sin(p),l.push(f.x,f.y,f.z),h.push(0,0,1),_.x=(f.x/e+1)/2,_.y=(f.y/e+1)/2,c.push(_.x,_.y)}u+=d}for(let w=0;w<s;w++){let m=w*(i+1);for(let p=0;p<i;p++){let v=p+m,R=v,b=v+i+1,C=v+i+2,E=v+1;a.push(R,b,E),a.push(b,C,E)}}this.setIndex(a),this.setAttribute("position",new we(l,3)),this.setAttribute("normal",new we(h,3)),this.setAttribute("uv",new we(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var Fn=class n extends ti{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),h=0,c=[],u=new B,d=new B,f=[],_=[],w=[],m=[];for(let p=0;p<=i;p++){let v=[],R=p/i,b=o+R*a,C=t*Math.cos(b),E=Math.sqrt(t*t-C*C),y=0;p===0&&o===0?y=.5/e:p===i&&l===Math.PI&&(y=-.5/e);for(let T=0;T<=e;T++){let U=T/e,L=s+U*r;u.x=-E*Math.cos(L),u.y=C,u.z=E*Math.sin(L),_.push(u.x,u.y,u.z),d.copy(u).normalize(),w.push(d.x,d.y,d.z),m.push(U+y,1-R),v.push(h++)}c.push(v)}for(let p=0;p<i;p++)for(let v=0;v<e;v++){let R=c[p][v+1],b=c[p][v],C=c[p+1][v],E=c[p+1][v+1];(p!==0||o>0)&&f.push(R,b,E),(p!==i-1||l<Math.PI)&&f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new we(_,3)),this.setAttribute("normal",new we(w,3)),this.setAttribute("uv",new we(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Sa=class n extends ti{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],h=[],c=[],u=[],d=new B,f=new B,_=new B;for(let w=0;w<=i;w++){let m=o+w/i*a;for(let p=0;p<=s;p++){let v=p/s*r;f.x=(t+e*Math.cos(m))*Math.cos(v),f.y=(t+e*Math.cos(m))*Math.sin(v),f.z=e*Math.sin(m),h.push(f.x,f.y,f.z),d.x=t*Math.cos(v),d.y=t*Math.sin(v),_.subVectors(f,d).normalize(),c.push(_.x,_.y,_.z),u.push(p/s),u.push(w/i)}}for(let w=1;w<=i;w++)for(let m=1;m<=s;m++){let p=(s+1)*w+m-1,v=(s+1)*(w-1)+m-1,R=(s+1)*(w-1)+m,b=(s+1)*w+m;l.push(p,v,b),l.push(v,R,b)}this.setIndex(l),this.setAttribute("position",new we(h,3)),this.setAttribute("normal",new we(c,3)),this.setAttribute("uv",new we(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};function yr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(fm(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(fm(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Vi(n){let t={};for(let e=0;e<n.length;e++){let i=yr(n[e]);for(let s in i)t[s]=i[s]}return t}function fm(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function by(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function jd(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ye.workingColorSpace}var lg={clone:yr,merge:Vi},wy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Sy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,es=class extends vs{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=wy,this.fragmentShader=Sy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=yr(t.uniforms),this.uniformsGroups=by(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ie().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new B().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Qe().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ne().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Ce().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},ah=class extends es{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ma=class extends vs{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ie(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ie(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=lc,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ys,this.combine=wh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},lh=class extends vs{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=$m,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},hh=class extends vs{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function jr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Bl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ws=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];i:{t:{let o;e:{n:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break n;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break i}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},ch=class extends Ws{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:fd,endingEnd:fd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case pd:r=t,a=2*e-i;break;case md:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case pd:o=t,l=2*i-e;break;case md:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let h=(i-e)*.5,c=this.valueSize;this._weightPrev=h/(e-a),this._weightNext=h/(l-i),this._offsetPrev=r*c,this._offsetNext=o*c}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,h=l-a,c=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,_=(i-e)/(s-e),w=_*_,m=w*_,p=-d*m+2*d*w-d*_,v=(1+d)*m+(-1.5-2*d)*w+(-.5+d)*_+1,R=(-1-f)*m+(1.5+f)*w+.5*_,b=f*m-f*w;for(let C=0;C!==a;++C)r[C]=p*o[c+C]+v*o[h+C]+R*o[l+C]+b*o[u+C];return r}},uh=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,h=l-a,c=(i-e)/(s-e),u=1-c;for(let d=0;d!==a;++d)r[d]=o[h+d]*u+o[l+d]*c;return r}},dh=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},fh=class extends Ws{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,h=l-a,c=this.inTangents,u=this.outTangents;if(!c||!u){let _=(i-e)/(s-e),w=1-_;for(let m=0;m!==a;++m)r[m]=o[h+m]*w+o[l+m]*_;return r}let d=a*2,f=t-1;for(let _=0;_!==a;++_){let w=o[h+_],m=o[l+_],p=f*d+_*2,v=u[p],R=u[p+1],b=t*d+_*2,C=c[b],E=c[b+1],y=Ay(i,e,v,C,s);r[_]=hg(y,w,R,E,m)}return r}};function hg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function My(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Ay(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=hg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=My(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fn=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=jr(e,this.TimeBufferType),this.values=jr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:jr(t.times,Array),values:jr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Bl(t.settings)&&(i.settings={inTangents:jr(t.settings.inTangents,Array),outTangents:jr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new dh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new uh(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new ch(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new fh(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case oa:e=this.InterpolantFactoryMethodDiscrete;break;case Ql:e=this.InterpolantFactoryMethodLinear;break;case Vl:e=this.InterpolantFactoryMethodSmooth;break;case dd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return oa;case this.InterpolantFactoryMethodLinear:return Ql;case this.InterpolantFactoryMethodSmooth:return Vl;case this.InterpolantFactoryMethodBezier:return dd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Bl(this.settings)&&(pm(this.settings.inTangents,t),pm(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Bl(this.settings)&&(mm(this.settings.inTangents,t),mm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(te("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(te("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){te("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){te("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Gx(s))for(let a=0,l=s.length;a!==l;++a){let h=s[a];if(isNaN(h)){te("KeyframeTrack: Value is not a valid number.",this,a,h),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Vl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,h=t[a],c=t[a+1];if(h!==c&&(a!==1||h!==t[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let _=0;_!==i;++_){let w=e[u+_];if(w!==e[d+_]||w!==e[f+_]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,h=0;h!==i;++h)e[l+h]=e[a+h];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Bl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function pm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function mm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}fn.prototype.ValueTypeName="";fn.prototype.TimeBufferType=Float32Array;fn.prototype.ValueBufferType=Float32Array;fn.prototype.DefaultInterpolation=Ql;var Xs=class extends fn{constructor(t,e,i){super(t,e,i)}};Xs.prototype.ValueTypeName="bool";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=oa;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var ph=class extends fn{constructor(t,e,i,s){super(t,e,i,s)}};ph.prototype.ValueTypeName="color";var mh=class extends fn{constructor(t,e,i,s){super(t,e,i,s)}};mh.prototype.ValueTypeName="number";var gh=class extends Ws{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),h=t*a;for(let c=h+a;h!==c;h+=4)Me.slerpFlat(r,0,o,h-a,o,h,l);return r}},Aa=class extends fn{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new gh(this.times,this.values,this.getValueSize(),t)}};Aa.prototype.ValueTypeName="quaternion";Aa.prototype.InterpolantFactoryMethodSmooth=void 0;var $s=class extends fn{constructor(t,e,i){super(t,e,i)}};$s.prototype.ValueTypeName="string";$s.prototype.ValueBufferType=Array;$s.prototype.DefaultInterpolation=oa;$s.prototype.InterpolantFactoryMethodLinear=void 0;$s.prototype.InterpolantFactoryMethodSmooth=void 0;var _h=class extends fn{constructor(t,e,i,s){super(t,e,i,s)}};_h.prototype.ValueTypeName="vector";var xh=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,h=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(c){a++,r===!1&&s.onStart!==void 0&&s.onStart(c,o,a),r=!0},this.itemEnd=function(c){o++,s.onProgress!==void 0&&s.onProgress(c,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(c){s.onError!==void 0&&s.onError(c)},this.resolveURL=function(c){return c=c.normalize("NFC"),l?l(c):c},this.setURLModifier=function(c){return l=c,this},this.addHandler=function(c,u){return h.push(c,u),this},this.removeHandler=function(c){let u=h.indexOf(c);return u!==-1&&h.splice(u,2),this},this.getHandler=function(c){for(let u=0,d=h.length;u<d;u+=2){let f=h[u],_=h[u+1];if(f.global&&(f.lastIndex=0),f.test(c))return _}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},cg=new xh,yh=class{constructor(t){this.manager=t!==void 0?t:cg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};yh.DEFAULT_MATERIAL_NAME="__DEFAULT";var uo=class extends Oi{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ie(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ta=class extends uo{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Oi.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ie(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},ud=new Ce,gm=new B,_m=new B,vh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=tn,this.map=null,this.mapPass=null,this.matrix=new Ce,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Gs,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new Qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;gm.setFromMatrixPosition(t.matrixWorld),e.position.copy(gm),_m.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(_m),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){ud.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(ud,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,h=s?s.y/r.y:0;t.coordinateSystem===no||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+h,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+h,0,0,.5,.5,0,0,0,1),e.multiply(ud)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},zl=new B,Gl=new Me,jn=new B,Ea=class extends Oi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ce,this.projectionMatrix=new Ce,this.projectionMatrixInverse=new Ce,this.coordinateSystem=wn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(zl,Gl,jn),jn.x===1&&jn.y===1&&jn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zl,Gl,jn.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(zl,Gl,jn),jn.x===1&&jn.y===1&&jn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(zl,Gl,jn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ks=new B,xm=new Yt,ym=new Yt,Zi=class extends Ea{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=ro*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(sa*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return ro*2*Math.atan(Math.tan(sa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ks.x,ks.y).multiplyScalar(-t/ks.z),ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ks.x,ks.y).multiplyScalar(-t/ks.z)}getViewSize(t,e){return this.getViewBounds(t,xm,ym),e.subVectors(ym,xm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(sa*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,h=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/h,s*=o.width/l,i*=o.height/h}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ca=class extends Ea{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let h=(this.right-this.left)/this.view.fullWidth/this.zoom,c=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=h*this.view.offsetX,o=r+h*this.view.width,a-=c*this.view.offsetY,l=a-c*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},gd=class extends vh{constructor(){super(new Ca(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ra=class extends uo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Oi.DEFAULT_UP),this.updateMatrix(),this.target=new Oi,this.shadow=new gd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Pa=class extends uo{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Qr=-90,to=1,fo=class extends Oi{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Zi(Qr,to,t,e);s.layers=this.layers,this.add(s);let r=new Zi(Qr,to,t,e);r.layers=this.layers,this.add(r);let o=new Zi(Qr,to,t,e);o.layers=this.layers,this.add(o);let a=new Zi(Qr,to,t,e);a.layers=this.layers,this.add(a);let l=new Zi(Qr,to,t,e);l.layers=this.layers,this.add(l);let h=new Zi(Qr,to,t,e);h.layers=this.layers,this.add(h)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let h of e)this.remove(h);if(t===wn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===no)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let h of e)this.add(h),h.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,h,c]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;let w=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),i.texture.mipmapsAutoUpdate=w,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(u,d,f),t.xr.enabled=_,i.texture.needsPMREMUpdate=!0}},bh=class extends Zi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Qd="\\[\\]\\.:\\/",Ty=new RegExp("["+Qd+"]","g"),tf="[^"+Qd+"]",Ey="[^"+Qd.replace("\\.","")+"]",Cy=/((?:WC+[\/:])*)/.source.replace("WC",tf),Ry=/(WCOD+)?/.source.replace("WCOD",Ey),Py=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",tf),Iy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",tf),Ly=new RegExp("^"+Cy+Ry+Py+Iy+"$"),Dy=["material","materials","bones","map"],_d=class{constructor(t,e,i){let s=i||Ze.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ze=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Ty,"")}static parseTrackName(t){let e=Ly.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Dy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let h=e.objectIndex;switch(i){case"materials":if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){te("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){te("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let c=0;c<t.length;c++)if(t[c].name===h){h=c;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){te("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){te("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){te("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(h!==void 0){if(t[h]===void 0){te("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[h]}}let o=t[s];if(o===void 0){let h=e.nodeName;te("PropertyBinding: Trying to update property for track: "+h+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){te("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ze.Composite=_d;Ze.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ze.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ze.prototype.GetterByBindingType=[Ze.prototype._getValue_direct,Ze.prototype._getValue_array,Ze.prototype._getValue_arrayElement,Ze.prototype._getValue_toArray];Ze.prototype.SetterByBindingTypeAndVersioning=[[Ze.prototype._setValue_direct,Ze.prototype._setValue_direct_setNeedsUpdate,Ze.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_array,Ze.prototype._setValue_array_setNeedsUpdate,Ze.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_arrayElement,Ze.prototype._setValue_arrayElement_setNeedsUpdate,Ze.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ze.prototype._setValue_fromArray,Ze.prototype._setValue_fromArray_setNeedsUpdate,Ze.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var gC=new Float32Array(1);var vm=new Ce,Ia=class{constructor(t,e,i=0,s=1/0){this.ray=new zs(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new ao,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):te("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return vm.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(vm),this}intersectObject(t,e=!0,i=[]){return xd(t,this,i,e),i.sort(bm),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)xd(t[s],this,i,e);return i.sort(bm),i}};function bm(n,t){return n.distance-t.distance}function xd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)xd(r[o],t,e,!0)}}var po=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=me(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(me(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var yd=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var La=class extends Nn{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function ef(n,t,e,i){let s=Ny(i);switch(e){case kd:return n*t;case zd:return n*t/s.components*s.byteLength;case Rh:return n*t/s.components*s.byteLength;case Ks:return n*t*2/s.components*s.byteLength;case Ph:return n*t*2/s.components*s.byteLength;case Bd:return n*t*3/s.components*s.byteLength;case Bn:return n*t*4/s.components*s.byteLength;case Ih:return n*t*4/s.components*s.byteLength;case Fa:case Ua:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Oa:case ka:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Dh:case Fh:return Math.max(n,16)*Math.max(t,8)/4;case Lh:case Nh:return Math.max(n,8)*Math.max(t,8)/2;case Uh:case Oh:case Bh:case zh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case kh:case Ba:case Gh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Vh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Hh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Wh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Xh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case $h:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case qh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Yh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Zh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Kh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Jh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case jh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Qh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case tc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case ec:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case ic:case nc:case sc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case rc:case oc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case za:case ac:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Ny(n){switch(n){case tn:case Nd:return{byteLength:1,components:1};case xo:case Fd:case kn:return{byteLength:2,components:1};case Eh:case Ch:return{byteLength:2,components:4};case Un:case Th:case On:return{byteLength:4,components:1};case Ud:case Od:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lg(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Vy(n){let t=new WeakMap;function e(a,l){let h=a.array,c=a.usage,u=h.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,h,c),a.onUploadCallback();let f;if(h instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&h instanceof Float16Array)f=n.HALF_FLOAT;else if(h instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(h instanceof Int16Array)f=n.SHORT;else if(h instanceof Uint32Array)f=n.UNSIGNED_INT;else if(h instanceof Int32Array)f=n.INT;else if(h instanceof Int8Array)f=n.BYTE;else if(h instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(h instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+h);return{buffer:d,type:f,bytesPerElement:h.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,h){let c=l.array,u=l.updateRanges;if(n.bindBuffer(h,a),u.length===0)n.bufferSubData(h,0,c);else{u.sort((f,_)=>f.start-_.start);let d=0;for(let f=1;f<u.length;f++){let _=u[d],w=u[f];w.start<=_.start+_.count+1?_.count=Math.max(_.count,w.start+w.count-_.start):(++d,u[d]=w)}u.length=d+1;for(let f=0,_=u.length;f<_;f++){let w=u[f];n.bufferSubData(h,w.start*c.BYTES_PER_ELEMENT,c,w.start,w.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let c=t.get(a);(!c||c.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let h=t.get(a);if(h===void 0)t.set(a,e(a,l));else if(h.version<a.version){if(h.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(h.buffer,a,l),h.version=a.version}}return{get:s,remove:r,update:o}}var Hy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Wy=`#ifdef USE_ALPHAHASH
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
#endif`,Xy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,$y=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,qy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Yy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Zy=`#ifdef USE_AOMAP
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
#endif`,Ky=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Jy=`#ifdef USE_BATCHING
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
#endif`,jy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Qy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,tv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ev=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,iv=`#ifdef USE_IRIDESCENCE
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
#endif`,nv=`#ifdef USE_BUMPMAP
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
#endif`,sv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,rv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ov=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,av=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,lv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,cv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,uv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,dv=`#define PI 3.141592653589793
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
} // validated`,fv=`vec3 transformedNormal = objectNormal;
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
#endif`,pv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,mv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,gv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,_v=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,xv="gl_FragColor = linearToOutputTexel( gl_FragColor );",yv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,vv=`#ifdef USE_ENVMAP
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
#endif`,bv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,wv=`#ifdef USE_ENVMAP
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
#endif`,Sv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Mv=`#ifdef USE_ENVMAP
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
#endif`,Av=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Tv=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ev=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Cv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Rv=`#ifdef USE_GRADIENTMAP
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
}`,Pv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Iv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Lv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Dv=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Nv=`#ifdef USE_ENVMAP
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
#endif`,Fv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Uv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ov=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,kv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Bv=`PhysicalMaterial material;
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
#endif`,zv=`uniform sampler2D dfgLUT;
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
}`,Gv=`
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
#endif`,Vv=`#if defined( RE_IndirectDiffuse )
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
#endif`,Hv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Wv=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Xv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,$v=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Yv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Zv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Kv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Jv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,jv=`#if defined( USE_POINTS_UV )
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
#endif`,Qv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,tb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,eb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,ib=`#if defined( USE_MORPHCOLORS )
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
#endif`,nb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,sb=`#ifdef USE_MORPHTARGETS
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
#endif`,rb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ob=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ab=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,lb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,cb=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,ub=`#ifdef USE_NORMALMAP
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
#endif`,db=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,fb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,pb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,mb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,gb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,_b=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,xb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,yb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,vb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,bb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Sb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Mb=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Ab=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Tb=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Eb=`float getShadowMask() {
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
}`,Cb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Rb=`#ifdef USE_SKINNING
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
#endif`,Pb=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Ib=`#ifdef USE_SKINNING
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
#endif`,Lb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Db=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Nb=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Fb=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ub=`#ifdef USE_TRANSMISSION
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
#endif`,Ob=`#ifdef USE_TRANSMISSION
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
#endif`,kb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Bb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,zb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Gb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Vb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Hb=`uniform sampler2D t2D;
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
}`,Wb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Xb=`uniform float backgroundBlurriness;
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
}`,$b=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,qb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Yb=`#include <common>
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
}`,Zb=`#if DEPTH_PACKING == 3200
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
}`,Kb=`#define DISTANCE
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
}`,Jb=`#define DISTANCE
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
}`,jb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Qb=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tw=`uniform float scale;
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
}`,ew=`uniform vec3 diffuse;
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
}`,iw=`#include <common>
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
}`,nw=`uniform vec3 diffuse;
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
}`,sw=`#define LAMBERT
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
}`,rw=`#define LAMBERT
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
}`,ow=`#define MATCAP
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
}`,aw=`#define MATCAP
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
}`,lw=`#define NORMAL
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
}`,hw=`#define NORMAL
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
}`,cw=`#define PHONG
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
}`,uw=`#define PHONG
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
}`,dw=`#define STANDARD
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
}`,fw=`#define STANDARD
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
}`,pw=`#define TOON
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
}`,mw=`#define TOON
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
}`,gw=`uniform float size;
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
}`,_w=`uniform vec3 diffuse;
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
}`,xw=`#include <common>
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
}`,yw=`uniform vec3 color;
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
}`,vw=`uniform float rotation;
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
}`,bw=`uniform vec3 diffuse;
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
}`,ue={alphahash_fragment:Hy,alphahash_pars_fragment:Wy,alphamap_fragment:Xy,alphamap_pars_fragment:$y,alphatest_fragment:qy,alphatest_pars_fragment:Yy,aomap_fragment:Zy,aomap_pars_fragment:Ky,batching_pars_vertex:Jy,batching_vertex:jy,begin_vertex:Qy,beginnormal_vertex:tv,bsdfs:ev,iridescence_fragment:iv,bumpmap_pars_fragment:nv,clipping_planes_fragment:sv,clipping_planes_pars_fragment:rv,clipping_planes_pars_vertex:ov,clipping_planes_vertex:av,color_fragment:lv,color_pars_fragment:hv,color_pars_vertex:cv,color_vertex:uv,common:dv,defaultnormal_vertex:fv,displacementmap_pars_vertex:pv,displacementmap_vertex:mv,emissivemap_fragment:gv,emissivemap_pars_fragment:_v,colorspace_fragment:xv,colorspace_pars_fragment:yv,envmap_fragment:vv,envmap_common_pars_fragment:bv,envmap_pars_fragment:wv,envmap_pars_vertex:Sv,envmap_physical_pars_fragment:Nv,envmap_vertex:Mv,fog_vertex:Av,fog_pars_vertex:Tv,fog_fragment:Ev,fog_pars_fragment:Cv,gradientmap_pars_fragment:Rv,lightmap_pars_fragment:Pv,lights_lambert_fragment:Iv,lights_lambert_pars_fragment:Lv,lights_pars_begin:Dv,lights_toon_fragment:Fv,lights_toon_pars_fragment:Uv,lights_phong_fragment:Ov,lights_phong_pars_fragment:kv,lights_physical_fragment:Bv,lights_physical_pars_fragment:zv,lights_fragment_begin:Gv,lights_fragment_maps:Vv,lights_fragment_end:Hv,lightprobes_pars_fragment:Wv,logdepthbuf_fragment:Xv,logdepthbuf_pars_fragment:$v,logdepthbuf_pars_vertex:qv,logdepthbuf_vertex:Yv,map_fragment:Zv,map_pars_fragment:Kv,map_particle_fragment:Jv,map_particle_pars_fragment:jv,metalnessmap_fragment:Qv,metalnessmap_pars_fragment:tb,morphinstance_vertex:eb,morphcolor_vertex:ib,morphnormal_vertex:nb,morphtarget_pars_vertex:sb,morphtarget_vertex:rb,normal_fragment_begin:ob,normal_fragment_maps:ab,normal_pars_fragment:lb,normal_pars_vertex:hb,normal_vertex:cb,normalmap_pars_fragment:ub,clearcoat_normal_fragment_begin:db,clearcoat_normal_fragment_maps:fb,clearcoat_pars_fragment:pb,iridescence_pars_fragment:mb,opaque_fragment:gb,packing:_b,premultiplied_alpha_fragment:xb,project_vertex:yb,dithering_fragment:vb,dithering_pars_fragment:bb,roughnessmap_fragment:wb,roughnessmap_pars_fragment:Sb,shadowmap_pars_fragment:Mb,shadowmap_pars_vertex:Ab,shadowmap_vertex:Tb,shadowmask_pars_fragment:Eb,skinbase_vertex:Cb,skinning_pars_vertex:Rb,skinning_vertex:Pb,skinnormal_vertex:Ib,specularmap_fragment:Lb,specularmap_pars_fragment:Db,tonemapping_fragment:Nb,tonemapping_pars_fragment:Fb,transmission_fragment:Ub,transmission_pars_fragment:Ob,uv_pars_fragment:kb,uv_pars_vertex:Bb,uv_vertex:zb,worldpos_vertex:Gb,background_vert:Vb,background_frag:Hb,backgroundCube_vert:Wb,backgroundCube_frag:Xb,cube_vert:$b,cube_frag:qb,depth_vert:Yb,depth_frag:Zb,distance_vert:Kb,distance_frag:Jb,equirect_vert:jb,equirect_frag:Qb,linedashed_vert:tw,linedashed_frag:ew,meshbasic_vert:iw,meshbasic_frag:nw,meshlambert_vert:sw,meshlambert_frag:rw,meshmatcap_vert:ow,meshmatcap_frag:aw,meshnormal_vert:lw,meshnormal_frag:hw,meshphong_vert:cw,meshphong_frag:uw,meshphysical_vert:dw,meshphysical_frag:fw,meshtoon_vert:pw,meshtoon_frag:mw,points_vert:gw,points_frag:_w,shadow_vert:xw,shadow_frag:yw,sprite_vert:vw,sprite_frag:bw},Lt={common:{diffuse:{value:new ie(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ne}},envmap:{envMap:{value:null},envMapRotation:{value:new ne},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ne}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ne}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ne},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ne},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ne},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ne}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ne}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ne}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ie(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ie(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0},uvTransform:{value:new ne}},sprite:{diffuse:{value:new ie(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ne},alphaMap:{value:null},alphaMapTransform:{value:new ne},alphaTest:{value:0}}},ss={basic:{uniforms:Vi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:Vi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new ie(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:Vi([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new ie(0)},specular:{value:new ie(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:Vi([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new ie(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:Vi([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new ie(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:Vi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:Vi([Lt.points,Lt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:Vi([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:Vi([Lt.common,Lt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:Vi([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:Vi([Lt.sprite,Lt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new ne},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ne}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:Vi([Lt.common,Lt.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:Vi([Lt.lights,Lt.fog,{color:{value:new ie(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};ss.physical={uniforms:Vi([ss.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ne},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ne},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ne},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ne},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ne},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ne},sheen:{value:0},sheenColor:{value:new ie(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ne},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ne},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ne},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ne},attenuationDistance:{value:0},attenuationColor:{value:new ie(0)},specularColor:{value:new ie(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ne},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ne},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ne}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var cc={r:0,b:0,g:0},ww=new Ce,Dg=new ne;Dg.set(-1,0,0,0,1,0,0,0,1);function Sw(n,t,e,i,s,r){let o=new ie(0),a=s===!0?0:1,l,h,c=null,u=0,d=null;function f(v){let R=v.isScene===!0?v.background:null;if(R&&R.isTexture){let b=v.backgroundBlurriness>0;R=t.get(R,b)}return R}function _(v){let R=!1,b=f(v);b===null?m(o,a):b&&b.isColor&&(m(b,1),R=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||R)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function w(v,R){let b=f(R);b&&b.isCubeTexture?(h===void 0&&(h=new Ae(new Sn(1,1,1),new es({name:"BackgroundCubeMaterial",uniforms:yr(ss.backgroundCube.uniforms),vertexShader:ss.backgroundCube.vertexShader,fragmentShader:ss.backgroundCube.fragmentShader,side:Ji,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),h.geometry.deleteAttribute("normal"),h.geometry.deleteAttribute("uv"),h.onBeforeRender=function(C,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(h.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(h)),h.material.uniforms.envMap.value=b,h.material.uniforms.backgroundBlurriness.value=R.backgroundBlurriness,h.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,h.material.uniforms.backgroundRotation.value.setFromMatrix4(ww.makeRotationFromEuler(R.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&h.material.uniforms.backgroundRotation.value.premultiply(Dg),h.material.toneMapped=ye.getTransfer(b.colorSpace)!==Le,(c!==b||u!==b.version||d!==n.toneMapping)&&(h.material.needsUpdate=!0,c=b,u=b.version,d=n.toneMapping),h.layers.enableAll(),v.unshift(h,h.geometry,h.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ae(new ba(2,2),new es({name:"BackgroundMaterial",uniforms:yr(ss.background.uniforms),vertexShader:ss.background.vertexShader,fragmentShader:ss.background.fragmentShader,side:Zs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=R.backgroundIntensity,l.material.toneMapped=ye.getTransfer(b.colorSpace)!==Le,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(c!==b||u!==b.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,c=b,u=b.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,R){v.getRGB(cc,jd(n)),e.buffers.color.setClear(cc.r,cc.g,cc.b,R,r)}function p(){h!==void 0&&(h.geometry.dispose(),h.material.dispose(),h=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,R=1){o.set(v),a=R,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:_,addToRenderList:w,dispose:p}}function Mw(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(D,z,V,N,W){let q=!1,H=u(D,N,V,z);r!==H&&(r=H,h(r.object)),q=f(D,N,V,W),q&&_(D,N,V,W),W!==null&&t.update(W,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(D,z,V,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return n.createVertexArray()}function h(D){return n.bindVertexArray(D)}function c(D){return n.deleteVertexArray(D)}function u(D,z,V,N){let W=N.wireframe===!0,q=i[z.id];q===void 0&&(q={},i[z.id]=q);let H=D.isInstancedMesh===!0?D.id:0,lt=q[H];lt===void 0&&(lt={},q[H]=lt);let Z=lt[V.id];Z===void 0&&(Z={},lt[V.id]=Z);let j=Z[W];return j===void 0&&(j=d(l()),Z[W]=j),j}function d(D){let z=[],V=[],N=[];for(let W=0;W<e;W++)z[W]=0,V[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:V,attributeDivisors:N,object:D,attributes:{},index:null}}function f(D,z,V,N){let W=r.attributes,q=z.attributes,H=0,lt=V.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let et=W[Z],dt=q[Z];if(dt===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(dt=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(dt=D.instanceColor)),et===void 0||et.attribute!==dt||dt&&et.data!==dt.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function _(D,z,V,N){let W={},q=z.attributes,H=0,lt=V.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let et=q[Z];et===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(et=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(et=D.instanceColor));let dt={};dt.attribute=et,et&&et.data&&(dt.data=et.data),W[Z]=dt,H++}r.attributes=W,r.attributesNum=H,r.index=N}function w(){let D=r.newAttributes;for(let z=0,V=D.length;z<V;z++)D[z]=0}function m(D){p(D,0)}function p(D,z){let V=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;V[D]=1,N[D]===0&&(n.enableVertexAttribArray(D),N[D]=1),W[D]!==z&&(n.vertexAttribDivisor(D,z),W[D]=z)}function v(){let D=r.newAttributes,z=r.enabledAttributes;for(let V=0,N=z.length;V<N;V++)z[V]!==D[V]&&(n.disableVertexAttribArray(V),z[V]=0)}function R(D,z,V,N,W,q,H){H===!0?n.vertexAttribIPointer(D,z,V,W,q):n.vertexAttribPointer(D,z,V,N,W,q)}function b(D,z,V,N){w();let W=N.attributes,q=V.getAttributes(),H=z.defaultAttributeValues;for(let lt in q){let Z=q[lt];if(Z.location>=0){let j=W[lt];if(j===void 0&&(lt==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),lt==="instanceColor"&&D.instanceColor&&(j=D.instanceColor)),j!==void 0){let et=j.normalized,dt=j.itemSize,ut=t.get(j);if(ut===void 0)continue;let tt=ut.buffer,mt=ut.type,xt=ut.bytesPerElement,Et=mt===n.INT||mt===n.UNSIGNED_INT||j.gpuType===Th;if(j.isInterleavedBufferAttribute){let wt=j.data,Wt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,oe=j.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Vt=0;Vt<Z.locationSize;Vt++)p(Z.location+Vt,wt.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Vt=0;Vt<Z.locationSize;Vt++)m(Z.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<Z.locationSize;Vt++)R(Z.location+Vt,dt/Z.locationSize,mt,et,Wt*xt,(oe+dt/Z.locationSize*Vt)*xt,Et)}else{if(j.isInstancedBufferAttribute){for(let wt=0;wt<Z.locationSize;wt++)p(Z.location+wt,j.meshPerAttribute);D.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let wt=0;wt<Z.locationSize;wt++)m(Z.location+wt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let wt=0;wt<Z.locationSize;wt++)R(Z.location+wt,dt/Z.locationSize,mt,et,dt*xt,dt/Z.locationSize*wt*xt,Et)}}else if(H!==void 0){let et=H[lt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(Z.location,et);break;case 3:n.vertexAttrib3fv(Z.location,et);break;case 4:n.vertexAttrib4fv(Z.location,et);break;default:n.vertexAttrib1fv(Z.location,et)}}}}v()}function C(){U();for(let D in i){let z=i[D];for(let V in z){let N=z[V];for(let W in N){let q=N[W];for(let H in q)c(q[H].object),delete q[H];delete N[W]}}delete i[D]}}function E(D){if(i[D.id]===void 0)return;let z=i[D.id];for(let V in z){let N=z[V];for(let W in N){let q=N[W];for(let H in q)c(q[H].object),delete q[H];delete N[W]}}delete i[D.id]}function y(D){for(let z in i){let V=i[z];for(let N in V){let W=V[N];if(W[D.id]===void 0)continue;let q=W[D.id];for(let H in q)c(q[H].object),delete q[H];delete W[D.id]}}}function T(D){for(let z in i){let V=i[z],N=D.isInstancedMesh===!0?D.id:0,W=V[N];if(W!==void 0){for(let q in W){let H=W[q];for(let lt in H)c(H[lt].object),delete H[lt];delete W[q]}delete V[N],Object.keys(V).length===0&&delete i[z]}}}function U(){L(),o=!0,r!==s&&(r=s,h(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:w,enableAttribute:m,disableUnusedAttributes:v}}function Aw(n,t,e){let i;function s(l){i=l}function r(l,h){n.drawArrays(i,l,h),e.update(h,i,1)}function o(l,h,c){c!==0&&(n.drawArraysInstanced(i,l,h,c),e.update(h,i,c))}function a(l,h,c){if(c===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,h,0,c);let d=0;for(let f=0;f<c;f++)d+=h[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Tw(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Bn&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let T=y===kn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==tn&&y!==On&&!T&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let h=e.precision!==void 0?e.precision:"highp",c=l(h);c!==h&&(qt("WebGLRenderer:",h,"not supported, using",c,"instead."),h=c);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),w=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),R=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:h,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:_,maxTextureSize:w,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:R,maxFragmentUniforms:b,maxSamples:C,samples:E}}function Ew(n){let t=this,e=null,i=0,s=!1,r=!1,o=new un,a=new ne,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,c(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=c(u,d,0)},this.setState=function(u,d,f){let _=u.clippingPlanes,w=u.clipIntersection,m=u.clipShadows,p=n.get(u);if(!s||_===null||_.length===0||r&&!m)r?c(null):h();else{let v=r?0:i,R=v*4,b=p.clippingState||null;l.value=b,b=c(_,d,R,f);for(let C=0;C!==R;++C)b[C]=e[C];p.clippingState=b,this.numIntersection=w?this.numPlanes:0,this.numPlanes+=v}};function h(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function c(u,d,f,_){let w=u!==null?u.length:0,m=null;if(w!==0){if(m=l.value,_!==!0||m===null){let p=f+w*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let R=0,b=f;R!==w;++R,b+=4)o.copy(u[R]).applyMatrix4(v,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=w,t.numIntersection=0,m}}var Ha=class extends dn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ga(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Sn(5,5,5),r=new es({name:"CubemapFromEquirect",uniforms:yr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Ji,blending:mr});r.uniforms.tEquirect.value=e;let o=new Ae(s,r),a=e.minFilter;return e.minFilter===ws&&(e.minFilter=Ki),new fo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},ug=256,Cw=3,Rw=20,Ng=256,Fg=16,Pw=3,Iw=new B,Lw=new ie,dc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fo(1,10,null),this._boxMesh=new Ae(new Sn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Iw}=r,l=this._renderer;this._setSize(o);let h=this._allocateTarget(),c=this._getSourceTarget(!0);e>0&&(c.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,_=l.autoClearStencil,w=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,w===null&&(t.background=l.getClearColor(Lw));let m=new fo(i,s,c);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=_,t.background=w,e>0&&(c.texture.mipmapsAutoUpdate=!0,this._blur(h,e)),this._applyPMREM(h),h}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=fg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(ug,Kd(t))}_fromTexture(t,e){t.mapping===_r||t.mapping===_o?this._setSize(t.image.length===0?ug:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=dg(t,!1,!1),i=Math.log2(t)-Cw;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=dg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===_r||t.mapping===_o?(this._cubemapMaterial===null&&(this._cubemapMaterial=pg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=fg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Dw(),this._integrationMaterial=Nw());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Fg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Pw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Ng*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Fw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function dg(n,t,e){return new Ha(n,{minFilter:ws,generateMipmaps:t,type:kn,colorSpace:aa,depthBuffer:e})}function Xa(n,t,e){return new es({name:n,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:Ji,blending:mr,depthTest:!1,depthWrite:!1})}function Dw(){return Xa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ng}u

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
	`)}function Nw(){return Xa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Fg}},`

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
	`)}function Fw(){return Xa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Rw}
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
	`)}function fg(){return Xa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function pg(){return Xa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Uw(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Sh||f===Mh)if(t.has(d)){let _=t.get(d).texture;return a(_,d.mapping)}else{let _=d.image;if(_&&_.height>0){let w=new Ha(_.height);return w.fromEquirectangularTexture(n,d),t.set(d,w),d.addEventListener("dispose",h),a(w.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,_=f===Sh||f===Mh,w=f===_r||f===_o;if(_||w){let m=e.get(d),p=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return i===null&&(i=new dc(n)),m=_?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return _&&v&&v.height>0||w&&v&&l(v)?(i===null&&(i=new dc(n)),m=_?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",c),m.texture):null}}}return d}function a(d,f){return f===Sh?d.mapping=_r:f===Mh&&(d.mapping=_o),d}function l(d){let f=0,_=6;for(let w=0;w<_;w++)d[w]!==void 0&&f++;return f===_}function h(d){let f=d.target;f.removeEventListener("dispose",h);let _=t.get(f);_!==void 0&&(t.delete(f),_.dispose())}function c(d){let f=d.target;f.removeEventListener("dispose",c);let _=e.get(f);_!==void 0&&(e.delete(f),_.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function Ow(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&na("WebGLRenderer: "+i+" extension not supported."),s}}}function kw(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(_=>delete s[_]);function a(_){l(_.target)}function l(_){_.index!==null&&t.remove(_.index);for(let m in _.attributes)t.remove(_.attributes[m]);_.removeEventListener("dispose",a),delete s[_.id],o.unregister(_);let w=r.get(_);w&&(t.remove(w),r.delete(_)),i.releaseStatesOfGeometry(_),_.isInstancedBufferGeometry===!0&&delete _._maxInstanceCount,e.memory.geometries--}function h(_,w){return s[w.id]!==void 0||(w.addEventListener("dispose",a),s[w.id]=new WeakRef(w),o.register(w,w.id,w),e.memory.geometries++),w}function c(_){let w=_.attributes;for(let m in w)t.update(w[m],n.ARRAY_BUFFER)}function u(_){let w=_.index,m=_.attributes.position,p=0;if(m===void 0)return;let v=w!==null?w.array.length:m.array.length/3-1,R=m.count>=65535?pa:fa,b=new R(Math.ceil(v/3)*6,1),C=b.array;if(w!==null){let y=w.array;p=w.version;for(let T=0,U=0;T<v;T+=3){let L=y[T+0],D=y[T+1],z=y[T+2];C[U++]=L,C[U++]=D,C[U++]=D,C[U++]=z,C[U++]=z,C[U++]=L}}else{p=m.version;for(let y=0,T=0;y<v;y+=3){let U=y+0,L=y+1,D=y+2;C[T++]=U,C[T++]=L,C[T++]=L,C[T++]=D,C[T++]=D,C[T++]=U}}b.version=p;let E=r.get(_);E&&t.remove(E),r.set(_,b)}function d(_){let w=r.get(_);if(w){let m=_.index;m!==null&&w.version<m.version&&u(_)}else u(_);return r.get(_)}function f(){for(let _ in s){let w=s[_].deref();w!==void 0&&l(w)}}return{get:h,update:c,getWireframeAttribute:d,dispose:f}}function Bw(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function h(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function c(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let w=0;for(let m=0;m<f;m++)w+=d[m];e.update(w,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=h,this.renderMultiDraw=c}function zw(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:te("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Gw(n,t,e){let i=new WeakMap,s=new Qe;function r(o,a,l){let h=o.morphTargetInfluences,c=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=c!==void 0?c.length:0,d=i.get(a);if(d===void 0||d.count!==u){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,_=a.morphAttributes.normal!==void 0,w=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],R=0;f===!0&&(R=1),_===!0&&(R=2),w===!0&&(R=3);let b=a.attributes.position.count*R,C=1;b>t.maxTextureSize&&(C=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let E=new Float32Array(b*C*4*u),y=new ca(E,b,C,u);y.type=On,y.needsUpdate=!0;let T=R*4;for(let L=0;L<u;L++){let D=m[L],z=p[L],V=v[L],N=b*C*4*L;for(let W=0;W<D.count;W++){let q=W*T;f===!0&&(s.fromBufferAttribute(D,W),E[N+q+0]=s.x,E[N+q+1]=s.y,E[N+q+2]=s.z,E[N+q+3]=0),_===!0&&(s.fromBufferAttribute(z,W),E[N+q+4]=s.x,E[N+q+5]=s.y,E[N+q+6]=s.z,E[N+q+7]=0),w===!0&&(s.fromBufferAttribute(V,W),E[N+q+8]=s.x,E[N+q+9]=s.y,E[N+q+10]=s.z,E[N+q+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new Yt(b,C)},i.set(a,d),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let w=0;w<h.length;w++)f+=h[w];let _=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",_),l.getUniforms().setValue(n,"morphTargetInfluences",h)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function Vw(n,t,e,i,s){let r=new WeakMap;function o(h){let c=s.render.frame,u=h.geometry,d=t.get(h,u);if(r.get(d)!==c&&(t.update(d),r.set(d,c)),h.isInstancedMesh&&(h.hasEventListener("dispose",l)===!1&&h.addEventListener("dispose",l),r.get(h)!==c&&(e.update(h.instanceMatrix,n.ARRAY_BUFFER),h.instanceColor!==null&&e.update(h.instanceColor,n.ARRAY_BUFFER),r.set(h,c))),h.isSkinnedMesh){let f=h.skeleton;r.get(f)!==c&&(f.update(),r.set(f,c))}return d}function a(){r=new WeakMap}function l(h){let c=h.target;c.removeEventListener("dispose",l),i.releaseStatesOfObject(c),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:o,dispose:a}}var Hw={[Td]:"LINEAR_TONE_MAPPING",[Ed]:"REINHARD_TONE_MAPPING",[Cd]:"CINEON_TONE_MAPPING",[Rd]:"ACES_FILMIC_TONE_MAPPING",[Id]:"AGX_TONE_MAPPING",[Ld]:"NEUTRAL_TONE_MAPPING",[Pd]:"CUSTOM_TONE_MAPPING"};function Ww(n,t,e,i,s,r){let o=new dn(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,h=null,c=new ti;c.setAttribute("position",new we([-1,3,0,-1,-1,0,3,-1,0],3)),c.setAttribute("uv",new we([0,2,0,0,2,0],2));let u=new ah({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ae(c,u),f=new Ca(-1,1,1,-1,0,1),_=null,w=null,m=!1,p,v=null,R=[],b=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let y=0;y<R.length;y++){let T=R[y];T.setSize&&T.setSize(C,E)}},this.setEffects=function(C){R=C,b=R.length>0&&R[0].isRenderPass===!0;let E=o.width,y=o.height;R.length>0&&a===null&&(a=new dn(E,y,{type:kn,depthBuffer:!1,stencilBuffer:!1}),l=new dn(E,y,{type:kn,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&R.some(U=>U.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&h===null&&(h=new bs(E,y),r===!0&&(h.format=Ss,h.type=xr)),o.dispose(),o.depthTexture=T?h:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let U=0;U<R.length;U++){let L=R[U];L.setSize&&L.setSize(E,y),T&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(h)}},this.begin=function(C,E){if(m||C.toneMapping===is&&R.length===0)return!1;if(v=E,E!==null){let y=E.width,T=E.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return b===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=is,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=p,m=!0;let y=o,T=a;for(let U=0;U<R.length;U++){let L=R[U];L.enabled!==!1&&(L.render(C,T,y,E),L.needsSwap!==!1&&(y=T,T=T===a?l:a))}if(_!==C.outputColorSpace||w!==C.toneMapping){_=C.outputColorSpace,w=C.toneMapping,u.defines={},ye.getTransfer(_)===Le&&(u.defines.SRGB_TRANSFER="");let U=Hw[w];U&&(u.defines[U]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(v),C.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),c.dispose(),u.dispose()}}var Ug=new Qi,Og=new bs(1,1),kg=new _a(1),Bg=new ca,zg=new ih,Gg=new ga,mg=[],gg=[],_g=new Float32Array(16),xg=new Float32Array(9),yg=new Float32Array(4);function bo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=mg[s];if(r===void 0&&(r=new Float32Array(s),mg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function wi(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Si(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function fc(n,t){let e=gg[t];e===void 0&&(e=new Int32Array(t),gg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Xw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function $w(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wi(e,t))return;n.uniform2fv(this.addr,t),Si(e,t)}}function qw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(wi(e,t))return;n.uniform3fv(this.addr,t),Si(e,t)}}function Yw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wi(e,t))return;n.uniform4fv(this.addr,t),Si(e,t)}}function Zw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(wi(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Si(e,t)}else{if(wi(e,i))return;yg.set(i),n.uniformMatrix2fv(this.addr,!1,yg),Si(e,i)}}function Kw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(wi(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Si(e,t)}else{if(wi(e,i))return;xg.set(i),n.uniformMatrix3fv(this.addr,!1,xg),Si(e,i)}}function Jw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(wi(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Si(e,t)}else{if(wi(e,i))return;_g.set(i),n.uniformMatrix4fv(this.addr,!1,_g),Si(e,i)}}function jw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Qw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wi(e,t))return;n.uniform2iv(this.addr,t),Si(e,t)}}function tS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wi(e,t))return;n.uniform3iv(this.addr,t),Si(e,t)}}function eS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wi(e,t))return;n.uniform4iv(this.addr,t),Si(e,t)}}function iS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function nS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(wi(e,t))return;n.uniform2uiv(this.addr,t),Si(e,t)}}function sS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(wi(e,t))return;n.uniform3uiv(this.addr,t),Si(e,t)}}function rS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(wi(e,t))return;n.uniform4uiv(this.addr,t),Si(e,t)}}function pc(n){return n.version===0&&(n.compareFunction=Xd,n.needsUpdate=!0),n}function oS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=pc(Og):r=Ug,e.setTexture2D(t||r,s)}function aS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||zg,s)}function lS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=pc(kg):r=Gg,e.setTextureCube(t||r,s)}function hS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Bg,s)}function cS(n){switch(n){case 5126:return Xw;case 35664:return $w;case 35665:return qw;case 35666:return Yw;case 35674:return Zw;case 35675:return Kw;case 35676:return Jw;case 5124:case 35670:return jw;case 35667:case 35671:return Qw;case 35668:case 35672:return tS;case 35669:case 35673:return eS;case 5125:return iS;case 36294:return nS;case 36295:return sS;case 36296:return rS;case 35678:case 36198:case 36298:case 36306:case 35682:return oS;case 35679:case 36299:case 36307:return aS;case 35680:case 36300:case 36308:case 36293:return lS;case 36289:case 36303:case 36311:case 36292:return hS}}function uS(n,t){n.uniform1fv(this.addr,t)}function dS(n,t){let e=bo(t,this.size,2);n.uniform2fv(this.addr,e)}function fS(n,t){let e=bo(t,this.size,3);n.uniform3fv(this.addr,e)}function pS(n,t){let e=bo(t,this.size,4);n.uniform4fv(this.addr,e)}function mS(n,t){let e=bo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function gS(n,t){let e=bo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function _S(n,t){let e=bo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function xS(n,t){n.uniform1iv(this.addr,t)}function yS(n,t){n.uniform2iv(this.addr,t)}function vS(n,t){n.uniform3iv(this.addr,t)}function bS(n,t){n.uniform4iv(this.addr,t)}function wS(n,t){n.uniform1uiv(this.addr,t)}function SS(n,t){n.uniform2uiv(this.addr,t)}function MS(n,t){n.uniform3uiv(this.addr,t)}function AS(n,t){n.uniform4uiv(this.addr,t)}function TS(n,t,e){let i=this.cache,s=t.length,r=fc(e,s);wi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=pc(Og):o=Ug;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function ES(n,t,e){let i=this.cache,s=t.length,r=fc(e,s);wi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||zg,r[o])}function CS(n,t,e){let i=this.cache,s=t.length,r=fc(e,s);wi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=pc(kg):o=Gg;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function RS(n,t,e){let i=this.cache,s=t.length,r=fc(e,s);wi(i,r)||(n.uniform1iv(this.addr,r),Si(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Bg,r[o])}function PS(n){switch(n){case 5126:return uS;case 35664:return dS;case 35665:return fS;case 35666:return pS;case 35674:return mS;case 35675:return gS;case 35676:return _S;case 5124:case 35670:return xS;case 35667:case 35671:return yS;case 35668:case 35672:return vS;case 35669:case 35673:return bS;case 5125:return wS;case 36294:return SS;case 36295:return MS;case 36296:return AS;case 35678:case 36198:case 36298:case 36306:case 35682:return TS;case 35679:case 36299:case 36307:return ES;case 35680:case 36300:case 36308:case 36293:return CS;case 36289:case 36303:case 36311:case 36292:return RS}}var rf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=cS(e.type)}},of=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=PS(e.type)}},af=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},nf=/(\w+)(\])?(\[|\.)?/g;function vg(n,t){n.seq.push(t),n.map[t.id]=t}function IS(n,t,e){let i=n.name,s=i.length;for(nf.lastIndex=0;;){let r=nf.exec(i),o=nf.lastIndex,a=r[1],l=r[2]==="]",h=r[3];if(l&&(a=a|0),h===void 0||h==="["&&o+2===s){vg(e,h===void 0?new rf(a,n,t):new of(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new af(a),vg(e,u)),e=u}}}var vo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);IS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function bg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var LS=37297,DS=0;function NS(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var wg=new ne;function FS(n){ye._getMatrix(wg,ye.workingColorSpace,n);let t=`mat3( ${wg.elements.map(e=>e.toFixed(4))} )`;switch(ye.getTransfer(n)){case la:return[t,"LinearTransferOETF"];case Le:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Sg(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+NS(n.getShaderSource(t),a)}else return r}function US(n,t){let e=FS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var OS={[Td]:"Linear",[Ed]:"Reinhard",[Cd]:"Cineon",[Rd]:"ACESFilmic",[Id]:"AgX",[Ld]:"Neutral",[Pd]:"Custom"};function kS(n,t){let e=OS[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var uc=new B;function BS(){ye.getLuminanceCoefficients(uc);let n=uc.x.toFixed(4),t=uc.y.toFixed(4),e=uc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function zS(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Va).join(`
`)}function GS(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function VS(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Va(n){return n!==""}function Mg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Ag(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var HS=/^[ \t]*#include +<([\w\d./]+)>/gm;function lf(n){return n.replace(HS,WS)}function WS(n,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return lf(e)}var XS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Tg(n){return n.replace(XS,$S)}function $S(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Eg(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var qS={[Da]:"SHADOWMAP_TYPE_PCF",[mo]:"SHADOWMAP_TYPE_VSM"};function YS(n){return qS[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ZS={[_o]:"ENVMAP_MODE_REFRACTION"};function KS(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":ZS[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var JS={[wh]:"ENVMAP_BLENDING_MULTIPLY",[Hm]:"ENVMAP_BLENDING_MIX",[Wm]:"ENVMAP_BLENDING_ADD"};function jS(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":JS[n.combine]||"ENVMAP_BLENDING_NONE"}function QS(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=YS(e),h=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",c=KS(e),u=jS(e),d=zS(e),f=GS(r),_=s.createProgram(),w,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(w=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Va).join(`
`),w.length>0&&(w+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Va).join(`
`),m.length>0&&(m+=`
`)):(w=[Eg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Va).join(`
`),m=[Eg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==is?"#define TONE_MAPPING":"",e.toneMapping!==is?ue.tonemapping_pars_fragment:"",e.toneMapping!==is?kS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,US("linearToOutputTexel",e.outputColorSpace),BS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Va).join(`
`)),o=lf(o),o=Mg(o,e),o=Ag(o,e),a=lf(a),a=Mg(a,e),a=Ag(a,e),o=Tg(o),a=Tg(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,w=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+w,m=["#define varying in",e.glslVersion===qd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===qd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+w+o,R=p+m+a,b=bg(s,s.VERTEX_SHADER,v),C=bg(s,s.FRAGMENT_SHADER,R);s.attachShader(_,b),s.attachShader(_,C),e.index0AttributeName!==void 0?s.bindAttribLocation(_,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(_,0,"position"),s.linkProgram(_);function E(L){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(_)||"",z=s.getShaderInfoLog(b)||"",V=s.getShaderInfoLog(C)||"",N=D.trim(),W=z.trim(),q=V.trim(),H=!0,lt=!0;if(s.getProgramParameter(_,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,_,b,C);else{let Z=Sg(s,b,"vertex"),j=Sg(s,C,"fragment");te("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(_,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+N+`
`+Z+`
`+j)}else N!==""?qt("WebGLProgram: Program Info Log:",N):(W===""||q==="")&&(lt=!1);lt&&(L.diagnostics={runnable:H,programLog:N,vertexShader:{log:W,prefix:w},fragmentShader:{log:q,prefix:m}})}s.deleteShader(b),s.deleteShader(C),y=new vo(s,_),T=VS(s,_)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(_,LS)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(_),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=DS++,this.cacheKey=t,this.usedTimes=1,this.program=_,this.vertexShader=b,this.fragmentShader=C,this}var tM=0,hf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new cf(t),e.set(t,i)),i}},cf=class{constructor(t){this.id=tM++,this.code=t,this.usedTimes=0}};function eM(n){return n===Ks||n===Ba||n===za}function iM(n,t,e,i,s,r){let o=new ao,a=new hf,l=new Set,h=[],c=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function _(y,T,U,L,D,z){let V=L.fog,N=D.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||W,q),lt=d[y.type],Z=i.precision;y.precision!==null&&(Z=i.getMaxPrecision(y.precision),Z!==y.precision&&qt("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let j=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,et=j!==void 0?j.length:0,dt=0;N.morphAttributes.position!==void 0&&(dt=1),N.morphAttributes.normal!==void 0&&(dt=2),N.morphAttributes.color!==void 0&&(dt=3);let ut,tt,mt,xt;if(lt){let Ct=ss[lt];ut=Ct.vertexShader,tt=Ct.fragmentShader}else{ut=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),le=a.getFragmentShaderStage(y);a.update(y,Ct,le),mt=Ct.id,xt=le.id}let Et=n.getRenderTarget(),wt=n.state.buffers.depth.getReversed(),Wt=D.isInstancedMesh===!0,oe=D.isBatchedMesh===!0,Vt=!!y.map,de=!!y.matcap,he=!!H,se=he&&H.isPMREMTexture===!0,Je=!!y.aoMap,He=!!y.lightMap,ui=!!y.bumpMap&&y.wireframe===!1,ke=!!y.normalMap,Ei=!!y.displacementMap,be=!!y.emissiveMap,vi=!!y.metalnessMap,ni=!!y.roughnessMap,di=y.anisotropy>0,k=y.clearcoat>0,Rt=y.diffuseRoughness>0,Zt=y.dispersion>0,ae=y.retroreflectivity>0,St=y.iridescence>0,ze=y.sheen>0,zt=y.transmission>0,$t=di&&!!y.anisotropyMap,P=k&&!!y.clearcoatMap,S=k&&!!y.clearcoatNormalMap,$=k&&!!y.clearcoatRoughnessMap,ct=Rt&&!!y.diffuseRoughnessMap,ot=St&&!!y.iridescenceMap,_t=St&&!!y.iridescenceThicknessMap,yt=ze&&!!y.sheenColorMap,it=ze&&!!y.sheenRoughnessMap,st=!!y.specularMap,pt=!!y.specularColorMap,O=!!y.specularIntensityMap,rt=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,Mt=!!y.gradientMap,gt=!!y.alphaMap,bt=y.alphaTest>0,Ht=!!y.alphaHash,jt=!!y.extensions,ht=is;y.toneMapped&&(Et===null||Et.isXRRenderTarget===!0)&&(ht=n.toneMapping);let Ot=se?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Qt={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:ut,fragmentShader:tt,defines:y.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:oe,batchingColor:oe&&D._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&D.instanceColor!==null,instancingMorph:Wt&&D.morphTexture!==null,outputColorSpace:Et===null?n.outputColorSpace:Et.isXRRenderTarget===!0?Et.texture.colorSpace:ye.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:de,envMap:he,envMapMode:he&&H.mapping,envMapPMREM:se,envMapMaxLod:se?Ot.length-1:null,envMapSize:se?Ot[0].width:null,aoMap:Je,lightMap:He,bumpMap:ui,normalMap:ke,displacementMap:Ei,emissiveMap:be,normalMapObjectSpace:ke&&y.normalMapType===qm,normalMapTangentSpace:ke&&y.normalMapType===lc,packedNormalMap:ke&&y.normalMapType===lc&&eM(y.normalMap.format),metalnessMap:vi,roughnessMap:ni,anisotropy:di,anisotropyMap:$t,clearcoat:k,clearcoatMap:P,clearcoatNormalMap:S,clearcoatRoughnessMap:$,diffuseRoughness:Rt,diffuseRoughnessMap:ct,dispersion:Zt,retroreflection:ae,iridescence:St,iridescenceMap:ot,iridescenceThicknessMap:_t,sheen:ze,sheenColorMap:yt,sheenRoughnessMap:it,specularMap:st,specularColorMap:pt,specularIntensityMap:O,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:Mt,opaque:y.transparent===!1&&y.blending===go&&y.alphaToCoverage===!1,alphaMap:gt,alphaTest:bt,alphaHash:Ht,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:Je&&f(y.aoMap.channel),lightMapUv:He&&f(y.lightMap.channel),bumpMapUv:ui&&f(y.bumpMap.channel),normalMapUv:ke&&f(y.normalMap.channel),displacementMapUv:Ei&&f(y.displacementMap.channel),emissiveMapUv:be&&f(y.emissiveMap.channel),metalnessMapUv:vi&&f(y.metalnessMap.channel),roughnessMapUv:ni&&f(y.roughnessMap.channel),anisotropyMapUv:$t&&f(y.anisotropyMap.channel),clearcoatMapUv:P&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ct&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:it&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:pt&&f(y.specularColorMap.channel),specularIntensityMapUv:O&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:gt&&f(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(ke||di),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!N.attributes.uv&&(Vt||gt),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&ke===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:wt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:dt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:z.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ht,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&ye.getTransfer(y.map.colorSpace)===Le,decodeVideoTextureEmissive:be&&y.emissiveMap.isVideoTexture===!0&&ye.getTransfer(y.emissiveMap.colorSpace)===Le,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Mn,flipSided:y.side===Ji,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:jt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(jt&&y.extensions.multiDraw===!0||oe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Qt.vertexUv1s=l.has(1),Qt.vertexUv2s=l.has(2),Qt.vertexUv3s=l.has(3),l.clear(),Qt}function w(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)T.push(U),T.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(m(T,y),p(T,y),T.push(n.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}function m(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}function p(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let T=d[y.type],U;if(T){let L=ss[T];U=lg.clone(L.uniforms)}else U=y.uniforms;return U}function R(y,T){let U=c.get(T);return U!==void 0?++U.usedTimes:(U=new QS(n,T,y,s),h.push(U),c.set(T,U)),U}function b(y){if(--y.usedTimes===0){let T=h.indexOf(y);h[T]=h[h.length-1],h.pop(),c.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function E(){a.dispose()}return{getParameters:_,getProgramCacheKey:w,getUniforms:v,acquireProgram:R,releaseProgram:b,releaseShaderCache:C,programs:h,dispose:E}}function nM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function sM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Cg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Rg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,_,w,m,p){let v=n[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:_,materialVariant:o(d),groupOrder:w,renderOrder:d.renderOrder,z:m,group:p},n[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=_,v.materialVariant=o(d),v.groupOrder=w,v.renderOrder=d.renderOrder,v.z=m,v.group=p),t++,v}function l(d,f,_,w,m,p,v){v.reversedDepth===!0&&(m=-m);let R=a(d,f,_,w,m,p);_.transmission>0?i.push(R):_.transparent===!0?s.push(R):e.push(R)}function h(d,f,_,w,m,p){let v=a(d,f,_,w,m,p);_.transmission>0?i.unshift(v):_.transparent===!0?s.unshift(v):e.unshift(v)}function c(d,f){e.length>1&&e.sort(d||sM),i.length>1&&i.sort(f||Cg),s.length>1&&s.sort(f||Cg)}function u(){for(let d=t,f=n.length;d<f;d++){let _=n[d];if(_.id===null)break;_.id=null,_.object=null,_.geometry=null,_.material=null,_.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:h,finish:u,sort:c}}function rM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Rg,n.set(i,[o])):s>=r.length?(o=new Rg,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function oM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new B,color:new ie};break;case"SpotLight":e={position:new B,direction:new B,color:new ie,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new B,color:new ie,distance:0,decay:0};break;case"HemisphereLight":e={direction:new B,skyColor:new ie,groundColor:new ie};break;case"RectAreaLight":e={color:new ie,position:new B,halfWidth:new B,halfHeight:new B};break}return n[t.id]=e,e}}}function aM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var lM=0;function hM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function cM(n){let t=new oM,e=aM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let h=0;h<9;h++)i.probe.push(new B);let s=new B,r=new Ce,o=new Ce;function a(h){let c=0,u=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,_=0,w=0,m=0,p=0,v=0,R=0,b=0,C=0,E=0,y=0,T=0,U=0,L=0;h.sort(hM);for(let z=0,V=h.length;z<V;z++){let N=h[z],W=N.color,q=N.intensity,H=N.distance,lt=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Ks?lt=N.shadow.map.texture:lt=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)c+=W.r*q,u+=W.g*q,d+=W.b*q;else if(N.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(N.sh.coefficients[Z],q);L++}else if(N.isSunLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[_]=et,i.sunShadowMap[_]=lt;let dt=j.getViewportCount();for(let ut=0;ut<dt;ut++)i.sunShadowMatrix[w+ut]=j.getMatrix(ut),i.sunShadowCascade[w+ut]=j._cascadeData[ut];w+=dt,_++}i.sun[f]=Z,f++}else if(N.isDirectionalLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let j=N.shadow,et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=lt,i.directionalShadowMatrix[m]=N.shadow.matrix,C++}i.directional[m]=Z,m++}else if(N.isSpotLight){let Z=t.get(N);Z.position.setFromMatrixPosition(N.matrixWorld),Z.color.copy(W).multiplyScalar(q),Z.distance=H,Z.coneCos=Math.cos(N.angle),Z.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),Z.decay=N.decay,i.spot[v]=Z;let j=N.shadow;if(N.map&&(i.spotLightMap[T]=N.map,T++,j.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[v]=j.matrix,N.castShadow){let et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.spotShadow[v]=et,i.spotShadowMap[v]=lt,y++}v++}else if(N.isRectAreaLight){let Z=t.get(N);Z.color.copy(W).multiplyScalar(q),Z.halfWidth.set(N.width*.5,0,0),Z.halfHeight.set(0,N.height*.5,0),i.rectArea[R]=Z,R++}else if(N.isPointLight){let Z=t.get(N);if(Z.color.copy(N.color).multiplyScalar(N.intensity),Z.distance=N.distance,Z.decay=N.decay,N.castShadow){let j=N.shadow,et=e.get(N);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,i.pointShadow[p]=et,i.pointShadowMap[p]=lt,i.pointShadowMatrix[p]=N.shadow.matrix,E++}i.point[p]=Z,p++}else if(N.isHemisphereLight){let Z=t.get(N);Z.skyColor.copy(N.color).multiplyScalar(q),Z.groundColor.copy(N.groundColor).multiplyScalar(q),i.hemi[b]=Z,b++}}R>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=c,i.ambient[1]=u,i.ambient[2]=d;let D=i.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==p||D.spotLength!==v||D.rectAreaLength!==R||D.hemiLength!==b||D.numSunShadows!==_||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==y||D.numSpotMaps!==T||D.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=v,i.rectArea.length=R,i.point.length=p,i.hemi.length=b,i.sunShadow.length=_,i.sunShadowMap.length=_,i.sunShadowMatrix.length=w,i.sunShadowCascade.length=w,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+T-U,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=L,D.sunLength=f,D.directionalLength=m,D.pointLength=p,D.spotLength=v,D.rectAreaLength=R,D.hemiLength=b,D.numSunShadows=_,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=y,D.numSpotMaps=T,D.numLightProbes=L,i.version=lM++)}function l(h,c){let u=0,d=0,f=0,_=0,w=0,m=0,p=c.matrixWorldInverse;for(let v=0,R=h.length;v<R;v++){let b=h[v];if(b.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),u++}else if(b.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(b.isSpotLight){let C=i.spot[_];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),_++}else if(b.isRectAreaLight){let C=i.rectArea[w];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),w++}else if(b.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:i}}function Pg(n){let t=new cM(n),e=[],i=[],s=[];function r(u){c.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function h(u){t.setupView(e,u)}let c={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:c,setupLights:l,setupLightsView:h,pushLight:o,pushShadow:a}}function uM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Pg(n),t.set(s,[a])):r>=o.length?(a=new Pg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var dM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,fM=`uniform sampler2D shadow_pass;
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
}`,pM=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],mM=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],Ig=new Ce,Ga=new B,sf=new B;function gM(n,t,e){let i=new Gs,s=new Yt,r=new Yt,o=new Qe,a=new lh,l=new hh,h={},c=e.maxTextureSize,u={[Zs]:Ji,[Ji]:Zs,[Mn]:Mn},d=new es({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:dM,fragmentShader:fM}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let _=new ti;_.setAttribute("position",new li(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let w=new Ae(_,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Da;let p=this.type;this.render=function(E,y,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Mm&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Da);let U=n.getRenderTarget(),L=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),z=n.state;z.setBlending(mr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let V=p!==this.type;V&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=E.length;N<W;N++){let q=E[N],H=q.shadow;if(H===void 0){qt("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let lt=H.getFrameExtents();s.multiply(lt),r.copy(H.mapSize),(s.x>c||s.y>c)&&(s.x>c&&(r.x=Math.floor(c/lt.x),s.x=r.x*lt.x,H.mapSize.x=r.x),s.y>c&&(r.y=Math.floor(c/lt.y),s.y=r.y*lt.y,H.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=Z,H.map===null||V===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===mo){if(q.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new dn(s.x,s.y,{format:Ks,type:kn,minFilter:Ki,magFilter:Ki,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new bs(s.x,s.y,On),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=xs,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Di,H.map.depthTexture.magFilter=Di}else q.isPointLight?(H.map=new Ha(s.x),H.map.depthTexture=new _a(s.x,Un)):(H.map=new dn(s.x,s.y),H.map.depthTexture=new bs(s.x,s.y,Un)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=xs,this.type===Da?(H.map.depthTexture.compareFunction=Z?Wd:Hd,H.map.depthTexture.minFilter=Ki,H.map.depthTexture.magFilter=Ki):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Di,H.map.depthTexture.magFilter=Di);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let j=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,T);let et=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let dt=0;dt<j;dt++){let ut=H.getCamera(dt);if(q.isPointLight){let tt=H.camera,mt=H.matrix,xt=q.distance||tt.far;xt!==tt.far&&(tt.far=xt,tt.updateProjectionMatrix()),Ga.setFromMatrixPosition(q.matrixWorld),tt.position.copy(Ga),sf.copy(tt.position),sf.add(pM[dt]),tt.up.copy(mM[dt]),tt.lookAt(sf),tt.updateMatrixWorld(),mt.makeTranslation(-Ga.x,-Ga.y,-Ga.z),Ig.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(Ig,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(H.map),n.clear());let tt=H.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),z.viewport(o)}i=H.getFrustum(dt),b(y,T,ut,q,et,this.type)}H.isPointLightShadow!==!0&&this.type===mo&&v(H,T),H.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(U,L,D)};function v(E,y){let T=t.update(w);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new dn(s.x,s.y,{format:Ks,type:kn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(y,null,T,d,w,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(y,null,T,f,w,null)}function R(E,y,T,U){let L=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)L=D;else if(L=T.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let z=L.uuid,V=y.uuid,N=h[z];N===void 0&&(N={},h[z]=N);let W=N[V];W===void 0&&(W=L.clone(),N[V]=W,y.addEventListener("dispose",C)),L=W}if(L.visible=y.visible,L.wireframe=y.wireframe,U===mo?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:u[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,T.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let z=n.properties.get(L);z.light=T}return L}function b(E,y,T,U,L,D){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===mo)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let N=t.update(E),W=E.material;if(Array.isArray(W)){let q=N.groups;for(let H=0,lt=q.length;H<lt;H++){let Z=q[H],j=W[Z.materialIndex];if(j&&j.visible){let et=R(E,j,U,D);E.onBeforeShadow(n,E,y,T,N,et,Z),n.renderBufferDirect(T,null,N,et,E,Z),E.onAfterShadow(n,E,y,T,N,et,Z)}}}else if(W.visible){let q=R(E,W,U,D);E.onBeforeShadow(n,E,y,T,N,q,null),n.renderBufferDirect(T,null,N,q,E,null),E.onAfterShadow(n,E,y,T,N,q,null)}}let V=E.children;for(let N=0,W=V.length;N<W;N++)b(V[N],y,T,U,L,D)}function C(E){E.target.removeEventListener("dispose",C);for(let T in h){let U=h[T],L=E.target.uuid;L in U&&(U[L].dispose(),delete U[L])}}}function _M(n,t){function e(){let O=!1,rt=new Qe,nt=null,Mt=new Qe(0,0,0,0);return{setMask:function(gt){nt!==gt&&!O&&(n.colorMask(gt,gt,gt,gt),nt=gt)},setLocked:function(gt){O=gt},setClear:function(gt,bt,Ht,jt,ht){ht===!0&&(gt*=jt,bt*=jt,Ht*=jt),rt.set(gt,bt,Ht,jt),Mt.equals(rt)===!1&&(n.clearColor(gt,bt,Ht,jt),Mt.copy(rt))},reset:function(){O=!1,nt=null,Mt.set(-1,0,0,0)}}}function i(){let O=!1,rt=!1,nt=null,Mt=null,gt=null;return{setReversed:function(bt){if(rt!==bt){let Ht=t.get("EXT_clip_control");bt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let jt=gt;gt=null,this.setClear(jt)}},getReversed:function(){return rt},setTest:function(bt){bt?wt(n.DEPTH_TEST):Wt(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!O&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=sg[bt]),Mt!==bt){switch(bt){case Wl:n.depthFunc(n.NEVER);break;case Xl:n.depthFunc(n.ALWAYS);break;case $l:n.depthFunc(n.LESS);break;case io:n.depthFunc(n.LEQUAL);break;case ql:n.depthFunc(n.EQUAL);break;case Yl:n.depthFunc(n.GEQUAL);break;case Zl:n.depthFunc(n.GREATER);break;case Kl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Mt=bt}},setLocked:function(bt){O=bt},setClear:function(bt){gt!==bt&&(gt=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){O=!1,nt=null,Mt=null,gt=null,rt=!1}}}function s(){let O=!1,rt=null,nt=null,Mt=null,gt=null,bt=null,Ht=null,jt=null,ht=null;return{setTest:function(Ot){O||(Ot?wt(n.STENCIL_TEST):Wt(n.STENCIL_TEST))},setMask:function(Ot){rt!==Ot&&!O&&(n.stencilMask(Ot),rt=Ot)},setFunc:function(Ot,Qt,Ct){(nt!==Ot||Mt!==Qt||gt!==Ct)&&(n.stencilFunc(Ot,Qt,Ct),nt=Ot,Mt=Qt,gt=Ct)},setOp:function(Ot,Qt,Ct){(bt!==Ot||Ht!==Qt||jt!==Ct)&&(n.stencilOp(Ot,Qt,Ct),bt=Ot,Ht=Qt,jt=Ct)},setLocked:function(Ot){O=Ot},setClear:function(Ot){ht!==Ot&&(n.clearStencil(Ot),ht=Ot)},reset:function(){O=!1,rt=null,nt=null,Mt=null,gt=null,bt=null,Ht=null,jt=null,ht=null}}}let r=new e,o=new i,a=new s,l={},h=new WeakMap,c={},u={},d={},f=new WeakMap,_=[],w=null,m=!1,p=null,v=null,R=null,b=null,C=null,E=null,y=null,T=new ie(0,0,0),U=0,L=!1,D=null,z=null,V=null,N=null,W=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,lt=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(Z)[1]),H=lt>=1):Z.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),H=lt>=2);let j=null,et={},dt=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),tt=new Qe().fromArray(dt),mt=new Qe().fromArray(ut);function xt(O,rt,nt,Mt){let gt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(O,bt),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<nt;Ht++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,Mt,0,n.RGBA,n.UNSIGNED_BYTE,gt):n.texImage2D(rt+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,gt);return bt}let Et={};Et[n.TEXTURE_2D]=xt(n.TEXTURE_2D,n.TEXTURE_2D,1),Et[n.TEXTURE_CUBE_MAP]=xt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Et[n.TEXTURE_2D_ARRAY]=xt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Et[n.TEXTURE_3D]=xt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(n.DEPTH_TEST),o.setFunc(io),ui(!1),ke(vd),wt(n.CULL_FACE),Je(mr);function wt(O){c[O]!==!0&&(n.enable(O),c[O]=!0)}function Wt(O){c[O]!==!1&&(n.disable(O),c[O]=!1)}function oe(O,rt){return d[O]!==rt?(n.bindFramebuffer(O,rt),d[O]=rt,O===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),O===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(O,rt){let nt=_,Mt=!1;if(O){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let gt=O.textures;if(nt.length!==gt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Ht=gt.length;bt<Ht;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=gt.length,Mt=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,Mt=!0);Mt&&n.drawBuffers(nt)}function de(O){return w!==O?(n.useProgram(O),w=O,!0):!1}let he={[gr]:n.FUNC_ADD,[Tm]:n.FUNC_SUBTRACT,[Em]:n.FUNC_REVERSE_SUBTRACT};he[Cm]=n.MIN,he[Rm]=n.MAX;let se={[Pm]:n.ZERO,[Im]:n.ONE,[Lm]:n.SRC_COLOR,[Md]:n.SRC_ALPHA,[km]:n.SRC_ALPHA_SATURATE,[Um]:n.DST_COLOR,[Nm]:n.DST_ALPHA,[Dm]:n.ONE_MINUS_SRC_COLOR,[Ad]:n.ONE_MINUS_SRC_ALPHA,[Om]:n.ONE_MINUS_DST_COLOR,[Fm]:n.ONE_MINUS_DST_ALPHA,[Bm]:n.CONSTANT_COLOR,[zm]:n.ONE_MINUS_CONSTANT_COLOR,[Gm]:n.CONSTANT_ALPHA,[Vm]:n.ONE_MINUS_CONSTANT_ALPHA};function Je(O,rt,nt,Mt,gt,bt,Ht,jt,ht,Ot){if(O===mr){m===!0&&(Wt(n.BLEND),m=!1);return}if(m===!1&&(wt(n.BLEND),m=!0),O!==Am){if(O!==p||Ot!==L){if((v!==gr||C!==gr)&&(n.blendEquation(n.FUNC_ADD),v=gr,C=gr),Ot)switch(O){case go:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bd:n.blendFunc(n.ONE,n.ONE);break;case wd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Sd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:te("WebGLState: Invalid blending: ",O);break}else switch(O){case go:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case bd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case wd:te("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Sd:te("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:te("WebGLState: Invalid blending: ",O);break}R=null,b=null,E=null,y=null,T.set(0,0,0),U=0,p=O,L=Ot}return}gt=gt||rt,bt=bt||nt,Ht=Ht||Mt,(rt!==v||gt!==C)&&(n.blendEquationSeparate(he[rt],he[gt]),v=rt,C=gt),(nt!==R||Mt!==b||bt!==E||Ht!==y)&&(n.blendFuncSeparate(se[nt],se[Mt],se[bt],se[Ht]),R=nt,b=Mt,E=bt,y=Ht),(jt.equals(T)===!1||ht!==U)&&(n.blendColor(jt.r,jt.g,jt.b,ht),T.copy(jt),U=ht),p=O,L=!1}function He(O,rt){O.side===Mn?Wt(n.CULL_FACE):wt(n.CULL_FACE);let nt=O.side===Ji;rt&&(nt=!nt),ui(nt),O.blending===go&&O.transparent===!1?Je(mr):Je(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Mt=O.stencilWrite;a.setTest(Mt),Mt&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),be(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?wt(n.SAMPLE_ALPHA_TO_COVERAGE):Wt(n.SAMPLE_ALPHA_TO_COVERAGE)}function ui(O){D!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),D=O)}function ke(O){O!==wm?(wt(n.CULL_FACE),O!==z&&(O===vd?n.cullFace(n.BACK):O===Sm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Wt(n.CULL_FACE),z=O}function Ei(O){O!==V&&(H&&n.lineWidth(O),V=O)}function be(O,rt,nt){O?(wt(n.POLYGON_OFFSET_FILL),(N!==rt||W!==nt)&&(N=rt,W=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Wt(n.POLYGON_OFFSET_FILL)}function vi(O){O?wt(n.SCISSOR_TEST):Wt(n.SCISSOR_TEST)}function ni(O){O===void 0&&(O=n.TEXTURE0+q-1),j!==O&&(n.activeTexture(O),j=O)}function di(O,rt,nt){nt===void 0&&(j===null?nt=n.TEXTURE0+q-1:nt=j);let Mt=et[nt];Mt===void 0&&(Mt={type:void 0,texture:void 0},et[nt]=Mt),(Mt.type!==O||Mt.texture!==rt)&&(j!==nt&&(n.activeTexture(nt),j=nt),n.bindTexture(O,rt||Et[O]),Mt.type=O,Mt.texture=rt)}function k(){let O=et[j];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function Zt(){try{n.compressedTexImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function ae(){try{n.texSubImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function St(){try{n.texSubImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function ze(){try{n.compressedTexSubImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function $t(){try{n.texStorage2D(...arguments)}catch(O){te("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){te("WebGLState:",O)}}function S(){try{n.texImage2D(...arguments)}catch(O){te("WebGLState:",O)}}function $(){try{n.texImage3D(...arguments)}catch(O){te("WebGLState:",O)}}function ct(O){return u[O]!==void 0?u[O]:n.getParameter(O)}function ot(O,rt){u[O]!==rt&&(n.pixelStorei(O,rt),u[O]=rt)}function _t(O){tt.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),tt.copy(O))}function yt(O){mt.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),mt.copy(O))}function it(O,rt){let nt=h.get(rt);nt===void 0&&(nt=new WeakMap,h.set(rt,nt));let Mt=nt.get(O);Mt===void 0&&(Mt=n.getUniformBlockIndex(rt,O.name),n.uniformBlockBinding(rt,Mt,Mt),nt.set(O,Mt))}function st(O,rt,nt){let gt=h.get(rt).get(O);l[gt]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,gt,nt),l[gt]=nt)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),c={},u={},j=null,et={},d={},l={},f=new WeakMap,_=[],w=null,m=!1,p=null,v=null,R=null,b=null,C=null,E=null,y=null,T=new ie(0,0,0),U=0,L=!1,D=null,z=null,V=null,N=null,W=null,tt.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:Wt,bindFramebuffer:oe,drawBuffers:Vt,useProgram:de,setBlending:Je,setMaterial:He,setFlipSided:ui,setCullFace:ke,setLineWidth:Ei,setPolygonOffset:be,setScissorTest:vi,activeTexture:ni,bindTexture:di,unbindTexture:k,compressedTexImage2D:Rt,compressedTexImage3D:Zt,texImage2D:S,texImage3D:$,pixelStorei:ot,getParameter:ct,updateUBOMapping:it,uniformBlockBinding:st,texStorage2D:$t,texStorage3D:P,texSubImage2D:ae,texSubImage3D:St,compressedTexSubImage2D:ze,compressedTexSubImage3D:zt,scissor:_t,viewport:yt,reset:pt}}function xM(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),h=new Yt,c=new WeakMap,u=new Set,d,f=new WeakMap,_=new Set,w=new FinalizationRegistry(P=>_.delete(P)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(P,S){return m?new OffscreenCanvas(P,S):ha("canvas")}function v(P,S,$){let ct=1,ot=$t(P);if((ot.width>$||ot.height>$)&&(ct=$/Math.max(ot.width,ot.height)),ct<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let _t=Math.floor(ct*ot.width),yt=Math.floor(ct*ot.height);d===void 0&&(d=p(_t,yt));let it=S?p(_t,yt):d;return it.width=_t,it.height=yt,it.getContext("2d").drawImage(P,0,0,_t,yt),qt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+_t+"x"+yt+")."),it}else return"data"in P&&qt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),P;return P}function R(P){return P.generateMipmaps}function b(P){n.generateMipmap(P)}function C(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(P,S,$,ct,ot,_t=!1){if(P!==null){if(n[P]!==void 0)return n[P];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let yt;ct&&(yt=t.get("EXT_texture_norm16"),yt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let it=S;if(S===n.RED&&($===n.FLOAT&&(it=n.R32F),$===n.HALF_FLOAT&&(it=n.R16F),$===n.UNSIGNED_BYTE&&(it=n.R8),$===n.UNSIGNED_SHORT&&yt&&(it=yt.R16_EXT),$===n.SHORT&&yt&&(it=yt.R16_SNORM_EXT)),S===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.R8UI),$===n.UNSIGNED_SHORT&&(it=n.R16UI),$===n.UNSIGNED_INT&&(it=n.R32UI),$===n.BYTE&&(it=n.R8I),$===n.SHORT&&(it=n.R16I),$===n.INT&&(it=n.R32I)),S===n.RG&&($===n.FLOAT&&(it=n.RG32F),$===n.HALF_FLOAT&&(it=n.RG16F),$===n.UNSIGNED_BYTE&&(it=n.RG8),$===n.UNSIGNED_SHORT&&yt&&(it=yt.RG16_EXT),$===n.SHORT&&yt&&(it=yt.RG16_SNORM_EXT)),S===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.RG8UI),$===n.UNSIGNED_SHORT&&(it=n.RG16UI),$===n.UNSIGNED_INT&&(it=n.RG32UI),$===n.BYTE&&(it=n.RG8I),$===n.SHORT&&(it=n.RG16I),$===n.INT&&(it=n.RG32I)),S===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.RGB8UI),$===n.UNSIGNED_SHORT&&(it=n.RGB16UI),$===n.UNSIGNED_INT&&(it=n.RGB32UI),$===n.BYTE&&(it=n.RGB8I),$===n.SHORT&&(it=n.RGB16I),$===n.INT&&(it=n.RGB32I)),S===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(it=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(it=n.RGBA16UI),$===n.UNSIGNED_INT&&(it=n.RGBA32UI),$===n.BYTE&&(it=n.RGBA8I),$===n.SHORT&&(it=n.RGBA16I),$===n.INT&&(it=n.RGBA32I)),S===n.RGB&&($===n.UNSIGNED_SHORT&&yt&&(it=yt.RGB16_EXT),$===n.SHORT&&yt&&(it=yt.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(it=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(it=n.R11F_G11F_B10F)),S===n.RGBA){let st=_t?la:ye.getTransfer(ot);$===n.FLOAT&&(it=n.RGBA32F),$===n.HALF_FLOAT&&(it=n.RGBA16F),$===n.UNSIGNED_BYTE&&(it=st===Le?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&yt&&(it=yt.RGBA16_EXT),$===n.SHORT&&yt&&(it=yt.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(it=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(it=n.RGB5_A1)}return(it===n.R16F||it===n.R32F||it===n.RG16F||it===n.RG32F||it===n.RGBA16F||it===n.RGBA32F)&&t.get("EXT_color_buffer_float"),it}function y(P,S){let $;return P?S===null||S===Un||S===xr?$=n.DEPTH24_STENCIL8:S===On?$=n.DEPTH32F_STENCIL8:S===xo&&($=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Un||S===xr?$=n.DEPTH_COMPONENT24:S===On?$=n.DEPTH_COMPONENT32F:S===xo&&($=n.DEPTH_COMPONENT16),$}function T(P,S){return R(P)===!0||P.isFramebufferTexture&&P.minFilter!==Di&&P.minFilter!==Ki?Math.log2(Math.max(S.width,S.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?S.mipmaps.length:1}function U(P){let S=new WeakRef(P);i.get(P).__ref=S,_.add(S),w.register(P,S,S)}function L(P){let S=i.get(P).__ref;S!==void 0&&(_.delete(S),w.unregister(S))}function D(P){V(P.target)}function z(P){N(P.target)}function V(P){P.removeEventListener("dispose",D),L(P),q(P),P.isVideoTexture&&c.delete(P),P.isHTMLTexture&&u.delete(P)}function N(P){P.removeEventListener("dispose",z),L(P),lt(P)}function W(){for(let P of _){let S=P.deref();S!==void 0&&(S.isRenderTarget===!0?N(S):V(S))}_.clear(),u.clear()}function q(P){let S=i.get(P);if(S.__webglInit===void 0)return;let $=P.source,ct=f.get($);if(ct){let ot=ct[S.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&H(P),Object.keys(ct).length===0&&f.delete($)}i.remove(P)}function H(P){let S=i.get(P);n.deleteTexture(S.__webglTexture);let $=P.source,ct=f.get($);delete ct[S.__cacheKey],o.memory.textures--}function lt(P){let S=i.get(P);S.__depthDisposeCallback&&S.__depthDisposeCallback();let $=P.depthTexture;if($&&$.renderTarget===P&&V($),P.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(S.__webglFramebuffer[ot]))for(let _t=0;_t<S.__webglFramebuffer[ot].length;_t++)n.deleteFramebuffer(S.__webglFramebuffer[ot][_t]);else n.deleteFramebuffer(S.__webglFramebuffer[ot]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ot])}else{if(Array.isArray(S.__webglFramebuffer))for(let ot=0;ot<S.__webglFramebuffer.length;ot++)n.deleteFramebuffer(S.__webglFramebuffer[ot]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ot=0;ot<S.__webglColorRenderbuffer.length;ot++)S.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ot]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ct=P.textures;for(let ot=0,_t=ct.length;ot<_t;ot++){let yt=i.get(ct[ot]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ct[ot])}i.remove(P)}let Z=0;function j(){Z=0}function et(){return Z}function dt(P){Z=P}function ut(){let P=Z;return P>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,P}function tt(P){let S=[];return S.push(P.wrapS),S.push(P.wrapT),S.push(P.wrapR||0),S.push(P.magFilter),S.push(P.minFilter),S.push(P.anisotropy),S.push(P.internalFormat),S.push(P.format),S.push(P.type),S.push(P.generateMipmaps),S.push(P.mipmapsAutoUpdate),S.push(P.premultiplyAlpha),S.push(P.flipY),S.push(P.unpackAlignment),S.push(P.colorSpace),S.join()}function mt(P,S){let $=i.get(P);if(P.isVideoTexture&&ze(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&$.__version!==P.version){let ct=P.image;if(ct===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ct.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{He($,P,S);return}}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+S)}function xt(P,S){let $=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){He($,P,S);return}else P.isExternalTexture&&($.__webglTexture=P.sourceTexture?P.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+S)}function Et(P,S){let $=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&$.__version!==P.version){He($,P,S);return}e.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+S)}function wt(P,S){let $=i.get(P);if(P.version>0&&$.__version!==P.version){ui($,P,S);return}e.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+S)}let Wt={[Jl]:n.REPEAT,[Qn]:n.CLAMP_TO_EDGE,[jl]:n.MIRRORED_REPEAT},oe={[Di]:n.NEAREST,[Xm]:n.NEAREST_MIPMAP_NEAREST,[Na]:n.NEAREST_MIPMAP_LINEAR,[Ki]:n.LINEAR,[Ah]:n.LINEAR_MIPMAP_NEAREST,[ws]:n.LINEAR_MIPMAP_LINEAR},Vt={[Zm]:n.NEVER,[Xd]:n.ALWAYS,[Km]:n.LESS,[Hd]:n.LEQUAL,[Jm]:n.EQUAL,[Wd]:n.GEQUAL,[jm]:n.GREATER,[Qm]:n.NOTEQUAL};function de(P,S){if(S.type===On&&t.has("OES_texture_float_linear")===!1&&(S.magFilter===Ki||S.magFilter===Ah||S.magFilter===Na||S.magFilter===ws||S.minFilter===Ki||S.minFilter===Ah||S.minFilter===Na||S.minFilter===ws)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,Wt[S.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,Wt[S.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,Wt[S.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,oe[S.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,oe[S.minFilter]),S.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Vt[S.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Di||S.minFilter!==Na&&S.minFilter!==ws||S.type===On&&t.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function he(P,S){let $=!1;P.__webglInit===void 0&&(P.__webglInit=!0,S.addEventListener("dispose",D),U(S));let ct=S.source,ot=f.get(ct);ot===void 0&&(ot={},f.set(ct,ot));let _t=tt(S);if(_t!==P.__cacheKey){ot[_t]===void 0&&(ot[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ot[_t].usedTimes++;let yt=ot[P.__cacheKey];yt!==void 0&&(ot[P.__cacheKey].usedTimes--,yt.usedTimes===0&&H(S)),P.__cacheKey=_t,P.__webglTexture=ot[_t].texture}return $}function se(P,S,$){return Math.floor(Math.floor(P/$)/S)}function Je(P,S,$,ct){let _t=P.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,$,ct,S.data);else{_t.sort((O,rt)=>O.start-rt.start);let yt=0;for(let O=1;O<_t.length;O++){let rt=_t[yt],nt=_t[O],Mt=rt.start+rt.count,gt=se(nt.start,S.width,4),bt=se(rt.start,S.width,4);nt.start<=Mt+1&&gt===bt&&se(nt.start+nt.count-1,S.width,4)===gt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,_t[yt]=nt)}_t.length=yt+1;let it=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let O=0,rt=_t.length;O<rt;O++){let nt=_t[O],Mt=Math.floor(nt.start/4),gt=Math.ceil(nt.count/4),bt=Mt%S.width,Ht=Math.floor(Mt/S.width),jt=gt,ht=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,bt,Ht,jt,ht,$,ct,S.data)}P.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,it),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function He(P,S,$){let ct=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ct=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ct=n.TEXTURE_3D);let ot=he(P,S),_t=S.source;e.bindTexture(ct,P.__webglTexture,n.TEXTURE0+$);let yt=i.get(_t);if(_t.version!==yt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ht=ye.getPrimaries(ye.workingColorSpace),Ot=S.colorSpace===Ms?null:ye.getPrimaries(S.colorSpace),Qt=S.colorSpace===Ms||ht===Ot?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Qt)}e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let st=v(S.image,!1,s.maxTextureSize);st=zt(S,st);let pt=r.convert(S.format,S.colorSpace),O=r.convert(S.type),rt=E(S.internalFormat,pt,O,S.normalized,S.colorSpace,S.isVideoTexture);de(ct,S);let nt,Mt=S.mipmaps,gt=S.isVideoTexture!==!0,bt=yt.__version===void 0||ot===!0,Ht=_t.dataReady,jt=T(S,st);if(S.isDepthTexture)rt=y(S.format===Ss,S.type),bt&&(gt?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,pt,O,null));else if(S.isDataTexture)if(Mt.length>0){gt&&bt&&e.texStorage2D(n.TEXTURE_2D,jt,rt,Mt[0].width,Mt[0].height);for(let ht=0,Ot=Mt.length;ht<Ot;ht++)nt=Mt[ht],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,nt.width,nt.height,pt,O,nt.data):e.texImage2D(n.TEXTURE_2D,ht,rt,nt.width,nt.height,0,pt,O,nt.data);S.generateMipmaps=!1}else gt?(bt&&e.texStorage2D(n.TEXTURE_2D,jt,rt,st.width,st.height),Ht&&Je(S,st,pt,O)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,pt,O,st.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){gt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,jt,rt,Mt[0].width,Mt[0].height,st.depth);for(let ht=0,Ot=Mt.length;ht<Ot;ht++)if(nt=Mt[ht],S.format!==Bn)if(pt!==null)if(gt){if(Ht)if(S.layerUpdates.size>0){let Qt=ef(nt.width,nt.height,S.format,S.type);for(let Ct of S.layerUpdates){let le=nt.data.subarray(Ct*Qt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Qt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,Ct,nt.width,nt.height,1,pt,le)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,st.depth,pt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ht,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else gt?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,nt.width,nt.height,st.depth,pt,O,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ht,rt,nt.width,nt.height,st.depth,0,pt,O,nt.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{gt&&bt&&e.texStorage2D(n.TEXTURE_2D,jt,rt,Mt[0].width,Mt[0].height);for(let ht=0,Ot=Mt.length;ht<Ot;ht++)nt=Mt[ht],S.format!==Bn?pt!==null?gt?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,ht,0,0,nt.width,nt.height,pt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ht,rt,nt.width,nt.height,0,nt.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,nt.width,nt.height,pt,O,nt.data):e.texImage2D(n.TEXTURE_2D,ht,rt,nt.width,nt.height,0,pt,O,nt.data)}else if(S.isDataArrayTexture)if(gt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,jt,rt,st.width,st.height,st.depth),Ht)if(S.layerUpdates.size>0){let ht=ef(st.width,st.height,S.format,S.type);for(let Ot of S.layerUpdates){let Qt=st.data.subarray(Ot*ht/st.data.BYTES_PER_ELEMENT,(Ot+1)*ht/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ot,st.width,st.height,1,pt,O,Qt)}S.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,pt,O,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,pt,O,st.data);else if(S.isData3DTexture)gt?(bt&&e.texStorage3D(n.TEXTURE_3D,jt,rt,st.width,st.height,st.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,pt,O,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,pt,O,st.data);else if(S.isFramebufferTexture){if(bt)if(gt)e.texStorage2D(n.TEXTURE_2D,jt,rt,st.width,st.height);else{let ht=st.width,Ot=st.height;for(let Qt=0;Qt<jt;Qt++)e.texImage2D(n.TEXTURE_2D,Qt,rt,ht,Ot,0,pt,O,null),ht>>=1,Ot>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ht=n.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),st.parentNode!==ht){ht.appendChild(st),u.add(S),ht.onpaint=Ot=>{let Qt=Ot.changedElements;for(let Ct of u)Qt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ht.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let Qt=n.RGBA,Ct=n.RGBA,le=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Qt,Ct,le,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Mt.length>0){if(gt&&bt){let ht=$t(Mt[0]);e.texStorage2D(n.TEXTURE_2D,jt,rt,ht.width,ht.height)}for(let ht=0,Ot=Mt.length;ht<Ot;ht++)nt=Mt[ht],gt?Ht&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,pt,O,nt):e.texImage2D(n.TEXTURE_2D,ht,rt,pt,O,nt);S.generateMipmaps=!1}else if(gt){if(bt){let ht=$t(st);e.texStorage2D(n.TEXTURE_2D,jt,rt,ht.width,ht.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,O,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,pt,O,st);R(S)&&S.mipmapsAutoUpdate===!0&&b(ct),yt.__version=_t.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function ui(P,S,$){if(S.image.length!==6)return;let ct=he(P,S),ot=S.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+$);let _t=i.get(ot);if(ot.version!==_t.__version||ct===!0){e.activeTexture(n.TEXTURE0+$);let yt=ye.getPrimaries(ye.workingColorSpace),it=S.colorSpace===Ms?null:ye.getPrimaries(S.colorSpace),st=S.colorSpace===Ms||yt===it?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let pt=S.isCompressedTexture||S.image[0].isCompressedTexture,O=S.image[0]&&S.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!pt&&!O?rt[Ct]=v(S.image[Ct],!0,s.maxCubemapSize):rt[Ct]=O?S.image[Ct].image:S.image[Ct],rt[Ct]=zt(S,rt[Ct]);let nt=rt[0],Mt=r.convert(S.format,S.colorSpace),gt=r.convert(S.type),bt=E(S.internalFormat,Mt,gt,S.normalized,S.colorSpace),Ht=S.isVideoTexture!==!0,jt=_t.__version===void 0||ct===!0,ht=ot.dataReady,Ot=T(S,nt);de(n.TEXTURE_CUBE_MAP,S);let Qt;if(S.isDepthTexture){if(bt=y(S.format===Ss,S.type),jt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,Mt,gt,null)}else if(pt){Ht&&jt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Qt=rt[Ct].mipmaps;for(let le=0;le<Qt.length;le++){let Xe=Qt[le];S.format!==Bn?Mt!==null?Ht?ht&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,Xe.width,Xe.height,Mt,Xe.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,Xe.width,Xe.height,0,Xe.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,0,0,Xe.width,Xe.height,Mt,gt,Xe.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le,bt,Xe.width,Xe.height,0,Mt,gt,Xe.data)}}}else{if(Qt=S.mipmaps,Ht&&jt){Qt.length>0&&Ot++;let Ct=$t(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ot,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(O){Ht?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,Mt,gt,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,Mt,gt,rt[Ct].data);for(let le=0;le<Qt.length;le++){let Wi=Qt[le].image[Ct].image;Ht?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,Wi.width,Wi.height,Mt,gt,Wi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,Wi.width,Wi.height,0,Mt,gt,Wi.data)}}else{Ht?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,Mt,gt,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,Mt,gt,rt[Ct]);for(let le=0;le<Qt.length;le++){let Xe=Qt[le];Ht?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,0,0,Mt,gt,Xe.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,le+1,bt,Mt,gt,Xe.image[Ct])}}}R(S)&&S.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),_t.__version=ot.version,S.onUpdate&&S.onUpdate(S)}P.__version=S.version}function ke(P,S,$,ct,ot,_t){let yt=r.convert($.format,$.colorSpace),it=r.convert($.type),st=E($.internalFormat,yt,it,$.normalized,$.colorSpace),pt=i.get(S),O=i.get($);if(O.__renderTarget=S,!pt.__hasExternalTextures){let rt=Math.max(1,S.width>>_t),nt=Math.max(1,S.height>>_t);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,_t,st,rt,nt,S.depth,0,yt,it,null):e.texImage2D(ot,_t,st,rt,nt,0,yt,it,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),St(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ct,ot,O.__webglTexture,0,ae(S)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ct,ot,O.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ei(P,S,$){if(n.bindRenderbuffer(n.RENDERBUFFER,P),S.depthBuffer){let ct=S.depthTexture,ot=ct&&ct.isDepthTexture?ct.type:null,_t=y(S.stencilBuffer,ot),yt=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;St(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ae(S),_t,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ae(S),_t,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,_t,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,P)}else{let ct=S.textures;for(let ot=0;ot<ct.length;ot++){let _t=ct[ot],yt=r.convert(_t.format,_t.colorSpace),it=r.convert(_t.type),st=E(_t.internalFormat,yt,it,_t.normalized,_t.colorSpace);St(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ae(S),st,S.width,S.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,ae(S),st,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,st,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function be(P,S,$){let ct=S.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(S.depthTexture);ot.__renderTarget=S;let _t=ct?S.depthTexture.image[0]:S.depthTexture.image;(!ot.__webglTexture||_t.width!==S.width||_t.height!==S.height)&&(_t.width=S.width,_t.height=S.height,S.depthTexture.needsUpdate=!0),ct?wt(S.depthTexture,0):mt(S.depthTexture,0);let yt=ot.__webglTexture,it=ae(S),st=ct?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,pt=S.depthTexture.format===Ss?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===xs)St(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,st,yt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,pt,st,yt,0);else if(S.depthTexture.format===Ss)St(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,st,yt,0,it):n.framebufferTexture2D(n.FRAMEBUFFER,pt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function vi(P){let S=i.get(P),$=P.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==P.depthTexture){let ct=P.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ct){let ot=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ct.removeEventListener("dispose",ot)};ct.addEventListener("dispose",ot),S.__depthDisposeCallback=ot}S.__boundDepthTexture=ct}if(P.depthTexture&&!S.__autoAllocateDepthBuffer)if($)for(let ct=0;ct<6;ct++)be(S.__webglFramebuffer[ct],P,ct);else P.texture.mipmaps.length>0?be(S.__webglFramebuffer[0],P,0):be(S.__webglFramebuffer,P,0);else if($){S.__webglDepthbuffer=[];for(let ct=0;ct<6;ct++)if(e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ct]),S.__webglDepthbuffer[ct]===void 0)S.__webglDepthbuffer[ct]=n.createRenderbuffer(),Ei(S.__webglDepthbuffer[ct],P,!1);else{let ot=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer[ct];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}}else if(P.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Ei(S.__webglDepthbuffer,P,!1);else{let ot=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function ni(P,S,$){let ct=i.get(P);S!==void 0&&ke(ct.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&vi(P)}function di(P){let S=P.texture,$=i.get(P),ct=i.get(S);P.addEventListener("dispose",z),U(P);let ot=P.textures,_t=P.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ct.__webglTexture===void 0&&(ct.__webglTexture=n.createTexture()),ct.__version=S.version,o.memory.textures++),_t){$.__webglFramebuffer=[];for(let it=0;it<6;it++)if(S.mipmaps.length>0){$.__webglFramebuffer[it]=[];for(let st=0;st<S.mipmaps.length;st++)$.__webglFramebuffer[it][st]=n.createFramebuffer()}else $.__webglFramebuffer[it]=n.createFramebuffer()}else{if(S.mipmaps.length>0){$.__webglFramebuffer=[];for(let it=0;it<S.mipmaps.length;it++)$.__webglFramebuffer[it]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(yt)for(let it=0,st=ot.length;it<st;it++){let pt=i.get(ot[it]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&St(P)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let it=0;it<ot.length;it++){let st=ot[it];$.__webglColorRenderbuffer[it]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[it]);let pt=r.convert(st.format,st.colorSpace),O=r.convert(st.type),rt=E(st.internalFormat,pt,O,st.normalized,st.colorSpace,P.isXRRenderTarget===!0),nt=ae(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+it,n.RENDERBUFFER,$.__webglColorRenderbuffer[it])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Ei($.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ct.__webglTexture),de(n.TEXTURE_CUBE_MAP,S);for(let it=0;it<6;it++)if(S.mipmaps.length>0)for(let st=0;st<S.mipmaps.length;st++)ke($.__webglFramebuffer[it][st],P,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,st);else ke($.__webglFramebuffer[it],P,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+it,0);R(S)?b(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let it=0,st=ot.length;it<st;it++){let pt=ot[it],O=i.get(pt),rt=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(rt=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,O.__webglTexture),de(rt,pt),ke($.__webglFramebuffer,P,pt,n.COLOR_ATTACHMENT0+it,rt,0),R(pt)&&b(rt)}e.unbindTexture()}else{let it=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(it=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(it,ct.__webglTexture),de(it,S),S.mipmaps.length>0)for(let st=0;st<S.mipmaps.length;st++)ke($.__webglFramebuffer[st],P,S,n.COLOR_ATTACHMENT0,it,st);else ke($.__webglFramebuffer,P,S,n.COLOR_ATTACHMENT0,it,0);R(S)?b(it):S.mipmaps.length>0&&n.texParameteri(it,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),e.unbindTexture()}P.depthBuffer&&vi(P)}function k(P){let S=P.textures;for(let $=0,ct=S.length;$<ct;$++){let ot=S[$];if(R(ot)&&ot.mipmapsAutoUpdate===!0){let _t=C(P),yt=i.get(ot).__webglTexture;e.bindTexture(_t,yt),b(_t),e.unbindTexture()}}}let Rt=[];function Zt(P){if(P.samples>0){if(St(P)===!1){let S=P.textures,$=P.width,ct=P.height,ot=n.COLOR_BUFFER_BIT,_t=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(P),it=S.length>1;if(it)for(let pt=0;pt<S.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let pt=0;pt<S.length;pt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),it){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[pt]);let O=i.get(S[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,$,ct,0,0,$,ct,ot,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+pt),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Rt.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),it)for(let pt=0;pt<S.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[pt]);let O=i.get(S[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,O,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let S=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ae(P){return Math.min(s.maxSamples,P.samples)}function St(P){let S=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function ze(P){let S=o.render.frame;c.get(P)!==S&&(c.set(P,S),P.update())}function zt(P,S){let $=P.colorSpace,ct=P.format,ot=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||$!==aa&&$!==Ms&&(ye.getTransfer($)===Le?(ct!==Bn||ot!==tn)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):te("WebGLTextures: Unsupported texture color space:",$)),S}function $t(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(h.width=P.naturalWidth||P.width,h.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(h.width=P.displayWidth,h.height=P.displayHeight):(h.width=P.width,h.height=P.height),h}this.allocateTextureUnit=ut,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=dt,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=Et,this.setTextureCube=wt,this.rebindTextures=ni,this.setupRenderTarget=di,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Zt,this.setupDepthRenderbuffer=vi,this.setupFrameBufferTexture=ke,this.useMultisampledRTT=St,this.dispose=W}function yM(n,t){function e(i,s=Ms){let r,o=ye.getTransfer(s);if(i===tn)return n.UNSIGNED_BYTE;if(i===Eh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ch)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ud)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Od)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Nd)return n.BYTE;if(i===Fd)return n.SHORT;if(i===xo)return n.UNSIGNED_SHORT;if(i===Th)return n.INT;if(i===Un)return n.UNSIGNED_INT;if(i===On)return n.FLOAT;if(i===kn)return n.HALF_FLOAT;if(i===kd)return n.ALPHA;if(i===Bd)return n.RGB;if(i===Bn)return n.RGBA;if(i===xs)return n.DEPTH_COMPONENT;if(i===Ss)return n.DEPTH_STENCIL;if(i===zd)return n.RED;if(i===Rh)return n.RED_INTEGER;if(i===Ks)return n.RG;if(i===Ph)return n.RG_INTEGER;if(i===Ih)return n.RGBA_INTEGER;if(i===Fa||i===Ua||i===Oa||i===ka)if(o===Le)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Fa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Fa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ua)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Oa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ka)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Lh||i===Dh||i===Nh||i===Fh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Lh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Dh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Nh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Fh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Uh||i===Oh||i===kh||i===Bh||i===zh||i===Ba||i===Gh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Uh||i===Oh)return o===Le?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===kh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Bh)return r.COMPRESSED_R11_EAC;if(i===zh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ba)return r.COMPRESSED_RG11_EAC;if(i===Gh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Vh||i===Hh||i===Wh||i===Xh||i===$h||i===qh||i===Yh||i===Zh||i===Kh||i===Jh||i===jh||i===Qh||i===tc||i===ec)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Vh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Hh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Wh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Xh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===$h)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===qh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Yh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Zh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Kh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Jh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===jh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Qh)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===tc)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===ec)return o===Le?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ic||i===nc||i===sc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===ic)return o===Le?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===nc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===sc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===rc||i===oc||i===za||i===ac)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===rc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===oc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===za)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ac)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===xr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var vM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,bM=`
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

}`,uf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new xa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new es({vertexShader:vM,fragmentShader:bM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ae(new ba(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},df=class extends Nn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,h=null,c=null,u=null,d=null,f=null,_=null,w=typeof XRWebGLBinding<"u",m=new uf,p={},v=e.getContextAttributes(),R=null,b=null,C=[],E=[],y=new Yt,T=null,U=null,L=new Zi;L.viewport=new Qe;let D=new Zi;D.viewport=new Qe;let z=[L,D],V=new bh,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let mt=C[tt];return mt===void 0&&(mt=new lo,C[tt]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(tt){let mt=C[tt];return mt===void 0&&(mt=new lo,C[tt]=mt),mt.getGripSpace()},this.getHand=function(tt){let mt=C[tt];return mt===void 0&&(mt=new lo,C[tt]=mt),mt.getHandSpace()};function q(tt){let mt=E.indexOf(tt.inputSource);if(mt===-1)return;let xt=C[mt];xt!==void 0&&(xt.update(tt.inputSource,tt.frame,h||o),xt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<C.length;tt++){let mt=E[tt];mt!==null&&(E[tt]=null,C[tt].disconnect(mt))}N=null,W=null,m.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(R),f=null,d=null,u=null,s=null,b=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(y.width,y.height,!1),U!==null){let tt=U.camera;tt.fov=U.fov,tt.zoom=U.zoom,tt.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return h||o},this.setReferenceSpace=function(tt){h=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&w&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(R=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",lt),v.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(y),w&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Et=null,wt=null;v.depth&&(wt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=v.stencil?Ss:xs,Et=v.stencil?xr:Un);let Wt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Wt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),b=new dn(d.textureWidth,d.textureHeight,{format:Bn,type:tn,depthTexture:new bs(d.textureWidth,d.textureHeight,Et,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new dn(f.framebufferWidth,f.framebufferHeight,{format:Bn,type:tn,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),h=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function lt(tt){for(let mt=0;mt<tt.removed.length;mt++){let xt=tt.removed[mt],Et=E.indexOf(xt);Et>=0&&(E[Et]=null,C[Et].disconnect(xt))}for(let mt=0;mt<tt.added.length;mt++){let xt=tt.added[mt],Et=E.indexOf(xt);if(Et===-1){for(let Wt=0;Wt<C.length;Wt++)if(Wt>=E.length){E.push(xt),Et=Wt;break}else if(E[Wt]===null){E[Wt]=xt,Et=Wt;break}if(Et===-1)break}let wt=C[Et];wt&&wt.connect(xt)}}function Z(tt,mt){mt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(mt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let mt=tt.near,xt=tt.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),V.near=D.near=L.near=mt,V.far=D.far=L.far=xt,(N!==V.near||W!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,W=V.far),V.layers.mask=tt.layers.mask|6,L.layers.mask=V.layers.mask&-5,D.layers.mask=V.layers.mask&-3;let Et=tt.parent,wt=V.cameras;Z(V,Et);for(let Wt=0;Wt<wt.length;Wt++)Z(wt[Wt],Et);V.projectionMatrix.copy(L.projectionMatrix),V.projectionMatrixInverse.copy(L.projectionMatrixInverse),U===null&&tt.isPerspectiveCamera&&(U={camera:tt,fov:tt.fov,zoom:tt.zoom}),j(tt,V,Et)};function j(tt,mt,xt){xt===null?tt.matrix.copy(mt.matrixWorld):(tt.matrix.copy(xt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(mt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(mt.projectionMatrix),tt.projectionMatrixInverse.copy(mt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=ro*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(tt){return p[tt]};let et=null;function dt(tt,mt){if(c=mt.getViewerPose(h||o),_=mt,c!==null){let xt=c.views;f!==null&&(t.setRenderTargetFramebuffer(b,f.framebuffer),t.setRenderTarget(b));let Et=!1;xt.length!==V.cameras.length&&(V.cameras.length=0,Et=!0);for(let Vt=0;Vt<xt.length;Vt++){let de=xt[Vt],he=null;if(f!==null)he=f.getViewport(de);else{let Je=u.getViewSubImage(d,de);he=Je.viewport,Vt===0&&(t.setRenderTargetTextures(b,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(b))}let se=z[Vt];se===void 0&&(se=new Zi,se.layers.enable(Vt),se.viewport=new Qe,z[Vt]=se),se.matrix.fromArray(de.transform.matrix),se.matrix.decompose(se.position,se.quaternion,se.scale),se.projectionMatrix.fromArray(de.projectionMatrix),se.projectionMatrixInverse.copy(se.projectionMatrix).invert(),se.viewport.set(he.x,he.y,he.width,he.height),Vt===0&&(V.matrix.copy(se.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Et===!0&&V.cameras.push(se)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&w){u=i.getBinding();let Vt=u.getDepthInformation(xt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(wt&&wt.includes("camera-access")&&w){t.state.unbindTexture(),u=i.getBinding();for(let Vt=0;Vt<xt.length;Vt++){let de=xt[Vt].camera;if(de){let he=p[de];he||(he=new xa,p[de]=he);let se=u.getCameraImage(de);he.sourceTexture=se}}}}for(let xt=0;xt<C.length;xt++){let Et=E[xt],wt=C[xt];Et!==null&&wt!==void 0&&wt.update(Et,mt,h||o)}et&&et(tt,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),_=null}let ut=new Lg;ut.setAnimationLoop(dt),this.setAnimationLoop=function(tt){et=tt},this.dispose=function(){}}},wM=new Ce,Vg=new ne;Vg.set(-1,0,0,0,1,0,0,0,1);function SM(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,jd(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,R,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),u(m,p)):p.isMeshPhongMaterial?(r(m,p),c(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,b)):p.isMeshMatcapMaterial?(r(m,p),_(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),w(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,v,R):p.isSpriteMaterial?h(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Ji&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Ji&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=t.get(p),R=v.envMap,b=v.envMapRotation;R&&(m.envMap.value=R,m.envMapRotation.value.setFromMatrix4(wM.makeRotationFromEuler(b)).transpose(),R.isCubeTexture&&R.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Vg),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,v,R){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=R*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function u(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Ji&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,p){p.matcap&&(m.matcap.value=p.matcap)}function w(m,p){let v=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function MM(n,t,e,i){let s={},r={};function o(v,R){let b=R.program;i.uniformBlockBinding(v,b,s[v.id])}function a(v,R){let b=s[v.id];b===void 0&&(_(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let C=R.program;i.updateUBOMapping(v,C);let E=t.render.frame;r[v.id]!==E&&(h(v),r[v.id]=E)}function l(v){let R=n.createBuffer(),b=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,R),n.bufferData(n.UNIFORM_BUFFER,b,C),n.bindBuffer(n.UNIFORM_BUFFER,null),R}function h(v){let R=s[v.id],b=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,R);for(let E=0,y=b.length;E<y;E++){let T=b[E];if(Array.isArray(T))for(let U=0,L=T.length;U<L;U++)c(T[U],E,U,C);else c(T,E,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function c(v,R,b,C){if(d(v,R,b,C)===!0){let E=v.__offset,y=v.value;if(Array.isArray(y)){let T=0;for(let U=0;U<y.length;U++){let L=y[U],D=w(L,!0);u(L,v.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,v.__data)}}function u(v,R,b){typeof v=="number"||typeof v=="boolean"?R[b]=v:v.isMatrix3?(R[b]=v.elements[0],R[b+1]=v.elements[1],R[b+2]=v.elements[2],R[b+3]=0,R[b+4]=v.elements[3],R[b+5]=v.elements[4],R[b+6]=v.elements[5],R[b+7]=0,R[b+8]=v.elements[6],R[b+9]=v.elements[7],R[b+10]=v.elements[8],R[b+11]=0):ArrayBuffer.isView(v)?R.set(v.subarray(0,R.length-b),b):v.toArray(R,b)}function d(v,R,b,C){let E=v.value,y=R+"_"+b;if(Array.isArray(E)){C[y]===void 0&&(C[y]=[]);let T=C[y],U=!1;for(let L=0;L<E.length;L++)f(E[L],T,L)===!0&&(U=!0);return U}return f(E,C,y)}function f(v,R,b){if(R[b]===void 0)return typeof v=="number"||typeof v=="boolean"?R[b]=v:ArrayBuffer.isView(v)?R[b]=v.slice():R[b]=v.clone(),!0;{let C=R[b];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return R[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function _(v){let R=v.uniforms,b=0,C=16;for(let y=0,T=R.length;y<T;y++){let U=Array.isArray(R[y])?R[y]:[R[y]];for(let L=0,D=U.length;L<D;L++){let z=U[L],V=Array.isArray(z.value)?z.value:[z.value],N=Array.isArray(R[y])||Array.isArray(z.value),W=b;for(let H=0,lt=V.length;H<lt;H++){let Z=V[H],j=w(Z,N),et=b%C,dt=et%j.boundary,ut=et+dt;b+=dt,ut!==0&&C-ut<j.storage&&(b+=C-ut),H===0&&(W=b),b+=j.storage}let q=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new q((b-W)/Float32Array.BYTES_PER_ELEMENT),z.__offset=W}}let E=b%C;return E>0&&(b+=C-E),v.__size=b,v.__cache={},this}function w(v,R){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",v),R===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let R=v.target;R.removeEventListener("dispose",m),n.deleteBuffer(s[R.id]),delete s[R.id],delete r[R.id]}function p(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var AM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function TM(){return ns===null&&(ns=new nh(AM,16,16,Ks,kn),ns.name="DFG_LUT",ns.minFilter=Ki,ns.magFilter=Ki,ns.wrapS=Qn,ns.wrapT=Qn,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var Wa=class{constructor(t={}){let{canvas:e=eg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:h=!1,powerPreference:c="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=tn}=t;this.isWebGLRenderer=!0;let _;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");_=i.getContextAttributes().alpha}else _=o;let w=f,m=new Set([Ih,Ph,Rh]),p=new Set([tn,Un,xo,xr,Eh,Ch]),v=new Uint32Array(4),R=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,y=[],T=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=is,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,D=!1,z=null,V=null,N=null,W=null;this._outputColorSpace=cn;let q=0,H=0,lt=null,Z=-1,j=null,et=new Qe,dt=new Qe,ut=null,tt=new ie(0),mt=0,xt=e.width,Et=e.height,wt=1,Wt=null,oe=null,Vt=new Qe(0,0,xt,Et),de=new Qe(0,0,xt,Et),he=!1,se=new Gs,Je=new sh,He=!1,ui=!1,ke=new Ce,Ei=new B,be=new Qe,vi={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ni=!1;function di(){return lt===null?wt:1}let k=i;function Rt(A,G){return e.getContext(A,G)}let Zt,ae,St,ze,zt,$t,P,S,$,ct,ot,_t,yt,it,st,pt,O,rt,nt,Mt,gt,bt,Ht;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:h,powerPreference:c,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ot,!1),e.addEventListener("webglcontextrestored",Qt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let G="webgl2";if(k=Rt(G,A),k===null)throw Rt(G)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}jt()}catch(A){throw e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Qt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),te("WebGLRenderer: "+A.message),A}function jt(){Zt=new Ow(k),Zt.init(),gt=new yM(k,Zt),ae=new Tw(k,Zt,t,gt),St=new _M(k,Zt),ae.reversedDepthBuffer&&d&&St.buffers.depth.setReversed(!0),V=k.createFramebuffer(),N=k.createFramebuffer(),W=k.createFramebuffer(),ze=new zw(k),zt=new nM,$t=new xM(k,Zt,St,zt,ae,gt,ze),P=new Uw(L),S=new Vy(k),bt=new Mw(k,S),$=new kw(k,S,ze,bt),ct=new Vw(k,$,S,bt,ze),rt=new Gw(k,ae,$t),st=new Ew(zt),ot=new iM(L,P,Zt,ae,bt,st),_t=new SM(L,zt),yt=new rM,it=new uM(Zt),O=new Sw(L,P,St,ct,_,l),pt=new gM(L,ct,ae),Ht=new MM(k,ze,ae,St),nt=new Aw(k,Zt,ze),Mt=new Bw(k,Zt,ze),ze.programs=ot.programs,L.capabilities=ae,L.extensions=Zt,L.properties=zt,L.renderLists=yt,L.shadowMap=pt,L.state=St,L.info=ze}w!==tn&&(U=new Ww(w,e.width,e.height,a,s,r));let ht=new df(L,k);this.xr=ht,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let A=Zt.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Zt.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(A){A!==void 0&&(wt=A,this.setSize(xt,Et,!1))},this.getSize=function(A){return A.set(xt,Et)},this.setSize=function(A,G,Q=!0){if(ht.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=A,Et=G,e.width=Math.floor(A*wt),e.height=Math.floor(G*wt),Q===!0&&(e.style.width=A+"px",e.style.height=G+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,A,G)},this.getDrawingBufferSize=function(A){return A.set(xt*wt,Et*wt).floor()},this.setDrawingBufferSize=function(A,G,Q){xt=A,Et=G,wt=Q,e.width=Math.floor(A*Q),e.height=Math.floor(G*Q),this.setViewport(0,0,A,G)},this.setEffects=function(A){if(w===tn){te("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let G=0;G<A.length;G++)if(A[G].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(et)},this.getViewport=function(A){return A.copy(Vt)},this.setViewport=function(A,G,Q,Y){A.isVector4?Vt.set(A.x,A.y,A.z,A.w):Vt.set(A,G,Q,Y),St.viewport(et.copy(Vt).multiplyScalar(di()).round())},this.getScissor=function(A){return A.copy(de)},this.setScissor=function(A,G,Q,Y){A.isVector4?de.set(A.x,A.y,A.z,A.w):de.set(A,G,Q,Y),St.scissor(dt.copy(de).multiplyScalar(di()).round())},this.getScissorTest=function(){return he},this.setScissorTest=function(A){St.setScissorTest(he=A)},this.setOpaqueSort=function(A){Wt=A},this.setTransparentSort=function(A){oe=A},this.getClearColor=function(A){return A.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(A=!0,G=!0,Q=!0){let Y=0;if(A){let K=!1;if(lt!==null){let At=lt.texture.format;K=m.has(At)}if(K){let At=lt.texture.type,Pt=p.has(At),Tt=O.getClearColor(),It=O.getClearAlpha(),Bt=Tt.r,ee=Tt.g,fe=Tt.b;Pt?(v[0]=Bt,v[1]=ee,v[2]=fe,v[3]=It,k.clearBufferuiv(k.COLOR,0,v)):(R[0]=Bt,R[1]=ee,R[2]=fe,R[3]=It,k.clearBufferiv(k.COLOR,0,R))}else Y|=k.COLOR_BUFFER_BIT}G&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),z=A},this.dispose=function(){e.removeEventListener("webglcontextlost",Ot,!1),e.removeEventListener("webglcontextrestored",Qt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),O.dispose(),yt.dispose(),it.dispose(),$t.dispose(),zt.dispose(),P.dispose(),ct.dispose(),$.dispose(),bt.dispose(),Ht.dispose(),ot.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",il),ht.removeEventListener("sessionend",Xn),os.stop()};function Ot(A){A.preventDefault(),Yd("WebGLRenderer: Context Lost."),D=!0}function Qt(){Yd("WebGLRenderer: Context Restored."),D=!1;let A=ze.autoReset,G=pt.enabled,Q=pt.autoUpdate,Y=pt.needsUpdate,K=pt.type;jt(),ze.autoReset=A,pt.enabled=G,pt.autoUpdate=Q,pt.needsUpdate=Y,pt.type=K}function Ct(A){te("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function le(A){let G=A.target;G.removeEventListener("dispose",le),Xe(G)}function Xe(A){Wi(A),zt.remove(A)}function Wi(A){let G=zt.get(A).programs;G!==void 0&&(G.forEach(function(Q){ot.releaseProgram(Q)}),A.isShaderMaterial&&ot.releaseShaderCache(A))}this.renderBufferDirect=function(A,G,Q,Y,K,At){G===null&&(G=vi);let Pt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Tt=Xo(A,G,Q,Y,K);St.setMaterial(Y,Pt);let It=Q.index,Bt=1;if(Y.wireframe===!0){if(It=$.getWireframeAttribute(Q),It===void 0)return;Bt=2}let ee=Q.drawRange,fe=Q.attributes.position,kt=ee.start*Bt,pe=(ee.start+ee.count)*Bt;At!==null&&(kt=Math.max(kt,At.start*Bt),pe=Math.min(pe,(At.start+At.count)*Bt)),It!==null?(kt=Math.max(kt,0),pe=Math.min(pe,It.count)):fe!=null&&(kt=Math.max(kt,0),pe=Math.min(pe,fe.count));let ei=pe-kt;if(ei<0||ei===1/0)return;bt.setup(K,Y,Tt,Q,It);let Ne,Fe=nt;if(It!==null&&(Ne=S.get(It),Fe=Mt,Fe.setIndex(Ne)),K.isMesh)Y.wireframe===!0?(St.setLineWidth(Y.wireframeLinewidth*di()),Fe.setMode(k.LINES)):Fe.setMode(k.TRIANGLES);else if(K.isLine){let bi=Y.linewidth;bi===void 0&&(bi=1),St.setLineWidth(bi*di()),K.isLineSegments?Fe.setMode(k.LINES):K.isLineLoop?Fe.setMode(k.LINE_LOOP):Fe.setMode(k.LINE_STRIP)}else K.isPoints?Fe.setMode(k.POINTS):K.isSprite&&Fe.setMode(k.TRIANGLES);if(K.isBatchedMesh)if(Zt.get("WEBGL_multi_draw"))Fe.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let bi=K._multiDrawStarts,Ft=K._multiDrawCounts,fi=K._multiDrawCount,xe=It?S.get(It).bytesPerElement:1,ls=zt.get(Y).currentProgram.getUniforms();for(let pi=0;pi<fi;pi++)ls.setValue(k,"_gl_DrawID",pi),Fe.render(bi[pi]/xe,Ft[pi])}else if(K.isInstancedMesh)Fe.renderInstances(kt,ei,K.count);else if(Q.isInstancedBufferGeometry){let bi=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ft=Math.min(Q.instanceCount,bi);Fe.renderInstances(kt,ei,Ft)}else Fe.render(kt,ei)};function Vo(A,G,Q,Y){z!==null&&A.isNodeMaterial&&z.setObject(Y,A),He===!0&&st.setState(A,Q,!1),A.transparent===!0&&A.side===Mn&&A.forceSinglePass===!1?(A.side=Ji,A.needsUpdate=!0,$n(A,G,Y),A.side=Zs,A.needsUpdate=!0,$n(A,G,Y),A.side=Mn):$n(A,G,Y)}this.compile=function(A,G,Q=null){Q===null&&(Q=A),z!==null&&z.renderStart(A,G,Q),E=it.get(Q),E.init(G),T.push(E),Q.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),A!==Q&&A.traverseVisible(function(K){K.isLight&&K.layers.test(G.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),E.setupLights(),z!==null&&z.updateLights(E.state.lightsArray),ui=this.localClippingEnabled,He=st.init(this.clippingPlanes,ui),He===!0&&st.setGlobalState(this.clippingPlanes,G),z!==null&&pt.render(E.state.shadowsArray,Q,G);let Y=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let At=K.material;if(At)if(Array.isArray(At))for(let Pt=0;Pt<At.length;Pt++){let Tt=At[Pt];Vo(Tt,Q,G,K),Y.add(Tt)}else Vo(At,Q,G,K),Y.add(At)}),E=T.pop(),z!==null&&z.renderEnd(),Y},this.compileAsync=function(A,G,Q=null){let Y=this.compile(A,G,Q);return new Promise(K=>{function At(){if(Y.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Y.delete(Pt)}),Y.size===0){K(A);return}setTimeout(At,10)}Zt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let Rr=null;function Iu(A){Rr&&Rr(A)}function il(){os.stop()}function Xn(){os.start()}let os=new Lg;os.setAnimationLoop(Iu),typeof self<"u"&&os.setContext(self),this.setAnimationLoop=function(A){Rr=A,ht.setAnimationLoop(A),A===null?os.stop():os.start()},ht.addEventListener("sessionstart",il),ht.addEventListener("sessionend",Xn),this.render=function(A,G){if(G!==void 0&&G.isCamera!==!0){te("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(A,G);let Q=ht.enabled===!0&&ht.isPresenting===!0,Y=U!==null&&(lt===null||Q)&&U.begin(L,lt);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),G.parent===null&&G.matrixWorldAutoUpdate===!0&&G.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(G),G=ht.getCamera()),A.isScene===!0&&A.onBeforeRender(L,A,G,lt),E=it.get(A,T.length),E.init(G),E.state.textureUnits=$t.getTextureUnits(),T.push(E),ke.multiplyMatrices(G.projectionMatrix,G.matrixWorldInverse),G.isArrayCamera?Je.setFromArrayCamera(G):se.setFromProjectionMatrix(ke,wn,G.reversedDepth),ui=this.localClippingEnabled,He=st.init(this.clippingPlanes,ui),C=yt.get(A,y.length),C.init(),y.push(C),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Pt=L.xr.getDepthSensingMesh();Pt!==null&&as(Pt,G,-1/0,L.sortObjects)}as(A,G,0,L.sortObjects),C.finish(),z!==null&&z.updateLights(E.state.lightsArray),L.sortObjects===!0&&C.sort(Wt,oe),ni=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,ni&&O.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),He===!0&&st.beginShadows();let K=E.state.shadowsArray;if(pt.render(K,A,G),He===!0&&st.endShadows(),(Y&&U.hasRenderPass())===!1){let Pt=C.opaque,Tt=C.transmissive;if(E.setupLights(),G.isArrayCamera){let It=G.cameras;if(Tt.length>0)for(let Bt=0,ee=It.length;Bt<ee;Bt++){let fe=It[Bt];Cn(Pt,Tt,A,fe)}ni&&O.render(A);for(let Bt=0,ee=It.length;Bt<ee;Bt++){let fe=It[Bt];Ho(C,A,fe,fe.viewport)}}else Tt.length>0&&Cn(Pt,Tt,A,G),ni&&O.render(A),Ho(C,A,G)}lt!==null&&H===0&&($t.updateMultisampleRenderTarget(lt),$t.updateRenderTargetMipmap(lt)),Y&&U.end(L),A.isScene===!0&&A.onAfterRender(L,A,G),bt.resetDefaultState(),Z=-1,j=null,T.pop(),T.length>0?(E=T[T.length-1],$t.setTextureUnits(E.state.textureUnits),He===!0&&st.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,z!==null&&z.renderEnd()};function as(A,G,Q,Y){if(A.visible===!1)return;if(A.layers.test(G.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(G);else if(A.isLight)E.pushLight(A),A.castShadow&&E.pushShadow(A);else if(A.isSprite){let Pt=G.isArrayCamera?Je:se;if(!A.frustumCulled||A.intersectsFrustum(Pt)){Y&&be.setFromMatrixPosition(A.matrixWorld).applyMatrix4(ke);let Tt=ct.update(A),It=A.material;It.visible&&C.push(A,Tt,It,Q,be.z,null,G)}}else if(A.isMesh||A.isLine||A.isPoints){let Pt=G.isArrayCamera?Je:se;if(!A.frustumCulled||A.intersectsFrustum(Pt)){let Tt=ct.update(A),It=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),be.copy(A.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),be.copy(Tt.boundingSphere.center)),be.applyMatrix4(A.matrixWorld).applyMatrix4(ke)),Array.isArray(It)){let Bt=Tt.groups;for(let ee=0,fe=Bt.length;ee<fe;ee++){let kt=Bt[ee],pe=It[kt.materialIndex];pe&&pe.visible&&C.push(A,Tt,pe,Q,be.z,kt,G)}}else It.visible&&C.push(A,Tt,It,Q,be.z,null,G)}}}let At=A.children;for(let Pt=0,Tt=At.length;Pt<Tt;Pt++)as(At[Pt],G,Q,Y)}function Ho(A,G,Q,Y){let{opaque:K,transmissive:At,transparent:Pt}=A;E.setupLightsView(Q),He===!0&&st.setGlobalState(L.clippingPlanes,Q),Y&&St.viewport(et.copy(Y)),K.length>0&&si(K,G,Q),At.length>0&&si(At,G,Q),Pt.length>0&&si(Pt,G,Q),St.buffers.depth.setTest(!0),St.buffers.depth.setMask(!0),St.buffers.color.setMask(!0),St.setPolygonOffset(!1)}function Cn(A,G,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let kt=Zt.has("EXT_color_buffer_half_float")||Zt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new dn(1,1,{generateMipmaps:!0,type:kt?kn:tn,minFilter:ws,samples:Math.max(4,ae.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ye.workingColorSpace})}let At=E.state.transmissionRenderTarget[Y.id],Pt=Y.viewport||et;At.setSize(Pt.z*L.transmissionResolutionScale,Pt.w*L.transmissionResolutionScale);let Tt=L.getRenderTarget(),It=L.getActiveCubeFace(),Bt=L.getActiveMipmapLevel();L.setRenderTarget(At),L.getClearColor(tt),mt=L.getClearAlpha(),mt<1&&L.setClearColor(16777215,.5),L.clear(),ni&&O.render(Q);let ee=L.toneMapping;L.toneMapping=is;let fe=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),He===!0&&st.setGlobalState(L.clippingPlanes,Y),si(A,Q,Y),$t.updateMultisampleRenderTarget(At),$t.updateRenderTargetMipmap(At),Zt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let pe=0,ei=G.length;pe<ei;pe++){let Ne=G[pe],{object:Fe,geometry:bi,material:Ft,group:fi}=Ne;if(Ft.side===Mn&&Fe.layers.test(Y.layers)){let xe=Ft.side;Ft.side=Ji,Ft.needsUpdate=!0,hi(Fe,Q,Y,bi,Ft,fi),Ft.side=xe,Ft.needsUpdate=!0,kt=!0}}kt===!0&&($t.updateMultisampleRenderTarget(At),$t.updateRenderTargetMipmap(At))}L.setRenderTarget(Tt,It,Bt),L.setClearColor(tt,mt),fe!==void 0&&(Y.viewport=fe),L.toneMapping=ee}function si(A,G,Q){let Y=G.isScene===!0?G.overrideMaterial:null;for(let K=0,At=A.length;K<At;K++){let Pt=A[K],{object:Tt,geometry:It,group:Bt}=Pt,ee=Pt.material;ee.allowOverride===!0&&Y!==null&&(ee=Y),Tt.layers.test(Q.layers)&&hi(Tt,G,Q,It,ee,Bt)}}function hi(A,G,Q,Y,K,At){z!==null&&K.isNodeMaterial&&z.setObject(A,K),A.onBeforeRender(L,G,Q,Y,K,At),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(L,G,Q,Y,A,At),K.transparent===!0&&K.side===Mn&&K.forceSinglePass===!1?(K.side=Ji,K.needsUpdate=!0,L.renderBufferDirect(Q,G,Y,K,A,At),K.side=Zs,K.needsUpdate=!0,L.renderBufferDirect(Q,G,Y,K,A,At),K.side=Mn):L.renderBufferDirect(Q,G,Y,K,A,At),A.onAfterRender(L,G,Q,Y,K,At)}function ci(A){let G=0;for(let Q of A)Q.texture!==null&&G++;return G}function $n(A,G,Q){G.isScene!==!0&&(G=vi);let Y=zt.get(A),K=E.state.lights,At=E.state.shadowsArray,Pt=K.state.version,Tt=ot.getParameters(A,K.state,At,G,Q,E.state.lightProbeGridArray),It=ot.getProgramCacheKey(Tt),Bt=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?G.environment:null,Y.fog=G.fog;let ee=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=P.get(A.envMap||Y.environment,ee),Y.envMapRotation=Y.environment!==null&&A.envMap===null?G.environmentRotation:A.envMapRotation,Bt===void 0&&(A.addEventListener("dispose",le),Bt=new Map,Y.programs=Bt,Y.programVariants=new Map);let fe=Bt.get(It);if(fe!==void 0){if(Y.currentProgram===fe&&Y.lightsStateVersion===Pt)return Wo(A,Tt),fe}else Tt.uniforms=ot.getUniforms(A),z!==null&&A.isNodeMaterial&&z.build(A,Q,Tt),A.onBeforeCompile(Tt,L),fe=ot.acquireProgram(Tt,It),Bt.set(It,fe),Y.uniforms=Tt.uniforms;let kt=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(kt.clippingPlanes=st.uniform),Wo(A,Tt),Y.needsLights=Cs(A),Y.lightsStateVersion=Pt,Y.needsLights&&(kt.ambientLightColor.value=K.state.ambient,kt.lightProbe.value=K.state.probe,kt.sunLights.value=K.state.sun,kt.sunLightShadows.value=K.state.sunShadow,kt.directionalLights.value=K.state.directional,kt.directionalLightShadows.value=K.state.directionalShadow,kt.spotLights.value=K.state.spot,kt.spotLightShadows.value=K.state.spotShadow,kt.rectAreaLights.value=K.state.rectArea,kt.ltc_1.value=K.state.rectAreaLTC1,kt.ltc_2.value=K.state.rectAreaLTC2,kt.pointLights.value=K.state.point,kt.pointLightShadows.value=K.state.pointShadow,kt.hemisphereLights.value=K.state.hemi,kt.sunShadowMatrix.value=K.state.sunShadowMatrix,kt.sunShadowCascade.value=K.state.sunShadowCascade,kt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,kt.spotLightMatrix.value=K.state.spotLightMatrix,kt.spotLightMap.value=K.state.spotLightMap,kt.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=ci(E.state.lightProbeGridArray),Y.currentProgram=fe,Y.uniformsList=null,fe}function nn(A,G,Q,Y,K){let At=zt.get(A),Pt=At.currentProgram.id+","+Y+","+K,Tt=At.programVariants.get(Pt);return Tt===void 0?(Tt=$n(A,G,Q),At.programVariants.set(Pt,Tt)):(At.currentProgram=Tt,At.uniformsList=null,At.outputColorSpace=Y,At.toneMapping=K),Tt}function Es(A){if(A.uniformsList===null){let G=A.currentProgram.getUniforms();A.uniformsList=vo.seqWithValue(G.seq,A.uniforms)}return A.uniformsList}function Wo(A,G){let Q=zt.get(A);Q.outputColorSpace=G.outputColorSpace,Q.batching=G.batching,Q.batchingColor=G.batchingColor,Q.instancing=G.instancing,Q.instancingColor=G.instancingColor,Q.instancingMorph=G.instancingMorph,Q.skinning=G.skinning,Q.morphTargets=G.morphTargets,Q.morphNormals=G.morphNormals,Q.morphColors=G.morphColors,Q.morphTargetsCount=G.morphTargetsCount,Q.numClippingPlanes=G.numClippingPlanes,Q.numIntersection=G.numClipIntersection,Q.vertexAlphas=G.vertexAlphas,Q.vertexTangents=G.vertexTangents,Q.toneMapping=G.toneMapping}function Xo(A,G,Q,Y,K){G.isScene!==!0&&(G=vi),$t.resetTextureUnits();let At=G.fog,Pt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?G.environment:null,Tt=lt===null?L.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:ye.workingColorSpace,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Bt=P.get(Y.envMap||Pt,It),ee=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,fe=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),kt=!!Q.morphAttributes.position,pe=!!Q.morphAttributes.normal,ei=!!Q.morphAttributes.color,Ne=is;Y.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Ne=L.toneMapping);let Fe=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,bi=Fe!==void 0?Fe.length:0,Ft=zt.get(Y),fi=E.state.lights;if(He===!0&&(ui===!0||A!==j)){let Ue=A===j&&Y.id===Z;st.setState(Y,A,Ue)}let xe=!1,ls=!1;Y.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==fi.state.version||K.isBatchedMesh&&Ft.batching===!1||!K.isBatchedMesh&&Ft.batching===!0||K.isBatchedMesh&&Ft.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ft.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ft.instancing===!1||!K.isInstancedMesh&&Ft.instancing===!0||K.isSkinnedMesh&&Ft.skinning===!1||!K.isSkinnedMesh&&Ft.skinning===!0||K.isInstancedMesh&&Ft.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ft.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ft.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ft.instancingMorph===!1&&K.morphTexture!==null||Ft.envMap!==Bt||Y.fog===!0&&Ft.fog!==At||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==st.numPlanes||Ft.numIntersection!==st.numIntersection)||Ft.vertexAlphas!==ee||Ft.vertexTangents!==fe||Ft.morphTargets!==kt||Ft.morphNormals!==pe||Ft.morphColors!==ei||Ft.morphTargetsCount!==bi||Ft.numLightProbeGrids!==ci(E.state.lightProbeGridArray)?xe=!0:(Ft.outputColorSpace!==Tt||Ft.toneMapping!==Ne)&&(ls=!0):(xe=!0,Ft.__version=Y.version);let pi=Ft.currentProgram;(xe===!0||ls===!0)&&(pi=ls===!0?nn(Y,G,K,Tt,Ne):$n(Y,G,K),z&&Y.isNodeMaterial&&z.onUpdateProgram(Y,pi,Ft));let Lr=!1,qn=!1,hs=!1,ce=pi.getUniforms(),ri=Ft.uniforms;if(St.useProgram(pi.program)&&(Lr=!0,qn=!0,hs=!0),Y.id!==Z&&(Z=Y.id,qn=!0),Lr||j!==A){St.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ce.setValue(k,"projectionMatrix",A.projectionMatrix),ce.setValue(k,"viewMatrix",A.matrixWorldInverse);let mi=ce.map.cameraPosition;mi!==void 0&&mi.setValue(k,Ei.setFromMatrixPosition(A.matrixWorld)),ae.logarithmicDepthBuffer&&ce.setValue(k,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ce.setValue(k,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,qn=!0,hs=!0)}if(Ft.needsLights&&(fi.state.sunShadowMap.length>0&&ce.setValue(k,"sunShadowMap",fi.state.sunShadowMap,$t),fi.state.directionalShadowMap.length>0&&ce.setValue(k,"directionalShadowMap",fi.state.directionalShadowMap,$t),fi.state.spotShadowMap.length>0&&ce.setValue(k,"spotShadowMap",fi.state.spotShadowMap,$t),fi.state.pointShadowMap.length>0&&ce.setValue(k,"pointShadowMap",fi.state.pointShadowMap,$t)),K.isSkinnedMesh){ce.setOptional(k,K,"bindMatrix"),ce.setOptional(k,K,"bindMatrixInverse");let Ue=K.skeleton;Ue&&(Ue.boneTexture===null&&Ue.computeBoneTexture(),ce.setValue(k,"boneTexture",Ue.boneTexture,$t))}K.isBatchedMesh&&(ce.setOptional(k,K,"batchingTexture"),ce.setValue(k,"batchingTexture",K._matricesTexture,$t),ce.setOptional(k,K,"batchingIdTexture"),ce.setValue(k,"batchingIdTexture",K._indirectTexture,$t),ce.setOptional(k,K,"batchingColorTexture"),K._colorsTexture!==null&&ce.setValue(k,"batchingColorTexture",K._colorsTexture,$t));let Xi=Q.morphAttributes;if((Xi.position!==void 0||Xi.normal!==void 0||Xi.color!==void 0)&&rt.update(K,Q,pi),(qn||Ft.receiveShadow!==K.receiveShadow)&&(Ft.receiveShadow=K.receiveShadow,ce.setValue(k,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&G.environment!==null&&(ri.envMapIntensity.value=G.environmentIntensity),ri.dfgLUT!==void 0&&(ri.dfgLUT.value=TM()),qn){if(ce.setValue(k,"toneMappingExposure",L.toneMappingExposure),Ft.needsLights&&Pr(ri,hs),At&&Y.fog===!0&&_t.refreshFogUniforms(ri,At),_t.refreshMaterialUniforms(ri,Y,wt,Et,E.state.transmissionRenderTarget[A.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Ue=b,mi=0;for(let Bi of E.state.lightProbeGridArray)Bi.texture!==null&&(Ue.textures[mi]=Bi.texture,Ue.min[mi]=Bi.boundingBox.min,Ue.max[mi]=Bi.boundingBox.max,Ue.resolution[mi]=Bi.resolution,mi++);for(let Bi in Ue)Ue[Bi].length=mi;ri.probesSH.value=Ue.textures,ri.probesMin.value=Ue.min,ri.probesMax.value=Ue.max,ri.probesResolution.value=Ue.resolution}vo.upload(k,Es(Ft),ri,$t)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(vo.upload(k,Es(Ft),ri,$t),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ce.setValue(k,"center",K.center),ce.setValue(k,"modelViewMatrix",K.modelViewMatrix),ce.setValue(k,"normalMatrix",K.normalMatrix),ce.setValue(k,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Ue=Y.uniformsGroups;for(let mi=0,Bi=Ue.length;mi<Bi;mi++){let nl=Ue[mi];Ht.update(nl,pi),Ht.bind(nl,pi)}}return pi}function Pr(A,G){A.ambientLightColor.needsUpdate=G,A.lightProbe.needsUpdate=G,A.sunLights.needsUpdate=G,A.sunLightShadows.needsUpdate=G,A.directionalLights.needsUpdate=G,A.directionalLightShadows.needsUpdate=G,A.pointLights.needsUpdate=G,A.pointLightShadows.needsUpdate=G,A.spotLights.needsUpdate=G,A.spotLightShadows.needsUpdate=G,A.rectAreaLights.needsUpdate=G,A.hemisphereLights.needsUpdate=G}function Cs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(A,G,Q){let Y=zt.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),zt.get(A.texture).__webglTexture=G,zt.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,G){let Q=zt.get(A);Q.__webglFramebuffer=G,Q.__useDefaultFramebuffer=G===void 0},this.setRenderTarget=function(A,G=0,Q=0){lt=A,q=G,H=Q;let Y=null,K=!1,At=!1;if(A){let Tt=zt.get(A);if(Tt.__useDefaultFramebuffer!==void 0){St.bindFramebuffer(k.FRAMEBUFFER,Tt.__webglFramebuffer),et.copy(A.viewport),dt.copy(A.scissor),ut=A.scissorTest,St.viewport(et),St.scissor(dt),St.setScissorTest(ut),Z=-1;return}else if(Tt.__webglFramebuffer===void 0)$t.setupRenderTarget(A);else if(Tt.__hasExternalTextures)$t.rebindTextures(A,zt.get(A.texture).__webglTexture,zt.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let ee=A.depthTexture;if(Tt.__boundDepthTexture!==ee){if(ee!==null&&zt.has(ee)&&(A.width!==ee.image.width||A.height!==ee.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(A)}}let It=A.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(At=!0);let Bt=zt.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Bt[G])?Y=Bt[G][Q]:Y=Bt[G],K=!0):A.samples>0&&$t.useMultisampledRTT(A)===!1?Y=zt.get(A).__webglMultisampledFramebuffer:Array.isArray(Bt)?Y=Bt[Q]:Y=Bt,et.copy(A.viewport),dt.copy(A.scissor),ut=A.scissorTest}else et.copy(Vt).multiplyScalar(wt).floor(),dt.copy(de).multiplyScalar(wt).floor(),ut=he;if(Q!==0&&(Y=V),St.bindFramebuffer(k.FRAMEBUFFER,Y)&&St.drawBuffers(A,Y),St.viewport(et),St.scissor(dt),St.setScissorTest(ut),K){let Tt=zt.get(A.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+G,Tt.__webglTexture,Q)}else if(At){let Tt=G;for(let It=0;It<A.textures.length;It++){let Bt=zt.get(A.textures[It]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+It,Bt.__webglTexture,Q,Tt)}}else if(A!==null&&Q!==0){let Tt=zt.get(A.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Tt.__webglTexture,Q)}Z=-1};function Ir(A){let G=zt.get(A);return(G.__readFormat!==A.format||G.__readType!==A.type)&&(G.__readFormat=A.format,G.__readType=A.type,G.__formatReadable=ae.textureFormatReadable(A.format),G.__typeReadable=ae.textureTypeReadable(A.type)),G}this.readRenderTargetPixels=function(A,G,Q,Y,K,At,Pt,Tt=0){if(!(A&&A.isWebGLRenderTarget)){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){St.bindFramebuffer(k.FRAMEBUFFER,It);try{let Bt=A.textures[Tt],ee=Bt.format,fe=Bt.type;A.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let kt=Ir(Bt);if(kt.__formatReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){te("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}G>=0&&G<=A.width-Y&&Q>=0&&Q<=A.height-K&&k.readPixels(G,Q,Y,K,gt.convert(ee),gt.convert(fe),At)}finally{let Bt=lt!==null?zt.get(lt).__webglFramebuffer:null;St.bindFramebuffer(k.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(A,G,Q,Y,K,At,Pt,Tt=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(G>=0&&G<=A.width-Y&&Q>=0&&Q<=A.height-K){St.bindFramebuffer(k.FRAMEBUFFER,It);let Bt=A.textures[Tt],ee=Bt.format,fe=Bt.type;A.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let kt=Ir(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pe=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,pe),k.bufferData(k.PIXEL_PACK_BUFFER,At.byteLength,k.STREAM_READ),k.readPixels(G,Q,Y,K,gt.convert(ee),gt.convert(fe),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let ei=lt!==null?zt.get(lt).__webglFramebuffer:null;St.bindFramebuffer(k.FRAMEBUFFER,ei);let Ne=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await ng(k,Ne,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,pe),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,At),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(pe),k.deleteSync(Ne),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,G=null,Q=0){let Y=Math.pow(2,-Q),K=Math.floor(A.image.width*Y),At=Math.floor(A.image.height*Y),Pt=G!==null?G.x:0,Tt=G!==null?G.y:0;$t.setTexture2D(A,0),k.copyTexSubImage2D(k.TEXTURE_2D,Q,0,0,Pt,Tt,K,At),St.unbindTexture()},this.copyTextureToTexture=function(A,G,Q=null,Y=null,K=0,At=0){let Pt,Tt,It,Bt,ee,fe,kt,pe,ei,Ne=A.isCompressedTexture?A.mipmaps[At]:A.image;if(Q!==null)Pt=Q.max.x-Q.min.x,Tt=Q.max.y-Q.min.y,It=Q.isBox3?Q.max.z-Q.min.z:1,Bt=Q.min.x,ee=Q.min.y,fe=Q.isBox3?Q.min.z:0;else{let ce=Math.pow(2,-K);Pt=Math.floor(Ne.width*ce),Tt=Math.floor(Ne.height*ce),A.isDataArrayTexture?It=Ne.depth:A.isData3DTexture?It=Math.floor(Ne.depth*ce):It=1,Bt=0,ee=0,fe=0}Y!==null?(kt=Y.x,pe=Y.y,ei=Y.z):(kt=0,pe=0,ei=0);let Fe=gt.convert(G.format),bi=gt.convert(G.type),Ft;G.isData3DTexture?($t.setTexture3D(G,0),Ft=k.TEXTURE_3D):G.isDataArrayTexture||G.isCompressedArrayTexture?($t.setTexture2DArray(G,0),Ft=k.TEXTURE_2D_ARRAY):($t.setTexture2D(G,0),Ft=k.TEXTURE_2D),St.activeTexture(k.TEXTURE0),St.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,G.flipY),St.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,G.premultiplyAlpha),St.pixelStorei(k.UNPACK_ALIGNMENT,G.unpackAlignment);let fi=St.getParameter(k.UNPACK_ROW_LENGTH),xe=St.getParameter(k.UNPACK_IMAGE_HEIGHT),ls=St.getParameter(k.UNPACK_SKIP_PIXELS),pi=St.getParameter(k.UNPACK_SKIP_ROWS),Lr=St.getParameter(k.UNPACK_SKIP_IMAGES);St.pixelStorei(k.UNPACK_ROW_LENGTH,Ne.width),St.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ne.height),St.pixelStorei(k.UNPACK_SKIP_PIXELS,Bt),St.pixelStorei(k.UNPACK_SKIP_ROWS,ee),St.pixelStorei(k.UNPACK_SKIP_IMAGES,fe);let qn=A.isDataArrayTexture||A.isData3DTexture,hs=G.isDataArrayTexture||G.isData3DTexture;if(A.isDepthTexture){let ce=zt.get(A),ri=zt.get(G),Xi=zt.get(ce.__renderTarget),Ue=zt.get(ri.__renderTarget);St.bindFramebuffer(k.READ_FRAMEBUFFER,Xi.__webglFramebuffer),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,Ue.__webglFramebuffer);for(let mi=0;mi<It;mi++)qn&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,zt.get(A).__webglTexture,K,fe+mi),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,zt.get(G).__webglTexture,At,ei+mi)),k.blitFramebuffer(Bt,ee,Bt+Pt,ee+Tt,kt,pe,kt+Pt,pe+Tt,k.DEPTH_BUFFER_BIT,k.NEAREST);St.bindFramebuffer(k.READ_FRAMEBUFFER,null),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||zt.has(A)){let ce=zt.get(A),ri=zt.get(G);St.bindFramebuffer(k.READ_FRAMEBUFFER,N),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,W);for(let Xi=0;Xi<It;Xi++)qn?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ce.__webglTexture,K,fe+Xi):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,ce.__webglTexture,K),hs?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,ri.__webglTexture,At,ei+Xi):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,ri.__webglTexture,At),K!==0?k.blitFramebuffer(Bt,ee,Bt+Pt,ee+Tt,kt,pe,kt+Pt,pe+Tt,k.COLOR_BUFFER_BIT,k.NEAREST):hs?k.copyTexSubImage3D(Ft,At,kt,pe,ei+Xi,Bt,ee,Pt,Tt):k.copyTexSubImage2D(Ft,At,kt,pe,Bt,ee,Pt,Tt);St.bindFramebuffer(k.READ_FRAMEBUFFER,null),St.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else hs?A.isDataTexture||A.isData3DTexture?k.texSubImage3D(Ft,At,kt,pe,ei,Pt,Tt,It,Fe,bi,Ne.data):G.isCompressedArrayTexture?k.compressedTexSubImage3D(Ft,At,kt,pe,ei,Pt,Tt,It,Fe,Ne.data):k.texSubImage3D(Ft,At,kt,pe,ei,Pt,Tt,It,Fe,bi,Ne):A.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,At,kt,pe,Pt,Tt,Fe,bi,Ne.data):A.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,At,kt,pe,Ne.width,Ne.height,Fe,Ne.data):k.texSubImage2D(k.TEXTURE_2D,At,kt,pe,Pt,Tt,Fe,bi,Ne);St.pixelStorei(k.UNPACK_ROW_LENGTH,fi),St.pixelStorei(k.UNPACK_IMAGE_HEIGHT,xe),St.pixelStorei(k.UNPACK_SKIP_PIXELS,ls),St.pixelStorei(k.UNPACK_SKIP_ROWS,pi),St.pixelStorei(k.UNPACK_SKIP_IMAGES,Lr),At===0&&G.generateMipmaps===!0&&G.mipmapsAutoUpdate===!0&&k.generateMipmap(Ft),St.unbindTexture()},this.initRenderTarget=function(A){zt.get(A).__webglFramebuffer===void 0&&$t.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?$t.setTextureCube(A,0):A.isData3DTexture?$t.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?$t.setTexture2DArray(A,0):$t.setTexture2D(A,0),St.unbindTexture()},this.resetState=function(){q=0,H=0,lt=null,St.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return wn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ye._getDrawingBufferColorSpace(t),e.unpackColorSpace=ye._getUnpackColorSpace()}};function Hg(n){let t=atob(n),e=new Uint8Array(t.length);for(let i=0;i<t.length;i++)e[i]=t.charCodeAt(i);return e.buffer}function An(n){return n?typeof n=="string"?new Float32Array(Hg(n)):Float32Array.from(n):new Float32Array(0)}function Wg(n){return typeof n=="string"?new Uint32Array(Hg(n)):Uint32Array.from(n)}function wo(n,t){return typeof t=="number"?t:n.findIndex(e=>(typeof e=="string"?e:e.name)===t)}var ff={value:0},EM=`
  vec3 n = normalize(normalMatrix * normal);
  vec3 light = ambientLightColor;
  #if NUM_HEMI_LIGHTS > 0
    for (int i = 0; i < NUM_HEMI_LIGHTS; i++)
      light += getHemisphereLightIrradiance(hemisphereLights[i], n);
  #endif
  #if NUM_DIR_LIGHTS > 0
    for (int i = 0; i < NUM_DIR_LIGHTS; i++)
      light += saturate(dot(n, directionalLights[i].direction)) * directionalLights[i].color;
  #endif
  float edge = 1.0 - abs(n.z);
  float dark = clamp(1.0 - 8.0 * max(diffuse.r, max(diffuse.g, diffuse.b)), 0.0, 1.0);
  vec3 tint = diffuse + lift * dark * (1.0 + 2.0 * edge * edge);
  paint = emissive + tint * RECIPROCAL_PI * light;`,Xg=`
#ifdef USE_FOG
  uniform vec3 fogColor;
  uniform float fogNear;
  uniform float fogFar;
  vec3 inFog(vec3 colour, float depth) {
    return mix(colour, fogColor, smoothstep(fogNear, fogFar, depth));
  }
#else
  vec3 inFog(vec3 colour, float depth) { return colour; }
#endif`,CM=(n,t)=>`
uniform vec3 diffuse;
varying vec3 paint;
#include <common>
#include <colorspace_pars_fragment>
${n?`uniform vec3 emissive;
uniform float lift;
#include <lights_pars_begin>`:""}
${t?"varying float depth;":Xg}
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * seen;
  ${n?EM:"paint = diffuse;"}
  paint = sRGBTransferOETF(vec4(paint, 1.0)).rgb;
  ${t?"depth = -seen.z;":"paint = inFog(paint, -seen.z);"}
}`,RM=n=>`
uniform float opacity;
varying vec3 paint;
${n?`varying float depth;${Xg}`:""}
void main() {
  gl_FragColor = vec4(${n?"inFog(paint, depth)":"paint"}, opacity);
}`,pf=(n,{lit:t=!1,long:e=!1}={})=>class extends n{onBeforeCompile(i){t&&(i.uniforms.lift=ff),i.vertexShader=CM(t,e),i.fragmentShader=RM(e)}customProgramCacheKey(){return`painted ${t} ${e}`}},mc=pf(Ma,{lit:!0}),pn=pf(ho),vr=pf(co,{long:!0});var PM=new Hs(1,1,1,10).translate(0,.5,0),IM=new pr(1,1,14).translate(0,.5,0),LM=new B(0,1,0),Js=class{constructor(t){this.root=new ge,this.material=new pn({color:t,transparent:!0,opacity:.9}),this.used=0,this.thickness=.004,this.turn=new Me,this.unit=new B}clear(){this.used=0;for(let t of this.root.children)t.visible=!1}add(t,e){let i=e.length();if(i<this.thickness)return;let s=this.root.children[this.used];s||(s=new ge,s.add(new Ae(PM,this.material),new Ae(IM,this.material)),this.root.add(s)),this.used++;let r=this.thickness,o=Math.min(5*r,.6*i);s.visible=!0,s.position.copy(t),this.unit.copy(e).divideScalar(i),s.quaternion.copy(this.turn.setFromUnitVectors(LM,this.unit)),s.children[0].scale.set(r,i-o,r),s.children[1].scale.set(2.6*r,o,2.6*r),s.children[1].position.set(0,i-o,0)}};var $g=60;function js(n,t,e,i){let s=n.clone().project(t);return{x:(s.x*.5+.5)*e,y:(.5-s.y*.5)*i,depth:s.z}}function qg(n,t,e,i,s,r,o){let a=n.centre.clone().applyMatrix4(t),l=n.held.clone().applyMatrix4(t),h=n.along.clone().transformDirection(t);return n.kind==="turn"?DM(a,l,h,e,i,s,r,o):Yg(l,h.multiplyScalar(n.along.length()),e,i,s,r,o)}function Yg(n,t,e,i,s,r,o){let l=js(n,e,i,s),h=js(n.clone().addScaledVector(t,.001),e,i,s),[c,u]=[(h.x-l.x)/.001,(h.y-l.y)/.001],d=c*c+u*u;return d<$g*$g&&([c,u]=[0,-300],d=c*c+u*u),(f,_)=>((f-r)*c+(_-o)*u)/d}function DM(n,t,e,i,s,r,o,a){let l=js(n,i,s,r),h=n.clone().sub(i.position).normalize(),c=e.dot(h);if(Math.abs(c)>.25){let f=c<0?-1:1,_=Math.atan2(a-l.y,o-l.x),w=0;return(m,p)=>{let v=Math.atan2(p-l.y,m-l.x),R=v-_;return R>Math.PI&&(R-=2*Math.PI),R<-Math.PI&&(R+=2*Math.PI),w+=R,_=v,f*w}}let u=t.clone().sub(n),d=new B().crossVectors(e,u);return Yg(t,d,i,s,r,o,a)}var Zg={mouse:13,pen:16,touch:26},NM=5,FM=400,So=class{constructor(t,e){this.view=t,this.told=e,this.ray=new Ia,this.held=null,this.pushing=!1;let{canvas:i}=t.stage,s=(r,o)=>i.addEventListener(r,o,{capture:!0});s("pointerdown",r=>this.down(r)),s("pointermove",r=>this.move(r)),s("pointerup",r=>this.up(r,"end")),s("pointercancel",r=>this.up(r,"cancel")),s("pointerleave",()=>this.held||this.hover(null))}spot(t){let e=this.view.stage.canvas.getBoundingClientRect();return{x:t.clientX-e.left,y:t.clientY-e.top,box:e}}handleAt(t){let{x:e,y:i,box:s}=this.spot(t),{handles:r,stage:o}=this.view,a=null,l=Zg[t.pointerType]??Zg.mouse;for(let h of r.all){if(!h.root.visible)continue;let c=h.held.clone().applyMatrix4(r.root.matrixWorld),u=js(c,o.camera,s.width,s.height),d=Math.hypot(u.x-e,u.y-i)-(r.selected.has(h.name)?4:0);d<l&&u.depth<1&&([a,l]=[h,d])}return a}bodyAt(t){let{x:e,y:i,box:s}=this.spot(t),r=new Yt(2*e/s.width-1,1-2*i/s.height),{robot:o,stage:a}=this.view;this.ray.setFromCamera(r,a.camera);let l=this.ray.intersectObjects(o.meshes.filter(d=>d.visible),!1)[0];if(!l)return null;let h=l.object.userData.body,{geom:c}=l.object.userData,u=o.groups[h].worldToLocal(l.point.clone());return{body:h,at:u,point:l.point,geom:c}}down(t){if(!t.isTrusted||(this.held&&!t.isPrimary&&this.giveToCamera(t),t.button!==0||!t.isPrimary||!this.view.design))return;let{x:e,y:i,box:s}=this.spot(t);this.start={x:e,y:i};let r=this.handleAt(t);if(r)return this.take(r,t,e,i,s);(this.pushing||t.shiftKey)&&this.beginPush(t)}take(t,e,i,s,r){this.grab(e);let{handles:o,stage:a}=this.view,l=this.view.readParameter(t.name);if(l.locked){this.told.drag(t.name,l.value,"locked");return}let h=o.root.matrixWorld,{width:c,height:u}=r,d=qg(t,h,a.camera,c,u,i,s);this.held={name:t.name,from:l.value,state:l,change:d},this.told.drag(t.name,l.value,"begin")}grab(t){t.stopImmediatePropagation(),t.preventDefault(),this.first=t;let{canvas:e,controls:i}=this.view.stage;e.focus({preventScroll:!0}),e.setPointerCapture(t.pointerId),i.enabled=!1}giveToCamera({timeStamp:t}){let{first:e,held:i}=this;if(e.pointerType!=="touch"||t-e.timeStamp>FM)return;this.letGo(i.from,"cancel"),this.start=null;let{pointerId:s,pointerType:r,clientX:o,clientY:a}=e,l=new PointerEvent("pointerdown",{pointerId:s,pointerType:r,clientX:o,clientY:a});this.view.stage.canvas.dispatchEvent(l)}letGo(t,e){let{held:i}=this;this.held=null,this.view.stage.controls.enabled=!0,i.push?(this.view.push=null,this.told.push(null)):this.told.drag(i.name,t,e)}beginPush(t){let e=this.bodyAt(t);e&&(this.grab(t),this.held={push:e})}move(t){if(!this.view.design)return;if(!this.held){t.buttons===0&&this.hover(this.handleAt(t)?.name??null);return}if(t.stopImmediatePropagation(),t.pointerId!==this.first.pointerId)return;let{x:e,y:i}=this.spot(t);if(this.held.push)return this.movePush(t);let{from:s,state:r,change:o,name:a}=this.held,l=Math.min(r.upper,Math.max(r.lower,s+o(e,i)));this.held.value=l,this.told.drag(a,l,"drag")}movePush(t){let{x:e,y:i,box:s}=this.spot(t),{camera:r}=this.view.stage,{point:o,body:a,at:l}=this.held.push,h=o.clone().project(r).z,u=new B(2*e/s.width-1,1-2*i/s.height,h).unproject(r).sub(o);u.applyQuaternion(this.view.stage.tilted.quaternion.clone().invert()),this.view.push={body:a,at:l.toArray(),along:u},this.told.push(this.view.push)}up(t,e){let{canvas:i,controls:s}=this.view.stage,{held:r,first:o}=this;if(r&&t.pointerId!==o.pointerId)return;if(s.enabled=!0,r)return t.stopImmediatePropagation(),i.hasPointerCapture(t.pointerId)&&i.releasePointerCapture(t.pointerId),this.letGo(r.value??r.from,e);if(!this.start||e!=="end")return;let{x:a,y:l}=this.spot(t),h=Math.hypot(a-this.start.x,l-this.start.y)<NM;if(this.start=null,!h)return;let c=this.bodyAt(t);this.told.pick(c?.body??null,t.ctrlKey||t.metaKey,c?.geom)}hover(t){let{canvas:e}=this.view.stage;e.style.cursor=t?"grab":"",this.hovered!==t&&(this.hovered=t,this.told.hover(t))}};var gc=new B(0,0,1),Qs=class{constructor(t){this.motion=t,this.period=t.period,this.root=t.root,this.frames=t.frames,this.poses=An(t.poses),this.bodyCount=this.poses.length/(7*this.frames),this.forces=An(t.forces),this.feet=t.feet??[],this.faults=t.faults??[],this.advance=t.advance??[0,0,0],this.footBody=this.feet.map(e=>Array.isArray(t.bodies)?wo(t.bodies,e.body):e.body),this.a=new Me,this.b=new Me,this.p=new B}cycleStart(t){let[e,i,s]=this.advance;if(Math.abs(s)<1e-9)return[t*e,t*i,0];let r=0,o=0,a=Math.abs(t),l=Math.sign(t);for(let h=0;h<a;h++){let c=l>0?h*s:-(h+1)*s;r+=l*(Math.cos(c)*e-Math.sin(c)*i),o+=l*(Math.sin(c)*e+Math.cos(c)*i)}return[r,o,t*s]}frame(t){return this.poses.subarray(7*t*this.bodyCount,7*(t+1)*this.bodyCount)}carry(t,e){let[i,s,r]=this.cycleStart(t);e.applyAxisAngle(gc,r),e.x+=i,e.y+=s}at(t){let e=t/this.period,i=Math.floor(e);return{cycle:i,phase:e-i}}path(t,e){let{cycle:i,phase:s}=this.at(t),[r,o]=this.cycleStart(i),[a,l]=this.cycleStart(i+1);return e.set(r+s*(a-r),o+s*(l-o),0)}sample(t,e){let{cycle:i,phase:s}=this.at(t),r=s*this.frames,o=Math.min(Math.floor(r),this.frames-1),a=r-o,l=o+1===this.frames?0:o+1,h=this.cycleStart(i),c=l===0?this.cycleStart(i+1):h;for(let u=0;u<this.bodyCount;u++){this.pose(o,u,h,this.p,this.a);let d=7*u,{x:f,y:_,z:w}=this.p;this.pose(l,u,c,this.p,this.b),this.a.slerp(this.b,a),e[d]=f+a*(this.p.x-f),e[d+1]=_+a*(this.p.y-_),e[d+2]=w+a*(this.p.z-w),e[d+3]=this.a.w,e[d+4]=this.a.x,e[d+5]=this.a.y,e[d+6]=this.a.z}return e}pose(t,e,[i,s,r],o,a){let l=7*(t*this.bodyCount+e),h=this.poses;o.set(h[l],h[l+1],h[l+2]),a.set(h[l+4],h[l+5],h[l+6],h[l+3]),r!==0&&(o.applyAxisAngle(gc,r),a.premultiply(new Me().setFromAxisAngle(gc,r))),o.x+=i,o.y+=s}force(t,e,i){let{cycle:s,phase:r}=this.at(t),a=3*(Math.min(Math.floor(r*this.frames),this.frames-1)*this.feet.length+e);return i.set(this.forces[a]||0,this.forces[a+1]||0,this.forces[a+2]||0),i.applyAxisAngle(gc,s*this.advance[2])}stands(t,e){let i=this.feet[e].stance;if(!i?.length)return!1;let{phase:s}=this.at(t);return i[Math.min(Math.floor(s*i.length),i.length-1)]>0}faultsAt(t){let{phase:e}=this.at(t);return this.faults.filter(({from:i,to:s})=>i<=s?e>=i&&e<=s:e>=i||e<=s)}};function Kg(n,t=Math.PI/3){let e=n.index?n.toNonIndexed():n,i=e.attributes.position,s=i.count,r;if(i.isBufferAttribute===!0&&i.itemSize===3&&i.normalized===!1)r=i.array;else{r=new Float64Array(s*3);for(let b=0;b<s;b++)r[3*b+0]=i.getX(b),r[3*b+1]=i.getY(b),r[3*b+2]=i.getZ(b)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,h=new Float64Array(l*3);for(let b=0;b<l;b++){let C=9*b,E=r[C+0],y=r[C+1],T=r[C+2],U=r[C+3],L=r[C+4],D=r[C+5],z=r[C+6],V=r[C+7],N=r[C+8],W=z-U,q=V-L,H=N-D,lt=E-U,Z=y-L,j=T-D,et=q*j-H*Z,dt=H*lt-W*j,ut=W*Z-q*lt,tt=1/(Math.sqrt(et*et+dt*dt+ut*ut)||1);h[3*b+0]=et*tt,h[3*b+1]=dt*tt,h[3*b+2]=ut*tt}let c=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,_=new Int32Array(d),w=0;for(let b=0;b<s;b++){let C=3*b,E=Math.trunc(r[C+0]*a),y=Math.trunc(r[C+1]*a),T=Math.trunc(r[C+2]*a),U=(Math.imul(E,73856093)^Math.imul(y,19349663)^Math.imul(T,83492791))&f;for(;;){let L=_[U];if(L===0){let z=3*w;u[z+0]=E,u[z+1]=y,u[z+2]=T,_[U]=w+1,c[b]=w++;break}let D=3*(L-1);if(u[D+0]===E&&u[D+1]===y&&u[D+2]===T){c[b]=L-1;break}U=U+1&f}}let m=new Int32Array(w+1);for(let b=0;b<s;b++)m[c[b]+1]++;for(let b=0;b<w;b++)m[b+1]+=m[b];let p=new Int32Array(s),v=m.slice(0,w);for(let b=0;b<l;b++){let C=3*b;p[v[c[C+0]]++]=b,p[v[c[C+1]]++]=b,p[v[c[C+2]]++]=b}let R=new Float32Array(s*3);for(let b=0;b<l;b++){let C=3*b,E=h[C+0],y=h[C+1],T=h[C+2];for(let U=0;U<3;U++){let L=C+U,D=c[L],z=0,V=0,N=0;for(let q=m[D],H=m[D+1];q<H;q++){let lt=3*p[q],Z=h[lt+0],j=h[lt+1],et=h[lt+2];E*Z+y*j+T*et>o&&(z+=Z,V+=j,N+=et)}let W=1/(Math.sqrt(z*z+V*V+N*N)||1);R[3*L+0]=z*W,R[3*L+1]=V*W,R[3*L+2]=N*W}}return e.setAttribute("normal",new li(R,3,!1)),e}var Jg={box:()=>new Sn(2,2,2),sphere:n=>new Fn(1,n,n/2),ellipsoid:n=>new Fn(1,n,n/2),cylinder:n=>new Hs(1,1,2,n).rotateX(Math.PI/2)},mf=new Map,UM=.6,OM=8,kM=24;function BM({type:n,size:t}){return n==="ellipsoid"?Math.max(...t):n==="sphere"||n==="cylinder"||n==="capsule"?t[0]:0}function jg(n,t){let e=BM(n);if(!e)return 0;let i=Math.PI/Math.acos(Math.max(0,1-t/e));return Math.min(kM,Math.max(OM,2*Math.ceil(i/2)))}function gf(n,t){return n.type==="capsule"?`capsule ${n.size[0]} ${n.size[1]} ${t}`:n.type==="mesh"?`mesh ${n.mesh}`:`${n.type} ${t}`}function _f(n,t){if(n.type==="capsule"){let[s,r]=n.size;return new ya(s,2*r,Math.ceil(t/4),t).rotateX(Math.PI/2)}if(!Jg[n.type])return null;let e=gf(n,t);mf.has(e)||mf.set(e,Jg[n.type](t));let i=mf.get(e);return i.userData.shared=!0,i}function Qg(n){let[t,e,i]=n.size;return n.type==="box"||n.type==="ellipsoid"?[t,e,i]:n.type==="sphere"?[t,t,t]:n.type==="cylinder"?[t,t,e]:[1,1,1]}function t0(n){let t=new ti;t.setAttribute("position",new li(An(n.vertices),3)),t.setIndex(new li(Wg(n.faces),1));let e=An(n.normals);if(e.length===t.attributes.position.array.length)t.setAttribute("normal",new li(e,3));else return Kg(t,UM);return t}var zM=2,GM=new ie(3112912),VM=.35,HM=1.2,WM=(n,t)=>_f(n,Math.max(8,2*Math.ceil(t/4))),e0=n=>n&&!n.userData.shared&&n.dispose(),tr=class{constructor({ghost:t=null,tint:e=null,meshSource:i,changed:s}){this.root=new ge,this.ghost=t,this.tint=e,this.meshSource=i,this.changed=s,this.groups=[],this.meshes=[],this.bodies=[],this.loaded=new Map,this.pixel=0}setDesign(t){this.layoutOf(t)!==this.layout&&this.rebuild(t),this.bodies=t.bodies,t.geoms.forEach((e,i)=>this.updateMesh(this.meshes[i],e,t))}layoutOf(t){return t.bodies.length+"|"+t.geoms.map(e=>`${e.body} ${e.type}`).join("|")}rebuild(t){this.dispose(),this.layout=this.layoutOf(t),this.groups=t.bodies.map(()=>new ge);for(let e of this.groups)this.root.add(e);this.meshes=t.geoms.map(e=>{let i=new mc;this.ghost!==null&&Object.assign(i,{transparent:!0,opacity:this.ghost,depthWrite:!1});let s=new Ae(void 0,i);return s.geometry.dispose(),s.userData.body=wo(t.bodies,e.body),this.groups[s.userData.body]?.add(s),s})}updateMesh(t,e,i){let[s,r,o,a]=e.rgba;t.visible=e.group<=zM&&a>0&&e.type!=="plane",t.position.fromArray(e.pos),t.quaternion.set(e.quat[1],e.quat[2],e.quat[3],e.quat[0]),t.scale.fromArray(Qg(e)),t.material.color.setRGB(s,r,o,"srgb"),this.tint&&t.material.color.lerp(this.tint,.75),a<1&&this.ghost===null&&Object.assign(t.material,{transparent:!0,opacity:a}),t.userData.geom=e,this.shape(t,i)}shape(t,e){let{geom:i}=t.userData,s=jg(i,(this.ghost===null?VM:HM)*this.pixel),r=gf(i,s);if(t.userData.shape!==r){if(t.userData.shape=r,this.freeShapes(t),t.userData.kept=i.type==="mesh",i.type==="mesh")return this.loadMesh(t,i.mesh,r,e);t.geometry=_f(i,s)??t.geometry,this.ghost===null&&(t.userData.shade=WM(i,s))}}freeShapes(t){t.userData.kept||e0(t.geometry),e0(t.userData.shade),t.userData.shade=null}setPixel(t){if(!(t===this.pixel||!this.root.visible)){this.pixel=t;for(let e of this.meshes)this.shape(e)}}loadMesh(t,e,i,s){let r=o=>{t.userData.shape===i&&(t.geometry=o,this.changed())};if(!this.loaded.has(e)){let o=s.meshes?.[e]??this.meshSource?.(e);this.loaded.set(e,Promise.resolve(o).then(t0))}this.loaded.get(e).then(r,()=>t.visible=!1)}complete(){return Promise.allSettled(this.loaded.values())}setPoses(t){this.groups.forEach((e,i)=>{let s=7*i;s+6>=t.length||(e.position.set(t[s],t[s+1],t[s+2]),e.quaternion.set(t[s+4],t[s+5],t[s+6],t[s+3]))})}highlight(t){for(let e of this.meshes){let i=t.includes(e.userData.body);e.material.emissive.copy(GM).multiplyScalar(i?.35:0)}}place(t,e,i){let s=this.groups[t];return s?i.fromArray(e).applyQuaternion(s.quaternion).add(s.position):i.set(0,0,0)}turn(t,e,i){let s=this.groups[t];return i.fromArray(e).applyQuaternion(s?s.quaternion:new Me)}dispose(){for(let t of this.meshes)this.freeShapes(t),t.material.dispose();this.root.clear(),this.groups=[],this.meshes=[]}};var XM=new ie(15238942),$M=.2,qM=1e-6,_c=(n,t)=>n.every((e,i)=>Math.abs(e-t[i])<qM);function YM(n,t){let[e,i]=[n,t].map(({motion:a})=>new Qs(a).frame(0)),s=a=>!_c(e.subarray(7*a,7*a+7),i.subarray(7*a)),{geoms:r}=n.design,o=t.design.geoms;return r.map((a,l)=>{let h=o[l];return!h||a.mesh!==h.mesh||!_c(a.size,h.size)||!_c(a.pos,h.pos)||!_c(a.quat,h.quat)||s(a.body)})}var xc=class{constructor(t){this.root=new ge,this.sides=["lower","upper"].map(e=>{let i=new tr({...t,ghost:$M,tint:XM});return i.root.visible=!1,this.root.add(i.root),{name:e,robot:i}})}set(t){this.shown=!!t;let e=t&&YM(t.lower,t.upper);for(let i of this.sides){if(i.robot.root.visible=this.shown,!t)continue;let{design:s,motion:r}=t[i.name];i.robot.setDesign(s),i.robot.meshes.forEach((o,a)=>o.visible&&=e[a]??!0),i.player=new Qs(r),i.poses=new Float32Array(7*i.player.bodyCount)}}setPixel(t){for(let{robot:e}of this.sides)e.setPixel(t)}pose(t,e){if(this.shown)for(let i of this.sides){if(i.robot.root.visible=!!t,!t)continue;let s=i.player.period/t.period;i.robot.setPoses(i.player.sample(e*s,i.poses))}}};function i0(n){n.root.updateMatrixWorld(!0);let t=new ts;for(let i of n.meshes)i.visible&&t.expandByObject(i);let e=t.getSize(new B);return t.isEmpty()?{size:.5,height:.3}:{size:Math.max(e.x,e.y,e.z),height:t.max.z}}function ZM(n,t){let e=n.bodies[t]?.name,i=n.geoms.filter(a=>a.body===t||a.body===e),s=a=>Math.hypot(...a.pos),r=i.filter(a=>a.type==="sphere");return(r.length?r:i).reduce((a,l)=>!a||s(l)>s(a)?l:a,null)}function n0(n,t){let e=new Me,i=t.feet.map((s,r)=>{let o=t.footBody[r];(typeof o!="number"||o<0)&&(o=n.bodies.findIndex(h=>h.name===s.body));let a=ZM(n,o),l=a?a.type==="sphere"?a.size[0]:Math.min(...a.size):0;return{body:o,at:s.at??a?.pos??[0,0,0],radius:l}});return(s,r,o)=>{let{body:a,at:l,radius:h}=i[r],c=7*a;return e.set(s[c+4],s[c+5],s[c+6],s[c+3]),o.fromArray(l).applyQuaternion(e),o.set(o.x+s[c],o.y+s[c+1],o.z+s[c+2]-h),o}}var KM=new va(1,24),JM=.0012,yc=class{constructor(){this.root=new ge,this.paths=new ge,this.discs=new ge,this.root.add(this.paths,this.discs),this.discMaterial=new pn({color:2067056,transparent:!0,opacity:.55,depthWrite:!1,fog:!1}),this.pathMaterial=new vr({color:8029846,transparent:!0,opacity:.7}),this.point=new B}setMotion(t,e){for(this.soles=e;this.discs.children.length<t.feet.length;){let i=new Ae(KM,this.discMaterial);i.renderOrder=2,this.discs.add(i)}this.fitPaths(t.feet.length,t.frames+1),this.paths.children.forEach(({geometry:i},s)=>{let{position:r}=i.attributes;for(let o=0;o<=t.frames;o++)e(t.frame(o%t.frames),s,this.point),o===t.frames&&t.carry(1,this.point),this.point.toArray(r.array,3*o);r.needsUpdate=!0})}fitPaths(t,e){let{children:i}=this.paths,s=i[0]?.geometry.attributes.position.count;if(!(i.length===t&&s===e)){for(let r of i)r.geometry.dispose();this.paths.clear();for(let r=0;r<t;r++){let o=new ti;o.setAttribute("position",new li(new Float32Array(3*e),3));let a=new Vs(o,this.pathMaterial);a.frustumCulled=!1,this.paths.add(a)}}}update(t,e,i,s){let{cycle:r}=t.at(e),[o,a,l]=t.cycleStart(r);this.paths.position.set(o,a,0),this.paths.rotation.z=l,this.discs.children.forEach((h,c)=>{h.visible=c<t.feet.length&&t.stands(e,c),h.visible&&(this.soles(i,c,h.position),h.position.z=JM,h.scale.setScalar(s))})}};var Mo={idle:3112912,active:15238942,locked:9147809,bound:15238942},xf={move:new Fn(1,10,6),scale:new Sn(1.7,1.7,1.7),turn:new Fn(.8,10,6)},s0=new pr(.75,1.5,14),jM=new Sa(1,.035,8,56),QM=.09,yf=6.5,t1=new B(0,0,1),e1=new B(0,1,0);function i1({handle:n}){if(!n)return[];let{kind:t,also:e=[],...i}=n;return[i,...e].map(s=>({kind:t,...s}))}var vf=class{constructor(t,e,i){this.name=t.name,this.kind=e.kind,this.body=wo(i,e.body),this.at=e.at,this.direction=e.direction,this.root=new ge,this.root.visible=!1,this.material=this.own(pn,Mo.idle),this.knob=new Ae(xf[this.kind],this.material),this.root.add(this.knob),this.kind==="turn"?(this.ring=new Ae(jM,this.material),this.root.add(this.ring)):(this.tips=[new Ae(s0,this.material),new Ae(s0,this.material)],this.root.add(...this.tips));for(let s of this.root.children)s.renderOrder=10;this.range=this.rangeLine(),this.centre=new B,this.along=new B,this.held=new B}own(t,e){return new t({color:e,depthTest:!1,transparent:!0,fog:!1,opacity:.92})}rangeLine(){let t=new ti;t.setAttribute("position",new li(new Float32Array(123),3));let e=new ge,i=new Vs(t,this.own(vr,Mo.bound));i.frustumCulled=!1;let s=this.own(pn,Mo.bound);s.opacity=.45;let r=[new Ae(xf[this.kind],s),new Ae(xf[this.kind],s)];e.add(i,...r),e.visible=!1;for(let o of e.children)o.renderOrder=9;return e}dispose(){this.range.children[0].geometry.dispose();for(let t of[...this.root.children,...this.range.children])t.material.dispose()}},vc=class{constructor(){this.root=new ge,this.all=[],this.selected=new Set,this.hovered=null,this.visible=!0,this.q=new Me,this.p=new B}setParameters(t,e){for(let i of this.all)i.dispose();this.root.clear(),this.parameters=new Map(t.map(i=>[i.name,i])),this.all=t.flatMap(i=>i1(i).map(s=>new vf(i,s,e)));for(let i of this.all)this.root.add(i.root,i.range)}moveTo(t){let e=t.flat();e.length===this.all.length&&this.all.forEach((i,s)=>i.at=e[s])}namesOn(t){return[...new Set(this.all.filter(e=>e.body===t).map(e=>e.name))]}isShown(t){return this.visible?this.selected.has(t.name)||this.hovered===t.name?!0:t.kind!=="turn":!1}update(t,e,i,s,r){let o=2*Math.tan(e.fov*Math.PI/360)/i;for(let a of this.all){if(a.root.visible=this.isShown(a),a.range.visible=!1,!a.root.visible)continue;t.place(a.body,a.at,a.centre),t.turn(a.body,a.direction,a.along);let l=r(a.name),h=this.selected.has(a.name)||this.hovered===a.name,c=l.locked?Mo.locked:h?Mo.active:Mo.idle;a.material.color.set(c),this.p.copy(a.centre).applyMatrix4(this.root.matrixWorld);let u=e.position.distanceTo(this.p)*o;a.kind==="turn"?this.shapeRing(a,u,s,l):this.shapeKnob(a,u,h),h&&this.showRange(a,u,s,l)}}shapeKnob(t,e,i){t.root.position.copy(t.centre),t.held.copy(t.centre);let s=yf*e*(i?1.15:.8);t.knob.scale.setScalar(s),this.q.setFromUnitVectors(e1,this.p.copy(t.along).normalize()),t.knob.quaternion.copy(this.q),t.tips.forEach((r,o)=>{let a=o?-1:1;r.visible=i,r.scale.setScalar(s*.8),r.quaternion.copy(this.q),o&&r.rotateX(Math.PI),r.position.copy(this.p).multiplyScalar(a*s*2.5)})}shapeRing(t,e,i,{value:s}){t.root.position.copy(t.centre);let r=this.p.copy(t.along).normalize();t.root.quaternion.setFromUnitVectors(t1,r),t.radius=i*QM,t.ring.scale.setScalar(t.radius),t.ring.scale.z=Math.max(t.radius,35*e),t.knob.scale.setScalar(yf*e);let o=new B(Math.cos(s),Math.sin(s),0).multiplyScalar(t.radius);t.knob.position.copy(o),t.held.copy(o).applyQuaternion(t.root.quaternion).add(t.centre)}showRange(t,e,i,{value:s,lower:r,upper:o}){let[a,l,h]=t.range.children,c=a.geometry.attributes.position,u=c.count,d=new B;t.range.visible=!0;for(let f=0;f<u;f++){let _=r+(o-r)*f/(u-1);t.kind==="turn"?(d.set(Math.cos(_),Math.sin(_),0).multiplyScalar(t.radius*1.12),d.applyQuaternion(t.root.quaternion).add(t.centre)):d.copy(t.along).multiplyScalar(_-s).add(t.centre),c.setXYZ(f,d.x,d.y,d.z),f===0&&l.position.copy(d)}h.position.copy(d),c.needsUpdate=!0;for(let f of[l,h])f.scale.setScalar(yf*e*.75),f.quaternion.copy(t.kind==="turn"?t.root.quaternion:t.knob.quaternion)}};var n1=new Sn(1,1,1).translate(0,0,.5),s1=.16,r1=.025,bc=class{constructor(){this.root=new ge,this.material=new mc({color:11951112,transparent:!0,opacity:.55,depthWrite:!1}),this.before=new B,this.after=new B,this.top=new B}setMotion(t,e,i){let s=t.motion.step??0;this.root.clear(),s>0&&t.feet.forEach((r,o)=>{let a=this.highest(t,e,o),l=c=>t.frame((a+c+t.frames)%t.frames);e(l(-1),o,this.before),e(l(0),o,this.top),e(l(1),o,this.after);let h=new Ae(n1,this.material);h.position.set(this.top.x,this.top.y,0),h.rotation.z=Math.atan2(this.after.y-this.before.y,this.after.x-this.before.x),h.scale.set(r1*i,s1*i,s),h.renderOrder=2,this.root.add(h)})}highest(t,e,i){let s=1,r=-1/0;for(let o=1;o+1<t.frames;o++){let{z:a}=e(t.frame(o),i,this.top);a>r&&([s,r]=[o,a])}return s}update(t,e){let{cycle:i}=t.at(e),[s,r,o]=t.cycleStart(i);this.root.position.set(s,r,0),this.root.rotation.z=o}};var o1=new wa(.72,1,28),r0=6,o0=19,bf=14,a1=6.4;function l1(n){return n.sort((t,e)=>t.y-e.y),n.forEach((t,e)=>{for(let i of n.slice(0,e))t.y<i.y+o0&&t.x<i.x+i.width&&i.x<t.x+t.width&&(t.y=i.y+o0)}),n}var wc=class{constructor(t){this.root=new ge,this.material=new pn({color:14169132,side:Mn,depthTest:!1,transparent:!0,opacity:.95,fog:!1}),this.labels=[],this.point=new B,this.turn=new Me;for(let e=0;e<r0;e++){let i=new Ae(o1,this.material);i.renderOrder=8,i.visible=!1,this.root.add(i);let s=document.createElement("div");s.className="mark-label",s.hidden=!0,t.append(s),this.labels.push(s)}}show(t,e,{camera:i,wide:s,tall:r}){this.shown=t.slice(0,r0),this.root.getWorldQuaternion(this.turn).invert(),this.root.children.forEach((o,a)=>{let l=this.shown[a];o.visible=!!l,l&&(o.position.copy(l.at),o.scale.setScalar(e),o.quaternion.copy(this.turn).multiply(i.quaternion))}),this.place(i,s,r)}place(t,e,i){if(!this.shown.length){for(let r of this.labels)r.hidden=!0;return}let s=[];this.labels.forEach((r,o)=>{let a=this.shown[o];if(r.hidden=!a?.words,r.hidden)return;this.root.children[o].getWorldPosition(this.point).project(t),r.textContent!==a.words&&(r.textContent=a.words);let h=(this.point.x*.5+.5)*e,c=(.5-this.point.y*.5)*i-8,u=a1*a.words.length+12,d=h+bf+u>e?Math.max(0,h-bf-u):h+bf;s.push({label:r,x:d,y:c,width:u})});for(let{label:r,x:o,y:a}of l1(s))r.style.transform=`translate(${o.toFixed(0)}px, ${a.toFixed(0)}px)`}};var Sc=class{constructor(t){this.layer=t,this.label=document.createElement("div"),this.label.className="name-tag",this.label.hidden=!0,t.append(this.label),this.point=new B}show(t,e,i,s){if(this.label.hidden=!t,!t)return;this.label.textContent!==t&&(this.label.textContent=t);let{clientWidth:r,clientHeight:o}=this.layer;this.point.set(0,0,i),e.localToWorld(this.point).project(s);let a=(this.point.x*.5+.5)*r,l=(.5-this.point.y*.5)*o;this.label.style.transform=`translate(${a.toFixed(0)}px, ${l.toFixed(0)}px) translate(-50%, -100%)`}};var h1=120,c1=1,Mc=class{constructor(){this.a=new Me,this.b=new Me,this.clear()}clear(){this.frames=[],this.shown=!1,this.at=0}get begin(){return this.frames[0]?.time??0}get end(){return this.frames.at(-1)?.time??0}get seconds(){return this.end-this.begin}add(t){let{frames:e}=this,i=e.at(-1);for(i&&(t.time<i.time||t.time>i.time+c1)&&this.clear(),this.frames.at(-1)?.time===t.time&&this.frames.pop(),this.frames.push(t);this.seconds>h1;)this.frames.shift();this.at=t.time}index(t){let[e,i]=[0,this.frames.length-1];for(;e<i;){let s=Math.ceil((e+i)/2);this.frames[s].time<=t?e=s:i=s-1}return e}neighbour(t){let e=Math.min(this.frames.length-1,Math.max(0,this.index(this.at)+t));return this.frames[e]?.time??0}show(t){if(!this.frames.length)return null;this.shown=!0,this.at=Math.min(this.end,Math.max(this.begin,t));let e=this.index(this.at),[i,s]=[this.frames[e],this.frames[e+1]??this.frames[e]],r=s.time-i.time,o=r>0?(this.at-i.time)/r:0;return{...i,time:this.at,poses:this.between(i.poses,s.poses,o)}}between(t,e,i){if(i===0||t.length!==e.length)return t;let s=Float32Array.from(t);for(let r=0;r<s.length;r+=7){for(let o=0;o<3;o++)s[r+o]+=i*(e[r+o]-t[r+o]);this.a.set(t[r+4],t[r+5],t[r+6],t[r+3]),this.b.set(e[r+4],e[r+5],e[r+6],e[r+3]),this.a.slerp(this.b,i),s.set([this.a.w,this.a.x,this.a.y,this.a.z],r+3)}return s}stances(t){let{frames:e,begin:i,seconds:s}=this,r=e[0]?.feet.length??0;return Array.from({length:r},(o,a)=>{let l=[],h=null;return e.forEach(({time:c,feet:u},d)=>{let f=(u[a]?.force?.[2]??0)>t;f&&(h??=c),h!==null&&(!f||d===e.length-1)&&(l.push([(h-i)/s,(c-i)/s]),h=null)}),l})}};var Ac=class{constructor(t){this.root=new ge,this.material=new pn({color:0,transparent:!0,opacity:.13,depthWrite:!1,stencilWrite:!0,stencilFunc:Vd,stencilZPass:Gd,fog:!1}),this.sun=t,this.flat=new Ce,this.toGround=new Ce,this.here=new B}setTheme(t){this.material.opacity=t==="dark"?.42:.13}aim(){let t=this.root.parent;this.toGround.copy(t.matrixWorld).invert(),this.here.copy(this.sun).transformDirection(this.toGround);let[e,i]=[this.here.x/this.here.z,this.here.y/this.here.z];this.flat.set(1,0,-e,0,0,1,-i,0,0,0,1e-5,8e-4,0,0,0,1),this.flat.multiply(this.toGround)}follow(t){for(this.aim();this.root.children.length>t.length;)this.root.children.pop();for(;this.root.children.length<t.length;){let e=new Ae(void 0,this.material);e.matrixAutoUpdate=!1,e.frustumCulled=!1,e.renderOrder=1,this.root.add(e)}t.forEach((e,i)=>{let s=this.root.children[i];s.visible=e.visible,s.geometry=e.userData.shade??e.geometry,s.matrix.multiplyMatrices(this.flat,e.matrixWorld),s.matrixWorldNeedsUpdate=!0})}};var a0=(n,t,e)=>Math.atan((n.x*t+n.y*e)/n.z),l0=(n,t)=>Math.abs(n)<1e-4?null:`${Math.abs(n).toFixed(2)} rad (${(Math.abs(n)*180/Math.PI).toFixed(1)}°) ${t[n>0?0:1]}`,Tc=class{constructor(t){this.label=document.createElement("div"),this.label.className="slope-tag",this.label.hidden=!0,t.append(this.label)}show(t,e){let i=Math.hypot(e[0],e[1]),[s,r]=i>1e-9?[e[0]/i,e[1]/i]:[1,0],o=[l0(a0(t,s,r),["up the way","down the way"]),l0(a0(t,-r,s),["up to its left","up to its right"])].filter(Boolean);this.label.hidden=!o.length,o.length&&(this.label.textContent=`Slope ${o.join(", ")}`)}};var h0={type:"change"},Sf={type:"start"},u0={type:"end"},Ec=new zs,c0=new un,u1=Math.cos(70*hc.DEG2RAD),Mi=new B,en=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},wf=1e-6,Cc=class extends La{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:qs.ROTATE,MIDDLE:qs.DOLLY,RIGHT:qs.PAN},this.touches={ONE:Ys.ROTATE,TWO:Ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new Me,this._lastTargetPosition=new B,this._quat=new Me().setFromUnitVectors(t.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new po,this._sphericalDelta=new po,this._scale=1,this._panOffset=new B,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new B,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=f1.bind(this),this._onPointerDown=d1.bind(this),this._onPointerUp=p1.bind(this),this._onContextMenu=b1.bind(this),this._onMouseWheel=_1.bind(this),this._onKeyDown=x1.bind(this),this._onTouchStart=y1.bind(this),this._onTouchMove=v1.bind(this),this._onMouseDown=m1.bind(this),this._onMouseMove=g1.bind(this),this._interceptControlDown=w1.bind(this),this._interceptControlUp=S1.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(h0),this.update(),this.state=Re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Mi.copy(e).sub(this.target),Mi.applyQuaternion(this._quat),this._spherical.setFromVector3(Mi),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=en:i>Math.PI&&(i-=en),s<-Math.PI?s+=en:s>Math.PI&&(s-=en),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mi.setFromSpherical(this._spherical),Mi.applyQuaternion(this._quatInverse),e.copy(this.target).add(Mi),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mi.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let h=new B(this._mouse.x,this._mouse.y,0);h.unproject(this.object),this.object.position.sub(h).add(a),this.object.updateMatrixWorld(),o=Mi.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Ec.origin.copy(this.object.position),Ec.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Ec.direction))<u1?this.object.lookAt(this.target):(c0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Ec.intersectPlane(c0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>wf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>wf||this._lastTargetPosition.distanceToSquared(this.target)>wf?(this.dispatchEvent(h0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?en/60*this.autoRotateSpeed*t:en/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Mi.setFromMatrixColumn(e,0),Mi.multiplyScalar(-t),this._panOffset.add(Mi)}_panUp(t,e){this.screenSpacePanning===!0?Mi.setFromMatrixColumn(e,1):(Mi.setFromMatrixColumn(e,0),Mi.crossVectors(this.object.up,Mi)),Mi.multiplyScalar(t),this._panOffset.add(Mi)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mi.copy(s).sub(this.target);let r=Mi.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(en*this._rotateDelta.x/e.clientHeight),this._rotateUp(en*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(en*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-en*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(en*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-en*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(en*this._rotateDelta.x/e.clientHeight),this._rotateUp(en*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function d1(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function f1(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function p1(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(u0),this.state=Re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function m1(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case qs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Re.DOLLY;break;case qs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Re.ROTATE}break;case qs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Sf)}function g1(n){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function _1(n){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(n.preventDefault(),this.dispatchEvent(Sf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(u0))}function x1(n){this.enabled!==!1&&this._handleKeyDown(n)}function y1(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ys.ROTATE:if(this.enableRotate===!1){this.state=Re.NONE;break}this._handleTouchStartRotate(n),this.state=Re.TOUCH_ROTATE;break;case Ys.PAN:if(this.enablePan===!1){this.state=Re.NONE;break}this._handleTouchStartPan(n),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case Ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Re.TOUCH_DOLLY_PAN;break;case Ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Sf)}function v1(n){switch(this._trackPointer(n),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Re.NONE}}function b1(n){this.enabled!==!1&&n.preventDefault()}function w1(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function S1(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Rc=40,Mf=5,Pc=class extends ma{constructor(t,e){let i=[];for(let o=-Rc;o<=Rc;o++)t(o)&&i.push(o);let s=new ti,r=new li(new Float32Array(12*i.length),3);s.setAttribute("position",r.setUsage($d)),super(s,e),this.numbers=i,this.points=r,this.frustumCulled=!1}cut([t,e,i],s,r){let{points:o,numbers:a}=this,l=0,h=(c,u,d,f)=>{let[_,w]=[(s-d)/u,(r-d)/u],m=Math.max(-Rc,Math.min(_,w)),p=Math.min(Rc,Math.max(_,w));if(m<p)for(let v of[m,p])o.setXYZ(l++,f?v:c,f?c:v,0)};for(let c of a)h(c,t,e*c+i,!0),h(c,e,t*c+i,!1);this.geometry.setDrawRange(0,l),o.needsUpdate=!0}},Ic=class{constructor(){this.mesh=new ge,this.minor=new vr,this.major=new vr,this.mesh.add(new Pc(t=>t%Mf!==0,this.minor),new Pc(t=>t%Mf===0,this.major)),this.toCamera=new Ce,this.setCell(.1)}setColours({line:t,minor:e}){this.major.color.set(t),this.minor.color.set(e)}setCell(t){this.tile=t*Mf,this.mesh.scale.setScalar(t)}moveTo(t,e){let i=s=>s-Math.round(s/this.tile)*this.tile;this.mesh.position.set(i(t),i(e),0)}cutFor(t,e){let{elements:i}=this.toCamera.multiplyMatrices(t.matrixWorldInverse,this.mesh.matrixWorld);for(let s of this.mesh.children)s.cut([-i[2],-i[6],-i[14]],t.near,Math.min(e.far,t.far))}};var d0=28,M1=42,A1=12,T1=.75,E1=.5,f0=350,C1={light:{sky:15330544,line:12173770,minor:14015200,ambient:1.15,lift:0},dark:{sky:1711651,line:3949904,minor:2764856,ambient:1.9,lift:.07}};function R1(n){let t=n.getExtension("WEBGL_debug_renderer_info"),e=t?n.getParameter(t.UNMASKED_RENDERER_WEBGL):"";return/swiftshader|llvmpipe|software|softpipe|basic render/i.test(e)}function P1(){let n=document.createElement("canvas"),t=n.getContext("webgl2",{stencil:!0,antialias:!1,alpha:!1});if(!t)throw new Error("This browser shows no 3-D pictures: WebGL 2 is off or missing.");let e=R1(t);return e?{renderer:new Wa({canvas:n,context:t}),software:e}:(t.getExtension("WEBGL_lose_context")?.loseContext(),{renderer:new Wa({antialias:!0,stencil:!0}),software:e})}var I1=n=>new Me().setFromUnitVectors(n,new B(0,0,1)),Lc=class{constructor(t){this.host=t;let{renderer:e,software:i}=P1();this.renderer=e,this.software=i,this.canvas=e.domElement,t.append(this.canvas),this.scene=new da,this.scene.fog=new ua(0,1,2),this.scene.matrixWorldAutoUpdate=!1,this.tilted=new ge,this.world=new ge,this.ground=new Ic,this.tilted.add(this.world,this.ground.mesh),this.scene.add(this.tilted),this.up=new B(0,0,1),this.addLights(),this.camera=new Zi(32,1,.01,200),this.camera.up.set(0,0,1),this.controls=new Cc(this.camera,this.canvas),this.controls.enableDamping=!1,this.controls.maxPolarAngle=Math.PI*.495,this.controls.addEventListener("change",()=>this.touch()),this.controls.addEventListener("start",()=>this.turned=!0),this.turned=!1,this.before=[],this.after=new Set,this.size=.5,this.drawnAt=-d0,this.pace={count:0,sum:0},this.coarse=!1,this.held=!1,this.drawn=0,this.fine=!1,this.dirty=!0,this.touched=0,this.observer=new ResizeObserver(()=>this.resize()),this.observer.observe(t),this.setTheme("light"),this.resize(),this.frame=requestAnimationFrame(s=>this.tick(s))}addLights(){this.ambient=new Pa(16777215,.5);let t=new Ta(16777215,8949920,1);t.position.set(0,0,1);let e=new Ra(16777215,1.9);e.position.set(.35,-.5,1.6),this.sun=e.position.clone().normalize(),this.scene.add(this.ambient,t,e)}setTheme(t){let e=C1[t];this.theme=t,this.scene.background=new ie(e.sky),this.scene.fog.color.set(e.sky),this.ambient.intensity=.5*e.ambient,ff.value=e.lift,this.ground.setColours(e),this.touch()}setUp([t,e,i]){t===this.up.x&&e===this.up.y&&i===this.up.z||(this.up.set(t,e,i),this.tilted.quaternion.copy(I1(this.up)),this.touch())}frameRobot(t,e){this.size=t,this.home=new B(0,0,e*.4),this.ground.setCell(t>1.5?.5:t>.6?.25:.1),this.scene.fog.near=t*2.5,this.scene.fog.far=t*9,this.camera.near=t/60,this.camera.far=t*60,this.controls.minDistance=t*.3,this.controls.maxDistance=t*14,this.view("corner")}view(t){let e={corner:[1.25,1.15,.8],side:[0,1.9,.25],front:[1.9,0,.25],top:[-.01,0,2.1]}[t];this.controls.target.copy(this.home??new B),this.camera.position.fromArray(e).multiplyScalar(this.size*1.45*Math.max(1,1.15/this.camera.aspect)).add(this.controls.target),this.camera.updateProjectionMatrix(),this.controls.update(),this.touch()}orbit(t,e){let i=this.camera.position.clone().sub(this.controls.target),s=i.length(),r=Math.atan2(i.y,i.x)+t,o=Math.PI/2-this.controls.maxPolarAngle,a=Math.min(1.55,Math.max(o,Math.asin(i.z/s)+e));i.set(s*Math.cos(a)*Math.cos(r),s*Math.cos(a)*Math.sin(r),s*Math.sin(a)),this.camera.position.copy(this.controls.target).add(i),this.controls.update(),this.touch()}zoom(t){let e=this.camera.position.clone().sub(this.controls.target).multiplyScalar(t);this.camera.position.copy(this.controls.target).add(e),this.controls.update(),this.touch()}touch(){this.dirty=!0,this.touched=performance.now()}ratio(){return this.software?this.fine?2:this.held?E1:this.coarse?T1:1:Math.min(devicePixelRatio,2)}setHeld(t){this.held!==t&&(this.held=t,this.software&&!this.fine&&this.setFine(!1))}resize(){let{clientWidth:t,clientHeight:e}=this.host;[this.wide,this.tall]=[t,e],this.shown=t>0,!(!t||!e)&&(this.renderer.setPixelRatio(this.ratio()),this.renderer.setSize(t,e),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.touch())}tick(t){if(this.frame=requestAnimationFrame(e=>this.tick(e)),!(!this.shown||this.software&&t-this.drawnAt<d0)){for(let e of this.before)e(t);this.dirty?(this.fine?this.setFine(!1):this.software&&!this.coarse&&this.watchPace(t-this.drawnAt),this.drawnAt=t,this.draw()):this.software&&!this.fine&&t-this.touched>f0&&(this.setFine(!0),this.draw())}}watchPace(t){let{pace:e}=this;t>f0?e.count=e.sum=0:(e.count++,e.sum+=t),!(e.count<A1)&&(this.coarse=e.sum>M1*e.count,e.count=e.sum=0,this.coarse&&this.setFine(!1))}setFine(t){this.fine=t,this.renderer.setPixelRatio(this.ratio())}pixel(){let{camera:t,controls:e}=this;return 2*Math.tan(t.fov*Math.PI/360)*t.position.distanceTo(e.target)/Math.max(1,this.canvas.height)}draw(){this.dirty=!1,this.refine?.(this.pixel()),this.scene.updateMatrixWorld(),this.camera.updateMatrixWorld(),this.ground.cutFor(this.camera,this.scene.fog),this.renderer.render(this.scene,this.camera),this.drawn++,this.onDrawn?.();for(let t of this.after)t()}picture(){for(let t of this.before)t(performance.now());return this.software&&!this.fine&&this.setFine(!0),this.draw(),this.canvas.toDataURL("image/png")}dispose(){cancelAnimationFrame(this.frame),this.observer.disconnect(),this.controls.dispose(),this.renderer.dispose(),this.canvas.remove()}};var L1=new ie(8097023),D1=.9,N1=.55,er=class{constructor(t,{meshSource:e}={}){this.stage=new Lc(t),this.labels=document.createElement("div"),this.labels.className="scene-labels",t.append(this.labels);let i={meshSource:e,changed:()=>this.stage.touch()};this.robot=new tr(i),this.ghost=new tr({...i,ghost:.32,tint:L1}),this.neighbour=new tr(i);for(let s of[this.ghost,this.neighbour])s.root.visible=!1;this.other=this.ghost,this.planned=new Js(2067056),this.measured=new Js(15238942),this.pushArrow=new Js(12720219),this.footprints=new yc,this.hurdles=new bc,this.handles=new vc,this.marks=new wc(this.labels),this.tag=new Sc(this.labels),this.slopeTag=new Tc(this.labels),this.bounds=new xc(i),this.shadow=new Ac(this.stage.sun),this.walker=new ge,this.walker.add(this.robot.root,this.footprints.root,this.handles.root),this.walker.add(this.ghost.root,this.neighbour.root,this.bounds.root,this.hurdles.root);for(let s of[this.planned,this.measured,this.pushArrow,this.marks])this.walker.add(s.root);this.stage.world.add(this.walker),this.stage.tilted.add(this.shadow.root),this.show={forces:!0,paths:!0,faults:!0,follow:!0},this.margin=1,this.playing=!0,this.speed=1,this.time=0,this.live=null,this.pointed=[],this.recording=new Mc,this.readParameter=()=>({value:0,lower:0,upper:0,locked:!1}),this.offset=new B,this.stage.before.push(s=>this.advance(s)),this.stage.refine=s=>this.refine(s)}setTheme(t){this.shadow.setTheme(t),this.stage.setTheme(t)}setSpeed(t){this.speed=t,this.onSpeed?.()}setDesign(t){this.design=t,this.dress(),this.findSoles=null,this.stage.touch()}setMotion(t){let e=this.player?this.player.at(this.time):{cycle:0,phase:0};this.player=new Qs(t),this.time=(e.cycle+e.phase)*this.player.period,this.poses=new Float32Array(7*this.player.bodyCount),this.findSoles=null,this.dress(),this.stage.touch()}dress(){if(!this.design)return;let t=this.player?.motion.extra??[],{design:e}=this;this.robot.setDesign(t.length?{...e,geoms:[...e.geoms,...t]}:e)}setGhost(t,{beside:e=!1}={}){let i=this.besides()!==(e&&!!t);this.other.root.visible=!1,this.other=e?this.neighbour:this.ghost,this.other.root.visible=!!t,this.ghostPlayer=null,this.tagged=e&&t?.name||"",t&&(this.other.setDesign(t.design),t.motion&&(this.ghostPlayer=new Qs(t.motion),this.ghostPoses=new Float32Array(7*this.ghostPlayer.bodyCount))),i&&this.framed&&!this.stage.turned&&this.fit(),this.pose()}setBounds(t){this.bounds.set(t),this.pose()}besides(){return this.other===this.neighbour&&this.neighbour.root.visible}lane(){return this.besides()?D1*this.size:0}setLive(t){this.live=t,this.pose()}pointAt(t){this.pointed=t,this.pose()}seekPhase(t){if(!this.player)return;let{cycle:e}=this.player.at(this.time);this.seek((e+Math.min(Math.max(t,0),.999999))*this.player.period)}seek(t){this.time=t,this.pose()}setPlaying(t){this.playing=t,this.last=null,this.onPlaying?.(t)}playRecording(t){let{recording:e}=this,i=Math.min(e.end,e.at+t);this.seekRecording(i),i===e.end&&this.setPlaying(!1)}seekRecording(t){let e=!this.recording.shown;this.setLive(this.recording.show(t)),e&&this.onRecording?.()}leaveRecording(){this.recording.shown=!1,this.setLive(null)}phase(){return this.player?this.player.at(this.time).phase:0}advance(t){let e=this.last?Math.min((t-this.last)/1e3,.2):0;this.playing&&this.recording.shown?this.playRecording(e*this.speed):this.playing&&this.player&&!this.live?(this.time+=e*this.speed,this.pose()):this.stage.dirty&&this.pose(),this.last=t}refine(t){for(let i of[this.robot,this.other,this.bounds])i.setPixel(t);let e=this.besides()?this.neighbour.meshes:[];this.shadow.follow([...this.robot.meshes,...e])}pose(){if(this.stage.touch(),!this.design||!(this.player||this.live))return;let t=this.live?.poses??this.player.sample(this.time,this.poses);this.robot.setPoses(t),this.stage.setUp(this.live?.up??this.player?.motion.up??[0,0,1]),this.framed||this.frame(),this.follow(t),this.poseGhost(),this.bounds.pose(this.live?null:this.player,this.time),this.drawForces(t),this.drawFeet(t),this.stage.scene.updateMatrixWorld();let{camera:e,tall:i}=this.stage;this.handles.update(this.robot,e,i,this.size,this.readParameter),this.drawFaults(),this.tagNeighbour(e),this.slopeTag.show(this.stage.up,this.player?.advance??[1,0,0]),this.onPose?.()}frame(){this.framed=!0,this.stage.turned=!1,this.fit(),this.robot.complete().then(()=>this.stage.turned||this.fit())}fit(){let{size:t,height:e}=i0(this.robot);this.size=t,this.height=e;for(let i of[this.planned,this.measured,this.pushArrow])i.thickness=t*.011;this.stage.frameRobot(this.margin*t+.6*this.lane(),e)}follow(t){this.show.follow?this.live?this.offset.set(t[7]??0,t[8]??0,0):this.player.path(this.time,this.offset):this.offset.set(0,0,0),this.walker.position.copy(this.offset).negate(),this.walker.position.y+=this.lane()/2,this.stage.ground.moveTo(-this.offset.x,-this.offset.y)}poseGhost(){let{other:t}=this;if(!t.root.visible)return;let e=t.root.position.set(0,-this.lane(),0);if(!this.ghostPlayer)return t.setPoses(this.live?.poses??this.poses);let{cycle:i,phase:s}=this.player?.at(this.time)??{cycle:0,phase:0},r=(i+s)*this.ghostPlayer.period;t.setPoses(this.ghostPlayer.sample(r,this.ghostPoses)),e.add(this.offset).sub(this.ghostPlayer.path(r,new B))}tagNeighbour(t){if(!this.besides())return this.tag.show("");let e=this.neighbour.groups[1]??this.neighbour.root;this.tag.show(this.tagged,e,.4*this.height,t)}drawForces(t){if(this.planned.clear(),this.measured.clear(),this.pushArrow.clear(),this.push&&(this.robot.place(this.push.body,this.push.at,this.pushFrom??=new B),this.pushArrow.add(this.pushFrom,this.push.along)),!this.show.forces||!this.player)return;let e=this.forceScale(),[i,s]=[new B,new B];if(this.live){for(let{at:r,force:o,planned:a}of this.live.feet??[])this.measured.add(i.fromArray(r),s.fromArray(o).multiplyScalar(e)),a&&this.planned.add(i,s.fromArray(a).multiplyScalar(e));return}this.player.feet.forEach((r,o)=>{this.soles()(t,o,i),this.planned.add(i,this.player.force(this.time,o,s).multiplyScalar(e))})}forceScale(){let{player:t}=this;if(t.weight===void 0){let e=0;for(let i=2;i<t.forces.length;i+=3)e+=t.forces[i];t.weight=e/Math.max(t.frames,1)}return t.weight>0?N1*this.size/t.weight:0}soles(){return this.findSoles||(this.findSoles=n0(this.design,this.player),this.footprints.setMotion(this.player,this.findSoles),this.hurdles.setMotion(this.player,this.findSoles,this.size)),this.findSoles}drawFeet(t){let{root:e}=this.footprints;e.visible=!!(this.show.paths&&this.player&&!this.live),this.hurdles.root.visible=e.visible,e.visible&&(this.soles(),this.footprints.update(this.player,this.time,t,this.size*.032),this.hurdles.update(this.player,this.time))}drawFaults(){let i=(this.show.faults&&this.player&&!this.live&&!this.pointed.length?this.player.faultsAt(this.time):this.pointed).map(s=>({at:this.placeOf(s,new B),words:s.words}));this.marks.show(i,this.size*.045,this.stage)}placeOf({body:t,at:e,where:i},s){let r=this.live?.feet?.find(a=>a.name===i);if(r)return s.fromArray(r.at);let o=this.live?-1:this.player.feet.findIndex(a=>a.name===i);return o>=0?this.soles()(this.poses,o,s):this.robot.place(typeof t=="number"?t:1,e??[0,0,0],s)}dispose(){this.stage.dispose(),this.labels.remove()}};var F1=new Fn(1,14,10),U1=8,p0={idle:2067056,aimed:15238942},Dc=class{constructor(t){this.root=new ge,this.all=[],this.label=document.createElement("div"),this.label.className="spot-label",this.label.hidden=!0,t.append(this.label),this.layer=t}set(t,e){for(;this.all.length>t.length;){let{mesh:i}=this.all.pop();this.root.remove(i),i.material.dispose()}for(;this.all.length<t.length;){let i=new pn({depthTest:!1,transparent:!0,fog:!1}),s=new Ae(F1,i);s.renderOrder=11,this.root.add(s),this.all.push({mesh:s,centre:new B})}t.forEach((i,s)=>{this.all[s].spot=i;let r=i.id===e;this.all[s].mesh.material.color.set(r?p0.aimed:p0.idle),this.all[s].mesh.material.opacity=r?1:.8}),this.aimed=e}update(t,e){let{clientWidth:i,clientHeight:s}=this.layer,r=2*Math.tan(e.fov*Math.PI/360)/Math.max(s,1);this.label.hidden=!0;for(let{mesh:o,spot:a,centre:l}of this.all){t.place(1,a.at,o.position),l.copy(o.position).applyMatrix4(this.root.matrixWorld);let h=U1*(a.id===this.aimed?1.4:1);if(o.scale.setScalar(h*r*e.position.distanceTo(l)),a.id!==this.aimed)continue;let c=js(l,e,i,s);this.label.hidden=!1,this.label.textContent=a.words,this.label.style.transform=`translate(${c.x+16}px, ${c.y-10}px)`}}near(t,e,i,s){let{clientWidth:r,clientHeight:o}=this.layer,a=null,l=i;for(let{spot:h,centre:c}of this.all){let u=js(c,s,r,o),d=Math.hypot(u.x-t,u.y-e);d<l&&u.depth<1&&([a,l]=[h,d])}return a}};var m0={x:new B(1,0,0),y:new B(0,1,0),z:new B(0,0,1)},g0=5e-4,_0=Math.PI/36,O1=.3,k1=.995,B1=1.25,z1=.2,G1=.16,V1=60,Af=n=>Math.round(n*1e6)/1e6;function Tf(n,t){let e=n.find(t);if(t.startsWith("part/"))return{key:"position",item:t,value:e.at};if(t.endsWith("/foot"))return{key:"offset",item:t,value:e.offset};let i=n.limbOf(t);return i?t===i.item||t===i.joints[0].item?{key:"hip",item:i.item,value:i.hip}:{key:"offset",item:t,value:e.offset}:null}var Nc=class{constructor(t){this.client=t,this.element=g("div.stage"),this.draft=null}begin(){if(this.view)return;let{client:t}=this;this.view=new er(this.element,{meshSource:t.studio.meshSource});let{canvas:e}=this.view.stage;e.tabIndex=0,e.setAttribute("role","img"),e.setAttribute("aria-label","The robot in 3-D. Arrow keys turn the camera."),this.view.margin=B1,this.spots=new Dc(this.view.labels),this.axes=new Js(3112912),this.view.walker.add(this.spots.root,this.axes.root),this.view.readParameter=i=>this.read(i),this.view.onPose=()=>this.overlay(),e.addEventListener("pointermove",i=>this.hoverSpot(i),{capture:!0}),e.addEventListener("click",i=>this.clickSpot(i),{capture:!0}),new So(this.view,{hover:i=>{this.view.handles.hovered=i,this.view.pose()},drag:(i,s,r)=>this.drag(i,s,r),pick:(i,s,r)=>this.pick(i,r),push:()=>{}}),Ds(i=>this.view.setTheme(i))}show(){let{told:t}=this.client;this.begin();let{view:e}=this,i=t.design.bodies.length;i!==this.layout&&!e.stage.turned&&(e.framed=!1),this.layout=i,e.setDesign(t.design),e.setLive({poses:An(t.design.poses),feet:[]}),this.placeHandles(),this.highlight()}placeHandles(){if(!this.view)return;let{client:t,view:e}=this,{bodies:i}=t.told.design,s=t.find(t.selected),r=Tf(t,t.selected),o=s.at??t.limbOf(t.selected)?.joints[0].at,a=s.axis&&new B().fromArray(s.axis),l=[];for(let[h,c]of Object.entries(m0)){let u=c.toArray(),d=o&&o.map((f,_)=>f+z1*e.size*u[_]);r&&l.push({name:h,handle:{kind:"move",body:1,at:d,direction:u}}),a&&Math.abs(a.dot(c))<k1&&l.push({name:`turn ${h}`,handle:{kind:"turn",body:1,at:o,direction:u}})}e.handles.setParameters(t.carried?[]:l,i),e.handles.selected=new Set(["turn x","turn y","turn z"])}highlight(){let{selected:t,told:e}=this.client,i=this.client.find(t)?.joints?`${t}/`:null,s=e.items.map((r,o)=>r===t||i&&r.startsWith(i)?o:-1).filter(r=>r>0);this.view.robot.highlight(t==="trunk"?[]:s),this.view.pose()}read(t){let e=(r,o)=>({value:r,lower:r-o,upper:r+o});if(t.startsWith("turn"))return e(this.draft?.name===t?this.draft.value:0,7);let i=Tf(this.client,this.client.selected),s=i?i.value["xyz".indexOf(t)]:0;return{...e(s,O1),locked:!1}}drag(t,e,i){let{client:s}=this;if(i==="begin"){s.begin();let r=s.selected;this.held={item:r,place:Tf(s,r),axis:s.find(r).axis}}else if(i==="drag"){if(!this.held||!s.find(this.held.item))return;this.draft={name:t,value:e},t.startsWith("turn")?this.turnAxis(m0[t.at(-1)],e):this.move("xyz".indexOf(t),e)}else i==="cancel"?this.cancelDrag():this.letGo()}letGo(){this.held=this.draft=null,this.view.pose()}cancelDrag(){if(!this.held)return!1;let{item:t,place:e,axis:i}=this.held;return this.draft?.name.startsWith("turn")?this.client.drag(t,"axis",i):this.draft&&this.client.drag(e.item,e.key,e.value),this.letGo(),!0}move(t,e){let{place:i}=this.held,s=i.value.map(Af);s[t]=Af(Math.round(e/g0)*g0),this.client.drag(i.item,i.key,s)}turnAxis(t,e){let i=Math.round(e/_0)*_0,s=new B().fromArray(this.held.axis).applyAxisAngle(t,i);this.client.drag(this.held.item,"axis",s.toArray().map(Af))}pick(t,e){if(this.client.carried||t===null)return;let i=this.client.told.items[t],s=i&&this.client.limbOf(i),r=s?.joints.at(-1).item===i;this.client.select(r&&e?.name?s.foot.item:i||"trunk")}spotAt(t){let e=this.view.stage.canvas.getBoundingClientRect(),[i,s]=[t.clientX-e.left,t.clientY-e.top];return i<0||s<0||i>e.width||s>e.height?null:this.spots.near(i,s,V1,this.view.stage.camera)}hoverSpot(t){this.client.carried&&this.client.aim(this.spotAt(t)?.id??null)}clickSpot(t){let e=this.client.carried&&this.spotAt(t);e&&this.client.put(e.id)}overlay(){let{client:t,view:e}=this;if(!t.told)return;this.spots.set(t.spots(),t.aimed),this.spots.update(e.robot,e.stage.camera),this.axes.thickness=.006*e.size,this.axes.clear();let[i,s]=[new B,new B];for(let r of t.told.limbs.flatMap(o=>o.joints)){let o=r.item===t.selected?1.6:1;s.fromArray(r.axis).multiplyScalar(G1*o*e.size),this.axes.add(e.robot.place(1,r.at,i),s)}}follow(t){!this.view||!this.client.told||((t==="selected"||t==="carried")&&(this.placeHandles(),this.highlight()),t==="aimed"&&this.view.pose())}};var H1={x:[1,0,0],y:[0,1,0],z:[0,0,1]},Ao=n=>String(Math.round(n*1e6)/1e6),Fc=class{constructor(t){this.client=t,this.title=g("h2"),this.body=g("div.item-form"),this.element=g("section.panel",{aria:{label:"What is selected"}},this.title,this.body)}show(){let{client:t}=this,{selected:e}=t,i=t.find(e),{activeElement:s}=document,o=this.shownItem===e&&this.body.contains(s)&&s.dataset.field;this.fillIn(e,i),o&&this.body.querySelector(`[data-field="${o}"]`)?.focus(),this.shownItem=e}async set(t,e,i){await this.client.set(t,e,i)||this.fillInAgain(t)}fillInAgain(t){let e=this.client.find(t);e&&this.shownItem===t&&this.fillIn(t,e)}fillIn(t,e){let[i,s]=this.rowsOf(t,e);Gt(this.title,i),Gt(this.body,s)}rowsOf(t,e){return t==="trunk"?["Trunk",this.trunk(e)]:t.startsWith("part/")?[e.module,[this.vector(t,"position","m",e.at),this.remove(t)]]:t.endsWith("/foot")?["Foot",this.foot(t,e)]:e.joints?[`Limb ${e.names.join(", ")}`,this.limb(t,e)]:[`Joint ${e.name}`,this.joint(t,e)]}trunk({module:t,size:e,mass:i}){let{name:s}=this.client.told,r=[this.text("trunk","name","name of the robot",s)];return t?r.push(g("p.hint",{},`The module ${t}, ${Ao(1e3*i)} g.`)):r.push(this.vector("trunk","size","m",e,"length, width, height"),this.number("trunk","mass","kg",i)),r}foot(t,{module:e,offset:i}){return[this.module(t,"foot",e),this.vector(t,"offset","m",i,"from the last joint")]}limb(t,{names:e,hip:i,mirror:s,copies:r,step:o}){let a=()=>this.client.carry({name:`Like ${e[0]}`,item:t}),l=[this.field("names",g("input",{type:"text",value:e.join(", "),data:{field:"names"},onChange:({target:h})=>this.set(t,"names",h.value.split(/[\s,]+/).filter(Boolean))})),this.vector(t,"hip","m",i,"of the first joint, in the trunk"),this.field("mirror image",g("input",{type:"checkbox",checked:s,data:{field:"mirror"},onChange:({target:h})=>this.set(t,"mirror",h.checked)})),this.number(t,"copies","",r,1)];return r>1&&l.push(this.vector(t,"step","m",o,"from one to the next")),l.push(g("div.button-row",{},g("button",{type:"button",onClick:a},"Another like it…"),this.removeButton(t))),l}joint(t,e){let{name:i,link:s,servo:r,axis:o,offset:a,roll:l,range:h,servo_range:c,torque:u}=e,d=`Torque at most ${Ao(u)} N m`,f=e.linear?`${d} as drawn. Lever and mount of a linear actuator are set in the file.`:`${d}.`,_=this.client.limbOf(t).joints[0].item===t,w=Object.entries(H1).map(([m,p])=>g("button.small",{type:"button",onClick:()=>this.set(t,"axis",p)},m));return[this.text(t,"name","name",i),this.text(t,"link","link that it moves",s),this.module(t,"servo",r,_?["servo"]:["servo","linear"]),g("p.hint",{},f),this.vector(t,"axis","",o,"the horn looks along it"),g("div.button-row",{},w),_?"":this.vector(t,"offset","m",a,"from the joint above"),this.number(t,"roll","rad",l),this.range(t,h,c),this.remove(t)]}range(t,e,i){let s=[0,1].map(r=>g("input",{type:"number",step:"any",value:e?Ao(e[r]):"",placeholder:i?Ao(i[r]):"free",aria:{label:`${r?"largest":"least"} angle`},data:{field:`range ${r}`},onChange:()=>{let o=s.map(a=>a.valueAsNumber);o.every(Number.isFinite)?this.set(t,"range",o):o.every(Number.isNaN)&&this.set(t,"range",null)}}));return this.field("range [rad]",g("span.three",{},s))}module(t,e,i,s=[e]){let o=(this.modules??[]).filter(h=>s.includes(h.kind)).map(h=>h.name);o.includes(i)||o.unshift(i);let a=o.map(h=>g("option",{value:h,selected:h===i},h)),l=({target:h})=>this.client.replace(t,h.value);return this.field(e,g("select",{data:{field:e},onChange:l},a))}vector(t,e,i,s,r=""){let o=s.map((l,h)=>g("input",{type:"number",step:i==="m"?.005:"any",value:Ao(l),aria:{label:`${e} ${"xyz"[h]}`},data:{field:`${e} ${h}`},onChange:()=>{let c=o.map(u=>u.valueAsNumber);c.every(Number.isFinite)?this.set(t,e,c):this.fillInAgain(t)}})),a=i?`${e} [${i}]`:e;return this.field(a,g("span.three",{},o),r)}number(t,e,i,s,r="any"){let o=g("input",{type:"number",step:r,value:Ao(s),data:{field:e},onChange:()=>Number.isFinite(o.valueAsNumber)?this.set(t,e,o.valueAsNumber):this.fillInAgain(t)});return this.field(i?`${e} [${i}]`:e,o)}text(t,e,i,s){let r=({target:o})=>this.set(t,e,o.value.trim());return this.field(i,g("input",{type:"text",value:s,data:{field:e},spellcheck:!1,onChange:r}))}field(t,e,i=""){return g("label.field",{title:i},g("span",{},t),e)}remove(t){return g("div.button-row",{},this.removeButton(t))}removeButton(t){return g("button",{type:"button",onClick:()=>this.client.obey({do:"remove",item:t})},"Remove (delete)")}};var Uc=class{constructor(t){this.client=t,this.list=g("ul.outline"),this.element=g("section.panel",{aria:{label:"Robot"}},g("h2",{},"Robot"),this.list),this.list.addEventListener("keydown",e=>this.key(e))}show(){let{trunk:t,parts:e,limbs:i}=this.client.told,s=this.list.contains(document.activeElement);this.buttons=[],Gt(this.list,this.row("trunk","Trunk",t.module??"a box",0),e.map(({item:r,module:o})=>this.row(r,o,"on the trunk",1)),i.map(r=>this.rowsOf(r))),this.mark(),s&&this.focusSelected()}rowsOf({item:t,names:e,mirror:i,joints:s,foot:r}){let o=i?e.flatMap(a=>[`${a}L`,`${a}R`]):e;return[this.row(t,`Limb ${e.join(", ")}`,o.join(" "),0),s.map(a=>this.row(a.item,a.name,a.servo,1)),this.row(r.item,"foot",r.module,1)]}row(t,e,i,s){let r=g(`button.outline-row.depth-${s}`,{type:"button",data:{item:t},onClick:()=>this.client.select(t)},g("span",{},e),g("small",{},i));return this.buttons.push(r),g("li",{},r)}mark(){for(let t of this.buttons)t.setAttribute("aria-pressed",String(t.dataset.item===this.client.selected))}focusSelected(){this.buttons.find(t=>t.dataset.item===this.client.selected)?.focus()}key(t){let e={ArrowDown:1,ArrowUp:-1}[t.key];if(!e)return;t.preventDefault();let i=this.buttons.indexOf(document.activeElement),s=this.buttons[(i+e+this.buttons.length)%this.buttons.length];this.client.select(s.dataset.item),s.focus()}};var To=class{constructor({width:t,height:e,theme:i,meshSource:s}){this.host=document.createElement("div"),this.host.className="still-host",Object.assign(this.host.style,{width:`${t}px`,height:`${e}px`}),document.body.append(this.host),this.meshSource=s,this.theme=i}async draw(t){this.view??=new er(this.host,{meshSource:this.meshSource});let{view:e}=this;return e.setTheme(this.theme),e.framed=!1,e.setDesign(t),await e.robot.complete(),e.setLive({poses:An(t.poses),feet:[]}),e.stage.picture()}dispose(){this.view?.dispose(),this.host.remove()}};var W1={servo:"Servos",linear:"Linear actuators",foot:"Feet",trunk:"Trunks",battery:"Batteries",computer:"Computers",payload:"Payloads"},X1=6;function $1(n){let{kind:t,mass:e,stall_torque:i,no_load_speed:s}=n,r=(l,h)=>`${We(l,3)} ${h}`.replaceAll(" "," "),o=r(1e3*e,"g");if(t==="linear"){let{max_force:l,stroke:h,rod_speed:c}=n,u=c?`, ${r(1e3*c,"mm/s")}`:"";return`${r(l,"N")}${u}, ${r(1e3*h,"mm")}, ${o}`}if(t!=="servo")return o;let a=s?`, ${r(s,"rad/s")}`:"";return`${r(i,"N m")}${a}, ${o}`}var Oc=class{constructor(t,e){this.client=t,this.scene=e,this.list=g("div.palette"),this.filter=g("input.wide",{type:"search",placeholder:"Find a module",aria:{label:"Find a module"},onInput:()=>this.show()}),this.element=g("section.panel",{},g("h2",{},"Modules"),this.filter,this.list),this.ghost=g("div.carried-ghost",{hidden:!0}),document.body.append(this.ghost)}async load(){this.modules||(this.modules=(await this.client.studio.act(()=>_i("/api/modules")))?.modules??[],this.cards=new Map(this.modules.map(t=>[t.name,this.card(t)])),this.show(),Ds(()=>this.drawPictures()))}show(){let t=this.filter.value.trim().toLowerCase(),e=({name:r,maker:o,kind:a})=>`${r} ${o} ${a}`.toLowerCase().includes(t),i=Object.entries(W1).map(([r,o])=>{let a=this.modules.filter(l=>l.kind===r&&e(l));return a.length?[g("h3",{},o),g("ul",{},a.map(({name:l})=>this.cards.get(l)))]:""}),s=t&&i.every(r=>r==="");Gt(this.list,s?g("p.hint",{},"No module has this in its name, maker or kind."):i)}card(t){let{name:e,about:i}=t,s=g("img",{alt:"",draggable:!1,data:{module:e}}),r=g("button.module-card",{type:"button",title:i,data:{module:e}},s,g("span",{},g("strong",{},e),g("small",{},$1(t))));return r.addEventListener("pointerdown",o=>this.press(o,t,r)),r.addEventListener("click",()=>{this.dragged||this.client.carry(t),this.dragged=!1}),g("li",{},r)}press(t,e,i){if(t.button!==0)return;let s=t;this.dragged=!1,i.setPointerCapture(t.pointerId);let r=a=>{let l=Math.hypot(a.clientX-s.clientX,a.clientY-s.clientY);this.dragged&&!this.client.carried&&(this.ghost.hidden=!0),!(this.dragged?!this.client.carried:l<X1)&&(this.dragged||this.client.carry(e,{dragged:!0}),this.dragged=!0,this.showGhost(e.name,a),this.scene.hoverSpot(a))},o=a=>{if(i.removeEventListener("pointermove",r),this.ghost.hidden=!0,!this.dragged)return;let l=a.type==="pointerup"&&this.client.carried&&this.scene.spotAt(a);l?this.client.put(l.id):this.client.carry(null),a.type!=="pointerup"&&(this.dragged=!1)};i.addEventListener("pointermove",r);for(let a of["pointerup","pointercancel"])i.addEventListener(a,o,{once:!0})}showGhost(t,{clientX:e,clientY:i}){this.ghost.hidden=!1,this.ghost.textContent=t,this.ghost.style.transform=`translate(${e+12}px, ${i+8}px)`}async drawPictures(){let t=this.drawing={},{meshSource:e}=this.client.studio,i=new To({width:128,height:96,theme:lr(),meshSource:e});for(let[s,r]of this.cards){let o=r.querySelector("img");try{o.src=await i.draw(await _i(`/api/module?name=${encodeURIComponent(s)}`))}catch{o.classList.add("no-picture")}if(await new Promise(a=>setTimeout(a)),this.drawing!==t)break}i.dispose()}},kc=class{constructor(t){this.client=t,this.element=g("section.place-list",{hidden:!0,aria:{label:"Where it goes"}}),this.element.addEventListener("keydown",e=>this.key(e)),t.on(e=>{(e==="carried"||e==="assembly")&&this.show(),e==="aimed"&&this.mark()})}show(){let{carried:t,dragged:e}=this.client,i=this.element.hidden;if(this.element.hidden=!t||e,this.element.hidden)return;let s=this.client.spots();this.buttons=s.map(({id:r,words:o})=>g("button",{type:"button",data:{spot:r},onFocus:()=>this.client.aim(r),onPointerenter:()=>this.client.aim(r),onClick:()=>this.client.put(r)},o)),Gt(this.element,g("h2",{},`${t.name}: where?`),s.length?g("div.place-buttons",{},this.buttons):g("p",{},"Nothing takes it yet."),g("button.link",{type:"button",onClick:()=>this.client.carry(null)},"Put it away (escape)")),i&&this.buttons[0]?.focus()}mark(){if(!this.element.hidden)for(let t of this.buttons)t.classList.toggle("aimed",t.dataset.spot===this.client.aimed)}key(t){let e={ArrowDown:1,ArrowUp:-1}[t.key];if(!e)return;t.preventDefault();let s=(this.buttons.indexOf(document.activeElement)+e+this.buttons.length)%this.buttons.length;this.buttons[s]?.focus()}};var q1="drag a servo from the palette onto the trunk, where it begins a leg",Y1={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]},Bc=class{constructor(t){this.studio=t,this.client=t.assembly=new fl(t),this.scene=t.assemblyScene=new Nc(this.client),this.palette=new Oc(this.client,this.scene),this.outline=new Uc(this.client),this.form=new Fc(this.client),this.summary=g("div.scene-hint"),this.tools=g("div.scene-tools");let e=g("main.middle",{aria:{label:"Robot"}},this.scene.element,this.tools,new kc(this.client).element,this.summary);this.element=g("div.assembly",{hidden:!0},this.topBar(),g("div.panes",{},g("aside.side.left",{aria:{label:"Palette"}},this.palette.element),e,g("aside.side.right",{},this.outline.element,this.form.element))),this.client.on(i=>this.follow(i)),addEventListener("keydown",i=>this.key(i))}topBar(){let t=()=>this.client.obey({do:"undo"}),e=()=>this.client.obey({do:"redo"});return this.undo=an("undo","Undo (ctrl z)",t),this.redo=an("redo","Redo (ctrl shift z)",e),this.title=g("span.document-name"),g("header.top-bar",{},g("span.brand",{},"Legwright"),g("button",{type:"button",onClick:()=>this.studio.showStart()},"Open another…"),g("button",{type:"button",onClick:()=>this.save()},"Save…"),this.title,g("span.spring"),g("div.segmented",{role:"group",aria:{label:"History"}},this.undo,this.redo),g("button.primary",{type:"button",onClick:()=>this.build()},"Build and design"),an("sun","Light or dark",yl))}async load(){this.shown=!0,this.client.told&&this.follow("assembly"),await this.palette.load(),this.form.modules=this.palette.modules,this.client.told&&this.form.show()}follow(t){this.element.hidden||(t==="assembly"?(this.showTold(),this.scene.show()):this.scene.follow(t),t==="selected"&&(this.outline.mark(),this.form.show()))}showTold(){let{name:t,mass:e,servos:i,path:s,can_undo:r,can_redo:o}=this.client.told;Kt(this.title,t),this.title.title=s??"",this.undo.disabled=!r,this.redo.disabled=!o;let a=`${We(e,3)} kg, ${i} servo${i===1?"":"s"}`;Kt(this.summary,i?a:`${a}: ${q1}`),this.outline.show(),this.form.show(),this.tools.firstChild||(this.scene.begin(),this.tools.append(xl(this.scene.view)))}build(){return this.studio.open(()=>ii("/api/assembly/build"))}async save(){let{path:t,name:e}=this.client.told,i=await Gr("Save the assembly",t||`${e}.toml`,{label:"File",action:"Save",hint:"Below the folders that the studio was started with."});await this.studio.answered(),i&&await this.saveTo(i,i===this.savedAs)}async saveTo(t,e){try{let{path:i}=await ii("/api/assembly/save",{path:t,force:e});this.savedAs=i,this.studio.notices.show("done",`Saved: ${i}`)}catch(i){let s=i.status===409&&!e;s&&await this.mayReplace(t)?await this.saveTo(t,!0):s||this.studio.fail(i)}}mayReplace(t){return new Promise(e=>{let i=r=>()=>{e(r),s.close()},s=Jo("Replace the file?",g("p",{},`${t} is there already. Its comments and its order would be lost.`),g("div.actions",{},g("button",{type:"button",onClick:i(!1)},"Cancel"),g("button.primary",{type:"button",onClick:i(!0)},"Replace")));s.addEventListener("close",()=>e(!1))})}key(t){if(t.defaultPrevented||document.body.dataset.page!=="assembly"||document.querySelector("dialog[open]"))return;let e=t.target.matches?.("input, textarea, select"),i=t.ctrlKey||t.metaKey,s=i?{z:()=>this.client.obey({do:t.shiftKey?"redo":"undo"}),y:()=>this.client.obey({do:"redo"}),s:()=>this.save()}:{Delete:()=>this.client.obey({do:"remove",item:this.client.selected}),Escape:()=>this.scene.cancelDrag()||this.client.carry(null),1:()=>this.scene.view.stage.view("corner"),2:()=>this.scene.view.stage.view("side"),3:()=>this.scene.view.stage.view("front"),4:()=>this.scene.view.stage.view("top")},r=Y1[t.key],{stage:o}=this.scene.view??{};if(r&&t.target===o?.canvas)o.orbit(r[0]*.12,r[1]*.08);else{let a=s[i?t.key.toLowerCase():t.key];if(!a||e&&t.key!=="s"&&t.key!=="Escape")return;a()}t.preventDefault()}};var Z1=450,K1=8,J1=6e3,j1="button, input, select, textarea, a, summary, label, canvas, [tabindex]",x0=12;function y0(n){let t=g("div.held-title",{role:"tooltip",hidden:!0}),e=null,i=!1,s=()=>{clearTimeout(e?.timer),e=null},r=o=>{Kt(t,o.title),(o.closest("dialog")??n.body).append(t),t.hidden=!1;let{left:a,top:l,bottom:h}=o.getBoundingClientRect(),c=Math.min(Math.max(8,a),innerWidth-t.offsetWidth-8),u=l-t.offsetHeight-x0,d=u>8?u:h+x0;t.style.transform=`translate(${c.toFixed(0)}px, ${d.toFixed(0)}px)`,clearTimeout(t.timer),t.timer=setTimeout(()=>t.hidden=!0,J1)};n.addEventListener("pointerdown",({target:o,pointerType:a,pointerId:l,clientX:h,clientY:c})=>{s(),t.hidden=!0,i=!1;let u=a==="touch"&&o.closest?.("[title]:not([title=''])");if(!u||o.matches("input[type=range]"))return;let f=setTimeout(()=>{i=!0,r(u)},Z1);e={element:u,target:o,id:l,x:h,y:c,timer:f}},!0),n.addEventListener("pointermove",({pointerId:o,clientX:a,clientY:l})=>{o===e?.id&&Math.hypot(a-e.x,l-e.y)>K1&&s()},!0),n.addEventListener("pointercancel",s,!0),n.addEventListener("pointerup",({pointerId:o})=>{o===e?.id&&(!i&&!e.target.closest(j1)&&r(e.element),s())},!0),n.addEventListener("click",o=>{!i||o.detail===0||(i=!1,o.preventDefault(),o.stopPropagation())},!0),n.addEventListener("contextmenu",o=>i&&o.preventDefault())}function v0(n){let t=null;n.addEventListener("focusin",({target:e})=>{t=e.matches?.('input[type="number"]')?e:null}),n.addEventListener("click",({target:e})=>{e===t&&e.select(),t=null})}var zc=class{constructor(t){this.studio=t,this.body=g("div.proposal-body"),this.element=g("main.proposal",{hidden:!0},g("h1",{},"A new robot"),g("p.lead",{},"Its file does not say yet what may change. Tick it; all else of the file stays but for what is noted here."),this.body)}async load(t=""){this.forward=t,Gt(this.body,g("p.empty",{},"Reading the robot …"));let e=`/api/proposal?forward=${encodeURIComponent(t)}`,i=await this.studio.act(()=>_i(e));i&&this.show(i)}show(t){let{parameters:e=[],left_out:i=[]}=t;this.boxes=e.map(s=>g("input",{type:"checkbox",checked:s.ticked??!0,name:s.name,aria:{label:Oe(s.name)}})),Gt(this.body,this.limbs(t),g("section.panel",{},g("h2",{},"What may change"),g("div.button-row",{},g("button.small",{type:"button",onClick:()=>this.tick(!0)},"All"),g("button.small",{type:"button",onClick:()=>this.tick(!1)},"None")),g("table.differences.proposals",{},g("tbody",{},e.map((s,r)=>this.row(s,r)))),this.leftOut(i)),g("div.actions",{},g("button",{type:"button",onClick:()=>this.studio.showStart()},"Back"),g("button.primary",{type:"button",onClick:()=>this.write()},"Write and go on")))}limbs({words:t,ahead:e,told:i=[],limbs:s=[]}){let r=["limb","joints","foot"].map(a=>g("th",{scope:"col"},a)),o=({name:a,joints:l=[],foot:h})=>g("tr",{},g("th",{scope:"row"},a),g("td",{},l.join(", ")),g("td",{},h??""));return g("section.panel",{},g("h2",{},"What was found"),g("p",{},t??""),this.facing(e),i.length?g("ul.notes",{},i.map(a=>g("li",{},a))):null,g("table.differences.found",{},g("thead",{},g("tr",{},r)),g("tbody",{},s.map(o))))}facing(t){let e=s=>g("option",{value:s,selected:s===t},s.replace("-","−"));return g("label.faces",{},"Ahead is the trunk’s ",g("select",{name:"forward",onChange:({target:s})=>this.load(s.value)},["+x","-x","+y","-y"].map(e)))}leftOut(t){if(!t.length)return null;let e=t.map(i=>g("li",{},i));return g("details",{},g("summary",{},`Left out (${t.length})`),g("ul",{},e))}row({name:t,sentence:e,unit:i,value:s,lower:r,upper:o,reason:a},l){return g("tr",{},g("td",{},g("label",{},this.boxes[l])),g("th",{scope:"row"},g("label",{onClick:()=>this.boxes[l].click()},Oe(t)),g("p.hint",{},e??""),a?g("p.hint",{},a):""),g("td",{},Ui(s,i)),g("td",{},`${Ui(r,"")} to ${Ui(o,i)}`))}tick(t){for(let e of this.boxes)e.checked=t}write(){let t=this.boxes.filter(e=>e.checked).map(e=>e.name);this.studio.open(()=>ii("/api/proposal",{parameters:t,forward:this.forward}))}};var b0=3;async function Q1(n){let t=[...n.items].map(s=>s.webkitGetAsEntry?.()).filter(Boolean);if(!t.length)return[...n.files].map(s=>({file:s,path:s.name}));let e=[],i=async(s,r)=>{if(s.isFile){let a=await new Promise((l,h)=>s.file(l,h));e.push({file:a,path:r+s.name});return}let o=s.createReader();for(;;){let a=await new Promise((l,h)=>o.readEntries(l,h));if(!a.length)break;for(let l of a)await i(l,`${r}${s.name}/`)}};for(let s of t)await i(s,"");return e}var tA=n=>new Promise((t,e)=>{let i=new FileReader;i.onload=()=>t(i.result.split(",")[1]??""),i.onerror=()=>e(i.error),i.readAsDataURL(n)});async function S0(n){let t=[];for(let{file:e,path:i}of n)t.push({name:i,base64:await tA(e)});return ii("/api/open",{files:t})}function M0(n,t){let e=i=>n.classList.toggle("dropping",i);n.addEventListener("dragover",i=>{i.preventDefault(),e(!0)}),n.addEventListener("dragleave",i=>i.relatedTarget||e(!1)),n.addEventListener("drop",async i=>{i.preventDefault(),e(!1);let s=await Q1(i.dataTransfer);s.length&&t.open(()=>S0(s))})}var w0=n=>{let t=/-dropped-\d+\/(.+)$/.exec(n??"");return t?`dropped: ${t[1]}`:n},Gc=class{constructor(t){this.studio=t,this.examples=g("div.examples"),this.recent=g("ul.recent"),this.assemblies=g("ul.recent"),this.unsaved=g("div",{hidden:!0}),this.back=g("button",{type:"button",onClick:()=>t.showOpen()}),this.path=g("input.wide",{type:"text",placeholder:"ROBOT.xml or .urdf, TASK.toml or a run's folder",aria:{label:"Path"},spellcheck:!1}),this.element=g("main.start",{},g("h1",{},"Legwright Studio"),g("p.lead",{},"Change the body and the gait of a legged robot together, and see what it does."),g("div.start-columns",{},g("section",{aria:{label:"Examples"}},g("h2",{},"Examples"),this.examples),g("section.start-side",{},this.back,g("h2",{},"Your own robot"),this.ownRobot(),this.unsaved,g("h2",{},"Of modules"),g("p",{},g("button",{type:"button",onClick:()=>this.openNew()},"New robot…")),g("details",{},g("summary",{},"Examples of modules"),this.assemblies),g("h2",{},"Open"),g("form.open-path",{onSubmit:e=>this.openPath(e)},this.path,g("button",{type:"submit"},"Open")),g("h2",{},"Recent"),this.recent)))}ownRobot(){let t=s=>{let r=g("input",{type:"file",hidden:!0,...s});return r.addEventListener("change",()=>this.chosen(r)),r},[e,i]=[t({multiple:!0}),t({webkitdirectory:!0})];return g("div.drop",{},g("p",{},"Drop an MJCF file here, with its meshes, or its folder."),g("div.button-row",{},g("button",{type:"button",onClick:()=>e.click()},"Files…"),g("button",{type:"button",onClick:()=>i.click()},"Folder…")),e,i)}showBack(){let{store:t}=this.studio,e=t.get("opened");this.back.hidden=!e?.kept&&!e?.proposes;let i=t.get("assembly")?.name??t.get("document")?.label??"the new robot";Kt(this.back,`Back to ${i}`)}async load(){this.showBack();let t=await this.studio.act(()=>_i("/api/start"));if(!t)return;this.showExamples(t.examples??[]);let e=(t.assemblies??[]).map(({path:a,name:l,words:h})=>this.link(a,Oe(l),h));Gt(this.assemblies,e);let i=(t.recent??[]).map(({path:a,words:l,opened:h})=>this.link(a,l||a,[h,w0(a)].filter(Boolean).join(", ")));Gt(this.recent,i.length?i:g("li.empty",{},"Nothing yet."));let s=(t.unsaved??[]).map(({path:a,name:l,origin:h,begun:c})=>this.link(a,l,[c,w0(h)].filter(Boolean).join(", ")));this.unsaved.hidden=!s.length;let[r,o]=[s.slice(0,b0),s.slice(b0)];Gt(this.unsaved,g("h2",{},"Not saved"),g("ul.recent",{},r),o.length?g("details",{},g("summary",{},`${o.length} older`),g("ul.recent",{},o)):""),t.roots?.length&&(this.path.title=`Below ${t.roots.join(", ")}`)}link(t,e,i){return g("li",{},g("button.link",{type:"button",title:t,onClick:()=>this.open(t)},e),g("span.path",{title:i},i))}showExamples(t){let e=new Map;for(let i of t){let s=i.name.split("/")[0];e.set(s,[...e.get(s)??[],i])}Gt(this.examples,[...e].map(([i,s])=>this.card(i,s))),this.drawPictures()}card(t,e){let i=g("img",{alt:`The robot ${Oe(t)}`,data:{example:e[0].name}}),s=({name:r})=>this.studio.open(()=>ii("/api/open",{example:r}));return g("article.example",{},i,g("strong",{},Oe(t)),g("ul",{},e.map(r=>g("li",{},g("button.link",{type:"button",title:r.words??"",onClick:()=>s(r)},Oe(r.name.split("/")[1]??r.name))))))}async drawPictures(){let t=[...this.examples.querySelectorAll("img")],{meshSource:e}=this.studio,i=new To({width:300,height:170,theme:lr(),meshSource:e});for(let s of t){let r=encodeURIComponent(s.dataset.example);try{s.src=await i.draw(await _i(`/api/example?name=${r}`))}catch{s.classList.add("no-picture")}if(this.element.hidden)break;await new Promise(o=>setTimeout(o))}i.dispose()}openNew(){this.studio.open(()=>ii("/api/open",{new_assembly:!0}))}open(t){this.studio.open(()=>ii("/api/open",{path:t}))}openPath(t){t.preventDefault(),this.path.value.trim()&&this.open(this.path.value.trim())}chosen(t){let e=[...t.files].map(i=>({file:i,path:i.webkitRelativePath||i.name}));t.value="",e.length&&this.studio.open(()=>S0(e))}};function A0(n){let t=null,e=i=>{let{slider:s}=t;t=null,s.value=i,s.dispatchEvent(new Event("input",{bubbles:!0}))};n.addEventListener("pointerdown",({target:i,pointerType:s,pointerId:r,clientX:o,clientY:a})=>{if(s!=="touch"||!i.matches?.("input.slider"))return;let{value:l}=i;t={slider:i,id:r,value:l,wanted:l,x:o,y:a}},!0),n.addEventListener("input",i=>{i.target===t?.slider&&(i.stopPropagation(),t.wanted=t.slider.value,t.slider.value=t.value)},!0),n.addEventListener("pointermove",({pointerId:i,clientX:s,clientY:r})=>{if(i!==t?.id)return;let[o,a]=[Math.abs(s-t.x),Math.abs(r-t.y)];o>6&&o>a&&e(t.wanted)}),n.addEventListener("pointercancel",({pointerId:i})=>{i===t?.id&&(t.slider.value=t.value,t=null)}),n.addEventListener("pointerup",({pointerId:i})=>{if(i!==t?.id)return;let{slider:s,value:r,wanted:o}=t;if(o===r)return t=null;e(o),s.dispatchEvent(new Event("change",{bubbles:!0}))})}function br(n,t){let e=0,i=-1/0,s=[];return(...r)=>{if(s=r,e)return;let o=Math.max(0,n-(performance.now()-i)),a=()=>{e=0,i=performance.now(),t(...s)};o===0?a():e=setTimeout(a,o)}}var eA=150,zn=n=>br(eA,n);var Vc=1e-9,Ef=6,wr={width:260,height:54},Hc=class{constructor(t){this.studio=t,this.count=g("p.hint"),this.find=g("button.small",{type:"button",title:"Puts changes back, the one that costs least first, and optimises the rest again (key F)",onClick:()=>this.findFewest()},"Fewest changes"),this.cancel=g("button.small",{type:"button",hidden:!0,onClick:()=>t.halt()},"Cancel"),this.busy=g("p.status",{role:"status"}),this.table=g("table.differences.changes",{aria:{label:"Changes of the given body"}}),this.more=g("button.link",{type:"button",onClick:()=>this.toggleAll()}),this.element=g("section.panel",{aria:{label:"Changes"}},g("h2",{},"Changes",g("span.button-row",{},this.find,this.cancel)),this.busy,this.chooser(),this.count,this.table,this.more),this.showChangesSoon=zn(()=>this.showChanges()),t.store.on(["state","document","alternatives fewest"],()=>this.update())}findFewest(){let t=this.hindrance();t?this.studio.notices.show("info",t):this.studio.workOut("fewest")}hindrance(){let{store:t}=this.studio,[e,i]=[t.get("state"),t.get("document")];return!e||!i?"No robot is here yet.":e.phase==="searching"?"A search goes on: pause it (O), then the fewest changes can be worked out.":e.phase==="working out"?"Other designs are being worked out already.":i.parameters.some(({given:r},o)=>!e.frozen?.[o]&&Math.abs(e.s[o]-r)>Vc)?"":"The body is as it was given, as far as it is free: optimise (O) or edit it first."}chooser(){return this.chart=Ie("svg.kept",{viewBox:`0 0 ${wr.width} ${wr.height}`,preserveAspectRatio:"none","aria-hidden":"true"}),this.slider=g("input.slider",{type:"range",step:1,min:0,aria:{label:"Design with fewer changes"},onInput:()=>this.choose(this.slider.valueAsNumber),onChange:()=>this.moving=!1}),this.told=g("p.told",{title:"The gain: by how much the cost F fell from the given body to the optimised one",aria:{live:"polite"}}),this.counts=g("div.kept-counts",{aria:{hidden:"true"}}),this.choices=g("div.fewest",{hidden:!0},this.chart,this.counts,this.slider,this.told),this.choices}choose(t){this.studio.choose("fewest",t,!!this.moving),this.moving=!0,this.tell(t)}update(){let{store:t}=this.studio,[e,i]=[t.get("state"),t.get("document")];if(!e||!i)return;let s=e.phase==="working out";this.cancel.hidden=!s,this.find.disabled=s||e.phase==="searching",Kt(this.busy,s?"Working out other designs …":"");let r=e.alternatives?.includes("fewest");this.found=r?t.get("alternatives fewest"):null,this.choices.hidden=!this.found,this.found&&this.showChoices(e),this.studio.edits.moving?this.showChangesSoon():this.showChanges()}kept(t){let{designs:e,given_F:i}=this.found;return(i-e[t].F)/(i-e[0].F||1)}changesOf(t){let{parameters:e}=this.studio.store.get("document");return e.filter((i,s)=>Math.abs(this.found.designs[t].s[s]-i.given)>Vc).length}showChoices(t){let{designs:e,fewest:i,kept:s}=this.found;if(this.present=e.findIndex(({s:r})=>r.every((o,a)=>Math.abs(o-t.s[a])<Vc)),this.found!==this.drawn){this.drawn=this.found,this.slider.max=e.length-1;let r=wr.width/e.length,o=l=>Math.max(1,wr.height*Math.max(0,this.kept(l)));this.bars=e.map((l,h)=>Ie(`rect.kept-bar${h===i?".fewest":""}`,{x:h*r+1,width:Math.max(1,r-2),y:wr.height-o(h),height:o(h),onClick:()=>this.choose(h)})),Gt(this.counts,e.map((l,h)=>g("span",{},String(this.changesOf(h)))));let a=wr.height*(1-s);Gt(this.chart,this.bars,Ie("line.kept-line",{x1:0,x2:wr.width,y1:a,y2:a}))}this.bars.forEach((r,o)=>r.classList.toggle("present",o===this.present)),!this.moving&&(this.present>=0&&(this.slider.valueAsNumber=this.present),this.tell(this.present))}tell(t){if(t<0){let s=this.found.fewest,r=`${this.changesOf(s)} changes would keep ${this.percent(s)} of the gain.`;return this.slider.setAttribute("aria-valuetext",r),Kt(this.told,r)}let e=this.changesOf(t),i=`${e} ${e===1?"change":"changes"}, cost F ${We(this.found.designs[t].F)}: ${this.percent(t)} of the gain`;this.slider.setAttribute("aria-valuetext",i),Kt(this.told,i)}percent(t){return`${(100*this.kept(t)).toFixed(1)} %`}showChanges(){let{store:t}=this.studio,[e,i]=[t.get("state"),t.get("document")];if(!e||!i)return;let{parameters:s}=i,r=new Map(this.found&&this.present===0?this.found.worths.map(({name:c,worth:u})=>[c,u]):[]),o=s.map((c,u)=>({parameter:c,now:e.s[u],locked:e.frozen?.[u],worth:r.get(c.name),size:Math.abs(e.s[u]-c.given)/(c.scale||1)})).filter(({now:c,parameter:u})=>Math.abs(c-u.given)>Vc).sort((c,u)=>T0(u)-T0(c)||u.size-c.size),a=JSON.stringify([o.map(({parameter:c,now:u,worth:d,locked:f})=>[c.name,u,d,f]),this.all]);if(a===this.key)return;this.key=a;let l=o.length===1?"1 parameter is":`${o.length} parameters are`;Kt(this.count,o.length?`${l} not as given, of ${s.length}.`:"The body is as it was given.");let h=this.all?o:o.slice(0,Ef);this.more.hidden=o.length<=Ef,Kt(this.more,this.all?"Fewer":`and ${o.length-Ef} more`),Gt(this.table,o.length&&r.size?g("thead",{},g("tr",{},["","now","worth"].map(c=>g("th",{scope:"col"},c)),g("td"))):null,g("tbody",{},h.map(c=>this.row(c))))}row({parameter:t,now:e,worth:i,locked:s}){let{name:r,given:o,unit:a}=t,l=`Put ${Oe(r)} back to ${Ui(o,a)}`;return g("tr",{title:`${Oe(r)}: given ${Ui(o,a)}, now ${Ui(e,a)}`},g("th",{scope:"row"},Oe(r)),g("td",{},Ui(e,a)),i===void 0?null:g("td",{title:"The cost F rises by so much where this one alone is put back"},i===null?"all":`cost +${We(i,2)}`),g("td",{},g("button.icon-button",{type:"button",title:s?`${Oe(r)} is locked`:l,disabled:!!s,aria:{label:l},onClick:()=>this.studio.edit(r,o,"once")},Fi("reset"))))}toggleAll(){this.all=!this.all,this.update()}},T0=({worth:n})=>n===void 0?0:n??1e9;var iA=9,nA="F sums up how far body and gait are from what is asked of them: the less, the better. The search makes it small.",Wc=class{constructor(t){this.studio=t,this.F=g("strong.figure"),this.rest=g("span.figures"),this.rows=Array.from({length:iA},()=>new Cf),this.terms=g("table.terms",{aria:{label:"What the cost F consists of"}},g("tbody",{},...this.rows.map(e=>e.element))),this.element=g("section.panel",{aria:{label:"Cost"}},g("h2",{title:nA},"Cost F"),g("p.headline",{},this.F,this.rest),this.terms),t.store.on("state",zn(e=>this.update(e))),t.store.on("document",()=>{this.told=null;let e=t.store.get("state");e&&this.update(e)})}update(t){if(t===this.told)return;this.told=t,Kt(this.F,We(t.F));let e=[t.settled?"":"predicted",t.J?`goal of the body (J) ${We(t.J)}`:"",this.massOf(t),...t.task_F?.length>1?t.task_F.map((i,s)=>`${this.taskName(s)} ${We(i,3)}`):[]];Kt(this.rest,e.filter(Boolean).join(" · ")),this.F.classList.toggle("pending",!t.settled),this.showTerms(t)}massOf({mass:t}){if(!Number.isFinite(t))return"";let e=this.studio.store.get("document")?.mass_changes===!1;return`${t.toFixed(3)} kg${e?", as the file has it":""}`}taskName(t){return this.studio.store.get("document")?.tasks?.[t]?.name??`task ${t+1}`}showTerms(t){let e=[...t.terms??[]].sort((s,r)=>r.value-s.value),i=e[0]?.value||1;this.rows.forEach((s,r)=>{s.element.hidden=r>=e.length,s.element.hidden||s.show(e[r],i)})}},Cf=class{constructor(){this.label=g("th",{scope:"row"}),this.bar=g("span.bar"),this.value=g("td.value"),this.element=g("tr",{hidden:!0},this.label,g("td.bar-cell",{},this.bar),this.value)}show({name:t,words:e,value:i},s){Kt(this.label,e??t),this.name!==t&&(this.element.title=`${e??t} (term ${t} of F)`),this.name=t,this.bar.style.width=`${Math.max(1,100*Math.max(0,i)/s).toFixed(1)}%`,Kt(this.value,We(i,3))}},Xc=class{constructor(t){this.studio=t,this.list=g("ul.faults"),this.title=g("h2",{},"What is wrong"),this.element=g("section.panel",{aria:{label:"What is wrong"}},this.title,this.list),t.store.on("motion",br(200,e=>this.update(e))),t.store.on(["refused","passed"],()=>{let e=t.store.get("motion");e&&this.update(e)})}update(t){let e=t.faults??[],{store:i}=this.studio,[s,r]=["refused","passed"].map(a=>!!i.get(a)),o=JSON.stringify([s,r,e.map(({words:a,from:l})=>[a,l])]);if(o!==this.key){if(this.key=o,Kt(this.title,e.length?`What is wrong (${e.length})`:"What is wrong"),!e.length)return Gt(this.list,s?g("li",{},"The plan keeps all limits, but MuJoCo fails it: see Simulate, Verdict."):g("li.good",{},r?"Nothing: the plan keeps all limits, and MuJoCo passes it.":"Nothing in the plan: it keeps all limits. MuJoCo is asked under Simulate, Judge."));Gt(this.list,r?g("li.good",{},"MuJoCo passes it all the same: these are margins that the plan wants."):null,e.slice(0,12).map(a=>this.row(a)),e.length>12?g("li.more",{},`and ${e.length-12} more`):null)}}row(t){let{words:e,where:i=""}=t,s=e.lastIndexOf(": "),[r,o]=s<0?[e,""]:[e.slice(0,s),e.slice(s+2)];return g("li",{title:e},g("strong",{},i),g("span.fault-name",{},r.replace(`, ${i}`,"")),g("span.amount",{},o),g("button.link",{type:"button",onClick:()=>this.studio.showFault(t)},"Show"))}};var sA={m:["length","lengths"],rad:["angle","angles"]},$c=class{constructor(t){this.studio=t,this.words=g("span",{role:"status"}),this.keep=g("button.small",{type:"button",onClick:()=>this.act()}),this.element=g("div.hand-note",{hidden:!0},this.words,this.keep,an("close","Dismiss",()=>this.dismiss())),t.store.on(["state","document"],zn(()=>this.update()))}update(){let{hand:t}=this.studio,e=t.changed(),i=e.length?e:t.before?[]:t.free();if(this.element.hidden=!i.length,!i.length)return;let s=this.count(i),r=t.searching?"The search changes":"The search has changed";Kt(this.words,e.length?`${r} ${s} that you set.`:`Optimise may change ${s} that you set.`),this.words.title=i.map(Oe).join(", ");let o=i.length===1?"it":"them";Kt(this.keep,e.length?`Put ${o} back and lock`:`Lock ${o}`)}count(t){let{parameters:e}=this.studio.store.get("document"),i=new Set(t.map(o=>e.find(a=>a.name===o)?.unit)),[s,r]=i.size===1&&sA[[...i][0]]||["value","values"];return`${t.length} ${t.length===1?s:r}`}async act(){await this.studio.hand.keep(),this.update()}dismiss(){this.studio.hand.startAnew(),this.update()}};var rA=700,oA=200,aA=500,qc=class{constructor(t){this.studio=t,this.name=null,t.store.on("held",({name:i,phase:s})=>this.take(i,s));let e=br(aA,()=>this.loaded&&this.load());t.store.on("motion",i=>i&&!i.predicted&&e()),t.store.on("forgotten",()=>this.end())}take(t,e){if(clearTimeout(this.timer),e==="once")return this.end();if(e==="end"){this.timer=setTimeout(()=>this.end(),rA);return}this.name!==t&&(this.name=t,this.loaded=!1,clearTimeout(this.soon),this.soon=setTimeout(()=>this.load(),oA))}load(){let{studio:t,name:e}=this;this.loaded=!0;let i=t.store.get("task")??0;t.latestBeside("bounds",async()=>{let s=await _i(`/api/bounds?name=${encodeURIComponent(e)}&task=${i}`);this.name===e&&t.view.setBounds(s)})}end(){this.name!==null&&(clearTimeout(this.soon),this.name=null,this.loaded=!1,this.studio.view.setBounds(null))}};var Rf=.3,lA=12;function hA({what:n,words:t,done:e=0,of:i=0}){let s=i>0?Math.min(1,e/i):null;return n!=="optimize"?s:t==="searching"?Rf*(s??0):t==="roll-outs"?1:e>0?Rf+(1-Rf)*(e/(e+lA)):0}function cA({what:n,words:t="",done:e=0,of:i=0}){return i>0?`${t}, ${e} of ${t==="searching"?"about ":""}${i}`:e>0?`${t}, ${e} so far`:t}var Eo=class{constructor({cancel:t}={}){this.words=g("span",{role:"status"}),this.passed=g("span.passed",{aria:{hidden:"true"}}),this.bar=g("progress",{max:1,aria:{label:"Progress"}}),this.element=g("span.job-status",{hidden:!0},this.words,this.passed,this.bar,t?g("button.small",{type:"button",onClick:t},"Cancel"):"")}show(t){let{running:e,what:i}=t;if(this.element.hidden=!e,clearInterval(this.clock),!e)return this.begun=null;this.job=t,this.begun??=performance.now(),this.bar.title=i==="optimize"?"How many designs will be played nobody knows: the bar slows down":"";let s=hA(t);s===null?this.bar.removeAttribute("value"):this.bar.value=s,this.tell(),this.clock=setInterval(()=>this.tell(),1e3)}tell(){Kt(this.words,cA(this.job)),Kt(this.passed,pl((performance.now()-this.begun)/1e3))}};var uA=n=>n.split(`
`).map(t=>t.startsWith("FAIL")?t.split(":")[0]:t).join(`
`),dA="What helps as a rule: optimise from here, then “Find one that passes…”; or ask for less: a lower speed, another gait, stronger servos.",Yc=class{constructor(t){this.studio=t,this.start=g("button.primary",{type:"button",onClick:()=>this.begin()},"Judge"),this.cancel=g("button",{type:"button",hidden:!0,onClick:()=>t.act(()=>zr("/api/judge"))},"Cancel"),this.find=g("button",{type:"button",title:"Searches on from this body: of many designs the best that MuJoCo passes (optimize)",onClick:()=>t.optimize()},"Find one that passes…"),this.found=g("button",{type:"button",onClick:()=>this.openFound()}),this.exportFound=g("button",{type:"button",title:"The body and the gait that MuJoCo passed, as that run hands them back",onClick:()=>t.exportRobot(this.path)},"Export the one that passes…"),this.ofFound=g("div.button-row",{hidden:!0},this.found,this.exportFound),this.progress=g("progress",{max:1,value:0,hidden:!0,aria:{label:"Progress of the judge"}}),this.finding=new Eo({cancel:()=>t.act(()=>zr("/api/job"))}),this.title=g("h2",{},"Verdict"),this.verdict=g("p.verdict",{role:"status"}),this.advice=g("p.hint",{hidden:!0},dA),this.lines=g("ul.verdict-lines"),this.kept=g("ul.verdict-lines"),this.keptTitle=g("summary"),this.folded=g("details",{hidden:!0},this.keptTitle,this.kept),this.element=g("section.panel",{aria:{label:"Judge"}},this.title,g("p.hint",{},"Plays the gait in MuJoCo at half, default and double gains."),g("div.button-row",{},this.start,this.cancel,this.find,this.progress),this.finding.element,this.verdict,this.advice,this.ofFound,this.lines,this.folded),t.store.on("judge",e=>this.update(e)),t.store.on(["state","document"],()=>this.markOld()),t.store.on("forgotten",()=>this.forget()),t.store.on("job",e=>this.showFound(e))}async begin(){this.asked=!0,await this.studio.answered(),await this.studio.act(()=>ii("/api/judge",{}))}update({running:t,words:e,done:i=0,of:s=0,lines:r=[],verdict:o,failed:a,judged:l}){this.start.disabled=!!t,this.cancel.hidden=this.progress.hidden=!t,s>0?this.progress.value=i/s:this.progress.removeAttribute("value");let h=`${e??"playing"}${s>0?`, ${i} of ${s}`:""} …`;Kt(this.verdict,t?h:o?uA(o.words):a??"");let c=o?.word==="PASS"?"good":"bad";this.verdict.className=`verdict ${t||!o?"":c}`,this.judged=o?l:void 0,this.passes=o?.word==="PASS",this.advice.hidden=!o||this.passes,this.markOld(),this.showLines(r),this.asked&&(t||o)&&this.verdict.scrollIntoView({block:"nearest"}),t||(this.asked=!1)}showLines(t){let e=t.filter(({passed:l})=>l),i=t.filter(({passed:l,numbers:h})=>!l&&h?.value!==null),s=t.filter(l=>!e.includes(l)&&!i.includes(l)),[r,o]=i.length?[i,[...e,...s]]:[s,e];for(let[l,h]of[[this.lines,r],[this.kept,o]])Gt(l,h.map(c=>this.line(c)));this.folded.hidden=!o.length;let a=[e.length&&`${e.length} ${e.length===1?"limit is":"limits are"} kept`,i.length&&s.length&&`${s.length} could not be measured`];Kt(this.keptTitle,a.filter(Boolean).join(", "))}forget(){this.update({}),this.ofFound.hidden=!0}showFound(t){let{what:e,running:i,path:s,passes:r}=t,o=e==="optimize";this.find.disabled=o&&!!i,this.finding.show(o?t:{}),r!==void 0&&(this.path=s,this.ofFound.hidden=!1,this.exportFound.hidden=!r,Kt(this.found,r?"Open the one that passes":"Open the best, which fails"))}openFound(){return this.studio.open(()=>ii("/api/open",{path:this.path}))}line({words:t,term:e,passed:i,moment:s,numbers:r,marks:o}){return g(`li.${i?"good":"bad"}`,{},g("span.sign",{aria:{hidden:"true"}},i?"✓":"✗"),g("span",{title:e},g("span.unseen",{},i?"passed: ":"failed: "),t),s?g("button.link",{type:"button",onClick:()=>this.studio.showMoment(s,r?.gains,o)},s.whole?"Show the walk":"Show me"):null)}markOld(){let{judged:t}=this,{store:e}=this.studio,[i,s]=[e.get("state")?.s,e.get("document")?.task_text],r=!!(t&&i&&(t.task_text!==s||t.s.some((a,l)=>a!==i[l])));this.element.classList.toggle("old",r),Kt(this.title,r?"Verdict of an earlier design":"Verdict");let o=!!t&&!r;e.set("refused",o&&!this.passes),e.set("passed",o&&this.passes)}};var fA=200,Zc=1e-9,E0=n=>Math.max((n.upper-n.lower)/fA,1e-6),Kc=class{constructor(t,e){this.parameter=t,this.told=e,this.dragging=!1;let{name:i,unit:s}=t,r=Oe(i);this.slider=g("input.slider",{type:"range",step:"any",aria:{label:`${r}, slider`},onInput:()=>this.slide(),onChange:()=>this.endSlide(),onKeydown:o=>this.key(o)}),this.number=g("input.number",{type:"number",step:"any",inputMode:"decimal",aria:{label:`${r} [${s}]`},onChange:()=>this.enter(),onKeydown:o=>this.key(o)}),this.lock=g("button.icon-button.lock",{type:"button",onClick:()=>e.lock(i,!this.state?.locked)}),this.reset=an("reset",`Back to the given ${Ui(t.given,s)}`,()=>e.edit(i,t.given,"once")),this.bar=g("span.gradient-fill"),this.gradient=g("span.gradient",{},this.bar),this.name=g("button.parameter-name",{type:"button",onClick:o=>e.select(i,o.ctrlKey||o.metaKey)},r),this.atBound=g("span.at-bound",{hidden:!0}),this.detail=g("div.parameter-detail",{hidden:!0}),this.element=g("div.parameter",{role:"group",aria:{label:r},data:{name:i},onPointerenter:()=>e.hover(i),onPointerleave:()=>e.hover(null)},g("div.parameter-line",{},this.name,this.atBound,this.number,g("span.unit",{},s)),g("div.parameter-line",{},this.slider,this.gradient,this.lock,this.reset),this.detail)}slide(){let t=this.dragging?"drag":"begin";this.dragging=!0,this.told.edit(this.parameter.name,this.slider.valueAsNumber,t)}endSlide(){this.dragging&&(this.dragging=!1,this.told.edit(this.parameter.name,this.slider.valueAsNumber,"end"))}enter(){let t=this.number.valueAsNumber;if(Number.isFinite(t)){let{lower:e,upper:i}=this.state;this.told.edit(this.parameter.name,Math.min(i,Math.max(e,t)),"once")}this.shown=void 0,this.update(this.state)}key(t){let e={ArrowUp:1,ArrowRight:1,"+":1,"=":1,ArrowDown:-1,ArrowLeft:-1,"-":-1},i=t.target===this.number,s=e[t.key];!s||i&&!/^Arrow(Up|Down)$/.test(t.key)||(t.preventDefault(),t.stopPropagation(),this.told.nudge(this.parameter.name,s*(t.shiftKey?10:1)))}update(t){let{parameter:e,slider:i,number:s}=this,r=this.state??{};if(this.state=t,!(!Object.keys(t).some(a=>t[a]!==r[a])&&this.shown!==void 0)){if(r.lower!==t.lower||r.upper!==t.upper||this.shown===void 0){i.min=t.lower,i.max=t.upper,s.min=t.lower,s.max=t.upper;let a=(e.given-t.lower)/(t.upper-t.lower||1);i.style.setProperty("--given",`${(100*Math.min(1,Math.max(0,a))).toFixed(1)}%`),this.fillBounds()}if(this.shown!==t.value){this.shown=t.value,this.dragging||(i.valueAsNumber=t.value),document.activeElement!==s||!s.matches(":focus-visible")||this.dragging?s.value=t.value.toFixed(ar(e.unit)):Math.abs(s.valueAsNumber-t.value)>Zc&&(s.value=t.value.toFixed(ar(e.unit)));let a=Math.abs(t.value-e.given)>Zc;this.reset.disabled=!a||t.locked,this.element.classList.toggle("changed",a)}this.showBound(t),r.locked!==t.locked&&this.showLock(t.locked),this.showGradient(t)}}showBound({value:t,lower:e,upper:i}){let{parameter:s,slider:r,atBound:o}=this,{unit:a,robot_lower:l,robot_upper:h}=s,c=1e-6*(i-e),d=i-e>Zc?t<=e+c?"lower":t>=i-c?"upper":"":"",f=d==="lower"?e:i,w=Math.abs(f-(d==="lower"?l:h))>Zc?"set here":"of the robot's file",m=d?`At its ${d} bound ${Ui(f,a)}, ${w}`:"";r.setAttribute("aria-valuetext",[Ui(t,a),m].filter(Boolean).join(". ")),m!==this.toldBound&&(this.toldBound=m,this.element.classList.toggle("bounded",!!d),o.hidden=!d,o.title=m&&`${m}: the search may want to go beyond it`,Gt(o,g("span",{aria:{hidden:"true"}},d==="lower"?"min":"max"),g("span.unseen",{},m)))}showLock(t){this.lock.replaceChildren(Fi(t?"lock":"unlock"));let e=`${t?"Unlock":"Lock"} ${Oe(this.parameter.name)}`;this.lock.title=e,this.lock.setAttribute("aria-label",e),this.lock.setAttribute("aria-pressed",String(t)),this.slider.disabled=this.number.disabled=t,this.reset.disabled||=t,this.element.classList.toggle("locked",t),t||(this.shown=void 0)}showGradient({gradient:t,share:e=0}){let i=Number.isFinite(t),s=i?Math.min(50,50*Math.abs(e)):0;this.bar.style.width=`${s.toFixed(1)}%`,this.bar.style.left=e>0?`${(50-s).toFixed(1)}%`:"50%";let{unit:r}=this.parameter;this.gradient.title=i?`The cost falls to the ${t>0?"left":"right"}: its slope is ${We(t,3)} per ${r} (gradient, dF/ds)`:"The slope of the cost is not known while motions are predicted (gradient, dF/ds)",this.slope&&Kt(this.slope,i?`${We(t,3)} per ${r}`:"–")}select(t){this.detail.hidden!==!t&&(this.element.classList.toggle("selected",t),this.name.setAttribute("aria-expanded",String(t)),this.detail.hidden=!t,t&&!this.slope&&this.fillDetail())}hover(t){this.element.classList.toggle("hovered",t)}fillDetail(){let{parameter:t,told:e}=this,i=s=>g("input.number",{type:"number",step:"any",aria:{label:`${s} of ${Oe(t.name)} [${t.unit}]`},onChange:()=>e.bounds(t.name,this.low.valueAsNumber,this.high.valueAsNumber)});this.low=i("Lower bound"),this.high=i("Upper bound"),this.slope=g("span"),this.fillBounds(),this.detail.append(g("p",{},t.sentence),this.tie(),g("div.bounds",{},g("label",{},"from ",this.low),g("label",{}," to ",this.high),g("span.unit",{},t.unit)),g("div.bounds",{title:"Gradient, dF/ds"},"slope of the cost: ",this.slope),g("button.small",{type:"button",title:"Back to the given value, and there it stays while the search goes on",onClick:()=>e.putBack(t.name,t.given)},"Put back and lock")),this.state&&this.showGradient(this.state)}tie(){let{tie:t}=this.parameter;if(!t||t.length<2)return"";let e=t.map(({name:i,mirrored:s})=>s?`${i} (mirrored)`:i);return g("p.tie",{},`Moves together: ${e.join(", ")}`)}fillBounds(){if(!this.low||!this.state)return;let t=ar(this.parameter.unit);for(let[e,i]of[[this.low,this.state.lower],[this.high,this.state.upper]])e.value=i.toFixed(t),e.min=this.parameter.robot_lower??"",e.max=this.parameter.robot_upper??""}};function pA(n){return n.group?Oe(n.group):n.unit==="rad"?"axes":"lengths"}var Jc=class{constructor(t){this.studio=t,this.rows=new Map,this.element=g("div.parameter-list"),t.store.on("document",e=>this.build(e)),t.store.on("state",zn(()=>this.update())),t.selection.on(()=>this.showSelection()),this.element.addEventListener("keydown",e=>this.key(e))}build(t){let e=t.parameters.map(s=>s.name+s.given).join();if(e===this.key_)return this.update();this.key_=e,this.rows.clear();let i=new Map;for(let s of t.parameters){let r=new Kc(s,this.told());this.rows.set(s.name,r);let o=pA(s);i.set(o,[...i.get(o)??[],r])}Gt(this.element,[...i].map(([s,r])=>g("details.group",{open:!0},g("summary",{},s,g("span.count",{},String(r.length))),r.map(o=>o.element)))),this.update()}told(){let{studio:t}=this;return{edit:(e,i,s)=>t.edit(e,i,s),nudge:(e,i)=>this.nudge(e,i),lock:(e,i)=>t.lock(e,i),bounds:(e,i,s)=>t.setBounds(e,i,s),select:(e,i)=>{let{names:s}=t.selection;i?t.selection.set(s.has(e)?[...s].filter(r=>r!==e):[...s,e]):t.selection.set(s.has(e)&&s.size===1?[]:[e])},hover:e=>t.selection.hover(e),putBack:(e,i)=>t.putBack(e,i)}}nudge(t,e){let i=this.studio.readParameter(t);if(i.locked)return;let s=Math.min(i.upper,Math.max(i.lower,i.value+e*E0(i))),r=this.nudged===t;this.nudged=t,clearTimeout(this.pause),this.studio.edit(t,s,r?"drag":"begin"),this.pause=setTimeout(()=>{this.nudged=null,this.studio.edit(t,this.studio.readParameter(t).value,"end")},1e3)}update(){let t=this.steepest();for(let[e,i]of this.rows){let s=this.studio.readParameter(e),r=t>0?(s.gradient??0)*(s.upper-s.lower)/t:0;i.update({...s,share:r})}}steepest(){let t=0;for(let e of this.rows.keys()){let{gradient:i,upper:s,lower:r}=this.studio.readParameter(e);Number.isFinite(i)&&(t=Math.max(t,Math.abs(i)*(s-r)))}return t}showSelection(){let{names:t,hovered:e}=this.studio.selection;for(let[s,r]of this.rows)r.select(t.has(s)),r.hover(e===s);let i=this.rows.get(this.studio.selection.first);i&&i!==this.scrolled&&i.element.scrollIntoView({block:"nearest"}),this.scrolled=i}key(t){let e=t.target.closest?.(".parameter");if(!e||t.target.tagName==="INPUT")return;let i=[...this.rows.keys()],s=i.indexOf(e.dataset.name),r={ArrowDown:1,ArrowUp:-1}[t.key];if(r)t.preventDefault(),this.rows.get(i[Math.min(i.length-1,Math.max(0,s+r))]).name.focus();else if(["+","=","-","ArrowRight","ArrowLeft"].includes(t.key)){t.preventDefault();let o=t.key==="-"||t.key==="ArrowLeft"?-1:1;this.nudge(i[s],o*(t.shiftKey?10:1))}}};var mA="uplot",gA="u-hz",_A="u-vt",xA="u-title",yA="u-wrap",vA="u-under",bA="u-over",wA="u-axis",Ar="u-off",SA="u-select",MA="u-cursor-x",AA="u-cursor-y",TA="u-cursor-pt",EA="u-legend",CA="u-live",RA="u-inline",PA="u-series",IA="u-marker",C0="u-label",LA="u-value",qa="width",Ya="height";var R0="bottom",Co="left",Pf="right",qf="#000",P0=qf+"0",If="mousemove",I0="mousedown",Lf="mouseup",L0="mouseenter",D0="mouseleave",N0="dblclick",DA="resize",NA="scroll",F0="change",iu="dppxchange",Yf="--",Fo=typeof window<"u",Of=Fo?document:null,Po=Fo?window:null,FA=Fo?navigator:null,Pe,jc;function kf(){let n=devicePixelRatio;Pe!=n&&(Pe=n,jc&&zf(F0,jc,kf),jc=matchMedia(`(min-resolution: ${Pe-.001}dppx) and (max-resolution: ${Pe+.001}dppx)`),Tr(F0,jc,kf),Po.dispatchEvent(new CustomEvent(iu)))}function mn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Bf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ke(n,t,e){n.style[t]=e+"px"}function Gn(n,t,e,i){let s=Of.createElement(n);return t!=null&&mn(s,t),e?.insertBefore(s,i),s}function Tn(n,t){return Gn("div",n,t)}var U0=new WeakMap;function rs(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=U0.get(n);r!=o&&(n.style.transform=r,U0.set(n,r),t<0||e<0||t>i||e>s?mn(n,Ar):Bf(n,Ar))}var O0=new WeakMap;function k0(n,t,e){let i=t+e,s=O0.get(n);i!=s&&(O0.set(n,i),n.style.background=t,n.style.borderColor=e)}var B0=new WeakMap;function z0(n,t,e,i){let s=t+""+e,r=B0.get(n);s!=r&&(B0.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Zf={passive:!0},UA={...Zf,capture:!0};function Tr(n,t,e,i){t.addEventListener(n,e,i?UA:Zf)}function zf(n,t,e,i){t.removeEventListener(n,e,Zf)}Fo&&kf();function Vn(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:gn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function p_(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var m_=n=>n!=null,g_=n=>n!=null&&n>0,ru=p_(m_),OA=p_(g_);function kA(n,t,e,i=0,s=!1){let r=s?OA:ru,o=s?g_:m_;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let h=t;h<=e;h++){let c=n[h];o(c)&&(c<a?a=c:c>l&&(l=c))}return[a??Ge,l??-Ge]}function ou(n,t,e,i){let s=H0(n),r=H0(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?As:__,a=s==1?gn:En,l=r==1?En:gn,h=a(o(Ti(n))),c=l(o(Ti(t))),u=Io(e,h),d=Io(e,c);return e==10&&(h<0&&(u=Ve(u,-h)),c<0&&(d=Ve(d,-c))),i||e==2?(n=u*s,t=d*r):(n=b_(n,u),t=au(t,d)),[n,t]}function Kf(n,t,e,i){let s=ou(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Jf=.1,G0={mode:3,pad:Jf},Ka={pad:0,soft:null,mode:0},BA={min:Ka,max:Ka};function nu(n,t,e,i){return lu(e)?V0(n,t,e):(Ka.pad=e,Ka.soft=i?0:null,Ka.mode=i?3:0,V0(n,t,BA))}function Te(n,t){return n??t}function zA(n,t,e){for(t=Te(t,0),e=Te(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function V0(n,t,e){let i=e.min,s=e.max,r=Te(i.pad,0),o=Te(s.pad,0),a=Te(i.hard,-Ge),l=Te(s.hard,Ge),h=Te(i.soft,Ge),c=Te(s.soft,-Ge),u=Te(i.mode,0),d=Te(s.mode,0),f=t-n,_=As(f),w=ji(Ti(n),Ti(t)),m=As(w),p=Ti(m-_);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,u==2&&h!=Ge&&(r=0),d==2&&c!=-Ge&&(o=0)));let v=f||w||1e3,R=As(v),b=Io(10,gn(R)),C=v*(f==0?n==0?.1:1:r),E=Ve(b_(n-C,b/10),24),y=n>=h&&(u==1||u==3&&E<=h||u==2&&E>=h)?h:Ge,T=ji(a,E<y&&n>=y?y:Hn(y,E)),U=v*(f==0?t==0?.1:1:o),L=Ve(au(t+U,b/10),24),D=t<=c&&(d==1||d==3&&L>=c||d==2&&L<=c)?c:-Ge,z=Hn(l,L>D&&t<=D?D:ji(D,L));return T==z&&T==0&&(z=100),[T,z]}var GA=new Intl.NumberFormat(Fo?FA.language:"en-US"),jf=n=>GA.format(n),_n=Math,eu=_n.PI,Ti=_n.abs,gn=_n.floor,Ai=_n.round,En=_n.ceil,Hn=_n.min,ji=_n.max,Io=_n.pow,H0=_n.sign,As=_n.log10,__=_n.log2,VA=(n,t=1)=>_n.sinh(n)*t,Df=(n,t=1)=>_n.asinh(n/t),Ge=1/0;function W0(n){return(As((n^n>>31)-(n>>31))|0)+1}function Gf(n,t,e){return Hn(ji(n,t),e)}function x_(n){return typeof n=="function"}function ve(n){return x_(n)?n:()=>n}var HA=()=>{},y_=n=>n,v_=(n,t)=>t,WA=n=>null,X0=n=>!0,$0=(n,t)=>n==t,XA=/\.\d*?(?=9{6,}|0{6,})/gm,Er=n=>{if(S_(n)||nr.has(n))return n;let t=`${n}`,e=t.match(XA);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Er(s)}e${r}`}return Ve(n,i)};function Sr(n,t){return Er(Ve(Er(n/t))*t)}function au(n,t){return Er(En(Er(n/t))*t)}function b_(n,t){return Er(gn(Er(n/t))*t)}function Ve(n,t=0){if(S_(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Ai(i)/e}var nr=new Map;function w_(n){return((""+n).split(".")[1]||"").length}function ja(n,t,e,i){let s=[],r=i.map(w_);for(let o=t;o<e;o++){let a=Ti(o),l=Ve(Io(n,o),a);for(let h=0;h<i.length;h++){let c=n==10?+`${i[h]}e${o}`:i[h]*l,u=(o>=0?0:a)+(o>=r[h]?0:r[h]),d=n==10?c:Ve(c,u);s.push(d),nr.set(d,u)}}return s}var Ja={},Qf=[],Lo=[null,null],ir=Array.isArray,S_=Number.isInteger,$A=n=>n===void 0;function q0(n){return typeof n=="string"}function lu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function qA(n){return n!=null&&typeof n=="object"}var YA=Object.getPrototypeOf(Uint8Array),M_="__proto__";function Do(n,t=lu){let e;if(ir(n)){let i=n.find(s=>s!=null);if(ir(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Do(n[s],t)}else e=n.slice()}else if(n instanceof YA)e=n.slice();else if(t(n)){e={};for(let i in n)i!=M_&&(e[i]=Do(n[i],t))}else e=n;return e}function yi(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=M_&&(lu(n[s])?yi(n[s],Do(i[s])):n[s]=Do(i[s]))}return n}var ZA=0,KA=1,JA=2;function jA(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function QA(n,t){if(iT(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return nT(o[0])||(o=eT(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],h=l.length;for(let c=0;c<h;c++)e.add(l[c])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let h=1;h<a.length;h++){let c=a[h],u=Array(s).fill(void 0),d=t?t[o][h]:KA,f=[];for(let _=0;_<c.length;_++){let w=c[_],m=r.get(l[_]);w===null?d!=ZA&&(u[m]=w,d==JA&&f.push(m)):u[m]=w}jA(u,f,s),i.push(u)}}return i}var tT=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function eT(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function iT(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function nT(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ji(1,gn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var A_=["January","February","March","April","May","June","July","August","September","October","November","December"],T_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function E_(n){return n.slice(0,3)}var sT=T_.map(E_),rT=A_.map(E_),oT={MMMM:A_,MMM:rT,WWWW:T_,WWW:sT};function $a(n){return(n<10?"0":"")+n}function aT(n){return(n<10?"00":n<100?"0":"")+n}var lT={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>$a(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>$a(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>$a(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>$a(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>$a(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>aT(n.getMilliseconds())};function tp(n,t){t=t||oT;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?lT[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var hT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function cT(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==hT?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var C_=n=>n%1==0,su=[1,2,2.5,5],uT=ja(10,-32,0,su),R_=ja(10,0,32,su),dT=R_.filter(C_),Mr=uT.concat(R_),ep=`
`,P_="{YYYY}",Y0=ep+P_,I_="{M}/{D}",Za=ep+I_,Qc=Za+"/{YY}",L_="{aa}",fT="{h}:{mm}",Ro=fT+L_,Z0=ep+Ro,K0=":{ss}",De=null;function D_(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?ja(10,0,3,su).filter(C_):ja(10,-3,0,su)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),h=[[o,P_,De,De,De,De,De,De,1],[s*28,"{MMM}",Y0,De,De,De,De,De,1],[s,I_,Y0,De,De,De,De,De,1],[i,"{h}"+L_,Qc,De,Za,De,De,De,1],[e,Ro,Qc,De,Za,De,De,De,1],[t,K0,Qc+" "+Ro,De,Za+" "+Ro,De,Z0,De,1],[n,K0+".{fff}",Qc+" "+Ro,De,Za+" "+Ro,De,Z0,De,1]];function c(u){return(d,f,_,w,m,p)=>{let v=[],R=m>=o,b=m>=r&&m<o,C=u(_),E=Ve(C*n,3),y=Nf(C.getFullYear(),R?0:C.getMonth(),b||R?1:C.getDate()),T=Ve(y*n,3);if(b||R){let U=b?m/r:0,L=R?m/o:0,D=E==T?E:Ve(Nf(y.getFullYear()+L,y.getMonth()+U,1)*n,3),z=new Date(Ai(D/n)),V=z.getFullYear(),N=z.getMonth();for(let W=0;D<=w;W++){let q=Nf(V+L*W,N+U*W,1),H=q-u(Ve(q*n,3));D=Ve((+q+H)*n,3),D<=w&&v.push(D)}}else{let U=m>=s?s:m,L=gn(_)-gn(E),D=T+L+au(E-T,U);v.push(D);let z=u(D),V=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,N=m/i,W=d.axes[f]._space,q=p/W;for(;D=Ve(D+m,n==1?0:3),!(D>w);)if(N>1){let H=gn(Ve(V+N,6))%24,j=u(D).getHours()-H;j>1&&(j=-1),D-=j*i,V=(V+N)%24;let et=v[v.length-1];Ve((D-et)/m,3)*q>=.7&&v.push(D)}else v.push(D)}return v}}return[l,h,c]}var[pT,mT,gT]=D_(1),[_T,xT,yT]=D_(.001);ja(2,-53,53,[1]);function J0(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function j0(n,t){return(e,i,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,h,c,u,d,f;return i.map(_=>{let w=n(_),m=w.getFullYear(),p=w.getMonth(),v=w.getDate(),R=w.getHours(),b=w.getMinutes(),C=w.getSeconds(),E=m!=l&&a[2]||p!=h&&a[3]||v!=c&&a[4]||R!=u&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,h=p,c=v,u=R,d=b,f=C,E(w)})}}function vT(n,t){let e=tp(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Nf(n,t,e){return new Date(n,t,e)}function Q0(n,t){return t(n)}var bT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function t_(n,t){return(e,i,s,r)=>r==null?Yf:t(n(i))}function wT(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function ST(n,t){return n.series[t].fill(n,t)}var MT={show:!0,live:!0,isolate:!1,mount:HA,markers:{show:!0,width:2,stroke:wT,fill:ST,dash:"solid"},idx:null,idxs:null,values:[]};function AT(n,t){let e=n.cursor.points,i=Tn(),s=e.size(n,t);Ke(i,qa,s),Ke(i,Ya,s);let r=s/-2;Ke(i,"marginLeft",r),Ke(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ke(i,"borderWidth",o),i}function TT(n,t){let e=n.series[t].points;return e._fill||e._stroke}function ET(n,t){let e=n.series[t].points;return e._stroke||e._fill}function CT(n,t){return n.series[t].points.size}var Ff=[0,0];function RT(n,t,e){return Ff[0]=t,Ff[1]=e,Ff}function tu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Uf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var PT={show:!0,x:!0,y:!0,lock:!1,move:RT,points:{one:!1,show:AT,size:CT,width:0,stroke:ET,fill:TT},bind:{mousedown:tu,mouseup:tu,click:tu,dblclick:tu,mousemove:Uf,mouseleave:Uf,mouseenter:Uf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},N_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},ip=yi({},N_,{filter:v_}),F_=yi({},ip,{size:10}),U_=yi({},N_,{show:!1}),np='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',O_="bold "+np,k_=1.5,e_={show:!0,scale:"x",stroke:qf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:O_,side:2,grid:ip,ticks:F_,border:U_,font:np,lineGap:k_,rotate:0},IT="Value",LT="Time",i_={show:!0,scale:"x",auto:!1,sorted:1,min:Ge,max:-Ge,idxs:[]};function DT(n,t,e,i,s){return t.map(r=>r==null?"":jf(r))}function NT(n,t,e,i,s,r,o){let a=[],l=nr.get(s)||0;e=o?e:Ve(au(e,s),l);for(let h=e;h<=i;h=Ve(h+s,l))a.push(Object.is(h,-0)?0:h);return a}function Vf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,h=l==10?As:__,c=gn(h(e));s=Io(l,c),l==10&&(s=Mr[Vn(s,Mr)]);let u=e,d=s*l;l==10&&(d=Mr[Vn(d,Mr)]);do a.push(u),u=u+s,l==10&&!nr.has(u)&&(u=Ve(u,nr.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=Mr[Vn(d,Mr)]));while(u<=i);return a}function FT(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,h=i>l?Vf(n,t,ji(l,e),i,s):[l],c=i>=0&&e<=0?[0]:[];return(e<-l?Vf(n,t,ji(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(c,h)}var B_=/./,UT=/[12357]/,OT=/[125]/,n_=/1/,Hf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function kT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,h=r._space,c=l(10,o),u=l(9,o)-c>=h?B_:l(7,o)-c>=h?UT:l(5,o)-c>=h?OT:n_;if(u==n_){let d=Ti(l(1,o)-c);if(d<h)return Hf(t.slice().reverse(),a.distr,u,En(h/d)).reverse()}return Hf(t,a.distr,u,1)}function BT(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,h=Ti(l(1,o)-l(2,o));return h<a?Hf(t.slice().reverse(),3,B_,En(a/h)).reverse():t}function zT(n,t,e,i){return i==null?Yf:t==null?"":jf(t)}var s_={show:!0,scale:"y",stroke:qf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:O_,side:3,grid:ip,ticks:F_,border:U_,font:np,lineGap:k_,rotate:0};function GT(n,t){let e=3+(n||1)*2;return Ve(e*t,3)}function VT(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Ti(o-r),l=n.series[t],h=a/(l.points.space*Pe);return i[1]-i[0]<=h}var r_={scale:null,auto:!0,sorted:0,min:Ge,max:-Ge},z_=(n,t,e,i,s)=>s,o_={show:!0,auto:!0,sorted:0,gaps:z_,alpha:1,facets:[yi({},r_,{scale:"x"}),yi({},r_,{scale:"y"})]},a_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:z_,alpha:1,points:{show:VT,filter:null},values:null,min:Ge,max:-Ge,idxs:[],path:null,clip:null};function HT(n,t,e,i,s){return e/10}var G_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},WT=yi({},G_,{time:!1,ori:1}),l_={};function V_(n,t){let e=l_[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,h){for(let c=0;c<e.plots.length;c++)e.plots[c]!=s&&e.plots[c].pub(i,s,r,o,a,l,h)}},n!=null&&(l_[n]=e)),e}var No=1,Wf=2;function Cr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],h=i==2?r[1]:r[t],c=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,_=a.width,w=a.height,m=n.valToPosH,p=n.valToPosV;return c.ori==0?e(s,l,h,c,u,m,p,d,f,_,w,cu,Uo,du,W_,$_):e(s,l,h,c,u,p,m,f,d,w,_,uu,Oo,op,X_,q_)}function sp(n,t){let e=0,i=0,s=Te(n.bands,Qf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function XT(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ts(n,t,e,i,s,r){return Cr(n,t,(o,a,l,h,c,u,d,f,_,w,m)=>{let p=o.pxRound,v=h.dir*(h.ori==0?1:-1),R=h.ori==0?Uo:Oo,b,C;v==1?(b=e,C=i):(b=i,C=e);let E=p(u(a[b],h,w,f)),y=p(d(l[b],c,m,_)),T=p(u(a[C],h,w,f)),U=p(d(r==1?c.max:c.min,c,m,_)),L=new Path2D(s);return R(L,T,U),R(L,E,U),R(L,E,y),L})}function hu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?du:op,l=e;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let h=e+s-l,c=10;h>0&&a(o,l,i-c/2,h,i+r+c)}return o}function $T(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function rp(n,t,e,i,s,r,o){let a=[],l=n.length;for(let h=s==1?e:i;h>=e&&h<=i;h+=s)if(t[h]===null){let u=h,d=h;if(s==1)for(;++h<=i&&t[h]===null;)d=h;else for(;--h>=e&&t[h]===null;)d=h;let f=r(n[u]),_=d==u?f:r(n[d]),w=u-s;f=o<=0&&w>=0&&w<l?r(n[w]):f;let p=d+s;_=o>=0&&p>=0&&p<l?r(n[p]):_,_>=f&&a.push([f,_])}return a}function h_(n){return n==0?y_:n==1?Ai:t=>Sr(t,n)}function H_(n){let t=n==0?cu:uu,e=n==0?(s,r,o,a,l,h)=>{s.arcTo(r,o,a,l,h)}:(s,r,o,a,l,h)=>{s.arcTo(o,r,l,a,h)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,h=0,c=0)=>{h==0&&c==0?i(s,r,o,a,l):(h=Hn(h,a/2,l/2),c=Hn(c,a/2,l/2),t(s,r+h,o),e(s,r+a,o,r+a,o+l,h),e(s,r+a,o+l,r,o+l,c),e(s,r,o+l,r,o,c),e(s,r,o,r+a,o,h),s.closePath())}}var cu=(n,t,e)=>{n.moveTo(t,e)},uu=(n,t,e)=>{n.moveTo(e,t)},Uo=(n,t,e)=>{n.lineTo(t,e)},Oo=(n,t,e)=>{n.lineTo(e,t)},du=H_(0),op=H_(1),W_=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},X_=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},$_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},q_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Y_(n){return(t,e,i,s,r)=>Cr(t,e,(o,a,l,h,c,u,d,f,_,w,m)=>{let{pxRound:p,points:v}=o,R,b;h.ori==0?(R=cu,b=W_):(R=uu,b=X_);let C=Ve(v.width*Pe,3),E=(v.size-v.width)/2*Pe,y=Ve(E*2,3),T=new Path2D,U=new Path2D,{left:L,top:D,width:z,height:V}=t.bbox;du(U,L-y,D-y,z+y*2,V+y*2);let N=W=>{if(l[W]!=null){let q=p(u(a[W],h,w,f)),H=p(d(l[W],c,m,_));R(T,q+E,H),b(T,q,H,E,0,eu*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:C>0?T:null,fill:T,clip:U,flags:No|Wf}})}function Z_(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var qT=Z_(Uo),YT=Z_(Oo);function K_(n){let t=Te(n?.alignGaps,0);return(e,i,s,r)=>Cr(e,i,(o,a,l,h,c,u,d,f,_,w,m)=>{[s,r]=ru(l,s,r);let p=o.pxRound,v=V=>p(u(V,h,w,f)),R=V=>p(d(V,c,m,_)),b,C;h.ori==0?(b=Uo,C=qT):(b=Oo,C=YT);let E=h.dir*(h.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:No},T=y.stroke,U=!1;if(r-s>=w*4){let V=ut=>e.posToVal(ut,h.key,!0),N=null,W=null,q,H,lt,Z=v(a[E==1?s:r]),j=v(a[s]),et=v(a[r]),dt=V(E==1?j+1:et-1);for(let ut=E==1?s:r;ut>=s&&ut<=r;ut+=E){let tt=a[ut],xt=(E==1?tt<dt:tt>dt)?Z:v(tt),Et=l[ut];xt==Z?Et!=null?(H=Et,N==null?(b(T,xt,R(H)),q=N=W=H):H<N?N=H:H>W&&(W=H)):Et===null&&(U=!0):(N!=null&&C(T,Z,R(N),R(W),R(q),R(H)),Et!=null?(H=Et,b(T,xt,R(H)),N=W=q=H):(N=W=null,Et===null&&(U=!0)),Z=xt,dt=V(Z+E))}N!=null&&N!=W&&lt!=Z&&C(T,Z,R(N),R(W),R(q),R(H))}else for(let V=E==1?s:r;V>=s&&V<=r;V+=E){let N=l[V];N===null?U=!0:N!=null&&b(T,v(a[V]),R(N))}let[D,z]=sp(e,i);if(o.fill!=null||D!=0){let V=y.fill=new Path2D(T),N=o.fillTo(e,i,o.min,o.max,D),W=R(N),q=v(a[s]),H=v(a[r]);E==-1&&([H,q]=[q,H]),b(V,H,W),b(V,q,W)}if(!o.spanGaps){let V=[];U&&V.push(...rp(a,l,s,r,E,v,t)),y.gaps=V=o.gaps(e,i,s,r,V),y.clip=hu(V,h.ori,f,_,w,m)}return z!=0&&(y.band=z==2?[Ts(e,i,s,r,T,-1),Ts(e,i,s,r,T,1)]:Ts(e,i,s,r,T,z)),y})}function ZT(n){let t=Te(n.align,1),e=Te(n.ascDesc,!1),i=Te(n.alignGaps,0),s=Te(n.extend,!1);return(r,o,a,l)=>Cr(r,o,(h,c,u,d,f,_,w,m,p,v,R)=>{[a,l]=ru(u,a,l);let b=h.pxRound,{left:C,width:E}=r.bbox,y=j=>b(_(j,d,v,m)),T=j=>b(w(j,f,R,p)),U=d.ori==0?Uo:Oo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:No},D=L.stroke,z=d.dir*(d.ori==0?1:-1),V=T(u[z==1?a:l]),N=y(c[z==1?a:l]),W=N,q=N;s&&t==-1&&(q=C,U(D,q,V)),U(D,N,V);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let et=u[j];if(et==null)continue;let dt=y(c[j]),ut=T(et);t==1?U(D,dt,V):U(D,W,ut),U(D,dt,ut),V=ut,W=dt}let H=W;s&&t==1&&(H=C+E,U(D,H,V));let[lt,Z]=sp(r,o);if(h.fill!=null||lt!=0){let j=L.fill=new Path2D(D),et=h.fillTo(r,o,h.min,h.max,lt),dt=T(et);U(j,H,dt),U(j,q,dt)}if(!h.spanGaps){let j=[];j.push(...rp(c,u,a,l,z,y,i));let et=h.width*Pe/2,dt=e||t==1?et:-et,ut=e||t==-1?-et:et;j.forEach(tt=>{tt[0]+=dt,tt[1]+=ut}),L.gaps=j=h.gaps(r,o,a,l,j),L.clip=hu(j,d.ori,m,p,v,R)}return Z!=0&&(L.band=Z==2?[Ts(r,o,a,l,D,-1),Ts(r,o,a,l,D,1)]:Ts(r,o,a,l,D,Z)),L})}function c_(n,t,e,i,s,r,o=Ge){if(n.length>1){let a=null;for(let l=0,h=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let c=Ti(n[l]-n[a]);c<h&&(h=c,o=Ti(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function KT(n){n=n||Ja;let t=Te(n.size,[.6,Ge,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=ve(s),o=1-t[0],a=Te(t[1],Ge),l=Te(t[2],1),h=Te(n.disp,Ja),c=Te(n.each,f=>{}),{fill:u,stroke:d}=h;return(f,_,w,m)=>Cr(f,_,(p,v,R,b,C,E,y,T,U,L,D)=>{let z=p.pxRound,V=e,N=i*Pe,W=a*Pe,q=l*Pe,H,lt;b.ori==0?[H,lt]=r(f,_):[lt,H]=r(f,_);let Z=b.dir*(b.ori==0?1:-1),j=b.ori==0?du:op,et=b.ori==0?c:(Rt,Zt,ae,St,ze,zt,$t)=>{c(Rt,Zt,ae,ze,St,$t,zt)},dt=Te(f.bands,Qf).find(Rt=>Rt.series[0]==_),ut=dt!=null?dt.dir:0,tt=p.fillTo(f,_,p.min,p.max,ut),mt=z(y(tt,C,D,U)),xt,Et,wt,Wt=L,oe=z(p.width*Pe),Vt=!1,de=null,he=null,se=null,Je=null;u!=null&&(oe==0||d!=null)&&(Vt=!0,de=u.values(f,_,w,m),he=new Map,new Set(de).forEach(Rt=>{Rt!=null&&he.set(Rt,new Path2D)}),oe>0&&(se=d.values(f,_,w,m),Je=new Map,new Set(se).forEach(Rt=>{Rt!=null&&Je.set(Rt,new Path2D)})));let{x0:He,size:ui}=h;if(He!=null&&ui!=null){V=1,v=He.values(f,_,w,m),He.unit==2&&(v=v.map(ae=>f.posToVal(T+ae*L,b.key,!0)));let Rt=ui.values(f,_,w,m);ui.unit==2?Et=Rt[0]*L:Et=E(Rt[0],b,L,T)-E(0,b,L,T),Wt=c_(v,R,E,b,L,T,Wt),wt=Wt-Et+N}else Wt=c_(v,R,E,b,L,T,Wt),wt=Wt*o+N,Et=Wt-wt;wt<1&&(wt=0),oe>=Et/2&&(oe=0),wt<5&&(z=y_);let ke=wt>0,Ei=Wt-wt-(ke?oe:0);Et=z(Gf(Ei,q,W)),xt=(V==0?Et/2:V==Z?0:Et)-V*Z*((V==0?N/2:0)+(ke?oe/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},vi=Vt?null:new Path2D,ni=null;if(dt!=null)ni=f.data[dt.series[1]];else{let{y0:Rt,y1:Zt}=h;Rt!=null&&Zt!=null&&(R=Zt.values(f,_,w,m),ni=Rt.values(f,_,w,m))}let di=H*Et,k=lt*Et;for(let Rt=Z==1?w:m;Rt>=w&&Rt<=m;Rt+=Z){let Zt=R[Rt];if(Zt==null)continue;if(ni!=null){let $=ni[Rt]??0;if(Zt-$==0)continue;mt=y($,C,D,U)}let ae=b.distr!=2||h!=null?v[Rt]:Rt,St=E(ae,b,L,T),ze=y(Te(Zt,tt),C,D,U),zt=z(St-xt),$t=z(ji(ze,mt)),P=z(Hn(ze,mt)),S=$t-P;if(Zt!=null){let $=Zt<0?k:di,ct=Zt<0?di:k;Vt?(oe>0&&se[Rt]!=null&&j(Je.get(se[Rt]),zt,P+gn(oe/2),Et,ji(0,S-oe),$,ct),de[Rt]!=null&&j(he.get(de[Rt]),zt,P+gn(oe/2),Et,ji(0,S-oe),$,ct)):j(vi,zt,P+gn(oe/2),Et,ji(0,S-oe),$,ct),et(f,_,Rt,zt-oe/2,P,Et+oe,S)}}return oe>0?be.stroke=Vt?Je:vi:Vt||(be._fill=p.width==0?p._fill:p._stroke??p._fill,be.width=0),be.fill=Vt?he:vi,be})}function JT(n,t){let e=Te(t?.alignGaps,0);return(i,s,r,o)=>Cr(i,s,(a,l,h,c,u,d,f,_,w,m,p)=>{[r,o]=ru(h,r,o);let v=a.pxRound,R=H=>v(d(H,c,m,_)),b=H=>v(f(H,u,p,w)),C,E,y;c.ori==0?(C=cu,y=Uo,E=$_):(C=uu,y=Oo,E=q_);let T=c.dir*(c.ori==0?1:-1),U=R(l[T==1?r:o]),L=U,D=[],z=[];for(let H=T==1?r:o;H>=r&&H<=o;H+=T)if(h[H]!=null){let Z=l[H],j=R(Z);D.push(L=j),z.push(b(h[H]))}let V={stroke:n(D,z,C,y,E,v),fill:null,clip:null,band:null,gaps:null,flags:No},N=V.stroke,[W,q]=sp(i,s);if(a.fill!=null||W!=0){let H=V.fill=new Path2D(N),lt=a.fillTo(i,s,a.min,a.max,W),Z=b(lt);y(H,L,Z),y(H,U,Z)}if(!a.spanGaps){let H=[];H.push(...rp(l,h,r,o,T,R,e)),V.gaps=H=a.gaps(i,s,r,o,H),V.clip=hu(H,c.ori,_,w,m,p)}return q!=0&&(V.band=q==2?[Ts(i,s,r,o,N,-1),Ts(i,s,r,o,N,1)]:Ts(i,s,r,o,N,q)),V})}function jT(n){return JT(QT,n)}function QT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),h=Array(o-1),c=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)c[d]=t[d+1]-t[d],u[d]=n[d+1]-n[d],h[d]=c[d]/u[d];l[0]=h[0];for(let d=1;d<o-1;d++)h[d]===0||h[d-1]===0||h[d-1]>0!=h[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/h[d-1]+(u[d]+2*u[d-1])/h[d]),isFinite(l[d])||(l[d]=0));l[o-1]=h[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,t[d]+l[d]*u[d]/3,n[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,n[d+1],t[d+1])}return a}var Xf=new Set;function u_(){for(let n of Xf)n.syncRect(!0)}Fo&&(Tr(DA,Po,u_),Tr(NA,Po,u_,!0),Tr(iu,Po,()=>{ki.pxRatio=Pe}));var tE=K_(),eE=Y_();function d_(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>$f(r,o,t,e))}function iE(n,t){return n.map((e,i)=>i==0?{}:yi({},t,e))}function $f(n,t,e,i){return yi({},t==0?e:i,n)}function J_(n,t,e){return t==null?Lo:[t,e]}var nE=J_;function sE(n,t,e){return t==null?Lo:nu(t,e,Jf,!0)}function j_(n,t,e,i){return t==null?Lo:ou(t,e,n.scales[i].log,!1)}var rE=j_;function Q_(n,t,e,i){return t==null?Lo:Kf(t,e,n.scales[i].log,!1)}var oE=Q_;function aE(n,t,e,i,s){let r=ji(W0(n),W0(t)),o=t-n,a=Vn(s/i*o,e);do{let l=e[a],h=i*l/o;if(h>=s&&r+(l<5?nr.get(l):0)<=17)return[l,h]}while(++a<e.length);return[0,0]}function f_(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Ai((e=+s)*Pe))+"px"),[n,t,e]}function lE(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ve(t[2]*Pe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ki(n,t,e){let i={mode:Te(n.mode,1)},s=i.mode;function r(x,M,I,F){let X=M.valToPct(x);return F+I*(M.dir==-1?1-X:X)}function o(x,M,I,F){let X=M.valToPct(x);return F+I*(M.dir==-1?X:1-X)}function a(x,M,I,F){return M.ori==0?r(x,M,I,F):o(x,M,I,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let h=i.root=Tn(mA);if(n.id!=null&&(h.id=n.id),mn(h,n.class),n.title){let x=Tn(xA,h);x.textContent=n.title}let c=Gn("canvas"),u=i.ctx=c.getContext("2d"),d=Tn(yA,h);Tr("click",d,x=>{x.target===_&&($e!=Fr||je!=Ur)&&Ni.click(i,x)},!0);let f=i.under=Tn(vA,d);d.appendChild(c);let _=i.over=Tn(bA,d);n=Do(n);let w=+Te(n.pxAlign,1),m=h_(w);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let p=n.ms||.001,v=i.series=s==1?d_(n.series||[],i_,a_,!1):iE(n.series||[null],o_),R=i.axes=d_(n.axes||[],e_,s_,!0),b=i.scales={},C=i.bands=n.bands||[];C.forEach(x=>{x.fill=ve(x.fill||null),x.dir=Te(x.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,y={axes:hs,series:pe},T=(n.drawOrder||["axes","series"]).map(x=>y[x]);function U(x){let M=x.distr==3?I=>As(I>0?I:x.clamp(i,I,x.min,x.max,x.key)):x.distr==4?I=>Df(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let F=M(I),{_min:X,_max:J}=x,at=J-X;return(F-X)/at}}function L(x){let M=b[x];if(M==null){let I=(n.scales||Ja)[x]||Ja;if(I.from!=null){L(I.from);let F=yi({},b[I.from],I,{key:x});F.valToPct=U(F),b[x]=F}else{M=b[x]=yi({},x==E?G_:WT,I),M.key=x;let F=M.time,X=M.range,J=ir(X);if((x!=E||s==2&&!F)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?G0:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?G0:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&lu(X))){let at=X;X=(ft,vt,Dt)=>vt==null?Lo:nu(vt,Dt,at)}M.range=ve(X||(F?nE:x==E?M.distr==3?rE:M.distr==4?oE:J_:M.distr==3?j_:M.distr==4?Q_:sE)),M.auto=ve(J?!1:M.auto),M.clamp=ve(M.clamp||HT),M._min=M._max=null,M.valToPct=U(M)}}}L("x"),L("y"),s==1&&v.forEach(x=>{L(x.scale)}),R.forEach(x=>{L(x.scale)});for(let x in n.scales)L(x);let D=b[E],z=D.distr,V,N;D.ori==0?(mn(h,gA),V=r,N=o):(mn(h,_A),V=o,N=r);let W={};for(let x in b){let M=b[x];(M.min!=null||M.max!=null)&&(W[x]={min:M.min,max:M.max},M.min=M.max=null)}let q=n.tzDate||(x=>new Date(Ai(x/p))),H=n.fmtDate||tp,lt=p==1?gT(q):yT(q),Z=j0(q,J0(p==1?mT:xT,H)),j=t_(q,Q0(bT,H)),et=[],dt=i.legend=yi({},MT,n.legend),ut=i.cursor=yi({},PT,{drag:{y:s==2}},n.cursor),tt=dt.show,mt=ut.show,xt=dt.markers;dt.idxs=et,xt.width=ve(xt.width),xt.dash=ve(xt.dash),xt.stroke=ve(xt.stroke),xt.fill=ve(xt.fill);let Et,wt,Wt,oe=[],Vt=[],de,he=!1,se={};if(dt.live){let x=v[1]?v[1].values:null;he=x!=null,de=he?x(i,1,0):{_:0};for(let M in de)se[M]=Yf}if(tt)if(Et=Gn("table",EA,h),Wt=Gn("tbody",null,Et),dt.mount(i,Et),he){wt=Gn("thead",null,Et,Wt);let x=Gn("tr",null,wt);Gn("th",null,x);for(var Je in de)Gn("th",C0,x).textContent=Je}else mn(Et,RA),dt.live&&mn(Et,CA);let He={show:!0},ui={show:!1};function ke(x,M){if(M==0&&(he||!dt.live||s==2))return Lo;let I=[],F=Gn("tr",PA,Wt,Wt.childNodes[M]);mn(F,x.class),x.show||mn(F,Ar);let X=Gn("th",null,F);if(xt.show){let ft=Tn(IA,X);if(M>0){let vt=xt.width(i,M);vt&&(ft.style.border=vt+"px "+xt.dash(i,M)+" "+xt.stroke(i,M)),ft.style.background=xt.fill(i,M)}}let J=Tn(C0,X);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,M>0&&(xt.show||(J.style.color=x.width>0?xt.stroke(i,M):xt.fill(i,M)),be("click",X,ft=>{if(ut._lock)return;jt(ft);let vt=v.indexOf(x);if((ft.ctrlKey||ft.metaKey)!=dt.isolate){let Dt=v.some((Nt,Ut)=>Ut>0&&Ut!=vt&&Nt.show);v.forEach((Nt,Ut)=>{Ut>0&&Yn(Ut,Dt?Ut==vt?He:ui:He,!0,gi.setSeries)})}else Yn(vt,{show:!x.show},!0,gi.setSeries)},!1),Qt&&be(L0,X,ft=>{ut._lock||(jt(ft),Yn(v.indexOf(x),kr,!0,gi.setSeries))},!1));for(var at in de){let ft=Gn("td",LA,F);ft.textContent="--",I.push(ft)}return[F,I]}let Ei=new Map;function be(x,M,I,F=!0){let X=Ei.get(M)||{},J=ut.bind[x](i,M,I,F);J&&(Tr(x,M,X[x]=J),Ei.set(M,X))}function vi(x,M,I){let F=Ei.get(M)||{};for(let X in F)(x==null||X==x)&&(zf(X,M,F[X]),delete F[X]);x==null&&Ei.delete(M)}let ni=0,di=0,k=0,Rt=0,Zt=0,ae=0,St=Zt,ze=ae,zt=k,$t=Rt,P=0,S=0,$=0,ct=0;i.bbox={};let ot=!1,_t=!1,yt=!1,it=!1,st=!1,pt=!1;function O(x,M,I){(I||x!=i.width||M!=i.height)&&rt(x,M),ce(!1),yt=!0,_t=!0,Bi()}function rt(x,M){i.width=ni=k=x,i.height=di=Rt=M,Zt=ae=0,bt(),Ht();let I=i.bbox;P=I.left=Sr(Zt*Pe,.5),S=I.top=Sr(ae*Pe,.5),$=I.width=Sr(k*Pe,.5),ct=I.height=Sr(Rt*Pe,.5)}let nt=3;function Mt(){let x=!1,M=0;for(;!x;){M++;let I=Lr(M),F=qn(M);x=M==nt||I&&F,x||(rt(i.width,i.height),_t=!0)}}function gt({width:x,height:M}){O(x,M)}i.setSize=gt;function bt(){let x=!1,M=!1,I=!1,F=!1;R.forEach((X,J)=>{if(X.show&&X._show){let{side:at,_size:ft}=X,vt=at%2,Dt=X.label!=null?X.labelSize:0,Nt=ft+Dt;Nt>0&&(vt?(k-=Nt,at==3?(Zt+=Nt,F=!0):I=!0):(Rt-=Nt,at==0?(ae+=Nt,x=!0):M=!0))}}),Xn[0]=x,Xn[1]=I,Xn[2]=M,Xn[3]=F,k-=Cn[1]+Cn[3],Zt+=Cn[3],Rt-=Cn[2]+Cn[0],ae+=Cn[0]}function Ht(){let x=Zt+k,M=ae+Rt,I=Zt,F=ae;function X(J,at){switch(J){case 1:return x+=at,x-at;case 2:return M+=at,M-at;case 3:return I-=at,I+at;case 0:return F-=at,F+at}}R.forEach((J,at)=>{if(J.show&&J._show){let ft=J.side;J._pos=X(ft,J._size),J.label!=null&&(J._lpos=X(ft,J.labelSize))}})}if(ut.dataIdx==null){let x=ut.hover,M=x.skip=new Set(x.skip??[]);M.add(void 0);let I=x.prox=ve(x.prox),F=x.bias??=0;ut.dataIdx=(X,J,at,ft)=>{if(J==0)return at;let vt=at,Dt=I(X,J,at,ft)??Ge,Nt=Dt>=0&&Dt<Ge,Ut=D.ori==0?k:Rt,re=ut.left,Ee=t[0],Se=t[J];if(M.has(Se[at])){vt=null;let _e=null,Jt=null,Xt;if(F==0||F==-1)for(Xt=at;_e==null&&Xt-- >0;)M.has(Se[Xt])||(_e=Xt);if(F==0||F==1)for(Xt=at;Jt==null&&Xt++<Se.length;)M.has(Se[Xt])||(Jt=Xt);if(_e!=null||Jt!=null)if(Nt){let Ye=_e==null?-1/0:V(Ee[_e],D,Ut,0),oi=Jt==null?1/0:V(Ee[Jt],D,Ut,0),Ii=re-Ye,Be=oi-re;Ii<=Be?Ii<=Dt&&(vt=_e):Be<=Dt&&(vt=Jt)}else vt=Jt==null?_e:_e==null?Jt:at-_e<=Jt-at?_e:Jt}else Nt&&Ti(re-V(Ee[at],D,Ut,0))>Dt&&(vt=null);return vt}}let jt=x=>{ut.event=x};ut.idxs=et,ut._lock=!1;let ht=ut.points;ht.show=ve(ht.show),ht.size=ve(ht.size),ht.stroke=ve(ht.stroke),ht.width=ve(ht.width),ht.fill=ve(ht.fill);let Ot=i.focus=yi({},n.focus||{alpha:.3},ut.focus),Qt=Ot.prox>=0,Ct=Qt&&ht.one,le=[],Xe=[],Wi=[];function Vo(x,M){let I=ht.show(i,M);if(I instanceof HTMLElement)return mn(I,TA),mn(I,x.class),rs(I,-10,-10,k,Rt),_.insertBefore(I,le[M]),I}function Rr(x,M){if(s==1||M>0){let I=s==1&&b[x.scale].time,F=x.value;x.value=I?q0(F)?t_(q,Q0(F,H)):F||j:F||zT,x.label=x.label||(I?LT:IT)}if(Ct||M>0){x.width=x.width==null?1:x.width,x.paths=x.paths||tE||WA,x.fillTo=ve(x.fillTo||XT),x.pxAlign=+Te(x.pxAlign,w),x.pxRound=h_(x.pxAlign),x.stroke=ve(x.stroke||null),x.fill=ve(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=GT(ji(1,x.width),1),F=x.points=yi({},{size:I,width:ji(1,I*.2),stroke:x.stroke,space:I*2,paths:eE,_stroke:null,_fill:null},x.points);F.show=ve(F.show),F.filter=ve(F.filter),F.fill=ve(F.fill),F.stroke=ve(F.stroke),F.paths=ve(F.paths),F.pxAlign=x.pxAlign}if(tt){let I=ke(x,M);oe.splice(M,0,I[0]),Vt.splice(M,0,I[1]),dt.values.push(null)}if(mt){et.splice(M,0,null);let I=null;Ct?M==0&&(I=Vo(x,M)):M>0&&(I=Vo(x,M)),le.splice(M,0,I),Xe.splice(M,0,0),Wi.splice(M,0,0)}Pi("addSeries",M)}function Iu(x,M){M=M??v.length,x=s==1?$f(x,M,i_,a_):$f(x,M,{},o_),v.splice(M,0,x),Rr(v[M],M)}i.addSeries=Iu;function il(x){if(v.splice(x,1),tt){dt.values.splice(x,1),Vt.splice(x,1);let M=oe.splice(x,1)[0];vi(null,M.firstChild),M.remove()}mt&&(et.splice(x,1),le.splice(x,1)[0].remove(),Xe.splice(x,1),Wi.splice(x,1)),Pi("delSeries",x)}i.delSeries=il;let Xn=[!1,!1,!1,!1];function os(x,M){if(x._show=x.show,x.show){let I=x.side%2,F=b[x.scale];F==null&&(x.scale=I?v[1].scale:E,F=b[x.scale]);let X=F.time;x.size=ve(x.size),x.space=ve(x.space),x.rotate=ve(x.rotate),ir(x.incrs)&&x.incrs.forEach(at=>{!nr.has(at)&&nr.set(at,w_(at))}),x.incrs=ve(x.incrs||(F.distr==2?dT:X?p==1?pT:_T:Mr)),x.splits=ve(x.splits||(X&&F.distr==1?lt:F.distr==3?Vf:F.distr==4?FT:NT)),x.stroke=ve(x.stroke),x.grid.stroke=ve(x.grid.stroke),x.ticks.stroke=ve(x.ticks.stroke),x.border.stroke=ve(x.border.stroke);let J=x.values;x.values=ir(J)&&!ir(J[0])?ve(J):X?ir(J)?j0(q,J0(J,H)):q0(J)?vT(q,J):J||Z:J||DT,x.filter=ve(x.filter||(F.distr>=3&&F.log==10?kT:F.distr==3&&F.log==2?BT:v_)),x.font=f_(x.font),x.labelFont=f_(x.labelFont),x._size=x.size(i,null,M,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Xn[M]=!0,x._el=Tn(wA,d))}}function as(x,M,I,F){let[X,J,at,ft]=I,vt=M%2,Dt=0;return vt==0&&(ft||J)&&(Dt=M==0&&!X||M==2&&!at?Ai(e_.size/3):0),vt==1&&(X||at)&&(Dt=M==1&&!J||M==3&&!ft?Ai(s_.size/2):0),Dt}let Ho=i.padding=(n.padding||[as,as,as,as]).map(x=>ve(Te(x,as))),Cn=i._padding=Ho.map((x,M)=>x(i,M,Xn,0)),si,hi=null,ci=null,$n=s==1?v[0].idxs:null,nn=null,Es=!1;function Wo(x,M){if(t=x??[],i.data=i._data=t,s==2){si=0;for(let I=1;I<v.length;I++)si+=t[I][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),nn=t[0],si=nn.length;let I=t;if(z==2){I=t.slice();let F=I[0]=Array(si);for(let X=0;X<si;X++)F[X]=X}i._data=t=I}if(ce(!0),Pi("setData"),z==2&&(yt=!0),M!==!1){let I=D;I.auto(i,Es)?Xo():Ps(E,I.min,I.max),it=it||ut.left>=0,pt=!0,Bi()}}i.setData=Wo;function Xo(){Es=!0;let x,M;s==1&&(si>0?(hi=$n[0]=0,ci=$n[1]=si-1,x=t[0][hi],M=t[0][ci],z==2?(x=hi,M=ci):x==M&&(z==3?[x,M]=ou(x,x,D.log,!1):z==4?[x,M]=Kf(x,x,D.log,!1):D.time?M=x+Ai(86400/p):[x,M]=nu(x,M,Jf,!0))):(hi=$n[0]=x=null,ci=$n[1]=M=null)),Ps(E,x,M)}let Pr,Cs,Ir,A,G,Q,Y,K,At,Pt;function Tt(x,M,I,F,X,J){x??=P0,I??=Qf,F??="butt",X??=P0,J??="round",x!=Pr&&(u.strokeStyle=Pr=x),X!=Cs&&(u.fillStyle=Cs=X),M!=Ir&&(u.lineWidth=Ir=M),J!=G&&(u.lineJoin=G=J),F!=Q&&(u.lineCap=Q=F),I!=A&&u.setLineDash(A=I)}function It(x,M,I,F){M!=Cs&&(u.fillStyle=Cs=M),x!=Y&&(u.font=Y=x),I!=K&&(u.textAlign=K=I),F!=At&&(u.textBaseline=At=F)}function Bt(x,M,I,F,X=0){if(F.length>0&&x.auto(i,Es)&&(M==null||M.min==null)){let J=Te(hi,0),at=Te(ci,F.length-1),ft=I.min==null?kA(F,J,at,X,x.distr==3):[I.min,I.max];x.min=Hn(x.min,I.min=ft[0]),x.max=ji(x.max,I.max=ft[1])}}let ee={min:null,max:null};function fe(){for(let F in b){let X=b[F];W[F]==null&&(X.min==null||W[E]!=null&&X.auto(i,Es))&&(W[F]=ee)}for(let F in b){let X=b[F];W[F]==null&&X.from!=null&&W[X.from]!=null&&(W[F]=ee)}W[E]!=null&&ce(!0);let x={};for(let F in W){let X=W[F];if(X!=null){let J=x[F]=Do(b[F],qA);if(X.min!=null)yi(J,X);else if(F!=E||s==2)if(si==0&&J.from==null){let at=J.range(i,null,null,F);J.min=at[0],J.max=at[1]}else J.min=Ge,J.max=-Ge}}if(si>0){v.forEach((F,X)=>{if(s==1){let J=F.scale,at=W[J];if(at==null)return;let ft=x[J];if(X==0){let vt=ft.range(i,ft.min,ft.max,J);ft.min=vt[0],ft.max=vt[1],hi=Vn(ft.min,t[0]),ci=Vn(ft.max,t[0]),ci-hi>1&&(t[0][hi]<ft.min&&hi++,t[0][ci]>ft.max&&ci--),F.min=nn[hi],F.max=nn[ci]}else F.show&&F.auto&&Bt(ft,at,F,t[X],F.sorted);F.idxs[0]=hi,F.idxs[1]=ci}else if(X>0&&F.show&&F.auto){let[J,at]=F.facets,ft=J.scale,vt=at.scale,[Dt,Nt]=t[X],Ut=x[ft],re=x[vt];Ut!=null&&Bt(Ut,W[ft],J,Dt,J.sorted),re!=null&&Bt(re,W[vt],at,Nt,at.sorted),F.min=at.min,F.max=at.max}});for(let F in x){let X=x[F],J=W[F];if(X.from==null&&(J==null||J.min==null)){let at=X.range(i,X.min==Ge?null:X.min,X.max==-Ge?null:X.max,F);X.min=at[0],X.max=at[1]}}}for(let F in x){let X=x[F];if(X.from!=null){let J=x[X.from];if(J.min==null)X.min=X.max=null;else{let at=X.range(i,J.min,J.max,F);X.min=at[0],X.max=at[1]}}}let M={},I=!1;for(let F in x){let X=x[F],J=b[F];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let at=J.distr;J._min=at==3?As(J.min):at==4?Df(J.min,J.asinh):at==100?J.fwd(J.min):J.min,J._max=at==3?As(J.max):at==4?Df(J.max,J.asinh):at==100?J.fwd(J.max):J.max,M[F]=I=!0}}if(I){v.forEach((F,X)=>{s==2?X>0&&M.y&&(F._paths=null):M[F.scale]&&(F._paths=null)});for(let F in M)yt=!0,Pi("setScale",F);mt&&ut.left>=0&&(it=pt=!0)}for(let F in W)W[F]=null}function kt(x){let M=Gf(hi-1,0,si-1),I=Gf(ci+1,0,si-1);for(;x[M]==null&&M>0;)M--;for(;x[I]==null&&I<si-1;)I++;return[M,I]}function pe(){if(si>0){let x=v.some(M=>M._focus)&&Pt!=Ot.alpha;x&&(u.globalAlpha=Pt=Ot.alpha),v.forEach((M,I)=>{if(I>0&&M.show&&(ei(I,!1),ei(I,!0),M._paths==null)){let F=Pt;Pt!=M.alpha&&(u.globalAlpha=Pt=M.alpha);let X=s==2?[0,t[I][0].length-1]:kt(t[I]);M._paths=M.paths(i,I,X[0],X[1]),Pt!=F&&(u.globalAlpha=Pt=F)}}),v.forEach((M,I)=>{if(I>0&&M.show){let F=Pt;Pt!=M.alpha&&(u.globalAlpha=Pt=M.alpha),M._paths!=null&&Ne(I,!1);{let X=M._paths!=null?M._paths.gaps:null,J=M.points.show(i,I,hi,ci,X),at=M.points.filter(i,I,J,X);(J||at)&&(M.points._paths=M.points.paths(i,I,hi,ci,at),Ne(I,!0))}Pt!=F&&(u.globalAlpha=Pt=F),Pi("drawSeries",I)}}),x&&(u.globalAlpha=Pt=1)}}function ei(x,M){let I=M?v[x].points:v[x];I._stroke=I.stroke(i,x),I._fill=I.fill(i,x)}function Ne(x,M){let I=M?v[x].points:v[x],{stroke:F,fill:X,clip:J,flags:at,_stroke:ft=I._stroke,_fill:vt=I._fill,_width:Dt=I.width}=I._paths;Dt=Ve(Dt*Pe,3);let Nt=null,Ut=Dt%2/2;M&&vt==null&&(vt=Dt>0?"#fff":ft);let re=I.pxAlign==1&&Ut>0;if(re&&u.translate(Ut,Ut),!M){let Ee=P-Dt/2,Se=S-Dt/2,_e=$+Dt,Jt=ct+Dt;Nt=new Path2D,Nt.rect(Ee,Se,_e,Jt)}M?Ft(ft,Dt,I.dash,I.cap,vt,F,X,at,J):Fe(x,ft,Dt,I.dash,I.cap,vt,F,X,at,Nt,J),re&&u.translate(-Ut,-Ut)}function Fe(x,M,I,F,X,J,at,ft,vt,Dt,Nt){let Ut=!1;vt!=0&&C.forEach((re,Ee)=>{if(re.series[0]==x){let Se=v[re.series[1]],_e=t[re.series[1]],Jt=(Se._paths||Ja).band;ir(Jt)&&(Jt=re.dir==1?Jt[0]:Jt[1]);let Xt,Ye=null;Se.show&&Jt&&zA(_e,hi,ci)?(Ye=re.fill(i,Ee)||J,Xt=Se._paths.clip):Jt=null,Ft(M,I,F,X,Ye,at,ft,vt,Dt,Nt,Xt,Jt),Ut=!0}}),Ut||Ft(M,I,F,X,J,at,ft,vt,Dt,Nt)}let bi=No|Wf;function Ft(x,M,I,F,X,J,at,ft,vt,Dt,Nt,Ut){Tt(x,M,I,F,X),(vt||Dt||Ut)&&(u.save(),vt&&u.clip(vt),Dt&&u.clip(Dt)),Ut?(ft&bi)==bi?(u.clip(Ut),Nt&&u.clip(Nt),xe(X,at),fi(x,J,M)):ft&Wf?(xe(X,at),u.clip(Ut),fi(x,J,M)):ft&No&&(u.save(),u.clip(Ut),Nt&&u.clip(Nt),xe(X,at),u.restore(),fi(x,J,M)):(xe(X,at),fi(x,J,M)),(vt||Dt||Ut)&&u.restore()}function fi(x,M,I){I>0&&(M instanceof Map?M.forEach((F,X)=>{u.strokeStyle=Pr=X,u.stroke(F)}):M!=null&&x&&u.stroke(M))}function xe(x,M){M instanceof Map?M.forEach((I,F)=>{u.fillStyle=Cs=F,u.fill(I)}):M!=null&&x&&u.fill(M)}function ls(x,M,I,F){let X=R[x],J;if(F<=0)J=[0,0];else{let at=X._space=X.space(i,x,M,I,F),ft=X._incrs=X.incrs(i,x,M,I,F,at);J=aE(M,I,ft,F,at)}return X._found=J}function pi(x,M,I,F,X,J,at,ft,vt,Dt){let Nt=at%2/2;w==1&&u.translate(Nt,Nt),Tt(ft,at,vt,Dt,ft),u.beginPath();let Ut,re,Ee,Se,_e=X+(F==0||F==3?-J:J);I==0?(re=X,Se=_e):(Ut=X,Ee=_e);for(let Jt=0;Jt<x.length;Jt++)M[Jt]!=null&&(I==0?Ut=Ee=x[Jt]:re=Se=x[Jt],u.moveTo(Ut,re),u.lineTo(Ee,Se));u.stroke(),w==1&&u.translate(-Nt,-Nt)}function Lr(x){let M=!0;return R.forEach((I,F)=>{if(!I.show)return;let X=b[I.scale];if(X.min==null){I._show&&(M=!1,I._show=!1,ce(!1));return}else I._show||(M=!1,I._show=!0,ce(!1));let J=I.side,at=J%2,{min:ft,max:vt}=X,[Dt,Nt]=ls(F,ft,vt,at==0?k:Rt);if(Nt==0)return;let Ut=X.distr==2,re=I._splits=I.splits(i,F,ft,vt,Dt,Nt,Ut),Ee=X.distr==2?re.map(Xt=>nn[Xt]):re,Se=X.distr==2?nn[re[1]]-nn[re[0]]:Dt,_e=I._values=I.values(i,I.filter(i,Ee,F,Nt,Se),F,Nt,Se);I._rotate=J==2?I.rotate(i,_e,F,Nt):0;let Jt=I._size;I._size=En(I.size(i,_e,F,x)),Jt!=null&&I._size!=Jt&&(M=!1)}),M}function qn(x){let M=!0;return Ho.forEach((I,F)=>{let X=I(i,F,Xn,x);X!=Cn[F]&&(M=!1),Cn[F]=X}),M}function hs(){for(let x=0;x<R.length;x++){let M=R[x];if(!M.show||!M._show)continue;let I=M.side,F=I%2,X,J,at=M.stroke(i,x),ft=I==0||I==3?-1:1,[vt,Dt]=M._found;if(M.label!=null){let qi=M.labelGap*ft,on=Ai((M._lpos+qi)*Pe);It(M.labelFont[0],at,"center",I==2?"top":R0),u.save(),F==1?(X=J=0,u.translate(on,Ai(S+ct/2)),u.rotate((I==3?-eu:eu)/2)):(X=Ai(P+$/2),J=on);let or=x_(M.label)?M.label(i,x,vt,Dt):M.label;u.fillText(or,X,J),u.restore()}if(Dt==0)continue;let Nt=b[M.scale],Ut=F==0?$:ct,re=F==0?P:S,Ee=M._splits,Se=Nt.distr==2?Ee.map(qi=>nn[qi]):Ee,_e=Nt.distr==2?nn[Ee[1]]-nn[Ee[0]]:vt,Jt=M.ticks,Xt=M.border,Ye=Jt.show?Jt.size:0,oi=Ai(Ye*Pe),Ii=Ai((M.alignTo==2?M._size-Ye-M.gap:M.gap)*Pe),Be=M._rotate*-eu/180,ai=m(M._pos*Pe),sn=(oi+Ii)*ft,$i=ai+sn;J=F==0?$i:0,X=F==1?$i:0;let yn=M.font[0],Rn=M.align==1?Co:M.align==2?Pf:Be>0?Co:Be<0?Pf:F==0?"center":I==3?Pf:Co,Kn=Be||F==1?"middle":I==2?"top":R0;It(yn,at,Rn,Kn);let rn=M.font[1]*M.lineGap,vn=Ee.map(qi=>m(a(qi,Nt,Ut,re))),Pn=M._values;for(let qi=0;qi<Pn.length;qi++){let on=Pn[qi];if(on!=null){F==0?X=vn[qi]:J=vn[qi],on=""+on;let or=on.indexOf(`
`)==-1?[on]:on.split(/\n/gm);for(let Yi=0;Yi<or.length;Yi++){let Lp=or[Yi];Be?(u.save(),u.translate(X,J+Yi*rn),u.rotate(Be),u.fillText(Lp,0,0),u.restore()):u.fillText(Lp,X,J+Yi*rn)}}}Jt.show&&pi(vn,Jt.filter(i,Se,x,Dt,_e),F,I,ai,oi,Ve(Jt.width*Pe,3),Jt.stroke(i,x),Jt.dash,Jt.cap);let Jn=M.grid;Jn.show&&pi(vn,Jn.filter(i,Se,x,Dt,_e),F,F==0?2:1,F==0?S:P,F==0?ct:$,Ve(Jn.width*Pe,3),Jn.stroke(i,x),Jn.dash,Jn.cap),Xt.show&&pi([ai],[1],F==0?1:0,F==0?1:2,F==1?S:P,F==1?ct:$,Ve(Xt.width*Pe,3),Xt.stroke(i,x),Xt.dash,Xt.cap)}Pi("drawAxes")}function ce(x){v.forEach((M,I)=>{I>0&&(M._paths=null,x&&(s==1?(M.min=null,M.max=null):M.facets.forEach(F=>{F.min=null,F.max=null})))})}let ri=!1,Xi=!1,Ue=[];function mi(){Xi=!1;for(let x=0;x<Ue.length;x++)Pi(...Ue[x]);Ue.length=0}function Bi(){ri||(tT(pp),ri=!0)}function nl(x,M=!1){ri=!0,Xi=M,x(i),pp(),M&&Ue.length>0&&queueMicrotask(mi)}i.batch=nl;function pp(){if(ot&&(fe(),ot=!1),yt&&(Mt(),yt=!1),_t){if(Ke(f,Co,Zt),Ke(f,"top",ae),Ke(f,qa,k),Ke(f,Ya,Rt),Ke(_,Co,Zt),Ke(_,"top",ae),Ke(_,qa,k),Ke(_,Ya,Rt),Ke(d,qa,ni),Ke(d,Ya,di),c.width=Ai(ni*Pe),c.height=Ai(di*Pe),R.forEach(({_el:x,_show:M,_size:I,_pos:F,side:X})=>{if(x!=null)if(M){let J=X===3||X===0?I:0,at=X%2==1;Ke(x,at?"left":"top",F-J),Ke(x,at?"width":"height",I),Ke(x,at?"top":"left",at?ae:Zt),Ke(x,at?"height":"width",at?Rt:k),Bf(x,Ar)}else mn(x,Ar)}),Pr=Cs=Ir=G=Q=Y=K=At=A=null,Pt=1,Yo(!0),Zt!=St||ae!=ze||k!=zt||Rt!=$t){ce(!1);let x=k/zt,M=Rt/$t;if(mt&&!it&&ut.left>=0){ut.left*=x,ut.top*=M,Dr&&rs(Dr,Ai(ut.left),0,k,Rt),Nr&&rs(Nr,0,Ai(ut.top),k,Rt);for(let I=0;I<le.length;I++){let F=le[I];F!=null&&(Xe[I]*=x,Wi[I]*=M,rs(F,En(Xe[I]),En(Wi[I]),k,Rt))}}if(qe.show&&!st&&qe.left>=0&&qe.width>0){qe.left*=x,qe.width*=x,qe.top*=M,qe.height*=M;for(let I in Ou)Ke(Or,I,qe[I])}St=Zt,ze=ae,zt=k,$t=Rt}Pi("setSize"),_t=!1}ni>0&&di>0&&(u.clearRect(0,0,c.width,c.height),Pi("drawClear"),T.forEach(x=>x()),Pi("draw")),qe.show&&st&&(sl(qe),st=!1),mt&&it&&(rr(null,!0,!1),it=!1),dt.show&&dt.live&&pt&&(Fu(),pt=!1),l||(l=!0,i.status=1,Pi("ready")),Es=!1,ri=!1}i.redraw=(x,M)=>{yt=M||!1,x!==!1?Ps(E,D.min,D.max):Bi()};function Lu(x,M){let I=b[x];if(I.from==null){if(si==0){let F=I.range(i,M.min,M.max,x);M.min=F[0],M.max=F[1]}if(M.min>M.max){let F=M.min;M.min=M.max,M.max=F}if(si>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;x==E&&I.distr==2&&si>0&&(M.min=Vn(M.min,t[0]),M.max=Vn(M.max,t[0]),M.min==M.max&&M.max++),W[x]=M,ot=!0,Bi()}}i.setScale=Lu;let Du,Nu,Dr,Nr,mp,gp,Fr,Ur,_p,xp,$e,je,Rs=!1,Ni=ut.drag,Ci=Ni.x,Ri=Ni.y;mt&&(ut.x&&(Du=Tn(MA,_)),ut.y&&(Nu=Tn(AA,_)),D.ori==0?(Dr=Du,Nr=Nu):(Dr=Nu,Nr=Du),$e=ut.left,je=ut.top);let qe=i.select=yi({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Or=qe.show?Tn(SA,qe.over?_:f):null;function sl(x,M){if(qe.show){for(let I in x)qe[I]=x[I],I in Ou&&Ke(Or,I,x[I]);M!==!1&&Pi("setSelect")}}i.setSelect=sl;function dx(x){if(v[x].show)tt&&Bf(oe[x],Ar);else if(tt&&mn(oe[x],Ar),mt){let I=Ct?le[0]:le[x];I!=null&&rs(I,-10,-10,k,Rt)}}function Ps(x,M,I){Lu(x,{min:M,max:I})}function Yn(x,M,I,F){M.focus!=null&&_x(x),M.show!=null&&v.forEach((X,J)=>{J>0&&(x==J||x==null)&&(X.show=M.show,dx(J),s==2?(Ps(X.facets[0].scale,null,null),Ps(X.facets[1].scale,null,null)):Ps(X.scale,null,null),Bi())}),I!==!1&&Pi("setSeries",x,M),F&&Zo("setSeries",i,x,M)}i.setSeries=Yn;function fx(x,M){yi(C[x],M)}function px(x,M){x.fill=ve(x.fill||null),x.dir=Te(x.dir,-1),M=M??C.length,C.splice(M,0,x)}function mx(x){x==null?C.length=0:C.splice(x,1)}i.addBand=px,i.setBand=fx,i.delBand=mx;function gx(x,M){v[x].alpha=M,mt&&le[x]!=null&&(le[x].style.opacity=M),tt&&oe[x]&&(oe[x].style.opacity=M)}let cs,Is,sr,kr={focus:!0};function _x(x){if(x!=sr){let M=x==null,I=Ot.alpha!=1;v.forEach((F,X)=>{if(s==1||X>0){let J=M||X==0||X==x;F._focus=M?null:J,I&&gx(X,J?1:Ot.alpha)}}),sr=x,I&&Bi()}}tt&&Qt&&be(D0,Et,x=>{ut._lock||(jt(x),sr!=null&&Yn(null,kr,!0,gi.setSeries))});function Zn(x,M,I){let F=b[M];I&&(x=x/Pe-(F.ori==1?ae:Zt));let X=k;F.ori==1&&(X=Rt,x=X-x),F.dir==-1&&(x=X-x);let J=F._min,at=F._max,ft=x/X,vt=J+(at-J)*ft,Dt=F.distr;return Dt==3?Io(10,vt):Dt==4?VA(vt,F.asinh):Dt==100?F.bwd(vt):vt}function xx(x,M){let I=Zn(x,E,M);return Vn(I,t[0],hi,ci)}i.valToIdx=x=>Vn(x,t[0]),i.posToIdx=xx,i.posToVal=Zn,i.valToPos=(x,M,I)=>b[M].ori==0?r(x,b[M],I?$:k,I?P:0):o(x,b[M],I?ct:Rt,I?S:0),i.setCursor=(x,M,I)=>{$e=x.left,je=x.top,rr(null,M,I)};function yp(x,M){Ke(Or,Co,qe.left=x),Ke(Or,qa,qe.width=M)}function vp(x,M){Ke(Or,"top",qe.top=x),Ke(Or,Ya,qe.height=M)}let $o=D.ori==0?yp:vp,qo=D.ori==1?yp:vp;function yx(){if(tt&&dt.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&he)continue;let M=dt.values[x],I=0;for(let F in M)Vt[x][I++].firstChild.nodeValue=M[F]}}function Fu(x,M){if(x!=null&&(x.idxs?x.idxs.forEach((I,F)=>{et[F]=I}):$A(x.idx)||et.fill(x.idx),dt.idx=et[0]),tt&&dt.live){for(let I=0;I<v.length;I++)(I>0||s==1&&!he)&&vx(I,et[I]);yx()}pt=!1,M!==!1&&Pi("setLegend")}i.setLegend=Fu;function vx(x,M){let I=v[x],F=x==0&&z==2?nn:t[x],X;he?X=I.values(i,x,M)??se:(X=I.value(i,M==null?null:F[M],x,M),X=X==null?se:{_:X}),dt.values[x]=X}function rr(x,M,I){_p=$e,xp=je,[$e,je]=ut.move(i,$e,je),ut.left=$e,ut.top=je,mt&&(Dr&&rs(Dr,Ai($e),0,k,Rt),Nr&&rs(Nr,0,Ai(je),k,Rt));let F,X=hi>ci;cs=Ge,Is=null;let J=D.ori==0?k:Rt,at=D.ori==1?k:Rt;if($e<0||si==0||X){F=ut.idx=null;for(let ft=0;ft<v.length;ft++){let vt=le[ft];vt!=null&&rs(vt,-10,-10,k,Rt)}Qt&&Yn(null,kr,!0,x==null&&gi.setSeries),dt.live&&(et.fill(F),pt=!0)}else{let ft,vt,Dt;s==1&&(ft=D.ori==0?$e:je,vt=Zn(ft,E),F=ut.idx=Vn(vt,t[0],hi,ci),Dt=V(t[0][F],D,J,0));let Nt=-10,Ut=-10,re=0,Ee=0,Se=!0,_e="",Jt="";for(let Xt=s==2?1:0;Xt<v.length;Xt++){let Ye=v[Xt],oi=et[Xt],Ii=oi==null?null:s==1?t[Xt][oi]:t[Xt][1][oi],Be=ut.dataIdx(i,Xt,F,vt),ai=Be==null?null:s==1?t[Xt][Be]:t[Xt][1][Be];if(pt=pt||ai!=Ii||Be!=oi,et[Xt]=Be,Xt>0&&Ye.show){let sn=Be==null?-10:Be==F?Dt:V(s==1?t[0][Be]:t[Xt][0][Be],D,J,0),$i=ai==null?-10:N(ai,s==1?b[Ye.scale]:b[Ye.facets[1].scale],at,0);if(Qt&&ai!=null){let yn=D.ori==1?$e:je,Rn=Ti(Ot.dist(i,Xt,Be,$i,yn));if(Rn<cs){let Kn=Ot.bias;if(Kn!=0){let rn=Zn(yn,Ye.scale),vn=ai>=0?1:-1,Pn=rn>=0?1:-1;Pn==vn&&(Pn==1?Kn==1?ai>=rn:ai<=rn:Kn==1?ai<=rn:ai>=rn)&&(cs=Rn,Is=Xt)}else cs=Rn,Is=Xt}}if(pt||Ct){let yn,Rn;D.ori==0?(yn=sn,Rn=$i):(yn=$i,Rn=sn);let Kn,rn,vn,Pn,Jn,qi,on=!0,or=ht.bbox;if(or!=null){on=!1;let Yi=or(i,Xt);vn=Yi.left,Pn=Yi.top,Kn=Yi.width,rn=Yi.height}else vn=yn,Pn=Rn,Kn=rn=ht.size(i,Xt);if(qi=ht.fill(i,Xt),Jn=ht.stroke(i,Xt),Ct)Xt==Is&&cs<=Ot.prox&&(Nt=vn,Ut=Pn,re=Kn,Ee=rn,Se=on,_e=qi,Jt=Jn);else{let Yi=le[Xt];Yi!=null&&(Xe[Xt]=vn,Wi[Xt]=Pn,z0(Yi,Kn,rn,on),k0(Yi,qi,Jn),rs(Yi,En(vn),En(Pn),k,Rt))}}}}if(Ct){let Xt=Ot.prox,Ye=sr==null?cs<=Xt:cs>Xt||Is!=sr;if(pt||Ye){let oi=le[0];oi!=null&&(Xe[0]=Nt,Wi[0]=Ut,z0(oi,re,Ee,Se),k0(oi,_e,Jt),rs(oi,En(Nt),En(Ut),k,Rt))}}}if(qe.show&&Rs)if(x!=null){let[ft,vt]=gi.scales,[Dt,Nt]=gi.match,[Ut,re]=x.cursor.sync.scales,Ee=x.cursor.drag;if(Ci=Ee._x,Ri=Ee._y,Ci||Ri){let{left:Se,top:_e,width:Jt,height:Xt}=x.select,Ye=x.scales[Ut].ori,oi=x.posToVal,Ii,Be,ai,sn,$i,yn=ft!=null&&Dt(ft,Ut),Rn=vt!=null&&Nt(vt,re);yn&&Ci?(Ye==0?(Ii=Se,Be=Jt):(Ii=_e,Be=Xt),ai=b[ft],sn=V(oi(Ii,Ut),ai,J,0),$i=V(oi(Ii+Be,Ut),ai,J,0),$o(Hn(sn,$i),Ti($i-sn))):$o(0,J),Rn&&Ri?(Ye==1?(Ii=Se,Be=Jt):(Ii=_e,Be=Xt),ai=b[vt],sn=N(oi(Ii,re),ai,at,0),$i=N(oi(Ii+Be,re),ai,at,0),qo(Hn(sn,$i),Ti($i-sn))):qo(0,at)}else ku()}else{let ft=Ti(_p-mp),vt=Ti(xp-gp);if(D.ori==1){let re=ft;ft=vt,vt=re}Ci=Ni.x&&ft>=Ni.dist,Ri=Ni.y&&vt>=Ni.dist;let Dt=Ni.uni;Dt!=null?Ci&&Ri&&(Ci=ft>=Dt,Ri=vt>=Dt,!Ci&&!Ri&&(vt>ft?Ri=!0:Ci=!0)):Ni.x&&Ni.y&&(Ci||Ri)&&(Ci=Ri=!0);let Nt,Ut;Ci&&(D.ori==0?(Nt=Fr,Ut=$e):(Nt=Ur,Ut=je),$o(Hn(Nt,Ut),Ti(Ut-Nt)),Ri||qo(0,at)),Ri&&(D.ori==1?(Nt=Fr,Ut=$e):(Nt=Ur,Ut=je),qo(Hn(Nt,Ut),Ti(Ut-Nt)),Ci||$o(0,J)),!Ci&&!Ri&&($o(0,0),qo(0,0))}if(Ni._x=Ci,Ni._y=Ri,x==null){if(I){if(Ip!=null){let[ft,vt]=gi.scales;gi.values[0]=ft!=null?Zn(D.ori==0?$e:je,ft):null,gi.values[1]=vt!=null?Zn(D.ori==1?$e:je,vt):null}Zo(If,i,$e,je,k,Rt,F)}if(Qt){let ft=I&&gi.setSeries,vt=Ot.prox;sr==null?cs<=vt&&Yn(Is,kr,!0,ft):cs>vt?Yn(null,kr,!0,ft):Is!=sr&&Yn(Is,kr,!0,ft)}}pt&&(dt.idx=F,Fu()),M!==!1&&Pi("setCursor")}let Ls=null;Object.defineProperty(i,"rect",{get(){return Ls==null&&Yo(!1),Ls}});function Yo(x=!1){x?Ls=null:(Ls=_.getBoundingClientRect(),Pi("syncRect",Ls))}function bp(x,M,I,F,X,J,at){ut._lock||Rs&&x!=null&&x.movementX==0&&x.movementY==0||(Uu(x,M,I,F,X,J,at,!1,x!=null),x!=null?rr(null,!0,!0):rr(M,!0,!1))}function Uu(x,M,I,F,X,J,at,ft,vt){if(Ls==null&&Yo(!1),jt(x),x!=null)I=x.clientX-Ls.left,F=x.clientY-Ls.top;else{if(I<0||F<0){$e=-10,je=-10;return}let[Dt,Nt]=gi.scales,Ut=M.cursor.sync,[re,Ee]=Ut.values,[Se,_e]=Ut.scales,[Jt,Xt]=gi.match,Ye=M.axes[0].side%2==1,oi=D.ori==0?k:Rt,Ii=D.ori==1?k:Rt,Be=Ye?J:X,ai=Ye?X:J,sn=Ye?F:I,$i=Ye?I:F;if(Se!=null?I=Jt(Dt,Se)?a(re,b[Dt],oi,0):-10:I=oi*(sn/Be),_e!=null?F=Xt(Nt,_e)?a(Ee,b[Nt],Ii,0):-10:F=Ii*($i/ai),D.ori==1){let yn=I;I=F,F=yn}}vt&&(M==null||M.cursor.event.type==If)&&((I<=1||I>=k-1)&&(I=Sr(I,k)),(F<=1||F>=Rt-1)&&(F=Sr(F,Rt))),ft?(mp=I,gp=F,[Fr,Ur]=ut.move(i,I,F)):($e=I,je=F)}let Ou={width:0,height:0,left:0,top:0};function ku(){sl(Ou,!1)}let wp,Sp,Mp,Ap;function Tp(x,M,I,F,X,J,at){Rs=!0,Ci=Ri=Ni._x=Ni._y=!1,Uu(x,M,I,F,X,J,at,!0,!1),x!=null&&(be(Lf,Of,Ep,!1),Zo(I0,i,Fr,Ur,k,Rt,null));let{left:ft,top:vt,width:Dt,height:Nt}=qe;wp=ft,Sp=vt,Mp=Dt,Ap=Nt}function Ep(x,M,I,F,X,J,at){Rs=Ni._x=Ni._y=!1,Uu(x,M,I,F,X,J,at,!1,!0);let{left:ft,top:vt,width:Dt,height:Nt}=qe,Ut=Dt>0||Nt>0,re=wp!=ft||Sp!=vt||Mp!=Dt||Ap!=Nt;if(Ut&&re&&sl(qe),Ni.setScale&&Ut&&re){let Ee=ft,Se=Dt,_e=vt,Jt=Nt;if(D.ori==1&&(Ee=vt,Se=Nt,_e=ft,Jt=Dt),Ci&&Ps(E,Zn(Ee,E),Zn(Ee+Se,E)),Ri)for(let Xt in b){let Ye=b[Xt];Xt!=E&&Ye.from==null&&Ye.min!=Ge&&Ps(Xt,Zn(_e+Jt,Xt),Zn(_e,Xt))}ku()}else ut.lock&&(ut._lock=!ut._lock,rr(M,!0,x!=null));x!=null&&(vi(Lf,Of),Zo(Lf,i,$e,je,k,Rt,null))}function bx(x,M,I,F,X,J,at){if(ut._lock)return;jt(x);let ft=Rs;if(Rs){let vt=!0,Dt=!0,Nt=10,Ut,re;D.ori==0?(Ut=Ci,re=Ri):(Ut=Ri,re=Ci),Ut&&re&&(vt=$e<=Nt||$e>=k-Nt,Dt=je<=Nt||je>=Rt-Nt),Ut&&vt&&($e=$e<Fr?0:k),re&&Dt&&(je=je<Ur?0:Rt),rr(null,!0,!0),Rs=!1}$e=-10,je=-10,et.fill(null),rr(null,!0,!0),ft&&(Rs=ft)}function Cp(x,M,I,F,X,J,at){ut._lock||(jt(x),Xo(),ku(),x!=null&&Zo(N0,i,$e,je,k,Rt,null))}function Rp(){R.forEach(lE),O(i.width,i.height,!0)}Tr(iu,Po,Rp);let Br={};Br.mousedown=Tp,Br.mousemove=bp,Br.mouseup=Ep,Br.dblclick=Cp,Br.setSeries=(x,M,I,F)=>{let X=gi.match[2];I=X(i,M,I),I!=-1&&Yn(I,F,!0,!1)},mt&&(be(I0,_,Tp),be(If,_,bp),be(L0,_,x=>{jt(x),Yo(!1)}),be(D0,_,bx),be(N0,_,Cp),Xf.add(i),i.syncRect=Yo);let rl=i.hooks=n.hooks||{};function Pi(x,M,I){Xi?Ue.push([x,M,I]):x in rl&&rl[x].forEach(F=>{F.call(null,i,M,I)})}(n.plugins||[]).forEach(x=>{for(let M in x.hooks)rl[M]=(rl[M]||[]).concat(x.hooks[M])});let Pp=(x,M,I)=>I,gi=yi({key:null,setSeries:!1,filters:{pub:X0,sub:X0},scales:[E,v[1]?v[1].scale:null],match:[$0,$0,Pp],values:[null,null]},ut.sync);gi.match.length==2&&gi.match.push(Pp),ut.sync=gi;let Ip=gi.key,Bu=V_(Ip);function Zo(x,M,I,F,X,J,at){gi.filters.pub(x,M,I,F,X,J,at)&&Bu.pub(x,M,I,F,X,J,at)}Bu.sub(i);function wx(x,M,I,F,X,J,at){gi.filters.sub(x,M,I,F,X,J,at)&&Br[x](null,M,I,F,X,J,at)}i.pub=wx;function Sx(){Bu.unsub(i),Xf.delete(i),Ei.clear(),zf(iu,Po,Rp),h.remove(),Et?.remove(),Pi("destroy")}i.destroy=Sx;function zu(){Pi("init",n,t),Wo(t||n.data,!1),W[E]?Lu(E,W[E]):Xo(),st=qe.show&&(qe.width>0||qe.height>0),it=pt=!0,O(n.width,n.height)}return v.forEach(Rr),R.forEach(os),e?e instanceof HTMLElement?(e.appendChild(h),zu()):e(i,zu):zu(),i}ki.assign=yi;ki.fmtNum=jf;ki.rangeNum=nu;ki.rangeLog=ou;ki.rangeAsinh=Kf;ki.orient=Cr;ki.pxRatio=Pe;ki.join=QA;ki.fmtDate=tp,ki.tzDate=cT;ki.sync=V_;{ki.addGap=$T,ki.clipGaps=hu;let n=ki.paths={points:Y_};n.linear=K_,n.stepped=ZT,n.bars=KT,n.spline=jT}var tx=200,Bo=["#2f7fd0","#e8871e","#1f8a70","#b0408f","#8a6d3b","#5b6ee1","#6b7785"],ap=n=>getComputedStyle(document.documentElement).getPropertyValue(n).trim(),ko=class{constructor({label:t,series:e,x:i,log:s=!1,height:r=170,unit:o=""}){this.element=document.createElement("div"),this.element.className="plot",this.element.setAttribute("role","img"),this.element.setAttribute("aria-label",t),this.options={series:e,x:i,log:s,height:r,unit:o},this.data=[[],...e.map(()=>[])],this.observer=new ResizeObserver(()=>this.fit()),this.observer.observe(this.element),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>this.rebuild())}axis(t){let{log:e}=this.options,i=(s,r)=>r.map(o=>e&&t.values&&!hE(o)?null:o);return{stroke:ap("--text-2"),grid:{stroke:ap("--line"),width:1,filter:i},ticks:{stroke:ap("--line"),width:1,size:4,filter:i},font:"11px system-ui, sans-serif",...t}}build(){let{series:t,x:e,log:i,height:s,unit:r}=this.options;this.plot=new ki({width:this.element.clientWidth,height:s,padding:[8,8,0,0],legend:{show:!1},cursor:{drag:{x:!1,y:!1}},scales:{x:{time:!1},y:i?{distr:3,range:cE}:{distr:1}},axes:[this.axis({size:34,label:e,labelSize:14,labelFont:"11px system-ui",gap:2,labelGap:0}),this.axis({size:46,values:(o,a)=>a.map(l=>uE(l,r))})],series:[{},...t.map(({label:o,colour:a,dash:l,width:h})=>({label:o,stroke:a,dash:l,width:h??1.5,points:{show:!1}}))]},this.data,this.element)}set(t){if(this.data=t,this.timer)return;let e=Math.max(0,tx-(performance.now()-(this.drawn??-tx)));this.timer=setTimeout(()=>this.draw(),e)}draw(){this.timer=0,this.drawn=performance.now(),this.element.clientWidth&&(this.plot?this.plot.setData(this.data):this.build())}fit(){this.element.clientWidth&&(this.plot?this.plot.setSize({width:this.element.clientWidth,height:this.options.height}):this.data[0].length&&this.draw())}rebuild(t=this.options.series){this.options.series=t,this.plot&&(this.plot.destroy(),this.plot=null,this.fit())}},hE=n=>Math.abs(Math.log10(n)%1)<1e-6;function cE(n,t,e){if(!(e>0))return[.1,1];let i=Math.max(t,e*1e-4);return[10**Math.floor(Math.log10(i)),10**Math.ceil(Math.log10(e))]}function uE(n,t){if(n===null)return"";let e=Math.abs(n),i=e>=1e4||e>0&&e<.001?n.toExponential(0):String(+n.toPrecision(3));return t?`${i} ${t}`:i}function ex([,,,n,t,e,i]){return Math.atan2(2*(n*i+t*e),1-2*(e*e+i*i))}var fu=class{constructor(){this.samples=[]}add(t,e,{period:i,root:s}){let r=this.samples.at(-1);r&&t<r.time&&(this.samples=[]);let o=e.slice(7*s,7*s+7),a=o.subarray(0,3),l=this.samples.at(-1)?.yaw??ex(o),h=ex(o)-l,c=l+Math.atan2(Math.sin(h),Math.cos(h));for(this.samples.push({time:t,at:a,yaw:c});this.samples.length>2&&this.samples[1].time<=t-i;)this.samples.shift()}words({period:t,advance:[e,i,s]}){let[r,o]=[this.samples[0],this.samples.at(-1)],a=(o?.time??0)-(r?.time??0);if(!(a>.9*t))return"";let l=Math.hypot(e,i)/t,h=s/t;return l<.01&&Math.abs(h)>=.01?`turns ${((o.yaw-r.yaw)/a).toFixed(2)} rad/s, planned ${h.toFixed(2)}`:`${(Math.hypot(...o.at.map((u,d)=>u-r.at[d]))/a).toFixed(3)} m/s, planned ${l.toFixed(3)}`}};var dE=3,fE=60,lp=[{key:"stiffness",label:"stiffness",unit:"×",min:.25,max:4,step:.05,value:1},{key:"damping",label:"damping",unit:"×",min:.25,max:4,step:.05,value:1},{key:"friction",label:"friction",unit:"",min:.1,max:1.5,step:.05,value:.8},{key:"slope",label:"slope",unit:"rad",min:-.3,max:.3,step:.01,value:0}],pu=class{constructor(t){this.studio=t,this.values=Object.fromEntries(lp.map(({key:e,value:i})=>[e,i])),this.taken={},this.walked=new fu,this.addButtons(),this.addCurves(),this.status=g("p.status",{role:"status"}),this.element=g("section.panel",{aria:{label:"Physics"}},g("h2",{},"Physics"),g("div.button-row",{},this.run,this.goOn,this.reset,this.pushing,this.nudge),this.pushHint,this.status,g("div.sliders",{},lp.map(e=>this.slider(e))),g("p.hint",{},"For playing here alone: Judge takes what the task says."),this.forces),this.show(!1),t.view.onRecording=()=>this.hold(),t.view.onSpeed=()=>this.running&&!this.held&&this.send({}),t.store.on("forgotten",()=>this.forget()),t.store.on("design",()=>this.held&&this.toggle(!1)),t.store.on("physics",e=>this.update(e)),t.store.on("document",e=>this.takeTask(e))}addButtons(){this.run=g("button.primary",{type:"button",onClick:()=>this.toggle()}),this.reset=g("button",{type:"button",onClick:()=>this.startAgain()},Fi("reset"),"Start again"),this.goOn=g("button",{type:"button",hidden:!0,title:"The physics go on from where they were held",onClick:()=>this.resume()},Fi("step"),"Go on"),this.pushing=g("button",{type:"button",title:"Drag on the robot pushes it (or hold shift)",aria:{pressed:"false"},onClick:()=>this.togglePush()},"Push"),this.pushHint=g("p.hint",{hidden:!0}),this.nudge=g("button",{type:"button",title:"A short push from the side",onClick:()=>this.shortPush()},"Nudge")}addCurves(){this.plot=new ko({label:"Vertical forces on the feet, planned and measured",series:[],x:"s",unit:"N",height:150}),this.legend=g("div.legend"),this.foot=g("select",{aria:{label:"Foot whose forces are shown"},onChange:()=>this.plotKey=null}),this.forces=g("div",{hidden:!0},g("h3",{},"Planned and measured force",this.foot),this.plot.element,this.legend)}slider({key:t,label:e,unit:i,min:s,max:r,step:o,value:a}){let l=g("output"),h=()=>Kt(l,`${c.valueAsNumber.toFixed(2)} ${i}`.trim()),c=g("input.slider",{type:"range",min:s,max:r,step:o,aria:{label:`${e} in physics`},onInput:()=>{h(),this.values[t]=c.valueAsNumber,this.send({})}});return c.valueAsNumber=a,this.inputs={...this.inputs,[t]:{input:c,tell:h}},h(),g("label.slider-row",{},g("span",{},e),c,l)}takeTask({tasks:t}){let e=t?.[this.studio.store.get("task")??0];if(!(!e||this.running))for(let[i,s]of[["friction",e.floor_friction],["slope",e.slope?.[0]]])!Number.isFinite(s)||s===this.taken[i]||(this.taken[i]=this.values[i]=s,this.inputs[i].input.valueAsNumber=s,this.inputs[i].tell())}body(t){let{stiffness:e,damping:i,friction:s,slope:r}=this.values,o=this.studio.store.get("task")??0,a=!!this.again;return this.again=!1,{run:this.running&&!this.held,task:o,gains:[e,i],friction:s,slope:r,speed:this.studio.view.speed,reset:a,push:this.push??null,...t}}send(t){this.studio.latestBeside("physics",()=>ii("/api/physics",this.body(t)))}startAgain(){this.again=!0,this.release(),this.send({})}resume(){this.release(),this.send({})}forget(){this.release(),this.push=this.until=this.plotKey=this.names=null,this.starting=this.again=!1,this.times=[],this.taken={},this.forces.hidden=!0;for(let{key:e,value:i}of lp)this.values[e]=this.inputs[e].input.valueAsNumber=i,this.inputs[e].tell();let{view:t}=this.studio;this.running&&t.setPlaying(this.wasPlaying??!0),this.show(!1),t.recording.clear(),t.leaveRecording()}release(){this.held=!1,this.goOn.hidden=!0,this.studio.view.recording.shown=!1,this.studio.view.pointAt([])}toggle(t=!this.running){this.release(),this.studio.view.recording.clear(),this.starting=t,t||(this.until=void 0),this.show(t),this.times=[],this.send({run:t});let{view:e}=this.studio;t?this.wasPlaying=e.playing:(e.leaveRecording(),e.setPlaying(this.wasPlaying??e.playing))}show(t){this.running=t,Gt(this.run,Fi(t?"stop":"play"),t?"Back to the plan":"Play in MuJoCo");for(let e of[this.reset,this.pushing,this.nudge])e.disabled=!t;this.pushHint.hidden=!t,t||(Kt(this.status,"The plan is shown."),this.status.classList.remove("bad"),this.togglePush(!1))}togglePush(t=!this.studio.pointer?.pushing){this.studio.pointer&&(this.studio.pointer.pushing=t),this.pushing.setAttribute("aria-pressed",String(t)),Kt(this.pushHint,t?"Drag on the robot: it is pushed that way, the harder the farther. Push again to turn the camera.":"Shift and drag on the robot pushes it; Push does so without shift.")}setPush(t){if(!this.running)return;let e=this.studio.store.get("document").mass??1;this.push=t&&{body:t.body,point:t.at,force:t.along.toArray().map(i=>i*fE*e)},this.send({})}shortPush(){let t=this.studio.store.get("document").mass??1;this.push={body:this.studio.view.player?.root??1,point:[0,0,0],force:[0,4*t,0]},this.send({}),setTimeout(()=>{this.push=null,this.send({})},200)}update(t){if(!t?.poses||!t.running){if(this.held)return;this.running&&t?.running===!1&&!this.starting&&this.toggle(!1);return}if(this.starting=!1,this.held||!this.running&&!this.goesOn())return;this.running||this.show(!0);let{poses:e,feet:i,phase:s,time:r,speed:o,fell:a,up:l}=t,h={time:r,poses:An(e),feet:i??[],phase:s,up:l,fell:a};this.studio.view.recording.add(h),this.studio.view.setLive(h);let c=Number.isFinite(o)?`${o.toFixed(2)} × real time`:"",u=a?`fell after ${a.time.toFixed(2)} s: ${a.words}`:"",d=this.studio.view.player;d&&this.walked.add(r,h.poses,d);let f=d&&!a?this.walked.words(d):"";Kt(this.status,[`${r.toFixed(2)} s`,c,f,u].filter(Boolean).join(" · ")),this.status.classList.toggle("bad",!!a),this.curves(t),this.rewound||=r<this.until,this.rewound&&r>=this.until&&this.hold()}goesOn(){let t=performance.now(),e=t-(this.frameAt??-1/0)<500;return this.frameAt=t,e}playUntil(t,e=""){let i=/half/.test(e)?.5:/double/.test(e)?2:1;for(let s of["stiffness","damping"])this.values[s]=this.inputs[s].input.valueAsNumber=i,this.inputs[s].tell();if(this.until=t,this.rewound=!1,this.again=!0,!this.running)return this.toggle(!0);this.release(),this.send({})}hold(){this.held||(this.until=void 0,this.held=!0,this.goOn.hidden=!1,Kt(this.status,`Held at ${this.studio.view.recording.end.toFixed(2)} s of the run.`),this.send({run:!1}))}curves({time:t,feet:e}){if(this.forces.hidden=!e?.length,!e?.length)return;let i=e.map(o=>o.name).join();for(i!==this.names&&(this.names=i,Gt(this.foot,e.map((o,a)=>g("option",{value:a},o.name)))),(!this.times||t<(this.times.at(-1)?.time??0))&&(this.times=[]),this.times.push({time:t,feet:e});this.times[0].time<t-dE;)this.times.shift();let s=Number(this.foot.value)||0;if(this.plotKey!==`${i} ${s}`){this.plotKey=`${i} ${s}`;let o=[{label:"planned",colour:Bo[2],dash:[5,4]},{label:"measured",colour:Bo[1],width:2}];this.plot.rebuild(o),Gt(this.legend,o.map(({label:a,colour:l})=>g("span",{},g("i",{style:{background:l}}),a)))}let r=o=>Array.isArray(o)?o[2]:o??null;this.plot.set([this.times.map(o=>o.time),this.times.map(o=>r(o.feet[s]?.planned)),this.times.map(o=>r(o.feet[s]?.force))])}};var pE=5,mu=class{constructor(t){this.studio=t,this.main=g("button.primary",{type:"button",onClick:()=>this.toggle()}),this.step=g("button",{type:"button",title:"One design iteration",onClick:()=>t.command("step")},Fi("step"),"Step"),this.stop=g("button",{type:"button",title:"End the search, or what goes on in the background; the design stays as it is",onClick:()=>t.stopAll()},Fi("stop"),"Stop"),this.element=g("div.search-buttons",{role:"group",aria:{label:"Search"}},this.main,this.step,this.stop),t.store.on(["state","paused","job","judge"],()=>this.update())}toggle(){this.searching?this.studio.pauseSearch():this.studio.startSearch()}update(){let t=this.studio.store.get("state"),e=this.studio.store.get("paused");this.searching=t?.phase==="searching";let i=this.searching?"Pause":e?"Continue":"Optimise";i!==this.label&&(this.label=i,Gt(this.main,Fi(this.searching?"pause":"play"),i)),this.step.disabled=this.searching,this.stop.disabled=!Object.values(this.studio.atWork()).some(Boolean)}},gu=class{constructor(t){this.studio=t,this.status=g("p.status",{role:"status"}),this.plot=new ko({label:"Cost F and its largest terms over the iterations",series:[],x:"iteration",log:!0}),this.legend=g("div.legend"),this.changed=g("table.differences"),this.changedTitle=g("h3",{hidden:!0},"The last iteration changed"),this.element=g("section.panel",{aria:{label:"Search"}},g("h2",{},"Search"),this.status,this.plot.element,this.legend,this.changedTitle,this.changed),this.points=[],t.store.on("state",e=>this.update(e)),t.store.on("point",e=>this.add(e)),t.store.on("searchCleared",()=>this.clear())}clear(){this.points=[],Gt(this.changed)}update(t){let e=Number.isFinite(t.seconds_left)?`, about ${pl(t.seconds_left)} left`:"",i={searching:`Searching: iteration ${t.iterations}${e}`,solving:"Solving for the motion","working out":"Working out other designs",idle:t.settled?"At rest":"The motion is predicted, not solved"}[t.phase];Kt(this.status,`${i} · cost F ${We(t.F)}`)}add(t){this.points.push(t),this.points.length>4e3&&this.points.splice(0,1e3),!this.timer&&(this.timer=setTimeout(()=>{this.timer=0,this.draw()},200))}draw(){let t=this.points.at(-1);if(!t)return;let e=[...t.terms??[]].sort((a,l)=>l.value-a.value).slice(0,pE),i=e.map(a=>a.name),s=[{label:"cost F",colour:Bo[0],width:2.25},...e.map((a,l)=>({label:a.words??a.name,colour:Bo[l+1],width:1.25}))],r=i.join();r!==this.key&&(this.key=r,this.plot.rebuild(s),Gt(this.legend,s.map(({label:a,colour:l})=>g("span",{},g("i",{style:{background:l}}),a))));let o=a=>a>1e-12?a:null;this.plot.set([this.points.map((a,l)=>l+1),this.points.map(a=>o(a.F)),...i.map(a=>this.points.map(l=>o(l.terms?.find(h=>h.name===a)?.value)))]),this.showChanges(t)}showChanges(t){let{parameters:e}=this.studio.store.get("document")??{parameters:[]},i=new Map(e.map(o=>[o.name,o])),s=({name:o,from:a,to:l})=>Math.abs(l-a)/(i.get(o)?.scale||1),r=[...t.changed??[]].sort((o,a)=>s(a)-s(o)).slice(0,6);this.changedTitle.hidden=!r.length,Gt(this.changed,g("tbody",{},r.map(({name:o,from:a,to:l})=>{let h=i.get(o)?.unit??"";return g("tr",{},g("th",{scope:"row"},Oe(o)),g("td",{},Ui(a,h)),g("td",{},"→ ",Ui(l,h)))})))}};var mE=[["Open","drop a robot's files on the first page (File, Open another…), or take an example"],["Ask","Simulate, at the left: Walk, Sideways, Faster, a speed, a payload, a slope"],["Optimise","at the top; a lock in the list (Design, at the left) keeps a length or an angle"],["Judge","Simulate, at the right: MuJoCo plays the gait. FAIL? Find one that passes…"],["Export…","under File, at the top left: the robot and its gait, for MuJoCo as it comes"]],gE=[["space","play or pause the motion"],[", .","one frame back, on"],["ctrl z, ctrl shift z","undo, redo"],["[ ]","the parameter before, after"],["+ −","change the selected parameter; with shift ten steps"],["L","lock or unlock the selected parameter"],["P","put the selected parameter back to its given value"],["F","work out with how few changes the body would do"],["escape","select nothing"],["O","optimise, pause, continue"],["arrows on the picture","turn the camera; with shift zoom"],["1 2 3 4","camera: corner, side, front, top"],["D, S","workspace: design, simulate"],["ctrl s","save"],["?","this page"]],_E=[["a dot on the robot","drag it: the limb grows, the axis turns, the trunk widens"],["a limb","tap it: its parameters are selected, axes get their rings"],["one finger","turns the camera"],["two fingers","move and zoom"],["a slider","sideways moves it; up and down scrolls"],["rest on a button or a figure","says what it is"]],xE=()=>g("ol.way",{},mE.map(([n,t])=>g("li",{},g("strong",{},n),` – ${t}`))),ix=n=>g("table.keys",{},g("tbody",{},n.map(([t,e])=>g("tr",{},g("th",{scope:"row"},g("kbd",{},t)),g("td",{},e)))));function hp(){let n=g("button.primary",{type:"button",onClick:()=>e.close()},"Close"),t=matchMedia("(pointer: coarse)").matches,e=Jo("How to",g("div.help",{},xE(),t?[g("h3",{},"Fingers"),ix(_E)]:[],g("h3",{},"Keys"),ix(gE)),g("div.actions",{},n))}var nx=n=>n.matches?.("input:not([type=range]), textarea, select, dialog *")??!1,yE={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function vE({stage:n},t){let e=yE[t.key];return!e||t.target!==n.canvas?!1:(t.shiftKey?n.zoom(e[0]+e[1]>0?.9:1.11):n.orbit(e[0]*.12,e[1]*.08),!0)}function bE(n){let t=n.selection.first,e=n.store.get("document").parameters.find(i=>i.name===t);e&&(n.readParameter(t).locked?n.notices.show("info",`${t.replaceAll("_"," ")} is locked.`):n.edit(t,e.given,"once"))}function wE(n){let{view:t,selection:e}=n,i=r=>{let o=n.store.get("document").parameters.map(l=>l.name),a=o.indexOf(e.first);e.set([o[(a+r+o.length)%o.length]])},s=(r,o)=>e.first&&n.list.nudge(e.first,r*(o.shiftKey?10:1));return{" ":r=>r.target.tagName!=="BUTTON"&&r.target.tagName!=="SUMMARY"&&(n.timeline.toggle(),!0),",":()=>n.timeline.stepFrame(-1),".":()=>n.timeline.stepFrame(1),"[":()=>i(-1),"]":()=>i(1),"+":r=>s(1,r),"=":r=>s(1,r),"-":r=>s(-1,r),l:()=>e.first&&n.lock(e.first,!n.readParameter(e.first).locked),p:()=>bE(n),f:()=>n.changes.findFewest(),o:()=>n.searchButtons.toggle(),1:()=>t.stage.view("corner"),2:()=>t.stage.view("side"),3:()=>t.stage.view("front"),4:()=>t.stage.view("top"),d:()=>n.showWorkspace("design"),s:()=>n.showWorkspace("simulate"),"?":()=>hp(),Escape:()=>e.set([])}}function sx(n){let t=wE(n);addEventListener("keydown",e=>{if(e.defaultPrevented||e.altKey||document.body.dataset.page!=="workspace")return;if(e.ctrlKey||e.metaKey){let s={z:()=>n.command(e.shiftKey?"redo":"undo"),y:()=>n.command("redo"),s:()=>n.save()}[e.key.toLowerCase()];if(!s||nx(e.target)&&e.key!=="s")return;e.preventDefault(),s();return}if(nx(e.target)||!n.store.get("document"))return;if(vE(n.view,e))return e.preventDefault();let i=t[e.key]??t[e.key.toLowerCase()];i&&i(e)!==!1&&e.preventDefault()})}var SE=1e-7;function _u(n,t,e,i){return g("tr",{},g("th",{scope:"row",title:n},n),g("td",{},t),g("td",{},e),g("td",{},i))}var xu=(n,t)=>n.toFixed(ar(t)),rx=(n,t,e)=>Wu(t-n,e).replace(` ${e}`,"");function ME({name:n,unit:t,a:e,b:i}){return _u(`${Oe(n)} [${t}]`,xu(e,t),xu(i,t),rx(e,i,t))}function ox(n,{rows:t,tasks:e=[],F:i,mass:s,verdict:r}){let o=t.filter(({a:c,b:u})=>Math.abs(c-u)>SE),a=["",n,"now","change"].map(c=>g("th",{scope:"col"},c)),l=[{name:"",...i},...e.length>1?e:[]];return[g("table.differences.compared",{},g("caption",{},`Differences from ${n}`),g("thead",{},g("tr",{},a)),g("tbody",{},l.map(c=>_u(c.name?`cost F, ${c.name}`:"cost F",We(c.a),We(c.b),c.a===null?"–":Wu(c.b-c.a))),_u("mass [kg]",xu(s.a,"kg"),xu(s.b,"kg"),rx(s.a,s.b,"kg")),_u("verdict",r.a??"not judged",r.b??"not judged",""),o.map(ME))),o.length?null:g("p.empty",{},"The bodies are the same.")]}var yu=class{constructor(t){this.studio=t,this.list=g("ul.snapshots"),this.comparison=g("div.comparison",{aria:{live:"polite"}}),this.beside=!1,this.places=[this.placeButton("Within",!1,"The other design as a ghost in this one"),this.placeButton("Beside",!0,"The two designs side by side")],this.place=g("div.segmented",{hidden:!0,aria:{label:"Other design"}},this.places),this.element=g("section.panel",{aria:{label:"Snapshots"}},g("h2",{},"Snapshots",g("button.small",{type:"button",onClick:()=>this.keep()},"Keep…")),this.list,this.place,this.comparison),t.store.on("state",e=>this.update(e)),t.store.on("judge",({running:e})=>!e&&this.compareSoon()),t.store.on("forgotten",()=>{this.ghost=void 0,this.place.hidden=!0,Gt(this.comparison)})}placeButton(t,e,i){let s={pressed:String(e===this.beside)};return g("button.small",{type:"button",title:i,aria:s,onClick:()=>this.setBeside(e)},t)}setBeside(t){this.beside=t,this.places.forEach((e,i)=>e.setAttribute("aria-pressed",String(i===1===t))),this.shown&&this.studio.view.setGhost(this.shown,{beside:t})}update(t){let e=t.names??[],i=e.join(`
`)+this.ghost;i!==this.key&&(this.key=i,Gt(this.list,e.length?e.map(s=>this.row(s)):g("li.empty",{},"None yet. Keep the design to come back to it, or to compare."))),this.ghost!==void 0&&t.settled&&this.compareSoon()}row(t){let{studio:e}=this,i=this.ghost===t;return g("li",{},g("span.name",{},t),g("button.small",{type:"button",aria:{pressed:String(i)},onClick:()=>this.toggleGhost(t)},"Compare"),g("button.small",{type:"button",onClick:()=>e.command("branch",{name:t})},"Go on from"))}async keep(){let t=this.studio.store.get("state")?.names??[],e=await Gr("Keep this design as",`design ${t.length+1}`);e&&this.studio.command("snapshot",{name:e})}async toggleGhost(t){let{studio:e}=this;if(this.ghost=this.ghost===t?void 0:t,this.update(e.store.get("state")),this.place.hidden=this.ghost===void 0,this.ghost===void 0){this.shown=null,e.view.setGhost(null),Gt(this.comparison);return}await e.act(async()=>{let i=e.store.get("task")??0,s=`snapshot=${encodeURIComponent(t)}`,[r,o]=await Promise.all([_i(`/api/design?${s}`),_i(`/api/motion?${s}&task=${i}`)]);this.ghost===t&&(this.shown={design:r,motion:o,name:t},e.view.setGhost(this.shown,{beside:this.beside}))}),await this.compare(),this.ghost===t&&this.element.scrollIntoView({block:"start"})}compareSoon(){clearTimeout(this.timer),this.timer=setTimeout(()=>this.compare(),400)}async compare(){if(this.ghost===void 0)return;let t=this.ghost,e=await this.studio.act(()=>_i(`/api/compare?a=${encodeURIComponent(t)}&b=`));!e||this.ghost!==t||Gt(this.comparison,ox(t,e))}};function vu(n){let t=n.length;if(n.every(Boolean))return[0,t];let e=[0,0];for(let i=0;i<t;i++){if(!n[i]||n[(i+t-1)%t])continue;let s=0;for(;s<t&&n[(i+s)%t];)s++;s>e[1]&&(e=[i,s])}return e}function ax(n,t,e){return Array.from({length:e},(i,s)=>(s-n+e)%e<t?1:0)}var bu=class{constructor(t){this.changed=t,this.element=g("div.footfall-grid",{role:"group",aria:{label:"Footfalls"}}),this.head=g("div.footfall-head"),this.element.addEventListener("pointerdown",e=>this.down(e)),this.element.addEventListener("pointermove",e=>this.move(e)),this.element.addEventListener("pointerup",()=>this.up()),this.element.addEventListener("pointercancel",()=>this.build(this.given)),this.element.addEventListener("keydown",e=>this.key(e))}set(t){let e=JSON.stringify(t);e===this.key_||this.painting||(this.key_=e,this.build(t))}build(t){this.given=t;let e=this.element.contains(document.activeElement)?document.activeElement.dataset.row:null;this.painting=null,this.rows=t.map(({foot:i,cells:s})=>({foot:i,cells:[...s]})),Gt(this.element,this.rows.map(({foot:i,cells:s},r)=>g("div.footfall-row",{role:"slider",tabIndex:0,data:{row:r},aria:{label:`${i} stands`,valuenow:0},title:"Arrow keys shift the stance, with shift they lengthen it"},g("span.foot",{},i),s.map((o,a)=>g(`span.cell${o?".on":""}`,{data:{row:r,cell:a}}))))),this.rows.forEach((i,s)=>this.describe(s)),e!==null&&this.element.children[e]?.focus()}describe(t){let{cells:e}=this.rows[t],[i,s]=vu(e),r=this.element.children[t],o=e.length,a=`from ${Math.round(100*i/o)} % of the cycle for ${Math.round(100*s/o)} %`;r.setAttribute("aria-valuenow",i),r.setAttribute("aria-valuetext",a)}cellAt(t){let e=document.elementFromPoint(t.clientX,t.clientY)?.closest?.(".cell");return e&&this.element.contains(e)?e:null}down(t){let e=this.cellAt(t);if(!e||t.button!==0)return;t.preventDefault(),this.element.setPointerCapture(t.pointerId);let i=Number(e.dataset.row);this.element.children[i].focus(),this.painting={r:i,to:this.rows[i].cells[e.dataset.cell]?0:1},this.paint(Number(e.dataset.cell))}move(t){if(!this.painting)return;let e=this.element.children[this.painting.r],i=e.lastChild.getBoundingClientRect(),s=e.children[1].getBoundingClientRect().left,r=this.rows[this.painting.r].cells.length,o=Math.floor((t.clientX-s)/(i.right-s)*r);o>=0&&o<r&&this.paint(o)}paint(t){let{r:e,to:i}=this.painting;this.rows[e].cells[t]=i,this.element.children[e].children[t+1].classList.toggle("on",!!i)}up(){if(!this.painting)return;let{r:t}=this.painting;this.painting=null,this.keepRun(t)}keepRun(t){let e=this.rows[t],[i,s]=vu(e.cells);if(!s)return this.build(this.given);e.cells=ax(i,s,e.cells.length),this.tell()}tell(){let t=this.rows.map(({foot:e,cells:i})=>{let[s,r]=vu(i);return{foot:e,cells:i,first:s,count:r}});this.build(this.rows),this.changed(t)}key(t){let e=t.target.closest?.(".footfall-row"),i={ArrowRight:1,ArrowLeft:-1}[t.key];if(!e)return;let s=Number(e.dataset.row);if(i){t.preventDefault(),t.stopPropagation();let{cells:r}=this.rows[s],o=r.length,[a,l]=vu(r);t.shiftKey?l=Math.min(o,Math.max(1,l+i)):a=(a+i+o)%o,this.rows[s].cells=ax(a,l,o),this.tell()}else(t.key==="ArrowDown"||t.key==="ArrowUp")&&(t.preventDefault(),this.element.children[s+(t.key==="ArrowDown"?1:-1)]?.focus())}};var xn=52,wu=class{constructor(t){this.changed=t,this.velocity=[0,0],this.scale=.5,this.knob=Ie("circle.knob",{r:8}),this.stick=Ie("line.stick",{x1:0,y1:0}),this.rim=Ie("text.rim",{x:0,y:-xn+11,"text-anchor":"middle"});let e=Ie("svg",{viewBox:"-62 -62 124 124","aria-hidden":"true"},Ie("circle.disc",{r:xn}),Ie("circle.ring",{r:xn/2}),Ie("path.cross",{d:`M0-${xn}V${xn}M-${xn} 0H${xn}`}),this.rim,this.stick,this.knob);this.element=g("div.joystick",{role:"application",tabIndex:0,aria:{label:"Velocity: arrow keys change it"},title:"Drag: forward is up. Arrow keys change the velocity."},e),this.drawing=e,this.element.addEventListener("pointerdown",i=>{i.preventDefault(),this.element.focus(),this.element.setPointerCapture(i.pointerId),this.held=!0,this.drag(i,!1)}),this.element.addEventListener("pointermove",i=>this.held&&this.drag(i,!1)),this.element.addEventListener("pointerup",i=>{this.held&&(this.held=!1,this.drag(i,!0))}),this.element.addEventListener("keydown",i=>this.key(i))}drag(t,e){let i=this.drawing.getBoundingClientRect(),s=(t.clientX-i.left)/i.width*124-62,r=(t.clientY-i.top)/i.height*124-62,o=Math.hypot(s,r);o>xn&&([s,r]=[s*xn/o,r*xn/o]),Math.abs(s)<4&&(s=0),Math.abs(r)<4&&(r=0);let a=l=>Math.round(l/xn*this.scale*200)/200+0;this.tell([a(-r),a(-s)],e)}key(t){let e=this.scale/20,i={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowLeft:[0,1],ArrowRight:[0,-1]}[t.key];if(!i)return;t.preventDefault(),t.stopPropagation();let s=r=>Math.round(r*1e3)/1e3;this.tell([s(this.velocity[0]+i[0]*e),s(this.velocity[1]+i[1]*e)],!0)}tell(t,e){this.show(t),this.changed(t,e)}setScale(t){this.scale=t,this.rim.textContent=`${t.toFixed(2)} m/s`,this.show(this.velocity)}show(t){this.velocity=t;let e=Math.max(1,Math.hypot(...t)/this.scale),[i,s]=[-t[1]/this.scale/e*xn,-t[0]/this.scale/e*xn];for(let[r,o]of[["cx",i],["cy",s]])this.knob.setAttribute(r,o.toFixed(1));for(let[r,o]of[["x2",i],["y2",s]])this.stick.setAttribute(r,o.toFixed(1))}};var cp={width:264,height:132,left:8,right:8,top:8,bottom:16};function hx(n,t){let e=i=>i.weights.reduce((s,r,o)=>s+(r-t[o])*(r-t[o]),0);return n.reduce((i,s,r)=>e(s)<e(n[i])?r:i,0)}function lx(n,t,e){let i=n.map(o=>Math.log(Math.max(o,1e-12))),[s,r]=[Math.min(...i),Math.max(...i)];return i.map(o=>t+(e-t)*(o-s)/(r-s||1))}var Su=class{constructor(t){this.choose=t,this.drawing=Ie("svg.front",{viewBox:`0 0 ${cp.width} ${cp.height}`,"aria-hidden":"true"}),this.words=g("p.told",{aria:{live:"polite"}}),this.element=g("div.front-plot",{},this.drawing,this.words)}draw(t,e){if(this.names=t,this.designs=e,this.drawing.classList.toggle("of-three",t.length!==2),t.length!==2)return Gt(this.drawing);let{width:i,height:s,left:r,right:o,top:a,bottom:l}=cp,[h,c]=[0,1].map(f=>e.map(({task_F:_})=>_[f])),u=lx(h,r,i-o),d=lx(c,s-l,a);this.points=e.map((f,_)=>Ie("circle.front-point",{cx:u[_],cy:d[_],r:4.5,onClick:()=>this.choose(_)})),Gt(this.drawing,Ie("path.front-line",{d:`M${u.map((f,_)=>`${f} ${d[_]}`).join("L")}`}),this.points,Ie("text",{x:i-o,y:s-2,"text-anchor":"end"},`cost F of ${t[0]} →`),Ie("text",{x:r,y:s-2},`↑ cost F of ${t[1]}`))}show(t){this.points?.forEach((i,s)=>i.classList.toggle("present",s===t));let e=this.designs[t];this.words.textContent=e?`Design ${t+1} of ${this.designs.length}: ${this.names.map((i,s)=>`${i} cost F ${We(e.task_F[s],3)}`).join(", ")}`:`${this.designs.length} designs are known; the one that stands is none of them.`}};var Qa=[[0,-50],[50,37],[-50,37]],up=.01;function AE(n,t){let[[e,i],[s,r],[o,a]]=Qa,l=(r-a)*(e-o)+(o-s)*(i-a),h=((r-a)*(n-o)+(o-s)*(t-a))/l,c=((a-i)*(n-o)+(e-o)*(t-a))/l;return dp([h,c,1-h-c])}function dp(n){let t=n.map(i=>Math.max(up,i)),e=t.reduce((i,s)=>i+s,0);return t.map(i=>i/e)}var Mu=class{constructor(t){this.changed=t,this.element=g("div.weights")}set(t,e){if(this.moving&&t.join(`
`)===this.key)return;this.weights=dp(e),this.names=t;let i=t.join(`
`);i!==this.key&&(this.key=i,Gt(this.element,t.length<2?null:this.build(t))),this.show()}build(t){let e=s=>g("input.slider",{type:"range",min:up,max:1-up,step:.01,aria:{label:`Weight of ${t[s]}`},onInput:r=>this.take(s,r.target.valueAsNumber),onChange:()=>this.end()});if(this.sliders=t.length===2?[e(1)]:t.map((s,r)=>e(r)),this.texts=t.map(()=>g("output")),t.length===2)return g("div.two-weights",{},g("span",{},t[0]," ",this.texts[0]),this.sliders[0],g("span",{},this.texts[1]," ",t[1]));let i=t.map((s,r)=>g("label.weight-row",{},g("span",{},s),this.sliders[r],this.texts[r]));return[t.length===3?this.triangle(t):null,i]}take(t,e){if(this.names.length===2)this.tell([1-e,e]);else{let i=this.weights.reduce((s,r,o)=>o===t?s:s+r,0)||1;this.tell(this.weights.map((s,r)=>r===t?e:s*(1-e)/i))}}triangle(t){this.knob=Ie("circle.knob",{r:6});let e=["middle","start","end"],i=Ie("svg.triangle",{viewBox:"-90 -66 180 122","aria-hidden":"true"},Ie("path.disc",{d:`M${Qa.map(r=>r.join(" ")).join("L")}Z`}),Qa.map(([r,o],a)=>Ie("text",{x:r,y:o+(a?14:-5),"text-anchor":(e[a]==="middle","middle")},t[a])),this.knob),s=r=>{let o=i.getBoundingClientRect(),a=(r.clientX-o.left)/o.width*180-90,l=(r.clientY-o.top)/o.height*122-66;this.tell(AE(a,l))};return i.addEventListener("pointerdown",r=>{i.setPointerCapture(r.pointerId),s(r)}),i.addEventListener("pointermove",r=>r.buttons&&s(r)),i.addEventListener("pointerup",()=>this.end()),i}tell(t){this.weights=dp(t),this.show();let e=this.weights.map(i=>Math.round(i*1e3)/1e3);this.changed(e,!!this.moving),this.moving=!0}end(){this.moving=!1}showDesigns(t){if(this.dots?.remove(),this.dots=null,!t.length||!this.knob||this.names?.length!==3)return;let e=(i,s)=>Qa.reduce((r,o,a)=>r+i[a]*o[s],0);this.dots=Ie("g.dots",{},t.map(({weights:i})=>Ie("circle",{cx:e(i,0),cy:e(i,1),r:2.2}))),this.knob.before(this.dots)}show(){if(this.names.length<2||(this.weights.forEach((e,i)=>this.texts[i].textContent=`${Math.round(100*e)} %`),this.names.length===2?this.sliders[0].valueAsNumber=this.weights[1]:this.sliders.forEach((e,i)=>e.valueAsNumber=this.weights[i]),!this.knob||this.names.length!==3))return;let t=[0,1].map(e=>Qa.reduce((i,s,r)=>i+this.weights[r]*s[e],0));this.knob.setAttribute("cx",t[0].toFixed(1)),this.knob.setAttribute("cy",t[1].toFixed(1))}};var TE=1e-9,Au=class{constructor(t){this.studio=t,this.weights=new Mu((e,i)=>this.weigh(e,i)),this.plot=new Su(e=>t.choose("front",e,!1)),this.find=g("button.small",{type:"button",title:"The best body for each of several weightings: takes a while, and any change ends it",onClick:()=>t.workOut("front")},"Work out the front"),this.along=g("button.small",{type:"button",title:"The weights move the body along the front, or only count for the next search",aria:{pressed:"true"},onClick:()=>this.setAlong(!this.isAlong)},"Along the front"),this.cancel=g("button.small",{type:"button",onClick:()=>t.halt()},"Cancel"),this.status=g("p.status",{role:"status"}),this.isAlong=!0,this.element=g("div.trade-off",{hidden:!0},this.weights.element,g("div.button-row",{},this.find,this.cancel,this.along),this.status,this.plot.element),t.store.on(["state","document","alternatives front"],()=>this.update())}setAlong(t){this.isAlong=t,this.along.setAttribute("aria-pressed",String(t))}weigh(t,e){let{studio:i}=this;this.front&&this.isAlong?i.choose("front",hx(this.front.designs,t),e):i.latest("weights",()=>i.commandQuietly("weights",{weights:t}))}update(){let{store:t}=this.studio,[e,i]=[t.get("state"),t.get("document")];if(!e||!i)return;let s=i.tasks.map(a=>a.name);if(this.element.hidden=s.length<2,s.length<2||e.weights.length!==s.length)return;this.weights.set(s,e.weights);let r=e.phase==="working out",o=e.alternatives?.includes("front");if(this.front=o?t.get("alternatives front"):null,this.find.hidden=r||s.length>3,this.find.textContent=this.front?"Work it out anew":"Work out the front",this.find.disabled=e.phase==="searching",this.cancel.hidden=!r,this.along.hidden=this.plot.element.hidden=!this.front,this.status.textContent=r?"Working out other designs …":"",!this.front){this.drawn&&this.weights.showDesigns([]),this.drawn=null;return}this.front!==this.drawn&&(this.drawn=this.front,this.plot.draw(s,this.front.designs),this.weights.showDesigns(this.front.designs)),this.plot.show(this.front.designs.findIndex(({s:a})=>a.every((l,h)=>Math.abs(l-e.s[h])<TE)))}};var fp=[{key:"turn",label:"turn",unit:"rad/s",step:.05,write:n=>({travel:{turn_rate:n}})},{key:"period",label:"period",unit:"s",step:.05,min:.05,max:20,write:n=>({gait:{period:n}})},{key:"payload",label:"payload",unit:"kg",step:.1,min:0,write:n=>({payload:n>0?{mass:n}:null})},{key:"slope",index:0,label:"slope up",unit:"rad",step:.01,write:n=>({ground:{slope_along:n}})},{key:"slope",index:1,label:"slope left",unit:"rad",step:.01,write:n=>({ground:{slope_across:n}})},{key:"step",label:"step over",unit:"m",step:.005,min:0,write:n=>({limits:{step_over:n>0?n:null}})},{key:"com_height",label:"COM height",unit:"m",step:.005,min:.001,expert:!0,write:n=>({style:{com_height:n}})},{key:"swing_height",label:"swing height",unit:"m",step:.005,min:0,expert:!0,write:n=>({limits:{swing_height:n}})},{key:"friction",label:"friction planned",unit:"",step:.05,min:.01,expert:!0,write:n=>({limits:{friction:n}})},{key:"floor_friction",label:"friction of floor",unit:"",step:.05,min:.01,expert:!0,write:n=>({limits:{floor_friction:n}})},{key:"min_normal",label:"least foot force",unit:"",step:.01,min:0,max:.5,expert:!0,write:n=>({limits:{min_normal:n}})},{key:"torque_margin",label:"torque in hand",unit:"",step:.05,min:0,expert:!0,write:n=>({limits:{torque_margin:n}})},{key:"stance_width",label:"stance width",unit:"×",step:.05,min:.2,max:5,expert:!0,write:n=>({style:{stance_width:n}})},{key:"aim_speed",label:"planned speed",unit:"×",step:.01,min:.5,max:2,expert:!0,write:n=>({travel:{aim_speed:n}})},{key:"aim_turn_rate",label:"turn added",unit:"rad/s",step:.01,expert:!0,write:n=>({travel:{aim_turn_rate:n}})}],Tu=class{constructor(t){this.studio=t,this.index=0,this.tabs=g("div.tabs",{role:"tablist",aria:{label:"Tasks"}}),this.tradeOff=new Au(t),this.gait=g("select.wide",{aria:{label:"Gait"},onChange:()=>this.chooseGait()}),this.about=g("p.hint"),this.footfalls=new bu(e=>this.setFootfalls(e)),this.joystick=new wu((e,i)=>this.setVelocity(e,i)),this.aim=g("p.hint",{hidden:!0}),this.forward=this.numberInput("forward [m/s]",.01,()=>this.typedVelocity()),this.left=this.numberInput("left [m/s]",.01,()=>this.typedVelocity()),this.fields=fp.map(e=>this.field(e)),this.terms=g("div.term-weights"),this.element=g("section.panel.task",{aria:{label:"Task"}},this.layout()),t.store.on("document",e=>this.update(e)),t.store.on("task",e=>this.select(e)),t.store.on("taskRefused",()=>this.restore())}layout(){let t=e=>this.fields.filter((i,s)=>!!fp[s].expert===e);return[g("h2",{},"Task"),this.tabs,this.tradeOff.element,g("div.behaviours",{role:"group",aria:{label:"Behaviours"}},this.behaviours()),g("h3",{},"Velocity"),g("div.velocity",{},this.joystick.element,g("div.fields",{},g("label.field",{},"forward",this.forward,g("span.unit",{},"m/s")),g("label.field",{},"left",this.left,g("span.unit",{},"m/s")),this.fields[0])),this.aim,g("h3",{},"Gait"),this.gait,this.about,this.footfalls.element,g("div.fields.two",{},t(!1).slice(1)),g("details.expert",{},g("summary",{},"Style, limits, weights"),g("div.fields.two",{},t(!0)),g("h3",{},"Weights of the terms of the cost F"),this.terms)]}numberInput(t,e,i){return g("input.number",{type:"number",step:e,aria:{label:t},onChange:i})}field({label:t,unit:e,step:i,min:s,max:r,write:o}){let a=this.numberInput(e?`${t} [${e}]`:t,i,()=>{let l=a.valueAsNumber;Number.isFinite(l)&&this.change(o(l))});return s!==void 0&&(a.min=s),r!==void 0&&(a.max=r),g("label.field",{},t,a,g("span.unit",{},e))}behaviours(){let t=()=>Math.hypot(...this.task.velocity)||this.joystick.scale*.3,e=(r,o)=>g("button.small",{type:"button",onClick:o},r),i=(r,o=0)=>this.change({travel:{velocity:r,turn_rate:o}}),s=r=>i(this.task.velocity.map(o=>tl(o*r)),tl(this.task.turn*r));return[e("Walk",()=>i([tl(t()),0])),e("Backwards",()=>i([-tl(t()),0])),e("Sideways",()=>i([0,tl(t())])),e("Turn on the spot",()=>i([0,0],.4)),e("Faster",()=>s(1.25)),e("Slower",()=>s(.8)),e("Carry",()=>{let r=this.studio.store.get("document").mass??1;this.change({payload:{mass:Math.max(.05,Math.round(r*4)/20)}})})]}get task(){return this.studio.store.get("document").tasks[this.index]}select(t){this.index=t;let e=this.studio.store.get("document");e&&this.update(e)}update({tasks:t,gaits:e,terms:i,leg_length:s}){if(!t?.length)return;this.index=Math.min(this.index,t.length-1);let{task:r}=this;Gt(this.tabs,t.length<2?null:t.map((a,l)=>g("button",{type:"button",role:"tab",aria:{selected:String(l===this.index)},onClick:()=>this.studio.showTask(l)},a.name)));let o=Math.sqrt(9.81*(s??.3));this.joystick.setScale(EE(Math.max(.3*o,1.3*Math.hypot(...r.velocity)))),this.joystick.held||this.joystick.show(r.velocity),this.showGaits(e??[],r),this.footfalls.set(r.footfalls),el(this.forward,r.velocity[0]),el(this.left,r.velocity[1]),this.showAim(r),fp.forEach(({key:a,index:l},h)=>{let c=l===void 0?r[a]:r[a]?.[l];el(this.fields[h].querySelector("input"),c??(a==="payload"||a==="step"?0:null))}),this.showTerms(i??[],r)}showAim({aim_speed:t=1,aim_turn_rate:e=0}){this.aim.hidden=t===1&&e===0;let i=e>0?"left":"right",r=[t===1?"":`${We(t,3)} times as fast as wanted`,e?`turning by ${We(Math.abs(e),2)} rad/s more to the ${i}`:""].filter(Boolean).join(", ");Kt(this.aim,`Planned ${r}, to make up for what MuJoCo does otherwise.`)}showGaits(t,e){let i=e.gait_kind==="own",s=t.map(a=>a.name),r=s.join()+i+e.gait;r!==this.gaitKey&&(this.gaitKey=r,Gt(this.gait,i?g("option",{value:"",selected:!0},`${e.gait} (own footfalls)`):null,s.map(a=>g("option",{value:a,selected:!i&&a===e.gait},Oe(a)))));let o=t.find(a=>a.name===e.gait)?.words??"";Kt(this.about,i?"Footfalls of your own: click or drag cells.":o)}showTerms(t,e){let i=JSON.stringify(e.term_weights)+t.length;i!==this.termKey&&(this.termKey=i,Gt(this.terms,t.map(({name:s,words:r,weight:o})=>{let a=this.numberInput(`Weight of ${Oe(s)}`,"any",()=>{a.valueAsNumber>=0&&this.change({weights:{[s]:a.valueAsNumber}})});return a.value=e.term_weights?.[s]??o,g("label.field",{title:r},Oe(s),a)})))}change(t){let{velocity:e,turn_rate:i}=t.travel??{},s=e?.some((h,c)=>h!==this.task.velocity[c]),r=i!==void 0&&i!==this.task.turn,a=s||r||t.gait||"ground"in t||"payload"in t?{aim_speed:null,aim_turn_rate:null}:{},l={...t.travel,...a};this.studio.setTask(this.index,Object.keys(l).length?{...t,travel:l}:t)}chooseGait(){this.gait.value&&this.change({gait:{name:this.gait.value,touchdown:null,duty:null}})}setFootfalls(t){let e=t[0].cells.length,i=o=>Object.fromEntries(t.map(a=>[a.foot,o(a)])),s=o=>Math.round(o/e*1e6)/1e6,r=this.task.gait_kind==="own"?this.task.gait:`my_${this.task.gait}`;this.change({gait:{name:r,touchdown:i(({first:o})=>s(o)),duty:i(({count:o})=>s(o))}})}restore(){let t=this.element.contains(document.activeElement)?document.activeElement:null;t?.blur(),this.select(this.index),t?.focus()}typedVelocity(){let t=[this.forward.valueAsNumber,this.left.valueAsNumber];t.every(Number.isFinite)&&this.change({travel:{velocity:t}})}setVelocity(t,e){el(this.forward,t[0]),el(this.left,t[1]),e&&this.change({travel:{velocity:t}})}},tl=n=>Math.round(n*1e3)/1e3;function EE(n){let t=10**Math.floor(Math.log10(n));return[1,2,5,10].map(e=>e*t).find(e=>e>=n*.999)}function el(n,t){if(document.activeElement===n)return;let e=t==null?"":String(+Number(t).toFixed(4));n.value!==e&&(n.value=e)}var Eu=class{constructor(t){this.words=g("span");let e=g("button.link",{type:"button",onClick:()=>t.showWorkspace("simulate")},"Change…");this.element=g("section.panel.task-summary",{aria:{label:"What it is to do"}},g("h2",{},"Task"),this.words,e),t.store.on("document",i=>this.update(i))}update({tasks:t=[]}){Gt(this.words,t.map(e=>g("span",{},e.words)))}};var cx=[1,2,5,10,20,50,100,200],Cu=class{constructor(t,e){let{frames:i,begin:s,seconds:r,at:o}=t;this.length=r>0?e/r:1,this.count=1/this.length,this.many=this.count>12;let a=i.at(-1),l=a.time-(a.phase??0)*e-s;this.first=(l%e+e)%e/(r||1),this.number=Math.round((s+this.first*r)/e),this.present=Math.floor(((o-s)/(r||1)-this.first)/this.length)}ticks(){let t=cx.find(i=>this.count/i<=8)??cx.at(-1),e=[];for(let i=0,s=this.first;s<1;s=this.first+ ++i*this.length)(this.number+i)%t===0&&this.number+i>0&&e.push({at:s,number:this.number+i});return e}joined(t){let e=[];for(let[i,s]of t)e.length&&i-e.at(-1)[1]<this.length?e.at(-1)[1]=s:e.push([i,s]);return e}shown(t){if(!this.many)return t;let e=this.first+this.present*this.length;return t.map(([i,s])=>[Math.max(i,e),Math.min(s,e+this.length)]).filter(([i,s])=>s>i)}};var Wn=9,zo=4,CE=48,RE=11,PE=12,IE=.02,LE=[1,.5,.25,.1],Ru=class{constructor(t){this.view=t,this.play=g("button.icon-button.play",{type:"button",onClick:()=>this.toggle()}),this.speed=g("select",{aria:{label:"Speed"},title:"Speed",onChange:()=>t.setSpeed(Number(this.speed.value))},LE.map(e=>g("option",{value:e},e===1?"1 ×":`${e} ×`))),this.clock=g("output.clock"),this.drawing=Ie("svg.footfalls",{preserveAspectRatio:"none","aria-hidden":"true"}),this.head=g("div.playhead"),this.slider=g("input.scrub",{type:"range",min:0,max:1,step:"any",aria:{label:"Phase of the cycle"},onInput:()=>this.scrub(),onKeydown:e=>this.key(e)}),this.labels=g("div.foot-names"),this.ticks=g("div.ticks",{aria:{hidden:"true"}}),this.element=g("div.timeline",{role:"group",aria:{label:"Timeline"}},this.play,this.speed,this.labels,g("div.track",{},this.drawing,this.ticks,this.head,this.slider),this.clock),this.drawRunSoon=br(250,()=>this.run&&this.drawRun()),this.drawSoon=zn(()=>t.player&&!this.run&&this.draw(t.player)),this.tell=zn((e,i,s)=>{this.slider.valueAsNumber=e,Kt(this.clock,i),this.slider.setAttribute("aria-valuetext",s)}),t.onPlaying=()=>this.showPlaying(),t.onPose=()=>this.showPhase(),this.showPlaying()}toggle(){let{view:t}=this;if(!this.run)return t.setPlaying(!t.playing);let{recording:e}=t,i=e.shown&&!t.playing;e.shown?i&&e.at>=e.end&&t.seekRecording(e.begin):t.seekRecording(e.end),t.setPlaying(i)}scrub(){let{view:t,slider:e}=this;if(t.setPlaying(!1),!this.run)return t.seekPhase(e.valueAsNumber);let{begin:i,seconds:s}=t.recording;t.seekRecording(i+e.valueAsNumber*s)}key(t){let e={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1}[t.key];e&&(t.preventDefault(),t.stopPropagation(),this.stepFrame(e))}stepFrame(t){let{view:e}=this;if(!e.player)return;if(e.setPlaying(!1),this.run)return e.seekRecording(e.recording.neighbour(t));let i=Math.round(e.phase()*e.player.frames)+t,{cycle:s}=e.player.at(e.time);e.seek((s+(i+1e-6)/e.player.frames)*e.player.period)}showPlaying(){let{view:t}=this,e=this.run&&!t.recording.shown?!0:t.playing;this.play.replaceChildren(Fi(e?"pause":"play"));let i=this.run?"the run":"the motion",s=e?`Pause ${i}`:`Play ${i}`;this.play.title=`${s} (space)`,this.play.setAttribute("aria-label",s)}showPhase(){let{view:t}=this,e=!!(t.live&&t.recording.frames.length>1);if(e!==!!this.run&&this.showRuns(e),e)return this.showRun();t.player&&t.player!==this.player&&this.drawSoon();let i=t.live?t.live.phase??0:t.phase(),s=i.toFixed(3);if(s===this.shownPhase)return;this.shownPhase=s,this.moveHead(i);let r=(t.player?.period??0).toFixed(2),o=(i*r).toFixed(2);this.tell(i,`${o} / ${r} s`,`${o} of ${r} seconds`)}showRuns(t){this.run=t,this.drawnKey=this.shownPhase=this.player=null,this.element.classList.toggle("of-a-run",t),this.slider.setAttribute("aria-label",t?"Time of the run":"Phase of the cycle"),this.showPlaying()}showRun(){let{view:t}=this,{recording:e}=t;e.shown!==this.held&&(this.held=e.shown,this.showPlaying());let i=e.seconds>0?(e.at-e.begin)/e.seconds:0;this.moveHead(i);let[s,r]=[e.at.toFixed(2),e.end.toFixed(2)];this.tell(i,`${s} / ${r} s`,`${s} of ${r} seconds of the run`),this.drawRunSoon()}moveHead(t){this.head.style.transform=`translateX(${(100*t).toFixed(2)}cqw)`}drawRun(){let{recording:t,player:e}=this.view;if(!e||!t.frames.length)return;let i=new Cu(t,e.period),s=`${t.begin} ${t.end} ${i.many?i.present:""}`;if(s===this.drawnKey)return;this.drawnKey=s;let r=t.frames[0].feet,o=Math.max(1,r.length)*Wn;this.drawing.setAttribute("viewBox",`0 0 1000 ${o+zo}`);let a=t.stances(IE*(e.weight??0)),l=f=>(_,w)=>_.map(([m,p])=>Go(f,m,p,w*Wn+1,Wn-2)),h=i.ticks(),c=[...i.many?a.map(f=>i.joined(f)).flatMap(l("walked")):[],...h.map(({at:f})=>Go("tick",f,f+.0015,0,o)),...a.map(f=>i.shown(f)).flatMap(l("stance"))];Gt(this.ticks,h.map(({at:f,number:_},w)=>g("span",{style:{left:`${100*f}%`}},w?`${_}`:`cycle ${_}`)));let{fell:u}=t.frames.at(-1),d=u?(u.time-t.begin)/t.seconds:1;d<1&&c.push(Go("fault",Math.max(0,d),1,r.length*Wn+1,zo-1)),Gt(this.drawing,c),this.nameFeet(r,!0,PE)}nameFeet(t,e,i=0){Gt(this.labels,t.map(a=>g("span",{},a.name)));let s=Math.max(1,t.length)*Wn+(e?zo:0),r=Math.max(CE,RE*t.length);this.element.style.setProperty("--track",`${r+i}px`);let o=(e?r*zo/s:0)+i;this.labels.style.paddingBottom=`${o}px`}draw(t){this.player=t,this.shownPhase=null;let{feet:e,faults:i}=t,s=JSON.stringify([e.map(({name:c,stance:u})=>[c,u]),i.map(({where:c,from:u,to:d})=>[c,u,d])]);if(s===this.drawnKey)return;this.drawnKey=s;let r=i.map(({where:c})=>e.findIndex(u=>u.name===c)),o=r.includes(-1),a=Math.max(1,e.length)*Wn+(o?zo:0);this.drawing.setAttribute("viewBox",`0 0 1000 ${a}`);let l=e.flatMap((c,u)=>NE(c.stance).map(([d,f])=>Go("stance",d,f,u*Wn+1,Wn-2))),h=i.flatMap((c,u)=>DE(c).map(([d,f])=>r[u]<0?Go("fault",d,f,e.length*Wn+1,zo-1):Go("fault",d,f,r[u]*Wn+Wn-3.5,2.5)));Gt(this.drawing,l,h),this.nameFeet(e,o)}},Go=(n,t,e,i,s)=>Ie(`rect.${n}`,{x:1e3*t,width:1e3*(e-t),y:i,height:s}),DE=({from:n,to:t})=>n<=t?[[n,t]]:[[n,1],[0,t]];function NE(n){let t=[],e=n?.length??0;for(let i=0;i<e;i++){if(!n[i])continue;let s=i;for(;i<e&&n[i];)i++;t.push([s/e,i/e])}return t}var Pu=class{constructor(t){this.studio=t,this.stage=g("div.stage"),t.view=new er(this.stage,{meshSource:t.meshSource});let{canvas:e}=t.view.stage;e.tabIndex=0,e.setAttribute("role","img"),e.setAttribute("aria-label","The robot in 3-D. Arrow keys turn the camera."),t.view.readParameter=i=>t.readParameter(i),t.timeline=new Ru(t.view),t.searchButtons=new mu(t),t.list=new Jc(t),t.changes=new Hc(t),this.physics=t.physics=new pu(t),this.below=this.panes(),this.element=g("div.workspace",{},this.topBar(),this.below),t.pointer=new So(t.view,this.pointerActs()),t.showWorkspace=i=>this.show(i),this.follow(),new qc(t),t.store.on("held",({phase:i})=>t.view.stage.setHeld(i==="begin"||i==="drag")),sx(t),Ds(i=>t.view.setTheme(i)),this.show("design")}topBar(){let{studio:t}=this;this.undo=an("undo","Undo (ctrl z)",()=>t.command("undo")),this.redo=an("redo","Redo (ctrl shift z)",()=>t.command("redo")),this.title=g("span.document-name"),this.job=new Eo,t.store.on("job",i=>this.job.show(i)),this.tabs=["design","simulate"].map(i=>g("button",{type:"button",role:"tab",aria:{selected:"false"},data:{workspace:i},onClick:()=>this.show(i)},i==="design"?"Design":"Simulate"));let e=Op("File",[{label:"Save…",hint:"ctrl s",act:()=>t.save()},{label:"Report…",act:()=>t.report()},{label:"Export…",act:()=>t.exportRobot()},{label:"Back to the given body",act:()=>t.command("reset")},{label:"Open another…",act:()=>t.showStart()}]);return this.modules=g("button",{type:"button",hidden:!0,onClick:()=>t.backToModules()},"Modules"),g("header.top-bar",{},g("span.brand",{},"Legwright"),e,this.modules,this.title,g("div.tabs",{role:"tablist",aria:{label:"Workspace"}},this.tabs),g("span.spring"),this.job.element,t.searchButtons.element,g("div.segmented",{role:"group",aria:{label:"History"}},this.undo,this.redo),an("sun","Light or dark",yl),an("help","How to, and keys (?)",hp))}panes(){let{studio:t}=this;this.panels={design:{left:[new Eu(t).element,g("section.panel",{aria:{label:"Parameters"}},g("h2",{},"Parameters"),t.list.element)],right:[new Wc(t),t.changes,new Xc(t),new yu(t)].map(i=>i.element)},simulate:{left:[new Tu(t).element],right:[new gu(t),new Yc(t),this.physics].map(i=>i.element)}},this.sides=Object.entries(this.panels).flatMap(([i,{left:s,right:r}])=>[g("aside.side.left",{data:{workspace:i},aria:{label:i==="design"?"Design":"Task"}},s),g("aside.side.right",{data:{workspace:i},aria:{label:"Results"}},r)]),this.tools=g("div.scene-tools",{},xl(t.view),Gp(t.view),this.handlesSwitch(),g("div.segmented",{},Hp(t),new _l(t).element),new $c(t).element),this.hint=g("div.scene-hint",{hidden:!0});let e=g("main.middle",{aria:{label:"Robot"}},this.stage,this.tools,this.hint,t.timeline.element);return g("div.panes",{},this.sides[0],this.sides[2],e,this.sides[1],this.sides[3])}handlesSwitch(){let{handles:t}=this.studio.view,e=g("button",{type:"button",aria:{pressed:"true"}},"Handles");return e.addEventListener("click",()=>{this.handlesOff=!this.handlesOff,e.setAttribute("aria-pressed",String(!this.handlesOff)),this.showHandles()}),t.visible=!0,this.handlesButton=g("div.segmented",{},e),this.handlesButton}showHandles(){let{view:t}=this.studio;this.handlesButton.hidden=this.name!=="design",t.handles.visible=!this.handlesOff&&this.name==="design",t.pose()}pointerActs(){let{studio:t}=this;return{hover:e=>t.selection.hover(e),drag:(e,i,s)=>{t.selection.set([e]),s==="locked"?t.notices.show("info",`${e.replaceAll("_"," ")} is locked.`):t.edit(e,i,s==="cancel"?"end":s)},pick:(e,i)=>{let s=this.namesNear(e);t.selection.set(i?[...t.selection.names,...s]:s)},push:e=>this.physics.setPush(e)}}namesNear(t){let{handles:e,design:i}=this.studio.view;for(let s=t;s>0;s=i.bodies[s].parent){let r=e.namesOn(s);if(r.length)return r}return[]}follow(){let{studio:t}=this,{store:e,view:i}=t,s=()=>this.below.inert=!e.get("document");s(),e.on(["document","forgotten"],s),e.on("document",r=>{Kt(this.title,r.label||r.name),this.title.title=r.path??"",i.handles.setParameters(r.parameters,e.get("design")?.bodies??[]);let o=e.get("design")?.handles;o&&i.handles.moveTo(o),i.pose()}),e.on("design",r=>{i.setDesign(r),r.handles&&i.handles.moveTo(r.handles)}),e.on("motion",r=>{i.setMotion(r),this.stage.classList.toggle("predicted",!!r.predicted)}),e.on("forgotten",()=>{i.framed=!1,i.player=null,i.setGhost(null)}),e.on("state",r=>{this.undo.disabled=!r.can_undo,this.redo.disabled=!r.can_redo,i.stage.touch()}),e.on("opened",r=>this.modules.hidden=!r?.of_modules),t.selection.on(({names:r,hovered:o})=>{i.handles.selected=r,i.handles.hovered=o,this.showValue(o??t.selection.first),i.pose()}),e.on("state",()=>this.showValue(t.selection.hovered??t.selection.first))}showValue(t){let i=this.studio.store.get("document")?.parameters.find(d=>d.name===t);if(this.hint.hidden=!i||this.name!=="design",this.hint.hidden)return;let{unit:s}=i,{value:r,lower:o,upper:a,locked:l}=this.studio.readParameter(t),h=s==="m"?4:3,c=s==="rad"?` (${(r*180/Math.PI).toFixed(1)}°)`:"",u=`${o.toFixed(h)} to ${a.toFixed(h)}`;Kt(this.hint,`${t.replaceAll("_"," ")}  ${r.toFixed(h)} ${s}${c}, ${l?"locked":u}`)}show(t){this.name=t;for(let e of[...this.tabs,...this.sides]){let i=e.dataset.workspace===t;e.role==="tab"?e.setAttribute("aria-selected",String(i)):e.hidden=!i}this.showHandles(),this.showValue(this.studio.selection.first)}};var FE=250,ux=document.getElementById("app"),Hi=new dl;function UE(){Ds(()=>{});let n=new Gc(Hi),t=new zc(Hi),e=new Bc(Hi),i=new Pu(Hi),s={start:n,proposal:t,assembly:e,workspace:i};ux.append(n.element,t.element,e.element,i.element,Hi.notices.element,OE(),g("div.opening",{role:"status",aria:{live:"polite"}},"Opening …")),i.element.hidden=n.element.hidden=!0;let r=a=>{for(let[l,h]of Object.entries(s))h.element.hidden=l!==a;document.body.dataset.page=a,s[a].load?.()};Hi.showStart=()=>r("start");let o=({path:a,proposes:l,assembles:h,of_modules:c})=>h?"assembly":l?"proposal":a||c?"workspace":"start";Hi.showOpen=()=>r(o(Hi.store.get("opened"))),Hi.store.on("opened",a=>a&&r(o(a))),Hi.store.on("opening",a=>document.body.classList.toggle("is-opening",a)),M0(document.body,Hi),A0(document),v0(document),y0(document),Hi.start(),Hi.store.on("connected",a=>a&&setTimeout(()=>kE(r),FE))}function OE(){let n=g("p.connection",{role:"status"});return Hi.store.on("trouble",t=>{Kt(n,t),document.body.classList.toggle("disconnected",!!t)}),n}function kE(n){!Hi.store.get("opened")&&!document.body.dataset.page&&n("start")}try{UE()}catch(n){throw ux.append(g("p.fatal",{role:"alert"},n.message)),n}globalThis.legwrightStudio=Hi;
