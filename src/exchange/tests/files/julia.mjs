// Julia's own tools are in no registry that tests install from, but a grammar of it is: parses a
// camera by it, and works out its rays from the syntax tree, by Julia's rules for numbers and
// vectors. node julia.mjs MODULES FILE I J I J ...: six numbers a pixel, a line each.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [modules, file, ...places] = process.argv.slice(2);
const grammar = join(modules, '@plutojl/lezer-julia/dist/index.js');
const { parser } = await import(pathToFileURL(grammar));

const text = readFileSync(file, 'utf8');
const tree = parser.parse(text);
tree.iterate({
  enter(node) {
    if (node.type.isError) throw new Error(`not Julia at ${node.from}: ${text.slice(node.from)}`);
  },
});

const said = (node) => text.slice(node.from, node.to);
const parts = (node) => {
  const found = [];
  for (let part = node.firstChild; part; part = part.nextSibling) {
    if (!['[', ']', '(', ')', 'LineComment', 'const', 'return'].includes(part.name)) found.push(part);
  }
  return found;
};

/** Julia has these for two numbers, and for a number or a vector on either side where they mean something. */
function operate(sign, a, b) {
  const vectors = [a, b].filter(Array.isArray).length;
  if (vectors === 0) return { '+': a + b, '-': a - b, '*': a * b, '/': a / b }[sign];
  if (vectors === 2 && '+-'.includes(sign)) return a.map((x, k) => operate(sign, x, b[k]));
  if (sign === '*' && vectors === 1) {
    return Array.isArray(a) ? a.map((x) => x * b) : b.map((x) => a * x);
  }
  if (sign === '/' && !Array.isArray(b)) return a.map((x) => x / b);
  throw new Error(`Julia has no ${sign} for these`);
}

function value(node, names) {
  const inside = parts(node);
  switch (node.name) {
    case 'FloatLiteral':
    case 'IntegerLiteral':
      return Number(said(node));
    case 'Identifier':
      if (!names.has(said(node))) throw new Error(`${said(node)} is not defined`);
      return names.get(said(node));
    case 'VectorExpression':
    case 'OpenTuple':
      return inside.map((part) => value(part, names));
    case 'ParenExpression':
      return value(inside[0], names);
    case 'UnaryExpression':
      return operate('*', said(inside[0]) === '-' ? -1 : 1, value(inside[1], names));
    case 'BinaryExpression':
      return operate(said(inside[1]), value(inside[0], names), value(inside[2], names));
    default:
      throw new Error(`${node.name} is not expected here: ${said(node)}`);
  }
}

function assign(node, names) {
  const [left, , right] = parts(node);
  const values = value(right, names);
  if (left.name === 'Identifier') names.set(said(left), values);
  else parts(left).forEach((name, k) => names.set(said(name), values[k]));
}

const globals = new Map();
let ray;
for (const node of parts(tree.topNode)) {
  if (node.name === 'ConstStatement') assign(parts(node)[0], globals);
  if (node.name === 'FunctionDefinition') ray = node;
}

function called(i, j) {
  const names = new Map(globals).set('i', i).set('j', j);
  for (const node of parts(ray)) {
    if (node.name === 'Assignment') assign(node, names);
    if (node.name === 'ReturnStatement') return value(parts(node)[0], names);
  }
  throw new Error('ray returns nothing');
}

for (let k = 0; k < places.length; k += 2) {
  console.log(called(Number(places[k]), Number(places[k + 1])).flat().join(' '));
}
