"""Prints WGSL from the syntax tree of GLSL, with the same names, comments and layout. tools/translate calls this
module.

WGSL has no preprocessor: conditions are decided here, and macros with values become constants. A const_assert checks
what a condition assumed about these constants."""

import bisect
import functools
import re

import copies
import glsl
from glsl import NUMBERS, SHAPES, changes, root, shape

TYPES = {"float": "f32", "int": "i32", "uint": "u32"} | {
    name: f"vec{size}{kind[0]}" for name, (kind, size) in SHAPES.items() if size > 1}
REMARKS = TYPES | {"dFdx": "dpdx", "dFdy": "dpdy"}  # words in comments
BUILTINS = {"inversesqrt": "inverseSqrt", "atan": "atan2"}  # atan only with two arguments
# What WGSL reserves, and the names that this module writes, which a variable of this name would hide.
RESERVED = set("""NULL Self abstract active alias alignas alignof as asm asm_fragment async attribute auto await become case
    cast catch class co_await co_return co_yield coherent column_major common compile compile_fragment concept const_assert
    const_cast consteval constexpr constinit continuing crate debugger decltype default delete demote demote_to_helper
    diagnostic dynamic_cast enable enum explicit export extends extern external fallthrough filter final finally fn friend
    from fxgroup get goto groupshared impl implements import inline instanceof interface layout let loop macro macro_rules
    match meta mod module move mut mutable namespace new nil noexcept noinline nointerpolation non_coherent noncoherent
    noperspective null nullptr of operator override package packoffset partial pass patch pixelfragment precise premerge
    priv protected pub public readonly ref regardless register reinterpret_cast require requires resource restrict self set
    shared sizeof smooth snorm static static_assert static_cast std subroutine super switch target template this thread_local
    throw trait try type typedef typeid typename typeof union unless unorm unsafe unsized use using var varying virtual
    volatile wgsl where with writeonly yield""".split()) | set(TYPES.values()) | {
        "array", "atan2", "bitcast", "function", "inverseSqrt", "ptr", "select"}
USERS = {"GABOR_DIRECTION"}  # macros with arguments that the user defines: WGSL lacks the functions that call them
GUARD = "_GLSL"  # the end of macros that only tell that a file was included
NAME = r"\b[A-Za-z_]\w*"
COMPARISONS = {"==", "!=", "<", "<=", ">", ">="}
OPPOSITES = dict(zip("== != < >= > <=".split(), "!= == >= < <= >".split()))


# ---- The preprocessor ----------------------------------------------------------------------------------------------

class Branches:
    """The state of an #if: whether we keep the text around it, whether we have kept one of its branches, and whether we
    keep the current one."""

    def __init__(self, outer, kept=False):
        self.outer, self.found, self.kept, self.failed = outer, kept, kept, []


