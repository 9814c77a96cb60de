// The panel of motions: lists, plays, uploads and deletes them.
import { button, el, setDisabled, setText } from '../dom';
import { confirmButton } from '../confirm';
import { fixed, sizeText } from '../format';
import type { Answer, Motion, PlayAnswer } from '../protocol';
import type { Session } from '../session';
import { makeUpload } from './upload';

interface Playing {
  name: string;
  duration: number; // duration of all loops, in s
  loops: number;
  startedAt: number | null; // virtual time at which the state "mtn" was seen first
  askedAt: number;
  where: 'simulation' | 'robot'; // the dog that plays the file
}

// The longest time between the robot's answer and the start of the motion. A motion that has not
// begun by then will not begin.
const BEGIN_MAX_S = 20;

class Motions {
  readonly element = el('div', { class: 'motions' });
  private readonly list = el('div', { class: 'motion-list' });
  private readonly loops = el('input', {
    type: 'number',
    min: 1,
    max: 65535,
    value: 1,
    'aria-label': 'Loops',
  });
  private readonly stop: HTMLButtonElement;
  private readonly load: HTMLButtonElement;
  private readonly empty: HTMLElement;
  private readonly progress = el('progress', { max: 1, value: 0, 'aria-label': 'Progress of the motion' });
  private readonly whose = el('p', { class: 'hint whose', hidden: true });
  private readonly progressText = el('span', { class: 'progress-text' });
  private readonly progressRow: HTMLElement;
  private playing: Playing | null = null;

  constructor(private readonly session: Session) {
    this.stop = button('■ Stop', () => void this.stopMotion(), { class: 'stop' });
    this.load = button('Show the motions of the robot', () => void this.refresh(), { class: 'primary' });
    this.empty = el(
      'div',
      { class: 'empty' },
      this.load,
      el('p', {}, 'Connects the remote control. Until then this page only watches.'),
    );
    const upload = makeUpload(session, {
      label: 'Upload .MTN',
      accept: '.mtn,.MTN',
      kind: 'motion',
      onDone: () => void this.refresh(),
    });
    const local = makeUpload(session, {
      label: 'Play a file',
      accept: '.mtn,.MTN',
      kind: 'motion',
      loops: () => this.readLoops(),
      onDone: (name, answer) => this.begin(name, answer as unknown as PlayAnswer, 'simulation'),
    });
    local.title = 'Plays a motion of this computer in the simulation; nothing stays on a stick';
    this.progressRow = el('div', { class: 'progress-row', hidden: true }, this.progress, this.progressText);
    this.element.append(
      el(
        'div',
        { class: 'bar' },
        el('label', { class: 'loops' }, el('span', { class: 'caption' }, 'Loops'), this.loops),
        this.stop,
        el('span', { class: 'spring' }),
        local,
        upload,
      ),
      this.whose,
      this.progressRow,
      this.list,
    );
    this.forget();
    session.on('newRun', () => this.forget());
    session.on('robot', () => this.forget());
    let endpoint = '';
    session.on('pair', (pair) => {
      const now = pair.isConnected ? pair.endpoint : '';
      if (now === endpoint) return;
      endpoint = now;
      this.forget();
      this.whose.hidden = now === '';
      setText(this.whose, `Motions of the robot ${now}. With the box Simulation, the simulated dog follows their key frames.`);
    });
    session.on('values', (values) => {
      const state =
        this.playing?.where === 'robot'
          ? (session.pair.status?.robot_state ?? '')
          : (values.robots[session.robot]?.state ?? '');
      this.showState(state, values.time_s);
    });
  }

  private forget(): void {
    this.playing = null;
    this.progressRow.hidden = true;
    this.list.removeAttribute('role');
    this.list.replaceChildren(this.empty);
  }

  private async refresh(): Promise<void> {
    setDisabled(this.load, true);
    const answer = await this.session.rc<{ motions: Motion[] } & Answer>('motions', {}, 'List of motions');
    setDisabled(this.load, false);
    if (answer === null) return;
    const rows = (answer.motions ?? []).map((each) => this.row(each));
    if (rows.length > 0) this.list.setAttribute('role', 'list');
    else this.list.removeAttribute('role');
    this.list.replaceChildren(
      ...(rows.length > 0 ? rows : [el('p', { class: 'empty' }, 'The robot has no motions yet. Upload one.')]),
    );
  }

  private row(motion: Motion): HTMLElement {
    const play = button('▶ Play', () => void this.play(motion.name), {
      'aria-label': `Play ${motion.name}`,
      class: 'play-motion',
    });
    return el(
      'div',
      { class: 'motion', role: 'listitem', 'data-name': motion.name },
      play,
      el('span', { class: 'name' }, motion.name),
      el('span', { class: 'size' }, sizeText(motion.size)),
      confirmButton(
        {
          label: 'Delete',
          question: `Delete ${motion.name}?`,
          yes: 'Delete',
          aria: `Delete ${motion.name}`,
          className: 'quiet',
        },
        () => void this.remove(motion.name),
      ),
    );
  }

  private async play(name: string): Promise<void> {
    const loops = this.readLoops();
    const where = this.session.pair.isConnected ? 'robot' : 'simulation';
    const answer = await this.session.rc<PlayAnswer & Answer>('play', { name, loops }, `Play ${name}`);
    if (answer !== null) this.begin(name, answer, where);
  }

  private readLoops(): number {
    const loops = Math.max(1, Math.min(65535, Math.round(Number(this.loops.value) || 1)));
    this.loops.value = String(loops);
    return loops;
  }

  private begin(name: string, answer: PlayAnswer, where: 'simulation' | 'robot'): void {
    this.playing = {
      name,
      where,
      loops: answer.loops,
      duration: Math.max(0.008, answer.duration_s * answer.loops),
      startedAt: null,
      askedAt: this.session.clock?.time_s ?? 0,
    };
    setText(this.progressText, `${name} begins`);
    this.progress.value = 0;
    this.progressRow.hidden = false;
  }

  private async stopMotion(): Promise<void> {
    if ((await this.session.rc('stop', {}, 'Stop')) !== null) this.session.good('Motion stopped');
  }

  private async remove(name: string): Promise<void> {
    if ((await this.session.rc('delete', { name }, `Delete ${name}`)) === null) return;
    this.session.good(`${name} deleted`);
    await this.refresh();
  }

  private showState(state: string, time: number): void {
    const playing = this.playing;
    for (const row of this.list.querySelectorAll<HTMLElement>('.motion'))
      row.classList.toggle('playing', playing !== null && row.dataset['name'] === playing.name);
    if (playing === null) return;
    if (state === 'mtn') {
      playing.startedAt ??= time;
      const done = Math.min(1, Math.max(0, (time - playing.startedAt) / playing.duration));
      this.progress.value = done;
      const loop = Math.min(playing.loops, Math.floor(done * playing.loops) + 1);
      const loops = playing.loops > 1 ? `, loop ${loop} of ${playing.loops}` : '';
      setText(
        this.progressText,
        `${playing.name} ${fixed(done * playing.duration, 1)} of ${fixed(playing.duration, 1)} s${loops}`,
      );
    } else if (state === 'prepare-mtn') {
      setText(this.progressText, `${playing.name}: going to the first key frame`);
    } else if (playing.startedAt !== null || time - playing.askedAt > BEGIN_MAX_S) {
      this.progressRow.hidden = true;
      if (playing.startedAt !== null) this.session.good(`${playing.name} has ended`);
      this.playing = null;
    }
  }
}

export function makeMotions(session: Session): HTMLElement {
  return new Motions(session).element;
}
