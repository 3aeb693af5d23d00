// Depth only: how far the light reaches.
void main() {}
