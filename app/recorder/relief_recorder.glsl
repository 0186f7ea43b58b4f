// Records what a tracer in a shader does, for `relief diagnose` and for the window of Reliefscope (Ctrl+T).
//
//     reliefBegin(ray);                       // the number of the ray: the row of the file of rays, from 0
//     ... in the loop:  reliefStep(from, to, height_at_to);
//     ... at the end:   reliefHit(lambda);    // or reliefMiss(), or reliefLimit()
//
// lambda is the descent of the ray: 0 in the polygon's plane (height 1), 1 at the bottom of the relief (height 0). The
// answers of all rays are written, and the steps of one of them, the chosen ray (-1: of none).
//
// The buffer, which the program makes, fills and reads back: four ints, that is the number of records, 0, the chosen ray
// and the number of rays; then the records, four floats each: first one for each ray, then room for steps.
// relief_recorder.py turns its bytes into files (write_buffer). In HLSL, define RELIEF_HLSL before including this file.
#ifndef RELIEF_RECORDER
#define RELIEF_RECORDER

#ifdef RELIEF_HLSL
#ifndef RELIEF_RECORDER_REGISTER
#define RELIEF_RECORDER_REGISTER u7
#endif
RWByteAddressBuffer reliefBuffer : register(RELIEF_RECORDER_REGISTER);
static uint reliefRay, reliefTaken;
static float reliefLastAt, reliefLastHeight;
void reliefPut(uint record, float4 values) { reliefBuffer.Store4(16 + 16 * record, asuint(values)); }
uint reliefCapacity() { return reliefBuffer.Load(0); }
uint reliefAnswers() { return reliefBuffer.Load(12); }
bool reliefChosen() { return asint(reliefBuffer.Load(8)) == int(reliefRay); }
uint reliefNext() {
    uint next;
    reliefBuffer.InterlockedAdd(4, 1, next);
    return next;
}
#define RELIEF_VEC4 float4
#else
#ifndef RELIEF_RECORDER_BINDING
#define RELIEF_RECORDER_BINDING 7
#endif
layout(std430, binding = RELIEF_RECORDER_BINDING) buffer ReliefRecorder {
    int reliefRecords;
    int reliefCount;
    int reliefChosenRay;
    int reliefRays;
    vec4 reliefData[];
};
uint reliefRay, reliefTaken;
float reliefLastAt, reliefLastHeight;
void reliefPut(uint record, vec4 values) { reliefData[record] = values; }
uint reliefCapacity() { return uint(reliefRecords); }
uint reliefAnswers() { return uint(reliefRays); }
bool reliefChosen() { return reliefChosenRay == int(reliefRay); }
uint reliefNext() { return uint(atomicAdd(reliefCount, 1)); }
#define RELIEF_VEC4 vec4
#endif

void reliefBegin(uint ray) {
    reliefRay = ray;
    reliefTaken = 0u;
    reliefLastAt = 0.0;
    reliefLastHeight = 1.0;
}

// Decisions: 0 advance, 1 hit, 2 miss, 3 limit.
void reliefLog(float from, float to, float height, float decision) {
    reliefTaken += 1u;
    if (!reliefChosen()) return;
    uint record = reliefAnswers() + reliefNext();
    if (record < reliefCapacity()) reliefPut(record, RELIEF_VEC4(from, to, height, decision));
}

// The search has looked at the surface at lambda = to, found the height there, and moved on to it from `from`.
void reliefStep(float from, float to, float height) {
    reliefLog(from, to, height, 0.0);
    reliefLastAt = to;
    reliefLastHeight = height;
}

void reliefAnswer(float lambda, float outcome) {
    reliefLog(min(reliefLastAt, lambda), lambda, reliefLastHeight, outcome);
    bool hasRoom = reliefRay < reliefAnswers() && reliefRay < reliefCapacity();
    if (hasRoom) reliefPut(reliefRay, RELIEF_VEC4(outcome, lambda, float(reliefTaken), 0.0));
}
void reliefHit(float lambda) { reliefAnswer(lambda, 1.0); }
void reliefMiss() { reliefAnswer(reliefLastAt, 2.0); }
void reliefLimit() { reliefAnswer(reliefLastAt, 3.0); }

#endif
