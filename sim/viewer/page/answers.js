// What answers the page: csgsim view, which serves it. A page without it has another file of this name (sim/web/page).

// {isGood, answer} to a question (sim/viewer/session.h) with its wish.
export const answerTo = async (question, wish) => {
  const reply = await fetch(question, {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify(wish)});
  return {isGood: reply.ok, answer: await reply.json()};
};

// The progress of the question with this evaluation, or an object without members.
export const progressOf = async evaluation => (await answerTo('progress', {evaluation})).answer;

// Ends that question. Its answer says that it was cancelled.
export const cancel = evaluation => answerTo('cancel', {evaluation});

// What the page has to know first.
export const askAbout = async () => (await fetch('about')).json();

// The page is set up.
export const pageIsThere = () => {
  // Open as long as the page is: csgsim view ends with its last page.
  new EventSource('alive');
};
