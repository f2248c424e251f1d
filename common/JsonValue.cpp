#include "JsonValue.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

namespace osgLego
{

/** Writes values, and converts from those of the JSON library. */
class JsonFormat
{
public:
    using Json = nlohmann::ordered_json;

    /** Append a value. The library only writes values without elements: the destructors of its arrays and objects need
     * memory, and end the program where there is none. */
    static void append(const JsonValue& value, int indent, int level, std::string& text)
    {
        const bool isArray = value._type == JsonValue::Type::ARRAY;
        if (!isArray && !value.isObject())
        {
            text += dump(toJson(value));
            return;
        }
        const auto startLine = [&](int newLevel)
        {
            if (indent < 0) return;
            text += '\n';
            text.append(static_cast<std::size_t>(indent * newLevel), ' ');
        };
        text += isArray ? '[' : '{';
        for (std::size_t index = 0; index < value._elements.size(); ++index)
        {
            if (index > 0) text += ',';
            startLine(level + 1);
            if (!isArray) text += dump(value._names[index]) + (indent < 0 ? ":" : ": ");
            append(value._elements[index], indent, level + 1, text);
        }
        if (!value._elements.empty()) startLine(level);
        text += isArray ? ']' : '}';
    }

    static JsonValue fromJson(const Json& json)
    {
        if (json.is_boolean()) return json.get<bool>();
        if (json.is_number_integer()) return json.get<std::int64_t>();
        if (json.is_number()) return json.get<double>();
        if (json.is_string()) return json.get<std::string>();
        JsonValue value;
        if (json.is_array())
        {
            value = JsonValue::createArray();
            for (const Json& element : json)
                value.append(fromJson(element));
        }
        else if (json.is_object())
        {
            value = JsonValue::createObject();
            for (const auto& [name, member] : json.items())
                value[name] = fromJson(member);
        }
        return value;
    }

private:
    /** Names of files may have bytes that are no UTF-8, which no JSON can contain. */
    static std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

    static Json toJson(const JsonValue& value)
    {
        switch (value._type)
        {
        case JsonValue::Type::BOOLEAN:
            return value._integer != 0;
        case JsonValue::Type::INTEGER:
            return value._integer;
        case JsonValue::Type::NUMBER:
            return value._number;
        case JsonValue::Type::TEXT:
            return value._text;
        default:
            return nullptr;
        }
    }
};

JsonValue::JsonValue(std::initializer_list<JsonMember> members) : _type(Type::OBJECT)
{
    for (const JsonMember& member : members)
        (*this)[member.name] = member.value;
}

JsonValue JsonValue::createObject()
{
    JsonValue object;
    object._type = Type::OBJECT;
    return object;
}

JsonValue JsonValue::createArray(std::vector<JsonValue> elements)
{
    JsonValue array;
    array._type = Type::ARRAY;
    array._elements = std::move(elements);
    return array;
}

std::optional<JsonValue> JsonValue::parse(const std::string& text)
{
    const JsonFormat::Json json = JsonFormat::Json::parse(text, nullptr, false);
    if (json.is_discarded()) return std::nullopt;
    return JsonFormat::fromJson(json);
}

std::string JsonValue::toString(int indent) const
{
    std::string text;
    JsonFormat::append(*this, indent, 0, text);
    return text;
}

const JsonValue* JsonValue::find(std::string_view name) const
{
    const auto found = std::find(_names.begin(), _names.end(), name);
    return found == _names.end() ? nullptr : &_elements[static_cast<std::size_t>(found - _names.begin())];
}

const JsonValue& JsonValue::operator[](std::string_view name) const
{
    const JsonValue* value = find(name);
    if (!value) throw std::logic_error("the JSON value has no member '" + std::string(name) + "'");
    return *value;
}

JsonValue& JsonValue::operator[](std::string_view name)
{
    if (_type == Type::NONE) _type = Type::OBJECT;
    require(isObject(), "an object");
    if (const JsonValue* value = find(name)) return const_cast<JsonValue&>(*value);
    _names.emplace_back(name);
    return _elements.emplace_back();
}

void JsonValue::update(const JsonValue& object)
{
    object.require(object.isObject(), "an object");
    for (std::size_t index = 0; index < object._names.size(); ++index)
        (*this)[object._names[index]] = object._elements[index];
}

void JsonValue::append(JsonValue element)
{
    if (_type == Type::NONE) _type = Type::ARRAY;
    require(_type == Type::ARRAY, "an array");
    _elements.push_back(std::move(element));
}

bool JsonValue::toBoolean() const
{
    require(_type == Type::BOOLEAN, "a boolean");
    return _integer != 0;
}

std::int64_t JsonValue::toInteger() const
{
    require(_type == Type::INTEGER, "an integer");
    return _integer;
}

double JsonValue::toNumber() const
{
    if (_type == Type::INTEGER) return static_cast<double>(_integer);
    require(_type == Type::NUMBER, "a number");
    return _number;
}

const std::string& JsonValue::toText() const
{
    require(_type == Type::TEXT, "a text");
    return _text;
}

void JsonValue::require(bool isExpected, const char* expected) const
{
    if (!isExpected) throw std::logic_error("the JSON value is " + toString() + "; expected " + expected);
}

} // namespace osgLego
