// The player's files share one scope: declarations of one are used by the next ones.
const player = 'src/port/player';
const rules = {
  'array-callback-return': 'error',
  'consistent-return': 'off',
  'default-case-last': 'error',
  'dot-notation': 'error',
  'eqeqeq': 'error',
  'max-lines': ['error', 500],
  'max-lines-per-function': ['error', 80],
  'no-constant-condition': 'error',
  'no-dupe-keys': 'error',
  'no-else-return': 'error',
  'no-eval': 'error',
  'no-implied-eval': 'error',
  'no-implicit-coercion': 'error',
  'no-lonely-if': 'error',
  'no-new-func': 'error',
  'no-self-compare': 'error',
  'no-shadow-restricted-names': 'error',
  'no-throw-literal': 'error',
  'no-unneeded-ternary': 'error',
  'no-unreachable': 'error',
  'no-unused-expressions': 'error',
  'no-useless-return': 'error',
  'no-var': 'error',
  'object-shorthand': 'error',
  'prefer-const': 'error',
  'prefer-template': 'error',
  'require-await': 'error',
};

/** Tests wait for events and states only. */
const waits = {
  'no-restricted-globals': ['error', ...['setTimeout', 'setInterval'].map((name) => ({ name, message: 'Wait for an event.' }))],
  'no-restricted-imports': ['error', 'node:timers', 'node:timers/promises', 'timers', 'timers/promises'],
  'no-restricted-properties': ['error', { property: 'waitForTimeout' }, { property: 'setTimeout' }, { property: 'setInterval' }],
};

export default [
  { ignores: [`${player}/min`] },
  { files: [`${player}/**/*.js`], languageOptions: { sourceType: 'script', ecmaVersion: 2023 }, rules },
  {
    files: ['packaging/npm/*/*.js', 'tests/package/*.cjs'],
    languageOptions: { sourceType: 'commonjs', ecmaVersion: 2023 },
    rules,
  },
  {
    files: [
      `${player}/modules/*.js`,
      'tests/**/*.{js,mjs}', 'site/.vitepress/**/*.js', 'editors/vscode/media/*.js', 'src/wasm/js/*.js',
      'site/playground/*.js', 'site/playground/src/*.js',
    ],
    languageOptions: { sourceType: 'module', ecmaVersion: 2023 },
    rules,
  },
  { files: ['tests/**'], rules: waits },
];
