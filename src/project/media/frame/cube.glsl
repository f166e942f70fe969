void main() {
    color = vec4(look(direction()), 1.0);
}
