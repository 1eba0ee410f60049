"""Reads the part of GLSL that the drop-ins use into a syntax tree with types, and edits its text. tools/translate and tools/nodes.py
print other languages from it. Refuses everything else with its file and line."""

import itertools
import re
from typing import NamedTuple

TOKEN = re.compile(r"""(?P<space>(?:\s|\\\n)+) | (?P<comment>//[^\n]*|/\*.*?\*/) | (?P<directive>\#(?:\\\n|(?!//|/\*)[^\n])*)
                       | (?P<number>0[xX][\da-fA-F]+[uU]?|(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][-+]?\d+)?[fF]?|\d+[uUif]?)
                       | (?P<name>[A-Za-z_]\w*) | (?P<sign><<=|>>=|&&|\|\||<<|>>|[-+*/%&|^=<>!]=|\+\+|--|[^\w\s])""", re.VERBOSE | re.DOTALL)
# Each number's or vector's type, with the type of its components and their number.
NUMBERS = {"float": "", "int": "i", "uint": "u", "bool": "b"}
SHAPES = {kind: (kind, 1) for kind in NUMBERS} | {f"{letter}vec{size}": (kind, size) for kind, letter in NUMBERS.items() for size in (2, 3, 4)}
TYPES = {shape: name for name, shape in SHAPES.items()}
SIGNS = ("||",), ("&&",), ("|",), ("^",), ("&",), ("==", "!="), ("<", ">", "<=", ">="), ("<<", ">>"), ("+", "-"), ("*", "/", "%")
PRECEDENCE = {sign: level for level, signs in enumerate(SIGNS, 1) for sign in signs}
LOGICAL = {sign for sign, level in PRECEDENCE.items() if level in (1, 2, 6, 7)}
COMPARISONS = {"lessThan": "<", "lessThanEqual": "<=", "greaterThan": ">", "greaterThanEqual": ">=", "equal": "==", "notEqual": "!="}
# Functions of GLSL that have a translation, and the type of their results' components if it is not that of their arguments.
FUNCTIONS = dict.fromkeys("abs acos asin atan ceil clamp cos cross dFdx dFdy exp exp2 floor fract inversesqrt log log2 max min mix "
                          "normalize pow sign sin smoothstep sqrt step tan dot length distance".split()) | {
    "all": "bool", "any": "bool", "uintBitsToFloat": "float", "intBitsToFloat": "float", "floatBitsToUint": "uint",
    "floatBitsToInt": "int"} | dict.fromkeys(COMPARISONS, "bool")
REDUCING = {"dot", "length", "distance", "all", "any"}  # they turn vectors into a number


class Refused(Exception):
    """A text that has no translation."""


class Token(NamedTuple):
    kind: str
    text: str
    start: int
    end: int
    line: int


class Node:
    """A part of the syntax tree: its kind, its place in the text, its parts and, for expressions and declarations, its type."""

    changed = False  # whether an expression is what an assignment changes

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
        start, line = match.end(), line + match[0].count("\n")


def without_comments(text):
    """Returns the text without comments and the spaces before them."""
    result, place = "", 0
    for token in tokens(text):
        if token.kind == "comment":
            result, place = (result + text[place:token.start]).rstrip(" "), token.end
    return result + text[place:]


def root(node):
    """Returns the variable of which an expression is a part."""
    return root(node.parts[0]) if node.kind in ("member", "index", "group") else node


def element(type):
    """Returns the type of a vector's or an array's elements, or None."""
    return type[:-2] if type and type.endswith("[]") else SHAPES[type][0] if SHAPES.get(type, ("", 1))[1] > 1 else None


def changes(function):
    """Returns the declarations of the variables that a function changes."""
    return {root(node).declared for node in function.walk() if node.changed}


