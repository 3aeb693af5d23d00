// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Touch, Touch X and Omni through the vendor's libHD.so, loaded at run time. One scheduler of the
// vendor's carries both arms: within one tick both frames are begun and read, the force law runs,
// then both forces are set and the frames ended.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "haptics/arm_hands.h"
#include "haptics/openhaptics_arm.h"
#include "haptics/real_time.h"

namespace placode::haptics {

namespace {

using namespace hd;  // NOLINT: the names of one library, in its one driver

constexpr auto kRetry = std::chrono::milliseconds(500);

class OpenHapticsDevice final : public ArmHands {
 public:
    OpenHapticsDevice(const DeviceConfig& config, std::vector<sim::Hand> hands,
                      std::vector<std::string> names)
        : ArmHands(config, hands),
          hd_(hd::load_library(config.station)),
          arms_(hands.size()),
          clock_ns_(config.clock_ns != nullptr ? config.clock_ns : monotonic_ns) {
        for (size_t i = 0; i < arms_.size(); ++i) {
            arms_[i].name = names[i];
            arms_[i].right = hands[i] != sim::Hand::kLeft;
        }
        try {
            for (Arm& arm : arms_) open_arm(hd_, arm);
        } catch (...) {
            disable_all();
            throw;
        }
    }
    ~OpenHapticsDevice() override { stop(); }

    [[nodiscard]] bool start(ServoTick tick, void* context) override {
        tick_ = tick;
        context_ = context;
        begin_session();
        watcher_ = std::thread([this] { watch(); });
        return true;
    }

    void stop() noexcept override {
        if (stopped_) return;
        stopped_ = true;
        {
            const std::lock_guard lock(mutex_);
            leave_ = true;
        }
        wake_.notify_all();
        if (watcher_.joinable()) watcher_.join();
        end_session();
        disable_all();
    }

    [[nodiscard]] int64_t now_ns() const noexcept override { return clock_ns_(); }
    [[nodiscard]] std::string last_error() const override {
        const unsigned code = last_error_.load(std::memory_order_relaxed);
        return code != kSuccess ? error_words(code) : "";
    }

 protected:
    void sense(int64_t, std::span<ArmSample> samples) noexcept override {
        for (size_t i = 0; i < samples.size(); ++i) samples[i] = arms_[i].sample;
    }
    void drive(std::span<const ArmForce> forces) noexcept override {
        for (size_t i = 0; i < forces.size(); ++i) arms_[i].force = forces[i];
    }
    [[nodiscard]] std::vector<DeviceInfo> arm_info() const override {
        std::vector<DeviceInfo> infos;
        for (const Arm& arm : arms_) infos.push_back(arm.info);
        return infos;
    }

 private:
    using Arm = hd::Arm;

    // Forces are enabled by the tick, once an arm is calibrated; the scheduler starts last.
    void begin_session() {
        for (Arm& arm : arms_) {
            arm.calibrated = arm.forces_on = arm.fault = arm.lost = false;
            arm.still_ticks = 0;
        }
        ticks_ = 0;
        drain(hd_);
        hd_.set_rate(kRateHz);
        task_ = hd_.schedule(&OpenHapticsDevice::scheduled, this, kMaxPriority);
        hd_.start_scheduler();
        scheduled_ = true;
    }

    void end_session() noexcept {
        if (!scheduled_) return;
        hd_.stop_scheduler();
        hd_.unschedule(task_);
        scheduled_ = false;
    }

    void disable_all() noexcept {
        for (Arm& arm : arms_) {
            if (arm.handle != kNoHandle) hd_.disable_device(arm.handle);
            arm.handle = kNoHandle;
        }
        drain(hd_);
    }

    static unsigned scheduled(void* self) noexcept {
        return static_cast<OpenHapticsDevice*>(self)->tick_all();
    }

