// Making elements of the page.
'use strict';

/// An element with attributes and children (elements, text, or null for none). An attribute that is false or null is
/// left out; `on<event>` is a listener.
function element(tag, attributes = {}, ...children) {
  return dress(document.createElement(tag), attributes, children);
}

/// The same for SVG.
function svgElement(tag, attributes = {}, ...children) {
  return dress(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

function dress(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

/// A table with a heading row; its caption, if there is one, also names it to screen readers. A column is
/// {heading, number: bool}; a row holds a text or an element for each column.
function tableElement(caption, columns, rows) {
  const align = (column) => (column.number ? 'number' : null);
  return element('div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': caption ?? 'table'},
    element('table', {},
      caption ? element('caption', {}, caption) : null,
      element('thead', {}, element('tr', {},
        ...columns.map((column) => element('th', {scope: 'col', class: align(column)}, column.heading)))),
      element('tbody', {}, ...rows.map((row) => element('tr', {},
        ...row.map((cell, i) => element('td', {class: align(columns[i])}, cell)))))));
}

/// A section of the details with its heading.
function sectionElement(id, heading, ...children) {
  return element('section', {id, 'aria-labelledby': `${id}-heading`},
    element('h2', {id: `${id}-heading`}, heading), ...children);
}