class Shader:
    """The syntax tree of a drop-in. `before` is the drop-in before it, whose names it uses.

    Directives and comments may stand between any two tokens. All branches of a condition are read, one after the other."""

    def __init__(self, text, path, before=None):
        self.text, self.path, self.before, self.place, self.items = text, path, before, 0, []
        self.structs, self.functions, self.macros, globals_ = (
            dict(getattr(before, kind)) if before else {} for kind in ("structs", "functions", "macros", "globals"))
        self.globals, self.scopes = globals_, [globals_]
        found = list(tokens(text))
        self.comments, self.directives = ([token for token in found if token.kind == kind] for kind in ("comment", "directive"))
        self.tested = {token.text.split()[1] for token in self.directives if token.text.startswith(("#ifdef ", "#ifndef "))}
        self.defined = [self.macro(token) for token in self.directives if token.text.split()[0] == "#define"]
        empty = {name for name, macro in self.macros.items() if not macro.body and macro.given is None}
        self.tokens = [token for token in found if token.kind not in ("comment", "directive") and token.text not in empty]
        self.tokens.append(Token("end", "the end of the file", len(text), len(text), text.count("\n") + 1))
        while self.token.kind != "end":
            self.items += self.definition()
        self.start = min(place.start for place in [*self.directives, *self.items, self.token])
        for macro in self.defined:
            macro.parts = [self.expanded(macro, {})] if macro.body else []

    def conditions(self, node):
        """Returns the directives of the conditions around a node: for each, the last of #if, #elif and #else before the node."""
        found = []
        for directive in self.directives:
            if directive.start < node.start and directive.text.startswith(("#if", "#el", "#endif")):
                kept = found if directive.text.startswith("#if") else found[:-1]
                found = kept if directive.text.startswith("#endif") else [*kept, directive]
        return found

    def comment_start(self, place):
        """Returns where the comment directly above a place starts, or the place itself."""
        while (line := self.text.rfind("\n", 0, max(place - 1, 0)) + 1) < place and self.text.startswith("//", line):
            place = line
        return place

    # ---- Tokens ----

    @property
    def token(self):
        return self.tokens[self.place]

    def refuse(self, reason, where=None):
        raise Refused(f"{self.path}:{(where or self.token).line}: {reason} has no translation")

    def at(self, *texts):
        return self.token.text in texts

    def take(self, *texts, kind=None):
        """Returns the next token, which must be one of these texts or of this kind."""
        if texts and not self.at(*texts) or self.token.kind != (kind or self.token.kind) or self.token.kind == "end" != kind:
            self.refuse(f"'{self.token.text}' where {' or '.join(texts) or kind or 'more'} should be")
        self.place += 1
        return self.tokens[self.place - 1]

    def maybe(self, *texts):
        return self.take() if self.at(*texts) else None

    def until(self, closing, read, separator=None):
        """Reads parts up to a closing token, with separators between them."""
        parts = []
        while not self.at(closing):
            if parts and separator:
                self.take(separator)
            parts.append(read())
        self.take(closing)
        return parts

    def node(self, kind, first, parts=(), type=None, **more):
        """Returns a node from a token or node to the last token. C++ may evaluate the parts of an expression in any order."""
        changed = [{root(node).declared for node in part.walk() if node.changed and node is not part} for part in parts]
        for change, other in itertools.permutations(range(len(parts) if kind in ("assign", "binary", "call", "index") else 0), 2):
            if changed[change] & {node.declared for node in parts[other].walk() if node.kind == "name"}:
                self.refuse("a use and a change of a variable in one expression", first)
        return Node(kind, first, self.tokens[self.place - 1], parts, type, **more)

    # ---- Macros ----

    def macro(self, directive):
        """Reads a #define, except for its body."""
        _, name, *body = tokens(self.text, directive.start + 1, directive.start + len(directive.text), directive.line)
        given = None
        if body and body[0].text == "(" and body[0].start == name.end:
            end = [token.text for token in body].index(")")
            given, body = [token.text for token in body[1:end:2]], body[end + 1:]
        self.macros[name.text] = Node("macro", name, [name, *body][-1], name=name, given=given, body=body)
        return self.macros[name.text]

    def expanded(self, macro, types):
        """Returns the syntax tree of a macro, in which its parameters have these types."""
        kept, last = (self.tokens, self.place, self.scopes), [macro.name, *macro.body][-1]
        self.tokens, self.place = [*macro.body, Token("end", "the end of the macro", last.end, last.end, last.line)], 0
        self.scopes = [self.globals, {name: Node("parameter", last, last, type=types.get(name)) for name in macro.given or ()}]
        tree = self.expression()
        self.take(kind="end")
        self.tokens, self.place, self.scopes = kept
        return tree

    # ---- Definitions ----

    def type_name(self):
        if not self.at("void", *SHAPES, *self.structs):
            self.refuse(f"'{self.token.text}'")
        return self.take()

    def variable(self, kind, first, type_name, **more):
        """Reads a name and the length of an array, after their type, and declares it."""
        name = self.take(kind="name")
        length = [self.expression(), self.take("]")][:1] if self.maybe("[") else []
        node = self.node(kind, first or name, length, type_name.text + "[]" * len(length), name=name, type_name=type_name, value=None, **more)
        if kind == "parameter" and length:
            self.refuse("an array as a parameter", name)
        if kind != "field" and self.scopes[-1].setdefault(name.text, node).type != node.type:
            self.refuse(f"a second {name.text} with another type", name)
        return node

    def declaration(self, kind):
        """Reads the declaration of one or more variables or fields, with a semicolon."""
        first, constant = self.token, self.maybe("const")
        type_name, parts = self.type_name(), []
        while not parts or self.take(",", ";").text == ",":
            parts.append(node := self.variable(kind, None, type_name))
            if kind != "field" and self.maybe("="):
                node.value = self.matched(self.expression(), node.type)
                node.parts.append(node.value)
        return self.node("declare", first, parts, constant=constant)

    def definition(self):
        """Returns a struct, constant, function or precision statement in a list."""
        first = self.token
        if self.maybe(";"):
            return []
        if self.maybe("precision"):
            self.until(";", self.take)
            return [self.node("precision", first)]
        if self.maybe("struct"):
            name = self.take(kind="name")
            self.take("{")
            parts = self.until("}", lambda: self.declaration("field"))
            fields = {field.name.text: field for line in parts for field in line.parts}
            self.take(";")
            self.structs[name.text] = self.node("struct", first, parts, name=name, fields=fields, constructed=False)
            return [self.structs[name.text]]
        if self.at("const"):
            return [self.declaration("variable")]
        type_name, name = self.type_name(), self.take(kind="name")
        if not self.maybe("("):
            self.refuse("a global variable that is not const", first)
        self.scopes.append({})
        parameters = self.until(")", self.parameter, ",")
        node = self.node("function", first, parameters, type_name.text, name=name, parameters=parameters, head=self.tokens[self.place - 1].end, body=None)
        for part in parameters:
            part.function = node
        types = [part.type for part in parameters]
        self.functions[name.text] = [other for other in self.functions.get(name.text, ()) if [part.type for part in other.parameters] != types] + [node]
        self.result = node.type
        if not self.maybe(";"):
            node.body = self.statement()
            node.parts.append(node.body)
        node.end = self.tokens[self.place - 1].end
        self.scopes.pop()
        return [node]

    def parameter(self):
        first, words = self.token, set()
        while word := self.maybe("const", "in", "out", "inout"):
            words.add(word.text)
        return self.variable("parameter", first, self.type_name(), out=bool(words & {"out", "inout"}), constant="const " * ("const" in words))

    # ---- Statements ----

    def statement(self):
        first, text = self.token, self.token.text
        if text in ("{", "for"):
            self.scopes.append({})
        if self.maybe("{"):
            parts = self.until("}", self.statement)
        elif self.maybe("for"):
            self.take("(")
            parts = [self.statement(), *self.until(";", self.expression, ";"), *self.until(")", self.expression, ","), self.statement()]
        elif self.maybe("if", "while"):
            parts = [self.condition(), self.statement(), *([self.statement()] if text == "if" and self.maybe("else") else [])]
        elif self.maybe("do"):
            parts = [self.statement(), self.take("while") and self.condition()]
            self.take(";")
        elif self.maybe("return"):
            parts = self.until(";", lambda: self.matched(self.expression(), self.result), ";")
        elif self.maybe("break", "continue"):
            text, parts = "jump", self.take(";") and []
        elif text == "const" or text in {*SHAPES, *self.structs} and self.tokens[self.place + 1].kind == "name":
            return self.declaration("variable")
        else:
            text, parts = "expression", self.until(";", self.expression, ",")
        if text in ("{", "for"):
            self.scopes.pop()
        return self.node({"{": "block", "if": "branch"}.get(text, text), first, parts)

    def condition(self):
        self.take("(")
        return [self.matched(self.expression(), "bool"), self.take(")")][0]

    # ---- Expressions ----

    def matched(self, node, type):
        """Returns the expression, which must have this type: GLSL ES, Godot and WGSL convert nothing."""
        if None not in (node.type, type) and (node.type != type or type.endswith("[]")):
            self.refuse(f"a conversion from {node.type} to {type}" if node.type != type else "a copy of an array", node)
        return node

    def pure(self, node):
        """Returns the expression, which must change nothing, because some languages evaluate it always, or twice."""
        if any(part.changed for part in node.walk()):
            self.refuse("a change within a part of an expression that may be skipped or repeated", node)
        return node

    def operated(self, left, sign, right, where):
        """Returns the type of a binary operation."""
        types = left.type, right.type
        if sign in ("&&", "||"):
            self.matched(left, "bool"), self.pure(self.matched(right, "bool"))
        if sign in LOGICAL and ({*types} <= {*SHAPES, None} or self.refuse(f"{sign} of structs or arrays", where)):
            return self.matched(left, right.type) and "bool"
        if None in types:
            return None
        (kind, size), (other, count) = (SHAPES.get(type, (type, 0)) for type in types)
        if not size or not count or kind != other and (sign not in ("<<", ">>") or size * count > 1) or size != count and 1 not in (size, count):
            self.refuse(f"{types[0]} {sign} {types[1]}", where)
        return TYPES[kind, max(size, count)]

    def change(self, node):
        """Notes that an expression changes. It must be a variable or a part of one."""
        if root(node).kind != "name" or node.kind in ("member", "index") and getattr(node.parts[0], "swizzle", False):
            self.refuse(f"a change of '{self.text[node.start:node.end]}'", node)
        node.changed = True
        return node

    def expression(self):
        left, sign = self.choice(), self.token
        if not sign.text.endswith("=") or sign.text in PRECEDENCE:
            return left
        self.take()
        right = self.expression()
        self.change(self.pure(left))
        if sign.text == "=":
            self.matched(right, left.type)
        elif self.operated(left, sign.text[:-1], right, sign) not in (left.type, None):
            self.refuse(f"{left.type} {sign.text} {right.type}", sign)
        return self.node("assign", left, [left, right], left.type, sign=sign)

    def choice(self):
        test = self.binary(1)
        if not self.maybe("?"):
            return test
        yes = [self.matched(test, "bool"), self.pure(self.expression()), self.take(":")][1]
        no = self.pure(self.matched(self.expression(), yes.type))
        if {yes.type, no.type} - {*SHAPES, None}:
            self.refuse(f"? of {yes.type}", test)
        return self.node("choice", test, [test, yes, no], yes.type or no.type)

    def binary(self, level):
        left = self.unary()
        while PRECEDENCE.get(self.token.text, 0) >= level:
            sign = self.take()
            right = self.binary(PRECEDENCE[sign.text] + 1)
            left = self.node("binary", left, [left, right], self.operated(left, sign.text, right, sign), sign=sign)
        return left

    def unary(self):
        if sign := self.maybe("-", "+", "!", "~"):
            part = self.unary()
            return self.node("unary", sign, [part], part.type, sign=sign)
        if sign := self.maybe("++", "--"):
            return self.step(sign, sign, self.unary())
        node = self.primary()
        while sign := self.maybe(".", "[", "++", "--"):
            if sign.text == ".":
                node = self.member(node, self.take(kind="name"))
            elif sign.text == "[":
                index = [self.expression(), self.take("]")][0]
                if node.type and not element(node.type):
                    self.refuse(f"an index into a {node.type}", sign)
                node = self.node("index", node, [node, index], element(node.type))
            else:
                node = self.step(node, sign, node)
        return node

    def step(self, first, sign, part):
        if part.type not in ("int", "uint"):
            self.refuse(f"{sign.text} of a {part.type}", sign)
        return self.node("step", first, [self.change(part)], part.type, sign=sign)

    def member(self, part, name):
        """Returns a struct's member or a swizzle. If the type is unknown, so is that of the member."""
        if part.type in self.structs and name.text in (fields := self.structs[part.type].fields):
            return self.node("member", part, [part], fields[name.text].type, name=name, swizzle=False)
        kind, size = SHAPES.get(part.type, (None, 4))
        swizzle = not set(name.text) - set("xyzw"[:size]) and len(name.text) < 5
        if part.type and (not kind or size == 1 or not swizzle):
            self.refuse(f".{name.text} of a {part.type}", name)
        return self.node("member", part, [part], kind and TYPES[kind, len(name.text)], name=name, swizzle=swizzle)

    def primary(self):
        token = self.take()
        if token.kind == "number":
            whole = token.text[:2] in ("0x", "0X") or not set(token.text) & set(".eEfF")
            return self.node("number", token, type="uint" if token.text[-1] in "uU" else "int" if whole else "float", name=token)
        if token.text == "(":
            part = [self.expression(), self.take(")")][0]
            return self.node("group", token, [part], part.type)
        if token.text in ("true", "false"):
            return self.node("name", token, type="bool", name=token, declared=None)
        if token.kind == "name" and self.maybe("("):
            parts = self.until(")", self.expression, ",")
            what, callee, type = self.called(token, parts)
            return self.node("call", token, parts, type, name=token, what=what, callee=callee)
        for scope in reversed(self.scopes):
            if token.text in scope:
                return self.node("name", token, type=scope[token.text].type, name=token, declared=scope[token.text])
        if token.text in self.macros and self.macros[token.text].given is None:
            return self.node("macro_name", token, type=self.expanded(self.macros[token.text], {}).type, name=token)
        self.refuse("an array constructor" if self.at("[") else f"'{token.text}', which is not declared," if token.kind == "name" else f"'{token.text}' here", token)

    def called(self, name, parts):
        """Returns what a call is, the definition that it calls, and its type."""
        types, text = [part.type for part in parts], name.text
        shapes = [SHAPES.get(type, (None, 1)) for type in types]
        listed = f"{text}({', '.join(map(str, types))})"
        if text in SHAPES:
            counts = [size for _, size in shapes]
            if not parts or {*types} - {*SHAPES, None} or None not in types and counts not in ([1], [SHAPES[text][1]]) and sum(counts) != SHAPES[text][1]:
                self.refuse(listed, name)
            return "vector", None, text
        if struct := self.structs.get(text):
            if len(parts) != len(struct.fields):
                self.refuse(listed, name)
            for part, field in zip(parts, struct.fields.values()):
                self.matched(part, field.type)
            struct.constructed |= struct in self.items
            return "struct", struct, text
        if text in self.functions:
            for function in self.functions[text]:
                if len(parts) == len(function.parameters) and all(None in (type, part.type) or type == part.type for type, part in zip(types, function.parameters)):
                    break
            else:
                self.refuse(f"{listed}, which matches no function,", name)
            out = [self.change(part) for part, given in zip(parts, function.parameters) if given.out]
            for part in out:
                if part.kind != "name" or [other.name.text for other in out].count(part.name.text) > 1:
                    self.refuse(f"'{self.text[part.start:part.end]}' as an out argument", part)
            return "function", function, function.type
        macro = self.macros.get(text)
        if macro and macro.given is not None or text in self.tested:
            return "macro", macro, macro and self.expanded(macro, dict(zip(macro.given, types))).type
        kind, size = max(shapes, key=lambda shape: shape[1], default=("", 0))
        numbers_only = text in REDUCING | {"normalize"} and size == 1 or "bool" in dict(shapes) and text not in ("all", "any", "equal", "notEqual")
        if text not in FUNCTIONS or not parts or numbers_only and None not in types:
            self.refuse(listed if text in FUNCTIONS else text, name)
        return "builtin", None, TYPES.get((FUNCTIONS[text] or kind, 1 if text in REDUCING else size)) if None not in types else None


