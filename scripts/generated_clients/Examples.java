import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.openapitools.client.ApiClient;
import org.openapitools.client.ApiException;
import org.openapitools.client.api.JobsApi;
import org.openapitools.client.api.SolveApi;
import org.openapitools.client.model.*;

/** Runs the Java client of openapi-generator over every example. */
final class Examples {
    private static final String PATIENCE = "wait=60";
    private static final ApiClient CLIENT = new ApiClient();
    private static final ObjectMapper JSON = CLIENT.getObjectMapper();
    private static SolveApi solving;
    private static JobsApi jobs;

    public static void main(String[] arguments) throws IOException {
        CLIENT.updateBaseUri(System.getenv("PLATEAU_URL"));
        solving = new SolveApi(CLIENT);
        jobs = new JobsApi(CLIENT);
        List<Path> paths;
        try (Stream<Path> files = Files.list(Path.of(arguments[0]))) {
            paths = files.filter(path -> path.toString().endsWith(".json")).sorted().collect(Collectors.toList());
        }
        int good = 0;
        for (Path path : paths) {
            try {
                solve(JSON.readTree(path.toFile()));
                good += 1;
            } catch (Exception | AssertionError error) {
                boolean isAnswer = error instanceof ApiException;
                String text = isAnswer ? ((ApiException) error).getResponseBody() : error.toString();
                System.err.printf("openapi-generator, java: %s: %.600s%n", path.getFileName(), text);
            }
        }
        System.out.printf("openapi-generator, java: %d of %d examples%n", good, paths.size());
        System.exit(good == paths.size() && good > 0 ? 0 : 1);
    }

    private static void solve(JsonNode request) throws Exception {
        String id = post(request);
        Object job;
        String status;
        do {
            job = jobs.getJob(id, PATIENCE).getActualInstance();
            status = JSON.valueToTree(job).path("status").asText();
        } while (status.equals("queued") || status.equals("running"));
        check(isGood(job), JSON.writeValueAsString(job));
        File mesh = jobs.getMesh(id, "glb", null, null, null, null, null);
        byte[] bytes = Files.readAllBytes(mesh.toPath());
        Files.delete(mesh.toPath());
        check(new String(bytes, 0, 4, StandardCharsets.US_ASCII).equals("glTF"), "the mesh is no GLB");
    }

    /** Creates the job of a request and returns its identifier. */
    private static String post(JsonNode json) throws Exception {
        switch (json.path("kind").asText()) {
            case "ruled_surface":
                return solving.postRuledSurface(read(json, RuledSurfaceRequest.class), PATIENCE, null).getId();
            case "minimal_surface":
                return solving.postMinimalSurface(read(json, MinimalSurfaceRequest.class), PATIENCE, null).getId();
            case "uniform_mesh":
                return solving.postUniformMesh(read(json, UniformMeshRequest.class), PATIENCE, null).getId();
            case "tensile_structure":
                return solving.postTensileStructure(read(json, TensileStructureRequest.class), PATIENCE, null).getId();
            case "cable_net":
                return solving.postCableNet(read(json, CableNetRequest.class), PATIENCE, null).getId();
            default:
                throw new AssertionError("unknown kind");
        }
    }

    /** Returns the request as the client's type, which must not change it. */
    private static <T> T read(JsonNode request, Class<T> type) throws IOException {
        T body = JSON.treeToValue(request, type);
        JsonNode written = JSON.readTree(JSON.writeValueAsString(body));
        boolean isEqual = filled(written).equals((a, b) -> {
            boolean isSame = a.isNumber() && b.isNumber() ? a.doubleValue() == b.doubleValue() : a.equals(b);
            return isSame ? 0 : 1;
        }, filled(request));
        check(isEqual, "the request changes on its way through the client: " + written);
        return body;
    }

    /** Returns a value without the members that are null or empty lists, which this client sends for what is not given. */
    private static JsonNode filled(JsonNode value) {
        if (value.isObject()) {
            ObjectNode object = JSON.createObjectNode();
            value.fields().forEachRemaining(field -> {
                JsonNode part = field.getValue();
                if (!part.isNull() && !(part.isArray() && part.isEmpty())) {
                    object.set(field.getKey(), filled(part));
                }
            });
            return object;
        }
        if (value.isArray()) {
            ArrayNode list = JSON.createArrayNode();
            value.forEach(part -> list.add(filled(part)));
            return list;
        }
        return value;
    }

    /** Whether a job has the statistics of its kind. */
    private static boolean isGood(Object job) {
        if (job instanceof RuledSurfaceJob) {
            RuledStatistics it = ((RuledSurfaceJob) job).getStatistics();
            return it != null && it.getTriangles() > 0 && it.getObjective() != null;
        }
        if (job instanceof MinimalSurfaceJob) {
            MinimalStatistics it = ((MinimalSurfaceJob) job).getStatistics();
            return it != null && it.getTriangles() > 0 && it.getArea() > 0 && it.getObjective() != null;
        }
        if (job instanceof UniformMeshJob) {
            UniformStatistics it = ((UniformMeshJob) job).getStatistics();
            return it != null && it.getTriangles() > 0 && it.getNodes() > 0 && it.getObjective() != null;
        }
        if (job instanceof TensileStructureJob) {
            TensileStatistics it = ((TensileStructureJob) job).getStatistics();
            return it != null && it.getTriangles() > 0 && it.getObjective() != null;
        }
        CableNetStatistics it = ((CableNetJob) job).getStatistics();
        return it != null && it.getEdges() > 0 && it.getObjective() != null;
    }

    private static void check(boolean isTrue, String otherwise) {
        if (!isTrue) {
            throw new AssertionError(otherwise);
        }
    }
}
