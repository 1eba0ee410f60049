"""Reads the part of GLSL that the drop-ins use, into a syntax tree with types, and edits its text. tools/translate and tools/nodes.py
print other languages from it. Raises Refused for everything else."""

import re
from typing import NamedTuple

TOKEN = re.compile(r"""(?P<space>(?:\s|\\\n)+) | (?P<comment>//[^\n]*|/\*.*?\*/) | (?P<directive>\#(?:\\\n|(?!//|/\*)[^\n])*)
                       | (?P<number>0[xX][\da-fA-F]+[uU]?|(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][-+]?\d+)?[fF]?|\d+[uUif]?)
                       | (?P<name>[A-Za-z_]\w*) | (?P<sign><<=|>>=|&&|\|\||\^\^|<<|>>|->|[-+*/%&|^=<>!]=|\+\+|--|[^\w\s])""",
                   re.VERBOSE | re.DOTALL)
# Each type of a number or vector, with the type of its components and their number.
SHAPES = {"float": ("float", 1), "int": ("int", 1), "uint": ("uint", 1), "bool": ("bool", 1)} | {
    f"{letter}vec{count}": (kind, count) for letter, kind in {"": "float", "i": "int", "u": "uint", "b": "bool"}.items() for count in (2, 3, 4)}
VECTORS = {shape: name for name, shape in SHAPES.items()}
SIGNS = ["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", ">", "<=", ">="], ["<<", ">>"], ["+", "-"], ["*", "/", "%"]
PRECEDENCE = {sign: level for level, signs in enumerate(SIGNS, 1) for sign in signs}
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
# GLSL's functions that have a translation, and the components of their results: those of the widest argument if None. The result is a
# vector unless its size is 1.
COMPARISONS = {"lessThan": "<", "lessThanEqual": "<=", "greaterThan": ">", "greaterThanEqual": ">=", "equal": "==", "notEqual": "!="}
FUNCTIONS = dict.fromkeys("abs acos asin atan ceil clamp cos cross dFdx dFdy exp exp2 floor fract inversesqrt log log2 max min mix "
                          "normalize pow sign sin smoothstep sqrt step tan".split()) | {
    "dot": "float", "length": "float", "distance": "float", "all": "bool", "any": "bool", "uintBitsToFloat": "float",
    "intBitsToFloat": "float", "floatBitsToUint": "uint", "floatBitsToInt": "int"} | dict.fromkeys(COMPARISONS, "bool")
NUMBERS = {"float", "int", "uint", "bool"}
SINGLE = {"dot", "length", "distance", "all", "any"}  # their results are numbers


class Refused(Exception):
    """A text that has no translation."""

    def __init__(self, path, line, reason):
        super().__init__(f"{path}:{line}: {reason}")


class Token(NamedTuple):
    kind: str
    text: str
    start: int
    end: int
    line: int


class Node:
    """A part of the syntax tree: its kind, its place in the text, its parts and, for expressions and variables, its type."""

    def __init__(self, kind, first, last, parts=(), type=None, **more):
        self.kind, self.start, self.end, self.line, self.type = kind, first.start, last.end, first.line, type
        self.parts = [part for part in parts if part]
        self.__dict__.update(more)

    def walk(self):
        """Yields all nodes below this one, and then this one."""
        for part in self.parts:
            yield from part.walk()
        yield self


def tokens(text, start=0, end=None, line=1):
    """Yields the tokens of a text, without white space."""
    while match := TOKEN.match(text, start, len(text) if end is None else end):
        if match.lastgroup != "space":
            yield Token(match.lastgroup, match[0].rstrip() if match.lastgroup == "directive" else match[0], start, match.end(), line)
        line += match[0].count("\n")
        start = match.end()


def without_comments(text):
    """Returns the text without comments and the spaces before them."""
    result, place = "", 0
    for token in tokens(text):
        if token.kind == "comment":
            result, place = (result + text[place:token.start]).rstrip(" "), token.end
    return result + text[place:]


def root(node):
    """Returns the variable that an expression reads or changes a part of."""
    while node.kind in ("member", "index", "group"):
        node = node.parts[0]
    return node