class Source:
    """A text after the preprocessor, with a form feed in place of each line that it removes. It keeps each #define,
    and has #assert and #refute for what its conditions found true and false. `known` are the macros defined before the
    text, and `given` those of the user. `editable` names the macros with a default that no condition uses to choose
    code."""

    def __init__(self, text, path, known, given):
        self.path, self.known, self.given, self.used, self.choosing = path, dict(known), given, set(), set()
        self.text, self.branches, self.defaults, place = "", [Branches(True, True)], [], 0
        for token in glsl.tokens(text):
            if token.kind in ("directive", "dialect"):
                end = token.end if token.kind == "dialect" else (text + "\n").index("\n", token.end)
                self.keep(text[place:token.start])
                line = self.directive(token, text[token.end:end], text[end:]) if token.kind == "directive" else ""
                self.text += (line or "\f") + "\f\n" * text.count("\n", token.start, end)
                place = end
        self.keep(text[place:])
        if len(self.branches) > 1:
            raise glsl.Refused(f"{path}: #if without #endif has no translation")
        self.fixed = [name for name in self.defaults if name in self.choosing]
        self.editable = [name for name in self.defaults if name not in self.choosing]

    def keep(self, text):
        self.text += text if self.branches[-1].kept else "\f\n" * text.count("\n")

    def refuse(self, token, reason):
        raise glsl.Refused(f"{self.path}:{token.line}: {reason}")

    def directive(self, token, comment, below):
        """Returns what to print in the place of a directive."""
        word, _, rest = token.text[1:].replace("\\\n", " ").strip().partition(" ")
        rest, state = rest.strip(), self.branches[-1]
        if word in ("if", "ifdef", "ifndef"):
            state = Branches(state.kept)
            self.branches.append(state)
            default = re.match(r"\s*#define (\w+) +(?!//)\S", below)
            if word == "ifndef" and default and default[1] == rest and state.outer and not rest.endswith(GUARD):
                self.defaults.append(rest)
        if word in ("if", "ifdef", "ifndef", "elif", "else"):
            test = {"ifdef": f"defined({rest})", "ifndef": f"!defined({rest})", "else": ""}.get(word, rest)
            error = re.match(r"\s*#error (.*)", below)
            return self.branch(token, test, error and error[1], state)
        if word == "endif" and len(self.branches) > 1:
            self.branches.pop()
        elif state.kept and word == "error":
            self.refuse(token, rest)
        elif state.kept and word == "define":
            return self.define(rest, comment)
        elif state.kept and word != "include":
            self.refuse(token, f"#{word} has no translation")
        return ""

    def branch(self, token, test, error, state):
        """Enters the next branch of a condition. Returns what WGSL must check of its constants."""
        names = set(re.findall(r"\b[A-Za-z_]\w*", test))
        of_constants = state.outer and names and all(self.known.get(name) for name in names)
        state.kept = state.outer and not state.found and (not test or self.value(token, test))
        if state.kept:
            state.found = True
            self.choosing |= names if of_constants else set()
            failed = " || ".join(state.failed)
            return f"#assert {test}" if of_constants else f"#refute {failed}" if failed and not test else ""
        if of_constants and error:
            return f"#refute {test} // {error}"
        if of_constants:
            state.failed.append(test)
            self.choosing |= names
        return ""

    def define(self, rest, comment):
        name, _, value = rest.partition(" ")
        if name in self.given:
            value = self.given[name]
            self.used.add(name)
        self.known[name] = value.strip()
        return "" if name.endswith(GUARD) else f"#define {name} {self.known[name]} {comment if value else ''}".rstrip()

    def value(self, token, test):
        """Tells whether a condition holds."""
        def of(match):
            word = match[0]
            known = "300" if word == "__VERSION__" else self.known.get(word)
            return f"({re.sub(NAME, of, known)})" if known else word
        text = re.sub(r"(!?)\s*\bdefined\s*\(?\s*(\w+)\s*\)?", lambda match: str(int((match[2] in {*self.known, *USERS}) != bool(match[1]))), test)
        text = re.sub(r"\b(0[xX][\da-fA-F]+|\d+)[uU]\b", r"\1", re.sub(NAME, of, text))
        text = text.replace("&&", " and ").replace("||", " or ").replace("/", "//")
        if not re.fullmatch(r"(and|or|0[xX][\da-fA-F]+|\d+|!=|[\s()<>=&|^~+*/%-])+", text):
            self.refuse(token, f"#if {test} has no translation")
        return bool(eval(text, {"__builtins__": {}}))  # of numbers and signs


@functools.cache
def shader(path, macros=(), before=None):
    """Returns the syntax tree of a drop-in with these macros, NAME=VALUE, after the files that it needs or these."""
    *others, last = (copies.needed(path) if before is None else before) or [None]
    tree = shader(last, macros, tuple(others)) if last else None
    given = dict(macro.partition("=")[::2] for macro in macros)
    shown = path.relative_to(copies.ROOT) if path.is_relative_to(copies.ROOT) else path
    source = Source(path.read_text(), shown, tree.source.known if tree else {}, given)
    made = glsl.Shader(source.text, shown, tree, USERS)
    made.source, made.used, made.absent = source, source.used | (tree.used if tree else set()), set(tree.absent if tree else ())
    for item in made.items:  # functions that need a macro of the user
        if any(part.kind == "call" and (part.what == "macro" or part.callee in made.absent) for part in item.walk()):
            made.absent.add(item)
    return made


