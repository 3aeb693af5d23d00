// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/course_editing.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <set>
#include <stdexcept>

namespace placode::curriculum {
namespace {

constexpr uint64_t kLargestSeed = 9007199254740991;  // 2^53 - 1: what JSON carries exactly.

bool good_id(const std::string& id) {
    return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_' || c == '.' || c == '-';
    });
}

void check_exam(const CourseStage& stage, int index, const std::string& pointer,
                std::vector<CourseProblem>& found) {
    if (stage.mode != StageMode::kExam) return;
    const std::string seeds = pointer + "/exam/seeds";
    if (stage.exam.seeds.empty() || stage.exam.seeds.size() > 100)
        found.push_back({CourseFault::kNoSeeds, index, seeds, ""});
    std::set<uint64_t> seen;
    for (const uint64_t seed : stage.exam.seeds)
        if (!seen.insert(seed).second)
            found.push_back({CourseFault::kSeedTwice, index, seeds, std::to_string(seed)});
}

void check_stage(const CourseStage& stage, int index, const std::vector<std::string>& tasks,
                 std::set<std::string>& earlier, std::vector<CourseProblem>& found) {
    const std::string at = "/stages/" + std::to_string(index);
    const auto add = [&](CourseFault fault, const char* field, const std::string& value) {
        found.push_back({fault, index, at + field, value});
    };
    if (std::find(tasks.begin(), tasks.end(), stage.task_id) == tasks.end())
        add(CourseFault::kTask, "/task_id", stage.task_id);
    if (!good_id(stage.id)) add(CourseFault::kStageId, "/id", stage.id);
    for (const std::string& each : stage.requires_stages)
        if (!earlier.contains(each)) add(CourseFault::kRequires, "/requires_stages", each);
    if (!earlier.insert(stage.id).second) add(CourseFault::kStageIdTwice, "/id", stage.id);
    if (!(stage.benchmark_points >= 0 && stage.benchmark_points <= 100))
        add(CourseFault::kBenchmark, "/benchmark_points", std::to_string(stage.benchmark_points));
    if (stage.consecutive < 1 || stage.consecutive > 20)
        add(CourseFault::kConsecutive, "/consecutive", std::to_string(stage.consecutive));
    if (stage.max_attempts != 0 && stage.mode != StageMode::kExam)
        add(CourseFault::kPracticeLimit, "/max_attempts", std::to_string(stage.max_attempts));
    else if (stage.max_attempts < 0 || stage.max_attempts > 1000 ||
             (stage.max_attempts > 0 && stage.max_attempts < stage.consecutive))
        add(CourseFault::kTooFewAttempts, "/max_attempts", std::to_string(stage.max_attempts));
    if (stage.remind_after_days < 0 || stage.remind_after_days > 3650)
        add(CourseFault::kRemind, "/remind_after_days", std::to_string(stage.remind_after_days));
    check_exam(stage, index, at, found);
}

/// Whoever stands before a stage, or is gone, is no longer waited for.
void drop_impossible(Course& course) {
    std::set<std::string> earlier;
    for (CourseStage& stage : course.stages) {
        std::erase_if(stage.requires_stages,
                      [&](const std::string& id) { return !earlier.contains(id); });
        earlier.insert(stage.id);
    }
}

/// "ring", "ring_2" ..
std::string free_id(const Course& course, const std::string& task_id) {
    std::string id = task_id;
    for (int n = 2; course.stage(id) != nullptr; ++n) id = task_id + "_" + std::to_string(n);
    return id;
}

}  // namespace

std::vector<CourseProblem> check_course(const Course& course,
                                        const std::vector<std::string>& tasks) {
    std::vector<CourseProblem> found;
    if (!good_id(course.id)) found.push_back({CourseFault::kId, -1, "/id", course.id});
    if (course.title.en.empty()) found.push_back({CourseFault::kTitle, -1, "/title/en", ""});
    if (course.stages.empty() || course.stages.size() > 100)
        found.push_back(
            {CourseFault::kNoStages, -1, "/stages", std::to_string(course.stages.size())});
    std::set<std::string> earlier;
    for (size_t i = 0; i < course.stages.size(); ++i)
        check_stage(course.stages[i], static_cast<int>(i), tasks, earlier, found);
    return found;
}

void add_stage(Course& course, const std::string& task_id) {
    CourseStage stage;
    stage.task_id = task_id;
    stage.id = free_id(course, task_id);
    if (!course.stages.empty()) stage.requires_stages = {course.stages.back().id};
    course.stages.push_back(std::move(stage));
}

void set_task(Course& course, size_t index, const std::string& task_id) {
    const CourseStage& stage = course.stages[index];
    if (stage.task_id == task_id) return;
    const std::string old = stage.task_id;
    const bool made = stage.id == old || stage.id.rfind(old + "_", 0) == 0;
    course.stages[index].task_id = task_id;
    if (made) rename_stage(course, index, free_id(course, task_id));
}

void remove_stage(Course& course, size_t index) {
    assert(index < course.stages.size());
    course.stages.erase(course.stages.begin() + static_cast<ptrdiff_t>(index));
    drop_impossible(course);
}

void move_stage(Course& course, size_t from, size_t to) {
    assert(from < course.stages.size() && to < course.stages.size());
    CourseStage moved = std::move(course.stages[from]);
    course.stages.erase(course.stages.begin() + static_cast<ptrdiff_t>(from));
    course.stages.insert(course.stages.begin() + static_cast<ptrdiff_t>(to), std::move(moved));
    drop_impossible(course);
}

void rename_stage(Course& course, size_t index, const std::string& id) {
    assert(index < course.stages.size());
    const std::string old = course.stages[index].id;
    course.stages[index].id = id;
    for (size_t i = index + 1; i < course.stages.size(); ++i)
        for (std::string& each : course.stages[i].requires_stages)
            if (each == old) each = id;
}

std::string seeds_text(const std::vector<uint64_t>& seeds) {
    std::string text;
    for (const uint64_t seed : seeds) text += (text.empty() ? "" : ", ") + std::to_string(seed);
    return text;
}

std::vector<uint64_t> seeds_of_text(const std::string& text) {
    std::vector<uint64_t> seeds;
    size_t at = 0;
    while (at < text.size()) {
        const size_t begin = text.find_first_not_of(" ,;\t", at);
        if (begin == std::string::npos) break;
        const size_t end = std::min(text.find_first_of(" ,;\t", begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        uint64_t seed = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
        if (error != std::errc() || stop != word.data() + word.size() || seed > kLargestSeed)
            throw std::invalid_argument(word);
        seeds.push_back(seed);
        at = end;
    }
    return seeds;
}

void CourseDraft::change(Course course, const std::string& key) {
    if (course_json(course) == course_json(now_)) return;
    if (key.empty() || key != key_) past_.push_back(now_);
    now_ = std::move(course);
    future_.clear();
    key_ = key;
}

void CourseDraft::undo() {
    if (past_.empty()) return;
    future_.push_back(std::move(now_));
    now_ = std::move(past_.back());
    past_.pop_back();
    key_.clear();
}

void CourseDraft::redo() {
    if (future_.empty()) return;
    past_.push_back(std::move(now_));
    now_ = std::move(future_.back());
    future_.pop_back();
    key_.clear();
}

}  // namespace placode::curriculum
