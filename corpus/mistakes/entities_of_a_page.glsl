void mainImage(out vec4 fragColor, in vec2 fragCoord) {
    vec2 uv = fragCoord / iResolution.xy;
    vec3 col = vec3(0.0);
    for (int i = 0; i &lt; 5; i++) {
        if (uv.x &gt; 0.5 &amp;&amp; uv.y &gt; 0.5) col += 0.1;
    }
    fragColor = vec4(col, 1.0);
}
