/* SPDX-FileCopyrightText: 2026 The Placode authors */
/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Placode for other programs: tasks of fetoscopic spina bifida repair as environments. C11 and C++.
 *
 * Handles are opaque and there is no global state. A handle belongs to one thread at a time.
 * Different handles may be used at the same time, also environments that share a `placode_fields`.
 * No exception leaves a function: it answers with a
 * status, and the handle keeps the reason in words until its next call. Functions that answer with
 * a pointer to text keep it valid until the next call with the same handle.
 *
 * Lengths are in metres, angles in radians, time in seconds unless a name says otherwise. World
 * frame: x cranial, y left, z outward from the back, origin at the lesion. One frame lasts 1 ms.
 *
 * Stable: a later version only adds functions, members at the end of structs, and names. Set
 * `size` of a struct with its init function, which also fills in the defaults.
 */
#ifndef PLACODE_H
#define PLACODE_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define PLACODE_API __attribute__((visibility("default")))
#else
#define PLACODE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define PLACODE_API_VERSION 1

/* Version of the library that was loaded, as PLACODE_API_VERSION. */
PLACODE_API int placode_api_version(void);
/* Version of the program, such as "0.1.0". Lives for ever. */
PLACODE_API const char* placode_version(void);

typedef enum placode_status {
    PLACODE_OK = 0,
    PLACODE_BAD_ARGUMENT = 1,   /* null handle, wrong size, not finite, out of range */
    PLACODE_BAD_DEFINITION = 2, /* task, scene or changes of it cannot be used */
    PLACODE_NOT_RESET = 3,      /* nothing has begun: reset first */
    PLACODE_ENDED = 4,          /* the attempt is over: reset first */
    PLACODE_RUNNING = 5,        /* the attempt is not over yet */
    PLACODE_OTHER_TASK = 6,     /* a saved moment of another task */
    PLACODE_NO_PICTURE = 7,     /* no OpenGL to draw with */
    PLACODE_FILE = 8,           /* a file exists already or cannot be written */
    PLACODE_NO_MEMORY = 9,
    PLACODE_INTERNAL = 10
} placode_status;

/* Name of a status, such as "bad argument". Lives for ever. */
PLACODE_API const char* placode_status_name(placode_status status);

typedef struct placode_fields placode_fields;
typedef struct placode_environment placode_environment;
typedef struct placode_moment placode_moment;
typedef struct placode_expert placode_expert;
typedef struct placode_batch placode_batch;
typedef struct placode_picture placode_picture;

/* --- fields: operative fields that were built, shared by all environments made with them --- */

/* Keeps so many fields although no environment uses them. Null without memory. */
PLACODE_API placode_fields* placode_fields_new(size_t most_kept);
/* After all environments made with it. Null is allowed here and in all other _free. */
PLACODE_API void placode_fields_free(placode_fields* fields);
/* How many fields were built so far: equal fields are built once. */
PLACODE_API size_t placode_fields_built(const placode_fields* fields);
/* Why placode_environment_new answered null; empty = it did not. */
PLACODE_API const char* placode_fields_error(const placode_fields* fields);
/* Ids of the tasks that are installed, separated by newlines. */
PLACODE_API const char* placode_fields_tasks(placode_fields* fields);

/* --- environment --- */

typedef enum placode_units {
    PLACODE_NORMALISED = 0, /* speeds and switches from -1 to 1 */
    PLACODE_ABSOLUTE = 1    /* places in metres, angles in radians */
} placode_units;

typedef struct placode_options {
    size_t size;            /* sizeof(placode_options) */
    int32_t threads;        /* of the physics, 1 to 64; results are the same with any number. 1 */
    int32_t units;          /* placode_units. PLACODE_NORMALISED */
    int32_t sparse;         /* 1: the reward is points/100 at the end and 0 before. 0 */
    int32_t record;         /* 1: keep what a recording needs (160 kB a second). 0 */
    uint64_t fields;        /* seed s gets the lesion 1 + s % fields; 0: every seed its own. 0 */
    double speed_m_s;       /* of a tip at a normalised 1; at most 0.3. 0.03 */
    double time_limit_s;    /* earlier than the task's own; 0: the task's. 0 */
    double start_spread_m;  /* tips start up to so far from home, by seed; at most 0.01. 0 */
    double judge_every_s;   /* points are asked for so often; 0: at the end only. 0.5 */
    double approach_weight; /* of the way to the present goal in the dense reward. 0.2 */
    const char* scene_changes; /* JSON merged into the task's scene, or null. null */
} placode_options;

PLACODE_API void placode_options_init(placode_options* options);

/* `task`: id of an installed task or path of a JSON file. `options` may be null. Null on failure:
 * placode_fields_error says why. */
PLACODE_API placode_environment* placode_environment_new(placode_fields* fields, const char* task,
                                                         const placode_options* options);
