// SPDX-License-Identifier: Apache-2.0
// The page: starts where the server stands, at the first page, at what is proposed for a robot, at
// the modules of one that is assembled, or at the workspace.
import { h, setText } from "./dom.js";
import { Studio } from "./studio.js";
import { AssemblyPage } from "./ui/assembly/assembly_page.js";
import { takeHeldTitles } from "./ui/held_titles.js";
import { takeNumbers } from "./ui/number_fields.js";
import { ProposalPage } from "./ui/proposal_page.js";
import { StartPage, takeDrops } from "./ui/start_page.js";
import { followTheme } from "./ui/theme.js";
import { takeTouches } from "./ui/touch_sliders.js";
import { Workspace } from "./ui/workspace.js";

const NOTHING_OPEN = 250; // ms after which it is clear that nothing is open

const root = document.getElementById("app");
const studio = new Studio();

function begin() {
  followTheme(() => {});
  const start = new StartPage(studio);
  const proposal = new ProposalPage(studio);
  const assembly = new AssemblyPage(studio);
  const workspace = new Workspace(studio);
  const pages = { start, proposal, assembly, workspace };
  root.append(
    start.element,
    proposal.element,
    assembly.element,
    workspace.element,
    studio.notices.element,
    connectionLine(),
    h("div.opening", { role: "status", aria: { live: "polite" } }, "Opening …"),
  );
  workspace.element.hidden = start.element.hidden = true;
  const show = (name) => {
    for (const [each, page] of Object.entries(pages)) page.element.hidden = each !== name;
    document.body.dataset.page = name;
    pages[name].load?.();
  };
  studio.showStart = () => show("start");
  const pageOf = ({ path, proposes, assembles, of_modules: built }) =>
    assembles ? "assembly" : proposes ? "proposal" : path || built ? "workspace" : "start";
  studio.showOpen = () => show(pageOf(studio.store.get("opened")));
  studio.store.on("opened", (opened) => opened && show(pageOf(opened)));
  studio.store.on("opening", (on) => document.body.classList.toggle("is-opening", on));
  takeDrops(document.body, studio);
  takeTouches(document);
  takeNumbers(document);
  takeHeldTitles(document);
  studio.start();
  studio.store.on("connected", (on) => on && setTimeout(() => beginAtStart(show), NOTHING_OPEN));
}

/** Why nothing comes from the server any more, over whatever is shown, or over an empty page. */
function connectionLine() {
  const line = h("p.connection", { role: "status" });
  studio.store.on("trouble", (trouble) => {
    setText(line, trouble);
    document.body.classList.toggle("disconnected", Boolean(trouble));
  });
  return line;
}

/** Shows the first page where nothing is open: the server tells at once of what is. */
function beginAtStart(show) {
  if (!studio.store.get("opened") && !document.body.dataset.page) show("start");
}

try {
  begin();
} catch (error) {
  root.append(h("p.fatal", { role: "alert" }, error.message));
  throw error;
}
// What tests and the benchmark look at.
globalThis.legwrightStudio = studio;
