
type ThreeOf<Text> = Of<Text> extends { material: infer Values } ? Values : {};
/** The uniforms of a program as three.js has them. */
export type ThreeUniforms<Vertex, Fragment> = ThreeOf<Vertex> & ThreeOf<Fragment>;

/** A material whose uniforms have the types that its shaders declare. */
export type TypedMaterial<Vertex, Fragment> = Omit<ShaderMaterial, "uniforms"> & { uniforms: ThreeUniforms<Vertex, Fragment> };

/** A `ShaderMaterial` that sets each uniform of its shaders. */
export function shaderMaterial<
  Vertex extends ShaderText,
  Fragment extends ShaderText & { readonly [Message in LinkErrors<Vertex, Fragment>]: never },
>(
  parameters: Omit<ShaderMaterialParameters, "uniforms" | "vertexShader" | "fragmentShader"> & {
    vertexShader: Vertex;
    fragmentShader: Fragment;
    uniforms: ThreeUniforms<Vertex, Fragment>;
  },
): TypedMaterial<Vertex, Fragment> {
  return new ShaderMaterial(parameters as ShaderMaterialParameters) as unknown as TypedMaterial<Vertex, Fragment>;
}
