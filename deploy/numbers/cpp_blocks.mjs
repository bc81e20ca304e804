// Functions and classes of C++ code, found by their braces. No compiler is needed, and code that does not compile is
// counted as well. What it takes for a function: a block whose head ends like a function's, outside of another one.

import {codeOf, withoutDirectives} from './cpp_text.mjs';

const QUALIFIERS = String.raw`(?:\s|const|noexcept(?:\s*\([^{}]*?\))?|override|final|mutable|try|&&?|requires[^{}]*)*`;
const FUNCTION = new RegExp(String.raw`\)${QUALIFIERS}(?:->\s*[\w:<>,\s*&()]+)?$`);
const INITIALISERS = new RegExp(String.raw`\)${QUALIFIERS}:(?!:)[^;]*$`);  // of a constructor, so far
const SCOPE = /^(?:(?:inline\s+)?namespace\b|extern\s+_+$|(?:export\s+)?(?:class|struct|union|enum)\b)/;

const LABELS = /^(\s*(public|private|protected)\s*:(?!:))*\s*/;

/** A head without what may stand before its first word: access labels, attributes, template parameters. */
function bare(head) {
  let text = head.replace(/\[\[[^\]]*\]\]/g, ' ').replace(LABELS, '').trim();
  while (text.startsWith('template')) {
    let [depth, end] = [0, text.indexOf('<')];
    do {
      if (text[end] === '<') ++depth;
      if (text[end] === '>') --depth;
      ++end;
    } while (depth > 0 && end < text.length);
    text = text.slice(end).trim();
  }
  return text;
}

/** 'scope', 'function', or 'value': a braced initialiser, after which the statement goes on. */
function kindOf(head) {
  const text = bare(head);
  if (SCOPE.test(text) && !/[)=]$/.test(text)) return 'scope';
  if (INITIALISERS.test(text)) return /[)}]$/.test(text) ? 'function' : 'value';
  return FUNCTION.test(text) ? 'function' : 'value';
}

/** The end of the block that begins at `open`, behind its last bracket. */
export function endOfBlock(code, open) {
  const [begins, ends] = code[open] === '{' ? ['{', '}'] : ['(', ')'];
  let depth = 0;
  for (let at = open; at < code.length; ++at) {
    if (code[at] === begins) ++depth;
    if (code[at] === ends && --depth === 0) return at + 1;
  }
  return code.length;
}

const linesIn = (code, from, to) => code.slice(from, to).split('\n').length;
const nameIn = (head) => /([~\w:]+(?:\s*operator\s*[^\s(]+)?|operator\s*[^\s(]+)\s*\(/.exec(bare(head))?.[1] ?? 'lambda';

/** The functions of a file: name, line, and number of lines from the head to the last brace. */
export function functionsIn(text) {
  const code = withoutDirectives(codeOf(text));
  const found = [];
  let [begin, at] = [0, 0];  // of the statement; of the reader
  const next = () => (begin = at);
  while (at < code.length) {
    if (code[at] === '(') at = endOfBlock(code, at);
    else if (code[at] === ';' || code[at] === '}') ++at, next();
    else if (code[at] === '{') {
      const head = code.slice(begin, at);
      const kind = kindOf(head);
      if (kind === 'scope') ++at, next();
      else {
        const end = endOfBlock(code, at);
        if (kind === 'function') {
          const first = begin + LABELS.exec(head)[0].length;
          found.push({name: nameIn(head), line: linesIn(code, 0, first), lines: linesIn(code, first, end)});
        }
        at = end;
        if (kind === 'function') next();
      }
    }
    else ++at;
  }
  return found;
}

/** The body of class `name`, between its braces; undefined: the text does not define it. */
function bodyOf(code, name) {
  const head = new RegExp(String.raw`\b(?:class|struct)\s+(?:\w+\s+)*${name}\b(?!\s*;)[^;{()]*\{`).exec(code);
  if (head === null) return undefined;
  const open = head.index + head[0].length - 1;
  return code.slice(open + 1, endOfBlock(code, open) - 1);
}

/**
 * The statements of a class's body. Brackets of types are left out; ( ) becomes ¶ and { } becomes §, and a function's body
 * ends its statement.
 */
function statementsIn(body) {
  let text = body.replace(/\b(public|private|protected)\s*:(?!:)/g, ' ');
  for (let before = ''; before !== text;) {
    before = text;
    text = text.replace(/\([^(){}]*\)/g, '¶').replace(/\{[^{}]*\}/g, '§').replace(/<[^<>;(){}=]*>/g, ' ');
  }
  return text.replace(/([¶§](?:\s|const|noexcept|override|final|&)*)§/g, '$1;').split(';');
}

/** The data members that class `name` has of its own, by the house's rule that their names end in an underscore. */
export function membersOf(text, name) {
  const body = bodyOf(withoutDirectives(codeOf(text)), name);
  if (body === undefined) return undefined;
  return statementsIn(body).flatMap((statement) => {
    const [declared] = statement.replace(/\[[^\]]*\]/g, '').split(/(?<!:):(?!:)/);  // without a constructor's initialisers
    return declared.split(',').flatMap((part) => /\b([a-z]\w*_)[\s§]*$/.exec(part.split('=')[0])?.[1] ?? []);
  });
}
