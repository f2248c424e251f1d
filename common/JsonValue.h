#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace osgLego
{

struct JsonMember;

/** A JSON value: null, a boolean, a number, a text, an array, or an object whose members keep their order.
 *
 * Sources that include it compile in a fraction of the time that the header of a JSON library takes: only JsonValue.cpp
 * includes one. Reading a value as another type than it has throws std::logic_error. Values are copied; one thread.
 *
 *     JsonValue row{{"mesh", "car"}, {"size", {{"width", 3}, {"height", 4}}}};
 *     row["times"].append(0.5);
 *     std::cout << row.toString(4) << '\n';
 */
class JsonValue
{
public:
    /** Null. */
    JsonValue() = default;
    JsonValue(bool value) : _type(Type::BOOLEAN), _integer(value ? 1 : 0) {}
    template <std::integral Integer>
    requires(!std::same_as<Integer, bool>) JsonValue(Integer value) :
        _type(Type::INTEGER), _integer(static_cast<std::int64_t>(value))
    {
    }
    JsonValue(double value) : _type(Type::NUMBER), _number(value) {}
    JsonValue(std::string value) : _type(Type::TEXT), _text(std::move(value)) {}
    JsonValue(const char* value) : JsonValue(std::string(value)) {}
    /** An object. */
    JsonValue(std::initializer_list<JsonMember> members);

    static JsonValue createObject();
    static JsonValue createArray(std::vector<JsonValue> elements = {});

    /** Read a JSON text. @return empty on an error of syntax. */
    static std::optional<JsonValue> parse(const std::string& text);

    /** @param indent the number of spaces for each level; negative: all on one line.
     * @return UTF-8; bytes of texts that are not, such as those of some names of files, become U+FFFD. */
    std::string toString(int indent = -1) const;

    bool isObject() const { return _type == Type::OBJECT; }
    bool contains(std::string_view name) const { return find(name) != nullptr; }
    /** The member of an object. */
    const JsonValue& operator[](std::string_view name) const;
    /** The member of an object, added if it is missing. Null becomes an object. */
    JsonValue& operator[](std::string_view name);
    /** Add the members of another object, or replace those of the same name. */
    void update(const JsonValue& object);

    /** Add an element to an array. Null becomes an array. */
    void append(JsonValue element);
    /** The elements of an array, or the values of an object. */
    const std::vector<JsonValue>& getElements() const { return _elements; }

    bool toBoolean() const;
    std::int64_t toInteger() const;
    /** The value of a number or an integer. */
    double toNumber() const;
    const std::string& toText() const;

private:
    friend class JsonFormat;

    enum class Type
    {
        NONE,
        BOOLEAN,
        INTEGER,
        NUMBER,
        TEXT,
        ARRAY,
        OBJECT
    };

    const JsonValue* find(std::string_view name) const;
    void require(bool isExpected, const char* expected) const;

    Type _type = Type::NONE;
    std::int64_t _integer = 0;
    double _number = 0.0;
    std::string _text;
    std::vector<std::string> _names; //!< of the elements of an object
    std::vector<JsonValue> _elements;
};

/** A member of a JSON object. */
struct JsonMember
{
    std::string name;
    JsonValue value;
};

} // namespace osgLego
