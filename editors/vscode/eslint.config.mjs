import js from '@eslint/js';
import { defineConfig } from 'eslint/config';
import { configs } from 'typescript-eslint';

export default defineConfig(
    { ignores: ['dist', 'node_modules'] },
    js.configs.recommended,
    {
        files: ['src/**/*.ts'],
        extends: [configs.strictTypeChecked],
        languageOptions: { parserOptions: { projectService: true } },
        rules: {
            'eqeqeq': 'error',
            'max-lines': ['error', 400],
            'max-lines-per-function': ['error', { max: 80, skipComments: true }],
            'no-else-return': 'error',
            'object-shorthand': 'error',
            'prefer-template': 'error',
            '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
        },
    },
    { files: ['*.mjs'], languageOptions: { globals: { Object: 'readonly', process: 'readonly', Promise: 'readonly', URL: 'readonly' } } },
    {
        // The shell of the preview runs in the webview, as it is.
        files: ['media/*.js'],
        languageOptions: {
            sourceType: 'script',
            globals: Object.fromEntries(
                ['acquireVsCodeApi', 'clearTimeout', 'document', 'KeyboardEvent', 'setTimeout', 'window'].map((name) => [name, 'readonly']),
            ),
        },
        rules: { 'eqeqeq': 'error', 'no-var': 'error', 'object-shorthand': 'error', 'prefer-const': 'error', 'prefer-template': 'error' },
    },
);
