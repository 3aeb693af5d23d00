// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/words.h"

#include <algorithm>
#include <climits>
#include <stdexcept>

namespace placode::web {
namespace {

bool polish_is_spoken() { return reports::spoken().language() == QLocale::Polish; }

/// A translation file of this program, read once.
class Strings {
 public:
    explicit Strings(const char* file) {
        if (!translator_.load(QString::fromLatin1(file)))
            throw std::runtime_error("this program was built without its words");
    }
    /// A null text where it has none. Any thread: nothing of it changes.
    [[nodiscard]] QString operator()(const char* english, int number) const {
        return translator_.translate("Web", english, nullptr, number);
    }

 private:
    QTranslator translator_;
};

/// In the reader's language. English is the source's, but for the forms of counted nouns.
/// @param number -1: no noun is counted.
std::string in_language(const char* english, int number) {
    static const Strings polish(":/i18n/placode_pl.qm"), counted(":/i18n/placode_en.qm");
    const QString found = polish_is_spoken() ? polish(english, number)
                          : number >= 0      ? counted(english, number)
                                             : QString();
    if (!found.isNull()) return found.toStdString();
    const std::string_view all = english;
    return std::string(all.substr(0, all.find('@')));
}

std::string_view trimmed(std::string_view words) {
    const size_t begin = words.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return words.substr(begin, words.find_last_not_of(" \t") + 1 - begin);
}

/// "0.8" in thousandths; without a q a language is liked fully, with a wrong one not at all.
int liking(std::string_view parameters) {
    const size_t at = parameters.find("q=");
    if (at == std::string_view::npos) return 1000;
    const std::string_view digits = trimmed(parameters.substr(at + 2));
    if (digits.empty() || (digits[0] != '0' && digits[0] != '1')) return 0;
    int thousandths = 1000 * (digits[0] - '0'), place = 100;
    for (size_t i = 2; i < digits.size() && place > 0; ++i, place /= 10) {
        if (digits[i] < '0' || digits[i] > '9') break;
        thousandths += place * (digits[i] - '0');
    }
    return std::min(1000, thousandths);
}

}  // namespace

std::string spoken_code() { return polish_is_spoken() ? "pl" : "en"; }

QLocale locale_of(std::string_view code) {
    return code == "pl" ? QLocale(QLocale::Polish, QLocale::Poland)
                        : QLocale(QLocale::English, QLocale::UnitedKingdom);
}

std::string_view liked_language(const std::string& accept_language) {
    std::string_view best = kLanguages[0];
    int most = 0;
    const std::string_view all = accept_language;
    for (size_t begin = 0; begin < all.size();) {
        const size_t end = std::min(all.find(',', begin), all.size());
        const std::string_view one = all.substr(begin, end - begin);
        const size_t semicolon = std::min(one.find(';'), one.size());
        // "pl-PL" is Polish as well, and "*" is any: then the first one of ours.
        std::string name(trimmed(one.substr(0, semicolon)));
        name = name.substr(0, name.find('-'));
        std::transform(name.begin(), name.end(), name.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        if (name == "*") name = kLanguages[0];
        const int liked = liking(one.substr(semicolon));
        const auto* ours = std::find(std::begin(kLanguages), std::end(kLanguages), name);
        if (ours != std::end(kLanguages) && liked > most) {
            best = *ours;
            most = liked;
        }
        begin = end + 1;
    }
    return best;
}

std::string Web::plain_phrase(Phrase english, const std::vector<std::string>& parts) {
    return inside::filled(inside::translated(english.english), parts);
}

const std::string& in_words(const curriculum::LocalText& text) { return text.in(spoken_code()); }

Text number_text(const QString& number) { return text(reports::with_spoken_sign(number)); }

ReportsInPolish::ReportsInPolish() {
    if (!load(QStringLiteral(":/i18n/placode_pl.qm")))
        throw std::runtime_error("this program was built without its Polish words");
}

QString ReportsInPolish::translate(const char* context, const char* english, const char* remark,
                                   int number) const {
    if (!polish_is_spoken()) return {};
    return QTranslator::translate(context, english, remark, number);
}

namespace inside {

std::string translated(const char* english) { return in_language(english, -1); }

std::string counted(const char* english, int64_t number) {
    std::string text =
        in_language(english, static_cast<int>(std::clamp<int64_t>(number, 0, INT_MAX)));
    const size_t at = text.find("%n");
    return at == std::string::npos ? text : text.replace(at, 2, std::to_string(number));
}

std::string filled(const std::string& pattern, const std::vector<std::string>& parts) {
    std::string out;
    for (size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = i + 1 < pattern.size() && pattern[i] == '%' && pattern[i + 1] > '0';
        const size_t place = is_place ? static_cast<size_t>(pattern[i + 1] - '1') : parts.size();
        if (place < parts.size())
            out += parts[place], ++i;
        else
            out += pattern[i];
    }
    return out;
}

}  // namespace inside
}  // namespace placode::web
