// C++ text without what the compiler does not count: comments and the contents of literals become placeholders. Lines
// stay lines, so that a place in the result is a place in the source.

const RAW_STRING = /R"([^()\\\s]{0,16})\(/y;

/** True if the quote at `at` separates digits, as in 10'000. */
const separatesDigits = (text, at) =>
  /[0-9a-fA-F]/.test(text[at + 1] ?? '') && /(^|[^\w'])[0-9][\w.']*$/.test(text.slice(Math.max(0, at - 40), at));

function endOfLiteral(text, at) {
  const quote = text[at];
  for (let end = at + 1; end < text.length; ++end) {
    if (text[end] === '\\') ++end;
    else if (text[end] === quote) return end + 1;
    else if (text[end] === '\n') return end;  // an unfinished literal, in an #error for example
  }
  return text.length;
}

function endOfComment(text, at) {
  const [mark, from] = text[at + 1] === '/' ? ['\n', at] : ['*/', at + 2];
  const end = text.indexOf(mark, from);
  return end < 0 ? text.length : end + (mark === '\n' ? 0 : 2);
}

/** Comments become spaces, and each character of a literal an underscore; line breaks stay. */
export function codeOf(text) {
  let [code, at] = ['', 0];
  const take = (end, instead) => {
    code += text.slice(at, end).replace(/[^\n]/g, instead);
    at = end;
  };
  while (at < text.length) {
    const letter = text[at];
    if (letter === '/' && (text[at + 1] === '/' || text[at + 1] === '*')) take(endOfComment(text, at), ' ');
    else if (letter === 'R' && text[at + 1] === '"' && !/\w/.test(text[at - 1] ?? '')) {
      RAW_STRING.lastIndex = at;
      const mark = RAW_STRING.exec(text)?.[1];
      const end = mark === undefined ? -1 : text.indexOf(`)${mark}"`, at);
      take(end < 0 ? at + 1 : end + mark.length + 2, '_');
    }
    else if (letter === '"' || (letter === "'" && !separatesDigits(text, at))) take(endOfLiteral(text, at), '_');
    else take(at + 1, letter);
  }
  return code;
}

/** The code without preprocessor directives, whose braces need not match. */
export const withoutDirectives = (code) =>
  code.replace(/^[ \t]*#(?:[^\n\\]|\\\n|\\.)*/gm, (directive) => directive.replace(/[^\n]/g, ' '));

/** Lines that are neither blank nor only a comment. */
export const codeLines = (text) => codeOf(text).split('\n').filter((line) => line.trim() !== '').length;
