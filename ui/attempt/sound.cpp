// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Output through OpenAL Soft. The only file that knows it. Tones are loops whose loudness changes,
// so that a slow picture never makes a gap.

#include "ui/attempt/sound.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace placode::ui {

namespace {

constexpr std::array<double, kTones> kLoudness{0.5, 0.5, 0.35};
constexpr double kAlarmLoudness = 0.9;

ALuint buffer_of(const std::vector<float>& samples) {
    std::vector<int16_t> pcm(samples.size());
    std::transform(samples.begin(), samples.end(), pcm.begin(), [](float x) {
        return static_cast<int16_t>(std::lround(32767 * std::clamp(x, -1.0F, 1.0F)));
    });
    ALuint buffer = 0;
    alGenBuffers(1, &buffer);
    alBufferData(buffer, AL_FORMAT_MONO16, pcm.data(),
                 static_cast<ALsizei>(pcm.size() * sizeof(int16_t)), kSampleRate);
    return buffer;
}

}  // namespace

struct Sound::Impl {
    SoundSettings settings;
    std::string problem;
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    LPALCRENDERSAMPLESSOFT render = nullptr;
    std::array<ALuint, kTones> tone{}, tone_buffer{};
    std::array<ALuint, kAlarms> alarm{}, alarm_buffer{};

    void open(Output output) {
        if (output == Output::kLoopback) {
            open_loopback();
        } else {
            device = alcOpenDevice(nullptr);
            if (device == nullptr) problem = "no audio device";
            if (device != nullptr) context = alcCreateContext(device, nullptr);
        }
        if (device == nullptr) return;
        if (context == nullptr || alcMakeContextCurrent(context) == ALC_FALSE) {
            problem = "the audio device cannot be used";
            return;
        }
        for (size_t i = 0; i < tone.size(); ++i) {
            tone_buffer[i] = buffer_of(synthesise(static_cast<Tone>(i)));
            tone[i] = source(tone_buffer[i], true);
            alSourcef(tone[i], AL_GAIN, 0);
            alSourcePlay(tone[i]);
        }
        for (size_t i = 0; i < alarm.size(); ++i) {
            alarm_buffer[i] = buffer_of(synthesise(static_cast<Alarm>(i)));
            alarm[i] = source(alarm_buffer[i], false);
            alSourcef(alarm[i], AL_GAIN, static_cast<ALfloat>(kAlarmLoudness));
        }
        if (alGetError() != AL_NO_ERROR) problem = "the audio device refused the sounds";
        listener();
    }

    void open_loopback() {
        const auto loopback = reinterpret_cast<LPALCLOOPBACKOPENDEVICESOFT>(
            alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
        render = reinterpret_cast<LPALCRENDERSAMPLESSOFT>(
            alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
        if (loopback == nullptr || render == nullptr) {
            problem = "this OpenAL cannot render into memory";
            return;
        }
        device = loopback(nullptr);
        const std::array<ALCint, 7> wanted{ALC_FORMAT_CHANNELS_SOFT,
                                           ALC_MONO_SOFT,
                                           ALC_FORMAT_TYPE_SOFT,
                                           ALC_FLOAT_SOFT,
                                           ALC_FREQUENCY,
                                           kSampleRate,
                                           0};
        if (device != nullptr) context = alcCreateContext(device, wanted.data());
    }

    static ALuint source(ALuint buffer, bool loops) {
        ALuint made = 0;
        alGenSources(1, &made);
        alSourcei(made, AL_BUFFER, static_cast<ALint>(buffer));
        alSourcei(made, AL_LOOPING, loops ? AL_TRUE : AL_FALSE);
        alSourcei(made, AL_SOURCE_RELATIVE, AL_TRUE);
        return made;
    }

    [[nodiscard]] bool usable() const { return context != nullptr && problem.empty(); }

    void listener() const {
        if (!usable()) return;
        const double gain = settings.muted ? 0 : std::clamp(settings.volume, 0.0, 1.0);
        alListenerf(AL_GAIN, static_cast<ALfloat>(gain));
    }

    ~Impl() {
        if (context != nullptr) {
            alDeleteSources(kTones, tone.data());
            alDeleteSources(kAlarms, alarm.data());
            alDeleteBuffers(kTones, tone_buffer.data());
            alDeleteBuffers(kAlarms, alarm_buffer.data());
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context);
        }
        if (device != nullptr) alcCloseDevice(device);
    }
};

Sound::Sound(const SoundSettings& settings, Output output) : impl_(std::make_unique<Impl>()) {
    impl_->settings = settings;
    impl_->open(output);
}
Sound::~Sound() = default;

const std::string& Sound::problem() const { return impl_->problem; }
const SoundSettings& Sound::settings() const { return impl_->settings; }

void Sound::play(const SoundScore::Wish& wish) {
    if (!impl_->usable()) return;
    const std::array<double, kTones> wanted{wish.cut, wish.coag, wish.hiss};
    for (size_t i = 0; i < wanted.size(); ++i)
        alSourcef(impl_->tone[i], AL_GAIN, static_cast<ALfloat>(kLoudness[i] * wanted[i]));
    for (const Alarm alarm : wish.alarms) alSourcePlay(impl_->alarm[static_cast<size_t>(alarm)]);
}

void Sound::silence() {
    if (!impl_->usable()) return;
    for (const ALuint tone : impl_->tone) alSourcef(tone, AL_GAIN, 0);
}

void Sound::set(const SoundSettings& settings) {
    impl_->settings = settings;
    impl_->listener();
}

std::vector<float> Sound::render(int samples) {
    if (impl_->render == nullptr || !impl_->usable()) return {};
    std::vector<float> out(static_cast<size_t>(samples));
    impl_->render(impl_->device, out.data(), samples);
    return out;
}

}  // namespace placode::ui
