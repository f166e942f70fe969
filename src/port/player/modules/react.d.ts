import type { CanvasHTMLAttributes, ReactElement } from 'react';
import type { MountOptions, Mounted, Uniforms } from './module.js';

export interface ShaderProps extends CanvasHTMLAttributes<HTMLCanvasElement> {
  /** Options of `mount`, read once. */
  options?: MountOptions;
  /** Values of the uniforms that you can set. */
  uniforms?: Partial<Uniforms>;
  paused?: boolean;
  sound?: boolean;
  /** Called with the player after it has been mounted. */
  onMount?: (player: Mounted) => void;
}

export function Shader(props: ShaderProps): ReactElement;
export default Shader;