# ---- Printing ------------------------------------------------------------------------------------------------------

def leaves(node):
    return [part for part in node.walk() if not part.parts]


def of_literals(node):
    """Tells whether an expression has only whole numbers: WGSL computes these with more than 32 bits."""
    return node.type == "int" and all(part.kind == "number" for part in leaves(node))


def constant(node, shader):
    """Returns the value of a constant whole number, or None."""
    if node.kind == "number" and node.type in ("int", "uint"):
        text = node.name.text.rstrip("uU")
        value = int(text, 8 if re.fullmatch("0[0-7]+", text) else 0)
        return value - 2**32 * (node.type == "int" and value >= 2**31)
    if node.kind == "macro_name":
        return constant(shader.macros[node.name.text].parts[0], shader)
    if node.kind == "name" and getattr(node.declared, "constant", False) and node.declared.value:
        return constant(node.declared.value, shader)
    values = [constant(part, shader) for part in node.parts]
    if node.type not in ("int", "uint") or None in values or node.kind not in ("group", "unary", "binary"):
        return None
    sign = node.sign.text if node.kind != "group" else ""
    if sign in ("<<", ">>") and not 0 <= values[1] < 32 or sign in ("/", "%") and values[1] == 0:
        return None
    wrapped = {"": lambda a: a, "+": lambda a, b=0: a + b, "-": lambda a, b=None: -a if b is None else a - b, "~": lambda a: ~a,
               "*": lambda a, b: a * b, "/": lambda a, b: int(a / b), "%": lambda a, b: a - b * int(a / b), "&": lambda a, b: a & b,
               "|": lambda a, b: a | b, "^": lambda a, b: a ^ b, "<<": lambda a, b: a << b, ">>": lambda a, b: a >> b}[sign](*values)
    return wrapped % 2**32 if node.type == "uint" else (wrapped + 2**31) % 2**32 - 2**31


def remark(text, whole):
    """Returns a comment of a text with WGSL's types, declarations of functions and, in examples, of variables."""
    if match := re.match(r"(// +)(?:float|u?int|[iu]?vec[234]|Gabor\w+) (\w+)(?= = )", text):
        changes = re.search(rf"^// +{match[2]}(\.\w+)? = ", whole, re.MULTILINE)
        text = f"{match[1]}{'var' if changes else 'let'} {match[2]}{text[match.end():]}"
    if match := re.fullmatch(r"// (\w+) (\w+)\(((?:\w+ \w+(?:, (?!$)|\)$))+|\))(.*)", text):
        given = re.sub(r"(\w+) (\w+)", r"\2: \1", match[3])
        text = f"// fn {match[2]}({given}{match[4]}" + f" -> {match[1]}" * (match[1] != "void")
    text = re.sub(r"\w+", lambda match: REMARKS.get(match[0], match[0]), text)
    return re.sub(r"\b([Aa]) (?=[fi]32\b)", r"\1n ", text)


