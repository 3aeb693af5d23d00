// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A schema validator says "no"; a person who edits a task wants to know what to write instead.
// So an own walk over the same schema explains the usual mistakes first, and valijson, which knows
// all of draft-7, has the last word.

// g++ 12 sees an overlap in std::string operations inside valijson that is not there (GCC 105651).
#pragma GCC diagnostic ignored "-Wrestrict"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <regex>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "curriculum/json_reader.h"
#include "sim/core/near_word.h"
#include "sim/core/number_text.h"

namespace placode::curriculum {

namespace {

/// What was found, short enough for a message.
std::string found_text(const Json& value) {
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

std::string escape_pointer(const std::string& key) {
    std::string escaped;
    for (const char c : key) {
        if (c == '~')
            escaped.append("~0");
        else if (c == '/')
            escaped.append("~1");
        else
            escaped.push_back(c);
    }
    return escaped;
}

constexpr size_t kLongestName = 300;  // of what has a pattern: ids, names of files, keys

/// A handful of patterns stand in our schemas, and one takes longer to compile than a definition to
/// be read. Each thread keeps its own.
const std::regex& compiled(const std::string& pattern) {
    thread_local std::map<std::string, std::regex> all;
    const auto found = all.find(pattern);
    return found != all.end() ? found->second
                              : all.emplace(pattern, std::regex(pattern)).first->second;
}

/// What a pattern of the schemas asks for, after "a text".
std::string pattern_words(const std::string& pattern) {
    if (pattern == "^[A-Za-z0-9_.-]+$") return " of letters, digits, _, . and - only";
    return " that fits " + pattern;
}

/// Of an unknown key; our longest has 40 letters.
constexpr size_t kMostShown = 80;

size_t shared_prefix(const std::string& a, const std::string& b) {
    size_t n = 0;
    while (n < a.size() && n < b.size() && a[n] == b[n]) ++n;
    return n;
}

/// Walks value and schema together; throws at the first mistake it can explain.
class Explainer {
 public:
    Explainer(const Json& root, std::string origin, Completeness completeness)
        : root_(root), origin_(std::move(origin)), completeness_(completeness) {}

    void check(const Json& value, const Json& schema_in, const std::string& pointer) const {
        const Json& schema = resolve(schema_in);
        if (completeness_ == Completeness::kPartial && value.is_null()) return;
        if (schema.contains("anyOf")) return;  // left to valijson
        if (schema.contains("type")) check_type(value, schema, pointer);
        if (schema.contains("enum")) check_choice(value, schema, pointer);
        if (value.is_number()) check_range(value, schema, pointer);
        if (value.is_string() && schema.contains("minLength") &&
            value.get_ref<const std::string&>().size() < schema["minLength"].get<size_t>())
            fail(pointer, "is empty", schema);
        if (value.is_string() && schema.contains("pattern")) check_pattern(value, schema, pointer);
        if (value.is_object()) check_object(value, schema, pointer);
        if (value.is_array()) check_array(value, schema, pointer);
    }

 private:
    const Json& resolve(const Json& schema) const {
        if (!schema.contains("$ref")) return schema;
        const std::string reference = schema["$ref"];
        return root_.at(Json::json_pointer(reference.substr(1)));
    }

    /// "a number in Pa from 10 to 1e+07"
    std::string expected(const Json& schema_in) const {
        const Json& schema = resolve(schema_in);
        if (schema.contains("enum")) {
            std::string list;
            for (const Json& choice : schema["enum"])
                list += (list.empty() ? "one of " : ", ") + choice.dump();
            return list;
        }
        const std::string type = schema.value("type", std::string("value"));
        std::string text;
        if (type == "number")
            text = "a number";
        else if (type == "integer")
            text = "a whole number";
        else if (type == "boolean")
            text = "true or false";
        else if (type == "string")
            text = "a text";
        else if (type == "array")
            text = "a list";
        else if (type == "object")
            text = "an object";
        else
            text.append("a ").append(type);
        if (schema.contains("pattern")) text += pattern_words(schema["pattern"]);
        if (schema.contains("unit")) text += " in " + schema["unit"].get<std::string>();
        const bool open_low = schema.contains("exclusiveMinimum");
        if (open_low) text += " above " + sim::shortest_text(schema["exclusiveMinimum"]);
        if (schema.contains("minimum")) text += " from " + sim::shortest_text(schema["minimum"]);
        if (schema.contains("maximum")) text += " to " + sim::shortest_text(schema["maximum"]);
        if (type == "array" && schema.contains("items")) {
            if (schema.contains("minItems") && schema.value("maxItems", 0) == schema["minItems"])
                text += " of " + std::to_string(schema["minItems"].get<int>());
            text += ", each " + expected(schema["items"]);
        }
        return text;
    }

    [[noreturn]] void fail(const std::string& pointer, const std::string& problem,
                           const Json& schema) const {
        throw DefinitionError(origin_, pointer.empty() ? "/" : pointer,
                              problem + "; expected " + expected(schema));
    }

    void check_type(const Json& value, const Json& schema, const std::string& pointer) const {
        const std::string type = schema["type"];
        const bool whole = value.is_number_integer() ||
                           (value.is_number() && std::floor(value.get<double>()) == value);
        const bool fits =
            (type == "number" && value.is_number()) || (type == "integer" && whole) ||
            (type == "boolean" && value.is_boolean()) || (type == "string" && value.is_string()) ||
            (type == "array" && value.is_array()) || (type == "object" && value.is_object());
        if (!fits) fail(pointer, "found " + found_text(value), schema);
    }

    void check_choice(const Json& value, const Json& schema, const std::string& pointer) const {
        const Json& choices = schema["enum"];
        if (std::find(choices.begin(), choices.end(), value) == choices.end())
            fail(pointer, "found " + found_text(value), schema);
    }

    void check_pattern(const Json& value, const Json& schema, const std::string& pointer) const {
        const auto& text = value.get_ref<const std::string&>();
        // Also because std::regex goes one call deeper with every letter.
        if (text.size() > kLongestName)
            fail(pointer, "has " + std::to_string(text.size()) + " letters", schema);
        if (!std::regex_search(text, compiled(schema["pattern"].get_ref<const std::string&>())))
            fail(pointer, "found " + found_text(value), schema);
    }

    void check_range(const Json& value, const Json& schema, const std::string& pointer) const {
        const double number = value.get<double>();
        const bool low = (schema.contains("minimum") && number < schema["minimum"].get<double>()) ||
                         (schema.contains("exclusiveMinimum") &&
                          number <= schema["exclusiveMinimum"].get<double>());
        const bool high = schema.contains("maximum") && number > schema["maximum"].get<double>();
        if (low || high)
            fail(pointer, sim::shortest_text(number) + (low ? " is too small" : " is too large"),
                 schema);
    }

    void check_object(const Json& value, const Json& schema, const std::string& pointer) const {
        if (!schema.contains("properties")) return;
        const Json& properties = schema["properties"];
        for (const auto& [key, child] : value.items()) {
            if (properties.contains(key)) {
                check(child, properties[key], pointer + "/" + escape_pointer(key));
            } else if (schema.contains("additionalProperties") &&
                       schema["additionalProperties"] == false) {
                unknown_key(key, value, properties, pointer);
            }
        }
        if (completeness_ == Completeness::kPartial || !schema.contains("required")) return;
        for (const Json& required : schema["required"]) {
            const std::string key = required;
            if (value.contains(key)) continue;
            throw DefinitionError(
                origin_, pointer.empty() ? "/" : pointer,
                "key \"" + key + "\" is missing; expected " + expected(properties[key]));
        }
    }

    /// The nearest known key that is not already used: most leading letters in common, then the
    /// fewest edits. A wrong unit suffix shares all of the stem.
    [[noreturn]] void unknown_key(const std::string& key, const Json& value, const Json& properties,
                                  const std::string& pointer) const {
        std::string best, all;
        size_t best_prefix = 0, best_distance = SIZE_MAX;
        // No key is near to one that is longer than every one, and the distance costs their
        // product.
        const std::string word = key.substr(0, kMostShown);
        for (const auto& [name, unused] : properties.items()) {
            all += (all.empty() ? "" : ", ") + name;
            if (value.contains(name)) continue;
            const size_t prefix = shared_prefix(word, name),
                         distance = sim::edit_distance(word, name);
            if (prefix < best_prefix || (prefix == best_prefix && distance >= best_distance))
                continue;
            best = name;
            best_prefix = prefix;
            best_distance = distance;
        }
        const bool near = !best.empty() && (best_prefix >= 5 ||
                                            best_distance <= std::max<size_t>(2, word.size() / 3));
        throw DefinitionError(origin_, pointer.empty() ? "/" : pointer,
                              "unknown key \"" + word + (word.size() < key.size() ? "..." : "") +
                                  "\"; expected " +
                                  (near ? "\"" + best + "\" (" + expected(properties[best]) + ")"
                                        : "one of: " + all));
    }

    void check_array(const Json& value, const Json& schema, const std::string& pointer) const {
        const size_t n = value.size();
        if (n < schema.value("minItems", size_t{0}) || n > schema.value("maxItems", SIZE_MAX))
            fail(pointer, "found a list of " + std::to_string(n), schema);
        if (!schema.contains("items")) return;
        for (size_t i = 0; i < n; ++i)
            check(value[i], schema["items"], pointer + "/" + std::to_string(i));
    }

    const Json& root_;
    std::string origin_;
    Completeness completeness_;
};

/// valijson contexts ("<root>", "[scene]", "[0]") to a JSON pointer.
std::string pointer_of(const std::vector<std::string>& context) {
    std::string pointer;
    for (const std::string& part : context) {
        if (part.size() > 2 && part.front() == '[' && part.back() == ']')
            pointer += "/" + part.substr(1, part.size() - 2);
    }
    return pointer;
}

/// A schema file and what it says.
struct KnownSchema {
    std::string text;
    Json json;
    std::unique_ptr<valijson::Schema> schema;
    std::unique_ptr<valijson::Validator> validator;  ///< Keeps the patterns that it has compiled.
};

/// valijson's adapter is written for the library's sorted JSON type.
KnownSchema parse_schema(std::string text, const std::string& file) {
    KnownSchema known{std::move(text),
                      {},
                      std::make_unique<valijson::Schema>(),
                      std::make_unique<valijson::Validator>()};
    known.json = parse_json(known.text, file);
    const nlohmann::json sorted = nlohmann::json::parse(known.json.dump());
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(sorted), *known.schema);
    return known;
}

/// Parsing a schema takes longer than checking a definition with it. Each thread keeps its own, so
/// that none waits; a file that was changed is parsed again.
const KnownSchema& known_schema(const std::string& name) {
    thread_local std::map<std::string, KnownSchema> all;
    const std::filesystem::path file = data_folder() / "schemas" / (name + ".schema.json");
    std::string text = read_definition(file);
    const auto found = all.find(file.string());
    if (found != all.end() && found->second.text == text) return found->second;
    return all.insert_or_assign(file.string(), parse_schema(std::move(text), file.string()))
        .first->second;
}

/// The last word.
void validate(const nlohmann::json& value, const KnownSchema& known, const std::string& origin,
              const std::string& prefix) {
    valijson::ValidationResults results;
    const valijson::adapters::NlohmannJsonAdapter target(value);
    if (known.validator->validate(*known.schema, target, &results)) return;
    // The deepest error is the most telling one.
    valijson::ValidationResults::Error error, deepest;
    while (results.popError(error)) {
        if (error.context.size() >= deepest.context.size()) deepest = error;
    }
    throw DefinitionError(origin, prefix + pointer_of(deepest.context), deepest.description);
}

}  // namespace

void check_schema(const Json& value, const std::string& schema_name, const std::string& origin,
                  const std::string& prefix, Completeness completeness) {
    const KnownSchema& known = known_schema(schema_name);
    Explainer(known.json, origin, completeness).check(value, known.json, prefix);
    if (completeness == Completeness::kWhole)
        validate(nlohmann::json::parse(value.dump()), known, origin, prefix);
}

}  // namespace placode::curriculum
