"""Generates the sub graphs of Unity's package, which Shader Graph shows as nodes: each calls a function of GaborNoise.hlsl.
tools/package calls this module."""

import hashlib
import json
import pathlib
import re
import uuid

UNITY = pathlib.Path(__file__).resolve().parents[1] / "shaders" / "nodes" / "unity"

# For each node, the defaults of the function's inputs, and the numbers of its outputs' components.
NODES = {
    "Noise": ({"Place": (0.0, 0.0), "Frequency": 4.0, "Orientation": 0.7854, "Seed": 7.0}, {"Noise": 1, "Quadrature": 1}),
    "Stripes": ({"Place": (0.0, 0.0), "Wave": (2.83, 2.83), "Sharpness": 2.0, "Seed": 7.0}, {"Noise": 1, "Gradient": 2, "Stripes": 3}),
}
FRACTAL = {"Place": (0.0, 0.0), "Octaves": 5.0, "Gain": 0.5, "Shape": 0.0, "Basis": 0.0, "Seed": 7.0}, {"Noise": 1, "Gradient": 2}
NODES |= {"Fractal": FRACTAL, "Fractal Filtered": FRACTAL}


def vector(values):
    return dict(zip("xyzw", values))


def made_id(*names):
    """Returns an id that is the same whenever the package is built."""
    return hashlib.md5(" ".join(map(str, names)).encode()).hexdigest()


def refer(ids):
    return [{"m_Id": each} for each in ids]


def item(version, kind, id, **members):
    return {"m_SGVersion": version, "m_Type": f"UnityEditor.ShaderGraph.{kind}", "m_ObjectId": id} | members


def slot(id, number, name, size, is_output, variable):
    value = 0.0 if size == 1 else vector([0.0] * size)
    return item(0, f"Vector{size}MaterialSlot", id, m_Id=number, m_DisplayName=name, m_SlotType=int(is_output), m_Hidden=False,
                m_ShaderOutputName=variable, m_StageCapability=3, m_Value=value, m_DefaultValue=value, m_Labels=[])


def node(version, kind, id, name, place, slots, precision=0, **members):
    position = {"serializedVersion": "2"} | vector(place) | {"width": 200.0, "height": 120.0}
    return item(version, kind, id, m_Group={"m_Id": ""}, m_Name=name, m_DrawState={"m_Expanded": True, "m_Position": position}, m_Slots=refer(slots),
                synonyms=[], m_Precision=precision, m_PreviewExpanded=False, m_DismissedVersion=0, m_PreviewMode=0,
                m_CustomColors={"m_SerializableColors": []}, **members)


def edge(one, one_slot, other, other_slot):
    return {end: {"m_Node": {"m_Id": id}, "m_SlotId": number} for end, id, number in (("m_OutputSlot", one, one_slot), ("m_InputSlot", other, other_slot))}


def graph(name, inputs, outputs):
    """Yields the objects of a sub graph: properties, whose nodes lead to the function, which leads to the output node."""
    def id(*names):
        return made_id(name, *names)

    called = f"Gabor{name.replace(' ', '')}"
    function, output, category = id("function"), id("output"), id("category")
    properties, nodes = [id("property", each) for each in inputs], [id("node", each) for each in inputs]
    sizes = {each: 2 if isinstance(value, tuple) else 1 for each, value in inputs.items()} | outputs
    arguments = [id("argument", each) for each in (*inputs, *outputs)]
    edges = [edge(each, 0, function, number) for number, each in enumerate(nodes)]
    edges += [edge(function, len(inputs) + number, output, 1 + number) for number, _ in enumerate(outputs)]
    context = {"m_Position": vector((0.0, 0.0)), "m_Blocks": []}
    mesh = {"m_SerializedMesh": '{"mesh":{"instanceID":0}}', "m_Guid": ""}
    yield item(3, "GraphData", id("graph"), m_Properties=refer(properties), m_Keywords=[], m_Dropdowns=[], m_CategoryData=refer([category]),
               m_Nodes=refer([output, function, *nodes]), m_GroupDatas=[], m_StickyNoteDatas=[], m_Edges=edges, m_VertexContext=context,
               m_FragmentContext=context, m_PreviewData={"serializedMesh": mesh, "preventRotation": False}, m_Path="Procedural/Noise",
               m_GraphPrecision=1, m_PreviewMode=2, m_OutputNode={"m_Id": output}, m_ActiveTargets=[])
    yield node(0, "SubGraphOutputNode", output, "Output", (-100.0, 0.0), [id("result", each) for each in outputs], IsFirstSlotValid=True)
    source = re.search("^guid: (.*)", (UNITY / "GaborNoise.hlsl.meta").read_text(), re.MULTILINE)[1]
    yield node(1, "CustomFunctionNode", function, f"{called} (Custom Function)", (-400.0, 0.0), arguments, precision=1, m_SourceType=0,
               m_FunctionName=called, m_FunctionSource=source, m_FunctionBody="")
    yield item(0, "CategoryData", category, m_Name="", m_ChildObjectList=refer(properties))
    for number, (label, value) in enumerate(inputs.items()):
        size, guid = sizes[label], {"m_GuidSerialized": str(uuid.UUID(id("guid", label)))}
        given = {"m_Value": vector((*value, 0.0, 0.0))} if size == 2 else {"m_Value": value, "m_FloatType": 0, "m_RangeValues": vector((0.0, 16.0))}
        yield item(1, f"Internal.Vector{size}ShaderProperty", properties[number], m_Guid=guid, m_Name=label, m_DefaultRefNameVersion=1,
                   m_RefNameGeneratedByDisplayName=label, m_DefaultReferenceName=f"_{label}", m_OverrideReferenceName="",
                   m_GeneratePropertyBlock=True, m_UseCustomSlotLabel=False, m_CustomSlotLabel="", m_DismissedVersion=0, m_Precision=0,
                   overrideHLSLDeclaration=False, hlslDeclarationOverride=0, m_Hidden=False, **given)
        yield node(0, "PropertyNode", nodes[number], "Property", (-700.0, 60.0 * number), [id("value", label)], m_Property={"m_Id": properties[number]})
        yield slot(id("value", label), 0, label, size, True, "Out")
    for number, (label, size) in enumerate(sizes.items()):
        yield slot(arguments[number], number, label, size, label in outputs, label)
    for number, (label, size) in enumerate(outputs.items(), 1):
        yield slot(id("result", label), number, label, size, False, label)


def packaged():
    """Yields the path and text of each sub graph."""
    for name, (inputs, outputs) in NODES.items():
        yield UNITY / f"Gabor {name}.shadersubgraph", "\n\n".join(json.dumps(each, indent=4) for each in graph(name, inputs, outputs)) + "\n"
