// A pixel is split into 4 by 4 samples at an edge, counted from its middle outward.

#ifndef SAMPLES
#define SAMPLES
const int FINE = 4;
const int WHOLE = 0xFFFF;              // all of them, a bit for each

// Row by row: 5, 6, 9, 10, 1, 2, 4, 7, 8, 11, 13, 14, 0, 3, 12, 15.
int sample_place(int index) {
    return int((index < 8 ? 0x7421A965u : 0xFC30EDB8u) >> uint(4 * (index & 7))) & 15;
}

vec2 sample_offset(int index) {
    int place = sample_place(index);
    return (vec2(float(place & 3), float(place >> 2)) + 0.5) / float(FINE) - 0.5;
}

float count_of(int mask) {
    mask -= (mask >> 1) & 0x5555;
    mask = (mask & 0x3333) + ((mask >> 2) & 0x3333);
    mask = (mask + (mask >> 4)) & 0x0F0F;
    return float((mask + (mask >> 8)) & 0x1F);
}
#endif
