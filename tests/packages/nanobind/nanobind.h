// The part of nanobind that packages/pypi uses, for a library that native.py loads with ctypes: a module's
// functions are called by native.cpp, and its attributes become Python's literals.

#include <array>
#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace nanobind {

inline std::string literal(const std::string& text) {
    std::string made = "\"";
    for (const char c : text)
        made += c == '"' ? "\\\"" : std::string(1, c);
    return made + "\"";
}
inline std::string literal(const char* text) {
    return literal(std::string(text));
}
inline std::string literal(bool value) {
    return value ? "True" : "False";
}
template <typename Number>
std::string literal(Number value) requires std::is_arithmetic_v<Number> {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}
template <typename Values>
std::string literal(const Values& values) requires requires {
    values.begin()->operator+(0);
} || std::is_arithmetic_v<typename Values::value_type> {
    std::string made = "[";
    for (const auto& value : values)
        made += literal(value) + ", ";
    return made + "]";
}

struct object {
    std::string text;
};
inline std::string literal(const object& value) {
    return value.text;
}
struct list : object {
    list() { text = "[]"; }
    void append(const object& value) { text.insert(text.size() - 1, value.text + ", "); }
};
struct dict {
    std::map<std::string, object> items;
    object& operator[](const char* name) { return items[name]; }
};
inline std::string literal(const dict& value) {
    std::string made = "{";
    for (const auto& [name, item] : value.items)
        made += literal(name) + ": " + item.text + ", ";
    return made + "}";
}
template <typename... Values>
object make_tuple(const Values&... values) {
    return {"(" + (... + (literal(values) + ", ")) + ")"};
}

struct module_ {
    dict attributes;
    struct Attribute {
        object& of;
        template <typename Value>
        void operator=(const Value& value) {
            of.text = literal(value);
        }
    };
    Attribute attr(const char* name) { return {attributes[name]}; }
    template <typename... Given>
    void def(const Given&...) {}
};
struct arg {
    arg noconvert() const { return {}; }
};
struct gil_scoped_release {}; // ctypes releases it

struct c_contig;
namespace device {
struct cpu;
}
template <int>
struct ndim;
template <typename T, typename...>
struct ndarray {
    T* values;
    std::vector<std::size_t> sides;
    std::vector<std::int64_t> strides;
    T* data() const { return values; }
    std::size_t ndim() const { return sides.size(); }
    std::size_t shape(std::size_t axis) const { return sides[axis]; }
    std::int64_t stride(std::size_t axis) const { return strides[axis]; }
    std::size_t size() const {
        std::size_t made = 1;
        for (const std::size_t side : sides)
            made *= side;
        return made;
    }
};

} // namespace nanobind

#define NB_MODULE(name, variable) static void name(nanobind::module_& variable)
