// The screen writes with the letters of the font texture.
#define texel glyph
