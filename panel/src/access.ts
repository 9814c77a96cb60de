// The token that the page has got from the server in its address, and the run in that address.

const TOKEN_KEY = 'openr-panel-token';

// Returns the token in the address or, after a reload, in the storage of this tab; "" without a
// token. Removes the token from the address bar, so that it does not get into a screenshot or a
// bookmark.
export function takeToken(): string {
  const address = new URL(location.href);
  const token = address.searchParams.get('token');
  try {
    if (token === null) return sessionStorage.getItem(TOKEN_KEY) ?? '';
    sessionStorage.setItem(TOKEN_KEY, token);
  } catch {
    return token ?? ''; // storage is blocked, so the token stays in the address for a reload
  }
  address.searchParams.delete('token');
  history.replaceState(null, '', address);
  return token;
}

// Returns the run that the address names; "" means the run that has started the server.
export function runOfAddress(): string {
  return new URL(location.href).searchParams.get('run') ?? '';
}

export function setRunOfAddress(run: string): void {
  const address = new URL(location.href);
  if (run === '') address.searchParams.delete('run');
  else address.searchParams.set('run', run);
  history.replaceState(null, '', address);
}
