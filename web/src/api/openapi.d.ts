// Generated from api/openapi.json by build.mjs.

export interface paths {
    "/": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The studio, a page to draw, solve and inspect surfaces */
        get: operations["getStudio"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/docs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Redirects to `/docs/` */
        get: operations["findDocs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/docs/": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A page to read and try the API, which works offline */
        get: operations["getDocs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/docs/{file}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A file of the API page */
        get: operations["getDocsFile"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/health/live": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Checks that the process answers */
        get: operations["getLive"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/health/ready": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Checks that the store answers and jobs are accepted */
        get: operations["getReady"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/hops": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The components for Hops in Grasshopper */
        get: operations["listHopsComponents"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/hops/solve": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Runs a component for Hops in Grasshopper
         * @description Hops posts beside the address of the component, and its later versions at the root of the host. Keys may also be sent in the header `RhinoComputeKey`.
         */
        post: operations["postHopsSolve"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/hops/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A component for Hops in Grasshopper */
        get: operations["getHopsComponent"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/mcp": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** A message of the Model Context Protocol, for tools of language models; 404 unless `http.mcp` is set */
        post: operations["postMcp"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/metrics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Metrics as Prometheus text */
        get: operations["getMetrics"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/openapi.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** This document */
        get: operations["getOpenApi"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/problems/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Meaning of the `type` of a problem document or of a failed job's error */
        get: operations["getProblem"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/solve": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Runs a component for Hops in Grasshopper
         * @description Hops posts beside the address of the component, and its later versions at the root of the host. Keys may also be sent in the header `RhinoComputeKey`.
         */
        post: operations["postSolve"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/studio/{file}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** A file of the studio */
        get: operations["getStudioFile"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/batches": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Submits many requests at once; either all are accepted or none */
        post: operations["postBatch"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/batches/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The batch with its status and its jobs */
        get: operations["getBatch"];
        put?: never;
        post?: never;
        /** Cancels jobs that have not ended, and removes all jobs and meshes */
        delete: operations["deleteBatch"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/batches/{id}/cancel": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Cancels every job that has not ended */
        post: operations["cancelBatch"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/batches/{id}/meshes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All meshes in one file */
        get: operations["getBatchMeshes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/cable-nets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Finds the shape in equilibrium of a cable net that comes nearest to target forces and lengths
         * @description With `Prefer: wait` and an `Accept` that prefers a media type of `getMesh`, such as `model/gltf-binary`, the answer to a job that succeeds in time is the mesh itself. `Location` and `Link` lead to its job. A job without a mesh is then answered with 409.
         */
        post: operations["postCableNet"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/examples": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Names and titles of the example requests */
        get: operations["listExamples"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/examples/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** An example request */
        get: operations["getExample"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Jobs, newest first */
        get: operations["listJobs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The job with its status, progress, statistics and links */
        get: operations["getJob"];
        put?: never;
        post?: never;
        /** Cancels the job if needed, and removes it with its mesh */
        delete: operations["deleteJob"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}/cancel": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Cancels a queued or running job; a finished job stays unchanged */
        post: operations["cancelJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}/certificate": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The proof of a minimal surface's `area_lower_bound`, for a check by another program */
        get: operations["getCertificate"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}/events": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Progress as server-sent events */
        get: operations["getEvents"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}/mesh": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The mesh as GLB, glTF, OBJ, PLY, STL or JSON */
        get: operations["getMesh"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}/pattern": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The flat pattern of an open ruled surface as SVG or DXF */
        get: operations["getPattern"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/jobs/{id}/ticket": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * An address for the EventSource of browsers, which cannot send a key
         * @description Anyone who has the address can follow the events of this job until it expires, and nothing else. A stream that is open then goes on.
         */
        post: operations["postTicket"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/limits": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Limits of this server for one request */
        get: operations["getLimits"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/minimal-surfaces": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Finds the minimal surface that spans boundary polylines
         * @description With `Prefer: wait` and an `Accept` that prefers a media type of `getMesh`, such as `model/gltf-binary`, the answer to a job that succeeds in time is the mesh itself. `Location` and `Link` lead to its job. A job without a mesh is then answered with 409.
         */
        post: operations["postMinimalSurface"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/objectives": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Objectives that a request can choose */
        get: operations["listObjectives"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/ruled-surfaces": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Finds the globally optimal ruled strip between directrices for an objective
         * @description With `Prefer: wait` and an `Accept` that prefers a media type of `getMesh`, such as `model/gltf-binary`, the answer to a job that succeeds in time is the mesh itself. `Location` and `Link` lead to its job. A job without a mesh is then answered with 409.
         */
        post: operations["postRuledSurface"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/tensile-structures": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Finds the shape in equilibrium of a film with cables, pressure and weight
         * @description With `Prefer: wait` and an `Accept` that prefers a media type of `getMesh`, such as `model/gltf-binary`, the answer to a job that succeeds in time is the mesh itself. `Location` and `Link` lead to its job. A job without a mesh is then answered with 409.
         */
        post: operations["postTensileStructure"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/v1/uniform-meshes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Finds a mesh of a polygon, patch or film with as many equal edges as possible
         * @description With `Prefer: wait` and an `Accept` that prefers a media type of `getMesh`, such as `model/gltf-binary`, the answer to a job that succeeds in time is the mesh itself. `Location` and `Link` lead to its job. A job without a mesh is then answered with 409.
         */
        post: operations["postUniformMesh"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /** @description A part of a boundary, in the boundary's direction. Points are counted from 0. */
        Along: {
            /** @description Default: `0`. */
            boundary?: number;
            /** @description Number of the point at which the cable begins. */
            from: number;
            /** @description Number of the point at which it ends. */
            to: number;
        };
        AngleRange: {
            /** Format: double */
            max: number;
            /** Format: double */
            min: number;
        };
        /** @description Requests that were submitted together, and the state of their jobs. */
        Batch: {
            counts: components["schemas"]["BatchCounts"];
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Time at which the last job ended. Null until then. */
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            /** @description Jobs in the order of the requests. Jobs that were deleted or have expired are left out. */
            jobs: components["schemas"]["BatchJob"][];
            links: components["schemas"]["BatchLinks"];
            /**
             * @description `queued` until the first job starts, then `running` until the last job has ended. The final status is `failed`
             *     if any job has failed, otherwise `cancelled` if any was cancelled, otherwise `succeeded`.
             */
            status: components["schemas"]["Status"];
        };
        /** @description Number of jobs of a batch in each state. */
        BatchCounts: {
            cancelled: number;
            failed: number;
            queued: number;
            running: number;
            succeeded: number;
        };
        /** @description Short form of a job of a batch. Its `self` link leads to the full job. */
        BatchJob: {
            id: string;
            /** @description Index of the job's request in the batch, counted from 0. */
            index: number;
            kind: components["schemas"]["Kind"];
            links: components["schemas"]["Links"];
            status: components["schemas"]["Status"];
        };
        /** @description Addresses that belong to a batch. */
        BatchLinks: {
            cancel: string;
            /** @description All meshes in one file. */
            meshes: string;
            self: string;
        };
        /** @description Requests of any kinds. Each becomes a separate job. */
        BatchRequest: {
            /** @description URL (https) that receives a signed POST when every job has ended. Requires webhooks to be enabled on this server: see `webhooks` of `GET /v1/limits`. */
            callback_url?: string | null;
            /** @description Each request names its `kind`. `GET /v1/limits` shows how many requests a batch may have. */
            requests: components["schemas"]["RequestWithKind"][];
        };
        /** @description A tensor-product Bézier patch. */
        Bezier: {
            /** @description Control points: rows along u, each with the points along v. */
            control_points: components["schemas"]["Polyline"][];
        };
        /** @description A point of a boundary, counted from 0. */
        BoundaryPoint: {
            /** @description Default: `0`. */
            boundary?: number;
            point: number;
        };
        /**
         * @description Sampling of the boundary. `refine` may add points on its segments, and `keep` uses only the polygon's vertices.
         * @enum {string}
         */
        BoundarySampling: "refine" | "keep";
        /** @description A cable. Its course is exactly one of `along`, `across` and `points`. */
        Cable: {
            /**
             * @description Points through which the cable runs across the film before form finding, as a ridge or a valley. The first and
             *     the last are points of the boundaries. Cables across the film may share points but must not cross.
             */
            across?: components["schemas"]["Point"][];
            /** @description Part of a boundary along which the cable runs. The film's edge hangs on the cable. */
            along?: components["schemas"]["Along"];
            /**
             * Format: double
             * @description EA, a force. `unstressed_length` needs it; with other modes it gives the unstressed length.
             */
            axial_stiffness?: number | null;
            mode?: components["schemas"]["CableMode"];
            /** @description Name in statistics and warnings. Null means its number, as in `cable 0`. */
            name?: string | null;
            /**
             * @description Two points between which the cable runs in the air. A point that equals a boundary's point, one of `joints` or
             *     the hub of a ring is joined to it; any other point is a support.
             */
            points?: components["schemas"]["Point"][];
            /**
             * Format: double
             * @description Value that the mode holds constant: a force, a force per length (`force_density`) or a length.
             */
            value: number;
            /**
             * Format: double
             * @description Weight per length of the found shape. Default: `0.0`.
             */
            weight?: number;
        };
        /** @description A cable of the found shape. */
        CableForce: {
            /**
             * Format: double
             * @description Mean force, weighted by length.
             */
            force: number;
            /** Format: double */
            force_max: number;
            /** Format: double */
            force_min: number;
            /** Format: double */
            length: number;
            mode: string;
            name: string;
            /**
             * Format: double
             * @description Largest distance from the chord between the ends.
             */
            sag: number;
            /** @description Whether it carries no force. */
            slack: boolean;
            /**
             * Format: double
             * @description Length / (1 + force / axial stiffness); null without an axial stiffness.
             */
            unstressed_length: number | null;
        };
        /**
         * @description Quantity of a cable that is held constant.
         *
         *     - `force`: The force. With a weight, the mean force.
         *     - `end_tension`: The force at the first end.
         *     - `horizontal_component`: The part of the force at the first end that is across the up axis.
         *     - `force_density`: The force divided by the length of the whole cable.
         *     - `length`: The length in the found shape.
         *     - `unstressed_length`: The length without force. The force is EA (length / unstressed length - 1), and 0 if that is negative.
         *     - `sag`: The largest distance from the chord between the ends.
         * @enum {string}
         */
        CableMode: "force" | "end_tension" | "horizontal_component" | "force_density" | "length" | "unstressed_length" | "sag";
        /** @description A job: an accepted request and its state. */
        CableNetJob: {
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Null unless the job has failed. */
            error: components["schemas"]["JobError"] | null;
            /** @description Time at which the job and its mesh are removed. */
            expires_at: string | null;
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "cable_net";
            /** @description Name of the job for people, if the request gave one. */
            label: string | null;
            links: components["schemas"]["Links"];
            /** @description Fields of the client, if the request gave some. */
            metadata: {
                [key: string]: unknown;
            } | null;
            progress: components["schemas"]["Progress"];
            started_at: string | null;
            /** @description Null until the job has succeeded. */
            statistics: components["schemas"]["CableNetStatistics"] | null;
            status: components["schemas"]["Status"];
            warnings: components["schemas"]["JobWarning"][];
        };
        /** @enum {string} */
        CableNetKind: "cable_net";
        /**
         * @description A net of cables without film, whose shape in equilibrium comes nearest to target forces and lengths.
         *
         *     The net is given by its vertices and by the edges between them. Every edge is a straight piece of cable in tension.
         *     Cables are groups of edges with common targets.
         */
        CableNetRequest: {
            /** @description Groups of edges with their targets. Edges that no cable lists have no target. */
            cables?: components["schemas"]["NetCable"][];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /** @description Pairs of vertices that a cable joins, counted from 0. */
            edges: number[][];
            /** @description Optional here, because the path names the kind. `plateau solve` needs it. */
            kind?: components["schemas"]["CableNetKind"] | null;
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /**
             * Format: double
             * @description Lower bound of the force densities that are found, a force per length. If it is above 0, every cable stays in
             *     tension. Otherwise a job fails if its targets leave a cable slack. Default: `0.0`.
             */
            least_force_density?: number;
            /** @description Loads on vertices. Loads of one vertex are added. */
            loads?: components["schemas"]["NetLoad"][];
            /** @description Maximum number of steps. Null means 200, and 200 more if fitting begins a second time. */
            max_iterations?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /** @description Vertices that do not move, counted from 0. */
            supports: number[];
            /**
             * Format: double
             * @description The shape counts as found when three steps in a row each lower the loss by less than this fraction of it. Default: `0.0001`.
             */
            tolerance?: number;
            units?: components["schemas"]["LengthAndForce"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
            /** @description Points of the net: supports where they stay, the other vertices where form finding begins. */
            vertices: components["schemas"]["Point"][];
            weights?: components["schemas"]["TargetWeights"];
        };
        /**
         * @description A net of cables without film, whose shape in equilibrium comes nearest to target forces and lengths.
         *
         *     The net is given by its vertices and by the edges between them. Every edge is a straight piece of cable in tension.
         *     Cables are groups of edges with common targets.
         */
        CableNetRequestWithKind: {
            /** @description Groups of edges with their targets. Edges that no cable lists have no target. */
            cables?: components["schemas"]["NetCable"][];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /** @description Pairs of vertices that a cable joins, counted from 0. */
            edges: number[][];
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "cable_net";
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /**
             * Format: double
             * @description Lower bound of the force densities that are found, a force per length. If it is above 0, every cable stays in
             *     tension. Otherwise a job fails if its targets leave a cable slack. Default: `0.0`.
             */
            least_force_density?: number;
            /** @description Loads on vertices. Loads of one vertex are added. */
            loads?: components["schemas"]["NetLoad"][];
            /** @description Maximum number of steps. Null means 200, and 200 more if fitting begins a second time. */
            max_iterations?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /** @description Vertices that do not move, counted from 0. */
            supports: number[];
            /**
             * Format: double
             * @description The shape counts as found when three steps in a row each lower the loss by less than this fraction of it. Default: `0.0001`.
             */
            tolerance?: number;
            units?: components["schemas"]["LengthAndForce"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
            /** @description Points of the net: supports where they stay, the other vertices where form finding begins. */
            vertices: components["schemas"]["Point"][];
            weights?: components["schemas"]["TargetWeights"];
        };
        /** @description Statistics of a cable net. */
        CableNetStatistics: {
            balance: components["schemas"]["ForceBalance"];
            /** @description Cables in the order of the request, and `other` for edges that no cable lists. */
            cables: components["schemas"]["NetCableResult"][];
            converged: boolean;
            edge_lengths: components["schemas"]["Spread"];
            edges: number;
            /** @description Unit of the forces. */
            force_unit: string;
            /**
             * Format: double
             * @description Largest derivative of the loss by the logarithm of a force density.
             */
            gradient: number;
            iterations: number;
            /**
             * Format: double
             * @description Σ force · length.
             */
            load_path: number;
            objective: string;
            /**
             * Format: double
             * @description Loss: the weighted sum of the mean squared deviations from the targets and of the load path. 0 without targets.
             */
            objective_value: number;
            /** @description Middle of the net's bounding box, which files with `origin=local` are relative to. */
            origin: number[];
            /** @description Supports in the order of the request. */
            reactions: components["schemas"]["NetReaction"][];
            /**
             * Format: double
             * @description Largest force on a free vertex that is not balanced, over the largest force of a cable.
             */
            residual: number;
            stop_reason: string;
            /** @description Always 0: a net has no triangles. */
            triangles: number;
            vertices: number;
        };
        /**
         * @description Whether the result of an equal earlier request may be returned. Results are deterministic, so it has the same bytes.
         *
         *     - `reuse`: Return a stored result if there is one, and store this one for later requests.
         *     - `bypass`: Solve again, and do not store the result for later requests.
         * @enum {string}
         */
        Cache: "reuse" | "bypass";
        /** @enum {string} */
        Caps: "none" | "flat";
        /** @description A proven lower bound of the area of all oriented surfaces with this boundary. */
        Certificate: {
            /**
             * Format: double
             * @description No oriented surface of any topology with this boundary has a smaller area.
             */
            area_lower_bound: number;
            /**
             * Format: double
             * @description The film's area is at most this fraction above the least area. Null if the bound is 0.
             */
            gap: number | null;
            iterations: number;
            /** @description Number of orientations of the loops for which a field was found. */
            orientations: number;
            /** @description The surfaces for which the bound holds. */
            scope: string;
            /**
             * Format: double
             * @description Number of nominal seconds to which the work of the search amounts. No clock is read, so that the result is the same
             *     on every machine.
             */
            seconds: number;
            /** @description The result in words. */
            statement: string;
            /** @description Number of tetrahedra of all fields together. */
            tetrahedra: number;
        };
        /** @description Whether and how to prove a lower bound of the area. */
        Certify: boolean | components["schemas"]["CertifyOptions"];
        /** @description Sharpness of the lower bound, and the limit of the search for it. */
        CertifyOptions: {
            /**
             * Format: double
             * @description The search ends once the film's area is at most this fraction above the bound. Default: `0.005`.
             */
            gap?: number;
            /**
             * Format: double
             * @description Number of nominal seconds of one core that the search may take. They are converted to work by fixed rates, so that
             *     the same request gives the same result on every machine. Default: `2.0`.
             */
            seconds?: number;
        };
        /**
         * @description A closed space below a layer: up to the next layer, or, below the last layer, up to fans from each boundary to its
         *     mean, which stand for the ground. It has exactly one of `pressure` and `volume`.
         */
        Chamber: {
            /** @description Number of the layer, counted from 0. Default: `0`. */
            below?: number;
            /**
             * Format: double
             * @description Pressure above that outside, a force per area.
             */
            pressure?: number;
            /**
             * Format: double
             * @description Volume. The pressure is found.
             */
            volume?: number;
        };
        /** @description A chamber of the found shape. */
        ChamberState: {
            /** @description Number of the layer above it. */
            below: number;
            /**
             * Format: double
             * @description Pressure above that outside, given or found.
             */
            pressure: number;
            /**
             * Format: double
             * @description Volume up to the next layer, or up to fans from each boundary to its mean.
             */
            volume: number;
        };
        CircleGuide: {
            /** @description Normal of the circle's plane. */
            axis: number[];
            centre: components["schemas"]["Point"];
            /** Format: double */
            radius: number;
        };
        /** @description Statistics of one objective's optimum. */
        Comparison: {
            /** Format: double */
            area: number;
            /** Format: double */
            bending_energy: number;
            bridges: number;
            /** Format: double */
            convex_bridge_ratio: number;
            /** @description Number of bridges that are locally convex. */
            convex_bridges: number;
            /**
             * Format: double
             * @description Largest angle between the normals of neighbouring triangles at bridges that are not locally convex. It is 0 for
             *     a strip that can be developed.
             */
            developability_deviation_deg: number;
            /**
             * Format: double
             * @description Largest angle between the normals of neighbouring triangles.
             */
            largest_fold_deg: number;
            /** Format: double */
            longest_bridge: number;
            /** Format: double */
            mean_curvature_variation: number;
            /**
             * Format: double
             * @description Value of `minimal_normal_variation`. Null without normals.
             */
            normal_variation: number | null;
            objective: string;
            /**
             * Format: double
             * @description Value of the objective. For `maximal_convexity` it is the number of convex bridges.
             */
            objective_value: number;
            secondary_objective: string | null;
            /**
             * Format: double
             * @description Value of the secondary objective. Null without one.
             */
            secondary_value: number | null;
            /** Format: double */
            shortest_bridge: number;
            /**
             * Format: double
             * @description Sum of 1 - n_p·n_q over the bridges (Wang-Tang, eq. 4).
             */
            total_normal_twist: number;
            triangles: number;
        };
        /** @description Fixed points and curves inside the surface. They become vertices and edges of the mesh. */
        Constraints: {
            /** @description Default: `[]`. */
            points?: components["schemas"]["Point"][];
            /** @description Default: `[]`. */
            polylines?: components["schemas"]["Polyline"][];
        };
        CylinderGuide: {
            axis: components["schemas"]["Point"];
            /** @description A point of the axis. */
            point: number[];
            /** Format: double */
            radius: number;
        };
        /** @enum {string} */
        Direction: "as_given" | "auto";
        /** @description Domain of the mesh: exactly one of `polygon` (with or without `holes`), `bezier`, `nurbs` and `boundaries`. */
        Domain: {
            bezier?: components["schemas"]["Bezier"];
            /** @description Closed polygons. The domain is the minimal surface that spans them. */
            boundaries?: components["schemas"]["Polygon"][];
            /** @description Holes of the polygon. Default: `[]`. */
            holes?: components["schemas"]["Polygon"][];
            nurbs?: components["schemas"]["Nurbs"];
            /** @description A planar polygon in space that does not repeat its first point. */
            polygon?: components["schemas"]["Point"][];
        };
        /** @description The supports along the fixed parts of a boundary together. */
        EdgeReaction: {
            boundary: number;
            /** @description Force of the supports on the structure. */
            force: number[];
        };
        /** @description Second variation of the energy. */
        EquilibriumStability: {
            /**
             * Format: double
             * @description Lowest eigenvalue with respect to the lumped mass, in 1/unit².
             */
            lowest_eigenvalue: number;
            morse_index: number;
            /** @description Whether the Morse index is 0: a true local minimum. */
            stable: boolean;
        };
        /** @description Address at which the events of a job can be followed without a key. */
        EventTicket: {
            /** @description Address of the job's events with a ticket in it. */
            events: string;
            /** @description Time until which the address opens a stream (RFC 3339, UTC). */
            expires_at: string;
        };
        /** @description An example request. */
        Example: {
            kind: components["schemas"]["Kind"];
            name: string;
            /** @description Request to post to the path of its kind. */
            request: components["schemas"]["RequestWithKind"];
            title: string;
        };
        ExampleList: {
            examples: components["schemas"]["ExampleSummary"][];
        };
        ExampleSummary: {
            kind: components["schemas"]["Kind"];
            name: string;
            title: string;
        };
        /** @description Area of the smooth surface on the same polygon, extrapolated from two resolutions. */
        ExtrapolatedArea: {
            /** Format: double */
            area: number;
            /**
             * Format: double
             * @description Estimate of the error of that area.
             */
            error_estimate: number;
        };
        /** @description One offending value of a body. Values are never echoed. */
        FieldError: {
            /** @description Description of the error. */
            detail: string;
            /** @description JSON Pointer (RFC 6901) to the offending value. */
            pointer: string;
        };
        /** @description Principal stresses of the film. */
        FilmStress: {
            /**
             * Format: double
             * @description Largest deviation of a principal stress from the required tension, as a fraction of it. It falls with the edge
             *     length. With warp and weft that of their stresses from those required at the same place.
             */
            deviation: number;
            /** Format: double */
            max: number;
            /** Format: double */
            min: number;
            /** @description Null for an isotropic tension. */
            weave: components["schemas"]["WeaveStress"] | null;
        };
        /** @description Quality of the strips' flat pattern. */
        FlatPatternStatistics: {
            /**
             * Format: double
             * @description Largest relative difference between an edge's length in space and in the plane.
             */
            edge_length_error_max: number;
            /** Format: double */
            height: number;
            /** @description Whether an unrolled strip overlaps itself. */
            self_overlap: boolean;
            /** Format: double */
            width: number;
        };
        /** @description Sums of the forces. */
        ForceBalance: {
            /**
             * Format: double
             * @description |loads + reactions| / magnitudes.
             */
            imbalance: number;
            /** @description Sum of all loads: weights and pressure. */
            loads: number[];
            /**
             * Format: double
             * @description Sum of the reactions' magnitudes, vertex by vertex.
             */
            magnitudes: number;
            /** @description Sum of all reactions. */
            reactions: number[];
            /**
             * Format: double
             * @description Largest force on a vertex that is not balanced.
             */
            residual_force: number;
        };
        /**
         * @description Unit of the client's forces. A film's tension is a force per unit of length, and a pressure a force per unit of area.
         * @enum {string}
         */
        ForceUnit: "N" | "kN" | "MN" | "lbf" | "kip";
        /**
         * @description The client's own initial mesh. It is either an oriented manifold whose boundary loops are `boundaries`, with or
         *     without further vertices on their segments, or a film whose sheets meet three by three along edges with three
         *     triangles. In a film, the edges with one triangle must be the segments of `boundaries`, which may share points.
         *     `resolution` has no effect in either case.
         */
        GivenMesh: {
            /** @description Vertex indices of each triangle, counted from 0. */
            triangles: number[][];
            vertices: components["schemas"]["Polygon"];
        };
        /** @description A named objective, or a weighted sum. */
        Goal: components["schemas"]["RuledSurfaceObjective"] | components["schemas"]["WeightedSum"];
        /** @description Count, minimum, mean, maximum and standard deviation of a group of lengths. All are 0 for an empty group. */
        GroupLengths: {
            count: number;
            /** Format: double */
            max: number;
            /** Format: double */
            mean: number;
            /** Format: double */
            min: number;
            /** Format: double */
            std_dev: number;
        };
        /**
         * @description A line or surface to slide on, given by exactly one of its fields. Edges slide on surfaces only. Directions need no
         *     unit length.
         */
        Guide: {
            circle?: components["schemas"]["CircleGuide"];
            cylinder?: components["schemas"]["CylinderGuide"];
            line?: components["schemas"]["LineGuide"];
            mesh?: components["schemas"]["MeshGuide"];
            plane?: components["schemas"]["PlaneGuide"];
            sphere?: components["schemas"]["SphereGuide"];
        };
        /** @description One iteration of the solver. */
        HistoryRow: {
            /** Format: double */
            area: number;
            iteration: number;
            phase: string;
            /** Format: double */
            residual: number;
        };
        /** @description The values of a component's outputs. */
        HopsAnswer: {
            /** @description Lines that name an input. */
            errors: string[];
            values: components["schemas"]["HopsTree"][];
            /** @description Warnings of the job. */
            warnings: string[];
        };
        /** @description A component of Hops. */
        HopsComponent: {
            /** @description Category. */
            Category?: string;
            /** @description Tooltip. */
            Description?: string;
            /** @description PNG in base64. */
            Icon?: string;
            Inputs: components["schemas"]["HopsParameter"][];
            /** @description Name. */
            Name: string;
            /** @description Short name. */
            Nickname?: string;
            Outputs: components["schemas"]["HopsParameter"][];
            /** @description Part of the category. */
            Subcategory?: string;
            /** @description Path of the component. */
            Uri: string;
        };
        /** @description A value of an input or output. */
        HopsItem: {
            /** @description The value as JSON text. Curves and meshes are openNURBS objects. */
            data: string;
            /** @description .NET type of the value. */
            type?: string;
        };
        /** @description The values of a component's inputs. Hops sends further fields, which are not used. */
        HopsMessage: {
            /** @description Distance up to which the ends of a curve count as equal. */
            absolutetolerance?: number;
            /** @description Name of the component, or its path or address. */
            pointer: string;
            values: components["schemas"]["HopsTree"][];
        };
        /** @description An input or output of a component of Hops. */
        HopsParameter: {
            /** @description Smallest number of values. */
            AtLeast: number;
            /** @description Largest number of values. */
            AtMost: number;
            /** @description Value of an input that is left alone: a number, a boolean or a text. */
            Default?: unknown;
            /** @description Tooltip. */
            Description?: string;
            /** @description Name in messages. */
            Name: string;
            /** @description Short name. */
            Nickname?: string;
            /** @description Name of the parameter's type in Grasshopper. */
            ParamType: string;
            /** @description .NET type of the values. */
            ResultType?: string;
        };
        /** @description The values of an input or output. */
        HopsTree: {
            /** @description Values by branch, such as `{0}`. */
            InnerTree: {
                [key: string]: components["schemas"]["HopsItem"][];
            };
            /** @description Name of the input or output. */
            ParamName: string;
        };
        /** @description Mesh that the solver starts from: built by the service, or supplied by the client. */
        InitialMesh: components["schemas"]["MadeMesh"] | components["schemas"]["GivenMesh"];
        /** @description A job: an accepted request and its state. */
        Job: components["schemas"]["RuledSurfaceJob"] | components["schemas"]["MinimalSurfaceJob"] | components["schemas"]["UniformMeshJob"] | components["schemas"]["TensileStructureJob"] | components["schemas"]["CableNetJob"];
        /** @description Reason for a failure: what was wrong with the geometry, and what to try. */
        JobError: {
            detail: string;
            errors: components["schemas"]["FieldError"][];
            title: string;
            /** @description Stable URI reference that identifies the kind of failure. */
            type: string;
        };
        /** @description One page of jobs, newest first. */
        JobList: {
            jobs: components["schemas"]["JobSummary"][];
            /** @description Value of `?cursor=` for the next page; null on the last page. */
            next_cursor: string | null;
        };
        /** @description A job of a list. */
        JobSummary: {
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Null unless the job has failed. */
            error: components["schemas"]["JobError"] | null;
            /** @description Time at which the job and its mesh are removed. */
            expires_at: string | null;
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            kind: components["schemas"]["Kind"];
            /** @description Name of the job for people, if the request gave one. */
            label: string | null;
            links: components["schemas"]["Links"];
            /** @description Fields of the client, if the request gave some. */
            metadata: {
                [key: string]: unknown;
            } | null;
            progress: components["schemas"]["Progress"];
            started_at: string | null;
            /**
             * @description Statistics of a job that has succeeded. Absent unless the list was asked for with `statistics=true`. The fields
             *     depend on the kind.
             */
            statistics?: {
                [key: string]: unknown;
            };
            status: components["schemas"]["Status"];
            warnings: components["schemas"]["JobWarning"][];
        };
        /** @description A warning about the input or the result of a job that succeeded. */
        JobWarning: {
            /** @description Stable name in snake case. */
            code: string;
            detail: string;
        };
        /** @description Curves along which three sheets of a film meet, and the balance of the sheets there. */
        Junctions: {
            /**
             * @description Curves along which three sheets meet, each as vertices of the mesh (counted from 0) from end to end. A closed
             *     curve ends with its first vertex.
             */
            curves: number[][];
            /** @description Number of mesh edges with three triangles. */
            edges: number;
            /** @description Angles between neighbouring triangles around the junctions' edges. */
            facet_angles_deg: components["schemas"]["Spread"];
            /**
             * Format: double
             * @description The same at the vertices next to an end, where it may hardly decrease with the mesh size. It is 0 if there are
             *     no such vertices.
             */
            largest_deviation_at_ends_deg: number;
            /**
             * Format: double
             * @description Largest departure of `sheet_angles_deg` from 120° at the vertices that are not next to an end of their junction.
             */
            largest_deviation_deg: number;
            /**
             * Format: double
             * @description Total length of these curves.
             */
            length: number;
            /**
             * Format: double
             * @description Mean departure of `sheet_angles_deg` from 120° over all these vertices.
             */
            mean_deviation_deg: number;
            /** @description Number of negative eigenvalues of the second variation with moving junctions. Null if it was not computed. */
            morse_index: number | null;
            /** @description Number of vertices inside the film where such curves meet. */
            points: number;
            /**
             * Format: double
             * @description Largest net pull of the sheets across a junction per length. It is 0 if the sheets balance, and 1 for a single
             *     sheet.
             */
            residual: number;
            /** @description Angles between the pulls of neighbouring sheets at the junctions' inner vertices. */
            sheet_angles_deg: components["schemas"]["Spread"];
            /** @description Number of parts of the film that are connected without crossing a junction. */
            sheets: number;
        };
        /**
         * @description Kind of a request.
         * @enum {string}
         */
        Kind: "ruled_surface" | "minimal_surface" | "uniform_mesh" | "tensile_structure" | "cable_net";
        /** @description A layer of the found shape. In the mesh its triangles follow those of the layers before it. */
        LayerFigures: {
            /** Format: double */
            area: number;
            /** @description Null if the forces could not be balanced. */
            stress: components["schemas"]["FilmStress"] | null;
            triangles: number;
        };
        /**
         * @description Units of lengths and forces. A tension is a force per length, a weight of a film and a pressure a force per area, a
         *     weight of a cable a force per length, and an axial stiffness a force.
         */
        LengthAndForce: {
            /** @description Default: `kN`. */
            force?: components["schemas"]["ForceUnit"];
            /** @description Default: `m`. */
            length?: components["schemas"]["Units"];
        };
        /** @description Histogram of lengths. Bin k counts lengths from `from` + k · `width` up to the next bin. */
        LengthHistogram: {
            counts: number[];
            /** Format: double */
            from: number;
            /** Format: double */
            width: number;
        };
        /** @description Limits of one request on this server. */
        Limits: {
            /** @description Largest number of requests of one batch. */
            batch_requests: number;
            /** @description Largest size of a request's body in bytes. */
            body_bytes: number;
            /** @description Time that a solver has, in milliseconds. After it the solver returns the best mesh that it has reached. */
            deadline_ms: number;
            /** @description Largest number of cells of the grids of all strips of a ruled surface. */
            grid_cells: number;
            /** @description Largest `max_iterations`. */
            iterations: number;
            /** @description Largest number of points of all polylines of a request, and of vertices of a cable net. */
            points: number;
            /** @description Number of jobs that may wait in the queue. */
            queue_length: number;
            /** @description Time in seconds after its end at which a job is removed with its mesh. 0 means never. */
            retention_s: number;
            /** @description Largest number of triangles of a minimal surface, a uniform mesh or a tensile structure, and of edges of a cable net. */
            triangles: number;
            /** @description Longest wait that `Prefer: wait` can ask for, in seconds. */
            wait_max_s: number;
            /** @description Whether requests may name a `callback_url`. */
            webhooks: boolean;
        };
        LineGuide: {
            direction: components["schemas"]["Point"];
            point: components["schemas"]["Point"];
        };
        /** @description A number for each line. */
        LineValues: {
            name: string;
            /** @description Empty for plain numbers. */
            unit: string;
            values: number[];
        };
        /**
         * @description Linear solver. `direct` always uses elimination. `conjugate_gradients` uses elimination only if the conjugate
         *     gradients do not converge.
         * @enum {string}
         */
        LinearSolver: "direct" | "conjugate_gradients";
        /** @description Addresses that belong to a job. */
        Links: {
            cancel: string;
            /** @description Address of the proof of the area's lower bound. Only minimal surfaces have it, and only if the request has `certify`. */
            certificate?: string | null;
            events: string;
            /** @description Address of the mesh. Absent from failed and cancelled jobs. */
            mesh?: string | null;
            /** @description Address of the flat pattern. Only ruled surfaces have it, and it is absent from failed and cancelled jobs. */
            pattern?: string | null;
            self: string;
        };
        /**
         * @description Construction of the initial mesh. The statistics name the construction that `auto` chose.
         *
         *     - `auto`: Chooses the best of the others for these boundaries.
         *     - `planar`: Delaunay triangulation in a plane onto which the boundary projects without crossing itself.
         *     - `disk`: Delaunay triangulation of a round disc, mapped harmonically.
         *     - `rings`: Rings of vertices (Chen, Cai, Zheng, section 3.4).
         *     - `barycentres`: Liu, Wang.
         * @enum {string}
         */
        MadeMesh: "auto" | "planar" | "disk" | "rings" | "barycentres";
        /**
         * @description A straight member between two points that may push. A point that equals a boundary's point, one of `joints` or the
         *     hub of a ring is joined to it; any other point is a support. At least one end is no support.
         */
        Mast: {
            mode?: components["schemas"]["MastMode"];
            /** @description Name in statistics and warnings. Null means its number, as in `mast 0`. */
            name?: string | null;
            points: components["schemas"]["Point"][];
            /**
             * Format: double
             * @description Value that the mode holds constant: a length, or the force with which the mast pushes.
             */
            value: number;
        };
        /** @description A mast of the found shape. */
        MastForce: {
            /**
             * Format: double
             * @description Force with which the mast pushes; negative if it pulls.
             */
            force: number;
            /** Format: double */
            length: number;
            mode: string;
            name: string;
        };
        /**
         * @description Quantity of a mast that is held constant.
         *
         *     - `length`: The length. The force is found, and negative if the mast has to pull.
         *     - `force`: The force with which the mast pushes. The length is found.
         * @enum {string}
         */
        MastMode: "length" | "force";
        MeanCurvature: {
            /** Format: double */
            max: number;
            /** Format: double */
            mean: number;
            /** Format: double */
            rms: number;
        };
        /** @description A mesh in the axes and the unit of its request. */
        Mesh: {
            attributes: components["schemas"]["MeshAttributes"];
            /** @description For each polyline of the request, the vertices that its points became. */
            input_vertices: number[][];
            lines: components["schemas"]["MeshLines"][];
            /** @description Point that the vertices are relative to. It is zero unless the file was asked for with `origin=local`. */
            origin: number[];
            /** @description Three indices of vertices for each triangle, counted from 0. A cable net has none. */
            triangles: number[][];
            unit: components["schemas"]["Units"];
            up: components["schemas"]["UpAxis"];
            /** @description The request's own points come first, in their order. */
            vertices: components["schemas"]["Point"][];
        };
        /** @description Numbers at the vertices. */
        MeshAttributes: {
            /** @description Unsigned mean curvature of each vertex in 1/unit. Only minimal surfaces have it. */
            mean_curvature?: number[];
        };
        /** @description A smooth surface along the client's own mesh. Neighbouring triangles are oriented alike. */
        MeshGuide: {
            /**
             * Format: double
             * @description Length within which the mesh's edges are rounded, because a film cannot slide over a sharp edge. For a mesh of a
             *     curved surface two to three times the length of its edges.
             */
            rounding: number;
            /** @description Vertex indices of each triangle, counted from 0. */
            triangles: number[][];
            vertices: components["schemas"]["Polygon"];
        };
        /** @description Lines along the mesh. */
        MeshLines: {
            /** @description Straight lines whose ends are no vertices of the mesh, such as those of `reactions`: two points each. */
            arrows: components["schemas"]["Point"][][];
            /**
             * @description `boundaries`, `junctions`, `directrices`, `bridges`, `members lattice`, `members rim`, `reactions`, or `cables` with
             *     the cable's name, such as `cables ridge`.
             */
            name: string;
            /** @description Each line as the vertices along it. A closed line ends with its first vertex. */
            paths: number[][];
            /** @description A number for each line, such as its length. Null if the lines have none. */
            values: components["schemas"]["LineValues"] | null;
        };
        /**
         * @description Statistics of a minimal surface. Lengths are in the request's unit, areas in its square, curvatures in its inverse,
         *     and angles in degrees.
         */
        MinimalStatistics: {
            angles_deg: components["schemas"]["AngleRange"];
            /** Format: double */
            area: number;
            boundary_loops: number;
            /** @description Proven lower bound of the area. Null without `certify`. */
            certificate: components["schemas"]["Certificate"] | null;
            components: number;
            converged: boolean;
            degenerate_triangles: number;
            edge_lengths: components["schemas"]["Spread"];
            edges_swapped: number;
            /** Format: int64 */
            euler_characteristic: number;
            /** @description Null if the boundary's points do not allow a second resolution, and for unstable surfaces. */
            extrapolated_area: components["schemas"]["ExtrapolatedArea"] | null;
            flipped_triangles: number;
            /**
             * Format: int64
             * @description Null for films with junctions, for which it is not defined.
             */
            genus: number | null;
            history: components["schemas"]["HistoryRow"][];
            /**
             * Format: double
             * @description Area of the initial mesh.
             */
            initial_area: number;
            /** @description Initial mesh that was built. */
            initial_mesh: string;
            iterations: number;
            /** @description Null unless the initial mesh of the film has edges with three triangles. */
            junctions: components["schemas"]["Junctions"] | null;
            mean_curvature: components["schemas"]["MeanCurvature"];
            objective: string;
            /** Format: double */
            objective_value: number;
            /** @description Middle of the mesh's bounding box, which files with `origin=local` are relative to. */
            origin: number[];
            /** @description Changes of topology in the order in which they happened. */
            pinches: components["schemas"]["Pinch"][];
            /**
             * Format: double
             * @description Largest normal mean curvature times the boundary's radius, which is dimensionless.
             */
            residual: number;
            /**
             * Format: double
             * @description The same including the tangential part of the area gradient.
             */
            residual_full: number;
            /**
             * @description Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded
             *     mesh. Null if not all pairs were looked at.
             */
            self_intersections: number | null;
            /** @description Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`. */
            self_intersections_skipped: string | null;
            /** @description Solver that was used. */
            solver: string;
            /** @description Null without `topology: best`. */
            spanning: components["schemas"]["Spanning"] | null;
            /** @description Null if it was not computed. */
            stability: components["schemas"]["Stability"] | null;
            stop_reason: string;
            triangles: number;
            vertices: number;
        };
        /** @description A job: an accepted request and its state. */
        MinimalSurfaceJob: {
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Null unless the job has failed. */
            error: components["schemas"]["JobError"] | null;
            /** @description Time at which the job and its mesh are removed. */
            expires_at: string | null;
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "minimal_surface";
            /** @description Name of the job for people, if the request gave one. */
            label: string | null;
            links: components["schemas"]["Links"];
            /** @description Fields of the client, if the request gave some. */
            metadata: {
                [key: string]: unknown;
            } | null;
            progress: components["schemas"]["Progress"];
            started_at: string | null;
            /** @description Null until the job has succeeded. */
            statistics: components["schemas"]["MinimalStatistics"] | null;
            status: components["schemas"]["Status"];
            warnings: components["schemas"]["JobWarning"][];
        };
        /** @enum {string} */
        MinimalSurfaceKind: "minimal_surface";
        /**
         * @description Quantity that is minimised. `GET /v1/objectives` has the formulas.
         * @enum {string}
         */
        MinimalSurfaceObjective: "minimal_area" | "minimal_dirichlet_energy" | "minimal_mean_curvature";
        /** @description Boundary polygons, and options for the surface that spans them. */
        MinimalSurfaceRequest: {
            /**
             * Format: double
             * @description Relative change of area per iteration at which `vertex_relaxation` and `pinkall_polthier` stop. Default: `1e-6`.
             */
            area_tolerance?: number;
            /** @description Closed polygons that do not repeat their first point. */
            boundaries: components["schemas"]["Polygon"][];
            /**
             * @description Whether `minimal_mean_curvature` includes the curvature at the boundary's vertices, as Liu and Wang's formula
             *     does. The film then leaves the minimal surface beside the boundary. Default: `false`.
             */
            boundary_curvature?: boolean;
            boundary_sampling?: components["schemas"]["BoundarySampling"];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /**
             * @description Whether to prove a lower bound of the area of all oriented surfaces with this boundary: `true`, or how sharp the
             *     bound is to be and how long the search may take. Only for `minimal_area`.
             */
            certify?: components["schemas"]["Certify"];
            constraints?: components["schemas"]["Constraints"];
            /**
             * Format: double
             * @description Smallest allowed angle in degrees. `pinkall_polthier` and `topology: free` remove triangles with a smaller
             *     angle. 0 removes none. Default: `1.0`.
             */
            degenerate_angle_deg?: number;
            /**
             * Format: double
             * @description Relative change of area at which the Laplacian fairing of `vertex_relaxation` stops. Null means
             *     `area_tolerance`.
             */
            fairing_tolerance?: number | null;
            initial_mesh?: components["schemas"]["InitialMesh"];
            /** @description Optional here, because the path names the kind. `plateau solve` needs it. */
            kind?: components["schemas"]["MinimalSurfaceKind"] | null;
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /** @description Method by which `pinkall_polthier` solves its linear systems. */
            linear_solver?: components["schemas"]["LinearSolver"];
            /** @description Maximum number of iterations. Null means the solver's default. */
            max_iterations?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            objective?: components["schemas"]["MinimalSurfaceObjective"];
            on_unstable?: components["schemas"]["OnUnstable"];
            /**
             * @description Stages of `vertex_relaxation` in order. Each is repeated until its tolerance is reached. Null means the paper's
             *     stages.
             */
            processes?: components["schemas"]["ProcessStage"][] | null;
            /** @description Resolution of the mesh. If absent, 2,000 triangles, or four for each boundary point where those are more. */
            resolution?: components["schemas"]["Resolution"];
            /** @description Seed of the choice among the candidate points of `initial_mesh: barycentres`. Default: `1`. */
            seed?: number;
            /** @description Method that minimises the area. */
            solver?: components["schemas"]["Solver"];
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /**
             * Format: double
             * @description Residual (largest normal mean curvature times the boundary's radius) at which a surface counts as converged. Default: `1e-6`.
             */
            tolerance?: number;
            topology?: components["schemas"]["Topology"];
            /** @description Unit of the coordinates. Default: `m`. */
            units?: components["schemas"]["Units"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
        };
        /** @description Boundary polygons, and options for the surface that spans them. */
        MinimalSurfaceRequestWithKind: {
            /**
             * Format: double
             * @description Relative change of area per iteration at which `vertex_relaxation` and `pinkall_polthier` stop. Default: `1e-6`.
             */
            area_tolerance?: number;
            /** @description Closed polygons that do not repeat their first point. */
            boundaries: components["schemas"]["Polygon"][];
            /**
             * @description Whether `minimal_mean_curvature` includes the curvature at the boundary's vertices, as Liu and Wang's formula
             *     does. The film then leaves the minimal surface beside the boundary. Default: `false`.
             */
            boundary_curvature?: boolean;
            boundary_sampling?: components["schemas"]["BoundarySampling"];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /**
             * @description Whether to prove a lower bound of the area of all oriented surfaces with this boundary: `true`, or how sharp the
             *     bound is to be and how long the search may take. Only for `minimal_area`.
             */
            certify?: components["schemas"]["Certify"];
            constraints?: components["schemas"]["Constraints"];
            /**
             * Format: double
             * @description Smallest allowed angle in degrees. `pinkall_polthier` and `topology: free` remove triangles with a smaller
             *     angle. 0 removes none. Default: `1.0`.
             */
            degenerate_angle_deg?: number;
            /**
             * Format: double
             * @description Relative change of area at which the Laplacian fairing of `vertex_relaxation` stops. Null means
             *     `area_tolerance`.
             */
            fairing_tolerance?: number | null;
            initial_mesh?: components["schemas"]["InitialMesh"];
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "minimal_surface";
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /** @description Method by which `pinkall_polthier` solves its linear systems. */
            linear_solver?: components["schemas"]["LinearSolver"];
            /** @description Maximum number of iterations. Null means the solver's default. */
            max_iterations?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            objective?: components["schemas"]["MinimalSurfaceObjective"];
            on_unstable?: components["schemas"]["OnUnstable"];
            /**
             * @description Stages of `vertex_relaxation` in order. Each is repeated until its tolerance is reached. Null means the paper's
             *     stages.
             */
            processes?: components["schemas"]["ProcessStage"][] | null;
            /** @description Resolution of the mesh. If absent, 2,000 triangles, or four for each boundary point where those are more. */
            resolution?: components["schemas"]["Resolution"];
            /** @description Seed of the choice among the candidate points of `initial_mesh: barycentres`. Default: `1`. */
            seed?: number;
            /** @description Method that minimises the area. */
            solver?: components["schemas"]["Solver"];
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /**
             * Format: double
             * @description Residual (largest normal mean curvature times the boundary's radius) at which a surface counts as converged. Default: `1e-6`.
             */
            tolerance?: number;
            topology?: components["schemas"]["Topology"];
            /** @description Unit of the coordinates. Default: `m`. */
            units?: components["schemas"]["Units"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
        };
        /** @description Edges with common targets. Targets are met in least squares, and `force_density` exactly. */
        NetCable: {
            /**
             * Format: double
             * @description EA, a force. It gives the unstressed length.
             */
            axial_stiffness?: number | null;
            /** @description Numbers of its edges, counted from 0. Null means all edges that no other cable lists. */
            edges?: number[] | null;
            /**
             * Format: double
             * @description Force that each edge is to have.
             */
            force?: number | null;
            /**
             * Format: double
             * @description Force over length of each edge, which is held. Not together with `force` or `length`.
             */
            force_density?: number | null;
            /**
             * Format: double
             * @description Length that each edge is to have in the found shape.
             */
            length?: number | null;
            /** @description Name in statistics and files. Null means its number, as in `cable 0`. */
            name?: string | null;
        };
        /** @description A cable of the found net: all its edges together. */
        NetCableResult: {
            edge_lengths: components["schemas"]["ValueRange"];
            /** @description Number of its edges. */
            edges: number;
            /**
             * Format: double
             * @description Mean force, weighted by length.
             */
            force: number;
            force_densities: components["schemas"]["ValueRange"];
            /**
             * Format: double
             * @description Largest |force / target - 1|; null without a target.
             */
            force_deviation: number | null;
            /** Format: double */
            force_max: number;
            /** Format: double */
            force_min: number;
            /**
             * Format: double
             * @description Sum of the edges' lengths.
             */
            length: number;
            /**
             * Format: double
             * @description Largest |length / target - 1|; null without a target.
             */
            length_deviation: number | null;
            name: string;
            /** @description Number of edges to which the targets leave no force, so that only `least_force_density` keeps them in tension. */
            slack_edges: number;
            /**
             * Format: double
             * @description Sum of the edges' unstressed lengths, length / (1 + force / axial stiffness) each; null without an axial stiffness.
             */
            unstressed_length: number | null;
        };
        /** @description A load, the same on each of its vertices. */
        NetLoad: {
            /** @description Force on each of the vertices. */
            force: number[];
            /** @description Vertices on which the load acts. Null means all vertices that are no supports. */
            vertices?: number[] | null;
        };
        /** @description A support of the net. */
        NetReaction: {
            /** @description Force of the support on the net. */
            force: number[];
            vertex: number;
        };
        /** @description A NURBS patch. */
        Nurbs: {
            /** @description Control points: rows along u, each with the points along v. */
            control_points: components["schemas"]["Polyline"][];
            /** @description Degrees along u and along v. */
            degrees: number[];
            /** @description Knots along u and along v: control points + degree + 1 each, in non-decreasing order. */
            knots: number[][];
            /** @description Trimmed patches are not supported, so only null or an empty list is accepted. */
            trim_curves?: unknown[] | null;
            /** @description Weights in the shape of the control points. Null means equal weights. */
            weights?: number[][] | null;
        };
        /** @description One objective of one kind of request. */
        Objective: {
            kind: components["schemas"]["Kind"];
            /** @description Quantity that is minimised or maximised, as a formula in words and symbols. */
            minimises: string;
            name: string;
            /** @description Names of the request's fields that change the solution. */
            options: string[];
            /** @description Author, section and equation. */
            source: string;
            /** @description Unit of the objective's value, where `u` is the client's unit. */
            unit: string;
        };
        ObjectiveList: {
            objectives: components["schemas"]["Objective"][];
        };
        /**
         * @description Treatment of a stationary surface that is not a local minimum. `report` adds a warning, and `descend` leaves it
         *     along its most unstable mode.
         * @enum {string}
         */
        OnUnstable: "report" | "descend";
        /**
         * @description `nodes` brings the members of the lattice as near to the edge length as possible. `lengths` then also reduces all
         *     members to at most `max_distinct_lengths` lengths.
         * @enum {string}
         */
        Optimise: "nodes" | "lengths";
        /** @description A member outside the range from the edge length to its double. */
        OutOfRange: {
            /** Format: double */
            length: number;
            vertices: number[];
            /** @description Reason: `short_side`, `sharp_corner`, `narrow`, `curvature`, `optimised` or `unfinished`. */
            why: string;
        };
        /** @description A change of topology. */
        Pinch: {
            iteration: number;
            /** @description Place of the change in the request's unit and axes. */
            place: number[];
            /**
             * @description Kind of the change: `split` (a component became two), `handle_cut` (it stayed one) or
             *     `closed_component_removed`.
             */
            what: string;
        };
        PlaneGuide: {
            normal: components["schemas"]["Point"];
            point: components["schemas"]["Point"];
        };
        /** @description A point or vector `[x, y, z]` in the client's axes and unit. */
        Point: number[];
        /** @description The points of a closed polygon in order. The first point is not repeated. */
        Polygon: components["schemas"]["Point"][];
        /** @description Points in order. */
        Polyline: components["schemas"]["Point"][];
        /** @description Water that stands on the film after rain, in all hollows from which it cannot run off over an edge. */
        Ponding: {
            /**
             * Format: double
             * @description Area of the water's surface.
             */
            area: number;
            /** @description Deepest place. */
            at: number[];
            /**
             * Format: double
             * @description Depth of the water at its deepest place.
             */
            depth: number;
            /**
             * Format: double
             * @description Volume of the water. Times 9.81 kN/m³ it is the water's weight.
             */
            volume: number;
        };
        /** @description A problem document, RFC 9457. */
        Problem: {
            detail: string;
            /** @description Offending values of the body, at most 50. */
            errors?: components["schemas"]["FieldError"][];
            /** @description True if there were more errors than are listed. */
            errors_omitted?: boolean;
            /** @description Path of the request. */
            instance: string;
            /** @description HTTP status of the response. */
            status: number;
            title: string;
            /** @description Stable URI reference that identifies the kind of problem. */
            type: string;
        };
        /**
         * @description A process of vertex relaxation.
         * @enum {string}
         */
        Process: "laplacian_fairing" | "area_minimising" | "edge_swapping";
        /** @description One process, or several that take turns. */
        ProcessStage: components["schemas"]["Process"] | components["schemas"]["Process"][];
        /** @description Progress of a job. */
        Progress: {
            /**
             * Format: double
             * @description Fraction of the work that is done, from 0 to 1. It never falls within one attempt.
             */
            fraction: number;
            iteration: number;
            /** Format: double */
            objective_value: number | null;
            /** @description Name of the solver's current phase. */
            phase: string;
            /** Format: double */
            residual: number | null;
        };
        /** @description The weft runs around an axis and the warp away from it. The axis must not pass through the film. */
        RadialDirection: {
            axis: components["schemas"]["Point"];
            /** @description A point of the axis. */
            point: number[];
        };
        /** @description A request that names its kind. */
        RequestWithKind: components["schemas"]["RuledSurfaceRequestWithKind"] | components["schemas"]["MinimalSurfaceRequestWithKind"] | components["schemas"]["UniformMeshRequestWithKind"] | components["schemas"]["TensileStructureRequestWithKind"] | components["schemas"]["CableNetRequestWithKind"];
        /** @description Resolution of the mesh, given by exactly one of the three fields. */
        Resolution: {
            /**
             * Format: double
             * @description Mean edge length in the request's unit.
             */
            edge_length?: number;
            /** @description Number of vertices that are not on the boundary. */
            interior_vertices?: number;
            /** @description Number of triangles. It is exact for `rings` with `keep`, and otherwise met within 10%. */
            triangles?: number;
        };
        /**
         * @description `bounded` keeps the members between the edge length and its double wherever possible. `free` does not limit them, as
         *     in the paper.
         * @enum {string}
         */
        Rim: "bounded" | "free";
        /** @description A boundary that is a rigid ring, guided along an axis without friction. It turns nowhere. */
        Ring: {
            /** @description Direction in which the ring moves. It needs no unit length. */
            axis: number[];
            boundary: number;
            /**
             * Format: double
             * @description Force on the ring along the axis, from outside. Default: `0.0`.
             */
            force?: number;
            /** @description Point in the air that moves with the ring. Masts and cables may end there. */
            hub?: number[];
        };
        /** @description A ring of the found shape. */
        RingPosition: {
            boundary: number;
            /**
             * Format: double
             * @description Distance that the ring has moved along its axis.
             */
            travel: number;
        };
        /** @description Statistics of a ruled surface. */
        RuledStatistics: {
            /** Format: double */
            area: number;
            /** Format: double */
            bending_energy: number;
            bridges: number;
            /** @description Statistics of each objective's optimum (Wang-Tang's Table 1). Null without `all_objectives`. */
            comparison: components["schemas"]["Comparison"][] | null;
            /** Format: double */
            convex_bridge_ratio: number;
            /** @description Number of bridges that are locally convex. */
            convex_bridges: number;
            /**
             * Format: double
             * @description Largest angle between the normals of neighbouring triangles at bridges that are not locally convex. It is 0 for
             *     a strip that can be developed.
             */
            developability_deviation_deg: number;
            /** @description Null for closed strips, which cannot be unrolled. */
            flat_pattern: components["schemas"]["FlatPatternStatistics"] | null;
            /**
             * Format: double
             * @description Largest angle between the normals of neighbouring triangles.
             */
            largest_fold_deg: number;
            /** Format: double */
            longest_bridge: number;
            /** Format: double */
            mean_curvature_variation: number;
            /**
             * Format: double
             * @description Value of `minimal_normal_variation`. Null without normals.
             */
            normal_variation: number | null;
            /** @description Name of the objective, or `weighted` for a weighted sum. */
            objective: string;
            /**
             * Format: double
             * @description Value of the objective. For `maximal_convexity` it is the number of convex bridges.
             */
            objective_value: number;
            /** @description Middle of the mesh's bounding box, which files with `origin=local` are relative to. */
            origin: number[];
            /** @description For each directrix, whether `direction: auto` reversed it. */
            reversed: boolean[];
            /**
             * Format: double
             * @description Value of the secondary objective. Null without one.
             */
            secondary_value: number | null;
            /**
             * @description Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded
             *     mesh. Null if not all pairs were looked at.
             */
            self_intersections: number | null;
            /** @description Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`. */
            self_intersections_skipped: string | null;
            /** Format: double */
            shortest_bridge: number;
            /** @description Statistics of each strip, in order. */
            strips: components["schemas"]["StripStatistics"][];
            /**
             * Format: double
             * @description Sum of 1 - n_p·n_q over the bridges (Wang-Tang, eq. 4).
             */
            total_normal_twist: number;
            triangles: number;
            /** @description Number of vertices of the mesh. */
            vertices: number;
        };
        /** @description A job: an accepted request and its state. */
        RuledSurfaceJob: {
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Null unless the job has failed. */
            error: components["schemas"]["JobError"] | null;
            /** @description Time at which the job and its mesh are removed. */
            expires_at: string | null;
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "ruled_surface";
            /** @description Name of the job for people, if the request gave one. */
            label: string | null;
            links: components["schemas"]["Links"];
            /** @description Fields of the client, if the request gave some. */
            metadata: {
                [key: string]: unknown;
            } | null;
            progress: components["schemas"]["Progress"];
            started_at: string | null;
            /** @description Null until the job has succeeded. */
            statistics: components["schemas"]["RuledStatistics"] | null;
            status: components["schemas"]["Status"];
            warnings: components["schemas"]["JobWarning"][];
        };
        /** @enum {string} */
        RuledSurfaceKind: "ruled_surface";
        /**
         * @description Quantity that is minimised. `GET /v1/objectives` has the formulas.
         *
         *     - `minimal_normal_variation`: Requires `normals`.
         * @enum {string}
         */
        RuledSurfaceObjective: "minimal_area" | "minimal_twist" | "maximal_convexity" | "minimal_bending_energy" | "minimal_mean_curvature_variation" | "minimal_normal_variation";
        /** @description Two or more directrices. Every neighbouring pair forms one strip, and all strips form one mesh. */
        RuledSurfaceRequest: {
            /** @description Solve for every objective and add the comparison to the statistics. Default: `false`. */
            all_objectives?: boolean;
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /** @description Treatment of the ends of a closed stack: open, or closed by flat caps. */
            caps?: components["schemas"]["Caps"];
            /** @description Whether the directrices are closed polygons (which do not repeat their first point). Default: `false`. */
            closed?: boolean;
            /**
             * Format: double
             * @description Tolerance of the test for local convexity: the angle in degrees by which a direction may reach beyond the
             *     half-plane. 0 is the exact test. Default: `1e-6`.
             */
            convexity_tolerance_deg?: number;
            /**
             * @description `auto` reverses a directrix if that improves the objective, and the statistics list the reversed directrices.
             *     `as_given` reverses none.
             */
            direction?: components["schemas"]["Direction"];
            /** @description Polylines in order. A single point is an apex. */
            directrices: components["schemas"]["Point"][][];
            /** @description Optional here, because the path names the kind. `plateau solve` needs it. */
            kind?: components["schemas"]["RuledSurfaceKind"] | null;
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            /**
             * @description Surface normals along the directrices, with the same shape as `directrices`. `minimal_normal_variation` requires
             *     them.
             */
            normals?: components["schemas"]["Point"][][] | null;
            /** @description One of the named objectives, or a weighted sum of them. */
            objective?: components["schemas"]["Goal"];
            /** @description Rule by which the directrices are resampled before solving. If null, they are used as given. */
            sampling?: components["schemas"]["Sampling"] | null;
            /** @description Objective that decides among the strips with the most convex bridges. It is used only with `maximal_convexity`. */
            secondary_objective?: components["schemas"]["SecondaryObjective"] | null;
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /**
             * @description Tangents along the directrices, with the same shape as `directrices`. If null, they are estimated from the
             *     points.
             */
            tangents?: components["schemas"]["Point"][][] | null;
            /** @description Unit of the coordinates. Default: `m`. */
            units?: components["schemas"]["Units"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
        };
        /** @description Two or more directrices. Every neighbouring pair forms one strip, and all strips form one mesh. */
        RuledSurfaceRequestWithKind: {
            /** @description Solve for every objective and add the comparison to the statistics. Default: `false`. */
            all_objectives?: boolean;
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /** @description Treatment of the ends of a closed stack: open, or closed by flat caps. */
            caps?: components["schemas"]["Caps"];
            /** @description Whether the directrices are closed polygons (which do not repeat their first point). Default: `false`. */
            closed?: boolean;
            /**
             * Format: double
             * @description Tolerance of the test for local convexity: the angle in degrees by which a direction may reach beyond the
             *     half-plane. 0 is the exact test. Default: `1e-6`.
             */
            convexity_tolerance_deg?: number;
            /**
             * @description `auto` reverses a directrix if that improves the objective, and the statistics list the reversed directrices.
             *     `as_given` reverses none.
             */
            direction?: components["schemas"]["Direction"];
            /** @description Polylines in order. A single point is an apex. */
            directrices: components["schemas"]["Point"][][];
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "ruled_surface";
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            /**
             * @description Surface normals along the directrices, with the same shape as `directrices`. `minimal_normal_variation` requires
             *     them.
             */
            normals?: components["schemas"]["Point"][][] | null;
            /** @description One of the named objectives, or a weighted sum of them. */
            objective?: components["schemas"]["Goal"];
            /** @description Rule by which the directrices are resampled before solving. If null, they are used as given. */
            sampling?: components["schemas"]["Sampling"] | null;
            /** @description Objective that decides among the strips with the most convex bridges. It is used only with `maximal_convexity`. */
            secondary_objective?: components["schemas"]["SecondaryObjective"] | null;
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /**
             * @description Tangents along the directrices, with the same shape as `directrices`. If null, they are estimated from the
             *     points.
             */
            tangents?: components["schemas"]["Point"][][] | null;
            /** @description Unit of the coordinates. Default: `m`. */
            units?: components["schemas"]["Units"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
        };
        /**
         * @description Rule by which every directrix is resampled. `extras.input_vertices` of the mesh then maps each given point to the
         *     nearest sample.
         */
        Sampling: {
            by: components["schemas"]["SamplingRule"];
            /**
             * @description Number of points of each directrix. With `chord_height` it is the largest number of points that are kept; null
             *     then keeps all points that the tolerance requires.
             */
            samples?: number | null;
            /**
             * Format: double
             * @description Largest distance, in the request's unit, between the polyline and the chords of the kept points. It is used only
             *     with `chord_height`.
             */
            tolerance?: number | null;
        };
        /**
         * @description `parameter` spaces the samples uniformly in the number of the point. `arc_length` spaces them uniformly along the
         *     polyline. `chord_height` keeps those of the given points that are needed to stay within `tolerance`.
         * @enum {string}
         */
        SamplingRule: "parameter" | "arc_length" | "chord_height";
        /**
         * @description Objective that decides among the strips with the most convex bridges, summed over the bridges that are not convex.
         * @enum {string}
         */
        SecondaryObjective: "minimal_bending_energy" | "minimal_mean_curvature_variation";
        /** @description Deviation of the members for one number of distinct lengths. */
        SharedLengths: {
            /**
             * Format: double
             * @description Largest difference between a member's length and the shared length that replaces it.
             */
            deviation: number;
            /**
             * Format: double
             * @description The same difference before the nodes moved.
             */
            deviation_before: number;
            lengths: number;
        };
        /** @description A support without friction. What slides is exactly one of `along`, `boundary` and `point`. */
        SlidingSupport: {
            /** @description Part of a boundary, without its two ends. */
            along?: components["schemas"]["Along"];
            /** @description Number of a boundary that slides as a whole. */
            boundary?: number;
            /**
             * Format: double
             * @description Angle between the film and the surface, on the left of the edge's direction, as seen from the side to which the
             *     surface's normal points: a plane's `normal`, outside a sphere or cylinder. Null means 90. A given angle needs an
             *     edge on a plane, sphere or cylinder, and a single film with a `tension` and no weight.
             */
            contact_angle_deg?: number | null;
            on: components["schemas"]["Guide"];
            point?: components["schemas"]["BoundaryPoint"];
        };
        /**
         * @description Method that minimises the area. `auto` chooses the best of the others for the request.
         *
         *     - `vertex_relaxation`: Chen, Cai, Zheng.
         *     - `pinkall_polthier`: Bento, Cavalcanti.
         *     - `newton`: Newton's method in normal heights, which also gives the Morse index.
         * @enum {string}
         */
        Solver: "auto" | "vertex_relaxation" | "pinkall_polthier" | "newton";
        /** @description Comparison of the ways to span the boundaries, made with `topology: best`. */
        Spanning: {
            /** @description Whether a film that connects all boundaries exists. */
            connected_film_exists: boolean;
            /**
             * Format: double
             * @description For two boundaries without a connected film, the largest fraction of their gap at which a connected film exists.
             */
            largest_gap_fraction: number | null;
            /** @description The topologies in order of area. Topologies without a film are last. */
            topologies: components["schemas"]["SpanningTopology"][];
        };
        /** @description One way to span the boundaries. */
        SpanningTopology: {
            /**
             * Format: double
             * @description Total area. Null if one of the films does not exist.
             */
            area: number | null;
            /** @description Whether this topology was returned. */
            chosen: boolean;
            /** @description Sets of boundaries by their numbers. A connected film spans each set. */
            films: number[][];
            /**
             * @description Whether its films pass through each other or through themselves. No soap film has such a shape, so the topology
             *     comes after all others.
             */
            films_cross: boolean;
            /**
             * Format: double
             * @description With `certify`: the area is at most this fraction above the least area of all oriented surfaces with this boundary.
             *     Null if nothing is proven.
             */
            gap: number | null;
            stability: components["schemas"]["Stability"] | null;
        };
        SphereGuide: {
            centre: components["schemas"]["Point"];
            /** Format: double */
            radius: number;
        };
        /** @description Minimum, mean, maximum and standard deviation. */
        Spread: {
            /** Format: double */
            max: number;
            /** Format: double */
            mean: number;
            /** Format: double */
            min: number;
            /** Format: double */
            std_dev: number;
        };
        /** @description Second variation of area under normal motion. */
        Stability: {
            /**
             * Format: double
             * @description Lowest eigenvalue with respect to the lumped mass, in 1/unit².
             */
            lowest_eigenvalue: number;
            /** @description Method that gave the index: `inertia` (exact) or `eigenvalue` (large meshes; the index is then 0). */
            method: string;
            /** @description Number of negative eigenvalues. */
            morse_index: number;
            /** @description Whether the Morse index is 0. The surface is then a true local minimum, like a physical soap film. */
            stable: boolean;
        };
        /** @description One stage of the computation: a pair of rows of Katoh, Ohsaki and Xu's Table 1. */
        Stage: {
            all: components["schemas"]["StageGroup"];
            /** @description Null for the auxiliary triangulation. */
            lattice: components["schemas"]["StageGroup"] | null;
            /**
             * @description Name of the stage: `auxiliary_surface`, `auxiliary_plane`, `plane`, `surface`, `optimised_nodes` or
             *     `shared_lengths`.
             */
            name: string;
        };
        /** @description One group of members at one stage. */
        StageGroup: {
            count: number;
            /** @description Smallest number of lengths for all members if lengths that differ by at most the tolerance count as one. */
            distinct_lengths: number;
            /** @description Number of members within the tolerance of the edge length. */
            equal_edges: number;
            /** Format: double */
            max: number;
            /** Format: double */
            mean: number;
            /** Format: double */
            min: number;
            /** Format: double */
            std_dev: number;
        };
        /**
         * @description State of a job. `succeeded`, `failed` and `cancelled` are final.
         * @enum {string}
         */
        Status: "queued" | "running" | "succeeded" | "failed" | "cancelled";
        StressRange: {
            /** Format: double */
            max: number;
            /**
             * Format: double
             * @description Mean over the area.
             */
            mean: number;
            /** Format: double */
            min: number;
        };
        /**
         * @description Statistics of one strip, or of all strips of a stack together. Lengths are in the request's unit, areas in its
         *     square, and angles in degrees.
         */
        StripStatistics: {
            /** Format: double */
            area: number;
            /** Format: double */
            bending_energy: number;
            bridges: number;
            /** Format: double */
            convex_bridge_ratio: number;
            /** @description Number of bridges that are locally convex. */
            convex_bridges: number;
            /**
             * Format: double
             * @description Largest angle between the normals of neighbouring triangles at bridges that are not locally convex. It is 0 for
             *     a strip that can be developed.
             */
            developability_deviation_deg: number;
            /**
             * Format: double
             * @description Largest angle between the normals of neighbouring triangles.
             */
            largest_fold_deg: number;
            /** Format: double */
            longest_bridge: number;
            /** Format: double */
            mean_curvature_variation: number;
            /**
             * Format: double
             * @description Value of `minimal_normal_variation`. Null without normals.
             */
            normal_variation: number | null;
            /**
             * Format: double
             * @description Value of the objective. For `maximal_convexity` it is the number of convex bridges.
             */
            objective_value: number;
            /**
             * Format: double
             * @description Value of the secondary objective. Null without one.
             */
            secondary_value: number | null;
            /** Format: double */
            shortest_bridge: number;
            /**
             * Format: double
             * @description Sum of 1 - n_p·n_q over the bridges (Wang-Tang, eq. 4).
             */
            total_normal_twist: number;
            triangles: number;
        };
        /** @description A support at the end of a cable. */
        SupportReaction: {
            /** @description Number of the boundary, or null for a support in the air. */
            boundary: number | null;
            /** @description Force of the support on the structure. */
            force: number[];
            /** @description Number of the boundary's point. */
            point: number | null;
            vertex: number;
        };
        /** @description The mesh beside the curved surface that it stands for. All nodes lie on the surface. */
        SurfaceFit: {
            /**
             * Format: double
             * @description The surface's own area.
             */
            area: number;
            /**
             * Format: double
             * @description The mesh's area less the surface's, relative to the surface's.
             */
            area_error: number;
            /**
             * Format: double
             * @description Largest distance from the middle of a triangle to the surface.
             */
            distance_max: number;
            /**
             * @description `flattened`: laid into the plane, meshed there and carried back. `on_surface`: meshed on the surface itself, because
             *     it cannot be laid into the plane with a bounded distortion.
             */
            method: string;
            /**
             * Format: double
             * @description Largest angle between the normals of a triangle and of the surface below its middle.
             */
            normal_deviation_max_deg: number;
        };
        /** @description Weights of the terms of the loss. */
        TargetWeights: {
            /**
             * Format: double
             * @description Weight of the mean of (force / target - 1)² over the edges with a target force. Default: `1.0`.
             */
            force?: number;
            /**
             * Format: double
             * @description Weight of the mean of (length / target - 1)² over the edges with a target length. Default: `1.0`.
             */
            length?: number;
            /**
             * Format: double
             * @description Weight of the load path Σ force · length, as a fraction of its value at the start. Default: `0.0`.
             */
            load_path?: number;
        };
        /** @description The film's prestress and weight. The prestress is either `tension`, or `warp` and `weft` with a `direction`. */
        TensileFilm: {
            direction?: components["schemas"]["WarpDirection"];
            hold?: components["schemas"]["WeaveHold"];
            /**
             * Format: double
             * @description Isotropic tension, a force per length.
             */
            tension?: number;
            /**
             * Format: double
             * @description Stress along the warp, a force per length.
             */
            warp?: number;
            /**
             * Format: double
             * @description Stress along the weft, at right angles to the warp, a force per length.
             */
            weft?: number;
            /**
             * Format: double
             * @description Weight per area of the found shape. An isotropic tension is `tension` at the film's mean height and grows with
             *     the height by the weight. Default: `0.0`.
             */
            weight?: number;
        };
        /** @description Statistics of a tensile structure. */
        TensileStatistics: {
            angles_deg: components["schemas"]["AngleRange"];
            /**
             * Format: double
             * @description Area of all layers.
             */
            area: number;
            /** @description Null if the forces could not be balanced. */
            balance: components["schemas"]["ForceBalance"] | null;
            cables: components["schemas"]["CableForce"][];
            /** @description The chambers. The space below a single film with a pressure is one. */
            chambers: components["schemas"]["ChamberState"][];
            /**
             * @description Angle between the film's pull on sliding edges and their surface; of edges with a given angle that on their left.
             *     Null without such an edge.
             */
            contact_angle_deg: components["schemas"]["AngleRange"] | null;
            converged: boolean;
            degenerate_triangles: number;
            edge_lengths: components["schemas"]["Spread"];
            /** @description Supports along the fixed parts of the boundaries. */
            edge_reactions: components["schemas"]["EdgeReaction"][];
            flipped_triangles: number;
            /** @description Unit of the forces. */
            force_unit: string;
            iterations: number;
            /** @description The layers. A single film is one. */
            layers: components["schemas"]["LayerFigures"][];
            masts: components["schemas"]["MastForce"][];
            /** @description Centroid of the triangle with the smallest slope. */
            minimum_slope_at: number[];
            /**
             * Format: double
             * @description Smallest slope of a triangle against the horizontal, in degrees. The middle of a saddle and a crown have 0.
             */
            minimum_slope_deg: number;
            objective: string;
            /**
             * Format: double
             * @description Energy of the found shape. With warp and weft the film counts with half the sum of its stresses times its area.
             */
            objective_value: number;
            /** @description Middle of the mesh's bounding box, which files with `origin=local` are relative to. */
            origin: number[];
            /** @description Water that would stand on the film after rain. Null if it runs off over the film's edges. */
            ponding: components["schemas"]["Ponding"] | null;
            /**
             * Format: double
             * @description Pressure in the first of `chambers`, given or found; 0 for none.
             */
            pressure: number;
            /** @description Supports at the ends of cables. */
            reactions: components["schemas"]["SupportReaction"][];
            /** Format: double */
            residual: number;
            rings: components["schemas"]["RingPosition"][];
            /** @description Number of pairs of triangles of the film that intersect. Null if not all pairs were looked at. */
            self_intersections: number | null;
            /** @description Why `self_intersections` is null: `too_many_pairs`, `deadline_passed`. */
            self_intersections_skipped: string | null;
            /** @description Null where the solve did not converge, and with warp and weft, because no energy has their shape as its minimum. */
            stability: components["schemas"]["EquilibriumStability"] | null;
            stop_reason: string;
            /** @description Stresses of all layers. Null if the forces could not be balanced. */
            stress: components["schemas"]["FilmStress"] | null;
            triangles: number;
            vertices: number;
            /**
             * Format: double
             * @description Volume of the first of `chambers`. Null without a pressure.
             */
            volume: number | null;
        };
        /** @description A job: an accepted request and its state. */
        TensileStructureJob: {
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Null unless the job has failed. */
            error: components["schemas"]["JobError"] | null;
            /** @description Time at which the job and its mesh are removed. */
            expires_at: string | null;
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "tensile_structure";
            /** @description Name of the job for people, if the request gave one. */
            label: string | null;
            links: components["schemas"]["Links"];
            /** @description Fields of the client, if the request gave some. */
            metadata: {
                [key: string]: unknown;
            } | null;
            progress: components["schemas"]["Progress"];
            started_at: string | null;
            /** @description Null until the job has succeeded. */
            statistics: components["schemas"]["TensileStatistics"] | null;
            status: components["schemas"]["Status"];
            warnings: components["schemas"]["JobWarning"][];
        };
        /** @enum {string} */
        TensileStructureKind: "tensile_structure";
        /**
         * @description A film with cables, pressure and weight, whose shape in equilibrium is found.
         *
         *     Every point of the boundaries is a support, unless it lies strictly inside the stretch of a cable or is listed in
         *     `free_points`.
         */
        TensileStructureRequest: {
            /** @description Closed polygons that do not repeat their first point: the edges of the film before form finding. */
            boundaries: components["schemas"]["Polygon"][];
            /** @description Cables along the boundaries and in the air. */
            cables?: components["schemas"]["Cable"][];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /**
             * @description Closed spaces below layers. Every space between two layers needs one. Not together with `film`, which has
             *     `pressure` and `volume`.
             */
            chambers?: components["schemas"]["Chamber"][];
            /** @description The film. Required unless there are `layers`. */
            film?: components["schemas"]["TensileFilm"];
            /**
             * @description Points of the boundaries that no support holds although cables end there. Each needs a cable along the boundary
             *     on both sides; cables in the air can tie it back.
             */
            free_points?: components["schemas"]["BoundaryPoint"][];
            /** @description Points in the air at which cables and masts end and which no support holds. Default: `[]`. */
            joints?: components["schemas"]["Point"][];
            /** @description Optional here, because the path names the kind. `plateau solve` needs it. */
            kind?: components["schemas"]["TensileStructureKind"] | null;
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /**
             * @description Two or more films over the same boundaries in place of `film`: a cushion. The first lies on the side from which
             *     the first boundary runs counter-clockwise, each next one below it. Each has a `tension`.
             */
            layers?: components["schemas"]["TensileFilm"][];
            /** @description Straight members that may push. */
            masts?: components["schemas"]["Mast"][];
            /** @description Maximum number of linear solves. Null means 400. */
            max_iterations?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            /**
             * Format: double
             * @description Pressure, a force per area, towards the side from which the first boundary runs counter-clockwise. Not together
             *     with `volume`, and not with cables along a boundary, `supports`, `rings` or `layers`.
             */
            pressure?: number | null;
            /** @description Resolution of the mesh of each layer. If absent, 2,000 triangles, or four for each boundary point where those are more. */
            resolution?: components["schemas"]["Resolution"];
            /** @description Boundaries that are rigid rings and move along an axis. */
            rings?: components["schemas"]["Ring"][];
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /** @description Supports on which points or edges of the film slide without friction. */
            supports?: components["schemas"]["SlidingSupport"][];
            /**
             * Format: double
             * @description Residual (largest unbalanced force over twice the vertex's share of tension times area, times the radius of the
             *     supports) at which the shape counts as found. Default: `1e-8`.
             */
            tolerance?: number;
            units?: components["schemas"]["LengthAndForce"];
            /** @description Axis that points up. Weights pull against it. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
            /**
             * Format: double
             * @description Volume between the film and fans from each boundary to its mean, on the side to which a pressure pushes. The
             *     pressure is found. Not with cables along a boundary, `supports`, `rings` or `layers`.
             */
            volume?: number | null;
        };
        /**
         * @description A film with cables, pressure and weight, whose shape in equilibrium is found.
         *
         *     Every point of the boundaries is a support, unless it lies strictly inside the stretch of a cable or is listed in
         *     `free_points`.
         */
        TensileStructureRequestWithKind: {
            /** @description Closed polygons that do not repeat their first point: the edges of the film before form finding. */
            boundaries: components["schemas"]["Polygon"][];
            /** @description Cables along the boundaries and in the air. */
            cables?: components["schemas"]["Cable"][];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            /**
             * @description Closed spaces below layers. Every space between two layers needs one. Not together with `film`, which has
             *     `pressure` and `volume`.
             */
            chambers?: components["schemas"]["Chamber"][];
            /** @description The film. Required unless there are `layers`. */
            film?: components["schemas"]["TensileFilm"];
            /**
             * @description Points of the boundaries that no support holds although cables end there. Each needs a cable along the boundary
             *     on both sides; cables in the air can tie it back.
             */
            free_points?: components["schemas"]["BoundaryPoint"][];
            /** @description Points in the air at which cables and masts end and which no support holds. Default: `[]`. */
            joints?: components["schemas"]["Point"][];
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "tensile_structure";
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /**
             * @description Two or more films over the same boundaries in place of `film`: a cushion. The first lies on the side from which
             *     the first boundary runs counter-clockwise, each next one below it. Each has a `tension`.
             */
            layers?: components["schemas"]["TensileFilm"][];
            /** @description Straight members that may push. */
            masts?: components["schemas"]["Mast"][];
            /** @description Maximum number of linear solves. Null means 400. */
            max_iterations?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            /**
             * Format: double
             * @description Pressure, a force per area, towards the side from which the first boundary runs counter-clockwise. Not together
             *     with `volume`, and not with cables along a boundary, `supports`, `rings` or `layers`.
             */
            pressure?: number | null;
            /** @description Resolution of the mesh of each layer. If absent, 2,000 triangles, or four for each boundary point where those are more. */
            resolution?: components["schemas"]["Resolution"];
            /** @description Boundaries that are rigid rings and move along an axis. */
            rings?: components["schemas"]["Ring"][];
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /** @description Supports on which points or edges of the film slide without friction. */
            supports?: components["schemas"]["SlidingSupport"][];
            /**
             * Format: double
             * @description Residual (largest unbalanced force over twice the vertex's share of tension times area, times the radius of the
             *     supports) at which the shape counts as found. Default: `1e-8`.
             */
            tolerance?: number;
            units?: components["schemas"]["LengthAndForce"];
            /** @description Axis that points up. Weights pull against it. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
            /**
             * Format: double
             * @description Volume between the film and fans from each boundary to its mean, on the side to which a pressure pushes. The
             *     pressure is found. Not with cables along a boundary, `supports`, `rings` or `layers`.
             */
            volume?: number | null;
        };
        /**
         * @description `fixed` keeps the topology of the initial mesh. `free` allows necks to pinch. `best` solves every spanning topology
         *     and returns the surface of least area.
         * @enum {string}
         */
        Topology: "fixed" | "free" | "best";
        /** @description A job: an accepted request and its state. */
        UniformMeshJob: {
            /** @description Time of submission (RFC 3339, UTC). */
            created_at: string;
            /** @description Null unless the job has failed. */
            error: components["schemas"]["JobError"] | null;
            /** @description Time at which the job and its mesh are removed. */
            expires_at: string | null;
            finished_at: string | null;
            /** @description ULID, which sorts by time of submission. */
            id: string;
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "uniform_mesh";
            /** @description Name of the job for people, if the request gave one. */
            label: string | null;
            links: components["schemas"]["Links"];
            /** @description Fields of the client, if the request gave some. */
            metadata: {
                [key: string]: unknown;
            } | null;
            progress: components["schemas"]["Progress"];
            started_at: string | null;
            /** @description Null until the job has succeeded. */
            statistics: components["schemas"]["UniformStatistics"] | null;
            status: components["schemas"]["Status"];
            warnings: components["schemas"]["JobWarning"][];
        };
        /** @enum {string} */
        UniformMeshKind: "uniform_mesh";
        /**
         * @description Quantity that is optimised. `GET /v1/objectives` has the formulas.
         *
         *     - `fewest_nodes`: As few nodes as possible.
         *     - `most_equal_edges`: As many members of the edge length as possible.
         * @enum {string}
         */
        UniformMeshObjective: "fewest_nodes" | "most_equal_edges";
        /** @description A domain and the edge length of its mesh. */
        UniformMeshRequest: {
            /** @description Number of rectangles along u and v in the auxiliary triangulation of a patch. Default: `[15,15]`. */
            auxiliary_grid?: number[];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            domain: components["schemas"]["Domain"];
            /**
             * Format: double
             * @description Edge length ℓ in the request's unit: the length of as many members as possible, and the smallest length of all
             *     members.
             */
            edge_length: number;
            /** @description Optional here, because the path names the kind. `plateau solve` needs it. */
            kind?: components["schemas"]["UniformMeshKind"] | null;
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /**
             * Format: double
             * @description Largest difference between lengths that count as equal, in the request's unit. Null means a thousandth of the
             *     edge length.
             */
            length_tolerance?: number | null;
            /** @description Largest number of different member lengths. It is used only with `optimise: lengths`. */
            max_distinct_lengths?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            objective?: components["schemas"]["UniformMeshObjective"];
            /** @description Aim of moving the nodes. */
            optimise?: components["schemas"]["Optimise"];
            /** @description Whether the inner nodes of a curved domain move on the surface after meshing. Default: `true`. */
            optimise_nodes?: boolean;
            /** @description Lengths that members outside the lattice group may take while the nodes move. */
            rim?: components["schemas"]["Rim"];
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /** @description Unit of the coordinates. Default: `m`. */
            units?: components["schemas"]["Units"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
        };
        /** @description A domain and the edge length of its mesh. */
        UniformMeshRequestWithKind: {
            /** @description Number of rectangles along u and v in the auxiliary triangulation of a patch. Default: `[15,15]`. */
            auxiliary_grid?: number[];
            /** @description Whether the stored result of an equal earlier request may be returned. */
            cache?: components["schemas"]["Cache"];
            /**
             * @description URL (https) that receives a signed POST when the job ends. Requires webhooks to be enabled on this server: see
             *     `webhooks` of `GET /v1/limits`.
             */
            callback_url?: string | null;
            /** @description Cancel the job if the client closes the connection while it waits for the end. Requires `Prefer: wait`. Default: `false`. */
            cancel_on_disconnect?: boolean;
            domain: components["schemas"]["Domain"];
            /**
             * Format: double
             * @description Edge length ℓ in the request's unit: the length of as many members as possible, and the smallest length of all
             *     members.
             */
            edge_length: number;
            /**
             * @description Kind of the request. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            kind: "uniform_mesh";
            /** @description Name of the job for people. The job and lists of jobs show it. */
            label?: string | null;
            /**
             * Format: double
             * @description Largest difference between lengths that count as equal, in the request's unit. Null means a thousandth of the
             *     edge length.
             */
            length_tolerance?: number | null;
            /** @description Largest number of different member lengths. It is used only with `optimise: lengths`. */
            max_distinct_lengths?: number | null;
            /** @description Any fields of the client, at most 4096 bytes as JSON text. The job and lists of jobs show them. */
            metadata?: {
                [key: string]: unknown;
            } | null;
            objective?: components["schemas"]["UniformMeshObjective"];
            /** @description Aim of moving the nodes. */
            optimise?: components["schemas"]["Optimise"];
            /** @description Whether the inner nodes of a curved domain move on the surface after meshing. Default: `true`. */
            optimise_nodes?: boolean;
            /** @description Lengths that members outside the lattice group may take while the nodes move. */
            rim?: components["schemas"]["Rim"];
            /**
             * @description Key of a series of requests of which only the newest counts, such as those of one drag. Once this request is
             *     accepted, older jobs with the same key that have not ended are cancelled.
             */
            supersede?: string | null;
            /** @description Unit of the coordinates. Default: `m`. */
            units?: components["schemas"]["Units"];
            /** @description Axis that points up. Default: `z`. */
            up?: components["schemas"]["UpAxis"];
        };
        /** @description Statistics of a uniform mesh. Lengths are in the request's unit, and angles are in degrees. */
        UniformStatistics: {
            angles_deg: components["schemas"]["AngleRange"];
            /**
             * @description False if the deadline cut the work short, or if the surface is curved too strongly for this edge length: the area is
             *     off by more than 1%, a triangle faces away, or edges or angles are far out of range. `not_converged` says by how much.
             */
            converged: boolean;
            distinct_lengths: number;
            edge_lengths: components["schemas"]["Spread"];
            edges: number;
            /** @description Number of members within the tolerance of the edge length. */
            equal_edges: number;
            /** @description Lengths of the members of the lattice. */
            lattice_edges: components["schemas"]["GroupLengths"];
            length_histogram: components["schemas"]["LengthHistogram"];
            /**
             * Format: double
             * @description Tolerance of `equal_edges` and `distinct_lengths`.
             */
            length_tolerance: number;
            /**
             * @description For polygons, a lower bound of the number of nodes of any mesh with members of at most twice the edge length.
             *     Null for curved domains.
             */
            node_lower_bound: number | null;
            nodes: number;
            objective: string;
            /** @description Number of nodes for `fewest_nodes`, and number of lattice edges for `most_equal_edges`. */
            objective_value: number;
            /** @description Middle of the mesh's bounding box, which files with `origin=local` are relative to. */
            origin: number[];
            /** @description The first 200 members that are out of range. */
            out_of_range: components["schemas"]["OutOfRange"][];
            out_of_range_edges: number;
            /** @description Number of members that are out of range, for each reason. */
            out_of_range_reasons: {
                [key: string]: number;
            };
            /**
             * @description Pairs of triangles that cross, touch or overlap beyond the vertices and edges that they share; 0 for an embedded mesh.
             *     Null if not all pairs were looked at.
             */
            self_intersections: number | null;
            /** @description Why `self_intersections` is null: `too_many_triangles`, `too_many_pairs`, `deadline_passed`. */
            self_intersections_skipped: string | null;
            /** @description With `optimise: lengths`, the deviation for each number of lengths that was tried. */
            shared_lengths: components["schemas"]["SharedLengths"][];
            /** @description Rows of Katoh, Ohsaki and Xu's Table 1, stage by stage. */
            stages: components["schemas"]["Stage"][];
            /** @description Curved domains: the mesh beside its surface. Null for polygons. */
            surface: components["schemas"]["SurfaceFit"] | null;
            triangles: number;
            /** @description Entry k is the number of nodes with k members. */
            valence_histogram: number[];
        };
        /**
         * @description Unit of the client's coordinates. Meshes in glTF are in metres, as glTF demands; OBJ, PLY and STL keep the client's
         *     unit.
         * @enum {string}
         */
        Units: "mm" | "cm" | "m" | "in" | "ft";
        /**
         * @description Axis of the client's coordinates that points up.
         * @enum {string}
         */
        UpAxis: "z" | "y";
        /** @description Smallest and largest value. */
        ValueRange: {
            /** Format: double */
            max: number;
            /** Format: double */
            min: number;
        };
        /**
         * @description Field of directions in space, given by exactly one of its fields. The film's warp is the projection of the field
         *     onto the film. Directions need no unit length.
         */
        WarpDirection: {
            /** @description Polyline along whose tangent at the nearest point the warp runs. */
            along?: components["schemas"]["Point"][];
            /** @description Vector along which the warp runs. */
            parallel?: number[];
            radial?: components["schemas"]["RadialDirection"];
        };
        /**
         * @description Quantity that the stresses of warp and weft hold constant. Requires `warp` and `weft`.
         *
         *     - `ratio`: Their ratio. Both vary by a common factor with the mean 1, so that the forces within the film can balance.
         *     - `magnitudes`: Their magnitudes. Two unequal ones cannot be in equilibrium on most shapes. The returned stresses then deviate
         *     from them, and the job has the warning `stress_deviates`.
         * @enum {string}
         */
        WeaveHold: "ratio" | "magnitudes";
        /** @description Stresses along warp and weft. */
        WeaveStress: {
            /**
             * Format: double
             * @description Root mean square over the area of each stress over the one required at the same place, less 1. Above 0.05 the
             *     job has the warning `stress_deviates`.
             */
            deviation_rms: number;
            hold: components["schemas"]["WeaveHold"];
            /** @description Stress of the weft over that of the warp. */
            ratio: components["schemas"]["StressRange"];
            /**
             * Format: double
             * @description Root mean square over the area of ratio / required ratio - 1.
             */
            ratio_deviation_rms: number;
            /** Format: double */
            required_ratio: number;
            warp: components["schemas"]["StressRange"];
            weft: components["schemas"]["StressRange"];
        };
        /** @description The sum of the named objectives times their weights. */
        WeightedSum: {
            /** @description Whether each term is first divided by its own optimum on the strip, because the terms have different units. Default: `true`. */
            normalise?: boolean;
            weights: components["schemas"]["Weights"];
        };
        /** @description Weights of the objectives. At least one must be positive. `minimal_normal_variation` requires `normals`. */
        Weights: {
            /**
             * Format: double
             * @description Default: `0.0`.
             */
            minimal_area?: number;
            /**
             * Format: double
             * @description Default: `0.0`.
             */
            minimal_bending_energy?: number;
            /**
             * Format: double
             * @description Default: `0.0`.
             */
            minimal_mean_curvature_variation?: number;
            /**
             * Format: double
             * @description Default: `0.0`.
             */
            minimal_normal_variation?: number;
            /**
             * Format: double
             * @description Default: `0.0`.
             */
            minimal_twist?: number;
        };
    };
    responses: {
        /** @description Malformed JSON, a repeated key, or an invalid query parameter */
        BadRequest: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description A defect of the server */
        Failed: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description A page of another origin sent the request, and `http.cors_origins` does not name that origin */
        ForeignPage: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The job has expired */
        Gone: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The request is well-formed JSON but invalid; `errors` names each offending value */
        Invalid: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The request is for a host that this server does not answer to */
        Misdirected: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The job has not ended, or ended without a mesh */
        NoMesh: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description None of the accepted media types is offered */
        NotAcceptable: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The resource does not exist */
        NotFound: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The queue is full, or this key has made too many requests */
        QueueFull: {
            headers: {
                RateLimit: components["headers"]["RateLimit"];
                "RateLimit-Policy": components["headers"]["RateLimitPolicy"];
                "Retry-After": components["headers"]["RetryAfter"];
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description This key has made too many requests */
        RateLimited: {
            headers: {
                RateLimit: components["headers"]["RateLimit"];
                "RateLimit-Policy": components["headers"]["RateLimitPolicy"];
                "Retry-After": components["headers"]["RetryAfter"];
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The body did not arrive in time */
        RequestTimeout: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description More bytes, points, triangles or cells than this server accepts */
        TooLarge: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The request has no valid key of this server */
        Unauthorized: {
            headers: {
                "WWW-Authenticate": components["headers"]["WwwAuthenticate"];
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The server cannot accept this request now */
        Unavailable: {
            headers: {
                "Retry-After": components["headers"]["RetryAfter"];
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description The body is not plain application/json */
        UnsupportedMediaType: {
            headers: {
                "X-Request-Id": components["headers"]["RequestId"];
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
    };
    parameters: never;
    requestBodies: never;
    headers: {
        /** @description Requests that the key has left (`r`), and seconds until it has all of a minute's again (`t`): `"requests";r=57;t=3`. */
        RateLimit: string;
        /** @description Requests that the key may make (`q`) in a number of seconds (`w`): `"requests";q=60;w=60`. */
        RateLimitPolicy: string;
        /** @description Identifier of this request in the server's logs. */
        RequestId: string;
        /** @description Seconds to wait. */
        RetryAfter: number;
        /** @description Bearer */
        WwwAuthenticate: string;
    };
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    getStudio: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The studio, a page to draw, solve and inspect surfaces */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/html; charset=utf-8": string;
                };
            };
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    findDocs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The page is at `/docs/` */
            303: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    getDocs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page to read and try the API, which works offline */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/html; charset=utf-8": string;
                };
            };
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    getDocsFile: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Name of the file. */
                file: "index.html" | "start.js" | "swagger-ui-bundle.js" | "swagger-ui.css" | "favicon-32x32.png" | "LICENSE" | "NOTICE";
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/png": string;
                    "text/css; charset=utf-8": string;
                    "text/html; charset=utf-8": string;
                    "text/javascript; charset=utf-8": string;
                    "text/plain; charset=utf-8": string;
                };
            };
            /** @description `If-None-Match` names the current entity tag */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["NotFound"];
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    getLive: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Checks that the process answers */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        status: string;
                    };
                };
            };
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    getReady: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Checks that the store answers and jobs are accepted */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        status: string;
                    };
                };
            };
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    listHopsComponents: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Descriptions of all components */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsComponent"][];
                };
            };
            404: components["responses"]["NotFound"];
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    postHopsSolve: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["HopsMessage"];
            };
        };
        responses: {
            /** @description The outputs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The outputs of a job that has not ended */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The body is not a message of Hops */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The header `RhinoComputeKey` has no valid key of this server */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description A page of another origin sent the message */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description No such component or job, or Hops is off on this server */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The body did not arrive in time */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The job has no mesh */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The job has expired */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The request is larger than this server accepts */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The body is not plain application/json */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The request is for a host that this server does not answer to */
            421: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description `errors` names each input that cannot be used, or says why there is no result */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The queue is full, or this key has made too many requests */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The inputs are not those of the component (`Bad inputs`), or a defect of the server */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The job takes longer than Hops waits, or the server cannot accept it now */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
        };
    };
    getHopsComponent: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Name of the component. */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Inputs and outputs of the component */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsComponent"];
                };
            };
            404: components["responses"]["NotFound"];
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    postMcp: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": {
                    /** @enum {string} */
                    jsonrpc: "2.0";
                };
            };
        };
        responses: {
            /** @description The answer to a request of the protocol */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        /** @enum {string} */
                        jsonrpc: "2.0";
                    };
                };
            };
            /** @description A notification was received */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            404: components["responses"]["NotFound"];
            406: components["responses"]["NotAcceptable"];
            408: components["responses"]["RequestTimeout"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getMetrics: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Metrics as Prometheus text */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            401: components["responses"]["Unauthorized"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
        };
    };
    getOpenApi: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description This document */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": Record<string, never>;
                };
            };
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    getProblem: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Last part of the type. */
                name: "bad-header" | "bad-query" | "body-timeout" | "deadline" | "degenerate-boundary" | "expired" | "foreign-page" | "idempotency-key-conflict" | "internal" | "invalid-geometry" | "invalid-mesh" | "invalid-request" | "malformed-body" | "mesh-lost" | "method-not-allowed" | "misdirected" | "no-connected-film" | "no-equilibrium" | "no-initial-mesh" | "no-mesh" | "no-room-for-interior-vertices" | "not-acceptable" | "not-flattenable" | "not-found" | "queue-full" | "range-not-satisfiable" | "rate-limited" | "refused" | "self-intersecting-boundary" | "slack-cable" | "solver-panicked" | "too-large" | "unauthorized" | "unavailable" | "unknown-kind" | "unsupported-media-type" | "unwritable" | "worker-lost";
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A status code or `failed job`, and the title */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            404: components["responses"]["NotFound"];
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    postSolve: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["HopsMessage"];
            };
        };
        responses: {
            /** @description The outputs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The outputs of a job that has not ended */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The body is not a message of Hops */
            400: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The header `RhinoComputeKey` has no valid key of this server */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description A page of another origin sent the message */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description No such component or job, or Hops is off on this server */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The body did not arrive in time */
            408: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The job has no mesh */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The job has expired */
            410: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The request is larger than this server accepts */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The body is not plain application/json */
            415: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The request is for a host that this server does not answer to */
            421: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description `errors` names each input that cannot be used, or says why there is no result */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The queue is full, or this key has made too many requests */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The inputs are not those of the component (`Bad inputs`), or a defect of the server */
            500: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
            /** @description The job takes longer than Hops waits, or the server cannot accept it now */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["HopsAnswer"];
                };
            };
        };
    };
    getStudioFile: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Name of the file. */
                file: "index.html" | "embed.html" | "studio.js" | "studio.css" | "icon.svg" | "inter.woff2" | "licences.txt" | "thumbnails.webp";
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "font/woff2": string;
                    "image/svg+xml": string;
                    "image/webp": string;
                    "text/css; charset=utf-8": string;
                    "text/html; charset=utf-8": string;
                    "text/javascript; charset=utf-8": string;
                    "text/plain; charset=utf-8": string;
                };
            };
            /** @description `If-None-Match` names the current entity tag */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["NotFound"];
            421: components["responses"]["Misdirected"];
            500: components["responses"]["Failed"];
        };
    };
    postBatch: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
                /** @description Printable ASCII text. The same key with the same body returns the same batch; with another body the answer is 422. */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["BatchRequest"];
            };
        };
        responses: {
            /** @description The batch ended within the time of `Prefer: wait` (read its `status`), or this idempotency key was used before with this body. */
            200: {
                headers: {
                    /** @description Address of the batch. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Batch"];
                };
            };
            /** @description The batch is stored on disk and will be solved. */
            202: {
                headers: {
                    /** @description Address of the batch. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    "Retry-After": components["headers"]["RetryAfter"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Batch"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            408: components["responses"]["RequestTimeout"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["QueueFull"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getBatch: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
            };
            path: {
                /** @description Identifier of the batch. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The batch as it is now, or as it ended within the wait */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Batch"];
                };
            };
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    deleteBatch: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Identifier of the batch. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Removed */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    cancelBatch: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Identifier of the batch. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The batch */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Batch"];
                };
            };
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getBatchMeshes: {
        parameters: {
            query?: {
                /** @description Takes precedence over `Accept`. The default is `zip`. With `Accept: application/octet-stream` the file has that type. */
                format?: "zip" | "glb";
                /** @description Format of the meshes in a ZIP. The default is `glb`. A scene is always GLB. */
                mesh_format?: "glb" | "gltf" | "obj" | "ply" | "stl" | "json";
            };
            header?: never;
            path: {
                /** @description Identifier of the batch. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A ZIP with every mesh and `batch.json`, which describes the job of each request; or all meshes in one GLB scene */
            200: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                    "application/zip": string;
                    "model/gltf-binary": string;
                };
            };
            /** @description The requested range */
            206: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                    "application/zip": string;
                    "model/gltf-binary": string;
                };
            };
            /** @description `If-None-Match` names the current entity tag */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            406: components["responses"]["NotAcceptable"];
            409: components["responses"]["NoMesh"];
            410: components["responses"]["Gone"];
            /** @description The range lies outside the file */
            416: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    postCableNet: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
                /** @description Printable ASCII text. The same key with the same body returns the same job; with another body the answer is 422. */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["CableNetRequest"];
            };
        };
        responses: {
            /** @description The job ended within the time of `Prefer: wait` (read its `status`), or this idempotency key was used before with this body. */
            200: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CableNetJob"];
                };
            };
            /** @description The job is stored on disk and will be solved. */
            202: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    "Retry-After": components["headers"]["RetryAfter"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["CableNetJob"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            408: components["responses"]["RequestTimeout"];
            409: components["responses"]["NoMesh"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["QueueFull"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    listExamples: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Names and titles of the example requests */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ExampleList"];
                };
            };
            401: components["responses"]["Unauthorized"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
        };
    };
    getExample: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Name of the example. */
                name: "two-rails" | "helicoid" | "catenoid" | "tent" | "four-corners" | "ridge-rope" | "own-mesh" | "helicoid-relaxation" | "two-rings" | "rings-12-free" | "rings-12-best" | "rings-11-proven" | "rings-14-free" | "rings-14-best" | "rings-14-pinkall-polthier" | "cut-cylinder" | "three-rings" | "tetrahedron-loops" | "nested-loops" | "three-half-circles" | "three-half-circles-uneven" | "helicoid-liu-wang" | "scherk-relaxation" | "wavy-strip" | "contour-stack" | "wang-tang-i" | "wang-tang-ii" | "wang-tang-iii" | "wang-tang-iv" | "wang-tang-v" | "wang-tang-vi" | "latticed-roof" | "latticed-roof-steep" | "latticed-film" | "latticed-roof-few-lengths" | "floor-fewest-nodes" | "floor-equal-members" | "courtyard" | "plane-sail" | "four-point-sail" | "inflated-disc" | "conic-tent" | "flying-mast" | "ridge-and-valley" | "air-hall" | "cushion" | "film-on-a-plane" | "four-cables" | "cable-net-by-targets" | "vault";
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The request */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Example"];
                };
            };
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
        };
    };
    listJobs: {
        parameters: {
            query?: {
                /** @description Only jobs in this state. */
                status?: "queued" | "running" | "succeeded" | "failed" | "cancelled";
                /** @description Only jobs of this kind. */
                kind?: "ruled_surface" | "minimal_surface" | "uniform_mesh" | "tensile_structure" | "cable_net";
                /** @description Only jobs that were submitted with this `Idempotency-Key`. */
                idempotency_key?: string;
                /** @description Maximum number of jobs on the page. The default is 50. */
                limit?: number;
                /** @description `next_cursor` of the previous page. */
                cursor?: string;
                /** @description Whether each job that has succeeded has its statistics. The default is false. */
                statistics?: boolean;
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description One page of jobs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobList"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getJob: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
            };
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The job as it is now, or as it ended within the wait */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    deleteJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Removed */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    cancelJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The job */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Job"];
                };
            };
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getCertificate: {
        parameters: {
            query?: {
                /** @description Takes precedence over `Accept`. The default is `json`. With `Accept: application/octet-stream` the file has that type. */
                format?: "json";
            };
            header?: never;
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The field that proves the lower bound of the area: tetrahedra and the field's values on them */
            200: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": string;
                    "application/octet-stream": string;
                };
            };
            /** @description The requested range */
            206: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": string;
                    "application/octet-stream": string;
                };
            };
            /** @description `If-None-Match` names the current entity tag */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            406: components["responses"]["NotAcceptable"];
            409: components["responses"]["NoMesh"];
            410: components["responses"]["Gone"];
            /** @description The range lies outside the file */
            416: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getEvents: {
        parameters: {
            query?: {
                /** @description Stands for the key in browsers, whose `EventSource` cannot send one: `events` of `postTicket` contains it. */
                ticket?: string;
            };
            header?: {
                /** @description Identifier of the last event that the client saw, `attempt.sequence`. After the final event the answer is 204. */
                "Last-Event-ID"?: string;
            };
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Server-sent events: `status` events, `progress` events, and one final `status` event */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": {
                        /** @description JSON text. For a `status` event it is the job as it was right after that change. For a `progress` event it is an object with the job's `id`, `status` and `progress`. */
                        data: string;
                        /** @enum {string} */
                        event: "status" | "progress";
                        /** @description `attempt.sequence` */
                        id: string;
                        retry?: number;
                    };
                };
            };
            /** @description The client has seen the final event, so no event follows */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getMesh: {
        parameters: {
            query?: {
                /** @description Takes precedence over `Accept`. The default is `glb`. With `Accept: application/octet-stream` the file has that type. */
                format?: "glb" | "gltf" | "obj" | "ply" | "stl" | "json";
                /** @description Point that the coordinates are relative to: the request's zero (`given`) or `origin` of the job's statistics (`local`). The default is `given`, except for STL files of meshes that are too far from zero for 32-bit numbers. */
                origin?: "given" | "local";
                /** @description Whether the file has the lines along the mesh (boundaries, directrices, bridges, members). The default is true. PLY and STL never have lines. */
                lines?: boolean;
                /** @description Whether a PLY file is binary or text. The default is `binary`. Other formats have no choice. */
                encoding?: "binary" | "ascii";
            };
            header?: never;
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The mesh */
            200: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                    "application/vnd.plateau.mesh+json": components["schemas"]["Mesh"];
                    "application/x-ply": string;
                    "model/gltf+json": string;
                    "model/gltf-binary": string;
                    "model/obj": string;
                    "model/stl": string;
                };
            };
            /** @description The requested range */
            206: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                    "application/vnd.plateau.mesh+json": string;
                    "application/x-ply": string;
                    "model/gltf+json": string;
                    "model/gltf-binary": string;
                    "model/obj": string;
                    "model/stl": string;
                };
            };
            /** @description `If-None-Match` names the current entity tag */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            406: components["responses"]["NotAcceptable"];
            409: components["responses"]["NoMesh"];
            410: components["responses"]["Gone"];
            /** @description The range lies outside the file */
            416: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getPattern: {
        parameters: {
            query?: {
                /** @description Takes precedence over `Accept`. The default is `svg`. With `Accept: application/octet-stream` the file has that type. */
                format?: "svg" | "dxf";
            };
            header?: never;
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The flat pattern, true to scale */
            200: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                    "image/svg+xml": string;
                    "image/vnd.dxf": string;
                };
            };
            /** @description The requested range */
            206: {
                headers: {
                    /** @description Hash of these bytes. */
                    ETag?: string;
                    /** @description Accept */
                    Vary?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": string;
                    "image/svg+xml": string;
                    "image/vnd.dxf": string;
                };
            };
            /** @description `If-None-Match` names the current entity tag */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            404: components["responses"]["NotFound"];
            406: components["responses"]["NotAcceptable"];
            409: components["responses"]["NoMesh"];
            410: components["responses"]["Gone"];
            /** @description The range lies outside the file */
            416: {
                headers: {
                    "X-Request-Id": components["headers"]["RequestId"];
                    [name: string]: unknown;
                };
                content: {
                    "application/problem+json": components["schemas"]["Problem"];
                };
            };
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    postTicket: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @description Identifier of the job. */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The address */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EventTicket"];
                };
            };
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            404: components["responses"]["NotFound"];
            410: components["responses"]["Gone"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    getLimits: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Limits of this server for one request */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Limits"];
                };
            };
            401: components["responses"]["Unauthorized"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
        };
    };
    postMinimalSurface: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
                /** @description Printable ASCII text. The same key with the same body returns the same job; with another body the answer is 422. */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["MinimalSurfaceRequest"];
            };
        };
        responses: {
            /** @description The job ended within the time of `Prefer: wait` (read its `status`), or this idempotency key was used before with this body. */
            200: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MinimalSurfaceJob"];
                };
            };
            /** @description The job is stored on disk and will be solved. */
            202: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    "Retry-After": components["headers"]["RetryAfter"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MinimalSurfaceJob"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            408: components["responses"]["RequestTimeout"];
            409: components["responses"]["NoMesh"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["QueueFull"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    listObjectives: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Objectives that a request can choose */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ObjectiveList"];
                };
            };
            401: components["responses"]["Unauthorized"];
            421: components["responses"]["Misdirected"];
            429: components["responses"]["RateLimited"];
            500: components["responses"]["Failed"];
        };
    };
    postRuledSurface: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
                /** @description Printable ASCII text. The same key with the same body returns the same job; with another body the answer is 422. */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["RuledSurfaceRequest"];
            };
        };
        responses: {
            /** @description The job ended within the time of `Prefer: wait` (read its `status`), or this idempotency key was used before with this body. */
            200: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RuledSurfaceJob"];
                };
            };
            /** @description The job is stored on disk and will be solved. */
            202: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    "Retry-After": components["headers"]["RetryAfter"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["RuledSurfaceJob"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            408: components["responses"]["RequestTimeout"];
            409: components["responses"]["NoMesh"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["QueueFull"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    postTensileStructure: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
                /** @description Printable ASCII text. The same key with the same body returns the same job; with another body the answer is 422. */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TensileStructureRequest"];
            };
        };
        responses: {
            /** @description The job ended within the time of `Prefer: wait` (read its `status`), or this idempotency key was used before with this body. */
            200: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TensileStructureJob"];
                };
            };
            /** @description The job is stored on disk and will be solved. */
            202: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    "Retry-After": components["headers"]["RetryAfter"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TensileStructureJob"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            408: components["responses"]["RequestTimeout"];
            409: components["responses"]["NoMesh"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["QueueFull"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
    postUniformMesh: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description `wait=N` waits up to N seconds for the end (RFC 7240). An invalid preference is ignored.
                 * @example wait=10
                 */
                Prefer?: string;
                /** @description Printable ASCII text. The same key with the same body returns the same job; with another body the answer is 422. */
                "Idempotency-Key"?: string;
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["UniformMeshRequest"];
            };
        };
        responses: {
            /** @description The job ended within the time of `Prefer: wait` (read its `status`), or this idempotency key was used before with this body. */
            200: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["UniformMeshJob"];
                };
            };
            /** @description The job is stored on disk and will be solved. */
            202: {
                headers: {
                    /** @description Address of the job. */
                    Location?: string;
                    /** @description The wait that was granted. */
                    "Preference-Applied"?: string;
                    "Retry-After": components["headers"]["RetryAfter"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["UniformMeshJob"];
                };
            };
            400: components["responses"]["BadRequest"];
            401: components["responses"]["Unauthorized"];
            403: components["responses"]["ForeignPage"];
            408: components["responses"]["RequestTimeout"];
            409: components["responses"]["NoMesh"];
            413: components["responses"]["TooLarge"];
            415: components["responses"]["UnsupportedMediaType"];
            421: components["responses"]["Misdirected"];
            422: components["responses"]["Invalid"];
            429: components["responses"]["QueueFull"];
            500: components["responses"]["Failed"];
            503: components["responses"]["Unavailable"];
        };
    };
}
