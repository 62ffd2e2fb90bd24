// Values in one line, in YAML's flow style: 0.5, robot, [1, 2], {uniform: [0, 1]}.

const NUMBER = /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/;
const PLAIN = /^[A-Za-z_/.~$][^,:#[\]{}&*!|>'"%@`\n]*$/;

export function parseFlow(text) {
  const parser = new FlowParser(text);
  const value = parser.value();
  parser.skipSpace();
  if (parser.at < text.length) throw new Error(`'${text.slice(parser.at)}' is left over`);
  return value;
}

// A number, true or false, or else the text itself, without quotes.
export function parseScalar(text) {
  const trimmed = text.trim();
  if (NUMBER.test(trimmed)) return Number(trimmed);
  if (trimmed === 'true' || trimmed === 'false') return trimmed === 'true';
  const quoted = /^"(.*)"$/.exec(trimmed) ?? /^'(.*)'$/.exec(trimmed);
  return quoted ? quoted[1] : trimmed;
}

export function printFlow(value) {
  if (value === undefined || value === null) return '';
  if (Array.isArray(value)) return `[${value.map(printFlow).join(', ')}]`;
  if (typeof value === 'object') {
    return `{${Object.entries(value).map(([key, each]) => `${key}: ${printFlow(each)}`).join(', ')}}`;
  }
  if (typeof value === 'string') return printText(value);
  return String(value);
}

function printText(text) {
  const readsAsOther = NUMBER.test(text) || text === 'true' || text === 'false';
  return !readsAsOther && PLAIN.test(text) && text.trim() === text ? text : JSON.stringify(text);
}

class FlowParser {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }

  skipSpace() {
    while (/\s/.test(this.text[this.at] ?? '')) ++this.at;
  }

  value() {
    this.skipSpace();
    const first = this.text[this.at];
    if (first === undefined) throw new Error('a value is missing');
    if (first === '[') return this.list();
    if (first === '{') return this.map();
    return this.scalar(/[,\]}]/);
  }

  list() {
    const values = [];
    this.entries(']', () => values.push(this.value()));
    return values;
  }

  map() {
    const values = {};
    this.entries('}', () => {
      const key = String(this.scalar(/[:,}]/));
      this.skipSpace();
      if (this.text[this.at] !== ':') throw new Error(`':' is missing after '${key}'`);
      ++this.at;
      values[key] = this.value();
    });
    return values;
  }

  entries(end, read) {
    ++this.at;
    for (this.skipSpace(); this.text[this.at] !== end; this.skipSpace()) {
      if (this.at >= this.text.length) throw new Error(`'${end}' is missing`);
      read();
      this.skipSpace();
      if (this.text[this.at] === ',')
        ++this.at;
      else if (this.text[this.at] !== end)
        throw new Error(`',' or '${end}' is missing`);
    }
    ++this.at;
  }

  scalar(end) {
    this.skipSpace();
    const quote = this.text[this.at];
    if (quote === '"' || quote === "'") {
      const close = this.text.indexOf(quote, this.at + 1);
      if (close < 0) throw new Error(`${quote} is missing`);
      const text = this.text.slice(this.at + 1, close);
      this.at = close + 1;
      return text;
    }
    let stop = this.at;
    // deg(20) and $(find x) are not cut within their parentheses.
    for (let depth = 0; stop < this.text.length; ++stop) {
      if (this.text[stop] === '(') ++depth;
      if (this.text[stop] === ')') --depth;
      if (depth <= 0 && end.test(this.text[stop])) break;
    }
    const text = this.text.slice(this.at, stop).trim();
    this.at = stop;
    if (!text) throw new Error('a value is missing');
    return parseScalar(text);
  }
}