PLACODE_API void placode_environment_free(placode_environment* environment);
/* Why the last call failed; empty after one that did not. */
PLACODE_API const char* placode_error(const placode_environment* environment);

/* Known without a reset. */
PLACODE_API size_t placode_tool_count(const placode_environment* environment);
/* "needle", "hook", "grasper", "scissors", "probe", "needle_driver", "irrigator" or
 * "scope". */
PLACODE_API const char* placode_tool_kind(const placode_environment* environment, size_t tool);
/* Whose: "right", "left" or "camera". Instruments of one hand share a port and take turns. */
PLACODE_API const char* placode_tool_hand(const placode_environment* environment, size_t tool);
PLACODE_API const char* placode_task_id(const placode_environment* environment);
/* The whole task with its resolved scene, as JSON. */
PLACODE_API const char* placode_task_json(const placode_environment* environment);
/* When an attempt ends at the latest. */
PLACODE_API double placode_time_limit_s(const placode_environment* environment);

/* A new attempt. A seed whose field was built before takes some milliseconds, another one about as
 * many seconds as the field is large. */
PLACODE_API placode_status placode_reset(placode_environment* environment, uint64_t seed);

/* Numbers of an action for each tool, in this order. They are held for all frames of a step.
 *
 *      PLACODE_NORMALISED [-1, 1]                 PLACODE_ABSOLUTE
 *   0  velocity of the tip along x, share of      x of the tip [m], reached at the end of the step,
 *   1    y    `speed_m_s`; together at most 1     y    at most 0.3 m/s
 *   2    z                                        z
 *   3  turn about the shaft, share of 4 rad/s     roll [rad], at most 10 rad/s
 *   4  jaws: -1 closed, 1 wide open               opening [rad], at most 12 rad/s
 *   5  yellow pedal (cut): pressed above 0        above 0.5
 *   6  blue pedal (coagulate): above 0            above 0.5; both pedals at once are none
 *   7  in its port: above 0; matters only for     above 0.5
 *        tools that share one: the largest is in
 *
 * Numbers beyond their range count as its end. Tips reach from -0.06 to 0.06 m in x and y and from
 * -0.01 to 0.08 m in z; the shaft always goes through the tool's port. */
#define PLACODE_ACTION_SIZE 8

typedef enum placode_end {
    PLACODE_GOING_ON = 0,
    PLACODE_FINISHED = 1, /* what was to be done is done, or `finish` was said */
    PLACODE_TIME_LIMIT = 2
} placode_end;

typedef struct placode_outcome {
    size_t size;     /* sizeof(placode_outcome) */
    double reward;   /* score + approach, or sparse */
    double score;    /* change of the rubric's points since they were last asked for, / 100 */
    double approach; /* weighted: way to the present goals that was covered, / 20 mm */
    int32_t end;     /* placode_end */
    int32_t success; /* it is over and a person would have passed */
    int32_t frames;  /* simulated; fewer than asked for when the attempt ended */
} placode_outcome;

/* `frames` frames with one action of `count` = tools * PLACODE_ACTION_SIZE numbers. `finish` = 1
 * declares the task done afterwards. `outcome` may be null; set its size. */
PLACODE_API placode_status placode_step(placode_environment* environment, const double* action,
                                        size_t count, int32_t frames, int32_t finish,
                                        placode_outcome* outcome);

/* --- what there is to see --- */

PLACODE_API size_t placode_observation_size(const placode_environment* environment);
/* Name of a number of the observation, e.g. "tool0.tip_x_mm"; null beyond the last. */
PLACODE_API const char* placode_observation_name(const placode_environment* environment, size_t i);
/* `count` = placode_observation_size. */
PLACODE_API placode_status placode_observe(placode_environment* environment, double* out,
                                           size_t count);

/* The planned incision where it lies now: points of 3 m, and 1 where it is cut. Both arrays may be
 * null. `points` gets the number of points; nothing is copied when it is more than `room`. */
PLACODE_API placode_status placode_contour(placode_environment* environment, double* xyz_m,
                                           uint8_t* cut, size_t room, size_t* points);
/* The tissue's surface: vertices of 3 m, triangles of 3 indices, and per vertex blanch, dried,
 * charred (0 to 1) and temperature [C]. As above. Vertex numbers keep their meaning during an
 * attempt; cutting adds vertices up to a limit known from the start. */
PLACODE_API placode_status placode_surface(placode_environment* environment, float* xyz_m,
                                           float* damage, size_t vertex_room, int32_t* triangles,
                                           size_t triangle_room, size_t* vertices,
                                           size_t* triangle_count);

typedef struct placode_event {
    double time_s;
    int32_t kind; /* placode_event_name */
    int32_t tool; /* -1: none */
    float value, value2;
    float rest_position_m[3];
} placode_event;

/* Events of this attempt from number `first` on; `count` gets how many there are in all. At most
 * `room` are copied. */