class Printer:
    """A shader's text in another language: subclasses edit the nodes, words and comments that differ, and everything else stays."""

    words = {}  # translations of names, wherever they stand

    def __init__(self, shader):
        self.shader, self.edits = shader, []
        for item in shader.items + shader.defined:
            for node in item.walk():
                getattr(self, node.kind, lambda node: None)(node)
        for token in shader.tokens + [token for macro in shader.defined for token in macro.body]:
            if token.kind == "name":
                self.replace(token, self.word(token.text))
        for token in shader.comments:
            self.replace(token, self.remark(token.text))

    def word(self, word):
        return self.words.get(word, word)

    def remark(self, text):
        """Returns the translation of a comment."""
        return text

    def refuse(self, reason, node):
        raise Refused(f"{self.shader.path}:{node.line}: {reason} has no translation")

    def edit(self, start, end, text):
        """Replaces a part of the text. Of edits that overlap, the one that starts first or was made first counts."""
        self.edits.append((start, 2, len(self.edits), end, text))

    def replace(self, place, text):
        if text != self.shader.text[place.start:place.end]:
            self.edit(place.start, place.end, text)

    def before(self, place, text):
        """Inserts a text before a token or node, outside of earlier ones."""
        self.edits.append((place.start, 1, -len(self.edits), place.start, text))

    def after(self, place, text):
        """Inserts a text after a token or node, outside of earlier ones."""
        self.edits.append((place.end, 0, len(self.edits), place.end, text))

    def below(self, node, text):
        """Inserts lines below a node's last line, or behind the node if more follows on that line."""
        end = self.shader.text.index("\n", node.end) + 1
        more = any(node.end <= token.start < end for token in self.shader.tokens)
        self.after(node, "\n" + text) if more else self.edits.append((end, 0, len(self.edits), end, text))

    def text(self, start=0, end=None):
        """Returns the edited text between two places."""
        end, result, place = len(self.shader.text) if end is None else end, "", start
        for first, rank, _, last, text in sorted(self.edits):
            if place <= first and last <= end and (first, rank) not in ((start, 0), (end, 1)):
                result, place = result + self.shader.text[place:first] + text, last
        return result + self.shader.text[place:end]
