// What eslint holds web/ and its tests to: tests/web/run lint. What runs text as code, or makes
// elements of it, is refused: texts come from messages of others.
import js from '@eslint/js';

const known = (names) => Object.fromEntries(names.map((name) => [name, 'readonly']));

/** Names that browsers define, as far as the page uses them. */
const browser = known([
  'AbortController', 'AbortSignal', 'Blob', 'CSS', 'DecompressionStream', 'Element', 'Event',
  'EventSource', 'File',
  'HTMLElement', 'Image', 'ImageData', 'MediaRecorder', 'MutationObserver', 'Node', 'Path2D',
  'ResizeObserver', 'Response', 'SharedWorker', 'TextDecoder', 'URL', 'URLSearchParams', 'addEventListener', 'atob', 'cancelAnimationFrame',
  'clearInterval', 'clearTimeout', 'console', 'createImageBitmap', 'devicePixelRatio', 'document',
  'fetch', 'getComputedStyle', 'history', 'location', 'matchMedia', 'navigator', 'performance',
  'removeEventListener', 'requestAnimationFrame', 'self', 'sessionStorage', 'setInterval',
  'setTimeout', 'window',
]);
const node = known([
  'AbortController', 'Buffer', 'TextEncoder', 'URL', 'clearInterval', 'clearTimeout', 'console', 'fetch',
  'performance', 'process', 'setImmediate', 'setInterval', 'setTimeout', 'structuredClone',
]);

const rules = {
  ...js.configs.recommended.rules,
  'array-callback-return': 'error',
  'consistent-return': 'error',
  'default-case-last': 'error',
  eqeqeq: ['error', 'always', {null: 'ignore'}],
  'no-constructor-return': 'error',
  'no-else-return': 'error',
  'no-implicit-coercion': ['error', {boolean: true, number: true, string: true}],
  'no-lonely-if': 'error',
  'no-promise-executor-return': 'error',
  'no-self-compare': 'error',
  'no-shadow': 'error',
  'no-template-curly-in-string': 'error',
  'no-throw-literal': 'error',
  'no-unmodified-loop-condition': 'error',
  'no-unused-expressions': 'error',
  'no-useless-return': 'error',
  'no-var': 'error',
  'object-shorthand': 'error',
  'prefer-const': 'error',
  'prefer-template': 'error',
  radix: 'error',
  // Nothing that came from outside becomes code or elements.
  'no-eval': 'error',
  'no-implied-eval': 'error',
  'no-new-func': 'error',
  'no-script-url': 'error',
  'no-restricted-properties': ['error',
    ...['innerHTML', 'outerHTML', 'insertAdjacentHTML', 'write', 'writeln', 'parseFromString',
      'createContextualFragment'].map((property) => (
      {property, message: 'Make text nodes: web/page/dom.js.'}))],
};

export default [
  {linterOptions: {reportUnusedDisableDirectives: 'error'}},
  {ignores: ['web/vendor/**']},
  {
    files: ['web/**/*.js'],
    languageOptions: {ecmaVersion: 2022, sourceType: 'module', globals: browser},
    rules,
  },
  {
    files: ['tests/web/**/*.mjs'],
    languageOptions: {ecmaVersion: 2022, sourceType: 'module', globals: {...browser, ...node}},
    rules: {...js.configs.recommended.rules, 'no-shadow': 'error', 'prefer-const': 'error'},
  },
];
