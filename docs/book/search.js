// The search of the site: ranks the pages of search-data.js. Titles, subjects and headings weigh more than defined terms, and
// these more than text. docs/book/search.py writes the data.

const WEIGHTS = {
  title: 1000, inTitle: 500, // the whole title, a part of it
  subject: 250,
  heading: 250, inHeading: 120,
  term: 100, atTermsBegin: 70, inTerm: 30, furtherTerm: 3, // of a first cell of a table, or a bold word
  literal: 40, // the query as typed, with its hyphens and points
  option: 120, // an option of a command, on the page of the commands
  text: 2, // each occurrence
  prose: 30, // of a section with an occurrence outside of tables and listings, among the sections of a page
};
const COMMANDS = "command-line.html";
const MOST_IN_TEXT = 20; // occurrences in the text of a page that count
const EXCERPT = 220; // characters

// The query as a pattern: hyphens, underscores and blanks are equal, so that "pixel-planes-5" finds "Pixel-planes 5".
function patternOf(query, flags) {
  const words = query.toLowerCase().split(/[-_\s]+/).filter(Boolean);
  const escaped = words.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  const last = escaped.length - 1;
  if (/[a-z]{3}$/.test(escaped[last])) escaped[last] = escaped[last].replace(/([^s])s$/, "$1") + "s?"; // singular and plural
  return new RegExp("(?<![a-z0-9])" + escaped.join("[-_\\s]+") + "(?![a-z0-9])", flags);
}

const count = (text, pattern) => (text.match(pattern) || []).length;

const isWhole = (text, pattern) => /^\W*$/.test(text.replace(pattern, ""));

// The score of a section: its heading, its terms and its text.
function sectionScore(section, pattern, query) {
  let score = 0;
  if (count(section.heading, pattern)) score += isWhole(section.heading, pattern) ? WEIGHTS.heading : WEIGHTS.inHeading;
  const weights = section.terms.split(" | ").filter((term) => count(term, pattern)).map((term) => {
    if (isWhole(term, pattern)) return WEIGHTS.term;
    return new RegExp("^\\W*" + pattern.source, "i").test(term) ? WEIGHTS.atTermsBegin : WEIGHTS.inTerm;
  });
  if (weights.length) score += Math.max(...weights) + WEIGHTS.furtherTerm * Math.min(weights.length - 1, 5);
  if (/[-_.]/.test(query) && section.terms.toLowerCase().includes(query.toLowerCase())) score += WEIGHTS.literal;
  return score;
}

function pageScore(page, query) {
  const pattern = patternOf(query, "gi");
  let score = 0;
  if (count(page.title, pattern)) score += isWhole(page.title, pattern) ? WEIGHTS.title : WEIGHTS.inTitle;
  if (count(page.subject, pattern)) score += WEIGHTS.subject;
  const scores = page.sections.map((section, at) => (at ? sectionScore(section, pattern, query) : 0)).sort((a, b) => b - a);
  score += (scores[0] || 0) + 0.2 * (scores[1] || 0);
  if (query.startsWith("--") && page.path === COMMANDS && score) score += WEIGHTS.option;
  const found = page.sections.reduce((sum, section) => sum + count(section.text, pattern) + count(section.other, pattern), 0);
  return score + WEIGHTS.text * Math.min(found, MOST_IN_TEXT);
}

// A page that lacks the query as it was typed, but has all of its words, ranks behind those that have it.
function looseScore(page, query) {
  const words = query.split(/\s+/).filter(Boolean);
  if (words.length < 2) return 0;
  const scores = words.map((word) => pageScore(page, word));
  return scores.every(Boolean) ? Math.min(...scores) / 100 : 0;
}

// The parts of a text around the first place of the query: [text, is found] pairs.
function excerpt(text, query) {
  const at = text.search(patternOf(query, "i"));
  const begin = at < 0 ? 0 : Math.max(0, text.lastIndexOf(" ", Math.max(0, at - EXCERPT / 3)) + 1);
  const piece = text.slice(begin, begin + EXCERPT);
  const parts = [];
  let last = 0;
  for (const found of piece.matchAll(patternOf(query, "gi"))) {
    parts.push([piece.slice(last, found.index), false], [found[0], true]);
    last = found.index + found[0].length;
  }
  parts.push([piece.slice(last), false]);
  return [[begin ? "… " : "", false], ...parts, [begin + EXCERPT < text.length ? " …" : "", false]];
}

// Pages that have the query, the best first, each with the section to begin with and an excerpt.
function search(all, query) {
  query = query.trim();
  if (!/[a-z0-9]/i.test(query)) return [];
  const results = [];
  for (const page of all) {
    const score = pageScore(page, query) || looseScore(page, query);
    if (!score) continue;
    const pattern = patternOf(query, "gi");
    const of = (section) => {
      const found = count(section.text, pattern);
      return sectionScore(section, pattern, query) + WEIGHTS.text * Math.min(found, MOST_IN_TEXT) + (found ? WEIGHTS.prose : 0);
    };
    const best = page.sections.reduce((one, other) => (of(other) > of(one) ? other : one), page.sections[0]);
    const text = count(best.text, pattern) || !count(best.other, pattern) ? best.text : best.other;
    results.push({ score, page, section: best, excerpt: excerpt(text, query) });
  }
  return results.sort((a, b) => b.score - a.score);
}

function element(name, text, properties) {
  const made = Object.assign(document.createElement(name), properties);
  made.textContent = text;
  return made;
}

function show(query) {
  const place = document.getElementById("search-results");
  const results = search(pages, query);
  document.querySelectorAll("input[name=q]").forEach((input) => (input.value = query));
  place.append(element("h1", "Search"), element("p", `${results.length} pages contain “${query}”.`));
  const list = document.createElement("ol");
  for (const { page, section, excerpt: parts } of results) {
    const item = document.createElement("li");
    const isTop = section === page.sections[0];
    item.append(element("a", page.title + (isTop ? "" : ` › ${section.heading}`), { href: page.path + (isTop ? "" : `#${section.id}`) }));
    const text = document.createElement("p");
    text.append(...parts.map(([words, isFound]) => (isFound ? element("mark", words) : document.createTextNode(words))));
    item.append(text);
    list.append(item);
  }
  place.append(list);
}

if (typeof document === "undefined") module.exports = { search };
else show(new URLSearchParams(location.search).get("q") || "");