    // Vendor's servo thread.
    unsigned tick_all() noexcept {
        if (over_.load(std::memory_order_relaxed)) return kCallbackDone;
        for (Arm& arm : arms_) {
            hd_.begin_frame(arm.handle);
            read_arm(hd_, arm, ticks_ % kPoll == 0);
        }
        ++ticks_;
        collect_errors();
        for (Arm& arm : arms_) apply_faults(arm);
        if (!tick_(context_, clock_ns_())) over_.store(true, std::memory_order_relaxed);
        const int64_t now = clock_ns_();
        const bool over = any_lost();  // one lost arm ends the session of both
        for (Arm& arm : arms_) {
            hd_.make_current(arm.handle);
            const bool allowed = !over && arm.forces_on &&
                                 arm.sample.status == DeviceStatus::kReady && arm.sample.held &&
                                 now <= arm.force.valid_until_ns;
            const Vec3 force = allowed ? arm.force.force_n : Vec3(Vec3::Zero());
            hd_.set_doublev(kForce, force.data());
            hd_.end_frame(arm.handle);
        }
        collect_errors();
        if (!any_lost()) return kCallbackContinue;
        // The last tick of this session tells the servo that the hands are gone.
        for (Arm& arm : arms_) arm.sample.status = DeviceStatus::kLost;
        if (!tick_(context_, clock_ns_())) over_.store(true, std::memory_order_relaxed);
        for (Arm& arm : arms_) let_go(arm);
        lost_.store(true, std::memory_order_release);
        return kCallbackDone;
    }

    // No frame follows in this session, and the motors would keep what they were given last. Where
    // the library takes one frame a tick only, the output is off all the same.
    void let_go(Arm& arm) noexcept {
        if (arm.handle == kNoHandle) return;
        const Vec3 none = Vec3::Zero();
        hd_.begin_frame(arm.handle);
        hd_.make_current(arm.handle);
        hd_.set_doublev(kForce, none.data());
        hd_.disable(kForceOutput);
        hd_.end_frame(arm.handle);
        arm.forces_on = false;
    }

    // Empties the error stack. An error that names no arm of ours concerns both.
    void collect_errors() noexcept {
        for (int i = 0; i < 64; ++i) {
            const ErrorInfo error = hd_.get_error();
            if (error.code == kSuccess) return;
            if (error.code == kInputType) continue;  // seen after start on sound hardware
            last_error_.store(error.code, std::memory_order_relaxed);
            bool named = false;
            for (const Arm& arm : arms_) named = named || arm.handle == error.device;
            for (Arm& arm : arms_) {
                if (named && arm.handle != error.device) continue;
                if (ends_session(error.code)) arm.lost = true;
                arm.fault = true;
            }
        }
    }

    void apply_faults(Arm& arm) noexcept {
        if (arm.fault) arm.sample.status = DeviceStatus::kFault;
        if (arm.lost) arm.sample.status = DeviceStatus::kLost;
        arm.fault = false;
    }

    [[nodiscard]] bool any_lost() const noexcept {
        for (const Arm& arm : arms_)
            if (arm.lost) return true;
        return false;
    }

    // Own thread, ordinary priority: brings lost arms back.
    void watch() {
        std::unique_lock lock(mutex_);
        while (!wake_.wait_for(lock, kRetry, [this] { return leave_; })) {
            if (!lost_.load(std::memory_order_acquire)) continue;
            end_session();
            disable_all();
            try {
                for (Arm& arm : arms_) open_arm(hd_, arm);
            } catch (const DeviceError&) {
                disable_all();
                continue;  // not yet
            }
            lost_ = false;
            begin_session();
        }
    }

    Library hd_;
    std::vector<Arm> arms_;
    int64_t (*clock_ns_)() noexcept;
    // servo thread
    ServoTick tick_ = nullptr;
    void* context_ = nullptr;
    int64_t ticks_ = 0;
    // crosses threads
    std::atomic<bool> over_{false}, lost_{false};
    std::atomic<unsigned> last_error_{0};
    // owner and watcher
    std::thread watcher_;
    std::mutex mutex_;  // never taken by the servo thread
    std::condition_variable wake_;
    bool leave_ = false, stopped_ = false, scheduled_ = false;
    unsigned long task_ = 0;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_openhaptics(const DeviceConfig& config) {
    const std::string right = config.station.text("openhaptics.right");
    const std::string left = config.station.text("openhaptics.left");
    const bool one_left = config.station.text("arm.one_hand") == "left";
    if (!right.empty() && right == left)
        throw DeviceError("openhaptics: openhaptics.right and openhaptics.left are both \"" +
                          right + "\"; give each arm its own name");
    std::vector<sim::Hand> hands;
    std::vector<std::string> names;
    if (!right.empty() || left.empty()) {
        hands.push_back(left.empty() && one_left ? sim::Hand::kLeft : sim::Hand::kRight);
        names.push_back(right);
    }
    if (!left.empty()) {
        hands.push_back(sim::Hand::kLeft);
        names.push_back(left);
    }
    return std::make_unique<OpenHapticsDevice>(config, hands, names);
}

}  // namespace placode::haptics
