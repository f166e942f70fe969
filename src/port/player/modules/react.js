// The React component for `mount`.

import { createElement, useEffect, useRef } from 'react';

/**
 * The shader as a component that fills its parent. `options` are those of `mount` and are read once;
 * `uniforms`, `paused` and `sound` are read whenever they change; all other props go to the canvas.
 */
export function Shader({ options, uniforms, paused = false, sound = false, onMount, style, ...rest }) {
  const canvas = useRef(null);
  const mounted = useRef(null);
  useEffect(() => {
    const player = mount(canvas.current, { ...options, paused, sound });
    mounted.current = player;
    onMount?.(player);
    return () => {
      mounted.current = null;
      player.dispose();
    };
    // Options are read once: to change them, render the component with another key.
  }, []);
  useEffect(() => {
    const player = mounted.current;
    void player?.ready.then(() => {
      if (mounted.current !== player) return;
      if (paused) player.pause();
      else player.play();
    });
  }, [paused]);
  useEffect(() => {
    mounted.current?.setSound(sound);
  }, [sound]);
  useEffect(() => {
    if (mounted.current) Object.assign(mounted.current.uniforms, uniforms);
  }, [uniforms]);
  const whole = { width: '100%', height: '100%', display: 'block', ...style };
  return createElement('canvas', { ...rest, ref: canvas, style: whole });
}

export default Shader;
