// The player's files share one scope: declarations of one are used by the next ones.
const player = 'src/port/player';
const rules = {
  'array-callback-return': 'error',
  'consistent-return': 'off',
  'default-case-last': 'error',
  'dot-notation': 'error',
  'eqeqeq': 'error',
  'max-lines': ['error', 500],
  'max-lines-per-function': ['error', { max: 110, skipComments: true }],
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
      'tests/browser/*.js', 'tests/browser/page/*.js', 'tests/site/*.js', 'site/.vitepress/**/*.js',
      'tests/wasm/*.js', 'tests/package/*.mjs', 'src/wasm/js/*.js', 'site/playground/*.js', 'site/playground/src/*.js',
    ],
    languageOptions: { sourceType: 'module', ecmaVersion: 2023 },
    rules,
  },
];
