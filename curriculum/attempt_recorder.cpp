// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/attempt_recorder.h"

#include <chrono>
#include <exception>

#include "curriculum/stage_start.h"

namespace placode::curriculum {

namespace {

constexpr auto kPoll = std::chrono::milliseconds(10);
// Half of what a crash may lose, in time of day and (an attempt may run faster) in frames.
constexpr auto kCommit = std::chrono::milliseconds(250);
constexpr size_t kCommitFrames = 250;
// 16 s of frames and samples: longer than the sink waits for whoever reads its file. A frame may
// raise up to 256 events, though it hardly ever does.
constexpr size_t kInputs = 16384, kSamples = 2048, kEvents = 16384;

template <class T>
void take_all(sim::Ring<T>& ring, std::vector<T>& block) {
    for (T value; ring.pop(value);) block.push_back(value);
}

}  // namespace

AttemptRecorder::AttemptRecorder(std::unique_ptr<sim::RecordingSink> sink,
                                 sim::RecordingHeader header,
                                 std::shared_ptr<const StageStart> start)
    : sink_(std::move(sink)),
      header_(std::move(header)),
      start_(std::move(start)),
      discard_(sink_ == nullptr),
      inputs_(kInputs),
      samples_(kSamples),
      events_(kEvents) {}

AttemptRecorder::~AttemptRecorder() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
}

void AttemptRecorder::start() {
    if (sink_) thread_ = std::thread([this] { run(); });
}

void AttemptRecorder::finish(const sim::RecordingEnd& end) {
    end_ = end;
    stop_.store(true, std::memory_order_release);
    if (thread_.joinable()) thread_.join();
}

std::string AttemptRecorder::problem() const {
    const std::lock_guard lock(problem_mutex_);
    return problem_;
}

bool AttemptRecorder::put(const sim::Input& input) noexcept {
    return discard_.load(std::memory_order_relaxed) || inputs_.push(input);
}
bool AttemptRecorder::put(const sim::Sample& sample) noexcept {
    return discard_.load(std::memory_order_relaxed) || samples_.push(sample);
}
bool AttemptRecorder::put(const sim::Event& event) noexcept {
    return discard_.load(std::memory_order_relaxed) || events_.push(event);
}

void AttemptRecorder::give_up(const std::string& why) {
    discard_ = true;
    const std::lock_guard lock(problem_mutex_);
    problem_ = "The recording stopped: " + why;
}

void AttemptRecorder::drain(bool everything) {
    take_all(inputs_, input_block_);
    take_all(samples_, sample_block_);
    take_all(events_, event_block_);
    const bool anything = !input_block_.empty() || !sample_block_.empty() || !event_block_.empty();
    if (!anything || !(everything || input_block_.size() >= kCommitFrames)) return;
    sink_->append(input_block_, sample_block_, event_block_);
    kept_.fetch_add(static_cast<int64_t>(input_block_.size()), std::memory_order_relaxed);
    input_block_.clear();
    sample_block_.clear();
    event_block_.clear();
}

void AttemptRecorder::run() {
    // The only place where a sink's exception is caught: the attempt goes on without it.
    try {
        sink_->begin(header_);
        if (start_) sink_->give(start_->given);
        start_.reset();
        auto committed = std::chrono::steady_clock::now();
        while (!stop_.load(std::memory_order_acquire)) {
            std::this_thread::sleep_for(kPoll);
            const auto now = std::chrono::steady_clock::now();
            const bool due = now - committed >= kCommit;
            drain(due);
            if (due) committed = now;
        }
        drain(true);
        // An end without a reason is an owner that went away: the file stays interrupted.
        if (end_.reason != sim::EndReason::kRunning) sink_->finish(end_);
    } catch (const std::exception& error) {
        give_up(error.what());
    }
}

}  // namespace placode::curriculum
