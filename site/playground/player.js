// Writes the page that plays the shader, which is the page that `shaderport` writes, without a shader.
import fs from 'node:fs';
import { Shaderlint, portAddress } from './wasm/index.js';

const shaderport = await Shaderlint.load(portAddress());
fs.mkdirSync('public', { recursive: true });
fs.writeFileSync('public/player.html', shaderport.playerPage());
