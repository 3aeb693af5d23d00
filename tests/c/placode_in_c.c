/* SPDX-FileCopyrightText: 2026 The Placode authors */
/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A C program with placode.h, as a function: 0, or the line that failed. */
#include <stdlib.h>
#include <string.h>

#include "interface/placode.h"

int placode_in_c(const char* scene_changes);

#define CHECK(what) \
    if (!(what)) return __LINE__

int placode_in_c(const char* scene_changes) {
    placode_fields* fields = placode_fields_new(4);
    placode_options options;
    placode_environment* environment;
    placode_outcome outcome;
    double action[PLACODE_ACTION_SIZE * 4];
    double* observation;
    size_t size, i;
    CHECK(fields != NULL);
    CHECK(strstr(placode_fields_tasks(fields), "touch_targets") != NULL);
    placode_options_init(&options);
    options.scene_changes = scene_changes;
    options.fields = 1;
    environment = placode_environment_new(fields, "touch_targets", &options);
    CHECK(environment != NULL);
    CHECK(placode_tool_count(environment) == 2);
    CHECK(strcmp(placode_tool_kind(environment, 0), "probe") == 0);
    CHECK(placode_reset(environment, 1) == PLACODE_OK);
    memset(action, 0, sizeof action);
    action[2] = -1; /* down */
    memset(&outcome, 0, sizeof outcome);
    outcome.size = sizeof outcome;
    for (i = 0; i < 5; ++i)
        CHECK(placode_step(environment, action, 2 * PLACODE_ACTION_SIZE, 20, 0, &outcome) ==
              PLACODE_OK);
    CHECK(outcome.frames == 20 && outcome.end == PLACODE_GOING_ON);
    size = placode_observation_size(environment);
    CHECK(strcmp(placode_observation_name(environment, 0), "time_s") == 0);
    CHECK(placode_observation_name(environment, size) == NULL);
    observation = (double*)malloc(size * sizeof(double));
    CHECK(observation != NULL);
    CHECK(placode_observe(environment, observation, size) == PLACODE_OK);
    CHECK(observation[0] > 0.099 && observation[0] < 0.101);
    free(observation);
    placode_environment_free(environment);
    placode_fields_free(fields);
    return 0;
}
