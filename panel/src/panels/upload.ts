// Makes a button that uploads a file to the robot, and shows the progress.
import { button, el, setText } from '../dom';
import type { Answer } from '../protocol';
import type { Session } from '../session';

export interface UploadUse {
  label: string;
  accept: string;
  kind: 'motion' | 'controller';
  // Returns how many times the motion is to be played. If set, the motion is played in the
  // simulation and its file is not kept.
  loops?: () => number;
  onDone: (name: string, answer: Answer) => void;
}

const SIZE_MAX = 8 * 1024 * 1024; // size of the largest image, docs/remote-control.md

async function asBase64(file: File): Promise<string> {
  const address = await new Promise<string>((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(new Error(`${file.name} cannot be read`));
    reader.readAsDataURL(file);
  });
  return address.slice(address.indexOf(',') + 1);
}

export function makeUpload(session: Session, use: UploadUse): HTMLElement {
  const file = el('input', { type: 'file', accept: use.accept, hidden: true, 'aria-label': use.label });
  const text = el('span', { class: 'upload-text', role: 'status' });
  const progress = el('progress', { max: 1, value: 0, hidden: true, 'aria-label': 'Progress of the upload' });
  let id = -1;
  session.on('upload', (event) => {
    if (event.id === id && event.size > 0) progress.value = event.sent / event.size;
  });

  async function upload(chosen: File): Promise<void> {
    if (chosen.size === 0 || chosen.size > SIZE_MAX) {
      session.bad(`${chosen.name} is empty or larger than 8 MiB`);
      return;
    }
    setText(text, chosen.name);
    progress.value = 0;
    progress.hidden = false;
    try {
      const data = await asBase64(chosen);
      id = session.idOfNext;
      const endpoint = use.loops === undefined ? (session.pair.targets('upload')[0] ?? 'run') : 'run';
      const answer = await session.ask({
        do: 'rc', call: 'upload', endpoint, robot: session.robot,
        kind: use.kind, name: chosen.name, data, ...(use.loops === undefined ? {} : { loops: use.loops() }),
      });
      if (use.loops === undefined) session.good(`${chosen.name} uploaded`);
      use.onDone(chosen.name, answer);
    } catch (error) {
      const what = use.loops === undefined ? 'uploaded' : 'played';
      session.bad(`${chosen.name} was not ${what}: ${(error as Error).message}`);
    } finally {
      progress.hidden = true;
      setText(text, '');
    }
  }

  file.addEventListener('change', () => {
    const chosen = file.files?.[0];
    file.value = '';
    if (chosen !== undefined) void upload(chosen);
  });
  return el('span', { class: 'upload' }, file, text, progress, button(use.label, () => file.click()));
}