class Wgsl:
    """A shader's text in WGSL. Each kind of node has a method that returns its text; `same` keeps the text between its parts."""

    def __init__(self, shader):
        self.shader, self.refuse, self.done = shader, shader.refuse, set()
        self.names = set(re.findall(NAME, shader.text))
        # variables that change, are arrays of which a variable chooses an element, or are lengths; numbers that need 32 bits
        self.changed, self.indexed, self.lengths, self.whole = set(), set(), set(), set()
        self.edits, self.starts, between, last = [], [], {}, ";"
        for token in glsl.tokens(shader.text):
            if token.kind == "comment":
                self.edits.append((token.start, token.end, remark(token.text, shader.text)))
            elif token.kind == "directive":
                between[token] = last in ";{}"
            elif token.text in shader.macros and not shader.macros[token.text].body:
                self.edits.append((token.start, token.end + 1, ""))
            else:
                last = token.text
        self.starts = [start for start, _, _ in self.edits]
        nodes = [node for item in [*shader.defined, *shader.items] for node in item.walk()]
        for node in nodes:
            self.study(node)
        for node in nodes:
            if node.kind == "binary" and node.sign.text in ("<<", ">>"):
                self.whole -= set(leaves(node.parts[1]))
        self.edits = sorted([*self.edits, *((token.start, token.end, self.directive(token, between[token])) for token in shader.directives)])
        self.starts = [start for start, _, _ in self.edits]

    def study(self, node):
        """Notes what nodes need to know of others."""
        if node.kind in ("function", "declare"):
            self.changed |= changes(node)
        if node.kind == "index" and (node.parts[0].type or "").endswith("[]") and node.parts[1].kind != "number" and self.variable_of(node):
            self.indexed.add(root(node))
        if node.kind in ("variable", "field") and node.type.endswith("[]"):
            self.lengths |= {part.declared for part in node.parts[0].walk() if part.declared}
        unsigned = node.kind == "call" and node.what == "vector" and "u" in node.name.text
        for part in node.parts if unsigned else [node] if node.kind == "binary" else []:
            if of_literals(part) and (node.kind == "binary" or part.kind != "number"):
                self.whole |= set(leaves(part))

    def variable_of(self, node):
        """Tells whether a node is a part of a variable."""
        while node.kind in ("member", "index"):
            node = node.parts[0]
        return node.kind == "name" and node.declared

    def text(self):
        made, place = "", 0
        for item in self.shader.items:
            made += self.source(place, item.start)
            if item in self.shader.absent:
                made = re.sub(r"(?m)(^//.*\n)*\Z", "", made)
            else:
                made += self.made(item)
            place = item.end
        made += self.source(place, len(self.shader.text))
        return re.sub(r"(?m)^[ \f]*\f\n", "", made).replace("\f", "")

    def source(self, start, end):
        """Returns the text between two places without nodes, with its comments and directives in WGSL."""
        made = ""
        for at, to, text in self.edits[bisect.bisect_left(self.starts, start):bisect.bisect_left(self.starts, end)]:
            made, start = made + self.shader.text[start:at] + text, to
        return made + self.shader.text[start:end]

    def made(self, node):
        return getattr(self, f"of_{node.kind}", self.same)(node)

    def same(self, node):
        made, place = "", node.start
        for part in node.parts:
            made, place = made + self.source(place, part.start) + self.made(part), part.end
        return made + self.source(place, node.end)

    def word(self, text):
        """Returns a name that WGSL accepts."""
        if text in RESERVED and f"{text}_" in self.names:
            line = self.shader.text.count("\n", 0, re.search(rf"\b{text}_\b", self.shader.text).start()) + 1
            raise glsl.Refused(f"{self.shader.path}:{line}: {text}_ beside {text}, which WGSL reserves, has no translation")
        return text + "_" * (text in RESERVED)

    def type(self, name):
        return TYPES.get(name) or self.word(name)

    def indent(self, node):
        """Returns the spaces at the start of a node's line."""
        return re.match(" *", self.shader.text[self.shader.text.rfind("\n", 0, node.start) + 1:])[0]

    # ---- Directives

    def directive(self, token, between):
        """Returns a constant or a check, which stands between two statements."""
        word, name = re.match(r"#(\w+) (\w*)", token.text).groups()
        within = any(item.start < token.start < item.end for item in self.shader.items)
        space = " " * self.shader.text.startswith("//", token.end)  # between code and a comment
        if word == "define":
            node = self.shader.macros[name]
            if within and node.body:
                self.refuse("#define within a function", token)
            return self.of_macro(node) + space if node.body else "\f"
        return f"{'    ' * within}const_assert {self.asserted(token, word)};{space}" if between else "\f"

    def of_macro(self, node):
        """Returns the constant in the place of a macro."""
        if len(node.parts) != 1 or node.parts[0].kind in ("binary", "choice") or any(part.kind == "call" and part.what == "function"
                                                                                   for part in node.walk()):
            self.refuse(f"{node.name.text}, a macro that is no constant in parentheses,", node)
        return f"const {self.word(node.name.text)}: {self.type(node.type)} = {self.made(node.parts[0])};"

    def asserted(self, token, word):
        _, *test = glsl.tokens(self.shader.text, token.start + 1, token.end, token.line)
        self.shader.start_reading(test, token.line)
        node = self.shader.expression()
        return self.made(node) if word == "assert" else self.negated(node)

    def negated(self, node):
        if node.kind == "binary" and node.sign.text in OPPOSITES and node.parts[0].type != "float":  # NaN has no opposites
            return f"{self.made(node.parts[0])} {OPPOSITES[node.sign.text]} {self.made(node.parts[1])}"
        return f"!({self.made(node)})"

    # ---- Expressions

    def of_number(self, node):
        text = node.name.text.lower()
        if node.type == "float":
            if not float(text.rstrip("f")) <= 3.4028235e38:
                self.refuse(f"{text}, more than a float holds,", node)
            return text
        value = int(text.rstrip("u"), 8 if re.fullmatch("0[0-7]+u?", text) else 0)
        if value >= 2**32:
            self.refuse(f"{text}, more than 32 bits,", node)
        if node.type == "int" and value >= 2**31:
            return f"i32({text}u)"
        if re.fullmatch("0[0-7]+u?", text):  # octal
            text = f"{value}{'u' * (node.type == 'uint')}"
        return text + "i" * (node in self.whole)

    def of_name(self, node):
        """Out parameters are pointers."""
        name = self.word(node.name.text)
        return f"(*{name})" if getattr(node.declared, "out", False) else name

    def of_group(self, node):
        return self.made(node.parts[0]) if node.parts[0].kind == "choice" else self.same(node)

    def of_macro_name(self, node):
        return self.word(node.name.text)

    def of_member(self, node):
        return self.made(node.parts[0]) + self.source(node.parts[0].end, node.name.start) + self.word(node.name.text)

    def of_step(self, node):
        if node in self.done:
            return self.made(node.parts[0])
        self.refuse(f"{node.sign.text} within an expression", node)

    def of_assign(self, node):
        self.refuse(f"{node.sign.text} within an expression", node)

    def of_unary(self, node):
        part, sign = self.made(node.parts[0]), node.sign.text
        if sign == "+":
            return part
        if sign == "-" and shape(node.type)[0] == "uint":  # WGSL negates only signed numbers
            return f"(0u - {part})"
        return f"{sign} {part}" if part.startswith(sign) else sign + part

    def of_binary(self, node):
        (left, right), sign = node.parts, node.sign
        self.check_constants(sign.text, left, right)
        gaps = self.source(left.end, sign.start), self.source(sign.end, right.start)
        return f"{self.operand(sign.text, left, left, right)}{gaps[0]}{sign.text}{gaps[1]}{self.operand(sign.text, right, left, right)}"

    def operand(self, sign, part, left, right):
        """Returns a side of an operation, in parentheses or converted where WGSL needs it."""
        types = self.conversions(sign, part, left, right)
        made = self.made(part.parts[0] if types and part.kind == "group" else part)
        for type in types:
            made = f"{type}({made})"
        if types or part.kind != "binary":
            return made
        other, logic = part.sign.text, {"&&", "||"}
        alone = sign in ("<<", ">>") or sign in ("&", "|", "^") and other != sign or {sign, other} == logic \
            or {sign, other} <= COMPARISONS
        return f"({made})" if alone else made

    def conversions(self, sign, part, left, right):
        """Returns the types to which a side of an operation is converted: bits of vectors and numbers do not mix."""
        size, count = (shape(each.type)[1] for each in (left, right))
        kind = shape(part.type)[0]
        if sign in ("<<", ">>") and part is right:
            types = [f"vec{count}u" if count > 1 else "u32"] if kind == "int" and part.kind != "number" else []
            return types + [f"vec{size}u"] * (size > count)
        return [f"vec{max(size, count)}{kind[0]}"] if sign in ("&", "|", "^") and shape(part.type)[1] < max(size, count) else []

    def check_constants(self, sign, left, right):
        """Refuses what WGSL's compilers refuse of constants."""
        first, second = (constant(part, self.shader) for part in (left, right))
        if sign in ("/", "%") and second == 0:
            self.refuse("a division by 0", right)
        if sign in ("/", "%") and right.kind == "number" and right.type == "float" and float(right.name.text.rstrip("fF")) == 0 \
                and all(leaf.kind in ("number", "macro_name") for leaf in leaves(left)):
            self.refuse("a division of a constant by 0", right)
        if sign in ("<<", ">>") and second is not None and not 0 <= second < 32:
            self.refuse(f"{sign} by {second}", right)
        if sign == "<<" and left.type == "int" and None not in (first, second) and not -2**31 <= first << second < 2**31:
            self.refuse("a constant beyond 32 bits", right)

    def of_choice(self, node):
        """WGSL computes both values of select; `pure` in glsl.py has refused changes in them."""
        test, yes, no = node.parts
        gaps = self.source(test.end, yes.start), self.source(yes.end, no.start)
        said = "".join(f" /* {each.strip('/* ')} */" for gap in gaps for each in re.findall(r"//.*|/\*.*?\*/", gap))
        comma = [", " if "\n" not in gap else ",\n" + " " * self.column(node) for gap in gaps]
        return f"select({self.made(no)}{comma[1]}{self.made(yes)}{comma[0]}{self.made(test)}{said})"

    def column(self, node):
        return node.start - self.shader.text.rfind("\n", 0, node.start) - 1

    def moved(self, text, column, by):
        """Returns a text whose further lines move with its first one, if they stand below what follows a column."""
        return re.sub(r"\n( +)(?=\S)", lambda match: match[0] if len(match[1]) < column else "\n" + " " * (len(match[1]) + by), text)

    def of_call(self, node):
        name = node.name.text
        if node.what == "vector":
            parts = [self.component(part, node) for part in node.parts]
            name = self.type(name)
        elif node.what == "builtin":
            parts = [self.argument(i, part, node) for i, part in enumerate(node.parts)]
            name = f"bitcast<{self.type(node.type)}>" if name == "uintBitsToFloat" else \
                BUILTINS[name] if name in BUILTINS and (name != "atan" or len(parts) == 2) else name
        else:
            given = node.callee.parameters if node.what == "function" else [None] * len(node.parts)
            parts = [self.made(part) if not (each and each.out) else self.address(part) for part, each in zip(node.parts, given)]
            name = self.word(name)
        text, place = "", node.name.end
        for part, made in zip(node.parts, parts):
            text, place = text + self.source(place, part.start) + made, part.end
        text += self.source(place, node.end)
        return name + self.moved(text, self.column(node) + len(node.name.text) + 1, len(name) - len(node.name.text))

    def address(self, part):
        """Returns the pointer for an out argument, which is a variable."""
        name = self.word(part.name.text)
        return name if getattr(part.declared, "out", False) else f"&{name}"

    def component(self, part, node):
        """Returns an argument of a vector or number, converted if it is one of several or makes all components."""
        kind, size = SHAPES[node.name.text]
        other, count = shape(part.type)
        abstract = part.kind == "number" and other == "int" and kind in ("float", "uint")
        if count == 1 and other != kind and size > 1 and not abstract:
            return f"{self.type(kind)}({self.made(part)})"
        return self.made(part)

    def argument(self, i, part, node):
        """Returns an argument of a function, as a vector if the others are vectors."""
        size = max(shape(each.type)[1] for each in node.parts)
        widened = i in NUMBERS.get(node.name.text, ()) and node.name.text != "mix" and shape(part.type)[1] < size
        return f"{self.type(node.type)}({self.made(part)})" if widened else self.made(part)

    # ---- Declarations

    def typed(self, node):
        """Returns a variable's type."""
        if node.type.endswith("[]"):
            return f"array<{self.type(node.type[:-2])}, {self.made(node.parts[0])}>"
        return self.type(node.type)

    def of_declare(self, node):
        parts = [self.declared(part, node) for part in node.parts]
        if not parts:
            self.refuse("an empty declaration", node)
        if parts[0].endswith(","):
            return " ".join(parts)
        gaps = [self.source(one.end, other.start) for one, other in zip(node.parts, node.parts[1:])]
        text = parts[0] + ";"
        for gap, part in zip(gaps, parts[1:]):
            comment = re.search("//.*", gap)
            long = "\n" in gap or len(self.indent(node) + text.split("\n")[-1] + part) > 118
            text += (f" {comment[0]}" if comment else "") + (f"\n{self.indent(node)}" if long else " ") + part + ";"
        return text

    def declared(self, part, node):
        name = self.word(part.name.text)
        if part.kind == "field":
            return f"{name}: {self.typed(part)},"
        if part.value and part.value.kind == "assign":
            return f"{self.act(part.value)}; {self.keyword(part)} {name} = {self.made(part.value.parts[0])}"
        value = part.value and self.made(part.value)
        if node in self.shader.items or part in self.lengths and node.constant:
            if any(each.kind == "call" and each.what == "function" for each in part.walk()):
                self.refuse("a call within a constant", part)
            return f"const {name}: {self.typed(part)} = {value}"
        if not value:
            return f"var {name}: {self.typed(part)}"
        before = f"{self.keyword(part)} {name} = "
        column = self.column(part.value)
        return before + (self.moved(value, column, self.column(node) + len(before) - column) if part is node.parts[0] else value)

    def keyword(self, part):
        return "var" if part in self.changed or part in self.indexed else "let"

    def of_struct(self, node):
        """Prints a struct, with the comments of its members in one column."""
        lines = self.same(node).rstrip(";").replace("struct " + node.name.text, "struct " + self.word(node.name.text), 1).split("\n")
        split = [re.fullmatch(r"( +\w+: .*?,) *(//.*)", line) for line in lines]
        widest = max((len(each[1]) for each in split if each), default=0)
        previous = None
        for i, each in enumerate(split):
            if each:
                lines[i] = f"{each[1]:{widest}} {each[2]}"
            elif previous and re.fullmatch(" *//.*", lines[i]):
                lines[i] = " " * (widest + 1) + lines[i].strip()
            previous = each or previous and re.fullmatch(" *//.*", lines[i])
        return "\n".join(lines)

    def of_function(self, node):
        """Parameters that change, or are arrays with a variable index, become variables."""
        copied = [part for part in node.parameters if not part.out and (part in self.changed or part in self.indexed)]
        text, place = f"fn {self.word(node.name.text)}(", node.name.end + 1
        indent = " " * len(text)
        for part in node.parameters:
            kind = f"ptr<function, {self.type(part.type)}>" if part.out else self.type(part.type)
            made = f"{self.given(part) if part in copied else self.word(part.name.text)}: {kind}"
            comment = re.search(r"//.*|/\*.*?\*/", self.source(place, part.start))
            if part is not node.parameters[0]:
                long = comment or len(text) - text.rfind("\n") + len(made) > 117
                text += "," + (f" {comment[0]}" if comment else "") + (f"\n{indent}" if long else " ")
            text, place = text + made, part.end
        text += re.sub(r"\)", ")" + f" -> {self.type(node.type)}" * (node.type != "void"), self.source(place, node.body.start), count=1)
        body = self.made(node.body)
        if copied:
            lines = [f"var {self.word(part.name.text)} = {self.given(part)};" for part in copied]
            body = "{" + "".join(f"\n    {line}" for line in lines) + body[1:] if "\n" in body else f"{{ {' '.join(lines)}{body[1:]}"
        return text + body

    def given(self, part):
        """Returns the name of a parameter whose own name is that of a variable."""
        name = f"{part.name.text}_in"
        while name in self.names:
            name += "_"
        return name

    # ---- Statements

    def act(self, node):
        """Returns an expression as a statement without its semicolon."""
        if node.kind == "step":
            return self.target(node.parts[0]) + node.sign.text
        if node.kind == "assign":
            left, right = node.parts
            before = f"{self.act(right)}; " if right.kind == "assign" else ""
            sign = node.sign.text[:-1]
            self.check_constants(sign, left, right)
            value = self.made(right.parts[0] if before else right)
            for type in self.conversions(sign, right, left, right):
                value = f"{type}({value})"
            target = self.target(left)
            value = self.moved(value, self.column(right), len(target) - (left.end - left.start))
            return f"{before}{target}{self.source(left.end, node.sign.start)}{sign}={self.source(node.sign.end, right.start)}{value}"
        if node.kind == "call" and node.what == "function":
            return self.made(node)
        return f"_ = {self.made(node)}"

    def target(self, node):
        """Returns what an assignment changes."""
        made = self.made(node)
        return made[1:-1] if node.kind == "name" and made[0] == "(" else made

    def of_expression(self, node):
        return self.act(node.parts[0]) + self.source(node.parts[0].end, node.end)

    def braced(self, gap, node, parent):
        """Returns a statement after the text before it, in braces."""
        if node.kind == "block":
            return gap + self.made(node)
        head, tail = re.fullmatch(r"((?:\s|//[^\n]*\n)*(?:\)|else))(.*)", gap, re.DOTALL).groups()
        end = f"\n{self.indent(parent)}" if "\n" in tail else " "
        return f"{head} {{{tail}{self.made(node)}{end}}}"

    def of_if(self, node):
        test, yes, *no = node.parts
        text = self.source(node.start, test.start) + self.made(test) + self.braced(self.source(test.end, yes.start), yes, node)
        if no:
            gap = self.source(yes.end, no[0].start)
            own_lines = yes.kind != "block" and "\n" in self.source(test.end, yes.start)  # else follows the new brace
            gap = re.sub(r"^\s*(?=else)", " ", gap) if own_lines else gap
            text += gap + self.made(no[0]) if no[0].kind == "if" else self.braced(gap, no[0], node)
        return text

    def of_while(self, node):
        test, body = node.parts
        return self.source(node.start, test.start) + self.made(test) + self.braced(self.source(test.end, body.start), body, node)

    def of_for(self, node):
        if node.begin.kind == "declare" and len(node.begin.parts) > 1 or len(node.step) > 1:
            self.refuse("a loop with several variables or steps", node)
        text, place = "for (" + self.made(node.begin), node.begin.end
        for part, made in ((node.test, self.made), *((step, self.act) for step in node.step)):
            if part:
                text, place = text + self.source(place, part.start) + made(part), part.end
        return text + self.braced(self.source(place, node.body.start), node.body, node)

    def of_do(self, node):
        """The test stands in the block that `continue` leads to, after its ++ and --."""
        body, test = node.parts
        steps = [part for part in test.walk() if part.kind == "step" and part.start == part.sign.start]
        self.done |= set(steps)
        last = f"continuing {{ {''.join(f'{self.act(part)}; ' for part in steps)}break if {self.negated(test)}; }}"
        block = self.made(body)[:-1].rstrip() if body.kind == "block" else "{ " + self.made(body)
        indent = f"\n{self.indent(node)}" if "\n" in block else ""
        return f"loop {block}{indent and indent + '   '} {last}{indent or ' '}}}"
