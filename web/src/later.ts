// The parts of the page that the first film does not need. They are loaded after that film, or when somebody asks for
// them.

import css from './later.css' with { type: 'text' };

const looks = new CSSStyleSheet();
looks.replaceSync(css);
document.adoptedStyleSheets.push(looks);

export { OBJECTIVES } from './objectives';
export { applyRequest, take, unitChanged } from './app/importing';
export { offerBox } from './app/box';
export { hintOfRig, placeRig, showRigs } from './app/rigging';
export { whenBack } from './app/reach';
export { pictureRecent, showRecent } from './app/recent';
export { follow } from './model/rigging';
export { copy, openShare, savePicture } from './app/sharing';
export { cableTable } from './panels/cables';
export { charts, samplesOf } from './panels/chart';
export { Compare } from './panels/compare';
export { Flat } from './panels/flat';
export { build, disable, schemaOf } from './panels/form';
export { gallery } from './panels/gallery';
export { details, statistics, warnings } from './panels/report';
export { OWN } from './panels/own';
export { openShort, unpack } from './panels/share';
export * as trees from './stage/trees';
