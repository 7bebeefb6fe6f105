// Access to elements of the page, by id.
export const byId = id => document.getElementById(id);

export const grouped = number => String(number).replace(/\B(?=(\d{3})+$)/g, ',');

export const make = (name, attributes = {}, ...children) => {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
};

export const button = (text, act, attributes = {}) => {
  const made = make('button', {type: 'button', ...attributes}, ...[text].flat());
  made.addEventListener('click', act);
  return made;
};

// Announces a text to screen readers.
export const announce = text => { byId('told').textContent = text; };
