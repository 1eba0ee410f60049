"""Generates the files of Unity's package: HLSL; sub graphs that Shader Graph shows as nodes, each of which calls a
function of the HLSL; and .meta files. tools/package calls this module."""

import hashlib
import json
import re
import uuid

import hlsl_nodes

# The ids of files of version 2.0.0, by which projects refer to them.
IDS = {"GaborNoise.hlsl": "f95faf149a677348e759cdb37a71f456", "gabor_noise.hlsl": "968b68b6d1ef18e3191ceb61f968d17a",
       "Gabor Noise.shadersubgraph": "699a1602ebe4724af3c57261fd735070", "Gabor Stripes.shadersubgraph": "461f50aa4c059b2b28798645d41aa90e"}
META = """fileFormatVersion: 2
guid: {}
ShaderIncludeImporter:
  externalObjects: {{}}
  userData: 
  assetBundleName: 
  assetBundleVariant: 
"""
GRAPH_META = """fileFormatVersion: 2
guid: {}
ScriptedImporter:
  internalIDToNameTable: []
  externalObjects: {{}}
  serializedVersion: 2
  userData: 
  assetBundleName: 
  assetBundleVariant: 
  script: {{fileID: 11500000, guid: 60072b568d64c40a485e0fc55012dc9f, type: 3}}
"""


def vector(values):
    return dict(zip("xyzw", values))


def made_id(*names):
    """Returns an id that is the same whenever the package is built."""
    return hashlib.md5(" ".join(map(str, names)).encode()).hexdigest()


def guid(file):
    return IDS.get(file, made_id("file", file))


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


def graph(made):
    """Yields the objects of a node's sub graph: properties, whose nodes lead to the function, which leads to the output node."""
    def id(*names):
        return made_id(made.name, *names)

    inputs, outputs = {each.name: each for each in made.inputs}, made.outputs
    called = f"Gabor{made.name.replace(' ', '')}"
    function, output, category = id("function"), id("output"), id("category")
    properties, nodes = [id("property", each) for each in inputs], [id("node", each) for each in inputs]
    sizes = {name: len(each.value) for name, each in inputs.items()} | outputs
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
    yield node(1, "CustomFunctionNode", function, f"{called} (Custom Function)", (-400.0, 0.0), arguments, precision=1, m_SourceType=0,
               m_FunctionName=called, m_FunctionSource=guid(f"Gabor{made.file}.hlsl"), m_FunctionBody="")
    yield item(0, "CategoryData", category, m_Name="", m_ChildObjectList=refer(properties))
    for number, (label, given) in enumerate(inputs.items()):
        size, shown = sizes[label], " ".join(re.findall("[A-Z][a-z0-9]*", label))
        value = {"m_Value": given.value[0], "m_FloatType": 0, "m_RangeValues": vector((given.low, given.high))} if size == 1 else \
            {"m_Value": vector((*given.value, 0.0, 0.0)[:4])}
        yield item(1, f"Internal.Vector{size}ShaderProperty", properties[number], m_Guid={"m_GuidSerialized": str(uuid.UUID(id("guid", label)))},
                   m_Name=shown, m_DefaultRefNameVersion=1, m_RefNameGeneratedByDisplayName=shown, m_DefaultReferenceName=f"_{label}",
                   m_OverrideReferenceName="", m_GeneratePropertyBlock=True, m_UseCustomSlotLabel=False, m_CustomSlotLabel="",
                   m_DismissedVersion=0, m_Precision=0, overrideHLSLDeclaration=False, hlslDeclarationOverride=0, m_Hidden=False, **value)
        yield node(0, "PropertyNode", nodes[number], "Property", (-700.0, 60.0 * number), [id("value", label)], m_Property={"m_Id": properties[number]})
        yield slot(id("value", label), 0, shown, size, True, "Out")
    for number, (label, size) in enumerate(sizes.items()):
        yield slot(arguments[number], number, " ".join(re.findall("[A-Z][a-z0-9]*", label)), size, label in outputs, label)
    for number, (label, size) in enumerate(outputs.items(), 1):
        yield slot(id("result", label), number, label, size, False, label)


def packaged():
    """Yields the path and text of each file of HLSL, of each sub graph, and of their .meta files."""
    for name, text in hlsl_nodes.unity_files():
        yield hlsl_nodes.UNITY / name, text
        yield hlsl_nodes.UNITY / f"{name}.meta", META.format(guid(name))
    for each in hlsl_nodes.table():
        name = f"Gabor {each.name}.shadersubgraph"
        yield hlsl_nodes.UNITY / name, "\n\n".join(json.dumps(part, indent=4) for part in graph(each)) + "\n"
        yield hlsl_nodes.UNITY / f"{name}.meta", GRAPH_META.format(guid(name))
