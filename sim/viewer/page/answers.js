// Requests to csgsim view, which serves the page. The page without a server has its own file of this name
// (sim/web/page).

// Answers a question (sim/viewer/session.h) with its request, as {isGood, answer}.
export const answerTo = async (question, request) => {
  const reply = await fetch(question, {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(request)});
  return {isGood: reply.ok, answer: await reply.json()};
};

// Progress of the question with this evaluation name; an empty object if there is none.
export const progressOf = async evaluation => (await answerTo('progress', {evaluation})).answer;

// Cancels the question with this evaluation name; its answer then has `cancelled`.
export const cancel = evaluation => answerTo('cancel', {evaluation});

// Returns the data that the page needs at its start.
export const askAbout = async () => (await fetch('about')).json();

// Called when the page is set up.
export const pageIsThere = () => {
  // This stream stays open as long as the page: csgsim view stops after its last page.
  new EventSource('alive');
};
