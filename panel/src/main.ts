// The panel: a page that shows a run of openr-host and gives inputs to it.
import './style/base.css';
import './style/layout.css';
import './style/stage.css';
import './style/panels.css';
import './style/graph.css';
import './style/both.css';
import { runOfAddress, setRunOfAddress, takeToken } from './access';
import { makeHeader, makeLinkBanner } from './header';
import { Layout, type PanelDef } from './layout';
import { makeNotices } from './notices';
import { makeBoth } from './panels/both';
import { makeGraph } from './panels/graph';
import { makeJoints } from './panels/joints';
import { makeLog } from './panels/log';
import { makeMotions } from './panels/motions';
import { makePlots } from './panels/plots';
import { makeRobot } from './panels/robot';
import { makeSensors } from './panels/sensors';
import { makeTimeBar } from './panels/time_bar';
import { Session } from './session';
import { startTheme } from './theme';
import { makeStageView } from './view/stage_view';

function start(): void {
  startTheme();
  const session = new Session(takeToken(), runOfAddress());
  const join = (run: string) => {
    setRunOfAddress(run);
    session.join(run);
  };
  session.on('branched', join);
  const panels: PanelDef[] = [
    { id: 'joints', title: 'Joints', element: makeJoints(session) },
    { id: 'motions', title: 'Motions', element: makeMotions(session) },
    { id: 'sensors', title: 'Sensors', element: makeSensors(session) },
    { id: 'graph', title: 'Graph', element: makeGraph(session) },
    { id: 'plots', title: 'Plots', element: makePlots(session) },
    { id: 'log', title: 'Log', element: makeLog(session) },
    { id: 'robot', title: 'Robot', element: makeRobot(session) },
    { id: 'both', title: 'Both dogs', element: makeBoth(session) },
  ];
  const stage = makeStageView(session);
  const layout = new Layout(panels, stage, makeTimeBar(session));
  // Disables the panels that act on the robot while the run is a recording, because nobody can act on
  // a recording.
  const acting = panels.filter((each) => each.id === 'motions' || each.id === 'robot');
  session.on('clock', () => {
    for (const each of acting) each.element.inert = session.isRecording;
    document.body.classList.toggle('recording', session.isRecording);
  });
  const app = document.getElementById('app');
  app?.replaceChildren(
    makeHeader(session, join, (panel) => layout.show(panel)),
    makeLinkBanner(session, join),
    layout.element,
    makeNotices(session),
  );
  session.on('runs', (runs) => {
    document.title = `${session.run || runs.own} · openr panel`;
  });
  session.join(session.run);
}

start();
