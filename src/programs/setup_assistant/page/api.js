// Requests to the server, and its events.

class Refused extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

async function answerOf(response) {
  if (response.ok) return response.json();
  let message = `${response.status} ${response.statusText}`;
  try {
    message = (await response.json()).error ?? message;
  } catch {
    // A 403 has no body.
  }
  throw new Refused(response.status, message);
}

// Identifies this page, so that the server refuses a waiting request only for a later one of the same page.
const PAGE = {
  'X-Page': Math.random().toString(36).slice(2)
};

export async function get(path, query = {}, options = {}) {
  const given = Object.entries(query).filter(([, value]) => value !== undefined && value !== null);
  const text = new URLSearchParams(given).toString();
  return answerOf(await fetch(text ? `${path}?${text}` : path, {headers: PAGE, ...options}));
}

export async function getPicture(path, query) {
  const response = await fetch(`${path}?${new URLSearchParams(query)}`, {headers: PAGE});
  return response.ok ? response.blob() : answerOf(response);
}

export async function post(path, body = {}) {
  return answerOf(await fetch(path, {
    method: 'POST',
    headers: {'Content-Type': 'application/json', ...PAGE},
    body: JSON.stringify(body),
  }));
}

// Calls `listeners[name](data)` for each event, and `onConnection('live' | 'lost' | 'refused')`.
export function listen(listeners, onConnection) {
  const source = new EventSource('api/events');
  source.onopen = () => onConnection('live');
  source.onerror = () => {
    onConnection('lost');
    // The browser tries again by itself unless it was refused.
    if (source.readyState !== EventSource.CLOSED) return;
    setTimeout(async () => {
      try {
        await get('api/state');
        listen(listeners, onConnection);
      } catch (error) {
        if (error.status === 403)
          onConnection('refused');
        else
          listen(listeners, onConnection);
      }
    }, 1500);
  };
  for (const [name, listener] of Object.entries(listeners)) {
    source.addEventListener(name, (event) => listener(JSON.parse(event.data)));
  }
}