def element(type):
    """Returns the type of a vector's component or an array's element, or None."""
    return type[:-2] if type and type.endswith("[]") else SHAPES[type][0] if type in SHAPES and SHAPES[type][1] > 1 else None


def changes(body):
    """Returns the declarations of all variables that a function's body changes."""
    found = set()
    for node in body.walk():
        if node.kind in ("assign", "step"):
            found.add(root(node.parts[0]).declared)
        if node.kind == "call" and node.what == "function":
            found |= {root(part).declared for part, given in zip(node.parts, node.callee.parameters) if given.how in ("out", "inout")}
    return found


class Shader:
    """The syntax tree of a drop-in. `before` are the shaders that come before it, whose names it uses.

    Directives and comments may stand between any two tokens. All branches of a condition are read, one after the other."""

    def __init__(self, text, path, before=()):
        self.text, self.path, self.before, self.place = text, path, before, 0
        self.structs, self.functions, self.macros, self.scopes = {}, {}, {}, [{}]
        for other in before:
            self.structs |= other.structs
            self.functions |= {name: self.functions.get(name, []) + found for name, found in other.functions.items()}
            self.macros |= other.macros
            self.scopes[0] |= other.scopes[0]
        found = list(tokens(text))
        self.comments = [token for token in found if token.kind == "comment"]
        self.directives = [token for token in found if token.kind == "directive"]
        self.tested = {token.text.split()[1] for token in self.directives if token.text.startswith(("#ifdef ", "#ifndef "))}
        self.defined = [self.macro(token) for token in self.directives if token.text.split()[0] == "#define"]
        empty = {macro.name.text for macro in self.macros.values() if not macro.body and macro.given is None}
        self.tokens = [token for token in found if token.kind not in ("comment", "directive") and token.text not in empty]
        self.tokens.append(Token("end", "the end", len(text), len(text), text.count("\n") + 1))
        self.items = []
        while self.token.kind != "end":
            self.items += self.definition()
        for macro in self.defined:
            if macro.body:
                macro.parts = [self.expanded(macro, {})]

    # ---- Tokens ----

    @property
    def token(self):
        return self.tokens[self.place]

    def refuse(self, reason, where=None):
        raise Refused(self.path, (where or self.token).line, reason)

    def conditions(self, node):
        """Returns the directives of the conditions around a node: for each, the last of #if, #elif and #else before it."""
        found = []
        for directive in self.directives:
            word = directive.text.split()[0]
            if directive.start > node.start or word in ("#else", "#elif", "#endif"):
                found = found if directive.start > node.start else found[:-1]
            if directive.start < node.start and word in ("#if", "#ifdef", "#ifndef", "#elif", "#else"):
                found.append(directive)
        return found

    def comment_start(self, place):
        """Returns where the comment directly above a place starts, or the place itself."""
        while (line := self.text.rfind("\n", 0, max(place - 1, 0)) + 1) < place and self.text.startswith("//", line):
            place = line
        return place

    def member_types(self, type):
        """Returns a type and, if it is a struct, those of its members."""
        fields = self.structs[type].fields.values() if type in self.structs else ()
        return [type, *(found for field in fields for found in self.member_types(field))]

    def at(self, *texts):
        return self.token.text in texts

    def take(self, *texts, kind=None):
        """Returns the next token, which must be one of these texts or of this kind."""
        token = self.token
        if texts and token.text not in texts or kind and token.kind != kind:
            self.refuse(f"'{token.text}' has no translation here, where {' or '.join(texts) or 'a ' + kind} is expected")
        self.place += 1
        return token

    def maybe(self, text):
        return self.take() if self.at(text) else None

    # ---- Macros ----

    def macro(self, directive):
        """Reads a #define, but not yet its body."""
        _, name, *rest = tokens(self.text, directive.start + 1, directive.start + len(directive.text), directive.line)
        given = None
        if rest and rest[0].text == "(" and rest[0].start == name.end:
            end = next(place for place, token in enumerate(rest) if token.text == ")")
            given, rest = [token.text for token in rest[1:end] if token.kind == "name"], rest[end + 1:]
        self.macros[name.text] = macro = Node("macro", name, rest[-1] if rest else name, name=name, given=given, body=rest)
        return macro

    def expanded(self, macro, types):
        """Returns the syntax tree of a macro's body, in which its parameters have these types."""
        kept = self.tokens, self.place, self.scopes
        last = macro.body[-1]
        self.tokens = [*macro.body, Token("end", "the end of the macro", last.end, last.end, last.line)]
        self.place, self.scopes = 0, [self.scopes[0], {name: Node("parameter", last, last, type=types.get(name)) for name in macro.given or []}]
        tree = self.expression()
        self.take(kind="end")
        self.tokens, self.place, self.scopes = kept
        return tree

    # ---- Definitions ----

    def declare(self, name, node):
        known = self.scopes[-1].setdefault(name.text, node)
        if known.type != node.type:
            self.refuse(f"a second declaration of {name.text} with another type has no translation", name)

    def type_name(self):
        if self.token.text not in SHAPES and self.token.text not in self.structs and self.token.text != "void":
            self.refuse(f"'{self.token.text}' has no translation")
        return self.take()

    def variable(self, kind, type, **more):
        """Reads a name and the length of an array after its type."""
        name = last = self.take(kind="name")
        first, length = more.pop("first", name), None
        if self.maybe("["):
            length, last = self.expression(), self.take("]")
        return Node(kind, first, last, [length], type.text + "[]" * bool(length), name=name, **more)

    def variables(self, kind, constant=None):
        """Reads a declaration of one or more variables, with a semicolon."""
        type, found = self.type_name(), []
        while True:
            node = self.variable(kind, type, value=None)
            if kind != "field" and self.maybe("="):
                node.value = self.matched(self.expression(), node.type)
                node.parts.append(node.value)
                node.end = node.value.end
            if kind != "field":
                self.declare(node.name, node)
            found.append(node)
            if self.take(",", ";").text == ";":
                return Node("declare", constant or type, self.tokens[self.place - 1], found, constant=constant, type_name=type)

    def definition(self):
        """Reads a struct, function, constant or precision statement."""
        first = self.token
        if self.maybe(";"):
            return []
        if self.maybe("precision"):
            return [Node("precision", first, [self.take(kind="name"), self.take(kind="name"), self.take(";")][2])]
        if self.maybe("struct"):
            name, fields = self.take(kind="name"), []
            self.take("{")
            while not self.at("}"):
                fields.append(self.variables("field"))
            self.take("}")
            if name.text in self.structs:
                self.refuse(f"a second struct {name.text} has no translation", name)
            self.structs[name.text] = node = Node("struct", first, self.take(";"), fields, name=name, constructed=False)
            node.fields = {field.name.text: field.type for declared in fields for field in declared.parts}
            return [node]
        if constant := self.maybe("const"):
            return [self.variables("variable", constant)]
        type, name = self.type_name(), self.take(kind="name")
        if not self.at("("):
            self.refuse("a global variable that is not const has no translation", first)
        return [self.function(type, name)]

    def function(self, type, name):
        opening, parameters = self.take("("), []
        self.scopes.append({})
        while not self.at(")"):
            first, how = self.token, set()
            while self.at("const", "in", "out", "inout"):
                how.add(self.take().text)
            type_name = self.type_name()
            node = self.variable("parameter", type_name, first=first, how=next(iter(how & {"out", "inout"}), "in"), type_name=type_name)
            self.declare(node.name, node)
            parameters.append(node)
            if not self.at(")"):
                self.take(",")
        closing = self.take(")")
        node = Node("function", type, closing, parameters, type.text, name=name, opening=opening, closing=closing, parameters=parameters, body=None)
        for part in parameters:
            part.function = node
        known = self.functions.setdefault(name.text, [])
        self.functions[name.text] = [*known, node]
        if same := [other for other in known if [part.type for part in other.parameters] == [part.type for part in parameters]]:
            if same[-1].body and not self.at(";") and same[-1].path_of_text is self.text:
                self.refuse(f"a second definition of {name.text} has no translation", name)
            self.functions[name.text] = [other for other in known if other not in same] + [node]
        node.path_of_text, self.result = self.text, type.text
        if not self.at(";"):
            node.body = self.statement()
            node.parts.append(node.body)
            node.end = node.body.end
        else:
            node.end = self.take().end
        self.scopes.pop()
        return node

    # ---- Statements ----

    def statement(self):
        first, text = self.token, self.token.text
        if text == "{":
            self.take()
            self.scopes.append({})
            parts = []
            while not self.at("}"):
                parts.append(self.statement())
            self.scopes.pop()
            return Node("block", first, self.take("}"), parts)
        if text in ("if", "while"):
            self.take()
            parts = [self.condition(), self.statement()]
            if text == "if" and self.maybe("else"):
                parts.append(self.statement())
            return Node("branch" if text == "if" else "while", first, parts[-1], parts)
        if text == "do":
            self.take()
            parts = [self.statement()]
            self.take("while")
            parts.append(self.condition())
            return Node("do", first, self.take(";"), parts)
        if text == "for":
            self.take()
            self.take("(")
            self.scopes.append({})
            parts = [self.statement(), None if self.at(";") else self.matched(self.expression(), "bool")]
            self.take(";")
            parts += [*([] if self.at(")") else self.sequence()), self.take(")") and self.statement()]
            self.scopes.pop()
            return Node("for", first, parts[-1], parts)
        if text in ("break", "continue"):
            return Node("jump", self.take(), self.take(";"))
        if text == "return":
            self.take()
            value = None if self.at(";") else self.matched(self.expression(), self.result)
            return Node("return", first, self.take(";"), [value])
        if text == "const" or (text in SHAPES or text in self.structs) and self.tokens[self.place + 1].kind == "name":
            return self.variables("variable", self.maybe("const"))
        parts = [] if text == ";" else self.sequence()
        return Node("expression", first, self.take(";"), parts)

    def condition(self):
        self.take("(")
        node = self.matched(self.expression(), "bool")
        self.take(")")
        return node

    def sequence(self):
        parts = [self.expression()]
        while self.maybe(","):
            parts.append(self.expression())
        return parts

    # ---- Expressions ----

    def matched(self, node, type):
        """Returns the expression if it has this type. GLSL ES, Godot and WGSL convert nothing."""
        if None not in (node.type, type) and node.type != type:
            self.refuse(f"a conversion from {node.type} to {type} has no translation", node)
        return node

    def operated(self, left, sign, right):
        """Returns the type of a binary operation."""
        types = left.type, right.type
        if sign.text in ("&&", "||"):
            self.matched(left, "bool"), self.matched(right, "bool")
        if sign.text in ("==", "!="):
            if {*types} & {*self.structs} or "[]" in "".join(filter(None, types)):
                self.refuse(f"{sign.text} of structs or arrays has no translation", sign)
            self.matched(left, right.type)
        if PRECEDENCE[sign.text] in (1, 2, 6, 7):
            return "bool"
        if None in types:
            return None
        (kind, size), (other, count) = (SHAPES.get(type, (type, 0)) for type in types)
        if not size or not count or kind != other and sign.text not in ("<<", ">>") or size != count and 1 not in (size, count):
            self.refuse(f"{types[0]} {sign.text} {types[1]} has no translation", sign)
        return VECTORS[kind, max(size, count)]

    def expression(self):
        left = self.choice()
        if self.token.text not in ASSIGNMENTS:
            return left
        sign, right = self.take(), self.expression()
        self.change(left)
        if sign.text == "=":
            self.matched(right, left.type)
        elif (type := self.operated(left, Token("sign", sign.text[:-1], *sign[2:]), right)) != left.type and type:
            self.refuse(f"{left.type} {sign.text} {right.type} has no translation", sign)
        return Node("assign", left, right, [left, right], left.type, sign=sign)

    def change(self, node):
        """Checks that the expression is a variable or a part of one, and notes that it changes."""
        if root(node).kind != "name" or node.kind in ("member", "index") and getattr(node.parts[0], "swizzle", False):
            self.refuse(f"a change of '{self.text[node.start:node.end]}' has no translation", node)
        node.changed = True

    def choice(self):
        test = self.binary(1)
        if not self.maybe("?"):
            return test
        self.matched(test, "bool")
        yes = self.expression()
        self.take(":")
        no = self.matched(self.expression(), yes.type)
        return Node("choice", test, no, [test, yes, no], yes.type or no.type)

    def binary(self, level):
        left = self.unary()
        while PRECEDENCE.get(self.token.text, 0) >= level:
            sign = self.take()
            right = self.binary(PRECEDENCE[sign.text] + 1)
            left = Node("binary", left, right, [left, right], self.operated(left, sign, right), sign=sign)
        return left

    def step(self, first, last, part, sign):
        self.change(part)
        if part.type not in ("int", "uint"):
            self.refuse(f"{sign.text} of a {part.type} has no translation", sign)
        return Node("step", first, last, [part], part.type, sign=sign)

    def unary(self):
        if self.at("-", "+", "!", "~"):
            sign, part = self.take(), self.unary()
            return Node("unary", sign, part, [part], part.type, sign=sign)
        if self.at("++", "--"):
            sign, part = self.take(), self.unary()
            return self.step(sign, part, part, sign)
        node = self.primary()
        while self.at(".", "[", "++", "--"):
            sign = self.take()
            if sign.text == ".":
                name = self.take(kind="name")
                node = Node("member", node, name, [node], self.member(node.type, name), name=name, changed=False,
                            swizzle=node.type in SHAPES or node.type is None and not set(name.text) - set("xyzw"))
            elif sign.text == "[":
                index = self.expression()
                if node.type and not element(node.type):
                    self.refuse(f"an index into a {node.type} has no translation", sign)
                node = Node("index", node, self.take("]"), [node, index], element(node.type))
            else:
                node = self.step(node, sign, node, sign)
        return node

    def member(self, type, name):
        """Returns the type of a struct's member or of a swizzle."""
        if type in self.structs and name.text in self.structs[type].fields:
            return self.structs[type].fields[name.text]
        kind, size = SHAPES.get(type, (None, 4))
        if type in self.structs or type and not kind or size == 1 or set(name.text) - set("xyzw"[:size]) or len(name.text) > 4:
            self.refuse(f".{name.text} of a {type} has no translation", name)
        return VECTORS[kind, len(name.text)] if kind else None

    def primary(self):
        token = self.take()
        if token.kind == "number":
            whole = token.text[:2] in ("0x", "0X") or not set(token.text) & set(".eEfF")
            return Node("number", token, token, type="uint" if token.text[-1] in "uU" else "int" if whole else "float", name=token)
        if token.text == "(":
            part = self.expression()
            return Node("group", token, self.take(")"), [part], part.type)
        if token.text in ("true", "false"):
            return Node("name", token, token, type="bool", name=token, declared=None)
        if token.kind != "name":
            self.refuse(f"'{token.text}' has no translation here", token)
        if self.at("("):
            return self.call(token)
        declared = next((scope[token.text] for scope in reversed(self.scopes) if token.text in scope), None)
        if declared:
            return Node("name", token, token, type=declared.type, name=token, declared=declared)
        if token.text in self.macros and self.macros[token.text].given is None:
            return Node("macro_name", token, token, type=self.expanded(self.macros[token.text], {}).type, name=token)
        self.refuse(f"an array constructor has no translation" if self.at("[") else f"'{token.text}' is not declared, so it has no translation", token)

    def call(self, name):
        self.take("(")
        opening, parts, commas = self.tokens[self.place - 1], [], []
        while not self.at(")"):
            parts.append(self.expression())
            if not self.at(")"):
                commas.append(self.take(","))
        closing = self.take(")")
        what, callee, type = self.called(name, parts)
        return Node("call", name, closing, parts, type, name=name, opening=opening, commas=commas, closing=closing, what=what, callee=callee)

    def called(self, name, parts):
        """Returns what a call is, the function if it is in the text, and its type."""
        types = [part.type for part in parts]
        shapes = [SHAPES.get(type, (None, 1)) for type in types]
        if name.text in SHAPES:
            kind, size = SHAPES[name.text]
            counts = [count for _, count in shapes]
            if set(types) - set(SHAPES) - {None} or not parts or None not in types and counts not in ([1], [size]) and sum(counts) != size:
                self.refuse(f"{name.text}({', '.join(map(str, types))}) has no translation", name)
            return "vector" if size > 1 else "number", None, name.text
        if name.text in self.structs:
            wanted = list(self.structs[name.text].fields.values())
            if len(parts) != len(wanted):
                self.refuse(f"{name.text} with {len(parts)} members has no translation", name)
            for part, type in zip(parts, wanted):
                self.matched(part, type)
            self.structs[name.text].constructed |= self.structs[name.text] in self.items
            return "struct", self.structs[name.text], name.text
        if name.text in self.functions:
            for function in self.functions[name.text]:
                if len(parts) == len(function.parameters) and all(None in (a, b.type) or a == b.type for a, b in zip(types, function.parameters)):
                    for part, given in zip(parts, function.parameters):
                        if given.how != "in" and part.kind in ("member", "index") and not (part.parts[0].type or "").endswith("[]") and (
                                part.parts[0].type not in self.structs):
                            self.refuse(f"a component of a vector as an {given.how} argument has no translation", part)
                        if given.how != "in":
                            self.change(part)
                    return "function", function, function.type
            self.refuse(f"{name.text}({', '.join(map(str, types))}) matches no function, so it has no translation", name)
        if name.text in self.macros and self.macros[name.text].given is not None:
            macro = self.macros[name.text]
            return "macro", macro, self.expanded(macro, dict(zip(macro.given, types))).type
        if name.text in self.tested:
            return "macro", None, None
        if name.text not in FUNCTIONS or not parts:
            self.refuse(f"{name.text} has no translation", name)
        kind, size = max((shape for shape in shapes if shape[0]), key=lambda shape: shape[1], default=(None, 1))
        kind = FUNCTIONS[name.text] or kind
        return "builtin", None, VECTORS[kind, 1 if name.text in SINGLE else size] if kind and (None not in types or name.text in SINGLE) else None


