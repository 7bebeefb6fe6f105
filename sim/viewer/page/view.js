// Entry point of the page of csgsim view.
import {askAbout, pageIsThere} from './answers.js';
import {byId} from './dom.js';
import {now} from './asking.js';
import {draw} from './draw.js';
import {setUpJudged} from './judged.js';
import {setUpKnobs} from './knobs.js';
import {setUpProgress} from './progress.js';
import {setUpSource} from './source.js';
import {setUpStage} from './stage.js';
import {setUpTime} from './time.js';
import {setUpTwo} from './two.js';
import {setUpWhy} from './why.js';
import {setUpWires} from './wires.js';

const begin = async () => {
  const about = await askAbout();
  now.about = about;
  document.title = about.model + ' - csgsim view';
  byId('title').textContent = about.model;
  byId('where').textContent = 'Changes here are drawn but not saved: ' + about.model + ' stays unchanged.';
  byId('source').value = about.source;
  setUpKnobs(about);
  setUpProgress();
  setUpSource();
  setUpStage();
  setUpTime();
  setUpTwo();
  setUpWhy();
  setUpJudged();
  setUpWires();
  draw();
  pageIsThere();
};
begin();