PLACODE_API placode_status placode_events(placode_environment* environment, size_t first,
                                          placode_event* out, size_t room, size_t* count);
/* "tissue torn": what happened, in English. Lives for ever. */
PLACODE_API const char* placode_event_name(int32_t kind);

/* The score when it was last asked for: every `judge_every_s`, and at the end. Points of 100; 1 =
 * a person would have passed. */
PLACODE_API placode_status placode_score(placode_environment* environment, double* points,
                                         int32_t* passed);
/* The score now, with every metric by name and what the rubric took points for, as one JSON object:
 * {"points", "verdict", "metrics": {...}, "reasons": [{"item", "text", "points", "critical"}]}. */
PLACODE_API placode_status placode_score_json(placode_environment* environment, const char** json);

/* --- going back --- */

PLACODE_API placode_moment* placode_moment_new(void);
PLACODE_API void placode_moment_free(placode_moment* moment);
PLACODE_API size_t placode_moment_bytes(const placode_moment* moment);
/* Everything that decides what happens next, and the recording so far. */
PLACODE_API placode_status placode_save(placode_environment* environment, placode_moment* into);
/* In the same environment or in another one of the same task with the same changes of its scene and
 * the same fields. Goes on bit by bit as from the first time. */
PLACODE_API placode_status placode_restore(placode_environment* environment,
                                           const placode_moment* from);
/* Hash of everything that decides what happens next. */
PLACODE_API placode_status placode_state_hash(placode_environment* environment, uint64_t* hash);

/* --- recordings --- */

/* The attempt that has just ended, as a new file for `placodectl score` and `import`, or to watch
 * with `placode-sim`. Needs the option `record` of the environment in which the attempt began:
 * a moment saved without it has no inputs elsewhere either. The file says that no person made it.
 */
PLACODE_API placode_status placode_write_recording(placode_environment* environment,
                                                   const char* path);

/* --- pictures --- */

/* Draws the fetoscope's picture off-screen, without a display. Null: placode_error says why, e.g.
 * that there is no OpenGL 3.3. After a reset. Smoke and lens remember what was drawn before. */
PLACODE_API placode_picture* placode_picture_new(placode_environment* environment, int32_t width,
                                                 int32_t height);
PLACODE_API void placode_picture_free(placode_picture* picture);
/* (height x width x 3) bytes, rows from the top; `count` = height * width * 3. */
PLACODE_API placode_status placode_draw(placode_environment* environment, placode_picture* picture,
                                        uint8_t* rgb, size_t count);

/* --- scripted operators as policies --- */

/* "expert", "intermediate" or "novice". Null: placode_error says why. */
PLACODE_API placode_expert* placode_expert_new(placode_environment* environment, const char* level,
                                               uint64_t seed);
PLACODE_API void placode_expert_free(placode_expert* expert);
/* What the operator does in the next `frames` frames, in PLACODE_ABSOLUTE units. `done` may be
 * null; 1: the operator considers the task done, say `finish`. */
PLACODE_API placode_status placode_expert_act(placode_environment* environment,
                                              placode_expert* expert, int32_t frames,
                                              double* action, size_t count, int32_t* done);

/* --- many at once --- */

typedef enum placode_autoreset {
    PLACODE_NEXT_STEP = 0,
    PLACODE_SAME_STEP = 1,
    PLACODE_NO_AUTORESET = 2
} placode_autoreset;

/* Environments of one task, stepped by `threads` threads. They must outlive the batch, and are not
 * used by anybody else meanwhile. Null: placode_error of the first says why. */
PLACODE_API placode_batch* placode_batch_new(placode_environment* const* environments, size_t count,
                                             placode_autoreset autoreset, int32_t threads);
PLACODE_API void placode_batch_free(placode_batch* batch);
PLACODE_API const char* placode_batch_error(const placode_batch* batch);
/* N seeds and N observations, one after the other. After its n-th attempt an environment goes on
 * with its seed + n N. */
PLACODE_API placode_status placode_batch_reset(placode_batch* batch, const uint64_t* seeds,
                                               double* observations);
/* N actions. `final_observations` only with PLACODE_SAME_STEP, else null; of environments whose
 * attempt ended. The other arrays have N entries. */
PLACODE_API placode_status placode_batch_step(placode_batch* batch, const double* actions,
                                              int32_t frames, double* observations,
                                              double* final_observations, double* rewards,
                                              uint8_t* terminated, uint8_t* truncated,
                                              uint8_t* success);
/* Before a step: N flags, 1 = the task is declared done with it. */
PLACODE_API placode_status placode_batch_finish(placode_batch* batch, const uint8_t* which);
/* After a step: the parts of its N rewards, and the points; with PLACODE_SAME_STEP those of an
 * attempt that ended. Null for what is not wanted. */
PLACODE_API placode_status placode_batch_last(placode_batch* batch, double* score_parts,
                                              double* approach_parts, double* points);

#ifdef __cplusplus
}
#endif

#endif