class Printer:
    """A shader's text in another language: subclasses edit the nodes, words and comments that differ, and everything else stays."""

    def __init__(self, shader):
        self.shader, self.edits = shader, []
        for item in shader.items + shader.defined:
            for node in item.walk():
                getattr(self, node.kind, lambda node: None)(node)
        for token in shader.tokens + [token for macro in shader.defined for token in macro.body]:
            if token.kind == "name" and (word := self.word(token.text)) != token.text:
                self.replace(token, word)
        for token in shader.comments:
            self.replace(token, self.comment(token.text))

    def word(self, word):
        """Returns the translation of a name, wherever it stands."""
        return word

    def comment(self, text):
        return text

    def refuse(self, reason, node):
        raise Refused(self.shader.path, node.line, reason)

    def edit(self, start, end, text):
        """Replaces a part of the text. Of edits that overlap, the one that starts first or was made first counts."""
        self.edits.append((start, 2, len(self.edits), end, text))

    def replace(self, place, text):
        self.edit(place.start, place.end, text)

    def before(self, place, text):
        """Inserts a text before a token or node, outside of earlier ones."""
        self.edits.append((place.start, 1, -len(self.edits), place.start, text))

    def after(self, place, text):
        """Inserts a text after a token or node, outside of earlier ones."""
        self.edits.append((place.end, 0, len(self.edits), place.end, text))

    def after_line(self, node, text):
        """Inserts a text below a node's last line, or behind the node if more follows on that line."""
        end = self.shader.text.index("\n", node.end) + 1
        if any(node.end <= token.start < end for token in self.shader.tokens):
            end, text = node.end, "\n" + text
        self.edits.append((end, 0, len(self.edits), end, text))

    def text(self, start=0, end=None):
        """Returns the edited text between two places."""
        end, result, place = len(self.shader.text) if end is None else end, "", start
        for first, rank, _, last, text in sorted(self.edits):
            if place <= first and last <= end and (first, rank) not in ((start, 0), (end, 1)):
                result += self.shader.text[place:first] + text
                place = last
        return result + self.shader.text[place:end]
